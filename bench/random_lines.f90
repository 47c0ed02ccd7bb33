! SPDX-License-Identifier: GPL-3.0-or-later
!> Is any sum of waves with a spectrum of relaxation times wrong? See bench/README.md.
!>
!> random_lines [NUMBER [SEED]]
program random_lines
   use adfric_base_kinds, only: dp
   use adfric_foundation_stepping_equilibrium, only: stepping_surface_t, stepping_equilibrium_t, find_at_penetration, &
      & find_at_load, stepping_solved
   use stepping_cases, only: stepping_case_t, stepping_sums_t, make_surface, sum_of
   use stepping_judge, only: draw_case, judge_case, words_of_case, verdict_right, verdict_wrong
   use measure, only: print_heading, integer_argument
   use random_dice, only: dice_t, new_dice
   implicit none (type, external)

   !> What balances may leave over, and a load may differ from that which is asked for.
   real(dp), parameter :: balance = 1.0e-10_dp
   !> Answers of the solver, and what the judge says of them.
   type :: counts_t
      integer :: n = 0, right = 0, wrong = 0, open = 0, not_solved = 0
      real(dp) :: mismatch = 0
   end type counts_t
   type(counts_t) :: at_penetration, under_load

   call print_heading('Random sums of waves')
   call search(integer_argument(1, 10000), integer_argument(2, 1))
   print '(a16, 5a10, a16)', '', 'lines', 'right', 'wrong', 'open', 'no state', 'mismatch'
   call report('at a penetration', at_penetration)
   call report('under a load', under_load)
   if (at_penetration%wrong + at_penetration%not_solved + under_load%wrong + under_load%not_solved > 0) stop 1
   if (max(at_penetration%mismatch, under_load%mismatch) > balance) stop 1

contains

   !> Solve and judge lines, each at a penetration and under a load.
   subroutine search(n_lines, seed)
      integer, intent(in) :: n_lines, seed
      type(dice_t) :: dice
      type(stepping_case_t) :: trial
      type(stepping_surface_t) :: surface
      type(stepping_equilibrium_t) :: found
      real(dp) :: depth, load
      integer :: k

      call new_dice(dice, seed)
      do k = 1, n_lines
         call draw_case(dice, k, trial, depth)
         call make_surface(trial, surface)
         call find_at_penetration(surface, depth, found)
         call judge(k, trial, found, at_penetration)
         ! every positive load has a state
         call dice%decades(-3.0_dp, 0.0_dp, load)
         call find_at_load(surface, load, found)
         if (found%status == stepping_solved) under_load%mismatch = max(under_load%mismatch, abs(found%forces(1)%load - load))
         call judge(k, trial, found, under_load)
      end do
   end subroutine search

   !> Judge an answer.
   subroutine judge(k, trial, found, counts)
      !> Number of the line.
      integer, intent(in) :: k
      type(stepping_case_t), intent(in) :: trial
      type(stepping_equilibrium_t), intent(in) :: found
      type(counts_t), intent(inout) :: counts
      type(stepping_sums_t) :: sums
      character(300) :: words
      real(dp) :: difference
      integer :: verdict

      counts%n = counts%n + 1
      call words_of_case(k, trial, found%depth, words)
      if (found%status /= stepping_solved) then
         counts%not_solved = counts%not_solved + 1
         print '(2a)', 'no state: ', trim(words)
         return
      end if
      sums = sum_of(found)
      counts%mismatch = max(counts%mismatch, sums%load_mismatch, sums%energy_mismatch)
      call judge_case(trial, found%depth, sums%load, sums%friction, verdict, difference)
      if (verdict == verdict_right) then
         counts%right = counts%right + 1
      else if (verdict == verdict_wrong) then
         counts%wrong = counts%wrong + 1
         print '(a, es9.2, 2a)', 'wrong by', difference, ': ', trim(words)
      else
         counts%open = counts%open + 1
      end if
   end subroutine judge

   !> A line of the table.
   subroutine report(name, counts)
      character(*), intent(in) :: name
      type(counts_t), intent(in) :: counts

      print '(a16, 5i10, es16.1)', name, counts%n, counts%right, counts%wrong, counts%open, counts%not_solved, counts%mismatch
   end subroutine report

end program random_lines
