! SPDX-License-Identifier: GPL-3.0-or-later
!> The greatest steady state of a column under a period of heights, from above.
!>
!> The steps of `adfric_foundation_stepping_steady_column` need the response J0 of a state below. They pass nothing, but converge linearly where
!> edges of adhesion move, and are short where the state below has contact that begins only far from where the steps are. So
!> - of states that are known to be below, which are those that a period raises, the one with the longest step is taken;
!> - where even that is short, J0 is taken from between, with an obstacle;
!> - Newton's steps with edges go ahead to a steady state, and `bound_response` may prove that there is no other between it and the
!>   state that the safe steps have reached. Then it is the one that is sought; else it is one more state below.
module adfric_foundation_stepping_approach_state
   use adfric_base_kinds, only: dp
   use adfric_numerics_obstacle, only: solve_above
   use adfric_foundation_stepping_law, only: stepping_law_t
   use adfric_foundation_stepping_period, only: stepped_period_t
   use adfric_foundation_stepping_response, only: bound_response
   use adfric_foundation_stepping_solid, only: product_of
   use adfric_foundation_stepping_steady_column, only: steady_column_t, start_from_below, take_edge_step, stepping, changes_flag, &
      & judge_step, &
      & move, get_steps, get_matrix, get_displacement_sums, most_edge_steps, most_periods
   use adfric_foundation_stepping_path, only: column_path_t
   implicit none (type, external)
   private
   public :: find_approach

   !> Longer steps are looked for from this period on, where they may be so many times as long, and in so many attempts.
   integer, parameter :: first_long_step = 6, most_shares = 16
   real(dp), parameter :: worth_it = 4

