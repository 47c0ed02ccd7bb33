! SPDX-License-Identifier: GPL-3.0-or-later
!> Static friction of a sphere that takes from adhesion what it needs to slip, sliding, and the events between them
!> (J 4.1-4.9, fig. 9).
!>
!> Everything in the reduced variables of J 2.11. What is prescribed is a load, an approach or a radius. Under a growing
!> force the contact follows the states of smallest slip; it is not found beyond the largest force or displacement it
!> reaches before sliding.
module adfric_round_sphere_peeling
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_round_pulled_contact, only: pulled_curve_t
   use adfric_round_stick_slip, only: stick_slip_t, find_critical_stiffness, find_stick_slip, forget_stick_slip
   use adfric_round_sphere_contact, only: sphere_contact_t, theory_t
   use adfric_interface_interaction, only: is_valid_interaction
   use adfric_round_slip_annulus, only: slip_core, largest_slip_core, angle_of_gamma
   use adfric_round_sphere_static_friction, only: mean_slip, largest_slip
   use adfric_round_sphere_peeling_path, only: peeling_friction_t, peeling_path_t, peeling_waypoint_t, new_path, get_waypoint, &
      & quantity_of, core_along, &
      & force_along, displacement_along, end_none, end_capped, end_sliding, end_snap_off, end_no_adhesion
   use adfric_round_sphere_peeling_search, only: find_end, find_state, find_largest, get_capped
   use adfric_round_pulled_sphere, only: pulled_sphere_t, take_sphere_curve
   implicit none (type, external)
   private
   public :: peeling_friction_t, friction_state_t, friction_events_t
   public :: describe, slide, is_valid_friction, find_static_state, find_sliding_state, find_friction_events, forget_events
   public :: given_gamma, given_force, given_displacement
   public :: end_none, end_capped, end_sliding, end_snap_off, end_no_adhesion

   !> What is given of the static phase.
   integer, parameter :: given_gamma = core_along, given_force = force_along, given_displacement = displacement_along

   !> A contact with friction.
   type :: friction_state_t
      !> Is there such a contact?
      logical :: is_found = .false.
      !> Have all searches converged?
      logical :: is_converged = .true.
      !> Radii, load and approach, with the adhesion that friction leaves.
      type(sphere_contact_t) :: contact
      !> g, X, b, gamma and arccos gamma.
      real(dp) :: slip_energy = 0, ratio = 1, friction_radius = 0, gamma = 1, angle = 0
      !> Tangential force in pi w R, and displacement. During sliding the displacement and slips are not numbers.
      real(dp) :: force = 0, displacement = 0
      !> Slip at the edge, mean around it and largest.
      real(dp) :: slip = 0, largest_slip = 0
   end type friction_state_t

   !> What happens as the tangential displacement grows. What does not happen is not a number.
   type :: friction_events_t
      !> Is there contact at rest?
      logical :: is_found = .false.
      !> Have all searches converged?
      logical :: is_converged = .true.
      !> How the part ends in which the contact changes, one of `end_...`: slip is large enough to take no more
      !> (the contact stays, and gamma falls to 0), sliding begins, the contact snaps off, nothing is left of adhesion.
      integer :: ending = end_none
      !> The largest force before sliding, its displacement and gamma.
      real(dp) :: peak_force = 0, peak_displacement = 0, peak_gamma = 0
      !> The force of sliding; how far it is below the largest force.
      real(dp) :: sliding_force = 0, force_drop = 0
      !> Where the contact snaps off: the last state, during static friction or at the onset of sliding.
      real(dp) :: snap_off_force = 0, snap_off_displacement = 0
      !> The jump on a lateral spring, and the stiffness from which on there is no stick-slip.
      type(stick_slip_t) :: jump
      !> That stiffness.
      real(dp) :: critical_stiffness = 0
   end type friction_events_t

