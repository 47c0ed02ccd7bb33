! SPDX-License-Identifier: GPL-3.0-or-later
! A shear strength tau0 + alpha p under an indenter: the table of Maugis's sphere, Coulomb's friction as the limit without
! tau0, the uniform strength of a face, derivatives, balance of the shear stress, other units, and what is refused.
module indenter_shear
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi, pi
   use adfric_indenter_model, only: indenter_model_t
   use adfric_indenter_variables
   use adfric_model_status, only: status_solved, status_no_equilibrium
   use indenter_cases, only: new_indenter, new_named, hold
   use model_calls, only: find_problems, solve_point
   use reference_table, only: table_t, read_table, table_digits
   use funit
   implicit none (type, external)

   integer, parameter :: slips(4) = [r_stick_fraction, r_tangential_displacement, r_tangential_stiffness, r_cycle_energy]
   character(*), parameter :: kinds(6) = [character(16) :: 'cone', 'sphere', 'flat_cone', 'flat_paraboloid', 'rounded_punch', &
      & 'rounded_cone']
   character(*), parameter :: parameters(6) = [character(15) :: 'slope=0.3', 'R=1.2', 'b=0.9;slope=0.3', 'b=0.9;R=1', &
      & 'b=0.9;R=1', 'b=0.9;slope=0.3']

contains

   !> A contact of radius 1 that slides, or slips under a share of the force of sliding.
   subroutine slip(model, values, share, results, label)
      type(indenter_model_t), intent(in) :: model
      real(dp), intent(in) :: values(:), share
      real(dp), intent(out) :: results(n_indenter_results)
      character(*), intent(in) :: label
      real(dp) :: point(size(values)), error_estimate
      integer :: status

      point = values
      call solve_point(model, point, results, error_estimate, status)
#line 36 "/work/main/tests/indenter/indenter_shear.pf"
  call assertEqual(status_solved, status, message=label, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 36) )
  if (anyExceptions()) return
#line 37 "/work/main/tests/indenter/indenter_shear.pf"
      point(v_tangential_force) = share*results(r_friction_force)
      call solve_point(model, point, results, error_estimate, status)
#line 39 "/work/main/tests/indenter/indenter_shear.pf"
  call assertEqual(status_solved, status, message=label, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 39) )
  if (anyExceptions()) return
#line 40 "/work/main/tests/indenter/indenter_shear.pf"
   end subroutine slip

   !> A kind of the list with a zone of adhesion.
   subroutine new_sticky(model, values, kind, edge_fraction)
      type(indenter_model_t), intent(out) :: model
      real(dp), allocatable, intent(out) :: values(:)
      integer, intent(in) :: kind
      real(dp), intent(in) :: edge_fraction

      call new_named(model, values, trim(kinds(kind)), trim(parameters(kind)))
      call hold(values, v_contact_radius, 1.0_dp)
      values([v_poisson_ratio, v_work_of_adhesion, v_adhesion_stress]) = [0.3_dp, 2.0e-3_dp, 0.05_dp]
      values(v_theory) = choose_maugis_dugdale
      values([v_shear_strength, v_pressure_factor, v_edge_fraction]) = [0.02_dp, 0.3_dp, edge_fraction]
   end subroutine new_sticky

   ! The sphere of Maugis and Dugdale in reduced units: E* = 3/4 K with K = 1, R = 1, w = 1/pi.
   !@test
   subroutine test_table()
      type(table_t) :: table
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: results(n_indenter_results), error_estimate, expected
      character(80) :: label
      integer :: row, status

      call read_table(table, 'slip_law')
#line 67 "/work/main/tests/indenter/indenter_shear.pf"
  call assertGreaterThan(table%n_rows, 20, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 67) )
  if (anyExceptions()) return
#line 68 "/work/main/tests/indenter/indenter_shear.pf"
      call new_indenter(model, values, kind_paraboloid)
      values([v_radius, v_contact_modulus, v_poisson_ratio, v_work_of_adhesion]) = [1.0_dp, 0.75_dp, 0.0_dp, 1/pi]
      do row = 1, table%n_rows
         label = table%label(row)
         values(v_lambda) = table%number(row, 'lambda')
         values(v_edge_fraction) = 0.4_dp
         ! a0 = (pi w R^2/K)^(1/3) = 1; like lambda, tau0 is in halves of pi w R/a0^2
         values([v_shear_strength, v_pressure_factor]) = [table%number(row, 'tau0')/2, table%number(row, 'alpha')]
         call hold(values, v_load, table%number(row, 'P'))
         values(v_tangential_force) = table%number(row, 'T')
         call solve_point(model, values, results, error_estimate, status)
