! SPDX-License-Identifier: GPL-3.0-or-later
!> A model that tells of its results how they change with variables and how uncertain they are: it holds another model, solves each
!> point and what is around it, and has more rows in its table of results. To whoever runs it, it is a model like any other.
module adfric_run_varied_model
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_describe_model, only: model_t
   use adfric_describe_profile_receiver, only: profile_receiver_t
   use adfric_describe_status, only: status_not_converged, status_out_of_memory, status_solved
   use adfric_describe_table, only: result_t
   use adfric_numerics_unit_samples, only: fill_latin_hypercube, normal_quantile
   use adfric_run_sample_statistics, only: find_statistics
   use adfric_run_stencil, only: differentiate, is_allowed, solve_some
   use adfric_run_variation, only: n_statistics, new_rows, variation_t
   use adfric_run_wrapped_model, only: wrapped_model_t
   implicit none (type, external)
   private
   public :: varied_model_t, vary_model

   !> A model with more results.
   type, extends(wrapped_model_t) :: varied_model_t
      private
      !> What is wanted.
      type(variation_t) :: wanted
      !> Indices of the variables that change: those of the derivatives, then the others that have an error.
      integer, allocatable :: variables_changed(:)
      !> Size that each of them has in the run, for the step where it is 0.
      real(dp), allocatable :: scales(:)
      !> Indices of the numbers among the results of the inner model.
      integer, allocatable :: numbers(:)
      !> Standard normal variables of each sample; shape `(n_uncertain, n_samples)`.
      real(dp), allocatable :: normal(:, :)
   contains
      procedure :: solve_block
      procedure :: solve_block_and_profiles
      procedure :: describe_results
   end type varied_model_t

