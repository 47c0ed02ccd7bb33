! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `rigid_punch`: a rigid punch on an elastic half-plane, without friction, plane strain.
module adfric_plane_punch_model
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_plane_contact_conditions, only: largest_violation
   use adfric_plane_field_model, only: set_plane_stresses, maps_of
   use adfric_plane_model, only: halfspace_model_t
   use adfric_plane_punch_profiles, only: polynomial_t, power_load, wedge_load
   use adfric_plane_punch_state, only: punch_state_t
   use adfric_plane_punch_stress, only: punch_stress
   use adfric_plane_rigid_punch, only: solve_punch, solve_punch_of_width
   use adfric_solid_contact_modulus, only: set_modulus_rows, contact_modulus_of, has_contact_modulus, &
      & check_contact_modulus
   use adfric_describe_doubt, only: doubt_contact_too_wide, doubt_slope_too_steep
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_check, only: require, require_one
   use adfric_describe_rows, only: positive, choice, number, whole_number, contact_profiles, result_row
   use adfric_describe_status, only: status_solved, status_no_equilibrium, status_not_converged
   use adfric_describe_table, only: result_t, profile_t, profile_axis_t, variable_t
   implicit none (type, external)
   private
   public :: punch_model_t, new_punch_model

   !> Logarithm of a slope that is more than any bound.
   real(dp), parameter :: most = 50.0_dp
   !> Places of the variables, of the words of the kind, and of the results.
   integer, parameter, public :: v_kind = 1, v_face = 2, v_slope = 3, v_radius = 4, v_coefficient_2 = 5, v_coefficient_8 = 8, &
      & v_contact_modulus = 9, v_poisson_ratio = 11, v_load = 12, v_contact_half_width = 13, v_points = 14
   integer, parameter, public :: kind_flat = 1, kind_wedge = 2, kind_cylinder = 3, kind_polynomial = 4
   integer, parameter, public :: r_load = 1, r_contact_half_width = 2, r_mean_pressure = 3, r_centre_pressure = 4, &
      & r_edge_intensity = 5, r_violation = 6
   !> Places of the profiles: those of the surface, and from `p_stress` on maps of s_xx, s_yy, s_xy and the largest shear.
   integer, parameter, public :: p_pressure = 1, p_gap = 2, p_displacement = 3, p_stress = 4, p_shear = 7
   !> Places where the conditions of contact are checked, and how far they reach, in half-widths.
   integer, parameter :: n_places = 120
   real(dp), parameter :: reach = 3.0_dp
   !> Largest coefficient of a polynomial; those of small tips are large.
   real(dp), parameter :: largest_coefficient = 1.0e100_dp
   !> Decimal logarithm of a load beyond all numbers.
   real(dp), parameter :: largest_load = 200.0_dp

   !> The model `rigid_punch`.
   type, extends(halfspace_model_t) :: punch_model_t
   contains
      procedure :: check_case
      procedure :: solve_point
      procedure :: fill_profiles
      procedure :: measure
   end type punch_model_t

