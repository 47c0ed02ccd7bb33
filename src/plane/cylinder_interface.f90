! SPDX-License-Identifier: GPL-3.0-or-later
!> Friction of a cylinder that slides over a viscoelastic half-plane with a law of the interface: the sum with what the solid loses.
module adfric_plane_cylinder_interface
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_unset, only: is_set
   use adfric_interface_friction_law, only: friction_law_t
   use adfric_interface_friction_law_rows, only: given_law_t, get_friction_law
   use adfric_interface_heat_rows, only: doubt_heat, h_bulk, h_contact, h_interface, has_heat, n_heat_results, &
      & velocity_that_heats
   use adfric_interface_total_friction, only: get_shear_of_area, interface_tractions, near_ratios, sliding_friction_t
   use adfric_plane_contact_shear, only: contact_nodes, integrate_shear, n_contact_nodes
   use adfric_plane_left_out_coupling, only: left_out_of_line, modulus_of_contact
   use adfric_plane_cylinder_heat, only: find_cylinder_temperature
   use adfric_plane_hertz_variables, only: in => hertz_input, out => hertz_output
   use adfric_plane_sliding_cylinder_point, only: cylinder_point_t
   use adfric_plane_sliding_cylinder_units, only: cylinder_slide_state_t, cylinder_slide_t, new_cylinder_slide
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_solid_spectrum_rows, only: poisson_ratio_of, shift_factor_of, solid_shift_of
   implicit none (type, external)
   private
   public :: add_cylinder_interface, set_cylinder_tractions, doubt_cylinder_heat, velocity_that_heats_cylinder

   !> Cells of a contact in which the largest temperature is looked for, where the heat goes with the pressure.
   integer, parameter :: n_fine = 400

