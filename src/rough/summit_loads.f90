! SPDX-License-Identifier: GPL-3.0-or-later
!> Moments of a Gaussian above a level: G_c(x) = int_x^inf (z - x)^c phi(z) dz, c = 1/2, 1, 3/2, phi the standard density.
!>
!> They are scaled by exp(x^2/2) where x > 0. In the middle those of c = 1/2 and 3/2 are series; outside, the asymptotic
!> expansions for large |x| have all digits.
module adfric_rough_summit_loads
   use adfric_base_constants, only: pi
   use adfric_base_kinds, only: dp
   use adfric_numerics_chebyshev, only: degree
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   use adfric_rough_panel_series, only: new_panel_series, panel_series_t, positions_of
   implicit none (type, external)
   private
   public :: summit_loads_t, new_summit_loads

   !> Ends of the series, and the width of their panels; and terms of the expansions.
   real(dp), parameter :: low = -11, high = 13, width = 1
   integer, parameter :: n_panels = 24, n_terms = 16

   !> The series.
   type :: summit_loads_t
      !> Scaled G_(1/2) and G_(3/2).
      type(panel_series_t) :: half, three_halves
   contains
      procedure :: get_moments
   end type summit_loads_t

contains

   !> Find the series.
   pure subroutine new_summit_loads(self)
      type(summit_loads_t), intent(out) :: self
      real(dp) :: x(0:degree, n_panels), g(0:degree, n_panels, 2)
      integer :: j, k

      x = positions_of(low, width, n_panels)
      do k = 1, n_panels
         do j = 0, degree
            g(j, k, :) = moments_by_quadrature(x(j, k))
         end do
      end do
      call new_panel_series(self%half, low, width, g(:, :, 1))
      call new_panel_series(self%three_halves, low, width, g(:, :, 2))
   end subroutine new_summit_loads

   !> Scaled G_(1/2) and G_(3/2), with z = x + r^2.
   pure function moments_by_quadrature(x) result(g)
      real(dp), intent(in) :: x
      real(dp) :: g(2), r(size(gauss_nodes)), term(size(gauss_nodes)), most, shift
      integer, parameter :: n_parts = 8
      integer :: k

      ! beyond this z - x the density has gone
      most = sqrt(9 + max(0.0_dp, -x))
      shift = max(x, 0.0_dp)**2/2
      g = 0
      do k = 1, n_parts
         r = most/n_parts*(k - 1 + (1 + gauss_nodes)/2)
         term = gauss_weights*most/(2*n_parts)*2*r**2*exp(shift - (x + r**2)**2/2)/sqrt(2*pi)
         g = g + [sum(term), sum(term*r**2)]
      end do
   end function moments_by_quadrature

   !> Scaled G_(1/2), G_1 and G_(3/2).
   pure subroutine get_moments(self, x, g)
      class(summit_loads_t), intent(in) :: self
      !> Level.
      real(dp), intent(in) :: x
      real(dp), intent(out) :: g(3)

      if (x < low) then
         g = [moment_far_below(0.5_dp, x), -x, moment_far_below(1.5_dp, x)]
      else if (x > high) then
         g = [moment_far_above(0.5_dp, x), moment_far_above(1.0_dp, x), moment_far_above(1.5_dp, x)]
      else
         g(1) = self%half%value_at(x)
         if (x > 0) then
            g(2) = 1/sqrt(2*pi) - x*erfc_scaled(x/sqrt(2.0_dp))/2
         else
            g(2) = exp(-x**2/2)/sqrt(2*pi) - x*erfc(x/sqrt(2.0_dp))/2
         end if
         g(3) = self%three_halves%value_at(x)
      end if
   end subroutine get_moments

   !> exp(x^2/2) G_c = int_0^inf t^c exp(-x t) exp(-t^2/2) dt/sqrt(2 pi), with the second factor as a series.
   pure real(dp) function moment_far_above(c, x) result(value)
      real(dp), intent(in) :: c, x
      real(dp) :: term
      integer :: k

      term = gamma(c + 1)/(sqrt(2*pi)*x**(c + 1))
      value = term
      do k = 1, n_terms
         term = -term*((c + 2*k - 1)/x)*((c + 2*k)/x)/(2*k)
         value = value + term
      end do
   end function moment_far_above

   !> G_c as the mean of (|x| + z)^c, expanded.
   pure real(dp) function moment_far_below(c, x) result(value)
      real(dp), intent(in) :: c, x
      real(dp) :: term
      integer :: k

      term = abs(x)**c
      value = term
      do k = 1, n_terms
         term = term*((c - 2*k + 2)/x)*((c - 2*k + 1)/x)/(2*k)
         value = value + term
      end do
   end function moment_far_below

end module adfric_rough_summit_loads
