! SPDX-License-Identifier: GPL-3.0-or-later
! Relaxation spectra: what becomes of the arms, and the complex modulus at any frequency.
module material_prony
   use, intrinsic :: iso_fortran_env, only: qp => real128
   use adfric_base_kinds, only: dp
   use adfric_material_prony, only: prony_t, new_prony, most_arms
   use random_dice, only: dice_t, new_dice
   use funit
   implicit none (type, external)

   !> Roundings of a sum of terms, each of which has some of its own.
   real(dp), parameter :: few_eps = 20*epsilon(1.0_dp)

contains

   ! Arms are sorted; those of equal times are one; those without a modulus are gone.
   !@test
   subroutine test_arms()
      type(prony_t) :: prony

      call new_prony(prony, 2.0_dp, [4.0_dp, 0.0_dp, 1.0_dp, 8.0_dp, 16.0_dp, 32.0_dp], &
         [3.0_dp, 0.5_dp, 1.0_dp, 3.0_dp, 2.0_dp, 1.0_dp])
#line 23 "/work/main/tests/material/material_prony.pf"
  call assertEqual([33.0_dp, 16.0_dp, 12.0_dp], prony%moduli, tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'material_prony.pf', &
 & 23) )
  if (anyExceptions()) return
#line 24 "/work/main/tests/material/material_prony.pf"
#line 24 "/work/main/tests/material/material_prony.pf"
  call assertEqual([1.0_dp, 2.0_dp, 3.0_dp], prony%times, tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'material_prony.pf', &
 & 24) )
  if (anyExceptions()) return
#line 25 "/work/main/tests/material/material_prony.pf"
#line 25 "/work/main/tests/material/material_prony.pf"
  call assertEqual(63.0_dp, prony%instantaneous_modulus(), tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'material_prony.pf', &
 & 25) )
  if (anyExceptions()) return
#line 26 "/work/main/tests/material/material_prony.pf"
      ! times that differ in the last digit are one, others remain two
      call new_prony(prony, 2.0_dp, [1.0_dp, 4.0_dp], [nearest(3.0_dp, 1.0_dp), 3.0_dp])
#line 28 "/work/main/tests/material/material_prony.pf"
  call assertEqual([5.0_dp], prony%moduli, tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'material_prony.pf', &
 & 28) )
  if (anyExceptions()) return
#line 29 "/work/main/tests/material/material_prony.pf"
#line 29 "/work/main/tests/material/material_prony.pf"
  call assertRelativelyEqual(3.0_dp, prony%times(1), tolerance=2*epsilon(1.0_dp), &
 & location=SourceLocation( &
 & 'material_prony.pf', &
 & 29) )
  if (anyExceptions()) return
#line 30 "/work/main/tests/material/material_prony.pf"
      call new_prony(prony, 2.0_dp, [1.0_dp, 4.0_dp], 3.0_dp*[1 + 20*epsilon(1.0_dp), 1.0_dp])
#line 31 "/work/main/tests/material/material_prony.pf"
  call assertEqual([4.0_dp, 1.0_dp], prony%moduli, tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'material_prony.pf', &
 & 31) )
  if (anyExceptions()) return
#line 32 "/work/main/tests/material/material_prony.pf"
   end subroutine test_arms

   ! Without arms there is a spring.
   !@test
   subroutine test_spring()
      type(prony_t) :: prony
      real(dp) :: storage, loss

      call new_prony(prony, 3.0_dp, [0.0_dp, 0.0_dp], [1.0_dp, 2.0_dp])
#line 41 "/work/main/tests/material/material_prony.pf"
  call assertEqual(0, size(prony%moduli), &
 & location=SourceLocation( &
 & 'material_prony.pf', &
 & 41) )
  if (anyExceptions()) return
#line 42 "/work/main/tests/material/material_prony.pf"
#line 42 "/work/main/tests/material/material_prony.pf"
  call assertEqual(3.0_dp, prony%instantaneous_modulus(), tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'material_prony.pf', &
 & 42) )
  if (anyExceptions()) return
#line 43 "/work/main/tests/material/material_prony.pf"
      call prony%get_complex_modulus(5.0_dp, storage, loss)
#line 44 "/work/main/tests/material/material_prony.pf"
  call assertEqual([3.0_dp, 0.0_dp], [storage, loss], tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'material_prony.pf', &
 & 44) )
  if (anyExceptions()) return
#line 45 "/work/main/tests/material/material_prony.pf"
   end subroutine test_spring

   ! Both moduli to round-off in relative terms, of any number of arms over 18 decades of times, far beyond both ends of these.
   !@test
   subroutine test_random_spectra()
      type(prony_t) :: prony
      type(dice_t) :: dice
      real(dp) :: frequency, storage, loss
      real(qp) :: x(most_arms), exact_storage, exact_loss
      real(dp) :: moduli(most_arms), times(most_arms)
      integer :: i, n, trial

      call new_dice(dice, 1)
      do trial = 1, 500
         n = 1 + modulo(trial, most_arms)
         do i = 1, n
            call dice%decades(-3.0_dp, 3.0_dp, moduli(i))
            call dice%decades(-9.0_dp, 9.0_dp, times(i))
         end do
         call new_prony(prony, 0.1_dp, moduli(:n), times(:n))
         call dice%decades(-30.0_dp, 30.0_dp, frequency)
         call prony%get_complex_modulus(frequency, storage, loss)
         x(:n) = real(frequency, qp)*prony%times
         exact_storage = 0.1_dp + sum(prony%moduli*x(:n)**2/(1 + x(:n)**2))
         exact_loss = sum(prony%moduli*x(:n)/(1 + x(:n)**2))
