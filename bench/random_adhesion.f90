! SPDX-License-Identifier: GPL-3.0-or-later
!> Are states of random rough surfaces that adhere wrong? See bench/README.md.
!>
!> random_adhesion [NUMBER [SEED [CELLS]]]
program random_adhesion
   use adhesion_judge, only: adhesion_counts_t, judge_adhesion
   use adhesion_trials, only: adhesion_trial_t, draw_trial, words_of_trial
   use measure, only: print_heading, integer_argument
   use random_dice, only: dice_t, new_dice
   implicit none (type, external)

   type(adhesion_counts_t) :: near, far
   integer :: n, seed

   call print_heading('Random rough surfaces that adhere')
   n = integer_argument(1, 1000)
   seed = integer_argument(2, 1)
   call search(n, seed, .true., near)
   call search(n/2, seed + 1, .false., far)
   print '(a16, 13a11)', 'sizes', 'surfaces', 'solved', 'no state', 'no conv', 'branches', 'in order', 'same', 'by a jump', &
      & 'no rest', 'rounds', 'unseen', 'broken'
   call report('near', near)
   call report('any', far)
   if (near%n_faults + far%n_faults > 0) stop 1

contains

   !> Draw and judge surfaces.
   subroutine search(n_trials, seed, is_near, counts)
      integer, intent(in) :: n_trials, seed
      logical, intent(in) :: is_near
      type(adhesion_counts_t), intent(out) :: counts
      type(dice_t) :: dice
      type(adhesion_trial_t) :: trial
      character(400) :: fault, words
      integer :: k

      call new_dice(dice, seed)
      do k = 1, n_trials
         call draw_trial(dice, is_near, integer_argument(3, 64), trial)
         call judge_adhesion(trial, counts, fault)
         if (len_trim(fault) == 0) cycle
         call words_of_trial(k, trial, words)
         print '(4a)', trim(fault), ': ', merge('near ', 'any  ', is_near), trim(words)
      end do
   end subroutine search

   !> A line of the table.
   subroutine report(name, counts)
      character(*), intent(in) :: name
      type(adhesion_counts_t), intent(in) :: counts

      associate (c => counts)
         print '(a16, 13i11)', name, c%n_trials, c%by_status([0, 2, 1]), c%n_with_branches, c%n_in_order, c%n_same, &
            & c%n_beyond_jump, c%n_restless, c%n_rounds, c%n_unseen, c%n_faults
         print '(a16, 3(a, es9.1))', '', 'residual over what is allowed', c%residual, ', rise of an energy', c%rise, &
            & ', most pairs of transforms', c%pairs
      end associate
   end subroutine report

end program random_adhesion
