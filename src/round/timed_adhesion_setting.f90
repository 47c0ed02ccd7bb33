! SPDX-License-Identifier: GPL-3.0-or-later
!> One point of the model `adhesive_indenter_time`: from the values of its variables to a contact in units of its own, with the
!> ends of its history and the cells of its first grid.
module adfric_round_timed_adhesion_setting
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_unset, only: is_set
   use adfric_round_case, only: indenter_case_t, is_possible, resolve_case
   use adfric_round_contact, only: find_contact
   use adfric_round_contact_state, only: contact_t
   use adfric_round_dugdale_curve, only: dugdale_curve_t
   use adfric_round_indenter_states, only: plain_indenter
   use adfric_round_survey, only: survey_t, survey_curve
   use adfric_round_timed_adhesion_path, only: close_path
   use adfric_round_timed_adhesion_rows, only: adhesion_input
   use adfric_round_timed_history, only: get_legs, largest_prescribed, path_triangle, steps_of_leg, timed_input
   use adfric_round_timed_model, only: indenter_time_t
   use adfric_round_timed_path, only: timed_control_t, timed_leg_t
   use adfric_round_timed_setting, only: before_history, before_solid, n_timed_variables
   use adfric_round_variables, only: choose_maugis_dugdale, in => indenter_input, n_indenter_variables
   use adfric_solid_prony, only: new_prony, prony_t
   use adfric_solid_spectrum_rows, only: get_spectrum, shift_factor_of
   implicit none (type, external)
   private
   public :: setting_t, set_up, values_of_indenter

   !> Cells of a first grid in a zone and, for a tolerance of 1e-3, in the largest radius of adhesion and in the unit of length of a
   !> shape that has none itself. A first grid too many costs a quarter of the last one; a last one too many costs four times all.
   real(dp), parameter :: per_zone = 8, per_radius = 60, per_unit = 24

   !> A point in units of its contact.
   type :: setting_t
      !> The indenter with its units.
      type(indenter_case_t) :: case
      !> The solid, whose relaxed modulus is 1.
      type(prony_t) :: solid
      !> The relaxed contact where most is prescribed.
      type(contact_t) :: largest
      !> Stress and range of adhesion.
      real(dp) :: stress = 1, range = 1
      !> What is prescribed.
      type(timed_control_t) :: control
      !> Its legs; shape `(n_legs)`.
      type(timed_leg_t), allocatable :: legs(:)
      !> Legs before those that are written, and steps of each.
      integer :: n_before = 0, n_per_leg = 1
      !> Cells of the first grid, and of the zone of adhesion beside a relaxed contact.
      real(dp) :: cell = 1, per_zone = 1
      !> Does retraction end where contact is lost?
      logical :: is_closed = .false.
   end type setting_t

