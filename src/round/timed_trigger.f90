! SPDX-License-Identifier: GPL-3.0-or-later
!> Pressing without adhesion that ends where a load is reached: the approach there.
module adfric_round_timed_trigger
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set, unset
   use adfric_describe_model, only: model_t
   use adfric_interface_normal_contact, only: normal_state_t
   use adfric_numerics_time_panels, only: find_fall, n_nodes
   use adfric_round_indenter_states, only: find_indenter_states, indenter_states_t, plain_indenter
   use adfric_round_timed_contact, only: advance, timed_contact_t
   use adfric_round_timed_history, only: has_power_law, n_timed_rows, pressing_alone, timed_input, timed_lists_t, top_row
   use adfric_round_timed_panel, only: timed_panel_t
   use adfric_round_timed_setting, only: before_history, before_solid, n_shape, new_timed_contact
   use adfric_round_variables, only: n_indenter_variables, in => indenter_input
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_solid_prony, only: prony_t
   use adfric_solid_spectrum_rows, only: get_spectrum
   implicit none (type, external)
   private
   public :: find_trigger

contains

   !> The approach at which pressing reaches the load that ends it, in place of this load. The contact is pressed at the same speed
   !> up to a larger approach: where the load is reached is a root in a panel.
   subroutine find_trigger(model, given, lists, values, is_found)
      !> The model, which may be stopped, and lists of the solid and of the history.
      class(model_t), intent(in) :: model
      type(given_spectrum_t), intent(in) :: given
      type(timed_lists_t), intent(in) :: lists
      !> In: values of the variables; shape `(n_variables)`. Out: the same without the load, if there is one.
      real(dp), intent(inout) :: values(:)
      !> Was it found, or is there none?
      logical, intent(out) :: is_found
      integer, parameter :: most_tries = 80
      ! how far beyond the root pressing may go, since errors count over the largest approach
      real(dp), parameter :: far = 1.5_dp, next = 1.2_dp
      type(timed_contact_t) :: contact
      type(indenter_states_t) :: states
      type(timed_panel_t) :: panel
      real(dp) :: top, end, trigger
      integer :: try, n_before
      logical :: is_reached

      associate (history => values(before_history + 1:before_history + n_timed_rows))
         trigger = history(timed_input%trigger_load)
         is_found = .not. is_set(trigger)
         if (is_found) return
         call guess_top(values, given, top, is_found)
         if (.not. is_found) return
         do try = 1, most_tries
            is_found = .false.
            call new_timed_contact([values(:before_history), pressing_alone(history, top)], given, lists, contact, states, &
               & n_before, is_found)
            if (.not. is_found) return
            is_reached = .false.
            do while (.not. (contact%is_done .or. is_reached))
               is_found = .not. model%is_stopped()
               if (is_found) call advance(contact, panel, is_found)
               if (.not. is_found) return
               is_reached = contact%load*states%case%force_unit() >= trigger
            end do
            if (.not. is_reached) then
               top = 2*top
               cycle
            end if
            end = top - history(timed_input%approach_rate)*(contact%legs(size(contact%legs))%span - (panel%clock + panel%span* &
               & (find_rise(panel%load - trigger/states%case%force_unit()) + 1)/2 - contact%legs(size(contact%legs))%clock))
            is_found = .not. end*far < top
            top = end
            if (is_found) exit
            top = next*top
         end do
         history(top_row(history)) = top
         history(timed_input%trigger_load) = unset
      end associate
   end subroutine find_trigger

   !> Where a polynomial that ends at or above 0 comes there for the first time.
   pure real(dp) function find_rise(values) result(root)
      !> Values at the nodes of a panel.
      real(dp), intent(in) :: values(n_nodes)

      root = find_fall(-values, 0.0_dp)
      if (root > 1) root = 1
   end function find_rise

   !> An approach from which the search for the end of pressing begins: that of an elastic solid.
   subroutine guess_top(values, given, top, is_found)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Lists of the solid.
      type(given_spectrum_t), intent(in) :: given
      !> Receives the approach [m], before its zero is taken off.
      real(dp), intent(out) :: top
      logical, intent(out) :: is_found
      real(dp) :: indenter(n_indenter_variables)
      type(indenter_states_t) :: states
      type(normal_state_t) :: state
      type(prony_t) :: solid

      top = 0
      associate (history => values(before_history + 1:before_history + n_timed_rows))
         indenter = plain_indenter(values(:n_shape))
         indenter(in%load) = history(timed_input%trigger_load)
         if (has_power_law(history)) then
            indenter(in%contact_modulus) = history(timed_input%power_law_modulus)
         else
            call get_spectrum(values(before_solid + 1:before_history), given, solid)
            indenter(in%contact_modulus) = solid%relaxed
         end if
         call find_indenter_states(indenter, states, is_found)
         if (.not. is_found) return
         call states%under_load(indenter(in%load)/states%case%force_unit(), state, is_found)
         if (.not. is_found) return
         top = state%approach*states%case%height_unit + max(0.0_dp, history(timed_input%contact_point))
         if (is_set(history(timed_input%machine_stiffness))) top = top + &
            & history(timed_input%trigger_load)/history(timed_input%machine_stiffness)
      end associate
   end subroutine guess_top

end module adfric_round_timed_trigger
