!> Solve every point of a plan with all threads and hand the results to a sink.
!>
!> The points are cut into blocks of neighbours, whose size depends on the plan alone, so that the results are
!> the same for any number of threads. Many blocks make a slab. Whoever solves the last block of a slab puts
!> it into the sink while the others go on with the next one; nobody waits as long as the sink keeps up, and the
!> memory does not grow with the plan.
module adfric_sweep_runner
   use omp_lib, only: omp_get_max_threads, omp_get_thread_num
   use adfric_base_kinds, only: dp, i8
   use adfric_base_error, only: error_t, set_error, input_failure
   use adfric_base_model, only: model_t, status_solved
   use adfric_base_words, only: count_words
   use adfric_sweep_clock, only: wall_clock
   use adfric_sweep_plan, only: plan_t
   use adfric_sweep_progress, only: progress_t
   use adfric_sweep_ring, only: ring_t, new_ring, n_slabs
   use adfric_sweep_sink, only: sink_t
   use adfric_sweep_slab, only: slab_t, slab_bytes
   use adfric_sweep_summary, only: run_summary_t, new_summary, add_attributes
   use adfric_sweep_threads, only: let_others_run
   implicit none (type, external)
   private
   public :: run_sweep, block_size_of, memory_needed

   !> Smallest and largest number of points of a block, and the number of blocks that a plan between them has.
   integer, parameter :: smallest_block = 16, largest_block = 256, blocks_of_small_plan = 32
   !> Least number of slabs of a plan, so that a run that is stopped has most of its results in the sink.
   integer, parameter :: slabs_per_plan = 8
   !> Largest number of blocks of a slab, but for many threads: each has a block in every slab.
   integer, parameter :: largest_slab = 64

   !> What the threads share.
   type :: sweep_t
      type(ring_t) :: ring
      !> Shape of the profiles of a point; (0, 0, 0) if there are none.
      integer :: profile_shape(3) = 0
      type(run_summary_t) :: summary
      type(error_t), allocatable :: error
   end type sweep_t

   !> What each thread has for itself.
   type :: worker_t
      !> Shape `(n_variables, block_size)`.
      real(dp), allocatable :: values(:, :)
      !> Shape `(n_results, block_size)`.
      real(dp), allocatable :: results(:, :)
      !> Profiles of a point.
      real(dp), allocatable :: profiles(:, :, :)
      type(run_summary_t) :: summary
   end type worker_t

