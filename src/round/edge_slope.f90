! SPDX-License-Identifier: GPL-3.0-or-later
!> How steep an indenter is at the edge of its contact, as the bounds of the theory ask: small slopes are assumed of every profile.
module adfric_round_edge_slope
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_round_variables, only: kind_cone, kind_flat_cone, kind_flat_paraboloid, kind_paraboloid, &
      & kind_polynomial, kind_power, kind_rounded_cone, kind_rounded_punch, kind_sphere, in => indenter_input
   use adfric_describe_doubt, only: doubt_contact_too_wide, doubt_slope_too_steep
   implicit none (type, external)
   private
   public :: measure_edge, slope_of

   !> Logarithm of a slope that is more than any bound.
   real(dp), parameter :: most = 50.0_dp

contains

   !> Measure the contact of a radius: of round bodies its width, of others the slope at its edge.
   pure subroutine measure_edge(values, radius, measures)
      !> Values of the variables up to the shape; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Radius of contact [m]; NaN if it is not known, when only the slope of a cone is.
      real(dp), intent(in) :: radius
      !> In: all `not_measured`. Out: with what is measured; shape `(n_doubts)`.
      real(dp), intent(inout) :: measures(:)
      integer :: kind

      kind = nint(values(in%kind))
      if (ieee_is_nan(radius)) then
         if (kind == kind_cone) measures(doubt_slope_too_steep) = slope_of(values)
         return
      end if
      ! what does not touch has no edge
      if (.not. radius > 0) return
      select case (kind)
      case (kind_paraboloid, kind_sphere)
         measures(doubt_contact_too_wide) = radius/values(in%radius)
      case (kind_flat_paraboloid)
         if (radius > values(in%face_radius)) measures(doubt_contact_too_wide) = radius/values(in%radius)
      case (kind_rounded_punch)
         measures(doubt_contact_too_wide) = max(0.0_dp, radius - values(in%face_radius))/values(in%radius)
      case (kind_cone)
         measures(doubt_slope_too_steep) = slope_of(values)
      case (kind_flat_cone)
         if (radius > values(in%face_radius)) measures(doubt_slope_too_steep) = slope_of(values)
      case (kind_rounded_cone)
         measures(doubt_slope_too_steep) = min(radius/values(in%radius), slope_of(values))
      case (kind_power)
         measures(doubt_slope_too_steep) = slope_of_power(values(in%coefficient), values(in%exponent), radius)
      case (kind_polynomial)
         measures(doubt_slope_too_steep) = slope_of_polynomial(values(in%coefficient_1:in%coefficient_8), radius)
      end select
   end subroutine measure_edge

   !> Slope n C a^(n - 1) of a power, or one beyond all bounds.
   pure real(dp) function slope_of_power(coefficient, exponent, radius) result(slope)
      !> C [m^(1 - n)] > 0, and n [-] > 0.
      real(dp), intent(in) :: coefficient, exponent
      !> Radius [m], > 0.
      real(dp), intent(in) :: radius

      slope = exp(max(-most, min(most, log(exponent) + log(coefficient) + (exponent - 1)*log(radius))))
   end function slope_of_power

   !> Slope of a sum of powers with the exponents 1, 2, ...
   pure real(dp) function slope_of_polynomial(coefficients, radius) result(slope)
      !> Coefficients >= 0.
      real(dp), intent(in) :: coefficients(:)
      real(dp), intent(in) :: radius
      integer :: k

      slope = 0
      do k = 1, size(coefficients)
         if (coefficients(k) > 0) slope = slope + slope_of_power(coefficients(k), real(k, dp), radius)
      end do
   end function slope_of_polynomial

   !> k of a cone.
   pure real(dp) function slope_of(values)
      real(dp), intent(in) :: values(:)

      slope_of = values(in%slope)
      if (.not. is_set(slope_of)) slope_of = 1/tan(values(in%half_angle))
   end function slope_of

end module adfric_round_edge_slope
