! SPDX-License-Identifier: GPL-3.0-or-later
!> The steady state of one strip on the chosen branch.
!>
!> The state of a column after one period, as a function of its state before (the return map), increases: of
!> two columns the one with the larger gap keeps it. So the steady states are ordered by their gap; adhesion
!> everywhere in the gap bounds them from below, a free column as high as the crest from above. The `adhered`
!> branch is the least gap, where unloading leads; the `approach` branch is the largest gap, where loading
!> leads. Stepping up from the lower bound, or down from the upper, meets the first steady state, and `return_map`
!> passes none.
module adfric_foundation_steady_state
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_constants, only: pi, two_pi
   use adfric_foundation_contact_zone, only: decay
   use adfric_foundation_edges, only: refine_edges, refine_adhesion_edges, is_admissible, is_admissible_adhesion
   use adfric_foundation_strip_stepping, only: column_t, period_t, leave_contact, step_to_leading_edge, in_free, &
      & period_closed, period_never_released, period_never_attached
   use adfric_foundation_phases, only: remaining_phases
   use adfric_foundation_return_map, only: close_period
   use adfric_foundation_saturated_adhesion, only: half_width_of_depth, shift_of_half_width, saturation_level
   use adfric_foundation_strip, only: strip_t, profile, lifted_profile, drive_round_off, steady_state_t, regime_free, &
      & regime_adhesion_only, regime_discrete, regime_saturated_adhesion, regime_adhesion_zones, regime_saturated
   implicit none (type, external)
   private
   public :: find_steady_state, find_beyond_fold, find_without_release, continue_state, get_range_margin
   public :: branch_adhered, branch_approach

   !> Which steady state is sought where there are several.
   integer, parameter :: branch_adhered = 1, branch_approach = 2

   !> Width of a contact that has just begun, as a share of the adhesion zone around it.
   real(dp), parameter :: narrow = 1.0e-4_dp

   !> How far past a fold the search goes on [rad, or of the retardation phase where that is less].
   real(dp), parameter :: past_fold = 1.0e-4_dp

