! SPDX-License-Identifier: GPL-3.0-or-later
!> Area of contact from a map of cells, and its error from coarser maps.
!>
!> Cells at the perimeter S_d are counted as a whole and so the area is too large by ((pi - 1 + ln 2)/24) S_d dx on average
!> (V. A. Yastrebov, G. Anciaux, J.-F. Molinari, Tribol. Int. 114, 2017, 161). In one dimension there is nothing to correct.
!>
!> What remains scatters with the positions of the perimeter between the cells. The number of lattice points in a disc of radius R
!> >> 1 at a random position has the variance (R/2 pi^2) sum |k|^-3 over all points k of the lattice but 0 (D. G. Kendall, Q. J.
!> Math. 19, 1948, 1), that is 0.24^2 for each of its 8 R sides. Those of many contacts add up; where symmetry positions all parts
!> alike it is four times as large.
module adfric_periodic_area
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   implicit none (type, external)
   private
   public :: area_t, area_of_cells, refine_area, relative_error_of, scatter_of_runs

   real(dp), parameter :: excess_of_perimeter = (pi - 1 + log(2.0_dp))/24
   !> Least scatter of the corrected area, as a part of S_d dx: what remains when two grids agree by accident.
   real(dp), parameter :: scatter = 0.03_dp
   !> Scatter of the number of cells over the root of that of sides: four times Kendall's, twice that of symmetric contacts.
   real(dp), parameter :: scatter_of_sides = 1.0_dp

   !> Fractions of the surface.
   type :: area_t
      !> Cells in contact.
      real(dp) :: cells = 0
      !> S_d dx: as many cells as there are sides between contact and gap.
      real(dp) :: perimeter = 0
      !> One cell: contacts and gaps that are smaller go unseen.
      real(dp) :: resolution = 0
      !> `cells` less the excess at the perimeter.
      real(dp) :: corrected = 0
      !> Bound of the error of `corrected`; the whole surface if there was no coarser grid.
      real(dp) :: error = 1
   end type area_t

contains

   !> Count cells and sides.
   pure type(area_t) function area_of_cells(is_contact, is_quarter, is_periodic) result(area)
      !> Is the cell in contact? Shape `(nx, ny)`.
      logical, intent(in) :: is_contact(:, :)
      !> Is the map a quarter between planes of symmetry (else it goes on periodically)?
      logical, intent(in) :: is_quarter
      !> Does a map that is no quarter go on periodically along x, along y? Where it does not, the contact may end at the border,
      !> which is no perimeter. Not present: it does along both.
      logical, intent(in), optional :: is_periodic(2)
      integer :: nx, ny, n_sides
      logical :: goes_on(2)

      nx = size(is_contact, 1)
      ny = size(is_contact, 2)
      n_sides = count(is_contact(2:, :) .neqv. is_contact(:nx - 1, :)) + count(is_contact(:, 2:) .neqv. is_contact(:, :ny - 1))
      goes_on = .not. is_quarter
      if (present(is_periodic)) goes_on = goes_on .and. is_periodic
      if (goes_on(1)) n_sides = n_sides + count(is_contact(1, :) .neqv. is_contact(nx, :))
      if (goes_on(2)) n_sides = n_sides + count(is_contact(:, 1) .neqv. is_contact(:, ny))
      area%cells = real(count(is_contact), dp)/size(is_contact)
      area%perimeter = real(n_sides, dp)/size(is_contact)
      area%resolution = 1/real(size(is_contact), dp)
      area%corrected = area%cells
      if (min(nx, ny) > 1) area%corrected = area%cells - excess_of_perimeter*area%perimeter
   end function area_of_cells

   !> Scatter of the area where edges are straight along x or y: a run of L sides in a line is off by a part of a cell as a whole, so
   !> that its sides count as L^2 that are each by themselves.
   pure real(dp) function scatter_of_runs(is_contact) result(scatter)
      !> Is the cell in contact? Shape `(nx, ny)`.
      logical, intent(in) :: is_contact(:, :)
      real(dp) :: square
      integer :: i, j

      square = 0
      do j = 1, size(is_contact, 2) - 1
         square = square + square_of_runs(is_contact(:, j), is_contact(:, j + 1))
      end do
      do i = 1, size(is_contact, 1) - 1
         square = square + square_of_runs(is_contact(i, :), is_contact(i + 1, :))
      end do
      scatter = scatter_of_sides*sqrt(square)/size(is_contact)
   end function scatter_of_runs

   !> Sum of the squares of the lengths of all runs between two rows.
   pure real(dp) function square_of_runs(row, next) result(square)
      logical, intent(in) :: row(:), next(:)
      integer :: i, length

      square = 0
      length = 0
      do i = 1, size(row)
         if (row(i) .eqv. next(i)) then
            length = 0
         else if (length > 0 .and. (row(i) .eqv. row(max(i - 1, 1)))) then
            ! (L + 1)^2 - L^2
            square = square + 2*length + 1
            length = length + 1
         else
            square = square + 1
            length = 1
         end if
      end do
   end function square_of_runs

   !> Estimate the error from the areas on grids of half and a quarter of the cells in each direction: the larger of the last
   !> change and half the one before, the scatter, and a cell. In one dimension each end of a contact is uncertain by a cell.
   pure subroutine refine_area(area, coarse, coarsest, is_line)
      !> Areas on the finest grid; the error is set.
      type(area_t), intent(inout) :: area
      !> Areas on the grid of half the cells in each direction.
      type(area_t), intent(in) :: coarse
      !> Areas on the grid of a quarter of the cells in each direction.
      type(area_t), intent(in) :: coarsest
      !> Does the surface not vary along y?
      logical, intent(in) :: is_line

      real(dp) :: at_edges

      at_edges = area%perimeter
      if (.not. is_line) at_edges = max(scatter*area%perimeter, scatter_of_sides*sqrt(area%perimeter*area%resolution))
      area%error = max(abs(area%corrected - coarse%corrected), abs(coarse%corrected - coarsest%corrected)/2) + at_edges &
         & + area%resolution
   end subroutine refine_area

   !> Error of the area relative to it, 1 at most; 0 without contact.
   pure real(dp) function relative_error_of(area) result(error)
      type(area_t), intent(in) :: area

      error = 0
      if (area%error > 0) error = area%error/max(area%corrected, area%error)
   end function relative_error_of

end module adfric_periodic_area
