! SPDX-License-Identifier: GPL-3.0-or-later
! Retardation spectra: every distance to all its digits, and the same column as the relaxation spectrum.
module material_retardation
   use, intrinsic :: iso_fortran_env, only: qp => real128
   use adfric_base_kinds, only: dp
   use adfric_material_prony, only: prony_t, new_prony, most_arms
   use adfric_material_retardation, only: retardation_t, new_retardation
   use random_dice, only: dice_t, new_dice
   use funit
   implicit none (type, external)

   !> Roundings of a quotient of a few numbers, each right to round-off.
   real(dp), parameter :: few_eps = 10*epsilon(1.0_dp)
   !> Sums of 64 terms that sum to 1 or less, with two roundings for each of the root of 64.
   real(dp), parameter :: sum_eps = 16*epsilon(1.0_dp)
   !> Ways to draw a spectrum.
   integer, parameter :: n_kinds = 5

contains

   ! One arm (GM 4): Ts and Te = beta Ts, stiffnesses 1/K and beta/K.
   !@test
   subroutine test_one_arm()
      type(prony_t) :: prony
      type(retardation_t) :: retardation
      real(dp), parameter :: beta = 12.5_dp, compliance = 3.0e-9_dp, relaxation = 0.02_dp

      call new_prony(prony, 1/compliance, [(beta - 1)/compliance], [relaxation])
      call new_retardation(retardation, prony)
#line 30 "/work/main/tests/material/material_retardation.pf"
  call assertEqual(1.0_dp, retardation%times(1)/(beta*relaxation), tolerance=few_eps, &
 & location=SourceLocation( &
 & 'material_retardation.pf', &
 & 30) )
  if (anyExceptions()) return
#line 31 "/work/main/tests/material/material_retardation.pf"
#line 31 "/work/main/tests/material/material_retardation.pf"
  call assertEqual(1.0_dp, retardation%distances(1, 1)/((beta - 1)*relaxation), tolerance=few_eps, &
 & location=SourceLocation( &
 & 'material_retardation.pf', &
 & 31) )
  if (anyExceptions()) return
#line 32 "/work/main/tests/material/material_retardation.pf"
#line 32 "/work/main/tests/material/material_retardation.pf"
  call assertEqual(1.0_dp, retardation%compliances(1)/(compliance*(1 - 1/beta)), tolerance=few_eps, &
 & location=SourceLocation( &
 & 'material_retardation.pf', &
 & 32) )
  if (anyExceptions()) return
#line 33 "/work/main/tests/material/material_retardation.pf"
   end subroutine test_one_arm

   ! Two arms: the roots of a quadratic equation. k0 = 1, k1 tau1 = 2, k2 tau2 = 3: lambda = 4 -+ sqrt(7).
   !@test
   subroutine test_two_arms()
      type(prony_t) :: prony
      type(retardation_t) :: retardation
      real(dp), parameter :: expected(2) = 4 + sqrt(7.0_dp)*[-1, 1]

      call new_prony(prony, 1.0_dp, [2.0_dp, 1.5_dp], [1.0_dp, 2.0_dp])
      call new_retardation(retardation, prony)
#line 44 "/work/main/tests/material/material_retardation.pf"
  call assertEqual(expected, retardation%times, tolerance=few_eps, &
 & location=SourceLocation( &
 & 'material_retardation.pf', &
 & 44) )
  if (anyExceptions()) return
#line 45 "/work/main/tests/material/material_retardation.pf"
   end subroutine test_two_arms

   ! A spring has no retardation.
   !@test
   subroutine test_spring()
      type(prony_t) :: prony
      type(retardation_t) :: retardation

      call new_prony(prony, 1.0_dp, [real(dp) ::], [real(dp) ::])
      call new_retardation(retardation, prony)
#line 55 "/work/main/tests/material/material_retardation.pf"
  call assertEqual(0, size(retardation%times) + size(retardation%compliances) + size(retardation%distances), &
 & location=SourceLocation( &
 & 'material_retardation.pf', &
 & 55) )
  if (anyExceptions()) return
