! SPDX-License-Identifier: GPL-3.0-or-later
! Differences of hyperbolic functions.
module numerics_hyperbolic
   use, intrinsic :: iso_fortran_env, only: real128
   use adfric_base_kinds, only: dp
   use adfric_numerics_hyperbolic, only: sinh_minus_argument
   use funit
   implicit none (type, external)

   real(dp), parameter :: round_off = 10*epsilon(1.0_dp)

contains

   ! Against quadruple precision, which keeps 16 digits of the difference down to x = 1e-9, and on both sides of x = 1.
   !@test
   subroutine test_digits()
      real(dp) :: x, expected
      integer :: i

      do i = -180, 26
         x = 10.0_dp**(0.05_dp*i)
         expected = real(sinh(real(x, real128)) - real(x, real128), dp)
#line 23 "/work/main/tests/numerics/numerics_hyperbolic.pf"
  call assertRelativelyEqual(expected, sinh_minus_argument(x), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_hyperbolic.pf', &
 & 23) )
  if (anyExceptions()) return
#line 24 "/work/main/tests/numerics/numerics_hyperbolic.pf"
      end do
      x = sinh_minus_argument(nearest(1.0_dp, -1.0_dp))
#line 26 "/work/main/tests/numerics/numerics_hyperbolic.pf"
  call assertRelativelyEqual(sinh_minus_argument(1.0_dp), x, tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_hyperbolic.pf', &
 & 26) )
  if (anyExceptions()) return
#line 27 "/work/main/tests/numerics/numerics_hyperbolic.pf"
   end subroutine test_digits

   !@test
   subroutine test_ends()
#line 31 "/work/main/tests/numerics/numerics_hyperbolic.pf"
  call assertEqual(0.0_dp, sinh_minus_argument(0.0_dp), &
 & location=SourceLocation( &
 & 'numerics_hyperbolic.pf', &
 & 31) )
  if (anyExceptions()) return
#line 32 "/work/main/tests/numerics/numerics_hyperbolic.pf"
      ! x^3/6
#line 33 "/work/main/tests/numerics/numerics_hyperbolic.pf"
  call assertRelativelyEqual(1.0e-300_dp/6, sinh_minus_argument(1.0e-100_dp), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_hyperbolic.pf', &
 & 33) )
  if (anyExceptions()) return
#line 34 "/work/main/tests/numerics/numerics_hyperbolic.pf"
   end subroutine test_ends

end module numerics_hyperbolic

module Wrapnumerics_hyperbolic
   use FUnit
   use numerics_hyperbolic
   implicit none
   private

contains


end module Wrapnumerics_hyperbolic

function numerics_hyperbolic_suite() result(suite)
   use FUnit
   use numerics_hyperbolic
   use Wrapnumerics_hyperbolic
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('numerics_hyperbolic_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_digits', &
      test_digits))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_ends', &
      test_ends))
   call suite%addTest(t)


end function numerics_hyperbolic_suite

