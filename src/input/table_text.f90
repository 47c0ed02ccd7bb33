! SPDX-License-Identifier: GPL-3.0-or-later
!> The text of a table, whatever its encoding and its line ends: UTF-8, UTF-16 with a mark, or Latin-1, as UTF-8 with one kind of
!> line end.
module adfric_input_table_text
   use adfric_base_printable, only: length_of_letter
   use adfric_base_text, only: newline, show_count
   use adfric_input_source_text, only: find_control_character
   implicit none (type, external)
   private
   public :: decode_text

   character, parameter :: carriage_return = achar(13)
   !> Marks before the first letter: of UTF-8, and of UTF-16 and UTF-32 with the low or the high byte first.
   character(*), parameter :: mark_8 = char(239)//char(187)//char(191), mark_low = char(255)//char(254), &
      mark_high = char(254)//char(255), mark_32_low = mark_low//char(0)//char(0), mark_32_high = char(0)//char(0)//mark_high
   !> Halves of letters beyond the 16 bits: the first of the upper and of the lower ones, and the first number that is none.
   integer, parameter :: upper_half = int(z'd800'), lower_half = int(z'dc00'), behind_halves = int(z'e000')

contains

   !> Make a text UTF-8 with one kind of line end.
   pure subroutine decode_text(text, flaw, position)
      !> In: the bytes of the file. Out: the text.
      character(:), allocatable, intent(inout) :: text
      character(:), allocatable, intent(out) :: flaw
      !> Position in the text of what is wrong, from 1.
      integer, intent(out) :: position

      flaw = ''
      position = 1
      if (begins(text, mark_32_low) .or. begins(text, mark_32_high)) then
         flaw = 'the encoding is UTF-32, allowed: UTF-8, UTF-16 with its mark, Latin-1'
      else if (begins(text, mark_low) .or. begins(text, mark_high)) then
         call decode_pairs(text, begins(text, mark_high), flaw)
      else if (begins(text, mark_8)) then
         text = text(len(mark_8) + 1:)
      end if
      if (len(flaw) > 0) return
      position = find_control_character(text)
      if (position > 0) then
         flaw = 'not a text, given the control character '//show_count(iachar(text(position:position)))
         if (text(position:position) == char(0)) flaw = flaw//'; UTF-16 needs its mark at the beginning'
         return
      end if
      if (.not. is_utf_8(text)) call decode_latin(text)
      call unify_line_ends(text)
   end subroutine decode_text

   !> Does a text begin with a mark?
   pure logical function begins(text, mark)
      character(*), intent(in) :: text, mark

      begins = index(text(:min(len(text), len(mark))), mark) == 1
   end function begins

   !> Is a text UTF-8?
   pure logical function is_utf_8(text)
      character(*), intent(in) :: text
      integer :: i, length

      is_utf_8 = .false.
      i = 1
      do while (i <= len(text))
         length = 1
         if (iachar(text(i:i)) > 127) length = length_of_letter(text, i)
         if (length == 0) return
         i = i + length
      end do
      is_utf_8 = .true.
   end function is_utf_8

   !> Make UTF-8 of UTF-16.
   pure subroutine decode_pairs(text, is_high_first, flaw)
      !> In: the bytes with the mark. Out: the text without it.
      character(:), allocatable, intent(inout) :: text
      !> Does the high byte of each pair stand first?
      logical, intent(in) :: is_high_first
      !> What is wrong; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw
      character(:), allocatable :: decoded
      integer :: i, n, code, lower

      flaw = ''
      if (mod(len(text), 2) > 0) flaw = 'half a letter of UTF-16 stands at the end'
      ! two bytes have at most three in UTF-8
      allocate (character(3*(len(text)/2)) :: decoded)
      n = 0
      i = 3
      do while (i < len(text) .and. len(flaw) == 0)
         code = pair_at(text, i, is_high_first)
         i = i + 2
         if (code >= upper_half .and. code < behind_halves) then
            lower = 0
            if (code < lower_half .and. i < len(text)) lower = pair_at(text, i, is_high_first)
            if (lower < lower_half .or. lower >= behind_halves) flaw = 'half a letter of UTF-16 stands alone'
            code = int(z'10000') + 1024*(code - upper_half) + lower - lower_half
            i = i + 2
         end if
         if (len(flaw) == 0) call append(code, decoded, n)
      end do
      text = decoded(:n)
   end subroutine decode_pairs

   !> The number of two bytes.
   pure integer function pair_at(text, i, is_high_first)
      !> The bytes.
      character(*), intent(in) :: text
      !> Position of the first of them.
      integer, intent(in) :: i
      logical, intent(in) :: is_high_first

      pair_at = iachar(text(i:i)) + 256*iachar(text(i + 1:i + 1))
      if (is_high_first) pair_at = 256*iachar(text(i:i)) + iachar(text(i + 1:i + 1))
   end function pair_at

   !> Make UTF-8 of Latin-1.
   pure subroutine decode_latin(text)
      !> In: the bytes. Out: the text.
      character(:), allocatable, intent(inout) :: text
      character(:), allocatable :: decoded
      integer :: i, n, n_high

      n_high = 0
      do i = 1, len(text)
         if (iachar(text(i:i)) > 127) n_high = n_high + 1
      end do
      allocate (character(len(text) + n_high) :: decoded)
      n = 0
      do i = 1, len(text)
         call append(iachar(text(i:i)), decoded, n)
      end do
      call move_alloc(decoded, text)
   end subroutine decode_latin

   !> Append a letter in UTF-8.
   pure subroutine append(code, text, n)
      !> Number of the letter.
      integer, intent(in) :: code
      !> The text, which has the space.
      character(*), intent(inout) :: text
      !> Length of the text so far; it grows.
      integer, intent(inout) :: n

      select case (code)
      case (:127)
         text(n + 1:n + 1) = char(code)
         n = n + 1
      case (128:2047)
         text(n + 1:n + 2) = char(192 + code/64)//char(128 + mod(code, 64))
         n = n + 2
      case (2048:65535)
         text(n + 1:n + 3) = char(224 + code/4096)//char(128 + mod(code/64, 64))//char(128 + mod(code, 64))
         n = n + 3
      case default
         text(n + 1:n + 4) = char(240 + code/262144)//char(128 + mod(code/4096, 64))//char(128 + mod(code/64, 64)) &
            //char(128 + mod(code, 64))
         n = n + 4
      end select
   end subroutine append

   !> Make a line end of each carriage return that stands alone; one before a line end counts as a blank.
   pure subroutine unify_line_ends(text)
      character(*), intent(inout) :: text
      integer :: i

      do i = 1, len(text)
         if (text(i:i) /= carriage_return) cycle
         if (i < len(text)) then
            if (text(i + 1:i + 1) == newline) cycle
         end if
         text(i:i) = newline
      end do
   end subroutine unify_line_ends

end module adfric_input_table_text
