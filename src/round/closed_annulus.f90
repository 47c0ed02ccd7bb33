! SPDX-License-Identifier: GPL-3.0-or-later
!> Closed forms of the integrals J and I over an annulus a < x < c (see `adfric_round_annulus`). By parts, with L(t) = t - arctan(t),
!>
!>     J = g(a) L(s/a) + J2,   J2 = int g/sqrt(c^2 - x^2) dx - g(a) s/a,   c dJ/dc = I,   s = sqrt(c^2 - a^2)
!>
!> With th = arctan(s/a), beyond a corner b = 1 v = sqrt(a^2 - 1), V = sqrt(c^2 - 1), t = arctan(s/v), q = arctan(s/(c v)), and for the
!> sphere k = sqrt(1 - c^2), p = arctan(s/(a k)),
!>
!>     sphere             J2 = th - k p                        I = s artanh(a) + c^2 p/k
!>     flat_cone          J2 = c q - t                         I = s arctan(v) + c q
!>     flat_paraboloid    J2 = (V^2 t - s v)/2                 I = s v + c^2 t
!>     rounded_punch      that of flat_paraboloid less that of flat_cone, in J and in I
!>     rounded_cone       flat_cone less flat_paraboloid, and x^2: (c^2 th - a s)/2 and s a + c^2 th
!>
!> A contact on a flat face has v = 0 and g = 0. For r^n, J of x^n is b_n and I n G_n, with b_0 = 0, b_1 = a L(s/a), G_0 = th, G_1 = s,
!>
!>     n b_n = a^n L(s/a) + (n - 1) [c^2 b_(n - 2) + s^2 th a^(n - 2)],    n G_n = s a^(n - 1) + (n - 1) c^2 G_(n - 2)
!>
!> Differences of arctangents are taken as series where the annulus is narrow, and by the theorem of addition where they are close.
module adfric_round_closed_annulus
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi
   implicit none (type, external)
   private
   public :: less_arctan, add_power_annulus, get_sphere_annulus, get_cone_annulus, get_paraboloid_annulus, get_punch_annulus, &
      & get_rounded_cone_annulus

   !> Below this argument differences of arctangents are series of so many terms.
   real(dp), parameter :: small = 0.3_dp
   integer, parameter :: n_terms = 16

