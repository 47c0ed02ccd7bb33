! SPDX-License-Identifier: GPL-3.0-or-later
!> How results get from the threads that solve into the sink.
!>
!> One more thread has nothing to do but that: while it writes and waits for the disk, the others go on. It sleeps as long
!> as there is nothing to write, and they do when too many batches wait for it. Where there is no such thread, each puts
!> its results into the sink itself.
module adfric_run_delivery
   use adfric_base_kinds, only: dp, i8
   use adfric_base_error, only: error_t, set_error, file_failure
   use adfric_describe_profile_receiver, only: profile_receiver_t
   use adfric_run_batch, only: batch_store_t, new_batch_store
   use adfric_run_sink, only: sink_t
   use adfric_system_clock, only: wall_clock
   use adfric_system_semaphore, only: semaphore_t
   implicit none (type, external)
   private
   public :: delivery_t, new_delivery, profile_gate_t, prepare_sink, leave_batch, end_leaving, deliver, give_up, has_failed, &
      & most_waiting

   !> Number of batches that may wait for the sink.
   integer, parameter :: most_waiting = 32

   !> What the threads share.
   type :: delivery_t
      !> Is there a thread that has nothing else to do?
      logical :: has_writer = .false.
      !> The batches that are filled, that wait and that are free.
      type(batch_store_t) :: store
      !> The first error of the sink or of a point; after it nothing more goes to the sink.
      type(error_t), allocatable :: error
      !> Time in the sink [s].
      real(dp) :: seconds = 0
      !> Number of threads that solve from the beginning.
      integer :: n_workers = 0
      !> Number of those threads that have not ended yet.
      integer, private :: n_working = 0
      !> Indices of the batches that wait for the sink; the one that has waited longest stands first.
      integer, allocatable, private :: queue(:)
      !> Number of batches that wait for the sink.
      integer, private :: n_waiting = 0
      !> The bell counts the batches that wait, and at the end one more; the space counts those that may still be left.
      type(semaphore_t), private :: bell, space
      !> The semaphore counts the threads that may end, once everything is written.
      type(semaphore_t), private :: finish
      !> Can the sink take results?
      logical, private :: is_prepared = .false.
   contains
      procedure :: make_writer
      procedure :: remove_writer
   end type delivery_t

   !> The way of the profiles of a block to the sink: at once, for they are large.
   type, extends(profile_receiver_t) :: profile_gate_t
      !> Receives the profiles.
      class(sink_t), pointer :: sink => null()
      !> What the threads share; it keeps an error of the sink.
      type(delivery_t), pointer :: delivery => null()
      !> Number of the first point of the block in the run.
      integer(i8) :: first = 1
      !> Time that profiles took to reach the sink, waiting included [s].
      real(dp) :: seconds = 0
      !> Has something failed? Then nothing more is handed over.
      logical :: is_closed = .false.
   contains
      procedure :: take => put_profiles
   end type profile_gate_t

