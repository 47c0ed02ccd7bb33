! SPDX-License-Identifier: GPL-3.0-or-later
!> A solver some of whose variables and results a scene counts otherwise: its values (`adfric_run_scene_values`), and the forces of
!> a period, which a scene counts as stresses over the nominal area,
!>
!>     stress = force/period,   the period being an area of waves and heights over x and y (`nominal_size` of the solver)
!>
!> Variables and results keep the order of the solver. A velocity may have either sign (`adfric_run_reversal`). The doubt of a
!> point is that of the solver, so that its values are converted once.
module adfric_run_converted_model
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_describe_derived, only: add_derived, derived_t
   use adfric_describe_model, only: model_t
   use adfric_describe_profile_receiver, only: profile_receiver_t
   use adfric_describe_status, only: status_solved
   use adfric_describe_table, only: result_t
   use adfric_run_conversion, only: as_it_is, is_counted_over_area, text_over_area, unit_over_area
   use adfric_run_reversal, only: new_reversal
   use adfric_run_scene_values, only: new_scene_values, scene_values_t
   use adfric_run_wrapped_model, only: wrapped_model_t
   implicit none (type, external)
   private
   public :: converted_model_t, convert_model

   !> The solver with the values of a scene.
   type, extends(wrapped_model_t) :: converted_model_t
      !> How its values are those of the solver.
      type(scene_values_t) :: scene_values
      !> Does the result count over the nominal area? Shape `(n_results)` of the solver.
      logical, allocatable :: is_of_period(:)
      !> Indices of these results.
      integer, allocatable :: of_period(:)
   contains
      procedure :: check_values
      procedure :: solve_block
      procedure :: solve_block_and_profiles
      procedure :: solve_profiles
      procedure :: describe_results
      procedure :: derive_quantities
      procedure :: take_dataset
      procedure :: take_attribute
      procedure :: unit_of
      procedure :: take_doubt
      procedure :: inner_values
      procedure :: inner_results
   end type converted_model_t

