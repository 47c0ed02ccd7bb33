! SPDX-License-Identifier: GPL-3.0-or-later
!> One point of `wave_1d` with adhesion over a viscoelastic half-plane, from the values of a namelist to results and profiles.
module adfric_plane_adhesive_sliding_point
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, two_pi
   use adfric_base_unset, only: is_set, unset
   use adfric_plane_adhesive_sliding_branch, only: slide_branches_t, slide_state_t, find_branches, state_of_load, &
      & state_of_penetration, slide_adhered => branch_adhered, slide_approach => branch_approach, state_none => regime_none, &
      & state_free => regime_free, state_zones => regime_zones, state_saturated => regime_saturated
   use adfric_plane_adhesive_sliding_profile, only: slide_profile_t, new_slide_profile, slide_pressure, slide_gap
   use adfric_plane_adhesive_sliding_survey, only: slide_survey_t, survey_slide
   use adfric_plane_adhesive_sliding_zones, only: adhesive_slide_t, set_compliances
   use adfric_plane_adhesive_sliding_derived, only: derive_edges
   use adfric_solid_order_margin, only: order_margin_of
   use adfric_plane_sliding_solid, only: new_sliding_solid, suits_solid
   use adfric_plane_sliding_wave, only: wave_contact_t, wave_of_pressure
   use adfric_plane_sliding_wave_profile, only: sliding_wave_pressure, sliding_wave_gap
   use adfric_plane_sliding_wave_survey, only: wave_survey_t, survey_wave
   use adfric_plane_wave_variables, only: regime_adhesion_zones, regime_full, regime_none, regime_saturated_adhesion, &
      & in => wave_input, out => wave_output
   use adfric_interface_adhesion_rows, only: adhesion_law_t, branch_adhered, resolve_adhesion
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_solid_prony, only: prony_t
   use adfric_solid_spectrum_rows, only: get_spectrum, is_same_spectrum, n_spectrum_rows, shift_factor_of
   use adfric_describe_derived, only: derived_t
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_status, only: status_solved, status_no_equilibrium, status_not_converged
   implicit none (type, external)
   private
   public :: adhesive_slide_point_t, is_possible_adhesive_slide, derive_adhesive_slide, solve_adhesive_slide, &
      & get_adhesive_slide_profiles

   !> What the equations leave of the digits.
   real(dp), parameter :: solved_digits = 1.0e-9_dp
   !> Bounds of stress and range, reduced.
   real(dp), parameter :: least_size = 1.0e-6_dp, largest_size = 1.0e6_dp
   !> Largest violation of the conditions of contact.
   real(dp), parameter :: largest_violation = 1.0e-6_dp
   !> Dissipation below this share of mean pressure times steepest slope is a small difference in the work of the pressure.
   real(dp), parameter :: small_share = 1.0e-3_dp

   !> What a point leaves: the branches at its speed, which may be those of the next point, and its state.
   type, extends(point_state_t) :: adhesive_slide_point_t
      !> Values of the material, from which the spectrum follows.
      real(dp) :: material(n_spectrum_rows) = unset
      !> Period, amplitude, velocity at the temperature of the spectrum, stress and range.
      real(dp) :: sizes(5) = unset
      !> Spectrum of contact moduli [Pa, s].
      type(prony_t) :: prony
      !> Pressure E0 k D [Pa], and wave number times amplitude [-].
      real(dp) :: pressure_unit = 1, slope = 1
      !> 1 for a velocity >= 0, or -1.
      real(dp) :: direction = 1
      !> M/Einf of the solid.
      real(dp) :: order_margin = 1
      !> Are the sizes numbers that can be handled, and were the ends of the branches found?
      logical :: is_possible = .false., is_found = .false.
      !> The branches, reduced.
      type(slide_branches_t) :: branches
      !> The state.
      type(slide_state_t) :: state
   end type adhesive_slide_point_t

