! SPDX-License-Identifier: GPL-3.0-or-later
!> What the residuals of a fit say: outliers, runs of equal signs, correlation of neighbours.
module adfric_fit_residuals
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_fit_curve, only: fit_curve_t
   use adfric_fit_order, only: order_of
   use adfric_fit_parts, only: number_curves
   use adfric_fit_problem, only: fit_t
   use adfric_fit_solution, only: solution_t
   use adfric_numerics_distributions, only: normal_outside
   implicit none (type, external)
   private
   public :: look_at_residuals, take_curve

   !> A residual beyond this many standard errors is an outlier.
   real(dp), parameter :: outlier_limit = 3.0_dp
   !> Fewer residuals say nothing of runs.
   integer, parameter :: least_count = 10

   !> Runs so far: how many, how many are expected, and the variance.
   type :: runs_t
      !> How many there are, are expected, and the variance.
      real(dp) :: found = 0, expected = 0, variance = 0
      !> Products of neighbours, and squares.
      real(dp) :: product = 0, square = 0
      !> Number of residuals.
      integer :: n = 0
   end type runs_t

contains

   !> Copy what an evaluation has left of a curve to its data set, whose count of points begins at 0.
   subroutine take_curve(curve, sigma, solution)
      class(fit_curve_t), intent(in) :: curve
      !> Standard error of a point in the units of the residuals.
      real(dp), intent(in) :: sigma
      !> Receives the fitted ordinates and residuals.
      type(solution_t), intent(inout) :: solution

      associate (data => solution%data_sets(curve%data_set))
         data%points_used = data%points_used + curve%n
         data%fitted(curve%index) = curve%fitted
         data%residual(curve%index) = curve%residual/sigma
         if (.not. allocated(data%is_apart)) allocate (data%is_apart(size(data%fitted)), source=.false.)
         data%is_apart(curve%index) = curve%is_apart
      end associate
   end subroutine take_curve

   !> Outliers, runs and correlation.
   subroutine look_at_residuals(fit, solution)
      type(fit_t), intent(in) :: fit
      !> In: with the residuals of all data sets. Out: with what they say.
      type(solution_t), intent(inout) :: solution
      type(runs_t) :: runs
      integer :: k, i, n
      integer, allocatable :: curve(:)
      logical, allocatable :: is_used(:)

      allocate (curve(0))
      n = 0
      do k = 1, size(solution%data_sets)
         n = n + count(abs_of(solution%data_sets(k)%residual) > outlier_limit)
      end do
      solution%n_outliers = n
      if (allocated(solution%outliers)) deallocate (solution%outliers)
      allocate (solution%outliers(2, n))
      n = 0
      do k = 1, size(solution%data_sets)
         associate (r => solution%data_sets(k)%residual)
            is_used = abs_of(r) >= 0
            do i = 1, size(r)
               if (.not. is_used(i)) cycle
               if (abs(r(i)) > outlier_limit) then
                  n = n + 1
                  solution%outliers(:, n) = [k, i]
               end if
            end do
            curve = number_curves(fit%data_sets(k))
            do i = 1, maxval([curve, 0])
               call add_runs(fit%data_sets(k)%x, r, is_used .and. curve == i, runs)
            end do
         end associate
      end do
      solution%runs_p_value = not_a_number()
      solution%lag_correlation = not_a_number()
      if (runs%n < least_count) return
      if (runs%square > 0) solution%lag_correlation = runs%product/runs%square
      if (runs%variance > 0) solution%runs_p_value = normal_outside((runs%found - runs%expected)/sqrt(runs%variance))
   end subroutine look_at_residuals

   !> Size of a residual; -1 where there is none.
   elemental real(dp) function abs_of(residual)
      !> The residual, or NaN.
      real(dp), intent(in) :: residual

      abs_of = -1
      if (.not. ieee_is_nan(residual)) abs_of = abs(residual)
   end function abs_of

   !> Add the runs of one data set along its abscissa (Wald and Wolfowitz), and the products of neighbours in the order of measurement.
   pure subroutine add_runs(x, r, is_used, runs)
      real(dp), intent(in) :: x(:)
      !> Residuals.
      real(dp), intent(in) :: r(:)
      !> Which of them count.
      logical, intent(in) :: is_used(:)
      type(runs_t), intent(inout) :: runs
      real(dp) :: sorted(count(is_used)), plus, minus, n

      n = size(sorted)
      sorted = pack(r, is_used)
      runs%n = runs%n + size(sorted)
      if (size(sorted) < 2) return
      runs%product = runs%product + dot_product(sorted(2:), sorted(:size(sorted) - 1))
      runs%square = runs%square + dot_product(sorted, sorted)
      sorted = sorted(order_of(pack(x, is_used)))
      plus = count(sorted > 0)
      minus = n - plus
      runs%found = runs%found + 1 + count((sorted(2:) > 0) .neqv. (sorted(:size(sorted) - 1) > 0))
      runs%expected = runs%expected + 1 + 2*plus*minus/n
      runs%variance = runs%variance + 2*plus*minus*(2*plus*minus - n)/(n**2*(n - 1))
   end subroutine add_runs

end module adfric_fit_residuals
