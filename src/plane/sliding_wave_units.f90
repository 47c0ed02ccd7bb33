! SPDX-License-Identifier: GPL-3.0-or-later
!> A rigid wave that slides over a viscoelastic half-plane (`sliding_wave`), in SI units and in both directions.
!>
!> x = 0 is a crest, and the body moves to +x where the velocity is positive. The tangential stress T = -mean(p h_x) has the sign
!> of the velocity that it resists.
module adfric_plane_sliding_wave_units
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, two_pi
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_not_a_number, only: not_a_number
   use adfric_solid_prony, only: prony_t
   use adfric_plane_sliding_solid, only: sliding_solid_t, new_sliding_solid, suits_solid
   use adfric_plane_sliding_wave, only: wave_contact_t, get_full_contact, wave_of_pressure, wave_of_penetration
   use adfric_plane_sliding_wave_profile, only: sliding_wave_pressure, sliding_wave_gap, sliding_wave_displacement
   use adfric_plane_sliding_wave_survey, only: wave_survey_t, survey_wave
   implicit none (type, external)
   private
   public :: wave_slide_t, wave_slide_state_t, new_wave_slide

   !> What slides on what, and how fast.
   type :: wave_slide_t
      !> Length l of the wave [m], > 0, and its amplitude D [m], > 0: the heights are D cos(2 pi x/l).
      real(dp) :: period = 1, amplitude = 1
      !> Mean pressure p* = pi E0 D/l of full contact at rest [Pa].
      real(dp) :: pressure_unit = 1
      !> 1 for a velocity >= 0, or -1.
      real(dp) :: direction = 1
      !> The solid, with lengths in l/(2 pi).
      type(sliding_solid_t) :: solid
   contains
      procedure :: full_contact
      procedure :: solve_pressure
      procedure :: solve_penetration
      procedure :: get_survey
      procedure :: pressure_at
      procedure :: gap_at
      procedure :: displacement_at
   end type wave_slide_t

   !> A contact.
   type :: wave_slide_state_t
      !> Is the whole wave in contact?
      logical :: is_full = .false.
      !> Ends of the contact on both sides of the crest at 0, and their mean value [m].
      real(dp) :: left_edge = 0, right_edge = 0, contact_shift = 0
      !> Width of the contact over the period [-], 0 to 1.
      real(dp) :: contact_fraction = 0
      !> Mean pressure [Pa], penetration since first touch and mean gap [m].
      real(dp) :: mean_pressure = 0, penetration = 0, mean_gap = 0
      !> Tangential stress [Pa], with the sign of the velocity.
      real(dp) :: friction_stress = 0
      !> Tangential stress over mean pressure [-]; NaN without load.
      real(dp) :: friction_coefficient = 0
      !> The contact in reduced units, as if the velocity were positive.
      type(wave_contact_t) :: contact
   end type wave_slide_state_t

