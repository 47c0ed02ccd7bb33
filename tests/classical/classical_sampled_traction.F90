! SPDX-License-Identifier: GPL-3.0-or-later
! Tractions that are linear between samples: against quadrature, closed forms, and the equations of equilibrium.
module classical_sampled_traction
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_classical_sampled_traction, only: sampled_traction_t, every_second
   use adfric_classical_strip_tractions, only: uniform_strip_stress, hertz_strip_stress, uniform_strip_integral
   use brute_tractions, only: brute_stress, brute_integral
   use funit
   implicit none (type, external)

   !> Of a sum over a few pieces.
   real(dp), parameter :: round_off = 50*epsilon(1.0_dp)
   !> Of sums over thousands.
   real(dp), parameter :: round_off_of_many = 1.0e-13_dp

contains

   !> Uneven samples that begin and end with zero.
   type(sampled_traction_t) function uneven() result(samples)
      samples%s = [-1.2_dp, -0.7_dp, -0.69_dp, 0.1_dp, 0.2_dp, 1.7_dp]
      samples%p = [0.0_dp, 1.0_dp, 0.4_dp, 2.0_dp, 1.5_dp, 0.0_dp]
      samples%q = [0.0_dp, -0.5_dp, 1.0_dp, 0.3_dp, 0.8_dp, 0.0_dp]
   end function uneven

   !> Difference of two stresses in units of the larger.
   pure real(dp) function difference(one, other)
      real(dp), intent(in) :: one(3), other(3)

      difference = norm2(one - other)/max(norm2(one), norm2(other), tiny(1.0_dp))
   end function difference

   ! At samples, between and beside them, at depths from 1e-9 to 1e9 times a piece of length 1/2.
   !@test
   subroutine test_quadrature()
      type(sampled_traction_t) :: m
      real(dp), parameter :: x(14) = [-1.2_dp, -0.7_dp, -0.69_dp, 0.1_dp, 0.2_dp, 1.7_dp, -1.0_dp, -0.695_dp, 0.7_dp, &
         -1.2000001_dp, 1.700000001_dp, 0.2000000001_dp, -40.0_dp, 3.0e6_dp]
      real(dp) :: y, s(3)
      integer :: i, k

      m = uneven()
      do i = 1, size(x)
         do k = -36, 36
            y = 0.5_dp*10.0_dp**(0.25_dp*k)
            s = m%stress_at(x(i), y)
#line 48 "/work/main/tests/classical/classical_sampled_traction.pf"
  call assertLessThan(difference(s, brute_stress(m%s, m%p, m%q, x(i), y)), round_off, &
 & location=SourceLocation( &
 & 'classical_sampled_traction.pf', &
 & 48) )
  if (anyExceptions()) return
#line 49 "/work/main/tests/classical/classical_sampled_traction.pf"
         end do
      end do
   end subroutine test_quadrature

   ! Pieces of 1e-12 beside those of 1, which are jumps in all but name, seen from 1e-15 to 1e3 beside each sample and below it.
   !@test
   subroutine test_hard_samples()
      type(sampled_traction_t) :: m
      real(dp) :: x, y, integral(2)
      integer :: i, k, l

      m%s = [-1.0_dp, -1.0_dp + 1.0e-12_dp, 0.0_dp, 1.0e-9_dp, 1.0_dp]
      m%p = [0.0_dp, 1.0_dp, 1.0_dp, 0.0_dp, 0.0_dp]
      m%q = [0.0_dp, -0.5_dp, 2.0_dp, 1.0_dp, 0.0_dp]
      do i = 1, size(m%s)
         do k = -15, 3, 3
            x = m%s(i) + (-1)**k*10.0_dp**k
            do l = -16, 4, 2
               y = 10.0_dp**l
               associate (s => brute_stress(m%s, m%p, m%q, x, y))
#line 69 "/work/main/tests/classical/classical_sampled_traction.pf"
  call assertLessThan(difference(s, m%stress_at(x, y)), round_off_of_many, &
 & location=SourceLocation( &
 & 'classical_sampled_traction.pf', &
 & 69) )
  if (anyExceptions()) return
