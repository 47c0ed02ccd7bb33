! SPDX-License-Identifier: GPL-3.0-or-later
!> Can the threads of a run be started? OpenMP ends the program where they cannot, so it is tried before.
module adfric_system_threads
   use, intrinsic :: iso_c_binding, only: c_double, c_int
   use adfric_base_error, only: error_t, set_error, file_failure
   implicit none (type, external)
   private
   public :: check_threads

   !> Least stack of a thread [kB]: ten times what any model has been seen to need.
   integer, parameter :: least_stack = 256

   interface
      !> Start threads and end them again; 0, or an error number of the system.
      integer(c_int) function try_threads(n, n_started, stack_size) bind(c, name='adfric_try_threads')
         import :: c_double, c_int
         implicit none (type, external)
         !> Number of threads to be started at once.
         integer(c_int), intent(in), value :: n
         !> Number of threads that could be started.
         integer(c_int), intent(out) :: n_started
         !> Stack of each thread [bytes]; 0 if it cannot be said.
         real(c_double), intent(out) :: stack_size
      end function try_threads
   end interface

contains

   !> Refuse a run whose threads the system has no space for, or whose stacks are too small.
   subroutine check_threads(n, error)
      !> Number of threads besides the one that is there.
      integer, intent(in) :: n
      !> Not allocated if the threads can be started.
      type(error_t), allocatable, intent(out) :: error
      integer(c_int) :: number, n_started
      real(c_double) :: stack_size
      integer :: most
      character(100) :: text

      most = most_threads()
      if (n > most) then
         write (text, '(a, i0, a, i0, a)') 'cannot start ', n, ' threads, the system has no more than ', most, ' for all'
         call set_error(error, file_failure, trim(text)//'; OMP_NUM_THREADS sets how many there are')
         return
      end if
      number = try_threads(int(n, c_int), n_started, stack_size)
      if (stack_size > 0 .and. stack_size < 1024*least_stack) then
         write (text, '(a, i0, a, i0, a)') 'the stack of a thread has ', int(stack_size)/1024, ' kB, needed: ', least_stack, ' kB'
         call set_error(error, file_failure, trim(text)//'; OMP_STACKSIZE and ulimit -s set it')
      else if (number /= 0) then
         write (text, '(a, i0, a, i0, a)') 'cannot start ', n, ' threads, only ', n_started, ' could be had'
         call set_error(error, file_failure, trim(text)//'; OMP_NUM_THREADS sets how many there are, OMP_STACKSIZE how large')
      end if
   end subroutine check_threads

   !> Threads that all processes of the system may have together; huge if it cannot be said. More are not even tried: others could
   !> start none in the meantime.
   integer function most_threads()
      character(*), parameter :: limits(*) = [character(32) :: '/proc/sys/kernel/pid_max', '/proc/sys/kernel/threads-max']
      integer :: i, limit, unit, status

      most_threads = huge(1)
      do i = 1, size(limits)
         open (newunit=unit, file=trim(limits(i)), action='read', status='old', iostat=status)
         if (status /= 0) cycle
         read (unit, *, iostat=status) limit
         if (status == 0) most_threads = min(most_threads, limit)
         close (unit, iostat=status)
      end do
   end function most_threads

end module adfric_system_threads
