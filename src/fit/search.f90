! SPDX-License-Identifier: GPL-3.0-or-later
!> All minima of a fit's sum of squares that count.
!>
!> Lambda is always scanned (`adfric_fit_lambda_scan`), since friction against load may have two answers for it. Other fits start at the
!> user's start or what the data show, at the next best positions that a look at a whole curve gives, and at positions around it by
!> a fixed list, six in all. With a loss the searches start at the
!> answers of least squares, too.
module adfric_fit_search
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: unset
   use adfric_fit_fold_search, only: searched_t
   use adfric_fit_fold_survey, only: survey_folds
   use adfric_fit_lambda_scan, only: scan_lambda, fewest_nodes
   use adfric_fit_minima, only: minima_t, new_minima, add_search, sort_minima
   use adfric_fit_problem, only: fit_t
   use adfric_fit_starts, only: get_start, get_more_starts, lambda_free
   implicit none (type, external)
   private
   public :: find_minima

   !> Starts of a fit without lambda, and how far they lie from the first one, as differences of the numbers that are fitted.
   integer, parameter :: usual_starts = 6
   real(dp), parameter :: usual_distance = 1.0_dp
   !> Most starts beside the first one that a look at the data gives.
   integer, parameter :: most_looked_at = 2

contains

   !> Find all minima.
   subroutine find_minima(search, fit, minima)
      type(searched_t), intent(inout) :: search
      type(fit_t), intent(in) :: fit
      type(minima_t), intent(out) :: minima
      type(minima_t) :: plain
      real(dp) :: q(search%objective%n_free)
      integer :: k

      call new_minima(minima, search%objective%n_free)
      if (search%objective%is_robust()) then
         ! a robust search starts at the answers of least squares, too
         search%objective%is_plain = .true.
         call new_minima(plain, search%objective%n_free)
         call search_all(search, fit, plain)
         search%objective%is_plain = .false.
         do k = 1, plain%n
            q = plain%q(:, k)
            call add_search(search, q, minima)
         end do
         minima%searches = minima%searches + plain%searches
         minima%steps = minima%steps + plain%steps
      end if
      call search_all(search, fit, minima)
      call survey_folds(search, minima)
      call sort_minima(minima, search%objective%n_free)
   end subroutine find_minima

   !> All searches of one kind of cost.
   subroutine search_all(search, fit, minima)
      type(searched_t), intent(inout) :: search
      type(fit_t), intent(in) :: fit
      !> The minima; those found are added.
      type(minima_t), intent(inout) :: minima
      real(dp) :: q(search%objective%n_free), first(search%objective%n_free)
      real(dp), allocatable :: more(:, :)
      integer :: k, n

      if (lambda_free(fit) > 0 .and. .not. (fit%n_starts > 0 .and. fit%n_starts < fewest_nodes)) then
         call scan_lambda(search, fit, minima)
         return
      end if
      call get_start(search%objective, fit, unset, search%work, first)
      call get_more_starts(search%objective, fit, first, more)
      n = usual_starts
      if (fit%n_starts > 0) n = fit%n_starts
      do k = 1, n
         q = first
         if (k > 1 .and. k - 1 <= min(size(more, 2), most_looked_at)) then
            q = more(:, k - 1)
         else
            call move_away(k - 1, q)
         end if
         q = min(max(q, search%scales%lower), search%scales%upper)
         call add_search(search, q, minima)
      end do
   end subroutine search_all

   !> Move a start away from the first one: number 0 not at all, others by a fixed list that fills the box around it evenly (Weyl).
   pure subroutine move_away(number, q)
      integer, intent(in) :: number
      !> The start; it is moved.
      real(dp), intent(inout) :: q(:)
      real(dp) :: root
      integer :: i

      if (number == 0) return
      ! the root of x^(n+1) = x + 1 makes a sequence that is even in n dimensions
      root = 1.5_dp
      do i = 1, 30
         root = (1 + root)**(1.0_dp/(size(q) + 1))
      end do
      do i = 1, size(q)
         q(i) = q(i) + usual_distance*(2*modulo(0.5_dp + number/root**i, 1.0_dp) - 1)
      end do
   end subroutine move_away

end module adfric_fit_search