contains

   !> What slides on what: as at the point before, or anew.
   pure subroutine resolve(values, given, law, point, slide, is_new)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      type(adhesion_law_t), intent(out) :: law
      !> In: what the point before has left. Out: spectrum and sizes of this one.
      type(adhesive_slide_point_t), intent(inout) :: point
      !> Receives the reduced wave, if it is new and possible.
      type(adhesive_slide_t), intent(out) :: slide
      !> Is it not that of the point before?
      logical, intent(out) :: is_new
      real(dp) :: sizes(5), speed

      call resolve_adhesion(values(in%adhesion:in%turning_pressure), law)
      associate (material => values(in%material(1):in%temperature))
         sizes = [values(in%period), values(in%amplitude), values(in%velocity)*shift_factor_of(material, given), law%stress, &
            & law%range]
         is_new = .not. (is_same_spectrum(material, point%material) .and. all(sizes >= point%sizes .and. sizes <= point%sizes))
         if (.not. is_new) return
         if (.not. is_same_spectrum(material, point%material)) call get_spectrum(material, given, point%prony)
         point%material = material
      end associate
      point%sizes = sizes
      point%direction = sign(1.0_dp, sizes(3))
      point%slope = two_pi*(sizes(2)/sizes(1))
      point%pressure_unit = point%prony%relaxed*point%slope
      speed = two_pi*(abs(sizes(3))/sizes(1))
      slide%stress = law%stress/point%pressure_unit
      slide%range = law%range/sizes(2)
      point%is_possible = suits_solid(point%prony, speed) .and. min(slide%stress, slide%range) >= least_size &
         & .and. max(slide%stress, slide%range) <= largest_size
      if (.not. point%is_possible) return
      call new_sliding_solid(slide%solid, point%prony, speed)
      call set_compliances(slide)
      point%order_margin = order_margin_of(slide%solid%ratios, slide%solid%relaxation)
   end subroutine resolve

   !> Are speed, stress and range of sizes that can be handled?
   pure logical function is_possible_adhesive_slide(values, given) result(is_possible)
      !> Values of the variables, which have been checked one by one; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      type(adhesion_law_t) :: law
      type(adhesive_slide_point_t) :: point
      type(adhesive_slide_t) :: slide
      logical :: is_new

      call resolve(values, given, law, point, slide, is_new)
      is_possible = point%is_possible
   end function is_possible_adhesive_slide

   !> Add order of states, zone and works of the two edges.
   subroutine derive_adhesive_slide(list, values, given)
      type(derived_t), allocatable, intent(inout) :: list(:)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      type(adhesion_law_t) :: law
      type(adhesive_slide_point_t) :: point
      type(adhesive_slide_t) :: slide
      logical :: is_new

      call resolve(values, given, law, point, slide, is_new)
      if (.not. point%is_possible) return
      call derive_edges(list, slide, point%order_margin, values(in%period)/two_pi, law%stress, law%range)
   end subroutine derive_adhesive_slide

   !> Solve a point.
   pure subroutine solve_adhesive_slide(values, given, point, results, error_estimate, status)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      !> In: what the point before has left. Out: what this one leaves.
      type(adhesive_slide_point_t), intent(inout) :: point
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the main result [-].
      real(dp), intent(out) :: error_estimate
      !> Status of the point, one of `status_...`.
      integer, intent(out) :: status
      type(adhesion_law_t) :: law
      type(adhesive_slide_t) :: slide
      type(slide_state_t) :: other
      logical :: is_new, is_solved, has_other
      integer :: branch

      error_estimate = solved_digits
      status = status_not_converged
      call resolve(values, given, law, point, slide, is_new)
      if (.not. point%is_possible) return
      if (is_new) call find_branches(slide, point%branches, point%is_found)
      if (.not. point%is_found) return
      call store_ends(point, results)
      branch = merge(slide_adhered, slide_approach, law%branch == branch_adhered)
      call find_state(values, point, branch, point%state, is_solved)
      if (.not. is_solved) return
      status = status_no_equilibrium
      if (point%state%regime == state_none) return
      call find_state(values, point, slide_adhered + slide_approach - branch, other, has_other)
      if (has_other) results(out%branches_differ) = merge(1, 0, other%regime /= state_none &
         & .and. (other%regime /= point%state%regime .or. abs(other%friction - point%state%friction) > &
         & solved_digits*abs(other%friction)))
      call store_state(values, point, results)
      status = status_solved
      if (.not. results(out%violation) <= largest_violation) status = status_not_converged
   end subroutine solve_adhesive_slide

   !> The state of a branch.
   pure subroutine find_state(values, point, branch, state, is_solved)
      real(dp), intent(in) :: values(:)
      type(adhesive_slide_point_t), intent(in) :: point
      integer, intent(in) :: branch
      type(slide_state_t), intent(out) :: state
      logical, intent(out) :: is_solved

      if (is_set(values(in%mean_pressure))) then
         call state_of_load(point%branches, values(in%mean_pressure)/point%pressure_unit, branch, state, is_solved)
      else
         call state_of_penetration(point%branches, values(in%penetration)/values(in%amplitude), branch, state, is_solved)
      end if
   end subroutine find_state

   !> Ends of the branches, which every point of a wave has.
   pure subroutine store_ends(point, results)
      type(adhesive_slide_point_t), intent(in) :: point
      !> Receives the results; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)

      associate (b => point%branches, p => point%pressure_unit)
         results(out%full_contact_pressure) = p*(b%full_load + b%slide%stress)
         results(out%end_of_saturation_pressure) = p*b%saturation_load
         results(out%order_margin) = point%order_margin
         if (.not. (b%is_complete .and. b%has_rise)) return
         results(out%pull_off_pressure) = p*b%pull_off_load
         results(out%saturation_fold_pressure) = p*b%fold_load
      end associate
   end subroutine store_ends

   !> Results of a state.
   pure subroutine store_state(values, point, results)
      real(dp), intent(in) :: values(:)
      type(adhesive_slide_point_t), intent(in) :: point
      !> Receives the results; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      real(dp) :: stress_unit, losses, work

      associate (state => point%state, p => point%pressure_unit, d => values(in%amplitude))
         stress_unit = point%direction*p*point%slope
         results([out%mean_pressure, out%penetration]) = [p*state%load, d*state%penetration]
         ! what is given keeps its bits
         if (is_set(values(in%mean_pressure))) results(out%mean_pressure) = values(in%mean_pressure)
         if (is_set(values(in%penetration))) results(out%penetration) = values(in%penetration)
         results(out%mean_gap) = d*(1 - state%penetration)
         results(out%friction_stress) = stress_unit*state%friction
         results(out%dissipation) = abs(results(out%friction_stress))
         if (results(out%mean_pressure) > 0) results(out%friction_coefficient) = &
            & results(out%friction_stress)/results(out%mean_pressure)
         if (results(out%mean_pressure) > 0) call split_friction(point, stress_unit, results)
         results(out%violation) = 0
         work = 0
         select case (state%regime)
         case (state_free)
            results(out%regime) = regime_none
            results([out%contact_width, out%contact_fraction, out%adhesion_fraction, out%peak_pressure]) = 0
            results(out%largest_gap) = d*(2 - (1 + state%penetration))
         case (state_zones)
            call store_zones(values, point, results, work)
         case default
            call store_saturated(values, point, results, work)
         end select
         losses = max(results(out%dissipation), small_share*p*max(abs(state%load), point%branches%slide%stress)*point%slope)
         results(out%energy_imbalance) = (abs(stress_unit)*work - results(out%dissipation))/losses
      end associate
   end subroutine store_state

   !> The parts of the friction, by definition: that of the same load without adhesion, and the rest.
   pure subroutine split_friction(point, stress_unit, results)
      type(adhesive_slide_point_t), intent(in) :: point
      real(dp), intent(in) :: stress_unit
      real(dp), intent(inout) :: results(:)
      type(wave_contact_t) :: contact
      logical :: is_converged

      call wave_of_pressure(point%branches%slide%solid, 2*point%state%load, contact, is_converged)
      if (.not. is_converged) return
      results(out%friction_without_adhesion) = stress_unit*contact%friction/2
      results(out%adhesive_friction_stress) = results(out%friction_stress) - results(out%friction_without_adhesion)
   end subroutine split_friction

   !> Results of a contact between two zones.
   pure subroutine store_zones(values, point, results, work)
      real(dp), intent(in) :: values(:)
      type(adhesive_slide_point_t), intent(in) :: point
      real(dp), intent(inout) :: results(:)
      !> Receives the friction from the pressure, reduced.
      real(dp), intent(out) :: work
      type(slide_profile_t) :: profile
      type(slide_survey_t) :: survey
      real(dp) :: length

      call new_slide_profile(point%branches%slide, point%state%zones, profile)
      call survey_slide(profile, survey)
      work = survey%friction
      length = values(in%period)/two_pi
      associate (z => point%state%zones)
         results(out%regime) = regime_adhesion_zones
         results(out%contact_fraction) = z%half_width/pi
         results(out%contact_width) = results(out%contact_fraction)*values(in%period)
         results(out%contact_shift) = point%direction*length*z%middle
         results(out%adhesion_fraction) = (z%leading + z%trailing)/two_pi
         results([out%zone_leading, out%zone_trailing]) = length*[z%leading, z%trailing]
         results(out%peak_pressure) = point%pressure_unit*survey%peak_pressure
         results(out%largest_gap) = values(in%amplitude)*survey%largest_gap
         results(out%violation) = survey%violation
      end associate
   end subroutine store_zones

   !> Results where all of the gap is in range, or none is left: those without adhesion, under the stress more.
   pure subroutine store_saturated(values, point, results, work)
      real(dp), intent(in) :: values(:)
      type(adhesive_slide_point_t), intent(in) :: point
      real(dp), intent(inout) :: results(:)
      real(dp), intent(out) :: work
      type(wave_survey_t) :: survey

      associate (contact => point%state%contact, slide => point%branches%slide)
         call survey_wave(slide%solid, contact, survey)
         work = survey%friction/2
         results(out%regime) = merge(regime_saturated_adhesion, regime_full, point%state%regime == state_saturated)
         results(out%contact_fraction) = contact%half_width/pi
         results(out%contact_width) = results(out%contact_fraction)*values(in%period)
         results(out%adhesion_fraction) = 1 - results(out%contact_fraction)
         results(out%mean_gap) = values(in%amplitude)*contact%mean_gap
         if (point%state%regime == state_saturated) results(out%contact_shift) = &
            & point%direction*values(in%period)/two_pi*contact%shift%shift
         ! a full contact is that under its own load, beyond the least one
         results(out%peak_pressure) = point%pressure_unit*(survey%peak_pressure/2 - slide%stress)
         results(out%largest_gap) = values(in%amplitude)*survey%largest_gap
         results(out%violation) = survey%violation
      end associate
   end subroutine store_saturated

   !> Pressure and gap along the wave.
   pure subroutine get_adhesive_slide_profiles(point, coordinates, pressure, gap)
      type(adhesive_slide_point_t), intent(in) :: point
      !> Positions along the wave, from a crest [m]; shape `(n)`.
      real(dp), intent(in) :: coordinates(:)
      !> Pressure [Pa] and gap [m]; shape `(n)`.
      real(dp), intent(out) :: pressure(:), gap(:)
      type(slide_profile_t) :: profile
      real(dp) :: x
      integer :: i

      if (point%state%regime == state_zones) call new_slide_profile(point%branches%slide, point%state%zones, profile)
      do i = 1, size(coordinates)
         x = point%direction*two_pi*(coordinates(i)/point%sizes(1))
         call get_profile_at(point, profile, x, pressure(i), gap(i))
      end do
      pressure = point%pressure_unit*pressure
      gap = point%sizes(2)*gap
   end subroutine get_adhesive_slide_profiles

   !> Pressure and gap at a position, reduced.
   pure subroutine get_profile_at(point, profile, x, pressure, gap)
      type(adhesive_slide_point_t), intent(in) :: point
      !> That of zones; of no meaning for other states.
      type(slide_profile_t), intent(in) :: profile
      real(dp), intent(in) :: x
      real(dp), intent(out) :: pressure, gap
      real(dp) :: s

      associate (state => point%state, z => point%state%zones, slide => point%branches%slide)
         pressure = 0
         gap = 0
         select case (state%regime)
         case (state_free)
            gap = -state%penetration + (1 - cos(x))
         case (state_zones)
            ! the path from the trailing edge
            s = modulo(x - (z%middle - z%half_width), two_pi)
            if (s < 2*z%half_width) then
               pressure = slide_pressure(profile, max(s, tiny(s)), max(2*z%half_width - s, tiny(s)))
            else
               gap = slide_gap(profile, max(s - 2*z%half_width, tiny(s)), .false.)
               if (gap <= slide%range) pressure = -slide%stress
            end if
         case default
            pressure = sliding_wave_pressure(slide%solid, state%contact, x)/2 - slide%stress
            gap = sliding_wave_gap(slide%solid, state%contact, x)
         end select
      end associate
   end subroutine get_profile_at

end module adfric_plane_adhesive_sliding_point
