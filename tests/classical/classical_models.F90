! SPDX-License-Identifier: GPL-3.0-or-later
! The models of the half-space as the program sees them.
module classical_models
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_model_status, only: status_solved, status_no_equilibrium
   use trial_case, only: trial_case_t, new_case
   use funit
   implicit none (type, external)

   real(dp), parameter :: closed_form = 100*epsilon(1.0_dp), solved = 1.0e-12_dp
   !> What is left of the conditions of contact is round-off.
   real(dp), parameter :: violation = 1.0e-12_dp

contains

   subroutine new_hertz(case, kind)
      type(trial_case_t), intent(out) :: case
      integer, intent(in) :: kind

      call new_case(case, 'hertz')
      call case%give('kind', real(kind, dp))
      call case%give('contact_modulus', 1.0e11_dp)
      call case%give('poisson_ratio', 0.3_dp)
      call case%give('load', 1000.0_dp)
   end subroutine new_hertz

   ! a and p0 of the table; the largest shear is 0.300 p0 at 0.786 a, the root of 1 - 2 z (1 + z^2)^(-1/2) + z^3 (1 + z^2)^(-3/2).
   !@test
   subroutine test_line()
      type(trial_case_t) :: case
      real(dp) :: z

      call new_hertz(case, 1)
      call case%give('radius', 0.01_dp)
#line 37 "/work/main/tests/classical/classical_models.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 37) )
  if (anyExceptions()) return
#line 38 "/work/main/tests/classical/classical_models.pf"
      call case%solve()
#line 39 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 39) )
  if (anyExceptions()) return
#line 40 "/work/main/tests/classical/classical_models.pf"
#line 40 "/work/main/tests/classical/classical_models.pf"
  call assertRelativelyEqual(1.128379167095513e-5_dp, case%found('contact_half_width'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 40) )
  if (anyExceptions()) return
#line 41 "/work/main/tests/classical/classical_models.pf"
#line 41 "/work/main/tests/classical/classical_models.pf"
  call assertRelativelyEqual(56418958.35477563_dp, case%found('peak_pressure'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 41) )
  if (anyExceptions()) return
#line 42 "/work/main/tests/classical/classical_models.pf"
#line 42 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(0.300_dp, case%found('largest_shear_stress')/case%found('peak_pressure'), tolerance=5.0e-4_dp, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 42) )
  if (anyExceptions()) return
#line 43 "/work/main/tests/classical/classical_models.pf"
      z = case%found('largest_shear_depth')/case%found('contact_half_width')
#line 44 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(0.786_dp, z, tolerance=5.0e-4_dp, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 44) )
  if (anyExceptions()) return
#line 45 "/work/main/tests/classical/classical_models.pf"
#line 45 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(0.0_dp, 1 - 2*z/sqrt(1 + z**2) + z**3/sqrt(1 + z**2)**3, tolerance=1.0e-7_dp, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 45) )
  if (anyExceptions()) return
#line 46 "/work/main/tests/classical/classical_models.pf"
#line 46 "/work/main/tests/classical/classical_models.pf"
  call assertTrue(ieee_is_nan(case%found('approach')), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 46) )
  if (anyExceptions()) return
#line 47 "/work/main/tests/classical/classical_models.pf"
#line 47 "/work/main/tests/classical/classical_models.pf"
  call assertLessThan(case%found('contact_violation'), violation, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 47) )
  if (anyExceptions()) return
#line 48 "/work/main/tests/classical/classical_models.pf"
   end subroutine test_line

   ! A circle: 0.31 p0 at 0.48 a for nu = 0.3 (Johnson 3.4); approach and load belong together.
   !@test
   subroutine test_circle()
      type(trial_case_t) :: case, other
      real(dp), parameter :: no_number = huge(1.0_dp)

      call new_hertz(case, 2)
      call case%give('load', 100.0_dp)
      call case%give('radius', 0.01_dp)
#line 59 "/work/main/tests/classical/classical_models.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 59) )
  if (anyExceptions()) return
#line 60 "/work/main/tests/classical/classical_models.pf"
      call case%solve()
#line 61 "/work/main/tests/classical/classical_models.pf"
  call assertRelativelyEqual(0.0001957433820584432_dp, case%found('contact_half_width'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 61) )
  if (anyExceptions()) return
