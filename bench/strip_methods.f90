! SPDX-License-Identifier: GPL-3.0-or-later
!> Time and error of a strip by several methods, regime by regime. See bench/README.md.
!>
!> strip_methods [TABLE.csv]
program strip_methods
   use, intrinsic :: iso_c_binding, only: c_funptr
   use adfric_base_kinds, only: dp
   use adfric_system_clock, only: wall_clock
   use adfric_foundation_balance, only: balance_t, get_balance
   use adfric_foundation_steady_state, only: find_steady_state
   use adfric_foundation_strip, only: steady_state_t, regime_saturated
   use gsl_multiroot, only: solver_t, new_solver, free_solver, solve_edges, gsl_set_error_handler_off
   use measure, only: spread_t, spread_of, print_heading, text_argument, open_table
   use plain_edges, only: get_residuals
   use strip_cases, only: case_t, snap, names, elsewhere, from_lengths, from_rest, start_names, collect_cases, start_of, error_of, &
      error_of_edges, load_scale, friction_scale
   use time_stepping, only: stepping_forces
   implicit none (type, external)

   integer, parameter :: n_strips = 300, n_repeats = 9, n_calls = 50
   !> Steps that a regime is stepped in all, for the time of a run.
   integer, parameter :: steps_in_all = 20000000

   !> What a method did on the strips of a regime.
   type :: outcome_t
      type(spread_t) :: time, anchor, share
      integer :: n = 0, n_failed = 0, n_impossible = 0, n_elsewhere = 0
      real(dp) :: errors(n_strips) = 0
   end type outcome_t

   type(case_t) :: cases(n_strips)
   type(c_funptr) :: former_handler
   integer :: regime, table, start, k

   former_handler = gsl_set_error_handler_off()
   call print_heading('Methods for one strip')
   table = open_table(text_argument(1, 'strip_methods.csv'), 'regime,method,tolerance_or_steps,strips,failed,'// &
      'inadmissible,elsewhere,error_median,error_worst,us,us_least,us_most,equations_ns,evaluations')
   print '(a25, a17, a8, 4a8, 2a9, a10, a20, a8, a10)', 'regime', 'method', 'tol|n', 'strips', 'failed', 'inadm', 'elsewh', &
      'err med', 'err max', 'us', 'least .. most', 'eq. ns', 'ratio'
   do regime = 0, snap
      call collect_cases(regime, cases)
      call report(regime, 'cold', 0.0_dp, run_own(cases, .false.))
      call report(regime, 'warm', 0.0_dp, run_own(cases, .true.))
      if (regime /= 0 .and. regime /= regime_saturated) then
         do start = from_lengths, from_rest
            do k = 4, 12, 4
               call report(regime, 'gsl from '//trim(start_names(start)), 10.0_dp**(-k), run_gsl(cases, 10.0_dp**(-k), start))
            end do
         end do
      end if
      do k = 2, 6
         call report(regime, 'time march', 10.0_dp**k, run_stepping(cases, 10**k))
      end do
   end do
   close (table)

contains

   !> The project's solver; its error is what the balances leave over, or the difference from the cold answer.
   function run_own(cases, is_warm) result(outcome)
      type(case_t), intent(in) :: cases(:)
      logical, intent(in) :: is_warm
      type(outcome_t) :: outcome
      type(steady_state_t) :: state
      type(balance_t) :: balance
      real(dp) :: times(n_repeats), anchors(n_repeats), start
      integer :: r, k, call_number

      outcome%n = size(cases)
      do r = 1, n_repeats
         anchors(r) = time_of_equations(cases)
         start = wall_clock()
         do call_number = 1, n_calls
            do k = 1, size(cases)
               if (is_warm) then
                  call find_steady_state(cases(k)%strip, cases(k)%trial%branch, state, cases(k)%neighbour)
               else
                  call find_steady_state(cases(k)%strip, cases(k)%trial%branch, state)
               end if
            end do
         end do
         times(r) = (wall_clock() - start)/(size(cases)*n_calls)
      end do
      call set_times(times, anchors, outcome)
      do k = 1, size(cases)
         associate (c => cases(k))
            state = c%answer
            if (is_warm) call find_steady_state(c%strip, c%trial%branch, state, c%neighbour)
            call get_balance(c%strip, state, balance)
            outcome%errors(k) = max(abs(balance%load_mismatch)/load_scale(c), &
               abs(balance%friction - balance%dissipation - balance%edge_loss)/friction_scale(c))
            if (is_warm) call keep(error_of(c, balance%load, balance%friction), k, outcome)
            if (.not. state%is_converged) outcome%n_failed = outcome%n_failed + 1
         end associate
      end do
   end function run_own

   !> GSL's hybrid solver on the edge equations.
   function run_gsl(cases, tolerance, kind_of_start) result(outcome)
      type(case_t), intent(in) :: cases(:)
      real(dp), intent(in) :: tolerance
      integer, intent(in) :: kind_of_start
      type(outcome_t) :: outcome
      type(solver_t) :: solver
      real(dp) :: times(n_repeats), anchors(n_repeats), start, x(4), error
      logical :: is_converged, is_admissible
      integer :: r, k

      call new_solver(solver, cases(1)%edges%n)
      do r = 1, n_repeats
         anchors(r) = time_of_equations(cases)
         start = wall_clock()
         do k = 1, size(cases)
            associate (c => cases(k), n => cases(k)%edges%n)
               x(:n) = start_of(c, kind_of_start)
               call solve_edges(solver, c%edges, tolerance, x(:n), is_converged)
            end associate
         end do
         times(r) = (wall_clock() - start)/size(cases)
      end do
      call set_times(times, anchors, outcome)
      do k = 1, size(cases)
         associate (c => cases(k), n => cases(k)%edges%n)
            x(:n) = start_of(c, kind_of_start)
            call solve_edges(solver, c%edges, tolerance, x(:n), is_converged)
            call error_of_edges(c, x(:n), error, is_admissible)
            if (.not. is_converged) then
               outcome%n_failed = outcome%n_failed + 1
            else if (.not. is_admissible) then
               outcome%n_impossible = outcome%n_impossible + 1
            else
               outcome%n = outcome%n + 1
               call keep(error, outcome%n, outcome)
            end if
         end associate
      end do
      call free_solver(solver)
   end function run_gsl

   !> One period in steps of time, from the answer's own column: less than any time stepping from rest needs.
   function run_stepping(cases, steps) result(outcome)
      type(case_t), intent(in) :: cases(:)
      integer, intent(in) :: steps
      type(outcome_t) :: outcome
      real(dp) :: times(n_repeats), anchors(n_repeats), start, load, friction
      integer :: r, k, n

      n = max(10, min(size(cases), steps_in_all/(steps*n_repeats)))
      do r = 1, n_repeats
         anchors(r) = time_of_equations(cases)
         start = wall_clock()
         do k = 1, n
            call stepping_forces(cases(k)%strip, cases(k)%answer, steps, load, friction)
            if (r == 1) call keep(error_of(cases(k), load, friction), k, outcome)
         end do
         times(r) = (wall_clock() - start)/n
      end do
      outcome%n = n
      call set_times(times, anchors, outcome)
   end function run_stepping

   !> Time of one evaluation of the edge equations [s].
   real(dp) function time_of_equations(cases) result(time)
      type(case_t), intent(in) :: cases(:)
      real(dp) :: x(4), residuals(4), total, start
      integer :: k, call_number

      total = 0
      start = wall_clock()
      do call_number = 1, n_calls
         do k = 1, size(cases)
            associate (n => cases(k)%edges%n)
               x = call_number*1.0e-3_dp + cases(k)%answer%half_width
               x(3:) = x(3:) + cases(k)%answer%trailing
               call get_residuals(cases(k)%edges, x(:n), residuals(:n))
               total = total + residuals(n)
            end associate
         end do
      end do
      time = (wall_clock() - start)/(size(cases)*n_calls)
      ! so that no compiler leaves the sum out
      if (.not. abs(total) >= 0) time = -1
   end function time_of_equations

   subroutine set_times(times, anchors, outcome)
      real(dp), intent(in) :: times(:), anchors(:)
      type(outcome_t), intent(inout) :: outcome

      outcome%time = spread_of(1.0e6_dp*times)
      outcome%anchor = spread_of(1.0e9_dp*anchors)
      outcome%share = spread_of(times/anchors)
   end subroutine set_times

   !> Note an error; a large one is another answer.
   subroutine keep(error, position, outcome)
      real(dp), intent(in) :: error
      integer, intent(in) :: position
      type(outcome_t), intent(inout) :: outcome

      outcome%errors(position) = error
      if (.not. error < elsewhere) outcome%n_elsewhere = outcome%n_elsewhere + 1
   end subroutine keep

   subroutine report(regime, method, setting, outcome)
      integer, intent(in) :: regime
      character(*), intent(in) :: method
      real(dp), intent(in) :: setting
      type(outcome_t), intent(in) :: outcome
      type(spread_t) :: error
      integer :: n

      n = outcome%n
      if (index(method, 'gsl') == 1) n = n + outcome%n_failed + outcome%n_impossible
      error = spread_of(outcome%errors(:outcome%n))
      print '(a25, a17, es8.0, 4i8, 2es9.1, 3f10.3, f8.1, f10.1)', names(regime), method, setting, n, outcome%n_failed, &
         outcome%n_impossible, outcome%n_elsewhere, error%median, error%most, outcome%time%median, outcome%time%least, &
         outcome%time%most, outcome%anchor%median, outcome%share%median
      write (table, '(2(a, ","), es7.1, 4(",", i0), 2(",", es8.2), 5(",", g0.5))') trim(names(regime)), method, setting, n, &
         outcome%n_failed, outcome%n_impossible, outcome%n_elsewhere, error%median, error%most, outcome%time%median, &
         outcome%time%least, outcome%time%most, outcome%anchor%median, outcome%share%median
   end subroutine report

end program strip_methods