contains

   !> Are the parameters within their limits?
   elemental logical function is_valid_friction(friction)
      type(peeling_friction_t), intent(in) :: friction

      is_valid_friction = friction%strength > 0 .and. friction%poisson > -1 .and. friction%poisson <= 0.5_dp &
         & .and. friction%edge_fraction >= 0 .and. friction%edge_fraction <= 1 .and. friction%interaction >= 0 &
         & .and. friction%slip_energy_ratio > 0
   end function is_valid_friction

   !> The static state of a gamma, a tangential force or a tangential displacement.
   pure subroutine find_static_state(theory, friction, control, prescribed, branch, given, value, state)
      !> Theory of adhesion; its own X is not used.
      class(theory_t), intent(in) :: theory
      !> Parameters of the law of friction, reduced; where they are impossible nothing is found.
      type(peeling_friction_t), intent(in) :: friction
      !> One of `control_...`: what is prescribed.
      integer, intent(in) :: control
      !> Value of the load, approach or radius that is prescribed, reduced.
      real(dp), intent(in) :: prescribed
      !> One of `branch_...`: which state is meant where there are two.
      integer, intent(in) :: branch
      !> One of `given_...`: what is given of the static phase.
      integer, intent(in) :: given
      !> Value of what is given, reduced: gamma from 0 to 1, the others >= 0.
      real(dp), intent(in) :: value
      !> Receives the state; not found where parameters are impossible, too.
      type(friction_state_t), intent(out) :: state
      type(peeling_path_t) :: path
      type(peeling_waypoint_t) :: waypoint

      if (.not. is_valid_friction(friction) .or. .not. value >= 0) return
      if (given == given_gamma .and. value > 1) return
      call new_path(path, theory, friction, control, prescribed, branch)
      if (given == given_gamma) then
         call find_state(path, given, sqrt(min(slip_core(value), largest_slip_core)), waypoint, state%is_converged)
         waypoint%angle = angle_of_gamma(value)
      else
         call find_state(path, given, value, waypoint, state%is_converged)
      end if
      if (.not. waypoint%is_found) return
      call describe(path, waypoint, state)
      if (given == given_gamma) state%gamma = value
      if (given == given_force) state%force = value
      if (given == given_displacement) state%displacement = value
   end subroutine find_static_state

   !> Fill in everything that follows from a state of the path.
   pure subroutine describe(path, waypoint, state)
      !> The path from rest to sliding, with its friction.
      type(peeling_path_t), intent(in) :: path
      type(peeling_waypoint_t), intent(in) :: waypoint
      !> In: whether the search converged. Out: all that is known of the state.
      type(friction_state_t), intent(inout) :: state

      state%is_found = .true.
      state%is_converged = state%is_converged .and. waypoint%contact%is_converged
      state%contact = waypoint%contact
      state%slip_energy = waypoint%slip_energy
      state%ratio = waypoint%ratio
      state%friction_radius = waypoint%friction_radius
      state%angle = waypoint%angle
      state%gamma = gamma_of(waypoint)
      state%force = quantity_of(path, force_along, waypoint)
      state%displacement = quantity_of(path, displacement_along, waypoint)
      associate (friction => path%friction, b => waypoint%friction_radius)
         state%slip = mean_slip(friction%strength, friction%poisson, b, state%angle)
         state%largest_slip = largest_slip(friction%strength, friction%poisson, b, state%angle)
      end associate
   end subroutine describe

   !> gamma of a state.
   pure real(dp) function gamma_of(waypoint) result(gamma)
      type(peeling_waypoint_t), intent(in) :: waypoint

      gamma = 0
      if (waypoint%angle < half_pi) gamma = cos(waypoint%angle)
   end function gamma_of

   !> The state of sliding, gamma = 0 and g = g0; not found if adhesion that remains does not hold the contact.
   pure subroutine find_sliding_state(theory, friction, control, prescribed, branch, state)
      !> Theory of adhesion; its own X is not used.
      class(theory_t), intent(in) :: theory
      !> Parameters of the law of friction, reduced; where they are impossible nothing is found.
      type(peeling_friction_t), intent(in) :: friction
      !> One of `control_...`: what is prescribed.
      integer, intent(in) :: control
      !> Value of the load, approach or radius that is prescribed, reduced.
      real(dp), intent(in) :: prescribed
      !> One of `branch_...`: which state is meant where there are two.
      integer, intent(in) :: branch
      !> Receives the state; not found where parameters are impossible, too.
      type(friction_state_t), intent(out) :: state
      type(peeling_path_t) :: path

      if (.not. is_valid_friction(friction)) return
      call new_path(path, theory, friction, control, prescribed, branch)
      call slide(path, state)
   end subroutine find_sliding_state

   !> The state of sliding of a path.
   pure subroutine slide(path, state)
      !> The path from rest to sliding, with its friction.
      type(peeling_path_t), intent(in) :: path
      !> In: a new one. Out: the state of sliding, if there is one.
      type(friction_state_t), intent(inout) :: state
      type(peeling_waypoint_t) :: waypoint, sliding

      if (.not. is_valid_interaction(path%friction%slip_energy_ratio, path%friction%interaction)) return
      call get_waypoint(path, path%friction%slip_energy_ratio, path%start%contact, waypoint)
      if (.not. waypoint%is_found) return
      call get_capped(waypoint, half_pi, sliding)
      call describe(path, sliding, state)
      state%displacement = not_a_number()
      state%slip = not_a_number()
      state%largest_slip = not_a_number()
   end subroutine slide

   !> What happens between rest and sliding.
   pure subroutine find_friction_events(theory, friction, control, prescribed, branch, events, stiffness)
      !> Theory of adhesion; its own X is not used.
      class(theory_t), intent(in) :: theory
      !> Parameters of the law of friction, reduced; where they are impossible nothing is found.
      type(peeling_friction_t), intent(in) :: friction
      !> One of `control_...`: what is prescribed.
      integer, intent(in) :: control
      !> Value of the load, approach or radius that is prescribed, reduced.
      real(dp), intent(in) :: prescribed
      !> One of `branch_...`: which state is meant where there are two.
      integer, intent(in) :: branch
      !> Receives the events; what does not happen is NaN.
      type(friction_events_t), intent(out) :: events
      !> Stiffness of a lateral spring, reduced; without it no jump is looked for.
      real(dp), intent(in), optional :: stiffness
      type(peeling_path_t) :: path
      type(peeling_waypoint_t) :: onset, peak
      type(friction_state_t) :: sliding
      logical :: is_peak_converged

      call forget_events(events)
      if (.not. is_valid_friction(friction)) return
      call new_path(path, theory, friction, control, prescribed, branch)
      events%is_found = path%start%is_found
      if (.not. events%is_found) return
      call find_end(path, events%is_converged)
      events%ending = path%ending
      ! the last static state, and the largest force
      onset = path%finish
      if (path%ending == end_capped) call get_capped(path%finish, half_pi, onset)
      call find_largest(path, onset, peak, is_peak_converged)
      events%is_converged = events%is_converged .and. is_peak_converged
      if (.not. peak%is_found) peak = onset
      if (quantity_of(path, force_along, onset) >= quantity_of(path, force_along, peak)) peak = onset
      events%peak_force = quantity_of(path, force_along, peak)
      events%peak_displacement = quantity_of(path, displacement_along, peak)
      events%peak_gamma = gamma_of(peak)
      call slide(path, sliding)
      if (path%ending == end_sliding .or. path%ending == end_capped) call add_sliding(sliding, events)
      if (path%ending == end_snap_off .or. (path%ending == end_sliding .and. .not. sliding%is_found)) then
         events%snap_off_force = quantity_of(path, force_along, onset)
         events%snap_off_displacement = quantity_of(path, displacement_along, onset)
      end if
      if (events%is_converged) call add_jump(path, sliding, events, stiffness)
   end subroutine find_friction_events

   !> Add what happens on a lateral spring. Without interaction nothing jumps, and where nothing is left of adhesion nobody knows.
   pure subroutine add_jump(path, sliding, events, stiffness)
      !> The path from rest to sliding, whose end is known.
      type(peeling_path_t), intent(in) :: path
      type(friction_state_t), intent(in) :: sliding
      !> In: with all other events. Out: with the jump, too.
      type(friction_events_t), intent(inout) :: events
      !> Stiffness of the spring, reduced.
      real(dp), intent(in), optional :: stiffness
      type(pulled_curve_t) :: curve
      type(pulled_sphere_t) :: contact
      real(dp) :: force

      if (path%ending == end_no_adhesion) return
      events%critical_stiffness = 0
      if (.not. path%friction%interaction > 0) return
      force = -1
      if (sliding%is_found .and. path%ending /= end_snap_off) force = sliding%force
      call take_sphere_curve(path, force, curve, contact)
      events%is_converged = events%is_converged .and. curve%is_converged
      call find_critical_stiffness(curve, events%critical_stiffness)
      if (present(stiffness)) call find_stick_slip(curve, stiffness, events%jump)
   end subroutine add_jump

   !> Add the force of sliding, and its drop, to the events.
   pure subroutine add_sliding(sliding, events)
      !> State of sliding; where it is not found nothing is added.
      type(friction_state_t), intent(in) :: sliding
      !> In: with the largest force. Out: with the force of sliding and the drop, too.
      type(friction_events_t), intent(inout) :: events

      if (.not. sliding%is_found) return
      events%sliding_force = sliding%force
      events%force_drop = events%peak_force - sliding%force
   end subroutine add_sliding

   !> Mark all events as not happening.
   pure subroutine forget_events(events)
      !> Events, whose numbers all become NaN; the rest stays.
      type(friction_events_t), intent(inout) :: events
      real(dp) :: none

      none = not_a_number()
      events%peak_force = none
      events%peak_displacement = none
      events%peak_gamma = none
      events%sliding_force = none
      events%force_drop = none
      events%snap_off_force = none
      events%snap_off_displacement = none
      events%critical_stiffness = none
      call forget_stick_slip(events%jump)
   end subroutine forget_events

end module adfric_round_sphere_peeling
