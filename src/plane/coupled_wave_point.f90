! SPDX-License-Identifier: GPL-3.0-or-later
!> One point of `wave_1d` that slides on an elastic half-plane whose contact is moved by the shear stress, from the values of a namelist
!> to results and profiles.
module adfric_plane_coupled_wave_point
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, two_pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_unset, only: is_set
   use adfric_interface_friction_law, only: friction_law_t, law_constant
   use adfric_interface_friction_law_rows, only: given_law_t, get_friction_law
   use adfric_interface_total_friction, only: coupling_of, near_ratios, sliding_friction_t
   use adfric_plane_contact_conditions, only: largest_violation
   use adfric_plane_coupled_wave_search, only: solve_coupled_wave
   use adfric_plane_sliding_coupling, only: coupled_wave_t, error_of_cut
   use adfric_plane_wave_interface, only: interface_of
   use adfric_plane_wave_variables, only: regime_full, regime_none, regime_partial, in => wave_input, out => wave_output
   use adfric_solid_contact_modulus, only: contact_modulus_of
   use adfric_solid_time_temperature, only: time_temperature_t
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_status, only: status_solved, status_no_equilibrium, status_not_converged
   implicit none (type, external)
   private
   public :: coupled_point_t, solve_coupled_point, get_coupled_profiles

   !> Positions where the conditions of contact are checked, in the contact and beside it.
   integer, parameter :: n_positions = 16
   !> What the integrals over the contact leave of the digits.
   real(dp), parameter :: closed_form = 100*epsilon(1.0_dp)

   !> The contact of a point, in units of the wave.
   type, extends(point_state_t) :: coupled_point_t
      !> The contact where it is partial.
      type(coupled_wave_t) :: contact
      !> One of `regime_...`.
      integer :: regime = regime_none
      !> Mean pressure [E* k D], and penetration [D], below 0 where the bodies are apart.
      real(dp) :: mean_pressure = 0, penetration = 0
      !> m = mu beta, and beta tau/(E* k D) [-].
      real(dp) :: m = 0, stress = 0
      !> Friction T_s [E* k^2 D^2], and contact over the wave [-].
      real(dp) :: slope_friction = 0, contact_fraction = 0
   end type coupled_point_t

