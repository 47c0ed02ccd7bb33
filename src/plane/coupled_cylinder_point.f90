! SPDX-License-Identifier: GPL-3.0-or-later
!> One point of a rigid cylinder that slides over an elastic half-plane with a law of the interface, from the values of a namelist to
!> results and profiles. With `coupling` the shear stress moves the contact; else it is Hertz's.
module adfric_plane_coupled_cylinder_point
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_unset, only: is_set, unset
   use adfric_interface_friction_law, only: friction_law_t, law_constant
   use adfric_interface_friction_law_rows, only: given_law_t, get_friction_law
   use adfric_interface_heat_rows, only: h_bulk, has_heat, n_heat_results
   use adfric_interface_shear_coupling, only: is_coupled
   use adfric_interface_total_friction, only: coupling_of, get_shear_of_area, interface_tractions, near_ratios, sliding_friction_t
   use adfric_plane_contact_shear, only: contact_nodes, integrate_shear, n_contact_nodes
   use adfric_plane_cylinder_heat, only: find_cylinder_temperature
   use adfric_plane_left_out_coupling, only: left_out_of_line
   use adfric_plane_hertz_variables, only: in => hertz_input, out => hertz_output
   use adfric_plane_coupled_line, only: coupled_cylinder, coupled_cylinder_t
   use adfric_plane_sliding_coupling, only: error_of_cut
   use adfric_solid_contact_modulus, only: contact_modulus_of
   use adfric_solid_time_temperature, only: time_temperature_t
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_status, only: status_solved, status_not_converged
   implicit none (type, external)
   private
   public :: coupled_cylinder_point_t, solve_coupled_cylinder, get_coupled_cylinder_profiles

   !> What the closed forms leave of the digits.
   real(dp), parameter :: closed_form = 100*epsilon(1.0_dp)
   !> Cells of a contact in which the largest temperature is looked for, where the heat goes with the pressure.
   integer, parameter :: n_fine = 400

   !> The contact of a point.
   type, extends(point_state_t) :: coupled_cylinder_point_t
      !> The contact.
      type(coupled_cylinder_t) :: contact
      !> Its temperature [K], or unset.
      real(dp) :: temperature = unset
   end type coupled_cylinder_point_t

