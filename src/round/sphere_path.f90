! SPDX-License-Identifier: GPL-3.0-or-later
!> The path of a sphere from rest to sliding in the reduced variables of J 2.11: its theory has the contact of each X in closed form,
!> so a given g has one state, with nothing to follow. What is prescribed is a load, an approach or a radius.
module adfric_round_sphere_path
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_interface_interaction, only: adhesion_ratio
   use adfric_numerics_scalar_root, only: equation_t, find_root
   use adfric_round_contact_state, only: contact_t
   use adfric_round_interaction_path, only: begin_path, complete_waypoint, interaction_law_t, interaction_path_t, &
      & steepest, waypoint_t
   use adfric_round_sphere_contact, only: sphere_contact_t, theory_t, control_load, control_approach, control_radius, &
      & branch_stable, find_sphere_contact => find_contact
   use adfric_round_sphere_jkr, only: jkr_t
   use adfric_round_sphere_maugis_dugdale, only: maugis_t
   implicit none (type, external)
   private
   public :: peeling_friction_t, peeling_path_t, new_sphere_path, is_valid_friction, law_of_sphere, slip_factor
   public :: take_contact, sphere_contact_of

   !> The law of friction of a sphere.
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

   !> The path of a sphere.
   type, extends(interaction_path_t) :: peeling_path_t
      !> Theory of adhesion; its X is set at each position.
      class(theory_t), allocatable :: theory
      !> What is prescribed, one of `control_...`, and the branch, one of `branch_...`.
      integer :: control = control_load, branch = branch_stable
      !> The load, approach or radius that is prescribed.
      real(dp) :: prescribed = 0
      !> The contact at rest, from which all others are looked for.
      type(sphere_contact_t) :: rest
   contains
      procedure :: find_contact
      procedure :: find_last
      procedure :: radius_rate
   end type peeling_path_t

   !> The last intimate contact less what is prescribed, as a function of X.
   type, extends(equation_t) :: last_contact_t
      !> Theory of adhesion; its X is set by `evaluate`.
      class(theory_t), allocatable :: theory
      !> What is prescribed: `control_load` or `control_approach`.
      integer :: control = control_load
      !> Load or approach that is prescribed, reduced.
      real(dp) :: prescribed = 0
   contains
      procedure :: evaluate
   end type last_contact_t

   !> Step of ln X for the slope of the last contact.
   real(dp), parameter :: ratio_step = 1.0e-6_dp
   !> Steps of ln g for slopes: the largest, the smallest, and the share of the distance from the end of the path, where b falls by
   !> the root of that distance.
   real(dp), parameter :: fine_step = 1.0e-5_dp, finest_step = 1.0e-10_dp, step_share = 0.125_dp

