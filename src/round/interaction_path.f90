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
!>
!> A sphere has more: its radius may be prescribed, and its contact may be the unstable one. Then b may grow with g
!> (`is_shrinking` is false). Its stresses are those of E* = R = 1, its lengths and forces those of J 2.11.
module adfric_round_interaction_path
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi, pi
   use adfric_round_contact_state, only: contact_t
   use adfric_interface_interaction, only: adhesion_ratio, largest_slip_energy
   use adfric_round_shrinking_path, only: shrinking_path_t, slip_state_t
   use adfric_round_slip_annulus, only: angle_of_slip, largest_slip_core, slip_of_angle
   implicit none (type, external)
   private
   public :: interaction_law_t, interaction_path_t, waypoint_t, begin_path, get_waypoint, get_known_waypoint, complete_waypoint
   public :: slip_of, slip_at, largest_slip_of, get_rates, gamma_of, steepest
   public :: end_none, end_capped, end_sliding, end_snap_off, end_no_adhesion

   !> How the part of the path ends where the contact changes: it is not known yet, slip is large enough to take no more, the centre
   !> slips, the contact is lost, or nothing is left of adhesion.
   integer, parameter :: end_none = 0, end_capped = 1, end_sliding = 2, end_snap_off = 3, end_no_adhesion = 4

   !> The law of friction.
   type :: interaction_law_t
      !> tau, > 0, and m.
      real(dp) :: strength = 1, compliance = 1
      !> x, 0 to 1.
      real(dp) :: edge_fraction = 0.4_dp
      !> alpha >= 0.
      real(dp) :: interaction = 0
      !> g0 > 0; the largest number if slip never stops to take from adhesion.
      real(dp) :: slip_energy_ratio = huge(1.0_dp)
   end type interaction_law_t

   !> A state on the path.
   type, extends(slip_state_t) :: waypoint_t
      !> The contact at this X.
      type(contact_t) :: contact
   end type waypoint_t

   !> A path.
   type, abstract, extends(shrinking_path_t) :: interaction_path_t
      !> Law of friction.
      type(interaction_law_t) :: law
      !> Does b fall all the path?
      logical :: is_shrinking = .true.
      !> At rest, and where the part of the path ends in which the contact changes.
      type(waypoint_t) :: start, finish
      !> How it ends, one of `end_...`.
      integer :: ending = end_none
   contains
      procedure :: get_state
      procedure :: follow
      procedure :: find_remaining
      procedure :: n_passed
      procedure(find_contact_i), deferred :: find_contact
      procedure(find_last_i), deferred :: find_last
      procedure(radius_rate_i), deferred :: radius_rate
   end type interaction_path_t

   abstract interface

      !> The contact of an X up to which the path has been followed.
      pure subroutine find_contact_i(self, ratio, contact)
         import :: interaction_path_t, contact_t, dp
         implicit none (type, external)
         class(interaction_path_t), intent(in) :: self
         !> X.
         real(dp), intent(in) :: ratio
         !> Receives the contact, with `is_found`.
         type(contact_t), intent(out) :: contact
      end subroutine find_contact_i

      !> The last contact, above an X where it has been lost.
      pure subroutine find_last_i(self, lost_ratio, ratio, contact, is_converged)
         import :: interaction_path_t, contact_t, dp
         implicit none (type, external)
         class(interaction_path_t), intent(inout) :: self
         !> An X without contact.
         real(dp), intent(in) :: lost_ratio
         !> Receives X of the last contact.
         real(dp), intent(out) :: ratio
         type(contact_t), intent(out) :: contact
         logical, intent(out) :: is_converged
      end subroutine find_last_i

      !> d ln b/d ln g at a state.
      pure real(dp) function radius_rate_i(self, waypoint)
         import :: interaction_path_t, waypoint_t, dp
         implicit none (type, external)
         class(interaction_path_t), intent(in) :: self
         type(waypoint_t), intent(in) :: waypoint
      end function radius_rate_i

   end interface

   !> A slope where b has fallen to nothing, and next to a fold.
   real(dp), parameter :: steepest = 1.0e30_dp

