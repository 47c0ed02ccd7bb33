! SPDX-License-Identifier: GPL-3.0-or-later
!> Results that are written into an open file: by one process, or by several at the same time.
!>
!> A point's `status` is written only when its results are on the disk, so a file says truthfully what it has, whenever the
!> program, or the machine, stops.
module adfric_output_results_writer
   use hdf5, only: hid_t
   use adfric_base_kinds, only: dp, i8
   use adfric_base_error, only: error_t
   use adfric_base_not_a_number, only: not_a_number
   use adfric_hdf5_calls, only: hdf5_calls_t, no_id
   use adfric_hdf5_file, only: open_file, flush_file, close_file
   use adfric_describe_status, only: status_solved
   use adfric_output_block_sums, only: profile_sums_t, sum_of_block, sum_of_profiles
   use adfric_output_datasets, only: datasets_t
   use adfric_output_file_state, only: is_idle, is_open, is_closed, is_shared, check_state
   use adfric_output_layout, only: layout_t
   use adfric_output_status_log, only: status_log_t
   use adfric_run_sink, only: sink_t
   use adfric_system_files, only: file_id_t, synchronise, begin_to_synchronise
   use adfric_system_clock, only: wall_clock
   use adfric_system_leftovers, only: forget_leftover, note_kept
   implicit none (type, external)
   private
   public :: results_writer_t

   !> Least time between two moments at which everything is brought to the disk [s], and in times of what that takes.
   real(dp), parameter :: least_interval = 0.1_dp, interval_by_duration = 50

   !> So many numbers are written before the system is asked to begin to bring them to the disk.
   integer, parameter :: many = 500000

   !> A file that is being written.
   type, extends(sink_t) :: results_writer_t
      !> Final name, and the one it has now.
      character(:), allocatable :: path, path_now
      !> Where the file is in its life, one of `is_...` of `file_state.f90`.
      integer :: state = is_idle
      !> Identity of the file that this run writes; others may put a file of theirs in its place.
      type(file_id_t) :: id
      !> Layout of the file: its datasets and its points.
      type(layout_t) :: layout
      !> Id of the file while it is open in this process.
      integer(hid_t) :: file = no_id
      !> The datasets of the open file.
      type(datasets_t) :: datasets
      !> When everything was last on the disk, and how long that took [s].
      real(dp) :: safe_at = 0, safe_took = 0
      !> Did this run find the file when it began?
      logical :: is_resumed = .false.
      !> May there be states of points in the file?
      logical :: has_states = .false.
      !> Checksums of the blocks that were put last.
      integer(i8), allocatable :: sums(:)
      !> States that wait for their results to be on the disk.
      type(status_log_t), private :: log
      !> Checksums of the profiles of blocks that have not been put yet.
      type(profile_sums_t), private :: profile_sums
      !> Numbers written since the system was last asked to bring them to the disk.
      integer(i8), private :: n_numbers = 0
   contains
      procedure :: open_found
      procedure :: open_shared
      procedure :: close_shared
      procedure :: put
      procedure :: put_profiles
      procedure :: put_counts
      procedure :: put_known_sums
      procedure :: make_safe
      procedure :: note_states
      procedure :: close_all
   end type results_writer_t

