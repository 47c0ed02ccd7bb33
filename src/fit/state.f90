! SPDX-License-Identifier: GPL-3.0-or-later
!> States of a smooth sphere along the curve of its theory, with the derivatives that a fit needs.
!>
!> Reduced variables as in `adfric_round_sphere_contact`. A state has a position t on its curve, and each theory its own t:
!>
!> - Maugis-Dugdale: the angle th of `adfric_round_sphere_dugdale_curve`, 0 < th <= pi/2, a = c cos th. With
!>   A = lambda f/2, B = (4/3) lambda^2 k, the radius c is the root of A c^2 + B c = 1, and its derivatives follow from those of that
!>   equation: with den = 2 A c + B
!>       den c_th = -(A_th c^2 + B_th c),   den c_l = -(A_l c^2 + B_l c),
!>       den c_thth = -(A_thth c^2 + 4 A_th c c_th + B_thth c + 2 B_th c_th + 2 A c_th^2),
!>       den c_thl = -(A_thl c^2 + 2 A_th c c_l + 2 A_l c c_th + B_thl c + B_th c_l + B_l c_th + 2 A c_th c_l)
!>   Beyond th = pi/2, without contact, t - pi/2 = 1 - c/c0 with c0 the radius at th = pi/2.
!> - JKR: t = a^(3/2), P = t^2 - sqrt(6) t. DMT and Hertz: t = a.
!>
!> c = a where a theory has no zone of adhesion outside of the contact.
module adfric_fit_state
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, half_pi
   use adfric_numerics_powers, only: cube_root
   use adfric_round_sphere_contact, only: theory_jkr, theory_dmt, theory_maugis_dugdale
   use adfric_round_sphere_dugdale_curve, only: curve_angle_t, dugdale_point_t, get_angle_point, get_disc, &
      & get_disc_radius
   implicit none (type, external)
   private
   public :: fit_state_t, get_state, add_derivatives

   !> A state, and its derivatives: `_t` by the position, `_l` by lambda.
   type :: fit_state_t
      !> The position.
      real(dp) :: t = 0
      !> Radii a and c, and their derivatives.
      real(dp) :: a = 0, a_t = 0, a_tt = 0, a_l = 0, a_tl = 0, c = 0, c_t = 0, c_tt = 0, c_l = 0, c_tl = 0
      !> Load P and its derivatives.
      real(dp) :: p = 0, p_t = 0, p_tt = 0, p_l = 0, p_tl = 0
      !> Approach delta and its derivatives.
      real(dp) :: d = 0, d_t = 0, d_tt = 0, d_l = 0, d_tl = 0
      !> What a state of Maugis-Dugdale is made of.
      type(curve_angle_t) :: angle
   end type fit_state_t

