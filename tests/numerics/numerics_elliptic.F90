! SPDX-License-Identifier: GPL-3.0-or-later
! Carlson's elliptic integrals.
module numerics_elliptic
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan, ieee_negative_inf, ieee_positive_denormal, &
      & ieee_positive_inf, ieee_value
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_numerics_elliptic, only: carlson_d, carlson_f
   use funit
   implicit none (type, external)

   real(dp), parameter :: round_off = 10*epsilon(1.0_dp)
   !> Digits of the published values.
   real(dp), parameter :: published = 1.0e-13_dp

contains

   ! B. C. Carlson, Numerical Algorithms 10 (1995) 13, section 3.
   !@test
   subroutine test_published()
#line 22 "/work/main/tests/numerics/numerics_elliptic.pf"
  call assertRelativelyEqual(1.3110287771461_dp, carlson_f(1.0_dp, 2.0_dp, 0.0_dp), tolerance=published, &
 & location=SourceLocation( &
 & 'numerics_elliptic.pf', &
 & 22) )
  if (anyExceptions()) return
#line 23 "/work/main/tests/numerics/numerics_elliptic.pf"
#line 23 "/work/main/tests/numerics/numerics_elliptic.pf"
  call assertRelativelyEqual(1.8540746773014_dp, carlson_f(0.5_dp, 1.0_dp, 0.0_dp), tolerance=published, &
 & location=SourceLocation( &
 & 'numerics_elliptic.pf', &
 & 23) )
  if (anyExceptions()) return
#line 24 "/work/main/tests/numerics/numerics_elliptic.pf"
#line 24 "/work/main/tests/numerics/numerics_elliptic.pf"
  call assertRelativelyEqual(0.58408284167715_dp, carlson_f(2.0_dp, 3.0_dp, 4.0_dp), tolerance=published, &
 & location=SourceLocation( &
 & 'numerics_elliptic.pf', &
 & 24) )
  if (anyExceptions()) return
#line 25 "/work/main/tests/numerics/numerics_elliptic.pf"
#line 25 "/work/main/tests/numerics/numerics_elliptic.pf"
  call assertRelativelyEqual(1.7972103521034_dp, carlson_d(0.0_dp, 2.0_dp, 1.0_dp), tolerance=published, &
 & location=SourceLocation( &
 & 'numerics_elliptic.pf', &
 & 25) )
  if (anyExceptions()) return
#line 26 "/work/main/tests/numerics/numerics_elliptic.pf"
#line 26 "/work/main/tests/numerics/numerics_elliptic.pf"
  call assertRelativelyEqual(0.16510527294261_dp, carlson_d(2.0_dp, 3.0_dp, 4.0_dp), tolerance=published, &
 & location=SourceLocation( &
 & 'numerics_elliptic.pf', &
 & 26) )
  if (anyExceptions()) return
#line 27 "/work/main/tests/numerics/numerics_elliptic.pf"
   end subroutine test_published

   ! R_F(x, x, x) = x^(-1/2), R_D(x, x, x) = x^(-3/2), and the complete circle.
   !@test
   subroutine test_equal_arguments()
      real(dp), parameter :: x(4) = [1.0e-30_dp, 0.01_dp, 4.0_dp, 1.0e30_dp]

#line 34 "/work/main/tests/numerics/numerics_elliptic.pf"
  call assertRelativelyEqual(1/sqrt(x), carlson_f(x, x, x), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_elliptic.pf', &
 & 34) )
  if (anyExceptions()) return
#line 35 "/work/main/tests/numerics/numerics_elliptic.pf"
#line 35 "/work/main/tests/numerics/numerics_elliptic.pf"
  call assertRelativelyEqual(1/(x*sqrt(x)), carlson_d(x, x, x), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_elliptic.pf', &
 & 35) )
  if (anyExceptions()) return
#line 36 "/work/main/tests/numerics/numerics_elliptic.pf"
#line 36 "/work/main/tests/numerics/numerics_elliptic.pf"
  call assertRelativelyEqual(half_pi, carlson_f(0.0_dp, 1.0_dp, 1.0_dp), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_elliptic.pf', &
 & 36) )
  if (anyExceptions()) return
