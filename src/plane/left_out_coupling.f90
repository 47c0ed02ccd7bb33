! SPDX-License-Identifier: GPL-3.0-or-later
!> What a wave or a cylinder leaves out where the shear stress of its interface does not move the contact: the change of the friction
!> to first order.
module adfric_plane_left_out_coupling
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_interface_friction_law, only: friction_law_t
   use adfric_interface_shear_coupling, only: change_by_coupling
   use adfric_plane_contact_shear, only: integrate_over_contact, n_contact_nodes
   use adfric_solid_prony, only: prony_t
   implicit none (type, external)
   private
   public :: left_out_of_line, modulus_of_contact

contains

   !> Change of the friction over the friction [-], without a sign of the velocity; NaN without Poisson's ratio or friction.
   pure function left_out_of_line(law, speed, temperature, pressure, half_width, period, poisson_ratio, modulus, friction, &
      & tension) result(change)
      type(friction_law_t), intent(in) :: law
      !> Speed [m/s], and temperature [K].
      real(dp), intent(in) :: speed, temperature
      !> Pressure at the nodes of the contact [Pa]; shape `(n_contact_nodes)`.
      real(dp), intent(in) :: pressure(:)
      !> Half-width of the contact, and the period, or 0 of a single contact [m].
      real(dp), intent(in) :: half_width, period
      !> Poisson's ratio [-], or unset, and contact modulus [Pa].
      real(dp), intent(in) :: poisson_ratio, modulus
      !> The friction, over nominal area or per length [Pa, or N/m].
      real(dp), intent(in) :: friction
      !> Tension of adhesion outside contact, over nominal area [Pa]; none if absent.
      real(dp), intent(in), optional :: tension
      real(dp) :: change, shear(n_contact_nodes), slope, means(3)
      logical :: is_valid
      integer :: i

      change = not_a_number()
      if (.not. abs(friction) > 0) return
      do i = 1, n_contact_nodes
         call law%get_stress(speed, pressure(i), temperature, shear(i), slope, is_valid)
         if (.not. is_valid) return
      end do
      means = [integrate_over_contact(half_width, pressure*shear), 0.0_dp, 0.0_dp]
      if (period > 0) means = [means(1), integrate_over_contact(half_width, pressure), &
         & integrate_over_contact(half_width, shear)]/period
      if (present(tension)) means(2) = means(2) - tension
      change = change_by_coupling(poisson_ratio, modulus, means(1), means(2), means(3), .true.)/abs(friction)
   end function left_out_of_line

   !> Inverse of the storage compliance at the frequency with which a contact passes [Pa].
   pure real(dp) function modulus_of_contact(prony, speed, half_width) result(modulus)
      !> Spectrum of contact moduli [Pa, s].
      type(prony_t), intent(in) :: prony
      !> Speed with the factor of the times [m/s], and half-width [m].
      real(dp), intent(in) :: speed, half_width
      real(dp) :: storage, loss

      modulus = prony%relaxed
      if (.not. half_width > 0) return
      call prony%get_complex_modulus(pi*speed/(2*half_width), storage, loss)
      modulus = storage + loss*(loss/storage)
   end function modulus_of_contact

end module adfric_plane_left_out_coupling
