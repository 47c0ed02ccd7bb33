! SPDX-License-Identifier: GPL-3.0-or-later
!> The stiffness of a half-space on a few cells, summed wave by wave.
module dense_kernel
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: set_kernel

   real(dp), parameter :: two_pi = 2*acos(-1.0_dp)

contains

   !> What the pressure of each cell gets from a gap of 1 in the first one [E* over the period along x].
   subroutine set_kernel(period_y, kernel)
      !> Period along y, over that along x.
      real(dp), intent(in) :: period_y
      !> Receives the stiffness by the positions of the cells along x and y, from 0.
      real(dp), intent(out) :: kernel(0:, 0:)
      integer :: i, j, k, l, nx, ny

      nx = size(kernel, 1)
      ny = size(kernel, 2)
      kernel = 0
      do l = -(ny - 1)/2, ny/2
         do k = -(nx - 1)/2, nx/2
            do j = 0, ny - 1
               do i = 0, nx - 1
                  kernel(i, j) = kernel(i, j) + two_pi*hypot(real(k, dp), l/period_y)/2 &
                     & *cos(two_pi*(real(k*i, dp)/nx + real(l*j, dp)/ny))/(nx*ny)
               end do
            end do
         end do
      end do
   end subroutine set_kernel

end module dense_kernel
