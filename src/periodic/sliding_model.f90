! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `surface_sliding`: a rigid periodic surface, a wave or given heights, that slides steadily over a viscoelastic half-space
!> or layer, with adhesion or without.
!>
!> The frame moves with the body, in which all is steady. Friction is the pressure on the slopes, and pays for the energy that is lost
!> in the solid (`adfric_periodic_friction`). The file is long by its answers to `periodic_model_t`, one procedure each.
module adfric_periodic_sliding_model
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_interface_friction_law_rows, only: given_law_t, take_law_attribute, take_law_table
   use adfric_interface_shear_strength_rows, only: n_shear_rows, p_shear_stress, shear_profiles
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_interface_adhesion_rows, only: adhesion_law_t
   use adfric_interface_attraction_rows, only: given_attraction_t, has_attraction, resolve_attraction
   use adfric_solid_spectrum_rows, only: take_spectrum, take_spectrum_attribute, describe_spectrum, n_spectrum_rows
   use adfric_describe_derived, only: derived_t
   use adfric_describe_doubt, only: doubt_slope_too_steep
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_table, only: profile_axis_t, profile_t, variable_t
   use adfric_periodic_adhesion_cells, only: are_sizes_possible, doubt_zone, sees_pull_off, tension_outside
   use adfric_periodic_adhesive_solver, only: adhesion_in_units
   use adfric_periodic_given_heights, only: given_heights_t
   use adfric_periodic_model, only: periodic_model_t
   use adfric_periodic_near_contact, only: near_contact_t, near_steps
   use adfric_periodic_point, only: periodic_surface_t, periodic_solid_t, periodic_goal_t
   use adfric_periodic_sliding_case, only: set_sliding_solid
   use adfric_periodic_sliding_check, only: check_pull, check_sliding_surface, check_sliding_solid
   use adfric_periodic_sliding_description, only: derive_surface, doubt_one_contact, doubt_surface, slope_of_surface
   use adfric_periodic_sliding_interface, only: add_left_out, add_surface_interface, doubt_surface_heat, has_surface_heat, &
      & has_surface_interface, set_interface_maps, velocity_that_heats_surface, wants_velocity_slope
   use adfric_periodic_sliding_results, only: set_sliding_results, peak_of_wave
   use adfric_periodic_chords, only: chord_fraction
   use adfric_periodic_sliding_variables, only: attraction_values, cells_of, get_sliding_results, kind_heights, kind_wave_1d, &
      & kind_wave_2d, n_solid_rows, n_surface_rows, s_friction, s_last_adhesion, s_other_branch, &
      & s_pull_off, s_thickness, &
      & set_solid_rows, set_surface_rows, &
      & in => sliding_input, out => sliding_output
   use adfric_periodic_solver, only: periodic_solution_t
   use adfric_periodic_variables, only: is_wanted, contact => periodic_output
   use adfric_periodic_viscoelastic_solid, only: viscoelastic_solid_t
   use adfric_periodic_wave_cells, only: set_wave
   use adfric_periodic_wave_contact, only: wave_pressure_of_full_contact, mean_pressure_at, &
      & set_full_contact, wave_friction_of_full_contact
   implicit none (type, external)
   private
   public :: sliding_model_t, new_sliding_model

   !> The model `surface_sliding`.
   type, extends(periodic_model_t) :: sliding_model_t
      private
      !> Heights of the input.
      type(given_heights_t) :: heights
      !> Lists and master curve of the input.
      type(given_spectrum_t) :: spectrum
      !> Table of the law of the interface.
      type(given_law_t) :: given_law
      !> Table of the law of attraction.
      type(given_attraction_t) :: given_attraction
   contains
      procedure :: take_dataset
      procedure :: take_attribute
      procedure :: check_surface
      procedure :: check_solid
      procedure :: get_cells
      procedure :: get_shape
      procedure :: set_solid
      procedure :: get_full_pressure
      procedure :: get_peak_pressure
      procedure :: solve_in_closed_form
      procedure :: set_interface
      procedure :: finish_point
      procedure :: derive_solid
      procedure :: describe_case
      procedure :: describe_doubts
      procedure :: velocity_of_heat
      procedure :: measure
      procedure, private :: adhesion_of
      procedure, private :: height_of
      procedure :: count_profiles
      procedure :: fill_profiles
   end type sliding_model_t

