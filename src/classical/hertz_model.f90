!> The model `hertz`: smooth elastic bodies in contact along a line, on a circle or on an ellipse, without friction.
module adfric_classical_hertz_model
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_classical_model, only: halfspace_model_t
   use adfric_classical_hertz_ellipse, only: ellipse_t, ellipse_shape_t, find_curvatures, ellipse_of_load, &
      & ellipse_of_approach, ellipse_pressure, ellipse_gap, ellipse_misfit
   use adfric_classical_hertz_line, only: line_contact_t, line_of_load, line_pressure, line_gap, line_misfit
   use adfric_classical_hertz_unit, only: unit_contact_t, find_unit_line, find_unit_ellipse
   use adfric_material_contact_modulus, only: set_modulus_rows, contact_modulus_of, check_contact_modulus
   use adfric_model_pointwise, only: point_state_t
   use adfric_model_check, only: require, require_one
   use adfric_model_rows, only: positive, choice, number, contact_profiles, result_row
   use adfric_model_status, only: status_solved, status_no_equilibrium, status_not_converged
   use adfric_model_table, only: result_t, variable_t, profile_axis_t
   implicit none (type, external)
   private
   public :: hertz_model_t, new_hertz_model

   !> Places of the variables, of the words of the kind, and of the results.
   integer, parameter, public :: v_kind = 1, v_radius = 2, v_radius_1x = 3, v_radius_1y = 4, v_radius_2x = 5, v_radius_2y = 6, &
      & v_angle = 7, v_contact_modulus = 8, v_poisson_ratio = 10, v_second_poisson_ratio = 12, v_load = 13, v_approach = 14
   integer, parameter, public :: kind_line = 1, kind_circular = 2, kind_elliptical = 3
   integer, parameter, public :: r_load = 1, r_approach = 2, r_half_width = 3, r_minor = 4, r_peak_pressure = 5, &
      & r_mean_pressure = 6, r_contact_area = 7, r_direction = 8, r_shear = 9, r_shear_depth = 10, r_violation = 11
   integer, parameter :: n_variables = 14, n_results = 11

   !> The model `hertz`.
   type, extends(halfspace_model_t) :: hertz_model_t
   contains
      procedure :: check_case
      procedure :: describe_results
      procedure :: unit_of
      procedure :: solve_point
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
   end type hertz_state_t

