! SPDX-License-Identifier: GPL-3.0-or-later
!> What happens to an indenter as a tangential force grows from 0: the largest force, the onset of sliding, and where the contact is lost
!> (J 4.1-4.9, fig. 9), its contact in sliding, and its jumps on a lateral spring.
module adfric_round_interaction_events
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_round_contact, only: branch_stable, find_contact
   use adfric_round_contact_state, only: contact_t
   use adfric_round_survey, only: survey_curve, survey_t
   use adfric_round_curve, only: curve_t
   use adfric_round_interaction_path, only: complete_waypoint, get_waypoint, interaction_path_t, waypoint_t
   use adfric_round_interaction_search, only: end_capped, end_no_adhesion, end_sliding, end_snap_off, &
      & find_end, find_peak
   use adfric_round_weak_path, only: weaken
   use adfric_round_pulled_indenter, only: pulled_indenter_t, take_indenter_curve
   use adfric_interface_interaction, only: adhesion_ratio
   use adfric_round_pulled_contact, only: pulled_curve_t
   use adfric_round_shrinking_path, only: displacement_of, force_of, turn
   use adfric_round_stick_slip, only: find_critical_stiffness, find_stick_slip, forget_stick_slip, stick_slip_t
   implicit none (type, external)
   private
   public :: peeling_events_t, find_peeling_events, forget_peeling_events, slide

   !> What happens; NaN where it does not.
   type :: peeling_events_t
      !> Have all searches converged?
      logical :: is_converged = .true.
      !> The largest force before sliding, and its displacement.
      real(dp) :: peak_force = 0, peak_displacement = 0
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
         events = peeling_events_t(.true., none, none, none, none, none, none, none)
      end associate
      call forget_stick_slip(events%jump)
   end subroutine forget_peeling_events

   !> The events of a path.
   pure subroutine find_peeling_events(path, stiffness, events)
      type(interaction_path_t), intent(inout) :: path
      !> Stiffness of a lateral spring, reduced; 0 without one.
      real(dp), intent(in) :: stiffness
      type(peeling_events_t), intent(out) :: events
      type(waypoint_t) :: finish, onset, peak, sliding
      integer :: ending
      logical :: is_found

      call forget_peeling_events(events)
      if (.not. path%start%is_found) return
      call find_end(path, finish, ending, events%is_converged)
      if (.not. events%is_converged) return
      onset = finish
      peak = onset
      if (ending == end_capped) call turn(half_pi, peak)
      call find_peak(path, onset, peak, is_found)
      if (ending == end_capped) call turn(half_pi, onset)
      events%peak_force = force_of(path, peak)
      events%peak_displacement = displacement_of(path, peak)
      is_found = .false.
      if (ending == end_sliding .or. ending == end_capped) call slide(path, sliding, is_found)
      if (is_found) then
         events%sliding_force = force_of(path, sliding)
         events%force_drop = events%peak_force - events%sliding_force
      else if (ending == end_snap_off .or. ending == end_sliding) then
         events%snap_off_force = force_of(path, onset)
         events%snap_off_displacement = displacement_of(path, onset)
      end if
      if (ending == end_no_adhesion) return
      events%critical_stiffness = 0
      if (path%is_weakened) call add_jump(path, finish, ending, stiffness, events)
   end subroutine find_peeling_events

   !> Add what happens on a lateral spring.
   pure subroutine add_jump(path, finish, ending, stiffness, events)
      type(interaction_path_t), intent(in) :: path
      !> The end of its part where the contact changes.
      type(waypoint_t), intent(in) :: finish
      !> One of `end_...`: how it ends.
      integer, intent(in) :: ending
      !> Stiffness of the spring, reduced; 0 without one.
      real(dp), intent(in) :: stiffness
      !> In: with all other events. Out: with the jump, too.
      type(peeling_events_t), intent(inout) :: events
      type(pulled_curve_t) :: curve
      type(pulled_indenter_t) :: contact
      real(dp) :: force

      force = -1
      if (.not. ieee_is_nan(events%sliding_force)) force = events%sliding_force
      call take_indenter_curve(path, finish, ending == end_capped, force, curve, contact)
      events%is_converged = curve%is_converged
      call find_critical_stiffness(curve, events%critical_stiffness)
      if (.not. stiffness > 0) return
      call find_stick_slip(curve, stiffness, events%jump)
      if (ending /= end_snap_off .or. .not. events%jump%is_lost) return
      if (.not. has_smaller(path, finish)) return
      ! where a smaller contact comes to rest is not known
      events%jump%arrest_force = not_a_number()
      events%jump%energy = not_a_number()
   end subroutine add_jump

   !> Is there a smaller contact where the one of a path has been lost?
   pure logical function has_smaller(path, finish)
      type(interaction_path_t), intent(in) :: path
      type(waypoint_t), intent(in) :: finish
      ! share of X that is beyond the last state for certain
      real(dp), parameter :: beyond = 1.0e-8_dp
      class(curve_t), allocatable :: curve
      type(survey_t) :: survey
      type(contact_t) :: contact

      allocate (curve, source=path%retreat%curve)
      call weaken(curve, finish%ratio*(1 - beyond))
      call survey_curve(curve, path%retreat%control, survey)
      call find_contact(curve, survey, path%retreat%control, path%retreat%given, .true., branch_stable, contact)
      has_smaller = contact%is_found .and. contact%spot%radius > 0
   end function has_smaller

   !> The state of sliding, g = g0: that of the path, or, where its contact has been lost, the largest stable one that remains.
   pure subroutine slide(path, sliding, is_found)
      type(interaction_path_t), intent(inout) :: path
      type(waypoint_t), intent(out) :: sliding
      logical, intent(out) :: is_found
      class(curve_t), allocatable :: curve
      type(survey_t) :: survey

      is_found = .false.
      if (path%is_weakened .and. path%slip_energy_ratio > path%limit) return
      call get_waypoint(path, path%slip_energy_ratio, sliding)
      if (.not. sliding%is_found) then
         allocate (curve, source=path%retreat%curve)
         sliding%ratio = adhesion_ratio(path%slip_energy_ratio, path%law%interaction)
         call weaken(curve, sliding%ratio)
         call survey_curve(curve, path%retreat%control, survey)
         call find_contact(curve, survey, path%retreat%control, path%retreat%given, .true., branch_stable, sliding%contact)
         sliding%is_found = sliding%contact%is_found .and. sliding%contact%spot%radius > 0
         if (sliding%is_found) call complete_waypoint(path, sliding)
      end if
      is_found = sliding%is_found
      call turn(half_pi, sliding)
   end subroutine slide

end module adfric_round_interaction_events
