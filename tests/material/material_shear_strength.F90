! SPDX-License-Identifier: GPL-3.0-or-later
! Friction of a shear strength: what it is of area and load, on the exact wave and on cells, with and without adhesion, where
! contact pulls as a whole and where there is none, in profiles and maps, in other units, and what is refused.
module material_shear_strength
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: unset
   use adfric_input_namelist_file, only: namelist_file_t, new_namelist_file
   use adfric_input_run, only: run_input_t, read_case
   use trial_case, only: trial_case_t, new_case
   use funit
   implicit none (type, external)

   real(dp), parameter :: pi = acos(-1.0_dp), period = 1.0e-5_dp, amplitude = 1.0e-7_dp, modulus = 1.0e7_dp
   real(dp), parameter :: full(2) = [1, 2]*pi*modulus*amplitude/period, strength = 2.0e5_dp, factor = 0.4_dp
   character(*), parameter :: names(2) = [character(15) :: 'wave_1d', 'wave_2d_elastic']

contains

   !> A wave in one direction or in two, under a load over that of full contact.
   subroutine new_wave(case, dimensions, load)
      type(trial_case_t), intent(out) :: case
      integer, intent(in) :: dimensions
      real(dp), intent(in) :: load

      call new_case(case, trim(names(dimensions)))
      call case%give('period', period)
      call case%give('amplitude', amplitude)
      call case%give('contact_modulus', modulus)
      call case%give('mean_pressure', load*full(dimensions))
      if (dimensions == 2) call case%give('cells', 64.0_dp)
   end subroutine new_wave

   !> Let it adhere, with a stress in units of the load of full contact and a range in units of the amplitude.
   subroutine adhere(case, dimensions, stress, range)
      type(trial_case_t), intent(inout) :: case
      integer, intent(in) :: dimensions
      real(dp), intent(in) :: stress, range

      call case%give('stress', stress*full(dimensions))
      call case%give('range', range*amplitude)
   end subroutine adhere

   !> Give strength and factor, and solve.
   subroutine rub(case, tau0, alpha)
      type(trial_case_t), intent(inout) :: case
      real(dp), intent(in) :: tau0, alpha

      call case%give('shear_strength', tau0)
      call case%give('pressure_factor', alpha)
#line 52 "/work/main/tests/material/material_shear_strength.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 52) )
  if (anyExceptions()) return
#line 53 "/work/main/tests/material/material_shear_strength.pf"
      call case%solve()
#line 54 "/work/main/tests/material/material_shear_strength.pf"
  call assertEqual(0, case%status(1), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 54) )
  if (anyExceptions()) return
#line 55 "/work/main/tests/material/material_shear_strength.pf"
   end subroutine rub

   ! A strength alone acts on the area, a factor alone on the load, and both on both; without the group there is no friction.
   !@test
   subroutine test_area_and_load()
      type(trial_case_t) :: case
      real(dp) :: load
      integer :: k

      do k = 1, 2
         load = 0.3_dp*full(k)
         call new_wave(case, k, 0.3_dp)
         call case%solve()
#line 68 "/work/main/tests/material/material_shear_strength.pf"
  call assertTrue(ieee_is_nan(case%found('friction_stress')), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 68) )
  if (anyExceptions()) return
#line 69 "/work/main/tests/material/material_shear_strength.pf"
#line 69 "/work/main/tests/material/material_shear_strength.pf"
  call assertTrue(ieee_is_nan(case%found('friction_coefficient')), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 69) )
  if (anyExceptions()) return
#line 70 "/work/main/tests/material/material_shear_strength.pf"
         call rub(case, strength, unset)
#line 71 "/work/main/tests/material/material_shear_strength.pf"
  call assertRelativelyEqual(strength*case%found('contact_fraction'), case%found('friction_stress'), tolerance=1.0e-15_dp, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 71) )
  if (anyExceptions()) return
#line 72 "/work/main/tests/material/material_shear_strength.pf"
         call rub(case, 0.0_dp, factor)
