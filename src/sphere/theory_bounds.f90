!> By how much JKR and DMT can differ from Maugis-Dugdale at one radius of contact: inequalities, not estimates.
!>
!> With X = 1 (other X by the scaling a -> X^(1/3) a, lambda -> X^(2/3) lambda, P -> X P, delta -> X^(2/3) delta) adhesion
!> pulls with p = lambda c^2 (sin th cos th + th), where A c^2 + B c = 1 (see `dugdale_curve`).
!>
!> JKR, small th: f <= 4 th^3/3, th^2 (1 - th^2/4)/2 <= k <= th^2/2 and 2 th - 2 th^3/3 <= sin th cos th + th <= 2 th
!> bound th from both sides by t, t^2 = 3/(2 a lambda^2), so that for t^2 <= 1/10 p is sqrt(6 a^3) (1 + r) and what
!> adhesion adds to the approach is (2/3) sqrt(6 a) (1 + r), with |r| <= 2 t^2 + 0.74 sqrt(a)/lambda^2; c/a - 1 <= 0.6 t^2.
!>
!> DMT, th near pi/2: p = 2 (1 - B c)(1 + q), q = (sin th cos th + th)/f - 1, and A <= pi lambda/4 bounds c from below,
!> which bounds cos th = a/c from above and f from below, which bounds c from above.
module adfric_sphere_theory_bounds
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_sphere_contact, only: theory_jkr, theory_dmt
   use adfric_sphere_dugdale_curve, only: get_disc_radius
   implicit none (type, external)
   private
   public :: get_theory_bounds

   !> Largest t^2 for which JKR is bounded, and largest cos th for which DMT is.
   real(dp), parameter :: largest_square = 0.1_dp, largest_cosine = 0.5_dp

contains

   !> Bounds of the differences of load and approach at a radius.
   elemental subroutine get_theory_bounds(theory, lambda, ratio, radius, load, approach, edge)
      !> `theory_jkr` or `theory_dmt`.
      integer, intent(in) :: theory
      !> > 0.
      real(dp), intent(in) :: lambda, ratio, radius
      !> Huge where nothing is proved.
      real(dp), intent(out) :: load, approach
      !> Bound of c/a - 1, which is 0 in JKR; DMT knows nothing of c.
      real(dp), intent(out), optional :: edge
      real(dp) :: scale

      load = huge(1.0_dp)
      approach = huge(1.0_dp)
      if (present(edge)) edge = huge(1.0_dp)
      scale = ratio**(1.0_dp/3)
      if (.not. scale > 0) return
      select case (theory)
      case (theory_jkr)
         call bound_jkr(scale**2*lambda, radius/scale, load, approach)
      case (theory_dmt)
         call bound_dmt(scale**2*lambda, radius/scale, load, approach)
      end select
      if (load < huge(load)) then
         load = ratio*load
         if (present(edge) .and. theory == theory_jkr) edge = 0.6_dp*1.5_dp/(ratio*radius*lambda**2)
      end if
      if (approach < huge(approach)) approach = scale**2*approach
   end subroutine get_theory_bounds

   !> JKR, X = 1.
   elemental subroutine bound_jkr(lambda, radius, load, approach)
      real(dp), intent(in) :: lambda, radius
      real(dp), intent(inout) :: load, approach
      real(dp) :: square, share

      square = 1.5_dp/(radius*lambda**2)
      if (.not. square <= largest_square) return
      share = 2*square + 0.74_dp*sqrt(radius)/lambda**2
      load = share*sqrt(6*radius**3)
      approach = share*2*sqrt(6*radius)/3
   end subroutine bound_jkr

   !> DMT, X = 1.
   elemental subroutine bound_dmt(lambda, radius, load, approach)
      real(dp), intent(in) :: lambda, radius
      real(dp), intent(inout) :: load, approach
      real(dp) :: cosine, angle, f, largest, bc, q

      ! c is least where f and k are largest, at th = pi/2
      cosine = radius/get_disc_radius(lambda, 1.0_dp)
      if (.not. cosine <= largest_cosine) return
      angle = asin(cosine)
      f = (sin(2*angle) + (pi - 2*angle)*cos(2*angle))/2
      largest = sqrt(2/(lambda*f))
      bc = 4*lambda**2*(pi/2 - 1)*largest/3
      q = (pi - 2*angle)*cosine**2/f
      load = 2*(bc + q + bc*q)
      approach = 4*lambda*largest/3
   end subroutine bound_dmt

end module adfric_sphere_theory_bounds
