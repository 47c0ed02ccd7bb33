! SPDX-License-Identifier: GPL-3.0-or-later
!> Where the adhered branch of an adhesive wave (`adhesive_wave`) ends, under a load and at a penetration, and what a loop of approach
!> and parting loses.
!>
!> Unless the approach has turned in partial contact, the branch begins saturated. Under a load it ends at the minimum of the load or at
!> the end of saturation, whichever is lower; at a penetration, likewise. After a turn in partial contact it is the minimum.
module adfric_plane_adhesive_wave_ends
   use adfric_base_kinds, only: dp
   use adfric_plane_adhesive_wave_curve, only: adhesive_wave_t, get_curve_state, get_saturated_penetration
   use adfric_plane_adhesive_wave_jumps, only: wave_jumps_t, get_jumps
   use adfric_plane_adhesive_wave_load, only: pull_off_load, was_partial
   implicit none (type, external)
   private
   public :: wave_ends_t, get_ends

   !> The ends.
   type :: wave_ends_t
      !> Least load P [p*] of the adhered branch, and the penetration there [D].
      real(dp) :: pull_off_load = 0, pull_off_penetration = 0
      !> Least penetration of the adhered branch [D].
      real(dp) :: jump_off_penetration = 0
      !> What a loop at prescribed penetrations loses [p* D].
      real(dp) :: loss = 0
   end type wave_ends_t

contains

   !> The ends of the branch.
   pure subroutine get_ends(wave, ends, is_converged, turning_load)
      type(adhesive_wave_t), intent(in) :: wave
      type(wave_ends_t), intent(out) :: ends
      logical, intent(out) :: is_converged
      !> Load of the approach's state at which the loop turns; absent: full contact.
      real(dp), intent(in), optional :: turning_load
      type(wave_jumps_t) :: jumps
      real(dp) :: load, gap
      logical :: ends_in_zones

      ends%pull_off_load = pull_off_load(wave, turning_load)
      ends%jump_off_penetration = min(wave%least_penetration, wave%saturation_penetration)
      ends_in_zones = wave%has_folds
      if (was_partial(wave, turning_load)) then
         ends%jump_off_penetration = wave%least_penetration
      else if (ends_in_zones) then
         ends_in_zones = wave%least_load < wave%saturation_load
      end if
      if (ends_in_zones) then
         call get_curve_state(wave, wave%least, load, ends%pull_off_penetration, gap)
      else
         ends%pull_off_penetration = get_saturated_penetration(wave%saturation_square)
      end if
      call get_jumps(wave, jumps, is_converged, turning_load)
      ends%loss = jumps%total
   end subroutine get_ends

end module adfric_plane_adhesive_wave_ends
