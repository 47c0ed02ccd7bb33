! SPDX-License-Identifier: GPL-3.0-or-later
!> Numbers in order.
module adfric_fit_order
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: sort, median_step, order_of

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

   !> Indices of numbers in rising order; equal ones keep theirs (merge sort).
   pure function order_of(numbers) result(indices)
      real(dp), intent(in) :: numbers(:)
      integer :: indices(size(numbers)), merged(size(numbers)), width, first, middle, last, i, k, m

      indices = [(i, i=1, size(numbers))]
      width = 1
      do while (width < size(numbers))
         do first = 1, size(numbers), 2*width
            middle = min(first + width, size(numbers) + 1)
            last = min(first + 2*width, size(numbers) + 1) - 1
            i = first
            k = middle
            do m = first, last
               if (k > last) then
                  merged(m) = indices(i)
                  i = i + 1
               else if (i >= middle) then
                  merged(m) = indices(k)
                  k = k + 1
               else if (numbers(indices(i)) <= numbers(indices(k))) then
                  merged(m) = indices(i)
                  i = i + 1
               else
                  merged(m) = indices(k)
                  k = k + 1
               end if
            end do
         end do
         indices = merged
         if (width > size(numbers)/2) exit
         width = 2*width
      end do
   end function order_of

   !> Sort numbers, the least first.
   pure subroutine sort(numbers)
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
