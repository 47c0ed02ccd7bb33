! SPDX-License-Identifier: GPL-3.0-or-later
!> Is any strip wrong, and how fast is one found? See bench/README.md.
!>
!> random_strips [NUMBER [SEED [TABLE.csv]]]
program random_strips
   use, intrinsic :: iso_c_binding, only: c_int
   use adfric_base_kinds, only: dp
   use adfric_system_program_end, only: end_program
   use adfric_system_clock, only: wall_clock
   use adfric_foundation_balance, only: balance_t, get_balance
   use adfric_foundation_steady_state, only: find_steady_state
   use adfric_foundation_strip, only: strip_t, steady_state_t, regime_free, regime_saturated
   use measure, only: spread_t, spread_of, print_heading, integer_argument, text_argument, open_table
   use strip_judge, only: judge_steady_state, verdict_right, verdict_not_steady
   use random_dice, only: dice_t, new_dice
   use trial_strips, only: trial_t, draw_trial, make_strip, describe
   implicit none (type, external)

   !> Change of the penetration from a neighbour to the strip [h].
   real(dp), parameter :: neighbour = 1.0e-4_dp
   integer, parameter :: n_repeats = 5
   !> Largest relative mismatch of a balance, and largest relative change of a force by the starting value.
   real(dp), parameter :: largest_mismatch = 1.0e-10_dp, largest_disagreement = 1.0e-8_dp
   !> Below this share of the load the round-off of the load alone may be a mismatch of the friction.
   real(dp), parameter :: frictionless = 1.0e-5_dp
   character(*), parameter :: regimes(0:5) = [character(32) :: 'free', 'adhesion without contact', &
      'contact without adhesion', 'saturated adhesion', 'adhesion zones', 'saturated contact']

   !> A strip, cold and warm, and what is wrong with it.
   type :: case_t
      type(trial_t) :: trial
      type(strip_t) :: strip
      type(steady_state_t) :: neighbour, cold, warm
      integer :: verdict = verdict_right
      !> Relative mismatch of load and energy, and disagreement of cold and warm.
      real(dp) :: load_mismatch = 0, energy_mismatch = 0, disagreement = 0
      !> Fastest of the repeats [s].
      real(dp) :: cold_time = huge(1.0_dp), warm_time = huge(1.0_dp)
   end type case_t

   type(case_t), allocatable :: cases(:)
   type(spread_t) :: cold_spread, warm_spread
   integer :: n_broken

   call print_heading('Random strips')
   call draw_cases(integer_argument(1, 100000), integer_argument(2, 1), cases)
   call solve_all(cases, cold_spread, warm_spread)
   call judge_all(cases)
   call report(cases, n_broken)
   call print_times(cases, cold_spread, warm_spread)
   if (n_broken > 0) call end_program(1_c_int)

