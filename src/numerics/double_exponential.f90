! SPDX-License-Identifier: GPL-3.0-or-later
!> The integral of a function over a range at whose ends it may have roots or inverse roots, by the double exponential rule
!> (H. Takahasi, M. Mori, Publ. RIMS Kyoto Univ. 9, 721, 1974).
module adfric_numerics_double_exponential
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_asserts, only: assert, has_asserts
   implicit none (type, external)
   private
   public :: integrand_t, integrate

   !> Positions beyond this one have a share of 1e-22 of an integral with an inverse root at the end.
   real(dp), parameter :: last_position = 4.125_dp
   !> Halvings of the step.
   integer, parameter :: most_levels = 9
   !> Change of the integral, over that of the absolute values, that tells that half the step has an error of round-off.
   real(dp), parameter :: small_change = 1.0e-10_dp

   !> A function that carries its parameters.
   type, abstract :: integrand_t
   contains
      procedure(evaluate_i), deferred :: evaluate
   end type integrand_t

   abstract interface
      !> Value at a position.
      pure real(dp) function evaluate_i(self, from_left, from_right)
         import :: integrand_t, dp
         implicit none (type, external)
         !> The function with its parameters.
         class(integrand_t), intent(in) :: self
         !> Distances of the position from the ends of the range, both > 0; the smaller one has all its digits.
         real(dp), intent(in) :: from_left, from_right
      end function evaluate_i
   end interface

contains

   !> The integral, with twice as many positions until it rests.
   pure subroutine integrate(integrand, length, integral, is_converged, negligible)
      !> The function.
      class(integrand_t), intent(in) :: integrand
      !> Length of the range, >= 0.
      real(dp), intent(in) :: length
      !> The integral.
      real(dp), intent(out) :: integral
      !> Has it come to rest? One that is NaN has not.
      logical, intent(out) :: is_converged
      !> A change of this size is nothing, >= 0; not present: it has to be little beside the integral of the absolute values. It lets
      !> an integrand rest that is round-off of its own terms.
      real(dp), intent(in), optional :: negligible
      real(dp) :: step, sums(2), old_integral, nothing
      integer :: level

      if (has_asserts) call assert(length >= 0, 'integrate: length >= 0')
      integral = 0
      is_converged = .not. length > 0
      if (is_converged) return
      nothing = 0
      if (present(negligible)) nothing = negligible
      sums = 0
      step = 0.5_dp
      call add_positions(integrand, length, 0.0_dp, step, sums)
      do level = 1, most_levels
         old_integral = integral
         call add_positions(integrand, length, step/2, step, sums)
         step = step/2
         integral = length*step*sums(1)
         if (ieee_is_nan(integral)) return
         is_converged = abs(integral - old_integral) <= small_change*length*step*sums(2) + nothing .and. level > 1
         if (is_converged) return
      end do
   end subroutine integrate

   !> Add the terms at equally spaced positions, which come in pairs at the same distance from either end.
   pure subroutine add_positions(integrand, length, first, step, sums)
      class(integrand_t), intent(in) :: integrand
      !> Length of the range, > 0.
      real(dp), intent(in) :: length
      !> The first position, >= 0; at 0 is the middle of the range.
      real(dp), intent(in) :: first
      !> Distance of the positions.
      real(dp), intent(in) :: step
      !> Sums of the terms, and of their absolute values.
      real(dp), intent(inout) :: sums(2)
      real(dp) :: position, ratio, near, weight, value

      position = first
      do while (position < last_position)
         ratio = exp(-pi*sinh(position))
         near = length*(ratio/(1 + ratio))
         weight = pi*cosh(position)*ratio/(1 + ratio)**2
         value = weight*integrand%evaluate(near, length - near)
         sums = sums + [value, abs(value)]
         if (position > 0) then
            value = weight*integrand%evaluate(length - near, near)
            sums = sums + [value, abs(value)]
         end if
         position = position + step
      end do
   end subroutine add_positions

end module adfric_numerics_double_exponential
