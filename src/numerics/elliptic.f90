! SPDX-License-Identifier: GPL-3.0-or-later
!> Elliptic integrals in Carlson's symmetric form: sums of them have terms of one sign where differences of
!> Legendre's E and F lose digits.
!>
!> Where an argument is NaN or outside of its domain, GSL calls the error handler of the process, which ends it unless somebody has
!> changed that. GSL is never asked there, so no handler is called, and none has to be changed. Within the domain each duplication
!> draws the arguments together, long before GSL stops counting, and no sum overflows.
module adfric_numerics_elliptic
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_numerics_gsl_bindings, only: gsl_sf_ellint_rf, gsl_sf_ellint_rd, gsl_prec_double
   implicit none (type, external)
   private
   public :: carlson_f, carlson_d

   !> Bounds of GSL's domain of R_F, rounded inwards: of the sum of any two arguments from below, of all from above. GSL has
   !> 1.1e-307 and 3.5e307.
   real(dp), parameter :: least_sum_f = 1.2e-307_dp, largest_f = 3.5e307_dp
   !> The same of R_D: of x + y and of z from below, of all from above. GSL has 6.3e-206 and 2.7e202.
   real(dp), parameter :: least_sum_d = 6.4e-206_dp, largest_d = 2.6e202_dp

contains

   !> R_F = (1/2) int_0^inf dt/sqrt((t + x)(t + y)(t + z)), x, y, z >= 0, at most one of them 0. NaN outside of this
   !> domain, or where two arguments add up to less than 1.2e-307 or one is 3.5e307 or more.
   elemental real(dp) function carlson_f(x, y, z)
      !> Arguments of the integral, >= 0, at most one of them 0.
      real(dp), intent(in) :: x, y, z

      carlson_f = not_a_number()
      if (.not. lie_within([x, y, z], largest_f)) return
      if (min(x + y, x + z, y + z) < least_sum_f) return
      carlson_f = gsl_sf_ellint_rf(x, y, z, gsl_prec_double)
   end function carlson_f

   !> R_D = (3/2) int_0^inf dt/(sqrt((t + x)(t + y)) (t + z)^(3/2)), x, y >= 0, at most one of them 0, z > 0. NaN outside
   !> of this domain, or where x + y or z is less than 6.4e-206 or one argument is 2.6e202 or more.
   elemental real(dp) function carlson_d(x, y, z)
      !> Arguments of the integral, >= 0, at most one of them 0.
      real(dp), intent(in) :: x, y
      !> Third argument of the integral, > 0.
      real(dp), intent(in) :: z

      carlson_d = not_a_number()
      if (.not. lie_within([x, y, z], largest_d)) return
      if (min(x + y, z) < least_sum_d) return
      carlson_d = gsl_sf_ellint_rd(x, y, z, gsl_prec_double)
   end function carlson_d

   !> Are all arguments >= 0 and below a bound? NaN is not.
   pure logical function lie_within(arguments, bound)
      !> Arguments of an integral.
      real(dp), intent(in) :: arguments(3)
      !> Bound that the arguments must not reach.
      real(dp), intent(in) :: bound

      lie_within = all(ieee_is_finite(arguments))
      if (lie_within) lie_within = all(arguments >= 0 .and. arguments < bound)
   end function lie_within

end module adfric_numerics_elliptic
