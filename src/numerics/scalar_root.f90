! SPDX-License-Identifier: GPL-3.0-or-later
!> A root of one equation in one unknown, inside a bracket that is never left.
module adfric_numerics_scalar_root
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   implicit none (type, external)
   private
   public :: equation_t, find_root

   integer, parameter :: max_iterations = 200
   !> A Newton step of this size, relative to the distance from the ends of the bracket, leaves an error of
   !> round-off only, for convergence is quadratic.
   real(dp), parameter :: close_enough = 1.0e-9_dp

   !> An equation `value(x) = 0` that carries its parameters.
   type, abstract :: equation_t
   contains
      procedure(evaluate_i), deferred :: evaluate
   end type equation_t

   abstract interface
      !> Value and derivative at x.
      pure subroutine evaluate_i(self, x, value, slope)
         import :: equation_t, dp
         implicit none (type, external)
         !> The equation with its parameters.
         class(equation_t), intent(in) :: self
         !> The unknown, at a position within the bracket.
         real(dp), intent(in) :: x
         !> Value of the equation at x, 0 at the root; NaN ends the search.
         real(dp), intent(out) :: value
         !> Derivative of the value by x, which steers the search.
         real(dp), intent(out) :: slope
      end subroutine evaluate_i
   end interface

contains

   !> Newton's method, with bisection wherever it would leave the bracket or does not at least halve its steps. Where the value is
   !> not a number there is no convergence.
   pure subroutine find_root(equation, low, high, rises, x, is_converged, small_step)
      !> The equation, whose value and slope are asked for again and again.
      class(equation_t), intent(in) :: equation
      !> Ends of the bracket; the value changes its sign once between them. They are not evaluated.
      real(dp), intent(in) :: low, high
      !> Is the value negative at `low`?
      logical, intent(in) :: rises
      !> In: a first guess, or anything outside the bracket. Out: the root.
      real(dp), intent(inout) :: x
      !> Was the root found to round-off, or to `small_step`?
      logical, intent(out) :: is_converged
      !> Size of a Newton step that ends the search; if absent, a size that follows from the bracket.
      real(dp), intent(in), optional :: small_step
      real(dp) :: left, right, value, slope, step, last_step, enough
      integer :: iteration
      logical :: is_tangent

      if (has_asserts) call assert(low < high, 'find_root: the bracket has a width')
      left = low
      right = high
      if (.not. (x > left .and. x < right)) x = left + (right - left)/2
      last_step = right - left
      is_converged = .false.
      do iteration = 1, max_iterations
         call equation%evaluate(x, value, slope)
         if (ieee_is_nan(value)) return
         is_converged = abs(value) < tiny(value)
         if (is_converged) return
         if ((value < 0) .eqv. rises) then
            left = x
         else
            right = x
         end if
         is_tangent = abs(slope)*(right - left) > abs(value) .and. (slope > 0 .eqv. rises)
         step = right - left
         if (is_tangent) step = -value/slope
         enough = close_enough*min(x - low, high - x)
         if (present(small_step)) enough = small_step
         is_converged = is_tangent .and. abs(step) <= enough
         if (is_converged) then
            x = min(max(x + step, left), right)
         else if (x + step > left .and. x + step < right .and. abs(step) < last_step/2) then
            last_step = abs(step)
            x = x + step
         else
            x = left + (right - left)/2
            last_step = right - left
            is_converged = last_step <= 4*epsilon(x)*max(abs(left), abs(right))
         end if
         if (is_converged) return
      end do
   end subroutine find_root

end module adfric_numerics_scalar_root
