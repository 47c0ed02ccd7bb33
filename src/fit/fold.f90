! SPDX-License-Identifier: GPL-3.0-or-later
!> Where a measured curve ends, as its free variables move that end: the fold, in the unit of the abscissa.
!>
!> The abscissa of the fold is X_f = x0 + X0 phi_f, with x0 the zero, X0 the unit and phi_f what is prescribed at the
!> fold of the path. Each point of contact with X_i <= X_f lies beyond it. Just above the fold the ordinate is y_f +
!> C (X - X_f)^p + ..., with C not 0. The power p follows from the orders in the distance from the fold's position: phi
!> rises with its square, or as t^2 and t^3, y as below. For p < 1 the slope is infinite, for p = 1 it has a jump,
!> and for p > 1 there is no kink.
module adfric_fit_fold
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi
   use adfric_fit_curve, only: fit_curve_t
   use adfric_fit_model_points, only: fold_t
   use adfric_fit_objective, only: objective_t, take_estimate
   use adfric_fit_order, only: order_of
   use adfric_fit_sphere_curve, only: sphere_curve_t, take_values
   use adfric_round_sphere_contact, only: theory_hertz, theory_dmt
   use adfric_round_sphere_variables, only: out => sphere_output
   implicit none (type, external)
   private
   public :: curve_fold_t, choose_fold, new_curve_fold, find_fold, fold_slopes, fold_slope, last_slopes, spread_below

   !> No kink: the slope does not jump.
   real(dp), parameter :: largest_power = 1.0_dp
   !> Where the power is looked at, as a part of the range of the abscissas; and a step of the numbers that are fitted.
   real(dp), parameter :: beside = 1.0e-6_dp, of_step = 3.0e-5_dp

   !> The fold of one curve, beside the points that it may pass.
   type :: curve_fold_t
      !> Number of the curve; 0: no curve has a fold that moves.
      integer :: curve = 0
      !> Abscissas of the points in contact that have no errors of the abscissa, rising, ordinates and their standard errors.
      real(dp), allocatable :: x(:), y(:), sigma(:)
      !> Rows of the residuals of these points.
      integer, allocatable :: row(:)
      !> The power p.
      real(dp) :: power = 0.5_dp
   end type curve_fold_t

