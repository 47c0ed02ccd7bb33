! SPDX-License-Identifier: GPL-3.0-or-later
!> Displacement of the surface of an elastic half-space in the middles of equal cells, under pressure on one of them.
!>
!> A pressure of E* on a rectangle of the sides 2a, 2b makes at (x, y) from its centre the displacement (A. E. H. Love, Phil. Trans.
!> R. Soc. Lond. A 228, 1929, 377)
!>
!>     u = (1/pi) [G(x + a, y + b) - G(x - a, y + b) - G(x + a, y - b) + G(x - a, y - b)],
!>     G(x, y) = x arsinh(y/|x|) + y arsinh(x/|y|).
!>
!> Far from the cell the terms cancel. There its pressure acts as a force with moments: the mean of 1/r over the rectangle is
!>
!>     D (1/r),   D = 1 + a^2/6 d_xx + b^2/6 d_yy + a^4/120 d_xxxx + a^2 b^2/36 d_xxyy + b^4/120 d_yyyy,
!>
!> with an error of (1/7) (a/r)^6, and u = (4 a b/pi) D (1/r).
!>
!> Where the pressure goes on periodically along x, with the period L, the sum over all images has no limit, as the displacement of
!> a line load has none. Their differences have one. The constant is chosen so that far from the line of images u goes to that of a
!> line load, -(2/pi) q ln(|y|/d), with the load q = 4 a b/L per length and a distance d. The images beyond the M nearest ones on
!> either side are summed by Euler and Maclaurin's formula, whose integral is -ln((X + R)/d)/L, X = (M + 1/2) L +- x, R^2 = X^2 +
!> y^2:
!>
!>     sum over m > M of f(m) = int f dm + f'/24 - 7 f'''/5760 + 31 f'''''/967680,   f = 1/r,
!>     f^(n) = (-L)^n n! P_n(X/R)/R^(n + 1),
!>
!> the last three at m = M + 1/2, P_n Legendre's polynomials. Of the moments of far images the second ones count, as integrals.
module adfric_periodic_free_influence
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   implicit none (type, external)
   private
   public :: influence_of_cell, influence_of_row, set_influence

   !> Distance from a cell in its half sides from which on it counts as a force with moments: the error is 1e-13 there.
   real(dp), parameter :: far = 100.0_dp
   !> Images on either side that are summed one by one.
   integer, parameter :: n_images = 12

contains

   !> Displacements that pressure on a cell of a map makes so many cells away.
   subroutine set_influence(cell_size, lengths, is_periodic, influence)
      !> Size of a cell along x and y, in any unit.
      real(dp), intent(in) :: cell_size(2)
      !> Lengths of the map along x and y, in the same unit.
      real(dp), intent(in) :: lengths(2)
      !> Does the surface go on periodically along x, along y? Not along both.
      logical, intent(in) :: is_periodic(2)
      !> Receives the displacements by the distance in cells along x and y.
      real(dp), intent(out) :: influence(0:, 0:)
      real(dp) :: half(2)
      integer :: i, j

      half = cell_size/2
      !$omp parallel do default(none) shared(cell_size, lengths, is_periodic, influence, half) private(i, j) schedule(dynamic)
      do j = 0, ubound(influence, 2)
         do i = 0, ubound(influence, 1)
            associate (x => i*cell_size(1), y => j*cell_size(2))
               if (is_periodic(1)) then
                  influence(i, j) = influence_of_row(x, y, half(1), half(2), lengths(1), lengths(2))
               else if (is_periodic(2)) then
                  influence(i, j) = influence_of_row(y, x, half(2), half(1), lengths(2), lengths(1))
               else
                  influence(i, j) = influence_of_cell(x, y, half(1), half(2))
               end if
            end associate
         end do
      end do
      !$omp end parallel do
   end subroutine set_influence

   !> Displacement under a single cell.
   elemental real(dp) function influence_of_cell(x, y, a, b) result(influence)
      !> Position from the centre of the cell.
      real(dp), intent(in) :: x, y
      !> Half of the sides of the cell, > 0, in the unit of x and y.
      real(dp), intent(in) :: a, b

      if (max(abs(x), abs(y)) > far*max(a, b)) then
         influence = 4*a*b/pi*mean_inverse_distance(x, y, a, b)
      else
         influence = (potential(x + a, y + b) - potential(x - a, y + b) - potential(x + a, y - b) + potential(x - a, y - b))/pi
      end if
   end function influence_of_cell

   !> G(x, y).
   elemental real(dp) function potential(x, y)
      real(dp), intent(in) :: x, y

      potential = 0
      ! its limit is 0 on both axes
      if (.not. (abs(x) > 0 .and. abs(y) > 0)) return
      potential = x*asinh(y/abs(x)) + y*asinh(x/abs(y))
   end function potential

   !> D (1/r).
   elemental real(dp) function mean_inverse_distance(x, y, a, b) result(mean)
      !> Position from the centre of the cell, and half of its sides.
      real(dp), intent(in) :: x, y, a, b
      real(dp) :: square, xx, yy

      square = x**2 + y**2
      xx = x**2/square
      yy = y**2/square
      mean = 1 + (a**2*(3*xx - 1) + b**2*(3*yy - 1))/(6*square) &
         & + (a**4*(105*xx**2 - 90*xx + 9)/120 + a**2*b**2*(105*xx*yy - 12)/36 + b**4*(105*yy**2 - 90*yy + 9)/120)/square**2
      mean = mean/sqrt(square)
   end function mean_inverse_distance

   !> Displacement under a row of cells that goes on periodically along x.
   elemental real(dp) function influence_of_row(x, y, a, b, period, datum) result(influence)
      !> Position from the centre of one of the cells.
      real(dp), intent(in) :: x, y
      !> Half of the sides of a cell, > 0, in the unit of x and y.
      real(dp), intent(in) :: a, b
      !> Distance of the cells along x, 2a at least.
      real(dp), intent(in) :: period
      !> Distance d at which a line load has the displacement 0.
      real(dp), intent(in) :: datum
      real(dp) :: from_cell
      integer :: m

      from_cell = x - period*anint(x/period)
      influence = 0
      do m = -n_images, n_images
         influence = influence + influence_of_cell(from_cell + m*period, y, a, b)
      end do
      influence = influence + 4*a*b/pi*(tail((n_images + 0.5_dp)*period + from_cell, y, a, b, period, datum) &
         & + tail((n_images + 0.5_dp)*period - from_cell, y, a, b, period, datum))
   end function influence_of_row

   !> Sum of D (1/r) over the images on one side, from the distance X on.
   elemental real(dp) function tail(x, y, a, b, period, datum)
      !> Distance X from the image before half a period, and y.
      real(dp), intent(in) :: x, y
      !> Half of the sides of a cell, their period, and the datum.
      real(dp), intent(in) :: a, b, period, datum
      real(dp) :: r, c, step

      r = hypot(x, y)
      c = x/r
      step = period/r
      tail = (-log((x + r)/datum) + (a**2*c + b**2*(r/(r + x) - c))/(6*r**2))/period &
         & + (-step*c/24 + 7*step**3*c*(15*c**2 - 9)/5760 - 31*step**5*c*(945*c**4 - 1050*c**2 + 225)/967680)/r
   end function tail

end module adfric_periodic_free_influence
