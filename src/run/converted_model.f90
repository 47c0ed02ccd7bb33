! SPDX-License-Identifier: GPL-3.0-or-later
!> A solver some of whose variables and results a scene counts otherwise: amplitude for height, lengths for spacings, an angle for a
!> word, and stresses over the nominal area for the forces of a period.
!>
!> Variables and results keep the order of the solver, and each value is converted by itself. With
!>
!>     height = 2 amplitude,   spacing = length/samples,   degrees = 180 direction/pi,
!>     stress = force/period,   the period being an area of waves and heights over x and y (`nominal_size` of the solver)
!>
!> Of work, stress and range of adhesion a scene gives any two; the solver gets those that it knows: work = stress range.
!>
!> The lengths of heights follow from the attributes dx and dy of their dataset where they are not given, and a velocity may have
!> either sign (`adfric_run_reversal`).
module adfric_run_converted_model
   use adfric_base_constants, only: pi
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set, unset
   use adfric_base_words, only: has_word
   use adfric_describe_derived, only: add_derived, derived_t
   use adfric_describe_model, only: model_t
   use adfric_describe_profile_receiver, only: profile_receiver_t
   use adfric_describe_status, only: status_solved
   use adfric_describe_table, only: result_t
   use adfric_run_conversion, only: as_it_is, be_angle, conversion_of, direction_tolerance, find_what_follows, follows_nothing, &
      follows_stress, follows_work, lengths_of, take_spacing, text_over_area, to_axis, to_degrees, to_reverse, to_scene, &
      to_solver, unit_over_area
   use adfric_run_reversal, only: new_reversal, reversal_t
   use adfric_run_wrapped_model, only: wrapped_model_t
   implicit none (type, external)
   private
   public :: converted_model_t, convert_model

   !> Results of a period that a scene counts over the nominal area.
   character(*), parameter :: of_period = 'load friction_force contact_area adhesion_area dissipation edge_loss pull_off_load '// &
      & 'friction_sample_error hysteretic_friction_force interfacial_friction_force'

   !> The solver with the values of a scene.
   type, extends(wrapped_model_t) :: converted_model_t
      !> How each variable is converted; shape `(n_variables)`.
      integer, allocatable :: how(:)
      !> Indices of the variables that are converted.
      integer, allocatable :: changed(:)
      !> Does the result count over the nominal area? Shape `(n_results)`.
      logical, allocatable :: is_of_period(:)
      !> Indices of these results.
      integer, allocatable :: of_period(:)
      !> Samples of the heights along x and y; 1 where there are none.
      integer :: n_x = 1, n_y = 1
      !> What of adhesion follows from the other two, and the indices of the three.
      integer :: follows = follows_nothing, work = 0, stress = 0, range = 0
      !> Is the surface a wave, which is the same in both directions?
      logical :: is_wave = .false.
      !> Indices of the lengths that the scene gives by the spacing of the heights; 0 where the solver knows the spacing.
      integer :: lengths(2) = 0
      !> Spacing of the samples along x and y that the heights come with [m], or unset.
      real(dp) :: spacing(2) = unset
      !> What the sense of the motion changes.
      type(reversal_t) :: reversal
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
      procedure :: is_converted
      procedure :: of_scene
      procedure :: inner_values
      procedure :: inner_results
      procedure :: measure
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
      integer, allocatable :: how(:)
      integer :: i, follows, lengths(2)

      allocate (how(size(model%variables)), source=as_it_is)
      do i = 1, size(how)
         how(i) = conversion_of(model%variables(i))
      end do
      follows = find_what_follows(model%name, facts)
      lengths = lengths_of(model)
      if (follows == follows_nothing .and. all(how == as_it_is) .and. all(lengths == 0)) return
      allocate (converted)
      call new_reversal(converted%reversal, model)
      call converted%wrap(model)
      converted%how = how
      converted%changed = pack([(i, i=1, size(how))], how /= as_it_is)
      converted%lengths = lengths
      if (lengths(1) > 0) call take_spacing(converted%variables(converted%index_of('surface', 'heights')))
      converted%follows = follows
      converted%results = converted%inner%results
      allocate (converted%is_of_period(size(converted%results)), source=.false.)
      do i = 1, size(how)
         if (any(how(i) == [to_reverse, to_axis, to_degrees])) call be_angle(converted%variables(i), how(i))
      end do
      if (converted%name == 'wavy_sliding') call count_over_area(converted, surface)
      converted%of_period = pack([(i, i=1, size(converted%results))], converted%is_of_period)
      converted%work = converted%index_of('adhesion', 'work_of_adhesion')
      converted%stress = converted%index_of('adhesion', 'adhesion_stress')
      converted%range = converted%index_of('adhesion', 'adhesion_range')
      call move_alloc(converted, model)
   end subroutine convert_model

   !> Have the results of a period count over its nominal area.
   subroutine count_over_area(self, surface)
      class(converted_model_t), intent(inout) :: self
      !> The surface of the scene.
      character(*), intent(in) :: surface
      integer :: j

      self%is_wave = index(surface, 'wave_') == 1
      do j = 1, size(self%results)
         self%is_of_period(j) = has_word(of_period, self%results(j)%solver_name)
         if (.not. self%is_of_period(j)) cycle
         self%results(j)%unit = unit_over_area(self%results(j)%unit)
         self%results(j)%long_name = text_over_area(self%results(j)%long_name)
      end do
   end subroutine count_over_area

   !> See `wrapped_model_t`.
   pure function inner_values(self, values) result(converted)
      class(converted_model_t), intent(in) :: self
      !> Values of the scene; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      real(dp) :: converted(size(values))

      converted = values
      call convert_values(self, converted)
   end function inner_values

   !> Values of a scene become those of the solver.
   pure subroutine convert_values(self, values)
      class(converted_model_t), intent(in) :: self
      !> Values of a point; shape `(n_variables)`.
      real(dp), intent(inout) :: values(:)
      real(dp) :: angle
      logical :: is_backward
      integer :: i, k

      is_backward = self%reversal%is_backward(values)
      angle = 0
      if (is_backward) angle = self%reversal%angle_of(values)
      do k = 1, size(self%changed)
         i = self%changed(k)
         if (is_set(values(i))) values(i) = to_solver(self%how(i), values(i), [self%n_x, self%n_y])
      end do
      do k = 1, 2
         if (self%lengths(k) == 0 .or. .not. is_set(self%spacing(k))) cycle
         if (k == 2 .and. self%n_y == 1 .or. is_set(values(self%lengths(k)))) cycle
         values(self%lengths(k)) = self%spacing(k)*merge(self%n_x, self%n_y, k == 1)
      end do
      associate (direction => self%reversal%direction)
         if (is_backward) then
            values(self%reversal%velocity) = -values(self%reversal%velocity)
            values(direction) = to_solver(self%how(direction), angle, [self%n_x, self%n_y])
         end if
         ! a wave is the same in both directions
         if (self%is_wave) values(direction) = unset
      end associate
      select case (self%follows)
      case (follows_work)
         values(self%work) = values(self%stress)*values(self%range)
         values(self%range) = unset
      case (follows_stress)
         values(self%stress) = values(self%work)/values(self%range)
         values(self%range) = unset
      end select
   end subroutine convert_values

   !> Does a scene count a variable otherwise than the solver?
   pure logical function is_converted(self, at)
      class(converted_model_t), intent(in) :: self
      !> Index of the variable.
      integer, intent(in) :: at

      is_converted = self%how(at) /= as_it_is
   end function is_converted

   !> Value of a scene.
   pure real(dp) function of_scene(self, at, value)
      class(converted_model_t), intent(in) :: self
      !> Index of the variable.
      integer, intent(in) :: at
      !> Value of the solver.
      real(dp), intent(in) :: value

      of_scene = to_scene(self%how(at), value, [self%n_x, self%n_y])
   end function of_scene

   !> See `model_t`.
   subroutine check_values(self, values, is_swept, problems)
      class(converted_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      real(dp) :: step
      integer :: i

      do i = 1, size(values)
         if (self%how(i) /= to_reverse .and. self%how(i) /= to_axis) cycle
         step = merge(pi, pi/2, self%how(i) == to_reverse)
         if (is_swept(i)) call problems%add(self%variables(i)%group, self%variables(i)%name, &
            'is swept; a run has one direction')
         if (.not. is_set(values(i))) cycle
         if (abs(values(i) - step*nint(values(i)/step)) > direction_tolerance) call problems%add(self%variables(i)%group, &
            self%variables(i)%name, 'is no multiple of '//trim(merge('pi  ', 'pi/2', self%how(i) == to_reverse)))
      end do
      call self%inner%check_values(self%inner_values(values), is_swept, problems)
   end subroutine check_values

   !> See `model_t`.
   subroutine solve_block(self, values, results, error_estimate, status, counts)
      class(converted_model_t), intent(in) :: self
      !> Values of the variables for each point; shape `(n_variables, n_points)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives the results of each point; shape `(n_results, n_points)`; NaN where there is no value.
      real(dp), intent(out) :: results(:, :)
      !> Relative error of the main result, estimated; shape `(n_points)`.
      real(dp), intent(out) :: error_estimate(:)
      !> One of `status_...` for each point; shape `(n_points)`.
      integer, intent(out) :: status(:)
      !> Receives what was counted at the points of the block, in the order of the table `counts`; shape `(n_counts)`.
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
      real(dp), intent(in) :: values(:, :)
      !> Receives those of the solver; shape of `values`.
      real(dp), intent(out) :: converted(:, :)
      integer :: i

      converted = values
      do i = 1, size(values, 2)
         call convert_values(self, converted(:, i))
      end do
   end subroutine convert_block

   !> Have results of a period count over its nominal area, and vectors have the sign of the velocity.
   pure subroutine convert_results(self, values, inner, results)
      class(converted_model_t), intent(in) :: self
      !> Values of the scene and of the solver for each point; shape `(n_variables, n_points)`.
      real(dp), intent(in) :: values(:, :), inner(:, :)
      !> In: the results of the solver. Out: those of the scene; shape `(n_results, n_points)`.
      real(dp), intent(inout) :: results(:, :)
      real(dp) :: nominal_size
      integer :: i, k

      do i = 1, size(values, 2)
         call self%reversal%turn_results(values(:, i), results(:, i))
      end do
      if (size(self%of_period) == 0) return
      do i = 1, size(values, 2)
         nominal_size = self%inner%nominal_size(inner(:, i))
         do k = 1, size(self%of_period)
            results(self%of_period(k), i) = results(self%of_period(k), i)/nominal_size
         end do
      end do
   end subroutine convert_results

   !> See `model_t`.
   subroutine solve_block_and_profiles(self, values, results, error_estimate, status, counts, profiles, receiver)
      class(converted_model_t), intent(in) :: self
      !> Values of the variables for each point; shape `(n_variables, n_points)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives the results of each point; shape `(n_results, n_points)`; NaN where there is no value.
      real(dp), intent(out) :: results(:, :)
      !> Relative error of the main result, estimated; shape `(n_points)`.
      real(dp), intent(out) :: error_estimate(:)
      !> One of `status_...` for each point; shape `(n_points)`.
      integer, intent(out) :: status(:)
      !> Receives what was counted at the points of the block, in the order of the table `counts`; shape `(n_counts)`.
      real(dp), intent(out) :: counts(:)
      !> Space for the profiles of one point, of their shape; what stands in it at the end has no meaning.
      real(dp), intent(inout) :: profiles(:, :, :)
      !> Takes the profiles of one solved point after the other, and says whether more are wanted.
      class(profile_receiver_t), intent(inout) :: receiver
      real(dp) :: inner(size(values, 1), size(values, 2))
      integer :: i
      logical :: goes_on

      if (.not. self%reversal%is_along_motion) then
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
      !> Values of the scene; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the scene for this point; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> Receives the profiles; shape `(n_last_axis, n_first_axis, n_profiles)`.
      real(dp), intent(out) :: profiles(:, :, :)

      call self%inner%solve_profiles(self%inner_values(values), self%inner_results(values, results), profiles)
      call self%reversal%turn_profiles(values, profiles)
   end subroutine solve_profiles

   !> See `wrapped_model_t`.
   pure function inner_results(self, values, results) result(inner)
      class(converted_model_t), intent(in) :: self
      !> Values of the scene; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the scene; shape `(n_results)` or longer.
      real(dp), intent(in) :: results(:)
      real(dp) :: inner(size(self%inner%results))

      inner = results(:size(inner))
      call self%reversal%turn_results(values, inner)
      if (size(self%of_period) > 0) then
         inner(self%of_period) = inner(self%of_period)*self%inner%nominal_size(self%inner_values(values))
      end if
   end function inner_results

   !> See `model_t`: asked at every point, so that each value is converted once.
   subroutine measure(self, values, results, measures)
      class(converted_model_t), intent(in) :: self
      !> Values of the scene; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the point, NaN where they are not known; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> In: all `not_measured`. Out: with what is measured; shape `(n_doubts)`.
      real(dp), intent(inout) :: measures(:)
      real(dp) :: inner(size(values)), of_solver(size(self%is_of_period)), nominal_size
      integer :: k

      inner = values
      call convert_values(self, inner)
      of_solver = results(:size(of_solver))
      call self%reversal%turn_results(values, of_solver)
      if (size(self%of_period) > 0) then
         nominal_size = self%inner%nominal_size(inner)
         do k = 1, size(self%of_period)
            of_solver(self%of_period(k)) = of_solver(self%of_period(k))*nominal_size
         end do
      end if
      call self%inner%measure(inner, of_solver, measures)
   end subroutine measure

   !> See `model_t`.
   function describe_results(self, values) result(results)
      class(converted_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
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
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: derived(:)
      real(dp) :: inner(size(values))
      integer :: k

      inner = self%inner_values(values)
      allocate (derived, source=self%inner%derive_quantities(inner))
      do k = 1, 2
         if (self%lengths(k) == 0 .or. .not. is_set(self%spacing(k))) cycle
         if (is_set(inner(self%lengths(k)))) call add_derived(derived, self%variables(self%lengths(k))%name, 'm', &
            'samples times the spacing that the heights come with', inner(self%lengths(k)), 'heights')
      end do
   end function derive_quantities

   !> See `model_t`.
   subroutine take_dataset(self, index, values, problems)
      class(converted_model_t), intent(inout) :: self
      !> Index of the dataset in `variables`.
      integer, intent(in) :: index
      !> Values of the dataset; shape `(n_last, n_first)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      if (self%variables(index)%is_called('surface', 'heights')) then
         self%n_x = size(values, 1)
         self%n_y = size(values, 2)
      end if
      call self%inner%take_dataset(index, values, problems)
      self%largest_block = self%inner%largest_block
   end subroutine take_dataset

   !> See `model_t`.
   subroutine take_attribute(self, index, name, value, problems)
      class(converted_model_t), intent(inout) :: self
      !> Index of the dataset in `variables`.
      integer, intent(in) :: index
      !> Name of the attribute, one of those of the row.
      character(*), intent(in) :: name
      !> The number in SI units.
      real(dp), intent(in) :: value
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      if (self%lengths(1) == 0 .or. .not. self%variables(index)%is_called('surface', 'heights')) then
         call self%inner%take_attribute(index, name, value, problems)
         return
      end if
      self%spacing(merge(1, 2, name == 'dx')) = value
      if (.not. value > 0) call problems%add(self%variables(index)%group, self%variables(index)%name, &
         'has an attribute '//name//' that is not > 0')
   end subroutine take_attribute

   !> See `model_t`.
   function unit_of(self, values, index) result(unit)
      class(converted_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Index of the variable in `variables`.
      integer, intent(in) :: index
      character(:), allocatable :: unit

      unit = self%variables(index)%unit
      if (self%how(index) == as_it_is) unit = self%inner%unit_of(self%inner_values(values), index)
   end function unit_of

end module adfric_run_converted_model
