! SPDX-License-Identifier: GPL-3.0-or-later
!> One point of `wave_1d` over a viscoelastic half-plane, from the values of a namelist to results and profiles.
module adfric_plane_sliding_wave_point
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_base_unset, only: is_set, unset
   use adfric_plane_sliding_wave_survey, only: wave_survey_t
   use adfric_plane_sliding_wave_units, only: wave_slide_t, wave_slide_state_t, new_wave_slide
   use adfric_plane_wave_variables, only: regime_full, regime_none, regime_partial, in => wave_input, out => wave_output
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_solid_prony, only: prony_t
   use adfric_solid_spectrum_rows, only: get_spectrum, is_same_spectrum, n_spectrum_rows, shift_factor_of
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_status, only: status_solved, status_no_equilibrium, status_not_converged
   implicit none (type, external)
   private
   public :: slide_point_t, is_possible_slide, solve_slide, get_slide_profiles

   !> What the closed forms leave of the digits.
   real(dp), parameter :: closed_form = 100*epsilon(1.0_dp)
   !> Dissipation below this share of mean pressure times steepest slope is a small difference in the work of the pressure, which
   !> both flanks of the wave do.
   real(dp), parameter :: small_share = 1.0e-3_dp

   !> What a point leaves: its contact, and the spectrum, which may be that of the next point.
   type, extends(point_state_t) :: slide_point_t
      !> Values of the material, from which the spectrum follows.
      real(dp) :: material(n_spectrum_rows) = unset
      !> Spectrum of contact moduli [Pa, s].
      type(prony_t) :: prony
      !> What slides on what.
      type(wave_slide_t) :: slide
      !> The contact.
      type(wave_slide_state_t) :: contact
   end type slide_point_t

contains

   !> What slides on what.
   pure subroutine resolve_slide(values, given, point, is_possible)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      !> In: what the point before has left. Out: spectrum, wave and speed of this one.
      type(slide_point_t), intent(inout) :: point
      !> Is the speed one that double precision can handle?
      logical, intent(out) :: is_possible

      associate (material => values(in%material(1):in%temperature))
         if (.not. is_same_spectrum(material, point%material)) then
            call get_spectrum(material, given, point%prony)
            point%material = material
         end if
         call new_wave_slide(point%slide, values(in%period), values(in%amplitude), point%prony, &
            & values(in%velocity)*shift_factor_of(material, given), is_possible)
      end associate
   end subroutine resolve_slide

   !> Is the speed one that double precision can handle?
   pure logical function is_possible_slide(values, given) result(is_possible)
      !> Values of the variables, which have been checked one by one; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      type(slide_point_t) :: point

      call resolve_slide(values, given, point, is_possible)
   end function is_possible_slide

   !> Solve a point. Beyond full contact the penetration of a half-plane is undefined.
   pure subroutine solve_slide(values, given, point, results, error_estimate, status)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      !> In: what the point before has left. Out: what this one leaves.
      type(slide_point_t), intent(inout) :: point
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the main result [-].
      real(dp), intent(out) :: error_estimate
      !> Status of the point, one of `status_...`.
      integer, intent(out) :: status
      type(wave_slide_state_t) :: full
      logical :: is_solved

      error_estimate = closed_form
      status = status_not_converged
      call resolve_slide(values, given, point, is_solved)
      if (.not. is_solved) return
      call point%slide%full_contact(full)
      results(out%full_contact_pressure) = full%mean_pressure
      if (is_set(values(in%mean_pressure))) then
         call point%slide%solve_pressure(values(in%mean_pressure), point%contact, is_solved)
      else
         if (values(in%penetration) > values(in%amplitude)) status = status_no_equilibrium
         if (status == status_no_equilibrium) return
         call point%slide%solve_penetration(values(in%penetration), point%contact, is_solved)
      end if
      if (.not. is_solved) return
      status = status_solved
      call store(values, point, results)
   end subroutine solve_slide

   !> Results of a contact.
   pure subroutine store(values, point, results)
      real(dp), intent(in) :: values(:)
      type(slide_point_t), intent(in) :: point
      !> Receives the results; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      type(wave_survey_t) :: survey
      real(dp) :: losses

      call point%slide%get_survey(point%contact, survey)
      associate (contact => point%contact)
         results([out%mean_pressure, out%penetration]) = [contact%mean_pressure, contact%penetration]
         ! what is given keeps its bits
         if (is_set(values(in%mean_pressure))) results(out%mean_pressure) = values(in%mean_pressure)
         if (is_set(values(in%penetration))) results(out%penetration) = values(in%penetration)
         results(out%contact_fraction) = contact%contact_fraction
         results(out%contact_width) = contact%contact_fraction*values(in%period)
         results([out%peak_pressure, out%violation]) = [survey%peak_pressure, survey%violation]
         results([out%mean_gap, out%largest_gap]) = [contact%mean_gap, survey%largest_gap]
         results(out%regime) = regime_partial
         if (.not. contact%contact_fraction > 0) results(out%regime) = regime_none
         if (contact%is_full) results(out%regime) = regime_full
         results(out%friction_stress) = contact%friction_stress
         results(out%friction_coefficient) = contact%friction_coefficient
         if (nint(results(out%regime)) == regime_partial) results(out%contact_shift) = contact%contact_shift
         results(out%dissipation) = abs(contact%friction_stress)
         losses = max(results(out%dissipation), small_share*contact%mean_pressure*two_pi*values(in%amplitude)/values(in%period))
         results(out%energy_imbalance) = 0
         if (losses > 0) results(out%energy_imbalance) = (abs(survey%friction) - results(out%dissipation))/losses
      end associate
   end subroutine store

   !> Pressure and gap along the wave.
   pure subroutine get_slide_profiles(point, coordinates, pressure, gap)
      type(slide_point_t), intent(in) :: point
      !> Positions along the wave, from a crest [m]; shape `(n)`.
      real(dp), intent(in) :: coordinates(:)
      !> Pressure [Pa] and gap [m]; shape `(n)`.
      real(dp), intent(out) :: pressure(:), gap(:)
      integer :: i

      do i = 1, size(coordinates)
         pressure(i) = point%slide%pressure_at(point%contact, coordinates(i))
         gap(i) = point%slide%gap_at(point%contact, coordinates(i))
      end do
   end subroutine get_slide_profiles

end module adfric_plane_sliding_wave_point
