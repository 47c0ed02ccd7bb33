! SPDX-License-Identifier: GPL-3.0-or-later
!> Bindings of the GNU Scientific Library. Its functions end the process where an argument is outside of their domain: only
!> `adfric_numerics_elliptic` and `adfric_numerics_bessel_ratios` call them, which look at the arguments before.
module adfric_numerics_gsl_bindings
   use, intrinsic :: iso_c_binding, only: c_double, c_int
   implicit none (type, external)
   private
   public :: gsl_sf_ellint_rf, gsl_sf_ellint_rd, gsl_prec_double
   public :: gsl_sf_bessel_i0_scaled, gsl_sf_bessel_i1_scaled, gsl_sf_bessel_k0_scaled, gsl_sf_bessel_k1_scaled

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

      !> The modified Bessel function e^(-|x|) I_0(x).
      pure real(c_double) function gsl_sf_bessel_i0_scaled(x) bind(c, name='gsl_sf_bessel_I0_scaled')
         import :: c_double
         implicit none (type, external)
         !> Argument of the function, > 0.
         real(c_double), intent(in), value :: x
      end function gsl_sf_bessel_i0_scaled

      !> The modified Bessel function e^(-|x|) I_1(x).
      pure real(c_double) function gsl_sf_bessel_i1_scaled(x) bind(c, name='gsl_sf_bessel_I1_scaled')
         import :: c_double
         implicit none (type, external)
         !> Argument of the function, > 0.
         real(c_double), intent(in), value :: x
      end function gsl_sf_bessel_i1_scaled

      !> The modified Bessel function e^x K_0(x).
      pure real(c_double) function gsl_sf_bessel_k0_scaled(x) bind(c, name='gsl_sf_bessel_K0_scaled')
         import :: c_double
         implicit none (type, external)
         !> Argument of the function, > 0.
         real(c_double), intent(in), value :: x
      end function gsl_sf_bessel_k0_scaled

      !> The modified Bessel function e^x K_1(x).
      pure real(c_double) function gsl_sf_bessel_k1_scaled(x) bind(c, name='gsl_sf_bessel_K1_scaled')
         import :: c_double
         implicit none (type, external)
         !> Argument of the function, > 0.
         real(c_double), intent(in), value :: x
      end function gsl_sf_bessel_k1_scaled
   end interface

end module adfric_numerics_gsl_bindings
