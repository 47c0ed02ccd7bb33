! SPDX-License-Identifier: GPL-3.0-or-later
!> Random self-affine surfaces: white noise whose waves are weighed.
module rough_shapes
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_numerics_spectral_filter, only: spectral_filter_t, new_spectral_filter
   use random_dice, only: dice_t
   implicit none (type, external)
   private
   public :: make_surface

contains

   !> Gaps of a surface above its highest cell, from 0 to 1. The power of its waves is |k|^(-2 - 2 H) from a quarter of the period on.
   subroutine make_surface(n, hurst, most_waves, shape, dice)
      !> Number of cells along x and y.
      integer, intent(in) :: n
      !> The exponent H.
      real(dp), intent(in) :: hurst
      !> Largest number of waves in a period.
      integer, intent(in) :: most_waves
      !> Receives the gaps; shape `(n, n)`.
      real(dp), allocatable, intent(out) :: shape(:, :)
      !> Where the noise comes from; absent: the same noise each time.
      type(dice_t), intent(inout), optional :: dice
      integer, parameter :: fewest_waves = 4
      type(spectral_filter_t) :: filter
      type(error_t), allocatable :: error
      real(dp), allocatable :: noise(:, :), symbol(:, :)
      real(dp) :: waves
      integer :: i, j

      call new_spectral_filter(filter, n, n, .false., .false., error)
      if (allocated(error)) error stop 'no transform'
      allocate (noise(n, n), shape(n, n), symbol(filter%n_modes(2), filter%n_modes(1)))
      if (present(dice)) then
         do j = 1, n
            do i = 1, n
               call dice%between(0.0_dp, 1.0_dp, noise(i, j))
            end do
         end do
      else
         call random_init(.true., .true.)
         call random_number(noise)
      end if
      do i = 1, size(symbol, 2)
         do j = 1, size(symbol, 1)
            waves = hypot(real(i - 1, dp), real(min(j - 1, n - j + 1), dp))
            symbol(j, i) = 0
            if (waves >= fewest_waves .and. waves <= most_waves) symbol(j, i) = waves**(-1 - hurst)
         end do
      end do
      call filter%apply(symbol, noise, shape)
      shape = shape - minval(shape)
      shape = shape/maxval(shape)
   end subroutine make_surface

end module rough_shapes
