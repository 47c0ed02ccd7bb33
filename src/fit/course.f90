! SPDX-License-Identifier: GPL-3.0-or-later
!> A fit that goes on: what its parts share, from the data to the minima.
module adfric_fit_course
   use adfric_base_kinds, only: dp
   use adfric_fit_fold_search, only: searched_t, find_minimum
   use adfric_fit_minima, only: minima_t, sort_minima, minima_limit
   use adfric_fit_objective, only: new_objective, take_estimate, most_rows_of, count_terms
   use adfric_fit_problem, only: fit_t, nuisance_load_offset, nuisance_friction_offset
   use adfric_fit_scales, only: set_scales
   use adfric_fit_solution, only: solution_t
   use adfric_numerics_bounded_least_squares, only: squares_limits_t, squares_outcome_t, new_squares_work, squares_no_value
   implicit none (type, external)
   private
   public :: course_t, begin_course, has_too_few_points, refine_minima, take_minima, evaluate_best

   !> Steps in standard errors that end a search with derivatives by steps forward, and what counts as a combination of columns then.
   real(dp), parameter :: forward_step = 1.0e-4_dp, forward_rank = 1.0e-5_dp, central_step = 1.0e-6_dp, central_rank = 1.0e-7_dp
   !> The same where an ordinate has bends everywhere, such as an area on cells: its sum has many least positions side by side,
   !> within a part of the standard error. A search ends at ten times this step where nothing lowers the sum.
   real(dp), parameter :: step_at_bends = 0.03_dp
   !> The same for the best minimum with exact derivatives.
   real(dp), parameter :: last_step = 1.0e-9_dp

   !> A fit that goes on: what its parts share.
   type, extends(searched_t) :: course_t
      !> All minima.
      type(minima_t) :: minima
      !> Covariance of the numbers that are fitted.
      real(dp), allocatable :: covariance(:, :)
      !> Has an ordinate bends everywhere?
      logical :: has_bends = .false.
      !> Points; points, events and priors; degrees of freedom.
      integer :: n_points = 0, n_terms = 0, freedom = 0
      !> Square of the unit of the residuals: that of the ordinates where sigma is not known, else 1; and variance of a point in it.
      real(dp) :: unit2 = 1, variance = 1
   end type course_t

contains

   !> Make the sum of squares and space for searches.
   subroutine begin_course(course, fit)
      type(course_t), intent(inout) :: course
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
      course%has_bends = has_bends(fit)
      if (.not. course%has_bends) return
      course%limits%step_tolerance = step_at_bends
      course%limits%same_distance = 10*step_at_bends
   end subroutine begin_course

   !> Has an ordinate bends everywhere, so that a minimum is known to its standard error alone?
   pure logical function has_bends(fit)
      type(fit_t), intent(in) :: fit
      integer :: k

      has_bends = .false.
      do k = 1, size(fit%data_sets)
         has_bends = has_bends .or. fit%model%results(fit%data_sets(k)%ordinate)%has_bends
      end do
   end function has_bends

   !> Are there fewer points, events and priors than free variables, or fewer in contact than those that need contact?
   pure logical function has_too_few_points(course, fit)
      type(course_t), intent(in) :: course
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

   !> the best one, for in a flat valley a millionth of a standard error of ln lambda moves the covariance by a ten-thousandth.
   subroutine refine_minima(course)
      type(course_t), intent(inout) :: course
      type(squares_limits_t) :: limits
      type(squares_outcome_t) :: outcome
      real(dp) :: least
      integer :: k
      logical :: is_fixed(course%objective%n_free), is_unfolded

      if (course%minima%n < 1) return
      least = course%minima%cost(1)
      limits = course%limits
      course%objective%is_exact = .true.
      is_fixed = .false.
      do k = 1, course%minima%n
         limits%step_tolerance = last_step
         if (size(course%objective%others) > 0) then
            limits%step_tolerance = central_step
            limits%rank_tolerance = central_rank
            if (course%has_bends) limits%step_tolerance = step_at_bends
            if (course%minima%cost(k) > least + minima_limit*max(1.0_dp, least/max(course%freedom, 1))) exit
         else if (k > 1) then
            exit
         end if
         call find_minimum(course%searched_t, is_fixed, course%minima%q(:, k), outcome, is_unfolded, limits)
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
      type(course_t), intent(inout) :: course
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

   !> Let the sum of squares hold the curves of the best minimum.
   subroutine evaluate_best(course)
      type(course_t), intent(inout) :: course
      real(dp) :: cost
      logical :: is_valid

      associate (work => course%work)
         call course%objective%evaluate(course%minima%q(:, 1), work%n_rows, work%r, work%j, cost, is_valid)
      end associate
   end subroutine evaluate_best

end module adfric_fit_course
