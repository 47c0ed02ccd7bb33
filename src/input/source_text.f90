!> The text of a namelist file: comments, quotes and lines.
module adfric_input_source_text
   use adfric_input_text, only: newline
   implicit none (type, external)
   private
   public :: strip_comments, find_control_character, end_of_quote, is_closed, end_of_line, line_at

   character(*), parameter :: carriage_return = achar(13)
   !> Mark that some editors put before the first line.
   character(*), parameter :: byte_order_mark = char(239)//char(187)//char(191)

contains

   !> The text with comments, tabs and line ends replaced by blanks and one kind of line end. Its length,
   !> and with it every position, is kept.
   pure function strip_comments(text) result(bare)
      character(*), intent(in) :: text
      character(:), allocatable :: bare
      integer :: i, last

      bare = text
      if (index(text, byte_order_mark) == 1) bare(1:3) = ' '
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
   end function strip_comments

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
      character(*), intent(in) :: text
      integer, intent(in) :: first
      integer :: last

      last = end_of_line(text, first)
      end_of_quote = first + 1
      do while (end_of_quote <= last)
         if (text(end_of_quote:end_of_quote) == text(first:first)) then
            if (end_of_quote == last) return
            if (text(end_of_quote + 1:end_of_quote + 1) /= text(first:first)) return
            end_of_quote = end_of_quote + 1
         end if
         end_of_quote = end_of_quote + 1
      end do
      end_of_quote = last
   end function end_of_quote

   !> Is a text in quotes, from the first to `end_of_quote`, closed? A doubled quote within it stands for itself.
   pure logical function is_closed(quoted)
      character(*), intent(in) :: quoted
      integer :: i

      is_closed = mod(count([(quoted(i:i) == quoted(1:1), i=1, len(quoted))]), 2) == 0
   end function is_closed

   !> Position of the last character of a line, its line end excluded.
   pure integer function end_of_line(text, first)
      character(*), intent(in) :: text
      integer, intent(in) :: first

      do end_of_line = first, len(text) - 1
         if (text(end_of_line + 1:end_of_line + 1) == newline) return
         if (text(end_of_line + 1:end_of_line + 1) == carriage_return) return
      end do
      end_of_line = len(text)
   end function end_of_line

   !> Line of a position, from 1.
   pure integer function line_at(bare, position)
      character(*), intent(in) :: bare
      integer, intent(in) :: position
      integer :: i

      line_at = 1
      do i = 1, min(position - 1, len(bare))
         if (bare(i:i) == newline) line_at = line_at + 1
      end do
   end function line_at

end module adfric_input_source_text
