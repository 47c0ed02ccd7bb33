!> The penetration that carries a load, on the branch of the surface: from above the largest, from below the smallest.
!>
!> Loading and unloading meet a state where the load passes the one that is sought, so a search must not pass one. From a
!> penetration that carries too much it is certain that nothing is passed within the reach of `get_reach`. A longer step is
!> kept only where the load between its ends is plain (`is_plain`); otherwise its far end is put aside, and the stretch between
!> is halved until it is certain or plain. What is left when both ends are indistinct is a jump, which passes no state: with
!> rising penetration the load jumps downwards only.
module adfric_wavy_load_search
   use adfric_base_kinds, only: dp
   use adfric_wavy_crosswise, only: memory_t
   use adfric_wavy_load_trial, only: trial_t, try_near, carries_load, get_reach, get_fall, has_moving_edges, is_plain, &
      & is_past_least, indistinct
   use adfric_wavy_surface, only: surface_t
   implicit none (type, external)
   private
   public :: search_down, search_up, find_entry, search_found, search_empty, search_failed

   !> How a search ends: a state, no state for certain, or neither.
   integer, parameter :: search_found = 1, search_empty = 2, search_failed = 3
   !> Trials of one search, and those that may be put aside at once.
   integer, parameter :: max_trials = 20000, max_aside = 64
   !> Longest step [h], of a surface whose stress and range are small.
   real(dp), parameter :: longest_step = 0.05_dp

   !> Trials put aside: the last one is the next on the way.
   type :: aside_t
      integer :: n = 0
      type(trial_t) :: trials(max_aside)
   end type aside_t

