! SPDX-License-Identifier: GPL-3.0-or-later
!> The curve of all states of an adhesive sliding wave or cylinder that have one contact and two zones, by arclength: from first
!> touch, where the contact has no width, to the end of saturation, where the free gap has none.
!>
!> Where adhesion is strong and zones are short beside what the arms remember, a zone tilts the surface by more than the wave is
!> steep. No state begins with a touch then: those with a partial contact are a closed curve of their own.
module adfric_plane_adhesive_sliding_curve
   use adfric_base_kinds, only: dp
   use adfric_plane_adhesive_sliding_point_of_curve, only: curve_point_t, correct_point
   use adfric_plane_adhesive_sliding_start, only: find_start, start_at_corner
   use adfric_plane_adhesive_sliding_zones, only: adhesive_slide_t
   implicit none (type, external)
   private
   public :: slide_curve_t, trace_curve, trace_from_corner, roughly, state_between

   integer, parameter :: most_points = 600
   !> Steps of the arclength.
   real(dp), parameter :: first_step = 0.1_dp, least_step = 1.0e-5_dp, largest_step = 0.8_dp, straight_step = 1.6_dp
   !> Least cosine between the directions of neighbours, and the one from which steps grow; largest correction over the step.
   real(dp), parameter :: least_cosine = 0.9_dp, good_cosine = 0.985_dp, largest_correction = 0.3_dp
   !> The same of the straight parts of the curve next to its ends, where steps may be longer.
   real(dp), parameter :: straight_cosine = 0.9999_dp, straight_correction = 3.0e-3_dp
   !> Fineness of the sums along the curve: they are right to 1e-9 (`adhesive_sliding_nodes`).
   real(dp), parameter :: rough_refinement = 0.6_dp
   !> Points after which a curve may be closed, least cosine of the directions where it is, and the distance of neighbours, over
   !> their own, and of points on one plane.
   integer, parameter :: least_closed = 6
   real(dp), parameter :: near_distance = 0.1_dp, same_distance = 1.0e-5_dp
   !> The coordinate of the width at first touch, and of a wide cylinder; that of a zone at the end of saturation.
   real(dp), parameter :: touch = -12.0_dp, wide = 20.0_dp, corner = 13.0_dp

   !> The curve.
   type :: slide_curve_t
      !> Points from first touch on.
      type(curve_point_t), allocatable :: points(:)
      !> Do they reach first touch, and the end of saturation (or the load that was asked for)?
      logical :: reaches_touch = .false., reaches_corner = .false.
      !> Is the curve closed? Then its points begin at the narrowest contact, go towards the crest, and end where they begin. Once
      !> extremes are inserted (`adhesive_sliding_folds`) they begin at one, in the same direction.
      logical :: is_closed = .false.
   end type slide_curve_t

