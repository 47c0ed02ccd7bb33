! SPDX-License-Identifier: GPL-3.0-or-later
!> The best curve over the range of the data, with its band by the linear rule.
module adfric_fit_drawn_curves
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_fit_objective, only: objective_t, new_objective, most_rows_of
   use adfric_fit_problem, only: fit_t, loss_gauss
   use adfric_fit_scales, only: scales_t
   use adfric_fit_solution, only: solution_t
   use adfric_numerics_bounded_least_squares, only: squares_work_t, new_squares_work
   use adfric_numerics_distributions, only: normal_quantile, t_quantile
   implicit none (type, external)
   private
   public :: draw_curves

   !> Points of a curve, and level of its band.
   integer, parameter :: n_drawn = 201
   real(dp), parameter :: band_level = 0.95_dp

contains

   !> Draw the curves of all data sets.
   subroutine draw_curves(fit, scales, minima, covariance, freedom, solution)
      !> The fit.
      type(fit_t), intent(in) :: fit
      !> Units and bounds.
      type(scales_t), intent(in) :: scales
      !> The best minimum and, if there is one, the second one, as numbers that are fitted; shape `(n_free, 1 or 2)`.
      real(dp), intent(in) :: minima(:, :)
      !> Covariance of the best one.
      real(dp), intent(in) :: covariance(:, :)
      !> Degrees of freedom where sigma is not known, else 0.
      integer, intent(in) :: freedom
      !> Receives the curves.
      type(solution_t), intent(inout) :: solution
      type(fit_t) :: drawn
      integer :: k

      drawn = fit
      if (allocated(drawn%events)) deallocate (drawn%events)
      do k = 1, size(fit%data_sets)
         ! one curve at a time, for one may lie where another has no value
         call make_grid(fit, k, drawn)
         if (size(drawn%data_sets(k)%x) == 0) cycle
         call draw(drawn, scales, k, minima, covariance, freedom, solution)
      end do
   end subroutine draw_curves

   !> Points of one data set over its range in contact, and none of the others.
   subroutine make_grid(fit, number, drawn)
      !> The fit.
      type(fit_t), intent(in) :: fit
      !> Number of the data set.
      integer, intent(in) :: number
      !> Receives the points.
      type(fit_t), intent(inout) :: drawn
      logical, allocatable :: counts(:)
      real(dp) :: low, high
      integer :: k, i

      do k = 1, size(fit%data_sets)
         associate (data => drawn%data_sets(k), from => fit%data_sets(k))
            if (allocated(data%sigma)) deallocate (data%sigma)
            if (allocated(data%x_sigma)) deallocate (data%x_sigma)
            if (allocated(data%is_contact)) deallocate (data%is_contact)
            if (allocated(data%segment)) deallocate (data%segment)
            if (allocated(data%is_used)) deallocate (data%is_used)
            data%loss = loss_gauss
            data%x = from%x(:0)
            if (k == number) then
               counts = ieee_is_finite(from%x) .and. ieee_is_finite(from%y)
               if (allocated(from%is_contact)) counts = counts .and. from%is_contact
               if (allocated(from%is_used)) counts = counts .and. from%is_used
               if (any(counts)) then
                  low = minval(from%x, counts)
                  high = maxval(from%x, counts)
                  data%x = [(low + (high - low)*i/(n_drawn - 1), i=0, n_drawn - 1)]
               end if
            end if
            data%y = 0*data%x
            allocate (data%sigma(size(data%x)), source=1.0_dp)
         end associate
      end do
   end subroutine make_grid

   !> Draw the curve of one data set. It has no value beyond the fold.
   subroutine draw(drawn, scales, number, minima, covariance, freedom, solution)
      !> The fit with points to be drawn for data.
      type(fit_t), intent(in) :: drawn
      !> Units and bounds.
      type(scales_t), intent(in) :: scales
      !> Number of the data set.
      integer, intent(in) :: number
      !> One or two minima, as numbers that are fitted.
      real(dp), intent(in) :: minima(:, :)
      !> Covariance of the first one.
      real(dp), intent(in) :: covariance(:, :)
      !> Degrees of freedom where sigma is not known, else 0.
      integer, intent(in) :: freedom
      !> Receives the curve.
      type(solution_t), intent(inout) :: solution
      type(objective_t) :: objective
      type(squares_work_t) :: work
      real(dp) :: cost, reach, half(n_drawn)
      logical :: is_valid, is_beyond(n_drawn)
      integer :: i

      call new_objective(objective, drawn, scales%unit, scales%lower, scales%upper, 0.0_dp)
      call new_squares_work(work, most_rows_of(objective), size(minima, 1))
      call objective%evaluate(minima(:, 1), work%n_rows, work%r, work%j, cost, is_valid)
      if (.not. is_valid) return
      reach = normal_quantile(band_level)
      if (freedom > 0) reach = t_quantile(band_level, freedom)
      do i = 1, n_drawn
         half(i) = reach*sqrt(max(dot_product(work%j(i, :), matmul(covariance, work%j(i, :))), 0.0_dp))
      end do
      is_beyond = .false.
      if (objective%is_sphere(number)) is_beyond = objective%spheres(objective%number(number))%is_beyond
      associate (data => solution%data_sets(number))
         data%curve_x = drawn%data_sets(number)%x
         data%curve = work%r(:n_drawn)
         where (is_beyond) data%curve = not_a_number()
         data%band_low = data%curve - half
         data%band_high = data%curve + half
         if (size(minima, 2) < 2) return
         call objective%evaluate(minima(:, 2), work%n_rows, work%r, work%j, cost, is_valid)
         if (.not. is_valid) return
         if (objective%is_sphere(number)) is_beyond = objective%spheres(objective%number(number))%is_beyond
         data%second_curve = work%r(:n_drawn)
         where (is_beyond) data%second_curve = not_a_number()
      end associate
   end subroutine draw

end module adfric_fit_drawn_curves
