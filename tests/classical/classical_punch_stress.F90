! SPDX-License-Identifier: GPL-3.0-or-later
! Stresses under a punch: the superposition of Flamant's line loads, and closed forms.
module classical_punch_stress
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_classical_flamant, only: line_stress
   use adfric_classical_punch_profiles, only: polynomial_t, wedge_load, wedge_pressure
   use adfric_classical_punch_stress, only: punch_stress
   use adfric_classical_rigid_punch, only: punch_contact_t, solve_punch
   use adfric_classical_strip_tractions, only: hertz_strip_stress
   use trial_case, only: trial_case_t, new_case
   use trial_profiles, only: hyperbola_t
   use funit
   implicit none (type, external)

   real(dp), parameter :: closed_form = 100*epsilon(1.0_dp), solved = 1.0e-12_dp
   !> Half-width of contact, E* and load of most cases.
   real(dp), parameter :: a = 0.7_dp, modulus = 3.0_dp, load = 2.0_dp

contains

   !> Stresses of the pressure of a contact without wedge, by the rule of equal parts in th, s = a cos th: the
   !> integrand is smooth and periodic, and its error falls as exp(-n d), d about the distance from the surface over a.
   function summed_stress(contact, x, y) result(stress)
      type(punch_contact_t), intent(in) :: contact
      real(dp), intent(in) :: x, y
      integer, parameter :: n = 2000
      real(dp) :: stress(3), th, s
      integer :: i

      stress = 0
      do i = 1, n
         th = (i - 0.5_dp)*pi/n
         s = contact%half_width*cos(th)
         stress = stress + contact%pressure(s)*sin(th)*line_stress(1.0_dp, 0.0_dp, x - s, y)
      end do
      stress = stress*contact%half_width*pi/n
   end function summed_stress

   !> The same for a wedge, by the rule of equal parts in v, |s| = a/cosh v, with which the integrand is smooth and vanishes.
   function summed_wedge(slope, x, y) result(stress)
      real(dp), intent(in) :: slope
      real(dp), intent(in) :: x, y
      integer, parameter :: n = 8000
      real(dp), parameter :: end = 50.0_dp
      real(dp) :: stress(3), v, s, share
      integer :: i

      stress = 0
      do i = 1, n
         v = i*end/n
         s = a/cosh(v)
         share = wedge_pressure(modulus, slope, a, s)*s*tanh(v)*end/n
         stress = stress + share*(line_stress(1.0_dp, 0.0_dp, x - s, y) + line_stress(1.0_dp, 0.0_dp, x + s, y))
      end do
   end function summed_wedge

   !> Compare in places beside, below and under the edges of the contact, in units of its mean pressure.
   subroutine check_places(contact, slope, name)
      type(punch_contact_t), intent(in) :: contact
      real(dp), intent(in) :: slope
      character(*), intent(in) :: name
      real(dp) :: x, y, expected(3)
      integer :: i, j

      do i = -6, 6
         do j = 1, 6
            x = 0.25_dp*i*a
            y = 0.1_dp*j**2*a
            expected = summed_stress(contact, x, y)
            if (slope > 0) expected = expected + summed_wedge(slope, x, y)
#line 73 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertEqual(expected, punch_stress(contact, slope, x, y), tolerance=solved*load/a, message=name, &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 73) )
  if (anyExceptions()) return
#line 74 "/work/main/tests/classical/classical_punch_stress.pf"
         end do
      end do
   end subroutine check_places

   !@test
   subroutine test_superposition()
      type(punch_contact_t) :: contact
      type(polynomial_t) :: flat, quartic
      type(hyperbola_t) :: hyperbola
      real(dp), parameter :: slope = 0.2_dp

      call solve_punch(flat, a, modulus, load, 8, contact)
      call check_places(contact, 0.0_dp, 'flat')
      quartic%c(1:2) = [0.1_dp, 0.3_dp]
      call solve_punch(quartic, 10*a, modulus, load, 16, contact)
      call check_places(contact, 0.0_dp, 'quartic')
      call solve_punch(quartic, 0.3_dp*a, modulus, load, 16, contact)
#line 91 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertGreaterThan(contact%excess, 0.0_dp, &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 91) )
  if (anyExceptions()) return