contains

   !> The greatest steady state, from the state that stands in `self`, which lies above it.
   pure subroutine find_approach(self, path, law, depth)
      !> In: where to start. Out: the steady state.
      type(steady_column_t), intent(inout) :: self
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      real(dp), intent(in) :: depth
      real(dp) :: steps(path%solid%n, path%solid%n + 1), sums(2)
      integer :: k
      logical :: is_solved
      type(steady_column_t) :: below

      self%is_steady = .false.
      call start_from_below(below, path, law, depth)
      call stepping(below, path, law, depth)
      call get_steps(path, below%period, steps, is_solved)
      self%has_failed = below%has_failed .or. .not. is_solved
      do k = 1, most_periods
         if (self%has_failed) return
         call stepping(self, path, law, depth)
         ! 1, 2, 4, ...
         if (iand(k, k - 1) == 0) then
            call raise_bound(self, below%period, path, law, depth, steps)
            if (.not. allocated(law%attraction)) call jump_to_proved(self, below%period, path, law, depth, steps)
            if (self%is_steady) exit
         end if
         if (.not. changes_flag(self, law)) then
            self%step = product_of(steps(:, :path%solid%n), self%period%growth)
            if (k >= first_long_step) call lengthen_step(self, path, law, depth)
         end if
         call judge_step(self, law, depth)
         if (self%is_steady) exit
         call move(self)
      end do
      self%has_failed = self%has_failed .or. .not. self%is_steady
      ! the load of the greatest state changes with its own zones
      call get_steps(path, self%period, steps, is_solved)
      call get_displacement_sums(path, self%period, 0*self%step, steps(:, path%solid%n + 1), sums)
      self%load_slope = sums(2)
   end subroutine find_approach

   !> Go to a steady state below, if there is proof that there is no other one between; else take its response for a bound.
   pure subroutine jump_to_proved(self, bound, path, law, depth, steps)
      !> In: a state above the greatest one, with its period. Out: the greatest one, if it is proved.
      type(steady_column_t), intent(inout) :: self
      !> In: the period whose response is used. Out: a better one, if there is one.
      type(stepped_period_t), intent(inout) :: bound
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      real(dp), intent(in) :: depth
      !> In: (I - J0)^-1 of the bound. Out: that of the better one.
      real(dp), intent(inout) :: steps(:, :)
      type(steady_column_t) :: trial
      real(dp) :: slope, last_step
      integer :: k
      logical :: is_proved

      if (self%has_failed .or. changes_flag(self, law)) return
      trial%state = self%state
      last_step = huge(1.0_dp)
      do k = 1, most_edge_steps
         call take_edge_step(trial, path, law, depth)
         if (trial%is_steady .or. .not. goes_on(trial, self%period, k, last_step)) exit
         last_step = trial%largest_step
         call move(trial)
      end do
      self%n_periods = self%n_periods + trial%n_periods
      if (trial%has_failed .or. .not. trial%is_steady) return
      call bound_response(path, law, trial%period, depth, self%period, depth, slope, is_proved)
      if (is_proved) then
         trial%n_periods = self%n_periods
         self = trial
      else
         call take_bound(self, trial%period, bound, path, steps)
      end if
   end subroutine jump_to_proved

   !> Is it of use to take one more of Newton's steps with edges? They end quickly, and there is a proof only with the same zones.
   pure logical function goes_on(self, period, k, last_step)
      type(steady_column_t), intent(in) :: self
      !> Period of the state from which the first step was taken.
      type(stepped_period_t), intent(in) :: period
      integer, intent(in) :: k
      !> The largest component of the step before.
      real(dp), intent(in) :: last_step

      goes_on = .not. self%has_failed
      if (k <= 2) return
      goes_on = goes_on .and. self%period%n_zones == period%n_zones .and. self%largest_step <= last_step/2
   end function goes_on

   !> Find a longer step towards the greatest state, where the bound has contact that begins only far below, and so leads to short ones.
   !> For any w below the state y let z be the higher one of w and the greatest state, for each arm. J0 of w holds between w and y, so
   !> z <= max(w, F(y) - J0 (y - z)). That is a linear problem with an obstacle, and its solution is above the greatest state.
   pure subroutine lengthen_step(self, path, law, depth)
      !> A state above the greatest one, with its period and step; receives the longer step.
      type(steady_column_t), intent(inout) :: self
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      real(dp), intent(in) :: depth
      real(dp) :: own(path%solid%n, 2), matrix(path%solid%n, path%solid%n), step(path%solid%n), share, best
      type(steady_column_t) :: obstacle
      integer :: k
      logical :: is_solved

      call get_steps(path, self%period, own, is_solved, self%period%growth)
      if (.not. is_solved) return
      best = sum(self%step)
      if (.not. sum(own(:, 1)) < worth_it*best) return
      share = 1
      obstacle%state%is_attached = self%state%is_attached
      obstacle%state%branch = self%state%branch
      do k = 1, most_shares
         obstacle%state%length = self%state%length + share*own(:, 1)
         call stepping(obstacle, path, law, depth)
         self%n_periods = self%n_periods + 1
         share = share/4
         if (obstacle%has_failed) cycle
         call get_matrix(path, obstacle%period, matrix)
         call solve_above(matrix, self%period%growth, obstacle%state%length - self%state%length, step, is_solved)
         if (.not. is_solved) cycle
         step = min(step, 0.0_dp)
         if (sum(step) < best) then
            best = sum(step)
            self%step = step
         else if (best < sum(own(:, 1))*share) then
            ! shorter paths cannot lead farther
            exit
         end if
      end do
   end subroutine lengthen_step

   !> Find a better bound of the response below the greatest state. The step with the response of the state itself may lead to a state that
   !> a period raises. Periods from there rise to a steady state, which is not above the greatest one: so the new state is below that,
   !> and its response is a bound.
   pure subroutine raise_bound(self, bound, path, law, depth, steps)
      !> A state above the greatest one, with its period.
      type(steady_column_t), intent(in) :: self
      type(stepped_period_t), intent(inout) :: bound
      type(column_path_t), intent(in) :: path
      type(stepping_law_t), intent(in) :: law
      real(dp), intent(in) :: depth
      real(dp), intent(inout) :: steps(:, :)
      type(steady_column_t) :: below
      real(dp) :: own(size(steps, 1), size(steps, 2))
      logical :: is_solved

      if (changes_flag(self, law) .or. path%solid%n == 0) return
      call get_steps(path, self%period, own, is_solved)
      if (.not. is_solved) return
      below%state%length = self%state%length + product_of(own(:, :path%solid%n), self%period%growth)
      below%state%is_attached = self%state%is_attached
      below%state%branch = self%state%branch
      if (.not. all(abs(below%state%length) <= huge(1.0_dp))) return
      call stepping(below, path, law, depth)
      if (below%has_failed .or. changes_flag(below, law) .or. .not. all(below%period%growth >= 0)) return
      call take_bound(self, below%period, bound, path, steps)
   end subroutine raise_bound

   !> Take the response of a period for a bound, if the step that follows is longer.
   pure subroutine take_bound(self, period, bound, path, steps)
      type(steady_column_t), intent(in) :: self
      !> The period of a state below the greatest one.
      type(stepped_period_t), intent(in) :: period
      !> In: the period whose response is used. Out: the better one.
      type(stepped_period_t), intent(inout) :: bound
      type(column_path_t), intent(in) :: path
      real(dp), intent(inout) :: steps(:, :)
      real(dp) :: other(size(steps, 1), size(steps, 2))
      logical :: is_solved

      call get_steps(path, period, other, is_solved)
      if (.not. is_solved) return
      associate (n => path%solid%n, growth => self%period%growth)
         if (sum(product_of(other(:, :n), growth)) >= sum(product_of(steps(:, :n), growth))) return
      end associate
      steps = other
      bound = period
   end subroutine take_bound

end module adfric_foundation_stepping_approach_state
