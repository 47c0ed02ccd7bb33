! SPDX-License-Identifier: GPL-3.0-or-later
!> The largest value of a function over a range at whose ends it may have roots: positions that crowd at both ends as those of the
!> double exponential rule do, and the golden section between the neighbours of each that is above them (J. Kiefer, Proc. AMS 4,
!> 502, 1953): of two summits the higher one may have the lower of these positions.
module adfric_numerics_largest_value
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_numerics_double_exponential, only: integrand_t
   implicit none (type, external)
   private
   public :: find_largest_value

   !> The first positions stand at -12 to 12 steps; the last ones are 4e-8 of the range away from its ends.
   integer, parameter :: n_steps = 12
   !> Distance of the first positions.
   real(dp), parameter :: step = 0.2_dp
   !> Next to a maximum the function is level: a bracket of this width leaves 1e-14 of its value.
   real(dp), parameter :: last_width = 1.0e-7_dp
   !> Inverse of the golden ratio.
   real(dp), parameter :: golden = 0.6180339887498949_dp

contains

   !> The largest value; NaN if a value is NaN.
   pure subroutine find_largest_value(function, length, value)
      !> The function, with one maximum between the neighbours of a first position where it is larger than there.
      class(integrand_t), intent(in) :: function
      !> Length of the range, > 0.
      real(dp), intent(in) :: length
      !> Its largest value.
      real(dp), intent(out) :: value
      real(dp) :: values(-n_steps:n_steps)
      integer :: k

      if (has_asserts) call assert(length > 0, 'find_largest_value: length > 0')
      do k = -n_steps, n_steps
         values(k) = value_at(function, length, step*k)
      end do
      value = sum(values)
      if (ieee_is_nan(value)) return
      value = maxval(values)
      do k = -n_steps, n_steps
         if (values(k) < max(values(max(k - 1, -n_steps)), values(min(k + 1, n_steps)))) cycle
         call climb(function, length, step*(k - 1), step*(k + 1), value)
      end do
   end subroutine find_largest_value

   !> The golden section.
   pure subroutine climb(function, length, from, to, value)
      class(integrand_t), intent(in) :: function
      !> Length of the range, > 0.
      real(dp), intent(in) :: length
      !> Positions on both sides of a maximum, from the middle of the range.
      real(dp), intent(in) :: from, to
      !> In: the largest value so far. Out: the maximum, if it is larger.
      real(dp), intent(inout) :: value
      real(dp) :: low, high, positions(2), inner(2)

      low = from
      high = to
      positions = [high - golden*(high - low), low + golden*(high - low)]
      inner = [value_at(function, length, positions(1)), value_at(function, length, positions(2))]
      do while (high - low > last_width)
         if (inner(1) > inner(2)) then
            high = positions(2)
            positions = [high - golden*(high - low), positions(1)]
            inner = [value_at(function, length, positions(1)), inner(1)]
         else
            low = positions(1)
            positions = [positions(2), low + golden*(high - low)]
            inner = [inner(2), value_at(function, length, positions(2))]
         end if
      end do
      value = max(value, inner(1), inner(2))
   end subroutine climb

   !> Value at a position.
   pure real(dp) function value_at(function, length, position) result(value)
      class(integrand_t), intent(in) :: function
      !> Length of the range.
      real(dp), intent(in) :: length
      !> The position, from the middle of the range; its ends are at infinity.
      real(dp), intent(in) :: position
      real(dp) :: ratio, near

      ratio = exp(-pi*sinh(abs(position)))
      near = length*(ratio/(1 + ratio))
      if (position < 0) then
         value = function%evaluate(near, length - near)
      else
         value = function%evaluate(length - near, near)
      end if
   end function value_at

end module adfric_numerics_largest_value
