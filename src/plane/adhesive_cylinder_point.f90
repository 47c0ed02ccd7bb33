! SPDX-License-Identifier: GPL-3.0-or-later
!> One point of `adhesive_cylinder`, from the values of a namelist to results and profiles.
!>
!> Lengths count in l = (R^2 w/E0)^(1/3), with the work of adhesion w = p0 d0: of the reduced stress and range one is the inverse of
!> the other.
module adfric_plane_adhesive_cylinder_point
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_unset, only: unset
   use adfric_interface_adhesion_rows, only: branch_adhered, range_of
   use adfric_plane_adhesive_cylinder_variables, only: in => adhesive_cylinder_input, out => adhesive_cylinder_output
   use adfric_plane_adhesive_sliding_branch, only: slide_branches_t, slide_state_t, find_branches, state_of_load, &
      & slide_adhered => branch_adhered, slide_approach => branch_approach, state_none => regime_none
   use adfric_plane_adhesive_sliding_derived, only: derive_edges
   use adfric_plane_adhesive_sliding_profile, only: slide_profile_t, new_slide_profile, slide_pressure, slide_gap
   use adfric_plane_adhesive_sliding_survey, only: slide_survey_t, survey_slide
   use adfric_plane_adhesive_sliding_zones, only: adhesive_slide_t, set_compliances
   use adfric_plane_sliding_cylinder, only: cylinder_contact_t, cylinder_of_load
   use adfric_plane_sliding_solid, only: new_sliding_solid, suits_solid
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_solid_order_margin, only: order_margin_of
   use adfric_solid_prony, only: prony_t
   use adfric_solid_spectrum_rows, only: get_spectrum, is_same_spectrum, n_spectrum_rows, shift_factor_of
   use adfric_describe_derived, only: derived_t
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_status, only: status_no_equilibrium, status_not_converged, status_solved
   implicit none (type, external)
   private
   public :: adhesive_cylinder_point_t, new_cylinder_case, is_possible_adhesive_cylinder, derive_adhesive_cylinder, &
      & solve_adhesive_cylinder, get_adhesive_cylinder_profiles

   !> What the equations leave of the digits.
   real(dp), parameter :: solved_digits = 1.0e-9_dp
   !> Bounds of the reduced stress, and largest reduced load.
   real(dp), parameter :: least_stress = 1.0e-4_dp, largest_stress = 1.0e4_dp, largest_load = 1.0e10_dp
   !> The curve of states reaches at least up to this load; steps of its end, so that many points of a sweep share it.
   real(dp), parameter :: least_end = 10, step_of_end = 10
   !> Largest violation of the conditions of contact.
   real(dp), parameter :: largest_violation = 1.0e-6_dp
   !> Dissipation below this share of load times half-width over radius is a small difference in the work of the pressure.
   real(dp), parameter :: small_share = 1.0e-3_dp
   !> Digits of the moment that edges carry, of which friction is a difference.
   real(dp), parameter :: digits_of_moment = 4.0e-13_dp

   !> What a point leaves: the branches at its speed, which may be those of the next point, and its state.
   type, extends(point_state_t) :: adhesive_cylinder_point_t
      !> Values of the material, from which the spectrum follows.
      real(dp) :: material(n_spectrum_rows) = unset
      !> Radius, velocity at the temperature of the spectrum, stress and range, and the end of the curve.
      real(dp) :: sizes(5) = unset
      !> Spectrum of contact moduli [Pa, s].
      type(prony_t) :: prony
      !> Unit of length l [m], and l/R [-].
      real(dp) :: length = 1, slope = 1
      !> 1 for a velocity >= 0, or -1.
      real(dp) :: direction = 1
      !> Reduced load.
      real(dp) :: load = 0
      !> Are the sizes numbers that can be handled?
      logical :: is_possible = .false.
      !> The branches, reduced.
      type(slide_branches_t) :: branches
      !> The state, reduced.
      type(slide_state_t) :: state
   contains
      procedure :: pressure_unit
      procedure :: force_unit
      procedure :: friction_unit
   end type adhesive_cylinder_point_t

