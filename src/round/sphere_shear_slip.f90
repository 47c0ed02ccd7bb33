! SPDX-License-Identifier: GPL-3.0-or-later
!> A sphere that resists shear by tau0 + alpha p: the force at which it slides, and partial slip below it, reduced.
!>
!> The radius e that sticks is that of a paraboloid (`adfric_round_shear`, in units of E* = R = 1, where stresses and forces are 2/3
!> and 4/3 of those of J 2.11).
!>
!> The slip at the edge is that of the punches of radius x between e and b, each of which slips as a whole, mean around the edge and
!> the part that goes around with cos 2t (J 3.6, 3.7 for a uniform stress):
!>
!>     s = (2 m/pi) int arccos(x/b) dv,   (2 m/pi) nu/(2 - nu) int (x/b) sqrt(1 - x^2/b^2) dv,   e < x < b
module adfric_round_sphere_shear_slip
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_round_contact_state, only: contact_t
   use adfric_round_power_shape, only: new_power_shape, power_shape_t
   use adfric_round_shear, only: find_position
   use adfric_round_shear_sums, only: sliding_force, stress_in_stick, sum_displacement, sum_force, uniform_force
   use adfric_round_sheared_contact, only: new_sheared, resistance_t, sheared_t
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   use adfric_round_sphere_contact, only: sphere_contact_t, theory_t
   use adfric_round_sphere_dmt, only: dmt_t
   use adfric_round_sphere_jkr, only: jkr_t
   use adfric_round_slip_annulus, only: slip_of_angle
   use adfric_round_sphere_path, only: slip_factor, take_contact
   implicit none (type, external)
   private
   public :: sheared_sphere_t, sphere_slip_t, new_sheared_sphere, find_slip, shear_stress_of

   !> Units of stresses and forces here, E* = R = 1, in those of J 2.11.
   real(dp), parameter :: stress_unit = 2.0_dp/3, force_unit = 4.0_dp/3
   !> Up to this angle at the edge the root of the adhesion zone counts; the longest panel of a logarithm.
   real(dp), parameter :: near_edge = 0.5_dp, longest = 2.0_dp

   !> A contact that resists shear.
   type, extends(sheared_t) :: sheared_sphere_t
      !> Shear strength, Poisson's ratio, and m.
      real(dp) :: strength = 0, poisson = 0, compliance = 1
      !> Is there a force of sliding? In JKR the infinite tension at the edge may take more than all of it.
      logical :: has_force = .true.
      !> Force of sliding and displacement at its onset, in the units of J 2.11.
      real(dp) :: largest_force = 0, largest_displacement = 0
   end type sheared_sphere_t

   !> Its slip, in the units of J 2.11.
   type :: sphere_slip_t
      !> Was it found to round-off?
      logical :: is_converged = .true.
      !> e and e/b.
      real(dp) :: radius = 0, gamma = 1
      !> Force and displacement.
      real(dp) :: force = 0, displacement = 0
      !> Slip at the edge, mean around it and largest.
      real(dp) :: slip = 0, largest_slip = 0
   end type sphere_slip_t

