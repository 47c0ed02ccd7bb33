! SPDX-License-Identifier: GPL-3.0-or-later
!> One point of the curve of states of an adhesive sliding wave or cylinder: Newton's method from a point nearby.
module adfric_plane_adhesive_sliding_point_of_curve
   use adfric_base_kinds, only: dp
   use adfric_numerics_lapack, only: dgesv
   use adfric_plane_adhesive_sliding_state, only: evaluate_zones
   use adfric_plane_adhesive_sliding_zones, only: adhesive_slide_t, slide_zones_t, get_zones
   implicit none (type, external)
   private
   public :: curve_point_t, correct_point, by_load, by_penetration

   !> What may be met instead of a plane.
   integer, parameter :: by_load = 1, by_penetration = 2
   !> Step of the coordinates for derivatives.
   real(dp), parameter :: difference = 1.0e-6_dp
   !> Last step of Newton's method, also of a rough point, and where round-off lets steps rest.
   real(dp), parameter :: tolerance = 1.0e-12_dp, rough_tolerance = 1.0e-6_dp, resting_step = 1.0e-7_dp
   !> Largest step, and largest number of them.
   real(dp), parameter :: largest_step = 3
   integer, parameter :: most_corrections = 18
   !> So many steps go with the same derivatives.
   integer, parameter :: most_old_steps = 5
   !> After so many steps derivatives are no longer fresh.
   integer, parameter :: fresh_steps = 4
   !> Least step from which derivatives are learnt.
   real(dp), parameter :: least_update = 1.0e-7_dp

   !> A point of the curve.
   type :: curve_point_t
      !> Coordinates and direction of the curve.
      real(dp) :: z(4) = 0, tangent(4) = 0
      !> Load, penetration and friction (`slide_zones_t`).
      real(dp) :: load = 0, penetration = 0, friction = 0
      !> Derivatives of load and penetration along the curve.
      real(dp) :: load_slope = 0, penetration_slope = 0
      !> Derivatives of the residuals, the load and the penetration by the coordinates.
      real(dp) :: derivatives(5, 4) = 0
      !> Are there derivatives?
      logical :: has_derivatives = .false.
      !> Its edges.
      type(slide_zones_t) :: zones
   end type curve_point_t

