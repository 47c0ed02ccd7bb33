! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `wave_1d`: a sinusoidal wave on an elastic half-plane (Westergaard), with or without adhesion, or sliding over a
!> viscoelastic one.
module adfric_classical_wave_model
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, two_pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_classical_adhesive_wave_point, only: adhesive_point_t, is_possible_adhesion, derive_adhesion, solve_adhesion, &
      & get_adhesive_profiles
   use adfric_classical_contact_conditions, only: largest_violation
   use adfric_classical_model, only: halfspace_model_t
   use adfric_classical_sliding_wave_point, only: slide_point_t, is_possible_slide, solve_slide, get_slide_profiles
   use adfric_classical_wave_slip_point, only: add_slip, slip_tractions
   use adfric_classical_wave_variables, only: get_wave_variables, get_wave_results, v_adhesion, v_amplitude, v_branch, &
      & v_contact_modulus, v_material, v_mean_pressure, v_penetration, v_period, v_poisson_ratio, &
      & v_second_poisson_ratio, v_temperature, &
      & v_coefficient, v_pressure_factor, v_shear_strength, v_tangential_stress, v_turning_pressure, v_velocity, &
      & r_friction_coefficient, r_friction_stress, &
      & r_adhesion_energy, r_adhesion_fraction, r_contact_fraction, r_contact_width, &
      & r_elastic_energy, r_full_contact_pressure, r_hysteresis_loss, r_largest_gap, r_mean_gap, r_mean_pressure, r_peak_pressure, &
      & r_penetration, r_regime, r_violation, regime_full, regime_none, regime_partial
   use adfric_classical_westergaard, only: wave_half_width, wave_pressure, wave_gap, wave_mean_gap, wave_penetration, &
      & wave_energy, find_wave_pressure
   use adfric_material_adhesion_rows, only: check_adhesion, has_adhesion
   use adfric_material_contact_modulus, only: contact_modulus_of, check_contact_modulus, derive_contact_modulus
   use adfric_material_coulomb_rows, only: check_coulomb, has_coulomb, n_coulomb_rows, needs_poisson_ratio
   use adfric_material_given_spectrum, only: given_spectrum_t
   use adfric_material_shear_strength_rows, only: check_shear, get_friction_of_area, has_shear, p_shear_stress, &
      & shear_profiles, shear_stress
   use adfric_material_spectrum_rows, only: check_spectrum, derive_spectrum, describe_spectrum, doubt_spectrum, has_spectrum, &
      & n_spectrum_rows, take_spectrum, take_spectrum_attribute
   use adfric_model_check, only: require, require_one
   use adfric_model_derived, only: derived_t
   use adfric_model_pointwise, only: point_state_t
   use adfric_model_status, only: status_solved, status_no_equilibrium, status_not_converged
   use adfric_model_table, only: profile_axis_t
   implicit none (type, external)
   private
   public :: wave_model_t, new_wave_model

   !> Places where the conditions of contact are checked, in the contact and beside it.
   integer, parameter :: n_places = 16

   !> The model `wave_1d`.
   type, extends(halfspace_model_t) :: wave_model_t
      private
      !> Lists and datasets of the material.
      type(given_spectrum_t) :: given
   contains
      procedure :: take_dataset
      procedure :: take_attribute
      procedure :: check_case
      procedure :: derive_quantities
      procedure :: describe_case
      procedure :: describe_doubts
      procedure :: solve_point
      procedure :: count_profiles
      procedure :: fill_profiles
   end type wave_model_t

