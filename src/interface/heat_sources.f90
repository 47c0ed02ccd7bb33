! SPDX-License-Identifier: GPL-3.0-or-later
!> How warm the surface of a half-space becomes under a source of heat that moves over it at a constant speed.
!>
!> All is in the unit q a/lambda of a temperature, with the mean flux q over the source, its half-width, half-side or radius a, and the
!> conductivity lambda. The speed counts as P = V a/(2 kappa), kappa the diffusivity. No heat leaves the surface beside the source. x is
!> in a, from the middle of the source, positive to where it moves.
!>
!> A point that sees the rim of a uniform source at the distance R(f) in the direction f from that of the motion has
!>
!>     T = (1/2 pi) int [1 - e^(-P R (1 - cos f))]/(P (1 - cos f)) df,   f from 0 to 2 pi,
!>
!> and under a band that is (1/pi P) [int_0^(P (1 + x)) e^(-t) K0 dt + int_0^(P (1 - x)) e^t K0 dt]. The mean over a source follows
!> from the share of its points that have another one of the source at a given distance: with C(r) of a round source
!> (1/pi) int_0^2 C(r) e^(-P r) I0(P r) dr.
module adfric_interface_heat_sources
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_constants, only: half_pi, pi
   use adfric_interface_graded_nodes, only: get_graded_nodes
   use adfric_numerics_libm, only: expm1
   use adfric_numerics_scaled_bessel, only: scaled_i0, scaled_k0, scaled_k1
   implicit none (type, external)
   private
   public :: temperature_at, band_temperature, find_largest_temperature, find_largest_of_sources, mean_temperature
   public :: largest_of_disc
   public :: source_band, source_square, source_disc, source_hertz

   !> Sources: a band across the motion, a square along it, a disc, and a disc under Hertz's pressure, q(r) = (3/2) sqrt(1 - r^2).
   integer, parameter :: source_band = 1, source_square = 2, source_disc = 3, source_hertz = 4
   !> Levels of panels towards both ends of a segment, each half as long as the one before: of integrals and of those inside them, for P
   !> up to 100; more above it.
   integer, parameter :: n_levels = 9, n_levels_inside = 5
   real(dp), parameter :: moderate_peclet = 100
   !> Below it integrals of K0 are taken by nodes, for their closed form has lost digits.
   real(dp), parameter :: small_argument = 1.0_dp
   !> Golden section, and steps of the search for the warmest point: a ten-millionth of the source.
   real(dp), parameter :: golden = 0.618033988749894848_dp
   integer, parameter :: n_steps = 36

