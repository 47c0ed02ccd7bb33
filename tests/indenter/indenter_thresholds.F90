! SPDX-License-Identifier: GPL-3.0-or-later
! Where folds of blunt indenters appear and vanish, and which of them is the pull-off: the constants of the theory, with
! beta = sqrt(2 pi w b/E*)/(k b), or /(b^2/R), to 12 digits.
module indenter_thresholds
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, two_pi
   use adfric_indenter_case, only: indenter_case_t, resolve_case
   use adfric_indenter_curve, only: interval_t, most_intervals, control_load, control_approach
   use adfric_indenter_model, only: indenter_model_t
   use adfric_indenter_variables
   use adfric_model_status, only: status_solved, status_no_equilibrium
   use indenter_cases, only: new_indenter, hold
   use model_calls, only: solve_point
   use funit
   implicit none (type, external)

   real(dp), parameter :: twelve_digits = 1.0e-12_dp
   !> What is counted: folds under load, folds at given approach, is the edge or the inner fold the pull-off?
   integer, parameter :: load_folds = 1, approach_folds = 2, inner_pull_off = 3

contains

   !> Values of a kind with b = k = R = E* = 1.
   subroutine new_beta(model, values, kind, beta)
      type(indenter_model_t), intent(out) :: model
      real(dp), allocatable, intent(out) :: values(:)
      integer, intent(in) :: kind
      real(dp), intent(in) :: beta

      call new_indenter(model, values, kind)
      values(v_work_of_adhesion) = beta**2/two_pi
      call hold(values, v_load, 0.0_dp)
   end subroutine new_beta

   !> What is counted at a beta.
   integer function count_at(kind, what, beta)
      integer, intent(in) :: kind, what
      real(dp), intent(in) :: beta
      type(indenter_model_t) :: model
      type(indenter_case_t) :: case
      type(interval_t) :: intervals(most_intervals)
      real(dp), allocatable :: values(:)
      real(dp) :: results(n_indenter_results), error_estimate
      integer :: n, status
      logical :: is_converged

      call new_beta(model, values, kind, beta)
      if (what == inner_pull_off) then
         call solve_point(model, values, results, error_estimate, status)
         count_at = merge(1, 0, ieee_is_nan(results(r_jump_inward_load)))
      else
         call resolve_case(values, case)
         call case%curve%find_intervals(merge(control_load, control_approach, what == load_folds), intervals, n, is_converged)
         count_at = count(intervals(:n)%begins_at_fold)
      end if
   end function count_at

   !> The beta where the count changes.
   real(dp) function threshold(kind, what, low, high)
      integer, intent(in) :: kind, what
      real(dp), intent(in) :: low, high
      real(dp) :: left, right
      integer :: k, before

      left = low
      right = high
      before = count_at(kind, what, left)
      do k = 1, 55
         threshold = (left + right)/2
         if (count_at(kind, what, threshold) == before) then
            left = threshold
         else
            right = threshold
         end if
      end do
   end function threshold

   ! No fold or two, and none or two.
   !@test
   subroutine test_folds()
      real(dp) :: found

      found = threshold(kind_flat_cone, load_folds, 1.0_dp, 2.0_dp)
#line 85 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertRelativelyEqual(1.414591860564903_dp, found, tolerance=twelve_digits, &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 85) )
  if (anyExceptions()) return
#line 86 "/work/main/tests/indenter/indenter_thresholds.pf"
      found = threshold(kind_flat_cone, approach_folds, 4.0_dp, 5.0_dp)
#line 87 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertRelativelyEqual(4.243775581694709_dp, found, tolerance=twelve_digits, &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 87) )
  if (anyExceptions()) return
#line 88 "/work/main/tests/indenter/indenter_thresholds.pf"
      found = threshold(kind_flat_paraboloid, load_folds, 2.0_dp, 3.0_dp)
#line 89 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertRelativelyEqual(2.062999215488075_dp, found, tolerance=twelve_digits, &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 89) )
  if (anyExceptions()) return
#line 90 "/work/main/tests/indenter/indenter_thresholds.pf"
      found = threshold(kind_flat_paraboloid, approach_folds, 6.0_dp, 7.0_dp)
#line 91 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertRelativelyEqual(6.188997646464224_dp, found, tolerance=twelve_digits, &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 91) )
  if (anyExceptions()) return
#line 92 "/work/main/tests/indenter/indenter_thresholds.pf"
   end subroutine test_folds

   ! Of a rounded cone there are three folds between two values of beta.
   !@test
   subroutine test_rounded_cone()
      real(dp) :: found

      found = threshold(kind_rounded_cone, load_folds, 1.25_dp, 2.0_dp)
