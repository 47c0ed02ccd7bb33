! SPDX-License-Identifier: GPL-3.0-or-later
!> What two stepped periods tell of all periods that start between them.
!>
!> A free column is known by its displacement w. Over a period w becomes T(w), and T increases. Its derivative is
!> $$ M = e^{-2\pi/v}\,\frac{D_0+\delta-\pi+\kappa}{D_0+\delta-\pi}\;
!>    \frac{-D_3-\delta+\pi-j}{-D_3-\delta}\;e^{-c(1/u-1/v)}, $$
!> where \( D_0 \) is the drive where adhesion takes hold, \( D_3 \) that where it is lost, c the length of the contact, j the
!> jump, and \( \kappa \) the lift (see `attach_lift`): each zone multiplies a disturbance by its decay and by the ratio of
!> the rates of the gap at its ends, and at the ends of contact these cancel. The further adhesion takes hold ahead of the
!> crest, the further behind it is lost, and the longer is the contact. So the two phases and the contact of any period
!> between two others lie between theirs, and with them, as the drive has only one extremum in each of the two intervals,
!> every factor of M between bounds in closed form. Where M does not pass 1, T(w) - w is monotone; where it may, tangents
!> of the extreme slopes bound T(w) - w from below.
module adfric_foundation_period_bounds
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_foundation_contact_zone, only: decay, longest_decay
   use adfric_foundation_strip_stepping, only: period_t, period_closed
   use adfric_foundation_strip, only: strip_t, profile, drive_round_off
   implicit none (type, external)
   private
   public :: bound_probe_t, judge_between, bound_multiplier, rise_of_displacement
   public :: between_clear, between_single, between_unknown

   !> What is known of the periods between two: none closes, one closes, or neither is sure.
   integer, parameter :: between_clear = 1, between_single = 2, between_unknown = 3

   !> A period that was stepped in a search.
   type, extends(period_t) :: bound_probe_t
      !> By how much the period is longer (direction 1) or shorter (-1) than 2 pi [rad].
      real(dp) :: excess = 0
   end type bound_probe_t

   !> Share of a bound that is relied upon; the rest is for round-off.
   real(dp), parameter :: reliable = 0.999_dp
   !> Longest path over which displacements are compared, over the retardation phase.
   real(dp), parameter :: longest = longest_decay/2
   !> Least denominator of a bound from above.
   real(dp), parameter :: least = 1.0e-60_dp

