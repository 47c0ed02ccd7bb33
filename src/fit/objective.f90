! SPDX-License-Identifier: GPL-3.0-or-later
!> The sum of squares of a fit, as a function of the numbers that are fitted.
!>
!> The number q of a free variable v is ln v, or v over a unit of its own size. Rows: the points of each curve, each with the second
!> rows that its curve adds, then events, then priors. A data set is one curve, or several where its points have values of further
!> variables (`adfric_fit_parts`). All are in standard errors; where the ordinates' standard error is not known, it is
!> taken to be `unit`, and `finish_statistics` puts that right.
module adfric_fit_objective
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_base_watch, only: asks_for_end, watch_t
   use adfric_fit_loss, only: get_loss, loss_width_of
   use adfric_fit_model_curve, only: model_curve_t, new_model_curve
   use adfric_fit_parts, only: curve_points_t, list_curves
   use adfric_fit_problem, only: fit_t, free_t, event_t, n_nuisances, loss_gauss
   use adfric_fit_sphere_curve, only: sphere_curve_t, new_sphere_curve, is_sphere_curve
   use adfric_numerics_bounded_least_squares, only: least_squares_t
   implicit none (type, external)
   private
   public :: objective_t, new_objective, take_estimate, most_rows_of, count_terms

   !> The sum of squares of a fit.
   type, extends(least_squares_t) :: objective_t
      !> Number of free variables.
      integer :: n_free = 0
      !> The free variables, and their units where they are not fitted by their logarithm.
      type(free_t), allocatable :: frees(:)
      !> Those units; 1 for the others. Shape `(n_free)`.
      real(dp), allocatable :: unit(:)
      !> Bounds of the numbers that are fitted.
      real(dp), allocatable :: lower(:), upper(:)
      !> Values of all variables of the model, and of the nuisances of each data set, shape `(n_nuisances, n_data_sets)`.
      real(dp), allocatable :: values(:), nuisance(:, :)
      !> Curves of spheres and of other models. Curve k is number `number(k)` of those that `is_sphere(k)` says.
      type(sphere_curve_t), allocatable :: spheres(:)
      !> Curves of other models.
      type(model_curve_t), allocatable :: others(:)
      !> Number of each curve among those of its kind.
      integer, allocatable :: number(:)
      !> Of which kind each curve is.
      logical, allocatable :: is_sphere(:)
      !> Number of the data set of each curve, which rises.
      integer, allocatable :: data_set(:)
      !> Events.
      type(event_t), allocatable :: events(:)
      !> Loss of each data set and its width; events have those of their data set.
      integer, allocatable :: loss(:)
      !> Width of each data set's loss.
      real(dp), allocatable :: loss_width(:)
      !> The standard error that all points have where none is known; 0: all are known.
      real(dp) :: unknown_unit = 0
      !> Are losses left out, or derivatives to be as exact as they can be?
      logical :: is_plain = .false., is_exact = .false.
      !> Rows as they are without a loss, and psi' of each, of the last evaluation.
      real(dp), allocatable :: psi(:), psi_r(:)
      !> Rows before those of each curve at the last evaluation.
      integer, allocatable :: rows_before(:)
      !> Evaluations so far.
      integer :: evaluations = 0
      !> Who may end the search before its time; null: nobody. The model has no value then, anywhere.
      class(watch_t), pointer :: watch => null()
   contains
      procedure :: evaluate
      procedure :: set_values
      procedure :: first_curve
      procedure :: find_event
      procedure :: is_robust
      procedure :: n_beyond
      procedure :: derivative_error
   end type objective_t

