! SPDX-License-Identifier: GPL-3.0-or-later
!> Nodes for integrals whose integrand changes fast at known points: Gauss's rule on panels that halve towards both ends of each segment.
module adfric_interface_graded_nodes
   use adfric_base_kinds, only: dp
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   implicit none (type, external)
   private
   public :: get_graded_nodes

contains

   !> Nodes and weights.
   pure subroutine get_graded_nodes(ends, n_levels, nodes, weights)
      !> Ends of the segments, rising; shape `(n_segments + 1)`.
      real(dp), intent(in) :: ends(:)
      !> Panels from the middle of a segment to each of its ends.
      integer, intent(in) :: n_levels
      !> Receives nodes and weights; shape `(2 n_levels n_segments n)`.
      real(dp), allocatable, intent(out) :: nodes(:), weights(:)
      real(dp) :: inner, outer, half
      integer :: segment, level, side, at
      integer, parameter :: n = size(gauss_nodes)

      allocate (nodes(2*n_levels*(size(ends) - 1)*n), weights(2*n_levels*(size(ends) - 1)*n))
      at = 0
      do segment = 1, size(ends) - 1
         half = (ends(segment + 1) - ends(segment))/2
         do level = 1, n_levels
            ! distances from an end, over half of the segment
            outer = 0.5_dp**(level - 1)
            inner = merge(0.0_dp, outer/2, level == n_levels)
            do side = 1, 2
               associate (distances => half*(inner + (outer - inner)*(1 + gauss_nodes)/2))
                  if (side == 1) nodes(at + 1:at + n) = ends(segment) + distances
                  if (side == 2) nodes(at + 1:at + n) = ends(segment + 1) - distances
               end associate
               weights(at + 1:at + n) = half*(outer - inner)/2*gauss_weights
               at = at + n
            end do
         end do
      end do
   end subroutine get_graded_nodes

end module adfric_interface_graded_nodes
