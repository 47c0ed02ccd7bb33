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
   use adfric_fit_parts, only: has_others, number_curves
   use adfric_fit_problem, only: fit_t, data_set_t, loss_gauss
   use adfric_fit_scales, only: scales_t
   use adfric_fit_solution, only: data_solution_t, solution_t
   use adfric_numerics_bounded_least_squares, only: squares_work_t, new_squares_work
   use adfric_numerics_distributions, only: normal_quantile, t_quantile
   implicit none (type, external)
   private
   public :: draw_curves

   !> Points of a curve at first, and level of its band.
   integer, parameter :: n_drawn = 201
   !> Most curves that are drawn of a data set whose points have values of further variables, and least points of one. They are not
   !> refined.
   integer, parameter :: most_drawn = 64, least_drawn = 33
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
      integer, allocatable :: number(:)
      integer :: k, c

      allocate (number(0))
      drawn = fit
      if (allocated(drawn%events)) deallocate (drawn%events)
      do k = 1, size(fit%data_sets)
         number = number_curves(fit%data_sets(k))
         do c = 1, min(maxval([number, 0]), most_drawn)
            ! one curve at a time, for one may lie where another has no value
            call make_grid(fit, k, number == c, drawn)
            if (size(drawn%data_sets(k)%x) == 0) cycle
            call draw(drawn, scales, k, minima, covariance, freedom, solution%data_sets(k))
         end do
      end do
   end subroutine draw_curves

   !> Points of one curve over its range in contact, and none of the other data sets.
   subroutine make_grid(fit, number, is_of_curve, drawn)
      type(fit_t), intent(in) :: fit
      !> Number of the data set.
      integer, intent(in) :: number
      !> Which of its points are those of the curve.
      logical, intent(in) :: is_of_curve(:)
      type(fit_t), intent(inout) :: drawn
      logical, allocatable :: counts(:)
      real(dp), allocatable :: x(:)
      real(dp) :: low, high
      integer :: k, i, n

      do k = 1, size(fit%data_sets)
         associate (from => fit%data_sets(k))
            n = n_drawn
            if (has_others(from)) n = max(n_drawn/max(maxval(number_curves(from)), 1), least_drawn)
            x = from%x(:0)
            i = 1
            if (k == number) then
               counts = ieee_is_finite(from%x) .and. ieee_is_finite(from%y) .and. is_of_curve
               if (allocated(from%is_contact)) counts = counts .and. from%is_contact
               if (allocated(from%is_used)) counts = counts .and. from%is_used
               if (has_others(from) .and. any(counts)) counts = counts .and. maxval(from%x, counts) > minval(from%x, counts)
               if (any(counts)) then
                  low = minval(from%x, counts)
                  high = maxval(from%x, counts)
                  x = [(low + (high - low)*i/(n - 1), i=0, n - 1)]
                  if (is_logarithmic(pack(from%x, counts))) x(2:n - 1) = [(low*(high/low)**(real(i, dp)/(n - 1)), i=1, n - 2)]
                  i = findloc(counts, .true., 1)
               end if
            end if
            call set_grid(drawn%data_sets(k), from, i, x)
         end associate
      end do
   end subroutine make_grid

   !> Points to be drawn for those of a data set.
   subroutine set_grid(data, from, point, x)
      !> The data set, which receives the points.
      type(data_set_t), intent(inout) :: data
      !> The data set as it was measured, and the index of a point with the values of the curve.
      type(data_set_t), intent(in) :: from
      integer, intent(in) :: point
      !> Abscissas of the points.
      real(dp), intent(in) :: x(:)

      if (allocated(data%x_sigma)) deallocate (data%x_sigma)
      if (allocated(data%is_contact)) deallocate (data%is_contact)
      if (allocated(data%segment)) deallocate (data%segment)
      if (allocated(data%is_used)) deallocate (data%is_used)
      if (allocated(data%prescribed)) deallocate (data%prescribed)
      data%loss = loss_gauss
      data%x = x
      data%y = 0*x
      data%sigma = spread(1.0_dp, 1, size(x))
      if (.not. has_others(from)) return
      if (size(x) > 0) then
         data%at = spread(from%at(:, point), 2, size(x))
      else
         data%at = from%at(:, :0)
      end if
   end subroutine set_grid

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

   !> Draw a curve, behind those that its data set has already.
   subroutine draw(drawn, scales, number, minima, covariance, freedom, found)
      !> The fit with points to be drawn for data; more are put in between.
      type(fit_t), intent(inout) :: drawn
      type(scales_t), intent(in) :: scales
      integer, intent(in) :: number
      !> One or two minima, as numbers that are fitted.
      real(dp), intent(in) :: minima(:, :)
      !> Covariance of the first one.
      real(dp), intent(in) :: covariance(:, :)
      integer, intent(in) :: freedom
      type(data_solution_t), intent(inout) :: found
      real(dp), allocatable :: curve(:), half(:), second(:)
      real(dp) :: reach
      logical :: is_valid, is_first
      integer :: again, most

      associate (data => drawn%data_sets(number))
         most = merge(0, most_refinements, has_others(data))
         do again = 0, most
            call evaluate_curve(drawn, scales, number, minima(:, 1), covariance, curve, half, is_valid)
            if (.not. is_valid) return
            if (again < most) call refine(curve, data)
            if (size(data%x) == size(curve)) exit
         end do
         reach = normal_quantile(band_level)
         if (freedom > 0) reach = t_quantile(band_level, freedom)
         is_first = .not. allocated(found%curve_x)
         if (.not. is_first) call separate(found, data%at(:, :1))
         call append(found%curve_x, data%x)
         call append(found%curve, curve)
         call append(found%band_low, curve - reach*half)
         call append(found%band_high, curve + reach*half)
         if (has_others(data)) call append_table(found%curve_at, data%at)
         if (size(minima, 2) < 2) return
         call evaluate_curve(drawn, scales, number, minima(:, 2), covariance, second, half, is_valid)
         if (.not. is_valid .and. .not. has_others(data)) return
         if (.not. is_valid) second = not_a_number() + 0*data%x
         if (is_first .or. allocated(found%second_curve)) call append(found%second_curve, second)
      end associate
   end subroutine draw

   !> Put a point without a value between two curves.
   pure subroutine separate(found, at)
      type(data_solution_t), intent(inout) :: found
      !> Values of the further variables on the next curve; shape `(n_others, 1)`.
      real(dp), intent(in) :: at(:, :)

      call append(found%curve_x, [found%curve_x(size(found%curve_x))])
      call append(found%curve, [not_a_number()])
      call append(found%band_low, [not_a_number()])
      call append(found%band_high, [not_a_number()])
      call append_table(found%curve_at, at)
      if (allocated(found%second_curve)) call append(found%second_curve, [not_a_number()])
   end subroutine separate

   !> Put numbers behind others.
   pure subroutine append(numbers, more)
      !> The numbers, which grow; not allocated: there are none yet.
      real(dp), allocatable, intent(inout) :: numbers(:)
      real(dp), intent(in) :: more(:)

      if (.not. allocated(numbers)) allocate (numbers(0))
      numbers = [numbers, more]
   end subroutine append

   !> Put columns behind others.
   pure subroutine append_table(table, more)
      !> The columns, which grow; not allocated: there are none yet.
      real(dp), allocatable, intent(inout) :: table(:, :)
      real(dp), intent(in) :: more(:, :)
      real(dp), allocatable :: both(:, :)
      integer :: n

      n = 0
      if (allocated(table)) n = size(table, 2)
      allocate (both(size(more, 1), n + size(more, 2)))
      if (n > 0) both(:, :n) = table
      both(:, n + 1:) = more
      call move_alloc(both, table)
   end subroutine append_table

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
      associate (at => objective%number(objective%first_curve(number)))
         if (objective%is_sphere(objective%first_curve(number))) then
            where (objective%spheres(at)%is_beyond) curve = not_a_number()
         else
            where (objective%others(at)%is_beyond) curve = not_a_number()
         end if
      end associate
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
      data%sigma = spread(1.0_dp, 1, size(data%x))
      if (has_others(data)) data%at = spread(data%at(:, 1), 2, size(data%x))
   end subroutine refine

end module adfric_fit_drawn_curves
