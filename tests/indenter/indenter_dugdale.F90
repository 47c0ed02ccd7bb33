! SPDX-License-Identifier: GPL-3.0-or-later
! Maugis's theory of every kind of indenter against tables of 13 digits and more.
module indenter_dugdale
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, two_pi
   use adfric_indenter_case, only: indenter_case_t, resolve_case
   use adfric_indenter_contact, only: contact_t, survey_t, find_contact, survey_curve
   use adfric_indenter_model, only: indenter_model_t
   use adfric_indenter_power_shape, only: depth_factor
   use adfric_indenter_profiles, only: gap_at
   use adfric_indenter_variables
   use adfric_model_status, only: status_solved, status_no_equilibrium
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   use indenter_cases, only: new_indenter, new_named, hold, n_kinds
   use model_calls, only: solve_point
   use reference_table, only: table_t, read_table, table_digits
   use adfric_sphere_model, only: sphere_model_t, new_sphere_model
   use adfric_sphere_variables, only: n_sphere_results, s_load => v_load, s_approach => v_approach, s_radius => v_radius, &
      & s_contact_radius => v_contact_radius, s_contact_modulus => v_contact_modulus, s_work_of_adhesion => v_work_of_adhesion, &
      & s_lambda => v_lambda, s_theory => v_theory, t_load => r_load, t_approach => r_approach, &
      & t_contact_radius => r_contact_radius, t_adhesion_radius => r_adhesion_radius, t_pull_off_load => r_pull_off_load
   use funit
   implicit none (type, external)

contains

   !> Solve a point that has to be solved.
   subroutine solve(model, values, results, label)
      type(indenter_model_t), intent(in) :: model
      real(dp), intent(in) :: values(:)
      real(dp), allocatable, intent(out) :: results(:)
      character(*), intent(in) :: label
      real(dp) :: error_estimate
      integer :: status

      allocate (results(n_indenter_results))
      call solve_point(model, values, results, error_estimate, status)
#line 38 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertEqual(status_solved, status, message=label, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 38) )
  if (anyExceptions()) return
#line 39 "/work/main/tests/indenter/indenter_dugdale.pf"
#line 39 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertEqual(theory_maugis_dugdale, nint(results(r_theory_used)), message=label, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 39) )
  if (anyExceptions()) return
#line 40 "/work/main/tests/indenter/indenter_dugdale.pf"
   end subroutine solve

   ! All kinds at given radius, contacts within a flat face, too; X = 0.7 is stress and work of adhesion together times 0.7.
   !@test
   subroutine test_shapes()
      type(table_t) :: table
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:), results(:)
      real(dp) :: profiles(3, 1, 2), size
      integer :: row

      call read_table(table, 'ind_md_shapes')
#line 52 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertEqual(40, table%n_rows, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 52) )
  if (anyExceptions()) return
#line 53 "/work/main/tests/indenter/indenter_dugdale.pf"
      do row = 1, table%n_rows
         call new_named(model, values, table%text(row, 'kind'), table%text(row, 'parameters'))
         associate (share => table%number(row, 'X'), a => table%number(row, 'a'), stress => table%number(row, 'sigma0'))
            values([v_work_of_adhesion, v_adhesion_stress]) = [0.01_dp, stress]*share
            call hold(values, v_contact_radius, a)
            values([v_profiles, v_n_r]) = [1, 3]
            values(v_r_max) = a
            call solve(model, values, results, table%label(row))
            size = abs(table%number(row, 'P')) + 4*stress*share*results(r_adhesion_radius)**2
#line 62 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertRelativelyEqual(table%number(row, 'c'), results(r_adhesion_radius), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 62) )
  if (anyExceptions()) return
#line 63 "/work/main/tests/indenter/indenter_dugdale.pf"
#line 63 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertEqual(table%number(row, 'P'), results(r_load), tolerance=size*table_digits, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 63) )
  if (anyExceptions()) return
#line 64 "/work/main/tests/indenter/indenter_dugdale.pf"
            size = abs(table%number(row, 'delta')) + 2*stress*share*results(r_adhesion_radius)