#line 70 "/work/main/tests/classical/classical_sampled_traction.pf"
               end associate
            end do
            integral = [brute_integral(m%s, m%p, x), brute_integral(m%s, m%q, x)]
#line 73 "/work/main/tests/classical/classical_sampled_traction.pf"
  call assertLessThan(norm2(m%integral_at(x) - integral), round_off_of_many*norm2(integral), &
 & location=SourceLocation( &
 & 'classical_sampled_traction.pf', &
 & 73) )
  if (anyExceptions()) return
#line 74 "/work/main/tests/classical/classical_sampled_traction.pf"
         end do
      end do
   end subroutine test_hard_samples

   ! On the surface the tractions come back, and s_xx = -p - (2/pi) int q/(x - s) ds.
   !@test
   subroutine test_surface()
      type(sampled_traction_t) :: m
      real(dp), parameter :: x(13) = [-1.2_dp, -0.7_dp, -0.69_dp, 0.1_dp, 0.2_dp, 1.7_dp, -1.0_dp, 0.7_dp, -1.2000001_dp, &
         1.700000001_dp, 0.2000000001_dp, -40.0_dp, 3.0e6_dp]
      real(dp) :: integral(2), value(2), s(3)
      integer :: i

      m = uneven()
      do i = 1, size(x)
         integral = [brute_integral(m%s, m%p, x(i)), brute_integral(m%s, m%q, x(i))]
#line 90 "/work/main/tests/classical/classical_sampled_traction.pf"
  call assertLessThan(maxval(abs(m%integral_at(x(i)) - integral)), round_off*(1 + maxval(abs(integral))), &
 & location=SourceLocation( &
 & 'classical_sampled_traction.pf', &
 & 90) )
  if (anyExceptions()) return
#line 91 "/work/main/tests/classical/classical_sampled_traction.pf"
         value = m%value_at(x(i))
         s = [-value(1) - 2/pi*integral(2), -value(1), -value(2)]
#line 93 "/work/main/tests/classical/classical_sampled_traction.pf"
  call assertLessThan(norm2(m%stress_at(x(i), 0.0_dp) - s), round_off*(1 + norm2(s)), &
 & location=SourceLocation( &
 & 'classical_sampled_traction.pf', &
 & 93) )
  if (anyExceptions()) return
#line 94 "/work/main/tests/classical/classical_sampled_traction.pf"
      end do
#line 95 "/work/main/tests/classical/classical_sampled_traction.pf"
  call assertRelativelyEqual(m%integral_at(3.0e6_dp), integral, tolerance=round_off, &
 & location=SourceLocation( &
 & 'classical_sampled_traction.pf', &
 & 95) )
  if (anyExceptions()) return
#line 96 "/work/main/tests/classical/classical_sampled_traction.pf"
#line 96 "/work/main/tests/classical/classical_sampled_traction.pf"
  call assertEqual([1.75_dp, 0.55_dp], m%value_at(0.15_dp), tolerance=round_off, &
 & location=SourceLocation( &
 & 'classical_sampled_traction.pf', &
 & 96) )
  if (anyExceptions()) return
#line 97 "/work/main/tests/classical/classical_sampled_traction.pf"
#line 97 "/work/main/tests/classical/classical_sampled_traction.pf"
  call assertEqual([0.4_dp, 1.0_dp], m%value_at(-0.69_dp), tolerance=round_off, &
 & location=SourceLocation( &
 & 'classical_sampled_traction.pf', &
 & 97) )
  if (anyExceptions()) return
#line 98 "/work/main/tests/classical/classical_sampled_traction.pf"
#line 98 "/work/main/tests/classical/classical_sampled_traction.pf"
  call assertEqual([0.0_dp, 0.0_dp], m%value_at(1.8_dp), &
 & location=SourceLocation( &
 & 'classical_sampled_traction.pf', &
 & 98) )
  if (anyExceptions()) return
