! SPDX-License-Identifier: GPL-3.0-or-later
! What threads share that is found once.
module numerics_found_once
   use adfric_base_kinds, only: dp
   use adfric_numerics_found_once, only: found_once_t, search_t
   use funit
   implicit none (type, external)

contains

   !> Two numbers that follow from a key.
   pure function answer_to(key) result(answer)
      real(dp), intent(in) :: key(:)
      real(dp) :: answer(2)

      answer = [sum(key), real(size(key), dp)]
   end function answer_to

   !> Ask for a key, and check what is found.
   subroutine ask(table, key)
      type(found_once_t), intent(inout) :: table
      real(dp), intent(in) :: key(:)
      type(search_t) :: search
      real(dp) :: answer(2)
      logical :: is_known

      call table%look_up(key, answer, is_known, search)
      if (is_known) then
#line 29 "/work/main/tests/numerics/numerics_found_once.pf"
  call assertEqual(answer_to(key), answer, &
 & location=SourceLocation( &
 & 'numerics_found_once.pf', &
 & 29) )
  if (anyExceptions()) return
#line 30 "/work/main/tests/numerics/numerics_found_once.pf"
      else
         call table%keep(search, answer_to(key))
      end if
   end subroutine ask

   ! Keys that differ in one bit, in their length or in one of many numbers are different, those of -0 and 0 are not.
   !@test
   subroutine test_keys()
      type(found_once_t) :: table
      real(dp) :: long(1000)
      integer :: round, k

      do round = 1, 2
         call ask(table, [1.0_dp])
         call ask(table, [1.0_dp, 2.0_dp])
         call ask(table, [1.0_dp, nearest(2.0_dp, 1.0_dp)])
         call ask(table, [0.0_dp])
         call ask(table, [-0.0_dp])
         do k = 1, 1000
            long = 3
            long(k) = 4
            call ask(table, long)
         end do
#line 53 "/work/main/tests/numerics/numerics_found_once.pf"
  call assertEqual(1004, int(table%n_found), &
 & location=SourceLocation( &
 & 'numerics_found_once.pf', &
 & 53) )
  if (anyExceptions()) return
#line 54 "/work/main/tests/numerics/numerics_found_once.pf"
      end do
      call table%clear()
      call ask(table, [1.0_dp])
#line 57 "/work/main/tests/numerics/numerics_found_once.pf"
  call assertEqual(1005, int(table%n_found), &
 & location=SourceLocation( &
 & 'numerics_found_once.pf', &
 & 57) )
  if (anyExceptions()) return
#line 58 "/work/main/tests/numerics/numerics_found_once.pf"
      call table%clear()
   end subroutine test_keys

   ! Threads find each key once, also when all of them begin with the same one.
   !@test
   subroutine test_threads()
      integer, parameter :: n = 4000, n_keys = 100
      type(found_once_t) :: table
      type(search_t) :: search
      integer :: n_sought(n_keys), i, k, n_wrong
      real(dp) :: answer(2), key(2), work
      logical :: is_known

      n_sought = 0
      n_wrong = 0
      !$omp parallel do num_threads(8) schedule(static, 1) private(search, k, answer, key, work, is_known) reduction(+:n_wrong)
      do i = 0, n - 1
         k = 1 + i*n_keys/n
         key = [real(k, dp), 0.5_dp]
         call table%look_up(key, answer, is_known, search)
         if (is_known) then
            if (any(abs(answer - answer_to(key)) > 0)) n_wrong = n_wrong + 1
         else
            !$omp atomic
            n_sought(k) = n_sought(k) + 1
            work = wait_a_while(key(1))
            call table%keep(search, answer_to(key) + 0*work)
         end if
      end do
      !$omp end parallel do
#line 88 "/work/main/tests/numerics/numerics_found_once.pf"
  call assertEqual(0, n_wrong, &
 & location=SourceLocation( &
 & 'numerics_found_once.pf', &
 & 88) )
  if (anyExceptions()) return
#line 89 "/work/main/tests/numerics/numerics_found_once.pf"
#line 89 "/work/main/tests/numerics/numerics_found_once.pf"
  call assertTrue(all(n_sought == 1), &
 & location=SourceLocation( &
 & 'numerics_found_once.pf', &
 & 89) )
  if (anyExceptions()) return
