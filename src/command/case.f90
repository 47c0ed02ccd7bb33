! SPDX-License-Identifier: GPL-3.0-or-later
!> Read the input of a command and make its model.
module adfric_command_case
   use adfric, only: known_models
   use adfric_base_error, only: error_t
   use adfric_base_printable, only: shell_word
   use adfric_base_problems, only: problems_t
   use adfric_base_words, only: has_word
   use adfric_command_outcome, only: outcome_t
   use adfric_input_fit, only: fit_input_t, has_fit_groups, read_fit
   use adfric_input_fit_rows, only: fit_groups
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_run, only: run_input_t, read_job, read_case
   use adfric_input_scene, only: make_model
   implicit none (type, external)
   private
   public :: open_case, open_input, run_or_fit, run_only, fit_only

   !> What an input may be.
   integer, parameter :: run_or_fit = 0, run_only = 1, fit_only = 2

contains

   !> Read and validate the input of a run. The outcome is a failure if anything is wrong with it.
   subroutine open_case(path, run, outcome)
      !> Name of the input.
      character(*), intent(in) :: path
      !> Receives what the input describes, with its model; only to be used if the outcome is no failure.
      type(run_input_t), intent(out) :: run
      !> Receives the failure, if there is one.
      type(outcome_t), intent(inout) :: outcome
      type(fit_input_t), allocatable :: details

      call open_input(path, run_only, run, details, outcome)
   end subroutine open_case

   !> Read and validate an input. The outcome is a failure if anything is wrong with it.
   subroutine open_input(path, kind, run, details, outcome)
      character(*), intent(in) :: path
      !> What the input may be: `run_or_fit`, `run_only` or `fit_only`.
      integer, intent(in) :: kind
      type(run_input_t), intent(out) :: run
      !> Receives what the input of a fit says of the data; not allocated for a run.
      type(fit_input_t), allocatable, intent(out) :: details
      type(outcome_t), intent(inout) :: outcome
      type(namelist_file_t) :: file
      type(problems_t) :: problems
      type(error_t), allocatable :: error

      call read_job(path, known_models, file, run, problems, error)
      if (.not. allocated(error)) call make_model(file, run, problems, error)
      if (.not. allocated(error) .and. allocated(run%model)) call read_run_or_fit(file, kind, run, details, problems)
      if (allocated(error)) then
         call outcome%fail(error)
      else if (problems%count() > 0) then
         call outcome%fail_with_problems(problems, path)
      end if
   end subroutine open_input

   !> Read the case of a run or of a fit.
   subroutine read_run_or_fit(file, kind, run, details, problems)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: kind
      !> In: what `read_job` has found, and the model. Out: the run.
      type(run_input_t), intent(inout) :: run
      type(fit_input_t), allocatable, intent(out) :: details
      type(problems_t), intent(inout) :: problems

      if (has_fit_groups(file)) then
         if (kind == run_only) then
            call problems%add(first_fit_group(file), '', 'the input is that of a fit, needed: adfric fit '// &
               shell_word(file%path))
         else
            allocate (details)
            call read_fit(file, run, details, problems)
         end if
      else if (kind == fit_only) then
         call problems%add('data', '', 'the group is missing, the input is that of a run, needed: adfric run '// &
            shell_word(file%path))
      else
         call read_case(file, run, problems)
      end if
   end subroutine read_run_or_fit

   !> Name of the first group that a run does not have.
   pure function first_fit_group(file) result(name)
      type(namelist_file_t), intent(in) :: file
      character(:), allocatable :: name
      integer :: i

      name = ''
      do i = size(file%groups), 1, -1
         if (has_word(fit_groups, file%groups(i)%name)) name = trim(file%groups(i)%name)
      end do
   end function first_fit_group

end module adfric_command_case
