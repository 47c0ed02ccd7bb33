! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `adhesive_indenter_time` with load, approach and radius of contact at a time, as fits ask for them. All points that differ
!> in nothing but the time have one history, whose steps are solved once. Between steps the results are straight; steps of a list that
!> was measured are the points themselves.
module adfric_round_fitted_adhesion
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set, unset
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_status, only: status_no_equilibrium, status_solved
   use adfric_describe_stepwise, only: steps_t
   use adfric_round_timed_adhesion_model, only: adhesive_indenter_time_t, new_adhesive_indenter_time
   use adfric_round_timed_history, only: n_given_legs, timed_input
   use adfric_round_timed_model, only: before_history
   use adfric_round_timed_rows, only: out => timed_output, p_approach, p_load, p_radius, p_time
   implicit none (type, external)
   private
   public :: fitted_adhesion_t, new_fitted_adhesion

   !> Largest error of a history that is fitted, for derivatives by differences; and fewest steps that are read between.
   real(dp), parameter :: most_error = 1.0e-5_dp
   integer, parameter :: fewest_steps = 1000
   !> Index of the time.
   integer, parameter :: time = before_history + timed_input%time

   !> The model.
   type, extends(adhesive_indenter_time_t) :: fitted_adhesion_t
   contains
      procedure :: check_values
      procedure :: solve_point
   end type fitted_adhesion_t

   !> The steps of a history.
   type, extends(point_state_t) :: adhesion_course_t
      !> Values of the variables that it belongs to; shape `(n_variables)`.
      real(dp), allocatable :: values(:)
      !> Time, approach, load and radius of contact; shape `(n_steps, 4)`.
      real(dp), allocatable :: steps(:, :)
      !> Error of approach and load, and one of `status_...`.
      real(dp) :: error = 0
      !> See `error`.
      integer :: status = status_no_equilibrium
   end type adhesion_course_t

