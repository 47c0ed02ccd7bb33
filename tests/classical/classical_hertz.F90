! SPDX-License-Identifier: GPL-3.0-or-later
! Hertz's contacts of lines, circles and ellipses.
module classical_hertz
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_classical_hertz_ellipse
   use adfric_classical_hertz_line, only: line_contact_t, line_of_load, line_gap, line_pressure
   use reference_table, only: table_t, read_table
   use funit
   implicit none (type, external)

   real(dp), parameter :: closed_form = 100*epsilon(1.0_dp), digits = 1.0e-13_dp

contains

   !> Find the shape, and the ellipse of a load.
   subroutine load_ellipse(a, b, modulus, load, s)
      real(dp), intent(in) :: a, b, modulus, load
      type(ellipse_t), intent(out) :: s
      type(ellipse_shape_t) :: shape

      call find_shape(a/b, shape)
      call ellipse_of_load(a, b, modulus, load, shape, s)
   end subroutine load_ellipse

   !@test
   subroutine test_table()
      type(table_t) :: table
      type(line_contact_t) :: line
      type(ellipse_t) :: point
      real(dp) :: p, r, e
      integer :: row

      call read_table(table, 'yas_hertz')
#line 35 "/work/main/tests/classical/classical_hertz.pf"
  call assertEqual(4, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 35) )
  if (anyExceptions()) return
#line 36 "/work/main/tests/classical/classical_hertz.pf"
      do row = 1, table%n_rows
         p = table%number(row, 'P')
         r = table%number(row, 'R')
         e = table%number(row, 'E*')
         if (table%text(row, 'kind') == 'line') then
            line = line_of_load(r, e, p)
#line 42 "/work/main/tests/classical/classical_hertz.pf"
  call assertRelativelyEqual(table%number(row, 'a'), line%half_width, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 42) )
  if (anyExceptions()) return
#line 43 "/work/main/tests/classical/classical_hertz.pf"
#line 43 "/work/main/tests/classical/classical_hertz.pf"
  call assertRelativelyEqual(table%number(row, 'p0'), line%peak_pressure, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 43) )
  if (anyExceptions()) return
#line 44 "/work/main/tests/classical/classical_hertz.pf"
         else
            call load_ellipse(1/(2*r), 1/(2*r), e, p, point)
#line 46 "/work/main/tests/classical/classical_hertz.pf"
  call assertRelativelyEqual(table%number(row, 'a'), point%minor, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 46) )
  if (anyExceptions()) return
#line 47 "/work/main/tests/classical/classical_hertz.pf"
#line 47 "/work/main/tests/classical/classical_hertz.pf"
  call assertRelativelyEqual(table%number(row, 'p0'), point%peak_pressure, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 47) )
  if (anyExceptions()) return
#line 48 "/work/main/tests/classical/classical_hertz.pf"
#line 48 "/work/main/tests/classical/classical_hertz.pf"
  call assertRelativelyEqual(table%number(row, 'delta'), point%approach, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 48) )
  if (anyExceptions()) return
#line 49 "/work/main/tests/classical/classical_hertz.pf"
         end if
      end do
   end subroutine test_table

   !@test
   subroutine test_elliptical_table()
      type(table_t) :: table
      type(ellipse_t) :: s
      real(dp) :: ratio
      integer :: row

      call read_table(table, 'yas_hertz_elliptical')
#line 61 "/work/main/tests/classical/classical_hertz.pf"
  call assertEqual(5, table%n_rows, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 61) )
  if (anyExceptions()) return
#line 62 "/work/main/tests/classical/classical_hertz.pf"
      do row = 1, table%n_rows
         ratio = table%number(row, 'B/A')
         call load_ellipse(1/(1 + ratio), ratio/(1 + ratio), 1.0_dp, 1.0_dp, s)
#line 65 "/work/main/tests/classical/classical_hertz.pf"
  call assertTrue(s%shape%is_converged, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 65) )
  if (anyExceptions()) return
#line 66 "/work/main/tests/classical/classical_hertz.pf"
#line 66 "/work/main/tests/classical/classical_hertz.pf"
  call assertRelativelyEqual(table%number(row, 'a'), s%major, tolerance=digits, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 66) )
  if (anyExceptions()) return
#line 67 "/work/main/tests/classical/classical_hertz.pf"
#line 67 "/work/main/tests/classical/classical_hertz.pf"
  call assertRelativelyEqual(table%number(row, 'b/a'), s%minor/s%major, tolerance=digits, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 67) )
  if (anyExceptions()) return
#line 68 "/work/main/tests/classical/classical_hertz.pf"
#line 68 "/work/main/tests/classical/classical_hertz.pf"
  call assertRelativelyEqual(table%number(row, 'p0'), s%peak_pressure, tolerance=digits, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 68) )
  if (anyExceptions()) return
