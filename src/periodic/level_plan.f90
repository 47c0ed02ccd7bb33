! SPDX-License-Identifier: GPL-3.0-or-later
!> The grids of the approximate inverse of `adfric_periodic_levels`, and what each makes of its residuals.
!>
!> A grid has the mean compliance c of the waves that its cells can tell. For a half-space c doubles from grid to grid, and each
!> grid takes part with the whole of it. Under a sliding body the solid is stiffer for waves along the motion than for those
!> across it, of the same length. Each grid (i, i), halved i times both ways, then has a row of grids (i + m, i) beside it, of
!> cells ever longer along the motion, each with what its waves are softer by than those of the grid before in the row.
!>
!> A layer gives way to long waves no more than to some shorter ones, and where it is thin its stiffness depends on the wave along
!> the motion alone. With the same weights a long wave would meet its compliance as many times as there are grids, and conjugate
!> gradients and their like take the more steps the thinner it is. So a grid takes part with what its waves are softer by than
!> those of all finer grids,
!>
!>     c(i, j) - c(i - 1, j) - c(i, j - 1) + c(i - 1, j - 1),
!>
!> and a wave meets in sum the compliance of the coarsest grid that has it, once. Under a thin layer that slides only the row
!> beside the finest grid is left. A grid of the main row, (i, i), stands beside none on its other side; it takes part with a
!> multiple of c(i, i) - c(i, i - 1), or of c(i, i) - c(i - 1, i - 1) on lines and at rest, where the main row is the only one;
!> with c(i, i) at most.
module adfric_periodic_level_plan
   use adfric_base_kinds, only: dp
   use adfric_periodic_operator, only: periodic_operator_t
   implicit none (type, external)
   private
   public :: level_t, plan_levels

   !> Fewest cells along a direction of the coarsest grid.
   integer, parameter :: fewest_cells = 4
   !> A direction is halved while its cells are not longer than so many times those of the other direction.
   real(dp), parameter :: longest = 1.5_dp
   !> Enough grids for any number of cells that fits into memory.
   integer, parameter :: most_grids = 600
   !> Factors of what the grids of the main row of a layer are softer by than finer ones, where one direction is halved, or both:
   !> with less, waves slide over a thick layer with more steps, with more over a thin one.
   real(dp), parameter :: gain = 1.5_dp, gain_of_both = 4

   !> One grid.
   type :: level_t
      !> Number of the finer grid that this one is made from; 0 for the finest.
      integer :: finer = 0
      !> Numbers of the next coarser grid and of the first one of the row beside; 0 where there is none.
      integer :: coarser = 0, beside = 0
      !> Number of cells.
      integer :: n_cells(2) = 1
      !> Was the direction halved from the finer grid?
      logical :: is_halved(2) = .false.
      !> Share of the cell that is open; shape of the cells of this grid, as that of the others.
      real(dp), allocatable :: open(:, :)
      !> Sums of residuals, and what this grid and the coarser ones make of them; not of the finest grid.
      real(dp), allocatable, dimension(:, :) :: residual, correction
      !> Correction over residual.
      real(dp) :: weight = 1
   end type level_t