#line 56 "/work/main/tests/material/material_retardation.pf"
   end subroutine test_spring

   ! Every distance of random spectra lies between the two places, few roundings apart, where the equation in four-fold precision
   ! has opposite signs; and the times are in their order.
   !@test
   subroutine test_digits()
      type(prony_t) :: prony
      type(retardation_t) :: retardation
      type(dice_t) :: dice
      integer :: trial, i, j
      character(30) :: label
      real(qp) :: x, tau

      call new_dice(dice, 2)
      do trial = 1, 640
         call draw(dice, trial, prony)
         call new_retardation(retardation, prony)
         write (label, '(a, i0, a, i0)') 'trial ', trial, ', arms ', size(prony%times)
         do j = 1, size(prony%times)
            ! the near time, and the root as it is seen from there
            i = minloc(abs(retardation%distances(:, j)), 1)
            x = retardation%distances(i, j)
            tau = prony%times(i)
#line 79 "/work/main/tests/material/material_retardation.pf"
  call assertTrue(has_root(prony, tau, x), message=label, &
 & location=SourceLocation( &
 & 'material_retardation.pf', &
 & 79) )
  if (anyExceptions()) return
#line 80 "/work/main/tests/material/material_retardation.pf"
#line 80 "/work/main/tests/material/material_retardation.pf"
  call assertLessThan(largest_error(prony, tau, x, retardation%distances(:, j)), few_eps, message=label, &
 & location=SourceLocation( &
 & 'material_retardation.pf', &
 & 80) )
  if (anyExceptions()) return
#line 81 "/work/main/tests/material/material_retardation.pf"
#line 81 "/work/main/tests/material/material_retardation.pf"
  call assertTrue(all(retardation%distances(:j, j) > 0), message=label, &
 & location=SourceLocation( &
 & 'material_retardation.pf', &
 & 81) )
  if (anyExceptions()) return
#line 82 "/work/main/tests/material/material_retardation.pf"
#line 82 "/work/main/tests/material/material_retardation.pf"
  call assertTrue(all(retardation%distances(j + 1:, j) < 0), message=label, &
 & location=SourceLocation( &
 & 'material_retardation.pf', &
 & 82) )
  if (anyExceptions()) return
#line 83 "/work/main/tests/material/material_retardation.pf"
         end do
      end do

   contains

      ! Does the equation change its sign next to tau + x?
      pure logical function has_root(prony, tau, x)
         type(prony_t), intent(in) :: prony
         real(qp), intent(in) :: tau, x

         has_root = value_at(prony, tau, x - few_eps*abs(x)) > 0 .and. value_at(prony, tau, x + few_eps*abs(x)) < 0
      end function has_root

      ! The secular equation at tau + x.
      pure real(qp) function value_at(prony, tau, x)
         type(prony_t), intent(in) :: prony
         real(qp), intent(in) :: tau, x

         value_at = sum(real(prony%moduli, qp)*prony%times/(x + (tau - prony%times))) - prony%relaxed
      end function value_at

      ! Largest relative error of the distances from the root tau + x.
      pure real(dp) function largest_error(prony, tau, x, distances)
         type(prony_t), intent(in) :: prony
         real(qp), intent(in) :: tau, x
         real(dp), intent(in) :: distances(:)
         real(qp) :: apart(size(distances))

         apart = x + (tau - prony%times)
         largest_error = real(maxval(abs(distances - apart)/abs(apart)), dp)
      end function largest_error
   end subroutine test_digits

   ! The matrix of the conversions is orthogonal, whatever the spectrum.
   !@test
   subroutine test_orthogonality()
      type(prony_t) :: prony
      type(retardation_t) :: retardation
      type(dice_t) :: dice
      real(dp), allocatable :: q(:, :), unit(:, :)
      integer :: trial, i
      character(30) :: label

      call new_dice(dice, 3)
      do trial = 1, 640
         call draw(dice, trial, prony)
         call new_retardation(retardation, prony)
         write (label, '(a, i0, a, i0)') 'trial ', trial, ', arms ', size(prony%times)
         associate (n => size(prony%times))
            q = spread(sqrt(prony%moduli*prony%times), 2, n)* &
               spread(sqrt(retardation%compliances*retardation%times), 1, n)/retardation%distances
            unit = reshape([1.0_dp, (0.0_dp, i=1, n)], [n, n], pad=[1.0_dp, (0.0_dp, i=1, n)])
         end associate
