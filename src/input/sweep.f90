! SPDX-License-Identifier: GPL-3.0-or-later
!> The `&sweep` groups: which variables take which values.
module adfric_input_sweep
   use adfric_base_kinds, only: dp, i8
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: join_words, to_lower, show_count, show_text
   use adfric_input_case, only: case_t, mark_meant
   use adfric_input_item, only: take_only_word
   use adfric_input_literal, only: convert
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_sweep_range, only: read_sweep_values
   use adfric_input_variable, only: find_outlier
   use adfric_input_vocabulary, only: sweep_names, report_unknown_names, find_variable, list_numbers, is_number
   use adfric_model_model, only: model_t
   use adfric_run_plan, only: axis_t, new_axis, plan_t
   implicit none (type, external)
   private
   public :: read_sweeps, find_size_problem

   !> Largest number of points: up to it a real number counts exactly.
   real(dp), parameter :: most_points = 2.0_dp**53

contains

   !> Read all sweeps. An axis that cannot be used is left out; there is a problem then.
   subroutine read_sweeps(file, model, input, axes, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> The model, whose table says which variables it has and what they may be.
      class(model_t), intent(in) :: model
      !> In: what the groups give. Out: also the first values of the axes, and what is swept or broken.
      type(case_t), intent(inout) :: input
      !> Variables and values of the axes that can be used, in the order of the file.
      type(axis_t), allocatable, intent(out) :: axes(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      type(axis_t) :: axis
      integer :: i, n

      allocate (axes(count(file%groups%name == 'sweep')))
      n = 0
      do i = 1, size(file%groups)
         if (file%groups(i)%name /= 'sweep') cycle
         if (problems%is_enough()) exit
         call read_axis(file, i, model, input, axis, problems)
         if (.not. allocated(axis%variables)) cycle
         n = n + 1
         call move_alloc(axis%variables, axes(n)%variables)
         call move_alloc(axis%values, axes(n)%values)
      end do
      if (n < size(axes)) axes = axes(:n)
   end subroutine read_sweeps

   !> Read one sweep.
   subroutine read_axis(file, group, model, input, axis, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the group in the file, from 1.
      integer, intent(in) :: group
      !> The model, whose table says which variables it has and what they may be.
      class(model_t), intent(in) :: model
      !> In: what the groups and earlier sweeps give. Out: also what this sweep does.
      type(case_t), intent(inout) :: input
      !> The variable and its values; not allocated if the axis cannot be used.
      type(axis_t), intent(out) :: axis
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      real(dp), allocatable :: values(:)
      integer :: variable, n_before

      call report_unknown_names(file, group, sweep_names, problems)
      call read_sweep_values(file, group, values, problems)
      call find_swept_variable(file, group, model, input, variable, problems)
      if (variable == 0) return
      n_before = problems%count()
      call check_not_twice(file, group, model, variable, input, problems)
      if (size(values) > 0) call check_swept_range(file, group, model, variable, values, problems)
      if (problems%count() > n_before .or. size(values) == 0) then
         input%is_broken(variable) = .true.
         if (input%line(variable) > 0) return
      else
         call new_axis(axis, variable, values)
         input%values(variable) = values(1)
      end if
      input%is_swept(variable) = .true.
      input%line(variable) = file%line_of(file%groups(group)%first)
   end subroutine read_axis

   !> Find which variable of the model is swept; 0 if it cannot be.
   subroutine find_swept_variable(file, group, model, input, variable, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the group in the file, from 1.
      integer, intent(in) :: group
      !> The model, whose table says which variables it has and what they may be.
      class(model_t), intent(in) :: model
      !> Receives as broken what an unknown name may mean; every variable, if there is no name.
      type(case_t), intent(inout) :: input
      !> Place of the variable in the model's table, from 1; 0 if none can be swept.
      integer, intent(out) :: variable
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: quoted, name, flaw
      integer :: number, place

      variable = 0
      number = file%find_assignment(group, 'variable')
      if (number == 0) then
         input%is_broken = .true.
         if (.not. file%groups(group)%is_garbled) call file%report_variable(problems, group, 'variable', &
            'not given, needed: the name of a variable of the model')
         return
      end if
      call take_only_word(file%value_of(number), quoted, flaw, place)
      if (len(flaw) == 0) call convert(quoted, name, flaw)
      if (len(flaw) > 0) then
         input%is_broken = .true.
         flaw = flaw//', allowed: the name of a variable of the model'
      else
         call look_up(model, to_lower(name), variable, flaw)
         if (variable == 0) call mark_meant(model, '', to_lower(name(index(name, '%') + 1:)), input)
      end if
      if (len(flaw) > 0) call file%report_variable(problems, group, 'variable', flaw, place)
   end subroutine find_swept_variable

   !> Look up the variable of a sweep, `name` or `group%name`.
   subroutine look_up(model, name, variable, flaw)
      !> The model, whose table says which variables it has and what they may be.
      class(model_t), intent(in) :: model
      !> `name` or `group%name`, in small letters.
      character(*), intent(in) :: name
      !> Place of the variable in the model's table, from 1; 0 if none can be swept.
      integer, intent(out) :: variable
      !> What is wrong, what was given, what is allowed; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw

      call find_variable(model, name, list_numbers(model), variable, flaw)
      if (variable == 0) return
      if (is_number(model%variables(variable))) return
      flaw = 'not a number, it cannot be swept, given '''//show_text(name)//''', allowed: '//join_words(list_numbers(model), ', ')
      variable = 0
   end subroutine look_up

   !> A variable is given in one place.
   subroutine check_not_twice(file, group, model, variable, input, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the group in the file, from 1.
      integer, intent(in) :: group
      !> The model, whose table says which variables it has and what they may be.
      class(model_t), intent(in) :: model
      !> Place of the variable in the model's table, from 1.
      integer, intent(in) :: variable
      !> Says which variables are given or swept already, and in which lines.
      type(case_t), intent(in) :: input
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: where_else

      if (input%is_swept(variable)) then
         where_else = 'in another &sweep'
      else if (input%is_given(variable)) then
         where_else = 'in &'//model%variables(variable)%group
      else
         return
      end if
      call file%report_variable(problems, group, 'variable', model%variables(variable)%name// &
         ' is given twice, here and '//where_else//' in line '//show_count(input%line(variable))// &
         ', allowed: one of them')
   end subroutine check_not_twice

   !> Every value is within the range of the variable.
   subroutine check_swept_range(file, group, model, variable, values, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the group in the file, from 1.
      integer, intent(in) :: group
      !> The model, whose table says which variables it has and what they may be.
      class(model_t), intent(in) :: model
      !> Place of the variable in the model's table, from 1.
      integer, intent(in) :: variable
      !> Values of the sweep, at least one, in the SI unit of the variable.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: name, flaw
      integer :: first

      call find_outlier(values, model%variables(variable), first, flaw)
      if (first == 0) return
      name = 'values'
      if (file%find_assignment(group, name) == 0) name = merge('to  ', 'from', first == size(values))
      call file%report_variable(problems, group, trim(name), model%variables(variable)%name//' '//flaw)
   end subroutine check_swept_range

   !> Is the number of points beyond all counting? Empty if it is not.
   pure function find_size_problem(plan) result(text)
      !> The run, of which the sizes of the axes count.
      type(plan_t), intent(in) :: plan
      character(:), allocatable :: text
      character(:), allocatable :: counts
      real(dp) :: n_points
      integer(i8) :: lengths(size(plan%axes))
      integer :: k

      text = ''
      counts = ''
      n_points = 1
      lengths = plan%shape()
      do k = 1, size(lengths)
         n_points = min(n_points*real(lengths(k), dp), 2*most_points)
         if (k > 1) counts = counts//' x '
         counts = counts//show_count(lengths(k))
      end do
      if (n_points > most_points) text = 'the sweep has too many points, given '//counts// &
         ', allowed: 2**53 points in all'
   end function find_size_problem

end module adfric_input_sweep
