! SPDX-License-Identifier: GPL-3.0-or-later
!> The states of an adhesive wave (`adhesive_wave`) under a load, on each branch (docs/theory/adhesive_wave.md, Proofs: Order).
!>
!> `approach` is the first c with P(c) >= P, which exists for P >= 0, and `adhered` the last with P(c) <= P. After a turn at a load
!> (the approach's state there) the adhered branch is in the zones, if it was at the turn, down to the least load. In the zones,
!> Q = P + sigma phi and cos gamma = cos phi cos alpha make the excess of the range an explicit function of phi. It has one root
!> between the folds, and its slope is 2 load_slope d gamma/d phi.
module adfric_plane_adhesive_wave_load
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_plane_adhesive_wave, only: zones_t, get_zones_of_angle, range_excess, load_slope
   use adfric_plane_adhesive_wave_curve, only: adhesive_wave_t, get_saturated_penetration
   use adfric_plane_adhesive_wave_state, only: wave_adhesion_t, state_of_zones, fill_saturated
   implicit none (type, external)
   private
   public :: state_of_load, was_partial, pull_off_load

   !> Branches: the least and the most adhered state.
   integer, parameter, public :: branch_approach = 0, branch_adhered = 1
   !> A Newton step of this relative size is the last.
   real(dp), parameter :: last_step = 1.0e-9_dp
   integer, parameter :: max_steps = 100

contains

   !> The state under a mean pressure.
   pure subroutine state_of_load(wave, load, branch, state, is_converged, turning_load)
      type(adhesive_wave_t), intent(in) :: wave
      !> P, compression > 0 [p*].
      real(dp), intent(in) :: load
      !> `branch_approach` or `branch_adhered`.
      integer, intent(in) :: branch
      !> The state; `regime_none` where there is no equilibrium.
      type(wave_adhesion_t), intent(out) :: state
      !> Was it found, or is there none?
      logical, intent(out) :: is_converged
      !> Load of the approach's state from which the adhered branch comes, instead of saturation.
      real(dp), intent(in), optional :: turning_load
      type(zones_t) :: zones
      logical :: is_partial

      is_converged = .true.
      is_partial = wave%has_folds
      if (is_partial) is_partial = load >= wave%least_load .and. load <= wave%largest_load
      if (branch == branch_approach) then
         if (load < 0) return
      else if (.not. was_partial(wave, turning_load)) then
         is_partial = is_partial .and. load < wave%saturation_load
         if (.not. is_partial .and. load < wave%saturation_load) return
      else if (load < wave%least_load) then
         return
      end if
      if (is_partial) then
         call find_partial(wave, load, zones, is_converged)
         call state_of_zones(wave, zones, state)
         state%mean_pressure = load
      else
         call saturate(wave, load, state)
      end if
   end subroutine state_of_load

   !> Was the approach's state at a turn partial contact?
   pure logical function was_partial(wave, turning_load)
      type(adhesive_wave_t), intent(in) :: wave
      !> The load at the turn; absent: full contact.
      real(dp), intent(in), optional :: turning_load

      was_partial = .false.
      if (present(turning_load)) was_partial = wave%has_folds .and. turning_load >= 0 .and. turning_load <= wave%largest_load
   end function was_partial

   !> Zones between the folds under a load: Newton's method in phi, with bisection.
   pure subroutine find_partial(wave, load, zones, is_converged)
      type(adhesive_wave_t), intent(in) :: wave
      !> P [p*], from the least to the largest.
      real(dp), intent(in) :: load
      type(zones_t), intent(out) :: zones
      logical, intent(out) :: is_converged
      real(dp) :: low, high, phi, value, slope, step, last
      logical :: is_newton
      integer :: i

      low = max(0.0_dp, -load/wave%sigma)
      high = min(pi/2, (1 - load)/wave%sigma)
      phi = guess_angle(wave, load)
      if (.not. (phi > low .and. phi < high)) phi = low + (high - low)/2
      last = high - low
      is_converged = .false.
      do i = 1, max_steps
         call get_zones_of_angle(phi, load + wave%sigma*phi, zones)
         call get_excess(wave, zones, value, slope)
         if (value < 0) low = phi
         if (value > 0) high = phi
         step = low + (high - low)/2 - phi
         is_newton = slope > 0
         if (is_newton) is_newton = abs(value) < slope*min(high - low, last/2)
         if (is_newton) step = -value/slope
         last = merge(abs(step), high - low, is_newton)
         is_converged = (is_newton .and. abs(step) <= last_step*phi) .or. high - low <= 4*epsilon(phi)*high
         phi = min(max(phi + step, low), high)
         if (is_converged) exit
      end do
      call get_zones_of_angle(phi, load + wave%sigma*phi, zones)
   end subroutine find_partial

   !> What the range of zones is more than eta, and its slope by phi; beyond the folds only the sign, and no slope.
   pure subroutine get_excess(wave, zones, value, slope)
      type(adhesive_wave_t), intent(in) :: wave
      type(zones_t), intent(in) :: zones
      !> The excess.
      real(dp), intent(out) :: value
      !> Its slope under a prescribed load.
      real(dp), intent(out) :: slope

      value = sign(1.0_dp, zones%position - wave%least%position)
      slope = 0
      if (zones%position <= wave%least%position .or. zones%position >= wave%largest%position) return
      value = range_excess(wave%sigma, wave%range, zones)
      slope = 2*load_slope(wave%sigma, zones)*angle_slope(wave%sigma, zones)
   end subroutine get_excess

   !> A first guess of phi, between those of both folds.
   pure real(dp) function guess_angle(wave, load) result(phi)
      type(adhesive_wave_t), intent(in) :: wave
      !> P [p*].
      real(dp), intent(in) :: load
      real(dp) :: share

      share = (load - wave%least_load)/(wave%largest_load - wave%least_load)
      phi = wave%least%phi + sqrt(share)*(wave%largest%phi - wave%least%phi)
   end function guess_angle

   !> d gamma/d phi under a load, (sin phi cos alpha + sigma cos phi/(2 cos alpha))/sin gamma.
   pure real(dp) function angle_slope(sigma, zones)
      !> sigma = 2 S/pi.
      real(dp), intent(in) :: sigma
      type(zones_t), intent(in) :: zones
      real(dp) :: cosine

      cosine = sqrt(1 - zones%square)
      angle_slope = (sin(zones%phi)*cosine + sigma*cos(zones%phi)/(2*cosine))/zones%sine
   end function angle_slope

   !> The saturated or full state under a load.
   pure subroutine saturate(wave, load, state)
      type(adhesive_wave_t), intent(in) :: wave
      !> P [p*], -S at least.
      real(dp), intent(in) :: load
      type(wave_adhesion_t), intent(inout) :: state

      state%mean_pressure = load
      state%square = min(max(load + wave%stress, 0.0_dp), 1.0_dp)
      state%penetration = get_saturated_penetration(state%square)
      call fill_saturated(wave, state)
   end subroutine saturate

   !> The least load of the adhered branch: the minimum of the load, or the end of saturation if this is below.
   pure real(dp) function pull_off_load(wave, turning_load)
      type(adhesive_wave_t), intent(in) :: wave
      !> Load of the approach's state from which the branch comes, instead of saturation.
      real(dp), intent(in), optional :: turning_load

      pull_off_load = wave%saturation_load
      if (was_partial(wave, turning_load)) then
         pull_off_load = wave%least_load
      else if (wave%has_folds) then
         pull_off_load = min(wave%saturation_load, wave%least_load)
      end if
   end function pull_off_load

end module adfric_plane_adhesive_wave_load
