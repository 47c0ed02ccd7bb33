! SPDX-License-Identifier: GPL-3.0-or-later
! The error of the mean of a sequence whose correlation is known: that of maximal length from a shift register, whose n = 2^p - 1
! values of -1 and 1 have the sum 1, and -1 as the sum of products of values any k places apart, k not a multiple of n.
module numerics_correlated_mean
   use adfric_base_kinds, only: dp
   use adfric_numerics_correlated_mean, only: error_of_mean
   use funit
   implicit none (type, external)

   !> Roundings of sums over the sequences.
   real(dp), parameter :: few_eps = 100*epsilon(1.0_dp)
   !> Length of the register, and of the sequence.
   integer, parameter :: p = 7, n = 2**p - 1

contains

   ! Less the mean 1/n, products of different places sum to -1 - 1/n < 0: they count as independent.
   !@test
   subroutine test_independent()
      real(dp) :: variance

      variance = (1 - 1/real(n, dp)**2)/(n - 1)
#line 23 "/work/main/tests/numerics/numerics_correlated_mean.pf"
  call assertRelativelyEqual(sqrt(variance), error_of_mean(sequence()), tolerance=few_eps, &
 & location=SourceLocation( &
 & 'numerics_correlated_mean.pf', &
 & 23) )
  if (anyExceptions()) return
#line 24 "/work/main/tests/numerics/numerics_correlated_mean.pf"
#line 24 "/work/main/tests/numerics/numerics_correlated_mean.pf"
  call assertRelativelyEqual(1.0_dp, error_of_mean([5.0_dp, 7.0_dp]), tolerance=few_eps, &
 & location=SourceLocation( &
 & 'numerics_correlated_mean.pf', &
 & 24) )
  if (anyExceptions()) return
#line 25 "/work/main/tests/numerics/numerics_correlated_mean.pf"
   end subroutine test_independent

   ! Each value m times: that tells nothing more of the mean. The sums of products fall from n m C0 to n m C1 in m equal steps,
   ! C0 = 1 - 1/n^2, C1 = -(1 + 1/n)/n.
   !@test
   subroutine test_repeated()
      real(dp) :: first, last, total
      integer :: k, m

      do m = 2, 10
         first = 1 - 1/real(n, dp)**2
         last = -(1 + 1/real(n, dp))/n
         total = first
         do k = 1, m - 1
            if (first*(m - k) + last*k > 0) total = total + 2*(first*(m - k) + last*k)/m
         end do
#line 41 "/work/main/tests/numerics/numerics_correlated_mean.pf"
  call assertRelativelyEqual(sqrt(total/(n*m - 1)), error_of_mean(repeated(m)), tolerance=few_eps, &
 & location=SourceLocation( &
 & 'numerics_correlated_mean.pf', &
 & 41) )
  if (anyExceptions()) return
#line 42 "/work/main/tests/numerics/numerics_correlated_mean.pf"
         ! which is that of the values taken once, but for the last terms
#line 43 "/work/main/tests/numerics/numerics_correlated_mean.pf"
  call assertRelativelyEqual(error_of_mean(sequence()), error_of_mean(repeated(m)), tolerance=2.0_dp/n, &
 & location=SourceLocation( &
 & 'numerics_correlated_mean.pf', &
 & 43) )
  if (anyExceptions()) return
#line 44 "/work/main/tests/numerics/numerics_correlated_mean.pf"
      end do
   end subroutine test_repeated

   ! Without scatter there is no error.
   !@test
   subroutine test_no_scatter()
#line 50 "/work/main/tests/numerics/numerics_correlated_mean.pf"
  call assertEqual(0.0_dp, error_of_mean([3.0_dp]), &
 & location=SourceLocation( &
 & 'numerics_correlated_mean.pf', &
 & 50) )
  if (anyExceptions()) return
#line 51 "/work/main/tests/numerics/numerics_correlated_mean.pf"
#line 51 "/work/main/tests/numerics/numerics_correlated_mean.pf"
  call assertEqual(0.0_dp, error_of_mean([2.0_dp, 2.0_dp, 2.0_dp, 2.0_dp]), &
 & location=SourceLocation( &
 & 'numerics_correlated_mean.pf', &
 & 51) )
  if (anyExceptions()) return
#line 52 "/work/main/tests/numerics/numerics_correlated_mean.pf"
   end subroutine test_no_scatter

   !> The sequence, by x^7 + x + 1.
   function sequence() result(values)
      real(dp) :: values(n)
      integer :: bits(n), i

      bits(:p) = 1
      do i = p + 1, n
         bits(i) = ieor(bits(i - p), bits(i - p + 1))
      end do
      values = 2*bits - 1
   end function sequence

   !> The sequence with each value m times.
   function repeated(m) result(values)
      integer, intent(in) :: m
      real(dp) :: values(n*m)

      values = reshape(spread(sequence(), 1, m), [n*m])
   end function repeated

end module numerics_correlated_mean

module Wrapnumerics_correlated_mean
   use FUnit
   use numerics_correlated_mean
   implicit none
   private

contains


end module Wrapnumerics_correlated_mean

function numerics_correlated_mean_suite() result(suite)
   use FUnit
   use numerics_correlated_mean
   use Wrapnumerics_correlated_mean
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('numerics_correlated_mean_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_independent', &
      test_independent))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_repeated', &
      test_repeated))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_no_scatter', &
      test_no_scatter))
   call suite%addTest(t)


end function numerics_correlated_mean_suite

