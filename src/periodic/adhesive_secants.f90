! SPDX-License-Identifier: GPL-3.0-or-later
!> The largest slopes of the shares of adhesion on a path from a state: for each cell a bound m of |t(g + s x) - t(g)|/s, 0 < s <= 1.
!>
!> - First the slopes themselves are bounded, over all gaps between the ends of the path. In a triangle whose corners keep their side of
!>   the range the derivative of the shares is a product of factors that rise or fall with each corner, so their largest values do. On a
!>   short path that is next to the slope at the state.
!> - Elsewhere m is the largest of secants. Shares change in one direction, so that between two positions on the path |t - t(g)|/s is
!>   not above the change at the farther one over the nearer s. Positions are closer in cells where that is needed.
!> - On the last part, next to the state, slopes are those of the state itself.
module adfric_periodic_adhesive_secants
   use adfric_base_kinds, only: dp
   use adfric_periodic_cohesion, only: cohesion_t, line_integrals, triangles, weight_of_triangle
   use adfric_periodic_contact, only: contact_state_t
   implicit none (type, external)
   private
   public :: set_largest_slope, set_slope

   !> Nearest part of the path with a secant of its own.
   real(dp), parameter :: nearest_part = 0.02_dp
   !> Number of parts of the path, of each of these where that is not enough, and so on.
   integer, parameter :: n_parts(*) = [24, 5, 6]

   !> Cells and squares in which shares change on a path.
   type :: band_t
      !> Range h0, in the unit of the gap.
      real(dp) :: range = 0
      !> Numbers of the cells of each square, round it; shape `(4, n_squares)`.
      integer, allocatable :: corners(:, :)
      !> Weights of the squares: a mirror halves them; shape `(n_squares)`. Works of adhesion below the largest one, and what had not closed
      !> at a turn, only make slopes smaller than their bounds.
      real(dp), allocatable :: weight(:)
      !> Gap of the state, and its change along the path, in the unit of the gap; shape `(n_cells)`.
      real(dp), allocatable :: start(:), direction(:)
      !> Shares that the squares give the cells at the state; shape `(n_cells)`.
      real(dp), allocatable :: here(:)
      !> Largest slope so far, and the one from which on secants are made closer; shape `(n_cells)`.
      real(dp), allocatable :: slope(:), limit(:)
   end type band_t

