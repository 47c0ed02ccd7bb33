! SPDX-License-Identifier: GPL-3.0-or-later
! Westergaard's wave: the tables, and the contact conditions checked by the integral equation.
module classical_wave
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_classical_westergaard, only: wave_half_width, wave_pressure, wave_gap, wave_mean_gap, wave_penetration, &
      & find_wave_pressure
   use reference_table, only: table_t, read_table, table_digits
   use funit
   implicit none (type, external)

   real(dp), parameter :: closed_form = 100*epsilon(1.0_dp)

contains

   !@test
   subroutine test_table()
      type(table_t) :: table
      real(dp) :: q, width
      integer :: row

      call read_table(table, 'yas_westergaard')
#line 23 "/work/main/tests/classical/classical_wave.pf"
  call assertEqual(16, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 23) )
  if (anyExceptions()) return
#line 24 "/work/main/tests/classical/classical_wave.pf"
      do row = 1, table%n_rows
         q = table%number(row, 'pbar')
         width = 2*wave_half_width(q)
#line 27 "/work/main/tests/classical/classical_wave.pf"
  call assertEqual(table%number(row, '2a/lambda'), width, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 27) )
  if (anyExceptions()) return
#line 28 "/work/main/tests/classical/classical_wave.pf"
         ! the printed arcsine, read without its root, is the truth at both ends only
         if (q < 1) then
#line 30 "/work/main/tests/classical/classical_wave.pf"
  call assertLessThan(table%number(row, '(2/pi) asin(pbar/p*)'), width, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 30) )
  if (anyExceptions()) return
#line 31 "/work/main/tests/classical/classical_wave.pf"
         end if
#line 32 "/work/main/tests/classical/classical_wave.pf"
  call assertEqual(table%number(row, 'p(0)/p*'), wave_pressure(q, 0.0_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 32) )
  if (anyExceptions()) return
#line 33 "/work/main/tests/classical/classical_wave.pf"
#line 33 "/work/main/tests/classical/classical_wave.pf"
  call assertEqual(table%number(row, 'mean gap'), wave_mean_gap(q), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 33) )
  if (anyExceptions()) return
#line 34 "/work/main/tests/classical/classical_wave.pf"
         if (q < 1) then
#line 35 "/work/main/tests/classical/classical_wave.pf"
  call assertRelativelyEqual(table%number(row, 'mean gap'), wave_mean_gap(q), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 35) )
  if (anyExceptions()) return
#line 36 "/work/main/tests/classical/classical_wave.pf"
         end if
      end do
   end subroutine test_table

   !@test
   subroutine test_profile_table()
      type(table_t) :: table
      real(dp) :: q, x
      !> The pressure rises from the edge by the root of the distance, known to round-off.
      real(dp), parameter :: edge = 1.0e-7_dp
      integer :: row

      call read_table(table, 'yas_westergaard_profile')
#line 49 "/work/main/tests/classical/classical_wave.pf"
  call assertEqual(55, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 49) )
  if (anyExceptions()) return
#line 50 "/work/main/tests/classical/classical_wave.pf"
      do row = 1, table%n_rows
         q = table%number(row, 'pbar')
         x = table%number(row, 'x/lambda')
         if (x > wave_half_width(q)*(1 - 1.0e-12_dp)) then
#line 54 "/work/main/tests/classical/classical_wave.pf"
  call assertEqual(0.0_dp, wave_pressure(q, x), tolerance=edge, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 54) )
  if (anyExceptions()) return
#line 55 "/work/main/tests/classical/classical_wave.pf"
         else
#line 56 "/work/main/tests/classical/classical_wave.pf"
  call assertEqual(table%number(row, 'p(x)/p*'), wave_pressure(q, x), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 56) )
  if (anyExceptions()) return
