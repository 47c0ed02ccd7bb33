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
   use adfric_round_work_check, only: require_work
   use adfric_round_sphere_variables, only: state_static, units_reduced, units_si, in => sphere_input
   implicit none (type, external)
   private
   public :: check_sphere_values

   !> A reduced number above this, or below its inverse, is refused: it comes from a slip in the units.
   real(dp), parameter :: largest = 1.0e30_dp

contains

   !> Add to `problems` what is wrong with the values together.
   subroutine check_sphere_values(variables, values, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      integer :: before

      before = problems%count()
      call check_sphere()
      call check_operation()
      call check_friction()
      if (values(in%profiles) > 0) call require(variables, values, [in%r_max], problems)
      if (problems%count() == before) call check_reduced()

   contains

      !> Add a problem of one variable to the list.
      subroutine add(v, text)
         !> Index of the variable, one of `v_...`.
         integer, intent(in) :: v
         character(*), intent(in) :: text

         call problems%add(variables(v)%group, variables(v)%name, text)
      end subroutine add

      !> Radius, moduli and adhesion: what each theory and the reduced units need, and what they have no place for.
      subroutine check_sphere()
         integer, parameter :: si_only(*) = [in%radius, in%contact_modulus, in%young_modulus, in%body_poisson_ratio, &
            & in%second_young_modulus, in%second_poisson_ratio, in%work_of_adhesion, in%adhesion_stress, in%adhesion_range, &
            & in%critical_slip]
         integer :: theory, k
         logical :: has_adhesion, is_asked_for

         theory = nint(values(in%theory)) - 2
         if (nint(values(in%units)) == units_reduced) then
            do k = 1, size(si_only)
               if (is_set(values(si_only(k)))) call add(si_only(k), 'has no place in reduced units')
            end do
            if (theory == theory_auto .or. theory == theory_maugis_dugdale) call require(variables, values, [in%lambda], problems)
         else
            call require(variables, values, [in%radius], problems)
            associate (first => in%contact_modulus, last => in%second_poisson_ratio)
               call check_contact_modulus(variables(first:last), values(first:last), problems, .false.)
            end associate
            if (theory /= theory_hertz) call require_work(variables, values, in%work_of_adhesion, &
               & [in%adhesion_stress, in%adhesion_range], problems)
            has_adhesion = .false.
            if (is_set(values(in%work_of_adhesion))) has_adhesion = values(in%work_of_adhesion) > 0
            call require_one(variables, values, [in%adhesion_stress, in%adhesion_range, in%lambda], &
               & has_adhesion .and. (theory == theory_auto .or. theory == theory_maugis_dugdale), problems)
            ! a theory that nobody asked for is that of Hertz without adhesion
            is_asked_for = abs(values(in%theory) - variables(in%theory)%default) > 0
            if (theory > theory_hertz .and. is_asked_for .and. is_set(values(in%work_of_adhesion)) .and. .not. has_adhesion) then
               call add(in%work_of_adhesion, 'is 0, given 0 J/m^2, allowed with this theory: a number > 0 [J/m^2]')
            end if
         end if
      end subroutine check_sphere

      !> What is prescribed: one of load, approach and radius.
      subroutine check_operation()
         call require_one(variables, values, [in%load, in%approach, in%contact_radius], .true., problems)
         if (is_set(values(in%contact_radius)) .and. nint(values(in%branch)) /= branch_stable) then
            call add(in%branch, 'has no meaning with contact_radius: a radius belongs to one state')
         end if
      end subroutine check_operation

      !> Friction: the variables that need a shear strength, and those that exclude each other.
      subroutine check_friction()
         integer, parameter :: with_strength(*) = [in%pressure_factor, in%poisson_ratio, in%critical_slip, in%slip_energy_ratio, &
            & in%tangential_force, in%tangential_displacement, in%base_displacement, in%lateral_stiffness], &
            & moves(*) = [in%tangential_force, in%tangential_displacement, in%base_displacement]
         logical :: is_static, is_moved
         integer :: k

         is_static = nint(values(in%state)) == state_static
         is_moved = any(is_set(values(moves)))
         call require_one(variables, values, moves, .false., problems)
         call require_one(variables, values, [in%critical_slip, in%slip_energy_ratio], .false., problems)
         if (.not. is_set(values(in%shear_strength))) then
            do k = 1, size(with_strength)
               if (is_set(values(with_strength(k)))) call add(in%shear_strength, &
                  & 'is missing [Pa]; '//variables(with_strength(k))%name//' needs it')
            end do
            if (values(in%interaction) > 0) call add(in%shear_strength, 'is missing [Pa]; interaction needs it')
            if (.not. is_static) call add(in%shear_strength, 'is missing [Pa]; sliding needs it')
            if (values(in%events) > 0) call add(in%shear_strength, 'is missing [Pa]; events need it')
            return
         end if
         if (is_set(values(in%base_displacement))) call require(variables, values, [in%lateral_stiffness], problems)
         if (is_set(values(in%lateral_stiffness)) .and. .not. (values(in%events) > 0 .or. is_set(values(in%base_displacement)))) &
            & call add(in%lateral_stiffness, 'has no meaning without events or base_displacement')
         if (is_moved .and. .not. is_static) call add(in%state, 'is sliding beside a tangential force or displacement')
         if ((is_moved .or. values(in%events) > 0) .and. .not. has_ratio_of_body(values)) &
            & call require(variables, values, [in%poisson_ratio], problems)
         if (values(in%interaction) > 0) then
            if (.not. is_static .or. values(in%events) > 0 .or. is_set(values(in%base_displacement))) then
               call require_one(variables, values, [in%slip_energy_ratio, in%critical_slip], .true., problems)
            end if
            ! where work_of_adhesion itself is missing that has been said
            if (nint(values(in%units)) == units_si .and. (.not. values(in%work_of_adhesion) > 0 .or. &
               & .not. is_set(values(in%work_of_adhesion)) .and. nint(values(in%theory)) - 2 == theory_hertz)) then
               call add(in%interaction, 'needs adhesion to act on')
            end if
         end if
         if (is_set(values(in%pressure_factor))) call check_pressure_factor(is_static .and. (is_moved .or. values(in%events) > 0))
      end subroutine check_friction

      !> A strength that grows with pressure: what has no meaning beside it.
      subroutine check_pressure_factor(slips)
         logical, intent(in) :: slips

         if (.not. values(in%pressure_factor) > 0) return
         if (is_set(values(in%base_displacement))) call add(in%base_displacement, &
            & 'stands beside pressure_factor > 0, with which nothing jumps; give tangential_displacement')
         if (slips .and. nint(values(in%theory)) - 2 == theory_jkr) call add(in%pressure_factor, &
            & 'has no partial slip in JKR, whose tension at the edge is infinite; give adhesion a range')
         if (.not. values(in%interaction) > 0) return
         if (slips) call add(in%pressure_factor, &
            & 'stands beside interaction > 0: what slip takes from adhesion on the way to sliding is known of a constant ' &
            & //'strength alone; allowed with it: 0 [-], or state = ''sliding'' without events')
         if (is_set(values(in%critical_slip))) call add(in%critical_slip, &
            & 'has no meaning with pressure_factor > 0, where the stress at the edge is not tau0; give slip_energy_ratio')
      end subroutine check_pressure_factor

      !> Values that are possible one by one, and not together.
      subroutine check_reduced()
         integer, parameter :: prescribed(*) = [in%load, in%approach, in%contact_radius], of_units(*) = [in%radius, &
            & in%contact_modulus, in%young_modulus, in%second_young_modulus, in%work_of_adhesion]
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
         if (.not. is_plain(resolved%lambda)) call add(in%lambda, 'is beyond all spheres, given the stress or the range')
         if (resolved%control == control_radius .and. .not. is_plain(resolved%value)) then
            call add(in%contact_radius, 'is beyond all spheres')
         else if (.not. abs(resolved%value) < largest) then
            call add(prescribed(resolved%control), 'is too large for this sphere')
         end if
         if (resolved%has_friction .and. .not. is_plain(resolved%strength)) call add(in%shear_strength, 'is beyond all spheres')
         if (is_set(values(in%lateral_stiffness)) .and. .not. is_plain(resolved%stiffness)) call add(in%lateral_stiffness, &
            & 'is beyond all spheres')
         if (resolved%pressure_factor > 0 .and. (resolved%theory == theory_auto .or. resolved%theory == theory_maugis_dugdale)) then
            call check_shear(variables(in%shear_strength:in%pressure_factor), [resolved%strength, resolved%pressure_factor], &
               & resolved%lambda, problems)
         end if
         if (.not. abs(resolved%tangential) < largest) call add(in%tangential_force - 1 + findloc([resolved%is_force_given, &
            & resolved%is_displacement_given, resolved%is_base_given], .true., 1), 'is too large for this sphere')
         if (resolved%interaction > 0 .and. resolved%slip_energy_ratio < huge(1.0_dp)) then
            if (.not. is_valid_interaction(resolved%slip_energy_ratio, resolved%interaction)) call add(in%interaction, &
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