contains

   !> Begin a path from a contact at rest.
   pure subroutine begin_path(self, law, force_scale, demand, is_weakened, contact)
      !> Receives the law, what follows from it, and the start, which is not found without contact.
      class(interaction_path_t), intent(inout) :: self
      type(interaction_law_t), intent(in) :: law
      !> Force of sliding over b^2, and K.
      real(dp), intent(in) :: force_scale, demand
      !> Does slip take anything from adhesion?
      logical, intent(in) :: is_weakened
      type(contact_t), intent(in) :: contact

      self%law = law
      self%is_weakened = is_weakened
      self%slip_energy_ratio = law%slip_energy_ratio
      self%limit = largest_slip_energy(law%interaction)
      self%force_scale = force_scale
      self%displacement_scale = 2*law%compliance*law%strength
      self%demand = demand
      self%start%is_found = contact%is_found .and. contact%spot%radius > 0
      self%start%contact = contact
      if (self%start%is_found) call complete_waypoint(self, self%start)
   end subroutine begin_path

   !> Follow the contact up to a g; contacts that each X has by itself need not be followed.
   pure subroutine follow(self, slip_energy)
      class(interaction_path_t), intent(inout) :: self
      !> g > 0.
      real(dp), intent(in) :: slip_energy

      associate (unused => self, unused_too => slip_energy)
      end associate
   end subroutine follow

   !> The contact that remains at an X where that of the path has been lost; there may be none.
   pure subroutine find_remaining(self, ratio, contact)
      class(interaction_path_t), intent(in) :: self
      real(dp), intent(in) :: ratio
      type(contact_t), intent(out) :: contact

      contact%is_found = .false.
      associate (unused => self, unused_too => ratio)
      end associate
   end subroutine find_remaining

   !> How many corners a contact has passed: a of it, and c. A smooth profile has none.
   pure integer function n_passed(self, contact)
      class(interaction_path_t), intent(in) :: self
      type(contact_t), intent(in) :: contact

      n_passed = 0
      associate (unused => self, unused_too => contact)
      end associate
   end function n_passed

   !> The state of a slip energy.
   pure subroutine get_waypoint(self, slip_energy, waypoint)
      class(interaction_path_t), intent(inout) :: self
      !> g, from 0 to the limit of the path.
      real(dp), intent(in) :: slip_energy
      !> Receives the state; not found where the contact has been lost.
      type(waypoint_t), intent(out) :: waypoint

      if (self%is_weakened .and. slip_energy > 0) call self%follow(slip_energy)
      call get_known_waypoint(self, slip_energy, waypoint)
   end subroutine get_waypoint

   !> See `shrinking_path_t`.
   pure subroutine get_state(self, slip_energy, state, rate)
      class(interaction_path_t), intent(inout) :: self
      real(dp), intent(in) :: slip_energy
      type(slip_state_t), intent(out) :: state
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
      type(waypoint_t), intent(out) :: waypoint

      waypoint = self%start
      waypoint%slip_energy = slip_energy
      if (self%is_weakened .and. slip_energy > 0) then
         waypoint%ratio = adhesion_ratio(slip_energy, self%law%interaction)
         call self%find_contact(waypoint%ratio, waypoint%contact)
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

   !> gamma = e/b of a state.
   pure real(dp) function gamma_of(state) result(gamma)
      class(slip_state_t), intent(in) :: state

      gamma = 0
      if (state%angle < half_pi) gamma = cos(state%angle)
   end function gamma_of

   !> s, the mean slip at the edge of an annulus.
   elemental real(dp) function slip_of(law, radius, angle) result(slip)
      type(interaction_law_t), intent(in) :: law
      !> b and th.
      real(dp), intent(in) :: radius, angle

      slip = 4*law%compliance*law%strength*radius*slip_of_angle(angle)/pi
   end function slip_of

   !> Slip at the edge in a direction t from that of the force: it varies by (4/3 pi) (m - 1) tau b (1 - (e/b)^3) cos 2t.
   elemental real(dp) function slip_at(law, radius, angle, direction) result(slip)
      type(interaction_law_t), intent(in) :: law
      real(dp), intent(in) :: radius, angle
      !> t [rad].
      real(dp), intent(in) :: direction
      real(dp) :: gamma, share

      gamma = cos(angle)
      share = 2*sin(angle/2)**2*(1 + gamma*(1 + gamma))/3
      slip = slip_of(law, radius, angle) - 4*(law%compliance - 1)*law%strength*radius*share*cos(2*direction)/pi
   end function slip_at

   !> The largest slip at the edge, across the force where m > 1.
   elemental real(dp) function largest_slip_of(law, radius, angle) result(slip)
      type(interaction_law_t), intent(in) :: law
      real(dp), intent(in) :: radius, angle

      slip = slip_at(law, radius, angle, merge(half_pi, 0.0_dp, law%compliance > 1))
   end function largest_slip_of

   !> d ln T/d ln g and d ln u/d ln g, the slip core's differential being th cos(th) dth.
   pure subroutine get_rates(self, waypoint, force_rate, displacement_rate, shrinkage)
      class(interaction_path_t), intent(in) :: self
      !> A state of the path, not an end of slip.
      type(waypoint_t), intent(in) :: waypoint
      !> Receive the rates.
      real(dp), intent(out) :: force_rate, displacement_rate
      !> Receives d ln b/d ln g.
      real(dp), intent(out) :: shrinkage
      real(dp) :: turning

      shrinkage = self%radius_rate(waypoint)
      associate (th => waypoint%angle)
         ! cos(th) dth/d ln g
         turning = 0
         if (waypoint%core <= largest_slip_core .and. th > 0) turning = waypoint%core*(1 - shrinkage)/th
         force_rate = 2*shrinkage + 2*cos(th)*turning/(th + sin(th)*cos(th))
         displacement_rate = shrinkage + turning/sin(th)
      end associate
   end subroutine get_rates

end module adfric_round_interaction_path
