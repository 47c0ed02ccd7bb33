! SPDX-License-Identifier: GPL-3.0-or-later
!> Round contacts with adhesion whose edge stays: what they are under a load, at an approach or on a spring, and what their edge
!> asks for.
!>
!> The edge of adhesion is at c. In JKR it is that of contact, a = c, and what is free is the depth D of the flat punch that
!> adhesion adds. With a stress S beside the contact (Maugis) the radius a of contact is free, a^2 = c^2 - s^2:
!>
!>     JKR      P = P1(c) - 2 c D,                  delta = g(c) - D,        G = D |D|/(2 pi c)
!>     Maugis   P = P1(a) - 2 S (c^2 th + a s),     delta = g(a) - 2 S s,    G = S h(c),     th = arctan(s/a)
!>
!> G is the energy release rate of the edge, h(c) the gap there. The edge stays while G lies between the work of closing and
!> that of opening.
!>
!> Uniqueness. Both kinds answer a change of approach like a flat punch of the radius of contact, dP = 2 a ddelta, and with the
!> free variable y (D falling, or a rising) ddelta/dy = 1, or g' + 2 S a/s > 0. So load, approach and base of a spring rise
!> together, and each has one state. The gap at c follows as dh = -(2/pi) arccos(a/c) ddelta < 0, so G falls along them: what
!> moves the edge first is known from the state at the end.
!>
!> Where a is 0 the disc alone carries the load: P = -pi S c^2, h(c) = f(c) - delta - 4 S c/pi.
module adfric_round_pinned_edge
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi, pi, two_pi
   use adfric_numerics_scalar_root, only: equation_t, find_root
   use adfric_round_contact, only: take_given
   use adfric_round_contact_state, only: contact_t, set_contact, set_disc
   use adfric_round_curve, only: at_corner, control_approach, control_load, control_spring, curve_t
   use adfric_round_dugdale_curve, only: dugdale_curve_t, get_range
   use adfric_round_shape, only: spot_t, within_edge
   implicit none (type, external)
   private
   public :: pin_contact, contact_at_edge, work_of_edge

   !> A contact of a given edge c: its load, approach or base less what is given, or its gap there less the range.
   !>
   !> The zone s alone says little of a small contact, and of one beside the corner b of the profile. So with S^2 = c^2 - b^2 the
   !> unknown is psi, s = S sin psi and v = sqrt(a^2 - b^2) = S cos psi. Where c lies within the corner, or there is none, b counts
   !> as 0. Contacts within the corner of an edge beyond it have the unknown w = sqrt(b^2 - a^2).
   type, extends(equation_t) :: pinned_equation_t
      !> The curve, whose range is used where `is_of_gap`.
      type(dugdale_curve_t) :: curve
      !> Radius c of the edge, and what is given.
      real(dp) :: edge = 1, given = 0
      !> What is prescribed.
      integer :: control = control_load
      !> Is the gap wanted?
      logical :: is_of_gap = .false.
      !> The corner b, 0 where it does not count, and S.
      real(dp) :: corner = 0, widest = 1
      !> Is w the unknown?
      logical :: is_within = .false.
   contains
      procedure :: evaluate
   end type pinned_equation_t

