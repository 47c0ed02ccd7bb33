! SPDX-License-Identifier: GPL-3.0-or-later
!> Contacts without friction of an indenter of any axisymmetric shape under all loads, reduced: what its histories are made of.
module adfric_round_indenter_states
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: unset
   use adfric_round_case, only: indenter_case_t, resolve_case, is_possible_case => is_possible
   use adfric_round_contact, only: branch_stable, find_contact
   use adfric_round_contact_state, only: contact_t
   use adfric_round_curve, only: control_load, control_approach
   use adfric_round_power_shape, only: power_shape_t
   use adfric_round_shape, only: spot_t
   use adfric_round_survey, only: survey_t, survey_curve
   use adfric_round_variables, only: choose_none, n_indenter_variables, in => indenter_input
   use adfric_interface_normal_contact, only: normal_contact_t, normal_state_t
   implicit none (type, external)
   private
   public :: indenter_states_t, find_indenter_states, plain_indenter

   !> Normal states of an indenter, reduced.
   type, extends(normal_contact_t) :: indenter_states_t
      !> The indenter with its units.
      type(indenter_case_t) :: case
      !> What its curve is under a load and at an approach.
      type(survey_t) :: surveys(2)
   contains
      procedure :: under_load
      procedure :: at_approach
      procedure :: get_spot
   end type indenter_states_t

contains

   !> The values that the model `indenter` would have without adhesion and friction. Load, approach and all else are unset.
   pure function plain_indenter(rows) result(values)
      !> Values of its first rows, with the shape.
      real(dp), intent(in) :: rows(:)
      real(dp) :: values(n_indenter_variables)

      values = unset
      values(:size(rows)) = rows
      values([in%theory, in%branch, in%profiles, in%n_r]) = [choose_none, branch_stable, 0, 2]
   end function plain_indenter

   !> The states of an indenter.
   pure subroutine find_indenter_states(values, states, is_possible)
      !> Values of the variables, in the order of `adfric_round_variables`, with the largest load or approach.
      real(dp), intent(in) :: values(:)
      !> Receives the states.
      type(indenter_states_t), intent(out) :: states
      !> Are its units and the largest load or approach within the numbers?
      logical, intent(out) :: is_possible
      type(spot_t) :: corner

      call resolve_case(values, states%case)
      is_possible = is_possible_case(values, states%case)
      if (.not. is_possible) return
      call survey_curve(states%case%curve, control_load, states%surveys(control_load))
      call survey_curve(states%case%curve, control_approach, states%surveys(control_approach))
      call states%case%curve%shape%evaluate(0.0_dp, .true., corner)
      if (states%case%curve%shape%inner_rise() > 0) states%kink = corner%depth
   end subroutine find_indenter_states

   !> See `normal_contact_t`.
   pure subroutine under_load(self, given, state, is_converged)
      class(indenter_states_t), intent(in) :: self
      real(dp), intent(in) :: given
      type(normal_state_t), intent(out) :: state
      logical, intent(out) :: is_converged

      call find_state(self, control_load, given, state, is_converged)
   end subroutine under_load

   !> See `normal_contact_t`.
   pure subroutine at_approach(self, given, state, is_converged)
      class(indenter_states_t), intent(in) :: self
      real(dp), intent(in) :: given
      type(normal_state_t), intent(out) :: state
      logical, intent(out) :: is_converged

      call find_state(self, control_approach, given, state, is_converged)
   end subroutine at_approach

   !> See `normal_contact_t`: in closed form for a profile that is one power of r.
   elemental subroutine get_spot(self, depth, radius, moment)
      class(indenter_states_t), intent(in) :: self
      real(dp), intent(in) :: depth
      real(dp), intent(out) :: radius, moment
      type(normal_state_t) :: state
      logical :: is_converged

      select type (shape => self%case%curve%shape)
      type is (power_shape_t)
         if (shape%n_terms == 1) then
            radius = shape%radius_of_depth(max(depth, 0.0_dp))
            moment = radius*max(depth, 0.0_dp)/(1 + shape%exponents(1))
            return
         end if
      end select
      call self%at_approach(max(depth, 0.0_dp), state, is_converged)
      radius = state%radius
      moment = radius*max(depth, 0.0_dp) - state%load/2
   end subroutine get_spot

   !> A normal state, reduced. The elastic energy is the integral of the load over the approach.
   pure subroutine find_state(self, control, given, state, is_converged)
      type(indenter_states_t), intent(in) :: self
      !> `control_load` or `control_approach`.
      integer, intent(in) :: control
      !> Load or approach.
      real(dp), intent(in) :: given
      type(normal_state_t), intent(out) :: state
      logical, intent(out) :: is_converged
      type(contact_t) :: contact

      call find_contact(self%case%curve, self%surveys(control), control, given, .true., branch_stable, contact)
      is_converged = contact%is_found .and. contact%is_converged
      state%load = contact%load
      state%approach = contact%approach
      state%radius = contact%spot%radius
      state%stiffness = contact%stiffness
      if (self%case%curve%shape%n_pieces == 0) then
         state%work = contact%load*contact%approach/2
      else
         state%work = self%case%curve%shape%energy(contact%u, contact%is_beyond)
      end if
   end subroutine find_state

end module adfric_round_indenter_states
