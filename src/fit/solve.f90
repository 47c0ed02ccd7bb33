! SPDX-License-Identifier: GPL-3.0-or-later
!> The fit of measured curves: all minima, the statistics of the best one, intervals, and other theories.
module adfric_fit_solve
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_unset, only: unset
   use adfric_fit_base_line, only: mark_base_lines
   use adfric_fit_bootstrap, only: take_bootstrap
   use adfric_fit_course, only: course_t, begin_course, has_too_few_points, refine_minima, take_minima, evaluate_best
   use adfric_fit_covariance, only: find_covariance
   use adfric_fit_derived, only: find_derived
   use adfric_fit_doubt, only: measure_fit
   use adfric_fit_drawn_curves, only: draw_curves
   use adfric_fit_intervals, only: take_covariance_intervals, take_profile
   use adfric_fit_minima, only: add_search, sort_minima
   use adfric_fit_objective, only: take_estimate
   use adfric_fit_problem, only: fit_t, intervals_covariance, intervals_profile, intervals_bootstrap
   use adfric_fit_residuals, only: look_at_residuals, take_curve
   use adfric_fit_scales, only: find_refusal
   use adfric_fit_solution, only: solution_t, fit_solved, fit_too_few_points, fit_not_converged, fit_not_identifiable
   use adfric_fit_starts, only: get_start, lambda_free
   use adfric_fit_theories, only: make_theory, theory_name
   use adfric_fit_thinning, only: search_minima
   use adfric_model_doubt, only: not_measured
   use adfric_numerics_bounded_least_squares, only: squares_converged, squares_stuck
   use adfric_numerics_distributions, only: chi_squared_above
   implicit none (type, external)
   private
   public :: solve_fit, find_start

   !> How often a profile may find a better minimum.
   integer, parameter :: most_restarts = 4

