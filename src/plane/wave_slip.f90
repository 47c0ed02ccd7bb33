! SPDX-License-Identifier: GPL-3.0-or-later
!> Partial slip of a sinusoidal wave on an elastic half-plane: under a constant mean pressure P a tangential force over nominal area T
!> has grown from 0, up to Coulomb's friction mu P.
!>
!> Reduced as in `adfric_plane_westergaard`: pressures in p*, q that of the load, r = q - T/mu that of the contact which sticks, and
!> displacements in mu m D, m the ratio of the tangential to the normal compliance. With the penetration d(q) = q (1 - ln q), 1 in
!> full contact, x = ln(q/r) for q <= 1,
!>
!>     u = d(q) - d(r) = -(q - r) ln q + r (e^x - 1 - x),      dT/du = 1/(-ln r)
!>     W = 4 int p(q) gap(r) over a wave = 4 q r (sinh x - x)
!>
!> the latter being the energy of a cycle between T and -T in mu^2 m p* D. No term is below 0. Beyond full contact q - 1 is a pressure
!> everywhere, which does not change the displacement: the forms hold with 1 for q, and W has 4 (q - 1) times the mean gap of r besides.
module adfric_plane_wave_slip
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_plane_westergaard, only: wave_half_width, wave_mean_gap, wave_pressure
   use adfric_numerics_hyperbolic, only: sinh_minus_argument
   use adfric_numerics_libm, only: log1p
   implicit none (type, external)
   private
   public :: wave_slip_t, find_wave_slip, wave_shear

   !> Slip of a wave.
   type :: wave_slip_t
      !> Mean pressure of the contact which sticks, in p*.
      real(dp) :: stick_pressure = 0
      !> Share of the area of contact that sticks.
      real(dp) :: stick = 1
      !> Displacement in mu m D, and its slope over T in D m/p*; the latter is 0 where all sticks in full contact.
      real(dp) :: displacement = 0, compliance = 0
      !> Energy of a cycle in mu^2 m p* D.
      real(dp) :: energy = 0
   end type wave_slip_t

contains

   !> The slip under a tangential force.
   pure subroutine find_wave_slip(q, tau, slip)
      !> Mean pressure in p*, > 0.
      real(dp), intent(in) :: q
      !> Tangential force over mu times the load, 0 to 1.
      real(dp), intent(in) :: tau
      type(wave_slip_t), intent(out) :: slip
      real(dp) :: top, fall, x

      associate (r => slip%stick_pressure)
         r = q*(1 - tau)
         if (r >= 1) return
         top = min(q, 1.0_dp)
         ! top - r
         fall = q*tau - (q - top)
         slip%stick = wave_half_width(r)/wave_half_width(q)
         slip%displacement = fall*(1 - log(top))
         slip%compliance = huge(q)
         slip%energy = 2*top**2 + 4*(q - top)
         if (.not. r > 0) return
         x = log(top/r)
         if (2*fall < top) x = -log1p(-fall/top)
         ! e^x - 1 - x
         slip%displacement = -fall*log(top) + r*(sinh_minus_argument(x) + 2*sinh(x/2)**2)
         slip%compliance = x - log(top)
         slip%energy = 4*(top*r*sinh_minus_argument(x) + (q - top)*wave_mean_gap(r))
      end associate
   end subroutine find_wave_slip

   !> Shear traction p(q) - p(r) at a position, in mu p*.
   elemental real(dp) function wave_shear(q, tau, x) result(traction)
      !> Mean pressure in p*, > 0.
      real(dp), intent(in) :: q
      !> Tangential force over mu times the load, 0 to 1.
      real(dp), intent(in) :: tau
      !> Coordinate along the wave, from a crest, in wavelengths [-].
      real(dp), intent(in) :: x
      real(dp) :: outer, inner, r, top

      r = q*(1 - tau)
      traction = q*tau
      if (r >= 1) return
      top = min(q, 1.0_dp)
      outer = wave_pressure(top, x)
      inner = wave_pressure(r, x)
      traction = outer - inner + (q - top)
      ! p^2 = 4 cos(psi)^2 (q - sin(psi)^2)
      if (inner > 0) traction = 4*cos(pi*(x - anint(x)))**2*(q*tau - (q - top))/(outer + inner) + (q - top)
   end function wave_shear

end module adfric_plane_wave_slip
