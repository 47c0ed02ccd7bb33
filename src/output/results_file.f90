!> The file with the results of a run, or of a part of it.
!>
!> It is written under other names beside the final one: `.new` until it has all its datasets, then `.partial`, by which
!> a run that was stopped goes on, and the final name when it is complete. A lock keeps other runs away.
module adfric_output_results_file
   use adfric_base_kinds, only: dp, i8
   use adfric_base_error, only: error_t, set_error, file_failure, input_failure
   use adfric_hdf5_calls, only: hdf5_calls_t, no_id
   use adfric_hdf5_file, only: create_file, flush_file
   use adfric_output_constants, only: add_derived_constants
   use adfric_output_done_points, only: read_done_points, is_readable
   use adfric_output_heading, only: heading_t, new_heading, write_heading
   use adfric_output_layout, only: layout_t, new_layout
   use adfric_output_means, only: write_placeholders, n_placeholders, write_seconds, write_means
   use adfric_output_names, only: check_output_name, check_partial_name, partial_name, new_name, lock_name, say_in_use
   use adfric_output_part_layout, only: write_part_layout
   use adfric_output_results_writer, only: results_writer_t
   use adfric_output_seal, only: seal_t
   use adfric_output_virtual_parts, only: virtual_parts_t
   use adfric_run_block_source, only: block_list_t
   use adfric_run_run, only: run_t
   use adfric_run_summary, only: run_summary_t
   use adfric_system_files, only: kind_of_path, path_free, file_id_t, id_of_file, is_same, lock_t, take_lock, &
      move_file, rename_file, remove_file, synchronise, ignore_file_size_signal
   use adfric_system_clock, only: wall_clock
   use adfric_system_leftovers, only: note_leftover, forget_leftover, note_kept, begin_making, end_making
   implicit none (type, external)
   private
   public :: results_file_t

   !> A results file that is being written.
   type, extends(results_writer_t) :: results_file_t
      private
      !> May a file of the final name be replaced?
      logical :: overwrite = .false.
      type(lock_t) :: lock
      !> Identity of the file that this run writes; others may put a file of theirs in its place.
      type(file_id_t) :: id
      !> Time that the run took before it was stopped [s].
      real(dp) :: seconds_before = 0
      !> What stands in the head of a file that has not been created yet.
      type(heading_t), allocatable :: heading
   contains
      procedure :: create
      procedure :: begin
      procedure :: prepare
      procedure :: create_from
      procedure :: resume
      procedure :: hand_over
      procedure :: join
      procedure :: finish
      procedure :: stop => stop_writing
      procedure :: abandon
      procedure :: discard
   end type results_file_t

