! SPDX-License-Identifier: GPL-3.0-or-later
!> Sums over maps, and multiples of maps, by all threads that there are for a point. Sums are taken row by row, then over the rows in
!> their order, so that they have the same bits for any number of threads.
module adfric_periodic_maps
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: sum_of, dot_of, add_multiple, largest_difference, is_shared

   !> Cells that are worth the work of another thread.
   integer, parameter :: cells_of_part = 2**17

contains

   !> Is a map large enough for several threads?
   pure logical function is_shared(n_cells)
      !> Number of its cells.
      integer, intent(in) :: n_cells

      is_shared = n_cells > cells_of_part
   end function is_shared

   !> Sum over all cells.
   real(dp) function sum_of(map) result(total)
      real(dp), intent(in), contiguous :: map(:, :)
      real(dp) :: rows(size(map, 2)), row
      integer :: i, j

      !$omp parallel do if(is_shared(size(map))) default(none) shared(map, rows) private(i, j, row)
      do j = 1, size(map, 2)
         row = 0
         !$omp simd reduction(+:row)
         do i = 1, size(map, 1)
            row = row + map(i, j)
         end do
         rows(j) = row
      end do
      !$omp end parallel do
      total = sum(rows)
   end function sum_of

   !> Sum of the products over all cells.
   real(dp) function dot_of(a, b) result(total)
      !> Maps of the same shape.
      real(dp), intent(in), contiguous :: a(:, :), b(:, :)
      real(dp) :: rows(size(a, 2)), row
      integer :: i, j

      !$omp parallel do if(is_shared(size(a))) default(none) shared(a, b, rows) private(i, j, row)
      do j = 1, size(a, 2)
         row = 0
         !$omp simd reduction(+:row)
         do i = 1, size(a, 1)
            row = row + a(i, j)*b(i, j)
         end do
         rows(j) = row
      end do
      !$omp end parallel do
      total = sum(rows)
   end function dot_of

   !> The largest difference of two maps, without its sign; NaN where all are.
   real(dp) function largest_difference(a, b) result(largest)
      !> Maps of the same shape.
      real(dp), intent(in), contiguous :: a(:, :), b(:, :)
      real(dp) :: rows(size(a, 2))
      integer :: j

      !$omp parallel do if(is_shared(size(a))) default(none) shared(a, b, rows) private(j)
      do j = 1, size(a, 2)
         rows(j) = maxval(abs(a(:, j) - b(:, j)))
      end do
      !$omp end parallel do
      largest = maxval(rows)
   end function largest_difference

   !> Add a multiple of a map to a map.
   subroutine add_multiple(map, factor, other)
      !> The map that is added to.
      real(dp), intent(inout), contiguous :: map(:, :)
      !> Factor of the other one.
      real(dp), intent(in) :: factor
      !> Map of the same shape.
      real(dp), intent(in), contiguous :: other(:, :)
      integer :: j

      !$omp parallel do if(is_shared(size(map))) default(none) shared(map, factor, other) private(j)
      do j = 1, size(map, 2)
         map(:, j) = map(:, j) + factor*other(:, j)
      end do
      !$omp end parallel do
   end subroutine add_multiple

end module adfric_periodic_maps
