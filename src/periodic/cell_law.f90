! SPDX-License-Identifier: GPL-3.0-or-later
!> What steps in single cells ask of a law of adhesion (`adfric_periodic_adhesive_relaxation`): its largest tension, and how tensions follow a
!> step.
module adfric_periodic_cell_law
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: cell_law_t

   !> A law of adhesion of the cells of a surface.
   type, abstract :: cell_law_t
   contains
      procedure(largest_tension_i), deferred :: largest_tension
      procedure(move_cell_i), deferred :: move_cell
   end type cell_law_t

   abstract interface
      !> The largest tension of the law [E*].
      pure real(dp) function largest_tension_i(self)
         import :: cell_law_t, dp
         implicit none (type, external)
         class(cell_law_t), intent(in) :: self
      end function largest_tension_i

      !> Change the gap of one cell; the tension follows, in all cells that know of it.
      pure subroutine move_cell_i(self, i, j, step, gap, tension)
         import :: cell_law_t, dp
         implicit none (type, external)
         !> The law, which may keep shares of the gap.
         class(cell_law_t), intent(inout) :: self
         !> The cell.
         integer, intent(in) :: i, j
         !> Change of its gap.
         real(dp), intent(in) :: step
         !> In: the gap in all cells. Out: with the change.
         real(dp), intent(inout), contiguous :: gap(:, :)
         !> A field that the change of the tension [E*] is added to; shape of the cells.
         real(dp), intent(inout), contiguous :: tension(:, :)
      end subroutine move_cell_i
   end interface

end module adfric_periodic_cell_law
