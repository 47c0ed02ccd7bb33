! SPDX-License-Identifier: GPL-3.0-or-later
!> Integrals of smooth functions over ranges of any length, by Gauss's rule of 16 nodes on panels of bounded length.
!>
!> A function whose singularities are pi/2 away from the real axis is integrated to round-off by panels of length 2.
module adfric_numerics_panels
   use adfric_base_kinds, only: dp
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   implicit none (type, external)
   private
   public :: panel_integrand_t, integrate

   !> Largest length of a panel.
   real(dp), parameter :: longest = 2.0_dp

   !> A function that carries its parameters.
   type, abstract :: panel_integrand_t
   contains
      procedure(value_at_i), deferred :: value_at
   end type panel_integrand_t

   abstract interface
      !> Value at a position.
      pure real(dp) function value_at_i(self, position)
         import :: panel_integrand_t, dp
         implicit none (type, external)
         !> The function with its parameters.
         class(panel_integrand_t), intent(in) :: self
         !> Where it is evaluated, inside the range of the integral.
         real(dp), intent(in) :: position
      end function value_at_i
   end interface

contains

   !> The integral of a function from `low` to `high`.
   pure real(dp) function integrate(integrand, low, high) result(total)
      !> The function; it is not evaluated at the ends.
      class(panel_integrand_t), intent(in) :: integrand
      !> Ends of the range, `low` <= `high`.
      real(dp), intent(in) :: low, high
      real(dp) :: half, middle
      integer :: n_panels, panel, node

      n_panels = max(1, ceiling((high - low)/longest))
      half = (high - low)/(2*n_panels)
      total = 0
      do panel = 1, n_panels
         middle = low + (2*panel - 1)*half
         do node = 1, size(gauss_nodes)
            total = total + gauss_weights(node)*integrand%value_at(middle + half*gauss_nodes(node))
         end do
      end do
      total = half*total
   end function integrate

end module adfric_numerics_panels
