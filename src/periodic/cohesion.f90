! SPDX-License-Identifier: GPL-3.0-or-later
!> Adhesion of Maugis and Dugdale between periodic surfaces: a tension of constant size while the gap is not larger than a range.
!>
!> Between the middles of four neighbouring cells the gap is taken as linear in triangles, as the mean over both ways to cut the
!> square in two. With the hat functions H_i of the triangles the energy of adhesion per area of a cell, and its derivative, are
!>
!>     Phi = sigma0 sum_i integral (min(g, h0) - h0),      d Phi/d g_i = sigma0 t_i,    t_i = integral of H_i where g <= h0
!>
!> (integrals over cells, in units of their area). The share t_i of the cell within the range goes from 1 to 0 as the edge of
!> the cohesive zone passes; nothing pins the edge to cells, as a yes or no in each cell does. What makes the shares usable:
!>
!> - Phi is concave, since min is and g is linear in each triangle. So the energy with the tangent of Phi in its place is above it, and
!>   solving the contact with given shares, which is convex, lowers the energy whenever the shares change.
!> - t_i falls with every g_j. A smaller gap means larger shares, and those, where the stiffness has no positive entries off its
!>   diagonal, a smaller gap (`adfric_periodic_adhesive_contact`).
!> - -d t_i/d g_j = integral of H_i H_j/|grad g| along the line g = h0, symmetric; where the gap is flat, no width is spread over it.
!>
!> Two things may differ from cell to cell. The work of adhesion is one: each triangle has the mean of its corners, as a part of the
!> stress. The other one is what had closed at a turn: opening may have a longer range than closing, and what had not come within the
!> range of closing by then has no tension. Both only weigh the integrals over g, so that all of the above stays.
!>
!> Another law that falls with the gap may replace Dugdale's. Then the share of a cell is its tension over the largest one, and
!> depends on the gap in its middle alone; no triangles are asked.
!>
!> The file is long by shares and slopes, which are integrals over the same triangles.
module adfric_periodic_cohesion
   use adfric_base_kinds, only: dp
   use adfric_interface_attraction, only: attraction_t
   use adfric_periodic_cell_law, only: cell_law_t
   use adfric_periodic_cut_triangle, only: cut_depth, cut_line, cut_shares
   use adfric_periodic_maps, only: is_shared, sum_of
   implicit none (type, external)
   private
   public :: cohesion_t, far_share, new_cohesion, line_integrals, triangles, weight_of_triangle

   !> A square between the middles of four cells.
   type :: square_t
      !> Positions of the middles along x and y; the same one twice on both sides of a mirror.
      integer :: x(2) = 1, y(2) = 1
      !> Weight: a mirror halves it.
      real(dp) :: weight = 1
   end type square_t

   !> The law, the shares of a gap, and how they change.
   type, extends(cell_law_t) :: cohesion_t
      !> Tension sigma0 [E*]; range h0, in the unit of the gap.
      real(dp) :: stress = 0, range = 0
      !> Is the surface even about 0 and half a period in x and in y, and only that quarter given?
      logical :: is_quarter = .false.
      !> Work of adhesion of each cell over the largest one, 0 to 1; not allocated: 1. Shape of the cells.
      real(dp), allocatable :: part(:, :)
      !> Gap at a turn less the range of closing; where it is above 0 there is no tension. Not allocated: there was no turn that counts.
      !> Shape of the cells.
      real(dp), allocatable :: beyond(:, :)
      !> Another law with a wall, whose largest tension has any unit; not allocated: Dugdale's. Of use where all cells have the same work.
      type(attraction_t), allocatable :: law
      !> With it: what the tension loses over a gap in each cell, not below 0; shape of the cells.
      real(dp), allocatable :: fall(:, :)
      !> Do the shares change with the gap as `corners` and `slopes` say? Else they are held.
      logical :: is_linear = .false.
      !> Shares t of the cells within the range, 0 to 1, each part of a cell with its work; shape of the cells.
      real(dp), allocatable :: share(:, :)
      !> Number of triangles that the edge of the zone passes.
      integer :: n_triangles = 0
      !> Cells at their corners, column by column; shape `(3, n)`, n >= `n_triangles`.
      integer, allocatable :: corners(:, :)
      !> sigma0 times the integrals of H_i H_j/|grad g| along the line, of corners 11, 22, 33, 12, 23, 31; shape `(6, n)`.
      real(dp), allocatable :: slopes(:, :)
      !> Number of squares that an edge passes on its way.
      integer :: n_squares = 0
      !> These squares; shape `(n)`, n >= `n_squares`.
      type(square_t), allocatable :: squares(:)
   contains
      procedure :: set_share
      procedure :: shares_of
      procedure :: area_share
      procedure :: open_by
      procedure :: largest_tension
      procedure :: move_cell
      procedure :: follow
      procedure :: far_range
      procedure :: set_band
      procedure :: get_band_share
      procedure :: hold
      procedure :: subtract_slope
      procedure :: energy_of
      procedure :: mean_tension
   end type cohesion_t

   !> Corners of the triangles among those of a square, which are counted round it; both ways to cut it.
   integer, parameter :: triangles(3, 4) = reshape([1, 2, 3, 1, 3, 4, 1, 2, 4, 2, 3, 4], [3, 4])
   !> Share of each triangle in the area of the square, of which it is half, and one cut of two.
   real(dp), parameter :: weight_of_triangle = 0.25_dp
   !> Share of the largest tension behind which surfaces are far apart.
   real(dp), parameter :: far_share = 1.0e-3_dp

