! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact of a flat face without an edge that rises: it touches all over, down to the load of Kendall, or by Dugdale's law.
module adfric_round_face_contact
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, half_pi
   use adfric_round_contact_state, only: contact_t
   use adfric_round_curve, only: curve_t, control_load, control_approach, control_spring
   use adfric_round_dugdale_curve, only: dugdale_curve_t
   use adfric_round_dugdale_folds, only: find_edge_angle
   implicit none (type, external)
   private
   public :: find_face_contact, find_face_angle, get_face_end

contains

   !> The contact of a flat face of radius 1: P = 2 delta, down to the load of Kendall, or by Dugdale's law.
   pure subroutine find_face_contact(curve, control, given, contact)
      !> The curve of the indenter, which has no piece.
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      real(dp), intent(in) :: given
      type(contact_t), intent(out) :: contact

      select type (curve)
      type is (dugdale_curve_t)
         call find_dugdale_face(curve, control, given, contact)
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
      contact%is_found = contact%approach >= -curve%tension
   end subroutine find_face_contact

   !> What is held by a flat face of approach 1 that is in contact all over.
   pure real(dp) function face_factor(curve, control) result(factor)
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control

      factor = merge(2, 1, control == control_load)
      if (control == control_spring) factor = 1 + 2*curve%compliance
   end function face_factor

   !> A flat face by Dugdale's law: under tension a zone of adhesion a < r < 1 opens at its edge, P = -2 S (th + sin(th) cos(th)),
   !> delta = -2 S sin(th), a = cos(th), until the gap at the edge is the range of adhesion, or until nothing touches. At given
   !> approach a face that does not touch goes on until its edge is out of range.
   pure subroutine find_dugdale_face(curve, control, given, contact)
      type(dugdale_curve_t), intent(in) :: curve
      integer, intent(in) :: control
      real(dp), intent(in) :: given
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
      type(dugdale_curve_t), intent(in) :: curve

      call find_edge_angle(pi*curve%range/(4*curve%stress), last_angle)
      if (.not. last_angle > 0) last_angle = half_pi
   end function last_angle

   !> The approach at which the edge of a face that does not touch is out of range.
   pure real(dp) function detached_approach(curve)
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

   !> Where the contact of a flat face ends.
   pure subroutine get_face_end(curve, control, load, approach)
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      !> Receive what remains before it lets go.
      real(dp), intent(out) :: load, approach

      load = -2*curve%tension
      approach = -curve%tension
      select type (curve)
      type is (dugdale_curve_t)
         associate (th => last_angle(curve))
            load = -2*curve%stress*(th + sin(th)*cos(th))
            approach = -2*curve%stress*sin(th)
            if (control /= control_load .and. th >= half_pi) approach = detached_approach(curve)
         end associate
      end select
   end subroutine get_face_end

end module adfric_round_face_contact
