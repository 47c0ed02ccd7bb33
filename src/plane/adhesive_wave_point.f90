! SPDX-License-Identifier: GPL-3.0-or-later
!> One point of `wave_1d` with adhesion, from the values of a namelist to results and profiles.
module adfric_plane_adhesive_wave_point
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set, unset
   use adfric_plane_adhesive_wave, only: load_slope, penetration_slope, range_excess
   use adfric_plane_adhesive_wave_ends, only: wave_ends_t, get_ends
   use adfric_plane_adhesive_wave_load, only: curve_approach => branch_approach, curve_adhered => branch_adhered
   use adfric_plane_adhesive_wave_profile, only: adhesive_wave_pressure
   use adfric_plane_adhesive_wave_state, only: curve_none => regime_none, curve_free => regime_free, &
      & curve_no_contact => regime_no_contact, curve_zones => regime_zones, curve_saturated => regime_saturated
   use adfric_plane_adhesive_wave_units, only: wave_adhesion_case_t, wave_adhesion_state_t, new_wave_adhesion
   use adfric_plane_jkr_wave, only: find_jkr_pull_off
   use adfric_plane_wave_variables, only: regime_adhesion_only, regime_adhesion_zones, regime_full, regime_none, &
      & regime_saturated_adhesion, in => wave_input, out => wave_output
   use adfric_plane_westergaard, only: wave_mean_gap
   use adfric_interface_adhesion_rows, only: adhesion_law_t, adhesion_names, branch_adhered, resolve_adhesion
   use adfric_solid_contact_modulus, only: contact_modulus_of, modulus_names
   use adfric_describe_derived, only: derived_t, add_derived
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_status, only: status_solved, status_no_equilibrium, status_not_converged
   implicit none (type, external)
   private
   public :: adhesive_point_t, is_possible_adhesion, derive_adhesion, solve_adhesion, get_adhesive_profiles

   !> What the closed forms leave of the digits (docs/theory/adhesive_wave.md).
   real(dp), parameter :: closed_form = 1.0e-13_dp
   !> Positions in the contact where the pressure is compared with the adhesion stress.
   integer, parameter :: n_positions = 4

   !> What a point leaves: the wave with its events, which may be those of the next point, and the state.
   type, extends(point_state_t) :: adhesive_point_t
      !> Period, amplitude, contact modulus, stress and range of the wave, in SI units.
      real(dp) :: sizes(5) = unset
      !> The wave with all events.
      type(wave_adhesion_case_t) :: wave
      !> Are its stress and range numbers that can be handled, and were the events found?
      logical :: is_possible = .false., is_converged = .false.
      !> Turning pressure of the ends [Pa], `unset` for full contact; and whether there are ends.
      real(dp) :: turning_pressure = unset
      !> Are the ends known?
      logical :: has_ends = .false.
      !> Ends of the adhered branch.
      type(wave_ends_t) :: ends
      !> The state.
      type(wave_adhesion_state_t) :: state
   end type adhesive_point_t

