! SPDX-License-Identifier: GPL-3.0-or-later
! Every model of the half-space in other units: all numbers change as their units do, and nothing else.
module classical_units
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_model_status, only: status_solved
   use adfric_model_table, only: result_t
   use scaled_cases, only: scale_values, factor_of
   use trial_case, only: trial_case_t, new_case
   use funit
   implicit none (type, external)

   !> Micrometres and gigapascals, and the other way to units larger than the metre.
   real(dp), parameter :: lengths(2) = [1.0e6_dp, 1.0e-3_dp], stresses(2) = [1.0e-9_dp, 1.0e4_dp]
   !> Round-off of closed forms and of a linear system of 32 unknowns.
   real(dp), parameter :: round_off = 1.0e-12_dp
   !> A place where a function is level is known to the root of round-off.
   real(dp), parameter :: level_place = 2*sqrt(epsilon(1.0_dp))

contains

   !> Solve a case as it is and in other units, and compare all results and profiles.
   subroutine check_units(case, name, tolerance)
      type(trial_case_t), intent(inout) :: case
      character(*), intent(in) :: name
      !> Of results, and of profiles relative to their largest value.
      real(dp), intent(in) :: tolerance
      type(trial_case_t) :: other
      real(dp), allocatable :: profiles(:, :, :), others(:, :, :)
      integer :: k

      call case%give('profiles', 1.0_dp)
#line 33 "/work/main/tests/classical/classical_units.pf"
  call assertEqual('', case%problems_of(), message=name, &
 & location=SourceLocation( &
 & 'classical_units.pf', &
 & 33) )
  if (anyExceptions()) return
#line 34 "/work/main/tests/classical/classical_units.pf"
      call case%solve()
#line 35 "/work/main/tests/classical/classical_units.pf"
  call assertEqual(status_solved, case%status(1), message=name, &
 & location=SourceLocation( &
 & 'classical_units.pf', &
 & 35) )
  if (anyExceptions()) return
#line 36 "/work/main/tests/classical/classical_units.pf"
      call case%get_profiles(profiles)
      do k = 1, size(lengths)
         other = case
         call scale_values(other, lengths(k), stresses(k))
#line 40 "/work/main/tests/classical/classical_units.pf"
  call assertEqual('', other%problems_of(), message=name, &
 & location=SourceLocation( &
 & 'classical_units.pf', &
 & 40) )
  if (anyExceptions()) return
#line 41 "/work/main/tests/classical/classical_units.pf"
         call other%solve()
#line 42 "/work/main/tests/classical/classical_units.pf"
  call assertEqual(status_solved, other%status(1), message=name, &
 & location=SourceLocation( &
 & 'classical_units.pf', &
 & 42) )
  if (anyExceptions()) return
#line 43 "/work/main/tests/classical/classical_units.pf"
         call other%get_profiles(others)
         call check_results(case, other, k, name, tolerance)
         call check_profiles(case, profiles, others, k, name, tolerance)
      end do
   end subroutine check_units

   subroutine check_results(case, other, k, name, tolerance)
      type(trial_case_t), intent(in) :: case, other
      integer, intent(in) :: k
      character(*), intent(in) :: name
      real(dp), intent(in) :: tolerance
      type(result_t), allocatable :: rows(:)
      character(:), allocatable :: label
      real(dp) :: expected, allowed
      integer :: i

      rows = case%model%describe_results(case%values)
      do i = 1, size(rows)
         label = name//' '//rows(i)%name
         expected = case%results(i, 1)
#line 63 "/work/main/tests/classical/classical_units.pf"
  call assertEqual(ieee_is_nan(expected), ieee_is_nan(other%results(i, 1)), message=label, &
 & location=SourceLocation( &
 & 'classical_units.pf', &
 & 63) )
  if (anyExceptions()) return
