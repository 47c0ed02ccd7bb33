! SPDX-License-Identifier: GPL-3.0-or-later
!> Reference tables: lines of comments, one header line, then comma-separated values.
module reference_table
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: table_t, read_table, table_digits

   !> Relative accuracy of the tables.
   real(dp), parameter :: table_digits = 1.0e-12_dp
   integer, parameter :: longest_line = 1000, longest_cell = 80

   !> A table.
   type :: table_t
      integer :: n_rows = 0
      character(longest_cell), allocatable :: header(:)
      !> Shape `(n_columns, n_rows)`.
      character(longest_cell), allocatable :: cells(:, :)
   contains
      procedure :: text
      procedure :: number
      procedure :: label
   end type table_t

contains

   !> Read a table from the folder of the tests' references; one that cannot be read has no rows.
   subroutine read_table(self, name)
      type(table_t), intent(out) :: self
      !> File name without its ending.
      character(*), intent(in) :: name
      character(1000) :: folder
      character(longest_line) :: line
      character(longest_cell), allocatable :: row(:)
      integer :: unit, status, length

      allocate (self%header(0), self%cells(0, 0))
      call get_environment_variable('ADFRIC_TEST_REFERENCE', folder, length)
      open (newunit=unit, file=folder(:length)//'/'//name//'.csv', status='old', action='read', iostat=status)
      if (status /= 0) return
      do
         read (unit, '(a)', iostat=status) line
         if (status /= 0) exit
         if (line(1:1) == '#' .or. len_trim(line) == 0) cycle
         call split(trim(line), row)
         if (size(self%header) == 0) then
            self%header = row
         else if (size(row) == size(self%header)) then
            self%cells = reshape([self%cells, row], [size(row), self%n_rows + 1])
            self%n_rows = self%n_rows + 1
         end if
      end do
      close (unit)
   end subroutine read_table

   !> Cut a line at its commas.
   pure subroutine split(line, cells)
      character(*), intent(in) :: line
      character(longest_cell), allocatable, intent(out) :: cells(:)
      integer :: first, last, n, k

      n = 1
      do k = 1, len(line)
         if (line(k:k) == ',') n = n + 1
      end do
      allocate (cells(n))
      first = 1
      do k = 1, n
         last = first + index(line(first:)//',', ',') - 2
         cells(k) = line(first:last)
         first = last + 2
      end do
   end subroutine split

   !> A cell as text; `(none)` if there is no column whose header begins so.
   function text(self, row, column)
      class(table_t), intent(in) :: self
      integer, intent(in) :: row
      !> How the header of the column begins.
      character(*), intent(in) :: column
      character(:), allocatable :: text
      integer :: k

      text = '(none)'
      do k = size(self%header), 1, -1
         if (index(self%header(k), column) == 1) text = trim(self%cells(k, row))
      end do
   end function text

   !> A cell as a number; one that no test expects if it is none.
   real(dp) function number(self, row, column)
      class(table_t), intent(in) :: self
      integer, intent(in) :: row
      character(*), intent(in) :: column
      character(:), allocatable :: cell
      integer :: status

      cell = self%text(row, column)
      read (cell, *, iostat=status) number
      if (status /= 0) number = -1.0e99_dp
   end function number

   !> A row in words, for messages.
   function label(self, row)
      class(table_t), intent(in) :: self
      integer, intent(in) :: row
      character(:), allocatable :: label
      integer :: k

      label = ''
      do k = 1, size(self%header)
         label = label//' '//trim(self%cells(k, row))
      end do
   end function label

end module reference_table
