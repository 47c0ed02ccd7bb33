! SPDX-License-Identifier: GPL-3.0-or-later
! Rigid punches in plane strain.
module classical_punch
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_classical_hertz_line, only: line_contact_t, line_of_load, line_pressure, line_gap
   use adfric_classical_punch_profiles, only: polynomial_t, power_load, wedge_load, wedge_pressure, wedge_gap
   use adfric_classical_rigid_punch, only: punch_contact_t, solve_punch, solve_punch_of_width, bounded_load
   use adfric_numerics_lapack, only: dgesv
   use trial_profiles, only: hyperbola_t
   use funit
   implicit none (type, external)

   real(dp), parameter :: closed_form = 100*epsilon(1.0_dp), solved = 1.0e-12_dp

contains

   ! The cylinder z = x^2/2R is Hertz's.
   !@test
   subroutine test_cylinder()
      type(polynomial_t) :: profile
      type(punch_contact_t) :: contact
      type(line_contact_t) :: hertz
      real(dp), parameter :: r = 2.0_dp, e = 3.0_dp
      real(dp) :: x, gap
      integer :: n, i

      profile%c(1) = 1/(2*r)
      hertz = line_of_load(r, e, 0.7_dp)
      do n = 2, 32, 2
         call solve_punch(profile, 10.0_dp, e, 0.7_dp, n, contact)
#line 32 "/work/main/tests/classical/classical_punch.pf"
  call assertTrue(contact%is_converged, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 32) )
  if (anyExceptions()) return
#line 33 "/work/main/tests/classical/classical_punch.pf"
#line 33 "/work/main/tests/classical/classical_punch.pf"
  call assertRelativelyEqual(hertz%half_width, contact%half_width, tolerance=solved, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 33) )
  if (anyExceptions()) return
#line 34 "/work/main/tests/classical/classical_punch.pf"
         do i = 0, 20
            x = 0.1_dp*i*contact%half_width
#line 36 "/work/main/tests/classical/classical_punch.pf"
  call assertEqual(line_pressure(hertz, x), contact%pressure(-x), tolerance=1.0e-7_dp, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 36) )
  if (anyExceptions()) return
#line 37 "/work/main/tests/classical/classical_punch.pf"
            if (i /= 10) then
#line 38 "/work/main/tests/classical/classical_punch.pf"
  call assertEqual(line_pressure(hertz, x), contact%pressure(-x), tolerance=solved, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 38) )
  if (anyExceptions()) return
#line 39 "/work/main/tests/classical/classical_punch.pf"
            end if
            gap = profile%height(x) - profile%height(contact%half_width) - contact%rise(x)
#line 41 "/work/main/tests/classical/classical_punch.pf"
  call assertEqual(line_gap(hertz, x), gap, tolerance=solved, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 41) )
  if (anyExceptions()) return
#line 42 "/work/main/tests/classical/classical_punch.pf"
         end do
      end do
   end subroutine test_cylinder

   ! Flat: P/(pi sqrt(a^2 - x^2)).
   !@test
   subroutine test_flat()
      type(polynomial_t) :: profile
      type(punch_contact_t) :: contact
      real(dp) :: x
      integer :: i

      call solve_punch(profile, 2.0_dp, 3.0_dp, 5.0_dp, 8, contact)
#line 55 "/work/main/tests/classical/classical_punch.pf"
  call assertEqual(2.0_dp, contact%half_width, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 55) )
  if (anyExceptions()) return
#line 56 "/work/main/tests/classical/classical_punch.pf"
      do i = -9, 9
         x = 0.2_dp*i
#line 58 "/work/main/tests/classical/classical_punch.pf"
  call assertEqual(5/(pi*sqrt(4 - x**2)), contact%pressure(x), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 58) )
  if (anyExceptions()) return
#line 59 "/work/main/tests/classical/classical_punch.pf"
#line 59 "/work/main/tests/classical/classical_punch.pf"
  call assertEqual(0.0_dp, contact%rise(x), &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 59) )
  if (anyExceptions()) return
#line 60 "/work/main/tests/classical/classical_punch.pf"
      end do
