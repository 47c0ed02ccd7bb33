! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `free_surface`: a rigid body, given by its heights on a map, on an elastic half-space that goes on beyond the map
!> without it.
module adfric_periodic_free_model
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t, file_failure
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_number
   use adfric_base_unset, only: is_set
   use adfric_describe_check, only: refuse_swept, require_one
   use adfric_describe_derived, only: add_derived, derived_t
   use adfric_describe_doubt, only: doubt_slope_too_steep
   use adfric_describe_pointwise, only: point_state_t, pointwise_model_t
   use adfric_describe_rows, only: contact_profiles, count_row, set_coordinate
   use adfric_describe_status, only: status_not_converged, status_out_of_memory, status_solved
   use adfric_describe_table, only: profile_axis_t
   use adfric_periodic_area, only: relative_error_of
   use adfric_periodic_free_rows, only: boundaries_periodic, get_free_results, &
      & get_free_variables, in => free_input, is_periodic_by, out => free_output
   use adfric_periodic_free_solver, only: free_solution_t, free_solver_t, new_free_solver, solve_free
   use adfric_periodic_given_heights, only: given_heights_t
   use adfric_periodic_point, only: periodic_surface_t
   use adfric_solid_contact_modulus, only: check_contact_modulus, contact_modulus_of, derive_contact_modulus, n_two_bodies
   implicit none (type, external)
   private
   public :: free_model_t, new_free_model

   !> Points that share their transforms.
   integer, parameter :: most_neighbours = 4

   !> The model `free_surface`.
   type, extends(pointwise_model_t) :: free_model_t
      private
      !> Heights of the input.
      type(given_heights_t) :: given
   contains
      procedure :: take_dataset
      procedure :: check_values
      procedure :: wants_profiles
      procedure :: get_profile_axes
      procedure :: solve_point
      procedure :: fill_profiles
      procedure :: derive_quantities
      procedure :: describe_case
      procedure :: describe_doubts
      procedure :: measure
   end type free_model_t

   !> What a point leaves for the next one, and for its maps.
   type, extends(point_state_t) :: free_point_state_t
      !> Lengths and cells of the map, and the undeformed gap [m].
      type(periodic_surface_t) :: surface
      !> Boundaries that the solver is made for.
      logical :: is_periodic(2) = .false.
      !> Number of cells, and ratio of the lengths, of the solver.
      integer :: n_cells(2) = 0
      !> Length along y over that along x.
      real(dp) :: ratio = 0
      !> Solver with its transforms; not allocated before the first point.
      type(free_solver_t), allocatable :: solver
      !> Solution, with lengths in `length_x` and pressures in E*.
      type(free_solution_t) :: solution
   end type free_point_state_t

