! SPDX-License-Identifier: GPL-3.0-or-later
!> Friction of `surface_sliding` with a law of the interface, as a sum with what the solid loses. The contact is that of frictionless
!> faces: exact on a half-space of Poisson's ratio 1/2.
module adfric_periodic_sliding_interface
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set, unset
   use adfric_interface_friction_law, only: friction_law_t
   use adfric_interface_friction_law_check, only: check_interface
   use adfric_interface_friction_law_rows, only: given_law_t, get_friction_law, has_interface, n_interface_rows, needs_temperature
   use adfric_interface_heat_rows, only: check_heat, doubt_heat, h_background, h_bulk, h_contact, h_interface, has_heat, &
      & n_heat_results, velocity_that_heats
   use adfric_interface_shear_coupling, only: is_coupled
   use adfric_interface_shear_strength_rows, only: p_shear_stress
   use adfric_interface_total_friction, only: coupling_of, doubt_coupling, get_shear_of_area, interface_tractions, &
      & sliding_friction_t
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_solid_spectrum_rows, only: n_spectrum_rows, solid_shift_of
   use adfric_solid_time_temperature, only: shift_none, time_temperature_t
   use adfric_describe_table, only: variable_t
   use adfric_periodic_coupled_kernel, only: coupled_kernel_t, coupling_of_layer, shear_coupling_t
   use adfric_periodic_coupled_losses, only: change_on_cells, heat_of_half_space
   use adfric_periodic_near_contact, only: near_contact_t
   use adfric_periodic_point, only: periodic_surface_t
   use adfric_periodic_viscoelastic_solid, only: viscoelastic_solid_t
   use adfric_periodic_sliding_case, only: poisson_ratio_of_solid
   use adfric_periodic_sliding_heat, only: find_contact_temperature
   use adfric_periodic_law_of_cells, only: get_mean_of_cells
   use adfric_periodic_sliding_slope, only: contact_slope
   use adfric_periodic_sliding_variables, only: base_bonded, s_base, s_coupling, s_friction, s_heat, &
      & s_last_heat, s_temperature, s_thickness, s_velocity, out => sliding_output
   use adfric_periodic_variables, only: periodic_output
   implicit none (type, external)
   private
   public :: has_surface_interface, without_temperature, check_surface_interface, add_surface_interface, set_interface_maps
   public :: add_left_out, doubt_surface_coupling, has_surface_heat, doubt_surface_heat, velocity_that_heats_surface
   public :: wants_velocity_slope

