! SPDX-License-Identifier: GPL-3.0-or-later
!> The integral over a stretch of one panel of a 3-D surface, by nested rules.
!>
!> A panel is mapped from -1..1 by \( \theta = \theta_0 + \Delta (3z - z^3)/2 \): near its ends forces go like half-integer
!> powers of the distance, which are smooth in \( z \). Where it ends on a line of symmetry, crest or valley, nothing
!> happens to the forces: such a panel is doubled to its mirror image, and half of the strips are enough.
!>
!> A rule is raised to the next, which keeps all its strips; where that gains little, the interval is halved.
module adfric_foundation_interval
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_constants, only: pi
   use adfric_numerics_patterson, only: n_levels, n_half, rule_nodes, rule_weights, first_stride
   use adfric_foundation_panels, only: panel_t
   use adfric_foundation_steady_state, only: find_steady_state
   use adfric_foundation_strip, only: strip_t, steady_state_t
   use adfric_foundation_surface, only: surface_t, totals_t, new_surface_strip, add_strip, add_totals, add_load_slope
   use adfric_foundation_wave_shape, only: share_at
   implicit none (type, external)
   private
   public :: interval_t, new_interval, raise_interval, split_interval, can_be_raised

   !> A rule that changes less than this share of what the one before it changed converges fast.
   real(dp), parameter :: fast = 0.1_dp
   !> The error of a rule, as a share of what the rule has changed, by level.
   real(dp), parameter :: gain(2:n_levels) = [2.0e-3_dp, 3.0e-2_dp, 1.0e-2_dp]
   !> A least error, as a share of what the first rule has changed: what rules of so few strips do not see.
   real(dp), parameter :: depth(2:n_levels) = [5.0e-6_dp, 4.0e-9_dp, 0.0_dp]
   !> How much closer than they are right two rules may agree by accident.
   real(dp), parameter :: accident = 10.0_dp

   !> A stretch of the mapped phase on one panel, and what its strips add up to.
   type :: interval_t
      !> Regime, ends and blur; doubled if it is mirrored.
      type(panel_t) :: panel
      !> Does the crest line or the valley line halve it, so that only what lies beyond is summed?
      logical :: is_mirrored = .false.
      !> Number under which its strips are remembered.
      integer :: position = 0
      !> Ends in \( z \).
      real(dp) :: start = -1, finish = 1
      !> The rule that was reached.
      integer :: level = 0
      !> Sums by all rules: a strip is added to its own and to all higher ones at once.
      type(totals_t) :: sums(0:n_levels)
      !> Largest load and friction of a unit of width.
      real(dp) :: peak(2) = 0
      !> Errors of load and friction: of the rule, and of round-off and of where the panel ends, which no finer rule takes away.
      real(dp) :: error(2) = 0, blur(2) = 0
      !> Are all strips in the regime of the panel?
      logical :: is_uniform = .true.
   end type interval_t

