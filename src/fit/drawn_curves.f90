! SPDX-License-Identifier: GPL-3.0-or-later
!> The best curve over the range of the data, with its band by the linear rule.
!>
!> Its abscissas are even on the scale of the data: in ratios where those are spread over decades in even ratios, else in differences.
!> Where chords between them would leave the curve more are put in between.
module adfric_fit_drawn_curves
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_fit_objective, only: objective_t, new_objective, most_rows_of
   use adfric_fit_order, only: order_of
   use adfric_fit_problem, only: fit_t, data_set_t, loss_gauss
   use adfric_fit_scales, only: scales_t
   use adfric_fit_solution, only: solution_t
   use adfric_numerics_bounded_least_squares, only: squares_work_t, new_squares_work
   use adfric_numerics_distributions, only: normal_quantile, t_quantile
   implicit none (type, external)
   private
   public :: draw_curves

   !> Points of a curve at first, and level of its band.
   integer, parameter :: n_drawn = 201
   real(dp), parameter :: band_level = 0.95_dp
   !> Where a point leaves the chord of its neighbours by more than this part of the curve's range, so many parts are made of the
   !> intervals beside it, and that so often.
   real(dp), parameter :: far_from_chord = 2.0e-3_dp
   integer, parameter :: parts = 4, most_refinements = 3
   !> Data are spread over decades if their range is at least that, and no ratio of neighbours is the others' power of that.
   real(dp), parameter :: a_decade = 10.0_dp, even_steps = 3.0_dp