#line 69 "/work/main/tests/classical/classical_hertz.pf"
#line 69 "/work/main/tests/classical/classical_hertz.pf"
  call assertRelativelyEqual(table%number(row, 'delta'), s%approach, tolerance=digits, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 69) )
  if (anyExceptions()) return
#line 70 "/work/main/tests/classical/classical_hertz.pf"
      end do
   end subroutine test_elliptical_table

   ! From the circle to a line: the equations hold, and load and approach belong together.
   !@test
   subroutine test_any_ratio()
      type(ellipse_t) :: s, t
      real(dp) :: a, b, before
      integer :: i

      before = 1
      do i = 0, 60
         b = 1
         a = 10.0_dp**(-0.2_dp*i)
         call load_ellipse(a, b, 3.0_dp, 2.0_dp, s)
#line 85 "/work/main/tests/classical/classical_hertz.pf"
  call assertTrue(s%shape%is_converged, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 85) )
  if (anyExceptions()) return
#line 86 "/work/main/tests/classical/classical_hertz.pf"
#line 86 "/work/main/tests/classical/classical_hertz.pf"
  call assertLessThan(ellipse_misfit(s, a, b, 3.0_dp), closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 86) )
  if (anyExceptions()) return
#line 87 "/work/main/tests/classical/classical_hertz.pf"
#line 87 "/work/main/tests/classical/classical_hertz.pf"
  call assertTrue(s%minor <= s%major .and. s%minor/s%major <= before, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 87) )
  if (anyExceptions()) return
#line 88 "/work/main/tests/classical/classical_hertz.pf"
         before = s%minor/s%major
         call ellipse_of_approach(a, b, 3.0_dp, s%approach, s%shape, t)
#line 90 "/work/main/tests/classical/classical_hertz.pf"
  call assertRelativelyEqual(2.0_dp, t%load, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 90) )
  if (anyExceptions()) return
#line 91 "/work/main/tests/classical/classical_hertz.pf"
#line 91 "/work/main/tests/classical/classical_hertz.pf"
  call assertRelativelyEqual(s%major, t%major, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 91) )
  if (anyExceptions()) return
#line 92 "/work/main/tests/classical/classical_hertz.pf"
#line 92 "/work/main/tests/classical/classical_hertz.pf"
  call assertRelativelyEqual(s%peak_pressure, t%peak_pressure, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 92) )
  if (anyExceptions()) return
#line 93 "/work/main/tests/classical/classical_hertz.pf"
      end do
      ! almost a circle: b/a = (A/B)^(2/3)
      call load_ellipse(1 - 1.0e-9_dp, 1.0_dp, 1.0_dp, 1.0_dp, s)
#line 96 "/work/main/tests/classical/classical_hertz.pf"
  call assertEqual(2.0e-9_dp/3, 1 - s%minor/s%major, tolerance=1.0e-15_dp, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 96) )
  if (anyExceptions()) return
#line 97 "/work/main/tests/classical/classical_hertz.pf"
      call load_ellipse(1.0_dp, 1.0_dp, 1.0_dp, 0.0_dp, s)
#line 98 "/work/main/tests/classical/classical_hertz.pf"
  call assertEqual(0.0_dp, s%major, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 98) )
  if (anyExceptions()) return
#line 99 "/work/main/tests/classical/classical_hertz.pf"
   end subroutine test_any_ratio

   ! Asymptote for A/B to 0: A/B = k^2 (ln(4/k) - 1), Johnson 4.2.
   !@test
   subroutine test_slender()
      type(ellipse_t) :: s
      real(dp) :: k

      call load_ellipse(1.0e-12_dp, 1.0_dp, 1.0_dp, 1.0_dp, s)
      k = s%minor/s%major
#line 109 "/work/main/tests/classical/classical_hertz.pf"
  call assertRelativelyEqual(1.0e-12_dp, k**2*(log(4/k) - 1), tolerance=1.0e-11_dp, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 109) )
  if (anyExceptions()) return
#line 110 "/work/main/tests/classical/classical_hertz.pf"
   end subroutine test_slender

   !@test
   subroutine test_curvatures()
      real(dp) :: a, b, direction
      real(dp), parameter :: skew = 1.0e-6_dp

      ! crossed equal cylinders are a sphere on a plane
      call find_curvatures([0.0_dp, 2.0_dp], [0.0_dp, 2.0_dp], pi/2, a, b, direction)
#line 119 "/work/main/tests/classical/classical_hertz.pf"
  call assertEqual([1.0_dp, 1.0_dp, 0.0_dp], [a, b, direction], tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 119) )
  if (anyExceptions()) return