contains

   !> Have a solver count as a scene does, if anything of it differs.
   subroutine convert_model(model, surface, facts)
      !> In: the solver, with its tables renamed. Out: the same, or one around it.
      class(model_t), allocatable, intent(inout) :: model
      !> The surface of the scene.
      character(*), intent(in) :: surface
      !> Facts of the scene, separated by a blank.
      character(*), intent(in) :: facts
      type(converted_model_t), allocatable :: converted

      allocate (converted)
      call new_scene_values(converted%scene_values, model, surface, facts)
      if (converted%scene_values%are_as_they_are()) return
      call new_reversal(converted%scene_values%reversal, model)
      call converted%wrap(model)
      call converted%scene_values%change_rows(converted%variables)
      converted%results = converted%inner%results
      allocate (converted%is_of_period(size(converted%results)), source=.false.)
      call count_over_area(converted)
      converted%of_period = indices_of(converted%is_of_period)
      call move_alloc(converted, model)
   end subroutine convert_model

   !> Have the results of a period count over its nominal area.
   subroutine count_over_area(self)
      class(converted_model_t), intent(inout) :: self
      integer :: j

      do j = 1, size(self%results)
         self%is_of_period(j) = is_counted_over_area(self%name, self%results(j)%solver_name)
         if (.not. self%is_of_period(j)) cycle
         self%results(j)%unit = unit_over_area(self%results(j)%unit)
         self%results(j)%long_name = text_over_area(self%results(j)%long_name)
      end do
   end subroutine count_over_area

   !> Indices of what is true.
   pure function indices_of(is_true) result(indices)
      logical, intent(in) :: is_true(:)
      integer, allocatable :: indices(:)
      integer :: i

      indices = pack([(i, i=1, size(is_true))], is_true)
   end function indices_of

   !> Take over the doubt, the last result that the solver has got.
   subroutine take_doubt(self)
      class(converted_model_t), intent(inout) :: self
      type(result_t), allocatable :: rows(:)
      integer :: j, n

      n = size(self%results)
      allocate (rows(n + 1))
      do j = 1, n
         rows(j) = self%results(j)
      end do
      rows(n + 1) = self%inner%results(n + 1)
      call move_alloc(rows, self%results)
      self%is_of_period = [self%is_of_period, .false.]
      self%scene_values%reversal%has_sign = [self%scene_values%reversal%has_sign, .false.]
   end subroutine take_doubt

   !> See `wrapped_model_t`.
   pure function inner_values(self, values) result(converted)
      class(converted_model_t), intent(in) :: self
      !> Values of the scene; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      real(dp) :: converted(size(values)), point(size(values), 1)

      point(:, 1) = values
      call self%scene_values%convert(point)
      converted = point(:, 1)
   end function inner_values

   !> See `model_t`.
   subroutine check_values(self, values, is_swept, problems)
      class(converted_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout) :: problems

      call self%scene_values%check_directions(self, values, is_swept, problems)
      call self%inner%check_values(self%inner_values(values), is_swept, problems)
   end subroutine check_values

   !> See `model_t`.
   subroutine solve_block(self, values, results, error_estimate, status, counts)
      class(converted_model_t), intent(in) :: self
      real(dp), intent(in), contiguous :: values(:, :)
      real(dp), intent(out) :: results(:, :), error_estimate(:)
      integer, intent(out) :: status(:)
      real(dp), intent(out) :: counts(:)

      real(dp) :: inner(size(values, 1), size(values, 2))

      call convert_block(self, values, inner)
      call self%inner%solve_block(inner, results, error_estimate, status, counts)
      call convert_results(self, values, inner, results)
   end subroutine solve_block

   !> Values of the solver for each point.
   pure subroutine convert_block(self, values, converted)
      class(converted_model_t), intent(in) :: self
      !> Values of the scene for each point; shape `(n_variables, n_points)`.
      real(dp), intent(in), contiguous :: values(:, :)
      !> Receives those of the solver; shape of `values`.
      real(dp), intent(out), contiguous :: converted(:, :)

      converted(:, :) = values
      call self%scene_values%convert(converted)
   end subroutine convert_block

   !> Have results of a period count over its nominal area, and vectors have the sign of the velocity.
   pure subroutine convert_results(self, values, inner, results)
      class(converted_model_t), intent(in) :: self
      !> Values of the scene and of the solver for each point; shape `(n_variables, n_points)`.
      real(dp), intent(in), contiguous :: values(:, :), inner(:, :)
      !> In: the results of the solver. Out: those of the scene; shape `(n_results, n_points)`.
      real(dp), intent(inout) :: results(:, :)
      real(dp) :: nominal_sizes(size(values, 2))
      integer :: i, k

      call self%scene_values%reversal%turn_results(values, results)
      if (size(self%of_period) == 0) return
      call self%inner%get_nominal_sizes(inner, nominal_sizes)
      do i = 1, size(values, 2)
         do k = 1, size(self%of_period)
            results(self%of_period(k), i) = results(self%of_period(k), i)/nominal_sizes(i)
         end do
      end do
   end subroutine convert_results

   !> See `model_t`.
   subroutine solve_block_and_profiles(self, values, results, error_estimate, status, counts, profiles, receiver)
      class(converted_model_t), intent(in) :: self
      real(dp), intent(in), contiguous :: values(:, :)
      real(dp), intent(out) :: results(:, :), error_estimate(:)
      integer, intent(out) :: status(:)
      real(dp), intent(out) :: counts(:)
      real(dp), intent(inout) :: profiles(:, :, :)
      class(profile_receiver_t), intent(inout) :: receiver
      real(dp) :: inner(size(values, 1), size(values, 2))
      integer :: i
      logical :: goes_on

      if (.not. self%scene_values%reversal%is_along_motion) then
         call convert_block(self, values, inner)
         call self%inner%solve_block_and_profiles(inner, results, error_estimate, status, counts, profiles, receiver)
         call convert_results(self, values, inner, results)
         return
      end if
      call self%solve_block(values, results, error_estimate, status, counts)
      do i = 1, size(status)
         if (status(i) /= status_solved) cycle
         call self%solve_profiles(values(:, i), results(:, i), profiles)
         call receiver%take(i, profiles, goes_on)
         if (.not. goes_on) return
      end do
   end subroutine solve_block_and_profiles

   !> See `model_t`.
   subroutine solve_profiles(self, values, results, profiles)
      class(converted_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:), results(:)
      real(dp), intent(out) :: profiles(:, :, :)

      call self%inner%solve_profiles(self%inner_values(values), self%inner_results(values, results), profiles)
      call self%scene_values%reversal%turn_profiles(values, profiles)
   end subroutine solve_profiles

   !> See `wrapped_model_t`.
   pure function inner_results(self, values, results) result(inner)
      class(converted_model_t), intent(in) :: self
      !> Values of the scene; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the scene; shape `(n_results)` or longer.
      real(dp), intent(in) :: results(:)
      real(dp) :: inner(size(self%inner%results)), point(size(self%inner%results), 1), nominal_sizes(1)

      point(:, 1) = results(:size(inner))
      call self%scene_values%reversal%turn_results(reshape(values, [size(values), 1]), point)
      inner = point(:, 1)
      if (size(self%of_period) == 0) return
      call self%inner%get_nominal_sizes(reshape(self%inner_values(values), [size(values), 1]), nominal_sizes)
      inner(self%of_period) = inner(self%of_period)*nominal_sizes(1)
   end function inner_results

   !> See `model_t`.
   function describe_results(self, values) result(results)
      class(converted_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(result_t), allocatable :: results(:)
      integer :: j

      allocate (results, source=self%inner%describe_results(self%inner_values(values)))
      do j = 1, size(results)
         if (self%is_of_period(j)) results(j) = self%results(j)
      end do
   end function describe_results

   !> See `model_t`.
   function derive_quantities(self, values) result(derived)
      class(converted_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: derived(:)
      real(dp) :: inner(size(values))
      integer :: k

      inner = self%inner_values(values)
      allocate (derived, source=self%inner%derive_quantities(inner))
      do k = 1, 2
         if (.not. self%scene_values%follows_from_spacing(k)) cycle
         associate (length => self%scene_values%lengths(k))
            if (is_set(inner(length))) call add_derived(derived, self%variables(length)%name, 'm', &
               'samples times the spacing that the heights come with', inner(length), 'heights')
         end associate
      end do
   end function derive_quantities

   !> See `model_t`.
   subroutine take_dataset(self, index, values, problems)
      class(converted_model_t), intent(inout) :: self
      integer, intent(in) :: index
      real(dp), intent(in) :: values(:, :)
      type(problems_t), intent(inout) :: problems

      if (self%variables(index)%is_called('surface', 'heights')) then
         self%scene_values%n_x = size(values, 1)
         self%scene_values%n_y = size(values, 2)
      end if
      call self%inner%take_dataset(index, values, problems)
      self%largest_block = self%inner%largest_block
   end subroutine take_dataset

   !> See `model_t`.
   subroutine take_attribute(self, index, name, value, problems)
      class(converted_model_t), intent(inout) :: self
      integer, intent(in) :: index
      character(*), intent(in) :: name
      real(dp), intent(in) :: value
      type(problems_t), intent(inout) :: problems

      if (self%scene_values%lengths(1) == 0 .or. .not. self%variables(index)%is_called('surface', 'heights')) then
         call self%inner%take_attribute(index, name, value, problems)
         return
      end if
      self%scene_values%spacing(merge(1, 2, name == 'dx')) = value
      if (.not. value > 0) call problems%add(self%variables(index)%group, self%variables(index)%name, &
         'has an attribute '//name//' that is not > 0')
   end subroutine take_attribute

   !> See `model_t`.
   function unit_of(self, values, index) result(unit)
      class(converted_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      integer, intent(in) :: index
      character(:), allocatable :: unit

      unit = self%variables(index)%unit
      if (self%scene_values%how(index) == as_it_is) unit = self%inner%unit_of(self%inner_values(values), index)
   end function unit_of

end module adfric_run_converted_model
