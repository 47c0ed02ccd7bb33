! SPDX-License-Identifier: GPL-3.0-or-later
!> Pressure and gap around the axis of a contact, for every theory.
!>
!> Reduced variables (see `sphere_contact`): radii in (3 pi w R^2/4E*)^(1/3), gaps in (9 pi^2 w^2 R/16E*^2)^(1/3), the unit
!> of the approach, and pressures in (2 pi w E*^2/9R)^(1/3). In that unit Dugdale's stress sigma0 is lambda, and
!>
!>     P = pi int p r dr,  h = r^2/2 - delta + (8/3 pi) int_0^r F(t)/sqrt(r^2 - t^2) dt,  F = int_t^inf p s/sqrt(s^2 - t^2) ds
!>
!> Compression is positive. With a = r cos beta, e^2 = r^2 - a^2, s0^2 = c^2 - a^2 and Hertz's part
!>
!>     p_H = (3/pi) sqrt(a^2 - r^2),                  h_H = (r^2/pi)(sin beta cos beta - beta cos 2 beta)
!>
!> theory by theory:
!>
!> - Hertz: p_H and h_H.
!> - DMT: p_H and h_H. The adhesion of this theory is a force from outside the contact that does not deform; it is no part
!>   of the pressure, whose integral is P + 2 X.
!> - JKR: p_H - sqrt(6 X a)/(pi sqrt(a^2 - r^2)), h_H + (4/3 pi) sqrt(6 X a) beta. At r = a there is no pressure: it falls
!>   to minus infinity on one side and is 0 on the other, so that the value there is NaN.
!> - Maugis-Dugdale: p_H - (2/pi) X lambda arctan(s0/sqrt(a^2 - r^2)) for r < a, which is J 2.12 with the arc cosine of a
!>   number near 1 rewritten, -X lambda for a <= r <= c, 0 beyond; h_H + (8/3 pi) X lambda g, see `opening`. Without contact
!>   (a = 0) the gap at the axis, which is 2/(pi lambda) less the rise from there to r = c, is added.
!>
!> Bodies apart (a = c = 0) have no pressure, and the gap r^2/2 - delta.
module adfric_round_sphere_profiles
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_numerics_elliptic, only: carlson_d, carlson_f
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   use adfric_numerics_trigonometry, only: sinc_minus_cos
   use adfric_round_sphere_contact, only: sphere_contact_t, theory_t
   use adfric_round_sphere_dmt, only: dmt_t
   use adfric_round_sphere_hertz, only: hertz_t
   use adfric_round_sphere_jkr, only: jkr_t
   use adfric_round_sphere_maugis_dugdale, only: maugis_t
   implicit none (type, external)
   private
   public :: contact_profile_t, new_profile

   !> Below this angle Hertz's gap is a small difference.
   real(dp), parameter :: narrow = 0.5_dp
   !> Below this share e^2/s0^2 the opening by tension is a small difference, of a function smooth enough for Gauss's rule.
   real(dp), parameter :: near_contact = 0.5_dp

   !> Pressure and gap of a contact.
   type :: contact_profile_t
      private
      !> Is there a contact, or a state of attraction? Otherwise all values are NaN.
      logical :: is_found = .false.
      !> Radii a, c and s0 = sqrt(c^2 - a^2).
      real(dp) :: radius = 0, adhesion_radius = 0, width = 0
      !> Tension X lambda of Dugdale's law; 0 in the other theories.
      real(dp) :: tension = 0
      !> sqrt(6 X a) of JKR; 0 in the other theories.
      real(dp) :: singularity = 0
      !> Gap at the axis.
      real(dp) :: least_gap = 0
   contains
      procedure :: pressure
      procedure :: gap
   end type contact_profile_t

