! SPDX-License-Identifier: GPL-3.0-or-later
!> One point of the sphere: the theory it needs, its contact, and its friction, in reduced variables.
!> The file is long by the kinds of friction, of which each takes another path through the same contact.
module adfric_round_sphere_point
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_describe_status, only: status_solved, status_no_equilibrium, status_not_converged
   use adfric_round_sphere_case, only: sphere_case_t, theory_auto
   use adfric_round_sphere_contact, only: sphere_contact_t, theory_t, theory_dmt, theory_maugis_dugdale, find_contact, &
      & friction_radius, &
      & part_bodies
   use adfric_round_driven_contact, only: driven_error
   use adfric_interface_interaction, only: adhesion_ratio
   use adfric_round_interaction_events, only: find_peeling_events, forget_peeling_events, peeling_events_t
   use adfric_round_interaction_path, only: interaction_law_t, largest_slip_of, slip_of
   use adfric_round_sphere_path, only: law_of_sphere, new_sphere_path, peeling_friction_t, peeling_path_t
   use adfric_round_sphere_peeling, only: friction_state_t, find_static_state, find_driven_sphere, given_force, given_displacement
   use adfric_round_slip_annulus, only: angle_of_force, force_of_angle, gamma_of_force, gamma_of_displacement
   use adfric_round_sphere_shear_slip, only: sheared_sphere_t, sphere_slip_t, new_sheared_sphere, find_slip
   use adfric_round_spring_drive, only: new_spring_drive, spring_drive_t
   use adfric_round_sphere_theory_choice, only: new_theory, theory_choice_t, new_choice, is_choice_of, choose_theory, get_mismatch
   implicit none (type, external)
   private
   public :: sphere_point_t, sphere_memory_t, solve_point

   !> The solution of a point, in reduced variables.
   type :: sphere_point_t
      !> One of `status_...`, and of `theory_...`.
      integer :: status = status_solved, theory = theory_maugis_dugdale
      !> Radii, load and approach.
      type(sphere_contact_t) :: contact
      !> X, the share of adhesion that friction leaves.
      real(dp) :: ratio = 1
      !> Proved error of the theory, and the error estimate of the point, which contains it.
      real(dp) :: theory_error = 0, error_estimate = 0
      !> Do the bodies neither touch nor attract each other?
      logical :: is_apart = .false.
      !> Radius b of friction, and the load at which the contact separates.
      real(dp) :: friction_radius = 0, pull_off_load = 0
      !> gamma = e/b, tangential force and displacement, slip at the edge: mean and largest.
      real(dp) :: gamma = 1, friction_force = 0, displacement = 0, slip = 0, largest_slip = 0
      !> Events of the static phase; NaN where they are not asked for, or do not happen.
      type(peeling_events_t) :: events
      !> Radii and stresses of a contact whose strength grows with pressure.
      type(sheared_sphere_t), allocatable :: sheared
   end type sphere_point_t

   !> What one point of a block hands on to the next, to save time.
   type :: sphere_memory_t
      !> The theory that is asked for; Maugis-Dugdale where it is to be chosen.
      class(theory_t), allocatable :: theory
      !> The theory's number, its lambda, and where it found a contact last.
      integer :: number = -1
      !> Maugis's parameter of this theory.
      real(dp) :: lambda = 0
      !> The last contact that this theory found.
      type(sphere_contact_t) :: contact
      !> What the choice of a theory needs.
      type(theory_choice_t) :: choice
      !> The last pull-off load, and what it belongs to.
      real(dp) :: pull_off_load = 0, pull_off_ratio = -1
      !> What was prescribed for that load, one of `control_...`; 0: none is known.
      integer :: pull_off_control = 0
      !> The last events of the static phase, and the contact and friction they belong to.
      logical :: has_events = .false.
      !> The point that the events belong to.
      type(sphere_case_t) :: events_case
      !> The events of that point.
      type(peeling_events_t) :: events
      !> The last way of a sphere on a driven spring.
      logical :: has_drive = .false.
      !> The point that it belongs to.
      type(sphere_case_t) :: drive_case
      !> That way.
      type(spring_drive_t) :: drive
   end type sphere_memory_t

