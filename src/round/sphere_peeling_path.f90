! SPDX-License-Identifier: GPL-3.0-or-later
!> The path of a contact from rest to sliding, where friction takes from adhesion what it needs to slip, J 4.5-4.9.
!>
!> At rest g = 0 and gamma = 1. On the path, with what is prescribed (load, approach or radius),
!>
!>     X = X(g),   contact = theory(X),   b = a + x (c - a),   slip core = g/(K b),   K = (2/3) (2 - nu)/(1 - nu) tau^2
!>
!> so a given g has one state, with nothing to iterate but the theory itself, while a given gamma, force or displacement
!> has to be looked for: the area shrinks as they grow. The position on the path is z = sqrt(g), along which gamma's angle,
!> force and displacement begin as straight lines. The path ends where g reaches g0 (from there on the contact stays
!> and only gamma falls), where gamma reaches 0, where the contact snaps off, or where X reaches 0.
module adfric_round_sphere_peeling_path
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi
   use adfric_numerics_scalar_root, only: equation_t
   use adfric_round_sphere_contact, only: sphere_contact_t, theory_t, control_load, branch_stable, find_contact, friction_radius
   use adfric_interface_interaction, only: adhesion_ratio, largest_slip_energy
   use adfric_round_slip_annulus, only: force_of_angle, angle_of_slip, largest_slip_core
   use adfric_round_sphere_static_friction, only: slip_factor
   implicit none (type, external)
   private
   public :: peeling_friction_t, peeling_path_t, peeling_waypoint_t
   public :: new_path, get_waypoint, complete_waypoint, quantity_of, rate_of
   public :: core_along, force_along, displacement_along
   public :: end_none, end_capped, end_sliding, end_snap_off, end_no_adhesion

   !> The law of friction.
   type :: peeling_friction_t
      !> tau, in the scale of lambda, > 0.
      real(dp) :: strength = 1
      !> nu, above -1, up to 1/2.
      real(dp) :: poisson = 0.3_dp
      !> x, 0 to 1 (J 3.8).
      real(dp) :: edge_fraction = 0.4_dp
      !> alpha >= 0.
      real(dp) :: interaction = 0
      !> g0 > 0; the largest number if slip never stops to take from adhesion.
      real(dp) :: slip_energy_ratio = huge(1.0_dp)
   end type peeling_friction_t

   !> A state on the path.
   type :: peeling_waypoint_t
      !> Is there intimate contact?
      logical :: is_found = .false.
      !> Radii, load and approach at this X.
      type(sphere_contact_t) :: contact
      !> g, X, b.
      real(dp) :: slip_energy = 0, ratio = 1, friction_radius = 0
      !> Slip core, which passes its largest value where gamma would be below 0, and arccos gamma.
      real(dp) :: core = 0, angle = 0
   end type peeling_waypoint_t

   !> Quantities along the path: the root of the slip core, force, displacement.
   integer, parameter :: core_along = 1, force_along = 2, displacement_along = 3
   !> How the path ends.
   integer, parameter :: end_none = 0, end_capped = 1, end_sliding = 2, end_snap_off = 3, end_no_adhesion = 4

   !> A path, and a quantity along it less a given value, or its rate, as a function of the position.
   type, extends(equation_t) :: peeling_path_t
      !> Theory of adhesion; its X is set at each position.
      class(theory_t), allocatable :: theory
      !> Law of friction.
      type(peeling_friction_t) :: friction
      !> What is prescribed, one of `control_...`, and the branch, one of `branch_...`.
      integer :: control = control_load, branch = branch_stable
      !> The load, approach or radius that is prescribed.
      real(dp) :: prescribed = 0
      !> K, and 2/3 (2 - nu)/(1 - nu) tau, of the displacement.
      real(dp) :: compliance = 0, displacement_scale = 0
      !> The largest g, where X is 0.
      real(dp) :: limit = huge(1.0_dp)
      !> At rest, and where the path ends.
      type(peeling_waypoint_t) :: start, finish
      !> How the path ends, one of `end_...`.
      integer :: ending = end_none
      !> What `evaluate` gives.
      integer :: quantity = force_along
      !> Value that `evaluate` takes off.
      real(dp) :: given = 0
      !> Does `evaluate` give the rate of the quantity, not the quantity?
      logical :: is_rate = .false.
   contains
      procedure :: evaluate
   end type peeling_path_t

   !> Steps of ln g for the slope of b, where it steers an iteration and where it is the result; of ln z, for the slope
   !> of that.
   real(dp), parameter :: coarse_step = 1.0e-6_dp, fine_step = 1.0e-5_dp, rate_step = 1.0e-4_dp
   !> Slope of ln b where b is 0.
   real(dp), parameter :: fall_to_nothing = -1.0e30_dp

