! SPDX-License-Identifier: GPL-3.0-or-later
! The largest shear stress of Hertz's contacts: where it is, and that nothing in the solid exceeds it.
module classical_shear
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_classical_boussinesq_cerruti, only: point_stress
   use adfric_classical_hertz_ellipse, only: ellipse_t, ellipse_axial_stress, ellipse_edge_shear
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   use trial_case, only: trial_case_t, new_case
   use funit
   implicit none (type, external)

   real(dp), parameter :: closed_form = 100*epsilon(1.0_dp)

contains

   !> Largest shear over peak pressure and its depth over the smaller half-width, as the model gives them.
   subroutine find_shear(ratio, poisson_ratio, k, shear, depth)
      !> Principal radius along the ellipse over that across; 0: a line.
      real(dp), intent(in) :: ratio
      real(dp), intent(in) :: poisson_ratio
      !> b/a.
      real(dp), intent(out) :: k
      real(dp), intent(out) :: shear, depth
      type(trial_case_t) :: case

      call new_case(case, 'hertz')
      call case%give('contact_modulus', 1.0_dp)
      call case%give('load', 1.0e-3_dp)
      if (poisson_ratio > -1) call case%give('poisson_ratio', poisson_ratio)
      call case%give('kind', merge(3.0_dp, 1.0_dp, ratio > 0))
      if (ratio > 0) call case%give('radius_1x', ratio)
      call case%give(trim(merge('radius_1y', 'radius   ', ratio > 0)), 1.0_dp)
      call case%solve()
      k = 0
      if (ratio > 0) k = case%found('minor_half_width')/case%found('contact_half_width')
      shear = case%found('largest_shear_stress')/case%found('peak_pressure')
      depth = case%found('largest_shear_depth')/case%found(merge('minor_half_width  ', 'contact_half_width', ratio > 0))
   end subroutine find_shear

   ! (1 - 2 nu) p0/3 at the edge of a circle, and Johnson's (4.28) for an ellipse.
   !@test
   subroutine test_edge()
      type(ellipse_t) :: s
      real(dp), parameter :: nu = 0.2_dp
      real(dp) :: e
      integer :: i

      s%major = 2
      s%minor = 2
      s%peak_pressure = 3
#line 52 "/work/main/tests/classical/classical_shear.pf"
  call assertRelativelyEqual(1 - 2*nu, ellipse_edge_shear(s, nu), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_shear.pf', &
 & 52) )
  if (anyExceptions()) return
#line 53 "/work/main/tests/classical/classical_shear.pf"
      do i = 1, 9
         s%minor = 0.2_dp*i
         e = sqrt(1 - (s%minor/s%major)**2)
         associate (expected => (1 - 2*nu)*3*s%minor/s%major/e**2*(atanh(e)/e - 1))
#line 57 "/work/main/tests/classical/classical_shear.pf"
  call assertRelativelyEqual(expected, ellipse_edge_shear(s, nu), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_shear.pf', &
 & 57) )
  if (anyExceptions()) return
#line 58 "/work/main/tests/classical/classical_shear.pf"
         end associate
      end do
   end subroutine test_edge

   ! From nu = -0.09 on the axis has more shear than the edge, whatever the ellipse; at -0.11 not where b/a = 0.7.
   !@test
   subroutine test_axis_or_edge()
      real(dp), parameter :: highest = -0.11_dp, lowest = -0.09_dp
      type(ellipse_t) :: s
      real(dp) :: k, shear, depth
      integer :: i

      s%major = 1
      s%peak_pressure = 1
      do i = 0, 60
         call find_shear(10.0_dp**(0.05_dp*i), lowest, s%minor, shear, depth)
#line 74 "/work/main/tests/classical/classical_shear.pf"
  call assertGreaterThan(shear, ellipse_edge_shear(s, lowest), &
 & location=SourceLocation( &
 & 'classical_shear.pf', &
 & 74) )
  if (anyExceptions()) return
