! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `indenter`: an indenter of any axisymmetric shape on an elastic half-space, without adhesion or with it (JKR, Maugis-Dugdale).
!> The file is long by its answers to `pointwise_model_t`.
module adfric_round_model
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set, unset
   use adfric_round_case, only: indenter_case_t, resolve_case, is_possible
   use adfric_round_check, only: check_indenter_values
   use adfric_round_contact, only: branch_stable, find_contact, part_bodies
   use adfric_round_contact_state, only: contact_t
   use adfric_round_survey, only: ends_t, survey_t, survey_curve
   use adfric_round_contact_heat, only: find_contact_temperature, has_contact_heat
   use adfric_round_curve, only: stability_control
   use adfric_round_edge_slope, only: measure_edge
   use adfric_round_friction_point, only: add_friction, add_slip, round_friction_t, shear_at
   use adfric_round_law_model, only: law_model_t
   use adfric_round_loop, only: find_loop, loop_t
   use adfric_round_peeled_point, only: begin_sliding, peel_contact, peeled_t, store_driven, store_peeled
   use adfric_round_full_stick, only: store_full_stick
   use adfric_round_point_results, only: estimate_error, store_contact, store_ends, store_events, store_stress
   use adfric_round_pressure_law, only: add_pressure_part
   use adfric_round_profiles, only: pressure_at, gap_at
   use adfric_round_variables, only: get_indenter_profiles, get_indenter_results, get_indenter_variables, &
      & indenter_unit_of, law_peeling, n_indenter_results, n_indenter_variables, p_gap, p_pressure, p_shear_stress, radius_axis, &
      & state_sliding, state_static, theory_maugis_dugdale, in => indenter_input, out => indenter_output
   use adfric_round_velocity_law, only: check_velocity_law, is_in_motion, law_of_contact, take_strength
   use adfric_interface_friction_law, only: friction_law_t
   use adfric_interface_heat_rows, only: doubt_heat, h_contact, n_heat_results, velocity_that_heats
   use adfric_solid_contact_modulus, only: derive_contact_modulus
   use adfric_describe_derived, only: derived_t
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_status, only: status_solved, status_no_equilibrium, status_not_converged
   use adfric_describe_table, only: profile_axis_t
   implicit none (type, external)
   private
   public :: indenter_model_t, new_indenter_model

   !> The model; its tables stand in `adfric_round_variables`.
   type, extends(law_model_t) :: indenter_model_t
   contains
      procedure :: check_values
      procedure :: wants_profiles
      procedure :: get_profile_axes
      procedure :: solve_point
      procedure :: count_profiles
      procedure :: fill_profiles
      procedure :: derive_quantities
      procedure :: describe_doubts
      procedure :: velocity_of_heat
      procedure :: unit_of
      procedure :: measure
   end type indenter_model_t

   !> What a point leaves for its profiles.
   type, extends(point_state_t) :: indenter_state_t
      !> The point.
      type(indenter_case_t) :: case
      !> Its contact.
      type(contact_t) :: contact
      !> Its friction, where there is one.
      type(round_friction_t) :: friction
      !> The survey of its curve; it serves the next point, too, if that has the same curve and control.
      type(survey_t) :: survey
      !> Values of the variables up to the theory, the stiffness of the spring, and X in sliding, which the curve follows from where
      !> there is a range of adhesion.
      real(dp) :: values(in%theory + 2) = 0
      !> What happens in a cycle of approach and retraction.
      type(loop_t) :: loop
      !> Has a survey been made?
      logical :: is_surveyed = .false.
      !> What peeling has done; its events and its path on a driven spring serve the next point, too, if that has another force or
      !> displacement of the base alone.
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
      class(indenter_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout) :: problems

      real(dp) :: constant(n_indenter_variables), slope
      logical :: is_valid
      integer :: before

      before = problems%count()
      call check_velocity_law(self%variables, values, self%given_law, problems)
      if (problems%count() > before) return
      call take_strength(values, self%given_law, values(in%temperature), constant, slope, is_valid)
      call check_indenter_values(self%variables, constant, is_swept, problems)
   end subroutine check_values

   !> See `model_t`.
   pure logical function wants_profiles(self, values)
      class(indenter_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      wants_profiles = values(in%profiles) > 0
      associate (unused => self)
      end associate
   end function wants_profiles

   !> See `model_t`.
   subroutine get_profile_axes(self, values, axes)
      class(indenter_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(profile_axis_t), allocatable, intent(out) :: axes(:)

      axes = radius_axis(values(in%r_max), values(in%n_r), 'm')
      associate (unused => self)
      end associate
   end subroutine get_profile_axes

   !> See `model_t`.
   subroutine measure(self, values, results, measures)
      class(indenter_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:), results(:)
      real(dp), intent(inout) :: measures(:)

      if (is_set(values(in%contact_radius))) then
         call measure_edge(values, values(in%contact_radius), measures)
      else
         call measure_edge(values, results(out%contact_radius), measures)
      end if
      associate (unused => self)
      end associate
   end subroutine measure

   !> See `pointwise_model_t`: a law of the velocity is a shear strength at each point.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
      class(indenter_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Receives the contact, for the profiles.
      class(point_state_t), allocatable, intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Relative error of radius, load and approach, the largest of them, estimated.
      real(dp), intent(out) :: error_estimate
      !> One of `status_...`.
      integer, intent(out) :: status
      !> This model counts nothing; size 0.
      real(dp), intent(inout) :: counts(:)
      real(dp) :: constant(n_indenter_variables), slope
      logical :: is_valid

      associate (unused => counts)
      end associate
      if (.not. is_in_motion(values)) then
         call solve_contact(values, state, results, error_estimate, status)
         return
      end if
      error_estimate = 0
      status = status_not_converged
      call take_strength(values, self%given_law, values(in%temperature), constant, slope, is_valid)
      if (.not. is_valid) return
      call solve_contact(constant, state, results, error_estimate, status)
      if (status /= status_solved) return
      if (has_contact_heat(values)) call add_heat(self, values, state, results, error_estimate, status)
      if (status /= status_solved) return
      associate (force => results(out%friction_force))
         if (force > 0) slope = slope*constant(in%shear_strength)*results(out%friction_area)/force
         if (force > 0) call add_pressure(self, values, state, force, slope, is_valid)
         if (.not. is_valid) then
            status = status_not_converged
            results(:) = not_a_number()
            return
         end if
         ! where adhesion depends on the shear strength, the area does, too
         if (force > 0 .and. abs(values(in%velocity)) > 0 .and. .not. is_set(values(in%critical_slip)) .and. .not. &
            & has_contact_heat(values)) results(out%velocity_slope) = slope
         force = sign(force, values(in%velocity))
      end associate
   end subroutine solve_point

   !> Add what a law of the pressure makes of the friction; nothing for the other laws.
   subroutine add_pressure(self, values, state, force, slope, is_valid)
      class(indenter_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> The contact of the point.
      class(point_state_t), intent(in) :: state
      !> Friction [N] > 0, and d ln F/d ln v [-].
      real(dp), intent(inout) :: force, slope
      !> Was it found?
      logical, intent(out) :: is_valid
      type(friction_law_t) :: law

      is_valid = .true.
      call law_of_contact(values, self%given_law, law)
      if (.not. law%depends_on_pressure()) return
      select type (state)
      type is (indenter_state_t)
         call add_pressure_part(law, abs(values(in%velocity)), values(in%temperature), state%case, state%contact, force, slope, &
            & is_valid)
      end select
   end subroutine add_pressure

   !> Find the temperature of a contact, and solve it again with the shear strength there.
   subroutine add_heat(self, values, state, results, error_estimate, status)
      class(indenter_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> In: the contact at the given temperature. Out: that at its own.
      class(point_state_t), allocatable, intent(inout) :: state
      !> In: results at the given temperature. Out: those at its own, with heat, or all NaN; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Relative error of radius, load and approach, the largest of them, estimated.
      real(dp), intent(inout) :: error_estimate
      !> In: solved. Out: one of `status_...`.
      integer, intent(inout) :: status
      type(friction_law_t) :: law
      real(dp) :: constant(n_indenter_variables), slope, temperature, heat(n_heat_results)
      logical :: is_valid

      heat = not_a_number()
      call law_of_contact(values, self%given_law, law)
      call find_contact_temperature(values, law, results(out%friction_area), results(out%load), temperature, heat, is_valid)
      if (is_valid) call take_strength(values, self%given_law, temperature, constant, slope, is_valid)
      results(:) = not_a_number()
      if (is_valid) then
         call solve_contact(constant, state, results, error_estimate, status)
         if (status == status_solved) results(out%heat) = heat
      else
         status = status_not_converged
         error_estimate = 0
      end if
   end subroutine add_heat

   !> Solve a point of a constant shear strength.
   subroutine solve_contact(values, state, results, error_estimate, status)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the contact, for the profiles; nothing is taken from the point before.
      class(point_state_t), allocatable, intent(inout) :: state
      real(dp), intent(inout) :: results(:)
      !> Relative error of radius, load and approach, the largest of them, estimated.
      real(dp), intent(out) :: error_estimate
      integer, intent(out) :: status
      type(indenter_state_t), allocatable :: found
      type(ends_t) :: ends
      real(dp) :: moved(n_indenter_variables)
      logical :: is_stuck

      allocate (found)
      error_estimate = 0
      status = status_no_equilibrium
      call resolve_case(values, found%case)
      if (.not. is_possible(values, found%case)) return
      associate (case => found%case, contact => found%contact, peeled => found%peeled)
         call take_events(state, values, found)
         if (nint(values(in%state)) == state_sliding) call begin_sliding(values, case, peeled, results)
         found%values = [values(:in%theory), values(in%machine_stiffness), peeled%ratio]
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
         if (nint(values(in%state)) == state_static) call peel_contact(values, case, contact, peeled, ends, results)
         if (.not. contact%is_found .and. contact%is_converged .and. may_part(values)) &
            & call part_bodies(case%curve, case%control, case%given, contact)
         call store_ends(case, ends, results)
         if (.not. (contact%is_converged .and. ends%is_converged .and. found%survey%ends%is_converged &
            & .and. found%loop%is_converged .and. peeled%is_converged)) status = status_not_converged
         if (contact%is_found .and. status /= status_not_converged) then
            status = status_solved
            error_estimate = min(1.0_dp, estimate_error(case, contact, found%survey%ends) + peeled%error + peeled%spring_error)
            call store_contact(case, contact, values, results)
            if (is_set(values(in%position_z))) call store_stress(case, contact, values, results)
            if (peeled%driven%is_found) then
               moved = values
               moved(in%tangential_force) = peeled%driven%force*case%force_unit()
               call store_friction(moved, found, results, status)
               if (status == status_solved) call store_driven(moved, case, peeled, results)
            else
               call store_friction(values, found, results, status)
            end if
            if (peeled%is_peeling) results(out%cycle_energy) = not_a_number()
            call store_full_stick(case, values, results, is_stuck)
            if (.not. is_stuck) status = status_not_converged
         end if
      end associate
      call move_alloc(found, state)
   end subroutine solve_contact

   !> May the state be one of bodies apart, which bears no tangential force? The other branches are those of contacts.
   pure logical function may_part(values)
      real(dp), intent(in) :: values(:)

      may_part = nint(values(in%branch)) == branch_stable .and. .not. is_set(values(in%base_displacement))
      if (is_set(values(in%tangential_force))) may_part = may_part .and. .not. abs(values(in%tangential_force)) > 0
   end function may_part

   !> Add the results of friction.
   subroutine store_friction(values, found, results, status)
      !> Values of the variables, with the tangential force of the state; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> The point with its contact; receives its friction.
      type(indenter_state_t), intent(inout) :: found
      !> In: results of the contact. Out: with those of friction, or all NaN; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> In: solved. Out: one of `status_...`.
      integer, intent(inout) :: status

      associate (friction => found%friction)
         if (is_set(values(in%friction_coefficient))) call add_slip(values, found%case, found%survey, found%contact, &
            & friction%slip, &
            & results, status)
         if (is_set(values(in%shear_strength))) call add_friction(values, found%case, found%contact, friction%resistance, &
            & friction%shear, results, status)
         if (status == status_solved .and. (is_set(values(in%shear_strength)) .or. nint(values(in%law)) == law_peeling)) &
            & call store_peeled(values, found%case, found%peeled, results)
      end associate
   end subroutine store_friction

   !> Are the events of a cycle of approach and retraction asked for?
   pure logical function makes_cycle(values)
      real(dp), intent(in) :: values(:)

      makes_cycle = values(in%events) > 0 .and. any(is_set(values([in%approach, in%base_approach])))
   end function makes_cycle

   !> Take the survey of the point before over, if it is that of the same curve. Without a range of adhesion the units follow from what
   !> is prescribed, and a survey takes no time.
   subroutine take_survey(state, found)
      class(point_state_t), allocatable, intent(in) :: state
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

   !> Take the events of the point before over, and its path on a driven spring, if that differs in the tangential force or the
   !> displacement of the base alone.
   pure subroutine take_events(state, values, found)
      class(point_state_t), allocatable, intent(in) :: state
      real(dp), intent(in) :: values(:)
      type(indenter_state_t), intent(inout) :: found

      found%point = values
      found%point([in%tangential_force, in%base_displacement]) = 0
      if (.not. allocated(state)) return
      select type (state)
      type is (indenter_state_t)
         if (.not. (state%peeled%has_events .or. state%peeled%has_drive)) return
         if (any(abs(state%point - found%point) > 0)) return
         found%peeled%has_events = state%peeled%has_events
         if (state%peeled%has_events) found%peeled%events = state%peeled%events
         found%peeled%has_drive = state%peeled%has_drive
         if (state%peeled%has_drive) found%peeled%drive = state%peeled%drive
      end select
   end subroutine take_events

   !> See `model_t`: the shear stress belongs to friction.
   pure integer function count_profiles(self, values)
      class(indenter_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      count_profiles = merge(p_shear_stress, p_gap, is_set(values(in%friction_coefficient)) .or. is_set(values(in%shear_strength)) &
         & .or. nint(values(in%law)) == law_peeling .or. is_in_motion(values))
      associate (unused => self)
      end associate
   end function count_profiles

   !> See `pointwise_model_t`: pressure and gap, and with friction the shear stress.
   subroutine fill_profiles(self, values, results, state, axes, profiles)
      class(indenter_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Results of the point, of which the temperature of the contact is needed; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> The contact of the point.
      class(point_state_t), allocatable, intent(in) :: state
      !> The axis r.
      type(profile_axis_t), intent(in) :: axes(:)
      real(dp), intent(inout) :: profiles(:, :, :)
      real(dp) :: r, constant(n_indenter_variables), slope, temperature
      logical :: is_valid
      integer :: k

      temperature = values(in%temperature)
      if (has_contact_heat(values) .and. .not. ieee_is_nan(results(out%heat(h_contact)))) &
         & temperature = results(out%heat(h_contact))
      call take_strength(values, self%given_law, temperature, constant, slope, is_valid)
      if (.not. is_valid) return
      select type (state)
      type is (indenter_state_t)
         associate (case => state%case)
            do k = 1, size(profiles, 1)
               r = axes(1)%coordinates(k)/case%length_unit
               profiles(k, 1, p_pressure) = pressure_at(case%curve%shape, state%contact, r)*case%modulus &
                  & *(case%height_unit/case%length_unit)
               profiles(k, 1, p_gap) = gap_at(case%curve%shape, state%contact, r)*case%height_unit
               if (size(profiles, 3) == p_shear_stress) profiles(k, 1, p_shear_stress) = shear_at(case, state%contact, &
                  & state%friction, constant, r)
            end do
            if (size(profiles, 3) == p_shear_stress) call set_stress_of_pressure(self, values, temperature, &
               & profiles(:, 1, p_pressure), profiles(:, 1, p_shear_stress))
         end associate
      end select
      if (is_in_motion(values)) profiles(:, 1, p_shear_stress) = sign(1.0_dp, values(in%velocity))*profiles(:, 1, p_shear_stress)
   end subroutine fill_profiles

   !> Shear stress of a law of the pressure, where there is one and the surfaces press; nothing changes for the other laws.
   subroutine set_stress_of_pressure(self, values, temperature, pressure, stress)
      class(indenter_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Temperature of the contact [K].
      real(dp), intent(in) :: temperature
      !> Pressure [Pa]; shape `(n_r)`.
      real(dp), intent(in) :: pressure(:)
      !> In: stress without pressure. Out: that with it [Pa]; shape `(n_r)`.
      real(dp), intent(inout) :: stress(:)
      type(friction_law_t) :: law
      real(dp) :: slope
      logical :: is_valid
      integer :: k

      if (.not. is_in_motion(values)) return
      call law_of_contact(values, self%given_law, law)
      if (.not. law%depends_on_pressure()) return
      do k = 1, size(pressure)
         if (ieee_is_nan(pressure(k))) then
            stress(k) = not_a_number()
         else if (pressure(k) > 0 .and. stress(k) > 0) then
            call law%get_stress(abs(values(in%velocity)), pressure(k), temperature, stress(k), slope, is_valid)
         end if
      end do
   end subroutine set_stress_of_pressure

   !> See `model_t`.
   function derive_quantities(self, values) result(derived)
      class(indenter_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: derived(:)

      associate (first => in%contact_modulus, last => in%second_poisson_ratio)
         derived = derive_contact_modulus(self%variables(first:last), values(first:last))
      end associate
   end function derive_quantities

   !> See `model_t`: the velocity from which on heat matters.
   function describe_doubts(self, values) result(text)
      class(indenter_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text
      type(friction_law_t) :: law
      real(dp) :: radius

      text = ''
      if (.not. has_contact_heat(values)) return
      radius = friction_radius(self, values)
      if (.not. radius > 0) return
      call law_of_contact(values, self%given_law, law)
      call doubt_heat(values(in%heat), law, values(in%temperature), radius, text)
   end function describe_doubts

   !> See `model_t`.
   real(dp) function velocity_of_heat(self, values) result(velocity)
      class(indenter_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(friction_law_t) :: law

      velocity = unset
      if (.not. is_in_motion(values)) return
      call law_of_contact(values, self%given_law, law)
      velocity = velocity_that_heats(values(in%heat), law, values(in%temperature), friction_radius(self, values))
   end function velocity_of_heat

   !> Radius of the disc that rubs [m]; 0 where the point is not solved.
   real(dp) function friction_radius(self, values) result(radius)
      class(indenter_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      class(point_state_t), allocatable :: state
      real(dp) :: results(n_indenter_results), error_estimate, counts(0)
      integer :: status

      radius = 0
      results = not_a_number()
      call self%solve_point(values, state, results, error_estimate, status, counts)
      if (status /= status_solved) return
      if (results(out%friction_area) > 0) radius = sqrt(results(out%friction_area)/pi)
   end function friction_radius

   !> See `model_t`: the coefficient of r^n has a unit that depends on n.
   function unit_of(self, values, index) result(unit)
      class(indenter_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      integer, intent(in) :: index
      character(:), allocatable :: unit

      unit = indenter_unit_of(self%variables, values, index)
   end function unit_of

end module adfric_round_model
