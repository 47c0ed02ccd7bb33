! SPDX-License-Identifier: GPL-3.0-or-later
! Equations and functions for the tests of roots and integrals.
module rising_equations
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_numerics_secant_root, only: rising_equation_t
   use adfric_numerics_double_exponential, only: integrand_t
   implicit none (type, external)
   private
   public :: power_equation_t, end_power_t

   !> x^n - c; without value for n < 0.
   type, extends(rising_equation_t) :: power_equation_t
      integer :: n = 1
      real(dp) :: c = 1
   contains
      procedure :: evaluate => evaluate_power
   end type power_equation_t

   !> l^a r^b exp(-d l) for the distances l and r from the ends.
   type, extends(integrand_t) :: end_power_t
      real(dp) :: a = 0, b = 0, decay = 0
   contains
      procedure :: evaluate => evaluate_end_power
   end type end_power_t

contains

   pure subroutine evaluate_power(self, x, value)
      class(power_equation_t), intent(in) :: self
      real(dp), intent(in) :: x
      real(dp), intent(out) :: value

      value = not_a_number()
      if (self%n > 0) value = x**self%n - self%c
   end subroutine evaluate_power

   pure real(dp) function evaluate_end_power(self, from_left, from_right)
      class(end_power_t), intent(in) :: self
      real(dp), intent(in) :: from_left, from_right

      evaluate_end_power = exp(-self%decay*from_left)*from_left**self%a*from_right**self%b
   end function evaluate_end_power

end module rising_equations
