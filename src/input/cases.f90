! SPDX-License-Identifier: GPL-3.0-or-later
!> `&cases`: several variables that change together, as a table of a file has them.
module adfric_input_cases
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: join_words, longest_name, show_count, show_text
   use adfric_base_words, only: count_words, get_word
   use adfric_hdf5_members, only: find_members
   use adfric_input_dataset, only: load_numbers, take_numbers
   use adfric_input_group_values, only: look_up_number, take_text, take_words
   use adfric_input_reading, only: reading_t
   use adfric_input_swept_variable, only: break_variable, check_not_twice, convert_values, put_swept
   use adfric_input_table_name, only: is_table_name
   use adfric_input_text_table, only: text_table_t, open_text_table
   use adfric_input_vocabulary, only: cases_names, list_numbers, report_unknown_names
   use adfric_run_dataset, only: dataset_t
   use adfric_run_plan, only: axis_t
   implicit none (type, external)
   private
   public :: read_cases, case_axis

   !> Name of the dimension.
   character(*), parameter :: case_axis = 'case'
   !> What may be given for `file`.
   character(*), parameter :: allowed_files = '''FILE.csv'' or ''FILE.h5:/GROUP'''
   !> What stands between the name of a file and that of a group, with which the latter begins.
   character(*), parameter :: divider = ':/'

   !> The table.
   type :: case_source_t
      !> Name of the file.
      character(:), allocatable :: file
      !> Name of the group; not allocated for a table of text.
      character(:), allocatable :: path
      !> The table of text.
      type(text_table_t) :: table
   end type case_source_t

