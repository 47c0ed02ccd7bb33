! SPDX-License-Identifier: GPL-3.0-or-later
!> The claim of a run on the name of a results file: other runs are kept away by a lock.
module adfric_output_name_claim
   use adfric_base_error, only: error_t, set_error, file_failure
   use adfric_hdf5_calls, only: hdf5_calls_t
   use adfric_output_names, only: check_output_name, partial_name, new_name, lock_name, say_in_use
   use adfric_system_files, only: lock_t, take_lock, ignore_file_size_signal
   use adfric_system_leftovers, only: note_leftover, forget_leftover, note_kept
   implicit none (type, external)
   private
   public :: claim_name, release_name

contains

   !> Take the name and its lock.
   subroutine claim_name(path, overwrite, lock, error)
      !> Final name of the results file.
      character(*), intent(in) :: path
      !> May a file of this name be replaced?
      logical, intent(in) :: overwrite
      type(lock_t), intent(out) :: lock
      !> Allocated if the name cannot be had.
      type(error_t), allocatable, intent(out) :: error
      logical :: is_in_use
      type(hdf5_calls_t) :: calls

      ! this thread closes what another one may have created
      call calls%open_library()
      call calls%get_error(path//': cannot create', error)
      if (.not. allocated(error)) call check_output_name(path, overwrite, error)
      if (allocated(error)) return
      call ignore_file_size_signal()
      call take_lock(lock_name(path), lock, is_in_use, error)
      if (is_in_use) call set_error(error, file_failure, say_in_use(path))
      if (allocated(error)) then
         if (.not. is_in_use) error%message = path//': cannot create: '//error%message
         return
      end if
      call note_leftover(lock_name(path))
   end subroutine claim_name

   !> Give the name back: nothing of this run is at work any more.
   subroutine release_name(path, lock)
      !> Final name of the results file; none of its other names is a leftover any more.
      character(*), intent(in) :: path
      type(lock_t), intent(inout) :: lock

      call forget_leftover(new_name(path))
      call forget_leftover(partial_name(path))
      call note_kept('')
      call lock%release()
      call forget_leftover(lock_name(path))
   end subroutine release_name

end module adfric_output_name_claim
