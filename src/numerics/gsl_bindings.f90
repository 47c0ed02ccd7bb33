!> Bindings of the GNU Scientific Library. Its functions end the process where an argument is outside of their domain: only
!> `adfric_numerics_elliptic` calls them, which looks at the arguments before.
module adfric_numerics_gsl_bindings
   use, intrinsic :: iso_c_binding, only: c_double, c_int
   implicit none (type, external)
   private
   public :: gsl_sf_ellint_rf, gsl_sf_ellint_rd, gsl_prec_double

   !> Mode of a special function: all digits of double precision.
   integer(c_int), parameter :: gsl_prec_double = 0

   interface
      !> Carlson's elliptic integral R_F(x, y, z).
      pure real(c_double) function gsl_sf_ellint_rf(x, y, z, mode) bind(c, name='gsl_sf_ellint_RF')
         import :: c_double, c_int
         implicit none (type, external)
         !> Arguments of the integral, >= 0, at most one of them 0.
         real(c_double), intent(in), value :: x, y, z
         !> Precision, `gsl_prec_double`.
         integer(c_int), intent(in), value :: mode
      end function gsl_sf_ellint_rf

      !> Carlson's elliptic integral R_D(x, y, z).
      pure real(c_double) function gsl_sf_ellint_rd(x, y, z, mode) bind(c, name='gsl_sf_ellint_RD')
         import :: c_double, c_int
         implicit none (type, external)
         !> Arguments of the integral, >= 0, at most one of them 0.
         real(c_double), intent(in), value :: x, y
         !> Third argument of the integral, > 0.
         real(c_double), intent(in), value :: z
         !> Precision, `gsl_prec_double`.
         integer(c_int), intent(in), value :: mode
      end function gsl_sf_ellint_rd
   end interface

end module adfric_numerics_gsl_bindings
