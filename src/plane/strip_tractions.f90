! SPDX-License-Identifier: GPL-3.0-or-later
!> Half-plane under tractions on the strip |x| < a: uniform, and as in Hertz's line contact (plane strain).
!>
!> Reduced: lengths in a, stresses in the traction p0 (pressure, along +y into the solid) or q0 (shear, along +x). Tension is
!> positive. Source: K. L. Johnson, Contact Mechanics, 1985, 2.5 and 4.2 (McEwen), in forms without small differences.
module adfric_plane_strip_tractions
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_numerics_trigonometry, only: angle_minus_sine
   implicit none (type, external)
   private
   public :: uniform_strip_stress, hertz_strip_stress, uniform_strip_integral, hertz_strip_integral, log_ratio

   !> Below this the logarithm of the distances' ratio is found as an inverse hyperbolic tangent.
   real(dp), parameter :: even_distances = 0.5_dp

contains

   !> Stresses [s_xx, s_yy, s_xy] under uniform p and q; NaN at the edges. With the angles phi from the inward normal to the ends of
   !> the strip, alpha their difference and beta their sum, and r1, r2 the distances from x = -1 and x = 1:
   !>
   !>     p: s_xx = -(p/pi)(alpha - sin alpha cos beta), s_yy = -(p/pi)(alpha + sin alpha cos beta),
   !>        s_xy = -(p/pi) sin alpha sin beta
   !>     q: s_xx = -(q/pi)(2 ln(r1/r2) - sin alpha sin beta), s_yy = (q/p) s_xy of p, s_xy = (q/p) s_xx of p
   pure function uniform_strip_stress(p, q, x, y) result(stress)
      !> Pressure on the strip, along +y.
      real(dp), intent(in) :: p
      !> Shear traction on the strip, along +x; in the unit of p.
      real(dp), intent(in) :: q
      !> Coordinates of the position, from the middle of the strip, in half-widths, y >= 0.
      real(dp), intent(in) :: x, y
      real(dp) :: stress(3)
      real(dp) :: r1, r2, alpha, beta, sine, along, across, mixed

      stress = not_a_number()
      r1 = hypot(x + 1, y)
      r2 = hypot(x - 1, y)
      if (.not. min(r1, r2) > 0) return
      alpha = atan2(2*y, y*y + (x - 1)*(x + 1))
      beta = atan2(2*x*y, y*y - (x - 1)*(x + 1))
      sine = 2*(y/r1)/r2
      along = angle_minus_sine(alpha) + 2*sine*sin(beta/2)**2
      across = alpha + sine*cos(beta)
      mixed = sine*sin(beta)
      stress = -[p*along + q*(2*log_ratio(x, y, r1, r2) - mixed), p*across + q*mixed, p*mixed + q*along]/pi
   end function uniform_strip_stress

   !> ln(r1/r2), with the distances r1 and r2 of the position (x, y) from (-1, 0) and (1, 0).
   pure real(dp) function log_ratio(x, y, r1, r2)
      !> Coordinates of the position, from the middle of the strip, in half-widths.
      real(dp), intent(in) :: x, y
      !> Distance of the position from (-1, 0), > 0.
      real(dp), intent(in) :: r1
      !> Distance of the position from (1, 0), > 0.
      real(dp), intent(in) :: r2
      real(dp) :: w

      w = 2*x/(x*x + y*y + 1)
      if (abs(w) < even_distances) then
         log_ratio = atanh(w)
      else
         log_ratio = log(r1/r2)
      end if
   end function log_ratio

   !> Stresses [s_xx, s_yy, s_xy] under p = p0 sqrt(1 - x^2) and q = q0 sqrt(1 - x^2). With m - i n = sqrt(1 - (x + i y)^2),
   !> n of the sign of x, and d = m^2 - y^2 = m^2/(m^2 + x^2), McEwen's formulas (Johnson 4.49, 7.20 ff.) read
   !>
   !>     p: s_xx = -p0 d [m d/(m + y) + 2 n^2]/((m + y)(m^2 + n^2)), s_yy = -p0 m d/(m^2 + n^2), s_xy = -p0 n d/(m^2 + n^2)
   !>     q: s_xx = q0 [2 (n - x) + n d/(m^2 + n^2)], s_yy = (q0/p0) s_xy of p, s_xy = (q0/p0) s_xx of p
   !>
   !> with n - x = -x d/(m (m + y)).
   pure function hertz_strip_stress(p0, q0, x, y) result(stress)
      !> Largest pressure on the strip, along +y.
      real(dp), intent(in) :: p0
      !> Largest shear traction on the strip, along +x; in the unit of p0.
      real(dp), intent(in) :: q0
      !> Coordinates of the position, from the middle of the strip, in half-widths, y >= 0.
      real(dp), intent(in) :: x, y
      real(dp) :: stress(3)
      complex(dp) :: root
      real(dp) :: m, n, d, share, square, along, across, mixed

      root = sqrt(cmplx(1 - x, -y, dp)*cmplx(1 + x, y, dp))
      m = abs(real(root))
      n = sign(abs(aimag(root)), x)
      square = m*m + n*n
      stress = [-2*q0*x, 0.0_dp, 0.0_dp]
      if (.not. square > 0) return
      d = m*m/(m*m + x*x)
      ! m/(m + y), which on the free surface, where m = y = 0, is the limit from inside
      if (m > 0) then
         share = m/(m + y)
      else
         share = abs(x)/(abs(x) + abs(n))
      end if
      along = share*m/(m*m + x*x)*(share*d + 2*n*n)/square
      across = m*d/square
      mixed = n*d/square
      stress = -[p0*along + q0*(2*x*share/(m*m + x*x) - mixed), p0*across + q0*mixed, p0*mixed + q0*along]
   end function hertz_strip_stress

   !> int p(s)/(x - s) ds over the strip for p = 1, principal value: ln |(1 + x)/(1 - x)|; NaN at the edges.
   elemental real(dp) function uniform_strip_integral(x)
      !> Coordinate on the surface, from the middle of the strip, in half-widths.
      real(dp), intent(in) :: x

      uniform_strip_integral = not_a_number()
      if (.not. abs(abs(x) - 1) > 0) return
      uniform_strip_integral = log_ratio(x, 0.0_dp, abs(1 + x), abs(1 - x))
   end function uniform_strip_integral

   !> The same integral for p = sqrt(1 - x^2): pi x inside, pi (x - sgn(x) sqrt(x^2 - 1)) outside.
   elemental real(dp) function hertz_strip_integral(x)
      !> Coordinate on the surface, from the middle of the strip, in half-widths.
      real(dp), intent(in) :: x

      if (abs(x) <= 1) then
         hertz_strip_integral = pi*x
      else
         hertz_strip_integral = sign(pi/(abs(x) + sqrt((abs(x) - 1)*(abs(x) + 1))), x)
      end if
   end function hertz_strip_integral

end module adfric_plane_strip_tractions