#line 62 "/work/main/tests/classical/classical_models.pf"
#line 62 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(0.31_dp, case%found('largest_shear_stress')/case%found('peak_pressure'), tolerance=5.0e-3_dp, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 62) )
  if (anyExceptions()) return
#line 63 "/work/main/tests/classical/classical_models.pf"
#line 63 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(0.48_dp, case%found('largest_shear_depth')/case%found('contact_half_width'), tolerance=5.0e-3_dp, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 63) )
  if (anyExceptions()) return
#line 64 "/work/main/tests/classical/classical_models.pf"
#line 64 "/work/main/tests/classical/classical_models.pf"
  call assertLessThan(case%found('contact_violation'), violation, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 64) )
  if (anyExceptions()) return
#line 65 "/work/main/tests/classical/classical_models.pf"
      call new_hertz(other, 3)
      call other%give('radius_1x', 0.02_dp)
      call other%give('radius_1y', 0.02_dp)
      call other%give('radius_2x', 0.02_dp)
      call other%give('radius_2y', 0.02_dp)
      call other%give('load', no_number)
      call other%give('approach', case%found('approach'))
#line 72 "/work/main/tests/classical/classical_models.pf"
  call assertEqual('', other%problems_of(), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 72) )
  if (anyExceptions()) return
#line 73 "/work/main/tests/classical/classical_models.pf"
      call other%solve()
#line 74 "/work/main/tests/classical/classical_models.pf"
  call assertRelativelyEqual(100.0_dp, other%found('load'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 74) )
  if (anyExceptions()) return
#line 75 "/work/main/tests/classical/classical_models.pf"
      call other%give('approach', 0.0_dp)
      call other%solve()
#line 77 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(0.0_dp, other%found('contact_area'), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 77) )
  if (anyExceptions()) return
#line 78 "/work/main/tests/classical/classical_models.pf"
   end subroutine test_circle

   ! Steps of the axis ratio, of units, and a map of pressure that carries the load.
   !@test
   subroutine test_ellipse()
      type(trial_case_t) :: case
      real(dp), allocatable :: profiles(:, :, :)
      real(dp) :: a, b
      integer :: i

      do i = 0, 12
         call new_hertz(case, 3)
         call case%give('radius_1x', 1.0e-2_dp*10.0_dp**i)
         call case%give('radius_1y', 1.0e-2_dp)
#line 92 "/work/main/tests/classical/classical_models.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 92) )
  if (anyExceptions()) return
#line 93 "/work/main/tests/classical/classical_models.pf"
         call case%solve()
#line 94 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(status_solved, case%status(1), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 94) )
  if (anyExceptions()) return
#line 95 "/work/main/tests/classical/classical_models.pf"
#line 95 "/work/main/tests/classical/classical_models.pf"
  call assertLessThan(case%found('contact_violation'), violation, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 95) )
  if (anyExceptions()) return
#line 96 "/work/main/tests/classical/classical_models.pf"
#line 96 "/work/main/tests/classical/classical_models.pf"
  call assertLessThan(case%found('largest_shear_stress'), 0.33_dp*case%found('peak_pressure'), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 96) )
  if (anyExceptions()) return
#line 97 "/work/main/tests/classical/classical_models.pf"
#line 97 "/work/main/tests/classical/classical_models.pf"
  call assertGreaterThan(case%found('largest_shear_stress'), 0.295_dp*case%found('peak_pressure'), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 97) )
  if (anyExceptions()) return
#line 98 "/work/main/tests/classical/classical_models.pf"
      end do
      call case%give('radius_1x', 0.05_dp)
      call case%solve()
      a = case%found('contact_half_width')
      b = case%found('minor_half_width')
      call case%give('profiles', 1.0_dp)
      call case%give('x_min', -1.2_dp*a)
      call case%give('x_max', 1.2_dp*a)
      call case%give('y_min', -1.2_dp*b)
      call case%give('y_max', 1.2_dp*b)
      call case%give('n_y', 201.0_dp)
#line 109 "/work/main/tests/classical/classical_models.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 109) )
  if (anyExceptions()) return
#line 110 "/work/main/tests/classical/classical_models.pf"
      call case%get_profiles(profiles)
