! SPDX-License-Identifier: GPL-3.0-or-later
!> Number kinds used throughout.
module adfric_base_kinds
   use, intrinsic :: iso_fortran_env, only: real64, int64
   implicit none (type, external)
   private
   public :: dp, i8

   !> Working precision.
   integer, parameter :: dp = real64
   !> Counts of points, bytes and file positions.
   integer, parameter :: i8 = int64

end module adfric_base_kinds
