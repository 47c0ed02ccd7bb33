! SPDX-License-Identifier: GPL-3.0-or-later
!> Periodic surfaces to press against a half-space, in units of the period: gaps at first touch.
module trial_surfaces
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: line_wave, wave, rough_surface, noise_surface, punch_surface

   real(dp), parameter :: two_pi = 6.283185307179586476925286766559_dp

contains

   !> (1 - cos 2 pi x)/pi, full contact at p* = E*; of n cells a period the first `n_given`.
   pure function line_wave(n, n_given) result(shape)
      integer, intent(in) :: n, n_given
      real(dp) :: shape(n_given, 1)
      integer :: i

      shape(:, 1) = [((1 - cos(two_pi*(i - 0.5_dp)/n))*2/two_pi, i=1, n_given)]
   end function line_wave

   !> (2 - cos 2 pi x - cos 2 pi y)/2 pi, full contact at p* = E*.
   pure function wave(n, n_given) result(shape)
      integer, intent(in) :: n, n_given
      real(dp) :: shape(n_given, n_given)
      integer :: i, j

      do j = 1, n_given
         do i = 1, n_given
            shape(i, j) = (2 - cos(two_pi*(i - 0.5_dp)/n) - cos(two_pi*(j - 0.5_dp)/n))/two_pi
         end do
      end do
   end function wave

   !> Waves of random phase and of amplitude |k|^-1.8 along each direction, from one per period to n/4; root of the mean square
   !> slope about 1.
   function rough_surface(nx, ny, seed) result(shape)
      integer, intent(in) :: nx, ny, seed
      real(dp) :: shape(nx, ny)
      complex(dp) :: along_x(nx), along_y(ny)
      real(dp) :: phase(2)
      integer :: k, l, i

      call start_random(seed)
      shape = 0
      do l = -ny/4, ny/4
         along_y = [(exp(cmplx(0, two_pi*l*i/ny, dp)), i=1, ny)]
         do k = 0, nx/4
            if (k == 0 .and. l == 0) cycle
            call random_number(phase)
            along_x = [(exp(cmplx(0, two_pi*(real(k, dp)*i/nx + phase(1)), dp)), i=1, nx)]
            shape = shape + 0.05_dp*real(hypot(real(k, dp), real(l, dp)), dp)**(-1.8_dp)* &
               real(spread(along_x, 2, ny)*spread(along_y, 1, nx))
         end do
      end do
      shape = shape - minval(shape)
   end function rough_surface

   !> Every cell at a random height: no coarse grid knows anything of it.
   function noise_surface(n, seed) result(shape)
      integer, intent(in) :: n, seed
      real(dp) :: shape(n, n)

      call start_random(seed)
      call random_number(shape)
      shape = 0.01_dp*(shape - minval(shape))
   end function noise_surface

   !> A flat square punch in the middle; edges are sharp and cells within touch together.
   pure function punch_surface(n) result(shape)
      integer, intent(in) :: n
      real(dp) :: shape(n, n)

      shape = 0.1_dp
      shape(n/4 + 1:3*n/4, n/4 + 1:3*n/4) = 0
   end function punch_surface

   subroutine start_random(seed)
      integer, intent(in) :: seed
      integer :: n

      call random_seed(size=n)
      call random_seed(put=spread(seed, 1, n))
   end subroutine start_random

end module trial_surfaces
