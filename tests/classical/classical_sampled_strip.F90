! SPDX-License-Identifier: GPL-3.0-or-later
! The model `strip_load` with sampled tractions: results, error estimate, units, and what is rejected.
module classical_sampled_strip
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: unset
   use adfric_model_status, only: status_solved
   use trial_case, only: trial_case_t, new_case
   use funit
   implicit none (type, external)

   real(dp), parameter :: round_off = 100*epsilon(1.0_dp), sampled = 3

contains

   !> Hand over a dataset as the program does; how many problems it has.
   integer function take(case, name, samples)
      type(trial_case_t), intent(inout) :: case
      character(*), intent(in) :: name
      real(dp), intent(in) :: samples(:)
      type(problems_t) :: problems

      call case%model%take_dataset(case%model%index_of('samples', name), reshape(samples, [size(samples), 1]), problems)
      call case%give(name, 1.0_dp)
      take = problems%count()
   end function take

   !> n samples of Hertz's tractions, dense at the ends, in other units.
   subroutine new_sampled(case, n, metre, pascal, shear)
      type(trial_case_t), intent(out) :: case
      integer, intent(in) :: n
      real(dp), intent(in) :: metre, pascal
      !> Ratio of q to p.
      real(dp), intent(in) :: shear
      real(dp) :: s(n), p(n)
      integer :: i

      s = [(-cos(pi*i/(n - 1)), i=0, n - 1)]
      p = sqrt(max(0.0_dp, 1 - s*s))
      call new_case(case, 'strip_load')
      call case%give('young_modulus', 3.0_dp*pascal)
      call case%give('poisson_ratio', 0.3_dp)
      call case%give('distribution', sampled)
#line 46 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertEqual(0, take(case, 'positions', s*metre), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 46) )
  if (anyExceptions()) return
#line 47 "/work/main/tests/classical/classical_sampled_strip.pf"
#line 47 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertEqual(0, take(case, 'pressures', p*pascal), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 47) )
  if (anyExceptions()) return
#line 48 "/work/main/tests/classical/classical_sampled_strip.pf"
      if (abs(shear) > 0) then
#line 49 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertEqual(0, take(case, 'shear_tractions', shear*p*pascal), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 49) )
  if (anyExceptions()) return
#line 50 "/work/main/tests/classical/classical_sampled_strip.pf"
      end if
   end subroutine new_sampled

   !> The same in closed form.
   subroutine new_hertz(case, shear)
      type(trial_case_t), intent(out) :: case
      real(dp), intent(in) :: shear

      call new_case(case, 'strip_load')
      call case%give('young_modulus', 3.0_dp)
      call case%give('poisson_ratio', 0.3_dp)
      call case%give('distribution', 2.0_dp)
      call case%give('half_width', 1.0_dp)
      call case%give('normal_traction', 1.0_dp)
      call case%give('tangential_traction', shear)
   end subroutine new_hertz

   subroutine solve_at(case, x, y)
      type(trial_case_t), intent(inout) :: case
      real(dp), intent(in) :: x, y

      call case%give('position_x', x)
      call case%give('position_y', y)
      call case%solve()
   end subroutine solve_at

   ! All results against Hertz's; the estimate is not less than the error, and not much more.
   !@test
   subroutine test_error_estimate()
      real(dp), parameter :: x(5) = [0.0_dp, 0.4_dp, -0.97_dp, 1.3_dp, -5.0_dp], y(3) = [0.0_dp, 0.03_dp, 2.0_dp]
      type(trial_case_t) :: case, exact
      real(dp) :: error
      integer :: i, j

      call new_sampled(case, 201, 1.0_dp, 1.0_dp, -0.4_dp)
      call new_hertz(exact, -0.4_dp)
#line 86 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 86) )
  if (anyExceptions()) return
#line 87 "/work/main/tests/classical/classical_sampled_strip.pf"
      do j = 1, size(y)
         do i = 1, size(x)
            call solve_at(case, x(i), y(j))
            call solve_at(exact, x(i), y(j))
#line 91 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 91) )
  if (anyExceptions()) return
#line 92 "/work/main/tests/classical/classical_sampled_strip.pf"
            error = norm2(case%results(:3, 1) - exact%results(:3, 1))/norm2(case%results(:3, 1))
#line 93 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertLessThan(error, case%error_estimate(1), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 93) )
  if (anyExceptions()) return
#line 94 "/work/main/tests/classical/classical_sampled_strip.pf"
#line 94 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertGreaterThan(20*error, case%error_estimate(1), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 94) )
  if (anyExceptions()) return
#line 95 "/work/main/tests/classical/classical_sampled_strip.pf"
            ! of 200 pieces, to the second order
#line 96 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertEqual(exact%results(4:, 1), case%results(4:, 1), tolerance=20.0_dp/200**2, &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 96) )
  if (anyExceptions()) return
