! SPDX-License-Identifier: GPL-3.0-or-later
!> A table of numbers in a text file: one header line, then a row a line, with commas between the cells (CSV).
!>
!> Lines that begin with `#` are comments. The names of the header may carry a unit in brackets, as in `load [nN]`; without one
!> the column is in SI units. An empty cell, or `nan`, has no value. Numbers are written as in C or Fortran. The text is kept, and
!> a column is converted when it is taken.
module adfric_input_csv_table
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_error, only: error_t, set_error, input_failure
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_text, only: newline, show_count, show_number, show_text, to_lower
   use adfric_base_units, only: unit_t, to_si
   use adfric_input_csv_header, only: csv_column_t, read_header, find_column, say_unknown_column
   use adfric_input_csv_lines, only: byte_order_mark, end_of_text_line, is_skipped, count_cells, find_cell
   use adfric_input_literal, only: convert
   use adfric_input_source_text, only: find_control_character
   use adfric_input_unit_match, only: match_units
   use adfric_input_whole_file, only: read_whole_file
   implicit none (type, external)
   private
   public :: csv_table_t, csv_column_t, open_csv_table, new_csv_table, new_table_of_numbers

   !> More than anybody has in one table of text: something else was given by mistake [bytes].
   integer, parameter :: largest_table = 1000*1024**2
   !> No number of physics is larger.
   real(dp), parameter :: largest = 1.0e60_dp
   !> Rows that there is room for at first.
   integer, parameter :: first_room = 64

   !> A table.
   type :: csv_table_t
      !> Name of the file, as the user gave it.
      character(:), allocatable :: path
      !> Names and units of the columns, in their order; shape `(n_columns)`.
      type(csv_column_t), allocatable :: columns(:)
      !> Text of the file, byte by byte.
      character(:), allocatable, private :: text
      !> Position in the text of the first character of each row.
      integer, allocatable, private :: rows(:)
      !> The numbers of a table that has no text; shape `(n_rows, n_columns)`.
      real(dp), allocatable, private :: numbers(:, :)
   contains
      procedure :: n_rows
      procedure :: index_of => index_of_column
      procedure :: take_column
      procedure :: get_numbers
      procedure :: line_of_row
   end type csv_table_t

