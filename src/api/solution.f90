!> Solve the points of a simulation by the threads that the caller wants, and leave OpenMP as it was.
module adfric_api_solution
   use omp_lib, only: omp_get_active_level, omp_get_max_active_levels, omp_get_max_threads, omp_set_num_threads
   use adfric_base_error, only: error_t, file_failure, input_failure, set_error
   use adfric_base_text, only: show_count
   use adfric_output_resources, only: check_memory
   use adfric_run_memory_sink, only: memory_sink_t, new_memory_sink, status_not_put
   use adfric_run_progress, only: silent_progress_t
   use adfric_run_run, only: run_t
   use adfric_run_runner, only: run_sweep
   use adfric_run_summary, only: run_summary_t
   use adfric_system_threads, only: check_threads
   implicit none (type, external)
   private
   public :: solve_by_threads

contains

   !> Solve every point of a run.
   subroutine solve_by_threads(run, found, error, n_threads)
      !> The run, whose values have been checked.
      class(run_t), intent(inout) :: run
      !> Receives the results; not allocated if there is an error.
      type(memory_sink_t), allocatable, intent(out) :: found
      !> Allocated if the machine has too little memory or too few threads.
      type(error_t), allocatable, intent(out) :: error
      !> Number of threads, >= 1; as many as OpenMP gives if absent.
      integer, intent(in), optional :: n_threads
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
      if (omp_get_active_level() >= omp_get_max_active_levels()) n = 1
      if (n > 1) call check_threads(n - 1, error)
      if (allocated(error)) return
      ! of this thread alone, and only up to the end of this procedure
      call omp_set_num_threads(n)
      call solve_all(run, found, error)
      call omp_set_num_threads(n_before)
      if (allocated(error)) deallocate (found)
   end subroutine solve_by_threads

   !> Solve every point by the threads that there are.
   subroutine solve_all(run, found, error)
      !> The run, whose values have been checked.
      class(run_t), intent(inout) :: run
      !> Receives the results; of no use if there is an error.
      type(memory_sink_t), allocatable, intent(out) :: found
      !> Allocated if the machine has too little memory.
      type(error_t), allocatable, intent(out) :: error
      type(silent_progress_t) :: silent
      type(run_summary_t) :: summary

      allocate (found)
      !$omp critical (adfric_api)
      call check_memory(run, 1, error)
      if (.not. allocated(error)) call new_memory_sink(found, run, error)
      !$omp end critical (adfric_api)
      if (allocated(error)) return
      call run%model%prepare()
      call run_sweep(run, found, silent, summary, error)
      call run%model%release()
      if (allocated(error)) return
      if (any(found%status == status_not_put)) call set_error(error, file_failure, 'a signal ended the run before its time')
   end subroutine solve_all

end module adfric_api_solution