contains

   !> Profile of a contact that a theory has found.
   pure subroutine new_profile(self, theory, contact)
      !> Receives all that pressure and gap need.
      type(contact_profile_t), intent(out) :: self
      !> Theory that has found the contact, one of the four.
      class(theory_t), intent(in) :: theory
      !> The contact as the theory gives it; where it is not found all values of the profile are NaN.
      type(sphere_contact_t), intent(in) :: contact

      self%is_found = contact%is_found
      self%radius = contact%radius
      self%adhesion_radius = contact%adhesion_radius
      select type (theory)
      type is (hertz_t)
      type is (dmt_t)
      type is (jkr_t)
         self%singularity = sqrt(6*theory%ratio*contact%radius)
      type is (maugis_t)
         self%tension = theory%ratio*theory%lambda
         if (contact%radius > 0) then
            ! the position is ln(s0/a); the difference of c and a has lost its digits where lambda is large
            self%width = contact%radius*exp(contact%position)
         else
            self%width = contact%adhesion_radius
            self%least_gap = axial_gap(theory%lambda, self%tension, contact%adhesion_radius)
            ! beyond the range of adhesion nothing pulls
            if (-contact%approach > self%least_gap .and. .not. contact%adhesion_radius > 0) self%tension = 0
         end if
      class default
         self%is_found = .false.
      end select
      if (.not. max(contact%radius, contact%adhesion_radius) > 0) self%least_gap = max(self%least_gap, -contact%approach)
   end subroutine new_profile

   !> Pressure at a distance r >= 0 from the axis; at r = c that of the inner side. NaN for JKR at r = a.
   elemental real(dp) function pressure(self, r)
      !> The profile of a contact; where that is not found the pressure is NaN.
      class(contact_profile_t), intent(in) :: self
      !> Distance from the axis, reduced; the pressure is NaN below 0.
      real(dp), intent(in) :: r
      real(dp) :: root

      if (.not. (self%is_found .and. r >= 0)) then
         pressure = not_a_number()
      else if (r < self%radius) then
         root = sqrt((self%radius - r)*(self%radius + r))
         pressure = (3*root - self%singularity/root - 2*self%tension*atan2(self%width, root))/pi
      else if (self%singularity > 0 .and. .not. r > self%radius) then
         pressure = not_a_number()
      else if (r <= self%adhesion_radius) then
         pressure = -self%tension
      else
         pressure = 0
      end if
   end function pressure

   !> Gap at a distance r >= 0 from the axis; 0 in contact.
   elemental real(dp) function gap(self, r)
      !> The profile of a contact; where that is not found the gap is NaN.
      class(contact_profile_t), intent(in) :: self
      !> Distance from the axis, reduced; the gap is NaN below 0.
      real(dp), intent(in) :: r
      real(dp) :: e, beta, f

      if (.not. (self%is_found .and. r >= 0)) then
         gap = not_a_number()
         return
      end if
      gap = self%least_gap
      if (r <= self%radius) return
      e = sqrt((r - self%radius)*(r + self%radius))
      beta = atan2(e, self%radius)
      if (beta < narrow) then
         f = beta*sinc_minus_cos(2*beta)
      else
         f = (self%radius*e + (e - self%radius)*(e + self%radius)*beta)/r**2
      end if
      gap = gap + r**2*f/pi + 4*self%singularity*beta/(3*pi)
      if (self%tension > 0 .and. self%width > 0) &
         & gap = gap + 8*self%tension*self%width*opening(self%radius, self%width, e, beta)/(3*pi)
   end function gap

   !> Opening by unit tension on a < r < c: g/s0, where
   !>
   !>     g = s0 beta - I,  I = int_a^min(r,c) sqrt((c^2 - x^2)/(r^2 - x^2)) dx
   !>
   !> With x = r cos psi, rho = e^2/s0^2 and kappa = |1 - rho|/max(1, rho), for r < c
   !>
   !>     I/s0 = kappa sin beta [R_F(q) + (rho/3) R_D(q)],  q = (kappa cos^2 beta, 1, kappa)
   !>
   !> and for r > c, with a = c cos th: I/s0 = (kappa/3) sin th/sqrt(rho) R_D(kappa cos^2 th, 1, kappa).
   elemental real(dp) function opening(a, s0, e, beta)
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
      !> Angle with cos beta = a/r [rad], > 0, up to pi/2.
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

   !> Gap at the axis of an adhesive disc of radius c without contact: 2/(pi lambda), the range of adhesion, at r = c
   !> less what the gap rises up to there.
   elemental real(dp) function axial_gap(lambda, tension, c)
      !> Maugis's parameter [-], > 0.
      real(dp), intent(in) :: lambda
      !> Tension X lambda of Dugdale's law, reduced, >= 0.
      real(dp), intent(in) :: tension
      !> Radius c of adhesion, reduced, >= 0.
      real(dp), intent(in) :: c

      ! at a = 0 the terms cancel; surfaces do not overlap
      axial_gap = max(0.0_dp, 2/(pi*lambda) - c**2/2 - 8*tension*c*(pi/2 - 1)/(3*pi))
   end function axial_gap

end module adfric_round_sphere_profiles
