! SPDX-License-Identifier: GPL-3.0-or-later
!> A state of an adhesive wave (`adhesive_wave`) with its energies.
module adfric_plane_adhesive_wave_state
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_plane_adhesive_wave, only: zones_t, range_excess, open_crest
   use adfric_plane_adhesive_wave_curve, only: adhesive_wave_t
   use adfric_plane_adhesive_wave_integrals, only: get_zone_integrals
   use adfric_plane_westergaard, only: wave_energy
   implicit none (type, external)
   private
   public :: wave_adhesion_t, state_of_zones, fill_saturated, dissipated_energy

   !> Regimes: no equilibrium; out of reach; cohesion without contact; contact, cohesion and free surface; cohesion in the whole gap;
   !> contact everywhere.
   integer, parameter, public :: regime_none = -1, regime_free = 0, regime_no_contact = 1, regime_zones = 2, regime_saturated = 3, &
      & regime_full = 4

   !> A state.
   type :: wave_adhesion_t
      !> One of `regime_...`.
      integer :: regime = regime_none
      !> Half-widths a of contact and c of cohesion [l].
      real(dp) :: contact_half_width = 0, cohesive_half_width = 0
      !> P [p*], delta and the gap of the crest [D].
      real(dp) :: mean_pressure = 0, penetration = 0, crest_gap = 0
      !> Energy of the solid, and of the attraction, which is 0 far apart and -S eta in contact [p* D].
      real(dp) :: elastic_energy = 0, adhesion_energy = 0
      !> Q = sin^2(pi a).
      real(dp) :: square = 0
      !> The zones in regimes `no_contact` and `zones`.
      type(zones_t) :: zones
   end type wave_adhesion_t

contains

   !> The state of zones in equilibrium. Its energies are, by dE = P d delta - sigma gamma d eta + (adhesion/sigma) d sigma,
   !>
   !>     E = Q^2 (1 - 2 ln Q)/4 + E1 + E2,    adhesion = E1 + 2 E2 - 2 sigma M P + 2 sigma^2 gamma K
   !>     E1 = sigma [phi (1 - Q) - 2 Lambda Q phi - m sin gamma cos gamma + 2 gamma (y Q - m sin^2 gamma)]
   !>     E2 = sigma^2 (W - 2 gamma K)
   pure subroutine state_of_zones(wave, zones, state)
      type(adhesive_wave_t), intent(in) :: wave
      type(zones_t), intent(in) :: zones
      type(wave_adhesion_t), intent(out) :: state
      real(dp) :: k, m, w, gamma, e1, e2, energy

      associate (z => zones, q => zones%square, sigma => wave%sigma)
         state%zones = z
         state%square = q
         state%regime = merge(regime_no_contact, regime_zones, z%y >= open_crest)
         state%contact_half_width = half_width(q)
         gamma = atan(z%tangent)
         state%cohesive_half_width = gamma/pi
         state%mean_pressure = q - sigma*z%phi
         if (state%regime == regime_no_contact) state%crest_gap = max(0.0_dp, -range_excess(sigma, wave%range, z))
         call get_zone_integrals(z%tangent, z%m, z%phi, z%distance, k, m, w)
         state%penetration = q*(1 + 2*z%lambda) + 2*sigma*m - state%crest_gap
         e1 = sigma*(z%phi*(1 - q) - 2*z%lambda*q*z%phi - z%m*z%sine*z%cosine + 2*gamma*(z%y*q - z%m*z%sine**2))
         e2 = sigma**2*(w - 2*gamma*k)
         energy = q**2*(1 + 4*z%lambda)/4 + e1 + e2
         state%adhesion_energy = e1 + 2*e2 - 2*sigma*m*state%mean_pressure + 2*sigma**2*gamma*k
         state%elastic_energy = energy - state%adhesion_energy
      end associate
   end subroutine state_of_zones

   !> What follows from Q and delta in saturation.
   pure subroutine fill_saturated(wave, state)
      type(adhesive_wave_t), intent(in) :: wave
      !> The state, with Q and delta.
      type(wave_adhesion_t), intent(inout) :: state

      state%regime = merge(regime_full, regime_saturated, state%square >= 1)
      state%contact_half_width = half_width(state%square)
      state%cohesive_half_width = 0.5_dp
      state%crest_gap = max(0.0_dp, -state%penetration)
      state%elastic_energy = wave_energy(state%square)
      state%adhesion_energy = wave%stress*((1 - state%penetration) - wave%range)
   end subroutine fill_saturated

   !> a of Q.
   pure real(dp) function half_width(square)
      !> Q, 0 to 1.
      real(dp), intent(in) :: square

      ! in zones that all but close Q may be 1 and a bit
      half_width = atan2(sqrt(square), sqrt(max(0.0_dp, 1 - square)))/pi
   end function half_width

   !> Energy lost in a jump at a prescribed penetration [p* D], > 0.
   elemental real(dp) function dissipated_energy(before, after)
      type(wave_adhesion_t), intent(in) :: before, after

      dissipated_energy = (before%elastic_energy - after%elastic_energy) + (before%adhesion_energy - after%adhesion_energy)
   end function dissipated_energy

end module adfric_plane_adhesive_wave_state