contains

   !> Solve every point.
   subroutine run_sweep(model, plan, sink, progress, summary, error)
      class(model_t), intent(in) :: model
      type(plan_t), intent(in) :: plan
      class(sink_t), intent(inout) :: sink
      class(progress_t), intent(inout) :: progress
      type(run_summary_t), intent(out) :: summary
      type(error_t), allocatable, intent(out) :: error
      type(sweep_t) :: sweep
      real(dp) :: start

      start = wall_clock()
      call prepare(model, plan, sweep)
      if (.not. allocated(sweep%error)) then
         !$omp parallel default(none) shared(model, plan, sink, progress, sweep)
         call work(model, plan, sink, progress, sweep)
         !$omp end parallel
      end if
      if (allocated(sweep%error)) call move_alloc(sweep%error, error)
      summary = sweep%summary
      summary%wall_seconds = wall_clock() - start
   end subroutine run_sweep

   !> Number of points of the blocks of a plan.
   pure integer function block_size_of(n_points)
      integer(i8), intent(in) :: n_points

      block_size_of = int(min(int(largest_block, i8), max(int(smallest_block, i8), n_points/blocks_of_small_plan)))
   end function block_size_of

   !> Memory that a run needs beside that of its plan [bytes].
   real(dp) function memory_needed(model, plan)
      class(model_t), intent(in) :: model
      type(plan_t), intent(in) :: plan
      integer, parameter :: real_bytes = 8
      integer :: n_results, n_threads

      n_results = size(model%results)
      n_threads = omp_get_max_threads()
      memory_needed = n_slabs*slab_bytes(n_results, blocks_per_slab(plan%n_points())*block_size_of(plan%n_points())) &
         + real(real_bytes, dp)*n_threads*largest_block*(size(model%variables) + n_results)
      if (model%wants_profiles(plan%base)) memory_needed = memory_needed &
         + real_bytes*n_threads*product(real(profile_shape_of(model, plan), dp))
   end function memory_needed

   !> Number of blocks of a slab.
   integer function blocks_per_slab(n_points)
      integer(i8), intent(in) :: n_points
      integer(i8) :: n_blocks

      n_blocks = 1 + (n_points - 1)/block_size_of(n_points)
      blocks_per_slab = int(min(n_blocks, max(min(n_blocks/slabs_per_plan, int(largest_slab, i8)), &
         int(omp_get_max_threads(), i8))))
   end function blocks_per_slab

   !> Shape of the profiles of a point: the axis that runs fastest first.
   function profile_shape_of(model, plan) result(counts)
      class(model_t), intent(in) :: model
      type(plan_t), intent(in) :: plan
      integer :: counts(3)
      integer :: k, n_axes

      n_axes = count_words(model%profile_axes)
      counts = [1, 1, size(model%profiles)]
      do k = 1, n_axes
         counts(n_axes + 1 - k) = size(model%get_profile_axis(plan%base, k))
      end do
   end function profile_shape_of

   !> Make ready what the threads share.
   subroutine prepare(model, plan, sweep)
      class(model_t), intent(in) :: model
      type(plan_t), intent(in) :: plan
      type(sweep_t), intent(out) :: sweep
      logical :: is_ready

      associate (n => plan%n_points())
         call new_ring(sweep%ring, n, size(model%results), block_size_of(n), blocks_per_slab(n), is_ready)
      end associate
      if (.not. is_ready) call set_error(sweep%error, input_failure, 'no memory for the results')
      if (model%wants_profiles(plan%base)) sweep%profile_shape = profile_shape_of(model, plan)
      call new_summary(sweep%summary, model%results)
   end subroutine prepare

   !> What each thread does.
   subroutine work(model, plan, sink, progress, sweep)
      class(model_t), intent(in) :: model
      type(plan_t), intent(in) :: plan
      class(sink_t), intent(inout) :: sink
      class(progress_t), intent(inout) :: progress
      type(sweep_t), intent(inout) :: sweep
      type(worker_t) :: worker
      integer(i8) :: n_solved
      integer :: slab, block
      logical :: is_last

      call new_worker(worker, model, sweep)
      do
         !$omp critical (adfric_sweep_ring)
         call sweep%ring%take_block(slab, block, is_last)
         is_last = is_last .or. allocated(sweep%error)
         !$omp end critical (adfric_sweep_ring)
         if (is_last) exit
         if (slab == 0) then
            call let_others_run()
            cycle
         end if
         call solve_one_block(model, plan, block, sweep%ring%slabs(slab), worker)
         if (size(worker%profiles) > 0) then
            call solve_block_profiles(model, plan, sink, block, sweep%ring%slabs(slab), worker, sweep%error)
         end if
         !$omp critical (adfric_sweep_ring)
         call sweep%ring%finish_block(slab, block)
         n_solved = sweep%ring%n_solved
         !$omp end critical (adfric_sweep_ring)
         if (omp_get_thread_num() == 0) call progress%report(n_solved, sweep%ring%n_points)
         call put_slabs(sink, sweep)
      end do
      !$omp critical (adfric_sweep_ring)
      call sweep%summary%merge(worker%summary)
      !$omp end critical (adfric_sweep_ring)
   end subroutine work

   !> Make ready what a thread has for itself.
   subroutine new_worker(self, model, sweep)
      type(worker_t), intent(out) :: self
      class(model_t), intent(in) :: model
      type(sweep_t), intent(in) :: sweep

      associate (n => sweep%ring%slabs(1)%block_size, shape => sweep%profile_shape)
         allocate (self%values(size(model%variables), n), self%results(size(model%results), n))
         allocate (self%profiles(shape(1), shape(2), shape(3)))
      end associate
      call new_summary(self%summary, model%results)
   end subroutine new_worker

   !> Solve a block.
   subroutine solve_one_block(model, plan, block, slab, worker)
      class(model_t), intent(in) :: model
      type(plan_t), intent(in) :: plan
      integer, intent(in) :: block
      !> Each block has its own part of the slab.
      type(slab_t), intent(inout) :: slab
      type(worker_t), intent(inout) :: worker
      real(dp) :: start
      integer :: offset, n, i

      start = wall_clock()
      call slab%get_block(block, offset, n)
      call plan%get_values(slab%first + offset, worker%values(:, :n))
      associate (error_estimate => slab%error_estimate(offset + 1:offset + n), &
                 status => slab%status(offset + 1:offset + n), results => worker%results(:, :n))
         call model%solve_block(worker%values(:, :n), results, error_estimate, status, slab%attributes(block)%items)
         call worker%summary%add_points(results, status)
         do i = 1, size(results, 1)
            slab%results(offset + 1:offset + n, i) = results(i, :)
         end do
      end associate
      worker%summary%solver_seconds = worker%summary%solver_seconds + wall_clock() - start
   end subroutine solve_one_block

   !> Solve the profiles of the solved points of a block; each goes to the sink at once.
   subroutine solve_block_profiles(model, plan, sink, block, slab, worker, error)
      class(model_t), intent(in) :: model
      type(plan_t), intent(in) :: plan
      class(sink_t), intent(inout) :: sink
      integer, intent(in) :: block
      type(slab_t), intent(in) :: slab
      type(worker_t), intent(inout) :: worker
      !> Shared by the threads.
      type(error_t), allocatable, intent(inout) :: error
      type(error_t), allocatable :: own_error
      integer :: offset, n, i
      logical :: has_failed

      call slab%get_block(block, offset, n)
      call plan%get_values(slab%first + offset, worker%values(:, :n))
      do i = 1, n
         if (slab%status(offset + i) /= status_solved) cycle
         call model%solve_profiles(worker%values(:, i), slab%results(offset + i, :), worker%profiles)
         !$omp critical (adfric_sweep_sink)
         if (.not. allocated(error)) then
            call sink%put_profiles(slab%first + offset + i - 1, worker%profiles, own_error)
            call keep_error(own_error, error)
         end if
         has_failed = allocated(error)
         !$omp end critical (adfric_sweep_sink)
         if (has_failed) return
      end do
   end subroutine solve_block_profiles

   !> Put the slabs that are complete into the sink, unless another thread is about it.
   subroutine put_slabs(sink, sweep)
      class(sink_t), intent(inout) :: sink
      type(sweep_t), intent(inout) :: sweep
      type(error_t), allocatable :: own_error
      integer :: slab

      do
         !$omp critical (adfric_sweep_ring)
         call sweep%ring%take_slab(slab)
         !$omp end critical (adfric_sweep_ring)
         if (slab == 0) return
         !$omp critical (adfric_sweep_sink)
         if (.not. allocated(sweep%error)) then
            call put_slab(sink, sweep%ring%slabs(slab), sweep%summary, own_error)
            call keep_error(own_error, sweep%error)
         end if
         !$omp end critical (adfric_sweep_sink)
         !$omp critical (adfric_sweep_ring)
         call sweep%ring%release_slab()
         !$omp end critical (adfric_sweep_ring)
      end do
   end subroutine put_slabs

   !> Put a slab into the sink; the sums are taken in the order of the blocks.
   subroutine put_slab(sink, slab, summary, error)
      class(sink_t), intent(inout) :: sink
      type(slab_t), intent(in) :: slab
      type(run_summary_t), intent(inout) :: summary
      type(error_t), allocatable, intent(out) :: error
      real(dp) :: start
      integer :: block

      start = wall_clock()
      do block = 1, slab%n_blocks
         call add_attributes(summary%attributes, slab%attributes(block)%items)
      end do
      associate (n => slab%n_points)
         call sink%put(slab%first, slab%results(:n, :), slab%error_estimate(:n), slab%status(:n), error)
      end associate
      summary%output_seconds = summary%output_seconds + wall_clock() - start
   end subroutine put_slab

   !> Keep an error for all threads to see: by it they end, and nothing more goes to the sink.
   subroutine keep_error(own_error, error)
      type(error_t), allocatable, intent(in) :: own_error
      type(error_t), allocatable, intent(inout) :: error

      if (.not. allocated(own_error)) return
      !$omp critical (adfric_sweep_ring)
      allocate (error, source=own_error)
      !$omp end critical (adfric_sweep_ring)
   end subroutine keep_error

end module adfric_sweep_runner
