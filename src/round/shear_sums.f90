! SPDX-License-Identifier: GPL-3.0-or-later
!> Sums for a round contact that resists shear by tau0 + alpha p, in sliding and in partial slip, in units of E* = 1.
!>
!> Friction acts on r < b, b = a + x (c - a), x the edge fraction. Maugis's pressure is that of a contact without adhesion and a stress
!> -S on r < c, and of what both leave between them, p + S > 0 for r < a. So the shear stress in sliding is a uniform one,
!> t = tau0 - alpha S, on r < b, and alpha (p + S) on r < a. Each is a punch whose edge slips first: with m the ratio of the tangential
!> to the normal compliance, and e the radius that sticks, the force and the displacement u = m v are
!>
!>     T = 2 t [b^2 arccos(e/b) + e sqrt(b^2 - e^2)] + alpha {P1(a) - P1(e) + 4 S [K(a) - K(e)]}
!>     v = 2 t sqrt(b^2 - e^2) + alpha {g(a) - g(e) + 2 S [sqrt(c^2 - e^2) - sqrt(c^2 - a^2)]}
!>     K(x) = [c^2 arcsin(x/c) - x sqrt(c^2 - x^2)]/2
!>
!> with the terms of alpha for e < a alone. P1 and g, the load and the depth of the profile without adhesion, come from the model.
module adfric_round_shear_sums
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi, pi
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   implicit none (type, external)
   private
   public :: shear_sums_t, set_shear_radii, sliding_force, sum_force, sum_rest, sum_displacement, uniform_force, uniform_rest, &
      & stress_in_stick

   !> A contact that resists shear.
   type :: shear_sums_t
      !> Radii a, b, c; b^2 - a^2, c^2 - a^2.
      real(dp) :: a = 0, b = 0, c = 0, zone = 0, whole_zone = 0
      !> t, alpha, S.
      real(dp) :: uniform = 0, factor = 0, stress = 0
   end type shear_sums_t

