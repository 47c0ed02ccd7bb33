! SPDX-License-Identifier: GPL-3.0-or-later
!> Every position that the fold of a curve can have among its points.
!>
!> Where the best minimum lies within some standard errors of a point that reaches the fold, another region
!> (`adfric_fit_fold_region`) may have a lesser S. The regions are as many as the points, but few can. With k points
!> beyond the fold all of these have one ordinate, and leave V_k at least, the spread of their ordinates, which rises
!> with k. The others leave S_k at least, what the fit without those k points leaves. So region k has no lesser S
!> where V_k > S - S_k. S - S_k is found by leaving out one point after the other, with the derivatives at the best
!> minimum: without point i, with residual r and row J_i, S falls by r^2/(1 - h), h = J_i C J_i', and the covariance
!> C rises by C J_i' J_i C/(1 - h). Since this is exact for a linear model only, twice that difference is asked for,
!> and the limit of minima besides. From every other region a search goes on in all variables: a few steps tell how
!> far its S falls.
module adfric_fit_fold_survey
   use adfric_base_kinds, only: dp
   use adfric_fit_covariance, only: find_covariance
   use adfric_fit_fold, only: curve_fold_t, new_curve_fold, find_fold, last_slopes, spread_below
   use adfric_fit_fold_region, only: region_t, new_region, enter_region, leave_region
   use adfric_fit_fold_search, only: searched_t
   use adfric_fit_minima, only: minima_t, add_search, minima_limit
   use adfric_numerics_bounded_least_squares, only: squares_limits_t, squares_outcome_t, find_least_squares, squares_converged, &
      & squares_not_converged, squares_no_value
   implicit none (type, external)
   private
   public :: survey_folds

   !> A fold so many standard errors away from the nearest point is far from it.
   real(dp), parameter :: far = 7.0_dp
   !> How much more than a linear model says may be gained by leaving out points.
   real(dp), parameter :: of_drop = 2.0_dp
   !> The few steps that tell how far S falls.
   real(dp), parameter :: coarse_step = 0.03_dp, coarse_decrease = 1.0e-4_dp
   integer, parameter :: coarse_steps = 20

