! SPDX-License-Identifier: GPL-3.0-or-later
!> A second process that does a piece of work for this one and sends back numbers. It may take too long, run out of memory or die:
!> this process goes on whatever becomes of it.
!>
!>    start ---> it works: `is_child` is true there, `send` any number of times, `end_child`
!>      |
!>      +------> this process: `receive` until the other has ended or the time is over, then `stop`
module adfric_system_child_process
   use, intrinsic :: iso_c_binding, only: c_int, c_long, c_short, c_size_t, c_double
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: child_process_t, start_child

   !> The other process.
   type :: child_process_t
      !> Is this the other process itself?
      logical :: is_child = .false.
      !> Number of the other process; < 0 if there is none.
      integer(c_int), private :: id = -1
      !> Ends of the pipe: where this process reads, where the other one writes.
      integer(c_int), private :: ends(2) = -1
   contains
      procedure :: send
      procedure :: end_child
      procedure :: receive
      procedure :: stop => stop_child
   end type child_process_t

   !> `struct pollfd`
   type, bind(c) :: poll_t
      !> Descriptor that is watched.
      integer(c_int) :: file
      !> Events that are waited for, and those that have come.
      integer(c_short) :: wanted, found
   end type poll_t

   !> `struct timeval` and `struct rusage`
   type, bind(c) :: time_t
      !> A duration, whole seconds and the rest [us].
      integer(c_long) :: seconds = 0, microseconds = 0
   end type time_t
   !> What a process has used, `struct rusage`.
   type, bind(c) :: usage_t
      !> Time on a processor in the program and in the system.
      type(time_t) :: of_user, of_system
      !> What else the system counts, which is not read.
      integer(c_long) :: others(14) = 0
   end type usage_t

   !> POLLIN, SIGKILL and descriptors 1 and 2 have these numbers on every POSIX system.
   integer(c_short), parameter :: poll_in = 1
   integer(c_int), parameter :: signal_kill = 9, standard_output = 1, standard_error = 2

   interface

      !> Make a pipe; 0 if it went well.
      integer(c_int) function c_pipe(ends) bind(c, name='pipe')
         import :: c_int
         implicit none (type, external)
         !> Descriptors of the two ends: reading, writing.
         integer(c_int), intent(out) :: ends(2)
      end function c_pipe

      !> Copy this process: 0 in the copy, else the number of the copy, negative if there is none.
      integer(c_int) function c_fork() bind(c, name='fork')
         import :: c_int
         implicit none (type, external)
      end function c_fork

      !> Let the system end this process after a time.
      integer(c_int) function c_alarm(seconds) bind(c, name='alarm')
         import :: c_int
         implicit none (type, external)
         !> After how many seconds the process is ended.
         integer(c_int), value :: seconds
      end function c_alarm

      !> Read numbers; how many bytes came, negative after an error.
      integer(c_size_t) function c_read(file, buffer, n_bytes) bind(c, name='read')
         import :: c_int, c_size_t, c_double
         implicit none (type, external)
         !> Descriptor of the file.
         integer(c_int), value :: file
         !> Receives the numbers.
         real(c_double), intent(inout) :: buffer(*)
         !> Largest number of bytes to read.
         integer(c_size_t), value :: n_bytes
      end function c_read

      !> Write numbers; how many bytes went, negative after an error.
      integer(c_size_t) function c_write(file, buffer, n_bytes) bind(c, name='write')
         import :: c_int, c_size_t, c_double
         implicit none (type, external)
         !> Descriptor of the file.
         integer(c_int), value :: file
         !> Numbers to write.
         real(c_double), intent(in) :: buffer(*)
         !> Number of bytes to write.
         integer(c_size_t), value :: n_bytes
      end function c_write

      !> Close a file; 0 if it went well.
      integer(c_int) function c_close(file) bind(c, name='close')
         import :: c_int
         implicit none (type, external)
         !> Descriptor of the file.
         integer(c_int), value :: file
      end function c_close

      !> Wait until something comes; the number of files with something to read, 0 if the time is over.
      integer(c_int) function c_poll(files, n_files, milliseconds) bind(c, name='poll')
         import :: c_int, c_long, poll_t
         implicit none (type, external)
         !> What is waited for, and receives what has come.
         type(poll_t), intent(inout) :: files(*)
         !> Number of these files.
         integer(c_long), value :: n_files
         !> Longest time to wait [ms]; negative: without end.
         integer(c_int), value :: milliseconds
      end function c_poll

      !> Send a signal to a process; 0 if it went well.
      integer(c_int) function c_kill(process, signal) bind(c, name='kill')
         import :: c_int
         implicit none (type, external)
         !> Number of the process.
         integer(c_int), value :: process
         !> Number of the signal.
         integer(c_int), value :: signal
      end function c_kill

      !> Wait for the end of a process; its number, negative after an error.
      integer(c_int) function c_wait4(process, status, options, usage) bind(c, name='wait4')
         import :: c_int, usage_t
         implicit none (type, external)
         !> Number of the process.
         integer(c_int), value :: process
         !> Receives how the process ended.
         integer(c_int), intent(out) :: status
         !> 0 to wait until the process ends.
         integer(c_int), value :: options
         !> Receives the times that the process had on a processor.
         type(usage_t), intent(inout) :: usage
      end function c_wait4

      !> End this process without closing or flushing anything.
      subroutine c_exit_at_once(status) bind(c, name='_exit')
         import :: c_int
         implicit none (type, external)
         !> Exit status of this process.
         integer(c_int), value :: status
      end subroutine c_exit_at_once

   end interface