#line 79 "/work/main/tests/indenter/indenter_shear.pf"
  call assertEqual(status_solved, status, message=label, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 79) )
  if (anyExceptions()) return
#line 80 "/work/main/tests/indenter/indenter_shear.pf"
#line 80 "/work/main/tests/indenter/indenter_shear.pf"
  call assertRelativelyEqual(table%number(row, 'T_slip'), results(r_friction_force), tolerance=1.0e-11_dp, message=label, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 80) )
  if (anyExceptions()) return
#line 81 "/work/main/tests/indenter/indenter_shear.pf"
         expected = table%number(row, 'u')
         ! in sliding u goes by round-off of T to the power 2/3
         associate (fair => merge(1.0e-11_dp, 1.0e-10_dp, table%number(row, 'e_over_b') > 0))
#line 84 "/work/main/tests/indenter/indenter_shear.pf"
  call assertEqual(expected, results(r_tangential_displacement), tolerance=fair*expected, message=label, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 84) )
  if (anyExceptions()) return
#line 85 "/work/main/tests/indenter/indenter_shear.pf"
         end associate
         expected = table%number(row, 'e_over_b')**2
#line 87 "/work/main/tests/indenter/indenter_shear.pf"
  call assertEqual(expected, results(r_stick_fraction), tolerance=1.0e-7_dp, message=label, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 87) )
  if (anyExceptions()) return
#line 88 "/work/main/tests/indenter/indenter_shear.pf"
      end do
   end subroutine test_table

   ! Without tau0 and adhesion it is Coulomb's friction, computed in another way.
   !@test
   subroutine test_coulomb()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: results(n_indenter_results), coulomb(n_indenter_results), error_estimate, share
      character(80) :: label
      integer :: kind, k, i, status

      do kind = 1, size(kinds)
         call new_named(model, values, trim(kinds(kind)), trim(parameters(kind)))
         call hold(values, v_contact_radius, 1.0_dp)
         values(v_poisson_ratio) = 0.3_dp
         do k = -8, 8
            share = 0.5_dp
            if (k < 0) share = 10.0_dp**k
            if (k > 0) share = 1 - 10.0_dp**(-k)
            values([v_shear_strength, v_pressure_factor, v_tangential_force]) = [0.0_dp, 0.3_dp, 0.0_dp]
            call slip(model, values, share, results, kinds(kind))
            values([v_friction_coefficient, v_tangential_force]) = [0.3_dp, share*results(r_friction_force)]
            values([v_shear_strength, v_pressure_factor]) = values(v_load)
            call solve_point(model, values, coulomb, error_estimate, status)
#line 113 "/work/main/tests/indenter/indenter_shear.pf"
  call assertEqual(status_solved, status, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 113) )
  if (anyExceptions()) return
#line 114 "/work/main/tests/indenter/indenter_shear.pf"
            values(v_friction_coefficient) = values(v_load)
            write (label, '(a, es9.1)') kinds(kind), share
#line 116 "/work/main/tests/indenter/indenter_shear.pf"
  call assertRelativelyEqual(0.3_dp*coulomb(r_load), results(r_friction_force), tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 116) )
  if (anyExceptions()) return
#line 117 "/work/main/tests/indenter/indenter_shear.pf"
            do i = 1, size(slips)
               if (k > 4 .and. i /= 2) cycle
#line 119 "/work/main/tests/indenter/indenter_shear.pf"
  call assertRelativelyEqual(coulomb(slips(i)), results(slips(i)), tolerance=1.0e-11_dp, message=label, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 119) )
  if (anyExceptions()) return
