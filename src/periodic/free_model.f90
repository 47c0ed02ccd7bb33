! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `free_surface`: a rigid body, given by its heights on a map, on an elastic half-space that goes on beyond the map
!> without it. The file is long by what an input may not say.
module adfric_periodic_free_model
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t, file_failure
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_count, show_number
   use adfric_base_unset, only: is_set
   use adfric_describe_check, only: refuse_swept, require_one
   use adfric_describe_derived, only: add_derived, derived_t
   use adfric_describe_doubt, only: doubt_slope_too_steep
   use adfric_describe_pointwise, only: point_state_t, pointwise_model_t
   use adfric_describe_rows, only: contact_profiles, count_row, set_coordinate
   use adfric_describe_status, only: status_no_equilibrium, status_not_converged, status_out_of_memory, status_solved
   use adfric_describe_table, only: profile_axis_t
   use adfric_interface_adhesion_rows, only: adhesion_law_t, n_adhesion_rows
   use adfric_interface_attraction_rows, only: given_attraction_t, has_attraction
   use adfric_interface_conduction_rows, only: check_conduction, has_conduction, n_conduction_rows, refuse_conduction
   use adfric_numerics_found_once, only: found_once_t
   use adfric_periodic_adhesion_cells, only: derive_zone, doubt_zone, sees_pull_off
   use adfric_periodic_free_adhesion, only: solve_free_adhesion
   use adfric_periodic_free_law, only: check_free_law, free_law_in_units, free_law_of, set_free_solid
   use adfric_periodic_free_point, only: add_punch, error_of_adhesion, error_of_contact, free_point_state_t, prepare_solver, &
      & store, store_adhesion
   use adfric_periodic_free_rows, only: attraction_values, boundaries_periodic, get_free_results, get_free_variables, &
      & in => free_input, is_periodic_by, tilt_free
   use adfric_periodic_free_solver, only: free_hinge_t, is_inside, solve_free
   use adfric_periodic_given_heights, only: given_heights_t
   use adfric_periodic_point, only: periodic_surface_t
   use adfric_periodic_variables, only: is_wanted
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
      !> Table of the law of attraction.
      type(given_attraction_t) :: given_attraction
      !> Pull-offs that the points of a run share; null before the run.
      type(found_once_t), pointer :: pull_offs => null()
   contains
      procedure :: prepare
      procedure :: release
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

