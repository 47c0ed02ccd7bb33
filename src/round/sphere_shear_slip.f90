! SPDX-License-Identifier: GPL-3.0-or-later
!> A sphere that resists shear by tau0 + alpha p: the force at which it slides, and partial slip below it, reduced.
!>
!> Force and displacement follow from the radius e that sticks (`adfric_round_shear_sums`, in units of E* = R = 1, where the load
!> without adhesion is 4 a^3/3, its depth a^2, and stresses and forces are 2/3 and 4/3 of those of J 2.11). Both fall with e, so a
!> force or a displacement has one e. Beside the contact, a < e < b, all is that of a uniform stress; in contact the unknown is
!> arccos(e/a), or arcsin(e/a) near sliding, where what the force lacks is compared.
!>
!> The slip at the edge is that of the punches of radius x between e and b, each of which slips as a whole, mean around the edge and
!> the part that goes around with cos 2t (J 3.6, 3.7 for a uniform stress):
!>
!>     s = (2 m/pi) int arccos(x/b) dv,   (2 m/pi) nu/(2 - nu) int (x/b) sqrt(1 - x^2/b^2) dv,   e < x < b
module adfric_round_sphere_shear_slip
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi, pi
   use adfric_round_shear_sums, only: shear_sums_t, set_shear_radii, sliding_force, stress_in_stick, sum_displacement, &
      & sum_force, sum_rest, uniform_force
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   use adfric_numerics_scalar_root, only: equation_t, find_root
   use adfric_round_sphere_contact, only: sphere_contact_t, theory_t
   use adfric_round_sphere_dmt, only: dmt_t
   use adfric_round_sphere_jkr, only: jkr_t
   use adfric_round_sphere_maugis_dugdale, only: maugis_t
   use adfric_round_slip_annulus, only: angle_of_force, gamma_of_force, slip_of_angle
   use adfric_round_sphere_path, only: slip_factor
   implicit none (type, external)
   private
   public :: sheared_sphere_t, sphere_slip_t, new_sheared_sphere, find_slip_of_force, find_slip_of_displacement, shear_stress_of

   !> Units of stresses and forces here, E* = R = 1, in those of J 2.11.
   real(dp), parameter :: stress_unit = 2.0_dp/3, force_unit = 4.0_dp/3
   !> Up to this angle at the edge the root of the adhesion zone counts; the longest panel of a logarithm.
   real(dp), parameter :: near_edge = 0.5_dp, longest = 2.0_dp

   !> A contact that resists shear.
   type, extends(shear_sums_t) :: sheared_sphere_t
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

   !> The logarithm of force or displacement, or of what it lacks to sliding, less that of its target, against the logarithm of the
   !> angle arccos(e/a), or arcsin(e/a).
   type, extends(equation_t) :: slip_equation_t
      !> The contact.
      type(sheared_sphere_t) :: sphere
      !> Is the force compared, or else the displacement? Is it what is lacking?
      logical :: is_of_force = .true., is_of_rest = .false.
      !> The target, in the units of the sums.
      real(dp) :: target = 1
   contains
      procedure :: evaluate
   end type slip_equation_t

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
      real(dp) :: whole_zone, carried, slope

      whole_zone = 0
      carried = contact%load
      select type (theory)
      type is (maugis_t)
         ! the position is ln(s/a), s^2 = c^2 - a^2
         whole_zone = (contact%radius*exp(contact%position))**2
         self%stress = stress_unit*theory%ratio*theory%lambda
      class is (dmt_t)
         carried = carried + theory%pull()
      end select
      call set_shear_radii(self, contact%radius, contact%adhesion_radius, whole_zone, edge_fraction)
      self%strength = stress_unit*strength
      self%factor = factor
      self%uniform = max(self%strength - factor*self%stress, 0.0_dp)
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

   !> The slip under a force.
   pure subroutine find_slip_of_force(self, force, slip)
      type(sheared_sphere_t), intent(in) :: self
      !> T, from 0 to that of sliding, reduced (J 2.11).
      real(dp), intent(in) :: force
      type(sphere_slip_t), intent(out) :: slip
      type(slip_equation_t) :: equation
      real(dp) :: zone, given, beside

      zone = sqrt(self%zone)
      given = force_unit*force
      beside = uniform_force(self, self%a, zone)
      slip%radius = self%b
      if (force > 0) then
         if (given <= beside) then
            given = given/(pi*self%uniform*self%b**2)
            slip%radius = self%b*gamma_of_force(given)
            call describe(self, angle_of_force(given), 0.0_dp, slip)
         else
            equation%sphere = self
            equation%target = given
            call find_in_contact(equation, force_unit*self%largest_force, slip)
         end if
      end if
      slip%force = force
   end subroutine find_slip_of_force

   !> The slip of a displacement.
   pure subroutine find_slip_of_displacement(self, displacement, slip)
      type(sheared_sphere_t), intent(in) :: self
      !> Displacement, from 0 to that of the onset of sliding, reduced (J 2.11).
      real(dp), intent(in) :: displacement
      type(sphere_slip_t), intent(out) :: slip
      type(slip_equation_t) :: equation
      real(dp) :: zone, given

      zone = sqrt(self%zone)
      given = displacement/self%compliance
      slip%radius = self%b
      if (displacement > 0) then
         if (given <= 2*self%uniform*zone) then
            given = given/(2*self%uniform*self%b)
            slip%radius = self%b*sqrt((1 - given)*(1 + given))
            call describe(self, asin(given), 0.0_dp, slip)
         else
            equation%sphere = self
            equation%is_of_force = .false.
            equation%target = given
            call find_in_contact(equation, self%largest_displacement/self%compliance, slip)
         end if
      end if
      slip%displacement = displacement
   end subroutine find_slip_of_displacement

   !> The slip whose position lies in contact. Up to the middle arccos(e/a) is the unknown, beyond it arcsin(e/a).
   pure subroutine find_in_contact(equation, total, slip)
      !> In: contact, kind and target. It serves the search.
      type(slip_equation_t), intent(inout) :: equation
      !> Force or displacement of sliding.
      real(dp), intent(in) :: total
      type(sphere_slip_t), intent(inout) :: slip
      ! logarithm of the smallest angle
      real(dp), parameter :: smallest = -300.0_dp, middle = half_pi/2
      real(dp) :: x, value, slope, angle, square

      call equation%evaluate(log(middle), value, slope)
      equation%is_of_rest = value < 0
      if (equation%is_of_rest) then
         equation%target = total - equation%target
         angle = 0
         if (equation%target > 0) then
            x = log(middle) + min(log(equation%target/total)/2, 0.0_dp)
            call find_root(equation, smallest, log(middle) + 0.01_dp, .true., x, slip%is_converged)
            angle = exp(x)
         end if
         slip%radius = equation%sphere%a*sin(angle)
         square = (equation%sphere%a*cos(angle))**2
      else
         x = log(middle) - value
         call find_root(equation, smallest, log(middle) + 0.01_dp, .true., x, slip%is_converged)
         slip%radius = equation%sphere%a*cos(exp(x))
         square = (equation%sphere%a*sin(exp(x)))**2
      end if
      call describe(equation%sphere, atan2(sqrt(equation%sphere%zone + square), slip%radius), square, slip)
   end subroutine find_in_contact

   !> See `equation_t`.
   pure subroutine evaluate(self, x, value, slope)
      class(slip_equation_t), intent(in) :: self
      !> Logarithm of the angle.
      real(dp), intent(in) :: x
      !> Difference of the logarithms.
      real(dp), intent(out) :: value
      !> Derivative of the value by x.
      real(dp), intent(out) :: slope
      real(dp) :: angle, e, square, size, rate

      angle = exp(x)
      associate (sphere => self%sphere, a => self%sphere%a)
         e = a*merge(sin(angle), cos(angle), self%is_of_rest)
         square = (a*merge(cos(angle), sin(angle), self%is_of_rest))**2
         call sum_displacement(sphere, square, square, size, rate)
         ! dv/dx, and dT = 2 e dv
         slope = (rate + sphere%factor)*a**2*sin(2*angle)*angle
         if (self%is_of_force) slope = 2*e*slope
         if (self%is_of_rest .and. self%is_of_force) then
            size = sum_rest(sphere, e, square, force_unit*e**3)
         else if (self%is_of_force) then
            size = sum_force(sphere, e, square, force_unit*cube_difference(a, e, square))
         else if (self%is_of_rest) then
            size = e**2*(2*sphere%uniform/(sphere%b + sqrt(sphere%zone + square)) + sphere%factor)
            if (sphere%stress > 0) size = size + 2*sphere%factor*sphere%stress*e**2/(sphere%c + sqrt(sphere%whole_zone + square))
         end if
         size = max(size, tiny(size))
         value = log(size/self%target)
         slope = slope/size
      end associate
   end subroutine evaluate

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
      !> a^2 - e^2.
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
