! SPDX-License-Identifier: GPL-3.0-or-later
!> The path of one column of the foundation under the surface, from event to event.
!>
!> In every zone the closed form of GM holds, and each zone can end only in one interval of the phase, where the
!> quantity that ends it is monotone: contact ends where the drive (see `strip`) is negative, a gap closes where
!> it is positive, adhesion is lost where it is below -release_gap, and is found again where it is above
!> stress - attach_gap (see `adhesion`). So every event is a bracketed root, and none can be missed or taken twice.
module adfric_foundation_strip_stepping
   use adfric_base_kinds, only: dp
   use adfric_numerics_scalar_root, only: equation_t, find_root
   use adfric_foundation_contact_zone, only: decay, longest_decay
   use adfric_foundation_phases, only: remaining_phases, half_interval
   use adfric_foundation_strip, only: strip_t, profile, lifted_profile, drive, get_drive, drive_round_off
   implicit none (type, external)
   private
   public :: column_t, advance, leave_contact, step_period, step_to_leading_edge, period_t
   public :: in_contact, in_adhesion, in_free
   public :: period_closed, period_never_released, period_never_attached

   !> Zones a column can be in.
   integer, parameter :: in_contact = 1, in_adhesion = 2, in_free = 3
   !> How a period that starts at the leading edge of adhesion can end.
   integer, parameter :: period_closed = 1, period_never_released = 2, period_never_attached = 3

   !> A column of the foundation.
   type :: column_t
      !> Zone that the column is in, one of `in_...`.
      integer :: zone = in_free
      !> Phase; falls as the surface moves on.
      real(dp) :: xi = 0
      !> Contact: pressure + stress; adhesion: displacement + stress; free: displacement.
      real(dp) :: value = 0
      !> Gap (0 in contact).
      real(dp) :: gap = 0
      !> Has the zone just begun, at an event?
      logical :: has_begun = .false.
   end type column_t

   !> What happened between two passages of the leading edge of adhesion.
   type :: period_t
      !> How the period ends, one of `period_...`.
      integer :: outcome = period_closed
      !> Phase where it starts.
      real(dp) :: start = 0
      !> Lengths of the zones: leading adhesion, contact, trailing adhesion, free. Without contact all adhesion
      !> is `leading`.
      real(dp) :: leading = 0, contact = 0, trailing = 0, free = 0
      !> Was there contact in the period?
      logical :: has_contact = .false.
      !> Was adhesion lost?
      logical :: is_released = .false.
      !> Drive and its slope where the period starts, and where adhesion is lost.
      real(dp) :: attach_drive = 0, attach_slope = 0, release_drive = 0, release_slope = 0
      !> What the contact leaves of a disturbance, over what an open zone of its length would leave; 0 if contact never ends.
      real(dp) :: kept = 1
      !> Derivative of the end with respect to the start.
      real(dp) :: slope = 0
   end type period_t

   !> What ends a zone, as a function of the phase d passed since it began:
   !> start + amplitude decay(d/length) + x (1 - cos d) + y sin d.
   type, extends(equation_t) :: strip_zone_curve_t
      !> Numbers of this formula; the length is a phase.
      real(dp) :: start = 0, amplitude = 0, length = 1, x = 0, y = 0
   contains
      procedure :: evaluate
   end type strip_zone_curve_t

