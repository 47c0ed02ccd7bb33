! SPDX-License-Identifier: GPL-3.0-or-later
!> Partial slip of the model `wave_1d`: what a point finds, in SI units.
module adfric_plane_wave_slip_point
   use adfric_base_kinds, only: dp
   use adfric_plane_wave_slip, only: find_wave_slip, wave_shear, wave_slip_t
   use adfric_plane_wave_variables, only: in => wave_input, out => wave_output
   use adfric_interface_coulomb_rows, only: coulomb_t, resolve_coulomb
   implicit none (type, external)
   private
   public :: add_slip, slip_tractions

contains

   !> Add the results of partial slip to those of a solved point. Without contact there are none.
   pure subroutine add_slip(values, results, is_sustained)
      real(dp), intent(in) :: values(:)
      !> In: those of the contact. Out: also those of slip; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      logical, intent(out) :: is_sustained
      type(coulomb_t) :: friction
      type(wave_slip_t) :: slip
      real(dp) :: tau, unit, stress

      call resolve_coulomb(values(in%tangential_stress:in%coefficient), values(in%contact_modulus:in%second_poisson_ratio), &
         & .true., &
         & friction)
      call friction%get_share(results(out%mean_pressure), tau, is_sustained)
      if (.not. (is_sustained .and. results(out%mean_pressure) > 0)) return
      stress = results(out%full_contact_pressure)
      call find_wave_slip(results(out%mean_pressure)/stress, tau, slip)
      associate (mu => friction%coefficient, ratio => friction%compliance_ratio(.true.), d => values(in%amplitude))
         unit = mu*ratio*d
         results(out%stick_fraction) = slip%stick
         results(out%tangential_displacement) = sign(unit*slip%displacement, friction%stress)
         results(out%cycle_energy) = mu*stress*unit*slip%energy
         if (slip%compliance > 0) results(out%tangential_stiffness) = stress/(ratio*d*slip%compliance)
         ! at the end the contact that sticks is a point
         if (.not. slip%stick_pressure > 0) results(out%tangential_stiffness) = 0
      end associate
   end subroutine add_slip

   !> Shear tractions of a solved point [Pa].
   pure function slip_tractions(values, results, x) result(tractions)
      real(dp), intent(in) :: values(:)
      !> Results of the point; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> Coordinates along the wave, from a crest [m]; shape `(n_x)`.
      real(dp), intent(in) :: x(:)
      real(dp) :: tractions(size(x)), tau
      type(coulomb_t) :: friction
      logical :: is_sustained

      call resolve_coulomb(values(in%tangential_stress:in%coefficient), values(in%contact_modulus:in%second_poisson_ratio), &
         & .true., &
         & friction)
      call friction%get_share(results(out%mean_pressure), tau, is_sustained)
      tractions = 0
      if (.not. results(out%mean_pressure) > 0) return
      associate (stress => results(out%full_contact_pressure))
         tractions = sign(friction%coefficient*stress, friction%stress) &
            & *wave_shear(results(out%mean_pressure)/stress, tau, x/values(in%period))
      end associate
   end function slip_tractions

end module adfric_plane_wave_slip_point