contains

   !> What slides on what.
   pure subroutine new_wave_slide(self, period, amplitude, prony, velocity, is_possible)
      type(wave_slide_t), intent(out) :: self
      !> Length of the wave [m], > 0.
      real(dp), intent(in) :: period
      !> Its amplitude [m], > 0; half of its height.
      real(dp), intent(in) :: amplitude
      !> Relaxation spectrum of the solid, contact moduli [Pa], `relaxed` > 0.
      type(prony_t), intent(in) :: prony
      !> Velocity [m/s], of either sign.
      real(dp), intent(in) :: velocity
      !> Is the speed one that double precision can handle?
      logical, intent(out) :: is_possible
      real(dp) :: speed

      if (has_asserts) call assert(period > 0 .and. amplitude > 0 .and. prony%relaxed > 0, &
         & 'new_wave_slide: period > 0, amplitude > 0, relaxed > 0')
      self%period = period
      self%amplitude = amplitude
      self%pressure_unit = pi*prony%relaxed*(amplitude/period)
      self%direction = sign(1.0_dp, velocity)
      speed = two_pi*(abs(velocity)/period)
      is_possible = suits_solid(prony, speed)
      if (is_possible) call new_sliding_solid(self%solid, prony, speed)
   end subroutine new_wave_slide

   !> Full contact at this velocity, under the least mean pressure that makes it.
   pure subroutine full_contact(self, state)
      class(wave_slide_t), intent(in) :: self
      type(wave_slide_state_t), intent(out) :: state

      call get_full_contact(self%solid, state%contact)
      call give_units(self, state)
   end subroutine full_contact

   !> The contact under a mean pressure.
   pure subroutine solve_pressure(self, mean_pressure, state, is_converged)
      class(wave_slide_t), intent(in) :: self
      !> Mean pressure [Pa], >= 0.
      real(dp), intent(in) :: mean_pressure
      type(wave_slide_state_t), intent(out) :: state
      !> Was it found? There is none under a tension.
      logical, intent(out) :: is_converged

      call wave_of_pressure(self%solid, mean_pressure/self%pressure_unit, state%contact, is_converged)
      call give_units(self, state)
   end subroutine solve_pressure

   !> The contact at a penetration.
   pure subroutine solve_penetration(self, penetration, state, is_converged)
      class(wave_slide_t), intent(in) :: self
      !> Penetration since first touch [m], at most the amplitude; there is no contact at a negative one.
      real(dp), intent(in) :: penetration
      !> The contact; of full contacts, the one under the least mean pressure.
      type(wave_slide_state_t), intent(out) :: state
      logical, intent(out) :: is_converged

      call wave_of_penetration(self%solid, penetration/self%amplitude, state%contact, is_converged)
      call give_units(self, state)
   end subroutine solve_penetration

   !> Give the results of a contact their units and the direction.
   pure subroutine give_units(self, state)
      type(wave_slide_t), intent(in) :: self
      type(wave_slide_state_t), intent(inout) :: state
      real(dp) :: length

      length = self%period/two_pi
      associate (contact => state%contact)
         state%is_full = contact%is_full
         state%contact_shift = self%direction*length*contact%shift%shift
         state%left_edge = state%contact_shift - length*contact%half_width
         state%right_edge = state%contact_shift + length*contact%half_width
         state%contact_fraction = contact%half_width/pi
         state%mean_pressure = self%pressure_unit*contact%mean_pressure
         state%penetration = self%amplitude*contact%penetration
         state%mean_gap = self%amplitude*contact%mean_gap
         state%friction_coefficient = not_a_number()
         if (contact%mean_pressure > 0) state%friction_coefficient = self%direction*(self%amplitude/length) &
            & *(contact%friction/contact%mean_pressure)
         state%friction_stress = self%direction*(self%amplitude/length)*self%pressure_unit*contact%friction
      end associate
   end subroutine give_units

   !> What is found by going over the profiles of a contact.
   pure subroutine get_survey(self, state, survey)
      class(wave_slide_t), intent(in) :: self
      type(wave_slide_state_t), intent(in) :: state
      !> Pressures [Pa], gap [m] and tangential stress with the sign of the velocity [Pa]; violations in p* and the amplitude.
      type(wave_survey_t), intent(out) :: survey

      call survey_wave(self%solid, state%contact, survey)
      survey%peak_pressure = self%pressure_unit*survey%peak_pressure
      survey%largest_gap = self%amplitude*survey%largest_gap
      survey%friction = self%direction*(two_pi*self%amplitude/self%period)*self%pressure_unit*survey%friction
   end subroutine get_survey

   !> Pressure at x [Pa].
   pure real(dp) function pressure_at(self, state, x)
      class(wave_slide_t), intent(in) :: self
      type(wave_slide_state_t), intent(in) :: state
      !> Position along the wave, from a crest [m].
      real(dp), intent(in) :: x

      pressure_at = self%pressure_unit*sliding_wave_pressure(self%solid, state%contact, reduced_position(self, x))
   end function pressure_at

   !> Gap at x [m].
   pure real(dp) function gap_at(self, state, x)
      class(wave_slide_t), intent(in) :: self
      type(wave_slide_state_t), intent(in) :: state
      !> Position along the wave, from a crest [m].
      real(dp), intent(in) :: x

      gap_at = self%amplitude*sliding_wave_gap(self%solid, state%contact, reduced_position(self, x))
   end function gap_at

   !> Displacement of the solid's surface at x [m], into the solid, of which the mean is 0.
   pure real(dp) function displacement_at(self, state, x)
      class(wave_slide_t), intent(in) :: self
      type(wave_slide_state_t), intent(in) :: state
      !> Position along the wave, from a crest [m].
      real(dp), intent(in) :: x

      displacement_at = self%amplitude*sliding_wave_displacement(self%solid, state%contact, reduced_position(self, x))
   end function displacement_at

   !> A position in l/(2 pi), as seen in the direction of the motion.
   pure real(dp) function reduced_position(self, x)
      type(wave_slide_t), intent(in) :: self
      !> Position along the wave, from a crest [m].
      real(dp), intent(in) :: x

      reduced_position = self%direction*two_pi*(x/self%period)
   end function reduced_position

end module adfric_plane_sliding_wave_units
