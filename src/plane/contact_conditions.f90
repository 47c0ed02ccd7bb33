! SPDX-License-Identifier: GPL-3.0-or-later
!> The conditions of contact (Hertz, Signorini, Moreau): gap g >= 0, pressure p >= 0, g p = 0.
module adfric_plane_contact_conditions
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: largest_violation

contains

   !> Largest violation at positions with a pressure and a gap, 0 if there is none [-].
   pure real(dp) function largest_violation(pressure, gap, pressure_unit, gap_unit) result(violation)
      !> Pressure at each position, in any unit; shape `(n_positions)`.
      real(dp), intent(in) :: pressure(:)
      !> Gap at each position, in any unit; shape `(n_positions)`.
      real(dp), intent(in) :: gap(:)
      !> Unit of pressure in which violations are measured, > 0.
      real(dp), intent(in) :: pressure_unit
      !> Unit of gap in which violations are measured, > 0.
      real(dp), intent(in) :: gap_unit
      real(dp) :: p, g
      integer :: i

      violation = 0
      do i = 1, size(pressure)
         p = pressure(i)/pressure_unit
         g = gap(i)/gap_unit
         violation = max(violation, -p, -g, abs(p)*abs(g))
      end do
   end function largest_violation

end module adfric_plane_contact_conditions
