! SPDX-License-Identifier: GPL-3.0-or-later
!> The points of a sweep: the outer product of its axes, along each of which one or several variables change.
module adfric_run_plan
   use adfric_base_kinds, only: dp, i8
   implicit none (type, external)
   private
   public :: axis_t, new_axis, plan_t

   !> Variables that change together, such as one that is swept alone, or all variables of a list of points.
   type :: axis_t
      !> Name of the dimension where it is none of a variable, such as `case` or `sample`; not allocated: that of the first
      !> variable, with which the others go in step.
      character(:), allocatable :: name
      !> Indices of the variables in the model's table, from 1.
      integer, allocatable :: variables(:)
      !> Values of the variables, in the order given by the user; shape `(n_variables, n_values)`.
      real(dp), allocatable :: values(:, :)
   end type axis_t

   !> Every point of a run. Points are numbered from 1; the last axis varies fastest.
   type :: plan_t
      !> Values of all variables of the model where nothing is swept; shape `(n_variables)`.
      real(dp), allocatable :: base(:)
      !> What is swept, the slowest first; size 0 for a single point.
      type(axis_t), allocatable :: axes(:)
   contains
      procedure :: n_points
      procedure :: shape => plan_shape
      procedure :: is_swept
      procedure :: values_of
      procedure :: get_values
   end type plan_t

contains

   !> An axis along which one variable changes.
   pure subroutine new_axis(self, variable, values)
      !> Receives the variable and its values.
      type(axis_t), intent(out) :: self
      !> Index of the variable in the model's table, from 1.
      integer, intent(in) :: variable
      !> Values that the variable takes, in the order given by the user.
      real(dp), intent(in) :: values(:)

      self%variables = [variable]
      allocate (self%values(1, size(values)))
      self%values(1, :) = values
   end subroutine new_axis

   !> Number of points of the run.
   pure integer(i8) function n_points(self)
      !> The run, whose points are all combinations of the values of its axes.
      class(plan_t), intent(in) :: self

      n_points = product(self%shape())
   end function n_points

   !> Number of values of each axis, the slowest first.
   pure function plan_shape(self) result(counts)
      class(plan_t), intent(in) :: self
      integer(i8), allocatable :: counts(:)
      integer :: k

      counts = [(size(self%axes(k)%values, 2, kind=i8), k=1, size(self%axes))]
   end function plan_shape

   !> Is a variable swept, alone or together with others?
   pure logical function is_swept(self, variable)
      class(plan_t), intent(in) :: self
      !> Index of the variable in the model's table, from 1.
      integer, intent(in) :: variable
      integer :: k

      is_swept = .false.
      do k = 1, size(self%axes)
         is_swept = is_swept .or. any(self%axes(k)%variables == variable)
      end do
   end function is_swept

   !> Every value that a variable takes: those of its axis, or the one of all points.
   pure function values_of(self, variable) result(values)
      class(plan_t), intent(in) :: self
      !> Index of the variable in the model's table, from 1.
      integer, intent(in) :: variable
      real(dp), allocatable :: values(:)
      integer :: j, k

      values = self%base(variable:variable)
      do k = 1, size(self%axes)
         j = findloc(self%axes(k)%variables, variable, dim=1)
         if (j > 0) values = self%axes(k)%values(j, :)
      end do
   end function values_of

   !> Values of all variables at the points `first`, `first + 1`, ...
   pure subroutine get_values(self, first, values)
      class(plan_t), intent(in) :: self
      !> Number of the first point, from 1.
      integer(i8), intent(in) :: first
      !> Values of all variables at n points; shape `(n_variables, n)`.
      real(dp), intent(out), contiguous :: values(:, :)
      integer(i8) :: indices(size(self%axes)), rest
      integer :: i, j, k

      rest = first - 1
      do k = size(self%axes), 1, -1
         associate (n => size(self%axes(k)%values, 2, kind=i8))
            indices(k) = 1 + mod(rest, n)
            rest = rest/n
         end associate
      end do
      do i = 1, size(values, 2)
         values(:, i) = self%base
         do k = 1, size(self%axes)
            associate (axis => self%axes(k))
               do j = 1, size(axis%variables)
                  values(axis%variables(j), i) = axis%values(j, indices(k))
               end do
            end associate
         end do
         call step(self, indices)
      end do
   end subroutine get_values

   !> Go to the next point.
   pure subroutine step(self, indices)
      class(plan_t), intent(in) :: self
      !> Index of the point among the values of each axis, from 1; behind the last point comes the first one.
      integer(i8), intent(inout) :: indices(:)
      integer :: k

      do k = size(indices), 1, -1
         indices(k) = indices(k) + 1
         if (indices(k) <= size(self%axes(k)%values, 2, kind=i8)) return
         indices(k) = 1
      end do
   end subroutine step

end module adfric_run_plan
