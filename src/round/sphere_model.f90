! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `sphere`: a smooth sphere on a plane, its adhesion and its friction (Johnson 1997).
module adfric_round_sphere_model
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_solid_contact_modulus, only: derive_contact_modulus, modulus_names
   use adfric_describe_derived, only: derived_t, add_derived
   use adfric_describe_pointwise, only: pointwise_model_t, point_state_t
   use adfric_describe_check, only: refuse_swept
   use adfric_describe_doubt, only: doubt_contact_too_wide
   use adfric_describe_status, only: status_solved
   use adfric_describe_rows, only: count_row
   use adfric_describe_table, only: result_t, profile_t, profile_axis_t, take_units
   use adfric_interface_conduction_rows, only: conductances, n_conduction_results, n_conduction_rows
   use adfric_round_interaction_events, only: results_of_events
   use adfric_round_sphere_case, only: sphere_case_t, resolve_case
   use adfric_round_sphere_check, only: check_sphere_values
   use adfric_round_sphere_contact, only: sphere_contact_t, theory_maugis_dugdale, theory_dmt
   use adfric_round_sphere_point, only: sphere_point_t, sphere_memory_t, solve_point
   use adfric_round_sphere_profiles, only: contact_profile_t, new_profile
   use adfric_round_slip_annulus, only: shear_traction
   use adfric_round_sphere_shear_slip, only: shear_stress_of
   use adfric_round_variables, only: radius_axis
   use adfric_round_sphere_variables, only: get_sphere_profiles, get_sphere_results, get_sphere_variables, &
      & units_reduced, in => sphere_input, out => sphere_output
   implicit none (type, external)
   private
   public :: sphere_model_t, new_sphere_model

   !> The model; its tables stand in `adfric_round_sphere_variables`.
   type, extends(pointwise_model_t) :: sphere_model_t
   contains
      procedure :: check_values
      procedure :: describe_results
      procedure :: describe_profiles
      procedure :: wants_profiles
      procedure :: get_profile_axes
      procedure :: solve_point => solve_sphere_point
      procedure :: fill_profiles
      procedure :: derive_quantities
      procedure :: unit_of
      procedure :: measure
   end type sphere_model_t

   !> What a point leaves to the next one.
   type, extends(point_state_t) :: sphere_state_t
      !> Theory, contact, pull-off load and events of the point.
      type(sphere_memory_t) :: memory
   end type sphere_state_t

