! SPDX-License-Identifier: GPL-3.0-or-later
!> How a table of text is laid out: what separates its columns, where their names and units stand, and which mark is decimal.
!>
!> The first line of numbers and the names above it settle that together (`docs/reference/tables.md`). A separator fits if by it the line
!> has numbers alone, and as many as there are names. A cell in which another separator stands is no number, and the comma of a
!> number stands between digits; so no two of them fit but tabs and blanks, and one column without any.
module adfric_input_table_layout
   use adfric_base_text, only: show_count, show_text
   use adfric_input_table_cells, only: begin_cells, cell_t, comment_text, count_cells, find_next_line, find_previous_line, &
      is_comment, next_cell, tab
   use adfric_input_table_heads, only: heads_t, read_heads
   use adfric_input_table_numbers, only: find_decimal_mark, has_numbers_alone, is_missing, is_number_form, is_numeral
   implicit none (type, external)
   private
   public :: table_layout_t, find_layout

   !> What may separate columns, in the order in which they are tried; a blank stands for any number of blanks and tabs.
   character(*), parameter :: separators = tab//';, '

   !> A layout.
   type :: table_layout_t
      !> What separates the columns; a tab where there is one column.
      character :: separator = ','
      !> Is there one column alone?
      logical :: is_single = .false.
      !> Is the decimal mark a comma?
      logical :: has_decimal_comma = .false.
      !> The names and the units of the columns.
      type(heads_t) :: heads
      !> Positions of the lines of the names and of the units; 0 if no line has the units.
      integer :: names_at = 0, units_at = 0
      !> Position of the first line behind them.
      integer :: rows_at = 0
   end type table_layout_t

