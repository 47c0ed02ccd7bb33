! SPDX-License-Identifier: GPL-3.0-or-later
! Partial slip of the model `indenter`: tables, the smallest and the largest shares, Hertz's sphere, derivatives of displacement and
! energy, faces, signs, and what is refused.
module indenter_slip
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_indenter_model, only: indenter_model_t
   use adfric_indenter_variables
   use adfric_model_status, only: status_solved, status_no_equilibrium
   use indenter_cases, only: new_indenter, new_named, hold
   use model_calls, only: find_problems, solve_point
   use reference_table, only: table_t, read_table, table_digits
   use trial_case, only: trial_case_t, new_case
   use funit
   implicit none (type, external)

   real(dp), parameter :: mu = 0.3_dp
   integer, parameter :: slips(4) = [r_stick_fraction, r_tangential_displacement, r_tangential_stiffness, r_cycle_energy]

contains

   !> Solve a contact under a share of mu P.
   subroutine slip(model, values, tau, results, label)
      type(indenter_model_t), intent(in) :: model
      real(dp), intent(in) :: values(:), tau
      real(dp), intent(out) :: results(n_indenter_results)
      character(*), intent(in) :: label
      real(dp) :: point(size(values)), error_estimate
      integer :: status

      point = values
      point([v_tangential_force, v_friction_coefficient]) = [0.0_dp, mu]
      call solve_point(model, point, results, error_estimate, status)
      point(v_tangential_force) = tau*mu*results(r_load)
      call solve_point(model, point, results, error_estimate, status)
#line 37 "/work/main/tests/indenter/indenter_slip.pf"
  call assertEqual(status_solved, status, message=label, &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 37) )
  if (anyExceptions()) return
#line 38 "/work/main/tests/indenter/indenter_slip.pf"
   end subroutine slip

   ! Nine kinds at two shares, with the traction at two places.
   !@test
   subroutine test_shapes()
      type(table_t) :: table
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: results(n_indenter_results), profiles(21, 1, 3), force
      character(80) :: label
      integer :: row

      call read_table(table, 'slip_profiles')
#line 51 "/work/main/tests/indenter/indenter_slip.pf"
  call assertEqual(18, table%n_rows, &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 51) )
  if (anyExceptions()) return
#line 52 "/work/main/tests/indenter/indenter_slip.pf"
      do row = 1, table%n_rows
         call new_named(model, values, table%text(row, 'kind'), table%text(row, 'parameters'))
         values(v_poisson_ratio) = 0
         call hold(values, v_contact_radius, 1.0_dp)
         values([v_profiles, v_n_r]) = [1, 21]
         values(v_r_max) = 1
         label = table%label(row)
         associate (tau => table%number(row, 'T_over_muP'))
            call slip(model, values, tau, results, label)
#line 61 "/work/main/tests/indenter/indenter_slip.pf"
  call assertRelativelyEqual(table%number(row, 'e')**2, results(r_stick_fraction), tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 61) )
  if (anyExceptions()) return
#line 62 "/work/main/tests/indenter/indenter_slip.pf"
            associate (u => results(r_tangential_displacement))
#line 63 "/work/main/tests/indenter/indenter_slip.pf"
  call assertRelativelyEqual(table%number(row, 'u'), u, tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 63) )
  if (anyExceptions()) return
#line 64 "/work/main/tests/indenter/indenter_slip.pf"
            end associate
#line 65 "/work/main/tests/indenter/indenter_slip.pf"
  call assertRelativelyEqual(table%number(row, 'W'), results(r_cycle_energy), tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 65) )
  if (anyExceptions()) return
#line 66 "/work/main/tests/indenter/indenter_slip.pf"
#line 66 "/work/main/tests/indenter/indenter_slip.pf"
  call assertRelativelyEqual(2*table%number(row, 'e'), results(r_tangential_stiffness), tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 66) )
  if (anyExceptions()) return
#line 67 "/work/main/tests/indenter/indenter_slip.pf"
            force = tau*mu*results(r_load)
            values([v_tangential_force, v_friction_coefficient]) = [force, mu]
            call model%solve_profiles(values, results, profiles)
#line 70 "/work/main/tests/indenter/indenter_slip.pf"
  call assertRelativelyEqual(table%number(row, 'q_0.3'), profiles(7, 1, 3), tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 70) )
  if (anyExceptions()) return
#line 71 "/work/main/tests/indenter/indenter_slip.pf"
#line 71 "/work/main/tests/indenter/indenter_slip.pf"
  call assertRelativelyEqual(table%number(row, 'q_0.95'), profiles(20, 1, 3), tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 71) )
  if (anyExceptions()) return
