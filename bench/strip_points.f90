! SPDX-License-Identifier: GPL-3.0-or-later
!> Random strips for another program to solve, and what its answers are worth. See bench/README.md.
!>
!> strip_points write STRIPS.csv
!> strip_points judge FOUND.csv TABLE.csv
!>
!> STRIPS.csv has the numbers of the edge equations (`plain_edges`), the starts, and our time for each strip, cold. FOUND.csv
!> has one line for a strip and method: regime, strip, method, tolerance, 1 if the method says it is solved, its time [us], its
!> edges.
program strip_points
   use adfric_base_kinds, only: dp
   use adfric_system_clock, only: wall_clock
   use adfric_foundation_steady_state, only: find_steady_state
   use adfric_foundation_strip, only: steady_state_t, regime_saturated
   use measure, only: spread_t, spread_of, print_heading, text_argument, open_table
   use strip_cases, only: case_t, snap, names, elsewhere, from_rest, collect_cases, start_of, error_of_edges
   implicit none (type, external)

   integer, parameter :: n_strips = 300, n_repeats = 9, n_calls = 50

   !> What one method did on the strips of one regime.
   type :: outcome_t
      integer :: regime = 0
      character(24) :: method = ''
      real(dp) :: tolerance = 0
      integer :: n = 0, n_failed = 0, n_impossible = 0, n_elsewhere = 0, n_errors = 0
      real(dp) :: times(n_strips) = 0, errors(n_strips) = 0
   end type outcome_t

   type(case_t) :: cases(n_strips, 0:snap)
   real(dp) :: our_time(0:snap)
   integer :: regime

   do regime = 1, snap
      if (regime == regime_saturated) cycle
      call collect_cases(regime, cases(:, regime))
      our_time(regime) = time_of(cases(:, regime))
   end do
   select case (text_argument(1, ''))
   case ('write')
      call write_strips(text_argument(2, 'strip_points.csv'))
   case ('judge')
      call judge_found(text_argument(2, 'strip_found.csv'), text_argument(3, 'strip_scipy.csv'))
   case default
      error stop 'usage: strip_points write STRIPS.csv | judge FOUND.csv TABLE.csv'
   end select

contains

   !> Median time of a strip, cold [us].
   real(dp) function time_of(cases) result(time)
      type(case_t), intent(in) :: cases(:)
      type(steady_state_t) :: state
      type(spread_t) :: spread
      real(dp) :: times(n_repeats), start
      integer :: r, k, call_number

      do r = 1, n_repeats
         start = wall_clock()
         do call_number = 1, n_calls
            do k = 1, size(cases)
               call find_steady_state(cases(k)%strip, cases(k)%trial%branch, state)
            end do
         end do
         times(r) = 1.0e6_dp*(wall_clock() - start)/(size(cases)*n_calls)
      end do
      spread = spread_of(times)
      time = spread%median
   end function time_of

   subroutine write_strips(path)
      character(*), intent(in) :: path
      real(dp) :: x(4, from_rest)
      integer :: table, regime, k, start

      table = open_table(path, 'regime,strip,u,v,storage,loss,mean,stress,range,jump,entry,our_us,n,'// &
         'lengths1,lengths2,lengths3,lengths4,phases1,phases2,phases3,phases4,rest1,rest2,rest3,rest4')
      do regime = 1, snap
         if (regime == regime_saturated) cycle
         do k = 1, n_strips
            associate (c => cases(k, regime), s => cases(k, regime)%strip, n => cases(k, regime)%edges%n)
               x = 0
               do start = 1, from_rest
                  x(:n, start) = start_of(c, start)
               end do
               write (table, '(i0, ",", i0, 9(",", es24.16e3), ",", f0.4, ",", i0, 12(",", es24.16e3))') regime, k, &
                  s%foundation%u, s%foundation%v, s%foundation%storage, s%foundation%loss, s%mean, &
                  s%adhesion%stress, s%adhesion%range, s%adhesion%jump, c%edges%entry, our_time(regime), n, x
            end associate
         end do
      end do
      close (table)
   end subroutine write_strips

   !> Read what was found, and count.
   subroutine judge_found(path, table_path)
      character(*), intent(in) :: path, table_path
      type(outcome_t) :: outcome
      character(24) :: method
      real(dp) :: tolerance, time, x(4)
      integer :: found, table, status, regime, k, is_solved

      call print_heading('The edge equations in SciPy')
      table = open_table(table_path, 'regime,method,tolerance,strips,failed,inadmissible,elsewhere,error_median,error_worst,'// &
         'us,us_least,us_most,our_us')
      print '(a25, a14, a8, 4a8, 2a9, a10, a22, a9)', 'regime', 'from', 'tol', 'strips', 'failed', 'inadm', 'elsewh', &
         'err med', 'err max', 'us', 'least .. most', 'ours us'
      open (newunit=found, file=path, action='read', status='old')
      do
         read (found, *, iostat=status) regime, k, method, tolerance, is_solved, time, x
         if (status /= 0) exit
         if (regime /= outcome%regime .or. method /= outcome%method .or. abs(tolerance - outcome%tolerance) > 0) then
            if (outcome%n > 0) call report(table, outcome)
            outcome = outcome_t(regime, method, tolerance)
         end if
         call count_found(cases(k, regime), is_solved > 0, time, x(:cases(k, regime)%edges%n), outcome)
      end do
      if (outcome%n > 0) call report(table, outcome)
      close (found)
      close (table)
   end subroutine judge_found

   subroutine count_found(c, is_solved, time, x, outcome)
      type(case_t), intent(in) :: c
      logical, intent(in) :: is_solved
      real(dp), intent(in) :: time, x(:)
      type(outcome_t), intent(inout) :: outcome
      real(dp) :: error
      logical :: is_admissible

      outcome%n = outcome%n + 1
      outcome%times(outcome%n) = time
      if (.not. is_solved) then
         outcome%n_failed = outcome%n_failed + 1
         return
      end if
      call error_of_edges(c, x, error, is_admissible)
      if (.not. is_admissible) then
         outcome%n_impossible = outcome%n_impossible + 1
         return
      end if
      outcome%n_errors = outcome%n_errors + 1
      outcome%errors(outcome%n_errors) = error
      if (.not. error < elsewhere) outcome%n_elsewhere = outcome%n_elsewhere + 1
   end subroutine count_found

   subroutine report(table, outcome)
      integer, intent(in) :: table
      type(outcome_t), intent(in) :: outcome
      type(spread_t) :: error, time

      error = spread_of(outcome%errors(:outcome%n_errors))
      time = spread_of(outcome%times(:outcome%n))
      associate (o => outcome)
         print '(a25, a14, es8.0, 4i8, 2es9.1, 3f10.1, f9.2)', names(o%regime), o%method, o%tolerance, o%n, o%n_failed, &
            o%n_impossible, o%n_elsewhere, error%median, error%most, time%median, time%least, time%most, our_time(o%regime)
         write (table, '(a, ",scipy from ", a, ",", es7.1, 4(",", i0), 2(",", es8.2), 4(",", g0.5))') trim(names(o%regime)), &
            trim(o%method), o%tolerance, o%n, o%n_failed, o%n_impossible, o%n_elsewhere, error%median, error%most, time%median, &
            time%least, time%most, our_time(o%regime)
      end associate
   end subroutine report

end program strip_points