#line 111 "/work/main/tests/classical/classical_models.pf"
  call assertEqual([201, 201, 2], shape(profiles), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 111) )
  if (anyExceptions()) return
#line 112 "/work/main/tests/classical/classical_models.pf"
#line 112 "/work/main/tests/classical/classical_models.pf"
  call assertRelativelyEqual(1000.0_dp, sum(profiles(:, :, 1))*a*b*(2.4_dp/200)**2, tolerance=1.0e-3_dp, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 112) )
  if (anyExceptions()) return
#line 113 "/work/main/tests/classical/classical_models.pf"
#line 113 "/work/main/tests/classical/classical_models.pf"
  call assertTrue(all(profiles >= 0), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 113) )
  if (anyExceptions()) return
#line 114 "/work/main/tests/classical/classical_models.pf"
   end subroutine test_ellipse

   !@test
   subroutine test_hertz_rejections()
      type(trial_case_t) :: case

      call new_hertz(case, 1)
      call check_problem(case, 'contact radius', 'is missing [m]')
      call case%give('radius', 1.0_dp)
      call case%give('approach', 1.0_dp)
      call check_problem(case, 'operating approach', 'undefined for the line')
      call new_hertz(case, 2)
      call case%give('radius', 1.0_dp)
      call case%give('radius_2x', 1.0_dp)
      call check_problem(case, 'contact radius_2x', 'no meaning')
      call new_hertz(case, 3)
      call check_problem(case, 'contact radius_1x', 'no ellipse')
      call case%give('radius_1x', 0.0_dp)
      call check_problem(case, 'contact radius_1x', 'is 0')
      call case%give('radius_1x', 1.0_dp)
      call case%give('radius_1y', 1.0_dp)
      call case%give('approach', 1.0_dp)
      call check_problem(case, 'operating load', 'stands beside approach')
   end subroutine test_hertz_rejections

   subroutine check_problem(case, start, words, swept)
      type(trial_case_t), intent(in) :: case
      character(*), intent(in) :: start, words
      character(*), intent(in), optional :: swept
      character(:), allocatable :: text

      text = case%problems_of(swept)
#line 146 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(1, index(text, 'case: &'//start//': '), message=text, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 146) )
  if (anyExceptions()) return
#line 147 "/work/main/tests/classical/classical_models.pf"
#line 147 "/work/main/tests/classical/classical_models.pf"
  call assertGreaterThan(index(text, words), len(start), message=text, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 147) )
  if (anyExceptions()) return
#line 148 "/work/main/tests/classical/classical_models.pf"
#line 148 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(len(text), index(text, new_line('a')), message=text, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 148) )
  if (anyExceptions()) return
#line 149 "/work/main/tests/classical/classical_models.pf"
   end subroutine check_problem

   ! A sweep may lead where there is no contact of the kind.
   !@test
   subroutine test_beyond()
      type(trial_case_t) :: case
      real(dp), allocatable :: profiles(:, :, :)

      call new_hertz(case, 3)
      call case%give('radius_1x', 1.0_dp)
      call case%give('radius_1y', 1.0_dp)
      call case%give('radius_2x', -0.9_dp)
      call case%solve()
#line 162 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(status_no_equilibrium, case%status(1), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 162) )
  if (anyExceptions()) return
#line 163 "/work/main/tests/classical/classical_models.pf"
#line 163 "/work/main/tests/classical/classical_models.pf"
  call assertTrue(ieee_is_nan(case%found('contact_half_width')), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 163) )
  if (anyExceptions()) return
#line 164 "/work/main/tests/classical/classical_models.pf"
      call case%get_profiles(profiles)
#line 165 "/work/main/tests/classical/classical_models.pf"
  call assertTrue(all(ieee_is_nan(profiles)), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 165) )
  if (anyExceptions()) return
#line 166 "/work/main/tests/classical/classical_models.pf"
      call case%give('radius_2x', 0.0_dp)
      call case%solve()
#line 168 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(status_no_equilibrium, case%status(1), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 168) )
  if (anyExceptions()) return
#line 169 "/work/main/tests/classical/classical_models.pf"
      call new_punch(case, 4)
      call case%solve()