contains

   !> Set the law, without shares.
   subroutine new_cohesion(self, stress, range, is_quarter, law)
      type(cohesion_t), intent(out) :: self
      !> Tension sigma0 [E*], > 0.
      real(dp), intent(in) :: stress
      !> Range h0, in the unit of the gap, > 0.
      real(dp), intent(in) :: range
      !> Is the surface even about 0 and half a period in x and in y, and only that quarter given?
      logical, intent(in) :: is_quarter
      !> Another law than Dugdale's; not allocated: Dugdale's.
      type(attraction_t), allocatable, intent(in), optional :: law

      self%stress = stress
      self%range = range
      self%is_quarter = is_quarter
      if (.not. present(law)) return
      if (allocated(law)) allocate (self%law, source=law)
   end subroutine new_cohesion

   !> Gap from which on surfaces count as apart: the range, or where a law has lost nearly all of its tension.
   pure real(dp) function far_range(self) result(range)
      class(cohesion_t), intent(in) :: self

      range = self%range
      if (allocated(self%law)) range = self%law%reach(far_share)
   end function far_range

   !> Find the shares of a gap, and hold them.
   subroutine set_share(self, gap)
      class(cohesion_t), intent(inout) :: self
      !> Gap in the middles of the cells.
      real(dp), intent(in), contiguous :: gap(:, :)
      integer :: j

      call self%hold()
      if (.not. allocated(self%share)) allocate (self%share(size(gap, 1), size(gap, 2)))
      if (.not. allocated(self%law)) then
         call sum_squares(self, gap, self%share)
         return
      end if
      !$omp parallel do if(is_shared(size(gap))) default(none) shared(self, gap) private(j)
      do j = 1, size(gap, 2)
         self%share(:, j) = self%law%tension(max(gap(:, j), 0.0_dp))/self%law%stress
      end do
      !$omp end parallel do
   end subroutine set_share

   !> The shares of all squares. Threads take parts of the rows. A part begins with the row of squares before it, whose second cells are its
   !> own, so that each cell has its four sums in their order whatever the parts are.
   subroutine sum_squares(self, gap, share)
      class(cohesion_t), intent(in) :: self
      real(dp), intent(in), contiguous :: gap(:, :)
      !> Receives the shares; shape of the cells.
      real(dp), intent(out), contiguous :: share(:, :)
      !> Rows of a part.
      integer, parameter :: n_rows = 32
      integer :: part, j, last
      logical :: has_last

      ! behind the last row are a mirror, the first one, or itself
      has_last = self%is_quarter .or. size(gap, 2) == 1
      share(:, :) = 0
      !$omp parallel do if(is_shared(size(gap))) schedule(dynamic) default(none) shared(self, gap, share, has_last) &
      !$omp& private(part, j, last)
      do part = 1, (size(gap, 2) - 1)/n_rows + 1
         last = min(size(gap, 2), n_rows*part)
         if (part == 1 .and. self%is_quarter) call add_row(self, gap, 0, [.true., .true.], share)
         if (part > 1) call add_row(self, gap, n_rows*(part - 1), [.false., .true.], share)
         do j = n_rows*(part - 1) + 1, last - 1
            call add_row(self, gap, j, [.true., .true.], share)
         end do
         call add_row(self, gap, last, [.true., last == size(gap, 2) .and. has_last], share)
      end do
      !$omp end parallel do
      if (.not. has_last) call add_row(self, gap, size(gap, 2), [.false., .true.], share)
   end subroutine sum_squares

   !> Add what a row of squares has within the range to the shares of their corners.
   pure subroutine add_row(self, gap, j, is_added, share)
      class(cohesion_t), intent(in) :: self
      real(dp), intent(in), contiguous :: gap(:, :)
      !> The row of cells before these squares; 0 before the first one in a mirror.
      integer, intent(in) :: j
      !> See `add_to_cells`.
      logical, intent(in) :: is_added(2)
      !> Receives the shares; shape of the cells.
      real(dp), intent(inout), contiguous :: share(:, :)
      integer :: i

      do i = merge(0, 1, self%is_quarter), size(gap, 1)
         call add_shares(self, gap, square_at(i, j, shape(gap), self%is_quarter), share, is_added)
      end do
   end subroutine add_row

   !> Shares of the cells' areas within the range, whatever the work of adhesion there is.
   function area_share(self, gap) result(share)
      class(cohesion_t), intent(in) :: self
      real(dp), intent(in), contiguous :: gap(:, :)
      real(dp), allocatable :: share(:, :)
      type(cohesion_t) :: law

      call new_cohesion(law, self%stress, self%range, self%is_quarter)
      if (allocated(self%beyond)) law%beyond = self%beyond
      call law%set_share(gap)
      call move_alloc(law%share, share)
   end function area_share

   !> Let what is within the range at a gap open with more work than closing gives: up to a longer range. What is outside of it by then has
   !> no tension any more. The shares of the gap itself stay.
   pure subroutine open_by(self, factor, gap)
      class(cohesion_t), intent(inout) :: self
      !> Work of opening over that of closing, >= 1; nothing is done where it is 1.
      real(dp), intent(in) :: factor
      !> Gap at the turn; shape of the cells.
      real(dp), intent(in), contiguous :: gap(:, :)

      if (.not. factor > 1) return
      self%beyond = gap - self%range
      self%range = factor*self%range
   end subroutine open_by

   !> Find the shares of a gap, and let them change with it in a straight line from there.
   subroutine follow(self, gap)
      class(cohesion_t), intent(inout) :: self
      real(dp), intent(in), contiguous :: gap(:, :)
      integer :: k

      call self%set_share(gap)
      self%is_linear = .true.
      if (allocated(self%law)) then
         self%fall = -(self%stress/self%law%stress)*self%law%slope(max(gap, 0.0_dp))
         return
      end if
      if (.not. allocated(self%corners)) allocate (self%corners(3, 64), self%slopes(6, 64))
      call self%set_band(gap, gap)
      do k = 1, self%n_squares
         call add_slopes(self, gap, self%squares(k))
      end do
   end subroutine follow

   !> Find the squares in which shares change on the way from a gap to another one that is nowhere smaller.
   subroutine set_band(self, low, high)
      class(cohesion_t), intent(inout) :: self
      !> The two gaps, in the middles of the cells.
      real(dp), intent(in), contiguous :: low(:, :), high(:, :)
      type(square_t), allocatable :: squares(:)
      type(square_t) :: square
      integer :: i, j, first

      if (.not. allocated(self%squares)) allocate (self%squares(64))
      self%n_squares = 0
      first = merge(0, 1, self%is_quarter)
      do j = first, size(low, 2)
         do i = first, size(low, 1)
            square = square_at(i, j, shape(low), self%is_quarter)
            associate (x => square%x, y => square%y)
               if (min(low(x(1), y(1)), low(x(2), y(1)), low(x(1), y(2)), low(x(2), y(2))) > self%range) cycle
               if (max(high(x(1), y(1)), high(x(2), y(1)), high(x(1), y(2)), high(x(2), y(2))) <= self%range) cycle
            end associate
            if (self%n_squares == size(self%squares)) then
               allocate (squares(2*self%n_squares))
               squares(:self%n_squares) = self%squares
               call move_alloc(squares, self%squares)
            end if
            self%n_squares = self%n_squares + 1
            self%squares(self%n_squares) = square
         end do
      end do
   end subroutine set_band

   !> What the squares of the band add to the shares.
   pure subroutine get_band_share(self, gap, share)
      class(cohesion_t), intent(in) :: self
      real(dp), intent(in), contiguous :: gap(:, :)
      !> Receives the shares that come from the band; shape of the cells.
      real(dp), intent(out), contiguous :: share(:, :)
      integer :: k

      share(:, :) = 0
      do k = 1, self%n_squares
         call add_shares(self, gap, self%squares(k), share)
      end do
   end subroutine get_band_share

   !> Hold the shares as they are.
   pure subroutine hold(self)
      class(cohesion_t), intent(inout) :: self

      self%n_triangles = 0
      self%is_linear = .false.
   end subroutine hold

   !> The square behind a cell, in a period or in a mirror.
   pure type(square_t) function square_at(i, j, n, is_quarter) result(square)
      !> The cell; 0 before the first one in a mirror.
      integer, intent(in) :: i, j
      !> Number of cells in each direction.
      integer, intent(in) :: n(2)
      !> Do mirrors bound the surface? Else it goes on with its period.
      logical, intent(in) :: is_quarter

      square%x = [max(i, 1), i + 1]
      square%y = [max(j, 1), j + 1]
      if (i == n(1)) square%x(2) = merge(n(1), 1, is_quarter)
      if (j == n(2)) square%y(2) = merge(n(2), 1, is_quarter)
      if (.not. is_quarter) return
      if (square%x(1) == square%x(2)) square%weight = square%weight/2
      if (square%y(1) == square%y(2)) square%weight = square%weight/2
   end function square_at

   !> Add what a square has within the range to the shares of its corners.
   pure subroutine add_shares(self, gap, square, share, is_added)
      class(cohesion_t), intent(in) :: self
      real(dp), intent(in), contiguous :: gap(:, :)
      type(square_t), intent(in) :: square
      !> Receives the shares; shape of the cells.
      real(dp), intent(inout), contiguous :: share(:, :)
      !> See `add_to_cells`.
      logical, intent(in), optional :: is_added(2)
      real(dp) :: corner(4)

      corner = corners_of(gap, square)
      if (min(corner(1), corner(2), corner(3), corner(4)) > self%range) return
      call add_to_cells(square, self%shares_of(square, corner), share, is_added)
   end subroutine add_shares

   !> What a square gives its corners as shares, but for its weight.
   pure function shares_of(self, square, corner) result(shares)
      class(cohesion_t), intent(in) :: self
      type(square_t), intent(in) :: square
      !> Gap at the corners, round the square.
      real(dp), intent(in) :: corner(4)
      real(dp) :: shares(4), part(4), beyond(4)
      integer :: k

      if (.not. (allocated(self%part) .or. allocated(self%beyond))) then
         shares = shares_in_square(self%range, corner)
         return
      end if
      shares = 0
      call get_parts(self, square, part, beyond)
      do k = 1, size(triangles, 2)
         associate (of => triangles(:, k))
            shares(of) = shares(of) + weight_of_triangle*sum(part(of))/3*shares_in_triangle(self%range, corner(of), beyond(of))
         end associate
      end do
   end function shares_of

   !> Works of the corners of a square over the largest one, and what their gaps at the turn were beyond the range.
   pure subroutine get_parts(self, square, part, beyond)
      class(cohesion_t), intent(in) :: self
      type(square_t), intent(in) :: square
      !> Receive the values, round the square; 1 and -1 where there are none.
      real(dp), intent(out) :: part(4), beyond(4)

      part = 1
      beyond = -1
      if (allocated(self%part)) part = corners_of(self%part, square)
      if (allocated(self%beyond)) beyond = corners_of(self%beyond, square)
   end subroutine get_parts

   !> Integrals of the hat functions over what holds of a triangle, in units of its area.
   pure function shares_in_triangle(range, corner, beyond) result(shares)
      !> Range h0.
      real(dp), intent(in) :: range
      !> Gap, and its excess over the range of closing at the turn, at the corners.
      real(dp), intent(in) :: corner(3), beyond(3)
      real(dp) :: shares(3)

      shares = 0
      if (minval(beyond) > 0) return
      if (maxval(beyond) > 0) then
         shares = cut_shares(corner - range, beyond)
      else
         call add_triangle(range, corner(1), corner(2), corner(3), shares(1), shares(2), shares(3))
         shares = shares/weight_of_triangle
      end if
   end function shares_in_triangle

   !> Add to the four cells of a square.
   pure subroutine add_to_cells(square, values, field, is_added)
      type(square_t), intent(in) :: square
      !> What is added, by the corners round the square, but for its weight.
      real(dp), intent(in) :: values(4)
      !> Receives it; shape of the cells.
      real(dp), intent(inout), contiguous :: field(:, :)
      !> Is it added to the first row of cells, and to the second one? Not given: to both.
      logical, intent(in), optional :: is_added(2)
      logical :: is_wanted(2)

      is_wanted = .true.
      if (present(is_added)) is_wanted = is_added
      associate (x => square%x, y => square%y, w => square%weight)
         if (is_wanted(1)) then
            field(x(1), y(1)) = field(x(1), y(1)) + w*values(1)
            field(x(2), y(1)) = field(x(2), y(1)) + w*values(2)
         end if
         if (is_wanted(2)) then
            field(x(2), y(2)) = field(x(2), y(2)) + w*values(3)
            field(x(1), y(2)) = field(x(1), y(2)) + w*values(4)
         end if
      end associate
   end subroutine add_to_cells

   !> Shares of the corners of a square within the range, as the mean over both cuts; 1/4 each where all of it is.
   pure function shares_in_square(range, corner) result(shares)
      !> Range h0.
      real(dp), intent(in) :: range
      !> Gap at the corners, round the square.
      real(dp), intent(in) :: corner(4)
      real(dp) :: shares(4)

      shares = 0
      if (min(corner(1), corner(2), corner(3), corner(4)) > range) return
      shares = 0.25_dp
      if (max(corner(1), corner(2), corner(3), corner(4)) <= range) return
      shares = 0
      ! as in `triangles`
      call add_triangle(range, corner(1), corner(2), corner(3), shares(1), shares(2), shares(3))
      call add_triangle(range, corner(1), corner(3), corner(4), shares(1), shares(3), shares(4))
      call add_triangle(range, corner(1), corner(2), corner(4), shares(1), shares(2), shares(4))
      call add_triangle(range, corner(2), corner(3), corner(4), shares(2), shares(3), shares(4))
   end function shares_in_square

   !> The largest tension [E*].
   pure real(dp) function largest_tension(self)
      class(cohesion_t), intent(in) :: self

      largest_tension = self%stress
   end function largest_tension

   !> Change the gap in one cell, and with it the shares there and in the cells beside, and a tension that follows them.
   pure subroutine move_cell(self, i, j, step, gap, tension)
      !> The law, with the shares of the gap.
      class(cohesion_t), intent(inout) :: self
      !> The cell.
      integer, intent(in) :: i, j
      !> Change of its gap.
      real(dp), intent(in) :: step
      !> In: the gap in all cells. Out: with the change.
      real(dp), intent(inout), contiguous :: gap(:, :)
      !> A field that the change of the tension [E*] is added to; shape of the cells.
      real(dp), intent(inout), contiguous :: tension(:, :)
      type(square_t) :: square
      real(dp) :: old(4), new(4), before
      integer :: x(2), y(2), k, l, first

      first = merge(0, 1, self%is_quarter)
      x = [i - 1, i]
      y = [j - 1, j]
      if (x(1) < first) x(1) = size(gap, 1)
      if (y(1) < first) y(1) = size(gap, 2)
      before = gap(i, j)
      if (is_plain()) then
         gap(i, j) = before + step
         return
      end if
      do l = merge(2, 1, y(1) == y(2)), 2
         do k = merge(2, 1, x(1) == x(2)), 2
            square = square_at(x(k), y(l), shape(gap), self%is_quarter)
            gap(i, j) = before
            old = self%shares_of(square, corners_of(gap, square))
            gap(i, j) = before + step
            new = self%shares_of(square, corners_of(gap, square)) - old
            if (.not. any(abs(new) > 0)) cycle
            call add_to_cells(square, new, self%share)
            call add_to_cells(square, self%stress*new, tension)
         end do
      end do

   contains

      !> Are the cell and all beside it on one side of the range, before and after? Not asked at the sides of the grid.
      pure logical function is_plain()
         real(dp) :: low, high
         integer :: m, n

         is_plain = i > 1 .and. j > 1 .and. i < size(gap, 1) .and. j < size(gap, 2)
         if (.not. is_plain) return
         low = min(before, before + step)
         high = max(before, before + step)
         do n = j - 1, j + 1
            do m = i - 1, i + 1
               low = min(low, gap(m, n))
               high = max(high, gap(m, n))
            end do
         end do
         is_plain = low > self%range .or. high <= self%range
      end function is_plain

   end subroutine move_cell

   !> Gap at the corners of a square, round it.
   pure function corners_of(gap, square) result(corner)
      real(dp), intent(in), contiguous :: gap(:, :)
      type(square_t), intent(in) :: square
      real(dp) :: corner(4)

      associate (x => square%x, y => square%y)
         corner = [gap(x(1), y(1)), gap(x(2), y(1)), gap(x(2), y(2)), gap(x(1), y(2))]
      end associate
   end function corners_of

   !> Add the integrals of the hat functions over the part of a triangle within the range, in units of the square's area.
   pure subroutine add_triangle(range, first, second, third, share_1, share_2, share_3)
      real(dp), intent(in) :: range
      !> Gap at the corners.
      real(dp), intent(in) :: first, second, third
      !> Receive the integrals of their hat functions.
      real(dp), intent(inout) :: share_1, share_2, share_3

      if (min(first, second, third) > range) return
      if (max(first, second, third) <= range) then
         share_1 = share_1 + weight_of_triangle/3
         share_2 = share_2 + weight_of_triangle/3
         share_3 = share_3 + weight_of_triangle/3
      else if (first <= second) then
         if (second <= third) then
            call add_cut(range, first, second, third, share_1, share_2, share_3)
         else if (first <= third) then
            call add_cut(range, first, third, second, share_1, share_3, share_2)
         else
            call add_cut(range, third, first, second, share_3, share_1, share_2)
         end if
      else if (first <= third) then
         call add_cut(range, second, first, third, share_2, share_1, share_3)
      else if (second <= third) then
         call add_cut(range, second, third, first, share_2, share_3, share_1)
      else
         call add_cut(range, third, second, first, share_3, share_2, share_1)
      end if
   end subroutine add_triangle

   !> The same of a triangle that the edge of the zone cuts.
   pure subroutine add_cut(range, low, middle, high, share_low, share_middle, share_high)
      real(dp), intent(in) :: range
      !> Gap at the corners, rising.
      real(dp), intent(in) :: low, middle, high
      !> Receive the integrals of their hat functions.
      real(dp), intent(inout) :: share_low, share_middle, share_high
      real(dp) :: a, b

      if (range < middle) then
         a = (range - low)/(middle - low)
         b = (range - low)/(high - low)
         share_low = share_low + weight_of_triangle*(a*b*(1 - (a + b)/3))
         share_middle = share_middle + weight_of_triangle*(a*b*a/3)
         share_high = share_high + weight_of_triangle*(a*b*b/3)
      else
         a = (high - range)/(high - low)
         b = (high - range)/(high - middle)
         share_high = share_high + weight_of_triangle*(1.0_dp/3 - a*b*(1 - (a + b)/3))
         share_low = share_low + weight_of_triangle*(1.0_dp/3 - a*b*a/3)
         share_middle = share_middle + weight_of_triangle*(1.0_dp/3 - a*b*b/3)
      end if
   end subroutine add_cut

   !> Corners from the lowest gap to the highest.
   pure function order_of(corner) result(order)
      real(dp), intent(in) :: corner(3)
      integer :: order(3)

      order = [1, 2, 3]
      if (corner(2) < corner(1)) order(1:2) = order([2, 1])
      if (corner(3) < corner(order(2))) order(2:3) = order([3, 2])
      if (corner(order(2)) < corner(order(1))) order(1:2) = order([2, 1])
   end function order_of

   !> Keep the triangles of a square that the edge of the zone passes.
   subroutine add_slopes(self, gap, square)
      type(cohesion_t), intent(inout) :: self
      real(dp), intent(in), contiguous :: gap(:, :)
      type(square_t), intent(in) :: square
      real(dp) :: corner(4), part(4), beyond(4)
      integer :: cells(4), k

      corner = corners_of(gap, square)
      call get_parts(self, square, part, beyond)
      cells = square%x([1, 2, 2, 1]) + size(gap, 1)*(square%y([1, 1, 2, 2]) - 1)
      do k = 1, 4
         associate (of => triangles(:, k))
            if (minval(corner(of)) > self%range .or. maxval(corner(of)) <= self%range .or. minval(beyond(of)) > 0) cycle
            if (self%n_triangles == size(self%corners, 2)) call make_space(self)
            self%n_triangles = self%n_triangles + 1
            self%corners(:, self%n_triangles) = cells(of)
            self%slopes(:, self%n_triangles) = square%weight*weight_of_triangle*self%stress &
               & *(sum(part(of))/3)*slopes_of(corner(of), self%range, beyond(of))
         end associate
      end do
   end subroutine add_slopes

   !> Make space for twice as many triangles.
   pure subroutine make_space(self)
      type(cohesion_t), intent(inout) :: self
      integer, allocatable :: corners(:, :)
      real(dp), allocatable :: slopes(:, :)
      integer :: n

      n = self%n_triangles
      allocate (corners(3, 2*n), slopes(6, 2*n))
      corners(:, :n) = self%corners(:, :n)
      slopes(:, :n) = self%slopes(:, :n)
      call move_alloc(corners, self%corners)
      call move_alloc(slopes, self%slopes)
   end subroutine make_space

   !> Integrals of products of hat functions along the line, over the gradient of the gap, in units of the triangle's area; pairs
   !> as in `line_integrals`.
   pure function slopes_of(corner, range, beyond) result(slopes)
      !> Gap at the corners, not all on one side of the range.
      real(dp), intent(in) :: corner(3)
      real(dp), intent(in) :: range
      !> What the line is cut to: where this function of the corners is not above 0.
      real(dp), intent(in) :: beyond(3)
      real(dp) :: slopes(6), part(2), rate, length
      real(dp) :: ends(3, 2)
      integer :: order(3)

      order = order_of(corner)
      ends = 0
      associate (low => corner(order(1)), middle => corner(order(2)), high => corner(order(3)))
         ! derivative of the area within the range by the range
         if (range < middle) then
            part = (range - low)/[middle - low, high - low]
            rate = 2*part(1)/(high - low)
            ends(order(1), :) = 1 - part
            ends(order(2), 1) = part(1)
            ends(order(3), 2) = part(2)
         else
            part = (high - range)/[high - low, high - middle]
            rate = 2*part(2)/(high - low)
            ends(order(3), :) = 1 - part
            ends(order(1), 1) = part(1)
            ends(order(2), 2) = part(2)
         end if
      end associate
      if (maxval(beyond) > 0) then
         call cut_line(beyond, ends(:, 1), ends(:, 2), length)
         rate = rate*length
      end if
      slopes = rate*line_integrals(ends(:, 1), ends(:, 2))
   end function slopes_of

   !> Means of products of two of three functions that are linear along a line; pairs 11, 22, 33, 12, 23, 31. The products are quadratic,
   !> so that Simpson's rule is exact.
   pure function line_integrals(first, last) result(integrals)
      !> The functions at both ends of the line.
      real(dp), intent(in) :: first(3), last(3)
      real(dp) :: integrals(6), middle(3)
      integer, parameter :: one(6) = [1, 2, 3, 1, 2, 3], other(6) = [1, 2, 3, 2, 3, 1]

      middle = (first + last)/2
      integrals = (first(one)*first(other) + 4*middle(one)*middle(other) + last(one)*last(other))/6
   end function line_integrals

   !> Subtract what the tension loses along a direction from its pressure, where shares follow the gap.
   pure subroutine subtract_slope(self, direction, pressure, product)
      class(cohesion_t), intent(in) :: self
      !> Change of the gap, in columns; shape `(n_cells)`.
      real(dp), intent(in) :: direction(*)
      !> Pressure of the change; shape `(n_cells)`.
      real(dp), intent(inout) :: pressure(*)
      !> Receives the sum of the change times what has been subtracted.
      real(dp), intent(out) :: product
      real(dp) :: change(3), lost(3)
      integer :: i, j, k

      product = 0
      if (allocated(self%law) .and. self%is_linear) then
         k = 0
         do j = 1, size(self%fall, 2)
            do i = 1, size(self%fall, 1)
               k = k + 1
               pressure(k) = pressure(k) - self%fall(i, j)*direction(k)
               product = product + self%fall(i, j)*direction(k)**2
            end do
         end do
         return
      end if
      do k = 1, self%n_triangles
         associate (c => self%corners(:, k), s => self%slopes(:, k))
            change = direction(c)
            lost = s(1:3)*change + s(4:6)*change([2, 3, 1]) + s([6, 4, 5])*change([3, 1, 2])
            pressure(c(1)) = pressure(c(1)) - lost(1)
            pressure(c(2)) = pressure(c(2)) - lost(2)
            pressure(c(3)) = pressure(c(3)) - lost(3)
            product = product + sum(change*lost)
         end associate
      end do
   end subroutine subtract_slope

   !> The mean tension of the shares [E*].
   real(dp) function mean_tension(self)
      class(cohesion_t), intent(in) :: self

      mean_tension = self%stress*(sum_of(self%share)/size(self%share))
   end function mean_tension

   !> Energy of adhesion per area, less than 0 where there is any: the mean of Phi [E* times the unit of the gap].
   pure real(dp) function energy_of(self, gap) result(energy)
      class(cohesion_t), intent(in) :: self
      real(dp), intent(in), contiguous :: gap(:, :)
      type(square_t) :: square
      real(dp) :: corner(4), part(4), beyond(4), total
      integer :: first, i, j, k

      if (allocated(self%law)) then
         energy = -(self%stress/self%law%stress)*sum(self%law%work_from(max(gap, 0.0_dp)))/size(gap)
         return
      end if
      first = merge(0, 1, self%is_quarter)
      total = 0
      do j = first, size(gap, 2)
         do i = first, size(gap, 1)
            square = square_at(i, j, shape(gap), self%is_quarter)
            corner = corners_of(gap, square)
            call get_parts(self, square, part, beyond)
            do k = 1, 4
               associate (of => triangles(:, k))
                  total = total + square%weight*weight_of_triangle*(sum(part(of))/3)*depth_of(corner(of), self%range, beyond(of))
               end associate
            end do
         end do
      end do
      energy = -self%stress*total/size(gap)
   end function energy_of

   !> Mean of the way from the gap up to the range, over a triangle.
   pure real(dp) function depth_of(corner, range, beyond) result(depth)
      real(dp), intent(in) :: corner(3)
      real(dp), intent(in) :: range
      !> Where this function of the corners is above 0 nothing is counted.
      real(dp), intent(in) :: beyond(3)
      integer :: order(3)

      depth = 0
      if (minval(corner) > range .or. minval(beyond) > 0) return
      if (maxval(beyond) > 0) then
         depth = cut_depth(corner - range, beyond)
         return
      end if
      depth = range - sum(corner)/3
      if (maxval(corner) <= range) return
      order = order_of(corner)
      associate (low => corner(order(1)), middle => corner(order(2)), high => corner(order(3)))
         if (range < middle) then
            depth = (range - low)**3/(3*(middle - low)*(high - low))
         else
            depth = depth + (high - range)**3/(3*(high - low)*(high - middle))
         end if
      end associate
   end function depth_of

end module adfric_periodic_cohesion
