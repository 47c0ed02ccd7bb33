! SPDX-License-Identifier: GPL-3.0-or-later
!> Read the input of a command and make its model.
module adfric_command_case
   use adfric, only: new_model, known_models
   use adfric_base_error, only: error_t
   use adfric_base_problems, only: problems_t
   use adfric_command_outcome, only: outcome_t
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_run, only: run_input_t, read_job, read_case
   implicit none (type, external)
   private
   public :: open_case

contains

   !> Read and validate an input. The outcome is a failure if anything is wrong with it.
   subroutine open_case(path, run, outcome)
      !> Name of the input.
      character(*), intent(in) :: path
      !> Receives what the input describes, with its model; only to be used if the outcome is no failure.
      type(run_input_t), intent(out) :: run
      !> Receives the failure, if there is one.
      type(outcome_t), intent(inout) :: outcome
      type(namelist_file_t) :: file
      type(problems_t) :: problems
      type(error_t), allocatable :: error

      call read_job(path, known_models, file, run, problems, error)
      if (.not. allocated(error) .and. len(run%model_name) > 0) then
         call new_model(run%model, run%model_name, error)
         if (.not. allocated(error)) call read_case(file, run, problems)
      end if
      if (allocated(error)) then
         call outcome%fail(error)
      else if (problems%count() > 0) then
         call outcome%fail_with_problems(problems, path)
      end if
   end subroutine open_case

end module adfric_command_case
