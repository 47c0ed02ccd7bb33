! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `hertz_history`: smooth elastic bodies that touch on a circle or an ellipse, with Coulomb's friction, through a path of
!> normal forces or approaches and of tangential forces or displacements along an axis of the ellipse.
!>
!> All contacts of the same bodies are similar: with x = a/a1, a1 the half-width of the largest contact of the path, of the load P1 and
!> the approach d1,
!>
!>     P = P1 x^3,   delta = d1 x^2,   int P d delta = (2/5) P1 d1 x^5
!>
!> and the bonded contact gives way m = pi E* C a/R_F(0, 1, k^2) times as much as under the load, C as in `adfric_plane_hertz_slip`.
!> A line has no displacement, that of a half-plane has no zero: it is refused.
module adfric_plane_hertz_history_model
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_base_constants, only: pi
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_plane_hertz_check, only: check_radii, get_curvatures, steepest_edge
   use adfric_plane_hertz_ellipse, only: ellipse_of_approach, ellipse_of_load, ellipse_shape_t, ellipse_t, find_shape
   use adfric_plane_hertz_slip, only: bonded_compliance
   use adfric_plane_hertz_variables, only: axis_minor, get_hertz_variables, kind_elliptical, kind_line, hertz_input
   use adfric_solid_contact_modulus, only: check_contact_modulus, contact_modulus_of
   use adfric_interface_history_model, only: history_model_t, history_units_t, solve_path
   use adfric_interface_history_path, only: n_path_results, path_approaches, path_coefficient, path_loads, &
      & path_tangential_displacements, path_tangential_forces, set_path_results
   use adfric_interface_normal_contact, only: normal_contact_t, normal_state_t
   use adfric_describe_check, only: require
   use adfric_describe_doubt, only: doubt_contact_too_wide
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_rows, only: result_row
   use adfric_describe_status, only: status_solved
   use adfric_describe_table, only: profile_t, variable_t
   use adfric_numerics_powers, only: cube_root
   implicit none (type, external)
   private
   public :: hertz_history_t, new_hertz_history

   !> Indices of the variables; up to the moduli they are those of the model `hertz`.
   integer, parameter, public :: h_axis = hertz_input%second_poisson_ratio + 1, h_coefficient = h_axis + path_coefficient, &
      & h_loads = h_axis + path_loads, h_approaches = h_axis + path_approaches, &
      & h_tangential_forces = h_axis + path_tangential_forces, h_tangential_displacements = h_axis + path_tangential_displacements
   !> Results in the order of their rows; a component is the index of its row.
   type :: hertz_history_output_t
      !> Indices of the rows.
      integer :: axis_ratio = 0, major_axis_angle = 0
   end type hertz_history_output_t
   type(hertz_history_output_t), parameter, public :: hertz_history_output = transfer(counting(n_path_results + 1:), &
      & hertz_history_output_t())
   integer, parameter, public :: n_hertz_history_results = hertz_history_output%major_axis_angle

   !> Units must be between these powers of ten, or numbers have no space.
   integer, parameter :: largest_unit = 70

   !> The model.
   type, extends(history_model_t) :: hertz_history_t
   contains
      procedure :: check_bodies
      procedure :: find_contacts
      procedure :: solve_point
      procedure :: measure
   end type hertz_history_t

   !> Normal states of all similar contacts, in units of the largest one.
   type, extends(normal_contact_t) :: similar_states_t
   contains
      procedure :: under_load
      procedure :: at_approach
   end type similar_states_t

