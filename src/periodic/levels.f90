! SPDX-License-Identifier: GPL-3.0-or-later
!> A cheap approximate inverse of the stiffness on the open cells: sums over grids of ever larger cells.
!>
!> A gap of the size of a grid's cells costs a pressure of the order of the mean stiffness of the waves that this grid has, so the sum
!> over all grids of the residuals over that mean is an inverse but for a factor (J. H. Bramble, J. E. Pasciak, J. Xu, Math. Comp. 55,
!> 1990, 1). A coarse cell that is open only in part takes part with its open share. So hardly any grid puts gaps where the
!> surfaces touch, other than the compliance restricted to the open cells, which forgets that at their edges. The sum is symmetric and
!> positive definite and takes no transform; seventeen iterations with it are worth ten digits, on any number of cells.
!>
!> Which grids there are, and what each makes of its residuals, stands in `adfric_periodic_level_plan`.
module adfric_periodic_levels
   use adfric_base_kinds, only: dp
   use adfric_periodic_level_plan, only: level_t, plan_levels
   use adfric_periodic_maps, only: is_shared
   use adfric_periodic_operator, only: periodic_operator_t
   use adfric_periodic_transfer, only: gather_line, spread_line, neighbour_of
   implicit none (type, external)
   private
   public :: levels_t, new_levels

   !> Part of the residuals of the four neighbours that is added to that of a cell, since the long waves of a grid are softer.
   real(dp), parameter :: neighbourly = 0.1_dp

   !> The grids. One for each contact that is solved at a time.
   type :: levels_t
      private
      !> Grids, the finest first and each after the one that it is made from; shape `(n_levels)`.
      type(level_t), allocatable :: grids(:)
      !> Does the surface go on by reflection (else periodically)?
      logical :: is_quarter = .false.
   contains
      procedure :: set_open
      procedure :: set_share
      procedure :: open_share
      procedure :: apply
   end type levels_t

