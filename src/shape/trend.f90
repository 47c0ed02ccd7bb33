! SPDX-License-Identifier: GPL-3.0-or-later
!> What of measured heights is tilt and not surface.
module adfric_shape_trend
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   implicit none (type, external)
   private
   public :: remove_trend, trend_none, trend_mean, trend_line

   !> What is subtracted: nothing, the mean height, or the straight line of least squares (of a map: the plane).
   integer, parameter :: trend_none = 1, trend_mean = 2, trend_line = 3

contains

   !> Subtract the mean height, or the plane of least squares, mean + a (x - mean x) + b (y - mean y). On a grid the three terms are
   !> orthogonal: a = sum of (x - mean x) z / sum of (x - mean x)^2, and b likewise. Rows are not levelled by themselves, since that
   !> would change their heights against each other.
   pure subroutine remove_trend(heights, trend)
      !> In: heights of equidistant samples, shape `(nx, ny)`; a line is one row, `(n, 1)`. Out: without the trend.
      real(dp), intent(inout) :: heights(:, :)
      !> `trend_none`, `trend_mean` or `trend_line`.
      integer, intent(in) :: trend
      real(dp) :: x(size(heights, 1)), y(size(heights, 2)), a, b
      integer :: j

      if (has_asserts) call assert(any(trend == [trend_none, trend_mean, trend_line]), 'remove_trend: a known trend')
      if (trend == trend_none) return
      heights = heights - sum(heights)/size(heights)
      if (trend == trend_mean) return
      x = centred(size(x))
      y = centred(size(y))
      a = slope_of(sum(heights, dim=2)/size(y), x)
      b = slope_of(sum(heights, dim=1)/size(x), y)
      do j = 1, size(y)
         heights(:, j) = heights(:, j) - a*x - b*y(j)
      end do
   end subroutine remove_trend

   !> Equidistant positions at distance 1 about 0.
   pure function centred(n) result(positions)
      !> Number of positions.
      integer, intent(in) :: n
      real(dp) :: positions(n)
      integer :: i

      positions = [(i - (n + 1)/2.0_dp, i=1, n)]
   end function centred

   !> Slope of the straight line of least squares.
   pure real(dp) function slope_of(z, x) result(slope)
      !> Heights.
      real(dp), intent(in) :: z(:)
      !> Their positions, about 0; as many.
      real(dp), intent(in) :: x(:)

      ! one position has no slope
      slope = 0
      if (size(x) > 1) slope = dot_product(x, z)/dot_product(x, x)
   end function slope_of

end module adfric_shape_trend