#line 70 "/work/main/tests/material/material_prony.pf"
  call assertEqual(1.0_dp, real(storage/exact_storage, dp), tolerance=few_eps, &
 & location=SourceLocation( &
 & 'material_prony.pf', &
 & 70) )
  if (anyExceptions()) return
#line 71 "/work/main/tests/material/material_prony.pf"
#line 71 "/work/main/tests/material/material_prony.pf"
  call assertEqual(1.0_dp, real(loss/exact_loss, dp), tolerance=few_eps, &
 & location=SourceLocation( &
 & 'material_prony.pf', &
 & 71) )
  if (anyExceptions()) return
#line 72 "/work/main/tests/material/material_prony.pf"
      end do
   end subroutine test_random_spectra

   ! The ends of all frequencies: at rest, and where omega tau and its square would overflow. Loss is k omega tau at one end,
   ! k/(omega tau) at the other.
   !@test
   subroutine test_extreme_frequencies()
      type(prony_t) :: prony
      real(dp) :: storage, loss

      call new_prony(prony, 1.0_dp, [2.0_dp, 4.0_dp], [1.0e-3_dp, 1.0e12_dp])
      call prony%get_complex_modulus(0.0_dp, storage, loss)
#line 84 "/work/main/tests/material/material_prony.pf"
  call assertEqual([1.0_dp, 0.0_dp], [storage, loss], tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'material_prony.pf', &
 & 84) )
  if (anyExceptions()) return
#line 85 "/work/main/tests/material/material_prony.pf"
      call prony%get_complex_modulus(1.0e-250_dp, storage, loss)
#line 86 "/work/main/tests/material/material_prony.pf"
  call assertEqual(1.0_dp, storage, tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'material_prony.pf', &
 & 86) )
  if (anyExceptions()) return
#line 87 "/work/main/tests/material/material_prony.pf"
#line 87 "/work/main/tests/material/material_prony.pf"
  call assertEqual(1.0_dp, loss/4.0e-238_dp, tolerance=few_eps, &
 & location=SourceLocation( &
 & 'material_prony.pf', &
 & 87) )
  if (anyExceptions()) return
#line 88 "/work/main/tests/material/material_prony.pf"
      call prony%get_complex_modulus(1.0e300_dp, storage, loss)
#line 89 "/work/main/tests/material/material_prony.pf"
  call assertEqual(7.0_dp, storage, tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'material_prony.pf', &
 & 89) )
  if (anyExceptions()) return
#line 90 "/work/main/tests/material/material_prony.pf"
#line 90 "/work/main/tests/material/material_prony.pf"
  call assertEqual(1.0_dp, loss/2.0e-297_dp, tolerance=few_eps, &
 & location=SourceLocation( &
 & 'material_prony.pf', &
 & 90) )
  if (anyExceptions()) return
#line 91 "/work/main/tests/material/material_prony.pf"
   end subroutine test_extreme_frequencies

   ! Many frequencies in one call.
   !@test
   subroutine test_frequencies()
      type(prony_t) :: prony
      real(dp) :: storage(3), loss(3)

      call new_prony(prony, 1.0_dp, [2.0_dp], [0.5_dp])
      call prony%get_complex_modulus([1.0_dp, 2.0_dp, 4.0_dp], storage, loss)
      ! k x^2/(1 + x^2) and k x/(1 + x^2) at x = 1/2, 1, 2
#line 102 "/work/main/tests/material/material_prony.pf"
  call assertEqual([1.4_dp, 2.0_dp, 2.6_dp], storage, tolerance=few_eps, &
 & location=SourceLocation( &
 & 'material_prony.pf', &
 & 102) )
  if (anyExceptions()) return
#line 103 "/work/main/tests/material/material_prony.pf"
#line 103 "/work/main/tests/material/material_prony.pf"
  call assertEqual([0.8_dp, 1.0_dp, 0.8_dp], loss, tolerance=few_eps, &
 & location=SourceLocation( &
 & 'material_prony.pf', &
 & 103) )
  if (anyExceptions()) return
#line 104 "/work/main/tests/material/material_prony.pf"
   end subroutine test_frequencies

end module material_prony

module Wrapmaterial_prony
   use FUnit
   use material_prony
   implicit none
   private

contains


end module Wrapmaterial_prony

function material_prony_suite() result(suite)
   use FUnit
   use material_prony
   use Wrapmaterial_prony
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('material_prony_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_arms', &
      test_arms))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_spring', &
      test_spring))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_random_spectra', &
      test_random_spectra))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_extreme_frequencies', &
      test_extreme_frequencies))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_frequencies', &
      test_frequencies))
   call suite%addTest(t)


end function material_prony_suite