contains

   !> Levels that a speed needs: what is felt ahead is as short as 1/P.
   pure integer function levels_of(base, peclet)
      !> Levels of a moderate speed.
      integer, intent(in) :: base
      real(dp), intent(in) :: peclet

      levels_of = base + max(0, ceiling(log(peclet/moderate_peclet)/log(2.0_dp)))
   end function levels_of

   !> Temperature on the middle line.
   pure real(dp) function temperature_at(source, peclet, x) result(temperature)
      !> One of `source_...`.
      integer, intent(in) :: source
      !> P [-], > 0.
      real(dp), intent(in) :: peclet
      !> Position [a], -1 < x < 1.
      real(dp), intent(in) :: x
      real(dp), allocatable :: f(:), weights(:)
      integer :: i

      if (has_asserts) call assert(peclet > 0 .and. abs(x) < 1, 'temperature_at: peclet > 0, |x| < 1')
      if (source == source_band) then
         temperature = band_temperature(peclet, x)
         return
      end if
      call get_graded_nodes([0.0_dp, kinks_of(source, x), pi], levels_of(n_levels, peclet), f, weights)
      temperature = 0
      do i = 1, size(f)
         temperature = temperature + weights(i)*from_direction(source, peclet, x, f(i))/pi
      end do
   end function temperature_at

   !> Temperature of a band, under it and beside it.
   pure real(dp) function band_temperature(peclet, x) result(temperature)
      !> P [-], > 0.
      real(dp), intent(in) :: peclet
      !> Position [a].
      real(dp), intent(in) :: x

      if (x > 1) then
         temperature = (integral_behind(peclet*(x + 1)) - integral_behind(peclet*(x - 1)))/(pi*peclet)
      else if (x < -1) then
         temperature = (integral_ahead(peclet*(1 - x)) - integral_ahead(peclet*(-1 - x)))/(pi*peclet)
      else
         temperature = (integral_behind(peclet*(1 + x)) + integral_ahead(peclet*(1 - x)))/(pi*peclet)
      end if
   end function band_temperature

   !> Largest temperature of a disc, 2/sqrt(pi (4/pi + P)): exact at rest and at high speeds, and within 2.3 % between.
   pure real(dp) function largest_of_disc(peclet) result(temperature)
      !> P [-], >= 0.
      real(dp), intent(in) :: peclet

      temperature = 2/sqrt(4 + pi*peclet)
   end function largest_of_disc

   !> Directions in which the distance of the rim changes fast.
   pure function kinks_of(source, x) result(kinks)
      integer, intent(in) :: source
      real(dp), intent(in) :: x
      real(dp) :: kinks(2)

      kinks = [half_pi/2, half_pi]
      if (source == source_square) kinks = [atan2(1.0_dp, 1 - x), pi - atan2(1.0_dp, 1 + x)]
   end function kinks_of

   !> What comes from a direction, 0 <= f <= pi.
   pure real(dp) function from_direction(source, peclet, x, f) result(heat)
      integer, intent(in) :: source
      real(dp), intent(in) :: peclet, x, f
      real(dp) :: rate, ahead, behind, root
      real(dp), allocatable :: s(:), weights(:)

      rate = 2*peclet*sin(f/2)**2
      root = sqrt((1 - x*sin(f))*(1 + x*sin(f)))
      if (source == source_square) then
         ahead = 1/max(sin(f), tiny(1.0_dp))
         if (cos(f) > 0) ahead = min(ahead, (1 - x)/cos(f))
         if (cos(f) < 0) ahead = min(ahead, -(1 + x)/cos(f))
      else
         ! the small one of both is the quotient of 1 - x^2 by the large one
         ahead = root - x*cos(f)
         if (x*cos(f) > 0) ahead = (1 - x**2)/(root + x*cos(f))
      end if
      if (source /= source_hertz) then
         heat = ahead
         if (rate*ahead > epsilon(1.0_dp)) heat = -expm1(-rate*ahead)/rate
         return
      end if
      behind = (1 - x**2)/ahead
      ! r = R (1 - s^2), so that the root at the rim is s
      call get_graded_nodes([0.0_dp, 1.0_dp], levels_of(n_levels_inside, peclet), s, weights)
      associate (r => ahead*(1 - s)*(1 + s))
         heat = 3*ahead*sqrt(ahead)*sum(weights*s**2*sqrt(r + behind)*exp(-rate*r))
      end associate
   end function from_direction

   !> int_0^z e^(-t) K0(t) dt.
   pure real(dp) function integral_behind(z) result(integral)
      real(dp), intent(in) :: z

      if (z < small_argument) then
         integral = integral_near_0(z, -1)
      else
         integral = 1 + z*exp(-2*z)*(scaled_k0(z) - scaled_k1(z))
      end if
   end function integral_behind

   !> int_0^z e^t K0(t) dt.
   pure real(dp) function integral_ahead(z) result(integral)
      real(dp), intent(in) :: z

      if (z < small_argument) then
         integral = integral_near_0(z, 1)
      else
         integral = z*(scaled_k0(z) + scaled_k1(z)) - 1
      end if
   end function integral_ahead

   !> int_0^z e^(+-t) K0(t) dt of a small z.
   pure real(dp) function integral_near_0(z, direction) result(integral)
      real(dp), intent(in) :: z
      !> Sign of the exponent.
      integer, intent(in) :: direction
      real(dp), allocatable :: s(:), weights(:)
      integer :: i

      integral = 0
      if (.not. z > 0) return
      call get_graded_nodes([0.0_dp, 1.0_dp], n_levels, s, weights)
      do i = 1, size(s)
         ! t = z s^4, which takes the logarithm away
         associate (t => z*s(i)**4)
            integral = integral + weights(i)*4*z*s(i)**3*scaled_k0(t)*exp((direction - 1)*t)
         end associate
      end do
   end function integral_near_0

   !> The warmest point of the middle line.
   pure subroutine find_largest_temperature(source, peclet, x, temperature)
      !> One of `source_...`.
      integer, intent(in) :: source
      !> P [-], > 0.
      real(dp), intent(in) :: peclet
      !> Its position [a], and its temperature.
      real(dp), intent(out) :: x, temperature

      call find_largest_of_sources([source], [1.0_dp], peclet, x, temperature)
   end subroutine find_largest_temperature

   !> The warmest point of the middle line under several sources. It lies between the warmest points of each: behind them all
   !> temperatures rise, and ahead of them all fall.
   pure subroutine find_largest_of_sources(sources, fluxes, peclet, x, temperature)
      !> Some of `source_...`.
      integer, intent(in) :: sources(:)
      !> Their fluxes, >= 0.
      real(dp), intent(in) :: fluxes(:)
      !> P [-], > 0.
      real(dp), intent(in) :: peclet
      !> Its position [a], and its temperature in the unit of the fluxes.
      real(dp), intent(out) :: x, temperature
      real(dp) :: ends(2), inner(2), values(2)
      integer :: i

      ends = [-1.0_dp, 1.0_dp]
      inner = [ends(2) - golden*(ends(2) - ends(1)), ends(1) + golden*(ends(2) - ends(1))]
      values = [sum_at(inner(1)), sum_at(inner(2))]
      do i = 1, n_steps
         if (values(1) > values(2)) then
            ends(2) = inner(2)
            inner(2) = inner(1)
            values(2) = values(1)
            inner(1) = ends(2) - golden*(ends(2) - ends(1))
            values(1) = sum_at(inner(1))
         else
            ends(1) = inner(1)
            inner(1) = inner(2)
            values(1) = values(2)
            inner(2) = ends(1) + golden*(ends(2) - ends(1))
            values(2) = sum_at(inner(2))
         end if
      end do
      x = inner(maxloc(values, 1))
      temperature = maxval(values)

   contains

      !> Temperature of all sources at a position.
      pure real(dp) function sum_at(position)
         real(dp), intent(in) :: position
         integer :: k

         sum_at = 0
         do k = 1, size(sources)
            if (fluxes(k) > 0) sum_at = sum_at + fluxes(k)*temperature_at(sources(k), peclet, position)
         end do
      end function sum_at

   end subroutine find_largest_of_sources

   !> Mean temperature over the source.
   pure real(dp) function mean_temperature(source, peclet, with_flux) result(mean)
      !> One of `source_...`.
      integer, intent(in) :: source
      !> P [-], > 0.
      real(dp), intent(in) :: peclet
      !> Is it weighted with the flux? That matters for Hertz's pressure alone.
      logical, intent(in) :: with_flux
      real(dp), allocatable :: s(:), weights(:)
      real(dp) :: r
      integer :: i

      if (has_asserts) call assert(peclet > 0, 'mean_temperature: peclet > 0')
      mean = 0
      if (source == source_square) then
         call get_graded_nodes([0.0_dp, pi/4, half_pi, 3*pi/4, pi], levels_of(n_levels, peclet), s, weights)
         do i = 1, size(s)
            mean = mean + weights(i)*mean_from_direction(peclet, s(i))/pi
         end do
         return
      end if
      call get_graded_nodes([0.0_dp, 1.0_dp], levels_of(n_levels, peclet), s, weights)
      do i = 1, size(s)
         ! r = 2 s^4, which takes the logarithm of a band away
         r = 2*s(i)**4
         if (source == source_band) then
            mean = mean + weights(i)*8*s(i)**3*(2 - r)/(2*pi)*(1 + exp(-2*peclet*r))*scaled_k0(peclet*r)
         else
            mean = mean + weights(i)*8*s(i)**3*correlation(source, r, with_flux)/pi*scaled_i0(peclet*r)
         end if
      end do
   end function mean_temperature

   !> What the points of a square get from a direction, on average.
   pure real(dp) function mean_from_direction(peclet, f) result(heat)
      real(dp), intent(in) :: peclet, f
      real(dp), allocatable :: s(:), weights(:)
      real(dp) :: longest, rate

      longest = 2/max(abs(cos(f)), sin(f))
      rate = 2*peclet*sin(f/2)**2
      call get_graded_nodes([0.0_dp, 1.0_dp], levels_of(n_levels_inside, peclet), s, weights)
      associate (r => longest*s)
         heat = longest*sum(weights*(2 - r*abs(cos(f)))*(2 - r*sin(f))/4*exp(-rate*r))
      end associate
   end function mean_from_direction

   !> C(r): the integral over a disc of its weight and that at the distance r in some direction.
   pure real(dp) function correlation(source, r, with_flux) result(c)
      integer, intent(in) :: source
      !> Distance, 0 to 2.
      real(dp), intent(in) :: r
      logical, intent(in) :: with_flux
      real(dp), allocatable :: s(:), weights(:)
      real(dp) :: half, u, near, far
      integer :: i

      if (source == source_disc) then
         c = 2*acos(min(r/2, 1.0_dp)) - r/2*sqrt(max((2 - r)*(2 + r), 0.0_dp))
         return
      end if
      ! u from the middle of both, -(1 - r/2) to 1 - r/2, and along it the chord that both discs share
      half = 1 - r/2
      c = 0
      if (.not. half > 0) return
      call get_graded_nodes([-half_pi, 0.0_dp, half_pi], n_levels_inside, s, weights)
      do i = 1, size(s)
         u = half*sin(s(i))
         near = (1 - (u + r/2))*(1 + u + r/2)
         far = (1 - (u - r/2))*(1 + u - r/2)
         c = c + weights(i)*half*cos(s(i))*merge(chord_of_both(near, far), chord_of_one(near, far), with_flux)
      end do
   end function correlation

   !> int (3/2) sqrt(near - v^2) dv over the chord of both discs, v^2 < near and v^2 < far.
   pure real(dp) function chord_of_one(near, far) result(integral)
      !> Squares of the half-chords of the disc with the weight and of the other.
      real(dp), intent(in) :: near, far

      integral = 0
      if (.not. min(near, far) > 0) return
      if (near <= far) then
         integral = 0.75_dp*pi*near
      else
         integral = 1.5_dp*(sqrt(far*(near - far)) + near*asin(sqrt(far/near)))
      end if
   end function chord_of_one

   !> int (9/4) sqrt((near - v^2) (far - v^2)) dv over that chord.
   pure real(dp) function chord_of_both(near, far) result(integral)
      real(dp), intent(in) :: near, far
      real(dp), allocatable :: s(:), weights(:)

      integral = 0
      if (.not. min(near, far) > 0) return
      call get_graded_nodes([0.0_dp, half_pi], n_levels_inside, s, weights)
      ! v = sqrt(least) sin s
      associate (least => min(near, far), most => max(near, far))
         integral = 4.5_dp*least*sum(weights*cos(s)**2*sqrt(most - least*sin(s)**2))
      end associate
   end function chord_of_both

end module adfric_interface_heat_sources
