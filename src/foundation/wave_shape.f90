! SPDX-License-Identifier: GPL-3.0-or-later
!> The shape of a wavy surface, and the strips of which it consists.
!>
!> Lengths are in units of the height h. The strip at distance y from the crest line has the share
!> Y = (1 + cos ky)/2 of the height: h_y = h Y, D_y = D - h (1 - Y) (GM 9, 10). A 2-D surface is the one strip Y = 1.
module adfric_foundation_wave_shape
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   implicit none (type, external)
   private
   public :: wave_shape_t, share_at, phase_of_share, strip_amplitude, strip_penetration, strip_steepness

   !> Shape of a wavy surface of height 1.
   type :: wave_shape_t
      !> Does the surface vary in both directions?
      logical :: is_3d = .false.
      !> k h of tau = p sin(arctan f'), or 0 for tau = p f'.
      real(dp) :: steepness = 0
   end type wave_shape_t

contains

   !> Share of the height at a crosswise phase.
   elemental real(dp) function share_at(theta)
      !> Crosswise phase k y [rad], 0 on the crest line and pi in the valley.
      real(dp), intent(in) :: theta

      share_at = cos(theta/2)**2
   end function share_at

   !> Crosswise phase at which the height has a share.
   elemental real(dp) function phase_of_share(share)
      !> Share Y of the height, in [0, 1].
      real(dp), intent(in) :: share

      if (has_asserts) call assert(share >= 0 .and. share <= 1, 'phase_of_share: 0 <= share <= 1')
      phase_of_share = 2*acos(sqrt(share))
   end function phase_of_share

   !> Amplitude of a strip, half its peak-to-valley height [h].
   elemental real(dp) function strip_amplitude(share)
      !> Share Y of the height, in (0, 1].
      real(dp), intent(in) :: share

      if (has_asserts) call assert(share > 0 .and. share <= 1, 'strip_amplitude: 0 < share <= 1')
      strip_amplitude = share/2
   end function strip_amplitude

   !> Penetration D_y of the crest of a strip [h].
   elemental real(dp) function strip_penetration(penetration, share)
      !> Penetration of the crests into the undisturbed surface [h].
      real(dp), intent(in) :: penetration
      !> Share Y of the height.
      real(dp), intent(in) :: share

      strip_penetration = penetration - (1 - share)
   end function strip_penetration

   !> Steepest slope of a strip, or 0 for tau = p f'.
   elemental real(dp) function strip_steepness(self, share)
      type(wave_shape_t), intent(in) :: self
      real(dp), intent(in) :: share

      strip_steepness = self%steepness*share/2
   end function strip_steepness

end module adfric_foundation_wave_shape
