! SPDX-License-Identifier: GPL-3.0-or-later
!> Reference values in quadruple precision, in which nothing that is tested here cancels.
module quad_precision
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: qp, storage_modulus, loss_modulus, hyperbolic_cotangent, solve_contact

   integer, parameter :: qp = selected_real_kind(33)
   real(qp), parameter :: pi = 3.14159265358979323846264338327950288_qp

contains

   !> (1 + u v)/(1 + u^2)
   pure real(qp) function storage_modulus(u, beta)
      real(dp), intent(in) :: u, beta

      storage_modulus = (1 + real(beta, qp)*real(u, qp)**2)/(1 + real(u, qp)**2)
   end function storage_modulus

   !> (v - u)/(1 + u^2)
   pure real(qp) function loss_modulus(u, beta)
      real(dp), intent(in) :: u, beta

      loss_modulus = (real(beta, qp) - 1)*real(u, qp)/(1 + real(u, qp)**2)
   end function loss_modulus

   !> coth x for x > 0.
   pure real(qp) function hyperbolic_cotangent(x)
      real(qp), intent(in) :: x

      hyperbolic_cotangent = 1
      if (x < 100) hyperbolic_cotangent = cosh(x)/sinh(x)
   end function hyperbolic_cotangent

   !> Depth and shift of a contact of given half width with adhesion in the whole gap: the pressure of a column that
   !> enters with -p0 is back at -p0 where it leaves, and the gap that it leaves with is closed a period later (GM 4.2).
   !> Both are linear in the cosine and the sine of the shift.
   pure subroutine solve_contact(u, beta, half_width, depth, shift)
      real(dp), intent(in) :: u, beta, half_width
      real(qp), intent(out) :: depth, shift
      real(qp) :: by_cos(2), by_sin(2)

      by_cos = levels(u, beta, half_width, 0.0_qp)
      by_sin = levels(u, beta, half_width, pi/2)
      shift = atan2(by_cos(1) - by_cos(2), by_sin(2) - by_sin(1))
      if (shift < 0) shift = shift + pi
      depth = 1 + by_cos(1)*cos(shift) + by_sin(1)*sin(shift)
   end subroutine solve_contact

   !> Level that the end of the contact asks for, and the one that its beginning does, at a shift.
   pure function levels(u, beta, half_width, shift)
      real(dp), intent(in) :: u, beta, half_width
      real(qp), intent(in) :: shift
      real(qp) :: levels(2)
      real(qp) :: kept, ahead, behind, g1, g2, w

      w = half_width
      g1 = storage_modulus(u, beta)
      g2 = loss_modulus(u, beta)
      ahead = g1*cos(shift + w) + g2*sin(shift + w)
      behind = g1*cos(shift - w) + g2*sin(shift - w)
      kept = exp(-2*w/u)
      levels(1) = (kept*ahead - behind)/(1 - kept)
      kept = exp(-2*(pi - w)/(real(u, qp)*beta))
      levels(2) = (kept*cos(shift - w) - cos(shift + w))/(1 - kept)
   end function levels

end module quad_precision
