! SPDX-License-Identifier: GPL-3.0-or-later
!> Steps in single cells from one side towards an extremal state of an adhesive surface; they never pass it.
!>
!> A gap g has the pressure F = q + A (g - g0) + s(g), s being the tension, and a state has g >= 0, F >= 0, g F = 0. F_i falls with every other gap, as far
!> as A has no positive entries off its diagonal. Let g be below the most adhered state in all cells. Where F_i < 0 a step of -F_i/A_ii in
!> that cell leaves it below: else the cell would have the state's gap somewhere on the step, and there F_i <= 0 would fall further in
!> going to the state in the other cells, which has F_i >= 0. The same holds from above the least adhered state where F_i > 0, g_i > 0.
!> So steps may come in any order and number (docs/theory/periodic_adhesion.md, Steps in single cells).
!>
!> - F follows each step, by a table of the influence of a cell on those around. Farther ones are left out: their F is too large from
!>   below and too small from above, which only makes steps shorter.
!> - What the contact left that the steps begin from is a margin that F has to exceed.
!> - Steps are made tile by tile. Tiles of one colour are so far apart that none sees what another does, and threads share them; colours
!>   come one after the other. So steps do not depend on threads.
module adfric_periodic_adhesive_relaxation
   use adfric_base_kinds, only: dp
   use adfric_periodic_cell_law, only: cell_law_t
   use adfric_periodic_maps, only: is_shared
   use adfric_periodic_operator, only: periodic_operator_t
   implicit none (type, external)
   private
   public :: relaxation_t, new_relaxation, relax

   !> The farthest cell that a table may have, cells along a tile, and cells beside it that take part.
   integer, parameter :: farthest = 10, cells_of_tile = 8, beside_tile = 6
   !> Tiles of one colour are so many apart, since steps reach `beside_tile` and `farthest` cells beyond a tile, on both sides.
   integer, parameter :: apart = 5
   !> Sweeps over a tile, at most.
   integer, parameter :: most_sweeps = 200
   !> Pressure over the largest of the last sweep from which on a cell takes a step.
   real(dp), parameter :: worthwhile = 0.4_dp
   !> Pressure over that of the first sweep at which a tile is left, and at which one is begun, over the largest of all tiles.
   real(dp), parameter :: enough = 0.1_dp, begun = 0.05_dp
   !> Pressure over the largest tension that is none.
   real(dp), parameter :: none = 1.0e-9_dp
   !> Steps over the number of cells of the surface, at most: as many take about the time of a round, and what they have not reached
   !> is left to the next one.
   real(dp), parameter :: most_steps_per_cell = 1.0_dp

   !> The table.
   type :: relaxation_t
      !> Cells in each direction that it reaches.
      integer :: reach(2) = 0
      !> Pressure of a gap of 1 in the cell 0, by the position [E*]; shape `(-reach(1):reach(1), -reach(2):reach(2))`.
      real(dp), allocatable :: influence(:, :)
      !> Cells of the grid that lie beside the first and the last ones: periodic or in a mirror; from -`reach` on.
      integer, allocatable :: along_x(:), along_y(:)
   end type relaxation_t

