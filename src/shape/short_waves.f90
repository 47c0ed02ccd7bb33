! SPDX-License-Identifier: GPL-3.0-or-later
!> Waves along x that are shorter than a bound, taken out of heights that are periodic along x.
module adfric_shape_short_waves
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_error, only: error_t
   use adfric_numerics_spectral_filter, only: spectral_filter_t, new_spectral_filter
   implicit none (type, external)
   private
   public :: remove_short_waves

contains

   !> Take out every wave exp(2 pi i m x/l) of a row with l/m below a bound; the others keep their amplitudes and phases. The mean
   !> height is no wave, it stays.
   subroutine remove_short_waves(heights, shortest_wavelength, error)
      !> In: heights of equidistant samples of one period, shape `(nx, ny)`; a line is one row. Out: without their short waves.
      real(dp), intent(inout) :: heights(:, :)
      !> The shortest wavelength that stays [periods], > 0. Two samples or less change nothing.
      real(dp), intent(in) :: shortest_wavelength
      type(error_t), allocatable, intent(out) :: error
      type(spectral_filter_t) :: filter
      real(dp), allocatable :: symbol(:, :), row(:, :)
      integer :: nx, j, longest_out

      if (has_asserts) call assert(shortest_wavelength > 0, 'remove_short_waves: a wavelength above 0')
      nx = size(heights, 1)
      longest_out = waves_within(shortest_wavelength, nx/2) + 1
      if (longest_out > nx/2) return
      ! all rows have the same length: one plan
      call new_spectral_filter(filter, nx, 1, .false., .false., error)
      if (allocated(error)) return
      allocate (symbol(1, 0:nx/2), row(nx, 1))
      symbol = 1/filter%gain
      symbol(:, longest_out:) = 0
      do j = 1, size(heights, 2)
         call filter%apply(symbol, heights(:, j:j), row)
         heights(:, j) = row(:, 1)
      end do
   end subroutine remove_short_waves

   !> How many waves of a length fit into the period. A length that is a whole part of the period but for round-off counts as one.
   pure integer function waves_within(wavelength, most) result(n_waves)
      !> Length of a wave [periods], > 0.
      real(dp), intent(in) :: wavelength
      !> The largest number that is told.
      integer, intent(in) :: most
      real(dp), parameter :: round_off = 16*epsilon(1.0_dp)

      n_waves = most
      if (wavelength > 1/(most + 1.0_dp)) n_waves = min(most, floor((1 + round_off)/wavelength))
   end function waves_within

end module adfric_shape_short_waves
