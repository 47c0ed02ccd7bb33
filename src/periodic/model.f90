! SPDX-License-Identifier: GPL-3.0-or-later
!> What the models of a periodic surface share; a model says what its surface and its solid are. The file is long by the interfaces
!> of what a model says, and by the answers of those that say nothing.
module adfric_periodic_model
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t, file_failure
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_describe_derived, only: derived_t, add_derived
   use adfric_describe_pointwise, only: pointwise_model_t, point_state_t
   use adfric_describe_check, only: require_one
   use adfric_describe_rows, only: contact_profiles, count_row, set_coordinate
   use adfric_describe_status, only: status_solved, status_no_equilibrium, status_not_converged, status_out_of_memory
   use adfric_describe_table, only: variable_t, profile_axis_t
   use adfric_numerics_found_once, only: found_once_t
   use adfric_periodic_area, only: relative_error_of
   use adfric_periodic_point, only: periodic_surface_t, periodic_solid_t, periodic_goal_t, periodic_memory_t, &
      & solve_periodic, find_full_pressure, find_near_contacts
   use adfric_periodic_slip, only: periodic_slip_t
   use adfric_periodic_solver, only: periodic_solution_t, contact_solved, contact_out_of_range
   use adfric_periodic_variables, only: get_periodic_results, n_prescribed, set_prescribed_rows, tolerance_row, &
      & in => periodic_input, out => periodic_output
   implicit none (type, external)
   private
   public :: periodic_model_t

   !> What the models of periodic surfaces share: how a point is solved, its results and its maps.
   type, abstract, extends(pointwise_model_t) :: periodic_model_t
      !> Indices of the tolerance, of the first and last row of the solid, and of the row before those of what is prescribed.
      integer :: v_tolerance = 0, first_of_solid = 0, last_of_solid = 0, before_prescribed = 0
      !> Is the pressure of full contact known in closed form, so that nothing is computed on the cells?
      logical :: knows_full_pressure = .false.
      !> Pull-offs that the points of a run share; null unless the model is prepared.
      type(found_once_t), pointer :: pull_offs => null()
   contains
      procedure :: prepare
      procedure, non_overridable :: prepare_contacts => prepare
      procedure :: release
      procedure, non_overridable :: release_contacts => release
      procedure :: set_tables
      procedure :: check_values
      procedure :: wants_profiles
      procedure :: get_profile_axes
      procedure :: solve_point
      procedure, non_overridable :: solve_contact => solve_point
      procedure :: fill_profiles
      procedure, non_overridable :: fill_contact_maps => fill_profiles
      procedure :: derive_quantities
      procedure, non_overridable :: derive_surface => derive_quantities
      procedure :: describe_case
      procedure :: describe_surface
      procedure :: solve_in_closed_form
      procedure :: set_interface
      procedure :: finish_point
      procedure :: store_slip
      procedure :: store_depth
      procedure :: derive_solid
      procedure(check_surface_i), deferred :: check_surface
      procedure(get_cells_i), deferred :: get_cells
      procedure(get_shape_i), deferred :: get_shape
      procedure(check_solid_i), deferred :: check_solid
      procedure(set_solid_i), deferred :: set_solid
      procedure :: get_full_pressure
      procedure :: get_peak_pressure
   end type periodic_model_t

   abstract interface

      !> Add to `problems` what is missing or impossible of the surface.
      subroutine check_surface_i(self, values, is_swept, problems)
         import :: periodic_model_t, dp, problems_t
         implicit none (type, external)
         !> The model; its tables give the variables their names.
         class(periodic_model_t), intent(in) :: self
         !> Values of the variables, in the order of the table; shape `(n_variables)`.
         real(dp), intent(in) :: values(:)
         !> Is the variable swept? Shape `(n_variables)`.
         logical, intent(in) :: is_swept(:)
         !> Receives what is wrong with the input; nothing is removed.
         type(problems_t), intent(inout) :: problems
      end subroutine check_surface_i

      !> Periods and cells of the surface of a point, whose values have been checked.
      subroutine get_cells_i(self, values, surface)
         import :: periodic_model_t, dp, periodic_surface_t
         implicit none (type, external)
         !> The model whose surface is wanted.
         class(periodic_model_t), intent(in) :: self
         real(dp), intent(in) :: values(:)
         !> Receives all but the map `shape`, which stays as it is.
         type(periodic_surface_t), intent(inout) :: surface
      end subroutine get_cells_i

      !> The undeformed gap of the surface of a point.
      subroutine get_shape_i(self, values, shape)
         import :: periodic_model_t, dp
         implicit none (type, external)
         class(periodic_model_t), intent(in) :: self
         real(dp), intent(in) :: values(:)
         !> In: the map of the point before, not allocated at the first one. Out: that of this point, which is not copied again
         !> where it is the same [m]; not allocated if there is no memory.
         real(dp), allocatable, intent(inout) :: shape(:, :)
      end subroutine get_shape_i

      !> Add to `problems` what is missing or impossible of the solid.
      subroutine check_solid_i(self, values, is_swept, problems)
         import :: periodic_model_t, dp, problems_t
         implicit none (type, external)
         class(periodic_model_t), intent(in) :: self
         real(dp), intent(in) :: values(:)
         logical, intent(in) :: is_swept(:)
         type(problems_t), intent(inout) :: problems
      end subroutine check_solid_i

      !> The solid of a point, whose values have been checked.
      subroutine set_solid_i(self, values, surface)
         import :: periodic_model_t, dp, periodic_surface_t
         implicit none (type, external)
         !> The model whose solid is wanted.
         class(periodic_model_t), intent(in) :: self
         real(dp), intent(in) :: values(:)
         !> In: with periods and cells. Out: also with `solid`.
         type(periodic_surface_t), intent(inout) :: surface
      end subroutine set_solid_i

   end interface

   !> What a point leaves: its surface and solver for the next point, and its solution for the maps.
   type, extends(point_state_t) :: periodic_state_t
      !> Surface of the point; its map is taken over where the next point has the same.
      type(periodic_surface_t) :: surface
      !> Solver of the point, with its transforms.
      type(periodic_memory_t) :: memory
      !> Pressure, gap and area of the point.
      type(periodic_solution_t) :: solution
      !> Partial slip of the point; not allocated without.
      type(periodic_slip_t), allocatable :: slip
   end type periodic_state_t

   !> Points that share their transforms.
   integer, parameter :: most_neighbours = 4