#line 37 "/work/main/tests/numerics/numerics_elliptic.pf"
#line 37 "/work/main/tests/numerics/numerics_elliptic.pf"
  call assertRelativelyEqual(1.5_dp*half_pi, carlson_d(0.0_dp, 1.0_dp, 1.0_dp), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_elliptic.pf', &
 & 37) )
  if (anyExceptions()) return
#line 38 "/work/main/tests/numerics/numerics_elliptic.pf"
   end subroutine test_equal_arguments

   ! Any three of these arguments: NaN just where the integral is none or not to be had. The handler of errors that GSL has by
   ! itself is in place, and would end this program.
   !@test
   subroutine test_no_argument_ends_the_process()
      real(dp), parameter :: finite(*) = [-huge(1.0_dp), -1.0_dp, -tiny(1.0_dp), -0.0_dp, 0.0_dp, tiny(1.0_dp), 0.5e-307_dp, &
         & 1.3e-307_dp, 3.1e-206_dp, 6.5e-206_dp, 1.0e-100_dp, 1.0_dp, 1.0e100_dp, 2.5e202_dp, 2.8e202_dp, &
         & 3.4e307_dp, 3.6e307_dp, huge(1.0_dp)]
      real(dp) :: arguments(size(finite) + 4), a(3)
      integer :: i, j, k

      arguments = [finite, not_a_number(), ieee_value(1.0_dp, ieee_positive_inf), ieee_value(1.0_dp, ieee_negative_inf), &
         & ieee_value(1.0_dp, ieee_positive_denormal)]
      do i = 1, size(arguments)
         do j = 1, size(arguments)
            do k = 1, size(arguments)
               a = arguments([i, j, k])
#line 56 "/work/main/tests/numerics/numerics_elliptic.pf"
  call assertTrue(is_positive(carlson_f(a(1), a(2), a(3))) .eqv. is_in_domain_f(a), &
 & location=SourceLocation( &
 & 'numerics_elliptic.pf', &
 & 56) )
  if (anyExceptions()) return
#line 57 "/work/main/tests/numerics/numerics_elliptic.pf"
#line 57 "/work/main/tests/numerics/numerics_elliptic.pf"
  call assertTrue(is_positive(carlson_d(a(1), a(2), a(3))) .eqv. is_in_domain_d(a), &
 & location=SourceLocation( &
 & 'numerics_elliptic.pf', &
 & 57) )
  if (anyExceptions()) return
#line 58 "/work/main/tests/numerics/numerics_elliptic.pf"
            end do
         end do
      end do
   end subroutine test_no_argument_ends_the_process

   ! A number > 0; else it must be NaN.
   logical function is_positive(value)
      real(dp), intent(in) :: value

      is_positive = ieee_is_finite(value)
      if (is_positive) is_positive = value > 0
      if (.not. is_positive .and. .not. ieee_is_nan(value)) error stop 'neither a number > 0 nor NaN'
   end function is_positive

   ! All are finite, >= 0 and not too large, and two of them are not both too small.
   logical function is_in_domain_f(a)
      real(dp), intent(in) :: a(3)

      is_in_domain_f = all(ieee_is_finite(a))
      if (is_in_domain_f) is_in_domain_f = all(a >= 0 .and. a < 3.5e307_dp) .and. count(a >= 1.2e-307_dp) >= 2
   end function is_in_domain_f

   ! All are finite, >= 0 and not too large, and z is not too small, nor are both x and y.
   logical function is_in_domain_d(a)
      real(dp), intent(in) :: a(3)

      is_in_domain_d = all(ieee_is_finite(a))
      if (is_in_domain_d) is_in_domain_d = all(a >= 0 .and. a < 2.6e202_dp) .and. a(3) >= 6.4e-206_dp &
         & .and. max(a(1), a(2)) >= 6.4e-206_dp
   end function is_in_domain_d

end module numerics_elliptic

module Wrapnumerics_elliptic
   use FUnit
   use numerics_elliptic
   implicit none
   private

contains


end module Wrapnumerics_elliptic

function numerics_elliptic_suite() result(suite)
   use FUnit
   use numerics_elliptic
   use Wrapnumerics_elliptic
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('numerics_elliptic_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_published', &
      test_published))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_equal_arguments', &
      test_equal_arguments))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_no_argument_ends_the_process', &
      test_no_argument_ends_the_process))
   call suite%addTest(t)


end function numerics_elliptic_suite