contains

   !> The model with its tables.
   subroutine new_wave_model(self)
      !> The new model; receives its tables.
      type(wave_model_t), intent(out) :: self

      call self%set_tables(name='wave_1d', summary='a sinusoidal wave on an elastic half-plane, also with adhesion, or sliding ' &
         & //'over a viscoelastic one, up to full contact', &
         & variables=get_wave_variables(), results=get_wave_results(), profiles=shear_profiles(), axes='x', is_depth=.false.)
      self%references = self%references//'; Int. J. Solids Struct. 32 (1995); N. Menga, C. Putignano, G. Carbone, G. P. Demelio, ' &
         & //'Proc. R. Soc. A 470 (2014)'
   end subroutine new_wave_model

   !> Does the wave slide over a viscoelastic half-plane?
   pure logical function is_sliding(values)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      is_sliding = has_spectrum(values(v_material:v_temperature))
   end function is_sliding

   !> Does the wave adhere to an elastic half-plane?
   pure logical function is_adhesive(values)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      is_adhesive = has_adhesion(values(v_adhesion:v_turning_pressure)) .and. .not. is_sliding(values)
   end function is_adhesive

   !> See `model_t`.
   subroutine take_dataset(self, place, values, problems)
      !> The model, which keeps the values.
      class(wave_model_t), intent(inout) :: self
      !> Place of the variable, one of the rows of the material.
      integer, intent(in) :: place
      !> The values in SI units; shape `(n, n_columns)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives what is wrong with the values; nothing here.
      type(problems_t), intent(inout) :: problems

      call take_spectrum(self%given, place - v_material + 1, values)
      associate (unused => problems)
      end associate
   end subroutine take_dataset

   !> See `model_t`.
   subroutine take_attribute(self, place, name, value, problems)
      !> The model, which keeps the value.
      class(wave_model_t), intent(inout) :: self
      !> Place of the variable, one of the rows of the material.
      integer, intent(in) :: place
      !> Name of the attribute.
      character(*), intent(in) :: name
      !> Its value in SI units.
      real(dp), intent(in) :: value
      !> Receives what is wrong with it.
      type(problems_t), intent(inout) :: problems

      call take_spectrum_attribute(self%given, self%variables(place), place - v_material + 1, name, value, problems)
   end subroutine take_attribute

   !> See `halfspace_model_t`.
   subroutine check_case(self, values, problems)
      !> The model; its tables give the variables their names.
      class(wave_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: before

      before = problems%count()
      call require(self%variables, values, [v_period, v_amplitude], problems)
      if (is_sliding(values)) then
         call check_material(self, values, problems)
      else
         call check_solid(self, values, problems)
      end if
      call require_one(self%variables, values, [v_mean_pressure, v_penetration], .true., problems)
      if (problems%count() > before) return
      if (is_adhesive(values)) then
         if (.not. is_possible_adhesion(values)) call problems%add('adhesion', 'stress', &
            & 'or its range is too small or too large for the wave: stress/p* and range/amplitude are 1e-12 to 1e12')
      else if (.not. is_set(values(v_adhesion)) .and. values(v_mean_pressure) < 0) then
         call problems%add('operating', 'mean_pressure', 'is below 0, but nothing pulls without &adhesion')
      end if
      if (.not. is_sliding(values)) return
      if (.not. is_possible_slide(values, self%given)) call problems%add('operating', 'velocity', &
         & 'is too small or too large for the period and the relaxation times')
   end subroutine check_case

   !> Add to `problems` what is wrong with an elastic solid, over which no velocity counts.
   subroutine check_solid(self, values, problems)
      !> The model; its tables give the variables their names.
      class(wave_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      real(dp) :: friction(n_coulomb_rows)
      integer :: k

      friction = values(v_tangential_stress:v_coefficient)
      call check_contact_modulus(self%variables(v_contact_modulus:v_second_poisson_ratio), &
         & values(v_contact_modulus:v_second_poisson_ratio), problems, has_coulomb(friction))
      if (needs_poisson_ratio(friction, .true.) .and. is_set(values(v_contact_modulus)) &
         & .and. .not. is_set(values(v_poisson_ratio))) call problems%add('solid', 'poisson_ratio', &
         & 'is missing [-]; the displacement along y needs it')
      call check_coulomb(self%variables(v_tangential_stress:v_coefficient), friction, &
         & has_adhesion(values(v_adhesion:v_turning_pressure)), has_shear(values(v_shear_strength:v_pressure_factor)), problems)
      call check_adhesion(self%variables(v_adhesion:v_turning_pressure), values(v_adhesion:v_turning_pressure), problems)
      call check_shear(self%variables(v_shear_strength:v_pressure_factor), values(v_shear_strength:v_pressure_factor), &
         & merge(values(v_adhesion), 0.0_dp, is_adhesive(values)), problems)
      do k = v_temperature, v_velocity
         if (is_set(values(k))) call problems%add(self%variables(k)%group, self%variables(k)%name, &
            & 'has no meaning without &material; over an elastic solid nothing rubs')
      end do
   end subroutine check_solid

   !> Add to `problems` what is wrong with a viscoelastic material.
   subroutine check_material(self, values, problems)
      !> The model; its tables give the variables their names.
      class(wave_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      logical :: is_swept(n_spectrum_rows)
      integer :: k

      do k = v_contact_modulus, v_second_poisson_ratio
         if (is_set(values(k))) call problems%add(self%variables(k)%group, self%variables(k)%name, &
            & 'stands beside &material; give &solid for an elastic solid, &material for a viscoelastic one')
      end do
      ! what is swept has a value here, and is refused for that
      is_swept = .false.
      call check_spectrum(self%variables(v_material:v_temperature), values(v_material:v_temperature), self%given, is_swept, &
         & problems)
      call require(self%variables, values, [v_velocity], problems)
      do k = v_shear_strength, v_coefficient
         if (is_set(values(k))) call problems%add(self%variables(k)%group, self%variables(k)%name, &
            & 'stands beside &material; the friction of a viscoelastic solid is that of its losses')
      end do
      do k = v_adhesion, v_turning_pressure
         if (k == v_branch .or. .not. is_set(values(k))) cycle
         call problems%add(self%variables(k)%group, self%variables(k)%name, &
            & 'stands beside &material; a wave adheres to an elastic solid, &solid')
         exit
      end do
   end subroutine check_material

   !> See `model_t`.
   function derive_quantities(self, values) result(list)
      !> The model, for the rows of its moduli.
      class(wave_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: list(:)

      if (is_sliding(values)) then
         call derive_spectrum(list, values(v_material:v_temperature), self%given)
      else
         list = derive_contact_modulus(self%variables(v_contact_modulus:v_second_poisson_ratio), &
            & values(v_contact_modulus:v_second_poisson_ratio))
         if (is_adhesive(values)) call derive_adhesion(list, values)
      end if
   end function derive_quantities

   !> See `model_t`.
   function describe_case(self, values) result(text)
      !> The model with its lists and datasets.
      class(wave_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = ''
      if (is_sliding(values)) text = describe_spectrum(values(v_material:v_temperature), self%given)
   end function describe_case

   !> See `model_t`.
   function describe_doubts(self, values) result(text)
      !> The model with its lists and datasets.
      class(wave_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text
      real(dp) :: frequency

      text = ''
      if (.not. is_sliding(values)) return
      frequency = two_pi*abs(values(v_velocity))/values(v_period)
      text = doubt_spectrum(values(v_material:v_temperature), self%given, [frequency, frequency])
   end function describe_doubts

   !> Pressure p* of full contact.
   pure real(dp) function full_pressure(values)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      full_pressure = pi*contact_modulus_of(values(v_contact_modulus:v_second_poisson_ratio))*(values(v_amplitude)/values(v_period))
   end function full_pressure

   !> See `pointwise_model_t`.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
      !> The model with its lists and datasets.
      class(wave_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> A sliding wave leaves its contact and the spectrum, an adhesive one its events.
      class(point_state_t), allocatable, intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the main result [-].
      real(dp), intent(out) :: error_estimate
      !> Status of the point, one of `status_...`.
      integer, intent(out) :: status
      !> These models count nothing; size 0.
      real(dp), intent(inout) :: counts(:)
      logical :: is_held

      if (is_sliding(values)) then
         if (.not. allocated(state)) allocate (slide_point_t :: state)
         status = status_not_converged
         error_estimate = 0
         select type (state)
         type is (slide_point_t)
            call solve_slide(values, self%given, state, results, error_estimate, status)
         end select
      else if (is_adhesive(values)) then
         if (.not. allocated(state)) allocate (adhesive_point_t :: state)
         status = status_not_converged
         error_estimate = 0
         select type (state)
         type is (adhesive_point_t)
            call solve_adhesion(values, state, results, error_estimate, status)
         end select
      else
         call solve_elastic(values, results, error_estimate, status)
      end if
      if (status == status_solved .and. .not. is_sliding(values)) call store_friction(values, results)
      if (status == status_solved .and. has_coulomb(values(v_tangential_stress:v_coefficient))) then
         call add_slip(values, results, is_held)
         if (.not. is_held) status = status_no_equilibrium
         if (.not. is_held) results(:) = not_a_number()
      end if
      associate (unused => counts)
      end associate
   end subroutine solve_point

   !> Friction of a shear strength.
   pure subroutine store_friction(values, results)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> In: results of a solved point. Out: with friction; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      real(dp) :: tension

      tension = 0
      if (is_adhesive(values)) tension = values(v_adhesion)*results(r_adhesion_fraction)
      call get_friction_of_area(values(v_shear_strength:v_pressure_factor), results(r_contact_fraction), &
         & results(r_mean_pressure), tension, results(r_friction_stress), results(r_friction_coefficient))
   end subroutine store_friction

   !> A wave on an elastic half-plane. Beyond full contact the penetration is undefined.
   subroutine solve_elastic(values, results, error_estimate, status)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the main result [-].
      real(dp), intent(out) :: error_estimate
      !> Status of the point, one of `status_...`.
      integer, intent(out) :: status
      real(dp) :: q, p, d, half_width, x(n_places), lift
      integer :: i
      logical :: is_converged

      status = status_solved
      error_estimate = epsilon(error_estimate)
      p = full_pressure(values)
      d = values(v_amplitude)
      results(r_full_contact_pressure) = p
      lift = 0
      if (is_set(values(v_mean_pressure))) then
         if (values(v_mean_pressure) < 0) status = status_no_equilibrium
         if (status /= status_solved) return
         q = values(v_mean_pressure)/p
         results([r_mean_pressure, r_penetration]) = [values(v_mean_pressure), d*wave_penetration(q)]
      else
         if (values(v_penetration) > d) status = status_no_equilibrium
         if (status /= status_solved) return
         call find_wave_pressure(values(v_penetration)/d, q, is_converged)
         if (.not. is_converged) status = status_not_converged
         if (status /= status_solved) return
         results([r_mean_pressure, r_penetration]) = [q*p, values(v_penetration)]
         lift = max(0.0_dp, -values(v_penetration))
      end if
      half_width = wave_half_width(q)
      results(r_contact_fraction) = 2*half_width
      results(r_contact_width) = results(r_contact_fraction)*values(v_period)
      results(r_peak_pressure) = p*wave_pressure(q, 0.0_dp)
      results([r_mean_gap, r_largest_gap]) = d*[wave_mean_gap(q), wave_gap(q, 0.5_dp)] + lift
      results([r_adhesion_fraction, r_adhesion_energy, r_hysteresis_loss]) = 0
      results(r_elastic_energy) = p*d*wave_energy(q)
      results(r_regime) = regime_partial
      if (.not. q > 0) results(r_regime) = regime_none
      if (q >= 1) results(r_regime) = regime_full
      x = [((i - 0.5_dp)/n_places, i=1, n_places)]
      associate (places => [half_width*x, half_width + (0.5_dp - half_width)*x])
         results(r_violation) = largest_violation(wave_pressure(q, places), wave_gap(q, places), 1.0_dp, 1.0_dp)
      end associate
   end subroutine solve_elastic

   !> See `model_t`: the shear stress belongs to friction.
   pure integer function count_profiles(self, values)
      !> The model; nothing is read from it here.
      class(wave_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      count_profiles = p_shear_stress - 1
      if (has_shear(values(v_shear_strength:v_pressure_factor)) .or. has_coulomb(values(v_tangential_stress:v_coefficient))) &
         & count_profiles = p_shear_stress
      associate (unused => self)
      end associate
   end function count_profiles

   !> See `pointwise_model_t`: pressure and gap, and with friction the shear stress.
   subroutine fill_profiles(self, values, results, state, axes, profiles)
      !> The model; nothing is read from it here.
      class(wave_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> What `solve_block` found for this point; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> What `solve_point` has left: the contact of a sliding or of an adhesive wave.
      class(point_state_t), allocatable, intent(in) :: state
      !> Axes of the profiles, the slowest first.
      type(profile_axis_t), intent(in) :: axes(:)
      !> In: all NaN. Out: profiles of the point; shape `(n_fast, n_slow, n_profiles)`.
      real(dp), intent(inout) :: profiles(:, :, :)

      call fill_pressure_and_gap(values, results, state, axes, profiles)
      if (size(profiles, 3) < p_shear_stress) return
      if (has_coulomb(values(v_tangential_stress:v_coefficient))) then
         profiles(:, 1, p_shear_stress) = slip_tractions(values, results, axes(1)%coordinates)
      else
         profiles(:, 1, p_shear_stress) = shear_stress(values(v_shear_strength:v_pressure_factor), profiles(:, 1, 1), &
            & results(r_contact_width) > 0 .and. .not. profiles(:, 1, 2) > 0)
      end if
      associate (unused => self)
      end associate
   end subroutine fill_profiles

   !> Pressure and gap.
   subroutine fill_pressure_and_gap(values, results, state, axes, profiles)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> What `solve_block` found for this point; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> What `solve_point` has left: the contact of a sliding or of an adhesive wave.
      class(point_state_t), allocatable, intent(in) :: state
      !> Axes of the profiles, the slowest first.
      type(profile_axis_t), intent(in) :: axes(:)
      !> In: all NaN. Out: with pressure and gap; shape `(n_fast, n_slow, n_profiles)`.
      real(dp), intent(inout) :: profiles(:, :, :)
      real(dp) :: q, p, lift

      if (is_sliding(values)) then
         select type (state)
         type is (slide_point_t)
            call get_slide_profiles(state, axes(1)%coordinates, profiles(:, 1, 1), profiles(:, 1, 2))
         end select
         return
      end if
      if (is_adhesive(values)) then
         select type (state)
         type is (adhesive_point_t)
            call get_adhesive_profiles(state, axes(1)%coordinates, profiles(:, 1, 1), profiles(:, 1, 2))
         end select
         return
      end if
      lift = 0
      if (is_set(values(v_penetration))) then
         if (values(v_penetration) > values(v_amplitude)) return
         lift = max(0.0_dp, -values(v_penetration))
      end if
      p = full_pressure(values)
      q = results(r_mean_pressure)/p
      profiles(:, 1, 1) = p*wave_pressure(q, axes(1)%coordinates/values(v_period))
      profiles(:, 1, 2) = values(v_amplitude)*wave_gap(q, axes(1)%coordinates/values(v_period)) + lift
   end subroutine fill_pressure_and_gap

end module adfric_classical_wave_model