contains

   !> The values of the interface.
   pure function interface_of(values) result(friction)
      !> Values of the rows of the solid; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)
      real(dp) :: friction(n_interface_rows)

      friction = values(s_friction:s_friction + n_interface_rows - 1)
   end function interface_of

   !> Is there friction of the interface?
   pure logical function has_surface_interface(values)
      !> Values of the rows of the solid; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)

      has_surface_interface = has_interface(interface_of(values))
   end function has_surface_interface

   !> Does heat count?
   pure logical function has_surface_heat(values)
      !> Values of the rows of the solid; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)

      has_surface_heat = has_heat(values(s_heat:s_last_heat))
   end function has_surface_heat

   !> The law of the interface.
   pure subroutine law_of_surface(values, spectrum, given, law)
      !> Values of the rows of the solid, which have been checked; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: spectrum
      type(given_law_t), intent(in) :: given
      type(friction_law_t), intent(out) :: law

      call get_friction_law(interface_of(values), given, solid_shift_of(values(:n_spectrum_rows), spectrum), law)
   end subroutine law_of_surface

   !> The values without a temperature that is for the interface alone.
   pure function without_temperature(values, spectrum) result(of_solid)
      !> Values of the rows of the solid; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: spectrum
      real(dp) :: of_solid(size(values))
      type(time_temperature_t) :: shift

      of_solid = values
      shift = solid_shift_of(values(:n_spectrum_rows), spectrum)
      if (shift%law == shift_none .and. (needs_temperature(interface_of(values)) .or. has_surface_heat(values))) &
         & of_solid(s_temperature) = unset
   end function without_temperature

   !> Add to `problems` what is wrong with the friction of the interface.
   subroutine check_surface_interface(rows, values, spectrum, given, tension, problems)
      !> Rows of the solid; their names stand in the messages.
      type(variable_t), intent(in) :: rows(:)
      !> Values of the rows; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: spectrum
      type(given_law_t), intent(in) :: given
      !> Largest tension in contact, that of adhesion [Pa].
      real(dp), intent(in) :: tension
      type(problems_t), intent(inout) :: problems
      integer :: k

      call check_heat(rows, values, s_heat, s_temperature, has_surface_interface(values), values(s_thickness), .false., problems)
      if (.not. has_surface_interface(values)) return
      call check_interface(rows, values, [(k, k=s_friction, s_friction + n_interface_rows - 1)], [s_temperature, s_velocity], &
         & given, solid_shift_of(values(:n_spectrum_rows), spectrum), tension, problems)
   end subroutine check_surface_interface

   !> Add the interface to the friction of a point, and its heat.
   subroutine add_surface_interface(values, spectrum, given, tension, surface, pressure, is_contact, near, results, flash, &
      & is_valid)
      !> Values of the rows of the solid; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: spectrum
      type(given_law_t), intent(in) :: given
      !> Tension of adhesion in contact, and outside of it over nominal area [Pa]; 0 without adhesion.
      real(dp), intent(in) :: tension(2)
      !> Periods and cells of the surface [m], and its solid.
      type(periodic_surface_t), intent(in) :: surface
      !> Pressure in the cells, below 0 where adhesion pulls [Pa], and where the faces touch; shape `(nx, ny)`.
      real(dp), intent(in) :: pressure(:, :)
      logical, intent(in) :: is_contact(:, :)
      !> Contacts at velocities a little off; not allocated: not known.
      type(near_contact_t), allocatable, intent(in) :: near(:)
      !> In: results of the frictionless contact. Out: with both parts of the friction; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Receives with heat the flash temperatures [K]; shape `(nx, ny)`.
      real(dp), allocatable, intent(out) :: flash(:, :)
      !> Does the law hold at this velocity and temperature, and is that of the contact known?
      logical, intent(out) :: is_valid
      type(friction_law_t) :: law
      type(sliding_friction_t) :: friction
      real(dp) :: carried, temperature

      is_valid = .true.
      if (.not. has_surface_interface(values)) return
      call law_of_surface(values, spectrum, given, law)
      friction%hysteretic = results(out%friction_stress)
      temperature = values(s_temperature)
      if (has_surface_heat(values)) call find_contact_temperature(values, law, surface, pressure, is_contact, &
         & friction%hysteretic, temperature, results(out%heat(1):out%heat(n_heat_results)), flash, is_valid)
      if (.not. is_valid) return
      associate (area => results(periodic_output%contact_fraction))
         if (law%depends_on_pressure() .and. area > 0) then
            call get_mean_of_cells(law, values(s_velocity), temperature, pressure, is_contact, friction%interfacial, &
               & friction%interfacial_slope, is_valid)
            friction%interfacial = area*friction%interfacial
            friction%interfacial_slope = area*friction%interfacial_slope
         else
            carried = results(periodic_output%mean_pressure) + tension(2)
            call get_shear_of_area(law, values(s_velocity), temperature, area, carried, friction%interfacial, &
               & friction%interfacial_slope, is_valid)
         end if
      end associate
      if (.not. is_valid) return
      if (has_surface_heat(values)) results(out%heat(h_interface)) = values(s_velocity)*friction%interfacial
      friction%contact_slope = not_a_number()
      if (allocated(near)) then
         select type (solid => surface%solid)
         type is (viscoelastic_solid_t)
            friction%contact_slope = contact_slope(law, values(s_velocity), values(s_temperature), tension(1), &
               & solid, near, friction%hysteretic + friction%interfacial)
         end select
      end if
      call friction%store(values(s_velocity), results(periodic_output%mean_pressure), results(out%friction_stress), &
         & results(out%friction_coefficient), results(out%hysteretic_friction_stress:out%velocity_slope))
      if (.not. (has_surface_heat(values) .and. law%is_coulomb())) return
      select type (solid => surface%solid)
      type is (viscoelastic_solid_t)
         call share_heat(values, law, solid, pressure, surface%period, results)
      end select
   end subroutine add_surface_interface

   !> Is the slope over the velocity to be found? With heat the contact has another temperature at another velocity.
   pure logical function wants_velocity_slope(values)
      !> Values of the rows of the solid; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)

      wants_velocity_slope = has_surface_interface(values) .and. .not. has_surface_heat(values)
      if (wants_velocity_slope) wants_velocity_slope = values(s_velocity) > 0
   end function wants_velocity_slope

   !> Share the heat of a shear stress that is proportional to the pressure: a part of its work is lost in the solid.
   subroutine share_heat(values, law, solid, pressure, period, results)
      !> Values of the rows of the solid; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)
      type(friction_law_t), intent(in) :: law
      type(viscoelastic_solid_t), intent(in) :: solid
      !> Pressure in the cells [Pa]; shape `(nx, ny)`.
      real(dp), intent(in), contiguous :: pressure(:, :)
      !> Periods along x and y [m].
      real(dp), intent(in) :: period(2)
      !> In: with the friction, and the heat of pressure and slip. Out: with that of solid and interface; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      type(coupled_kernel_t) :: kernel
      real(dp) :: losses

      ! what a layer loses by shear stress is not known
      if (is_set(values(s_thickness))) return
      kernel%coupling%friction_coefficient = law%pressure_factor
      kernel%coupling%direction = solid%motion%direction()
      ! along a line it counts for nothing
      if (is_set(poisson_ratio_of_solid(values))) then
         kernel%coupling%poisson_ratio = poisson_ratio_of_solid(values)
      else if (size(pressure, 2) > 1) then
         return
      end if
      allocate (kernel%solid, source=solid%kernel)
      losses = heat_of_half_space(kernel, pressure, period/period(1))/solid%modulus
      results(out%heat(h_bulk)) = values(s_velocity)*losses
      results(out%heat(h_interface)) = values(s_velocity)*results(out%friction_stress) - results(out%heat(h_bulk))
   end subroutine share_heat

   !> Set the map of the shear stress, and with heat that of the temperature.
   subroutine set_interface_maps(values, spectrum, given, results, maps)
      !> Values of the rows of the solid; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: spectrum
      type(given_law_t), intent(in) :: given
      !> Results of the point; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> In: pressure [Pa], gap [m] and flashes [K]. Out: with shear stress [Pa] and temperature [K]; shape `(nx, ny, n_profiles)`.
      real(dp), intent(inout) :: maps(:, :, :)
      type(friction_law_t) :: law

      call law_of_surface(values, spectrum, given, law)
      maps(:, :, p_shear_stress) = interface_tractions(law, values(s_velocity), temperature_of(values, results), maps(:, :, 1), &
         & .not. maps(:, :, 2) > 0)
      if (size(maps, 3) > p_shear_stress) maps(:, :, p_shear_stress + 1) = maps(:, :, p_shear_stress + 1) &
         & + values(s_temperature) + results(out%heat(h_background))
   end subroutine set_interface_maps

   !> Temperature of the contact [K]: with heat that of the slip.
   pure real(dp) function temperature_of(values, results) result(temperature)
      !> Values of the rows of the solid; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)
      !> Results of the point; shape `(n_results)`.
      real(dp), intent(in) :: results(:)

      temperature = values(s_temperature)
      if (has_surface_heat(values) .and. .not. ieee_is_nan(results(out%heat(h_contact)))) temperature = results(out%heat(h_contact))
   end function temperature_of

   !> A line on the velocity above which heat matters; nothing without heat.
   subroutine doubt_surface_heat(values, spectrum, given, half_width, text)
      !> Values of the rows of the solid; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: spectrum
      type(given_law_t), intent(in) :: given
      !> Half-width of a contact [m].
      real(dp), intent(in) :: half_width
      character(:), allocatable, intent(out) :: text
      type(friction_law_t) :: law

      text = ''
      if (.not. has_surface_heat(values)) return
      call law_of_surface(values, spectrum, given, law)
      call doubt_heat(values(s_heat:s_last_heat), law, values(s_temperature), half_width, text)
   end subroutine doubt_surface_heat

   !> Velocity from which on heat matters [m/s], or unset.
   real(dp) function velocity_that_heats_surface(values, spectrum, given, half_width) result(velocity)
      !> Values of the rows of the solid; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: spectrum
      type(given_law_t), intent(in) :: given
      !> Half-width of a contact [m].
      real(dp), intent(in) :: half_width
      type(friction_law_t) :: law

      velocity = unset
      if (.not. has_surface_interface(values)) return
      call law_of_surface(values, spectrum, given, law)
      velocity = velocity_that_heats(values(s_heat:s_last_heat), law, values(s_temperature), half_width)
   end function velocity_that_heats_surface

   !> Add the change of the friction by a coupling that is left out, where Poisson's ratio is known.
   subroutine add_left_out(values, spectrum, given, solid, pressure, is_contact, period, results)
      !> Values of the rows of the solid; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: spectrum
      type(given_law_t), intent(in) :: given
      type(viscoelastic_solid_t), intent(in) :: solid
      !> Pressure in the cells, below 0 where adhesion pulls [Pa], and where the faces touch; shape `(nx, ny)`.
      real(dp), intent(in), contiguous :: pressure(:, :)
      logical, intent(in) :: is_contact(:, :)
      !> Periods along x and y [m].
      real(dp), intent(in) :: period(2)
      !> In: with the friction. Out: with what is left out; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      type(shear_coupling_t) :: coupling
      type(friction_law_t) :: law
      real(dp), allocatable :: shear(:, :)

      if (.not. has_surface_interface(values) .or. is_coupled(values(s_coupling))) return
      if (.not. (is_set(poisson_ratio_of_solid(values)) .and. abs(results(out%friction_stress)) > 0)) return
      coupling%friction_coefficient = 1
      coupling%poisson_ratio = poisson_ratio_of_solid(values)
      coupling%direction = solid%motion%direction()
      if (is_set(values(s_thickness))) then
         ! a base that slips cannot carry the shear stress
         if (nint(values(s_base)) /= base_bonded) return
         coupling%thickness = values(s_thickness)/period(1)
      end if
      ! an incompressible half-space has none, and most rubber is one
      if (.not. (coupling%thickness > 0 .or. abs(coupling_of(coupling%poisson_ratio)) > 0)) then
         results(out%coupling_left_out) = 0
         return
      end if
      call law_of_surface(values, spectrum, given, law)
      allocate (shear, mold=pressure)
      shear(:, :) = interface_tractions(law, values(s_velocity), temperature_of(values, results), pressure, is_contact)
      results(out%coupling_left_out) = change_on_cells(solid%kernel, coupling, pressure, shear, period/period(1), .false.) &
         & /solid%modulus/abs(results(out%friction_stress))
   end subroutine add_left_out

   !> A line on the shear stress that would move the contact; nothing where it does not.
   function doubt_surface_coupling(values, period) result(text)
      !> Values of the rows of the solid; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)
      !> Period of the surface [m].
      real(dp), intent(in) :: period
      character(:), allocatable :: text
      character(250) :: line
      real(dp) :: poisson_ratio

      text = ''
      if (.not. has_surface_interface(values) .or. is_coupled(values(s_coupling))) return
      poisson_ratio = poisson_ratio_of_solid(values)
      if (.not. is_set(values(s_thickness))) then
         text = doubt_coupling(poisson_ratio)
      else if (nint(values(s_base)) == base_bonded) then
         write (line, '(a, f7.3, a)') 'shear stress moves the contact on a bonded layer: for the longest wave by m =', &
            & coupling_of_layer(poisson_ratio, two_pi*values(s_thickness)/period), &
            & ' times mu; coupling_left_out is how much is left out'
         text = trim(line)//new_line('a')
      else
         text = 'a layer that slips on its base cannot carry the shear stress there: something else has to keep it in place' &
            & //new_line('a')
      end if
   end function doubt_surface_coupling

end module adfric_periodic_sliding_interface
