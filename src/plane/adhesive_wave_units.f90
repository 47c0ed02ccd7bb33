! SPDX-License-Identifier: GPL-3.0-or-later
!> A rigid wave z = D (1 - cos 2 pi x/l) that adheres to an elastic half-plane (`adhesive_wave`), in SI units.
module adfric_plane_adhesive_wave_units
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_plane_adhesive_wave_curve, only: adhesive_wave_t, least_amount, largest_amount
   use adfric_plane_adhesive_wave_events, only: new_adhesive_wave
   use adfric_plane_adhesive_wave_jumps, only: wave_jumps_t, get_jumps
   use adfric_plane_adhesive_wave_load, only: state_of_load, pull_off_load
   use adfric_plane_adhesive_wave_penetration, only: state_of_penetration
   use adfric_plane_adhesive_wave_profile, only: adhesive_wave_pressure, adhesive_wave_gap, adhesive_wave_valley_gap
   use adfric_plane_adhesive_wave_state, only: wave_adhesion_t, regime_none
   implicit none (type, external)
   private
   public :: wave_adhesion_case_t, wave_adhesion_state_t, new_wave_adhesion

   !> What adheres to what, with all events of the curve: it serves any number of loads.
   type :: wave_adhesion_case_t
      !> Length l of the wave [m], its amplitude D [m], and p* = pi E* D/l [Pa].
      real(dp) :: period = 1, amplitude = 1, pressure_unit = 1
      !> The wave in reduced units.
      type(adhesive_wave_t) :: wave
      !> Johnson's alpha, alpha^2 = 2 w l/(pi^2 E* D^2) [-].
      real(dp) :: alpha = 0
      !> Length of a short cohesive zone, pi E* h0/(4 sigma0) [m].
      real(dp) :: zone_length = 0
   contains
      procedure :: solve_pressure
      procedure :: solve_penetration
      procedure :: pull_off_pressure
      procedure :: loop_energy
      procedure :: pressure_at
      procedure :: gap_at
   end type wave_adhesion_case_t

   !> A state.
   type :: wave_adhesion_state_t
      !> One of `regime_...` of `adhesive_wave_state`.
      integer :: regime = regime_none
      !> Shares of the period in contact, and in contact or cohesion [-].
      real(dp) :: contact_fraction = 0, label_fraction = 0
      !> Mean pressure and pressure of the crest [Pa].
      real(dp) :: mean_pressure = 0, crest_pressure = 0
      !> Penetration since first touch of the undeformed surfaces, mean gap, gap of the valley [m].
      real(dp) :: penetration = 0, mean_gap = 0, valley_gap = 0
      !> Energies of the solid and of the attraction per area [J/m^2]; the latter is 0 far apart.
      real(dp) :: elastic_energy = 0, adhesion_energy = 0
      !> The state in reduced units.
      type(wave_adhesion_t) :: state
   end type wave_adhesion_state_t

