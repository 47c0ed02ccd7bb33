! SPDX-License-Identifier: GPL-3.0-or-later
!> A rigid cylinder that slides over a viscoelastic half-plane (`sliding_cylinder`), in SI units and in both directions.
!>
!> x = 0 is the lowest line of the cylinder, which moves to +x where the velocity is positive. The tangential force has the sign
!> of the velocity that it resists.
module adfric_plane_sliding_cylinder_units
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_not_a_number, only: not_a_number
   use adfric_solid_prony, only: prony_t
   use adfric_plane_sliding_solid, only: sliding_solid_t, new_sliding_solid, suits_solid
   use adfric_plane_sliding_cylinder, only: cylinder_contact_t, cylinder_of_load
   use adfric_plane_sliding_cylinder_profile, only: sliding_cylinder_pressure, sliding_cylinder_gap
   use adfric_plane_sliding_cylinder_survey, only: cylinder_survey_t, survey_cylinder
   implicit none (type, external)
   private
   public :: cylinder_slide_t, cylinder_slide_state_t, new_cylinder_slide

   !> Half-widths over the radius whose squares double precision can handle.
   real(dp), parameter :: least_width = 1.0e-100_dp, largest_width = 1.0e100_dp

   !> What slides on what, and how fast.
   type :: cylinder_slide_t
      !> Radius R of the cylinder [m], > 0.
      real(dp) :: radius = 1
      !> Relaxed contact modulus E0 of the solid [Pa], > 0.
      real(dp) :: relaxed = 1
      !> 1 for a velocity >= 0, or -1.
      real(dp) :: direction = 1
      !> Speed over the radius [1/s].
      real(dp) :: speed = 0
      !> The solid, with lengths in the radius.
      type(sliding_solid_t) :: solid
   contains
      procedure :: suits_load
      procedure :: solve_load
      procedure :: get_survey
      procedure :: pressure_at
      procedure :: gap_at
   end type cylinder_slide_t

   !> A contact.
   type :: cylinder_slide_state_t
      !> Load per length [N/m].
      real(dp) :: load = 0
      !> Ends of the contact on both sides of the lowest line, their mean value, and half of their distance [m].
      real(dp) :: left_edge = 0, right_edge = 0, contact_shift = 0, half_width = 0
      !> Tangential force per length [N/m], with the sign of the velocity.
      real(dp) :: friction_force = 0
      !> Tangential force over load [-]; NaN without load.
      real(dp) :: friction_coefficient = 0
      !> The contact in reduced units, as if the velocity were positive.
      type(cylinder_contact_t) :: contact
   end type cylinder_slide_state_t

contains

   !> What slides on what.
   pure subroutine new_cylinder_slide(self, radius, prony, velocity, is_possible)
      type(cylinder_slide_t), intent(out) :: self
      !> Radius of the cylinder [m], > 0.
      real(dp), intent(in) :: radius
      !> Relaxation spectrum of the solid, contact moduli [Pa], `relaxed` > 0.
      type(prony_t), intent(in) :: prony
      !> Velocity [m/s], of either sign.
      real(dp), intent(in) :: velocity
      !> Is the speed one that double precision can handle?
      logical, intent(out) :: is_possible

      if (has_asserts) call assert(radius > 0 .and. prony%relaxed > 0, 'new_cylinder_slide: radius > 0, relaxed > 0')
      self%radius = radius
      self%relaxed = prony%relaxed
      self%direction = sign(1.0_dp, velocity)
      self%speed = abs(velocity)/radius
      is_possible = suits_solid(prony, self%speed)
      if (is_possible) call new_sliding_solid(self%solid, prony, self%speed)
   end subroutine new_cylinder_slide

   !> Can double precision handle a load? No length over the half-width of its contact may be beyond the bounds of a solid.
   pure logical function suits_load(self, prony, load)
      class(cylinder_slide_t), intent(in) :: self
      type(prony_t), intent(in) :: prony
      !> Load per length [N/m], >= 0.
      real(dp), intent(in) :: load
      real(dp) :: widths(2)

      suits_load = .not. load > 0
      if (suits_load) return
      ! the half-width on the relaxed solid, and that on the instantaneous one
      widths = sqrt(reduced_load(self, load)*[1.0_dp, prony%relaxed/prony%instantaneous_modulus()])
      suits_load = widths(2) >= least_width .and. widths(1) <= largest_width
      if (suits_load) suits_load = all([suits_solid(prony, self%speed/widths(1)), suits_solid(prony, self%speed/widths(2))])
   end function suits_load

   !> The contact under a load.
   pure subroutine solve_load(self, load, state, is_converged)
      class(cylinder_slide_t), intent(in) :: self
      !> Load per length [N/m], >= 0.
      real(dp), intent(in) :: load
      type(cylinder_slide_state_t), intent(out) :: state
      !> Was it found? There is none under a tension.
      logical, intent(out) :: is_converged

      call cylinder_of_load(self%solid, reduced_load(self, load), state%contact, is_converged)
      associate (contact => state%contact)
         state%load = load
         state%half_width = self%radius*contact%half_width
         state%contact_shift = self%direction*state%half_width*contact%shift%shift
         state%left_edge = state%contact_shift - state%half_width
         state%right_edge = state%contact_shift + state%half_width
         state%friction_coefficient = not_a_number()
         if (load > 0) state%friction_coefficient = self%direction*contact%half_width*contact%friction_ratio
         if (load > 0) state%friction_force = load*state%friction_coefficient
      end associate
   end subroutine solve_load

   !> Square of the half-width, in the radius, that a load would have on the relaxed solid.
   pure real(dp) function reduced_load(self, load)
      class(cylinder_slide_t), intent(in) :: self
      !> Load per length [N/m], >= 0.
      real(dp), intent(in) :: load

      reduced_load = 4/pi*(load/self%relaxed/self%radius)
   end function reduced_load

   !> What is found by going over the profiles of a contact.
   pure subroutine get_survey(self, state, survey)
      class(cylinder_slide_t), intent(in) :: self
      type(cylinder_slide_state_t), intent(in) :: state
      !> Largest pressure [Pa], violations, and in place of the friction ratio the friction coefficient from the pressure, with the
      type(cylinder_survey_t), intent(out) :: survey

      call survey_cylinder(state%contact, survey)
      survey%peak_pressure = self%relaxed*state%contact%half_width/2*survey%peak_pressure
      survey%friction_ratio = self%direction*state%contact%half_width*survey%friction_ratio
   end subroutine get_survey

   !> Pressure at x [Pa].
   pure real(dp) function pressure_at(self, state, x)
      class(cylinder_slide_t), intent(in) :: self
      type(cylinder_slide_state_t), intent(in) :: state
      !> Position along the surface, from the lowest line of the cylinder [m].
      real(dp), intent(in) :: x

      pressure_at = 0
      if (state%half_width > 0) pressure_at = self%relaxed*state%contact%half_width/2 &
         & *sliding_cylinder_pressure(state%contact, self%direction*x/state%half_width)
   end function pressure_at

   !> Gap at x [m].
   pure real(dp) function gap_at(self, state, x)
      class(cylinder_slide_t), intent(in) :: self
      type(cylinder_slide_state_t), intent(in) :: state
      !> Position along the surface, from the lowest line of the cylinder [m].
      real(dp), intent(in) :: x

      ! without load the solid is flat
      gap_at = x*(x/self%radius)/2
      if (state%half_width > 0) gap_at = state%half_width*state%contact%half_width &
         & *sliding_cylinder_gap(state%contact, self%direction*x/state%half_width)
   end function gap_at

end module adfric_plane_sliding_cylinder_units
