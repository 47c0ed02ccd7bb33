! SPDX-License-Identifier: GPL-3.0-or-later
!> The `&sweep` groups: which variables take which values.
module adfric_input_sweep
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: show_count, show_text, to_lower
   use adfric_input_case, only: mark_meant
   use adfric_input_group_values, only: look_up_number, take_text, take_variable
   use adfric_input_reading, only: reading_t
   use adfric_input_swept_variable, only: break_variable, check_not_twice, convert_values, put_swept
   use adfric_input_sweep_range, only: read_sweep_values
   use adfric_input_variable, only: find_outlier
   use adfric_input_vocabulary, only: sweep_names, full_name, report_unknown_names
   use adfric_run_dataset, only: dataset_t
   use adfric_run_plan, only: axis_t, new_axis
   implicit none (type, external)
   private
   public :: read_sweep, join_sweep

contains

   !> Read a sweep that goes by itself.
   subroutine read_sweep(r, group, axis)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      !> The variable and its values; not allocated if the axis cannot be used.
      type(axis_t), intent(out) :: axis
      type(dataset_t) :: dataset
      character(:), allocatable :: name, flaw
      real(dp), allocatable :: values(:)
      integer :: variable, n_before

      call report_unknown_names(r, group, sweep_names)
      call read_sweep_values(r, group, values, dataset)
      call take_variable(r, group, name, variable)
      if (variable == 0) then
         if (len(name) == 0) then
            r%input%is_broken = .true.
         else
            call mark_meant(r%model, '', name(index(name, '%') + 1:), r%input)
         end if
         return
      end if
      n_before = r%problems%count()
      call check_not_twice(r, group, variable)
      if (size(values) > 0 .and. dataset%is_given()) then
         call convert_values(r%model, variable, r%input, dataset, values, flaw)
         if (len(flaw) > 0) call r%report(group, 'values', flaw)
      else if (size(values) > 0) then
         call check_swept_range(r, group, variable, values)
      end if
      if (r%problems%count() > n_before .or. size(values) == 0) then
         call break_variable(variable, r%file%line_of(r%file%groups(group)%first), r%input)
         return
      end if
      call new_axis(axis, variable, values)
      call put_swept(variable, values(1), r%file%line_of(r%file%groups(group)%first), dataset, r%input)
   end subroutine read_sweep

   !> Let a sweep go in step with another one.
   subroutine join_sweep(r, group, axes)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      type(axis_t), intent(inout) :: axes(:)
      type(axis_t) :: axis
      integer :: k

      call read_sweep(r, group, axis)
      call find_leader(r, group, axes, k)
      if (k == 0 .or. .not. allocated(axis%variables)) return
      associate (leader => axes(k), n => size(axes(k)%values, 2))
         if (size(axis%values, 2) /= n) then
            call r%report(group, 'with', 'the sweep has not as many values as that of ' //full_name(r%model, leader%variables(1)) &
               //', given '//show_count(size(axis%values, 2))//', allowed: '//show_count(n))
            return
         end if
         leader%values = reshape([transpose(leader%values), axis%values(1, :)], [size(leader%variables) + 1, n], order=[2, 1])
         leader%variables = [leader%variables, axis%variables]
      end associate
   end subroutine join_sweep

   !> Find the sweep that another one goes in step with.
   subroutine find_leader(r, group, axes, position)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      type(axis_t), intent(in) :: axes(:)
      !> Index of the axis; 0 if there is none.
      integer, intent(out) :: position
      character(:), allocatable :: name, flaw
      integer :: n_before, leader

      position = 0
      name = ''
      n_before = r%problems%count()
      call take_text(r, group, 'with', 'the variable of another &sweep', name)
      if (r%problems%count() > n_before) return
      call look_up_number(r%model, to_lower(name), leader, flaw)
      if (leader > 0) then
         do position = 1, size(axes)
            if (allocated(axes(position)%name)) cycle
            if (axes(position)%variables(1) == leader) return
         end do
         position = 0
         ! what is wrong with its sweep has been said
         if (r%input%is_broken(leader)) return
         flaw = 'it is not swept by a &sweep of its own, given '''//show_text(name)//''', allowed: the variable of a &sweep ' &
            //'without with'
      end if
      call r%report(group, 'with', flaw)
   end subroutine find_leader

   !> Every value is within the range of the variable.
   subroutine check_swept_range(r, group, variable, values)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      !> Index of the variable in the model's table, from 1.
      integer, intent(in) :: variable
      !> Values of the sweep, at least one, in the SI unit of the variable.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: name, flaw
      integer :: first

      call find_outlier(values, r%model%variables(variable), first, flaw)
      if (first == 0) return
      name = 'values'
      if (r%file%find_assignment(group, name) == 0) name = merge('to  ', 'from', first == size(values))
      call r%report(group, trim(name), r%model%variables(variable)%name//' '//flaw)
   end subroutine check_swept_range

end module adfric_input_sweep