#line 136 "/work/main/tests/material/material_retardation.pf"
  call assertEqual(unit, matmul(q, transpose(q)), tolerance=sum_eps, message=label, &
 & location=SourceLocation( &
 & 'material_retardation.pf', &
 & 136) )
  if (anyExceptions()) return
#line 137 "/work/main/tests/material/material_retardation.pf"
#line 137 "/work/main/tests/material/material_retardation.pf"
  call assertEqual(unit, matmul(transpose(q), q), tolerance=sum_eps, message=label, &
 & location=SourceLocation( &
 & 'material_retardation.pf', &
 & 137) )
  if (anyExceptions()) return
#line 138 "/work/main/tests/material/material_retardation.pf"
      end do
   end subroutine test_orthogonality

   ! J M = 1 at complex frequencies, and at once and at rest.
   !@test
   subroutine test_inverse()
      type(prony_t) :: prony
      type(retardation_t) :: retardation
      type(dice_t) :: dice
      real(dp) :: frequency, storage, loss, glassy
      complex(dp) :: compliance
      integer :: trial, k

      call new_dice(dice, 4)
      do trial = 1, 640
         call draw(dice, trial, prony)
         call new_retardation(retardation, prony)
         glassy = prony%instantaneous_modulus()
#line 156 "/work/main/tests/material/material_retardation.pf"
  call assertEqual(1.0_dp, prony%relaxed*(1/glassy + sum(retardation%compliances)), tolerance=sum_eps, &
 & location=SourceLocation( &
 & 'material_retardation.pf', &
 & 156) )
  if (anyExceptions()) return
#line 157 "/work/main/tests/material/material_retardation.pf"
         do k = 1, 20
            call dice%decades(-12.0_dp, 12.0_dp, frequency)
            call prony%get_complex_modulus(frequency, storage, loss)
            compliance = 1/glassy + sum(retardation%compliances/cmplx(1.0_dp, frequency*retardation%times, dp))
#line 161 "/work/main/tests/material/material_retardation.pf"
  call assertEqual(0.0_dp, abs(compliance*cmplx(storage, loss, dp) - 1), tolerance=4*sum_eps, &
 & location=SourceLocation( &
 & 'material_retardation.pf', &
 & 161) )
  if (anyExceptions()) return
#line 162 "/work/main/tests/material/material_retardation.pf"
         end do
      end do
   end subroutine test_inverse

   ! Other units: powers of 2 change no digit, and no unit is too large or too small.
   !@test
   subroutine test_units()
      type(prony_t) :: prony, other
      type(retardation_t) :: retardation, found
      type(dice_t) :: dice
      real(dp), parameter :: moduli_unit = 2.0_dp**400, times_unit = 2.0_dp**(-500)

      call new_dice(dice, 5)
      call draw(dice, 20, prony)
      call new_prony(other, prony%relaxed*moduli_unit, prony%moduli*moduli_unit, prony%times*times_unit)
      call new_retardation(retardation, prony)
      call new_retardation(found, other)
#line 179 "/work/main/tests/material/material_retardation.pf"
  call assertEqual(retardation%times*times_unit, found%times, tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'material_retardation.pf', &
 & 179) )
  if (anyExceptions()) return
#line 180 "/work/main/tests/material/material_retardation.pf"
#line 180 "/work/main/tests/material/material_retardation.pf"
  call assertEqual(retardation%distances*times_unit, found%distances, tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'material_retardation.pf', &
 & 180) )
  if (anyExceptions()) return
#line 181 "/work/main/tests/material/material_retardation.pf"
#line 181 "/work/main/tests/material/material_retardation.pf"
  call assertEqual(retardation%compliances/moduli_unit, found%compliances, tolerance=0.0_dp, &
 & location=SourceLocation( &
 & 'material_retardation.pf', &
 & 181) )
  if (anyExceptions()) return
