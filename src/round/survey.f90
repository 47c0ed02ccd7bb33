! SPDX-License-Identifier: GPL-3.0-or-later
!> The survey of a curve: its stable and unstable parts, where contacts separate, and where they jump.
!>
!> A curve may have several stable parts. Its least load is the least one of all stable states: the fold that a contact meets first
!> may only be a jump to a smaller contact.
module adfric_round_survey
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_round_contact_state, only: prescribed_of
   use adfric_round_curve, only: curve_t, state_t, curve_interval_t, disc_range_t, stability_control, most_intervals, &
      & most_disc_ranges
   use adfric_round_face_contact, only: get_face_end
   use adfric_round_prescribed, only: measure_interval
   implicit none (type, external)
   private
   public :: ends_t, survey_t, survey_curve

   !> Where contacts end under what is prescribed; NaN where there is no such end.
   type :: ends_t
      !> Have all been found to round-off?
      logical :: is_converged = .true.
      !> Load and approach of the last stable state before contact separates.
      real(dp) :: pull_off_load = 0, pull_off_approach = 0
      !> Load and approach from which contact jumps to a smaller one.
      real(dp) :: jump_inward_load = 0, jump_inward_approach = 0
      !> Load and approach from which contact jumps to a larger one.
      real(dp) :: jump_outward_load = 0, jump_outward_approach = 0
   end type ends_t

   !> The stable and the unstable parts of a curve under what is prescribed, and where contacts end: all that does not depend on the
   !> value that is prescribed.
   type :: survey_t
      !> Number of the parts.
      integer :: n = 0
      !> The parts, from the smallest contacts to the largest.
      type(curve_interval_t) :: intervals(most_intervals)
      !> Number of the ranges of discs without touch that are stable.
      integer :: n_discs = 0
      !> The ranges, from the smallest discs to the largest.
      type(disc_range_t) :: discs(most_disc_ranges)
      !> Where contacts end.
      type(ends_t) :: ends
   end type survey_t

contains

   !> The parts of a curve, and where contacts end under what is prescribed.
   pure subroutine survey_curve(curve, control, survey)
      class(curve_t), intent(in) :: curve
      !> What is prescribed; a given radius counts as a given load.
      integer, intent(in) :: control
      type(survey_t), intent(out) :: survey
      integer :: prescribed_control, k

      call clear_ends(survey%ends)
      prescribed_control = stability_control(control)
      call curve%find_intervals(prescribed_control, survey%intervals, survey%n, survey%ends%is_converged)
      do k = 1, survey%n
         call measure_interval(curve, prescribed_control, survey%intervals(k))
      end do
      if (curve%shape%n_pieces == 0) then
         call get_face_end(curve, prescribed_control, survey%ends%pull_off_load, survey%ends%pull_off_approach)
      else
         call curve%find_discs(prescribed_control, survey%discs, survey%n_discs)
         call find_pull_off(curve, prescribed_control, survey%intervals(:survey%n), survey%discs(:survey%n_discs), survey%ends)
         call find_jumps(curve, prescribed_control, survey%intervals(:survey%n), survey%ends)
      end if
   end subroutine survey_curve

   !> The stable state where what is prescribed is least.
   pure subroutine find_pull_off(curve, control, intervals, discs, ends)
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      type(curve_interval_t), intent(in) :: intervals(:)
      type(disc_range_t), intent(in) :: discs(:)
      type(ends_t), intent(inout) :: ends
      type(state_t) :: state
      real(dp) :: least
      integer :: k

      least = huge(least)
      do k = 1, size(intervals)
         if (.not. intervals(k)%is_stable) cycle
         call curve%get_state(intervals(k)%low, intervals(k)%is_beyond, state)
         call take_least(curve, control, state, least, ends)
      end do
      do k = 1, size(discs)
         call curve%get_disc(discs(k)%low, state)
         call take_least(curve, control, state, least, ends)
      end do
   end subroutine find_pull_off

   !> Take a state as the pull-off if it is the least one so far.
   pure subroutine take_least(curve, control, state, least, ends)
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      type(state_t), intent(in) :: state
      !> The least that is prescribed so far.
      real(dp), intent(inout) :: least
      type(ends_t), intent(inout) :: ends

      if (.not. prescribed_of(curve, control, state) < least) return
      least = prescribed_of(curve, control, state)
      ends%pull_off_load = state%load
      ends%pull_off_approach = state%approach
   end subroutine take_least

   !> No end is known.
   pure subroutine clear_ends(ends)
      !> Receives NaN for all ends.
      type(ends_t), intent(inout) :: ends

      ends%pull_off_load = not_a_number()
      ends%pull_off_approach = not_a_number()
      ends%jump_inward_load = not_a_number()
      ends%jump_inward_approach = not_a_number()
      ends%jump_outward_load = not_a_number()
      ends%jump_outward_approach = not_a_number()
   end subroutine clear_ends

   !> Jumps between stable parts: inward where a fold has another stable state, smaller and under the same load or approach;
   !> outward from the fold at the end of a stable part.
   pure subroutine find_jumps(curve, control, intervals, ends)
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      !> The intervals of the curve, from the smallest contacts to the largest.
      type(curve_interval_t), intent(in) :: intervals(:)
      type(ends_t), intent(inout) :: ends
      type(state_t) :: fold
      real(dp) :: prescribed
      integer :: k, j

      do k = 1, size(intervals)
         if (.not. intervals(k)%is_stable) cycle
         if (intervals(k)%ends_at_fold) then
            call curve%get_state(intervals(k)%high, intervals(k)%is_beyond, fold)
            ends%jump_outward_load = fold%load
            ends%jump_outward_approach = fold%approach
         end if
         if (.not. intervals(k)%begins_at_fold) cycle
         call curve%get_state(intervals(k)%low, intervals(k)%is_beyond, fold)
         prescribed = prescribed_of(curve, control, fold)
         do j = 1, k - 1
            if (.not. intervals(j)%is_stable) cycle
            if (prescribed < intervals(j)%first .or. prescribed > intervals(j)%last) cycle
            ends%jump_inward_load = fold%load
            ends%jump_inward_approach = fold%approach
         end do
      end do
   end subroutine find_jumps

end module adfric_round_survey