#line 65 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertEqual(table%number(row, 'delta'), results(r_approach), tolerance=size*table_digits, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 65) )
  if (anyExceptions()) return
#line 66 "/work/main/tests/indenter/indenter_dugdale.pf"
            if (table%text(row, 'p_0.5a') == '') cycle
            size = abs(table%number(row, 'p_0.5a')) + stress
            call model%solve_profiles(values, results, profiles)
#line 69 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertEqual(table%number(row, 'p_0.5a'), profiles(2, 1, p_pressure), tolerance=size*table_digits, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 69) )
  if (anyExceptions()) return
#line 70 "/work/main/tests/indenter/indenter_dugdale.pf"
         end associate
      end do
   end subroutine test_shapes

   ! Where g' never falls, states along a curve turn from unstable to stable once at most, and none has a load below the pull-off.
   !@test
   subroutine test_one_fold()
      character(*), parameter :: kinds(5) = [character(13) :: 'cone', 'paraboloid', 'power', 'polynomial', 'rounded_punch']
      character(*), parameter :: parameters(5) = [character(11) :: 'slope=0.3', 'R=1', 'n=4.5;C=0.3', 'C2=1;C6=0.1', 'b=0.9;R=1']
      real(dp), parameter :: works(3) = [1.0e-6_dp, 1.0e-2_dp, 1.0e2_dp], shares(4) = [1.0e-3_dp, 0.1_dp, 1.0_dp, 1.0e2_dp]
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: results(n_indenter_results), least, pull_off, error_estimate
      integer :: kind, i, j, k, status, n_turns
      logical :: is_stable, was_stable

      do kind = 1, size(kinds)
         do i = 1, size(works)
            do j = 1, size(shares)
               call new_named(model, values, trim(kinds(kind)), trim(parameters(kind)))
               values([v_work_of_adhesion, v_adhesion_stress]) = [works(i), shares(j)*sqrt(works(i))]
               n_turns = 0
               was_stable = .false.
               least = huge(least)
               pull_off = -huge(pull_off)
               do k = -80, 80
                  call hold(values, v_contact_radius, 10.0_dp**(0.05_dp*k))
                  call solve_point(model, values, results, error_estimate, status)
                  if (status /= status_solved) cycle
                  pull_off = results(r_pull_off_load)
                  is_stable = nint(results(r_stable)) == 1
                  if (is_stable .neqv. was_stable) n_turns = n_turns + 1
                  was_stable = is_stable
                  least = min(least, results(r_load))
               end do
#line 105 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertLessThanOrEqual(n_turns, 1, message=kinds(kind), &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 105) )
  if (anyExceptions()) return
#line 106 "/work/main/tests/indenter/indenter_dugdale.pf"
#line 106 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertTrue(was_stable, message=kinds(kind), &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 106) )
  if (anyExceptions()) return
#line 107 "/work/main/tests/indenter/indenter_dugdale.pf"
#line 107 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertLessThanOrEqual(pull_off, least + 1.0e-10_dp*abs(least), message=kinds(kind), &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 107) )
  if (anyExceptions()) return
#line 108 "/work/main/tests/indenter/indenter_dugdale.pf"
            end do
         end do
      end do
   end subroutine test_one_fold

   !> a0 of the reduced units of r^n, C = E* = w = 1: 2 pi a0 = (8/3) K^2 a0^(2n).
   real(dp) function length_of(n)
      real(dp), intent(in) :: n

      length_of = (0.75_dp*pi/depth_factor(n)**2)**(1/(2*n - 1))
   end function length_of

   !> r^n with C = E* = w = 1 and a lambda, its units of length, height and force.
   subroutine new_power(model, values, n, lambda, units)
      type(indenter_model_t), intent(out) :: model
      real(dp), allocatable, intent(out) :: values(:)
      real(dp), intent(in) :: n, lambda
      real(dp), intent(out) :: units(3)

      call new_indenter(model, values, kind_power)
      values([v_exponent, v_work_of_adhesion, v_lambda]) = [n, 1.0_dp, lambda]
      units(1) = length_of(n)
      units(2) = depth_factor(n)*units(1)**n
      units(3) = 2*n/(n + 1)*units(1)*units(2)
   end subroutine new_power

   ! States at given angle: radius by radius.
   !@test
   subroutine test_power_curve()
      type(table_t) :: table
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:), results(:)
      real(dp) :: units(3), a, size, slope
      integer :: row

      call read_table(table, 'ind_md_power_curve')
