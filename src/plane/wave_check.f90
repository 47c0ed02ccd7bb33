! SPDX-License-Identifier: GPL-3.0-or-later
!> What an input of the model `wave_1d` may not say, and what its values mean.
module adfric_plane_wave_check
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set, unset
   use adfric_plane_adhesive_sliding_point, only: is_possible_adhesive_slide
   use adfric_plane_adhesive_wave_point, only: is_possible_adhesion
   use adfric_plane_sliding_check, only: check_sliding, refuse_sliding
   use adfric_plane_sliding_wave_point, only: is_possible_slide
   use adfric_plane_wave_interface, only: interface_of
   use adfric_plane_wave_variables, only: in => wave_input
   use adfric_interface_adhesion_rows, only: check_adhesion, has_adhesion
   use adfric_solid_contact_modulus, only: check_contact_modulus
   use adfric_interface_conduction_rows, only: check_conduction, n_conduction_rows, refuse_conduction
   use adfric_interface_coulomb_rows, only: check_coulomb, has_coulomb, n_coulomb_rows, needs_poisson_ratio
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_interface_shear_strength_rows, only: n_shear_rows
   use adfric_interface_friction_law_check, only: check_interface
   use adfric_interface_shear_coupling, only: check_coupling, is_coupled
   use adfric_interface_friction_law_rows, only: given_law_t, has_interface, has_law_of_speed, i_pressure_volume, &
      & n_interface_rows, needs_temperature
   use adfric_solid_spectrum_rows, only: has_spectrum, solid_shift_of
   use adfric_solid_time_temperature, only: shift_none, time_temperature_t
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
   subroutine check_wave(variables, values, given, given_law, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      type(given_law_t), intent(in) :: given_law
      type(problems_t), intent(inout) :: problems
      integer :: before

      before = problems%count()
      call require(variables, values, [in%period, in%amplitude], problems)
      if (is_sliding(values)) then
         call check_material(variables, values, given, given_law, problems)
      else
         call check_solid(variables, values, given_law, problems)
      end if
      call check_current(variables, values, problems)
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

   !> Add to `problems` what is wrong with conduction, which the wave at rest has in closed form.
   subroutine check_current(variables, values, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems

      associate (rows => variables(in%conduction(1):in%conduction(n_conduction_rows)), &
            & of_rows => values(in%conduction(1):in%conduction(n_conduction_rows)))
         call check_conduction(rows, of_rows, problems)
         if (is_sliding(values) .or. is_coupled(values(in%coupling))) call refuse_conduction(rows, of_rows, &
            & 'stands beside a wave that slides; the conductance is that of one at rest', problems)
      end associate
   end subroutine check_current

   !> Add to `problems` what is wrong with an elastic solid, over which a velocity counts for a law of the interface alone.
   subroutine check_solid(variables, values, given_law, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(given_law_t), intent(in) :: given_law
      type(problems_t), intent(inout) :: problems
      type(time_temperature_t) :: none
      real(dp) :: coulomb(n_coulomb_rows), friction(n_interface_rows), others(size(values))

      coulomb = values(in%tangential_stress:in%coefficient)
      friction = interface_of(values)
      call check_contact_modulus(variables(in%contact_modulus:in%second_poisson_ratio), &
         & values(in%contact_modulus:in%second_poisson_ratio), problems, has_coulomb(coulomb) .or. is_coupled(values(in%coupling)))
      if (needs_poisson_ratio(coulomb, .true.) .and. is_set(values(in%contact_modulus)) &
         & .and. .not. is_set(values(in%poisson_ratio))) call problems%add('solid', 'poisson_ratio', &
         & 'is missing [-]; the displacement along y needs it')
      call check_coulomb(variables(in%tangential_stress:in%coefficient), coulomb, &
         & has_adhesion(values(in%adhesion:in%turning_pressure)), has_interface(friction), problems)
      call check_adhesion(variables(in%adhesion:in%turning_pressure), values(in%adhesion:in%turning_pressure), problems)
      call check_friction(variables, values, given_law, none, merge(values(in%adhesion), 0.0_dp, is_adhesive(values)), problems)
      if (is_adhesive(values) .and. is_set(friction(i_pressure_volume))) call problems%add('friction', &
         & variables(in%law(i_pressure_volume - n_shear_rows))%name, 'stands beside &adhesion; over the tension at its edges the ' &
         & //'law is not integrated')
      others = values
      call check_coupled(variables, values, problems)
      if (has_law_of_speed(friction) .or. is_coupled(values(in%coupling))) others(in%velocity) = unset
      if (needs_temperature(friction)) others(in%temperature) = unset
      call refuse_sliding(variables(in%material(1):in%velocity), others(in%material(1):in%velocity), problems)
   end subroutine check_solid

   !> Add to `problems` what does not go with a contact that the shear stress moves.
   subroutine check_coupled(variables, values, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems

      associate (row => variables(in%coupling), value => values(in%coupling))
         call check_coupling(row, value, interface_of(values), values(in%poisson_ratio), .false., problems)
         if (.not. is_coupled(value)) return
         if (has_adhesion(values(in%adhesion:in%turning_pressure))) call problems%add(row%group, row%name, &
            & 'stands beside adhesion, with which the contact is that of frictionless faces')
         if (is_set(values(in%second_young_modulus))) call problems%add(row%group, row%name, &
            & 'stands beside second_young_modulus; the body that slides is rigid')
         call require(variables, values, [in%velocity], problems)
      end associate
   end subroutine check_coupled

   !> Add to `problems` what is wrong with the friction of the interface.
   subroutine check_friction(variables, values, given_law, of_solid, tension, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(given_law_t), intent(in) :: given_law
      !> The solid's own shift.
      type(time_temperature_t), intent(in) :: of_solid
      !> Largest tension in contact [Pa].
      real(dp), intent(in) :: tension
      type(problems_t), intent(inout) :: problems

      if (.not. has_interface(interface_of(values))) return
      call check_interface(variables, values, [in%shear_strength, in%pressure_factor, in%law], [in%temperature, in%velocity], &
         & given_law, of_solid, tension, problems)
   end subroutine check_friction

   !> Add to `problems` what is wrong with a viscoelastic material.
   subroutine check_material(variables, values, given, given_law, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      type(given_law_t), intent(in) :: given_law
      type(problems_t), intent(inout) :: problems
      type(time_temperature_t) :: of_solid
      real(dp) :: others(size(values))
      integer :: k, before

      before = problems%count()
      do k = in%contact_modulus, in%second_poisson_ratio
         if (is_set(values(k))) call problems%add(variables(k)%group, variables(k)%name, &
            & 'stands beside &material; give &solid for an elastic solid, &material for a viscoelastic one')
      end do
      of_solid = solid_shift_of(values(in%material(1):in%temperature), given)
      others = values
      ! a solid without shift has no use for the temperature of the interface
      if (needs_temperature(interface_of(values)) .and. of_solid%law == shift_none) others(in%temperature) = unset
      call check_sliding(variables(in%material(1):in%velocity), others(in%material(1):in%velocity), given, problems)
      if (is_coupled(values(in%coupling))) call problems%add(variables(in%coupling)%group, variables(in%coupling)%name, &
         & 'stands beside &material; a wave on cells has both')
      do k = in%tangential_stress, in%coefficient
         if (is_set(values(k))) call problems%add(variables(k)%group, variables(k)%name, &
            & 'stands beside &material; what slides over a viscoelastic solid has no partial slip')
      end do
      if (problems%count() == before) call check_friction(variables, values, given_law, of_solid, 0.0_dp, problems)
      call check_adhesion(variables(in%adhesion:in%turning_pressure), values(in%adhesion:in%turning_pressure), problems)
      if (is_set(values(in%turning_pressure))) call problems%add(variables(in%turning_pressure)%group, &
         & variables(in%turning_pressure)%name, 'stands beside &material; a wave that slides unloads from full contact')
      if (is_adhesive_slide(values) .and. has_interface(interface_of(values))) call problems%add(variables(in%adhesion)%group, &
         & variables(in%adhesion)%name, 'stands beside &friction and &material; a wave on cells has all three')
   end subroutine check_material

end module adfric_plane_wave_check
