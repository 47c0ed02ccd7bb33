! SPDX-License-Identifier: GPL-3.0-or-later
!> Results of a point of the model `indenter` but those of friction, in SI units, and their error.
module adfric_round_point_results
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_unset, only: is_set
   use adfric_interface_conduction_rows, only: conductances, n_conduction_results, n_conduction_rows
   use adfric_round_axis_stress, only: get_axis_stress
   use adfric_round_case, only: indenter_case_t
   use adfric_round_contact_state, only: contact_t, terms_of
   use adfric_round_curve, only: control_load, control_radius, control_spring
   use adfric_round_energy, only: elastic_energy
   use adfric_round_loop, only: loop_t
   use adfric_round_survey, only: ends_t
   use adfric_round_variables, only: theory_dmt, theory_none, in => indenter_input, out => indenter_output
   implicit none (type, external)
   private
   public :: store_ends, store_events, store_contact, store_stress, estimate_error

contains

   !> Where contacts end, in SI units.
   pure subroutine store_ends(case, ends, results)
      type(indenter_case_t), intent(in) :: case
      type(ends_t), intent(in) :: ends
      !> Receives them; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)

      results([out%pull_off_load, out%jump_inward_load, out%jump_outward_load]) = case%force_unit() &
         & *[ends%pull_off_load, ends%jump_inward_load, ends%jump_outward_load]
      results([out%pull_off_approach, out%jump_inward_approach, out%jump_outward_approach]) = case%height_unit &
         & *[ends%pull_off_approach, ends%jump_inward_approach, ends%jump_outward_approach]
   end subroutine store_ends

   !> What happens in a cycle, in SI units. Without adhesion nothing jumps.
   pure subroutine store_events(case, loop, results)
      type(indenter_case_t), intent(in) :: case
      type(loop_t), intent(in) :: loop
      !> Receives it; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)

      results(out%loop_energy) = 0
      if (case%theory == theory_none) return
      results(out%loop_energy) = loop%energy*case%force_unit()*case%height_unit
      results(out%jump_in_base_approach) = loop%jump_in*case%height_unit
      results(out%jump_in_load) = loop%jump_in_load*case%force_unit()
      results(out%pull_off_base_approach) = loop%pull_off*case%height_unit
   end subroutine store_events

   !> Results of a contact, in SI units. What was given comes back to the last digit.
   pure subroutine store_contact(case, contact, values, results)
      type(indenter_case_t), intent(in) :: case
      type(contact_t), intent(in) :: contact
      real(dp), intent(in) :: values(:)
      !> Receives the results; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      real(dp) :: radius

      associate (a => contact%spot%radius)
         radius = a*case%length_unit
         if (is_set(values(in%contact_radius))) radius = values(in%contact_radius)
         results(out%load) = contact%load*case%force_unit()
         if (is_set(values(in%load))) results(out%load) = values(in%load)
         results(out%approach) = contact%approach*case%height_unit
         if (is_set(values(in%approach))) results(out%approach) = values(in%approach)
         if (is_set(values(in%base_approach))) results(out%base_approach) = values(in%base_approach)
         results(out%contact_radius) = radius
         results(out%contact_area) = pi*radius**2
         if (a > 0) results(out%mean_pressure) = contact%load/(pi*a**2)*case%modulus*(case%height_unit/case%length_unit)
         results(out%contact_stiffness) = contact%stiffness*case%modulus*case%length_unit
         ! a circular punch has the stiffness 2 E* a, whatever adhesion does to that of the contact
         call conductances(values(in%conduction(1):in%conduction(n_conduction_rows)), 2*radius, &
            & results(out%conductances(1):out%conductances(n_conduction_results)))
         results(out%elastic_energy) = elastic_energy(case%curve, contact)*case%force_unit()*case%height_unit
         results(out%stable) = merge(1, 0, contact%is_stable)
         results(out%theory_used) = case%theory
         if (case%theory /= theory_dmt) results(out%adhesion_radius) = contact%adhesion_radius*case%length_unit
      end associate
   end subroutine store_contact

   !> Stresses on the axis, in SI units.
   pure subroutine store_stress(case, contact, values, results)
      type(indenter_case_t), intent(in) :: case
      type(contact_t), intent(in) :: contact
      real(dp), intent(in) :: values(:)
      real(dp), intent(inout) :: results(:)
      real(dp) :: s_zz, s_rr, unit

      call get_axis_stress(case%curve%shape, contact, values(in%poisson_ratio), values(in%position_z)/case%length_unit, s_zz, s_rr)
      unit = case%modulus*(case%height_unit/case%length_unit)
      results(out%stress_zz) = s_zz*unit
      results(out%stress_rr) = s_rr*unit
   end subroutine store_stress

   !> Round-off of what is prescribed moves the contact along the curve, at the end of stability by the root of round-off; load and
   !> approach are differences. The largest relative error of radius, load and approach, the latter two against at least a tenth of
   !> pull-off.
   pure real(dp) function estimate_error(case, contact, ends) result(error)
      type(indenter_case_t), intent(in) :: case
      type(contact_t), intent(in) :: contact
      type(ends_t), intent(in) :: ends
      real(dp), parameter :: round_off = 2*epsilon(1.0_dp), least_share = 0.1_dp
      real(dp) :: terms(2), best(2), sizes(2), shares(2), index, shift, slope
      integer :: k

      error = round_off
      associate (spot => contact%spot)
         terms = terms_of(contact)
         sizes = abs([contact%load, contact%approach])
         ! where no contact is stable there is no pull-off
         if (.not. ieee_is_nan(ends%pull_off_load)) then
            sizes = max(sizes, least_share*abs([ends%pull_off_load, ends%pull_off_approach]))
         end if
         best = terms
         if (case%control == control_spring) best = min(terms, [(abs(case%given) + terms(2))/case%curve%compliance, &
            & abs(case%given) + case%curve%compliance*terms(1)])
         do k = 1, 2
            if (sizes(k) > 0) error = max(error, 2*round_off*best(k)/sizes(k))
         end do
         ! that of a disc without touch is its radius
         index = contact%u
         if (contact%disc_terms(2) > 0) index = contact%adhesion_radius
         if (case%control == control_radius .or. .not. index > 0 .or. case%curve%shape%n_pieces == 0) return
         ! change of u that round-off of what is prescribed makes
         shares = 0
         shares(merge(1, 2, case%control == control_load)) = 1
         if (case%control == control_spring) shares(1) = case%curve%compliance
         shift = sqrt(round_off)*index
         slope = abs(sum(shares*contact%slopes))
         if (round_off*sum(shares*terms) < shift*slope) shift = round_off*sum(shares*terms)/slope
         if (contact%disc_terms(2) > 0) then
            error = error + shift/index
         else
            error = error + shift*spot%radius_slope/spot%radius
         end if
         do k = 1, 2
            ! what is given has no such error
            if (sizes(k) > 0 .and. k /= case%control) error = error + shift*abs(contact%slopes(k))/sizes(k)
         end do
         ! no digits at all
         error = min(error, 1.0_dp)
      end associate
   end function estimate_error

end module adfric_round_point_results