#line 144 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertEqual(54, table%n_rows, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 144) )
  if (anyExceptions()) return
#line 145 "/work/main/tests/indenter/indenter_dugdale.pf"
      do row = 1, table%n_rows
         a = table%number(row, 'a')
         call new_power(model, values, table%number(row, 'n'), table%number(row, 'lambda'), units)
         call hold(values, v_contact_radius, a*units(1))
         call solve(model, values, results, table%label(row))
         associate (n => table%number(row, 'n'), c => table%number(row, 'c'), lambda => table%number(row, 'lambda'))
#line 151 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertRelativelyEqual(c, results(r_adhesion_radius)/units(1), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 151) )
  if (anyExceptions()) return
#line 152 "/work/main/tests/indenter/indenter_dugdale.pf"
            size = abs(table%number(row, 'P')) + lambda*c**2 + a**(n + 1)
#line 153 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertEqual(table%number(row, 'P'), results(r_load)/units(3), tolerance=size*table_digits, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 153) )
  if (anyExceptions()) return
#line 154 "/work/main/tests/indenter/indenter_dugdale.pf"
            size = abs(table%number(row, 'delta')) + lambda*c + a**n
#line 155 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertEqual(table%number(row, 'delta'), results(r_approach)/units(2), tolerance=size*table_digits, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 155) )
  if (anyExceptions()) return
#line 156 "/work/main/tests/indenter/indenter_dugdale.pf"
            slope = table%number(row, 'dP_dtheta')/table%number(row, 'ddelta_dtheta')*units(3)/units(2)
#line 157 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertRelativelyEqual(slope, results(r_contact_stiffness), tolerance=1.0e-9_dp, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 157) )
  if (anyExceptions()) return
#line 158 "/work/main/tests/indenter/indenter_dugdale.pf"
         end associate
      end do
   end subroutine test_power_curve

   ! Pull-off in both controls, on a contact or a disc, and the state without load.
   !@test
   subroutine test_power_pull_off()
      type(table_t) :: table
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:), results(:)
      real(dp) :: units(3)
      integer :: row

      call read_table(table, 'ind_md_power_pulloff')
#line 172 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertEqual(30, table%n_rows, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 172) )
  if (anyExceptions()) return
#line 173 "/work/main/tests/indenter/indenter_dugdale.pf"
      do row = 1, table%n_rows
         call new_power(model, values, table%number(row, 'n'), table%number(row, 'lambda'), units)
         call hold(values, v_load, 0.0_dp)
         call solve(model, values, results, table%label(row))
         associate (expected => table%number(row, 'P_load'))
#line 178 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertRelativelyEqual(expected, results(r_pull_off_load)/units(3), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 178) )
  if (anyExceptions()) return
#line 179 "/work/main/tests/indenter/indenter_dugdale.pf"
         end associate
         associate (expected => table%number(row, 'a_P0'))
#line 181 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertRelativelyEqual(expected, results(r_contact_radius)/units(1), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 181) )
  if (anyExceptions()) return
#line 182 "/work/main/tests/indenter/indenter_dugdale.pf"
         end associate
         associate (expected => table%number(row, 'c_P0'))
#line 184 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertRelativelyEqual(expected, results(r_adhesion_radius)/units(1), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 184) )
  if (anyExceptions()) return
#line 185 "/work/main/tests/indenter/indenter_dugdale.pf"
         end associate
         call hold(values, v_approach, 0.0_dp)
         call solve(model, values, results, table%label(row))
         associate (expected => table%number(row, 'delta_disp'))
