! SPDX-License-Identifier: GPL-3.0-or-later
!> The viscoelastic foundation: a standard linear solid under a steadily moving surface.
!>
!> In the phase \( \xi = k x \) (GM 4), with lengths in any unit and stresses in that unit over K,
!> $$ w - v w' = p - u p', \qquad u = k V T_s, \quad v = \beta u. $$
!> Material enters at large \( \xi \) and leaves at small \( \xi \).
!> GM: Goryacheva, Makhovskaya, acta mechanica et automatica 5(4), 2011.
module adfric_foundation_foundation
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   implicit none (type, external)
   private
   public :: foundation_t, new_foundation

   !> Below this retardation phase the surface slides so slowly that the answer is its limit for V -> 0 to round-off,
   !> and the phases over which gaps relax can no longer be told from nothing.
   real(dp), parameter :: slowest = 1.0e-13_dp

   !> A foundation at one sliding velocity.
   type :: foundation_t
      !> Relaxation phase k V Ts [-], > 0.
      real(dp) :: u = 1
      !> Ratio of retardation to relaxation time = instantaneous over long-time stiffness [-], >= 1.
      real(dp) :: beta = 1
      !> Retardation phase beta u [-].
      real(dp) :: v = 1
      !> Storage modulus over the long-time stiffness, (1 + u v)/(1 + u^2) [-].
      real(dp) :: storage = 1
      !> Loss modulus over the long-time stiffness, (v - u)/(1 + u^2) [-].
      real(dp) :: loss = 0
   end type foundation_t

contains

   !> A foundation from its relaxation phase and its ratio of times.
   elemental subroutine new_foundation(self, u, beta)
      !> The foundation at the sliding velocity of `u`; of an elastic one `u` is set to 1.
      type(foundation_t), intent(out) :: self
      !> Relaxation phase k V Ts [-], >= 0.
      real(dp), intent(in) :: u
      !> Ratio of retardation to relaxation time Te/Ts [-], >= 1.
      real(dp), intent(in) :: beta
      real(dp) :: s

      if (has_asserts) call assert(u >= 0 .and. beta >= 1, 'new_foundation: u >= 0, beta >= 1')
      self%u = max(u, slowest/beta)
      ! nothing lags behind an elastic foundation: it knows no velocity
      if (beta <= 1) self%u = 1
      self%beta = beta
      self%v = beta*self%u
      ! (1 + u v)/(1 + u^2) = 1 + u loss, written so that neither square overflows
      s = 1/(self%u + 1/self%u)
      self%loss = (beta - 1)*s
      self%storage = 1 + (beta - 1)*s*self%u
   end subroutine new_foundation

end module adfric_foundation_foundation