contains

   !> A path; its start is not found if there is no contact at rest.
   pure subroutine new_path(self, theory, friction, control, prescribed, branch)
      !> In: a new path. Out: the path with its parameters and its start.
      type(peeling_path_t), intent(inout) :: self
      !> Theory of adhesion; its own X is not used.
      class(theory_t), intent(in) :: theory
      type(peeling_friction_t), intent(in) :: friction
      !> One of `control_...`: what is prescribed.
      integer, intent(in) :: control
      !> Value of the load, approach or radius that is prescribed, reduced.
      real(dp), intent(in) :: prescribed
      !> One of `branch_...`: which state is meant where there are two.
      integer, intent(in) :: branch

      allocate (self%theory, source=theory)
      self%friction = friction
      self%control = control
      self%prescribed = prescribed
      self%branch = branch
      self%displacement_scale = 2*slip_factor(friction%poisson)*friction%strength/3
      self%compliance = self%displacement_scale*friction%strength
      self%limit = largest_slip_energy(friction%interaction)
      call get_waypoint(self, 0.0_dp, sphere_contact_t(), self%start)
   end subroutine new_path

   !> The state of a slip energy.
   pure subroutine get_waypoint(self, slip_energy, neighbour, waypoint)
      !> The path, with its theory, its friction and what is prescribed.
      class(peeling_path_t), intent(in) :: self
      !> Slip energy g [-], from 0 to the limit of the path.
      real(dp), intent(in) :: slip_energy
      !> A contact nearby, which helps the search, or a new one.
      type(sphere_contact_t), intent(in) :: neighbour
      !> Receives the state; not found without intimate contact.
      type(peeling_waypoint_t), intent(out) :: waypoint
      class(theory_t), allocatable :: theory

      waypoint%slip_energy = slip_energy
      waypoint%ratio = adhesion_ratio(slip_energy, self%friction%interaction)
      waypoint%contact = neighbour
      allocate (theory, source=self%theory)
      theory%ratio = waypoint%ratio
      call find_contact(theory, self%control, self%prescribed, self%branch, waypoint%contact)
      ! without intimate contact there is no friction
      waypoint%is_found = waypoint%contact%is_found .and. waypoint%contact%radius > 0
      if (waypoint%is_found) call complete_waypoint(self, waypoint)
   end subroutine get_waypoint

   !> b, slip core and angle of a contact and its g.
   pure subroutine complete_waypoint(self, waypoint)
      class(peeling_path_t), intent(in) :: self
      !> In: with its contact and g. Out: with b, slip core and angle, too.
      type(peeling_waypoint_t), intent(inout) :: waypoint
      real(dp) :: enough

      waypoint%friction_radius = friction_radius(waypoint%contact, self%friction%edge_fraction)
      waypoint%core = 2*largest_slip_core
      enough = waypoint%core*self%compliance*waypoint%friction_radius
      if (waypoint%slip_energy < enough) waypoint%core = waypoint%slip_energy/(self%compliance*waypoint%friction_radius)
      waypoint%angle = angle_of_slip(waypoint%core)
   end subroutine complete_waypoint

   !> A quantity of a state: root of the slip core, force in pi w R, or displacement, reduced.
   pure real(dp) function quantity_of(self, quantity, waypoint) result(value)
      class(peeling_path_t), intent(in) :: self
      !> One of `..._along`: the quantity that is asked for.
      integer, intent(in) :: quantity
      type(peeling_waypoint_t), intent(in) :: waypoint

      select case (quantity)
      case (core_along)
         value = sqrt(waypoint%core)
      case (force_along)
         value = half_pi*self%friction%strength*waypoint%friction_radius**2*force_of_angle(waypoint%angle)
      case default
         value = self%displacement_scale*waypoint%friction_radius*sin(waypoint%angle)
      end select
   end function quantity_of

   !> d ln(quantity)/d ln g at a state, d core being th cos th d th.
   pure real(dp) function rate_of(self, quantity, waypoint, step, is_central) result(rate)
      !> The path, with its theory, its friction and what is prescribed.
      class(peeling_path_t), intent(in) :: self
      !> One of `..._along`: the quantity that is asked for.
      integer, intent(in) :: quantity
      type(peeling_waypoint_t), intent(in) :: waypoint
      !> Step of ln g for differences, > 0, much below 1.
      real(dp), intent(in) :: step
      !> Shall the difference be central? Otherwise it is one upwards, if there is contact.
      logical, intent(in) :: is_central
      real(dp) :: shrinkage, turn

      shrinkage = radius_rate(self, waypoint, step, is_central)
      associate (th => waypoint%angle)
         turn = 0
         if (waypoint%core <= largest_slip_core) turn = waypoint%core*(1 - shrinkage)/th
         select case (quantity)
         case (core_along)
            rate = (1 - shrinkage)/2
         case (force_along)
            rate = 2*shrinkage + 2*cos(th)*turn/(th + sin(th)*cos(th))
         case default
            rate = shrinkage + turn/sin(th)
         end select
      end associate
   end function rate_of

   !> d ln b/d ln g at a state, from differences on the sides where there is contact.
   pure real(dp) function radius_rate(self, waypoint, step, is_central) result(rate)
      !> The path, with its theory, its friction and what is prescribed.
      class(peeling_path_t), intent(in) :: self
      type(peeling_waypoint_t), intent(in) :: waypoint
      !> Step of ln g for differences, > 0, much below 1.
      real(dp), intent(in) :: step
      !> Shall the difference be central? Otherwise it is one upwards, if there is contact.
      logical, intent(in) :: is_central
      type(peeling_waypoint_t) :: before, after
      real(dp) :: width

      after = waypoint
      before = waypoint
      width = 0
      if (waypoint%slip_energy*(1 + step) <= self%limit) then
         call get_waypoint(self, waypoint%slip_energy*(1 + step), waypoint%contact, after)
         if (after%is_found) width = step
         if (.not. after%is_found) after = waypoint
      end if
      if (is_central .or. .not. width > 0) then
         call get_waypoint(self, waypoint%slip_energy*(1 - step), waypoint%contact, before)
         if (before%is_found) width = width + step
         if (.not. before%is_found) before = waypoint
      end if
      rate = 0
      if (.not. width > 0) return
      ! a contact that ends as a point falls to nothing
      rate = fall_to_nothing
      if (waypoint%friction_radius > 0) rate = ((after%friction_radius - before%friction_radius)/waypoint%friction_radius)/width
   end function radius_rate

   !> A quantity less the given value, or its rate, and the slope of that. Beyond the last contact both are as if the
   !> root had been passed.
   pure subroutine evaluate(self, x, value, slope)
      !> The path; its `quantity`, `given` and `is_rate` say what is evaluated.
      class(peeling_path_t), intent(in) :: self
      !> Position z = sqrt(g) on the path, > 0.
      real(dp), intent(in) :: x
      !> Quantity less its given value, or the rate of the quantity.
      real(dp), intent(out) :: value
      !> Derivative of the value by z.
      real(dp), intent(out) :: slope
      type(peeling_waypoint_t) :: waypoint, near
      real(dp) :: quantity

      call get_waypoint(self, x**2, self%start%contact, waypoint)
      value = merge(-1, 1, self%is_rate)
      slope = 0
      if (.not. waypoint%is_found) return
      if (self%is_rate) then
         value = rate_of(self, self%quantity, waypoint, fine_step, .true.)
         call get_waypoint(self, (x*(1 - rate_step))**2, waypoint%contact, near)
         slope = (value - rate_of(self, self%quantity, near, fine_step, .true.))/(x*rate_step)
      else
         quantity = quantity_of(self, self%quantity, waypoint)
         value = quantity - self%given
         slope = 2*quantity*rate_of(self, self%quantity, waypoint, coarse_step, .false.)/x
      end if
   end subroutine evaluate

end module adfric_round_sphere_peeling_path