contains

   !> What adheres to what: the wave of the point before, or a new one.
   pure subroutine resolve_wave(values, law, point)
      real(dp), intent(in) :: values(:)
      type(adhesion_law_t), intent(in) :: law
      !> In: what the point before has left. Out: the wave of this one.
      type(adhesive_point_t), intent(inout) :: point
      real(dp) :: sizes(5)

      sizes = [values(in%period), values(in%amplitude), contact_modulus_of(values(in%contact_modulus:in%second_poisson_ratio)), &
         & law%stress, law%range]
      if (all(sizes >= point%sizes .and. sizes <= point%sizes)) return
      point%sizes = sizes
      point%has_ends = .false.
      call new_wave_adhesion(point%wave, sizes(1), sizes(2), sizes(3), sizes(4), sizes(5), point%is_possible, point%is_converged)
   end subroutine resolve_wave

   !> Where the branch ends: as at the point before, or anew.
   pure subroutine resolve_ends(law, point)
      type(adhesion_law_t), intent(in) :: law
      !> In: what the point before has left, with the wave of this one. Out: with the ends of this one.
      type(adhesive_point_t), intent(inout) :: point
      real(dp) :: turning_pressure

      turning_pressure = unset
      if (allocated(law%turning_pressure)) turning_pressure = law%turning_pressure
      if (point%has_ends .and. turning_pressure >= point%turning_pressure .and. turning_pressure <= point%turning_pressure) return
      point%turning_pressure = turning_pressure
      if (is_set(turning_pressure)) then
         call get_ends(point%wave%wave, point%ends, point%has_ends, turning_pressure/point%wave%pressure_unit)
      else
         call get_ends(point%wave%wave, point%ends, point%has_ends)
      end if
   end subroutine resolve_ends

   !> Are stress and range of sizes that can be handled?
   pure logical function is_possible_adhesion(values) result(is_possible)
      !> Values of the variables, which have been checked one by one; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(adhesion_law_t) :: law
      type(adhesive_point_t) :: point

      call resolve_adhesion(values(in%adhesion:in%turning_pressure), law)
      call resolve_wave(values, law, point)
      is_possible = point%is_possible
   end function is_possible_adhesion

   !> Add the numbers that say which limit a wave is near.
   subroutine derive_adhesion(list, values)
      type(derived_t), allocatable, intent(inout) :: list(:)
      real(dp), intent(in) :: values(:)
      character(*), parameter :: of_wave = ' period amplitude '//modulus_names, of_all = adhesion_names//of_wave
      type(adhesion_law_t) :: law
      type(adhesive_point_t) :: point
      real(dp) :: half_width, load
      logical :: has_fold

      call resolve_adhesion(values(in%adhesion:in%turning_pressure), law)
      call resolve_wave(values, law, point)
      if (.not. point%is_possible) return
      if (is_set(values(in%adhesion + 2))) then
         call add_derived(list, 'surface_energy', 'J/m^2', 'stress times range', law%stress*law%range, adhesion_names)
      else
         call add_derived(list, 'range', 'm', 'largest gap with adhesion', law%range, adhesion_names)
      end if
      call add_derived(list, 'reduced_stress', '-', 'adhesion stress over p* = pi E* D/l', point%wave%wave%stress, &
         & 'stress'//of_wave)
      call add_derived(list, 'reduced_range', '-', 'range of adhesion over amplitude', point%wave%wave%range, &
         & adhesion_names//' amplitude')
      call add_derived(list, 'adhesion_parameter', '-', &
         & 'Johnson''s alpha, alpha^2 = 2 w l/(pi^2 E* D^2)', point%wave%alpha, of_all)
      call add_derived(list, 'zone_length', 'm', 'length of a short zone of adhesion, pi E* h0/(4 p0)', &
         & point%wave%zone_length, of_all)
      call find_jkr_pull_off(point%wave%alpha, half_width, load, has_fold)
      if (has_fold) call add_derived(list, 'jkr_pull_off_pressure', 'Pa', &
         & 'pull-off of partial contacts for a short range at the same surface energy', load*point%wave%pressure_unit, of_all)
   end subroutine derive_adhesion

   !> Solve a point.
   pure subroutine solve_adhesion(values, point, results, error_estimate, status)
      real(dp), intent(in) :: values(:)
      !> In: what the point before has left. Out: what this one leaves.
      type(adhesive_point_t), intent(inout) :: point
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the main result [-].
      real(dp), intent(out) :: error_estimate
      !> Status of the point, one of `status_...`.
      integer, intent(out) :: status
      type(adhesion_law_t) :: law
      integer :: branch
      logical :: is_solved

      error_estimate = closed_form
      status = status_not_converged
      call resolve_adhesion(values(in%adhesion:in%turning_pressure), law)
      call resolve_wave(values, law, point)
      if (.not. (point%is_possible .and. point%is_converged)) return
      call resolve_ends(law, point)
      if (.not. point%has_ends) return
      branch = merge(curve_adhered, curve_approach, law%branch == branch_adhered)
      if (is_set(values(in%mean_pressure))) then
         call point%wave%solve_pressure(values(in%mean_pressure), branch, point%state, is_solved, law%turning_pressure)
      else
         call point%wave%solve_penetration(values(in%penetration), branch, point%state, is_solved, law%turning_pressure)
      end if
      if (is_solved) status = merge(status_no_equilibrium, status_solved, point%state%regime == curve_none)
      results(out%full_contact_pressure) = point%wave%pressure_unit
      call store_ends(point, results)
      if (status /= status_solved) return
      call store_state(values, point, results)
      error_estimate = error_of(values, point)
   end subroutine solve_adhesion

   !> Results of the branch, which every point of a wave has.
   pure subroutine store_ends(point, results)
      type(adhesive_point_t), intent(in) :: point
      !> Receives the results; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)

      associate (ends => point%ends, p => point%wave%pressure_unit, d => point%wave%amplitude)
         results(out%pull_off_pressure) = p*ends%pull_off_load
         results([out%pull_off_penetration, out%jump_off_penetration]) = d*[ends%pull_off_penetration, ends%jump_off_penetration]
         results(out%hysteresis_loss) = p*d*ends%loss
      end associate
   end subroutine store_ends

   !> Results of a state.
   pure subroutine store_state(values, point, results)
      real(dp), intent(in) :: values(:)
      type(adhesive_point_t), intent(in) :: point
      !> Receives the results; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)

      associate (state => point%state)
         results([out%mean_pressure, out%penetration]) = [state%mean_pressure, state%penetration]
         ! what is given keeps its bits
         if (is_set(values(in%mean_pressure))) results(out%mean_pressure) = values(in%mean_pressure)
         if (is_set(values(in%penetration))) results(out%penetration) = values(in%penetration)
         results(out%contact_fraction) = state%contact_fraction
         results(out%contact_width) = state%contact_fraction*values(in%period)
         results(out%adhesion_fraction) = max(0.0_dp, state%label_fraction - state%contact_fraction)
         results(out%peak_pressure) = state%crest_pressure
         results([out%mean_gap, out%largest_gap]) = [state%mean_gap, state%valley_gap]
         if (state%regime >= curve_saturated .and. state%contact_fraction > 0) results(out%mean_gap) = &
            & point%wave%amplitude*wave_mean_gap(state%state%square)
         results([out%elastic_energy, out%adhesion_energy]) = [state%elastic_energy, state%adhesion_energy]
         results(out%regime) = regime_of(state)
      end associate
      results(out%violation) = violation_of(point)
   end subroutine store_state

   !> The regime in the words of the table.
   pure integer function regime_of(state) result(regime)
      type(wave_adhesion_state_t), intent(in) :: state

      select case (state%regime)
      case (curve_free)
         regime = regime_none
      case (curve_no_contact)
         regime = regime_adhesion_only
      case (curve_zones)
         regime = regime_adhesion_zones
      case (curve_saturated)
         regime = merge(regime_saturated_adhesion, regime_adhesion_only, state%contact_fraction > 0)
      case default
         regime = regime_full
      end select
   end function regime_of

   !> Largest violation of p + p0 >= 0 in contact, of the range at the edge of adhesion, and of what adheres in the trough; pressures
   !> are measured in p* or p0, gaps in D or h0, whichever is larger.
   pure real(dp) function violation_of(point) result(violation)
      type(adhesive_point_t), intent(in) :: point
      real(dp) :: x, gap
      integer :: i

      associate (wave => point%wave%wave, state => point%state%state)
         violation = 0
         if (state%regime == curve_free) return
         do i = 1, n_positions
            x = state%contact_half_width*((i - 0.5_dp)/n_positions)
            violation = max(violation, -(adhesive_wave_pressure(wave, state, x) + wave%stress)/max(1.0_dp, wave%stress))
         end do
         gap = (point%state%valley_gap/point%wave%amplitude - wave%range)/max(1.0_dp, wave%range)
         violation = max(violation, merge(gap, -gap, state%regime >= curve_saturated))
         if (state%regime == curve_zones) violation = max(violation, &
            & abs(range_excess(wave%sigma, wave%range, state%zones))/max(1.0_dp, wave%range))
      end associate
   end function violation_of

   !> Estimated relative error of the main result: the penetration under a load grows without bound at a fold, where it is the square
   !> root of the error of the load.
   pure real(dp) function error_of(values, point) result(error)
      real(dp), intent(in) :: values(:)
      type(adhesive_point_t), intent(in) :: point
      real(dp) :: slope, scale

      error = closed_form
      associate (wave => point%wave%wave, state => point%state%state)
         if (state%regime /= curve_zones) return
         slope = abs(load_slope(wave%sigma, state%zones))
         scale = abs(2*penetration_slope(wave%sigma, state%zones))
         if (is_set(values(in%penetration))) then
            ! d P/d delta, where the penetration is the given number
            error = closed_form*max(1.0_dp, slope/max(scale, tiny(scale)))
         else
            error = closed_form*max(1.0_dp, scale/max(slope, tiny(slope)))
         end if
         error = min(error, sqrt(closed_form))
      end associate
   end function error_of

   !> Pressure and gap along the wave.
   pure subroutine get_adhesive_profiles(point, coordinates, pressure, gap)
      type(adhesive_point_t), intent(in) :: point
      !> Positions along the wave, from a crest [m]; shape `(n)`.
      real(dp), intent(in) :: coordinates(:)
      !> Pressure [Pa] and gap [m]; shape `(n)`.
      real(dp), intent(out) :: pressure(:), gap(:)
      integer :: i

      do i = 1, size(coordinates)
         pressure(i) = point%wave%pressure_at(point%state, coordinates(i))
         gap(i) = point%wave%gap_at(point%state, coordinates(i))
      end do
   end subroutine get_adhesive_profiles

end module adfric_plane_adhesive_wave_point