contains

   !> Are the parameters within their limits?
   elemental logical function is_valid_friction(friction)
      type(peeling_friction_t), intent(in) :: friction

      is_valid_friction = friction%strength > 0 .and. friction%poisson > -1 .and. friction%poisson <= 0.5_dp &
         & .and. friction%edge_fraction >= 0 .and. friction%edge_fraction <= 1 .and. friction%interaction >= 0 &
         & .and. friction%slip_energy_ratio > 0
   end function is_valid_friction

   !> The law as that of an indenter, with the strength in the stresses of E* = R = 1.
   elemental type(interaction_law_t) function law_of_sphere(friction) result(law)
      type(peeling_friction_t), intent(in) :: friction

      law = interaction_law_t(2*friction%strength/3, slip_factor(friction%poisson)/2, friction%edge_fraction, &
         & friction%interaction, friction%slip_energy_ratio)
   end function law_of_sphere

   !> k = (2 - nu)/(1 - nu) (J 3.5), twice the ratio m of the tangential to the normal compliance.
   elemental real(dp) function slip_factor(poisson)
      !> Poisson's ratio nu [-], above -1, up to 1/2.
      real(dp), intent(in) :: poisson

      slip_factor = (2 - poisson)/(1 - poisson)
   end function slip_factor

   !> A path; its start is not found if there is no contact at rest, or if the law of friction is impossible.
   pure subroutine new_sphere_path(self, theory, friction, control, prescribed, branch)
      type(peeling_path_t), intent(out) :: self
      class(theory_t), intent(in) :: theory
      type(peeling_friction_t), intent(in) :: friction
      integer, intent(in) :: control
      real(dp), intent(in) :: prescribed
      !> One of `branch_...`: which state is meant where there are two.
      integer, intent(in) :: branch
      type(contact_t) :: contact
      type(interaction_law_t) :: law

      if (.not. is_valid_friction(friction)) return
      law = law_of_sphere(friction)
      allocate (self%theory, source=theory)
      self%theory%ratio = 1
      self%control = control
      self%prescribed = prescribed
      self%branch = branch
      ! not on the other branch, and not with a radius held, where the reach of adhesion widens
      self%is_shrinking = branch == branch_stable .and. control /= control_radius
      call find_sphere_contact(self%theory, control, prescribed, branch, self%rest)
      call take_contact(self%theory, self%rest, contact)
      ! with the strength in the scale of lambda, 3/2 of this one, T = (pi/2) strength b^2 and K = strength times the scale of u
      call begin_path(self, law, 0.75_dp*pi*law%strength, 3*law%compliance*law%strength**2, law%interaction > 0, contact)
   end subroutine new_sphere_path

   !> A contact of a sphere as one of an indenter, whose stresses are those of E* = R = 1.
   pure subroutine take_contact(theory, sphere, contact)
      class(theory_t), intent(in) :: theory
      type(sphere_contact_t), intent(in) :: sphere
      !> Receives it; the unknown u is the position on the curve.
      type(contact_t), intent(out) :: contact
      ! the reach of a stress of nothing is still that of the gap
      real(dp), parameter :: nothing = 1.0e-30_dp

      contact%is_found = sphere%is_found
      contact%is_converged = sphere%is_converged
      contact%is_stable = sphere%is_stable
      contact%spot%radius = sphere%radius
      contact%adhesion_radius = sphere%adhesion_radius
      contact%load = sphere%load
      contact%approach = sphere%approach
      contact%u = sphere%position
      contact%slopes = sphere%slope
      select type (theory)
      type is (jkr_t)
         contact%neck = 2*sqrt(6*theory%ratio*sphere%radius)/3
      type is (maugis_t)
         contact%stress = 2*max(theory%ratio, nothing)*theory%lambda/3
         ! the position is ln(s/a), s^2 = c^2 - a^2; the difference of c and a has lost its digits where lambda is large
         contact%neck = 2*contact%stress*sphere%adhesion_radius
         if (sphere%radius > 0) contact%neck = 2*contact%stress*sphere%radius*exp(sphere%position)
      end select
   end subroutine take_contact

   !> The contact of a sphere that has become one of an indenter.
   pure type(sphere_contact_t) function sphere_contact_of(contact) result(sphere)
      type(contact_t), intent(in) :: contact

      sphere = sphere_contact_t(contact%is_found, contact%is_converged, contact%is_stable, contact%spot%radius, &
         & contact%adhesion_radius, contact%load, contact%approach, contact%u, contact%slopes(1))
   end function sphere_contact_of

   !> See `interaction_path_t`.
   pure subroutine find_contact(self, ratio, contact)
      class(peeling_path_t), intent(in) :: self
      real(dp), intent(in) :: ratio
      type(contact_t), intent(out) :: contact

      call find_from(self, self%rest, ratio, contact)
   end subroutine find_contact

   !> The contact of an X, looked for from a neighbour.
   pure subroutine find_from(self, neighbour, ratio, contact)
      class(peeling_path_t), intent(in) :: self
      type(sphere_contact_t), intent(in) :: neighbour
      !> X.
      real(dp), intent(in) :: ratio
      type(contact_t), intent(out) :: contact
      class(theory_t), allocatable :: theory
      type(sphere_contact_t) :: sphere

      allocate (theory, source=self%theory)
      theory%ratio = ratio
      sphere = neighbour
      call find_sphere_contact(theory, self%control, self%prescribed, self%branch, sphere)
      call take_contact(theory, sphere, contact)
   end subroutine find_from

   !> See `interaction_path_t`: pull-off, or, where the surfaces part without a jump, the radius 0.
   pure subroutine find_last(self, lost_ratio, ratio, contact, is_converged)
      class(peeling_path_t), intent(inout) :: self
      real(dp), intent(in) :: lost_ratio
      real(dp), intent(out) :: ratio
      type(contact_t), intent(out) :: contact
      logical, intent(out) :: is_converged
      type(last_contact_t) :: equation
      type(sphere_contact_t) :: sphere

      allocate (equation%theory, source=self%theory)
      equation%control = self%control
      equation%prescribed = self%prescribed
      ratio = lost_ratio + (1 - lost_ratio)/2
      call find_root(equation, lost_ratio, 1.0_dp, .false., ratio, is_converged)
      equation%theory%ratio = ratio
      call get_last_contact(equation%theory, self%control, sphere)
      call take_contact(equation%theory, sphere, contact)
   end subroutine find_last

   !> The last intimate contact of a theory.
   pure subroutine get_last_contact(theory, control, contact)
      !> Theory of adhesion, for the X that its `ratio` holds.
      class(theory_t), intent(in) :: theory
      integer, intent(in) :: control
      type(sphere_contact_t), intent(out) :: contact

      call theory%pull_off(control, contact)
      if (.not. contact%radius > 0) call theory%of_radius(0.0_dp, contact)
   end subroutine get_last_contact

   !> The last contact less what is prescribed.
   pure subroutine evaluate(self, x, value, slope)
      class(last_contact_t), intent(in) :: self
      !> X, the share of adhesion that remains [-], > 0.
      real(dp), intent(in) :: x
      !> Load or approach of the last contact less the one that is prescribed, reduced.
      real(dp), intent(out) :: value
      !> Derivative of the value by X, from a difference.
      real(dp), intent(out) :: slope
      class(theory_t), allocatable :: theory
      type(sphere_contact_t) :: here, near

      allocate (theory, source=self%theory)
      theory%ratio = x
      call get_last_contact(theory, self%control, here)
      theory%ratio = x*(1 - ratio_step)
      call get_last_contact(theory, self%control, near)
      if (self%control == control_approach) then
         value = here%approach - self%prescribed
         slope = (here%approach - near%approach)/(x*ratio_step)
      else
         value = here%load - self%prescribed
         slope = (here%load - near%load)/(x*ratio_step)
      end if
   end subroutine evaluate

   !> See `interaction_path_t`: from differences on the sides where there is contact.
   pure real(dp) function radius_rate(self, waypoint) result(rate)
      class(peeling_path_t), intent(in) :: self
      type(waypoint_t), intent(in) :: waypoint
      type(waypoint_t) :: before, after
      real(dp) :: step, width

      step = max(min(fine_step, step_share*(1 - waypoint%slip_energy/self%finish%slip_energy)), finest_step)
      width = 0
      if (waypoint%slip_energy*(1 + step) <= self%limit) call get_beside(self, waypoint, waypoint%slip_energy*(1 + step), after)
      if (after%is_found) width = step
      if (.not. after%is_found) after = waypoint
      call get_beside(self, waypoint, waypoint%slip_energy*(1 - step), before)
      if (before%is_found) width = width + step
      if (.not. before%is_found) before = waypoint
      rate = 0
      if (.not. width > 0) return
      ! a contact that ends as a point falls to nothing
      rate = -steepest
      if (waypoint%radius > 0) rate = ((after%radius - before%radius)/waypoint%radius)/width
   end function radius_rate

   !> The state of a slip energy next to that of a state.
   pure subroutine get_beside(self, neighbour, slip_energy, waypoint)
      class(peeling_path_t), intent(in) :: self
      type(waypoint_t), intent(in) :: neighbour
      !> g.
      real(dp), intent(in) :: slip_energy
      !> Receives the state; not found without intimate contact.
      type(waypoint_t), intent(out) :: waypoint

      waypoint%slip_energy = slip_energy
      waypoint%ratio = adhesion_ratio(slip_energy, self%law%interaction)
      call find_from(self, sphere_contact_of(neighbour%contact), waypoint%ratio, waypoint%contact)
      waypoint%is_found = waypoint%contact%is_found .and. waypoint%contact%spot%radius > 0
      if (waypoint%is_found) call complete_waypoint(self, waypoint)
   end subroutine get_beside

end module adfric_round_sphere_path
