! SPDX-License-Identifier: GPL-3.0-or-later
!> The least sum of squares within bounds, by the method of Levenberg and Marquardt with the scaling of J. J. More (1978).
!>
!> At a position q with residuals r and their derivatives J the step s makes |r + J s|^2 + mu |D s|^2 least within the bounds. D are
!> the largest lengths that the columns of J have had, so that the units of q have no part in the answer. mu falls by up to 10 where
!> the sum of squares falls as foreseen (H. B. Nielsen 1999), and rises where it does not, or where there is no value at the trial
!> position.
!>
!> A variable at its bound whose gradient points out is kept there: then the conditions of Karush, Kuhn and Tucker are those of an
!> unbounded problem in the rest. A step that would cross a bound ends on it, and the others' steps are found again with that one
!> known. J = Q R is factored once a step; all the rest is done with R, whatever the number of rows.
!>
!> The search ends where the undamped step of the free variables is shorter than `step_tolerance` standard errors, |Q' r| in units
!> of the residuals, and would lower the sum of squares by less than `relative_tolerance` of it. It ends as well where no step lowers
!> the sum any more and the undamped step is shorter than ten times that, or foresees less than the round-off of the sum: with n points
!> of unknown error a step of 1e-6 standard errors lowers the sum by 1e-12/n of it, which no difference of two sums shows. A search
!> that creeps though its undamped step is long lies at a kink. No end asks how large a gradient is: that depends on units. |Q' r| is
!> the same in all units of q.
!>
!> Columns that are combinations of those before them, up to `rank_tolerance`, have no part in |Q' r|: their reflection is made of
!> round-off. The damping keeps their variables where they are.
module adfric_numerics_bounded_least_squares
   use adfric_base_kinds, only: dp
   use adfric_numerics_column_factors, only: factor_columns, solve_triangle
   implicit none (type, external)
   private
   public :: least_squares_t, squares_work_t, squares_limits_t, squares_outcome_t, new_squares_work, find_least_squares
   public :: squares_converged, squares_stuck, squares_not_converged, squares_no_value, most_variables

   !> How a search ends: at a minimum; where no step lowers the sum any more though the slope is not 0, a kink; without end; at a
   !> start that has no value.
   integer, parameter :: squares_converged = 0, squares_stuck = 1, squares_not_converged = 2, squares_no_value = 3
   !> Most variables.
   integer, parameter :: most_variables = 12
   !> First damping, and how little of the foreseen decrease is enough.
   real(dp), parameter :: first_damping = 1.0e-3_dp, least_damping = 1.0e-15_dp, enough_gain = 1.0e-4_dp
   !> Steps below this are round-off of variables of size 1.
   real(dp), parameter :: smallest_step = 1.0e-13_dp
   !> Steps that the sum cannot judge: so many times `step_tolerance`, or a foreseen decrease of that part of the sum.
   real(dp), parameter :: unjudged_step = 10.0_dp, unjudged_decrease = 64*epsilon(1.0_dp)
   !> Where a search that creeps has an undamped step longer than that, in standard errors, it lies at a kink.
   real(dp), parameter :: longest_last_step = 0.01_dp
   !> So many steps one after the other that lower the sum by less than the tolerance end the search.
   integer, parameter :: most_idle = 4

   !> A sum of squares. It may keep what helps its next evaluation.
   type, abstract :: least_squares_t
   contains
      procedure(evaluate_i), deferred :: evaluate
   end type least_squares_t

   abstract interface
      !> Residuals and their derivatives at a position, in one pass.
      subroutine evaluate_i(self, q, n_rows, r, j, cost, is_valid)
         import :: least_squares_t, dp
         implicit none (type, external)
         !> The sum of squares.
         class(least_squares_t), intent(inout) :: self
         !> The position; shape `(n)`.
         real(dp), intent(in) :: q(:)
         !> Receives the number of rows that are used here.
         integer, intent(out) :: n_rows
         !> Receives the residuals; shape `(most_rows)`.
         real(dp), intent(inout) :: r(:)
         !> Receives their derivatives; shape `(most_rows, n)`.
         real(dp), intent(inout) :: j(:, :)
         !> Receives what is to be least: the sum of squares, or another cost whose gradient is 2 J' r.
         real(dp), intent(out) :: cost
         !> Is there a value at this position?
         logical, intent(out) :: is_valid
      end subroutine evaluate_i
   end interface

   !> When a search ends.
   type :: squares_limits_t
      !> Relative decrease of the sum.
      real(dp) :: relative_tolerance = 1.0e-10_dp
      !> Length of the undamped step in standard errors.
      real(dp) :: step_tolerance = 1.0e-6_dp
      !> Number of residuals less that of variables, where the residuals' standard error is not known and follows from the sum;
      !> 0: the residuals are in standard errors.
      integer :: freedom = 0
      !> Columns that are combinations of others to this relative accuracy count as such.
      real(dp) :: rank_tolerance = 1.0e-11_dp
      !> Ends of searches that are no further apart, in standard errors, are one.
      real(dp) :: same_distance = 0.01_dp
      !> Most steps.
      integer :: most_steps = 200
   end type squares_limits_t

   !> Space for a search.
   type :: squares_work_t
      !> Rows that are used, at the position and at the trial position.
      integer :: n_rows = 0, n_trial = 0
      !> Residuals and derivatives at the position and at the trial position, and space for the factors.
      real(dp), allocatable :: r(:), j(:, :), r_trial(:), j_trial(:, :), a(:, :), b(:)
   end type squares_work_t

   !> How a search has ended.
   type :: squares_outcome_t
      !> One of `squares_...`.
      integer :: status = squares_not_converged
      !> Steps, and evaluations.
      integer :: steps = 0, evaluations = 0
      !> The least cost.
      real(dp) :: cost = 0
   end type squares_outcome_t

   !> The problem of one step: R and Q' r of the free variables, and where the step may go.
   type :: squares_step_t
      !> Number of free variables, and which ones they are.
      integer :: n = 0, position(most_variables) = 0
      !> R and Q' r.
      real(dp) :: r(most_variables, most_variables) = 0, w(most_variables) = 0
      !> Scales, bounds of the step, and the step.
      real(dp) :: scale(most_variables) = 0, low(most_variables) = 0, high(most_variables) = 0, s(most_variables) = 0
      !> Square of the length of the undamped step, in units of the residuals.
      real(dp) :: length2 = 0
   end type squares_step_t