#line 171 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(status_no_equilibrium, case%status(1), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 171) )
  if (anyExceptions()) return
#line 172 "/work/main/tests/classical/classical_models.pf"
      call new_punch(case, 3)
      call case%give('radius', 1.0_dp)
      call case%give('load', huge(1.0_dp))
      call case%give('half_width', 1.0_dp)
      call case%give('contact_half_width', 2.0_dp)
      call case%solve()
#line 178 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(status_no_equilibrium, case%status(1), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 178) )
  if (anyExceptions()) return
#line 179 "/work/main/tests/classical/classical_models.pf"
      call case%get_profiles(profiles)
#line 180 "/work/main/tests/classical/classical_models.pf"
  call assertTrue(all(ieee_is_nan(profiles)), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 180) )
  if (anyExceptions()) return
#line 181 "/work/main/tests/classical/classical_models.pf"
   end subroutine test_beyond

   subroutine new_wave(case)
      type(trial_case_t), intent(out) :: case

      call new_case(case, 'wave_1d')
      call case%give('period', 1.0e-3_dp)
      call case%give('amplitude', 1.0e-6_dp)
      call case%give('contact_modulus', 1.0e11_dp)
   end subroutine new_wave

   ! Both controls give the same state.
   !@test
   subroutine test_wave()
      type(trial_case_t) :: case, other
      real(dp), allocatable :: profiles(:, :, :)
      real(dp), parameter :: full = pi*1.0e8_dp
      integer :: i

      do i = 0, 12
         call new_wave(case)
         call case%give('mean_pressure', 0.1_dp*i*full)
#line 203 "/work/main/tests/classical/classical_models.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 203) )
  if (anyExceptions()) return
#line 204 "/work/main/tests/classical/classical_models.pf"
         call case%solve()
         ! at full contact itself round-off decides
         if (i /= 10) then
#line 207 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(merge(0, merge(1, 2, i < 10), i == 0), nint(case%found('regime')), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 207) )
  if (anyExceptions()) return
#line 208 "/work/main/tests/classical/classical_models.pf"
         end if
#line 209 "/work/main/tests/classical/classical_models.pf"
  call assertLessThan(case%found('contact_violation'), violation, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 209) )
  if (anyExceptions()) return
#line 210 "/work/main/tests/classical/classical_models.pf"
         call new_wave(other)
         call other%give('penetration', case%found('penetration'))
         call other%solve()
#line 213 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(status_solved, other%status(1), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 213) )
  if (anyExceptions()) return
#line 214 "/work/main/tests/classical/classical_models.pf"
#line 214 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(min(1.0_dp, 0.1_dp*i)*full, other%found('mean_pressure'), tolerance=solved*full, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 214) )
  if (anyExceptions()) return
#line 215 "/work/main/tests/classical/classical_models.pf"
#line 215 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(1.0e-6_dp, other%found('mean_gap') + other%found('penetration'), tolerance=solved, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 215) )
  if (anyExceptions()) return
#line 216 "/work/main/tests/classical/classical_models.pf"
      end do
      call new_wave(other)
      call other%give('penetration', 1.1e-6_dp)
      call other%solve()
#line 220 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(status_no_equilibrium, other%status(1), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 220) )
  if (anyExceptions()) return
#line 221 "/work/main/tests/classical/classical_models.pf"
      call other%give('penetration', -1.0e-6_dp)
      call other%give('profiles', 1.0_dp)
      call other%give('x_max', 1.0e-3_dp)
      call other%give('n_x', 3.0_dp)
#line 225 "/work/main/tests/classical/classical_models.pf"
  call assertEqual('', other%problems_of(), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 225) )
  if (anyExceptions()) return
#line 226 "/work/main/tests/classical/classical_models.pf"
      call other%solve()
#line 227 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(3.0e-6_dp, other%found('largest_gap'), tolerance=closed_form*1.0e-6_dp, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 227) )
  if (anyExceptions()) return
#line 228 "/work/main/tests/classical/classical_models.pf"
      call other%get_profiles(profiles)
#line 229 "/work/main/tests/classical/classical_models.pf"
  call assertEqual([1.0e-6_dp, 3.0e-6_dp, 1.0e-6_dp], profiles(:, 1, 2), tolerance=1.0e-18_dp, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 229) )
  if (anyExceptions()) return
