! SPDX-License-Identifier: GPL-3.0-or-later
!> Derivatives of results by a variable: differences between a point and its neighbours in that variable.
!>
!> With e the relative error of the results, which `error_estimate` says, a central difference of step h x has an error of about
!> e/h from the results and h^2 from the curve, in units of a result over x; h = e^(1/3) makes their sum least, and it is then
!> e^(2/3). A neighbour counts if the variable may have its value and it has the status and all states of the point. Where one
!> side does not count, the other one is taken with a second neighbour at 2 h x, whose parabola is as good to the same order; with
!> the slope of the chord where that does not count either.
module adfric_run_stencil
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_describe_model, only: model_t
   use adfric_describe_status, only: status_not_converged, status_out_of_memory
   use adfric_describe_table, only: variable_t, kind_integer
   implicit none (type, external)
   private
   public :: differentiate, solve_some, is_allowed

   !> Relative error that is taken where a model says none, as at a point without equilibrium.
   real(dp), parameter :: usual_error = 1.0e-8_dp
   !> Largest step relative to the variable, however large the error is.
   real(dp), parameter :: largest_step = 0.1_dp

   !> The points of a block on one side of it.
   type :: side_t
      !> Value of the variable; shape `(n_points)`.
      real(dp), allocatable :: x(:)
      !> Results; shape `(n_results, n_points)`.
      real(dp), allocatable :: results(:, :)
      !> Does the neighbour count?
      logical, allocatable :: counts(:)
   end type side_t

