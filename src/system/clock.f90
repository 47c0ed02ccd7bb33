! SPDX-License-Identifier: GPL-3.0-or-later
!> The time that passes.
module adfric_system_clock
   use adfric_base_kinds, only: dp, i8
   implicit none (type, external)
   private
   public :: wall_clock

contains

   !> Seconds since some moment; only differences mean something.
   real(dp) function wall_clock()
      integer(i8) :: count, rate

      call system_clock(count, rate)
      wall_clock = real(count, dp)/real(rate, dp)
   end function wall_clock

end module adfric_system_clock
