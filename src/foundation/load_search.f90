! SPDX-License-Identifier: GPL-3.0-or-later
!> The penetration that carries a load, on the branch of the surface: from above the largest, from below the smallest.
!>
!> Loading and unloading meet a state where the load passes the one that is sought, so a search must not pass one. From a
!> penetration that carries too much it is certain that nothing is passed within the reach of `get_reach`. A longer step is
!> kept only where the load between its ends is plain (`is_plain`); otherwise its far end is put aside, and the stretch between
!> is halved until it is certain or plain. What remains when both ends are indistinct is a jump, which passes no state: with
!> rising penetration the load jumps downwards only.
module adfric_foundation_load_search
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_foundation_crosswise, only: memory_t
   use adfric_foundation_load_trial, only: trial_t, try_near, carries_load, get_reach, get_fall, has_moving_edges, is_plain, &
      & is_past_least, indistinct
   use adfric_foundation_surface, only: surface_t
   implicit none (type, external)
   private
   public :: find_first_state, find_entry, downwards, upwards, search_found, search_empty

   !> The path of a search, towards smaller or larger penetrations.
   integer, parameter :: downwards = -1, upwards = 1
   !> How a search ends: a state, no state for certain, or neither.
   integer, parameter :: search_found = 1, search_empty = 2, search_failed = 3
   !> Trials of one search, and those that may be put aside at once.
   integer, parameter :: max_trials = 20000, max_aside = 64
   !> Longest step [h], of a surface whose stress and range are small.
   real(dp), parameter :: longest_step = 0.05_dp

   !> Trials put aside: the last one is the next on the path.
   type :: aside_t
      !> Number of trials put aside.
      integer :: n = 0
      !> The trials; those behind `n` have no meaning.
      type(trial_t) :: trials(max_aside)
   end type aside_t

