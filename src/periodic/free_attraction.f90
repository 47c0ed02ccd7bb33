! SPDX-License-Identifier: GPL-3.0-or-later
!> Law of attraction of a body that ends: Dugdale's, or another one that falls with the gap.
module adfric_periodic_free_attraction
   use adfric_base_kinds, only: dp
   use adfric_periodic_adhesive_solver, only: periodic_adhesion_t
   use adfric_periodic_attracted_surface, only: periodic_attraction_t
   implicit none (type, external)
   private
   public :: free_law_t

   !> The law of a body: stresses in E*, lengths in the unit of the map, and a load of a turn as `turning_pressure` [E* times the square
   !> of the unit of length].
   type :: free_law_t
      !> Dugdale's law; beside another one that of the same largest tension and work.
      type(periodic_adhesion_t) :: dugdale
      !> The other law.
      type(periodic_attraction_t), allocatable :: attraction
   contains
      procedure :: on_cells
   end type free_law_t

contains

   !> The law on a map with more cells than those of the body, on which alone it acts.
   pure type(free_law_t) function on_cells(self, area, is_body) result(law)
      class(free_law_t), intent(in) :: self
      !> Area of the map, over which a load of a turn is a mean pressure.
      real(dp), intent(in) :: area
      !> Is the cell one of the body?
      logical, intent(in) :: is_body(:, :)

      law%dugdale = self%dugdale
      if (allocated(self%attraction)) then
         law%attraction = self%attraction
         law%attraction%turning_pressure = self%attraction%turning_pressure/area
         law%attraction%part = merge(1.0_dp, 0.0_dp, is_body)
      else
         law%dugdale%turning_pressure = self%dugdale%turning_pressure/area
         law%dugdale%part = merge(1.0_dp, 0.0_dp, is_body)
      end if
   end function on_cells

end module adfric_periodic_free_attraction
