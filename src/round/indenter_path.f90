! SPDX-License-Identifier: GPL-3.0-or-later
!> The path from rest to sliding of an indenter that is a curve of equilibrium: its contact is followed as X falls
!> (`adfric_round_weak_contact`).
module adfric_round_indenter_path
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_round_annulus, only: get_annulus
   use adfric_round_contact, only: branch_stable, find_curve_contact => find_contact
   use adfric_round_contact_state, only: contact_t
   use adfric_round_curve, only: control_approach, control_spring, curve_t
   use adfric_round_dugdale_curve, only: dugdale_curve_t
   use adfric_round_interaction_path, only: begin_path, interaction_law_t, get_waypoint, interaction_path_t, steepest, waypoint_t
   use adfric_round_survey, only: survey_curve, survey_t
   use adfric_round_weak_contact, only: extend_path, find_known, find_last_contact => find_last, new_weak_path, weak_path_t
   use adfric_round_weak_path, only: weaken
   use adfric_interface_interaction, only: adhesion_ratio, get_adhesion_ratio
   implicit none (type, external)
   private
   public :: indenter_path_t, new_path, work_of

   !> The path of an indenter.
   type, extends(interaction_path_t) :: indenter_path_t
      !> States of contact as X falls.
      type(weak_path_t) :: retreat
   contains
      procedure :: follow
      procedure :: find_contact
      procedure :: find_last
      procedure :: find_remaining
      procedure :: n_passed
      procedure :: radius_rate
   end type indenter_path_t

