! SPDX-License-Identifier: GPL-3.0-or-later
!> The fit of measured curves: all minima, the statistics of the best one, intervals, and other theories.
module adfric_fit_solve
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_fit_bootstrap, only: take_bootstrap
   use adfric_fit_covariance, only: find_covariance
   use adfric_fit_derived, only: find_derived
   use adfric_fit_objective, only: objective_t, new_objective, take_estimate, most_rows_of, count_terms
   use adfric_fit_drawn_curves, only: draw_curves
   use adfric_fit_intervals, only: take_covariance_intervals, take_profile
   use adfric_fit_problem, only: fit_t, intervals_covariance, intervals_profile, intervals_bootstrap, nuisance_load_offset, &
      & nuisance_friction_offset
   use adfric_fit_residuals, only: look_at_residuals, take_curve
   use adfric_fit_scales, only: scales_t, set_scales, find_refusal
   use adfric_fit_search, only: minima_t, find_minima, add_search, sort_minima, minima_limit
   use adfric_fit_solution, only: solution_t, fit_solved, fit_too_few_points, fit_not_converged, fit_not_identifiable
   use adfric_fit_starts, only: lambda_free
   use adfric_fit_theories, only: make_theory, theory_name
   use adfric_numerics_bounded_least_squares, only: squares_work_t, squares_limits_t, squares_outcome_t, &
      & new_squares_work, find_least_squares, squares_converged, squares_stuck, squares_no_value
   use adfric_numerics_distributions, only: chi_squared_above
   implicit none (type, external)
   private
   public :: solve_fit

   !> Steps in standard errors that end a search with derivatives by steps forward, and what counts as a combination of columns then.
   real(dp), parameter :: forward_step = 1.0e-4_dp, forward_rank = 1.0e-5_dp, central_step = 1.0e-6_dp, central_rank = 1.0e-7_dp
   !> The same for the best minimum with exact derivatives.
   real(dp), parameter :: last_step = 1.0e-9_dp

   !> How often a profile may find a better minimum.
   integer, parameter :: most_restarts = 4

   !> A fit on its way: what its parts share.
   type :: course_t
      !> Units and bounds.
      type(scales_t) :: scales
      !> The sum of squares.
      type(objective_t) :: objective
      !> When a search ends.
      type(squares_limits_t) :: limits
      !> Room to work in.
      type(squares_work_t) :: work
      !> All minima.
      type(minima_t) :: minima
      !> Covariance of the numbers that are fitted.
      real(dp), allocatable :: covariance(:, :)
      !> Points; points, events and priors; degrees of freedom.
      integer :: n_points = 0, n_terms = 0, freedom = 0
      !> Square of the unit of the residuals: that of the ordinates where sigma is not known, else 1; and variance of a point in it.
      real(dp) :: unit2 = 1, variance = 1
   end type course_t