contains

   !> A contact that resists shear.
   pure subroutine new_sheared_sphere(self, theory, contact, strength, factor, edge_fraction, poisson)
      type(sheared_sphere_t), intent(out) :: self
      !> The theory that has found it, with its X.
      class(theory_t), intent(in) :: theory
      !> The contact, of a radius > 0.
      type(sphere_contact_t), intent(in) :: contact
      !> Shear strength tau0, reduced (J 2.11).
      real(dp), intent(in) :: strength
      !> alpha.
      real(dp), intent(in) :: factor
      !> x of the radius b = a + x (c - a).
      real(dp), intent(in) :: edge_fraction
      !> Poisson's ratio.
      real(dp), intent(in) :: poisson
      type(power_shape_t) :: shape
      type(contact_t) :: paraboloid
      real(dp) :: carried, slope

      carried = contact%load
      select type (theory)
      class is (dmt_t)
         carried = carried + theory%pull()
      end select
      call new_power_shape(shape, [2.0_dp], [1.0_dp])
      call take_contact(theory, contact, paraboloid)
      paraboloid%u = contact%radius
      call shape%evaluate(paraboloid%u, .true., paraboloid%spot)
      self%strength = stress_unit*strength
      call new_sheared(shape, resistance_t(self%strength, factor, edge_fraction), paraboloid, self%sheared_t)
      self%poisson = poisson
      self%compliance = slip_factor(poisson)/2
      self%largest_force = sliding_force(self, self%strength, force_unit*carried)/force_unit
      select type (theory)
      type is (jkr_t)
         self%has_force = self%largest_force >= 0
      end select
      self%largest_force = max(self%largest_force, 0.0_dp)
      call sum_displacement(self, self%a**2, self%a**2, self%largest_displacement, slope)
      self%largest_displacement = self%compliance*self%largest_displacement
   end subroutine new_sheared_sphere

   !> The slip under a force, or of a displacement.
   pure subroutine find_slip(self, value, is_of_force, slip)
      type(sheared_sphere_t), intent(in) :: self
      !> T or displacement, from 0 to that of the onset of sliding, reduced (J 2.11).
      real(dp), intent(in) :: value
      !> Is it T?
      logical, intent(in) :: is_of_force
      type(sphere_slip_t), intent(out) :: slip
      real(dp) :: unit, total, x, remaining, square
      integer :: number

      slip%radius = self%b
      if (value > 0) then
         unit = merge(force_unit, 1/self%compliance, is_of_force)
         total = unit*merge(self%largest_force, self%largest_displacement, is_of_force)
         call find_position(self%sheared_t, unit*value, is_of_force, total, number, x, remaining, slip%is_converged)
         if (self%ranges(number)%is_beside) then
            slip%radius = self%b*cos(x)
            call describe(self, x, 0.0_dp, slip)
         else
            slip%radius = self%a - x
            if (remaining > 0) slip%radius = remaining
            square = x*(2*self%a - x)
            call describe(self, atan2(sqrt(self%zone + square), slip%radius), square, slip)
         end if
      end if
      if (is_of_force) slip%force = value
      if (.not. is_of_force) slip%displacement = value
   end subroutine find_slip

   !> What follows from the position: force, displacement and slip.
   pure subroutine describe(self, angle, square, slip)
      type(sheared_sphere_t), intent(in) :: self
      !> arccos(e/b).
      real(dp), intent(in) :: angle
      !> a^2 - e^2; 0 beside the contact.
      real(dp), intent(in) :: square
      !> In: with e. Out: with all but what was given.
      type(sphere_slip_t), intent(inout) :: slip
      real(dp) :: around, parts(2), rate

      associate (e => slip%radius)
         slip%gamma = min(e/self%b, 1.0_dp)
         around = 2*self%uniform*self%b*2*sin(angle/2)**2*(1 + slip%gamma*(1 + slip%gamma))/3
         slip%slip = 2*self%uniform*self%b*slip_of_angle(angle)
         if (square > 0) then
            call sum_displacement(self, square, square, slip%displacement, rate)
            slip%force = sum_force(self, e, square, force_unit*cube_difference(self%a, e, square))
            parts = edge_integrals(self, e, square)
            slip%slip = slip%slip + self%factor*parts(1)
            around = around + self%factor*parts(2)
         else
            slip%displacement = 2*self%uniform*self%b*sin(angle)
            slip%force = uniform_force(self, e, self%b*sin(angle))
         end if
      end associate
      slip%force = slip%force/force_unit
      slip%displacement = self%compliance*slip%displacement
      slip%slip = 2*self%compliance/pi*slip%slip
      slip%largest_slip = slip%slip + 2*self%compliance/pi*abs(self%poisson)/(2 - self%poisson)*around
   end subroutine describe

   !> a^3 - e^3 from a^2 - e^2.
   pure real(dp) function cube_difference(a, e, square) result(difference)
      real(dp), intent(in) :: a, e
      !> a^2 - e^2.
      real(dp), intent(in) :: square

      difference = square*(a**2 + a*e + e**2)/(a + e)
   end function cube_difference

   !> The integrals of the slip at the edge over the terms of alpha: with x = b cos y, dv/dy = b^2 sin 2y [1 + S/sqrt(z^2 + b^2 sin^2 y)],
   !> z^2 = c^2 - b^2, of y and of sin y cos y. Near the edge y = (z/b) sinh w takes the root, beyond it one panel does.
   pure function edge_integrals(self, e, square) result(parts)
      type(sheared_sphere_t), intent(in) :: self
      !> e, at most a.
      real(dp), intent(in) :: e
      real(dp), intent(in) :: square
      real(dp) :: parts(2), t, zone, first, last, scale, low, high
      integer :: panel, n_panels

      parts = 0
      t = sqrt(self%zone + square)
      zone = sqrt(self%zone)
      first = atan2(zone, self%a)
      last = first + atan2(square*self%b**2, (self%a*e + t*zone)*(self%a*t + e*zone))
      scale = sqrt(max(self%whole_zone - self%zone, 0.0_dp))/self%b
      if (.not. (self%stress > 0 .and. scale > 0 .and. scale < near_edge)) scale = 0
      if (last > near_edge .or. .not. scale > 0) then
         low = first
         if (scale > 0) low = max(first, near_edge)
         parts = panel_integrals(self, low, low, last, 0.0_dp)
         if (low > first) last = low
         if (.not. low > first) return
      end if
      low = asinh(first/scale)
      high = asinh(last/scale)
      n_panels = max(1, ceiling((high - low)/longest))
      do panel = 1, n_panels
         parts = parts + panel_integrals(self, first, low + (high - low)*(panel - 1)/n_panels, low + (high - low)*panel/n_panels, &
            & scale)
      end do
   end function edge_integrals

   !> The integrals over a panel.
   pure function panel_integrals(self, least, low, high, scale) result(parts)
      type(sheared_sphere_t), intent(in) :: self
      !> The least angle, which round-off does not pass.
      real(dp), intent(in) :: least
      !> Ends of the panel: of the angle y, or of w with y = scale sinh w.
      real(dp), intent(in) :: low, high
      !> z/b, or 0 where y is the variable.
      real(dp), intent(in) :: scale
      real(dp) :: parts(2), w, y, weight
      integer :: node

      parts = 0
      do node = 1, size(gauss_nodes)
         w = low + (high - low)*(1 + gauss_nodes(node))/2
         weight = gauss_weights(node)*(high - low)/2
         y = w
         if (scale > 0) then
            y = max(scale*sinh(w), least)
            weight = weight*scale*cosh(w)
         end if
         weight = weight*self%b**2*sin(2*y)
         if (self%stress > 0) weight = weight*(1 + self%stress/sqrt(max(self%whole_zone - self%zone, 0.0_dp) + (self%b*sin(y))**2))
         parts = parts + weight*[y, sin(y)*cos(y)]
      end do
   end function panel_integrals

   !> Shear stress at a distance from the axis, reduced (J 2.11); where JKR's tension passes tau0/alpha there is none.
   elemental real(dp) function shear_stress_of(self, gamma, r, pressure) result(stress)
      type(sheared_sphere_t), intent(in) :: self
      !> e/b.
      real(dp), intent(in) :: gamma
      !> Distance from the axis, reduced, >= 0.
      real(dp), intent(in) :: r
      !> Pressure there, reduced (J 2.11).
      real(dp), intent(in) :: pressure
      real(dp) :: e, stick

      stress = 0
      e = gamma*self%b
      if (r > self%b) return
      if (r >= e) then
         stress = max(self%strength + self%factor*stress_unit*pressure, 0.0_dp)/stress_unit
      else
         stick = 3/pi*sqrt((e - r)*(e + r))
         stress = stress_in_stick(self, e, r, stress_unit*pressure, stress_unit*stick)/stress_unit
      end if
   end function shear_stress_of

end module adfric_round_sphere_shear_slip