#line 61 "/work/main/tests/classical/classical_punch.pf"
  call assertEqual(2*5/(pi*3)*acosh(1.5_dp), contact%rise(3.0_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 61) )
  if (anyExceptions()) return
#line 62 "/work/main/tests/classical/classical_punch.pf"
   end subroutine test_flat

   ! z = c x^4: P = (3 pi/4) E* c a^4, p = 2 E* c a^3 (t^2 + 1/2) sqrt(1 - t^2).
   !@test
   subroutine test_quartic()
      type(polynomial_t) :: profile
      type(punch_contact_t) :: contact
      real(dp), parameter :: a = 1.3_dp, e = 2.0_dp, c = 0.4_dp
      real(dp) :: t
      integer :: i

      profile%c(2) = c
#line 74 "/work/main/tests/classical/classical_punch.pf"
  call assertRelativelyEqual(0.75_dp*pi*e*c*a**4, bounded_load(profile, e, a, 8), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 74) )
  if (anyExceptions()) return
#line 75 "/work/main/tests/classical/classical_punch.pf"
#line 75 "/work/main/tests/classical/classical_punch.pf"
  call assertRelativelyEqual(0.75_dp*pi*e*c*a**4, power_load(e, c, 2, a), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 75) )
  if (anyExceptions()) return
#line 76 "/work/main/tests/classical/classical_punch.pf"
      call solve_punch(profile, 5.0_dp, e, 0.75_dp*pi*e*c*a**4, 8, contact)
#line 77 "/work/main/tests/classical/classical_punch.pf"
  call assertRelativelyEqual(a, contact%half_width, tolerance=solved, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 77) )
  if (anyExceptions()) return
#line 78 "/work/main/tests/classical/classical_punch.pf"
      do i = 0, 9
         t = 0.1_dp*i
#line 80 "/work/main/tests/classical/classical_punch.pf"
  call assertEqual(2*e*c*a**3*(t**2 + 0.5_dp)*sqrt(1 - t**2), contact%pressure(t*contact%half_width), tolerance=solved, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 80) )
  if (anyExceptions()) return
#line 81 "/work/main/tests/classical/classical_punch.pf"
      end do
#line 82 "/work/main/tests/classical/classical_punch.pf"
  call assertLessThan(contact%load_error, solved, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 82) )
  if (anyExceptions()) return
#line 83 "/work/main/tests/classical/classical_punch.pf"
      call solve_punch_of_width(profile, a, e, 8, contact)
#line 84 "/work/main/tests/classical/classical_punch.pf"
  call assertEqual(a, contact%half_width, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 84) )
  if (anyExceptions()) return
#line 85 "/work/main/tests/classical/classical_punch.pf"
#line 85 "/work/main/tests/classical/classical_punch.pf"
  call assertRelativelyEqual(0.75_dp*pi*e*c*a**4, contact%load, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 85) )
  if (anyExceptions()) return
#line 86 "/work/main/tests/classical/classical_punch.pf"
#line 86 "/work/main/tests/classical/classical_punch.pf"
  call assertLessThan(contact%load_error, closed_form, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 86) )
  if (anyExceptions()) return
#line 87 "/work/main/tests/classical/classical_punch.pf"
      ! z' is of degree 3: so are the terms, however many points there are
      call solve_punch(profile, 5.0_dp, e, 0.75_dp*pi*e*c*a**4, 1000, contact)
#line 89 "/work/main/tests/classical/classical_punch.pf"
  call assertEqual(3, size(contact%b), &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 89) )
  if (anyExceptions()) return
#line 90 "/work/main/tests/classical/classical_punch.pf"
#line 90 "/work/main/tests/classical/classical_punch.pf"
  call assertRelativelyEqual(3*e*c*a**3/2, contact%b(1), tolerance=solved, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 90) )
  if (anyExceptions()) return
#line 91 "/work/main/tests/classical/classical_punch.pf"
#line 91 "/work/main/tests/classical/classical_punch.pf"
  call assertRelativelyEqual(e*c*a**3/2, contact%b(3), tolerance=solved, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 91) )
  if (anyExceptions()) return