contains

   !> Make space for a search.
   pure subroutine new_squares_work(work, most_rows, n)
      !> Receives the space.
      type(squares_work_t), intent(out) :: work
      !> Most rows that an evaluation may give.
      integer, intent(in) :: most_rows
      !> Number of variables, at most `most_variables`.
      integer, intent(in) :: n

      allocate (work%r(most_rows), work%r_trial(most_rows), work%b(most_rows), source=0.0_dp)
      allocate (work%j(most_rows, n), work%j_trial(most_rows, n), work%a(most_rows, n), source=0.0_dp)
   end subroutine new_squares_work

   !> Find the least sum of squares from a start. `work` holds residuals and derivatives at the end.
   subroutine find_least_squares(squares, lower, upper, is_fixed, limits, work, q, outcome)
      !> The sum of squares.
      class(least_squares_t), intent(inout) :: squares
      !> Bounds of the variables; shape `(n)`.
      real(dp), intent(in) :: lower(:), upper(:)
      !> Which variables stay as they are; shape `(n)`.
      logical, intent(in) :: is_fixed(:)
      !> When the search ends.
      type(squares_limits_t), intent(in) :: limits
      !> Workspace.
      type(squares_work_t), intent(inout) :: work
      !> In: the start. Out: the position found; shape `(n)`.
      real(dp), intent(inout) :: q(:)
      !> Receives how it ended.
      type(squares_outcome_t), intent(out) :: outcome
      type(squares_step_t) :: step
      real(dp) :: scale(size(q)), damping, raise, before
      integer :: idle
      logical :: is_valid, is_better

      q = min(max(q, lower), upper)
      call squares%evaluate(q, work%n_rows, work%r, work%j, outcome%cost, is_valid)
      outcome%evaluations = 1
      outcome%status = squares_no_value
      if (.not. is_valid) return
      outcome%status = squares_not_converged
      damping = first_damping
      raise = 2
      scale = 0
      idle = 0
      do while (outcome%steps < limits%most_steps)
         call prepare_step(work, lower, upper, is_fixed, limits, q, scale, step)
         if (is_at_end(step, limits, outcome%cost, idle)) then
            outcome%status = merge(squares_stuck, squares_converged, is_far_from_level(step, limits, outcome%cost))
            return
         end if
         outcome%steps = outcome%steps + 1
         before = outcome%cost
         call try_steps(squares, limits, step, work, q, damping, raise, outcome, is_better)
         if (.not. is_better) then
            outcome%status = squares_stuck
            if (is_below_judgement(step, limits, outcome%cost)) outcome%status = squares_converged
            return
         end if
         idle = merge(idle + 1, 0, before - outcome%cost <= limits%relative_tolerance*before)
      end do
   end subroutine find_least_squares

   !> Factor the columns of the free variables.
   pure subroutine prepare_step(work, lower, upper, is_fixed, limits, q, scale, step)
      !> Residuals and derivatives, and space for the factors.
      type(squares_work_t), intent(inout) :: work
      !> Bounds of the variables.
      real(dp), intent(in) :: lower(:), upper(:)
      !> Which variables stay as they are.
      logical, intent(in) :: is_fixed(:)
      !> The accuracy to which columns count as combinations of others.
      type(squares_limits_t), intent(in) :: limits
      real(dp), intent(in) :: q(:)
      !> The largest lengths that the columns have had; 0 at the beginning.
      real(dp), intent(inout) :: scale(:)
      type(squares_step_t), intent(out) :: step
      real(dp) :: gradient, length(size(q))
      integer :: k, n, m

      m = work%n_rows
      n = 0
      do k = 1, size(q)
         if (is_fixed(k)) cycle
         length(k) = norm2(work%j(:m, k))
         scale(k) = max(scale(k), length(k))
         gradient = dot_product(work%j(:m, k), work%r(:m))
         if (q(k) <= lower(k) .and. gradient > 0 .or. q(k) >= upper(k) .and. gradient < 0) cycle
         n = n + 1
         step%position(n) = k
         step%scale(n) = scale(k)
         if (.not. scale(k) > 0) step%scale(n) = 1
         step%low(n) = lower(k) - q(k)
         step%high(n) = upper(k) - q(k)
         work%a(:m, n) = work%j(:m, k)
      end do
      step%n = n
      work%b(:m) = work%r(:m)
      call factor_columns(work%a(:m, :n), work%b(:m))
      do k = 1, n
         step%r(:min(k, m), k) = work%a(:min(k, m), k)
         if (k > m) cycle
         step%w(k) = work%b(k)
         if (abs(step%r(k, k)) > limits%rank_tolerance*length(step%position(k))) step%length2 = step%length2 + step%w(k)**2
      end do
   end subroutine prepare_step

   !> Is the undamped step so short that the search has come to its end?
   pure logical function is_at_end(step, limits, cost, idle)
      type(squares_step_t), intent(in) :: step
      type(squares_limits_t), intent(in) :: limits
      !> Cost at the position.
      real(dp), intent(in) :: cost
      !> Number of steps, the last ones, that have lowered the cost by less than the tolerance.
      integer, intent(in) :: idle

      is_at_end = has_short_step(step, limits, cost) .and. step%length2 <= limits%relative_tolerance*cost .or. idle >= most_idle &
         & .or. step%n == 0 .or. .not. cost > 0
   end function is_at_end

   !> Is the undamped step shorter than the tolerance in standard errors, or round-off?
   pure logical function has_short_step(step, limits, cost)
      type(squares_step_t), intent(in) :: step
      type(squares_limits_t), intent(in) :: limits
      real(dp), intent(in) :: cost
      real(dp) :: s(step%n), variance

      variance = 1
      if (limits%freedom > 0) variance = cost/limits%freedom
      has_short_step = step%length2 <= limits%step_tolerance**2*variance
      if (has_short_step) return
      call solve_triangle(step%r(:step%n, :step%n), -step%w(:step%n), s)
      has_short_step = all(abs(s) <= 100*smallest_step)
   end function has_short_step

   !> Is the undamped step so short that a difference of two sums cannot judge it?
   pure logical function is_below_judgement(step, limits, cost)
      type(squares_step_t), intent(in) :: step
      type(squares_limits_t), intent(in) :: limits
      real(dp), intent(in) :: cost
      real(dp) :: variance

      variance = 1
      if (limits%freedom > 0) variance = cost/limits%freedom
      is_below_judgement = step%length2 <= max((unjudged_step*limits%step_tolerance)**2*variance, unjudged_decrease*cost) &
         & .or. has_short_step(step, limits, cost)
   end function is_below_judgement

   !> Is the undamped step so long that its end is no minimum of a smooth sum?
   pure logical function is_far_from_level(step, limits, cost)
      type(squares_step_t), intent(in) :: step
      type(squares_limits_t), intent(in) :: limits
      real(dp), intent(in) :: cost
      real(dp) :: variance

      variance = 1
      if (limits%freedom > 0) variance = cost/limits%freedom
      is_far_from_level = step%length2 > longest_last_step**2*variance
   end function is_far_from_level

   !> Take the first step that lowers the cost, with more and more damping.
   subroutine try_steps(squares, limits, step, work, q, damping, raise, outcome, is_better)
      class(least_squares_t), intent(inout) :: squares
      type(squares_limits_t), intent(in) :: limits
      type(squares_step_t), intent(inout) :: step
      !> In: residuals and derivatives at the position. Out: those of the new position.
      type(squares_work_t), intent(inout) :: work
      !> In: the position. Out: the new position.
      real(dp), intent(inout) :: q(:)
      !> The damping, and what the next refused step multiplies it by.
      real(dp), intent(inout) :: damping, raise
      !> Counts the evaluations, and receives the new cost.
      type(squares_outcome_t), intent(inout) :: outcome
      logical, intent(out) :: is_better
      real(dp) :: trial(size(q)), cost, foreseen, gain
      logical :: is_valid

      is_better = .false.
      do
         call solve_step(step, damping)
         foreseen = foreseen_decrease(step)
         trial = q
         trial(step%position(:step%n)) = trial(step%position(:step%n)) + step%s(:step%n)
         if (all(abs(step%s(:step%n)) <= smallest_step*max(1.0_dp, abs(q(step%position(:step%n)))))) return
         call squares%evaluate(trial, work%n_trial, work%r_trial, work%j_trial, cost, is_valid)
         outcome%evaluations = outcome%evaluations + 1
         gain = -1
         if (is_valid .and. foreseen > 0) gain = (outcome%cost - cost)/foreseen
         if (gain >= enough_gain) exit
         ! a step as short as that cannot be told from round-off of the sum
         if (is_valid .and. is_below_judgement(step, limits, outcome%cost)) return
         damping = max(damping, 1.0e-6_dp)*raise
         raise = 2*raise
         if (raise > 1.0e15_dp) return
      end do
      is_better = .true.
      damping = max(least_damping, damping*max(0.1_dp, 1 - (2*min(gain, 1.0_dp) - 1)**3))
      raise = 2
      q = trial
      outcome%cost = cost
      work%n_rows = work%n_trial
      call swap(work)
   end subroutine try_steps

   !> Let the trial position be the position.
   pure subroutine swap(work)
      type(squares_work_t), intent(inout) :: work
      real(dp), allocatable :: r(:), j(:, :)

      call move_alloc(work%r, r)
      call move_alloc(work%r_trial, work%r)
      call move_alloc(r, work%r_trial)
      call move_alloc(work%j, j)
      call move_alloc(work%j_trial, work%j)
      call move_alloc(j, work%j_trial)
   end subroutine swap

   !> The damped step within the bounds. What would cross a bound ends on it, and the rest is found again.
   pure subroutine solve_step(step, damping)
      !> The problem of the step; it receives the step.
      type(squares_step_t), intent(inout) :: step
      !> mu.
      real(dp), intent(in) :: damping
      real(dp) :: a(2*most_variables, most_variables), b(2*most_variables), s(most_variables)
      logical :: is_fixed(most_variables)
      integer :: k, n_remaining, position(most_variables), again

      is_fixed = .false.
      step%s = 0
      do again = 1, step%n
         a = 0
         b = 0
         b(:step%n) = -step%w(:step%n)
         n_remaining = 0
         do k = 1, step%n
            if (is_fixed(k)) then
               b(:step%n) = b(:step%n) - step%r(:step%n, k)*step%s(k)
            else
               n_remaining = n_remaining + 1
               position(n_remaining) = k
               a(:step%n, n_remaining) = step%r(:step%n, k)
               a(step%n + n_remaining, n_remaining) = sqrt(damping)*step%scale(k)
            end if
         end do
         if (n_remaining == 0) return
         call factor_columns(a(:step%n + n_remaining, :n_remaining), b(:step%n + n_remaining))
         call solve_triangle(a(:n_remaining, :n_remaining), b(:n_remaining), s(:n_remaining))
         associate (remaining => position(:n_remaining))
            step%s(remaining) = s(:n_remaining)
            if (all(s(:n_remaining) >= step%low(remaining) .and. s(:n_remaining) <= step%high(remaining))) return
            is_fixed(remaining) = s(:n_remaining) < step%low(remaining) .or. s(:n_remaining) > step%high(remaining)
            step%s(remaining) = min(max(s(:n_remaining), step%low(remaining)), step%high(remaining))
         end associate
      end do
   end subroutine solve_step

   !> The decrease of the sum if the residuals were linear: -2 s' R' w - |R s|^2.
   pure real(dp) function foreseen_decrease(step)
      type(squares_step_t), intent(in) :: step
      real(dp) :: change(step%n)

      change = matmul(step%r(:step%n, :step%n), step%s(:step%n))
      foreseen_decrease = -dot_product(change, 2*step%w(:step%n) + change)
   end function foreseen_decrease

end module adfric_numerics_bounded_least_squares
