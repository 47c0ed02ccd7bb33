! SPDX-License-Identifier: GPL-3.0-or-later
!> Points of the curve of an adhesive sliding wave that are no states: a zone bulges, its gap is larger than the range.
module adfric_plane_adhesive_sliding_bulges
   use adfric_base_kinds, only: dp
   use adfric_plane_adhesive_sliding_curve, only: slide_curve_t, state_between
   use adfric_plane_adhesive_sliding_point_of_curve, only: curve_point_t
   use adfric_plane_adhesive_sliding_profile, only: slide_profile_t, new_slide_profile, may_bulge, zone_violation
   use adfric_plane_adhesive_sliding_zones, only: adhesive_slide_t, slide_zones_t
   implicit none (type, external)
   private
   public :: keep_states

   !> Gap above the range, over the range, in a zone that still counts as one.
   real(dp), parameter :: allowed_violation = 1.0e-6_dp

contains

   !> Cut what is no state off the curve, behind the end of saturation and, where adhesion is strong, next to first touch: there
   !> zones have a gap that is larger than the range. What is left ends at the last states, not at the points that happen to be next
   !> to them: extremes of the load may lie there.
   pure subroutine keep_states(slide, curve, begins_at_touch)
      !> What slides on what.
      type(adhesive_slide_t), intent(in) :: slide
      !> In: the curve. Out: its points that are states.
      type(slide_curve_t), intent(inout) :: curve
      !> Is what is left the curve from its first point on?
      logical, intent(out) :: begins_at_touch
      type(curve_point_t), allocatable :: states(:)
      integer :: first, last, n
      logical :: is_cut

      n = size(curve%points)
      first = 1
      do while (first < n)
         if (.not. is_bulging(slide, curve%points(first)%zones)) exit
         first = first + 1
      end do
      begins_at_touch = first == 1
      last = first
      do while (last < n)
         if (is_bulging(slide, curve%points(last)%zones)) exit
         last = last + 1
      end do
      if (first == 1 .and. last == n) return
      is_cut = first > 1 .and. first < n
      states = curve%points(merge(first - 1, first, is_cut):last)
      if (is_cut) states(1) = last_state(slide, curve%points(first), curve%points(first - 1))
      if (last < n) states(size(states)) = last_state(slide, curve%points(last - 1), curve%points(last))
      call move_alloc(states, curve%points)
   end subroutine keep_states

   !> The last state between one and a neighbour that is none.
   pure function last_state(slide, state, beyond) result(last)
      type(adhesive_slide_t), intent(in) :: slide
      type(curve_point_t), intent(in) :: state, beyond
      type(curve_point_t) :: last, trial
      !> What is left of the distance of the neighbours.
      real(dp), parameter :: narrow = 1.0e-9_dp
      real(dp) :: share, step
      logical :: is_found

      last = state
      share = 0
      step = 0.5_dp
      do while (step > narrow)
         call state_between(slide, state, beyond, share + step, trial, is_found)
         if (is_found) is_found = .not. is_bulging(slide, trial%zones)
         if (is_found) then
            last = trial
            share = share + step
         end if
         step = step/2
      end do
   end function last_state

   !> Has a zone a gap that is larger than the range?
   pure logical function is_bulging(slide, zones)
      type(adhesive_slide_t), intent(in) :: slide
      type(slide_zones_t), intent(in) :: zones
      type(slide_profile_t) :: profile

      is_bulging = may_bulge(zones)
      if (.not. is_bulging) return
      call new_slide_profile(slide, zones, profile)
      is_bulging = zone_violation(profile) > allowed_violation
   end function is_bulging

end module adfric_plane_adhesive_sliding_bulges