contains

   !> Solve a point. Beyond full contact the penetration of a half-plane is undefined.
   pure subroutine solve_coupled_point(values, given, state, results, error_estimate, status)
      real(dp), intent(in) :: values(:)
      type(given_law_t), intent(in) :: given
      !> Receives the contact.
      type(coupled_point_t), intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the main result [-]; of a constant shear stress the length where the gap is below 0.
      real(dp), intent(out) :: error_estimate
      !> Status of the point, one of `status_...`.
      integer, intent(out) :: status
      type(friction_law_t) :: law
      type(time_temperature_t) :: none

      error_estimate = closed_form
      call get_friction_law(interface_of(values), given, none, law)
      call find_contact(values, law, abs(values(in%velocity)), state, status)
      if (status /= status_solved) return
      if (state%regime == regime_partial) error_estimate = max(error_estimate, error_of_cut(state%stress, &
         & state%contact%peak_pressure))
      ! the length where the gap would be below 0 is longer than the contact
      if (.not. error_estimate <= 1) then
         status = status_not_converged
         error_estimate = 0
         return
      end if
      call store(values, state, results)
      call store_friction(values, law, state, results)
   end subroutine solve_coupled_point

   !> E* k D [Pa].
   pure real(dp) function pressure_unit(values)
      real(dp), intent(in) :: values(:)

      pressure_unit = contact_modulus_of(values(in%contact_modulus:in%second_poisson_ratio))*slope_unit(values)
   end function pressure_unit

   !> k D [-].
   pure real(dp) function slope_unit(values)
      real(dp), intent(in) :: values(:)

      slope_unit = two_pi*(values(in%amplitude)/values(in%period))
   end function slope_unit

   !> Shear stress without what goes with the pressure [Pa]; NaN where the law does not hold.
   pure real(dp) function constant_stress(values, law, speed) result(stress)
      real(dp), intent(in) :: values(:)
      type(friction_law_t), intent(in) :: law
      !> Speed [m/s].
      real(dp), intent(in) :: speed
      real(dp) :: slope
      logical :: is_valid

      call law%get_stress(speed, 0.0_dp, values(in%temperature), stress, slope, is_valid)
      if (.not. is_valid) stress = not_a_number()
   end function constant_stress

   !> Find the contact at a speed.
   pure subroutine find_contact(values, law, speed, state, status)
      real(dp), intent(in) :: values(:)
      type(friction_law_t), intent(in) :: law
      !> Speed [m/s], which counts for the law.
      real(dp), intent(in) :: speed
      type(coupled_point_t), intent(inout) :: state
      integer, intent(out) :: status
      real(dp) :: eta, full, goal
      logical :: is_pressure, is_converged

      status = status_not_converged
      associate (beta => coupling_of(values(in%poisson_ratio)))
         state%m = law%pressure_factor*beta
         state%stress = beta*constant_stress(values, law, speed)/pressure_unit(values)
      end associate
      if (ieee_is_nan(state%stress)) return
      eta = atan(state%m)/pi
      full = cos(pi*eta)/2
      is_pressure = is_set(values(in%mean_pressure))
      if (is_pressure) then
         goal = values(in%mean_pressure)/pressure_unit(values)
         if (goal < 0) status = status_no_equilibrium
      else
         goal = values(in%penetration)/values(in%amplitude)
         if (goal > 1) status = status_no_equilibrium
      end if
      if (status == status_no_equilibrium) return
      status = status_solved
      state%contact = coupled_wave_t()
      state%slope_friction = 0
      if (.not. goal > 0) then
         state%regime = regime_none
         state%mean_pressure = 0
         state%penetration = min(goal, 0.0_dp)
         state%contact_fraction = 0
      else if (goal >= merge(full, 1.0_dp, is_pressure)) then
         state%regime = regime_full
         state%mean_pressure = merge(goal, full, is_pressure)
         state%penetration = 1
         state%contact_fraction = 1
         state%slope_friction = -sin(pi*eta)*cos(pi*eta)/4
      else
         call solve_coupled_wave(state%contact, state%m, 2*state%stress, goal, is_pressure, is_converged)
         if (.not. is_converged) status = status_not_converged
         state%regime = regime_partial
         state%mean_pressure = state%contact%mean_pressure
         state%penetration = state%contact%penetration
         state%contact_fraction = state%contact%half_width/pi
         state%slope_friction = state%contact%friction_of_energy
      end if
   end subroutine find_contact

   !> Results of a contact.
   pure subroutine store(values, state, results)
      real(dp), intent(in) :: values(:)
      type(coupled_point_t), intent(in) :: state
      !> Receives the results; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      real(dp) :: unit, full, x(n_positions), pressure(2*n_positions), gap(2*n_positions)
      integer :: i

      unit = pressure_unit(values)
      full = cos(atan(state%m))/2
      associate (d => values(in%amplitude), wave => state%contact)
         results(out%mean_pressure) = state%mean_pressure*unit
         results(out%penetration) = state%penetration*d
         if (is_set(values(in%mean_pressure))) results(out%mean_pressure) = values(in%mean_pressure)
         if (is_set(values(in%penetration))) results(out%penetration) = values(in%penetration)
         results(out%full_contact_pressure) = full*unit
         results(out%contact_fraction) = state%contact_fraction
         results(out%contact_width) = state%contact_fraction*values(in%period)
         results(out%regime) = state%regime
         results([out%adhesion_fraction, out%adhesion_energy, out%hysteresis_loss]) = 0
         results([out%peak_pressure, out%mean_gap, out%largest_gap, out%violation, out%energy_imbalance]) = 0
         results(out%largest_coupling) = state%m
         results(out%smallest_stiffness_ratio) = cos(atan(state%m))
         if (state%regime == regime_none) then
            results(out%mean_gap) = d*(1 - state%penetration)
            results(out%largest_gap) = d*(2 - state%penetration)
         else if (state%regime == regime_full) then
            results(out%peak_pressure) = (state%mean_pressure + full)*unit
         else
            results(out%peak_pressure) = wave%peak_pressure*unit
            results([out%mean_gap, out%largest_gap]) = d*[1 - wave%penetration, wave%largest_gap]
            results(out%contact_shift) = sign(1.0_dp, values(in%velocity))*wave%centre*values(in%period)/two_pi
            associate (first => wave%slope_friction, second => wave%friction_of_energy)
               if (max(abs(first), abs(second)) > 0) results(out%energy_imbalance) = (first - second)/max(abs(first), abs(second))
            end associate
            x = [((i - 0.5_dp)/n_positions, i=1, n_positions)]
            do i = 1, n_positions
               pressure(i) = wave%pressure_at(wave%centre + wave%half_width*(2*x(i) - 1))
               gap(i) = wave%gap_at(wave%centre + wave%half_width*(2*x(i) - 1))
               pressure(n_positions + i) = wave%pressure_at(wave%centre + wave%half_width + 2*wave%opening*x(i))
               gap(n_positions + i) = wave%gap_at(wave%centre + wave%half_width + 2*wave%opening*x(i))
            end do
            results(out%violation) = largest_violation(pressure, gap, 1.0_dp, 1.0_dp)
         end if
      end associate
   end subroutine store

   !> Friction of a contact, and its change with the velocity.
   pure subroutine store_friction(values, law, state, results)
      real(dp), intent(in) :: values(:)
      type(friction_law_t), intent(in) :: law
      type(coupled_point_t), intent(in) :: state
      !> Receives the friction; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      type(sliding_friction_t) :: friction
      type(coupled_point_t) :: other
      real(dp) :: speed
      integer :: k, status

      speed = abs(values(in%velocity))
      friction%direction = sign(1.0_dp, values(in%velocity))
      friction%hysteretic = state%slope_friction*pressure_unit(values)*slope_unit(values)
      friction%interfacial = shear_of(values, law, speed, state)
      friction%neighbours = 0
      if (law%law /= law_constant) then
         friction%neighbours = not_a_number()
         do k = 1, size(near_ratios)
            call find_contact(values, law, speed*near_ratios(k), other, status)
            if (status == status_solved) friction%neighbours(k) = other%slope_friction*pressure_unit(values)*slope_unit(values) &
               & + shear_of(values, law, speed*near_ratios(k), other)
         end do
      end if
      call friction%store(values(in%velocity), results(out%mean_pressure), results(out%friction_stress), &
         & results(out%friction_coefficient), results(out%hysteretic_friction_stress:out%velocity_slope))
   end subroutine store_friction

   !> Mean shear stress of a contact [Pa].
   pure real(dp) function shear_of(values, law, speed, state) result(shear)
      real(dp), intent(in) :: values(:)
      type(friction_law_t), intent(in) :: law
      real(dp), intent(in) :: speed
      type(coupled_point_t), intent(in) :: state

      shear = constant_stress(values, law, speed)*state%contact_fraction + law%pressure_factor*state%mean_pressure &
         & *pressure_unit(values)
   end function shear_of

   !> Pressure and gap.
   pure subroutine get_coupled_profiles(values, state, x, pressure, gap)
      real(dp), intent(in) :: values(:)
      type(coupled_point_t), intent(in) :: state
      !> Distances from a crest [m]; shape `(n_x)`.
      real(dp), intent(in) :: x(:)
      !> Pressure [Pa] and gap [m]; shape `(n_x)`.
      real(dp), intent(inout) :: pressure(:), gap(:)
      real(dp) :: phase, angle
      integer :: i

      angle = atan(state%m)
      do i = 1, size(x)
         phase = sign(1.0_dp, values(in%velocity))*two_pi*x(i)/values(in%period)
         select case (state%regime)
         case (regime_none)
            pressure(i) = 0
            gap(i) = 2*sin(phase/2)**2 - state%penetration
         case (regime_full)
            pressure(i) = state%mean_pressure + cos(angle)*cos(phase + angle)/2
            gap(i) = 0
         case default
            pressure(i) = state%contact%pressure_at(phase)
            gap(i) = state%contact%gap_at(phase)
         end select
      end do
      pressure = pressure*pressure_unit(values)
      gap = gap*values(in%amplitude)
   end subroutine get_coupled_profiles

end module adfric_plane_coupled_wave_point
