! SPDX-License-Identifier: GPL-3.0-or-later
!> What the bounds of a theory are compared with in a fit: the largest of each measure over the points of contact that are used. So the
!> doubt of the curve is the first in the list of doubts that any of its points has.
module adfric_fit_doubt
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_fit_model_curve, only: model_curve_t
   use adfric_fit_objective, only: objective_t
   use adfric_fit_sphere_curve, only: sphere_curve_t
   use adfric_fit_state, only: fit_state_t, get_state
   use adfric_describe_doubt, only: doubt_estimate_above_tenth, n_doubts, not_measured, raise_measures
   use adfric_describe_model, only: model_t
   use adfric_describe_status, only: status_solved
   use adfric_round_sphere_variables, only: out => sphere_output
   implicit none (type, external)
   private
   public :: measure_fit

   !> Points that the model is asked for at once.
   integer, parameter :: most_at_once = 1024

contains

   !> Measure the curves as they are at the last evaluation.
   subroutine measure_fit(self, model, measures)
      type(objective_t), intent(in) :: self
      class(model_t), intent(in) :: model
      !> Receives what is measured; shape `(n_doubts)`.
      real(dp), intent(out) :: measures(:)
      integer :: k

      measures = not_measured
      do k = 1, size(self%spheres)
         call measure_sphere(self%spheres(k), model, self%spheres(k)%values_of(self%values), measures)
      end do
      do k = 1, size(self%others)
         call measure_points(self%others(k), model, self%others(k)%values_of(self%values), &
            & self%nuisance(:, self%others(k)%data_set), measures)
      end do
   end subroutine measure_fit

   !> Points of a sphere, whose positions on their curve are known. What has a closed form has no error to speak of.
   subroutine measure_sphere(curve, model, values, measures)
      type(sphere_curve_t), intent(in) :: curve
      class(model_t), intent(in) :: model
      real(dp), intent(in) :: values(:)
      !> What is measured, which rises.
      real(dp), intent(inout) :: measures(:)
      real(dp) :: results(size(model%results)), of_point(n_doubts)
      type(fit_state_t) :: s
      integer :: i

      results = not_a_number()
      do i = 1, curve%n
         ! a point of the base line, or beyond the fold, has no position
         if (curve%is_apart(i) .or. .not. curve%t(i) > 0) cycle
         call get_state(curve%path%theory, curve%path%lambda, curve%t(i), s)
         results(out%contact_radius) = curve%basis%length*s%a
         of_point = not_measured
         call model%measure(values, results, of_point)
         call raise_measures(of_point, measures)
      end do
   end subroutine measure_sphere

   !> Points that the model itself solves.
   subroutine measure_points(curve, model, values, nuisance, measures)
      type(model_curve_t), intent(in) :: curve
      class(model_t), intent(in) :: model
      real(dp), intent(in) :: values(:), nuisance(:)
      real(dp), intent(inout) :: measures(:)
      real(dp) :: of_point(n_doubts), counts(size(model%counts)), x_zero
      real(dp), allocatable :: x(:), all_values(:, :), results(:, :), error_estimate(:)
      integer, allocatable :: status(:)
      integer :: first, k, n

      x_zero = 0
      if (curve%x_nuisance > 0) x_zero = nuisance(curve%x_nuisance)
      x = pack(curve%foot, .not. (curve%is_apart .or. curve%is_beyond)) - x_zero
      do first = 1, size(x), most_at_once
         n = min(most_at_once, size(x) - first + 1)
         all_values = spread(curve%own_values(values, nuisance), 2, n)
         all_values(curve%points%abscissa, :) = x(first:first + n - 1)
         allocate (results(size(model%results), n), error_estimate(n), status(n))
         call model%solve_block(all_values, results, error_estimate, status, counts)
         do k = 1, n
            if (status(k) /= status_solved) cycle
            of_point = not_measured
            call model%measure(all_values(:, k), results(:, k), of_point)
            of_point(doubt_estimate_above_tenth) = error_estimate(k)
            call raise_measures(of_point, measures)
         end do
         deallocate (results, error_estimate, status)
      end do
   end subroutine measure_points

end module adfric_fit_doubt