contains

   !> Mean pressure at which contact becomes full [Pa]: that of the cells, unless a model knows better.
   pure real(dp) function get_full_pressure(self, values, solid, on_cells)
      !> The model whose pressure of full contact is wanted.
      class(periodic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> The solid of the point.
      class(periodic_solid_t), intent(in) :: solid
      !> Pressure of full contact of the surface as its cells have it [E*]; of no meaning where the model `knows_full_pressure`.
      real(dp), intent(in) :: on_cells

      get_full_pressure = solid%modulus*on_cells
      associate (unused => self, unused_values => values)
      end associate
   end function get_full_pressure

   !> The largest pressure of a map, in its unit: that of a cell, unless a model knows better.
   real(dp) function get_peak_pressure(self, values, pressure)
      !> The model whose largest pressure is wanted.
      class(periodic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Pressure in the middles of the cells; shape `(nx, ny)`.
      real(dp), intent(in) :: pressure(:, :)

      get_peak_pressure = maxval(pressure)
      associate (unused => self, unused_values => values)
      end associate
   end function get_peak_pressure

   !> Set the tables of the model.
   subroutine set_tables(self, name, summary, surface, solid, may_pull)
      class(periodic_model_t), intent(inout) :: self
      !> Name of the model in `&job model = ...`.
      character(*), intent(in) :: name
      !> What the model is, in one line for `adfric help`.
      character(*), intent(in) :: summary
      !> Variables of the surface, and those of the solid.
      type(variable_t), intent(in) :: surface(:), solid(:)
      !> May the load be below 0?
      logical, intent(in) :: may_pull

      self%name = name
      self%summary = summary
      self%references = 'K. L. Johnson, J. A. Greenwood, J. G. Higginson, Int. J. Mech. Sci. 27 (1985) 383'
      self%v_tolerance = size(surface) + 1
      self%first_of_solid = self%v_tolerance + 1
      self%last_of_solid = self%v_tolerance + size(solid)
      self%before_prescribed = self%last_of_solid
      allocate (self%variables(self%before_prescribed + n_prescribed))
      self%variables(:size(surface)) = surface
      self%variables(self%v_tolerance) = tolerance_row()
      self%variables(self%first_of_solid:self%last_of_solid) = solid
      call set_prescribed_rows(self%variables(self%before_prescribed + 1:), may_pull)
      self%results = get_periodic_results()
      self%profiles = contact_profiles()
      allocate (self%counts(1))
      self%counts(1) = count_row(name='iterations_per_point', long_name='iterations on the finest grid')
      self%profile_axes = 'y x'
      self%largest_block = most_neighbours
      self%shares_points = .true.
   end subroutine set_tables

   !> Make space for the pull-offs that points share.
   subroutine prepare(self)
      class(periodic_model_t), intent(inout) :: self

      if (.not. associated(self%pull_offs)) allocate (self%pull_offs)
   end subroutine prepare

   !> Give back the pull-offs that points have shared.
   subroutine release(self)
      class(periodic_model_t), intent(inout) :: self

      if (.not. associated(self%pull_offs)) return
      call self%pull_offs%clear()
      deallocate (self%pull_offs)
   end subroutine release

   !> See `model_t`.
   subroutine check_values(self, values, is_swept, problems)
      class(periodic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout) :: problems

      call self%check_surface(values, is_swept, problems)
      call self%check_solid(values, is_swept, problems)
      call require_one(self%variables, values, self%before_prescribed + [in%mean_pressure, in%penetration], .true., problems)
   end subroutine check_values

   !> See `model_t`.
   pure logical function wants_profiles(self, values)
      !> The model, for the index of its switch of the profiles.
      class(periodic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      wants_profiles = values(self%before_prescribed + in%profiles) > 0
   end function wants_profiles

   !> See `model_t`: the middles of the cells.
   subroutine get_profile_axes(self, values, axes)
      class(periodic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(profile_axis_t), allocatable, intent(out) :: axes(:)
      type(periodic_surface_t) :: surface
      integer :: along

      allocate (axes(2))
      call self%get_cells(values, surface)
      do along = 1, 2
         call set_coordinate(axes(3 - along), self%profile_axes, 3 - along, surface%middles(along))
      end do
   end subroutine get_profile_axes

   !> What is prescribed at a point.
   type(periodic_goal_t) function get_goal(self, values, modulus) result(goal)
      class(periodic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Contact modulus E* [Pa].
      real(dp), intent(in) :: modulus

      goal%tolerance = values(self%v_tolerance)
      associate (v => values(self%before_prescribed + 1:))
         goal%is_pressure = is_set(v(in%mean_pressure))
         if (goal%is_pressure) goal%value = v(in%mean_pressure)/modulus
         if (.not. goal%is_pressure) goal%value = v(in%penetration)
      end associate
   end function get_goal

   !> See `pointwise_model_t`.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
      !> The model, which says what the surface of the point is.
      class(periodic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Solver and solution of the point before; receives those of this point.
      class(point_state_t), allocatable, intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the main result [-]; 0 where the point is not solved.
      real(dp), intent(out) :: error_estimate
      !> Status of the point, one of `status_...`.
      integer, intent(out) :: status
      !> One number, to which the iterations on the finest grid are added.
      real(dp), intent(inout) :: counts(:)
      type(error_t), allocatable :: error
      type(periodic_goal_t) :: goal
      logical :: is_known, has_memory

      if (.not. allocated(state)) allocate (periodic_state_t :: state)
      status = status_not_converged
      error_estimate = 0
      select type (state)
      type is (periodic_state_t)
         call self%get_cells(values, state%surface)
         call self%get_shape(values, state%surface%shape)
         if (.not. allocated(state%surface%shape)) then
            status = status_out_of_memory
            return
         end if
         call self%set_solid(values, state%surface)
         goal = get_goal(self, values, state%surface%solid%modulus)
         call self%set_interface(values, state%surface, goal)
         goal%watch => self%watch
         goal%pull_offs => self%pull_offs
         ! what follows may end without a solution of its own
         state%solution%n_iterations = 0
         if (allocated(state%slip)) deallocate (state%slip)
         if (allocated(state%solution%near)) deallocate (state%solution%near)
         call self%solve_in_closed_form(values, state%surface, goal, state%solution, is_known)
         if (.not. is_known) call solve_periodic(state%surface, goal, state%memory, state%solution, state%slip, error)
         if (allocated(error)) then
            ! cells of a sweep may be too long, which is no lack of memory
            if (error%code == file_failure) status = status_out_of_memory
            return
         end if
         if (state%solution%status == contact_out_of_range) status = status_no_equilibrium
         counts(1) = counts(1) + state%solution%n_iterations
         if (state%solution%status /= contact_solved) return
         status = status_solved
         if (goal%wants_near) call find_near_contacts(state%surface, goal, state%memory, state%solution)
         call store(self, values, state%surface%solid, state%solution, results)
         call self%finish_point(values, state%surface, state%solution, results, error_estimate)
         if (allocated(state%slip)) call self%store_slip(values, state%surface, state%slip, results)
         has_memory = .true.
         if (error_estimate <= 1) call self%store_depth(values, state%surface, state%solution, results, has_memory, state%slip)
         if (error_estimate <= 1 .and. has_memory) return
         status = merge(status_not_converged, status_out_of_memory, has_memory)
         error_estimate = 0
         results(:) = not_a_number()
      end select
   end subroutine solve_point

   !> See `pointwise_model_t`: the maps of pressure and gap, and of the shear stress in partial slip, or of flashes.
   subroutine fill_profiles(self, values, results, state, axes, profiles)
      class(periodic_model_t), intent(in) :: self
      !> Values of the variables, not used here.
      real(dp), intent(in) :: values(:)
      !> Results of the point, not used here.
      real(dp), intent(in) :: results(:)
      class(point_state_t), allocatable, intent(in) :: state
      !> Axes of the maps, not used here: a map has a value in each cell.
      type(profile_axis_t), intent(in) :: axes(:)
      !> Receives the maps of pressure [Pa], gap [m], shear stress [Pa], and flashes [K] or impressions [m]; shape
      !> `(nx, ny, n_profiles)`.
      real(dp), intent(inout) :: profiles(:, :, :)

      select type (state)
      type is (periodic_state_t)
         profiles(:, :, 1) = state%solution%pressure*state%surface%solid%modulus
         profiles(:, :, 2) = state%solution%gap
         if (allocated(state%slip)) profiles(:, :, 3) = state%slip%traction*state%surface%solid%modulus
         if (allocated(state%solution%flash)) profiles(:, :, 4) = state%solution%flash
         if (allocated(state%solution%plastic_depth)) profiles(:, :, 4) = state%solution%plastic_depth
      end select
      associate (unused => self, unused_values => values, unused_results => results, unused_axes => axes)
      end associate
   end subroutine fill_profiles

   !> Set the results of a point.
   subroutine store(self, values, solid, solution, results)
      !> The model, which finds peak pressure and pressure of full contact.
      class(periodic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      class(periodic_solid_t), intent(in) :: solid
      !> Solution of the point; lengths in m, pressures in E*.
      type(periodic_solution_t), intent(in) :: solution
      !> In: all NaN. Out: with those that all these models have; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)

      associate (s => solution, v => values(self%before_prescribed + 1:))
         results(out%mean_pressure) = s%mean_pressure*solid%modulus
         results(out%penetration) = s%penetration
         ! what was given comes back to the last digit
         if (is_set(v(in%mean_pressure))) results(out%mean_pressure) = v(in%mean_pressure)
         if (is_set(v(in%penetration))) results(out%penetration) = v(in%penetration)
         results(out%contact_fraction) = s%area%corrected
         results(out%contact_fraction_error) = s%area%error
         results(out%peak_pressure) = solid%modulus*self%get_peak_pressure(values, s%pressure)
         results(out%mean_gap) = sum(s%gap)/size(s%gap)
         results(out%full_contact_pressure) = self%get_full_pressure(values, solid, s%full_pressure)
         results(out%contact_violation) = s%residual
      end associate
   end subroutine store

   !> Solve a point whose solution is known in closed form: none. A model may override it.
   subroutine solve_in_closed_form(self, values, surface, goal, solution, is_known)
      class(periodic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Periods and undeformed gap of the surface [m], and its solid.
      type(periodic_surface_t), intent(in) :: surface
      type(periodic_goal_t), intent(in) :: goal
      !> Receives the solution if it is known; lengths in m, pressures in E*.
      type(periodic_solution_t), intent(inout) :: solution
      logical, intent(out) :: is_known

      is_known = .false.
      associate (unused => self, unused_values => values, unused_surface => surface, unused_goal => goal, &
         & unused_solution => solution)
      end associate
   end subroutine solve_in_closed_form

   !> Adhesion and friction of a point: none. A model may override it.
   subroutine set_interface(self, values, surface, goal)
      class(periodic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Periods and cells of the surface [m], and its solid, not used here.
      type(periodic_surface_t), intent(in) :: surface
      !> What is prescribed at the point; may receive adhesion or friction.
      type(periodic_goal_t), intent(inout) :: goal

      if (allocated(goal%adhesion)) deallocate (goal%adhesion)
      if (allocated(goal%friction)) deallocate (goal%friction)
      associate (unused => self, unused_values => values, unused_surface => surface)
      end associate
   end subroutine set_interface

   !> Store the results of partial slip: none. A model may override it.
   subroutine store_slip(self, values, surface, slip, results)
      class(periodic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(periodic_surface_t), intent(in) :: surface
      !> Slip of the point; lengths in m, stresses in E*.
      type(periodic_slip_t), intent(in) :: slip
      !> In: with the results of the contact. Out: with all; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)

      associate (unused => self, unused_values => values, unused_surface => surface, unused_slip => slip, &
         & unused_results => results)
      end associate
   end subroutine store_slip

   !> Store stresses in depth: none. A model may override it.
   subroutine store_depth(self, values, surface, solution, results, has_memory, slip)
      class(periodic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(periodic_surface_t), intent(in) :: surface
      !> Solution of the point; lengths in m, pressures in E*.
      type(periodic_solution_t), intent(in) :: solution
      !> In: with the results of the contact. Out: with all; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Was there memory for them?
      logical, intent(out) :: has_memory
      !> Partial slip of the point; not present without.
      type(periodic_slip_t), intent(in), optional :: slip

      has_memory = .true.
      associate (unused => self, unused_values => values, unused_surface => surface, unused_solution => solution, &
         & unused_results => results, unused_slip => present(slip))
      end associate
   end subroutine store_depth

   !> The error of a solved point: that of the area of contact. A model may override it, and add results of its own.
   subroutine finish_point(self, values, surface, solution, results, error_estimate)
      class(periodic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(periodic_surface_t), intent(in) :: surface
      !> Solution of the point; lengths in m, pressures in E*.
      type(periodic_solution_t), intent(inout) :: solution
      !> In: with the results that all these models have. Out: with all; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the main result [-].
      real(dp), intent(out) :: error_estimate

      error_estimate = relative_error_of(solution%area)
      associate (unused => self, unused_values => values, unused_surface => surface, unused_results => results)
      end associate
   end subroutine finish_point

   !> See `model_t`.
   function derive_quantities(self, values) result(derived)
      class(periodic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: derived(:)
      type(periodic_surface_t) :: surface
      real(dp) :: mean, on_cells, pressure

      call self%get_cells(values, surface)
      call self%get_shape(values, surface%shape)
      call self%set_solid(values, surface)
      derived = self%derive_solid(values, surface)
      if (.not. allocated(surface%shape)) return
      on_cells = not_a_number()
      if (.not. self%knows_full_pressure) on_cells = find_full_pressure(surface)
      pressure = self%get_full_pressure(values, surface%solid, on_cells)
      call add_derived(derived, 'full_contact_pressure', 'Pa', 'pressure of full contact p*', pressure)
      mean = sum(surface%shape)/size(surface%shape)
      call add_derived(derived, 'full_contact_penetration', 'm', 'penetration of full contact', &
         & mean + pressure*mean_compliance_of(surface))
      call add_derived(derived, 'root_mean_square_height', 'm', 'root of the mean square of the heights', &
         & sqrt(sum((surface%shape - mean)**2)/size(surface%shape)))
   end function derive_quantities

   !> Mean compression of a layer over the mean pressure [m/Pa]; 0 for a half-space, which has none.
   pure real(dp) function mean_compliance_of(surface) result(compliance)
      type(periodic_surface_t), intent(in) :: surface

      compliance = 0
      associate (solid => surface%solid)
         if (allocated(solid%kernel)) compliance = solid%kernel%mean_compliance()*surface%period(1)/solid%modulus
      end associate
   end function mean_compliance_of

   !> Quantities that follow from the rows of the solid: none. A model may override it.
   function derive_solid(self, values, surface) result(derived)
      class(periodic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(periodic_surface_t), intent(in) :: surface
      type(derived_t), allocatable :: derived(:)

      allocate (derived(0))
      associate (unused => self, unused_values => values, unused_surface => surface)
      end associate
   end function derive_solid

   !> See `model_t`.
   function describe_case(self, values) result(text)
      class(periodic_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = self%describe_surface()
      associate (unused => values)
      end associate
   end function describe_case

   !> What else there is to say of the surface, a line each: nothing. A model may override it.
   function describe_surface(self) result(text)
      class(periodic_model_t), intent(in) :: self
      character(:), allocatable :: text

      text = ''
      associate (unused => self)
      end associate
   end function describe_surface

end module adfric_periodic_model