#line 99 "/work/main/tests/classical/classical_sampled_traction.pf"
   end subroutine test_surface

   !> n samples from -1 to 1, dense at the ends, of a function: 0 uniform, 1 sqrt(1 - x^2).
   type(sampled_traction_t) function graded(n, kind) result(samples)
      integer, intent(in) :: n, kind
      integer :: i

      samples%s = [(-cos(pi*i/(n - 1)), i=0, n - 1)]
      samples%p = [(sin(pi*i/(n - 1))**kind, i=0, n - 1)]
      samples%q = -0.5_dp*samples%p
   end function graded

   ! Uniform tractions are those of the closed form, with few samples and with many.
   !@test
   subroutine test_uniform()
      type(sampled_traction_t) :: m
      real(dp), parameter :: x(6) = [-1.0_dp, -0.3_dp, 0.0_dp, 0.999_dp, 1.5_dp, 3.0e3_dp]
      real(dp) :: y, s(3)
      integer :: i, k, n

      do n = 3, 20003, 10000
         m = graded(n, 0)
         do i = 1, size(x)
            do k = -9, 9
               y = 10.0_dp**k
               s = uniform_strip_stress(1.0_dp, -0.5_dp, x(i), y)
#line 125 "/work/main/tests/classical/classical_sampled_traction.pf"
  call assertLessThan(difference(s, m%stress_at(x(i), y)), round_off_of_many, &
 & location=SourceLocation( &
 & 'classical_sampled_traction.pf', &
 & 125) )
  if (anyExceptions()) return
#line 126 "/work/main/tests/classical/classical_sampled_traction.pf"
            end do
         end do
#line 128 "/work/main/tests/classical/classical_sampled_traction.pf"
  call assertEqual([1.0_dp, -0.5_dp]*uniform_strip_integral(0.3_dp), m%integral_at(0.3_dp), tolerance=round_off_of_many, &
 & location=SourceLocation( &
 & 'classical_sampled_traction.pf', &
 & 128) )
  if (anyExceptions()) return
#line 129 "/work/main/tests/classical/classical_sampled_traction.pf"
#line 129 "/work/main/tests/classical/classical_sampled_traction.pf"
  call assertEqual([1.0_dp, -0.5_dp]*uniform_strip_integral(-2.0_dp), m%integral_at(-2.0_dp), tolerance=round_off_of_many, &
 & location=SourceLocation( &
 & 'classical_sampled_traction.pf', &
 & 129) )
  if (anyExceptions()) return
#line 130 "/work/main/tests/classical/classical_sampled_traction.pf"
      end do
#line 131 "/work/main/tests/classical/classical_sampled_traction.pf"
  call assertTrue(all(ieee_is_nan(m%stress_at(1.0_dp, 0.0_dp))), &
 & location=SourceLocation( &
 & 'classical_sampled_traction.pf', &
 & 131) )
  if (anyExceptions()) return
#line 132 "/work/main/tests/classical/classical_sampled_traction.pf"
#line 132 "/work/main/tests/classical/classical_sampled_traction.pf"
  call assertTrue(all(ieee_is_nan(m%integral_at(-1.0_dp))), &
 & location=SourceLocation( &
 & 'classical_sampled_traction.pf', &
 & 132) )
  if (anyExceptions()) return
#line 133 "/work/main/tests/classical/classical_sampled_traction.pf"
   end subroutine test_uniform

   ! A triangle on |x| < 1, on its axis: s_yy = -(2/pi) atan(1/y), s_xx = s_yy + (2/pi) y ln((1 + y^2)/y^2).
   !@test
   subroutine test_triangle()
      type(sampled_traction_t) :: m
      real(dp) :: y, across, along
      integer :: k

      m%s = [-1.0_dp, 0.0_dp, 1.0_dp]
      m%p = [0.0_dp, 1.0_dp, 0.0_dp]
      m%q = 0*m%p
      do k = -9, 3
         y = 10.0_dp**k
         across = -2/pi*atan2(1.0_dp, y)
         if (k < 0) then
            along = 2/pi*y*log((1 + y*y)/(y*y))
         else
            along = 4/pi*y*atanh(1/(1 + 2*y*y))
         end if