contains

   !> Create the file of a run with every dataset in it.
   subroutine create(self, run, overwrite, error)
      !> The file, which is there and open afterwards, or nothing is.
      class(results_file_t), intent(inout) :: self
      !> The run, with the name of its file.
      class(run_t), intent(in) :: run
      !> May a file of this name, and results of a run that was stopped, be replaced?
      logical, intent(in) :: overwrite
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error

      call self%begin(run, overwrite, error)
      if (allocated(error)) return
      call self%prepare(error)
      if (allocated(error)) call self%discard()
   end subroutine create

   !> Take the name for a run, whose file is created before the first results come, by `prepare`.
   subroutine begin(self, run, overwrite, error)
      !> The file, which has its name and its lock afterwards.
      class(results_file_t), intent(inout) :: self
      !> The run, with the name of its file.
      class(run_t), intent(in) :: run
      !> May a file of this name, and results of a run that was stopped, be replaced?
      logical, intent(in) :: overwrite
      !> Allocated if the name cannot be had.
      type(error_t), allocatable, intent(out) :: error
      type(layout_t) :: layout

      call check_axes(run, error)
      if (allocated(error)) return
      call new_layout(layout, run)
      call check_partial_name(run%output, overwrite, error)
      if (.not. allocated(error)) call take_name(self, run%output, overwrite, layout, error)
      if (allocated(error)) return
      call add_derived_constants(run, self%layout%constants)
      allocate (self%heading)
      call new_heading(self%heading, run)
      self%path_now = new_name(self%path)
   end subroutine begin

   !> See `sink_t`: create the file of a run that has just begun. If that fails there is none.
   subroutine prepare(self, error)
      !> A file that has begun; it has the ending `.partial` afterwards. `error` is not allocated if all went well.
      class(results_file_t), intent(inout) :: self
      type(error_t), allocatable, intent(out) :: error

      if (.not. allocated(self%heading)) return
      call create_all(self, self%heading, error)
      deallocate (self%heading)
      ! some file systems give room no earlier than this; and where it never came, zeros would look like results
      if (.not. allocated(error)) call synchronise(self%path_now, error)
      ! nobody can have begun to write results in the meantime, since we have the lock
      if (allocated(error)) return
      ! it is of no use before there are results in it
      call note_leftover(partial_name(self%path))
      call rename_file(self%path_now, partial_name(self%path), error)
      if (allocated(error)) then
         call forget_leftover(partial_name(self%path))
         return
      end if
      self%path_now = partial_name(self%path)
      call forget_leftover(new_name(self%path))
   end subroutine prepare

   !> Create a file that is of no use until it is complete.
   subroutine create_from(self, path, overwrite, layout, heading, error, parts)
      !> `layout` and `heading` say what stands in the file that `self` makes; `error` is not allocated if all went well.
      class(results_file_t), intent(inout) :: self
      !> Final name of the results file.
      character(*), intent(in) :: path
      !> May a file of this name be replaced?
      logical, intent(in) :: overwrite
      type(layout_t), intent(in) :: layout
      type(heading_t), intent(in) :: heading
      type(error_t), allocatable, intent(out) :: error
      !> Files in which the values are; if absent the values come into this file.
      type(virtual_parts_t), intent(in), optional :: parts

      call take_name(self, path, overwrite, layout, error)
      if (allocated(error)) return
      self%path_now = new_name(path)
      call create_all(self, heading, error, parts)
      if (allocated(error)) call self%discard()
   end subroutine create_from

   !> Create every dataset.
   subroutine create_all(self, heading, error, parts)
      !> The arguments of `create_from`; `self` has its names and its layout already.
      class(results_file_t), intent(inout) :: self
      type(heading_t), intent(in) :: heading
      type(error_t), allocatable, intent(out) :: error
      type(virtual_parts_t), intent(in), optional :: parts
      type(hdf5_calls_t) :: calls
      type(seal_t) :: seal
      integer(i8), allocatable :: extents(:, :)

      if (kind_of_path(self%path_now) /= path_free) call remove_file(self%path_now, error)
      if (allocated(error)) return
      call begin_making()
      call note_leftover(self%path_now)
      call create_file(calls, self%path_now, self%file)
      call end_making()
      ! what a creation leaves that has failed half way is ours, too
      self%id = id_of_file(self%path_now)
      associate (layout => self%layout)
         call seal%create(calls, self%file, n_placeholders(layout) + size(layout%fields) + size(layout%profiles) &
            + size(layout%counts) + 1)
      end associate
      call write_heading(calls, self%file, heading)
      call write_placeholders(calls, self%file, self%layout)
      if (.not. self%layout%blocks%part%is_whole()) call write_part_layout(calls, self%file, self%layout)
      call self%datasets%create(calls, self%file, self%layout, parts)
      call flush_file(calls, self%file)
      call self%datasets%get_extents(calls, extents)
      call seal%write(calls, self%path_now, extents, n_placeholders(self%layout))
      call flush_file(calls, self%file)
      call calls%get_error(self%path//': cannot create', error)
      self%safe_at = wall_clock()
   end subroutine create_all

   !> Refuse a run with axes that have no form in the file.
   subroutine check_axes(run, error)
      !> The run, along each axis of which one variable should change.
      class(run_t), intent(in) :: run
      !> Not allocated if the run can be written.
      type(error_t), allocatable, intent(out) :: error

      if (run%plan%has_joint_axis()) call set_error(error, input_failure, &
         run%output//': cannot create: a results file has no form for variables that are swept together')
   end subroutine check_axes

   !> What every run does first: take the name.
   subroutine take_name(self, path, overwrite, layout, error)
      !> `self` has the lock, the final name and the `layout` afterwards; the other arguments are those of `begin`.
      class(results_file_t), intent(inout) :: self
      character(*), intent(in) :: path
      logical, intent(in) :: overwrite
      type(layout_t), intent(in) :: layout
      type(error_t), allocatable, intent(out) :: error
      logical :: is_in_use
      type(hdf5_calls_t) :: calls

      ! this thread closes what another one may have created
      call calls%open_library()
      call calls%get_error(path//': cannot create', error)
      if (.not. allocated(error)) call check_output_name(path, overwrite, error)
      if (allocated(error)) return
      call ignore_file_size_signal()
      call take_lock(lock_name(path), self%lock, is_in_use, error)
      if (is_in_use) call set_error(error, file_failure, say_in_use(path))
      if (allocated(error)) then
         if (.not. is_in_use) error%message = path//': cannot create: '//error%message
         return
      end if
      call note_leftover(lock_name(path))
      self%path = path
      self%overwrite = overwrite
      self%layout = layout
      self%safe_at = wall_clock()
   end subroutine take_name

   !> Go on with the file of a run that was stopped.
   subroutine resume(self, run, overwrite, list, summary, error)
      !> The file, which is open again afterwards if there is no error.
      class(results_file_t), intent(inout) :: self
      !> The run, with the name of its file; the file must belong to it.
      class(run_t), intent(in) :: run
      !> May a file of the final name be replaced?
      logical, intent(in) :: overwrite
      !> The blocks that are left.
      type(block_list_t), intent(out) :: list
      !> Summary of the points that are solved.
      type(run_summary_t), intent(out) :: summary
      !> Allocated if the file cannot be read, or is not that of the run.
      type(error_t), allocatable, intent(out) :: error
      type(layout_t) :: layout
      type(hdf5_calls_t) :: calls

      call new_layout(layout, run)
      call take_name(self, run%output, overwrite, layout, error)
      if (allocated(error)) return
      self%path_now = partial_name(self%path)
      self%is_resumed = .true.
      self%has_states = .true.
      call note_kept(self%path_now)
      call read_done_points(self%path_now, run, layout, list, summary, error)
      if (.not. allocated(error)) then
         self%seconds_before = summary%wall_seconds
         self%id = id_of_file(self%path_now)
         call self%open_found(error)
      end if
      if (.not. allocated(error)) return
      call self%close_all(calls)
      call end_name(self)
   end subroutine resume

   !> Close the file, for several processes to open it. This one keeps its lock and will complete it.
   subroutine hand_over(self, error)
      !> The file is created and open; closed afterwards. `error` is not allocated if all went well.
      class(results_file_t), intent(inout) :: self
      type(error_t), allocatable, intent(out) :: error
      type(hdf5_calls_t) :: calls

      call self%close_all(calls)
      call calls%get_error(self%path//': cannot write', error)
      ! the others may write into it from now on
      call self%note_states()
   end subroutine hand_over

   !> Take part in writing a file that another process has handed over.
   subroutine join(self, run)
      !> The file, which has its names afterwards, but no lock.
      class(results_file_t), intent(inout) :: self
      !> The run, with the name of its file; the same in all processes.
      class(run_t), intent(in) :: run

      call ignore_file_size_signal()
      self%path = run%output
      self%path_now = partial_name(self%path)
      ! the other process may have found it, damaged in places
      self%is_resumed = .true.
      call new_layout(self%layout, run)
   end subroutine join

   !> Complete the file and give it its name.
   subroutine finish(self, wall_seconds, error)
      !> The file with all results, which has its final name afterwards. If it cannot be completed, `error` says what is left.
      class(results_file_t), intent(inout) :: self
      !> Time that the run took since it began or was resumed [s].
      real(dp), intent(in) :: wall_seconds
      type(error_t), allocatable, intent(out) :: error

      call close_with_time(self, wall_seconds, .true., error)
      if (.not. allocated(error)) then
         if (is_same(self%id, id_of_file(self%path_now))) then
            call move_file(self%path_now, self%path, self%overwrite, error)
         else
            call set_error(error, file_failure, self%path//': the results are lost: '//self%path_now &
               //' has been removed or replaced while it was written')
         end if
      end if
      if (allocated(error)) then
         call self%abandon(error)
      else
         call end_name(self)
      end if
   end subroutine finish

   !> Leave the file, so that the run can go on another time.
   subroutine stop_writing(self, wall_seconds, error)
      !> The file, which keeps the ending `.partial`. If it cannot be closed, `error` says what is left.
      class(results_file_t), intent(inout) :: self
      !> Time that the run took since it began or was resumed [s].
      real(dp), intent(in) :: wall_seconds
      type(error_t), allocatable, intent(out) :: error

      call close_with_time(self, wall_seconds, .false., error)
      if (.not. allocated(error)) call synchronise(self%path_now, error)
      if (allocated(error)) then
         call self%abandon(error)
      else
         call end_name(self)
      end if
   end subroutine stop_writing

   !> Bring everything to the disk, say how long it took, and close the file.
   subroutine close_with_time(self, wall_seconds, is_complete, error)
      class(results_file_t), intent(inout) :: self
      !> The open file, which is closed afterwards; `error` is not allocated if all went well.
      !> Time that the run took since it began or was resumed [s].
      real(dp), intent(in) :: wall_seconds
      !> Are all points solved? Then the means over them are written, too.
      logical, intent(in) :: is_complete
      type(error_t), allocatable, intent(out) :: error
      type(hdf5_calls_t) :: calls

      call self%make_safe(error)
      if (allocated(error)) return
      if (is_complete) call write_means(calls, self%file, self%layout, self%datasets)
      call write_seconds(calls, self%file, self%seconds_before + wall_seconds)
      call self%close_all(calls)
      call calls%get_error(self%path//': cannot '//trim(merge('complete', 'write   ', is_complete)), error)
   end subroutine close_with_time

   !> Close the file after an error; the error says what is left of it.
   subroutine abandon(self, error)
      !> The file, whose name and lock are free afterwards.
      class(results_file_t), intent(inout) :: self
      !> Why the run ends here; what is left of the file is added to the message.
      type(error_t), intent(inout) :: error
      type(hdf5_calls_t) :: calls
      type(error_t), allocatable :: another

      if (self%path_now == new_name(self%path)) then
         call self%discard()
         return
      end if
      ! what was written before may still be saved
      if (self%file /= no_id) call self%make_safe(another)
      call self%close_all(calls)
      if (is_same(self%id, id_of_file(self%path_now))) then
         if (is_readable(self%path_now)) then
            error%message = error%message//'; the results so far stay in '//self%path_now//', --resume goes on with them'
         else
            error%message = error%message//'; no results could be kept, '//self%path_now//' cannot be read'
         end if
      end if
      call end_name(self)
   end subroutine abandon

   !> Close the file and remove what has been written by this run.
   subroutine discard(self)
      !> The file; one that this run found when it began is kept.
      class(results_file_t), intent(inout) :: self
      type(hdf5_calls_t) :: calls
      type(error_t), allocatable :: error

      call self%close_all(calls)
      ! a file that cannot be removed does no harm
      if (.not. self%is_resumed) then
         if (is_same(self%id, id_of_file(self%path_now))) call remove_file(self%path_now, error)
      end if
      call end_name(self)
   end subroutine discard

   !> Give the name back: nothing of this run is at work any more.
   subroutine end_name(self)
      !> The file, whose lock is released and whose names are no leftovers any more.
      class(results_file_t), intent(inout) :: self

      call forget_leftover(new_name(self%path))
      call forget_leftover(partial_name(self%path))
      call note_kept('')
      call self%lock%release()
      call forget_leftover(lock_name(self%path))
   end subroutine end_name

end module adfric_output_results_file
