! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `indenter`: an indenter of any axisymmetric shape on an elastic half-space, without adhesion or with it (JKR, Maugis-Dugdale).
module adfric_indenter_model
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_number
   use adfric_base_unset, only: is_set
   use adfric_indenter_axis_stress, only: get_axis_stress
   use adfric_indenter_case, only: indenter_case_t, resolve_case, is_possible
   use adfric_indenter_check, only: check_indenter_values
   use adfric_indenter_contact, only: find_contact
   use adfric_indenter_contact_state, only: contact_t, terms_of
   use adfric_indenter_survey, only: ends_t, survey_t, survey_curve
   use adfric_indenter_curve, only: control_approach, control_load, control_radius, control_spring, stability_control
   use adfric_indenter_energy, only: elastic_energy
   use adfric_indenter_loop, only: find_loop, loop_t
   use adfric_indenter_peeled_point, only: begin_sliding, peel_contact, peeled_t, store_peeled, tangential_compliance
   use adfric_indenter_profiles, only: pressure_at, gap_at
   use adfric_indenter_shear, only: find_shear_slip, find_sliding, resistance_t, shear_slip_t, shear_stress_at
   use adfric_indenter_slip, only: find_indenter_slip, indenter_slip_t
   use adfric_indenter_variables
   use adfric_material_contact_modulus, only: derive_contact_modulus
   use adfric_model_derived, only: derived_t
   use adfric_model_pointwise, only: pointwise_model_t, point_state_t
   use adfric_model_status, only: status_solved, status_no_equilibrium, status_not_converged
   use adfric_model_table, only: profile_axis_t
   implicit none (type, external)
   private
   public :: indenter_model_t, new_indenter_model

   !> The model; its tables stand in `adfric_indenter_variables`.
   type, extends(pointwise_model_t) :: indenter_model_t
   contains
      procedure :: check_values
      procedure :: wants_profiles
      procedure :: get_profile_axes
      procedure :: solve_point
      procedure :: count_profiles
      procedure :: fill_profiles
      procedure :: derive_quantities
      procedure :: unit_of
   end type indenter_model_t

   !> What a point leaves for its profiles.
   type, extends(point_state_t) :: indenter_state_t
      !> The point.
      type(indenter_case_t) :: case
      !> Its contact.
      type(contact_t) :: contact
      !> Its slip, where there is friction.
      type(indenter_slip_t) :: slip
      !> How it resists shear, where there is a shear strength.
      type(resistance_t) :: resistance
      !> Its slip then.
      type(shear_slip_t) :: shear
      !> The survey of its curve; it serves the next point, too, if that has the same curve and control.
      type(survey_t) :: survey
      !> Values of the variables up to the theory, the stiffness of the spring, and X in sliding, which the curve follows from where
      !> there is a range of adhesion.
      real(dp) :: values(v_theory + 2) = 0
      !> What happens in a cycle of approach and retraction.
      type(loop_t) :: loop
      !> Has a survey been made?
      logical :: is_surveyed = .false.
      !> What peeling has done; its events serve the next point, too, if that has another force alone.
      type(peeled_t) :: peeled
      !> All values of the point.
      real(dp) :: point(n_indenter_variables) = 0
   end type indenter_state_t

