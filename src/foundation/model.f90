! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `wavy_sliding`: a rigid wavy surface sliding on a viscoelastic foundation (GM 2011). The file is long by
!> the many questions that a model answers.
module adfric_foundation_model
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_interface_friction_law_rows, only: given_law_t, has_interface, take_law_attribute, take_law_table
   use adfric_interface_shear_strength_rows, only: n_shear_rows
   use adfric_interface_total_friction, only: near_ratios
   use adfric_describe_derived, only: derived_t
   use adfric_describe_model, only: model_t
   use adfric_describe_rows, only: count_row, set_coordinate
   use adfric_describe_status, only: status_not_converged, status_solved
   use adfric_describe_table, only: result_t, profile_axis_t, take_units
   use adfric_numerics_found_once, only: found_once_t
   use adfric_foundation_case, only: wavy_case_t, resolve_case, kind_3d, kind_map
   use adfric_foundation_check, only: check_wavy_values
   use adfric_foundation_given_surface, only: given_surface_t, take_given
   use adfric_foundation_stepped_case, only: has_heights, has_other_law, is_stepped, size_of_period
   use adfric_foundation_stepped_check, only: check_stepped_values
   use adfric_foundation_stepped_description, only: describe_stepped, doubt_stepped, derive_stepped
   use adfric_foundation_stepped_points, only: solve_stepped_block, solve_stepped_profiles, row_indices, column_indices
   use adfric_foundation_interface, only: add_column_interface, add_column_tractions, check_column_interface, interface_of, &
      & without_temperature
   use adfric_foundation_profiles, only: get_profiles
   use adfric_foundation_strip_description, only: derive_strips, doubt_strips
   use adfric_foundation_strip_points, only: solve_strip_block
   use adfric_foundation_surface_bounds, only: measure_heights, measure_waves
   use adfric_foundation_variables, only: get_wavy_profiles, get_wavy_results, get_wavy_variables, in => foundation_input, &
      & out => foundation_output
   implicit none (type, external)
   private
   public :: wavy_model_t, new_wavy_model

   !> Samples of a map whose points take long.
   integer, parameter :: large_map = 100000

   !> The model. A copy of one that is prepared is not to be used once either is released.
   type, extends(model_t) :: wavy_model_t
      private
      !> The pull-off loads that the points of a run share; null unless the model is prepared.
      type(found_once_t), pointer :: pull_offs => null()
      !> Lists and datasets of the input.
      type(given_surface_t) :: given
      !> What is given of the law of the interface beside numbers.
      type(given_law_t) :: given_law
   contains
      procedure :: take_dataset
      procedure :: take_attribute
      procedure :: describe_case
      procedure :: prepare
      procedure :: release
      procedure :: check_values
      procedure :: describe_results
      procedure :: wants_profiles
      procedure :: get_profile_axes
      procedure :: solve_block
      procedure :: solve_profiles
      procedure :: derive_quantities
      procedure :: describe_doubts
      procedure :: measure
      procedure :: unit_of
      procedure :: get_nominal_sizes
   end type wavy_model_t

