! SPDX-License-Identifier: GPL-3.0-or-later
!> By how much JKR and DMT can differ from Maugis-Dugdale at one radius of contact: inequalities, not estimates.
!>
!> Adhesion pulls with p = X lambda c^2 (sin th cos th + th), where A c^2 + B c = 1 (see `dugdale_curve`). For X = 1 (other X by
!> the scaling a -> X^(1/3) a, lambda -> X^(2/3) lambda, P -> X P, delta -> X^(2/3) delta):
!>
!> JKR, small th: f <= 4 th^3/3, th^2 (1 - th^2/4)/2 <= k <= th^2/2 and 2 th - 2 th^3/3 <= sin th cos th + th <= 2 th
!> bound th from both sides by t, t^2 = 3/(2 a lambda^2), so that for t^2 <= 1/10 p is sqrt(6 a^3) (1 + r) and what
!> adhesion adds to the approach is (2/3) sqrt(6 a) (1 + r), with |r| <= 2 t^2 + 0.74 sqrt(a)/lambda^2; c/a - 1 <= 0.6 t^2.
!>
!> DMT, th near pi/2: p = 2 (1 - B c)(1 + q), q = (sin th cos th + th)/f - 1 = 2 th u^2/f with u = cos th = a/c. A <= pi lambda/4
!> bounds c from below by c0, its value at a = 0, so that u <= a/c0; th <= pi/2 - u; and for u <= 1/2, where
!> arcsin u <= pi u/3, f >= (pi/2)(1 - 2.2 u^2), which bounds c from above by c1/sqrt(1 - 2.2 u^2), c1^2 = 4/(pi lambda).
module adfric_round_sphere_theory_bounds
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_round_sphere_contact, only: theory_jkr, theory_dmt
   use adfric_round_sphere_dugdale_curve, only: get_disc_radius
   implicit none (type, external)
   private
   public :: limit_t, new_limit

   !> Largest t^2 for which JKR is bounded, and largest u for which DMT is.
   real(dp), parameter :: largest_square = 0.1_dp, largest_cosine = 0.5_dp
   !> pi/2 less f, at most, over (pi/2) u^2.
   real(dp), parameter :: fall = 2.2_dp

   !> A limit theory beside Maugis-Dugdale: what of the bounds does not depend on the radius.
   type :: limit_t
      !> `theory_jkr` or `theory_dmt`; for others nothing is bounded.
      integer :: theory = theory_jkr
      !> X, the share of adhesion that friction leaves.
      real(dp) :: ratio = 1
      !> JKR: t^2 times the radius; DMT: c0.
      real(dp) :: length = 0
      !> JKR: 2 t^2 sqrt(6 X a^3) and 0.74 sqrt(6 X a^3) sqrt(a)/lambda^2 over sqrt(a) and a^2.
      !> DMT: what B c is at c1, and 4 X lambda c1/3.
      real(dp) :: near = 0, far = 0
   contains
      procedure :: get_bounds
   end type limit_t

contains

   !> The bounds of a limit theory.
   elemental subroutine new_limit(self, theory, lambda, ratio)
      !> Receives what of the bounds does not depend on the radius.
      type(limit_t), intent(out) :: self
      !> `theory_jkr` or `theory_dmt`; for others nothing is bounded.
      integer, intent(in) :: theory
      !> Maugis's parameter [-], > 0.
      real(dp), intent(in) :: lambda
      !> X, the share of adhesion that remains [-], > 0.
      real(dp), intent(in) :: ratio
      real(dp) :: widest

      self%theory = theory
      self%ratio = ratio
      select case (theory)
      case (theory_jkr)
         self%length = 1.5_dp/(ratio*lambda**2)
         self%near = 2*self%length*sqrt(6*ratio)
         self%far = 0.74_dp*sqrt(6.0_dp)/(ratio*lambda**2)
      case (theory_dmt)
         self%length = get_disc_radius(lambda, ratio)
         widest = 2/sqrt(pi*lambda)
         self%far = 4*ratio*lambda*widest/3
         self%near = self%far*lambda*(pi/2 - 1)
      end select
   end subroutine new_limit

   !> Bounds of the differences of load and approach at a radius. They grow with the radius, JKR's of the approach where a is
   !> not small.
   elemental subroutine get_bounds(self, radius, load, approach)
      class(limit_t), intent(in) :: self
      !> Radius a of the contact, reduced, > 0.
      real(dp), intent(in) :: radius
      !> Bound of the difference of load, reduced; huge where nothing is proved.
      real(dp), intent(out) :: load
      !> Bound of the difference of approach, reduced; huge where nothing is proved.
      real(dp), intent(out) :: approach
      real(dp) :: root, square, rest, q, bc

      load = huge(1.0_dp)
      approach = huge(1.0_dp)
      if (self%theory == theory_jkr) then
         if (.not. self%length <= largest_square*radius) return
         root = sqrt(radius)
         load = root*(self%near + self%far*radius*root)
         approach = 2*load/(3*radius)
      else if (self%theory == theory_dmt) then
         if (.not. radius <= largest_cosine*self%length) return
         square = (radius/self%length)**2
         rest = 1/(1 - fall*square)
         q = 2*square*(1 - 2*radius/(pi*self%length))*rest
         root = sqrt(rest)
         bc = self%near*root
         load = 2*self%ratio*(bc + q + bc*q)
         approach = self%far*root
      end if
   end subroutine get_bounds

end module adfric_round_sphere_theory_bounds