contains

   !> The model with its tables.
   subroutine new_free_model(self)
      !> The new model; receives its tables.
      type(free_model_t), intent(out) :: self

      self%name = 'free_surface'
      self%summary = 'a rigid body of given heights on an elastic half-space, alone or periodic in one direction: load, area'
      self%references = 'A. E. H. Love, Phil. Trans. R. Soc. Lond. A 228 (1929) 377; '// &
         & 'R. W. Hockney, Methods Comput. Phys. 9 (1970) 135'
      self%variables = get_free_variables()
      self%results = get_free_results()
      self%profiles = contact_profiles()
      allocate (self%counts(1))
      self%counts(1) = count_row(name='iterations_per_point', long_name='iterations on the finest grid')
      self%profile_axes = 'y x'
      self%largest_block = most_neighbours
      self%shares_points = .true.
      self%given%has_border = .true.
   end subroutine new_free_model

   !> See `model_t`.
   subroutine take_dataset(self, index, values, problems)
      class(free_model_t), intent(inout) :: self
      !> Index of the heights in `variables`.
      integer, intent(in) :: index
      !> Heights of the body [m], NaN where they are not known; shape `(nx, ny)`.
      real(dp), intent(in) :: values(:, :)
      type(problems_t), intent(inout) :: problems

      call self%given%take(self%variables(index), values, problems)
   end subroutine take_dataset

   !> See `model_t`.
   subroutine check_values(self, values, is_swept, problems)
      class(free_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout) :: problems

      call self%given%check(self%variables(in%heights:in%rms_height), values(in%heights:in%rms_height), problems)
      if (self%wants_profiles(values)) call refuse_swept(self%variables, is_swept, [in%length_x, in%length_y], problems)
      call check_contact_modulus(self%variables(in%modulus:in%modulus + n_two_bodies - 1), &
         & values(in%modulus:in%modulus + n_two_bodies - 1), problems, .false.)
      if (nint(values(in%boundaries)) == boundaries_periodic) call problems%add('solid', 'boundaries', &
         & 'are periodic in both directions, which the model surface_elastic solves')
      call check_images(self, values, problems)
      call require_one(self%variables, values, [in%load, in%approach], .true., problems)
   end subroutine check_values

   !> A cell that is much longer than the period of its images has no sum of them (`adfric_periodic_free_influence`).
   subroutine check_images(self, values, problems)
      class(free_model_t), intent(in) :: self
      !> Values of the variables.
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      type(periodic_surface_t) :: surface
      logical :: is_periodic(2)
      real(dp) :: sizes(2)
      integer :: along

      if (.not. allocated(self%given%is_body)) return
      if (.not. (is_set(values(in%heights)) .and. is_set(values(in%length_x)) .and. is_set(values(in%length_y)))) return
      is_periodic = is_periodic_by(values(in%boundaries))
      if (count(is_periodic) /= 1) return
      call self%given%get_cells(values(in%heights:in%rms_height), surface)
      along = merge(1, 2, is_periodic(1))
      sizes = surface%cell_sizes()
      if (sizes(3 - along) > surface%period(along)) call problems%add('surface', merge('length_x', 'length_y', along == 1), &
         & 'is a period shorter than the cells are long across it, given '//show_number(surface%period(along))// &
         & ' m, allowed: at least '//show_number(sizes(3 - along))//' m')
   end subroutine check_images

   !> See `model_t`.
   pure logical function wants_profiles(self, values)
      class(free_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      wants_profiles = values(in%profiles) > 0
      associate (unused => self)
      end associate
   end function wants_profiles

   !> See `model_t`: the middles of the cells.
   subroutine get_profile_axes(self, values, axes)
      class(free_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(profile_axis_t), allocatable, intent(out) :: axes(:)
      type(periodic_surface_t) :: surface
      integer :: along

      allocate (axes(2))
      call self%given%get_cells(values(in%heights:in%rms_height), surface)
      do along = 1, 2
         call set_coordinate(axes(3 - along), self%profile_axes, 3 - along, surface%middles(along))
      end do
   end subroutine get_profile_axes

   !> See `pointwise_model_t`.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
      class(free_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Solver of the point before; receives solver and solution of this point.
      class(point_state_t), allocatable, intent(inout) :: state
      real(dp), intent(inout) :: results(:)
      real(dp), intent(out) :: error_estimate
      integer, intent(out) :: status
      !> One number, to which the iterations on the finest grid are added.
      real(dp), intent(inout) :: counts(:)
      type(error_t), allocatable :: error
      real(dp) :: unit, modulus, prescribed
      logical :: has_load

      if (.not. allocated(state)) allocate (free_point_state_t :: state)
      status = status_not_converged
      error_estimate = 0
      select type (state)
      type is (free_point_state_t)
         call self%given%get_cells(values(in%heights:in%rms_height), state%surface)
         call self%given%get_shape(values(in%heights:in%rms_height), state%surface%shape)
         call prepare_solver(self, state, is_periodic_by(values(in%boundaries)), error)
         if (allocated(error)) then
            if (error%code == file_failure) status = status_out_of_memory
            return
         end if
         unit = state%surface%period(1)
         modulus = contact_modulus_of(values(in%modulus:in%modulus + n_two_bodies - 1))
         has_load = is_set(values(in%load))
         if (has_load) prescribed = values(in%load)/modulus/unit/unit
         if (.not. has_load) prescribed = values(in%approach)/unit
         call solve_free(state%solver, state%surface%shape/unit, self%given%is_body, has_load, prescribed, values(in%tolerance), &
            & state%solution)
         counts(1) = counts(1) + state%solution%n_iterations
         if (.not. state%solution%is_converged) return
         status = status_solved
         call store(values, state, modulus, results)
         error_estimate = error_of(state%solution, has_load)
      end select
   end subroutine solve_point

   !> Make a solver, unless that of the point before serves.
   subroutine prepare_solver(self, state, is_periodic, error)
      class(free_model_t), intent(in) :: self
      type(free_point_state_t), intent(inout) :: state
      !> Does the surface go on periodically along x, along y?
      logical, intent(in) :: is_periodic(2)
      type(error_t), allocatable, intent(out) :: error
      real(dp) :: ratio

      associate (surface => state%surface)
         ratio = surface%period(2)/surface%period(1)
         if (allocated(state%solver)) then
            if (all(state%n_cells == surface%n_cells) .and. all(state%is_periodic .eqv. is_periodic) &
               & .and. .not. abs(state%ratio - ratio) > 0) return
            deallocate (state%solver)
         end if
         allocate (state%solver)
         call new_free_solver(state%solver, surface%n_cells, [1.0_dp, ratio], is_periodic, self%watch, error)
         if (allocated(error)) then
            deallocate (state%solver)
            return
         end if
         state%n_cells = surface%n_cells
         state%ratio = ratio
         state%is_periodic = is_periodic
      end associate
   end subroutine prepare_solver

   !> Relative error of area, and of load or approach, whichever is not given.
   pure real(dp) function error_of(solution, has_load) result(error)
      type(free_solution_t), intent(in) :: solution
      logical, intent(in) :: has_load

      error = relative_error_of(solution%area)
      if (has_load) then
         error = max(error, ratio_of(solution%approach_error, solution%approach))
      else
         error = max(error, ratio_of(solution%load_error, solution%load))
      end if

   contains

      !> Error of a value relative to it, 1 at most; 0 without error.
      pure real(dp) function ratio_of(error, value)
         real(dp), intent(in) :: error, value

         ratio_of = 0
         if (error > 0) ratio_of = error/max(abs(value), error)
      end function ratio_of

   end function error_of

   !> Set the results of a point.
   subroutine store(values, state, modulus, results)
      real(dp), intent(in) :: values(:)
      type(free_point_state_t), intent(in) :: state
      !> Contact modulus E* [Pa].
      real(dp), intent(in) :: modulus
      !> In: all NaN. Out: with what has a value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      real(dp) :: force, cell, map
      integer :: i

      associate (s => state%solution, unit => state%surface%period(1), lengths => state%surface%period, n => state%n_cells)
         map = product(lengths)
         force = modulus*unit*unit
         cell = force*(state%ratio/product(real(n, dp)))
         results(out%load) = s%load*force
         results(out%approach) = s%approach*unit
         ! what was given comes back to the last digit
         if (is_set(values(in%load))) results(out%load) = values(in%load)
         if (is_set(values(in%approach))) results(out%approach) = values(in%approach)
         results(out%contact_area) = s%area%corrected*map
         results(out%contact_area_error) = s%area%error*map
         results(out%smooth_area) = s%smooth_area*map
         if (s%area%corrected > 0) results(out%mean_contact_pressure) = results(out%load)/results(out%contact_area)
         results(out%peak_pressure) = maxval(s%pressure)*modulus
         results(out%elastic_energy) = s%elastic_energy*force*unit
         if (.not. state%is_periodic(2)) results(out%moment_x) = cell*lengths(2)*sum( &
            & [((i - 0.5_dp)/n(2) - 0.5_dp, i=1, n(2))]*sum(s%pressure, 1))
         if (.not. state%is_periodic(1)) results(out%moment_y) = -cell*lengths(1)*sum( &
            & [((i - 0.5_dp)/n(1) - 0.5_dp, i=1, n(1))]*sum(s%pressure, 2))
         results(out%violation) = s%residual
      end associate
   end subroutine store

   !> See `pointwise_model_t`: the maps of pressure and gap, which has no value beside the body.
   subroutine fill_profiles(self, values, results, state, axes, profiles)
      class(free_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      real(dp), intent(in) :: results(:)
      class(point_state_t), allocatable, intent(in) :: state
      type(profile_axis_t), intent(in) :: axes(:)
      !> Receives the maps of pressure [Pa] and gap [m]; shape `(nx, ny, 2)`.
      real(dp), intent(inout) :: profiles(:, :, :)

      select type (state)
      type is (free_point_state_t)
         profiles(:, :, 1) = state%solution%pressure*contact_modulus_of(values(in%modulus:in%modulus + n_two_bodies - 1))
         profiles(:, :, 2) = state%solution%gap*state%surface%period(1)
         where (.not. self%given%is_body) profiles(:, :, 2) = not_a_number()
      end select
      associate (unused_results => results, unused_axes => axes)
      end associate
   end subroutine fill_profiles

   !> See `model_t`.
   function derive_quantities(self, values) result(derived)
      class(free_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: derived(:)

      derived = derive_contact_modulus(self%variables(in%modulus:in%modulus + n_two_bodies - 1), &
         & values(in%modulus:in%modulus + n_two_bodies - 1))
      call add_derived(derived, 'root_mean_square_height', 'm', 'root of the mean square of the heights', &
         & self%given%factor_of(values(in%heights:in%rms_height))*self%given%root_mean_square)
   end function derive_quantities

   !> See `model_t`.
   function describe_case(self, values) result(text)
      class(free_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = self%given%describe(.false.)
      associate (unused => values)
      end associate
   end function describe_case

   !> See `model_t`: edges that do not meet along the period.
   function describe_doubts(self, values) result(text)
      class(free_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = self%given%doubt(is_periodic_by(values(in%boundaries)))
   end function describe_doubts

   !> See `model_t`: the mean slope of the heights.
   subroutine measure(self, values, results, measures)
      class(free_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      real(dp), intent(in) :: results(:)
      real(dp), intent(inout) :: measures(:)

      measures(doubt_slope_too_steep) = self%given%slope(values(in%heights:in%rms_height))
      associate (unused => results)
      end associate
   end subroutine measure

end module adfric_periodic_free_model