contains

   !> Draw the curves of all data sets.
   subroutine draw_curves(fit, scales, minima, covariance, freedom, solution)
      type(fit_t), intent(in) :: fit
      type(scales_t), intent(in) :: scales
      !> The best minimum and, if there is one, the second one, as numbers that are fitted; shape `(n_free, 1 or 2)`.
      real(dp), intent(in) :: minima(:, :)
      !> Covariance of the best one.
      real(dp), intent(in) :: covariance(:, :)
      !> Degrees of freedom where sigma is not known, else 0.
      integer, intent(in) :: freedom
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
      type(fit_t), intent(in) :: fit
      integer, intent(in) :: number
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
                  if (is_logarithmic(pack(from%x, counts))) data%x(2:n_drawn - 1) = [(low*(high/low)**(real(i, dp) &
                     & /(n_drawn - 1)), i=1, n_drawn - 2)]
               end if
            end if
            data%y = 0*data%x
            allocate (data%sigma(size(data%x)), source=1.0_dp)
         end associate
      end do
   end subroutine make_grid

   !> Are abscissas spread over decades in even ratios?
   pure logical function is_logarithmic(x)
      !> The abscissas, in any order.
      real(dp), intent(in) :: x(:)
      real(dp) :: sorted(size(x)), steps(max(size(x) - 1, 0))
      integer :: n, i

      is_logarithmic = .false.
      sorted = x(order_of(x))
      ! each once
      n = min(size(x), 1)
      do i = 2, size(x)
         if (.not. sorted(i) > sorted(n)) cycle
         n = n + 1
         sorted(n) = sorted(i)
      end do
      if (n < 3) return
      if (.not. (sorted(1) > 0 .and. sorted(n) >= a_decade*sorted(1))) return
      steps(:n - 1) = log(sorted(2:n)/sorted(:n - 1))
      is_logarithmic = maxval(steps(:n - 1)) < even_steps*minval(steps(:n - 1))
   end function is_logarithmic

   !> Draw the curve of one data set.
   subroutine draw(drawn, scales, number, minima, covariance, freedom, solution)
      !> The fit with points to be drawn for data; more are put in between.
      type(fit_t), intent(inout) :: drawn
      type(scales_t), intent(in) :: scales
      integer, intent(in) :: number
      !> One or two minima, as numbers that are fitted.
      real(dp), intent(in) :: minima(:, :)
      !> Covariance of the first one.
      real(dp), intent(in) :: covariance(:, :)
      integer, intent(in) :: freedom
      type(solution_t), intent(inout) :: solution
      real(dp), allocatable :: curve(:), half(:)
      real(dp) :: reach
      logical :: is_valid
      integer :: again

      associate (data => solution%data_sets(number))
         do again = 0, most_refinements
            call evaluate_curve(drawn, scales, number, minima(:, 1), covariance, curve, half, is_valid)
            if (.not. is_valid) return
            if (again < most_refinements) call refine(curve, drawn%data_sets(number))
            if (size(drawn%data_sets(number)%x) == size(curve)) exit
         end do
         reach = normal_quantile(band_level)
         if (freedom > 0) reach = t_quantile(band_level, freedom)
         half = reach*half
         data%curve_x = drawn%data_sets(number)%x
         data%curve = curve
         data%band_low = curve - half
         data%band_high = curve + half
         if (size(minima, 2) < 2) return
         call evaluate_curve(drawn, scales, number, minima(:, 2), covariance, curve, half, is_valid)
         if (is_valid) data%second_curve = curve
      end associate
   end subroutine draw

   !> The curve at its points, and its standard errors. It has no value beyond the fold.
   subroutine evaluate_curve(drawn, scales, number, q, covariance, curve, half, is_valid)
      !> The fit with points to be drawn for data.
      type(fit_t), intent(in) :: drawn
      type(scales_t), intent(in) :: scales
      integer, intent(in) :: number
      real(dp), intent(in) :: q(:), covariance(:, :)
      !> Receives the ordinates.
      real(dp), allocatable, intent(out) :: curve(:)
      !> Receives their standard errors by the linear rule.
      real(dp), allocatable, intent(out) :: half(:)
      !> Has the model a value at all points?
      logical, intent(out) :: is_valid
      type(objective_t) :: objective
      type(squares_work_t) :: work
      real(dp) :: cost
      integer :: i, n

      call new_objective(objective, drawn, scales%unit, scales%lower, scales%upper, 0.0_dp)
      call new_squares_work(work, most_rows_of(objective), size(q))
      call objective%evaluate(q, work%n_rows, work%r, work%j, cost, is_valid)
      n = size(drawn%data_sets(number)%x)
      allocate (curve(n), half(n), source=0.0_dp)
      if (.not. is_valid) return
      curve = work%r(:n)
      do i = 1, n
         half(i) = sqrt(max(dot_product(work%j(i, :), matmul(covariance, work%j(i, :))), 0.0_dp))
      end do
      if (objective%is_sphere(number)) then
         where (objective%spheres(objective%number(number))%is_beyond) curve = not_a_number()
      else
         where (objective%others(objective%number(number))%is_beyond) curve = not_a_number()
      end if
   end subroutine evaluate_curve

   !> Put points between those whose chords leave the curve.
   pure subroutine refine(curve, data)
      !> The ordinates.
      real(dp), intent(in) :: curve(:)
      !> The data set, whose abscissas are refined.
      type(data_set_t), intent(inout) :: data
      logical :: is_coarse(size(curve) - 1), is_there(size(curve))
      real(dp), allocatable :: x(:)
      real(dp) :: range, chord
      integer :: i, k

      is_coarse = .false.
      is_there = ieee_is_finite(curve)
      if (count(is_there) < 3) return
      range = maxval(curve, is_there) - minval(curve, is_there)
      do i = 2, size(curve) - 1
         if (.not. all(is_there(i - 1:i + 1))) cycle
         chord = curve(i - 1) + (curve(i + 1) - curve(i - 1))*(data%x(i) - data%x(i - 1))/(data%x(i + 1) - data%x(i - 1))
         if (abs(curve(i) - chord) > far_from_chord*range) is_coarse(i - 1:i) = .true.
      end do
      ! an end of the curve between two points
      is_coarse = is_coarse .or. (is_there(2:) .neqv. is_there(:size(curve) - 1))
      allocate (x(0))
      do i = 1, size(curve) - 1
         if (is_coarse(i)) then
            x = [x, (data%x(i) + (data%x(i + 1) - data%x(i))*k/parts, k=0, parts - 1)]
         else
            x = [x, data%x(i)]
         end if
      end do
      data%x = [x, data%x(size(curve))]
      data%y = 0*data%x
      deallocate (data%sigma)
      allocate (data%sigma(size(data%x)), source=1.0_dp)
   end subroutine refine

end module adfric_fit_drawn_curves
