! SPDX-License-Identifier: GPL-3.0-or-later
! Linear problems with an obstacle.
module numerics_obstacle
   use adfric_base_kinds, only: dp
   use adfric_numerics_obstacle, only: solve_above
   use random_dice, only: dice_t, new_dice
   use funit
   implicit none (type, external)

contains

   ! Each x_i obeys its equation or is that of the obstacle, and no less of either.
   !@test
   subroutine test_complementarity()
      type(dice_t) :: dice
      real(dp), allocatable :: matrix(:, :), right(:), obstacle(:), x(:), residual(:)
      real(dp) :: scale
      integer :: i, j, k, n, n_free, n_met
      logical :: is_solved

      call new_dice(dice, 7)
      n_free = 0
      n_met = 0
      do k = 1, 2000
         call dice%choose(20, n)
         allocate (matrix(n, n), right(n), obstacle(n), x(n))
         ! I - J with rows of J that sum up to nearly 1
         call dice%decades(-6.0_dp, 0.0_dp, scale)
         do i = 1, n
            do j = 1, n
               call dice%between(0.0_dp, 1.0_dp, matrix(i, j))
            end do
            matrix(i, :) = -matrix(i, :)/sum(matrix(i, :))*(1 - scale)
            matrix(i, i) = matrix(i, i) + 1
            call dice%between(-1.0_dp, 0.1_dp, right(i))
            call dice%between(-2/scale, 0.0_dp, obstacle(i))
         end do
         call solve_above(matrix, right, obstacle, x, is_solved)
#line 39 "/work/main/tests/numerics/numerics_obstacle.pf"
  call assertTrue(is_solved, &
 & location=SourceLocation( &
 & 'numerics_obstacle.pf', &
 & 39) )
  if (anyExceptions()) return
#line 40 "/work/main/tests/numerics/numerics_obstacle.pf"
         residual = matmul(matrix, x) - right
         do i = 1, n
#line 42 "/work/main/tests/numerics/numerics_obstacle.pf"
  call assertGreaterThanOrEqual(x(i), obstacle(i) - 1.0e-10_dp/scale, &
 & location=SourceLocation( &
 & 'numerics_obstacle.pf', &
 & 42) )
  if (anyExceptions()) return
#line 43 "/work/main/tests/numerics/numerics_obstacle.pf"
#line 43 "/work/main/tests/numerics/numerics_obstacle.pf"
  call assertGreaterThanOrEqual(residual(i), -1.0e-10_dp/scale, &
 & location=SourceLocation( &
 & 'numerics_obstacle.pf', &
 & 43) )
  if (anyExceptions()) return
#line 44 "/work/main/tests/numerics/numerics_obstacle.pf"
#line 44 "/work/main/tests/numerics/numerics_obstacle.pf"
  call assertEqual(0.0_dp, min(x(i) - obstacle(i), residual(i)), tolerance=1.0e-10_dp/scale, &
 & location=SourceLocation( &
 & 'numerics_obstacle.pf', &
 & 44) )
  if (anyExceptions()) return
#line 45 "/work/main/tests/numerics/numerics_obstacle.pf"
            if (x(i) > obstacle(i)) n_free = n_free + 1
            if (.not. x(i) > obstacle(i)) n_met = n_met + 1
         end do
         deallocate (matrix, right, obstacle, x)
      end do
#line 50 "/work/main/tests/numerics/numerics_obstacle.pf"
  call assertGreaterThan(min(n_free, n_met), 2000, &
 & location=SourceLocation( &
 & 'numerics_obstacle.pf', &
 & 50) )
  if (anyExceptions()) return
#line 51 "/work/main/tests/numerics/numerics_obstacle.pf"
   end subroutine test_complementarity

   ! Two unknowns: the first obeys x1 - x2/2 = -1, the second rests on the obstacle.
   !@test
   subroutine test_two_unknowns()
      real(dp) :: x(2)
      logical :: is_solved

      call solve_above(reshape([1.0_dp, -0.5_dp, -0.5_dp, 1.0_dp], [2, 2]), [-1.0_dp, -3.0_dp], [-2.0_dp, -1.0_dp], x, is_solved)
#line 60 "/work/main/tests/numerics/numerics_obstacle.pf"
  call assertTrue(is_solved, &
 & location=SourceLocation( &
 & 'numerics_obstacle.pf', &
 & 60) )
  if (anyExceptions()) return
#line 61 "/work/main/tests/numerics/numerics_obstacle.pf"
#line 61 "/work/main/tests/numerics/numerics_obstacle.pf"
  call assertEqual([-1.5_dp, -1.0_dp], x, tolerance=1.0e-15_dp, &
 & location=SourceLocation( &
 & 'numerics_obstacle.pf', &
 & 61) )
  if (anyExceptions()) return
#line 62 "/work/main/tests/numerics/numerics_obstacle.pf"
   end subroutine test_two_unknowns

   !@test
   subroutine test_singular()
      real(dp) :: x(2)
      logical :: is_solved

      call solve_above(reshape([1.0_dp, -1.0_dp, -1.0_dp, 1.0_dp], [2, 2]), [1.0_dp, 1.0_dp], [0.0_dp, 0.0_dp], x, is_solved)
#line 70 "/work/main/tests/numerics/numerics_obstacle.pf"
  call assertFalse(is_solved, &
 & location=SourceLocation( &
 & 'numerics_obstacle.pf', &
 & 70) )
  if (anyExceptions()) return
#line 71 "/work/main/tests/numerics/numerics_obstacle.pf"
   end subroutine test_singular

end module numerics_obstacle

module Wrapnumerics_obstacle
   use FUnit
   use numerics_obstacle
   implicit none
   private

contains


end module Wrapnumerics_obstacle

function numerics_obstacle_suite() result(suite)
   use FUnit
   use numerics_obstacle
   use Wrapnumerics_obstacle
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('numerics_obstacle_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_complementarity', &
      test_complementarity))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_two_unknowns', &
      test_two_unknowns))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_singular', &
      test_singular))
   call suite%addTest(t)


end function numerics_obstacle_suite

