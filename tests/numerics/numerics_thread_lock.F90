! SPDX-License-Identifier: GPL-3.0-or-later
! A lock that one thread holds while others wait.
module numerics_thread_lock
   use adfric_numerics_thread_lock, only: thread_lock_t
   use funit
   implicit none (type, external)

contains

   ! Threads that hold the lock come one after the other, and who waits for it sees what was done meanwhile.
   !@test
   subroutine test_one_after_the_other()
      integer, parameter :: n = 2000
      type(thread_lock_t) :: lock
      integer :: i, n_done

      n_done = 0
      call lock%acquire()
      call lock%release()
      !$omp parallel do num_threads(4)
      do i = 1, n
         call lock%acquire()
         n_done = n_done + 1
         call lock%release()
      end do
      !$omp end parallel do
      call lock%destroy()
#line 28 "/work/main/tests/numerics/numerics_thread_lock.pf"
  call assertEqual(n, n_done, &
 & location=SourceLocation( &
 & 'numerics_thread_lock.pf', &
 & 28) )
  if (anyExceptions()) return
#line 29 "/work/main/tests/numerics/numerics_thread_lock.pf"
   end subroutine test_one_after_the_other

   ! The thread that is first to come does the work under the lock, the others have it when they have waited.
   !@test
   subroutine test_waiting()
      integer, parameter :: n_threads = 4, n_rounds = 200
      type(thread_lock_t) :: lock
      integer :: round, i, k, n_early, work
      logical :: is_taken, is_mine

      n_early = 0
      do round = 1, n_rounds
         work = 0
         is_taken = .false.
         !$omp parallel do num_threads(n_threads) private(is_mine, k) reduction(+:n_early)
         do i = 1, n_threads
            !$omp critical (numerics_thread_lock_test)
            is_mine = .not. is_taken
            is_taken = .true.
            if (is_mine) call lock%acquire()
            !$omp end critical (numerics_thread_lock_test)
            if (is_mine) then
               do k = 1, 1000
                  work = work + 1
               end do
               call lock%release()
            else
               call lock%wait_for()
               if (work /= 1000) n_early = n_early + 1
            end if
         end do
         !$omp end parallel do
      end do
      call lock%destroy()
#line 63 "/work/main/tests/numerics/numerics_thread_lock.pf"
  call assertEqual(0, n_early, &
 & location=SourceLocation( &
 & 'numerics_thread_lock.pf', &
 & 63) )
  if (anyExceptions()) return
#line 64 "/work/main/tests/numerics/numerics_thread_lock.pf"
   end subroutine test_waiting

end module numerics_thread_lock

module Wrapnumerics_thread_lock
   use FUnit
   use numerics_thread_lock
   implicit none
   private

contains


end module Wrapnumerics_thread_lock

function numerics_thread_lock_suite() result(suite)
   use FUnit
   use numerics_thread_lock
   use Wrapnumerics_thread_lock
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('numerics_thread_lock_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_one_after_the_other', &
      test_one_after_the_other))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_waiting', &
      test_waiting))
   call suite%addTest(t)


end function numerics_thread_lock_suite

