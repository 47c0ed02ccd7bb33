! SPDX-License-Identifier: GPL-3.0-or-later
!> What is missing, contradictory or impossible in an input of the model `sphere`.
module adfric_round_sphere_check
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_number
   use adfric_base_unset, only: is_set
   use adfric_solid_contact_modulus, only: check_contact_modulus
   use adfric_interface_conduction_rows, only: check_conduction, n_conduction_rows
   use adfric_interface_shear_strength_rows, only: check_shear
   use adfric_describe_check, only: checks_t, new_checks
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

   !> Add to `problems` what is wrong with the values together. It is long by its procedures, one a group, which share the checks.
   subroutine check_sphere_values(variables, values, problems)
      type(variable_t), intent(in), target :: variables(:)
      real(dp), intent(in), target :: values(:)
      type(problems_t), intent(inout), target :: problems
      type(checks_t) :: c
      integer :: before

      before = problems%count()
      call new_checks(c, variables, values, problems)
      call check_sphere()
      call check_operation()
      call check_friction()
      if (values(in%profiles) > 0) call c%need([in%r_max])
      if (problems%count() == before) call check_reduced()

   contains

      !> Radius, moduli and adhesion: what each theory and the reduced units need, and what they have no place for.
      subroutine check_sphere()
         integer, parameter :: si_only(*) = [in%radius, in%contact_modulus, in%young_modulus, in%body_poisson_ratio, &
            & in%second_young_modulus, in%second_poisson_ratio, in%work_of_adhesion, in%adhesion_stress, in%adhesion_range, &
            & in%critical_slip]
         integer :: theory
         logical :: has_adhesion, is_asked_for

         theory = nint(values(in%theory)) - 2
         if (nint(values(in%units)) == units_reduced) then
            call c%refuse([si_only, in%conduction], 'has no place in reduced units')
            if (theory == theory_auto .or. theory == theory_maugis_dugdale) call c%need([in%lambda])
         else
            call c%need([in%radius])
            call check_conduction(variables(in%conduction(1):in%conduction(n_conduction_rows)), &
               & values(in%conduction(1):in%conduction(n_conduction_rows)), problems)
            associate (first => in%contact_modulus, last => in%second_poisson_ratio)
               call check_contact_modulus(variables(first:last), values(first:last), problems, .false.)
            end associate
            if (theory /= theory_hertz) call require_work(c, in%work_of_adhesion, [in%adhesion_stress, in%adhesion_range])
            has_adhesion = c%is_above_zero(in%work_of_adhesion)
            call c%need_one([in%adhesion_stress, in%adhesion_range, in%lambda], &
               & has_adhesion .and. (theory == theory_auto .or. theory == theory_maugis_dugdale))
            ! a theory that nobody asked for is that of Hertz without adhesion
            is_asked_for = abs(values(in%theory) - variables(in%theory)%default) > 0
            call c%add(in%work_of_adhesion, 'is 0, given 0 J/m^2, allowed with this theory: a number > 0 [J/m^2]', &
               & theory > theory_hertz .and. is_asked_for .and. c%has(in%work_of_adhesion) .and. .not. has_adhesion)
         end if
      end subroutine check_sphere

      !> What is prescribed: one of load, approach and radius.
      subroutine check_operation()
         call c%need_one([in%load, in%approach, in%contact_radius], .true.)
         call c%add(in%branch, 'has no meaning with contact_radius: a radius belongs to one state', &
            & c%has(in%contact_radius) .and. .not. c%is_choice(in%branch, branch_stable))
      end subroutine check_operation

      !> Friction: the variables that need a shear strength, and those that exclude each other.
      subroutine check_friction()
         integer, parameter :: with_strength(*) = [in%pressure_factor, in%poisson_ratio, in%critical_slip, in%slip_energy_ratio, &
            & in%tangential_force, in%tangential_displacement, in%base_displacement, in%lateral_stiffness], &
            & moves(*) = [in%tangential_force, in%tangential_displacement, in%base_displacement]
         logical :: is_static, is_moved
         integer :: k

         is_static = nint(values(in%state)) == state_static
         is_moved = c%has_any(moves)
         call c%need_one(moves, .false.)
         call c%need_one([in%critical_slip, in%slip_energy_ratio], .false.)
         if (.not. c%has(in%shear_strength)) then
            do k = 1, size(with_strength)
               call c%add(in%shear_strength, 'is missing [Pa]; '//variables(with_strength(k))%name//' needs it', &
                  & c%has(with_strength(k)))
            end do
            call c%add(in%shear_strength, 'is missing [Pa]; interaction needs it', values(in%interaction) > 0)
            call c%add(in%shear_strength, 'is missing [Pa]; sliding needs it', .not. is_static)
            call c%add(in%shear_strength, 'is missing [Pa]; events need it', values(in%events) > 0)
            return
         end if
         if (c%has(in%base_displacement)) call c%need([in%lateral_stiffness])
         if (c%has(in%lateral_stiffness) .and. .not. (values(in%events) > 0 .or. c%has(in%base_displacement))) &
            & call c%add(in%lateral_stiffness, 'has no meaning without events or base_displacement')
         if (is_moved .and. .not. is_static) call c%add(in%state, 'is sliding beside a tangential force or displacement')
         call c%add(in%poisson_ratio, 'is missing [-]; the tangential displacement needs it', &
            & (is_moved .or. values(in%events) > 0) .and. .not. has_ratio_of_body(values) .and. .not. c%has(in%poisson_ratio))
         if (values(in%interaction) > 0) then
            if (.not. is_static .or. values(in%events) > 0 .or. c%has(in%base_displacement)) &
               & call c%need_one([in%slip_energy_ratio, in%critical_slip], .true.)
            ! where work_of_adhesion itself is missing that has been said
            call c%add(in%interaction, 'needs adhesion, of which friction takes a part', nint(values(in%units)) == units_si &
               & .and. (.not. values(in%work_of_adhesion) > 0 .or. &
               & .not. c%has(in%work_of_adhesion) .and. nint(values(in%theory)) - 2 == theory_hertz))
         end if
         if (c%has(in%pressure_factor)) call check_pressure_factor(is_static .and. (is_moved .or. values(in%events) > 0))
      end subroutine check_friction

      !> A strength that grows with pressure: what has no meaning beside it.
      subroutine check_pressure_factor(slips)
         logical, intent(in) :: slips

         if (.not. values(in%pressure_factor) > 0) return
         if (c%has(in%base_displacement)) call c%add(in%base_displacement, &
            & 'stands beside pressure_factor > 0, with which nothing jumps; give tangential_displacement')
         if (slips .and. nint(values(in%theory)) - 2 == theory_jkr) call c%add(in%pressure_factor, &
            & 'has no partial slip in JKR, whose tension at the edge is infinite; give adhesion a range')
         if (.not. values(in%interaction) > 0) return
         if (slips) call c%add(in%pressure_factor, &
            & 'stands beside interaction > 0: what slip takes from adhesion on the way to sliding is known of a constant ' &
            & //'strength alone; allowed with it: 0 [-], or state = ''sliding'' without events')
         if (c%has(in%critical_slip)) call c%add(in%critical_slip, &
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
               if (.not. is_plain(values(k))) call c%add(k, 'is too large or too small for a sphere, given '// &
                  & shown(values(k))//', allowed: 1e-30 to 1e30 ['//variables(k)%unit//']')
            else if (.not. abs(values(k)) < largest**3) then
               call c%add(k, 'is too large for a sphere, given '//shown(values(k))//', allowed: below 1e90')
            end if
         end do
         if (problems%count() > before) return
         call resolve_case(values, resolved)
         call need_plain(in%lambda, resolved%lambda, .true.)
         if (resolved%control == control_radius) then
            call need_plain(in%contact_radius, resolved%value, .true.)
         else
            call need_small(prescribed(resolved%control), resolved%value)
         end if
         call need_plain(in%shear_strength, resolved%strength, resolved%has_friction)
         call need_plain(in%lateral_stiffness, resolved%stiffness, c%has(in%lateral_stiffness))
         if (resolved%pressure_factor > 0 .and. (resolved%theory == theory_auto .or. resolved%theory == theory_maugis_dugdale)) then
            call check_shear(variables(in%shear_strength:in%pressure_factor), [resolved%strength, resolved%pressure_factor], &
               & resolved%lambda, problems)
         end if
         call need_small(in%tangential_force - 1 + findloc([resolved%is_force_given, resolved%is_displacement_given, &
            & resolved%is_base_given], .true., 1), resolved%tangential)
         if (resolved%interaction > 0 .and. resolved%slip_energy_ratio < huge(1.0_dp)) then
            call c%add(in%interaction, 'would take more work of adhesion than there is; allowed: a number <= 1 + 1/(2 g0) [-]', &
               & .not. is_valid_interaction(resolved%slip_energy_ratio, resolved%interaction))
         end if
      end subroutine check_reduced

      !> A reduced number is to be neither too large nor too small.
      subroutine need_plain(index, value, is_needed)
         integer, intent(in) :: index
         real(dp), intent(in) :: value
         logical, intent(in) :: is_needed

         if (is_needed .and. .not. is_plain(value)) call c%add(index, 'is too large or too small for this sphere, given '// &
            & shown(value)//' in reduced units, allowed: 1e-30 to 1e30')
      end subroutine need_plain

      !> A reduced number is not to be too large.
      subroutine need_small(index, value)
         integer, intent(in) :: index
         real(dp), intent(in) :: value

         if (.not. abs(value) < largest) call c%add(index, 'is too large for this sphere, given '//shown(value)// &
            & ' in reduced units, allowed: -1e30 to 1e30')
      end subroutine need_small

      !> A number, which may be infinite.
      function shown(value) result(text)
         real(dp), intent(in) :: value
         character(:), allocatable :: text

         text = 'no finite number'
         if (abs(value) <= huge(value)) text = show_number(value)
      end function shown

   end subroutine check_sphere_values

   !> Is a positive number neither enormous nor next to nothing?
   pure logical function is_plain(value)
      !> A reduced number, or a variable in its SI unit.
      real(dp), intent(in) :: value

      is_plain = value < largest .and. value > 1/largest
   end function is_plain

end module adfric_round_sphere_check
