! SPDX-License-Identifier: GPL-3.0-or-later
!> A measured curve of any model, with derivatives by differences, or in closed form where the model has it over the time.
!>
!> A result has the relative error e that the model says (`error_estimate`), 1e-13 at least. A step h forward leaves the error e/h + h/2 in
!> a derivative, least for h = e^(1/2); a central one e/h + h^2/6, least for about h = e^(1/3). A relative error of the derivatives moves
!> an estimate by about that part of its standard error, so steps forward will do on the way, and central ones for the covariance.
!> At a bound of the model's table, and where a neighbour has no solution or is of another regime, the step is taken to the other side.
!>
!> Where the model knows the fold x_f, the end of contact, a point is a index s = sqrt(x - x_f), over which ordinates are smooth
!> (`adfric_fit_model_slopes`), and no step crosses the fold. A point of contact beyond has the ordinate of the fold; where the abscissa
!> is a load, one more row says how far it is beyond, as in `adfric_fit_sphere_curve`. With errors of the abscissa the state is the
!> nearest point of the curve (`adfric_fit_model_foot`).
module adfric_fit_model_curve
   use adfric_base_kinds, only: dp
   use adfric_fit_curve, only: fit_curve_t, take_points, nuisance_slopes, abscissas_of
   use adfric_fit_model_foot, only: feet_t, find_feet
   use adfric_fit_model_points, only: model_points_t, new_model_points, is_beyond_fold
   use adfric_fit_model_slopes, only: slopes_t, set_slopes
   use adfric_fit_order, only: median_step
   use adfric_fit_parts, only: set_values_at, take_part
   use adfric_fit_problem, only: data_set_t, free_t, fit_t, n_nuisances, nuisance_load_offset, nuisance_friction_offset, &
      & nuisance_contact_point, nuisance_lateral_gain, nuisance_tilt, nuisance_drift_rate, event_pull_off_load
   use adfric_fit_sphere_curve, only: is_plain_sphere
   use adfric_describe_model, only: model_t
   use adfric_describe_of_fits, only: is_abscissa_of_fits
   implicit none (type, external)
   private
   public :: model_curve_t, new_model_curve

   !> A measured curve of any model.
   type, extends(fit_curve_t) :: model_curve_t
      !> What is asked of the model.
      type(model_points_t) :: points
      !> Which offset is taken off the abscissa; 0: none.
      integer :: x_nuisance = 0
      !> The free variables.
      type(free_t), allocatable :: frees(:)
      !> Variables of the model that zero and drift of a history are added to; 0: they are no such variables.
      integer :: of_model(n_nuisances) = 0
      !> Variable that says whose history it is; 0: it is that of all.
      integer :: history = 0
      !> How well loads of the abscissa are resolved, for points beyond the fold.
      real(dp) :: resolution = 1
      !> Indices of the feet at the last evaluation.
      type(feet_t) :: feet
      !> Error of the derivatives of the last evaluation, relative.
      real(dp) :: error = 0
      !> Of the last evaluation: derivatives of the abscissa of the fold by the numbers that are fitted; shape `(n_free)`.
      real(dp), allocatable :: fold_by(:)
   contains
      procedure :: evaluate
      procedure :: find_event
      procedure :: most_rows
      procedure :: own_values
   end type model_curve_t