#line 189 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertRelativelyEqual(expected, results(r_pull_off_approach)/units(2), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 189) )
  if (anyExceptions()) return
#line 190 "/work/main/tests/indenter/indenter_dugdale.pf"
         end associate
#line 191 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertEqual(table%number(row, 'P_disp'), results(r_pull_off_load)/units(3), tolerance=1.0e-6_dp, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 191) )
  if (anyExceptions()) return
#line 192 "/work/main/tests/indenter/indenter_dugdale.pf"
         ! a hair above that approach the contact is where the table has it
         call hold(values, v_approach, results(r_pull_off_approach) + 1.0e-12_dp*units(2))
         call solve(model, values, results, table%label(row))
#line 195 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertEqual(table%number(row, 'a_disp'), results(r_contact_radius)/units(1), tolerance=1.0e-4_dp, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 195) )
  if (anyExceptions()) return
#line 196 "/work/main/tests/indenter/indenter_dugdale.pf"
      end do
   end subroutine test_power_pull_off

   ! A flat punch, from one that pulls as a whole to Kendall's.
   !@test
   subroutine test_flat_punch()
      type(table_t) :: table
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:), results(:)
      real(dp) :: stress
      integer :: row

      call read_table(table, 'ind_flat_punch_md')
#line 209 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertEqual(6, table%n_rows, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 209) )
  if (anyExceptions()) return
#line 210 "/work/main/tests/indenter/indenter_dugdale.pf"
      call new_indenter(model, values, kind_flat)
      do row = 1, table%n_rows
         stress = 0.01_dp
         values([v_work_of_adhesion, v_adhesion_stress]) = [4*stress**2/(pi*table%number(row, 'chi')), stress]
         call hold(values, v_load, 0.0_dp)
         call solve(model, values, results, table%label(row))
#line 216 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertRelativelyEqual(table%number(row, 'P')*pi*stress, results(r_pull_off_load), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 216) )
  if (anyExceptions()) return
#line 217 "/work/main/tests/indenter/indenter_dugdale.pf"
         associate (delta => table%number(row, 'delta_sigma_unit')*stress)
#line 218 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertRelativelyEqual(delta, results(r_pull_off_approach), tolerance=table_digits, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 218) )
  if (anyExceptions()) return
#line 219 "/work/main/tests/indenter/indenter_dugdale.pf"
         end associate
      end do
   end subroutine test_flat_punch

   ! The paraboloid is the sphere of the model `sphere`, by every theory and in every control.
   !@test
   subroutine test_same_as_sphere()
      type(indenter_model_t) :: model
      type(sphere_model_t) :: sphere
      real(dp), allocatable :: values(:), sphere_values(:)
      real(dp) :: results(n_indenter_results), expected(n_sphere_results), error_estimate, numbers(3), tolerance
      integer :: theory, k, control, status
      integer, parameter :: choices(2, 3) = reshape([choose_jkr, 3, choose_dmt, 4, choose_maugis_dugdale, 5], [2, 3])
      integer, parameter :: held(2, 3) = reshape([v_load, s_load, v_approach, s_approach, v_contact_radius, s_contact_radius], &
         & [2, 3])
      character(20) :: label

      call new_sphere_model(sphere)
      do theory = 1, 3
         do k = 1, 20
            do control = 1, 3
               write (label, '(3i4)') theory, k, control
               call new_indenter(model, values, kind_paraboloid)
               values([v_radius, v_contact_modulus, v_work_of_adhesion]) = [140.0e-9_dp, 44.0e9_dp, 0.19_dp]
               values(v_theory) = choices(1, theory)
               sphere_values = sphere%variables%default
               sphere_values([s_radius, s_contact_modulus, s_work_of_adhesion]) = values([v_radius, v_contact_modulus, &
                  & v_work_of_adhesion])
               sphere_values(s_theory) = choices(2, theory)
               if (theory == 3) values(v_lambda) = 10.0_dp**(k/4.0_dp - 2.5_dp)
               if (theory == 3) sphere_values(s_lambda) = values(v_lambda)
               numbers = [(k - 9)*1.0e-8_dp, (k - 3)*1.0e-10_dp, k*0.5e-9_dp]
               call hold(values, held(1, control), numbers(control))
               sphere_values(held(2, control)) = numbers(control)
               call solve_point(model, values, results, error_estimate, status)
               tolerance = 20*error_estimate
               call solve_point(sphere, sphere_values, expected, error_estimate, status)
               if (status /= status_solved) cycle
               ! the load of a fold of the approach is known like the place of the fold
               tolerance = max(tolerance, 20*error_estimate, table_digits)
               call compare(results(r_contact_radius), expected(t_contact_radius))
               call compare(results(r_load), expected(t_load))
               call compare(results(r_approach), expected(t_approach))
               call compare(results(r_pull_off_load), expected(t_pull_off_load))
               if (theory /= 2) call compare(results(r_adhesion_radius), expected(t_adhesion_radius))
            end do
         end do
      end do

   contains

      !> One result.
      subroutine compare(found, known)
         real(dp), intent(in) :: found, known

