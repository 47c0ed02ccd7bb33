! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `wave_1d`: a sinusoidal wave on an elastic half-plane (Westergaard), with or without adhesion, or sliding over a
!> viscoelastic one, with a law of the interface.
module adfric_plane_wave_model
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, two_pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set, unset
   use adfric_plane_adhesive_sliding_point, only: adhesive_slide_point_t, derive_adhesive_slide, solve_adhesive_slide, &
      & get_adhesive_slide_profiles
   use adfric_plane_adhesive_wave_point, only: adhesive_point_t, derive_adhesion, solve_adhesion, get_adhesive_profiles
   use adfric_plane_coupled_wave_point, only: coupled_point_t, get_coupled_profiles, solve_coupled_point
   use adfric_plane_elastic_wave_point, only: solve_elastic_wave, get_elastic_wave_profiles, &
      & store_wave_conductances
   use adfric_plane_sliding_wave_point, only: slide_point_t, solve_slide, get_slide_profiles
   use adfric_plane_viscoelastic_model, only: viscoelastic_model_t
   use adfric_plane_wave_check, only: check_wave, is_adhesive, is_adhesive_slide, is_sliding
   use adfric_plane_wave_interface, only: add_elastic_interface, add_left_out, add_slide_interface, interface_of, &
      & wave_tractions
   use adfric_plane_wave_slip_point, only: add_slip, slip_tractions
   use adfric_plane_wave_variables, only: get_wave_variables, get_wave_results, in => wave_input, out => wave_output
   use adfric_solid_contact_modulus, only: derive_contact_modulus
   use adfric_interface_coulomb_rows, only: has_coulomb
   use adfric_interface_friction_law, only: friction_law_t
   use adfric_interface_friction_law_rows, only: get_friction_law, has_interface, has_law_of_speed
   use adfric_interface_heat_rows, only: n_heat_rows, velocity_that_heats
   use adfric_interface_shear_coupling, only: doubt_left_out, is_coupled
   use adfric_interface_shear_strength_rows, only: get_friction_of_area, has_shear, p_shear_stress, shear_profiles, shear_stress
   use adfric_solid_spectrum_rows, only: derive_spectrum, describe_spectrum, doubt_spectrum, solid_shift_of
   use adfric_describe_derived, only: derived_t
   use adfric_describe_doubt, only: doubt_slope_too_steep
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_status, only: status_solved, status_no_equilibrium, status_not_converged
   use adfric_describe_table, only: profile_axis_t
   implicit none (type, external)
   private
   public :: wave_model_t, new_wave_model

   !> The model `wave_1d`.
   type, extends(viscoelastic_model_t) :: wave_model_t
   contains
      procedure :: check_case
      procedure :: derive_quantities
      procedure :: describe_case
      procedure :: describe_doubts
      procedure :: velocity_of_heat
      procedure :: solve_point
      procedure :: count_profiles
      procedure :: fill_profiles
      procedure :: measure
   end type wave_model_t

