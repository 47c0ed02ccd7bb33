! SPDX-License-Identifier: GPL-3.0-or-later
!> States of a sphere whose friction takes from adhesion what it needs to slip: before sliding, during it, and on a driven spring
!> (J 4.1-4.9, fig. 9).
!>
!> Everything in the reduced variables of J 2.11. What is prescribed is a load, an approach or a radius. Under a growing
!> force the contact follows the states of smallest slip; it is not found beyond the largest force or displacement it
!> reaches before sliding.
module adfric_round_sphere_peeling
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_round_interaction_events, only: slide
   use adfric_round_interaction_path, only: gamma_of, largest_slip_of, slip_of, waypoint_t
   use adfric_round_interaction_search, only: find_state
   use adfric_round_shrinking_path, only: displacement_of, force_of, first_core, first_displacement, first_force
   use adfric_round_slip_annulus, only: slip_core, largest_slip_core, angle_of_gamma
   use adfric_round_sphere_contact, only: sphere_contact_t
   use adfric_round_sphere_path, only: peeling_path_t, sphere_contact_of
   use adfric_round_spring_drive, only: driven_state_t, find_driven_state, spring_drive_t
   implicit none (type, external)
   private
   public :: friction_state_t, find_static_state, find_sliding_state, find_driven_sphere
   public :: given_gamma, given_force, given_displacement

   !> What is given of the static phase.
   integer, parameter :: given_gamma = first_core, given_force = first_force, given_displacement = first_displacement

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

contains

   !> The static state of a gamma, a tangential force or a tangential displacement.
   pure subroutine find_static_state(path, given, value, state)
      !> The path from rest to sliding; where its end is needed it receives that, too.
      type(peeling_path_t), intent(inout) :: path
      !> One of `given_...`: what is given of the static phase.
      integer, intent(in) :: given
      !> Value of what is given, reduced: gamma from 0 to 1, the others >= 0.
      real(dp), intent(in) :: value
      !> Receives the state; not found where the value is impossible, too.
      type(friction_state_t), intent(out) :: state
      type(waypoint_t) :: waypoint
      real(dp) :: sought

      if (.not. value >= 0 .or. (given == given_gamma .and. value > 1)) return
      sought = value
      if (given == given_gamma) sought = sqrt(min(slip_core(value), largest_slip_core))
      if (path%start%is_found) then
         call find_state(path, given, sought, waypoint, state%is_converged)
      else
         ! a mere touch carries no friction
         waypoint = path%start
         waypoint%is_found = waypoint%contact%is_found .and. .not. sought > 0
         state%is_converged = waypoint%contact%is_converged
      end if
      if (given == given_gamma) waypoint%angle = angle_of_gamma(value)
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
      type(waypoint_t), intent(in) :: waypoint
      !> In: whether the search converged. Out: all that is known of the state.
      type(friction_state_t), intent(inout) :: state

      state%is_found = .true.
      state%contact = sphere_contact_of(waypoint%contact)
      state%is_converged = state%is_converged .and. state%contact%is_converged
      state%slip_energy = waypoint%slip_energy
      state%ratio = waypoint%ratio
      state%friction_radius = waypoint%radius
      state%angle = waypoint%angle
      state%gamma = gamma_of(waypoint)
      state%force = force_of(path, waypoint)
      state%displacement = displacement_of(path, waypoint)
      state%slip = slip_of(path%law, waypoint%radius, waypoint%angle)
      state%largest_slip = largest_slip_of(path%law, waypoint%radius, waypoint%angle)
   end subroutine describe

   !> A state of sliding: displacement and slip grow without end.
   pure subroutine describe_sliding(path, waypoint, state)
      type(peeling_path_t), intent(in) :: path
      type(waypoint_t), intent(in) :: waypoint
      type(friction_state_t), intent(inout) :: state

      call describe(path, waypoint, state)
      state%displacement = not_a_number()
      state%slip = not_a_number()
      state%largest_slip = not_a_number()
   end subroutine describe_sliding

   !> The state of sliding, gamma = 0 and g = g0; not found if adhesion that remains does not hold the contact.
   pure subroutine find_sliding_state(path, state)
      type(peeling_path_t), intent(inout) :: path
      type(friction_state_t), intent(out) :: state
      type(waypoint_t) :: sliding
      logical :: is_found

      if (.not. path%start%is_found) return
      call slide(path, sliding, is_found)
      if (is_found) call describe_sliding(path, sliding, state)
   end subroutine find_sliding_state

   !> The state at a displacement of the base.
   pure subroutine find_driven_sphere(drive, base, state)
      type(spring_drive_t), intent(in) :: drive
      !> Displacement of the base from rest, reduced, >= 0.
      real(dp), intent(in) :: base
      !> Receives the state, with the displacement from rest; not found where contact is lost.
      type(friction_state_t), intent(out) :: state
      type(driven_state_t) :: driven

      state%is_converged = drive%is_converged
      call find_driven_state(drive, base, driven)
      if (.not. driven%is_found) return
      select type (path => drive%contact%path)
      type is (peeling_path_t)
         if (driven%is_sliding) call describe_sliding(path, driven%waypoint, state)
         if (.not. driven%is_sliding) call describe(path, driven%waypoint, state)
      end select
      state%force = driven%force
      state%displacement = driven%displacement
   end subroutine find_driven_sphere

end module adfric_round_sphere_peeling