#line 64 "/work/main/tests/classical/classical_units.pf"
         if (ieee_is_nan(expected)) cycle
         expected = expected*factor_of(rows(i)%unit, lengths(k), stresses(k))
         allowed = tolerance*abs(expected)
         if (rows(i)%name == 'largest_shear_depth') allowed = level_place*abs(expected)
         if (rows(i)%name == 'contact_violation') allowed = tolerance
#line 69 "/work/main/tests/classical/classical_units.pf"
  call assertEqual(expected, other%results(i, 1), tolerance=allowed, message=label, &
 & location=SourceLocation( &
 & 'classical_units.pf', &
 & 69) )
  if (anyExceptions()) return
#line 70 "/work/main/tests/classical/classical_units.pf"
      end do
   end subroutine check_results

   subroutine check_profiles(case, profiles, others, k, name, tolerance)
      type(trial_case_t), intent(in) :: case
      real(dp), intent(in) :: profiles(:, :, :), others(:, :, :)
      integer, intent(in) :: k
      character(*), intent(in) :: name
      real(dp), intent(in) :: tolerance
      character(:), allocatable :: label
      real(dp) :: factor, largest
      integer :: i

      do i = 1, size(profiles, 3)
         label = name//' '//case%model%profiles(i)%name
         factor = factor_of(case%model%profiles(i)%unit, lengths(k), stresses(k))
         associate (is_empty => ieee_is_nan(profiles(:, :, i)))
#line 87 "/work/main/tests/classical/classical_units.pf"
  call assertTrue(all(is_empty .eqv. ieee_is_nan(others(:, :, i))), message=label, &
 & location=SourceLocation( &
 & 'classical_units.pf', &
 & 87) )
  if (anyExceptions()) return
#line 88 "/work/main/tests/classical/classical_units.pf"
            largest = maxval(abs(profiles(:, :, i)), mask=.not. is_empty)
            ! the gap of a flat punch
            if (.not. largest > 0) largest = 1
            largest = maxval(abs(others(:, :, i)/factor - profiles(:, :, i)), mask=.not. is_empty)/largest
#line 92 "/work/main/tests/classical/classical_units.pf"
  call assertLessThan(largest, tolerance, message=label, &
 & location=SourceLocation( &
 & 'classical_units.pf', &
 & 92) )
  if (anyExceptions()) return