contains

   !> The model with its tables.
   subroutine new_hertz_history(self)
      !> Receives its names and its tables.
      type(hertz_history_t), intent(out) :: self
      type(variable_t), allocatable :: rows(:)

      self%name = 'hertz_history'
      self%summary = 'bodies that touch on a circle or an ellipse, with friction, through a path of forces or displacements'
      allocate (rows, source=get_hertz_variables())
      ! the axis of the force stands behind the moduli
      rows(h_axis) = rows(hertz_input%tangential_axis)
      rows(hertz_input%kind)%meaning = 'spheres, or any smooth bodies; a line has no displacement and is refused'
      call self%set_history_tables(rows(:h_axis), [hertz_input%contact_modulus, hertz_input%second_poisson_ratio], &
         & profile_t(name='contact_half_width', unit='m', long_name='half-width a of contact, along the major axis'), &
         & profile_t(name='stick_half_width', unit='m', long_name='that of what does not slip at the end of the step'))
      allocate (self%results(n_hertz_history_results))
      call set_path_results(self%results(:n_path_results))
      self%results(hertz_history_output%axis_ratio) = result_row(name='axis_ratio', unit='-', &
         & long_name='minor over major half-width, of all contacts of the path and of what sticks')
      self%results(hertz_history_output%major_axis_angle) = result_row(name='major_axis_angle', unit='rad', &
         & long_name='from the first principal direction of body 1 to the major axis')
   end subroutine new_hertz_history

   !> See `history_model_t`.
   subroutine check_bodies(self, values, problems)
      class(hertz_history_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: kind

      call require(self%variables, values, [hertz_input%kind], problems)
      call check_contact_modulus(self%variables(hertz_input%contact_modulus:hertz_input%second_poisson_ratio), &
         & values(hertz_input%contact_modulus:hertz_input%second_poisson_ratio), problems, .true.)
      if (.not. is_set(values(hertz_input%kind))) return
      kind = nint(values(hertz_input%kind))
      if (kind == kind_line) then
         call problems%add('contact', 'kind', 'is ''line'', whose displacement is undefined, for it grows like a ' &
            & //'logarithm; allowed: circular, elliptical')
         return
      end if
      if (is_set(values(h_axis)) .and. kind /= kind_elliptical) call problems%add('operating', 'tangential_axis', &
         & 'has no meaning for this kind')
      call check_radii(self%variables, values, problems)
   end subroutine check_bodies

   !> See `history_model_t`.
   subroutine find_contacts(self, values, contacts, units, is_possible)
      class(hertz_history_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the contacts, reduced; not allocated where they are not possible.
      class(normal_contact_t), allocatable, intent(out) :: contacts
      !> Receives their units.
      type(history_units_t), intent(out) :: units
      !> Are the largest contact of the path and its units within the numbers?
      logical, intent(out) :: is_possible
      type(ellipse_t) :: largest

      call find_largest(self, values, largest, is_possible)
      if (.not. is_possible) return
      units%force = largest%load
      units%approach = largest%approach
      units%length = largest%major
      units%compliance_ratio = pi*contact_modulus_of(values(hertz_input%contact_modulus:hertz_input%second_poisson_ratio)) &
         & *bonded_compliance(values(hertz_input%contact_modulus:hertz_input%second_poisson_ratio), largest%shape, &
         & is_along_minor(values)) &
         & /largest%shape%f
      allocate (similar_states_t :: contacts)
   end subroutine find_contacts

   !> Does the force act along the minor axis?
   pure logical function is_along_minor(values)
      real(dp), intent(in) :: values(:)

      is_along_minor = is_set(values(h_axis))
      if (is_along_minor) is_along_minor = nint(values(h_axis)) == axis_minor
   end function is_along_minor

   !> The largest contact of the path.
   pure subroutine find_largest(self, values, largest, is_possible)
      class(hertz_history_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(ellipse_t), intent(out) :: largest
      logical, intent(out) :: is_possible
      real(dp), parameter :: most = 10.0_dp**largest_unit
      type(ellipse_shape_t) :: shape
      real(dp) :: a, b, direction, modulus

      is_possible = .false.
      call get_curvatures(values, a, b, direction)
      if (.not. a > 0) return
      call find_shape(a/b, shape)
      if (.not. shape%is_converged) return
      modulus = contact_modulus_of(values(hertz_input%contact_modulus:hertz_input%second_poisson_ratio))
      if (is_set(values(h_loads))) then
         call ellipse_of_load(a, b, modulus, self%largest_of(values, path_loads), shape, largest)
      else
         call ellipse_of_approach(a, b, modulus, self%largest_of(values, path_approaches), shape, largest)
      end if
      associate (sizes => [largest%load, largest%approach, largest%major, largest%minor])
         is_possible = minval(sizes) > 1/most .and. maxval(sizes) < most
      end associate
   end subroutine find_largest

   !> See `model_t`: the largest contact of the path.
   subroutine measure(self, values, results, measures)
      class(hertz_history_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the point, none of which is needed; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> In: all `not_measured`. Out: with what is measured; shape `(n_doubts)`.
      real(dp), intent(inout) :: measures(:)
      type(ellipse_t) :: largest
      real(dp) :: a, b, direction
      logical :: is_possible

      call find_largest(self, values, largest, is_possible)
      if (.not. is_possible) return
      call get_curvatures(values, a, b, direction)
      measures(doubt_contact_too_wide) = steepest_edge(values, largest%major, largest%minor, direction)
      associate (unused => results)
      end associate
   end subroutine measure

   !> See `pointwise_model_t`: the path, and the shape of the ellipse.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
      class(hertz_history_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the steps, for the profiles; nothing is taken from the point before.
      class(point_state_t), allocatable, intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Relative error of the energy that friction takes, and at least round-off.
      real(dp), intent(out) :: error_estimate
      !> One of `status_...`.
      integer, intent(out) :: status
      !> This model counts nothing; size 0.
      real(dp), intent(inout) :: counts(:)
      type(ellipse_shape_t) :: shape
      real(dp) :: a, b, direction

      call solve_path(self, values, state, results, error_estimate, status)
      if (status /= status_solved) return
      call get_curvatures(values, a, b, direction)
      call find_shape(a/b, shape)
      results([hertz_history_output%axis_ratio, hertz_history_output%major_axis_angle]) = [shape%axis_ratio, direction]
      associate (unused_counts => counts)
      end associate
   end subroutine solve_point

   !> See `normal_contact_t`.
   pure subroutine under_load(self, given, state, is_converged)
      class(similar_states_t), intent(in) :: self
      !> Load, over the largest one.
      real(dp), intent(in) :: given
      type(normal_state_t), intent(out) :: state
      logical, intent(out) :: is_converged
      real(dp) :: x

      x = cube_root(given)
      state = normal_state_t(load=given, approach=x**2, work=0.4_dp*given*x**2, stiffness=1.5_dp*x, radius=x)
      is_converged = .true.
      associate (unused => self)
      end associate
   end subroutine under_load

   !> See `normal_contact_t`.
   pure subroutine at_approach(self, given, state, is_converged)
      class(similar_states_t), intent(in) :: self
      !> Approach, over the largest one.
      real(dp), intent(in) :: given
      type(normal_state_t), intent(out) :: state
      logical, intent(out) :: is_converged
      real(dp) :: x

      x = sqrt(given)
      state = normal_state_t(load=given*x, approach=given, work=0.4_dp*given**2*x, stiffness=1.5_dp*x, radius=x)
      is_converged = .true.
      associate (unused => self)
      end associate
   end subroutine at_approach

end module adfric_plane_hertz_history_model
