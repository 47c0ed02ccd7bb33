! SPDX-License-Identifier: GPL-3.0-or-later
!> A table of numbers in a text file, as instruments, spreadsheets and scripts write it (`docs/reference/tables.md`), or in memory.
!>
!> The text is kept, and a column is converted when it is taken.
module adfric_input_text_table
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_error, only: error_t, set_error, input_failure
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: newline, show_count, show_number, show_text
   use adfric_base_units, only: unit_t, to_si
   use adfric_input_head_unit, only: head_t
   use adfric_input_table_cells, only: cell_t, count_cells, find_cell, find_next_line, is_comment
   use adfric_input_table_heads, only: set_heads
   use adfric_input_table_layout, only: table_layout_t, find_layout
   use adfric_input_table_numbers, only: convert_cell
   use adfric_input_table_text, only: decode_text
   use adfric_input_unit_match, only: match_units
   use adfric_input_whole_file, only: read_whole_file
   implicit none (type, external)
   private
   public :: text_table_t, open_text_table, new_text_table, new_table_of_numbers

   !> More than anybody has in one table of text: something else was given by mistake [bytes].
   integer, parameter :: largest_table = 1000*1024**2
   !> Rows that there is space for at first.
   integer, parameter :: first_space = 64
   !> No number of physics is larger.
   real(dp), parameter :: largest = 1.0e60_dp

   !> A table.
   type :: text_table_t
      !> Name of the file, as the user gave it.
      character(:), allocatable :: path
      !> Text of the file.
      character(:), allocatable, private :: text
      !> What stands where.
      type(table_layout_t), private :: layout
      !> Position in the text of the first character of each row.
      integer, allocatable, private :: rows(:)
      !> The numbers of a table that has no text; shape `(n_rows, n_columns)`.
      real(dp), allocatable, private :: numbers(:, :)
   contains
      procedure :: n_rows
      procedure :: has_column
      procedure :: unit_of
      procedure :: take_column
      procedure :: get_numbers
      procedure :: line_of_row
      procedure :: list_names
      procedure :: describe
   end type text_table_t

