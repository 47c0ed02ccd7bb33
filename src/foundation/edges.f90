! SPDX-License-Identifier: GPL-3.0-or-later
!> The edges of contact and adhesion of one strip, by Newton's method on all edge equations at once.
module adfric_foundation_edges
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_foundation_contact_zone, only: decay, longest_decay
   use adfric_foundation_edge_equations, only: edge_equations_t, get_edge_equations, solve_edges, free_length, &
      & get_adhesion_equations, solve_pair, no_step
   use adfric_foundation_phases, only: remaining_phases
   use adfric_foundation_strip, only: strip_t, steady_state_t, drive, drive_round_off, lifted_profile, &
      & regime_adhesion_zones, regime_adhesion_only
   implicit none (type, external)
   private
   public :: refine_edges, refine_adhesion_edges, is_admissible, is_admissible_adhesion
   public :: edge_rates_t, get_rates, get_multiplier, largest_share

   integer, parameter :: max_iterations = 30
   !> Relative step after which nothing but round-off is left, for convergence is quadratic.
   real(dp), parameter :: close_enough = 1.0e-9_dp
   !> Relative step that round-off alone may cause near the end of a branch.
   real(dp), parameter :: round_off = 1.0e-6_dp
   !> A disturbance that grows like this is not told from one that grows without bounds.
   real(dp), parameter :: unstable = 1.0e100_dp
   !> Beyond this retardation phase what a gap loses in a zone is less than round-off.
   real(dp), parameter :: fastest = 1.0e12_dp

   !> A jump of the rate of the gap (times v) where adhesion starts or ends multiplies a disturbance; the zones damp it.
   type :: edge_rates_t
      !> Rates before and after adhesion is released, and before and after it takes hold.
      real(dp) :: release = 0, freed = 0, attach = 0, attached = 0
      !> Exponent of the damping over a period.
      real(dp) :: damping = 0
   end type edge_rates_t

