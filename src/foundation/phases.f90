! SPDX-License-Identifier: GPL-3.0-or-later
!> Intervals of the phase in which the drive of a strip is above or below a bound.
module adfric_foundation_phases
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, two_pi
   use adfric_foundation_strip, only: strip_t
   implicit none (type, external)
   private
   public :: remaining_phases, phases_since, half_interval

contains

   !> Phase remaining from xi to the next end of the interval where the drive is above a bound, or below it;
   !> a whole period if it always is, negative if it never is.
   pure real(dp) function remaining_phases(strip, xi, bound, below, is_outside) result(left)
      type(strip_t), intent(in) :: strip
      !> Phase where the path begins [rad]; it falls along the path.
      real(dp), intent(in) :: xi
      !> Bound of the drive [c].
      real(dp), intent(in) :: bound
      !> Is the interval where the drive is below the bound? Else it is where the drive is above.
      logical, intent(in) :: below
      !> Is xi known to be outside the interval? Then the whole interval lies ahead, even if round-off says that xi has
      !> only just left it.
      logical, intent(in), optional :: is_outside
      real(dp) :: ratio, crossing

      associate (v => strip%foundation%v)
         ratio = (bound - strip%level)/sqrt(1 + v*v)
         left = merge(two_pi, -1.0_dp, ratio > 0 .eqv. below)
         if (abs(ratio) >= 1) return
         crossing = acos(ratio)
         if (below) crossing = -crossing
         ! the drive is level + hypot(1, v) cos(tau), tau = atan(v) - xi growing
         left = modulo(crossing - atan(v) + xi, two_pi)
         if (.not. present(is_outside)) return
         if (below) crossing = pi + crossing
         if (is_outside .and. left < crossing) left = left + two_pi
      end associate
   end function remaining_phases

   !> Half the length of the interval where the drive is above a bound, or below it.
   pure real(dp) function half_interval(strip, bound, below) result(half)
      type(strip_t), intent(in) :: strip
      real(dp), intent(in) :: bound
      logical, intent(in) :: below
      real(dp) :: ratio

      ratio = (bound - strip%level)/sqrt(1 + strip%foundation%v**2)
      half = acos(max(-1.0_dp, min(1.0_dp, ratio)))
      if (below) half = pi - half
   end function half_interval

   !> Phase passed at xi since the drive came above a bound; a whole period if it always is, 0 if it never is.
   pure real(dp) function phases_since(strip, xi, bound) result(since)
      type(strip_t), intent(in) :: strip
      !> Phase where the path ends [rad].
      real(dp), intent(in) :: xi
      real(dp), intent(in) :: bound
      real(dp) :: ratio

      associate (v => strip%foundation%v)
         ratio = (bound - strip%level)/sqrt(1 + v*v)
         since = merge(0.0_dp, two_pi, ratio > 0)
         if (abs(ratio) < 1) since = modulo(atan(v) - xi + acos(ratio), two_pi)
      end associate
   end function phases_since

end module adfric_foundation_phases
