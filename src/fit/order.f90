! SPDX-License-Identifier: GPL-3.0-or-later
!> Numbers in order.
module adfric_fit_order
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: sort, median_step

contains

   !> Median distance of neighbouring numbers; their range over their count where most are equal.
   pure real(dp) function median_step(numbers) result(step)
      !> The numbers, in any order.
      real(dp), intent(in) :: numbers(:)
      real(dp) :: steps(max(size(numbers) - 1, 0)), sorted(size(numbers))
      integer :: n

      step = 1
      n = size(numbers) - 1
      if (n < 1) return
      sorted = numbers
      call sort(sorted)
      steps = sorted(2:) - sorted(:n)
      call sort(steps)
      step = (steps((n + 1)/2) + steps(n/2 + 1))/2
      if (.not. step > 0) step = (sorted(n + 1) - sorted(1))/n
      if (.not. step > 0) step = max(abs(sorted(1)), tiny(step))
   end function median_step

   !> Sort numbers, the least first.
   pure subroutine sort(numbers)
      !> The numbers.
      real(dp), intent(inout) :: numbers(:)
      real(dp) :: number
      integer :: gap, i, k

      gap = size(numbers)/2
      do while (gap > 0)
         do i = gap + 1, size(numbers)
            number = numbers(i)
            k = i
            do while (k > gap)
               if (numbers(k - gap) <= number) exit
               numbers(k) = numbers(k - gap)
               k = k - gap
            end do
            numbers(k) = number
         end do
         gap = gap/2
      end do
   end subroutine sort

end module adfric_fit_order