contains

   !> Make the table of a grid. A short one makes cheaper steps, a long one makes them longer.
   pure subroutine new_relaxation(self, operator, reach)
      type(relaxation_t), intent(out) :: self
      !> Operator of the grid.
      type(periodic_operator_t), intent(in) :: operator
      !> The farthest cell in each direction, 1 to 10; not given: 10.
      integer, intent(in), optional :: reach
      integer :: k

      associate (n => operator%n_cells, r => self%reach)
         r = min(farthest, (n - 1)/2)
         if (present(reach)) r = min(reach, r)
         allocate (self%influence(-r(1):r(1), -r(2):r(2)))
         call operator%get_influence(r, self%influence)
         allocate (self%along_x(1 - r(1):n(1) + r(1)), self%along_y(1 - r(2):n(2) + r(2)))
         self%along_x(:) = [(beside(k, n(1), operator%is_quarter), k=1 - r(1), n(1) + r(1))]
         self%along_y(:) = [(beside(k, n(2), operator%is_quarter), k=1 - r(2), n(2) + r(2))]
      end associate
   end subroutine new_relaxation

   !> The cell at a position beyond the first or the last one.
   pure integer function beside(position, n_cells, is_quarter)
      integer, intent(in) :: position
      !> Number of cells.
      integer, intent(in) :: n_cells
      !> Do mirrors bound the surface? Else it goes on with its period.
      logical, intent(in) :: is_quarter

      beside = modulo(position - 1, merge(2, 1, is_quarter)*n_cells) + 1
      if (beside > n_cells) beside = 2*n_cells + 1 - beside
   end function beside

   !> Make steps.
   subroutine relax(self, is_adhered, margin, is_slow, law, gap, pressure)
      type(relaxation_t), intent(in) :: self
      !> Are gaps below the most adhered state? Else above the least adhered one.
      logical, intent(in) :: is_adhered
      !> Error of the pressure that steps begin from [E*].
      real(dp), intent(in) :: margin
      !> Cells that steps are for; shape of the cells.
      logical, intent(in), contiguous :: is_slow(:, :)
      !> The law; what it keeps of the gap follows the steps.
      class(cell_law_t), intent(inout) :: law
      !> In: a gap that has not passed the state. Out: one that is nearer to it; shape of the cells.
      real(dp), intent(inout), contiguous :: gap(:, :)
      !> In: F of the gap [E*]. Out: F of the new one, as far as the table goes.
      real(dp), intent(inout), contiguous :: pressure(:, :)
      real(dp) :: rows(size(gap, 2)), least
      integer :: n_colours(2), i, j, sign_of_step, n_steps, most_steps

      sign_of_step = merge(1, -1, is_adhered)
      most_steps = ceiling(most_steps_per_cell*size(gap))
      !$omp parallel do if(is_shared(size(gap))) default(none) shared(pressure, gap, is_adhered, sign_of_step, rows) private(j)
      do j = 1, size(gap, 2)
         rows(j) = maxval(-sign_of_step*pressure(:, j), mask=is_adhered .or. gap(:, j) > 0)
      end do
      !$omp end parallel do
      least = max(none*law%largest_tension(), margin/2, begun*(maxval(rows) - margin))
      n_colours = [colours_of(size(gap, 1)), colours_of(size(gap, 2))]
      n_steps = 0
      do j = 1, n_colours(2)
         do i = 1, n_colours(1)
            if (n_steps >= most_steps) return
            call relax_colour(self, tiles_of(i, size(gap, 1)), tiles_of(j, size(gap, 2)), sign_of_step, margin, least, is_slow, &
               & law, gap, pressure, n_steps)
         end do
      end do
   end subroutine relax

   !> Number of colours of tiles along one direction.
   pure integer function colours_of(n_cells)
      !> Number of cells.
      integer, intent(in) :: n_cells
      integer :: n_tiles

      n_tiles = (n_cells - 1)/cells_of_tile + 1
      colours_of = n_tiles
      ! those that remain of the last group of colours are near the first tiles
      if (n_tiles >= 2*apart) colours_of = apart + modulo(n_tiles, apart)
   end function colours_of

   !> The first cells of the tiles of a colour along one direction.
   pure function tiles_of(colour, n_cells) result(first)
      integer, intent(in) :: colour
      !> Number of cells.
      integer, intent(in) :: n_cells
      integer, allocatable :: first(:)
      integer :: n_colours, n_tiles, last, k

      n_tiles = (n_cells - 1)/cells_of_tile + 1
      n_colours = colours_of(n_cells)
      last = n_tiles - (n_colours - apart)
      if (n_colours == n_tiles) then
         first = [cells_of_tile*(colour - 1) + 1]
      else if (colour > apart) then
         first = [cells_of_tile*(last + colour - apart - 1) + 1]
      else
         first = [(cells_of_tile*(k - 1) + 1, k=colour, last, apart)]
      end if
   end function tiles_of

   !> Make steps in the tiles of a colour.
   subroutine relax_colour(self, first_x, first_y, sign_of_step, margin, least, is_slow, law, gap, pressure, n_steps)
      type(relaxation_t), intent(in) :: self
      !> First cells of the tiles along both directions.
      integer, intent(in), contiguous :: first_x(:), first_y(:)
      !> 1 where gaps grow, -1 where they shrink.
      integer, intent(in) :: sign_of_step
      !> Error of the pressure [E*].
      real(dp), intent(in) :: margin
      !> Pressure beyond the margin that makes a tile worth it [E*].
      real(dp), intent(in) :: least
      !> Cells that steps are for; shape of the cells.
      logical, intent(in), contiguous :: is_slow(:, :)
      class(cell_law_t), intent(inout) :: law
      real(dp), intent(inout), contiguous :: gap(:, :)
      !> F [E*].
      real(dp), intent(inout), contiguous :: pressure(:, :)
      !> Receives the steps, which are added to those of before.
      integer, intent(inout) :: n_steps
      integer :: i, j, k

      !$omp parallel do if(is_shared(size(gap))) schedule(dynamic) default(none) private(i, j, k) reduction(+:n_steps) &
      !$omp& shared(self, first_x, first_y, sign_of_step, margin, least, is_slow, law, gap, pressure)
      do k = 1, size(first_x)*size(first_y)
         i = first_x(modulo(k - 1, size(first_x)) + 1)
         j = first_y((k - 1)/size(first_x) + 1)
         associate (last => min([i, j] + cells_of_tile - 1, shape(gap)))
            if (any(is_slow(i:last(1), j:last(2)))) call relax_tile(self, [i, j], last, sign_of_step, margin, least, law, gap, &
               & pressure, n_steps)
         end associate
      end do
      !$omp end parallel do
   end subroutine relax_colour

   !> Make steps in a tile and the cells around it, if it has one that is worth it.
   subroutine relax_tile(self, first, last, sign_of_step, margin, least, law, gap, pressure, n_steps)
      type(relaxation_t), intent(in) :: self
      !> First and last cell of the tile along both directions.
      integer, intent(in) :: first(2), last(2)
      !> 1 where gaps grow, -1 where they shrink.
      integer, intent(in) :: sign_of_step
      !> Error of the pressure [E*].
      real(dp), intent(in) :: margin
      !> Pressure beyond the margin that makes a tile worth it [E*].
      real(dp), intent(in) :: least
      class(cell_law_t), intent(inout) :: law
      real(dp), intent(inout), contiguous :: gap(:, :)
      !> F [E*].
      real(dp), intent(inout), contiguous :: pressure(:, :)
      !> Receives the steps, which are added to those of before.
      integer, intent(inout) :: n_steps
      real(dp) :: threshold, largest, first_largest, excess, step, stiffness
      integer :: sweep, i, j, ii, jj, around(2)

      if (.not. has_any()) return
      around = min(self%reach, beside_tile)
      stiffness = self%influence(0, 0)
      threshold = least
      do sweep = 1, most_sweeps
         largest = 0
         do jj = first(2) - around(2), last(2) + around(2)
            j = self%along_y(jj)
            do ii = first(1) - around(1), last(1) + around(1)
               i = self%along_x(ii)
               excess = -sign_of_step*pressure(i, j) - margin
               if (excess <= threshold) cycle
               step = sign_of_step*excess/stiffness
               if (gap(i, j) + step < 0) step = -gap(i, j)
               if (.not. abs(step) > 0) cycle
               largest = max(largest, abs(step)*stiffness)
               call spread(self, i, j, step, pressure)
               call law%move_cell(i, j, step, gap, pressure)
               n_steps = n_steps + 1
            end do
         end do
         if (sweep == 1) first_largest = largest
         if (largest <= max(least, enough*first_largest) .and. threshold <= least) exit
         threshold = max(least, worthwhile*largest)
         if (largest <= max(2.5_dp*least, enough*first_largest)) threshold = least
      end do

   contains

      !> Is a cell of the tile worth it?
      pure logical function has_any()
         integer :: i, j

         has_any = .false.
         do j = first(2), last(2)
            do i = first(1), last(1)
               if (.not. -sign_of_step*pressure(i, j) - margin > least) cycle
               has_any = sign_of_step > 0 .or. gap(i, j) > 0
               if (has_any) return
            end do
         end do
      end function has_any

   end subroutine relax_tile

   !> Add the pressure of a step in a cell to that of the cells around.
   pure subroutine spread(self, i, j, step, pressure)
      type(relaxation_t), intent(in) :: self
      !> The cell.
      integer, intent(in) :: i, j
      real(dp), intent(in) :: step
      real(dp), intent(inout), contiguous :: pressure(:, :)
      integer :: k, l, x

      associate (r => self%reach)
         if (i > r(1) .and. i + r(1) <= size(pressure, 1)) then
            do l = -r(2), r(2)
               call add_row(step, self%influence(:, l), pressure(i - r(1):i + r(1), self%along_y(j + l)))
            end do
         else
            do l = -r(2), r(2)
               do k = -r(1), r(1)
                  x = self%along_x(i + k)
                  pressure(x, self%along_y(j + l)) = pressure(x, self%along_y(j + l)) + step*self%influence(k, l)
               end do
            end do
         end if
      end associate
   end subroutine spread

   !> Add a multiple of a row of the table.
   pure subroutine add_row(factor, row, values)
      real(dp), intent(in) :: factor
      real(dp), intent(in), contiguous :: row(:)
      !> Receives the sum; as many as in the row.
      real(dp), intent(inout), contiguous :: values(:)
      integer :: k

      !$omp simd
      do k = 1, size(row)
         values(k) = values(k) + factor*row(k)
      end do
   end subroutine add_row

end module adfric_periodic_adhesive_relaxation
