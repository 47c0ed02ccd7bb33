! SPDX-License-Identifier: GPL-3.0-or-later
! Stresses on the axis of an indenter: Hertz's closed form, a flat punch, Boussinesq's integral for the kinds with adhesion,
! far below the contact, and what is refused.
module indenter_stress
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_indenter_model, only: indenter_model_t
   use adfric_indenter_variables
   use adfric_model_status, only: status_solved
   use indenter_cases, only: new_indenter, new_named, hold
   use model_calls, only: find_problems, solve_point
   use reference_table, only: table_digits
   use funit
   implicit none (type, external)

   real(dp), parameter :: nu = 0.3_dp
   real(dp), parameter :: depths(5) = [1.0e-3_dp, 0.1_dp, 0.5_dp, 1.0_dp, 30.0_dp]

contains

   !> The stresses of a case at a depth.
   subroutine get_stresses(model, values, depth, s_zz, s_rr)
      type(indenter_model_t), intent(in) :: model
      real(dp), intent(inout) :: values(:)
      real(dp), intent(in) :: depth
      real(dp), intent(out) :: s_zz, s_rr
      real(dp) :: results(n_indenter_results), error_estimate
      integer :: status

      values([v_poisson_ratio, v_position_z]) = [nu, depth]
      call solve_point(model, values, results, error_estimate, status)
#line 33 "/work/main/tests/indenter/indenter_stress.pf"
  call assertEqual(status_solved, status, &
 & location=SourceLocation( &
 & 'indenter_stress.pf', &
 & 33) )
  if (anyExceptions()) return
#line 34 "/work/main/tests/indenter/indenter_stress.pf"
      s_zz = results(r_stress_zz)
      s_rr = results(r_stress_rr)
   end subroutine get_stresses

   ! p0 = 2 a E*/(pi R): s_zz = -p0/(1 + q^2), s_rr = -p0 [(1 + nu) (1 - q arctan(1/q)) - 1/(2 (1 + q^2))], q = z/a.
   !@test
   subroutine test_hertz()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: s_zz, s_rr, peak, q, expected
      integer :: k

      call new_indenter(model, values, kind_paraboloid)
      values([v_radius, v_contact_modulus]) = [0.02_dp, 3.0e9_dp]
      call hold(values, v_contact_radius, 1.0e-3_dp)
      peak = 2*1.0e-3_dp*3.0e9_dp/(pi*0.02_dp)
      do k = 1, size(depths)
         q = depths(k)
         call get_stresses(model, values, q*1.0e-3_dp, s_zz, s_rr)
         expected = -peak/(1 + q**2)
#line 54 "/work/main/tests/indenter/indenter_stress.pf"
  call assertRelativelyEqual(expected, s_zz, tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_stress.pf', &
 & 54) )
  if (anyExceptions()) return
#line 55 "/work/main/tests/indenter/indenter_stress.pf"
         ! at depth its terms take each other's digits
         expected = -peak*((1 + nu)*(1 - q*atan(1/q)) - 1/(2*(1 + q**2)))
#line 57 "/work/main/tests/indenter/indenter_stress.pf"
  call assertEqual(expected, s_rr, tolerance=table_digits*peak, &
 & location=SourceLocation( &
 & 'indenter_stress.pf', &
 & 57) )
  if (anyExceptions()) return
#line 58 "/work/main/tests/indenter/indenter_stress.pf"
      end do
   end subroutine test_hertz

   ! p = P/(2 pi a sqrt(a^2 - r^2)): s_zz = -P (1 + 3 q^2)/[2 pi a^2 (1 + q^2)^2].
   !@test
   subroutine test_face()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: s_zz, s_rr, expected
      integer :: k

      call new_named(model, values, 'flat', 'b=0.5')
      call hold(values, v_load, 2.0_dp)
      do k = 1, size(depths)
         call get_stresses(model, values, depths(k)/2, s_zz, s_rr)
         associate (q => depths(k))
            expected = -2*(1 + 3*q**2)/(2*pi*0.25_dp*(1 + q**2)**2)
#line 75 "/work/main/tests/indenter/indenter_stress.pf"
  call assertRelativelyEqual(expected, s_zz, tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_stress.pf', &
 & 75) )
  if (anyExceptions()) return
#line 76 "/work/main/tests/indenter/indenter_stress.pf"
            expected = 2/(4*pi*0.25_dp)*((1 + 3*q**2)/(1 + q**2)**2 - 2*(1 + nu)/(1 + q**2))
#line 77 "/work/main/tests/indenter/indenter_stress.pf"
  call assertRelativelyEqual(expected, s_rr, tolerance=1.0e-11_dp, &
 & location=SourceLocation( &
 & 'indenter_stress.pf', &
 & 77) )
  if (anyExceptions()) return
