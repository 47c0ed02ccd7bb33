! SPDX-License-Identifier: GPL-3.0-or-later
!> The design of a scan: all groups that say at which points a model is solved.
module adfric_input_design
   use adfric_input_cases, only: read_cases
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_reading, only: reading_t
   use adfric_input_sample, only: read_sample
   use adfric_input_sweep, only: join_sweep, read_sweep
   use adfric_run_plan, only: axis_t
   implicit none (type, external)
   private
   public :: read_axes

contains

   !> Read all axes. One that cannot be used is left out; there is a problem then.
   subroutine read_axes(r, axes)
      type(reading_t), intent(in) :: r
      !> Variables and values of the axes that can be used, in the order of the file.
      type(axis_t), allocatable, intent(out) :: axes(:)
      type(axis_t) :: axis
      integer :: i, n

      allocate (axes(count([(makes_axis(r%file, i), i=1, size(r%file%groups))])))
      n = 0
      do i = 1, size(r%file%groups)
         if (r%problems%is_enough()) exit
         if (.not. makes_axis(r%file, i)) cycle
         select case (r%file%groups(i)%name)
         case ('sweep')
            call read_sweep(r, i, axis)
         case ('cases')
            call read_cases(r, i, axis)
         case default
            call read_sample(r, i, axis)
         end select
         if (.not. allocated(axis%variables)) cycle
         n = n + 1
         call move_alloc(axis%name, axes(n)%name)
         call move_alloc(axis%variables, axes(n)%variables)
         call move_alloc(axis%values, axes(n)%values)
      end do
      if (n < size(axes)) axes = axes(:n)
      do i = 1, size(r%file%groups)
         if (r%problems%is_enough()) exit
         if (goes_with_another(r%file, i)) call join_sweep(r, i, axes)
      end do
      call check_ranges(r)
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
   subroutine check_ranges(r)
      type(reading_t), intent(in) :: r
      integer :: i

      if (r%file%find_group('sample') > 0) return
      do i = 1, size(r%file%groups)
         if (r%problems%is_enough()) exit
         if (r%file%groups(i)%name == 'range') call r%report(i, '', 'a range without a sample, needed: &sample count = ... /')
      end do
   end subroutine check_ranges

end module adfric_input_design