#line 97 "/work/main/tests/classical/classical_sampled_strip.pf"
         end do
      end do
   end subroutine test_error_estimate

   !@test
   subroutine test_other_units()
      real(dp), parameter :: metre = 1.0e-9_dp, pascal = 1.0e10_dp
      type(trial_case_t) :: case, other
      real(dp) :: unit(6)

      unit = [pascal, pascal, pascal, pascal, 1.0_dp, 1.0_dp]
      call new_sampled(case, 51, 1.0_dp, 1.0_dp, 0.7_dp)
      call new_sampled(other, 51, metre, pascal, 0.7_dp)
      call solve_at(case, 0.3_dp, 0.2_dp)
      call solve_at(other, 0.3_dp*metre, 0.2_dp*metre)
#line 112 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertRelativelyEqual(case%results(:, 1)*unit, other%results(:, 1), tolerance=10*round_off, &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 112) )
  if (anyExceptions()) return
#line 113 "/work/main/tests/classical/classical_sampled_strip.pf"
   end subroutine test_other_units

   ! Without shear tractions there are none; maps are the field.
   !@test
   subroutine test_maps()
      type(trial_case_t) :: case
      real(dp), allocatable :: maps(:, :, :)

      call new_sampled(case, 51, 1.0_dp, 1.0_dp, 0.0_dp)
      call case%give('profiles', 1.0_dp)
      call case%give('x_max', 2.0_dp)
      call case%give('n_x', 3.0_dp)
#line 125 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 125) )
  if (anyExceptions()) return
#line 126 "/work/main/tests/classical/classical_sampled_strip.pf"
      call solve_at(case, 1.0_dp, 0.0_dp)
#line 127 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertEqual(0.0_dp, maxval(abs(case%results(2:3, 1))), tolerance=round_off, &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 127) )
  if (anyExceptions()) return
#line 128 "/work/main/tests/classical/classical_sampled_strip.pf"
      call case%get_profiles(maps)
#line 129 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertEqual(case%results(:, 1), maps(2, 1, :), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 129) )
  if (anyExceptions()) return
#line 130 "/work/main/tests/classical/classical_sampled_strip.pf"
#line 130 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertEqual(0.0_dp, maps(1, 1, 3), tolerance=round_off, &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 130) )
  if (anyExceptions()) return
#line 131 "/work/main/tests/classical/classical_sampled_strip.pf"
#line 131 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertEqual(-1.0_dp, maps(1, 1, 2), tolerance=round_off, &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 131) )
  if (anyExceptions()) return
#line 132 "/work/main/tests/classical/classical_sampled_strip.pf"
   end subroutine test_maps

   ! Where a traction jumps, on the surface, there are no values, as for uniform ones.
   !@test
   subroutine test_jump()
      type(trial_case_t) :: case

      call new_sampled(case, 5, 1.0_dp, 1.0_dp, 0.0_dp)
#line 140 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertEqual(0, take(case, 'pressures', [1.0_dp, 1.0_dp, 1.0_dp, 1.0_dp, 0.0_dp]), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 140) )
  if (anyExceptions()) return
#line 141 "/work/main/tests/classical/classical_sampled_strip.pf"
      call solve_at(case, -1.0_dp, 0.0_dp)
#line 142 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertTrue(all(ieee_is_nan(case%results(:, 1))), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 142) )
  if (anyExceptions()) return
#line 143 "/work/main/tests/classical/classical_sampled_strip.pf"
      call solve_at(case, -1.0_dp, 0.1_dp)
#line 144 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertFalse(any(ieee_is_nan(case%results(:4, 1))), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 144) )
  if (anyExceptions()) return
#line 145 "/work/main/tests/classical/classical_sampled_strip.pf"
#line 145 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertTrue(all(ieee_is_nan(case%results(5:, 1))), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 145) )
  if (anyExceptions()) return
#line 146 "/work/main/tests/classical/classical_sampled_strip.pf"
      call solve_at(case, 1.0_dp, 0.0_dp)
#line 147 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertFalse(any(ieee_is_nan(case%results(:, 1))), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 147) )
  if (anyExceptions()) return
