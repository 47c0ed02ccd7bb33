! SPDX-License-Identifier: GPL-3.0-or-later
!> The results of a fit that every curve of a stack has: the rows of their table, and their values.
module adfric_fit_result_rows
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_words, only: get_word
   use adfric_fit_names, only: list_free_names, find_derived_rows
   use adfric_fit_problem, only: fit_t
   use adfric_fit_solution, only: solution_t, fit_solved, fit_not_identifiable
   use adfric_describe_doubt, only: find_doubt
   use adfric_describe_model, only: derived_t
   use adfric_describe_rows, only: result_row
   use adfric_describe_table, only: doubt_row, result_t
   implicit none (type, external)
   private
   public :: get_result_rows, get_result_values

   !> Results of each free variable, of each derived quantity, and of the fit as a whole.
   integer, parameter :: n_of_free = 3, n_of_derived = 2, n_of_fit = 17

contains

   !> The rows, in the order of the values.
   subroutine get_result_rows(fit, rows)
      !> The fit with its model and its free variables.
      type(fit_t), intent(in) :: fit
      type(result_t), allocatable, intent(out) :: rows(:)
      type(derived_t), allocatable :: derived(:)
      character(:), allocatable :: names, name
      integer :: i, n

      call find_derived_rows(fit, derived)
      names = list_free_names(fit)
      allocate (rows(n_of_free*size(fit%frees) + n_of_derived*size(derived) + n_of_fit))
      n = 0
      do i = 1, size(fit%frees)
         name = get_word(names, i)
         rows(n + 1) = result_row(name, fit%frees(i)%unit, 'best value of '//fit%frees(i)%name, is_main=.true.)
         rows(n + 2) = result_row(name//'_error', fit%frees(i)%unit, 'standard error of '//name//'; none at a bound')
         rows(n + 3) = result_row(name//'_bound', '-', 'bound that holds '//name//': -1 the lower, 1 the upper one, 0 none')
         n = n + n_of_free
      end do
      do i = 1, size(derived)
         rows(n + 1) = result_row(derived(i)%name, derived(i)%unit, derived(i)%long_name)
         rows(n + 2) = result_row(derived(i)%name//'_error', derived(i)%unit, 'standard error of '//derived(i)%name// &
            ' by the linear rule')
         n = n + n_of_derived
      end do
      rows(n + 1:) = rows_of_fit(fit)
   end subroutine get_result_rows

   !> The rows of the fit as a whole.
   function rows_of_fit(fit) result(rows)
      !> The fit, the unit of whose ordinate is that of an unknown sigma.
      type(fit_t), intent(in) :: fit
      type(result_t) :: rows(n_of_fit)
      type(result_t), allocatable :: of_model(:)
      character(:), allocatable :: unit

      allocate (of_model, source=fit%model%describe_results(fit%base))
      unit = of_model(fit%data_sets(1)%ordinate)%unit
      rows(1) = result_row('chi2', '-', 'least sum of squares S in standard errors; where these are not known, in the unit ' &
         //'of the ordinate', is_main=.true.)
      rows(2) = result_row('degrees_of_freedom', '-', 'points, events and priors less free variables')
      rows(3) = result_row('p_value', '-', 'probability Q of a larger S', is_main=.true.)
      rows(4) = result_row('sigma_estimate', unit, 'standard error of a point as found from S, where it was not known')
      rows(5) = result_row('aic', '-', 'criterion of Akaike')
      rows(6) = result_row('bic', '-', 'criterion of Bayes')
      rows(7) = result_row('at_bound', '-', 'number of variables held by a bound')
      rows(8) = result_row('n_minima', '-', 'number of distinct minima with S less than 12 above the least')
      rows(9) = result_row('second_minimum', '-', 'S of the second minimum less the least S')
      rows(10) = result_row('iterations', '-', 'iterations of all searches')
      rows(11) = result_row('evaluations', '-', 'evaluations of all curves')
      rows(12) = result_row('points_used', '-', 'points that are used')
      rows(13) = result_row('points_beyond_fold', '-', 'points beyond the fold at the best fit')
      rows(14) = result_row('n_outliers', '-', 'residuals beyond 3 standard errors')
      rows(15) = result_row('runs_p_value', '-', 'probability of so many or so few runs of equal signs of the residuals')
      rows(16) = result_row('lag_correlation', '-', 'correlation of neighbouring residuals')
      rows(17) = doubt_row()
   end function rows_of_fit

   !> The values of the rows.
   subroutine get_result_values(fit, solution, derived_names, values)
      type(fit_t), intent(in) :: fit
      type(solution_t), intent(in) :: solution
      !> Names of the derived quantities in the order of their rows.
      type(derived_t), intent(in) :: derived_names(:)
      !> Receives the values, NaN where there is none.
      real(dp), intent(out) :: values(:)
      integer :: i, k, n

      values = not_a_number()
      n = size(values) - n_of_fit
      values(n + 12) = solution%points_used
      if (.not. any(solution%status == [fit_solved, fit_not_identifiable])) return
      call set_values_of_fit(solution, values(n + 1:))
      if (solution%status /= fit_solved) return
      values(n + 17) = find_doubt(solution%measures)
      do i = 1, size(fit%frees)
         k = n_of_free*(i - 1)
         values(k + 1) = solution%estimate(i)
         values(k + 2) = solution%error(i)
         values(k + 3) = solution%at_bound(i)
      end do
      if (.not. allocated(solution%derived)) return
      do i = 1, size(derived_names)
         k = n_of_free*size(fit%frees) + n_of_derived*(i - 1)
         call find_derived(solution, derived_names(i), values(k + 1:k + 2))
      end do
   end subroutine get_result_values

   !> The values of the fit as a whole.
   subroutine set_values_of_fit(solution, values)
      type(solution_t), intent(in) :: solution
      !> Receives the values; shape `(n_of_fit)`.
      real(dp), intent(inout) :: values(:)

      values(:6) = [solution%chi2, real(solution%degrees_of_freedom, dp), solution%p_value, solution%sigma_estimate, solution%aic, &
         solution%bic]
      if (allocated(solution%at_bound)) values(7) = count(solution%at_bound /= 0)
      if (allocated(solution%minima_chi2)) then
         values(8) = size(solution%minima_chi2)
         if (size(solution%minima_chi2) > 1) values(9) = solution%minima_chi2(2) - solution%minima_chi2(1)
      end if
      values(10:14) = real([solution%iterations, solution%evaluations, solution%points_used, solution%points_beyond_fold, &
         solution%n_outliers], dp)
      values(15) = solution%runs_p_value
      values(16) = solution%lag_correlation
   end subroutine set_values_of_fit

   !> Value and error of a derived quantity; left as they are if the solution has it not.
   subroutine find_derived(solution, row, pair)
      type(solution_t), intent(in) :: solution
      type(derived_t), intent(in) :: row
      !> Receives value and standard error.
      real(dp), intent(inout) :: pair(2)
      integer :: i

      do i = 1, size(solution%derived)
         if (solution%derived(i)%name == row%name) pair = [solution%derived(i)%value, solution%derived(i)%error]
      end do
   end subroutine find_derived

end module adfric_fit_result_rows
