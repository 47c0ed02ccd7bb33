! SPDX-License-Identifier: GPL-3.0-or-later
! The modulus of a history that is linear between samples: against the history itself, the sum over aliases, and its limits.
module material_sampled_modulus
   use adfric_base_kinds, only: dp
   use adfric_material_prony, only: prony_t, new_prony
   use adfric_material_sampled_modulus, only: sampled_modulus
   use funit
   implicit none (type, external)

   real(dp), parameter :: pi = acos(-1.0_dp), round_off = 1.0e-13_dp

contains

   subroutine make_solid(prony)
      type(prony_t), intent(out) :: prony

      call new_prony(prony, 2.0_dp, [3.0_dp, 50.0_dp, 7.0_dp], [10.0_dp, 1.0_dp, 1.0e-3_dp])
   end subroutine make_solid

   ! The arms march along the samples of a wave until they have forgotten the beginning.
   !@test
   subroutine test_march()
      real(dp), parameter :: intervals(*) = [1.0e-2_dp, 0.3_dp, 4.0_dp, 1.0e3_dp], phases(*) = [-3.0_dp, -0.2_dp, 1.0e-3_dp, 1.3_dp]
      type(prony_t) :: prony
      complex(dp) :: stress(3), strain, last, found
      real(dp) :: kept(3)
      integer :: i, k, j, n

      call make_solid(prony)
      do i = 1, size(intervals)
         kept = exp(-intervals(i)/prony%times)
         n = int(40/minval(intervals(i)/prony%times)) + 2
         do k = 1, size(phases)
            stress = 0
            strain = 1
            do j = 1, n
               last = strain
               strain = exp(cmplx(0.0_dp, -j*phases(k), dp))
               stress = kept*stress + prony%moduli*((1 - kept)/(intervals(i)/prony%times))*(strain - last)
            end do
            found = sampled_modulus(prony, intervals(i), phases(k))
#line 42 "/work/main/tests/material/material_sampled_modulus.pf"
  call assertEqual(0.0_dp, abs((2 + sum(stress)/strain)/found - 1), tolerance=1.0e-11_dp, &
 & location=SourceLocation( &
 & 'material_sampled_modulus.pf', &
 & 42) )
  if (anyExceptions()) return
#line 43 "/work/main/tests/material/material_sampled_modulus.pf"
         end do
      end do
   end subroutine test_march

   ! It is the mean over all waves that have the same samples; what is left out falls with the number of waves.
   !@test
   subroutine test_aliases()
      integer, parameter :: most = 20000
      real(dp), parameter :: interval = 0.4_dp, phase = 2.1_dp
      type(prony_t) :: prony
      complex(dp) :: total
      real(dp) :: frequency, storage, loss, weights
      integer :: m

      call make_solid(prony)
      total = 0
      weights = 0
      do m = -most, most
         frequency = -(phase + 2*pi*m)/interval
         call prony%get_complex_modulus(abs(frequency), storage, loss)
         total = total + cmplx(storage, sign(loss, frequency), dp)/frequency**2
         weights = weights + 1/frequency**2
      end do
#line 66 "/work/main/tests/material/material_sampled_modulus.pf"
  call assertEqual(0.0_dp, abs(total/weights/sampled_modulus(prony, interval, phase) - 1), tolerance=1.0_dp/most, &
 & location=SourceLocation( &
 & 'material_sampled_modulus.pf', &
 & 66) )
  if (anyExceptions()) return
#line 67 "/work/main/tests/material/material_sampled_modulus.pf"
   end subroutine test_aliases

   ! Slow samples meet the relaxed modulus, fast ones that of the first moment, and those of one phase the relaxed one always.
   !@test
   subroutine test_limits()
      type(prony_t) :: prony
      complex(dp) :: difference

      call make_solid(prony)
#line 76 "/work/main/tests/material/material_sampled_modulus.pf"
  call assertEqual(2.0_dp, abs(sampled_modulus(prony, 1.0e30_dp, 1.0_dp)), tolerance=round_off, &
 & location=SourceLocation( &
 & 'material_sampled_modulus.pf', &
 & 76) )
  if (anyExceptions()) return
#line 77 "/work/main/tests/material/material_sampled_modulus.pf"
#line 77 "/work/main/tests/material/material_sampled_modulus.pf"
  call assertEqual(62.0_dp, abs(sampled_modulus(prony, 1.0e-30_dp, 1.0_dp)), tolerance=100*round_off, &
 & location=SourceLocation( &
 & 'material_sampled_modulus.pf', &
 & 77) )
  if (anyExceptions()) return
