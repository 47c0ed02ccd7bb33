! SPDX-License-Identifier: GPL-3.0-or-later
!> Functions of the contact zone that keep their digits for narrow contacts and for slow and fast sliding.
module adfric_foundation_contact_zone
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_numerics_libm, only: expm1
   use adfric_numerics_trigonometry, only: sinc_minus_cos
   implicit none (type, external)
   private
   public :: coth_and_slope, get_lag, decay, longest_decay

   !> exp(-x) of more than this is nothing for every purpose here, and exp(x) does not overflow.
   real(dp), parameter :: longest_decay = 700.0_dp

contains

   !> coth x and coth^2 x - 1 for x > 0.
   elemental subroutine coth_and_slope(x, coth, excess)
      !> Argument, > 0.
      real(dp), intent(in) :: x
      !> The value coth x.
      real(dp), intent(out) :: coth
      !> The difference coth^2 x - 1, which is minus the slope of coth.
      real(dp), intent(out) :: excess
      real(dp) :: q

      if (has_asserts) call assert(x > 0, 'coth_and_slope: x > 0')
      q = 1/expm1(min(2*x, longest_decay))
      coth = 1 + 2*q
      excess = 4*q*(1 + q)
   end subroutine coth_and_slope

   !> 1 - exp(-x) without loss of digits: what a decay over x takes away.
   elemental real(dp) function decay(x)
      !> Distance over the length of the decay [-]; back, where it is negative.
      real(dp), intent(in) :: x

      decay = -expm1(-x)
   end function decay

   !> Langevin's function coth x - 1/x for x >= 0.
   elemental real(dp) function langevin(x)
      !> Argument, >= 0.
      real(dp), intent(in) :: x
      real(dp) :: y

      if (has_asserts) call assert(x >= 0, 'langevin: x >= 0')
      if (x < 1) then
         y = x*x
         langevin = x/(3 + y/(5 + y/(7 + y/(9 + y/(11 + y/(13 + y/(15 + y/17)))))))
      else
         langevin = 1 + 2/expm1(min(2*x, longest_decay)) - 1/x
      end if
   end function langevin

   !> \( \sin\lambda\coth(\lambda/u) - u\cos\lambda \), without loss of digits in narrow contacts.
   elemental real(dp) function get_lag(half_width, u, coth_u)
      !> Half width of the contact [rad], in (0, pi).
      real(dp), intent(in) :: half_width
      !> Relaxation phase of the foundation [-], > 0.
      real(dp), intent(in) :: u
      !> Value of coth(half_width/u).
      real(dp), intent(in) :: coth_u

      if (has_asserts) call assert(half_width > 0 .and. u > 0, 'get_lag: half width and relaxation phase are positive')
      if (half_width >= 1) then
         get_lag = sin(half_width)*coth_u - u*cos(half_width)
      else
         get_lag = u*sinc_minus_cos(half_width) + sin(half_width)*langevin(half_width/u)
      end if
   end function get_lag

end module adfric_foundation_contact_zone