contains

   !> Find what the data say of the free variables. It changes nothing but `solution`, and threads may fit at the same time.
   subroutine solve_fit(fit, solution)
      !> What is to be fitted; it has been checked.
      type(fit_t), intent(in) :: fit
      !> Receives what is found.
      type(solution_t), intent(out) :: solution
      type(course_t) :: course
      type(fit_t) :: marked

      marked = fit
      call mark_base_lines(marked)
      call solve_marked(marked, course, solution)
      call keep_marks(fit, marked, solution)
   end subroutine solve_fit

   !> Keep which points have been found to be in contact.
   subroutine keep_marks(fit, marked, solution)
      !> The fit as it was given.
      type(fit_t), intent(in) :: fit
      !> The fit with its base lines.
      type(fit_t), intent(in) :: marked
      !> Receives the marks.
      type(solution_t), intent(inout) :: solution
      integer :: k

      do k = 1, size(fit%data_sets)
         if (.not. allocated(fit%data_sets(k)%is_contact) .and. allocated(marked%data_sets(k)%is_contact)) &
            & solution%data_sets(k)%is_contact = marked%data_sets(k)%is_contact
      end do
   end subroutine keep_marks

   !> The same with the points of base lines known.
   subroutine solve_marked(fit, course, solution)
      !> What is to be fitted.
      type(fit_t), intent(in) :: fit
      !> Receives what the parts share.
      type(course_t), intent(out) :: course
      !> Receives what is found.
      type(solution_t), intent(inout) :: solution

      call solve_best(fit, course, solution)
      if (solution%status /= fit_solved) return
      if (fit%wants_curves) call draw_curves(fit, course%scales, course%minima%q(:, :min(2, size(solution%minima_chi2))), &
         & course%covariance, course%limits%freedom, solution)
      call take_intervals(course, fit, solution)
      if (allocated(fit%theories)) call compare_theories(fit, solution)
      solution%evaluations = course%objective%evaluations
   end subroutine solve_marked

   !> Estimates and their statistics, without intervals.
   subroutine solve_best(fit, course, solution)
      !> What is to be fitted.
      type(fit_t), intent(in) :: fit
      !> Receives what the parts share.
      type(course_t), intent(out) :: course
      !> Receives what is found.
      type(solution_t), intent(inout) :: solution

      call make_room(fit, solution)
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
         solution%reason = 'the model has no value at any start'
         return
      end if
      call take_minima(course, solution)
      call finish_estimate(course, fit, solution)
   end subroutine solve_best

   !> Fit the same data by other theories.
   subroutine compare_theories(fit, solution)
      !> The fit.
      type(fit_t), intent(in) :: fit
      !> Receives what they find.
      type(solution_t), intent(inout) :: solution
      type(fit_t) :: other
      type(course_t) :: course
      type(solution_t) :: found
      integer, allocatable :: kept(:)
      logical :: is_possible
      real(dp) :: none
      integer :: k

      none = not_a_number()
      if (allocated(solution%theories)) deallocate (solution%theories)
      allocate (solution%theories(size(fit%theories)))
      do k = 1, size(fit%theories)
         associate (theory => solution%theories(k))
            theory%chi2 = none
            theory%aic = none
            theory%bic = none
            allocate (theory%estimate(size(fit%frees)), source=none)
            call theory_name(fit, fit%theories(k), theory%name)
            call make_theory(fit, fit%theories(k), other, kept, is_possible)
            if (.not. is_possible) cycle
            found = solution_t()
            call solve_best(other, course, found)
            if (.not. any(found%status == [fit_solved, fit_not_identifiable])) cycle
            theory%chi2 = found%chi2
            theory%aic = found%aic
            theory%bic = found%bic
            theory%estimate(kept) = found%estimate
         end associate
      end do
   end subroutine compare_theories

   !> Intervals of all variables. A profile that falls below the least S has found a better minimum: the fit is finished again with it.
   subroutine take_intervals(course, fit, solution)
      !> What the parts share.
      type(course_t), intent(inout) :: course
      !> The fit.
      type(fit_t), intent(in) :: fit
      !> Receives the intervals.
      type(solution_t), intent(inout) :: solution
      real(dp) :: below(size(fit%frees))
      real(dp), allocatable :: others(:, :)
      logical :: is_below
      integer :: i, k, n, again

      if (.not. allocated(fit%levels)) return
      if (size(fit%levels) == 0) return
      if (fit%intervals == intervals_covariance .or. (fit%intervals == intervals_profile .and. course%objective%is_robust())) then
         call take_covariance_intervals(course%minima%q(:, 1), course%scales, course%objective, fit%levels, course%limits%freedom, &
            & solution)
         return
      end if
      if (fit%intervals == intervals_bootstrap) then
         n = size(solution%minima_chi2)
         call evaluate_best(course)
         call take_bootstrap(course%objective, fit, course%scales, course%limits, course%work, course%minima%q(:, :n), &
            & sqrt(course%variance), solution)
         return
      end if
      do again = 1, most_restarts
         if (allocated(solution%profiles)) deallocate (solution%profiles)
         allocate (solution%profiles(size(fit%frees)))
         n = size(solution%minima_chi2)
         others = course%minima%q(:, :0)
         do i = 0, size(fit%frees)
            ! lambda is the first, for its profile shows valleys to the others
            k = merge(lambda_free(fit), i, i == 0)
            if (k == 0 .or. i == lambda_free(fit) .and. i > 0) cycle
            call take_profile(course%objective, course%scales, course%limits, course%work, k, course%minima%q(:, :n), &
               & course%minima%cost(:n), others, course%variance, fit%levels, k == lambda_free(fit), solution, below, is_below)
            if (is_below) exit
         end do
         if (.not. is_below) return
         call add_search(course%objective, course%scales, course%limits, course%work, below, course%minima)
         call sort_minima(course%minima, size(fit%frees))
         call take_minima(course, solution)
         call finish_estimate(course, fit, solution)
         if (solution%status /= fit_solved) return
      end do
   end subroutine take_intervals

   !> Give every part of the solution its shape.
   subroutine make_room(fit, solution)
      !> The fit.
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
   end subroutine make_room

   !> Estimates, errors, goodness.
   subroutine finish_estimate(course, fit, solution)
      !> What the parts share.
      type(course_t), intent(inout) :: course
      !> The fit.
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
      !> What the parts share.
      type(course_t), intent(in) :: course
      !> Receives them.
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
      !> What the parts share.
      type(course_t), intent(in) :: course
      !> The fit.
      type(fit_t), intent(in) :: fit
      !> Receives them.
      type(solution_t), intent(inout) :: solution
      real(dp) :: sigma
      integer :: k

      sigma = sqrt(course%variance)
      do k = 1, size(course%objective%spheres)
         call take_curve(course%objective%spheres(k), sigma, solution)
      end do
      do k = 1, size(course%objective%others)
         call take_curve(course%objective%others(k), sigma, solution)
      end do
      call look_at_residuals(fit, solution)
      if (solution%status == fit_solved) call measure_fit(course%objective, fit%model, solution%measures)
   end subroutine take_residuals

   !> Where the search would begin, from the user's values or the data, and S there.
   subroutine find_start(fit, start, chi2, measures, reason)
      !> The fit.
      type(fit_t), intent(in) :: fit
      !> Receives values of the free variables in their units; shape `(n_free)`. NaN if the fit is refused.
      real(dp), allocatable, intent(out) :: start(:)
      !> Receives S; NaN where the model has no value.
      real(dp), intent(out) :: chi2
      !> Receives what the bounds of the theory are held against, as a solution has it; shape `(n_doubts)`.
      real(dp), intent(out) :: measures(:)
      !> Receives why the fit is refused; empty if it is not.
      character(:), allocatable, intent(out) :: reason
      type(course_t) :: course
      type(fit_t) :: marked
      real(dp) :: q(size(fit%frees)), slopes(size(fit%frees)), cost
      logical :: is_valid

      allocate (start(size(fit%frees)), source=not_a_number())
      chi2 = not_a_number()
      measures = not_measured
      call find_refusal(fit, reason)
      if (len(reason) > 0) return
      marked = fit
      call mark_base_lines(marked)
      call begin_course(course, marked)
      call get_start(course%objective, marked, unset, course%work, q)
      call take_estimate(course%objective, q, start, slopes)
      associate (work => course%work)
         call course%objective%evaluate(q, work%n_rows, work%r, work%j, cost, is_valid)
      end associate
      if (.not. is_valid) return
      chi2 = cost*course%unit2
      call measure_fit(course%objective, fit%model, measures)
   end subroutine find_start

end module adfric_fit_solve
