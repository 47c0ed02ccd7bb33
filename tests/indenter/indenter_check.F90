! SPDX-License-Identifier: GPL-3.0-or-later
! What the model `indenter` refuses, and hard cases that it does not.
module indenter_check
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_unset, only: unset
   use adfric_indenter_model, only: indenter_model_t
   use adfric_indenter_variables
   use adfric_model_status, only: status_solved, status_no_equilibrium
   use indenter_cases, only: new_indenter, hold, n_kinds
   use model_calls, only: find_problems, solve_point
   use funit
   implicit none (type, external)

contains

   !> A case without problems, but for what is done to it.
   subroutine check_text(model, values, expected)
      type(indenter_model_t), intent(in) :: model
      real(dp), intent(in) :: values(:)
      character(*), intent(in) :: expected
      character(:), allocatable :: text

      text = find_problems(model, values)
      if (expected == '') then
#line 27 "/work/main/tests/indenter/indenter_check.pf"
  call assertEqual('', text, &
 & location=SourceLocation( &
 & 'indenter_check.pf', &
 & 27) )
  if (anyExceptions()) return
#line 28 "/work/main/tests/indenter/indenter_check.pf"
      else
#line 29 "/work/main/tests/indenter/indenter_check.pf"
  call assertGreaterThan(index(text, expected), 0, message=text//' lacks '//expected, &
 & location=SourceLocation( &
 & 'indenter_check.pf', &
 & 29) )
  if (anyExceptions()) return
