! SPDX-License-Identifier: GPL-3.0-or-later
!> What is prescribed in time: approach, load, or the position of a base behind a spring, leg by leg. A leg is straight, has a sine
!> on it, or is a jump, which takes no time.
module adfric_round_timed_path
   use adfric_base_kinds, only: dp
   use adfric_numerics_exact_pairs, only: get_sum
   implicit none (type, external)
   private
   public :: timed_leg_t, timed_control_t, mark_t
   public :: falls_to_zero, later, prescribed_at, prescribed_rate, prescribed_rise, time_between

   !> One leg. Along it the phase goes from 0 to 1.
   type :: timed_leg_t
      !> Time at the begin, and length in time, >= 0.
      real(dp) :: clock = 0, span = 0
      !> What is prescribed at the begin and at the end, without the sine.
      real(dp) :: begin = 0, end = 0
      !> Amplitude of the sine, its angular frequency [rad/unit of time], and its angle at the begin [rad].
      real(dp) :: amplitude = 0, frequency = 0, angle = 0
   end type timed_leg_t

   !> What is prescribed: u = by_approach delta + by_load P.
   type :: timed_control_t
      !> 1 and 0 for an approach, 0 and 1 for a load, 1 and the compliance of the spring for a base.
      real(dp) :: by_approach = 1, by_load = 0
   end type timed_control_t

   !> A moment of a path. Its phase is phase + rest: a short time since another moment has all its digits, wherever both are.
   type :: mark_t
      !> Leg.
      integer :: leg = 1
      !> Phase of the leg, and what its rounding left.
      real(dp) :: phase = 0, rest = 0
   end type mark_t

contains

   !> Does what is prescribed fall to 0 at the end of a leg, without a sine?
   elemental logical function falls_to_zero(leg)
      type(timed_leg_t), intent(in) :: leg

      falls_to_zero = leg%begin > 0 .and. .not. abs(leg%end) > 0 .and. .not. abs(leg%amplitude) > 0
   end function falls_to_zero

   !> A moment of the same leg, later by a step in phase.
   pure type(mark_t) function later(mark, step)
      type(mark_t), intent(in) :: mark
      !> The step.
      real(dp), intent(in) :: step
      real(dp) :: total, rest

      call get_sum(mark%phase, step, total, rest)
      later%leg = mark%leg
      call get_sum(total, rest + mark%rest, later%phase, later%rest)
   end function later

   !> The time between two moments.
   pure real(dp) function time_between(legs, early, late) result(time)
      !> Legs of the path.
      type(timed_leg_t), intent(in) :: legs(:)
      !> The moments, in their order.
      type(mark_t), intent(in) :: early, late

      if (early%leg == late%leg) then
         time = legs(late%leg)%span*((late%phase - early%phase) + (late%rest - early%rest))
      else
         time = legs(early%leg)%span*((1 - early%phase) - early%rest) + legs(late%leg)%span*(late%phase + late%rest)
         if (late%leg > early%leg + 1) time = time + (legs(late%leg)%clock - legs(early%leg + 1)%clock)
      end if
   end function time_between

   !> What is prescribed at a phase.
   elemental real(dp) function prescribed_at(leg, phase) result(value)
      type(timed_leg_t), intent(in) :: leg
      !> Phase, from 0 to 1.
      real(dp), intent(in) :: phase

      value = leg%begin + (leg%end - leg%begin)*phase
      if (abs(leg%amplitude) > 0) then
         value = value + leg%amplitude*(sin(leg%frequency*leg%span*phase + leg%angle) - sin(leg%angle))
      end if
   end function prescribed_at

   !> What it rises by from a phase to a later one, with all digits of this rise.
   elemental real(dp) function prescribed_rise(leg, phase, step) result(rise)
      type(timed_leg_t), intent(in) :: leg
      !> Phase at the begin, and how much later the other one is.
      real(dp), intent(in) :: phase, step

      rise = (leg%end - leg%begin)*step
      if (abs(leg%amplitude) > 0) then
         associate (half => leg%frequency*leg%span*step/2)
            rise = rise + 2*leg%amplitude*sin(half)*cos(leg%frequency*leg%span*phase + leg%angle + half)
         end associate
      end if
   end function prescribed_rise

   !> Its derivative by the phase.
   elemental real(dp) function prescribed_rate(leg, phase) result(rate)
      type(timed_leg_t), intent(in) :: leg
      !> Phase, from 0 to 1.
      real(dp), intent(in) :: phase

      rate = leg%end - leg%begin
      if (abs(leg%amplitude) > 0) then
         rate = rate + leg%amplitude*leg%frequency*leg%span*cos(leg%frequency*leg%span*phase + leg%angle)
      end if
   end function prescribed_rate

end module adfric_round_timed_path
