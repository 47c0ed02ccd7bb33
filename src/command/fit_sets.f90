! SPDX-License-Identifier: GPL-3.0-or-later
!> Confidence sets in words: one interval, several, or open ones.
module adfric_command_fit_sets
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_command_rounding, only: show_to_digits, show_to_error
   use adfric_fit_problem, only: fit_t
   use adfric_fit_solution, only: solution_t
   implicit none (type, external)
   private
   public :: show_set

contains

   !> The set of a variable.
   pure function show_set(fit, solution, free, level) result(text)
      type(fit_t), intent(in) :: fit
      type(solution_t), intent(in) :: solution
      !> Number of the free variable.
      integer, intent(in) :: free
      !> Number of the level.
      integer, intent(in) :: level
      character(:), allocatable :: text
      integer :: k

      text = 'none'
      if (.not. allocated(solution%interval)) return
      if (size(solution%interval) == 0 .or. size(fit%frees) < free) return
      do k = 1, min(solution%interval_pieces(level, free), size(solution%interval, 2))
         if (k == 1) text = show_piece(solution%interval(:, k, level, free), solution%error(free))
         if (k > 1) text = text//' or '//show_piece(solution%interval(:, k, level, free), solution%error(free))
      end do
   end function show_set

   !> A piece of a set.
   pure function show_piece(ends, error) result(text)
      !> Both ends; NaN: open.
      real(dp), intent(in) :: ends(2)
      !> Standard error of the variable; NaN: there is none.
      real(dp), intent(in) :: error
      character(:), allocatable :: text

      if (ieee_is_finite(ends(1)) .and. ieee_is_finite(ends(2))) then
         text = show_end(ends(1), error)//' to '//show_end(ends(2), error)
      else if (ieee_is_finite(ends(1))) then
         text = '>= '//show_end(ends(1), error)
      else if (ieee_is_finite(ends(2))) then
         text = '<= '//show_end(ends(2), error)
      else
         text = 'any'
      end if
   end function show_piece

   !> An end: to the second digit of the error, where that leaves a digit.
   pure function show_end(value, error) result(text)
      !> The end.
      real(dp), intent(in) :: value
      real(dp), intent(in) :: error
      character(:), allocatable :: text

      if (ieee_is_finite(error)) then
         if (abs(value) > error) then
            text = show_to_error(value, error)
            return
         end if
      end if
      text = show_to_digits(value, 2)
   end function show_end

end module adfric_command_fit_sets
