! SPDX-License-Identifier: GPL-3.0-or-later
!> A row of points of a grid as boxes of the grid.
module adfric_base_boxes
   use adfric_base_kinds, only: i8
   implicit none (type, external)
   private
   public :: box_t, next_box

   !> A part of a grid, the slowest dimension first.
   type :: box_t
      !> First index along each dimension, from 0.
      integer(i8), allocatable :: start(:)
      !> Number of indices along each dimension.
      integer(i8), allocatable :: count(:)
   end type box_t

contains

   !> The largest box that holds the next points of a row and no others. A row of points of a grid of r
   !> dimensions falls into 2 r - 1 boxes at most.
   pure subroutine next_box(shape, first, n_points, box)
      !> Number of indices along each dimension; the last one varies fastest.
      integer(i8), intent(in) :: shape(:)
      !> First point that remains, from 0.
      integer(i8), intent(in) :: first
      !> Number of points that remain.
      integer(i8), intent(in) :: n_points
      !> The box, whose first point is `first`.
      type(box_t), intent(out) :: box
      integer(i8) :: rest, stride
      integer :: k

      allocate (box%start(size(shape)), box%count(size(shape)), source=1_i8)
      rest = first
      do k = size(shape), 1, -1
         box%start(k) = mod(rest, shape(k))
         rest = rest/shape(k)
      end do
      stride = 1
      do k = size(shape), 1, -1
         box%count(k) = min(n_points/stride, shape(k) - box%start(k))
         stride = stride*shape(k)
         if (box%count(k) < shape(k)) return
      end do
   end subroutine next_box

end module adfric_base_boxes
