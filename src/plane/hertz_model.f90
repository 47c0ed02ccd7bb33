! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `hertz`: smooth elastic bodies in contact along a line, on a circle or on an ellipse, without friction or in partial slip
!> (Cattaneo, Mindlin), or rolling (Carter); or a rigid cylinder that slides over a viscoelastic half-plane (Hunter).
!> The file is long by its answers to `pointwise_model_t`.
module adfric_plane_hertz_model
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set, unset
   use adfric_base_not_a_number, only: not_a_number
   use adfric_interface_conduction_rows, only: conductances, n_conduction_results, n_conduction_rows
   use adfric_interface_friction_law_rows, only: has_interface
   use adfric_interface_shear_coupling, only: doubt_left_out
   use adfric_interface_shear_strength_rows, only: n_shear_rows
   use adfric_plane_coupled_cylinder_point, only: coupled_cylinder_point_t, get_coupled_cylinder_profiles, &
      & solve_coupled_cylinder
   use adfric_plane_cylinder_interface, only: add_cylinder_interface, doubt_cylinder_heat, set_cylinder_tractions, &
      & velocity_that_heats_cylinder
   use adfric_plane_ellipse_interface, only: add_ellipse_interface, set_ellipse_tractions
   use adfric_plane_hertz_check, only: check_hertz, is_sliding, get_curvatures, steepest_edge, wants_stresses
   use adfric_plane_hertz_ellipse, only: ellipse_t, ellipse_of_load, ellipse_pressure, ellipse_gap, ellipse_misfit
   use adfric_plane_hertz_line, only: line_contact_t, line_of_load, line_pressure, line_gap, line_misfit
   use adfric_plane_hertz_prescribed, only: line_load, prescribed_ellipse
   use adfric_plane_hertz_slip, only: add_ellipse_slip, add_line_slip, fill_rolling, find_slip, has_slip, hertz_slip_t, &
      & is_rolling, p_shear_stress, p_slip_ratio, slip_profiles, solve_rolling, tractions
   use adfric_plane_hertz_unit, only: add_ellipse_von_mises, add_line_von_mises, find_unit_ellipse, find_unit_line, unit_contact_t
   use adfric_plane_hertz_variables, only: get_hertz_variables, get_hertz_results, kind_line, in => hertz_input, &
      & out => hertz_output
   use adfric_plane_sliding_cylinder_point, only: cylinder_point_t, solve_cylinder, get_cylinder_profiles, &
      & get_cylinder_frequency
   use adfric_plane_viscoelastic_model, only: viscoelastic_model_t
   use adfric_solid_contact_modulus, only: contact_modulus_of, derive_contact_modulus
   use adfric_solid_spectrum_rows, only: derive_spectrum, describe_spectrum, doubt_spectrum
   use adfric_describe_doubt, only: doubt_contact_too_wide
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_derived, only: derived_t
   use adfric_describe_status, only: status_solved, status_no_equilibrium, status_not_converged
   use adfric_describe_table, only: result_t, profile_axis_t, take_units
   implicit none (type, external)
   private
   public :: hertz_model_t, new_hertz_model

   !> The model `hertz`.
   type, extends(viscoelastic_model_t) :: hertz_model_t
   contains
      procedure :: check_case
      procedure :: derive_quantities
      procedure :: describe_case
      procedure :: describe_doubts
      procedure :: velocity_of_heat
      procedure :: describe_results
      procedure :: unit_of
      procedure :: measure
      procedure :: solve_point
      procedure :: count_profiles
      procedure :: fill_profiles
   end type hertz_model_t

   !> Hertz's contact at a point.
   type, extends(point_state_t) :: hertz_state_t
      !> The contact in units of its own; the next point takes it over where it has the same.
      type(unit_contact_t) :: unit_contact
      !> The contact along a line, where it is one.
      type(line_contact_t) :: line
      !> The contact on an ellipse or a circle, where it is one.
      type(ellipse_t) :: ellipse
      !> Curvatures A <= B of the gap of an ellipse [1/m].
      real(dp) :: a = 0, b = 0
      !> Slip, where there is friction.
      type(hertz_slip_t) :: slip
   end type hertz_state_t