#line 78 "/work/main/tests/indenter/indenter_stress.pf"
         end associate
      end do
   end subroutine test_face

   ! Rings of the pressure of the profiles, by Boussinesq: s_zz = -3 z^3 int p r dr/(r^2 + z^2)^(5/2), and
   ! s_rr = int p r {(1 - 2 nu) [1/r^2 - z/(r^2 R)] - 3 r^2 z/R^5} dr/2 - (the same of the other direction)/2, R^2 = r^2 + z^2.
   !@test
   subroutine test_rings()
      character(*), parameter :: kinds(8) = [character(16) :: 'flat', 'cone', 'sphere', 'flat_cone', 'flat_paraboloid', &
         & 'rounded_punch', 'rounded_cone', 'power']
      character(*), parameter :: parameters(8) = [character(15) :: 'b=1', 'slope=0.3', 'R=1.6', 'b=0.9;slope=0.3', 'b=0.9;R=1', &
         & 'b=0.9;R=1', 'b=0.9;slope=0.3', 'n=2.5;C=0.4']
      integer, parameter :: n = 160001
      real(dp), parameter :: furthest = 1.6_dp, z = 0.4_dp
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:), profiles(:, :, :)
      real(dp) :: results(n_indenter_results), s_zz, s_rr, rings(2), r, step, distance, error_estimate
      integer :: kind, i, status

      allocate (profiles(n, 1, 3))
      step = furthest/(n - 1)
      do kind = 1, size(kinds)
         call new_named(model, values, trim(kinds(kind)), trim(parameters(kind)))
         if (kind == 1) call hold(values, v_load, -0.05_dp)
         if (kind > 1) call hold(values, v_contact_radius, 1.0_dp)
         values([v_work_of_adhesion, v_adhesion_stress]) = [2.0e-3_dp, 0.05_dp]
         values(v_theory) = choose_maugis_dugdale
         call get_stresses(model, values, z, s_zz, s_rr)
         values([v_profiles, v_n_r, v_r_max]) = [1.0_dp, real(n, dp), furthest]
         call solve_point(model, values, results, error_estimate, status)
         call model%solve_profiles(values, results, profiles(:, :, :2))
         rings = 0
         do i = 2, n
            if (ieee_is_nan(profiles(i, 1, 1))) cycle
            r = (i - 1)*step
            distance = hypot(r, z)
            associate (force => profiles(i, 1, 1)*r*step)
               rings(1) = rings(1) - 3*z**3*force/distance**5
               ! trace -2 (1 + nu) z/R^3 of a point force 1/(2 pi), less s_zz
               rings(2) = rings(2) - force*(1 + nu)*z/distance**3
            end associate
         end do
         rings(2) = rings(2) - rings(1)/2
#line 121 "/work/main/tests/indenter/indenter_stress.pf"
  call assertEqual(rings(1), s_zz, tolerance=1.0e-5_dp, message=kinds(kind), &
 & location=SourceLocation( &
 & 'indenter_stress.pf', &
 & 121) )
  if (anyExceptions()) return
#line 122 "/work/main/tests/indenter/indenter_stress.pf"
#line 122 "/work/main/tests/indenter/indenter_stress.pf"
  call assertEqual(rings(2), s_rr, tolerance=1.0e-5_dp, message=kinds(kind), &
 & location=SourceLocation( &
 & 'indenter_stress.pf', &
 & 122) )
  if (anyExceptions()) return
#line 123 "/work/main/tests/indenter/indenter_stress.pf"
      end do
   end subroutine test_rings

   ! Far below, the stresses are those of the load in a point; with JKR and with a range.
   !@test
   subroutine test_far()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: s_zz, s_rr, expected
      integer :: k

      do k = 1, 2
         call new_named(model, values, 'flat_cone', 'b=0.9;slope=0.3')
         call hold(values, v_load, 0.3_dp)
         values(v_work_of_adhesion) = 2.0e-3_dp
         if (k == 2) values(v_adhesion_stress) = 0.05_dp
         call get_stresses(model, values, 1.0e4_dp, s_zz, s_rr)
         expected = -3*0.3_dp/(2*pi*1.0e8_dp)
#line 141 "/work/main/tests/indenter/indenter_stress.pf"
  call assertRelativelyEqual(expected, s_zz, tolerance=1.0e-7_dp, &
 & location=SourceLocation( &
 & 'indenter_stress.pf', &
 & 141) )
  if (anyExceptions()) return
#line 142 "/work/main/tests/indenter/indenter_stress.pf"
         expected = 0.3_dp*(1 - 2*nu)/(4*pi*1.0e8_dp)
#line 143 "/work/main/tests/indenter/indenter_stress.pf"
  call assertRelativelyEqual(expected, s_rr, tolerance=1.0e-6_dp, &
 & location=SourceLocation( &
 & 'indenter_stress.pf', &
 & 143) )
  if (anyExceptions()) return
#line 144 "/work/main/tests/indenter/indenter_stress.pf"
      end do
   end subroutine test_far

   !@test
   subroutine test_refusals()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)

      call new_named(model, values, 'cone', 'slope=0.3')
      call hold(values, v_load, 1.0_dp)
      values(v_position_z) = 0.1_dp
#line 155 "/work/main/tests/indenter/indenter_stress.pf"
  call assertTrue(index(find_problems(model, values), '&solid poisson_ratio: is missing') > 0, &
 & location=SourceLocation( &
 & 'indenter_stress.pf', &
 & 155) )
  if (anyExceptions()) return
#line 156 "/work/main/tests/indenter/indenter_stress.pf"
      values(v_poisson_ratio) = nu
#line 157 "/work/main/tests/indenter/indenter_stress.pf"
  call assertEqual('', find_problems(model, values), &
 & location=SourceLocation( &
 & 'indenter_stress.pf', &
 & 157) )
  if (anyExceptions()) return
#line 158 "/work/main/tests/indenter/indenter_stress.pf"
   end subroutine test_refusals

end module indenter_stress

module Wrapindenter_stress
   use FUnit
   use indenter_stress
   implicit none
   private

contains


end module Wrapindenter_stress

function indenter_stress_suite() result(suite)
   use FUnit
   use indenter_stress
   use Wrapindenter_stress
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('indenter_stress_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_hertz', &
      test_hertz))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_face', &
      test_face))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_rings', &
      test_rings))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_far', &
      test_far))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_refusals', &
      test_refusals))
   call suite%addTest(t)


end function indenter_stress_suite