contains

   !> The state at a position: radii, load, approach, and their derivatives by the position. The rest has no meaning.
   pure subroutine get_state(theory, lambda, t, s)
      integer, intent(in) :: theory
      !> Maugis's parameter; without meaning in the other theories.
      real(dp), intent(in) :: lambda
      real(dp), intent(in) :: t
      type(fit_state_t), intent(inout) :: s
      real(dp), parameter :: root6 = sqrt(6.0_dp)
      real(dp) :: root

      s%t = t
      select case (theory)
      case (theory_maugis_dugdale)
         if (t <= half_pi) then
            call get_dugdale(lambda, t, s)
         else
            call get_apart(lambda, t, s)
         end if
         return
      case (theory_jkr)
         root = cube_root(t)
         s%a = root**2
         s%a_t = 2/(3*root)
         s%p = t*(t - root6)
         s%p_t = 2*t - root6
         s%d = root*(t - 2*root6/3)
         s%d_t = 4*root/3 - 2*root6/(9*root**2)
      case default
         s%a = t
         s%a_t = 1
         s%p = t**3
         if (theory == theory_dmt) s%p = s%p - 2
         s%p_t = 3*t**2
         s%d = t**2
         s%d_t = 2*t
      end select
      s%c = s%a
      s%c_t = s%a_t
   end subroutine get_state

   !> Maugis-Dugdale with contact.
   pure subroutine get_dugdale(lambda, th, s)
      real(dp), intent(in) :: lambda, th
      type(fit_state_t), intent(inout) :: s
      type(dugdale_point_t) :: point

      s%angle = curve_angle_t(th, sin(th), cos(th))
      associate (angle => s%angle)
         call get_angle_point(lambda, 1.0_dp, (angle%cosine - angle%sine)*(angle%cosine + angle%sine), angle, point)
      end associate
      s%a = point%radius
      s%a_t = point%radius_slope
      s%c = point%adhesion_radius
      s%c_t = point%adhesion_radius_slope
      s%p = point%load
      s%p_t = point%load_slope
      s%d = point%approach
      s%d_t = point%approach_slope
   end subroutine get_dugdale

   !> Maugis-Dugdale without contact, c = c0 (1 - (t - pi/2)).
   pure subroutine get_apart(lambda, t, s)
      real(dp), intent(in) :: lambda
      !> The position, between pi/2 and pi/2 + 1.
      real(dp), intent(in) :: t
      type(fit_state_t), intent(inout) :: s
      real(dp) :: first

      first = get_disc_radius(lambda, 1.0_dp)
      s%a = 0
      s%a_t = 0
      s%c = first*(1 - (t - half_pi))
      s%c_t = -first
      call get_disc(lambda, 1.0_dp, s%c, s%p, s%d)
      s%p_t = -pi*lambda*s%c*s%c_t
      s%d_t = (s%c - 8*lambda/(3*pi))*s%c_t
   end subroutine get_apart

   !> Add the derivatives by lambda, and the second ones.
   pure subroutine add_derivatives(theory, lambda, s)
      integer, intent(in) :: theory
      real(dp), intent(in) :: lambda
      !> In: from `get_state`. Out: with all derivatives.
      type(fit_state_t), intent(inout) :: s
      real(dp), parameter :: root6 = sqrt(6.0_dp)
      real(dp) :: root

      select case (theory)
      case (theory_maugis_dugdale)
         if (s%t <= half_pi) then
            call add_dugdale(lambda, s)
         else
            call add_apart(lambda, s)
         end if
         return
      case (theory_jkr)
         root = cube_root(s%t)
         s%a_tt = -2/(9*root*s%t)
         s%p_tt = 2
         s%d_tt = 4/(9*root**2) + 4*root6/(27*root**2*s%t)
      case default
         s%a_tt = 0
         s%p_tt = 6*s%t
         s%d_tt = 2
      end select
      s%c_tt = s%a_tt
   end subroutine add_derivatives

   !> The same of Maugis-Dugdale with contact.
   pure subroutine add_dugdale(lambda, s)
      real(dp), intent(in) :: lambda
      !> In: from `get_dugdale`. Out: with all derivatives.
      type(fit_state_t), intent(inout) :: s
      real(dp) :: total, aa_t, aa_tt, bb_t, bb_tt, aa_l, aa_tl, bb_l, bb_tl

      associate (angle => s%angle, th => s%angle%th, sine => s%angle%sine, cosine => s%angle%cosine)
         total = sine*cosine + th
         ! f' = 2 th sin 2th, k' = th cos th
         aa_t = 2*lambda*th*sine*cosine
         aa_tt = lambda*(2*sine*cosine + 2*th*(cosine - sine)*(cosine + sine))
         bb_t = 4*lambda**2*th*cosine/3
         bb_tt = 4*lambda**2*(cosine - th*sine)/3
         aa_l = angle%f/2
         aa_tl = aa_t/lambda
         bb_l = 8*lambda*angle%k/3
         bb_tl = 2*bb_t/lambda
         s%c_l = -(aa_l*s%c + bb_l)*s%c/angle%root
         s%c_tt = -(aa_tt*s%c**2 + 4*aa_t*s%c*s%c_t + bb_tt*s%c + 2*bb_t*s%c_t + 2*angle%aa*s%c_t**2)/angle%root
         s%c_tl = -(aa_tl*s%c**2 + 2*aa_t*s%c*s%c_l + 2*aa_l*s%c*s%c_t + bb_tl*s%c + bb_t*s%c_l + bb_l*s%c_t &
            & + 2*angle%aa*s%c_t*s%c_l)/angle%root
         s%a_l = s%c_l*cosine
         s%a_tt = s%c_tt*cosine - 2*s%c_t*sine - s%a
         s%a_tl = s%c_tl*cosine - s%c_l*sine
         s%p_l = 3*s%a**2*s%a_l - (s%c**2 + 2*lambda*s%c*s%c_l)*total
         s%p_tt = 6*s%a*s%a_t**2 + 3*s%a**2*s%a_tt - lambda*(2*(s%c_t**2 + s%c*s%c_tt)*total &
            & + 8*s%c_t*s%a*cosine - 4*s%c*sine*s%a)
         s%p_tl = 6*s%a*s%a_t*s%a_l + 3*s%a**2*s%a_tl - 2*(s%c*s%c_t*total + s%a**2) &
            & - lambda*(2*(s%c_l*s%c_t + s%c*s%c_tl)*total + 4*s%c_l*s%a*cosine)
         s%d_l = 2*s%a*s%a_l - 4*sine*(s%c + lambda*s%c_l)/3
         s%d_tt = 2*(s%a_t**2 + s%a*s%a_tt) - 4*lambda*(s%c_tt*sine + 2*s%c_t*cosine - s%c*sine)/3
         s%d_tl = 2*(s%a_l*s%a_t + s%a*s%a_tl) - 4*(s%c_t*sine + s%a)/3 - 4*lambda*(s%c_tl*sine + s%c_l*cosine)/3
      end associate
   end subroutine add_dugdale

   !> The same without contact. c0 = 2/(B + sqrt(B^2 + 4 A)) with A = pi lambda/4, B = (4/3)(pi/2 - 1) lambda^2.
   pure subroutine add_apart(lambda, s)
      real(dp), intent(in) :: lambda
      !> In: from `get_apart`. Out: with all derivatives.
      type(fit_state_t), intent(inout) :: s
      real(dp), parameter :: slope = 8*(half_pi - 1)/3
      real(dp) :: first, first_l, den

      first = -s%c_t
      den = sqrt((lambda**2*slope/2)**2 + pi*lambda)
      first_l = -(pi*first/4 + slope*lambda)*first/den
      s%a_tt = 0
      s%a_l = 0
      s%a_tl = 0
      s%c_tt = 0
      s%c_l = s%c*first_l/first
      s%c_tl = -first_l
      s%p_tt = -pi*lambda*s%c_t**2
      s%p_l = -half_pi*s%c**2 - pi*lambda*s%c*s%c_l
      s%p_tl = -pi*s%c*s%c_t - pi*lambda*(s%c_l*s%c_t + s%c*s%c_tl)
      s%d_tt = s%c_t**2
      s%d_l = (s%c - 8*lambda/(3*pi))*s%c_l - 8*s%c/(3*pi) + 2/(pi*lambda**2)
      s%d_tl = (s%c_l - 8/(3*pi))*s%c_t + (s%c - 8*lambda/(3*pi))*s%c_tl
   end subroutine add_apart

end module adfric_fit_state
