! SPDX-License-Identifier: GPL-3.0-or-later
! The model `indenter` without adhesion and with JKR against tables of 40 digits.
module indenter_tables
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, two_pi
   use adfric_indenter_case, only: indenter_case_t, resolve_case
   use adfric_indenter_curve, only: interval_t, state_t, most_intervals, control_load, control_approach
   use adfric_indenter_model, only: indenter_model_t
   use adfric_indenter_power_shape, only: depth_factor
   use adfric_indenter_variables
   use adfric_model_status, only: status_solved
   use indenter_cases, only: new_indenter, new_named, hold, kind_of
   use model_calls, only: solve_point
   use reference_table, only: table_t, read_table, table_digits
   use funit
   implicit none (type, external)

contains

   !> Solve a point and say whether it is solved.
   subroutine solve(model, values, results, label)
      type(indenter_model_t), intent(in) :: model
      real(dp), intent(in) :: values(:)
      real(dp), allocatable, intent(out) :: results(:)
      character(*), intent(in) :: label
      real(dp) :: error_estimate
      integer :: status

      allocate (results(n_indenter_results))
      call solve_point(model, values, results, error_estimate, status)
#line 31 "/work/main/tests/indenter/indenter_tables.pf"
  call assertEqual(status_solved, status, message=label, &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 31) )
  if (anyExceptions()) return
#line 32 "/work/main/tests/indenter/indenter_tables.pf"
#line 32 "/work/main/tests/indenter/indenter_tables.pf"
  call assertLessThan(error_estimate, 1.0e-6_dp, message=label, &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 32) )
  if (anyExceptions()) return
#line 33 "/work/main/tests/indenter/indenter_tables.pf"
   end subroutine solve

   ! Ten kinds without adhesion: load and approach of a radius, and back; stiffness.
   !@test
   subroutine test_shapes()
      type(table_t) :: table
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:), results(:)
      real(dp) :: expected(3)
      integer, parameter :: held(*) = [v_load, v_approach, v_contact_radius], found(*) = [r_load, r_approach, r_contact_radius]
      integer :: row, k, i

      call read_table(table, 'ind_shapes')
#line 46 "/work/main/tests/indenter/indenter_tables.pf"
  call assertEqual(19, table%n_rows, &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 46) )
  if (anyExceptions()) return
#line 47 "/work/main/tests/indenter/indenter_tables.pf"
      do row = 1, table%n_rows
         call new_named(model, values, table%text(row, 'kind'), table%text(row, 'parameters'))
         expected = [table%number(row, 'P'), table%number(row, 'delta'), table%number(row, 'a')]
         do k = 1, 3
            if (k == 3 .and. table%text(row, 'kind') == 'flat') cycle
            call hold(values, held(k), expected(k))
            call solve(model, values, results, table%label(row))
            do i = 1, 3
#line 55 "/work/main/tests/indenter/indenter_tables.pf"
  call assertRelativelyEqual(expected(i), results(found(i)), tolerance=table_digits, message=table%label(row), &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 55) )
  if (anyExceptions()) return
#line 56 "/work/main/tests/indenter/indenter_tables.pf"
            end do
            associate (stiffness => table%number(row, 'dP_ddelta'))
#line 58 "/work/main/tests/indenter/indenter_tables.pf"
  call assertRelativelyEqual(stiffness, results(r_contact_stiffness), tolerance=table_digits, message=table%label(row), &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 58) )
  if (anyExceptions()) return
#line 59 "/work/main/tests/indenter/indenter_tables.pf"
            end associate
         end do
      end do
   end subroutine test_shapes

   ! Pressure at three places, and the gap at one and a half radii.
   !@test
   subroutine test_profiles()
      type(table_t) :: table
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:), results(:)
      real(dp) :: profiles(16, 1, 2)
      integer :: row, k
      character(*), parameter :: columns(*) = ['p_0.1', 'p_0.5', 'p_0.9']
      integer, parameter :: places(*) = [2, 6, 10]

      call read_table(table, 'ind_shapes')
      do row = 1, table%n_rows
         call new_named(model, values, table%text(row, 'kind'), table%text(row, 'parameters'))
         call hold(values, v_approach, table%number(row, 'delta'))
         values([v_profiles, v_n_r]) = [1, 16]
         values(v_r_max) = 1.5_dp*table%number(row, 'a')
         call solve(model, values, results, table%label(row))
         call model%solve_profiles(values, results, profiles)
         do k = 1, 3
            associate (p => table%number(row, columns(k)))