contains

   !> Make the sum of squares of a fit. Curves keep what helps their next evaluation, so each thread has its own.
   subroutine new_objective(self, fit, unit, lower, upper, unknown_unit)
      type(objective_t), intent(out) :: self
      type(fit_t), intent(in) :: fit
      !> Units of the free variables that are not fitted by their logarithm; shape `(n_free)`.
      real(dp), intent(in) :: unit(:)
      !> Bounds of the numbers that are fitted.
      real(dp), intent(in) :: lower(:), upper(:)
      !> The standard error of all points where none is known, else 0.
      real(dp), intent(in) :: unknown_unit
      type(curve_points_t), allocatable :: curves(:)
      integer :: k, n

      if (associated(fit%model)) self%watch => fit%model%watch
      self%n_free = size(fit%frees)
      self%frees = fit%frees
      self%unit = unit
      self%lower = lower
      self%upper = upper
      self%values = fit%base
      self%unknown_unit = unknown_unit
      n = size(fit%data_sets)
      allocate (self%nuisance(n_nuisances, n), self%loss(n), self%loss_width(n))
      do k = 1, n
         self%nuisance(:, k) = fit%data_sets(k)%nuisance
         self%loss(k) = fit%data_sets(k)%loss
         self%loss_width(k) = loss_width_of(fit%data_sets(k)%loss, fit%data_sets(k)%loss_width)
      end do
      call list_curves(fit%data_sets, curves)
      self%data_set = curves%data_set
      n = size(curves)
      allocate (self%number(n), self%is_sphere(n))
      do k = 1, n
         ! which further variables a data set has decides it, and not their values
         self%is_sphere(k) = is_sphere_curve(fit, fit%data_sets(self%data_set(k)))
         self%number(k) = count(self%is_sphere(:k) .eqv. self%is_sphere(k))
      end do
      allocate (self%spheres(count(self%is_sphere)), self%others(count(.not. self%is_sphere)))
      do k = 1, n
         if (self%is_sphere(k)) then
            call new_sphere_curve(self%spheres(self%number(k)), fit, self%data_set(k), curves(k)%points, max(unknown_unit, &
               & tiny(unknown_unit)))
         else
            call new_model_curve(self%others(self%number(k)), fit, self%data_set(k), curves(k)%points, max(unknown_unit, &
               & tiny(unknown_unit)))
         end if
      end do
      if (allocated(fit%events)) then
         self%events = fit%events
      else
         allocate (self%events(0))
      end if
      n = most_rows_of(self)
      allocate (self%psi(n), self%psi_r(n), source=0.0_dp)
      allocate (self%rows_before(size(self%number)), source=0)
   end subroutine new_objective

   !> Most rows of an evaluation.
   pure integer function most_rows_of(self)
      type(objective_t), intent(in) :: self
      integer :: k

      most_rows_of = size(self%events) + self%n_free
      do k = 1, size(self%spheres)
         most_rows_of = most_rows_of + self%spheres(k)%most_rows()
      end do
      do k = 1, size(self%others)
         most_rows_of = most_rows_of + self%others(k)%most_rows()
      end do
   end function most_rows_of

   !> Number of points, and of points, events and priors together.
   pure subroutine count_terms(self, n_points, n_terms)
      type(objective_t), intent(in) :: self
      integer, intent(out) :: n_points, n_terms

      n_points = sum(self%spheres%n) + sum(self%others%n)
      n_terms = n_points + size(self%events) + count(is_set(self%frees%prior))
   end subroutine count_terms

   !> Has a data set a loss that is not the square?
   pure logical function is_robust(self)
      class(objective_t), intent(in) :: self

      is_robust = .not. self%is_plain .and. any(self%loss /= loss_gauss)
   end function is_robust

   !> Points beyond the fold at the last evaluation.
   pure integer function n_beyond(self)
      class(objective_t), intent(in) :: self
      integer :: k

      n_beyond = 0
      do k = 1, size(self%spheres)
         n_beyond = n_beyond + count(self%spheres(k)%is_beyond)
      end do
      do k = 1, size(self%others)
         n_beyond = n_beyond + count(self%others(k)%is_beyond)
      end do
   end function n_beyond

   !> Relative error of the derivatives at the last evaluation; 0 where they are exact.
   pure real(dp) function derivative_error(self)
      class(objective_t), intent(in) :: self
      integer :: k

      derivative_error = 0
      do k = 1, size(self%others)
         derivative_error = max(derivative_error, self%others(k)%error)
      end do
   end function derivative_error

   !> Values of the free variables, and their derivatives by the numbers that are fitted.
   pure subroutine take_estimate(self, q, v, slopes)
      class(objective_t), intent(in) :: self
      real(dp), intent(in) :: q(:)
      !> Receives the values.
      real(dp), intent(out) :: v(:)
      !> Receives the derivatives.
      real(dp), intent(out) :: slopes(:)

      where (self%frees%is_log)
         v = exp(min(q, log(huge(1.0_dp))/2))
         slopes = v
      elsewhere
         v = q*self%unit
         slopes = self%unit
      end where
   end subroutine take_estimate

   !> Put the values of the free variables to where they belong.
   pure subroutine set_values(self, v)
      class(objective_t), intent(inout) :: self
      real(dp), intent(in) :: v(:)
      integer :: k

      do k = 1, self%n_free
         if (self%frees(k)%variable > 0) then
            self%values(self%frees(k)%variable) = v(k)
         else
            self%nuisance(self%frees(k)%nuisance, self%frees(k)%data_set) = v(k)
         end if
      end do
   end subroutine set_values

   !> The first curve of a data set; 0 if it has none.
   pure integer function first_curve(self, data_set)
      class(objective_t), intent(in) :: self
      !> Number of the data set.
      integer, intent(in) :: data_set

      first_curve = findloc(self%data_set, data_set, 1)
   end function first_curve

   !> See `least_squares_t`.
   subroutine evaluate(self, q, n_rows, r, j, cost, is_valid)
      class(objective_t), intent(inout) :: self
      real(dp), intent(in) :: q(:)
      integer, intent(out) :: n_rows
      real(dp), intent(inout) :: r(:), j(:, :)
      !> Receives the sum of the costs of all rows.
      real(dp), intent(out) :: cost
      logical, intent(out) :: is_valid
      real(dp) :: v(self%n_free), slopes(self%n_free)
      integer :: k, n

      self%evaluations = self%evaluations + 1
      n_rows = 0
      cost = 0
      is_valid = .not. asks_for_end(self%watch)
      if (.not. is_valid) return
      call take_estimate(self, q, v, slopes)
      call self%set_values(v)
      do k = 1, size(self%number)
         self%rows_before(k) = n_rows
         associate (at => self%number(k), of => self%data_set(k))
            if (self%is_sphere(k)) then
               call self%spheres(at)%evaluate(self%spheres(at)%values_of(self%values), self%nuisance(:, of), slopes, &
                  & self%is_exact, n, r(n_rows + 1:), j(n_rows + 1:, :), is_valid)
            else
               call self%others(at)%evaluate(self%others(at)%values_of(self%values), self%nuisance(:, of), slopes, &
                  & self%is_exact, n, r(n_rows + 1:), j(n_rows + 1:, :), is_valid)
            end if
         end associate
         if (.not. is_valid) return
         call take_loss(self, self%data_set(k), n_rows + 1, n_rows + n, r, j, cost)
         n_rows = n_rows + n
      end do
      call add_events(self, slopes, n_rows, r, j, cost, is_valid)
      if (is_valid) call add_priors(self, q, n_rows, r, j, cost)
      is_valid = is_valid .and. cost <= huge(cost)
   end subroutine evaluate

   !> Turn rows into those of their loss, and add their cost.
   subroutine take_loss(self, data_set, first, last, r, j, cost)
      !> The sum of squares; it receives psi and psi' of the rows.
      type(objective_t), intent(inout) :: self
      !> Number of the data set whose loss it is.
      integer, intent(in) :: data_set
      integer, intent(in) :: first, last
      real(dp), intent(inout) :: r(:), j(:, :)
      !> The cost is added.
      real(dp), intent(inout) :: cost
      real(dp) :: one, weight
      integer :: i

      if (.not. self%is_robust() .or. self%loss(data_set) == loss_gauss) then
         cost = cost + dot_product(r(first:last), r(first:last))
         if (.not. self%is_robust()) return
         self%psi(first:last) = r(first:last)
         self%psi_r(first:last) = 1
         return
      end if
      do i = first, last
         call get_loss(self%loss(data_set), self%loss_width(data_set), r(i), one, self%psi(i), self%psi_r(i))
         cost = cost + one
         weight = self%psi_r(i)
         if (.not. weight > 0) then
            weight = 1
            if (abs(r(i)) > 0) weight = self%psi(i)/r(i)
         end if
         weight = sqrt(weight)
         r(i) = self%psi(i)/weight
         j(i, :) = j(i, :)*weight
      end do
   end subroutine take_loss

   !> What the model says of an event, at the values of the last evaluation. Its data set is one curve.
   subroutine find_event(self, event, slopes, value, gradient, is_valid)
      class(objective_t), intent(inout) :: self
      type(event_t), intent(in) :: event
      !> Derivatives of the free variables by the numbers that are fitted.
      real(dp), intent(in) :: slopes(:)
      !> Receives the load [N] or position [m].
      real(dp), intent(out) :: value
      !> Receives its derivatives; shape `(n_free)`.
      real(dp), intent(out) :: gradient(:)
      !> Has the model such an event?
      logical, intent(out) :: is_valid
      integer :: curve

      value = 0
      gradient = 0
      curve = self%first_curve(event%data_set)
      is_valid = curve > 0
      if (.not. is_valid) return
      associate (number => self%number(curve), nuisance => self%nuisance(:, event%data_set))
         if (self%is_sphere(curve)) then
            call self%spheres(number)%find_event(event%kind, self%values, nuisance, slopes, value, gradient, is_valid)
         else
            call self%others(number)%find_event(event%kind, self%values, nuisance, slopes, value, gradient, is_valid)
         end if
      end associate
   end subroutine find_event

   !> Add a row for each event.
   subroutine add_events(self, slopes, n_rows, r, j, cost, is_valid)
      type(objective_t), intent(inout) :: self
      !> Derivatives of the free variables by the numbers that are fitted.
      real(dp), intent(in) :: slopes(:)
      !> Number of rows so far; it rises.
      integer, intent(inout) :: n_rows
      real(dp), intent(inout) :: r(:), j(:, :), cost
      logical, intent(out) :: is_valid
      real(dp) :: value, gradient(self%n_free)
      integer :: k

      is_valid = .true.
      do k = 1, size(self%events)
         associate (event => self%events(k), of => self%events(k)%data_set)
            call self%find_event(event, slopes, value, gradient, is_valid)
            if (.not. is_valid) return
            n_rows = n_rows + 1
            r(n_rows) = (value - event%value)/event%sigma
            j(n_rows, :) = gradient/event%sigma
            call take_loss(self, of, n_rows, n_rows, r, j, cost)
         end associate
      end do
   end subroutine add_events

   !> Add a row for each prior.
   subroutine add_priors(self, q, n_rows, r, j, cost)
      type(objective_t), intent(inout) :: self
      real(dp), intent(in) :: q(:)
      integer, intent(inout) :: n_rows
      real(dp), intent(inout) :: r(:), j(:, :), cost
      integer :: k

      do k = 1, self%n_free
         if (.not. is_set(self%frees(k)%prior)) cycle
         n_rows = n_rows + 1
         j(n_rows, :) = 0
         if (self%frees(k)%is_log) then
            r(n_rows) = (q(k) - log(self%frees(k)%prior))/self%frees(k)%prior_sigma
            j(n_rows, k) = 1/self%frees(k)%prior_sigma
         else
            r(n_rows) = (q(k)*self%unit(k) - self%frees(k)%prior)/self%frees(k)%prior_sigma
            j(n_rows, k) = self%unit(k)/self%frees(k)%prior_sigma
         end if
         cost = cost + r(n_rows)**2
         self%psi(n_rows) = r(n_rows)
         self%psi_r(n_rows) = 1
      end do
   end subroutine add_priors

end module adfric_fit_objective
