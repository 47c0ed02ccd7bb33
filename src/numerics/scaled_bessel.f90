! SPDX-License-Identifier: GPL-3.0-or-later
!> Modified Bessel functions without their exponentials. GSL ends the process for an argument that is not above 0, which none is here.
module adfric_numerics_scaled_bessel
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_numerics_gsl_bindings, only: gsl_sf_bessel_i0_scaled, gsl_sf_bessel_k0_scaled, gsl_sf_bessel_k1_scaled
   implicit none (type, external)
   private
   public :: scaled_i0, scaled_k0, scaled_k1

contains

   !> e^(-x) I_0(x).
   pure real(dp) function scaled_i0(x)
      !> Argument, >= 0.
      real(dp), intent(in) :: x

      if (has_asserts) call assert(x >= 0, 'scaled_i0: x >= 0')
      scaled_i0 = 1
      if (x > 0) scaled_i0 = gsl_sf_bessel_i0_scaled(x)
   end function scaled_i0

   !> e^x K_0(x).
   pure real(dp) function scaled_k0(x)
      !> Argument, > 0; 0 is a product that was too small for a number, and counts as the least one.
      real(dp), intent(in) :: x

      if (has_asserts) call assert(x >= 0, 'scaled_k0: x >= 0')
      scaled_k0 = gsl_sf_bessel_k0_scaled(max(x, tiny(x)))
   end function scaled_k0

   !> e^x K_1(x).
   pure real(dp) function scaled_k1(x)
      !> Argument, > 0.
      real(dp), intent(in) :: x

      if (has_asserts) call assert(x > 0, 'scaled_k1: x > 0')
      scaled_k1 = gsl_sf_bessel_k1_scaled(x)
   end function scaled_k1

end module adfric_numerics_scaled_bessel