contains

   !> Read a table of cases.
   subroutine read_cases(r, group, axis)
      type(reading_t), intent(in) :: r
      !> Number of `&cases` in the file, from 1.
      integer, intent(in) :: group
      !> The variables and their values; not allocated if the axis cannot be used.
      type(axis_t), intent(out) :: axis
      type(case_source_t) :: source
      type(dataset_t), allocatable :: columns(:)
      character(:), allocatable :: names
      real(dp), allocatable :: values(:, :)
      integer, allocatable :: indices(:)
      integer :: k, n_before, line

      n_before = r%problems%count()
      line = r%file%line_of(r%file%groups(group)%first)
      call report_unknown_names(r, group, cases_names)
      call open_source(r, group, source)
      names = ''
      if (r%problems%count() == n_before) call choose_names(r, group, source, names)
      call find_indices(r, group, names, indices)
      do k = 1, size(indices)
         call check_not_twice(r, group, indices(k))
      end do
      if (r%problems%count() == n_before) call read_columns(r, group, source, names, indices, columns, values)
      if (r%problems%count() > n_before) then
         ! what it should have given is not missing
         if (size(indices) == 0) r%input%is_broken = .true.
         do k = 1, size(indices)
            call break_variable(indices(k), line, r%input)
         end do
         return
      end if
      axis%name = case_axis
      axis%variables = indices
      axis%values = transpose(values)
      do k = 1, size(indices)
         call put_swept(indices(k), values(1, k), line, columns(k), r%input)
      end do
   end subroutine read_cases

   !> Find the table.
   subroutine open_source(r, group, source)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      !> Receives the names of file and group, or the open table.
      type(case_source_t), intent(out) :: source
      type(error_t), allocatable :: error
      character(:), allocatable :: name
      integer :: colon, n_before

      if (r%file%groups(group)%is_garbled) return
      if (r%file%find_assignment(group, 'file') == 0) then
         call r%report(group, 'file', 'not given, needed: '//allowed_files)
         return
      end if
      name = ''
      n_before = r%problems%count()
      call take_text(r, group, 'file', allowed_files, name)
      if (r%problems%count() > n_before) return
      colon = index(name, divider, back=.true.)
      if (len(name) > longest_name) then
         call r%report(group, 'file', 'too long for the name of a file, given '''//show_text(name)//'''')
      else if (is_table_name(name)) then
         source%file = name
         call open_text_table(source%table, name, error)
         if (allocated(error)) call r%report(group, 'file', error%message)
      else if (colon > 1) then
         source%file = name(:colon - 1)
         source%path = name(colon + 1:)
      else
         call r%report(group, 'file', 'names no table, given '''//show_text(name)//''', allowed: '//allowed_files)
      end if
   end subroutine open_source

   !> Which columns are wanted: those of `variables`, else all that have the name of a numeric variable.
   subroutine choose_names(r, group, source, names)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      type(case_source_t), intent(in) :: source
      !> Receives the names, separated by a blank; empty if something is wrong.
      character(:), allocatable, intent(inout) :: names
      character(:), allocatable :: known, flaw, there
      logical, allocatable :: exists(:)
      integer :: k

      call take_words(r, group, 'variables', 'names of variables of the model', names)
      if (r%file%find_assignment(group, 'variables') > 0) return
      known = list_numbers(r%model)
      flaw = ''
      there = ''
      allocate (exists(count_words(known)), source=.false.)
      if (allocated(source%path)) then
         call find_members(source%file, source%path, known, exists, flaw)
      else
         there = source%table%list_names()
         do k = 1, size(exists)
            exists(k) = source%table%has_column(get_word(known, k))
         end do
      end if
      do k = 1, size(exists)
         if (exists(k)) names = trim(adjustl(names//' '//get_word(known, k)))
      end do
      if (len(flaw) == 0 .and. len(names) == 0) then
         flaw = 'no column has the name of a numeric variable'
         if (len(there) > 0) flaw = flaw//', there are '//there
      end if
      if (len(flaw) > 0) call r%report(group, 'file', flaw//', given '''//show_text(source%file) &
         //''', allowed: columns with the names '//join_words(known, ', '))
   end subroutine choose_names

   !> Find the variables of the columns.
   subroutine find_indices(r, group, names, indices)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      !> Names of the columns, separated by a blank.
      character(*), intent(in) :: names
      !> Receives the indices of the variables in the model's table.
      integer, allocatable, intent(out) :: indices(:)
      character(:), allocatable :: flaw
      integer :: k, position

      allocate (indices(0))
      do k = 1, count_words(names)
         call look_up_number(r%model, get_word(names, k), position, flaw)
         if (len(flaw) == 0 .and. any(indices == position)) flaw = 'given twice, '''//get_word(names, k)//''''
         if (len(flaw) > 0) then
            call r%report(group, 'variables', flaw)
         else
            indices = [indices, position]
         end if
      end do
   end subroutine find_indices

   !> Read the columns in SI units.
   subroutine read_columns(r, group, source, names, indices, columns, values)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      type(case_source_t), intent(in) :: source
      character(*), intent(in) :: names
      !> Indices of the variables in the model's table.
      integer, intent(in) :: indices(:)
      type(dataset_t), allocatable, intent(out) :: columns(:)
      !> Receives the values; shape `(n_cases, n_variables)`.
      real(dp), allocatable, intent(out) :: values(:, :)
      character(:), allocatable :: flaw
      real(dp), allocatable :: numbers(:, :)
      integer :: k

      allocate (columns(size(indices)))
      do k = 1, size(indices)
         call load_column(source, get_word(names, k), columns(k), numbers, flaw)
         if (len(flaw) == 0) call convert_values(r%model, indices(k), r%input, columns(k), numbers(:, 1), flaw)
         if (len(flaw) == 0) then
            if (k == 1) allocate (values(size(numbers, 1), size(indices)))
            if (size(numbers, 1) /= size(values, 1)) flaw = get_word(names, 1)//' and '//get_word(names, k)// &
               ' have not as many values, '//show_count(size(values, 1))//' and '//show_count(size(numbers, 1))
         end if
         if (len(flaw) > 0) then
            call r%report(group, 'file', flaw)
            return
         end if
         values(:, k) = numbers(:, 1)
      end do
   end subroutine read_columns

   !> Read a column as the file has it.
   subroutine load_column(source, name, column, numbers, flaw)
      type(case_source_t), intent(in) :: source
      !> Name of the column.
      character(*), intent(in) :: name
      !> Receives its names, its shape and its units.
      type(dataset_t), intent(inout) :: column
      !> Receives the numbers; shape `(n, 1)`.
      real(dp), allocatable, intent(out) :: numbers(:, :)
      !> What is wrong with the file or the column; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw

      column%file = source%file
      if (allocated(source%path)) then
         column%path = source%path
         if (column%path /= '/') column%path = column%path//'/'
         column%path = column%path//name
         column%text = column%file//':'//column%path
         call load_numbers(column, 1, numbers, flaw)
         if (len(flaw) > 0) flaw = flaw//', given '''//show_text(column%text)//''''
      else
         column%is_column = .true.
         column%path = name
         column%text = column%file//':'//name
         call take_numbers(source%table, column, numbers, flaw)
      end if
   end subroutine load_column

end module adfric_input_cases
