! SPDX-License-Identifier: GPL-3.0-or-later
! Ratios of modified Bessel functions against the integrals that define them (DLMF 10.32.3, 10.32.9), with twice the digits.
module numerics_bessel_ratios
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_numerics_bessel_ratios, only: bessel_i1_deficit, bessel_i1_i0, bessel_i2_i0, bessel_k1_k0
   use quad_phi, only: qp
   use funit
   implicit none (type, external)

   real(dp), parameter :: round_off = 8*epsilon(1.0_dp)

contains

   ! Both sides of 4, where the way of computing changes.
   !@test
   subroutine test_integrals()
      real(dp), parameter :: places(12) = [1.0e-9_dp, 1.0e-6_dp, 1.0e-3_dp, 0.1_dp, 0.5_dp, 1.0_dp, 2.0_dp, 3.9_dp, 4.1_dp, &
         & 10.0_dp, 30.0_dp, 300.0_dp]
      real(dp) :: x, ratio
      integer :: i

      do i = 1, 12
         x = places(i)
         ratio = real(first_kind(x, 1)/first_kind(x, 0), dp)
#line 26 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
  call assertRelativelyEqual(ratio, bessel_i1_i0(x), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_bessel_ratios.pf', &
 & 26) )
  if (anyExceptions()) return
#line 27 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
         ratio = real(first_kind(x, 2)/first_kind(x, 0), dp)
#line 28 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
  call assertRelativelyEqual(ratio, bessel_i2_i0(x), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_bessel_ratios.pf', &
 & 28) )
  if (anyExceptions()) return
#line 29 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
         ratio = real(second_kind(x, 1)/second_kind(x, 0), dp)
#line 30 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
  call assertRelativelyEqual(ratio, bessel_k1_k0(x), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_bessel_ratios.pf', &
 & 30) )
  if (anyExceptions()) return
#line 31 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
      end do
   end subroutine test_integrals

   ! Both sides of 50, from where the digits of a small deficit are all there.
   !@test
   subroutine test_deficit()
      real(dp), parameter :: places(7) = [1.0e-6_dp, 1.0_dp, 10.0_dp, 49.9_dp, 50.1_dp, 100.0_dp, 1000.0_dp]
      real(dp) :: x, deficit
      integer :: i

      do i = 1, 7
         x = places(i)
         deficit = real(1 - first_kind(x, 1)/first_kind(x, 0), dp)
#line 44 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
  call assertEqual(deficit, bessel_i1_deficit(x), tolerance=round_off*merge(1.0_dp, deficit, x < 50), &
 & location=SourceLocation( &
 & 'numerics_bessel_ratios.pf', &
 & 44) )
  if (anyExceptions()) return
#line 45 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
      end do
#line 46 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
  call assertRelativelyEqual(0.5e-140_dp, bessel_i1_deficit(1.0e140_dp), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_bessel_ratios.pf', &
 & 46) )
  if (anyExceptions()) return
#line 47 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
#line 47 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
  call assertTrue(ieee_is_nan(bessel_i1_deficit(1.0e160_dp)), &
 & location=SourceLocation( &
 & 'numerics_bessel_ratios.pf', &
 & 47) )
  if (anyExceptions()) return
#line 48 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
   end subroutine test_deficit

   !> exp(-x) I_n(x), by midpoints of a period, whose error falls faster than any power.
   pure real(qp) function first_kind(x, n)
      real(dp), intent(in) :: x
      integer, intent(in) :: n
      integer, parameter :: n_places = 400
      real(qp) :: angle
      integer :: i

      first_kind = 0
      do i = 1, n_places
         angle = (i - 0.5_qp)*(acos(-1.0_qp)/n_places)
         first_kind = first_kind + exp(real(x, qp)*(cos(angle) - 1))*cos(n*angle)/n_places
      end do
   end function first_kind

   !> exp(x) K_n(x) but for a factor, by the trapezoidal rule.
   pure real(qp) function second_kind(x, n)
      real(dp), intent(in) :: x
      integer, intent(in) :: n
      real(qp) :: v
      integer :: i

      second_kind = 0.5_qp
      do i = 1, 2000
         v = 0.02_qp*i
         second_kind = second_kind + exp(-real(x, qp)*(cosh(v) - 1))*cosh(n*v)
      end do
   end function second_kind

   ! x/2, x^2/8 and 1/(x ln(f/x)) where x is small, 1 where it is large; no value beyond the bounds.
   !@test
   subroutine test_ends()
      real(dp), parameter :: small = 1.0e-100_dp, large = 1.0e100_dp
      !> 2 exp(-Euler's constant).
      real(dp), parameter :: factor = 1.1229189671337703_dp

#line 86 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
  call assertRelativelyEqual(small/2, bessel_i1_i0(small), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_bessel_ratios.pf', &
 & 86) )
  if (anyExceptions()) return
#line 87 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
#line 87 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
  call assertRelativelyEqual(small**2/8, bessel_i2_i0(small), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_bessel_ratios.pf', &
 & 87) )
  if (anyExceptions()) return
#line 88 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
#line 88 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
  call assertRelativelyEqual(1/(small*log(factor/small)), bessel_k1_k0(small), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_bessel_ratios.pf', &
 & 88) )
  if (anyExceptions()) return
#line 89 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
#line 89 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
  call assertEqual(1.0_dp, bessel_i1_i0(large), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_bessel_ratios.pf', &
 & 89) )
  if (anyExceptions()) return
#line 90 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
#line 90 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
  call assertEqual(1.0_dp, bessel_i2_i0(large), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_bessel_ratios.pf', &
 & 90) )
  if (anyExceptions()) return
#line 91 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
#line 91 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
  call assertEqual(1.0_dp, bessel_k1_k0(large), tolerance=round_off, &
 & location=SourceLocation( &
 & 'numerics_bessel_ratios.pf', &
 & 91) )
  if (anyExceptions()) return
#line 92 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
#line 92 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
  call assertTrue(ieee_is_nan(bessel_i1_i0(0.0_dp)), &
 & location=SourceLocation( &
 & 'numerics_bessel_ratios.pf', &
 & 92) )
  if (anyExceptions()) return
#line 93 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
#line 93 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
  call assertTrue(ieee_is_nan(bessel_i2_i0(1.0e151_dp)), &
 & location=SourceLocation( &
 & 'numerics_bessel_ratios.pf', &
 & 93) )
  if (anyExceptions()) return
#line 94 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
#line 94 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
  call assertTrue(ieee_is_nan(bessel_k1_k0(-1.0_dp)), &
 & location=SourceLocation( &
 & 'numerics_bessel_ratios.pf', &
 & 94) )
  if (anyExceptions()) return
#line 95 "/work/main/tests/numerics/numerics_bessel_ratios.pf"
   end subroutine test_ends

end module numerics_bessel_ratios

module Wrapnumerics_bessel_ratios
   use FUnit
   use numerics_bessel_ratios
   implicit none
   private

contains


end module Wrapnumerics_bessel_ratios

function numerics_bessel_ratios_suite() result(suite)
   use FUnit
   use numerics_bessel_ratios
   use Wrapnumerics_bessel_ratios
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('numerics_bessel_ratios_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_integrals', &
      test_integrals))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_deficit', &
      test_deficit))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_ends', &
      test_ends))
   call suite%addTest(t)


end function numerics_bessel_ratios_suite

