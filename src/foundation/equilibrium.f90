! SPDX-License-Identifier: GPL-3.0-or-later
!> A wavy surface under a given penetration or a given load.
!>
!> Under load the penetration is sought on the chosen branch where the load rises with it. On the adhered branch
!> that is the largest such penetration, where unloading arrives; on the approach branch the smallest, where loading
!> arrives. Two loads enclose that of either branch at every penetration: without adhesion a surface carries no less, and with
!> adhesion in the whole gap it carries no more. Both are convex and rise, so each search starts next to where it may end.
module adfric_foundation_equilibrium
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_describe_status, only: status_solved, status_no_equilibrium, status_not_converged
   use adfric_foundation_crosswise, only: memory_t
   use adfric_foundation_load_search, only: find_first_state, downwards, upwards, search_found, search_empty
   use adfric_foundation_load_starts, only: start_above, start_below, search_without_adhesion, highest
   use adfric_foundation_load_trial, only: trial_t, try_penetration, carries_load, get_reach, is_plain, round_off, indistinct
   use adfric_foundation_steady_state, only: branch_adhered
   use adfric_foundation_strip, only: steady_state_t
   use adfric_foundation_surface, only: surface_t, totals_t, is_same_surface, get_relative_error, lowest_of
   implicit none (type, external)
   private
   public :: equilibrium_t, neighbour_t, solve_penetration, solve_load, leads_to

   integer, parameter :: max_iterations = 100, max_refinements = 6
   !> Longest step of the penetration from a neighbour's [h].
   real(dp), parameter :: longest_step = 0.05_dp

   !> A point: its penetration, what it carries, and how well that is known.
   type :: equilibrium_t
      !> How the point was solved, one of `status_...`.
      integer :: status = status_solved
      !> Penetration of the crests into the undisturbed surface [h].
      real(dp) :: penetration = 0
      !> Forces and areas at this penetration.
      type(totals_t) :: totals
      !> The strip of the crest line.
      type(steady_state_t) :: crest
      !> Relative error of friction and load.
      real(dp) :: error_estimate = 0
   end type equilibrium_t

   !> Points of the same surface that have been solved before, the last of which leads to the next one (see `leads_to`).
   type :: neighbour_t
      !> Number of points that are known, 2 at most.
      integer :: n = 0
      !> The last point, with its excess over its own load.
      type(trial_t) :: last
      !> Penetration of the point before it [h].
      real(dp) :: before = 0
   end type neighbour_t