contains

   !> The model with its tables.
   subroutine new_hertz_model(self)
      !> The new model; receives its tables.
      type(hertz_model_t), intent(out) :: self
      type(variable_t) :: v(n_variables)

      v(v_kind) = choice(group='contact', name='kind', meaning='parallel cylinders, spheres, or any smooth bodies', &
         & choices='line circular elliptical')
      v(v_radius) = positive(group='contact', name='radius', unit='m', meaning='R of line and circle, 1/R = 1/R1 + 1/R2')
      v(v_radius_1x) = number(group='contact', name='radius_1x', unit='m', &
         & meaning='principal radius of the first body, convex > 0; not given: flat')
      v(v_radius_1y) = number(group='contact', name='radius_1y', unit='m', meaning='its other principal radius')
      v(v_radius_2x) = number(group='contact', name='radius_2x', unit='m', meaning='principal radius of the second body')
      v(v_radius_2y) = number(group='contact', name='radius_2y', unit='m', meaning='its other principal radius')
      v(v_angle) = number(group='contact', name='angle', unit='rad', &
         & meaning='from the first principal direction of body 1 to that of body 2', default=0.0_dp)
      call set_modulus_rows(positive(group='solid', name='contact_modulus', unit='Pa', meaning=''), &
         & v(v_contact_modulus:v_second_poisson_ratio))
      v(v_poisson_ratio)%meaning = 'of the first body, and for the largest shear stress; a line without it: that in the plane'
      v(v_load) = number(group='operating', name='load', unit='N; N/m for line', meaning='load', lower=0.0_dp)
      v(v_approach) = number(group='operating', name='approach', unit='m', &
         & meaning='of distant points, instead of the load; not for a line', lower=0.0_dp)
      call self%set_tables(name='hertz', summary='smooth elastic bodies in contact along a line, on a circle or an ellipse', &
         & variables=v, results=get_results(), profiles=contact_profiles(), axes='y x', is_depth=.false.)
      self%solids = [v_contact_modulus, v_second_poisson_ratio]
   end subroutine new_hertz_model

   !> The table of results.
   function get_results(is_line) result(r)
      !> Is the contact one along a line, so that load and area are per length? Absent before it is known: then the units are
      !> those of either.
      logical, intent(in), optional :: is_line
      type(result_t) :: r(n_results)
      character(:), allocatable :: force, area

      force = 'N; N/m for line'
      area = 'm^2; m for line'
      if (present(is_line)) then
         force = trim(merge('N/m', 'N  ', is_line))
         area = trim(merge('m  ', 'm^2', is_line))
      end if
      r(r_load) = result_row(name='load', unit=force, long_name='load', is_main=.true.)
      r(r_approach) = result_row(name='approach', unit='m', long_name='approach of distant points; a line contact has none', &
         & is_main=.true.)
      r(r_half_width) = result_row(name='contact_half_width', unit='m', &
         & long_name='half-width a of contact, along the major axis x', is_main=.true.)
      r(r_minor) = result_row(name='minor_half_width', unit='m', long_name='half-width b along the minor axis y')
      r(r_peak_pressure) = result_row(name='peak_pressure', unit='Pa', long_name='largest pressure', is_main=.true.)
      r(r_mean_pressure) = result_row(name='mean_pressure', unit='Pa', long_name='load over area of contact')
      r(r_contact_area) = result_row(name='contact_area', unit=area, long_name='area of contact')
      r(r_direction) = result_row(name='major_axis_angle', unit='rad', &
         & long_name='from the first principal direction of body 1 to the major axis')
      r(r_shear) = result_row(name='largest_shear_stress', unit='Pa', long_name='largest shear stress in the solid')
      r(r_shear_depth) = result_row(name='largest_shear_depth', unit='m', long_name='its depth')
      r(r_violation) = result_row(name='contact_violation', unit='-', long_name='largest violation of g >= 0, p >= 0, g p = 0')
   end function get_results

   !> See `model_t`.
   function describe_results(self, values) result(results)
      !> The model with its table of results.
      class(hertz_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(result_t), allocatable :: results(:)

      results = self%results
      if (is_set(values(v_kind))) results = get_results(nint(values(v_kind)) == kind_line)
   end function describe_results

   !> See `model_t`: the load of a line is one per length.
   function unit_of(self, values, place) result(unit)
      !> The model with its table of variables.
      class(hertz_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Place of the variable in `variables`.
      integer, intent(in) :: place
      character(:), allocatable :: unit

      unit = self%variables(place)%unit
      if (place == v_load .and. is_set(values(v_kind))) unit = trim(merge('N/m', 'N  ', nint(values(v_kind)) == kind_line))
   end function unit_of

   !> See `halfspace_model_t`.
   subroutine check_case(self, values, problems)
      !> The model; its tables give the variables their names.
      class(hertz_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      real(dp) :: a, b, direction
      integer :: i

      call require(self%variables, values, [v_kind], problems)
      call check_contact_modulus(self%variables(v_contact_modulus:v_second_poisson_ratio), &
         & values(v_contact_modulus:v_second_poisson_ratio), problems, .true.)
      if (.not. is_set(values(v_kind))) return
      if (nint(values(v_kind)) == kind_line) then
         call require(self%variables, values, [v_load], problems)
         if (is_set(values(v_approach))) call problems%add('operating', 'approach', &
            & 'is undefined for the line contact of half-planes; give load')
      else
         call require_one(self%variables, values, [v_load, v_approach], .true., problems)
      end if
      do i = v_radius, v_radius_2y
         if (i == v_radius .eqv. nint(values(v_kind)) /= kind_elliptical) cycle
         if (is_set(values(i))) call problems%add('contact', self%variables(i)%name, 'has no meaning for this kind')
      end do
      if (nint(values(v_kind)) /= kind_elliptical) then
         call require(self%variables, values, [v_radius], problems)
         return
      end if
      do i = v_radius_1x, v_radius_2y
         if (abs(values(i)) > 0) cycle
         call problems%add('contact', self%variables(i)%name, 'is 0, allowed: any other number; flat if not given')
         return
      end do
      call get_curvatures(values, a, b, direction)
      if (.not. a > 0) call problems%add('contact', 'radius_1x', &
         & 'and the other radii do not make a gap that opens in all directions: there is no ellipse of contact')
   end subroutine check_case

   !> E* [Pa].
   pure real(dp) function modulus_of(values)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      modulus_of = contact_modulus_of(values(v_contact_modulus:v_second_poisson_ratio))
   end function modulus_of

   !> Curvatures A <= B of the gap A x^2 + B y^2; A <= 0 where there is no ellipse of contact.
   pure subroutine get_curvatures(values, a, b, direction)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Smaller curvature A of the gap [1/m]; 0 or less where there is no single ellipse of contact.
      real(dp), intent(out) :: a
      !> Larger curvature B of the gap [1/m].
      real(dp), intent(out) :: b
      !> Angle from the first principal direction of the first body to the major axis [rad]; 0 for a circle.
      real(dp), intent(out) :: direction
      real(dp) :: curvatures(4)
      integer :: i

      if (nint(values(v_kind)) /= kind_elliptical) then
         a = 0.5_dp/values(v_radius)
         b = a
         direction = 0
         return
      end if
      a = 0
      b = 0
      direction = 0
      curvatures = 0
      if (.not. minval(abs(values(v_radius_1x:v_radius_2y))) > 0) return
      do i = 1, 4
         if (is_set(values(v_radius_1x + i - 1))) curvatures(i) = 1/values(v_radius_1x + i - 1)
      end do
      call find_curvatures(curvatures(:2), curvatures(3:), values(v_angle), a, b, direction)
   end subroutine get_curvatures

   !> See `pointwise_model_t`.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
      !> The model; nothing is read from it here.
      class(hertz_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
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

      if (.not. allocated(state)) allocate (hertz_state_t :: state)
      select type (state)
      type is (hertz_state_t)
         if (nint(values(v_kind)) == kind_line) then
            call solve_line(values, state, results, error_estimate)
            status = status_solved
         else
            call solve_ellipse(values, state, results, error_estimate, status)
         end if
      end select
      associate (unused => self, unused_counts => counts)
      end associate
   end subroutine solve_point

   !> Solve the contact along a line.
   subroutine solve_line(values, state, results, error_estimate)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> In: the unit contact of the point before. Out: that of this point, and its contact.
      type(hertz_state_t), intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the main result [-].
      real(dp), intent(out) :: error_estimate
      real(dp) :: misfit

      state%line = line_of_load(values(v_radius), modulus_of(values), values(v_load))
      call find_unit_line(values(v_poisson_ratio), state%unit_contact)
      associate (line => state%line, unit_contact => state%unit_contact)
         results([r_load, r_half_width, r_peak_pressure]) = [values(v_load), line%half_width, line%peak_pressure]
         results([r_mean_pressure, r_contact_area]) = [pi/4*line%peak_pressure, 2*line%half_width]
         results([r_shear, r_shear_depth]) = [unit_contact%shear*line%peak_pressure, unit_contact%depth*line%half_width]
         misfit = line_misfit(line, values(v_load))
         error_estimate = max(epsilon(error_estimate), misfit)
         results(r_violation) = max(misfit, unit_contact%violation)
      end associate
   end subroutine solve_line

   !> Solve the contact on an ellipse or a circle.
   subroutine solve_ellipse(values, state, results, error_estimate, status)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> In: the unit contact of the point before. Out: that of this point, and its contact.
      type(hertz_state_t), intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the main result [-].
      real(dp), intent(out) :: error_estimate
      !> Status of the point, one of `status_...`.
      integer, intent(out) :: status
      real(dp) :: direction, misfit

      status = status_no_equilibrium
      error_estimate = epsilon(error_estimate)
      associate (a => state%a, b => state%b, s => state%ellipse, unit_contact => state%unit_contact)
         call get_curvatures(values, a, b, direction)
         if (.not. a > 0) return
         call find_unit_ellipse(a/b, values(v_poisson_ratio), unit_contact)
         status = merge(status_solved, status_not_converged, unit_contact%shape%is_converged)
         if (status /= status_solved) return
         call get_ellipse(values, a, b, unit_contact%shape, s)
         results([r_load, r_approach, r_half_width, r_minor]) = [s%load, s%approach, s%major, s%minor]
         results([r_peak_pressure, r_mean_pressure]) = s%peak_pressure*[1.0_dp, 2.0_dp/3]
         results([r_contact_area, r_direction, r_violation]) = [pi*s%major*s%minor, direction, 0.0_dp]
         if (.not. s%minor > 0) return
         if (is_set(values(v_poisson_ratio))) results([r_shear, r_shear_depth]) = [unit_contact%shear*s%peak_pressure, &
            & unit_contact%depth*s%major]
         misfit = ellipse_misfit(s, a, b, modulus_of(values))
         error_estimate = max(error_estimate, misfit)
         results(r_violation) = max(misfit, unit_contact%violation)
      end associate
   end subroutine solve_ellipse

   !> Ellipse of a case under its load or approach.
   pure subroutine get_ellipse(values, a, b, shape, s)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Curvatures A <= B of the gap [1/m].
      real(dp), intent(in) :: a, b
      !> Shape of the ellipse that belongs to A/B.
      type(ellipse_shape_t), intent(in) :: shape
      !> The contact; its half-axes are 0 if the shape is not converged.
      type(ellipse_t), intent(out) :: s

      if (is_set(values(v_load))) then
         call ellipse_of_load(a, b, modulus_of(values), values(v_load), shape, s)
      else
         call ellipse_of_approach(a, b, modulus_of(values), values(v_approach), shape, s)
      end if
   end subroutine get_ellipse

   !> See `pointwise_model_t`. x and y are the axes of the ellipse; a line contact extends along y.
   subroutine fill_profiles(self, values, results, state, axes, profiles)
      !> The model; nothing is read from it here.
      class(hertz_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> What `solve_block` found for this point, not used here.
      real(dp), intent(in) :: results(:)
      !> The contact of the point.
      class(point_state_t), allocatable, intent(in) :: state
      !> Axes of the profiles, the slowest first.
      type(profile_axis_t), intent(in) :: axes(:)
      !> In: all NaN. Out: profiles of the point; shape `(n_fast, n_slow, n_profiles)`.
      real(dp), intent(inout) :: profiles(:, :, :)
      integer :: j

      select type (state)
      type is (hertz_state_t)
         associate (s => state%ellipse, y => axes(1)%coordinates, x => axes(2)%coordinates)
            do j = 1, size(y)
               if (nint(values(v_kind)) == kind_line) then
                  profiles(:, j, 1) = line_pressure(state%line, x)
                  profiles(:, j, 2) = line_gap(state%line, x)
               else
                  profiles(:, j, 1) = ellipse_pressure(s, x, y(j))
                  profiles(:, j, 2) = ellipse_gap(s, modulus_of(values), x, y(j))
                  if (.not. s%minor > 0) profiles(:, j, 2) = state%a*x**2 + state%b*y(j)**2
               end if
            end do
         end associate
      end select
      associate (unused => self, unused_results => results)
      end associate
   end subroutine fill_profiles

end module adfric_classical_hertz_model
