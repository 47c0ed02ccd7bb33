! SPDX-License-Identifier: GPL-3.0-or-later
!> A measured curve of any model, with derivatives by differences.
!>
!> A result has the relative error e that the model says (`error_estimate`), 1e-13 at least. A step h forward leaves the error e/h + h/2 in
!> a derivative, least for h = e^(1/2); a central one e/h + h^2/6, least for about h = e^(1/3). A relative error of the derivatives moves
!> an estimate by about that part of its standard error, so steps forward will do on the way, and central ones for the covariance.
!> At a bound of the model's table, and where a neighbour has no solution or is of another regime, the step is taken to the other side.
module adfric_fit_model_curve
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_fit_curve, only: curve_t, take_points, nuisance_slopes
   use adfric_fit_problem, only: free_t, fit_t, n_nuisances, nuisance_load_offset, nuisance_friction_offset, &
      & nuisance_contact_point, nuisance_lateral_gain, event_pull_off_load
   use adfric_model_model, only: model_t
   use adfric_model_status, only: status_solved
   implicit none (type, external)
   private
   public :: model_curve_t, new_model_curve

   !> A measured curve of any model.
   type, extends(curve_t) :: model_curve_t
      !> The model.
      class(model_t), pointer :: model => null()
      !> Places of abscissa and ordinate, and of the results `regime` and `pull_off_load`; 0: none.
      integer :: abscissa = 0, ordinate = 0, regime = 0, pull_off = 0
      !> Which offset is taken off the abscissa (0: none), and is the ordinate a load?
      integer :: x_nuisance = 0
      !> Is the zero of the load added to the ordinate?
      logical :: is_load = .false.
      !> The free variables.
      type(free_t), allocatable :: frees(:)
      !> Error of the derivatives of the last evaluation, relative.
      real(dp) :: error = 0
   contains
      procedure :: evaluate
      procedure :: find_event
      procedure :: most_rows
   end type model_curve_t

   !> Least and largest error that a result is held to have.
   real(dp), parameter :: least_error = 1.0e-13_dp, largest_error = 1.0e-4_dp

