! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact of an indenter under a given load, approach or radius; where it separates, and where it jumps.
!>
!> A curve may have several stable parts. Its least load is the least one of all stable states: the fold that a contact meets first
!> may only be a jump to a smaller contact. A flat face without an edge that rises is a case of its own: the whole face is in contact.
module adfric_indenter_contact
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, half_pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_indenter_curve, only: curve_t, state_t, interval_t, find_held, most_intervals, control_load, control_approach, &
      & control_radius
   use adfric_indenter_dugdale_curve, only: dugdale_curve_t
   use adfric_indenter_dugdale_folds, only: find_edge_angle
   use adfric_indenter_shape, only: spot_t
   implicit none (type, external)
   private
   public :: contact_t, ends_t, survey_t, find_contact, survey_curve, find_face_angle, branch_stable, branch_inner, branch_unstable

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
      !> Their derivatives by u; 0 without touch, and for a flat face.
      real(dp) :: slopes(2) = 0
      !> g(a) - delta, the depth of the flat punch of radius a that adhesion adds: Dl of JKR; of a flat face -delta.
      real(dp) :: neck = 0
      !> Radius c up to which adhesion acts, and its stress there; 0 where it acts in the contact alone.
      real(dp) :: adhesion_radius = 0, stress = 0
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

   !> The stable and the unstable parts of a curve under what is held, and where contacts end: all that does not depend on the value
   !> that is held.
   type :: survey_t
      !> Number of the parts.
      integer :: n = 0
      !> The parts, from the smallest contacts to the largest.
      type(interval_t) :: intervals(most_intervals)
      !> Where contacts end.
      type(ends_t) :: ends
   end type survey_t

