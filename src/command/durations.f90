! SPDX-License-Identifier: GPL-3.0-or-later
!> Times as people say them.
module adfric_command_durations
   use adfric_base_kinds, only: dp
   use adfric_base_text, only: show_count
   implicit none (type, external)
   private
   public :: show_duration

   !> Units, and how long they are [s].
   character(*), parameter :: units(*) = [character(6) :: 'second', 'minute', 'hour', 'day', 'year']
   real(dp), parameter :: sizes(*) = [1.0_dp, 60.0_dp, 3600.0_dp, 86400.0_dp, 31557600.0_dp]

contains

   !> A time in words, such as `less than a second`, `3 minutes` or `20 days`: as many units as there are, without more digits
   !> than an estimate has.
   pure function show_duration(seconds) result(text)
      !> The time [s], >= 0.
      real(dp), intent(in) :: seconds
      character(:), allocatable :: text
      real(dp), parameter :: many = 1.0e9_dp
      real(dp) :: number
      integer :: k

      if (seconds < sizes(1)) then
         text = 'less than a second'
         return
      end if
      k = 1
      do while (k < size(sizes))
         ! 60 seconds are called a minute, and so are 59.7
         if (rounded(seconds/sizes(k))*sizes(k) < sizes(k + 1)) exit
         k = k + 1
      end do
      number = rounded(seconds/sizes(k))
      if (number > many) then
         text = 'more than '//show_count(nint(many))//' years'
      else
         text = show_count(nint(number))//' '//trim(units(k))
         if (nint(number) /= 1) text = text//'s'
      end if
   end function show_duration

   !> A number as an integer: below 20 itself, then multiples of 5, 10, 50 and so on, less than 20 of each.
   pure real(dp) function rounded(number)
      !> The number of units, >= 0.
      real(dp), intent(in) :: number
      real(dp), parameter :: most_steps = 20
      real(dp) :: step, factor

      step = 1
      factor = 5
      do while (number/step >= most_steps)
         step = factor*step
         factor = 10/factor
      end do
      rounded = anint(number/step)*step
   end function rounded

end module adfric_command_durations
