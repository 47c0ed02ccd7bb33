! SPDX-License-Identifier: GPL-3.0-or-later
!> One point of the model `indenter_time`: from the values of its variables to a solid and a path in units of its contact.
module adfric_round_timed_setting
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_round_indenter_states, only: find_indenter_states, indenter_states_t, plain_indenter
   use adfric_round_timed_contact, only: start_contact, timed_contact_t
   use adfric_round_timed_course, only: join_legs
   use adfric_round_timed_history, only: get_legs, has_power_law, largest_prescribed, n_timed_rows, steps_of_leg, timed_input, &
      & timed_lists_t
   use adfric_round_timed_path, only: timed_control_t, timed_leg_t
   use adfric_round_variables, only: n_indenter_variables, in => indenter_input
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_solid_power_law, only: get_power_law, power_law_error
   use adfric_solid_prony, only: new_prony, prony_t
   use adfric_solid_spectrum_rows, only: get_spectrum, n_spectrum_rows, shift_factor_of
   implicit none (type, external)
   private
   public :: timed_setting_t, new_timed_contact, set_up_history, get_power_law_of

   !> Numbers of the rows of the shape, and indices before those of the solid and of the history.
   integer, parameter, public :: n_shape = in%coefficient_8, before_solid = n_shape, before_history = n_shape + n_spectrum_rows, &
      & n_timed_variables = before_history + n_timed_rows

   !> The solid and the path of a point.
   type :: timed_setting_t
      !> The solid, its relaxed modulus 1.
      type(prony_t) :: solid
      !> What is prescribed.
      type(timed_control_t) :: control
      !> Its legs; shape `(n_legs)`.
      type(timed_leg_t), allocatable :: legs(:)
      !> Legs before the first one that is written.
      integer :: n_before = 0
      !> Largest error of approach and load, over the largest ones.
      real(dp) :: tolerance = 0
   end type timed_setting_t

contains

   !> The springs of a point, before the begin of its history.
   pure subroutine new_timed_contact(values, given, lists, contact, states, n_before, is_possible)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Lists of the solid and of the history.
      type(given_spectrum_t), intent(in) :: given
      type(timed_lists_t), intent(in) :: lists
      !> Receives the springs, in units of `states`.
      type(timed_contact_t), intent(out) :: contact
      !> Receives the indenter on an elastic half-space of modulus 1.
      type(indenter_states_t), intent(out) :: states
      !> Receives the number of legs before the first one that is written.
      integer, intent(out) :: n_before
      !> Are all numbers within bounds?
      logical, intent(out) :: is_possible
      type(timed_setting_t) :: setting

      call set_up_history(values, given, lists, setting, states, is_possible)
      n_before = setting%n_before
      if (is_possible) call start_contact(contact, setting%solid, states, setting%control, setting%legs, setting%tolerance, &
         & is_possible)
   end subroutine new_timed_contact

   !> The solid and the path of a point, in units of its contact.
   pure subroutine set_up_history(values, given, lists, setting, states, is_possible)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Lists of the solid and of the history.
      type(given_spectrum_t), intent(in) :: given
      type(timed_lists_t), intent(in) :: lists
      !> Receives the solid and the path.
      type(timed_setting_t), intent(out) :: setting
      !> Receives the indenter on an elastic half-space of modulus 1, with the units.
      type(indenter_states_t), intent(out) :: states
      !> Are all numbers within bounds?
      logical, intent(out) :: is_possible
      !> Legs that are one straight line but for this part of the largest prescribed value are one leg, in a fit.
      real(dp), parameter :: straight = 1.0e-8_dp
      real(dp) :: indenter(n_indenter_variables), factor
      type(prony_t) :: solid

      associate (history => values(before_history + 1:), rows => values(before_solid + 1:before_history))
         factor = 1
         setting%tolerance = history(timed_input%relative_tolerance)
         if (has_power_law(history)) then
            ! digits beyond those of its arms would be sought in vain
            setting%tolerance = max(setting%tolerance, power_law_error/2)
            call get_power_law_of(history, lists, solid)
         else
            call get_spectrum(rows, given, solid)
            factor = shift_factor_of(rows, given)
         end if
         call new_prony(setting%solid, 1.0_dp, solid%moduli/solid%relaxed, solid%times*factor)
         indenter = plain_indenter(values(:n_shape))
         indenter(in%contact_modulus) = solid%relaxed
         if (is_set(history(timed_input%loads)) .or. is_set(history(timed_input%largest_load))) then
            indenter(in%load) = largest_prescribed(history, lists)
         else
            indenter(in%approach) = largest_prescribed(history, lists)
         end if
         call find_indenter_states(indenter, states, is_possible)
         if (.not. is_possible) return
         call get_legs(history, lists, states%case%height_unit, states%case%force_unit(), 0.0_dp, setting%control, &
            & setting%legs, setting%n_before)
         associate (legs => setting%legs)
            is_possible = all(abs(legs%end) < 1.0e100_dp) .and. all(abs(legs%begin) < 1.0e100_dp) .and. &
               & setting%control%by_load < 1.0e100_dp
         end associate
         if (is_set(history(timed_input%smoothing))) then
            call join_legs(setting%legs, history(timed_input%smoothing)/merge(states%case%height_unit, &
               & states%case%force_unit(), setting%control%by_approach > 0))
         else if (is_set(history(timed_input%time))) then
            call join_legs(setting%legs, straight*maxval(abs(setting%legs%end)))
         end if
      end associate
   end subroutine set_up_history

   !> The arms that a power law has for a history: for its length in time, and for the steps that are written of it.
   pure subroutine get_power_law_of(history, lists, solid)
      !> Values of the rows of the history; shape `(n_timed_rows)`.
      real(dp), intent(in) :: history(:)
      type(timed_lists_t), intent(in) :: lists
      !> Receives the arms [Pa, s].
      type(prony_t), intent(out) :: solid
      type(timed_control_t) :: control
      type(timed_leg_t), allocatable :: legs(:)
      integer :: n_before

      call get_legs(history, lists, 1.0_dp, 1.0_dp, 0.0_dp, control, legs, n_before)
      call get_power_law(history(timed_input%power_law_modulus), history(timed_input%power_law_exponent), sum(legs%span), &
         & minval(legs%span, legs%span > 0)/steps_of_leg(history), solid)
   end subroutine get_power_law_of

end module adfric_round_timed_setting