#line 274 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertEqual(known, found, tolerance=tolerance*abs(known), message=label, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 274) )
  if (anyExceptions()) return
#line 275 "/work/main/tests/indenter/indenter_dugdale.pf"
      end subroutine compare

   end subroutine test_same_as_sphere

   ! Towards a range of 0 every kind is that of JKR, in both controls: the differences fall like the range, or its root.
   !@test
   subroutine test_short_range()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:)
      real(dp) :: expected(n_indenter_results), results(n_indenter_results), error_estimate
      integer :: kind, control, status
      integer, parameter :: same(*) = [r_load, r_approach, r_contact_radius, r_pull_off_load, r_pull_off_approach]
      integer :: k
      character(20) :: label

      do kind = 1, n_kinds
         do control = 1, 2
            write (label, '(2i4)') kind, control
            call new_indenter(model, values, kind)
            values([v_work_of_adhesion, v_theory]) = [0.05_dp, real(choose_jkr, dp)]
            call hold(values, merge(v_load, v_approach, control == 1), 0.3_dp)
            call solve_point(model, values, expected, error_estimate, status)
#line 297 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertEqual(status_solved, status, message=label, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 297) )
  if (anyExceptions()) return
#line 298 "/work/main/tests/indenter/indenter_dugdale.pf"
            values([v_adhesion_stress, v_theory]) = [1.0e5_dp, real(choose_auto, dp)]
            call solve_point(model, values, results, error_estimate, status)
#line 300 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertEqual(status_solved, status, message=label, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 300) )
  if (anyExceptions()) return
#line 301 "/work/main/tests/indenter/indenter_dugdale.pf"
#line 301 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertEqual(theory_maugis_dugdale, nint(results(r_theory_used)), &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 301) )
  if (anyExceptions()) return
#line 302 "/work/main/tests/indenter/indenter_dugdale.pf"
            do k = 1, size(same)
#line 303 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertEqual(expected(same(k)), results(same(k)), tolerance=2.0e-5_dp, message=label, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 303) )
  if (anyExceptions()) return
