! SPDX-License-Identifier: GPL-3.0-or-later
!> The file with the results of a run, or of a part of it: its life.
!>
!> The file has other names beside the final one, NAME.h5: `.new` until it has all its datasets, then `.partial`, by which a
!> run that was stopped goes on, and the final name when it is complete. A lock, NAME.h5.lock, keeps other runs away.
!>
!>                 begin      +------+  join (a process that has no lock)
!>            +---------------| idle |---------------------------+
!>            |               +------+                           |
!>            v                  |                               |
!>        +-------+              | create (begin and prepare)    |
!>        | begun | .new         | resume (found as .partial)    |
!>        +-------+              | create_from (stays .new)      |
!>            |                  v                               v
!>            |  prepare      +------+   hand_over          +--------+
!>            +-------------->| open |--------------------->| closed | .partial
!>                            +------+<---------------------+--------+
!>                   .partial    |       open_found          |      ^
!>                               |               open_shared v      | close_shared
!>                               |                          +--------+
!>                               |                          | shared | .partial
!>                               |                          +--------+
!>                               +---> idle
!>                                     by finish, with the final name, or stop, as .partial
!>
!> An error leads from everywhere to idle: `abandon` keeps the results so far, `discard` keeps nothing of this run. A step
!> that does not go out from the state of the file is a mistake of the program, and an error. Results are put where the
!> state is open or shared.
module adfric_output_results_file
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t, set_error, file_failure
   use adfric_hdf5_calls, only: hdf5_calls_t, no_id
   use adfric_output_constants, only: add_derived_constants
   use adfric_output_done_points, only: read_done_points, is_readable
   use adfric_output_file_creation, only: create_all
   use adfric_output_file_state, only: is_idle, is_begun, is_open, is_closed, is_shared, check_state
   use adfric_output_heading, only: heading_t, new_heading
   use adfric_output_layout, only: layout_t, new_layout
   use adfric_output_means, only: write_seconds, write_means
   use adfric_output_name_claim, only: claim_name, release_name
   use adfric_output_names, only: check_partial_name, partial_name, new_name
   use adfric_output_results_writer, only: results_writer_t
   use adfric_output_virtual_parts, only: virtual_parts_t
   use adfric_run_block_source, only: block_list_t
   use adfric_run_run, only: run_t
   use adfric_run_summary, only: run_summary_t
   use adfric_system_files, only: id_of_file, is_same, lock_t, move_file, rename_file, remove_file, synchronise, &
      ignore_file_size_signal
   use adfric_system_clock, only: wall_clock
   use adfric_system_leftovers, only: note_leftover, forget_leftover, note_kept
   implicit none (type, external)
   private
   public :: results_file_t

   !> A results file that is being written.
   type, extends(results_writer_t) :: results_file_t
      private
      !> May a file of the final name be replaced?
      logical :: overwrite = .false.
      !> The lock of the name; not held in a process that has joined.
      type(lock_t) :: lock
      !> Time that the run took before it was stopped [s].
      real(dp) :: seconds_before = 0
      !> Texts at the root of a file that has begun.
      type(heading_t) :: heading
   contains
      procedure :: begin
      procedure :: prepare
      procedure :: create
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

   !> Take the name for a run, whose file is created before the first results come, by `prepare`.
   subroutine begin(self, run, overwrite, error)
      !> The file, which is begun afterwards: it has its name and its lock.
      class(results_file_t), intent(inout) :: self
      !> The run, with the name of its file.
      class(run_t), intent(in) :: run
      !> May a file of this name, and results of a run that was stopped, be replaced?
      logical, intent(in) :: overwrite
      !> Allocated if the name cannot be had.
      type(error_t), allocatable, intent(out) :: error
      type(layout_t) :: layout

      call check_state(self%state, [is_idle], 'begin', error)
      if (allocated(error)) return
      call new_layout(layout, run)
      call check_partial_name(run%output, overwrite, error)
      if (.not. allocated(error)) call take_name(self, run%output, overwrite, layout, error)
      if (allocated(error)) return
      call add_derived_constants(run, self%layout%constants)
      call run%model%get_extras(self%layout%extras)
      call new_heading(self%heading, run)
      self%path_now = new_name(self%path)
      self%state = is_begun
   end subroutine begin

   !> See `sink_t`: create the file of a run that has just begun. If that fails there is none.
   subroutine prepare(self, error)
      class(results_file_t), intent(inout) :: self
      type(error_t), allocatable, intent(out) :: error

      call check_state(self%state, [is_begun, is_open, is_shared], 'prepare', error)
      if (allocated(error) .or. self%state /= is_begun) return
      call create_all(self, self%heading, error)
      ! some file systems give space no earlier than this; and where it never came, zeros would look like results
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
      self%state = is_open
      call forget_leftover(new_name(self%path))
   end subroutine prepare

   !> Create the file of a run with every dataset in it.
   subroutine create(self, run, overwrite, error)
      !> The file, which is open afterwards, or idle after an error.
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

   !> Create a file that is of no use until it is complete.
   subroutine create_from(self, path, overwrite, layout, heading, error, parts)
      !> The file, which is open afterwards, or idle after an error.
      class(results_file_t), intent(inout) :: self
      !> Final name of the results file.
      character(*), intent(in) :: path
      !> May a file of this name be replaced?
      logical, intent(in) :: overwrite
      !> Layout of the file: its datasets and its points.
      type(layout_t), intent(in) :: layout
      !> Texts at the root of the file.
      type(heading_t), intent(in) :: heading
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      !> Files in which the values are; if absent the values come into this file.
      type(virtual_parts_t), intent(in), optional :: parts

      call check_state(self%state, [is_idle], 'create_from', error)
      if (.not. allocated(error)) call take_name(self, path, overwrite, layout, error)
      if (allocated(error)) return
      self%path_now = new_name(path)
      self%state = is_begun
      call create_all(self, heading, error, parts)
      if (allocated(error)) then
         call self%discard()
      else
         self%state = is_open
      end if
   end subroutine create_from

   !> Go on with the file of a run that was stopped.
   subroutine resume(self, run, overwrite, list, summary, error)
      !> The file, which is open afterwards, or idle after an error.
      class(results_file_t), intent(inout) :: self
      !> The run, with the name of its file; the file must belong to it.
      class(run_t), intent(in) :: run
      !> May a file of the final name be replaced?
      logical, intent(in) :: overwrite
      !> The blocks that remain.
      type(block_list_t), intent(out) :: list
      !> Summary of the points that are solved.
      type(run_summary_t), intent(out) :: summary
      !> Allocated if the file cannot be read, or is not that of the run.
      type(error_t), allocatable, intent(out) :: error
      type(layout_t) :: layout
      type(hdf5_calls_t) :: calls

      call check_state(self%state, [is_idle], 'resume', error)
      if (allocated(error)) return
      call new_layout(layout, run)
      call take_name(self, run%output, overwrite, layout, error)
      if (allocated(error)) return
      self%path_now = partial_name(self%path)
      self%is_resumed = .true.
      self%has_states = .true.
      self%state = is_closed
      call note_kept(self%path_now)
      call read_done_points(self%path_now, run, layout, list, summary, error)
      if (.not. allocated(error)) then
         self%seconds_before = summary%wall_seconds
         self%id = id_of_file(self%path_now)
         call self%open_found(error)
      end if
      if (.not. allocated(error)) return
      call self%close_all(calls)
      call end_work(self)
   end subroutine resume

   !> What every run does first: take the name.
   subroutine take_name(self, path, overwrite, layout, error)
      !> The file, which has the lock, the final name and the layout afterwards.
      class(results_file_t), intent(inout) :: self
      !> Final name of the results file.
      character(*), intent(in) :: path
      !> May a file of this name be replaced?
      logical, intent(in) :: overwrite
      type(layout_t), intent(in) :: layout
      !> Allocated if the name cannot be had.
      type(error_t), allocatable, intent(out) :: error

      call claim_name(path, overwrite, self%lock, error)
      if (allocated(error)) return
      self%path = path
      self%overwrite = overwrite
      self%layout = layout
      self%safe_at = wall_clock()
   end subroutine take_name

   !> Close the file, for several processes to open it. This one keeps its lock and will complete it.
   subroutine hand_over(self, error)
      class(results_file_t), intent(inout) :: self
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      type(hdf5_calls_t) :: calls

      call check_state(self%state, [is_open], 'hand_over', error)
      if (allocated(error)) return
      call self%close_all(calls)
      call calls%get_error(self%path//': cannot write', error)
      self%state = is_closed
      ! the others may write into it from now on
      call self%note_states()
   end subroutine hand_over

   !> Take part in writing a file that another process has handed over.
   subroutine join(self, run, error)
      !> The idle file, which has its names afterwards, but no lock.
      class(results_file_t), intent(inout) :: self
      !> The run, with the name of its file; the same in all processes.
      class(run_t), intent(in) :: run
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error

      call check_state(self%state, [is_idle], 'join', error)
      if (allocated(error)) return
      call ignore_file_size_signal()
      self%path = run%output
      self%path_now = partial_name(self%path)
      ! the other process may have found it, damaged in indices
      self%is_resumed = .true.
      call new_layout(self%layout, run)
      self%state = is_closed
   end subroutine join

   !> Complete the file and give it its name.
   subroutine finish(self, wall_seconds, error)
      !> The open file with all results, which has its final name afterwards.
      class(results_file_t), intent(inout) :: self
      !> Time that the run took since it began or was resumed [s].
      real(dp), intent(in) :: wall_seconds
      !> Allocated if the file cannot be completed; it says what remains.
      type(error_t), allocatable, intent(out) :: error

      call check_state(self%state, [is_open], 'finish', error)
      if (allocated(error)) return
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
         call end_work(self)
      end if
   end subroutine finish

   !> Leave the file, so that the run can go on another time.
   subroutine stop_writing(self, wall_seconds, error)
      class(results_file_t), intent(inout) :: self
      !> Time that the run took since it began or was resumed [s].
      real(dp), intent(in) :: wall_seconds
      !> Allocated if the file cannot be closed; it says what remains.
      type(error_t), allocatable, intent(out) :: error

      call check_state(self%state, [is_open], 'stop', error)
      if (allocated(error)) return
      call close_with_time(self, wall_seconds, .false., error)
      if (.not. allocated(error)) call synchronise(self%path_now, error)
      if (allocated(error)) then
         call self%abandon(error)
      else
         call end_work(self)
      end if
   end subroutine stop_writing

   !> Bring everything to the disk, say how long it took, and close the file.
   subroutine close_with_time(self, wall_seconds, is_complete, error)
      !> The open file, all ids of which are closed afterwards.
      class(results_file_t), intent(inout) :: self
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

   !> Close the file after an error; the error says what remains of it.
   subroutine abandon(self, error)
      class(results_file_t), intent(inout) :: self
      !> Why the run ends here; what remains of the file is added to the message.
      type(error_t), intent(inout) :: error
      type(hdf5_calls_t) :: calls
      type(error_t), allocatable :: another

      if (self%state == is_idle) return
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
      call end_work(self)
   end subroutine abandon

   !> Close the file and remove what has been written by this run.
   subroutine discard(self)
      !> The file in any state, which is idle afterwards; one that this run found when it began is kept.
      class(results_file_t), intent(inout) :: self
      type(hdf5_calls_t) :: calls
      type(error_t), allocatable :: error

      if (self%state == is_idle) return
      call self%close_all(calls)
      ! a file that cannot be removed does no harm
      if (.not. self%is_resumed) then
         if (is_same(self%id, id_of_file(self%path_now))) call remove_file(self%path_now, error)
      end if
      call end_work(self)
   end subroutine discard

   !> Nothing of this run is at work any more.
   subroutine end_work(self)
      !> The closed file, which is idle afterwards and has no lock.
      class(results_file_t), intent(inout) :: self

      call release_name(self%path, self%lock)
      self%state = is_idle
   end subroutine end_work

end module adfric_output_results_file
