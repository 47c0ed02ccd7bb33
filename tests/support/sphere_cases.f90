! SPDX-License-Identifier: GPL-3.0-or-later
!> Values of the model `sphere` as an input would give them.
module sphere_cases
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_unset, only: unset
   use adfric_round_sphere_model, only: sphere_model_t, new_sphere_model
   use adfric_round_sphere_variables, only: state_sliding, units_reduced, units_si, in => sphere_input, out => sphere_output
   use model_calls, only: find_problems, solve_values, solve_point
   implicit none (type, external)
   private
   public :: new_tip, new_reduced, slide, hold, add_friction, find_problems, solve_values, solve_point
   public :: theory_word, controls, prescribed, lengths, approaches, forces, unit_of, is_same_number

   !> What can be held, as variables and as results.
   integer, parameter :: controls(*) = [in%load, in%approach, in%contact_radius]
   integer, parameter :: prescribed(*) = [out%load, out%approach, out%contact_radius]

   !> Units of the results; the others are areas, energies, a stiffness and pure numbers.
   integer, parameter :: lengths(*) = [out%contact_radius, out%adhesion_radius, out%friction_radius, out%stick_radius]
   integer, parameter :: approaches(*) = [out%approach, out%slip, out%largest_slip, out%tangential_displacement, &
      out%peak_displacement, out%snap_off_displacement, out%jump_base_displacement, out%jump_displacement, out%jump_period]
   integer, parameter :: forces(*) = [out%load, out%friction_force, out%pull_off_load, out%peak_force, out%sliding_force, &
      out%force_drop, out%snap_off_force, out%jump_force, out%arrest_force]

contains

   !> The tip of Johnson's Fig. 5 in SI: Maugis-Dugdale, lambda = 0.8, no friction, no load.
   subroutine new_tip(model, values)
      type(sphere_model_t), intent(out) :: model
      real(dp), allocatable, intent(out) :: values(:)

      call new_sphere_model(model)
      values = model%variables%default
      values(in%units) = units_si
      values([in%radius, in%contact_modulus, in%work_of_adhesion]) = [140.0e-9_dp, 44.0e9_dp, 0.19_dp]
      values(in%lambda) = 0.8_dp
      values(in%load) = 0
      values(in%theory) = theory_word('maugis_dugdale')
   end subroutine new_tip

   !> The same in reduced units.
   subroutine new_reduced(model, values)
      type(sphere_model_t), intent(out) :: model
      real(dp), allocatable, intent(out) :: values(:)

      call new_tip(model, values)
      values(in%units) = units_reduced
      values([in%radius, in%contact_modulus, in%work_of_adhesion]) = unset
   end subroutine new_reduced

   !> Let it slide, with interaction.
   pure subroutine slide(values, strength, interaction, slip_energy_ratio)
      real(dp), intent(inout) :: values(:)
      real(dp), intent(in) :: strength, interaction, slip_energy_ratio

      values(in%state) = state_sliding
      values(in%shear_strength) = strength
      values(in%interaction) = interaction
      values(in%slip_energy_ratio) = slip_energy_ratio
   end subroutine slide

   !> Hold one quantity.
   pure subroutine hold(values, control, number)
      real(dp), intent(inout) :: values(:)
      !> One of `controls`.
      integer, intent(in) :: control
      real(dp), intent(in) :: number

      values(controls) = unset
      values(control) = number
   end subroutine hold

   !> Friction of the kind 1: none, 2: static without force, 3: static under a force, 4: under a displacement, 5: sliding,
   !> 6: sliding with interaction. In the units of `values`.
   pure subroutine add_friction(values, kind)
      real(dp), intent(inout) :: values(:)
      integer, intent(in) :: kind
      real(dp) :: stress_unit

      if (kind == 1) return
      stress_unit = 1
      if (nint(values(in%units)) == units_si) stress_unit = unit_of(out%load, values)/(2*unit_of(out%contact_radius, values)**2)
      values([in%shear_strength, in%poisson_ratio]) = [0.6_dp*stress_unit, 0.3_dp]
      if (kind == 3) values(in%tangential_force) = 0.4_dp
      if (kind == 4) values(in%tangential_displacement) = 0.3_dp
      if (nint(values(in%units)) == units_si) then
         if (kind == 3) values(in%tangential_force) = 0.4_dp*unit_of(out%load, values)
         if (kind == 4) values(in%tangential_displacement) = 0.3_dp*unit_of(out%approach, values)
      end if
      if (kind >= 5) values(in%state) = state_sliding
      if (kind == 6) values([in%interaction, in%slip_energy_ratio]) = [0.3_dp, 1.2_dp]
   end subroutine add_friction

   !> Position of a theory among the words of the input.
   pure integer function theory_word(name)
      character(*), intent(in) :: name
      character(14), parameter :: names(*) = [character(14) :: 'auto', 'hertz', 'jkr', 'dmt', 'maugis_dugdale']

      theory_word = findloc(names == name, .true., 1)
   end function theory_word

   !> Unit of a result by J 2.11, written out.
   pure real(dp) function unit_of(position, values) result(unit)
      integer, intent(in) :: position
      real(dp), intent(in) :: values(:)

      associate (r => values(in%radius), e => values(in%contact_modulus), w => values(in%work_of_adhesion))
         unit = 1
         if (any(lengths == position)) unit = (3*pi*w*r**2/(4*e))**(1.0_dp/3)
         if (any(approaches == position)) unit = (9*pi**2*w**2*r/(16*e**2))**(1.0_dp/3)
         if (any(forces == position)) unit = pi*w*r
         if (any([out%jump_energy, out%period_work] == position)) unit = pi*w*r*(9*pi**2*w**2*r/(16*e**2))**(1.0_dp/3)
         if (any([out%critical_lateral_stiffness, out%contact_stiffness] == position)) &
            & unit = pi*w*r/(9*pi**2*w**2*r/(16*e**2))**(1.0_dp/3)
         if (any([out%contact_area, out%friction_area] == position)) unit = (3*pi*w*r**2/(4*e))**(2.0_dp/3)
      end associate
   end function unit_of

   !> Are both NaN, or both numbers and, relative to the larger of the first and a least value, next to each other?
   elemental logical function is_same_number(a, b, relative, least_value)
      real(dp), intent(in) :: a, b
      real(dp), intent(in) :: relative, least_value

      is_same_number = ieee_is_nan(a) .eqv. ieee_is_nan(b)
      if (ieee_is_nan(a) .or. ieee_is_nan(b)) return
      is_same_number = ieee_is_finite(a) .and. ieee_is_finite(b)
      if (is_same_number) is_same_number = abs(a - b) <= relative*max(abs(a), least_value)
   end function is_same_number

end module sphere_cases
