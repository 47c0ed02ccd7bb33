! SPDX-License-Identifier: GPL-3.0-or-later
!> Three integrals over a cohesive zone beside the contact on a wave (`adhesive_wave`): with T = tan gamma, tan phi = m T,
!>
!>     K = int_0^phi artanh(tan f/T) df
!>     M = int_0^phi ln s(f) df,    W = -2 int_0^phi f ln s(f) df,    s(f)^2 = sin(gamma + f) sin(gamma - f)/cos^2 f
!>
!> K and M are sums of Clausen functions (with M = phi ln sin gamma + L of other texts),
!>
!>     K = Cl(2 gamma)/2 - [Cl(2 gamma + 2 phi) + Cl(2 gamma - 2 phi)]/4
!>     M = -[Cl(2 gamma + 2 phi) - Cl(2 gamma - 2 phi)]/4 - Cl(pi - 2 phi)/2
!>
!> which lose their digits in short zones and close to saturation. So here the logarithms of the nearest zeros of the sines are
!> integrated in closed form, and the smooth rest by a Gauss rule of 10 nodes. For T <= 2 and phi <= pi/4 these are the zeros at
!> f = gamma and -gamma; for T > 2 and tan phi <= 1/2 no zero is near. Else the zones are seen from the valley, p = pi/2 - f,
!> e = pi/2 - gamma:
!>
!>     K = int_psi^(pi/2) artanh(tan e cot p) dp,    M = (1/2) int_psi^(pi/2) ln(1 - sin^2 e/sin^2 p) dp
!>
!> and the zeros are p = +-e and pi +- e. The rest is analytic within an ellipse of axes whose sum is 5.8 half-intervals at least, so
!> that the rule is exact to 5.8^-20 = 5e-16 of it. All three keep their relative accuracy where they are small.
module adfric_plane_adhesive_wave_integrals
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_numerics_gauss, only: nodes => gauss_nodes_10, weights => gauss_weights_10
   use adfric_numerics_libm, only: log1p
   implicit none (type, external)
   private
   public :: zone_range_integral, get_zone_integrals

   !> Up to which T and m T the zones are seen from the crest, and beyond which T and up to which m T no zero is near.
   real(dp), parameter :: moderate = 2.0_dp, far_from_valley = 1.0_dp, far_from_edge = 0.5_dp
   !> Below this ratio the sum of entropies is a series.
   real(dp), parameter :: small_ratio = 0.5_dp
   integer :: index
   !> Its coefficients 1/(k (2 k - 1)); (1/2)^2k of the last is 1e-15.
   real(dp), parameter :: entropy_series(25) = [(1.0_dp/(index*(2*index - 1)), index=1, 25)]