contains

   !> Find what the data say of the free variables. It changes nothing but `solution`, and threads may fit at the same time.
   subroutine solve_fit(fit, solution)
      !> What is to be fitted; it has been checked.
      type(fit_t), intent(in) :: fit
      !> Receives what is found.
      type(solution_t), intent(out) :: solution
      type(course_t) :: course

      call solve_best(fit, course, solution)
      if (solution%status /= fit_solved) return
      if (fit%wants_curves) call draw_curves(fit, course%scales, course%minima%q(:, 1), course%covariance, course%limits%freedom, &
         & solution)
      call take_intervals(course, fit, solution)
      if (allocated(fit%theories)) call compare_theories(fit, solution)
      solution%evaluations = course%objective%evaluations
   end subroutine solve_fit

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
      call find_minima(course%objective, fit, course%scales, course%limits, course%work, course%minima)
      call refine_minima(course)
      if (course%minima%n < 1) then
         solution%reason = 'the model has no value at any start'
         return
      end if
      call take_minima(course, solution)
      call finish_estimate(course, fit, solution)
   end subroutine solve_best

   !> Are there fewer points, events and priors than free variables, or fewer in contact than those that need contact?
   pure logical function has_too_few_points(course, fit)
      !> What the parts share.
      type(course_t), intent(in) :: course
      !> The fit.
      type(fit_t), intent(in) :: fit
      integer :: k, n_contact, n_free

      n_contact = course%n_terms - course%n_points
      do k = 1, size(course%objective%spheres)
         n_contact = n_contact + count(course%objective%spheres(k)%is_contact)
      end do
      do k = 1, size(course%objective%others)
         n_contact = n_contact + count(course%objective%others(k)%is_contact)
      end do
      n_free = count(fit%frees%nuisance /= nuisance_load_offset .and. fit%frees%nuisance /= nuisance_friction_offset)
      has_too_few_points = course%freedom < 0 .or. course%n_points < 1 .or. n_contact < n_free &
         & .or. (course%freedom < 1 .and. course%scales%unknown_unit > 0)
   end function has_too_few_points

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

   !> Let the sum of squares hold the curves of the best minimum.
   subroutine evaluate_best(course)
      !> What the parts share.
      type(course_t), intent(inout) :: course
      real(dp) :: cost
      logical :: is_valid

      associate (work => course%work)
         call course%objective%evaluate(course%minima%q(:, 1), work%n_rows, work%r, work%j, cost, is_valid)
      end associate
   end subroutine evaluate_best

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

   !> Make the sum of squares and room for searches.
   subroutine begin_course(course, fit)
      !> Receives what the parts share.
      type(course_t), intent(inout) :: course
      !> The fit.
      type(fit_t), intent(in) :: fit

      call set_scales(course%scales, fit)
      associate (scales => course%scales)
         call new_objective(course%objective, fit, scales%unit, scales%lower, scales%upper, scales%unknown_unit)
      end associate
      call count_terms(course%objective, course%n_points, course%n_terms)
      course%freedom = course%n_terms - size(fit%frees)
      call new_squares_work(course%work, most_rows_of(course%objective), size(fit%frees))
      course%limits%relative_tolerance = fit%relative_tolerance
      if (course%scales%unknown_unit > 0) then
         course%limits%freedom = max(course%freedom, 1)
         course%unit2 = course%scales%unknown_unit**2
      end if
      if (size(course%objective%others) == 0) return
      course%limits%step_tolerance = forward_step
      course%limits%rank_tolerance = forward_rank
   end subroutine begin_course

   !> Search on from the minima that count: with central differences where derivatives were steps forward, and to the last digits from
   !> the best one, for in a flat valley a millionth of a standard error of ln lambda moves the covariance by a ten-thousandth.
   subroutine refine_minima(course)
      !> What the parts share.
      type(course_t), intent(inout) :: course
      type(squares_limits_t) :: limits
      type(squares_outcome_t) :: outcome
      real(dp) :: least
      integer :: k
      logical :: is_held(course%objective%n_free)

      if (course%minima%n < 1) return
      least = course%minima%cost(1)
      limits = course%limits
      course%objective%is_exact = .true.
      is_held = .false.
      do k = 1, course%minima%n
         limits%step_tolerance = last_step
         if (size(course%objective%others) > 0) then
            limits%step_tolerance = central_step
            limits%rank_tolerance = central_rank
            if (course%minima%cost(k) > least + minima_limit*max(1.0_dp, least/max(course%freedom, 1))) exit
         else if (k > 1) then
            exit
         end if
         call find_least_squares(course%objective, course%scales%lower, course%scales%upper, is_held, limits, course%work, &
            & course%minima%q(:, k), outcome)
         if (outcome%status == squares_no_value) cycle
         course%minima%steps = course%minima%steps + outcome%steps
         course%minima%cost(k) = outcome%cost
         course%minima%status(k) = min(course%minima%status(k), outcome%status)
      end do
      course%objective%is_exact = .false.
      call sort_minima(course%minima, course%objective%n_free)
   end subroutine refine_minima

   !> Put the minima that count into the solution.
   subroutine take_minima(course, solution)
      !> What the parts share.
      type(course_t), intent(inout) :: course
      !> Receives the minima.
      type(solution_t), intent(inout) :: solution
      real(dp), allocatable :: slopes(:)
      integer :: k, n, n_free

      n_free = course%objective%n_free
      if (course%limits%freedom > 0) course%variance = course%minima%cost(1)/course%limits%freedom
      if (.not. course%variance > 0) course%variance = tiny(1.0_dp)
      n = count(course%minima%cost(:course%minima%n) - course%minima%cost(1) < minima_limit*course%variance)
      n = max(n, 1)
      if (allocated(solution%minima)) deallocate (solution%minima, solution%minima_chi2, solution%minima_at_bound)
      allocate (solution%minima(n_free, n), solution%minima_chi2(n), slopes(n_free))
      allocate (solution%minima_at_bound(n_free, n), source=0)
      do k = 1, n
         call take_estimate(course%objective, course%minima%q(:, k), solution%minima(:, k), slopes)
         solution%minima_at_bound(:, k) = merge(1, 0, course%minima%q(:, k) >= course%scales%upper) &
            & - merge(1, 0, course%minima%q(:, k) <= course%scales%lower)
      end do
      solution%minima_chi2 = course%minima%cost(:n)*course%unit2
      solution%starts = course%minima%searches
      solution%starts_at_best = course%minima%times(1)
      solution%iterations = course%minima%steps
   end subroutine take_minima

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
         if (solution%points_beyond_fold > 0) solution%reason = solution%reason//', &
            & where a point meets the fold: give errors of the load'
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

   !> Residuals of the best minimum, which has just been evaluated, and what they say.
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
   end subroutine take_residuals

end module adfric_fit_solve
