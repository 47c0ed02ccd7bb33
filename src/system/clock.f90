! SPDX-License-Identifier: GPL-3.0-or-later
!> The time that passes.
module adfric_system_clock
   use, intrinsic :: iso_c_binding, only: c_int
   use adfric_base_kinds, only: dp, i8
   implicit none (type, external)
   private
   public :: pause_thread, wall_clock

   interface
      !> Sleep for so many microseconds, below a million.
      integer(c_int) function c_usleep(microseconds) bind(c, name='usleep')
         import :: c_int
         implicit none (type, external)
         !> The time.
         integer(c_int), intent(in), value :: microseconds
      end function c_usleep
   end interface

contains

   !> Seconds since some moment; only differences mean something.
   real(dp) function wall_clock()
      integer(i8) :: count, rate

      call system_clock(count, rate)
      wall_clock = real(count, dp)/real(rate, dp)
   end function wall_clock

   !> Let the calling thread sleep; a signal may wake it earlier.
   subroutine pause_thread(seconds)
      !> The time, from 0 to below 1 [s].
      real(dp), intent(in) :: seconds
      integer(c_int) :: unused

      unused = c_usleep(int(1.0e6_dp*seconds, c_int))
   end subroutine pause_thread

end module adfric_system_clock
