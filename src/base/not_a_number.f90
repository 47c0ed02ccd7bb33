! SPDX-License-Identifier: GPL-3.0-or-later
!> The mark of a result without a value.
module adfric_base_not_a_number
   use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_quiet_nan
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: not_a_number

contains

   !> A quiet NaN, which stands for `no value`.
   pure real(dp) function not_a_number()
      not_a_number = ieee_value(1.0_dp, ieee_quiet_nan)
   end function not_a_number

end module adfric_base_not_a_number