#line 120 "/work/main/tests/indenter/indenter_shear.pf"
            end do
         end do
      end do
   end subroutine test_coulomb

   ! A face of uniform strength: u = 2 tau0/G* sqrt(b^2 - e^2), T = 2 tau0 [b^2 arccos(e/b) + e sqrt(b^2 - e^2)]; alpha P holds it.
   !@test
   subroutine test_faces()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: results(n_indenter_results), angle, force, error_estimate
      integer :: k, status

      call new_named(model, values, 'flat', 'b=0.4')
      values(v_poisson_ratio) = 0
      call hold(values, v_load, 2.0_dp)
      values(v_shear_strength) = 0.7_dp
      do k = 1, 20
         angle = half_pi*k/20
         force = 2*0.7_dp*0.4_dp**2*(angle + sin(angle)*cos(angle))
         call slip(model, values, min(force/(0.7_dp*pi*0.4_dp**2), 1.0_dp), results, 'flat')
#line 141 "/work/main/tests/indenter/indenter_shear.pf"
  call assertEqual(cos(angle)**2, results(r_stick_fraction), tolerance=1.0e-7_dp, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 141) )
  if (anyExceptions()) return
#line 142 "/work/main/tests/indenter/indenter_shear.pf"
#line 142 "/work/main/tests/indenter/indenter_shear.pf"
  call assertRelativelyEqual(2*0.7_dp*0.4_dp*sin(angle), results(r_tangential_displacement), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 142) )
  if (anyExceptions()) return
#line 143 "/work/main/tests/indenter/indenter_shear.pf"
      end do
      values([v_pressure_factor, v_tangential_force]) = [0.25_dp, 0.4_dp]
      call solve_point(model, values, results, error_estimate, status)
#line 146 "/work/main/tests/indenter/indenter_shear.pf"
  call assertEqual(status_solved, status, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 146) )
  if (anyExceptions()) return
#line 147 "/work/main/tests/indenter/indenter_shear.pf"
#line 147 "/work/main/tests/indenter/indenter_shear.pf"
  call assertEqual(1.0_dp, results(r_stick_fraction), &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 147) )
  if (anyExceptions()) return
#line 148 "/work/main/tests/indenter/indenter_shear.pf"
#line 148 "/work/main/tests/indenter/indenter_shear.pf"
  call assertEqual(0.0_dp, results(r_cycle_energy), &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 148) )
  if (anyExceptions()) return
#line 149 "/work/main/tests/indenter/indenter_shear.pf"
#line 149 "/work/main/tests/indenter/indenter_shear.pf"
  call assertRelativelyEqual(0.4_dp/0.8_dp, results(r_tangential_displacement), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 149) )
  if (anyExceptions()) return
#line 150 "/work/main/tests/indenter/indenter_shear.pf"
#line 150 "/work/main/tests/indenter/indenter_shear.pf"
  call assertRelativelyEqual(0.7_dp*pi*0.16_dp + 0.5_dp, results(r_friction_force), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 150) )
  if (anyExceptions()) return
#line 151 "/work/main/tests/indenter/indenter_shear.pf"
      ! beyond alpha P the edge slips
      call slip(model, values, 0.9_dp, results, 'flat')
#line 153 "/work/main/tests/indenter/indenter_shear.pf"
  call assertLessThan(results(r_stick_fraction), 1.0_dp, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 153) )
  if (anyExceptions()) return
#line 154 "/work/main/tests/indenter/indenter_shear.pf"
#line 154 "/work/main/tests/indenter/indenter_shear.pf"
  call assertGreaterThan(results(r_cycle_energy), 0.0_dp, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 154) )
  if (anyExceptions()) return
#line 155 "/work/main/tests/indenter/indenter_shear.pf"
   end subroutine test_faces

   ! The stiffness is the slope of the force, and the energy of a cycle 8 (int T du - T u/2); each kind, adhesive.
   !@test
   subroutine test_slopes()
      real(dp), parameter :: step = 1.0e-4_dp
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: before(n_indenter_results), after(n_indenter_results), middle(n_indenter_results), share, rise, slope
      character(80) :: label
      integer :: kind, k, edge

      do kind = 1, size(kinds)
         do edge = 0, 2
            call new_sticky(model, values, kind, edge/2.0_dp)
            do k = 1, 9
               share = 0.1_dp*k
               write (label, '(2a, i0, f5.1)') kinds(kind), ' edge ', edge, share
               call slip(model, values, share - step, before, label)
               call slip(model, values, share, middle, label)
               call slip(model, values, share + step, after, label)
               associate (u => r_tangential_displacement, t => middle(r_friction_force))
                  rise = 2*step*t/(after(u) - before(u))
