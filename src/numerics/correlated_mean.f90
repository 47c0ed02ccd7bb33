! SPDX-License-Identifier: GPL-3.0-or-later
!> The error of a mean of values that resemble their neighbours.
module adfric_numerics_correlated_mean
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: error_of_mean

contains

   !> Standard error of the mean of values along a period, by their scatter and the length over which they are correlated:
   !> $$ s^2 = \left(c_0 + 2 \sum_{k=1}^{m} c_k\right)/(n - 1), $$
   !> c_k being the covariance of values k positions apart and m the last before the first that is not positive. Values without
   !> correlation have sqrt(c_0/(n - 1)). A single value has no scatter, 0.
   pure real(dp) function error_of_mean(values) result(error)
      !> The values, of which the first follows on the last.
      real(dp), intent(in) :: values(:)
      real(dp) :: deviations(size(values)), covariance, total
      integer :: k, n

      error = 0
      n = size(values)
      if (n < 2) return
      deviations = values - sum(values)/n
      total = sum(deviations**2)
      do k = 1, n/2
         covariance = dot_product(deviations(:n - k), deviations(k + 1:)) + dot_product(deviations(n - k + 1:), deviations(:k))
         if (.not. covariance > 0) exit
         ! at half a period both ways lead to the same value
         total = total + merge(1, 2, 2*k == n)*covariance
      end do
      error = sqrt(total/n/(n - 1))
   end function error_of_mean

end module adfric_numerics_correlated_mean
