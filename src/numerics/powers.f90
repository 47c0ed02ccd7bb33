! SPDX-License-Identifier: GPL-3.0-or-later
!> Roots of numbers.
module adfric_numerics_powers
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   implicit none (type, external)
   private
   public :: cube_root

contains

   !> Cube root of x >= 0, to round-off.
   elemental real(dp) function cube_root(x)
      !> Number whose root is taken, >= 0.
      real(dp), intent(in) :: x

      if (has_asserts) call assert(x >= 0, 'cube_root: x >= 0')
      cube_root = x**(1.0_dp/3)
      ! the exponent is not a third, which shows where x is large or small
      if (x > 0) cube_root = cube_root - (cube_root - x/cube_root**2)/3
   end function cube_root

end module adfric_numerics_powers