contains

   !> Newton's method on the edges of contact and adhesion, from the edges in `state`.
   pure subroutine refine_edges(strip, state)
      type(strip_t), intent(in) :: strip
      !> In: a guess of half_width, shift, trailing and leading. Out: the edges; `is_converged` tells whether they were found.
      type(steady_state_t), intent(inout) :: state
      type(edge_equations_t) :: equations
      real(dp) :: step(4), size_now, size_last, share
      integer :: iteration

      state%regime = regime_adhesion_zones
      state%is_converged = .false.
      state%entry = 0
      if (strip%foundation%v > fastest) return
      if (strip%adhesion%snaps) then
         state%entry = strip%adhesion%entry
         state%leading = 0
      end if
      if (strip%adhesion%is_lost_at_contact) state%trailing = 0
      state%outer_shift = state%shift + (state%leading - state%trailing)/2
      size_last = huge(1.0_dp)
      do iteration = 1, max_iterations
         call get_edge_equations(strip, state, equations)
         step = solve_edges(equations, equations%value)
         if (.not. maxval(abs(step)) < no_step) return
         share = largest_share(state, step)
         size_now = maxval(abs(step)/max([state%half_width, 1.0_dp, state%trailing, state%leading], tiny(1.0_dp)*no_step))
         state%half_width = state%half_width + share*step(1)
         state%shift = state%shift + share*step(2)
         state%trailing = state%trailing + share*step(3)
         state%leading = state%leading + share*step(4)
         state%outer_shift = state%outer_shift + share*(step(2) + (step(4) - step(3))/2)
         if (.not. (share > 0 .and. free_length(state) > 0)) return
         if (share < 1) cycle
         state%is_converged = size_now <= close_enough .or. (size_now <= round_off .and. size_now >= size_last/2)
         if (state%is_converged) exit
         size_last = size_now
      end do
      if (state%is_converged) state%multiplier = get_multiplier(strip, state)
   end subroutine refine_edges

   !> The share of a step that keeps every zone longer than a tenth of what it was.
   pure real(dp) function largest_share(state, step) result(share)
      !> State before the step, with contact and adhesion zones.
      type(steady_state_t), intent(in) :: state
      !> Changes of half_width, shift, trailing and leading [rad].
      real(dp), intent(in) :: step(4)
      real(dp) :: lengths(4), change(4)

      lengths = [state%half_width, state%trailing, state%leading, free_length(state)]
      change = [step(1), step(3), step(4), -(2*step(1) + step(3) + step(4))]
      share = min(1.0_dp, minval(0.9_dp*lengths/max(-change, tiny(1.0_dp)), mask=-change > 0.9_dp*lengths))
   end function largest_share

   !> Newton's method on the two edges of adhesion where there is no contact.
   pure subroutine refine_adhesion_edges(strip, state)
      type(strip_t), intent(in) :: strip
      !> In: a guess of half_width and shift of the adhesion zone. Out: the edges; `is_converged` tells whether they were found.
      type(steady_state_t), intent(inout) :: state
      real(dp) :: value(2), by_depth(2), jacobian(2, 2), step(2), size_now, size_last
      integer :: iteration

      state%is_converged = .false.
      state%regime = regime_adhesion_only
      state%trailing = 0
      state%leading = 0
      state%entry = 0
      size_last = huge(1.0_dp)
      do iteration = 1, max_iterations
         call get_adhesion_equations(strip, state, value, jacobian, by_depth)
         step = solve_pair(jacobian, value)
         size_now = maxval(abs(step))/state%half_width
         if (.not. size_now < 0.5_dp) return
         state%half_width = state%half_width + (step(1) + step(2))/2
         state%shift = state%shift + (step(2) - step(1))/2
         if (state%half_width <= 0 .or. 2*state%half_width >= two_pi) return
         state%is_converged = size_now <= close_enough .or. (size_now <= round_off .and. size_now >= size_last/2)
         if (state%is_converged) exit
         size_last = size_now
      end do
      if (state%is_converged) state%multiplier = get_multiplier(strip, state)
   end subroutine refine_adhesion_edges

   !> Do the edges of contact with adhesion zones fulfil every inequality of the model? The closed forms
   !> then have no earlier event (see `stepping`), so signs at the edges are enough.
   pure logical function is_admissible(strip, state)
      type(strip_t), intent(in) :: strip
      !> The state that is judged, with contact and adhesion zones.
      type(steady_state_t), intent(in) :: state
      real(dp) :: a, b, margin

      a = state%half_width - state%shift
      b = state%half_width + state%shift
      is_admissible = state%is_converged .and. state%half_width > 0 &
         & .and. (state%trailing > 0 .or. strip%adhesion%is_lost_at_contact) .and. state%leading >= 0 .and. free_length(state) > 0
      if (.not. is_admissible) return
      margin = drive_round_off(strip)
      is_admissible = drive(strip, -a) < margin .and. drive(strip, -a - state%trailing) < margin - strip%adhesion%release_gap &
         & .and. drive(strip, b + state%leading) > strip%adhesion%stress - strip%adhesion%attach_gap - margin &
         & .and. drive(strip, b) > state%entry - margin
   end function is_admissible

   !> Does an adhesion zone without contact fulfil every inequality? Its gap is least at the end of the interval where
   !> the drive is positive, or at the end of the zone.
   pure logical function is_admissible_adhesion(strip, state, may_touch)
      type(strip_t), intent(in) :: strip
      !> The state that is judged, with adhesion and without contact.
      type(steady_state_t), intent(in) :: state
      !> May the gap touch zero? It may not if this is absent.
      logical, intent(in), optional :: may_touch
      real(dp) :: a, b, span, margin

      a = state%half_width - state%shift
      b = state%half_width + state%shift
      margin = drive_round_off(strip)
      is_admissible_adhesion = state%is_converged .and. .not. strip%adhesion%snaps &
         & .and. drive(strip, -a) < margin - strip%adhesion%release_gap &
         & .and. drive(strip, b) > strip%adhesion%stress - strip%adhesion%attach_gap - margin
      if (.not. is_admissible_adhesion) return
      if (present(may_touch)) then
         if (may_touch) return
      end if
      span = remaining_phases(strip, b, 0.0_dp, .false.)
      if (span < 0 .or. span >= 2*state%half_width) return
      is_admissible_adhesion = strip%adhesion%attached_gap - 2*sin(b - span/2)*sin(span/2) &
         & - (lifted_profile(strip, b) + strip%adhesion%attach_gap - strip%adhesion%jump)*decay(span/strip%foundation%v) > 0
   end function is_admissible_adhesion

   !> Derivative of the return map at a steady state with adhesion and free zones.
   pure real(dp) function get_multiplier(strip, state) result(multiplier)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      type(edge_rates_t) :: rates
      real(dp) :: kept, denominator

      rates = get_rates(strip, state)
      kept = exp(-min(rates%damping, longest_decay))*rates%freed*rates%attached
      denominator = rates%release*rates%attach
      multiplier = huge(1.0_dp)
      if (abs(kept) < unstable*abs(denominator)) multiplier = kept/denominator
   end function get_multiplier

   !> What the edges of adhesion do to a disturbance.
   pure type(edge_rates_t) function get_rates(strip, state) result(rates)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      real(dp) :: a1, b, b1

      associate (f => strip%foundation)
         a1 = state%half_width - state%shift + state%trailing
         b = state%half_width + state%shift
         b1 = b + state%leading
         rates%damping = two_pi/f%v
         if (state%regime == regime_adhesion_zones) rates%damping = rates%damping + 2*state%half_width*(1/f%u - 1/f%v)
         rates%release = -drive(strip, -a1) - strip%adhesion%release_gap
         rates%freed = rates%release + strip%adhesion%stress - strip%adhesion%jump
         rates%attach = -drive(strip, b1) + strip%adhesion%stress - strip%adhesion%attach_gap
         if (state%entry > 0) then
            rates%attached = -drive(strip, b) + state%entry
         else
            rates%attached = -drive(strip, b1) - strip%adhesion%attach_gap + strip%adhesion%jump
         end if
      end associate
   end function get_rates

end module adfric_foundation_edges