#line 92 "/work/main/tests/classical/classical_punch_stress.pf"
      call check_places(contact, 0.0_dp, 'quartic, whole face')
      call solve_punch(hyperbola, 10*a, modulus, 0.2_dp*load, 32, contact)
      call check_places(contact, 0.0_dp, 'hyperbola')
      call solve_punch(flat, a, modulus, load, 2, contact)
      contact%excess = load - wedge_load(modulus, slope, a)
      call check_places(contact, slope, 'wedge, whole face')
      contact%excess = 0
      call check_places(contact, slope, 'wedge')
   end subroutine test_superposition

   ! A cylinder: McEwen's stresses (Johnson 4.49), at all depths from the surface on.
   !@test
   subroutine test_cylinder()
      type(punch_contact_t) :: contact
      type(polynomial_t) :: profile
      real(dp) :: x, y, p0, expected(3)
      integer :: i, j

      profile%c(1) = 0.25_dp
      call solve_punch(profile, 10*a, modulus, load, 8, contact)
      p0 = contact%pressure(0.0_dp)
      do i = -8, 8
         do j = 0, 12
            x = 0.3_dp*i
            y = merge(0.0_dp, 10.0_dp**(j - 9), j == 0)
            expected = p0*hertz_strip_stress(1.0_dp, 0.0_dp, x, y)
            associate (w => contact%half_width)
#line 119 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertEqual(expected, punch_stress(contact, 0.0_dp, x*w, y*w), tolerance=solved*p0, &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 119) )
  if (anyExceptions()) return
#line 120 "/work/main/tests/classical/classical_punch_stress.pf"
            end associate
         end do
      end do
      ! at the edge all stresses end
#line 124 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertEqual([0.0_dp, 0.0_dp, 0.0_dp], punch_stress(contact, 0.0_dp, contact%half_width, 0.0_dp), &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 124) )
  if (anyExceptions()) return
#line 125 "/work/main/tests/classical/classical_punch_stress.pf"
   end subroutine test_cylinder

   ! On the surface s_xx = s_yy = -p and s_xy = 0; no values where the pressure is infinite.
   !@test
   subroutine test_surface()
      type(punch_contact_t) :: contact
      type(polynomial_t) :: flat
      real(dp), parameter :: slope = 0.2_dp
      real(dp) :: x, p
      integer :: i

      call solve_punch(flat, a, modulus, load, 2, contact)
      do i = -15, 15
         x = 0.1_dp*(i + 0.25_dp)*a
         p = contact%pressure(x)
#line 140 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertEqual([-p, -p, 0.0_dp], punch_stress(contact, 0.0_dp, x, 0.0_dp), tolerance=closed_form*load/a, &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 140) )
  if (anyExceptions()) return
#line 141 "/work/main/tests/classical/classical_punch_stress.pf"
         p = p + wedge_pressure(modulus, slope, a, x)
#line 142 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertEqual([-p, -p, 0.0_dp], punch_stress(contact, slope, x, 0.0_dp), tolerance=closed_form*load/a, &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 142) )
  if (anyExceptions()) return
#line 143 "/work/main/tests/classical/classical_punch_stress.pf"
      end do
#line 144 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertTrue(all(ieee_is_nan(punch_stress(contact, 0.0_dp, -a, 0.0_dp))), &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 144) )
  if (anyExceptions()) return
#line 145 "/work/main/tests/classical/classical_punch_stress.pf"
#line 145 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertTrue(all(ieee_is_nan(punch_stress(contact, slope, 0.0_dp, 0.0_dp))), &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 145) )
  if (anyExceptions()) return
#line 146 "/work/main/tests/classical/classical_punch_stress.pf"
#line 146 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertFalse(any(ieee_is_nan(punch_stress(contact, 0.0_dp, 0.0_dp, 0.0_dp))), &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 146) )
  if (anyExceptions()) return
#line 147 "/work/main/tests/classical/classical_punch_stress.pf"
      contact%excess = 0
#line 148 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertEqual([0.0_dp, 0.0_dp, 0.0_dp], punch_stress(contact, slope, a, 0.0_dp), &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 148) )
  if (anyExceptions()) return
#line 149 "/work/main/tests/classical/classical_punch_stress.pf"
   end subroutine test_surface

   ! Far away it is the line load, but for the square of the distance.
   !@test
   subroutine test_far_away()
      type(punch_contact_t) :: contact
      type(polynomial_t) :: flat
      real(dp), parameter :: far = 1.0e8_dp
      real(dp) :: expected(3)

      call solve_punch(flat, a, modulus, load, 2, contact)
      expected = line_stress(load, 0.0_dp, 0.6_dp*far, 0.8_dp*far)
#line 161 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertRelativelyEqual(expected, punch_stress(contact, 0.0_dp, 0.6_dp*far, 0.8_dp*far), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 161) )
  if (anyExceptions()) return
#line 162 "/work/main/tests/classical/classical_punch_stress.pf"
   end subroutine test_far_away

   ! Maps of the model: a row at the surface with its pressure, and rows below with the stresses only.
   !@test
   subroutine test_maps()
      type(trial_case_t) :: case
      real(dp), allocatable :: profiles(:, :, :)
      real(dp) :: shear

      call new_case(case, 'rigid_punch')
      call case%give('kind', 3.0_dp)
      call case%give('contact_modulus', modulus)
      call case%give('radius', 2.0_dp)
      call case%give('load', load)
      call case%give('profiles', 1.0_dp)
      call case%give('x_min', -1.0_dp)
      call case%give('x_max', 1.0_dp)
      call case%give('n_x', 5.0_dp)
      call case%give('y_max', 0.8_dp)
      call case%give('n_y', 3.0_dp)
