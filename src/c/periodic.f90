! SPDX-License-Identifier: GPL-3.0-or-later
!> The functions of adfric.h for one periodic rough surface.
module adfric_c_periodic
   use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int32_t, c_int64_t
   use adfric_base_error, only: error_t
   use adfric_c_batches, only: check_batch, check_cells
   use adfric_c_texts, only: status_of
   use adfric_contact_periodic, only: solve_periodic_penetration, solve_periodic_pressure
   implicit none (type, external)
   private

contains

   !> See adfric.h.
   integer(c_int) function periodic_pressure(ny, nx, heights, period_y, period_x, mean_pressure, tolerance, pressure, gap, &
      & penetration, contact_fraction, status) bind(c, name='adfric_periodic_pressure') result(outcome)
      integer(c_int64_t), intent(in), value :: ny, nx
      real(c_double), intent(in), optional :: heights(nx, ny)
      real(c_double), intent(in), value :: period_y, period_x, mean_pressure, tolerance
      real(c_double), intent(inout), optional :: pressure(nx, ny), gap(nx, ny), penetration, contact_fraction
      integer(c_int32_t), intent(inout), optional :: status
      type(error_t), allocatable :: error

      call check_cells('ny', ny, error)
      if (.not. allocated(error)) call check_cells('nx', nx, error)
      if (.not. allocated(error)) call check_batch(nx, [present(heights), present(pressure), present(gap), present(penetration), &
         & present(contact_fraction), present(status)], 'heights pressure gap penetration contact_fraction status', error)
      outcome = status_of(error)
      if (allocated(error)) return
      call solve_periodic_pressure(heights, [period_x, period_y], mean_pressure, pressure, gap, penetration, contact_fraction, &
         & status, tolerance)
   end function periodic_pressure

   !> See adfric.h.
   integer(c_int) function periodic_penetration(ny, nx, heights, period_y, period_x, penetration, tolerance, pressure, gap, &
      & mean_pressure, contact_fraction, status) bind(c, name='adfric_periodic_penetration') result(outcome)
      integer(c_int64_t), intent(in), value :: ny, nx
      real(c_double), intent(in), optional :: heights(nx, ny)
      real(c_double), intent(in), value :: period_y, period_x, penetration, tolerance
      real(c_double), intent(inout), optional :: pressure(nx, ny), gap(nx, ny), mean_pressure, contact_fraction
      integer(c_int32_t), intent(inout), optional :: status
      type(error_t), allocatable :: error

      call check_cells('ny', ny, error)
      if (.not. allocated(error)) call check_cells('nx', nx, error)
      if (.not. allocated(error)) call check_batch(nx, [present(heights), present(pressure), present(gap), &
         & present(mean_pressure), present(contact_fraction), present(status)], &
         & 'heights pressure gap mean_pressure contact_fraction status', error)
      outcome = status_of(error)
      if (allocated(error)) return
      call solve_periodic_penetration(heights, [period_x, period_y], penetration, pressure, gap, mean_pressure, &
         & contact_fraction, status, tolerance)
   end function periodic_penetration

end module adfric_c_periodic
