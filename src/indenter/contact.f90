! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact of an indenter under a given load, approach or radius; where it separates, and where it jumps.
!>
!> A curve may have several stable parts. Its least load is the least one of all stable states: the fold that a contact meets first
!> may only be a jump to a smaller contact. A flat face without an edge that rises is a case of its own: the whole face is in contact.
module adfric_indenter_contact
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_indenter_curve, only: curve_t, state_t, interval_t, find_held, most_intervals, control_load, control_approach, &
      & control_radius
   use adfric_indenter_shape, only: spot_t
   implicit none (type, external)
   private
   public :: contact_t, ends_t, find_contact, find_ends, branch_stable, branch_inner, branch_unstable

   !> Which state is meant where there are several: the largest stable one, the smallest stable one, the largest unstable one.
   integer, parameter :: branch_stable = 1, branch_inner = 2, branch_unstable = 3

   !> A state of contact, reduced.
   type :: contact_t
      !> Does it exist, and was it found to round-off?
      logical :: is_found = .false., is_converged = .true.
      !> Is it stable under what is held?
      logical :: is_stable = .false.
      !> The unknown, and whether it lies beyond the corner.
      real(dp) :: u = 0
      !> Is u one of those beyond the corner?
      logical :: is_beyond = .true.
      !> What the shape is there.
      type(spot_t) :: spot
      !> Load P and approach delta.
      real(dp) :: load = 0, approach = 0
      !> g(a) - delta, the depth of the flat punch of radius a that adhesion adds: Dl of JKR; of a flat face -delta.
      real(dp) :: neck = 0
      !> Radius c up to which adhesion acts.
      real(dp) :: adhesion_radius = 0
      !> dP/ddelta along the curve.
      real(dp) :: stiffness = 0
   end type contact_t

   !> Where contacts end under what is held; NaN where there is no such end.
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