#line 72 "/work/main/tests/indenter/indenter_slip.pf"
         end associate
      end do
   end subroutine test_shapes

   ! r^n of any exponent.
   !@test
   subroutine test_powers()
      type(table_t) :: table
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: results(n_indenter_results), depth, energy
      character(80) :: label
      integer :: row

      call read_table(table, 'slip_power')
#line 87 "/work/main/tests/indenter/indenter_slip.pf"
  call assertGreaterThan(table%n_rows, 30, &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 87) )
  if (anyExceptions()) return
#line 88 "/work/main/tests/indenter/indenter_slip.pf"
      do row = 1, table%n_rows
         call new_indenter(model, values, kind_power)
         values([v_exponent, v_coefficient]) = [table%number(row, 'n'), 0.3_dp]
         values(v_poisson_ratio) = 0
         call hold(values, v_contact_radius, 1.0_dp)
         label = table%label(row)
         associate (tau => table%number(row, 'tau'))
            call slip(model, values, tau, results, label)
            depth = results(r_approach)
            energy = table%number(row, 'W')*mu**2*depth**2
            depth = table%number(row, 'u')*mu*depth
#line 99 "/work/main/tests/indenter/indenter_slip.pf"
  call assertRelativelyEqual(depth, results(r_tangential_displacement), tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 99) )
  if (anyExceptions()) return
#line 100 "/work/main/tests/indenter/indenter_slip.pf"
#line 100 "/work/main/tests/indenter/indenter_slip.pf"
  call assertRelativelyEqual(energy, results(r_cycle_energy), tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 100) )
  if (anyExceptions()) return
#line 101 "/work/main/tests/indenter/indenter_slip.pf"
#line 101 "/work/main/tests/indenter/indenter_slip.pf"
  call assertEqual(table%number(row, 'stick')**2, results(r_stick_fraction), tolerance=table_digits, message=label, &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 101) )
  if (anyExceptions()) return
#line 102 "/work/main/tests/indenter/indenter_slip.pf"
         end associate
      end do
   end subroutine test_powers

   ! A paraboloid is the sphere of `hertz`, from the smallest share to the whole.
   !@test
   subroutine test_hertz()
      type(trial_case_t) :: hertz
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: results(n_indenter_results), tau
      character(*), parameter :: names(3) = [character(23) :: 'tangential_displacement', 'tangential_stiffness', 'cycle_energy']
      integer :: k, i

      call new_indenter(model, values, kind_paraboloid)
      values([v_radius, v_contact_modulus, v_poisson_ratio]) = [2.0e-3_dp, 1.0e9_dp, 0.4_dp]
      call hold(values, v_load, 3.0_dp)
      do k = -12, 12
         tau = 0.5_dp
         if (k < 0) tau = 10.0_dp**k
         if (k > 0) tau = 1 - 10.0_dp**(-k)
         call slip(model, values, tau, results, 'share')
         call new_case(hertz, 'hertz')
         call hertz%give('kind', 2.0_dp)
         call hertz%give('radius', 2.0e-3_dp)
         call hertz%give('contact_modulus', 1.0e9_dp)
         call hertz%give('poisson_ratio', 0.4_dp)
         call hertz%give('load', 3.0_dp)
         call hertz%give('coefficient', mu)
         call hertz%give('tangential_force', tau*mu*3)
         call hertz%solve()
         do i = 1, 3
            ! 1 - tau is rounded, and the stiffness its third root
            associate (fair => merge(1.0e-4_dp, table_digits, i == 2 .and. k > 6))
#line 136 "/work/main/tests/indenter/indenter_slip.pf"
  call assertRelativelyEqual(hertz%found(trim(names(i))), results(slips(i + 1)), tolerance=fair, message=names(i), &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 136) )
  if (anyExceptions()) return
