! SPDX-License-Identifier: GPL-3.0-or-later
!> What a zone of adhesion a < r < c of a stress S adds to the gap beside a contact, (4 S/pi) g, and what a disc of it takes away where
!> nothing touches, (4 S/pi) I of a = 0:
!>
!>     g = s0 arccos(a/r) - I,  I = int sqrt((c^2 - x^2)/(r^2 - x^2)) dx,  a < x < min(r, c),  s0 = sqrt(c^2 - a^2)
!>
!> With x = r cos psi, e^2 = r^2 - a^2, a = r cos beta = c cos th, rho = e^2/s0^2 and kappa = |1 - rho|/max(1, rho), I has Carlson's
!> closed forms:
!>
!>     r < c:  I/s0 = kappa sin beta [R_F(q) + (rho/3) R_D(q)],  q = (kappa cos^2 beta, 1, kappa)
!>     r > c:  I/s0 = (kappa/3) sin th/sqrt(rho) R_D(kappa cos^2 th, 1, kappa)
module adfric_round_dugdale_gap
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, half_pi
   use adfric_numerics_elliptic, only: carlson_d, carlson_f
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   implicit none (type, external)
   private
   public :: zone_gap, disc_gap

   !> Below this share e^2/s0^2 the opening by tension is a small difference, of a function smooth enough for Gauss's rule.
   real(dp), parameter :: near_contact = 0.5_dp

contains

   !> What a zone of adhesion adds to the gap.
   pure real(dp) function zone_gap(stress, a, width, r) result(gap)
      !> Stress S, reduced, > 0.
      real(dp), intent(in) :: stress
      !> Radius of contact, >= 0, and s0, > 0, which has more digits than c.
      real(dp), intent(in) :: a, width
      !> Distance from the axis, > a.
      real(dp), intent(in) :: r
      real(dp) :: e

      e = sqrt((r - a)*(r + a))
      gap = 4*stress/pi*width*opening(a, width, e, atan2(e, a))
   end function zone_gap

   !> What a disc of adhesion takes from the gap.
   pure real(dp) function disc_gap(stress, c, r) result(gap)
      real(dp), intent(in) :: stress
      !> Radius of the disc, > 0.
      real(dp), intent(in) :: c
      !> Distance from the axis, >= 0.
      real(dp), intent(in) :: r

      gap = half_pi
      if (r > 0) gap = half_pi - opening(0.0_dp, c, r, half_pi)
      gap = 4*stress/pi*c*gap
   end function disc_gap

   !> g/s0.
   pure real(dp) function opening(a, s0, e, beta)
      !> Radius a of the contact, reduced, >= 0.
      real(dp), intent(in) :: a
      !> sqrt(c^2 - a^2) of the radii of contact and adhesion, reduced, > 0.
      real(dp), intent(in) :: s0
      !> sqrt(r^2 - a^2) at a distance r from the axis, reduced, > 0.
      real(dp), intent(in) :: e
      !> Angle with cos beta = a/r [rad], > 0, up to pi/2.
      real(dp), intent(in) :: beta
      real(dp) :: rho, kappa, q, c

      rho = (e/s0)**2
      if (rho < near_contact) then
         opening = opening_near_contact(rho, beta)
      else if (rho < 1) then
         kappa = (s0 - e)*(s0 + e)/s0**2
         q = kappa*cos_squared(a, e)
         opening = beta - kappa*sin(beta)*(carlson_f(q, 1.0_dp, kappa) + rho*carlson_d(q, 1.0_dp, kappa)/3)
      else if (rho > 1) then
         c = sqrt(a**2 + s0**2)
         kappa = (e - s0)*(e + s0)/e**2
         opening = beta - kappa*(s0/c)*(s0/e)*carlson_d(kappa*cos_squared(a, s0), 1.0_dp, kappa)/3
      else
         ! r = c, where I = c - a
         opening = beta - s0/(sqrt(a**2 + s0**2) + a)
      end if
   end function opening

   !> The same for small rho:
   !>
   !>     g/s0 = int_0^beta y/(1 + sqrt(1 - y)) d psi,  y = rho (1 - sin^2 psi/sin^2 beta)
   pure real(dp) function opening_near_contact(rho, beta) result(opening)
      !> Share e^2/s0^2 [-], >= 0, up to `near_contact`.
      real(dp), intent(in) :: rho
      real(dp), intent(in) :: beta
      real(dp) :: psi(size(gauss_nodes)), y(size(gauss_nodes))

      psi = (1 + gauss_nodes)*beta/2
      y = rho*sin(beta - psi)*sin(beta + psi)/sin(beta)**2
      opening = sum(gauss_weights*y/(1 + sqrt(1 - y)))*beta/2
   end function opening_near_contact

   !> a^2/(a^2 + e^2).
   elemental real(dp) function cos_squared(a, e)
      !> Legs of a right triangle, >= 0; the angle lies between `a` and the hypotenuse.
      real(dp), intent(in) :: a, e

      cos_squared = a**2/(a**2 + e**2)
   end function cos_squared

end module adfric_round_dugdale_gap
