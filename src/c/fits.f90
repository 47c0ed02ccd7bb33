! SPDX-License-Identifier: GPL-3.0-or-later
!> The function of adfric.h that opens a fit of tables in memory.
module adfric_c_fits
   use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int, c_int32_t, c_int64_t, c_ptr
   use adfric_api_state, only: read_state, case_state_t
   use adfric_base_error, only: error_t, file_failure, input_failure, set_error
   use adfric_base_text, only: longest_name, show_count
   use adfric_c_cases, only: keep_case
   use adfric_c_texts, only: read_text, read_words, refuse_null, status_of, too_little_memory
   use adfric_input_text_table, only: text_table_t, new_table_of_numbers
   implicit none (type, external)
   private

   !> Most tables of a fit, and columns of a table.
   integer, parameter :: most_tables = 1000, most_columns = 1000

   !> `adfric_table` of adfric.h.
   type, bind(c) :: table_info_t
      !> Name, names of the columns, their units or null, and the numbers.
      type(c_ptr) :: name, columns, units, values
      !> Number of rows.
      integer(c_int64_t) :: n
      !> Number of columns.
      integer(c_int32_t) :: n_columns
   end type table_info_t

contains

   !> See adfric.h.
   integer(c_int) function read_fit(text, n_tables, tables, opened) bind(c, name='adfric_read_fit') result(status)
      type(c_ptr), intent(in), value :: text
      integer(c_int32_t), intent(in), value :: n_tables
      type(c_ptr), intent(in), value :: tables, opened
      type(case_state_t), pointer :: state
      type(error_t), allocatable :: error
      type(text_table_t), allocatable :: in_memory(:)
      character(:), allocatable :: input
      integer :: failure

      nullify (state)
      call refuse_null(opened, 'opened', error)
      if (.not. allocated(error)) call read_text(text, 'text', input, error)
      if (.not. allocated(error)) call take_tables(n_tables, tables, in_memory, error)
      if (.not. allocated(error)) then
         allocate (state, stat=failure)
         if (failure /= 0) call set_error(error, file_failure, too_little_memory)
      end if
      !$omp critical (adfric_api)
      if (.not. allocated(error)) call read_state(state, input, is_text=.true., error=error, tables=in_memory)
      call keep_case(state, opened, error)
      !$omp end critical (adfric_api)
      status = status_of(error)
   end function read_fit

   !> Copy the tables.
   subroutine take_tables(n, given, tables, error)
      !> Number of tables.
      integer(c_int32_t), intent(in) :: n
      !> The tables.
      type(c_ptr), intent(in) :: given
      !> Receives them.
      type(text_table_t), allocatable, intent(out) :: tables(:)
      !> Allocated if something is missing, or out of range.
      type(error_t), allocatable, intent(out) :: error
      type(table_info_t), pointer :: list(:)
      integer :: i

      if (n < 0 .or. n > most_tables) then
         call set_error(error, input_failure, 'n_tables: out of range, given '//show_count(n)//', allowed: 0 to '// &
            & show_count(most_tables))
         return
      end if
      allocate (tables(n))
      if (n == 0) return
      call refuse_null(given, 'tables', error)
      if (allocated(error)) return
      call c_f_pointer(given, list, [n])
      do i = 1, n
         call take_table(list(i), tables(i), error)
         if (allocated(error)) return
      end do
   end subroutine take_tables

   !> Copy a table.
   subroutine take_table(given, table, error)
      !> The table of the caller.
      type(table_info_t), intent(in) :: given
      !> Receives it.
      type(text_table_t), intent(out) :: table
      type(error_t), allocatable, intent(out) :: error
      character(:), allocatable :: name
      character(longest_name), allocatable :: columns(:), units(:)
      real(c_double), pointer :: values(:, :)

      call read_text(given%name, 'name', name, error)
      if (allocated(error)) return
      if (given%n < 1 .or. given%n > huge(1) .or. given%n_columns < 1 .or. given%n_columns > most_columns) then
         call set_error(error, input_failure, name//': out of range, given '//show_count(given%n)//' rows of '// &
            & show_count(given%n_columns)//' columns, allowed: at least one row, and 1 to '//show_count(most_columns)//' columns')
         return
      end if
      call refuse_null(given%values, name//': values', error)
      if (.not. allocated(error)) call read_words(given%columns, name//': columns', int(given%n_columns), columns, error)
      if (allocated(error)) return
      if (c_associated(given%units)) then
         call read_words(given%units, name//': units', int(given%n_columns), units, error)
         if (allocated(error)) return
      else
         allocate (units(given%n_columns))
         units = ''
      end if
      call c_f_pointer(given%values, values, [given%n, int(given%n_columns, c_int64_t)])
      !$omp critical (adfric_api)
      call new_table_of_numbers(table, name, columns, units, values, error)
      !$omp end critical (adfric_api)
   end subroutine take_table

end module adfric_c_fits
