! SPDX-License-Identifier: GPL-3.0-or-later
! Integrals by panels: functions whose singularities are pi/2 away from the real axis, over short and long ranges.
module numerics_panels
   use adfric_base_kinds, only: dp
   use adfric_numerics_panels, only: integrand_t, integrate
   use funit
   implicit none (type, external)

   !> What a pole of fourth order leaves at that distance.
   real(dp), parameter :: round_off = 1.0e-13_dp

   !> 1/cosh(t)^2, the slope of tanh(t); or its square.
   type, extends(integrand_t) :: bell_t
      integer :: power = 1
   contains
      procedure :: value_at
   end type bell_t

contains

   !> See `integrand_t`.
   pure real(dp) function value_at(self, place)
      class(bell_t), intent(in) :: self
      real(dp), intent(in) :: place

      value_at = 1/cosh(place)**(2*self%power)
   end function value_at

   ! The integral of 1/cosh^2 is tanh, that of 1/cosh^4 is tanh - tanh^3/3.
   !@test
   subroutine test_bells()
      type(bell_t) :: bell
      real(dp), parameter :: ends(*) = [1.0e-9_dp, 0.3_dp, 2.0_dp, 2.1_dp, 7.0_dp, 60.0_dp]
      real(dp) :: found
      integer :: k

      do k = 1, size(ends)
         bell%power = 1
         found = integrate(bell, 0.0_dp, ends(k))
#line 40 "/work/main/tests/numerics/numerics_panels.pf"
  call assertRelativelyEqual(tanh(ends(k)), found, tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_panels.pf', &
 & 40) )
  if (anyExceptions()) return
#line 41 "/work/main/tests/numerics/numerics_panels.pf"
         bell%power = 2
         found = integrate(bell, 0.0_dp, ends(k))
#line 43 "/work/main/tests/numerics/numerics_panels.pf"
  call assertRelativelyEqual(tanh(ends(k)) - tanh(ends(k))**3/3, found, tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_panels.pf', &
 & 43) )
  if (anyExceptions()) return
#line 44 "/work/main/tests/numerics/numerics_panels.pf"
         found = integrate(bell, -ends(k), ends(k))
#line 45 "/work/main/tests/numerics/numerics_panels.pf"
  call assertRelativelyEqual(2*(tanh(ends(k)) - tanh(ends(k))**3/3), found, tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_panels.pf', &
 & 45) )
  if (anyExceptions()) return
#line 46 "/work/main/tests/numerics/numerics_panels.pf"
      end do
   end subroutine test_bells

   ! A range without length has no integral.
   !@test
   subroutine test_no_range()
      type(bell_t) :: bell
      real(dp) :: found

      found = integrate(bell, 1.5_dp, 1.5_dp)
#line 56 "/work/main/tests/numerics/numerics_panels.pf"
  call assertEqual(0.0_dp, found, &
 & location=SourceLocation( &
 & 'numerics_panels.pf', &
 & 56) )
  if (anyExceptions()) return
#line 57 "/work/main/tests/numerics/numerics_panels.pf"
   end subroutine test_no_range

end module numerics_panels

module Wrapnumerics_panels
   use FUnit
   use numerics_panels
   implicit none
   private

contains


end module Wrapnumerics_panels

function numerics_panels_suite() result(suite)
   use FUnit
   use numerics_panels
   use Wrapnumerics_panels
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('numerics_panels_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_bells', &
      test_bells))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_no_range', &
      test_no_range))
   call suite%addTest(t)


end function numerics_panels_suite

