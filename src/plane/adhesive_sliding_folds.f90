! SPDX-License-Identifier: GPL-3.0-or-later
!> Extremes of load and penetration along the curve of states of an adhesive sliding wave or cylinder.
module adfric_plane_adhesive_sliding_folds
   use adfric_base_kinds, only: dp
   use adfric_plane_adhesive_sliding_curve, only: slide_curve_t, state_between
   use adfric_plane_adhesive_sliding_point_of_curve, only: curve_point_t, by_load, by_penetration
   use adfric_plane_adhesive_sliding_zones, only: adhesive_slide_t
   implicit none (type, external)
   private
   public :: insert_folds

contains

   !> Insert the extremes of load and penetration among the points.
   pure subroutine insert_folds(slide, curve)
      type(adhesive_slide_t), intent(in) :: slide
      type(slide_curve_t), intent(inout) :: curve
      integer :: which

      do which = 1, merge(2, 1, slide%is_wave)
         call insert_extremes(slide, which, curve)
      end do
   end subroutine insert_folds

   !> Insert the extremes of one of them.
   pure subroutine insert_extremes(slide, which, curve)
      type(adhesive_slide_t), intent(in) :: slide
      integer, intent(in) :: which
      type(slide_curve_t), intent(inout) :: curve
      type(curve_point_t) :: list(2*size(curve%points) + 1), extreme
      real(dp) :: v(size(curve%points)), before, after, noise
      integer :: i, n, m
      logical :: is_found

      v = curve%points%load
      if (which == by_penetration) v = curve%points%penetration
      noise = 1.0e-11_dp*maxval(abs(v))
      m = size(v)
      n = 1
      list(1) = curve%points(1)
      do i = 2, m - 1
         n = n + 1
         list(n) = curve%points(i)
         before = v(i) - v(i - 1)
         after = v(i + 1) - v(i)
         if (.not. (before*after < 0 .and. abs(before) > noise .and. abs(after) > noise)) cycle
         call state_between(slide, curve%points(i), curve%points(i + 1), 0.0_dp, extreme, is_found)
         if (.not. is_found) cycle
         ! the extreme is on that side of the point to which its slope leads
         if (slope_of(extreme, which)*after < 0) then
            call find_extreme(slide, which, curve%points(i), curve%points(i + 1), extreme, is_found)
            if (.not. is_found) cycle
            n = n + 1
            list(n) = extreme
         else
            call find_extreme(slide, which, curve%points(i - 1), curve%points(i), extreme, is_found)
            if (.not. is_found) cycle
            list(n + 1) = list(n)
            list(n) = extreme
            n = n + 1
         end if
      end do
      list(n + 1) = curve%points(m)
      curve%points = list(:n + merge(1, 0, m > 1))
   end subroutine insert_extremes

   !> Derivative along the curve.
   pure real(dp) function slope_of(point, which)
      type(curve_point_t), intent(in) :: point
      integer, intent(in) :: which

      slope_of = merge(point%load_slope, point%penetration_slope, which == by_load)
   end function slope_of

   !> The extreme between two neighbours.
   pure subroutine find_extreme(slide, which, first, second, extreme, is_found)
      type(adhesive_slide_t), intent(in) :: slide
      integer, intent(in) :: which
      type(curve_point_t), intent(in) :: first, second
      type(curve_point_t), intent(out) :: extreme
      logical, intent(out) :: is_found
      real(dp) :: low, high, f_low, f_high, share, f, scale
      integer :: i, last_side

      low = 0
      high = 1
      call state_between(slide, first, second, 0.0_dp, extreme, is_found)
      f_low = slope_of(extreme, which)
      if (is_found) call state_between(slide, first, second, 1.0_dp, extreme, is_found)
      if (.not. is_found) return
      f_high = slope_of(extreme, which)
      scale = max(abs(f_low), abs(f_high))
      is_found = f_low*f_high < 0
      if (.not. is_found) return
      last_side = 0
      do i = 1, 40
         share = low - f_low*(high - low)/(f_high - f_low)
         call state_between(slide, first, second, share, extreme, is_found)
         if (.not. is_found) return
         f = slope_of(extreme, which)
         if (f*f_low > 0) then
            low = share
            f_low = f
            if (last_side == 1) f_high = f_high/2
            last_side = 1
         else
            high = share
            f_high = f
            if (last_side == 2) f_low = f_low/2
            last_side = 2
         end if
         if (high - low < 1.0e-7_dp .or. abs(f) < 1.0e-8_dp*scale) exit
      end do
   end subroutine find_extreme

end module adfric_plane_adhesive_sliding_folds