#line 73 "/work/main/tests/material/material_shear_strength.pf"
  call assertRelativelyEqual(factor*load, case%found('friction_stress'), tolerance=1.0e-15_dp, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 73) )
  if (anyExceptions()) return
#line 74 "/work/main/tests/material/material_shear_strength.pf"
#line 74 "/work/main/tests/material/material_shear_strength.pf"
  call assertRelativelyEqual(factor, case%found('friction_coefficient'), tolerance=1.0e-15_dp, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 74) )
  if (anyExceptions()) return
#line 75 "/work/main/tests/material/material_shear_strength.pf"
         call rub(case, strength, factor)
         associate (both => strength*case%found('contact_fraction') + factor*load)
#line 77 "/work/main/tests/material/material_shear_strength.pf"
  call assertRelativelyEqual(both, case%found('friction_stress'), tolerance=1.0e-15_dp, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 77) )
  if (anyExceptions()) return
#line 78 "/work/main/tests/material/material_shear_strength.pf"
         end associate
      end do
   end subroutine test_area_and_load

   ! In full contact everything is sheared; without contact nothing; adhesion has friction under no load and under a tension.
   !@test
   subroutine test_limits()
      type(trial_case_t) :: case
      integer :: k

      do k = 1, 2
         call new_wave(case, k, 1.2_dp)
         call rub(case, strength, factor)
#line 91 "/work/main/tests/material/material_shear_strength.pf"
  call assertRelativelyEqual(strength + factor*1.2_dp*full(k), case%found('friction_stress'), tolerance=1.0e-12_dp, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 91) )
  if (anyExceptions()) return
#line 92 "/work/main/tests/material/material_shear_strength.pf"
         call new_wave(case, k, 0.0_dp)
         call rub(case, strength, factor)
#line 94 "/work/main/tests/material/material_shear_strength.pf"
  call assertEqual(0.0_dp, case%found('friction_stress'), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 94) )
  if (anyExceptions()) return
#line 95 "/work/main/tests/material/material_shear_strength.pf"
#line 95 "/work/main/tests/material/material_shear_strength.pf"
  call assertTrue(ieee_is_nan(case%found('friction_coefficient')), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 95) )
  if (anyExceptions()) return
#line 96 "/work/main/tests/material/material_shear_strength.pf"
         call new_wave(case, k, 0.0_dp)
         call adhere(case, k, 0.3_dp, 0.3_dp)
         call rub(case, strength, factor)
#line 99 "/work/main/tests/material/material_shear_strength.pf"
  call assertGreaterThan(case%found('friction_stress'), strength*case%found('contact_fraction'), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 99) )
  if (anyExceptions()) return
#line 100 "/work/main/tests/material/material_shear_strength.pf"
#line 100 "/work/main/tests/material/material_shear_strength.pf"
  call assertTrue(ieee_is_nan(case%found('friction_coefficient')), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 100) )
  if (anyExceptions()) return
#line 101 "/work/main/tests/material/material_shear_strength.pf"
         call case%give('mean_pressure', -0.01_dp*full(k))
         call rub(case, strength, factor)
#line 103 "/work/main/tests/material/material_shear_strength.pf"
  call assertGreaterThan(case%found('friction_stress'), 0.0_dp, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 103) )
  if (anyExceptions()) return
#line 104 "/work/main/tests/material/material_shear_strength.pf"
#line 104 "/work/main/tests/material/material_shear_strength.pf"
  call assertTrue(ieee_is_nan(case%found('friction_coefficient')), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 104) )
  if (anyExceptions()) return