contains

   subroutine draw_cases(n, seed, cases)
      integer, intent(in) :: n, seed
      type(case_t), allocatable, intent(out) :: cases(:)
      type(dice_t) :: dice
      type(strip_t) :: strip
      integer :: k

      call new_dice(dice, seed)
      allocate (cases(n))
      do k = 1, n
         associate (c => cases(k))
            call draw_trial(dice, c%trial)
            call make_strip(c%trial, 0.0_dp, c%strip)
            call make_strip(c%trial, neighbour, strip)
            call find_steady_state(strip, c%trial%branch, c%neighbour)
         end associate
      end do
      print '(i0, a, i0)', n, ' strips, seed ', seed
   end subroutine draw_cases

   !> Solve cold and warm; means over all strips from whole passes, the slowest strip from its own times.
   subroutine solve_all(cases, cold, warm)
      type(case_t), intent(inout) :: cases(:)
      !> Mean time of a strip over the passes [s].
      type(spread_t), intent(out) :: cold, warm
      real(dp) :: cold_means(n_repeats), warm_means(n_repeats), start, middle, last
      integer :: k, r

      do r = 1, n_repeats
         start = wall_clock()
         do k = 1, size(cases)
            call find_steady_state(cases(k)%strip, cases(k)%trial%branch, cases(k)%cold)
         end do
         middle = wall_clock()
         do k = 1, size(cases)
            call find_steady_state(cases(k)%strip, cases(k)%trial%branch, cases(k)%warm, cases(k)%neighbour)
         end do
         last = wall_clock()
         cold_means(r) = (middle - start)/size(cases)
         warm_means(r) = (last - middle)/size(cases)
         do k = 1, size(cases)
            start = wall_clock()
            call find_steady_state(cases(k)%strip, cases(k)%trial%branch, cases(k)%cold)
            middle = wall_clock()
            call find_steady_state(cases(k)%strip, cases(k)%trial%branch, cases(k)%warm, cases(k)%neighbour)
            last = wall_clock()
            cases(k)%cold_time = min(cases(k)%cold_time, middle - start)
            cases(k)%warm_time = min(cases(k)%warm_time, last - middle)
         end do
      end do
      cold = spread_of(cold_means)
      warm = spread_of(warm_means)
   end subroutine solve_all

   !> Judge every strip by the brute-force time stepping and by its balances.
   subroutine judge_all(cases)
      type(case_t), intent(inout) :: cases(:)
      type(balance_t) :: cold, warm
      real(dp) :: energy
      integer :: k

      !$omp parallel do schedule(dynamic, 16) private(cold, warm, energy)
      do k = 1, size(cases)
         associate (c => cases(k))
            call get_balance(c%strip, c%cold, cold)
            call get_balance(c%strip, c%warm, warm)
            c%load_mismatch = ratio(cold%load_mismatch, cold%load_scale)
            energy = max(cold%friction_scale + cold%dissipation + abs(cold%edge_loss), frictionless*cold%load_scale)
            c%energy_mismatch = ratio(cold%friction - cold%dissipation - cold%edge_loss, energy)
            c%disagreement = max(ratio(warm%load - cold%load, cold%load_scale), &
               ratio(warm%friction - cold%friction, energy))
            c%verdict = judge_steady_state(c%strip, c%cold, c%trial%branch)
         end associate
      end do
      !$omp end parallel do
   end subroutine judge_all

   pure real(dp) function ratio(part, whole)
      real(dp), intent(in) :: part, whole

      ratio = abs(part)
      if (whole > 0) ratio = ratio/whole
   end function ratio

   !> What is wrong with a strip; nothing if the text is empty.
   pure function fault_of(c) result(fault)
      type(case_t), intent(in) :: c
      character(:), allocatable :: fault

      fault = ''
      if (.not. c%cold%is_converged) then
         fault = 'not converged'
      else if (c%cold%multiplier >= 1) then
         fault = 'unstable'
      else if (c%verdict /= verdict_right) then
         fault = 'not the first steady state of its branch'
         if (c%verdict == verdict_not_steady) fault = 'not steady'
      else if (.not. max(c%load_mismatch, c%energy_mismatch) <= largest_mismatch) then
         fault = 'balance violated'
      else if (.not. c%warm%is_converged .or. c%warm%regime /= c%cold%regime &
         .or. .not. c%disagreement <= largest_disagreement) then
         fault = 'depends on the starting value'
      end if
   end function fault_of

   !> Print what is broken, and a table by regime.
   subroutine report(cases, n_broken)
      type(case_t), intent(in) :: cases(:)
      integer, intent(out) :: n_broken
      character(:), allocatable :: fault
      integer :: k, regime, table

      n_broken = 0
      do k = 1, size(cases)
         fault = fault_of(cases(k))
         if (fault == '') cycle
         n_broken = n_broken + 1
         print '(a)', describe(cases(k)%trial, fault)
      end do

      table = open_table(text_argument(3, 'random_strips.csv'), 'regime,strips,not_converged,not_steady,not_first,'// &
         'load_mismatch,energy_mismatch,disagreement,cold_us,cold_worst_us,warm_us,warm_worst_us')
      print '(a32, a9, 3a8, 3a10, 4a10)', 'regime', 'strips', 'no conv', 'unstdy', 'notfirst', 'load', 'energy', &
         'cold-warm', 'cold us', 'worst', 'warm us', 'worst'
      do regime = regime_free, regime_saturated
         call report_regime(table, regimes(regime), pack(cases, cases%cold%regime == regime))
      end do
      call report_regime(table, 'all', cases)
      close (table)
   end subroutine report

   subroutine report_regime(table, name, cases)
      integer, intent(in) :: table
      character(*), intent(in) :: name
      type(case_t), intent(in) :: cases(:)
      integer :: counts(4)
      real(dp) :: worst(3), times(4)

      if (size(cases) == 0) return
      counts = [size(cases), count(.not. cases%cold%is_converged), count(cases%verdict == verdict_not_steady), &
         count(cases%verdict /= verdict_right .and. cases%verdict /= verdict_not_steady)]
      worst = [maxval(cases%load_mismatch), maxval(cases%energy_mismatch), maxval(cases%disagreement)]
      times = 1.0e6_dp*[sum(cases%cold_time)/size(cases), maxval(cases%cold_time), &
         sum(cases%warm_time)/size(cases), maxval(cases%warm_time)]
      print '(a32, i9, 3i8, 3es10.1, 4f10.2)', name, counts, worst, times
      write (table, '(a, 4(",", i0), 3(",", es9.2), 4(",", f0.3))') trim(name), counts, worst, times
   end subroutine report_regime

   subroutine print_times(cases, cold, warm)
      type(case_t), intent(in) :: cases(:)
      type(spread_t), intent(in) :: cold, warm

      print '(a, 3(f7.3, a))', 'mean of all strips, cold: ', 1.0e6_dp*cold%median, ' us (', 1.0e6_dp*cold%least, &
         ' to', 1.0e6_dp*cold%most, ')'
      print '(a, 3(f7.3, a))', 'mean of all strips, warm: ', 1.0e6_dp*warm%median, ' us (', 1.0e6_dp*warm%least, &
         ' to', 1.0e6_dp*warm%most, ')'
      print '(a)', describe(cases(maxloc(cases%cold_time, 1))%trial, 'none; slowest when cold')
      print '(a)', describe(cases(maxloc(cases%warm_time, 1))%trial, 'none; slowest when warm')
   end subroutine print_times

end program random_strips
