! SPDX-License-Identifier: GPL-3.0-or-later
!> A round contact with adhesion along a path of loads, approaches, or approaches of the base of a spring. Opening may take more
!> work than closing has given.
!>
!> Closing goes along the curve of equilibrium with the work of closing, opening along that with the work of opening; between
!> them the edge of adhesion stays (`adfric_round_pinned_edge`). A leg of the path, along which what is prescribed rises or
!> falls, is answered by its end: the contact with the present edge there is unique, and its energy release rate G has fallen or
!> risen all along the leg. If G ends between both works the edge has not moved. Else it moves on the curve of the one that G
!> has passed, from where G is that work up to the end, with the jumps on it (`adfric_round_stretches`). So a path depends on
!> the turning points alone, not on its steps.
!>
!> Energies. E is that of a state with the work of closing, W (`adfric_round_energy`). Where the edge falls back from c1 to c2
!> by itself, opening takes pi (W_opening - W) (c1^2 - c2^2), and jumps take what they lose. What has been taken is the work
!> done less E.
module adfric_round_adhesive_path
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_round_contact, only: reach_of
   use adfric_round_contact_state, only: contact_t, prescribed_by, set_contact, terms_of
   use adfric_round_curve, only: control_approach, control_load, curve_t, most_intervals
   use adfric_round_dugdale_curve, only: dugdale_curve_t
   use adfric_round_pinned_edge, only: contact_at_edge, pin_contact, work_of_edge
   use adfric_round_stretches, only: follow_stretches, journey_t, list_stretches, radii_of, stretches_t
   use adfric_round_survey, only: survey_t, survey_curve
   implicit none (type, external)
   private
   public :: adhesive_path_t, begin_path, go_to, new_opening

   !> A contact on its path, reduced.
   type :: adhesive_path_t
      !> What is prescribed: `control_load`, `control_approach` or `control_spring`.
      integer :: control = control_approach
      !> Curves of closing and of opening.
      class(curve_t), allocatable :: closing, opening
      !> Their stable stretches under what is prescribed.
      type(stretches_t) :: closes, opens
      !> Where opening has its least loads: the contacts at folds under a load; shape `(n_folds)`.
      type(contact_t) :: folds(most_intervals)
      !> Number of them.
      integer :: n_folds = 0
      !> Do the bodies touch or attract each other?
      logical :: is_bound = .false.
      !> The contact, while they do.
      type(contact_t) :: contact
      !> Energy that has been taken so far.
      real(dp) :: taken = 0
      !> Sum of the terms whose differences that is.
      real(dp) :: terms = 0
      !> Number of jumps of the edge.
      integer :: n_jumps = 0
      !> What was prescribed at the jump in that took most, the load after it, and what it took, below 0 before there is one.
      real(dp) :: jump_in = 0, load_after = 0, largest_jump = -1
      !> Has the contact parted? The last state before it did so for the last time.
      logical :: has_parted = .false.
      !> Load and approach of that state.
      real(dp) :: last_load = 0, last_approach = 0
      !> Least load so far, the approach there, and the size of the terms of that load.
      real(dp) :: least_load = 0, least_approach = 0, least_load_terms = 0
      !> Were all states found to round-off?
      logical :: is_converged = .true.
   end type adhesive_path_t