contains

   !> K alone.
   pure real(dp) function zone_range_integral(tangent, m, phi, distance) result(k)
      !> T = tan gamma, > 0.
      real(dp), intent(in) :: tangent
      !> m, 0 to 1.
      real(dp), intent(in) :: m
      !> phi = arctan(m T).
      real(dp), intent(in) :: phi
      !> gamma - phi, which is a small number where the contact is narrow.
      real(dp), intent(in) :: distance
      real(dp) :: f(size(nodes)), t1(size(nodes)), t2(size(nodes)), gamma, e, psi, ends

      if (has_asserts) call assert(tangent > 0 .and. m >= 0 .and. phi >= 0 .and. distance >= 0, 'zone_range_integral: T > 0')
      if (tangent > moderate .and. m*tangent <= far_from_edge) then
         k = (phi/2)*dot_product(weights, atanh(tan((phi/2)*(1 + nodes))/tangent))
      else if (tangent <= moderate .and. m*tangent <= far_from_valley) then
         gamma = phi + distance
         f = (phi/2)*(1 + nodes)
         t1 = tan(f)/tangent
         t2 = f/gamma
         k = (phi/2)*dot_product(weights, atanh((t1 - t2)/(1 - t1*t2))) + (gamma/2)*entropies(phi/gamma, distance/gamma)
      else
         e = atan(1/tangent)
         psi = e + distance
         f = psi + (phi/2)*(1 + nodes)
         t1 = 1/(tan(f)*tangent)
         t2 = e/f
         t1 = (t1 - t2)/(1 - t1*t2)
         t2 = e/(pi - f)
         ends = 2*area_below(pi/2, e, pi/2 - e) - area_below(psi, e, distance) - area_below(pi - psi, e, pi - psi - e)
         k = (phi/2)*dot_product(weights, atanh((t1 + t2)/(1 + t1*t2))) + ends
      end if
   end function zone_range_integral

   !> K, M and W.
   pure subroutine get_zone_integrals(tangent, m, phi, distance, k, mm, w)
      !> T = tan gamma, > 0.
      real(dp), intent(in) :: tangent
      !> m, 0 to 1.
      real(dp), intent(in) :: m
      !> phi = arctan(m T).
      real(dp), intent(in) :: phi
      !> gamma - phi.
      real(dp), intent(in) :: distance
      !> K, of the range.
      real(dp), intent(out) :: k
      !> M, of the penetration.
      real(dp), intent(out) :: mm
      !> W, of the energy.
      real(dp), intent(out) :: w

      k = zone_range_integral(tangent, m, phi, distance)
      if (tangent > moderate .and. m*tangent <= far_from_edge) then
         call get_far_from_edge(tangent, phi, mm, w)
      else if (tangent <= moderate .and. m*tangent <= far_from_valley) then
         call get_from_crest(tangent, phi, distance, mm, w)
      else
         call get_from_valley(tangent, phi, distance, mm, w)
      end if
   end subroutine get_zone_integrals

   !> M and W of T > 2, m T <= 1/2.
   pure subroutine get_far_from_edge(tangent, phi, mm, w)
      !> T = tan gamma, > 2.
      real(dp), intent(in) :: tangent
      !> phi, 0 to arctan(1/2).
      real(dp), intent(in) :: phi
      !> M.
      real(dp), intent(out) :: mm
      real(dp), intent(out) :: w
      real(dp) :: f(size(nodes)), logarithm(size(nodes))
      integer :: i

      f = (phi/2)*(1 + nodes)
      do i = 1, size(nodes)
         logarithm(i) = (phi/4)*weights(i)*(log1p(-(tan(f(i))/tangent)**2) - log1p(1/tangent**2))
      end do
      mm = sum(logarithm)
      w = -2*dot_product(logarithm, f)
   end subroutine get_far_from_edge

   !> M and W of T <= 2, phi <= pi/4.
   pure subroutine get_from_crest(tangent, phi, distance, mm, w)
      !> T = tan gamma, 0 to 2.
      real(dp), intent(in) :: tangent
      !> phi, 0 to pi/4.
      real(dp), intent(in) :: phi
      !> gamma - phi.
      real(dp), intent(in) :: distance
      !> M.
      real(dp), intent(out) :: mm
      real(dp), intent(out) :: w
      real(dp) :: f(size(nodes)), rest(size(nodes)), gamma, ratio, logarithm, in_log, closed

      gamma = phi + distance
      ratio = phi/gamma
      if (ratio < small_ratio) then
         in_log = log1p(-ratio**2)
         closed = (phi/2)*in_log - phi + gamma*atanh(ratio)
      else
         in_log = log_of(distance/gamma) + log1p(ratio)
         closed = (gamma/2)*((1 + ratio)*log1p(ratio) - (distance/gamma)*log_of(distance/gamma)) - phi
      end if
      logarithm = -log1p(1/tangent**2)/2
      f = (phi/2)*(1 + nodes)
      rest = (phi/4)*weights*log((1 - (tan(f)/tangent)**2)/(1 - (f/gamma)**2))
      mm = phi*logarithm + sum(rest) + closed
      w = -phi**2*logarithm - 2*dot_product(rest, f) + (distance*(gamma + phi)*in_log + phi**2)/2
   end subroutine get_from_crest

   !> M and W of the other zones.
   pure subroutine get_from_valley(tangent, phi, distance, mm, w)
      !> T = tan gamma, > 1.
      real(dp), intent(in) :: tangent
      !> phi, arctan(1/2) to pi/2.
      real(dp), intent(in) :: phi
      !> gamma - phi.
      real(dp), intent(in) :: distance
      !> M.
      real(dp), intent(out) :: mm
      real(dp), intent(out) :: w
      real(dp) :: p(size(nodes)), a(size(nodes)), b(size(nodes)), c(size(nodes)), e, psi, far, f_near, f_far, f_half

      e = atan(1/tangent)
      psi = e + distance
      far = pi - psi
      p = psi + (phi/2)*(1 + nodes)
      a = 1/((1 + tangent**2)*sin(p)**2)
      b = (e/p)**2
      c = (e/(pi - p))**2
      a = (phi/4)*weights*log_of_ratios(a, b, c)
      f_near = (psi/2)*entropies(e/psi, distance/psi)
      f_far = (far/2)*entropies(e/far, (far - e)/far)
      f_half = (pi/4)*entropies(2*e/pi, 1 - 2*e/pi)
      mm = sum(a) + f_far - f_near
      w = -2*(dot_product(pi/2 - p, a) + (pi/2)*(2*f_half - f_near - f_far) &
         & + moment_below(psi, e, distance) + moment_below(far, e, far - e) - 2*moment_below(pi/2, e, pi/2 - e))
   end subroutine get_from_valley

   !> ln[(1 - a)/((1 - b)(1 - c))], of small numbers too.
   elemental real(dp) function log_of_ratios(a, b, c)
      !> Squares of ratios, < 1.
      real(dp), intent(in) :: a, b, c

      log_of_ratios = log1p((b + c - b*c - a)/((1 - b)*(1 - c)))
   end function log_of_ratios

   !> The integral of artanh(e/p) over p, e ln p + [(p + e) ln(1 + e/p) - (p - e) ln(1 - e/p)]/2.
   pure real(dp) function area_below(p, e, distance)
      !> Position [rad], >= e.
      real(dp), intent(in) :: p
      !> The zero [rad], >= 0.
      real(dp), intent(in) :: e
      !> p - e.
      real(dp), intent(in) :: distance
      real(dp) :: ratio, logarithm

      ratio = e/p
      logarithm = log_of(distance/p)
      if (ratio < small_ratio) logarithm = log1p(-ratio)
      area_below = e*log(p) + ((p + e)*log1p(ratio) - distance*logarithm)/2
   end function area_below

   !> The integral of p ln(1 - e^2/p^2)/2 over p, [(p^2 - e^2) ln(1 - e^2/p^2) - 2 e^2 ln p]/4.
   pure real(dp) function moment_below(p, e, distance)
      !> Position [rad], >= e.
      real(dp), intent(in) :: p
      !> The zero [rad], >= 0.
      real(dp), intent(in) :: e
      !> p - e.
      real(dp), intent(in) :: distance
      real(dp) :: ratio, logarithm

      ratio = e/p
      logarithm = log_of(distance/p) + log1p(ratio)
      ! a number next to 1 has lost what it differs from 1 by
      if (ratio < small_ratio) logarithm = log1p(-ratio**2)
      moment_below = (distance*(p + e)*logarithm - 2*e**2*log(p))/4
   end function moment_below

   !> (1 + r) ln(1 + r) + (1 - r) ln(1 - r).
   pure real(dp) function entropies(ratio, rest)
      !> r, 0 to 1.
      real(dp), intent(in) :: ratio
      !> 1 - r.
      real(dp), intent(in) :: rest
      integer :: i

      if (ratio > small_ratio) then
         entropies = (1 + ratio)*log1p(ratio) + rest*log_of(rest)
      else
         entropies = 0
         do i = size(entropy_series), 1, -1
            entropies = entropies*ratio**2 + entropy_series(i)
         end do
         entropies = entropies*ratio**2
      end if
   end function entropies

   !> ln x, and a finite number at 0.
   elemental real(dp) function log_of(x)
      !> A number >= 0.
      real(dp), intent(in) :: x

      log_of = log(max(x, tiny(x)))
   end function log_of

end module adfric_plane_adhesive_wave_integrals
