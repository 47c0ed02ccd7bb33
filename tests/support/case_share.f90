! SPDX-License-Identifier: GPL-3.0-or-later
! How many of many alike cases a test is to take.
module case_share
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: share_of_cases, number_of_cases, whole_or_part

contains

   !> The share of its cases that a test takes: ADFRIC_RANDOM_CASES where checks make them slow; 1 if it is not set.
   real(dp) function share_of_cases() result(share)
      character(20) :: text
      integer :: length

      share = 1
      call get_environment_variable('ADFRIC_RANDOM_CASES', text, length)
      if (length > 0) read (text, *) share
   end function share_of_cases

   !> So many of `n` random cases that a test takes, at least one.
   integer function number_of_cases(n)
      integer, intent(in) :: n

      number_of_cases = max(1, nint(n*share_of_cases()))
   end function number_of_cases

   !> A number that a test takes, or a smaller one where it takes a part of its cases.
   integer function whole_or_part(whole, part) result(number)
      integer, intent(in) :: whole, part

      number = merge(part, whole, share_of_cases() < 1)
   end function whole_or_part

end module case_share