contains

   !> Start the other process: a copy of this one that goes on from here. It prints nothing, and ends by itself after a time.
   subroutine start_child(self, seconds, is_started)
      !> The other process, with a pipe from it to this one.
      type(child_process_t), intent(out) :: self
      !> Time after which the other process ends, whatever it does [s].
      integer, intent(in) :: seconds
      !> False where the machine has no space for another process.
      logical, intent(out) :: is_started
      integer(c_int) :: unused

      is_started = .false.
      if (c_pipe(self%ends) /= 0) return
      self%id = c_fork()
      self%is_child = self%id == 0
      is_started = self%id >= 0
      if (self%is_child) then
         unused = c_alarm(int(seconds, c_int))
         unused = c_close(standard_output)
         unused = c_close(standard_error)
         unused = c_close(self%ends(1))
      else
         unused = c_close(self%ends(2))
         if (.not. is_started) unused = c_close(self%ends(1))
      end if
   end subroutine start_child

   !> In the other process: send numbers, all of them or none.
   subroutine send(self, numbers)
      class(child_process_t), intent(in) :: self
      !> So few numbers that the pipe takes them at once.
      real(dp), intent(in) :: numbers(:)
      real(c_double) :: buffer(size(numbers))

      buffer = numbers
      if (c_write(self%ends(2), buffer, bytes_of(size(numbers))) /= bytes_of(size(numbers))) call c_exit_at_once(1_c_int)
   end subroutine send

   !> In the other process: end it. Nothing of what it holds in common with this one is touched.
   subroutine end_child(self)
      class(child_process_t), intent(in) :: self

      if (self%is_child) call c_exit_at_once(0_c_int)
   end subroutine end_child

   !> In this process: wait for numbers that the other one has sent.
   subroutine receive(self, numbers, seconds, is_received)
      class(child_process_t), intent(in) :: self
      !> Receives as many numbers as were sent at once; 0 if none came.
      real(dp), intent(out) :: numbers(:)
      !> Longest time to wait for the numbers [s]; with 0 or less nothing is received.
      real(dp), intent(in) :: seconds
      !> False if the time was over or the other process has ended.
      logical, intent(out) :: is_received
      real(c_double) :: buffer(size(numbers))
      type(poll_t) :: files(1)
      integer, parameter :: thousand = 1000

      numbers = 0
      buffer = 0
      files(1) = poll_t(self%ends(1), poll_in, 0_c_short)
      is_received = .false.
      if (.not. seconds > 0) return
      if (c_poll(files, 1_c_long, int(ceiling(thousand*seconds), c_int)) <= 0) return
      is_received = c_read(self%ends(1), buffer, bytes_of(size(numbers))) == bytes_of(size(numbers))
      if (is_received) numbers = buffer
   end subroutine receive

   !> In this process: end the other one, if it has not ended yet.
   subroutine stop_child(self, seconds)
      class(child_process_t), intent(inout) :: self
      !> Time that the other process had on a processor [s].
      real(dp), intent(out) :: seconds
      real(dp), parameter :: microsecond = 1.0e-6_dp
      type(usage_t) :: usage
      integer(c_int) :: unused, status

      seconds = 0
      if (self%id <= 0) return
      unused = c_kill(self%id, signal_kill)
      unused = c_wait4(self%id, status, 0_c_int, usage)
      seconds = usage%of_user%seconds + usage%of_system%seconds &
         & + microsecond*(usage%of_user%microseconds + usage%of_system%microseconds)
      unused = c_close(self%ends(1))
      self%id = -1
   end subroutine stop_child

   !> Size of so many numbers [bytes].
   pure integer(c_size_t) function bytes_of(n)
      !> Number of real numbers.
      integer, intent(in) :: n
      integer, parameter :: real_bytes = 8

      bytes_of = int(n*real_bytes, c_size_t)
   end function bytes_of

end module adfric_system_child_process