contains

   !> The law of the interface.
   pure subroutine law_of_cylinder(values, spectrum, given, law)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: spectrum
      type(given_law_t), intent(in) :: given
      type(friction_law_t), intent(out) :: law

      call get_friction_law(values(in%friction), given, solid_shift_of(values(in%material(1):in%temperature), spectrum), law)
   end subroutine law_of_cylinder

   !> The temperature of the contact.
   pure subroutine set_temperature(values, law, point, temperature, results, is_valid)
      real(dp), intent(in) :: values(:)
      type(friction_law_t), intent(in) :: law
      type(cylinder_point_t), intent(in) :: point
      !> The temperature [K].
      real(dp), intent(out) :: temperature
      !> Receives the results of heat; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Is it known?
      logical, intent(out) :: is_valid
      real(dp) :: fine_pressure(n_fine)
      integer :: i

      temperature = values(in%temperature)
      is_valid = .true.
      if (.not. has_heat(values(in%heat))) return
      associate (slide => point%slide, contact => point%contact)
         fine_pressure = [(slide%pressure_at(contact, contact%contact_shift + contact%half_width*(2*i - 1 - n_fine)/n_fine), &
            & i=1, n_fine)]
         results(out%heat(h_bulk)) = abs(values(in%velocity)*contact%friction_force)
         call find_cylinder_temperature(values(in%heat), law, values(in%velocity), temperature, contact%half_width, &
            & node_pressures(slide, contact), fine_pressure, results(out%heat(1):out%heat(n_heat_results)), is_valid)
         if (.not. (is_valid .and. law%is_coulomb())) return
         ! of the work of a shear stress mu p the solid, which it cycles, loses mu^2 of what it loses by the pressure
         associate (by_shear => law%pressure_factor**2*results(out%heat(h_bulk)))
            results(out%heat(h_interface)) = results(out%heat(h_interface)) - by_shear
            results(out%heat(h_bulk)) = results(out%heat(h_bulk)) + by_shear
         end associate
      end associate
   end subroutine set_temperature

   !> A line on the velocity above which heat matters; nothing without heat.
   subroutine doubt_cylinder_heat(values, spectrum, given, half_width, text)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: spectrum
      type(given_law_t), intent(in) :: given
      !> Half-width of the contact, which has been solved [m].
      real(dp), intent(in) :: half_width
      character(:), allocatable, intent(out) :: text
      type(friction_law_t) :: law

      text = ''
      if (.not. (has_heat(values(in%heat)) .and. half_width > 0)) return
      call law_of_cylinder(values, spectrum, given, law)
      call doubt_heat(values(in%heat), law, values(in%temperature), half_width, text)
   end subroutine doubt_cylinder_heat

   !> Velocity from which on heat matters [m/s], or unset.
   real(dp) function velocity_that_heats_cylinder(values, spectrum, given, half_width) result(velocity)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: spectrum
      type(given_law_t), intent(in) :: given
      !> Half-width of the contact, which has been solved [m].
      real(dp), intent(in) :: half_width
      type(friction_law_t) :: law

      call law_of_cylinder(values, spectrum, given, law)
      velocity = velocity_that_heats(values(in%heat), law, values(in%temperature), half_width)
   end function velocity_that_heats_cylinder

   !> Add the interface to the friction of a sliding cylinder, and its heat.
   pure subroutine add_cylinder_interface(values, spectrum, given, point, results, is_valid)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: spectrum
      type(given_law_t), intent(in) :: given
      !> The point, which has been solved.
      type(cylinder_point_t), intent(in) :: point
      !> In: results of the solid. Out: with both parts of the friction; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Does the law hold at this velocity and temperature?
      logical, intent(out) :: is_valid
      type(friction_law_t) :: law
      type(sliding_friction_t) :: friction
      type(cylinder_slide_t) :: slide
      type(cylinder_slide_state_t) :: state
      real(dp) :: shear, unused, temperature
      logical :: is_solved
      integer :: k

      call law_of_cylinder(values, spectrum, given, law)
      call set_temperature(values, law, point, temperature, results, is_valid)
      if (.not. is_valid) return
      friction%direction = point%slide%direction
      friction%hysteretic = friction%direction*point%contact%friction_force
      call get_shear(values, law, temperature, point%slide, point%contact, friction%interfacial, friction%interfacial_slope, &
         & is_valid)
      if (.not. is_valid) return
      friction%neighbours = not_a_number()
      do k = 1, size(near_ratios)
         call new_cylinder_slide(slide, values(in%radius), point%prony, values(in%velocity)*near_ratios(k) &
            & *shift_factor_of(values(in%material(1):in%temperature), spectrum), is_solved)
         if (is_solved) is_solved = slide%suits_load(point%prony, values(in%load))
         if (.not. is_solved) cycle
         call slide%solve_load(values(in%load), state, is_solved)
         if (.not. is_solved) cycle
         call get_shear(values, law, temperature, slide, state, shear, unused, is_solved)
         friction%neighbours(k) = friction%direction*state%friction_force + shear
      end do
      call friction%store(values(in%velocity), values(in%load), results(out%friction_force), results(out%friction_coefficient), &
         & results(out%hysteretic_friction_force:out%velocity_slope))
      call add_left_out(values, law, spectrum, point, results)
   end subroutine add_cylinder_interface

   !> Add what the cylinder leaves out by a contact of frictionless faces.
   pure subroutine add_left_out(values, law, spectrum, point, results)
      real(dp), intent(in) :: values(:)
      type(friction_law_t), intent(in) :: law
      type(given_spectrum_t), intent(in) :: spectrum
      !> The point, which has been solved.
      type(cylinder_point_t), intent(in) :: point
      !> In: with the friction. Out: with what is left out; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)

      associate (state => point%contact, material => values(in%material(1):in%temperature))
         if (.not. (state%half_width > 0 .and. is_set(poisson_ratio_of(material)))) return
         results(out%coupling_left_out) = left_out_of_line(law, abs(values(in%velocity)), values(in%temperature), &
            & node_pressures(point%slide, state), state%half_width, 0.0_dp, poisson_ratio_of(material), &
            & modulus_of_contact(point%prony, abs(values(in%velocity))*shift_factor_of(material, spectrum), state%half_width), &
            & results(out%friction_force))
      end associate
   end subroutine add_left_out

   !> Pressure at the nodes of a contact [Pa].
   pure function node_pressures(slide, state) result(pressure)
      type(cylinder_slide_t), intent(in) :: slide
      type(cylinder_slide_state_t), intent(in) :: state
      real(dp) :: pressure(n_contact_nodes), x(n_contact_nodes)
      integer :: i

      x = contact_nodes(state%contact_shift, state%half_width)
      pressure = [(slide%pressure_at(state, x(i)), i=1, n_contact_nodes)]
   end function node_pressures

   !> Shear of a contact per length.
   pure subroutine get_shear(values, law, temperature, slide, state, shear, slope, is_valid)
      real(dp), intent(in) :: values(:)
      type(friction_law_t), intent(in) :: law
      !> Temperature of the contact [K].
      real(dp), intent(in) :: temperature
      type(cylinder_slide_t), intent(in) :: slide
      type(cylinder_slide_state_t), intent(in) :: state
      !> The shear [N/m], and its change by ln v in this contact.
      real(dp), intent(out) :: shear, slope
      logical, intent(out) :: is_valid

      if (.not. law%depends_on_pressure() .or. .not. state%half_width > 0) then
         call get_shear_of_area(law, abs(values(in%velocity)), temperature, 2*state%half_width, values(in%load), shear, slope, &
            & is_valid)
         return
      end if
      call integrate_shear(law, abs(values(in%velocity)), temperature, state%half_width, node_pressures(slide, state), shear, &
         & slope, is_valid)
   end subroutine get_shear

   !> Set the shear stress along x.
   pure subroutine set_cylinder_tractions(values, spectrum, given, results, pressure, shear)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: spectrum
      type(given_law_t), intent(in) :: given
      !> Results of the point; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> Pressure, 0 outside of contact [Pa]; shape `(n_x)`.
      real(dp), intent(in) :: pressure(:)
      !> Receives the shear stress [Pa]; shape `(n_x)`.
      real(dp), intent(out) :: shear(:)
      type(friction_law_t) :: law
      real(dp) :: temperature

      call law_of_cylinder(values, spectrum, given, law)
      temperature = values(in%temperature)
      if (has_heat(values(in%heat)) .and. .not. ieee_is_nan(results(out%heat(h_contact)))) &
         & temperature = results(out%heat(h_contact))
      shear = interface_tractions(law, values(in%velocity), temperature, pressure, pressure > 0)
   end subroutine set_cylinder_tractions

end module adfric_plane_cylinder_interface
