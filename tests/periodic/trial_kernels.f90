! SPDX-License-Identifier: GPL-3.0-or-later
!> Kernels for tests of the periodic operator: a solid twice as stiff, and one whose displacement lags behind.
module trial_kernels
   use adfric_base_kinds, only: dp
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_kernel, only: kernel_t
   implicit none (type, external)
   private
   public :: stiff_kernel_t, lagging_kernel_t

   !> Twice the stiffness of an elastic half-space.
   type, extends(kernel_t) :: stiff_kernel_t
   contains
      procedure :: get_stiffness => stiffness_of_stiff
   end type stiff_kernel_t

   !> An elastic half-space whose displacement lags behind along x.
   type, extends(kernel_t) :: lagging_kernel_t
   contains
      procedure :: get_stiffness => stiffness_of_lagging
   end type lagging_kernel_t

contains

   pure subroutine stiffness_of_stiff(self, n_x, n_y, cell_size, stiffness)
      class(stiff_kernel_t), intent(in) :: self
      real(dp), intent(in) :: n_x(:), n_y(:), cell_size(2)
      complex(dp), intent(out) :: stiffness(:, :)
      type(elastic_kernel_t) :: elastic

      call elastic%get_stiffness(n_x, n_y, cell_size, stiffness)
      stiffness = 2*stiffness
      associate (unused => self)
      end associate
   end subroutine stiffness_of_stiff

   pure subroutine stiffness_of_lagging(self, n_x, n_y, cell_size, stiffness)
      class(lagging_kernel_t), intent(in) :: self
      real(dp), intent(in) :: n_x(:), n_y(:), cell_size(2)
      complex(dp), intent(out) :: stiffness(:, :)
      type(elastic_kernel_t) :: elastic

      call elastic%get_stiffness(n_x, n_y, cell_size, stiffness)
      stiffness = stiffness*(1 + (0.0_dp, 0.1_dp)*spread(sign(1.0_dp, n_x), 1, size(n_y)))
      associate (unused => self)
      end associate
   end subroutine stiffness_of_lagging

end module trial_kernels