contains

   !> Does a period close between two?
   pure subroutine judge_between(strip, direction, near, far, is_far_open, verdict, centre)
      type(strip_t), intent(in) :: strip
      !> Direction of the search: 1 towards larger gaps (later leading edges), -1 towards smaller ones.
      integer, intent(in) :: direction
      !> The period where the search stands: it is closed, and its excess is positive.
      type(bound_probe_t), intent(in) :: near
      !> A period that starts further on in the direction of the search.
      type(bound_probe_t), intent(in) :: far
      !> Is the excess of `far` positive?
      logical, intent(in) :: is_far_open
      !> What is known of the periods between the two, one of `between_...`.
      integer, intent(out) :: verdict
      !> Where to look next if the verdict is unknown, as a share of the path from `near` to `far`.
      real(dp), intent(out) :: centre
      real(dp) :: most, fewest, width, rise, from_near, from_far

      centre = 0.5_dp
      if (direction > 0) then
         call bound_multiplier(strip, far, near, fewest, most)
      else
         call bound_multiplier(strip, near, far, fewest, most)
      end if
      if (.not. is_far_open) then
         verdict = merge(between_single, between_unknown, most < 1)
      else
         ! a step of the excess passes nothing, for the map increases
         verdict = between_unknown
         if (most <= 1 .or. fewest >= 1 .or. reliable*near%excess >= abs(far%start - near%start)) verdict = between_clear
      end if
      if (verdict /= between_unknown) return

      ! tangents, in the displacement
      if (max(abs(far%start - near%start), abs(near%excess), abs(far%excess)) > longest*strip%foundation%v) return
      width = abs(rise_of_displacement(strip, near%start, far%start - near%start))
      rise = abs(rise_of_displacement(strip, near%start, -direction*near%excess))
      from_near = width
      if (fewest < 1) from_near = reliable*rise/(1 - fewest)
      from_far = 0
      if (is_far_open .and. far%outcome == period_closed .and. most < 1/least) then
         rise = abs(rise_of_displacement(strip, far%start, -direction*far%excess)) &
            & *exp((near%start - far%start)/strip%foundation%v)
         from_far = reliable*rise/(most - 1)
      end if
      if (is_far_open .and. from_near + from_far > width) then
         verdict = between_clear
      else if (width > 0) then
         centre = min(max((width + from_near - from_far)/(2*width), 0.05_dp), 0.95_dp)
      end if
   end subroutine judge_between

   !> Bounds of the multiplier of all periods that start between two.
   pure subroutine bound_multiplier(strip, late, early, fewest, most)
      type(strip_t), intent(in) :: strip
      !> The period that starts later (at a smaller phase), and the one that starts earlier.
      type(bound_probe_t), intent(in) :: late, early
      !> Lower bound of the multiplier.
      real(dp), intent(out) :: fewest
      !> Upper bound of the multiplier.
      real(dp), intent(out) :: most
      real(dp) :: low, high, round_off, base, lift, jump

      round_off = drive_round_off(strip)
      base = exp(-min(two_pi/strip%foundation%v, longest_decay))
      lift = strip%adhesion%attach_lift
      jump = strip%adhesion%stress - strip%adhesion%jump
      call bound_drive(strip, late%attach_drive, late%attach_slope, early%attach_drive, early%attach_slope, low, high)
      associate (bound => strip%adhesion%stress - strip%adhesion%attach_gap)
         fewest = base*early%kept*(1 + lift/max(high - bound + round_off, least))
         most = base*late%kept*(1 + lift/max(low - bound - round_off, least))
      end associate
      call bound_release(strip, late, early, low, high)
      fewest = fewest*(1 + jump/max(-low - strip%adhesion%release_gap + round_off, least))
      most = most*(1 + jump/max(-high - strip%adhesion%release_gap - round_off, least))
   end subroutine bound_multiplier

   !> Least and greatest drive where adhesion is lost. One that is not lost has passed the end of the interval where it
   !> can be; one that never took hold, the beginning.
   pure subroutine bound_release(strip, late, early, low, high)
      type(strip_t), intent(in) :: strip
      type(bound_probe_t), intent(in) :: late, early
      !> Least and greatest drive where adhesion is lost [c].
      real(dp), intent(out) :: low, high
      real(dp) :: first(2), last(2)

      ! what takes hold earlier is lost later, at a smaller phase
      first = [-strip%adhesion%release_gap, 1.0_dp]
      last = [-strip%adhesion%release_gap, -1.0_dp]
      if (late%is_released) first = [late%release_drive, late%release_slope]
      if (early%is_released) last = [early%release_drive, early%release_slope]
      call bound_drive(strip, last(1), last(2), first(1), first(2), low, high)
   end subroutine bound_release

   !> Least and greatest drive between two phases that are less than half a period apart, or on both sides of its only
   !> extremum between them, from its values and slopes there.
   pure subroutine bound_drive(strip, at_low, slope_at_low, at_high, slope_at_high, low, high)
      type(strip_t), intent(in) :: strip
      !> Drive [c] and its slope [c/rad] at the smaller phase.
      real(dp), intent(in) :: at_low, slope_at_low
      !> Drive [c] and its slope [c/rad] at the larger phase.
      real(dp), intent(in) :: at_high, slope_at_high
      !> Least and greatest drive between the phases [c].
      real(dp), intent(out) :: low, high

      low = min(at_low, at_high)
      high = max(at_low, at_high)
      if (slope_at_low < 0 .and. slope_at_high > 0) low = strip%level - hypot(1.0_dp, strip%foundation%v)
      if (slope_at_low > 0 .and. slope_at_high < 0) high = strip%level + hypot(1.0_dp, strip%foundation%v)
   end subroutine bound_drive

   !> How much more the displacement of a free column is, brought back to the phase xi, if it comes into the range of adhesion
   !> at xi + d and not at xi.
   pure real(dp) function rise_of_displacement(strip, xi, d) result(rise)
      type(strip_t), intent(in) :: strip
      !> Phase to which both displacements are brought [rad].
      real(dp), intent(in) :: xi
      !> Distance of the other phase from xi, of either sign [rad].
      real(dp), intent(in) :: d

      rise = -2*sin(xi + d/2)*sin(d/2)*exp(-d/strip%foundation%v) &
         & - (profile(strip, xi) + strip%adhesion%attach_gap)*decay(d/strip%foundation%v)
   end function rise_of_displacement

end module adfric_foundation_period_bounds