contains

   !> Solve a point.
   subroutine solve_point(case, needs_events, memory, point)
      type(sphere_case_t), intent(in) :: case
      !> Are the events of the static phase asked for?
      logical, intent(in) :: needs_events
      !> What earlier points left; it saves time and changes no result.
      type(sphere_memory_t), intent(inout) :: memory
      !> Receives what is found of the point, reduced.
      type(sphere_point_t), intent(out) :: point
      type(friction_state_t) :: state
      real(dp) :: spring_error

      spring_error = 0
      call forget_peeling_events(point%events)
      if (case%has_friction .and. case%is_sliding) point%ratio = adhesion_ratio(case%slip_energy_ratio, case%interaction)
      point%theory = case%theory
      if (case%theory == theory_auto) point%theory = theory_maugis_dugdale
      call take_theory(point%theory, case%lambda, memory)
      if (case%is_base_given) then
         call take_drive(case, memory)
         call find_driven_sphere(memory%drive, case%tangential, state)
         call take_state(state, point)
         if (state%is_found) spring_error = driven_error(memory%drive%jump, case%stiffness, case%tangential, state%force)
      else if (is_peeling(case)) then
         call peel(case, memory, state)
         call take_state(state, point)
      else
         ! with events X changes on the path, and with it what could be proved; nothing is proved of what r < b carries
         if (case%theory == theory_auto .and. .not. (needs_events .or. case%pressure_factor > 0)) &
            & call try_limit(case, memory, point)
         memory%theory%ratio = point%ratio
         if (.not. point%contact%is_found) then
            point%contact = memory%contact
            call find_contact(memory%theory, case%control, case%value, case%branch, point%contact)
         end if
         if (.not. (point%contact%is_found .or. point%theory == theory_dmt .or. case%tangential > 0)) &
            & call part_bodies(case%control, case%value, case%branch, point%contact, point%is_apart)
      end if
      memory%theory%ratio = point%ratio
      call finish_contact(case, memory, point)
      if (point%status == status_solved) point%error_estimate = min(1.0_dp, point%error_estimate + spring_error)
      if (point%status == status_solved .and. case%pressure_factor > 0 .and. point%friction_radius > 0) then
         call add_sheared(case, memory, needs_events, point)
      else if (point%status == status_solved .and. case%has_friction .and. .not. (is_peeling(case) .or. case%is_base_given)) then
         call add_friction(case, point)
      end if
      if (needs_events .and. .not. case%pressure_factor > 0) call add_events(case, memory, point)
   end subroutine solve_point

   !> Take the path on a driven spring into the memory.
   pure subroutine take_drive(case, memory)
      type(sphere_case_t), intent(in) :: case
      !> Receives the path, if it is a new one.
      type(sphere_memory_t), intent(inout) :: memory
      type(peeling_path_t) :: path

      if (memory%has_drive) then
         if (has_same_events(case, memory%drive_case)) return
      end if
      call new_path_of(case, memory, path)
      call new_spring_drive(memory%drive, path, case%stiffness)
      memory%drive_case = case
      memory%has_drive = .true.
   end subroutine take_drive

   !> Does static friction change the contact?
   pure logical function is_peeling(case)
      type(sphere_case_t), intent(in) :: case

      is_peeling = case%has_friction .and. case%interaction > 0 .and. (case%is_force_given .or. case%is_displacement_given) &
         & .and. case%tangential > 0
   end function is_peeling

   !> The law of friction of a case.
   pure type(peeling_friction_t) function new_friction(case) result(friction)
      type(sphere_case_t), intent(in) :: case

      friction = peeling_friction_t(case%strength, case%poisson, case%edge_fraction, case%interaction, case%slip_energy_ratio)
   end function new_friction

   !> The state of static friction that changes the contact.
   pure subroutine peel(case, memory, state)
      type(sphere_case_t), intent(in) :: case
      type(sphere_memory_t), intent(in) :: memory
      type(friction_state_t), intent(out) :: state
      type(peeling_path_t) :: path

      call new_path_of(case, memory, path)
      call find_static_state(path, merge(given_force, given_displacement, case%is_force_given), case%tangential, state)
   end subroutine peel

   !> The path of a case from rest to sliding.
   pure subroutine new_path_of(case, memory, path)
      type(sphere_case_t), intent(in) :: case
      type(sphere_memory_t), intent(in) :: memory
      type(peeling_path_t), intent(out) :: path

      call new_sphere_path(path, memory%theory, new_friction(case), case%control, case%value, case%branch)
   end subroutine new_path_of

   !> A state of the static phase.
   pure subroutine take_state(state, point)
      type(friction_state_t), intent(in) :: state
      !> Receives the contact, X and friction of the state.
      type(sphere_point_t), intent(inout) :: point

      point%contact = state%contact
      point%contact%is_found = state%is_found
      point%contact%is_converged = state%is_converged
      point%ratio = state%ratio
      point%gamma = state%gamma
      point%friction_force = state%force
      point%displacement = state%displacement
      point%slip = state%slip
      point%largest_slip = state%largest_slip
   end subroutine take_state

   !> What happens between rest and sliding; a tangential force or displacement has no part in it.
   pure subroutine add_events(case, memory, point)
      type(sphere_case_t), intent(in) :: case
      !> What earlier points left; it receives the events if they are new.
      type(sphere_memory_t), intent(inout) :: memory
      !> Receives the events, and their status if they were not found to round-off.
      type(sphere_point_t), intent(inout) :: point
      type(peeling_path_t) :: path

      if (.not. (memory%has_events .and. has_same_events(case, memory%events_case))) then
         call new_path_of(case, memory, path)
         call find_peeling_events(path, case%stiffness, memory%events)
         memory%events_case = case
         memory%has_events = .true.
      end if
      point%events = memory%events
      if (point%events%is_found .and. .not. point%events%is_converged) point%status = status_not_converged
   end subroutine add_events

   !> Have two points of one theory the same way from rest to sliding?
   pure logical function has_same_events(one, two)
      type(sphere_case_t), intent(in) :: one, two

      has_same_events = one%control == two%control .and. one%branch == two%branch .and. .not. any(abs( &
         & [one%value, one%strength, one%poisson, one%edge_fraction, one%interaction, one%slip_energy_ratio, &
         & one%stiffness] &
         & - [two%value, two%strength, two%poisson, two%edge_fraction, two%interaction, two%slip_energy_ratio, &
         & two%stiffness]) > 0)
   end function has_same_events

   !> Take the theory of a number into the memory.
   subroutine take_theory(number, lambda, memory)
      integer, intent(in) :: number
      !> Maugis's parameter [-], > 0.
      real(dp), intent(in) :: lambda
      !> Receives the theory; what belongs to another theory is forgotten.
      type(sphere_memory_t), intent(inout) :: memory

      if (number == memory%number .and. .not. abs(lambda - memory%lambda) > 0) return
      call new_theory(memory%theory, number, lambda)
      memory%number = number
      memory%lambda = lambda
      memory%contact = sphere_contact_t()
      memory%pull_off_ratio = -1
      memory%has_events = .false.
      memory%has_drive = .false.
   end subroutine take_theory

   !> The contact of a limit theory, where it will do.
   pure subroutine try_limit(case, memory, point)
      type(sphere_case_t), intent(in) :: case
      !> What earlier points left; it receives the choice if that is another one.
      type(sphere_memory_t), intent(inout) :: memory
      !> In: with X. Out: with the theory that will do, its error, and its contact if that is a limit theory.
      type(sphere_point_t), intent(inout) :: point
      logical :: needs_edge

      needs_edge = case%edge_fraction > 0
      if (.not. is_choice_of(memory%choice, case%lambda, point%ratio, case%control, needs_edge, case%tolerance)) then
         call new_choice(memory%choice, case%lambda, point%ratio, case%control, needs_edge, case%tolerance)
      end if
      call choose_theory(memory%choice, case%value, case%branch, point%theory, point%theory_error, point%contact)
   end subroutine try_limit

   !> Add what follows from the contact alone.
   subroutine finish_contact(case, memory, point)
      type(sphere_case_t), intent(in) :: case
      !> What earlier points left; it receives the pull-off load, and the contact as a neighbour.
      type(sphere_memory_t), intent(inout) :: memory
      !> In: with theory, X and contact. Out: with status, error estimate, pull-off load and friction radius, too.
      type(sphere_point_t), intent(inout) :: point
      type(sphere_contact_t) :: fold

      if (abs(memory%pull_off_ratio - point%ratio) > 0 .or. memory%pull_off_control /= case%control) then
         ! of Maugis-Dugdale, where that stands for a limit theory: what is proved of the contact is not proved of its end
         call memory%theory%pull_off(case%control, fold)
         memory%pull_off_load = fold%load
         memory%pull_off_ratio = point%ratio
         memory%pull_off_control = case%control
      end if
      point%pull_off_load = memory%pull_off_load
      if (.not. point%contact%is_found) then
         point%status = merge(status_no_equilibrium, status_not_converged, point%contact%is_converged)
         return
      end if
      if (point%is_apart) return
      point%error_estimate = point%theory_error + get_mismatch_of(memory, point, case%control)
      if (.not. point%contact%is_converged .or. .not. point%error_estimate < 1) then
         point%status = status_not_converged
         return
      end if
      if (point%theory == memory%number) memory%contact = point%contact
      if (point%contact%radius > 0) point%friction_radius = friction_radius(point%contact, case%edge_fraction)
   end subroutine finish_contact

   !> By how much the contact misses the equations of its theory.
   pure real(dp) function get_mismatch_of(memory, point, control) result(mismatch)
      !> Holds the theories of which one has found the contact.
      type(sphere_memory_t), intent(in) :: memory
      type(sphere_point_t), intent(in) :: point
      integer, intent(in) :: control

      if (point%theory == memory%number) then
         mismatch = get_mismatch(memory%theory, point%theory, control, point%contact)
      else if (point%theory == theory_dmt) then
         mismatch = get_mismatch(memory%choice%dmt, point%theory, control, point%contact)
      else
         mismatch = get_mismatch(memory%choice%jkr, point%theory, control, point%contact)
      end if
   end function get_mismatch_of

   !> Friction of a strength that grows with pressure.
   subroutine add_sheared(case, memory, needs_events, point)
      type(sphere_case_t), intent(in) :: case
      type(sphere_memory_t), intent(in) :: memory
      !> Are the events asked for? At the onset of sliding nothing drops.
      logical, intent(in) :: needs_events
      !> In: with its contact. Out: with its friction, too, or with the status of a force that it does not bear.
      type(sphere_point_t), intent(inout) :: point
      type(sphere_slip_t) :: slip

      allocate (point%sheared)
      call new_sheared_sphere(point%sheared, memory%theory, point%contact, case%strength, case%pressure_factor, &
         & case%edge_fraction, case%poisson)
      associate (sphere => point%sheared)
         if (.not. sphere%has_force) then
            point%status = status_no_equilibrium
            return
         end if
         if (needs_events) then
            point%events%peak_force = sphere%largest_force
            point%events%peak_displacement = sphere%largest_displacement
            point%events%sliding_force = sphere%largest_force
            point%events%force_drop = 0
            point%events%critical_stiffness = 0
         end if
         if (case%is_sliding) then
            call slide(sphere%largest_force, point)
            return
         end if
         if (case%tangential > merge(sphere%largest_displacement, sphere%largest_force, case%is_displacement_given)) then
            point%status = status_no_equilibrium
            return
         end if
         call find_slip(sphere, case%tangential, .not. case%is_displacement_given, slip)
      end associate
      if (.not. slip%is_converged) point%status = status_not_converged
      point%gamma = slip%gamma
      point%friction_force = slip%force
      point%displacement = slip%displacement
      point%slip = slip%slip
      point%largest_slip = slip%largest_slip
   end subroutine add_sheared

   !> The state of sliding.
   pure subroutine slide(force, point)
      !> Force of sliding, reduced.
      real(dp), intent(in) :: force
      !> Receives it; displacement and slip grow without end.
      type(sphere_point_t), intent(inout) :: point

      point%gamma = 0
      point%friction_force = force
      point%displacement = not_a_number()
      point%slip = not_a_number()
      point%largest_slip = not_a_number()
   end subroutine slide

   !> Friction that leaves the contact alone: during sliding, or without interaction.
   pure subroutine add_friction(case, point)
      type(sphere_case_t), intent(in) :: case
      type(sphere_point_t), intent(inout) :: point
      real(dp) :: largest_force, largest_displacement, angle
      type(interaction_law_t) :: law

      largest_force = half_pi*case%strength*point%friction_radius**2
      law = law_of_sphere(new_friction(case))
      largest_displacement = 2*law%compliance*law%strength*point%friction_radius
      if (case%is_sliding) then
         call slide(largest_force, point)
         return
      end if
      ! little slip is known by the angle, of which gamma = cos(angle) says nothing
      point%gamma = 1
      angle = 0
      if (case%is_force_given .and. case%tangential > 0) then
         if (case%tangential > largest_force) point%status = status_no_equilibrium
         if (point%status /= status_solved) return
         point%gamma = gamma_of_force(case%tangential/largest_force)
         angle = angle_of_force(case%tangential/largest_force)
      else if (case%is_displacement_given .and. case%tangential > 0) then
         if (case%tangential > largest_displacement) point%status = status_no_equilibrium
         if (point%status /= status_solved) return
         point%gamma = gamma_of_displacement(case%tangential/largest_displacement)
         angle = asin(case%tangential/largest_displacement)
      end if
      call add_static_friction(case, angle, point)
   end subroutine add_friction

   !> Add force, displacement and slip that follow from arccos gamma.
   pure subroutine add_static_friction(case, angle, point)
      type(sphere_case_t), intent(in) :: case
      !> Angle arccos gamma [rad], 0 to pi/2.
      real(dp), intent(in) :: angle
      !> In: with its friction radius. Out: with force, displacement and slip, too.
      type(sphere_point_t), intent(inout) :: point
      type(interaction_law_t) :: law

      law = law_of_sphere(new_friction(case))
      point%friction_force = half_pi*case%strength*point%friction_radius**2*force_of_angle(angle)
      if (case%is_force_given) point%friction_force = case%tangential
      point%displacement = 2*law%compliance*law%strength*point%friction_radius*sin(angle)
      if (case%is_displacement_given) point%displacement = case%tangential
      point%slip = slip_of(law, point%friction_radius, angle)
      point%largest_slip = largest_slip_of(law, point%friction_radius, angle)
   end subroutine add_static_friction

end module adfric_round_sphere_point
