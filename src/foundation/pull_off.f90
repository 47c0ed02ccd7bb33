! SPDX-License-Identifier: GPL-3.0-or-later
!> The pull-off load: the least load of the adhered branch. No state of any branch carries less, for of all states of a penetration
!> that of the adhered branch has the smallest gap, and so the smallest mean displacement.
!>
!> From the state without load the load is followed downwards to where it turns. Then a smaller load is sought further down: if
!> the search proves that there is none, the turn is the least load; if it finds one, it goes on from there.
module adfric_foundation_pull_off
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_foundation_crosswise, only: memory_t
   use adfric_foundation_equilibrium, only: equilibrium_t, neighbour_t, solve_load
   use adfric_foundation_load_search, only: find_first_state, downwards, search_found, search_empty
   use adfric_foundation_load_trial, only: trial_t, try_penetration, try_near, is_plain, has_moving_edges, round_off, &
      & indistinct
   use adfric_foundation_steady_state, only: branch_adhered
   use adfric_foundation_surface, only: surface_t, is_identical_surface, lowest_of
   implicit none (type, external)
   private
   public :: pull_off_t, find_pull_off, is_below_pull_off

   integer, parameter :: max_turns = 20, max_steps = 400, max_iterations = 80
   !> A step that is short enough to tell by its ends where the load goes, as a share of stress and range, the longest one where these are
   !> small [h], and by how much each one is longer than the one before.
   real(dp), parameter :: short_step = 2.0e-3_dp, longest_step = 0.1_dp, growth = 2.0_dp
   !> A step between the same regimes over which the load has one turn at most, where its slope is not known [h].
   real(dp), parameter :: smooth_step = 0.01_dp
   !> Secants towards a smooth turn at most, and how far the first one reaches [h, or of the penetration].
   integer, parameter :: max_secants = 8
   real(dp), parameter :: nearby = 1.0e-6_dp
   !> A load that is smaller than another one by this share of the stress is so for certain.
   real(dp), parameter :: distinct = 1.0e-9_dp
   !> Largest part of the pull-off load that states which are not known may add.
   real(dp), parameter :: uncertain = 1.0e-7_dp
   !> Share of the golden section.
   real(dp), parameter :: golden = 0.3819660112501051_dp

   !> The pull-off load of a surface.
   type :: pull_off_t
      !> The surface it belongs to, once it has been looked for.
      type(surface_t) :: surface
      !> Has the load been looked for?
      logical :: is_known = .false.
      !> False if it was not found.
      logical :: is_converged = .false.
      !> The load [h/K] and its penetration [h].
      real(dp) :: load = 0, penetration = 0
   end type pull_off_t

   !> Where the load turns: two penetrations that carry more than one between them.
   type :: turn_t
      !> The two penetrations [h].
      real(dp) :: low = 0, high = 0
      !> Bound of the slope between them [1/K].
      real(dp) :: slope_bound = 1
      !> The trial between them.
      type(trial_t) :: least
   end type turn_t

