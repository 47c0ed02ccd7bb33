! Random rough surfaces that adhere, as many as are quick: `bench/run random_adhesion` has a thousand.
module periodic_adhesion_search
   use adfric_base_kinds, only: dp
   use adhesion_judge, only: adhesion_counts_t, judge_adhesion
   use adhesion_trials, only: adhesion_trial_t, draw_trial, words_of_trial
   use plain_periodic, only: plain_share, stiff_pressure
   use random_dice, only: dice_t, new_dice
   use funit
   implicit none (type, external)

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
         call draw_trial(dice, is_near, 32, trial)
         call judge_adhesion(trial, counts, fault)
         call words_of_trial(k, trial, words)
#line 28 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
  call assertEqual('', trim(fault), message=trim(words), &
 & location=SourceLocation( &
 & 'periodic_adhesion_search.pf', &
 & 28) )
  if (anyExceptions()) return
#line 29 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
      end do
   end subroutine search

   ! Zones that cells see: all is solved, branches are those of rounds alone, and there are loads with two of them.
   !@test
   subroutine test_near()
      integer, parameter :: n = 80
      type(adhesion_counts_t) :: counts

      call search(n, 11, .true., counts)
#line 39 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
  call assertEqual(0, counts%by_status(1), &
 & location=SourceLocation( &
 & 'periodic_adhesion_search.pf', &
 & 39) )
  if (anyExceptions()) return
#line 40 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
#line 40 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
  call assertGreaterThan(counts%by_status(0), 4*n, &
 & location=SourceLocation( &
 & 'periodic_adhesion_search.pf', &
 & 40) )
  if (anyExceptions()) return
#line 41 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
#line 41 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
  call assertGreaterThan(counts%n_with_branches, 2, &
 & location=SourceLocation( &
 & 'periodic_adhesion_search.pf', &
 & 41) )
  if (anyExceptions()) return
#line 42 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
#line 42 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
  call assertGreaterThan(counts%n_same, n, &
 & location=SourceLocation( &
 & 'periodic_adhesion_search.pf', &
 & 42) )
  if (anyExceptions()) return
#line 43 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
#line 43 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
  call assertLessThan(20*counts%n_beyond_jump, counts%n_same, &
 & location=SourceLocation( &
 & 'periodic_adhesion_search.pf', &
 & 43) )
  if (anyExceptions()) return
#line 44 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
#line 44 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
  call assertEqual(0, counts%n_restless, &
 & location=SourceLocation( &
 & 'periodic_adhesion_search.pf', &
 & 44) )
  if (anyExceptions()) return
#line 45 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
   end subroutine test_near

   ! Stress and range of any size: no answer is wrong.
   !@test
   subroutine test_any_size()
      integer, parameter :: n = 40
      type(adhesion_counts_t) :: counts

      call search(n, 13, .false., counts)
#line 54 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
  call assertGreaterThan(counts%by_status(0), 2*n, &
 & location=SourceLocation( &
 & 'periodic_adhesion_search.pf', &
 & 54) )
  if (anyExceptions()) return
#line 55 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
#line 55 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
  call assertEqual(0, counts%n_restless, &
 & location=SourceLocation( &
 & 'periodic_adhesion_search.pf', &
 & 55) )
  if (anyExceptions()) return
#line 56 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
   end subroutine test_any_size

   ! The judge's own stiffness and shares: a wave, and a plane that is cut.
   !@test
   subroutine test_judge()
      real(dp), parameter :: two_pi = 6.283185307179586476925286766559_dp
      real(dp) :: wave(12, 8), ridge(8, 5)
      real(dp), allocatable :: found(:, :)
      integer :: i, j

      do j = 1, 8
         wave(:, j) = [(cos(two_pi*(2*i/12.0_dp + 3*j/8.0_dp)), i=1, 12)]
      end do
      found = stiff_pressure(wave, [1.0_dp, 0.5_dp], .false.)
#line 70 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
  call assertEqual(two_pi/2*hypot(2.0_dp, 6.0_dp)*wave, found, tolerance=1.0e-12_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion_search.pf', &
 & 70) )
  if (anyExceptions()) return
#line 71 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
      do i = 1, 8
         ridge(i, :) = 0.1_dp*abs(i - 4)
      end do
      found = plain_share(ridge, 0.25_dp, .false.)
#line 75 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
  call assertEqual(5.0_dp, sum(found(:, 2)), tolerance=1.0e-14_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion_search.pf', &
 & 75) )
  if (anyExceptions()) return
#line 76 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
#line 76 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
  call assertEqual(0.125_dp, found(1, 4), tolerance=1.0e-14_dp, &
 & location=SourceLocation( &
 & 'periodic_adhesion_search.pf', &
 & 76) )
  if (anyExceptions()) return
#line 77 "/work/wt/penetration/tests/periodic/periodic_adhesion_search.pf"
   end subroutine test_judge

end module periodic_adhesion_search

module Wrapperiodic_adhesion_search
   use FUnit
   use periodic_adhesion_search
   implicit none
   private

contains


end module Wrapperiodic_adhesion_search

function periodic_adhesion_search_suite() result(suite)
   use FUnit
   use periodic_adhesion_search
   use Wrapperiodic_adhesion_search
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('periodic_adhesion_search_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_near', &
      test_near))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_any_size', &
      test_any_size))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_judge', &
      test_judge))
   call suite%addTest(t)


end function periodic_adhesion_search_suite

