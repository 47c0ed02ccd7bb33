! SPDX-License-Identifier: GPL-3.0-or-later
!> A search for a minimum of S that gets past its kinks.
!>
!> S is smooth but where a point of contact reaches the fold of its curve (`adfric_fit_fold_region`). A search that
!> ends at a minimum of a smooth S is done. Any other one goes on in the region where it has come to an end. Where
!> that search ends at a point that the fold reaches, it goes on in the region on the other side. A position where the
!> searches on both sides end is a minimum at the kink; all other ways lower S, so that none is gone twice.
module adfric_fit_fold_search
   use adfric_base_kinds, only: dp
   use adfric_fit_fold, only: curve_fold_t, choose_fold, find_fold
   use adfric_fit_fold_region, only: region_t, new_region, enter_region, leave_region
   use adfric_fit_objective, only: objective_t
   use adfric_fit_scales, only: scales_t
   use adfric_numerics_bounded_least_squares, only: squares_work_t, squares_limits_t, squares_outcome_t, find_least_squares, &
      & squares_converged, squares_no_value
   implicit none (type, external)
   private
   public :: searched_t, find_minimum, cross_regions

   !> What all searches of a fit share.
   type :: searched_t
      !> Units and bounds.
      type(scales_t) :: scales
      !> The sum of squares.
      type(objective_t) :: objective
      !> When a search ends.
      type(squares_limits_t) :: limits
      !> Workspace.
      type(squares_work_t) :: work
   end type searched_t

   !> A decrease of S by less than this part of it is none.
   real(dp), parameter :: of_cost = 1.0e-9_dp

contains

   !> Search from a start. `work` has residuals and derivatives at the end, those of a region where `is_unfolded`.
   subroutine find_minimum(search, is_fixed, q, outcome, is_unfolded, limits)
      type(searched_t), intent(inout) :: search
      !> Which variables stay as they are.
      logical, intent(in) :: is_fixed(:)
      !> In: the start. Out: the position found.
      real(dp), intent(inout) :: q(:)
      type(squares_outcome_t), intent(out) :: outcome
      !> Are the derivatives at the end those with s instead of the pivot?
      logical, intent(out) :: is_unfolded
      !> When the search ends, if not as others do.
      type(squares_limits_t), intent(in), optional :: limits
      type(squares_limits_t) :: own
      type(curve_fold_t) :: fold

      is_unfolded = .false.
      own = search%limits
      if (present(limits)) own = limits
      call find_least_squares(search%objective, search%scales%lower, search%scales%upper, is_fixed, own, search%work, q, outcome)
      if (any(outcome%status == [squares_converged, squares_no_value])) return
      call choose_fold(search%objective, q, is_fixed, fold)
      if (fold%curve == 0) return
      call cross_regions(search, fold, is_fixed, q, outcome, is_unfolded, own)
   end subroutine find_minimum

   !> Search from region to region.
   subroutine cross_regions(search, fold, is_fixed, q, outcome, is_unfolded, limits)
      type(searched_t), intent(inout), target :: search
      type(curve_fold_t), intent(in) :: fold
      logical, intent(in) :: is_fixed(:)
      real(dp), intent(inout) :: q(:)
      !> In: what has been found before. Out: with what has been done here.
      type(squares_outcome_t), intent(inout) :: outcome
      !> Has a search in a region been made?
      logical, intent(out) :: is_unfolded
      !> When searches end.
      type(squares_limits_t), intent(in) :: limits
      type(region_t) :: region
      type(squares_outcome_t) :: one
      real(dp) :: at, u(size(q)), last
      integer :: k, n, move, side, kink, from
      logical :: is_there

      is_unfolded = .false.
      call new_region(region, search%objective, fold, search%scales%lower, search%scales%upper, is_fixed, q, is_there)
      if (.not. is_there) return
      n = size(fold%x)
      call find_fold(search%objective, q, fold, at, is_there)
      if (.not. is_there) return
      k = min(count(fold%x <= at), n - 1)
      from = -1
      side = -1
      last = huge(last)
      do move = 1, 4*n
         call enter_region(region, k, q, u, is_there)
         if (is_there) then
            call find_least_squares(region, region%lower, region%upper, is_fixed, limits, search%work, u, one)
            outcome%steps = outcome%steps + one%steps
            outcome%evaluations = outcome%evaluations + one%evaluations
            if (one%status == squares_no_value) return
            is_unfolded = .true.
            call leave_region(region, u, q, is_there)
            outcome%cost = one%cost
            outcome%status = one%status
            side = 0
            if (u(region%pivot) <= region%lower(region%pivot)) side = 1
            if (u(region%pivot) >= region%upper(region%pivot)) side = -1
            if (side == 0) return
            kink = merge(k + 1, k, side > 0)
            if (kink == from .and. last - one%cost <= of_cost*last) return
            from = kink
            last = one%cost
         end if
         if (k + side < 0 .or. k + side > n - 1) return
         k = k + side
      end do
   end subroutine cross_regions

end module adfric_fit_fold_search
