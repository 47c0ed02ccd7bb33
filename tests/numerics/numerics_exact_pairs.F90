! SPDX-License-Identifier: GPL-3.0-or-later
! Pairs of numbers against four-fold precision, which holds any product and the sum of numbers that are not too far apart.
module numerics_exact_pairs
   use, intrinsic :: iso_fortran_env, only: qp => real128
   use adfric_base_kinds, only: dp
   use adfric_numerics_exact_pairs, only: get_sum, get_product, get_quotient
   use random_dice, only: dice_t, new_dice
   use funit
   implicit none (type, external)

   integer, parameter :: n_trials = 2000

contains

   ! A sum has no error at all, whichever number is larger and whatever cancels.
   !@test
   subroutine test_sums()
      type(dice_t) :: dice
      real(dp) :: x, y, total, rest
      integer :: trial

      call new_dice(dice, 8)
      do trial = 1, n_trials
         call draw(dice, 8.0_dp, x)
         call draw(dice, 8.0_dp, y)
         if (modulo(trial, 4) == 0) y = -nearest(x, 1.0_dp)
         call get_sum(x, y, total, rest)
#line 28 "/work/main/tests/numerics/numerics_exact_pairs.pf"
  call assertEqual(x + y, total, tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'numerics_exact_pairs.pf', &
 & 28) )
  if (anyExceptions()) return
#line 29 "/work/main/tests/numerics/numerics_exact_pairs.pf"
#line 29 "/work/main/tests/numerics/numerics_exact_pairs.pf"
  call assertTrue(real(total, qp) + rest == real(x, qp) + y, &
 & location=SourceLocation( &
 & 'numerics_exact_pairs.pf', &
 & 29) )
  if (anyExceptions()) return
#line 30 "/work/main/tests/numerics/numerics_exact_pairs.pf"
      end do
   end subroutine test_sums

   ! Nor has a product.
   !@test
   subroutine test_products()
      type(dice_t) :: dice
      real(dp) :: x, y, total, rest
      integer :: trial

      call new_dice(dice, 9)
      do trial = 1, n_trials
         call draw(dice, 100.0_dp, x)
         call draw(dice, 30.0_dp, y)
         call get_product(x, y, total, rest)
#line 45 "/work/main/tests/numerics/numerics_exact_pairs.pf"
  call assertEqual(x*y, total, tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'numerics_exact_pairs.pf', &
 & 45) )
  if (anyExceptions()) return
#line 46 "/work/main/tests/numerics/numerics_exact_pairs.pf"
#line 46 "/work/main/tests/numerics/numerics_exact_pairs.pf"
  call assertTrue(real(total, qp) + rest == real(x, qp)*y, &
 & location=SourceLocation( &
 & 'numerics_exact_pairs.pf', &
 & 46) )
  if (anyExceptions()) return
#line 47 "/work/main/tests/numerics/numerics_exact_pairs.pf"
      end do
      call get_product(0.0_dp, 3.0_dp, total, rest)
#line 49 "/work/main/tests/numerics/numerics_exact_pairs.pf"
  call assertEqual([0.0_dp, 0.0_dp], [total, rest], tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'numerics_exact_pairs.pf', &
 & 49) )
  if (anyExceptions()) return
#line 50 "/work/main/tests/numerics/numerics_exact_pairs.pf"
   end subroutine test_products

   ! A quotient of pairs is right to some squares of epsilon.
   !@test
   subroutine test_quotients()
      type(dice_t) :: dice
      real(dp) :: x, y, x_rest, y_rest, total, rest
      real(qp) :: exact
      integer :: trial
      real(dp), parameter :: squares = 4*epsilon(1.0_dp)**2

      call new_dice(dice, 10)
      do trial = 1, n_trials
         call draw(dice, 30.0_dp, x)
         call draw(dice, 30.0_dp, y)
         call dice%between(-0.5_dp*spacing(x), 0.5_dp*spacing(x), x_rest)
         call dice%between(-0.5_dp*spacing(y), 0.5_dp*spacing(y), y_rest)
         call get_quotient(x, x_rest, y, y_rest, total, rest)
         exact = (real(x, qp) + x_rest)/(real(y, qp) + y_rest)
#line 69 "/work/main/tests/numerics/numerics_exact_pairs.pf"
  call assertLessThan(real(abs((total - exact) + rest)/abs(exact), dp), squares, &
 & location=SourceLocation( &
 & 'numerics_exact_pairs.pf', &
 & 69) )
  if (anyExceptions()) return
#line 70 "/work/main/tests/numerics/numerics_exact_pairs.pf"
      end do
   end subroutine test_quotients

   ! A number of either sign, over some decades about 1.
   subroutine draw(dice, decades, x)
      type(dice_t), intent(inout) :: dice
      real(dp), intent(in) :: decades
      real(dp), intent(out) :: x
      logical :: is_negative

      call dice%decades(-decades/2, decades/2, x)
      call dice%happens(0.5_dp, is_negative)
      if (is_negative) x = -x
   end subroutine draw

end module numerics_exact_pairs

module Wrapnumerics_exact_pairs
   use FUnit
   use numerics_exact_pairs
   implicit none
   private

contains


end module Wrapnumerics_exact_pairs

function numerics_exact_pairs_suite() result(suite)
   use FUnit
   use numerics_exact_pairs
   use Wrapnumerics_exact_pairs
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('numerics_exact_pairs_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_sums', &
      test_sums))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_products', &
      test_products))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_quotients', &
      test_quotients))
   call suite%addTest(t)


end function numerics_exact_pairs_suite

