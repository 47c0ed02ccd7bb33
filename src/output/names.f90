! SPDX-License-Identifier: GPL-3.0-or-later
!> Names of a results file, and whether it may be written.
module adfric_output_names
   use adfric_base_error, only: error_t, set_error, file_failure
   use adfric_run_blocks, only: part_t
   use adfric_system_files, only: kind_of_path, path_free, path_file, file_id_t, id_of_file, &
      is_same, is_locked
   implicit none (type, external)
   private
   public :: partial_name, new_name, lock_name, part_name, check_output_name, check_partial_name, would_replace
   public :: say_in_use

   !> What is added to the name of a file that is not complete, of one that nothing has been written into yet, and of the
   !> file that says that a run is at work.
   character(*), parameter :: partial_ending = '.partial', new_ending = '.new', lock_ending = '.lock'
   !> How names of results files usually end.
   character(*), parameter :: usual_ending = '.h5'

contains

   !> Name of the file until it is complete; it can be read, and a run can go on with it.
   pure function partial_name(path) result(name)
      !> Name of the results file.
      character(*), intent(in) :: path
      character(:), allocatable :: name

      name = path//partial_ending
   end function partial_name

   !> Name of the file until it has all its datasets. Nobody needs what stands there when no run is at work.
   pure function new_name(path) result(name)
      character(*), intent(in) :: path
      character(:), allocatable :: name

      name = path//new_ending
   end function new_name

   !> Name of the lock of a results file.
   pure function lock_name(path) result(name)
      character(*), intent(in) :: path
      character(:), allocatable :: name

      name = path//lock_ending
   end function lock_name

   !> Name of the file of a part of a run: `NAME.part-0003-of-0016.h5`. That of the whole run is `path` itself.
   pure function part_name(path, part) result(name)
      !> Name of the results file of the whole run.
      character(*), intent(in) :: path
      !> Part of the run, or the whole run.
      type(part_t), intent(in) :: part
      character(:), allocatable :: name
      character(40) :: buffer
      integer :: n

      name = path
      if (part%is_whole()) return
      write (buffer, '(a, i0.4, a, i0.4)') '.part-', part%number, '-of-', part%of
      n = len(path) - len(usual_ending)
      if (n > 0) then
         if (path(n + 1:) == usual_ending .and. path(n:n) /= '/') name = path(:n)
      end if
      name = name//trim(buffer)//usual_ending
   end function part_name

   !> May a file of this name be written?
   subroutine check_output_name(path, overwrite, error, advice)
      !> Name of the results file.
      character(*), intent(in) :: path
      !> May a file of this name be replaced?
      logical, intent(in) :: overwrite
      !> Not allocated if the file may be written.
      type(error_t), allocatable, intent(out) :: error
      !> What else to do than to overwrite a file that exists; '--output writes another one' if absent.
      character(*), intent(in), optional :: advice

      select case (kind_of_path(path))
      case (path_free)
      case (path_file)
         if (.not. overwrite .and. present(advice)) then
            call set_error(error, file_failure, path//': this file exists; --force overwrites it, '//advice)
         else if (.not. overwrite) then
            call set_error(error, file_failure, path//': this file exists; --force overwrites it, --output writes another one')
         end if
      case default
         call set_error(error, file_failure, path//': cannot write: this is no regular file')
      end select
      if (allocated(error)) return
      if (is_locked(lock_name(path))) call set_error(error, file_failure, say_in_use(path))
   end subroutine check_output_name

   !> May a run start from its beginning, or would it lose the results of one that was stopped?
   subroutine check_partial_name(path, overwrite, error)
      !> Name of the results file.
      character(*), intent(in) :: path
      !> May results of a run that was stopped be replaced?
      logical, intent(in) :: overwrite
      !> Not allocated if nothing would be lost.
      type(error_t), allocatable, intent(out) :: error

      select case (kind_of_path(partial_name(path)))
      case (path_free)
      case (path_file)
         if (.not. overwrite) call set_error(error, file_failure, path//': '//partial_name(path) &
            //' has results of a run that was stopped; --resume goes on with it, --force discards it')
      case default
         call set_error(error, file_failure, path//': cannot write '//partial_name(path)//': this is no regular file')
      end select
   end subroutine check_partial_name

   !> What is said when two runs want the same file.
   pure function say_in_use(path) result(text)
      character(*), intent(in) :: path
      character(:), allocatable :: text

      text = path//': another run is writing this file ('//lock_name(path)//' is in use)'
   end function say_in_use

   !> Would results of this name replace a file, by whatever name it is called?
   logical function would_replace(path, file)
      !> Name of the results file.
      character(*), intent(in) :: path
      !> Name of the other file.
      character(*), intent(in) :: file
      type(file_id_t) :: id, others(4)

      id = id_of_file(file)
      others = [id_of_file(path), id_of_file(partial_name(path)), id_of_file(new_name(path)), id_of_file(lock_name(path))]
      would_replace = path == file .or. any(is_same(id, others))
   end function would_replace

end module adfric_output_names