#line 100 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertRelativelyEqual(4/3.0_dp, found, tolerance=twelve_digits, &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 100) )
  if (anyExceptions()) return
#line 101 "/work/main/tests/indenter/indenter_thresholds.pf"
      found = threshold(kind_rounded_cone, approach_folds, 3.8_dp, 5.0_dp)
#line 102 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertRelativelyEqual(4.0_dp, found, tolerance=twelve_digits, &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 102) )
  if (anyExceptions()) return
#line 103 "/work/main/tests/indenter/indenter_thresholds.pf"
      found = threshold(kind_rounded_cone, load_folds, 1.25_dp, 1.0_dp)
#line 104 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertRelativelyEqual(1.197798_dp, found, tolerance=5.0e-7_dp, &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 104) )
  if (anyExceptions()) return
#line 105 "/work/main/tests/indenter/indenter_thresholds.pf"
      found = threshold(kind_rounded_cone, approach_folds, 3.8_dp, 3.0_dp)
#line 106 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertRelativelyEqual(3.593394_dp, found, tolerance=5.0e-7_dp, &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 106) )
  if (anyExceptions()) return
#line 107 "/work/main/tests/indenter/indenter_thresholds.pf"
#line 107 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertEqual(3, count_at(kind_rounded_cone, load_folds, 1.25_dp), &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 107) )
  if (anyExceptions()) return
#line 108 "/work/main/tests/indenter/indenter_thresholds.pf"
#line 108 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertEqual(1, count_at(kind_rounded_cone, load_folds, 1.1_dp), &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 108) )
  if (anyExceptions()) return
#line 109 "/work/main/tests/indenter/indenter_thresholds.pf"
#line 109 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertEqual(1, count_at(kind_rounded_cone, load_folds, 1.4_dp), &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 109) )
  if (anyExceptions()) return
#line 110 "/work/main/tests/indenter/indenter_thresholds.pf"
   end subroutine test_rounded_cone

   ! Where the outer fold becomes the pull-off.
   !@test
   subroutine test_pull_off()
      real(dp) :: found

      found = threshold(kind_flat_cone, inner_pull_off, 1.5_dp, 2.0_dp)
#line 118 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertRelativelyEqual(1.607611579876932_dp, found, tolerance=twelve_digits, &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 118) )
  if (anyExceptions()) return
#line 119 "/work/main/tests/indenter/indenter_thresholds.pf"
      found = threshold(kind_flat_paraboloid, inner_pull_off, 2.2_dp, 3.0_dp)
#line 120 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertRelativelyEqual(2.441879482773425_dp, found, tolerance=twelve_digits, &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 120) )
  if (anyExceptions()) return
#line 121 "/work/main/tests/indenter/indenter_thresholds.pf"
      found = threshold(kind_rounded_cone, inner_pull_off, 1.21_dp, 1.3_dp)
#line 122 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertRelativelyEqual(1.223555132882645_dp, found, tolerance=twelve_digits, &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 122) )
  if (anyExceptions()) return
#line 123 "/work/main/tests/indenter/indenter_thresholds.pf"
   end subroutine test_pull_off

   ! The pull-off is the least load of all stable states: at the edge of a blunt cone it is that of Kendall, of a rounded punch it
   ! is more. Between the jump and the pull-off there is a state, below it there is none.
   !@test
   subroutine test_least_load()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: results(n_indenter_results), other(n_indenter_results), error_estimate, kendall, beta
      integer, parameter :: kinds(*) = [kind_flat, kind_flat_cone, kind_flat_paraboloid, kind_rounded_punch, kind_rounded_cone, &
         & kind_cone, kind_paraboloid, kind_sphere, kind_power, kind_polynomial]
      integer :: kind, k, status
      character(30) :: label

      do kind = 1, size(kinds)
         do k = 1, 40
            beta = 0.02_dp*1.25_dp**k
            write (label, '(i4, es12.4)') kinds(kind), beta
            call new_beta(model, values, kinds(kind), beta)
            call solve_point(model, values, results, error_estimate, status)
            kendall = -sqrt(8*pi*values(v_work_of_adhesion))
            if (kind == 1 .or. (kind == 2 .and. beta < 1.6_dp) .or. (kind == 3 .and. beta < 2.44_dp)) then
#line 145 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertRelativelyEqual(kendall, results(r_pull_off_load), tolerance=twelve_digits, message=label, &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 145) )
  if (anyExceptions()) return
#line 146 "/work/main/tests/indenter/indenter_thresholds.pf"
            else if (kind <= 4) then
#line 147 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertLessThan(results(r_pull_off_load), kendall, message=label, &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 147) )
  if (anyExceptions()) return
