! SPDX-License-Identifier: GPL-3.0-or-later
!> One point of `hertz` over a viscoelastic half-plane, from the values of a namelist to results and profiles.
module adfric_plane_sliding_cylinder_point
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: unset
   use adfric_plane_hertz_variables, only: in => hertz_input, out => hertz_output
   use adfric_plane_sliding_cylinder_survey, only: cylinder_survey_t
   use adfric_plane_sliding_cylinder_units, only: cylinder_slide_t, cylinder_slide_state_t, new_cylinder_slide
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_solid_prony, only: prony_t
   use adfric_solid_spectrum_rows, only: get_spectrum, is_same_spectrum, n_spectrum_rows, shift_factor_of
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_status, only: status_solved, status_not_converged
   implicit none (type, external)
   private
   public :: cylinder_point_t, is_possible_cylinder, solve_cylinder, get_cylinder_profiles, get_cylinder_frequency

   !> What the closed forms leave of the digits.
   real(dp), parameter :: closed_form = 100*epsilon(1.0_dp)
   !> Dissipation below this share of load times half-width over radius is a small difference in the work of the pressure, which both
   !> sides of the cylinder do.
   real(dp), parameter :: small_share = 1.0e-3_dp

   !> What a point leaves: its contact, and the spectrum, which may be that of the next point.
   type, extends(point_state_t) :: cylinder_point_t
      !> Values of the material, from which the spectrum follows.
      real(dp) :: material(n_spectrum_rows) = unset
      !> Spectrum of contact moduli [Pa, s].
      type(prony_t) :: prony
      !> What slides on what.
      type(cylinder_slide_t) :: slide
      !> The contact.
      type(cylinder_slide_state_t) :: contact
   end type cylinder_point_t

contains

   !> What slides on what.
   pure subroutine resolve_cylinder(values, given, point, is_possible)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      !> In: what the point before has left. Out: spectrum, cylinder and speed of this one.
      type(cylinder_point_t), intent(inout) :: point
      !> Are speed and load such that double precision can handle them?
      logical, intent(out) :: is_possible

      associate (material => values(in%material(1):in%temperature))
         if (.not. is_same_spectrum(material, point%material)) then
            call get_spectrum(material, given, point%prony)
            point%material = material
         end if
         call new_cylinder_slide(point%slide, values(in%radius), point%prony, values(in%velocity)*shift_factor_of(material, &
            & given), &
            & is_possible)
      end associate
      if (is_possible) is_possible = point%slide%suits_load(point%prony, values(in%load))
   end subroutine resolve_cylinder

   !> Are speed and load such that double precision can handle them?
   pure logical function is_possible_cylinder(values, given) result(is_possible)
      !> Values of the variables, which have been checked one by one; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      type(cylinder_point_t) :: point

      call resolve_cylinder(values, given, point, is_possible)
   end function is_possible_cylinder

   !> The angular frequency V/w that belongs to the half-width w of the contact [rad/s]; 0 without contact, or where none is found.
   pure subroutine get_cylinder_frequency(values, given, frequency)
      !> Values of the variables, which have been checked; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      !> Receives the frequency.
      real(dp), intent(out) :: frequency
      type(cylinder_point_t) :: point
      logical :: is_solved

      frequency = 0
      call resolve_cylinder(values, given, point, is_solved)
      if (.not. is_solved) return
      call point%slide%solve_load(values(in%load), point%contact, is_solved)
      if (is_solved .and. point%contact%half_width > 0) frequency = abs(values(in%velocity))/point%contact%half_width
   end subroutine get_cylinder_frequency

   !> Solve a point.
   pure subroutine solve_cylinder(values, given, point, results, error_estimate, status)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      !> In: what the point before has left. Out: what this one leaves.
      type(cylinder_point_t), intent(inout) :: point
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the main result [-].
      real(dp), intent(out) :: error_estimate
      !> Status of the point, one of `status_...`.
      integer, intent(out) :: status
      logical :: is_solved

      error_estimate = closed_form
      status = status_not_converged
      call resolve_cylinder(values, given, point, is_solved)
      if (.not. is_solved) return
      call point%slide%solve_load(values(in%load), point%contact, is_solved)
      if (.not. is_solved) return
      status = status_solved
      call store(values, point, results)
   end subroutine solve_cylinder

   !> Results of a contact.
   pure subroutine store(values, point, results)
      real(dp), intent(in) :: values(:)
      type(cylinder_point_t), intent(in) :: point
      !> Receives the results; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      type(cylinder_survey_t) :: survey
      real(dp) :: losses

      call point%slide%get_survey(point%contact, survey)
      associate (contact => point%contact, load => values(in%load))
         results([out%load, out%half_width, out%contact_area]) = [load, contact%half_width, 2*contact%half_width]
         results([out%peak_pressure, out%violation]) = [survey%peak_pressure, survey%violation]
         results(out%mean_pressure) = 0
         results(out%friction_force) = contact%friction_force
         results(out%dissipation) = abs(contact%friction_force)
         results(out%energy_imbalance) = 0
         if (.not. contact%half_width > 0) return
         results(out%mean_pressure) = load/(2*contact%half_width)
         results(out%friction_coefficient) = contact%friction_coefficient
         results(out%contact_shift) = contact%contact_shift
         losses = max(abs(contact%friction_coefficient), small_share*contact%half_width/values(in%radius))
         results(out%energy_imbalance) = (abs(survey%friction_ratio) - abs(contact%friction_coefficient))/losses
      end associate
   end subroutine store

   !> Pressure and gap across the contact.
   pure subroutine get_cylinder_profiles(point, coordinates, pressure, gap)
      type(cylinder_point_t), intent(in) :: point
      !> Positions, from the lowest line of the cylinder [m]; shape `(n)`.
      real(dp), intent(in) :: coordinates(:)
      !> Pressure [Pa] and gap [m]; shape `(n)`.
      real(dp), intent(out) :: pressure(:), gap(:)
      integer :: i

      do i = 1, size(coordinates)
         pressure(i) = point%slide%pressure_at(point%contact, coordinates(i))
         gap(i) = point%slide%gap_at(point%contact, coordinates(i))
      end do
   end subroutine get_cylinder_profiles

end module adfric_plane_sliding_cylinder_point