contains

   !> The law of the interface.
   pure subroutine law_of_cylinder(values, given, law)
      real(dp), intent(in) :: values(:)
      type(given_law_t), intent(in) :: given
      type(friction_law_t), intent(out) :: law
      type(time_temperature_t) :: none

      call get_friction_law(values(in%friction), given, none, law)
   end subroutine law_of_cylinder

   !> Solve a point.
   pure subroutine solve_coupled_cylinder(values, given, state, results, error_estimate, status)
      real(dp), intent(in) :: values(:)
      type(given_law_t), intent(in) :: given
      !> Receives the contact.
      type(coupled_cylinder_point_t), intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the main result [-]; of a constant shear stress the length where the gap is below 0.
      real(dp), intent(out) :: error_estimate
      !> Status of the point, one of `status_...`.
      integer, intent(out) :: status
      type(friction_law_t) :: law
      real(dp) :: stress, speed, slope, warm(size(values))
      logical :: is_valid

      error_estimate = closed_form
      status = status_not_converged
      speed = abs(values(in%velocity))
      call law_of_cylinder(values, given, law)
      call find_contact(values, law, speed, state%contact, stress, is_valid)
      if (.not. is_valid) return
      status = status_solved
      associate (contact => state%contact)
         results([out%load, out%half_width, out%peak_pressure]) = [values(in%load), contact%half_width, contact%peak_pressure]
         results([out%contact_area, out%violation]) = [2*contact%half_width, 0.0_dp]
         results(out%energy_imbalance) = 0
         if (is_coupled(values(in%coupling))) then
            results(out%largest_coupling) = law%pressure_factor*coupling_of(values(in%poisson_ratio))
            results(out%smallest_stiffness_ratio) = cos(atan(results(out%largest_coupling)))
         end if
         if (contact%half_width > 0) then
            if (stress > 0) error_estimate = max(error_estimate, error_of_cut(stress, contact%peak_pressure))
            ! the length where the gap would be below 0 is longer than the contact
            if (.not. error_estimate <= 1) status = status_not_converged
            results(out%mean_pressure) = values(in%load)/(2*contact%half_width)
            results(out%contact_shift) = sign(1.0_dp, values(in%velocity))*contact%centre
            slope = max(abs(contact%slope_friction), abs(contact%friction_of_energy))
            if (slope > 0) results(out%energy_imbalance) = (contact%slope_friction - contact%friction_of_energy)/slope
         end if
      end associate
      is_valid = status == status_solved
      state%temperature = values(in%temperature)
      if (is_valid .and. has_heat(values(in%heat))) call find_temperature(values, law, state, results, is_valid)
      warm = values
      warm(in%temperature) = state%temperature
      if (is_valid) call store_friction(warm, law, state%contact, results, is_valid)
      if (.not. is_valid) then
         status = status_not_converged
         results(:) = not_a_number()
         error_estimate = 0
         return
      end if
      if (is_coupled(values(in%coupling)) .or. is_set(values(in%second_young_modulus))) return
      if (values(in%load) > 0) results(out%coupling_left_out) = left_out_of_line(law, speed, state%temperature, &
         & node_pressures(state%contact), state%contact%half_width, 0.0_dp, values(in%poisson_ratio), state%contact%modulus, &
         & results(out%friction_force))
   end subroutine solve_coupled_cylinder

   !> The temperature of the contact, and the results of heat.
   pure subroutine find_temperature(values, law, state, results, is_valid)
      real(dp), intent(in) :: values(:)
      type(friction_law_t), intent(in) :: law
      !> In: the contact, and the temperature without heat. Out: with its own temperature.
      type(coupled_cylinder_point_t), intent(inout) :: state
      !> Receives the heat; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Is it known?
      logical, intent(out) :: is_valid
      real(dp) :: fine_pressure(n_fine)
      integer :: i

      associate (contact => state%contact)
         fine_pressure = [(contact%cylinder_pressure_at(contact%centre + contact%half_width*(2*i - 1 - n_fine)/n_fine), &
            & i=1, n_fine)]
         results(out%heat(h_bulk)) = 0
         call find_cylinder_temperature(values(in%heat), law, values(in%velocity), state%temperature, contact%half_width, &
            & node_pressures(contact), fine_pressure, results(out%heat(1):out%heat(n_heat_results)), is_valid)
      end associate
   end subroutine find_temperature

   !> The contact at a speed.
   pure subroutine find_contact(values, law, speed, contact, stress, is_valid)
      real(dp), intent(in) :: values(:)
      type(friction_law_t), intent(in) :: law
      !> Speed [m/s], which counts for the law.
      real(dp), intent(in) :: speed
      type(coupled_cylinder_t), intent(out) :: contact
      !> beta times the shear stress without what goes with the pressure [Pa]; 0 without coupling.
      real(dp), intent(out) :: stress
      !> Does the law hold?
      logical, intent(out) :: is_valid
      real(dp) :: beta, slope

      stress = 0
      beta = 0
      is_valid = .true.
      if (is_coupled(values(in%coupling))) then
         beta = coupling_of(values(in%poisson_ratio))
         call law%get_stress(speed, 0.0_dp, values(in%temperature), stress, slope, is_valid)
         stress = beta*stress
      end if
      if (is_valid) contact = coupled_cylinder(beta*law%pressure_factor, stress, values(in%radius), &
         & contact_modulus_of(values(in%contact_modulus:in%second_poisson_ratio)), values(in%load))
   end subroutine find_contact

   !> Friction of a contact, and its change with the velocity.
   pure subroutine store_friction(values, law, contact, results, is_valid)
      real(dp), intent(in) :: values(:)
      type(friction_law_t), intent(in) :: law
      type(coupled_cylinder_t), intent(in) :: contact
      !> Receives the friction; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Does the law hold?
      logical, intent(out) :: is_valid
      type(sliding_friction_t) :: friction
      type(coupled_cylinder_t) :: other
      real(dp) :: speed, shear, unused
      integer :: k
      logical :: is_solved

      speed = abs(values(in%velocity))
      friction%direction = sign(1.0_dp, values(in%velocity))
      friction%hysteretic = contact%slope_friction
      call get_shear(values, law, speed, contact, friction%interfacial, unused, is_valid)
      if (.not. is_valid) return
      friction%neighbours = 0
      if (law%law /= law_constant) then
         friction%neighbours = not_a_number()
         do k = 1, size(near_ratios)
            call find_contact(values, law, speed*near_ratios(k), other, unused, is_solved)
            if (is_solved) call get_shear(values, law, speed*near_ratios(k), other, shear, unused, is_solved)
            if (is_solved) friction%neighbours(k) = other%slope_friction + shear
         end do
      end if
      call friction%store(values(in%velocity), values(in%load), results(out%friction_force), results(out%friction_coefficient), &
         & results(out%hysteretic_friction_force:out%velocity_slope))
   end subroutine store_friction

   !> Pressure at the nodes of a contact [Pa].
   pure function node_pressures(contact) result(pressure)
      type(coupled_cylinder_t), intent(in) :: contact
      real(dp) :: pressure(n_contact_nodes), x(n_contact_nodes)
      integer :: i

      x = contact_nodes(contact%centre, contact%half_width)
      pressure = [(contact%cylinder_pressure_at(x(i)), i=1, n_contact_nodes)]
   end function node_pressures

   !> Shear of a contact per length.
   pure subroutine get_shear(values, law, speed, contact, shear, slope, is_valid)
      real(dp), intent(in) :: values(:)
      type(friction_law_t), intent(in) :: law
      !> Speed [m/s].
      real(dp), intent(in) :: speed
      type(coupled_cylinder_t), intent(in) :: contact
      !> The shear [N/m], and its change by ln v in this contact.
      real(dp), intent(out) :: shear, slope
      logical, intent(out) :: is_valid

      if (law%depends_on_pressure() .and. contact%half_width > 0) then
         call integrate_shear(law, speed, values(in%temperature), contact%half_width, node_pressures(contact), shear, slope, &
            & is_valid)
      else
         call get_shear_of_area(law, speed, values(in%temperature), 2*contact%half_width, values(in%load), shear, slope, is_valid)
      end if
   end subroutine get_shear

   !> Pressure and gap along x, and with a third profile the shear stress.
   pure subroutine get_coupled_cylinder_profiles(values, given, state, x, profiles)
      real(dp), intent(in) :: values(:)
      type(given_law_t), intent(in) :: given
      type(coupled_cylinder_point_t), intent(in) :: state
      !> Distances from the lowest line [m]; shape `(n_x)`.
      real(dp), intent(in) :: x(:)
      !> Pressure [Pa], gap [m] and shear stress [Pa], the same along the lines; shape `(n_x, n_y, 3)`.
      real(dp), intent(inout) :: profiles(:, :, :)
      type(friction_law_t) :: law
      real(dp) :: position
      integer :: i

      do i = 1, size(x)
         position = sign(1.0_dp, values(in%velocity))*x(i)
         profiles(i, :, 1) = state%contact%cylinder_pressure_at(position)
         profiles(i, :, 2) = state%contact%cylinder_gap_at(position)
      end do
      call law_of_cylinder(values, given, law)
      profiles(:, :, 3) = interface_tractions(law, values(in%velocity), state%temperature, profiles(:, :, 1), &
         & profiles(:, :, 1) > 0)
   end subroutine get_coupled_cylinder_profiles

end module adfric_plane_coupled_cylinder_point
