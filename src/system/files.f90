! SPDX-License-Identifier: GPL-3.0-or-later
!> What neither Fortran nor HDF5 says about files, with the bindings of `files.c`.
module adfric_system_files
   use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int, c_int64_t, c_null_char, c_size_t
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t, set_error, file_failure
   implicit none (type, external)
   private
   public :: kind_of_path, path_free, path_file, path_other
   public :: target_of
   public :: file_id_t, id_of_file, is_same
   public :: folder_of, path_from, free_space, utc_time
   public :: error_text
   public :: lock_t, take_lock, is_locked
   public :: move_file, rename_file, remove_file, synchronise, begin_to_synchronise, ignore_file_size_signal

   !> What can stand at a path: nothing, a regular file, anything else.
   integer, parameter :: path_free = 0, path_file = 1, path_other = 2
   !> Space for a text that C gives back, and for a path.
   integer, parameter :: text_length = 256, path_length = 4096

   !> Identity of a file, whatever its names.
   type :: file_id_t
      private
      !> Device and inode; 0 for no file.
      integer(c_int64_t) :: numbers(2) = 0
   end type file_id_t

   !> A lock that keeps other runs, on this machine or on others that share the folder, from the same files.
   type :: lock_t
      private
      !> Path of the lock's file.
      character(:), allocatable :: path
      !> Number of the open file; -1 where nothing is locked.
      integer(c_int) :: number = -1
   contains
      procedure :: release
   end type lock_t

   interface

      integer(c_int) function c_kind_of_path(path) bind(c, name='adfric_kind_of_path')
         import :: c_char, c_int
         implicit none (type, external)
         !> Path, with a null character at its end.
         character(kind=c_char), intent(in) :: path(*)
      end function c_kind_of_path

      integer(c_int) function c_follow_link(path, text, size) bind(c, name='adfric_follow_link')
         import :: c_char, c_int, c_size_t
         implicit none (type, external)
         !> Path of the link, with a null character at its end.
         character(kind=c_char), intent(in) :: path(*)
         !> Where the link leads to, with a null character at its end.
         character(kind=c_char), intent(out) :: text(*)
         !> Space in `text` [bytes].
         integer(c_size_t), intent(in), value :: size
      end function c_follow_link

      subroutine c_identify(path, id) bind(c, name='adfric_identify')
         import :: c_char, c_int64_t
         implicit none (type, external)
         !> Path, with a null character at its end.
         character(kind=c_char), intent(in) :: path(*)
         !> Device and inode; zeros if there is nothing.
         integer(c_int64_t), intent(out) :: id(2)
      end subroutine c_identify

      integer(c_int) function c_is_locked(path) bind(c, name='adfric_is_locked')
         import :: c_char, c_int
         implicit none (type, external)
         !> Path of the lock's file, with a null character at its end.
         character(kind=c_char), intent(in) :: path(*)
      end function c_is_locked

      integer(c_int) function c_take_lock(path, lock) bind(c, name='adfric_take_lock')
         import :: c_char, c_int
         implicit none (type, external)
         !> Path of the lock's file, with a null character at its end.
         character(kind=c_char), intent(in) :: path(*)
         !> Number of the open file; -1 if no lock was taken.
         integer(c_int), intent(out) :: lock
      end function c_take_lock

      subroutine c_release_lock(path, lock) bind(c, name='adfric_release_lock')
         import :: c_char, c_int
         implicit none (type, external)
         !> Path of the lock's file, with a null character at its end.
         character(kind=c_char), intent(in) :: path(*)
         !> Number of the open file; negative: nothing is done.
         integer(c_int), intent(in), value :: lock
      end subroutine c_release_lock

      integer(c_int) function c_path_from(folder, path, text, size) bind(c, name='adfric_path_from')
         import :: c_char, c_int, c_size_t
         implicit none (type, external)
         !> Folder from which the file is seen, with a null character at its end.
         character(kind=c_char), intent(in) :: folder(*)
         !> Path of the file, with a null character at its end.
         character(kind=c_char), intent(in) :: path(*)
         !> Path as seen from the folder, with a null character at its end.
         character(kind=c_char), intent(out) :: text(*)
         !> Space in `text` [bytes].
         integer(c_size_t), intent(in), value :: size
      end function c_path_from

      integer(c_int) function c_synchronise(path) bind(c, name='adfric_synchronise')
         import :: c_char, c_int
         implicit none (type, external)
         !> Path, with a null character at its end.
         character(kind=c_char), intent(in) :: path(*)
      end function c_synchronise

      subroutine c_begin_to_synchronise(path) bind(c, name='adfric_begin_to_synchronise')
         import :: c_char
         implicit none (type, external)
         !> Path, with a null character at its end.
         character(kind=c_char), intent(in) :: path(*)
      end subroutine c_begin_to_synchronise

      real(c_double) function c_free_space(folder) bind(c, name='adfric_free_space')
         import :: c_char, c_double
         implicit none (type, external)
         !> Path of the folder, with a null character at its end.
         character(kind=c_char), intent(in) :: folder(*)
      end function c_free_space

      integer(c_int) function c_move_file(from, to, overwrite) bind(c, name='adfric_move_file')
         import :: c_char, c_int
         implicit none (type, external)
         !> Former name, with a null character at its end.
         character(kind=c_char), intent(in) :: from(*)
         !> New name, with a null character at its end.
         character(kind=c_char), intent(in) :: to(*)
         !> 1 if a file of the new name may be replaced, else 0.
         integer(c_int), intent(in), value :: overwrite
      end function c_move_file

      integer(c_int) function c_rename_file(from, to) bind(c, name='adfric_rename_file')
         import :: c_char, c_int
         implicit none (type, external)
         !> Former name, with a null character at its end.
         character(kind=c_char), intent(in) :: from(*)
         !> New name, with a null character at its end.
         character(kind=c_char), intent(in) :: to(*)
      end function c_rename_file

      integer(c_int) function c_remove_file(path) bind(c, name='adfric_remove_file')
         import :: c_char, c_int
         implicit none (type, external)
         !> Path, with a null character at its end.
         character(kind=c_char), intent(in) :: path(*)
      end function c_remove_file

      subroutine c_error_text(number, text, size) bind(c, name='adfric_error_text')
         import :: c_char, c_int, c_size_t
         implicit none (type, external)
         !> Error number of the system.
         integer(c_int), intent(in), value :: number
         !> What the number means, with a null character at its end.
         character(kind=c_char), intent(out) :: text(*)
         !> Space in `text` [bytes].
         integer(c_size_t), intent(in), value :: size
      end subroutine c_error_text

      subroutine c_utc_time(text, size) bind(c, name='adfric_utc_time')
         import :: c_char, c_size_t
         implicit none (type, external)
         !> The time, with a null character at its end.
         character(kind=c_char), intent(out) :: text(*)
         !> Space in `text` [bytes].
         integer(c_size_t), intent(in), value :: size
      end subroutine c_utc_time

      !> Make a write over the limit of the file size an error that can be reported.
      subroutine ignore_file_size_signal() bind(c, name='adfric_ignore_file_size_signal')
         implicit none (type, external)
      end subroutine ignore_file_size_signal

   end interface

