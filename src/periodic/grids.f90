! SPDX-License-Identifier: GPL-3.0-or-later
!> Fields in the middles of the cells of nested grids.
module adfric_periodic_grids
   use adfric_base_kinds, only: dp
   use adfric_periodic_transfer, only: neighbour_of
   implicit none (type, external)
   private
   public :: coarsen, halve, refine, n_grids_of

   !> A direction is not halved below this number of cells.
   integer, parameter :: fewest_cells = 8

contains

   !> Number of nested grids: one, and one more each time that the cells can be halved in all directions that vary.
   pure integer function n_grids_of(n_cells) result(n_grids)
      !> Number of cells in each direction.
      integer, intent(in) :: n_cells(2)
      integer :: n(2)

      n = n_cells
      n_grids = 1
      do while (all((mod(n, 2) == 0 .and. n >= 2*fewest_cells) .or. n == 1) .and. any(n > 1))
         n = max(n/2, 1)
         n_grids = n_grids + 1
      end do
   end function n_grids_of

   !> Means over pairs of cells, in every direction that varies.
   pure function coarsen(fine) result(coarse)
      !> Field on the finer grid: even numbers of cells, or one cell in the second direction.
      real(dp), intent(in) :: fine(:, :)
      real(dp), allocatable :: coarse(:, :)

      coarse = (fine(1::2, :) + fine(2::2, :))/2
      if (size(fine, 2) > 1) coarse = (coarse(:, 1::2) + coarse(:, 2::2))/2
   end function coarsen

   !> Cubic interpolation to cells of twice the size, in every direction that varies: a wave keeps its height, of which means over pairs
   !> take 8 % where it has 8 cells.
   pure function halve(fine, is_quarter) result(coarse)
      !> Field on the finer grid: even numbers of cells, or one cell in the second direction.
      real(dp), intent(in) :: fine(:, :)
      !> Does the field go on by reflection (else periodically)?
      logical, intent(in) :: is_quarter
      real(dp), allocatable :: coarse(:, :)

      coarse = halve_columns(fine, is_quarter)
      if (size(fine, 2) > 1) coarse = transpose(halve_columns(transpose(coarse), is_quarter))
   end function halve

   !> The same along the first direction.
   pure function halve_columns(fine, is_quarter) result(coarse)
      real(dp), intent(in) :: fine(:, :)
      logical, intent(in) :: is_quarter
      real(dp) :: coarse(size(fine, 1)/2, size(fine, 2))
      integer :: i, n

      n = size(fine, 1)
      do i = 1, n/2
         coarse(i, :) = (9*(fine(2*i - 1, :) + fine(2*i, :)) - fine(neighbour_of(2*i - 1, -1, n, is_quarter), :) &
            & - fine(neighbour_of(2*i, 1, n, is_quarter), :))/16
      end do
   end function halve_columns

   !> Linear interpolation to cells of half the size, in every direction that varies.
   pure function refine(coarse, like, is_quarter) result(fine)
      !> Field on the coarser grid.
      real(dp), intent(in) :: coarse(:, :)
      !> A field of the finer grid, for its shape.
      real(dp), intent(in) :: like(:, :)
      !> Does the field go on by reflection (else periodically)?
      logical, intent(in) :: is_quarter
      real(dp) :: fine(size(like, 1), size(like, 2))
      real(dp) :: half(size(like, 1), size(coarse, 2))
      integer :: j, n

      do j = 1, size(coarse, 2)
         call refine_line(coarse(:, j), is_quarter, half(:, j))
      end do
      n = size(coarse, 2)
      if (n == size(like, 2)) then
         fine = half
         return
      end if
      do j = 1, n
         fine(:, 2*j - 1) = (3*half(:, j) + half(:, neighbour_of(j, -1, n, is_quarter)))/4
         fine(:, 2*j) = (3*half(:, j) + half(:, neighbour_of(j, 1, n, is_quarter)))/4
      end do
   end function refine

   !> Linear interpolation to cells of half the size along one line.
   pure subroutine refine_line(coarse, is_quarter, fine)
      !> Values along a line of the coarser grid.
      real(dp), intent(in) :: coarse(:)
      !> Does the field go on by reflection (else periodically)?
      logical, intent(in) :: is_quarter
      !> Values along the same line in cells of half the size.
      real(dp), intent(out) :: fine(:)
      integer :: i, n

      n = size(coarse)
      do i = 1, n
         fine(2*i - 1) = (3*coarse(i) + coarse(neighbour_of(i, -1, n, is_quarter)))/4
         fine(2*i) = (3*coarse(i) + coarse(neighbour_of(i, 1, n, is_quarter)))/4
      end do
   end subroutine refine_line

end module adfric_periodic_grids
