! SPDX-License-Identifier: GPL-3.0-or-later
!> What a residual costs: its square, or less where it is large.
!>
!> With z = (r/C)^2 the cost is C^2 rho(z): rho = z; huber: z up to 1, then 2 sqrt(z) - 1; soft_l1: 2 (sqrt(1 + z) - 1); cauchy: ln(1 + z). The sum of
!> costs takes the position of S, so that a loss as wide as all residuals changes nothing.
!>
!> In a least-squares search the row J becomes k J and r becomes psi/k, with psi = rho' r and k^2 = psi' = rho' + 2 z rho'': the gradient is
!> exact, and so is the curvature where psi' > 0. Elsewhere rho' takes the position of psi', as in reweighted least squares.
module adfric_fit_loss
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_fit_problem, only: loss_huber, loss_soft_l1, loss_cauchy
   implicit none (type, external)
   private
   public :: get_loss, loss_width_of

contains

   !> The width of a loss: the one given, or the usual one.
   pure real(dp) function loss_width_of(loss, width)
      !> One of `loss_...`.
      integer, intent(in) :: loss
      !> Width in standard errors, or not set.
      real(dp), intent(in) :: width

      loss_width_of = width
      if (is_set(width)) return
      select case (loss)
      case (loss_huber)
         loss_width_of = 1.345_dp
      case (loss_cauchy)
         loss_width_of = 2.385_dp
      case default
         loss_width_of = 1
      end select
   end function loss_width_of

   !> Cost of a residual, psi = half its derivative, and psi'.
   elemental subroutine get_loss(loss, width, r, cost, psi, psi_r)
      integer, intent(in) :: loss
      !> C, in standard errors.
      real(dp), intent(in) :: width
      !> The residual.
      real(dp), intent(in) :: r
      real(dp), intent(out) :: cost, psi
      !> Receives psi'.
      real(dp), intent(out) :: psi_r
      real(dp) :: z, root

      z = (r/width)**2
      select case (loss)
      case (loss_huber)
         cost = r**2
         psi = r
         psi_r = 1
         if (z <= 1) return
         cost = width**2*(2*abs(r)/width - 1)
         psi = sign(width, r)
         psi_r = 0
      case (loss_soft_l1)
         root = sqrt(1 + z)
         cost = 2*width**2*z/(root + 1)
         psi = r/root
         psi_r = 1/root**3
      case (loss_cauchy)
         cost = width**2*log(1 + z)
         psi = r/(1 + z)
         psi_r = (1 - z)/(1 + z)**2
      case default
         cost = r**2
         psi = r
         psi_r = 1
      end select
   end subroutine get_loss

end module adfric_fit_loss