#line 92 "/work/main/tests/classical/classical_punch.pf"
   end subroutine test_quartic

   ! The face ends: a cylinder's bounded pressure and a flat punch's for the rest.
   !@test
   subroutine test_whole_face()
      type(polynomial_t) :: profile
      type(punch_contact_t) :: contact
      real(dp), parameter :: w = 0.5_dp, e = 2.0_dp, p = 3.0_dp
      real(dp) :: part, x
      integer :: i

      profile%c(1) = 0.5_dp
      part = pi*e*w**2/4
      call solve_punch(profile, w, e, p, 16, contact)
#line 106 "/work/main/tests/classical/classical_punch.pf"
  call assertEqual(w, contact%half_width, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 106) )
  if (anyExceptions()) return
#line 107 "/work/main/tests/classical/classical_punch.pf"
#line 107 "/work/main/tests/classical/classical_punch.pf"
  call assertEqual(p - part, contact%excess, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 107) )
  if (anyExceptions()) return
#line 108 "/work/main/tests/classical/classical_punch.pf"
      do i = 0, 9
         x = 0.1_dp*i*w
#line 110 "/work/main/tests/classical/classical_punch.pf"
  call assertEqual(e/2*sqrt(w**2 - x**2) + (p - part)/(pi*sqrt(w**2 - x**2)), contact%pressure(x), tolerance=solved, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 110) )
  if (anyExceptions()) return
#line 111 "/work/main/tests/classical/classical_punch.pf"
      end do
   end subroutine test_whole_face

   ! A smooth profile: four points more take the error down by a factor, to round-off.
   !@test
   subroutine test_spectral_convergence()
      type(hyperbola_t) :: profile
      type(punch_contact_t) :: fine, coarse
      real(dp), parameter :: a = 1.0_dp
      real(dp) :: errors(7), load, x, gap
      integer :: k, i

      load = bounded_load(profile, 1.0_dp, a, 64)
      call solve_punch(profile, 10.0_dp, 1.0_dp, load, 64, fine)
#line 125 "/work/main/tests/classical/classical_punch.pf"
  call assertRelativelyEqual(a, fine%half_width, tolerance=solved, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 125) )
  if (anyExceptions()) return
#line 126 "/work/main/tests/classical/classical_punch.pf"
      do k = 1, 7
         call solve_punch(profile, 10.0_dp, 1.0_dp, load, 4*k, coarse)
         errors(k) = maxval(abs(coarse%pressure([(0.09_dp*i, i=0, 10)]) - fine%pressure([(0.09_dp*i, i=0, 10)])))
      end do
      do k = 2, 7
#line 131 "/work/main/tests/classical/classical_punch.pf"
  call assertLessThan(errors(k), max(0.1_dp*errors(k - 1), solved), &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 131) )
  if (anyExceptions()) return
#line 132 "/work/main/tests/classical/classical_punch.pf"
      end do
#line 133 "/work/main/tests/classical/classical_punch.pf"
  call assertLessThan(errors(7), 1.0e-9_dp, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 133) )
  if (anyExceptions()) return
#line 134 "/work/main/tests/classical/classical_punch.pf"
      ! the gap closes in contact and opens outside
      do i = 0, 30
         x = 0.1_dp*i
         gap = profile%height(x) - profile%height(fine%half_width) - fine%rise(x)
         if (x <= a) then
#line 139 "/work/main/tests/classical/classical_punch.pf"
  call assertEqual(0.0_dp, gap, tolerance=solved, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 139) )
  if (anyExceptions()) return
#line 140 "/work/main/tests/classical/classical_punch.pf"
         else
#line 141 "/work/main/tests/classical/classical_punch.pf"
  call assertGreaterThan(gap, 0.0_dp, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 141) )
  if (anyExceptions()) return
#line 142 "/work/main/tests/classical/classical_punch.pf"
         end if
      end do
   end subroutine test_spectral_convergence

   ! The wedge: its load is the integral of the pressure, its gap that of 2 m arccos(a/x)/pi.
   !@test
   subroutine test_wedge()
      integer, parameter :: n = 20000
      real(dp), parameter :: e = 2.0_dp, m = 0.1_dp, a = 1.5_dp, midpoints = 1.0e-4_dp
      real(dp) :: x(n)
      integer :: i

      x = ([(i, i=1, n)] - 0.5_dp)/n
