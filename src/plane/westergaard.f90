! SPDX-License-Identifier: GPL-3.0-or-later
!> A sinusoidal wave z = D (1 - cos 2 pi x/l) pressed on an elastic half-plane without friction (Westergaard; Y; Johnson, Contact
!> Mechanics, 1985, 13.2).
!>
!> Reduced: pressures in p* = pi E* D/l, the mean pressure of full contact, lengths along the wave in l, heights and gaps in D.
!> q is the mean pressure, and psi = pi x/l. Contact holds where |sin psi| <= s = sqrt(q), so that 2a/l = (2/pi) asin sqrt(q):
!> the root is inside the arcsine, which a hasty reading of Y misses.
module adfric_plane_westergaard
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_numerics_hyperbolic, only: sinh_minus_argument
   use adfric_numerics_scalar_root, only: equation_t, find_root
   implicit none (type, external)
   private
   public :: wave_half_width, wave_pressure, wave_gap, wave_mean_gap, wave_penetration, wave_energy, wave_stiffness
   public :: find_wave_pressure

   !> Below this distance from full contact the mean gap is a small difference.
   real(dp), parameter :: nearly_full = 0.1_dp
   !> Logarithm of the least mean pressure that is looked for.
   real(dp), parameter :: least_logarithm = -700.0_dp
   !> A Newton step of this size of ln q is the last.
   real(dp), parameter :: last_step = 1.0e-9_dp

   !> ln(1 - x) + x - ln(penetration) for x = ln q.
   type, extends(equation_t) :: penetration_equation_t
      !> ln of the penetration over D.
      real(dp) :: logarithm = 0
   contains
      procedure :: evaluate
   end type penetration_equation_t

contains

   !> Half-width a/l of contact for a mean pressure q >= 0.
   elemental real(dp) function wave_half_width(q)
      !> Mean pressure, in p* [-], >= 0.
      real(dp), intent(in) :: q

      wave_half_width = 0.5_dp
      if (q < 1) wave_half_width = atan2(sqrt(q), sqrt(1 - q))/pi
   end function wave_half_width

   !> Pressure at x: 2 cos psi sqrt(s^2 - sin^2 psi), and q + cos 2 psi in full contact.
   elemental real(dp) function wave_pressure(q, x)
      !> Mean pressure, in p* [-], >= 0.
      real(dp), intent(in) :: q
      !> Coordinate along the wave, from a crest, in wavelengths [-].
      real(dp), intent(in) :: x
      real(dp) :: psi, edge

      psi = phase_of(x)
      if (q < 1) then
         edge = pi*wave_half_width(q)
         wave_pressure = 2*cos(psi)*sqrt(max(0.0_dp, sin(edge - psi))*sin(edge + psi))
      else
         wave_pressure = (q - 1) + 2*cos(psi)**2
      end if
   end function wave_pressure

   !> Gap at x. Its slope continues the pressure, dg/d psi = 4 cos psi sqrt(sin^2 psi - s^2), and with sin psi = s cosh v
   !>
   !>     g = s^2 (sinh 2v - 2v)
   elemental real(dp) function wave_gap(q, x)
      !> Mean pressure, in p* [-], >= 0.
      real(dp), intent(in) :: q
      !> Coordinate along the wave, from a crest, in wavelengths [-].
      real(dp), intent(in) :: x
      real(dp) :: psi, edge, square

      psi = phase_of(x)
      wave_gap = 0
      if (q >= 1) return
      edge = pi*wave_half_width(q)
      if (psi <= edge) return
      square = sin(psi - edge)*sin(psi + edge)
      if (q > epsilon(q)**2) then
         wave_gap = q*sinh_minus_argument(2*asinh(sqrt(square/q)))
      else
         wave_gap = 2*square
      end if
   end function wave_gap

   !> psi of the same position within half a wave of the nearest crest, 0 <= psi <= pi/2.
   elemental real(dp) function phase_of(x)
      !> Coordinate along the wave, from a crest, in wavelengths [-].
      real(dp), intent(in) :: x

      phase_of = pi*abs(x - anint(x))
   end function phase_of

   !> Mean gap 1 - q + q ln q; 0 in full contact.
   elemental real(dp) function wave_mean_gap(q)
      !> Mean pressure, in p* [-], >= 0.
      real(dp), intent(in) :: q
      real(dp) :: d, term
      integer :: k

      wave_mean_gap = 0
      if (q >= 1) return
      d = 1 - q
      if (d > nearly_full) then
         wave_mean_gap = d
         if (q > 0) wave_mean_gap = d + q*log(q)
         return
      end if
      ! sum of d^k/(k (k - 1))
      term = d*d
      do k = 2, 17
         wave_mean_gap = wave_mean_gap + term/(k*(k - 1))
         term = term*d
      end do
   end function wave_mean_gap

   !> How far the mean planes have approached since first touch: q - q ln q, 1 in full contact.
   elemental real(dp) function wave_penetration(q)
      !> Mean pressure, in p* [-], >= 0.
      real(dp), intent(in) :: q

      wave_penetration = 1
      if (q < 1) wave_penetration = 0
      if (q > 0 .and. q < 1) wave_penetration = q - q*log(q)
   end function wave_penetration

   !> Slope of the mean pressure over the approach, in p*/D: -1/ln q, 0 without contact and infinite in full contact.
   elemental real(dp) function wave_stiffness(q)
      !> Mean pressure, in p* [-], >= 0 and below 1.
      real(dp), intent(in) :: q

      wave_stiffness = 0
      if (q > 0) wave_stiffness = -1/log(q)
   end function wave_stiffness

   !> Energy of the solid over nominal area, in p* D: q^2 (1 - 2 ln q)/4, 1/4 in full contact.
   elemental real(dp) function wave_energy(q)
      !> Mean pressure, in p* [-], >= 0.
      real(dp), intent(in) :: q

      wave_energy = 0.25_dp
      if (q < 1) wave_energy = 0
      if (q > 0 .and. q < 1) wave_energy = q**2*(1 - 2*log(q))/4
   end function wave_energy

   !> Mean pressure of a penetration up to 1; 0 for a negative one. In full contact every pressure >= 1 belongs to
   !> the penetration 1, and the least is given.
   pure subroutine find_wave_pressure(penetration, q, is_converged)
      !> Approach of the mean planes since first touch, in D [-]; no pressure belongs to more than 1.
      real(dp), intent(in) :: penetration
      !> Mean pressure, in p* [-], >= 0.
      real(dp), intent(out) :: q
      logical, intent(out) :: is_converged
      type(penetration_equation_t) :: equation
      real(dp) :: x

      q = merge(0.0_dp, 1.0_dp, penetration < 1)
      is_converged = penetration <= 1
      if (penetration <= exp(least_logarithm) .or. penetration >= 1) return
      equation%logarithm = log(penetration)
      x = -sqrt(2*(1 - penetration))
      call find_root(equation, 2*least_logarithm, 0.0_dp, .true., x, is_converged, last_step)
      q = exp(x)
   end subroutine find_wave_pressure

   !> See `equation_t`.
   pure subroutine evaluate(self, x, value, slope)
      class(penetration_equation_t), intent(in) :: self
      !> Logarithm of the mean pressure, ln q, < 0.
      real(dp), intent(in) :: x
      !> Value of the equation, 0 at its root.
      real(dp), intent(out) :: value
      !> Derivative of the value with respect to x.
      real(dp), intent(out) :: slope

      value = log(1 - x) + x - self%logarithm
      slope = -x/(1 - x)
   end subroutine evaluate

end module adfric_plane_westergaard