contains

   !> Value and slope of a zone curve.
   pure subroutine evaluate(self, x, value, slope)
      class(strip_zone_curve_t), intent(in) :: self
      !> Phase d passed since the zone began [rad], >= 0.
      real(dp), intent(in) :: x
      !> Value of the curve.
      real(dp), intent(out) :: value
      !> Derivative of the curve with respect to the phase.
      real(dp), intent(out) :: slope
      real(dp) :: lost

      lost = decay(x/self%length)
      value = self%start + self%amplitude*lost + self%x*(2*sin(x/2)**2) + self%y*sin(x)
      slope = self%amplitude*(1 - lost)/self%length + self%x*sin(x) + self%y*cos(x)
   end subroutine evaluate

   !> Pressure above -stress in contact.
   pure type(strip_zone_curve_t) function contact_curve(strip, column) result(curve)
      type(strip_t), intent(in) :: strip
      type(column_t), intent(in) :: column
      real(dp) :: along

      associate (f => strip%foundation)
         along = f%storage*cos(column%xi) + f%loss*sin(column%xi)
         curve%start = column%value
         curve%length = f%u
         curve%amplitude = -(column%value - strip%level - along)
         curve%x = -along
         curve%y = f%storage*sin(column%xi) - f%loss*cos(column%xi)
      end associate
   end function contact_curve

   !> Gap above a bound in an open zone.
   pure type(strip_zone_curve_t) function gap_curve(strip, column, bound) result(curve)
      type(strip_t), intent(in) :: strip
      !> A column in an open zone, in adhesion or free.
      type(column_t), intent(in) :: column
      !> Gap that is subtracted: 0, or that of attachment or release [c].
      real(dp), intent(in) :: bound

      curve%start = column%gap - bound
      curve%length = strip%foundation%v
      curve%amplitude = -column%value
      curve%x = cos(column%xi)
      curve%y = -sin(column%xi)
   end function gap_curve

   !> Follow a curve up to the end of the interval of the drive in which it may cross zero, and find where it did.
   pure subroutine follow(strip, curve, span, bound, below, rises, crosses, passed)
      type(strip_t), intent(in) :: strip
      type(strip_zone_curve_t), intent(in) :: curve
      !> Phase to the end of the interval [rad]; negative if there is none.
      real(dp), intent(in) :: span
      !> Bound of the drive at which the interval begins and ends [c].
      real(dp), intent(in) :: bound
      !> Is the interval where the drive is below the bound? Else it is where the drive is above.
      logical, intent(in) :: below
      logical, intent(in) :: rises
      !> Does the curve cross zero before the interval ends?
      logical, intent(out) :: crosses
      !> In: a guess, or 0. Out: the phase passed up to the crossing, if there is one [rad].
      real(dp), intent(inout) :: passed
      real(dp), parameter :: looks(3) = [0.0_dp, 0.2_dp, 1.0_dp]
      real(dp) :: value, slope, limit
      integer :: k
      logical :: is_converged

      crosses = .false.
      ! once crossed it stays so up to the end; but there, where relaxation is fast, it may be back at round-off
      do k = 1, size(looks)
         limit = span
         if (k > 1) limit = span - looks(k)*half_interval(strip, bound, below)
         if (.not. limit > 0) return
         call curve%evaluate(limit, value, slope)
         crosses = merge(value >= 0, value <= 0, rises)
         if (crosses) exit
      end do
      if (.not. crosses) return
      call find_root(curve, 0.0_dp, limit, rises, passed, is_converged)
   end subroutine follow

   !> Move a column to its next event. `has_event` is false if the zone lasts for more than a period.
   pure subroutine advance(strip, column, passed, has_event)
      type(strip_t), intent(in) :: strip
      !> In: a column in its zone. Out: the column where the next zone begins; as it was if the zone does not end.
      type(column_t), intent(inout) :: column
      !> In: a guess of the phase passed, or 0. Out: the phase passed [rad].
      real(dp), intent(inout) :: passed
      !> Does the zone end within a period?
      logical, intent(out) :: has_event
      type(strip_zone_curve_t) :: curve
      real(dp) :: bound

      bound = 0
      select case (column%zone)
      case (in_contact)
         curve = contact_curve(strip, column)
         call follow(strip, curve, remaining_phases(strip, column%xi, 0.0_dp, .true., column%has_begun), &
            & 0.0_dp, .true., .false., has_event, passed)
      case (in_adhesion)
         call end_adhesion(strip, column, curve, bound, has_event, passed)
      case default
         curve = gap_curve(strip, column, strip%adhesion%attach_gap)
         bound = strip%adhesion%stress - strip%adhesion%attach_gap
         call follow(strip, curve, remaining_phases(strip, column%xi, bound, .false., column%has_begun), &
            & bound, .false., .false., has_event, passed)
      end select
      if (.not. has_event) return
      column%value = column%value*(1 - decay(passed/curve%length))
      column%xi = column%xi - passed
      select case (column%zone)
      case (in_contact)
         column = leave_contact(strip, column%xi)
      case (in_adhesion)
         if (bound > 0) then
            column = column_t(in_free, column%xi, column%value - strip%adhesion%stress + strip%adhesion%jump, &
               & strip%adhesion%released_gap, .true.)
         else
            column = column_t(in_contact, column%xi, 0.0_dp, 0.0_dp, .true.)
         end if
      case default
         call attach(strip, column)
      end select
   end subroutine advance

   !> The column where contact ends: in adhesion, or free at once where there is none beside the contact.
   pure type(column_t) function leave_contact(strip, xi) result(column)
      type(strip_t), intent(in) :: strip
      !> Phase where contact ends [rad].
      real(dp), intent(in) :: xi

      if (strip%adhesion%is_lost_at_contact) then
         column = column_t(in_free, xi, profile(strip, xi) + strip%adhesion%jump, strip%adhesion%released_gap, .true.)
      else
         column = column_t(in_adhesion, xi, lifted_profile(strip, xi), 0.0_dp, .true.)
      end if
   end function leave_contact

   !> Adhesion ends in contact or in freedom, whichever comes first.
   pure subroutine end_adhesion(strip, column, curve, bound, has_event, passed)
      type(strip_t), intent(in) :: strip
      type(column_t), intent(in) :: column
      !> Gap less the gap at which the zone ends, as a function of the phase passed.
      type(strip_zone_curve_t), intent(out) :: curve
      !> Gap at which the zone ends: 0 or that of release [c].
      real(dp), intent(out) :: bound
      logical, intent(out) :: has_event
      real(dp), intent(inout) :: passed
      real(dp) :: to_closure, to_release
      integer :: try
      logical :: may_close

      ! it begins where contact ends or where freedom ends: outside the one interval or outside the other
      to_closure = remaining_phases(strip, column%xi, 0.0_dp, .false., column%has_begun .and. .not. column%gap > 0)
      to_release = remaining_phases(strip, column%xi, -strip%adhesion%release_gap, .true., column%has_begun .and. column%gap > 0)
      may_close = to_closure < to_release
      do try = 1, 2
         bound = merge(0.0_dp, strip%adhesion%release_gap, may_close)
         curve = gap_curve(strip, column, bound)
         call follow(strip, curve, merge(to_closure, to_release, may_close), &
            & merge(0.0_dp, -strip%adhesion%release_gap, may_close), .not. may_close, .not. may_close, has_event, passed)
         if (has_event) return
         may_close = .not. may_close
      end do
   end subroutine end_adhesion

   !> A free column comes to the gap of attachment: the displacement may jump, and the surface may snap
   !> straight into contact.
   pure subroutine attach(strip, column)
      type(strip_t), intent(in) :: strip
      !> In: a free column at the gap of attachment. Out: the column in adhesion, or in contact.
      type(column_t), intent(inout) :: column

      associate (adhesion => strip%adhesion)
         if (adhesion%snaps) then
            column = column_t(in_contact, column%xi, adhesion%entry, 0.0_dp, .true.)
         else
            column = column_t(in_adhesion, column%xi, lifted_profile(strip, column%xi) + adhesion%attached_gap, &
               & adhesion%attached_gap, .true.)
         end if
      end associate
   end subroutine attach

   !> Time stepping from one passage of the leading edge of adhesion to the next.
   pure subroutine step_period(strip, xi_start, period)
      type(strip_t), intent(in) :: strip
      !> Phase of the leading edge, where a free column comes into the range of adhesion [rad].
      real(dp), intent(in) :: xi_start
      !> In: a similar period, whose lengths are first guesses, or none. Out: this period.
      type(period_t), intent(inout) :: period
      type(period_t) :: guess
      type(column_t) :: column
      real(dp) :: passed
      integer :: event, zone
      logical :: has_event

      guess = period
      period = period_t(start=xi_start)
      call get_drive(strip, xi_start, period%attach_drive, period%attach_slope)
      ! where the drive is lower, no column comes into the range of adhesion
      if (.not. period%attach_drive > strip%adhesion%stress - strip%adhesion%attach_gap - drive_round_off(strip)) then
         period%outcome = period_never_attached
         return
      end if
      column%xi = xi_start
      call attach(strip, column)
      do event = 1, 4
         zone = column%zone
         select case (zone)
         case (in_contact)
            passed = guess%contact
         case (in_adhesion)
            passed = merge(guess%trailing, guess%leading, period%has_contact)
         case default
            passed = guess%free
         end select
         call advance(strip, column, passed, has_event)
         if (.not. has_event) then
            period%outcome = merge(period_never_attached, period_never_released, zone == in_free)
            if (zone == in_contact) period%kept = 0
            return
         end if
         select case (zone)
         case (in_contact)
            period%has_contact = .true.
            period%contact = passed
            associate (f => strip%foundation)
               period%kept = exp(-min(passed*(1/f%u - 1/f%v), longest_decay))
            end associate
         case (in_adhesion)
            if (period%has_contact) then
               period%trailing = passed
            else
               period%leading = passed
            end if
            ! contact again
            if (column%zone == in_contact .and. period%has_contact) exit
         case default
            period%free = passed
            period%slope = get_slope(strip, period)
            return
         end select
         if (column%zone /= in_free) cycle
         period%is_released = .true.
         call get_drive(strip, column%xi, period%release_drive, period%release_slope)
      end do
      period%outcome = period_never_released
   end subroutine step_period

   !> Derivative of the end of a period with respect to its start: the product over its zones, in which the rates where
   !> contact begins and ends cancel.
   pure real(dp) function get_slope(strip, period) result(slope)
      type(strip_t), intent(in) :: strip
      type(period_t), intent(in) :: period
      real(dp) :: length, least, freed, attach

      least = drive_round_off(strip)
      associate (p => period)
         length = p%leading + p%contact + p%trailing + p%free
         freed = 1 + (strip%adhesion%stress - strip%adhesion%jump)/max(-p%release_drive - strip%adhesion%release_gap, least)
         attach = drive(strip, p%start - length) + strip%adhesion%attach_gap - strip%adhesion%stress
         slope = exp(-min(length/strip%foundation%v, longest_decay))*p%kept*freed &
            & *(p%attach_drive + strip%adhesion%attach_gap - strip%adhesion%stress + strip%adhesion%attach_lift)/max(attach, least)
      end associate
   end function get_slope

   !> Time stepping a column to the first leading edge of adhesion that it passes.
   pure subroutine step_to_leading_edge(strip, column, outcome)
      type(strip_t), intent(in) :: strip
      !> In: a column in any zone. Out: the column at the leading edge, if it passes one.
      type(column_t), intent(inout) :: column
      !> `period_closed` if the column passes such an edge; else another of `period_...`.
      integer, intent(out) :: outcome
      real(dp) :: passed
      integer :: event
      logical :: has_event, is_free

      do event = 1, 4
         is_free = column%zone == in_free
         passed = 0
         call advance(strip, column, passed, has_event)
         outcome = merge(period_never_attached, period_never_released, is_free)
         if (.not. has_event) return
         outcome = period_closed
         if (is_free) return
      end do
      outcome = period_never_released
   end subroutine step_to_leading_edge

end module adfric_foundation_strip_stepping