contains

   !> Reduced work of adhesion of a curve, W.
   pure real(dp) function work_of_edge(curve) result(work)
      class(curve_t), intent(in) :: curve

      work = curve%tension**2/two_pi
      select type (curve)
      type is (dugdale_curve_t)
         work = curve%stress*curve%range
      end select
   end function work_of_edge

   !> The contact with this edge under what is prescribed.
   pure subroutine pin_contact(curve, control, edge, given, contact, release)
      class(curve_t), intent(in) :: curve
      !> What is prescribed: load, approach, or base of a spring.
      integer, intent(in) :: control
      !> Radius c of the edge, > 0.
      real(dp), intent(in) :: edge
      !> What is given, reduced.
      real(dp), intent(in) :: given
      !> Receives the contact, with `is_found`: a load below that of the disc has none.
      type(contact_t), intent(out) :: contact
      !> Receives the energy release rate of the edge, in the unit of `work_of_edge`.
      real(dp), intent(out) :: release

      release = 0
      select type (curve)
      type is (dugdale_curve_t)
         call pin_zone(curve, control, edge, given, contact, release)
      class default
         call pin_punch(curve, control, edge, given, contact, release)
      end select
      if (contact%is_found) call take_given(curve, control, given, contact)
   end subroutine pin_contact

   !> See `pin_contact`: JKR.
   pure subroutine pin_punch(curve, control, edge, given, contact, release)
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      real(dp), intent(in) :: edge, given
      type(contact_t), intent(out) :: contact
      real(dp), intent(out) :: release

      release = 0
      call contact_at_edge(curve, control, edge, contact)
      if (.not. contact%is_converged) return
      contact%is_stable = .true.
      associate (spot => contact%spot, neck => contact%neck)
         select case (control)
         case (control_load)
            neck = (spot%load - given)/(2*spot%radius)
         case (control_approach)
            neck = spot%depth - given
         case default
            neck = (spot%depth + curve%compliance*spot%load - given)/(1 + 2*curve%compliance*spot%radius)
         end select
         contact%load = spot%load - 2*spot%radius*neck
         contact%approach = spot%depth - neck
         contact%stiffness = 2*spot%radius
         release = neck*abs(neck)/(two_pi*spot%radius)
      end associate
   end subroutine pin_punch

   !> See `pin_contact`: a stress beside the contact.
   pure subroutine pin_zone(curve, control, edge, given, contact, release)
      type(dugdale_curve_t), intent(in) :: curve
      integer, intent(in) :: control
      real(dp), intent(in) :: edge, given
      type(contact_t), intent(out) :: contact
      real(dp), intent(out) :: release
      type(pinned_equation_t) :: equation
      type(spot_t) :: spot
      real(dp) :: s, gap, ratio, opening, intensity, height, slope

      equation%edge = edge
      equation%control = control
      equation%given = given
      call find_zone(curve, equation, contact)
      if (contact%is_found) then
         s = contact%neck/(2*curve%stress)
         gap = 0
         if (s > 0) call get_range(curve, contact%spot, contact%is_beyond, s, gap, ratio, opening, intensity)
         release = curve%stress*gap
      else if (contact%is_converged .and. control /= control_load) then
         ! the disc alone
         call curve%shape%evaluate(0.0_dp, .not. curve%shape%corner > 0, spot)
         call curve%shape%get_profile(edge, height, slope)
         contact%is_found = .true.
         contact%is_beyond = .false.
         contact%spot = spot
         contact%load = -pi*curve%stress*edge**2
         contact%approach = given
         if (control == control_spring) contact%approach = given - curve%compliance*contact%load
         contact%neck = 2*curve%stress*edge
         contact%disc_terms = [pi*curve%stress*edge**2, height + 4*curve%stress*edge/pi + abs(contact%approach)]
         release = curve%stress*(height - contact%approach - 4*curve%stress*edge/pi)
      end if
      contact%adhesion_radius = edge
      contact%stress = curve%stress
      contact%is_stable = contact%is_found
   end subroutine pin_zone

   !> The contact on the curve whose edge of adhesion is at a radius, stable or not.
   pure subroutine contact_at_edge(curve, control, edge, contact)
      class(curve_t), intent(in) :: curve
      integer, intent(in) :: control
      !> Radius c of the edge, > 0.
      real(dp), intent(in) :: edge
      type(contact_t), intent(out) :: contact
      type(pinned_equation_t) :: equation

      select type (curve)
      type is (dugdale_curve_t)
         equation%edge = edge
         equation%is_of_gap = .true.
         call find_zone(curve, equation, contact)
         if (contact%is_found) then
            call set_contact(curve, control, contact%u, contact%is_beyond, contact)
         else if (contact%is_converged) then
            call set_disc(curve, control, edge, contact)
            contact%is_found = .true.
         end if
      class default
         ! a radius so close to a vertical edge does not know its contact
         contact%is_converged = edge < within_edge*curve%shape%edge
         if (.not. contact%is_converged) return
         call set_contact(curve, control, curve%shape%unknown_of(edge), edge >= curve%shape%corner, contact)
         contact%is_found = .true.
      end select
   end subroutine contact_at_edge

   !> The zone that solves an equation.
   pure subroutine find_zone(curve, equation, contact)
      type(dugdale_curve_t), intent(in) :: curve
      !> In: what is wanted. Out: with the curve.
      type(pinned_equation_t), intent(inout) :: equation
      !> Receives what the equation says of the contact; not found where even the disc has more of what is wanted.
      type(contact_t), intent(out) :: contact
      real(dp) :: x, value, slope, last

      allocate (equation%curve%shape, source=curve%shape)
      equation%curve%stress = curve%stress
      equation%curve%range = curve%range
      equation%curve%compliance = curve%compliance
      if (equation%edge > curve%shape%corner) equation%corner = curve%shape%corner
      equation%widest = sqrt((equation%edge - equation%corner)*(equation%edge + equation%corner))
      last = half_pi
      call equation%evaluate(last, value, slope)
      if (.not. value < 0 .and. equation%corner > 0) then
         equation%is_within = .true.
         last = equation%corner
         call equation%evaluate(last, value, slope)
      end if
      contact%is_found = value < 0
      if (.not. contact%is_found) return
      x = 0
      value = 1
      ! where the whole disc touches there is no zone
      if (.not. (equation%is_of_gap .or. equation%is_within)) call equation%evaluate(x, value, slope)
      if (value > 0) then
         x = last/2
         call find_root(equation, 0.0_dp, last, .false., x, contact%is_converged)
      end if
      call set_pinned(equation, x, contact)
   end subroutine find_zone

   !> Load and approach of a contact of a given edge.
   pure subroutine set_pinned(equation, x, contact, zone_slope, u_slope)
      type(pinned_equation_t), intent(in) :: equation
      !> The unknown.
      real(dp), intent(in) :: x
      !> Receives what it is.
      type(contact_t), intent(inout) :: contact
      !> Receive ds/dx and du/dx.
      real(dp), intent(out), optional :: zone_slope, u_slope
      real(dp) :: a, s, s_slope, slope

      associate (shape => equation%curve%shape, b => equation%corner, c => equation%edge, pull => equation%curve%stress)
         slope = 0
         if (equation%is_within) then
            s = sqrt(equation%widest**2 + x**2)
            a = sqrt((b - x)*(b + x))
            s_slope = x/s
            contact%is_beyond = .false.
            contact%u = a
            if (shape%has_face) contact%u = min(a/max(x, a/at_corner), at_corner)
            if (.not. shape%has_face .and. a > 0) slope = -x/a
         else
            s = equation%widest*sin(x)
            s_slope = max(equation%widest*cos(x), 0.0_dp)
            contact%is_beyond = b > 0 .or. s_slope >= shape%corner
            contact%u = s_slope
            if (.not. b > 0) contact%u = shape%unknown_of(s_slope)
         end if
         call shape%evaluate(contact%u, contact%is_beyond, contact%spot)
         a = contact%spot%radius
         if (.not. equation%is_within) then
            slope = -s
            if (.not. b > 0 .and. contact%spot%radius_slope > 0) slope = -s/contact%spot%radius_slope
         end if
         contact%neck = 2*pull*s
         contact%load = contact%spot%load - 2*pull*(c**2*atan2(s, a) + a*s)
         contact%approach = contact%spot%depth - contact%neck
         contact%stiffness = 2*a
      end associate
      if (present(zone_slope)) zone_slope = s_slope
      if (present(u_slope)) u_slope = slope
   end subroutine set_pinned

   !> See `equation_t`: what is prescribed less what is given, or the range less the gap. Both fall with the unknown.
   pure subroutine evaluate(self, x, value, slope)
      class(pinned_equation_t), intent(in) :: self
      real(dp), intent(in) :: x
      real(dp), intent(out) :: value, slope
      type(contact_t) :: contact
      real(dp) :: s, gap, ratio, opening, intensity, rate, zone_slope, u_slope

      call set_pinned(self, x, contact, zone_slope, u_slope)
      associate (spot => contact%spot, a => contact%spot%radius)
         ! ddelta/dx
         rate = spot%depth_slope*u_slope - 2*self%curve%stress*zone_slope
         if (self%is_of_gap) then
            s = contact%neck/(2*self%curve%stress)
            call get_range(self%curve, spot, contact%is_beyond, s, gap, ratio, opening, intensity)
            value = self%curve%range - gap
            slope = rate*atan2(s, a)/half_pi
         else
            select case (self%control)
            case (control_load)
               value = contact%load - self%given
               slope = 2*a*rate
            case (control_approach)
               value = contact%approach - self%given
               slope = rate
            case default
               value = contact%approach + self%curve%compliance*contact%load - self%given
               slope = rate*(1 + 2*self%curve%compliance*a)
            end select
         end if
      end associate
   end subroutine evaluate

end module adfric_round_pinned_edge