contains

   !> Plan the grids for the cells of an operator.
   pure subroutine plan_levels(self, operator)
      !> Receives the grids without their fields, the finest first and each after the one that it is made from.
      type(level_t), allocatable, intent(out) :: self(:)
      !> Operator of the finest grid, for its cells and stiffness.
      type(periodic_operator_t), intent(in) :: operator
      logical, allocatable :: is_halved(:, :)
      type(level_t) :: grids(most_grids)
      integer :: k, n, first

      call plan_grids(operator%n_cells, operator%cell_size, is_halved)
      n = 1
      grids(1)%n_cells = operator%n_cells
      do k = 2, size(is_halved, 2)
         call add_grid(grids, n, k - 1, is_halved(:, k))
      end do
      do k = 1, n
         grids(k)%weight = main_weight(grids, k, operator)
         if (k < n) grids(k)%coarser = k + 1
      end do
      if (.not. operator%is_symmetric) then
         do k = 1, size(is_halved, 2)
            first = n + 1
            call add_grids_beside(grids, n, k, operator)
            if (n >= first) grids(k)%beside = first
         end do
      end if
      ! residuals are sums over cells
      do k = 1, n
         grids(k)%weight = grids(k)%weight*(real(product(grids(k)%n_cells), dp)/product(real(grids(1)%n_cells, dp)))
      end do
      allocate (self(n))
      self(:) = grids(:n)
   end subroutine plan_levels

   !> Add a grid.
   pure subroutine add_grid(grids, n, finer, is_halved)
      type(level_t), intent(inout) :: grids(:)
      !> Number of grids.
      integer, intent(inout) :: n
      !> Number of the grid that it is made from.
      integer, intent(in) :: finer
      logical, intent(in) :: is_halved(2)

      n = n + 1
      grids(n)%finer = finer
      grids(n)%is_halved = is_halved
      grids(n)%n_cells = merge((grids(finer)%n_cells + 1)/2, grids(finer)%n_cells, is_halved)
   end subroutine add_grid

   !> Gap over residual of a grid of the main row.
   pure real(dp) function main_weight(grids, index, operator) result(weight)
      type(level_t), intent(in) :: grids(:)
      !> Number of the grid.
      integer, intent(in) :: index
      type(periodic_operator_t), intent(in) :: operator
      real(dp) :: before, factor

      weight = compliance_of(operator, grids(index)%n_cells)
      if (index == 1 .or. .not. operator%mean_compliance > 0) return
      associate (n => grids(index)%n_cells, finer => grids(index - 1)%n_cells)
         before = compliance_of(operator, finer)
         factor = gain
         if (.not. operator%is_symmetric .and. all(grids(index)%is_halved)) then
            before = max(before, compliance_of(operator, [n(1), finer(2)]), compliance_of(operator, [finer(1), n(2)]))
            factor = gain_of_both
         end if
         weight = min(weight, factor*max(weight - before, 0.0_dp))
      end associate
   end function main_weight

   !> Add the grids beside a grid: its cells are doubled along the direction in which that softens waves more.
   pure subroutine add_grids_beside(grids, n, index, operator)
      type(level_t), intent(inout) :: grids(:)
      !> Number of grids.
      integer, intent(inout) :: n
      !> Number of the grid beside which they stand.
      integer, intent(in) :: index
      type(periodic_operator_t), intent(in) :: operator
      logical :: is_halved(2)
      real(dp) :: before, softer
      integer :: last

      associate (cells => grids(index)%n_cells)
         if (any(cells <= fewest_cells)) return
         is_halved = compliance_of(operator, [cells(1)/2, cells(2)]) > compliance_of(operator, [cells(1), cells(2)/2])
      end associate
      is_halved(2) = .not. is_halved(1)
      last = index
      before = softness()
      do while (all(grids(last)%n_cells > fewest_cells) .and. n < size(grids))
         call add_grid(grids, n, last, is_halved)
         if (last /= index) grids(last)%coarser = n
         last = n
         softer = softness()
         grids(n)%weight = max(softer - before, 0.0_dp)
         before = softer
      end do

   contains

      !> By how much the waves of the last grid are softer than those of the grid of the same cells along the motion in the finer
      !> row.
      pure real(dp) function softness()
         integer :: cells(2)

         softness = compliance_of(operator, grids(last)%n_cells)
         if (index == 1 .or. .not. operator%mean_compliance > 0) return
         cells = merge(grids(last)%n_cells, grids(index - 1)%n_cells, is_halved)
         softness = softness - compliance_of(operator, cells)
      end function softness

   end subroutine add_grids_beside

   !> Gap over residual of the waves that a grid has.
   pure real(dp) function compliance_of(operator, n_cells) result(compliance)
      type(periodic_operator_t), intent(in) :: operator
      !> Number of cells of the grid.
      integer, intent(in) :: n_cells(2)

      compliance = operator%mean_stiffness(n_cells)
      if (compliance > 0) compliance = 1/compliance
   end function compliance_of

   !> Halve the shorter direction, or both where they are about as long, down to a few cells.
   pure subroutine plan_grids(n_cells, cell_size, is_halved)
      !> Number of cells of the finest grid in each direction.
      integer, intent(in) :: n_cells(2)
      !> Their size.
      real(dp), intent(in) :: cell_size(2)
      !> Receives for each grid whether a direction was halved from the next finer one; shape `(2, n_grids)`.
      logical, allocatable, intent(out) :: is_halved(:, :)
      integer, parameter :: most_halvings = 2*bit_size(1)
      logical :: halved(2, most_halvings)
      real(dp) :: sizes(2)
      integer :: n(2), k

      n = n_cells
      sizes = cell_size
      halved = .false.
      do k = 2, most_halvings
         halved(:, k) = n > fewest_cells .and. sizes/longest <= minval(sizes, mask=n > fewest_cells)
         if (.not. any(halved(:, k))) exit
         n = merge((n + 1)/2, n, halved(:, k))
         sizes = sizes*merge(2, 1, halved(:, k))
      end do
      allocate (is_halved, source=halved(:, :k - 1))
   end subroutine plan_grids

end module adfric_periodic_level_plan
