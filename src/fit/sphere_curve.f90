! SPDX-License-Identifier: GPL-3.0-or-later
!> A measured curve of the model `sphere`, with exact derivatives.
!>
!> With X = X0 phi + x0 and Y = Y0 y + y0 (units X0, Y0, zeros x0, y0; phi, y functions of the index t and of lambda, see
!> `adfric_fit_path` and `adfric_fit_ordinate`), and d ln X0, d ln Y0, d ln ks, d lambda the changes with a free variable:
!>
!> - Exact abscissas: t is where X(t) = X_i, so dY = Y0 (y dlnY0 + y_l dl + (y_t/phi_t) (-phi dlnX0 - dx0/X0 - phi_l dl - P dks)) + dy0.
!> - Abscissas with errors: the state is the nearest point of the curve, the foot (`adfric_fit_foot`). By the envelope theorem the distance
!>   along the normal changes as if t were prescribed.
!> - The foot is the fold: both components count, and the fold moves with lambda and ks.
!> - A point of contact beyond the fold has the fold's ordinate; where the abscissa is a load, one more row says how far it is beyond,
!>   in units of the median step of the loads over the root of 12. S has a kink there, and its count is reported.
!>
!> A index found for one set of variables is the start for the next, moved along a parabola.
module adfric_fit_sphere_curve
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_unset, only: is_set
   use adfric_fit_curve, only: fit_curve_t, abscissas_of, take_points
   use adfric_fit_foot, only: foot_t, find_foot
   use adfric_fit_frame, only: frame_t, new_frame, set_frame
   use adfric_fit_order, only: median_step
   use adfric_fit_ordinate, only: ordinate_t, get_ordinate, is_ordinate
   use adfric_fit_path, only: sphere_path_t, set_path, find_state, move_state, is_outer, ends_unloaded
   use adfric_fit_parts, only: set_values_at, take_part
   use adfric_fit_problem, only: free_t, fit_t, data_set_t, event_pull_off_load, event_jump_in_approach, nuisance_load_offset
   use adfric_fit_sphere_basis, only: basis_t, set_basis, of_radius, of_work, of_lambda
   use adfric_fit_state, only: fit_state_t, add_derivatives
   use adfric_round_sphere_contact, only: theory_maugis_dugdale
   use adfric_round_sphere_variables, only: units_si, in => sphere_input, out => sphere_output
   implicit none (type, external)
   private
   public :: sphere_curve_t, new_sphere_curve, is_sphere_curve, is_plain_sphere, take_values

   !> A measured curve of a sphere.
   type, extends(fit_curve_t) :: sphere_curve_t
      !> The ordinate, a index in the results of the model.
      integer :: ordinate = 0
      !> Is the abscissa the position of a base, not the load?
      logical :: is_base = .false.
      !> The free variables.
      type(free_t), allocatable :: frees(:)
      !> How well the loads are resolved, for points beyond the fold.
      real(dp) :: resolution = 1
      !> The sphere, its path, and what all points have in common.
      type(basis_t) :: basis
      !> The path of prescribed states.
      type(sphere_path_t) :: path
      !> What all points have in common.
      type(frame_t) :: common
      !> Of the last evaluation: indices (0: none), what was prescribed there, and its derivatives by the index (two), lambda and
      !> ks.
      real(dp), allocatable :: t(:), prescribed(:), prescribed_t(:), prescribed_tt(:), prescribed_l(:), prescribed_ks(:)
      !> Of the last evaluation: lambda and ks.
      real(dp) :: last_lambda = 0, last_ks = 0
      !> Derivatives of the residuals by what a free variable may change: the indices `by_...`; shape `(n, n_changes)`.
      real(dp), allocatable :: change(:, :)
   contains
      procedure :: evaluate
      procedure :: find_event
      procedure :: most_rows
   end type sphere_curve_t

   !> What a free variable may change: the logarithms of both units, lambda, x, both zeros, ks, the tilt.
   integer, parameter :: by_y_unit = 1, by_x_unit = 2, by_lambda = 3, by_edge = 4, by_y_zero = 5, by_x_zero = 6, by_ks = 7, &
      & by_tilt = 8, n_changes = 8