#line 85 "/work/main/tests/indenter/indenter_tables.pf"
  call assertRelativelyEqual(p, profiles(places(k), 1, p_pressure), tolerance=table_digits, message=table%label(row), &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 85) )
  if (anyExceptions()) return
#line 86 "/work/main/tests/indenter/indenter_tables.pf"
            end associate
         end do
         if (table%text(row, 'kind') == 'flat') cycle
         associate (gap => table%number(row, 'gap_at_1.5a'))
#line 90 "/work/main/tests/indenter/indenter_tables.pf"
  call assertRelativelyEqual(gap, profiles(16, 1, p_gap), tolerance=table_digits, message=table%label(row), &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 90) )
  if (anyExceptions()) return
#line 91 "/work/main/tests/indenter/indenter_tables.pf"
         end associate
      end do
   end subroutine test_profiles

   ! The exact sphere down to a = 1e-9 R, without adhesion and with it.
   !@test
   subroutine test_sphere()
      type(table_t) :: table
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:), results(:)
      real(dp) :: a, scale
      integer :: row

      call read_table(table, 'ind_sphere_exact')
#line 105 "/work/main/tests/indenter/indenter_tables.pf"
  call assertEqual(7, table%n_rows, &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 105) )
  if (anyExceptions()) return
#line 106 "/work/main/tests/indenter/indenter_tables.pf"
      call new_indenter(model, values, kind_sphere)
      do row = 1, table%n_rows
         a = table%number(row, 'a')
         values(v_work_of_adhesion) = 0
         call hold(values, v_contact_radius, a)
         call solve(model, values, results, table%label(row))
#line 112 "/work/main/tests/indenter/indenter_tables.pf"
  call assertRelativelyEqual(table%number(row, 'P'), results(r_load), tolerance=table_digits, message=table%label(row), &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 112) )
  if (anyExceptions()) return
#line 113 "/work/main/tests/indenter/indenter_tables.pf"
#line 113 "/work/main/tests/indenter/indenter_tables.pf"
  call assertRelativelyEqual(table%number(row, 'delta'), results(r_approach), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 113) )
  if (anyExceptions()) return
#line 114 "/work/main/tests/indenter/indenter_tables.pf"
         values(v_work_of_adhesion) = 1.0e-3_dp
         call solve(model, values, results, table%label(row))
         scale = table%number(row, 'P') + sqrt(8*pi*1.0e-3_dp*a**3)
#line 117 "/work/main/tests/indenter/indenter_tables.pf"
  call assertEqual(table%number(row, 'P_jkr'), results(r_load), tolerance=table_digits*scale, message=table%label(row), &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 117) )
  if (anyExceptions()) return
#line 118 "/work/main/tests/indenter/indenter_tables.pf"
         scale = table%number(row, 'delta') + sqrt(two_pi*1.0e-3_dp*a)
#line 119 "/work/main/tests/indenter/indenter_tables.pf"
  call assertEqual(table%number(row, 'delta_jkr'), results(r_approach), tolerance=table_digits*scale, &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 119) )
  if (anyExceptions()) return
#line 120 "/work/main/tests/indenter/indenter_tables.pf"
      end do
   end subroutine test_sphere

   ! Its pull-off in both controls.
   !@test
   subroutine test_sphere_pull_off()
      type(table_t) :: table
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:), results(:)
      integer :: row

      call read_table(table, 'ind_sphere_exact_pulloff')
#line 132 "/work/main/tests/indenter/indenter_tables.pf"
  call assertEqual(3, table%n_rows, &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 132) )
  if (anyExceptions()) return
