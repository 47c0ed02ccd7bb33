! SPDX-License-Identifier: GPL-3.0-or-later
!> Ask any model as the program does.
module model_calls
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: profile_axis_t
   implicit none (type, external)
   private
   public :: set_value, find_problems, solve_values, solve_point, axis_of

contains

   !> Set a variable by its name; an unknown name ends the program.
   subroutine set_value(model, values, group, name, value)
      class(model_t), intent(in) :: model
      real(dp), intent(inout) :: values(:)
      character(*), intent(in) :: group, name
      real(dp), intent(in) :: value
      integer :: position

      position = model%index_of(group, name)
      if (position == 0) error stop 'model_calls: no such variable'
      values(position) = value
   end subroutine set_value

   !> What the model finds wrong, a line for each problem.
   function find_problems(model, values, swept) result(text)
      class(model_t), intent(in) :: model
      real(dp), intent(in) :: values(:)
      !> Position of a swept variable.
      integer, intent(in), optional :: swept
      character(:), allocatable :: text
      type(problems_t) :: problems
      logical :: is_swept(size(values))
      integer :: k

      is_swept = .false.
      if (present(swept)) is_swept(swept) = .true.
      call model%check_values(values, is_swept, problems)
      text = ''
      do k = 1, problems%count()
         text = text//problems%line_of(k, 'case')//new_line('a')
      end do
   end function find_problems

   !> Coordinates along a profile axis.
   function axis_of(model, values, position) result(coordinates)
      class(model_t), intent(in) :: model
      real(dp), intent(in) :: values(:)
      !> Position of the axis, from 1; the slowest is the first.
      integer, intent(in) :: position
      real(dp), allocatable :: coordinates(:)
      type(profile_axis_t), allocatable :: axes(:)

      call model%get_profile_axes(values, axes)
      coordinates = axes(position)%coordinates
   end function axis_of

   !> Solve points as one block.
   subroutine solve_values(model, values, results, error_estimate, status)
      class(model_t), intent(in) :: model
      !> Shape `(n_variables, n_points)`.
      real(dp), intent(in) :: values(:, :)
      !> Shape `(n_results, n_points)`.
      real(dp), allocatable, intent(out) :: results(:, :)
      real(dp), allocatable, intent(out) :: error_estimate(:)
      integer, allocatable, intent(out) :: status(:)
      real(dp) :: counts(size(model%counts))
      integer :: n

      n = size(values, 2)
      allocate (results(size(model%results), n), error_estimate(n), status(n))
      call model%solve_block(values, results, error_estimate, status, counts)
   end subroutine solve_values

   !> Solve one point alone.
   subroutine solve_point(model, values, results, error_estimate, status)
      class(model_t), intent(in) :: model
      real(dp), intent(in) :: values(:)
      !> Shape `(n_results)`.
      real(dp), intent(out) :: results(:)
      real(dp), intent(out) :: error_estimate
      integer, intent(out) :: status
      real(dp), allocatable :: all_results(:, :), errors(:)
      integer, allocatable :: states(:)

      call solve_values(model, spread(values, 2, 1), all_results, errors, states)
      results = all_results(:, 1)
      error_estimate = errors(1)
      status = states(1)
   end subroutine solve_point

end module model_calls