contains

   !> Read a file: its header and the place of each row. The numbers are not looked at before a column is taken.
   subroutine open_csv_table(self, path, error)
      !> Receives the table; only to be used if there is no error.
      type(csv_table_t), intent(out) :: self
      !> Name of the file, as the user gave it.
      character(*), intent(in) :: path
      !> Allocated if the file cannot be read (`file_failure`), or if it is no table (`input_failure`).
      type(error_t), allocatable, intent(out) :: error
      character(:), allocatable :: text

      call read_whole_file(path, text, error, 'table', largest_table)
      if (.not. allocated(error)) call new_csv_table(self, path, text, error)
   end subroutine open_csv_table

   !> Find the header and the rows of a text.
   subroutine new_csv_table(self, path, text, error)
      !> Receives the table; only to be used if there is no error.
      type(csv_table_t), intent(out) :: self
      !> Name of the file, for messages.
      character(*), intent(in) :: path
      !> The whole text; it is taken over and not allocated afterwards.
      character(:), allocatable, intent(inout) :: text
      !> Allocated if it is no table.
      type(error_t), allocatable, intent(out) :: error
      character(:), allocatable :: flaw
      integer :: place, first, last

      self%path = path
      call move_alloc(text, self%text)
      place = find_control_character(self%text)
      if (place > 0) then
         call fail(self, 'not a text, given the control character '//show_count(iachar(self%text(place:place))), place, error)
         return
      end if
      first = 1
      if (index(self%text, byte_order_mark) == 1) first = 1 + len(byte_order_mark)
      do while (first <= len(self%text))
         last = end_of_text_line(self%text, first)
         if (.not. is_skipped(self%text, first, last)) exit
         first = last + 2
      end do
      if (first > len(self%text)) then
         call set_error(error, input_failure, path//': no header, needed: a line with the names of the columns')
         return
      end if
      call read_header(self%text(first:last), self%columns, flaw)
      if (len(flaw) > 0) then
         call fail(self, flaw, first, error)
      else
         call find_rows(self, last + 2, error)
      end if
   end subroutine new_csv_table

   !> A table of numbers that somebody has.
   subroutine new_table_of_numbers(self, name, columns, units, numbers, error)
      !> Receives the table; only to be used if there is no error.
      type(csv_table_t), intent(out) :: self
      !> Its name, by which an input knows it.
      character(*), intent(in) :: name
      !> Names of its columns; blanks at their ends do not count.
      character(*), intent(in) :: columns(:)
      !> Their units, empty for SI units.
      character(*), intent(in) :: units(:)
      !> The numbers, NaN where there is none; shape `(n_rows, n_columns)`.
      real(dp), intent(in) :: numbers(:, :)
      !> Allocated if the shapes do not go together, a name is missing or there twice, or there is no row.
      type(error_t), allocatable, intent(out) :: error
      integer :: k

      self%path = name
      if (size(columns) /= size(numbers, 2) .or. size(units) /= size(columns) .or. size(numbers) == 0) then
         call set_error(error, input_failure, name//': given numbers of shape ('//show_count(size(numbers, 1))//', '// &
            show_count(size(numbers, 2))//') with '//show_count(size(columns))//' names and '//show_count(size(units))// &
            ' units of columns, needed: at least one row, and one name and unit of each column')
         return
      end if
      allocate (self%columns(size(columns)))
      do k = 1, size(columns)
         self%columns(k) = csv_column_t(name=trim(columns(k)), unit=trim(units(k)))
         if (len_trim(columns(k)) == 0) then
            call set_error(error, input_failure, name//': column '//show_count(k)//' has no name')
         else if (find_column(self%columns(:k - 1), trim(columns(k))) > 0) then
            call set_error(error, input_failure, name//': two columns have the name '//show_text(trim(columns(k)))// &
               ', allowed: one')
         end if
         if (allocated(error)) return
      end do
      allocate (self%numbers, source=numbers)
   end subroutine new_table_of_numbers

   !> Find where each row begins. All of them have as many cells as the header.
   subroutine find_rows(self, start, error)
      !> The table, which receives its rows.
      type(csv_table_t), intent(inout) :: self
      !> Position in the text behind the header.
      integer, intent(in) :: start
      !> Allocated if a row has too few or too many cells, or if there is no row.
      type(error_t), allocatable, intent(out) :: error
      integer, allocatable :: larger(:)
      integer :: first, last, n, n_cells

      allocate (self%rows(first_room))
      n = 0
      first = start
      do while (first <= len(self%text))
         last = end_of_text_line(self%text, first)
         if (.not. is_skipped(self%text, first, last)) then
            n_cells = count_cells(self%text, first, last)
            if (n_cells /= size(self%columns)) then
               call fail(self, 'the row has not as many cells as the header, given '//show_count(n_cells)//', allowed: ' &
                  //show_count(size(self%columns)), first, error)
               return
            end if
            if (n == size(self%rows)) then
               allocate (larger(2*n))
               larger(:n) = self%rows
               call move_alloc(larger, self%rows)
            end if
            n = n + 1
            self%rows(n) = first
         end if
         first = last + 2
      end do
      self%rows = self%rows(:n)
      if (n == 0) call set_error(error, input_failure, self%path//': no rows, needed: at least one behind the header')
   end subroutine find_rows

   !> Number of rows.
   pure integer function n_rows(self)
      !> The table.
      class(csv_table_t), intent(in) :: self

      if (allocated(self%numbers)) then
         n_rows = size(self%numbers, 1)
      else
         n_rows = size(self%rows)
      end if
   end function n_rows

   !> Place of a column, from 1; 0 if there is none of this name.
   pure integer function index_of_column(self, name)
      !> The table, the names of whose columns are compared.
      class(csv_table_t), intent(in) :: self
      !> Name of the column without its unit.
      character(*), intent(in) :: name

      index_of_column = find_column(self%columns, name)
   end function index_of_column

   !> Take a column in SI units.
   subroutine take_column(self, name, wanted, values, error)
      !> The table.
      class(csv_table_t), intent(in) :: self
      !> Name of the column without its unit.
      character(*), intent(in) :: name
      !> SI unit that is wanted, such as N or J/m^2; a hyphen for a pure number.
      character(*), intent(in) :: wanted
      !> Receives the values, NaN where a cell has none; shape `(n_rows)`.
      real(dp), allocatable, intent(out) :: values(:)
      !> Allocated if there is no such column, if it is of another quantity, or if a cell is no number.
      type(error_t), allocatable, intent(out) :: error
      type(unit_t) :: unit
      character(:), allocatable :: flaw
      integer :: k, i

      call self%get_numbers(name, values, error)
      if (allocated(error)) return
      k = self%index_of(name)
      call match_units(self%columns(k)%unit, wanted, 'column', unit, flaw)
      if (len(flaw) > 0) then
         call set_error(error, input_failure, self%path//': column '//show_text(name)//': '//flaw//', allowed: units of [' &
            //wanted//']')
         return
      end if
      do i = 1, size(values)
         if (ieee_is_nan(values(i))) cycle
         values(i) = to_si(values(i), unit)
      end do
   end subroutine take_column

   !> Take the numbers of a column as they are written, in the unit of the column.
   subroutine get_numbers(self, name, values, error)
      !> The table.
      class(csv_table_t), intent(in) :: self
      !> Name of the column without its unit.
      character(*), intent(in) :: name
      !> Receives the numbers, NaN where a cell has none; shape `(n_rows)`.
      real(dp), allocatable, intent(out) :: values(:)
      !> Allocated if there is no such column, or if a cell is no number.
      type(error_t), allocatable, intent(out) :: error
      character(:), allocatable :: flaw
      integer :: k, i, first, last

      k = self%index_of(name)
      if (k == 0) then
         call set_error(error, input_failure, self%path//': '//say_unknown_column(self%columns, name))
         return
      end if
      allocate (values(self%n_rows()))
      if (allocated(self%numbers)) then
         call take_numbers(self, k, values, error)
         return
      end if
      do i = 1, size(values)
         call find_cell(self%text, self%rows(i), k, first, last)
         call convert_cell(self%text(first:last), values(i), flaw)
         if (len(flaw) == 0) cycle
         call fail(self, 'column '//show_text(name)//': '//flaw//', allowed: a number, or an empty cell or nan where there ' &
            //'is none', first, error)
         return
      end do
   end subroutine get_numbers

   !> Take a column of a table that has no text, by the bounds of those that have one.
   subroutine take_numbers(self, column, values, error)
      !> The table.
      type(csv_table_t), intent(in) :: self
      !> Place of the column, from 1.
      integer, intent(in) :: column
      !> Receives the numbers; shape `(n_rows)`.
      real(dp), intent(out) :: values(:)
      !> Allocated if a number is out of range.
      type(error_t), allocatable, intent(out) :: error
      integer :: i

      values(:) = self%numbers(:, column)
      do i = 1, size(values)
         if (ieee_is_nan(values(i))) cycle
         if (abs(values(i)) <= largest) cycle
         call set_error(error, input_failure, self%path//': column '//show_text(self%columns(column)%name)// &
            ': out of range, given '//show_number(values(i))//' in row '//show_count(i)//', allowed: a number, or nan where ' &
            //'there is none')
         return
      end do
   end subroutine take_numbers

   !> A number from a cell.
   pure subroutine convert_cell(cell, value, flaw)
      !> Text of the cell without blanks around it.
      character(*), intent(in) :: cell
      !> Receives the number, NaN where there is none.
      real(dp), intent(out) :: value
      !> What is wrong and what was given; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw

      value = not_a_number()
      if (len(cell) == 0) then
         flaw = ''
      else if (is_nan_word(to_lower(cell))) then
         flaw = ''
      else
         call convert(cell, value, flaw)
         if (len(flaw) == 0 .and. abs(value) > largest) flaw = 'out of range, given '//show_number(value)
      end if
   end subroutine convert_cell

   !> Is it the word for no number?
   pure logical function is_nan_word(word)
      !> Text of the cell, in small letters.
      character(*), intent(in) :: word

      is_nan_word = word == 'nan' .or. word == '+nan' .or. word == '-nan'
   end function is_nan_word

   !> Line of the file in which a row stands, from 1.
   pure integer function line_of_row(self, row)
      !> The table.
      class(csv_table_t), intent(in) :: self
      !> Number of the row, from 1.
      integer, intent(in) :: row

      line_of_row = line_at(self%text, self%rows(row))
   end function line_of_row

   !> Line of a position, from 1.
   pure integer function line_at(text, position)
      !> Text of the file.
      character(*), intent(in) :: text
      !> Position in the text, from 1.
      integer, intent(in) :: position
      integer :: i

      line_at = 1
      do i = 1, position - 1
         if (text(i:i) == newline) line_at = line_at + 1
      end do
   end function line_at

   !> Report what is wrong at a place of the file.
   subroutine fail(self, flaw, position, error)
      !> The table, whose file and lines are named.
      type(csv_table_t), intent(in) :: self
      !> What is wrong, what was given, what is allowed.
      character(*), intent(in) :: flaw
      !> Position in the text of what is wrong, from 1.
      integer, intent(in) :: position
      !> Receives the report.
      type(error_t), allocatable, intent(out) :: error

      call set_error(error, input_failure, self%path//': '//flaw//' (line '//show_count(line_at(self%text, position))//')')
   end subroutine fail

end module adfric_input_csv_table
