! SPDX-License-Identifier: GPL-3.0-or-later
!> Equations with known roots.
module trial_equations
   use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
   use adfric_base_kinds, only: dp
   use adfric_numerics_scalar_root, only: equation_t
   implicit none (type, external)
   private
   public :: trial_equation_t, cubic, steep, flat, straight, wrong_slope, no_number

   !> x^3 - 2; atan(1e4 (x - 0.3)); (x - 0.5)^5; root - x; x^3 - 2 with the slope of its opposite; and NaN.
   integer, parameter :: cubic = 1, steep = 2, flat = 3, straight = 4, wrong_slope = 5, no_number = 6

   !> One of them.
   type, extends(equation_t) :: trial_equation_t
      integer :: kind = cubic
      !> Of the straight one alone.
      real(dp) :: root = 0.25_dp
   contains
      procedure :: evaluate
   end type trial_equation_t

contains

   pure subroutine evaluate(self, x, value, slope)
      class(trial_equation_t), intent(in) :: self
      real(dp), intent(in) :: x
      real(dp), intent(out) :: value
      real(dp), intent(out) :: slope
      real(dp), parameter :: steepness = 1.0e4_dp

      select case (self%kind)
      case (cubic, wrong_slope)
         value = x**3 - 2
         slope = merge(3, -3, self%kind == cubic)*x**2
      case (steep)
         value = atan(steepness*(x - 0.3_dp))
         slope = steepness/(1 + (steepness*(x - 0.3_dp))**2)
      case (flat)
         value = (x - 0.5_dp)**5
         slope = 5*(x - 0.5_dp)**4
      case (no_number)
         value = ieee_value(x, ieee_quiet_nan)
         slope = 1
      case default
         value = self%root - x
         slope = -1
      end select
   end subroutine evaluate

end module trial_equations
