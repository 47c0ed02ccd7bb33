! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact as a state of its curve, and what is prescribed in it.
module adfric_round_contact_state
   use adfric_base_kinds, only: dp
   use adfric_round_curve, only: curve_t, state_t, stability_control, control_load, control_spring
   use adfric_round_shape, only: spot_t
   implicit none (type, external)
   private
   public :: contact_t, set_contact, set_disc, terms_of, prescribed_of, prescribed_by, prescribed_slope

   !> A state of contact, reduced.
   type :: contact_t
      !> Does it exist, and was it found to round-off?
      logical :: is_found = .false., is_converged = .true.
      !> Is it stable under what is prescribed?
      logical :: is_stable = .false.
      !> The unknown, and whether it lies beyond the corner.
      real(dp) :: u = 0
      !> Is u one of those beyond the corner?
      logical :: is_beyond = .true.
      !> What the shape is there.
      type(spot_t) :: spot
      !> Load P and approach delta.
      real(dp) :: load = 0, approach = 0
      !> Their derivatives by u; 0 without touch, and for a flat face.
      real(dp) :: slopes(2) = 0
      !> g(a) - delta, the depth of the flat punch of radius a that adhesion adds: Dl of JKR; of a flat face -delta.
      real(dp) :: neck = 0
      !> Radius c up to which adhesion acts, and its stress there; 0 where it acts in the contact alone.
      real(dp) :: adhesion_radius = 0, stress = 0
      !> Sizes of the terms of load and approach of a disc without touch; else 0.
      real(dp) :: disc_terms(2) = 0
      !> dP/ddelta along the curve.
      real(dp) :: stiffness = 0
   end type contact_t

contains

   !> What follows from the unknown.
   pure subroutine set_contact(curve, control, u, is_beyond, contact)
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      !> The unknown, >= 0.
      real(dp), intent(in) :: u
      logical, intent(in) :: is_beyond
      !> Receives radius, load, approach and stiffness.
      type(contact_t), intent(inout) :: contact
      type(state_t) :: state

      contact%u = u
      contact%is_beyond = is_beyond
      call curve%get_state(u, is_beyond, state)
      call take_state(state, control, contact)
   end subroutine set_contact

   !> A state without touch.
   pure subroutine set_disc(curve, control, c, contact)
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      !> Radius of the disc, >= 0.
      real(dp), intent(in) :: c
      type(contact_t), intent(inout) :: contact
      type(state_t) :: state

      call curve%get_disc(c, state)
      contact%is_beyond = .false.
      call take_state(state, control, contact)
   end subroutine set_disc

   !> Take a state over.
   pure subroutine take_state(state, control, contact)
      type(state_t), intent(in) :: state
      integer, intent(in) :: control
      !> Receives radii, load, approach and stiffness.
      type(contact_t), intent(inout) :: contact

      contact%spot = state%spot
      contact%load = state%load
      contact%approach = state%approach
      contact%slopes = [state%load_slope, state%approach_slope]
      contact%neck = state%neck
      contact%stiffness = state%stiffness
      contact%adhesion_radius = state%adhesion_radius
      contact%stress = state%stress
      contact%disc_terms = state%disc_terms
      contact%is_stable = state%is_stable(stability_control(control))
      contact%is_converged = contact%is_converged .and. state%is_converged
   end subroutine take_state

   !> Sizes of the terms whose differences are load and approach.
   pure function terms_of(contact) result(terms)
      type(contact_t), intent(in) :: contact
      real(dp) :: terms(2)

      terms = contact%disc_terms
      if (terms(2) > 0) return
      terms = [contact%spot%load + 2*contact%spot%radius*abs(contact%neck), contact%spot%depth + abs(contact%neck)]
   end function terms_of

   !> What is prescribed in a state: its load, its approach, or that of the base of the spring.
   pure real(dp) function prescribed_of(curve, control, state)
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      type(state_t), intent(in) :: state

      prescribed_of = prescribed_part(curve, control, state%load, state%approach)
   end function prescribed_of

   !> What is prescribed for a contact, see `prescribed_of`.
   pure real(dp) function prescribed_by(curve, control, contact)
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      type(contact_t), intent(in) :: contact

      prescribed_by = prescribed_part(curve, control, contact%load, contact%approach)
   end function prescribed_by

   !> Derivative of what is prescribed by u along the curve, see `prescribed_of`.
   pure real(dp) function prescribed_slope(curve, control, state)
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      type(state_t), intent(in) :: state

      prescribed_slope = prescribed_part(curve, control, state%load_slope, state%approach_slope)
   end function prescribed_slope

   !> What is prescribed of a load and an approach, or of changes of both.
   pure real(dp) function prescribed_part(curve, control, load, approach)
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      real(dp), intent(in) :: load, approach

      prescribed_part = load
      if (control /= control_load) prescribed_part = approach
      if (control == control_spring) prescribed_part = prescribed_part + curve%compliance*load
   end function prescribed_part

end module adfric_round_contact_state
