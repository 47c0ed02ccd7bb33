! SPDX-License-Identifier: GPL-3.0-or-later
!> Random strips, the same on every machine.
module random_strips
   use adfric_base_kinds, only: dp, i8
   use adfric_foundation_adhesion, only: adhesion_t, acting_adhesion
   use adfric_foundation_foundation, only: new_foundation
   use adfric_foundation_surface, only: surface_t
   use unit_strips, only: trial_strip_t, edge_continuous, edge_instantaneous, edge_front, branch_adhered, branch_approach
   implicit none (type, external)
   private
   public :: dice_t, draw_strip, draw_fast_strip, draw_front_strip, draw_surface

   !> A source of random numbers (Lewis, Goodman and Miller, 1969; multiplier of Park and Miller, 1993).
   type :: dice_t
      integer(i8) :: state = 20110504
   contains
      procedure :: between
      procedure :: between_log
   end type dice_t

contains

   !> Uniform in (low, high).
   real(dp) function between(self, low, high)
      class(dice_t), intent(inout) :: self
      real(dp), intent(in) :: low, high
      integer(i8), parameter :: multiplier = 48271, modulus = 2147483647

      self%state = mod(multiplier*self%state, modulus)
      between = low + (high - low)*real(self%state, dp)/real(modulus, dp)
   end function between

   !> Between two positive numbers, uniform in the logarithm.
   real(dp) function between_log(self, low, high)
      class(dice_t), intent(inout) :: self
      real(dp), intent(in) :: low, high

      between_log = exp(self%between(log(low), log(high)))
   end function between_log

   !> A strip that spans slow to fast, elastic to soft, weak to strong and short to long adhesion.
   subroutine draw_strip(dice, number, trial)
      type(dice_t), intent(inout) :: dice
      !> The edge rule and the branch follow in turn.
      integer, intent(in) :: number
      type(trial_strip_t), intent(out) :: trial

      trial%u = dice%between_log(1.0e-3_dp, 1.0e2_dp)
      trial%beta = dice%between_log(1.0_dp, 1.0e4_dp)
      trial%stress = dice%between_log(1.0e-3_dp, 1.0e2_dp)
      trial%range = dice%between_log(1.0e-3_dp, 10.0_dp)
      trial%penetration = dice%between(-0.1_dp, 2.0_dp)
      trial%edge = merge(edge_continuous, edge_instantaneous, mod(number, 2) == 0)
      trial%branch = merge(branch_adhered, branch_approach, mod(number/2, 2) == 0)
   end subroutine draw_strip

   !> A strip that slides fast, and whose valley is all but in the range of adhesion: a period takes next to nothing of a
   !> disturbance away, and several states lie close together.
   subroutine draw_fast_strip(dice, number, trial)
      type(dice_t), intent(inout) :: dice
      !> The edge rule and the branch follow in turn.
      integer, intent(in) :: number
      type(trial_strip_t), intent(out) :: trial

      call draw_strip(dice, number, trial)
      trial%u = dice%between_log(1.0_dp, 1.0e2_dp)
      trial%beta = dice%between_log(10.0_dp, 1.0e4_dp)
      trial%stress = dice%between_log(0.03_dp, 1.0_dp)
      trial%range = dice%between(0.85_dp, 1.0_dp)
   end subroutine draw_fast_strip

   !> A strip with the front as its edge rule. Of five one has a jump between one and two ranges, and one a larger jump, so that
   !> nothing adheres beside the contact. Every other strip slides fast.
   subroutine draw_front_strip(dice, number, trial)
      type(dice_t), intent(inout) :: dice
      integer, intent(in) :: number
      type(trial_strip_t), intent(out) :: trial

      if (mod(number, 2) == 0) call draw_strip(dice, number/2, trial)
      if (mod(number, 2) == 1) call draw_fast_strip(dice, number/2, trial)
      trial%edge = edge_front
      if (mod(number, 5) == 1) trial%range = trial%stress/trial%beta/dice%between(1.0_dp, 2.0_dp)
      if (mod(number, 5) == 2) trial%range = trial%stress/trial%beta/dice%between_log(2.0_dp, 1.0e2_dp)
   end subroutine draw_front_strip

   !> A 3-D surface with the parameters of a strip, and a penetration of it.
   subroutine draw_surface(dice, number, surface, penetration, edge)
      type(dice_t), intent(inout) :: dice
      integer, intent(in) :: number
      type(surface_t), intent(out) :: surface
      real(dp), intent(out) :: penetration
      !> The edge rule, if it does not follow from the number.
      integer, intent(in), optional :: edge
      type(trial_strip_t) :: trial

      call draw_strip(dice, number, trial)
      if (present(edge)) trial%edge = edge
      surface%shape%is_3d = .true.
      call new_foundation(surface%foundation, trial%u, trial%beta)
      surface%adhesion = acting_adhesion(adhesion_t(trial%stress, trial%range, trial%edge), trial%beta)
      surface%branch = trial%branch
      penetration = trial%penetration
   end subroutine draw_surface

end module random_strips