#line 57 "/work/main/tests/classical/classical_wave.pf"
#line 57 "/work/main/tests/classical/classical_wave.pf"
  call assertEqual(table%number(row, 'p(x)/p*'), wave_pressure(q, -x - 3), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 57) )
  if (anyExceptions()) return
#line 58 "/work/main/tests/classical/classical_wave.pf"
         end if
      end do
   end subroutine test_profile_table

   ! Mean pressure and mean gap are those of the profiles: sums of midpoints, of the order 3/2 of the spacing at the edge.
   !@test
   subroutine test_means()
      integer, parameter :: n = 4000
      real(dp), parameter :: midpoints = 1.0e-5_dp
      real(dp) :: q, x(n)
      integer :: i

      x = ([(i, i=1, n)] - 0.5_dp)/n
      do i = 0, 12
         q = 0.1_dp*i
#line 73 "/work/main/tests/classical/classical_wave.pf"
  call assertEqual(q, sum(wave_pressure(q, x))/n, tolerance=midpoints, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 73) )
  if (anyExceptions()) return
#line 74 "/work/main/tests/classical/classical_wave.pf"
#line 74 "/work/main/tests/classical/classical_wave.pf"
  call assertEqual(wave_mean_gap(q), sum(wave_gap(q, x))/n, tolerance=midpoints, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 74) )
  if (anyExceptions()) return
#line 75 "/work/main/tests/classical/classical_wave.pf"
#line 75 "/work/main/tests/classical/classical_wave.pf"
  call assertEqual(1 - wave_mean_gap(q), wave_penetration(q), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 75) )
  if (anyExceptions()) return
#line 76 "/work/main/tests/classical/classical_wave.pf"
#line 76 "/work/main/tests/classical/classical_wave.pf"
  call assertTrue(all(wave_pressure(q, x) >= 0 .and. wave_gap(q, x) >= 0), &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 76) )
  if (anyExceptions()) return
#line 77 "/work/main/tests/classical/classical_wave.pf"
      end do
   end subroutine test_means

   ! The surface moves by u(x) = -(2/pi E*) int p ln|2 sin(pi (x - s)/l)| ds, in D: -2 int p ln ds. Gap z - u is level in
   ! contact and as the closed form outside: a Fourier series of the sampled pressure.
   !@test
   subroutine test_integral_equation()
      integer, parameter :: n = 2048, n_terms = 500
      !> Terms of the order k^(-5/2) are left out from the last one on.
      real(dp), parameter :: q = 0.4_dp, series = 500**(-1.5_dp)
      real(dp) :: x(n), p(n), shift, gap, c(n_terms), place
      integer :: i, k

      x = ([(i, i=1, n)] - 0.5_dp)/n
      p = wave_pressure(q, x)
      ! -ln|2 sin(psi)| = sum cos(2 k psi)/k
      c = [(2*sum(p*cos(2*pi*k*x))/n/k, k=1, n_terms)]
      shift = sum(c)
      do i = 0, 10
         place = 0.05_dp*i
         gap = 1 - cos(2*pi*place) + sum([(c(k)*cos(2*pi*k*place), k=1, n_terms)]) - shift
#line 98 "/work/main/tests/classical/classical_wave.pf"
  call assertEqual(wave_gap(q, place), gap, tolerance=series, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 98) )
  if (anyExceptions()) return
#line 99 "/work/main/tests/classical/classical_wave.pf"
      end do
   end subroutine test_integral_equation

   !@test
   subroutine test_penetration()
      real(dp) :: q, found
      logical :: is_converged
      integer :: i

      do i = 0, 60
         q = 0.6_dp**i*0.999_dp
         call find_wave_pressure(wave_penetration(q), found, is_converged)
#line 111 "/work/main/tests/classical/classical_wave.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 111) )
  if (anyExceptions()) return
#line 112 "/work/main/tests/classical/classical_wave.pf"
         ! near full contact the penetration is level