contains

   !> What adheres to what.
   pure subroutine new_wave_adhesion(self, period, amplitude, contact_modulus, stress, range, is_possible, is_converged)
      type(wave_adhesion_case_t), intent(out) :: self
      !> Length of the wave [m], > 0.
      real(dp), intent(in) :: period
      !> Its amplitude [m], > 0; half of its height.
      real(dp), intent(in) :: amplitude
      !> E* [Pa], > 0.
      real(dp), intent(in) :: contact_modulus
      !> Adhesive stress sigma0 [Pa], > 0.
      real(dp), intent(in) :: stress
      !> Range h0 of the attraction [m], > 0.
      real(dp), intent(in) :: range
      !> Are sigma0/p* and h0/D numbers from 1e-12 to 1e12?
      logical, intent(out) :: is_possible
      logical, intent(out) :: is_converged
      real(dp) :: reduced(2)

      if (has_asserts) call assert(min(period, amplitude, contact_modulus, stress, range) > 0, 'new_wave_adhesion: all > 0')
      self%period = period
      self%amplitude = amplitude
      self%pressure_unit = pi*contact_modulus*(amplitude/period)
      reduced = [stress/self%pressure_unit, range/amplitude]
      self%alpha = sqrt(2*product(reduced)/pi)
      self%zone_length = (pi/4)*(contact_modulus/stress)*range
      is_possible = all(reduced >= least_amount .and. reduced <= largest_amount)
      is_converged = is_possible
      if (is_possible) call new_adhesive_wave(self%wave, reduced(1), reduced(2), is_converged)
   end subroutine new_wave_adhesion

   !> The state under a mean pressure.
   pure subroutine solve_pressure(self, mean_pressure, branch, state, is_converged, turning_pressure)
      class(wave_adhesion_case_t), intent(in) :: self
      !> Mean pressure [Pa], compression > 0.
      real(dp), intent(in) :: mean_pressure
      !> `branch_approach` or `branch_adhered` of `adhesive_wave_load`.
      integer, intent(in) :: branch
      !> The state; `regime_none` where there is no equilibrium.
      type(wave_adhesion_state_t), intent(out) :: state
      !> Was it found, or is there none?
      logical, intent(out) :: is_converged
      !> Mean pressure at which the approach has turned [Pa]; absent: full contact.
      real(dp), intent(in), optional :: turning_pressure

      if (present(turning_pressure)) then
         call state_of_load(self%wave, mean_pressure/self%pressure_unit, branch, state%state, is_converged, &
            & turning_pressure/self%pressure_unit)
      else
         call state_of_load(self%wave, mean_pressure/self%pressure_unit, branch, state%state, is_converged)
      end if
      call give_units(self, state)
   end subroutine solve_pressure

   !> The state at a penetration.
   pure subroutine solve_penetration(self, penetration, branch, state, is_converged, turning_pressure)
      class(wave_adhesion_case_t), intent(in) :: self
      !> Penetration since first touch of the undeformed surfaces [m], at most the amplitude.
      real(dp), intent(in) :: penetration
      !> `branch_approach` or `branch_adhered` of `adhesive_wave_load`.
      integer, intent(in) :: branch
      !> The state; `regime_none` beyond the amplitude.
      type(wave_adhesion_state_t), intent(out) :: state
      !> Was it found, or is there none?
      logical, intent(out) :: is_converged
      !> Mean pressure at which the approach has turned [Pa]; absent: full contact.
      real(dp), intent(in), optional :: turning_pressure

      if (present(turning_pressure)) then
         call state_of_penetration(self%wave, penetration/self%amplitude, branch, state%state, is_converged, &
            & turning_pressure/self%pressure_unit)
      else
         call state_of_penetration(self%wave, penetration/self%amplitude, branch, state%state, is_converged)
      end if
      call give_units(self, state)
   end subroutine solve_penetration

   !> Least mean pressure of the adhered branch [Pa], < 0 as a rule.
   pure real(dp) function pull_off_pressure(self, turning_pressure)
      class(wave_adhesion_case_t), intent(in) :: self
      !> Mean pressure at which the approach has turned [Pa]; absent: full contact.
      real(dp), intent(in), optional :: turning_pressure

      if (present(turning_pressure)) then
         pull_off_pressure = self%pressure_unit*pull_off_load(self%wave, turning_pressure/self%pressure_unit)
      else
         pull_off_pressure = self%pressure_unit*pull_off_load(self%wave)
      end if
   end function pull_off_pressure

   !> Energy per area that a loop of approach and retraction at prescribed penetrations loses [J/m^2].
   pure subroutine loop_energy(self, energy, is_converged)
      class(wave_adhesion_case_t), intent(in) :: self
      real(dp), intent(out) :: energy
      logical, intent(out) :: is_converged
      type(wave_jumps_t) :: jumps

      call get_jumps(self%wave, jumps, is_converged)
      energy = self%pressure_unit*self%amplitude*jumps%total
   end subroutine loop_energy

   !> Give the results of a state their units.
   pure subroutine give_units(self, state)
      type(wave_adhesion_case_t), intent(in) :: self
      !> The state, with its reduced one.
      type(wave_adhesion_state_t), intent(inout) :: state
      real(dp) :: energy

      energy = self%pressure_unit*self%amplitude
      associate (reduced => state%state)
         state%regime = reduced%regime
         if (reduced%regime == regime_none) return
         state%contact_fraction = 2*reduced%contact_half_width
         state%label_fraction = 2*reduced%cohesive_half_width
         state%mean_pressure = self%pressure_unit*reduced%mean_pressure
         state%crest_pressure = self%pressure_unit*adhesive_wave_pressure(self%wave, reduced, 0.0_dp)
         state%penetration = self%amplitude*reduced%penetration
         state%mean_gap = self%amplitude*(1 - reduced%penetration)
         state%valley_gap = self%amplitude*adhesive_wave_valley_gap(self%wave, reduced)
         state%elastic_energy = energy*reduced%elastic_energy
         state%adhesion_energy = energy*reduced%adhesion_energy
      end associate
   end subroutine give_units

   !> Pressure at x [Pa].
   pure real(dp) function pressure_at(self, state, x)
      class(wave_adhesion_case_t), intent(in) :: self
      type(wave_adhesion_state_t), intent(in) :: state
      !> Position along the wave, from a crest [m].
      real(dp), intent(in) :: x

      pressure_at = self%pressure_unit*adhesive_wave_pressure(self%wave, state%state, x/self%period)
   end function pressure_at

   !> Gap at x [m].
   pure real(dp) function gap_at(self, state, x)
      class(wave_adhesion_case_t), intent(in) :: self
      type(wave_adhesion_state_t), intent(in) :: state
      !> Position along the wave, from a crest [m].
      real(dp), intent(in) :: x

      gap_at = self%amplitude*adhesive_wave_gap(self%wave, state%state, x/self%period)
   end function gap_at

end module adfric_plane_adhesive_wave_units
