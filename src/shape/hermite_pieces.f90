! SPDX-License-Identifier: GPL-3.0-or-later
!> Polynomials in theta = 0..1 that have given heights and derivatives at both ends (Hermite's interpolation).
module adfric_shape_hermite_pieces
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: cubic_piece, quintic_piece

contains

   !> The cubic with given heights and slopes.
   pure function cubic_piece(heights, slopes) result(c)
      !> Heights at theta = 0 and 1.
      real(dp), intent(in) :: heights(2)
      !> Derivatives by theta at 0 and 1.
      real(dp), intent(in) :: slopes(2)
      real(dp) :: c(0:3), rise

      rise = heights(2) - heights(1)
      c = [heights(1), slopes(1), 3*rise - 2*slopes(1) - slopes(2), slopes(1) + slopes(2) - 2*rise]
   end function cubic_piece

   !> The quintic with given heights and two derivatives.
   pure function quintic_piece(first, last) result(c)
      !> Height, derivative by theta and half the second derivative at theta = 0.
      real(dp), intent(in) :: first(0:2)
      !> The same at theta = 1.
      real(dp), intent(in) :: last(0:2)
      real(dp) :: c(0:5), rest(0:2)

      ! what the terms up to theta^2 leave at theta = 1
      rest = last - [sum(first), first(1) + 2*first(2), first(2)]
      c(:2) = first
      c(3:) = [10*rest(0) - 4*rest(1) + rest(2), -15*rest(0) + 7*rest(1) - 2*rest(2), 6*rest(0) - 3*rest(1) + rest(2)]
   end function quintic_piece

end module adfric_shape_hermite_pieces
