! SPDX-License-Identifier: GPL-3.0-or-later
!> Does a viscoelastic half-plane that slides keep the order of adhesive states?
!>
!> At the distance s/V behind its source a pressure answers to a displacement with a kernel of the sign of
!>
!> $$ -\Big[E_\infty - \sum_i E_i f(s/\tau_i)\Big], \qquad f(a) = a^2 (e^{-a} \mathrm{Ei}(a) - 1/a), $$
!>
!> and ahead of it, where f is below 0, it is below 0 in any case. With M the least value of the brackets over s > 0: where M >= 0 larger
!> shares of adhesion make smaller gaps and the reverse, so that there is a least and a most adhered state under each load, and
!> rounds end in them (`adfric_periodic_sliding_rounds`). f begins at 0, rises to 1.784110508790133 at a = 4.5506608795, and falls to 1: one
!> time keeps the order up to E_inf/E_0 = 2.2753304398. M depends on ratios of moduli and of times alone, and not on the velocity.
module adfric_solid_order_margin
   use adfric_base_kinds, only: dp
   use adfric_numerics_exponential_integral, only: scaled_exponential_integral
   implicit none (type, external)
   private
   public :: order_margin_of, order_function

   !> Samples of ln s per unit, where the search begins below the least time and ends above the largest one, and steps of the search
   !> for the least value between two samples.
   integer, parameter :: samples_per_unit = 16, most_steps = 60
   real(dp), parameter :: below = 1.0_dp, above = 9.0_dp
   !> Argument from which f is its asymptotic series, and the terms of it.
   real(dp), parameter :: far = 60
   integer, parameter :: n_terms = 20

contains

   !> M over the instantaneous modulus [-]: the least of the brackets; 1 for an elastic solid.
   pure real(dp) function order_margin_of(ratios, times) result(margin)
      !> Moduli of the arms over the relaxed one [-]; shape `(n_arms)`.
      real(dp), intent(in) :: ratios(:)
      !> Their relaxation times, in any unit; shape `(n_arms)`.
      real(dp), intent(in) :: times(:)
      real(dp), parameter :: golden = 0.6180339887498949_dp
      real(dp) :: first, last, step, low, high, left, right, at_left, at_right, value
      integer :: i, n, least

      margin = 1
      if (size(times) == 0) return
      first = log(minval(times)) - below
      last = log(maxval(times)) + above
      n = ceiling((last - first)*samples_per_unit)
      step = (last - first)/n
      least = 0
      do i = 0, n
         value = bracket(ratios, times, first + i*step)
         if (i > 0 .and. .not. value < margin) cycle
         margin = value
         least = i
      end do
      low = first + (least - 1)*step
      high = first + (least + 1)*step
      left = high - golden*(high - low)
      right = low + golden*(high - low)
      at_left = bracket(ratios, times, left)
      at_right = bracket(ratios, times, right)
      do i = 1, most_steps
         if (at_left < at_right) then
            high = right
            right = left
            at_right = at_left
            left = high - golden*(high - low)
            at_left = bracket(ratios, times, left)
         else
            low = left
            left = right
            at_left = at_right
            right = low + golden*(high - low)
            at_right = bracket(ratios, times, right)
         end if
      end do
      margin = min(margin, at_left, at_right)
      ! far behind all times the bracket is that of the relaxed solid
      margin = min(margin, 1/(1 + sum(ratios)))
   end function order_margin_of

   !> The bracket over the instantaneous modulus.
   pure real(dp) function bracket(ratios, times, log_time)
      real(dp), intent(in) :: ratios(:), times(:)
      !> ln s [ln of the unit of the times].
      real(dp), intent(in) :: log_time
      integer :: i

      bracket = 1
      do i = 1, size(times)
         bracket = bracket - ratios(i)/(1 + sum(ratios))*order_function(exp(log_time - log(times(i))))
      end do
   end function bracket

   !> f(a) = a^2 (exp(-a) Ei(a) - 1/a), a >= 0.
   pure real(dp) function order_function(a) result(f)
      real(dp), intent(in) :: a
      real(dp) :: term
      integer :: k

      if (.not. a > tiny(a)) then
         f = 0
      else if (a < far) then
         f = a*(a*scaled_exponential_integral(a) - 1)
      else
         f = 0
         term = 1
         do k = 1, n_terms
            f = f + term
            term = term*(k + 1)/a
         end do
      end if
   end function order_function

end module adfric_solid_order_margin