#line 178 "/work/main/tests/indenter/indenter_shear.pf"
  call assertRelativelyEqual(middle(r_tangential_stiffness), rise, tolerance=1.0e-5_dp, message=label, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 178) )
  if (anyExceptions()) return
#line 179 "/work/main/tests/indenter/indenter_shear.pf"
                  rise = -4*(middle(u) - share*t/middle(r_tangential_stiffness))
                  slope = (after(r_cycle_energy) - before(r_cycle_energy))/(2*step*t)
#line 181 "/work/main/tests/indenter/indenter_shear.pf"
  call assertRelativelyEqual(rise, slope, tolerance=2.0e-5_dp, message=label, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 181) )
  if (anyExceptions()) return
#line 182 "/work/main/tests/indenter/indenter_shear.pf"
               end associate
            end do
         end do
      end do
   end subroutine test_slopes

   ! The shear stress has the force: int 2 pi r q dr = T; at small and large shares, with a zone of adhesion.
   !@test
   subroutine test_balance()
      integer, parameter :: n = 160001
      real(dp), parameter :: shares(3) = [0.05_dp, 0.5_dp, 1.0_dp]
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:), profiles(:, :, :)
      real(dp) :: results(n_indenter_results), force, step
      integer :: kind, k, i

      allocate (profiles(n, 1, 3))
      do kind = 1, size(kinds)
         call new_sticky(model, values, kind, 0.5_dp)
         values([v_profiles, v_n_r, v_r_max]) = [1.0_dp, real(n, dp), 1.2_dp]
         step = 1.2_dp/(n - 1)
         do k = 1, size(shares)
            call slip(model, values, shares(k), results, kinds(kind))
            values(v_tangential_force) = shares(k)*results(r_friction_force)
            call model%solve_profiles(values, results, profiles)
            force = 0
            do i = 2, n
               ! at the corner of a face the pressure is infinite
               if (.not. ieee_is_nan(profiles(i, 1, 3))) force = force + 2*pi*(i - 1)*step*step*profiles(i, 1, 3)
            end do
#line 212 "/work/main/tests/indenter/indenter_shear.pf"
  call assertRelativelyEqual(values(v_tangential_force), force, tolerance=2.0e-4_dp, message=kinds(kind), &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 212) )
  if (anyExceptions()) return
#line 213 "/work/main/tests/indenter/indenter_shear.pf"
            values(v_tangential_force) = values(v_load)
         end do
      end do
   end subroutine test_balance

   ! Other units, the other sign, too large a force.
   !@test
   subroutine test_units()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: results(n_indenter_results), scaled(n_indenter_results), error_estimate, force
      integer :: status, k

      call new_sticky(model, values, 3, 0.3_dp)
      call slip(model, values, 0.4_dp, results, 'unit')
      ! lengths by 1e-6, stresses by 1e9
      values(v_face_radius) = values(v_face_radius)*1.0e-6_dp
      call hold(values, v_contact_radius, 1.0e-6_dp)
      values([v_contact_modulus, v_adhesion_stress, v_shear_strength]) &
         & = values([v_contact_modulus, v_adhesion_stress, v_shear_strength])*1.0e9_dp
      values(v_work_of_adhesion) = values(v_work_of_adhesion)*1.0e3_dp
      call slip(model, values, 0.4_dp, scaled, 'other units')
      force = 1.0e-3_dp*results(r_friction_force)
#line 236 "/work/main/tests/indenter/indenter_shear.pf"
  call assertRelativelyEqual(force, scaled(r_friction_force), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 236) )
  if (anyExceptions()) return
#line 237 "/work/main/tests/indenter/indenter_shear.pf"
      do k = 1, 4
         associate (unit => [1.0_dp, 1.0e-6_dp, 1.0e3_dp, 1.0e-9_dp])
#line 239 "/work/main/tests/indenter/indenter_shear.pf"
  call assertRelativelyEqual(unit(k)*results(slips(k)), scaled(slips(k)), tolerance=1.0e-11_dp, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 239) )
  if (anyExceptions()) return