#line 75 "/work/main/tests/classical/classical_shear.pf"
      end do
      call find_shear(1.7_dp, highest, k, shear, depth)
      s%minor = k
#line 78 "/work/main/tests/classical/classical_shear.pf"
  call assertEqual(0.7_dp, k, tolerance=0.02_dp, &
 & location=SourceLocation( &
 & 'classical_shear.pf', &
 & 78) )
  if (anyExceptions()) return
#line 79 "/work/main/tests/classical/classical_shear.pf"
#line 79 "/work/main/tests/classical/classical_shear.pf"
  call assertRelativelyEqual(ellipse_edge_shear(s, highest), shear, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_shear.pf', &
 & 79) )
  if (anyExceptions()) return
#line 80 "/work/main/tests/classical/classical_shear.pf"
   end subroutine test_axis_or_edge

   ! No place on the axis has more, from spheres to rollers: the search for the largest does not stop at another maximum.
   !@test
   subroutine test_nothing_on_axis_exceeds()
      integer, parameter :: n_depths = 2000
      type(ellipse_t) :: s
      real(dp) :: nu, shear, depth, most, stress(3)
      integer :: i, j, k

      s%major = 1
      s%peak_pressure = 1
      do i = 0, 12
         do j = 0, 14
            nu = -0.9_dp + 0.1_dp*j
            call find_shear(10.0_dp**(0.5_dp*i), nu, s%minor, shear, depth)
            most = 0
            do k = 0, n_depths
               ! up to 50 b
               stress = ellipse_axial_stress(s, nu, s%minor*sinh(4.6_dp*k/n_depths))
               most = max(most, (maxval(stress) - minval(stress))/2)
            end do
#line 102 "/work/main/tests/classical/classical_shear.pf"
  call assertLessThanOrEqual(most, shear*(1 + closed_form), &
 & location=SourceLocation( &
 & 'classical_shear.pf', &
 & 102) )
  if (anyExceptions()) return
#line 103 "/work/main/tests/classical/classical_shear.pf"
         end do
      end do
   end subroutine test_nothing_on_axis_exceeds

   ! A circle with nu far below 0, and at 0, where the edge has p0/3.
   !@test
   subroutine test_circle_of_low_ratio()
      real(dp) :: k, shear, depth

      call find_shear(1.0_dp, -0.5_dp, k, shear, depth)
#line 113 "/work/main/tests/classical/classical_shear.pf"
  call assertRelativelyEqual(2.0_dp/3, shear, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_shear.pf', &
 & 113) )
  if (anyExceptions()) return
#line 114 "/work/main/tests/classical/classical_shear.pf"
#line 114 "/work/main/tests/classical/classical_shear.pf"
  call assertEqual(0.0_dp, depth, &
 & location=SourceLocation( &
 & 'classical_shear.pf', &
 & 114) )
  if (anyExceptions()) return
#line 115 "/work/main/tests/classical/classical_shear.pf"
      call find_shear(1.0_dp, 0.0_dp, k, shear, depth)
#line 116 "/work/main/tests/classical/classical_shear.pf"
  call assertGreaterThan(shear, 1.0_dp/3, &
 & location=SourceLocation( &
 & 'classical_shear.pf', &
 & 116) )
  if (anyExceptions()) return
#line 117 "/work/main/tests/classical/classical_shear.pf"
      ! the root of d/dz [1 - z atan(1/z) - 3/(2 (1 + z^2))] = 0
#line 118 "/work/main/tests/classical/classical_shear.pf"
  call assertEqual(0.0_dp, depth/(1 + depth**2) - atan(1/depth) + 3*depth/(1 + depth**2)**2, tolerance=1.0e-6_dp, &
 & location=SourceLocation( &
 & 'classical_shear.pf', &
 & 118) )
  if (anyExceptions()) return