#line 105 "/work/main/tests/material/material_shear_strength.pf"
      end do
   end subroutine test_limits

   ! What contact carries is the pressure in it: the load, and the tension outside it, and so on the exact wave as from its profile,
   ! also where contact pulls as a whole. The mean of the profile of the shear stress is friction.
   !@test
   subroutine test_pressure_of_contact()
      call check_profile(0.1_dp, 0.3_dp, pulls=.false.)
      call check_profile(-0.28_dp, 3.0_dp, pulls=.true.)
   end subroutine test_pressure_of_contact

   !> Compare under a load and with a range; the stress is 0.3 p*. The profile may have a place too many or too few at each edge.
   subroutine check_profile(load, range, pulls)
      real(dp), intent(in) :: load, range
      logical, intent(in) :: pulls
      integer, parameter :: n = 20000
      real(dp), parameter :: stress = 0.3_dp
      type(trial_case_t) :: case
      real(dp), allocatable :: profiles(:, :, :)
      real(dp) :: carried, width
      integer :: i

      call new_wave(case, 1, load)
      call adhere(case, 1, stress, range)
      call rub(case, strength, factor)
      width = case%found('contact_width')
      carried = (case%found('friction_stress') - strength*case%found('contact_fraction'))/factor
#line 132 "/work/main/tests/material/material_shear_strength.pf"
  call assertTrue(pulls .eqv. carried < 0, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 132) )
  if (anyExceptions()) return
#line 133 "/work/main/tests/material/material_shear_strength.pf"
      call case%give('profiles', 1.0_dp)
      call case%give('x_min', -period/2 + period/(2*n))
      call case%give('x_max', period/2 - period/(2*n))
      call case%give('n_x', real(n, dp))
      call case%get_profiles(profiles)
      associate (x => [(-period/2 + (i - 0.5_dp)*period/n, i=1, n)])
#line 139 "/work/main/tests/material/material_shear_strength.pf"
  call assertEqual(sum(profiles(:, 1, 1), mask=abs(x) < width/2)/n, carried, tolerance=2*stress*full(1)/n, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 139) )
  if (anyExceptions()) return
#line 140 "/work/main/tests/material/material_shear_strength.pf"
#line 140 "/work/main/tests/material/material_shear_strength.pf"
  call assertTrue(all(abs(profiles(:, 1, 3)) <= 0 .or. abs(x) <= width/2), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 140) )
  if (anyExceptions()) return
#line 141 "/work/main/tests/material/material_shear_strength.pf"
#line 141 "/work/main/tests/material/material_shear_strength.pf"
  call assertEqual(sum(profiles(:, 1, 3))/n, case%found('friction_stress'), tolerance=2*strength/n, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 141) )
  if (anyExceptions()) return
#line 142 "/work/main/tests/material/material_shear_strength.pf"
      end associate
   end subroutine check_profile

   ! The profile goes on behind the period as the wave does, in full contact it has no gap, without contact it is 0.
   !@test
   subroutine test_profile_of_waves()
      integer, parameter :: n = 40
      real(dp), parameter :: loads(3) = [0.0_dp, 0.3_dp, 1.2_dp]
      type(trial_case_t) :: case
      real(dp), allocatable :: profiles(:, :, :)
      integer :: k

      do k = 1, size(loads)
         call new_wave(case, 1, loads(k))
         call rub(case, strength, factor)
         call case%give('profiles', 1.0_dp)
         call case%give('x_min', -1.5_dp*period)
         call case%give('x_max', 2.5_dp*period)
         call case%give('n_x', 4.0_dp*n + 1)
         call case%get_profiles(profiles)
         associate (p => profiles(:, 1, 1), shear => profiles(:, 1, 3))
#line 163 "/work/main/tests/material/material_shear_strength.pf"
  call assertEqual(shear(:3*n), shear(n + 1:4*n), tolerance=1.0e-9_dp*strength, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 163) )
  if (anyExceptions()) return
#line 164 "/work/main/tests/material/material_shear_strength.pf"
            select case (k)
            case (1)
#line 166 "/work/main/tests/material/material_shear_strength.pf"
  call assertTrue(all(abs(shear) <= 0), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 166) )
  if (anyExceptions()) return
#line 167 "/work/main/tests/material/material_shear_strength.pf"
            case (2)
#line 168 "/work/main/tests/material/material_shear_strength.pf"
  call assertEqual(merge(strength + factor*p, 0.0_dp, p > 0), shear, tolerance=1.0e-15_dp*strength, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 168) )
  if (anyExceptions()) return