contains

   !> Newton's method, of which Broyden's rule keeps the derivatives, on the plane normal*(z - guess) = 0 or where a load or a
   !> penetration is met. It begins with the derivatives that the point has, and takes new ones where it does not end soon.
   pure subroutine correct_point(slide, guess, normal, point, is_found, wanted, which, is_rough, has_slopes)
      type(adhesive_slide_t), intent(in) :: slide
      real(dp), intent(in) :: guess(4), normal(4)
      !> In: a point nearby, with or without derivatives. Out: the new one, if it was found.
      type(curve_point_t), intent(inout) :: point
      logical, intent(out) :: is_found
      !> Instead of the plane: a load (1) or a penetration (2).
      real(dp), intent(in), optional :: wanted
      integer, intent(in), optional :: which
      !> Are exact derivatives wanted?
      logical, intent(in), optional :: has_slopes
      !> Is a point near the curve enough?
      logical, intent(in), optional :: is_rough
      type(slide_zones_t) :: zones
      real(dp) :: z(4), rows(5, 4), values(5), old(5), step(4), size_of_step, old_size, enough
      integer :: i, kind, last_fresh
      logical :: is_solved

      z = guess
      is_found = .false.
      kind = 0
      if (present(wanted)) kind = which
      enough = tolerance
      if (present(is_rough)) enough = merge(rough_tolerance, tolerance, is_rough)
      size_of_step = huge(1.0_dp)
      call get_zones(slide, z, zones)
      call evaluate_zones(slide, zones, is_solved)
      if (.not. is_solved) return
      values = values_of(zones)
      last_fresh = -most_old_steps
      if (point%has_derivatives) then
         rows = point%derivatives
         call update(z - point%z, values - values_of(point%zones), rows)
         last_fresh = 0
      end if
      do i = 1, most_corrections
         if (i - last_fresh > most_old_steps) then
            call differentiate(slide, z, zones, rows, is_solved)
            if (.not. is_solved) return
            last_fresh = i
         end if
         call solve_step(rows, values, kind, normal, dot_product(normal, z - guess), wanted, step, is_solved)
         if (.not. is_solved .or. .not. maxval(abs(step)) < largest_step) then
            if (last_fresh == i) return
            last_fresh = -most_corrections
            cycle
         end if
         old_size = size_of_step
         size_of_step = maxval(abs(step))
         if (i > max(3, last_fresh + 1) .and. size_of_step > old_size/2 .and. size_of_step < resting_step) then
            ! old derivatives may be what keeps the steps from shrinking
            if (last_fresh > 0 .and. i - last_fresh < fresh_steps) exit
            last_fresh = -most_corrections
            size_of_step = huge(1.0_dp)
            cycle
         end if
         z = z + step
         old = values
         call get_zones(slide, z, zones)
         call evaluate_zones(slide, zones, is_solved)
         if (.not. is_solved) return
         values = values_of(zones)
         call update(step, values - old, rows)
         if (size_of_step < enough) exit
      end do
      is_found = size_of_step < max(resting_step, enough) .and. maxval(abs(zones%residual(2:3))) < 100*max(resting_step, enough)
      if (.not. is_found) return
      if (present(has_slopes)) call differentiate(slide, z, zones, rows, is_found)
      if (.not. is_found) return
      point%z = z
      point%zones = zones
      point%load = zones%load
      point%penetration = zones%penetration
      point%friction = zones%friction
      point%derivatives = rows
      point%has_derivatives = .true.
      call set_tangent(point)
   end subroutine correct_point

   !> What has derivatives: residuals, load and penetration.
   pure function values_of(zones) result(values)
      type(slide_zones_t), intent(in) :: zones
      real(dp) :: values(5)

      values = [zones%residual, zones%load, zones%penetration]
   end function values_of

   !> A step of Newton's method.
   pure subroutine solve_step(rows, values, kind, normal, distance, wanted, step, is_solved)
      !> Derivatives and values (`values_of`).
      real(dp), intent(in) :: rows(:, :), values(:)
      !> What is met: a plane (0), a load or a penetration.
      integer, intent(in) :: kind
      !> The plane, and the distance from it.
      real(dp), intent(in) :: normal(4), distance
      real(dp), intent(in), optional :: wanted
      real(dp), intent(out) :: step(4)
      logical, intent(out) :: is_solved
      real(dp) :: matrix(4, 4), right(4)

      matrix(:3, :) = rows(:3, :)
      right(:3) = -values(:3)
      if (kind == 0) then
         matrix(4, :) = normal
         right(4) = -distance
      else
         matrix(4, :) = rows(3 + kind, :)
         right(4) = wanted - values(3 + kind)
      end if
      call solve_four(matrix, right, step, is_solved)
   end subroutine solve_step

   !> Broyden's rule; shorter steps would put the round-off of the values into the derivatives.
   pure subroutine update(step, change, rows)
      real(dp), intent(in) :: step(4), change(:)
      real(dp), intent(inout) :: rows(:, :)
      real(dp) :: missing(size(change)), square
      integer :: k

      square = dot_product(step, step)
      if (.not. square > least_update**2) return
      missing = (change - matmul(rows, step))/square
      do k = 1, 4
         rows(:, k) = rows(:, k) + missing*step(k)
      end do
   end subroutine update

   !> Derivatives by the coordinates.
   pure subroutine differentiate(slide, z, zones, rows, is_solved)
      type(adhesive_slide_t), intent(in) :: slide
      real(dp), intent(in) :: z(4)
      type(slide_zones_t), intent(in) :: zones
      !> Derivatives of `values_of`; shape `(5, 4)`.
      real(dp), intent(out) :: rows(:, :)
      logical, intent(out) :: is_solved
      type(slide_zones_t) :: moved
      real(dp) :: other(4)
      integer :: k

      do k = 1, 4
         other = z
         other(k) = z(k) + difference
         call get_zones(slide, other, moved)
         call evaluate_zones(slide, moved, is_solved)
         if (.not. is_solved) return
         rows(:, k) = (values_of(moved) - values_of(zones))/difference
      end do
   end subroutine differentiate

   !> Four linear equations, with rows of one size.
   pure subroutine solve_four(matrix, right, solution, is_solved)
      real(dp), intent(in) :: matrix(4, 4), right(4)
      real(dp), intent(out) :: solution(4)
      logical, intent(out) :: is_solved
      real(dp) :: copy(4, 4), column(4, 1), scale
      integer :: pivots(4), info, k

      solution = 0
      do k = 1, 4
         scale = maxval(abs(matrix(k, :)))
         is_solved = scale > 0 .and. scale < huge(1.0_dp)
         if (.not. is_solved) return
         copy(k, :) = matrix(k, :)/scale
         column(k, 1) = right(k)/scale
      end do
      call dgesv(4, 1, copy, 4, pivots, column, 4, info)
      is_solved = info == 0
      if (is_solved) solution = column(:, 1)
      if (is_solved) is_solved = all(abs(solution) < huge(1.0_dp))
   end subroutine solve_four

   !> The unit vector that all three residuals let pass, towards the former one.
   pure subroutine set_tangent(point)
      type(curve_point_t), intent(inout) :: point
      real(dp) :: rows(3, 4), tangent(4)
      integer :: k, c(3)

      do k = 1, 3
         rows(k, :) = point%derivatives(k, :)/max(maxval(abs(point%derivatives(k, :))), tiny(1.0_dp))
      end do
      do k = 1, 4
         c = pack([1, 2, 3, 4], [1, 2, 3, 4] /= k)
         tangent(k) = (-1)**k*(rows(1, c(1))*(rows(2, c(2))*rows(3, c(3)) - rows(2, c(3))*rows(3, c(2))) &
            & - rows(1, c(2))*(rows(2, c(1))*rows(3, c(3)) - rows(2, c(3))*rows(3, c(1))) &
            & + rows(1, c(3))*(rows(2, c(1))*rows(3, c(2)) - rows(2, c(2))*rows(3, c(1))))
      end do
      tangent = tangent/max(norm2(tangent), tiny(1.0_dp))
      if (norm2(point%tangent) > 0) then
         if (dot_product(tangent, point%tangent) < 0) tangent = -tangent
      else if (tangent(2) < 0) then
         tangent = -tangent
      end if
      point%tangent = tangent
      point%load_slope = dot_product(point%derivatives(4, :), tangent)
      point%penetration_slope = dot_product(point%derivatives(5, :), tangent)
   end subroutine set_tangent

end module adfric_plane_adhesive_sliding_point_of_curve
