! SPDX-License-Identifier: GPL-3.0-or-later
!> The law of the interface's shear stress as an input gives it: rows of the group `friction`, behind those of the constant law
!> (`adfric_interface_shear_strength_rows`). Every model whose friction may depend on velocity and temperature has both in its table.
!>
!> The values of both sets of rows, one behind the other, are those of an interface.
module adfric_interface_friction_law_rows
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set, unset
   use adfric_interface_friction_law, only: friction_law_t, law_activated, law_bonds, law_constant, law_log_gaussian, law_power, &
      & law_table
   use adfric_interface_shear_strength_rows, only: n_shear_rows
   use adfric_interface_strength_table, only: new_strength_table
   use adfric_solid_shift_rows, only: set_shift_rows, time_temperature_of
   use adfric_solid_time_temperature, only: shift_none, time_temperature_t
   use adfric_describe_rows, only: above_zero, any_number, choice, columns_row, number, positive
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: given_law_t, set_law_rows, take_law_table, take_law_attribute, has_interface, law_of, has_law_of_speed
   public :: get_friction_law, needs_temperature
   public :: n_law_rows, n_interface_rows, words_of_law
   public :: i_strength, i_pressure_factor, i_law, i_barrier_power, i_pressure_volume, i_table, i_shift, i_reference, i_energy

   !> Indices among the values of an interface: the two rows of the constant law, then the others.
   integer, parameter :: i_strength = 1, i_pressure_factor = 2, i_law = 3, i_reference_velocity = 4, i_exponent = 5, &
      & i_shear_volume = 6, i_pressure_volume = 7, i_attempt_velocity = 8, i_barrier_power = 9, i_bond_strength = 10, &
      & i_bond_velocity = 11, i_rest_ratio = 12, i_hazard = 13, i_peak = 14, i_peak_velocity = 15, i_width_factor = 16, &
      & i_table = 17, i_shift = 18, i_reference = 19, i_c1 = 20, i_c2 = 21, i_energy = 22
   !> Numbers of the values of an interface, and of those rows of which this file has the table.
   integer, parameter :: n_interface_rows = i_energy, n_law_rows = n_interface_rows - n_shear_rows
   !> The laws, in the order of `adfric_interface_friction_law`.
   character(*), parameter :: laws = 'shear_strength power activated bonds log_gaussian table'
   !> Of each value the laws that it belongs to; in front of what a law needs stands `+`.
   character(*), parameter :: words_of_law(n_interface_rows) = [character(70) :: &
      & '+shear_strength +power', &
      & 'shear_strength power bonds log_gaussian table', &
      & laws, &
      & '+power', &
      & '+power', &
      & '+activated', &
      & 'activated', &
      & '+activated', &
      & 'activated', &
      & '+bonds', &
      & '+bonds', &
      & '+bonds', &
      & '+bonds', &
      & '+log_gaussian', &
      & '+log_gaussian', &
      & '+log_gaussian', &
      & '+table', &
      & 'power bonds log_gaussian table', &
      & 'power bonds log_gaussian table', &
      & 'power bonds log_gaussian table', &
      & 'power bonds log_gaussian table', &
      & '+activated power bonds log_gaussian table']
   !> The first word of `shift`: as the solid.
   integer, parameter :: shift_as_material = 1

   !> What an input gives of the law beside single numbers.
   type :: given_law_t
      !> Velocity [m/s] and shear stress [Pa] of a table; shape `(n, 2)`; not allocated without one.
      real(dp), allocatable :: velocity_table(:, :)
      !> Temperature of the table [K], or unset.
      real(dp) :: temperature = unset
   end type given_law_t