contains

   !> Find the steady state of a strip.
   !>
   !> With adhesion zones several states may be stable. Of a strip that adheres more, the first state from above may lie below those
   !> of this one, and still continue to one of them: so on the approach branch a state of a neighbour is continued only where it is
   !> known to adhere less.
   pure subroutine find_steady_state(strip, branch, state, guess, is_regime_known, adheres_more)
      type(strip_t), intent(in) :: strip
      !> The branch that is sought, one of `branch_...`.
      integer, intent(in) :: branch
      !> The steady state; `is_converged` tells whether it was found.
      type(steady_state_t), intent(out) :: state
      !> State of a neighbouring strip; it may save time.
      type(steady_state_t), intent(in), optional :: guess
      !> Is this strip known to be in the regime of the guess, if it is stable there? Then nothing else is tried.
      logical, intent(in), optional :: is_regime_known
      !> Does this strip adhere wherever the neighbour does, for it is the same at a larger penetration? If absent, that is not
      !> known.
      logical, intent(in), optional :: adheres_more
      logical :: is_found, is_known, may_continue
      real(dp) :: bound_width

      if (has_asserts) call assert(branch == branch_adhered .or. branch == branch_approach, &
         & 'find_steady_state: the branch is known')
      if (strip%adhesion%stress <= 0) then
         call find_without_release(strip, state, guess)
         if (state%regime == regime_saturated_adhesion) state%regime = regime_discrete
         return
      end if
      is_known = .false.
      if (present(is_regime_known)) is_known = is_regime_known
      ! adhesion everywhere is the same regime as adhesion in a zone, and another branch
      if (branch == branch_adhered .and. strip%depth <= 0) is_known = is_known .and. strip%adhesion%release_gap < 2 - strip%depth
      if (is_known .and. present(guess)) then
         call continue_state(strip, guess, state, is_found)
         if (is_found) return
      end if
      call try_bound(strip, branch, state, is_found, guess)
      if (is_found) return
      bound_width = state%bound_width
      may_continue = branch == branch_adhered
      if (present(adheres_more)) may_continue = may_continue .or. adheres_more
      if (may_continue .and. present(guess)) then
         if (guess%regime == regime_adhesion_zones) call continue_state(strip, guess, state, is_found)
      end if
      if (.not. is_found) call search_with_release(strip, branch, state)
      state%bound_width = bound_width
   end subroutine find_steady_state

   !> Find the steady state of a strip just beyond the fold of a branch. What remains of the branch would slow down the
   !> search from the bound, so it starts on the far side of it.
   pure subroutine find_beyond_fold(strip, branch, fold, state)
      type(strip_t), intent(in) :: strip
      integer, intent(in) :: branch
      type(steady_state_t), intent(in) :: fold
      type(steady_state_t), intent(out) :: state
      logical :: is_found

      call try_bound(strip, branch, state, is_found)
      if (is_found) return
      call search_with_release(strip, branch, state, fold%shift + fold%half_width + fold%leading)
      if (.not. state%is_converged) call search_with_release(strip, branch, state)
   end subroutine find_beyond_fold

   !> The state that bounds a branch, if it is a steady state: the free surface undisturbed, or adhesion everywhere in the
   !> gap.
   pure subroutine try_bound(strip, branch, state, is_found, guess)
      type(strip_t), intent(in) :: strip
      integer, intent(in) :: branch
      type(steady_state_t), intent(out) :: state
      !> Is there nothing to search for? That is so, too, where `state` did not converge.
      logical, intent(out) :: is_found
      type(steady_state_t), intent(in), optional :: guess

      if (branch == branch_approach) then
         state%regime = regime_free
         ! a crest that is just in range, but for round-off, draws nothing in
         is_found = -strip%crest >= strip%adhesion%attach_gap*(1 - 4*epsilon(1.0_dp))
      else
         call find_without_release(strip, state, guess)
         is_found = .not. state%is_converged
         if (.not. is_found) is_found = get_range_margin(strip, state) >= 0
      end if
   end subroutine try_bound

   !> The state of this strip that continues a neighbour's in the same regime, if there is a stable one.
   pure subroutine continue_state(strip, guess, state, is_found)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: guess
      !> State of this strip in the same regime, of use only if `is_found`.
      type(steady_state_t), intent(out) :: state
      !> Is there a stable state that continues the guess?
      logical, intent(out) :: is_found

      state = guess
      is_found = .false.
      select case (guess%regime)
      case (regime_adhesion_zones)
         call refine_edges(strip, state)
         is_found = is_admissible(strip, state)
      case (regime_adhesion_only)
         if (guess%half_width >= pi) return
         call refine_adhesion_edges(strip, state)
         is_found = is_admissible_adhesion(strip, state)
      case (regime_saturated_adhesion)
         call find_without_release(strip, state, guess)
         is_found = state%is_converged .and. state%regime == guess%regime
         if (is_found) is_found = get_range_margin(strip, state) >= 0
      end select
      if (is_found) is_found = state%multiplier < 1
   end subroutine continue_state

   !> The state with adhesion everywhere in the gap, whatever its range: there is exactly one.
   pure subroutine find_without_release(strip, state, guess)
      type(strip_t), intent(in) :: strip
      !> The state; its range of adhesion is as large as the gap.
      type(steady_state_t), intent(out) :: state
      type(steady_state_t), intent(in), optional :: guess
      real(dp) :: start

      if (strip%level >= saturation_level(strip%foundation)) then
         state%regime = regime_saturated
         state%half_width = pi
      else if (strip%depth <= 0) then
         state%regime = merge(regime_adhesion_only, regime_free, strip%adhesion%stress > 0)
         state%half_width = merge(pi, 0.0_dp, strip%adhesion%stress > 0)
      else
         state%regime = regime_saturated_adhesion
         start = 0
         if (present(guess)) start = guess%bound_width
         call half_width_of_depth(strip%foundation, strip%depth, start, state%half_width, state%is_converged)
         state%bound_width = state%half_width
         state%shift = shift_of_half_width(strip%foundation, state%half_width)
      end if
   end subroutine find_without_release

   !> By how much the range of adhesion exceeds the gap of a state found without release, where it matters:
   !> adhesion is lost somewhere if and only if this is negative.
   pure real(dp) function get_range_margin(strip, state) result(margin)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      real(dp) :: opening, span

      margin = strip%adhesion%release_gap
      select case (state%regime)
      case (regime_adhesion_only)
         margin = strip%adhesion%release_gap - (2 - strip%depth)
      case (regime_saturated_adhesion)
         ! where the drive is below -release_gap a gap of this size only grows, so the end of that interval decides
         opening = state%shift - state%half_width
         span = remaining_phases(strip, opening, -strip%adhesion%release_gap, .true.)
         if (span < 0 .or. span > two_pi - 2*state%half_width) return
         margin = strip%adhesion%release_gap + lifted_profile(strip, opening)*decay(span/strip%foundation%v) &
            & + 2*sin(opening - span/2)*sin(span/2)
      case default
         continue
      end select
   end function get_range_margin

   !> Search the states in which adhesion is lost somewhere, from the bound of the branch.
   pure subroutine search_with_release(strip, branch, state, fold)
      type(strip_t), intent(in) :: strip
      integer, intent(in) :: branch
      type(steady_state_t), intent(out) :: state
      !> Phase of the leading edge of adhesion in a fold that has just been passed [rad].
      real(dp), intent(in), optional :: fold
      type(period_t) :: period
      integer :: outcome, direction
      real(dp) :: xi, step

      direction = merge(1, -1, branch == branch_adhered)
      if (present(fold)) then
         step = past_fold*min(1.0_dp, strip%foundation%v)
         xi = fold - direction*step
         outcome = period_closed
      else
         step = 0
         call find_first_edge(strip, branch, xi, outcome)
      end if
      if (outcome == period_closed) then
         call close_period(strip, direction, step, xi, period, state%is_converged)
         outcome = period%outcome
      end if
      ! if no period closes, the bound of the other branch is the only state, so it must be one
      if (outcome == period_never_released) then
         call find_without_release(strip, state)
         if (state%is_converged) state%is_converged = get_range_margin(strip, state) >= -drive_round_off(strip)
      else if (outcome /= period_closed) then
         state%regime = regime_free
         state%is_converged = -strip%crest >= strip%adhesion%attach_gap - drive_round_off(strip)
      else if (state%is_converged) then
         call read_edges(strip, xi, period, state)
      end if
   end subroutine search_with_release

   !> The leading edge of adhesion that a column from the bound of a branch comes to first.
   pure subroutine find_first_edge(strip, branch, xi, outcome)
      type(strip_t), intent(in) :: strip
      integer, intent(in) :: branch
      !> Phase of that edge [rad].
      real(dp), intent(out) :: xi
      !> `period_closed` if the column comes to such an edge; else another of `period_...`.
      integer, intent(out) :: outcome
      type(column_t) :: column
      integer :: k

      if (branch == branch_adhered) then
         call get_lowest_column(strip, column, outcome)
      else
         call get_highest_column(strip, column, outcome)
      end if
      if (outcome == period_closed) call step_to_leading_edge(strip, column, outcome)
      do k = 1, 3
         if (outcome /= period_never_attached .or. branch == branch_adhered) exit
         ! the crest was just out of range: once more around
         column%xi = column%xi + two_pi
         column%value = column%value*(1 - decay(two_pi/strip%foundation%v))
         column%gap = column%value - profile(strip, column%xi)
         call step_to_leading_edge(strip, column, outcome)
      end do
      xi = column%xi
   end subroutine find_first_edge

   !> A column below all steady states, on the orbit with adhesion everywhere in the gap. `outcome` is not closed if
   !> there is nothing to time stepping.
   pure subroutine get_lowest_column(strip, column, outcome)
      type(strip_t), intent(in) :: strip
      !> The column, in adhesion or free.
      type(column_t), intent(out) :: column
      !> `period_closed` if there is a column to time stepping; else another of `period_...`.
      integer, intent(out) :: outcome
      type(steady_state_t) :: state
      real(dp) :: xi, crossing

      outcome = period_closed
      call find_without_release(strip, state)
      select case (state%regime)
      case (regime_saturated)
         outcome = period_never_released
      case (regime_saturated_adhesion)
         column = leave_contact(strip, state%shift - state%half_width)
         column%has_begun = column%zone == in_free
      case default
         ! released where the gap -level - cos(xi) of a displacement -stress passes that of release
         crossing = -strip%level - strip%adhesion%release_gap
         if (crossing >= 1) outcome = period_never_attached
         xi = -acos(max(-1.0_dp, min(1.0_dp, crossing)))
         column = column_t(in_free, xi, strip%adhesion%jump - strip%adhesion%stress, strip%adhesion%released_gap, .true.)
      end select
   end subroutine get_lowest_column

   !> A column above all steady states: free in the valley, with the largest displacement that any state can have.
   pure subroutine get_highest_column(strip, column, outcome)
      type(strip_t), intent(in) :: strip
      type(column_t), intent(out) :: column
      integer, intent(out) :: outcome
      real(dp) :: w, periods

      outcome = period_never_released
      w = max(strip%crest, 0.0_dp) + strip%adhesion%jump
      if (w - profile(strip, pi) <= strip%adhesion%attach_gap) return
      ! periods in which it passes the crest out of range
      periods = 0
      if (w > strip%crest + strip%adhesion%attach_gap) then
         periods = strip%foundation%v/two_pi*log(w/max(strip%crest + strip%adhesion%attach_gap, tiny(w)))
      end if
      w = w*(1 - decay(max(0.0_dp, real(floor(min(periods, 1.0e9_dp)) - 1, dp))*two_pi/strip%foundation%v))
      outcome = period_closed
      column = column_t(in_free, pi, w, w - profile(strip, pi))
   end subroutine get_highest_column

   !> Edges of the zones of a closed period, made exact. Where contact is about to be lost the time stepping cannot tell
   !> contact from none, so both are tried.
   pure subroutine read_edges(strip, xi, period, state)
      type(strip_t), intent(in) :: strip
      !> Phase of the leading edge of adhesion [rad].
      real(dp), intent(in) :: xi
      type(period_t), intent(in) :: period
      !> Receives the edges; `is_converged` tells whether they are those of an admissible state.
      type(steady_state_t), intent(inout) :: state
      real(dp) :: length
      integer :: try
      logical :: has_contact

      length = period%leading + period%contact + period%trailing
      do try = 1, 2
         has_contact = period%has_contact .eqv. try == 1
         if (has_contact) then
            state%half_width = max(period%contact, narrow*length)/2
            state%shift = centred(xi - period%leading - period%contact/2)
            state%leading = period%leading
            state%trailing = period%trailing
            if (.not. period%has_contact) state%leading = length/2
            if (.not. period%has_contact) state%trailing = length/2
            call refine_edges(strip, state)
            state%is_converged = is_admissible(strip, state)
         else
            state%half_width = length/2
            state%shift = centred(xi - length/2)
            call refine_adhesion_edges(strip, state)
            state%is_converged = is_admissible_adhesion(strip, state)
         end if
         if (state%is_converged) exit
      end do
   end subroutine read_edges

   !> A phase brought into (-pi, pi].
   pure real(dp) function centred(xi)
      !> Any phase [rad].
      real(dp), intent(in) :: xi

      centred = xi - two_pi*anint(xi/two_pi)
   end function centred

end module adfric_foundation_steady_state