contains

   !> Make ready what the threads share. Of the batches each thread that solves has the one of its number, from 1.
   subroutine new_delivery(self, n_workers, n_results, n_counts, block_size, max_blocks)
      !> Receives the store and an empty queue; no thread writes for the others yet.
      type(delivery_t), intent(out) :: self
      !> Number of threads that solve.
      integer, intent(in) :: n_workers
      !> Number of results per point.
      integer, intent(in) :: n_results
      !> Number of counts that the model makes per block.
      integer, intent(in) :: n_counts
      !> Largest number of points of a block.
      integer, intent(in) :: block_size
      !> Largest number of blocks of a batch.
      integer, intent(in) :: max_blocks
      integer :: i, index

      self%n_workers = n_workers
      self%n_working = n_workers
      allocate (self%queue(n_workers + most_waiting))
      call new_batch_store(self%store, size(self%queue), n_results, n_counts, block_size, max_blocks)
      do i = 1, n_workers
         call self%store%take(index)
      end do
   end subroutine new_delivery

   !> From now on a thread writes for the others, if the system has what that needs.
   subroutine make_writer(self)
      !> Receives the semaphores; `has_writer` says whether all could be made.
      class(delivery_t), intent(inout) :: self
      logical :: is_made(3)

      call self%bell%make(0, is_made(1))
      call self%space%make(most_waiting, is_made(2))
      call self%finish%make(0, is_made(3))
      self%has_writer = all(is_made)
   end subroutine make_writer

   !> The thread that wrote has ended.
   subroutine remove_writer(self)
      class(delivery_t), intent(inout) :: self

      call self%bell%free()
      call self%space%free()
      call self%finish%free()
   end subroutine remove_writer

   !> Leave a batch to be put into the sink, and go on with an empty one behind it.
   subroutine leave_batch(sink, self, index)
      !> Receives the results at once where no thread writes for the others.
      class(sink_t), intent(inout) :: sink
      !> What the threads share; the batch is added to its queue.
      type(delivery_t), intent(inout) :: self
      !> In: index of the batch that remains. Out: index of the empty one.
      integer, intent(inout) :: index
      integer :: next

      if (self%store%batches(index)%n_blocks == 0) return
      if (.not. self%has_writer) then
         call put_batch(sink, self, index)
         return
      end if
      call self%space%wait()
      !$omp critical (adfric_run_store)
      call self%store%take(next)
      self%store%batches(next)%first = self%store%batches(index)%first + self%store%batches(index)%n_points
      self%n_waiting = self%n_waiting + 1
      self%queue(self%n_waiting) = index
      !$omp end critical (adfric_run_store)
      call self%bell%post()
      index = next
   end subroutine leave_batch

   !> A thread solves nothing more, and sleeps until all is written.
   subroutine end_leaving(self)
      !> What the threads share; the thread no longer counts as one that solves.
      type(delivery_t), intent(inout) :: self
      logical :: is_last

      !$omp critical (adfric_run_store)
      self%n_working = self%n_working - 1
      is_last = self%n_working == 0
      !$omp end critical (adfric_run_store)
      if (.not. self%has_writer) return
      if (is_last) call self%bell%post()
      call self%finish%wait()
   end subroutine end_leaving

   !> Put into the sink what the others leave, until all of them have ended.
   subroutine deliver(sink, self)
      class(sink_t), intent(inout) :: sink
      !> What the threads share; batches are taken from its queue and given back to its store.
      type(delivery_t), intent(inout) :: self
      integer :: index, i

      call prepare_sink(sink, self)
      do
         call self%bell%wait()
         !$omp critical (adfric_run_store)
         index = 0
         if (self%n_waiting > 0) then
            index = self%queue(1)
            self%queue(:self%n_waiting - 1) = self%queue(2:self%n_waiting)
            self%n_waiting = self%n_waiting - 1
         end if
         !$omp end critical (adfric_run_store)
         if (index == 0) exit
         call put_batch(sink, self, index)
         !$omp critical (adfric_run_store)
         call self%store%give_back(index)
         !$omp end critical (adfric_run_store)
         call self%space%post()
      end do
      do i = 1, self%n_workers
         call self%finish%post()
      end do
   end subroutine deliver

   !> Make the sink ready, unless it is so already. It must be before a batch is put into it.
   subroutine prepare_sink(sink, self)
      !> The sink, which can take results afterwards unless it fails.
      class(sink_t), intent(inout) :: sink
      !> What the threads share; it keeps the error if the sink fails.
      type(delivery_t), intent(inout) :: self
      type(error_t), allocatable :: error

      !$omp critical (adfric_run_sink)
      if (.not. self%is_prepared) then
         call sink%prepare(error)
         call keep_error(error, self%error)
         self%is_prepared = .true.
      end if
      !$omp end critical (adfric_run_sink)
   end subroutine prepare_sink

   !> Put a batch into the sink; it is empty then.
   subroutine put_batch(sink, self, index)
      class(sink_t), intent(inout) :: sink
      !> What the threads share; it keeps the error if the sink fails, and the time.
      type(delivery_t), intent(inout) :: self
      !> Index of the batch in the store, from 1.
      integer, intent(in) :: index
      type(error_t), allocatable :: error
      real(dp) :: start

      !$omp critical (adfric_run_sink)
      start = wall_clock()
      if (.not. has_failed(self)) then
         call self%store%batches(index)%put_into(sink, error)
         call keep_error(error, self%error)
      else
         call self%store%batches(index)%clear()
      end if
      self%seconds = self%seconds + wall_clock() - start
      !$omp end critical (adfric_run_sink)
   end subroutine put_batch

   !> See `profile_receiver_t`.
   subroutine put_profiles(self, index, profiles, goes_on)
      !> The way to the sink; it is closed if the sink has failed.
      class(profile_gate_t), intent(inout) :: self
      !> Index of the point in its block, from 1.
      integer, intent(in) :: index
      real(dp), intent(in) :: profiles(:, :, :)
      !> False: nothing more of this block is wanted, its results neither.
      logical, intent(out) :: goes_on
      type(error_t), allocatable :: error
      real(dp) :: arrival, start

      arrival = wall_clock()
      associate (delivery => self%delivery)
         ! the thread that writes may not have come to it
         call prepare_sink(self%sink, delivery)
         !$omp critical (adfric_run_sink)
         start = wall_clock()
         if (.not. has_failed(delivery)) then
            call self%sink%put_profiles(self%first + index - 1, profiles, error)
            call keep_error(error, delivery%error)
         end if
         self%is_closed = has_failed(delivery)
         delivery%seconds = delivery%seconds + wall_clock() - start
         !$omp end critical (adfric_run_sink)
      end associate
      goes_on = .not. self%is_closed
      self%seconds = self%seconds + wall_clock() - arrival
   end subroutine put_profiles

   !> End the run, since points cannot be solved: nothing more goes to the sink.
   subroutine give_up(self, message)
      !> What the threads share; it keeps the error, unless there is one already.
      type(delivery_t), intent(inout) :: self
      !> Why the points cannot be solved, in one line.
      character(*), intent(in) :: message
      type(error_t), allocatable :: error

      call set_error(error, file_failure, message)
      call keep_error(error, self%error)
   end subroutine give_up

   !> Keep an error for all threads to see.
   subroutine keep_error(own_error, error)
      !> Error that this thread has met; not allocated: nothing is done.
      type(error_t), allocatable, intent(in) :: own_error
      !> Receives a copy of the error, unless there is one already.
      type(error_t), allocatable, intent(inout) :: error

      if (.not. allocated(own_error)) return
      !$omp critical (adfric_run_error)
      if (.not. allocated(error)) allocate (error, source=own_error)
      !$omp end critical (adfric_run_error)
   end subroutine keep_error

   !> Has the sink or a point failed? Then all threads end.
   logical function has_failed(self)
      !> What the threads share, with the error if there is one.
      type(delivery_t), intent(in) :: self

      !$omp critical (adfric_run_error)
      has_failed = allocated(self%error)
      !$omp end critical (adfric_run_error)
   end function has_failed

end module adfric_run_delivery