#line 153 "/work/main/tests/classical/classical_sampled_traction.pf"
  call assertEqual([across + along, across, 0.0_dp], m%stress_at(0.0_dp, y), tolerance=round_off, &
 & location=SourceLocation( &
 & 'classical_sampled_traction.pf', &
 & 153) )
  if (anyExceptions()) return
#line 154 "/work/main/tests/classical/classical_sampled_traction.pf"
      end do
      ! the slope of the surface beside its end: int p/(x - s) ds = 2 x ln x - (x - 1) ln (x - 1) - ... = 3 ln 3 - 4 ln 2 at x = 2
#line 156 "/work/main/tests/classical/classical_sampled_traction.pf"
  call assertEqual([3*log(3.0_dp) - 4*log(2.0_dp), 0.0_dp], m%integral_at(2.0_dp), tolerance=round_off, &
 & location=SourceLocation( &
 & 'classical_sampled_traction.pf', &
 & 156) )
  if (anyExceptions()) return
#line 157 "/work/main/tests/classical/classical_sampled_traction.pf"
   end subroutine test_triangle

   ! Samples of Hertz's tractions, dense at the ends: the second order of the number of pieces. At samples on the
   ! surface the third: the leading error is as 1/sqrt(1 - s^2), whose integral vanishes there.
   !@test
   subroutine test_order()
      real(dp), parameter :: x(5) = [-sqrt(0.5_dp), cos(3*pi/8), 0.3_dp, 1.5_dp, 1.0_dp]
      real(dp), parameter :: y(5) = [0.0_dp, 0.0_dp, 0.5_dp, 1.0_dp, 0.2_dp]
      real(dp), parameter :: expected(5) = [8.0_dp, 8.0_dp, 4.0_dp, 4.0_dp, 4.0_dp]
      ! the next order, from the ends of the strip, is a half higher
      real(dp), parameter :: higher_orders = 0.1_dp
      type(sampled_traction_t) :: m
      real(dp) :: error(2), s(3)
      integer :: i, k

      do i = 1, size(x)
         do k = 1, 2
            m = graded(400*k + 1, 1)
            s = hertz_strip_stress(1.0_dp, -0.5_dp, x(i), y(i))
            error(k) = norm2(s - m%stress_at(x(i), y(i)))
         end do
#line 178 "/work/main/tests/classical/classical_sampled_traction.pf"
  call assertEqual(expected(i), error(1)/error(2), tolerance=higher_orders, &
 & location=SourceLocation( &
 & 'classical_sampled_traction.pf', &
 & 178) )
  if (anyExceptions()) return
#line 179 "/work/main/tests/classical/classical_sampled_traction.pf"
         m = every_second(m)
#line 180 "/work/main/tests/classical/classical_sampled_traction.pf"
  call assertEqual(error(1), norm2(s - m%stress_at(x(i), y(i))), tolerance=round_off_of_many, &
 & location=SourceLocation( &
 & 'classical_sampled_traction.pf', &
 & 180) )
  if (anyExceptions()) return
#line 181 "/work/main/tests/classical/classical_sampled_traction.pf"
      end do
   end subroutine test_order

   ! Lines at any depth carry the load: x = y tan(th), where the rule of equal parts converges as a power does.
   !@test
   subroutine test_force()
      integer, parameter :: n = 400
      type(sampled_traction_t) :: m
      real(dp) :: th, y, s(3), force(2), load(2)
      integer :: i, k

      m = uneven()
      associate (step => m%s(2:) - m%s(:5))
         load = [sum(step*(m%p(2:) + m%p(:5)))/2, sum(step*(m%q(2:) + m%q(:5)))/2]
      end associate
      do k = 0, 4
         y = 10.0_dp**k
         force = 0
         do i = 1, n
            th = pi*(i - 0.5_dp)/n - pi/2
            s = m%stress_at(y*tan(th), y)
            force = force - s(2:3)*y/cos(th)**2*pi/n
         end do
#line 204 "/work/main/tests/classical/classical_sampled_traction.pf"
  call assertRelativelyEqual(load, force, tolerance=round_off_of_many, &
 & location=SourceLocation( &
 & 'classical_sampled_traction.pf', &
 & 204) )
  if (anyExceptions()) return
