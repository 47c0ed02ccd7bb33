! SPDX-License-Identifier: GPL-3.0-or-later
! Tractions on a strip: the table, superposition of line loads, and the numbers of Hertz's line contact.
module classical_strip
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_classical_flamant, only: line_stress
   use adfric_classical_strip_tractions, only: uniform_strip_stress, hertz_strip_stress, uniform_strip_integral, &
      & hertz_strip_integral
   use reference_table, only: table_t, read_table, table_digits
   use funit
   implicit none (type, external)

   real(dp), parameter :: closed_form = 100*epsilon(1.0_dp)

contains

   !@test
   subroutine test_table()
      type(table_t) :: table
      real(dp) :: x, y, p(3), q(3)
      integer :: row

      call read_table(table, 'yas_strip_load')
#line 24 "/work/main/tests/classical/classical_strip.pf"
  call assertEqual(8, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_strip.pf', &
 & 24) )
  if (anyExceptions()) return
#line 25 "/work/main/tests/classical/classical_strip.pf"
      do row = 1, table%n_rows
         x = table%number(row, 'x/a')
         y = table%number(row, 'y/a')
         p = [table%number(row, 'p=1: sxx'), table%number(row, 'p=1: syy'), table%number(row, 'p=1: sxy')]
         q = [table%number(row, 'tau=1: sxx'), table%number(row, 'tau=1: syy'), table%number(row, 'tau=1: sxy')]
#line 30 "/work/main/tests/classical/classical_strip.pf"
  call assertEqual(p, uniform_strip_stress(1.0_dp, 0.0_dp, x, y), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_strip.pf', &
 & 30) )
  if (anyExceptions()) return
#line 31 "/work/main/tests/classical/classical_strip.pf"
#line 31 "/work/main/tests/classical/classical_strip.pf"
  call assertEqual(q, uniform_strip_stress(0.0_dp, 1.0_dp, x, y), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_strip.pf', &
 & 31) )
  if (anyExceptions()) return
#line 32 "/work/main/tests/classical/classical_strip.pf"
#line 32 "/work/main/tests/classical/classical_strip.pf"
  call assertEqual(2*p - q, uniform_strip_stress(2.0_dp, -1.0_dp, x, y), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_strip.pf', &
 & 32) )
  if (anyExceptions()) return
#line 33 "/work/main/tests/classical/classical_strip.pf"
      end do
   end subroutine test_table

   ! Against line loads at the nodes of Gauss and Chebyshev, exact to round-off at these depths.
   !@test
   subroutine test_superposition()
      integer, parameter :: n = 400
      real(dp) :: s, weight, stress(3), x, y
      integer :: i, j, k

      do j = -3, 3
         x = 0.6_dp*j
         y = 0.2_dp + 0.3_dp*abs(j)
         do k = 0, 1
            stress = 0
            do i = 1, n
               s = cos(pi*i/(n + 1))
               weight = pi/(n + 1)*sin(pi*i/(n + 1))**2
               stress = stress + weight*line_stress(real(1 - k, dp), real(k, dp), x - s, y)
            end do
#line 53 "/work/main/tests/classical/classical_strip.pf"
  call assertEqual(stress, hertz_strip_stress(real(1 - k, dp), real(k, dp), x, y), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'classical_strip.pf', &
 & 53) )
  if (anyExceptions()) return
#line 54 "/work/main/tests/classical/classical_strip.pf"
         end do
      end do
   end subroutine test_superposition

   ! Far away both are the line load, to the second order of the distance.
   !@test
   subroutine test_far_away()
      real(dp), parameter :: x = 3.0e7_dp, y = 4.0e7_dp, far = 1.0e-13_dp
      real(dp) :: line(3)

      line = line_stress(1.0_dp, 0.0_dp, x, y)
#line 65 "/work/main/tests/classical/classical_strip.pf"
  call assertEqual(2*line/line(2), uniform_strip_stress(1.0_dp, 0.0_dp, x, y)/line(2), tolerance=far, &
 & location=SourceLocation( &
 & 'classical_strip.pf', &
 & 65) )
  if (anyExceptions()) return
#line 66 "/work/main/tests/classical/classical_strip.pf"
#line 66 "/work/main/tests/classical/classical_strip.pf"
  call assertEqual(pi/2*line/line(2), hertz_strip_stress(1.0_dp, 0.0_dp, x, y)/line(2), tolerance=far, &
 & location=SourceLocation( &
 & 'classical_strip.pf', &
 & 66) )
  if (anyExceptions()) return
#line 67 "/work/main/tests/classical/classical_strip.pf"
      line = line_stress(0.0_dp, 1.0_dp, x, y)
#line 68 "/work/main/tests/classical/classical_strip.pf"
  call assertEqual(pi/2*line/line(1), hertz_strip_stress(0.0_dp, 1.0_dp, x, y)/line(1), tolerance=far, &
 & location=SourceLocation( &
 & 'classical_strip.pf', &
 & 68) )
  if (anyExceptions()) return
#line 69 "/work/main/tests/classical/classical_strip.pf"
   end subroutine test_far_away

   ! On the boundary the tractions come back, and with s_xx = -p the pressure is uniform in the plane.
   !@test
   subroutine test_boundary()
      real(dp) :: x, root
      integer :: i

      do i = -9, 9
         x = 0.1_dp*i
         root = sqrt(1 - x*x)
#line 80 "/work/main/tests/classical/classical_strip.pf"
  call assertEqual([-root, -root, 0.0_dp], hertz_strip_stress(1.0_dp, 0.0_dp, x, 0.0_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_strip.pf', &
 & 80) )
  if (anyExceptions()) return
