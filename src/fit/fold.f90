! SPDX-License-Identifier: GPL-3.0-or-later
!> Where a measured curve ends, as its free variables move that end: the fold, in the unit of the abscissa.
!>
!> The abscissa of the fold is X_f = x0 + X0 phi_f, with x0 the zero, X0 the unit and phi_f what is prescribed at the fold of the path. Each
!> point of contact with X_i <= X_f lies beyond it. Just above the fold the ordinate is y_f + C (X - X_f)^p + ..., with C not 0. The
!> power p follows from the orders in the distance from the fold's place: phi rises with its square, or as t^2 and t^3, y as below.
!> For p < 1 the slope is infinite, for p = 1 it has a jump, and for p > 1 there is no kink.
module adfric_fit_fold
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi
   use adfric_fit_curve, only: curve_t
   use adfric_fit_objective, only: objective_t, take_estimate
   use adfric_fit_order, only: order_of
   use adfric_fit_path, only: path_t
   use adfric_fit_sphere_curve, only: sphere_curve_t, take_values
   use adfric_sphere_contact, only: theory_hertz, theory_dmt
   use adfric_sphere_variables, only: r_load, r_approach, r_contact_radius, r_contact_area, r_adhesion_radius, r_friction_radius
   implicit none (type, external)
   private
   public :: fold_t, choose_fold, find_fold, spread_below

   !> The fold of one curve, beside the points that it may pass.
   type :: fold_t
      !> Number of the data set; 0: no curve has a fold that moves.
      integer :: data_set = 0
      !> Abscissas of the points in contact that have no errors of the abscissa, rising, ordinates and their standard errors.
      real(dp), allocatable :: x(:), y(:), sigma(:)
   end type fold_t

contains

   !> Choose the curve whose fold is nearest to its points, relative to their range.
   subroutine choose_fold(self, q, is_held, fold)
      !> The sum of squares.
      type(objective_t), intent(inout) :: self
      !> The numbers that are fitted.
      real(dp), intent(in) :: q(:)
      !> Which of them stay as they are.
      logical, intent(in) :: is_held(:)
      !> Receives the fold.
      type(fold_t), intent(out) :: fold
      type(fold_t) :: one
      real(dp) :: at, power, by_free(size(q)), distance, least
      integer :: k

      least = huge(least)
      do k = 1, size(self%spheres)
         call take_contact(self%spheres(k), one)
         if (size(one%x) < 2) cycle
         call find_fold(self, q, one, at, by_free, power)
         if (.not. any(abs(by_free) > 0 .and. .not. is_held) .or. power > 1) cycle
         distance = max(0.0_dp, one%x(1) - at)/max(one%x(size(one%x)) - one%x(1), tiny(at))
         if (distance >= least) cycle
         least = distance
         fold = one
      end do
   end subroutine choose_fold

   !> The abscissa of the fold, how it moves, and the power by which the ordinate leaves it.
   subroutine find_fold(self, q, fold, at, by_free, power)
      !> The sum of squares; it receives the values of the variables.
      type(objective_t), intent(inout) :: self
      !> The numbers that are fitted.
      real(dp), intent(in) :: q(:)
      !> The curve.
      type(fold_t), intent(in) :: fold
      !> Receives the abscissa.
      real(dp), intent(out) :: at
      !> Receives its derivatives by the numbers that are fitted.
      real(dp), intent(out) :: by_free(:)
      !> Receives the power.
      real(dp), intent(out) :: power
      real(dp) :: v(size(q)), slopes(size(q)), prescribed_l

      call take_estimate(self, q, v, slopes)
      call self%set_values(v)
      associate (curve => self%spheres(self%number(fold%data_set)))
         call take_values(curve, self%values, self%nuisance(:, fold%data_set), slopes)
         associate (c => curve%common, path => curve%path)
            at = c%x_unit*path%held_at_fold + c%x_zero
            prescribed_l = path%fold%p_l
            if (path%is_base) prescribed_l = path%fold%d_l + path%ks*path%fold%p_l
            by_free = c%x_unit*(path%held_at_fold*c%x_unit_by + prescribed_l*c%lambda_by) + c%x_zero_by
            if (path%is_base) by_free = by_free + c%x_unit*path%fold%p*c%ks_by
         end associate
         power = power_of(curve)
      end associate
   end subroutine find_fold

   !> The power by which the ordinate leaves the fold.
   pure real(dp) function power_of(curve) result(power)
      !> The curve, with its path.
      type(sphere_curve_t), intent(in) :: curve
      logical :: is_touch
      integer :: of_abscissa

      associate (path => curve%path, y => curve%ordinate)
         if (path%theory == theory_hertz .or. path%theory == theory_dmt) then
            of_abscissa = merge(2, 3, path%is_base)
            select case (y)
            case (r_load)
               power = 3.0_dp/of_abscissa
            case (r_contact_radius, r_adhesion_radius, r_friction_radius)
               power = 1.0_dp/of_abscissa
            case default
               power = 2.0_dp/of_abscissa
            end select
            return
         end if
         ! at th = pi/2 load, approach and c change with the square of the distance, as the abscissa does, and the radius linearly
         is_touch = path%side < 0 .and. path%fold%t >= half_pi
         power = 0.5_dp
         if (is_touch .and. any(y == [r_load, r_approach, r_contact_area, r_adhesion_radius])) power = 1
      end associate
   end function power_of

   !> Take the points of a curve that the fold may pass.
   pure subroutine take_contact(curve, fold)
      !> The curve.
      class(curve_t), intent(in) :: curve
      !> Receives the points.
      type(fold_t), intent(inout) :: fold
      integer, allocatable :: kept(:)
      integer :: i

      kept = pack([(i, i=1, curve%n)], curve%is_contact .and. .not. curve%x_sigma > 0)
      kept = kept(order_of(curve%x(kept)))
      fold%data_set = curve%data_set
      fold%x = curve%x(kept)
      fold%y = curve%y(kept)
      fold%sigma = curve%sigma(kept)
   end subroutine take_contact

   !> The least sum of squares that the first points of a curve leave if all have one ordinate, whichever that is. It rises with their
   !> number. No place of the fold beyond so many points has a lesser S.
   pure subroutine spread_below(fold, least)
      !> The curve.
      type(fold_t), intent(in) :: fold
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