contains

   !> Unit of pressures, E0 l/R [Pa].
   pure real(dp) function pressure_unit(self)
      class(adhesive_cylinder_point_t), intent(in) :: self

      pressure_unit = self%prony%relaxed*self%slope
   end function pressure_unit

   !> Unit of loads, E0 l^2/R [N/m].
   pure real(dp) function force_unit(self)
      class(adhesive_cylinder_point_t), intent(in) :: self

      force_unit = self%pressure_unit()*self%length
   end function force_unit

   !> Unit of the friction, E0 l^3/R^2 [N/m], with the sign of the velocity.
   pure real(dp) function friction_unit(self)
      class(adhesive_cylinder_point_t), intent(in) :: self

      friction_unit = self%direction*self%force_unit()*self%slope
   end function friction_unit

   !> The cylinder of a velocity.
   pure subroutine new_cylinder_case(values, given, velocity, point, slide)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      !> The velocity [m/s].
      real(dp), intent(in) :: velocity
      !> In: what the point before has left. Out: spectrum, units and load of this one.
      type(adhesive_cylinder_point_t), intent(inout) :: point
      !> The reduced cylinder; of no meaning where it is not possible.
      type(adhesive_slide_t), intent(out) :: slide
      real(dp) :: speed, range, stress

      associate (material => values(in%material(1):in%temperature))
         if (.not. is_same_spectrum(material, point%material)) call get_spectrum(material, given, point%prony)
         point%material = material
         stress = values(in%stress(1))
         range = range_of(values(in%stress))
         associate (r => values(in%radius), e0 => point%prony%relaxed)
            point%slope = (stress/e0*(range/r))**(1/3.0_dp)
            point%length = point%slope*r
            slide%is_wave = .false.
            slide%stress = stress/e0/point%slope
            slide%range = range/r/point%slope**2
            point%direction = sign(1.0_dp, velocity)
            point%load = values(in%load)/r/e0/point%slope**2
            speed = abs(velocity)*shift_factor_of(material, given)/point%length
         end associate
      end associate
      point%is_possible = slide%stress >= least_stress .and. slide%stress <= largest_stress .and. &
         & abs(point%load) <= largest_load
      if (point%is_possible) point%is_possible = suits_solid(point%prony, speed)
      if (.not. point%is_possible) return
      call new_sliding_solid(slide%solid, point%prony, speed)
      call set_compliances(slide)
   end subroutine new_cylinder_case

   !> Are speed, stress and load of sizes that can be handled?
   pure logical function is_possible_adhesive_cylinder(values, given) result(is_possible)
      !> Values of the variables, which have been checked one by one; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      type(adhesive_cylinder_point_t) :: point
      type(adhesive_slide_t) :: slide

      call new_cylinder_case(values, given, values(in%velocity), point, slide)
      is_possible = point%is_possible
   end function is_possible_adhesive_cylinder

   !> Add order of states, zone and works of the two edges.
   subroutine derive_adhesive_cylinder(list, values, given)
      type(derived_t), allocatable, intent(inout) :: list(:)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      type(adhesive_cylinder_point_t) :: point
      type(adhesive_slide_t) :: slide

      call new_cylinder_case(values, given, values(in%velocity), point, slide)
      if (point%is_possible) call derive_edges(list, slide, order_margin_of(slide%solid%ratios, slide%solid%relaxation), &
         & point%length, values(in%stress(1)), range_of(values(in%stress)))
   end subroutine derive_adhesive_cylinder

   !> Solve a point.
   pure subroutine solve_adhesive_cylinder(values, given, point, results, error_estimate, status)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      !> In: what the point before has left. Out: what this one leaves.
      type(adhesive_cylinder_point_t), intent(inout) :: point
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the main result [-].
      real(dp), intent(out) :: error_estimate
      !> Status of the point, one of `status_...`.
      integer, intent(out) :: status
      type(slide_state_t) :: other
      logical :: is_solved, has_other
      integer :: branch

      error_estimate = solved_digits
      status = status_not_converged
      call resolve_branches(values, given, point)
      if (.not. point%is_possible) return
      associate (b => point%branches)
         results(out%order_margin) = order_margin_of(b%slide%solid%ratios, b%slide%solid%relaxation)
         if (.not. b%has_curve) return
         if (b%is_complete) results(out%pull_off_load) = point%force_unit()*b%pull_off_load
         if (b%is_complete) results(out%pull_off_half_width) = merge(0.0_dp, &
            & point%length*b%curve%points(b%pull_off)%zones%half_width, b%is_at_touch)
         branch = merge(slide_adhered, slide_approach, nint(values(in%branch)) == branch_adhered)
         call state_of_load(b, point%load, branch, point%state, is_solved)
         if (.not. is_solved) return
         status = status_no_equilibrium
         if (point%state%regime == state_none) return
         call state_of_load(b, point%load, slide_adhered + slide_approach - branch, other, has_other)
      end associate
      if (has_other) results(out%branches_differ) = merge(1, 0, other%regime /= state_none &
         & .and. abs(other%friction - point%state%friction) > solved_digits*abs(other%friction))
      call store_state(values, point, results, error_estimate)
      status = status_solved
      if (.not. (results(out%violation) <= largest_violation .and. error_estimate <= sqrt(solved_digits))) &
         & status = status_not_converged
      if (status == status_solved) error_estimate = max(error_estimate, error_of_friction(point))
   end subroutine solve_adhesive_cylinder

   !> Relative error of a small friction, which is the difference of what both edges carry; 1 where it is below round-off.
   pure real(dp) function error_of_friction(point) result(error)
      !> A point with its state.
      type(adhesive_cylinder_point_t), intent(in) :: point

      associate (noise => digits_of_moment*carried_load(point)*length_of_zones(point))
         error = noise/max(abs(point%state%friction), noise)
      end associate
   end function error_of_friction

   !> What the contact carries, reduced: the load and the tension outside it.
   pure real(dp) function carried_load(point)
      !> A point with its state.
      type(adhesive_cylinder_point_t), intent(in) :: point

      associate (z => point%state%zones)
         carried_load = abs(point%state%load) + point%branches%slide%stress*(z%leading + z%trailing)
      end associate
   end function carried_load

   !> Half of the contact and both zones, reduced.
   pure real(dp) function length_of_zones(point)
      !> A point with its state.
      type(adhesive_cylinder_point_t), intent(in) :: point

      associate (z => point%state%zones)
         length_of_zones = z%half_width + z%leading + z%trailing
      end associate
   end function length_of_zones

   !> The branches: those of the point before, or new ones. Their curve ends at a load that depends on this point alone.
   pure subroutine resolve_branches(values, given, point)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      type(adhesive_cylinder_point_t), intent(inout) :: point
      type(adhesive_slide_t) :: slide
      real(dp) :: sizes(5), material(n_spectrum_rows), end_of_curve
      logical :: is_found

      material = point%material
      call new_cylinder_case(values, given, values(in%velocity), point, slide)
      if (.not. is_same_spectrum(material, point%material)) point%sizes = unset
      if (.not. point%is_possible) return
      end_of_curve = least_end
      do while (end_of_curve < point%load)
         end_of_curve = step_of_end*end_of_curve
      end do
      sizes = [values(in%radius), values(in%velocity)*shift_factor_of(point%material, given), values(in%stress(1)), &
         & range_of(values(in%stress)), end_of_curve]
      if (all(sizes >= point%sizes .and. sizes <= point%sizes)) return
      point%sizes = sizes
      call find_branches(slide, point%branches, is_found, end_of_curve)
   end subroutine resolve_branches

   !> Results of a state.
   pure subroutine store_state(values, point, results, error_estimate)
      real(dp), intent(in) :: values(:)
      type(adhesive_cylinder_point_t), intent(in) :: point
      !> Receives the results; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      real(dp), intent(out) :: error_estimate
      type(slide_profile_t) :: profile
      type(slide_survey_t) :: survey
      real(dp) :: losses

      call new_slide_profile(point%branches%slide, point%state%zones, profile)
      call survey_slide(profile, survey)
      associate (state => point%state, z => point%state%zones, load => values(in%load), l => point%length)
         results(out%load) = load
         results([out%half_width, out%contact_shift]) = l*[z%half_width, point%direction*z%middle]
         results([out%zone_leading, out%zone_trailing]) = l*[z%leading, z%trailing]
         results(out%peak_pressure) = point%pressure_unit()*survey%peak_pressure
         results(out%mean_pressure) = load/(2*results(out%half_width))
         results(out%friction_force) = point%friction_unit()*state%friction
         if (load > 0) results(out%friction_coefficient) = results(out%friction_force)/load
         if (load > 0) call split_friction(point, results)
         results(out%dissipation) = abs(results(out%friction_force))
         losses = max(abs(state%friction), small_share*carried_load(point)*length_of_zones(point))
         results(out%energy_imbalance) = (survey%friction - state%friction)/losses
         results(out%violation) = survey%violation
         error_estimate = max(solved_digits, abs(results(out%energy_imbalance)), abs(survey%load - state%load)/carried_load(point))
      end associate
   end subroutine store_state

   !> The parts of the losses, by definition: those of the same load without adhesion, and the rest.
   pure subroutine split_friction(point, results)
      type(adhesive_cylinder_point_t), intent(in) :: point
      real(dp), intent(inout) :: results(:)
      type(cylinder_contact_t) :: contact
      logical :: is_converged

      call cylinder_of_load(point%branches%slide%solid, 4*point%load/pi, contact, is_converged)
      if (.not. is_converged) return
      results(out%friction_without_adhesion) = point%friction_unit()*point%load*contact%half_width*contact%friction_ratio
      results(out%adhesive_friction_force) = results(out%friction_force) - results(out%friction_without_adhesion)
   end subroutine split_friction

   !> Pressure and gap across the cylinder.
   pure subroutine get_adhesive_cylinder_profiles(point, coordinates, pressure, gap)
      type(adhesive_cylinder_point_t), intent(in) :: point
      !> Positions from the lowest line [m]; shape `(n)`.
      real(dp), intent(in) :: coordinates(:)
      !> Pressure [Pa] and gap [m]; shape `(n)`.
      real(dp), intent(out) :: pressure(:), gap(:)
      type(slide_profile_t) :: profile
      real(dp) :: from_left, from_right
      integer :: i

      call new_slide_profile(point%branches%slide, point%state%zones, profile)
      associate (z => point%state%zones, slide => point%branches%slide)
         do i = 1, size(coordinates)
            from_left = point%direction*coordinates(i)/point%length - (z%middle - z%half_width)
            from_right = (z%middle + z%half_width) - point%direction*coordinates(i)/point%length
            pressure(i) = 0
            gap(i) = 0
            if (from_left > 0 .and. from_right > 0) then
               pressure(i) = slide_pressure(profile, from_left, from_right)
            else if (from_right < 0) then
               gap(i) = slide_gap(profile, -from_right, .false.)
            else if (from_left < 0) then
               gap(i) = slide_gap(profile, -from_left, .true.)
            end if
            if (max(-from_left - z%trailing, -from_right - z%leading) <= 0 .and. min(from_left, from_right) <= 0) &
               & pressure(i) = -slide%stress
         end do
      end associate
      pressure = point%pressure_unit()*pressure
      gap = point%length*point%slope*gap
   end subroutine get_adhesive_cylinder_profiles

end module adfric_plane_adhesive_cylinder_point
