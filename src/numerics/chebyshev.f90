! SPDX-License-Identifier: GPL-3.0-or-later
!> Functions on (-1, 1) as sums of Chebyshev's polynomials, from their values at the roots of the next one:
!> ends, where a function may be known less well, are none of these.
module adfric_numerics_chebyshev
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   implicit none (type, external)
   private
   public :: degree, chebyshev_positions, coefficients_of, value_of, slope_of

   !> Degree of the sums.
   integer, parameter :: degree = 16

contains

   !> The positions, downwards.
   pure function chebyshev_positions() result(x)
      real(dp) :: x(0:degree)
      integer :: j

      x = [(sin(pi*(degree - 2*j)/(2*(degree + 1))), j=0, degree)]
   end function chebyshev_positions

   !> Coefficients of a function.
   pure function coefficients_of(values) result(c)
      !> Its values at the positions.
      real(dp), intent(in) :: values(0:degree)
      real(dp) :: c(0:degree)
      integer :: j, k

      do k = 0, degree
         c(k) = 2*sum([(values(j)*cos(pi*modulo(k*(2*j + 1), 4*(degree + 1))/(2*(degree + 1))), j=0, degree)])/(degree + 1)
      end do
      c(0) = c(0)/2
   end function coefficients_of

   !> The function (C. W. Clenshaw's recurrence).
   pure real(dp) function value_of(c, x) result(value)
      !> Coefficients.
      real(dp), intent(in) :: c(0:degree)
      !> Position, from -1 to 1.
      real(dp), intent(in) :: x
      real(dp) :: one, two, next
      integer :: k

      one = 0
      two = 0
      do k = degree, 1, -1
         next = c(k) + 2*x*one - two
         two = one
         one = next
      end do
      value = c(0) + x*one - two
   end function value_of

   !> Its derivative: T_k' = k U_(k-1), and U by the same recurrence.
   pure real(dp) function slope_of(c, x) result(slope)
      !> Coefficients.
      real(dp), intent(in) :: c(0:degree)
      !> Position, from -1 to 1.
      real(dp), intent(in) :: x
      real(dp) :: one, two, next
      integer :: k

      one = 0
      two = 0
      do k = degree, 1, -1
         next = k*c(k) + 2*x*one - two
         two = one
         one = next
      end do
      slope = one
   end function slope_of

end module adfric_numerics_chebyshev
