! SPDX-License-Identifier: GPL-3.0-or-later
!> Estimates of a fit and their statistics, without intervals: the least minimum, its errors, goodness and residuals.
module adfric_fit_estimate
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_fit_course, only: course_t, begin_course, has_too_few_points, refine_minima, take_minima
   use adfric_fit_covariance, only: find_covariance
   use adfric_fit_derived, only: find_derived
   use adfric_fit_doubt, only: measure_fit
   use adfric_fit_objective, only: take_estimate
   use adfric_fit_problem, only: fit_t
   use adfric_fit_residuals, only: look_at_residuals, take_curve
   use adfric_fit_scales, only: find_refusal
   use adfric_fit_solution, only: solution_t, fit_solved, fit_too_few_points, fit_not_converged, fit_not_identifiable
   use adfric_fit_thinning, only: search_minima
   use adfric_numerics_bounded_least_squares, only: squares_converged, squares_stuck
   use adfric_numerics_distributions, only: chi_squared_above
   implicit none (type, external)
   private
   public :: solve_best, finish_estimate

contains

   !> Estimates and their statistics, without intervals.
   subroutine solve_best(fit, course, solution)
      type(fit_t), intent(in) :: fit
      type(course_t), intent(out) :: course
      type(solution_t), intent(inout) :: solution

      call make_space(fit, solution)
      call find_refusal(fit, solution%reason)
      if (len(solution%reason) > 0) return
      call begin_course(course, fit)
      solution%points_used = course%n_points
      solution%degrees_of_freedom = course%freedom
      if (has_too_few_points(course, fit)) then
         solution%status = fit_too_few_points
         solution%reason = 'there are fewer points than free variables'
         return
      end if
      call search_minima(course, fit)
      call refine_minima(course)
      if (course%minima%n < 1) then
         solution%reason = 'the model has no value at some point, whatever the start; are all points in its range, '// &
            & 'such as times within a path?'
         return
      end if
      call take_minima(course, solution)
      call finish_estimate(course, fit, solution)
   end subroutine solve_best

   !> Give every part of the solution its shape.
   subroutine make_space(fit, solution)
      type(fit_t), intent(in) :: fit
      !> Receives arrays of NaN.
      type(solution_t), intent(inout) :: solution
      real(dp) :: none
      integer :: n, k, n_levels

      none = not_a_number()
      n = size(fit%frees)
      n_levels = 0
      if (allocated(fit%levels)) n_levels = size(fit%levels)
      allocate (solution%estimate(n), solution%error(n), solution%error_internal(n), source=none)
      allocate (solution%covariance(n, n), solution%covariance_internal(n, n), solution%correlation(n, n), source=none)
      allocate (solution%at_bound(n), source=0)
      allocate (solution%null_vector(n), source=0.0_dp)
      allocate (solution%interval(2, 0, n_levels, n))
      allocate (solution%interval_pieces(n_levels, n), source=0)
      allocate (solution%theories(0), solution%profiles(0))
      allocate (solution%data_sets(size(fit%data_sets)))
      do k = 1, size(fit%data_sets)
         allocate (solution%data_sets(k)%fitted(size(fit%data_sets(k)%x)), source=none)
         allocate (solution%data_sets(k)%residual(size(fit%data_sets(k)%x)), source=none)
      end do
      solution%chi2 = none
      solution%p_value = none
      solution%sigma_estimate = none
      solution%aic = none
      solution%bic = none
   end subroutine make_space

   !> Estimates, errors, goodness.
   subroutine finish_estimate(course, fit, solution)
      type(course_t), intent(inout) :: course
      type(fit_t), intent(in) :: fit
      !> Receives what follows from the best minimum.
      type(solution_t), intent(inout) :: solution
      real(dp) :: slopes(size(fit%frees)), v(size(fit%frees)), covariance(size(fit%frees), size(fit%frees)), q(size(fit%frees))
      logical :: is_identifiable, is_valid
      integer :: k

      q = course%minima%q(:, 1)
      call take_estimate(course%objective, q, v, slopes)
      solution%estimate = v
      solution%at_bound = solution%minima_at_bound(:, 1)
      call find_covariance(course%objective, q, course%work, covariance, solution%null_vector, is_identifiable, is_valid)
      call finish_goodness(course, solution)
      solution%status = fit_solved
      if (course%minima%status(1) /= squares_converged) then
         solution%status = fit_not_converged
         solution%reason = 'the search for the least sum of squares has no end'
         if (course%minima%status(1) == squares_stuck) solution%reason = 'the least sum of squares lies at a kink'
         if (solution%points_beyond_fold > 0) solution%reason = solution%reason// &
            & ', where a point meets the fold: give errors of the load'
      else if (.not. course%minima%is_complete) then
         solution%status = fit_not_converged
         solution%reason = 'the search has not seen every place that the fold can have among the points'
      else if (.not. is_identifiable) then
         solution%status = fit_not_identifiable
         solution%reason = 'the data do not see a combination of the free variables'
      end if
      call take_residuals(course, fit, solution)
      if (.not. is_identifiable) return
      solution%covariance_scaled = course%scales%unknown_unit > 0
      if (solution%covariance_scaled) covariance = covariance*course%variance
      course%covariance = covariance
      do k = 1, size(v)
         solution%covariance(:, k) = covariance(:, k)*slopes*slopes(k)
         solution%covariance_internal(:, k) = covariance(:, k)*course%scales%unit*course%scales%unit(k)
         solution%error_internal(k) = sqrt(covariance(k, k))*course%scales%unit(k)
         if (solution%at_bound(k) == 0) solution%error(k) = sqrt(covariance(k, k))*slopes(k)
      end do
      do k = 1, size(v)
         solution%correlation(:, k) = solution%covariance_internal(:, k)/(solution%error_internal*solution%error_internal(k))
      end do
      if (allocated(fit%derived)) then
         call find_derived(course%objective, fit%derived, covariance, solution)
      else
         call find_derived(course%objective, '', covariance, solution)
      end if
   end subroutine finish_estimate

   !> S, its probability, and the criteria of choice.
   subroutine finish_goodness(course, solution)
      type(course_t), intent(in) :: course
      type(solution_t), intent(inout) :: solution
      real(dp), parameter :: two_pi = 2*acos(-1.0_dp)
      integer :: p

      p = course%objective%n_free
      solution%chi2 = course%minima%cost(1)*course%unit2
      solution%evaluations = course%objective%evaluations
      solution%points_beyond_fold = course%objective%n_beyond()
      associate (n => course%n_terms)
         if (course%scales%unknown_unit > 0) then
            solution%sigma_estimate = sqrt(course%variance*course%unit2)
            solution%aic = n*log(two_pi*max(solution%chi2, tiny(1.0_dp))/n) + n + 2*(p + 1)
            solution%bic = solution%aic + (p + 1)*(log(real(n, dp)) - 2)
         else
            solution%aic = solution%chi2 + 2*p
            solution%bic = solution%chi2 + p*log(real(n, dp))
            if (.not. course%objective%is_robust()) solution%p_value = chi_squared_above(solution%chi2, course%freedom)
         end if
      end associate
   end subroutine finish_goodness

   !> Residuals of the best minimum, which has just been evaluated, what they say, and how far the theory holds.
   subroutine take_residuals(course, fit, solution)
      type(course_t), intent(in) :: course
      type(fit_t), intent(in) :: fit
      type(solution_t), intent(inout) :: solution
      real(dp) :: sigma
      integer :: k

      sigma = sqrt(course%variance)
      do k = 1, size(solution%data_sets)
         solution%data_sets(k)%points_used = 0
         if (allocated(solution%data_sets(k)%is_apart)) solution%data_sets(k)%is_apart = .false.
      end do
      do k = 1, size(course%objective%spheres)
         call take_curve(course%objective%spheres(k), sigma, solution)
      end do
      do k = 1, size(course%objective%others)
         call take_curve(course%objective%others(k), sigma, solution)
      end do
      call look_at_residuals(fit, solution)
      if (solution%status == fit_solved) call measure_fit(course%objective, fit%model, solution%measures)
   end subroutine take_residuals

end module adfric_fit_estimate