#line 113 "/work/main/tests/classical/classical_wave.pf"
  call assertRelativelyEqual(q, found, tolerance=closed_form/(1 - q), &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 113) )
  if (anyExceptions()) return
#line 114 "/work/main/tests/classical/classical_wave.pf"
      end do
      call find_wave_pressure(-1.0_dp, found, is_converged)
#line 116 "/work/main/tests/classical/classical_wave.pf"
  call assertEqual(0.0_dp, found, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 116) )
  if (anyExceptions()) return
#line 117 "/work/main/tests/classical/classical_wave.pf"
      call find_wave_pressure(1.0_dp, found, is_converged)
#line 118 "/work/main/tests/classical/classical_wave.pf"
  call assertEqual(1.0_dp, found, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 118) )
  if (anyExceptions()) return
#line 119 "/work/main/tests/classical/classical_wave.pf"
#line 119 "/work/main/tests/classical/classical_wave.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 119) )
  if (anyExceptions()) return
#line 120 "/work/main/tests/classical/classical_wave.pf"
      call find_wave_pressure(1.01_dp, found, is_converged)
#line 121 "/work/main/tests/classical/classical_wave.pf"
  call assertFalse(is_converged, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 121) )
  if (anyExceptions()) return
#line 122 "/work/main/tests/classical/classical_wave.pf"
   end subroutine test_penetration

   ! Hertz's line contact on the crests, 1/R = (2 pi/l)^2 D: a^2 = 4 P R/(pi E*) is (a/l)^2 = q/pi^2; the bare wave without load.
   !@test
   subroutine test_limits()
      real(dp), parameter :: q = 1.0e-12_dp
#line 128 "/work/main/tests/classical/classical_wave.pf"
  call assertRelativelyEqual(1.0_dp, wave_half_width(q)*pi/sqrt(q), tolerance=1.0e-11_dp, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 128) )
  if (anyExceptions()) return
#line 129 "/work/main/tests/classical/classical_wave.pf"
#line 129 "/work/main/tests/classical/classical_wave.pf"
  call assertEqual(2.0_dp, wave_gap(0.0_dp, 0.5_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 129) )
  if (anyExceptions()) return
#line 130 "/work/main/tests/classical/classical_wave.pf"
#line 130 "/work/main/tests/classical/classical_wave.pf"
  call assertEqual(1 - cos(0.4_dp*pi), wave_gap(0.0_dp, 0.2_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 130) )
  if (anyExceptions()) return
#line 131 "/work/main/tests/classical/classical_wave.pf"
#line 131 "/work/main/tests/classical/classical_wave.pf"
  call assertEqual(1 - cos(0.4_dp*pi), wave_gap(1.0e-20_dp, 0.2_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 131) )
  if (anyExceptions()) return
#line 132 "/work/main/tests/classical/classical_wave.pf"
#line 132 "/work/main/tests/classical/classical_wave.pf"
  call assertEqual(0.5_dp, wave_pressure(1.5_dp, 0.5_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 132) )
  if (anyExceptions()) return
#line 133 "/work/main/tests/classical/classical_wave.pf"
#line 133 "/work/main/tests/classical/classical_wave.pf"
  call assertEqual(2.5_dp, wave_pressure(1.5_dp, 0.0_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_wave.pf', &
 & 133) )
  if (anyExceptions()) return
#line 134 "/work/main/tests/classical/classical_wave.pf"
   end subroutine test_limits

end module classical_wave

module Wrapclassical_wave
   use FUnit
   use classical_wave
   implicit none
   private

contains


end module Wrapclassical_wave

function classical_wave_suite() result(suite)
   use FUnit
   use classical_wave
   use Wrapclassical_wave
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_wave_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_table', &
      test_table))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_profile_table', &
      test_profile_table))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_means', &
      test_means))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_integral_equation', &
      test_integral_equation))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_penetration', &
      test_penetration))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_limits', &
      test_limits))
   call suite%addTest(t)


end function classical_wave_suite

