! SPDX-License-Identifier: GPL-3.0-or-later
!> Partial slip of the model `wave_1d`: what a point finds, in SI units.
module adfric_plane_wave_slip_point
   use adfric_base_kinds, only: dp
   use adfric_plane_wave_slip, only: find_wave_slip, wave_shear, wave_slip_t
   use adfric_plane_wave_variables, only: r_cycle_energy, r_full_contact_pressure, r_mean_pressure, r_stick_fraction, &
      & r_tangential_displacement, r_tangential_stiffness, v_amplitude, v_coefficient, v_contact_modulus, v_period, &
      & v_second_poisson_ratio, v_tangential_stress
   use adfric_interface_coulomb_rows, only: coulomb_t, resolve_coulomb
   implicit none (type, external)
   private
   public :: add_slip, slip_tractions

contains

   !> Add the results of partial slip to those of a solved point. Without contact there are none.
   pure subroutine add_slip(values, results, is_held)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> In: those of the contact. Out: also those of slip; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Does friction hold the force?
      logical, intent(out) :: is_held
      type(coulomb_t) :: friction
      type(wave_slip_t) :: slip
      real(dp) :: tau, unit, stress

      call resolve_coulomb(values(v_tangential_stress:v_coefficient), values(v_contact_modulus:v_second_poisson_ratio), .true., &
         & friction)
      call friction%get_share(results(r_mean_pressure), tau, is_held)
      if (.not. (is_held .and. results(r_mean_pressure) > 0)) return
      stress = results(r_full_contact_pressure)
      call find_wave_slip(results(r_mean_pressure)/stress, tau, slip)
      associate (mu => friction%coefficient, ratio => friction%compliance_ratio(.true.), d => values(v_amplitude))
         unit = mu*ratio*d
         results(r_stick_fraction) = slip%stick
         results(r_tangential_displacement) = sign(unit*slip%displacement, friction%stress)
         results(r_cycle_energy) = mu*stress*unit*slip%energy
         if (slip%compliance > 0) results(r_tangential_stiffness) = stress/(ratio*d*slip%compliance)
         ! at the end the contact that sticks is a point
         if (.not. slip%stick_pressure > 0) results(r_tangential_stiffness) = 0
      end associate
   end subroutine add_slip

   !> Shear tractions of a solved point [Pa].
   pure function slip_tractions(values, results, x) result(tractions)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the point; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> Coordinates along the wave, from a crest [m]; shape `(n_x)`.
      real(dp), intent(in) :: x(:)
      real(dp) :: tractions(size(x)), tau
      type(coulomb_t) :: friction
      logical :: is_held

      call resolve_coulomb(values(v_tangential_stress:v_coefficient), values(v_contact_modulus:v_second_poisson_ratio), .true., &
         & friction)
      call friction%get_share(results(r_mean_pressure), tau, is_held)
      tractions = 0
      if (.not. results(r_mean_pressure) > 0) return
      associate (stress => results(r_full_contact_pressure))
         tractions = sign(friction%coefficient*stress, friction%stress) &
            & *wave_shear(results(r_mean_pressure)/stress, tau, x/values(v_period))
      end associate
   end function slip_tractions

end module adfric_plane_wave_slip_point
