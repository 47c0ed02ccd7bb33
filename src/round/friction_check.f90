! SPDX-License-Identifier: GPL-3.0-or-later
!> What is missing, contradictory or impossible in the friction of an input of the model `indenter`.
module adfric_round_friction_check
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_round_case, only: theory_of
   use adfric_round_contact, only: branch_stable
   use adfric_round_variables, only: law_peeling, state_sliding, theory_jkr, in => indenter_input
   use adfric_solid_contact_modulus, only: has_poisson_ratio
   use adfric_interface_interaction, only: is_valid_interaction
   use adfric_interface_interaction_rows, only: slip_energy_ratio_of
   use adfric_interface_shear_strength_rows, only: check_shear, has_shear
   use adfric_describe_check, only: checks_t
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
   subroutine check_friction(c)
      type(checks_t), intent(in) :: c
      logical :: is_coulomb, has_strength, is_adhesive, is_peeling

      associate (values => c%values)
         is_coulomb = c%has(in%friction_coefficient)
         has_strength = has_shear(values(in%shear_strength:in%pressure_factor))
         is_adhesive = c%is_above_zero(in%work_of_adhesion)
         is_peeling = c%is_choice(in%law, law_peeling)
         if (is_peeling) then
            call check_peeling(c)
         else if (is_coulomb) then
            call c%need([in%tangential_force])
            call c%add(in%friction_coefficient, &
               & 'stands beside &adhesion; mu p has no meaning where p is below 0: give shear_strength', is_adhesive)
            call c%add(in%friction_coefficient, 'stands beside shear_strength or pressure_factor; give one friction', has_strength)
         else if (has_strength) then
            call check_shear(c%variables(in%shear_strength:in%pressure_factor), values(in%shear_strength:in%pressure_factor), &
               & 0.0_dp, c%problems)
            ! JKR's infinite tension at the edge would slip at once
            call c%add(in%pressure_factor, &
               & 'has no partial slip in JKR, whose tension at the edge is infinite; give adhesion a range', &
               & c%is_above_zero(in%pressure_factor) .and. (c%has(in%tangential_force) .or. has_events(values)) &
               & .and. theory_of(values) == theory_jkr)
         else
            call c%add(in%friction_coefficient, 'is missing [-]; tangential_force needs it, or shear_strength', &
               & c%has(in%tangential_force))
         end if
         if (.not. is_peeling) call check_interaction(c, is_adhesive)
         if (c%has_any([in%lateral_stiffness, in%base_displacement])) call check_lateral_spring(c)
         call c%add(in%poisson_ratio, 'is missing [-]; the tangential displacement needs it', is_moved(values) &
            & .and. c%has(in%contact_modulus) .and. .not. has_poisson_ratio(values(in%contact_modulus:in%second_poisson_ratio)))
      end associate
   end subroutine check_friction

   !> A lateral spring: its jumps are events of a contact that slides against a shear strength.
   subroutine check_lateral_spring(c)
      type(checks_t), intent(in) :: c
      logical :: is_driven

      is_driven = c%has(in%base_displacement)
      call c%need([in%lateral_stiffness], is_driven)
      if (c%is_choice(in%law, law_peeling)) then
         call c%add(in%lateral_stiffness, 'has no meaning for law = ''peeling'', where nothing slides')
         return
      end if
      call c%add(in%lateral_stiffness, 'has no meaning without events or base_displacement', &
         & .not. (c%values(in%events) > 0 .or. is_driven))
      call c%add(in%shear_strength, 'is missing [Pa]; lateral_stiffness needs it', .not. c%has(in%shear_strength))
      ! with interaction that has been said
      call c%add(in%branch, 'has no meaning with lateral_stiffness, whose jumps begin at the largest stable contact', &
         & .not. c%is_choice(in%branch, branch_stable) .and. .not. c%values(in%interaction) > 0)
      if (is_driven) call check_driven(c)
   end subroutine check_lateral_spring

   !> A base that is moved.
   subroutine check_driven(c)
      type(checks_t), intent(in) :: c

      call c%need_one([in%tangential_force, in%base_displacement], .false.)
      call c%add(in%state, 'is ''sliding'' beside a displacement of the base', c%is_choice(in%state, state_sliding))
      call c%add(in%base_displacement, 'needs a prescribed load or approach; give load, approach or base_approach', &
         & c%has_any([in%contact_radius, in%face_angle]) .and. .not. c%values(in%interaction) > 0)
      call c%add(in%shear_strength, 'is 0 [Pa]; base_displacement needs a number > 0', &
         & .not. c%values(in%shear_strength) > 0 .and. .not. c%values(in%interaction) > 0)
      call c%add(in%base_displacement, 'stands beside pressure_factor > 0, with which nothing jumps; give tangential_force', &
         & c%is_above_zero(in%pressure_factor))
   end subroutine check_driven

   !> A contact that sticks without limit has no other friction, a load, and JKR's adhesion.
   subroutine check_peeling(c)
      type(checks_t), intent(in) :: c
      character(*), parameter :: nothing_slips = 'has no meaning for law = ''peeling'', where nothing slips'
      integer, parameter :: without(*) = [in%friction_coefficient, in%shear_strength, in%pressure_factor, in%critical_slip, &
         & in%slip_energy_ratio]

      call c%refuse(without, nothing_slips)
      call c%add(in%interaction, nothing_slips, c%values(in%interaction) > 0)
      call c%add(in%state, 'is ''sliding'', and a contact of law = ''peeling'' never slides', c%is_choice(in%state, state_sliding))
      call c%add(in%law, 'is ''peeling'', which is that of JKR; give work_of_adhesion, without a range', &
         & theory_of(c%values) /= theory_jkr)
      call c%add(in%law, 'is ''peeling'', which is known at a given load; give load', .not. c%has(in%load))
      call c%add(in%branch, 'has no meaning for law = ''peeling'', which begins at the largest stable contact', &
         & .not. c%is_choice(in%branch, branch_stable))
   end subroutine check_peeling

   !> What friction does to adhesion, and sliding.
   subroutine check_interaction(c, is_adhesive)
      type(checks_t), intent(in) :: c
      logical, intent(in) :: is_adhesive
      logical :: is_sliding, has_interaction
      integer :: k

      is_sliding = c%is_choice(in%state, state_sliding)
      has_interaction = c%values(in%interaction) > 0
      call c%need_one([in%critical_slip, in%slip_energy_ratio], .false.)
      call c%add(in%state, 'is ''sliding'' beside a tangential force', is_sliding .and. c%has(in%tangential_force))
      if (.not. c%has(in%shear_strength)) then
         do k = in%critical_slip, in%slip_energy_ratio
            call c%add(in%shear_strength, 'is missing [Pa]; '//c%variables(k)%name//' needs it', c%has(k))
         end do
         call c%add(in%shear_strength, 'is missing [Pa]; interaction needs it', has_interaction)
         call c%add(in%shear_strength, 'is missing [Pa]; sliding needs it', is_sliding)
      else if (has_interaction) then
         call c%add(in%interaction, 'needs adhesion, of which friction takes a part; give work_of_adhesion', .not. is_adhesive)
         call c%add(in%shear_strength, 'is 0 [Pa]; interaction needs a number > 0', .not. c%values(in%shear_strength) > 0)
         if (is_sliding .or. has_events(c%values) .or. c%has(in%base_displacement)) &
            & call c%need_one([in%slip_energy_ratio, in%critical_slip], .true.)
         call check_path(c)
         if (is_adhesive) call check_share(c)
      end if
   end subroutine check_interaction

   !> What a path from rest to sliding needs: a contact that may change, and a slip that is known.
   subroutine check_path(c)
      type(checks_t), intent(in) :: c
      logical :: has_path

      has_path = is_moved(c%values)
      call c%add(in%interaction, &
         & 'makes the contact shrink under a tangential force, but its radius is given; give load, approach or base_approach', &
         & has_path .and. c%has_any([in%contact_radius, in%face_angle]))
      call c%add(in%branch, 'has no meaning with interaction before sliding, which begins at the largest stable contact', &
         & has_path .and. .not. c%is_choice(in%branch, branch_stable))
      if (.not. c%is_above_zero(in%pressure_factor)) return
      call c%add(in%pressure_factor, &
         & 'has no interaction before sliding, for the slip at an edge of a stress that is not uniform is not known; allowed: 0', &
         & has_path)
      call c%add(in%critical_slip, &
         & 'has no meaning beside pressure_factor, with which the stress at the edge is not tau0; give slip_energy_ratio', &
         & c%has(in%critical_slip))
   end subroutine check_path

   !> Friction takes no more than there is of adhesion.
   subroutine check_share(c)
      type(checks_t), intent(in) :: c
      real(dp) :: ratio

      ratio = slip_energy_ratio_of(c%values(in%interaction:in%slip_energy_ratio), c%values(in%shear_strength), &
         & c%values(in%work_of_adhesion))
      if (ratio < huge(ratio)) call c%add(in%interaction, &
         & 'would take more work of adhesion than there is; allowed: a number <= 1 + 1/(2 g0) [-]', &
         & .not. is_valid_interaction(ratio, c%values(in%interaction)))
   end subroutine check_share

end module adfric_round_friction_check
