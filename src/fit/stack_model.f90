! SPDX-License-Identifier: GPL-3.0-or-later
!> A stack of measured curves as a run: a point of the run is one curve, and solving it is fitting the curve.
!>
!> So blocks, threads, processes, parts and results files serve fits as they serve sweeps. Each curve starts cold: its results depend
!> on no other. A single fit is a stack of one; it is solved when the model is prepared, and the results file has more of it.
!> The file is long by its answers to `model_t`.
module adfric_fit_stack_model
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp, i8
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_count
   use adfric_base_watch, only: watch_t
   use adfric_base_words, only: get_word
   use adfric_fit_curve_source, only: curve_source_t
   use adfric_fit_extras, only: get_solution_extras
   use adfric_fit_names, only: find_derived_rows, list_extra_names
   use adfric_fit_problem, only: fit_t, data_set_t
   use adfric_fit_result_rows, only: get_result_rows, get_result_values
   use adfric_fit_data_extras, only: get_units
   use adfric_fit_solution, only: data_solution_t, solution_t, fit_solved, fit_not_converged, fit_status_meanings, &
      & fit_too_few_points
   use adfric_fit_solve, only: solve_fit
   use adfric_describe_model, only: model_t, derived_t
   use adfric_describe_rows, only: dataset, whole_number
   use adfric_describe_profile_receiver, only: profile_receiver_t
   use adfric_describe_table, only: extra_t, profile_axis_t, profile_t
   implicit none (type, external)
   private
   public :: stack_model_t, new_stack_model

   !> Most curves of a block: each takes long.
   integer, parameter :: most_curves = 4
   !> Indices of the profiles: what was measured, the fitted ordinate, the residual.
   integer, parameter :: p_abscissa = 1, p_ordinate = 2, p_fitted = 3, p_residual = 4, n_profiles = 4
   !> A search ends at a step below this part of a standard error.
   real(dp), parameter :: last_step = 1.0e-6_dp

   !> A stack.
   type, extends(model_t) :: stack_model_t
      !> The model that is fitted; the stack gives it back.
      class(model_t), pointer :: fitted_model => null()
      !> What is fitted; the data sets of a stack are without their points.
      type(fit_t) :: fit
      !> Number of curves along each dimension, the slowest first; size 0 for a single fit.
      integer(i8), allocatable :: lengths(:)
      !> Index in `variables` of the one before the first dimension of the stack.
      integer :: last_before = 0
      !> Points of each curve; 0 where there are no profiles.
      integer :: n_samples = 0
      !> The curves; not allocated for a single fit, whose data sets have their points.
      class(curve_source_t), allocatable :: source
      !> Derived quantities in the order of their results.
      type(derived_t), allocatable :: derived(:)
      !> What a single fit has found, once the model is prepared.
      type(solution_t), allocatable :: solution
   contains
      procedure :: check_values
      procedure :: wants_profiles
      procedure :: get_profile_axes
      procedure :: prepare
      procedure :: release
      procedure :: obey
      procedure :: solve_block
      procedure :: solve_block_and_profiles
      procedure :: solve_profiles
      procedure :: list_states
      procedure :: get_extras
      procedure :: unit_of
      procedure :: is_single
      final :: remove_model
   end type stack_model_t

