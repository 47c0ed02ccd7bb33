! SPDX-License-Identifier: GPL-3.0-or-later
!> Heights along one period of a line, as polynomials between equidistant positions.
!>
!> The period is the unit of length. The surface slides to +x, so a column of the foundation meets it in the order of falling x:
!> s = -x is the way that the column has gone, and everything is in the order of s.
module adfric_shape_height_line
   use adfric_base_kinds, only: dp, i8
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_numerics_periodic_spline, only: get_spline_slopes
   use adfric_shape_hermite_pieces, only: cubic_piece, quintic_piece
   use adfric_shape_polynomial, only: polynomial_at, mirrored, get_piece_bounds, get_turning_positions
   use adfric_shape_wave_pieces, only: get_wave_pieces
   implicit none (type, external)
   private
   public :: height_line_t, new_cosine_line, new_sampled_line, linear_pieces, cubic_pieces, pieces_per_wave, same_height

   !> Interpolation between samples: chords, or the periodic cubic spline. The number is the degree.
   integer, parameter :: linear_pieces = 1, cubic_pieces = 3
   !> Pieces of a cosine line in its shortest wave. A quintic piece departs from a wave of amplitude 1 by
   !> (2 pi/256)^6/46080 = 5e-15 at most.
   integer, parameter :: pieces_per_wave = 256
   !> Degree of the pieces of a cosine line.
   integer, parameter :: quintic_pieces = 5
   !> Heights that differ by less than this share of the heights are the same but for round-off.
   real(dp), parameter :: same_height = 64*epsilon(1.0_dp)
   !> The fewest samples of a line, by the degree of its pieces.
   integer, parameter :: fewest_samples(5) = [2, 0, 4, 0, 1]

   !> Heights along one period of length 1, as polynomials between equidistant positions, in the order in which a column of the
   !> foundation meets them: x falls.
   type :: height_line_t
      !> Degree of the polynomials: 1, 3 or 5.
      integer :: degree = linear_pieces
      !> Shape `(0:degree, n)`. Piece j covers the way s = (j - 1 + theta)/n, theta = 0..1, from x = 0 on; its height is
      !> sum_m coefficients(m, j) theta^m [unit of the heights].
      real(dp), allocatable :: coefficients(:, :)
   contains
      procedure :: height_at
      procedure :: get_extremes
      procedure :: coarsen
      procedure :: reverse
      procedure :: rotate
   end type height_line_t

