! SPDX-License-Identifier: GPL-3.0-or-later
!> Every place that the fold of a curve can have among its points.
!>
!> Where the best minimum lies within many standard errors of a point that reaches the fold, another region (`adfric_fit_fold_region`) may
!> have a lesser S. The regions are as many as the points, but few can: with k points beyond the fold, all of these have one ordinate,
!> and S is no less than what that leaves (`spread_below`). From each other region a search goes on, in all variables.
module adfric_fit_fold_survey
   use adfric_base_kinds, only: dp
   use adfric_fit_covariance, only: find_covariance
   use adfric_fit_fold, only: curve_fold_t, choose_fold, find_fold, fold_slopes, spread_below
   use adfric_fit_fold_region, only: region_t, new_region, enter_region, leave_region
   use adfric_fit_minima, only: minima_t, add_search
   use adfric_fit_objective, only: objective_t
   use adfric_fit_scales, only: scales_t
   use adfric_numerics_bounded_least_squares, only: squares_work_t, squares_limits_t, squares_converged
   implicit none (type, external)
   private
   public :: survey_folds

   !> A fold so many standard errors away from the nearest point is far from it.
   real(dp), parameter :: far = 10.0_dp

contains

   !> Search from every region of the fold that can have a lesser S.
   subroutine survey_folds(self, scales, limits, work, minima)
      !> The sum of squares.
      type(objective_t), intent(inout), target :: self
      !> Units and bounds.
      type(scales_t), intent(in) :: scales
      !> When a search ends.
      type(squares_limits_t), intent(in) :: limits
      !> Room to work in.
      type(squares_work_t), intent(inout) :: work
      !> The minima; those found are added.
      type(minima_t), intent(inout) :: minima
      type(curve_fold_t) :: fold
      type(region_t) :: region
      real(dp) :: best(self%n_free), q(self%n_free), u(self%n_free)
      real(dp), allocatable :: least(:)
      logical :: is_held(self%n_free), is_there
      integer :: k

      if (minima%n < 1) return
      k = minloc(minima%cost(:minima%n), 1)
      best = minima%q(:, k)
      is_held = .false.
      call choose_fold(self, best, is_held, fold)
      if (fold%data_set == 0) return
      if (minima%status(k) == squares_converged) then
         if (is_far(self, fold, best, minima%cost(k), limits, work)) return
      end if
      call new_region(region, self, fold, scales%lower, scales%upper, is_held, best, is_there)
      if (.not. is_there) return
      allocate (least(size(fold%x)))
      call spread_below(fold, least)
      do k = 0, size(fold%x) - 1
         if (k > 0) then
            if (least(k) >= minval(minima%cost(:minima%n))) return
         end if
         call enter_region(region, k, best, u, is_there)
         if (.not. is_there) cycle
         call leave_region(region, u, q, is_there)
         if (is_there) call add_search(self, scales, limits, work, q, minima, fold)
      end do
   end subroutine survey_folds

   !> Is the fold of a minimum far below all points?
   logical function is_far(self, fold, q, cost, limits, work)
      !> The sum of squares.
      type(objective_t), intent(inout) :: self
      !> The curve.
      type(curve_fold_t), intent(in) :: fold
      !> The minimum, and S there.
      real(dp), intent(in) :: q(:), cost
      !> When a search ends.
      type(squares_limits_t), intent(in) :: limits
      !> Room to work in.
      type(squares_work_t), intent(inout) :: work
      real(dp) :: covariance(size(q), size(q)), null_vector(size(q)), at, by_free(size(q)), variance
      logical :: is_identifiable, is_valid, is_known

      is_far = .true.
      call find_covariance(self, q, work, covariance, null_vector, is_identifiable, is_valid)
      if (.not. is_identifiable) return
      call find_fold(self, q, fold, at, is_known)
      if (.not. is_known) return
      by_free = fold_slopes(self, q, fold)
      variance = 1
      if (limits%freedom > 0) variance = cost/limits%freedom
      is_far = fold%x(1) - at > far*sqrt(variance*dot_product(by_free, matmul(covariance, by_free)))
   end function is_far

end module adfric_fit_fold_survey
