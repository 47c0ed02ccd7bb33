! SPDX-License-Identifier: GPL-3.0-or-later
!> Solve the points of a simulation by the threads that the caller wants, and leave OpenMP as it was.
module adfric_api_solution
   use omp_lib, only: omp_get_active_level, omp_get_max_active_levels, omp_get_max_threads, omp_set_num_threads
   use adfric_base_error, only: error_t, file_failure, input_failure, set_error
   use adfric_base_text, only: show_count
   use adfric_base_watch, only: watch_t
   use adfric_output_resources, only: check_memory
   use adfric_run_blocks, only: blocks_t
   use adfric_run_memory_sink, only: memory_sink_t, new_memory_sink, status_not_put
   use adfric_run_progress, only: progress_t, silent_progress_t
   use adfric_run_run, only: run_t
   use adfric_run_runner, only: run_sweep
   use adfric_run_summary, only: run_summary_t
   use adfric_system_threads, only: check_threads
   implicit none (type, external)
   private
   public :: solve_by_threads, stopped

   !> Code of the error of a call that the caller has ended before its time.
   integer, parameter :: stopped = 4

contains

   !> Solve every point of a run.
   subroutine solve_by_threads(run, found, error, n_threads, progress, summary)
      !> The run, whose values have been checked.
      class(run_t), intent(inout) :: run
      !> Receives the results; not allocated if there is an error.
      type(memory_sink_t), allocatable, intent(out) :: found
      !> Allocated if the machine has too little memory or too few threads, or the caller has ended the call.
      type(error_t), allocatable, intent(out) :: error
      !> Number of threads, >= 1; as many as OpenMP gives if absent.
      integer, intent(in), optional :: n_threads
      !> Is told from time to time how many points are solved, and may end the call.
      class(progress_t), intent(inout), optional :: progress
      !> Receives counts and times; of no use if there is an error.
      type(run_summary_t), intent(out), optional :: summary
      type(silent_progress_t) :: silent
      type(run_summary_t) :: told
      integer :: n, n_before

      n_before = omp_get_max_threads()
      n = n_before
      if (present(n_threads)) n = n_threads
      if (n < 1) then
         !$omp critical (adfric_api)
         call set_error(error, input_failure, 'n_threads: out of range, given '//show_count(n)//', allowed: an integer >= 1')
         !$omp end critical (adfric_api)
         return
      end if
      ! a caller within a parallel region of its own has the threads that OpenMP leaves it
      if (omp_get_active_level() >= omp_get_max_active_levels() .or. takes_one_thread(run)) n = 1
      if (n > 1) call check_threads(n - 1, error)
      if (allocated(error)) return
      ! of this thread alone, and only up to the end of this procedure
      call omp_set_num_threads(n)
      if (present(progress)) then
         call solve_all(run, found, progress, told, error)
      else
         call solve_all(run, found, silent, told, error)
      end if
      call omp_set_num_threads(n_before)
      if (allocated(error)) deallocate (found)
      if (present(summary)) summary = told
   end subroutine solve_by_threads

   !> Would more threads than the one that calls find nothing to do?
   logical function takes_one_thread(run)
      !> The run, with its model and its points.
      class(run_t), intent(in) :: run
      type(blocks_t) :: blocks

      blocks = run%blocks()
      takes_one_thread = blocks%n_blocks() <= 1 .and. .not. run%model%shares_points
   end function takes_one_thread

   !> Solve every point by the threads that there are.
   subroutine solve_all(run, found, progress, summary, error)
      class(run_t), intent(inout) :: run
      !> Receives the results; of no use if there is an error.
      type(memory_sink_t), allocatable, intent(out) :: found
      class(progress_t), intent(inout), target :: progress
      type(run_summary_t), intent(out) :: summary
      type(error_t), allocatable, intent(out) :: error
      class(watch_t), pointer :: watch

      allocate (found)
      !$omp critical (adfric_api)
      call check_memory(run, 1, error)
      if (.not. allocated(error)) call new_memory_sink(found, run, error)
      !$omp end critical (adfric_api)
      if (allocated(error)) return
      watch => progress
      call run%model%obey(watch)
      call run%model%prepare()
      call run_sweep(run, found, progress, summary, error)
      call run%model%release()
      nullify (watch)
      call run%model%obey(watch)
      if (allocated(error)) return
      if (all(found%status /= status_not_put)) return
      if (summary%signal /= 0) then
         call set_error(error, file_failure, 'a signal ended the run before its time')
      else
         call set_error(error, stopped, 'the call was stopped before all points were solved')
      end if
   end subroutine solve_all

end module adfric_api_solution
