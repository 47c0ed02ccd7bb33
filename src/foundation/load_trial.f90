! SPDX-License-Identifier: GPL-3.0-or-later
!> What a surface carries at one penetration, beside the load that is sought, and what follows for other penetrations.
!>
!> With a fixed pattern of what adheres and what is free the displacement is a convex function of the penetration D, and a
!> larger pattern of adhesion lowers it. Adhesion grows with D on both branches, so of two penetrations D1 < D2
!> $$ P(D_2) - P(D_1) \le s(D_2)\,(D_2 - D_1), \qquad 0 \le s \le l/K, $$
!> where s is the slope of the load while the edges of adhesion stay where they are (`slope_bound`; docs/theory/columns_load.md
!> has the proof).
!> So a penetration that carries too much, by an excess e, is followed downwards by none that carries too little within e/s.
module adfric_foundation_load_trial
   use adfric_base_kinds, only: dp
   use adfric_foundation_crosswise, only: memory_t, get_totals
   use adfric_foundation_strip, only: steady_state_t
   use adfric_foundation_surface, only: share_of_scale, surface_t, totals_t
   implicit none (type, external)
   private
   public :: trial_t, try_penetration, try_near, carries_load, get_reach, get_fall, is_plain
   public :: is_past_least, has_moving_edges, round_off, indistinct

   !> Relative tolerance of what is known in closed form.
   real(dp), parameter :: round_off = 1.0e-13_dp
   !> Penetrations nearer to each other than this are one [h, or of the penetration].
   real(dp), parameter :: indistinct = 1.0e-10_dp
   !> On surfaces that are integrated across, whose slope is known but for what moving edges add, the load must change by this
   !> share of the slope's bound, and no more than this step may be in question [h], to be taken for monotone between two
   !> penetrations.
   real(dp), parameter :: plain_share = 0.1_dp, plain_step = 0.01_dp

   !> A penetration, and what it carries.
   type :: trial_t
      !> Penetration of the crests into the undisturbed surface [h].
      real(dp) :: penetration = 0
      !> The load less the one that is sought [h/K].
      real(dp) :: excess = 0
      !> Forces and areas at this penetration.
      type(totals_t) :: totals
      !> Errors of load and friction by the quadrature.
      real(dp) :: error(2) = 0
      !> The strip of the crest line.
      type(steady_state_t) :: crest
   end type trial_t

