! SPDX-License-Identifier: GPL-3.0-or-later
!> An elastic half-plane on a rigid wave z = D (1 - cos 2 pi x/l) that attracts it by a constant stress sigma0 where the gap is at
!> most h0 (Dugdale): the equations of the zones.
!>
!> Reduced: pressures in p* = pi E* D/l, heights, gaps and penetrations in D, lengths along the wave in l, energies per area in
!> p* D. S = sigma0/p*, eta = h0/D, sigma = 2 S/pi. Contact holds at |x| < a, cohesion at a < |x| < c; alpha = pi a, gamma = pi c,
!> T = tan gamma, m = sqrt(1 - sin^2 alpha/sin^2 gamma) = tanh y, tan phi = m T, which is cos gamma = cos alpha cos phi, and
!> Q = sin^2 alpha. With the integrals K and M of `adhesive_wave_integrals`,
!>
!>     (1)  P     = Q - sigma phi
!>     (2)  eta   = 2 sin^2 gamma [m - (1 - m^2) y] + 2 sigma K
!>     (3)  delta = Q (1 - ln Q) + 2 sigma M
!>
!> An open crest has y = infinity in (1) and in M, and stands eta - (right side of (2)) above the half-plane, by which delta is
!> less than in (3). The derivatives along the curve of equilibria, S and eta held, are with L = ln(tan gamma/tan alpha),
!> Lambda = -ln sin alpha
!>
!>     y dP/d gamma             = m sin 2 gamma - sigma L           =: load_slope
!>     (y/2) d delta/d gamma    = Lambda load_slope + sigma y^2     =: penetration_slope
!>
!> and with an open crest dP/d gamma = -sigma, d delta/d gamma = 2 sin 2 gamma + 2 sigma ln(2 sin 2 gamma). The right side of (2)
!> rises with y, d/dy = 2 y (1 - m^2) [2 m sin^2 gamma + sigma T/(1 + m^2 T^2)].
module adfric_plane_adhesive_wave
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_numerics_hyperbolic, only: sinh_minus_argument
   use adfric_numerics_libm, only: log1p
   use adfric_plane_adhesive_wave_integrals, only: zone_range_integral
   implicit none (type, external)
   private
   public :: zones_t, get_zones_of_position, get_zones_of_angle, range_excess, load_slope, penetration_slope, get_range_slopes, &
      & get_fold_slopes, open_crest, log_cosh

   !> y of an open crest; sin alpha is 0 for every y beyond.
   real(dp), parameter :: open_crest = 1000.0_dp
   !> Below this y differences of hyperbolic functions are series.
   real(dp), parameter :: small_y = 0.5_dp

   !> The zones of contact and cohesion.
   type :: zones_t
      !> Position x = ln T of the edge of cohesion, and y of the edge of contact.
      real(dp) :: position = 0, y = 0
      !> T, sin gamma, cos gamma.
      real(dp) :: tangent = 1, sine = 0, cosine = 1
      !> m and 1 - m^2.
      real(dp) :: m = 0, rest = 1
      !> phi and gamma - phi [rad].
      real(dp) :: phi = 0, distance = 0
      !> Q = sin^2 alpha.
      real(dp) :: square = 0
      !> Lambda = -ln sin alpha and L = ln(tan gamma/tan alpha).
      real(dp) :: lambda = 0, log_ratio = 0
   end type zones_t

