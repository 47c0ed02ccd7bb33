! SPDX-License-Identifier: GPL-3.0-or-later
!> The exponential integral of positive numbers.
module adfric_numerics_exponential_integral
   use, intrinsic :: iso_c_binding, only: c_double
   use adfric_base_kinds, only: dp
   use adfric_numerics_gsl_bindings, only: gsl_sf_expint_ei_scaled
   implicit none (type, external)
   private
   public :: scaled_exponential_integral

contains

   !> exp(-x) Ei(x).
   pure real(dp) function scaled_exponential_integral(x) result(value)
      !> Argument, at least the smallest normal number.
      real(dp), intent(in) :: x

      value = real(gsl_sf_expint_ei_scaled(real(x, c_double)), dp)
   end function scaled_exponential_integral

end module adfric_numerics_exponential_integral
