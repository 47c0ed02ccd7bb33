! SPDX-License-Identifier: GPL-3.0-or-later
!> Polynomials in theta = 0..1, as pieces of a line of heights are.
module adfric_shape_polynomial
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: polynomial_at, mirrored, get_piece_bounds, get_turning_positions

   !> Largest of theta - theta^m in 0..1, for m = 2 to 5.
   real(dp), parameter :: sag(2:5) = [0.25_dp, 0.3849002_dp, 0.4724704_dp, 0.5349923_dp]
   !> Halvings of an interval until it is as small as round-off.
   integer, parameter :: most_halvings = 60

contains

   !> Value of a polynomial.
   pure real(dp) function polynomial_at(c, theta) result(value)
      !> Coefficients, from that of theta^0.
      real(dp), intent(in) :: c(0:)
      !> Position, 0 to 1.
      real(dp), intent(in) :: theta
      integer :: m

      value = c(ubound(c, 1))
      do m = ubound(c, 1) - 1, 0, -1
         value = value*theta + c(m)
      end do
   end function polynomial_at

   !> The polynomial in 1 - theta that is the same curve.
   pure function mirrored(c) result(other)
      !> Coefficients, from that of theta^0.
      real(dp), intent(in) :: c(0:)
      real(dp) :: other(0:ubound(c, 1))
      integer :: m, k

      ! p(1 - theta) by Horner's scheme, with polynomials in theta as numbers
      other = 0
      do k = ubound(c, 1), 0, -1
         do m = ubound(c, 1), 1, -1
            other(m) = other(m) - other(m - 1)
         end do
         other(0) = other(0) + c(k)
      end do
   end function mirrored

   !> Bounds between which a polynomial of degree 5 or less stays: those of its chord, and of what it departs from it at most.
   pure subroutine get_piece_bounds(c, low, high)
      !> Coefficients, from that of theta^0.
      real(dp), intent(in) :: c(0:)
      !> Receives a height that the polynomial does not fall below.
      real(dp), intent(out) :: low
      !> Receives a height that the polynomial does not rise above.
      real(dp), intent(out) :: high
      real(dp) :: at_end, departure

      at_end = sum(c)
      departure = sum(sag(2:ubound(c, 1))*abs(c(2:)))
      low = min(c(0), at_end) - departure
      high = max(c(0), at_end) + departure
   end subroutine get_piece_bounds

   !> Positions in 0..1 where a polynomial turns from rising to falling or the other way.
   pure subroutine get_turning_positions(c, positions, n_positions)
      !> Coefficients, from that of theta^0, of degree 1 or more.
      real(dp), intent(in) :: c(0:)
      !> Receives the positions, rising, in `positions(1:n_positions)`; shape `(2)` or, if that is more, one less than the degree.
      real(dp), intent(out) :: positions(:)
      !> Receives the number of positions.
      integer, intent(out) :: n_positions
      real(dp) :: derivative(0:max(2, ubound(c, 1))), ends(ubound(c, 1) + 1)
      integer :: degree, order

      degree = ubound(c, 1)
      derivative = 0
      call differentiate(c, max(1, degree - 2), derivative(:min(2, degree - 1)))
      call get_quadratic_roots(derivative(:2), positions, n_positions)
      ! between two neighbouring roots of its derivative a polynomial has one root at most
      do order = degree - 3, 1, -1
         call differentiate(c, order, derivative(:degree - order))
         ends(:n_positions + 2) = [0.0_dp, positions(:n_positions), 1.0_dp]
         call get_roots_between(derivative(:degree - order), ends(:n_positions + 2), positions, n_positions)
      end do
   end subroutine get_turning_positions

   !> Roots of a polynomial of degree 2 or less in 0..1.
   pure subroutine get_quadratic_roots(c, roots, n_roots)
      !> Coefficients of theta^0 to theta^2.
      real(dp), intent(in) :: c(0:)
      !> Receives the roots, rising, in `roots(1:n_roots)`.
      real(dp), intent(inout) :: roots(:)
      !> Receives the number of roots.
      integer, intent(out) :: n_roots
      real(dp) :: discriminant, q

      n_roots = 0
      discriminant = c(1)**2 - 4*c(0)*c(2)
      if (discriminant < 0) return
      ! the roots are c0/q and q/c2, both without a difference of nearly equal numbers
      q = -(c(1) + sign(sqrt(discriminant), c(1)))/2
      call keep_quotient(c(0), q, roots, n_roots)
      call keep_quotient(q, c(2), roots, n_roots)
      if (n_roots == 2) roots(:2) = [minval(roots(:2)), maxval(roots(:2))]
   end subroutine get_quadratic_roots

   !> Add a quotient to a list if it is in 0..1.
   pure subroutine keep_quotient(numerator, denominator, list, n_list)
      !> The quotient is `numerator/denominator`.
      real(dp), intent(in) :: numerator, denominator
      !> In and out: the list, in `list(1:n_list)`.
      real(dp), intent(inout) :: list(:)
      !> In and out: the length of the list.
      integer, intent(inout) :: n_list

      ! the quotient is not asked for where it could overflow; 0/0 belongs to a polynomial that vanishes, and is no root
      if (abs(numerator) > abs(denominator) .or. .not. abs(denominator) > 0) return
      if (numerator/denominator < 0) return
      n_list = n_list + 1
      list(n_list) = numerator/denominator
   end subroutine keep_quotient

   !> A derivative of a polynomial.
   pure subroutine differentiate(c, order, derivative)
      !> Coefficients, from that of theta^0.
      real(dp), intent(in) :: c(0:)
      !> Order of the derivative, 1 or more.
      integer, intent(in) :: order
      !> Receives the coefficients of the derivative, `order` fewer than those of the polynomial.
      real(dp), intent(out) :: derivative(0:)
      integer :: m, k

      do m = 0, ubound(derivative, 1)
         derivative(m) = c(m + order)
         do k = m + 1, m + order
            derivative(m) = derivative(m)*k
         end do
      end do
   end subroutine differentiate

   !> Roots at which a polynomial changes its sign, one at most in each of some intervals.
   pure subroutine get_roots_between(c, ends, roots, n_roots)
      !> Coefficients, from that of theta^0.
      real(dp), intent(in) :: c(0:)
      !> Ends of the intervals, rising.
      real(dp), intent(in) :: ends(:)
      !> Receives the roots, rising, in `roots(1:n_roots)`.
      real(dp), intent(inout) :: roots(:)
      !> Receives the number of roots.
      integer, intent(out) :: n_roots
      integer :: i

      n_roots = 0
      do i = 1, size(ends) - 1
         if ((polynomial_at(c, ends(i)) > 0) .eqv. (polynomial_at(c, ends(i + 1)) > 0)) cycle
         n_roots = n_roots + 1
         roots(n_roots) = root_between(c, ends(i), ends(i + 1))
      end do
   end subroutine get_roots_between

   !> The position at which a polynomial changes its sign, by halving the interval: it is asked for few pieces only.
   pure real(dp) function root_between(c, first, last) result(root)
      !> Coefficients, from that of theta^0.
      real(dp), intent(in) :: c(0:)
      !> Ends of the interval; the polynomial is positive at one of them only.
      real(dp), intent(in) :: first, last
      real(dp) :: left, right
      integer :: halving
      logical :: falls

      left = first
      right = last
      falls = polynomial_at(c, first) > 0
      do halving = 1, most_halvings
         root = left + (right - left)/2
         if ((polynomial_at(c, root) > 0) .eqv. falls) then
            left = root
         else
            right = root
         end if
      end do
   end function root_between

end module adfric_shape_polynomial
