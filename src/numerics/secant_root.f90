! SPDX-License-Identifier: GPL-3.0-or-later
!> A root of one equation whose value rises and whose slope is not known, inside a bracket that is never left.
module adfric_numerics_secant_root
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   implicit none (type, external)
   private
   public :: rising_equation_t, find_rising_root

   !> Steps in which any bracket has become a point.
   integer, parameter :: max_iterations = 200
   !> A secant step of the first size is the last, if the one before was within the second: the next would be of the size of their
   !> product. A secant over a wider range says little about the slope at the root.
   real(dp), parameter :: last_step = 1.0e-10_dp, near_step = 1.0e-5_dp
   !> A bracket of this size has no space for a step.
   real(dp), parameter :: last_digits = 4*epsilon(1.0_dp)
   !> The least step that gives a new slope.
   real(dp), parameter :: probe_step = 1.0e-6_dp

   !> An equation `value(x) = 0` that carries its parameters.
   type, abstract :: rising_equation_t
   contains
      procedure(evaluate_i), deferred :: evaluate
   end type rising_equation_t

   abstract interface
      !> Value at x.
      pure subroutine evaluate_i(self, x, value)
         import :: rising_equation_t, dp
         implicit none (type, external)
         !> The equation with its parameters.
         class(rising_equation_t), intent(in) :: self
         !> The unknown, at a position within the bracket.
         real(dp), intent(in) :: x
         !> Value of the equation, which rises with x; NaN ends the search.
         real(dp), intent(out) :: value
      end subroutine evaluate_i
   end interface

contains

   !> The secant method, with bisection wherever it would leave the bracket or does not at least halve its steps.
   pure subroutine find_rising_root(equation, low, high, slope, round_off, x, is_converged)
      !> The equation, whose value is asked for again and again.
      class(rising_equation_t), intent(in) :: equation
      !> Ends of the bracket, with a negative value at `low` and a positive one at `high`. They are not evaluated.
      real(dp), intent(in) :: low, high
      !> A guess of the slope at the first position, > 0.
      real(dp), intent(in) :: slope
      !> A value of this size is 0.
      real(dp), intent(in) :: round_off
      !> In: a first guess, or anything outside the bracket. Out: the root.
      real(dp), intent(inout) :: x
      !> Was the root found?
      logical, intent(out) :: is_converged
      real(dp) :: left, right, value, old_value, rise, step, old_step
      integer :: iteration
      logical :: is_secant

      if (has_asserts) call assert(low < high, 'find_rising_root: the bracket has a width')
      left = low
      right = high
      if (.not. (x > left .and. x < right)) x = left + (right - left)/2
      rise = slope
      step = 0
      old_step = right - left
      old_value = 0
      is_converged = .false.
      do iteration = 1, max_iterations
         call equation%evaluate(x, value)
         if (ieee_is_nan(value)) return
         is_converged = abs(value) <= round_off
         if (is_converged) return
         if (value < 0) left = x
         if (value > 0) right = x
         if (abs(step) > 0) rise = (value - old_value)/step
         old_value = value
         is_secant = 2*rise*(right - left) > abs(value)
         step = 0
         if (is_secant) step = min(max(-value/rise, left - x), right - x)
         is_converged = (is_secant .and. abs(step) <= last_step .and. old_step <= near_step) &
            & .or. right - left <= last_digits*max(abs(x), 1.0_dp)
         if (is_converged) x = x + step
         if (is_converged) return
         if (abs(step) < probe_step .and. old_step > near_step) step = min(max(-sign(probe_step, value), left - x), right - x)
         if (.not. is_secant .or. abs(step) >= max(old_step/2, 2*probe_step)) then
            step = left + (right - left)/2 - x
            old_step = right - left
         else
            old_step = abs(step)
         end if
         x = x + step
      end do
   end subroutine find_rising_root

end module adfric_numerics_secant_root
