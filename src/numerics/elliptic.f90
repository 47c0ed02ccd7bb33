!> Elliptic integrals in Carlson's symmetric form: sums of them have terms of one sign where differences of
!> Legendre's E and F lose digits.
module adfric_numerics_elliptic
   use adfric_base_kinds, only: dp
   use adfric_numerics_gsl_bindings, only: gsl_sf_ellint_rf, gsl_sf_ellint_rd, gsl_prec_double
   implicit none (type, external)
   private
   public :: carlson_f, carlson_d

contains

   !> R_F = (1/2) int_0^inf dt/sqrt((t + x)(t + y)(t + z)), x, y, z >= 0, at most one of them 0.
   elemental real(dp) function carlson_f(x, y, z)
      !> Arguments of the integral, >= 0, at most one of them 0.
      real(dp), intent(in) :: x, y, z

      carlson_f = gsl_sf_ellint_rf(x, y, z, gsl_prec_double)
   end function carlson_f

   !> R_D = (3/2) int_0^inf dt/(sqrt((t + x)(t + y)) (t + z)^(3/2)), x, y >= 0, at most one of them 0, z > 0.
   elemental real(dp) function carlson_d(x, y, z)
      !> Arguments of the integral, >= 0, at most one of them 0.
      real(dp), intent(in) :: x, y
      !> Third argument of the integral, > 0.
      real(dp), intent(in) :: z

      carlson_d = gsl_sf_ellint_rd(x, y, z, gsl_prec_double)
   end function carlson_d

end module adfric_numerics_elliptic
