! SPDX-License-Identifier: GPL-3.0-or-later
!> Mean, standard deviation and quantiles of numbers, some of which may have no value.
module adfric_run_sample_statistics
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   implicit none (type, external)
   private
   public :: find_statistics

   !> Probabilities of the quantiles.
   real(dp), parameter :: probabilities(3) = [0.025_dp, 0.5_dp, 0.975_dp]

contains

   !> Mean, standard deviation, and quantiles 0.025, 0.5, 0.975 of the numbers that have a value; NaN if fewer than two have one.
   pure subroutine find_statistics(numbers, statistics)
      !> The numbers, NaN where there is no value.
      real(dp), intent(in) :: numbers(:)
      !> Receives the five statistics.
      real(dp), intent(out) :: statistics(5)
      real(dp), allocatable :: sorted(:)
      real(dp) :: index, scale
      integer :: k, n, below

      statistics = not_a_number()
      sorted = pack(numbers,.not. ieee_is_nan(numbers))
      n = size(sorted)
      if (n < 2) return
      call sort(sorted)
      statistics(1) = sorted(1) + sum(sorted - sorted(1))/n
      ! squares of tiny numbers would vanish
      scale = max(sorted(n) - sorted(1), tiny(scale))
      statistics(2) = scale*sqrt(sum(((sorted - statistics(1))/scale)**2)/(n - 1))
      do k = 1, size(probabilities)
         index = 1 + probabilities(k)*(n - 1)
         below = min(int(index), n - 1)
         statistics(2 + k) = sorted(below) + (index - below)*(sorted(below + 1) - sorted(below))
      end do
   end subroutine find_statistics

   !> Sort numbers, the smallest first: heapsort (J. W. J. Williams, Commun. ACM 7, 347, 1964).
   pure subroutine sort(numbers)
      !> The numbers, none of which is NaN.
      real(dp), intent(inout) :: numbers(:)
      real(dp) :: kept
      integer :: i

      do i = size(numbers)/2, 1, -1
         call sift(numbers, i, size(numbers))
      end do
      do i = size(numbers), 2, -1
         kept = numbers(i)
         numbers(i) = numbers(1)
         numbers(1) = kept
         call sift(numbers, 1, i - 1)
      end do
   end subroutine sort

   !> Let a number sink to its place in a heap, each number of which is no less than the two below it.
   pure subroutine sift(numbers, first, last)
      real(dp), intent(inout) :: numbers(:)
      !> Index of the number that sinks, and the last index of the heap.
      integer, intent(in) :: first, last
      real(dp) :: sinking
      integer :: index, child

      sinking = numbers(first)
      index = first
      do
         child = 2*index
         if (child > last) exit
         if (child < last) then
            if (numbers(child + 1) > numbers(child)) child = child + 1
         end if
         if (.not. numbers(child) > sinking) exit
         numbers(index) = numbers(child)
         index = child
      end do
      numbers(index) = sinking
   end subroutine sift

end module adfric_run_sample_statistics