contains

   !> Bodies that are apart.
   pure subroutine begin_path(curve, control, work_ratio, path)
      !> The curve of closing.
      class(curve_t), intent(in) :: curve
      !> What is prescribed.
      integer, intent(in) :: control
      !> Work of opening over that of closing, >= 1.
      real(dp), intent(in) :: work_ratio
      !> Receives the path without a leg.
      type(adhesive_path_t), intent(out) :: path
      type(survey_t) :: survey
      integer :: k

      path%control = control
      allocate (path%closing, source=curve)
      call new_opening(curve, work_ratio, path%opening)
      call survey_curve(path%closing, control, survey)
      path%is_converged = survey%ends%is_converged
      call list_stretches(survey, control, path%closes)
      call survey_curve(path%opening, control, survey)
      path%is_converged = path%is_converged .and. survey%ends%is_converged
      call list_stretches(survey, control, path%opens)
      call survey_curve(path%opening, control_load, survey)
      do k = 1, survey%n
         if (.not. survey%intervals(k)%is_stable) cycle
         path%n_folds = path%n_folds + 1
         call set_contact(path%opening, control_load, survey%intervals(k)%low, survey%intervals(k)%is_beyond, &
            & path%folds(path%n_folds))
      end do
   end subroutine begin_path

   !> The curve of opening: the work is larger, and the stress is the same.
   pure subroutine new_opening(curve, work_ratio, opening)
      !> The curve of closing.
      class(curve_t), intent(in) :: curve
      !> Work of opening over that of closing, >= 1.
      real(dp), intent(in) :: work_ratio
      !> In: not allocated. Out: the curve.
      class(curve_t), allocatable, intent(inout) :: opening

      allocate (opening, source=curve)
      opening%tension = curve%tension*sqrt(work_ratio)
      select type (opening)
      type is (dugdale_curve_t)
         opening%range = opening%range*work_ratio
      end select
   end subroutine new_opening

   !> Go to the end of a leg.
   pure subroutine go_to(path, given, is_found)
      type(adhesive_path_t), intent(inout) :: path
      !> What is prescribed at the end, reduced.
      real(dp), intent(in) :: given
      !> Is there a state? Bodies that have parted carry no load below 0.
      logical, intent(out) :: is_found
      type(contact_t) :: pinned
      real(dp) :: release, edge

      is_found = .true.
      if (.not. path%is_bound) then
         call approach_from_apart(path, given, is_found)
         return
      end if
      edge = path%contact%adhesion_radius
      call pin_contact(path%closing, path%control, edge, given, pinned, release)
      path%is_converged = path%is_converged .and. pinned%is_converged
      if (.not. path%is_converged) return
      if (pinned%is_found .and. release < work_of_edge(path%closing)) then
         call move_edge(path, 1, given)
      else if (.not. pinned%is_found .or. release > work_of_edge(path%opening)) then
         call move_edge(path, -1, given)
         ! under a load below 0 bodies that part are gone
         is_found = path%is_bound .or. path%control /= control_load
      else
         path%contact = pinned
      end if
      if (path%is_bound) call take_contact(path, path%contact)
   end subroutine go_to

   !> Bodies that are apart come into the reach of each other, or stay apart.
   pure subroutine approach_from_apart(path, given, is_found)
      type(adhesive_path_t), intent(inout) :: path
      real(dp), intent(in) :: given
      logical, intent(out) :: is_found
      type(journey_t) :: journey
      real(dp) :: reach

      reach = 0
      if (path%control /= control_load) reach = reach_of(path%closing)
      path%contact = contact_t()
      is_found = given >= reach .or. path%control /= control_load
      if (given < reach) then
         path%contact%approach = given
         return
      end if
      journey%prescribed = reach
      if (path%closes%n > 0) then
         if (path%closes%list(1)%goes_back) journey%k = 1
      end if
      call follow_stretches(path%closing, path%closes, 1, journey, given)
      call take_rise(path, journey)
      call take_contact(path, path%contact)
   end subroutine approach_from_apart

   !> The edge moves outward or inward.
   pure subroutine move_edge(path, direction, given)
      type(adhesive_path_t), intent(inout) :: path
      !> 1 outward, -1 inward.
      integer, intent(in) :: direction
      real(dp), intent(in) :: given
      type(journey_t) :: journey
      real(dp) :: edge

      edge = path%contact%adhesion_radius
      if (direction > 0) then
         call begin_journey(path%closing, path%control, edge, journey)
         if (journey%is_converged) call follow_stretches(path%closing, path%closes, 1, journey, given)
         call take_rise(path, journey)
      else
         call begin_journey(path%opening, path%control, edge, journey)
         if (journey%is_converged) call follow_stretches(path%opening, path%opens, -1, journey, given)
         call take_fall(path, journey, edge, given)
      end if
   end subroutine move_edge

   !> The state of a curve from which an edge begins to move.
   pure subroutine begin_journey(curve, control, edge, journey)
      class(curve_t), intent(in) :: curve
      !> What is prescribed.
      integer, intent(in) :: control
      !> Radius of adhesion.
      real(dp), intent(in) :: edge
      !> Receives the state, and whether it was found to round-off.
      type(journey_t), intent(out) :: journey

      call contact_at_edge(curve, control, edge, journey%contact)
      journey%is_converged = journey%contact%is_converged
      if (journey%is_converged) journey%prescribed = prescribed_by(curve, control, journey%contact)
   end subroutine begin_journey

   !> Take over what a rise has come to.
   pure subroutine take_rise(path, journey)
      type(adhesive_path_t), intent(inout) :: path
      type(journey_t), intent(in) :: journey

      path%is_bound = .true.
      path%contact = journey%contact
      path%taken = path%taken + journey%loss
      path%terms = path%terms + journey%terms
      path%n_jumps = path%n_jumps + journey%n_jumps
      path%is_converged = path%is_converged .and. journey%is_converged
      if (.not. journey%largest_loss > path%largest_jump) return
      path%largest_jump = journey%largest_loss
      path%jump_in = journey%jump
      path%load_after = journey%load_after
   end subroutine take_rise

   !> Take over what a fall has come to.
   pure subroutine take_fall(path, journey, edge, given)
      type(adhesive_path_t), intent(inout) :: path
      type(journey_t), intent(in) :: journey
      !> Radius of adhesion before, and what is prescribed at the end.
      real(dp), intent(in) :: edge, given
      real(dp) :: left
      integer :: i, k

      left = journey%contact%adhesion_radius
      if (journey%parts) left = 0
      path%taken = path%taken + journey%loss + pi*(work_of_edge(path%opening) - work_of_edge(path%closing)) &
         & *(edge - left)*(edge + left)
      path%terms = path%terms + journey%terms
      path%n_jumps = path%n_jumps + journey%n_jumps
      path%is_converged = path%is_converged .and. journey%is_converged
      do k = 1, journey%n_passages
         associate (passage => journey%passages(k))
            call take_load(path, passage%load, passage%approach, passage%load_terms)
            do i = 1, path%n_folds
               associate (fold => path%folds(i))
                  if (all(radii_of(fold) >= passage%left .and. radii_of(fold) <= passage%entered)) call take_contact(path, fold)
               end associate
            end do
         end associate
      end do
      path%is_bound = .not. journey%parts
      path%contact = journey%contact
      if (path%is_bound) return
      path%has_parted = .true.
      path%last_load = journey%contact%load
      path%last_approach = journey%contact%approach
      if (journey%n_passages == 0) call take_contact(path, journey%contact)
      path%contact = contact_t()
      path%contact%approach = given
      if (path%control == control_load) path%contact%approach = not_a_number()
   end subroutine take_fall

   !> Is the load of a contact the least one so far?
   pure subroutine take_contact(path, contact)
      type(adhesive_path_t), intent(inout) :: path
      type(contact_t), intent(in) :: contact
      real(dp) :: terms(2)

      terms = terms_of(contact)
      call take_load(path, contact%load, contact%approach, terms(1))
   end subroutine take_contact

   !> Is a load the least one so far?
   pure subroutine take_load(path, load, approach, terms)
      type(adhesive_path_t), intent(inout) :: path
      !> The load, the approach there, and the size of the terms of the load.
      real(dp), intent(in) :: load, approach, terms

      if (.not. load < path%least_load) return
      path%least_load = load
      path%least_approach = approach
      path%least_load_terms = terms
   end subroutine take_load

end module adfric_round_adhesive_path
