! SPDX-License-Identifier: GPL-3.0-or-later
!> What an adhesive wave (`adhesive_wave`) loses in the jumps of one closed loop: from out of reach to full contact, or to the state at
!> which the approach turns, and back, at prescribed penetrations. A turn in partial contact leaves out both jumps of saturation.
!> Elsewhere the loop is reversible, so the integral of P d delta around it is the sum of the losses.
module adfric_plane_adhesive_wave_jumps
   use adfric_base_kinds, only: dp
   use adfric_plane_adhesive_wave_curve, only: adhesive_wave_t
   use adfric_plane_adhesive_wave_load, only: was_partial, branch_approach, branch_adhered
   use adfric_plane_adhesive_wave_penetration, only: state_of_penetration
   use adfric_plane_adhesive_wave_state, only: wave_adhesion_t, state_of_zones, dissipated_energy
   implicit none (type, external)
   private
   public :: wave_jumps_t, get_jumps

   !> Energies that are lost [p* D], each >= 0.
   type :: wave_jumps_t
      !> Jump into contact, or cohesion, at delta = -eta.
      real(dp) :: jump_in = 0
      !> Onset of saturation at the largest penetration of the zones, and its end.
      real(dp) :: saturation = 0, desaturation = 0
      !> Jump off at the least penetration; 0 if the end of saturation is the end of contact.
      real(dp) :: pull_off = 0
      !> Their sum.
      real(dp) :: total = 0
   end type wave_jumps_t

contains

   !> The losses of the loop.
   pure subroutine get_jumps(wave, jumps, is_converged, turning_load)
      type(adhesive_wave_t), intent(in) :: wave
      type(wave_jumps_t), intent(out) :: jumps
      logical, intent(out) :: is_converged
      !> Load of the approach's state at which the loop turns; absent: full contact.
      real(dp), intent(in), optional :: turning_load
      type(wave_adhesion_t) :: before, after, free
      logical :: has_found(4), is_partial

      has_found = .true.
      is_partial = was_partial(wave, turning_load)
      call state_of_penetration(wave, nearest(-wave%range, 1.0_dp), branch_approach, after, has_found(1))
      jumps%jump_in = dissipated_energy(free, after)
      ! zones whose penetration is 1 to the last bit are saturated without a loss
      if (.not. is_partial .and. wave%largest_penetration < 1) then
         call state_of_zones(wave, wave%highest, before)
         call state_of_penetration(wave, nearest(wave%largest_penetration, 1.0_dp), branch_approach, after, has_found(2))
         jumps%saturation = dissipated_energy(before, after)
      end if
      if (.not. is_partial) then
         call state_of_penetration(wave, wave%saturation_penetration, branch_adhered, before, has_found(3))
         call state_of_penetration(wave, nearest(wave%saturation_penetration, -huge(1.0_dp)), branch_adhered, after, has_found(4))
         jumps%desaturation = dissipated_energy(before, after)
      end if
      if (is_partial .or. wave%least_penetration < wave%saturation_penetration) then
         call state_of_zones(wave, wave%lowest, before)
         jumps%pull_off = dissipated_energy(before, free)
      end if
      ! a loss is less than the round-off of the energies where the stress is small
      jumps%jump_in = max(0.0_dp, jumps%jump_in)
      jumps%saturation = max(0.0_dp, jumps%saturation)
      jumps%desaturation = max(0.0_dp, jumps%desaturation)
      jumps%pull_off = max(0.0_dp, jumps%pull_off)
      jumps%total = jumps%jump_in + jumps%saturation + jumps%desaturation + jumps%pull_off
      is_converged = all(has_found)
   end subroutine get_jumps

end module adfric_plane_adhesive_wave_jumps
