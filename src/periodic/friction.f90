! SPDX-License-Identifier: GPL-3.0-or-later
!> What a rough body that slides steadily over a viscoelastic solid is held back by, without friction at the surfaces: the pressure on
!> its slopes.
!>
!> With heights h, positive into the solid, and the displacement u of the solid's surface, the stress that holds the body back along x is
!>
!> $$ T = -\overline{p h_x} = -\overline{p u_x} + \overline{p g_x} = \sum_k k_x (-\mathrm{Im} A_k) |u_k|^2, $$
!> since p = 0 or the gap g = 0 everywhere. The first form is that of the pressure, the last one that of the energy lost in the
!> solid. On cells they differ by the error of the edges, where pressure and gap begin in the same cell, and by nothing else.
module adfric_periodic_friction
   use adfric_base_kinds, only: dp
   use adfric_periodic_maps, only: dot_of
   use adfric_periodic_operator, only: periodic_operator_t
   implicit none (type, external)
   private
   public :: friction_t, get_friction, get_losses

   !> Stresses that hold a body back, along x and along y.
   type :: friction_t
      !> From the pressure on the slopes of the body [E*].
      real(dp) :: direct(2) = 0
      !> From the energy that is lost in the solid [E*].
      real(dp) :: loss(2) = 0
   end type friction_t

contains

   !> Find both forms of the friction.
   subroutine get_friction(operator, pressure, shape, gap, friction)
      !> Stiffness of the solid on the cells; nothing is lost where it is real, and nothing rubs.
      type(periodic_operator_t), intent(inout) :: operator
      !> Pressure in the middles of the cells [E*]; shape `(nx, ny)`.
      real(dp), intent(in), contiguous :: pressure(:, :)
      !> Gap of the undeformed surfaces, which is a constant less h, and that of the deformed ones; shape of `pressure`.
      real(dp), intent(in), contiguous :: shape(:, :), gap(:, :)
      type(friction_t), intent(out) :: friction
      real(dp), allocatable :: slope(:, :)
      integer :: along

      if (operator%is_symmetric) return
      allocate (slope, mold=shape)
      do along = 1, merge(1, 2, size(shape, 2) == 1)
         call operator%get_slope(along, shape, slope)
         friction%direct(along) = dot_of(pressure, slope)/size(shape)
      end do
      call get_losses(operator, gap - shape, friction%loss)
   end subroutine get_friction

   !> Find the friction from the energy that displacements lose in the solid.
   subroutine get_losses(operator, displacement, loss)
      !> Stiffness of the solid on the cells.
      type(periodic_operator_t), intent(inout) :: operator
      !> Displacement of the solid's surface, up to a constant; shape `(nx, ny)`.
      real(dp), intent(in), contiguous :: displacement(:, :)
      !> Receives the stress along x and along y [E*].
      real(dp), intent(out) :: loss(2)
      integer :: along

      loss = 0
      do along = 1, merge(1, 2, size(displacement, 2) == 1)
         call operator%get_loss(along, displacement, loss(along))
      end do
   end subroutine get_losses

end module adfric_periodic_friction