contains

   !> Open the file that is there, with its datasets.
   subroutine open_found(self, error)
      !> The closed file of the name `path_now`, which is open afterwards.
      class(results_writer_t), intent(inout) :: self
      type(error_t), allocatable, intent(out) :: error

      call check_state(self%state, [is_closed], 'open_found', error)
      if (allocated(error)) return
      self%state = is_open
      call open_with_datasets(self, error)
   end subroutine open_found

   !> Open the file together with all other processes. From now on each writes its results where it likes and when it likes.
   !> Nothing but values changes in the file, so that a process that dies cannot harm it.
   subroutine open_shared(self, access, error)
      !> The closed file, which is shared afterwards, also after an error.
      class(results_writer_t), intent(inout) :: self
      !> How all processes open the file together: an access list of HDF5.
      integer(hid_t), intent(in) :: access
      type(error_t), allocatable, intent(out) :: error

      call check_state(self%state, [is_closed], 'open_shared', error)
      if (allocated(error)) return
      self%state = is_shared
      ! cores are given to processes, and MPI may allow no thread but the one that asks for blocks
      self%has_own_thread = .false.
      self%safe_at = wall_clock()
      call open_with_datasets(self, error, access)
   end subroutine open_shared

   !> Open the file that is there, with its datasets.
   subroutine open_with_datasets(self, error, access)
      !> The file of the name `path_now`, which is open for writing afterwards.
      class(results_writer_t), intent(inout) :: self
      type(error_t), allocatable, intent(out) :: error
      !> How several processes open the file together, see `open_file`; if absent this one opens it alone.
      integer(hid_t), intent(in), optional :: access
      type(hdf5_calls_t) :: calls

      call open_file(calls, self%path_now, .true., self%file, access)
      call self%datasets%open(calls, self%file, self%layout)
      call calls%get_error(self%path_now//': cannot open', error)
   end subroutine open_with_datasets

   !> Bring everything to the disk, and close the file together with all other processes.
   subroutine close_shared(self, error)
      !> The shared file, which is closed afterwards, even after an error.
      class(results_writer_t), intent(inout) :: self
      !> An error of the run, which is kept if it is allocated; else what goes wrong here, if anything.
      type(error_t), allocatable, intent(inout) :: error
      type(error_t), allocatable :: another
      type(hdf5_calls_t) :: calls

      call check_state(self%state, [is_shared], 'close_shared', another)
      if (.not. allocated(another)) then
         ! what was written before an error may still be saved
         if (self%file /= no_id) call self%make_safe(another)
         call self%close_all(calls)
         if (.not. allocated(another)) call calls%get_error(self%path//': cannot write', another)
         self%state = is_closed
      end if
      if (.not. allocated(error)) call move_alloc(another, error)
   end subroutine close_shared

   !> Write the results of a row of points.
   subroutine put(self, first, results, error_estimate, status, counts, error)
      !> The open file; its checksums and the log of states follow the results.
      class(results_writer_t), intent(inout) :: self
      !> Number of the first point in the run, from 1; the first one of a block.
      integer(i8), intent(in) :: first
      !> Results in the units of the model, shape `(n_points, n_results)`.
      real(dp), intent(in) :: results(:, :)
      !> Estimated relative error of each point [-].
      real(dp), intent(in) :: error_estimate(:)
      !> Status of each point, one of `status_...`.
      integer, intent(in) :: status(:)
      real(dp), intent(in) :: counts(:, :)
      type(error_t), allocatable, intent(out) :: error
      type(hdf5_calls_t) :: calls
      integer(i8) :: row
      real(dp) :: waiting

      call check_state(self%state, [is_open, is_shared], 'put', error)
      if (.not. (allocated(error) .or. self%log%has_space(size(status)))) call self%make_safe(error)
      if (allocated(error)) return
      call calls%silence()
      row = self%layout%row_of(first)
      call self%datasets%write_results(calls, self%layout, row, results, error_estimate)
      call calls%get_error(self%path//': cannot write', error)
      if (.not. allocated(error)) call self%put_counts(first, counts, error)
      if (.not. allocated(error) .and. self%is_resumed) call clear_profiles(self, row, status, error)
      if (.not. allocated(error)) call put_sums(self, first, results, error_estimate, status, counts, error)
      if (allocated(error)) return
      call self%log%add(row, status)
      call begin_to_bring(self, size(results))
      waiting = wall_clock() - self%safe_at
      if (waiting > max(least_interval, interval_by_duration*self%safe_took)) call self%make_safe(error)
   end subroutine put

   !> Write what the model counted in a row of blocks.
   subroutine put_counts(self, first, counts, error)
      class(results_writer_t), intent(inout) :: self
      integer(i8), intent(in) :: first
      real(dp), intent(in) :: counts(:, :)
      type(error_t), allocatable, intent(out) :: error
      type(hdf5_calls_t) :: calls

      call self%datasets%write_counts(calls, (self%layout%row_of(first) - 1)/self%layout%blocks%size + 1, counts)
      call calls%get_error(self%path//': cannot write', error)
   end subroutine put_counts

   !> Points that are not solved have no profiles. In a file that was found something else may stand there.
   subroutine clear_profiles(self, row, status, error)
      !> The open file, which this run found when it began.
      class(results_writer_t), intent(inout) :: self
      !> Index of the first point in the file, from 1.
      integer(i8), intent(in) :: row
      !> Status of the points from there on; those that are not solved get NaN.
      integer, intent(in) :: status(:)
      type(error_t), allocatable, intent(out) :: error
      type(hdf5_calls_t) :: calls
      real(dp), allocatable :: nothing(:, :, :)
      integer :: i

      if (size(self%layout%profiles) == 0) return
      allocate (nothing(product(self%layout%profile_shape()), 1, size(self%layout%profiles)), source=not_a_number())
      do i = 1, size(status)
         if (status(i) /= status_solved) call self%datasets%write_profiles(calls, self%layout, row + i - 1, nothing)
      end do
      call calls%get_error(self%path//': cannot write', error)
   end subroutine clear_profiles

   !> Write the checksums of a row of blocks.
   subroutine put_sums(self, first, results, error_estimate, status, counts, error)
      !> The open file; the sums of the profiles of these blocks are taken from it.
      class(results_writer_t), intent(inout) :: self
      integer(i8), intent(in) :: first
      real(dp), intent(in) :: results(:, :), error_estimate(:)
      integer, intent(in) :: status(:)
      real(dp), intent(in) :: counts(:, :)
      type(error_t), allocatable, intent(out) :: error
      integer(i8) :: sums(size(counts, 1)), block, profile_sum
      integer :: i, start, end

      do i = 1, size(sums)
         start = (i - 1)*self%layout%blocks%size + 1
         end = min(i*self%layout%blocks%size, size(status))
         block = (first - 1)/self%layout%blocks%size + i
         call self%profile_sums%take(block, profile_sum)
         sums(i) = sum_of_block(self%layout, block, results(start:end, :), error_estimate(start:end), status(start:end), &
            counts(i, :), profile_sum)
      end do
      self%sums = sums
      call self%put_known_sums(first, sums, error)
   end subroutine put_sums

   !> Write checksums of a row of blocks that are known.
   subroutine put_known_sums(self, first, sums, error)
      class(results_writer_t), intent(inout) :: self
      integer(i8), intent(in) :: first
      !> Checksum of each block, from the block of that point on.
      integer(i8), intent(in), contiguous :: sums(:)
      type(error_t), allocatable, intent(out) :: error
      type(hdf5_calls_t) :: calls

      call self%datasets%sums%write(calls, (self%layout%row_of(first) - 1)/self%layout%blocks%size + 1, sums)
      call calls%get_error(self%path//': cannot write', error)
   end subroutine put_known_sums

   !> Write the profiles of a point.
   subroutine put_profiles(self, point, profiles, error)
      !> The open file; the checksum of the profiles is kept until the block is put.
      class(results_writer_t), intent(inout) :: self
      !> Number of the point in the run, from 1.
      integer(i8), intent(in) :: point
      real(dp), intent(in) :: profiles(:, :, :)
      type(error_t), allocatable, intent(out) :: error
      type(hdf5_calls_t) :: calls

      call check_state(self%state, [is_open, is_shared], 'put_profiles', error)
      if (allocated(error)) return
      call calls%silence()
      call self%datasets%write_profiles(calls, self%layout, self%layout%row_of(point), profiles)
      call self%profile_sums%add((point - 1)/self%layout%blocks%size + 1, sum_of_profiles(point, profiles))
      call calls%get_error(self%path//': cannot write', error)
      call begin_to_bring(self, size(profiles))
   end subroutine put_profiles

   !> From time to time ask the system to begin to bring to the disk what has been written.
   subroutine begin_to_bring(self, n_numbers)
      !> The file, whose count of numbers begins anew when the system has been asked.
      class(results_writer_t), intent(inout) :: self
      !> How many numbers have been written since the last call.
      integer, intent(in) :: n_numbers

      self%n_numbers = self%n_numbers + n_numbers
      if (self%n_numbers < many) return
      call begin_to_synchronise(self%path_now)
      self%n_numbers = 0
   end subroutine begin_to_bring

   !> Bring the results so far to the disk, and then say that they are there.
   subroutine make_safe(self, error)
      !> The open file; the log of states is empty afterwards.
      class(results_writer_t), intent(inout) :: self
      type(error_t), allocatable, intent(out) :: error
      type(hdf5_calls_t) :: calls
      real(dp) :: start
      integer :: i, done

      start = wall_clock()
      call calls%silence()
      if (self%log%n_points > 0) then
         call flush_own(calls, self)
         call calls%get_error(self%path//': cannot write', error)
         if (.not. allocated(error)) call synchronise(self%path_now, error)
         if (allocated(error)) return
         call self%note_states()
         done = 0
         do i = 1, self%log%n_rows
            associate (n => self%log%count(i))
               call self%datasets%write_status(calls, self%layout, self%log%first(i), self%log%states(done + 1:done + n))
               done = done + n
            end associate
         end do
      end if
      call flush_own(calls, self)
      call calls%get_error(self%path//': cannot write', error)
      if (allocated(error)) return
      call self%log%clear()
      self%safe_at = wall_clock()
      self%safe_took = self%safe_at - start
   end subroutine make_safe

   !> From now on there may be states in the file: it is of use, however the program ends.
   subroutine note_states(self)
      class(results_writer_t), intent(inout) :: self

      if (self%has_states) return
      self%has_states = .true.
      call note_kept(self%path_now)
      call forget_leftover(self%path_now)
   end subroutine note_states

   !> Hand everything written so far to the operating system. What is written into a shared file is there already: HDF5
   !> keeps back nothing of contiguous datasets that are written by MPI, and to flush them would take all processes.
   subroutine flush_own(calls, self)
      type(hdf5_calls_t), intent(inout) :: calls
      !> The file; one that several processes share is left alone.
      class(results_writer_t), intent(inout) :: self

      if (self%state /= is_shared) call flush_file(calls, self%file)
   end subroutine flush_own

   !> Close every id.
   subroutine close_all(self, calls)
      class(results_writer_t), intent(inout) :: self
      !> Chain of HDF5 calls; the ids are closed even where one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls

      call self%datasets%close(calls)
      call close_file(calls, self%file)
   end subroutine close_all

end module adfric_output_results_writer
