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
module adfric_run_converted_model
   use adfric_base_constants, only: pi
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set, unset
   use adfric_base_words, only: has_word
   use adfric_describe_model, only: model_t
   use adfric_describe_profile_receiver, only: profile_receiver_t
   use adfric_describe_table, only: kind_real, result_t, variable_t
   use adfric_run_conversion, only: as_it_is, by_samples_x, by_samples_y, direction_tolerance, doubled, find_what_follows, &
      follows_nothing, follows_stress, follows_work, to_axis, to_degrees, to_reverse, to_scene, to_solver, text_over_area, &
      unit_over_area
   use adfric_run_wrapped_model, only: wrapped_model_t
   implicit none (type, external)
   private
   public :: converted_model_t, convert_model

   !> Results of a period that a scene counts over the nominal area.
   character(*), parameter :: of_period = 'load friction_force contact_area adhesion_area dissipation edge_loss pull_off_load '// &
      & 'friction_sample_error'

   !> The solver with the values of a scene.
   type, extends(wrapped_model_t) :: converted_model_t
      !> How each variable is converted; shape `(n_variables)`.
      integer, allocatable :: how(:)
      !> Does the result count over the nominal area? Shape `(n_results)`.
      logical, allocatable :: is_of_period(:)
      !> Samples of the heights along x and y; 1 where there are none.
      integer :: n_x = 1, n_y = 1
      !> What of adhesion follows from the other two, and the indices of the three.
      integer :: follows = follows_nothing, work = 0, stress = 0, range = 0
      !> Is the surface a wave, which is the same in both directions?
      logical :: is_wave = .false.
   contains
      procedure :: check_values
      procedure :: solve_block
      procedure :: solve_block_and_profiles
      procedure :: describe_results
      procedure :: take_dataset
      procedure :: unit_of
      procedure :: is_converted
      procedure :: of_scene
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
      integer, allocatable :: how(:)
      integer :: i, follows

      allocate (how(size(model%variables)), source=as_it_is)
      do i = 1, size(how)
         how(i) = conversion_of(model%variables(i))
      end do
      follows = find_what_follows(model%name, facts)
      if (follows == follows_nothing .and. all(how == as_it_is)) return
      allocate (converted)
      call converted%wrap(model)
      converted%how = how
      converted%follows = follows
      converted%results = converted%inner%results
      allocate (converted%is_of_period(size(converted%results)), source=.false.)
      do i = 1, size(how)
         if (any(how(i) == [to_reverse, to_axis, to_degrees])) call be_angle(converted%variables(i), how(i))
      end do
      if (converted%name == 'wavy_sliding') call count_over_area(converted, surface)
      converted%work = converted%index_of('adhesion', 'work_of_adhesion')
      converted%stress = converted%index_of('adhesion', 'adhesion_stress')
      converted%range = converted%index_of('adhesion', 'adhesion_range')
      call move_alloc(converted, model)
   end subroutine convert_model

   !> How a variable is converted.
   pure integer function conversion_of(variable) result(how)
      type(variable_t), intent(in) :: variable

      how = as_it_is
      if (variable%is_called('surface', 'height')) how = doubled
      if (variable%is_called('surface', 'spacing')) how = by_samples_x
      if (variable%is_called('surface', 'strip_spacing')) how = by_samples_y
      if (variable%is_called('surface', 'reverse')) how = to_reverse
      if (variable%is_called('operating', 'tangential_axis')) how = to_axis
      if (variable%is_called('surface', 'direction')) how = to_degrees
   end function conversion_of

   !> A variable is an angle for the scene, in at of a word or of degrees.
   pure subroutine be_angle(variable, how)
      type(variable_t), intent(inout) :: variable
      !> How it is converted.
      integer, intent(in) :: how

      select case (how)
      case (to_reverse)
         variable%meaning = 'direction to which the body slides: 0 along +x, or pi against it'
      case (to_axis)
         variable%meaning = 'direction of the tangential force from the first axis (x, or the major one): 0 or pi/2'
      case default
         variable%meaning = 'direction to which the body slides, from +x to +y; a multiple of pi/2, of pi/4 for waves'
      end select
      variable%kind = kind_real
      variable%unit = 'rad'
      variable%choices = ''
      variable%lower = -6.5_dp
      variable%upper = 6.5_dp
      if (is_set(variable%default)) variable%default = 0
   end subroutine be_angle

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
      integer :: i

      do i = 1, size(values)
         converted(i) = values(i)
         if (is_set(values(i)) .and. self%how(i) /= as_it_is) converted(i) = to_solver(self%how(i), values(i), [self%n_x, self%n_y])
      end do
      ! a wave is the same in both directions
      if (self%is_wave) where (self%how == to_reverse) converted = unset
      select case (self%follows)
      case (follows_work)
         converted(self%work) = values(self%stress)*values(self%range)
         converted(self%range) = unset
      case (follows_stress)
         converted(self%stress) = values(self%work)/values(self%range)
         converted(self%range) = unset
      end select
   end function inner_values

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
         if (self%how(i) == to_reverse .and. modulo(nint(values(i)/pi), 2) == 1 .and. self%wants_profiles(values) &
            .and. .not. self%is_wave) call problems%add(self%variables(i)%group, self%variables(i)%name, &
            'is against the axis of the profiles; leave one of them out')
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

      call self%inner%solve_block(all_to_solver(self, values), results, error_estimate, status, counts)
      call divide_results(self, values, results)
   end subroutine solve_block

   !> Values of the solver for each point.
   pure function all_to_solver(self, values) result(converted)
      class(converted_model_t), intent(in) :: self
      !> Values of the scene for each point; shape `(n_variables, n_points)`.
      real(dp), intent(in) :: values(:, :)
      real(dp) :: converted(size(values, 1), size(values, 2))
      integer :: i

      do i = 1, size(values, 2)
         converted(:, i) = self%inner_values(values(:, i))
      end do
   end function all_to_solver

   !> Have results of a period count over its nominal area.
   pure subroutine divide_results(self, values, results)
      class(converted_model_t), intent(in) :: self
      !> Values of the scene for each point; shape `(n_variables, n_points)`.
      real(dp), intent(in) :: values(:, :)
      !> In: the results of the solver. Out: those of the scene; shape `(n_results, n_points)`.
      real(dp), intent(inout) :: results(:, :)
      integer :: i

      if (.not. any(self%is_of_period)) return
      do i = 1, size(values, 2)
         where (self%is_of_period) results(:, i) = results(:, i)/self%inner%nominal_size(self%inner_values(values(:, i)))
      end do
   end subroutine divide_results

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

      call self%inner%solve_block_and_profiles(all_to_solver(self, values), results, error_estimate, status, counts, profiles, &
         receiver)
      call divide_results(self, values, results)
   end subroutine solve_block_and_profiles

   !> See `wrapped_model_t`.
   pure function inner_results(self, values, results) result(inner)
      class(converted_model_t), intent(in) :: self
      !> Values of the scene; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the scene; shape `(n_results)` or longer.
      real(dp), intent(in) :: results(:)
      real(dp) :: inner(size(self%inner%results))

      inner = results(:size(inner))
      if (any(self%is_of_period)) then
         where (self%is_of_period) inner = inner*self%inner%nominal_size(self%inner_values(values))
      end if
   end function inner_results

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
