!> The grid of points of a sweep: the outer product of the swept variables.
module adfric_run_plan
   use adfric_base_kinds, only: dp, i8
   implicit none (type, external)
   private
   public :: axis_t, plan_t

   !> One swept variable.
   type :: axis_t
      !> Place of the variable in the model's table, from 1; 0: none.
      integer :: variable = 0
      !> Values that the variable takes, in the order given by the user.
      real(dp), allocatable :: values(:)
   end type axis_t

   !> Every point of a run. Points are numbered from 1; the last axis varies fastest.
   type :: plan_t
      !> Values of all variables of the model where nothing is swept; shape `(n_variables)`.
      real(dp), allocatable :: base(:)
      !> Swept variables, the slowest first; size 0 for a single point.
      type(axis_t), allocatable :: axes(:)
   contains
      procedure :: n_points
      procedure :: shape => plan_shape
      procedure :: is_swept
      procedure :: get_values
   end type plan_t

contains

   !> Number of points of the run.
   pure integer(i8) function n_points(self)
      !> The run, whose points are all combinations of the values of its axes.
      class(plan_t), intent(in) :: self

      n_points = product(self%shape())
   end function n_points

   !> Number of values of each axis, the slowest first.
   pure function plan_shape(self) result(counts)
      !> The run, the values of whose axes are counted.
      class(plan_t), intent(in) :: self
      integer(i8), allocatable :: counts(:)
      integer :: k

      counts = [(size(self%axes(k)%values, kind=i8), k=1, size(self%axes))]
   end function plan_shape

   !> Is a variable swept?
   pure logical function is_swept(self, variable)
      !> The run, whose axes are searched.
      class(plan_t), intent(in) :: self
      !> Place of the variable in the model's table, from 1.
      integer, intent(in) :: variable
      integer :: k

      is_swept = .false.
      do k = 1, size(self%axes)
         is_swept = is_swept .or. self%axes(k)%variable == variable
      end do
   end function is_swept

   !> Values of all variables at the points `first`, `first + 1`, ...
   pure subroutine get_values(self, first, values)
      !> The run, with its base values and axes.
      class(plan_t), intent(in) :: self
      !> Number of the first point, from 1.
      integer(i8), intent(in) :: first
      !> Values of all variables at n points; shape `(n_variables, n)`.
      real(dp), intent(out) :: values(:, :)
      integer(i8) :: rest
      integer :: i, k

      do i = 1, size(values, 2)
         values(:, i) = self%base
         rest = first + i - 2
         do k = size(self%axes), 1, -1
            associate (axis => self%axes(k))
               values(axis%variable, i) = axis%values(1 + mod(rest, size(axis%values, kind=i8)))
               rest = rest/size(axis%values, kind=i8)
            end associate
         end do
      end do
   end subroutine get_values

end module adfric_run_plan
