! SPDX-License-Identifier: GPL-3.0-or-later
!> A cylinder that rolls on another and drives it by friction (F. W. Carter, Proc. R. Soc. Lond. A 112 (1926) 151; K. L. Johnson,
!> Contact Mechanics, 1985, 8.3). It rolls to +x, x in half-widths a of the contact, and r is 1 less the width of what sticks:
!>
!>     q/(mu p0) = sqrt(1 - x^2) - sqrt(y^2 - (x - r)^2),  y = 1 - r = sqrt(1 - T/(mu P)),  xi = xi_1 r,  xi_1 = mu a/R
!>
!> What sticks is -1 + 2 r < x < 1, at the leading edge. Behind it the surfaces slip by s/(xi_1 V) = sqrt((1 - x) (2 r - 1 - x)).
!> From the creepage xi_1 on all of it slips, and T stays mu P. No form is a difference of nearly equal numbers.
module adfric_plane_rolling_line
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_plane_partial_slip, only: line_slip, partial_slip_t
   implicit none (type, external)
   private
   public :: rolling_t, rolling_of_force, rolling_of_creepage, rolling_traction, rolling_slip, rolling_loss

   !> Positions where the loss of energy is summed. It is a sine times a polynomial of degree 2: a few are exact.
   integer, parameter :: n_positions = 8

   !> A contact that rolls.
   type :: rolling_t
      !> r, the share of the width that slips.
      real(dp) :: rest = 0
      !> Creepage over xi_1, >= 0; above 1 all of the contact slips.
      real(dp) :: creepage = 0
   contains
      procedure :: force
   end type rolling_t

contains

   !> Rolling under a force.
   elemental type(rolling_t) function rolling_of_force(tau) result(self)
      !> Tangential force over mu P, 0 to 1.
      real(dp), intent(in) :: tau
      type(partial_slip_t) :: slip

      slip = line_slip(tau)
      self%rest = slip%rest
      self%creepage = slip%rest
   end function rolling_of_force

   !> Rolling with a creepage.
   elemental type(rolling_t) function rolling_of_creepage(creepage) result(self)
      !> Creepage over xi_1, >= 0.
      real(dp), intent(in) :: creepage

      self%rest = min(creepage, 1.0_dp)
      self%creepage = creepage
   end function rolling_of_creepage

   !> Tangential force over mu P, 1 - y^2.
   elemental real(dp) function force(self)
      class(rolling_t), intent(in) :: self

      force = self%rest*(2 - self%rest)
   end function force

   !> Shear traction over mu p0.
   elemental real(dp) function rolling_traction(self, x) result(traction)
      type(rolling_t), intent(in) :: self
      !> Position from the middle in half-widths, the leading edge at 1.
      real(dp), intent(in) :: x

      traction = 0
      if (abs(x) < 1) traction = traction_behind(self, 1 + x)
   end function rolling_traction

   !> Velocity of slip over xi_1 and the velocity of rolling.
   elemental real(dp) function rolling_slip(self, x) result(slip)
      type(rolling_t), intent(in) :: self
      !> Position from the middle in half-widths, the leading edge at 1.
      real(dp), intent(in) :: x

      slip = 0
      if (abs(x) < 1) slip = slip_behind(self, 1 + x)
   end function rolling_slip

   !> Shear traction over mu p0, by the distance from the trailing edge.
   elemental real(dp) function traction_behind(self, e) result(traction)
      type(rolling_t), intent(in) :: self
      !> 1 + x, 0 to 2.
      real(dp), intent(in) :: e
      real(dp) :: stick

      traction = sqrt((2 - e)*e)
      ! y^2 - (x - r)^2
      stick = (2 - e)*(e - 2*self%rest)
      if (stick > 0) traction = 2*self%rest*(2 - e)/(traction + sqrt(stick))
   end function traction_behind

   !> Velocity of slip over xi_1 and the velocity of rolling, by the distance from the trailing edge.
   elemental real(dp) function slip_behind(self, e) result(slip)
      type(rolling_t), intent(in) :: self
      !> 1 + x, 0 to 2.
      real(dp), intent(in) :: e

      slip = self%creepage - self%rest + sqrt(max((2 - e)*(2*self%rest - e), 0.0_dp))
   end function slip_behind

   !> Work of the traction on the slip, over mu P xi_1 and the distance that is rolled: from both of them as they are along x.
   pure real(dp) function rolling_loss(self) result(loss)
      type(rolling_t), intent(in) :: self
      real(dp) :: angle, e
      integer :: k

      loss = 0
      do k = 1, n_positions
         ! what slips begins at the trailing edge, and r is its half-width
         angle = k*pi/(n_positions + 1)
         e = self%rest*(1 + cos(angle))
         loss = loss + traction_behind(self, e)*slip_behind(self, e)*self%rest*sin(angle)
      end do
      ! P = (pi/2) p0 a
      loss = 2*loss/(n_positions + 1)
   end function rolling_loss

end module adfric_plane_rolling_line
