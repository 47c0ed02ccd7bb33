! SPDX-License-Identifier: GPL-3.0-or-later
! Least squares with unknowns that are not negative.
module numerics_non_negative
   use, intrinsic :: iso_fortran_env, only: qp => real128
   use adfric_base_kinds, only: dp
   use adfric_numerics_non_negative, only: solve_non_negative
   use random_dice, only: dice_t, new_dice
   use funit
   implicit none (type, external)

   !> Roundings of a small well-conditioned problem.
   real(dp), parameter :: few_eps = 50*epsilon(1.0_dp)

contains

   ! Solve, which must be proved.
   subroutine solve(a, b, x)
      real(dp), intent(in) :: a(:, :), b(:)
      real(dp), intent(out) :: x(:)
      logical :: is_solved

      call solve_non_negative(a, b, x, is_solved)
#line 23 "/work/main/tests/numerics/numerics_non_negative.pf"
  call assertTrue(is_solved, &
 & location=SourceLocation( &
 & 'numerics_non_negative.pf', &
 & 23) )
  if (anyExceptions()) return
#line 24 "/work/main/tests/numerics/numerics_non_negative.pf"
#line 24 "/work/main/tests/numerics/numerics_non_negative.pf"
  call assertTrue(all(x >= 0), &
 & location=SourceLocation( &
 & 'numerics_non_negative.pf', &
 & 24) )
  if (anyExceptions()) return
#line 25 "/work/main/tests/numerics/numerics_non_negative.pf"
   end subroutine solve

   ! A point of the plane, and the nearest one of a quadrant: inside, beside and behind it.
   !@test
   subroutine test_quadrant()
      real(dp), parameter :: a(2, 2) = reshape([2.0_dp, 0.0_dp, 0.0_dp, 4.0_dp], [2, 2])
      real(dp) :: x(2)

      call solve(a, [1.0_dp, 1.0_dp], x)
#line 34 "/work/main/tests/numerics/numerics_non_negative.pf"
  call assertEqual([0.5_dp, 0.25_dp], x, tolerance=few_eps, &
 & location=SourceLocation( &
 & 'numerics_non_negative.pf', &
 & 34) )
  if (anyExceptions()) return
#line 35 "/work/main/tests/numerics/numerics_non_negative.pf"
      call solve(a, [1.0_dp, -1.0_dp], x)
#line 36 "/work/main/tests/numerics/numerics_non_negative.pf"
  call assertEqual([0.5_dp, 0.0_dp], x, tolerance=few_eps, &
 & location=SourceLocation( &
 & 'numerics_non_negative.pf', &
 & 36) )
  if (anyExceptions()) return
#line 37 "/work/main/tests/numerics/numerics_non_negative.pf"
      call solve(a, [-1.0_dp, -1.0_dp], x)
#line 38 "/work/main/tests/numerics/numerics_non_negative.pf"
  call assertEqual([0.0_dp, 0.0_dp], x, tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'numerics_non_negative.pf', &
 & 38) )
  if (anyExceptions()) return
#line 39 "/work/main/tests/numerics/numerics_non_negative.pf"
   end subroutine test_quadrant

   ! The nearest point of the edge of a sharp cone: the least squares without bounds have one negative unknown, and putting this
   ! to 0 changes the other. Columns (1, 0) and (1, 1), b = (1, -1): the foot on (1, 0) is 1; on both it is (2, -1).
   !@test
   subroutine test_cone()
      real(dp) :: x(2)

      call solve(reshape([1.0_dp, 0.0_dp, 1.0_dp, 1.0_dp], [2, 2]), [1.0_dp, -1.0_dp], x)
#line 48 "/work/main/tests/numerics/numerics_non_negative.pf"
  call assertEqual([1.0_dp, 0.0_dp], x, tolerance=few_eps, &
 & location=SourceLocation( &
 & 'numerics_non_negative.pf', &
 & 48) )
  if (anyExceptions()) return
