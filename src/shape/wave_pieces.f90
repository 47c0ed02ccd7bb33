! SPDX-License-Identifier: GPL-3.0-or-later
!> Sums of waves as quintic pieces.
module adfric_shape_wave_pieces
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_constants, only: two_pi
   implicit none (type, external)
   private
   public :: get_wave_pieces

   !> The last term of the series for the coefficients of a wave; with 256 pieces a wave it is (2 pi/256)^13/13! = 1e-31.
   integer, parameter :: last_term = 13

contains

   !> Coefficients of the n quintic pieces of the sum over m of a_m cos(2 pi m s) + b_m sin(2 pi m s), s = 0..1, with the heights
   !> and the first two derivatives of the sum at their ends.
   pure subroutine get_wave_pieces(a, b, coefficients)
      !> Amplitudes of the cosines, m = 1, 2, ....
      real(dp), intent(in) :: a(:)
      !> Amplitudes of the sines; as many.
      real(dp), intent(in) :: b(:)
      !> Receives the coefficients of theta^0 to theta^5; shape `(0:5, n)`, n is a multiple of 8 and larger than every m.
      real(dp), intent(out) :: coefficients(0:, :)
      real(dp), allocatable :: circle(:, :)
      integer :: m

      if (has_asserts) call assert(modulo(size(coefficients, 2), 8) == 0, 'get_wave_pieces: a multiple of 8 pieces')
      allocate (circle(2, 0:size(coefficients, 2) - 1))
      call get_circle(circle)
      coefficients = 0
      do m = 1, size(a)
         if (abs(a(m)) + abs(b(m)) > 0) call add_wave(circle, m, [a(m), b(m)], coefficients)
      end do
   end subroutine get_wave_pieces

   !> Cosines and sines of n equidistant angles of the circle, to round-off of each.
   pure subroutine get_circle(circle)
      !> Receives cosine and sine of 2 pi k/n in `circle(:, k)`, k = 0..n - 1; n is a multiple of 8.
      real(dp), intent(out) :: circle(:, 0:)
      integer :: n, k

      n = size(circle, 2)
      do k = 0, n/8
         circle(:, k) = [cos(two_pi*k/n), sin(two_pi*k/n)]
      end do
      ! the other angles of the quarter by the diagonal, those of the circle by turning the quarter
      do k = n/8 + 1, n/4 - 1
         circle(:, k) = circle(2:1:-1, n/4 - k)
      end do
      do k = n/4, n - 1
         circle(:, k) = [-circle(2, k - n/4), circle(1, k - n/4)]
      end do
   end subroutine get_circle

   !> Add a wave a cos(2 pi m s) + b sin(2 pi m s) to quintic pieces.
   pure subroutine add_wave(circle, m, amplitude, coefficients)
      !> Cosines and sines of 2 pi k/n, shape `(2, 0:n - 1)`.
      real(dp), intent(in) :: circle(:, 0:)
      !> Number of waves in the period.
      integer, intent(in) :: m
      !> The amplitudes a and b.
      real(dp), intent(in) :: amplitude(2)
      !> Coefficients of n pieces, to which those of the wave are added; shape `(0:5, n)`.
      real(dp), intent(inout) :: coefficients(0:, :)
      real(dp) :: factors(0:5, 2)
      integer :: k, angle

      factors = wave_factors(two_pi*m/size(coefficients, 2), amplitude)
      angle = 0
      do k = 1, size(coefficients, 2)
         coefficients(:, k) = coefficients(:, k) + factors(:, 1)*circle(1, angle) + factors(:, 2)*circle(2, angle)
         ! the angle modulo the circle, in whole numbers
         angle = angle + m
         if (angle >= size(coefficients, 2)) angle = angle - size(coefficients, 2)
      end do
   end subroutine add_wave

   !> Coefficients of the quintic piece that begins at an angle alpha of a wave a cos + b sin: sum of factors(:, 1) cos alpha and
   !> factors(:, 2) sin alpha.
   !>
   !> The quintic with the heights and two derivatives of theta^p at both ends is
   !> [(p - 4)(p - 5) theta^3 - 2 (p - 3)(p - 5) theta^4 + (p - 3)(p - 4) theta^5]/2, p >= 3. It is taken for each term of the
   !> Taylor series of the wave, since differences of the values at the ends would lose digits.
   pure function wave_factors(step, amplitude) result(factors)
      !> Angle that a piece covers [rad].
      real(dp), intent(in) :: step
      !> The amplitudes a and b.
      real(dp), intent(in) :: amplitude(2)
      real(dp) :: factors(0:5, 2), term(2)
      integer :: p

      ! term: the p-th derivative of the wave times step^p/p!, as amplitudes of cos alpha and sin alpha
      factors = 0
      term = amplitude
      do p = 0, last_term
         if (p > 0) term = [term(2), -term(1)]*(step/p)
         if (p < 3) then
            factors(p, :) = term
         else
            factors(3, :) = factors(3, :) + term*((p - 4)*(p - 5)/2)
            factors(4, :) = factors(4, :) - term*((p - 3)*(p - 5))
            factors(5, :) = factors(5, :) + term*((p - 3)*(p - 4)/2)
         end if
      end do
   end function wave_factors

end module adfric_shape_wave_pieces