#line 230 "/work/main/tests/classical/classical_models.pf"
      call check_problem(other, 'output x_max', 'is swept', 'x_max')
      call other%give('x_max', -1.0_dp)
      call check_problem(other, 'output x_max', 'is not larger than x_min')
      call new_wave(other)
      call check_problem(other, 'operating mean_pressure', 'one of mean_pressure or penetration')
   end subroutine test_wave

   subroutine new_punch(case, kind)
      type(trial_case_t), intent(out) :: case
      integer, intent(in) :: kind

      call new_case(case, 'rigid_punch')
      call case%give('kind', real(kind, dp))
      call case%give('contact_modulus', 1.0e11_dp)
      call case%give('load', 1.0e5_dp)
   end subroutine new_punch

   !@test
   subroutine test_punches()
      type(trial_case_t) :: case
      real(dp), allocatable :: profiles(:, :, :)
      real(dp) :: a

      call new_punch(case, 1)
      call case%give('half_width', 1.0e-3_dp)
#line 255 "/work/main/tests/classical/classical_models.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 255) )
  if (anyExceptions()) return
#line 256 "/work/main/tests/classical/classical_models.pf"
      call case%solve()
#line 257 "/work/main/tests/classical/classical_models.pf"
  call assertRelativelyEqual(1.0e8_dp/pi, case%found('centre_pressure'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 257) )
  if (anyExceptions()) return
#line 258 "/work/main/tests/classical/classical_models.pf"
#line 258 "/work/main/tests/classical/classical_models.pf"
  call assertRelativelyEqual(1.0e5_dp/sqrt(pi*1.0e-3_dp), case%found('edge_intensity'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 258) )
  if (anyExceptions()) return
#line 259 "/work/main/tests/classical/classical_models.pf"
#line 259 "/work/main/tests/classical/classical_models.pf"
  call assertLessThan(case%found('contact_violation'), violation, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 259) )
  if (anyExceptions()) return
#line 260 "/work/main/tests/classical/classical_models.pf"

      call new_punch(case, 2)
      call case%give('slope', 1.0e-2_dp)
      call case%solve()
#line 264 "/work/main/tests/classical/classical_models.pf"
  call assertRelativelyEqual(1.0e-4_dp, case%found('contact_half_width'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 264) )
  if (anyExceptions()) return
#line 265 "/work/main/tests/classical/classical_models.pf"
#line 265 "/work/main/tests/classical/classical_models.pf"
  call assertTrue(ieee_is_nan(case%found('centre_pressure')), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 265) )
  if (anyExceptions()) return
#line 266 "/work/main/tests/classical/classical_models.pf"
#line 266 "/work/main/tests/classical/classical_models.pf"
  call assertLessThan(case%found('contact_violation'), violation, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 266) )
  if (anyExceptions()) return
#line 267 "/work/main/tests/classical/classical_models.pf"
      call case%give('half_width', 0.5e-4_dp)
      call case%solve()
#line 269 "/work/main/tests/classical/classical_models.pf"
  call assertRelativelyEqual(0.5e5_dp/sqrt(pi*0.5e-4_dp), case%found('edge_intensity'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 269) )
  if (anyExceptions()) return
#line 270 "/work/main/tests/classical/classical_models.pf"

      call new_punch(case, 3)
      call case%give('radius', 0.01_dp)
      call case%solve()
      a = case%found('contact_half_width')
#line 275 "/work/main/tests/classical/classical_models.pf"
  call assertRelativelyEqual(sqrt(4*1.0e5_dp*0.01_dp/(pi*1.0e11_dp)), a, tolerance=solved, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 275) )
  if (anyExceptions()) return
#line 276 "/work/main/tests/classical/classical_models.pf"
#line 276 "/work/main/tests/classical/classical_models.pf"
  call assertRelativelyEqual(2.0e5_dp/(pi*a), case%found('centre_pressure'), tolerance=solved, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 276) )
  if (anyExceptions()) return
#line 277 "/work/main/tests/classical/classical_models.pf"
#line 277 "/work/main/tests/classical/classical_models.pf"
  call assertLessThan(case%found('contact_violation'), violation, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 277) )
  if (anyExceptions()) return
