! SPDX-License-Identifier: GPL-3.0-or-later
!> Heat of a periodic surface that slides: the temperature of its contact, which the law of friction has, and the map of it.
!>
!> Heat of the interface is made where it rubs, and makes flashes. That of the losses in the solid is made below, and counts for
!> the background alone. The relaxation times of the solid have the given temperature: what a flash heats is thinner than what is
!> dented.
module adfric_periodic_sliding_heat
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_base_not_a_number, only: not_a_number
   use adfric_interface_friction_law, only: friction_law_t
   use adfric_interface_heat_rows, only: get_heat, h_background, h_bulk, h_flash, h_interface, h_peak, h_share, heat_t
   use adfric_interface_thermal_states, only: heated_contact_t
   use adfric_interface_total_friction, only: interface_tractions
   use adfric_periodic_flash_cells, only: flash_cells_t, heated_bodies_t, new_flash_cells
   use adfric_periodic_point, only: periodic_surface_t
   use adfric_periodic_sliding_variables, only: s_heat, s_last_heat, s_temperature, s_thickness, s_velocity
   use adfric_periodic_viscoelastic_solid, only: viscoelastic_solid_t
   use adfric_base_unset, only: is_set
   implicit none (type, external)
   private
   public :: find_contact_temperature

contains

   !> The temperature of the contact, all results of heat, and the map of flashes.
   subroutine find_contact_temperature(values, law, surface, pressure, is_contact, losses, temperature, results, rise, is_valid)
      !> Values of the rows of the solid; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)
      type(friction_law_t), intent(in) :: law
      !> Periods and cells of the surface [m], and the solid with the direction of the motion.
      type(periodic_surface_t), intent(in) :: surface
      !> Pressure in the cells, below 0 where adhesion pulls [Pa], and where the faces touch; shape `(nx, ny)`.
      real(dp), intent(in) :: pressure(:, :)
      logical, intent(in) :: is_contact(:, :)
      !> Friction of the losses in the solid, over nominal area [Pa].
      real(dp), intent(in) :: losses
      !> Mean temperature of the contact [K].
      real(dp), intent(out) :: temperature
      !> Receives the results; shape `(n_heat_results)`.
      real(dp), intent(out) :: results(:)
      !> Receives the flash temperatures of the surface of the solid [K]; shape `(nx, ny)`.
      real(dp), allocatable, intent(out) :: rise(:, :)
      !> Were the states and the partition of the heat found?
      logical, intent(out) :: is_valid
      type(flash_cells_t) :: flash
      type(heat_t) :: heat
      type(heated_contact_t) :: contact
      real(dp), allocatable :: weights(:, :), tractions(:, :)

      results = not_a_number()
      allocate (rise(size(pressure, 1), size(pressure, 2)), source=0.0_dp)
      temperature = values(s_temperature)
      call get_heat(values(s_heat:s_last_heat), values(s_thickness), heat)
      associate (speed => values(s_velocity))
         is_valid = .true.
         results([h_bulk, h_background]) = speed*losses*[1.0_dp, heat%background]
         temperature = temperature + results(h_background)
         results(h_interface) = 0
         if (.not. any(is_contact)) return
         allocate (weights, source=rise)
         if (speed > 0) call set_flash(heat, values, surface, flash, is_valid)
         if (speed > 0 .and. is_valid) call flash%get_weights(is_contact, weights, is_valid)
         if (.not. is_valid) return
         contact = heated_contact_t(law=law, speed=speed, base=temperature, pressure=pack(pressure, is_contact), &
            & weights=speed*(pack(weights, is_contact) + heat%background/size(is_contact)))
         call heat%settle(contact, temperature, results, is_valid)
         if (.not. is_valid) return
         allocate (tractions, mold=weights)
         tractions(:, :) = interface_tractions(law, speed, temperature, pressure, is_contact)
         results(h_interface) = speed*sum(tractions)/size(tractions)
         results(h_background) = results(h_background) + heat%background*results(h_interface)
         results(h_flash) = speed*sum(weights*tractions)
         if (.not. results(h_interface) > 0) return
         call flash%get_temperature(is_contact, speed*tractions, rise, results(h_share), is_valid)
         results(h_peak) = maxval(rise)
      end associate
   end subroutine find_contact_temperature

   !> The waves of the surface.
   subroutine set_flash(heat, values, surface, flash, is_valid)
      type(heat_t), intent(in) :: heat
      real(dp), intent(in) :: values(:)
      type(periodic_surface_t), intent(in) :: surface
      type(flash_cells_t), intent(out) :: flash
      !> Is there memory for them?
      logical, intent(out) :: is_valid
      type(heated_bodies_t) :: bodies
      type(error_t), allocatable :: error

      bodies = heated_bodies_t(conductivity=heat%conductivity, diffusivity=heat%diffusivity, &
         & second_conductivity=heat%second_conductivity)
      if (is_set(values(s_thickness))) bodies%thickness = values(s_thickness)
      select type (solid => surface%solid)
      type is (viscoelastic_solid_t)
         bodies%velocity = values(s_velocity)*solid%motion%direction()
      end select
      call new_flash_cells(flash, bodies, surface%n_cells, surface%period, error)
      is_valid = .not. allocated(error)
   end subroutine set_flash

end module adfric_periodic_sliding_heat
