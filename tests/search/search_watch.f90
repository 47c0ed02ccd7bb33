! SPDX-License-Identifier: GPL-3.0-or-later
!> What is being solved, for the case that it never ends: a watch that rings, a trapped operation or a crash prints the case first.
module search_watch
   use, intrinsic :: iso_c_binding, only: c_char, c_funloc, c_funptr, c_int, c_ptr, c_loc, c_size_t
   implicit none (type, external)
   private
   public :: watch, stop_watch

   !> Numbers of the signals on Linux: abort, arithmetic, memory, time.
   integer(c_int), parameter :: signals(*) = [6_c_int, 8_c_int, 11_c_int, 14_c_int]
   integer(c_int), parameter :: standard_error = 2

   !> The handler of a signal gets no arguments of ours: what it prints has to stand in the module.
   character(20000), target, save :: current = ''
   integer, save :: length = 0

   interface
      type(c_ptr) function c_signal(number, handler) bind(c, name='signal')
         import :: c_int, c_funptr, c_ptr
         implicit none (type, external)
         integer(c_int), intent(in), value :: number
         type(c_funptr), intent(in), value :: handler
      end function c_signal
      integer(c_int) function c_alarm(seconds) bind(c, name='alarm')
         import :: c_int
         implicit none (type, external)
         integer(c_int), intent(in), value :: seconds
      end function c_alarm
      integer(c_size_t) function c_write(unit, text, n) bind(c, name='write')
         import :: c_int, c_ptr, c_size_t
         implicit none (type, external)
         integer(c_int), intent(in), value :: unit
         type(c_ptr), intent(in), value :: text
         integer(c_size_t), intent(in), value :: n
      end function c_write
      subroutine c_exit(status) bind(c, name='_exit')
         import :: c_int
         implicit none (type, external)
         integer(c_int), intent(in), value :: status
      end subroutine c_exit
   end interface

contains

   !> From now on this text is what is being solved, for at most so many seconds.
   subroutine watch(text, seconds)
      character(*), intent(in) :: text
      integer, intent(in) :: seconds
      type(c_ptr) :: old
      integer(c_int) :: rest
      integer :: k

      length = min(len(text), len(current))
      current(:length) = text(:length)
      do k = 1, size(signals)
         old = c_signal(signals(k), c_funloc(print_current))
      end do
      rest = c_alarm(int(seconds, c_int))
      associate (unused => old, unused_too => rest)
      end associate
   end subroutine watch

   !> No watch any more.
   subroutine stop_watch()
      integer(c_int) :: rest

      rest = c_alarm(0_c_int)
      associate (unused => rest)
      end associate
   end subroutine stop_watch

   !> Print the case and end.
   subroutine print_current(number) bind(c)
      integer(c_int), intent(in), value :: number
      character(*), parameter :: head = 'search: stopped by a signal (8 arithmetic, 11 memory, 14 time) '
      character(len(head) + 4), target :: line
      integer(c_size_t) :: n
      integer :: digit

      line = head
      digit = number
      line(len(head) + 1:) = achar(iachar('0') + digit/10)//achar(iachar('0') + mod(digit, 10))//achar(10)//' '
      n = c_write(standard_error, c_loc(line), int(len(head) + 3, c_size_t))
      n = c_write(standard_error, c_loc(current), int(length, c_size_t))
      call c_exit(3_c_int)
   end subroutine print_current

end module search_watch