#line 90 "/work/main/tests/numerics/numerics_found_once.pf"
#line 90 "/work/main/tests/numerics/numerics_found_once.pf"
  call assertEqual(n_keys, int(table%n_found), &
 & location=SourceLocation( &
 & 'numerics_found_once.pf', &
 & 90) )
  if (anyExceptions()) return
#line 91 "/work/main/tests/numerics/numerics_found_once.pf"
      call table%clear()
   end subroutine test_threads

   !> Time for others to come.
   pure real(dp) function wait_a_while(start) result(x)
      real(dp), intent(in) :: start
      integer :: i

      x = start
      do i = 1, 20000
         x = cos(x)
      end do
   end function wait_a_while

   ! A table that is full begins anew, by keys and by their numbers; a long key has room alone.
   !@test
   subroutine test_full_table()
      type(found_once_t) :: table
      integer :: k

      table%most_entries = 10
      do k = 1, 11
         call ask(table, [real(k, dp)])
      end do
      call ask(table, [11.0_dp])
#line 116 "/work/main/tests/numerics/numerics_found_once.pf"
  call assertEqual(11, int(table%n_found), &
 & location=SourceLocation( &
 & 'numerics_found_once.pf', &
 & 116) )
  if (anyExceptions()) return
#line 117 "/work/main/tests/numerics/numerics_found_once.pf"
      call ask(table, [1.0_dp])
#line 118 "/work/main/tests/numerics/numerics_found_once.pf"
  call assertEqual(12, int(table%n_found), &
 & location=SourceLocation( &
 & 'numerics_found_once.pf', &
 & 118) )
  if (anyExceptions()) return
#line 119 "/work/main/tests/numerics/numerics_found_once.pf"
      table%most_entries = 1000
      table%most_numbers = 20
      do k = 1, 3
         call ask(table, spread(1.0_dp, 1, 30))
      end do
#line 124 "/work/main/tests/numerics/numerics_found_once.pf"
  call assertEqual(13, int(table%n_found), &
 & location=SourceLocation( &
 & 'numerics_found_once.pf', &
 & 124) )
  if (anyExceptions()) return
#line 125 "/work/main/tests/numerics/numerics_found_once.pf"
      call ask(table, [1.0_dp])
      call ask(table, spread(1.0_dp, 1, 30))
#line 127 "/work/main/tests/numerics/numerics_found_once.pf"
  call assertEqual(15, int(table%n_found), &
 & location=SourceLocation( &
 & 'numerics_found_once.pf', &
 & 127) )
  if (anyExceptions()) return
#line 128 "/work/main/tests/numerics/numerics_found_once.pf"
      call table%clear()
   end subroutine test_full_table

   ! What is found after the table has begun anew is not kept, and what was not found is sought again.
   !@test
   subroutine test_searches()
      type(found_once_t) :: table
      type(search_t) :: search, other
      real(dp) :: answer(2)
      logical :: is_known

      table%most_entries = 1
      call table%look_up([1.0_dp], answer, is_known, search)
#line 141 "/work/main/tests/numerics/numerics_found_once.pf"
  call assertFalse(is_known, &
 & location=SourceLocation( &
 & 'numerics_found_once.pf', &
 & 141) )
  if (anyExceptions()) return
#line 142 "/work/main/tests/numerics/numerics_found_once.pf"
      call table%look_up([2.0_dp], answer, is_known, other)
#line 143 "/work/main/tests/numerics/numerics_found_once.pf"
  call assertFalse(is_known, &
 & location=SourceLocation( &
 & 'numerics_found_once.pf', &
 & 143) )
  if (anyExceptions()) return
#line 144 "/work/main/tests/numerics/numerics_found_once.pf"
      call table%keep(search, [10.0_dp, 11.0_dp])
      call table%keep(other, [20.0_dp, 21.0_dp])
      call table%look_up([2.0_dp], answer, is_known, other)
#line 147 "/work/main/tests/numerics/numerics_found_once.pf"
  call assertTrue(is_known, &
 & location=SourceLocation( &
 & 'numerics_found_once.pf', &
 & 147) )
  if (anyExceptions()) return