#line 120 "/work/main/tests/classical/classical_hertz.pf"
      call find_curvatures([2.0_dp, 1.0_dp], [0.0_dp, 0.0_dp], 0.7_dp, a, b, direction)
#line 121 "/work/main/tests/classical/classical_hertz.pf"
  call assertEqual([0.5_dp, 1.0_dp, pi/2], [a, b, direction], tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 121) )
  if (anyExceptions()) return
#line 122 "/work/main/tests/classical/classical_hertz.pf"
      ! a cylinder turned on a plane: its axis, and the gap does not close along it
      call find_curvatures([0.0_dp, 0.0_dp], [0.0_dp, 2.0_dp], 0.3_dp, a, b, direction)
#line 124 "/work/main/tests/classical/classical_hertz.pf"
  call assertEqual([0.0_dp, 1.0_dp, 0.3_dp], [a, b, direction], tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 124) )
  if (anyExceptions()) return
#line 125 "/work/main/tests/classical/classical_hertz.pf"
      ! cylinders almost along each other: 4AB = c1 c2 sin^2, half-way between both
      call find_curvatures([0.0_dp, 2.0_dp], [0.0_dp, 2.0_dp], skew, a, b, direction)
#line 127 "/work/main/tests/classical/classical_hertz.pf"
  call assertRelativelyEqual(skew**2/2, a, tolerance=1.0e-11_dp, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 127) )
  if (anyExceptions()) return
#line 128 "/work/main/tests/classical/classical_hertz.pf"
#line 128 "/work/main/tests/classical/classical_hertz.pf"
  call assertEqual([2.0_dp, skew/2], [b, direction], tolerance=1.0e-12_dp, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 128) )
  if (anyExceptions()) return
#line 129 "/work/main/tests/classical/classical_hertz.pf"
      ! a sphere in a groove, and one in a hole that is too narrow
      call find_curvatures([1.0_dp, 1.0_dp], [0.0_dp, -0.9_dp], 0.0_dp, a, b, direction)
#line 131 "/work/main/tests/classical/classical_hertz.pf"
  call assertEqual([0.05_dp, 0.5_dp, pi/2], [a, b, direction], tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 131) )
  if (anyExceptions()) return
#line 132 "/work/main/tests/classical/classical_hertz.pf"
      call find_curvatures([1.0_dp, 1.0_dp], [0.0_dp, -1.1_dp], 0.0_dp, a, b, direction)
#line 133 "/work/main/tests/classical/classical_hertz.pf"
  call assertLessThan(a, 0.0_dp, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 133) )
  if (anyExceptions()) return
#line 134 "/work/main/tests/classical/classical_hertz.pf"
   end subroutine test_curvatures

   ! Of a circle the gap is known: (r^2/pi R)(sin w cos w - w cos 2w), a = r cos w; and p0 a/E* = 2 a^2/(pi R).
   !@test
   subroutine test_gap()
      type(ellipse_t) :: s
      type(line_contact_t) :: line
      real(dp) :: r, w, expected
      integer :: i

      call load_ellipse(0.5_dp, 0.5_dp, 1.0_dp, 1.0_dp, s)
      do i = 1, 20
         r = s%major*(1 + 0.2_dp*i)
         w = acos(s%major/r)
         expected = r*r/pi*(sin(w)*cos(w) - w*cos(2*w))
#line 149 "/work/main/tests/classical/classical_hertz.pf"
  call assertRelativelyEqual(expected, ellipse_gap(s, 1.0_dp, 0.6_dp*r, 0.8_dp*r), tolerance=1.0e-12_dp, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 149) )
  if (anyExceptions()) return
#line 150 "/work/main/tests/classical/classical_hertz.pf"
      end do
#line 151 "/work/main/tests/classical/classical_hertz.pf"
  call assertEqual(0.0_dp, ellipse_gap(s, 1.0_dp, 0.5_dp, 0.5_dp), &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 151) )
  if (anyExceptions()) return
#line 152 "/work/main/tests/classical/classical_hertz.pf"
      ! a slender one is the contact of a line across its middle, 2 B = 1/R
      call load_ellipse(1.0e-12_dp, 0.5_dp, 1.0_dp, 1.0_dp, s)
      line%half_width = s%minor
      line%peak_pressure = s%peak_pressure
      do i = 1, 5
         expected = line_gap(line, s%minor*(1 + i))
#line 158 "/work/main/tests/classical/classical_hertz.pf"
  call assertRelativelyEqual(expected, ellipse_gap(s, 1.0_dp, 0.0_dp, s%minor*(1 + i)), tolerance=1.0e-10_dp, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 158) )
  if (anyExceptions()) return
#line 159 "/work/main/tests/classical/classical_hertz.pf"
      end do
      ! far away it is the undeformed gap less the approach
      call load_ellipse(0.2_dp, 0.8_dp, 1.0_dp, 1.0_dp, s)
      r = 1.0e5_dp
      expected = r**2 - s%approach
