! SPDX-License-Identifier: GPL-3.0-or-later
!> The path of an indenter from rest to sliding, where friction takes from adhesion what it needs to slip (K. L. Johnson, Proc. R.
!> Soc. Lond. A 453, 1997, 163: J 4.5-4.9), reduced. With tau the shear strength, m the ratio of the tangential to the normal
!> compliance, b = a + x (c - a) the radius up to which friction acts, and th = arccos(e/b), e the radius that sticks,
!>
!>     T = 2 tau b^2 (th + sin th cos th),   u = 2 m tau b sin th,   s = (4 m tau b/pi) (th sin th + cos th - 1)
!>     g = tau s/W,   X = X(g),   contact = that of X w
!>
!> s is the slip at the edge, the mean around it. What is prescribed stays: a load, an approach, or that of the base of a spring. g
!> is the position on the path: as it grows X falls, with it b (`adfric_round_weak_contact`), so the slip core th sin th + cos th -
!> 1 = g/(K b), K = 4 m tau^2/(pi W), and th grow: each g has one state, and so has each th. T and u may fall again.
module adfric_round_interaction_path
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_round_annulus, only: get_annulus
   use adfric_round_contact_state, only: contact_t
   use adfric_round_curve, only: control_approach, control_load, control_spring, curve_t
   use adfric_round_dugdale_curve, only: dugdale_curve_t
   use adfric_round_weak_contact, only: extend_path, find_known, new_weak_path, weak_path_t
   use adfric_interface_interaction, only: adhesion_ratio, get_adhesion_ratio, largest_slip_energy
   use adfric_round_shrinking_path, only: shrinking_path_t, slip_state_t
   use adfric_round_slip_annulus, only: angle_of_slip, largest_slip_core, slip_of_angle
   implicit none (type, external)
   private
   public :: friction_law_t, interaction_path_t, waypoint_t, new_path, get_waypoint, get_known_waypoint, complete_waypoint
   public :: slip_of, largest_slip_of, get_rates, work_of

   !> The law of friction.
   type :: friction_law_t
      !> tau, > 0, and m.
      real(dp) :: strength = 1, compliance = 1
      !> x, 0 to 1.
      real(dp) :: edge_fraction = 0.4_dp
      !> alpha >= 0.
      real(dp) :: interaction = 0
      !> g0 > 0; the largest number if slip never stops to take from adhesion.
      real(dp) :: slip_energy_ratio = huge(1.0_dp)
   end type friction_law_t

   !> A state on the path.
   type, extends(slip_state_t) :: waypoint_t
      !> The contact at this X.
      type(contact_t) :: contact
   end type waypoint_t

   !> A path.
   type, extends(shrinking_path_t) :: interaction_path_t
      !> States of contact as X falls.
      type(weak_path_t) :: retreat
      !> Law of friction.
      type(friction_law_t) :: law
      !> At rest.
      type(waypoint_t) :: start
   contains
      procedure :: get_state
   end type interaction_path_t

   !> A slope where b has fallen to nothing, and next to a fold.
   real(dp), parameter :: steepest = 1.0e30_dp

