! SPDX-License-Identifier: GPL-3.0-or-later
!> Lines and cells of a table whose cells have commas between them.
module adfric_input_csv_lines
   use adfric_base_text, only: newline
   implicit none (type, external)
   private
   public :: byte_order_mark, strip_cell, end_of_text_line, is_skipped, count_cells, find_cell

   !> What may stand around a cell without being a part of it: blank, tab, and the first half of some line ends.
   character(*), parameter :: blanks = ' '//achar(9)//achar(13)
   !> Mark that some programs put before the first line.
   character(*), parameter :: byte_order_mark = char(239)//char(187)//char(191)

contains

   !> Position of the last character of a line, before its end.
   pure integer function end_of_text_line(text, first)
      !> The whole text.
      character(*), intent(in) :: text
      !> Position in the line, from 1.
      integer, intent(in) :: first
      integer :: i

      end_of_text_line = len(text)
      do i = first, len(text)
         if (text(i:i) /= newline) cycle
         end_of_text_line = i - 1
         return
      end do
   end function end_of_text_line

   !> Is a line empty, or a comment?
   pure logical function is_skipped(text, first, last)
      !> The whole text.
      character(*), intent(in) :: text
      !> Positions of the first and the last character of the line; `last < first` for an empty one.
      integer, intent(in) :: first, last
      integer :: i

      i = verify(text(first:last), blanks)
      is_skipped = i == 0
      if (.not. is_skipped) is_skipped = text(first + i - 1:first + i - 1) == '#'
   end function is_skipped

   !> Number of cells of a line.
   pure integer function count_cells(text, first, last)
      !> The whole text.
      character(*), intent(in) :: text
      !> Positions of the first and the last character of the line.
      integer, intent(in) :: first, last
      integer :: i

      count_cells = 1
      do i = first, last
         if (text(i:i) == ',') count_cells = count_cells + 1
      end do
   end function count_cells

   !> Find a cell of a line.
   pure subroutine find_cell(text, start, number, first, last)
      !> The whole text.
      character(*), intent(in) :: text
      !> Position of the first character of the line.
      integer, intent(in) :: start
      !> Which cell of the line, from 1; the line has it.
      integer, intent(in) :: number
      !> Positions of the first and the last character of the cell without the blanks around it; `last < first` for an empty one.
      integer, intent(out) :: first, last
      integer :: k

      first = start
      do k = 2, number
         do while (text(first:first) /= ',')
            first = first + 1
         end do
         first = first + 1
      end do
      last = first
      do while (last <= len(text))
         if (text(last:last) == ',' .or. text(last:last) == newline) exit
         last = last + 1
      end do
      last = last - 1
      call strip_cell(text, first, last)
   end subroutine find_cell

   !> Leave out the blanks around a cell.
   pure subroutine strip_cell(text, first, last)
      !> The whole text.
      character(*), intent(in) :: text
      !> In: positions of the first and the last character of the cell. Out: those of what is left; `last < first` if nothing is.
      integer, intent(inout) :: first, last

      do while (first <= last)
         if (scan(text(first:first), blanks) == 0) exit
         first = first + 1
      end do
      do while (last >= first)
         if (scan(text(last:last), blanks) == 0) exit
         last = last - 1
      end do
   end subroutine strip_cell

end module adfric_input_csv_lines
