! SPDX-License-Identifier: GPL-3.0-or-later
!> The surface of an elastic half-space: pressure over displacement is E* |k|/2 (K. L. Johnson, Contact Mechanics, 1985,
!> section 13.2).
module adfric_periodic_elastic_kernel
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_periodic_kernel, only: kernel_t
   implicit none (type, external)
   private
   public :: elastic_kernel_t

   !> An elastic half-space, with pressures in units of its contact modulus E*.
   type, extends(kernel_t) :: elastic_kernel_t
   contains
      procedure :: get_stiffness
   end type elastic_kernel_t

contains

   !> See `kernel_t`: |k|/2 with the wave number k = 2 pi n.
   pure subroutine get_stiffness(self, n_x, n_y, cell_size, stiffness)
      class(elastic_kernel_t), intent(in) :: self
      !> Numbers of waves per length along x and along y.
      real(dp), intent(in) :: n_x(:), n_y(:)
      !> Size of the cells, not used here: this is the stiffness of the wave itself.
      real(dp), intent(in) :: cell_size(2)
      !> Receives the stiffness of each pair of numbers; shape `(size(n_y), size(n_x))`.
      complex(dp), intent(out) :: stiffness(:, :)
      integer :: i

      do i = 1, size(n_x)
         stiffness(:, i) = cmplx(two_pi*hypot(n_x(i), n_y)/2, 0.0_dp, dp)
      end do
      associate (unused => self, unused_size => cell_size)
      end associate
   end subroutine get_stiffness

end module adfric_periodic_elastic_kernel
