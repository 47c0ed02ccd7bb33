! SPDX-License-Identifier: GPL-3.0-or-later
!> A file as a text, byte by byte: a regular file, or as an input also a pipe.
module adfric_input_whole_file
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_int64_t, c_null_char
   use adfric_base_error, only: error_t, set_error, input_failure, file_failure
   use adfric_base_kinds, only: i8
   use adfric_base_text, only: show_count, show_text
   use adfric_system_files, only: kind_of_path, path_free, error_text
   use adfric_system_file_bytes, only: size_of_file
   implicit none (type, external)
   private
   public :: read_whole_file

   !> Bytes of a MiB.
   integer, parameter :: mebibyte = 1024**2
   !> More than anybody writes: something else was given by mistake [bytes].
   integer, parameter :: largest_file = 100*mebibyte
   !> What `c_open` gives back for a device, a folder, and the like.
   integer(c_int), parameter :: c_is_irregular = -huge(1_c_int)
   !> Space at first for what has no known length [bytes].
   integer, parameter :: first_space = 65536

   !> See `file_bytes.c`.
   interface

      !> Open a file to read it; its number, `c_is_irregular`, or minus an error number of the system.
      integer(c_int) function c_open(path, takes_pipes) bind(c, name='adfric_open_to_read')
         import :: c_char, c_int
         implicit none (type, external)
         !> Name of the file, ends with a null character.
         character(kind=c_char), intent(in) :: path(*)
         !> 1 if a pipe may be opened, else 0.
         integer(c_int), intent(in), value :: takes_pipes
      end function c_open

      !> Read what comes next; the number of bytes, 0 at the end, or minus an error number of the system.
      integer(c_int64_t) function c_read(file, bytes, n) bind(c, name='adfric_read_next')
         import :: c_char, c_int, c_int64_t
         implicit none (type, external)
         !> Number of the open file.
         integer(c_int), intent(in), value :: file
         !> What is read.
         character(kind=c_char), intent(inout) :: bytes(*)
         !> Space in it [bytes].
         integer(c_int64_t), intent(in), value :: n
      end function c_read

      !> Close a file.
      subroutine c_close(file) bind(c, name='adfric_close_file')
         import :: c_int
         implicit none (type, external)
         !> Number of the open file.
         integer(c_int), intent(in), value :: file
      end subroutine c_close

   end interface

contains

   !> Read a file.
   subroutine read_whole_file(path, text, error, thing, largest)
      !> Name of the file, as the user gave it.
      character(*), intent(in) :: path
      !> All of its bytes.
      character(:), allocatable, intent(out) :: text
      !> It cannot be read, or is too large.
      type(error_t), allocatable, intent(out) :: error
      !> What the file should be, for messages; not present: an input. An input that cannot be read is a failure of the input,
      !> anything else one of files.
      character(*), intent(in), optional :: thing
      !> Size that it may have [bytes], less than 2**30; not present: that of an input.
      integer, intent(in), optional :: largest
      character(:), allocatable :: name
      integer(c_int) :: file, number
      integer :: space, limit, code

      name = 'input'
      code = input_failure
      if (present(thing)) then
         name = thing
         code = file_failure
      end if
      limit = largest_file
      if (present(largest)) limit = largest
      if (index(path, c_null_char) > 0) then
         call set_error(error, code, show_text(path)//': cannot open the '//name//', a null character stands in its name')
         return
      end if
      if (kind_of_path(path) == path_free) then
         call set_error(error, code, path//': cannot open the '//name//', there is no such file')
         return
      end if
      file = c_open(path//c_null_char, merge(0_c_int, 1_c_int, present(thing)))
      if (file == c_is_irregular) then
         call set_error(error, code, path//': cannot open the '//name//', this is no regular file')
         return
      else if (file < 0) then
         call set_error(error, code, path//': cannot open the '//name//', '//error_text(-file))
         return
      end if
      ! one byte more than there should be, to meet the end
      space = space_for(size_of_file(path), limit)
      allocate (character(space) :: text)
      call read_to_end(file, limit, text, number)
      call c_close(file)
      if (number /= 0) then
         call set_error(error, code, path//': cannot read the '//name//', '//error_text(number))
      else if (len(text) > limit) then
         call set_error(error, code, path//': cannot be '//trim(merge('an', 'a ', name == 'input'))//' '//name// &
            ', it is larger than '//show_count(limit/mebibyte)//' MiB')
      end if
   end subroutine read_whole_file

   !> Space for a file of such a size and one byte more [bytes], but no more than is read.
   pure integer function space_for(size, limit)
      !> [bytes]; less than 1 if it is not known.
      integer(i8), intent(in) :: size
      !> Size that the file may have [bytes].
      integer, intent(in) :: limit

      space_for = first_space
      if (size > 0) space_for = int(min(size, int(limit, i8))) + 1
   end function space_for

   !> Read to the end of a file, or one byte more than is allowed.
   subroutine read_to_end(file, limit, text, number)
      !> Number of the open file.
      integer(c_int), intent(in) :: file
      integer, intent(in) :: limit
      !> Space that grows as it is needed; then what has been read.
      character(:), allocatable, intent(inout) :: text
      !> 0 or an error number.
      integer(c_int), intent(out) :: number
      character(:), allocatable :: larger
      integer(c_int64_t) :: n_read
      integer :: n

      n = 0
      number = 0
      do
         if (n == len(text)) then
            if (n > limit) exit
            allocate (character(min(2*n, limit + 1)) :: larger)
            larger(:n) = text
            call move_alloc(larger, text)
         end if
         n_read = c_read(file, text(n + 1:len(text)), int(len(text) - n, c_int64_t))
         if (n_read < 0) number = int(-n_read, c_int)
         if (n_read <= 0) exit
         n = n + int(n_read)
      end do
      text = text(:n)
   end subroutine read_to_end

end module adfric_input_whole_file