contains

   !> The model with its tables.
   subroutine new_punch_model(self)
      !> The new model; receives its tables.
      type(punch_model_t), intent(out) :: self
      type(variable_t) :: v(v_points)
      character(*), parameter :: units(4) = ['1/m  ', '1/m^3', '1/m^5', '1/m^7']
      character(1) :: degree
      integer :: i

      v(v_kind) = choice(group='punch', name='kind', meaning='profile', choices='flat wedge cylinder polynomial')
      v(v_face) = positive(group='punch', name='half_width', unit='m', &
         & meaning='half-width of the face; without it only flat punches end')
      v(v_slope) = positive(group='punch', name='slope', unit='-', meaning='of a wedge z = slope |x|')
      v(v_radius) = positive(group='punch', name='radius', unit='m', meaning='of a cylinder z = x^2/2R')
      do i = 1, 4
         write (degree, '(i1)') 2*i
         v(v_coefficient_2 + i - 1) = number(group='punch', name='coefficient_'//degree, unit=trim(units(i)), &
            & meaning='c of c x^'//degree//' in a polynomial profile', default=0.0_dp, lower=0.0_dp, upper=largest_coefficient)
      end do
      call set_modulus_rows(positive(group='solid', name='contact_modulus', unit='Pa', meaning=''), &
         & v(v_contact_modulus:v_poisson_ratio))
      v(v_load) = positive(group='operating', name='load', unit='N/m', meaning='load per length')
      v(v_contact_half_width) = positive(group='operating', name='contact_half_width', unit='m', &
         & meaning='instead of the load; not for a flat punch')
      v(v_points) = whole_number(group='numerics', name='points', meaning='points of collocation', default=32, lower=8, &
         & upper=1000, multiple_of=2)
      call self%set_tables(name='rigid_punch', summary='a rigid punch on an elastic half-plane, plane strain', variables=v, &
         & results=get_results(), profiles=get_profile_table(), axes='y x', is_depth=.true.)
      self%solids = [v_contact_modulus, v_poisson_ratio]
   end subroutine new_punch_model

   !> The table of profiles.
   function get_profile_table() result(p)
      type(profile_t) :: p(p_shear)
      type(result_t) :: r(p_shear - p_stress + 1)

      p(:p_gap) = contact_profiles()
      p(p_displacement) = profile_t(name='displacement', unit='m', &
         & long_name='displacement of the surface into the solid, against the middle of the punch')
      call set_plane_stresses(r)
      p(p_stress:) = maps_of(r)
   end function get_profile_table

   !> The table of results.
   function get_results() result(r)
      type(result_t) :: r(6)

      r(r_load) = result_row(name='load', unit='N/m', long_name='load per length', is_main=.true.)
      r(r_contact_half_width) = result_row(name='contact_half_width', unit='m', long_name='half-width a of contact', is_main=.true.)
      r(r_mean_pressure) = result_row(name='mean_pressure', unit='Pa', long_name='load over contact', is_main=.true.)
      r(r_centre_pressure) = result_row(name='centre_pressure', unit='Pa', long_name='pressure in the middle; a wedge has none')
      r(r_edge_intensity) = result_row(name='edge_intensity', unit='Pa m^1/2', &
         & long_name='p sqrt(2 pi (a - x)) at the edge of a whole face')
      r(r_violation) = result_row(name='contact_violation', unit='-', long_name='largest violation of g >= 0, p >= 0, g p = 0')
   end function get_results

   !> See `halfspace_model_t`.
   subroutine check_case(self, values, problems)
      !> The model; its tables give the variables their names.
      class(punch_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call require(self%variables, values, [v_kind], problems)
      call check_contact_modulus(self%variables(v_contact_modulus:v_poisson_ratio), &
         & values(v_contact_modulus:v_poisson_ratio), problems, .false.)
      if (.not. is_set(values(v_kind))) return
      select case (nint(values(v_kind)))
      case (kind_flat)
         call require(self%variables, values, [v_face, v_load], problems)
         if (is_set(values(v_contact_half_width))) call problems%add('operating', 'contact_half_width', &
            & 'has no meaning for a flat punch, whose whole face is in contact')
         return
      case (kind_wedge)
         call require(self%variables, values, [v_slope], problems)
      case (kind_cylinder)
         call require(self%variables, values, [v_radius], problems)
      case default
         if (.not. maxval(values(v_coefficient_2:v_coefficient_8)) > 0) call problems%add('punch', 'coefficient_2', &
            & 'is 0 like all coefficients; give one of them, or kind = ''flat''')
         if (has_contact_modulus(values(v_contact_modulus:v_poisson_ratio))) call check_coefficients(self, values, problems)
      end select
      call require_one(self%variables, values, [v_load, v_contact_half_width], .true., problems)
      if (is_set(values(v_contact_half_width)) .and. is_set(values(v_face))) then
         if (values(v_contact_half_width) > values(v_face)) call problems%add('operating', 'contact_half_width', &
            & 'is larger than the half_width of the face')
      end if
   end subroutine check_case

   !> E* [Pa].
   pure real(dp) function modulus_of(values)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      modulus_of = contact_modulus_of(values(v_contact_modulus:v_poisson_ratio))
   end function modulus_of

   !> Find coefficients that make a load beyond all numbers.
   subroutine check_coefficients(self, values, problems)
      !> The model; its tables give the variables their names.
      class(punch_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: i

      do i = v_coefficient_2, v_coefficient_8
         if (.not. is_carried(values, i)) call problems%add('punch', self%variables(i)%name, &
            & 'makes a load beyond all numbers at this contact_half_width')
      end do
   end subroutine check_coefficients

   !> Is the load of a term c x^2i within the numbers, where the half-width of contact is given?
   pure logical function is_carried(values, i)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Place of the coefficient in `variables`.
      integer, intent(in) :: i

      is_carried = .true.
      if (.not. (is_set(values(v_contact_half_width)) .and. values(i) > 0)) return
      is_carried = log10(values(i)) + 2*(i - v_coefficient_2 + 1)*log10(values(v_contact_half_width)) &
         & + log10(modulus_of(values)) < largest_load
   end function is_carried

   !> Is there such a contact? A sweep may lead to a contact wider than the face, or to a polynomial without terms and end.
   pure logical function is_possible(values)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      integer :: i

      is_possible = .true.
      if (is_set(values(v_contact_half_width))) is_possible = values(v_contact_half_width) <= values(v_face)
      if (nint(values(v_kind)) == kind_polynomial) is_possible = is_possible &
         & .and. maxval(values(v_coefficient_2:v_coefficient_8)) > 0 &
         & .and. all([(is_carried(values, i), i=v_coefficient_2, v_coefficient_8)])
   end function is_possible

   !> Solve for the contact.
   subroutine solve_state(values, state)
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> The punch on its contact; `contact%is_converged` tells whether it was found.
      type(punch_state_t), intent(out) :: state
      real(dp) :: load, width, modulus
      integer :: n

      modulus = modulus_of(values)
      n = nint(values(v_points))
      load = values(v_load)
      width = values(v_contact_half_width)
      if (is_set(values(v_face))) state%face = values(v_face)
      select case (nint(values(v_kind)))
      case (kind_flat)
      case (kind_wedge)
         state%slope = values(v_slope)
         if (.not. is_set(load)) load = wedge_load(modulus, state%slope, width)
         width = min(state%face, load/modulus/state%slope)
         call solve_punch(state%profile, width, modulus, load, 2, state%contact)
         state%contact%excess = max(0.0_dp, load - wedge_load(modulus, state%slope, width))
         if (width < state%face) state%contact%excess = 0
         return
      case (kind_cylinder)
         state%profile%c(1) = 1/(2*values(v_radius))
      case default
         state%profile%c = values(v_coefficient_2:v_coefficient_8)
      end select
      if (is_set(load)) then
         call solve_punch(state%profile, widest(state%profile, state%face, modulus, load), modulus, load, n, state%contact)
      else
         call solve_punch_of_width(state%profile, width, modulus, n, state%contact)
      end if
   end subroutine solve_state

   !> A half-width that the contact does not pass: that of the face, or what a single term of the profile would need.
   pure real(dp) function widest(profile, face, modulus, load)
      !> Polynomial profile of the punch.
      type(polynomial_t), intent(in) :: profile
      !> Half-width of the face [m]; enormous without an end.
      real(dp), intent(in) :: face
      !> Contact modulus E* [Pa].
      real(dp), intent(in) :: modulus
      !> Load P per length [N/m], > 0.
      real(dp), intent(in) :: load
      real(dp), parameter :: margin = 1.1_dp
      integer :: i

      widest = face
      do i = 1, size(profile%c)
         if (profile%c(i) > 0) widest = min(widest, margin*(load/power_load(modulus, profile%c(i), i, 1.0_dp))**(1.0_dp/(2*i)))
      end do
   end function widest

   !> See `model_t`: the slope at the edge of contact, of a cylinder its half-width over its radius.
   subroutine measure(self, values, results, measures)
      !> The model; nothing is read from it here.
      class(punch_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the point, NaN where they are not known; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> In: all `not_measured`. Out: with what is measured; shape `(n_doubts)`.
      real(dp), intent(inout) :: measures(:)
      integer :: i

      select case (nint(values(v_kind)))
      case (kind_wedge)
         measures(doubt_slope_too_steep) = values(v_slope)
      case (kind_cylinder)
         measures(doubt_contact_too_wide) = results(r_contact_half_width)/values(v_radius)
      case (kind_polynomial)
         if (ieee_is_nan(results(r_contact_half_width))) return
         measures(doubt_slope_too_steep) = sum([(exp(min(most, log(2*i*max(values(v_coefficient_2 + i - 1), tiny(1.0_dp))) &
            & + (2*i - 1)*log(results(r_contact_half_width)))), i=1, 4)])
      end select
      associate (unused => self)
      end associate
   end subroutine measure

   !> See `pointwise_model_t`.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
      !> The model; nothing is read from it here.
      class(punch_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the punch on its contact, for the profiles; nothing is taken from the point before.
      class(point_state_t), allocatable, intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the main result [-].
      real(dp), intent(out) :: error_estimate
      !> Status of the point, one of `status_...`.
      integer, intent(out) :: status
      !> These models count nothing; size 0.
      real(dp), intent(inout) :: counts(:)
      type(punch_state_t), allocatable :: found
      real(dp) :: x(n_places), mean
      integer :: i

      status = status_no_equilibrium
      error_estimate = 0
      if (.not. is_possible(values)) return
      allocate (found)
      call solve_state(values, found)
      status = merge(status_solved, status_not_converged, found%contact%is_converged)
      error_estimate = max(epsilon(mean), found%contact%load_error)
      if (status /= status_solved) return
      associate (contact => found%contact)
         mean = contact%load/(2*contact%half_width)
         results([r_load, r_contact_half_width, r_mean_pressure]) = [contact%load, contact%half_width, mean]
         results(r_centre_pressure) = found%pressure(0.0_dp)
         results(r_edge_intensity) = contact%excess/sqrt(pi*contact%half_width)
         x = [((i - 0.5_dp)*reach/n_places, i=1, n_places)]*contact%half_width
         x = pack(x, x < found%face, spread(x(1), 1, n_places))
         results(r_violation) = largest_violation(found%pressure(x), found%gap(x), mean, mean*contact%half_width/contact%modulus)
      end associate
      call move_alloc(found, state)
      associate (unused => self, unused_counts => counts)
      end associate
   end subroutine solve_point

   !> See `pointwise_model_t`. Pressure, gap and displacement are those of the surface, NaN at other depths.
   subroutine fill_profiles(self, values, results, state, axes, profiles)
      !> The model; nothing is read from it here.
      class(punch_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> What `solve_block` found for this point, not used here.
      real(dp), intent(in) :: results(:)
      !> The punch on its contact.
      class(point_state_t), allocatable, intent(in) :: state
      !> Axes of the profiles, the slowest first.
      type(profile_axis_t), intent(in) :: axes(:)
      !> In: all NaN. Out: profiles of the point; shape `(n_fast, n_slow, n_profiles)`.
      real(dp), intent(inout) :: profiles(:, :, :)
      real(dp) :: stress(3)
      integer :: i, j

      select type (state)
      type is (punch_state_t)
         associate (depth => axes(1)%coordinates, x => axes(2)%coordinates)
            do j = 1, size(depth)
               if (.not. depth(j) > 0) call get_surface(state, x, profiles(:, j, :))
               do i = 1, size(x)
                  stress = punch_stress(state%contact, state%slope, x(i), depth(j))
                  profiles(i, j, p_stress:p_shear - 1) = stress
                  profiles(i, j, p_shear) = hypot((stress(1) - stress(2))/2, stress(3))
               end do
            end do
         end associate
      end select
      associate (unused => self, unused_values => values, unused_results => results)
      end associate
   end subroutine fill_profiles

   !> Set pressure, gap and displacement along the surface.
   subroutine get_surface(state, x, profiles)
      !> The punch on its solved contact.
      type(punch_state_t), intent(in) :: state
      !> Coordinates along the surface, from the middle of the punch [m].
      real(dp), intent(in) :: x(:)
      !> Profiles along the surface; pressure, gap and displacement are set. Shape `(n_x, n_profiles)`.
      real(dp), intent(inout) :: profiles(:, :)
      integer :: i

      profiles(:, p_pressure) = state%pressure(x)
      do i = 1, size(x)
         ! beyond the face there is no punch to have a gap from; in contact what is left is round-off
         if (abs(x(i)) <= state%face) profiles(i, p_gap) = max(0.0_dp, state%gap(x(i)))
         if (abs(x(i)) <= state%contact%half_width) profiles(i, p_gap) = 0
      end do
      profiles(:, p_displacement) = -state%level(x)
   end subroutine get_surface

end module adfric_plane_punch_model