contains

   !> Load at a penetration.
   pure subroutine try_penetration(surface, penetration, load, memory, trial)
      type(surface_t), intent(in) :: surface
      !> Penetration of the crests into the undisturbed surface [h].
      real(dp), intent(in) :: penetration
      !> Load that is sought, per period in x (and y) [h/K].
      real(dp), intent(in) :: load
      !> Strips found before, as first guesses; they save time and change nothing. Out: those found here.
      type(memory_t), intent(inout) :: memory
      type(trial_t), intent(out) :: trial

      trial%penetration = penetration
      call get_totals(surface, penetration, memory, trial%totals, trial%error)
      trial%excess = trial%totals%load - load
      trial%crest = memory%crest
   end subroutine try_penetration

   !> Load at a penetration, or next to it towards `from` where a strip happens to be at the very end of its branch.
   pure subroutine try_near(surface, penetration, from, load, memory, trial)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      !> The penetration towards which it may move, by 3/128 of the path at most [h].
      real(dp), intent(in) :: from
      real(dp), intent(in) :: load
      type(memory_t), intent(inout) :: memory
      !> The penetration that was reached, and what it carries.
      type(trial_t), intent(out) :: trial
      integer :: k

      do k = 0, 3
         call try_penetration(surface, penetration + (from - penetration)*(k/128.0_dp), load, memory, trial)
         if (trial%totals%is_converged) return
      end do
   end subroutine try_near

   !> Does a trial carry the load, to a tenth of the tolerance (in 2-D to round-off)?
   pure logical function carries_load(surface, trial)
      !> The surface in reduced units, with the tolerance of its load.
      type(surface_t), intent(in) :: surface
      type(trial_t), intent(in) :: trial
      real(dp) :: tolerance

      tolerance = round_off
      if (has_moving_edges(surface)) tolerance = max(surface%tolerance/10, round_off)
      carries_load = abs(trial%excess) <= tolerance*max(abs(trial%totals%load), share_of_scale*trial%totals%load_scale) &
         & .and. abs(trial%excess) < huge(tolerance)
   end function carries_load

   !> Is the surface integrated across, with panels of one regime whose edges move with the penetration? Then the slope of the
   !> load is that of its strips and what the edges add, which is not known.
   pure logical function has_moving_edges(surface)
      type(surface_t), intent(in) :: surface

      has_moving_edges = surface%shape%is_3d .and. surface%n_strips == 0
   end function has_moving_edges

   !> How far from a trial the sign of its excess holds for certain [h]: downwards if it carries too much, upwards if it carries
   !> too little (`get_fall` knows more downwards).
   pure real(dp) function get_reach(trial, slope_bound) result(reach)
      !> The trial, whose excess is left when the sign may change.
      type(trial_t), intent(in) :: trial
      !> Bound of the slope: downwards that of the trial, upwards that of the furthest penetration in question [1/K].
      real(dp), intent(in) :: slope_bound

      reach = huge(reach)
      if (slope_bound > tiny(reach)*max(1.0_dp, abs(trial%excess))*2.0_dp**60) reach = abs(trial%excess)/slope_bound
   end function get_reach

   !> How far below a trial that carries too much nothing can carry too little [h].
   pure real(dp) function get_fall(surface, trial) result(fall)
      !> The surface in reduced units; adhesion pulls with its stress at most.
      type(surface_t), intent(in) :: surface
      type(trial_t), intent(in) :: trial

      fall = get_reach(trial, trial%totals%slope_bound)
      ! nothing that adheres pulls with more than the stress, and less of the surface adheres at smaller penetrations
      if (surface%adhesion%stress*(trial%totals%contact + trial%totals%adhesion) < trial%excess - trial%totals%load) &
         & fall = huge(fall)
   end function get_fall

   !> Does the load between two penetrations cross each level between its ends once, and none beyond the end that is further on
   !> the path?
   !>
   !> Where all adheres at the smaller penetration, and without adhesion, the load is convex and rises. Between the same regimes
   !> it is smooth, and turns at most twice: it rises with the penetration in one stretch between two where it falls
   !> (docs/theory/columns_load.md). So where it rises at the end that is further on the path it has passed no more than its
   !> largest value.
   pure logical function is_plain(surface, low, high, far)
      type(surface_t), intent(in) :: surface
      type(trial_t), intent(in) :: low, high, far
      real(dp) :: width, reach

      is_plain = low%totals%is_converged .and. high%totals%is_converged
      if (.not. is_plain .or. surface%adhesion%stress <= 0 .or. low%totals%is_attached) return
      is_plain = low%totals%structure == high%totals%structure .and. far%totals%load_slope > 0
      if (.not. is_plain .or. .not. has_moving_edges(surface)) return
      width = high%penetration - low%penetration
      ! what is certain from the start of the path is not in question
      reach = abs(high%excess)
      if (far%penetration > low%penetration) reach = abs(low%excess)
      is_plain = high%totals%slope_bound*(width - plain_step) <= reach &
         & .and. high%excess - low%excess > plain_share*high%totals%slope_bound*width
   end function is_plain

   !> Is the least load between two penetrations known to be no less than half of what the smaller of their excesses is, for the
   !> load has been looked at once more?
   !>
   !> Where the slope is known, a load that falls with the penetration after it has risen, seen from above, has passed the
   !> least of its stretch (see `is_plain`). On surfaces that are integrated across, the parabola through three trials tells.
   pure logical function is_past_least(surface, has_risen, below, low, high)
      type(surface_t), intent(in) :: surface
      !> Does the load rise with the penetration somewhere above `high`, between the same regimes?
      logical, intent(in) :: has_risen
      !> Three trials with rising penetration; `below` may be `low` where there is no third one.
      type(trial_t), intent(in) :: below, low, high
      real(dp) :: width, wider, slope, curvature, position, least

      is_past_least = .false.
      if (low%totals%structure /= high%totals%structure .or. .not. low%totals%is_converged) return
      if (.not. has_moving_edges(surface)) then
         is_past_least = has_risen .and. high%totals%load_slope <= 0
         return
      end if
      width = high%penetration - low%penetration
      wider = high%penetration - below%penetration
      if (.not. wider > width .or. wider > 4*plain_step .or. below%totals%structure /= low%totals%structure) return
      ! slope at `high` and half the curvature of the parabola
      curvature = ((below%excess - high%excess)/wider - (low%excess - high%excess)/width)/(wider - width)
      slope = (high%excess - low%excess)/width + curvature*width
      least = min(high%excess, low%excess)
      position = 0
      if (curvature > 0) position = min(max(slope/(2*curvature), 0.0_dp), width)
      is_past_least = high%excess - position*(slope - curvature*position) > least/2
   end function is_past_least

end module adfric_foundation_load_trial
