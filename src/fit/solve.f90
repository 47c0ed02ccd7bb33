! SPDX-License-Identifier: GPL-3.0-or-later
!> The fit of measured curves: all minima, the statistics of the best one, intervals, and other theories.
module adfric_fit_solve
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_unset, only: unset
   use adfric_fit_base_line, only: mark_base_lines
   use adfric_fit_base_line_choice, only: settle_base_lines
   use adfric_fit_bootstrap, only: take_bootstrap
   use adfric_fit_course, only: course_t, begin_course, take_minima, evaluate_best
   use adfric_fit_doubt, only: measure_fit
   use adfric_fit_drawn_curves, only: draw_curves
   use adfric_fit_estimate, only: solve_best, finish_estimate
   use adfric_fit_intervals, only: take_covariance_intervals, take_profile
   use adfric_fit_minima, only: add_search, sort_minima
   use adfric_fit_objective, only: take_estimate
   use adfric_fit_problem, only: fit_t, intervals_covariance, intervals_profile, intervals_bootstrap
   use adfric_fit_scales, only: find_refusal
   use adfric_fit_solution, only: solution_t, fit_solved, fit_not_identifiable
   use adfric_fit_starts, only: get_start, lambda_free
   use adfric_fit_theories, only: make_theory, theory_name
   use adfric_describe_doubt, only: not_measured
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
      type(solution_t), intent(out) :: solution
      type(course_t) :: course
      type(fit_t) :: marked

      marked = fit
      call mark_base_lines(marked)
      call solve_best(marked, course, solution)
      call settle_base_lines(fit, marked, course, solution)
      call finish_marked(marked, course, solution)
      call keep_marks(fit, marked, solution)
   end subroutine solve_fit

   !> Keep which points have been found to be in contact.
   subroutine keep_marks(fit, marked, solution)
      type(fit_t), intent(in) :: fit, marked
      type(solution_t), intent(inout) :: solution
      integer :: k

      do k = 1, size(fit%data_sets)
         if (.not. allocated(fit%data_sets(k)%is_contact) .and. allocated(marked%data_sets(k)%is_contact)) &
            & solution%data_sets(k)%is_contact = marked%data_sets(k)%is_contact
      end do
   end subroutine keep_marks

   !> Curves, intervals and other theories, with the points of base lines known.
   subroutine finish_marked(fit, course, solution)
      type(fit_t), intent(in) :: fit
      type(course_t), intent(inout) :: course
      type(solution_t), intent(inout) :: solution

      if (solution%status /= fit_solved) return
      if (fit%wants_curves) call draw_curves(fit, course%scales, course%minima%q(:, :min(2, size(solution%minima_chi2))), &
         & course%covariance, course%limits%freedom, solution)
      call take_intervals(course, fit, solution)
      if (allocated(fit%theories)) call compare_theories(fit, solution)
      solution%evaluations = course%objective%evaluations
   end subroutine finish_marked

   !> Fit the same data by other theories.
   subroutine compare_theories(fit, solution)
      type(fit_t), intent(in) :: fit
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
      type(course_t), intent(inout) :: course
      type(fit_t), intent(in) :: fit
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
         call take_bootstrap(course%searched_t, fit, course%minima%q(:, :n), sqrt(course%variance), solution)
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
            call take_profile(course%searched_t, k, course%minima%q(:, :n), course%minima%cost(:n), others, course%variance, &
               & fit%levels, k == lambda_free(fit), solution, below, is_below)
            if (is_below) exit
         end do
         if (.not. is_below) return
         call add_search(course%searched_t, below, course%minima)
         call sort_minima(course%minima, size(fit%frees))
         call take_minima(course, solution)
         call finish_estimate(course, fit, solution)
         if (solution%status /= fit_solved) return
      end do
   end subroutine take_intervals

   !> Where the search would begin, from the user's values or the data, and S there.
   subroutine find_start(fit, start, chi2, measures, reason)
      !> The fit.
      type(fit_t), intent(in) :: fit
      !> Receives values of the free variables in their units; shape `(n_free)`. NaN if the fit is refused.
      real(dp), allocatable, intent(out) :: start(:)
      !> Receives S; NaN where the model has no value.
      real(dp), intent(out) :: chi2
      !> Receives what the bounds of the theory are compared with, as a solution has it; shape `(n_doubts)`.
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