contains

   !> A sum of waves, z(x) = sum over m of a_m cos(2 pi m x + phi_m), m = 1, 2, ...: quintic pieces with the heights and the first
   !> two derivatives of the sum at their ends.
   pure subroutine new_cosine_line(self, amplitudes, phases)
      !> Receives the line, in `pieces_per_wave` pieces for each period of its shortest wave.
      type(height_line_t), intent(out) :: self
      !> Amplitudes a_m [unit of the heights]; the shortest wave is the last that is not 0.
      real(dp), intent(in) :: amplitudes(:)
      !> Phases phi_m [rad]; as many as amplitudes.
      real(dp), intent(in) :: phases(:)
      integer :: shortest

      if (has_asserts) call assert(size(amplitudes) == size(phases), 'new_cosine_line: a phase for each amplitude')
      shortest = max(1, findloc(abs(amplitudes) > 0, .true., dim=1, back=.true.))
      self%degree = quintic_pieces
      allocate (self%coefficients(0:quintic_pieces, pieces_per_wave*shortest))
      ! as a function of s = -x the phases count backwards
      call get_wave_pieces(amplitudes*cos(phases), amplitudes*sin(phases), self%coefficients)
   end subroutine new_cosine_line

   !> A line through samples at x = 0, 1/n, ..., (n - 1)/n.
   pure subroutine new_sampled_line(self, heights, interpolation)
      !> Receives the line, in as many pieces as samples.
      type(height_line_t), intent(out) :: self
      !> The samples, in the order of rising x; 2 or more, 4 or more for `cubic_pieces`. The first follows on the last.
      real(dp), intent(in) :: heights(:)
      !> Degree of the pieces: `linear_pieces` or `cubic_pieces`.
      integer, intent(in) :: interpolation
      integer :: n

      if (has_asserts) call assert(any(interpolation == [linear_pieces, cubic_pieces]), 'new_sampled_line: known pieces')
      if (has_asserts) call assert(size(heights) >= fewest_samples(interpolation), 'new_sampled_line: enough samples')
      n = size(heights)
      call connect(self, [heights(1), heights(n:2:-1)], interpolation)
   end subroutine new_sampled_line

   !> A line through samples in the order in which a column meets them.
   pure subroutine connect(self, heights, interpolation)
      !> Receives the line, in as many pieces as samples.
      type(height_line_t), intent(out) :: self
      !> The samples, in the order of rising s.
      real(dp), intent(in) :: heights(:)
      !> Degree of the pieces: `linear_pieces` or `cubic_pieces`.
      integer, intent(in) :: interpolation
      real(dp), allocatable :: slopes(:)
      integer :: n, j, next

      n = size(heights)
      self%degree = interpolation
      allocate (self%coefficients(0:interpolation, n), slopes(n))
      if (interpolation == cubic_pieces) call get_spline_slopes(heights, slopes)
      do j = 1, n
         next = merge(1, j + 1, j == n)
         if (interpolation == cubic_pieces) then
            self%coefficients(:, j) = cubic_piece(heights([j, next]), slopes([j, next]))
         else
            self%coefficients(:, j) = [heights(j), heights(next) - heights(j)]
         end if
      end do
   end subroutine connect

   !> Height of the line at a position.
   pure real(dp) function height_at(self, x)
      class(height_line_t), intent(in) :: self
      !> Position, in periods; any.
      real(dp), intent(in) :: x
      real(dp) :: path
      integer :: j

      path = modulo(-x, 1.0_dp)*size(self%coefficients, 2)
      j = min(int(path) + 1, size(self%coefficients, 2))
      height_at = polynomial_at(self%coefficients(:, j), path - (j - 1))
   end function height_at

   !> Lowest and highest height of the line itself, between its samples too.
   pure subroutine get_extremes(self, lowest, highest, highest_piece)
      class(height_line_t), intent(in) :: self
      !> Receives the lowest height.
      real(dp), intent(out) :: lowest
      !> Receives the highest height.
      real(dp), intent(out) :: highest
      !> Receives the number of the piece with the highest height, the first of those that are as high but for round-off.
      integer, intent(out) :: highest_piece
      real(dp) :: tops(size(self%coefficients, 2)), low, high, positions(4)
      integer :: j, i, n_positions

      lowest = minval(self%coefficients(0, :))
      tops = self%coefficients(0, :)
      highest = maxval(tops)
      do j = 1, size(tops)
         call get_piece_bounds(self%coefficients(:, j), low, high)
         if (low >= lowest .and. high <= highest) cycle
         call get_turning_positions(self%coefficients(:, j), positions, n_positions)
         do i = 1, n_positions
            lowest = min(lowest, polynomial_at(self%coefficients(:, j), positions(i)))
            tops(j) = max(tops(j), polynomial_at(self%coefficients(:, j), positions(i)))
         end do
         highest = max(highest, tops(j))
      end do
      highest_piece = findloc(tops >= highest - same_height*(highest - lowest + max(abs(lowest), abs(highest))), .true., dim=1)
   end subroutine get_extremes

   !> The line that half as many samples give, for an estimate of what the interpolation costs: every second one where their number
   !> n is even; else heights of the line at (n + 1)/2 equidistant positions. Where that are too few, as many as are needed.
   pure subroutine coarsen(self, coarse)
      class(height_line_t), intent(in) :: self
      !> Receives the line with fewer pieces, of the same degree and from the same x = 0 on.
      type(height_line_t), intent(out) :: coarse
      real(dp), allocatable :: taylor(:, :)
      integer :: n, k

      n = max((size(self%coefficients, 2) + 1)/2, fewest_samples(self%degree))
      allocate (taylor(0:2, n))
      do k = 1, n
         call get_taylor(self, k - 1, n, taylor(:, k))
      end do
      if (self%degree == quintic_pieces) then
         coarse%degree = quintic_pieces
         allocate (coarse%coefficients(0:quintic_pieces, n))
         do k = 1, n
            coarse%coefficients(:, k) = quintic_piece(taylor(:, k), taylor(:, modulo(k, n) + 1))
         end do
      else
         call connect(coarse, taylor(0, :), self%degree)
      end if
   end subroutine coarsen

   !> Height and derivatives at one of n equidistant positions, of a variable that grows by 1 from each position to the next.
   pure subroutine get_taylor(self, k, n, taylor)
      type(height_line_t), intent(in) :: self
      !> The position is s = k/n, k = 0..n - 1.
      integer, intent(in) :: k
      !> Number of positions.
      integer, intent(in) :: n
      !> Receives the height, its first derivative, and half its second one.
      real(dp), intent(out) :: taylor(0:2)
      real(dp) :: theta, widening
      integer(i8) :: path
      integer :: m, j

      path = int(k, i8)*size(self%coefficients, 2)
      j = int(path/n) + 1
      theta = real(modulo(path, int(n, i8)), dp)/n
      widening = real(size(self%coefficients, 2), dp)/n
      ! Horner's scheme, with the Taylor polynomial of the second degree as number
      taylor = 0
      do m = self%degree, 0, -1
         taylor(2) = taylor(2)*theta + taylor(1)
         taylor(1) = taylor(1)*theta + taylor(0)
         taylor(0) = taylor(0)*theta + self%coefficients(m, j)
      end do
      taylor = taylor*[1.0_dp, widening, widening**2]
   end subroutine get_taylor

   !> The line crossed from its end to its start: x becomes -x.
   pure subroutine reverse(self)
      class(height_line_t), intent(inout) :: self
      real(dp), allocatable :: reversed(:, :)
      integer :: n, j

      n = size(self%coefficients, 2)
      allocate (reversed(0:self%degree, n))
      do j = 1, n
         reversed(:, j) = mirrored(self%coefficients(:, n + 1 - j))
      end do
      call move_alloc(reversed, self%coefficients)
   end subroutine reverse

   !> Begin the way at another piece: x = 0 moves to where that piece begins, x = -(first - 1)/n.
   pure subroutine rotate(self, first)
      class(height_line_t), intent(inout) :: self
      !> The piece that becomes the first, 1 to n.
      integer, intent(in) :: first

      if (has_asserts) call assert(first >= 1 .and. first <= size(self%coefficients, 2), 'rotate: one of the pieces')
      self%coefficients(:, :) = cshift(self%coefficients, first - 1, dim=2)
   end subroutine rotate

end module adfric_shape_height_line
