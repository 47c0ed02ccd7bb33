! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact of an indenter under a given load, approach or radius; where it separates, and where it jumps.
!>
!> A curve may have several stable parts. Its least load is the least one of all stable states: the fold that a contact meets first
!> may only be a jump to a smaller contact. A flat face without an edge that rises is a case of its own: the whole face is in contact.
module adfric_indenter_contact
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, half_pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_indenter_curve, only: curve_t, state_t, interval_t, disc_range_t, find_held, measure_interval, stability_control, &
      & most_intervals, most_disc_ranges, control_load, control_approach, control_spring, control_radius
   use adfric_indenter_dugdale_curve, only: dugdale_curve_t
   use adfric_indenter_dugdale_folds, only: find_edge_angle
   use adfric_indenter_shape, only: spot_t
   use adfric_numerics_scalar_root, only: equation_t, find_root
   implicit none (type, external)
   private
   public :: contact_t, ends_t, survey_t, find_contact, survey_curve, find_face_angle, held_of, held_by, set_contact, &
      & set_disc, take_given, terms_of, try_interval, try_disc_range, branch_stable, branch_inner, branch_unstable

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
      !> Number of the ranges of discs without touch that are stable.
      integer :: n_discs = 0
      !> The ranges, from the smallest discs to the largest.
      type(disc_range_t) :: discs(most_disc_ranges)
      !> Where contacts end.
      type(ends_t) :: ends
   end type survey_t

   !> What is held by a disc without touch, less what is given.
   type, extends(equation_t) :: disc_equation_t
      !> The curve.
      class(curve_t), allocatable :: curve
      !> What is held.
      integer :: control = control_approach
      !> What is given.
      real(dp) :: given = 0
   contains
      procedure :: evaluate => evaluate_disc
   end type disc_equation_t

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
         if (branch == branch_inner) call try_discs(curve, survey, control, given, branch, contact)
         do k = 1, survey%n
            if (contact%is_found) return
            place = merge(k, survey%n + 1 - k, branch == branch_inner)
            if (survey%intervals(place)%is_stable .eqv. branch == branch_unstable) cycle
            call try_interval(curve, control, given, survey%intervals(place), contact)
         end do
         if (.not. contact%is_found .and. branch == branch_stable) call try_discs(curve, survey, control, given, branch, contact)
      end if
   end subroutine find_contact

   !> The contact within one interval, if it has what is held.
   pure subroutine try_interval(curve, control, given, interval, contact)
      !> The curve of the indenter.
      class(curve_t), intent(in) :: curve
      !> What is held; not `control_radius`.
      integer, intent(in) :: control
      !> What is given, reduced.
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
      call take_given(curve, control, given, contact)
   end subroutine try_interval

   !> What is given has all of its digits.
   pure subroutine take_given(curve, control, given, contact)
      !> The curve with the compliance of its spring.
      class(curve_t), intent(in) :: curve
      !> What is held; not `control_radius`.
      integer, intent(in) :: control
      !> What is given, reduced.
      real(dp), intent(in) :: given
      !> The contact, whose load or approach may be replaced.
      type(contact_t), intent(inout) :: contact

      if (control == control_load) contact%load = given
      if (control == control_approach) contact%approach = given
      if (control == control_spring) call share_digits(curve, given, contact)
   end subroutine take_given

   !> Of load and approach, both differences, the one with fewer digits follows from the other and from the base of the spring.
   pure subroutine share_digits(curve, given, contact)
      !> The curve with the compliance of its spring.
      class(curve_t), intent(in) :: curve
      !> Approach of the base.
      real(dp), intent(in) :: given
      !> The contact, whose load or approach may be replaced.
      type(contact_t), intent(inout) :: contact
      real(dp) :: terms(2)

      terms = terms_of(contact)
      if (curve%compliance*terms(1) > abs(given) + terms(2)) then
         contact%load = (given - contact%approach)/curve%compliance
      else if (terms(2) > abs(given) + curve%compliance*terms(1)) then
         contact%approach = given - curve%compliance*contact%load
      end if
   end subroutine share_digits

   !> Sizes of the terms whose differences are load and approach.
   pure function terms_of(contact) result(terms)
      !> The contact.
      type(contact_t), intent(in) :: contact
      real(dp) :: terms(2)

      terms = [contact%spot%load + 2*contact%spot%radius*abs(contact%neck), contact%spot%depth + abs(contact%neck)]
   end function terms_of

   !> The state without touch, if there is one.
   pure subroutine try_discs(curve, survey, control, given, branch, contact)
      !> The curve of the indenter.
      class(curve_t), intent(in) :: curve
      !> Its parts under this control.
      type(survey_t), intent(in) :: survey
      !> What is held; not `control_radius`.
      integer, intent(in) :: control
      !> What is given, reduced.
      real(dp), intent(in) :: given
      !> `branch_inner` for the smallest disc, else the largest.
      integer, intent(in) :: branch
      !> Receives the state, with `is_found`.
      type(contact_t), intent(inout) :: contact
      integer :: k

      do k = 1, survey%n_discs
         if (contact%is_found) return
         call try_disc_range(curve, control, given, survey%discs(merge(k, survey%n_discs + 1 - k, branch == branch_inner)), contact)
      end do
   end subroutine try_discs

   !> The disc within one range, if it has what is held.
   pure subroutine try_disc_range(curve, control, given, range, contact)
      !> The curve of the indenter.
      class(curve_t), intent(in) :: curve
      !> What is held; not `control_radius`.
      integer, intent(in) :: control
      !> What is given, reduced.
      real(dp), intent(in) :: given
      !> The range.
      type(disc_range_t), intent(in) :: range
      !> Receives the state, with `is_found`.
      type(contact_t), intent(inout) :: contact
      type(disc_equation_t) :: equation
      type(state_t) :: first, last
      real(dp) :: c
      logical :: is_converged

      call curve%get_disc(range%low, first)
      call curve%get_disc(range%high, last)
      contact%is_found = given >= held_of(curve, control, first) .and. given < held_of(curve, control, last)
      if (.not. contact%is_found) return
      c = range%low
      is_converged = .true.
      if (given > held_of(curve, control, first)) then
         c = (range%low + range%high)/2
         allocate (equation%curve, source=curve)
         equation%control = control
         equation%given = given
         call find_root(equation, range%low, range%high, .true., c, is_converged)
      end if
      call set_disc(curve, control, c, contact)
      contact%is_stable = .true.
      contact%is_converged = contact%is_converged .and. is_converged
      if (control == control_approach) contact%approach = given
   end subroutine try_disc_range

   !> A state without touch.
   pure subroutine set_disc(curve, control, c, contact)
      !> The curve of the indenter.
      class(curve_t), intent(in) :: curve
      !> What is held.
      integer, intent(in) :: control
      !> Radius of the disc, >= 0.
      real(dp), intent(in) :: c
      !> Receives the state.
      type(contact_t), intent(inout) :: contact
      type(state_t) :: state

      call curve%get_disc(c, state)
      contact%is_beyond = .false.
      call take_state(state, control, contact)
   end subroutine set_disc

   !> See `equation_t`.
   pure subroutine evaluate_disc(self, x, value, slope)
      !> The equation with its curve.
      class(disc_equation_t), intent(in) :: self
      !> Radius c of the disc.
      real(dp), intent(in) :: x
      !> What it holds less what is given.
      real(dp), intent(out) :: value
      !> Derivative of the value by c.
      real(dp), intent(out) :: slope
      type(state_t) :: state

      call self%curve%get_disc(x, state)
      value = held_of(self%curve, self%control, state) - self%given
      slope = state%approach_slope
      if (self%control == control_spring) slope = slope + self%curve%compliance*state%load_slope
   end subroutine evaluate_disc

   !> What is held in a state: its load, its approach, or that of the base of the spring.
   pure real(dp) function held_of(curve, control, state)
      !> The curve with the compliance of its spring.
      class(curve_t), intent(in) :: curve
      !> What is held; not `control_radius`.
      integer, intent(in) :: control
      !> The state.
      type(state_t), intent(in) :: state

      held_of = state%load
      if (control /= control_load) held_of = state%approach
      if (control == control_spring) held_of = held_of + curve%compliance*state%load
   end function held_of

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
      contact%is_stable = state%is_stable(stability_control(control))
      contact%is_converged = contact%is_converged .and. state%is_converged
   end subroutine take_state

   !> The contact of a flat face of radius 1: P = 2 delta, down to the load of Kendall, or by Dugdale's law.
   pure subroutine find_face_contact(curve, control, given, branch, contact)
      !> The curve of the indenter, which has no piece.
      class(curve_t), intent(in) :: curve
      !> What is held; not `control_radius`.
      integer, intent(in) :: control
      !> What is given, reduced.
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
      contact%approach = given/face_factor(curve, control)
      contact%load = 2*contact%approach
      if (control == control_load) contact%load = given
      contact%neck = -contact%approach
      contact%stiffness = 2
      contact%is_stable = .true.
      contact%is_found = branch /= branch_unstable .and. contact%approach >= -curve%tension
   end subroutine find_face_contact

   !> What is held by a flat face of approach 1 that is in contact all over.
   pure real(dp) function face_factor(curve, control) result(factor)
      !> The curve of the face.
      class(curve_t), intent(in) :: curve
      !> What is held; not `control_radius`.
      integer, intent(in) :: control

      factor = merge(2, 1, control == control_load)
      if (control == control_spring) factor = 1 + 2*curve%compliance
   end function face_factor

   !> A flat face by Dugdale's law: under tension a zone of adhesion a < r < 1 opens at its edge, P = -2 S (th + sin(th) cos(th)),
   !> delta = -2 S sin(th), a = cos(th), until the gap at the edge is the range of adhesion, or until nothing touches. At given
   !> approach a face that does not touch goes on until its edge is out of range.
   pure subroutine find_dugdale_face(curve, control, given, contact)
      !> The curve of the face.
      type(dugdale_curve_t), intent(in) :: curve
      !> What is held; not `control_radius`.
      integer, intent(in) :: control
      !> What is given, reduced.
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
         contact%approach = given/face_factor(curve, control)
         contact%load = 2*contact%approach
         contact%neck = -contact%approach
         contact%stiffness = 2
         return
      end if
      last = last_angle(curve)
      contact%stress = curve%stress
      select case (control)
      case (control_load)
         call find_face_angle(-given/(2*curve%stress), last, 1.0_dp, 0.0_dp, th, is_found)
      case (control_approach)
         call find_face_angle(-given/(2*curve%stress), last, 0.0_dp, 1.0_dp, th, is_found)
      case default
         call find_face_angle(-given/(2*curve%stress), last, curve%compliance, 1.0_dp, th, is_found)
      end select
      contact%load = -2*curve%stress*(th + sin(th)*cos(th))
      contact%approach = -2*curve%stress*sin(th)
      if (.not. is_found .and. control /= control_load .and. last >= half_pi) then
         ! nothing touches, and the load is that of the whole face
         contact%approach = given
         if (control == control_spring) contact%approach = given - curve%compliance*contact%load
         is_found = contact%approach >= detached_approach(curve)
      end if
      contact%is_found = is_found
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

   !> The angle where p [th + sin(th) cos(th)] + q sin(th) has a value.
   pure subroutine find_face_angle(value, last, p, q, th, is_found)
      !> The value, > 0.
      real(dp), intent(in) :: value
      !> The largest angle.
      real(dp), intent(in) :: last
      !> The factors, >= 0, not both 0.
      real(dp), intent(in) :: p, q
      !> Receives the angle.
      real(dp), intent(out) :: th
      !> Is there one up to the largest?
      logical, intent(out) :: is_found
      integer, parameter :: most_steps = 100
      real(dp) :: low, high, rest, largest
      integer :: k

      th = last
      largest = p*(last + sin(last)*cos(last)) + q*sin(last)
      is_found = value <= largest
      if (.not. is_found .or. .not. value < largest) return
      low = 0
      high = last
      th = min(value/(2*p + q), last)
      do k = 1, most_steps
         rest = value - p*(th + sin(th)*cos(th)) - q*sin(th)
         if (rest > 0) low = th
         if (.not. rest > 0) high = th
         if (high - low <= 2*epsilon(th)*high .or. .not. abs(rest) > 2*epsilon(rest)*value) return
         th = th + rest/(2*p*cos(th)**2 + q*cos(th))
         if (.not. (th > low .and. th < high)) th = low + (high - low)/2
      end do
   end subroutine find_face_angle

   !> What is held by a contact, see `held_of`.
   pure real(dp) function held_by(curve, control, contact)
      !> The curve with the compliance of its spring.
      class(curve_t), intent(in) :: curve
      !> What is held; not `control_radius`.
      integer, intent(in) :: control
      !> The contact.
      type(contact_t), intent(in) :: contact

      held_by = contact%load
      if (control /= control_load) held_by = contact%approach
      if (control == control_spring) held_by = held_by + curve%compliance*contact%load
   end function held_by

   !> The parts of a curve, and where contacts end under what is held.
   pure subroutine survey_curve(curve, control, survey)
      !> The curve of the indenter.
      class(curve_t), intent(in) :: curve
      !> What is held; a given radius counts as a given load.
      integer, intent(in) :: control
      !> Receives the parts and the ends.
      type(survey_t), intent(out) :: survey
      integer :: held_control, k

      call clear_ends(survey%ends)
      held_control = stability_control(control)
      if (curve%shape%n_pieces == 0) then
         call set_face_ends(curve, held_control, survey%ends)
      else
         call curve%find_intervals(held_control, survey%intervals, survey%n, survey%ends%is_converged)
         do k = 1, survey%n
            call measure_interval(curve, held_control, survey%intervals(k))
         end do
         call curve%find_discs(held_control, survey%discs, survey%n_discs)
         call find_pull_off(curve, held_control, survey%intervals(:survey%n), survey%discs(:survey%n_discs), survey%ends)
         call find_jumps(curve, held_control, survey%intervals(:survey%n), survey%ends)
      end if
   end subroutine survey_curve

   !> Where the contact of a flat face ends.
   pure subroutine set_face_ends(curve, control, ends)
      !> The curve of the face.
      class(curve_t), intent(in) :: curve
      !> What is held; not `control_radius`.
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
            if (control /= control_load .and. th >= half_pi) ends%pull_off_approach = detached_approach(curve)
         end associate
      end select
   end subroutine set_face_ends

   !> The stable state where what is held is least.
   pure subroutine find_pull_off(curve, control, intervals, discs, ends)
      !> The curve of the indenter.
      class(curve_t), intent(in) :: curve
      !> What is held; not `control_radius`.
      integer, intent(in) :: control
      !> The intervals of the curve.
      type(interval_t), intent(in) :: intervals(:)
      !> The discs that are stable.
      type(disc_range_t), intent(in) :: discs(:)
      !> Receives the pull-off.
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
      !> The curve of the indenter.
      class(curve_t), intent(in) :: curve
      !> What is held; not `control_radius`.
      integer, intent(in) :: control
      !> The state.
      type(state_t), intent(in) :: state
      !> The least that is held so far.
      real(dp), intent(inout) :: least
      !> Receives the pull-off.
      type(ends_t), intent(inout) :: ends

      if (.not. held_of(curve, control, state) < least) return
      least = held_of(curve, control, state)
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
      !> The curve of the indenter.
      class(curve_t), intent(in) :: curve
      !> What is held; not `control_radius`.
      integer, intent(in) :: control
      !> The intervals of the curve, from the smallest contacts to the largest.
      type(interval_t), intent(in) :: intervals(:)
      !> Receives the jumps.
      type(ends_t), intent(inout) :: ends
      type(state_t) :: fold
      real(dp) :: held
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
         held = held_of(curve, control, fold)
         do j = 1, k - 1
            if (.not. intervals(j)%is_stable) cycle
            if (held < intervals(j)%first .or. held > intervals(j)%last) cycle
            ends%jump_inward_load = fold%load
            ends%jump_inward_approach = fold%approach
         end do
      end do
   end subroutine find_jumps

end module adfric_indenter_contact
