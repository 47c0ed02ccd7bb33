! SPDX-License-Identifier: GPL-3.0-or-later
!> A sphere on a plane: time of a contact, error against quadruple precision, and the limit theories. See bench/README.md.
!>
!> sphere [FOLDER [points]]
program sphere
   use, intrinsic :: iso_fortran_env, only: output_unit
   use adfric_base_kinds, only: dp
   use adfric_describe_status, only: status_solved
   use adfric_round_sphere_contact, only: sphere_contact_t, find_contact, theory_maugis_dugdale, control_load, control_approach, &
      control_radius, branch_stable
   use adfric_round_sphere_maugis_dugdale, only: maugis_t
   use adfric_round_sphere_model, only: sphere_model_t, new_sphere_model
   use adfric_round_sphere_variables, only: choose_auto, n_sphere_results, n_sphere_variables, units_reduced, &
      & in => sphere_input, out => sphere_output
   use adfric_system_clock, only: wall_clock
   use measure, only: spread_t, spread_of, print_heading, text_argument, open_table
   use plain_dugdale, only: solve_plain
   use quad_dugdale, only: state_t, of_radius, of_load, of_approach, pull_off_of_load, pull_off_of_approach, &
      touching_approach, relative
   use sphere_limits, only: report_limits
   use sphere_points, only: write_points
   use sphere_timing, only: time_theory, time_pull_off, even, logarithmic, shuffle
   implicit none (type, external)

   integer, parameter :: n_repeats = 7, n_curve = 1000000, n_times = 10000, n_errors = 60, n_auto = 2000
   !> Decades of lambda, and those of everyday.
   integer, parameter :: decades = 12, usual_decades = 6
   !> More than this is wrong.
   real(dp), parameter :: worst_error = 1.0e-11_dp
   !> What the choice of a theory and the solution may add to the proved error by round-off.
   real(dp), parameter :: round_off = 1.0e-14_dp

   !> Largest errors: load and approach of a radius, radius of a load and of an approach, load and approach of pull-off.
   type :: errors_t
      real(dp) :: load = 0, approach = 0, radius_of_load = 0, radius_of_approach = 0, pull_off_load = 0, &
         pull_off_approach = 0
   end type errors_t

   character(:), allocatable :: folder
   integer :: n_wrong, n_unsolved, n_broken

   folder = text_argument(1, '.')
   n_wrong = 0
   if (text_argument(2, 'all') == 'points') then
      call write_points(folder//'/sphere_points.csv', usual_decades, n_repeats, n_unsolved)
      call judge(n_unsolved == 0, 'points: not converged')
   else
      call print_heading('Sphere on a plane')
      call report_curve(folder)
      call report_times(folder)
      call report_errors(folder)
      call report_limits(folder//'/sphere_theories.csv', usual_decades, n_broken)
      call judge(n_broken == 0, 'theories: a bound is broken')
      call report_auto(folder)
   end if
   if (n_wrong > 0) then
      flush (output_unit)
      error stop 'sphere: something is wrong'
   end if

contains

   !> A million radii at lambda = 0.8: in the model's blocks, as the program solves them, and the theory alone.
   subroutine report_curve(folder)
      character(*), intent(in) :: folder
      integer, parameter :: block = 250
      type(sphere_model_t) :: model
      real(dp) :: counts(1)
      real(dp), allocatable :: values(:, :), results(:, :), radii(:)
      real(dp) :: error_estimate(block), start, times(n_repeats)
      integer :: status(block), table, r, first, choice, n_failed

      table = open_table(folder//'/sphere_curve.csv', 'what,points,seconds,seconds_least,seconds_most')
      print '(/, a)', 'a million radii at lambda = 0.8, from 1e-6 to 3 in even steps: seconds'
      radii = even(1.0e-6_dp, 3.0_dp, n_curve)
      call time_theory(0.8_dp, control_radius, radii, .true., times, n_failed)
      call judge(n_failed == 0, 'times: not converged')
      call report_seconds(table, 'theory alone', times)
      call new_sphere_model(model)
      allocate (values(n_sphere_variables, block), results(n_sphere_results, block))
      do choice = theory_maugis_dugdale + 2, choose_auto, choose_auto - theory_maugis_dugdale - 2
         values = spread(case_values(0.8_dp), 2, block)
         values(in%theory, :) = choice
         do r = 1, n_repeats
            times(r) = 0
            do first = 1, n_curve, block
               values(in%contact_radius, :) = radii(first:first + block - 1)
               start = wall_clock()
               call model%solve_block(values, results, error_estimate, status, counts)
               times(r) = times(r) + (wall_clock() - start)
               call judge(all(status == status_solved), 'curve: unsolved')
            end do
         end do
         times = times*1.0e6_dp/n_curve
         call report_seconds(table, merge('model auto          ', 'model maugis_dugdale', choice == choose_auto), times)
      end do
      close (table)
   end subroutine report_curve

   !> The seconds of a million points.
   subroutine report_seconds(table, what, times)
      integer, intent(in) :: table
      character(*), intent(in) :: what
      !> [us/point]
      real(dp), intent(in) :: times(:)
      type(spread_t) :: t

      t = spread_of(times*n_curve*1.0e-6_dp)
      print '(a24, f8.3, a, f5.3, a, f5.3, a)', what, t%median, ' (', t%least, ' to ', t%most, ')'
      write (table, '(a, ",", i0, 3(",", f0.4))') trim(what), n_curve, t%median, t%least, t%most
      flush (output_unit)
   end subroutine report_seconds

   !> The variables of the model in reduced units.
   function case_values(lambda) result(values)
      real(dp), intent(in) :: lambda
      real(dp) :: values(n_sphere_variables)
      type(sphere_model_t) :: model
      integer :: k

      call new_sphere_model(model)
      values = [(model%variables(k)%default, k=1, n_sphere_variables)]
      values(in%units) = units_reduced
      values(in%lambda) = lambda
   end function case_values

   !> Times against lambda: radius, load and approach held, and pull-off.
   subroutine report_times(folder)
      character(*), intent(in) :: folder
      character(9), parameter :: names(3) = ['load     ', 'approach ', 'radius   ']
      real(dp) :: lambda, prescribed(n_times), shuffled(n_times), low(3), times(n_repeats)
      type(maugis_t) :: theory
      type(sphere_contact_t) :: fold
      integer :: table, k, control, n_failed

      table = open_table(folder//'/sphere_times.csv', 'lambda,held,order,us,us_least,us_most')
      print '(/, a)', 'us per contact; held from where it ends + 0.001 up to + 10 (radius: 0.001 to 3), even steps'
      print '(a8, 11a10)', 'lambda', 'load', 'shuffled', 'cold', 'below-3/2', 'approach', 'shuffled', 'cold', 'radius', &
         'shuffled', 'P_c', 'd_c'
      do k = -usual_decades, usual_decades
         lambda = 10.0_dp**k
         theory%lambda = lambda
         call theory%pull_off(control_load, fold)
         low(control_load) = fold%load + 1.0e-3_dp
         call theory%pull_off(control_approach, fold)
         low(control_approach) = max(fold%approach, touching_approach(lambda)) + 1.0e-3_dp
         low(control_radius) = 1.0e-3_dp
         write (output_unit, '(es8.1)', advance='no') lambda
         do control = 1, 3
            prescribed = even(low(control), merge(3.0_dp, low(control) + 10, control == control_radius), n_times)
            shuffled = shuffle(prescribed)
            call time_theory(lambda, control, prescribed, .true., times, n_failed)
            call judge(n_failed == 0, 'times: not converged')
            call report_time(table, lambda, trim(names(control)), 'swept', times)
            call time_theory(lambda, control, shuffled, .true., times, n_failed)
            call judge(n_failed == 0, 'times: not converged')
            call report_time(table, lambda, trim(names(control)), 'shuffled', times)
            if (control == control_radius) cycle
            call time_theory(lambda, control, shuffled, .false., times, n_failed)
            call judge(n_failed == 0, 'times: not converged')
            call report_time(table, lambda, trim(names(control)), 'cold', times)
            if (control == control_approach) cycle
            if (low(control) < -1.51_dp) then
               call time_theory(lambda, control, even(low(control), -1.501_dp, n_times), .true., times, n_failed)
               call judge(n_failed == 0, 'times: not converged')
               call report_time(table, lambda, 'load below -3/2', 'swept', times)
            else
               write (output_unit, '(a10)', advance='no') '-'
            end if
         end do
         do control = control_load, control_approach
            call time_pull_off(lambda, control, times, n_failed)
            call judge(n_failed == 0, 'times: not converged')
            call report_time(table, lambda, 'pull-off of '//trim(names(control)), '', times)
         end do
         print *
      end do
      close (table)
   end subroutine report_times

   !> A time in a row of the table on the screen, and in the file.
   subroutine report_time(table, lambda, what, order, times)
      integer, intent(in) :: table
      real(dp), intent(in) :: lambda, times(:)
      character(*), intent(in) :: what, order
      type(spread_t) :: t

      t = spread_of(times)
      write (output_unit, '(f10.3)', advance='no') t%median
      write (table, '(es8.1, 2(",", a), 3(",", f0.4))') lambda, what, order, t%median, t%least, t%most
   end subroutine report_time

   !> Error against lambda: the theory, and the textbook's form.
   subroutine report_errors(folder)
      character(*), intent(in) :: folder
      type(errors_t) :: e
      type(spread_t) :: t
      real(dp) :: lambda, plain_load, plain_approach
      integer :: table, k, n_failed

      table = open_table(folder//'/sphere_errors.csv', 'lambda,load_of_radius,approach_of_radius,radius_of_load,'// &
         'radius_of_approach,pull_off_load,pull_off_approach,plain_load,plain_approach,plain_failed,points,plain_us')
      print '(/, a)', 'largest error; radius 0.01 to 100, load and approach 0.01 to 1e6 above their least; plain: Newton in m'
      print '(a8, 8a9, a8, a9)', 'lambda', 'P(a)', 'd(a)', 'a(P)', 'a(d)', 'P_c', 'd_c', 'plain P', 'plain d', 'failed', &
         'plain us'
      do k = -decades, decades
         lambda = 10.0_dp**k
         call get_errors(lambda, e)
         call judge(max(e%load, e%approach, e%radius_of_load, e%radius_of_approach, e%pull_off_load, e%pull_off_approach) &
            < worst_error, 'errors: too large')
         call try_plain(lambda, plain_load, plain_approach, n_failed, t)
         print '(es8.1, 8es9.1, i8, f9.3)', lambda, e, plain_load, plain_approach, n_failed, t%median
         write (table, '(es8.1, 8(",", es9.2), 2(",", i0), ",", f0.4)') lambda, e, plain_load, plain_approach, n_failed, &
            n_errors, t%median
      end do
      close (table)
      flush (output_unit)
   end subroutine report_errors

   !> Largest errors at a lambda.
   subroutine get_errors(lambda, e)
      real(dp), intent(in) :: lambda
      type(errors_t), intent(out) :: e
      type(maugis_t) :: theory
      type(sphere_contact_t) :: contact, fold
      type(state_t) :: truth
      real(dp), dimension(n_errors) :: radii, excess
      real(dp) :: least
      integer :: k

      theory%lambda = lambda
      radii = logarithmic(-2.0_dp, 2.0_dp, n_errors)
      excess = logarithmic(-2.0_dp, 6.0_dp, n_errors)
      call theory%pull_off(control_load, fold)
      truth = pull_off_of_load(lambda)
      e%pull_off_load = relative(fold%load, truth%value(2))
      least = fold%load
      call theory%pull_off(control_approach, fold)
      truth = pull_off_of_approach(lambda)
      e%pull_off_approach = relative(fold%approach, truth%value(3))
      do k = 1, n_errors
         call find_contact(theory, control_radius, radii(k), branch_stable, contact)
         truth = of_radius(lambda, radii(k))
         e%load = max(e%load, relative(contact%load, truth%value(2)))
         e%approach = max(e%approach, relative(contact%approach, truth%value(3)))
         call find_contact(theory, control_load, least + excess(k), branch_stable, contact)
         truth = of_load(lambda, least + excess(k))
         e%radius_of_load = max(e%radius_of_load, relative(contact%radius, truth%value(1)))
         ! from where there is contact
         associate (approach => max(fold%approach, touching_approach(lambda)) + excess(k))
            call find_contact(theory, control_approach, approach, branch_stable, contact)
            truth = of_approach(lambda, approach)
            e%radius_of_approach = max(e%radius_of_approach, relative(contact%radius, truth%value(1)))
         end associate
      end do
   end subroutine get_errors

   !> Largest errors of the textbook's form, the points it does not solve, and its time [us].
   subroutine try_plain(lambda, load_error, approach_error, n_failed, time)
      real(dp), intent(in) :: lambda
      real(dp), intent(out) :: load_error, approach_error
      integer, intent(out) :: n_failed
      type(spread_t), intent(out) :: time
      type(state_t) :: truth
      real(dp) :: radii(n_errors), load, approach, start, times(n_repeats), unused
      logical :: is_converged
      integer :: r, k, n

      radii = logarithmic(-2.0_dp, 2.0_dp, n_errors)
      load_error = 0
      approach_error = 0
      n_failed = 0
      do k = 1, n_errors
         call solve_plain(lambda, radii(k), load, approach, is_converged)
         if (.not. is_converged) then
            n_failed = n_failed + 1
            cycle
         end if
         truth = of_radius(lambda, radii(k))
         load_error = max(load_error, relative(load, truth%value(2)))
         approach_error = max(approach_error, relative(approach, truth%value(3)))
      end do
      unused = 0
      n = 20
      do r = 1, n_repeats
         start = wall_clock()
         do k = 1, n*n_errors
            call solve_plain(lambda, radii(1 + mod(k, n_errors)), load, approach, is_converged)
            unused = unused + load
         end do
         times(r) = 1.0e6_dp*(wall_clock() - start)/(n*n_errors)
      end do
      if (unused > huge(unused)) print '(a)', 'endless'
      time = spread_of(times)
   end subroutine try_plain

   !> A map of loads and lambdas by `auto`: its time, how often a limit theory will do, and how wrong it is.
   subroutine report_auto(folder)
      character(*), intent(in) :: folder
      type(sphere_model_t) :: model
      real(dp) :: counts(1)
      type(spread_t) :: t
      real(dp), allocatable :: values(:, :), results(:, :)
      real(dp) :: loads(n_auto), error_estimate(n_auto), times(n_repeats), start, share, worst, tolerance
      integer :: status(n_auto), table, k, r, decade

      table = open_table(folder//'/sphere_auto.csv', 'tolerance,share_of_limit_theories,us,us_least,us_most,largest_error')
      print '(/, a)', 'auto: load -1.4 + (0.01 to 1e4), lambda 1e-6 to 1e6, 2000 loads at each of 13 lambdas'
      print '(a9, a8, a8, 19x, a10)', 'tolerance', 'share', 'us', 'error'
      call new_sphere_model(model)
      allocate (values(n_sphere_variables, n_auto), results(n_sphere_results, n_auto))
      loads = -1.4_dp + logarithmic(-2.0_dp, 4.0_dp, n_auto)
      do k = 1, 8
         tolerance = 10.0_dp**(-2*k)
         times = 0
         share = 0
         worst = 0
         do decade = -usual_decades, usual_decades
            values = spread(case_values(10.0_dp**decade), 2, n_auto)
            values(in%load, :) = loads
            values(in%relative_tolerance, :) = max(tolerance, 1.0e-15_dp)
            ! last: what auto is compared with in time
            if (k == 8) values(in%theory, :) = theory_maugis_dugdale + 2
            do r = 1, n_repeats
               start = wall_clock()
               call model%solve_block(values, results, error_estimate, status, counts)
               times(r) = times(r) + (wall_clock() - start)
            end do
            call judge(all(status == status_solved), 'auto: unsolved')
            share = share + count(nint(results(out%theory_used, :)) /= theory_maugis_dugdale)
            worst = max(worst, worst_of(10.0_dp**decade, results))
         end do
         share = share/(n_auto*(2*usual_decades + 1))
         if (k < 8) call judge(worst <= tolerance + round_off, 'auto: not within its tolerance')
         t = spread_of(1.0e6_dp*times/(n_auto*(2*usual_decades + 1)))
         if (k == 8) tolerance = 0
         print '(es9.0, f8.3, f8.3, a, f5.3, a, f5.3, a, es10.1)', tolerance, share, t%median, ' (', t%least, ' to ', t%most, &
            ') ', worst
         write (table, '(es7.0, ",", f0.4, 3(",", f0.4), ",", es9.2)') tolerance, share, t%median, t%least, t%most, worst
      end do
      print '(a)', 'tolerance 0: maugis_dugdale asked for'
      close (table)
   end subroutine report_auto

   !> The largest error of radius and approach among some of the results of a limit theory; round-off is let pass.
   real(dp) function worst_of(lambda, results) result(worst)
      real(dp), intent(in) :: lambda, results(:, :)
      type(state_t) :: truth
      integer :: k

      worst = 0
      do k = 1, size(results, 2), 20
         if (nint(results(out%theory_used, k)) == theory_maugis_dugdale) cycle
         truth = of_load(lambda, results(out%load, k))
         worst = max(worst, real(abs(results(out%contact_radius, k)/truth%value(1) - 1), dp), &
            relative(results(out%approach, k), truth%value(3)))
      end do
   end function worst_of

   !> Note what is wrong.
   subroutine judge(is_right, complaint)
      logical, intent(in) :: is_right
      character(*), intent(in) :: complaint

      if (is_right) return
      n_wrong = n_wrong + 1
      if (n_wrong <= 20) print '(a)', 'WRONG: '//complaint
   end subroutine judge

end program sphere