#line 240 "/work/main/tests/indenter/indenter_shear.pf"
         end associate
      end do
      values(v_tangential_force) = -0.4_dp*scaled(r_friction_force)
      call solve_point(model, values, results, error_estimate, status)
#line 244 "/work/main/tests/indenter/indenter_shear.pf"
  call assertEqual(-scaled(r_tangential_displacement), results(r_tangential_displacement), &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 244) )
  if (anyExceptions()) return
#line 245 "/work/main/tests/indenter/indenter_shear.pf"
      values(v_tangential_force) = 1.0001_dp*scaled(r_friction_force)
      call solve_point(model, values, results, error_estimate, status)
#line 247 "/work/main/tests/indenter/indenter_shear.pf"
  call assertEqual(status_no_equilibrium, status, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 247) )
  if (anyExceptions()) return
#line 248 "/work/main/tests/indenter/indenter_shear.pf"
#line 248 "/work/main/tests/indenter/indenter_shear.pf"
  call assertTrue(ieee_is_nan(results(r_load)), &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 248) )
  if (anyExceptions()) return
#line 249 "/work/main/tests/indenter/indenter_shear.pf"
   end subroutine test_units

   !@test
   subroutine test_refusals()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)

      call new_named(model, values, 'cone', 'slope=0.3')
      call hold(values, v_load, 1.0_dp)
      values(v_pressure_factor) = 0.1_dp
#line 259 "/work/main/tests/indenter/indenter_shear.pf"
  call assertTrue(index(find_problems(model, values), '&friction shear_strength: is missing') > 0, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 259) )
  if (anyExceptions()) return
#line 260 "/work/main/tests/indenter/indenter_shear.pf"
      values(v_shear_strength) = 0.1_dp
#line 261 "/work/main/tests/indenter/indenter_shear.pf"
  call assertEqual('', find_problems(model, values), &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 261) )
  if (anyExceptions()) return
#line 262 "/work/main/tests/indenter/indenter_shear.pf"
      values(v_friction_coefficient) = 0.1_dp
      values([v_tangential_force, v_poisson_ratio]) = [0.1_dp, 0.3_dp]
#line 264 "/work/main/tests/indenter/indenter_shear.pf"
  call assertTrue(index(find_problems(model, values), '&friction coefficient: stands beside shear_strength') > 0, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 264) )
  if (anyExceptions()) return
#line 265 "/work/main/tests/indenter/indenter_shear.pf"
      values(v_friction_coefficient) = values(v_approach)
      values(v_work_of_adhesion) = 1.0e-3_dp
#line 267 "/work/main/tests/indenter/indenter_shear.pf"
  call assertTrue(index(find_problems(model, values), '&friction pressure_factor: has no partial slip in JKR') > 0, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 267) )
  if (anyExceptions()) return
#line 268 "/work/main/tests/indenter/indenter_shear.pf"
      values(v_adhesion_stress) = 2.0_dp
#line 269 "/work/main/tests/indenter/indenter_shear.pf"
  call assertTrue(index(find_problems(model, values), '&friction pressure_factor: times the stress of adhesion') > 0, &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 269) )
  if (anyExceptions()) return
#line 270 "/work/main/tests/indenter/indenter_shear.pf"
      values(v_adhesion_stress) = 0.9_dp
#line 271 "/work/main/tests/indenter/indenter_shear.pf"
  call assertEqual('', find_problems(model, values), &
 & location=SourceLocation( &
 & 'indenter_shear.pf', &
 & 271) )
  if (anyExceptions()) return
#line 272 "/work/main/tests/indenter/indenter_shear.pf"
   end subroutine test_refusals

end module indenter_shear

module Wrapindenter_shear
   use FUnit
   use indenter_shear
   implicit none
   private

contains


end module Wrapindenter_shear

function indenter_shear_suite() result(suite)
   use FUnit
   use indenter_shear
   use Wrapindenter_shear
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('indenter_shear_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_table', &
      test_table))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_coulomb', &
      test_coulomb))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_faces', &
      test_faces))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_slopes', &
      test_slopes))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_balance', &
      test_balance))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_units', &
      test_units))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_refusals', &
      test_refusals))
   call suite%addTest(t)


end function indenter_shear_suite

