! SPDX-License-Identifier: GPL-3.0-or-later
!> The pieces of a curve of JKR on a spring: ranges where m/q rises, or falls, m = sqrt(a) g'(a), q = (1 + 3 y)/(2 (1 + y)), y = 2 s a
!> with the compliance s of the spring; a state is stable where m/q > sqrt(2 pi W).
!>
!> q rises with a, and r = d(ln q)/d(ln a) = 2 y/((1 + 3 y) (1 + y)) is nowhere above 2/(1 + sqrt(3))^2 = 0.268, which it has at
!> y = 1/sqrt(3). So where m falls, m/q falls; and where h = d(ln m)/d(ln a) = 1/2 + a g''/g' is at least 0.268, m/q rises: everywhere
!> if g' never falls, where h >= 1/2, and for r^n from n = 0.768 on. Two sorts of pieces are left:
!>
!> - r^n with n < 0.768: h = n - 1/2 is constant, and r, which rises and falls, is h at two positions, on both sides of y =
!> 1/sqrt(3);
!> - beyond the position where m of `flat_cone`, `flat_paraboloid` or `rounded_cone` is least: h rises from 0, where it is below
!> 0.27
!>   with a slope dh/d(ln a) of at least 1.0, 11.8 and 1.4, and stays above; that of r is at most 0.101. So h - r has one root.
module adfric_round_spring_pieces
   use adfric_base_kinds, only: dp
   use adfric_round_shape, only: shape_t, spot_t, piece_t, most_pieces
   implicit none (type, external)
   private
   public :: divide_pieces, most_divided_pieces

   !> Most pieces on a spring.
   integer, parameter :: most_divided_pieces = most_pieces + 2
   !> Most doublings of a position, and halvings of a range.
   integer, parameter :: most_doublings = 1000, most_halvings = 60

contains

   !> Divide the pieces of a shape where m/q turns.
   pure subroutine divide_pieces(shape, compliance, pieces, n)
      class(shape_t), intent(in) :: shape
      !> Compliance of the spring, > 0.
      real(dp), intent(in) :: compliance
      !> In: pieces where m rises or falls. Out: where m/q does.
      type(piece_t), intent(inout) :: pieces(most_divided_pieces)
      integer, intent(inout) :: n
      real(dp) :: steepest, low, high
      integer :: k

      if (shape%has_rising_slope) return
      ! the last piece alone, which has no end, rises slowly
      low = pieces(n)%low
      steepest = shape%unknown_of(max(1/(2*sqrt(3.0_dp)*compliance), shape%corner))
      if (low > 0) then
         high = max(2*low, steepest)
         do k = 1, most_doublings
            if (excess(shape, compliance, high) > 0) exit
            high = 2*high
         end do
         call divide_last(pieces, n, turn_between(shape, compliance, low, high))
      else if (excess(shape, compliance, steepest) < 0) then
         low = steepest
         high = steepest
         do k = 1, most_doublings
            if (.not. excess(shape, compliance, low) > 0) low = low/2
            if (.not. excess(shape, compliance, high) > 0) high = 2*high
         end do
         call divide_last(pieces, n, turn_between(shape, compliance, steepest, low))
         call divide_last(pieces, n, turn_between(shape, compliance, steepest, high))
      end if
   end subroutine divide_pieces

   !> Divide the last piece.
   pure subroutine divide_last(pieces, n, position)
      type(piece_t), intent(inout) :: pieces(:)
      !> Their number, which grows by 1.
      integer, intent(inout) :: n
      !> Where, within the last piece.
      real(dp), intent(in) :: position

      pieces(n + 1) = pieces(n)
      pieces(n)%high = position
      pieces(n + 1)%low = position
      n = n + 1
   end subroutine divide_last

   !> (h - r) da/du / a, which has the sign of the slope of m/q.
   pure real(dp) function excess(shape, compliance, u)
      class(shape_t), intent(in) :: shape
      !> Compliance of the spring.
      real(dp), intent(in) :: compliance
      !> The unknown, beyond the corner, > 0.
      real(dp), intent(in) :: u
      type(spot_t) :: spot
      real(dp) :: y

      call shape%evaluate(u, .true., spot)
      y = 2*compliance*spot%radius
      excess = spot%radius_slope/spot%radius*(0.5_dp - 2*(y/(1 + 3*y))/(1 + y)) + spot%depth_curve/spot%depth_slope &
         & - spot%radius_curve/spot%radius_slope
   end function excess

   !> Where the slope of m/q changes its sign.
   pure real(dp) function turn_between(shape, compliance, falling, rising) result(turn)
      class(shape_t), intent(in) :: shape
      real(dp), intent(in) :: compliance
      !> Positions > 0 where m/q falls, and where it rises.
      real(dp), intent(in) :: falling, rising
      real(dp) :: ends(2)
      integer :: k

      ends = [falling, rising]
      do k = 1, most_halvings
         turn = sqrt(ends(1))*sqrt(ends(2))
         ends(merge(2, 1, excess(shape, compliance, turn) > 0)) = turn
      end do
   end function turn_between

end module adfric_round_spring_pieces
