! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact of an indenter under a given load, approach or radius, from the survey of its curve.
module adfric_round_contact
   use adfric_base_kinds, only: dp
   use adfric_round_contact_state, only: contact_t, set_contact, set_disc, terms_of, prescribed_of
   use adfric_round_curve, only: curve_t, state_t, curve_interval_t, disc_range_t, control_load, control_approach, &
      & control_spring, control_radius
   use adfric_round_dugdale_curve, only: dugdale_curve_t
   use adfric_round_face_contact, only: find_face_contact
   use adfric_round_prescribed, only: find_prescribed
   use adfric_round_survey, only: survey_t
   use adfric_numerics_scalar_root, only: equation_t, find_root
   implicit none (type, external)
   private
   public :: find_contact, part_bodies, reach_of, take_given, try_interval, try_disc_range
   public :: branch_stable, branch_inner, branch_unstable

   !> Which state is meant where there are several: the largest stable one, the smallest stable one, the largest unstable one.
   integer, parameter :: branch_stable = 1, branch_inner = 2, branch_unstable = 3

   !> What is held by a disc without touch, less what is given.
   type, extends(equation_t) :: disc_equation_t
      !> The curve.
      class(curve_t), allocatable :: curve
      !> What is prescribed.
      integer :: control = control_approach
      !> What is given.
      real(dp) :: given = 0
   contains
      procedure :: evaluate => evaluate_disc
   end type disc_equation_t

