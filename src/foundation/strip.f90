! SPDX-License-Identifier: GPL-3.0-or-later
!> One strip of the surface in reduced form, and what a steady state of it is.
!>
!> The strip has the profile \( F(\xi) = m + \cos \xi \): lengths are in units of half its
!> peak-to-valley height c = h_y/2, stresses in c/K. Its gap is \( g = w - F \ge 0 \).
!> Adhesion pulls with the stress \( \pi \) wherever \( 0 < g \le \delta \).
module adfric_foundation_strip
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_foundation_adhesion, only: adhesion_t, strip_adhesion_t, new_strip_adhesion
   use adfric_foundation_foundation, only: foundation_t
   implicit none (type, external)
   private
   public :: strip_t, new_strip, steady_state_t, drive, get_drive, drive_round_off, profile, lifted_profile
   public :: regime_free, regime_adhesion_only, regime_discrete, regime_saturated_adhesion
   public :: regime_adhesion_zones, regime_saturated, regime_several_contacts, regime_mixed, regime_meanings

   !> Regimes of one strip (GM section 4), as they stand in the results file; the last two are those of measured heights: several
   !> contacts on a period, and rows of which some are in one regime and some in another.
   integer, parameter :: regime_free = 0, regime_adhesion_only = 1, regime_discrete = 2
   integer, parameter :: regime_saturated_adhesion = 3, regime_adhesion_zones = 4, regime_saturated = 5
   integer, parameter :: regime_several_contacts = 6, regime_mixed = 7
   !> Names of the regimes, in the order of their numbers from 0.
   character(*), parameter :: regime_meanings = 'free adhesion_without_contact discrete_contact &
      &discrete_contact_saturated_adhesion discrete_contact_adhesion_zones saturated_contact several_contacts mixed'

   !> A strip in reduced form.
   type :: strip_t
      !> Foundation under the strip, at its velocity.
      type(foundation_t) :: foundation
      !> Penetration of the crest, and mean level of the profile (1 less), positive into the foundation [c].
      real(dp) :: crest = -1, mean = -2
      !> Adhesion: its stress [c/K], its gaps and its jump [c].
      type(strip_adhesion_t) :: adhesion
      !> Crest and mean level above a foundation that adhesion has lifted, crest + stress and mean + stress [c].
      real(dp) :: depth = -1, level = -2
   end type strip_t

   !> A steady state: contact (shift - half_width, shift + half_width), adhesion on `trailing` behind
   !> it and on `leading` before it, free elsewhere. Phases in radians.
   type :: steady_state_t
      !> Regime of the strip, one of `regime_...`.
      integer :: regime = regime_free
      !> Half width and centre of the contact zone; without contact, those of the adhesion zone.
      real(dp) :: half_width = 0, shift = 0
      !> Lengths of the adhesion zones beside the contact.
      real(dp) :: trailing = 0, leading = 0
      !> Centre of contact and adhesion zones together, shift + (leading - trailing)/2; kept apart because in fast
      !> sliding it is much smaller than the lengths from which it follows.
      real(dp) :: outer_shift = 0
      !> Half width that the contact would have with adhesion in the whole gap; the next strip's first guess of it.
      real(dp) :: bound_width = 0
      !> Stress above -stress with which the contact starts (snap into contact, else 0) [c/K].
      real(dp) :: entry = 0
      !> Derivative of the return map: what one period leaves of a disturbance; < 1 is stable.
      real(dp) :: multiplier = 0
      !> False if no steady state was found.
      logical :: is_converged = .true.
   end type steady_state_t

contains

   !> Bring a strip into reduced form.
   elemental subroutine new_strip(self, foundation, amplitude, penetration, adhesion)
      !> The strip in units of its amplitude.
      type(strip_t), intent(out) :: self
      !> The foundation at its sliding velocity; the strip keeps a copy.
      type(foundation_t), intent(in) :: foundation
      !> Half the peak-to-valley height of the strip [h], > 0.
      real(dp), intent(in) :: amplitude
      !> Penetration D_y of the crest of the strip [h].
      real(dp), intent(in) :: penetration
      !> Adhesion of the surface, its stress in h/K and its range in h.
      type(adhesion_t), intent(in) :: adhesion

      if (has_asserts) call assert(amplitude > 0, 'new_strip: the strip has a height')
      self%foundation = foundation
      self%crest = penetration/amplitude
      self%mean = self%crest - 1
      self%depth = (penetration + adhesion%stress)/amplitude
      self%level = self%depth - 1
      call new_strip_adhesion(self%adhesion, adhesion, amplitude, foundation%beta)
   end subroutine new_strip

   !> Level F of the profile [c], to full precision near the crest.
   elemental real(dp) function profile(self, xi)
      !> The strip, of which the penetration of the crest is read.
      type(strip_t), intent(in) :: self
      !> Phase [rad]; the crest is at 0.
      real(dp), intent(in) :: xi

      profile = self%crest - 2*sin(xi/2)**2
   end function profile

   !> The profile above a foundation that adhesion has lifted, F + stress [c].
   elemental real(dp) function lifted_profile(self, xi)
      type(strip_t), intent(in) :: self
      real(dp), intent(in) :: xi

      lifted_profile = self%depth - 2*sin(xi/2)**2
   end function lifted_profile

   !> What drives the open and the closed zones, \( F + \pi - v F' = m + \pi + \cos\xi + v \sin\xi \):
   !> contact can end only where it is negative and begin only where it is positive.
   elemental real(dp) function drive(self, xi)
      !> The strip, of which the level and the foundation are read.
      type(strip_t), intent(in) :: self
      real(dp), intent(in) :: xi

      drive = self%level + cos(xi) + self%foundation%v*sin(xi)
   end function drive

   !> The drive and its derivative.
   pure subroutine get_drive(self, xi, value, slope)
      type(strip_t), intent(in) :: self
      real(dp), intent(in) :: xi
      !> The drive at the phase [c].
      real(dp), intent(out) :: value
      !> Derivative of the drive with respect to the phase [c/rad].
      real(dp), intent(out) :: slope
      real(dp) :: c, s

      c = cos(xi)
      s = sin(xi)
      value = self%level + c + self%foundation%v*s
      slope = self%foundation%v*c - s
   end subroutine get_drive

   !> What the drive is known to: in slow sliding zones end where it passes their bound, to round-off.
   pure real(dp) function drive_round_off(strip)
      type(strip_t), intent(in) :: strip

      drive_round_off = 16*epsilon(1.0_dp) &
         & *(1 + abs(strip%level) + strip%adhesion%stress + strip%adhesion%range + strip%foundation%v)
   end function drive_round_off

end module adfric_foundation_strip