contains

   !> Solve a point of given penetration.
   pure subroutine solve_penetration(surface, penetration, memory, equilibrium)
      !> The surface in reduced units.
      type(surface_t), intent(in) :: surface
      !> Penetration of its crests [h].
      real(dp), intent(in) :: penetration
      !> Strips found before, as first guesses; they save time and change nothing. Out: those found here.
      type(memory_t), intent(inout) :: memory
      !> The point, with the status `status_solved` or `status_not_converged`.
      type(equilibrium_t), intent(out) :: equilibrium
      type(trial_t) :: trial

      call try_penetration(surface, penetration, 0.0_dp, memory, trial)
      call finish(trial, 0.0_dp, equilibrium)
   end subroutine solve_penetration

   !> Solve a point of given load.
   pure subroutine solve_load(surface, load, neighbour, memory, equilibrium)
      !> The surface in reduced units.
      type(surface_t), intent(in) :: surface
      !> Load per period in x (and y) [h/K].
      real(dp), intent(in) :: load
      !> In: points that lead to this one, or none; they save time and change nothing. Out: this one is the last.
      type(neighbour_t), intent(inout) :: neighbour
      !> Strips found before, as first guesses; they save time and change nothing. Out: those found here.
      type(memory_t), intent(inout) :: memory
      !> The point, of which only the status is set if it was not found.
      type(equilibrium_t), intent(out) :: equilibrium
      type(trial_t) :: state
      real(dp) :: excess
      integer :: outcome
      logical :: is_found

      is_found = .false.
      if (neighbour%n > 0) call follow_neighbour(surface, load, neighbour, memory, state, is_found)
      outcome = search_found
      if (.not. is_found) call search(surface, load, neighbour, memory, state, outcome)
      if (outcome /= search_found) then
         equilibrium%status = merge(status_no_equilibrium, status_not_converged, outcome == search_empty)
         neighbour%n = 0
         return
      end if
      excess = abs(state%excess)
      ! an error of the load is one of the penetration that carries it; what so few strips as the user wants carry is their load
      if (surface%n_strips > 0) state%error(1) = 0
      excess = excess + state%error(1)
      call finish(state, excess, equilibrium)
      neighbour%before = neighbour%last%penetration
      neighbour%last = state
      neighbour%n = min(neighbour%n + 1, 2)
      if (equilibrium%status /= status_solved) neighbour%n = 0
   end subroutine solve_load

   !> Does the state of one load lead to that of another on the same branch? Without adhesion it always does.
   !> With it the load need not be monotone. On the adhered branch every penetration above the one that carries a load
   !> carries more, so what carries less lies below it; on the approach branch it is the other way round, for loads that press:
   !> a surface that is drawn in passes tensions twice, and one tension may be met before another, smaller or larger, is reached.
   pure logical function leads_to(from, from_load, to, to_load)
      !> The surface of the load that is known, and that of the other load.
      type(surface_t), intent(in) :: from, to
      !> The load that is known, and the other load [h/K].
      real(dp), intent(in) :: from_load, to_load

      leads_to = is_same_surface(from, to)
      if (.not. leads_to .or. to%adhesion%stress <= 0) return
      if (to%branch == branch_adhered) then
         leads_to = to_load <= from_load
      else
         leads_to = to_load >= from_load .and. from_load > 0
      end if
   end function leads_to

   !> Newton's method from a neighbour's state, and the proof that nothing is passed on the path.
   pure subroutine follow_neighbour(surface, load, neighbour, memory, state, is_found)
      type(surface_t), intent(in) :: surface
      !> Load that is sought [h/K].
      real(dp), intent(in) :: load
      type(neighbour_t), intent(in) :: neighbour
      !> Strips found before, as first guesses. Out: those found here.
      type(memory_t), intent(inout) :: memory
      type(trial_t), intent(out) :: state
      logical, intent(out) :: is_found
      type(trial_t) :: last
      real(dp) :: penetration, step, slope
      integer :: k

      is_found = .false.
      penetration = neighbour%last%penetration
      if (neighbour%n > 1) penetration = 2*penetration - neighbour%before
      do k = 1, max_refinements
         call try_penetration(surface, penetration, load, memory, state)
         if (.not. state%totals%is_converged .or. .not. state%totals%load_slope > 0) return
         if (carries_load(surface, state)) then
            last = neighbour%last
            last%excess = last%totals%load - load
            is_found = is_next(surface, last, state)
            return
         end if
         ! regimes that spread add to the slope of the strips: the chord sees that
         slope = state%totals%load_slope
         if (k > 1) then
            ! as near as round-off lets the penetration come
            if (.not. abs(state%penetration - last%penetration) > 0) return
            slope = (state%excess - last%excess)/(state%penetration - last%penetration)
         end if
         step = -state%excess/slope
         if (.not. (slope > 0 .and. abs(step) < longest_step)) return
         penetration = penetration + step
         last = state
      end do
   end subroutine follow_neighbour

   !> Is a state that carries the load the first one on the path from a neighbour?
   pure logical function is_next(surface, last, state)
      type(surface_t), intent(in) :: surface
      !> The state of the neighbour, and the one that was found.
      type(trial_t), intent(in) :: last, state

      if (surface%adhesion%stress <= 0) then
         is_next = .true.
      else if (surface%branch == branch_adhered) then
         is_next = last%penetration - state%penetration <= get_reach(last, last%totals%slope_bound)
         if (.not. is_next) is_next = is_plain(surface, state, last, state)
      else
         is_next = state%penetration - last%penetration <= get_reach(last, state%totals%slope_bound)
         if (.not. is_next) is_next = is_plain(surface, last, state, state)
      end if
   end function is_next

   !> The state of a load, from a neighbour or from nothing.
   pure subroutine search(surface, load, neighbour, memory, state, outcome)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: load
      type(neighbour_t), intent(in) :: neighbour
      !> Strips found before, as first guesses.
      type(memory_t), intent(inout) :: memory
      !> The state of the load if the outcome is `search_found`.
      type(trial_t), intent(out) :: state
      !> One of `search_...`.
      integer, intent(out) :: outcome
      type(trial_t) :: low, high
      real(dp) :: start

      if (surface%adhesion%stress <= 0) then
         call search_without_adhesion(surface, load, memory, state, outcome)
         return
      end if
      if (surface%branch == branch_adhered) then
         outcome = search_found
         if (neighbour%n > 0) then
            high = neighbour%last
            high%excess = high%totals%load - load
         else
            call start_above(surface, load, high, outcome)
            start = high%penetration
            if (outcome == search_found) call try_penetration(surface, start, load, memory, high)
         end if
         if (outcome == search_found) call find_first_state(surface, load, downwards, .false., lowest_of(surface), memory, high, &
            & low, outcome)
      else
         if (neighbour%n > 0) then
            low = neighbour%last
            low%excess = low%totals%load - load
            outcome = search_found
         else
            call start_below(surface, load, memory, low, outcome)
         end if
         ! a little beyond endless contact, for round-off
         start = highest(surface, load)
         start = start + indistinct*max(1.0_dp, abs(start))
         if (outcome == search_found) &
            & call find_first_state(surface, load, upwards, .not. load > 0, start, memory, low, high, outcome)
      end if
      if (outcome /= search_found) return
      call close_bracket(surface, load, memory, low, high)
      state = high
   end subroutine search

   !> Close a bracket: Newton's method from its better end, with bisection wherever that gains too little.
   pure subroutine close_bracket(surface, load, memory, low, high)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: load
      type(memory_t), intent(inout) :: memory
      !> The ends of the bracket, which carry less than the load and no less. Out: `high` carries the load.
      type(trial_t), intent(inout) :: low, high
      type(trial_t) :: middle
      real(dp) :: width, penetration
      integer :: k

      if (has_asserts) call assert(low%penetration <= high%penetration, 'close_bracket: the bracket has its ends in order')
      if (carries_load(surface, low)) high = low
      do k = 1, max_iterations
         if (carries_load(surface, high)) return
         width = high%penetration - low%penetration
         if (width <= 2*epsilon(width)*max(abs(high%penetration), abs(low%penetration))) exit
         penetration = low%penetration + width/2
         if (mod(k, 3) > 0) then
            middle = high
            if (abs(low%excess) < abs(high%excess)) middle = low
            if (middle%totals%load_slope > 0) penetration = middle%penetration - middle%excess/middle%totals%load_slope
            if (penetration <= low%penetration .or. penetration >= high%penetration) then
               ! two loads that do not differ, as far as round-off can tell, have no chord
               penetration = low%penetration + width/2
               if (high%excess > low%excess) penetration = low%penetration - low%excess*(width/(high%excess - low%excess))
            end if
         end if
         call try_penetration(surface, penetration, load, memory, middle)
         if (middle%excess < 0 .and. .not. carries_load(surface, middle)) then
            low = middle
         else
            high = middle
         end if
      end do
      ! as far as round-off of the penetration allows, but no further
      high%totals%is_converged = abs(high%excess) <= sqrt(round_off)*high%totals%load_scale
   end subroutine close_bracket

   !> What is known of the point, and how well.
   pure subroutine finish(trial, excess, equilibrium)
      type(trial_t), intent(in) :: trial
      !> By how much the load of the trial may differ from one that is given [h/K].
      real(dp), intent(in) :: excess
      type(equilibrium_t), intent(out) :: equilibrium

      equilibrium%penetration = trial%penetration
      equilibrium%totals = trial%totals
      equilibrium%crest = trial%crest
      equilibrium%error_estimate = get_relative_error(trial%totals, trial%error, excess)
      equilibrium%status = merge(status_solved, status_not_converged, &
         & trial%totals%is_converged .and. equilibrium%error_estimate < 1)
   end subroutine finish

end module adfric_foundation_equilibrium