contains

   !> The contact under what is prescribed.
   pure subroutine find_contact(curve, survey, control, given, is_beyond, branch, contact)
      class(curve_t), intent(in) :: curve
      type(survey_t), intent(in) :: survey
      !> What is prescribed, one of `control_...`.
      integer, intent(in) :: control
      !> Load, approach or unknown u that is given, reduced.
      real(dp), intent(in) :: given
      !> Is a given u one of those beyond the corner?
      logical, intent(in) :: is_beyond
      !> One of `branch_...`.
      integer, intent(in) :: branch
      type(contact_t), intent(out) :: contact
      integer :: k, position

      if (curve%shape%n_pieces == 0 .and. branch /= branch_unstable) then
         call find_face_contact(curve, control, given, contact)
      else if (control == control_radius) then
         call set_contact(curve, control, given, is_beyond, contact)
         contact%is_found = .true.
      else
         contact%is_converged = survey%ends%is_converged
         if (branch == branch_inner) call try_discs(curve, survey, control, given, branch, contact)
         do k = 1, survey%n
            if (contact%is_found) return
            position = merge(k, survey%n + 1 - k, branch == branch_inner)
            if (survey%intervals(position)%is_stable .eqv. branch == branch_unstable) cycle
            call try_interval(curve, control, given, survey%intervals(position), contact)
         end do
         if (.not. contact%is_found .and. branch == branch_stable) call try_discs(curve, survey, control, given, branch, contact)
      end if
   end subroutine find_contact

   !> Bodies apart, where no contact has been found that is stable: below the approach of all of them, and of all attraction, there
   !> is no load. Without a range that begins at 0, with one at -h0. DMT has no such state: its pull ends nowhere.
   pure subroutine part_bodies(curve, control, given, contact)
      class(curve_t), intent(in) :: curve
      !> What is prescribed; a load or a radius parts nothing.
      integer, intent(in) :: control
      !> Approach, or that of the base of a spring, reduced.
      real(dp), intent(in) :: given
      !> In: what was found, no contact. Out: the state, if there is one.
      type(contact_t), intent(inout) :: contact

      if (control /= control_approach .and. control /= control_spring .or. abs(curve%outer_pull) > 0) return
      if (.not. given < reach_of(curve)) return
      contact = contact_t()
      contact%is_found = .true.
      contact%is_stable = .true.
      contact%is_beyond = .false.
      contact%approach = given
   end subroutine part_bodies

   !> Approach from which on bodies that are apart attract each other: without a range 0, with one -h0.
   pure real(dp) function reach_of(curve) result(reach)
      class(curve_t), intent(in) :: curve

      reach = 0
      select type (curve)
      type is (dugdale_curve_t)
         reach = -curve%range
      end select
   end function reach_of

   !> The contact within one interval, if it has what is prescribed.
   pure subroutine try_interval(curve, control, given, interval, contact)
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      real(dp), intent(in) :: given
      type(curve_interval_t), intent(in) :: interval
      !> Receives the contact, with `is_found`.
      type(contact_t), intent(inout) :: contact
      real(dp) :: u
      logical :: is_found, is_converged

      call find_prescribed(curve, control, interval, given, u, is_found, is_converged)
      if (.not. is_found) return
      call set_contact(curve, control, u, interval%is_beyond, contact)
      contact%is_found = .true.
      contact%is_converged = contact%is_converged .and. is_converged
      contact%is_stable = interval%is_stable
      call take_given(curve, control, given, contact)
   end subroutine try_interval

   !> What is given has all of its digits.
   pure subroutine take_given(curve, control, given, contact)
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      real(dp), intent(in) :: given
      !> The contact, whose load or approach may be replaced.
      type(contact_t), intent(inout) :: contact

      if (control == control_load) contact%load = given
      if (control == control_approach) contact%approach = given
      if (control == control_spring) call share_digits(curve, given, contact)
   end subroutine take_given

   !> Of load and approach, both differences, the one with fewer digits follows from the other and from the base of the spring.
   pure subroutine share_digits(curve, given, contact)
      class(curve_t), intent(in) :: curve
      !> Approach of the base.
      real(dp), intent(in) :: given
      type(contact_t), intent(inout) :: contact
      real(dp) :: terms(2)

      terms = terms_of(contact)
      if (curve%compliance*terms(1) > abs(given) + terms(2)) then
         contact%load = (given - contact%approach)/curve%compliance
      else if (terms(2) > abs(given) + curve%compliance*terms(1)) then
         contact%approach = given - curve%compliance*contact%load
      end if
   end subroutine share_digits

   !> The state without touch, if there is one.
   pure subroutine try_discs(curve, survey, control, given, branch, contact)
      class(curve_t), intent(in) :: curve
      type(survey_t), intent(in) :: survey
      integer, intent(in) :: control
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

   !> The disc within one range, if it has what is prescribed.
   pure subroutine try_disc_range(curve, control, given, range, contact)
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      real(dp), intent(in) :: given
      type(disc_range_t), intent(in) :: range
      type(contact_t), intent(inout) :: contact
      type(disc_equation_t) :: equation
      type(state_t) :: first, last
      real(dp) :: c
      logical :: is_converged

      call curve%get_disc(range%low, first)
      call curve%get_disc(range%high, last)
      contact%is_found = given >= prescribed_of(curve, control, first) .and. given < prescribed_of(curve, control, last)
      if (.not. contact%is_found) return
      c = range%low
      is_converged = .true.
      if (given > prescribed_of(curve, control, first)) then
         c = (range%low + range%high)/2
         allocate (equation%curve, source=curve)
         equation%control = control
         equation%given = given
         call find_root(equation, range%low, range%high, .true., c, is_converged)
      end if
      call set_disc(curve, control, c, contact)
      contact%is_stable = .true.
      contact%is_converged = contact%is_converged .and. is_converged
      call take_given(curve, control, given, contact)
   end subroutine try_disc_range

   !> See `equation_t`.
   pure subroutine evaluate_disc(self, x, value, slope)
      class(disc_equation_t), intent(in) :: self
      !> Radius c of the disc.
      real(dp), intent(in) :: x
      !> What it holds less what is given.
      real(dp), intent(out) :: value
      !> Derivative of the value by c.
      real(dp), intent(out) :: slope
      type(state_t) :: state

      call self%curve%get_disc(x, state)
      value = prescribed_of(self%curve, self%control, state) - self%given
      slope = state%approach_slope
      if (self%control == control_spring) slope = slope + self%curve%compliance*state%load_slope
   end subroutine evaluate_disc

end module adfric_round_contact
