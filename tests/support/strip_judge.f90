! SPDX-License-Identifier: GPL-3.0-or-later
!> Judges the steady state of a strip with the brute time stepping: is it one, and is there none before it on its branch?
module strip_judge
   use adfric_base_kinds, only: dp
   use adfric_foundation_adhesion, only: edge_front
   use adfric_foundation_column, only: get_column
   use adfric_foundation_saturated_adhesion, only: saturation_level
   use adfric_foundation_strip, only: strip_t, steady_state_t
   use adfric_foundation_steady_state, only: branch_adhered
   use brute_stepping, only: brute_strip_t, brute_state_t, step_one_period, column_of_gap, column_of_height, &
      & height_of
   implicit none (type, external)
   private
   public :: judge_steady_state, verdict_right, verdict_not_steady, verdict_not_first

   integer, parameter :: verdict_right = 0, verdict_not_steady = 1, verdict_not_first = 2
   !> Steps of the first trial and how often they are multiplied by four before a state is called wrong.
   integer, parameter :: first_steps = 2000, max_refinements = 5
   !> Shares of the way from the bound of the branch to the state.
   real(dp), parameter :: shares(12) = [0.0_dp, 0.1_dp, 0.25_dp, 0.5_dp, 0.7_dp, 0.8_dp, 0.9_dp, 0.95_dp, &
      & 0.97_dp, 0.98_dp, 0.99_dp, 0.995_dp]

contains

   !> Judge a state.
   pure integer function judge_steady_state(strip, state, branch) result(verdict)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      integer, intent(in) :: branch
      type(brute_strip_t) :: brute
      type(brute_state_t) :: column
      real(dp) :: section, goal, bound
      integer :: k

      associate (f => strip%foundation)
         brute = brute_strip_t(f%u, f%beta, strip%mean, strip%adhesion%stress, strip%adhesion%range, strip%adhesion%jump > 0, &
            & strip%adhesion%edge == edge_front)
         ! where the drive is least the strip is open, if it is open anywhere
         section = atan(f%v) + 3.141592653589793_dp
      end associate
      column = column_of_state(strip, state, brute, section)
      goal = height_of(brute, section, column)
      verdict = verdict_not_steady
      if (.not. is_steady(brute, section, column)) return
      if (branch == branch_adhered) then
         bound = -(strip%level + saturation_level(strip%foundation)) - 1
      else
         bound = brute%beta*(max(0.0_dp, strip%mean + 1) + 1 - strip%mean)
      end if
      verdict = verdict_not_first
      do k = 1, size(shares)
         column = column_of_height(brute, section, bound + shares(k)*(goal - bound), branch == branch_adhered)
         if (.not. moves_towards(brute, section, column, branch == branch_adhered)) return
      end do
      verdict = verdict_right
   end function judge_steady_state

   !> The column of a state at a phase.
   pure type(brute_state_t) function column_of_state(strip, state, brute, xi) result(column)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      type(brute_strip_t), intent(in) :: brute
      real(dp), intent(in) :: xi
      real(dp) :: w, p, gap

      call get_column(strip, state, xi, w, p)
      gap = w - (strip%mean + cos(xi))
      if (gap <= 4*epsilon(gap)*(1 + abs(strip%mean))) gap = min(-tiny(gap), -(p + strip%adhesion%stress))
      column = column_of_gap(brute, xi, gap, p < -strip%adhesion%stress/2)
   end function column_of_state

   !> Does a period bring the column back, the better the finer the steps?
   pure logical function is_steady(brute, section, start)
      type(brute_strip_t), intent(in) :: brute
      real(dp), intent(in) :: section
      type(brute_state_t), intent(in) :: start
      type(brute_state_t) :: column
      real(dp) :: change, coarse, height
      integer :: steps, k

      steps = first_steps
      coarse = huge(1.0_dp)
      height = height_of(brute, section, start)
      do k = 0, max_refinements
         column = start
         call step_one_period(brute, section, steps, column)
         change = abs(height_of(brute, section, column) - height)
         is_steady = change <= 1.0e-3_dp*max(abs(height), 0.1_dp) .or. change < 0.02_dp*coarse
         is_steady = is_steady .and. (column%in_contact .eqv. start%in_contact)
         if (is_steady) return
         if (k == 0) coarse = change
         steps = 4*steps
      end do
   end function is_steady

   !> Does a period bring a column up (or down), as far as the steps can tell?
   pure logical function moves_towards(brute, section, start, upwards)
      type(brute_strip_t), intent(in) :: brute
      real(dp), intent(in) :: section
      type(brute_state_t), intent(in) :: start
      logical, intent(in) :: upwards
      type(brute_state_t) :: column
      real(dp) :: moved
      integer :: steps, k

      steps = first_steps
      do k = 0, max_refinements
         column = start
         call step_one_period(brute, section, steps, column)
         moved = sheet_of(column) - sheet_of(start)
         if (abs(moved) < 0.5_dp) moved = height_of(brute, section, column) - height_of(brute, section, start)
         moves_towards = merge(moved >= 0, moved <= 0, upwards)
         if (moves_towards) return
         steps = 4*steps
      end do
   end function moves_towards

   !> Contact, adhesion, freedom: with a jump at their edges they overlap in height, and this order comes first.
   pure real(dp) function sheet_of(column)
      type(brute_state_t), intent(in) :: column

      sheet_of = merge(0.0_dp, merge(1.0_dp, 2.0_dp, column%in_adhesion), column%in_contact)
   end function sheet_of

end module strip_judge
