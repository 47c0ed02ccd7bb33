! SPDX-License-Identifier: GPL-3.0-or-later
!> The header of a table: names of its columns, each with a unit in brackets or without.
module adfric_input_csv_header
   use adfric_base_text, only: show_count, show_text
   use adfric_input_csv_lines, only: count_cells, find_cell, strip_cell
   use adfric_input_literal, only: convert
   use adfric_input_suggestion, only: find_nearest
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: csv_column_t, read_header, find_column, say_unknown_column

   !> Stands for a blank within a name where names are separated by blanks.
   character, parameter :: inner_blank = achar(31)

   !> A column.
   type :: csv_column_t
      !> Its name, without the unit.
      character(:), allocatable :: name
      !> Its unit as it is written; empty where there is none, and the numbers are in SI units.
      character(:), allocatable :: unit
   end type csv_column_t

contains

   !> Read a header.
   subroutine read_header(line, columns, flaw)
      !> The line without its end.
      character(*), intent(in) :: line
      !> Receives the columns; only to be used if nothing is wrong.
      type(csv_column_t), allocatable, intent(out) :: columns(:)
      !> What is wrong, what was given, what is allowed; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw
      integer :: k, first, last

      flaw = ''
      allocate (columns(count_cells(line, 1, len(line))))
      do k = 1, size(columns)
         call find_cell(line, 1, k, first, last)
         call read_name(line(first:last), columns(k), flaw)
         if (len(flaw) > 0) then
            flaw = 'column '//show_count(k)//': '//flaw
         else if (find_column(columns(:k - 1), columns(k)%name) > 0) then
            flaw = 'two columns have the name '//show_text(columns(k)%name)//', number ' &
               //show_count(find_column(columns(:k - 1), columns(k)%name))//' and number '//show_count(k)//', allowed: one'
         end if
         if (len(flaw) > 0) return
      end do
   end subroutine read_header

   !> Read the name of a column with its unit.
   subroutine read_name(text, column, flaw)
      !> Text of the cell without the blanks around it; it may stand in quotes.
      character(*), intent(in) :: text
      !> Receives name and unit.
      type(csv_column_t), intent(out) :: column
      !> What is wrong, what was given, what is allowed; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw
      character(:), allocatable :: cell, unused
      real(dp) :: number
      integer :: first, last, bracket

      flaw = ''
      cell = text
      if (len(cell) > 1) then
         if (cell(1:1) == '"' .and. cell(len(cell):) == '"') cell = cell(2:len(cell) - 1)
      end if
      bracket = index(cell, '[', back=.true.)
      first = 1
      last = len(cell)
      column%unit = ''
      if (bracket > 0) then
         last = bracket - 1
         if (cell(len(cell):) /= ']') then
            flaw = 'the bracket of the unit is not closed, given '//show_text(text)//', allowed: a name, or NAME [UNIT]'
            return
         end if
         column%unit = trim(adjustl(cell(bracket + 1:len(cell) - 1)))
         if (len(column%unit) == 0) flaw = 'no unit in the brackets, given '//show_text(text)//', allowed: a name, or NAME [UNIT]'
      end if
      call strip_cell(cell, first, last)
      column%name = cell(first:last)
      if (len(flaw) > 0) return
      if (len(column%name) == 0) then
         flaw = 'no name in the header, allowed: a name, or NAME [UNIT]'
         return
      end if
      call convert(column%name, number, unused)
      if (len(unused) == 0) flaw = 'no header, given the number '//show_text(text)// &
         ' in the place of a name, needed: a line with the names of the columns'
   end subroutine read_name

   !> Place of a column, from 1; 0 if there is none of this name.
   pure integer function find_column(columns, name)
      !> The columns, whose names are compared.
      type(csv_column_t), intent(in) :: columns(:)
      !> Name of the column without its unit.
      character(*), intent(in) :: name

      do find_column = 1, size(columns)
         if (columns(find_column)%name == name) return
      end do
      find_column = 0
   end function find_column

   !> What to say of a column that is not there.
   pure function say_unknown_column(columns, name) result(text)
      !> The columns that are there.
      type(csv_column_t), intent(in) :: columns(:)
      !> The name that is not known.
      character(*), intent(in) :: name
      character(:), allocatable :: text
      character(:), allocatable :: known, near
      integer :: k

      text = 'unknown column, given '//show_text(name)//', allowed: '
      known = ''
      do k = 1, size(columns)
         if (k > 1) text = text//', '
         text = text//show_text(columns(k)%name)
         known = known//' '//exchange(columns(k)%name, ' ', inner_blank)
      end do
      near = find_nearest(exchange(name, ' ', inner_blank), known)
      if (len(near) > 0) text = text//'; did you mean '//show_text(exchange(near, inner_blank, ' '))//'?'
   end function say_unknown_column

   !> A text with one character in the place of another.
   pure function exchange(text, old, new) result(changed)
      !> Any text.
      character(*), intent(in) :: text
      !> The character that is replaced, and the one that takes its place.
      character, intent(in) :: old, new
      character(len(text)) :: changed
      integer :: i

      changed = text
      do i = 1, len(text)
         if (text(i:i) == old) changed(i:i) = new
      end do
   end function exchange

end module adfric_input_csv_header