#line 49 "/work/main/tests/numerics/numerics_non_negative.pf"
   end subroutine test_cone

   ! An unknown that enters first and must leave again: a column near b, and two on its sides that hold b between them.
   !@test
   subroutine test_leaves_again()
      real(dp), parameter :: a(3, 3) = reshape([1.0_dp, 1.0_dp, 0.1_dp, 1.0_dp, 0.0_dp, 0.0_dp, 0.0_dp, 1.0_dp, 0.0_dp], [3, 3])
      real(dp) :: x(3)

      call solve(a, [1.0_dp, 1.0_dp, -0.1_dp], x)
#line 58 "/work/main/tests/numerics/numerics_non_negative.pf"
  call assertEqual([0.0_dp, 1.0_dp, 1.0_dp], x, tolerance=few_eps, &
 & location=SourceLocation( &
 & 'numerics_non_negative.pf', &
 & 58) )
  if (anyExceptions()) return
#line 59 "/work/main/tests/numerics/numerics_non_negative.pf"
   end subroutine test_leaves_again

   ! Nothing to fit, nothing to fit with, columns of zeros, and the same column twice.
   !@test
   subroutine test_degenerate()
      real(dp), parameter :: zeros(3, 2) = 0
      real(dp) :: x(2), none(0), a(3, 4), four(4)

      call solve(zeros, [1.0_dp, 2.0_dp, 3.0_dp], x)
#line 68 "/work/main/tests/numerics/numerics_non_negative.pf"
  call assertEqual([0.0_dp, 0.0_dp], x, tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'numerics_non_negative.pf', &
 & 68) )
  if (anyExceptions()) return
#line 69 "/work/main/tests/numerics/numerics_non_negative.pf"
      call solve(zeros(:, :0), [1.0_dp, 2.0_dp, 3.0_dp], none)
      a = spread([1.0_dp, 2.0_dp, 3.0_dp], 2, 4)
      a(:, 2) = 0
      call solve(a, [0.0_dp, 0.0_dp, 0.0_dp], four)
#line 73 "/work/main/tests/numerics/numerics_non_negative.pf"
  call assertEqual(0.0_dp, sum(four), tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'numerics_non_negative.pf', &
 & 73) )
  if (anyExceptions()) return
#line 74 "/work/main/tests/numerics/numerics_non_negative.pf"
      call solve(a, [2.0_dp, 4.0_dp, 6.0_dp], four)
#line 75 "/work/main/tests/numerics/numerics_non_negative.pf"
  call assertEqual(2.0_dp, sum(four), tolerance=few_eps, &
 & location=SourceLocation( &
 & 'numerics_non_negative.pf', &
 & 75) )
  if (anyExceptions()) return
#line 76 "/work/main/tests/numerics/numerics_non_negative.pf"
#line 76 "/work/main/tests/numerics/numerics_non_negative.pf"
  call assertEqual(0.0_dp, four(2), tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'numerics_non_negative.pf', &
 & 76) )
  if (anyExceptions()) return
#line 77 "/work/main/tests/numerics/numerics_non_negative.pf"
   end subroutine test_degenerate

   ! More unknowns than equations: some solution of no residual.
   !@test
   subroutine test_more_unknowns()
      real(dp) :: a(2, 5), x(5)

      a = reshape([1.0_dp, 0.0_dp, 0.8_dp, 0.3_dp, 0.5_dp, 0.5_dp, 0.2_dp, 0.9_dp, 0.0_dp, 1.0_dp], [2, 5])
      call solve(a, [3.0_dp, 2.0_dp], x)
#line 86 "/work/main/tests/numerics/numerics_non_negative.pf"
  call assertEqual([3.0_dp, 2.0_dp], matmul(a, x), tolerance=few_eps, &
 & location=SourceLocation( &
 & 'numerics_non_negative.pf', &
 & 86) )
  if (anyExceptions()) return
#line 87 "/work/main/tests/numerics/numerics_non_negative.pf"
   end subroutine test_more_unknowns

   ! Other units of columns and right-hand side, far apart.
   !@test
   subroutine test_units()
      real(dp), parameter :: a(3, 2) = reshape([1.0_dp, 2.0_dp, 3.0_dp, 3.0_dp, 1.0_dp, 0.5_dp], [3, 2])
      real(dp), parameter :: b(3) = [4.0_dp, 3.0_dp, 2.0_dp]
      real(dp), parameter :: units(2) = [2.0_dp**300, 2.0_dp**(-300)], unit = 2.0_dp**100
      real(dp) :: x(2), y(2)

      call solve(a, b, x)
      call solve(a*spread(units, 1, 3), b*unit, y)