contains

   !> The values that the model `indenter` would have with this adhesion.
   pure function values_of_indenter(values) result(indenter)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      real(dp) :: indenter(n_indenter_variables)

      indenter = plain_indenter(values(:in%coefficient_8))
      indenter(in%theory) = choose_maugis_dugdale
      indenter(in%work_of_adhesion:in%lambda) = values(n_timed_variables + 1:n_timed_variables + adhesion_input%lambda)
   end function values_of_indenter

   !> A point in units of its contact.
   pure subroutine set_up(self, values, setting, is_found)
      !> The lists of the history and of the solid.
      class(indenter_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the point.
      type(setting_t), intent(out) :: setting
      !> Are all numbers within bounds?
      logical, intent(out) :: is_found
      real(dp) :: indenter(n_indenter_variables), largest
      type(prony_t) :: solid
      type(survey_t) :: survey

      associate (history => values(before_history + 1:n_timed_variables), rows => values(before_solid + 1:before_history))
         call get_spectrum(rows, self%given, solid)
         is_found = solid%relaxed > 0
         if (.not. is_found) return
         call new_prony(setting%solid, 1.0_dp, solid%moduli/solid%relaxed, solid%times*shift_factor_of(rows, self%given))
         indenter = values_of_indenter(values)
         indenter(in%contact_modulus) = solid%relaxed
         largest = largest_prescribed(history, self%lists)
         if (is_set(history(timed_input%loads)) .or. is_set(history(timed_input%largest_load))) then
            indenter(in%load) = largest
         else if (is_set(history(timed_input%machine_stiffness))) then
            indenter(in%base_approach) = largest
            indenter(in%machine_stiffness) = history(timed_input%machine_stiffness)
         else
            indenter(in%approach) = largest
         end if
         call resolve_case(indenter, setting%case)
         is_found = is_possible(indenter, setting%case)
         if (.not. is_found) return
         associate (case => setting%case)
            call survey_curve(case%curve, case%control, survey)
            call find_contact(case%curve, survey, case%control, case%given, .true., case%branch, setting%largest)
            is_found = setting%largest%is_found .and. setting%largest%is_converged
            if (.not. is_found) return
            select type (curve => case%curve)
            type is (dugdale_curve_t)
               setting%stress = curve%stress
               setting%range = curve%range
            end select
            call get_legs(history, self%lists, case%height_unit, case%force_unit(), setting%range, setting%control, &
               & setting%legs, setting%n_before)
         end associate
         is_found = all(abs(setting%legs%end) < 1.0e100_dp) .and. all(abs(setting%legs%begin) < 1.0e100_dp) .and. &
            & setting%control%by_load < 1.0e100_dp
         setting%n_per_leg = steps_of_leg(history)
         call set_ends(setting, is_set(history(timed_input%path)))
         setting%is_closed = .false.
         if (is_set(history(timed_input%path))) setting%is_closed = nint(history(timed_input%path)) == path_triangle
         call choose_cell(setting, values(n_timed_variables + adhesion_input%cells), history(timed_input%relative_tolerance))
      end associate
   end subroutine set_up

   !> A history begins out of contact.
   pure subroutine set_ends(setting, has_path)
      type(setting_t), intent(inout) :: setting
      !> Has the path a name?
      logical, intent(in) :: has_path
      real(dp) :: apart, pulled

      apart = -setting%range*setting%control%by_approach
      if (has_path) then
         ! no stress is above S, and no radius above the largest relaxed one
         associate (c => setting%largest%adhesion_radius)
            pulled = 2*apart - 2*setting%stress*c*setting%control%by_approach - pi*setting%stress*c**2*setting%control%by_load
         end associate
         call close_path(setting%legs, apart, pulled)
      else if (setting%n_before > 0) then
         setting%legs(1)%begin = apart
      else if (setting%legs(1)%begin > apart) then
         setting%legs = [timed_leg_t(begin=apart, end=setting%legs(1)%begin), setting%legs]
         setting%n_before = 1
      end if
   end subroutine set_ends

   !> Cells that radii and zone need, or those that are given.
   pure subroutine choose_cell(setting, given, tolerance)
      type(setting_t), intent(inout) :: setting
      !> Cells up to the largest radius of adhesion; 0 if not given.
      real(dp), intent(in) :: given
      !> Largest error.
      real(dp), intent(in) :: tolerance
      real(dp) :: zone, more

      associate (shape => setting%case%curve%shape, radius => setting%largest%adhesion_radius)
         zone = pi/4*setting%range/setting%stress
         if (given > 0) then
            setting%cell = radius/given
         else
            ! what two grids say together has an error between third and fourth order
            more = (1.0e-3_dp/tolerance)**0.25_dp
            setting%cell = min(radius/(per_radius*more), zone/per_zone)
            if (.not. shape%corner > 0 .and. .not. shape%edge < huge(radius)) setting%cell = min(setting%cell, 1/(per_unit*more))
         end if
         ! the kink at a corner is a node, also of cells twice as wide
         if (shape%corner > 0) setting%cell = shape%corner/(2*max(1.0_dp, anint(shape%corner/(2*setting%cell))))
         setting%per_zone = zone/setting%cell
      end associate
   end subroutine choose_cell

end module adfric_round_timed_adhesion_setting
