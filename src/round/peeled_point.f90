! SPDX-License-Identifier: GPL-3.0-or-later
!> What friction does to the contact of a point of the model `indenter`: it slides with less adhesion, it slips in part, or it peels.
module adfric_round_peeled_point
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi, pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_unset, only: is_set
   use adfric_round_brittle_peeling, only: brittle_t, find_peeled, new_brittle
   use adfric_round_case, only: indenter_case_t, tangential_compliance
   use adfric_round_contact, only: branch_stable, find_contact
   use adfric_round_contact_state, only: contact_t
   use adfric_round_survey, only: ends_t, survey_curve, survey_t
   use adfric_round_interaction_events, only: find_peeling_events, peeling_events_t, results_of_events
   use adfric_round_interaction_path, only: interaction_law_t, gamma_of, get_rates, largest_slip_of, slip_of, waypoint_t
   use adfric_round_interaction_search, only: find_state
   use adfric_round_indenter_path, only: indenter_path_t, new_path
   use adfric_round_spring_drive, only: driven_state_t, find_driven_state, new_spring_drive, spring_drive_t
   use adfric_round_variables, only: law_peeling, state_sliding, theory_none, in => indenter_input, out => indenter_output
   use adfric_round_weak_path, only: weaken
   use adfric_solid_contact_modulus, only: has_poisson_ratio
   use adfric_round_driven_contact, only: driven_error
   use adfric_interface_interaction, only: adhesion_ratio
   use adfric_interface_interaction_rows, only: slip_energy_ratio_of
   use adfric_round_shrinking_path, only: displacement_of, first_force, force_of
   use adfric_round_slip_annulus, only: angle_of_force
   implicit none (type, external)
   private
   public :: peeled_t, begin_sliding, peel_contact, store_driven, store_peeled, wants_peeling_events

   !> What peeling has done to a contact.
   type :: peeled_t
      !> X, what friction leaves of adhesion.
      real(dp) :: ratio = 1
      !> Does the contact change with the force?
      logical :: is_peeling = .false.
      !> dT/du along the path, reduced.
      real(dp) :: stiffness = 0
      !> Relative error of the radius by round-off of the force, and that of the force on a driven spring.
      real(dp) :: error = 0, spring_error = 0
      !> Has all been found to round-off?
      logical :: is_converged = .true.
      !> Are the events of the path known, from a point that differs in the force alone?
      logical :: has_events = .false.
      !> They, reduced.
      type(peeling_events_t) :: events
      !> Is the path on a driven spring known, from a point that differs in the displacement of the base alone?
      logical :: has_drive = .false.
      !> That way.
      type(spring_drive_t) :: drive
      !> The state at the displacement of the base.
      type(driven_state_t) :: driven
   end type peeled_t

