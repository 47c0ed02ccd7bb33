! SPDX-License-Identifier: GPL-3.0-or-later
!> What an input of the model `wave_1d` may not say, and what its values mean.
module adfric_plane_wave_check
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_plane_adhesive_sliding_point, only: is_possible_adhesive_slide
   use adfric_plane_adhesive_wave_point, only: is_possible_adhesion
   use adfric_plane_sliding_check, only: check_sliding, refuse_sliding
   use adfric_plane_sliding_wave_point, only: is_possible_slide
   use adfric_plane_wave_variables, only: in => wave_input
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
   public :: check_wave, is_sliding, is_adhesive, is_adhesive_slide

contains

   !> Does the wave slide over a viscoelastic half-plane?
   pure logical function is_sliding(values)
      real(dp), intent(in) :: values(:)

      is_sliding = has_spectrum(values(in%material(1):in%temperature))
   end function is_sliding

   !> Does the wave adhere to an elastic half-plane?
   pure logical function is_adhesive(values)
      real(dp), intent(in) :: values(:)

      is_adhesive = has_adhesion(values(in%adhesion:in%turning_pressure)) .and. .not. is_sliding(values)
   end function is_adhesive

   !> Does the wave adhere to a viscoelastic half-plane over which it slides?
   pure logical function is_adhesive_slide(values)
      real(dp), intent(in) :: values(:)

      is_adhesive_slide = has_adhesion(values(in%adhesion:in%turning_pressure)) .and. is_sliding(values)
   end function is_adhesive_slide

   !> Add to `problems` what is missing or impossible.
   subroutine check_wave(variables, values, given, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      type(problems_t), intent(inout) :: problems
      integer :: before

      before = problems%count()
      call require(variables, values, [in%period, in%amplitude], problems)
      if (is_sliding(values)) then
         call check_material(variables, values, given, problems)
      else
         call check_solid(variables, values, problems)
      end if
      call require_one(variables, values, [in%mean_pressure, in%penetration], .true., problems)
      if (problems%count() > before) return
      if (is_adhesive(values)) then
         if (.not. is_possible_adhesion(values)) call problems%add('adhesion', 'stress', &
            & 'or its range is too small or too large for the wave: stress/p* and range/amplitude are 1e-12 to 1e12')
      else if (.not. is_set(values(in%adhesion)) .and. values(in%mean_pressure) < 0) then
         call problems%add('operating', 'mean_pressure', 'is below 0, but nothing pulls without &adhesion')
      end if
      if (.not. is_sliding(values)) return
      if (is_adhesive_slide(values)) then
         if (.not. is_possible_adhesive_slide(values, given)) call problems%add('adhesion', 'stress', &
            & 'or its range or the velocity is too small or too large: stress/(k D E0) and range/amplitude are 1e-6 to 1e6')
         return
      end if
      if (.not. is_possible_slide(values, given)) call problems%add('operating', 'velocity', &
         & 'is too small or too large for the period and the relaxation times')
   end subroutine check_wave

   !> Add to `problems` what is wrong with an elastic solid, over which no velocity counts.
   subroutine check_solid(variables, values, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      real(dp) :: friction(n_coulomb_rows)

      friction = values(in%tangential_stress:in%coefficient)
      call check_contact_modulus(variables(in%contact_modulus:in%second_poisson_ratio), &
         & values(in%contact_modulus:in%second_poisson_ratio), problems, has_coulomb(friction))
      if (needs_poisson_ratio(friction, .true.) .and. is_set(values(in%contact_modulus)) &
         & .and. .not. is_set(values(in%poisson_ratio))) call problems%add('solid', 'poisson_ratio', &
         & 'is missing [-]; the displacement along y needs it')
      call check_coulomb(variables(in%tangential_stress:in%coefficient), friction, &
         & has_adhesion(values(in%adhesion:in%turning_pressure)), has_shear(values(in%shear_strength:in%pressure_factor)), problems)
      call check_adhesion(variables(in%adhesion:in%turning_pressure), values(in%adhesion:in%turning_pressure), problems)
      call check_shear(variables(in%shear_strength:in%pressure_factor), values(in%shear_strength:in%pressure_factor), &
         & merge(values(in%adhesion), 0.0_dp, is_adhesive(values)), problems)
      call refuse_sliding(variables(in%material(1):in%velocity), values(in%material(1):in%velocity), problems)
   end subroutine check_solid

   !> Add to `problems` what is wrong with a viscoelastic material.
   subroutine check_material(variables, values, given, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      type(problems_t), intent(inout) :: problems
      integer :: k

      do k = in%contact_modulus, in%second_poisson_ratio
         if (is_set(values(k))) call problems%add(variables(k)%group, variables(k)%name, &
            & 'stands beside &material; give &solid for an elastic solid, &material for a viscoelastic one')
      end do
      call check_sliding(variables(in%material(1):in%velocity), values(in%material(1):in%velocity), given, problems)
      do k = in%shear_strength, in%coefficient
         if (is_set(values(k))) call problems%add(variables(k)%group, variables(k)%name, &
            & 'stands beside &material; the friction of a viscoelastic solid is that of its losses')
      end do
      call check_adhesion(variables(in%adhesion:in%turning_pressure), values(in%adhesion:in%turning_pressure), problems)
      if (is_set(values(in%turning_pressure))) call problems%add(variables(in%turning_pressure)%group, &
         & variables(in%turning_pressure)%name, 'stands beside &material; a wave that slides unloads from full contact')
   end subroutine check_material

end module adfric_plane_wave_check
