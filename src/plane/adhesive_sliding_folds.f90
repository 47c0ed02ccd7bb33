! SPDX-License-Identifier: GPL-3.0-or-later
!> Extremes of load and penetration along the curve of states of an adhesive sliding wave or cylinder.
module adfric_plane_adhesive_sliding_folds
   use adfric_base_kinds, only: dp
   use adfric_plane_adhesive_sliding_curve, only: slide_curve_t, roughly
   use adfric_plane_adhesive_sliding_point_of_curve, only: curve_point_t, by_load, by_penetration, correct_point
   use adfric_plane_adhesive_sliding_zones, only: adhesive_slide_t
   implicit none (type, external)
   private
   public :: insert_folds

   !> What a value may be off, over its size.
   real(dp), parameter :: round_off = 1.0e-13_dp
   !> Changes of a value over its size that points near the curve do not tell.
   real(dp), parameter :: rough_noise = 1.0e-6_dp
   !> Slope over the values beside the extreme, below which differences do not tell its sign.
   real(dp), parameter :: least_slope = 1.0e-7_dp
   !> Width of a bracket that needs no more steps, and their largest number.
   real(dp), parameter :: last_width = 1.0e-8_dp
   integer, parameter :: most_steps = 40

contains

   !> Insert the extremes of load and penetration among the points.
   pure subroutine insert_folds(slide, curve)
      type(adhesive_slide_t), intent(in) :: slide
      type(slide_curve_t), intent(inout) :: curve
      integer :: which

      do which = 1, merge(2, 1, slide%is_wave)
         if (curve%is_closed) then
            call insert_on_closed(slide, which, curve)
         else
            call insert_extremes(slide, which, curve)
         end if
      end do
   end subroutine insert_folds

   !> A closed curve has no ends: its first point may lie beside an extreme, too. Its points go on to the third one for the search.
   !> Then they begin and end at the foot of the arc that rises to the largest load.
   pure subroutine insert_on_closed(slide, which, curve)
      type(adhesive_slide_t), intent(in) :: slide
      integer, intent(in) :: which
      type(slide_curve_t), intent(inout) :: curve
      type(curve_point_t) :: lapped(size(curve%points) + 2), second
      integer :: first, last, least, i, n

      second = curve%points(2)
      lapped(:size(curve%points)) = curve%points
      lapped(size(lapped) - 1:) = curve%points(2:3)
      curve%points = lapped
      call insert_extremes(slide, which, curve)
      ! once around: from behind the second point to where it stands again
      first = 2
      do while (is_elsewhere(first))
         first = first + 1
      end do
      last = size(curve%points)
      do while (is_elsewhere(last))
         last = last - 1
      end do
      n = last - first
      least = maxloc([(curve%points(first + i)%load, i=1, n)], 1)
      do i = 1, n
         if (.not. curve%points(around(least - 1))%load < curve%points(around(least))%load) exit
         least = least - 1
      end do
      curve%points = [(curve%points(around(least + i)), i=0, n)]

   contains

      !> Index of a point that is counted once around.
      pure integer function around(k)
         integer, intent(in) :: k

         around = first + 1 + modulo(k - 1, n)
      end function around

      !> Is a point not the second one?
      pure logical function is_elsewhere(k)
         integer, intent(in) :: k

         is_elsewhere = norm2(curve%points(k)%z - second%z) > 0
      end function is_elsewhere

   end subroutine insert_on_closed

   !> Insert the extremes of one of them.
   pure subroutine insert_extremes(slide, which, curve)
      type(adhesive_slide_t), intent(in) :: slide
      integer, intent(in) :: which
      type(slide_curve_t), intent(inout) :: curve
      type(curve_point_t) :: list(2*size(curve%points) + 1), extreme, three(3)
      real(dp) :: v(size(curve%points)), before, after, noise, size_of, w(3)
      integer :: i, n, m
      type(adhesive_slide_t) :: rough
      logical :: is_found, is_behind

      rough = roughly(slide)
      v = values_of(curve%points, which)
      size_of = maxval(abs(v))
      noise = round_off*size_of
      m = size(v)
      n = 1
      list(1) = curve%points(1)
      do i = 2, m - 1
         n = n + 1
         list(n) = curve%points(i)
         before = v(i) - v(i - 1)
         after = v(i + 1) - v(i)
         if (.not. (before*after < 0 .and. min(abs(before), abs(after)) > noise)) cycle
         three = curve%points(i - 1:i + 1)
         if (min(abs(before), abs(after)) < rough_noise*size_of) then
            call polish(slide, three, is_found)
            w = values_of(three, which)
            if (.not. (is_found .and. (w(2) - w(1))*(w(3) - w(2)) < 0)) cycle
         end if
         call find_extreme(rough, which, three, size_of, extreme, is_behind, is_found)
         if (is_found) call correct_point(slide, extreme%z, extreme%tangent, extreme, is_found)
         if (.not. is_found) cycle
         if (is_behind) then
            list(n + 1) = extreme
         else
            list(n + 1) = list(n)
            list(n) = extreme
         end if
         n = n + 1
      end do
      list(n + 1) = curve%points(m)
      curve%points = list(:n + merge(1, 0, m > 1))
   end subroutine insert_extremes

   !> Bring three points onto the curve.
   pure subroutine polish(slide, points, is_found)
      type(adhesive_slide_t), intent(in) :: slide
      type(curve_point_t), intent(inout) :: points(3)
      logical, intent(out) :: is_found
      integer :: k

      do k = 1, 3
         call correct_point(slide, points(k)%z, points(k)%tangent, points(k), is_found)
         if (.not. is_found) return
      end do
   end subroutine polish

   !> The extreme between three neighbours: where the derivative along the curve is 0. x is the distance from the middle one along
   !> its tangent. A parabola says where the search begins; secants end it where they expect no change of the value.
   pure subroutine find_extreme(slide, which, points, size_of, extreme, is_behind, is_found)
      type(adhesive_slide_t), intent(in) :: slide
      integer, intent(in) :: which
      type(curve_point_t), intent(in) :: points(3)
      !> Largest size of the value on the curve.
      real(dp), intent(in) :: size_of
      type(curve_point_t), intent(out) :: extreme
      !> Is it behind the middle one?
      logical, intent(out) :: is_behind, is_found
      real(dp) :: x, ends(2), values(3), bend, slope, old_slope, move, old_x
      integer :: i

      is_behind = .false.
      ends = [dot_product(points(2)%tangent, points(1)%z - points(2)%z), dot_product(points(2)%tangent, points(3)%z - points(2)%z)]
      is_found = ends(1) < 0 .and. ends(2) > 0
      if (.not. is_found) return
      values = values_of(points, which)
      ! the second derivative of the parabola
      bend = 2*((values(3) - values(2))/ends(2) - (values(1) - values(2))/ends(1))/(ends(2) - ends(1))
      x = vertex(ends(1), ends(2), values)
      extreme = points(2)
      extreme%has_derivatives = .false.
      call correct_point(slide, on_parabola(points, ends, x), points(2)%tangent, extreme, is_found, has_slopes=.true.)
      do i = 1, most_steps
         if (.not. is_found) return
         is_behind = x > 0
         slope = slope_along(extreme, which, points(2)%tangent)
         if (i > 1) then
            ! a secant that bends the other way is not used
            if ((slope - old_slope)/(x - old_x)*bend > 0) bend = (slope - old_slope)/(x - old_x)
         end if
         if (slope**2 < round_off*size_of*abs(bend) .or. abs(slope) < least_slope*maxval(abs(values))) return
         if (slope*bend > 0) ends(2) = x
         if (.not. slope*bend > 0) ends(1) = x
         if (ends(2) - ends(1) < last_width) return
         move = -slope/bend
         if (.not. (x + move > ends(1) .and. x + move < ends(2))) move = (ends(1) + ends(2))/2 - x
         old_x = x
         old_slope = slope
         x = x + move
         call correct_point(slide, extreme%z + (move/dot_product(points(2)%tangent, extreme%tangent))*extreme%tangent, &
            & points(2)%tangent, extreme, is_found, has_slopes=.true.)
      end do
      is_found = .false.
   end subroutine find_extreme

   !> Derivative by the distance along a direction.
   pure real(dp) function slope_along(point, which, direction)
      type(curve_point_t), intent(in) :: point
      integer, intent(in) :: which
      real(dp), intent(in) :: direction(4)

      slope_along = merge(point%load_slope, point%penetration_slope, which == by_load)/dot_product(point%tangent, direction)
   end function slope_along

   !> Loads or penetrations.
   pure function values_of(points, which) result(values)
      type(curve_point_t), intent(in) :: points(:)
      integer, intent(in) :: which
      real(dp) :: values(size(points))

      values = points%load
      if (which == by_penetration) values = points%penetration
   end function values_of

   !> Where a parabola has its extreme that passes three values at low, 0 and high.
   pure real(dp) function vertex(low, high, values)
      real(dp), intent(in) :: low, high, values(3)
      real(dp) :: one, two

      one = (values(1) - values(2))/low
      two = (values(3) - values(2))/high
      vertex = (high*one - low*two)/(2*(one - two))
   end function vertex

   !> Coordinates on the parabola through three points.
   pure function on_parabola(points, ends, x) result(z)
      type(curve_point_t), intent(in) :: points(3)
      real(dp), intent(in) :: ends(2), x
      real(dp) :: z(4)

      associate (a => ends(1), b => ends(2))
         z = points(1)%z*(x*(x - b)/(a*(a - b))) + points(2)%z*((x - a)*(x - b)/(a*b)) + points(3)%z*(x*(x - a)/(b*(b - a)))
      end associate
   end function on_parabola

end module adfric_plane_adhesive_sliding_folds
