! SPDX-License-Identifier: GPL-3.0-or-later
!> Friction of `wavy_sliding` with a law of the interface, as a sum with what the columns lose. A shear stress does not move a column,
!> so that the contact is that of frictionless faces.
module adfric_foundation_interface
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set, unset
   use adfric_interface_attraction, only: attraction_t
   use adfric_interface_friction_law, only: friction_law_t
   use adfric_interface_friction_law_check, only: check_interface
   use adfric_interface_friction_law_rows, only: given_law_t, get_friction_law, i_pressure_volume, &
      & n_interface_rows, needs_temperature
   use adfric_interface_total_friction, only: get_shear_of_area, interface_tractions, near_ratios, sliding_friction_t
   use adfric_solid_shift_rows, only: time_temperature_of
   use adfric_solid_time_temperature, only: shift_none, time_temperature_t
   use adfric_describe_table, only: variable_t
   use adfric_foundation_case, only: dugdale_of
   use adfric_foundation_given_surface, only: given_surface_t
   use adfric_foundation_stepped_case, only: get_attraction, is_stepped
   use adfric_foundation_variables, only: in => foundation_input, out => foundation_output
   implicit none (type, external)
   private
   public :: interface_of, without_temperature, check_column_interface, add_column_interface, add_column_tractions

   !> Faces touch where the gap is no more than this share of the largest.
   real(dp), parameter :: touching = 1.0e-12_dp
   !> Position of the word in the choice of the slope.
   integer, parameter :: slope_finite = 2

contains

   !> The values of the interface.
   pure function interface_of(values) result(friction)
      !> Values of all variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      real(dp) :: friction(n_interface_rows)

      friction = values(in%friction)
   end function interface_of

   !> The foundation's own shift.
   pure type(time_temperature_t) function shift_of_columns(values, given)
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given

      shift_of_columns = time_temperature_of(values(in%shift:in%activation_energy), given%master_temperature)
   end function shift_of_columns

   !> The values without a temperature that is for the interface alone.
   pure function without_temperature(values, given) result(of_solid)
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      real(dp) :: of_solid(size(values))
      type(time_temperature_t) :: shift

      of_solid = values
      shift = shift_of_columns(values, given)
      if (shift%law == shift_none .and. needs_temperature(interface_of(values))) of_solid(in%temperature) = unset
   end function without_temperature

   !> The largest tension of adhesion [Pa]; times the area of adhesion it is the pull outside of contacts.
   pure real(dp) function tension_of(values, given)
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      type(attraction_t), allocatable :: attraction
      real(dp) :: law(in%range - in%stress + 1)

      tension_of = 0
      call get_attraction(values, given, attraction)
      if (allocated(attraction)) then
         tension_of = attraction%stress
      else
         law = dugdale_of(values)
         if (is_set(law(1))) tension_of = law(1)
      end if
   end function tension_of

   !> Add to `problems` what is wrong with the friction of the interface.
   subroutine check_column_interface(variables, values, given, given_law, problems)
      !> Table of the variables; their names stand in the messages.
      type(variable_t), intent(in) :: variables(:)
      !> Values in the order of `variables`, of which one of the interface is given; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      type(given_law_t), intent(in) :: given_law
      type(problems_t), intent(inout) :: problems

      call check_interface(variables, values, in%friction, [in%temperature, in%velocity], given_law, &
         & shift_of_columns(values, given), tension_of(values, given), problems)
      if (is_set(values(in%friction(i_pressure_volume)))) call problems%add('friction', &
         & variables(in%friction(i_pressure_volume))%name, 'is for half-spaces; on a foundation the law has no pressure')
      if (nint(values(in%slope)) == slope_finite) call problems%add(variables(in%slope)%group, variables(in%slope)%name, &
         & 'is finite; with friction of the interface it is small')
   end subroutine check_column_interface

   !> Add the interface to the friction of a point.
   pure subroutine add_column_interface(values, given, given_law, others, results, is_valid)
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      type(given_law_t), intent(in) :: given_law
      !> Results of the frictionless contact at the velocities of `near_ratios`; shape `(n_results, n_steps)`.
      real(dp), intent(in) :: others(:, :)
      !> In: results of the frictionless contact. Out: with both parts of the friction; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Does the law hold at this velocity and temperature?
      logical, intent(out) :: is_valid
      type(friction_law_t) :: law
      type(sliding_friction_t) :: friction
      real(dp) :: shear, unused
      logical :: is_solved
      integer :: k

      call get_friction_law(interface_of(values), given_law, shift_of_columns(values, given), law)
      friction%hysteretic = results(out%friction_force)
      friction%has_outer = .not. is_stepped(values)
      call get_shear(results, friction%interfacial, friction%interfacial_slope, is_valid)
      if (.not. is_valid) return
      friction%neighbours = not_a_number()
      do k = 1, size(near_ratios)
         if (.not. ieee_is_finite(others(out%friction_force, k))) cycle
         call get_shear(others(:, k), shear, unused, is_solved)
         friction%neighbours(k) = others(out%friction_force, k) + shear
      end do
      call friction%get_results(values(in%velocity), results(out%friction_force), &
         & results(out%hysteretic_friction_force:out%velocity_slope))
      ! a load that is as good as 0 has no coefficient
      if (ieee_is_finite(results(out%friction_coefficient))) results(out%friction_coefficient) = results(out%friction_force) &
         & /results(out%load)

   contains

      !> Shear of a contact.
      pure subroutine get_shear(contact, shear, slope, is_valid)
         real(dp), intent(in) :: contact(:)
         real(dp), intent(out) :: shear, slope
         logical, intent(out) :: is_valid

         call get_shear_of_area(law, values(in%velocity), values(in%temperature), contact(out%contact_area), &
            & contact(out%load) + tension_of(values, given)*contact(out%adhesion_area), shear, slope, is_valid)
      end subroutine get_shear

   end subroutine add_column_interface

   !> Add the shear stress of the interface to that of the pressure on the slopes.
   pure subroutine add_column_tractions(values, given, given_law, has_contact, profiles)
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      type(given_law_t), intent(in) :: given_law
      !> Does anything touch?
      logical, intent(in) :: has_contact
      !> Pressure and shear stress [Pa], displacement and gap [m]; shape `(n_x, n_y, 4)`.
      real(dp), intent(inout) :: profiles(:, :, :)
      type(friction_law_t) :: law

      call get_friction_law(interface_of(values), given_law, shift_of_columns(values, given), law)
      profiles(:, :, 2) = profiles(:, :, 2) + interface_tractions(law, values(in%velocity), values(in%temperature), &
         & profiles(:, :, 1), has_contact .and. profiles(:, :, 4) <= touching*maxval(profiles(:, :, 4)))
   end subroutine add_column_tractions

end module adfric_foundation_interface
