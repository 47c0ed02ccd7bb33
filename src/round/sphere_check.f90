! SPDX-License-Identifier: GPL-3.0-or-later
!> What is missing, contradictory or impossible in an input of the model `sphere`.
module adfric_round_sphere_check
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_solid_contact_modulus, only: check_contact_modulus
   use adfric_interface_shear_strength_rows, only: check_shear
   use adfric_describe_check, only: require, require_one
   use adfric_describe_table, only: variable_t, kind_real
   use adfric_round_sphere_case, only: sphere_case_t, resolve_case, has_ratio_of_body, theory_auto
   use adfric_round_sphere_contact, only: theory_hertz, theory_jkr, theory_maugis_dugdale, control_radius, branch_stable
   use adfric_interface_interaction, only: is_valid_interaction
   use adfric_round_sphere_variables
   implicit none (type, external)
   private
   public :: check_sphere_values

   !> A reduced number above this, or below its inverse, is refused: it comes from a slip in the units.
   real(dp), parameter :: largest = 1.0e30_dp

contains

   !> Add to `problems` what is wrong with the values together.
   subroutine check_sphere_values(variables, values, problems)
      !> Table of the variables of the model; shape `(n_variables)`.
      type(variable_t), intent(in) :: variables(:)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: before

      before = problems%count()
      call check_sphere()
      call check_operation()
      call check_friction()
      if (values(v_profiles) > 0) call require(variables, values, [v_r_max], problems)
      if (problems%count() == before) call check_reduced()

   contains

      !> Add a problem of one variable to the list.
      subroutine add(v, text)
         !> Place of the variable, one of `v_...`.
         integer, intent(in) :: v
         !> What is wrong, what was given, what is allowed.
         character(*), intent(in) :: text

         call problems%add(variables(v)%group, variables(v)%name, text)
      end subroutine add

      !> Radius, moduli and adhesion: what each theory and the reduced units need, and what they have no place for.
      subroutine check_sphere()
         integer, parameter :: si_only(*) = [v_radius, v_contact_modulus, v_young_modulus, v_body_poisson_ratio, &
            & v_second_young_modulus, v_second_poisson_ratio, v_work_of_adhesion, v_adhesion_stress, v_adhesion_range, &
            & v_critical_slip]
         integer :: theory, k
         logical :: has_adhesion

         theory = nint(values(v_theory)) - 2
         if (nint(values(v_units)) == units_reduced) then
            do k = 1, size(si_only)
               if (is_set(values(si_only(k)))) call add(si_only(k), 'has no place in reduced units')
            end do
            if (theory == theory_auto .or. theory == theory_maugis_dugdale) call require(variables, values, [v_lambda], problems)
         else
            call require(variables, values, [v_radius], problems)
            associate (first => v_contact_modulus, last => v_second_poisson_ratio)
               call check_contact_modulus(variables(first:last), values(first:last), problems, .false.)
            end associate
            if (theory /= theory_hertz) call require(variables, values, [v_work_of_adhesion], problems)
            has_adhesion = .false.
            if (is_set(values(v_work_of_adhesion))) has_adhesion = values(v_work_of_adhesion) > 0
            call require_one(variables, values, [v_adhesion_stress, v_adhesion_range, v_lambda], &
               & has_adhesion .and. (theory == theory_auto .or. theory == theory_maugis_dugdale), problems)
            if (theory > theory_hertz .and. is_set(values(v_work_of_adhesion)) .and. .not. has_adhesion) then
               call add(v_work_of_adhesion, 'is 0, given 0 J/m^2, allowed with this theory: a number > 0 [J/m^2]')
            end if
         end if
      end subroutine check_sphere

      !> What is held: one of load, approach and radius.
      subroutine check_operation()
         call require_one(variables, values, [v_load, v_approach, v_contact_radius], .true., problems)
         if (is_set(values(v_contact_radius)) .and. nint(values(v_branch)) /= branch_stable) then
            call add(v_branch, 'has no meaning with contact_radius: a radius belongs to one state')
         end if
      end subroutine check_operation

      !> Friction: the variables that need a shear strength, and those that exclude each other.
      subroutine check_friction()
         integer, parameter :: with_strength(*) = [v_pressure_factor, v_poisson_ratio, v_critical_slip, v_slip_energy_ratio, &
            & v_tangential_force, v_tangential_displacement, v_base_displacement, v_lateral_stiffness], &
            & moves(*) = [v_tangential_force, v_tangential_displacement, v_base_displacement]
         logical :: is_static, is_moved
         integer :: k

         is_static = nint(values(v_state)) == state_static
         is_moved = any(is_set(values(moves)))
         call require_one(variables, values, moves, .false., problems)
         call require_one(variables, values, [v_critical_slip, v_slip_energy_ratio], .false., problems)
         if (.not. is_set(values(v_shear_strength))) then
            do k = 1, size(with_strength)
               if (is_set(values(with_strength(k)))) call add(v_shear_strength, &
                  & 'is missing [Pa]; '//variables(with_strength(k))%name//' needs it')
            end do
            if (values(v_interaction) > 0) call add(v_shear_strength, 'is missing [Pa]; interaction needs it')
            if (.not. is_static) call add(v_shear_strength, 'is missing [Pa]; sliding needs it')
            if (values(v_events) > 0) call add(v_shear_strength, 'is missing [Pa]; events need it')
            return
         end if
         if (is_set(values(v_base_displacement))) call require(variables, values, [v_lateral_stiffness], problems)
         if (is_set(values(v_lateral_stiffness)) .and. .not. (values(v_events) > 0 .or. is_set(values(v_base_displacement)))) &
            & call add(v_lateral_stiffness, 'has no meaning without events or base_displacement')
         if (is_moved .and. .not. is_static) call add(v_state, 'is sliding beside a tangential force or displacement')
         if ((is_moved .or. values(v_events) > 0) .and. .not. has_ratio_of_body(values)) &
            & call require(variables, values, [v_poisson_ratio], problems)
         if (values(v_interaction) > 0) then
            if (.not. is_static .or. values(v_events) > 0 .or. is_set(values(v_base_displacement))) then
               call require_one(variables, values, [v_slip_energy_ratio, v_critical_slip], .true., problems)
            end if
            ! where work_of_adhesion itself is missing that has been said
            if (nint(values(v_units)) == units_si .and. (.not. values(v_work_of_adhesion) > 0 .or. &
               & .not. is_set(values(v_work_of_adhesion)) .and. nint(values(v_theory)) - 2 == theory_hertz)) then
               call add(v_interaction, 'needs adhesion to act on')
            end if
         end if
         if (is_set(values(v_pressure_factor))) call check_pressure_factor(is_static .and. (is_moved .or. values(v_events) > 0))
      end subroutine check_friction

      !> A strength that grows with pressure: what has no meaning beside it.
      subroutine check_pressure_factor(slips)
         !> Is there partial slip?
         logical, intent(in) :: slips

         if (.not. values(v_pressure_factor) > 0) return
         if (is_set(values(v_base_displacement))) call add(v_base_displacement, &
            & 'stands beside pressure_factor > 0, with which nothing jumps; give tangential_displacement')
         if (slips .and. nint(values(v_theory)) - 2 == theory_jkr) call add(v_pressure_factor, &
            & 'has no partial slip in JKR, whose tension at the edge is infinite; give adhesion a range')
         if (.not. values(v_interaction) > 0) return
         if (slips) call add(v_pressure_factor, &
            & 'stands beside interaction > 0: what slip takes from adhesion on the way to sliding is known of a constant ' &
            & //'strength alone; allowed with it: 0 [-], or state = ''sliding'' without events')
         if (is_set(values(v_critical_slip))) call add(v_critical_slip, &
            & 'has no meaning with pressure_factor > 0, where the stress at the edge is not tau0; give slip_energy_ratio')
      end subroutine check_pressure_factor

      !> Values that are possible one by one, and not together.
      subroutine check_reduced()
         integer, parameter :: held(*) = [v_load, v_approach, v_contact_radius], of_units(*) = [v_radius, &
            & v_contact_modulus, v_young_modulus, v_second_young_modulus, v_work_of_adhesion]
         type(sphere_case_t) :: resolved
         integer :: k

         ! beyond these the units, and ratios to them, are no numbers any more
         do k = 1, size(values)
            if (variables(k)%kind /= kind_real .or. .not. is_set(values(k))) cycle
            if (any(of_units == k) .and. abs(values(k)) > 0) then
               if (.not. is_plain(values(k))) call add(k, 'is beyond all spheres')
            else if (.not. abs(values(k)) < largest**3) then
               call add(k, 'is beyond all spheres')
            end if
         end do
         if (problems%count() > before) return
         call resolve_case(values, resolved)
         if (.not. is_plain(resolved%lambda)) call add(v_lambda, 'is beyond all spheres, given the stress or the range')
         if (resolved%control == control_radius .and. .not. is_plain(resolved%value)) then
            call add(v_contact_radius, 'is beyond all spheres')
         else if (.not. abs(resolved%value) < largest) then
            call add(held(resolved%control), 'is too large for this sphere')
         end if
         if (resolved%has_friction .and. .not. is_plain(resolved%strength)) call add(v_shear_strength, 'is beyond all spheres')
         if (is_set(values(v_lateral_stiffness)) .and. .not. is_plain(resolved%stiffness)) call add(v_lateral_stiffness, &
            & 'is beyond all spheres')
         if (resolved%pressure_factor > 0 .and. (resolved%theory == theory_auto .or. resolved%theory == theory_maugis_dugdale)) then
            call check_shear(variables(v_shear_strength:v_pressure_factor), [resolved%strength, resolved%pressure_factor], &
               & resolved%lambda, problems)
         end if
         if (.not. abs(resolved%tangential) < largest) call add(v_tangential_force - 1 + findloc([resolved%is_force_given, &
            & resolved%is_displacement_given, resolved%is_base_given], .true., 1), 'is too large for this sphere')
         if (resolved%interaction > 0 .and. resolved%slip_energy_ratio < huge(1.0_dp)) then
            if (.not. is_valid_interaction(resolved%slip_energy_ratio, resolved%interaction)) call add(v_interaction, &
               & 'would take more than there is of adhesion; allowed: a number <= 1 + 1/(2 g0) [-]')
         end if
      end subroutine check_reduced

   end subroutine check_sphere_values

   !> Is a positive number neither enormous nor next to nothing?
   pure logical function is_plain(value)
      !> A reduced number, or a variable in its SI unit.
      real(dp), intent(in) :: value

      is_plain = value < largest .and. value > 1/largest
   end function is_plain

end module adfric_round_sphere_check
