! SPDX-License-Identifier: GPL-3.0-or-later
!> Bytes of a file as they stand on the disk: their checksum, and where something stands among them. Holes, which rise and do
!> not touch each other, are passed over; each has its first byte, from 0, and its number of bytes, shape `(2, n)`.
module adfric_system_file_bytes
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_int64_t, c_null_char
   use adfric_base_kinds, only: i8
   implicit none (type, external)
   private
   public :: size_of_file, sum_of_file, find_word, read_words, is_short

   !> What is given back for a file that ends too early, or is no regular file; positive: an error number of the system.
   integer, parameter :: is_short = -1

   interface

      !> Checksum of a file outside its holes; 0, `is_short` or an error number.
      integer(c_int) function c_sum_file(path, size, n_holes, holes, sum) bind(c, name='adfric_sum_file')
         import :: c_char, c_int, c_int64_t
         implicit none (type, external)
         !> Path, with a null character at its end.
         character(kind=c_char), intent(in) :: path(*)
         !> Number of bytes that are read, holes and all.
         integer(c_int64_t), intent(in), value :: size
         !> Number of holes.
         integer(c_int), intent(in), value :: n_holes
         !> First byte, from 0, and number of bytes of each hole.
         integer(c_int64_t), intent(in) :: holes(*)
         !> Checksum of the bytes outside the holes.
         integer(c_int64_t), intent(out) :: sum
      end function c_sum_file

      !> Look for eight bytes in a file outside its holes; 0, `is_short` or an error number.
      integer(c_int) function c_find_word(path, size, n_holes, holes, word, found_at, n_found) bind(c, name='adfric_find_word')
         import :: c_char, c_int, c_int64_t
         implicit none (type, external)
         !> Path, with a null character at its end.
         character(kind=c_char), intent(in) :: path(*)
         !> Number of bytes that are searched, holes and all.
         integer(c_int64_t), intent(in), value :: size
         !> Number of holes.
         integer(c_int), intent(in), value :: n_holes
         !> First byte, from 0, and number of bytes of each hole.
         integer(c_int64_t), intent(in) :: holes(*)
         !> The eight bytes that are looked for.
         integer(c_int64_t), intent(in) :: word
         !> First byte of the first position, from 0; 0 if there is none.
         integer(c_int64_t), intent(out) :: found_at
         !> Number of indices.
         integer(c_int), intent(out) :: n_found
      end function c_find_word

      !> Read words of eight bytes from a index of a file; 0, `is_short` or an error number.
      integer(c_int) function c_read_words(path, index, n, words) bind(c, name='adfric_read_words')
         import :: c_char, c_int, c_int64_t
         implicit none (type, external)
         !> Path, with a null character at its end.
         character(kind=c_char), intent(in) :: path(*)
         !> First byte that is read, from 0.
         integer(c_int64_t), intent(in), value :: index
         !> Number of words of eight bytes.
         integer(c_int64_t), intent(in), value :: n
         !> Receives the words.
         integer(c_int64_t), intent(inout) :: words(*)
      end function c_read_words

      !> Size of a file [bytes]; negative if it cannot be said.
      integer(c_int64_t) function c_size_of_file(path) bind(c, name='adfric_size_of_file')
         import :: c_char, c_int64_t
         implicit none (type, external)
         !> Path, with a null character at its end.
         character(kind=c_char), intent(in) :: path(*)
      end function c_size_of_file

   end interface

contains

   !> Size of a file [bytes]; negative if it cannot be said.
   integer(i8) function size_of_file(path)
      !> Name of the file.
      character(*), intent(in) :: path

      size_of_file = c_size_of_file(path//c_null_char)
   end function size_of_file

   !> Checksum of the first bytes of a file.
   subroutine sum_of_file(path, n_bytes, holes, sum, number)
      !> Name of the file.
      character(*), intent(in) :: path
      !> Number of bytes that are read, holes and all.
      integer(i8), intent(in) :: n_bytes
      !> First byte, from 0, and number of bytes of each hole, which rise; shape `(2, n)`.
      integer(i8), intent(in), contiguous :: holes(:, :)
      !> Checksum of the bytes outside the holes.
      integer(i8), intent(out) :: sum
      !> 0, `is_short`, or an error number of the system.
      integer, intent(out) :: number

      number = int(c_sum_file(path//c_null_char, n_bytes, int(size(holes, 2), c_int), holes, sum))
   end subroutine sum_of_file

   !> Find eight bytes among the first bytes of a file.
   subroutine find_word(path, n_bytes, holes, word, found_at, n_found, number)
      !> Name of the file.
      character(*), intent(in) :: path
      !> Number of bytes that are searched, holes and all.
      integer(i8), intent(in) :: n_bytes
      !> First byte, from 0, and number of bytes of each hole, which rise; shape `(2, n)`.
      integer(i8), intent(in), contiguous :: holes(:, :)
      !> The eight bytes that are looked for.
      integer(i8), intent(in) :: word
      !> First byte of the first position where they stand, from 0; 0 if there is none.
      integer(i8), intent(out) :: found_at
      !> Number of indices where they stand.
      integer, intent(out) :: n_found
      !> 0, `is_short`, or an error number of the system.
      integer, intent(out) :: number
      integer(c_int) :: n

      number = int(c_find_word(path//c_null_char, n_bytes, int(size(holes, 2), c_int), holes, word, found_at, n))
      n_found = int(n)
   end subroutine find_word

   !> Read words of eight bytes.
   subroutine read_words(path, index, words, number)
      !> Name of the file.
      character(*), intent(in) :: path
      !> First byte that is read, from 0.
      integer(i8), intent(in) :: index
      !> Receives the words; only a part of them if `number` is not 0.
      integer(i8), intent(inout), contiguous :: words(:)
      !> 0, `is_short`, or an error number of the system.
      integer, intent(out) :: number

      number = int(c_read_words(path//c_null_char, index, size(words, kind=c_int64_t), words))
   end subroutine read_words

end module adfric_system_file_bytes
