!> The return map of a strip: where the leading edge of adhesion is found a period after it was at a phase, and the phase
!> to which it returns.
module adfric_wavy_return_map
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_wavy_march, only: period_t, march_period, period_closed, period_never_released
   use adfric_wavy_phases, only: phases_since
   use adfric_wavy_strip, only: strip_t
   implicit none (type, external)
   private
   public :: close_period

   integer, parameter :: max_periods = 2000, max_bisections = 60
   !> Phase after which a period counts as closed; Newton's method on the edges does the rest.
   real(dp), parameter :: closed = 1.0e-9_dp
   !> Longest steps of the phase, by Newton's method and where the excess rises.
   real(dp), parameter :: longest_step = 1, longest_rise = 0.25_dp

contains

   !> Move the leading edge of adhesion until the period closes: Newton's method on the return map, one-sided,
   !> with every sign change and every turn of the map looked into, so that no steady state is passed.
   pure subroutine close_period(strip, direction, first_step, xi, period, is_converged)
      type(strip_t), intent(in) :: strip
      !> 1 towards larger gaps (later leading edges), -1 towards smaller ones.
      integer, intent(in) :: direction
      !> Least step where there is nothing to find.
      real(dp), intent(in) :: first_step
      !> Phase of the leading edge.
      real(dp), intent(inout) :: xi
      !> In: a period like it, if there is one. Out: the closed period, or one that shows that none closes (see its
      !> outcome).
      type(period_t), intent(inout) :: period
      logical, intent(out) :: is_converged
      real(dp) :: excess, step, last_xi, last_excess, last_slope, dip, earliest
      integer :: k

      step = first_step
      call march_excess(strip, direction, xi, period, excess)
      do k = 1, max_periods
         ! the bound itself may close to within round-off
         is_converged = excess <= closed*contraction(period) .and. period%outcome == period_closed
         if (is_converged .or. period%outcome /= period_closed) return
         ! on the rising side there is nothing to find: ever longer steps
         if (period%slope < 1) then
            step = min(excess/max(1 - period%slope, excess/4), longest_step)
         else
            step = max(excess, min(2*max(excess, step), longest_rise))
         end if
         last_xi = xi
         last_excess = excess
         last_slope = period%slope
         xi = xi - direction*step
         if (direction < 0) then
            ! no column comes into the range of adhesion earlier than this
            earliest = last_xi + phases_since(strip, last_xi, strip%stress - strip%range)*(1 - 4*epsilon(xi))
            xi = min(xi, earliest)
         end if
         call march_excess(strip, direction, xi, period, excess)
         do while (last_slope >= 1 .and. period%outcome /= period_closed .and. step > last_excess)
            ! the map increases, so a step of the excess passes nothing; a longer one may have
            step = max(step/2, last_excess)
            xi = last_xi - direction*step
            call march_excess(strip, direction, xi, period, excess)
         end do
         if (excess < -closed*contraction(period)) then
            call bisect_period(strip, direction, last_xi, xi, period, is_converged)
            return
         end if
         if (last_slope < 1 .and. (period%slope > 1 .or. period%outcome /= period_closed)) then
            dip = xi
            call look_between(strip, direction, last_xi, dip, period, is_converged)
            if (is_converged) then
               xi = dip
               return
            end if
            call march_excess(strip, direction, xi, period, excess)
         end if
      end do
      is_converged = .false.
   end subroutine close_period

   !> By how much a period is longer (direction 1) or shorter (-1) than it should be.
   pure subroutine march_excess(strip, direction, xi, period, excess)
      type(strip_t), intent(in) :: strip
      integer, intent(in) :: direction
      real(dp), intent(in) :: xi
      type(period_t), intent(inout) :: period
      real(dp), intent(out) :: excess

      call march_period(strip, xi, period)
      select case (period%outcome)
      case (period_closed)
         excess = direction*(period%leading + period%contact + period%trailing + period%free - two_pi)
      case (period_never_released)
         excess = -direction
      case default
         excess = direction
      end select
   end subroutine march_excess

   !> How much of a disturbance a period takes away: in fast sliding next to nothing, and then the period must close the
   !> better, as far as round-off allows.
   pure real(dp) function contraction(period)
      type(period_t), intent(in) :: period

      contraction = min(max(1 - period%slope, 1.0e-6_dp), 1.0_dp)
   end function contraction

   !> A period that closes between `near` (excess positive) and `far` (negative).
   pure subroutine bisect_period(strip, direction, near, far, period, is_converged)
      type(strip_t), intent(in) :: strip
      integer, intent(in) :: direction
      real(dp), intent(in) :: near
      !> In: the far end. Out: the leading edge where the period closes.
      real(dp), intent(inout) :: far
      type(period_t), intent(inout) :: period
      logical, intent(out) :: is_converged
      real(dp) :: low, high, xi, excess, newton
      integer :: k

      low = near
      high = far
      xi = low + (high - low)/2
      do k = 1, max_bisections
         call march_excess(strip, direction, xi, period, excess)
         is_converged = abs(excess) <= closed*contraction(period)
         far = xi
         ! a column that never closes its period, on the near side, shows that none closes further on
         if (is_converged .or. (excess > 0 .and. period%outcome /= period_closed)) return
         if (excess > 0) then
            low = xi
         else
            high = xi
         end if
         newton = xi - direction*excess/max(1 - period%slope, abs(excess)/4)
         xi = low + (high - low)/2
         if ((newton - low)*(newton - high) < 0 .and. period%outcome == period_closed) xi = newton
      end do
   end subroutine bisect_period

   !> The excess falls at `near` and rises at `far` (or there is no period there): does it touch zero between? The
   !> tangents at both ends bound a convex excess from below; where they meet is looked at next.
   pure subroutine look_between(strip, direction, near, far, period, is_converged)
      type(strip_t), intent(in) :: strip
      integer, intent(in) :: direction
      real(dp), intent(in) :: near
      !> In: the far end. Out: the leading edge where the period closes, if it does.
      real(dp), intent(inout) :: far
      type(period_t), intent(inout) :: period
      logical, intent(out) :: is_converged
      type(period_t) :: low_period, high_period
      real(dp) :: low, high, at_low, at_high, excess, width, meeting
      integer :: k

      low = near
      high = far
      is_converged = .false.
      call march_excess(strip, direction, low, low_period, at_low)
      call march_excess(strip, direction, high, high_period, at_high)
      do k = 1, max_bisections
         width = abs(high - low)
         if (width <= closed) return
         meeting = width/2
         if (high_period%outcome == period_closed) then
            associate (fall => low_period%slope - 1, rise => high_period%slope - 1)
               ! only where the excess is above both tangents
               if (at_high >= at_low + fall*width .and. at_low >= at_high - rise*width) then
                  meeting = (at_low - at_high + rise*width)/(rise - fall)
                  if (at_low + fall*meeting > closed) return
                  meeting = min(max(meeting, 0.05_dp*width), 0.95_dp*width)
               end if
            end associate
         end if
         far = low - direction*meeting
         call march_excess(strip, direction, far, period, excess)
         if (excess <= 0) then
            call bisect_period(strip, direction, near, far, period, is_converged)
            return
         end if
         if (period%outcome == period_closed .and. period%slope < 1) then
            low = far
            at_low = excess
            low_period = period
         else
            high = far
            at_high = excess
            high_period = period
         end if
      end do
   end subroutine look_between

end module adfric_wavy_return_map
