! SPDX-License-Identifier: GPL-3.0-or-later
! Integrals with roots and inverse roots at the ends.
module numerics_double_exponential
   use adfric_base_kinds, only: dp
   use adfric_numerics_double_exponential, only: integrate
   use rising_equations, only: end_power_t
   use funit
   implicit none (type, external)

   real(dp), parameter :: round_off = 20*epsilon(1.0_dp)

contains

   ! Euler's integral: int l^a r^b = length^(a + b + 1) Gamma(a + 1) Gamma(b + 1)/Gamma(a + b + 2).
   !@test
   subroutine test_powers()
      real(dp), parameter :: powers(5) = [-0.5_dp, 0.0_dp, 0.5_dp, 1.0_dp, 2.5_dp], length = 3
      real(dp) :: integral, a, b
      logical :: is_converged
      integer :: i, j

      do i = 1, 5
         do j = 1, 5
            a = powers(i)
            b = powers(j)
            call integrate(end_power_t(a, b), length, integral, is_converged)
#line 27 "/work/main/tests/numerics/numerics_double_exponential.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'numerics_double_exponential.pf', &
 & 27) )
  if (anyExceptions()) return
#line 28 "/work/main/tests/numerics/numerics_double_exponential.pf"
#line 28 "/work/main/tests/numerics/numerics_double_exponential.pf"
  call assertRelativelyEqual(length**(a + b + 1)*gamma(a + 1)*gamma(b + 1)/gamma(a + b + 2), integral, tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_double_exponential.pf', &
 & 28) )
  if (anyExceptions()) return
#line 29 "/work/main/tests/numerics/numerics_double_exponential.pf"
         end do
      end do
   end subroutine test_powers

   !@test
   subroutine test_decays()
      real(dp) :: integral
      logical :: is_converged
      integer :: i

      do i = 0, 5
         call integrate(end_power_t(decay=2.0_dp**i), 1.5_dp, integral, is_converged)
#line 41 "/work/main/tests/numerics/numerics_double_exponential.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'numerics_double_exponential.pf', &
 & 41) )
  if (anyExceptions()) return
#line 42 "/work/main/tests/numerics/numerics_double_exponential.pf"
#line 42 "/work/main/tests/numerics/numerics_double_exponential.pf"
  call assertRelativelyEqual((1 - exp(-1.5_dp*2**i))/2**i, integral, tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_double_exponential.pf', &
 & 42) )
  if (anyExceptions()) return
#line 43 "/work/main/tests/numerics/numerics_double_exponential.pf"
      end do
   end subroutine test_decays

   ! No range has no integral; one that does not exist does not come to rest.
   !@test
   subroutine test_ends()
      real(dp) :: integral
      logical :: is_converged

      call integrate(end_power_t(-0.5_dp), 0.0_dp, integral, is_converged)
#line 53 "/work/main/tests/numerics/numerics_double_exponential.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'numerics_double_exponential.pf', &
 & 53) )
  if (anyExceptions()) return
#line 54 "/work/main/tests/numerics/numerics_double_exponential.pf"
#line 54 "/work/main/tests/numerics/numerics_double_exponential.pf"
  call assertEqual(0.0_dp, integral, &
 & location=SourceLocation( &
 & 'numerics_double_exponential.pf', &
 & 54) )
  if (anyExceptions()) return
#line 55 "/work/main/tests/numerics/numerics_double_exponential.pf"
      call integrate(end_power_t(-1.5_dp), 1.0_dp, integral, is_converged)
#line 56 "/work/main/tests/numerics/numerics_double_exponential.pf"
  call assertFalse(is_converged, &
 & location=SourceLocation( &
 & 'numerics_double_exponential.pf', &
 & 56) )
  if (anyExceptions()) return
#line 57 "/work/main/tests/numerics/numerics_double_exponential.pf"
   end subroutine test_ends

end module numerics_double_exponential

module Wrapnumerics_double_exponential
   use FUnit
   use numerics_double_exponential
   implicit none
   private

contains


end module Wrapnumerics_double_exponential

function numerics_double_exponential_suite() result(suite)
   use FUnit
   use numerics_double_exponential
   use Wrapnumerics_double_exponential
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('numerics_double_exponential_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_powers', &
      test_powers))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_decays', &
      test_decays))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_ends', &
      test_ends))
   call suite%addTest(t)


end function numerics_double_exponential_suite