contains

   !> A path from a contact at rest.
   pure subroutine new_path(self, curve, law, control, given, contact)
      !> Receives the path; its start is not found without contact.
      type(interaction_path_t), intent(out) :: self
      class(curve_t), intent(in) :: curve
      type(friction_law_t), intent(in) :: law
      integer, intent(in) :: control
      real(dp), intent(in) :: given
      type(contact_t), intent(in) :: contact

      self%law = law
      ! without adhesion there is nothing that friction could take
      self%is_weakened = law%interaction > 0 .and. work_of(curve) > 0
      self%slip_energy_ratio = law%slip_energy_ratio
      self%limit = largest_slip_energy(law%interaction)
      self%force_scale = pi*law%strength
      self%displacement_scale = 2*law%compliance*law%strength
      if (work_of(curve) > 0) self%demand = 4*law%compliance*law%strength**2/(pi*work_of(curve))
      self%start%is_found = contact%is_found .and. contact%spot%radius > 0
      self%start%contact = contact
      if (.not. self%start%is_found) return
      call complete_waypoint(self, self%start)
      call new_weak_path(self%retreat, curve, control, given, contact)
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

   !> The state of a slip energy.
   pure subroutine get_waypoint(self, slip_energy, waypoint)
      class(interaction_path_t), intent(inout) :: self
      !> g, from 0 to the limit of the path.
      real(dp), intent(in) :: slip_energy
      !> Receives the state; not found where the contact has been lost.
      type(waypoint_t), intent(out) :: waypoint

      if (self%is_weakened .and. slip_energy > 0) call extend_path(self%retreat, adhesion_ratio(slip_energy, &
         & self%law%interaction))
      call get_known_waypoint(self, slip_energy, waypoint)
   end subroutine get_waypoint

   !> See `shrinking_path_t`.
   pure subroutine get_state(self, slip_energy, state, rate)
      class(interaction_path_t), intent(inout) :: self
      !> g, from 0 to the limit of the path.
      real(dp), intent(in) :: slip_energy
      !> Receives the state; not found where the contact has been lost.
      type(slip_state_t), intent(out) :: state
      !> Receives d ln T/d ln g, if it is asked for; enormous and below 0 beyond the last contact.
      real(dp), intent(out), optional :: rate
      type(waypoint_t) :: waypoint
      real(dp) :: others(2)

      call get_waypoint(self, slip_energy, waypoint)
      state = waypoint%slip_state_t
      if (.not. present(rate)) return
      rate = -steepest
      if (waypoint%is_found) call get_rates(self, waypoint, rate, others(1), others(2))
   end subroutine get_state

   !> The state of a slip energy up to which the path is known.
   pure subroutine get_known_waypoint(self, slip_energy, waypoint)
      class(interaction_path_t), intent(in) :: self
      !> g, from 0 to the largest one that has been looked at.
      real(dp), intent(in) :: slip_energy
      !> Receives the state; not found where the contact has been lost.
      type(waypoint_t), intent(out) :: waypoint

      waypoint = self%start
      waypoint%slip_energy = slip_energy
      if (self%is_weakened .and. slip_energy > 0) then
         waypoint%ratio = adhesion_ratio(slip_energy, self%law%interaction)
         call find_known(self%retreat, waypoint%ratio, waypoint%contact)
         waypoint%is_found = waypoint%contact%is_found .and. waypoint%contact%spot%radius > 0
      end if
      if (waypoint%is_found) call complete_waypoint(self, waypoint)
   end subroutine get_known_waypoint

   !> b, slip core and angle of a contact and its g.
   pure subroutine complete_waypoint(self, waypoint)
      class(interaction_path_t), intent(in) :: self
      !> In: with its contact and g. Out: with b, slip core and angle, too.
      type(waypoint_t), intent(inout) :: waypoint

      associate (contact => waypoint%contact)
         waypoint%radius = contact%spot%radius
         ! c - a = s^2/(c + a)
         if (contact%stress > 0) waypoint%radius = waypoint%radius + self%law%edge_fraction*(contact%neck/(2*contact%stress))**2 &
            & /(contact%adhesion_radius + contact%spot%radius)
      end associate
      waypoint%core = 2*largest_slip_core
      ! where friction takes nothing from adhesion the slip energy of sliding need not be given
      if (waypoint%slip_energy < huge(waypoint%slip_energy)) then
         if (waypoint%slip_energy/self%demand < waypoint%core*waypoint%radius) &
            & waypoint%core = waypoint%slip_energy/self%demand/waypoint%radius
      end if
      waypoint%angle = angle_of_slip(waypoint%core)
   end subroutine complete_waypoint

   !> s, the mean slip at the edge of an annulus.
   pure real(dp) function slip_of(law, radius, angle) result(slip)
      type(friction_law_t), intent(in) :: law
      !> b and th.
      real(dp), intent(in) :: radius, angle

      slip = 4*law%compliance*law%strength*radius*slip_of_angle(angle)/pi
   end function slip_of

   !> The largest slip at the edge: it varies by (4/3 pi) (m - 1) tau b (1 - (e/b)^3) cos 2t around it.
   pure real(dp) function largest_slip_of(law, radius, angle) result(slip)
      type(friction_law_t), intent(in) :: law
      !> b and th.
      real(dp), intent(in) :: radius, angle
      real(dp) :: share

      share = cos(angle)
      share = 2*sin(angle/2)**2*(1 + share*(1 + share))/3
      slip = slip_of(law, radius, angle) + abs(4*(law%compliance - 1)*law%strength*radius*share/pi)
   end function largest_slip_of

   !> d ln T/d ln g and d ln u/d ln g, the slip core's differential being th cos(th) dth.
   pure subroutine get_rates(self, waypoint, force_rate, displacement_rate, shrinkage)
      class(interaction_path_t), intent(in) :: self
      !> A state of the path, not an end of slip.
      type(waypoint_t), intent(in) :: waypoint
      !> Receive the rates.
      real(dp), intent(out) :: force_rate, displacement_rate
      !> Receives d ln b/d ln g, at most 0.
      real(dp), intent(out) :: shrinkage
      real(dp) :: turning

      shrinkage = radius_rate(self, waypoint)
      associate (th => waypoint%angle)
         ! cos(th) dth/d ln g
         turning = 0
         if (waypoint%core <= largest_slip_core .and. th > 0) turning = waypoint%core*(1 - shrinkage)/th
         force_rate = 2*shrinkage + 2*cos(th)*turning/(th + sin(th)*cos(th))
         displacement_rate = shrinkage + turning/sin(th)
      end associate
   end subroutine get_rates

   !> d ln b/d ln g, at most 0.
   pure real(dp) function radius_rate(self, waypoint) result(rate)
      class(interaction_path_t), intent(in) :: self
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
      class(interaction_path_t), intent(in) :: self
      type(waypoint_t), intent(in) :: waypoint
      real(dp), parameter :: step = 1.0e-6_dp
      type(interaction_path_t) :: copy
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

end module adfric_round_interaction_path