#line 137 "/work/main/tests/indenter/indenter_slip.pf"
            end associate
         end do
      end do
   end subroutine test_hertz

   ! Across the share where the formulas change, and across the corner of a rounded cone, nothing jumps; the stiffness is the slope.
   !@test
   subroutine test_slopes()
      character(*), parameter :: kinds(4) = [character(13) :: 'rounded_cone', 'flat_cone', 'rounded_punch', 'sphere']
      character(*), parameter :: parameters(4) = [character(15) :: 'b=0.9;slope=0.3', 'b=0.9;slope=0.3', 'b=0.9;R=1', 'R=1.2']
      real(dp), parameter :: step = 1.0e-5_dp
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: before(n_indenter_results), after(n_indenter_results), middle(n_indenter_results), tau, rise
      integer :: kind, k

      do kind = 1, size(kinds)
         call new_named(model, values, trim(kinds(kind)), trim(parameters(kind)))
         values(v_poisson_ratio) = 0.2_dp
         call hold(values, v_contact_radius, 1.0_dp)
         do k = 1, 19
            tau = 0.05_dp*k
            call slip(model, values, tau - step, before, kinds(kind))
            call slip(model, values, tau, middle, kinds(kind))
            call slip(model, values, tau + step, after, kinds(kind))
            rise = 2*step*mu*middle(r_load)/(after(r_tangential_displacement) - before(r_tangential_displacement))
#line 163 "/work/main/tests/indenter/indenter_slip.pf"
  call assertRelativelyEqual(middle(r_tangential_stiffness), rise, tolerance=1.0e-6_dp, message=kinds(kind), &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 163) )
  if (anyExceptions()) return
#line 164 "/work/main/tests/indenter/indenter_slip.pf"
            ! W = 8 (int T du - T u/2)
            rise = 4*(middle(r_tangential_displacement) - tau*mu*middle(r_load)/middle(r_tangential_stiffness))
            associate (slope => (after(r_cycle_energy) - before(r_cycle_energy))/(2*step*mu*middle(r_load)))
#line 167 "/work/main/tests/indenter/indenter_slip.pf"
  call assertRelativelyEqual(-rise, slope, tolerance=1.0e-5_dp, message=kinds(kind), &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 167) )
  if (anyExceptions()) return
#line 168 "/work/main/tests/indenter/indenter_slip.pf"
            end associate
         end do
      end do
   end subroutine test_slopes

   ! A flat face sticks as a whole up to mu P; a contact within a face has the face at least.
   !@test
   subroutine test_faces()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: results(n_indenter_results)

      call new_named(model, values, 'flat', 'b=0.4')
      values(v_poisson_ratio) = 0
      call hold(values, v_load, 2.0_dp)
      call slip(model, values, 0.7_dp, results, 'flat')
#line 184 "/work/main/tests/indenter/indenter_slip.pf"
  call assertEqual(1.0_dp, results(r_stick_fraction), &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 184) )
  if (anyExceptions()) return
#line 185 "/work/main/tests/indenter/indenter_slip.pf"
#line 185 "/work/main/tests/indenter/indenter_slip.pf"
  call assertEqual(0.0_dp, results(r_cycle_energy), &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 185) )
  if (anyExceptions()) return
#line 186 "/work/main/tests/indenter/indenter_slip.pf"
      ! T = 2 G* b u
#line 187 "/work/main/tests/indenter/indenter_slip.pf"
  call assertRelativelyEqual(0.7_dp*mu*2/(2*0.4_dp), results(r_tangential_displacement), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 187) )
  if (anyExceptions()) return
#line 188 "/work/main/tests/indenter/indenter_slip.pf"
#line 188 "/work/main/tests/indenter/indenter_slip.pf"
  call assertRelativelyEqual(0.8_dp, results(r_tangential_stiffness), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 188) )
  if (anyExceptions()) return
#line 189 "/work/main/tests/indenter/indenter_slip.pf"
      call new_named(model, values, 'flat_cone', 'b=0.4;slope=0.3')
      values(v_poisson_ratio) = 0
      call hold(values, v_contact_radius, 0.5_dp)
      call slip(model, values, 1.0_dp, results, 'flat_cone')
#line 193 "/work/main/tests/indenter/indenter_slip.pf"
  call assertRelativelyEqual(0.64_dp, results(r_stick_fraction), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 193) )
  if (anyExceptions()) return
#line 194 "/work/main/tests/indenter/indenter_slip.pf"
#line 194 "/work/main/tests/indenter/indenter_slip.pf"
  call assertRelativelyEqual(mu*results(r_approach), results(r_tangential_displacement), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 194) )
  if (anyExceptions()) return
#line 195 "/work/main/tests/indenter/indenter_slip.pf"
   end subroutine test_faces

   ! Forces of the other sign, too large ones, and no load.
   !@test
   subroutine test_forces()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: results(n_indenter_results), mirrored(n_indenter_results), error_estimate
      integer :: status

      call new_named(model, values, 'cone', 'slope=0.3')
      values(v_poisson_ratio) = 0
      call hold(values, v_load, 1.0_dp)
      call slip(model, values, 0.3_dp, results, 'cone')
      call slip(model, values, -0.3_dp, mirrored, 'cone')
