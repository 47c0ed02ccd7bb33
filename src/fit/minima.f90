! SPDX-License-Identifier: GPL-3.0-or-later
!> The minima of a sum of squares, as searches find them one after the other.
module adfric_fit_minima
   use adfric_base_kinds, only: dp
   use adfric_fit_fold, only: curve_fold_t
   use adfric_fit_fold_search, only: searched_t, find_minimum, cross_regions
   use adfric_numerics_bounded_least_squares, only: squares_outcome_t, squares_no_value
   implicit none (type, external)
   private
   public :: minima_t, new_minima, add_search, sort_minima, minima_limit

   !> Minima with S - S_min above this are not kept.
   real(dp), parameter :: minima_limit = 12.0_dp
   !> Most minima.
   integer, parameter :: most_minima = 40

   !> Minima found so far, in the order in which they were found, or sorted.
   type :: minima_t
      !> Number of minima.
      integer :: n = 0
      !> Numbers that are fitted; shape `(n_free, most_minima)`.
      real(dp), allocatable :: q(:, :)
      !> Least cost of each, how often it was found, and how the search ended (`squares_...`).
      real(dp), allocatable :: cost(:)
      !> How often each was found, and how its search ended.
      integer, allocatable :: times(:), status(:)
      !> Has every position of a fold been seen that may have a lesser cost?
      logical :: is_complete = .true.
      !> Searches, steps.
      integer :: searches = 0, steps = 0
   end type minima_t

contains

   !> Make an empty list.
   pure subroutine new_minima(minima, n_free)
      type(minima_t), intent(out) :: minima
      !> Number of free variables.
      integer, intent(in) :: n_free

      allocate (minima%q(n_free, most_minima), minima%cost(most_minima), source=0.0_dp)
      allocate (minima%times(most_minima), minima%status(most_minima), source=0)
   end subroutine new_minima

   !> Search from a start, and add the minimum if it is new.
   subroutine add_search(search, q, minima, fold)
      type(searched_t), intent(inout) :: search
      !> In: the start. Out: where the search ended.
      real(dp), intent(inout) :: q(:)
      type(minima_t), intent(inout) :: minima
      !> The curve to whose fold the start is near, so that the search begins in a region. If absent, it begins as if S were smooth.
      type(curve_fold_t), intent(in), optional :: fold
      type(squares_outcome_t) :: outcome
      logical :: is_fixed(size(q)), is_unfolded, is_valid
      real(dp) :: variance
      integer :: k

      is_fixed = .false.
      if (present(fold)) then
         outcome%status = squares_no_value
         call cross_regions(search, fold, is_fixed, q, outcome, is_unfolded, search%limits)
      else
         call find_minimum(search, is_fixed, q, outcome, is_unfolded)
      end if
      if (is_unfolded) call search%objective%evaluate(q, search%work%n_rows, search%work%r, search%work%j, outcome%cost, is_valid)
      minima%searches = minima%searches + 1
      minima%steps = minima%steps + outcome%steps
      if (outcome%status == squares_no_value) return
      variance = 1
      if (search%limits%freedom > 0) variance = outcome%cost/search%limits%freedom
      do k = 1, minima%n
         if (abs(minima%cost(k) - outcome%cost) > search%limits%same_distance**2*variance &
            & .and. abs(minima%cost(k) - outcome%cost) > 1.0e-20_dp) cycle
         if (norm2(matmul(search%work%j(:search%work%n_rows, :), minima%q(:, k) - q)) &
            & > search%limits%same_distance*sqrt(variance) + 1.0e-10_dp) cycle
         minima%times(k) = minima%times(k) + 1
         if (outcome%status > minima%status(k)) return
         if (outcome%status == minima%status(k) .and. outcome%cost >= minima%cost(k)) return
         exit
      end do
      if (k > most_minima) return
      minima%n = max(minima%n, k)
      minima%times(k) = max(minima%times(k), 1)
      minima%q(:, k) = q
      minima%cost(k) = outcome%cost
      minima%status(k) = outcome%status
   end subroutine add_search

   !> Sort the minima, the least first.
   pure subroutine sort_minima(minima, n_free)
      type(minima_t), intent(inout) :: minima
      integer, intent(in) :: n_free
      real(dp) :: q(n_free), cost
      integer :: i, k, times, status

      do i = 1, minima%n - 1
         k = i - 1 + minloc(minima%cost(i:minima%n), 1)
         q = minima%q(:, i)
         cost = minima%cost(i)
         times = minima%times(i)
         status = minima%status(i)
         minima%q(:, i) = minima%q(:, k)
         minima%cost(i) = minima%cost(k)
         minima%times(i) = minima%times(k)
         minima%status(i) = minima%status(k)
         minima%q(:, k) = q
         minima%cost(k) = cost
         minima%times(k) = times
         minima%status(k) = status
      end do
   end subroutine sort_minima

end module adfric_fit_minima