#line 169 "/work/main/tests/material/material_shear_strength.pf"
#line 169 "/work/main/tests/material/material_shear_strength.pf"
  call assertTrue(any(abs(shear) <= 0) .and. any(shear > strength), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 169) )
  if (anyExceptions()) return
#line 170 "/work/main/tests/material/material_shear_strength.pf"
            case (3)
#line 171 "/work/main/tests/material/material_shear_strength.pf"
  call assertEqual(strength + factor*p, shear, tolerance=1.0e-15_dp*strength, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 171) )
  if (anyExceptions()) return
#line 172 "/work/main/tests/material/material_shear_strength.pf"
            end select
         end associate
      end do
   end subroutine test_profile_of_waves

   ! The map is 0 outside contact, and has the pressure of contact in it: the load, and what pulls outside. A case without friction
   ! has no such map.
   !@test
   subroutine test_map()
      type(trial_case_t) :: case
      real(dp), allocatable :: maps(:, :, :)
      real(dp) :: mean
      integer :: k

      call new_wave(case, 2, 0.1_dp)
      call case%give('profiles', 1.0_dp)
      do k = 1, 2
         if (k == 2) call adhere(case, 2, 0.3_dp, 0.3_dp)
         call case%give('shear_strength', unset)
         call case%give('pressure_factor', unset)
         call case%solve()
#line 193 "/work/main/tests/material/material_shear_strength.pf"
  call assertTrue(ieee_is_nan(case%found('friction_force')), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 193) )
  if (anyExceptions()) return
#line 194 "/work/main/tests/material/material_shear_strength.pf"
         call case%get_profiles(maps)
#line 195 "/work/main/tests/material/material_shear_strength.pf"
  call assertEqual([32, 32, 2], shape(maps), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 195) )
  if (anyExceptions()) return
#line 196 "/work/main/tests/material/material_shear_strength.pf"
#line 196 "/work/main/tests/material/material_shear_strength.pf"
  call assertEqual(2, case%model%count_profiles(case%values), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 196) )
  if (anyExceptions()) return
#line 197 "/work/main/tests/material/material_shear_strength.pf"
         call rub(case, strength, factor)
#line 198 "/work/main/tests/material/material_shear_strength.pf"
  call assertRelativelyEqual(period**2*case%found('friction_stress'), case%found('friction_force'), tolerance=1.0e-15_dp, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 198) )
  if (anyExceptions()) return
#line 199 "/work/main/tests/material/material_shear_strength.pf"
         call case%get_profiles(maps)
#line 200 "/work/main/tests/material/material_shear_strength.pf"
  call assertEqual([32, 32, 3], shape(maps), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 200) )
  if (anyExceptions()) return
#line 201 "/work/main/tests/material/material_shear_strength.pf"
         associate (p => maps(:, :, 1), gap => maps(:, :, 2), shear => maps(:, :, 3), n => 32**2)
#line 202 "/work/main/tests/material/material_shear_strength.pf"
  call assertTrue(all((shear > 0) .eqv. .not. gap > 0), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 202) )
  if (anyExceptions()) return
#line 203 "/work/main/tests/material/material_shear_strength.pf"
            mean = (strength*count(shear > 0) - factor*sum(p, mask=gap > 0))/n + factor*0.1_dp*full(2)
#line 204 "/work/main/tests/material/material_shear_strength.pf"
  call assertRelativelyEqual(mean, sum(shear)/n, tolerance=1.0e-9_dp, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 204) )
  if (anyExceptions()) return
#line 205 "/work/main/tests/material/material_shear_strength.pf"
            ! cells at the perimeter are counted as a whole in the map
            associate (excess => count(shear > 0)/real(n, dp) - case%found('contact_fraction'))
#line 207 "/work/main/tests/material/material_shear_strength.pf"
  call assertGreaterThan(excess, 0.0_dp, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 207) )
  if (anyExceptions()) return
#line 208 "/work/main/tests/material/material_shear_strength.pf"
#line 208 "/work/main/tests/material/material_shear_strength.pf"
  call assertEqual(mean, case%found('friction_stress'), tolerance=1.0001_dp*strength*excess, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 208) )
  if (anyExceptions()) return