contains

   !> Shall the events of a growing tangential force be found? They need Poisson's ratio, and a uniform shear strength.
   pure logical function wants_peeling_events(values) result(wants)
      real(dp), intent(in) :: values(:)

      wants = values(in%events) > 0 .and. has_poisson_ratio(values(in%contact_modulus:in%second_poisson_ratio))
      if (.not. wants) return
      if (nint(values(in%law)) == law_peeling) return
      wants = is_set(values(in%shear_strength)) .and. nint(values(in%branch)) == branch_stable
      if (wants) wants = values(in%shear_strength) > 0
      if (is_set(values(in%pressure_factor))) wants = wants .and. .not. values(in%pressure_factor) > 0
   end function wants_peeling_events

   !> The law of friction of a point.
   pure type(interaction_law_t) function law_of(values, case) result(law)
      real(dp), intent(in) :: values(:)
      !> The point with its units, and all of its adhesion.
      type(indenter_case_t), intent(in) :: case
      real(dp) :: work

      work = 0
      if (is_set(values(in%work_of_adhesion))) work = values(in%work_of_adhesion)
      law%strength = values(in%shear_strength)/(case%modulus*(case%height_unit/case%length_unit))
      ! in sliding no displacement is known, and none is needed
      if (has_poisson_ratio(values(in%contact_modulus:in%second_poisson_ratio))) &
         & law%compliance = tangential_compliance(values, case)
      law%edge_fraction = values(in%edge_fraction)
      law%interaction = values(in%interaction)
      law%slip_energy_ratio = slip_energy_ratio_of(values(in%interaction:in%slip_energy_ratio), values(in%shear_strength), work)
   end function law_of

   !> In sliding the curve has lost what friction takes; the events before it belong to the whole curve.
   pure subroutine begin_sliding(values, case, peeled, results)
      real(dp), intent(in) :: values(:)
      !> In: the point. Out: with the adhesion that remains.
      type(indenter_case_t), intent(inout) :: case
      type(peeled_t), intent(inout) :: peeled
      !> Receives the events; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      type(survey_t) :: survey
      type(contact_t) :: contact
      type(indenter_path_t) :: path
      type(interaction_law_t) :: law

      if (wants_peeling_events(values)) then
         call survey_curve(case%curve, case%control, survey)
         call find_contact(case%curve, survey, case%control, case%given, case%is_beyond, case%branch, contact)
         peeled%is_converged = survey%ends%is_converged .and. contact%is_converged
         call new_path(path, case%curve, law_of(values, case), case%control, case%given, contact)
         call add_events(case, path, peeled, results)
      end if
      if (.not. values(in%interaction) > 0) return
      law = law_of(values, case)
      peeled%ratio = adhesion_ratio(law%slip_energy_ratio, law%interaction)
      call weaken(case%curve, peeled%ratio)
   end subroutine begin_sliding

   !> Add the events of a path, in SI units.
   pure subroutine add_events(case, path, peeled, results)
      type(indenter_case_t), intent(in) :: case
      type(indenter_path_t), intent(inout) :: path
      type(peeled_t), intent(inout) :: peeled
      real(dp), intent(inout) :: results(:)

      if (.not. peeled%has_events) call find_peeling_events(path, case%lateral_stiffness, peeled%events)
      peeled%has_events = .true.
      peeled%is_converged = peeled%is_converged .and. peeled%events%is_converged
      results(out%peak_force:out%period_work) = results_of_events(peeled%events, case%force_unit(), case%height_unit, &
         & case%stiffness_unit())
   end subroutine add_events

   !> The contact under a tangential force that takes from adhesion, and the events of its path.
   pure subroutine peel_contact(values, case, contact, peeled, ends, results)
      real(dp), intent(in) :: values(:)
      type(indenter_case_t), intent(inout) :: case
      !> In: the contact at rest. Out: that under the force; not found if there is none.
      type(contact_t), intent(inout) :: contact
      type(peeled_t), intent(inout) :: peeled
      !> In: where contacts end at rest. Out: with the adhesion that remains.
      type(ends_t), intent(inout) :: ends
      real(dp), intent(inout) :: results(:)
      type(indenter_path_t) :: path
      type(waypoint_t) :: waypoint
      type(survey_t) :: weak
      real(dp) :: force
      logical :: is_moved

      force = 0
      if (is_set(values(in%tangential_force))) force = abs(values(in%tangential_force))/case%force_unit()
      if (nint(values(in%law)) == law_peeling) then
         call peel_brittle(values, case, force, contact, peeled, results)
         return
      end if
      is_moved = values(in%interaction) > 0 .and. force > 0 .or. is_set(values(in%base_displacement))
      if (.not. (is_moved .or. wants_peeling_events(values)) .or. .not. contact%is_found) return
      call new_path(path, case%curve, law_of(values, case), case%control, case%given, contact)
      if (wants_peeling_events(values)) call add_events(case, path, peeled, results)
      if (.not. is_moved) return
      ! without touch no force is borne
      contact%is_found = path%start%is_found
      if (.not. contact%is_found) return
      if (is_set(values(in%base_displacement))) then
         call drive_contact(case, path, peeled)
         waypoint = peeled%driven%waypoint
         waypoint%is_found = peeled%driven%is_found
      else
         call find_state(path, first_force, force, waypoint, peeled%is_converged)
      end if
      contact%is_found = waypoint%is_found
      if (.not. waypoint%is_found) return
      contact = waypoint%contact
      peeled%ratio = waypoint%ratio
      call weaken(case%curve, peeled%ratio)
      call survey_curve(case%curve, case%control, weak)
      ends = weak%ends
      call add_rates(path, waypoint, peeled)
   end subroutine peel_contact

   !> The state at a displacement of the base of a lateral spring.
   pure subroutine drive_contact(case, path, peeled)
      type(indenter_case_t), intent(in) :: case
      !> The path from rest, which need not have been followed.
      type(indenter_path_t), intent(in) :: path
      !> Receives the state; its path is found if it is not known.
      type(peeled_t), intent(inout) :: peeled

      if (.not. peeled%has_drive) call new_spring_drive(peeled%drive, path, case%lateral_stiffness)
      peeled%has_drive = .true.
      peeled%is_converged = peeled%is_converged .and. peeled%drive%is_converged
      if (.not. peeled%drive%is_converged) return
      call find_driven_state(peeled%drive, case%base_displacement, peeled%driven)
      if (peeled%driven%is_found) peeled%spring_error = driven_error(peeled%drive%jump, case%lateral_stiffness, &
         & case%base_displacement, peeled%driven%force)
   end subroutine drive_contact

   !> The slope of the force over the displacement, and what round-off of the force does to the radius.
   pure subroutine add_rates(path, waypoint, peeled)
      type(indenter_path_t), intent(in) :: path
      type(waypoint_t), intent(in) :: waypoint
      type(peeled_t), intent(inout) :: peeled
      real(dp), parameter :: round_off = 8*epsilon(1.0_dp)
      real(dp) :: force_rate, displacement_rate, shrinkage

      peeled%is_peeling = waypoint%slip_energy > 0 .and. waypoint%slip_energy < min(path%law%slip_energy_ratio, path%limit)
      if (.not. peeled%is_peeling .or. .not. waypoint%angle > 0) return
      call get_rates(path, waypoint, force_rate, displacement_rate, shrinkage)
      peeled%stiffness = force_of(path, waypoint)/displacement_of(path, waypoint)*(force_rate/displacement_rate)
      peeled%error = min(sqrt(round_off), round_off*abs(shrinkage)/max(abs(force_rate), round_off))
   end subroutine add_rates

   !> The contact that sticks without limit and peels.
   pure subroutine peel_brittle(values, case, force, contact, peeled, results)
      real(dp), intent(in) :: values(:)
      type(indenter_case_t), intent(in) :: case
      !> T, reduced, >= 0.
      real(dp), intent(in) :: force
      type(contact_t), intent(inout) :: contact
      type(peeled_t), intent(inout) :: peeled
      !> Receives the event; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      real(dp), parameter :: round_off = 4*epsilon(1.0_dp)
      type(brittle_t) :: brittle
      real(dp) :: radius

      if (.not. contact%is_found) return
      call new_brittle(brittle, case%curve, case%given, tangential_compliance(values, case), contact)
      if (values(in%events) > 0) then
         results(out%snap_off_force) = brittle%snap_off_force*case%force_unit()
         results(out%snap_off_displacement) = brittle%snap_off_displacement*case%height_unit
      end if
      radius = contact%spot%radius
      contact%is_found = force <= (1 + round_off)*brittle%snap_off_force
      if (.not. contact%is_found) return
      call find_peeled(brittle, min(force, brittle%snap_off_force), contact, peeled%ratio, peeled%stiffness, peeled%is_converged)
      peeled%is_peeling = .true.
      ! next to snap-off the radius goes by the root of the force
      if (force > 0 .and. contact%spot%radius < radius) peeled%error = min(sqrt(round_off), round_off &
         & *abs(2/(brittle%compliance*peeled%stiffness/contact%spot%radius) - 1))
   end subroutine peel_brittle

   !> Add what slip and peeling are, in SI units, to the results of a contact and of its friction.
   pure subroutine store_peeled(values, case, peeled, results)
      real(dp), intent(in) :: values(:)
      type(indenter_case_t), intent(in) :: case
      type(peeled_t), intent(in) :: peeled
      !> In: with the results of friction. Out: with those of slip; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      type(interaction_law_t) :: law
      real(dp) :: angle, radius, compliance

      if (case%theory /= theory_none) results(out%adhesion_ratio) = peeled%ratio
      if (nint(values(in%law)) == law_peeling) then
         compliance = tangential_compliance(values, case)
         results(out%stick_radius) = results(out%contact_radius)
         results(out%stick_fraction) = 1
         if (is_set(values(in%tangential_force))) results(out%tangential_displacement) = compliance*values(in%tangential_force) &
            & /(2*case%modulus*results(out%contact_radius))
         results(out%tangential_stiffness) = peeled%stiffness*case%modulus*case%length_unit
         return
      end if
      results(out%friction_radius) = sqrt(results(out%friction_area)/pi)
      if (nint(values(in%state)) == state_sliding) then
         results([out%stick_radius, out%stick_fraction]) = 0
         return
      end if
      if (.not. is_set(values(in%tangential_force)) .or. .not. results(out%friction_radius) > 0) return
      results(out%stick_radius) = sqrt(results(out%stick_fraction))*results(out%friction_radius)
      if (peeled%is_peeling) results(out%tangential_stiffness) = peeled%stiffness*case%modulus*case%length_unit
      if (is_set(values(in%pressure_factor))) then
         if (values(in%pressure_factor) > 0) return
      end if
      law = law_of(values, case)
      radius = results(out%friction_radius)/case%length_unit
      angle = half_pi
      if (abs(values(in%tangential_force)) < results(out%friction_force)) &
         & angle = angle_of_force(abs(values(in%tangential_force))/results(out%friction_force))
      results(out%slip) = slip_of(law, radius, angle)*case%height_unit
      results(out%largest_slip) = largest_slip_of(law, radius, angle)*case%height_unit
   end subroutine store_peeled

   !> Add the state at a displacement of the base, in SI units, which its angle tells better than its force does.
   pure subroutine store_driven(values, case, peeled, results)
      !> Values of the variables, with the tangential force of the state; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(indenter_case_t), intent(in) :: case
      type(peeled_t), intent(in) :: peeled
      !> In: with the results of friction. Out: with those of the state; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      type(interaction_law_t) :: law
      real(dp) :: stick

      associate (driven => peeled%driven, waypoint => peeled%driven%waypoint)
         results(out%tangential_force) = values(in%tangential_force)
         results(out%tangential_displacement) = driven%displacement*case%height_unit
         stick = gamma_of(waypoint)
         results(out%stick_fraction) = stick**2
         results(out%stick_radius) = stick*results(out%friction_radius)
         if (driven%is_sliding) then
            results([out%slip, out%largest_slip, out%cycle_energy]) = not_a_number()
            results(out%tangential_stiffness) = 0
         else
            law = law_of(values, case)
            results(out%slip) = slip_of(law, waypoint%radius, waypoint%angle)*case%height_unit
            results(out%largest_slip) = largest_slip_of(law, waypoint%radius, waypoint%angle)*case%height_unit
         end if
      end associate
   end subroutine store_driven

end module adfric_round_peeled_point