#line 133 "/work/main/tests/indenter/indenter_tables.pf"
      call new_indenter(model, values, kind_sphere)
      do row = 1, table%n_rows
         values(v_work_of_adhesion) = table%number(row, 'w')
         call hold(values, v_load, 0.0_dp)
         call solve(model, values, results, table%label(row))
#line 138 "/work/main/tests/indenter/indenter_tables.pf"
  call assertRelativelyEqual(table%number(row, 'P_load'), results(r_pull_off_load), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 138) )
  if (anyExceptions()) return
#line 139 "/work/main/tests/indenter/indenter_tables.pf"
#line 139 "/work/main/tests/indenter/indenter_tables.pf"
  call assertRelativelyEqual(table%number(row, 'delta_load'), results(r_pull_off_approach), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 139) )
  if (anyExceptions()) return
#line 140 "/work/main/tests/indenter/indenter_tables.pf"
         call hold(values, v_approach, 0.0_dp)
         call solve(model, values, results, table%label(row))
#line 142 "/work/main/tests/indenter/indenter_tables.pf"
  call assertRelativelyEqual(table%number(row, 'P_disp'), results(r_pull_off_load), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 142) )
  if (anyExceptions()) return
#line 143 "/work/main/tests/indenter/indenter_tables.pf"
#line 143 "/work/main/tests/indenter/indenter_tables.pf"
  call assertRelativelyEqual(table%number(row, 'delta_disp'), results(r_pull_off_approach), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 143) )
  if (anyExceptions()) return
#line 144 "/work/main/tests/indenter/indenter_tables.pf"
      end do
   end subroutine test_sphere_pull_off

   ! r^n with C = E* = w = 1: pull-off in both controls, and the state without load.
   !@test
   subroutine test_power_pull_off()
      type(table_t) :: table
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:), results(:)
      integer :: row
      real(dp) :: a0

      call read_table(table, 'ind_jkr_power_pulloff')
#line 157 "/work/main/tests/indenter/indenter_tables.pf"
  call assertEqual(4, table%n_rows, &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 157) )
  if (anyExceptions()) return
#line 158 "/work/main/tests/indenter/indenter_tables.pf"
      call new_indenter(model, values, kind_power)
      values(v_work_of_adhesion) = 1
      do row = 1, table%n_rows
         values(v_exponent) = table%number(row, 'n')
         a0 = length_of(values(v_exponent))
         call hold(values, v_load, 0.0_dp)
         call solve(model, values, results, table%label(row))
#line 165 "/work/main/tests/indenter/indenter_tables.pf"
  call assertRelativelyEqual(table%number(row, 'Pphys_load'), results(r_pull_off_load), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 165) )
  if (anyExceptions()) return
#line 166 "/work/main/tests/indenter/indenter_tables.pf"
#line 166 "/work/main/tests/indenter/indenter_tables.pf"
  call assertRelativelyEqual(table%number(row, 'a_P0'), results(r_contact_radius)/a0, tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 166) )
  if (anyExceptions()) return
#line 167 "/work/main/tests/indenter/indenter_tables.pf"
         call hold(values, v_approach, 0.0_dp)
         call solve(model, values, results, table%label(row))
#line 169 "/work/main/tests/indenter/indenter_tables.pf"
  call assertRelativelyEqual(table%number(row, 'Pphys_disp'), results(r_pull_off_load), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 169) )
  if (anyExceptions()) return
#line 170 "/work/main/tests/indenter/indenter_tables.pf"
         call hold(values, v_contact_radius, table%number(row, 'aphys_disp'))
         call solve(model, values, results, table%label(row))
#line 172 "/work/main/tests/indenter/indenter_tables.pf"
  call assertRelativelyEqual(table%number(row, 'Pphys_disp'), results(r_load), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 172) )
  if (anyExceptions()) return
#line 173 "/work/main/tests/indenter/indenter_tables.pf"
         call hold(values, v_contact_radius, table%number(row, 'aphys_load'))
         call solve(model, values, results, table%label(row))