contains

   !> The contact under what is held.
   pure subroutine find_contact(curve, control, given, is_beyond, branch, contact)
      !> The curve of the indenter.
      class(curve_t), intent(in) :: curve
      !> What is held, one of `control_...`.
      integer, intent(in) :: control
      !> Load, approach or unknown u that is given, reduced.
      real(dp), intent(in) :: given
      !> Is a given u one of those beyond the corner?
      logical, intent(in) :: is_beyond
      !> One of `branch_...`.
      integer, intent(in) :: branch
      !> Receives the contact.
      type(contact_t), intent(out) :: contact
      type(interval_t) :: intervals(most_intervals)
      integer :: n, k, place

      if (curve%shape%n_pieces == 0) then
         call find_face_contact(curve, control, given, branch, contact)
      else if (control == control_radius) then
         call set_contact(curve, control, given, is_beyond, contact)
         contact%is_found = .true.
      else
         call curve%find_intervals(control, intervals, n, contact%is_converged)
         do k = 1, n
            place = merge(k, n + 1 - k, branch == branch_inner)
            if (intervals(place)%is_stable .eqv. branch == branch_unstable) cycle
            call try_interval(curve, control, given, intervals(place), contact)
            if (contact%is_found) return
         end do
      end if
   end subroutine find_contact

   !> The contact within one interval, if it has what is held.
   pure subroutine try_interval(curve, control, given, interval, contact)
      !> The curve of the indenter.
      class(curve_t), intent(in) :: curve
      !> `control_load` or `control_approach`.
      integer, intent(in) :: control
      !> Load or approach that is given, reduced.
      real(dp), intent(in) :: given
      !> The interval.
      type(interval_t), intent(in) :: interval
      !> Receives the contact, with `is_found`.
      type(contact_t), intent(inout) :: contact
      real(dp) :: u
      logical :: is_found, is_converged

      call find_held(curve, control, interval, given, u, is_found, is_converged)
      if (.not. is_found) return
      call set_contact(curve, control, u, interval%is_beyond, contact)
      contact%is_found = .true.
      contact%is_converged = contact%is_converged .and. is_converged
      contact%is_stable = interval%is_stable
      if (control == control_load) contact%load = given
      if (control == control_approach) contact%approach = given
   end subroutine try_interval

   !> What follows from the unknown.
   pure subroutine set_contact(curve, control, u, is_beyond, contact)
      !> The curve of the indenter.
      class(curve_t), intent(in) :: curve
      !> What is held.
      integer, intent(in) :: control
      !> The unknown, >= 0.
      real(dp), intent(in) :: u
      !> Is u one of those beyond the corner?
      logical, intent(in) :: is_beyond
      !> Receives radius, load, approach and stiffness.
      type(contact_t), intent(inout) :: contact
      type(state_t) :: state

      contact%u = u
      contact%is_beyond = is_beyond
      call curve%get_state(u, is_beyond, state)
      contact%spot = state%spot
      contact%load = state%load
      contact%approach = state%approach
      contact%neck = state%neck
      contact%stiffness = state%stiffness
      contact%adhesion_radius = state%adhesion_radius
      contact%is_stable = state%is_stable(merge(control_approach, control_load, control == control_approach))
      contact%is_converged = contact%is_converged .and. state%is_converged
   end subroutine set_contact

   !> The contact of a flat face of radius 1: P = 2 delta, down to the load of Kendall.
   pure subroutine find_face_contact(curve, control, given, branch, contact)
      !> The curve of the indenter, which has no piece.
      class(curve_t), intent(in) :: curve
      !> `control_load` or `control_approach`.
      integer, intent(in) :: control
      !> Load or approach that is given, reduced.
      real(dp), intent(in) :: given
      !> One of `branch_...`; no state is unstable.
      integer, intent(in) :: branch
      !> Receives the contact.
      type(contact_t), intent(out) :: contact

      contact%spot%radius = 1
      contact%adhesion_radius = 1
      contact%load = given
      contact%approach = given/2
      if (control == control_approach) then
         contact%load = 2*given
         contact%approach = given
      end if
      contact%neck = -contact%approach
      contact%stiffness = 2
      contact%is_stable = .true.
      contact%is_found = branch /= branch_unstable .and. contact%approach >= -curve%tension
   end subroutine find_face_contact

   !> Where contacts end under what is held.
   pure subroutine find_ends(curve, control, ends)
      !> The curve of the indenter.
      class(curve_t), intent(in) :: curve
      !> What is held; a given radius counts as a given load.
      integer, intent(in) :: control
      !> Receives the ends.
      type(ends_t), intent(out) :: ends
      type(interval_t) :: intervals(most_intervals)
      real(dp) :: least, held, load, approach
      integer :: n, k, held_control

      call clear_ends(ends)
      if (curve%shape%n_pieces == 0) then
         ends%pull_off_load = -2*curve%tension
         ends%pull_off_approach = -curve%tension
         return
      end if
      held_control = merge(control_approach, control_load, control == control_approach)
      call curve%find_intervals(held_control, intervals, n, ends%is_converged)
      least = huge(least)
      do k = 1, n
         if (.not. intervals(k)%is_stable) cycle
         call get_end_state(curve, intervals(k)%is_beyond, intervals(k)%low, load, approach)
         held = merge(approach, load, held_control == control_approach)
         if (held < least) then
            least = held
            ends%pull_off_load = load
            ends%pull_off_approach = approach
         end if
      end do
      call find_jumps(curve, held_control, intervals(:n), ends)
   end subroutine find_ends

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

   !> Load and approach of a state.
   pure subroutine get_end_state(curve, is_beyond, u, load, approach)
      !> The curve of the indenter.
      class(curve_t), intent(in) :: curve
      !> Is u one of those beyond the corner?
      logical, intent(in) :: is_beyond
      !> The unknown of the state.
      real(dp), intent(in) :: u
      !> Load P and approach delta, reduced.
      real(dp), intent(out) :: load, approach
      type(state_t) :: state

      call curve%get_state(u, is_beyond, state)
      load = state%load
      approach = state%approach
   end subroutine get_end_state

   !> Jumps between stable parts: inward where a fold has another stable state, smaller and under the same load or approach;
   !> outward from the fold at the end of a stable part.
   pure subroutine find_jumps(curve, control, intervals, ends)
      !> The curve of the indenter.
      class(curve_t), intent(in) :: curve
      !> `control_load` or `control_approach`.
      integer, intent(in) :: control
      !> The intervals of the curve, from the smallest contacts to the largest.
      type(interval_t), intent(in) :: intervals(:)
      !> Receives the jumps.
      type(ends_t), intent(inout) :: ends
      real(dp) :: load, approach, held, first, last, slope
      integer :: k, j

      do k = 1, size(intervals)
         if (.not. intervals(k)%is_stable) cycle
         if (intervals(k)%ends_at_fold) then
            call get_end_state(curve, intervals(k)%is_beyond, intervals(k)%high, &
               & ends%jump_outward_load, ends%jump_outward_approach)
         end if
         if (.not. intervals(k)%begins_at_fold) cycle
         call get_end_state(curve, intervals(k)%is_beyond, intervals(k)%low, load, approach)
         held = merge(approach, load, control == control_approach)
         do j = 1, k - 1
            if (.not. intervals(j)%is_stable) cycle
            call curve%get_held(control, intervals(j)%low, intervals(j)%is_beyond, first, slope)
            call curve%get_held(control, intervals(j)%high, intervals(j)%is_beyond, last, slope)
            if (held < first .or. held > last) cycle
            ends%jump_inward_load = load
            ends%jump_inward_approach = approach
         end do
      end do
   end subroutine find_jumps

end module adfric_indenter_contact
