! SPDX-License-Identifier: GPL-3.0-or-later
!> The `&sweep` groups: which variables take which values.
module adfric_input_sweep
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_count, show_text, to_lower
   use adfric_input_case, only: case_t, mark_meant
   use adfric_input_group_values, only: look_up_number, take_text, take_variable
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_swept_variable, only: break_variable, check_not_twice, convert_values, put_swept
   use adfric_input_sweep_range, only: read_sweep_values
   use adfric_input_variable, only: find_outlier
   use adfric_input_vocabulary, only: sweep_names, full_name, report_unknown_names
   use adfric_describe_model, only: model_t
   use adfric_run_dataset, only: dataset_t
   use adfric_run_plan, only: axis_t, new_axis
   implicit none (type, external)
   private
   public :: read_sweep, join_sweep

contains

   !> Read a sweep that goes by itself.
   subroutine read_sweep(file, group, model, input, axis, problems)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: group
      class(model_t), intent(in) :: model
      !> In: what the groups and earlier sweeps give. Out: also what this sweep does.
      type(case_t), intent(inout) :: input
      !> The variable and its values; not allocated if the axis cannot be used.
      type(axis_t), intent(out) :: axis
      type(problems_t), intent(inout) :: problems
      type(dataset_t) :: dataset
      character(:), allocatable :: name, flaw
      real(dp), allocatable :: values(:)
      integer :: variable, n_before

      call report_unknown_names(file, group, sweep_names, problems)
      call read_sweep_values(file, group, values, dataset, problems)
      call take_variable(file, group, model, name, variable, problems)
      if (variable == 0) then
         if (len(name) == 0) then
            input%is_broken = .true.
         else
            call mark_meant(model, '', name(index(name, '%') + 1:), input)
         end if
         return
      end if
      n_before = problems%count()
      call check_not_twice(file, group, model, variable, input, problems)
      if (size(values) > 0 .and. dataset%is_given()) then
         call convert_values(model, variable, input, dataset, values, flaw)
         if (len(flaw) > 0) call file%report_variable(problems, group, 'values', flaw)
      else if (size(values) > 0) then
         call check_swept_range(file, group, model, variable, values, problems)
      end if
      if (problems%count() > n_before .or. size(values) == 0) then
         call break_variable(variable, file%line_of(file%groups(group)%first), input)
         return
      end if
      call new_axis(axis, variable, values)
      call put_swept(variable, values(1), file%line_of(file%groups(group)%first), dataset, input)
   end subroutine read_sweep

   !> Let a sweep go in step with another one.
   subroutine join_sweep(file, group, model, input, axes, problems)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: group
      class(model_t), intent(in) :: model
      type(case_t), intent(inout) :: input
      type(axis_t), intent(inout) :: axes(:)
      type(problems_t), intent(inout) :: problems
      type(axis_t) :: axis
      integer :: k

      call read_sweep(file, group, model, input, axis, problems)
      call find_leader(file, group, model, input, axes, k, problems)
      if (k == 0 .or. .not. allocated(axis%variables)) return
      associate (leader => axes(k), n => size(axes(k)%values, 2))
         if (size(axis%values, 2) /= n) then
            call file%report_variable(problems, group, 'with', 'the sweep has not as many values as that of ' &
               //full_name(model, leader%variables(1))//', given '//show_count(size(axis%values, 2))//', allowed: '//show_count(n))
            return
         end if
         leader%values = reshape([transpose(leader%values), axis%values(1, :)], [size(leader%variables) + 1, n], order=[2, 1])
         leader%variables = [leader%variables, axis%variables]
      end associate
   end subroutine join_sweep

   !> Find the sweep that another one goes in step with.
   subroutine find_leader(file, group, model, input, axes, position, problems)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: group
      class(model_t), intent(in) :: model
      type(case_t), intent(in) :: input
      type(axis_t), intent(in) :: axes(:)
      !> Index of the axis; 0 if there is none.
      integer, intent(out) :: position
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: name, flaw
      integer :: n_before, leader

      position = 0
      name = ''
      n_before = problems%count()
      call take_text(file, group, 'with', 'the variable of another &sweep', name, problems)
      if (problems%count() > n_before) return
      call look_up_number(model, to_lower(name), leader, flaw)
      if (leader > 0) then
         do position = 1, size(axes)
            if (allocated(axes(position)%name)) cycle
            if (axes(position)%variables(1) == leader) return
         end do
         position = 0
         ! what is wrong with its sweep has been said
         if (input%is_broken(leader)) return
         flaw = 'it is not swept by a &sweep of its own, given '''//show_text(name)//''', allowed: the variable of a &sweep ' &
            //'without with'
      end if
      call file%report_variable(problems, group, 'with', flaw)
   end subroutine find_leader

   !> Every value is within the range of the variable.
   subroutine check_swept_range(file, group, model, variable, values, problems)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: group
      class(model_t), intent(in) :: model
      !> Index of the variable in the model's table, from 1.
      integer, intent(in) :: variable
      !> Values of the sweep, at least one, in the SI unit of the variable.
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: name, flaw
      integer :: first

      call find_outlier(values, model%variables(variable), first, flaw)
      if (first == 0) return
      name = 'values'
      if (file%find_assignment(group, name) == 0) name = merge('to  ', 'from', first == size(values))
      call file%report_variable(problems, group, trim(name), model%variables(variable)%name//' '//flaw)
   end subroutine check_swept_range

end module adfric_input_sweep
