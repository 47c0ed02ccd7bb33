! SPDX-License-Identifier: GPL-3.0-or-later
!> The design of a scan: all groups that say at which points a model is solved.
module adfric_input_design
   use adfric_base_problems, only: problems_t
   use adfric_input_case, only: case_t
   use adfric_input_cases, only: read_cases
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_sample, only: read_sample
   use adfric_input_sweep, only: join_sweep, read_sweep
   use adfric_describe_model, only: model_t
   use adfric_run_plan, only: axis_t
   implicit none (type, external)
   private
   public :: read_axes

contains

   !> Read all axes. One that cannot be used is left out; there is a problem then.
   subroutine read_axes(file, model, input, axes, problems)
      type(namelist_file_t), intent(in) :: file
      class(model_t), intent(in) :: model
      !> In: what the groups give. Out: also the first values of the axes, and what is swept or broken.
      type(case_t), intent(inout) :: input
      !> Variables and values of the axes that can be used, in the order of the file.
      type(axis_t), allocatable, intent(out) :: axes(:)
      type(problems_t), intent(inout) :: problems
      type(axis_t) :: axis
      integer :: i, n

      allocate (axes(count([(makes_axis(file, i), i=1, size(file%groups))])))
      n = 0
      do i = 1, size(file%groups)
         if (problems%is_enough()) exit
         if (.not. makes_axis(file, i)) cycle
         select case (file%groups(i)%name)
         case ('sweep')
            call read_sweep(file, i, model, input, axis, problems)
         case ('cases')
            call read_cases(file, i, model, input, axis, problems)
         case default
            call read_sample(file, i, model, input, axis, problems)
         end select
         if (.not. allocated(axis%variables)) cycle
         n = n + 1
         call move_alloc(axis%name, axes(n)%name)
         call move_alloc(axis%variables, axes(n)%variables)
         call move_alloc(axis%values, axes(n)%values)
      end do
      if (n < size(axes)) axes = axes(:n)
      do i = 1, size(file%groups)
         if (problems%is_enough()) exit
         if (goes_with_another(file, i)) call join_sweep(file, i, model, input, axes, problems)
      end do
      call check_ranges(file, problems)
   end subroutine read_axes

   !> Does a group make an axis of its own? Of `&cases` and `&sample` there may be one.
   pure logical function makes_axis(file, group)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: group

      select case (file%groups(group)%name)
      case ('sweep')
         makes_axis = .not. goes_with_another(file, group)
      case ('cases', 'sample')
         makes_axis = file%groups(group)%index == 1
      case default
         makes_axis = .false.
      end select
   end function makes_axis

   !> Is it a sweep that goes in step with another one?
   pure logical function goes_with_another(file, group)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: group

      goes_with_another = file%groups(group)%name == 'sweep' .and. file%find_assignment(group, 'with') > 0
   end function goes_with_another

   !> Ranges belong to a sample.
   subroutine check_ranges(file, problems)
      type(namelist_file_t), intent(in) :: file
      type(problems_t), intent(inout) :: problems
      integer :: i

      if (file%find_group('sample') > 0) return
      do i = 1, size(file%groups)
         if (problems%is_enough()) exit
         if (file%groups(i)%name == 'range') call file%report_variable(problems, i, '', &
            'a range without a sample, needed: &sample count = ... /')
      end do
   end subroutine check_ranges

end module adfric_input_design
