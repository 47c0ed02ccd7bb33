! SPDX-License-Identifier: GPL-3.0-or-later
!> What is prescribed in time: approach, load, or the position of a base behind a spring, leg by leg. A leg is straight, has a sine
!> on it, or is a jump, which takes no time.
module adfric_round_timed_path
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: timed_leg_t, timed_control_t, prescribed_at, prescribed_rate

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

contains

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
