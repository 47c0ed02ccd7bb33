! SPDX-License-Identifier: GPL-3.0-or-later
!> What is missing, contradictory or impossible in the friction of an input of the model `indenter`.
module adfric_round_friction_check
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_round_case, only: theory_of
   use adfric_round_contact, only: branch_stable
   use adfric_round_variables, only: law_peeling, state_sliding, theory_jkr, in => indenter_input
   use adfric_solid_contact_modulus, only: has_poisson_ratio
   use adfric_interface_interaction, only: is_valid_interaction
   use adfric_interface_interaction_rows, only: slip_energy_ratio_of
   use adfric_interface_shear_strength_rows, only: check_shear, has_shear
   use adfric_describe_check, only: require, require_one
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: check_friction, is_moved

contains

   !> Is there a tangential displacement or stiffness, so that Poisson's ratio has a use of its own?
   pure logical function is_moved(values)
      real(dp), intent(in) :: values(:)

      is_moved = any(is_set(values([in%tangential_force, in%base_displacement]))) .or. has_events(values) &
         & .or. nint(values(in%law)) == law_peeling
   end function is_moved

   !> Are the events of a growing tangential force asked for at a given load? At a given approach they come beside those of a cycle.
   pure logical function has_events(values)
      real(dp), intent(in) :: values(:)

      has_events = values(in%events) > 0 .and. (is_set(values(in%shear_strength)) .or. nint(values(in%law)) == law_peeling)
      has_events = has_events &
         & .and. (is_set(values(in%load)) .or. values(in%interaction) > 0 .or. is_set(values(in%lateral_stiffness)))
   end function has_events

   !> Friction: Coulomb's, of a shear strength, or none that gives way.
   subroutine check_friction(variables, values, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      logical :: is_coulomb, has_strength, is_adhesive

      is_coulomb = is_set(values(in%friction_coefficient))
      has_strength = has_shear(values(in%shear_strength:in%pressure_factor))
      is_adhesive = .false.
      if (is_set(values(in%work_of_adhesion))) is_adhesive = values(in%work_of_adhesion) > 0
      if (nint(values(in%law)) == law_peeling) then
         call check_peeling(variables, values, problems)
      else if (is_coulomb) then
         call require(variables, values, [in%tangential_force], problems)
         if (is_adhesive) call problems%add('friction', 'coefficient', &
            & 'stands beside &adhesion; mu p has no meaning where p is below 0: give shear_strength')
         if (has_strength) call problems%add('friction', 'coefficient', &
            & 'stands beside shear_strength or pressure_factor; give one friction')
      else if (has_strength) then
         call check_shear(variables(in%shear_strength:in%pressure_factor), values(in%shear_strength:in%pressure_factor), 0.0_dp, &
            & problems)
         if (is_set(values(in%pressure_factor))) call check_edge(values, problems)
      else if (is_set(values(in%tangential_force))) then
         call problems%add('friction', 'coefficient', 'is missing [-]; tangential_force needs it, or shear_strength')
      end if
      if (nint(values(in%law)) /= law_peeling) call check_interaction(variables, values, is_adhesive, problems)
      if (any(is_set(values([in%lateral_stiffness, in%base_displacement])))) call check_lateral_spring(variables, values, problems)
      if (.not. is_moved(values) .or. .not. is_set(values(in%contact_modulus))) return
      if (.not. has_poisson_ratio(values(in%contact_modulus:in%second_poisson_ratio))) &
         & call problems%add('solid', 'poisson_ratio', 'is missing [-]; the tangential displacement needs it')
   end subroutine check_friction

   !> A lateral spring: its jumps are events of a contact that slides against a shear strength.
   subroutine check_lateral_spring(variables, values, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      logical :: is_driven

      is_driven = is_set(values(in%base_displacement))
      if (is_driven) call require(variables, values, [in%lateral_stiffness], problems)
      if (nint(values(in%law)) == law_peeling) then
         call problems%add('operating', 'lateral_stiffness', 'has no meaning for law = ''peeling'', where nothing slides')
         return
      end if
      if (.not. (values(in%events) > 0 .or. is_driven)) call problems%add('operating', 'lateral_stiffness', &
         & 'has no meaning without events or base_displacement')
      if (.not. is_set(values(in%shear_strength))) call problems%add('friction', 'shear_strength', &
         & 'is missing [Pa]; lateral_stiffness needs it')
      ! with interaction that has been said
      if (nint(values(in%branch)) /= branch_stable .and. .not. values(in%interaction) > 0) call problems%add('operating', &
         & 'branch', &
         & 'has no meaning with lateral_stiffness, whose jumps begin at the largest stable contact')
      if (is_driven) call check_driven(variables, values, problems)
   end subroutine check_lateral_spring

   !> A base that is moved.
   subroutine check_driven(variables, values, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems

      call require_one(variables, values, [in%tangential_force, in%base_displacement], .false., problems)
      if (nint(values(in%state)) == state_sliding) call problems%add('operating', 'state', &
         & 'is ''sliding'' beside a displacement of the base')
      if (any(is_set(values([in%contact_radius, in%face_angle]))) .and. .not. values(in%interaction) > 0) &
         & call problems%add('operating', 'base_displacement', 'needs a contact that is held; give load, approach or base_approach')
      if (is_set(values(in%shear_strength))) then
         if (.not. values(in%shear_strength) > 0 .and. .not. values(in%interaction) > 0) call problems%add('friction', &
            & 'shear_strength', 'is 0 [Pa]; base_displacement needs a number > 0')
      end if
      if (.not. is_set(values(in%pressure_factor))) return
      if (values(in%pressure_factor) > 0) call problems%add('operating', 'base_displacement', &
         & 'stands beside pressure_factor > 0, with which nothing jumps; give tangential_force')
   end subroutine check_driven

   !> With alpha > 0, JKR's infinite tension at the edge would slip at once.
   subroutine check_edge(values, problems)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems

      if (.not. values(in%pressure_factor) > 0) return
      if (.not. (is_set(values(in%tangential_force)) .or. has_events(values))) return
      if (theory_of(values) == theory_jkr) call problems%add('friction', 'pressure_factor', &
         & 'has no partial slip in JKR, whose tension at the edge is infinite; give adhesion a range')
   end subroutine check_edge

   !> A contact that sticks without limit has no other friction, a load, and JKR's adhesion.
   subroutine check_peeling(variables, values, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      integer, parameter :: without(*) = [in%friction_coefficient, in%shear_strength, in%pressure_factor, in%critical_slip, &
         & in%slip_energy_ratio]
      integer :: k

      do k = 1, size(without)
         if (is_set(values(without(k)))) call problems%add('friction', variables(without(k))%name, &
            & 'has no meaning for law = ''peeling'', where nothing slips')
      end do
      if (values(in%interaction) > 0) call problems%add('friction', 'interaction', &
         & 'has no meaning for law = ''peeling'', where nothing slips')
      if (nint(values(in%state)) == state_sliding) call problems%add('operating', 'state', &
         & 'is ''sliding'', and a contact of law = ''peeling'' never slides')
      if (theory_of(values) /= theory_jkr) call problems%add('friction', 'law', &
         & 'is ''peeling'', which is that of JKR; give work_of_adhesion, without a range')
      if (.not. is_set(values(in%load))) call problems%add('friction', 'law', &
         & 'is ''peeling'', which is known at a given load; give load')
      if (nint(values(in%branch)) /= branch_stable) call problems%add('operating', 'branch', &
         & 'has no meaning for law = ''peeling'', which begins at the largest stable contact')
   end subroutine check_peeling

   !> What friction does to adhesion, and sliding.
   subroutine check_interaction(variables, values, is_adhesive, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      logical, intent(in) :: is_adhesive
      type(problems_t), intent(inout) :: problems
      logical :: is_sliding
      integer :: k

      is_sliding = nint(values(in%state)) == state_sliding
      call require_one(variables, values, [in%critical_slip, in%slip_energy_ratio], .false., problems)
      if (is_sliding .and. is_set(values(in%tangential_force))) call problems%add('operating', 'state', &
         & 'is ''sliding'' beside a tangential force')
      if (.not. is_set(values(in%shear_strength))) then
         do k = in%critical_slip, in%slip_energy_ratio
            if (is_set(values(k))) call problems%add('friction', 'shear_strength', &
               & 'is missing [Pa]; '//variables(k)%name//' needs it')
         end do
         if (values(in%interaction) > 0) call problems%add('friction', 'shear_strength', 'is missing [Pa]; interaction needs it')
         if (is_sliding) call problems%add('friction', 'shear_strength', 'is missing [Pa]; sliding needs it')
         return
      end if
      if (.not. values(in%interaction) > 0) return
      if (.not. is_adhesive) call problems%add('friction', 'interaction', 'needs adhesion to act on; give work_of_adhesion')
      if (.not. values(in%shear_strength) > 0) call problems%add('friction', 'shear_strength', &
         & 'is 0 [Pa]; interaction needs a number > 0')
      if (is_sliding .or. has_events(values) .or. is_set(values(in%base_displacement))) call require_one(variables, values, &
         & [in%slip_energy_ratio, in%critical_slip], .true., problems)
      call check_path(values, problems)
      if (is_adhesive) call check_share(values, problems)
   end subroutine check_interaction

   !> What a path from rest to sliding needs: a contact that may change, and a slip that is known.
   subroutine check_path(values, problems)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      logical :: has_path

      has_path = is_moved(values)
      if (has_path .and. any(is_set(values([in%contact_radius, in%face_angle])))) call problems%add('friction', 'interaction', &
         & 'makes the contact shrink under a tangential force, but its radius is given; give load, approach or base_approach')
      if (has_path .and. nint(values(in%branch)) /= branch_stable) call problems%add('operating', 'branch', &
         & 'has no meaning with interaction before sliding, which begins at the largest stable contact')
      if (.not. is_set(values(in%pressure_factor))) return
      if (.not. values(in%pressure_factor) > 0) return
      if (has_path) call problems%add('friction', 'pressure_factor', &
         & 'has no interaction before sliding, for the slip at an edge of a stress that is not uniform is not known; allowed: 0')
      if (is_set(values(in%critical_slip))) call problems%add('friction', 'critical_slip', &
         & 'has no meaning beside pressure_factor, with which the stress at the edge is not tau0; give slip_energy_ratio')
   end subroutine check_path

   !> Friction takes no more than there is of adhesion.
   subroutine check_share(values, problems)
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      real(dp) :: ratio

      ratio = slip_energy_ratio_of(values(in%interaction:in%slip_energy_ratio), values(in%shear_strength), &
         & values(in%work_of_adhesion))
      if (.not. ratio < huge(ratio) .or. is_valid_interaction(ratio, values(in%interaction))) return
      call problems%add('friction', 'interaction', &
         & 'would take more than there is of adhesion; allowed: a number <= 1 + 1/(2 g0) [-]')
   end subroutine check_share

end module adfric_round_friction_check