contains

   !> The model with its tables.
   subroutine new_wavy_model(self)
      !> Receives its name and the tables of variables, results and profiles.
      type(wavy_model_t), intent(out) :: self

      self%name = 'wavy_sliding'
      self%summary = 'a rigid wavy surface sliding on a viscoelastic foundation, with adhesion'
      self%references = 'I. Goryacheva, Yu. Makhovskaya, acta mechanica et automatica 5(4) (2011)'
      self%variables = get_wavy_variables()
      self%results = get_wavy_results()
      self%profiles = get_wavy_profiles()
      self%profile_axes = 'y x'
      self%shares_points = .true.
      allocate (self%counts(2))
      self%counts(1) = count_row(name='strips_per_point', long_name='strips that were solved')
      self%counts(2) = count_row(name='closed_form_strips_per_point', long_name='strips that were solved in closed form')
   end subroutine new_wavy_model

   !> Add to `problems` what is contradictory or impossible in the values together.
   subroutine check_values(self, values, is_swept, problems)
      class(wavy_model_t), intent(in) :: self
      !> Values in the order of `self%variables`, of a swept variable one of its values; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      associate (of_solid => without_temperature(values, self%given))
         if (is_stepped(values)) then
            call check_stepped_values(self%variables, of_solid, self%given, is_swept, problems)
         else
            call check_wavy_values(self%variables, of_solid, is_swept, problems)
         end if
      end associate
      if (has_interface(interface_of(values)) .and. problems%count() == 0) call check_column_interface(self%variables, values, &
         & self%given, self%given_law, problems)
   end subroutine check_values

   !> The table of results, whose units are those of a 2-D or of a 3-D wave.
   function describe_results(self, values) result(results)
      !> The model, whose table of results serves a 2-D wave.
      class(wavy_model_t), intent(in) :: self
      !> Values of one point in the order of `self%variables`; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(result_t), allocatable :: results(:)

      results = self%results
      if (is_set(values(in%kind))) call take_units(get_wavy_results(has_width(values)), results)
   end function describe_results

   !> SI unit of a variable: the load of a 2-D wave is one per width.
   function unit_of(self, values, index) result(unit)
      class(wavy_model_t), intent(in) :: self
      !> Values of one point in the order of `self%variables`; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Index of the variable, one of `v_...`.
      integer, intent(in) :: index
      character(:), allocatable :: unit

      unit = self%variables(index)%unit
      if (index == in%load) unit = trim(merge('N  ', 'N/m', has_width(values)))
   end function unit_of

   !> See `model_t`.
   pure subroutine get_nominal_sizes(self, values, sizes)
      class(wavy_model_t), intent(in) :: self
      real(dp), intent(in), contiguous :: values(:, :)
      real(dp), intent(out) :: sizes(:)
      integer :: i

      do i = 1, size(values, 2)
         sizes(i) = size_of_period(values(:, i), self%given)
      end do
   end subroutine get_nominal_sizes

   !> Has the surface a width of its own, so that forces are not per width?
   pure logical function has_width(values)
      !> Values of one point in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      has_width = nint(values(in%kind)) == kind_3d .or. nint(values(in%kind)) == kind_map
   end function has_width

   !> Keep the values of a list or a dataset.
   subroutine take_dataset(self, index, values, problems)
      class(wavy_model_t), intent(inout) :: self
      !> Index of the variable, one of `v_...`.
      integer, intent(in) :: index
      !> The values in SI units; shape `(n_last, n_first)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives what is wrong with the values.
      type(problems_t), intent(inout) :: problems

      call take_given(self%given, self%variables, index, values, problems)
      call take_law_table(self%given_law, index - in%friction(n_shear_rows), values)
      ! a map takes long, and its points are given to threads one by one
      if (index == in%heights .and. size(values) > large_map) self%largest_block = 1
   end subroutine take_dataset

   !> Keep what a dataset says of itself.
   subroutine take_attribute(self, index, name, value, problems)
      class(wavy_model_t), intent(inout) :: self
      !> Index of the variable, one of `v_...`.
      integer, intent(in) :: index
      !> Name of the attribute.
      character(*), intent(in) :: name
      !> Its value in SI units.
      real(dp), intent(in) :: value
      !> Receives what is wrong with it.
      type(problems_t), intent(inout) :: problems

      if (any(index == in%friction)) then
         call take_law_attribute(self%given_law, self%variables(index), index - in%friction(n_shear_rows), name, value, problems)
         return
      end if
      select case (name)
      case ('dx')
         self%given%dx = value
      case ('dy')
         self%given%dy = value
      case ('reference_temperature')
         self%given%master_temperature = value
      end select
      if (.not. value > 0) call problems%add(self%variables(index)%group, self%variables(index)%name, &
         & 'has an attribute '//name//' that is not > 0')
   end subroutine take_attribute

   !> What `adfric check` says of spectrum and heights.
   function describe_case(self, values) result(text)
      class(wavy_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = ''
      if (is_stepped(values)) text = describe_stepped(values, self%given)
   end function describe_case

   !> Does the user ask for profiles?
   pure logical function wants_profiles(self, values)
      class(wavy_model_t), intent(in) :: self
      !> Values of one point in the order of `self%variables`; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      wants_profiles = values(in%profiles) > 0
      associate (unused => self)
      end associate
   end function wants_profiles

   !> The profile axes y and x: one period about the crest.
   subroutine get_profile_axes(self, values, axes)
      class(wavy_model_t), intent(in) :: self
      !> Values of one point in the order of `self%variables`; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives y and x.
      type(profile_axis_t), allocatable, intent(out) :: axes(:)

      allocate (axes(2))
      if (is_stepped(values)) then
         call set_coordinate(axes(1), self%profile_axes, 1, row_indices(values, self%given))
         call set_coordinate(axes(2), self%profile_axes, 2, column_indices(values, self%given))
         return
      end if
      call set_coordinate(axes(1), self%profile_axes, 1, &
         & about_crest(values(in%period), merge(nint(values(in%n_y)), 1, nint(values(in%kind)) == kind_3d)))
      call set_coordinate(axes(2), self%profile_axes, 2, about_crest(values(in%period), nint(values(in%n_x))))
   end subroutine get_profile_axes

   !> Coordinates over one period, as far on one side of the crest as on the other, to the last digit.
   pure function about_crest(period, n) result(coordinates)
      !> Period of the wave [m].
      real(dp), intent(in) :: period
      !> Number of coordinates; a single one is that of the crest.
      integer, intent(in) :: n
      real(dp) :: coordinates(n)
      integer :: k

      coordinates = 0
      if (n > 1) coordinates = [(period*(real(2*k - (n - 1), dp)/(2*(n - 1))), k=0, n - 1)]
   end function about_crest

   !> Make space for the pull-off loads that points share, each of which is found once.
   subroutine prepare(self)
      class(wavy_model_t), intent(inout) :: self

      if (.not. associated(self%pull_offs)) allocate (self%pull_offs)
   end subroutine prepare

   !> Give back the pull-off loads that points have shared.
   subroutine release(self)
      class(wavy_model_t), intent(inout) :: self

      if (.not. associated(self%pull_offs)) return
      call self%pull_offs%clear()
      deallocate (self%pull_offs)
   end subroutine release

   !> Solve neighbouring points, with the friction of the interface if there is one.
   subroutine solve_block(self, values, results, error_estimate, status, counts)
      !> The model, whose pull-off loads are looked up, and completed, if it is prepared.
      class(wavy_model_t), intent(in) :: self
      !> Values of neighbouring points; shape `(n_variables, n_points)`.
      real(dp), intent(in), contiguous :: values(:, :)
      !> Results in SI units, NaN where there is no value; shape `(n_results, n_points)`.
      real(dp), intent(out) :: results(:, :)
      !> Relative error of load and friction [-], NaN where the point is not solved; shape `(n_points)`.
      real(dp), intent(out) :: error_estimate(:)
      !> How each point was solved, one of `status_...`; shape `(n_points)`.
      integer, intent(out) :: status(:)
      !> Receives the number of strips solved for all points of the block, and of those among them in closed form.
      real(dp), intent(out) :: counts(:)
      real(dp) :: others(size(results, 1), size(near_ratios), size(results, 2)), moved(size(values, 1), size(values, 2))
      real(dp) :: unused_errors(size(status)), unused_counts(size(counts))
      integer :: unused_status(size(status)), i, k
      logical :: is_valid

      call solve_contacts(self, values, results, error_estimate, status, counts)
      if (size(status) == 0) return
      if (.not. has_interface(interface_of(values(:, 1)))) then
         call hide_zones(values, results)
         return
      end if
      others = not_a_number()
      do k = 1, size(near_ratios)
         ! what is stepped takes long, and two velocities will do
         if (is_stepped(values(:, 1)) .and. any(k == [1, 4])) cycle
         moved = values
         moved(in%velocity, :) = moved(in%velocity, :)*near_ratios(k)
         moved(in%pull_off, :) = 0
         call solve_contacts(self, moved, others(:, k, :), unused_errors, unused_status, unused_counts)
      end do
      do i = 1, size(status)
         if (status(i) /= status_solved) cycle
         call add_column_interface(values(:, i), self%given, self%given_law, others(:, :, i), results(:, i), is_valid)
         if (is_valid) cycle
         status(i) = status_not_converged
         results(:, i) = not_a_number()
         error_estimate(i) = not_a_number()
      end do
      call hide_zones(values, results)
   end subroutine solve_block

   !> Zones of another law than Dugdale's have no end, and so no area and no number.
   pure subroutine hide_zones(values, results)
      !> Values of the points; shape `(n_variables, n_points)`.
      real(dp), intent(in) :: values(:, :)
      !> Results of the points; shape `(n_results, n_points)`.
      real(dp), intent(inout) :: results(:, :)
      integer :: i

      do i = 1, size(values, 2)
         if (has_other_law(values(:, i))) results([out%adhesion_area, out%adhesion_count], i) = not_a_number()
      end do
   end subroutine hide_zones

   !> Solve neighbouring points as if the faces were frictionless.
   subroutine solve_contacts(self, values, results, error_estimate, status, counts)
      type(wavy_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:, :)
      real(dp), intent(out) :: results(:, :), error_estimate(:)
      integer, intent(out) :: status(:)
      real(dp), intent(out) :: counts(:)
      integer :: n

      counts = 0
      n = size(values, 2)
      if (n > 0) then
         if (is_stepped(values(:, 1))) then
            call solve_stepped_block(self%given, values, results, error_estimate, status)
            counts(1) = n
            if (nint(values(in%kind, 1)) == kind_map) counts(1) = real(n, dp)*size(self%given%heights, 2)
            return
         end if
      end if
      call solve_strip_block(self%pull_offs, values, results, error_estimate, status, counts)
   end subroutine solve_contacts

   !> Profiles of one solved point.
   subroutine solve_profiles(self, values, results, profiles)
      class(wavy_model_t), intent(in) :: self
      !> Values of one point in the order of `self%variables`; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the point, of which the penetration is read; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> Pressure and shear stress [Pa], displacement and gap [m]; shape `(n_x, n_y, 4)`.
      real(dp), intent(out) :: profiles(:, :, :)
      type(profile_axis_t), allocatable :: axes(:)
      type(wavy_case_t) :: point

      call self%get_profile_axes(values, axes)
      if (is_stepped(values)) then
         call solve_stepped_profiles(self%given, values, axes(2)%coordinates, profiles)
      else
         call resolve_case(values, point)
         call get_profiles(point, results(out%penetration), axes(2)%coordinates, axes(1)%coordinates, profiles)
      end if
      if (has_interface(interface_of(values))) call add_column_tractions(values, self%given, self%given_law, &
         & results(out%contact_area) > 0, profiles)
   end subroutine solve_profiles

   !> Quantities that follow from the values of a point, for `adfric check` and the results file.
   function derive_quantities(self, values) result(derived)
      class(wavy_model_t), intent(in) :: self
      !> Values of one point in the order of `self%variables`; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: derived(:)

      allocate (derived(0))
      if (is_stepped(values)) then
         call derive_stepped(derived, values, self%given)
         return
      end if
      call derive_strips(derived, values)
   end function derive_quantities

   !> See `model_t`.
   function describe_doubts(self, values) result(text)
      class(wavy_model_t), intent(in) :: self
      !> Values of one point in the order of `self%variables`; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      if (is_stepped(values)) then
         text = doubt_stepped(values, self%given)
         return
      end if
      text = doubt_strips(values)
   end function describe_doubts

   !> See `model_t`.
   subroutine measure(self, values, results, measures)
      class(wavy_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:), results(:)
      real(dp), intent(inout) :: measures(:)

      if (has_heights(values)) then
         call measure_heights(values, self%given, measures)
      else
         call measure_waves(values, self%given, measures)
      end if
      associate (unused => results)
      end associate
   end subroutine measure

end module adfric_foundation_model