contains

   !> Find the layout of a text.
   pure subroutine find_layout(text, layout, flaw, position)
      character(*), intent(in) :: text
      !> Receives the layout; only to be used if nothing is wrong.
      type(table_layout_t), intent(out) :: layout
      character(:), allocatable, intent(out) :: flaw
      !> Position in the text of what is wrong, from 1; 0 if it is the whole of it.
      integer, intent(out) :: position
      integer :: first, last
      logical :: is_found

      flaw = ''
      position = 0
      call find_numbers(text, first, last)
      if (first == 0) then
         call take_first_line(text, layout, flaw, position)
      else
         call find_heads(text, first, last, .false., layout, is_found)
         if (.not. is_found) call find_heads(text, first, last, .true., layout, is_found)
         if (.not. is_found) call say_what_is_wrong(text, first, last, flaw)
         if (.not. is_found) position = first
      end if
      if (len(flaw) == 0) call find_decimal_mark(text, layout%rows_at, layout%separator, layout%has_decimal_comma, flaw, position)
   end subroutine find_layout

   !> Find the first line that has numbers alone, whatever separates them.
   pure subroutine find_numbers(text, first, last)
      character(*), intent(in) :: text
      !> Positions of the first and the last character of the line; `first = 0` if there is none.
      integer, intent(out) :: first, last

      call find_next_line(text, 1, first, last)
      do while (first > 0)
         if (.not. is_comment(text(first:last))) then
            if (has_numbers_alone(text(first:last))) return
         end if
         call find_next_line(text, last + 2, first, last)
      end do
   end subroutine find_numbers

   !> Has a line numbers alone by a separator, be they right or not?
   pure logical function fits_numbers(text, first, last, separator)
      character(*), intent(in) :: text
      !> Positions of the first and the last character of the line.
      integer, intent(in) :: first, last
      character, intent(in) :: separator
      type(cell_t) :: cell
      integer :: n

      cell = begin_cells(first)
      fits_numbers = .true.
      n = 0
      do while (cell%next > 0 .and. fits_numbers)
         call next_cell(text, last, separator, cell)
         n = n + 1
         associate (word => text(cell%first:cell%last))
            fits_numbers = is_numeral(word) .or. is_missing(word)
            ! in one column alone a mark too many might separate columns
            if (n == 1 .and. cell%next == 0) fits_numbers = is_number_form(word)
         end associate
      end do
   end function fits_numbers

   !> Find the separator by which there are names above the first line of numbers.
   pure subroutine find_heads(text, first, last, in_comments, layout, is_found)
      character(*), intent(in) :: text
      !> Positions of the first and the last character of the line of numbers.
      integer, intent(in) :: first, last
      !> Do the names stand in comments, directly above?
      logical, intent(in) :: in_comments
      !> Receives the separator and the names, if there are some.
      type(table_layout_t), intent(inout) :: layout
      logical, intent(out) :: is_found
      integer :: k, n_cells, n_filled
      logical :: is_wrong

      is_found = .false.
      do k = 1, len(separators)
         if (.not. fits_numbers(text, first, last, separators(k:k))) cycle
         layout%separator = separators(k:k)
         call count_cells(text, first, last, layout%separator, n_cells, n_filled, is_wrong)
         call search_above(text, first, n_filled, n_cells, in_comments, layout, is_found)
         layout%is_single = n_cells == 1
         if (is_found) return
      end do
   end subroutine find_heads

   !> Find the nearest line above another that has names, and a line of units before it or none.
   pure recursive subroutine search_above(text, start, n_least, n_most, in_comments, layout, is_found)
      character(*), intent(in) :: text
      !> Position of the first character of the line of numbers.
      integer, intent(in) :: start
      !> Columns that have a number, and those that there are at most.
      integer, intent(in) :: n_least, n_most
      !> Are comments searched, of which only those directly above count?
      logical, intent(in) :: in_comments
      !> In: the separator. Out: also the names, if there are some.
      type(table_layout_t), intent(inout) :: layout
      logical, intent(out) :: is_found
      type(heads_t) :: heads
      integer :: first, last, upper
      logical :: is_right

      is_found = .false.
      first = start
      do
         call find_next_above(text, (first), in_comments, first, last)
         if (first == 0) return
         call try_heads(text, first, last, layout%separator, n_least, n_most, layout%heads, is_right)
         if (is_right) exit
         if (in_comments) return
      end do
      layout%names_at = first
      layout%units_at = 0
      layout%rows_at = last + 2
      is_found = layout%heads%n_columns() >= n_least
      if (.not. layout%heads%are_units()) then
         if (is_found .and. .not. in_comments) call take_units_below(text, .true., layout)
         return
      end if
      call find_next_above(text, first, in_comments, upper, last)
      is_right = upper > 0
      if (is_right) call try_heads(text, upper, last, layout%separator, n_least, n_most, heads, is_right)
      if (.not. is_right) return
      is_found = .true.
      call heads%take_units(layout%heads)
      layout%heads = heads
      layout%names_at = upper
      layout%units_at = first
   end subroutine search_above

   !> Take the units of the line directly below the names, if it has nothing else.
   pure subroutine take_units_below(text, in_comment, layout)
      character(*), intent(in) :: text
      !> Is it a comment that may have them?
      logical, intent(in) :: in_comment
      !> In: the layout without units. Out: also the units, if they stand there.
      type(table_layout_t), intent(inout) :: layout
      type(heads_t) :: units
      integer :: first, last, start, n
      logical :: is_right

      call find_next_line(text, layout%rows_at, first, last)
      if (first == 0) return
      if (is_comment(text(first:last)) .neqv. in_comment) return
      n = layout%heads%n_columns()
      start = first
      if (in_comment) start = first - 1 + comment_text(text(first:last))
      call read_heads(text, start, last, layout%separator, n, n, units, is_right)
      if (is_right) is_right = units%n_columns() == n
      if (.not. is_right .and. in_comment) then
         ! the sign of a comment may be a unit
         call read_heads(text, first, last, layout%separator, n, n, units, is_right)
         if (is_right) is_right = units%n_columns() == n
      end if
      if (is_right) is_right = units%are_units() .and. units%has_letters()
      if (.not. is_right) return
      call layout%heads%take_units(units)
      layout%units_at = first
      layout%rows_at = last + 2
   end subroutine take_units_below

   !> Find the next line above that is a comment, or that is none.
   pure subroutine find_next_above(text, start, in_comments, first, last)
      character(*), intent(in) :: text
      !> Position of the first character of a line.
      integer, intent(in) :: start
      !> Is it a comment that is wanted, directly above?
      logical, intent(in) :: in_comments
      integer, intent(out) :: first, last

      call find_previous_line(text, start, first, last)
      do while (first > 0)
         if (is_comment(text(first:last)) .eqv. in_comments) return
         if (in_comments) first = 0
         if (in_comments) return
         call find_previous_line(text, (first), first, last)
      end do
   end subroutine find_next_above

   !> Read the heads of a line, which may be a comment.
   pure subroutine try_heads(text, first, last, separator, n_least, n_most, heads, is_right)
      character(*), intent(in) :: text
      !> Positions of the first and the last character of the line, which may be a comment.
      integer, intent(in) :: first, last
      character, intent(in) :: separator
      integer, intent(in) :: n_least, n_most
      type(heads_t), intent(out) :: heads
      !> Are they names or units of all columns?
      logical, intent(out) :: is_right
      integer :: start

      start = first
      if (is_comment(text(first:last))) start = first - 1 + comment_text(text(first:last))
      call read_heads(text, start, last, separator, n_least, n_most, heads, is_right)
   end subroutine try_heads

   !> Take the first line for the names, where every row has a text.
   pure subroutine take_first_line(text, layout, flaw, position)
      character(*), intent(in) :: text
      type(table_layout_t), intent(inout) :: layout
      character(:), allocatable, intent(out) :: flaw
      integer, intent(out) :: position
      integer :: first, last, n_cells, n_filled
      logical :: is_right

      flaw = ''
      position = 0
      call find_next_line(text, 1, first, last)
      do while (first > 0)
         if (.not. is_comment(text(first:last))) exit
         call find_next_line(text, last + 2, first, last)
      end do
      if (first == 0) then
         flaw = 'no header, needed: a line with the names of the columns'
         return
      end if
      layout%separator = separator_in(text(first:last))
      layout%names_at = first
      layout%rows_at = last + 2
      call count_cells(text, first, last, layout%separator, n_cells, n_filled, is_right)
      call read_heads(text, first, last, layout%separator, n_filled, n_cells, layout%heads, is_right)
      layout%is_single = n_cells == 1
      if (is_right) call take_units_below(text, .false., layout)
      if (is_right .and. layout%units_at == 0) call take_units_below(text, .true., layout)
      if (is_right) return
      flaw = 'no header, given '//show_text(text(first:last))//', needed: a line with the names of the columns'
      position = first
   end subroutine take_first_line

   !> What may separate the columns of a line, by itself.
   pure character function separator_in(line)
      character(*), intent(in) :: line
      integer :: k

      do k = 1, len(separators)
         separator_in = separators(k:k)
         if (index(line, separator_in) > 0) return
      end do
      separator_in = tab
   end function separator_in

   !> Say why there are no names above the first line of numbers.
   pure subroutine say_what_is_wrong(text, first, last, flaw)
      character(*), intent(in) :: text
      integer, intent(in) :: first, last
      character(:), allocatable, intent(out) :: flaw
      type(cell_t) :: cell
      character :: separator
      integer :: n_cells, n_filled
      logical :: is_wrong

      separator = separator_in(text(first:last))
      cell = begin_cells(first)
      do while (cell%next > 0)
         call next_cell(text, last, separator, cell)
         associate (word => text(cell%first:cell%last))
            if (cell%is_wrong) then
               flaw = 'a quote is not closed, or something stands behind it, given '//show_text(text(first:last))
               return
            else if (.not. (is_numeral(word) .or. is_missing(word))) then
               flaw = 'not a number, given '//show_text(word)//', in the first row of numbers'
               return
            end if
         end associate
      end do
      call count_cells(text, first, last, separator, n_cells, n_filled, is_wrong)
      flaw = 'no header, needed: a line with '//show_count(n_cells)//' names of columns above the first row of numbers'
      if (n_cells == 1) flaw = 'no header, needed: a line with the name of the column above the first number'
      flaw = flaw//', given '//show_text(text(first:last))
      if (separator == ',') flaw = flaw//'; a decimal comma needs columns between semicolons, tabs or blanks'
   end subroutine say_what_is_wrong

end module adfric_input_table_layout