#line 30 "/work/main/tests/indenter/indenter_check.pf"
      end if
   end subroutine check_text

   ! All kinds are accepted as they are; what a kind needs and has not is missed.
   !@test
   subroutine test_needs()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: kept
      integer :: kind, k

      do kind = 1, n_kinds
         call new_indenter(model, values, kind)
         call hold(values, v_load, 1.0_dp)
         call check_text(model, values, '')
         do k = v_radius, v_face_radius
            if (.not. values(k) < unset) cycle
            kept = values(k)
            values(k) = unset
            call check_text(model, values, '&shape '//model%variables(k)%name//': is missing')
            values(k) = kept
         end do
         do k = v_radius, v_coefficient_8
            if (values(k) < unset .and. .not. abs(values(k)) > 0) cycle
            if (kind == kind_polynomial .and. k >= v_coefficient_1) cycle
            if (values(k) < unset) cycle
            if (k == v_half_angle .and. values(v_slope) < unset) cycle
            values(k) = 0.7_dp
            call check_text(model, values, '&shape '//model%variables(k)%name//': has no meaning for kind')
            values(k) = unset
         end do
         values(v_contact_modulus) = unset
         call check_text(model, values, '&solid contact_modulus: is missing')
      end do
      values(v_kind) = unset
      call check_text(model, values, '&shape kind: is missing')
   end subroutine test_needs

   ! Contradictions.
   !@test
   subroutine test_contradictions()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)

      call new_indenter(model, values, kind_cone)
      call check_text(model, values, &
         & '&operating load: is missing; one of load, approach, contact_radius, face_angle or base_approach')
      call hold(values, v_load, 1.0_dp)
      values(v_half_angle) = 1
      call check_text(model, values, '&shape slope: stands beside half_angle')
      values(v_half_angle) = unset
      values(v_approach) = 1
      call check_text(model, values, '&operating load: stands beside approach')
      call hold(values, v_face_angle, 0.1_dp)
      call check_text(model, values, '&operating face_angle: has a meaning only for')
      call hold(values, v_contact_radius, 0.1_dp)
      values(v_branch) = 2
      call check_text(model, values, '&operating branch: has no meaning with contact_radius')
      values(v_branch) = 1
      values(v_theory) = choose_jkr
      call check_text(model, values, '&adhesion work_of_adhesion: is missing')
      values(v_theory) = choose_none
      values(v_work_of_adhesion) = 1
      call check_text(model, values, '&adhesion work_of_adhesion: has no meaning for theory = ''none''')
      values(v_theory) = choose_auto
      values(v_profiles) = 1
      call check_text(model, values, '&output r_max: is missing')
      values(v_profiles) = 0
      call new_indenter(model, values, kind_polynomial)
      call hold(values, v_load, 1.0_dp)
      values(v_coefficient_1:v_coefficient_8) = 0
      call check_text(model, values, '&shape coefficient_1: is 0 like all coefficients')
   end subroutine test_contradictions

   ! Theories: a range belongs to Maugis-Dugdale, DMT to r^2, lambda to powers.
   !@test
   subroutine test_theories()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      integer :: kind

      do kind = 1, n_kinds
         call new_indenter(model, values, kind)
         call hold(values, v_load, 0.0_dp)
         values([v_work_of_adhesion, v_theory]) = [0.01_dp, real(choose_dmt, dp)]
         if (kind == kind_paraboloid) then
            call check_text(model, values, '')
         else
            call check_text(model, values, '&model theory: is ''dmt'', which only r^2 has')
         end if
         values(v_theory) = choose_maugis_dugdale
         call check_text(model, values, '&adhesion adhesion_stress: is missing; one of adhesion_stress, adhesion_range or lambda')
         values(v_adhesion_range) = 0.1_dp
         call check_text(model, values, '')
         values(v_adhesion_stress) = 0.1_dp
         call check_text(model, values, '&adhesion adhesion_stress: stands beside adhesion_range')
         values([v_adhesion_stress, v_adhesion_range]) = unset
         values(v_lambda) = 1
         if (any(kind == [kind_cone, kind_paraboloid, kind_power])) then
            call check_text(model, values, '')
         else
            call check_text(model, values, '&adhesion lambda: has a meaning only for')
         end if
         values(v_work_of_adhesion) = unset
         call check_text(model, values, '&adhesion work_of_adhesion: is missing')
      end do
      call new_indenter(model, values, kind_power)
      call hold(values, v_load, 0.0_dp)
      values([v_exponent, v_work_of_adhesion, v_lambda]) = [0.9_dp, 1.0_dp, 1.0_dp]
      call check_text(model, values, '&shape exponent: is too small for adhesion of a range')
      call new_indenter(model, values, kind_sphere)
      call hold(values, v_load, 0.0_dp)
      values([v_work_of_adhesion, v_adhesion_range]) = [0.01_dp, 1.5_dp]
      call check_text(model, values, '&shape radius: is so small that adhesion would reach beyond the sphere')
   end subroutine test_theories

   ! Radii that no contact has, exponents without a stable state, and what is beyond all numbers.
   !@test
   subroutine test_impossible()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: results(n_indenter_results), error_estimate
      integer :: status

      call new_indenter(model, values, kind_flat)
      call hold(values, v_contact_radius, 1.0_dp)
      call check_text(model, values, '&operating contact_radius: has no meaning for kind = ''flat''')
      call new_indenter(model, values, kind_sphere)
      call hold(values, v_contact_radius, 1.0_dp)
      call check_text(model, values, '&operating contact_radius: is not smaller than the radius of the sphere')
      call solve_point(model, values, results, error_estimate, status)
#line 161 "/work/main/tests/indenter/indenter_check.pf"
  call assertEqual(status_no_equilibrium, status, &
 & location=SourceLocation( &
 & 'indenter_check.pf', &
 & 161) )
  if (anyExceptions()) return
#line 162 "/work/main/tests/indenter/indenter_check.pf"
      call new_indenter(model, values, kind_flat_cone)
      call hold(values, v_contact_radius, 0.999_dp)
      call check_text(model, values, '&operating contact_radius: is smaller than face_radius')
      call solve_point(model, values, results, error_estimate, status)
#line 166 "/work/main/tests/indenter/indenter_check.pf"
  call assertEqual(status_no_equilibrium, status, &
 & location=SourceLocation( &
 & 'indenter_check.pf', &
 & 166) )
  if (anyExceptions()) return
#line 167 "/work/main/tests/indenter/indenter_check.pf"
      call new_indenter(model, values, kind_power)
      call hold(values, v_load, 1.0_dp)
      values(v_exponent) = 0.5_dp
      call check_text(model, values, '')
      values(v_work_of_adhesion) = 1
      call check_text(model, values, '&shape exponent: is too small for adhesion')
      values(v_exponent) = 2
      values(v_load) = 1.0e90_dp
      call check_text(model, values, '&operating load: is beyond all numbers')
   end subroutine test_impossible

   ! Without adhesion nothing pulls; at no load there is a touch without area.
   !@test
   subroutine test_no_adhesion()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: results(n_indenter_results), error_estimate
      integer :: kind, status

      do kind = 1, n_kinds
         call new_indenter(model, values, kind)
         call hold(values, v_load, -1.0e-3_dp)
         call solve_point(model, values, results, error_estimate, status)
#line 190 "/work/main/tests/indenter/indenter_check.pf"
  call assertEqual(status_no_equilibrium, status, &
 & location=SourceLocation( &
 & 'indenter_check.pf', &
 & 190) )
  if (anyExceptions()) return
#line 191 "/work/main/tests/indenter/indenter_check.pf"
#line 191 "/work/main/tests/indenter/indenter_check.pf"
  call assertEqual(0.0_dp, results(r_pull_off_load), &
 & location=SourceLocation( &
 & 'indenter_check.pf', &
 & 191) )
  if (anyExceptions()) return
#line 192 "/work/main/tests/indenter/indenter_check.pf"
#line 192 "/work/main/tests/indenter/indenter_check.pf"
  call assertEqual(0.0_dp, results(r_pull_off_approach), &
 & location=SourceLocation( &
 & 'indenter_check.pf', &
 & 192) )
  if (anyExceptions()) return
#line 193 "/work/main/tests/indenter/indenter_check.pf"
         call hold(values, v_load, 0.0_dp)
         call solve_point(model, values, results, error_estimate, status)
#line 195 "/work/main/tests/indenter/indenter_check.pf"
  call assertEqual(status_solved, status, &
 & location=SourceLocation( &
 & 'indenter_check.pf', &
 & 195) )
  if (anyExceptions()) return
#line 196 "/work/main/tests/indenter/indenter_check.pf"
#line 196 "/work/main/tests/indenter/indenter_check.pf"
  call assertEqual(0.0_dp, results(r_approach), &
 & location=SourceLocation( &
 & 'indenter_check.pf', &
 & 196) )
  if (anyExceptions()) return
#line 197 "/work/main/tests/indenter/indenter_check.pf"
      end do
   end subroutine test_no_adhesion

   ! Exponents next to 1/2 and of 16 and 100, tiny and huge works of adhesion: pull-off by its closed form.
   !@test
   subroutine test_hard_powers()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: results(n_indenter_results), error_estimate, fold, work
      real(dp), parameter :: exponents(*) = [0.51_dp, 0.6_dp, 1.0_dp, 3.7_dp, 16.0_dp, 100.0_dp]
      integer :: k, decade, status

      do k = 1, size(exponents)
         do decade = -20, 10, 10
            work = 10.0_dp**decade
            if (k == 1) work = 0.1_dp
            call new_indenter(model, values, kind_power)
            values([v_exponent, v_work_of_adhesion]) = [exponents(k), work]
            call hold(values, v_load, 0.0_dp)
            call solve_point(model, values, results, error_estimate, status)
            ! radii are like w^(1/(2 n - 1))
            if (abs(decade) > 60*(2*exponents(k) - 1)) cycle
#line 219 "/work/main/tests/indenter/indenter_check.pf"
  call assertEqual(status_solved, status, &
 & location=SourceLocation( &
 & 'indenter_check.pf', &
 & 219) )
  if (anyExceptions()) return
#line 220 "/work/main/tests/indenter/indenter_check.pf"
            call hold(values, v_contact_radius, results(r_contact_radius))
            call solve_point(model, values, results, error_estimate, status)
            fold = results(r_pull_off_load)
            ! P = -((2 n - 1)/(n + 1)) sqrt(2 pi w E* a^3), where a g' = (3/2) Dl; the load has half the digits of a there
            call hold(values, v_load, fold*(1 - 1.0e-15_dp))
            call solve_point(model, values, results, error_estimate, status)
#line 226 "/work/main/tests/indenter/indenter_check.pf"
  call assertEqual(status_solved, status, &
 & location=SourceLocation( &
 & 'indenter_check.pf', &
 & 226) )
  if (anyExceptions()) return
#line 227 "/work/main/tests/indenter/indenter_check.pf"
            associate (n => exponents(k), a => results(r_contact_radius))
#line 228 "/work/main/tests/indenter/indenter_check.pf"
  call assertRelativelyEqual(-(2*n - 1)/(n + 1)*sqrt(2*pi*work*a**3), fold, tolerance=1.0e-5_dp, &
 & location=SourceLocation( &
 & 'indenter_check.pf', &
 & 228) )
  if (anyExceptions()) return
#line 229 "/work/main/tests/indenter/indenter_check.pf"
            end associate
         end do
      end do
   end subroutine test_hard_powers

   ! The pressure of JKR is infinite at the edge, that of a cone at its tip, and nowhere else.
   !@test
   subroutine test_infinite_pressures()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: results(n_indenter_results), profiles(5, 1, 2), error_estimate
      integer :: kind, status

      do kind = 1, n_kinds
         if (kind == kind_flat) cycle
         call new_indenter(model, values, kind)
         values(v_work_of_adhesion) = 0.01_dp
         call hold(values, v_contact_radius, 1.25_dp)
         if (kind == kind_sphere) call hold(values, v_contact_radius, 0.5_dp)
         values([v_profiles, v_n_r]) = [1, 5]
         values(v_r_max) = 2*values(v_contact_radius)
         call solve_point(model, values, results, error_estimate, status)
         call model%solve_profiles(values, results, profiles)
#line 252 "/work/main/tests/indenter/indenter_check.pf"
  call assertTrue(ieee_is_nan(profiles(3, 1, p_pressure)), &
 & location=SourceLocation( &
 & 'indenter_check.pf', &
 & 252) )
  if (anyExceptions()) return
#line 253 "/work/main/tests/indenter/indenter_check.pf"
#line 253 "/work/main/tests/indenter/indenter_check.pf"
  call assertTrue(ieee_is_nan(profiles(1, 1, p_pressure)) .eqv. kind == kind_cone, &
 & location=SourceLocation( &
 & 'indenter_check.pf', &
 & 253) )
  if (anyExceptions()) return
#line 254 "/work/main/tests/indenter/indenter_check.pf"
#line 254 "/work/main/tests/indenter/indenter_check.pf"
  call assertFalse(ieee_is_nan(profiles(2, 1, p_pressure)), &
 & location=SourceLocation( &
 & 'indenter_check.pf', &
 & 254) )
  if (anyExceptions()) return
#line 255 "/work/main/tests/indenter/indenter_check.pf"
#line 255 "/work/main/tests/indenter/indenter_check.pf"
  call assertEqual(0.0_dp, profiles(4, 1, p_pressure), &
 & location=SourceLocation( &
 & 'indenter_check.pf', &
 & 255) )
  if (anyExceptions()) return
#line 256 "/work/main/tests/indenter/indenter_check.pf"
#line 256 "/work/main/tests/indenter/indenter_check.pf"
  call assertEqual(0.0_dp, profiles(3, 1, p_gap), &
 & location=SourceLocation( &
 & 'indenter_check.pf', &
 & 256) )
  if (anyExceptions()) return
#line 257 "/work/main/tests/indenter/indenter_check.pf"
#line 257 "/work/main/tests/indenter/indenter_check.pf"
  call assertGreaterThan(profiles(4, 1, p_gap), 0.0_dp, &
 & location=SourceLocation( &
 & 'indenter_check.pf', &
 & 257) )
  if (anyExceptions()) return
#line 258 "/work/main/tests/indenter/indenter_check.pf"
#line 258 "/work/main/tests/indenter/indenter_check.pf"
  call assertTrue(ieee_is_nan(profiles(5, 1, p_gap)) .eqv. kind == kind_sphere, &
 & location=SourceLocation( &
 & 'indenter_check.pf', &
 & 258) )
  if (anyExceptions()) return
#line 259 "/work/main/tests/indenter/indenter_check.pf"
      end do
   end subroutine test_infinite_pressures

end module indenter_check

module Wrapindenter_check
   use FUnit
   use indenter_check
   implicit none
   private

contains


end module Wrapindenter_check

function indenter_check_suite() result(suite)
   use FUnit
   use indenter_check
   use Wrapindenter_check
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('indenter_check_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_needs', &
      test_needs))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_contradictions', &
      test_contradictions))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_theories', &
      test_theories))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_impossible', &
      test_impossible))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_no_adhesion', &
      test_no_adhesion))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_hard_powers', &
      test_hard_powers))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_infinite_pressures', &
      test_infinite_pressures))
   call suite%addTest(t)


end function indenter_check_suite

