! SPDX-License-Identifier: GPL-3.0-or-later
!> What the procedures of this folder hold their arguments against, and how they say what has become of them.
module adfric_contact_arguments
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: lies_between, status_bad_argument, largest_ratio

   !> A status beside those of `adfric_describe_status`: an argument is NaN or not allowed, and nothing was solved.
   integer, parameter :: status_bad_argument = -2
   !> A reduced number above this, or positive and below its inverse, comes from a slip in the units.
   real(dp), parameter :: largest_ratio = 1.0e30_dp

contains

   !> Is a number within its bounds? NaN is not.
   elemental logical function lies_between(value, lower, upper)
      !> Any number, or NaN.
      real(dp), intent(in) :: value
      !> Least value that is allowed.
      real(dp), intent(in) :: lower
      !> Greatest value that is allowed.
      real(dp), intent(in) :: upper

      lies_between = ieee_is_finite(value)
      if (lies_between) lies_between = value >= lower .and. value <= upper
   end function lies_between

end module adfric_contact_arguments