#line 81 "/work/main/tests/classical/classical_strip.pf"
#line 81 "/work/main/tests/classical/classical_strip.pf"
  call assertEqual([-2*x, 0.0_dp, -root], hertz_strip_stress(0.0_dp, 1.0_dp, x, 0.0_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_strip.pf', &
 & 81) )
  if (anyExceptions()) return
#line 82 "/work/main/tests/classical/classical_strip.pf"
#line 82 "/work/main/tests/classical/classical_strip.pf"
  call assertEqual([-1.0_dp, -1.0_dp, 0.0_dp], uniform_strip_stress(1.0_dp, 0.0_dp, x, 0.0_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_strip.pf', &
 & 82) )
  if (anyExceptions()) return
#line 83 "/work/main/tests/classical/classical_strip.pf"
      end do
      do i = 11, 30
         x = 0.1_dp*i
         root = 2*(sqrt(x*x - 1) - x)
#line 87 "/work/main/tests/classical/classical_strip.pf"
  call assertEqual([0.0_dp, 0.0_dp, 0.0_dp], hertz_strip_stress(1.0_dp, 0.0_dp, x, 0.0_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_strip.pf', &
 & 87) )
  if (anyExceptions()) return
#line 88 "/work/main/tests/classical/classical_strip.pf"
#line 88 "/work/main/tests/classical/classical_strip.pf"
  call assertEqual([root, 0.0_dp, 0.0_dp], hertz_strip_stress(0.0_dp, 1.0_dp, x, 0.0_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_strip.pf', &
 & 88) )
  if (anyExceptions()) return
#line 89 "/work/main/tests/classical/classical_strip.pf"
#line 89 "/work/main/tests/classical/classical_strip.pf"
  call assertEqual([-root, 0.0_dp, 0.0_dp], hertz_strip_stress(0.0_dp, 1.0_dp, -x, 0.0_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_strip.pf', &
 & 89) )
  if (anyExceptions()) return
#line 90 "/work/main/tests/classical/classical_strip.pf"
      end do
#line 91 "/work/main/tests/classical/classical_strip.pf"
  call assertEqual([-2.0_dp, 0.0_dp, 0.0_dp], hertz_strip_stress(1.0_dp, 1.0_dp, 1.0_dp, 0.0_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_strip.pf', &
 & 91) )
  if (anyExceptions()) return
#line 92 "/work/main/tests/classical/classical_strip.pf"
#line 92 "/work/main/tests/classical/classical_strip.pf"
  call assertTrue(all(abs(hertz_strip_stress(1.0_dp, 1.0_dp, 1.0e-200_dp, 1.0e-200_dp)) < 2), &
 & location=SourceLocation( &
 & 'classical_strip.pf', &
 & 92) )
  if (anyExceptions()) return
#line 93 "/work/main/tests/classical/classical_strip.pf"
   end subroutine test_boundary

   ! Hertz's principal value by quadrature without the singularity: int (p(s) - p(x))/(x - s) ds = int p/(x - s) ds - p(x) ln.
   !@test
   subroutine test_integrals()
#line 98 "/work/main/tests/classical/classical_strip.pf"
  call assertEqual(0.5_dp*pi, hertz_strip_integral(0.5_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_strip.pf', &
 & 98) )
  if (anyExceptions()) return
#line 99 "/work/main/tests/classical/classical_strip.pf"
#line 99 "/work/main/tests/classical/classical_strip.pf"
  call assertEqual(pi/(2 + sqrt(3.0_dp)), hertz_strip_integral(2.0_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_strip.pf', &
 & 99) )
  if (anyExceptions()) return
#line 100 "/work/main/tests/classical/classical_strip.pf"
#line 100 "/work/main/tests/classical/classical_strip.pf"
  call assertEqual(-pi/(2 + sqrt(3.0_dp)), hertz_strip_integral(-2.0_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_strip.pf', &
 & 100) )
  if (anyExceptions()) return
#line 101 "/work/main/tests/classical/classical_strip.pf"
#line 101 "/work/main/tests/classical/classical_strip.pf"
  call assertEqual(log(3.0_dp), uniform_strip_integral(2.0_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_strip.pf', &
 & 101) )
  if (anyExceptions()) return
#line 102 "/work/main/tests/classical/classical_strip.pf"
#line 102 "/work/main/tests/classical/classical_strip.pf"
  call assertEqual(log(3.0_dp), uniform_strip_integral(0.5_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_strip.pf', &
 & 102) )
  if (anyExceptions()) return
#line 103 "/work/main/tests/classical/classical_strip.pf"
#line 103 "/work/main/tests/classical/classical_strip.pf"
  call assertEqual(-log(7.0_dp), uniform_strip_integral(-0.75_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_strip.pf', &
 & 103) )
  if (anyExceptions()) return
#line 104 "/work/main/tests/classical/classical_strip.pf"
   end subroutine test_integrals

end module classical_strip

module Wrapclassical_strip
   use FUnit
   use classical_strip
   implicit none
   private

contains


end module Wrapclassical_strip

function classical_strip_suite() result(suite)
   use FUnit
   use classical_strip
   use Wrapclassical_strip
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_strip_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_table', &
      test_table))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_superposition', &
      test_superposition))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_far_away', &
      test_far_away))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_boundary', &
      test_boundary))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_integrals', &
      test_integrals))
   call suite%addTest(t)


end function classical_strip_suite