contains

   !> The model with its tables.
   subroutine new_hertz_model(self)
      !> The new model; receives its tables.
      type(hertz_model_t), intent(out) :: self

      call self%set_tables(name='hertz', &
         & summary='smooth bodies in contact along a line, a circle or an ellipse; a cylinder sliding on a viscoelastic solid', &
         & variables=get_hertz_variables(), results=get_hertz_results(), profiles=slip_profiles(), axes='y x', is_depth=.false.)
      self%first_material = in%material(1)
      self%first_law = in%friction(n_shear_rows + 1)
      self%references = self%references//'; S. C. Hunter, J. Appl. Mech. 28, 611 (1961); ' &
         & //'R. D. Mindlin, J. Appl. Mech. 16, 259 (1949); F. W. Carter, Proc. R. Soc. Lond. A 112, 151 (1926)'
   end subroutine new_hertz_model

   !> See `model_t`.
   function describe_results(self, values) result(results)
      class(hertz_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(result_t), allocatable :: results(:)

      results = self%results
      if (is_set(values(in%kind))) call take_units(get_hertz_results(nint(values(in%kind)) == kind_line), results)
   end function describe_results

   !> See `model_t`: forces on a line are those per length.
   function unit_of(self, values, index) result(unit)
      class(hertz_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Index of the variable in `variables`.
      integer, intent(in) :: index
      character(:), allocatable :: unit

      unit = self%variables(index)%unit
      if ((index == in%load .or. index == in%tangential_force) .and. is_set(values(in%kind))) &
         & unit = trim(merge('N/m', 'N  ', nint(values(in%kind)) == kind_line))
   end function unit_of

   !> See `model_t`.
   subroutine measure(self, values, results, measures)
      class(hertz_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Results of the point, NaN where they are not known; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> In: all `not_measured`. Out: with what is measured; shape `(n_doubts)`.
      real(dp), intent(inout) :: measures(:)

      if (.not. ieee_is_nan(results(out%half_width))) measures(doubt_contact_too_wide) = steepest_edge(values, &
         & results(out%half_width), results(out%minor), results(out%direction))
      associate (unused => self)
      end associate
   end subroutine measure

   !> See `halfspace_model_t`.
   subroutine check_case(self, values, problems)
      class(hertz_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call check_hertz(self%variables, values, self%given, self%given_law, problems)
   end subroutine check_case

   !> See `model_t`.
   function derive_quantities(self, values) result(list)
      class(hertz_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: list(:)

      if (is_sliding(values)) then
         call derive_spectrum(list, values(in%material(1):in%temperature), self%given)
      else
         list = derive_contact_modulus(self%variables(in%contact_modulus:in%second_poisson_ratio), &
            & values(in%contact_modulus:in%second_poisson_ratio))
      end if
   end function derive_quantities

   !> See `model_t`.
   function describe_case(self, values) result(text)
      class(hertz_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = ''
      if (is_sliding(values)) text = describe_spectrum(values(in%material(1):in%temperature), self%given)
   end function describe_case

   !> See `model_t`.
   function describe_doubts(self, values) result(text)
      class(hertz_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text, of_heat
      class(point_state_t), allocatable :: state
      real(dp) :: frequency, results(size(self%results)), error_estimate, counts(0)
      integer :: status

      text = ''
      if (is_sliding(values)) then
         call get_cylinder_frequency(values, self%given, frequency)
         text = doubt_spectrum(values(in%material(1):in%temperature), self%given, [frequency, frequency])
      end if
      if (.not. has_interface(values(in%friction))) return
      results = not_a_number()
      call self%solve_point(values, state, results, error_estimate, status, counts)
      if (status /= status_solved) return
      text = text//doubt_left_out(results(out%coupling_left_out), error_estimate, &
         & .not. is_sliding(values) .and. nint(values(in%kind)) == kind_line)
      if (nint(values(in%kind)) /= kind_line) return
      call doubt_cylinder_heat(values, self%given, self%given_law, results(out%half_width), of_heat)
      text = text//of_heat
   end function describe_doubts

   !> See `model_t`: of cylinders that lie along each other.
   real(dp) function velocity_of_heat(self, values) result(velocity)
      class(hertz_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      class(point_state_t), allocatable :: state
      real(dp) :: results(size(self%results)), error_estimate, counts(0)
      integer :: status

      velocity = unset
      if (.not. has_interface(values(in%friction)) .or. nint(values(in%kind)) /= kind_line) return
      results = not_a_number()
      call self%solve_point(values, state, results, error_estimate, status, counts)
      if (status == status_solved) velocity = velocity_that_heats_cylinder(values, self%given, self%given_law, &
         & results(out%half_width))
   end function velocity_of_heat

   !> E* [Pa].
   pure real(dp) function modulus_of(values)
      real(dp), intent(in) :: values(:)

      modulus_of = contact_modulus_of(values(in%contact_modulus:in%second_poisson_ratio))
   end function modulus_of

   !> See `pointwise_model_t`.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
      class(hertz_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> What the point before has left; receives what this point leaves.
      class(point_state_t), allocatable, intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the main result [-].
      real(dp), intent(out) :: error_estimate
      !> Status of the point, one of `status_...`.
      integer, intent(out) :: status
      !> These models count nothing; size 0.
      real(dp), intent(inout) :: counts(:)
      real(dp) :: loaded(size(values))
      logical :: is_valid

      status = status_not_converged
      error_estimate = 0
      loaded = values
      if (nint(values(in%kind)) == kind_line) loaded(in%load) = line_load(values)
      if (.not. allocated(state)) then
         if (is_sliding(values)) allocate (cylinder_point_t :: state)
         if (has_interface(values(in%friction)) .and. nint(values(in%kind)) == kind_line .and. .not. allocated(state)) &
            & allocate (coupled_cylinder_point_t :: state)
         if (.not. allocated(state)) allocate (hertz_state_t :: state)
      end if
      select type (state)
      type is (cylinder_point_t)
         call solve_cylinder(values, self%given, state, results, error_estimate, status)
         if (status == status_solved .and. has_interface(values(in%friction))) then
            call add_cylinder_interface(values, self%given, self%given_law, state, results, is_valid)
            if (.not. is_valid) then
               status = status_not_converged
               results(:) = not_a_number()
            end if
         end if
      type is (coupled_cylinder_point_t)
         call solve_coupled_cylinder(loaded, self%given_law, state, results, error_estimate, status)
      type is (hertz_state_t)
         if (nint(values(in%kind)) == kind_line) then
            call solve_line(loaded, state, results, error_estimate, status)
         else
            call solve_ellipse(values, state, results, error_estimate, status)
            if (status == status_solved .and. has_interface(values(in%friction))) then
               call add_ellipse_interface(values, self%given_law, state%ellipse, results, is_valid)
               if (.not. is_valid) then
                  status = status_not_converged
                  results(:) = not_a_number()
               end if
            end if
         end if
      end select
      associate (unused_counts => counts)
      end associate
   end subroutine solve_point

   !> Solve the contact along a line.
   subroutine solve_line(values, state, results, error_estimate, status)
      real(dp), intent(in) :: values(:)
      !> In: the unit contact of the point before. Out: that of this point, and its contact.
      type(hertz_state_t), intent(inout) :: state
      real(dp), intent(inout) :: results(:)
      real(dp), intent(out) :: error_estimate
      integer, intent(out) :: status
      type(line_contact_t) :: reference
      real(dp) :: misfit
      logical :: is_sustained

      status = status_solved
      error_estimate = epsilon(error_estimate)
      state%line = line_of_load(values(in%radius), modulus_of(values), values(in%load))
      if (is_rolling(values)) then
         call solve_rolling(values, values(in%load), state%line, state%slip, results, is_sustained)
         if (.not. is_sustained) status = status_no_equilibrium
         if (.not. is_sustained) return
      else if (has_slip(values)) then
         call find_slip(values, values(in%load), state%line%peak_pressure, .true., state%slip, is_sustained)
         if (.not. is_sustained) status = status_no_equilibrium
         if (.not. is_sustained) return
         if (values(in%load) > 0) call add_line_slip(values, values(in%load), state%slip%share, results)
      end if
      call find_unit_line(values(in%poisson_ratio), state%unit_contact)
      associate (line => state%line, unit_contact => state%unit_contact)
         results([out%load, out%half_width, out%peak_pressure]) = [values(in%load), line%half_width, line%peak_pressure]
         results([out%mean_pressure, out%contact_area]) = [pi/4*line%peak_pressure, 2*line%half_width]
         results([out%shear, out%shear_depth]) = [unit_contact%shear*line%peak_pressure, unit_contact%depth*line%half_width]
         if (wants_stresses(values)) then
            call add_line_von_mises(values(in%poisson_ratio), state%unit_contact)
            reference = line_of_load(values(in%radius), modulus_of(values), 1.0_dp)
            call store_von_mises(values, unit_contact, line%peak_pressure, line%half_width, 2, reference%peak_pressure, results)
         end if
         misfit = line_misfit(line, values(in%load))
         error_estimate = max(error_estimate, misfit)
         results(out%violation) = max(misfit, unit_contact%violation)
      end associate
   end subroutine solve_line

   !> Solve the contact on an ellipse or a circle.
   subroutine solve_ellipse(values, state, results, error_estimate, status)
      real(dp), intent(in) :: values(:)
      type(hertz_state_t), intent(inout) :: state
      real(dp), intent(inout) :: results(:)
      real(dp), intent(out) :: error_estimate
      integer, intent(out) :: status
      type(ellipse_t) :: reference
      real(dp) :: direction, misfit, punch
      logical :: is_sustained

      status = status_no_equilibrium
      error_estimate = epsilon(error_estimate)
      associate (a => state%a, b => state%b, s => state%ellipse, unit_contact => state%unit_contact)
         call get_curvatures(values, a, b, direction)
         if (.not. a > 0) return
         call find_unit_ellipse(a/b, values(in%poisson_ratio), unit_contact)
         status = merge(status_solved, status_not_converged, unit_contact%shape%is_converged)
         if (status /= status_solved) return
         call prescribed_ellipse(values, a, b, unit_contact%shape, s)
         if (has_slip(values)) then
            call find_slip(values, s%load, s%peak_pressure, .false., state%slip, is_sustained)
            if (.not. is_sustained) status = status_no_equilibrium
            if (.not. is_sustained) return
            if (s%minor > 0) call add_ellipse_slip(values, s, state%slip%share, results)
         end if
         results([out%load, out%approach, out%half_width, out%minor]) = [s%load, s%approach, s%major, s%minor]
         results([out%peak_pressure, out%mean_pressure]) = s%peak_pressure*[1.0_dp, 2.0_dp/3]
         results([out%contact_area, out%direction, out%violation]) = [pi*s%major*s%minor, direction, 0.0_dp]
         punch = 0
         if (s%minor > 0) punch = pi*s%major/s%shape%f
         results(out%contact_stiffness) = modulus_of(values)*punch
         call conductances(values(in%conduction(1):in%conduction(n_conduction_rows)), punch, &
            & results(out%conductances(1):out%conductances(n_conduction_results)))
         if (wants_stresses(values)) then
            call add_ellipse_von_mises(values(in%poisson_ratio), unit_contact)
            call ellipse_of_load(a, b, modulus_of(values), 1.0_dp, unit_contact%shape, reference)
            call store_von_mises(values, unit_contact, s%peak_pressure, s%major, 3, reference%peak_pressure, results)
         end if
         if (.not. s%minor > 0) return
         if (is_set(values(in%poisson_ratio))) results([out%shear, out%shear_depth]) = [unit_contact%shear*s%peak_pressure, &
            & unit_contact%depth*s%major]
         misfit = ellipse_misfit(s, a, b, modulus_of(values))
         error_estimate = max(error_estimate, misfit)
         results(out%violation) = max(misfit, unit_contact%violation)
      end associate
   end subroutine solve_ellipse

   !> Store the largest von Mises stress, and the load that makes it the yield strength.
   pure subroutine store_von_mises(values, unit_contact, peak_pressure, half_width, power, pressure_of_one, results)
      real(dp), intent(in) :: values(:)
      !> The contact in units of its own, with its von Mises stress.
      type(unit_contact_t), intent(in) :: unit_contact
      !> Largest pressure [Pa] and half-width [m] of the contact; 0 without contact.
      real(dp), intent(in) :: peak_pressure, half_width
      !> Power of the peak pressure to which the load is proportional, and the peak pressure under a load of 1.
      integer, intent(in) :: power
      real(dp), intent(in) :: pressure_of_one
      !> In: without these results. Out: with them.
      real(dp), intent(inout) :: results(:)

      results(out%von_mises) = unit_contact%von_mises*peak_pressure
      if (peak_pressure > 0) results(out%von_mises_depth) = unit_contact%von_mises_depth*half_width
      if (.not. is_set(values(in%yield_strength))) return
      results(out%yield_ratio) = results(out%von_mises)/values(in%yield_strength)
      results(out%yield_load) = (values(in%yield_strength)/unit_contact%von_mises/pressure_of_one)**power
   end subroutine store_von_mises

   !> See `model_t`: the shear stress belongs to friction, and slip to rolling.
   pure integer function count_profiles(self, values)
      class(hertz_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      count_profiles = merge(p_shear_stress, p_shear_stress - 1, has_slip(values) .or. has_interface(values(in%friction)))
      if (is_rolling(values)) count_profiles = p_slip_ratio
      associate (unused => self)
      end associate
   end function count_profiles

   !> See `pointwise_model_t`. x and y are the axes of the ellipse; a line contact extends along y.
   subroutine fill_profiles(self, values, results, state, axes, profiles)
      class(hertz_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> What `solve_block` found for this point.
      real(dp), intent(in) :: results(:)
      !> The contact of the point.
      class(point_state_t), allocatable, intent(in) :: state
      !> Axes of the profiles, the slowest first.
      type(profile_axis_t), intent(in) :: axes(:)
      !> In: all NaN. Out: profiles of the point; shape `(n_fast, n_slow, n_profiles)`.
      real(dp), intent(inout) :: profiles(:, :, :)
      integer :: j

      select type (state)
      type is (cylinder_point_t)
         do j = 1, size(axes(1)%coordinates)
            call get_cylinder_profiles(state, axes(2)%coordinates, profiles(:, j, 1), profiles(:, j, 2))
            if (size(profiles, 3) == p_shear_stress) call set_cylinder_tractions(values, self%given, self%given_law, results, &
               & profiles(:, j, 1), profiles(:, j, p_shear_stress))
         end do
      type is (coupled_cylinder_point_t)
         call get_coupled_cylinder_profiles(values, self%given_law, state, axes(2)%coordinates, profiles)
      type is (hertz_state_t)
         associate (s => state%ellipse, y => axes(1)%coordinates, x => axes(2)%coordinates)
            do j = 1, size(y)
               if (nint(values(in%kind)) == kind_line) then
                  profiles(:, j, 1) = line_pressure(state%line, x)
                  profiles(:, j, 2) = line_gap(state%line, x)
               else
                  profiles(:, j, 1) = ellipse_pressure(s, x, y(j))
                  profiles(:, j, 2) = ellipse_gap(s, modulus_of(values), x, y(j))
                  if (.not. s%minor > 0) profiles(:, j, 2) = state%a*x**2 + state%b*y(j)**2 - s%approach
               end if
               if (has_interface(values(in%friction))) then
                  call set_ellipse_tractions(values, self%given_law, profiles(:, j, 1), profiles(:, j, p_shear_stress))
               else if (is_rolling(values)) then
                  call fill_rolling(state%slip, state%line, x, profiles(:, j, p_shear_stress), profiles(:, j, p_slip_ratio))
               else if (size(profiles, 3) == p_shear_stress) then
                  call fill_tractions(state, x, y(j), nint(values(in%kind)) == kind_line, profiles(:, j, p_shear_stress))
               end if
            end do
         end associate
      end select
   end subroutine fill_profiles

   !> Shear tractions along a line of x.
   pure subroutine fill_tractions(state, x, y, is_line, traction)
      type(hertz_state_t), intent(in) :: state
      !> Coordinates along the major axis, or across a line [m]; shape `(n_x)`.
      real(dp), intent(in) :: x(:)
      !> Coordinate along the minor axis [m].
      real(dp), intent(in) :: y
      !> Is the contact one along a line?
      logical, intent(in) :: is_line
      !> Receives the tractions [Pa]; shape `(n_x)`.
      real(dp), intent(out) :: traction(:)

      traction = 0
      if (is_line) then
         if (state%line%half_width > 0) traction = tractions(state%slip, (x/state%line%half_width)**2)
      else if (state%ellipse%minor > 0) then
         traction = tractions(state%slip, (x/state%ellipse%major)**2 + (y/state%ellipse%minor)**2)
      end if
   end subroutine fill_tractions

end module adfric_plane_hertz_model