contains

   !> Zones of given edges.
   pure subroutine get_zones_of_position(x, y, zones)
      !> ln tan(pi c).
      real(dp), intent(in) :: x
      !> y = artanh m, >= 0; `open_crest` without contact.
      real(dp), intent(in) :: y
      type(zones_t), intent(out) :: zones
      real(dp) :: e

      if (has_asserts) call assert(y >= 0, 'get_zones_of_place: y >= 0')
      e = exp(-2*y)
      zones%position = x
      zones%y = y
      zones%tangent = exp(x)
      zones%m = tanh(y)
      zones%rest = 4*e/(1 + e)**2
      call set_edge(zones)
      zones%phi = atan(zones%m*zones%tangent)
      zones%distance = distance_of(zones)
      zones%square = zones%sine**2*zones%rest
      zones%lambda = log1p(1/zones%tangent**2)/2 + log_cosh(y)
      zones%log_ratio = log1p((zones%m*zones%tangent)**2)/2 + log_cosh(y)
   end subroutine get_zones_of_position

   !> Zones of given phi and contact.
   pure subroutine get_zones_of_angle(phi, square, zones)
      !> phi [rad], 0 to pi/2.
      real(dp), intent(in) :: phi
      !> Q = sin^2 alpha, > 0, < 1.
      real(dp), intent(in) :: square
      type(zones_t), intent(out) :: zones
      real(dp) :: tangent_phi

      if (has_asserts) call assert(square > 0 .and. square < 1 .and. phi > 0, 'get_zones_of_angle: 0 < Q < 1, phi > 0')
      tangent_phi = tan(phi)
      zones%phi = phi
      zones%square = square
      ! sin^2 gamma = sin^2 phi + Q cos^2 phi, cos^2 gamma = (1 - Q) cos^2 phi
      zones%tangent = sqrt((tangent_phi**2 + square)/(1 - square))
      zones%position = log(zones%tangent)
      call set_edge(zones)
      zones%m = tangent_phi/zones%tangent
      zones%rest = square/zones%sine**2
      if (zones%m < small_y) then
         zones%y = atanh(zones%m)
      else
         zones%y = log1p(zones%m) - log(zones%rest)/2
      end if
      zones%distance = distance_of(zones)
      zones%lambda = -log(square)/2
      zones%log_ratio = (log1p(tangent_phi**2) + log_inverse(zones))/2
   end subroutine get_zones_of_angle

   !> Sine and cosine of gamma.
   pure subroutine set_edge(zones)
      !> The zones, with T; receives the sine and the cosine.
      type(zones_t), intent(inout) :: zones

      zones%cosine = 1/sqrt(1 + zones%tangent**2)
      zones%sine = zones%tangent*zones%cosine
   end subroutine set_edge

   !> -ln(1 - m^2).
   pure real(dp) function log_inverse(zones)
      !> The zones, with m and 1 - m^2.
      type(zones_t), intent(in) :: zones

      if (zones%m < small_y) then
         log_inverse = -log1p(-zones%m**2)
      else
         log_inverse = -log(zones%rest)
      end if
   end function log_inverse

   !> gamma - phi, of which the tangent is (1 - m) T/(1 + m T^2).
   pure real(dp) function distance_of(zones)
      !> The zones, with T, m and 1 - m^2.
      type(zones_t), intent(in) :: zones

      distance_of = atan((zones%rest/(1 + zones%m))/(1/zones%tangent + zones%m*zones%tangent))
   end function distance_of

   !> ln cosh y for y >= 0.
   elemental real(dp) function log_cosh(y)
      !> Argument of the function [-], >= 0.
      real(dp), intent(in) :: y

      if (y < 1) then
         log_cosh = log1p(sinh(y)**2)/2
      else
         log_cosh = y + log1p(exp(-2*y)) - log(2.0_dp)
      end if
   end function log_cosh

   !> What the right side of (2) is more than eta.
   pure real(dp) function range_excess(sigma, eta, zones, k)
      !> sigma = 2 S/pi, > 0.
      real(dp), intent(in) :: sigma
      !> Range eta; 0 gives the range of the zones.
      real(dp), intent(in) :: eta
      type(zones_t), intent(in) :: zones
      !> K of the zones, if it is known.
      real(dp), intent(in), optional :: k

      associate (z => zones)
         if (z%y < small_y) then
            range_excess = z%square*sinh_minus_argument(2*z%y) - eta
         else if (z%tangent > 1) then
            range_excess = (2 - eta) - 2*z%cosine**2 - 2*z%sine**2*z%rest*(1/(1 + z%m) + z%y)
         else
            range_excess = 2*z%sine**2*(z%m - z%rest*z%y) - eta
         end if
         if (present(k)) then
            range_excess = range_excess + 2*sigma*k
         else
            range_excess = range_excess + 2*sigma*zone_range_integral(z%tangent, z%m, z%phi, z%distance)
         end if
      end associate
   end function range_excess

   !> Slope y dP/d gamma of the load along the curve of equilibria.
   pure real(dp) function load_slope(sigma, zones)
      !> sigma = 2 S/pi, > 0.
      real(dp), intent(in) :: sigma
      type(zones_t), intent(in) :: zones

      load_slope = 2*zones%m*zones%sine*zones%cosine - sigma*zones%log_ratio
   end function load_slope

   !> Slope (y/2) d delta/d gamma of the penetration along the curve of equilibria.
   pure real(dp) function penetration_slope(sigma, zones)
      !> sigma = 2 S/pi, > 0.
      real(dp), intent(in) :: sigma
      type(zones_t), intent(in) :: zones

      penetration_slope = zones%lambda*load_slope(sigma, zones) + sigma*zones%y**2
   end function penetration_slope

   !> Derivatives of the right side of (2).
   pure subroutine get_range_slopes(sigma, zones, by_position, by_y)
      !> sigma = 2 S/pi, > 0.
      real(dp), intent(in) :: sigma
      type(zones_t), intent(in) :: zones
      !> Derivatives by x and by y.
      real(dp), intent(out) :: by_position, by_y
      real(dp) :: h

      associate (z => zones, sc => zones%sine*zones%cosine)
         h = 1 + (z%m*z%tangent)**2
         by_y = 2*z%y*z%rest*(2*z%m*z%sine**2 + sigma*z%tangent/h)
         by_position = 2*sc*(2*sc*(z%m - z%rest*z%y)) + 2*sigma*sc*((1 + z%tangent**2)*z%m*z%y/h - z%log_ratio)
         if (z%y < small_y) by_position = 2*sc*(2*sc*z%rest*sinh_minus_argument(2*z%y)/2) &
            & + 2*sigma*sc*((1 + z%tangent**2)*z%m*z%y/h - z%log_ratio)
      end associate
   end subroutine get_range_slopes

   !> Derivatives of `load_slope` and `penetration_slope`.
   pure subroutine get_fold_slopes(sigma, zones, load_by, penetration_by)
      !> sigma = 2 S/pi, > 0.
      real(dp), intent(in) :: sigma
      type(zones_t), intent(in) :: zones
      !> Derivatives by x and by y of the one and of the other.
      real(dp), intent(out) :: load_by(2), penetration_by(2)
      real(dp) :: h, twice

      associate (z => zones)
         h = 1 + (z%m*z%tangent)**2
         twice = 2*z%sine*z%cosine
         load_by(1) = z%m*twice*(z%cosine**2 - z%sine**2) - sigma*(z%m*z%tangent)**2/h
         load_by(2) = z%rest*twice - sigma*z%m*(1 + z%tangent**2)/h
         penetration_by = z%lambda*load_by + load_slope(sigma, z)*[-z%cosine**2, z%m] + [0.0_dp, 2*sigma*z%y]
      end associate
   end subroutine get_fold_slopes

end module adfric_plane_adhesive_wave