contains

   !> The first penetration that carries a load, on the path from one that does not: downwards the largest, from where all above
   !> carry more; upwards the smallest, from one that carries less.
   pure subroutine find_first_state(surface, load, direction, has_turned, limit, memory, near, far, outcome)
      type(surface_t), intent(in) :: surface
      !> Load that is sought, per period in x (and y) [h/K].
      real(dp), intent(in) :: load
      !> The path of the search, `downwards` or `upwards`.
      integer, intent(in) :: direction
      !> Does the search begin where the load has just turned? Downwards: from falling on the way to rising. Upwards: the surface
      !> has just been drawn in, so `near` may carry the load to within its tolerance where the load still falls, and that is not
      !> the state that is sought.
      logical, intent(in) :: has_turned
      !> Beyond this penetration nothing is sought [h].
      real(dp), intent(in) :: limit
      !> Strips found before, as first guesses; they save time and change nothing. Out: those found here.
      type(memory_t), intent(inout) :: memory
      !> In: the penetration where the search begins. Out: the last one on the path before the state, if one is found.
      type(trial_t), intent(inout) :: near
      !> If a state is found, a penetration beyond it; the state is the only one between the two.
      type(trial_t), intent(out) :: far
      !> How the search ends, one of `search_...`.
      integer, intent(out) :: outcome
      type(aside_t) :: aside
      type(trial_t) :: last
      real(dp) :: sure, next
      logical :: is_turn, is_over
      integer :: k

      if (has_asserts) call assert(direction == downwards .or. direction == upwards, 'find_first_state: the way is known')
      outcome = search_found
      last = near
      is_turn = has_turned
      do k = 1, max_trials
         far = near
         if (direction == downwards) then
            is_turn = (is_turn .and. near%totals%structure == last%totals%structure) .or. near%totals%load_slope > 0
         else
            is_turn = is_turn .and. .not. near%excess > last%excess
         end if
         if (carries_load(surface, near) .and. .not. (direction == upwards .and. is_turn)) return
         if (aside%n == 0) then
            call step_on(surface, direction, is_turn, limit, near, last, next, is_over)
            if (is_over) exit
         else
            far = aside%trials(aside%n)
            sure = get_sure(surface, direction, near, far%totals%slope_bound)
            if (is_clear(surface, direction, is_turn, sure, near, far, aside%trials(max(aside%n - 1, 1)))) then
               if (merge(far%excess < 0, far%excess >= 0, direction == downwards)) return
               last = near
               near = far
               aside%n = aside%n - 1
               cycle
            end if
            next = divide(near%penetration, sure, far%penetration)
         end if
         call add_trial(surface, next, near%penetration, load, memory, aside, outcome)
         if (outcome == search_failed) return
      end do
      outcome = merge(search_empty, search_failed, k <= max_trials)
   end subroutine find_first_state

   !> The next penetration of a search where no trial is put aside.
   pure subroutine step_on(surface, direction, is_turn, limit, near, last, next, is_over)
      type(surface_t), intent(in) :: surface
      integer, intent(in) :: direction
      !> Has the load just turned? Upwards it still falls then.
      logical, intent(in) :: is_turn
      real(dp), intent(in) :: limit
      !> The trial where the search stands, and the one before it.
      type(trial_t), intent(in) :: near, last
      !> The next penetration [h].
      real(dp), intent(out) :: next
      !> Is there nothing to seek before the limit?
      logical, intent(out) :: is_over
      real(dp) :: sure

      if (direction == downwards) then
         sure = get_sure(surface, direction, near, near%totals%slope_bound)
         is_over = sure <= limit
         next = min(sure, near%penetration - get_step(surface, near, last))
      else
         is_over = near%penetration >= limit
         ! the slope is 1 at most
         sure = get_sure(surface, direction, near, 1.0_dp)
         next = near%penetration + get_longest_step(surface)
         if (.not. is_turn) next = near%penetration + get_step(surface, near, last)
         next = max(sure, min(next, limit))
      end if
   end subroutine step_on

   !> The penetration up to which a search passes no state for certain [h].
   pure real(dp) function get_sure(surface, direction, near, slope_bound) result(sure)
      type(surface_t), intent(in) :: surface
      integer, intent(in) :: direction
      type(trial_t), intent(in) :: near
      !> Bound of the slope up to the furthest penetration in question [1/K]; downwards the trial has its own.
      real(dp), intent(in) :: slope_bound

      if (direction == downwards) then
         sure = near%penetration - get_fall(surface, near)
      else
         sure = near%penetration + get_reach(near, slope_bound)
      end if
   end function get_sure

   !> Is no state passed on the path from one trial to the next, but for one that is crossed?
   pure logical function is_clear(surface, direction, is_turn, sure, near, far, further)
      type(surface_t), intent(in) :: surface
      integer, intent(in) :: direction
      !> Downwards: does the load rise with the penetration somewhere above `near`, between the same regimes?
      logical, intent(in) :: is_turn
      !> The penetration up to which no state is passed for certain [h].
      real(dp), intent(in) :: sure
      !> The trial where the search stands, the next one on the path, and the one behind that, or once more the next one.
      type(trial_t), intent(in) :: near, far, further

      is_clear = direction*(far%penetration - sure) <= 0 .or. is_one(far%penetration, sure)
      if (is_clear) return
      if (direction == upwards) then
         is_clear = is_plain(surface, near, far, far)
      else
         is_clear = is_plain(surface, far, near, far)
         if (.not. is_clear .and. far%excess > 0) is_clear = is_past_least(surface, is_turn, further, far, near)
      end if
   end function is_clear

   !> The smallest penetration that carries less than a load, for a surface that adhesion draws in. What carries more is
   !> certain downwards from each trial.
   pure subroutine find_entry(surface, load, highest, memory, low, outcome)
      type(surface_t), intent(in) :: surface
      !> Load that the penetration sought does not reach, per period in x (and y) [h/K].
      real(dp), intent(in) :: load
      !> Above this penetration all carry more [h].
      real(dp), intent(in) :: highest
      type(memory_t), intent(inout) :: memory
      !> In: a penetration below which none carries less than the load. Out: the first that carries less.
      type(trial_t), intent(inout) :: low
      integer, intent(out) :: outcome
      type(aside_t) :: aside
      type(trial_t) :: high
      real(dp) :: sure, next
      integer :: k

      outcome = search_found
      do k = 1, max_trials
         if (low%excess < 0) return
         if (aside%n == 0) then
            if (low%penetration >= highest) exit
            ! a load that is met to the last digit would have no step at all
            next = low%penetration + max(get_step(surface, low, low), indistinct*max(1.0_dp, abs(low%penetration)))
            next = min(next, highest)
         else
            high = aside%trials(aside%n)
            sure = high%penetration
            if (high%excess >= 0) sure = sure - get_reach(high, high%totals%slope_bound)
            if (sure <= low%penetration .or. is_one(low%penetration, sure) .or. &
               & (high%excess >= 0 .and. is_plain(surface, low, high, low))) then
               low = high
               aside%n = aside%n - 1
               cycle
            end if
            next = divide(high%penetration, sure, low%penetration)
         end if
         call add_trial(surface, next, low%penetration, load, memory, aside, outcome)
         if (outcome == search_failed) return
      end do
      outcome = merge(search_empty, search_failed, k <= max_trials)
   end subroutine find_entry

   !> Solve one more penetration, and put it aside.
   pure subroutine add_trial(surface, penetration, from, load, memory, aside, outcome)
      type(surface_t), intent(in) :: surface
      !> The penetration, and the one from which it is reached [h].
      real(dp), intent(in) :: penetration, from
      real(dp), intent(in) :: load
      type(memory_t), intent(inout) :: memory
      !> Trials put aside; the new one comes last.
      type(aside_t), intent(inout) :: aside
      !> `search_failed` if the penetration has no state; else as it was.
      integer, intent(inout) :: outcome

      if (aside%n < max_aside) aside%n = aside%n + 1
      associate (trial => aside%trials(aside%n))
         call try_near(surface, penetration, from, load, memory, trial)
         if (.not. trial%totals%is_converged) outcome = search_failed
      end associate
   end subroutine add_trial

   !> Where a stretch is divided [h]: in the middle of what is not certain, or where that begins, if it is the smaller part.
   pure real(dp) function divide(start, sure, finish)
      !> The ends of the stretch, and how far from its start it is certain [h].
      real(dp), intent(in) :: start, sure, finish

      divide = sure
      if (abs(finish - sure) > abs(sure - start)) divide = sure + (finish - sure)/2
   end function divide

   !> Are two penetrations as good as one?
   pure logical function is_one(one, other)
      !> The two penetrations [h].
      real(dp), intent(in) :: one, other

      is_one = abs(other - one) <= indistinct*max(abs(max(one, other)), 1.0_dp)
   end function is_one

   !> How long the next step is [h]: along the tangent, and not too long.
   pure real(dp) function get_step(surface, trial, last) result(step)
      type(surface_t), intent(in) :: surface
      !> The trial where the step begins, and the one before it.
      type(trial_t), intent(in) :: trial, last
      real(dp) :: slope, change

      slope = trial%totals%load_slope
      if (has_moving_edges(surface) .and. trial%totals%structure == last%totals%structure) then
         ! the chord sees what regimes that spread add to the slope of the strips
         change = abs(trial%penetration - last%penetration)
         if (change > indistinct) slope = min(slope, abs(trial%excess - last%excess)/change)
      end if
      step = get_longest_step(surface)
      if (slope*step > abs(trial%excess)) step = abs(trial%excess)/slope
   end function get_step

   !> Length of a step where nothing tells how far the load is [h].
   pure real(dp) function get_longest_step(surface) result(step)
      !> The surface in reduced units; its stress and range lengthen the step.
      type(surface_t), intent(in) :: surface

      step = longest_step*max(1.0_dp, surface%adhesion%stress + surface%adhesion%range)
   end function get_longest_step

end module adfric_foundation_load_search
