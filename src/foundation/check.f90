! SPDX-License-Identifier: GPL-3.0-or-later
!> What is missing, contradictory or impossible in an input of the model `wavy_sliding`.
module adfric_foundation_check
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_interface_adhesion_rows, only: check_stress
   use adfric_describe_check, only: require
   use adfric_describe_table, only: variable_t
   use adfric_foundation_case, only: wavy_case_t, resolve_case
   use adfric_foundation_stepped_check, only: check_load_values, require_modulus, require_single_time
   use adfric_foundation_variables, only: v_activation_energy, v_amplitudes, v_blend_share, v_detrend, v_height, v_height_factor, &
      & v_heights, v_interpolation, v_kind, v_load, v_moduli, v_n_x, v_n_y, v_penetration, v_period, v_periodise, v_phases, &
      & v_poisson_ratio, v_profiles, v_range, v_reference_temperature, v_reverse, v_shift, &
      & v_shortest_wavelength, v_spacing, v_stiffness, v_stress, v_strip_spacing, v_relaxed_modulus, v_temperature, &
      & v_terms_per_decade, v_thickness, &
      & v_time_factor, v_velocity, v_wlf_c1, v_wlf_c2, v_young_moduli, v_young_modulus
   implicit none (type, external)
   private
   public :: check_wavy_values

contains

   !> Add to `problems` what is wrong with the values together.
   subroutine check_wavy_values(variables, values, is_swept, problems)
      !> Table of the variables; their names stand in the messages.
      type(variable_t), intent(in) :: variables(:)
      !> Values in the order of `variables`, `unset` where none is given; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: before

      before = problems%count()
      call require(variables, values, [v_kind, v_period, v_height], problems)
      call check_foundation()
      call check_stress(variables(v_stress:v_range), values(v_stress:v_range), problems)
      call require(variables, values, [v_velocity], problems)
      call check_load_values(variables, values, problems)
      call refuse_marched()
      if (values(v_profiles) > 0 .and. is_swept(v_period)) then
         call add(v_profiles, 'need one period, which is swept; sweep another variable or switch profiles off')
      end if
      if (values(v_profiles) > 0 .and. (is_swept(v_n_x) .or. is_swept(v_n_y))) then
         call add(v_profiles, 'need one axis, and its samples are swept; sweep another variable or switch profiles off')
      end if
      if (problems%count() == before) call check_reduced()

   contains

      !> Add a problem of one variable to the list.
      subroutine add(v, text)
         !> Place of the variable in the table, one of `v_...`.
         integer, intent(in) :: v
         !> What is wrong with the variable; its name is put before this.
         character(*), intent(in) :: text

         call problems%add(variables(v)%group, variables(v)%name, text)
      end subroutine add

      !> Foundation: a stiffness or a layer, and both times of the solid.
      subroutine check_foundation()
         logical :: has_layer(3)
         integer, parameter :: layer(3) = [v_young_modulus, v_poisson_ratio, v_thickness]

         has_layer = is_set(values(layer))
         if (is_set(values(v_stiffness)) .and. any(has_layer)) then
            call add(v_stiffness, 'stands beside '//variables(layer(findloc(has_layer, .true., 1)))%name// &
               & '; give stiffness, or young_modulus, poisson_ratio and thickness')
         else if (.not. is_set(values(v_stiffness))) then
            call require_modulus(variables, values, problems)
         end if
         call require_single_time(variables, values, problems)
      end subroutine check_foundation

      !> Refuse what belongs to heights and spectra.
      subroutine refuse_marched()
         integer, parameter :: places(*) = [v_heights, v_spacing, v_strip_spacing, v_amplitudes, v_phases, &
            & v_interpolation, v_detrend, &
            & v_periodise, v_blend_share, v_shortest_wavelength, v_reverse, v_height_factor, v_moduli, v_young_moduli, &
            & v_relaxed_modulus, v_terms_per_decade, v_time_factor, v_shift, v_reference_temperature, v_wlf_c1, v_wlf_c2, &
            & v_activation_energy, &
            & v_temperature]
         integer :: k

         do k = 1, size(places)
            if (is_set(values(places(k))) .or. is_swept(places(k))) call add(places(k), &
               & 'belongs to heights, cosines or a spectrum (relaxation_times or master_curve), which are not given')
         end do
      end subroutine refuse_marched

      !> Values that are possible one by one, and beyond all numbers together.
      subroutine check_reduced()
         type(wavy_case_t) :: resolved
         real(dp), parameter :: largest = 1.0e100_dp

         call resolve_case(values, resolved)
         associate (given => resolved%given)
            if (.not. resolved%surface%foundation%v < largest) call add(v_velocity, &
               & 'times relaxation_time and retardation_ratio is too large for the period')
            if (.not. max(given%stress, given%range) < largest) call add(v_stress, &
               & 'or its range is too large for this height and stiffness')
            if (.not. max(abs(resolved%load), abs(resolved%penetration)) < largest) call add(merge(v_load, &
               & v_penetration, resolved%is_load_given), 'is too large for this height and stiffness')
         end associate
      end subroutine check_reduced

   end subroutine check_wavy_values

end module adfric_foundation_check
