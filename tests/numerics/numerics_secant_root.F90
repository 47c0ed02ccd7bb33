! SPDX-License-Identifier: GPL-3.0-or-later
! Roots of rising equations without a slope.
module numerics_secant_root
   use adfric_base_kinds, only: dp
   use adfric_numerics_secant_root, only: find_rising_root
   use rising_equations, only: power_equation_t
   use funit
   implicit none (type, external)

   real(dp), parameter :: round_off = 4*epsilon(1.0_dp)

contains

   ! x^n = c, from a good guess, a bad one, none, and the root but for 1e-13; with slopes that are far off.
   !@test
   subroutine test_powers()
      real(dp) :: x
      logical :: is_converged
      integer :: n, k, start
      real(dp), parameter :: starts(3) = [1.3_dp, 90.0_dp, -200.0_dp]

      do n = 1, 9, 2
         do start = 1, 4
            do k = -3, 3, 3
               x = 2.0_dp**(1.0_dp/n)*(1 + 1.0e-13_dp)
               if (start < 4) x = starts(start)
               call find_rising_root(power_equation_t(n, 2.0_dp), -100.0_dp, 100.0_dp, 10.0_dp**k, round_off, x, is_converged)
#line 28 "/work/main/tests/numerics/numerics_secant_root.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'numerics_secant_root.pf', &
 & 28) )
  if (anyExceptions()) return
#line 29 "/work/main/tests/numerics/numerics_secant_root.pf"
#line 29 "/work/main/tests/numerics/numerics_secant_root.pf"
  call assertRelativelyEqual(2.0_dp**(1.0_dp/n), x, tolerance=10*epsilon(x), &
 & location=SourceLocation( &
 & 'numerics_secant_root.pf', &
 & 29) )
  if (anyExceptions()) return
#line 30 "/work/main/tests/numerics/numerics_secant_root.pf"
            end do
         end do
      end do
   end subroutine test_powers

   ! A value that is not a number ends the search.
   !@test
   subroutine test_failures()
      real(dp) :: x
      logical :: is_converged

      x = 1
      call find_rising_root(power_equation_t(-1, 2.0_dp), 0.0_dp, 10.0_dp, 1.0_dp, round_off, x, is_converged)
#line 43 "/work/main/tests/numerics/numerics_secant_root.pf"
  call assertFalse(is_converged, &
 & location=SourceLocation( &
 & 'numerics_secant_root.pf', &
 & 43) )
  if (anyExceptions()) return
#line 44 "/work/main/tests/numerics/numerics_secant_root.pf"
   end subroutine test_failures

end module numerics_secant_root

module Wrapnumerics_secant_root
   use FUnit
   use numerics_secant_root
   implicit none
   private

contains


end module Wrapnumerics_secant_root

function numerics_secant_root_suite() result(suite)
   use FUnit
   use numerics_secant_root
   use Wrapnumerics_secant_root
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('numerics_secant_root_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_powers', &
      test_powers))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_failures', &
      test_failures))
   call suite%addTest(t)


end function numerics_secant_root_suite