#line 182 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 182) )
  if (anyExceptions()) return
#line 183 "/work/main/tests/classical/classical_punch_stress.pf"
      call case%solve()
      call case%get_profiles(profiles)
#line 185 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertEqual([5, 3, 7], shape(profiles), &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 185) )
  if (anyExceptions()) return
#line 186 "/work/main/tests/classical/classical_punch_stress.pf"
#line 186 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertEqual(-profiles(:, 1, 1), profiles(:, 1, 5), tolerance=solved*load/a, &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 186) )
  if (anyExceptions()) return
#line 187 "/work/main/tests/classical/classical_punch_stress.pf"
#line 187 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertFalse(any(ieee_is_nan(profiles(:, 1, :))), &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 187) )
  if (anyExceptions()) return
#line 188 "/work/main/tests/classical/classical_punch_stress.pf"
#line 188 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertTrue(all(ieee_is_nan(profiles(:, 2:, :3))), &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 188) )
  if (anyExceptions()) return
#line 189 "/work/main/tests/classical/classical_punch_stress.pf"
#line 189 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertFalse(any(ieee_is_nan(profiles(:, :, 4:))), &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 189) )
  if (anyExceptions()) return
#line 190 "/work/main/tests/classical/classical_punch_stress.pf"
      shear = hypot((profiles(2, 3, 4) - profiles(2, 3, 5))/2, profiles(2, 3, 6))
#line 191 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertEqual(shear, profiles(2, 3, 7), &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 191) )
  if (anyExceptions()) return
#line 192 "/work/main/tests/classical/classical_punch_stress.pf"
      ! on the axis the line contact's 0.300 p0 is not exceeded
#line 193 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertLessThan(maxval(profiles(:, :, 7)), 0.301_dp*case%found('centre_pressure'), &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 193) )
  if (anyExceptions()) return
#line 194 "/work/main/tests/classical/classical_punch_stress.pf"
#line 194 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertEqual(0.0_dp, case%model%variables(case%model%index_of('output', 'y_min'))%lower, &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 194) )
  if (anyExceptions()) return
#line 195 "/work/main/tests/classical/classical_punch_stress.pf"
   end subroutine test_maps

   ! On the axis of a wedge, with d = y/a, -(E* m/pi)(asinh(1/d) -+ 1/sqrt(1 + d^2)): at the tip like a logarithm.
   !@test
   subroutine test_tip_of_wedge()
      real(dp), parameter :: slope = 0.1_dp
      type(punch_contact_t) :: none
      real(dp) :: d, shape, stress(3)
      integer :: k

      none%half_width = a
      none%modulus = modulus
      allocate (none%b(0))
      do k = -60, 0
         d = 10.0_dp**k
         ! asinh(1/d), which is ln(2/d) where 1/d^2 has no room
         shape = log((1 + sqrt(1 + d**2))/d)
         stress = punch_stress(none, slope, 0.0_dp, d*a)
#line 213 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertRelativelyEqual(-modulus*slope/pi*(shape - 1/sqrt(1 + d**2)), stress(1), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 213) )
  if (anyExceptions()) return
#line 214 "/work/main/tests/classical/classical_punch_stress.pf"
#line 214 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertRelativelyEqual(-modulus*slope/pi*(shape + 1/sqrt(1 + d**2)), stress(2), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 214) )
  if (anyExceptions()) return
#line 215 "/work/main/tests/classical/classical_punch_stress.pf"
#line 215 "/work/main/tests/classical/classical_punch_stress.pf"
  call assertEqual(0.0_dp, stress(3), tolerance=closed_form*modulus*slope, &
 & location=SourceLocation( &
 & 'classical_punch_stress.pf', &
 & 215) )
  if (anyExceptions()) return
#line 216 "/work/main/tests/classical/classical_punch_stress.pf"
      end do
   end subroutine test_tip_of_wedge

end module classical_punch_stress

module Wrapclassical_punch_stress
   use FUnit
   use classical_punch_stress
   implicit none
   private

contains


end module Wrapclassical_punch_stress

function classical_punch_stress_suite() result(suite)
   use FUnit
   use classical_punch_stress
   use Wrapclassical_punch_stress
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_punch_stress_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_superposition', &
      test_superposition))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_cylinder', &
      test_cylinder))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_surface', &
      test_surface))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_far_away', &
      test_far_away))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_maps', &
      test_maps))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_tip_of_wedge', &
      test_tip_of_wedge))
   call suite%addTest(t)


end function classical_punch_stress_suite

