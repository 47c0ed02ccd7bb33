! SPDX-License-Identifier: GPL-3.0-or-later
!> What a fit has found.
module adfric_fit_solution
   use adfric_base_kinds, only: dp
   use adfric_describe_doubt, only: n_doubts, not_measured
   implicit none (type, external)
   private
   public :: solution_t, data_solution_t, profile_grid_t, derived_value_t, theory_solution_t
   public :: fit_solved, fit_too_few_points, fit_not_converged, fit_not_identifiable, fit_status_meanings

   !> The best values were found.
   integer, parameter :: fit_solved = 0
   !> There are fewer measured points, or fewer in contact, than free variables need.
   integer, parameter :: fit_too_few_points = 1
   !> No search is known to have ended at the least sum of squares.
   integer, parameter :: fit_not_converged = 2
   !> The data do not determine the free variables: other values fit as well.
   integer, parameter :: fit_not_identifiable = 3
   !> Their names, from 0 on.
   character(*), parameter :: fit_status_meanings = 'fitted too_few_points not_converged not_identifiable'

   !> What there is of one data set.
   type :: data_solution_t
      !> The model at the measured abscissas, and the residuals in standard errors; NaN where a point is left out. With errors of the
      !> abscissa `fitted` is the ordinate of the point's foot. Shape `(n_points)`.
      real(dp), allocatable :: fitted(:), residual(:)
      !> The curve at 201 abscissas or more over the range of the data, with its band of 95 % by the linear rule; one behind the other
      !> where the points have values of further variables, with NaN between two.
      real(dp), allocatable :: curve_x(:), curve(:), band_low(:), band_high(:)
      !> Values of the further variables of the data set there; not allocated: there are none. Shape `(n_others, n)`.
      real(dp), allocatable :: curve_at(:, :)
      !> The curve of the second minimum at the same abscissas; not allocated if there is none.
      real(dp), allocatable :: second_curve(:)
      !> Which points were found to be in contact, where the data do not say it and some are not; else not allocated. Shape `(n_points)`.
      logical, allocatable :: is_contact(:)
      !> Which points of the best fit belong to the base line: free ones, and those before touch. Shape `(n_points)`.
      logical, allocatable :: is_apart(:)
      !> Points that are used.
      integer :: points_used = 0
   end type data_solution_t

   !> S - S_min as a function of one variable, the others free.
   type :: profile_grid_t
      !> Values of the variable, rising, and S - S_min there.
      real(dp), allocatable :: value(:), excess(:)
   end type profile_grid_t

   !> A derived quantity.
   type :: derived_value_t
      !> Name, and SI unit.
      character(:), allocatable :: name, unit
      !> Value, and its standard error by the linear rule.
      real(dp) :: value = 0, error = 0
   end type derived_value_t

   !> The best fit of another theory.
   type :: theory_solution_t
      !> Name of the theory.
      character(:), allocatable :: name
      !> Least S, and both criteria; NaN where the theory does not fit these data at all.
      real(dp) :: chi2 = 0, aic = 0, bic = 0
      !> Estimates in the order of the free variables; NaN for those that the theory does not have. Shape `(n_free)`.
      real(dp), allocatable :: estimate(:)
   end type theory_solution_t

   !> What a fit has found. `n_free` is the number of free variables.
   type :: solution_t
      !> One of `fit_...`.
      integer :: status = fit_not_converged
      !> Why there is no answer, empty if there is one.
      character(:), allocatable :: reason
      !> Estimates and standard errors in the unit of each variable; the error is NaN at a bound. Shape `(n_free)`.
      real(dp), allocatable :: estimate(:), error(:)
      !> Standard errors of the variables as they are fitted: relative ones for those fitted by their logarithm.
      real(dp), allocatable :: error_internal(:)
      !> Covariance in the units of the variables, and of the variables as they are fitted; of all variables, as if no bound
      !> prescribed one.
      real(dp), allocatable :: covariance(:, :), covariance_internal(:, :)
      !> Correlations.
      real(dp), allocatable :: correlation(:, :)
      !> Was the covariance multiplied by S/(n - p), since sigma is not known?
      logical :: covariance_scaled = .false.
      !> -1, 1: the variable is kept by its lower, upper bound; else 0.
      integer, allocatable :: at_bound(:)
      !> Least S; with a robust loss twice the least cost.
      real(dp) :: chi2 = 0
      !> n - p: points, events and priors less free variables.
      integer :: degrees_of_freedom = 0
      !> Probability of a larger S; NaN where sigma is not known, and with a robust loss.
      real(dp) :: p_value = 0
      !> Standard error of a point as found from S; NaN where sigma is given.
      real(dp) :: sigma_estimate = 0
      !> Criteria of Akaike and Bayes.
      real(dp) :: aic = 0, bic = 0
      !> All distinct minima with S - S_min < 12, the least first; shapes `(n_free, n_minima)`, `(n_minima)`.
      real(dp), allocatable :: minima(:, :), minima_chi2(:)
      !> Is the variable at a bound there? As `at_bound`; shape `(n_free, n_minima)`.
      integer, allocatable :: minima_at_bound(:, :)
      !> Intervals as lists of pieces: shape `(2, n_pieces, n_levels, n_free)`, NaN: no piece, or an open end.
      real(dp), allocatable :: interval(:, :, :, :)
      !> Number of pieces of each; 0: none was found. Shape `(n_levels, n_free)`.
      integer, allocatable :: interval_pieces(:, :)
      !> What the data do not see: a direction in the variables as they are fitted, of length 1; 0 if they see all. Shape `(n_free)`.
      real(dp), allocatable :: null_vector(:)
      !> Iterations of all searches, and evaluations of all curves.
      integer :: iterations = 0, evaluations = 0
      !> Points used, points beyond the fold at the best fit and anywhere in the profile.
      integer :: points_used = 0, points_beyond_fold = 0, points_beyond_fold_in_profile = 0
      !> What the bounds of the theory are compared with, the largest of all points of contact, in the order of the doubts.
      real(dp) :: measures(n_doubts) = not_measured
      !> Residuals beyond 3 standard errors: how many, and data set and point of each; shape `(2, n_outliers)`.
      integer :: n_outliers = 0
      !> Data set and point of each outlier; shape `(2, n_outliers)`.
      integer, allocatable :: outliers(:, :)
      !> Two-sided probability of so many or so few runs of equal signs; NaN with fewer than 10 residuals.
      real(dp) :: runs_p_value = 0
      !> Correlation of neighbouring residuals.
      real(dp) :: lag_correlation = 0
      !> Starts that were tried, and those that ended in the best minimum.
      integer :: starts = 0, starts_at_best = 0
      !> Derived quantities with their errors.
      type(derived_value_t), allocatable :: derived(:)
      !> Other theories.
      type(theory_solution_t), allocatable :: theories(:)
      !> Each data set.
      type(data_solution_t), allocatable :: data_sets(:)
      !> Each free variable's profile; size 0 where none was asked for.
      type(profile_grid_t), allocatable :: profiles(:)
   end type solution_t

end module adfric_fit_solution