contains

   !> A path from a contact at rest.
   pure subroutine new_path(self, curve, law, control, given, contact)
      !> Receives the path; its start is not found without contact.
      type(indenter_path_t), intent(out) :: self
      class(curve_t), intent(in) :: curve
      type(interaction_law_t), intent(in) :: law
      integer, intent(in) :: control
      real(dp), intent(in) :: given
      type(contact_t), intent(in) :: contact
      real(dp) :: demand

      demand = huge(demand)
      if (work_of(curve) > 0) demand = 4*law%compliance*law%strength**2/(pi*work_of(curve))
      ! without adhesion there is nothing that friction could take
      call begin_path(self, law, pi*law%strength, demand, law%interaction > 0 .and. work_of(curve) > 0, contact)
      if (self%start%is_found) call new_weak_path(self%retreat, curve, control, given, contact)
   end subroutine new_path

   !> W, the work of adhesion of a curve.
   pure real(dp) function work_of(curve) result(work)
      class(curve_t), intent(in) :: curve

      work = (curve%tension**2 + curve%outer_pull)/(2*pi)
      select type (curve)
      type is (dugdale_curve_t)
         work = curve%stress*curve%range
      end select
   end function work_of

   !> See `interaction_path_t`.
   pure subroutine follow(self, slip_energy)
      class(indenter_path_t), intent(inout) :: self
      real(dp), intent(in) :: slip_energy

      call extend_path(self%retreat, adhesion_ratio(slip_energy, self%law%interaction))
   end subroutine follow

   !> See `interaction_path_t`.
   pure subroutine find_contact(self, ratio, contact)
      class(indenter_path_t), intent(in) :: self
      real(dp), intent(in) :: ratio
      type(contact_t), intent(out) :: contact

      call find_known(self%retreat, ratio, contact)
   end subroutine find_contact

   !> See `interaction_path_t`.
   pure subroutine find_last(self, lost_ratio, ratio, contact, is_converged)
      class(indenter_path_t), intent(inout) :: self
      real(dp), intent(in) :: lost_ratio
      real(dp), intent(out) :: ratio
      type(contact_t), intent(out) :: contact
      logical, intent(out) :: is_converged

      call find_last_contact(self%retreat, lost_ratio, ratio, contact, is_converged)
   end subroutine find_last

   !> See `interaction_path_t`: the largest stable contact.
   pure subroutine find_remaining(self, ratio, contact)
      class(indenter_path_t), intent(in) :: self
      real(dp), intent(in) :: ratio
      type(contact_t), intent(out) :: contact
      class(curve_t), allocatable :: curve
      type(survey_t) :: survey

      allocate (curve, source=self%retreat%curve)
      call weaken(curve, ratio)
      call survey_curve(curve, self%retreat%control, survey)
      call find_curve_contact(curve, survey, self%retreat%control, self%retreat%given, .true., branch_stable, contact)
   end subroutine find_remaining

   !> See `interaction_path_t`.
   pure integer function n_passed(self, contact)
      class(indenter_path_t), intent(in) :: self
      type(contact_t), intent(in) :: contact

      n_passed = 0
      associate (shape => self%retreat%curve%shape)
         if (shape%n_pieces == 0 .or. .not. shape%corner > 0 .or. contact%is_beyond) return
         n_passed = 1
         if (.not. contact%adhesion_radius > shape%corner) n_passed = 2
      end associate
   end function n_passed

   !> See `interaction_path_t`; at most 0.
   pure real(dp) function radius_rate(self, waypoint) result(rate)
      class(indenter_path_t), intent(in) :: self
      type(waypoint_t), intent(in) :: waypoint
      real(dp) :: ratio, ratio_slope, by_u(2), by_ratio(2), radius_by_u, radius_by_ratio, shares(2), slope

      rate = 0
      if (.not. self%is_weakened .or. self%retreat%curve%shape%n_pieces == 0) then
         rate = face_rate(self, waypoint)
         return
      end if
      call get_adhesion_ratio(waypoint%slip_energy, self%law%interaction, ratio, ratio_slope)
      associate (contact => waypoint%contact, retreat => self%retreat)
         by_u = contact%slopes
         radius_by_u = contact%spot%radius_slope
         radius_by_ratio = 0
         select type (curve => retreat%curve)
         type is (dugdale_curve_t)
            call get_dugdale_slopes(curve, contact, waypoint%ratio, self%law%edge_fraction, by_ratio, radius_by_u, radius_by_ratio)
         class default
            by_ratio = -[contact%spot%radius, 0.5_dp]*contact%neck/waypoint%ratio
            by_ratio(1) = by_ratio(1) - curve%outer_pull
         end select
         shares = [1.0_dp, 0.0_dp]
         if (retreat%control == control_approach) shares = [0.0_dp, 1.0_dp]
         if (retreat%control == control_spring) shares = [retreat%curve%compliance, 1.0_dp]
         slope = sum(shares*by_u)
         rate = steepest
         if (slope > 0) rate = min(-radius_by_u*sum(shares*by_ratio)/slope + radius_by_ratio, steepest)
         rate = rate*(ratio_slope*waypoint%slip_energy/waypoint%radius)
      end associate
   end function radius_rate

   !> The same of a flat face, from a difference; a contact that is the whole face does not change.
   pure real(dp) function face_rate(self, waypoint) result(rate)
      class(indenter_path_t), intent(in) :: self
      type(waypoint_t), intent(in) :: waypoint
      real(dp), parameter :: step = 1.0e-6_dp
      type(indenter_path_t) :: copy
      type(waypoint_t) :: before

      rate = 0
      if (.not. self%is_weakened .or. .not. waypoint%contact%spot%radius < 1) return
      copy = self
      call get_waypoint(copy, waypoint%slip_energy*(1 - step), before)
      rate = (waypoint%radius - before%radius)/waypoint%radius/step
   end function face_rate

   !> Derivatives of load and approach by X at given a, and of b by u along a curve and by X at given a. With S the whole stress, Y = X S,
   !> h = (2/pi) J + (4 Y/pi) k, k = s th - s^2/(c + a), P = P1 - 2 Y r, r = c^2 th + a s, delta = g - 2 Y s.
   pure subroutine get_dugdale_slopes(curve, contact, ratio, edge_fraction, by_ratio, radius_by_u, radius_by_ratio)
      type(dugdale_curve_t), intent(in) :: curve
      type(contact_t), intent(in) :: contact
      !> X, and x of b.
      real(dp), intent(in) :: ratio, edge_fraction
      !> Receives dP/dX and ddelta/dX at given a.
      real(dp), intent(out) :: by_ratio(2)
      !> Receive db/du and db/dX.
      real(dp), intent(out) :: radius_by_u, radius_by_ratio
      real(dp) :: s, c, th, opening, intensity, pull, one_less, s_by_ratio, s_by_u, n

      pull = ratio*curve%stress
      associate (a => contact%spot%radius, spot => contact%spot)
         s = contact%neck/(2*contact%stress)
         c = hypot(a, s)
         th = atan2(s, a)
         one_less = (s/c)*(s/(c + a))
         call get_annulus(curve%shape, spot, contact%is_beyond, s, opening, intensity)
         s_by_ratio = -(4*curve%stress*(s*th - c*one_less)/pi) &
            & /(2*intensity*s/(pi*c**2) + 4*pull*(th - one_less*s/c)/pi)
         by_ratio(1) = -2*curve%stress*(c**2*th + a*s) - 4*pull*(s*th + a)*s_by_ratio
         by_ratio(2) = -2*curve%stress*s - 2*pull*s_by_ratio
         n = 2*intensity*s/c**2 + 4*pull*(th - one_less*s/c)
         s_by_u = 2*(spot%depth_slope*th - a/c*intensity/c*spot%radius_slope + 2*pull*a/c*one_less*spot%radius_slope)/n
         radius_by_u = spot%radius_slope + edge_fraction*((a*spot%radius_slope + s*s_by_u)/c - spot%radius_slope)
         radius_by_ratio = edge_fraction*s*s_by_ratio/c
      end associate
   end subroutine get_dugdale_slopes

end module adfric_round_indenter_path
