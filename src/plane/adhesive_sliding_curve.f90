! SPDX-License-Identifier: GPL-3.0-or-later
!> The curve of all states of an adhesive sliding wave or cylinder that have one contact and two zones, by arclength: from first
!> touch, where the contact has no width, to the end of saturation, where the free gap has none.
module adfric_plane_adhesive_sliding_curve
   use adfric_base_kinds, only: dp
   use adfric_plane_adhesive_sliding_point_of_curve, only: curve_point_t, correct_point
   use adfric_plane_adhesive_sliding_start, only: find_start
   use adfric_plane_adhesive_sliding_zones, only: adhesive_slide_t
   implicit none (type, external)
   private
   public :: slide_curve_t, trace_curve, state_between

   integer, parameter :: most_points = 600
   !> Steps of the arclength.
   real(dp), parameter :: first_step = 0.1_dp, least_step = 1.0e-5_dp, largest_step = 0.8_dp
   !> Least cosine between the directions of neighbours, and the one from which steps grow; largest correction over the step.
   real(dp), parameter :: least_cosine = 0.9_dp, good_cosine = 0.985_dp, largest_correction = 0.3_dp
   !> The coordinate of the width at first touch, and of a wide cylinder; that of a zone at the end of saturation.
   real(dp), parameter :: touch = -12.0_dp, wide = 20.0_dp, corner = 13.0_dp

   !> The curve.
   type :: slide_curve_t
      !> Points from first touch on.
      type(curve_point_t), allocatable :: points(:)
      !> Do they reach first touch, and the end of saturation (or the load that was asked for)?
      logical :: reaches_touch = .false., reaches_corner = .false.
   end type slide_curve_t

contains

   !> Trace the whole curve
   pure subroutine trace_curve(slide, curve, is_traced, largest_load)
      type(adhesive_slide_t), intent(in) :: slide
      type(slide_curve_t), intent(out) :: curve
      !> Is there a curve
      logical, intent(out) :: is_traced
      !> Where the curve of a cylinder may end.
      real(dp), intent(in), optional :: largest_load
      type(curve_point_t) :: start
      type(curve_point_t), allocatable :: down(:), up(:)
      integer :: i, n

      call find_start(slide, start, is_traced)
      if (.not. is_traced) return
      call follow(slide, start, -1.0_dp, down, curve%reaches_touch, largest_load)
      call follow(slide, start, 1.0_dp, up, curve%reaches_corner, largest_load)
      n = size(down)
      allocate (curve%points(n + size(up) + 1))
      do i = 1, n
         curve%points(i) = down(n + 1 - i)
      end do
      curve%points(n + 1) = start
      curve%points(n + 2:) = up
   end subroutine trace_curve

   !> Follow the curve
   pure subroutine follow(slide, start, direction, points, reaches_end, largest_load)
      type(adhesive_slide_t), intent(in) :: slide
      type(curve_point_t), intent(in) :: start
      !> -1 to first touch, 1 to the end of saturation
      real(dp), intent(in) :: direction
      type(curve_point_t), allocatable, intent(out) :: points(:)
      logical, intent(out) :: reaches_end
      real(dp), intent(in), optional :: largest_load
      type(curve_point_t), allocatable :: list(:)
      type(curve_point_t) :: point, trial
      real(dp) :: step, guess(4)
      integer :: n
      logical :: is_found

      allocate (list(most_points))
      n = 0
      point = start
      step = first_step
      reaches_end = .false.
      do while (n < most_points)
         guess = point%z + direction*step*point%tangent
         if (n > 2) guess = beyond(list(n - 2:n), step)
         trial = point
         call correct_point(slide, guess, point%tangent, trial, is_found, is_rough=.true.)
         if (is_found) is_found = dot_product(trial%tangent, point%tangent) > least_cosine &
            & .and. norm2(trial%z - guess) < largest_correction*step
         if (.not. is_found) then
            step = step/3
            if (step < least_step) exit
            cycle
         end if
         n = n + 1
         list(n) = trial
         if (dot_product(trial%tangent, point%tangent) > good_cosine) step = min(1.6_dp*step, largest_step)
         point = trial
         reaches_end = ends_at(slide, point)
         if (present(largest_load) .and. direction > 0) reaches_end = reaches_end .or. (point%load > largest_load &
            & .and. point%load_slope > 0)
         if (reaches_end) exit
      end do
      points = list(:n)
   end subroutine follow

   !> Coordinates at a distance beyond the last of three points, on the parabola through them.
   pure function beyond(points, distance) result(z)
      type(curve_point_t), intent(in) :: points(3)
      real(dp), intent(in) :: distance
      real(dp) :: z(4), a, b

      b = norm2(points(3)%z - points(2)%z)
      a = b + norm2(points(2)%z - points(1)%z)
      associate (d => distance)
         z = points(1)%z*(d*(d + b)/(a*(a - b))) - points(2)%z*(d*(d + a)/(b*(a - b))) + points(3)%z*((d + a)*(d + b)/(a*b))
      end associate
   end function beyond

   !> Does the curve end at a point?
   pure logical function ends_at(slide, point)
      type(adhesive_slide_t), intent(in) :: slide
      type(curve_point_t), intent(in) :: point

      if (slide%is_wave) then
         ends_at = point%z(2) < touch .or. max(point%z(3), point%z(4)) > corner
      else
         ends_at = point%z(2) < touch .or. point%z(2) > wide
      end if
   end function ends_at

   !> A state between two neighbours.
   pure subroutine state_between(slide, first, second, share, point, is_found, wanted, which)
      type(adhesive_slide_t), intent(in) :: slide
      type(curve_point_t), intent(in) :: first, second
      real(dp), intent(in) :: share
      type(curve_point_t), intent(out) :: point
      logical, intent(out) :: is_found
      !> A load (1) or a penetration (2) that the state is to have.
      real(dp), intent(in), optional :: wanted
      integer, intent(in), optional :: which
      real(dp) :: chord(4), s, length, guess(4)

      chord = second%z - first%z
      length = norm2(chord)
      s = share
      ! Hermite's cubic
      guess = (1 + 2*s)*(1 - s)**2*first%z + s**2*(3 - 2*s)*second%z + length*(s*(1 - s)**2*first%tangent &
         & - s**2*(1 - s)*second%tangent)
      point = first
      if (present(wanted)) then
         call correct_point(slide, guess, chord/length, point, is_found, wanted, which)
      else
         call correct_point(slide, guess, chord/length, point, is_found, has_slopes=.true.)
      end if
   end subroutine state_between

end module adfric_plane_adhesive_sliding_curve
