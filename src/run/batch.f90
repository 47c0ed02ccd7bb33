! SPDX-License-Identifier: GPL-3.0-or-later
!> A batch: results of neighbouring blocks that go to the sink together; and a store of batches.
module adfric_run_batch
   use adfric_base_kinds, only: dp, i8
   use adfric_base_error, only: error_t
   use adfric_run_sink, only: sink_t
   implicit none (type, external)
   private
   public :: batch_store_t, new_batch_store, batch_bytes

   !> Where a thread finds space for the next batch while others wait for the sink.
   type :: batch_store_t
      !> The batches, taken or not.
      type(batch_t), allocatable :: batches(:)
      !> Is the batch at a index taken?
      logical, allocatable, private :: is_taken(:)
      !> Sizes of a batch, which gets its memory when it is first taken.
      integer, private :: n_results = 0, n_counts = 0, block_size = 0, max_blocks = 0
   contains
      procedure :: take
      procedure :: give_back
   end type batch_store_t

   !> Results of some points from `first` on, kept as they are written.
   type :: batch_t
      !> Number of the first point in the run, from 1.
      integer(i8) :: first = 1
      !> Number of points whose results are in the batch, and of their blocks.
      integer :: n_points = 0, n_blocks = 0
      !> Results of the points; shape `(n_points, n_results)`, with space for more.
      real(dp), allocatable :: results(:, :)
      !> Relative error of the main result at each point; shape `(n_points)`, with space for more.
      real(dp), allocatable :: error_estimate(:)
      !> One of `status_...` for each point; shape `(n_points)`, with space for more.
      integer, allocatable :: status(:)
      !> What the model counted; shape `(n_blocks, n_counts)`, with space for more.
      real(dp), allocatable :: counts(:, :)
   contains
      procedure :: put_into
      procedure :: clear
   end type batch_t

contains

   !> Make space for a batch; it is empty.
   pure subroutine new_batch(self, n_results, n_counts, block_size, max_blocks)
      !> Receives space for results; it has no points yet.
      type(batch_t), intent(out) :: self
      !> Number of results per point.
      integer, intent(in) :: n_results
      !> Number of counts that the model makes per block.
      integer, intent(in) :: n_counts
      !> Largest number of points of a block.
      integer, intent(in) :: block_size
      !> Largest number of blocks of a batch.
      integer, intent(in) :: max_blocks

      allocate (self%results(block_size*max_blocks, n_results), self%counts(max_blocks, n_counts))
      allocate (self%error_estimate(block_size*max_blocks), self%status(block_size*max_blocks))
   end subroutine new_batch

   !> Make a store of so many batches.
   pure subroutine new_batch_store(self, n, n_results, n_counts, block_size, max_blocks)
      !> Receives the batches, none of which is taken or has memory yet.
      type(batch_store_t), intent(out) :: self
      integer, intent(in) :: n, n_results, n_counts, block_size, max_blocks

      allocate (self%batches(n))
      allocate (self%is_taken(n), source=.false.)
      self%n_results = n_results
      self%n_counts = n_counts
      self%block_size = block_size
      self%max_blocks = max_blocks
   end subroutine new_batch_store

   !> Take an empty batch; by one thread at a time.
   pure subroutine take(self, index)
      !> The store, in which the batch is marked as taken.
      class(batch_store_t), intent(inout) :: self
      !> Index of the batch in the store, from 1; 0 if all are taken.
      integer, intent(out) :: index

      index = findloc(self%is_taken, .false., dim=1)
      if (index == 0) return
      self%is_taken(index) = .true.
      if (.not. allocated(self%batches(index)%status)) call new_batch(self%batches(index), self%n_results, self%n_counts, &
         self%block_size, self%max_blocks)
   end subroutine take

   !> Give back a batch, which is empty again; by one thread at a time.
   pure subroutine give_back(self, index)
      !> The store, in which the batch is marked as free.
      class(batch_store_t), intent(inout) :: self
      !> Index of the batch in the store, from 1.
      integer, intent(in) :: index

      self%is_taken(index) = .false.
   end subroutine give_back

   !> Memory of a batch [bytes].
   pure real(dp) function batch_bytes(n_results, n_points)
      integer, intent(in) :: n_results
      !> Number of points that the batch has space for.
      integer, intent(in) :: n_points
      integer, parameter :: real_bytes = 8, integer_bytes = 4

      batch_bytes = real(n_points, dp)*(real_bytes*(n_results + 1) + integer_bytes)
   end function batch_bytes

   !> Hand the results to a sink; the batch is empty then, and goes on with the next block.
   subroutine put_into(self, sink, error)
      !> In: the results of some points. Out: an empty batch that begins with the point behind them.
      class(batch_t), intent(inout) :: self
      class(sink_t), intent(inout) :: sink
      type(error_t), allocatable, intent(out) :: error

      associate (n => self%n_points)
         call sink%put(self%first, self%results(:n, :), self%error_estimate(:n), self%status(:n), &
            self%counts(:self%n_blocks, :), error)
      end associate
      self%first = self%first + self%n_points
      call self%clear()
   end subroutine put_into

   !> Forget the results.
   pure subroutine clear(self)
      !> The batch, which keeps its memory and its first point.
      class(batch_t), intent(inout) :: self

      self%n_points = 0
      self%n_blocks = 0
   end subroutine clear

end module adfric_run_batch
