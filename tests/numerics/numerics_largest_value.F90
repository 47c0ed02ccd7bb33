! SPDX-License-Identifier: GPL-3.0-or-later
! The largest value of functions with roots at the ends of their range.
module numerics_largest_value
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_numerics_double_exponential, only: integrand_t
   use adfric_numerics_largest_value, only: find_largest_value
   use rising_equations, only: end_power_t
   use funit
   implicit none (type, external)

   real(dp), parameter :: round_off = 20*epsilon(1.0_dp)

   !> A low wide hill and a high narrow one, x/(x + a) exp(1 - x/a) near the left end; or NaN beyond a place.
   type, extends(integrand_t) :: two_hills_t
      real(dp) :: narrow = 1.0e-5_dp
      real(dp) :: end = huge(1.0_dp)
   contains
      procedure :: evaluate
   end type two_hills_t

   !> A plain of 1 with a hill of height 0.1 and width 0.05 between two first places, and a bank of 0.05 at the left end.
   type, extends(integrand_t) :: hidden_hill_t
   contains
      procedure :: evaluate => evaluate_hidden
   end type hidden_hill_t

contains

   pure real(dp) function evaluate_hidden(self, from_left, from_right) result(value)
      class(hidden_hill_t), intent(in) :: self
      real(dp), intent(in) :: from_left, from_right

      value = 1 + 0.1_dp*exp(-((from_left - 0.42_dp)/0.05_dp)**2) + 0.05_dp*exp(-from_left/0.01_dp)
      associate (unused => self, unused_way => from_right)
      end associate
   end function evaluate_hidden

   pure real(dp) function evaluate(self, from_left, from_right)
      class(two_hills_t), intent(in) :: self
      real(dp), intent(in) :: from_left, from_right

      evaluate = from_left*from_right + from_left/self%narrow*exp(1 - from_left/self%narrow)
      if (from_left > self%end) evaluate = not_a_number()
   end function evaluate

   ! l^a r^b has its maximum at l = a/(a + b).
   !@test
   subroutine test_powers()
      real(dp), parameter :: powers(4) = [0.01_dp, 0.5_dp, 1.0_dp, 3.0_dp]
      real(dp) :: largest, a, b
      integer :: i, j

      do i = 1, 4
         do j = 1, 4
            a = powers(i)
            b = powers(j)
            call find_largest_value(end_power_t(a, b), a + b, largest)
#line 60 "/work/main/tests/numerics/numerics_largest_value.pf"
  call assertRelativelyEqual(a**a*b**b, largest, tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_largest_value.pf', &
 & 60) )
  if (anyExceptions()) return
#line 61 "/work/main/tests/numerics/numerics_largest_value.pf"
         end do
      end do
   end subroutine test_powers

   ! The narrow hill is 1 high, and the wide one adds its slope there, 1e-5; without it 1/4 is left.
   !@test
   subroutine test_two_hills()
      real(dp) :: largest

      call find_largest_value(two_hills_t(), 1.0_dp, largest)
#line 71 "/work/main/tests/numerics/numerics_largest_value.pf"
  call assertEqual(1 + 1.0e-5_dp, largest, tolerance=1.0e-9_dp, &
 & location=SourceLocation( &
 & 'numerics_largest_value.pf', &
 & 71) )
  if (anyExceptions()) return
#line 72 "/work/main/tests/numerics/numerics_largest_value.pf"
      call find_largest_value(two_hills_t(narrow=1.0e-30_dp), 1.0_dp, largest)
#line 73 "/work/main/tests/numerics/numerics_largest_value.pf"
  call assertEqual(0.25_dp, largest, tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_largest_value.pf', &
 & 73) )
  if (anyExceptions()) return
#line 74 "/work/main/tests/numerics/numerics_largest_value.pf"
   end subroutine test_two_hills

   ! The places nearest to the hill, 0.347 and 0.5, are lower than the bank.
   !@test
   subroutine test_lower_place_of_the_higher_summit()
      real(dp) :: largest

      call find_largest_value(hidden_hill_t(), 1.0_dp, largest)
#line 82 "/work/main/tests/numerics/numerics_largest_value.pf"
  call assertEqual(1.1_dp, largest, tolerance=1.0e-13_dp, &
 & location=SourceLocation( &
 & 'numerics_largest_value.pf', &
 & 82) )
  if (anyExceptions()) return
#line 83 "/work/main/tests/numerics/numerics_largest_value.pf"
   end subroutine test_lower_place_of_the_higher_summit

   !@test
   subroutine test_not_a_number()
      real(dp) :: largest

      call find_largest_value(two_hills_t(end=0.9_dp), 1.0_dp, largest)
#line 90 "/work/main/tests/numerics/numerics_largest_value.pf"
  call assertTrue(ieee_is_nan(largest), &
 & location=SourceLocation( &
 & 'numerics_largest_value.pf', &
 & 90) )
  if (anyExceptions()) return
#line 91 "/work/main/tests/numerics/numerics_largest_value.pf"
   end subroutine test_not_a_number

end module numerics_largest_value

module Wrapnumerics_largest_value
   use FUnit
   use numerics_largest_value
   implicit none
   private

contains


end module Wrapnumerics_largest_value

function numerics_largest_value_suite() result(suite)
   use FUnit
   use numerics_largest_value
   use Wrapnumerics_largest_value
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('numerics_largest_value_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_powers', &
      test_powers))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_two_hills', &
      test_two_hills))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_lower_place_of_the_higher_summit', &
      test_lower_place_of_the_higher_summit))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_not_a_number', &
      test_not_a_number))
   call suite%addTest(t)


end function numerics_largest_value_suite

