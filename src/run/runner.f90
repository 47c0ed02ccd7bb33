! SPDX-License-Identifier: GPL-3.0-or-later
!> Solve the blocks that a source gives, with all threads, and hand the results to a sink.
!>
!> Each thread takes a few neighbouring blocks, solves them one by one and leaves their results to one more thread, which
!> puts them into the sink, again and again. Blocks may be taken and put in any order: the results do not depend on it.
!> Batches are small where points take long, so that little is lost when a run is killed, and large where points take
!> next to no time, so that few calls of the sink are needed. Memory does not grow with the number of points.
module adfric_run_runner
   use omp_lib, only: omp_get_max_active_levels, omp_get_max_threads, omp_get_num_threads, omp_get_thread_num, &
      & omp_set_max_active_levels, omp_set_num_threads
   use adfric_base_kinds, only: dp, i8
   use adfric_base_error, only: error_t
   use adfric_describe_status, only: status_out_of_memory
   use adfric_run_batch, only: batch_bytes
   use adfric_run_blocks, only: blocks_t, block_size_of
   use adfric_run_block_source, only: block_source_t, block_list_t, new_block_list
   use adfric_run_delivery, only: delivery_t, new_delivery, profile_gate_t, prepare_sink, leave_batch, &
      & end_leaving, deliver, give_up, has_failed, most_waiting
   use adfric_run_progress, only: progress_t
   use adfric_run_run, only: run_t
   use adfric_run_sink, only: sink_t
   use adfric_run_summary, only: run_summary_t, new_summary
   use adfric_system_clock, only: pause_thread, wall_clock
   use adfric_system_interruption, only: caught_signal
   implicit none (type, external)
   private
   public :: run_sweep, memory_needed

   !> Largest number of blocks of a batch.
   integer, parameter :: largest_batch = 16
   !> A batch that is solved faster is followed by a larger one, one that takes longer by a smaller one [s].
   real(dp), parameter :: short_batch = 0.02_dp, long_batch = 0.1_dp
   !> Results of whole blocks wait no longer than this for the rest of their batch [s].
   real(dp), parameter :: longest_wait = 0.2_dp
   !> Shortest and longest time that the first thread sleeps while others solve the last blocks [s].
   real(dp), parameter :: shortest_pause = 2.0e-5_dp, longest_pause = 5.0e-3_dp

   !> What the threads share.
   type :: sweep_t
      !> Number of points solved by this process, and before this run.
      integer(i8) :: n_solved = 0
      !> Number of threads that solve nothing more.
      integer :: n_ended = 0
      !> The way of the results to the sink.
      type(delivery_t) :: delivery
      !> Shape of the profiles of a point, see `run_t`.
      integer :: profile_shape(3) = 0
      !> Threads that a model may use for one point.
      integer :: threads_of_point = 1
      !> What the threads that have ended have found.
      type(run_summary_t) :: summary
   end type sweep_t

   !> What each thread has for itself.
   type :: worker_t
      !> Values of the variables at the points of a block; shape `(n_variables, block_size)`.
      real(dp), allocatable :: values(:, :)
      !> Results of the points of a block; shape `(n_results, block_size)`.
      real(dp), allocatable :: results(:, :)
      !> Profiles of a point; shape `profile_shape` of `sweep_t`.
      real(dp), allocatable :: profiles(:, :, :)
      !> Index of the batch that the thread fills.
      integer :: index = 0
      !> Number of blocks that the thread takes next.
      integer :: n_wanted = 1
      !> What this thread has found so far.
      type(run_summary_t) :: summary
   end type worker_t

