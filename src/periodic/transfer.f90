! SPDX-License-Identifier: GPL-3.0-or-later
!> Linear interpolation from a grid to one of twice the cells in some directions, and its transpose, line by line.
!>
!> Cell I of the coarser grid covers the cells 2I - 1 and 2I of the finer one, of which the last may be missing. Values stand in the
!> middles, so a fine cell has three quarters of its coarse one and a quarter of the neighbour on its side.
module adfric_periodic_transfer
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: gather_line, spread_line, neighbour_of

contains

   !> The transpose along a line: weighted sums of fine values.
   pure subroutine gather_line(fine, is_halved, is_quarter, coarse)
      !> Values on the finer line, with one position before and behind it, and one more for a missing last cell; they are set here.
      real(dp), intent(inout), contiguous :: fine(0:)
      !> Is the coarser line of half the cells? Else it is the same.
      logical, intent(in) :: is_halved
      !> Does the line go on by reflection (else periodically)?
      logical, intent(in) :: is_quarter
      !> Receives the sums.
      real(dp), intent(out), contiguous :: coarse(:)
      integer :: i, n, n_fine

      n = size(coarse)
      if (.not. is_halved) then
         coarse(:) = fine(1:n)
         return
      end if
      n_fine = size(fine) - 3
      if (n_fine < 2*n) fine(2*n) = 0
      fine(0) = merge(fine(1), fine(2*n), is_quarter)
      fine(2*n + 1) = merge(fine(2*n), fine(1), is_quarter)
      !$omp simd
      do i = 1, n
         coarse(i) = 0.75_dp*(fine(2*i - 1) + fine(2*i)) + 0.25_dp*(fine(2*i - 2) + fine(2*i + 1))
      end do
   end subroutine gather_line

   !> The interpolation along a line.
   pure subroutine spread_line(coarse, is_halved, is_quarter, fine)
      !> Values on the coarser line, with one position before and behind it, which are set here.
      real(dp), intent(inout), contiguous :: coarse(0:)
      !> Is the coarser line of half the cells? Else it is the same.
      logical, intent(in) :: is_halved
      !> Does the line go on by reflection (else periodically)?
      logical, intent(in) :: is_quarter
      !> Receives the values on the finer line.
      real(dp), intent(out), contiguous :: fine(:)
      integer :: i, n

      n = size(coarse) - 2
      if (.not. is_halved) then
         fine(:) = coarse(1:n)
         return
      end if
      coarse(0) = merge(coarse(1), coarse(n), is_quarter)
      coarse(n + 1) = merge(coarse(n), coarse(1), is_quarter)
      !$omp simd
      do i = 1, size(fine)/2
         fine(2*i - 1) = 0.75_dp*coarse(i) + 0.25_dp*coarse(i - 1)
         fine(2*i) = 0.75_dp*coarse(i) + 0.25_dp*coarse(i + 1)
      end do
      if (mod(size(fine), 2) == 1) fine(size(fine)) = 0.75_dp*coarse(n) + 0.25_dp*coarse(n - 1)
   end subroutine spread_line

   !> The cell beside a cell, by reflection or periodically at the ends.
   pure integer function neighbour_of(i, step, n, is_quarter)
      !> Number of the cell on its line, from 1.
      integer, intent(in) :: i
      !> Side on which the neighbour lies: -1 before the cell, 1 after it.
      integer, intent(in) :: step
      !> Number of cells on the line.
      integer, intent(in) :: n
      !> Does the field go on by reflection (else periodically)?
      logical, intent(in) :: is_quarter

      neighbour_of = i + step
      if (is_quarter) then
         neighbour_of = min(max(neighbour_of, 1), n)
      else
         neighbour_of = modulo(neighbour_of - 1, n) + 1
      end if
   end function neighbour_of

end module adfric_periodic_transfer
