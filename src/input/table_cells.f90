! SPDX-License-Identifier: GPL-3.0-or-later
!> Lines and cells of a table of text.
!>
!> A cell ends at a separator, or at the end of its line. A quote opens at the beginning of a cell, and a doubled one within quotes
!> stands for itself. Where blanks separate, several of them, or tabs, are one separator.
module adfric_input_table_cells
   use adfric_base_text, only: newline
   implicit none (type, external)
   private
   public :: cell_t, tab, end_of_text_line, find_next_line, find_previous_line, begin_cells, next_cell, count_cells, find_cell
   public :: is_comment, comment_text, text_of_cell

   !> The separator that stands for several blanks.
   character, parameter :: tab = achar(9)
   !> What may stand around a cell without being a part of it: blank, tab, and the first half of some line ends.
   character(*), parameter :: blanks = ' '//tab//achar(13)
   !> Signs with which a comment begins.
   character(*), parameter :: comment_signs = '#%'

   !> A index in a line, and the cell that was found last.
   type :: cell_t
      !> Positions of the first and the last character of the cell, without quotes and blanks around it; `last < first` for an
      !> empty one.
      integer :: first = 1, last = 0
      !> Does it stand in quotes?
      logical :: is_quoted = .false.
      !> Is its quote not closed, or is there something behind it?
      logical :: is_wrong = .false.
      !> Position where the next cell begins; 0: there is none.
      integer :: next = 0
   end type cell_t

