! SPDX-License-Identifier: GPL-3.0-or-later
!> The return map of a strip: where the leading edge of adhesion is found a period after it was at a phase, and the phase
!> to which it returns.
module adfric_foundation_return_map
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_foundation_strip_stepping, only: period_t, step_period, period_closed, period_never_released
   use adfric_foundation_period_bounds, only: bound_probe_t, judge_between, between_clear, between_single
   use adfric_foundation_phases, only: remaining_phases, phases_since
   use adfric_foundation_strip, only: strip_t
   implicit none (type, external)
   private
   public :: close_period

   integer, parameter :: max_periods = 2000, max_bisections = 60
   !> Phase after which a period counts as closed; Newton's method on the edges does the rest.
   real(dp), parameter :: closed = 1.0e-9_dp
   !> Longest steps of the phase, by Newton's method and where the excess rises.
   real(dp), parameter :: longest_step = 1, longest_rise = 0.25_dp

contains

   !> Move the leading edge of adhesion until the period closes: Newton's method on the return map, one-sided. What lies
   !> between two steps is known from bounds, or is looked into, so that no steady state is passed.
   pure subroutine close_period(strip, direction, first_step, xi, period, is_converged)
      type(strip_t), intent(in) :: strip
      !> Direction of the search: 1 towards larger gaps (later leading edges), -1 towards smaller ones.
      integer, intent(in) :: direction
      !> Least length of the first step where there is nothing to find [rad].
      real(dp), intent(in) :: first_step
      !> In: phase of the leading edge where the search starts [rad]. Out: that of the period.
      real(dp), intent(inout) :: xi
      !> The closed period, or one that shows that none closes (see its outcome).
      type(period_t), intent(out) :: period
      logical, intent(out) :: is_converged
      type(bound_probe_t) :: near, far
      real(dp) :: step, last
      integer :: k

      step = first_step
      call stepping_excess(strip, direction, xi, near)
      last = last_edge(strip, direction, xi)
      do k = 1, max_periods
         is_converged = is_closed(near)
         if (is_converged .or. near%outcome /= period_closed) exit
         ! on the rising side there is nothing to find: ever longer steps
         if (near%slope < 1) then
            step = min(near%excess/max(1 - near%slope, near%excess/4), longest_step)
         else
            step = max(near%excess, min(2*max(near%excess, step), longest_rise))
         end if
         step = min(step, direction*(near%start - last))
         if (.not. step > 0) exit
         far = near
         call stepping_excess(strip, direction, near%start - direction*step, far)
         call look_between(strip, direction, near, far, is_converged)
         near = far
         if (is_converged .or. near%excess <= 0) exit
      end do
      xi = near%start
      period = near%period_t
   end subroutine close_period

   !> The last phase in a direction where a column may come into the range of adhesion.
   pure real(dp) function last_edge(strip, direction, xi) result(last)
      type(strip_t), intent(in) :: strip
      integer, intent(in) :: direction
      !> Phase of a leading edge from which the path leads on [rad].
      real(dp), intent(in) :: xi

      associate (bound => strip%adhesion%stress - strip%adhesion%attach_gap)
         if (direction < 0) then
            last = xi + phases_since(strip, xi, bound)*(1 - 4*epsilon(xi))
         else
            last = xi - remaining_phases(strip, xi, bound, .false.)*(1 - 4*epsilon(xi))
         end if
      end associate
   end function last_edge

   !> Time stepping a period, and tell its excess.
   pure subroutine stepping_excess(strip, direction, xi, probe)
      type(strip_t), intent(in) :: strip
      integer, intent(in) :: direction
      !> Phase of the leading edge where the period starts [rad].
      real(dp), intent(in) :: xi
      !> In: a similar period, whose lengths are first guesses, or none. Out: this period.
      type(bound_probe_t), intent(inout) :: probe

      call step_period(strip, xi, probe%period_t)
      select case (probe%outcome)
      case (period_closed)
         probe%excess = direction*(probe%leading + probe%contact + probe%trailing + probe%free - two_pi)
      case (period_never_released)
         probe%excess = -direction
      case default
         probe%excess = direction
      end select
   end subroutine stepping_excess

   !> Is a period closed, but for an excess of either sign that is nothing?
   pure logical function is_closed(probe)
      type(bound_probe_t), intent(in) :: probe

      is_closed = probe%outcome == period_closed .and. abs(probe%excess) <= tolerance_of(probe)
   end function is_closed

   !> Excess that is nothing. In fast sliding a period takes next to nothing of a disturbance away, and must close the
   !> better, as far as round-off allows.
   pure real(dp) function tolerance_of(probe) result(tolerance)
      !> A period that was stepped; its slope tells what remains of a disturbance.
      type(bound_probe_t), intent(in) :: probe

      tolerance = closed*min(max(1 - probe%slope, 1.0e-6_dp), 1.0_dp)
   end function tolerance_of

   !> The first period that closes between two, if there is one. What cannot be judged is halved, and its first half
   !> judged first.
   pure subroutine look_between(strip, direction, near, far, is_found)
      type(strip_t), intent(in) :: strip
      integer, intent(in) :: direction
      !> In: the period where the search stands; its excess is positive. Out: that period, or one further on of the same kind.
      type(bound_probe_t), intent(inout) :: near
      !> In: a period further on. Out: the period that closes, if there is one; if there is none, the same as before; or one whose
      !> excess is not positive, if neither could be made out.
      type(bound_probe_t), intent(inout) :: far
      logical, intent(out) :: is_found
      real(dp) :: centre
      integer :: verdict

      call judge_between(strip, direction, near, far, far%excess > tolerance_of(far), verdict, centre)
      is_found = .false.
      select case (verdict)
      case (between_clear)
         return
      case (between_single)
         call polish_period(strip, direction, near%start, far, is_found)
      case default
         call search_between(strip, direction, near, far, centre, is_found)
      end select
   end subroutine look_between

   !> The first period that closes between two, where the first judgement did not tell.
   pure subroutine search_between(strip, direction, near, far, first_centre, is_found)
      type(strip_t), intent(in) :: strip
      integer, intent(in) :: direction
      !> The period where the search stands, and one further on; see `look_between`.
      type(bound_probe_t), intent(inout) :: near, far
      !> Where to look first, as a share of the path from `near` to `far`.
      real(dp), intent(in) :: first_centre
      logical, intent(out) :: is_found
      type(bound_probe_t) :: ahead(max_bisections), middle
      real(dp) :: centre
      integer :: n, k, verdict

      n = 1
      ahead(1) = far
      centre = first_centre
      is_found = .false.
      do k = 1, max_periods
         if (abs(ahead(n)%start - near%start) <= closed) then
            ! no more can be told
            is_found = ahead(n)%excess <= tolerance_of(ahead(n)) .and. ahead(n)%outcome == period_closed
            if (ahead(n)%excess <= tolerance_of(ahead(n))) exit
            near = ahead(n)
            n = n - 1
         else
            middle = near
            call stepping_excess(strip, direction, near%start + centre*(ahead(n)%start - near%start), middle)
            ! then nothing further on counts
            if (middle%excess <= tolerance_of(middle) .or. middle%outcome /= period_closed) n = 0
            n = min(n + 1, size(ahead))
            ahead(n) = middle
         end if
         do while (n > 0)
            associate (next => ahead(n))
               call judge_between(strip, direction, near, next, next%excess > tolerance_of(next), verdict, centre)
               if (verdict == between_single) then
                  far = next
                  call polish_period(strip, direction, near%start, far, is_found)
                  return
               end if
               if (verdict /= between_clear) exit
               near = next
               n = n - 1
            end associate
         end do
         if (n == 0) return
      end do
      far = ahead(n)
      far%excess = min(far%excess, 0.0_dp)
   end subroutine search_between

   !> The one period that closes between `near` (excess positive) and `far` (negative).
   pure subroutine polish_period(strip, direction, near, far, is_found)
      type(strip_t), intent(in) :: strip
      integer, intent(in) :: direction
      !> Phase of the leading edge where the near period starts [rad].
      real(dp), intent(in) :: near
      !> In: the far period. Out: the period that closes.
      type(bound_probe_t), intent(inout) :: far
      logical, intent(out) :: is_found
      real(dp) :: low, high, xi, newton
      integer :: k

      low = near
      high = far%start
      do k = 1, max_bisections
         is_found = is_closed(far) .or. (far%outcome == period_closed .and. abs(high - low) <= closed)
         if (is_found) return
         if (far%excess > 0) then
            low = far%start
         else
            high = far%start
         end if
         xi = low + (high - low)/2
         if (far%outcome == period_closed) then
            newton = far%start - direction*far%excess/max(1 - far%slope, abs(far%excess)/4)
            if ((newton - low)*(newton - high) < 0) xi = newton
         end if
         call stepping_excess(strip, direction, xi, far)
      end do
   end subroutine polish_period

end module adfric_foundation_return_map
