! SPDX-License-Identifier: GPL-3.0-or-later
!> One point of `wave_1d` on an elastic half-plane without adhesion, from the values of a namelist to results and profiles.
module adfric_plane_elastic_wave_point
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_unset, only: is_set
   use adfric_plane_contact_conditions, only: largest_violation
   use adfric_plane_wave_variables, only: v_amplitude, v_contact_modulus, v_mean_pressure, v_penetration, v_period, &
      & v_second_poisson_ratio, r_adhesion_energy, r_adhesion_fraction, r_contact_fraction, r_contact_width, r_elastic_energy, &
      & r_full_contact_pressure, r_hysteresis_loss, r_largest_gap, r_mean_gap, r_mean_pressure, r_peak_pressure, r_penetration, &
      & r_regime, r_violation, regime_full, regime_none, regime_partial
   use adfric_plane_westergaard, only: wave_half_width, wave_pressure, wave_gap, wave_mean_gap, wave_penetration, &
      & wave_energy, find_wave_pressure
   use adfric_solid_contact_modulus, only: contact_modulus_of
   use adfric_describe_status, only: status_solved, status_no_equilibrium, status_not_converged
   implicit none (type, external)
   private
   public :: solve_elastic_wave, get_elastic_wave_profiles

   !> Places where the conditions of contact are checked, in the contact and beside it.
   integer, parameter :: n_places = 16

contains

   !> Pressure p* of full contact.
   pure real(dp) function full_pressure(values)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      full_pressure = pi*contact_modulus_of(values(v_contact_modulus:v_second_poisson_ratio))*(values(v_amplitude)/values(v_period))
   end function full_pressure

   !> Load, gaps and energy of a point. Beyond full contact the penetration is undefined.
   subroutine solve_elastic_wave(values, results, error_estimate, status)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the main result [-].
      real(dp), intent(out) :: error_estimate
      !> Status of the point, one of `status_...`.
      integer, intent(out) :: status
      real(dp) :: q, p, d, half_width, x(n_places), lift
      integer :: i
      logical :: is_converged

      status = status_solved
      error_estimate = epsilon(error_estimate)
      p = full_pressure(values)
      d = values(v_amplitude)
      results(r_full_contact_pressure) = p
      lift = 0
      if (is_set(values(v_mean_pressure))) then
         if (values(v_mean_pressure) < 0) status = status_no_equilibrium
         if (status /= status_solved) return
         q = values(v_mean_pressure)/p
         results([r_mean_pressure, r_penetration]) = [values(v_mean_pressure), d*wave_penetration(q)]
      else
         if (values(v_penetration) > d) status = status_no_equilibrium
         if (status /= status_solved) return
         call find_wave_pressure(values(v_penetration)/d, q, is_converged)
         if (.not. is_converged) status = status_not_converged
         if (status /= status_solved) return
         results([r_mean_pressure, r_penetration]) = [q*p, values(v_penetration)]
         lift = max(0.0_dp, -values(v_penetration))
      end if
      half_width = wave_half_width(q)
      results(r_contact_fraction) = 2*half_width
      results(r_contact_width) = results(r_contact_fraction)*values(v_period)
      results(r_peak_pressure) = p*wave_pressure(q, 0.0_dp)
      results([r_mean_gap, r_largest_gap]) = d*[wave_mean_gap(q), wave_gap(q, 0.5_dp)] + lift
      results([r_adhesion_fraction, r_adhesion_energy, r_hysteresis_loss]) = 0
      results(r_elastic_energy) = p*d*wave_energy(q)
      results(r_regime) = regime_partial
      if (.not. q > 0) results(r_regime) = regime_none
      if (q >= 1) results(r_regime) = regime_full
      x = [((i - 0.5_dp)/n_places, i=1, n_places)]
      associate (places => [half_width*x, half_width + (0.5_dp - half_width)*x])
         results(r_violation) = largest_violation(wave_pressure(q, places), wave_gap(q, places), 1.0_dp, 1.0_dp)
      end associate
   end subroutine solve_elastic_wave

   !> Pressure and gap.
   pure subroutine get_elastic_wave_profiles(values, results, x, pressure, gap)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the point; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> Distances from a crest [m]; shape `(n_x)`.
      real(dp), intent(in) :: x(:)
      !> In: all NaN. Out: pressure [Pa] and gap [m], if there is an equilibrium; shape `(n_x)`.
      real(dp), intent(inout) :: pressure(:), gap(:)
      real(dp) :: q, p, lift

      lift = 0
      if (is_set(values(v_penetration))) then
         if (values(v_penetration) > values(v_amplitude)) return
         lift = max(0.0_dp, -values(v_penetration))
      end if
      p = full_pressure(values)
      q = results(r_mean_pressure)/p
      pressure(:) = p*wave_pressure(q, x/values(v_period))
      gap(:) = values(v_amplitude)*wave_gap(q, x/values(v_period)) + lift
   end subroutine get_elastic_wave_profiles

end module adfric_plane_elastic_wave_point
