! SPDX-License-Identifier: GPL-3.0-or-later
!> A law of the interface that depends on the pressure, over the cells of a contact.
module adfric_periodic_law_of_cells
   use adfric_base_kinds, only: dp
   use adfric_interface_friction_law, only: friction_law_t
   implicit none (type, external)
   private
   public :: get_mean_of_cells

contains

   !> Mean shear stress of the cells in contact, and its change by ln v.
   pure subroutine get_mean_of_cells(law, speed, temperature, pressure, is_contact, mean, mean_slope, is_valid)
      !> The law of the interface.
      type(friction_law_t), intent(in) :: law
      !> Speed [m/s], and temperature of the contact [K].
      real(dp), intent(in) :: speed, temperature
      !> Pressure in the cells [Pa].
      real(dp), intent(in) :: pressure(:, :)
      !> Do the faces touch? Shape of `pressure`.
      logical, intent(in) :: is_contact(:, :)
      !> The mean, and the mean of the changes [Pa].
      real(dp), intent(out) :: mean, mean_slope
      !> Does the law hold there?
      logical, intent(out) :: is_valid
      real(dp) :: stress, slope
      integer :: i, j, n

      mean = 0
      mean_slope = 0
      n = 0
      is_valid = .true.
      do j = 1, size(pressure, 2)
         do i = 1, size(pressure, 1)
            if (.not. is_contact(i, j)) cycle
            call law%get_stress(speed, pressure(i, j), temperature, stress, slope, is_valid)
            if (.not. is_valid) return
            mean = mean + stress
            mean_slope = mean_slope + slope*stress
            n = n + 1
         end do
      end do
      mean = mean/max(n, 1)
      mean_slope = mean_slope/max(n, 1)
   end subroutine get_mean_of_cells

end module adfric_periodic_law_of_cells