#line 93 "/work/main/tests/classical/classical_units.pf"
         end associate
      end do
   end subroutine check_profiles

   !> Maps over x and a second axis, with a few samples off all places of symmetry.
   subroutine ask_maps(case, second, end)
      type(trial_case_t), intent(inout) :: case
      character(*), intent(in) :: second
      !> Largest coordinate [m].
      real(dp), intent(in) :: end

      call case%give('x_min', -0.93_dp*end)
      call case%give('x_max', 1.1_dp*end)
      call case%give('n_x', 9.0_dp)
      if (second == '') return
      call case%give(second//'_max', end)
      call case%give('n_'//second, 4.0_dp)
   end subroutine ask_maps

   !@test
   subroutine test_hertz()
      type(trial_case_t) :: case
      character(10), parameter :: kinds(3) = [character(10) :: 'line', 'circle', 'ellipse']
      integer :: kind

      do kind = 1, 3
         call new_case(case, 'hertz')
         call case%give('kind', real(kind, dp))
         call case%give('contact_modulus', 1.1e11_dp)
         call case%give('poisson_ratio', 0.27_dp)
         call case%give('load', 130.0_dp)
         if (kind < 3) call case%give('radius', 0.013_dp)
         if (kind == 3) call case%give('radius_1x', 0.05_dp)
         if (kind == 3) call case%give('radius_1y', 0.013_dp)
         call ask_maps(case, 'y', merge(1.0e-5_dp, 4.0e-4_dp, kind == 1))
         call check_units(case, 'hertz '//kinds(kind), round_off)
      end do
   end subroutine test_hertz

   !@test
   subroutine test_punch()
      type(trial_case_t) :: case
      character(10), parameter :: kinds(4) = [character(10) :: 'flat', 'wedge', 'cylinder', 'polynomial']
      integer :: kind

      do kind = 1, 4
         call new_case(case, 'rigid_punch')
         call case%give('kind', real(kind, dp))
         call case%give('half_width', 1.3e-3_dp)
         call case%give('slope', 3.0e-3_dp)
         call case%give('radius', 0.7_dp)
         call case%give('coefficient_2', 0.6_dp)
         call case%give('coefficient_4', 1.7e5_dp)
         call case%give('coefficient_8', 3.0e16_dp)
         call case%give('contact_modulus', 1.1e11_dp)
         call case%give('load', 1.7e5_dp)
         call ask_maps(case, 'y', 2.0e-3_dp)
         call check_units(case, 'rigid_punch '//kinds(kind), round_off)
         ! and the whole face
         call case%give('load', 9.0e5_dp)
         call check_units(case, 'rigid_punch, face of '//kinds(kind), round_off)
      end do
   end subroutine test_punch

   !@test
   subroutine test_wave()
      type(trial_case_t) :: case
      integer :: k

      do k = 1, 2
         call new_case(case, 'wave_1d')
         call case%give('period', 1.3e-3_dp)
         call case%give('amplitude', 1.7e-6_dp)
         call case%give('contact_modulus', 1.1e11_dp)
         if (k == 1) call case%give('mean_pressure', 0.13e9_dp)
         if (k == 2) call case%give('penetration', 1.1e-6_dp)
         call ask_maps(case, '', 0.6e-3_dp)
         call check_units(case, 'wave_1d', round_off)
      end do
   end subroutine test_wave

   ! The cells in contact are the same; pressures and gaps differ by what the residual of the solver, 1e-10, leaves.
   !@test
   subroutine test_wave_2d()
      type(trial_case_t) :: case
      real(dp), parameter :: residual = 1.0e-10_dp, conditioning = 10.0_dp
      integer :: k

      do k = 1, 2
         call new_case(case, 'wave_2d_elastic')
         call case%give('period', 1.3e-5_dp)
         call case%give('amplitude', 1.7e-7_dp)
         call case%give('contact_modulus', 1.1e9_dp)
         call case%give('cells', 64.0_dp)
         if (k == 1) call case%give('mean_pressure', 3.1e7_dp)
         if (k == 2) call case%give('penetration', 2.1e-7_dp)
         call check_units(case, 'wave_2d_elastic', conditioning*residual)
      end do
   end subroutine test_wave_2d

   !@test
   subroutine test_given_loads()
      type(trial_case_t) :: case
      character(10), parameter :: names(3) = [character(10) :: 'line_load', 'strip_load', 'point_load']
      integer :: k

      do k = 1, 3
         call new_case(case, trim(names(k)))
         call case%give('young_modulus', 2.1e11_dp)
         call case%give('poisson_ratio', 0.27_dp)
         if (k == 2) then
            call case%give('distribution', 2.0_dp)
            call case%give('half_width', 1.3e-4_dp)
            call case%give('normal_traction', 1.7e9_dp)
            call case%give('tangential_traction', 0.4e9_dp)
         else
            call case%give('normal_load', 1.7e3_dp)
            call case%give('tangential_load', 0.4e3_dp)
         end if
         call case%give('position_x', 0.9e-4_dp)
         call case%give('position_y', 1.1e-4_dp)
         if (k == 3) call case%give('position_z', 0.7e-4_dp)
         call ask_maps(case, merge('z', 'y', k == 3), 2.0e-4_dp)
         call check_units(case, trim(names(k)), round_off)
      end do
   end subroutine test_given_loads

end module classical_units

module Wrapclassical_units
   use FUnit
   use classical_units
   implicit none
   private

contains


end module Wrapclassical_units

function classical_units_suite() result(suite)
   use FUnit
   use classical_units
   use Wrapclassical_units
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_units_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_hertz', &
      test_hertz))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_punch', &
      test_punch))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_wave', &
      test_wave))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_wave_2d', &
      test_wave_2d))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_given_loads', &
      test_given_loads))
   call suite%addTest(t)


end function classical_units_suite

