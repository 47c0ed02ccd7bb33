! SPDX-License-Identifier: GPL-3.0-or-later
!> Does a map of heights go on where its period ends?
!>
!> The steps between neighbouring rows, the root mean square of the differences along them, are compared with the step across the
!> seam, from the last row to the first of the next period. Of a surface that is random and periodic every row might as well be
!> the last: the largest of the n steps is that across the seam with the probability 1/n, and it is larger than twice all others
!> more rarely still. A measured map that was cut out of a larger surface has a step there as large as its heights.
module adfric_shape_period_seam
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: seam_t, seam_of

   !> Steps across the seam that are so many times as large as the largest inside are pointed out.
   real(dp), parameter :: suspicious = 2

   !> Steps between rows [unit of the heights].
   type :: seam_t
      !> From the last row to the first.
      real(dp) :: step = 0
      !> The largest inside.
      real(dp) :: largest = 0
   contains
      procedure :: is_open
   end type seam_t

contains

   !> Measure the steps along a direction.
   pure type(seam_t) function seam_of(heights, direction) result(seam)
      !> Heights of the surface, in any unit; shape `(nx, ny)`.
      real(dp), intent(in) :: heights(:, :)
      !> Direction of the steps, 1: along x, 2: along y. Where there is only one row, there is no step.
      integer, intent(in) :: direction
      integer :: i, n

      n = size(heights, direction)
      do i = 1, n - 1
         seam%largest = max(seam%largest, step_between(heights, direction, i, i + 1))
      end do
      seam%step = step_between(heights, direction, n, 1)
   end function seam_of

   !> Root mean square of the differences between two rows.
   pure real(dp) function step_between(heights, direction, i, j)
      !> Heights of the surface, in any unit; shape `(nx, ny)`.
      real(dp), intent(in) :: heights(:, :)
      !> Direction of the step, 1: along x, 2: along y.
      integer, intent(in) :: direction
      !> Numbers of the two rows along the direction, from 1.
      integer, intent(in) :: i, j

      if (direction == 1) then
         step_between = norm2(heights(i, :) - heights(j, :))/sqrt(real(size(heights, 2), dp))
      else
         step_between = norm2(heights(:, i) - heights(:, j))/sqrt(real(size(heights, 1), dp))
      end if
   end function step_between

   !> Do the opposite edges not meet?
   pure logical function is_open(self)
      class(seam_t), intent(in) :: self

      is_open = self%step > suspicious*self%largest
   end function is_open

end module adfric_shape_period_seam