contains

   !> Position of the last character of a line, before its end.
   pure integer function end_of_text_line(text, first)
      character(*), intent(in) :: text
      !> Position in the line, from 1.
      integer, intent(in) :: first

      do end_of_text_line = first, len(text)
         if (text(end_of_text_line:end_of_text_line) == newline) exit
      end do
      end_of_text_line = end_of_text_line - 1
   end function end_of_text_line

   !> Find the next line that is not empty.
   pure subroutine find_next_line(text, start, first, last)
      character(*), intent(in) :: text
      !> Position where the search begins, at the beginning of a line.
      integer, intent(in) :: start
      !> Positions of the first and the last character of the line; `first = 0` if there is none.
      integer, intent(out) :: first, last

      first = start
      do while (first <= len(text))
         last = end_of_text_line(text, first)
         if (verify(text(first:last), blanks) > 0) return
         first = last + 2
      end do
      first = 0
      last = 0
   end subroutine find_next_line

   !> Find the line before one that is not empty.
   pure subroutine find_previous_line(text, start, first, last)
      character(*), intent(in) :: text
      !> Position of the first character of a line.
      integer, intent(in) :: start
      !> Positions of the first and the last character of the line before; `first = 0` if there is none.
      integer, intent(out) :: first, last

      first = start
      do while (first > 1)
         last = first - 2
         first = index(text(:last), newline, back=.true.) + 1
         if (verify(text(first:last), blanks) > 0) return
      end do
      first = 0
      last = 0
   end subroutine find_previous_line

   !> Is a line a comment? A cell with nothing but a sign makes none: a percent sign is a unit, and # the name of a column.
   pure logical function is_comment(line)
      !> A line that is not empty.
      character(*), intent(in) :: line
      integer :: i, k

      i = verify(line, blanks)
      is_comment = scan(line(i:i), comment_signs) == 1
      if (.not. is_comment) return
      do k = i + 1, len(line)
         if (scan(line(k:k), ';,'//tab) == 1) is_comment = .false.
         if (line(k:k) /= ' ') return
      end do
   end function is_comment

   !> Position in a comment of what stands behind the sign.
   pure integer function comment_text(line)
      character(*), intent(in) :: line

      comment_text = verify(line, blanks//comment_signs)
      if (comment_text == 0) comment_text = len(line) + 1
   end function comment_text

   !> Stand before the first cell of a line.
   pure type(cell_t) function begin_cells(first) result(cell)
      !> Position of the first character of the line.
      integer, intent(in) :: first

      cell%next = first
   end function begin_cells

   !> Go to the next cell of a line. There is always one where a separator stands before it; where blanks separate, there is none
   !> behind the last one.
   pure subroutine next_cell(text, last, separator, cell)
      character(*), intent(in) :: text
      !> Position of the last character of the line.
      integer, intent(in) :: last
      character, intent(in) :: separator
      !> In: the cell before, whose `next` is not 0. Out: the cell.
      type(cell_t), intent(inout) :: cell
      integer :: i

      i = cell%next
      cell%is_quoted = .false.
      cell%is_wrong = .false.
      do while (i <= last)
         if (scan(text(i:i), blanks) == 0 .or. text(i:i) == separator) then
            if (separator /= ' ' .or. scan(text(i:i), blanks) == 0) exit
         end if
         i = i + 1
      end do
      cell%first = i
      if (i <= last) cell%is_quoted = text(i:i) == '"'
      if (cell%is_quoted) then
         call pass_quotes(text, last, cell, i)
         cell%is_wrong = cell%is_wrong .or. .not. ends_here(text, last, separator, i)
         do while (.not. ends_here(text, last, separator, i))
            i = i + 1
         end do
      else
         do while (i <= last)
            if (is_separator_at(text, i, separator)) exit
            i = i + 1
         end do
         cell%last = i - 1
         cell%last = cell%first - 1 + verify(text(cell%first:cell%last), blanks, back=.true.)
      end if
      call pass_separator(text, last, separator, i, cell)
   end subroutine next_cell

   !> Does a separator stand here?
   pure logical function is_separator_at(text, i, separator)
      character(*), intent(in) :: text
      !> Position in the text.
      integer, intent(in) :: i
      character, intent(in) :: separator

      is_separator_at = text(i:i) == separator
      if (separator == ' ') is_separator_at = scan(text(i:i), blanks) == 1
   end function is_separator_at

   !> Does a cell end here, behind its closing quote?
   pure logical function ends_here(text, last, separator, i)
      character(*), intent(in) :: text
      integer, intent(in) :: last
      character, intent(in) :: separator
      integer, intent(in) :: i
      integer :: k

      ends_here = .true.
      do k = i, last
         if (is_separator_at(text, k, separator)) return
         if (scan(text(k:k), blanks) == 0) exit
      end do
      ends_here = k > last
   end function ends_here

   !> Pass what stands in quotes.
   pure subroutine pass_quotes(text, last, cell, i)
      character(*), intent(in) :: text
      integer, intent(in) :: last
      !> Receives the positions within the quotes, and whether they are not closed.
      type(cell_t), intent(inout) :: cell
      !> In: position of the quote that opens. Out: position behind the one that closes.
      integer, intent(inout) :: i

      cell%first = i + 1
      do
         i = i + 1
         if (i > last) exit
         if (text(i:i) /= '"') cycle
         if (i == last) exit
         if (text(i + 1:i + 1) /= '"') exit
         i = i + 1
      end do
      cell%is_wrong = i > last
      cell%last = min(i, last + 1) - 1
      i = min(i, last) + 1
   end subroutine pass_quotes

   !> Pass the separator behind a cell.
   pure subroutine pass_separator(text, last, separator, i, cell)
      character(*), intent(in) :: text
      integer, intent(in) :: last
      character, intent(in) :: separator
      !> Position behind the cell, where blanks may stand before the separator.
      integer, intent(in) :: i
      !> Receives where the next cell begins.
      type(cell_t), intent(inout) :: cell
      integer :: k

      cell%next = 0
      do k = i, last
         if (separator == ' ') then
            if (scan(text(k:k), blanks) == 1) cycle
            cell%next = k
            return
         else if (text(k:k) == separator) then
            cell%next = k + 1
            return
         end if
      end do
   end subroutine pass_separator

   !> Text of a cell, with the doubled quotes of a quoted one made one.
   pure function text_of_cell(text, cell) result(content)
      character(*), intent(in) :: text
      type(cell_t), intent(in) :: cell
      character(:), allocatable :: content
      integer :: i, n

      content = text(cell%first:cell%last)
      if (.not. cell%is_quoted) return
      n = 0
      i = 1
      do while (i <= len(content))
         n = n + 1
         content(n:n) = content(i:i)
         i = i + merge(2, 1, content(i:i) == '"')
      end do
      content = trim(adjustl(content(:n)))
   end function text_of_cell

   !> Count the cells of a line.
   pure subroutine count_cells(text, first, last, separator, n_cells, n_filled, is_wrong)
      character(*), intent(in) :: text
      !> Positions of the first and the last character of the line.
      integer, intent(in) :: first, last
      character, intent(in) :: separator
      !> Number of cells, and of the last one that is not empty.
      integer, intent(out) :: n_cells, n_filled
      !> Is a quote not closed, or does something stand behind it?
      logical, intent(out) :: is_wrong
      type(cell_t) :: cell

      n_cells = 0
      n_filled = 0
      is_wrong = .false.
      cell = begin_cells(first)
      do while (cell%next > 0)
         call next_cell(text, last, separator, cell)
         n_cells = n_cells + 1
         if (cell%last >= cell%first) n_filled = n_cells
         is_wrong = is_wrong .or. cell%is_wrong
      end do
   end subroutine count_cells

   !> Find a cell of a line.
   pure subroutine find_cell(text, first, separator, number, cell)
      character(*), intent(in) :: text
      integer, intent(in) :: first
      character, intent(in) :: separator
      !> Which cell of the line, from 1; the line has it.
      integer, intent(in) :: number
      type(cell_t), intent(out) :: cell
      integer :: k, last

      last = end_of_text_line(text, first)
      cell = begin_cells(first)
      do k = 1, number
         call next_cell(text, last, separator, cell)
      end do
   end subroutine find_cell

end module adfric_input_table_cells