#line 148 "/work/main/tests/classical/classical_sampled_strip.pf"
   end subroutine test_jump

   !> Is this one of the problems of a case?
   logical function says(case, text)
      type(trial_case_t), intent(in) :: case
      character(*), intent(in) :: text

      says = index(case%problems_of(), 'case: &'//text) > 0
   end function says

   !@test
   subroutine test_rejections()
      type(trial_case_t) :: case

      call new_sampled(case, 5, 1.0_dp, 1.0_dp, 0.5_dp)
#line 163 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 163) )
  if (anyExceptions()) return
#line 164 "/work/main/tests/classical/classical_sampled_strip.pf"
#line 164 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertEqual(1, take(case, 'positions', [0.0_dp, 1.0_dp, 1.0_dp, 2.0_dp, 3.0_dp]), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 164) )
  if (anyExceptions()) return
#line 165 "/work/main/tests/classical/classical_sampled_strip.pf"
#line 165 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertEqual(1, take(case, 'positions', [0.0_dp, 1.0_dp, 0.5_dp, 2.0_dp, 3.0_dp]), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 165) )
  if (anyExceptions()) return
#line 166 "/work/main/tests/classical/classical_sampled_strip.pf"
#line 166 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertEqual(0, take(case, 'positions', [0.0_dp, 1.0_dp, 1.5_dp, 2.0_dp]), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 166) )
  if (anyExceptions()) return
#line 167 "/work/main/tests/classical/classical_sampled_strip.pf"
#line 167 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertTrue(says(case, 'samples pressures: has not as many values as positions'), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 167) )
  if (anyExceptions()) return
#line 168 "/work/main/tests/classical/classical_sampled_strip.pf"
#line 168 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertTrue(says(case, 'samples shear_tractions: has not as many values as positions'), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 168) )
  if (anyExceptions()) return
#line 169 "/work/main/tests/classical/classical_sampled_strip.pf"
      call new_sampled(case, 5, 1.0_dp, 1.0_dp, 0.0_dp)
      call case%give('half_width', 1.0_dp)
      call case%give('normal_traction', 1.0_dp)
      call case%give('tangential_traction', 1.0_dp)
#line 173 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertTrue(says(case, 'operating half_width: is given, but the distribution does not take it'), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 173) )
  if (anyExceptions()) return
#line 174 "/work/main/tests/classical/classical_sampled_strip.pf"
#line 174 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertTrue(says(case, 'operating normal_traction: is given, but'), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 174) )
  if (anyExceptions()) return
#line 175 "/work/main/tests/classical/classical_sampled_strip.pf"
#line 175 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertTrue(says(case, 'operating tangential_traction: is given, but'), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 175) )
  if (anyExceptions()) return
#line 176 "/work/main/tests/classical/classical_sampled_strip.pf"
      call case%give('distribution', 1.0_dp)
#line 177 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertTrue(says(case, 'samples positions: is given, but'), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 177) )
  if (anyExceptions()) return
#line 178 "/work/main/tests/classical/classical_sampled_strip.pf"
#line 178 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertTrue(says(case, 'samples pressures: is given, but'), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 178) )
  if (anyExceptions()) return
#line 179 "/work/main/tests/classical/classical_sampled_strip.pf"
#line 179 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertFalse(says(case, 'samples shear_tractions'), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 179) )
  if (anyExceptions()) return
#line 180 "/work/main/tests/classical/classical_sampled_strip.pf"
#line 180 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertFalse(says(case, 'operating'), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 180) )
  if (anyExceptions()) return
#line 181 "/work/main/tests/classical/classical_sampled_strip.pf"
      call new_case(case, 'strip_load')
      call case%give('distribution', sampled)
#line 183 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertTrue(says(case, 'samples positions: is missing [m]'), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 183) )
  if (anyExceptions()) return
#line 184 "/work/main/tests/classical/classical_sampled_strip.pf"
#line 184 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertTrue(says(case, 'samples pressures: is missing [Pa]'), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 184) )
  if (anyExceptions()) return
#line 185 "/work/main/tests/classical/classical_sampled_strip.pf"
#line 185 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertFalse(says(case, 'samples shear_tractions'), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 185) )
  if (anyExceptions()) return
#line 186 "/work/main/tests/classical/classical_sampled_strip.pf"
      call case%give('distribution', 2.0_dp)
#line 187 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertTrue(says(case, 'operating half_width: is missing [m]'), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 187) )
  if (anyExceptions()) return
#line 188 "/work/main/tests/classical/classical_sampled_strip.pf"
      call case%give('distribution', unset)
#line 189 "/work/main/tests/classical/classical_sampled_strip.pf"
  call assertTrue(says(case, 'operating distribution: is missing, one of uniform hertz sampled'), &
 & location=SourceLocation( &
 & 'classical_sampled_strip.pf', &
 & 189) )
  if (anyExceptions()) return
#line 190 "/work/main/tests/classical/classical_sampled_strip.pf"
   end subroutine test_rejections

end module classical_sampled_strip

module Wrapclassical_sampled_strip
   use FUnit
   use classical_sampled_strip
   implicit none
   private

contains


end module Wrapclassical_sampled_strip

function classical_sampled_strip_suite() result(suite)
   use FUnit
   use classical_sampled_strip
   use Wrapclassical_sampled_strip
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_sampled_strip_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_error_estimate', &
      test_error_estimate))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_other_units', &
      test_other_units))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_maps', &
      test_maps))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_jump', &
      test_jump))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_rejections', &
      test_rejections))
   call suite%addTest(t)


end function classical_sampled_strip_suite