#line 119 "/work/main/tests/classical/classical_shear.pf"
   end subroutine test_circle_of_low_ratio

   ! A line is a slender ellipse, for every nu: 0.300 p0 at 0.786 a above nu of about 0.2, below it near the surface, where the
   ! stress along the line is the least; without nu that in the plane.
   !@test
   subroutine test_line()
      real(dp), parameter :: slender = 1.0e12_dp, its_share = 1.0e-6_dp, level = 1.0e-3_dp
      real(dp) :: k, shear, depth, line_shear, line_depth
      integer :: i

      do i = -9, 5
         call find_shear(slender, 0.1_dp*i, k, shear, depth)
         call find_shear(0.0_dp, 0.1_dp*i, k, line_shear, line_depth)
#line 132 "/work/main/tests/classical/classical_shear.pf"
  call assertRelativelyEqual(line_shear, shear, tolerance=its_share, &
 & location=SourceLocation( &
 & 'classical_shear.pf', &
 & 132) )
  if (anyExceptions()) return
#line 133 "/work/main/tests/classical/classical_shear.pf"
#line 133 "/work/main/tests/classical/classical_shear.pf"
  call assertEqual(line_depth, depth, tolerance=level, &
 & location=SourceLocation( &
 & 'classical_shear.pf', &
 & 133) )
  if (anyExceptions()) return
#line 134 "/work/main/tests/classical/classical_shear.pf"
      end do
      call find_shear(0.0_dp, 0.0_dp, k, line_shear, line_depth)
#line 136 "/work/main/tests/classical/classical_shear.pf"
  call assertEqual(0.5_dp, line_shear, tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_shear.pf', &
 & 136) )
  if (anyExceptions()) return
#line 137 "/work/main/tests/classical/classical_shear.pf"
      call find_shear(0.0_dp, -2.0_dp, k, line_shear, line_depth)
#line 138 "/work/main/tests/classical/classical_shear.pf"
  call assertEqual(0.300_dp, line_shear, tolerance=5.0e-4_dp, &
 & location=SourceLocation( &
 & 'classical_shear.pf', &
 & 138) )
  if (anyExceptions()) return
#line 139 "/work/main/tests/classical/classical_shear.pf"
#line 139 "/work/main/tests/classical/classical_shear.pf"
  call assertEqual(0.786_dp, line_depth, tolerance=5.0e-4_dp, &
 & location=SourceLocation( &
 & 'classical_shear.pf', &
 & 139) )
  if (anyExceptions()) return
#line 140 "/work/main/tests/classical/classical_shear.pf"
   end subroutine test_line

   ! The surface of a circle (Johnson 3.43), whose edge is the largest where the axis is not.
   !@test
   subroutine test_surface_of_circle()
      real(dp) :: k, shear, depth, nu, r, root, radial, around, p, largest
      integer :: i, j

      do i = -9, 5
         nu = 0.1_dp*i
         call find_shear(1.0_dp, nu, k, shear, depth)
         do j = 1, 200
            r = 0.01_dp*j
            p = sqrt(max(0.0_dp, 1 - r*r))
            root = 1 - p**3
            radial = (1 - 2*nu)/3*root/r**2 - p
            around = -(1 - 2*nu)/3*root/r**2 - 2*nu*p
            largest = (max(radial, around, -p) - min(radial, around, -p))/2
#line 158 "/work/main/tests/classical/classical_shear.pf"
  call assertLessThan(largest, shear*(1 + closed_form), &
 & location=SourceLocation( &
 & 'classical_shear.pf', &
 & 158) )
  if (anyExceptions()) return
