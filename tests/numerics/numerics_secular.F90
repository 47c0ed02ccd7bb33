! SPDX-License-Identifier: GPL-3.0-or-later
! Roots of secular equations by their distances from the poles. What random spectra ask of them is in tests/material.
module numerics_secular
   use, intrinsic :: iso_fortran_env, only: qp => real128
   use adfric_base_kinds, only: dp
   use adfric_numerics_secular, only: get_root_distances
   use funit
   implicit none (type, external)

   !> Roundings of one distance.
   real(dp), parameter :: few_eps = 8*epsilon(1.0_dp)

contains

   ! One pole: b/(x - a) = c.
   !@test
   subroutine test_one_pole()
      real(dp) :: distance(1)

      call get_root_distances([3.0_dp], [0.0_dp], [5.0_dp], 4.0_dp, 1, distance)
#line 21 "/work/main/tests/numerics/numerics_secular.pf"
  call assertEqual(0.75_dp, distance(1), tolerance=few_eps, &
 & location=SourceLocation( &
 & 'numerics_secular.pf', &
 & 21) )
  if (anyExceptions()) return
#line 22 "/work/main/tests/numerics/numerics_secular.pf"
      call get_root_distances([3.0e-40_dp], [0.0_dp], [-5.0_dp], 4.0_dp, 1, distance)
#line 23 "/work/main/tests/numerics/numerics_secular.pf"
  call assertRelativelyEqual(0.75e-40_dp, distance(1), tolerance=few_eps, &
 & location=SourceLocation( &
 & 'numerics_secular.pf', &
 & 23) )
  if (anyExceptions()) return
#line 24 "/work/main/tests/numerics/numerics_secular.pf"
   end subroutine test_one_pole

   ! Poles at -1 and 1 with the same numerator b: c x^2 - 2 b x - c = 0. The roots are x and -1/x, and x - 1 = r + r^2/(1 + s) with
   ! r = b/c, s = sqrt(r^2 + 1).
   !@test
   subroutine test_two_poles()
      real(dp) :: distances(2), c
      real(qp) :: r, s, above
      integer :: i

      do i = -30, 30
         c = 10.0_dp**i
         r = 1/real(c, qp)
         s = sqrt(r**2 + 1)
         above = r + r**2/(1 + s)
         call get_root_distances([1.0_dp, 1.0_dp], [0.0_dp, 0.0_dp], [-1.0_dp, 1.0_dp], c, 2, distances)
#line 40 "/work/main/tests/numerics/numerics_secular.pf"
  call assertRelativelyEqual(real(above + 2, dp), distances(1), tolerance=few_eps, &
 & location=SourceLocation( &
 & 'numerics_secular.pf', &
 & 40) )
  if (anyExceptions()) return
#line 41 "/work/main/tests/numerics/numerics_secular.pf"
#line 41 "/work/main/tests/numerics/numerics_secular.pf"
  call assertRelativelyEqual(real(above, dp), distances(2), tolerance=few_eps, &
 & location=SourceLocation( &
 & 'numerics_secular.pf', &
 & 41) )
  if (anyExceptions()) return
#line 42 "/work/main/tests/numerics/numerics_secular.pf"
         call get_root_distances([1.0_dp, 1.0_dp], [0.0_dp, 0.0_dp], [-1.0_dp, 1.0_dp], c, 1, distances)
#line 43 "/work/main/tests/numerics/numerics_secular.pf"
  call assertRelativelyEqual(real(above/(1 + above), dp), distances(1), tolerance=few_eps, &
 & location=SourceLocation( &
 & 'numerics_secular.pf', &
 & 43) )
  if (anyExceptions()) return
#line 44 "/work/main/tests/numerics/numerics_secular.pf"
#line 44 "/work/main/tests/numerics/numerics_secular.pf"
  call assertRelativelyEqual(real(-(above + 2)/(1 + above), dp), distances(2), tolerance=few_eps, &
 & location=SourceLocation( &
 & 'numerics_secular.pf', &
 & 44) )
  if (anyExceptions()) return
#line 45 "/work/main/tests/numerics/numerics_secular.pf"
      end do
   end subroutine test_two_poles

   ! At a weak pole all that the others do, 4/2 - 6/6, cancels with the right-hand side, but for the rest of a numerator:
   ! weak/y = rest/2 + y (1 + 1/6) + ..., of which the second term is too small to be seen.
   !@test
   subroutine test_cancellation()
      real(dp) :: distances(3)
      real(dp), parameter :: weak = 2.0_dp**(-200), rest = 2.0_dp**(-60)

      call get_root_distances([4.0_dp, weak, 6.0_dp], [-rest, 0.0_dp, 0.0_dp], [-2.0_dp, 0.0_dp, 6.0_dp], 1.0_dp, 2, distances)
#line 56 "/work/main/tests/numerics/numerics_secular.pf"
  call assertRelativelyEqual(2*weak/rest, distances(2), tolerance=few_eps, &
 & location=SourceLocation( &
 & 'numerics_secular.pf', &
 & 56) )
  if (anyExceptions()) return
#line 57 "/work/main/tests/numerics/numerics_secular.pf"
#line 57 "/work/main/tests/numerics/numerics_secular.pf"
  call assertRelativelyEqual(2.0_dp, distances(1), tolerance=few_eps, &
 & location=SourceLocation( &
 & 'numerics_secular.pf', &
 & 57) )
  if (anyExceptions()) return
#line 58 "/work/main/tests/numerics/numerics_secular.pf"
#line 58 "/work/main/tests/numerics/numerics_secular.pf"
  call assertRelativelyEqual(-6.0_dp, distances(3), tolerance=few_eps, &
 & location=SourceLocation( &
 & 'numerics_secular.pf', &
 & 58) )
  if (anyExceptions()) return
#line 59 "/work/main/tests/numerics/numerics_secular.pf"
   end subroutine test_cancellation

   ! Neighbours that differ in their last digit: the root is between them, where the numerators put it.
   !@test
   subroutine test_neighbours()
      real(dp) :: distances(2), gap
      real(dp), parameter :: first = 3.0_dp

      gap = spacing(first)
      ! 1/y = 3/(gap - y): y = gap/4
      call get_root_distances([1.0_dp, 3.0_dp], [0.0_dp, 0.0_dp], [first, first + gap], 1.0_dp, 1, distances)
#line 70 "/work/main/tests/numerics/numerics_secular.pf"
  call assertEqual([0.25_dp, -0.75_dp], distances/gap, tolerance=2*few_eps, &
 & location=SourceLocation( &
 & 'numerics_secular.pf', &
 & 70) )
  if (anyExceptions()) return
#line 71 "/work/main/tests/numerics/numerics_secular.pf"
   end subroutine test_neighbours

end module numerics_secular

module Wrapnumerics_secular
   use FUnit
   use numerics_secular
   implicit none
   private

contains


end module Wrapnumerics_secular

function numerics_secular_suite() result(suite)
   use FUnit
   use numerics_secular
   use Wrapnumerics_secular
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('numerics_secular_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_one_pole', &
      test_one_pole))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_two_poles', &
      test_two_poles))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_cancellation', &
      test_cancellation))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_neighbours', &
      test_neighbours))
   call suite%addTest(t)


end function numerics_secular_suite