contains

   !> The model with its tables.
   subroutine new_sphere_model(self)
      !> Receives its names and its tables.
      type(sphere_model_t), intent(out) :: self

      self%name = 'sphere'
      self%summary = 'a smooth sphere on a plane: adhesion, static friction, sliding, and what friction does to adhesion'
      self%references = 'K. L. Johnson, Proc. R. Soc. Lond. A 453 (1997) 163; D. Maugis, J. Colloid Interface Sci. 150 (1992) 243'
      self%variables = get_sphere_variables()
      self%results = get_sphere_results(.false.)
      self%profiles = get_sphere_profiles(.false.)
      self%profile_axes = 'r'
      allocate (self%counts(1))
      self%counts(1) = count_row(name='share_of_limit_theories', long_name='points that a limit theory solves')
   end subroutine new_sphere_model

   !> See `model_t`.
   subroutine check_values(self, values, is_swept, problems)
      class(sphere_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout) :: problems

      call check_sphere_values(self%variables, values, problems)
      if (self%wants_profiles(values)) call refuse_swept(self%variables, is_swept, [in%r_max, in%n_r], problems)
   end subroutine check_values

   !> See `model_t`.
   function describe_results(self, values) result(results)
      class(sphere_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(result_t), allocatable :: results(:)

      results = self%results
      if (is_reduced(values)) call take_units(get_sphere_results(.true.), results)
   end function describe_results

   !> See `model_t`.
   function describe_profiles(self, values) result(profiles)
      class(sphere_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(profile_t), allocatable :: profiles(:)

      profiles = self%profiles
      if (is_reduced(values)) profiles = get_sphere_profiles(.true.)
   end function describe_profiles

   !> See `model_t`.
   function unit_of(self, values, index) result(unit)
      class(sphere_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      integer, intent(in) :: index
      character(:), allocatable :: unit

      unit = self%variables(index)%unit
      if (is_reduced(values) .and. len(unit) > 0) unit = '-'
   end function unit_of

   !> Are all quantities reduced?
   pure logical function is_reduced(values)
      real(dp), intent(in) :: values(:)

      is_reduced = nint(values(in%units)) == units_reduced
   end function is_reduced

   !> See `model_t`.
   pure logical function wants_profiles(self, values)
      class(sphere_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      wants_profiles = values(in%profiles) > 0
      associate (unused => self)
      end associate
   end function wants_profiles

   !> See `model_t`.
   subroutine get_profile_axes(self, values, axes)
      class(sphere_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(profile_axis_t), allocatable, intent(out) :: axes(:)

      axes = radius_axis(values(in%r_max), values(in%n_r), merge('-', 'm', is_reduced(values)))
      associate (unused => self)
      end associate
   end subroutine get_profile_axes

   !> See `model_t`: a paraboloid stands for the sphere. Reduced units have no radius of the sphere.
   subroutine measure(self, values, results, measures)
      class(sphere_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:), results(:)
      real(dp), intent(inout) :: measures(:)

      if (is_reduced(values)) return
      measures(doubt_contact_too_wide) = results(out%contact_radius)/values(in%radius)
      if (is_set(values(in%contact_radius))) measures(doubt_contact_too_wide) = values(in%contact_radius)/values(in%radius)
      associate (unused => self)
      end associate
   end subroutine measure

   !> See `pointwise_model_t`.
   subroutine solve_sphere_point(self, values, state, results, error_estimate, status, counts)
      class(sphere_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Theory and contact of the point before; receives those of this point.
      class(point_state_t), allocatable, intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Relative error of the main result, estimated.
      real(dp), intent(out) :: error_estimate
      !> One of `status_...`.
      integer, intent(out) :: status
      !> One number, which rises by 1 if a limit theory has solved the point.
      real(dp), intent(inout) :: counts(:)
      type(sphere_case_t) :: case
      type(sphere_point_t) :: point

      if (.not. allocated(state)) allocate (sphere_state_t :: state)
      select type (state)
      type is (sphere_state_t)
         call resolve_case(values, case)
         call solve_point(case, values(in%events) > 0, state%memory, point)
         status = point%status
         error_estimate = point%error_estimate
         call store(case, point, values, results)
         if (point%theory < theory_maugis_dugdale) counts(1) = counts(1) + 1
      end select
      associate (unused => self)
      end associate
   end subroutine solve_sphere_point

   !> Results of a point in the units of the case.
   pure subroutine store(case, point, values, results)
      type(sphere_case_t), intent(in) :: case
      type(sphere_point_t), intent(in) :: point
      real(dp), intent(in) :: values(:)
      !> Receives the results of the point in the units of the case; shape `(n_results)`; NaN where there is no value.
      real(dp), intent(out) :: results(:)
      real(dp) :: area_unit

      area_unit = case%length_unit**2
      results = not_a_number()
      ! these say why there is no state
      results(out%pull_off_load) = point%pull_off_load*case%force_unit
      results(out%peak_force:out%period_work) = results_of_events(point%events, case%force_unit, case%approach_unit, &
         & case%force_unit/case%approach_unit)
      if (point%status /= status_solved) return
      associate (contact => point%contact)
         results(out%load) = contact%load*case%force_unit
         results(out%approach) = contact%approach*case%approach_unit
         results(out%contact_radius) = contact%radius*case%length_unit
         results(out%contact_area) = pi*contact%radius**2*area_unit
         ! what was given comes back to the last digit
         if (is_set(values(in%load))) results(out%load) = values(in%load)
         if (is_set(values(in%approach))) results(out%approach) = values(in%approach)
         if (is_set(values(in%contact_radius))) results(out%contact_radius) = values(in%contact_radius)
         if (point%theory /= theory_dmt) results(out%adhesion_radius) = contact%adhesion_radius*case%length_unit
         results(out%stable) = merge(1, 0, contact%is_stable)
         if (has_stiffness(case, point)) results(out%contact_stiffness) = &
            & stiffness_of(contact)*(case%force_unit/case%approach_unit)
         call conductances(values(in%conduction(1):in%conduction(n_conduction_rows)), 2*results(out%contact_radius), &
            & results(out%conductances(1):out%conductances(n_conduction_results)))
      end associate
      results(out%friction_radius) = point%friction_radius*case%length_unit
      results(out%adhesion_ratio) = point%ratio
      results(out%theory_used) = point%theory
      results(out%theory_error) = point%theory_error
      if (.not. case%has_friction) return
      results(out%friction_area) = pi*point%friction_radius**2*area_unit
      results(out%friction_force) = point%friction_force*case%force_unit
      results(out%stick_radius) = point%gamma*point%friction_radius*case%length_unit
      results(out%slip) = point%slip*case%approach_unit
      results(out%largest_slip) = point%largest_slip*case%approach_unit
      results(out%tangential_displacement) = point%displacement*case%approach_unit
      if (is_set(values(in%tangential_force))) results(out%friction_force) = values(in%tangential_force)
      if (is_set(values(in%tangential_displacement))) results(out%tangential_displacement) = values(in%tangential_displacement)
   end subroutine store

   !> Is the change of load with approach known? Friction changes adhesion with it, and an attraction without touch has another
   !> slope.
   pure logical function has_stiffness(case, point)
      type(sphere_case_t), intent(in) :: case
      type(sphere_point_t), intent(in) :: point

      has_stiffness = .not. case%has_friction .and. point%theory /= theory_maugis_dugdale
      if (has_stiffness) has_stiffness = point%contact%radius > 0 .or. .not. abs(point%contact%load) > 0
   end function has_stiffness

   !> Change of load with approach, reduced: 0 of bodies that are apart, and none where the approach turns.
   pure real(dp) function stiffness_of(contact) result(stiffness)
      type(sphere_contact_t), intent(in) :: contact

      stiffness = 0
      if (abs(contact%approach_slope) > 0) then
         stiffness = contact%load_slope/contact%approach_slope
      else if (abs(contact%load_slope) > 0) then
         stiffness = not_a_number()
      end if
   end function stiffness_of

   !> See `pointwise_model_t`: pressure, shear stress and gap. The point is solved once more, by the theory that was used and
   !> without the point before it, which would change round-off; beside the samples of a profile that takes no time.
   subroutine fill_profiles(self, values, results, state, axes, profiles)
      class(sphere_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Results of the point, of which the theory is read; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> What the point has left, not used here.
      class(point_state_t), allocatable, intent(in) :: state
      !> The axis r.
      type(profile_axis_t), intent(in) :: axes(:)
      !> In: all NaN. Out: the profiles; there is no shear stress without friction. Shape `(n_r, 1, 3)`.
      real(dp), intent(inout) :: profiles(:, :, :)
      type(sphere_case_t) :: case
      type(sphere_point_t) :: point
      type(sphere_memory_t) :: memory
      type(contact_profile_t) :: profile
      real(dp) :: r(size(profiles, 1))

      call resolve_case(values, case)
      case%theory = nint(results(out%theory_used))
      call solve_point(case, .false., memory, point)
      call new_profile(profile, memory%theory, point%contact)
      r = axes(1)%coordinates/case%length_unit
      profiles(:, 1, 1) = profile%pressure(r)*case%stress_unit
      if (case%pressure_factor > 0 .and. point%friction_radius > 0) then
         profiles(:, 1, 2) = shear_stress_of(point%sheared, point%gamma, r, profile%pressure(r))*case%stress_unit
      else if (case%has_friction) then
         profiles(:, 1, 2) = case%strength*case%stress_unit*shear_traction(r, point%friction_radius, point%gamma)
      end if
      profiles(:, 1, 3) = profile%gap(r)*case%approach_unit
      associate (unused => self, unused_state => state)
      end associate
   end subroutine fill_profiles

   !> See `model_t`.
   function derive_quantities(self, values) result(derived)
      class(sphere_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: derived(:)
      character(*), parameter :: of_units = 'units radius work_of_adhesion theory '//modulus_names
      character(*), parameter :: of_lambda = of_units//' adhesion_stress adhesion_range lambda'
      type(sphere_case_t) :: case
      logical :: has_range

      associate (first => in%contact_modulus, last => in%second_poisson_ratio)
         derived = derive_contact_modulus(self%variables(first:last), values(first:last))
      end associate
      call resolve_case(values, case)
      ! without a range the units take lambda for 1, which a scene does not say
      has_range = any(is_set(values([in%adhesion_stress, in%adhesion_range, in%lambda])))
      if (has_range .or. .not. allocated(self%scene)) call add_derived(derived, 'lambda', '-', 'Maugis''s parameter lambda', &
         & case%lambda, of_lambda)
      if (.not. is_reduced(values)) then
         call add_derived(derived, 'radius_unit', 'm', 'unit of radii', case%length_unit, of_units)
         call add_derived(derived, 'approach_unit', 'm', 'unit of the approach', case%approach_unit, of_units)
         call add_derived(derived, 'force_unit', 'N', 'unit of forces', case%force_unit, of_units)
         call add_derived(derived, 'stress_unit', 'Pa', 'unit of stresses', case%stress_unit, of_units)
      end if
      if (case%has_friction) call add_derived(derived, 'reduced_shear_strength', '-', 'shear strength in the scale of lambda', &
         & case%strength, of_units//' shear_strength')
      if (case%slip_energy_ratio < huge(1.0_dp)) call add_derived(derived, 'slip_energy_ratio', '-', &
         & 'slip energy ratio g0', case%slip_energy_ratio, of_units//' shear_strength critical_slip slip_energy_ratio')
   end function derive_quantities

end module adfric_round_sphere_model
