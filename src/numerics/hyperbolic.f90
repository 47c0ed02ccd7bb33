! SPDX-License-Identifier: GPL-3.0-or-later
!> Differences of hyperbolic functions that keep their digits where the argument is small.
module adfric_numerics_hyperbolic
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   implicit none (type, external)
   private
   public :: sinh_minus_argument

contains

   !> sinh x - x for x >= 0.
   elemental real(dp) function sinh_minus_argument(x)
      !> Argument of the function [-], >= 0.
      real(dp), intent(in) :: x
      integer :: k
      real(dp) :: y, term

      if (has_asserts) call assert(x >= 0, 'sinh_minus_argument: x >= 0')
      if (x >= 1) then
         sinh_minus_argument = sinh(x) - x
         return
      end if
      ! sum of x^(2k+1)/(2k+1)!
      y = x*x
      term = x*y/6
      sinh_minus_argument = 0
      do k = 1, 9
         sinh_minus_argument = sinh_minus_argument + term
         term = term*y/((2*k + 2)*(2*k + 3))
      end do
   end function sinh_minus_argument

end module adfric_numerics_hyperbolic
