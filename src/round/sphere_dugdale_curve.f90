! SPDX-License-Identifier: GPL-3.0-or-later
!> The curve of all states with contact in Maugis's theory, J 2.12-2.14, 4.8, 4.9, for every lambda and X.
!>
!> With a = c cos th, 0 < th < pi/2,
!>
!>     f = sin th cos th - th cos 2th,  k = th sin th + cos th - 1,  A = lambda f/2,  B = (4/3) X lambda^2 k
!>     c = 2/(B + sqrt(B^2 + 4A)),  P = a^3 - X lambda c^2 (sin th cos th + th),  delta = a^2 - (4/3) X lambda c sin th
!>
!> c is the positive root of A c^2 + B c = 1, which is J 2.12: there is nothing to iterate. The position on the curve is
!> y = ln tan th: it has all digits at both ends, th -> 0 (JKR, large contacts) and th -> pi/2 (DMT, point contact),
!> and radii go like powers of exp y there.
module adfric_round_sphere_dugdale_curve
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_constants, only: pi
   use adfric_numerics_trigonometry, only: sinc_minus_cos
   implicit none (type, external)
   private
   public :: dugdale_point_t, curve_angle_t, get_curve_point, get_angle_point, get_disc_radius, get_disc, guess_position
   public :: farthest, largest_radius

   !> Contacts are looked for up to this reduced radius, and up to this position y towards a = 0; real ones are far from both.
   real(dp), parameter :: largest_radius = 1.0e60_dp, farthest = 150.0_dp
   !> Below this angle the difference in f loses digits.
   real(dp), parameter :: narrow = 0.5_dp

   !> A point of the curve, and its change with the position.
   type :: dugdale_point_t
      !> Radii of contact and adhesion, load, approach.
      real(dp) :: radius = 0, adhesion_radius = 0, load = 0, approach = 0
      !> Derivatives of these four by the position, or by the angle.
      real(dp) :: radius_slope = 0, adhesion_radius_slope = 0, load_slope = 0, approach_slope = 0
   end type dugdale_point_t

   !> An angle of the curve, and what the point there is made of.
   type :: curve_angle_t
      !> th, its sine and cosine.
      real(dp) :: th = 0, sine = 0, cosine = 1
      !> f, k, A, and sqrt(B^2 + 4 A), which is 2 A c + B.
      real(dp) :: f = 0, k = 0, aa = 0, root = 1
   end type curve_angle_t