contains

   !> The model with its tables.
   subroutine new_sliding_model(self)
      !> The new model; receives its tables.
      type(sliding_model_t), intent(out) :: self
      type(variable_t) :: surface(n_surface_rows), solid(n_solid_rows)

      call set_surface_rows(surface)
      call set_solid_rows(solid)
      call self%set_tables(name='surface_sliding', surface=surface, solid=solid, may_pull=.true., &
         & summary='a rigid rough surface or wave that slides over a viscoelastic half-space or layer: friction, area and pressure')
      self%references = 'S. C. Hunter, J. Appl. Mech. 28 (1961) 611; B. N. J. Persson, J. Chem. Phys. 115 (2001) 3840'
      self%results = get_sliding_results()
      self%profiles = sliding_profiles()
   end subroutine new_sliding_model

   !> The profiles: those of a contact with friction, and the temperature. Row by row: gfortran loses the texts of an array that is
   !> put together.
   function sliding_profiles() result(p)
      type(profile_t) :: p(p_shear_stress + 1)

      p(:p_shear_stress) = shear_profiles()
      p(p_shear_stress + 1) = profile_t(name='temperature', unit='K', &
         & long_name='temperature of the surface of the solid, with flashes')
   end function sliding_profiles

   !> See `model_t`.
   subroutine take_dataset(self, index, values, problems)
      class(sliding_model_t), intent(inout) :: self
      !> Index of the dataset in `variables`.
      integer, intent(in) :: index
      !> Its values; shape `(n_last, n_first)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      if (index == in%heights) then
         call self%heights%take(self%variables(index), values, problems)
      else
         call take_spectrum(self%spectrum, index - self%first_of_solid + 1, values)
         call take_law_table(self%given_law, law_row(self, index), values)
         call self%given_attraction%take(index - (self%first_of_solid + s_last_adhesion - 1), values)
      end if
   end subroutine take_dataset

   !> See `model_t`.
   subroutine take_attribute(self, index, name, value, problems)
      !> The model, which keeps the temperature of the master curve.
      class(sliding_model_t), intent(inout) :: self
      integer, intent(in) :: index
      !> Name of the attribute.
      character(*), intent(in) :: name
      !> Its value in SI units.
      real(dp), intent(in) :: value
      type(problems_t), intent(inout) :: problems

      call take_spectrum_attribute(self%spectrum, self%variables(index), index - self%first_of_solid + 1, name, value, problems)
      call take_law_attribute(self%given_law, self%variables(index), law_row(self, index), name, value, problems)
   end subroutine take_attribute

   !> Index among the rows of the law.
   pure integer function law_row(self, index)
      class(sliding_model_t), intent(in) :: self
      !> Index in `variables`.
      integer, intent(in) :: index

      law_row = index - (self%first_of_solid + s_friction + n_shear_rows - 2)
   end function law_row

   !> See `periodic_model_t`.
   subroutine check_surface(self, values, is_swept, problems)
      !> The model with its heights; its tables give the variables their names.
      class(sliding_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout) :: problems

      call check_sliding_surface(self%variables, values, self%heights, is_swept, self%wants_profiles(values), problems)
   end subroutine check_surface

   !> See `periodic_model_t`.
   subroutine check_solid(self, values, is_swept, problems)
      !> The model with its spectrum; its tables give the variables their names.
      class(sliding_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout) :: problems
      type(periodic_surface_t) :: surface
      type(adhesion_law_t) :: law
      logical :: is_adhesive

      associate (first => self%first_of_solid, last => self%last_of_solid)
         call check_sliding_solid(self%variables(first:last), values(first:last), &
            & values(merge(in%length_x, in%period, is_set(values(in%length_x)))), self%spectrum, self%given_law, &
            & self%given_attraction, is_swept(first:last), problems)
      end associate
      is_adhesive = has_attraction(attraction_values(values(self%first_of_solid:self%last_of_solid)))
      associate (before => self%first_of_solid - 1)
         if (.not. is_adhesive) call check_pull(self%variables, values, self%before_prescribed, &
            & before + [s_pull_off, s_other_branch], problems)
      end associate
      if (problems%count() > 0 .or. .not. is_adhesive) return
      law = self%adhesion_of(values)
      call self%get_cells(values, surface)
      call self%set_solid(values, surface)
      if (.not. are_sizes_possible(law, self%height_of(values), surface)) call problems%add('adhesion', &
         & 'stress', 'or its range is too small or too large for the surface: stress/(E0 height/period) and range/height are ' &
         & //'1e-12 to 1e12')
   end subroutine check_solid

   !> See `periodic_model_t`.
   subroutine get_cells(self, values, surface)
      class(sliding_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Receives the periods and the cells.
      type(periodic_surface_t), intent(inout) :: surface

      if (nint(values(in%kind)) == kind_heights) then
         call self%heights%get_cells(values(in%heights:in%rms_height), surface)
      else
         surface%period = values(in%period)
         surface%n_cells = cells_of(values)
         if (nint(values(in%kind)) == kind_wave_1d) surface%n_cells(2) = 1
      end if
   end subroutine get_cells

   !> See `periodic_model_t`.
   subroutine get_shape(self, values, shape)
      class(sliding_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Receives the gap of the undeformed surfaces; that of heights is not copied again [m].
      real(dp), allocatable, intent(inout) :: shape(:, :)

      if (nint(values(in%kind)) == kind_heights) then
         call self%heights%get_shape(values(in%heights:in%rms_height), shape)
      else
         associate (n => cells_of(values))
            call set_wave(values(in%amplitude), n, [n, merge(1, n, nint(values(in%kind)) == kind_wave_1d)], shape)
         end associate
      end if
   end subroutine get_shape

   !> See `periodic_model_t`.
   subroutine set_solid(self, values, surface)
      class(sliding_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> In: with periods and cells. Out: also with `solid`.
      type(periodic_surface_t), intent(inout) :: surface

      associate (first => self%first_of_solid, last => self%last_of_solid)
         call set_sliding_solid(values(first:last), values(in%direction), self%spectrum, surface)
      end associate
   end subroutine set_solid

   !> See `periodic_model_t`: of a wave in closed form, of heights that of the cells as they are.
   pure real(dp) function get_full_pressure(self, values, solid, on_cells)
      class(sliding_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> The solid of the point.
      class(periodic_solid_t), intent(in) :: solid
      !> Pressure of full contact of the surface as its cells have it [E0].
      real(dp), intent(in) :: on_cells

      get_full_pressure = solid%modulus*on_cells
      if (nint(values(in%kind)) == kind_heights) return
      select type (solid)
      type is (viscoelastic_solid_t)
         get_full_pressure = solid%modulus*pressure_of_wave(values, solid)
      end select
      associate (unused => self)
      end associate
   end function get_full_pressure

   !> Pressure of full contact of a wave [E0].
   pure real(dp) function pressure_of_wave(values, solid) result(pressure)
      real(dp), intent(in) :: values(:)
      type(viscoelastic_solid_t), intent(in) :: solid

      pressure = wave_pressure_of_full_contact(solid, values(in%amplitude)/values(in%period), nint(values(in%kind)) == kind_wave_2d)
   end function pressure_of_wave

   !> See `periodic_model_t`: that of the cells, of a wave with a parabola between them.
   real(dp) function get_peak_pressure(self, values, pressure)
      class(sliding_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Pressure in the middles of the cells; shape `(nx, ny)`.
      real(dp), intent(in) :: pressure(:, :)

      if (nint(values(in%kind)) == kind_heights) then
         get_peak_pressure = maxval(pressure)
      else
         get_peak_pressure = peak_of_wave(pressure)
      end if
      associate (unused => self)
      end associate
   end function get_peak_pressure

   !> See `periodic_model_t`: a wave in full contact, which adhesion leaves as it is.
   subroutine solve_in_closed_form(self, values, surface, goal, solution, is_known)
      class(sliding_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Periods and undeformed gap of the surface [m], and its solid.
      type(periodic_surface_t), intent(in) :: surface
      !> What is prescribed at the point.
      type(periodic_goal_t), intent(in) :: goal
      !> Receives the solution if it is known; lengths in m, pressures in E0.
      type(periodic_solution_t), intent(inout) :: solution
      !> Is the solution known?
      logical, intent(out) :: is_known
      real(dp) :: pressure

      is_known = .false.
      if (nint(values(in%kind)) == kind_heights) return
      select type (solid => surface%solid)
      type is (viscoelastic_solid_t)
         pressure = goal%value
         if (.not. goal%is_pressure) pressure = mean_pressure_at(goal%value, solid, values(in%amplitude), values(in%period), &
            & nint(values(in%kind)) == kind_wave_2d)
         ! pull-off and the other branch are those of the cells
         is_known = pressure >= pressure_of_wave(values, solid) .and. .not. (goal%wants_pull_off .or. goal%wants_other_branch)
         if (is_known) call set_full_contact(solid, surface%shape, values(in%amplitude), values(in%period), pressure, solution)
      end select
      associate (unused => self)
      end associate
   end subroutine solve_in_closed_form

   !> See `periodic_model_t`.
   subroutine set_interface(self, values, surface, goal)
      class(sliding_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Periods and cells of the surface [m], and its solid.
      type(periodic_surface_t), intent(in) :: surface
      !> What is prescribed at the point; receives adhesion.
      type(periodic_goal_t), intent(inout) :: goal
      type(adhesion_law_t) :: law

      goal%wants_near = wants_velocity_slope(values(self%first_of_solid:self%last_of_solid))
      law = self%adhesion_of(values)
      if (allocated(goal%adhesion)) deallocate (goal%adhesion)
      if (.not. law%stress > 0) return
      goal%adhesion = adhesion_in_units(law, surface%solid%modulus)
      goal%wants_pull_off = is_wanted(values(self%first_of_solid + s_pull_off - 1)) .and. sees_pull_off(law, surface)
      goal%wants_other_branch = is_wanted(values(self%first_of_solid + s_other_branch - 1))
   end subroutine set_interface

   !> Adhesion of a point, whose values have been checked.
   pure type(adhesion_law_t) function adhesion_of(self, values) result(law)
      class(sliding_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      call resolve_attraction(attraction_values(values(self%first_of_solid:self%last_of_solid)), self%given_attraction, law)
   end function adhesion_of

   !> Range of the undeformed gap [m].
   pure real(dp) function height_of(self, values) result(height)
      class(sliding_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      select case (nint(values(in%kind)))
      case (kind_heights)
         height = self%heights%factor_of(values(in%heights:in%rms_height))*maxval(self%heights%depths)
      case (kind_wave_1d)
         height = 2*values(in%amplitude)
      case default
         height = 4*values(in%amplitude)
      end select
   end function height_of

   !> See `periodic_model_t`: friction, and its error.
   subroutine finish_point(self, values, surface, solution, results, error_estimate)
      class(sliding_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(periodic_surface_t), intent(in) :: surface
      !> Solution of the point; lengths in m, pressures in E0.
      type(periodic_solution_t), intent(inout) :: solution
      !> In: with the results that all these models have. Out: with all; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the friction [-]; where there is none, that of the area.
      real(dp), intent(out) :: error_estimate
      type(adhesion_law_t) :: law
      logical :: is_valid

      error_estimate = 0
      law = self%adhesion_of(values)
      select type (solid => surface%solid)
      type is (viscoelastic_solid_t)
         call set_sliding_results(values, law, surface, solid, solution, results, error_estimate)
         results(out%smooth_fraction) = chord_fraction(solution%pressure, solution%gap, surface%cell_sizes(), surface%is_quarter)
      end select
      if (allocated(solution%near) .and. nint(values(in%kind)) /= kind_heights) call set_near_losses(values, surface, results, &
         & solution%near)
      call add_surface_interface(values(self%first_of_solid:self%last_of_solid), self%spectrum, self%given_law, &
         & [law%stress, tension_outside(law, solution)], surface, solution%pressure*surface%solid%modulus, &
         & .not. solution%gap > 0, solution%near, results, solution%flash, is_valid)
      select type (solid => surface%solid)
      type is (viscoelastic_solid_t)
         if (is_valid) call add_left_out(values(self%first_of_solid:self%last_of_solid), self%spectrum, self%given_law, solid, &
            & solution%pressure*solid%modulus, .not. solution%gap > 0, surface%period, results)
      end select
      ! so large an error is that of a point which is not solved
      if (.not. is_valid) error_estimate = huge(error_estimate)
   end subroutine finish_point

   !> Set the losses of a wave in full contact, which are those of the wave and not those of its cells.
   subroutine set_near_losses(values, surface, results, near)
      real(dp), intent(in) :: values(:)
      type(periodic_surface_t), intent(in) :: surface
      !> Results of the point; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> In: contacts on the cells at velocities a little off. Out: of full contact, with the loss of the wave.
      type(near_contact_t), intent(inout) :: near(:)
      type(viscoelastic_solid_t) :: other
      integer :: k

      if (.not. results(contact%mean_pressure) >= results(contact%full_contact_pressure)) return
      select type (solid => surface%solid)
      type is (viscoelastic_solid_t)
         other = solid
         do k = 1, size(near)
            other%motion%velocity = solid%motion%velocity*exp(near_steps(k))
            near(k)%loss = solid%motion%direction()*wave_friction_of_full_contact(other, values(in%amplitude)/values(in%period), &
               & nint(values(in%kind)) == kind_wave_2d)
         end do
      end select
   end subroutine set_near_losses

   !> See `model_t`: the shear stress belongs to friction of the interface, the temperature to heat.
   pure integer function count_profiles(self, values)
      class(sliding_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      count_profiles = merge(p_shear_stress, p_shear_stress - 1, &
         & has_surface_interface(values(self%first_of_solid:self%last_of_solid)))
      if (has_surface_heat(values(self%first_of_solid:self%last_of_solid))) count_profiles = size(self%profiles)
   end function count_profiles

   !> See `pointwise_model_t`: the maps of pressure and gap, with friction of the interface that of its shear stress, and with heat that
   !> of the temperature.
   subroutine fill_profiles(self, values, results, state, axes, profiles)
      class(sliding_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Results of the point; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> What `solve_point` has left.
      class(point_state_t), allocatable, intent(in) :: state
      !> Axes of the maps.
      type(profile_axis_t), intent(in) :: axes(:)
      !> Receives the maps of pressure [Pa], gap [m], shear stress [Pa] and temperature [K]; shape `(nx, ny, n_profiles)`.
      real(dp), intent(inout) :: profiles(:, :, :)

      call self%fill_contact_maps(values, results, state, axes, profiles)
      if (size(profiles, 3) >= p_shear_stress) call set_interface_maps(values(self%first_of_solid:self%last_of_solid), &
         & self%spectrum, self%given_law, results, profiles)
   end subroutine fill_profiles

   !> See `periodic_model_t`: moduli and shift factor, the frequencies of the surface, and the cells of a wave.
   function derive_solid(self, values, surface) result(derived)
      class(sliding_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> The surface, not used here.
      type(periodic_surface_t), intent(in) :: surface
      type(derived_t), allocatable :: derived(:)

      call derive_surface(derived, values, values(self%first_of_solid:self%last_of_solid), self%spectrum, surface, &
         & self%adhesion_of(values))
   end function derive_solid

   !> See `model_t`: the arms, and what is not estimated.
   function describe_case(self, values) result(text)
      class(sliding_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = describe_spectrum(values(self%first_of_solid:self%first_of_solid + n_spectrum_rows - 1), self%spectrum)
      if (nint(values(in%kind)) == kind_heights) text = text//self%heights%describe(.true.)
   end function describe_case

   !> See `model_t`: edges that do not meet, a solid that loses nothing, frequencies beyond the master curve.
   function describe_doubts(self, values) result(text)
      class(sliding_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text, of_heat
      type(periodic_surface_t) :: surface
      type(adhesion_law_t) :: law

      call self%get_cells(values, surface)
      text = doubt_surface(values, values(self%first_of_solid:self%last_of_solid), self%spectrum, self%heights, surface)
      ! a contact is at most as wide as half of the period
      call doubt_surface_heat(values(self%first_of_solid:self%last_of_solid), self%spectrum, self%given_law, surface%period(1)/4, &
         & of_heat)
      text = text//of_heat
      call self%set_solid(values, surface)
      text = text//doubt_one_contact(surface)
      law = self%adhesion_of(values)
      if (law%stress > 0) text = text//doubt_zone(law, surface)
   end function describe_doubts

   !> See `model_t`: in contacts of half of the period.
   real(dp) function velocity_of_heat(self, values) result(velocity)
      class(sliding_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(periodic_surface_t) :: surface

      call self%get_cells(values, surface)
      velocity = velocity_that_heats_surface(values(self%first_of_solid:self%last_of_solid), self%spectrum, self%given_law, &
         & surface%period(1)/4)
   end function velocity_of_heat

   !> See `model_t`: the steepest slope of waves, the mean one of heights.
   subroutine measure(self, values, results, measures)
      class(sliding_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Results of the point, NaN where they are not known; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> In: all `not_measured`. Out: with what is measured; shape `(n_doubts)`.
      real(dp), intent(inout) :: measures(:)

      measures(doubt_slope_too_steep) = slope_of_surface(values, self%heights)
      associate (unused => results)
      end associate
   end subroutine measure

end module adfric_periodic_sliding_model
