! SPDX-License-Identifier: GPL-3.0-or-later
!> A cycle of approach and retraction, at a given approach or on a spring: where contact jumps in, where it lets go, and what
!> energy the jumps take.
!>
!> Bodies come from apart (0, or minus the range of adhesion) to the largest contact and back, along the stable stretches of one
!> curve (`adfric_round_stretches`). The last state of retraction is the one with the least of what is prescribed of all that
!> are stable.
module adfric_round_loop
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_round_contact, only: find_contact, reach_of, branch_stable
   use adfric_round_contact_state, only: contact_t
   use adfric_round_survey, only: survey_t
   use adfric_round_curve, only: curve_t, control_spring
   use adfric_round_stretches, only: follow_stretches, journey_t, list_stretches, potential_of, stretches_t
   implicit none (type, external)
   private
   public :: loop_t, find_loop

   !> What happens in a cycle, reduced; NaN where there is nothing of the kind.
   type :: loop_t
      !> What is prescribed where contact jumps in on approach, and the load right after: of the jump that takes most.
      real(dp) :: jump_in = 0, jump_in_load = 0
      !> What is prescribed in the last state of retraction.
      real(dp) :: pull_off = 0
      !> Energy that all jumps take.
      real(dp) :: energy = 0
      !> Were all states found to round-off?
      logical :: is_converged = .true.
   end type loop_t

contains

   !> The cycle.
   pure subroutine find_loop(curve, survey, control, loop)
      class(curve_t), intent(in) :: curve
      type(survey_t), intent(in) :: survey
      !> `control_approach` or `control_spring`.
      integer, intent(in) :: control
      type(loop_t), intent(out) :: loop
      type(stretches_t) :: stretches
      real(dp) :: apart

      loop%is_converged = survey%ends%is_converged
      loop%jump_in = not_a_number()
      loop%jump_in_load = not_a_number()
      loop%pull_off = survey%ends%pull_off_approach
      if (control == control_spring) loop%pull_off = loop%pull_off + curve%compliance*survey%ends%pull_off_load
      apart = reach_of(curve)
      if (curve%shape%n_pieces == 0) then
         call follow_face(curve, survey, control, apart, loop)
      else
         call list_stretches(survey, control, stretches)
         if (stretches%n > 0) call go_through(curve, stretches, apart, loop)
      end if
      if (.not. loop%is_converged .or. (stretches%n == 0 .and. curve%shape%n_pieces > 0)) loop%energy = not_a_number()
   end subroutine find_loop

   !> A flat face: it jumps in as a whole, and lets go.
   pure subroutine follow_face(curve, survey, control, apart, loop)
      class(curve_t), intent(in) :: curve
      type(survey_t), intent(in) :: survey
      integer, intent(in) :: control
      !> What is prescribed where bodies that are apart come into the reach of adhesion.
      real(dp), intent(in) :: apart
      type(loop_t), intent(inout) :: loop
      type(contact_t) :: contact

      call find_contact(curve, survey, control, apart, .true., branch_stable, contact)
      loop%is_converged = loop%is_converged .and. contact%is_found .and. contact%is_converged
      loop%jump_in = apart
      loop%jump_in_load = contact%load
      loop%energy = -potential_of(curve, control, contact)
      call find_contact(curve, survey, control, loop%pull_off*(1 - 4*epsilon(1.0_dp)), .true., branch_stable, contact)
      loop%is_converged = loop%is_converged .and. contact%is_found .and. contact%is_converged
      loop%energy = loop%energy + potential_of(curve, control, contact)
   end subroutine follow_face

   !> From bodies that are apart to the largest contact, and back.
   pure subroutine go_through(curve, stretches, apart, loop)
      class(curve_t), intent(in) :: curve
      type(stretches_t), intent(in) :: stretches
      !> What is prescribed where bodies that are apart come into the reach of adhesion.
      real(dp), intent(in) :: apart
      type(loop_t), intent(inout) :: loop
      type(journey_t) :: there, back

      if (stretches%list(1)%goes_back) there%k = 1
      there%prescribed = apart
      call follow_stretches(curve, stretches, 1, there)
      back%k = stretches%n
      call follow_stretches(curve, stretches, -1, back)
      loop%is_converged = loop%is_converged .and. there%is_converged .and. back%is_converged
      loop%energy = there%loss + back%loss
      if (there%n_jumps == 0) return
      loop%jump_in = there%jump
      loop%jump_in_load = there%load_after
   end subroutine go_through

end module adfric_round_loop