#line 175 "/work/main/tests/indenter/indenter_tables.pf"
  call assertRelativelyEqual(table%number(row, 'Pphys_load'), results(r_load), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 175) )
  if (anyExceptions()) return
#line 176 "/work/main/tests/indenter/indenter_tables.pf"
      end do
   end subroutine test_power_pull_off

   !> a0 of the reduced units of r^n, C = E* = w = 1: 2 pi a0 = (8/3) K^2 a0^(2n).
   real(dp) function length_of(n)
      real(dp), intent(in) :: n

      length_of = (0.75_dp*pi/depth_factor(n)**2)**(1/(2*n - 1))
   end function length_of

   ! States of r^n at given radius, and the stable radius of their load.
   !@test
   subroutine test_power_curve()
      type(table_t) :: table
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:), results(:)
      real(dp) :: n, a, a0, height, force, size
      integer :: row

      call read_table(table, 'ind_jkr_power_curve')
#line 196 "/work/main/tests/indenter/indenter_tables.pf"
  call assertEqual(18, table%n_rows, &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 196) )
  if (anyExceptions()) return
#line 197 "/work/main/tests/indenter/indenter_tables.pf"
      call new_indenter(model, values, kind_power)
      values(v_work_of_adhesion) = 1
      do row = 1, table%n_rows
         n = table%number(row, 'n')
         a = table%number(row, 'a')
         values(v_exponent) = n
         a0 = length_of(n)
         height = depth_factor(n)*a0**n
         force = 2*n/(n + 1)*a0*height
         size = a**(n + 1) + 2*(n + 1)/n*a**1.5_dp
         call hold(values, v_contact_radius, a*a0)
         call solve(model, values, results, table%label(row))
#line 209 "/work/main/tests/indenter/indenter_tables.pf"
  call assertEqual(table%number(row, 'P'), results(r_load)/force, tolerance=size*table_digits, message=table%label(row), &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 209) )
  if (anyExceptions()) return
#line 210 "/work/main/tests/indenter/indenter_tables.pf"
#line 210 "/work/main/tests/indenter/indenter_tables.pf"
  call assertEqual(table%number(row, 'delta'), results(r_approach)/height, tolerance=(a**n + 2*sqrt(a))*table_digits, &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 210) )
  if (anyExceptions()) return
#line 211 "/work/main/tests/indenter/indenter_tables.pf"
         if (nint(results(r_stable)) == 0) cycle
         call hold(values, v_load, table%number(row, 'P')*force)
         call solve(model, values, results, table%label(row))
#line 214 "/work/main/tests/indenter/indenter_tables.pf"
  call assertRelativelyEqual(a, results(r_contact_radius)/a0, tolerance=table_digits, message=table%label(row), &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 214) )
  if (anyExceptions()) return
#line 215 "/work/main/tests/indenter/indenter_tables.pf"
      end do
   end subroutine test_power_curve

   ! Every fold of the shapes with a corner, in both controls, and no other.
   !@test
   subroutine test_blunt_folds()
      type(table_t) :: table
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: folds(3, most_intervals), size
      logical :: are_stable(most_intervals)
      integer :: row, n, place, control

      call read_table(table, 'ind_jkr_blunt')
#line 229 "/work/main/tests/indenter/indenter_tables.pf"
  call assertEqual(67, table%n_rows, &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 229) )
  if (anyExceptions()) return
#line 230 "/work/main/tests/indenter/indenter_tables.pf"
      do row = 1, table%n_rows
         call new_indenter(model, values, kind_of(table%text(row, 'kind')))
         values(v_work_of_adhesion) = table%number(row, 'beta')**2/two_pi
         control = merge(control_load, control_approach, table%text(row, 'control') == 'load')
         call hold(values, merge(v_load, v_approach, control == control_load), 0.0_dp)
         call get_folds(values, control, folds, are_stable, n)
         place = nint(table%number(row, 'index'))
         if (place == 0) then
