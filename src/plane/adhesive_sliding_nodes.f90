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
      !> Length of the range [any unit], > 0, and the shortest lengths over which the function changes next to the left and to the
      !> right end, > 0.
      real(dp), intent(in) :: length, shortest(2)
      !> How near the positions come to the ends: exp(-depth) of the length.
      real(dp), intent(in) :: depth
      !> 1, or more for smaller steps.
      real(dp), intent(in) :: refinement
      type(nodes_t), intent(out) :: nodes
      real(dp) :: ranges(2), range, middle, amplitude, step, growth, phi, e
      integer :: n(2), i, k

      ranges = min(depth, log(max(length/shortest, 1.0_dp)) + 1)
      range = sum(ranges)/2
      middle = (ranges(2) - ranges(1))/2
      amplitude = max(least_amplitude, range)
      step = 2*pi*used_strip*(pi/2)/sqrt(amplitude**2 + range**2)/(error_logarithm*refinement)
      n = ceiling(asinh((depth + [middle, -middle])/amplitude)/step)
      k = sum(n) + 1
      allocate (nodes%left(k), nodes%right(k), nodes%weights(k))
      do i = -n(1), n(2)
         k = i + n(1) + 1
         growth = exp(i*step)
         phi = middle + amplitude*(growth - 1/growth)/2
         e = exp(-abs(phi))
         nodes%left(k) = merge(length*e, length, phi < 0)/(1 + e)
         nodes%right(k) = merge(length, length*e, phi < 0)/(1 + e)
         nodes%weights(k) = step*amplitude*(growth + 1/growth)/2*length*e/(1 + e)**2
      end do
   end subroutine get_nodes

end module adfric_plane_adhesive_sliding_nodes