#line 278 "/work/main/tests/classical/classical_models.pf"
      call case%give('profiles', 1.0_dp)
      call case%give('x_max', 3*a)
      call case%give('n_x', 7.0_dp)
      call case%get_profiles(profiles)
#line 282 "/work/main/tests/classical/classical_models.pf"
  call assertEqual([0.0_dp, 0.0_dp, 0.0_dp], profiles(:3, 1, 2), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 282) )
  if (anyExceptions()) return
#line 283 "/work/main/tests/classical/classical_models.pf"
#line 283 "/work/main/tests/classical/classical_models.pf"
  call assertTrue(all(profiles(4:, 1, 2) > 0), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 283) )
  if (anyExceptions()) return
#line 284 "/work/main/tests/classical/classical_models.pf"
#line 284 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(-a**2/0.02_dp, profiles(3, 1, 3), tolerance=solved*a, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 284) )
  if (anyExceptions()) return
#line 285 "/work/main/tests/classical/classical_models.pf"

      call new_punch(case, 4)
      call case%give('coefficient_4', 1.0e6_dp)
      call case%give('coefficient_2', 5.0_dp)
      call case%give('load', huge(1.0_dp))
      call case%give('contact_half_width', 1.0e-3_dp)
#line 291 "/work/main/tests/classical/classical_models.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 291) )
  if (anyExceptions()) return
#line 292 "/work/main/tests/classical/classical_models.pf"
      call case%solve()
#line 293 "/work/main/tests/classical/classical_models.pf"
  call assertRelativelyEqual(pi*1.0e11_dp*1.0e-6_dp*(2.5_dp + 0.75_dp), case%found('load'), tolerance=solved, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 293) )
  if (anyExceptions()) return
#line 294 "/work/main/tests/classical/classical_models.pf"
#line 294 "/work/main/tests/classical/classical_models.pf"
  call assertRelativelyEqual(1.0e-3_dp, case%found('contact_half_width'), tolerance=solved, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 294) )
  if (anyExceptions()) return
#line 295 "/work/main/tests/classical/classical_models.pf"
#line 295 "/work/main/tests/classical/classical_models.pf"
  call assertLessThan(case%found('contact_violation'), violation, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 295) )
  if (anyExceptions()) return
#line 296 "/work/main/tests/classical/classical_models.pf"
   end subroutine test_punches

   !@test
   subroutine test_punch_rejections()
      type(trial_case_t) :: case

      call new_punch(case, 1)
      call check_problem(case, 'punch half_width', 'is missing [m]')
      call new_punch(case, 2)
      call check_problem(case, 'punch slope', 'is missing [-]')
      call new_punch(case, 3)
      call check_problem(case, 'punch radius', 'is missing [m]')
      call new_punch(case, 4)
      call check_problem(case, 'punch coefficient_2', 'is 0 like all')
      call case%give('coefficient_2', 1.0_dp)
      call case%give('contact_half_width', 1.0_dp)
      call check_problem(case, 'operating load', 'stands beside contact_half_width')
      call case%give('load', huge(1.0_dp))
      call case%give('half_width', 0.5_dp)
      call check_problem(case, 'operating contact_half_width', 'is larger than')
      call case%give('contact_half_width', 0.5_dp)
#line 317 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(2, case%model%variables(case%model%index_of('numerics', 'points'))%multiple_of, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 317) )
  if (anyExceptions()) return
#line 318 "/work/main/tests/classical/classical_models.pf"
   end subroutine test_punch_rejections

   ! Given loads: at a place and on a map.
   !@test
   subroutine test_fields()
      type(trial_case_t) :: case
      real(dp), allocatable :: profiles(:, :, :)
      character(10), parameter :: names(3) = [character(10) :: 'line_load', 'strip_load', 'point_load']
      integer :: k

      do k = 1, 3
         call new_case(case, trim(names(k)))
         call check_missing(case)
         call case%give('young_modulus', 2.0_dp)
         call case%give('poisson_ratio', 0.3_dp)
         if (k == 2) then
            call case%give('distribution', 1.0_dp)
            call case%give('half_width', 1.0_dp)
            call case%give('normal_traction', 1.0_dp)
         else
            call case%give('normal_load', 1.0_dp)
            call case%give('tangential_load', 1.0_dp)
         end if
