! SPDX-License-Identifier: GPL-3.0-or-later
!> A function of one variable on panels of equal width, each with a sum of Chebyshev's polynomials.
module adfric_rough_panel_series
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_kinds, only: dp
   use adfric_numerics_chebyshev, only: chebyshev_positions, coefficients_of, degree, value_of
   implicit none (type, external)
   private
   public :: panel_series_t, new_panel_series, positions_of

   !> A function on panels.
   type :: panel_series_t
      !> Beginning of the first panel, and width of each.
      real(dp) :: low = 0, width = 1
      !> Coefficients; shape `(0:degree, n_panels)`.
      real(dp), allocatable :: coefficients(:, :)
   contains
      procedure :: value_at
   end type panel_series_t

contains

   !> The positions at which a function has to be known; shape `(0:degree, n_panels)`.
   pure function positions_of(low, width, n_panels) result(x)
      !> Beginning of the first panel, and width of each.
      real(dp), intent(in) :: low, width
      integer, intent(in) :: n_panels
      real(dp) :: x(0:degree, n_panels)
      integer :: k

      do k = 1, n_panels
         x(:, k) = low + width*(k - 1 + (1 + chebyshev_positions())/2)
      end do
   end function positions_of

   !> The series of a function.
   pure subroutine new_panel_series(self, low, width, values)
      type(panel_series_t), intent(out) :: self
      !> Beginning of the first panel, and width of each.
      real(dp), intent(in) :: low, width
      !> Its values at `positions_of`; shape `(0:degree, n_panels)`.
      real(dp), intent(in) :: values(0:, :)
      integer :: k

      self%low = low
      self%width = width
      allocate (self%coefficients(0:degree, size(values, 2)))
      do k = 1, size(values, 2)
         self%coefficients(:, k) = coefficients_of(values(:, k))
      end do
   end subroutine new_panel_series

   !> The function at a position within its panels.
   pure real(dp) function value_at(self, x) result(value)
      class(panel_series_t), intent(in) :: self
      real(dp), intent(in) :: x
      real(dp) :: position
      integer :: k

      position = (x - self%low)/self%width
      if (has_asserts) call assert(position >= 0 .and. position <= size(self%coefficients, 2), 'panel_series: a position within')
      k = min(int(position) + 1, size(self%coefficients, 2))
      value = value_of(self%coefficients(:, k), 2*(position - (k - 1)) - 1)
   end function value_at

end module adfric_rough_panel_series