#line 164 "/work/main/tests/classical/classical_hertz.pf"
  call assertRelativelyEqual(expected, ellipse_gap(s, 1.0_dp, r, r), tolerance=1.0e-14_dp, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 164) )
  if (anyExceptions()) return
#line 165 "/work/main/tests/classical/classical_hertz.pf"
   end subroutine test_gap

   ! On the axis: the circle (Johnson 3.45), the line, and the surface values (Johnson 3.65).
   !@test
   subroutine test_axial_stress()
      type(ellipse_t) :: s
      real(dp), parameter :: nu = 0.3_dp
      real(dp) :: z, radial, expected(3)
      integer :: i

      s%major = 2
      s%minor = 2
      s%peak_pressure = 1
      do i = 1, 30
         z = 0.1_dp*i
         radial = -(1 + nu)*(1 - z*atan(1/z)) + 0.5_dp/(1 + z*z)
#line 181 "/work/main/tests/classical/classical_hertz.pf"
  call assertEqual([radial, radial, -1/(1 + z*z)], ellipse_axial_stress(s, nu, 2*z), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 181) )
  if (anyExceptions()) return
#line 182 "/work/main/tests/classical/classical_hertz.pf"
      end do
      s%minor = 0.5_dp
      expected = [-0.6_dp - 0.4_dp*0.2_dp, -0.6_dp - 0.4_dp*0.8_dp, -1.0_dp]
#line 185 "/work/main/tests/classical/classical_hertz.pf"
  call assertEqual(expected, ellipse_axial_stress(s, nu, 0.0_dp), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 185) )
  if (anyExceptions()) return
#line 186 "/work/main/tests/classical/classical_hertz.pf"
      s%minor = 2.0e-9_dp
      do i = 1, 30
         z = 0.1_dp*i
         radial = -(1 + 2*z*z)/sqrt(1 + z*z) + 2*z
         expected = [nu*(radial - 1/sqrt(1 + z*z)), radial, -1/sqrt(1 + z*z)]
#line 191 "/work/main/tests/classical/classical_hertz.pf"
  call assertEqual(expected, ellipse_axial_stress(s, nu, z*s%minor), tolerance=1.0e-7_dp, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 191) )
  if (anyExceptions()) return
#line 192 "/work/main/tests/classical/classical_hertz.pf"
      end do
   end subroutine test_axial_stress

   !@test
   subroutine test_line()
      type(line_contact_t) :: line
      real(dp) :: x, gap

      line = line_of_load(2.0_dp, 3.0_dp, 5.0_dp)
      x = 1.7_dp*line%half_width
      gap = (x*sqrt(x**2 - line%half_width**2) - line%half_width**2*acosh(1.7_dp))/4
#line 203 "/work/main/tests/classical/classical_hertz.pf"
  call assertRelativelyEqual(gap, line_gap(line, x), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 203) )
  if (anyExceptions()) return
#line 204 "/work/main/tests/classical/classical_hertz.pf"
#line 204 "/work/main/tests/classical/classical_hertz.pf"
  call assertEqual(0.0_dp, line_pressure(line, x), &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 204) )
  if (anyExceptions()) return
#line 205 "/work/main/tests/classical/classical_hertz.pf"
#line 205 "/work/main/tests/classical/classical_hertz.pf"
  call assertEqual(line%peak_pressure*0.6_dp, line_pressure(line, 0.8_dp*line%half_width), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 205) )
  if (anyExceptions()) return
#line 206 "/work/main/tests/classical/classical_hertz.pf"
      line = line_of_load(2.0_dp, 3.0_dp, 0.0_dp)
#line 207 "/work/main/tests/classical/classical_hertz.pf"
  call assertEqual(0.25_dp, line_gap(line, 1.0_dp), &
 & location=SourceLocation( &
 & 'classical_hertz.pf', &
 & 207) )
  if (anyExceptions()) return
#line 208 "/work/main/tests/classical/classical_hertz.pf"
   end subroutine test_line

end module classical_hertz

module Wrapclassical_hertz
   use FUnit
   use classical_hertz
   implicit none
   private

contains


end module Wrapclassical_hertz

function classical_hertz_suite() result(suite)
   use FUnit
   use classical_hertz
   use Wrapclassical_hertz
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_hertz_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_table', &
      test_table))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_elliptical_table', &
      test_elliptical_table))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_any_ratio', &
      test_any_ratio))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_slender', &
      test_slender))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_curvatures', &
      test_curvatures))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_gap', &
      test_gap))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_axial_stress', &
      test_axial_stress))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_line', &
      test_line))
   call suite%addTest(t)


end function classical_hertz_suite