contains

   !> The model with its tables.
   subroutine new_free_model(self)
      !> The new model; receives its tables.
      type(free_model_t), intent(out) :: self

      self%name = 'free_surface'
      self%summary = 'a rigid body of given heights on an elastic half-space, alone or periodic in one direction: load, area, '// &
         & 'pull-off'
      self%references = 'A. E. H. Love, Phil. Trans. R. Soc. Lond. A 228 (1929) 377; '// &
         & 'R. W. Hockney, Methods Comput. Phys. 9 (1970) 135; D. Maugis, J. Colloid Interface Sci. 150 (1992) 243'
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

   !> Make space for the pull-offs that points share.
   subroutine prepare(self)
      class(free_model_t), intent(inout) :: self

      if (.not. associated(self%pull_offs)) allocate (self%pull_offs)
   end subroutine prepare

   !> Give back the pull-offs that points have shared.
   subroutine release(self)
      class(free_model_t), intent(inout) :: self

      if (.not. associated(self%pull_offs)) return
      call self%pull_offs%clear()
      deallocate (self%pull_offs)
   end subroutine release

   !> See `model_t`.
   subroutine take_dataset(self, index, values, problems)
      class(free_model_t), intent(inout) :: self
      !> Index of the heights, or of the table of a law, in `variables`.
      integer, intent(in) :: index
      !> Heights of the body [m], NaN where they are not known; shape `(nx, ny)`. Or gaps [m] and tensions [Pa]; shape `(n, 2)`.
      real(dp), intent(in) :: values(:, :)
      type(problems_t), intent(inout) :: problems

      if (index == in%tension_table) then
         call self%given_attraction%take(index - (in%adhesion + n_adhesion_rows - 1), values)
      else
         call self%given%take(self%variables(index), values, problems)
      end if
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
      call check_cells_of_adhesion(self, values, problems)
      call require_one(self%variables, values, [in%load, in%approach], .true., problems)
      call check_free_law(self%variables, values, self%given_attraction, problems)
      call check_tilt(self, values, problems)
      call check_punch(self, values, problems)
   end subroutine check_values

   !> Add to `problems` what is wrong with a tilt.
   subroutine check_tilt(self, values, problems)
      class(free_model_t), intent(in) :: self
      !> Values of the variables.
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      real(dp) :: lengths(2)
      logical :: is_periodic(2)
      integer :: along

      is_periodic = is_periodic_by(values(in%boundaries))
      lengths = values([in%length_x, in%length_y])
      do along = 1, 2
         associate (row => self%variables(merge(in%load_x, in%load_y, along == 1)), &
               & point => values(merge(in%load_x, in%load_y, along == 1)))
            if (.not. is_set(point)) cycle
            if (nint(values(in%tilt)) /= tilt_free) then
               call problems%add(row%group, row%name, 'has no meaning for a body that does not tilt; give tilt = ''free''')
            else if (is_periodic(along)) then
               call problems%add(row%group, row%name, 'has no meaning along a period, where the body does not tilt')
            else if (is_set(lengths(along)) .and. .not. (point > 0 .and. point < lengths(along))) then
               call problems%add(row%group, row%name, 'is not on the map, given '//show_number(point)//' m, allowed: 0 to '// &
                  & show_number(lengths(along))//' m')
            end if
         end associate
      end do
      if (nint(values(in%tilt)) /= tilt_free) return
      if (is_set(values(in%approach))) call problems%add('operating', 'tilt', &
         & 'is free, but the approach is given; a body that may tilt has a load')
      if (has_attraction(attraction_values(values))) call problems%add('operating', 'tilt', &
         & 'is free beside &adhesion, where the body must be fixed')
   end subroutine check_tilt

   !> Add to `problems` what is wrong with conduction and stiffness, and what they cannot stand beside.
   subroutine check_punch(self, values, problems)
      class(free_model_t), intent(in) :: self
      !> Values of the variables.
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems

      associate (rows => self%variables(in%conduction(1):in%conduction(n_conduction_rows)), &
            & of_rows => values(in%conduction(1):in%conduction(n_conduction_rows)))
         call check_conduction(rows, of_rows, problems)
         if (any(is_periodic_by(values(in%boundaries)))) call refuse_conduction(rows, of_rows, 'stands beside boundaries that ' &
            & //'are periodic along one direction; what a row of spots conducts depends on the size of the bodies', problems)
      end associate
      if (.not. is_wanted(values(in%stiffness))) return
      if (nint(values(in%tilt)) == tilt_free) call problems%add('output', 'stiffness', 'stands beside tilt = ''free''; ' &
         & //'the stiffness is that of a body that keeps its direction')
      if (has_attraction(attraction_values(values))) call problems%add('output', 'stiffness', &
         & 'stands beside &adhesion, whose edge moves with the approach; differences of two loads have its slope')
   end subroutine check_punch

   !> How the body of a point may move.
   pure type(free_hinge_t) function hinge_of(values, unit) result(hinge)
      !> Values of the variables.
      real(dp), intent(in) :: values(:)
      !> Unit of length [m].
      real(dp), intent(in) :: unit

      hinge%may_tilt = nint(values(in%tilt)) == tilt_free .and. .not. is_periodic_by(values(in%boundaries))
      hinge%point = values([in%length_x, in%length_y])/2
      if (is_set(values(in%load_x))) hinge%point(1) = values(in%load_x)
      if (is_set(values(in%load_y))) hinge%point(2) = values(in%load_y)
      hinge%point = hinge%point/unit
   end function hinge_of

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

   !> On fewer cells the order of states fails, and states of a load are lost: 7 of 25 on 8 and 10 cells, none of 55 on 12 to 32.
   subroutine check_cells_of_adhesion(self, values, problems)
      class(free_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      integer, parameter :: fewest = 16
      integer :: fewest_given

      if (.not. (allocated(self%given%is_body) .and. has_attraction(attraction_values(values)))) return
      fewest_given = minval(shape(self%given%is_body), mask=.not. is_periodic_by(values(in%boundaries)))
      if (fewest_given < fewest) call problems%add('surface', 'heights', 'has '//show_count(fewest_given)//' cells along a side,' &
         & //' allowed: at least '//show_count(fewest)//'; with adhesion states are lost on fewer')
   end subroutine check_cells_of_adhesion

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
      type(adhesion_law_t) :: law
      type(free_hinge_t) :: hinge
      real(dp) :: unit, prescribed
      logical :: has_load, is_found

      if (.not. allocated(state)) allocate (free_point_state_t :: state)
      status = status_not_converged
      error_estimate = 0
      law = free_law_of(values, self%given_attraction)
      select type (state)
      type is (free_point_state_t)
         call self%given%get_cells(values(in%heights:in%rms_height), state%surface)
         call self%given%get_shape(values(in%heights:in%rms_height), state%surface%shape)
         call set_free_solid(values, state%surface)
         call prepare_solver(state, self%watch, is_periodic_by(values(in%boundaries)), law%stress > 0, error)
         unit = state%surface%period(1)
         hinge = hinge_of(values, unit)
         has_load = is_set(values(in%load))
         prescribed = values(merge(in%load, in%approach, has_load))/unit
         associate (modulus => state%surface%solid%modulus)
            if (has_load) prescribed = values(in%load)/modulus/unit/unit
            if (allocated(error)) then
               continue
            else if (law%stress > 0) then
               call solve_free_adhesion(state%adhesive_solver, state%surface%shape/unit, self%given%is_body, has_load, prescribed, &
                  & free_law_in_units(law, modulus, unit), values(in%tolerance), &
                  & is_wanted(values(in%pull_off)) .and. sees_pull_off(law, state%surface), &
                  & self%pull_offs, state%solution, state%adhesion, error)
               if (state%adhesion%is_out_of_range) status = status_no_equilibrium
            else if (is_inside(self%given%is_body, state%surface%period/unit, hinge)) then
               call solve_free(state%solver, state%surface%shape/unit, self%given%is_body, has_load, prescribed, &
                  & values(in%tolerance), state%solution, hinge)
            else
               ! it tips over
               status = status_no_equilibrium
               return
            end if
            if (allocated(error)) then
               if (error%code == file_failure) status = status_out_of_memory
               return
            end if
            counts(1) = counts(1) + state%solution%n_iterations
            if (.not. state%solution%is_converged) return
            error_estimate = error_of_contact(state%solution, has_load)
            if (law%stress > 0) error_estimate = max(error_estimate, error_of_adhesion(law, state))
            ! cells that do not see the edge of adhesion
            if (.not. error_estimate <= 1) then
               error_estimate = 0
               return
            end if
            call store(values, state, modulus, hinge, results)
            if (law%stress > 0) call store_adhesion(law, state, results)
            status = status_solved
            if (.not. (is_wanted(values(in%stiffness)) .or. &
               & has_conduction(values(in%conduction(1):in%conduction(n_conduction_rows))))) return
            call add_punch(values, self%given%is_body, law%stress > 0, self%watch, state, results, is_found, error)
            if (is_found) return
            error_estimate = 0
            results(:) = not_a_number()
            status = status_not_converged
            if (allocated(error)) status = status_out_of_memory
         end associate
      end select
   end subroutine solve_point

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
      type(periodic_surface_t) :: surface
      type(adhesion_law_t) :: law

      derived = derive_contact_modulus(self%variables(in%modulus:in%modulus + n_two_bodies - 1), &
         & values(in%modulus:in%modulus + n_two_bodies - 1))
      call add_derived(derived, 'root_mean_square_height', 'm', 'root of the mean square of the heights', &
         & self%given%factor_of(values(in%heights:in%rms_height))*self%given%root_mean_square)
      law = free_law_of(values, self%given_attraction)
      if (.not. law%stress > 0) return
      call self%given%get_cells(values(in%heights:in%rms_height), surface)
      call set_free_solid(values, surface)
      call derive_zone(derived, law, surface, 'length of a short zone of adhesion, pi E* w/(4 p0^2)')
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

   !> See `model_t`: edges that do not meet along the period, and zones of adhesion that the cells do not see.
   function describe_doubts(self, values) result(text)
      class(free_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text
      type(periodic_surface_t) :: surface
      type(adhesion_law_t) :: law

      text = self%given%doubt(is_periodic_by(values(in%boundaries)))
      law = free_law_of(values, self%given_attraction)
      if (.not. law%stress > 0) return
      call self%given%get_cells(values(in%heights:in%rms_height), surface)
      call set_free_solid(values, surface)
      text = text//doubt_zone(law, surface)
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
