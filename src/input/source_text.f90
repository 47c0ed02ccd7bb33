! SPDX-License-Identifier: GPL-3.0-or-later
!> The text of a namelist file: comments, quotes and lines.
!>
!> Nothing here looks at a letter more than a fixed number of times for each time it is asked, so that reading takes a time in
!> proportion to the length of the text.
module adfric_input_source_text
   use adfric_base_text, only: newline
   implicit none (type, external)
   private
   public :: source_t, new_source, find_control_character, end_of_quote, is_closed, end_of_line

   !> Line end of old files, and first half of that of others.
   character(*), parameter :: carriage_return = achar(13)
   !> Mark that some editors put before the first line.
   character(*), parameter :: byte_order_mark = char(239)//char(187)//char(191)
   !> Letters between the positions whose lines are known.
   integer, parameter :: stride = 1024

   !> A text without its comments.
   type :: source_t
      !> The text with blanks for comments and tabs, and one kind of line end: the positions are those of the file.
      character(:), allocatable :: bare
      !> Number of line ends before the positions 1, 1 + stride, 1 + 2 stride and so on.
      integer, allocatable :: lines_before(:)
   contains
      procedure :: line_at
   end type source_t

contains

   !> Strip a text of its comments and count its lines.
   pure subroutine new_source(self, text)
      !> Receives the text without comments, and the lines before its positions.
      type(source_t), intent(out) :: self
      !> The text as it stands in the file.
      character(*), intent(in) :: text

      self%bare = text
      call strip_comments(text, self%bare)
      call count_lines(self)
   end subroutine new_source

   !> Replace comments and tabs by blanks and line ends by one kind of them.
   pure subroutine strip_comments(text, bare)
      character(*), intent(in) :: text
      !> In: a copy of the text. Out: the same with blanks for comments and tabs.
      character(*), intent(inout) :: bare
      integer :: i, last

      if (index(text(:min(len(text), len(byte_order_mark))), byte_order_mark) == 1) bare(1:3) = ' '
      i = 1
      do while (i <= len(text))
         select case (text(i:i))
         case ('''', '"')
            i = end_of_quote(text, i)
         case ('!')
            last = end_of_line(text, i)
            bare(i:last) = ' '
            i = last
         case (carriage_return)
            bare(i:i) = newline
            if (i < len(text)) then
               if (text(i + 1:i + 1) == newline) bare(i:i) = ' '
            end if
         case (achar(9), achar(11), achar(12))
            bare(i:i) = ' '
         end select
         i = i + 1
      end do
   end subroutine strip_comments

   !> Count the line ends before every position that is a stride from the last.
   pure subroutine count_lines(self)
      !> In: the text without comments. Out: also the lines before its positions.
      type(source_t), intent(inout) :: self
      integer :: i, n

      allocate (self%lines_before(0:len(self%bare)/stride))
      n = 0
      do i = 1, len(self%bare)
         if (mod(i - 1, stride) == 0) self%lines_before((i - 1)/stride) = n
         if (self%bare(i:i) == newline) n = n + 1
      end do
      if (mod(len(self%bare), stride) == 0) self%lines_before(len(self%bare)/stride) = n
   end subroutine count_lines

   !> Line of a position, from 1.
   pure integer function line_at(self, position)
      class(source_t), intent(in) :: self
      !> Position in the text, from 1 to one behind its end.
      integer, intent(in) :: position
      integer :: i, block

      block = (position - 1)/stride
      line_at = 1 + self%lines_before(block)
      do i = block*stride + 1, position - 1
         if (self%bare(i:i) == newline) line_at = line_at + 1
      end do
   end function line_at

   !> Position of the first character that no text has; 0 if there is none.
   pure integer function find_control_character(text)
      character(*), intent(in) :: text

      do find_control_character = 1, len(text)
         select case (iachar(text(find_control_character:find_control_character)))
         case (0:8, 14:31, 127)
            return
         end select
      end do
      find_control_character = 0
   end function find_control_character

   !> Position of the quote that closes the one at `first`; the end of the line if there is none.
   pure integer function end_of_quote(text, first)
      !> Text in which the quote stands.
      character(*), intent(in) :: text
      !> Position of the quote that opens.
      integer, intent(in) :: first

      end_of_quote = first + 1
      do while (end_of_quote <= len(text))
         select case (text(end_of_quote:end_of_quote))
         case (newline, carriage_return)
            exit
         case ('''', '"')
            if (text(end_of_quote:end_of_quote) == text(first:first)) then
               if (end_of_quote == len(text)) return
               if (text(end_of_quote + 1:end_of_quote + 1) /= text(first:first)) return
               end_of_quote = end_of_quote + 1
            end if
         end select
         end_of_quote = end_of_quote + 1
      end do
      end_of_quote = end_of_quote - 1
   end function end_of_quote

   !> Is a text in quotes, from the first to `end_of_quote`, closed? A doubled quote within it stands for itself.
   pure logical function is_closed(quoted)
      !> The text with the quote that opens and, if there is one, that which closes.
      character(*), intent(in) :: quoted
      integer :: i

      is_closed = .true.
      do i = 1, len(quoted)
         if (quoted(i:i) == quoted(1:1)) is_closed = .not. is_closed
      end do
   end function is_closed

   !> Position of the last character of a line, its line end excluded.
   pure integer function end_of_line(text, first)
      !> Text with line ends of any kind.
      character(*), intent(in) :: text
      !> Position in the line, at most the length of the text.
      integer, intent(in) :: first

      do end_of_line = first, len(text) - 1
         if (text(end_of_line + 1:end_of_line + 1) == newline) return
         if (text(end_of_line + 1:end_of_line + 1) == carriage_return) return
      end do
      end_of_line = len(text)
   end function end_of_line

end module adfric_input_source_text
