! SPDX-License-Identifier: GPL-3.0-or-later
!> Friction of a round body that slides by a law of velocity and temperature. In all of the contact the law has one value, but for what
!> goes with the pressure: so it is that of a shear strength, which the law gives. What an activation volume of the pressure adds is
!> integrated by `adfric_round_pressure_law`.
module adfric_round_velocity_law
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set, unset
   use adfric_interface_friction_law, only: friction_law_t
   use adfric_interface_friction_law_check, only: check_interface
   use adfric_interface_friction_law_rows, only: given_law_t, get_friction_law, i_law, i_pressure_volume, &
      & n_interface_rows, n_law_rows, needs_temperature, set_law_rows
   use adfric_round_contact_heat, only: check_contact_heat, has_contact_heat
   use adfric_round_variables, only: law_peeling, law_shear_strength, state_sliding, in => indenter_input
   use adfric_solid_time_temperature, only: time_temperature_t
   use adfric_describe_check, only: checks_t, new_checks
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: has_velocity_law, is_in_motion, check_velocity_law, law_of_contact, take_strength, law_row_of

   !> Indices of the interface in the table.
   integer, parameter :: of_interface(n_interface_rows) = [in%shear_strength, in%pressure_factor, in%law, in%velocity_law]

contains

   !> Values of the interface, whose laws count without that of peeling.
   pure function interface_of(values) result(friction)
      real(dp), intent(in) :: values(:)
      real(dp) :: friction(n_interface_rows)

      friction = values(of_interface)
      if (nint(values(in%law)) >= law_peeling) friction(i_law) = values(in%law) - 1
   end function interface_of

   !> Is there a law of the velocity?
   pure logical function has_velocity_law(values)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      ! the words behind that of peeling
      has_velocity_law = nint(values(in%law)) > law_peeling
   end function has_velocity_law

   !> Does the body slide at a velocity, by a law or for its heat?
   pure logical function is_in_motion(values)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      is_in_motion = has_velocity_law(values) .or. has_contact_heat(values)
   end function is_in_motion

   !> Index among the rows of the law; of another variable one that no row of a table has.
   pure integer function law_row_of(index) result(row)
      !> Index in the table.
      integer, intent(in) :: index

      row = index - in%velocity_law(1) + 2
   end function law_row_of

   !> Add to `problems` what is wrong with the law, its velocity and its temperature.
   subroutine check_velocity_law(variables, values, given, problems)
      !> Table of the variables; their names stand in the messages.
      type(variable_t), intent(in), target :: variables(:)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in), target :: values(:)
      !> The table of the law.
      type(given_law_t), intent(in) :: given
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout), target :: problems
      type(variable_t), allocatable :: table(:)
      type(variable_t) :: rows(n_law_rows)
      type(time_temperature_t) :: none
      real(dp) :: numbers(size(values))
      type(checks_t) :: c

      call new_checks(c, variables, values, problems)
      call check_contact_heat(variables, values, problems)
      if (.not. has_velocity_law(values)) then
         call c%refuse(in%velocity_law, 'has no meaning for this law of friction')
         if (has_contact_heat(values)) return
         call c%refuse([in%velocity], 'has no meaning without a law of the velocity in &friction; ' &
            & //'a constant shear strength is the same at all velocities')
         call c%refuse([in%temperature], 'has no meaning without a law of the velocity in &friction')
         return
      end if
      call set_law_rows(rows)
      table = variables
      table(in%law)%choices = rows(1)%choices
      numbers = values
      numbers(of_interface) = interface_of(values)
      call check_interface(table, numbers, of_interface, [in%temperature, in%velocity], given, none, 0.0_dp, problems)
      if (.not. (needs_temperature(interface_of(values)) .or. has_contact_heat(values))) call c%refuse([in%temperature], &
         & 'has no meaning for this law of friction without shift')
      if (.not. is_set(values(of_interface(i_pressure_volume))) .or. .not. values(of_interface(i_pressure_volume)) > 0) return
      if (is_set(values(in%interaction)) .and. values(in%interaction) > 0) call c%add(of_interface(i_pressure_volume), &
         & 'stands beside interaction, with which the contact has one shear stress')
      if (has_contact_heat(values)) call c%add(of_interface(i_pressure_volume), &
         & 'stands beside &heat, for which a round contact has one shear stress')
   end subroutine check_velocity_law

   !> The law of a body that is in motion.
   pure subroutine law_of_contact(values, given, law)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> The table of the law.
      type(given_law_t), intent(in) :: given
      !> Receives the law.
      type(friction_law_t), intent(out) :: law
      type(time_temperature_t) :: none

      call get_friction_law(interface_of(values), given, none, law)
   end subroutine law_of_contact

   !> The values of a body in motion, against the shear strength of the law at a temperature; at rest those that are given.
   pure subroutine take_strength(values, given, temperature, constant, slope, is_valid)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> The table of the law.
      type(given_law_t), intent(in) :: given
      !> Temperature of the contact [K], or unset.
      real(dp), intent(in) :: temperature
      !> Receives the values with a constant shear strength [Pa]; shape `(n_variables)`.
      real(dp), intent(out) :: constant(:)
      !> d ln/d ln v of this strength [-].
      real(dp), intent(out) :: slope
      !> Does the law hold at this velocity and temperature?
      logical, intent(out) :: is_valid
      type(friction_law_t) :: law

      constant = values
      slope = 0
      is_valid = .true.
      if (.not. is_in_motion(values)) return
      call law_of_contact(values, given, law)
      law%pressure_factor = 0
      constant(in%velocity_law) = unset
      constant([in%temperature, in%velocity, in%heat]) = unset
      constant(in%law) = law_shear_strength
      constant(in%state) = state_sliding
      call law%get_stress(abs(values(in%velocity)), 0.0_dp, temperature, constant(in%shear_strength), slope, is_valid)
   end subroutine take_strength

end module adfric_round_velocity_law