#line 182 "/work/main/tests/material/material_retardation.pf"
   end subroutine test_units

   ! Arms of next to no modulus: lambda - tau is k tau over the modulus of all the others at that time.
   !@test
   subroutine test_weak_arm()
      type(prony_t) :: prony
      type(retardation_t) :: retardation
      real(dp), parameter :: weak = 1.0e-30_dp

      ! with k0 = 1 and an arm of 2 at the time 4: weak/x = 1 - 2*4/(1 - 4) = 11/3
      call new_prony(prony, 1.0_dp, [weak, 2.0_dp], [1.0_dp, 4.0_dp])
      call new_retardation(retardation, prony)
#line 194 "/work/main/tests/material/material_retardation.pf"
  call assertEqual(3.0_dp/11, retardation%distances(1, 1)/weak, tolerance=few_eps, &
 & location=SourceLocation( &
 & 'material_retardation.pf', &
 & 194) )
  if (anyExceptions()) return
#line 195 "/work/main/tests/material/material_retardation.pf"
      ! from above: the root below 4 is nearer to it, -weak 4/x = 1 - 6*1/(4 - 1) = -1
      call new_prony(prony, 1.0_dp, [6.0_dp, weak], [1.0_dp, 4.0_dp])
      call new_retardation(retardation, prony)
#line 198 "/work/main/tests/material/material_retardation.pf"
  call assertEqual(-4.0_dp, retardation%distances(2, 1)/weak, tolerance=few_eps, &
 & location=SourceLocation( &
 & 'material_retardation.pf', &
 & 198) )
  if (anyExceptions()) return
#line 199 "/work/main/tests/material/material_retardation.pf"
#line 199 "/work/main/tests/material/material_retardation.pf"
  call assertEqual(7.0_dp, retardation%times(2), tolerance=7*few_eps, &
 & location=SourceLocation( &
 & 'material_retardation.pf', &
 & 199) )
  if (anyExceptions()) return
#line 200 "/work/main/tests/material/material_retardation.pf"
   end subroutine test_weak_arm

   ! A spectrum: 1 to 64 arms over up to 18 decades, with moduli alike, over six decades, with weak arms among them, with times in
   ! bunches, or with neighbours that differ in their last digits only.
   subroutine draw(dice, trial, prony)
      type(dice_t), intent(inout) :: dice
      integer, intent(in) :: trial
      type(prony_t), intent(out) :: prony
      real(dp) :: moduli(most_arms), times(most_arms), relaxed
      integer :: i, n, kind_of
      logical :: is_special

      n = 1 + modulo(trial, most_arms)
      kind_of = 1 + modulo(trial/most_arms, n_kinds)
      call dice%decades(-3.0_dp, 3.0_dp, relaxed)
      do i = 1, n
         call dice%decades(merge(0.0_dp, -3.0_dp, kind_of == 1), merge(0.01_dp, 3.0_dp, kind_of == 1), moduli(i))
         call dice%decades(-9.0_dp, 9.0_dp, times(i))
         call dice%happens(0.4_dp, is_special)
         if (kind_of == 3 .and. is_special) moduli(i) = 1.0e-14_dp*moduli(i)
         if (kind_of == 4) times(i) = 10.0_dp**nint(log10(times(i)))*(1 + 1.0e-6_dp*log10(times(i)))
         if (kind_of == 5 .and. is_special .and. i > 1) times(i) = nearest(times(i - 1), 1.0_dp)
      end do
      call new_prony(prony, relaxed, moduli(:n), times(:n))
   end subroutine draw

end module material_retardation

module Wrapmaterial_retardation
   use FUnit
   use material_retardation
   implicit none
   private

contains


end module Wrapmaterial_retardation

function material_retardation_suite() result(suite)
   use FUnit
   use material_retardation
   use Wrapmaterial_retardation
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('material_retardation_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_one_arm', &
      test_one_arm))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_two_arms', &
      test_two_arms))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_spring', &
      test_spring))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_digits', &
      test_digits))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_orthogonality', &
      test_orthogonality))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_inverse', &
      test_inverse))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_units', &
      test_units))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_weak_arm', &
      test_weak_arm))
   call suite%addTest(t)


end function material_retardation_suite

