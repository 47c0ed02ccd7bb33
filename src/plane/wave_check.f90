! SPDX-License-Identifier: GPL-3.0-or-later
!> What an input of the model `wave_1d` may not say, and what its values mean.
module adfric_plane_wave_check
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_plane_adhesive_wave_point, only: is_possible_adhesion
   use adfric_plane_sliding_check, only: check_sliding, refuse_sliding
   use adfric_plane_sliding_wave_point, only: is_possible_slide
   use adfric_plane_wave_variables, only: v_adhesion, v_amplitude, v_branch, v_coefficient, v_contact_modulus, v_material, &
      & v_mean_pressure, v_penetration, v_period, v_poisson_ratio, v_pressure_factor, v_second_poisson_ratio, v_shear_strength, &
      & v_tangential_stress, v_temperature, v_turning_pressure, v_velocity
   use adfric_interface_adhesion_rows, only: check_adhesion, has_adhesion
   use adfric_solid_contact_modulus, only: check_contact_modulus
   use adfric_interface_coulomb_rows, only: check_coulomb, has_coulomb, n_coulomb_rows, needs_poisson_ratio
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_interface_shear_strength_rows, only: check_shear, has_shear
   use adfric_solid_spectrum_rows, only: has_spectrum
   use adfric_describe_check, only: require, require_one
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: check_wave, is_sliding, is_adhesive

contains

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

   !> Add to `problems` what is missing or impossible.
   subroutine check_wave(variables, values, given, problems)
      !> Table of the variables; their names are part of the messages.
      type(variable_t), intent(in) :: variables(:)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Lists and datasets of the input.
      type(given_spectrum_t), intent(in) :: given
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: before

      before = problems%count()
      call require(variables, values, [v_period, v_amplitude], problems)
      if (is_sliding(values)) then
         call check_material(variables, values, given, problems)
      else
         call check_solid(variables, values, problems)
      end if
      call require_one(variables, values, [v_mean_pressure, v_penetration], .true., problems)
      if (problems%count() > before) return
      if (is_adhesive(values)) then
         if (.not. is_possible_adhesion(values)) call problems%add('adhesion', 'stress', &
            & 'or its range is too small or too large for the wave: stress/p* and range/amplitude are 1e-12 to 1e12')
      else if (.not. is_set(values(v_adhesion)) .and. values(v_mean_pressure) < 0) then
         call problems%add('operating', 'mean_pressure', 'is below 0, but nothing pulls without &adhesion')
      end if
      if (.not. is_sliding(values)) return
      if (.not. is_possible_slide(values, given)) call problems%add('operating', 'velocity', &
         & 'is too small or too large for the period and the relaxation times')
   end subroutine check_wave

   !> Add to `problems` what is wrong with an elastic solid, over which no velocity counts.
   subroutine check_solid(variables, values, problems)
      !> Table of the variables; their names are part of the messages.
      type(variable_t), intent(in) :: variables(:)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      real(dp) :: friction(n_coulomb_rows)

      friction = values(v_tangential_stress:v_coefficient)
      call check_contact_modulus(variables(v_contact_modulus:v_second_poisson_ratio), &
         & values(v_contact_modulus:v_second_poisson_ratio), problems, has_coulomb(friction))
      if (needs_poisson_ratio(friction, .true.) .and. is_set(values(v_contact_modulus)) &
         & .and. .not. is_set(values(v_poisson_ratio))) call problems%add('solid', 'poisson_ratio', &
         & 'is missing [-]; the displacement along y needs it')
      call check_coulomb(variables(v_tangential_stress:v_coefficient), friction, &
         & has_adhesion(values(v_adhesion:v_turning_pressure)), has_shear(values(v_shear_strength:v_pressure_factor)), problems)
      call check_adhesion(variables(v_adhesion:v_turning_pressure), values(v_adhesion:v_turning_pressure), problems)
      call check_shear(variables(v_shear_strength:v_pressure_factor), values(v_shear_strength:v_pressure_factor), &
         & merge(values(v_adhesion), 0.0_dp, is_adhesive(values)), problems)
      call refuse_sliding(variables(v_material:v_velocity), values(v_material:v_velocity), problems)
   end subroutine check_solid

   !> Add to `problems` what is wrong with a viscoelastic material.
   subroutine check_material(variables, values, given, problems)
      !> Table of the variables; their names are part of the messages.
      type(variable_t), intent(in) :: variables(:)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Lists and datasets of the input.
      type(given_spectrum_t), intent(in) :: given
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: k

      do k = v_contact_modulus, v_second_poisson_ratio
         if (is_set(values(k))) call problems%add(variables(k)%group, variables(k)%name, &
            & 'stands beside &material; give &solid for an elastic solid, &material for a viscoelastic one')
      end do
      call check_sliding(variables(v_material:v_velocity), values(v_material:v_velocity), given, problems)
      do k = v_shear_strength, v_coefficient
         if (is_set(values(k))) call problems%add(variables(k)%group, variables(k)%name, &
            & 'stands beside &material; the friction of a viscoelastic solid is that of its losses')
      end do
      do k = v_adhesion, v_turning_pressure
         if (k == v_branch .or. .not. is_set(values(k))) cycle
         call problems%add(variables(k)%group, variables(k)%name, &
            & 'stands beside &material; a wave adheres to an elastic solid, &solid')
         exit
      end do
   end subroutine check_material

end module adfric_plane_wave_check