#line 209 "/work/main/tests/material/material_shear_strength.pf"
            end associate
         end associate
      end do
   end subroutine test_map

   ! Adhesion without contact has no friction, not even a rounded one.
   !@test
   subroutine test_no_contact()
      type(trial_case_t) :: case
      integer :: k, n_adhered

      n_adhered = 0
      do k = 1, 40
         call new_wave(case, 1, 0.0_dp)
         call adhere(case, 1, 0.3_dp, 3.0_dp)
         call case%give('mean_pressure', unset)
         call case%give('penetration', -0.1_dp*k*amplitude)
         call case%give('branch', 2.0_dp)
         call rub(case, strength, factor)
         if (case%found('contact_fraction') > 0) cycle
         if (case%found('adhesion_fraction') > 0) n_adhered = n_adhered + 1
#line 230 "/work/main/tests/material/material_shear_strength.pf"
  call assertEqual(0.0_dp, case%found('friction_stress'), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 230) )
  if (anyExceptions()) return
#line 231 "/work/main/tests/material/material_shear_strength.pf"
      end do
#line 232 "/work/main/tests/material/material_shear_strength.pf"
  call assertGreaterThan(n_adhered, 5, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 232) )
  if (anyExceptions()) return
#line 233 "/work/main/tests/material/material_shear_strength.pf"
   end subroutine test_no_contact

   ! A wave in one direction on a line of cells, with adhesion and without, has the friction of the exact one within its error.
   !@test
   subroutine test_wave_on_cells()
      integer, parameter :: n = 2048
      real(dp), parameter :: loads(*) = [-0.02_dp, 0.0_dp, 0.1_dp, 0.3_dp, 0.6_dp]
      type(trial_case_t) :: cells, exact
      type(problems_t) :: problems
      real(dp), allocatable :: maps(:, :, :)
      integer :: i, k

      call new_case(cells, 'surface_elastic')
      call cells%model%take_dataset(cells%model%index_of('surface', 'heights'), &
         & reshape([(amplitude*cos(2*pi*(i - 0.5_dp)/n), i=1, n)], [n, 1]), problems)
#line 248 "/work/main/tests/material/material_shear_strength.pf"
  call assertEqual(0, problems%count(), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 248) )
  if (anyExceptions()) return
#line 249 "/work/main/tests/material/material_shear_strength.pf"
      call cells%give('heights', 1.0_dp)
      call cells%give('length_x', period)
      call cells%give('contact_modulus', modulus)
      do i = 1, 2
         call new_wave(exact, 1, 0.0_dp)
         if (i == 2) call adhere(exact, 1, 0.3_dp, 0.3_dp)
         if (i == 2) call adhere(cells, 1, 0.3_dp, 0.3_dp)
         do k = merge(3, 1, i == 1), size(loads)
            call exact%give('mean_pressure', loads(k)*full(1))
            call cells%give('mean_pressure', loads(k)*full(1))
            call rub(exact, strength, factor)
            call rub(cells, strength, factor)
#line 261 "/work/main/tests/material/material_shear_strength.pf"
  call assertLessThan(cells%error_estimate(1), 0.02_dp, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 261) )
  if (anyExceptions()) return
#line 262 "/work/main/tests/material/material_shear_strength.pf"
            associate (ratio => cells%found('friction_stress')/exact%found('friction_stress'))
#line 263 "/work/main/tests/material/material_shear_strength.pf"
  call assertEqual(1.0_dp, ratio, tolerance=cells%error_estimate(1), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 263) )
  if (anyExceptions()) return
#line 264 "/work/main/tests/material/material_shear_strength.pf"
            end associate
#line 265 "/work/main/tests/material/material_shear_strength.pf"
  call assertTrue(ieee_is_nan(cells%found('friction_force')), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 265) )
  if (anyExceptions()) return
#line 266 "/work/main/tests/material/material_shear_strength.pf"
            ! on a line the cells of the map are the area, and its mean is friction
            call cells%get_profiles(maps)
