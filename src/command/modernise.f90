! SPDX-License-Identifier: GPL-3.0-or-later
!> `adfric modernise`: write an input that names a model as a scene.
module adfric_command_modernise
   use adfric, only: known_models
   use adfric_base_error, only: error_t
   use adfric_base_problems, only: problems_t
   use adfric_command_case, only: open_input, run_or_fit
   use adfric_command_line, only: command_t
   use adfric_command_outcome, only: outcome_t, exit_success
   use adfric_input_fit, only: fit_input_t
   use adfric_input_modern, only: write_scene
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_run, only: read_job, run_input_t
   implicit none (type, external)
   private
   public :: modernise_input

contains

   !> Carry out the command.
   subroutine modernise_input(command, outcome)
      !> What the user asks for on the command line.
      type(command_t), intent(in) :: command
      !> Receives the scene, and the exit status.
      type(outcome_t), intent(inout) :: outcome
      type(run_input_t) :: job
      type(namelist_file_t) :: file
      type(problems_t) :: problems
      type(error_t), allocatable :: error
      character(:), allocatable :: text

      call read_job(command%subject, known_models, file, job, problems, error)
      if (allocated(error)) then
         call outcome%fail(error)
         return
      end if
      text = file%text
      if (problems%count() == 0 .and. .not. job%is_scene) &
         call write_scene(file, job%model_name, counts_of_heights(command), text, problems)
      if (problems%count() > 0) then
         call outcome%fail_with_problems(problems, command%subject)
      else
         call outcome%say(without_returns(text))
      end if
   end subroutine modernise_input

   !> A text with line ends of one letter, and blanks for tabs.
   pure function without_returns(text) result(plain)
      character(*), intent(in) :: text
      character(:), allocatable :: plain
      integer :: i, n

      plain = text
      n = 0
      do i = 1, len(text)
         if (text(i:i) == achar(13)) cycle
         n = n + 1
         plain(n:n) = text(i:i)
         if (text(i:i) == achar(9)) plain(n:n) = ' '
      end do
      plain = plain(:n)
   end function without_returns

   !> Number of samples of the heights along x and y; 0 where the input has none, or their file is not there.
   function counts_of_heights(command) result(counts)
      type(command_t), intent(in) :: command
      integer :: counts(2)
      type(run_input_t) :: run
      type(fit_input_t), allocatable :: details
      type(outcome_t) :: outcome
      integer :: i, n

      counts = 0
      call open_input(command%subject, run_or_fit, run, details, outcome)
      if (outcome%exit_status /= exit_success) return
      do i = 1, size(run%datasets)
         if (run%model%variables(i)%name /= 'heights' .or. .not. allocated(run%datasets(i)%counts)) cycle
         n = size(run%datasets(i)%counts)
         counts = 1
         counts(1) = int(run%datasets(i)%counts(n))
         if (n > 1) counts(2) = int(run%datasets(i)%counts(1))
      end do
   end function counts_of_heights

end module adfric_command_modernise
