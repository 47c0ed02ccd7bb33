! SPDX-License-Identifier: GPL-3.0-or-later
!> Ratios of modified Bessel functions.
!>
!> GSL calls the error handler of the process, which ends it, where a function or a part of it would underflow or overflow. That
!> does not happen between the bounds of the argument, so no handler is called.
module adfric_numerics_bessel_ratios
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_numerics_gsl_bindings, only: gsl_sf_bessel_i0_scaled, gsl_sf_bessel_i1_scaled, gsl_sf_bessel_k0_scaled, &
      & gsl_sf_bessel_k1_scaled
   implicit none (type, external)
   private
   public :: bessel_i1_i0, bessel_i1_deficit, bessel_i2_i0, bessel_k1_k0

   !> Bounds of the argument.
   real(dp), parameter :: least_argument = 1.0e-150_dp, largest_argument = 1.0e150_dp
   !> Order from which the continued fraction is taken, for arguments up to 4.
   integer, parameter :: last_order = 30
   !> Argument from which the deficit is taken from its asymptotic series, and terms of the series: those left out are round-off.
   real(dp), parameter :: large_argument = 50
   integer, parameter :: n_terms = 12

contains

   !> I_1(x)/I_0(x).
   elemental real(dp) function bessel_i1_i0(x)
      !> Argument, 1e-150 to 1e150; the ratio of any other is NaN.
      real(dp), intent(in) :: x

      bessel_i1_i0 = not_a_number()
      if (.not. lies_within(x)) return
      if (x > 4) then
         bessel_i1_i0 = gsl_sf_bessel_i1_scaled(x)/gsl_sf_bessel_i0_scaled(x)
      else
         bessel_i1_i0 = neighbour_ratio(0, x)
      end if
   end function bessel_i1_i0

   !> 1 - I_1(x)/I_0(x), with its digits where it is small.
   !>
   !> With a = 1/x, 2 d = a - a d + d^2 + a^2 d'(a) gives the terms of d = a/2 + a^2/8 + ... one after the other.
   elemental real(dp) function bessel_i1_deficit(x) result(deficit)
      !> Argument, 1e-150 to 1e150; the deficit of any other is NaN.
      real(dp), intent(in) :: x
      real(dp) :: terms(n_terms)
      integer :: n

      deficit = 1 - bessel_i1_i0(x)
      if (.not. (x > large_argument .and. lies_within(x))) return
      terms(1) = 1/x/2
      do n = 2, n_terms
         terms(n) = ((n - 2)*terms(n - 1)/x + dot_product(terms(:n - 1), terms(n - 1:1:-1)))/2
      end do
      deficit = sum(terms(n_terms:1:-1))
   end function bessel_i1_deficit

   !> I_2(x)/I_0(x).
   elemental real(dp) function bessel_i2_i0(x)
      !> Argument, 1e-150 to 1e150; the ratio of any other is NaN.
      real(dp), intent(in) :: x

      bessel_i2_i0 = not_a_number()
      if (.not. lies_within(x)) return
      if (x > 4) then
         bessel_i2_i0 = 1 - 2*bessel_i1_i0(x)/x
      else
         bessel_i2_i0 = neighbour_ratio(1, x)*bessel_i1_i0(x)
      end if
   end function bessel_i2_i0

   !> I_(n+1)(x)/I_n(x) = 1/(2 (n + 1)/x + I_(n+2)/I_(n+1)), from a high order downwards. GSL's scaled I_1 leaves its factor out
   !> where x is small.
   elemental real(dp) function neighbour_ratio(order, x)
      !> The order n, 0 or 1.
      integer, intent(in) :: order
      !> Argument, to 4.
      real(dp), intent(in) :: x
      integer :: n

      neighbour_ratio = 0
      do n = last_order, order, -1
         neighbour_ratio = x/(2*(n + 1) + x*neighbour_ratio)
      end do
   end function neighbour_ratio

   !> K_1(x)/K_0(x).
   elemental real(dp) function bessel_k1_k0(x)
      !> Argument, 1e-150 to 1e150; the ratio of any other is NaN.
      real(dp), intent(in) :: x

      bessel_k1_k0 = not_a_number()
      if (lies_within(x)) bessel_k1_k0 = gsl_sf_bessel_k1_scaled(x)/gsl_sf_bessel_k0_scaled(x)
   end function bessel_k1_k0

   !> Is an argument between the bounds? NaN is not.
   elemental logical function lies_within(x)
      !> Argument of a ratio.
      real(dp), intent(in) :: x

      lies_within = x >= least_argument .and. x <= largest_argument
   end function lies_within

end module adfric_numerics_bessel_ratios
