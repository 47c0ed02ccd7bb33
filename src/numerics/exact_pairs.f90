! SPDX-License-Identifier: GPL-3.0-or-later
!> Sums, products and quotients of two numbers as a pair: the rounded value and what the rounding left.
!>
!> The pair of a sum or a product is exact (T. J. Dekker, Numerische Mathematik 18, 224, 1971), that of a quotient is right to about
!> the square of `epsilon`. No product may exceed 1e300. They hold as long as a compiler keeps the order of the operations.
module adfric_numerics_exact_pairs
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: get_sum, get_product, get_quotient

   !> Cuts a number into two halves of 26 bits.
   real(dp), parameter :: splitter = 2.0_dp**27 + 1

contains

   !> x + y = total + rest, exactly.
   elemental subroutine get_sum(x, y, total, rest)
      !> The numbers, in any order of their sizes.
      real(dp), intent(in) :: x, y
      !> The rounded sum.
      real(dp), intent(out) :: total
      !> What the rounding left.
      real(dp), intent(out) :: rest
      real(dp) :: share

      total = x + y
      share = total - x
      rest = (x - (total - share)) + (y - share)
   end subroutine get_sum

   !> x y = total + rest, exactly.
   elemental subroutine get_product(x, y, total, rest)
      !> The numbers.
      real(dp), intent(in) :: x, y
      !> The rounded product.
      real(dp), intent(out) :: total
      !> What the rounding left.
      real(dp), intent(out) :: rest
      real(dp) :: x_high, x_low, y_high, y_low

      total = x*y
      call halve(x, x_high, x_low)
      call halve(y, y_high, y_low)
      rest = ((x_high*y_high - total) + x_high*y_low + x_low*y_high) + x_low*y_low
   end subroutine get_product

   !> (x + x_rest)/(y + y_rest) = total + rest, nearly.
   elemental subroutine get_quotient(x, x_rest, y, y_rest, total, rest)
      !> The dividend, a pair.
      real(dp), intent(in) :: x, x_rest
      !> The divisor, a pair that is not zero.
      real(dp), intent(in) :: y, y_rest
      !> The rounded quotient.
      real(dp), intent(out) :: total
      !> What remains.
      real(dp), intent(out) :: rest
      real(dp) :: back, back_rest

      total = x/y
      call get_product(total, y, back, back_rest)
      rest = ((((x - back) - back_rest) + x_rest) - total*y_rest)/y
   end subroutine get_quotient

   !> x = high + low, each with half of the bits.
   elemental subroutine halve(x, high, low)
      !> The number.
      real(dp), intent(in) :: x
      !> Its leading half.
      real(dp), intent(out) :: high
      !> The other half.
      real(dp), intent(out) :: low
      real(dp) :: lifted

      lifted = splitter*x
      high = lifted - (lifted - x)
      low = x - high
   end subroutine halve

end module adfric_numerics_exact_pairs