contains

   !> Is a result a number that the scene has, so that it varies?
   elemental logical function is_varied(result)
      type(result_t), intent(in) :: result

      is_varied = result%n_states() == 0 .and. .not. result%is_hidden
   end function is_varied

   !> Make a model tell more.
   subroutine vary_model(model, wanted, scales)
      !> In: the model. Out: a model that holds it.
      class(model_t), allocatable, intent(inout) :: model
      type(variation_t), intent(in) :: wanted
      !> Size > 0 that each variable has in the run; shape `(n_variables)`.
      real(dp), intent(in) :: scales(:)
      type(varied_model_t), allocatable :: varied
      type(result_t), allocatable :: units(:), numbers(:), rows(:)
      integer :: i, k

      allocate (varied)
      call varied%wrap(model)
      varied%wanted = wanted
      varied%variables_changed = wanted%derivatives
      do k = 1, size(wanted%uncertain)
         if (any(varied%variables_changed == wanted%uncertain(k)%variable)) cycle
         varied%variables_changed = [varied%variables_changed, wanted%uncertain(k)%variable]
      end do
      varied%scales = scales(varied%variables_changed)
      associate (inner => varied%inner)
         varied%numbers = pack([(i, i=1, size(inner%results))], is_varied(inner%results))
         allocate (units(size(wanted%derivatives)))
         do k = 1, size(units)
            units(k)%unit = inner%variables(wanted%derivatives(k))%unit
         end do
         call pick_rows(inner%results, varied%numbers, numbers)
         call new_rows(wanted, inner%variables, units, numbers, names_of(inner%results), rows)
         call join_rows(inner%results, rows, varied%results)
      end associate
      allocate (varied%normal(size(wanted%uncertain), wanted%n_samples))
      if (wanted%n_samples > 0) then
         call fill_latin_hypercube(wanted%seed, varied%normal)
         do i = 1, wanted%n_samples
            do k = 1, size(wanted%uncertain)
               varied%normal(k, i) = normal_quantile(varied%normal(k, i))
            end do
         end do
      end if
      call move_alloc(varied, model)
   end subroutine vary_model

   !> Names of the rows of a table, separated by a blank.
   pure function names_of(table) result(names)
      type(result_t), intent(in) :: table(:)
      character(:), allocatable :: names
      integer :: i

      names = ''
      do i = 1, size(table)
         names = names//' '//table(i)%name
      end do
   end function names_of

   !> Some rows of a table.
   subroutine pick_rows(table, indices, rows)
      type(result_t), intent(in) :: table(:)
      integer, intent(in) :: indices(:)
      type(result_t), allocatable, intent(out) :: rows(:)
      integer :: i

      allocate (rows(size(indices)))
      do i = 1, size(indices)
         rows(i) = table(indices(i))
      end do
   end subroutine pick_rows

   !> Put rows behind others.
   subroutine join_rows(first, second, both)
      type(result_t), intent(in) :: first(:), second(:)
      type(result_t), allocatable, intent(out) :: both(:)
      integer :: i

      allocate (both(size(first) + size(second)))
      do i = 1, size(first)
         both(i) = first(i)
      end do
      do i = 1, size(second)
         both(size(first) + i) = second(i)
      end do
   end subroutine join_rows

   !> See `model_t`.
   subroutine solve_block(self, values, results, error_estimate, status, counts)
      class(varied_model_t), intent(in) :: self
      real(dp), intent(in), contiguous :: values(:, :)
      real(dp), intent(out) :: results(:, :), error_estimate(:)
      integer, intent(out) :: status(:)
      real(dp), intent(out) :: counts(:)
      real(dp), allocatable :: own(:, :)

      allocate (own(size(self%inner%results), size(values, 2)))
      call self%inner%solve_block(values, own, error_estimate, status, counts)
      call add_variations(self, values, own, error_estimate, status, results, counts)
   end subroutine solve_block

   !> See `model_t`.
   subroutine solve_block_and_profiles(self, values, results, error_estimate, status, counts, profiles, receiver)
      class(varied_model_t), intent(in) :: self
      real(dp), intent(in), contiguous :: values(:, :)
      real(dp), intent(out) :: results(:, :), error_estimate(:)
      integer, intent(out) :: status(:)
      real(dp), intent(out) :: counts(:)
      real(dp), intent(inout) :: profiles(:, :, :)
      class(profile_receiver_t), intent(inout) :: receiver
      real(dp), allocatable :: own(:, :)

      allocate (own(size(self%inner%results), size(values, 2)))
      call self%inner%solve_block_and_profiles(values, own, error_estimate, status, counts, profiles, receiver)
      call add_variations(self, values, own, error_estimate, status, results, counts)
   end subroutine solve_block_and_profiles

   !> Add what is wanted to the results of the inner model.
   subroutine add_variations(self, values, own, error_estimate, status, results, counts)
      class(varied_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:, :)
      !> Results of the inner model; shape `(n_inner_results, n_points)`.
      real(dp), intent(in) :: own(:, :)
      !> Relative error of each point.
      real(dp), intent(in) :: error_estimate(:)
      !> Status of each point, which becomes `status_out_of_memory` where that is so.
      integer, intent(inout) :: status(:)
      !> Receives all results; shape `(n_results, n_points)`.
      real(dp), intent(out) :: results(:, :)
      !> What is counted; that of the points around is added.
      real(dp), intent(inout) :: counts(:)
      real(dp), allocatable :: slopes(:, :), squares(:, :)
      integer :: k, n, n_inner
      logical :: is_out_of_memory

      results = not_a_number()
      n_inner = size(own, 1)
      results(:n_inner, :) = own
      ! of what cannot be solved there is nothing around
      if (any(status == status_out_of_memory)) return
      is_out_of_memory = .false.
      n = size(self%numbers)
      allocate (slopes, mold=own)
      allocate (squares(n, size(status)), source=0.0_dp)
      do k = 1, size(self%variables_changed)
         call differentiate(self%inner, self%variables_changed(k), self%scales(k), values, own, error_estimate, status, slopes, &
            & counts, is_out_of_memory)
         if (k <= size(self%wanted%derivatives)) &
            & results(n_inner + (k - 1)*n + 1:n_inner + k*n, :) = slopes(self%numbers, :)
         call add_squares(self, self%variables_changed(k), values, slopes(self%numbers, :), squares)
      end do
      n_inner = n_inner + n*size(self%wanted%derivatives)
      if (size(self%wanted%uncertain) > 0) then
         do k = 1, size(status)
            if (status(k) /= status_not_converged) results(n_inner + 1:n_inner + n, k) = sqrt(squares(:, k))
         end do
      end if
      n_inner = n_inner + n
      do k = 1, size(status)
         if (self%wanted%n_samples == 0 .or. status(k) == status_not_converged) cycle
         call sample_point(self, values(:, k), results(n_inner + 1:, k), counts, is_out_of_memory)
      end do
      if (is_out_of_memory) status = status_out_of_memory
   end subroutine add_variations

   !> Add the square of what the error of a variable does to the results.
   pure subroutine add_squares(self, variable, values, slopes, squares)
      class(varied_model_t), intent(in) :: self
      integer, intent(in) :: variable
      real(dp), intent(in) :: values(:, :)
      !> Derivatives of the numbers by the variable; shape `(n_numbers, n_points)`.
      real(dp), intent(in) :: slopes(:, :)
      !> Sums of squares, to which those of the variable are added; shape of `slopes`.
      real(dp), intent(inout) :: squares(:, :)
      real(dp) :: error
      integer :: i, k

      do k = 1, size(self%wanted%uncertain)
         if (self%wanted%uncertain(k)%variable /= variable) cycle
         do i = 1, size(values, 2)
            error = error_at(self, k, values(variable, i))
            if (error > 0) squares(:, i) = squares(:, i) + (slopes(:, i)*error)**2
         end do
      end do
   end subroutine add_squares

   !> Standard error of a variable at a value.
   pure real(dp) function error_at(self, index, value)
      class(varied_model_t), intent(in) :: self
      !> Index among the variables that have an error.
      integer, intent(in) :: index
      !> Value of the variable.
      real(dp), intent(in) :: value

      associate (uncertain => self%wanted%uncertain(index))
         error_at = hypot(uncertain%error, uncertain%relative_error*value)
      end associate
   end function error_at

   !> Solve the samples of a point, and tell their statistics.
   subroutine sample_point(self, values, statistics, counts, is_out_of_memory)
      class(varied_model_t), intent(in) :: self
      !> Values of the variables of the point; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the statistics of each number, and the share of samples that are solved.
      real(dp), intent(inout) :: statistics(:)
      !> What is counted; that of the samples is added.
      real(dp), intent(inout) :: counts(:)
      !> Was there too little memory for a sample?
      logical, intent(inout) :: is_out_of_memory
      real(dp), allocatable :: samples(:, :), results(:, :)
      integer, allocatable :: status(:)
      logical, allocatable :: is_wanted(:)
      integer :: i, k

      associate (n => self%wanted%n_samples, uncertain => self%wanted%uncertain)
         samples = spread(values, 2, n)
         allocate (results(size(self%inner%results), n), status(n), is_wanted(n))
         is_wanted = .true.
         do k = 1, size(uncertain)
            associate (index => uncertain(k)%variable)
               samples(index, :) = values(index) + error_at(self, k, values(index))*self%normal(k, :)
               is_wanted = is_wanted .and. is_allowed(samples(index, :), self%variables(index))
            end associate
         end do
         call solve_some(self%inner, samples, is_wanted, results, status, counts, is_out_of_memory)
         do i = 1, size(self%numbers)
            call find_statistics(results(self%numbers(i), :), statistics((i - 1)*n_statistics + 1:i*n_statistics))
         end do
         statistics(size(self%numbers)*n_statistics + 1) = real(count(status == status_solved), dp)/n
      end associate
   end subroutine sample_point

   !> See `model_t`: the units of what is added follow from those of the results and the variables in this case.
   function describe_results(self, values) result(results)
      class(varied_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(result_t), allocatable :: results(:), own(:), units(:), numbers(:), rows(:)
      integer :: k

      allocate (own, source=self%inner%describe_results(values))
      allocate (units(size(self%wanted%derivatives)))
      do k = 1, size(units)
         units(k)%unit = self%inner%unit_of(values, self%wanted%derivatives(k))
      end do
      call pick_rows(own, self%numbers, numbers)
      call new_rows(self%wanted, self%inner%variables, units, numbers, names_of(own), rows)
      call join_rows(own, rows, results)
   end function describe_results

end module adfric_run_varied_model
