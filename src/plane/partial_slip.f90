! SPDX-License-Identifier: GPL-3.0-or-later
!> Partial slip of Hertz's contacts: under a constant load P a tangential force T grows from 0, up to Coulomb's friction mu P (C. Cattaneo
!> 1938, R. D. Mindlin 1949; K. L. Johnson, Contact Mechanics, 1985, 7.2).
!>
!> The shear traction is the difference of two frictionless contacts, q = mu [p(.; P) - p(.; P*)], P* = P - T/mu, and the contact of
!> the load P* is what sticks. It is similar to the whole one: y times as large, with tau = T/(mu P)
!>
!>     y = (1 - tau)^(1/3) of a circle or an ellipse,  y = (1 - tau)^(1/2) of a line
!>
!> Nothing here is a difference of nearly equal numbers: 1 - y has a name of its own. The energies are those that a cycle of the
!> amplitude T loses, W = 4 mu^2 m int p(.; P) gap(.; P*) dA, m the ratio of the tangential to the normal compliance.
module adfric_plane_partial_slip
   use adfric_base_kinds, only: dp
   use adfric_numerics_hyperbolic, only: sinh_minus_argument
   use adfric_numerics_libm, only: expm1, log1p
   implicit none (type, external)
   private
   public :: partial_slip_t, ellipse_slip, line_slip, shear_traction

   !> How far a contact slips.
   type :: partial_slip_t
      !> Ratio y of what sticks to the whole, of half-axes; and 1 - y.
      real(dp) :: stick = 1, rest = 0
      !> Energy that a cycle loses: of an ellipse over mu P times the displacement of full slip, of a line over 4 mu^2 P^2/(pi E*).
      real(dp) :: energy = 0
   contains
      procedure :: displacement
   end type partial_slip_t

contains

   !> Slip of a contact on a circle or an ellipse.
   elemental type(partial_slip_t) function ellipse_slip(tau) result(self)
      !> Tangential force over mu P, 0 to 1.
      real(dp), intent(in) :: tau

      call set_ratio(tau, 3, self)
      associate (y => self%stick)
         self%energy = 0.8_dp*self%rest**3*(1 + y*(3 + y))
      end associate
   end function ellipse_slip

   !> Slip of a contact along a line.
   elemental type(partial_slip_t) function line_slip(tau) result(self)
      !> Tangential force over mu P, 0 to 1.
      real(dp), intent(in) :: tau

      call set_ratio(tau, 2, self)
      self%energy = 0.5_dp
      ! P P* (sinh x - x)/P^2 with x = ln(P/P*)
      if (tau < 1) self%energy = (1 - tau)*sinh_minus_argument(-log1p(-tau))
   end function line_slip

   !> The ratio of what sticks, (1 - tau)^(1/n).
   pure subroutine set_ratio(tau, n, self)
      !> Tangential force over mu P, 0 to 1.
      real(dp), intent(in) :: tau
      !> The root.
      integer, intent(in) :: n
      !> Receives the ratio, and 1 less it.
      type(partial_slip_t), intent(out) :: self

      self%stick = 0
      self%rest = 1
      if (.not. tau < 1) return
      self%stick = exp(log1p(-tau)/n)
      self%rest = -expm1(log1p(-tau)/n)
   end subroutine set_ratio

   !> Displacement of a circle or an ellipse over that of full slip, 1 - y^2.
   elemental real(dp) function displacement(self)
      class(partial_slip_t), intent(in) :: self

      displacement = self%rest*(1 + self%stick)
   end function displacement

   !> Shear traction over mu p0, p0 the largest pressure: sqrt(1 - r^2) - sqrt(y^2 - r^2), the latter where it sticks.
   elemental real(dp) function shear_traction(self, square) result(traction)
      class(partial_slip_t), intent(in) :: self
      !> r^2, r the distance from the middle in half-axes: x^2/a^2 + y^2/b^2, >= 0.
      real(dp), intent(in) :: square
      real(dp) :: left

      traction = 0
      if (.not. square < 1) return
      traction = sqrt(1 - square)
      ! of y^2 - r^2, as y^2 = 1 - (1 - y) (1 + y)
      left = (1 - square) - self%displacement()
      if (left > 0) traction = self%displacement()/(traction + sqrt(left))
   end function shear_traction

end module adfric_plane_partial_slip