contains

   !> Make the grids for the cells of an operator.
   subroutine new_levels(self, operator)
      !> Receives the grids; `set_open` comes before `apply`.
      type(levels_t), intent(out) :: self
      !> Operator of the finest grid, for its cells and stiffness.
      type(periodic_operator_t), intent(in) :: operator
      integer :: k

      self%is_quarter = operator%is_quarter
      call plan_levels(self%grids, operator)
      do k = 1, size(self%grids)
         associate (n => self%grids(k)%n_cells)
            allocate (self%grids(k)%open(n(1), n(2)))
            if (k > 1) allocate (self%grids(k)%residual(n(1), n(2)), self%grids(k)%correction(n(1), n(2)))
         end associate
      end do
   end subroutine new_levels

   !> Say which cells are open.
   subroutine set_open(self, is_open)
      class(levels_t), intent(inout) :: self
      !> Is the cell open? Shape of the cells of the finest grid.
      logical, intent(in), contiguous :: is_open(:, :)
      integer :: j

      !$omp parallel do if(is_shared(size(is_open))) default(none) shared(self, is_open) private(j)
      do j = 1, size(is_open, 2)
         self%grids(1)%open(:, j) = merge(1.0_dp, 0.0_dp, is_open(:, j))
      end do
      !$omp end parallel do
      call set_coarse_shares(self)
   end subroutine set_open

   !> Say how much each cell takes part.
   subroutine set_share(self, share)
      class(levels_t), intent(inout) :: self
      !> From 0, where the cell is as good as closed, to 1; shape of the cells of the finest grid.
      real(dp), intent(in), contiguous :: share(:, :)

      self%grids(1)%open(:, :) = share
      call set_coarse_shares(self)
   end subroutine set_share

   !> Shares of the cells of all grids but the finest.
   subroutine set_coarse_shares(self)
      class(levels_t), intent(inout) :: self
      integer :: k

      do k = 2, size(self%grids)
         call average(self%grids(self%grids(k)%finer)%open, self%grids(k)%is_halved, self%grids(k)%open)
      end do
   end subroutine set_coarse_shares

   !> 1 in open cells, 0 in closed ones.
   function open_share(self) result(open)
      class(levels_t), intent(in), target :: self
      real(dp), pointer, contiguous :: open(:, :)

      open => self%grids(1)%open
   end function open_share

   !> Means over the cells of a finer grid; a cell that is missing counts as closed.
   subroutine average(fine, is_halved, coarse)
      !> Values on the finer grid.
      real(dp), intent(in), contiguous :: fine(:, :)
      logical, intent(in) :: is_halved(2)
      !> Receives the means.
      real(dp), intent(out), contiguous :: coarse(:, :)
      real(dp) :: line(size(fine, 1) + 1)
      integer :: i, j, n, first, step(2)

      n = size(fine, 1)
      step = merge(2, 1, is_halved)
      !$omp parallel do if(is_shared(size(fine))) default(none) shared(fine, coarse, n, step) private(line, i, j, first)
      do j = 1, size(coarse, 2)
         first = step(2)*(j - 1) + 1
         line(:n) = fine(:, first)
         if (step(2) > 1 .and. first < size(fine, 2)) line(:n) = line(:n) + fine(:, first + 1)
         line(n + 1) = 0
         do i = 1, size(coarse, 1)
            coarse(i, j) = sum(line(step(1)*(i - 1) + 1:step(1)*i))/product(step)
         end do
      end do
      !$omp end parallel do
   end subroutine average

   !> Apply the approximate inverse on the open cells.
   subroutine apply(self, residual, other, correction, sums)
      class(levels_t), intent(inout) :: self
      !> What stands in closed cells does not matter; shape of the cells of the finest grid.
      real(dp), intent(in), contiguous :: residual(:, :)
      !> A field of the same shape.
      real(dp), intent(in), contiguous :: other(:, :)
      !> Receives the correction, 0 in closed cells; shape of the cells of the finest grid.
      real(dp), intent(out), contiguous :: correction(:, :)
      !> Receives the sums of correction times residual and times the other field.
      real(dp), intent(out) :: sums(2)
      real(dp) :: unused(2)
      integer :: k, n

      n = size(self%grids)
      associate (grids => self%grids)
         do k = 2, n
            associate (finer => grids(grids(k)%finer))
               if (grids(k)%finer == 1) then
                  call gather(finer, residual, self%is_quarter, grids(k))
               else
                  call gather(finer, finer%residual, self%is_quarter, grids(k))
               end if
            end associate
         end do
         do k = n, 2, -1
            call correct(grids(k), grids(k)%residual, grids(k)%residual, grids(max(grids(k)%coarser, 1)), &
               & grids(max(grids(k)%beside, 1)), self%is_quarter, grids(k)%correction, unused)
         end do
         call correct(grids(1), residual, other, grids(max(grids(1)%coarser, 1)), grids(max(grids(1)%beside, 1)), &
            & self%is_quarter, correction, sums)
      end associate
   end subroutine apply

   !> Sum the residuals of the open shares of a grid for the next coarser one: the transpose of the interpolation.
   subroutine gather(grid, residual, is_quarter, coarse)
      type(level_t), intent(in) :: grid
      !> Its residuals.
      real(dp), intent(in), contiguous :: residual(:, :)
      !> Does the surface go on by reflection (else periodically)?
      logical, intent(in) :: is_quarter
      !> The coarser grid, which receives its residuals.
      type(level_t), intent(inout) :: coarse
      real(dp) :: line(0:size(residual, 1) + 2)
      integer :: j, n, ny

      n = size(residual, 1)
      ny = size(coarse%residual, 2)
      !$omp parallel do if(is_shared(size(residual))) default(none) shared(grid, residual, is_quarter, coarse, n, ny) &
      !$omp& private(line, j)
      do j = 1, ny
         line = 0
         if (coarse%is_halved(2)) then
            call add_row(grid%open, residual, 2*j - 1, 0.75_dp, line(1:n))
            call add_row(grid%open, residual, 2*j, 0.75_dp, line(1:n))
            call add_row(grid%open, residual, merge(1, 2*neighbour_of(j, -1, ny, .false.), is_quarter .and. j == 1), 0.25_dp, &
               & line(1:n))
            call add_row(grid%open, residual, merge(2*j, 2*neighbour_of(j, 1, ny, .false.) - 1, is_quarter .and. j == ny), &
               & 0.25_dp, line(1:n))
         else
            call add_row(grid%open, residual, j, 1.0_dp, line(1:n))
         end if
         call gather_line(line, coarse%is_halved(1), is_quarter, coarse%residual(:, j))
      end do
      !$omp end parallel do
   end subroutine gather

   !> Add the residuals of a row, each with its open share; nothing where the row is missing.
   pure subroutine add_row(open, residual, j, factor, line)
      !> Open shares of the grid.
      real(dp), intent(in), contiguous :: open(:, :)
      !> Residuals of the grid.
      real(dp), intent(in), contiguous :: residual(:, :)
      !> Number of the row.
      integer, intent(in) :: j
      !> Factor of the row.
      real(dp), intent(in) :: factor
      !> Receives the sum.
      real(dp), intent(inout), contiguous :: line(:)

      if (j <= size(open, 2)) line(:) = line + factor*(open(:, j)*residual(:, j))
   end subroutine add_row

   !> What a grid makes of its residuals, and what the coarser ones made of theirs.
   subroutine correct(grid, residual, other, coarse, beside, is_quarter, correction, sums)
      type(level_t), intent(in) :: grid
      !> Its residuals.
      real(dp), intent(in), contiguous :: residual(:, :)
      !> A field of the same shape.
      real(dp), intent(in), contiguous :: other(:, :)
      !> The next coarser grid and the first one of the row beside, with their corrections, if they are.
      type(level_t), intent(in) :: coarse, beside
      !> Does the surface go on by reflection (else periodically)?
      logical, intent(in) :: is_quarter
      !> Receives the sum, times the open shares.
      real(dp), intent(out), contiguous :: correction(:, :)
      !> Receives the sums of correction times residual and times the other field.
      real(dp), intent(out) :: sums(2)
      real(dp) :: work(0:size(residual, 1) + 1, 4), rows(size(residual, 2), 2)
      integer :: j, ny

      ny = size(residual, 2)
      !$omp parallel do if(is_shared(size(residual))) default(none) &
      !$omp& shared(grid, residual, other, coarse, beside, is_quarter, correction, rows, ny) private(work, j)
      do j = 1, ny
         work(:, 3) = 0
         if (grid%coarser > 0) call interpolate(coarse, j, is_quarter, work(:, 1), work(1:size(residual, 1), 3))
         if (grid%beside > 0) then
            call interpolate(beside, j, is_quarter, work(:, 1), work(1:size(residual, 1), 4))
            ! the ends of the workspace have no values
            work(1:size(residual, 1), 3) = work(1:size(residual, 1), 3) + work(1:size(residual, 1), 4)
         end if
         associate (before => neighbour_of(j, -1, ny, is_quarter), after => neighbour_of(j, 1, ny, is_quarter))
            call correct_row(grid%weight, grid%open(:, j), grid%open(:, before), grid%open(:, after), residual(:, j), &
               & residual(:, before), residual(:, after), is_quarter, other(:, j), work, correction(:, j), rows(j, :))
         end associate
      end do
      !$omp end parallel do
      sums = sum(rows, 1)
   end subroutine correct

   !> What a grid makes of the residuals of a row and of its neighbours.
   pure subroutine correct_row(weight, open, open_before, open_after, residual, before, after, is_quarter, other, work, &
      & correction, sums)
      !> Correction over residual.
      real(dp), intent(in) :: weight
      !> Open shares of the row, the row before it and the row after it.
      real(dp), intent(in), contiguous :: open(:), open_before(:), open_after(:)
      !> Residuals of the same rows.
      real(dp), intent(in), contiguous :: residual(:), before(:), after(:)
      !> Does the surface go on by reflection (else periodically)?
      logical, intent(in) :: is_quarter
      !> Another field in the row.
      real(dp), intent(in), contiguous :: other(:)
      !> Workspace; its third column has the correction of coarser grids.
      real(dp), intent(inout), contiguous :: work(0:, :)
      !> Receives the correction.
      real(dp), intent(out), contiguous :: correction(:)
      !> Receives the sums of correction times residual and times the other field.
      real(dp), intent(out) :: sums(2)
      real(dp) :: with_residual, with_other
      integer :: i, n

      n = size(residual)
      work(1:n, 1) = open*residual
      work(0, 1) = work(neighbour_of(1, -1, n, is_quarter), 1)
      work(n + 1, 1) = work(neighbour_of(n, 1, n, is_quarter), 1)
      with_residual = 0
      with_other = 0
      !$omp simd reduction(+:with_residual, with_other)
      do i = 1, n
         correction(i) = open(i)*(work(i, 3) + weight*(work(i, 1) + neighbourly*(work(i - 1, 1) + work(i + 1, 1) &
            & + open_before(i)*before(i) + open_after(i)*after(i))))
         with_residual = with_residual + correction(i)*residual(i)
         with_other = with_other + correction(i)*other(i)
      end do
      sums = [with_residual, with_other]
   end subroutine correct_row

   !> The correction of a grid on a row of the next finer one.
   pure subroutine interpolate(coarse, j, is_quarter, values, line)
      type(level_t), intent(in) :: coarse
      !> Number of the row of the finer grid.
      integer, intent(in) :: j
      !> Does the surface go on by reflection (else periodically)?
      logical, intent(in) :: is_quarter
      real(dp), intent(inout), contiguous :: values(0:)
      !> Receives the interpolated values.
      real(dp), intent(out), contiguous :: line(:)
      integer :: row, n

      n = size(coarse%correction, 1)
      if (coarse%is_halved(2)) then
         row = (j + 1)/2
         values(1:n) = 0.75_dp*coarse%correction(:, row) &
            + 0.25_dp*coarse%correction(:, neighbour_of(row, merge(1, -1, j == 2*row), size(coarse%correction, 2), is_quarter))
      else
         values(1:n) = coarse%correction(:, j)
      end if
      call spread_line(values(0:n + 1), coarse%is_halved(1), is_quarter, line)
   end subroutine interpolate

end module adfric_periodic_levels