#line 304 "/work/main/tests/indenter/indenter_dugdale.pf"
            end do
         end do
      end do
   end subroutine test_short_range

   ! The load does the work: E = U - pi a^2 w - sigma0 int (h0 - gap) 2 pi r dr (a < r < c), dE = P ddelta, for every kind at given
   ! approach, and the gap at c is the range of adhesion.
   !@test
   subroutine test_energy()
      type(indenter_model_t) :: model
      real(dp), allocatable :: values(:), first(:), last(:), inside(:)
      real(dp), parameter :: stresses(*) = [0.01_dp, 0.2_dp, 3.0_dp]
      real(dp), parameter :: low = 0.02_dp, width = 0.05_dp
      real(dp) :: done, energies(2)
      integer :: kind, k, node
      character(20) :: label

      do kind = kind_cone, n_kinds
         do k = 1, size(stresses)
            write (label, '(2i4)') kind, k
            call new_indenter(model, values, kind)
            values([v_work_of_adhesion, v_adhesion_stress]) = [0.01_dp, stresses(k)]
            if (kind == kind_sphere) values(v_radius) = 3
            ! where the zone passes the corner the load is not smooth
            if (kind == kind_rounded_cone) values(v_radius) = 5
            call hold(values, v_approach, low)
            call solve(model, values, first, label)
            energies(1) = energy_of(values, first)
            call hold(values, v_approach, low + width)
            call solve(model, values, last, label)
            energies(2) = energy_of(values, last)
            done = 0
            do node = 1, size(gauss_nodes)
               call hold(values, v_approach, low + width*(1 + gauss_nodes(node))/2)
               call solve(model, values, inside, label)
               done = done + gauss_weights(node)*inside(r_load)*width/2
            end do
#line 341 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertEqual(energies(2) - energies(1), done, tolerance=1.0e-11_dp, message=label, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 341) )
  if (anyExceptions()) return
#line 342 "/work/main/tests/indenter/indenter_dugdale.pf"
         end do
      end do
   end subroutine test_energy

   !> Energy of the solids and of adhesion. The slope of the gap has a root at a, and a logarithm at c.
   real(dp) function energy_of(values, results)
      real(dp), intent(in) :: values(:), results(:)
      integer, parameter :: n_panels = 6
      type(indenter_case_t) :: case
      type(survey_t) :: survey
      type(contact_t) :: contact
      real(dp) :: place, r, gap, lost, units(2)
      integer :: panel, node

      call resolve_case(values, case)
      call survey_curve(case%curve, case%control, survey)
      call find_contact(case%curve, survey, case%control, case%given, case%is_beyond, case%branch, contact)
      units = [case%length_unit, case%height_unit]
      associate (a => contact%spot%radius, c => contact%adhesion_radius)
         gap = gap_at(case%curve%shape, contact, c)*units(2)
#line 362 "/work/main/tests/indenter/indenter_dugdale.pf"
  call assertRelativelyEqual(values(v_work_of_adhesion)/values(v_adhesion_stress), gap, tolerance=1.0e-11_dp, &
 & location=SourceLocation( &
 & 'indenter_dugdale.pf', &
 & 362) )
  if (anyExceptions()) return
#line 363 "/work/main/tests/indenter/indenter_dugdale.pf"
         lost = 0
         do panel = 1, n_panels
            do node = 1, size(gauss_nodes)
               place = (panel - 0.5_dp + gauss_nodes(node)/2)/n_panels
               r = a + (c - a)*place**2*(3 - 2*place)
               gap = gap_at(case%curve%shape, contact, r)*units(2)
               lost = lost + gauss_weights(node)/2/n_panels*6*place*(1 - place)*(c - a)*2*pi*r*units(1)**2 &
                  & *(values(v_work_of_adhesion) - gap*values(v_adhesion_stress))
            end do
         end do
      end associate
      energy_of = results(r_elastic_energy) - values(v_work_of_adhesion)*results(r_contact_area) - lost
   end function energy_of

end module indenter_dugdale

module Wrapindenter_dugdale
   use FUnit
   use indenter_dugdale
   implicit none
   private

contains


end module Wrapindenter_dugdale

function indenter_dugdale_suite() result(suite)
   use FUnit
   use indenter_dugdale
   use Wrapindenter_dugdale
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('indenter_dugdale_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_shapes', &
      test_shapes))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_one_fold', &
      test_one_fold))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_power_curve', &
      test_power_curve))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_power_pull_off', &
      test_power_pull_off))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_flat_punch', &
      test_flat_punch))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_same_as_sphere', &
      test_same_as_sphere))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_short_range', &
      test_short_range))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_energy', &
      test_energy))
   call suite%addTest(t)


end function indenter_dugdale_suite