contains

   !> Is a data set of the model `sphere` one that this module computes? Otherwise the model itself is asked, as where an approach has
   !> errors.
   logical function is_sphere_curve(fit, data)
      type(fit_t), intent(in) :: fit
      type(data_set_t), intent(in) :: data

      is_sphere_curve = is_plain_sphere(fit, data)
      if (data%abscissa == in%approach .and. allocated(data%x_sigma)) is_sphere_curve = .false.
   end function is_sphere_curve

   !> Is a data set one of a smooth sphere at rest or in steady sliding, on its stable branch?
   logical function is_plain_sphere(fit, data)
      type(fit_t), intent(in) :: fit
      type(data_set_t), intent(in) :: data
      !> What takes a contact out of steady sliding.
      integer, parameter :: beside_sliding(*) = [in%tangential_force, in%tangential_displacement, in%base_displacement, &
         & in%lateral_stiffness]
      real(dp) :: base(size(fit%base))

      is_plain_sphere = .false.
      if (fit%model%name /= 'sphere') return
      base = fit%base
      call set_values_at(data, 1, base)
      is_plain_sphere = (data%abscissa == in%load .or. data%abscissa == in%approach) .and. is_ordinate(data%ordinate) &
         & .and. nint(base(in%units)) == units_si .and. nint(base(in%branch)) == 1 &
         & .and. .not. base(in%interaction) > 0 .and. .not. any(fit%frees%variable == in%interaction) &
         & .and. .not. any(fit%frees%variable == in%pressure_factor) .and. .not. any(is_set(base(beside_sliding)))
      if (is_plain_sphere .and. is_set(base(in%pressure_factor))) is_plain_sphere = .not. abs(base(in%pressure_factor)) > 0
   end function is_plain_sphere

   !> Take the points of a data set that are one curve.
   subroutine new_sphere_curve(self, fit, number, points, unit)
      type(sphere_curve_t), intent(out) :: self
      type(fit_t), intent(in) :: fit
      integer, intent(in) :: number
      !> Indices of the points in the data set.
      integer, intent(in) :: points(:)
      !> The standard error of all ordinates where none is given.
      real(dp), intent(in) :: unit
      type(data_set_t) :: data

      call take_part(fit%data_sets(number), points, data)
      call take_points(self, number, data, points, unit)
      self%ordinate = fit%data_sets(number)%ordinate
      self%is_base = fit%data_sets(number)%abscissa == in%approach
      self%frees = fit%frees
      allocate (self%t(self%n), self%prescribed(self%n), self%prescribed_t(self%n), self%prescribed_tt(self%n), &
         & self%prescribed_l(self%n), &
         & self%prescribed_ks(self%n), source=0.0_dp)
      allocate (self%change(self%n, n_changes), source=0.0_dp)
      self%resolution = median_step(abscissas_of(self, fit%data_sets(number)))/sqrt(12.0_dp)
      call new_frame(self%common, size(fit%frees))
   end subroutine new_sphere_curve

   !> See `fit_curve_t`: a second row for every point at most.
   pure integer function most_rows(self)
      class(sphere_curve_t), intent(in) :: self

      most_rows = 2*self%n
   end function most_rows

   !> Take new values: the sphere, the path, the units and zeros, and how they change.
   subroutine take_values(self, values, nuisance, slopes)
      !> The curve; it receives what all points have in common.
      class(sphere_curve_t), intent(inout) :: self
      real(dp), intent(in) :: values(:), nuisance(:), slopes(:)
      real(dp) :: ks

      call set_basis(self%basis, values, self%frees, slopes)
      call set_frame(self%common, self%basis, self%frees, self%data_set, self%ordinate, self%is_base, nuisance, slopes, ks)
      call set_path(self%path, self%basis%theory, self%is_base, self%basis%lambda, ks)
   end subroutine take_values

   !> See `fit_curve_t`.
   subroutine evaluate(self, values, nuisance, slopes, is_exact, n_rows, r, j, is_valid)
      class(sphere_curve_t), intent(inout) :: self
      real(dp), intent(in) :: values(:), nuisance(:), slopes(:)
      logical, intent(in) :: is_exact
      integer, intent(out) :: n_rows
      real(dp), intent(inout) :: r(:), j(:, :)
      logical, intent(out) :: is_valid
      integer :: i

      call take_values(self, values, nuisance, slopes)
      n_rows = self%n
      do i = 1, self%n
         if (.not. self%is_contact(i)) then
            self%is_apart(i) = .true.
            self%fitted(i) = self%common%y_zero + self%common%tilt*self%x(i)
            r(i) = (self%fitted(i) - self%y(i))/self%sigma(i)
            self%change(i, by_y_zero) = 1/self%sigma(i)
            self%change(i, by_tilt) = self%x(i)/self%sigma(i)
         else if (self%x_sigma(i) > 0) then
            call evaluate_latent(self, i, n_rows, r, j)
         else
            call evaluate_exact(self, i, n_rows, r, j)
         end if
         self%residual(i) = -r(i)
      end do
      call add_changes(self, j)
      self%last_lambda = self%path%lambda
      self%last_ks = self%path%ks
      is_valid = all(abs(r(:n_rows)) <= sqrt(huge(1.0_dp)))
      associate (unused => is_exact)
      end associate
   end subroutine evaluate

   !> Derivatives of the points' residuals by the free variables, of which most change few things.
   pure subroutine add_changes(self, j)
      class(sphere_curve_t), intent(in) :: self
      !> Receives the derivatives.
      real(dp), intent(inout) :: j(:, :)
      real(dp) :: share(n_changes)
      integer :: k, m

      associate (c => self%common)
         do k = 1, size(self%frees)
            share = [c%y_unit_by(k), c%x_unit_by(k), c%lambda_by(k), c%edge_by(k), c%y_zero_by(k), c%x_zero_by(k), c%ks_by(k), &
               & c%tilt_by(k)]
            j(:self%n, k) = 0
            do m = 1, n_changes
               if (abs(share(m)) > 0) j(:self%n, k) = j(:self%n, k) + share(m)*self%change(:, m)
            end do
         end do
      end associate
   end subroutine add_changes

   !> A point whose abscissa has no error.
   subroutine evaluate_exact(self, i, n_rows, r, j)
      class(sphere_curve_t), intent(inout) :: self
      integer, intent(in) :: i
      !> Number of rows so far; a point beyond the fold adds one.
      integer, intent(inout) :: n_rows
      real(dp), intent(inout) :: r(:), j(:, :)
      type(fit_state_t) :: s
      type(ordinate_t) :: o
      real(dp) :: prescribed, share, prescribed_l, prescribed_ks, weight, last_step
      logical :: is_beyond

      associate (c => self%common, path => self%path)
         prescribed = (self%x(i) - c%x_zero)/c%x_unit
         call predict(self, i, prescribed)
         call find_state(path, prescribed, self%t(i), s, last_step, is_beyond)
         self%is_beyond(i) = is_beyond .and. .not. ends_unloaded(path)
         self%is_apart(i) = is_beyond .and. ends_unloaded(path)
         if (.not. is_beyond) then
            call add_derivatives(path%theory, path%lambda, s)
            call move_state(path, s, last_step)
            self%t(i) = s%t
         end if
         call get_ordinate(self%ordinate, self%basis%edge, s, o)
         self%fitted(i) = c%y_unit*o%y + c%y_zero + c%tilt*self%x(i)
         r(i) = (self%fitted(i) - self%y(i))/self%sigma(i)
         weight = c%y_unit/self%sigma(i)
         if (is_beyond) then
            self%t(i) = 0
            self%change(i, :) = 0
            self%change(i, by_y_unit) = weight*o%y
            self%change(i, by_lambda) = weight*(o%y_l + o%y_t*path%fold_l)
            self%change(i, by_edge) = weight*o%y_x
            self%change(i, by_ks) = weight*o%y_t*path%fold_ks
            self%change(i, by_y_zero) = 1/self%sigma(i)
            self%change(i, by_tilt) = self%x(i)/self%sigma(i)
            if (self%is_base) return
            n_rows = n_rows + 1
            r(n_rows) = c%x_unit*(path%prescribed_at_fold - prescribed)/self%resolution
            j(n_rows, :) = (c%x_unit*(path%prescribed_at_fold*c%x_unit_by + s%p_l*c%lambda_by) + c%x_zero_by)/self%resolution
            return
         end if
         prescribed_l = s%p_l
         prescribed_ks = 0
         self%prescribed_t(i) = s%p_t
         self%prescribed_tt(i) = s%p_tt
         if (self%is_base) then
            prescribed_l = s%d_l + path%ks*s%p_l
            prescribed_ks = s%p
            self%prescribed_t(i) = s%d_t + path%ks*s%p_t
            self%prescribed_tt(i) = s%d_tt + path%ks*s%p_tt
         end if
         self%prescribed(i) = prescribed
         self%prescribed_l(i) = prescribed_l
         self%prescribed_ks(i) = prescribed_ks
         share = o%y_t/self%prescribed_t(i)
         self%change(i, by_y_unit) = weight*o%y
         self%change(i, by_x_unit) = -weight*share*prescribed
         self%change(i, by_lambda) = weight*(o%y_l - share*prescribed_l)
         self%change(i, by_edge) = weight*o%y_x
         self%change(i, by_y_zero) = 1/self%sigma(i)
         self%change(i, by_tilt) = self%x(i)/self%sigma(i)
         self%change(i, by_x_zero) = -weight*share/c%x_unit
         self%change(i, by_ks) = -weight*share*prescribed_ks
      end associate
   end subroutine evaluate_exact

   !> Move the last index of a point along the tangent to where it is now, if it is not far.
   subroutine predict(self, i, prescribed)
      class(sphere_curve_t), intent(inout) :: self
      integer, intent(in) :: i
      real(dp), intent(in) :: prescribed
      real(dp) :: t, step, bend

      if (.not. self%t(i) > 0) return
      step = (prescribed - self%prescribed(i) - self%prescribed_l(i)*(self%path%lambda - self%last_lambda) &
         & - self%prescribed_ks(i)*(self%path%ks - self%last_ks))/self%prescribed_t(i)
      bend = self%prescribed_tt(i)*step/(2*self%prescribed_t(i))
      if (abs(bend) < 0.3_dp) step = step*(1 - bend)
      t = self%t(i) + step
      if (abs(t - self%t(i)) < self%t(i)/2 .and. is_outer(self%path, t, self%path%fold%t)) self%t(i) = t
   end subroutine predict

   !> A point whose abscissa has an error.
   subroutine evaluate_latent(self, i, n_rows, r, j)
      class(sphere_curve_t), intent(inout) :: self
      integer, intent(in) :: i
      !> Number of rows so far; a point whose foot is the fold adds one.
      integer, intent(inout) :: n_rows
      real(dp), intent(inout) :: r(:), j(:, :)
      type(fit_state_t) :: s
      type(ordinate_t) :: o
      type(foot_t) :: point
      real(dp) :: u, v, u_t, v_t, length, x_weight, y_weight
      logical :: is_fold

      associate (c => self%common, path => self%path)
         point = foot_t(self%ordinate, self%basis%edge, self%x(i), self%y(i), self%x_sigma(i), self%sigma(i))
         call find_foot(point, c, path, self%t(i), s, o, is_fold)
         x_weight = c%x_unit/self%x_sigma(i)
         y_weight = c%y_unit/self%sigma(i)
         u = (c%x_unit*s%p + c%x_zero - self%x(i))/self%x_sigma(i)
         v = (c%y_unit*o%y + c%y_zero - self%y(i))/self%sigma(i)
         self%fitted(i) = c%y_unit*o%y + c%y_zero
         self%foot(i) = c%x_unit*s%p + c%x_zero
         self%is_beyond(i) = .false.
         if (is_fold) then
            r(i) = v
            self%change(i, :) = 0
            self%change(i, by_y_unit) = y_weight*o%y
            self%change(i, by_lambda) = y_weight*(o%y_l + o%y_t*path%fold_l)
            self%change(i, by_edge) = y_weight*o%y_x
            self%change(i, by_y_zero) = 1/self%sigma(i)
            n_rows = n_rows + 1
            r(n_rows) = u
            j(n_rows, :) = x_weight*(s%p*c%x_unit_by + s%p_l*c%lambda_by) + c%x_zero_by/self%x_sigma(i)
            return
         end if
         ! the normal, upward, in standard errors
         u_t = abs(x_weight*s%p_t)
         v_t = abs(y_weight*o%y_t)
         length = hypot(u_t, v_t)
         u_t = u_t/length
         v_t = v_t/length
         r(i) = u_t*v - v_t*u
         self%change(i, by_y_unit) = u_t*y_weight*o%y
         self%change(i, by_x_unit) = -v_t*x_weight*s%p
         self%change(i, by_lambda) = u_t*y_weight*o%y_l - v_t*x_weight*s%p_l
         self%change(i, by_edge) = u_t*y_weight*o%y_x
         self%change(i, by_y_zero) = u_t/self%sigma(i)
         self%change(i, by_x_zero) = -v_t/self%x_sigma(i)
      end associate
   end subroutine evaluate_latent

   !> An event with its derivatives. On approach the surfaces jump into contact where the attraction begins: in Maugis-Dugdale where the
   !> gap is its range, in the other theories at touch. Until then nothing loads the spring. The end of contact under a load is the fold;
   !> that of a base is the end of all states, also of those without intimate contact.
   subroutine find_event(self, kind, values, nuisance, slopes, value, gradient, is_valid)
      class(sphere_curve_t), intent(inout) :: self
      !> One of `event_...`.
      integer, intent(in) :: kind
      real(dp), intent(in) :: values(:), nuisance(:), slopes(:)
      !> Receives the load [N] or position [m].
      real(dp), intent(out) :: value
      !> Receives its derivatives.
      real(dp), intent(out) :: gradient(:)
      logical, intent(out) :: is_valid
      type(sphere_path_t) :: path
      real(dp) :: jump

      call take_values(self, values, nuisance, slopes)
      associate (c => self%common, b => self%basis%by_free, p => self%path)
         is_valid = kind == event_pull_off_load .or. self%is_base
         value = 0
         gradient = 0
         if (kind == event_pull_off_load) then
            path = self%path
            call set_path(path, p%theory, .false., p%lambda, 0.0_dp)
            value = self%basis%force*path%fold%p + nuisance(nuisance_load_offset)
            gradient = self%basis%force*(path%fold%p*(b(:, of_work) + b(:, of_radius)) + path%fold%p_l*c%lambda_by) + c%load_zero_by
         else if (kind == event_jump_in_approach) then
            jump = 0
            if (p%theory == theory_maugis_dugdale) jump = -2/(pi*p%lambda)
            value = c%x_unit*jump + c%x_zero
            gradient = c%x_unit*jump*(c%x_unit_by - b(:, of_lambda)) + c%x_zero_by
         else
            path = self%path
            call set_path(path, p%theory, .true., p%lambda, p%ks, .true.)
            value = c%x_unit*path%prescribed_at_fold + c%x_zero
            gradient = c%x_unit*(path%prescribed_at_fold*c%x_unit_by + (path%fold%d_l + p%ks*path%fold%p_l)*c%lambda_by &
               & + path%fold%p*c%ks_by) + c%x_zero_by
         end if
      end associate
   end subroutine find_event

end module adfric_fit_sphere_curve
