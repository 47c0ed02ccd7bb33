! SPDX-License-Identifier: GPL-3.0-or-later
!> A first point of the curve of states of an adhesive sliding wave or cylinder. The zones of the relaxed solid are found by
!> bisection at a given width of the contact, and then the moduli of the arms rise from nothing to their values, at that width.
!> A wave has another one at the end of saturation, which is a contact without adhesion.
module adfric_plane_adhesive_sliding_start
   use adfric_base_kinds, only: dp
   use adfric_plane_adhesive_sliding_point_of_curve, only: curve_point_t, correct_point
   use adfric_plane_adhesive_sliding_state, only: evaluate_zones
   use adfric_plane_adhesive_sliding_zones, only: adhesive_slide_t, slide_zones_t, get_zones, set_compliances
   use adfric_plane_sliding_solid, only: new_sliding_solid
   use adfric_solid_prony, only: prony_t
   implicit none (type, external)
   private
   public :: find_start, start_at_corner

   !> Half-widths of the contact at which the curve may begin.
   real(dp), parameter :: start_widths(*) = [0.5_dp, 0.2_dp, 0.05_dp, 1.0_dp, 0.01_dp, 1.7_dp]
   !> First, largest and least step of the share of the arms, and their largest number.
   real(dp), parameter :: first_step = 0.2_dp, largest_step = 0.4_dp, least_step = 1.0e-5_dp
   integer, parameter :: most_steps = 200
   !> Halvings before lines lead to the elastic zones, all steps, and the gap over the range, less 1, at which they end.
   integer, parameter :: n_halvings = 6, most_halvings = 60
   real(dp), parameter :: elastic_tolerance = 1.0e-3_dp
   !> Largest change of a coordinate in a step.
   real(dp), parameter :: largest_change = 1.5_dp
   !> Largest coordinate of a zone next to the end of saturation.
   real(dp), parameter :: near_corner = 12.0_dp
   !> The direction of the width.
   real(dp), parameter :: constant_width(4) = [0.0_dp, 1.0_dp, 0.0_dp, 0.0_dp]