contains

   !> The model with its tables.
   subroutine new_indenter_model(self)
      !> Receives its names and its tables.
      type(indenter_model_t), intent(out) :: self

      self%name = 'indenter'
      self%summary = 'an indenter of any axisymmetric shape on a half-space, without adhesion or with it (JKR, Maugis-Dugdale)'
      self%references = 'I. N. Sneddon, Int. J. Eng. Sci. 3 (1965) 47; D. Maugis, M. Barquins, J. Phys. D 11 (1978) 1989'
      self%variables = get_indenter_variables()
      self%results = get_indenter_results()
      self%profiles = get_indenter_profiles()
      self%profile_axes = 'r'
      allocate (self%counts(0))
   end subroutine new_indenter_model

   !> See `model_t`.
   subroutine check_values(self, values, is_swept, problems)
      !> The model, whose table of variables is read.
      class(indenter_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call check_indenter_values(self%variables, values, is_swept, problems)
   end subroutine check_values

   !> See `model_t`.
   pure logical function wants_profiles(self, values)
      !> The model; nothing of it is read here.
      class(indenter_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      wants_profiles = values(v_profiles) > 0
      associate (unused => self)
      end associate
   end function wants_profiles

   !> See `model_t`.
   subroutine get_profile_axes(self, values, axes)
      !> The model, for the name of its axis.
      class(indenter_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the axis r.
      type(profile_axis_t), allocatable, intent(out) :: axes(:)
      integer :: n, k

      allocate (axes(1))
      axes(1)%name = self%profile_axes
      axes(1)%unit = 'm'
      axes(1)%long_name = 'distance from the axis'
      n = nint(values(v_n_r))
      allocate (axes(1)%coordinates(n), source=0.0_dp)
      if (is_set(values(v_r_max))) axes(1)%coordinates = [(values(v_r_max)*k/(n - 1), k=0, n - 1)]
   end subroutine get_profile_axes

   !> See `pointwise_model_t`.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
      !> The model; nothing of it is read here.
      class(indenter_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the contact, for the profiles; nothing is taken from the point before.
      class(point_state_t), allocatable, intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Relative error of radius, load and approach, the largest of them, estimated.
      real(dp), intent(out) :: error_estimate
      !> One of `status_...`.
      integer, intent(out) :: status
      !> This model counts nothing; size 0.
      real(dp), intent(inout) :: counts(:)
      type(indenter_state_t), allocatable :: found
      type(ends_t) :: ends

      allocate (found)
      error_estimate = 0
      status = status_no_equilibrium
      call resolve_case(values, found%case)
      if (.not. is_possible(values, found%case)) return
      associate (case => found%case, contact => found%contact, peeled => found%peeled)
         call take_events(state, values, found)
         if (nint(values(v_state)) == state_sliding) call begin_sliding(values, case, peeled, results)
         found%values = [values(:v_theory), values(v_machine_stiffness), peeled%ratio]
         call take_survey(state, found)
         if (.not. found%is_surveyed) then
            call survey_curve(case%curve, case%control, found%survey)
            if (makes_cycle(values)) call find_loop(case%curve, found%survey, case%control, found%loop)
         end if
         found%is_surveyed = .true.
         if (makes_cycle(values)) call store_events(case, found%loop, results)
         call find_contact(case%curve, found%survey, case%control, case%given, case%is_beyond, case%branch, contact)
         ! the way to u and back is not exact
         if (case%radius > 0) contact%spot%radius = case%radius
         ends = found%survey%ends
         if (nint(values(v_state)) == state_static) call peel_contact(values, case, contact, peeled, ends, results)
         call store_ends(case, ends, results)
         if (.not. (contact%is_converged .and. ends%is_converged .and. found%survey%ends%is_converged &
            & .and. found%loop%is_converged .and. peeled%is_converged)) status = status_not_converged
         if (contact%is_found .and. status /= status_not_converged) then
            status = status_solved
            error_estimate = estimate_error(case, contact, found%survey%ends) + peeled%error
            call store_contact(case, contact, values, results)
            if (is_set(values(v_position_z))) call store_stress(case, contact, values, results)
            if (is_set(values(v_friction_coefficient))) call add_slip(values, found, results, status)
            if (is_set(values(v_shear_strength))) call add_friction(values, found, results, status)
            if (status == status_solved .and. (is_set(values(v_shear_strength)) .or. nint(values(v_law)) == law_peeling)) &
               & call store_peeled(values, case, peeled, results)
            if (peeled%is_peeling) results(r_cycle_energy) = not_a_number()
         end if
      end associate
      call move_alloc(found, state)
      associate (unused => self, unused_counts => counts)
      end associate
   end subroutine solve_point

   !> Are the events of a cycle of approach and retraction asked for?
   pure logical function makes_cycle(values)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      makes_cycle = values(v_events) > 0 .and. any(is_set(values([v_approach, v_base_approach])))
   end function makes_cycle

   !> Take the survey of the point before over, if it is that of the same curve. Without a range of adhesion the units follow from what
   !> is held, and a survey takes no time.
   subroutine take_survey(state, found)
      !> What the point before has left.
      class(point_state_t), allocatable, intent(in) :: state
      !> The point, which receives the survey.
      type(indenter_state_t), intent(inout) :: found

      if (.not. allocated(state) .or. found%case%theory /= theory_maugis_dugdale) return
      select type (state)
      type is (indenter_state_t)
         found%is_surveyed = state%is_surveyed .and. .not. any(abs(state%values - found%values) > 0) &
            & .and. stability_control(state%case%control) == stability_control(found%case%control)
         if (.not. found%is_surveyed) return
         found%survey = state%survey
         found%loop = state%loop
      end select
   end subroutine take_survey

   !> Take the events of the point before over, if that differs in the tangential force alone.
   pure subroutine take_events(state, values, found)
      !> What the point before has left.
      class(point_state_t), allocatable, intent(in) :: state
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> The point, which receives the events.
      type(indenter_state_t), intent(inout) :: found

      found%point = values
      found%point(v_tangential_force) = 0
      if (.not. allocated(state)) return
      select type (state)
      type is (indenter_state_t)
         if (any(abs(state%point - found%point) > 0) .or. .not. state%peeled%has_events) return
         found%peeled%has_events = .true.
         found%peeled%events = state%peeled%events
      end select
   end subroutine take_events

   !> Where contacts end, in SI units.
   pure subroutine store_ends(case, ends, results)
      !> The point with its units.
      type(indenter_case_t), intent(in) :: case
      !> Where contacts end, reduced.
      type(ends_t), intent(in) :: ends
      !> Receives them; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)

      results([r_pull_off_load, r_jump_inward_load, r_jump_outward_load]) = case%force_unit() &
         & *[ends%pull_off_load, ends%jump_inward_load, ends%jump_outward_load]
      results([r_pull_off_approach, r_jump_inward_approach, r_jump_outward_approach]) = case%height_unit &
         & *[ends%pull_off_approach, ends%jump_inward_approach, ends%jump_outward_approach]
   end subroutine store_ends

   !> What happens in a cycle, in SI units. Without adhesion nothing jumps.
   pure subroutine store_events(case, loop, results)
      !> The point with its units.
      type(indenter_case_t), intent(in) :: case
      !> What happens, reduced.
      type(loop_t), intent(in) :: loop
      !> Receives it; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)

      results(r_loop_energy) = 0
      if (case%theory == theory_none) return
      results(r_loop_energy) = loop%energy*case%force_unit()*case%height_unit
      results(r_jump_in_base_approach) = loop%jump_in*case%height_unit
      results(r_jump_in_load) = loop%jump_in_load*case%force_unit()
      results(r_pull_off_base_approach) = loop%pull_off*case%height_unit
   end subroutine store_events

   !> Results of a contact, in SI units. What was given comes back to the last digit.
   pure subroutine store_contact(case, contact, values, results)
      !> The point with its units.
      type(indenter_case_t), intent(in) :: case
      !> The contact, reduced.
      type(contact_t), intent(in) :: contact
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the results; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      real(dp) :: radius

      associate (a => contact%spot%radius)
         radius = a*case%length_unit
         if (is_set(values(v_contact_radius))) radius = values(v_contact_radius)
         results(r_load) = contact%load*case%force_unit()
         if (is_set(values(v_load))) results(r_load) = values(v_load)
         results(r_approach) = contact%approach*case%height_unit
         if (is_set(values(v_approach))) results(r_approach) = values(v_approach)
         if (is_set(values(v_base_approach))) results(r_base_approach) = values(v_base_approach)
         results(r_contact_radius) = radius
         results(r_contact_area) = pi*radius**2
         if (a > 0) results(r_mean_pressure) = contact%load/(pi*a**2)*case%modulus*(case%height_unit/case%length_unit)
         results(r_contact_stiffness) = contact%stiffness*case%modulus*case%length_unit
         results(r_elastic_energy) = elastic_energy(case%curve, contact)*case%force_unit()*case%height_unit
         results(r_stable) = merge(1, 0, contact%is_stable)
         results(r_theory_used) = case%theory
         if (case%theory /= theory_dmt) results(r_adhesion_radius) = contact%adhesion_radius*case%length_unit
      end associate
   end subroutine store_contact

   !> Stresses on the axis, in SI units.
   pure subroutine store_stress(case, contact, values, results)
      !> The point with its units.
      type(indenter_case_t), intent(in) :: case
      !> The contact, reduced.
      type(contact_t), intent(in) :: contact
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the results; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      real(dp) :: s_zz, s_rr, unit

      call get_axis_stress(case%curve%shape, contact, values(v_poisson_ratio), values(v_position_z)/case%length_unit, s_zz, s_rr)
      unit = case%modulus*(case%height_unit/case%length_unit)
      results(r_stress_zz) = s_zz*unit
      results(r_stress_rr) = s_rr*unit
   end subroutine store_stress

   !> Add the results of partial slip; without load there are none.
   pure subroutine add_slip(values, found, results, status)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> The point with its contact; receives the slip.
      type(indenter_state_t), intent(inout) :: found
      !> In: results of the contact. Out: with those of slip, or all NaN; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> In: solved. Out: one of `status_...`.
      integer, intent(inout) :: status
      real(dp), parameter :: round_off = 4*epsilon(1.0_dp)
      real(dp) :: needed, ratio
      logical :: is_converged

      associate (case => found%case, slip => found%slip, mu => values(v_friction_coefficient))
         needed = abs(values(v_tangential_force))/mu
         if (needed > (1 + round_off)*results(r_load)) then
            status = status_no_equilibrium
            results(:) = not_a_number()
            return
         end if
         if (.not. results(r_load) > 0) return
         call find_indenter_slip(case%curve, found%survey, found%contact, min(needed/results(r_load), 1.0_dp), slip, is_converged)
         ratio = tangential_compliance(values, case)
         results(r_stick_fraction) = slip%ratio**2
         results(r_tangential_displacement) = sign(mu*ratio*case%height_unit*slip%fall, values(v_tangential_force))
         results(r_tangential_stiffness) = 2*slip%stick%spot%radius*case%length_unit*case%modulus/ratio
         results(r_cycle_energy) = 8*mu**2*ratio*slip%energy*case%force_unit()*case%height_unit
         if (is_converged) return
         status = status_not_converged
         results(:) = not_a_number()
      end associate
   end subroutine add_slip

   !> Add the friction of a shear strength, and under a tangential force its partial slip.
   pure subroutine add_friction(values, found, results, status)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> The point with its contact; receives resistance and slip.
      type(indenter_state_t), intent(inout) :: found
      !> In: results of the contact. Out: with those of friction, or all NaN; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> In: solved. Out: one of `status_...`.
      integer, intent(inout) :: status
      real(dp), parameter :: round_off = 4*epsilon(1.0_dp)
      real(dp) :: radius, force, ratio, unit
      logical :: is_converged

      associate (case => found%case, slip => found%shear)
         unit = case%modulus*(case%height_unit/case%length_unit)
         found%resistance%strength = values(v_shear_strength)/unit
         if (is_set(values(v_pressure_factor))) found%resistance%factor = values(v_pressure_factor)
         found%resistance%edge_fraction = values(v_edge_fraction)
         call find_sliding(found%resistance, found%contact, case%curve%outer_pull, radius, force)
         results(r_friction_area) = pi*(radius*case%length_unit)**2
         results(r_friction_force) = force*case%force_unit()
         if (.not. is_set(values(v_tangential_force))) return
         if (abs(values(v_tangential_force)) > (1 + round_off)*results(r_friction_force)) then
            status = status_no_equilibrium
            results(:) = not_a_number()
            return
         end if
         if (.not. radius > 0) return
         call find_shear_slip(case%curve%shape, found%resistance, found%contact, abs(values(v_tangential_force)) &
            & /case%force_unit(), slip, is_converged)
         ratio = tangential_compliance(values, case)
         results(r_stick_fraction) = slip%ratio**2
         results(r_tangential_displacement) = sign(ratio*case%height_unit*slip%displacement, values(v_tangential_force))
         results(r_tangential_stiffness) = 2*slip%radius*case%length_unit*case%modulus/ratio
         results(r_cycle_energy) = ratio*slip%energy*case%force_unit()*case%height_unit
         if (is_converged) return
         status = status_not_converged
         results(:) = not_a_number()
      end associate
   end subroutine add_friction

   !> Round-off of what is held moves the contact along the curve, at the end of stability by the root of round-off; load and approach
   !> are differences. The largest relative error of radius, load and approach, the latter two against at least a tenth of pull-off.
   pure real(dp) function estimate_error(case, contact, ends) result(error)
      !> The point.
      type(indenter_case_t), intent(in) :: case
      !> Its contact.
      type(contact_t), intent(in) :: contact
      !> Where contacts end.
      type(ends_t), intent(in) :: ends
      real(dp), parameter :: round_off = 2*epsilon(1.0_dp), least_share = 0.1_dp
      real(dp) :: terms(2), best(2), sizes(2), shares(2), shift, slope
      integer :: k

      error = round_off
      associate (spot => contact%spot)
         terms = terms_of(contact)
         sizes = abs([contact%load, contact%approach])
         ! where no contact is stable there is no pull-off
         if (.not. ieee_is_nan(ends%pull_off_load)) then
            sizes = max(sizes, least_share*abs([ends%pull_off_load, ends%pull_off_approach]))
         end if
         best = terms
         if (case%control == control_spring) best = min(terms, [(abs(case%given) + terms(2))/case%curve%compliance, &
            & abs(case%given) + case%curve%compliance*terms(1)])
         do k = 1, 2
            if (sizes(k) > 0) error = max(error, 2*round_off*best(k)/sizes(k))
         end do
         if (case%control == control_radius .or. .not. contact%u > 0 .or. case%curve%shape%n_pieces == 0) return
         ! change of u that round-off of what is held makes
         shares = 0
         shares(merge(1, 2, case%control == control_load)) = 1
         if (case%control == control_spring) shares(1) = case%curve%compliance
         shift = sqrt(round_off)*contact%u
         slope = abs(sum(shares*contact%slopes))
         if (round_off*sum(shares*terms) < shift*slope) shift = round_off*sum(shares*terms)/slope
         error = error + shift*spot%radius_slope/spot%radius
         do k = 1, 2
            ! what is given has no such error
            if (sizes(k) > 0 .and. k /= case%control) error = error + shift*abs(contact%slopes(k))/sizes(k)
         end do
         ! no digits at all
         error = min(error, 1.0_dp)
      end associate
   end function estimate_error

   !> See `model_t`: the shear stress belongs to friction.
   pure integer function count_profiles(self, values)
      !> The model; nothing of it is read here.
      class(indenter_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      count_profiles = merge(p_shear_stress, p_gap, is_set(values(v_friction_coefficient)) .or. is_set(values(v_shear_strength)) &
         & .or. nint(values(v_law)) == law_peeling)
      associate (unused => self)
      end associate
   end function count_profiles

   !> See `pointwise_model_t`: pressure and gap, and with friction the shear stress.
   subroutine fill_profiles(self, values, results, state, axes, profiles)
      !> The model; nothing of it is read here.
      class(indenter_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the point, of which none is needed; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> The contact of the point.
      class(point_state_t), allocatable, intent(in) :: state
      !> The axis r.
      type(profile_axis_t), intent(in) :: axes(:)
      !> In: all NaN. Out: the profiles; shape `(n_r, 1, n_profiles)`.
      real(dp), intent(inout) :: profiles(:, :, :)
      real(dp) :: r
      integer :: k

      select type (state)
      type is (indenter_state_t)
         associate (case => state%case)
            do k = 1, size(profiles, 1)
               r = axes(1)%coordinates(k)/case%length_unit
               profiles(k, 1, p_pressure) = pressure_at(case%curve%shape, state%contact, r)*case%modulus &
                  & *(case%height_unit/case%length_unit)
               profiles(k, 1, p_gap) = gap_at(case%curve%shape, state%contact, r)*case%height_unit
               if (size(profiles, 3) == p_shear_stress) profiles(k, 1, p_shear_stress) = shear_at(state, values, r)
            end do
         end associate
      end select
      associate (unused => self, unused_too => values, unused_results => results)
      end associate
   end subroutine fill_profiles

   !> Shear traction at a distance from the axis [Pa].
   pure real(dp) function shear_at(state, values, r) result(traction)
      !> The point with its slip.
      type(indenter_state_t), intent(in) :: state
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Distance from the axis, reduced, >= 0.
      real(dp), intent(in) :: r

      associate (case => state%case)
         if (nint(values(v_law)) == law_peeling) then
            traction = bonded_stress(values(v_tangential_force), state%contact%spot%radius, r)/case%length_unit**2
            return
         end if
         if (is_set(values(v_shear_strength))) then
            traction = shear_stress_at(case%curve%shape, state%resistance, state%contact, state%shear, r)*case%modulus &
               & *(case%height_unit/case%length_unit)
            if (is_set(values(v_tangential_force))) traction = sign(traction, values(v_tangential_force))
            return
         end if
         traction = pressure_at(case%curve%shape, state%contact, r)
         if (state%slip%stick%load > 0) traction = traction - pressure_at(case%curve%shape, state%slip%stick, r)
         traction = sign(values(v_friction_coefficient), values(v_tangential_force))*traction*case%modulus &
            & *(case%height_unit/case%length_unit)
      end associate
   end function shear_at

   !> Shear stress of a force on a circle that sticks as a whole; none at its edge.
   pure real(dp) function bonded_stress(force, radius, r) result(stress)
      !> The force, which may not be given.
      real(dp), intent(in) :: force
      !> Radius of the circle, and distance from the axis.
      real(dp), intent(in) :: radius, r

      stress = 0
      if (.not. is_set(force) .or. r > radius) return
      stress = not_a_number()
      if (r < radius) stress = force/(2*pi*radius*sqrt((radius - r)*(radius + r)))
   end function bonded_stress

   !> See `model_t`.
   function derive_quantities(self, values) result(derived)
      !> The model, whose table of variables is read.
      class(indenter_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: derived(:)

      associate (first => v_contact_modulus, last => v_second_poisson_ratio)
         derived = derive_contact_modulus(self%variables(first:last), values(first:last))
      end associate
   end function derive_quantities

   !> See `model_t`: the coefficient of r^n has a unit that depends on n.
   function unit_of(self, values, place) result(unit)
      !> The model, whose table of variables is read.
      class(indenter_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Place of the variable in `variables`.
      integer, intent(in) :: place
      character(:), allocatable :: unit

      unit = self%variables(place)%unit
      if (place /= v_coefficient .or. .not. is_set(values(v_exponent))) return
      unit = 'm^(1-'//show_number(values(v_exponent))//')'
   end function unit_of

end module adfric_indenter_model
