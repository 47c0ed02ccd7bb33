! SPDX-License-Identifier: GPL-3.0-or-later
!> Heat of a cylinder that slides: the mean temperature of its contact, which the law of friction has.
!>
!> Heat at a point warms the contact in the mean by half of what a uniform band would warm that point if it moved the other way:
!> so the closed form of the band serves every distribution of heat. No heat leaves the surface beside the contact.
module adfric_plane_cylinder_heat
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: unset
   use adfric_interface_friction_law, only: friction_law_t
   use adfric_interface_heat_rows, only: get_heat, h_background, h_interface, h_peak, h_share, heat_t
   use adfric_interface_heat_sources, only: band_temperature, find_largest_temperature, mean_temperature, source_band
   use adfric_interface_thermal_states, only: heated_contact_t
   use adfric_plane_contact_shear, only: contact_nodes, contact_weights, n_contact_nodes
   implicit none (type, external)
   private
   public :: find_cylinder_temperature, peak_of_bands

contains

   !> The temperature of the contact, and the results of heat but that of the bulk.
   pure subroutine find_cylinder_temperature(values, law, velocity, temperature, half_width, pressure, fine_pressure, results, &
         is_valid)
      !> Values of the rows of heat; shape `(n_heat_rows)`.
      real(dp), intent(in) :: values(:)
      type(friction_law_t), intent(in) :: law
      !> Velocity [m/s].
      real(dp), intent(in) :: velocity
      !> In: temperature of the background. Out: mean temperature of the contact [K].
      real(dp), intent(inout) :: temperature
      !> Half-width of the contact [m].
      real(dp), intent(in) :: half_width
      !> Pressure at the nodes of the contact, and in the middles of equal cells, both from -x to x [Pa].
      real(dp), intent(in) :: pressure(:), fine_pressure(:)
      !> Receives the results; shape `(n_heat_results)`.
      real(dp), intent(inout) :: results(:)
      !> Were the states found?
      logical, intent(out) :: is_valid
      type(heat_t) :: heat
      type(heated_contact_t) :: contact
      real(dp) :: x(n_contact_nodes), weights(n_contact_nodes), tractions(n_contact_nodes), fine(size(fine_pressure)), peclet, &
         & unit, slope, position
      integer :: i

      call get_heat(values, unset, heat)
      results(h_background) = 0
      results(h_interface) = 0
      is_valid = .true.
      if (.not. half_width > 0) return
      x = contact_nodes(0.0_dp, 1.0_dp)
      weights = contact_weights()
      peclet = abs(velocity)*half_width/(2*heat%diffusivity)
      unit = abs(velocity)*half_width/heat%conductivity
      contact = heated_contact_t(law=law, speed=abs(velocity), base=temperature, pressure=pressure, weights=0*x)
      if (peclet > 0) then
         do i = 1, n_contact_nodes
            contact%weights(i) = weights(i)/2*band_temperature(peclet, -sign(1.0_dp, velocity)*x(i))
         end do
         ! the sum is known to all digits
         contact%weights = contact%weights*(unit*mean_temperature(source_band, peclet, .false.)/sum(contact%weights))
      end if
      call heat%settle(contact, temperature, results, is_valid)
      if (.not. is_valid) return
      do i = 1, n_contact_nodes
         call law%get_stress(abs(velocity), pressure(i), temperature, tractions(i), slope, is_valid)
      end do
      results(h_interface) = abs(velocity)*half_width*sum(weights*tractions)
      if (.not. results(h_interface) > 0) return
      results(h_share) = 1
      if (law%depends_on_pressure() .or. law%pressure_factor > 0) then
         do i = 1, size(fine)
            call law%get_stress(abs(velocity), fine_pressure(i), temperature, fine(i), slope, is_valid)
         end do
         if (velocity < 0) fine = fine(size(fine):1:-1)
         results(h_peak) = unit*peak_of_bands(peclet, fine)
      else
         call find_largest_temperature(source_band, peclet, position, results(h_peak))
         results(h_peak) = unit*tractions(1)*results(h_peak)
      end if
   end subroutine find_cylinder_temperature

   !> Largest mean temperature of equal cells of a contact of half-width 1 with a flux of their own, in the unit of a flux.
   pure real(dp) function peak_of_bands(peclet, flux) result(peak)
      !> P of the contact [-], > 0.
      real(dp), intent(in) :: peclet
      !> Fluxes from behind to ahead; shape `(n)`.
      real(dp), intent(in) :: flux(:)
      real(dp) :: of_distance(1 - size(flux):size(flux) - 1)
      integer :: i, n

      n = size(flux)
      do i = 1 - n, n - 1
         of_distance(i) = band_temperature(peclet/n, 2.0_dp*i)/n
      end do
      peak = 0
      do i = 1, n
         peak = max(peak, dot_product(flux, of_distance(i - 1:i - n:-1)))
      end do
   end function peak_of_bands

end module adfric_plane_cylinder_heat