#line 205 "/work/main/tests/classical/classical_sampled_traction.pf"
      end do
   end subroutine test_force

   ! Equilibrium, and s_xx + s_yy harmonic, by differences.
   !@test
   subroutine test_equilibrium()
      real(dp), parameter :: step = 2.0e-3_dp, x(4) = [-0.7_dp, 0.1_dp, 0.8_dp, 2.5_dp], y(4) = [0.5_dp, 0.9_dp, 1.0_dp, 0.6_dp]
      ! step^4/30 of a fifth derivative of 24 max(p)/y^5, and epsilon/step^2
      real(dp), parameter :: differences = 1.0e-7_dp
      type(sampled_traction_t) :: m
      real(dp) :: dx(3), dy(3), laplacian
      integer :: i

      m = uneven()
      do i = 1, size(x)
         dx = (8*(at(1, 0) - at(-1, 0)) - at(2, 0) + at(-2, 0))/(12*step)
         dy = (8*(at(0, 1) - at(0, -1)) - at(0, 2) + at(0, -2))/(12*step)
#line 222 "/work/main/tests/classical/classical_sampled_traction.pf"
  call assertEqual([0.0_dp, 0.0_dp], [dx(1) + dy(3), dx(3) + dy(2)], tolerance=differences, &
 & location=SourceLocation( &
 & 'classical_sampled_traction.pf', &
 & 222) )
  if (anyExceptions()) return
#line 223 "/work/main/tests/classical/classical_sampled_traction.pf"
         laplacian = sum([1, 1, 0]*(16*(at(1, 0) + at(-1, 0) + at(0, 1) + at(0, -1)) - at(2, 0) - at(-2, 0) - at(0, 2) &
            - at(0, -2) - 60*at(0, 0)))/(12*step**2)
#line 225 "/work/main/tests/classical/classical_sampled_traction.pf"
  call assertEqual(0.0_dp, laplacian, tolerance=10*differences, &
 & location=SourceLocation( &
 & 'classical_sampled_traction.pf', &
 & 225) )
  if (anyExceptions()) return
#line 226 "/work/main/tests/classical/classical_sampled_traction.pf"
      end do

   contains

      function at(k, l)
         integer, intent(in) :: k, l
         real(dp) :: at(3)

         at = m%stress_at(x(i) + k*step, y(i) + l*step)
      end function at

   end subroutine test_equilibrium

   ! Far away it is the line load.
   !@test
   subroutine test_far_away()
      type(sampled_traction_t) :: m
      real(dp) :: s(3)

      m%s = [-1.0_dp, 0.0_dp, 1.0_dp]
      m%p = [0.0_dp, 1.0_dp, 0.0_dp]
      m%q = 0*m%p
      s = m%stress_at(3.0e9_dp, 4.0e9_dp)
#line 249 "/work/main/tests/classical/classical_sampled_traction.pf"
  call assertRelativelyEqual(-2*0.8_dp/(pi*5.0e9_dp)*[0.36_dp, 0.64_dp, 0.48_dp], s, tolerance=round_off, &
 & location=SourceLocation( &
 & 'classical_sampled_traction.pf', &
 & 249) )
  if (anyExceptions()) return
#line 250 "/work/main/tests/classical/classical_sampled_traction.pf"
   end subroutine test_far_away

end module classical_sampled_traction

module Wrapclassical_sampled_traction
   use FUnit
   use classical_sampled_traction
   implicit none
   private

contains


end module Wrapclassical_sampled_traction

function classical_sampled_traction_suite() result(suite)
   use FUnit
   use classical_sampled_traction
   use Wrapclassical_sampled_traction
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_sampled_traction_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_quadrature', &
      test_quadrature))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_hard_samples', &
      test_hard_samples))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_surface', &
      test_surface))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_uniform', &
      test_uniform))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_triangle', &
      test_triangle))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_order', &
      test_order))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_force', &
      test_force))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_equilibrium', &
      test_equilibrium))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_far_away', &
      test_far_away))
   call suite%addTest(t)


end function classical_sampled_traction_suite