contains

   !> The largest penetration that carries a load, below one above which all carry more.
   pure subroutine search_down(surface, load, is_turn, lowest, memory, low, high, outcome)
      !> The wavy surface: its foundation, adhesion and branch, in reduced units.
      type(surface_t), intent(in) :: surface
      !> Load that is sought, per period in x (and y) [h/K].
      real(dp), intent(in) :: load
      !> Is `high` where the load has just turned, from falling on the way down to rising?
      logical, intent(in) :: is_turn
      !> Below this penetration nothing is sought [h].
      real(dp), intent(in) :: lowest
      !> Strips found before, as first guesses; they save time and change nothing. Out: those found here.
      type(memory_t), intent(inout) :: memory
      !> If a state is found, a penetration that carries less; the state is the only one between the two.
      type(trial_t), intent(out) :: low
      !> In: a penetration above which all carry more than the load, and which carries no less. Out: the last such penetration.
      type(trial_t), intent(inout) :: high
      !> How the search ends, one of `search_...`.
      integer, intent(out) :: outcome
      type(aside_t) :: aside
      type(trial_t) :: last
      real(dp) :: sure, next
      logical :: has_risen, is_clear
      integer :: k

      outcome = search_found
      last = high
      has_risen = is_turn
      do k = 1, max_trials
         low = high
         if (carries_load(surface, high)) return
         sure = high%penetration - get_fall(surface, high)
         has_risen = (has_risen .and. high%totals%structure == last%totals%structure) .or. high%totals%load_slope > 0
         if (aside%n == 0) then
            if (sure <= lowest) exit
            next = min(sure, high%penetration - get_step(surface, high, last))
         else
            low = aside%trials(aside%n)
            is_clear = low%penetration >= sure .or. is_plain(surface, low, high, low) .or. is_one(low%penetration, sure)
            if (.not. is_clear .and. low%excess > 0) &
               & is_clear = is_past_least(surface, has_risen, aside%trials(max(aside%n - 1, 1)), low, high)
            if (is_clear) then
               if (low%excess < 0) return
               last = high
               high = low
               aside%n = aside%n - 1
               cycle
            end if
            next = divide(high%penetration, sure, low%penetration)
         end if
         call add_trial(surface, next, high%penetration, load, memory, aside, outcome)
         if (outcome == search_failed) return
      end do
      outcome = merge(search_empty, search_failed, k <= max_trials)
   end subroutine search_down

   !> The smallest penetration that carries a load, above one that carries less.
   pure subroutine search_up(surface, load, is_drawn_in, highest, memory, low, high, outcome)
      !> The wavy surface: its foundation, adhesion and branch, in reduced units.
      type(surface_t), intent(in) :: surface
      !> Load that is sought, per period in x (and y) [h/K].
      real(dp), intent(in) :: load
      !> Has the surface just been drawn in? Then `low` may carry the load to within its tolerance, and is not the state that is
      !> sought: the load falls there.
      logical, intent(in) :: is_drawn_in
      !> Above this penetration nothing is sought [h].
      real(dp), intent(in) :: highest
      !> Strips found before, as first guesses; they save time and change nothing. Out: those found here.
      type(memory_t), intent(inout) :: memory
      !> In: a penetration that carries less than the load. Out: the last such penetration.
      type(trial_t), intent(inout) :: low
      !> If a state is found, a penetration that carries no less; the state is the only one between the two.
      type(trial_t), intent(out) :: high
      !> How the search ends, one of `search_...`.
      integer, intent(out) :: outcome
      type(aside_t) :: aside
      type(trial_t) :: last
      real(dp) :: sure, next
      logical :: is_falling
      integer :: k

      outcome = search_found
      last = low
      is_falling = is_drawn_in
      do k = 1, max_trials
         high = low
         is_falling = is_falling .and. .not. low%excess > last%excess
         if (carries_load(surface, low) .and. .not. is_falling) return
         if (aside%n == 0) then
            if (low%penetration >= highest) exit
            ! the slope is 1 at most
            sure = low%penetration + get_reach(low, 1.0_dp)
            next = low%penetration + get_longest_step(surface)
            if (.not. is_falling) next = low%penetration + get_step(surface, low, last)
            next = max(sure, min(next, highest))
         else
            high = aside%trials(aside%n)
            sure = low%penetration + get_reach(low, high%totals%slope_bound)
            if (high%penetration <= sure .or. is_plain(surface, low, high, high) .or. is_one(sure, high%penetration)) then
               if (high%excess >= 0) return
               last = low
               low = high
               aside%n = aside%n - 1
               cycle
            end if
            next = divide(low%penetration, sure, high%penetration)
         end if
         call add_trial(surface, next, low%penetration, load, memory, aside, outcome)
         if (outcome == search_failed) return
      end do
      outcome = merge(search_empty, search_failed, k <= max_trials)
   end subroutine search_up

   !> The smallest penetration that carries less than a load, for a surface that adhesion draws in. What carries more is
   !> certain downwards from each trial.
   pure subroutine find_entry(surface, load, highest, memory, low, outcome)
      !> The wavy surface: its foundation, adhesion and branch, in reduced units.
      type(surface_t), intent(in) :: surface
      !> Load that the penetration sought does not reach, per period in x (and y) [h/K].
      real(dp), intent(in) :: load
      !> Above this penetration all carry more [h].
      real(dp), intent(in) :: highest
      !> Strips found before, as first guesses; they save time and change nothing. Out: those found here.
      type(memory_t), intent(inout) :: memory
      !> In: a penetration below which none carries less than the load. Out: the first that carries less.
      type(trial_t), intent(inout) :: low
      !> How the search ends, one of `search_...`.
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
            next = min(low%penetration + get_step(surface, low, low), highest)
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
      !> The wavy surface: its foundation, adhesion and branch, in reduced units.
      type(surface_t), intent(in) :: surface
      !> The penetration, and the one from which it is reached [h].
      real(dp), intent(in) :: penetration, from
      !> Load that is sought, per period in x (and y) [h/K].
      real(dp), intent(in) :: load
      !> Strips found before, as first guesses; they save time and change nothing. Out: those found here.
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
   pure logical function is_one(low, high)
      !> The smaller and the larger penetration [h].
      real(dp), intent(in) :: low, high

      is_one = high - low <= indistinct*max(abs(high), 1.0_dp)
   end function is_one

   !> How long the next step is [h]: along the tangent, and not too long.
   pure real(dp) function get_step(surface, trial, last) result(step)
      !> The wavy surface: its foundation, adhesion and branch, in reduced units.
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

      step = longest_step*max(1.0_dp, surface%stress + surface%range)
   end function get_longest_step

end module adfric_wavy_load_search
