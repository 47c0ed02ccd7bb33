! SPDX-License-Identifier: GPL-3.0-or-later
!> Positions and weights of integrals over a contact and the gap beside it, for functions that change over lengths of all sizes next
!> to both ends: roots and logarithms at the ends, layers exp(-d/a), poles a small distance beyond an end.
!>
!> A position is d = l/(1 + exp(-phi)), phi = A sinh t, with equal steps of t. In ln d a layer is analytic in the strip |Im| < pi/2,
!> a pole beyond the end in |Im| < pi. For a ratio e^L of l and the shortest length the strip in t is (pi/2)/sqrt(A^2 + L^2), and A
!> of the size of L needs the fewest positions.
module adfric_plane_adhesive_sliding_nodes
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   implicit none (type, external)
   private
   public :: nodes_t, get_nodes

   !> The share of the strip that is used, and the logarithm of the error of a sum.
   real(dp), parameter :: used_strip = 0.9_dp, error_logarithm = 34.5_dp
   !> Least A.
   real(dp), parameter :: least_amplitude = 3.0_dp

   !> Positions.
   type :: nodes_t
      !> Distances from both ends, each with all its digits, and weights [unit of length]; shape `(n)`, rising from the left end.
      real(dp), allocatable :: left(:), right(:), weights(:)
   end type nodes_t

contains

   !> Positions for a range.
   pure subroutine get_nodes(length, shortest, depth, refinement, nodes)
      !> Length of the range [any unit], > 0, and the shortest length over which the function changes next to an end, > 0.
      real(dp), intent(in) :: length, shortest
      !> How near the positions come to the ends: exp(-depth) of the length.
      real(dp), intent(in) :: depth
      !> 1, or more for smaller steps.
      real(dp), intent(in) :: refinement
      type(nodes_t), intent(out) :: nodes
      real(dp) :: range, amplitude, step, t, phi, e
      integer :: n, i

      range = min(depth, log(max(length/shortest, 1.0_dp)) + 1)
      amplitude = max(least_amplitude, range)
      step = 2*pi*used_strip*(pi/2)/sqrt(amplitude**2 + range**2)/(error_logarithm*refinement)
      n = ceiling(asinh(depth/amplitude)/step)
      allocate (nodes%left(2*n + 1), nodes%right(2*n + 1), nodes%weights(2*n + 1))
      do i = -n, n
         t = i*step
         phi = amplitude*sinh(t)
         e = exp(-abs(phi))
         nodes%left(i + n + 1) = merge(length*e, length, phi < 0)/(1 + e)
         nodes%right(i + n + 1) = merge(length, length*e, phi < 0)/(1 + e)
         nodes%weights(i + n + 1) = step*amplitude*cosh(t)*length*e/(1 + e)**2
      end do
   end subroutine get_nodes

end module adfric_plane_adhesive_sliding_nodes