#line 268 "/work/main/tests/material/material_shear_strength.pf"
  call assertRelativelyEqual(count(maps(:, :, 3) > 0)/real(n, dp), cells%found('contact_fraction'), tolerance=1.0e-14_dp, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 268) )
  if (anyExceptions()) return
#line 269 "/work/main/tests/material/material_shear_strength.pf"
#line 269 "/work/main/tests/material/material_shear_strength.pf"
  call assertRelativelyEqual(sum(maps(:, :, 3))/n, cells%found('friction_stress'), tolerance=1.0e-9_dp, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 269) )
  if (anyExceptions()) return
#line 270 "/work/main/tests/material/material_shear_strength.pf"
         end do
      end do
   end subroutine test_wave_on_cells

   ! Other units of length and pressure change friction with them.
   !@test
   subroutine test_units()
      type(trial_case_t) :: case, other
      integer :: k

      do k = 1, 2
         call new_wave(case, k, 0.1_dp)
         call adhere(case, k, 0.3_dp, 0.3_dp)
         call rub(case, strength, factor)
         call new_case(other, trim(names(k)))
         call other%give('period', 8*period)
         call other%give('amplitude', 8*amplitude)
         call other%give('contact_modulus', 64*modulus)
         call other%give('mean_pressure', 64*0.1_dp*full(k))
         if (k == 2) call other%give('cells', 64.0_dp)
         call other%give('stress', 64*0.3_dp*full(k))
         call other%give('range', 8*0.3_dp*amplitude)
         call rub(other, 64*strength, factor)
         associate (stresses => [64*case%found('friction_stress'), other%found('friction_stress')])
#line 294 "/work/main/tests/material/material_shear_strength.pf"
  call assertRelativelyEqual(stresses(1), stresses(2), tolerance=1.0e-9_dp, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 294) )
  if (anyExceptions()) return
#line 295 "/work/main/tests/material/material_shear_strength.pf"
         end associate
         associate (coefficients => [case%found('friction_coefficient'), other%found('friction_coefficient')])
#line 297 "/work/main/tests/material/material_shear_strength.pf"
  call assertRelativelyEqual(coefficients(1), coefficients(2), tolerance=1.0e-9_dp, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 297) )
  if (anyExceptions()) return
#line 298 "/work/main/tests/material/material_shear_strength.pf"
         end associate
         if (k == 1) cycle
         associate (forces => [64*8**2*case%found('friction_force'), other%found('friction_force')])
#line 301 "/work/main/tests/material/material_shear_strength.pf"
  call assertRelativelyEqual(forces(1), forces(2), tolerance=1.0e-9_dp, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 301) )
  if (anyExceptions()) return
#line 302 "/work/main/tests/material/material_shear_strength.pf"
         end associate
      end do
   end subroutine test_units

   !> What the program says of an input with this group.
   function told_of(friction) result(lines)
      character(*), intent(in) :: friction
      character(:), allocatable :: lines
      type(namelist_file_t) :: file
      type(problems_t) :: problems
      type(run_input_t) :: run
      type(trial_case_t) :: case
      integer :: k

      call new_case(case, 'wave_1d')
      allocate (run%model, source=case%model)
      call new_namelist_file(file, 'f.nml', '&surface period = 1e-5, amplitude = 1e-7 /'//new_line('a')// &
         & '&solid contact_modulus = 1e7 /'//new_line('a')//'&operating mean_pressure = 1e4 /'//new_line('a')// &
         & '&friction '//friction//' /'//new_line('a'), problems)
      call read_case(file, run, problems)
      lines = ''
      do k = 1, problems%count()
         lines = lines//problems%line_of(k, 'f.nml')//new_line('a')
      end do
   end function told_of

   !@test
   subroutine test_ranges()
#line 330 "/work/main/tests/material/material_shear_strength.pf"
  call assertEqual('', told_of('shear_strength = 0, pressure_factor = 0'), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 330) )
  if (anyExceptions()) return
#line 331 "/work/main/tests/material/material_shear_strength.pf"
#line 331 "/work/main/tests/material/material_shear_strength.pf"
  call assertTrue(index(told_of('shear_strength = -1e3'), '&friction shear_strength: out of range, given -1000 Pa') > 0, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 331) )
  if (anyExceptions()) return
