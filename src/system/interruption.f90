! SPDX-License-Identifier: GPL-3.0-or-later
!> Has a run been asked to end, by SIGTERM (a batch system), SIGINT (Ctrl-C) or SIGHUP (its terminal is gone)? Another signal,
!> more than a second later, ends it at once.
module adfric_system_interruption
   use, intrinsic :: iso_c_binding, only: c_int
   use adfric_base_watch, only: watch_t
   implicit none (type, external)
   private
   public :: signal_watch_t, catch_signals, caught_signal, signal_name

   !> Ends the work when one of these signals has come, once they are caught.
   type, extends(watch_t) :: signal_watch_t
   contains
      procedure :: wants_end
   end type signal_watch_t

   interface

      !> From now on the signals are noted, and end nothing.
      subroutine catch_signals() bind(c, name='adfric_catch_signals')
         implicit none (type, external)
      end subroutine catch_signals

      !> Number of the signal that came; 0 if none did.
      integer(c_int) function caught_signal() bind(c, name='adfric_caught_signal')
         import :: c_int
         implicit none (type, external)
      end function caught_signal

   end interface

contains

   !> Has one of the signals come?
   logical function wants_end(self)
      class(signal_watch_t), intent(in) :: self

      wants_end = caught_signal() /= 0
      associate (unused => self)
      end associate
   end function wants_end

   !> Name of one of these signals.
   pure function signal_name(number) result(name)
      !> Number of the signal; any but those of SIGHUP and SIGINT is taken for that of SIGTERM.
      integer, intent(in) :: number
      character(:), allocatable :: name
      !> The same on every POSIX system.
      integer, parameter :: number_of_hup = 1, number_of_int = 2

      select case (number)
      case (number_of_hup)
         name = 'SIGHUP'
      case (number_of_int)
         name = 'SIGINT'
      case default
         name = 'SIGTERM'
      end select
   end function signal_name

end module adfric_system_interruption