contains

   !> The point at a position.
   elemental subroutine get_curve_point(lambda, ratio, position, point)
      !> Maugis's parameter [-], > 0.
      real(dp), intent(in) :: lambda
      !> X, the share of adhesion that remains [-], >= 0.
      real(dp), intent(in) :: ratio
      !> Position y = ln tan th on the curve.
      real(dp), intent(in) :: position
      !> Receives radii, load and approach, reduced, and their slopes.
      type(dugdale_point_t), intent(out) :: point
      type(curve_angle_t) :: angle
      real(dp) :: t

      if (has_asserts) call assert(lambda > 0 .and. ratio >= 0, 'get_curve_point: lambda > 0, X >= 0')
      t = exp(position)
      angle%th = atan(t)
      angle%cosine = 1/sqrt(1 + t*t)
      angle%sine = t*angle%cosine
      call get_angle_point(lambda, ratio, (1 - t)*(1 + t)*angle%cosine*angle%cosine, angle, point)
      ! d th/dy = sin th cos th
      associate (p => point, s_c => angle%sine*angle%cosine)
         p%radius_slope = p%radius_slope*s_c
         p%adhesion_radius_slope = p%adhesion_radius_slope*s_c
         p%load_slope = p%load_slope*s_c
         p%approach_slope = p%approach_slope*s_c
      end associate
   end subroutine get_curve_point

   !> The point of an angle, with slopes by the angle: f' = 2 th sin 2th, k' = th cos th.
   elemental subroutine get_angle_point(lambda, ratio, cos_2, angle, point)
      !> Maugis's parameter [-], > 0.
      real(dp), intent(in) :: lambda
      !> X, the share of adhesion that remains [-], >= 0.
      real(dp), intent(in) :: ratio
      !> cos 2th.
      real(dp), intent(in) :: cos_2
      !> In: th, its sine and cosine. Out: with all.
      type(curve_angle_t), intent(inout) :: angle
      !> Receives radii, load and approach, reduced, and their slopes.
      type(dugdale_point_t), intent(out) :: point
      real(dp) :: s_c, bb, c_slope, total, pull

      associate (p => point, th => angle%th, s => angle%sine, c => angle%cosine)
         s_c = s*c
         if (th < narrow) then
            angle%f = th*sinc_minus_cos(2*th)
         else
            angle%f = s_c - th*cos_2
         end if
         angle%k = s*(th - s/(1 + c))
         angle%aa = lambda*angle%f/2
         bb = 4*ratio*lambda**2*angle%k/3
         angle%root = sqrt(bb*bb + 4*angle%aa)
         total = s_c + th
         pull = ratio*lambda
         p%adhesion_radius = 2/(bb + angle%root)
         p%radius = p%adhesion_radius*c
         p%load = p%radius**3 - pull*p%adhesion_radius**2*total
         p%approach = p%radius**2 - 4*pull*p%adhesion_radius*s/3
         c_slope = -p%adhesion_radius*(2*lambda*th*s_c*p%adhesion_radius + 4*ratio*lambda**2*th*c/3)/angle%root
         p%adhesion_radius_slope = c_slope
         p%radius_slope = c_slope*c - p%adhesion_radius*s
         p%load_slope = 3*p%radius**2*p%radius_slope &
            & - 2*pull*(p%adhesion_radius*c_slope*total + p%radius**2)
         p%approach_slope = 2*p%radius*p%radius_slope - 4*pull*(c_slope*s + p%radius)/3
      end associate
   end subroutine get_angle_point

   !> Radius of adhesion at a = 0, where the curve ends.
   elemental real(dp) function get_disc_radius(lambda, ratio) result(radius)
      !> Maugis's parameter [-], > 0.
      real(dp), intent(in) :: lambda
      !> X, the share of adhesion that remains [-], >= 0.
      real(dp), intent(in) :: ratio
      real(dp) :: bb

      if (has_asserts) call assert(lambda > 0 .and. ratio >= 0, 'get_disc_radius: lambda > 0, X >= 0')
      bb = 4*ratio*lambda**2*(pi/2 - 1)/3
      radius = 2/(bb + sqrt(bb*bb + pi*lambda))
   end function get_disc_radius

   !> Load and approach without contact, of an adhesive disc of radius c.
   elemental subroutine get_disc(lambda, ratio, radius, load, approach)
      !> Maugis's parameter [-], > 0.
      real(dp), intent(in) :: lambda
      !> X, the share of adhesion that remains [-], >= 0.
      real(dp), intent(in) :: ratio
      !> Radius c of adhesion, reduced, >= 0.
      real(dp), intent(in) :: radius
      !> Load P of the disc, reduced; tension is negative.
      real(dp), intent(out) :: load
      !> Approach delta of the disc, reduced; separation is negative.
      real(dp), intent(out) :: approach

      if (has_asserts) call assert(lambda > 0 .and. ratio >= 0 .and. radius >= 0, 'get_disc: lambda > 0, X >= 0, radius >= 0')
      load = -pi*ratio*lambda*radius**2/2
      approach = radius**2/2 - 8*ratio*lambda*radius/(3*pi) - 2/(pi*lambda)
   end subroutine get_disc

   !> About where a contact of a radius is, from the leading terms of A c^2 + B c = 1 at both ends.
   elemental real(dp) function guess_position(lambda, ratio, radius) result(position)
      !> Maugis's parameter [-], > 0.
      real(dp), intent(in) :: lambda
      !> X, the share of adhesion that remains [-], >= 0.
      real(dp), intent(in) :: ratio
      !> Radius a of the contact, reduced, > 0.
      real(dp), intent(in) :: radius
      real(dp) :: inverse

      if (has_asserts) call assert(lambda > 0 .and. ratio >= 0 .and. radius > 0, 'guess_place: lambda > 0, X >= 0, radius > 0')
      ! (2/3) lambda th^3 a^2 + (2/3) X lambda^2 th^2 a = 1, by the harmonic sum of what each alone gives
      inverse = (2*lambda*radius**2/3)**(1.0_dp/3) + lambda*sqrt(2*ratio*radius/3)
      if (inverse >= 1) then
         position = -log(inverse)
      else
         position = max(log(get_disc_radius(lambda, ratio)) - log(radius), 0.0_dp)
      end if
   end function guess_position

end module adfric_round_sphere_dugdale_curve