#line 148 "/work/main/tests/numerics/numerics_found_once.pf"
#line 148 "/work/main/tests/numerics/numerics_found_once.pf"
  call assertEqual([20.0_dp, 21.0_dp], answer, &
 & location=SourceLocation( &
 & 'numerics_found_once.pf', &
 & 148) )
  if (anyExceptions()) return
#line 149 "/work/main/tests/numerics/numerics_found_once.pf"
      call table%look_up([1.0_dp], answer, is_known, search)
#line 150 "/work/main/tests/numerics/numerics_found_once.pf"
  call assertFalse(is_known, &
 & location=SourceLocation( &
 & 'numerics_found_once.pf', &
 & 150) )
  if (anyExceptions()) return
#line 151 "/work/main/tests/numerics/numerics_found_once.pf"
      call table%give_up(search)
      call table%look_up([1.0_dp], answer, is_known, search)
#line 153 "/work/main/tests/numerics/numerics_found_once.pf"
  call assertFalse(is_known, &
 & location=SourceLocation( &
 & 'numerics_found_once.pf', &
 & 153) )
  if (anyExceptions()) return
#line 154 "/work/main/tests/numerics/numerics_found_once.pf"
      call table%keep(search, [10.0_dp, 11.0_dp])
#line 155 "/work/main/tests/numerics/numerics_found_once.pf"
  call assertEqual(3, int(table%n_found), &
 & location=SourceLocation( &
 & 'numerics_found_once.pf', &
 & 155) )
  if (anyExceptions()) return
#line 156 "/work/main/tests/numerics/numerics_found_once.pf"
      call table%clear()
   end subroutine test_searches

   ! More searches than there are locks: what is left over is found, and not kept.
   !@test
   subroutine test_many_searches()
      integer, parameter :: n = 130, n_locks = 128
      type(found_once_t) :: table
      type(search_t) :: searches(n)
      real(dp) :: answer(2)
      logical :: is_known
      integer :: k

      do k = 1, n
         call table%look_up([real(k, dp)], answer, is_known, searches(k))
#line 171 "/work/main/tests/numerics/numerics_found_once.pf"
  call assertFalse(is_known, &
 & location=SourceLocation( &
 & 'numerics_found_once.pf', &
 & 171) )
  if (anyExceptions()) return
#line 172 "/work/main/tests/numerics/numerics_found_once.pf"
      end do
      do k = 1, n
         call table%keep(searches(k), answer_to([real(k, dp)]))
      end do
#line 176 "/work/main/tests/numerics/numerics_found_once.pf"
  call assertEqual(n, int(table%n_found), &
 & location=SourceLocation( &
 & 'numerics_found_once.pf', &
 & 176) )
  if (anyExceptions()) return
#line 177 "/work/main/tests/numerics/numerics_found_once.pf"
      do k = 1, n
         call ask(table, [real(k, dp)])
      end do
#line 180 "/work/main/tests/numerics/numerics_found_once.pf"
  call assertEqual(2*n - n_locks, int(table%n_found), &
 & location=SourceLocation( &
 & 'numerics_found_once.pf', &
 & 180) )
  if (anyExceptions()) return
#line 181 "/work/main/tests/numerics/numerics_found_once.pf"
      call table%clear()
   end subroutine test_many_searches

end module numerics_found_once

module Wrapnumerics_found_once
   use FUnit
   use numerics_found_once
   implicit none
   private

contains


end module Wrapnumerics_found_once

function numerics_found_once_suite() result(suite)
   use FUnit
   use numerics_found_once
   use Wrapnumerics_found_once
   implicit none
   type (TestSuite) :: suite

   class (Test), allocatable :: t

   suite = TestSuite('numerics_found_once_suite')

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_keys', &
      test_keys))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_threads', &
      test_threads))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_full_table', &
      test_full_table))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_searches', &
      test_searches))
   call suite%addTest(t)

   if(allocated(t)) deallocate(t)
   allocate(t, source=TestMethod('test_many_searches', &
      test_many_searches))
   call suite%addTest(t)


end function numerics_found_once_suite

