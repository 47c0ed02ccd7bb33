! SPDX-License-Identifier: GPL-3.0-or-later
!> How often an estimate of an error is right, and how far above the error it is.
module estimate_counts
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: counts_t, count_case, report_counts, lowest, highest

   !> Decades of estimate over error: the first and last also have what lies beyond.
   integer, parameter :: lowest = -3, highest = 9
   !> The round-off of a number in double precision: no error is known to be smaller.
   real(dp), parameter :: round_off = epsilon(1.0_dp)/2

   !> Estimates that may be below the error, as a share.
   real(dp), parameter :: largest_share_below = 0.01_dp

   !> Counts of one kind of case.
   type :: counts_t
      character(40) :: name = ''
      !> Cases by decade.
      integer :: by_decade(lowest:highest) = 0
      !> Cases whose estimate is below their error; above 100 times it; all.
      integer :: n_below = 0, n_far = 0, n = 0
      !> Cases that were not solved, that have no truth, and whose truth another method does not confirm.
      integer :: n_unsolved = 0, n_without_truth = 0, n_doubtful = 0
      !> The smallest estimate over error.
      real(dp) :: least = huge(1.0_dp)
      !> The largest error that is above its estimate.
      real(dp) :: worst = 0
   end type counts_t

contains

   !> Count a case.
   subroutine count_case(counts, estimate, error, label)
      type(counts_t), intent(inout) :: counts
      real(dp), intent(in) :: estimate, error
      !> What the case is, for the message.
      character(*), intent(in) :: label
      real(dp) :: ratio

      if (.not. (estimate >= 0 .and. error >= 0)) error stop 'error_estimates: not a number: '//label
      ratio = max(estimate, round_off)/max(error, round_off)
      counts%n = counts%n + 1
      if (estimate < error) counts%n_below = counts%n_below + 1
      if (estimate < error) counts%worst = max(counts%worst, error)
      if (ratio > 100) counts%n_far = counts%n_far + 1
      counts%least = min(counts%least, ratio)
      associate (k => max(lowest, min(highest, floor(log10(ratio)))))
         counts%by_decade(k) = counts%by_decade(k) + 1
      end associate
   end subroutine count_case

   !> Print and write all kinds and their sum.
   subroutine report_counts(table, counts)
      integer, intent(in) :: table
      type(counts_t), intent(in) :: counts(:)
      type(counts_t) :: all_counts
      integer :: k

      print '(a, i0, a, i0, a)', 'estimate over true error, cases by decade from 1e', lowest, ' to 1e', highest, ' and above'
      print '(a30, a8, 13i6, 2a9, 2a7, a9, 2a8)', '', 'cases', [(k, k=lowest, highest)], '>= 1', '<= 100', 'not s.', 'no t.', &
         'doubtful', 'least', 'worst'
      all_counts%name = 'all'
      do k = 1, size(counts)
         call report(table, counts(k))
         all_counts%by_decade = all_counts%by_decade + counts(k)%by_decade
         all_counts%n_below = all_counts%n_below + counts(k)%n_below
         all_counts%n_far = all_counts%n_far + counts(k)%n_far
         all_counts%n = all_counts%n + counts(k)%n
         all_counts%n_unsolved = all_counts%n_unsolved + counts(k)%n_unsolved
         all_counts%n_without_truth = all_counts%n_without_truth + counts(k)%n_without_truth
         all_counts%n_doubtful = all_counts%n_doubtful + counts(k)%n_doubtful
         all_counts%least = min(all_counts%least, counts(k)%least)
         all_counts%worst = max(all_counts%worst, counts(k)%worst)
      end do
      call report(table, all_counts)
      if (all_counts%n_below > largest_share_below*all_counts%n) error stop 'error_estimates: too many are below the error'
   end subroutine report_counts

   subroutine report(table, counts)
      integer, intent(in) :: table
      type(counts_t), intent(in) :: counts
      integer :: k

      associate (c => counts)
         print '(a30, i8, 13i6, 2f9.4, 2i7, i9, 2es8.1)', c%name, c%n, c%by_decade, 1 - real(c%n_below, dp)/max(c%n, 1), &
            1 - real(c%n_far, dp)/max(c%n, 1), c%n_unsolved, c%n_without_truth, c%n_doubtful, c%least, c%worst
         do k = lowest, highest
            write (table, '(a, 2(",", i0))') '"'//trim(c%name)//'"', k, c%by_decade(k)
         end do
         write (table, '(a, ",", a, ",", f0.6)') '"'//trim(c%name)//'"', 'share_held', 1 - real(c%n_below, dp)/max(c%n, 1)
         write (table, '(a, ",", a, ",", f0.6)') '"'//trim(c%name)//'"', 'share_within_100', 1 - real(c%n_far, dp)/max(c%n, 1)
         write (table, '(a, ",", a, ",", i0)') '"'//trim(c%name)//'"', 'cases', c%n
      end associate
   end subroutine report

end module estimate_counts
