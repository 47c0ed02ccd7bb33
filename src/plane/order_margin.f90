! SPDX-License-Identifier: GPL-3.0-or-later
!> Do sliding adhesive states have an order, so that a least and a most adhered one are certain (docs/theory/adhesive_sliding.md)?
!>
!> The pressure at a point that a displacement elsewhere makes pulls for every distance x behind it if
!>
!>     M = min over x of Einf - sum E_i f(x/a_i) >= 0,    f(s) = s^2 [exp(-s) Ei(s) - 1/s]
!>
!> with the exponential integral Ei. The largest f is 1.784110508790133; for one time M >= 0 if E0/Einf >= 0.4394966.
module adfric_plane_order_margin
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: order_margin_of

   real(dp), parameter :: euler = 0.57721566490153286_dp
   !> Positions in a decade of the distance, and how far they go beyond the shortest and the longest length.
   integer, parameter :: per_decade = 40
   real(dp), parameter :: below = 0.1_dp, beyond = 100.0_dp
   !> Where the series of Ei ends and its asymptotic form begins.
   real(dp), parameter :: large = 45.0_dp
   integer, parameter :: golden_steps = 60

contains

   !> M over Einf.
   pure real(dp) function order_margin_of(ratios, lengths) result(margin)
      !> Moduli of the arms over the relaxed modulus, and their relaxation times or lengths in one unit, rising; shape `(n)`.
      real(dp), intent(in) :: ratios(:), lengths(:)
      real(dp), parameter :: golden = 0.6180339887498949_dp
      real(dp) :: first, step, x, low, high, one, two
      integer :: i, n, best

      margin = 1
      if (size(ratios) == 0) return
      first = log(below*lengths(1))
      n = per_decade*ceiling(log10(beyond*lengths(size(lengths))/(below*lengths(1))))
      step = log(10.0_dp)/per_decade
      best = 0
      do i = 0, n
         x = margin_at(first + i*step)
         if (x < margin) best = i
         margin = min(margin, x)
      end do
      low = first + (best - 1)*step
      high = first + (best + 1)*step
      do i = 1, golden_steps
         one = high - golden*(high - low)
         two = low + golden*(high - low)
         if (margin_at(one) < margin_at(two)) high = two
         if (.not. margin_at(one) < margin_at(two)) low = one
      end do
      margin = min(margin, margin_at((low + high)/2))

   contains

      !> What is minimised, at the logarithm of a distance.
      pure real(dp) function margin_at(logarithm)
         real(dp), intent(in) :: logarithm

         margin_at = 1 - sum(ratios*memory_of(exp(logarithm)/lengths))/(1 + sum(ratios))
      end function margin_at

   end function order_margin_of

   !> f.
   elemental real(dp) function memory_of(s)
      !> A distance over a relaxation length, > 0.
      real(dp), intent(in) :: s
      real(dp) :: term, total
      integer :: k

      if (s < large) then
         ! Ei = euler + ln s + sum s^k/(k k!)
         term = 1
         total = euler + log(s)
         do k = 1, 200
            term = term*s/k
            total = total + term/k
            if (term < 1.0e-18_dp*total .and. k > s) exit
         end do
         memory_of = s**2*exp(-s)*total - s
      else
         ! exp(-s) Ei - 1/s = sum k!/s^(k + 1) from k = 1
         term = 1
         total = 0
         do k = 1, 30
            term = term*k/s
            total = total + term
         end do
         memory_of = s*total
      end if
   end function memory_of

end module adfric_plane_order_margin