contains

   !> A first point: elastic zones at a width, then the arms rise from nothing.
   pure subroutine find_start(slide, start, is_found)
      type(adhesive_slide_t), intent(in) :: slide
      type(curve_point_t), intent(out) :: start
      logical, intent(out) :: is_found
      integer :: k

      is_found = .false.
      do k = 1, size(start_widths)
         call find_start_at(slide, start_widths(k), start, is_found)
         if (is_found) return
      end do
   end subroutine find_start

   !> A point of a curve with a contact of a given width.
   pure subroutine find_start_at(slide, half_width, start, is_found)
      type(adhesive_slide_t), intent(in) :: slide
      !> Half-width of the contact, at which the arms rise.
      real(dp), intent(in) :: half_width
      type(curve_point_t), intent(out) :: start
      logical, intent(out) :: is_found
      real(dp) :: z(4)

      z = 0
      z(2) = log(half_width)
      if (slide%is_wave) z(2) = log(tan(half_width/2))
      call find_elastic_zones(slide, z, is_found)
      if (is_found) call raise_arms(slide, z, start, is_found)
   end subroutine find_start_at

   !> A point next to the end of saturation, where zones leave a free gap without length at the largest gap.
   pure subroutine start_at_corner(slide, middle, half_width, zones, start, is_found)
      type(adhesive_slide_t), intent(in) :: slide
      !> Middle and half-width of the contact at the end of saturation, and the lengths of its zones.
      real(dp), intent(in) :: middle, half_width, zones(2)
      type(curve_point_t), intent(out) :: start
      logical, intent(out) :: is_found
      real(dp), parameter :: along_both(4) = [0.0_dp, 0.0_dp, sqrt(0.5_dp), sqrt(0.5_dp)]
      real(dp) :: z(4)

      z = [middle, log(tan(half_width/2)), near_corner + log(zones/maxval(zones))]
      start%tangent = along_both
      call correct_point(slide, z, along_both, start, is_found, has_slopes=.true.)
   end subroutine start_at_corner

   !> Zones of the relaxed solid at a width.
   pure subroutine find_elastic_zones(slide, z, is_found)
      type(adhesive_slide_t), intent(in) :: slide
      real(dp), intent(inout) :: z(4)
      logical, intent(out) :: is_found
      type(adhesive_slide_t) :: relaxed
      real(dp) :: low, high, excess, excess_low, excess_high
      integer :: i, side

      relaxed = slide
      relaxed%solid%n_arms = 0
      relaxed%solid%ratios = [real(dp) ::]
      relaxed%solid%relaxation = [real(dp) ::]
      relaxed%solid%retardation = [real(dp) ::]
      relaxed%compliances = [real(dp) ::]
      low = -60
      high = merge(12.0_dp, 20.0_dp, slide%is_wave)
      excess_high = excess_of(high)
      excess_low = excess_of(low)
      is_found = excess_high > 0 .and. excess_low < 0
      if (.not. is_found) return
      side = 0
      do i = 1, most_halvings
         z(3:4) = (low + high)/2
         ! the bracket is small enough for a line
         if (i > n_halvings) z(3:4) = low - excess_low*(high - low)/(excess_high - excess_low)
         excess = excess_of(z(3))
         if (excess < 0) then
            low = z(3)
            excess_low = excess
            if (side == 1) excess_high = excess_high/2
            side = 1
         else
            high = z(3)
            excess_high = excess
            if (side == 2) excess_low = excess_low/2
            side = 2
         end if
         if (abs(excess) < elastic_tolerance) exit
      end do

   contains

      !> The gap at the ends of equal zones over the range, less 1.
      pure real(dp) function excess_of(x)
         !> Coordinate of both zones.
         real(dp), intent(in) :: x
         type(slide_zones_t) :: zones
         logical :: is_solved

         call get_zones(relaxed, [z(1), z(2), x, x], zones)
         call evaluate_zones(relaxed, zones, is_solved)
         excess_of = zones%residual(2)
      end function excess_of

   end subroutine find_elastic_zones

   !> Raise the moduli of the arms from nothing, at a constant width.
   pure subroutine raise_arms(slide, z, point, is_found)
      type(adhesive_slide_t), intent(in) :: slide
      real(dp), intent(in) :: z(4)
      type(curve_point_t), intent(out) :: point
      logical, intent(out) :: is_found
      type(adhesive_slide_t) :: part
      type(curve_point_t) :: trial
      type(prony_t) :: prony
      real(dp) :: share, step, total, new_share
      integer :: i

      point%z = z
      if (slide%solid%n_arms == 0) then
         call correct_point(slide, z, constant_width, point, is_found)
         return
      end if
      total = sum(slide%solid%ratios)
      part = slide
      prony%relaxed = 1
      prony%times = slide%solid%relaxation
      share = 0
      step = first_step
      do i = 1, most_steps
         new_share = min(1.0_dp, share + step)
         prony%moduli = slide%solid%ratios*((1 + total)**new_share - 1)/total
         part%solid = slide%solid
         if (new_share < 1) call new_sliding_solid(part%solid, prony, 1.0_dp)
         call set_compliances(part)
         trial = point
         call correct_point(part, point%z, constant_width, trial, is_found)
         if (is_found) is_found = maxval(abs(trial%z - point%z)) < largest_change
         if (is_found) then
            point = trial
            share = new_share
            if (share >= 1) exit
            step = min(largest_step, 1.5_dp*step)
         else
            step = step/2
            if (step < least_step) return
         end if
      end do
      is_found = share >= 1
      if (.not. is_found) return
      ! the derivatives are those of weaker arms, and would give the curve a wrong direction
      trial = point
      trial%tangent = 0
      call correct_point(slide, point%z, constant_width, trial, is_found, has_slopes=.true.)
      if (is_found) point = trial
   end subroutine raise_arms

end module adfric_plane_adhesive_sliding_start