contains

   !> Choose the curve whose fold is nearest to its points, relative to their range.
   subroutine choose_fold(self, q, is_fixed, fold)
      type(objective_t), intent(inout) :: self
      real(dp), intent(in) :: q(:)
      !> Which of them stay as they are.
      logical, intent(in) :: is_fixed(:)
      !> Receives the fold; its curve is 0 if there is none.
      type(curve_fold_t), intent(out) :: fold
      type(curve_fold_t) :: one
      real(dp) :: distance, least
      integer :: k

      least = huge(least)
      do k = 1, size(self%number)
         call new_curve_fold(self, q, is_fixed, k, one, distance)
         if (one%curve == 0 .or. distance >= least) cycle
         least = distance
         fold = one
      end do
   end subroutine choose_fold

   !> The fold of a curve, if it has one that moves and where S has a kink.
   subroutine new_curve_fold(self, q, is_fixed, curve, fold, distance)
      type(objective_t), intent(inout) :: self
      real(dp), intent(in) :: q(:)
      logical, intent(in) :: is_fixed(:)
      integer, intent(in) :: curve
      type(curve_fold_t), intent(out) :: fold
      !> Receives how far it is below all points, as a part of their range.
      real(dp), intent(out) :: distance
      type(curve_fold_t) :: one
      real(dp) :: at
      logical :: is_known

      distance = 0
      if (self%is_sphere(curve)) then
         call take_contact(self%spheres(self%number(curve)), one)
      else
         call take_contact(self%others(self%number(curve)), one)
      end if
      one%curve = curve
      if (size(one%x) < 2) return
      call find_fold(self, q, one, at, is_known)
      if (.not. is_known) return
      if (.not. any(abs(fold_slopes(self, q, one)) > 0 .and. .not. is_fixed)) return
      call find_power(self, q, at, one)
      if (one%power > largest_power) return
      distance = max(0.0_dp, one%x(1) - at)/max(one%x(size(one%x)) - one%x(1), tiny(at))
      fold = one
   end subroutine new_curve_fold

   !> The abscissa of the fold.
   subroutine find_fold(self, q, fold, at, is_known)
      !> The sum of squares; it receives the values of the variables.
      type(objective_t), intent(inout) :: self
      real(dp), intent(in) :: q(:)
      type(curve_fold_t), intent(in) :: fold
      !> Receives the abscissa.
      real(dp), intent(out) :: at
      logical, intent(out) :: is_known
      real(dp) :: v(size(q)), slopes(size(q))
      type(fold_t) :: of_model

      call take_estimate(self, q, v, slopes)
      call self%set_values(v)
      associate (number => self%number(fold%curve), nuisance => self%nuisance(:, self%data_set(fold%curve)))
         if (self%is_sphere(fold%curve)) then
            call take_values(self%spheres(number), self%spheres(number)%values_of(self%values), nuisance, slopes)
            associate (c => self%spheres(number)%common, path => self%spheres(number)%path)
               at = c%x_unit*path%prescribed_at_fold + c%x_zero
            end associate
            is_known = .true.
         else
            associate (curve => self%others(number))
               call curve%points%find_fold(curve%values_of(self%values), of_model)
               is_known = of_model%is_known
               at = of_model%x
               if (curve%x_nuisance > 0) at = at + nuisance(curve%x_nuisance)
            end associate
         end if
      end associate
   end subroutine find_fold

   !> How the abscissa of the fold changes with the numbers that are fitted.
   function fold_slopes(self, q, fold) result(by_free)
      type(objective_t), intent(inout) :: self
      real(dp), intent(in) :: q(:)
      type(curve_fold_t), intent(in) :: fold
      real(dp) :: by_free(size(q)), at
      logical :: is_known
      integer :: k

      if (self%is_sphere(fold%curve)) then
         call find_fold(self, q, fold, at, is_known)
         by_free = last_slopes(self, fold)
         return
      end if
      do k = 1, size(q)
         by_free(k) = fold_slope(self, q, fold, k)
      end do
   end function fold_slopes

   !> The same with one of these numbers, where `find_fold` has just been asked.
   real(dp) function fold_slope(self, q, fold, k) result(slope)
      type(objective_t), intent(inout) :: self
      real(dp), intent(in) :: q(:)
      type(curve_fold_t), intent(in) :: fold
      integer, intent(in) :: k
      real(dp) :: moved(size(q)), below, above, by_free(size(q))
      logical :: is_known

      slope = 0
      if (self%is_sphere(fold%curve)) then
         by_free = last_slopes(self, fold)
         slope = by_free(k)
         return
      end if
      if (self%frees(k)%variable == 0) then
         if (self%frees(k)%data_set /= self%data_set(fold%curve)) return
         if (self%frees(k)%nuisance == self%others(self%number(fold%curve))%x_nuisance) slope = self%unit(k)
         return
      end if
      moved = q
      moved(k) = q(k) - of_step
      call find_fold(self, moved, fold, below, is_known)
      if (.not. is_known) return
      moved(k) = q(k) + of_step
      call find_fold(self, moved, fold, above, is_known)
      if (is_known) slope = (above - below)/(2*of_step)
   end function fold_slope

   !> The same with all of them as the last evaluation of the sum of squares has found it.
   pure function last_slopes(self, fold) result(by_free)
      type(objective_t), intent(in) :: self
      type(curve_fold_t), intent(in) :: fold
      real(dp) :: by_free(self%n_free), prescribed_l

      if (.not. self%is_sphere(fold%curve)) then
         by_free = self%others(self%number(fold%curve))%fold_by
         return
      end if
      associate (c => self%spheres(self%number(fold%curve))%common, path => self%spheres(self%number(fold%curve))%path)
         prescribed_l = path%fold%p_l
         if (path%is_base) prescribed_l = path%fold%d_l + path%ks*path%fold%p_l
         by_free = c%x_unit*(path%prescribed_at_fold*c%x_unit_by + prescribed_l*c%lambda_by) + c%x_zero_by
         if (path%is_base) by_free = by_free + c%x_unit*path%fold%p*c%ks_by
      end associate
   end function last_slopes

   !> The power by which the ordinate leaves the fold. Any model is asked at two distances from it.
   subroutine find_power(self, q, at, fold)
      type(objective_t), intent(inout) :: self
      real(dp), intent(in) :: q(:)
      !> The abscissa of the fold.
      real(dp), intent(in) :: at
      !> The curve; it receives the power.
      type(curve_fold_t), intent(inout) :: fold
      real(dp) :: v(size(q)), slopes(size(q)), x(2), y(2), error, zero
      type(fold_t) :: of_model
      integer :: regimes(2)

      call take_estimate(self, q, v, slopes)
      call self%set_values(v)
      associate (number => self%number(fold%curve))
         if (self%is_sphere(fold%curve)) then
            fold%power = power_of(self%spheres(number))
            return
         end if
         associate (curve => self%others(number))
            zero = 0
            if (curve%x_nuisance > 0) zero = self%nuisance(curve%x_nuisance, self%data_set(fold%curve))
            call curve%points%find_fold(curve%values_of(self%values), of_model)
            x = at - zero + beside*(fold%x(size(fold%x)) - fold%x(1))*[1, 4]
            y = of_model%y
            fold%power = 2
            call curve%points%ask(curve%values_of(self%values), x, y, regimes, error, of_model)
            call curve%points%find_fold(curve%values_of(self%values), of_model)
            if (any(regimes < 0) .or. .not. all(abs(y - of_model%y) > 0)) return
            fold%power = log(abs((y(2) - of_model%y)/(y(1) - of_model%y)))/log(4.0_dp)
            fold%power = max(nint(12*fold%power), 1)/12.0_dp
         end associate
      end associate
   end subroutine find_power

   !> The power by which the ordinate leaves the fold.
   pure real(dp) function power_of(curve) result(power)
      type(sphere_curve_t), intent(in) :: curve
      logical :: is_touch
      integer :: of_abscissa

      associate (path => curve%path, y => curve%ordinate)
         if (path%theory == theory_hertz .or. path%theory == theory_dmt) then
            of_abscissa = merge(2, 3, path%is_base)
            select case (y)
            case (out%load)
               power = 3.0_dp/of_abscissa
            case (out%contact_radius, out%adhesion_radius, out%friction_radius)
               power = 1.0_dp/of_abscissa
            case default
               power = 2.0_dp/of_abscissa
            end select
            return
         end if
         ! at th = pi/2 load, approach and c change with the square of the distance, as the abscissa does, and the radius linearly
         is_touch = path%side < 0 .and. path%fold%t >= half_pi
         power = 0.5_dp
         if (is_touch .and. any(y == [out%load, out%approach, out%contact_area, out%adhesion_radius])) power = 1
      end associate
   end function power_of

   !> Take the points of a curve that the fold may pass.
   pure subroutine take_contact(curve, fold)
      class(fit_curve_t), intent(in) :: curve
      type(curve_fold_t), intent(inout) :: fold
      integer, allocatable :: kept(:)
      integer :: i

      kept = pack([(i, i=1, curve%n)], curve%is_contact .and. .not. curve%x_sigma > 0)
      kept = kept(order_of(curve%x(kept)))
      fold%x = curve%x(kept)
      fold%y = curve%y(kept)
      fold%sigma = curve%sigma(kept)
      fold%row = kept
   end subroutine take_contact

   !> The least sum of squares that the first points of a curve leave if all have one ordinate, whichever that is. It
   !> rises with their number. No position of the fold beyond so many points has a lesser S.
   pure subroutine spread_below(fold, least)
      type(curve_fold_t), intent(in) :: fold
      !> Receives the sum for the fold beyond 1, 2, ... points; shape `(size(fold%x))`.
      real(dp), intent(out) :: least(:)
      real(dp) :: weight, weights, mean, step, total
      integer :: k

      weights = 0
      mean = 0
      total = 0
      do k = 1, size(fold%x)
         weight = 1/fold%sigma(k)**2
         step = fold%y(k) - mean
         total = total + step**2*weight*weights/(weights + weight)
         weights = weights + weight
         mean = mean + step*weight/weights
         least(k) = total
      end do
   end subroutine spread_below

end module adfric_fit_fold
