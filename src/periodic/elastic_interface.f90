! SPDX-License-Identifier: GPL-3.0-or-later
!> Friction of elastic surfaces by a law of velocity and temperature. Its rows stand behind that of the pull-off, the last one of those
!> of the solid before there were such laws, and behind them temperature and velocity.
module adfric_periodic_elastic_interface
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_interface_friction_law, only: friction_law_t
   use adfric_interface_friction_law_check, only: check_interface
   use adfric_interface_friction_law_rows, only: given_law_t, get_friction_law, has_interface, has_law_of_speed, &
      & i_pressure_volume, n_law_rows, needs_temperature, set_law_rows
   use adfric_interface_shear_strength_rows, only: get_friction_of_area, n_shear_rows, shear_stress
   use adfric_interface_total_friction, only: coupling_of, get_shear_of_area, interface_tractions
   use adfric_solid_time_temperature, only: time_temperature_t
   use adfric_describe_rows, only: above_zero, number
   use adfric_describe_table, only: variable_t
   use adfric_periodic_coupled_kernel, only: shear_coupling_t
   use adfric_periodic_coupled_losses, only: change_on_cells
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_law_of_cells, only: get_mean_of_cells
   use adfric_periodic_point, only: periodic_surface_t
   use adfric_periodic_solver, only: periodic_solution_t
   use adfric_periodic_variables, only: out => periodic_output
   implicit none (type, external)
   private
   public :: set_motion_rows, check_elastic_friction, has_friction, has_law, store_friction, store_left_out, tractions_of_friction
   public :: n_motion_rows, n_friction_rows

   !> Rows behind that of the pull-off, and all from the shear strength on, with that of the pull-off.
   integer, parameter :: n_motion_rows = n_law_rows + 2, n_friction_rows = n_shear_rows + 1 + n_motion_rows
   !> Indices among them: those of the interface, temperature, and velocity.
   integer, parameter :: of_interface(n_shear_rows + n_law_rows) = [counting(:n_shear_rows), &
      & counting(n_shear_rows + 2:n_shear_rows + 1 + n_law_rows)]
   integer, parameter :: temperature = n_friction_rows - 1, velocity = n_friction_rows

