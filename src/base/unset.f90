! SPDX-License-Identifier: GPL-3.0-or-later
!> The mark of a value that the user has not given.
!>
!> A quiet NaN would trap under -ffpe-trap=invalid, so the largest number stands for `not given`.
module adfric_base_unset
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: unset, is_set

   !> Not given.
   real(dp), parameter :: unset = huge(1.0_dp)

contains

   !> Has the value been given?
   elemental logical function is_set(value)
      !> Value of a variable, or `unset`.
      real(dp), intent(in) :: value

      is_set = value < unset
   end function is_set

end module adfric_base_unset
