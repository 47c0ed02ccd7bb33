! SPDX-License-Identifier: GPL-3.0-or-later
!> Curvatures of the bodies that have an ellipse of contact of a given axis ratio.
module ellipse_curvatures
   use adfric_base_kinds, only: dp
   use adfric_plane_hertz_ellipse, only: ellipse_shape_t, find_shape
   implicit none (type, external)
   private
   public :: curvatures_of

contains

   !> Ratio A/B of the curvatures that belongs to an axis ratio, by halves.
   subroutine curvatures_of(axis_ratio, ratio)
      real(dp), intent(in) :: axis_ratio
      real(dp), intent(out) :: ratio
      type(ellipse_shape_t) :: shape
      real(dp) :: low, high
      integer :: k

      low = -60
      high = 0
      ratio = 1
      if (.not. axis_ratio < 1) return
      do k = 1, 70
         ratio = exp((low + high)/2)
         call find_shape(ratio, shape)
         if (shape%axis_ratio < axis_ratio) low = (low + high)/2
         if (.not. shape%axis_ratio < axis_ratio) high = (low + high)/2
      end do
   end subroutine curvatures_of

end module ellipse_curvatures