contains

   !> Take a data set.
   subroutine new_model_curve(self, fit, number, unit)
      !> Receives the curve.
      type(model_curve_t), intent(out) :: self
      !> The fit.
      type(fit_t), intent(in) :: fit
      !> Number of the data set.
      integer, intent(in) :: number
      !> The standard error of all ordinates where none is given.
      real(dp), intent(in) :: unit
      integer :: k

      call take_points(self, number, fit%data_sets(number), unit)
      self%model => fit%model
      self%abscissa = fit%data_sets(number)%abscissa
      self%ordinate = fit%data_sets(number)%ordinate
      self%frees = fit%frees
      do k = 1, size(fit%model%results)
         if (fit%model%results(k)%name == 'regime') self%regime = k
         if (fit%model%results(k)%name == 'pull_off_load') self%pull_off = k
      end do
      if (fit%model%variables(self%abscissa)%name == 'load') self%x_nuisance = nuisance_load_offset
      if (fit%model%variables(self%abscissa)%name == 'approach') self%x_nuisance = nuisance_contact_point
      self%is_load = fit%model%results(self%ordinate)%name == 'load'
   end subroutine new_model_curve

   !> See `curve_t`: a row for every point.
   pure integer function most_rows(self)
      !> The curve.
      class(model_curve_t), intent(in) :: self

      most_rows = self%n
   end function most_rows

   !> See `curve_t`.
   subroutine evaluate(self, values, nuisance, slopes, is_exact, n_rows, r, j, is_valid)
      !> The curve.
      class(model_curve_t), intent(inout) :: self
      !> Values of all variables of the model.
      real(dp), intent(in) :: values(:)
      !> Values of the nuisances of the curve.
      real(dp), intent(in) :: nuisance(:)
      !> Derivatives of each free variable by the number that is fitted.
      real(dp), intent(in) :: slopes(:)
      !> Are central differences wanted?
      logical, intent(in) :: is_exact
      !> Receives the number of rows.
      integer, intent(out) :: n_rows
      !> Receives the residuals.
      real(dp), intent(inout) :: r(:)
      !> Receives their derivatives.
      real(dp), intent(inout) :: j(:, :)
      !> Has the model a value at all points?
      logical, intent(out) :: is_valid
      real(dp) :: y(self%n), slope(self%n), zero, of_nuisance(size(slopes), n_nuisances), x(self%n), e, zero_by
      integer :: regimes(self%n), k

      n_rows = self%n
      call nuisance_slopes(self%frees, self%data_set, slopes, of_nuisance)
      x = self%x
      if (self%x_nuisance > 0) x = x - nuisance(self%x_nuisance)
      call ask(self, values, x, y, regimes, e)
      is_valid = all(regimes >= 0)
      if (.not. is_valid) return
      zero = nuisance(nuisance_friction_offset)
      if (self%is_load) zero = zero + nuisance(nuisance_load_offset)
      self%fitted = nuisance(nuisance_lateral_gain)*y + zero
      r(:n_rows) = (self%fitted - self%y)/self%sigma
      self%residual = -r(:n_rows)
      do k = 1, size(slopes)
         slope = y*of_nuisance(k, nuisance_lateral_gain)
         if (self%frees(k)%variable > 0) then
            call differentiate(self, values, x, k, slopes(k), e, is_exact, y, regimes, slope, is_valid)
            slope = nuisance(nuisance_lateral_gain)*slope
         else if (self%x_nuisance > 0) then
            if (abs(of_nuisance(k, self%x_nuisance)) > 0) then
               call differentiate(self, values, x, 0, 1.0_dp, e, is_exact, y, regimes, slope, is_valid)
               slope = -nuisance(nuisance_lateral_gain)*slope*of_nuisance(k, self%x_nuisance)
            end if
         end if
         if (.not. is_valid) return
         where (.not. self%is_contact) slope = 0
         zero_by = of_nuisance(k, nuisance_friction_offset)
         if (self%is_load) zero_by = zero_by + of_nuisance(k, nuisance_load_offset)
         j(:n_rows, k) = (slope + zero_by)/self%sigma
      end do
      self%error = merge(e**(2.0_dp/3), sqrt(e), is_exact)
   end subroutine evaluate

   !> Ask the model for the ordinates at abscissas. Free points have the ordinate 0.
   subroutine ask(self, values, x, y, regimes, error)
      !> The curve.
      class(model_curve_t), intent(in) :: self
      !> Values of all variables of the model.
      real(dp), intent(in) :: values(:)
      !> Abscissas.
      real(dp), intent(in) :: x(:)
      !> Receives the ordinates.
      real(dp), intent(out) :: y(:)
      !> Receives the regimes, 0 where the model has none, -1 where there is no solution.
      integer, intent(out) :: regimes(:)
      !> Receives the largest relative error of a result.
      real(dp), intent(out) :: error
      real(dp) :: all_values(size(values), size(x)), results(size(self%model%results), size(x)), error_estimate(size(x)), &
         & counts(size(self%model%counts))
      integer :: status(size(x)), i, k, n

      n = 0
      do i = 1, size(x)
         if (.not. self%is_contact(i)) cycle
         n = n + 1
         all_values(:, n) = values
         all_values(self%abscissa, n) = x(i)
      end do
      call self%model%solve_block(all_values(:, :n), results(:, :n), error_estimate(:n), status(:n), counts)
      error = least_error
      y = 0
      regimes = 0
      k = 0
      do i = 1, size(x)
         if (.not. self%is_contact(i)) cycle
         k = k + 1
         regimes(i) = -1
         if (status(k) /= status_solved) cycle
         if (.not. ieee_is_finite(results(self%ordinate, k))) cycle
         y(i) = results(self%ordinate, k)
         regimes(i) = 0
         if (self%regime > 0) regimes(i) = nint(results(self%regime, k))
         if (ieee_is_finite(error_estimate(k))) error = max(error, error_estimate(k))
      end do
      error = min(error, largest_error)
   end subroutine ask

   !> Derivative of the ordinates by a free variable, or by the abscissa.
   subroutine differentiate(self, values, x, free, slope, error, is_central, y, regimes, y_by, is_valid)
      !> The curve.
      class(model_curve_t), intent(in) :: self
      !> Values of all variables of the model.
      real(dp), intent(in) :: values(:)
      !> Abscissas.
      real(dp), intent(in) :: x(:)
      !> Number of the free variable; 0: the abscissa.
      integer, intent(in) :: free
      !> Derivative of the free variable by the number that is fitted.
      real(dp), intent(in) :: slope
      !> Relative error of a result.
      real(dp), intent(in) :: error
      !> Is a central difference wanted?
      logical, intent(in) :: is_central
      !> Ordinates and regimes at the place.
      real(dp), intent(in) :: y(:)
      !> Regimes at the place.
      integer, intent(in) :: regimes(:)
      !> Receives the derivative.
      real(dp), intent(out) :: y_by(:)
      !> Is there one at every point?
      logical, intent(out) :: is_valid
      real(dp), dimension(size(x)) :: above, below
      integer, dimension(size(x)) :: regimes_above, regimes_below
      real(dp) :: h, up, down, size_of_x

      h = merge(error**(1.0_dp/3), sqrt(error), is_central)
      size_of_x = maxval(abs(self%x))
      call shift(h, above, regimes_above, up)
      regimes_below = -1
      below = y
      down = 0
      if (is_central .or. any(regimes_above /= regimes)) call shift(-h, below, regimes_below, down)
      is_valid = all(max(regimes_above, regimes_below) >= 0)
      if (.not. is_valid) return
      where (regimes_above == regimes .and. regimes_below == regimes)
         y_by = (above - below)/(up - down)
      elsewhere (regimes_above == regimes .or. regimes_below < 0)
         y_by = (above - y)/up
      elsewhere
         y_by = (below - y)/down
      end where
      y_by = y_by*slope

   contains

      !> Ordinates at a step from the place, as far as the table of the model lets it go.
      subroutine shift(part, shifted, shifted_regimes, step)
         !> The relative step.
         real(dp), intent(in) :: part
         !> Receives the ordinates.
         real(dp), intent(out) :: shifted(:)
         !> Receives the regimes.
         integer, intent(out) :: shifted_regimes(:)
         !> Receives the step of the variable.
         real(dp), intent(out) :: step
         real(dp) :: moved(size(values)), unused
         integer :: v

         moved = values
         if (free == 0) then
            step = part*size_of_x
            call ask(self, values, x + step, shifted, shifted_regimes, unused)
            return
         end if
         v = self%frees(free)%variable
         moved(v) = values(v) + part*max(abs(values(v)), abs(slope))
         step = moved(v) - values(v)
         if (moved(v) < self%model%variables(v)%lower .or. moved(v) > self%model%variables(v)%upper) then
            shifted_regimes = -1
            shifted = 0
            return
         end if
         call ask(self, moved, x, shifted, shifted_regimes, unused)
      end subroutine shift

   end subroutine differentiate

   !> See `curve_t`: the pull-off load of models that have it among their results.
   subroutine find_event(self, kind, values, nuisance, slopes, value, gradient, is_valid)
      !> The curve, whose nuisances shift the event.
      class(model_curve_t), intent(inout) :: self
      !> One of `event_...`.
      integer, intent(in) :: kind
      !> Values of all variables of the model.
      real(dp), intent(in) :: values(:)
      !> Values of the nuisances of the curve.
      real(dp), intent(in) :: nuisance(:)
      !> Derivatives of each free variable by the number that is fitted.
      real(dp), intent(in) :: slopes(:)
      !> Receives the load [N].
      real(dp), intent(out) :: value
      !> Receives its derivatives.
      real(dp), intent(out) :: gradient(:)
      !> Has the model such an event?
      logical, intent(out) :: is_valid
      type(model_curve_t) :: event
      real(dp) :: none(n_nuisances), r(1), j(1, size(slopes))
      integer :: i, n_rows

      is_valid = kind == event_pull_off_load .and. self%pull_off > 0 .and. any(self%is_contact)
      value = 0
      gradient = 0
      if (.not. is_valid) return
      i = maxloc(self%x, 1, self%is_contact)
      event%n = 1
      event%model => self%model
      event%abscissa = self%abscissa
      event%ordinate = self%pull_off
      event%regime = self%regime
      event%frees = self%frees
      event%x = self%x(i:i)
      event%y = [0.0_dp]
      event%sigma = [1.0_dp]
      event%is_contact = [.true.]
      allocate (event%fitted(1), event%residual(1), source=0.0_dp)
      none = 0
      none(nuisance_lateral_gain) = 1
      call event%evaluate(values, none, slopes, .true., n_rows, r, j, is_valid)
      if (.not. is_valid) return
      value = r(1) + nuisance(nuisance_load_offset)
      gradient = j(1, :)
      do i = 1, size(self%frees)
         if (self%frees(i)%data_set == self%data_set .and. self%frees(i)%nuisance == nuisance_load_offset) gradient(i) = slopes(i)
      end do
   end subroutine find_event

end module adfric_fit_model_curve
