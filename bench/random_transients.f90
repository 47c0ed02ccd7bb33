! SPDX-License-Identifier: GPL-3.0-or-later
!> Do transients end in the states of random waves that adhere while they slide? See bench/README.md.
!>
!> random_transients [NUMBER [SEED [TABLE.csv]]]
program random_transients
   use, intrinsic :: iso_fortran_env, only: output_unit
   use measure, only: integer_argument, open_table, print_heading, text_argument
   use random_dice, only: dice_t, new_dice
   use transient_judge, only: slide_trial_t, transient_counts_t, draw_slide, judge_slide, words_of_slide
   implicit none (type, external)
   !> Prescribed and branch.
   character(*), parameter :: kinds(*) = [character(24) :: 'mean pressure,loading', 'mean pressure,adhered', &
      & 'penetration,loading', 'penetration,adhered']
   type(dice_t) :: dice
   type(slide_trial_t) :: trial
   !> Cells on which a state is judged again that seems wrong.
   integer, parameter :: finer(2) = [256, 384]
   type(transient_counts_t) :: counts(size(kinds)), again
   character(200) :: fault
   character(2000) :: words
   integer :: k, kind, seed, before, table

   call print_heading('Random waves that adhere while they slide, beside transients')
   seed = integer_argument(2, 1)
   do k = seed, seed + integer_argument(1, 100) - 1
      ! a trial does not depend on those before
      call new_dice(dice, k)
      call draw_slide(dice, trial)
      kind = merge(2, 0, trial%has_penetration) + merge(2, 1, trial%is_adhered)
      associate (c => counts(kind))
         before = c%n_unconverged
         call judge_slide(trial, c, fault)
         if (c%n_unconverged > before) fault = 'not_converged'
         if (index(fault, 'another state') == 1) then
            ! two grids that agree by chance tell too small an error
            again = transient_counts_t()
            call judge_slide(trial, again, fault, grids=finer)
            if (again%n_wrong == 0) then
               c%n_wrong = c%n_wrong - 1
               print '(a, i0, 2(a, i0), a, f0.2)', 'seed ', k, ': judged again on ', finer(1), ' and ', finer(2), ' cells: ', &
                  & again%largest
            end if
         end if
      end associate
      if (len_trim(fault) == 0) cycle
      call words_of_slide(trial, words)
      print '(a, i0, 4a)', 'seed ', k, ': ', trim(fault), ': ', trim(words)
      flush (output_unit)
   end do
   table = open_table(text_argument(3, 'random_transients.csv'), &
      & 'prescribed,branch,waves,not_converged,restless,judged,apart,with_gap,friction_known,wrong,largest')
   print '(a24, *(a15))', 'kind', 'waves', 'not converged', 'restless', 'judged', 'apart', 'with a gap', 'friction known', &
      & 'wrong', 'largest'
   do kind = 1, size(kinds)
      associate (c => counts(kind))
         print '(a24, 8i15, f15.2)', kinds(kind), c%n_trials, c%n_unconverged, c%n_restless, c%n_judged, c%n_apart, c%n_gaps, &
            & c%n_sharp, c%n_wrong, c%largest
         write (table, '(a, 8(",", i0), ",", f0.2)') trim(kinds(kind)), c%n_trials, c%n_unconverged, c%n_restless, c%n_judged, &
            & c%n_apart, c%n_gaps, c%n_sharp, c%n_wrong, c%largest
      end associate
   end do
   close (table)
   if (sum(counts%n_wrong) > 0) stop 1
end program random_transients