#line 99 "/work/main/tests/numerics/numerics_non_negative.pf"
  call assertEqual(x*unit, y*units, tolerance=4*unit*epsilon(1.0_dp), &
 & location=SourceLocation( &
 & 'numerics_non_negative.pf', &
 & 99) )
  if (anyExceptions()) return
#line 100 "/work/main/tests/numerics/numerics_non_negative.pf"
   end subroutine test_units

   ! Random problems of all shapes, noisy or exact, with columns alike or not. The conditions of a solution in four-fold precision:
   ! nothing is gained by any unknown that is 0, and the others are least squares.
   !@test
   subroutine test_random()
      type(dice_t) :: dice
      real(dp), allocatable :: a(:, :), b(:), x(:)
      real(qp), allocatable :: gradient(:)
      real(dp) :: bound
      integer :: trial
      character(20) :: label

      call new_dice(dice, 6)
      do trial = 1, 600
         write (label, '(a, i0)') 'trial ', trial
         call draw(dice, trial, a, b)
         if (allocated(x)) deallocate (x)
         allocate (x(size(a, 2)))
         call solve(a, b, x)
         gradient = matmul(real(b, qp) - matmul(real(a, qp), real(x, qp)), real(a, qp))/norm2(a, 1)/norm2(b)
         ! the proof allows 100 n epsilon, of which the rounding of the triangle and of the unknowns is a part
         bound = 200*size(x)*epsilon(1.0_dp)
#line 123 "/work/main/tests/numerics/numerics_non_negative.pf"
  call assertLessThan(real(maxval(gradient), dp), bound, message=label, &
 & location=SourceLocation( &
 & 'numerics_non_negative.pf', &
 & 123) )
  if (anyExceptions()) return
#line 124 "/work/main/tests/numerics/numerics_non_negative.pf"
#line 124 "/work/main/tests/numerics/numerics_non_negative.pf"
  call assertLessThan(real(maxval(abs(merge(gradient, 0.0_qp, x > 0))), dp), bound, message=label, &
 & location=SourceLocation( &
 & 'numerics_non_negative.pf', &
 & 124) )
  if (anyExceptions()) return
#line 125 "/work/main/tests/numerics/numerics_non_negative.pf"
      end do
   end subroutine test_random

   ! A problem: rows and columns of any number, columns that are random, alike, or decays of neighbouring rates.
   subroutine draw(dice, trial, a, b)
      type(dice_t), intent(inout) :: dice
      integer, intent(in) :: trial
      real(dp), allocatable, intent(out) :: a(:, :), b(:)
      integer :: m, n, i, j
      real(dp) :: noise, value

      call dice%choose(60, m)
      call dice%choose(40, n)
      allocate (a(m, n), b(m))
      do j = 1, n
         do i = 1, m
            call dice%between(-1.0_dp, 1.0_dp, a(i, j))
            if (modulo(trial, 3) == 1) a(i, j) = 1 + 1.0e-6_dp*a(i, j)
            if (modulo(trial, 3) == 2) a(i, j) = exp(-10.0_dp**(-3 + 4.0_dp*j/n)*i)
         end do
      end do
      call dice%decades(-15.0_dp, 1.0_dp, noise)
      do i = 1, m
         call dice%between(-noise, noise, value)
         b(i) = sum(a(i, ::2)) + value
      end do
   end subroutine draw

end module numerics_non_negative

module Wrapnumerics_non_negative
   use FUnit
   use numerics_non_negative
   implicit none
   private

contains


end module Wrapnumerics_non_negative

function numerics_non_negative_suite() result(suite)
   use FUnit
   use numerics_non_negative
   use Wrapnumerics_non_negative
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('numerics_non_negative_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_quadrant', &
      test_quadrant))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_cone', &
      test_cone))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_leaves_again', &
      test_leaves_again))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_degenerate', &
      test_degenerate))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_more_unknowns', &
      test_more_unknowns))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_units', &
      test_units))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_random', &
      test_random))
   call suite%addTest(t)


end function numerics_non_negative_suite

