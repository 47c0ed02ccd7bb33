! SPDX-License-Identifier: GPL-3.0-or-later
!> The numbers from which a table gets the indices of its rows.
!>
!> A table names its rows as the integer components of a type, in order, and has the constant `transfer(counting, names_t())` of it: the
!> compiler numbers them, so a row that is added or moved has its index everywhere.
module adfric_base_counting
   implicit none (type, external)
   private
   public :: counting

   integer, parameter :: ten(10) = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]
   !> The whole numbers from 1, for more rows than any table has.
   integer, parameter :: counting(100) = [ten, ten + 10, ten + 20, ten + 30, ten + 40, ten + 50, ten + 60, ten + 70, ten + 80, &
      & ten + 90]

end module adfric_base_counting