contains

   !> v - arctan(v), to its own round-off.
   elemental real(dp) function less_arctan(v)
      !> The number v, >= 0.
      real(dp), intent(in) :: v
      integer :: k

      if (v > small) then
         less_arctan = v - atan(v)
         return
      end if
      less_arctan = 0
      do k = n_terms, 1, -1
         less_arctan = 1.0_dp/(2*k + 1) - v*v*less_arctan
      end do
      less_arctan = v**3*less_arctan
   end function less_arctan

   !> arctan(k s/d) - k arctan(s/d) for k < 1, to its own round-off.
   pure real(dp) function lag(k, rest, s, d)
      !> The factor k, > 0, and 1 - k^2.
      real(dp), intent(in) :: k, rest
      !> The two sides s > 0 and d >= 0.
      real(dp), intent(in) :: s, d
      real(dp) :: square, power, sum_of_powers
      integer :: m

      if (s < small*d) then
         ! k (1 - k^2) t^3 sum of (-t^2)^(m - 1) (1 + k^2 + ... + k^(2 m - 2))/(2 m + 1)
         square = (s/d)**2
         lag = 0
         power = 1
         sum_of_powers = 1
         do m = 1, n_terms
            lag = lag + power*sum_of_powers/(2*m + 1)
            power = -power*square
            sum_of_powers = 1 + k*k*sum_of_powers
         end do
         lag = k*rest*square*(s/d)*lag
      else if (k < 0.5_dp) then
         lag = atan2(k*s, d) - k*atan2(s, d)
      else
         lag = rest/(1 + k)
         lag = lag*atan2(s, d) - atan(s*d*lag/(d*d + k*s*s))
      end if
   end function lag

   !> (x^2 + s^2) arctan(s/x) - s x, to its own round-off.
   pure real(dp) function bulge(s, x)
      !> The two sides s > 0 and x >= 0.
      real(dp), intent(in) :: s, x

      if (s < small*x) then
         bulge = x*x*(s/x)**3 - (x*x + s*s)*less_arctan(s/x)
      else
         bulge = (x*x + s*s)*atan2(s, x) - s*x
      end if
   end function bulge

   !> Add J and I of x^n.
   pure subroutine add_power_annulus(n, factor, a, s, opening, intensity)
      !> The whole exponent, >= 1.
      integer, intent(in) :: n
      !> The factor of x^n.
      real(dp), intent(in) :: factor
      !> Radius of contact, and s; both >= 0, and not both 0.
      real(dp), intent(in) :: a, s
      !> J and I, to which is added.
      real(dp), intent(inout) :: opening, intensity
      real(dp) :: th, part, c_square, power, b, g
      integer :: k

      th = atan2(s, a)
      c_square = a*a + s*s
      ! a^k L(s/a) is part times a^(k - 1)
      part = s
      if (a > 0) part = a*less_arctan(s/a)
      ! power is a^(k - 2) for the k that follows
      b = 0
      g = th
      power = 1
      if (modulo(n, 2) == 1) then
         b = part
         g = s
         power = a
      end if
      do k = 2 + modulo(n, 2), n, 2
         b = (power*a*part + (k - 1)*(c_square*b + s*s*th*power))/k
         g = (s*power*a + (k - 1)*c_square*g)/k
         power = power*a*a
      end do
      opening = opening + factor*b
      intensity = intensity + factor*n*g
   end subroutine add_power_annulus

   !> J and I of a sphere of radius 1.
   pure subroutine get_sphere_annulus(u, a, rest, s, opening, intensity)
      !> artanh(a), the radius a, 1 - a^2, and s > 0 with s^2 < 1 - a^2.
      real(dp), intent(in) :: u, a, rest, s
      !> Receive J and I.
      real(dp), intent(out) :: opening, intensity
      real(dp) :: c_square, k

      c_square = a*a + s*s
      k = sqrt((sqrt(rest) - s)*(sqrt(rest) + s))
      opening = lag(k, c_square, s, a*k)
      if (a > 0) opening = opening + a*u*less_arctan(s/a)
      intensity = s*u + c_square/k*atan2(s, a*k)
   end subroutine get_sphere_annulus

   !> J and I of a cone that begins at a corner of radius 1.
   pure subroutine get_cone_annulus(v, s, opening, intensity)
      !> v, and s > 0; for a contact on the face 0 and V.
      real(dp), intent(in) :: v, s
      !> Receive J and I, without the part of J that g(a) has.
      real(dp), intent(out) :: opening, intensity
      real(dp) :: largest, c

      largest = v*v + s*s
      c = sqrt(1 + largest)
      opening = c*lag(1/c, largest/(c*c), s, v)
      intensity = c*atan2(s, c*v)
      if (v > 0) intensity = intensity + s*atan(v)
   end subroutine get_cone_annulus

   !> J and I of a paraboloid that begins at a corner of radius 1, see `get_cone_annulus`.
   pure subroutine get_paraboloid_annulus(v, s, opening, intensity)
      real(dp), intent(in) :: v, s
      real(dp), intent(out) :: opening, intensity

      opening = bulge(s, v)/2
      intensity = s*v + (1 + v*v + s*s)*atan2(s, v)
   end subroutine get_paraboloid_annulus

   !> J and I of a punch with a rounded edge, see `get_cone_annulus`; for small V J loses digits.
   pure subroutine get_punch_annulus(v, s, opening, intensity)
      real(dp), intent(in) :: v, s
      real(dp), intent(out) :: opening, intensity
      real(dp) :: largest, c, less

      largest = v*v + s*s
      c = sqrt(1 + largest)
      ! c - 1
      less = largest/(1 + c)
      if (v > 0) then
         opening = bulge(s, v)/2 - c*lag(1/c, largest/(c*c), s, v)
         intensity = s*less_arctan(v) + c*(less*atan2(s, v) + atan(s*v*less/(c*v*v + s*s)))
      else
         opening = half_pi*less**2/2
         intensity = half_pi*c*less
      end if
   end subroutine get_punch_annulus

   !> J and I of a cone with a rounded tip beside a contact beyond its corner, see `get_cone_annulus`; for small V both lose digits.
   pure subroutine get_rounded_cone_annulus(a, v, s, opening, intensity)
      !> Radius a of contact, v, and s > 0.
      real(dp), intent(in) :: a, v, s
      real(dp), intent(out) :: opening, intensity

      real(dp) :: edge, turn

      call get_cone_annulus(v, s, opening, intensity)
      ! s (a - v) and c^2 (t - th)
      edge = s/(a + v)
      turn = (a*a + s*s)*atan(edge/(a*v + s*s))
      intensity = intensity + edge - turn
      if (s < small*v) then
         opening = opening - narrow_difference(a, v, s)
      else
         opening = opening + (atan2(s, v) - turn - edge)/2
      end if
   end subroutine get_rounded_cone_annulus

   !> Half of `bulge(s, v)` less half of `bulge(s, a)` for s below v, as a series: s^3 sum of (-s^2)^m/((2 m + 1) (2 m + 3)) times the
   !> difference of v^-(2 m + 1) and a^-(2 m + 1).
   pure real(dp) function narrow_difference(a, v, s) result(total)
      real(dp), intent(in) :: a, v, s
      real(dp) :: power, ratio, difference
      integer :: m

      ! times s^(2 m + 1)
      ratio = (s/(a*v))**2
      difference = s/(a*v*(a + v))
      power = s/a
      total = 0
      do m = 0, n_terms - 1
         total = total + merge(1, -1, modulo(m, 2) == 0)*difference/((2*m + 1)*(2*m + 3))
         difference = difference*(s/v)**2 + power*ratio
         power = power*(s/a)**2
      end do
      total = s*s*total
   end function narrow_difference

end module adfric_round_closed_annulus