contains

   !> The contact under what is held.
   pure subroutine find_contact(curve, survey, control, given, is_beyond, branch, contact)
      !> The curve of the indenter.
      class(curve_t), intent(in) :: curve
      !> Its parts under this control.
      type(survey_t), intent(in) :: survey
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
      integer :: k, place

      if (curve%shape%n_pieces == 0) then
         call find_face_contact(curve, control, given, branch, contact)
      else if (control == control_radius) then
         call set_contact(curve, control, given, is_beyond, contact)
         contact%is_found = .true.
      else
         contact%is_converged = survey%ends%is_converged
         do k = 1, survey%n
            place = merge(k, survey%n + 1 - k, branch == branch_inner)
            if (survey%intervals(place)%is_stable .eqv. branch == branch_unstable) cycle
            call try_interval(curve, control, given, survey%intervals(place), contact)
            if (contact%is_found) return
         end do
         if (control == control_approach .and. branch /= branch_unstable) call try_disc(curve, given, contact)
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

   !> The state without touch, if there is one.
   pure subroutine try_disc(curve, approach, contact)
      !> The curve of the indenter.
      class(curve_t), intent(in) :: curve
      !> Approach that is given, reduced.
      real(dp), intent(in) :: approach
      !> Receives the state, with `is_found`.
      type(contact_t), intent(inout) :: contact
      type(state_t) :: state

      call curve%find_disc(approach, state, contact%is_found)
      if (.not. contact%is_found) return
      contact%is_beyond = .false.
      call take_state(state, control_approach, contact)
   end subroutine try_disc

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
      call take_state(state, control, contact)
   end subroutine set_contact

   !> Take a state over.
   pure subroutine take_state(state, control, contact)
      !> The state.
      type(state_t), intent(in) :: state
      !> What is held.
      integer, intent(in) :: control
      !> Receives radii, load, approach and stiffness.
      type(contact_t), intent(inout) :: contact

      contact%spot = state%spot
      contact%load = state%load
      contact%approach = state%approach
      contact%slopes = [state%load_slope, state%approach_slope]
      contact%neck = state%neck
      contact%stiffness = state%stiffness
      contact%adhesion_radius = state%adhesion_radius
      contact%stress = state%stress
      contact%is_stable = state%is_stable(merge(control_approach, control_load, control == control_approach))
      contact%is_converged = contact%is_converged .and. state%is_converged
   end subroutine take_state

   !> The contact of a flat face of radius 1: P = 2 delta, down to the load of Kendall, or by Dugdale's law.
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

      select type (curve)
      type is (dugdale_curve_t)
         call find_dugdale_face(curve, control, given, contact)
         contact%is_found = contact%is_found .and. branch /= branch_unstable
         return
      end select
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

   !> A flat face by Dugdale's law: under tension a zone of adhesion a < r < 1 opens at its edge, P = -2 S (th + sin(th) cos(th)),
   !> delta = -2 S sin(th), a = cos(th), until the gap at the edge is the range of adhesion, or until nothing touches. At given
   !> approach a face that does not touch goes on until its edge is out of range.
   pure subroutine find_dugdale_face(curve, control, given, contact)
      !> The curve of the face.
      type(dugdale_curve_t), intent(in) :: curve
      !> `control_load` or `control_approach`.
      integer, intent(in) :: control
      !> Load or approach that is given, reduced.
      real(dp), intent(in) :: given
      !> Receives the contact.
      type(contact_t), intent(inout) :: contact
      real(dp) :: last, th
      logical :: is_found

      contact%is_stable = .true.
      contact%adhesion_radius = 1
      contact%spot%radius = 1
      contact%is_found = .true.
      if (given >= 0) then
         contact%approach = given/merge(2, 1, control == control_load)
         contact%load = 2*contact%approach
         contact%neck = -contact%approach
         contact%stiffness = 2
         return
      end if
      last = last_angle(curve)
      contact%stress = curve%stress
      if (control == control_load) then
         call find_face_angle(-given/(2*curve%stress), last, th, is_found)
      else
         is_found = -given <= 2*curve%stress*sin(last)
         th = last
         if (is_found) th = asin(min(1.0_dp, -given/(2*curve%stress)))
         if (.not. is_found .and. last >= half_pi) is_found = given >= detached_approach(curve)
      end if
      contact%is_found = is_found
      contact%load = -2*curve%stress*(th + sin(th)*cos(th))
      contact%approach = -2*curve%stress*sin(th)
      contact%spot%radius = cos(th)
      if (th >= half_pi) contact%spot%radius = 0
      contact%neck = 2*curve%stress*sin(th)
      contact%stiffness = 2*contact%spot%radius
      contact%is_beyond = .false.
      if (control == control_load) contact%load = given
      if (control == control_approach) contact%approach = given
   end subroutine find_dugdale_face

   !> The angle at which a flat face lets go under load: k(th) = pi h/(4 S), pi/2 if the whole face pulls.
   pure real(dp) function last_angle(curve)
      !> The curve of the face.
      type(dugdale_curve_t), intent(in) :: curve

      call find_edge_angle(pi*curve%range/(4*curve%stress), last_angle)
      if (.not. last_angle > 0) last_angle = half_pi
   end function last_angle

   !> The approach at which the edge of a face that does not touch is out of range.
   pure real(dp) function detached_approach(curve)
      !> The curve of the face.
      type(dugdale_curve_t), intent(in) :: curve

      detached_approach = -4*curve%stress/pi - curve%range
   end function detached_approach

   !> The angle where th + sin(th) cos(th) has a value.
   pure subroutine find_face_angle(value, last, th, is_found)
      !> The value, > 0.
      real(dp), intent(in) :: value
      !> The largest angle.
      real(dp), intent(in) :: last
      !> Receives the angle.
      real(dp), intent(out) :: th
      !> Is there one up to the largest?
      logical, intent(out) :: is_found
      integer, parameter :: most_steps = 100
      real(dp) :: low, high, rest
      integer :: k

      th = last
      is_found = value <= last + sin(last)*cos(last)
      if (.not. is_found .or. .not. value < last + sin(last)*cos(last)) return
      low = 0
      high = last
      th = min(value/2, last)
      do k = 1, most_steps
         rest = value - th - sin(th)*cos(th)
         if (rest > 0) low = th
         if (.not. rest > 0) high = th
         if (high - low <= 2*epsilon(th)*high .or. .not. abs(rest) > 2*epsilon(rest)*value) return
         th = th + rest/(2*cos(th)**2)
         if (.not. (th > low .and. th < high)) th = low + (high - low)/2
      end do
   end subroutine find_face_angle

   !> The parts of a curve, and where contacts end under what is held.
   pure subroutine survey_curve(curve, control, survey)
      !> The curve of the indenter.
      class(curve_t), intent(in) :: curve
      !> What is held; a given radius counts as a given load.
      integer, intent(in) :: control
      !> Receives the parts and the ends.
      type(survey_t), intent(out) :: survey
      integer :: held_control

      call clear_ends(survey%ends)
      held_control = merge(control_approach, control_load, control == control_approach)
      if (curve%shape%n_pieces == 0) then
         call set_face_ends(curve, held_control, survey%ends)
      else
         call curve%find_intervals(held_control, survey%intervals, survey%n, survey%ends%is_converged)
         call find_pull_off(curve, held_control, survey%intervals(:survey%n), survey%ends)
         call find_jumps(curve, held_control, survey%intervals(:survey%n), survey%ends)
      end if
   end subroutine survey_curve

   !> Where the contact of a flat face ends.
   pure subroutine set_face_ends(curve, control, ends)
      !> The curve of the face.
      class(curve_t), intent(in) :: curve
      !> `control_load` or `control_approach`.
      integer, intent(in) :: control
      !> Receives the pull-off.
      type(ends_t), intent(inout) :: ends

      ends%pull_off_load = -2*curve%tension
      ends%pull_off_approach = -curve%tension
      select type (curve)
      type is (dugdale_curve_t)
         associate (th => last_angle(curve))
            ends%pull_off_load = -2*curve%stress*(th + sin(th)*cos(th))
            ends%pull_off_approach = -2*curve%stress*sin(th)
            if (control == control_approach .and. th >= half_pi) ends%pull_off_approach = detached_approach(curve)
         end associate
      end select
   end subroutine set_face_ends

   !> The stable state with the least load, or the least approach.
   pure subroutine find_pull_off(curve, control, intervals, ends)
      !> The curve of the indenter.
      class(curve_t), intent(in) :: curve
      !> `control_load` or `control_approach`.
      integer, intent(in) :: control
      !> The intervals of the curve.
      type(interval_t), intent(in) :: intervals(:)
      !> Receives the pull-off.
      type(ends_t), intent(inout) :: ends
      type(state_t) :: disc
      real(dp) :: least, held, load, approach
      integer :: k
      logical :: is_disc

      least = huge(least)
      do k = 1, size(intervals)
         if (.not. intervals(k)%is_stable) cycle
         call get_end_state(curve, intervals(k)%is_beyond, intervals(k)%low, load, approach)
         held = merge(approach, load, control == control_approach)
         if (held < least) then
            least = held
            ends%pull_off_load = load
            ends%pull_off_approach = approach
         end if
      end do
      if (control == control_approach) then
         call curve%get_disc_end(disc, is_disc)
         if (is_disc .and. disc%approach < least) then
            ends%pull_off_load = disc%load
            ends%pull_off_approach = disc%approach
         end if
      end if
   end subroutine find_pull_off

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