#line 210 "/work/main/tests/indenter/indenter_slip.pf"
  call assertEqual(-results(r_tangential_displacement), mirrored(r_tangential_displacement), &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 210) )
  if (anyExceptions()) return
#line 211 "/work/main/tests/indenter/indenter_slip.pf"
#line 211 "/work/main/tests/indenter/indenter_slip.pf"
  call assertEqual(results(r_cycle_energy), mirrored(r_cycle_energy), &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 211) )
  if (anyExceptions()) return
#line 212 "/work/main/tests/indenter/indenter_slip.pf"
      values([v_tangential_force, v_friction_coefficient]) = [1.001_dp*mu, mu]
      call solve_point(model, values, results, error_estimate, status)
#line 214 "/work/main/tests/indenter/indenter_slip.pf"
  call assertEqual(status_no_equilibrium, status, &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 214) )
  if (anyExceptions()) return
#line 215 "/work/main/tests/indenter/indenter_slip.pf"
#line 215 "/work/main/tests/indenter/indenter_slip.pf"
  call assertTrue(ieee_is_nan(results(r_approach)), &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 215) )
  if (anyExceptions()) return
#line 216 "/work/main/tests/indenter/indenter_slip.pf"
      call hold(values, v_load, 0.0_dp)
      values(v_tangential_force) = 0
      call solve_point(model, values, results, error_estimate, status)
#line 219 "/work/main/tests/indenter/indenter_slip.pf"
  call assertEqual(status_solved, status, &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 219) )
  if (anyExceptions()) return
#line 220 "/work/main/tests/indenter/indenter_slip.pf"
#line 220 "/work/main/tests/indenter/indenter_slip.pf"
  call assertTrue(ieee_is_nan(results(r_stick_fraction)), &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 220) )
  if (anyExceptions()) return
#line 221 "/work/main/tests/indenter/indenter_slip.pf"
   end subroutine test_forces

   !@test
   subroutine test_refusals()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)

      call new_named(model, values, 'cone', 'slope=0.3')
      call hold(values, v_load, 1.0_dp)
      values(v_tangential_force) = 0.1_dp
#line 231 "/work/main/tests/indenter/indenter_slip.pf"
  call assertTrue(index(find_problems(model, values), '&friction coefficient: is missing') > 0, &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 231) )
  if (anyExceptions()) return
#line 232 "/work/main/tests/indenter/indenter_slip.pf"
      values(v_friction_coefficient) = mu
#line 233 "/work/main/tests/indenter/indenter_slip.pf"
  call assertTrue(index(find_problems(model, values), '&solid poisson_ratio: is missing') > 0, &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 233) )
  if (anyExceptions()) return
#line 234 "/work/main/tests/indenter/indenter_slip.pf"
      values(v_poisson_ratio) = 0.3_dp
#line 235 "/work/main/tests/indenter/indenter_slip.pf"
  call assertEqual('', find_problems(model, values), &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 235) )
  if (anyExceptions()) return
#line 236 "/work/main/tests/indenter/indenter_slip.pf"
      values(v_tangential_force) = huge(mu)
#line 237 "/work/main/tests/indenter/indenter_slip.pf"
  call assertTrue(index(find_problems(model, values), '&operating tangential_force: is missing') > 0, &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 237) )
  if (anyExceptions()) return
#line 238 "/work/main/tests/indenter/indenter_slip.pf"
      values(v_tangential_force) = 0.1_dp
      values(v_work_of_adhesion) = 1.0e-3_dp
#line 240 "/work/main/tests/indenter/indenter_slip.pf"
  call assertTrue(index(find_problems(model, values), '&friction coefficient: stands beside &adhesion') > 0, &
 & location=SourceLocation( &
 & 'indenter_slip.pf', &
 & 240) )
  if (anyExceptions()) return
#line 241 "/work/main/tests/indenter/indenter_slip.pf"
   end subroutine test_refusals

end module indenter_slip

module Wrapindenter_slip
   use FUnit
   use indenter_slip
   implicit none
   private

contains


end module Wrapindenter_slip

function indenter_slip_suite() result(suite)
   use FUnit
   use indenter_slip
   use Wrapindenter_slip
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('indenter_slip_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_shapes', &
      test_shapes))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_powers', &
      test_powers))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_hertz', &
      test_hertz))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_slopes', &
      test_slopes))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_faces', &
      test_faces))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_forces', &
      test_forces))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_refusals', &
      test_refusals))
   call suite%addTest(t)


end function indenter_slip_suite

