! SPDX-License-Identifier: GPL-3.0-or-later
!> Distributions of statistics: chi squared, F, Student's t, and the normal one; by the GNU Scientific Library, whose arguments are
!> looked at before.
module adfric_numerics_distributions
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_numerics_gsl_bindings, only: gsl_cdf_chisq_q, gsl_cdf_chisq_pinv, gsl_cdf_fdist_pinv, gsl_cdf_tdist_pinv, &
      & gsl_cdf_ugaussian_q, gsl_cdf_ugaussian_pinv
   implicit none (type, external)
   private
   public :: chi_squared_above, chi_squared_quantile, f_quantile, t_quantile, normal_quantile, normal_outside

contains

   !> Probability that chi squared is larger.
   elemental real(dp) function chi_squared_above(value, freedom) result(probability)
      !> The value, >= 0.
      real(dp), intent(in) :: value
      !> Degrees of freedom, >= 1.
      integer, intent(in) :: freedom

      probability = not_a_number()
      if (value >= 0 .and. value <= huge(value) .and. freedom >= 1) probability = gsl_cdf_chisq_q(value, real(freedom, dp))
   end function chi_squared_above

   !> The value that chi squared does not exceed at a level.
   elemental real(dp) function chi_squared_quantile(level, freedom) result(value)
      !> The level, between 0 and 1.
      real(dp), intent(in) :: level
      !> Degrees of freedom, >= 1.
      integer, intent(in) :: freedom

      value = not_a_number()
      if (level > 0 .and. level < 1 .and. freedom >= 1) value = gsl_cdf_chisq_pinv(level, real(freedom, dp))
   end function chi_squared_quantile

   !> The value that F does not exceed at a level.
   elemental real(dp) function f_quantile(level, freedom, other_freedom) result(value)
      !> The level, between 0 and 1.
      real(dp), intent(in) :: level
      !> Degrees of freedom of the numerator, >= 1.
      integer, intent(in) :: freedom
      !> Degrees of freedom of the denominator, >= 1.
      integer, intent(in) :: other_freedom

      value = not_a_number()
      if (level > 0 .and. level < 1 .and. min(freedom, other_freedom) >= 1) value = &
         & gsl_cdf_fdist_pinv(level, real(freedom, dp), real(other_freedom, dp))
   end function f_quantile

   !> The value that the size of Student's t does not exceed at a level.
   elemental real(dp) function t_quantile(level, freedom) result(value)
      !> The level, between 0 and 1.
      real(dp), intent(in) :: level
      !> Degrees of freedom, >= 1.
      integer, intent(in) :: freedom

      value = not_a_number()
      if (level > 0 .and. level < 1 .and. freedom >= 1) value = gsl_cdf_tdist_pinv((1 + level)/2, real(freedom, dp))
   end function t_quantile

   !> The value that the size of a normal number does not exceed at a level.
   elemental real(dp) function normal_quantile(level) result(value)
      !> The level, between 0 and 1.
      real(dp), intent(in) :: level

      value = not_a_number()
      if (level > 0 .and. level < 1) value = gsl_cdf_ugaussian_pinv((1 + level)/2)
   end function normal_quantile

   !> Probability that the size of a normal number is larger.
   elemental real(dp) function normal_outside(value) result(probability)
      !> The value.
      real(dp), intent(in) :: value

      probability = 2*gsl_cdf_ugaussian_q(abs(value))
   end function normal_outside

end module adfric_numerics_distributions