contains

   !> Read a file: its layout and the index of each row. The numbers are not looked at before a column is taken.
   subroutine open_text_table(self, path, error)
      !> Receives the table; only to be used if there is no error.
      type(text_table_t), intent(out) :: self
      !> Name of the file, as the user gave it.
      character(*), intent(in) :: path
      !> Allocated if the file cannot be read (`file_failure`), or if it is no table (`input_failure`).
      type(error_t), allocatable, intent(out) :: error
      character(:), allocatable :: text

      call read_whole_file(path, text, error, 'table', largest_table)
      if (.not. allocated(error)) call new_text_table(self, path, text, error)
   end subroutine open_text_table

   !> Find the layout and the rows of a text.
   subroutine new_text_table(self, path, text, error)
      type(text_table_t), intent(out) :: self
      !> Name of the file, for messages.
      character(*), intent(in) :: path
      !> The bytes of the file; they are taken over and not allocated afterwards.
      character(:), allocatable, intent(inout) :: text
      !> Allocated if it is no table.
      type(error_t), allocatable, intent(out) :: error
      character(:), allocatable :: flaw
      integer :: index

      self%path = path
      call move_alloc(text, self%text)
      call decode_text(self%text, flaw, index)
      if (len(flaw) == 0) call find_layout(self%text, self%layout, flaw, index)
      if (len(flaw) == 0) then
         call find_rows(self, error)
      else if (index > 0) then
         call fail(self, flaw, index, error)
      else
         call set_error(error, input_failure, path//': '//flaw)
      end if
   end subroutine new_text_table

   !> A table of numbers that somebody has in memory.
   subroutine new_table_of_numbers(self, name, columns, units, numbers, error)
      !> Receives the table; only to be used if there is no error.
      type(text_table_t), intent(out) :: self
      !> Its name, by which an input knows it.
      character(*), intent(in) :: name
      !> Heads of its columns, with a unit as in a file or without; blanks at their ends do not count.
      character(*), intent(in) :: columns(:)
      !> Units that the heads have not, empty for SI units.
      character(*), intent(in) :: units(:)
      !> The numbers, NaN where there is none; shape `(n_rows, n_columns)`.
      real(dp), intent(in) :: numbers(:, :)
      !> Allocated if the shapes do not go together, or there is no row.
      type(error_t), allocatable, intent(out) :: error

      self%path = name
      if (size(columns) /= size(numbers, 2) .or. size(units) /= size(columns) .or. size(numbers) == 0) then
         call set_error(error, input_failure, name//': given numbers of shape ('//show_count(size(numbers, 1))//', '// &
            show_count(size(numbers, 2))//') with '//show_count(size(columns))//' names and '//show_count(size(units))// &
            ' units of columns, needed: at least one row, and one name and unit of each column')
         return
      end if
      call set_heads(self%layout%heads, columns, units)
      allocate (self%numbers, source=numbers)
   end subroutine new_table_of_numbers

   !> Find where each row begins. All of them have a cell for each name, and nothing behind.
   subroutine find_rows(self, error)
      type(text_table_t), intent(inout) :: self
      !> Allocated if a row has too few or too many cells, or if there is no row.
      type(error_t), allocatable, intent(out) :: error
      integer, allocatable :: larger(:)
      integer :: first, last, n, n_cells, n_filled, n_names
      logical :: is_wrong

      allocate (self%rows(first_space))
      n = 0
      n_names = self%layout%heads%n_columns()
      call find_next_line(self%text, self%layout%rows_at, first, last)
      do while (first > 0)
         if (.not. is_comment(self%text(first:last))) then
            call count_cells(self%text, first, last, self%layout%separator, n_cells, n_filled, is_wrong)
            if (is_wrong) then
               call fail(self, 'a quote is not closed, or something stands behind it, given ' &
                  //show_text(self%text(first:last)), first, error)
            else if (n_cells < n_names .or. n_filled > n_names) then
               call fail(self, 'the row has not as many cells as there are names, given '//show_count(max(n_filled, &
                  merge(n_cells, 0, n_cells < n_names)))//', allowed: '//show_count(n_names), first, error)
            end if
            if (allocated(error)) return
            if (n == size(self%rows)) then
               allocate (larger(2*n))
               larger(:n) = self%rows
               call move_alloc(larger, self%rows)
            end if
            n = n + 1
            self%rows(n) = first
         end if
         call find_next_line(self%text, last + 2, first, last)
      end do
      self%rows = self%rows(:n)
      if (n == 0) call set_error(error, input_failure, self%path//': no rows, needed: at least one behind the header')
   end subroutine find_rows

   !> Number of rows.
   pure integer function n_rows(self)
      class(text_table_t), intent(in) :: self

      if (allocated(self%numbers)) then
         n_rows = size(self%numbers, 1)
      else
         n_rows = size(self%rows)
      end if
   end function n_rows

   !> Is there a column of this name, or are there several?
   pure logical function has_column(self, name)
      class(text_table_t), intent(in) :: self
      !> Name of the column, or its whole head.
      character(*), intent(in) :: name
      integer :: index, other

      call self%layout%heads%find(name, index, other)
      has_column = index > 0
   end function has_column

   !> Unit of a column as it is written; empty where there is none, and the numbers are in SI units.
   pure function unit_of(self, name) result(unit)
      class(text_table_t), intent(in) :: self
      !> Name of a column that there is.
      character(*), intent(in) :: name
      character(:), allocatable :: unit
      type(head_t) :: head
      integer :: index, other

      call self%layout%heads%find(name, index, other)
      call self%layout%heads%get(index, head)
      unit = head%unit
   end function unit_of

   !> The names of the first columns, and how many there are more.
   pure function list_names(self) result(text)
      class(text_table_t), intent(in) :: self
      character(:), allocatable :: text

      text = self%layout%heads%list_names()
   end function list_names

   !> How the table was read, in words.
   pure function describe(self) result(text)
      class(text_table_t), intent(in) :: self
      character(:), allocatable :: text

      if (allocated(self%numbers)) then
         text = 'columns in memory'
         return
      end if
      select case (self%layout%separator)
      case (',')
         text = 'commas'
      case (';')
         text = 'semicolons'
      case (' ')
         text = 'blanks'
      case default
         text = 'tabs'
      end select
      text = 'columns between '//text
      if (self%layout%is_single) text = 'one column'
      text = text//', decimal '//trim(merge('comma', 'point', self%layout%has_decimal_comma))//', names in line ' &
         //show_count(line_at(self%text, self%layout%names_at))
      if (self%layout%units_at > 0) text = text//', units in line '//show_count(line_at(self%text, self%layout%units_at))
   end function describe

   !> Take a column in SI units.
   subroutine take_column(self, name, wanted, values, error)
      class(text_table_t), intent(in) :: self
      !> Name of the column, or its whole head.
      character(*), intent(in) :: name
      !> SI unit that is wanted, such as N or J/m^2; a hyphen for a pure number.
      character(*), intent(in) :: wanted
      !> Receives the values, NaN where a cell has none; shape `(n_rows)`.
      real(dp), allocatable, intent(out) :: values(:)
      !> Allocated if there is no such column, if it is of another quantity, or if a cell is no number.
      type(error_t), allocatable, intent(out) :: error
      type(unit_t) :: unit
      character(:), allocatable :: flaw
      integer :: i

      call self%get_numbers(name, values, error)
      if (allocated(error)) return
      call match_units(self%unit_of(name), wanted, 'column', unit, flaw)
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
      class(text_table_t), intent(in) :: self
      !> Name of the column, or its whole head.
      character(*), intent(in) :: name
      !> Receives the numbers, NaN where a cell has none; shape `(n_rows)`.
      real(dp), allocatable, intent(out) :: values(:)
      !> Allocated if there is no such column, or if a cell is no number.
      type(error_t), allocatable, intent(out) :: error
      character(:), allocatable :: flaw
      type(head_t) :: head
      type(cell_t) :: cell
      integer :: k, i, other

      call self%layout%heads%find(name, k, other)
      if (k == 0) then
         call set_error(error, input_failure, self%path//': '//self%layout%heads%say_unknown(name))
         return
      else if (other > 0) then
         call set_error(error, input_failure, self%path//': two columns have the name '//show_text(name)//', number ' &
            //show_count(min(k, other))//' and number '//show_count(max(k, other))//', allowed: one')
         return
      end if
      call self%layout%heads%get(k, head)
      if (len(head%flaw) > 0) then
         call set_error(error, input_failure, self%path//': column '//show_text(name)//': '//head%flaw &
            //', allowed: a name, or NAME [UNIT]')
         return
      end if
      allocate (values(self%n_rows()))
      if (allocated(self%numbers)) then
         call take_numbers(self, k, name, values, error)
         return
      end if
      do i = 1, size(values)
         call find_cell(self%text, self%rows(i), self%layout%separator, k, cell)
         associate (word => self%text(cell%first:cell%last))
            call convert_cell(word, self%layout%has_decimal_comma, self%layout%separator, values(i), flaw)
         end associate
         if (len(flaw) == 0) cycle
         call fail(self, 'column '//show_text(name)//': '//flaw//', allowed: a number, or an empty cell or nan where there ' &
            //'is none', cell%first, error)
         return
      end do
   end subroutine get_numbers

   !> Take a column of a table that has no text.
   subroutine take_numbers(self, column, name, values, error)
      type(text_table_t), intent(in) :: self
      !> Index of the column, from 1.
      integer, intent(in) :: column
      !> Its name, for messages.
      character(*), intent(in) :: name
      !> Receives the numbers; shape `(n_rows)`.
      real(dp), intent(out) :: values(:)
      !> Allocated if a number is out of range.
      type(error_t), allocatable, intent(out) :: error
      integer :: i

      values(:) = self%numbers(:, column)
      do i = 1, size(values)
         if (ieee_is_nan(values(i))) cycle
         if (abs(values(i)) <= largest) cycle
         call set_error(error, input_failure, self%path//': column '//show_text(name)//': out of range, given '// &
            show_number(values(i))//' in row '//show_count(i)//', allowed: a number, or nan where there is none')
         return
      end do
   end subroutine take_numbers

   !> Line of the file in which a row stands, from 1.
   pure integer function line_of_row(self, row)
      class(text_table_t), intent(in) :: self
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

   !> Report what is wrong at a index of the file.
   subroutine fail(self, flaw, position, error)
      type(text_table_t), intent(in) :: self
      character(*), intent(in) :: flaw
      !> Position in the text of what is wrong, from 1.
      integer, intent(in) :: position
      type(error_t), allocatable, intent(out) :: error

      call set_error(error, input_failure, self%path//', line '//show_count(line_at(self%text, position))//': '//flaw)
   end subroutine fail

end module adfric_input_text_table
