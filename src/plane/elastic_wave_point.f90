! SPDX-License-Identifier: GPL-3.0-or-later
!> One point of `wave_1d` on an elastic half-plane without adhesion, from the values of a namelist to results and profiles.
module adfric_plane_elastic_wave_point
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_unset, only: is_set
   use adfric_interface_conduction_rows, only: conductances, n_conduction_results, n_conduction_rows
   use adfric_plane_contact_conditions, only: largest_violation
   use adfric_plane_wave_variables, only: regime_full, regime_none, regime_partial, in => wave_input, out => wave_output
   use adfric_plane_westergaard, only: wave_half_width, wave_pressure, wave_gap, wave_mean_gap, wave_penetration, &
      & wave_energy, wave_stiffness, find_wave_pressure
   use adfric_solid_contact_modulus, only: contact_modulus_of
   use adfric_describe_status, only: status_solved, status_no_equilibrium, status_not_converged
   implicit none (type, external)
   private
   public :: solve_elastic_wave, get_elastic_wave_profiles, store_wave_conductances

   !> Positions where the conditions of contact are checked, in the contact and beside it.
   integer, parameter :: n_positions = 16

contains

   !> Pressure p* of full contact.
   pure real(dp) function full_pressure(values)
      real(dp), intent(in) :: values(:)

      full_pressure = pi*contact_modulus_of(values(in%contact_modulus:in%second_poisson_ratio)) &
         & *(values(in%amplitude)/values(in%period))
   end function full_pressure

   !> Load, gaps and energy of a point. Beyond full contact the penetration is undefined.
   subroutine solve_elastic_wave(values, results, error_estimate, status)
      real(dp), intent(in) :: values(:)
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the main result [-].
      real(dp), intent(out) :: error_estimate
      !> Status of the point, one of `status_...`.
      integer, intent(out) :: status
      real(dp) :: q, p, d, half_width, x(n_positions), lift
      integer :: i
      logical :: is_converged

      status = status_solved
      error_estimate = epsilon(error_estimate)
      p = full_pressure(values)
      d = values(in%amplitude)
      results(out%full_contact_pressure) = p
      lift = 0
      if (is_set(values(in%mean_pressure))) then
         if (values(in%mean_pressure) < 0) status = status_no_equilibrium
         if (status /= status_solved) return
         q = values(in%mean_pressure)/p
         results([out%mean_pressure, out%penetration]) = [values(in%mean_pressure), d*wave_penetration(q)]
      else
         if (values(in%penetration) > d) status = status_no_equilibrium
         if (status /= status_solved) return
         call find_wave_pressure(values(in%penetration)/d, q, is_converged)
         if (.not. is_converged) status = status_not_converged
         if (status /= status_solved) return
         results([out%mean_pressure, out%penetration]) = [q*p, values(in%penetration)]
         lift = max(0.0_dp, -values(in%penetration))
      end if
      half_width = wave_half_width(q)
      results(out%contact_fraction) = 2*half_width
      results(out%contact_width) = results(out%contact_fraction)*values(in%period)
      results(out%peak_pressure) = p*wave_pressure(q, 0.0_dp)
      results([out%mean_gap, out%largest_gap]) = d*[wave_mean_gap(q), wave_gap(q, 0.5_dp)] + lift
      results([out%adhesion_fraction, out%adhesion_energy, out%hysteresis_loss]) = 0
      results(out%elastic_energy) = p*d*wave_energy(q)
      ! in full contact both are infinite
      if (q < 1) results(out%contact_stiffness) = p/d*wave_stiffness(q)
      call store_wave_conductances(values, q, results)
      results(out%regime) = regime_partial
      if (.not. q > 0) results(out%regime) = regime_none
      if (q >= 1) results(out%regime) = regime_full
      x = [((i - 0.5_dp)/n_positions, i=1, n_positions)]
      associate (positions => [half_width*x, half_width + (0.5_dp - half_width)*x])
         results(out%violation) = largest_violation(wave_pressure(q, positions), wave_gap(q, positions), 1.0_dp, 1.0_dp)
      end associate
   end subroutine solve_elastic_wave

   !> Store the conductances of a contact, which are infinite where it is full.
   pure subroutine store_wave_conductances(values, q, results)
      real(dp), intent(in) :: values(:)
      !> Square of the sine of half the angle of contact, the mean pressure in p* without adhesion [-], >= 0.
      real(dp), intent(in) :: q
      !> Receives the conductances that are wanted; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)

      if (q < 1) call conductances(values(in%conduction(1):in%conduction(n_conduction_rows)), &
         & pi/values(in%period)*wave_stiffness(q), results(out%conductances(1):out%conductances(n_conduction_results)))
   end subroutine store_wave_conductances

   !> Pressure and gap.
   pure subroutine get_elastic_wave_profiles(values, results, x, pressure, gap)
      real(dp), intent(in) :: values(:)
      !> Results of the point; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> Distances from a crest [m]; shape `(n_x)`.
      real(dp), intent(in) :: x(:)
      !> In: all NaN. Out: pressure [Pa] and gap [m], if there is an equilibrium; shape `(n_x)`.
      real(dp), intent(inout) :: pressure(:), gap(:)
      real(dp) :: q, p, lift

      lift = 0
      if (is_set(values(in%penetration))) then
         if (values(in%penetration) > values(in%amplitude)) return
         lift = max(0.0_dp, -values(in%penetration))
      end if
      p = full_pressure(values)
      q = results(out%mean_pressure)/p
      pressure(:) = p*wave_pressure(q, x/values(in%period))
      gap(:) = values(in%amplitude)*wave_gap(q, x/values(in%period)) + lift
   end subroutine get_elastic_wave_profiles

end module adfric_plane_elastic_wave_point