contains

   !> The radii, whose differences keep their digits.
   pure subroutine set_shear_radii(self, radius, adhesion_radius, whole_zone, edge_fraction)
      class(shear_sums_t), intent(inout) :: self
      !> a and c; c counts only where there is a zone of adhesion.
      real(dp), intent(in) :: radius, adhesion_radius
      !> c^2 - a^2; 0 without such a zone.
      real(dp), intent(in) :: whole_zone
      !> x.
      real(dp), intent(in) :: edge_fraction
      real(dp) :: width

      self%a = radius
      self%c = radius
      self%whole_zone = whole_zone
      width = 0
      if (whole_zone > 0) then
         self%c = adhesion_radius
         width = edge_fraction*whole_zone/(adhesion_radius + radius)
      end if
      self%b = radius + width
      self%zone = width*(self%a + self%b)
   end subroutine set_shear_radii

   !> The force of sliding: tau0 pi b^2 and alpha times what r < b carries; 0 without contact. Where alpha S <= tau0 it is below
   !> 0 by round-off alone. JKR has no such bound: below 0 there is no friction of this kind.
   pure real(dp) function sliding_force(self, strength, load) result(force)
      class(shear_sums_t), intent(in) :: self
      !> tau0.
      real(dp), intent(in) :: strength
      !> The load, and what adhesion outside the contact adds to it (DMT).
      real(dp), intent(in) :: load

      force = 0
      if (.not. self%b > 0) return
      force = strength*pi*self%b**2 + self%factor*(load + pi*self%stress*(self%whole_zone - self%zone))
   end function sliding_force

   !> T of a position e <= a.
   pure real(dp) function sum_force(self, e, square, load) result(force)
      class(shear_sums_t), intent(in) :: self
      !> The radius e that sticks, and a^2 - e^2.
      real(dp), intent(in) :: e, square
      !> P1(a) - P1(e).
      real(dp), intent(in) :: load

      force = uniform_force(self, e, sqrt(self%zone + square)) &
         & + self%factor*(load + 4*self%stress*segment(self, e, sqrt(self%whole_zone + square), square))
   end function sum_force

   !> What T lacks to sliding at a position e <= a.
   pure real(dp) function sum_rest(self, e, square, load) result(rest)
      class(shear_sums_t), intent(in) :: self
      real(dp), intent(in) :: e, square
      !> P1(e).
      real(dp), intent(in) :: load

      rest = uniform_rest(self, e, sqrt(self%zone + square)) + self%factor*load
      if (self%stress > 0) rest = rest + 2*self%factor*self%stress*core(self%c, e, sqrt(self%whole_zone + square))
   end function sum_rest

   !> v of a position e <= a, and dv/d(e^2), which is below 0.
   pure subroutine sum_displacement(self, square, depth, displacement, slope)
      class(shear_sums_t), intent(in) :: self
      !> a^2 - e^2.
      real(dp), intent(in) :: square
      !> g(a) - g(e).
      real(dp), intent(in) :: depth
      !> Receives v.
      real(dp), intent(out) :: displacement
      !> Receives -dv/d(e^2) of all but the term of g; it has no end at e = b.
      real(dp), intent(out) :: slope
      real(dp) :: t, s

      t = sqrt(self%zone + square)
      displacement = 2*self%uniform*t + self%factor*depth
      slope = 0
      if (t > 0) slope = self%uniform/t
      if (.not. self%stress > 0) return
      s = sqrt(self%whole_zone + square)
      displacement = displacement + 2*self%factor*self%stress*square/(s + sqrt(self%whole_zone))
      slope = slope + self%factor*self%stress/s
   end subroutine sum_displacement

   !> The force of the uniform stress.
   pure real(dp) function uniform_force(self, e, t) result(force)
      class(shear_sums_t), intent(in) :: self
      !> The radius e that sticks, and sqrt(b^2 - e^2).
      real(dp), intent(in) :: e, t

      force = 2*self%uniform*(self%b**2*atan2(t, e) + e*t)
   end function uniform_force

   !> What the force of the uniform stress lacks to sliding.
   pure real(dp) function uniform_rest(self, e, t) result(rest)
      class(shear_sums_t), intent(in) :: self
      real(dp), intent(in) :: e, t

      rest = 2*self%uniform*core(self%b, e, t)
   end function uniform_rest

   !> K(a) - K(e) = c^2 int sin(y)^2 dy between the angles arcsin(x/c): their difference has its own digits.
   pure real(dp) function segment(self, e, s, square)
      class(shear_sums_t), intent(in) :: self
      !> e, at most a.
      real(dp), intent(in) :: e
      !> sqrt(c^2 - e^2).
      real(dp), intent(in) :: s
      real(dp), intent(in) :: square
      real(dp) :: edge, width, cosine, first, unit

      segment = 0
      if (.not. (self%stress > 0 .and. square > 0)) return
      edge = sqrt(self%whole_zone)
      ! a power of two costs no digits, and fourth powers of lengths in its unit stay within the numbers
      unit = scale(1.0_dp, -exponent(self%c))
      cosine = ((edge*unit)*(s*unit) + (self%a*unit)*(e*unit))*((self%a*unit)*(s*unit) + (e*unit)*(edge*unit))
      width = atan2(((square*unit)*unit)*(self%c*unit)**2, cosine)
      first = atan2(e, s)
      segment = self%c**2*sum(gauss_weights*sin(first + width*(1 + gauss_nodes)/2)**2)*width/2
   end function segment

   !> r^2 arcsin(e/r) - e sqrt(r^2 - e^2) = 2 r^2 int sin(y)^2 dy, 0 < y < arcsin(e/r): a small one has its own digits.
   pure real(dp) function core(r, e, s)
      !> r, and e, at most r.
      real(dp), intent(in) :: r, e
      !> sqrt(r^2 - e^2).
      real(dp), intent(in) :: s
      real(dp) :: angle

      angle = atan2(e, s)
      core = 2*r**2*sum(gauss_weights*sin(angle*(1 + gauss_nodes)/2)**2)*angle/2
   end function core

   !> Shear stress at r < e.
   pure real(dp) function stress_in_stick(self, e, r, pressure, stick_pressure) result(stress)
      class(shear_sums_t), intent(in) :: self
      !> The radius e that sticks, at most b, and the distance from the axis.
      real(dp), intent(in) :: e, r
      !> Pressure of the contact there, and of a contact of radius e without adhesion.
      real(dp), intent(in) :: pressure, stick_pressure
      real(dp) :: inner, s

      inner = sqrt((e - r)*(e + r))
      stress = 2/pi*self%uniform*atan2(sqrt(max((self%b - e)*(self%b + e), 0.0_dp)), inner)
      if (.not. (self%factor > 0 .and. e < self%a)) return
      s = sqrt(self%whole_zone + (self%a - e)*(self%a + e))
      stress = stress + self%factor*(pressure - stick_pressure + self%stress*(1 - atan2(inner, s)/half_pi))
   end function stress_in_stick

end module adfric_round_shear_sums
