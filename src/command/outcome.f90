! SPDX-License-Identifier: GPL-3.0-or-later
!> What a command leaves behind: what it has to say, and how it ended.
!>
!> Whatever it says comes through here, so that here, once for all, text from outside is made fit to be shown.
module adfric_command_outcome
   use adfric_base_error, only: error_t
   use adfric_base_printable, only: printable
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: newline
   implicit none (type, external)
   private
   public :: outcome_t, exit_success, exit_not_converged, exit_input, exit_file, exit_signal

   !> Exit status of the program; to the last one the number of the signal is added, as shells do.
   integer, parameter :: exit_success = 0, exit_not_converged = 1, exit_input = 2, exit_file = 3, exit_signal = 128

   !> The end of a command.
   type :: outcome_t
      !> One of `exit_...`, or `exit_signal` and the number of a signal.
      integer :: exit_status = exit_success
      !> Lines for the standard output, each with its line end.
      character(:), allocatable :: output
      !> Lines for the standard error, each with its line end.
      character(:), allocatable :: errors
   contains
      procedure :: say
      procedure :: fail
      procedure :: fail_with_problems
   end type outcome_t

contains

   !> Add lines to the output.
   pure subroutine say(self, lines)
      class(outcome_t), intent(inout) :: self
      !> Lines, each with its line end.
      character(*), intent(in) :: lines

      if (.not. allocated(self%output)) self%output = ''
      self%output = self%output//printable(lines, has_lines=.true.)
   end subroutine say

   !> End with an error.
   pure subroutine fail(self, error)
      class(outcome_t), intent(inout) :: self
      !> What went wrong; its code becomes the exit status.
      type(error_t), intent(in) :: error

      if (.not. allocated(self%errors)) self%errors = ''
      self%errors = self%errors//printable(error%message)//newline
      self%exit_status = error%code
   end subroutine fail

   !> End with everything that is wrong with an input.
   pure subroutine fail_with_problems(self, problems, file)
      !> The outcome; receives a line for each problem and the exit status.
      class(outcome_t), intent(inout) :: self
      !> What is wrong with the input, at least one problem.
      type(problems_t), intent(in) :: problems
      !> Name of the input, which stands before every line.
      character(*), intent(in) :: file
      integer :: i

      if (.not. allocated(self%errors)) self%errors = ''
      do i = 1, problems%count()
         if (problems%is_repeated(i)) cycle
         self%errors = self%errors//printable(problems%line_of(i, file))//newline
      end do
      if (problems%is_enough()) self%errors = self%errors//printable(file)// &
         ': the rest of the input has not been examined, there may be more to mend'//newline
      self%exit_status = exit_input
   end subroutine fail_with_problems

end module adfric_command_outcome
