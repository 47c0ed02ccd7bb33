! SPDX-License-Identifier: GPL-3.0-or-later
!> Seconds of the parts of a run, as `adfric run` goes through them. For `whole_program`; see bench/README.md.
!>
!> phases INPUT.nml OUTPUT.h5
program phases
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_command_case, only: open_case
   use adfric_command_outcome, only: outcome_t, exit_success
   use adfric_input_run, only: run_input_t
   use adfric_output_results_file, only: results_file_t
   use adfric_run_progress, only: silent_progress_t
   use adfric_run_runner, only: run_sweep
   use adfric_run_summary, only: run_summary_t
   use adfric_system_clock, only: wall_clock
   use measure, only: text_argument
   implicit none (type, external)

   type(run_input_t) :: run
   type(outcome_t) :: outcome
   type(results_file_t) :: results
   type(silent_progress_t) :: progress
   type(run_summary_t) :: summary
   type(error_t), allocatable :: error
   real(dp) :: times(5)

   times(1) = wall_clock()
   call open_case(text_argument(1, 'input.nml'), run, outcome)
   if (outcome%exit_status /= exit_success) error stop 'phases: the input is wrong'
   times(2) = wall_clock()
   run%output = text_argument(2, 'phases.h5')
   call results%begin(run, .true., error)
   if (allocated(error)) error stop 'phases: no name for the file'
   times(3) = wall_clock()
   call run_sweep(run, results, progress, summary, error)
   if (allocated(error)) error stop 'phases: the sweep failed'
   times(4) = wall_clock()
   call results%finish(summary%wall_seconds, error)
   if (allocated(error)) error stop 'phases: the file cannot be closed'
   times(5) = wall_clock()
   ! input, name of the file, solution, what the one thread that solves waits for, closing, all; and what a second thread
   ! does beside the solution: creating and writing the file
   print '(7es13.5)', times(2) - times(1), times(3) - times(2), summary%solver_seconds, &
      times(4) - times(3) - summary%solver_seconds, times(5) - times(4), times(5) - times(1), summary%output_seconds

end program phases