contains

   !> The largest slopes of the shares on a path.
   subroutine set_largest_slope(state, sign_of_path, path, cost, slope)
      !> The state with the slopes of its shares.
      type(contact_state_t), intent(in) :: state
      !> -1 where the path leads to smaller gaps, else 1.
      real(dp), intent(in) :: sign_of_path
      !> The path, >= 0; shape of the cells.
      real(dp), intent(in), contiguous :: path(:, :)
      !> Slope beyond that at the state from which on secants are made closer.
      real(dp), intent(in) :: cost
      !> Receives the slopes, >= 0.
      real(dp), intent(out), contiguous :: slope(:, :)
      type(cohesion_t) :: law
      type(band_t) :: band
      integer, allocatable :: number(:, :)
      real(dp), allocatable :: bound(:)
      logical, allocatable :: is_beyond(:)
      integer :: i, j

      law = state%cohesion
      call set_slope(law, path, slope)
      call set_band(band, law, state%gap, sign_of_path*path, slope, cost, number)
      allocate (bound, mold=band%start)
      call get_bound(band, bound)
      allocate (is_beyond, source=bound > band%limit)
      where (.not. is_beyond) band%slope = bound
      call raise_slope(band, law, 1.0_dp, nearest_part, 1, touching(band, [(i, i=1, size(band%weight))], is_beyond), is_beyond)
      do j = 1, size(slope, 2)
         do i = 1, size(slope, 1)
            if (number(i, j) > 0) slope(i, j) = band%slope(number(i, j))
         end do
      end do
   end subroutine set_largest_slope

   !> Slopes of the shares at a state along a path.
   pure subroutine set_slope(law, path, slope)
      !> The law with its slopes.
      type(cohesion_t), intent(in) :: law
      !> Change of the gap, of one sign; shape of the cells.
      real(dp), intent(in), contiguous :: path(:, :)
      !> Receives the slopes, >= 0.
      real(dp), intent(out), contiguous :: slope(:, :)
      real(dp) :: product

      slope(:, :) = 0
      call law%subtract_slope(path, slope, product)
      slope(:, :) = abs(slope)/law%stress
   end subroutine set_slope

   !> Find the squares and cells in which shares change on a path.
   subroutine set_band(self, law, gap, path, at_state, cost, number)
      type(band_t), intent(out) :: self
      !> The law; receives the squares on the path.
      type(cohesion_t), intent(inout) :: law
      !> Gap of the state; shape of the cells.
      real(dp), intent(in), contiguous :: gap(:, :)
      !> Change of the gap, of one sign.
      real(dp), intent(in), contiguous :: path(:, :)
      !> Slopes at the state.
      real(dp), intent(in), contiguous :: at_state(:, :)
      !> Slope beyond these from which on secants are made closer.
      real(dp), intent(in) :: cost
      !> Receives the number of each cell in the band, 0: none; shape of the cells.
      integer, allocatable, intent(out) :: number(:, :)
      integer :: i, k, n

      call law%set_band(min(gap, gap + path), max(gap, gap + path))
      allocate (number(size(gap, 1), size(gap, 2)), source=0)
      allocate (self%corners(4, law%n_squares), self%weight(law%n_squares))
      n = 0
      do k = 1, law%n_squares
         self%weight(k) = law%squares(k)%weight
         associate (x => law%squares(k)%x([1, 2, 2, 1]), y => law%squares(k)%y([1, 1, 2, 2]))
            do i = 1, 4
               if (number(x(i), y(i)) == 0) then
                  n = n + 1
                  number(x(i), y(i)) = n
               end if
               self%corners(i, k) = number(x(i), y(i))
            end do
         end associate
      end do
      self%range = law%range
      allocate (self%start(n), self%direction(n), self%slope(n), self%here(n))
      call pick(gap, number, self%start)
      call pick(path, number, self%direction)
      call pick(at_state, number, self%slope)
      allocate (self%limit(n), source=self%slope + cost)
      call sum_shares(self, law, [(k, k=1, law%n_squares)], 0.0_dp, self%here)
   end subroutine set_band

   !> Raise the slopes of some cells to the largest of their secants, from the state to all positions in a part of the path. Where that is
   !> beyond the limit, the part is taken in smaller ones.
   recursive subroutine raise_slope(band, law, far, near, depth, squares, is_wanted)
      type(band_t), intent(inout) :: band
      !> The law with the squares of the band.
      type(cohesion_t), intent(in) :: law
      !> Ends of the part of the path, of all of it.
      real(dp), intent(in) :: far, near
      !> How often parts have been taken in smaller ones, with that of the whole path.
      integer, intent(in) :: depth
      !> Squares of the cells; shape `(n)`.
      integer, intent(in), contiguous :: squares(:)
      !> Which cells of the band these are; shape of its cells.
      logical, intent(in), contiguous :: is_wanted(:)
      real(dp), allocatable :: there(:), secant(:)
      logical, allocatable :: is_beyond(:)
      real(dp) :: ends(2), ratio
      integer :: k

      allocate (there, mold=band%start)
      allocate (secant, mold=band%start)
      allocate (is_beyond(size(there)))
      ratio = (near/far)**(1.0_dp/n_parts(depth))
      do k = 1, n_parts(depth)
         ends = far*ratio**[k - 1, k]
         call sum_shares(band, law, squares, ends(1), there)
         secant(:) = abs(there - band%here)/ends(2)
         is_beyond(:) = is_wanted .and. secant > band%limit
         if (depth == size(n_parts) .or. .not. any(is_beyond)) then
            where (is_wanted) band%slope = max(band%slope, secant)
         else
            where (is_wanted .and. .not. is_beyond) band%slope = max(band%slope, secant)
            call raise_slope(band, law, ends(1), ends(2), depth + 1, touching(band, squares, is_beyond), is_beyond)
         end if
      end do
   end subroutine raise_slope

   !> The squares that have one of some cells.
   pure function touching(band, squares, is_wanted)
      type(band_t), intent(in) :: band
      !> Squares to choose from; shape `(n)`.
      integer, intent(in), contiguous :: squares(:)
      !> The cells; shape of the cells of the band.
      logical, intent(in), contiguous :: is_wanted(:)
      integer, allocatable :: touching(:)
      integer :: k

      touching = pack(squares, [(any(is_wanted(band%corners(:, squares(k)))), k=1, size(squares))])
   end function touching

   !> Bounds of the slopes over all gaps between the ends of the path; huge where a corner of a triangle crosses the range.
   pure subroutine get_bound(band, bound)
      type(band_t), intent(in) :: band
      !> Receives the bounds; shape of the cells of the band.
      real(dp), intent(out), contiguous :: bound(:)
      real(dp) :: start(3), change(3), slopes(6), lost(3)
      integer :: cells(3), k, l

      bound(:) = 0
      do k = 1, size(band%weight)
         do l = 1, size(triangles, 2)
            cells = band%corners(triangles(:, l), k)
            start = band%start(cells) - band%range
            change = band%direction(cells)
            slopes = largest_slopes(min(start, start + change), max(start, start + change))
            if (slopes(1) >= huge(slopes)) then
               bound(cells) = huge(bound)
            else
               lost = abs(slopes(1:3)*change + slopes(4:6)*change([2, 3, 1]) + slopes([6, 4, 5])*change([3, 1, 2]))
               lost = band%weight(k)*weight_of_triangle*lost
               bound(cells(1)) = bound(cells(1)) + lost(1)
               bound(cells(2)) = bound(cells(2)) + lost(2)
               bound(cells(3)) = bound(cells(3)) + lost(3)
            end if
         end do
      end do
   end subroutine get_bound

   !> The largest integrals of products of hat functions along the line, over the gradient of the gap, in units of the triangle's area, for
   !> all gaps between two; pairs as in `line_integrals`. Huge where a corner crosses the range.
   pure function largest_slopes(low, high) result(slopes)
      !> Least and largest gap beyond the range at the corners.
      real(dp), intent(in) :: low(3), high(3)
      real(dp) :: slopes(6), lone(2), other(2, 2), first(3), last(3)
      integer :: apex, next(2), i

      slopes = 0
      if (all(high <= 0) .or. all(low > 0)) return
      slopes = huge(slopes)
      if (.not. all(high <= 0 .or. low > 0)) return
      ! the corner that is alone on its side, and its distance from the range; the line leaves out its part of both edges there
      if (count(low > 0) == 1) then
         apex = findloc(low > 0, .true., 1)
         lone = [low(apex), high(apex)]
      else
         apex = findloc(high <= 0, .true., 1)
         lone = -[high(apex), low(apex)]
      end if
      do i = 1, 2
         next(i) = modulo(apex + i - 1, 3) + 1
         other(:, i) = merge([low(next(i)), high(next(i))], -[high(next(i)), low(next(i))], low(next(i)) > 0)
      end do
      first = 0
      last = 0
      first([apex, next(1)]) = [other(2, 1)/(other(2, 1) + lone(1)), lone(2)/(other(1, 1) + lone(2))]
      last([apex, next(2)]) = [other(2, 2)/(other(2, 2) + lone(1)), lone(2)/(other(1, 2) + lone(2))]
      slopes = 2*lone(2)/product(other(1, :) + lone(1))*line_integrals(first, last)
   end function largest_slopes

   !> The values of numbered cells in their order.
   pure subroutine pick(field, number, values)
      real(dp), intent(in), contiguous :: field(:, :)
      !> Number of each cell; 0: none.
      integer, intent(in), contiguous :: number(:, :)
      !> Receives the values.
      real(dp), intent(out), contiguous :: values(:)
      integer :: i, j

      do j = 1, size(field, 2)
         do i = 1, size(field, 1)
            if (number(i, j) > 0) values(number(i, j)) = field(i, j)
         end do
      end do
   end subroutine pick

   !> What some squares of the band add to the shares of their cells.
   pure subroutine sum_shares(band, law, squares, part, share)
      type(band_t), intent(in) :: band
      !> The law with the squares of the band.
      type(cohesion_t), intent(in) :: law
      !> Numbers of the squares; shape `(n)`.
      integer, intent(in), contiguous :: squares(:)
      !> How far along the path, of all of it.
      real(dp), intent(in) :: part
      !> Receives the shares; shape of the cells of the band.
      real(dp), intent(out), contiguous :: share(:)
      real(dp) :: shares(4)
      integer :: i, k

      share(:) = 0
      do k = 1, size(squares)
         associate (cells => band%corners(:, squares(k)))
            shares = band%weight(squares(k)) &
               & *law%shares_of(law%squares(squares(k)), band%start(cells) + part*band%direction(cells))
            do i = 1, 4
               share(cells(i)) = share(cells(i)) + shares(i)
            end do
         end associate
      end do
   end subroutine sum_shares

end module adfric_periodic_adhesive_secants