#line 332 "/work/main/tests/material/material_shear_strength.pf"
#line 332 "/work/main/tests/material/material_shear_strength.pf"
  call assertTrue(index(told_of('shear_strength = NaN'), '&friction shear_strength: not a finite number') > 0, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 332) )
  if (anyExceptions()) return
#line 333 "/work/main/tests/material/material_shear_strength.pf"
#line 333 "/work/main/tests/material/material_shear_strength.pf"
  call assertTrue(index(told_of('shear_strength = 1, pressure_factor = -0.1'), '&friction pressure_factor: out of range') > 0, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 333) )
  if (anyExceptions()) return
#line 334 "/work/main/tests/material/material_shear_strength.pf"
#line 334 "/work/main/tests/material/material_shear_strength.pf"
  call assertTrue(index(told_of('shear_strength = 1, pressure_factor = NaN'), '&friction pressure_factor: not a finite') > 0, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 334) )
  if (anyExceptions()) return
#line 335 "/work/main/tests/material/material_shear_strength.pf"
   end subroutine test_ranges

   !@test
   subroutine test_rejections()
      type(trial_case_t) :: case
      integer :: k

      do k = 1, 2
         call new_wave(case, k, 0.1_dp)
         call case%give('pressure_factor', factor)
#line 345 "/work/main/tests/material/material_shear_strength.pf"
  call assertTrue(index(case%problems_of(), '&friction shear_strength: is missing [Pa]; pressure_factor needs it') > 0, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 345) )
  if (anyExceptions()) return
#line 346 "/work/main/tests/material/material_shear_strength.pf"
         call case%give('shear_strength', 0.0_dp)
#line 347 "/work/main/tests/material/material_shear_strength.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 347) )
  if (anyExceptions()) return
#line 348 "/work/main/tests/material/material_shear_strength.pf"
         call adhere(case, k, 0.3_dp, 0.3_dp)
#line 349 "/work/main/tests/material/material_shear_strength.pf"
  call assertTrue(index(case%problems_of(), '&friction pressure_factor: times the stress of adhesion is above') > 0, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 349) )
  if (anyExceptions()) return
#line 350 "/work/main/tests/material/material_shear_strength.pf"
         call case%give('shear_strength', 1.01_dp*factor*0.3_dp*full(k))
#line 351 "/work/main/tests/material/material_shear_strength.pf"
  call assertEqual('', case%problems_of(), &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 351) )
  if (anyExceptions()) return
#line 352 "/work/main/tests/material/material_shear_strength.pf"
      end do
      call new_wave(case, 1, 0.1_dp)
      call case%give('contact_modulus', unset)
      call case%give('shear_strength', strength)
      call case%give('velocity', 1.0_dp)
      call case%give('modulus', modulus)
#line 358 "/work/main/tests/material/material_shear_strength.pf"
  call assertTrue(index(case%problems_of(), '&friction shear_strength: stands beside &material') > 0, &
 & location=SourceLocation( &
 & 'material_shear_strength.pf', &
 & 358) )
  if (anyExceptions()) return
#line 359 "/work/main/tests/material/material_shear_strength.pf"
   end subroutine test_rejections

end module material_shear_strength

module Wrapmaterial_shear_strength
   use FUnit
   use material_shear_strength
   implicit none
   private

contains


end module Wrapmaterial_shear_strength

function material_shear_strength_suite() result(suite)
   use FUnit
   use material_shear_strength
   use Wrapmaterial_shear_strength
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('material_shear_strength_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_area_and_load', &
      test_area_and_load))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_limits', &
      test_limits))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_pressure_of_contact', &
      test_pressure_of_contact))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_profile_of_waves', &
      test_profile_of_waves))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_map', &
      test_map))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_no_contact', &
      test_no_contact))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_wave_on_cells', &
      test_wave_on_cells))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_units', &
      test_units))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_ranges', &
      test_ranges))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_rejections', &
      test_rejections))
   call suite%addTest(t)


end function material_shear_strength_suite

