! SPDX-License-Identifier: GPL-3.0-or-later
!> Pressure and gap along an adhesive wave (`adhesive_wave`), psi = pi x.
!>
!> With tau(psi)^2 = tan^2 psi - tan^2 alpha over 1 + tan^2 alpha, which is sin(psi - alpha) sin(psi + alpha)/cos^2 psi and tan^2 phi at
!> the edge of cohesion,
!>
!>     p = 2 cos psi sqrt(sin^2 alpha - sin^2 psi) - sigma arctan[tan phi/sqrt(-tau^2)]    in contact,   -S in cohesion
!>     g = crest gap + Q (sinh 2v - 2v) + 2 sigma int_alpha^psi artanh(tau'/tan phi) d psi',   sin psi = sin alpha cosh v,
!>
!> with the inverse ratio beyond the edge, where the integral starts from g = eta. Up to the trough, psi = pi/2, it is with
!> p = pi/2 - psi, sin e = cos gamma, and cos d = sin p/cos alpha
!>
!>     int artanh(tan phi/tau) d psi = int_phi^(pi/2) ln[sin(d + phi)/cos phi] (dp/dd) dd - (1/2) int_0^2e ln sin x dx + e ln sin e
!>
!> whose parts are smooth but for logarithms that are integrated in closed form; they cancel in short zones.
module adfric_plane_adhesive_wave_profile
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_numerics_gauss, only: nodes => gauss_nodes_10, weights => gauss_weights_10
   use adfric_numerics_double_exponential, only: integrand_t, integrate
   use adfric_plane_adhesive_wave, only: zones_t
   use adfric_plane_adhesive_wave_curve, only: adhesive_wave_t
   use adfric_plane_adhesive_wave_state, only: wave_adhesion_t, regime_none, regime_free, regime_no_contact, regime_zones
   use adfric_plane_westergaard, only: wave_pressure, wave_gap
   implicit none (type, external)
   private
   public :: adhesive_wave_pressure, adhesive_wave_gap, adhesive_wave_valley_gap

   !> Zones from this phi on, of stresses up to this sigma, keep the digits of the gap of the trough.
   real(dp), parameter :: least_phi = 0.05_dp, largest_sigma = 4.0_dp

   !> The integrand of the gap beside the contact.
   type, extends(integrand_t) :: opening_t
      !> alpha, gamma and tan phi.
      real(dp) :: alpha = 0, gamma = 0, tangent = 1
      !> Where the integral starts and ends [rad].
      real(dp) :: start = 0, finish = 0
   contains
      procedure :: evaluate
   end type opening_t

contains

   !> Pressure at x [p*].
   elemental real(dp) function adhesive_wave_pressure(wave, state, x) result(p)
      type(adhesive_wave_t), intent(in) :: wave
      !> A state with a regime other than `regime_none`.
      type(wave_adhesion_t), intent(in) :: state
      !> Position from a crest [l].
      real(dp), intent(in) :: x
      real(dp) :: psi, alpha, square

      psi = pi*abs(x - anint(x))
      p = 0
      select case (state%regime)
      case (regime_none, regime_free)
      case (regime_no_contact, regime_zones)
         alpha = pi*state%contact_half_width
         if (psi <= pi*state%cohesive_half_width) p = -wave%stress
         if (psi >= alpha) return
         square = sin(alpha - psi)*sin(alpha + psi)
         p = 2*cos(psi)*sqrt(square) - wave%sigma*atan(tan(state%zones%phi)*cos(psi)/sqrt(square))
      case default
         p = wave_pressure(state%mean_pressure + wave%stress, x) - wave%stress
      end select
   end function adhesive_wave_pressure

   !> Gap at x [D].
   elemental real(dp) function adhesive_wave_gap(wave, state, x) result(g)
      type(adhesive_wave_t), intent(in) :: wave
      !> A state with a regime other than `regime_none`.
      type(wave_adhesion_t), intent(in) :: state
      !> Position from a crest [l].
      real(dp), intent(in) :: x
      type(opening_t) :: opening
      real(dp) :: psi
      logical :: is_converged

      psi = pi*abs(x - anint(x))
      select case (state%regime)
      case (regime_no_contact, regime_zones)
         g = 0
         opening%alpha = pi*state%contact_half_width
         opening%gamma = pi*state%cohesive_half_width
         opening%tangent = tan(state%zones%phi)
         if (psi <= opening%alpha .and. state%regime == regime_zones) return
         opening%start = merge(opening%alpha, opening%gamma, psi <= opening%gamma)
         opening%finish = psi
         if (psi > opening%start) call integrate(opening, psi - opening%start, g, is_converged)
         g = 2*wave%sigma*g + wave_gap(state%square, x) + state%crest_gap
         if (psi > opening%gamma) g = g + (wave%range - wave_gap(state%square, state%cohesive_half_width) - state%crest_gap)
      case default
         g = wave_gap(state%square, x) + state%crest_gap
      end select
   end function adhesive_wave_gap

   !> Gap of the trough [D].
   pure real(dp) function adhesive_wave_valley_gap(wave, state) result(g)
      type(adhesive_wave_t), intent(in) :: wave
      !> A state with a regime other than `regime_none`.
      type(wave_adhesion_t), intent(in) :: state
      logical :: has_zones

      has_zones = state%regime == regime_no_contact .or. state%regime == regime_zones
      if (has_zones .and. state%zones%phi >= least_phi .and. wave%sigma <= largest_sigma) then
         g = wave%range + wave_gap(state%square, 0.5_dp) - wave_gap(state%square, state%cohesive_half_width) &
            & + 2*wave%sigma*opening_of_valley(state%zones)
      else
         g = adhesive_wave_gap(wave, state, 0.5_dp)
      end if
   end function adhesive_wave_valley_gap

   !> The integral of artanh(tan phi/tau) from the edge of adhesion to the trough, in panels of d that end at phi, 2 phi, 4 phi ...
   pure real(dp) function opening_of_valley(zones) result(opening)
      type(zones_t), intent(in) :: zones
      real(dp) :: d(size(nodes)), x(size(nodes)), low, high, e, logarithms

      e = atan(1/zones%tangent)
      ! ln sin x without its zeros at 0 and pi
      x = e*(1 + nodes)
      logarithms = e*dot_product(weights, log(sin(x)/(x*(pi - x)))) + 2*e*(log(2*e) - 1) + pi*(log(pi) - 1) &
         & - 2*(pi/2 - e)*(log(2*(pi/2 - e)) - 1)
      opening = e*log(zones%cosine) - logarithms/2
      low = zones%phi
      do while (low < pi/2)
         high = min(2*low, pi/2)
         d = low + (high - low)/2*(1 + nodes)
         x = log(sin(d + zones%phi)/cos(zones%phi))*sin(d)
         opening = opening + (high - low)/2*sqrt(1 - zones%square) &
            & *dot_product(weights, x/sqrt(zones%square + (1 - zones%square)*sin(d)**2))
         low = high
      end do
   end function opening_of_valley

   !> See `opening_t`.
   pure real(dp) function evaluate(self, from_left, from_right)
      class(opening_t), intent(in) :: self
      !> Distances from its ends [rad].
      real(dp), intent(in) :: from_left, from_right
      real(dp) :: psi, tau, distance, inside

      psi = self%start + from_left
      ! psi - alpha and gamma - psi without cancellation; a zone of round-off may have alpha > gamma
      inside = from_left + max(0.0_dp, self%start - self%alpha)
      distance = from_right + (self%gamma - self%finish)
      if (self%start >= self%gamma) distance = -from_left
      tau = sqrt(sin(inside)*sin(psi + self%alpha))/cos(psi)
      ! |tan^2 phi - tau^2| = cos^2 alpha sin|gamma - psi| sin(gamma + psi)/(cos gamma cos psi)^2
      evaluate = log((self%tangent + tau)*cos(self%gamma)*cos(psi)/cos(self%alpha)) &
         & - log(abs(sin(distance))*sin(self%gamma + psi))/2
   end function evaluate

end module adfric_plane_adhesive_wave_profile
