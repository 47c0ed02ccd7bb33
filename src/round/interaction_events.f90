! SPDX-License-Identifier: GPL-3.0-or-later
!> What happens to an indenter as a tangential force grows from 0: the largest force, the onset of sliding, and where the contact is lost
!> (J 4.1-4.9, fig. 9), its contact in sliding, and its jumps on a lateral spring.
module adfric_round_interaction_events
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_round_contact_state, only: contact_t
   use adfric_round_interaction_path, only: complete_waypoint, end_capped, end_no_adhesion, end_none, end_sliding, end_snap_off, &
      & gamma_of, get_waypoint, interaction_path_t, waypoint_t
   use adfric_round_interaction_search, only: find_end, find_peak
   use adfric_round_pulled_indenter, only: pulled_indenter_t, take_indenter_curve
   use adfric_interface_interaction, only: adhesion_ratio
   use adfric_round_pulled_contact, only: pulled_curve_t
   use adfric_round_shrinking_path, only: displacement_of, force_of, turn
   use adfric_round_stick_slip, only: find_critical_stiffness, find_stick_slip, forget_stick_slip, stick_slip_t
   implicit none (type, external)
   private
   public :: peeling_events_t, find_peeling_events, forget_peeling_events, results_of_events, slide

   !> What happens; NaN where it does not.
   type :: peeling_events_t
      !> Is there contact at rest, and have all searches converged?
      logical :: is_found = .false., is_converged = .true.
      !> How the part of the path ends where the contact changes, one of `end_...`.
      integer :: ending = end_none
      !> The largest force before sliding, its displacement, and gamma = e/b.
      real(dp) :: peak_force = 0, peak_displacement = 0, peak_gamma = 0
      !> The force of sliding, and how far it is below the largest force.
      real(dp) :: sliding_force = 0, force_drop = 0
      !> Force and displacement where the contact is lost: it snaps off, or jumps to a smaller one.
      real(dp) :: snap_off_force = 0, snap_off_displacement = 0
      !> The stiffness of a lateral spring from which on there is no stick-slip; see `find_critical_stiffness`.
      real(dp) :: critical_stiffness = 0
      !> The jump on a lateral spring.
      type(stick_slip_t) :: jump
   end type peeling_events_t

contains

   !> Nothing happens.
   pure subroutine forget_peeling_events(events)
      !> Receives NaN for all events.
      type(peeling_events_t), intent(out) :: events

      associate (none => not_a_number())
         events = peeling_events_t(.false., .true., end_none, none, none, none, none, none, none, none, none)
      end associate
      call forget_stick_slip(events%jump)
   end subroutine forget_peeling_events

   !> The events of a path.
   pure subroutine find_peeling_events(path, stiffness, events)
      class(interaction_path_t), intent(inout) :: path
      !> Stiffness of a lateral spring, reduced; 0 without one.
      real(dp), intent(in) :: stiffness
      type(peeling_events_t), intent(out) :: events
      type(waypoint_t) :: onset, peak, sliding
      logical :: is_found, is_converged

      call forget_peeling_events(events)
      events%is_found = path%start%is_found
      if (.not. events%is_found) return
      call find_end(path, events%is_converged)
      events%ending = path%ending
      if (.not. events%is_converged) return
      onset = path%finish
      if (path%ending == end_capped) call turn(half_pi, onset)
      peak = onset
      call find_peak(path, peak, is_found, is_converged)
      events%is_converged = is_converged
      events%peak_force = force_of(path, peak)
      events%peak_displacement = displacement_of(path, peak)
      events%peak_gamma = gamma_of(peak)
      is_found = .false.
      if (path%ending == end_sliding .or. path%ending == end_capped) call slide(path, sliding, is_found)
      if (is_found) then
         events%sliding_force = force_of(path, sliding)
         events%force_drop = events%peak_force - events%sliding_force
      else if (path%ending == end_snap_off .or. path%ending == end_sliding) then
         events%snap_off_force = force_of(path, onset)
         events%snap_off_displacement = displacement_of(path, onset)
      end if
      if (path%ending == end_no_adhesion .or. .not. is_converged) return
      events%critical_stiffness = 0
      if (path%is_weakened) call add_jump(path, stiffness, events)
   end subroutine find_peeling_events

   !> Add what happens on a lateral spring.
   pure subroutine add_jump(path, stiffness, events)
      !> The path, whose end is known.
      class(interaction_path_t), intent(in) :: path
      !> Stiffness of the spring, reduced; 0 without one.
      real(dp), intent(in) :: stiffness
      !> In: with all other events. Out: with the jump, too.
      type(peeling_events_t), intent(inout) :: events
      ! share of X that is beyond the last state for certain
      real(dp), parameter :: beyond = 1.0e-8_dp
      type(pulled_curve_t) :: curve
      type(pulled_indenter_t) :: pulled
      type(contact_t) :: smaller
      real(dp) :: force

      force = -1
      if (.not. ieee_is_nan(events%sliding_force)) force = events%sliding_force
      call take_indenter_curve(path, force, curve, pulled)
      events%is_converged = curve%is_converged
      call find_critical_stiffness(curve, events%critical_stiffness)
      if (.not. stiffness > 0) return
      call find_stick_slip(curve, stiffness, events%jump)
      if (path%ending /= end_snap_off .or. .not. events%jump%is_lost) return
      call path%find_remaining(path%finish%ratio*(1 - beyond), smaller)
      if (.not. (smaller%is_found .and. smaller%spot%radius > 0)) return
      ! where a smaller contact comes to rest is not known
      events%jump%arrest_force = not_a_number()
      events%jump%energy = not_a_number()
   end subroutine add_jump

   !> The state of sliding, g = g0: that of the path, or, where its contact has been lost, that of the contact that remains.
   pure subroutine slide(path, sliding, is_found)
      class(interaction_path_t), intent(inout) :: path
      type(waypoint_t), intent(out) :: sliding
      logical, intent(out) :: is_found

      is_found = .false.
      if (path%is_weakened .and. path%slip_energy_ratio > path%limit) return
      call get_waypoint(path, path%slip_energy_ratio, sliding)
      if (.not. sliding%is_found) then
         sliding%ratio = adhesion_ratio(path%slip_energy_ratio, path%law%interaction)
         call path%find_remaining(sliding%ratio, sliding%contact)
         sliding%is_found = sliding%contact%is_found .and. sliding%contact%spot%radius > 0
         if (sliding%is_found) call complete_waypoint(path, sliding)
      end if
      is_found = sliding%is_found
      call turn(half_pi, sliding)
   end subroutine slide

   !> The events as results, from the largest force to the work of a period, in the order of the tables of results.
   pure function results_of_events(events, force, displacement, stiffness) result(results)
      type(peeling_events_t), intent(in) :: events
      !> Units of forces, tangential displacements and stiffnesses.
      real(dp), intent(in) :: force, displacement, stiffness
      real(dp) :: results(14)

      associate (jump => events%jump)
         results = [force*events%peak_force, displacement*events%peak_displacement, force*events%sliding_force, &
            & force*events%force_drop, force*events%snap_off_force, displacement*events%snap_off_displacement, &
            & events%critical_stiffness*stiffness, displacement*jump%base_displacement, displacement*jump%displacement, &
            & force*jump%force, force*jump%arrest_force, force*displacement*jump%energy, displacement*jump%period, &
            & force*displacement*jump%work]
      end associate
   end function results_of_events

end module adfric_round_interaction_events