contains

   !> The model with its tables.
   subroutine new_fitted_adhesion(self)
      !> Receives its names and its tables.
      type(fitted_adhesion_t), intent(out) :: self

      call new_adhesive_indenter_time(self%adhesive_indenter_time_t)
      ! grids come and go with what is fitted
      self%results(out%load:out%contact_radius)%has_bends = .true.
   end subroutine new_fitted_adhesion

   !> See `model_t`.
   subroutine check_values(self, values, is_swept, problems)
      class(fitted_adhesion_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      real(dp), parameter :: small = 1.0e-12_dp
      type(adhesive_indenter_time_t) :: plain
      real(dp) :: own(size(values))
      logical :: swept(size(values))

      own = values
      swept = is_swept
      own(time) = unset
      swept(time) = .false.
      plain = self%adhesive_indenter_time_t
      if (is_set(values(time))) then
         ! each curve has a history of its own, and that of the check is any, of 1 m or N
         if (is_unit(plain%lists%approaches)) plain%lists%approaches = small*plain%lists%approaches
         if (is_unit(plain%lists%base_approaches)) plain%lists%base_approaches = small*plain%lists%base_approaches
         if (is_unit(plain%lists%loads)) plain%lists%loads = small*plain%lists%loads
      end if
      call plain%check_values(own, swept, problems)
   end subroutine check_values

   !> Is a list 0 and 1?
   pure logical function is_unit(list)
      !> The list, or none.
      real(dp), allocatable, intent(in) :: list(:)

      is_unit = allocated(list)
      if (is_unit) is_unit = size(list) == 2
      if (is_unit) is_unit = all(abs(list - [0.0_dp, 1.0_dp]) <= 0)
   end function is_unit

   !> See `pointwise_model_t`.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
      class(fitted_adhesion_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> In a fit the history of the point before, or none; receives that of this point. Else the steps.
      class(point_state_t), allocatable, intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Largest error of approach and load over the largest ones.
      real(dp), intent(out) :: error_estimate
      !> One of `status_...`.
      integer, intent(out) :: status
      !> This model counts nothing; size 0.
      real(dp), intent(inout) :: counts(:)
      logical :: is_there

      if (.not. is_set(values(time))) then
         call self%adhesive_indenter_time_t%solve_point(values, state, results, error_estimate, status, counts)
         return
      end if
      is_there = .false.
      if (allocated(state)) then
         select type (state)
         type is (adhesion_course_t)
            is_there = is_same(state%values, values)
         end select
         if (.not. is_there) deallocate (state)
      end if
      if (.not. allocated(state)) call start_course(self, values, state, counts)
      error_estimate = 0
      status = status_no_equilibrium
      select type (state)
      type is (adhesion_course_t)
         status = state%status
         error_estimate = state%error
         if (status == status_solved) call read_at(state, values(time), results, status)
      end select
   end subroutine solve_point

   !> Are values the same but for the time?
   pure logical function is_same(values, others)
      !> Values of the variables at both points; shape `(n_variables)`.
      real(dp), intent(in) :: values(:), others(:)
      integer :: k

      is_same = .false.
      do k = 1, size(values)
         if (k /= time .and. abs(values(k) - others(k)) > 0) return
      end do
      is_same = .true.
   end function is_same

   !> The history of a point.
   subroutine start_course(self, values, state, counts)
      class(fitted_adhesion_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Receives the history.
      class(point_state_t), allocatable, intent(out) :: state
      real(dp), intent(inout) :: counts(:)
      class(point_state_t), allocatable :: inner
      type(adhesion_course_t), allocatable :: course
      real(dp) :: own(size(values)), unused(size(self%results))

      own = values
      own(time) = unset
      associate (tolerance => own(before_history + timed_input%relative_tolerance), &
         & per_leg => own(before_history + timed_input%steps_per_leg))
         tolerance = min(tolerance, most_error)
         if (nint(per_leg) == 0) then
            associate (legs => n_given_legs(own(before_history + 1:), self%lists))
               ! a list that was measured has a step at each point
               if (legs < fewest_steps/10) per_leg = fewest_steps/legs
            end associate
         end if
      end associate
      allocate (course)
      course%values = values
      unused = 0
      call self%adhesive_indenter_time_t%solve_point(own, inner, unused, course%error, course%status, counts)
      if (course%status == status_solved .and. allocated(inner)) then
         select type (inner)
         type is (steps_t)
            course%steps = inner%steps(:, [p_time, p_approach, p_load, p_radius])
         end select
      end if
      if (.not. allocated(course%steps)) course%status = merge(status_no_equilibrium, course%status, course%status == status_solved)
      call move_alloc(course, state)
   end subroutine start_course

   !> Results at a time.
   pure subroutine read_at(course, at, results, status)
      type(adhesion_course_t), intent(in) :: course
      !> The time [s].
      real(dp), intent(in) :: at
      real(dp), intent(inout) :: results(:)
      !> Receives one of `status_...`.
      integer, intent(out) :: status
      real(dp), parameter :: round_off = 16*epsilon(1.0_dp)
      real(dp) :: part
      integer :: low, high, middle

      low = 1
      high = size(course%steps, 1)
      associate (times => course%steps(:, 1), margin => round_off*(abs(at) + abs(course%steps(1, 1))))
         status = status_no_equilibrium
         if (at < times(low) - margin .or. at > times(high) + margin) return
         status = status_solved
         do while (high > low + 1)
            middle = (low + high)/2
            if (times(middle) <= at) then
               low = middle
            else
               high = middle
            end if
         end do
         part = 0
         if (times(high) > times(low)) part = max(0.0_dp, min(1.0_dp, (at - times(low))/(times(high) - times(low))))
      end associate
      results([out%approach, out%load, out%contact_radius]) = course%steps(low, 2:4) + part*(course%steps(high, 2:4) &
         & - course%steps(low, 2:4))
   end subroutine read_at

end module adfric_round_fitted_adhesion
