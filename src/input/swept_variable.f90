! SPDX-License-Identifier: GPL-3.0-or-later
!> What groups that sweep variables have in common, be it one variable alone or several together.
module adfric_input_swept_variable
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: show_count, show_text
   use adfric_input_case, only: case_t
   use adfric_input_dataset, only: examine_values
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_reading, only: reading_t
   use adfric_input_variable, only: describe_allowed, find_outlier
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: variable_t
   use adfric_run_dataset, only: dataset_t
   implicit none (type, external)
   private
   public :: check_not_twice, convert_values, put_swept, break_variable

contains

   !> A variable is given in one index.
   subroutine check_not_twice(r, group, variable)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      !> Index of the variable in the model's table, from 1.
      integer, intent(in) :: variable
      character(:), allocatable :: where_else

      if (r%input%is_swept(variable)) then
         where_else = 'in &'//group_at(r%file, r%input%line(variable))
         if (where_else == 'in &sweep') where_else = 'in another &sweep'
      else if (r%input%is_given(variable)) then
         where_else = 'in &'//r%model%variables(variable)%group
      else
         return
      end if
      call r%report(group, 'variable', r%model%variables(variable)%name//' is given twice, here and '//where_else//' in line ' &
         //show_count(r%input%line(variable))//', allowed: one of them')
   end subroutine check_not_twice

   !> Name of the group that begins on a line; empty if none does.
   function group_at(file, line) result(name)
      type(namelist_file_t), intent(in) :: file
      !> Number of the line, from 1.
      integer, intent(in) :: line
      character(:), allocatable :: name
      integer :: i

      name = ''
      do i = 1, size(file%groups)
         if (file%line_of(file%groups(i)%first) == line) name = trim(file%groups(i)%name)
      end do
   end function group_at

   !> Convert the values of a file to the unit of a variable, and note what is known of them.
   subroutine convert_values(model, variable, input, dataset, values, flaw)
      class(model_t), intent(in) :: model
      integer, intent(in) :: variable
      !> What the groups give, on which the unit of the variable may depend.
      type(case_t), intent(in) :: input
      !> In: the names of file and dataset, and its units. Out: also range and checksum.
      type(dataset_t), intent(inout) :: dataset
      !> In: the values in their units. Out: the values in SI units.
      real(dp), intent(inout) :: values(:)
      character(:), allocatable, intent(out) :: flaw
      type(variable_t) :: row
      real(dp), allocatable :: column(:, :)
      integer :: first

      row = model%variables(variable)
      row%unit = model%unit_of(input%values, variable)
      column = reshape(values, [size(values), 1])
      call examine_values(dataset, row, column, flaw)
      values = column(:, 1)
      if (len(flaw) > 0) then
         flaw = flaw//', given '''//show_text(dataset%text)//''', allowed: '//describe_allowed(row)
         return
      end if
      ! a number as such, but perhaps no integer
      call find_outlier(values, row, first, flaw)
      if (first > 0) flaw = row%name//' '//flaw//', in '''//show_text(dataset%text)//''''
   end subroutine convert_values

   !> Take note of a variable that is swept.
   subroutine put_swept(variable, first_value, line, dataset, input)
      integer, intent(in) :: variable
      !> First value of the axis.
      real(dp), intent(in) :: first_value
      !> Line of the group that sweeps it.
      integer, intent(in) :: line
      !> The dataset or column of a file that has the values; not given if there is none.
      type(dataset_t), intent(in) :: dataset
      !> Receives the value, and that the variable is swept.
      type(case_t), intent(inout) :: input

      input%values(variable) = first_value
      input%is_swept(variable) = .true.
      input%line(variable) = line
      if (dataset%is_given()) input%datasets(variable) = dataset
   end subroutine put_swept

   !> Take note of a variable whose sweep cannot be used.
   subroutine break_variable(variable, line, input)
      integer, intent(in) :: variable, line
      !> Receives that the variable is broken, and swept unless it stands elsewhere as well.
      type(case_t), intent(inout) :: input

      input%is_broken(variable) = .true.
      if (input%line(variable) > 0) return
      input%is_swept(variable) = .true.
      input%line(variable) = line
   end subroutine break_variable

end module adfric_input_swept_variable