contains

   !> A stack, or a single fit. Its variables are those of the model that is fitted, the files with the data, and the indices along
   !> each dimension of the stack.
   subroutine new_stack_model(self, fit, n_files, lengths, n_samples, source)
      !> Receives the model of the run.
      type(stack_model_t), intent(out) :: self
      !> What is fitted; its model belongs to the stack from now on.
      type(fit_t), intent(in) :: fit
      !> Number of files or datasets that the points come from.
      integer, intent(in) :: n_files
      !> Number of curves along each dimension, the slowest first; size 0 for a single fit.
      integer(i8), intent(in) :: lengths(:)
      !> Points of each curve of a stack, if they are wanted beside the results; else 0.
      integer, intent(in) :: n_samples
      !> The curves, which are taken over; not allocated for a single fit.
      class(curve_source_t), allocatable, intent(inout) :: source

      self%fit = fit
      self%fit%wants_curves = size(lengths) == 0
      self%fitted_model => fit%model
      self%lengths = lengths
      call move_alloc(source, self%source)
      self%name = fit%model%name
      self%summary = fit%model%summary
      if (allocated(fit%model%scene)) self%scene = fit%model%scene
      self%references = fit%model%references
      if (self%is_single()) self%extra_names = list_extra_names(fit)
      call set_variables(self, n_files)
      call get_result_rows(fit, self%results)
      call find_derived_rows(fit, self%derived)
      allocate (self%counts(0))
      self%profile_axes = 'point'
      call set_profile_rows(self, n_samples)
      self%largest_block = most_curves
      self%shares_points = fit%model%shares_points
   end subroutine new_stack_model

   !> The table of the profiles: points and residuals of a curve, where a stack has one curve a point.
   subroutine set_profile_rows(self, n_samples)
      !> The stack, whose profiles are set.
      type(stack_model_t), intent(inout) :: self
      !> Points of each curve.
      integer, intent(in) :: n_samples
      character(:), allocatable :: x_unit, y_unit

      if (self%is_single() .or. n_samples == 0 .or. size(self%fit%data_sets) /= 1) then
         allocate (self%profiles(0))
         return
      end if
      self%n_samples = n_samples
      allocate (self%profiles(n_profiles))
      associate (of_data => self%fit%data_sets(1))
         call get_units(self%fit, of_data, x_unit, y_unit)
         self%profiles(p_abscissa) = row('abscissa', x_unit, self%fit%model%variables(of_data%abscissa)%name)
         self%profiles(p_ordinate) = row('ordinate', y_unit, self%fit%model%results(of_data%ordinate)%name)
      end associate
      self%profiles(p_fitted) = row('fitted', y_unit, 'the model at the measured points')
      self%profiles(p_residual) = row('residual', '-', 'residuals in standard errors')
   contains
      !> A profile. gfortran 12 copies too much into a constructor that has two components of deferred length.
      function row(name, unit, long_name) result(p)
         !> Its name, unit and meaning.
         character(*), intent(in) :: name, unit, long_name
         type(profile_t) :: p

         p%name = name
         p%unit = unit
         p%long_name = long_name
      end function row
   end subroutine set_profile_rows

   !> The table of variables.
   subroutine set_variables(self, n_files)
      !> The stack, whose variables are set.
      type(stack_model_t), intent(inout) :: self
      !> Number of files or datasets that the points come from.
      integer, intent(in) :: n_files
      character(:), allocatable :: name
      integer :: k

      associate (of_model => size(self%fitted_model%variables), n => size(self%lengths))
         self%last_before = of_model + n_files
         allocate (self%variables(self%last_before + n))
         self%variables(:of_model) = self%fitted_model%variables
         do k = 1, n_files
            name = 'data'
            if (n_files > 1) name = name//'_'//show_count(k)
            self%variables(of_model + k) = dataset(group='data', name=name, unit='-', meaning='the measured points', &
               largest_rank=2, least_count=1)
         end do
         do k = 1, n
            name = 'curve'
            if (n == 2) name = get_word('row column', k)
            if (n > 2) name = 'place_'//show_count(k)
            self%variables(self%last_before + k) = whole_number(group='data', name=name, &
               meaning='place in the stack along its dimension '//show_count(k)//', from 1', default=1, lower=1, upper=huge(1))
         end do
      end associate
   end subroutine set_variables

   !> The model that is fitted goes with the stack.
   impure elemental subroutine remove_model(self)
      type(stack_model_t), intent(inout) :: self

      if (associated(self%fitted_model)) deallocate (self%fitted_model)
   end subroutine remove_model

   !> Is it one fit, and no stack?
   pure logical function is_single(self)
      class(stack_model_t), intent(in) :: self

      is_single = size(self%lengths) == 0
   end function is_single

   !> See `model_t`: the input of a fit has been checked before there is a stack.
   subroutine check_values(self, values, is_swept, problems)
      class(stack_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout) :: problems

      associate (unused => self, unused_values => values, unused_swept => is_swept, unused_problems => problems)
      end associate
   end subroutine check_values

   !> See `model_t`: points and residuals, where they are wanted.
   pure logical function wants_profiles(self, values)
      class(stack_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      wants_profiles = self%n_samples > 0
      associate (unused_values => values)
      end associate
   end function wants_profiles

   !> See `model_t`: the points of a curve.
   subroutine get_profile_axes(self, values, axes)
      class(stack_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Receives the axis of the points.
      type(profile_axis_t), allocatable, intent(out) :: axes(:)
      integer :: k

      allocate (axes(1))
      axes(1)%name = self%profile_axes
      axes(1)%unit = '-'
      axes(1)%long_name = 'measured point'
      axes(1)%coordinates = [(real(k, dp), k=1, self%n_samples)]
      associate (unused_values => values)
      end associate
   end subroutine get_profile_axes

   !> See `model_t`: a single fit is solved here, so that its results file can be created with all that it has.
   subroutine prepare(self)
      class(stack_model_t), intent(inout) :: self

      call self%fitted_model%prepare()
      if (.not. self%is_single() .or. allocated(self%solution)) return
      allocate (self%solution)
      call solve_fit(self%fit, self%solution)
      if (self%is_stopped()) deallocate (self%solution)
   end subroutine prepare

   !> See `model_t`.
   subroutine obey(self, watch)
      class(stack_model_t), intent(inout) :: self
      class(watch_t), pointer, intent(in) :: watch

      self%watch => watch
      call self%fitted_model%obey(watch)
   end subroutine obey

   !> See `model_t`.
   subroutine release(self)
      class(stack_model_t), intent(inout) :: self

      call self%fitted_model%release()
      if (allocated(self%source)) call self%source%close()
   end subroutine release

   !> See `model_t`.
   subroutine solve_block(self, values, results, error_estimate, status, counts)
      class(stack_model_t), intent(in) :: self
      real(dp), intent(in), contiguous :: values(:, :)
      real(dp), intent(out) :: results(:, :)
      !> Relative error of the first variable that the search leaves; shape `(n_points)`.
      real(dp), intent(out) :: error_estimate(:)
      integer, intent(out) :: status(:)
      !> Of size 0: nothing is counted.
      real(dp), intent(out) :: counts(:)

      call solve_curves(self, values, results, error_estimate, status, counts)
   end subroutine solve_block

   !> See `model_t`: the residuals are those of the fit that the results are taken from.
   subroutine solve_block_and_profiles(self, values, results, error_estimate, status, counts, profiles, receiver)
      class(stack_model_t), intent(in) :: self
      !> Values of the variables for each curve; shape `(n_variables, n_points)`.
      real(dp), intent(in), contiguous :: values(:, :)
      !> Receives the results of each curve; shape `(n_results, n_points)`; NaN where there is no value.
      real(dp), intent(out) :: results(:, :)
      !> Relative error of the first variable that the search leaves; shape `(n_points)`.
      real(dp), intent(out) :: error_estimate(:)
      !> One of `fit_...` for each curve; shape `(n_points)`.
      integer, intent(out) :: status(:)
      !> Of size 0: nothing is counted.
      real(dp), intent(out) :: counts(:)
      !> Space for the profiles of one curve, of their shape; what stands in it at the end has no meaning.
      real(dp), intent(inout) :: profiles(:, :, :)
      !> Takes the profiles of one solved curve after the other, and says whether more are wanted.
      class(profile_receiver_t), intent(inout) :: receiver

      call solve_curves(self, values, results, error_estimate, status, counts, profiles, receiver)
   end subroutine solve_block_and_profiles

   !> Fit the curves of a block, with their profiles if they are wanted.
   subroutine solve_curves(self, values, results, error_estimate, status, counts, profiles, receiver)
      class(stack_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:, :)
      real(dp), intent(out) :: results(:, :), error_estimate(:)
      integer, intent(out) :: status(:)
      real(dp), intent(out) :: counts(:)
      real(dp), intent(inout), optional :: profiles(:, :, :)
      class(profile_receiver_t), intent(inout), optional :: receiver
      type(data_set_t), allocatable :: curves(:, :)
      class(model_t), allocatable, target :: own
      type(fit_t) :: fit
      type(solution_t) :: solution
      integer :: i
      logical :: is_read, goes_on

      results = not_a_number()
      error_estimate = not_a_number()
      status = fit_not_converged
      counts = 0
      if (allocated(self%solution)) then
         call keep(self, self%solution, results(:, 1), error_estimate(1), status(1))
         return
      end if
      fit = self%fit
      if (self%is_single()) then
         call solve_fit(fit, solution)
         call keep(self, solution, results(:, 1), error_estimate(1), status(1))
         return
      end if
      allocate (curves(size(fit%data_sets), size(status)))
      do i = 1, size(status)
         curves(:, i) = fit%data_sets
      end do
      call self%source%get_curves(curve_number(self, values(:, 1)), curves, is_read)
      if (.not. is_read) return
      if (any(fit%history_lists > 0)) then
         ! lists belong to a model, and other threads have other curves
         allocate (own, source=self%fitted_model)
         fit%model => own
      end if
      do i = 1, size(status)
         if (self%is_stopped()) return
         fit%data_sets = curves(:, i)
         if (any(fit%history_lists > 0)) then
            call take_history(fit%history_lists, curves(1, i), own, status(i))
            if (status(i) == fit_too_few_points) cycle
         end if
         call solve_fit(fit, solution)
         call keep(self, solution, results(:, i), error_estimate(i), status(i))
         if (.not. present(receiver) .or. status(i) /= fit_solved) cycle
         call fill_profiles(fit%data_sets(1), solution%data_sets(1), profiles)
         call receiver%take(i, profiles, goes_on)
         if (.not. goes_on) return
      end do
   end subroutine solve_curves

   !> Give a model the history of a curve. Times that fall are none.
   subroutine take_history(lists, curve, model, status)
      !> Positions of the times and of what is prescribed.
      integer, intent(in) :: lists(2)
      !> The curve.
      type(data_set_t), intent(in) :: curve
      !> The model, whose lists are changed.
      class(model_t), intent(inout) :: model
      !> Becomes `fit_too_few_points` where the curve has no history.
      integer, intent(inout) :: status
      type(problems_t) :: unused
      logical :: is_there(size(curve%x))
      real(dp), allocatable :: times(:), prescribed(:)

      is_there = ieee_is_finite(curve%x) .and. ieee_is_finite(curve%prescribed)
      times = pack(curve%x, is_there)
      prescribed = pack(curve%prescribed, is_there)
      associate (n => size(times))
         if (n < 2) then
            status = fit_too_few_points
         else if (any(times(2:) < times(:n - 1))) then
            status = fit_too_few_points
         else
            call model%take_dataset(lists(1), reshape(times, [n, 1]), unused)
            call model%take_dataset(lists(2), reshape(prescribed, [n, 1]), unused)
         end if
      end associate
   end subroutine take_history

   !> Points and residuals of a curve.
   pure subroutine fill_profiles(curve, found, profiles)
      type(data_set_t), intent(in) :: curve
      type(data_solution_t), intent(in) :: found
      !> Receives them; shape `(n_samples, 1, n_profiles)`.
      real(dp), intent(out) :: profiles(:, :, :)

      profiles(:, 1, p_abscissa) = curve%x
      profiles(:, 1, p_ordinate) = curve%y
      profiles(:, 1, p_fitted) = found%fitted
      profiles(:, 1, p_residual) = found%residual
   end subroutine fill_profiles

   !> Number of a curve in the stack, from 1: the last dimension runs fastest.
   pure integer(i8) function curve_number(self, values)
      class(stack_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      integer :: k

      curve_number = 0
      do k = 1, size(self%lengths)
         curve_number = curve_number*self%lengths(k) + nint(values(self%last_before + k), i8) - 1
      end do
      curve_number = curve_number + 1
   end function curve_number

   !> What a fit has found as results of a point.
   subroutine keep(self, solution, results, error_estimate, status)
      class(stack_model_t), intent(in) :: self
      type(solution_t), intent(in) :: solution
      !> Receives the results; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Relative error of the first variable that the search leaves; left as it is where there is none.
      real(dp), intent(inout) :: error_estimate
      integer, intent(out) :: status

      status = solution%status
      call get_result_values(self%fit, solution, self%derived, results)
      if (status /= fit_solved) return
      if (abs(solution%estimate(1)) > 0) error_estimate = last_step*solution%error(1)/abs(solution%estimate(1))
   end subroutine keep

   !> See `model_t`: they come with the results alone (`solve_block_and_profiles`).
   subroutine solve_profiles(self, values, results, profiles)
      class(stack_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:), results(:)
      !> Receives NaN.
      real(dp), intent(out) :: profiles(:, :, :)

      profiles = not_a_number()
      associate (unused => self, unused_values => values, unused_results => results)
      end associate
   end subroutine solve_profiles

   !> See `model_t`.
   function list_states(self) result(words)
      class(stack_model_t), intent(in) :: self
      character(:), allocatable :: words

      words = fit_status_meanings
      associate (unused => self)
      end associate
   end function list_states

   !> See `model_t`: what a single fit has in addition.
   subroutine get_extras(self, extras)
      class(stack_model_t), intent(in) :: self
      type(extra_t), allocatable, intent(out) :: extras(:)

      if (allocated(self%solution)) then
         call get_solution_extras(self%fit, self%solution, extras)
      else
         allocate (extras(0))
      end if
   end subroutine get_extras

   !> See `model_t`.
   function unit_of(self, values, index) result(unit)
      class(stack_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      integer, intent(in) :: index
      character(:), allocatable :: unit

      unit = self%variables(index)%unit
      if (index <= size(self%fitted_model%variables)) unit = self%fitted_model%unit_of(values(:size(self%fitted_model%variables)), &
         index)
   end function unit_of

end module adfric_fit_stack_model
