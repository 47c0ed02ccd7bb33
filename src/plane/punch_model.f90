! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `rigid_punch`: a rigid punch on an elastic half-plane, without friction or sliding by a shear strength, plane strain.
!> The file is long by its answers to `pointwise_model_t`, and by the tables of four kinds of punches.
module adfric_plane_punch_model
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_base_constants, only: pi
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_number
   use adfric_base_unset, only: is_set
   use adfric_interface_shear_coupling, only: coupling_row
   use adfric_interface_shear_strength_rows, only: set_shear_rows
   use adfric_plane_contact_conditions, only: largest_violation
   use adfric_plane_coupled_wedge, only: find_coupled_wedge
   use adfric_plane_field_model, only: set_plane_stresses, maps_of
   use adfric_plane_model, only: halfspace_model_t
   use adfric_plane_punch_friction, only: check_punch_friction, n_friction_results, punch_friction_results, punch_friction_t, &
      & sliding_pressure_at, store_punch_friction
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
   !> Variables in the order of their rows; a component is the index of its row.
   type :: punch_input_t
      !> Indices of the rows.
      integer :: kind = 0, face = 0, slope = 0, radius = 0, coefficient_2 = 0, coefficient_4 = 0, coefficient_6 = 0, &
         & coefficient_8 = 0, contact_modulus = 0, young_modulus = 0, poisson_ratio = 0, load = 0, contact_half_width = 0, &
         & points = 0, shear(2) = 0, coupling = 0, velocity = 0
   end type punch_input_t
   type(punch_input_t), parameter, public :: punch_input = transfer(counting, punch_input_t())
   integer, parameter, public :: kind_flat = 1, kind_wedge = 2, kind_cylinder = 3, kind_polynomial = 4
   !> Results in the order of their rows; a component is the index of its row.
   type :: punch_output_t
      !> Indices of the rows.
      integer :: load = 0, contact_half_width = 0, mean_pressure = 0, centre_pressure = 0, edge_intensity = 0, violation = 0, &
         & friction(n_friction_results) = 0
   end type punch_output_t
   type(punch_output_t), parameter, public :: punch_output = transfer(counting, punch_output_t())
   !> Indices of the profiles: those of the surface, and from `p_stress` on maps of s_xx, s_yy, s_xy and the largest shear.
   integer, parameter, public :: p_pressure = 1, p_gap = 2, p_displacement = 3, p_stress = 4, p_shear = 7
   !> Indices where the conditions of contact are checked, and how far they reach, in half-widths.
   integer, parameter :: n_indices = 120
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
      type(variable_t) :: v(punch_input%velocity)
      character(*), parameter :: units(4) = ['1/m  ', '1/m^3', '1/m^5', '1/m^7']
      character(1) :: degree
      integer :: i

      v(punch_input%kind) = choice(group='punch', name='kind', meaning='profile', choices='flat wedge cylinder polynomial')
      v(punch_input%face) = positive(group='punch', name='half_width', unit='m', &
         & meaning='half-width of the face; without it only flat punches end')
      v(punch_input%slope) = positive(group='punch', name='slope', unit='-', meaning='of a wedge z = slope |x|')
      v(punch_input%radius) = positive(group='punch', name='radius', unit='m', meaning='of a cylinder z = x^2/2R')
      do i = 1, 4
         write (degree, '(i1)') 2*i
         v(punch_input%coefficient_2 + i - 1) = number(group='punch', name='coefficient_'//degree, unit=trim(units(i)), &
            & meaning='c of c x^'//degree//' in a polynomial profile', default=0.0_dp, lower=0.0_dp, upper=largest_coefficient)
      end do
      call set_modulus_rows(positive(group='solid', name='contact_modulus', unit='Pa', meaning=''), &
         & v(punch_input%contact_modulus:punch_input%poisson_ratio))
      v(punch_input%load) = positive(group='operating', name='load', unit='N/m', meaning='load per length')
      v(punch_input%contact_half_width) = positive(group='operating', name='contact_half_width', unit='m', &
         & meaning='instead of the load; not for a flat punch')
      v(punch_input%points) = whole_number(group='numerics', name='points', meaning='points of collocation', default=32, lower=8, &
         & upper=1000, multiple_of=2)
      call set_shear_rows(v(punch_input%shear(1):punch_input%shear(2)))
      v(punch_input%coupling) = coupling_row()
      v(punch_input%velocity) = number(group='operating', name='velocity', unit='m/s', &
         & meaning='sliding velocity, positive to +x; its sign counts')
      call self%set_tables(name='rigid_punch', summary='a rigid punch on an elastic half-plane, plane strain', variables=v, &
         & results=get_results(), profiles=get_profile_table(), axes='y x', is_depth=.true.)
      self%solids = [punch_input%contact_modulus, punch_input%poisson_ratio]
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
      type(result_t) :: r(punch_output%friction(n_friction_results))

      r(punch_output%load) = result_row(name='load', unit='N/m', long_name='load per length', is_main=.true.)
      r(punch_output%contact_half_width) = result_row(name='contact_half_width', unit='m', long_name='half-width a of contact', &
         & is_main=.true.)
      r(punch_output%mean_pressure) = result_row(name='mean_pressure', unit='Pa', long_name='load over contact', is_main=.true.)
      r(punch_output%centre_pressure) = result_row(name='centre_pressure', unit='Pa', &
         & long_name='pressure in the middle; a wedge has none')
      r(punch_output%edge_intensity) = result_row(name='edge_intensity', unit='Pa m^1/2', &
         & long_name='p sqrt(2 pi (a - x)) at the edge of a whole face')
      r(punch_output%violation) = result_row(name='contact_violation', unit='-', &
         & long_name='largest violation of g >= 0, p >= 0, g p = 0')
      r(punch_output%friction(1):) = punch_friction_results()
   end function get_results

   !> What the values say of the friction.
   pure type(punch_friction_t) function friction_of(values) result(friction)
      real(dp), intent(in) :: values(:)

      friction%shear = values(punch_input%shear)
      friction%coupling = values(punch_input%coupling)
      friction%velocity = values(punch_input%velocity)
      friction%poisson_ratio = values(punch_input%poisson_ratio)
   end function friction_of

   !> See `halfspace_model_t`.
   subroutine check_case(self, values, problems)
      class(punch_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call require(self%variables, values, [punch_input%kind], problems)
      call check_contact_modulus(self%variables(punch_input%contact_modulus:punch_input%poisson_ratio), &
         & values(punch_input%contact_modulus:punch_input%poisson_ratio), problems, .false.)
      if (.not. is_set(values(punch_input%kind))) return
      call check_punch_friction(self%variables(punch_input%shear(1):punch_input%velocity), friction_of(values), &
         & nint(values(punch_input%kind)) == kind_flat .or. (nint(values(punch_input%kind)) == kind_wedge .and. &
         & .not. is_set(values(punch_input%face))), problems)
      select case (nint(values(punch_input%kind)))
      case (kind_flat)
         call require(self%variables, values, [punch_input%face, punch_input%load], problems)
         if (is_set(values(punch_input%contact_half_width))) call problems%add('operating', 'contact_half_width', &
            & 'has no meaning for a flat punch, whose whole face is in contact')
         return
      case (kind_wedge)
         call require(self%variables, values, [punch_input%slope], problems)
      case (kind_cylinder)
         call require(self%variables, values, [punch_input%radius], problems)
      case default
         if (.not. maxval(values(punch_input%coefficient_2:punch_input%coefficient_8)) > 0) call problems%add('punch', &
            & 'coefficient_2', &
            & 'is 0 like all coefficients; give one of them, or kind = ''flat''')
         if (has_contact_modulus(values(punch_input%contact_modulus:punch_input%poisson_ratio))) call check_coefficients(self, &
            & values, problems)
      end select
      call require_one(self%variables, values, [punch_input%load, punch_input%contact_half_width], .true., problems)
      if (is_set(values(punch_input%contact_half_width)) .and. is_set(values(punch_input%face))) then
         if (values(punch_input%contact_half_width) > values(punch_input%face)) call problems%add('operating', &
            & 'contact_half_width', &
            & 'is larger than the half_width of the face')
      end if
   end subroutine check_case

   !> E* [Pa].
   pure real(dp) function modulus_of(values)
      real(dp), intent(in) :: values(:)

      modulus_of = contact_modulus_of(values(punch_input%contact_modulus:punch_input%poisson_ratio))
   end function modulus_of

   !> Find coefficients that make a load beyond all numbers.
   subroutine check_coefficients(self, values, problems)
      class(punch_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      integer :: i

      do i = punch_input%coefficient_2, punch_input%coefficient_8
         if (.not. is_carried(values, i)) call problems%add('punch', self%variables(i)%name, &
            & 'makes a load above 1e308 N/m at this contact_half_width, given '//show_number(values(i))//' ['// &
            & self%variables(i)%unit//']')
      end do
   end subroutine check_coefficients

   !> Is the load of a term c x^2i within the numbers, where the half-width of contact is given?
   pure logical function is_carried(values, i)
      real(dp), intent(in) :: values(:)
      !> Index of the coefficient in `variables`.
      integer, intent(in) :: i

      is_carried = .true.
      if (.not. (is_set(values(punch_input%contact_half_width)) .and. values(i) > 0)) return
      is_carried = log10(values(i)) + 2*(i - punch_input%coefficient_2 + 1)*log10(values(punch_input%contact_half_width)) &
         & + log10(modulus_of(values)) < largest_load
   end function is_carried

   !> Is there such a contact? A sweep may lead to a contact wider than the face, or to a polynomial without terms and end.
   pure logical function is_possible(values)
      real(dp), intent(in) :: values(:)
      integer :: i

      is_possible = .true.
      if (is_set(values(punch_input%contact_half_width))) is_possible = &
         & values(punch_input%contact_half_width) <= values(punch_input%face)
      if (nint(values(punch_input%kind)) == kind_polynomial) is_possible = is_possible &
         & .and. maxval(values(punch_input%coefficient_2:punch_input%coefficient_8)) > 0 &
         & .and. all([(is_carried(values, i), i=punch_input%coefficient_2, punch_input%coefficient_8)])
   end function is_possible

   !> Solve for the contact.
   subroutine solve_state(values, state)
      real(dp), intent(in) :: values(:)
      !> The punch on its contact; `contact%is_converged` tells whether it was found.
      type(punch_state_t), intent(out) :: state
      type(punch_friction_t) :: friction
      real(dp) :: load, width, modulus
      integer :: n

      modulus = modulus_of(values)
      n = nint(values(punch_input%points))
      load = values(punch_input%load)
      width = values(punch_input%contact_half_width)
      if (is_set(values(punch_input%face))) state%face = values(punch_input%face)
      friction = friction_of(values)
      if (friction%moves_contact() .and. nint(values(punch_input%kind)) == kind_wedge) then
         state%slope = values(punch_input%slope)
         if (is_set(load)) width = 0
         call find_coupled_wedge(friction%get_coupling(), state%slope, modulus, load, width, state%coupled, &
            & state%contact%is_converged)
         state%contact%half_width = (state%coupled%ahead + state%coupled%behind)/2
         state%contact%load = state%coupled%load
         state%contact%modulus = modulus
         allocate (state%contact%b(0))
         return
      end if
      select case (nint(values(punch_input%kind)))
      case (kind_flat)
      case (kind_wedge)
         state%slope = values(punch_input%slope)
         if (.not. is_set(load)) load = wedge_load(modulus, state%slope, width)
         width = min(state%face, load/modulus/state%slope)
         call solve_punch(state%profile, width, modulus, load, 2, state%contact)
         state%contact%excess = max(0.0_dp, load - wedge_load(modulus, state%slope, width))
         if (width < state%face) state%contact%excess = 0
         return
      case (kind_cylinder)
         state%profile%c(1) = 1/(2*values(punch_input%radius))
      case default
         state%profile%c = values(punch_input%coefficient_2:punch_input%coefficient_8)
      end select
      if (is_set(load)) then
         call solve_punch(state%profile, widest(state%profile, state%face, modulus, load), modulus, load, n, state%contact)
      else
         call solve_punch_of_width(state%profile, width, modulus, n, state%contact)
      end if
   end subroutine solve_state

   !> A half-width that the contact does not pass: that of the face, or what a single term of the profile would need.
   pure real(dp) function widest(profile, face, modulus, load)
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
      class(punch_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the point, NaN where they are not known; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> In: all `not_measured`. Out: with what is measured; shape `(n_doubts)`.
      real(dp), intent(inout) :: measures(:)
      integer :: i

      select case (nint(values(punch_input%kind)))
      case (kind_wedge)
         measures(doubt_slope_too_steep) = values(punch_input%slope)
      case (kind_cylinder)
         measures(doubt_contact_too_wide) = results(punch_output%contact_half_width)/values(punch_input%radius)
      case (kind_polynomial)
         if (ieee_is_nan(results(punch_output%contact_half_width))) return
         measures(doubt_slope_too_steep) = sum([(exp(min(most, log(2*i*max(values(punch_input%coefficient_2 + i - 1), &
            & tiny(1.0_dp))) &
            & + (2*i - 1)*log(results(punch_output%contact_half_width)))), i=1, 4)])
      end select
      associate (unused => self)
      end associate
   end subroutine measure

   !> See `pointwise_model_t`.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
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
      type(punch_friction_t) :: friction
      real(dp) :: x(n_indices), mean
      integer :: i

      status = status_no_equilibrium
      error_estimate = 0
      if (.not. is_possible(values)) return
      friction = friction_of(values)
      allocate (found)
      call solve_state(values, found)
      status = merge(status_solved, status_not_converged, found%contact%is_converged)
      error_estimate = max(epsilon(mean), found%contact%load_error)
      if (status /= status_solved) return
      associate (contact => found%contact)
         mean = contact%load/(2*contact%half_width)
         results([punch_output%load, punch_output%contact_half_width, punch_output%mean_pressure]) = [contact%load, &
            & contact%half_width, mean]
         if (friction%exists()) call store_punch_friction(friction, found, &
            & results(punch_output%friction(1):punch_output%friction(n_friction_results)))
         if (friction%moves_contact()) then
            results(punch_output%centre_pressure) = sliding_pressure_at(friction, found, 0.0_dp)
            call move_alloc(found, state)
            return
         end if
         results(punch_output%centre_pressure) = found%pressure(0.0_dp)
         results(punch_output%edge_intensity) = contact%excess/sqrt(pi*contact%half_width)
         x = [((i - 0.5_dp)*reach/n_indices, i=1, n_indices)]*contact%half_width
         x = pack(x, x < found%face, spread(x(1), 1, n_indices))
         results(punch_output%violation) = largest_violation(found%pressure(x), found%gap(x), mean, &
            & mean*contact%half_width/contact%modulus)
      end associate
      call move_alloc(found, state)
      associate (unused => self, unused_counts => counts)
      end associate
   end subroutine solve_point

   !> See `pointwise_model_t`. Pressure, gap and displacement are those of the surface, NaN at other depths.
   subroutine fill_profiles(self, values, results, state, axes, profiles)
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
      type(punch_friction_t) :: friction
      real(dp) :: stress(3)
      integer :: i, j

      friction = friction_of(values)
      select type (state)
      type is (punch_state_t)
         associate (depth => axes(1)%coordinates, x => axes(2)%coordinates)
            do j = 1, size(depth)
               if (friction%moves_contact()) then
                  if (.not. depth(j) > 0) profiles(:, j, p_pressure) = sliding_pressure_at(friction, state, x)
                  cycle
               end if
               if (.not. depth(j) > 0) call get_surface(state, x, profiles(:, j, :))
               ! what the shear stress adds in the solid is not known
               if (friction%exists()) cycle
               do i = 1, size(x)
                  stress = punch_stress(state%contact, state%slope, x(i), depth(j))
                  profiles(i, j, p_stress:p_shear - 1) = stress
                  profiles(i, j, p_shear) = hypot((stress(1) - stress(2))/2, stress(3))
               end do
            end do
         end associate
      end select
      associate (unused => self, unused_results => results)
      end associate
   end subroutine fill_profiles

   !> Set pressure, gap and displacement along the surface.
   subroutine get_surface(state, x, profiles)
      type(punch_state_t), intent(in) :: state
      !> Coordinates along the surface, from the middle of the punch [m].
      real(dp), intent(in) :: x(:)
      !> Profiles along the surface; pressure, gap and displacement are set. Shape `(n_x, n_profiles)`.
      real(dp), intent(inout) :: profiles(:, :)
      integer :: i

      profiles(:, p_pressure) = state%pressure(x)
      do i = 1, size(x)
         ! beyond the face there is no punch to have a gap from; in contact what remains is round-off
         if (abs(x(i)) <= state%face) profiles(i, p_gap) = max(0.0_dp, state%gap(x(i)))
         if (abs(x(i)) <= state%contact%half_width) profiles(i, p_gap) = 0
      end do
      profiles(:, p_displacement) = -state%level(x)
   end subroutine get_surface

end module adfric_plane_punch_model