contains

   !> Search from every region of every fold that can have a lesser S.
   subroutine survey_folds(search, minima)
      type(searched_t), intent(inout) :: search
      !> The minima; those found are added, and whether all positions of a fold have been seen.
      type(minima_t), intent(inout) :: minima
      type(curve_fold_t) :: fold
      real(dp) :: best(search%objective%n_free), unused
      real(dp), allocatable :: drop(:)
      logical :: is_fixed(search%objective%n_free), is_far
      integer :: k, at

      is_fixed = .false.
      do k = 1, size(search%objective%number)
         if (minima%n < 1) return
         at = minloc(minima%cost(:minima%n), 1)
         best = minima%q(:, at)
         call new_curve_fold(search%objective, best, is_fixed, k, fold, unused)
         if (fold%curve == 0) cycle
         allocate (drop(size(fold%x)))
         call look_at_best(search, fold, best, minima%cost(at), is_far, drop)
         if (.not. is_far .or. minima%status(at) /= squares_converged) &
            & call survey_fold(search, fold, best, drop, minima%status(at) == squares_converged, minima)
         deallocate (drop)
      end do
   end subroutine survey_folds

   !> Search from every region of one fold that can have a lesser S.
   subroutine survey_fold(search, fold, best, drop, is_converged, minima)
      type(searched_t), intent(inout), target :: search
      type(curve_fold_t), intent(in) :: fold
      !> The best minimum, and how much less S is without the first 1, 2, ... points.
      real(dp), intent(in) :: best(:), drop(:)
      !> Is the best one a minimum, so that its region has been searched?
      logical, intent(in) :: is_converged
      !> The minima; those found are added.
      type(minima_t), intent(inout) :: minima
      type(region_t) :: region
      type(squares_limits_t) :: coarse
      type(squares_outcome_t) :: outcome
      real(dp) :: q(size(best)), u(size(best)), least(size(drop)), variance, at, least_so_far
      logical :: is_fixed(size(best)), is_there, is_wanted
      integer :: k, own, ends_above

      is_fixed = .false.
      call new_region(region, search%objective, fold, search%scales%lower, search%scales%upper, is_fixed, best, is_there)
      if (.not. is_there) return
      call spread_below(fold, least)
      coarse = search%limits
      coarse%step_tolerance = max(coarse_step, search%limits%step_tolerance)
      coarse%relative_tolerance = max(coarse_decrease, search%limits%relative_tolerance)
      coarse%most_steps = coarse_steps
      variance = 1
      if (search%limits%freedom > 0) variance = minval(minima%cost(:minima%n))/search%limits%freedom
      own = -1
      ends_above = -1
      call find_fold(search%objective, best, fold, at, is_there)
      if (is_there .and. is_converged) own = count(fold%x <= at)
      do k = 0, size(fold%x) - 1
         if (k == own) cycle
         if (k > 0) then
            if (least(max(k, 1)) >= min(minval(minima%cost(:minima%n)), of_drop*drop(max(k, 1)) + minima_limit*variance)) return
         end if
         call enter_region(region, k, best, u, is_there)
         if (.not. is_there) cycle
         call find_least_squares(region, region%lower, region%upper, is_fixed, coarse, search%work, u, outcome)
         minima%steps = minima%steps + outcome%steps
         if (outcome%status == squares_no_value) then
            minima%is_complete = minima%is_complete .and. region%is_outside
            cycle
         end if
         associate (s => u(region%pivot), low => region%lower(region%pivot), high => region%upper(region%pivot))
            ! a way out of the region belongs to the neighbour, but where the way out of the neighbour leads here
            is_wanted = s > low .and. s < high .or. s >= high .and. ends_above == k
            ends_above = merge(k + 1, -1, s <= low)
         end associate
         least_so_far = minval(minima%cost(:minima%n))
         is_wanted = is_wanted .and. (outcome%cost <= least_so_far + minima_limit*variance .or. &
            & outcome%status == squares_not_converged) .or. outcome%cost < least_so_far
         if (.not. is_wanted) cycle
         call leave_region(region, u, q, is_there)
         if (is_there) call add_search(search, q, minima, fold)
      end do
   end subroutine survey_fold

   !> Is the fold of the best minimum far below all points, and how much is S less without the first 1, 2, ... points?
   subroutine look_at_best(search, fold, q, cost, is_far, drop)
      type(searched_t), intent(inout) :: search
      type(curve_fold_t), intent(in) :: fold
      !> The minimum, and S there.
      real(dp), intent(in) :: q(:), cost
      logical, intent(out) :: is_far
      !> Receives the differences; shape `(size(fold%x))`.
      real(dp), intent(out) :: drop(:)
      real(dp) :: covariance(size(q), size(q)), null_vector(size(q)), at, by_free(size(q)), variance, leverage, r, &
         & total, shift(size(q)), row(size(q)), change(size(q))
      logical :: is_identifiable, is_valid, is_known
      integer :: i, k

      is_far = .false.
      drop = cost
      call find_covariance(search%objective, q, search%work, covariance, null_vector, is_identifiable, is_valid)
      if (.not. is_identifiable) return
      variance = 1
      if (search%limits%freedom > 0) variance = cost/search%limits%freedom
      by_free = last_slopes(search%objective, fold)
      call find_fold(search%objective, q, fold, at, is_known)
      if (.not. is_known) return
      is_far = fold%x(1) - at > far*sqrt(variance*dot_product(by_free, matmul(covariance, by_free)))
      shift = 0
      total = 0
      do k = 1, size(fold%x)
         i = search%objective%rows_before(fold%curve) + fold%row(k)
         row = search%work%j(i, :)
         r = search%work%r(i) + dot_product(row, shift)
         change = matmul(covariance, row)
         leverage = dot_product(row, change)
         if (.not. leverage < 1) exit
         total = total + r**2/(1 - leverage)
         drop(k) = total
         ! without this point the best position moves by that
         shift = shift + change*r/(1 - leverage)
         covariance = covariance + spread(change, 2, size(q))*spread(change, 1, size(q))/(1 - leverage)
      end do
   end subroutine look_at_best

end module adfric_fit_fold_survey