contains

   !> The rows, in the group `friction`.
   subroutine set_law_rows(rows)
      !> Receives the rows; shape `(n_law_rows)`.
      type(variable_t), intent(out) :: rows(:)
      character(*), parameter :: group = 'friction'
      type(variable_t) :: all_rows(n_interface_rows)

      all_rows(i_law) = choice(group=group, name='law', choices=laws, &
         & meaning='law of the shear stress in contact over velocity and temperature; shear_strength if not given')
      all_rows(i_reference_velocity) = positive(group=group, name='reference_velocity', unit='m/s', &
         & meaning='v0 of the law power, tau0 (v a_T/v0)^n')
      all_rows(i_exponent) = any_number(group=group, name='velocity_exponent', unit='-', meaning='n of the law power', &
         & lower=0.0_dp, upper=1.0_dp)
      all_rows(i_shear_volume) = above_zero(group=group, name='shear_activation_volume', unit='m^3', &
         & meaning='phi of the law activated: its barrier over the shear stress that removes it')
      all_rows(i_pressure_volume) = any_number(group=group, name='pressure_activation_volume', unit='m^3', &
         & meaning='Om of the law activated, by which the pressure raises the barrier; 0 if not given', lower=0.0_dp)
      all_rows(i_attempt_velocity) = positive(group=group, name='attempt_velocity', unit='m/s', &
         & meaning='v0 of the law activated, where thermal motion no longer helps; velocities are at most as large')
      all_rows(i_barrier_power) = any_number(group=group, name='barrier_power', unit='-', &
         & meaning='power of the stress with which the barrier falls: 1 (Eyring, if not given), or 1.5 (Prandtl and Tomlinson)', &
         & lower=1.0_dp, upper=1.5_dp)
      all_rows(i_barrier_power)%has_steps = .true.
      all_rows(i_bond_strength) = number(group=group, name='bond_strength', unit='Pa', &
         & meaning='of the law bonds: stress of slow sliding over v/bond_velocity', lower=0.0_dp)
      all_rows(i_bond_velocity) = positive(group=group, name='bond_velocity', unit='m/s', &
         & meaning='of the law bonds: length over life of a bond')
      all_rows(i_rest_ratio) = any_number(group=group, name='rest_ratio', unit='-', &
         & meaning='of the law bonds: time between two bonds of a site over the life of a bond', lower=0.0_dp, upper=1.0e30_dp)
      all_rows(i_hazard) = choice(group=group, name='hazard', choices='constant exponential', &
         & meaning='of the law bonds: the same at every stretch up to the length of a bond (constant), or growing with it')
      all_rows(i_peak) = number(group=group, name='peak_shear_strength', unit='Pa', &
         & meaning='tau_p of the law log_gaussian, tau_p exp(-c [log10(v a_T/v_p)]^2)', lower=0.0_dp)
      all_rows(i_peak_velocity) = positive(group=group, name='peak_velocity', unit='m/s', meaning='v_p of the law log_gaussian')
      all_rows(i_width_factor) = any_number(group=group, name='log_width_factor', unit='-', &
         & meaning='c of the law log_gaussian', lower=0.0_dp, upper=1.0e30_dp)
      all_rows(i_table) = columns_row(group=group, name='velocity_table', columns='velocity shear_strength', units='m/s Pa', &
         & meaning='group with the shear stress over the velocity, for the law table', least_count=2, &
         & attributes='reference_temperature', attribute_units='K')
      call set_shift_rows(group, all_rows(i_shift:))
      all_rows(i_shift)%choices = 'material '//all_rows(i_shift)%choices
      all_rows(i_shift)%meaning = 'law by which temperature changes the velocities of the law; that of the solid if not given'
      all_rows(i_reference)%meaning = 'temperature at which the velocities hold; that of the table if not given'
      all_rows(i_energy)%meaning = 'barrier Q of the law activated, or activation energy of shift = ''arrhenius'''
      all_rows(i_shift:)%has_bare_name = .false.
      rows = all_rows(n_shear_rows + 1:)
   end subroutine set_law_rows

   !> Keep the table; nothing of another variable.
   subroutine take_law_table(given, index, values)
      !> Receives the table.
      class(given_law_t), intent(inout) :: given
      !> Index of the variable among the rows of `set_law_rows`.
      integer, intent(in) :: index
      !> The values in SI units; shape `(n, 2)`.
      real(dp), intent(in) :: values(:, :)

      if (index == i_table - n_shear_rows) given%velocity_table = values
   end subroutine take_law_table

   !> Keep the temperature that the table says of itself; nothing of another variable.
   subroutine take_law_attribute(given, row, index, name, value, problems)
      !> Receives the temperature.
      class(given_law_t), intent(inout) :: given
      !> Row of the variable; its name is part of the message.
      type(variable_t), intent(in) :: row
      !> Index of the variable among the rows of `set_law_rows`.
      integer, intent(in) :: index
      !> Name of the attribute.
      character(*), intent(in) :: name
      !> Its value [K].
      real(dp), intent(in) :: value
      !> Receives what is wrong with it.
      type(problems_t), intent(inout) :: problems

      if (index /= i_table - n_shear_rows) return
      given%temperature = value
      if (.not. value > 0) call problems%add(row%group, row%name, 'has an attribute '//name//' that is not > 0')
   end subroutine take_law_attribute

   !> Is there friction of the interface?
   pure logical function has_interface(values)
      !> Values of an interface; shape `(n_interface_rows)`.
      real(dp), intent(in) :: values(:)

      has_interface = any(is_set(values))
   end function has_interface

   !> Which law is it, one of `law_...`?
   pure integer function law_of(values)
      !> Values of an interface; shape `(n_interface_rows)`.
      real(dp), intent(in) :: values(:)

      law_of = law_constant
      if (is_set(values(i_law))) law_of = nint(values(i_law))
   end function law_of

   !> Is the law one of the velocity?
   pure logical function has_law_of_speed(values)
      !> Values of an interface; shape `(n_interface_rows)`.
      real(dp), intent(in) :: values(:)

      has_law_of_speed = law_of(values) /= law_constant
   end function has_law_of_speed

   !> Does the law need a temperature, whatever the solid does?
   pure logical function needs_temperature(values)
      !> Values of an interface; shape `(n_interface_rows)`.
      real(dp), intent(in) :: values(:)
      type(time_temperature_t) :: none

      needs_temperature = law_of(values) == law_activated
      if (needs_temperature .or. .not. is_set(values(i_shift))) return
      if (nint(values(i_shift)) == shift_as_material) return
      none = time_temperature_of([values(i_shift) - 1, values(i_reference:)], unset)
      needs_temperature = none%law /= shift_none
   end function needs_temperature

   !> The law that checked values say.
   pure subroutine get_friction_law(values, given, of_solid, law)
      !> Values of an interface; shape `(n_interface_rows)`.
      real(dp), intent(in) :: values(:)
      !> The table of the input.
      class(given_law_t), intent(in) :: given
      !> The solid's own shift, or a default one.
      type(time_temperature_t), intent(in) :: of_solid
      !> Receives the law.
      type(friction_law_t), intent(out) :: law

      law%law = law_of(values)
      if (is_set(values(i_pressure_factor))) law%pressure_factor = values(i_pressure_factor)
      select case (law%law)
      case (law_constant)
         law%strength = values(i_strength)
      case (law_power)
         law%strength = values(i_strength)
         law%velocity = values(i_reference_velocity)
         law%exponent = values(i_exponent)
      case (law_activated)
         law%velocity = values(i_attempt_velocity)
         law%activation_energy = values(i_energy)
         law%shear_volume = values(i_shear_volume)
         if (is_set(values(i_pressure_volume))) law%pressure_volume = values(i_pressure_volume)
         if (is_set(values(i_barrier_power))) law%is_curved = values(i_barrier_power) > 1
      case (law_bonds)
         law%strength = values(i_bond_strength)
         law%velocity = values(i_bond_velocity)
         law%exponent = values(i_rest_ratio)
         law%hazard = nint(values(i_hazard))
      case (law_log_gaussian)
         law%strength = values(i_peak)
         law%velocity = values(i_peak_velocity)
         law%exponent = values(i_width_factor)
      case (law_table)
         call new_strength_table(law%table, given%velocity_table(:, 1), given%velocity_table(:, 2))
      end select
      if (any(law%law == [law_constant, law_activated])) return
      law%shift = of_solid
      if (.not. is_set(values(i_shift))) return
      if (nint(values(i_shift)) == shift_as_material) return
      law%shift = time_temperature_of([values(i_shift) - 1, values(i_reference:)], given%temperature)
   end subroutine get_friction_law

end module adfric_interface_friction_law_rows