#line 148 "/work/main/tests/indenter/indenter_thresholds.pf"
            end if
            call hold(values, v_load, results(r_pull_off_load)*(1 - 1.0e-9_dp))
            call solve_point(model, values, other, error_estimate, status)
#line 151 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertEqual(status_solved, status, message=label, &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 151) )
  if (anyExceptions()) return
#line 152 "/work/main/tests/indenter/indenter_thresholds.pf"
#line 152 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertEqual(1.0_dp, other(r_stable), message=label, &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 152) )
  if (anyExceptions()) return
#line 153 "/work/main/tests/indenter/indenter_thresholds.pf"
            call hold(values, v_load, results(r_pull_off_load)*(1 + 1.0e-9_dp))
            call solve_point(model, values, other, error_estimate, status)
#line 155 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertEqual(status_no_equilibrium, status, message=label, &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 155) )
  if (anyExceptions()) return
#line 156 "/work/main/tests/indenter/indenter_thresholds.pf"
            if (ieee_is_nan(results(r_jump_inward_load))) cycle
            call hold(values, v_load, results(r_jump_inward_load)*(1 - 1.0e-9_dp))
            call check_two_states(model, values, label)
         end do
      end do
   end subroutine test_least_load

   !> The largest stable state is larger than the smallest one, and one between them is unstable.
   subroutine check_two_states(model, values, label)
      type(indenter_model_t), intent(in) :: model
      real(dp), intent(inout) :: values(:)
      character(*), intent(in) :: label
      real(dp) :: radii(3), results(n_indenter_results), error_estimate
      integer :: branch, status

      do branch = 1, 3
         values(v_branch) = branch
         call solve_point(model, values, results, error_estimate, status)
#line 174 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertEqual(status_solved, status, message=label, &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 174) )
  if (anyExceptions()) return
#line 175 "/work/main/tests/indenter/indenter_thresholds.pf"
         radii(branch) = results(r_contact_radius)
#line 176 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertTrue(nint(results(r_stable)) == 1 .neqv. branch == 3, message=label, &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 176) )
  if (anyExceptions()) return
#line 177 "/work/main/tests/indenter/indenter_thresholds.pf"
      end do
#line 178 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertLessThan(radii(2), radii(3), message=label, &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 178) )
  if (anyExceptions()) return
#line 179 "/work/main/tests/indenter/indenter_thresholds.pf"
#line 179 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertLessThan(radii(3), radii(1), message=label, &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 179) )
  if (anyExceptions()) return
#line 180 "/work/main/tests/indenter/indenter_thresholds.pf"
   end subroutine check_two_states

   ! At the end of stability a hundred steps of round-off in the load are either nowhere or solved, and never lost.
   !@test
   subroutine test_at_the_end()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: results(n_indenter_results), error_estimate, least
      integer, parameter :: kinds(*) = [kind_flat_cone, kind_flat_paraboloid, kind_rounded_punch, kind_rounded_cone, kind_cone, &
         & kind_sphere, kind_power, kind_polynomial]
      integer :: kind, k, status, control

      do kind = 1, size(kinds)
         do control = 1, 2
            call new_beta(model, values, kinds(kind), 1.55_dp)
            if (control == 2) call hold(values, v_approach, 0.0_dp)
            call solve_point(model, values, results, error_estimate, status)
            least = results(merge(r_pull_off_load, r_pull_off_approach, control == 1))
            do k = -100, 100
               call hold(values, merge(v_load, v_approach, control == 1), least*(1 + k*epsilon(least)))
               call solve_point(model, values, results, error_estimate, status)
#line 201 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertTrue(status == status_solved .or. status == status_no_equilibrium, &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 201) )
  if (anyExceptions()) return
#line 202 "/work/main/tests/indenter/indenter_thresholds.pf"
               if (k < -4) then
#line 203 "/work/main/tests/indenter/indenter_thresholds.pf"
  call assertEqual(status_solved, status, &
 & location=SourceLocation( &
 & 'indenter_thresholds.pf', &
 & 203) )
  if (anyExceptions()) return
#line 204 "/work/main/tests/indenter/indenter_thresholds.pf"
               end if
            end do
         end do
      end do
   end subroutine test_at_the_end

end module indenter_thresholds

module Wrapindenter_thresholds
   use FUnit
   use indenter_thresholds
   implicit none
   private

contains


end module Wrapindenter_thresholds

function indenter_thresholds_suite() result(suite)
   use FUnit
   use indenter_thresholds
   use Wrapindenter_thresholds
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('indenter_thresholds_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_folds', &
      test_folds))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_rounded_cone', &
      test_rounded_cone))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_pull_off', &
      test_pull_off))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_least_load', &
      test_least_load))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_at_the_end', &
      test_at_the_end))
   call suite%addTest(t)


end function indenter_thresholds_suite