contains

   !> Solve every block of the source. The run ends before that when a signal asks for it; `summary%signal` says so. It does so, too,
   !> when the listener wants it.
   subroutine run_sweep(run, sink, progress, summary, error, source)
      !> The run, whose model solves the points.
      class(run_t), intent(in) :: run
      !> Receives the results.
      class(sink_t), intent(inout) :: sink
      !> Is told from time to time how many points are solved, and says whether the run shall end.
      class(progress_t), intent(inout) :: progress
      !> Counts, ranges and times of the points that are solved now.
      type(run_summary_t), intent(out) :: summary
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      !> Says which blocks are solved; if absent, every block of the run's part is.
      class(block_source_t), intent(inout), optional :: source
      type(block_list_t) :: every_block

      if (present(source)) then
         call run_source(run, sink, progress, summary, error, source)
      else
         call new_block_list(every_block, run%blocks())
         call run_source(run, sink, progress, summary, error, every_block)
      end if
   end subroutine run_sweep

   !> Solve every block of a source.
   subroutine run_source(run, sink, progress, summary, error, source)
      class(run_t), intent(in) :: run
      class(sink_t), intent(inout) :: sink
      !> Is told from time to time how many points are solved, and says whether the run shall end.
      class(progress_t), intent(inout) :: progress
      !> Counts, ranges and times of the points that are solved now.
      type(run_summary_t), intent(out) :: summary
      type(error_t), allocatable, intent(out) :: error
      !> Says which blocks are solved; they are taken from it.
      class(block_source_t), intent(inout) :: source
      type(sweep_t) :: sweep
      real(dp) :: start
      integer :: n_threads, n_workers, n_levels

      start = wall_clock()
      sweep%profile_shape = run%profile_shape()
      call new_summary(sweep%summary, run%model%results)
      sweep%n_solved = source%n_points_before
      call progress%report(sweep%n_solved, source%blocks%n_points())
      n_threads = omp_get_max_threads()
      ! where there are less blocks than threads, a model that can shares the work of a point among the threads that remain
      n_workers = int(max(1_i8, min(int(n_threads, i8), source%blocks%n_blocks())))
      sweep%threads_of_point = max(1, n_threads/n_workers)
      n_levels = omp_get_max_active_levels()
      call omp_set_max_active_levels(max(2, n_levels))
      if (n_workers == 1 .and. n_threads > 1) then
         ! no team around those of the point: the runtime makes new threads for each team within a team, which took a fifth of the time
         call share_work(run, sink, source, n_workers, 1, sweep)
         call take_part(run, sink, progress, source, 0, sweep)
      else
         !$omp parallel default(none) shared(run, sink, progress, source, sweep, n_workers) &
         !$omp& num_threads(n_workers + merge(1, 0, sink%has_own_thread))
         !$omp single
         call share_work(run, sink, source, n_workers, omp_get_num_threads(), sweep)
         !$omp end single
         call take_part(run, sink, progress, source, omp_get_thread_num(), sweep)
         !$omp end parallel
      end if
      call omp_set_max_active_levels(n_levels)
      call sweep%delivery%remove_writer()
      if (allocated(sweep%delivery%error)) call move_alloc(sweep%delivery%error, error)
      summary = sweep%summary
      summary%output_seconds = sweep%delivery%seconds
      if (sweep%n_solved < source%blocks%n_points()) summary%signal = int(caught_signal())
      summary%wall_seconds = wall_clock() - start
   end subroutine run_source

   !> What a thread of the run does: it solves, or it writes.
   subroutine take_part(run, sink, progress, source, thread, sweep)
      class(run_t), intent(in) :: run
      class(sink_t), intent(inout) :: sink
      class(progress_t), intent(inout) :: progress
      class(block_source_t), intent(inout) :: source
      !> Number of the thread among those of the run, from 0. The team of a caller has other numbers.
      integer, intent(in) :: thread
      type(sweep_t), intent(inout) :: sweep

      ! the last thread is the one that writes
      if (thread < sweep%delivery%n_workers) then
         call work(run, sink, progress, source, thread, sweep)
         if (thread == 0) call watch_others(progress, source, sweep)
         call end_leaving(sweep%delivery)
      else if (sweep%delivery%has_writer) then
         call deliver(sink, sweep%delivery)
      end if
   end subroutine take_part

   !> Say who solves and who writes, as far as the threads that there are allow it.
   subroutine share_work(run, sink, source, n_wanted, n_threads, sweep)
      !> The run, whose model has so many results and counts.
      class(run_t), intent(in) :: run
      !> The sink, which is made ready here if no thread writes for the others.
      class(sink_t), intent(inout) :: sink
      class(block_source_t), intent(in) :: source
      !> Number of threads that may solve, and of those that there are.
      integer, intent(in) :: n_wanted, n_threads
      !> Receives the delivery, ready to take batches.
      type(sweep_t), intent(inout) :: sweep

      call new_delivery(sweep%delivery, min(n_wanted, n_threads), size(run%model%results), size(run%model%counts), &
         source%blocks%size, largest_batch)
      if (n_threads > sweep%delivery%n_workers) call sweep%delivery%make_writer()
      ! the thread that writes does that itself, while the others begin
      if (.not. sweep%delivery%has_writer) call prepare_sink(sink, sweep%delivery)
   end subroutine share_work

   !> Memory that a run needs beside that of its plan [bytes].
   real(dp) function memory_needed(run)
      !> The run, whose numbers of points, variables and results and lengths of profiles count.
      class(run_t), intent(in) :: run
      integer, parameter :: real_bytes = 8
      real(dp) :: per_thread, batch
      integer :: block_size, n_threads

      block_size = block_size_of(run%plan%n_points())
      n_threads = omp_get_max_threads()
      batch = batch_bytes(size(run%model%results), largest_batch*block_size)
      per_thread = real(real_bytes, dp)*block_size*(size(run%model%variables) + size(run%model%results)) &
         + real_bytes*product(real(run%profile_shape(), dp))
      memory_needed = per_thread*n_threads + batch*(n_threads + most_waiting)
   end function memory_needed

   !> What each thread does.
   subroutine work(run, sink, progress, source, thread, sweep)
      class(run_t), intent(in) :: run
      class(sink_t), intent(inout) :: sink
      class(progress_t), intent(inout) :: progress
      class(block_source_t), intent(inout) :: source
      !> Number of the thread, from 0.
      integer, intent(in) :: thread
      !> What the threads share; receives what this thread has found.
      type(sweep_t), intent(inout) :: sweep
      type(worker_t) :: worker
      integer(i8) :: first, n_solved
      real(dp) :: start, waiting, waiting_since
      integer :: n, i
      logical :: is_solved, is_cut_short

      call new_worker(worker, run, source%blocks, thread, sweep)
      call omp_set_num_threads(sweep%threads_of_point)
      do
         call take_blocks(source, sweep, progress, worker%n_wanted, first, n)
         if (n == 0) exit
         sweep%delivery%store%batches(worker%index)%first = source%blocks%first_point(first)
         start = wall_clock()
         waiting_since = start
         do i = 0, n - 1
            call solve_one_block(run, source%blocks, first + i, sink, sweep, worker, is_solved)
            if (.not. is_solved) exit
            waiting = wall_clock() - waiting_since
            if (i == n - 1 .or. waiting > longest_wait) then
               call leave_batch(sink, sweep%delivery, worker%index)
               waiting_since = wall_clock()
            end if
            !$omp critical (adfric_run_shared)
            sweep%n_solved = sweep%n_solved + source%blocks%n_points_of(first + i)
            n_solved = sweep%n_solved + source%n_points_elsewhere
            !$omp end critical (adfric_run_shared)
            if (thread == 0) call progress%report(n_solved, source%blocks%n_points())
            if (must_end(sweep, progress)) exit
         end do
         call leave_batch(sink, sweep%delivery, worker%index)
         call choose_batch_size(wall_clock() - start, worker%n_wanted)
      end do
      is_cut_short = must_end(sweep, progress)
      !$omp critical (adfric_run_shared)
      if (is_cut_short) call source%end_early()
      call sweep%summary%merge(worker%summary)
      sweep%n_ended = sweep%n_ended + 1
      !$omp end critical (adfric_run_shared)
   end subroutine work

   !> Sleep until the others have ended, and tell how far they are: the first thread alone may end the run on its listener's behalf.
   subroutine watch_others(progress, source, sweep)
      !> Is told from time to time how many points are solved.
      class(progress_t), intent(inout) :: progress
      class(block_source_t), intent(in) :: source
      type(sweep_t), intent(in) :: sweep
      integer(i8) :: n_solved
      integer :: n_ended
      real(dp) :: pause

      pause = shortest_pause
      do
         !$omp critical (adfric_run_shared)
         n_ended = sweep%n_ended
         n_solved = sweep%n_solved + source%n_points_elsewhere
         !$omp end critical (adfric_run_shared)
         if (n_ended >= sweep%delivery%n_workers) exit
         call progress%report(n_solved, source%blocks%n_points())
         call pause_thread(pause)
         pause = min(2*pause, longest_pause)
      end do
   end subroutine watch_others

   !> Make ready what a thread has for itself.
   subroutine new_worker(self, run, blocks, thread, sweep)
      !> Receives space for the values, results and profiles of a block.
      type(worker_t), intent(out) :: self
      !> The run, whose numbers of variables and results count.
      class(run_t), intent(in) :: run
      !> The blocks of the run, which say how many points one has.
      type(blocks_t), intent(in) :: blocks
      !> Number of the thread, from 0.
      integer, intent(in) :: thread
      !> What the threads share; it says which shape profiles have.
      type(sweep_t), intent(in) :: sweep

      associate (n => blocks%size, shape => sweep%profile_shape)
         allocate (self%values(size(run%model%variables), n), self%results(size(run%model%results), n))
         allocate (self%profiles(shape(1), shape(2), shape(3)))
      end associate
      self%index = thread + 1
      call new_summary(self%summary, run%model%results)
   end subroutine new_worker

   !> Take the next blocks: less of them towards the end of the run, so that all threads end at about the same time.
   subroutine take_blocks(source, sweep, progress, n_wanted, first, n)
      !> The source, which has these blocks no more.
      class(block_source_t), intent(inout) :: source
      !> What the threads share; it says whether something has failed.
      type(sweep_t), intent(in) :: sweep
      class(progress_t), intent(in) :: progress
      !> Largest number of blocks to take, at least 1.
      integer, intent(in) :: n_wanted
      !> Number in the run of the first block that is taken; undefined if there is none.
      integer(i8), intent(out) :: first
      !> Number of blocks that are taken; 0 if none remains, or if the run must end.
      integer, intent(out) :: n
      integer(i8) :: share

      n = 0
      if (must_end(sweep, progress)) return
      !$omp critical (adfric_run_shared)
      share = source%n_remaining/(2*sweep%delivery%n_workers)
      call source%take_blocks(int(max(1_i8, min(share, int(n_wanted, i8)))), first, n)
      !$omp end critical (adfric_run_shared)
   end subroutine take_blocks

   !> Has something failed, or does the user want the run to end?
   logical function must_end(sweep, progress)
      type(sweep_t), intent(in) :: sweep
      class(progress_t), intent(in) :: progress

      must_end = has_failed(sweep%delivery)
      if (.not. must_end) must_end = caught_signal() /= 0
      if (.not. must_end) must_end = progress%wants_end()
   end function must_end

   !> Number of blocks of the next batch.
   pure subroutine choose_batch_size(duration, n)
      !> Time that the last batch took [s].
      real(dp), intent(in) :: duration
      !> In: number of blocks of the last batch. Out: that of the next one.
      integer, intent(inout) :: n

      if (duration < short_batch) n = min(2*n, largest_batch)
      if (duration > long_batch) n = max(n/2, 1)
   end subroutine choose_batch_size

   !> Solve a block and add it to the batch; profiles go to the sink at once. Where that fails, nothing is added.
   subroutine solve_one_block(run, blocks, block, sink, sweep, worker, is_solved)
      class(run_t), intent(in) :: run
      !> The blocks of the run, which say where this one begins and ends.
      type(blocks_t), intent(in) :: blocks
      !> Number of the block in the run, from 1.
      integer(i8), intent(in) :: block
      class(sink_t), intent(inout), target :: sink
      !> What the threads share; the results are added to the thread's batch in its store.
      type(sweep_t), intent(inout), target :: sweep
      !> What the thread has for itself; the points are added to its summary.
      type(worker_t), intent(inout) :: worker
      logical, intent(out) :: is_solved
      real(dp) :: counts(size(run%model%counts))
      type(profile_gate_t) :: gate
      real(dp) :: start
      integer :: offset, n, i

      start = wall_clock()
      is_solved = .false.
      n = blocks%n_points_of(block)
      gate%first = blocks%first_point(block)
      call run%plan%get_values(gate%first, worker%values(:, :n))
      associate (batch => sweep%delivery%store%batches(worker%index), results => worker%results(:, :n))
         offset = batch%n_points
         if (size(worker%profiles) > 0) then
            gate%sink => sink
            gate%delivery => sweep%delivery
            call run%model%solve_block_and_profiles(worker%values(:, :n), results, batch%error_estimate(offset + 1:offset + n), &
               batch%status(offset + 1:offset + n), counts, worker%profiles, gate)
            if (gate%is_closed) return
         else
            call run%model%solve_block(worker%values(:, :n), results, batch%error_estimate(offset + 1:offset + n), &
               batch%status(offset + 1:offset + n), counts)
         end if
         if (any(batch%status(offset + 1:offset + n) == status_out_of_memory)) then
            call give_up(sweep%delivery, 'there is too little memory to solve a point')
            return
         end if
         ! what was found may have ended before its time
         if (run%model%is_stopped()) return
         call worker%summary%add_points(results, batch%status(offset + 1:offset + n))
         do i = 1, size(results, 1)
            batch%results(offset + 1:offset + n, i) = results(i, :)
         end do
         batch%n_points = offset + n
         batch%n_blocks = batch%n_blocks + 1
         batch%counts(batch%n_blocks, :) = counts
      end associate
      is_solved = .true.
      worker%summary%solver_seconds = worker%summary%solver_seconds + wall_clock() - start - gate%seconds
   end subroutine solve_one_block

end module adfric_run_runner