contains

   !> Derivatives of all results of a block by a variable.
   subroutine differentiate(model, variable, scale, values, results, error_estimate, status, slopes, counts, is_out_of_memory)
      class(model_t), intent(in) :: model
      !> Index of the variable, from 1.
      integer, intent(in) :: variable
      !> Size that the variable has elsewhere, for the step where it is 0.
      real(dp), intent(in) :: scale
      !> Values of the variables of each point; shape `(n_variables, n_points)`.
      real(dp), intent(in) :: values(:, :)
      !> Results of each point; shape `(n_results, n_points)`.
      real(dp), intent(in) :: results(:, :)
      !> Relative error of each point.
      real(dp), intent(in) :: error_estimate(:)
      !> Status of each point.
      integer, intent(in) :: status(:)
      !> Receives the derivatives, NaN where there is none; shape of `results`.
      real(dp), intent(out) :: slopes(:, :)
      !> What is counted at all points; that of the neighbours is added.
      real(dp), intent(inout) :: counts(:)
      !> Was there too little memory for a neighbour? Then nothing else is of use.
      logical, intent(inout) :: is_out_of_memory
      type(side_t) :: above, below, beyond
      real(dp) :: h(size(values, 2)), direction(size(values, 2))
      integer :: i

      do i = 1, size(h)
         h(i) = step_of(values(variable, i), scale, error_estimate(i))
      end do
      call solve_side(model, variable, values, results, status, h, status /= status_not_converged, above, counts, is_out_of_memory)
      call solve_side(model, variable, values, results, status, -h, status /= status_not_converged, below, counts, is_out_of_memory)
      direction = merge(1.0_dp, -1.0_dp, above%counts)
      call solve_side(model, variable, values, results, status, 2*direction*h, above%counts .neqv. below%counts, beyond, counts, &
         & is_out_of_memory)
      do i = 1, size(h)
         if (above%counts(i) .and. below%counts(i)) then
            slopes(:, i) = (above%results(:, i) - below%results(:, i))/(above%x(i) - below%x(i))
         else if (above%counts(i)) then
            slopes(:, i) = slope_at_end(values(variable, i), results(:, i), above, beyond, i)
         else if (below%counts(i)) then
            slopes(:, i) = slope_at_end(values(variable, i), results(:, i), below, beyond, i)
         else
            slopes(:, i) = not_a_number()
         end if
      end do
   end subroutine differentiate

   !> Step of a difference, > 0.
   pure real(dp) function step_of(x, scale, error_estimate)
      !> The variable at the point.
      real(dp), intent(in) :: x
      !> Size that the variable has elsewhere, > 0, for the step where it is 0.
      real(dp), intent(in) :: scale
      !> Relative error of the results; NaN if it is not known.
      real(dp), intent(in) :: error_estimate
      real(dp) :: e

      e = usual_error
      if (.not. ieee_is_nan(error_estimate)) e = max(error_estimate, epsilon(e))
      step_of = min(e**(1.0_dp/3.0_dp), largest_step)
      if (abs(x) > 0) then
         step_of = step_of*abs(x)
      else
         step_of = step_of*scale
      end if
   end function step_of

   !> Solve the neighbours on one side.
   subroutine solve_side(model, variable, values, results, status, steps, is_asked, side, counts, is_out_of_memory)
      class(model_t), intent(in) :: model
      integer, intent(in) :: variable
      real(dp), intent(in) :: values(:, :), results(:, :)
      integer, intent(in) :: status(:)
      !> Where the neighbour stands, relative to each point.
      real(dp), intent(in) :: steps(:)
      !> Of which points is the neighbour wanted?
      logical, intent(in) :: is_asked(:)
      type(side_t), intent(out) :: side
      real(dp), intent(inout) :: counts(:)
      !> Was there too little memory for a neighbour?
      logical, intent(inout) :: is_out_of_memory
      real(dp) :: shifted(size(values, 1), size(values, 2))
      integer :: found(size(status)), i

      shifted = values
      shifted(variable, :) = values(variable, :) + steps
      side%x = shifted(variable, :)
      side%counts = is_asked .and. is_allowed(side%x, model%variables(variable))
      allocate (side%results, mold=results)
      call solve_some(model, shifted, side%counts, side%results, found, counts, is_out_of_memory)
      do i = 1, size(found)
         if (side%counts(i)) side%counts(i) = found(i) == status(i) .and. has_same_states(model, side%results(:, i), results(:, i))
      end do
   end subroutine solve_side

   !> Solve some points of a list, side by side.
   subroutine solve_some(model, values, is_wanted, results, status, counts, is_out_of_memory)
      class(model_t), intent(in) :: model
      real(dp), intent(in) :: values(:, :)
      logical, intent(in) :: is_wanted(:)
      !> Receives the results, NaN for points that are not wanted; shape `(n_results, n_points)`.
      real(dp), intent(out) :: results(:, :)
      !> Receives the status, `status_not_converged` for points that are not wanted.
      integer, intent(out) :: status(:)
      !> What is counted at all points; that of these is added.
      real(dp), intent(inout) :: counts(:)
      !> Was there too little memory for a point?
      logical, intent(inout) :: is_out_of_memory
      real(dp), allocatable :: some(:, :), found(:, :), errors(:), added(:)
      integer, allocatable :: indices(:), states(:)
      integer :: i, first, last

      results = not_a_number()
      status = status_not_converged
      indices = pack([(i, i=1, size(is_wanted))], is_wanted)
      allocate (added(size(counts)))
      first = 1
      do while (first <= size(indices))
         last = first + min(model%largest_block, size(indices) - first + 1) - 1
         allocate (some, source=values(:, indices(first:last)))
         allocate (found(size(results, 1), size(some, 2)), errors(size(some, 2)), states(size(some, 2)))
         call model%solve_block(some, found, errors, states, added)
         counts = counts + added
         results(:, indices(first:last)) = found
         status(indices(first:last)) = states
         is_out_of_memory = is_out_of_memory .or. any(states == status_out_of_memory)
         deallocate (some, found, errors, states)
         first = last + 1
      end do
   end subroutine solve_some

   !> May a variable have a value?
   elemental logical function is_allowed(value, variable)
      real(dp), intent(in) :: value
      type(variable_t), intent(in) :: variable

      is_allowed = value >= variable%lower .and. value <= variable%upper .and. variable%kind /= kind_integer
      is_allowed = is_allowed .and. .not. variable%has_steps
      if (variable%lower_open) is_allowed = is_allowed .and. value > variable%lower
      if (variable%upper_open) is_allowed = is_allowed .and. value < variable%upper
   end function is_allowed

   !> Are two points in the same states, of all that the model tells?
   pure logical function has_same_states(model, a, b)
      !> The model, whose table says which results are states.
      class(model_t), intent(in) :: model
      !> Results of the two points; shape `(n_results)`.
      real(dp), intent(in) :: a(:), b(:)
      integer :: i

      has_same_states = .false.
      do i = 1, size(model%results)
         if (model%results(i)%n_states() == 0) cycle
         if (ieee_is_nan(a(i)) .neqv. ieee_is_nan(b(i))) return
         if (ieee_is_nan(a(i))) cycle
         if (nint(a(i)) /= nint(b(i))) return
      end do
      has_same_states = .true.
   end function has_same_states

   !> Slope at the end of a row of two or three points.
   pure function slope_at_end(x, results, near, far, i) result(slope)
      real(dp), intent(in) :: x, results(:)
      !> The neighbours on one side, the near ones and those at twice the distance.
      type(side_t), intent(in) :: near, far
      integer, intent(in) :: i
      real(dp) :: slope(size(results))

      slope = (near%results(:, i) - results)/(near%x(i) - x)
      if (.not. far%counts(i)) return
      slope = slope + (x - near%x(i))*((far%results(:, i) - near%results(:, i))/(far%x(i) - near%x(i)) - slope)/(far%x(i) - x)
   end function slope_at_end

end module adfric_run_stencil