contains

   !> Find the pull-off load of a surface with adhesion.
   pure subroutine find_pull_off(surface, self)
      !> The surface in reduced units; its branch does not matter.
      type(surface_t), intent(in) :: surface
      !> In: the pull-off load of a surface, or of none. Out: that of this surface; it is sought only if the surface is another.
      type(pull_off_t), intent(inout) :: self
      type(surface_t) :: adhered
      type(memory_t) :: memory
      type(neighbour_t) :: neighbour
      type(equilibrium_t) :: unloaded
      type(trial_t) :: start, low, high
      type(turn_t) :: turns(max_turns)
      integer :: k, outcome

      if (self%is_known) then
         if (is_identical_surface(surface, self%surface)) return
      end if
      self = pull_off_t(surface, is_known=.true.)
      adhered = surface
      adhered%branch = branch_adhered
      ! nothing pulls with more than the stress: if all adheres where the crest loses contact, that is the least load
      call try_penetration(adhered, -surface%adhesion%stress, 0.0_dp, memory, low)
      self%is_converged = low%totals%is_converged .and. low%totals%load <= -surface%adhesion%stress*(1 - round_off)
      self%load = -surface%adhesion%stress
      self%penetration = -surface%adhesion%stress
      if (self%is_converged) return
      call solve_load(adhered, 0.0_dp, neighbour, memory, unloaded)
      if (unloaded%totals%n_strips > 0 .and. unloaded%totals%is_converged) then
         start = neighbour%last
      else
         call find_loaded(adhered, memory, start)
         if (.not. start%totals%is_converged) return
      end if
      do k = 1, max_turns
         call follow_to_turn(adhered, memory, start, turns(k), high)
         if (.not. turns(k)%least%totals%is_converged) return
         high%excess = high%totals%load - turns(k)%least%totals%load
         call find_first_state(adhered, turns(k)%least%totals%load, downwards, &
            & high%totals%structure == turns(k)%least%totals%structure, lowest_of(surface), memory, high, low, outcome)
         if (outcome /= search_found) exit
         start = high
         if (low%excess < high%excess) start = low
      end do
      if (outcome == search_empty) call compare_turns(adhered, memory, turns(:k), self)
   end subroutine find_pull_off

   !> A state that carries a load, where that without load is not found to its digits.
   pure subroutine find_loaded(surface, memory, start)
      type(surface_t), intent(in) :: surface
      !> Strips found before, as first guesses; they save time and change nothing. Out: those found here.
      type(memory_t), intent(inout) :: memory
      !> Receives the state; not converged if there is none.
      type(trial_t), intent(out) :: start
      ! penetrations that are tried: the first one, and by how much each is larger than the one before
      real(dp), parameter :: first = 1.0e-3_dp, factor = 4
      integer, parameter :: most_trials = 10
      integer :: k

      do k = 0, most_trials
         call try_penetration(surface, first*factor**k, 0.0_dp, memory, start)
         start%totals%is_converged = start%totals%is_converged .and. start%totals%load >= 0
         if (start%totals%is_converged) return
      end do
   end subroutine find_loaded

   !> Is a load so small that no state carries it, on any branch?
   pure logical function is_below_pull_off(self, surface, load)
      type(pull_off_t), intent(in) :: self
      type(surface_t), intent(in) :: surface
      !> Load that is sought, per period in x (and y) [h/K].
      real(dp), intent(in) :: load

      is_below_pull_off = self%is_known .and. self%is_converged
      ! a load as near as this is left to the search
      if (is_below_pull_off) is_below_pull_off = load < self%load - max(distinct, surface%tolerance)*surface%adhesion%stress
      if (is_below_pull_off) is_below_pull_off = is_identical_surface(surface, self%surface)
   end function is_below_pull_off

   !> The least of all turns; only those that may be the least are looked at closely.
   pure subroutine compare_turns(surface, memory, turns, self)
      type(surface_t), intent(in) :: surface
      type(memory_t), intent(inout) :: memory
      !> The turns, with falling penetration; nothing below the last one carries less than it does. Out: some are narrowed.
      type(turn_t), intent(inout) :: turns(:)
      !> Receives the least load and its penetration.
      type(pull_off_t), intent(inout) :: self
      real(dp) :: unknown
      integer :: k

      do k = size(turns), 1, -1
         associate (turn => turns(k))
            ! the load falls by no more than its slope allows
            if (self%is_converged .and. turn%least%totals%load - turn%slope_bound*(turn%high - turn%low) >= self%load) cycle
            call narrow(surface, memory, turn%low, turn%high, turn%least, unknown)
            ! between the least load and a state that is not known the load may fall by its slope
            if (unknown*turn%slope_bound > uncertain*abs(turn%least%totals%load)) then
               self%is_converged = .false.
               return
            end if
            if (.not. has_moving_edges(surface)) call polish(surface, memory, turn%least)
            if (self%is_converged .and. turn%least%totals%load >= self%load) cycle
            self%load = turn%least%totals%load
            self%penetration = turn%least%penetration
            self%is_converged = .true.
         end associate
      end do
   end subroutine compare_turns

   !> From a state go down to where the load is no longer smaller.
   pure subroutine follow_to_turn(surface, memory, start, turn, beyond)
      type(surface_t), intent(in) :: surface
      type(memory_t), intent(inout) :: memory
      type(trial_t), intent(in) :: start
      !> The turn; its trial is not converged if there is none.
      type(turn_t), intent(out) :: turn
      !> The first trial below the turn.
      type(trial_t), intent(out) :: beyond
      type(trial_t) :: here, above
      real(dp) :: step, short, longest
      logical :: is_step
      integer :: k

      above = start
      here = start
      short = short_step*(surface%adhesion%stress + surface%adhesion%range)
      step = short
      longest = longest_step*max(1.0_dp, surface%adhesion%stress + surface%adhesion%range)
      do k = 1, max_steps
         call try_near(surface, here%penetration - step, here%penetration, 0.0_dp, memory, beyond)
         if (.not. beyond%totals%is_converged) exit
         is_step = beyond%totals%load < here%totals%load
         ! the end of a long step must belong to the same fall
         if (step > short) is_step = is_step .and. is_smooth(surface, beyond, here)
         if (is_step) then
            above = here
            here = beyond
            step = min(growth*step, longest)
         else if (step > short) then
            step = max(step/4, short)
            ! what has been too long once will be so again
            longest = 2*step
         else
            exit
         end if
      end do
      turn = turn_t(beyond%penetration, above%penetration, above%totals%slope_bound, here)
      turn%least%totals%is_converged = here%totals%is_converged .and. beyond%totals%is_converged .and. k <= max_steps
   end subroutine follow_to_turn

   !> Does the load fall from one penetration to a smaller one without turning on the path?
   pure logical function is_smooth(surface, low, high)
      type(surface_t), intent(in) :: surface
      !> The trials at the smaller and the larger penetration.
      type(trial_t), intent(in) :: low, high
      type(trial_t) :: one, two

      ! loads above that of the far end, down to which a dip would matter
      one = low
      two = high
      one%excess = 0
      two%excess = high%totals%load - low%totals%load
      is_smooth = is_plain(surface, one, two, one)
      if (is_smooth .or. .not. has_moving_edges(surface)) return
      is_smooth = low%totals%structure == high%totals%structure .and. high%penetration - low%penetration <= smooth_step
   end function is_smooth

   !> Where the slope of the load is known its zero is the position of a smooth turn: secants from next to it.
   pure subroutine polish(surface, memory, turn)
      type(surface_t), intent(in) :: surface
      type(memory_t), intent(inout) :: memory
      !> In: the least trial near the turn. Out: one that carries no more and is nearer to the turn, if there is one.
      type(trial_t), intent(inout) :: turn
      type(trial_t) :: last, next
      real(dp) :: penetration, change
      integer :: k

      last = turn
      penetration = turn%penetration + nearby*max(1.0_dp, abs(turn%penetration))
      do k = 1, max_secants
         call try_penetration(surface, penetration, 0.0_dp, memory, next)
         if (.not. next%totals%is_converged .or. next%totals%structure /= turn%totals%structure) return
         change = next%totals%load_slope - last%totals%load_slope
         if (.not. change*(next%penetration - last%penetration) > 0) return
         if (k > 1 .and. abs(next%totals%load_slope) >= abs(turn%totals%load_slope)) return
         penetration = next%penetration - next%totals%load_slope*((next%penetration - last%penetration)/change)
         last = next
         if (next%totals%load <= turn%totals%load + round_off*surface%adhesion%stress .and. &
            & abs(next%totals%load_slope) < abs(turn%totals%load_slope)) turn = next
         if (.not. abs(penetration - turn%penetration) < 100*nearby*max(1.0_dp, abs(turn%penetration))) return
      end do
   end subroutine polish

   !> The least load between two penetrations, one of which is known to carry less: by parabolas, and golden sections where
   !> these gain too little (Brent's method).
   pure subroutine narrow(surface, memory, lowest, highest, least, unknown)
      type(surface_t), intent(in) :: surface
      type(memory_t), intent(inout) :: memory
      !> The two penetrations [h].
      real(dp), intent(in) :: lowest, highest
      !> In: a penetration between them that carries less than both. Out: the penetration that carries least.
      type(trial_t), intent(inout) :: least
      !> Receives how far the nearest state is that is not known; 0 if all are.
      real(dp), intent(out) :: unknown
      type(trial_t) :: second, third, next
      logical :: are_unknown(2)
      real(dp) :: low, high, ends(2), enough, middle, margin, step, before, last
      integer :: k

      if (has_asserts) call assert(lowest <= least%penetration .and. least%penetration <= highest, &
         & 'narrow: the least load lies between the two penetrations')
      low = lowest
      high = highest
      ends = huge(low)
      enough = round_off
      if (has_moving_edges(surface)) enough = max(surface%tolerance/10, round_off)
      second = least
      third = least
      are_unknown = .false.
      last = 0
      before = 0
      do k = 1, max_iterations
         middle = (low + high)/2
         ! heights are known to the round-off of 1
         margin = max(indistinct*abs(least%penetration)/4, 4*epsilon(margin))
         if (abs(least%penetration - middle) <= 2*margin - (high - low)/2) exit
         ! a smooth turn is so flat that its position matters less than its load
         if (maxval(ends) - least%totals%load <= enough*surface%adhesion%stress) exit
         call choose_step(least, second, third, low, high, before, last)
         step = last
         if (abs(step) < margin) step = sign(margin, last)
         call try_near(surface, least%penetration + step, least%penetration, 0.0_dp, memory, next)
         if (.not. next%totals%is_converged) then
            ! next to the end of a branch, whose state is not known: the search goes on between it and the least load
            if (step < 0) low = next%penetration
            if (step > 0) high = next%penetration
            are_unknown = are_unknown .or. [step < 0, step > 0]
         else if (next%totals%load <= least%totals%load) then
            if (next%penetration < least%penetration) then
               high = least%penetration
               ends(2) = least%totals%load
            else
               low = least%penetration
               ends(1) = least%totals%load
            end if
            third = second
            second = least
            least = next
         else
            if (next%penetration < least%penetration) then
               low = next%penetration
               ends(1) = next%totals%load
            else
               high = next%penetration
               ends(2) = next%totals%load
            end if
            if (next%totals%load <= second%totals%load .or. k == 1) then
               third = second
               second = next
            else
               third = next
            end if
         end if
      end do
      unknown = maxval([least%penetration - low, high - least%penetration], are_unknown)
      unknown = max(unknown, 0.0_dp)
   end subroutine narrow

   !> The next step of Brent's method: to the turn of the parabola through the three least loads, or a golden section.
   pure subroutine choose_step(least, second, third, low, high, before, last)
      !> The three least loads found so far, the least first.
      type(trial_t), intent(in) :: least, second, third
      !> Penetrations between which the least load lies.
      real(dp), intent(in) :: low, high
      !> In: the step before the last one. Out: the last one, or the length that a golden section divides.
      real(dp), intent(inout) :: before
      !> In: the last step. Out: the next one.
      real(dp), intent(inout) :: last
      real(dp) :: p, q, r

      r = (least%penetration - second%penetration)*(least%totals%load - third%totals%load)
      q = (least%penetration - third%penetration)*(least%totals%load - second%totals%load)
      p = (least%penetration - third%penetration)*q - (least%penetration - second%penetration)*r
      q = 2*(q - r)
      if (q > 0) p = -p
      q = abs(q)
      if (abs(p) < abs(q*before/2) .and. p > q*(low - least%penetration) .and. p < q*(high - least%penetration)) then
         before = last
         last = p/q
      else
         before = merge(high, low, least%penetration < (low + high)/2) - least%penetration
         last = golden*before
      end if
   end subroutine choose_step

end module adfric_foundation_pull_off