contains

   !> Trace the whole curve. Its points are near it, to 1e-6 of their coordinates.
   pure subroutine trace_curve(slide, curve, is_traced, largest_load)
      type(adhesive_slide_t), intent(in) :: slide
      type(slide_curve_t), intent(out) :: curve
      !> Is there a curve
      logical, intent(out) :: is_traced
      !> Where the curve of a cylinder may end.
      real(dp), intent(in), optional :: largest_load
      type(curve_point_t) :: start
      type(curve_point_t), allocatable :: down(:), up(:)
      type(adhesive_slide_t) :: rough
      integer :: i, n

      rough = roughly(slide)
      call find_start(rough, start, is_traced)
      if (.not. is_traced) return
      call follow(rough, start, -1.0_dp, down, curve%reaches_touch, curve%is_closed, largest_load)
      if (curve%is_closed) then
         call turn_closed(down, curve%points)
         return
      end if
      call follow(rough, start, 1.0_dp, up, curve%reaches_corner, curve%is_closed, largest_load)
      if (curve%is_closed) then
         call turn_closed(up, curve%points)
         return
      end if
      n = size(down)
      allocate (curve%points(n + size(up) + 1))
      do i = 1, n
         curve%points(i) = down(n + 1 - i)
      end do
      curve%points(n + 1) = start
      curve%points(n + 2:) = up
   end subroutine trace_curve

   !> The same with rougher sums.
   pure function roughly(slide) result(rough)
      type(adhesive_slide_t), intent(in) :: slide
      type(adhesive_slide_t) :: rough

      rough = slide
      rough%refinement = rough_refinement*slide%refinement
   end function roughly

   !> Trace the curve of a wave from the end of saturation where `trace_curve` has not found both ends, and take it if it has both
   !> and passes through what was found. A closed curve stays: what touches first then is no state (`adhesive_sliding_branch`).
   pure subroutine trace_from_corner(slide, middle, half_width, zones, curve, is_traced)
      type(adhesive_slide_t), intent(in) :: slide
      !> Middle and half-width of the contact at the end of saturation, and the lengths of its zones.
      real(dp), intent(in) :: middle, half_width, zones(2)
      !> In: the curve so far. Out: the curve.
      type(slide_curve_t), intent(inout) :: curve
      !> Is there a curve?
      logical, intent(inout) :: is_traced
      type(adhesive_slide_t) :: rough
      type(curve_point_t) :: start
      type(curve_point_t), allocatable :: points(:)
      logical :: is_found, reaches_touch, is_closed
      integer :: i, n

      rough = roughly(slide)
      call start_at_corner(rough, middle, half_width, zones, start, is_found)
      if (.not. is_found) return
      call follow(rough, start, -1.0_dp, points, reaches_touch, is_closed)
      n = size(points)
      if (.not. reaches_touch .or. n < 2) return
      ! it may be another curve
      if (is_traced) then
         is_found = .false.
         do i = 1, n - 1
            is_found = is_found .or. passes(rough, points(i), points(i + 1), curve%points(size(curve%points)/2 + 1))
         end do
         if (.not. is_found) return
      end if
      is_traced = .true.
      curve%reaches_touch = .true.
      curve%reaches_corner = .true.
      if (allocated(curve%points)) deallocate (curve%points)
      allocate (curve%points(n + 1))
      do i = 1, n
         curve%points(i) = points(n + 1 - i)
      end do
      curve%points(n + 1) = start
   end subroutine trace_from_corner

   !> Let a closed curve begin at its narrowest contact and go towards the crest.
   pure subroutine turn_closed(points, turned)
      !> The points, each once.
      type(curve_point_t), intent(in) :: points(:)
      !> The same from the narrowest contact on, which is also the last one.
      type(curve_point_t), allocatable, intent(out) :: turned(:)
      integer :: i, k, n, first
      logical :: goes_along, keeps_order

      n = size(points)
      first = minloc(points%z(2), 1)
      goes_along = dot_product(points(2)%z - points(1)%z, points(1)%tangent) > 0
      keeps_order = points(first)%tangent(1) > 0 .eqv. goes_along
      allocate (turned(n + 1))
      do i = 0, n
         k = merge(i, n - i, keeps_order)
         turned(i + 1) = points(modulo(first - 1 + k, n) + 1)
         if (keeps_order .neqv. goes_along) call reverse(turned(i + 1))
      end do
   end subroutine turn_closed

   !> Turn the direction of the curve at a point.
   pure subroutine reverse(point)
      type(curve_point_t), intent(inout) :: point

      point%tangent = -point%tangent
      point%load_slope = -point%load_slope
      point%penetration_slope = -point%penetration_slope
   end subroutine reverse

   !> Follow the curve
   pure subroutine follow(slide, start, direction, points, reaches_end, is_closed, largest_load)
      type(adhesive_slide_t), intent(in) :: slide
      type(curve_point_t), intent(in) :: start
      !> -1 to first touch, 1 to the end of saturation
      real(dp), intent(in) :: direction
      type(curve_point_t), allocatable, intent(out) :: points(:)
      !> Does it reach its end, or the start again?
      logical, intent(out) :: reaches_end, is_closed
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
      is_closed = .false.
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
         if (n > least_closed) is_closed = passes(slide, point, trial, start)
         n = n + 1
         list(n) = trial
         if (is_closed) list(n) = start
         if (is_closed) exit
         if (dot_product(trial%tangent, point%tangent) > good_cosine) step = min(1.6_dp*step, merge(straight_step, largest_step, &
            & dot_product(trial%tangent, point%tangent) > straight_cosine .and. norm2(trial%z - guess) < straight_correction*step))
         point = trial
         reaches_end = ends_at(slide, point)
         if (present(largest_load) .and. direction > 0) reaches_end = reaches_end .or. (point%load > largest_load &
            & .and. point%load_slope > 0)
         if (reaches_end) exit
      end do
      points = list(:n)
   end subroutine follow

   !> Does the curve pass through a point between two neighbours?
   pure logical function passes(slide, first, second, point)
      type(adhesive_slide_t), intent(in) :: slide
      !> The neighbours, and the point, a state.
      type(curve_point_t), intent(in) :: first, second, point
      type(curve_point_t) :: crossing
      real(dp) :: chord(4), length, share, guess(4)

      chord = second%z - first%z
      length = norm2(chord)
      share = dot_product(point%z - first%z, chord)/max(length, tiny(length))**2
      passes = share >= 0 .and. share <= 1
      if (.not. passes) return
      guess = between(first, second, share)
      passes = norm2(guess - point%z) < near_distance*length
      if (.not. passes) return
      guess = guess - dot_product(guess - point%z, point%tangent)*point%tangent
      crossing = first
      if (share > 0.5_dp) crossing = second
      call correct_point(slide, guess, point%tangent, crossing, passes)
      if (passes) passes = norm2(crossing%z - point%z) < same_distance
   end function passes

   !> Coordinates between two neighbours by Hermite's cubic. Their directions may be against the path from one to the other.
   pure function between(first, second, s) result(z)
      type(curve_point_t), intent(in) :: first, second
      !> Share of the distance.
      real(dp), intent(in) :: s
      real(dp) :: z(4), chord(4), length

      chord = second%z - first%z
      length = sign(norm2(chord), dot_product(chord, first%tangent + second%tangent))
      z = (1 + 2*s)*(1 - s)**2*first%z + s**2*(3 - 2*s)*second%z + length*(s*(1 - s)**2*first%tangent &
         & - s**2*(1 - s)*second%tangent)
   end function between

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
      real(dp) :: chord(4), length, guess(4)

      chord = second%z - first%z
      length = norm2(chord)
      guess = between(first, second, share)
      point = first
      if (present(wanted)) then
         call correct_point(slide, guess, chord/length, point, is_found, wanted, which)
      else
         call correct_point(slide, guess, chord/length, point, is_found, has_slopes=.true.)
      end if
   end subroutine state_between

end module adfric_plane_adhesive_sliding_curve
