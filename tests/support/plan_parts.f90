! SPDX-License-Identifier: GPL-3.0-or-later
!> Parts of plans and runs for tests.
module plan_parts
   use adfric_base_kinds, only: dp
   use adfric_describe_model, only: model_t
   use adfric_run_plan, only: plan_t, axis_t, new_axis
   use adfric_run_run, only: run_t, new_run
   implicit none (type, external)
   private
   public :: new_plan, new_run_of, add_axis

contains

   !> A single point.
   subroutine new_plan(plan, base)
      type(plan_t), intent(out) :: plan
      real(dp), intent(in) :: base(:)

      plan%base = base
      allocate (plan%axes(0))
   end subroutine new_plan

   !> A run of a single point, by a copy of a model.
   subroutine new_run_of(run, model, base)
      type(run_t), intent(out) :: run
      class(model_t), intent(in) :: model
      real(dp), intent(in) :: base(:)
      class(model_t), allocatable :: copy

      allocate (copy, source=model)
      call new_run(run, copy)
      run%plan%base = base
   end subroutine new_run_of

   !> Add a swept variable that varies faster than those before it. (The shorter `[axis_t(...), ...]` loses its memory
   !> under gfortran 12.)
   subroutine add_axis(plan, variable, values)
      type(plan_t), intent(inout) :: plan
      integer, intent(in) :: variable
      real(dp), intent(in) :: values(:)
      type(axis_t), allocatable :: axes(:)
      integer :: k, n

      n = size(plan%axes)
      allocate (axes(n + 1))
      do k = 1, n
         axes(k) = plan%axes(k)
      end do
      call new_axis(axes(n + 1), variable, values)
      call move_alloc(axes, plan%axes)
   end subroutine add_axis

end module plan_parts