#line 341 "/work/main/tests/classical/classical_models.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 341) )
  if (anyExceptions()) return
#line 342 "/work/main/tests/classical/classical_models.pf"
         call case%give('position_x', 0.5_dp)
         call case%give(merge('position_z', 'position_y', k == 3), 0.5_dp)
         call case%give('profiles', 1.0_dp)
         call case%give('x_min', -0.5_dp)
         call case%give('x_max', 0.5_dp)
         call case%give('n_x', 3.0_dp)
         call case%give(merge('z_max', 'y_max', k == 3), 0.5_dp)
         call case%give(merge('n_z', 'n_y', k == 3), 2.0_dp)
#line 350 "/work/main/tests/classical/classical_models.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 350) )
  if (anyExceptions()) return
#line 351 "/work/main/tests/classical/classical_models.pf"
         call case%solve()
         call case%get_profiles(profiles)
#line 353 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(case%results(:, 1), profiles(3, 2, :), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 353) )
  if (anyExceptions()) return
#line 354 "/work/main/tests/classical/classical_models.pf"
         ! under a concentrated load there is no value
#line 355 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(k /= 2, ieee_is_nan(profiles(2, 1, 1)), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 355) )
  if (anyExceptions()) return
#line 356 "/work/main/tests/classical/classical_models.pf"
      end do
   end subroutine test_fields

   subroutine check_missing(case)
      type(trial_case_t), intent(in) :: case

#line 362 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(1, index(case%problems_of(), 'case: &solid young_modulus: is missing [Pa]'), &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 362) )
  if (anyExceptions()) return
#line 363 "/work/main/tests/classical/classical_models.pf"
   end subroutine check_missing

   ! Slopes of the surface (Johnson 2.5): those of Flamant's displacements, summed over the strip.
   !@test
   subroutine test_strip_slopes()
      type(trial_case_t) :: case
      real(dp), parameter :: nu = 0.2_dp
      real(dp) :: strain

      call new_case(case, 'strip_load')
      call case%give('young_modulus', 1.0_dp)
      call case%give('poisson_ratio', nu)
      call case%give('half_width', 1.0_dp)
      call case%give('distribution', 2.0_dp)
      call case%give('normal_traction', 3.0_dp)
      call case%give('tangential_traction', 2.0_dp)
      call case%solve()
      ! in the middle there are the tractions only
#line 381 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(-3*(1 + nu)*(1 - 2*nu), case%found('surface_strain'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 381) )
  if (anyExceptions()) return
#line 382 "/work/main/tests/classical/classical_models.pf"
#line 382 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(2*(1 + nu)*(1 - 2*nu), case%found('surface_slope'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 382) )
  if (anyExceptions()) return
#line 383 "/work/main/tests/classical/classical_models.pf"
      ! Hooke's law with the stresses of the surface
      call case%give('position_x', 0.3_dp)
      call case%solve()
      strain = (1 + nu)*((1 - nu)*case%found('stress_xx') - nu*case%found('stress_yy'))
#line 387 "/work/main/tests/classical/classical_models.pf"
  call assertEqual(strain, case%found('surface_strain'), tolerance=closed_form, &
 & location=SourceLocation( &
 & 'classical_models.pf', &
 & 387) )
  if (anyExceptions()) return
#line 388 "/work/main/tests/classical/classical_models.pf"
   end subroutine test_strip_slopes

end module classical_models

module Wrapclassical_models
   use FUnit
   use classical_models
   implicit none
   private

contains


end module Wrapclassical_models

function classical_models_suite() result(suite)
   use FUnit
   use classical_models
   use Wrapclassical_models
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('classical_models_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_line', &
      test_line))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_circle', &
      test_circle))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_ellipse', &
      test_ellipse))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_hertz_rejections', &
      test_hertz_rejections))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_beyond', &
      test_beyond))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_wave', &
      test_wave))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_punches', &
      test_punches))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_punch_rejections', &
      test_punch_rejections))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_fields', &
      test_fields))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_strip_slopes', &
      test_strip_slopes))
   call suite%addTest(t)


end function classical_models_suite