contains

   !> A whole panel, without any strips yet.
   pure type(interval_t) function new_interval(panel, position) result(interval)
      !> The panel that the interval covers; its ends are in [0, pi].
      type(panel_t), intent(in) :: panel
      !> Number under which the strips are remembered, from 1.
      integer, intent(in) :: position

      if (has_asserts) call assert(panel%start >= 0 .and. panel%start < panel%finish .and. panel%finish <= pi, &
         & 'new_interval: 0 <= start < finish <= pi')
      interval%panel = panel
      interval%position = position
      interval%is_mirrored = panel%start <= 0 .or. panel%finish >= pi
      if (panel%start <= 0) then
         interval%panel%start = -panel%finish
      else if (panel%finish >= pi) then
         ! counted from the valley, so that what is beyond the line is the panel itself
         interval%panel%start = 2*pi - panel%start
         interval%panel%finish = panel%start
      end if
   end function new_interval

   !> Raise an interval to the next rule.
   pure subroutine raise_interval(surface, penetration, needs_slope, interval, states)
      type(surface_t), intent(in) :: surface
      !> Penetration of the crests into the undisturbed surface [h].
      real(dp), intent(in) :: penetration
      !> Is the change of the load with the penetration asked for?
      logical, intent(in) :: needs_slope
      !> The interval: its level rises by one, and sums and errors become those of the next rule.
      type(interval_t), intent(inout) :: interval
      !> States at the nodes of the finest rule. In: those beyond the rule that was reached are of another surface; they save time.
      !> Out: those of the next rule are of this surface.
      type(steady_state_t), intent(inout) :: states(-n_half:n_half)
      type(steady_state_t) :: near
      integer :: stride, lowest, j

      interval%level = interval%level + 1
      stride = first_stride/2**(interval%level - 1)
      lowest = merge(0, -(n_half/stride)*stride, interval%is_mirrored)
      do j = lowest, n_half, stride
         ! all others are already there
         if (interval%level > 1 .and. mod(j/stride, 2) == 0) cycle
         if (j > lowest) then
            near = states(j - stride)
         else if (interval%level > 1) then
            near = states(j + stride)
         end if
         call add_node(surface, penetration, needs_slope, interval, j, near, states(j))
      end do
      if (interval%level > 1) call estimate_error(interval)
   end subroutine raise_interval

   !> Solve the strip at a node of the finest rule, and add it to all rules that know it.
   pure subroutine add_node(surface, penetration, needs_slope, interval, j, near, state)
      type(surface_t), intent(in) :: surface
      real(dp), intent(in) :: penetration
      logical, intent(in) :: needs_slope
      !> The interval; the sums of all rules that know the node take in the strip.
      type(interval_t), intent(inout) :: interval
      !> Number of the node, counted from the midpoint, of either sign.
      integer, intent(in) :: j
      !> State of a strip nearby, the guess where `state` is not in the regime of the panel.
      type(steady_state_t), intent(in) :: near
      !> In: the state at this node on another surface, as a guess. Out: the state on this surface.
      type(steady_state_t), intent(inout) :: state
      type(totals_t) :: node
      type(strip_t) :: strip
      type(steady_state_t) :: guess
      real(dp) :: z, half, width, share
      integer :: level

      ! the midpoint is a rule of its own
      level = merge(0, interval%level, j == 0)
      half = (interval%finish - interval%start)/2
      z = (interval%start + interval%finish)/2 + sign(half, real(j, dp))*rule_nodes(abs(j))
      associate (panel => interval%panel)
         share = share_at((panel%start + panel%finish)/2 + (panel%finish - panel%start)/4*z*(3 - z*z))
         ! dy = d theta/(2 pi), twice for both sides of the crest line
         width = abs(panel%finish - panel%start)*0.75_dp*(1 - z)*(1 + z)*half/pi
         if (interval%is_mirrored .and. j == 0) width = width/2
         call new_surface_strip(surface, penetration, share, strip)
         guess = state
         if (guess%regime /= panel%regime) guess = near
         call find_steady_state(strip, surface%branch, state, guess, guess%regime == panel%regime)
         interval%is_uniform = interval%is_uniform .and. state%regime == panel%regime
      end associate
      call add_strip(surface, strip, state, share, width, node)
      if (needs_slope) call add_load_slope(strip, state, width, node)
      interval%peak = max(interval%peak, abs([node%load, node%friction])/width)
      do level = level, n_levels
         call add_totals(interval%sums(level), node, rule_weights(abs(j), level))
      end do
   end subroutine add_node

   !> Error of the rule that was reached.
   !>
   !> What a rule has changed is the error of the one before, and its own is far less. How much less depends on how close
   !> to the panel's ends the strips change steeply: `gain` and `depth` are such that one estimate in a hundred is too
   !> small (`bench/error_estimates`).
   pure subroutine estimate_error(interval)
      !> The interval, at the second rule or higher; its error and blur are set.
      type(interval_t), intent(inout) :: interval
      real(dp) :: last(2)

      associate (sums => interval%sums, level => interval%level)
         last = change(sums(level - 1), sums(level))
         interval%error = min(accident*last, max(gain(level)*last, depth(level)*change(sums(0), sums(1))))
         ! an end that is not known well moves the integral by what stands there
         interval%blur = interval%panel%blur/pi*interval%peak &
            & + epsilon(1.0_dp)*[sums(level)%load_scale, sums(level)%friction_scale]
      end associate
   end subroutine estimate_error

   !> By how much load and friction differ.
   pure function change(one, two)
      type(totals_t), intent(in) :: one, two
      real(dp) :: change(2)

      change = abs([two%load - one%load, two%friction - one%friction])
   end function change

   !> Is there a higher rule, and do they converge fast?
   pure logical function can_be_raised(interval, scales)
      type(interval_t), intent(in) :: interval
      !> Sizes of load and friction that errors are relative to.
      real(dp), intent(in) :: scales(2)

      associate (sums => interval%sums, level => interval%level)
         can_be_raised = level < n_levels .and. maxval(change(sums(level - 1), sums(level))/scales) &
            & <= fast*maxval(change(sums(level - 2), sums(level - 1))/scales)
      end associate
   end function can_be_raised

   !> Halve an interval; both halves begin anew, and are remembered apart from the whole, which comes first next time.
   pure subroutine split_interval(interval, other, last_position)
      !> In: the whole interval. Out: one half of it; of a mirrored one the part about the line.
      type(interval_t), intent(inout) :: interval
      !> The other half; of a mirrored one the part beyond.
      type(interval_t), intent(out) :: other
      !> The last number under which strips are remembered; it rises by two.
      integer, intent(inout) :: last_position
      type(interval_t) :: whole
      real(dp) :: inner

      whole = interval
      ! of a mirrored one, half of what is summed: the part about the line, and the part beyond
      inner = (whole%finish - whole%start)/merge(4, 2, whole%is_mirrored)
      interval = interval_t(whole%panel, whole%is_mirrored, last_position + 1, whole%start, whole%finish - inner)
      if (whole%is_mirrored) interval%start = whole%start + inner
      other = interval_t(whole%panel, .false., last_position + 2, whole%finish - inner, whole%finish)
      last_position = last_position + 2
   end subroutine split_interval

end module adfric_foundation_interval