#line 155 "/work/main/tests/classical/classical_punch.pf"
  call assertRelativelyEqual(wedge_load(e, m, a), 2*a*sum(wedge_pressure(e, m, a, a*x))/n, tolerance=midpoints, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 155) )
  if (anyExceptions()) return
#line 156 "/work/main/tests/classical/classical_punch.pf"
#line 156 "/work/main/tests/classical/classical_punch.pf"
  call assertRelativelyEqual(sum(2*m/pi*acos(a/(a + x)))/n, wedge_gap(m, a, a + 1), tolerance=midpoints, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 156) )
  if (anyExceptions()) return
#line 157 "/work/main/tests/classical/classical_punch.pf"
#line 157 "/work/main/tests/classical/classical_punch.pf"
  call assertEqual(0.0_dp, wedge_gap(m, a, a), &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 157) )
  if (anyExceptions()) return
#line 158 "/work/main/tests/classical/classical_punch.pf"
   end subroutine test_wedge

   ! The equations of collocation as Erdogan and Gupta have them, solved by LAPACK: with t_i = cos(i pi/(n + 1)) and
   ! x_j = cos((2j - 1) pi/(2n + 2)), sum over i of (1 - t_i^2) G(t_i)/((n + 1)(x_j - t_i)) = (E*/2) z'(a x_j), p = sqrt(1 - t^2) G.
   ! The middle one of the n + 1 equations reads 0 = 0 by symmetry.
   !@test
   subroutine test_equations_of_collocation()
      real(dp), parameter :: a = 0.8_dp, e = 3.0_dp
      type(hyperbola_t) :: profile
      type(punch_contact_t) :: contact
      real(dp), allocatable :: matrix(:, :), g(:, :), t(:), x(:)
      integer, allocatable :: pivots(:)
      integer :: n, i, info

      do n = 2, 40, 2
         t = cos([(i, i=1, n)]*pi/(n + 1))
         x = cos([(2*i - 1, i=1, n/2), (2*i - 1, i=n/2 + 2, n + 1)]*pi/(2*n + 2))
         allocate (matrix(n, n), g(n, 1), pivots(n))
         do i = 1, n
            matrix(:, i) = (1 - t(i)**2)/((n + 1)*(x - t(i)))
         end do
         g(:, 1) = e/2*sign(profile%slope(a*abs(x)), x)
         call dgesv(n, 1, matrix, n, pivots, g, n, info)
#line 181 "/work/main/tests/classical/classical_punch.pf"
  call assertEqual(0, info, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 181) )
  if (anyExceptions()) return
#line 182 "/work/main/tests/classical/classical_punch.pf"
         call solve_punch_of_width(profile, a, e, n, contact)
         do i = 1, n
#line 184 "/work/main/tests/classical/classical_punch.pf"
  call assertEqual(sqrt(1 - t(i)**2)*g(i, 1), contact%pressure(a*t(i)), tolerance=solved, &
 & location=SourceLocation( &
 & 'classical_punch.pf', &
 & 184) )
  if (anyExceptions()) return
#line 185 "/work/main/tests/classical/classical_punch.pf"
         end do
         deallocate (matrix, g, pivots)
         if (anyExceptions()) return
      end do
   end subroutine test_equations_of_collocation

end module classical_punch

module Wrapclassical_punch
   use FUnit
   use classical_punch
   implicit none
   private

contains


end module Wrapclassical_punch

function classical_punch_suite() result(suite)
   use FUnit
   use classical_punch
   use Wrapclassical_punch
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_punch_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_cylinder', &
      test_cylinder))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_flat', &
      test_flat))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_quartic', &
      test_quartic))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_whole_face', &
      test_whole_face))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_spectral_convergence', &
      test_spectral_convergence))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_wedge', &
      test_wedge))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_equations_of_collocation', &
      test_equations_of_collocation))
   call suite%addTest(t)


end function classical_punch_suite

