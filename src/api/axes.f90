! SPDX-License-Identifier: GPL-3.0-or-later
!> The axes of a simulation: what is swept, alone or together.
module adfric_api_axes
   use adfric_base_kinds, only: dp
   use adfric_run_plan, only: axis_t
   implicit none (type, external)
   private
   public :: put_axis, leave_out

   !> Name of the dimension of a list of points.
   character(*), parameter :: name_of_list = 'point'

contains

   !> Put an axis behind the others, or in the index of one along which the same variables change.
   subroutine put_axis(axes, variables, values)
      !> The axes, the slowest first.
      type(axis_t), allocatable, intent(inout) :: axes(:)
      !> Indices of the variables in the model's table, each once.
      integer, intent(in) :: variables(:)
      !> Values of the variables; shape `(n_variables, n_values)`.
      real(dp), intent(in) :: values(:, :)
      type(axis_t), allocatable :: longer(:)
      integer :: i, k, n

      do k = 1, size(axes)
         if (size(axes(k)%variables) /= size(variables)) cycle
         if (any(axes(k)%variables /= variables)) cycle
         axes(k)%values = values
         return
      end do
      do i = 1, size(variables)
         call leave_out(axes, variables(i))
      end do
      n = size(axes) + 1
      allocate (longer(n))
      call move_axes(axes, longer)
      longer(n)%variables = variables
      longer(n)%values = values
      ! n and not an expression: gfortran 11 would write beside the name
      if (size(variables) > 1) longer(n)%name = name_of_list
      call move_alloc(longer, axes)
   end subroutine put_axis

   !> Leave a variable out of the axes; one along which nothing else changes is left out itself.
   subroutine leave_out(axes, variable)
      !> The axes, the slowest first.
      type(axis_t), allocatable, intent(inout) :: axes(:)
      !> Index of the variable in the model's table, from 1.
      integer, intent(in) :: variable
      type(axis_t), allocatable :: shorter(:)
      logical, allocatable :: is_kept(:)
      integer, allocatable :: rows(:)
      integer :: i, k

      do k = 1, size(axes)
         if (all(axes(k)%variables /= variable)) cycle
         is_kept = axes(k)%variables /= variable
         rows = pack([(i, i=1, size(is_kept))], is_kept)
         axes(k)%variables = axes(k)%variables(rows)
         axes(k)%values = axes(k)%values(rows, :)
         if (size(rows) == 1 .and. allocated(axes(k)%name)) deallocate (axes(k)%name)
         if (size(rows) > 0) return
         allocate (shorter(size(axes) - 1))
         call move_axes(axes(k + 1:), shorter(k:))
         call move_axes(axes(:k - 1), shorter(:k - 1))
         call move_alloc(shorter, axes)
         return
      end do
   end subroutine leave_out

   !> Move axes to other indices.
   subroutine move_axes(from, to)
      !> The axes, which are empty afterwards.
      type(axis_t), intent(inout) :: from(:)
      !> Receives them, the first ones first.
      type(axis_t), intent(inout) :: to(:)
      integer :: k

      do k = 1, size(from)
         call move_alloc(from(k)%name, to(k)%name)
         call move_alloc(from(k)%variables, to(k)%variables)
         call move_alloc(from(k)%values, to(k)%values)
      end do
   end subroutine move_axes

end module adfric_api_axes