contains

   !> Take the points of a data set that are one curve.
   subroutine new_model_curve(self, fit, number, points, unit)
      type(model_curve_t), intent(out) :: self
      type(fit_t), intent(in) :: fit
      integer, intent(in) :: number
      !> Indices of the points in the data set.
      integer, intent(in) :: points(:)
      !> The standard error of all ordinates where none is given.
      real(dp), intent(in) :: unit
      type(data_set_t) :: data
      real(dp) :: base(size(fit%base))

      call take_part(fit%data_sets(number), points, data)
      base = fit%base
      call set_values_at(data, 1, base)
      call take_points(self, number, data, points, unit)
      associate (whole => fit%data_sets(number))
         call new_model_points(self%points, fit%model, base, data%abscissa, data%ordinate, is_plain_sphere(fit, data))
         self%frees = fit%frees
         if (is_abscissa_of_fits(fit%model%variables(data%abscissa))) call find_shifts(self, fit%model)
         if (self%points%is_by_load) self%resolution = median_step(abscissas_of(self, whole))/sqrt(12.0_dp)
         select case (fit%model%variables(data%abscissa)%name)
         case ('load')
            self%x_nuisance = nuisance_load_offset
         case ('approach', 'base_approach')
            self%x_nuisance = nuisance_contact_point
         end select
      end associate
   end subroutine new_model_curve

   !> Zero and drift of a history are variables of the model.
   subroutine find_shifts(self, model)
      type(model_curve_t), intent(inout) :: self
      class(model_t), intent(in) :: model
      integer :: k

      self%of_model(nuisance_contact_point) = model%index_of('history', 'contact_point')
      self%of_model(nuisance_drift_rate) = model%index_of('history', 'drift_rate')
      do k = 1, size(model%variables)
         if (model%variables(k)%is_hidden .and. model%variables(k)%group == 'history' .and. model%variables(k)%name == 'data') &
            & self%history = k
      end do
      do k = 1, size(self%frees)
         associate (free => self%frees(k))
            if (free%data_set /= self%data_set .or. free%nuisance == 0) cycle
            free%variable = self%of_model(free%nuisance)
         end associate
      end do
   end subroutine find_shifts

   !> Values of all variables of the model, with zero and drift of the measurement.
   pure function own_values(self, values, nuisance) result(own)
      !> The curve.
      class(model_curve_t), intent(in) :: self
      !> Values of all variables, and of the nuisances.
      real(dp), intent(in) :: values(:), nuisance(:)
      real(dp) :: own(size(values))
      integer :: k

      own = values
      if (self%history > 0) own(self%history) = self%data_set
      do k = 1, n_nuisances
         if (self%of_model(k) > 0) own(self%of_model(k)) = own(self%of_model(k)) + nuisance(k)
      end do
   end function own_values

   !> See `fit_curve_t`: a second row for a point whose load, or foot, is not on the curve.
   pure integer function most_rows(self)
      class(model_curve_t), intent(in) :: self

      most_rows = self%n
      if (self%is_latent .or. self%points%is_by_load .and. self%points%pull_off_load > 0) most_rows = 2*self%n
   end function most_rows

   !> See `fit_curve_t`.
   subroutine evaluate(self, values, nuisance, slopes, is_exact, n_rows, r, j, is_valid)
      class(model_curve_t), intent(inout) :: self
      real(dp), intent(in) :: values(:), nuisance(:), slopes(:)
      logical, intent(in) :: is_exact
      integer, intent(out) :: n_rows
      real(dp), intent(inout) :: r(:), j(:, :)
      logical, intent(out) :: is_valid
      type(slopes_t) :: of
      real(dp) :: of_nuisance(size(slopes), n_nuisances), x_zero, x_zero_by(size(slopes))
      real(dp) :: own(size(values))
      integer :: contacts(count(self%is_contact)), k

      n_rows = self%n
      own = self%own_values(values, nuisance)
      call nuisance_slopes(self%frees, self%data_set, slopes, of_nuisance)
      x_zero = 0
      x_zero_by = 0
      if (self%x_nuisance > 0) then
         x_zero = nuisance(self%x_nuisance)
         x_zero_by = of_nuisance(:, self%x_nuisance)
      end if
      contacts = pack([(k, k=1, self%n)], self%is_contact)
      call take_base_line(self, nuisance, of_nuisance, r, j)
      associate (gain => nuisance(nuisance_lateral_gain), gain_by => of_nuisance(:, nuisance_lateral_gain))
         if (self%is_latent) then
            call find_feet(self%points, own, self%x(contacts) - x_zero, self%y(contacts) - self%fitted(contacts), &
               & self%x_sigma(contacts), self%sigma(contacts), gain, self%feet, is_valid)
            if (.not. is_valid) return
            call set_slopes(of, self%points, own, self%feet%x, maxval(abs(self%x)), self%frees, slopes, &
               & is_exact, .true., is_valid)
            if (.not. is_valid) return
            call add_latent(self, of, contacts, gain, gain_by, x_zero, x_zero_by, n_rows, r, j)
         else
            call set_slopes(of, self%points, own, self%x(contacts) - x_zero, maxval(abs(self%x)), self%frees, slopes, &
               & is_exact, any(abs(x_zero_by) > 0), is_valid)
            if (.not. is_valid) return
            call add_exact(self, of, contacts, gain, gain_by, x_zero, x_zero_by, n_rows, r, j)
         end if
      end associate
      do k = 1, size(slopes)
         j(:self%n, k) = j(:self%n, k)/self%sigma
      end do
      self%residual = -r(:self%n)
      self%error = of%derivative_error
      self%fold_by = of%fold_x_by + x_zero_by
   end subroutine evaluate

   !> What all points have, and free points have alone: the zero and the slope of the base line. `fitted` is that part of the ordinate.
   subroutine take_base_line(self, nuisance, of_nuisance, r, j)
      class(model_curve_t), intent(inout) :: self
      real(dp), intent(in) :: nuisance(:)
      !> Derivatives of the nuisances; shape `(n_free, n_nuisances)`.
      real(dp), intent(in) :: of_nuisance(:, :)
      real(dp), intent(inout) :: r(:)
      !> Receives the derivatives of the ordinates.
      real(dp), intent(inout) :: j(:, :)
      real(dp) :: zero, zero_by(size(of_nuisance, 1))
      integer :: k

      zero = nuisance(nuisance_friction_offset)
      zero_by = of_nuisance(:, nuisance_friction_offset)
      if (self%points%is_load) then
         zero = zero + nuisance(nuisance_load_offset)
         zero_by = zero_by + of_nuisance(:, nuisance_load_offset)
      end if
      self%fitted = zero + nuisance(nuisance_tilt)*self%x
      self%is_apart = .not. self%is_contact
      self%is_beyond = .false.
      r(:self%n) = (self%fitted - self%y)/self%sigma
      do k = 1, size(zero_by)
         j(:self%n, k) = zero_by(k) + of_nuisance(k, nuisance_tilt)*self%x
      end do
   end subroutine take_base_line

   !> Points whose abscissas have no errors.
   subroutine add_exact(self, of, contacts, gain, gain_by, x_zero, x_zero_by, n_rows, r, j)
      class(model_curve_t), intent(inout) :: self
      type(slopes_t), intent(in) :: of
      integer, intent(in) :: contacts(:)
      !> The gain and its derivatives.
      real(dp), intent(in) :: gain, gain_by(:)
      !> The zero of the abscissa and its derivatives.
      real(dp), intent(in) :: x_zero, x_zero_by(:)
      !> Number of rows so far; a load beyond the fold adds one.
      integer, intent(inout) :: n_rows
      !> The residuals, to which the model is added.
      real(dp), intent(inout) :: r(:)
      !> Derivatives of the ordinates, and of the rows that are added.
      real(dp), intent(inout) :: j(:, :)
      integer :: i, k

      do k = 1, size(contacts)
         i = contacts(k)
         self%fitted(i) = gain*of%y(k) + self%fitted(i)
         r(i) = (self%fitted(i) - self%y(i))/self%sigma(i)
         j(i, :) = of%y(k)*gain_by + gain*of%by(k, :) - gain*of%y_x(k)*x_zero_by + j(i, :)
         if (.not. is_beyond_fold(of%regimes(k))) cycle
         self%is_apart(i) = .not. abs(of%fold%y) > 0
         self%is_beyond(i) = .not. self%is_apart(i)
         if (.not. self%points%is_by_load) cycle
         n_rows = n_rows + 1
         r(n_rows) = (of%fold%x + x_zero - self%x(i))/self%resolution
         j(n_rows, :) = (of%fold_x_by + x_zero_by)/self%resolution
      end do
   end subroutine add_exact

   !> Points whose abscissas have errors: the distance along the normal at the foot, where the index on the curve does not count; of
   !> a foot that is the fold both distances.
   subroutine add_latent(self, of, contacts, gain, gain_by, x_zero, x_zero_by, n_rows, r, j)
      class(model_curve_t), intent(inout) :: self
      type(slopes_t), intent(in) :: of
      integer, intent(in) :: contacts(:)
      real(dp), intent(in) :: gain, gain_by(:), x_zero, x_zero_by(:)
      !> Number of rows so far; a foot that is the fold adds one.
      integer, intent(inout) :: n_rows
      real(dp), intent(inout) :: r(:)
      !> Derivatives of the residuals times the errors of the ordinates, and of the rows that are added.
      real(dp), intent(inout) :: j(:, :)
      real(dp) :: u, v, u_s, v_s, v_by(size(gain_by)), u_by(size(gain_by))
      integer :: i, k

      do k = 1, size(contacts)
         i = contacts(k)
         self%fitted(i) = gain*of%y(k) + self%fitted(i)
         self%foot(i) = self%feet%x(k) + x_zero
         v = (self%fitted(i) - self%y(i))/self%sigma(i)
         v_by = j(i, :) + gain*of%by_at_position(k, :) + of%y(k)*gain_by
         self%is_apart(i) = is_beyond_fold(of%regimes(k)) .and. .not. abs(of%fold%y) > 0
         r(i) = v
         j(i, :) = v_by
         if (.not. self%x_sigma(i) > 0) cycle
         u = (self%foot(i) - self%x(i))/self%x_sigma(i)
         u_by = (of%x_by_at_position(k, :) + x_zero_by)/self%x_sigma(i)
         if (is_beyond_fold(of%regimes(k)) .and. abs(of%fold%y) > 0) then
            n_rows = n_rows + 1
            r(n_rows) = u
            j(n_rows, :) = u_by
            cycle
         end if
         u_s = of%x_s(k)/self%x_sigma(i)
         v_s = gain*of%y_s(k)/self%sigma(i)
         associate (length => hypot(u_s, v_s))
            r(i) = (u_s*v - v_s*u)/length
            j(i, :) = (u_s*v_by - v_s*u_by*self%sigma(i))/length
         end associate
      end do
   end subroutine add_latent

   !> See `fit_curve_t`: the pull-off load of models that have it among their results.
   subroutine find_event(self, kind, values, nuisance, slopes, value, gradient, is_valid)
      class(model_curve_t), intent(inout) :: self
      integer, intent(in) :: kind
      real(dp), intent(in) :: values(:), nuisance(:), slopes(:)
      real(dp), intent(out) :: value, gradient(:)
      logical, intent(out) :: is_valid
      type(model_curve_t) :: event
      real(dp) :: none(n_nuisances), r(1), j(1, size(slopes))
      integer :: i, n_rows

      is_valid = kind == event_pull_off_load .and. self%points%pull_off_result > 0 .and. any(self%is_contact)
      value = 0
      gradient = 0
      if (.not. is_valid) return
      i = maxloc(self%x, 1, self%is_contact)
      event%n = 1
      event%points = self%points
      event%points%ordinate = self%points%pull_off_result
      event%points%is_load = .false.
      ! the fold is known, not looked at
      event%points%pull_off_load = 0
      event%points%is_sphere = .false.
      event%frees = self%frees
      event%x = self%x(i:i)
      event%y = [0.0_dp]
      event%sigma = [1.0_dp]
      event%is_contact = [.true.]
      event%is_apart = [.false.]
      event%is_beyond = [.false.]
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