contains

   !> The model with its tables.
   subroutine new_wave_model(self)
      !> The new model; receives its tables.
      type(wave_model_t), intent(out) :: self

      call self%set_tables(name='wave_1d', summary='a sinusoidal wave on an elastic half-plane, also with adhesion, or sliding ' &
         & //'over a viscoelastic one, up to full contact', &
         & variables=get_wave_variables(), results=get_wave_results(), profiles=shear_profiles(), axes='x', is_depth=.false.)
      self%first_material = in%material(1)
      self%first_law = in%law(1)
      self%references = self%references//'; Int. J. Solids Struct. 32 (1995); N. Menga, C. Putignano, G. Carbone, G. P. Demelio, ' &
         & //'Proc. R. Soc. A 470 (2014)'
   end subroutine new_wave_model

   !> See `halfspace_model_t`.
   subroutine check_case(self, values, problems)
      class(wave_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call check_wave(self%variables, values, self%given, self%given_law, problems)
   end subroutine check_case

   !> See `model_t`.
   function derive_quantities(self, values) result(list)
      class(wave_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: list(:)

      if (is_sliding(values)) then
         call derive_spectrum(list, values(in%material(1):in%temperature), self%given)
         if (is_adhesive_slide(values)) call derive_adhesive_slide(list, values, self%given)
      else
         list = derive_contact_modulus(self%variables(in%contact_modulus:in%second_poisson_ratio), &
            & values(in%contact_modulus:in%second_poisson_ratio))
         if (is_adhesive(values)) call derive_adhesion(list, values)
      end if
   end function derive_quantities

   !> See `model_t`.
   function describe_case(self, values) result(text)
      class(wave_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = ''
      if (is_sliding(values)) text = describe_spectrum(values(in%material(1):in%temperature), self%given)
   end function describe_case

   !> See `model_t`.
   function describe_doubts(self, values) result(text)
      class(wave_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text
      class(point_state_t), allocatable :: state
      real(dp) :: frequency, results(size(self%results)), counts(0), error_estimate
      integer :: status

      text = ''
      if (is_sliding(values)) then
         frequency = two_pi*abs(values(in%velocity))/values(in%period)
         text = doubt_spectrum(values(in%material(1):in%temperature), self%given, [frequency, frequency])
      end if
      if (.not. has_interface(interface_of(values)) .or. is_coupled(values(in%coupling))) return
      results = not_a_number()
      call self%solve_point(values, state, results, error_estimate, status, counts)
      if (status == status_solved) text = text//doubt_left_out(results(out%coupling_left_out), error_estimate, .true.)
   end function describe_doubts

   !> See `model_t`: in contacts of half of the period.
   real(dp) function velocity_of_heat(self, values) result(velocity)
      class(wave_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(friction_law_t) :: law
      real(dp) :: isothermal(n_heat_rows)

      velocity = unset
      if (.not. (is_sliding(values) .and. has_interface(interface_of(values)))) return
      call get_friction_law(interface_of(values), self%given_law, solid_shift_of(values(in%material(1):in%temperature), &
         & self%given), law)
      isothermal = unset
      velocity = velocity_that_heats(isothermal, law, values(in%temperature), values(in%period)/4)
   end function velocity_of_heat

   !> See `model_t`: the steepest slope of the wave.
   subroutine measure(self, values, results, measures)
      class(wave_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the point, NaN where they are not known; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> In: all `not_measured`. Out: with what is measured; shape `(n_doubts)`.
      real(dp), intent(inout) :: measures(:)

      measures(doubt_slope_too_steep) = two_pi*values(in%amplitude)/values(in%period)
      associate (unused => self, unused_results => results)
      end associate
   end subroutine measure

   !> See `pointwise_model_t`.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
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
      logical :: is_sustained, is_valid

      if (is_adhesive_slide(values)) then
         if (.not. allocated(state)) allocate (adhesive_slide_point_t :: state)
         status = status_not_converged
         error_estimate = 0
         select type (state)
         type is (adhesive_slide_point_t)
            call solve_adhesive_slide(values, self%given, state, results, error_estimate, status)
         end select
      else if (is_sliding(values)) then
         if (.not. allocated(state)) allocate (slide_point_t :: state)
         status = status_not_converged
         error_estimate = 0
         select type (state)
         type is (slide_point_t)
            call solve_slide(values, self%given, state, results, error_estimate, status)
            if (status == status_solved .and. has_interface(interface_of(values))) then
               call add_slide_interface(values, self%given, self%given_law, state, results, is_valid)
               if (.not. is_valid) status = status_not_converged
            end if
         end select
      else if (is_adhesive(values)) then
         if (.not. allocated(state)) allocate (adhesive_point_t :: state)
         status = status_not_converged
         error_estimate = 0
         select type (state)
         type is (adhesive_point_t)
            call solve_adhesion(values, state, results, error_estimate, status)
         end select
         if (status == status_solved) call store_wave_conductances(values, sin(pi*results(out%contact_fraction)/2)**2, results)
      else if (is_coupled(values(in%coupling))) then
         if (.not. allocated(state)) allocate (coupled_point_t :: state)
         status = status_not_converged
         error_estimate = 0
         select type (state)
         type is (coupled_point_t)
            call solve_coupled_point(values, self%given_law, state, results, error_estimate, status)
         end select
      else
         call solve_elastic_wave(values, results, error_estimate, status)
      end if
      if (status == status_solved .and. .not. (is_sliding(values) .or. is_coupled(values(in%coupling)))) &
         & call store_friction(self, values, results, status)
      if (status == status_solved .and. has_interface(interface_of(values)) .and. .not. (is_sliding(values) .or. &
         & is_coupled(values(in%coupling)))) call store_left_out(self, values, state, results)
      if (status == status_solved .and. has_coulomb(values(in%tangential_stress:in%coefficient))) then
         call add_slip(values, results, is_sustained)
         if (.not. is_sustained) status = status_no_equilibrium
         if (.not. is_sustained) results(:) = not_a_number()
      end if
      associate (unused => counts)
      end associate
   end subroutine solve_point

   !> What a wave on an elastic half-plane leaves out by a contact of frictionless faces.
   pure subroutine store_left_out(self, values, state, results)
      type(wave_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> The state of an adhesive wave; else not allocated.
      class(point_state_t), allocatable, intent(in) :: state
      !> In: with the friction. Out: with what is left out; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)

      if (.not. is_adhesive(values)) then
         call add_left_out(values, self%given_law, results)
         return
      end if
      select type (state)
      type is (adhesive_point_t)
         call add_left_out(values, self%given_law, results, state)
      end select
   end subroutine store_left_out

   !> Friction of the interface with an elastic half-plane.
   pure subroutine store_friction(self, values, results, status)
      type(wave_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> In: results of a solved point. Out: with friction; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> In: solved. Out: not converged where a law of the velocity does not hold.
      integer, intent(inout) :: status
      real(dp) :: tension
      logical :: is_valid

      tension = 0
      if (is_adhesive(values)) tension = values(in%adhesion)*results(out%adhesion_fraction)
      if (has_law_of_speed(interface_of(values))) then
         call add_elastic_interface(values, self%given_law, tension, results, is_valid)
         if (.not. is_valid) status = status_not_converged
         return
      end if
      call get_friction_of_area(values(in%shear_strength:in%pressure_factor), results(out%contact_fraction), &
         & results(out%mean_pressure), tension, results(out%friction_stress), results(out%friction_coefficient))
      if (.not. has_shear(values(in%shear_strength:in%pressure_factor))) return
      if (is_set(values(in%coupling))) results(out%hysteretic_friction_stress) = 0
      results([out%interfacial_friction_stress, out%velocity_slope]) = [results(out%friction_stress), 0.0_dp]
      if (results(out%friction_stress) > 0) results(out%interfacial_share) = 1
   end subroutine store_friction

   !> See `model_t`: the shear stress belongs to friction.
   pure integer function count_profiles(self, values)
      class(wave_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      count_profiles = p_shear_stress - 1
      if (has_interface(interface_of(values)) .or. has_coulomb(values(in%tangential_stress:in%coefficient))) &
         & count_profiles = p_shear_stress
      associate (unused => self)
      end associate
   end function count_profiles

   !> See `pointwise_model_t`: pressure and gap, and with friction the shear stress.
   subroutine fill_profiles(self, values, results, state, axes, profiles)
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
      if (has_coulomb(values(in%tangential_stress:in%coefficient))) then
         profiles(:, 1, p_shear_stress) = slip_tractions(values, results, axes(1)%coordinates)
      else if (is_sliding(values) .or. has_law_of_speed(interface_of(values)) .or. is_coupled(values(in%coupling))) then
         profiles(:, 1, p_shear_stress) = wave_tractions(values, self%given, self%given_law, profiles(:, 1, 1), &
            & results(out%contact_width) > 0 .and. .not. profiles(:, 1, 2) > 0)
      else
         profiles(:, :, p_shear_stress) = shear_stress(values(in%shear_strength:in%pressure_factor), profiles(:, :, 1), &
            & results(out%contact_width) > 0 .and. .not. profiles(:, :, 2) > 0)
      end if
   end subroutine fill_profiles

   !> Pressure and gap.
   subroutine fill_pressure_and_gap(values, results, state, axes, profiles)
      real(dp), intent(in) :: values(:)
      !> What `solve_block` found for this point; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> What `solve_point` has left: the contact of a sliding or of an adhesive wave.
      class(point_state_t), allocatable, intent(in) :: state
      type(profile_axis_t), intent(in) :: axes(:)
      !> In: all NaN. Out: with pressure and gap; shape `(n_fast, n_slow, n_profiles)`.
      real(dp), intent(inout) :: profiles(:, :, :)

      if (is_sliding(values)) then
         select type (state)
         type is (adhesive_slide_point_t)
            call get_adhesive_slide_profiles(state, axes(1)%coordinates, profiles(:, 1, 1), profiles(:, 1, 2))
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
      if (is_coupled(values(in%coupling))) then
         select type (state)
         type is (coupled_point_t)
            call get_coupled_profiles(values, state, axes(1)%coordinates, profiles(:, 1, 1), profiles(:, 1, 2))
         end select
         return
      end if
      call get_elastic_wave_profiles(values, results, axes(1)%coordinates, profiles(:, 1, 1), profiles(:, 1, 2))
   end subroutine fill_pressure_and_gap

end module adfric_plane_wave_model
