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
   real(dp), parameter :: tolerance = 3.0e-11_dp, rough_tolerance = 1.0e-5_dp, resting_step = 1.0e-7_dp
   !> Largest step, and largest number of them.
   real(dp), parameter :: largest_step = 3
   integer, parameter :: most_corrections = 14

   !> A point of the curve.
   type :: curve_point_t
      !> Coordinates and direction of the curve.
      real(dp) :: z(4) = 0, tangent(4) = 0
      !> Load, penetration and friction (`slide_zones_t`).
      real(dp) :: load = 0, penetration = 0, friction = 0
      !> Derivatives of load and penetration along the curve.
      real(dp) :: load_slope = 0, penetration_slope = 0
      !> Gradients of load and penetration by the coordinates.
      real(dp) :: load_gradient(4) = 0, penetration_gradient(4) = 0
      !> Its edges.
      type(slide_zones_t) :: zones
   end type curve_point_t

contains

   !> Newton's method, of which Broyden's rule keeps the derivatives, on the plane normal*(z - guess) = 0 or where a load or a
   !> penetration is met.
   pure subroutine correct_point(slide, guess, normal, point, is_found, wanted, which, is_rough, has_slopes)
      type(adhesive_slide_t), intent(in) :: slide
      real(dp), intent(in) :: guess(4), normal(4)
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
      real(dp) :: z(4), jacobian(4, 4), gradients(4, 2), values(4), old(4), step(4), size_of_step, old_size, enough
      integer :: i, kind
      logical :: is_solved

      z = guess
      is_found = .false.
      kind = 0
      if (present(wanted)) kind = which
      enough = tolerance
      if (present(is_rough)) enough = merge(rough_tolerance, tolerance, is_rough)
      old_size = huge(1.0_dp)
      size_of_step = old_size
      step = 0
      old = 0
      jacobian = 0
      gradients = 0
      call get_zones(slide, z, zones)
      call evaluate_zones(slide, zones, is_solved)
      if (.not. is_solved) return
      do i = 1, most_corrections
         values(:3) = zones%residual
         select case (kind)
         case (0)
            values(4) = dot_product(normal, z - guess)
         case (1)
            values(4) = zones%load - wanted
         case default
            values(4) = zones%penetration - wanted
         end select
         if (i == 1 .or. i == 6 .or. i == 10) then
            call differentiate(slide, z, zones, jacobian(:3, :), gradients(:, 1), gradients(:, 2), is_solved)
            if (.not. is_solved) return
            jacobian(4, :) = normal
            if (kind > 0) jacobian(4, :) = gradients(:, kind)
         else
            call update(step, values - old, jacobian)
         end if
         old = values
         call solve_four(jacobian, -values, step, is_solved)
         if (.not. is_solved) return
         size_of_step = maxval(abs(step))
         if (.not. size_of_step < largest_step) return
         if (i > 3 .and. size_of_step > old_size/2 .and. size_of_step < resting_step) exit
         old_size = size_of_step
         z = z + step
         call get_zones(slide, z, zones)
         call evaluate_zones(slide, zones, is_solved)
         if (.not. is_solved) return
         if (size_of_step < enough) exit
      end do
      is_found = size_of_step < max(resting_step, enough) .and. maxval(abs(zones%residual(2:3))) < 100*max(resting_step, enough)
      if (.not. is_found) return
      if (present(has_slopes)) call differentiate(slide, z, zones, jacobian(:3, :), gradients(:, 1), gradients(:, 2), is_found)
      if (.not. is_found) return
      point%z = z
      point%zones = zones
      point%load = zones%load
      point%penetration = zones%penetration
      point%friction = zones%friction
      point%load_gradient = gradients(:, 1)
      point%penetration_gradient = gradients(:, 2)
      call set_tangent(jacobian(:3, :), point)
   end subroutine correct_point

   !> Broyden's rule.
   pure subroutine update(step, change, jacobian)
      real(dp), intent(in) :: step(4), change(4)
      real(dp), intent(inout) :: jacobian(4, 4)
      real(dp) :: missing(4)
      integer :: k

      missing = (change - matmul(jacobian, step))/max(dot_product(step, step), tiny(1.0_dp))
      do k = 1, 4
         jacobian(:, k) = jacobian(:, k) + missing*step(k)
      end do
   end subroutine update

   !> Derivatives of residuals, load and penetration.
   pure subroutine differentiate(slide, z, zones, jacobian, load_gradient, penetration_gradient, is_solved)
      type(adhesive_slide_t), intent(in) :: slide
      real(dp), intent(in) :: z(4)
      type(slide_zones_t), intent(in) :: zones
      real(dp), intent(out) :: jacobian(3, 4), load_gradient(4), penetration_gradient(4)
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
         jacobian(:, k) = (moved%residual - zones%residual)/difference
         load_gradient(k) = (moved%load - zones%load)/difference
         penetration_gradient(k) = (moved%penetration - zones%penetration)/difference
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
   pure subroutine set_tangent(jacobian, point)
      real(dp), intent(in) :: jacobian(3, 4)
      type(curve_point_t), intent(inout) :: point
      real(dp) :: rows(3, 4), tangent(4)
      integer :: k, c(3)

      do k = 1, 3
         rows(k, :) = jacobian(k, :)/max(maxval(abs(jacobian(k, :))), tiny(1.0_dp))
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
      point%load_slope = dot_product(point%load_gradient, tangent)
      point%penetration_slope = dot_product(point%penetration_gradient, tangent)
   end subroutine set_tangent

end module adfric_plane_adhesive_sliding_point_of_curve