contains

   !> One of `path_...`.
   integer function kind_of_path(path)
      !> Path, by whatever name; links are followed.
      character(*), intent(in) :: path

      kind_of_path = int(c_kind_of_path(path//c_null_char))
   end function kind_of_path

   !> The file that a name stands for: where it leads to if it is a link, so that the link stays; else itself.
   function target_of(path) result(target)
      !> Name of the file; nothing need stand there.
      character(*), intent(in) :: path
      character(:), allocatable :: target
      character(kind=c_char) :: buffer(path_length)

      target = path
      buffer = c_null_char
      if (c_follow_link(path//c_null_char, buffer, size(buffer, kind=c_size_t)) == 0) target = text_of(buffer)
   end function target_of

   !> Which file stands at a path.
   function id_of_file(path) result(id)
      !> Path, by whatever name; links are followed.
      character(*), intent(in) :: path
      type(file_id_t) :: id

      call c_identify(path//c_null_char, id%numbers)
   end function id_of_file

   !> Are these the same file? Two that do not exist are not.
   elemental logical function is_same(one, other)
      !> Files as `id_of_file` gives them.
      type(file_id_t), intent(in) :: one, other

      is_same = all(one%numbers == other%numbers) .and. any(one%numbers /= 0)
   end function is_same

   !> Folder of a file.
   pure function folder_of(path) result(folder)
      !> Name of the file, with or without its folder.
      character(*), intent(in) :: path
      character(:), allocatable :: folder
      integer :: slash

      slash = index(path, '/', back=.true.)
      if (slash == 0) then
         folder = '.'
      else if (slash == 1) then
         folder = '/'
      else
         folder = path(:slash - 1)
      end if
   end function folder_of

   !> Path of a file as seen from a folder: relative if the file is in it or below it, else absolute.
   subroutine path_from(folder, path, text, error)
      !> Folder from which the file is seen; it must exist.
      character(*), intent(in) :: folder
      !> Name of the file; it must exist.
      character(*), intent(in) :: path
      !> Path of the file as seen from the folder.
      character(:), allocatable, intent(out) :: text
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      character(kind=c_char) :: buffer(path_length)
      integer(c_int) :: number

      buffer = c_null_char
      number = c_path_from(folder//c_null_char, path//c_null_char, buffer, size(buffer, kind=c_size_t))
      text = text_of(buffer)
      if (number /= 0) call set_error(error, file_failure, path//': cannot find this file: '//error_text(number))
   end subroutine path_from

   !> Take a lock.
   subroutine take_lock(path, lock, is_locked_by_others, error)
      !> Name of the file that stands for the lock; it is removed with the lock.
      character(*), intent(in) :: path
      !> Receives the lock; where the file system knows no locks it protects nothing.
      type(lock_t), intent(inout) :: lock
      !> Does another run hold the lock? Then it is not taken.
      logical, intent(out) :: is_locked_by_others
      !> Allocated if the file of the lock cannot be made.
      type(error_t), allocatable, intent(out) :: error
      integer(c_int) :: number

      lock%path = path
      number = c_take_lock(path//c_null_char, lock%number)
      is_locked_by_others = number < 0
      if (number > 0) call set_error(error, file_failure, error_text(number))
   end subroutine take_lock

   !> Give a lock back.
   subroutine release(self)
      !> The lock, which is not held afterwards; nothing is done if it was not held before.
      class(lock_t), intent(inout) :: self

      if (self%number >= 0) call c_release_lock(self%path//c_null_char, self%number)
      self%number = -1
   end subroutine release

   !> Does another run hold a lock?
   logical function is_locked(path)
      !> Name of the file that stands for the lock.
      character(*), intent(in) :: path

      is_locked = c_is_locked(path//c_null_char) /= 0
   end function is_locked

   !> Bytes that may still be written into a folder; huge if it cannot be said.
   real(dp) function free_space(folder)
      !> Path of the folder.
      character(*), intent(in) :: folder

      free_space = c_free_space(folder//c_null_char)
      if (free_space < 0) free_space = huge(1.0_dp)
   end function free_space

   !> The time now, as in `2025-01-31T13:45:00Z`.
   function utc_time() result(text)
      character(:), allocatable :: text
      character(kind=c_char) :: buffer(text_length)

      call c_utc_time(buffer, size(buffer, kind=c_size_t))
      text = text_of(buffer)
   end function utc_time

   !> Rename a file within its folder, in one step, without waiting for the disk.
   subroutine rename_file(from, to, error)
      !> Former name of the file.
      character(*), intent(in) :: from
      !> New name of the file; what stands there is replaced.
      character(*), intent(in) :: to
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      integer(c_int) :: number

      number = c_rename_file(from//c_null_char, to//c_null_char)
      if (number /= 0) call set_error(error, file_failure, &
         to//': cannot rename '//from//' to this name: '//error_text(number))
   end subroutine rename_file

   !> Rename a file within its folder, in one step, when it is safe on the disk.
   subroutine move_file(from, to, overwrite, error)
      !> Former name of the file.
      character(*), intent(in) :: from
      !> New name of the file.
      character(*), intent(in) :: to
      !> May a file of the new name be replaced?
      logical, intent(in) :: overwrite
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      integer(c_int) :: number

      number = c_move_file(from//c_null_char, to//c_null_char, merge(1_c_int, 0_c_int, overwrite))
      if (number /= 0) call set_error(error, file_failure, &
         to//': cannot rename '//from//' to this name: '//error_text(number))
   end subroutine move_file

   !> Bring a file to the disk itself.
   subroutine synchronise(path, error)
      !> Name of the file.
      character(*), intent(in) :: path
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      integer(c_int) :: number

      number = c_synchronise(path//c_null_char)
      if (number /= 0) call set_error(error, file_failure, path//': cannot bring to the disk: '//error_text(number))
   end subroutine synchronise

   !> Begin to bring a file to the disk, without waiting, so that less is left to wait for in the end.
   subroutine begin_to_synchronise(path)
      !> Name of the file.
      character(*), intent(in) :: path

      call c_begin_to_synchronise(path//c_null_char)
   end subroutine begin_to_synchronise

   !> Remove a file.
   subroutine remove_file(path, error)
      !> Name of the file.
      character(*), intent(in) :: path
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      integer(c_int) :: number

      number = c_remove_file(path//c_null_char)
      if (number /= 0) call set_error(error, file_failure, path//': cannot remove: '//error_text(number))
   end subroutine remove_file

   !> What an error number of the system means.
   function error_text(number) result(text)
      !> Error number of the system.
      integer(c_int), intent(in) :: number
      character(:), allocatable :: text
      character(kind=c_char) :: buffer(text_length)

      call c_error_text(number, buffer, size(buffer, kind=c_size_t))
      text = text_of(buffer)
   end function error_text

   !> A text of C up to its null character.
   pure function text_of(buffer) result(text)
      !> Text with a null character at its end; without one the whole of it is taken.
      character(kind=c_char), intent(in) :: buffer(:)
      character(:), allocatable :: text
      integer :: i

      text = ''
      do i = 1, size(buffer)
         if (buffer(i) == c_null_char) return
         text = text//buffer(i)
      end do
   end function text_of

end module adfric_system_files