#line 238 "/work/main/tests/indenter/indenter_tables.pf"
  call assertEqual(0, n, message=table%label(row), &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 238) )
  if (anyExceptions()) return
#line 239 "/work/main/tests/indenter/indenter_tables.pf"
            cycle
         end if
#line 241 "/work/main/tests/indenter/indenter_tables.pf"
  call assertLessThanOrEqual(place, n, message=table%label(row), &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 241) )
  if (anyExceptions()) return
#line 242 "/work/main/tests/indenter/indenter_tables.pf"
#line 242 "/work/main/tests/indenter/indenter_tables.pf"
  call assertRelativelyEqual(table%number(row, 'a'), folds(1, place), tolerance=table_digits, message=table%label(row), &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 242) )
  if (anyExceptions()) return
#line 243 "/work/main/tests/indenter/indenter_tables.pf"
#line 243 "/work/main/tests/indenter/indenter_tables.pf"
  call assertRelativelyEqual(table%number(row, 'P'), folds(2, place), tolerance=table_digits, message=table%label(row), &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 243) )
  if (anyExceptions()) return
#line 244 "/work/main/tests/indenter/indenter_tables.pf"
         size = abs(table%number(row, 'delta')) + table%number(row, 'beta')*sqrt(folds(1, place))
#line 245 "/work/main/tests/indenter/indenter_tables.pf"
  call assertEqual(table%number(row, 'delta'), folds(3, place), tolerance=size*table_digits, message=table%label(row), &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 245) )
  if (anyExceptions()) return
#line 246 "/work/main/tests/indenter/indenter_tables.pf"
#line 246 "/work/main/tests/indenter/indenter_tables.pf"
  call assertTrue(are_stable(place) .eqv. table%text(row, 'stable_beyond') == 'yes', message=table%label(row), &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 246) )
  if (anyExceptions()) return
#line 247 "/work/main/tests/indenter/indenter_tables.pf"
      end do
   end subroutine test_blunt_folds

   !> Radius, load and approach of every fold, and whether larger contacts are stable.
   subroutine get_folds(values, control, folds, are_stable, n)
      real(dp), intent(in) :: values(:)
      integer, intent(in) :: control
      real(dp), intent(out) :: folds(:, :)
      logical, intent(out) :: are_stable(:)
      integer, intent(out) :: n
      type(indenter_case_t) :: case
      type(interval_t) :: intervals(most_intervals)
      type(state_t) :: state
      integer :: k, n_intervals
      logical :: is_converged

      call resolve_case(values, case)
      call case%curve%find_intervals(control, intervals, n_intervals, is_converged)
#line 265 "/work/main/tests/indenter/indenter_tables.pf"
  call assertTrue(is_converged, &
 & location=SourceLocation( &
 & 'indenter_tables.pf', &
 & 265) )
  if (anyExceptions()) return
#line 266 "/work/main/tests/indenter/indenter_tables.pf"
      n = 0
      do k = 1, n_intervals
         if (.not. intervals(k)%begins_at_fold) cycle
         n = n + 1
         call case%curve%get_state(intervals(k)%low, intervals(k)%is_beyond, state)
         folds(:, n) = [state%spot%radius*case%length_unit, state%load*case%force_unit(), state%approach*case%height_unit]
         are_stable(n) = intervals(k)%is_stable
      end do
   end subroutine get_folds

end module indenter_tables

module Wrapindenter_tables
   use FUnit
   use indenter_tables
   implicit none
   private

contains


end module Wrapindenter_tables

function indenter_tables_suite() result(suite)
   use FUnit
   use indenter_tables
   use Wrapindenter_tables
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('indenter_tables_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_shapes', &
      test_shapes))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_profiles', &
      test_profiles))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_sphere', &
      test_sphere))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_sphere_pull_off', &
      test_sphere_pull_off))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_power_pull_off', &
      test_power_pull_off))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_power_curve', &
      test_power_curve))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_blunt_folds', &
      test_blunt_folds))
   call suite%addTest(t)


end function indenter_tables_suite

