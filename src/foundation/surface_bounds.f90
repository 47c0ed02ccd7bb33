! SPDX-License-Identifier: GPL-3.0-or-later
!> What the bounds of a foundation of columns are compared with: the slope of the surface, and the thickness of the layer over the
!> shortest wave, for columns know nothing of their neighbours.
module adfric_foundation_surface_bounds
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, two_pi
   use adfric_base_unset, only: is_set
   use adfric_describe_doubt, only: doubt_layer_too_thick, doubt_slope_too_steep
   use adfric_foundation_case, only: kind_cosines
   use adfric_foundation_given_surface, only: given_surface_t
   use adfric_foundation_stepped_case, only: spacing_of
   use adfric_foundation_variables, only: in => foundation_input
   implicit none (type, external)
   private
   public :: measure_waves, measure_heights

contains

   !> Measure a wave, by its steepest slope, or a sum of waves, by the root of the mean square of its slope.
   pure subroutine measure_waves(values, given, measures)
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      !> In: all `not_measured`. Out: with what is measured; shape `(n_doubts)`.
      real(dp), intent(inout) :: measures(:)
      integer :: k, n_waves

      n_waves = 1
      if (nint(values(in%kind)) == kind_cosines) then
         n_waves = max(1, findloc(abs(given%amplitudes) > 0, .true., dim=1, back=.true.))
         measures(doubt_slope_too_steep) = factor_of(values)*two_pi/values(in%period) &
            & *norm2([(k*given%amplitudes(k), k=1, size(given%amplitudes))])/sqrt(2.0_dp)
      else
         measures(doubt_slope_too_steep) = factor_of(values)*pi*values(in%height)/values(in%period)
      end if
      call measure_layer(values, values(in%period)/n_waves, measures)
   end subroutine measure_waves

   !> Measure heights by the root of the mean square of their slope, less its mean. The shortest wave is that of two samples, or the one
   !> below which waves are taken out; slopes are those between the middles of such waves.
   pure subroutine measure_heights(values, given, measures)
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      real(dp), intent(inout) :: measures(:)
      real(dp) :: spacing, shortest, square, trend
      integer :: lag, n, j

      spacing = spacing_of(values, given)
      shortest = 2*spacing
      if (is_set(values(in%shortest_wavelength))) shortest = max(shortest, values(in%shortest_wavelength))
      call measure_layer(values, shortest, measures)
      n = size(given%heights, 1)
      lag = max(1, min(n - 1, nint(shortest/(2*spacing))))
      if (n < 2) return
      square = 0
      do j = 1, size(given%heights, 2)
         associate (h => given%heights(:, j))
            trend = (h(n) - h(1))/(n - 1)*lag
            square = square + sum((h(1 + lag:) - h(:n - lag) - trend)**2)
         end associate
      end do
      measures(doubt_slope_too_steep) = factor_of(values)*sqrt(square/((n - lag)*size(given%heights, 2)))/(lag*spacing)
   end subroutine measure_heights

   !> Measure a layer, if its thickness is given.
   pure subroutine measure_layer(values, shortest, measures)
      real(dp), intent(in) :: values(:)
      !> The shortest wave [m].
      real(dp), intent(in) :: shortest
      !> Receives the thickness over the shortest wave.
      real(dp), intent(inout) :: measures(:)

      if (is_set(values(in%thickness))) measures(doubt_layer_too_thick) = values(in%thickness)/shortest
   end subroutine measure_layer

   !> Factor of the heights.
   pure real(dp) function factor_of(values) result(factor)
      real(dp), intent(in) :: values(:)

      factor = 1
      if (is_set(values(in%height_factor))) factor = values(in%height_factor)
   end function factor_of

end module adfric_foundation_surface_bounds