#line 159 "/work/main/tests/classical/classical_shear.pf"
         end do
      end do
   end subroutine test_surface_of_circle

   ! The solid: stresses summed from point forces by quadrature. They are linear in nu.
   !@test
   subroutine test_solid()
      real(dp), parameter :: ratios(3) = [1.0_dp, 3.0_dp, 8.0_dp]
      !> What the quadrature leaves at the least depth, 0.25 b.
      real(dp), parameter :: quadrature = 1.0e-5_dp
      integer, parameter :: first = -9, last = 5
      real(dp) :: k, shear(first:last), depth, ends(6, 2), place(3), nu
      integer :: i, j, l, m, n

      do n = 1, size(ratios)
         do m = first, last
            call find_shear(ratios(n), 0.1_dp*m, k, shear(m), depth)
         end do
         do i = 0, 4
            do j = 0, 4
               do l = 0, 4
                  place = [0.3_dp*i, 0.3_dp*j*k, 0.25_dp*2**(0.6_dp*l)*k]
                  ends(:, 1) = summed_stress(k, 0.0_dp, place)
                  ends(:, 2) = summed_stress(k, 0.5_dp, place)
                  do m = first, last
                     nu = 0.1_dp*m
#line 185 "/work/main/tests/classical/classical_shear.pf"
  call assertLessThan(largest_shear(ends(:, 1)*(1 - 2*nu) + ends(:, 2)*2*nu), shear(m) + quadrature, &
 & location=SourceLocation( &
 & 'classical_shear.pf', &
 & 185) )
  if (anyExceptions()) return
#line 186 "/work/main/tests/classical/classical_shear.pf"
                  end do
               end do
            end do
         end do
      end do
   end subroutine test_solid

   !> Stresses under p = sqrt(1 - x^2 - y^2/k^2) = c, by rings: r dr = -c dc, Gauss' nodes in c and equal parts around.
   function summed_stress(k, poisson_ratio, place) result(stress)
      real(dp), intent(in) :: k, poisson_ratio
      real(dp), intent(in) :: place(3)
      integer, parameter :: n_panels = 6, n_around = 240
      real(dp) :: stress(6), c, r, th, load
      integer :: i, j, panel

      stress = 0
      do panel = 1, n_panels
         do i = 1, size(gauss_nodes)
            c = (panel - 0.5_dp + gauss_nodes(i)/2)/n_panels
            r = sqrt(1 - c**2)
            load = c**2*k*gauss_weights(i)/(2*n_panels)*2*pi/n_around
            do j = 1, n_around
               th = (j - 0.5_dp)*2*pi/n_around
               stress = stress + point_stress(load, 0.0_dp, poisson_ratio, place - [r*cos(th), k*r*sin(th), 0.0_dp])
            end do
         end do
      end do
   end function summed_stress

   !> Half the range of the principal stresses of [xx, yy, zz, xy, yz, xz], by the roots of the cubic.
   pure real(dp) function largest_shear(s)
      real(dp), intent(in) :: s(6)
      real(dp) :: d(3), size, determinant, angle

      d = s(:3) - sum(s(:3))/3
      size = sqrt((sum(d**2) + 2*sum(s(4:)**2))/6)
      determinant = d(1)*d(2)*d(3) + 2*s(4)*s(5)*s(6) - d(1)*s(5)**2 - d(2)*s(6)**2 - d(3)*s(4)**2
      angle = acos(max(-1.0_dp, min(1.0_dp, determinant/(2*size**3))))/3
      largest_shear = size*(cos(angle) - cos(angle + 2*pi/3))
   end function largest_shear

end module classical_shear

module Wrapclassical_shear
   use FUnit
   use classical_shear
   implicit none
   private

contains


end module Wrapclassical_shear

function classical_shear_suite() result(suite)
   use FUnit
   use classical_shear
   use Wrapclassical_shear
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_shear_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_edge', &
      test_edge))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_axis_or_edge', &
      test_axis_or_edge))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_nothing_on_axis_exceeds', &
      test_nothing_on_axis_exceeds))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_circle_of_low_ratio', &
      test_circle_of_low_ratio))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_line', &
      test_line))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_surface_of_circle', &
      test_surface_of_circle))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_solid', &
      test_solid))
   call suite%addTest(t)


end function classical_shear_suite