#line 78 "/work/main/tests/material/material_sampled_modulus.pf"
#line 78 "/work/main/tests/material/material_sampled_modulus.pf"
  call assertEqual(62.0_dp, abs(sampled_modulus(prony, tiny(1.0_dp), -1.0_dp)), tolerance=100*round_off, &
 & location=SourceLocation( &
 & 'material_sampled_modulus.pf', &
 & 78) )
  if (anyExceptions()) return
#line 79 "/work/main/tests/material/material_sampled_modulus.pf"
#line 79 "/work/main/tests/material/material_sampled_modulus.pf"
  call assertEqual(2.0_dp, abs(sampled_modulus(prony, 0.1_dp, 0.0_dp)), tolerance=round_off, &
 & location=SourceLocation( &
 & 'material_sampled_modulus.pf', &
 & 79) )
  if (anyExceptions()) return
#line 80 "/work/main/tests/material/material_sampled_modulus.pf"
      difference = sampled_modulus(prony, 0.1_dp, 0.7_dp) - conjg(sampled_modulus(prony, 0.1_dp, -0.7_dp))
#line 81 "/work/main/tests/material/material_sampled_modulus.pf"
  call assertEqual(0.0_dp, abs(difference), tolerance=100*round_off, &
 & location=SourceLocation( &
 & 'material_sampled_modulus.pf', &
 & 81) )
  if (anyExceptions()) return
#line 82 "/work/main/tests/material/material_sampled_modulus.pf"
   end subroutine test_limits

   ! A sample pushes back itself and is helped by all before it, and none after it counts.
   !@test
   subroutine test_past_alone()
      integer, parameter :: n = 64
      real(dp), parameter :: intervals(*) = [1.0e-4_dp, 1.0e-2_dp, 0.5_dp, 30.0_dp]
      type(prony_t) :: prony
      real(dp) :: answer(0:n - 1)
      integer :: i, j, k

      call new_prony(prony, 2.0_dp, [3.0_dp, 500.0_dp], [1.0e-2_dp, 1.0e-3_dp])
      do i = 1, size(intervals)
         do j = 0, n - 1
            ! the phase falls with time: the sample j intervals before has the phase j theta more
            answer(j) = 0
            do k = 0, n - 1
               answer(j) = answer(j) + real(sampled_modulus(prony, intervals(i), 2*pi*(k - n*((2*k)/n))/n) &
                  & *exp(cmplx(0.0_dp, -2*pi*k*j/n, dp)), dp)/n
            end do
         end do
#line 103 "/work/main/tests/material/material_sampled_modulus.pf"
  call assertRelativelyEqual(2.0_dp, sum(answer), tolerance=1.0e-10_dp, &
 & location=SourceLocation( &
 & 'material_sampled_modulus.pf', &
 & 103) )
  if (anyExceptions()) return
#line 104 "/work/main/tests/material/material_sampled_modulus.pf"
#line 104 "/work/main/tests/material/material_sampled_modulus.pf"
  call assertGreaterThan(answer(0), 2.0_dp, &
 & location=SourceLocation( &
 & 'material_sampled_modulus.pf', &
 & 104) )
  if (anyExceptions()) return
#line 105 "/work/main/tests/material/material_sampled_modulus.pf"
#line 105 "/work/main/tests/material/material_sampled_modulus.pf"
  call assertLessThan(maxval(answer(1:)), 1.0e-11_dp, &
 & location=SourceLocation( &
 & 'material_sampled_modulus.pf', &
 & 105) )
  if (anyExceptions()) return
#line 106 "/work/main/tests/material/material_sampled_modulus.pf"
      end do
   end subroutine test_past_alone

end module material_sampled_modulus

module Wrapmaterial_sampled_modulus
   use FUnit
   use material_sampled_modulus
   implicit none
   private

contains


end module Wrapmaterial_sampled_modulus

function material_sampled_modulus_suite() result(suite)
   use FUnit
   use material_sampled_modulus
   use Wrapmaterial_sampled_modulus
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('material_sampled_modulus_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_march', &
      test_march))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_aliases', &
      test_aliases))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_limits', &
      test_limits))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_past_alone', &
      test_past_alone))
   call suite%addTest(t)


end function material_sampled_modulus_suite