contains

   !> The rows of the law, the temperature and the velocity.
   subroutine set_motion_rows(rows)
      !> Receives the rows; shape `(n_motion_rows)`.
      type(variable_t), intent(out) :: rows(:)

      call set_law_rows(rows(:n_law_rows))
      rows(n_law_rows + 1) = above_zero(group='operating', name='temperature', unit='K', &
         & meaning='temperature of the interface, for laws of friction that depend on it')
      rows(n_motion_rows) = number(group='operating', name='velocity', unit='m/s', &
         & meaning='sliding velocity, for laws of friction that depend on it')
   end subroutine set_motion_rows

   !> Is there friction of the interface?
   pure logical function has_friction(values)
      !> Values of the rows; shape `(n_friction_rows)`.
      real(dp), intent(in) :: values(:)

      has_friction = has_interface(values(of_interface))
   end function has_friction

   !> Is there a law of the velocity?
   pure logical function has_law(values)
      !> Values of the rows; shape `(n_friction_rows)`.
      real(dp), intent(in) :: values(:)

      has_law = has_law_of_speed(values(of_interface))
   end function has_law

   !> Add to `problems` what is wrong with the friction of the interface.
   subroutine check_elastic_friction(rows, values, given, tension, problems)
      type(variable_t), intent(in) :: rows(:)
      !> Values of the rows; shape `(n_friction_rows)`.
      real(dp), intent(in) :: values(:)
      type(given_law_t), intent(in) :: given
      !> Largest tension in contact, that of adhesion [Pa].
      real(dp), intent(in) :: tension
      type(problems_t), intent(inout) :: problems
      type(time_temperature_t) :: none

      if (has_interface(values(of_interface))) call check_interface(rows, values, of_interface, [temperature, velocity], given, &
         & none, tension, problems)
      if (is_set(values(velocity)) .and. .not. has_law(values)) call problems%add(rows(velocity)%group, rows(velocity)%name, &
         & 'has no meaning without a law of the velocity in &friction; over an elastic solid nothing else rubs')
      if (is_set(values(temperature)) .and. .not. needs_temperature(values(of_interface))) call problems%add( &
         & rows(temperature)%group, rows(temperature)%name, 'has no meaning for this law of friction without shift')
      associate (row => of_interface(i_pressure_volume))
         if (tension > 0 .and. is_set(values(row))) call problems%add(rows(row)%group, rows(row)%name, &
            & 'stands beside &adhesion; over the tension at its edges the law is not integrated')
      end associate
   end subroutine check_elastic_friction

   !> Friction of a shear strength, or by a law of the velocity.
   pure subroutine store_friction(values, given, tension, pressure, results, is_valid)
      !> Values of the rows; shape `(n_friction_rows)`.
      real(dp), intent(in) :: values(:)
      type(given_law_t), intent(in) :: given
      !> Tension of adhesion outside contact, over nominal area [Pa].
      real(dp), intent(in) :: tension
      !> Pressure in the cells [Pa]; shape `(nx, ny)`.
      real(dp), intent(in) :: pressure(:, :)
      !> In: with the results of the contact; without an area that varies smoothly there is no friction of it. Out: with friction;
      !> shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Does the law hold at this velocity and temperature?
      logical, intent(out) :: is_valid
      real(dp) :: unused

      is_valid = .true.
      if (has_law(values)) then
         associate (load => results(out%mean_pressure) + tension)
            if (.not. ieee_is_nan(results(out%smooth_fraction))) call get_law_friction(values, given, &
               & results(out%smooth_fraction), load, pressure, results(out%smooth_friction), unused, is_valid)
            call get_law_friction(values, given, results(out%contact_fraction), load, pressure, results(out%friction_stress), &
               & results(out%velocity_slope), is_valid)
         end associate
         if (.not. abs(values(velocity)) > 0) results(out%velocity_slope) = not_a_number()
         if (results(out%mean_pressure) > 0) results(out%friction_coefficient) = results(out%friction_stress) &
            & /results(out%mean_pressure)
      else
         call get_friction_of_area(values(:n_shear_rows), results(out%contact_fraction), results(out%mean_pressure), tension, &
            & results(out%friction_stress), results(out%friction_coefficient))
         if (ieee_is_nan(results(out%smooth_fraction))) return
         call get_friction_of_area(values(:n_shear_rows), results(out%smooth_fraction), results(out%mean_pressure), tension, &
            & results(out%smooth_friction), unused)
      end if
   end subroutine store_friction

   !> Friction over nominal area by a law of the velocity.
   pure subroutine get_law_friction(values, given, area, load, pressure, stress, slope, is_valid)
      !> Values of the rows; shape `(n_friction_rows)`.
      real(dp), intent(in) :: values(:)
      type(given_law_t), intent(in) :: given
      !> Share of the nominal area in contact [-], and what contact carries over nominal area [Pa].
      real(dp), intent(in) :: area, load
      !> Pressure in the cells [Pa]; shape `(nx, ny)`.
      real(dp), intent(in) :: pressure(:, :)
      !> Friction with the sign of the velocity [Pa], and d ln T/d ln v.
      real(dp), intent(out) :: stress, slope
      !> Does the law hold at this velocity and temperature?
      logical, intent(out) :: is_valid
      type(friction_law_t) :: law
      type(time_temperature_t) :: none

      call get_friction_law(values(of_interface), given, none, law)
      if (law%depends_on_pressure() .and. area > 0) then
         call get_mean_of_cells(law, abs(values(velocity)), values(temperature), pressure, pressure > 0, stress, slope, is_valid)
         if (.not. is_valid) return
         stress = area*stress
         slope = area*slope
      else
         call get_shear_of_area(law, abs(values(velocity)), values(temperature), area, load, stress, slope, is_valid)
      end if
      if (stress > 0) slope = slope/stress
      stress = sign(1.0_dp, values(velocity))*stress
   end subroutine get_law_friction

   !> Store the change of the friction by a coupling that is left out, of a body that slides along x; nothing without friction.
   subroutine store_left_out(values, given, poisson_ratio, surface, solution, results)
      !> Values of the rows; shape `(n_friction_rows)`.
      real(dp), intent(in) :: values(:)
      type(given_law_t), intent(in) :: given
      !> Poisson's ratio of the half-space below a rigid body [-].
      real(dp), intent(in) :: poisson_ratio
      !> Periods and cells of the surface [m], and its solid.
      type(periodic_surface_t), intent(in) :: surface
      !> Solution of the point; lengths in m, pressures in E*.
      type(periodic_solution_t), intent(in) :: solution
      !> In: with the friction. Out: with what is left out; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      type(elastic_kernel_t) :: kernel
      type(shear_coupling_t) :: coupling
      real(dp), allocatable :: shear(:, :)

      ! without friction it is no number
      if (ieee_is_nan(results(out%friction_stress))) return
      if (.not. abs(results(out%friction_stress)) > 0) return
      ! an incompressible half-space has no coupling
      results(out%coupling_left_out) = 0
      if (.not. abs(coupling_of(poisson_ratio)) > 0) return
      coupling%friction_coefficient = 1
      coupling%poisson_ratio = poisson_ratio
      allocate (shear, mold=solution%pressure)
      shear(:, :) = abs(tractions_of_friction(values, given, surface%solid%modulus*solution%pressure, .not. solution%gap > 0))
      results(out%coupling_left_out) = change_on_cells(kernel, coupling, solution%pressure, shear, &
         & surface%period/surface%period(1), surface%is_quarter)/abs(results(out%friction_stress))
   end subroutine store_left_out

   !> Shear stress of cells [Pa].
   pure function tractions_of_friction(values, given, pressure, is_contact) result(stress)
      !> Values of the rows; shape `(n_friction_rows)`.
      real(dp), intent(in) :: values(:)
      type(given_law_t), intent(in) :: given
      !> Pressure [Pa]; shape `(nx, ny)`.
      real(dp), intent(in) :: pressure(:, :)
      !> Do the surfaces touch? Shape `(nx, ny)`.
      logical, intent(in) :: is_contact(:, :)
      real(dp) :: stress(size(pressure, 1), size(pressure, 2))
      type(friction_law_t) :: law
      type(time_temperature_t) :: none

      if (has_law(values)) then
         call get_friction_law(values(of_interface), given, none, law)
         stress = interface_tractions(law, values(velocity), values(temperature), pressure, is_contact)
      else
         stress = shear_stress(values(:n_shear_rows), pressure, is_contact)
      end if
   end function tractions_of_friction

end module adfric_periodic_elastic_interface
