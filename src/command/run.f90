!> `adfric run`: solve every point of an input and write the results file.
module adfric_command_run
   use adfric_base_error, only: error_t, set_error, input_failure, file_failure
   use adfric_base_model, only: model_t, status_not_converged
   use adfric_command_case, only: open_case
   use adfric_command_line, only: command_t
   use adfric_command_outcome, only: outcome_t, exit_success, exit_not_converged
   use adfric_input_run, only: run_input_t
   use adfric_output_names, only: check_output_name, would_replace
   use adfric_output_resources, only: check_resources
   use adfric_output_results_file, only: results_file_t, note_t
   use adfric_output_run_table, only: new_run_table
   use adfric_sweep_progress, only: progress_t
   use adfric_sweep_runner, only: run_sweep
   use adfric_sweep_summary, only: run_summary_t
   implicit none (type, external)
   private
   public :: run_case

contains

   !> Carry out the command.
   subroutine run_case(command, progress, outcome)
      type(command_t), intent(in) :: command
      class(progress_t), intent(inout) :: progress
      type(outcome_t), intent(inout) :: outcome
      class(model_t), allocatable :: model
      type(run_input_t) :: run
      type(run_summary_t) :: summary
      type(error_t), allocatable :: error

      call open_case(command%subject, model, run, outcome)
      if (outcome%exit_status /= exit_success) return
      if (len(command%output) > 0) run%output = command%output
      call check_output(command, model, run, error)
      if (.not. allocated(error)) call solve_case(command, model, run, progress, summary, error)
      if (allocated(error)) then
         call outcome%fail(error)
         return
      end if
      if (summary%by_status(status_not_converged) > 0) outcome%exit_status = exit_not_converged
      if (command%is_quiet) return
      call outcome%say(new_run_table(summary, model%describe_results(run%plan%base), run%output))
   end subroutine run_case

   !> Can the results be written? Asked before anything is solved.
   subroutine check_output(command, model, run, error)
      type(command_t), intent(in) :: command
      class(model_t), intent(in) :: model
      type(run_input_t), intent(in) :: run
      type(error_t), allocatable, intent(out) :: error
      integer :: k

      if (would_replace(run%output, command%subject)) then
         call set_error(error, input_failure, run%output//': the results would replace the input')
         return
      end if
      do k = 1, size(run%datasets)
         if (.not. run%datasets(k)%is_given()) cycle
         if (.not. would_replace(run%output, run%datasets(k)%file)) cycle
         call set_error(error, input_failure, run%output//': the results would replace the data of '//model%variables(k)%name)
         return
      end do
      call check_output_name(run%output, command%overwrite, error)
      if (allocated(error)) return
      call check_resources(model, run%plan, run%output, error)
      if (allocated(error)) error%message = command%subject//': '//error%message
   end subroutine check_output

   !> Names and checksums of the datasets that the input names.
   function notes_on_datasets(model, run) result(notes)
      class(model_t), intent(in) :: model
      type(run_input_t), intent(in) :: run
      type(note_t), allocatable :: notes(:)
      integer :: k, n

      allocate (notes(2*count(run%datasets%is_given())))
      n = 0
      do k = 1, size(run%datasets)
         if (.not. run%datasets(k)%is_given()) cycle
         notes(n + 1)%name = 'dataset_'//model%variables(k)%name
         notes(n + 1)%text = run%datasets(k)%text
         notes(n + 2)%name = 'checksum_'//model%variables(k)%name
         notes(n + 2)%text = run%datasets(k)%checksum
         n = n + 2
      end do
   end function notes_on_datasets

   !> Solve every point and write the results.
   subroutine solve_case(command, model, run, progress, summary, error)
      type(command_t), intent(in) :: command
      class(model_t), intent(in) :: model
      type(run_input_t), intent(in) :: run
      class(progress_t), intent(inout) :: progress
      type(run_summary_t), intent(out) :: summary
      type(error_t), allocatable, intent(out) :: error
      type(results_file_t) :: results

      call results%create(run%output, command%overwrite, model, run%plan, run%title, run%text, error, &
         notes_on_datasets(model, run))
      if (allocated(error)) return
      call run_sweep(model, run%plan, results, progress, summary, error)
      if (allocated(error)) then
         ! What could be written may be the work of hours.
         if (error%code == file_failure) then
            call results%abandon(error)
         else
            call results%discard()
         end if
         return
      end if
      call results%finish(summary%wall_seconds, summary%attributes, error)
   end subroutine solve_case

end module adfric_command_run
