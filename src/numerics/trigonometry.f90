! SPDX-License-Identifier: GPL-3.0-or-later
!> Differences of angles, sines and cosines that keep their digits where the angle is small.
module adfric_numerics_trigonometry
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   implicit none (type, external)
   private
   public :: sinc_minus_cos, angle_minus_sine

   !> Coefficients of x^(2k) in sin(x)/x - cos x, and of x^(2k + 1) in x - sin x, as far as digits go for x < 1.
   real(dp), parameter :: k(9) = [1, 2, 3, 4, 5, 6, 7, 8, 9], signs(9) = [1, -1, 1, -1, 1, -1, 1, -1, 1]
   real(dp), parameter :: of_sinc(9) = signs*2*k/gamma(2*k + 2), of_sine(9) = signs/gamma(2*k + 2)

contains

   !> sin(x)/x - cos x for 0 <= x <= pi.
   elemental real(dp) function sinc_minus_cos(x)
      !> Angle [rad], 0 to pi.
      real(dp), intent(in) :: x

      if (has_asserts) call assert(x >= 0, 'sinc_minus_cos: x >= 0')
      if (x >= 1) then
         sinc_minus_cos = sin(x)/x - cos(x)
      else
         sinc_minus_cos = x*x*series(of_sinc, x*x)
      end if
   end function sinc_minus_cos

   !> x - sin x for x >= 0.
   elemental real(dp) function angle_minus_sine(x)
      !> Angle [rad], >= 0.
      real(dp), intent(in) :: x

      if (has_asserts) call assert(x >= 0, 'angle_minus_sine: x >= 0')
      if (x >= 1) then
         angle_minus_sine = x - sin(x)
      else
         angle_minus_sine = x**3*series(of_sine, x*x)
      end if
   end function angle_minus_sine

   !> A polynomial of nine coefficients.
   pure real(dp) function series(c, y)
      !> Coefficients of y^0 to y^8.
      real(dp), intent(in) :: c(9)
      !> Argument of the polynomial: the square of an angle below 1.
      real(dp), intent(in) :: y
      real(dp) :: z

      ! two chains, which the machine works on at the same time
      z = y*y
      series = (((c(9)*z + c(7))*z + c(5))*z + c(3))*z + c(1) + y*(((c(8)*z + c(6))*z + c(4))*z + c(2))
   end function series

end module adfric_numerics_trigonometry
