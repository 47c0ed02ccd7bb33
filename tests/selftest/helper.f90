! SPDX-License-Identifier: GPL-3.0-or-later
!> Stands for code under test and helpers that test files share.
module helper
   use, intrinsic :: iso_fortran_env, only: real64
   use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_quiet_nan, ieee_value
   implicit none (type, external)
   private
   public :: infinity, nan, hilbert

contains

   real(real64) function infinity()
      infinity = ieee_value(0.0_real64, ieee_positive_inf)
   end function infinity

   real(real64) function nan()
      nan = ieee_value(0.0_real64, ieee_quiet_nan)
   end function nan

   !> Hilbert matrix of order n.
   pure function hilbert(n) result(matrix)
      integer, intent(in) :: n
      real(real64) :: matrix(n, n)

      integer :: i, j

      do j = 1, n
         do i = 1, n
            matrix(i, j) = 1.0_real64/real(i + j - 1, real64)
         end do
      end do
   end function hilbert

end module helper
