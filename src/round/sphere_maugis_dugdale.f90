! SPDX-License-Identifier: GPL-3.0-or-later
!> Maugis's theory with Dugdale's constant stress of adhesion, for every lambda and X.
!>
!> Along its curve (see `dugdale_curve`) radius falls; load and approach fall to their least values and rise again
!> to a = 0. Beyond, the surfaces only attract each other, on a disc of radius c, down to c = 0.
module adfric_round_sphere_maugis_dugdale
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_constants, only: pi
   use adfric_numerics_powers, only: cube_root
   use adfric_numerics_scalar_root, only: equation_t, find_root
   use adfric_round_sphere_contact, only: sphere_contact_t, theory_t, branch_stable, control_approach
   use adfric_round_sphere_dugdale_curve, only: dugdale_point_t, get_curve_point, get_disc, get_disc_radius, guess_position, &
      & farthest, largest_radius
   implicit none (type, external)
   private
   public :: maugis_t

   !> Maugis-Dugdale for one lambda and one X.
   type, extends(theory_t) :: maugis_t
      !> Maugis's parameter, > 0.
      real(dp) :: lambda = 1
   contains
      procedure :: of_radius
      procedure :: of_load
      procedure :: of_approach
      procedure :: pull_off
   end type maugis_t

   !> Quantities along the curve.
   integer, parameter :: radius_along = 1, load_along = 2, approach_along = 3

   !> A quantity along the curve less a given value, or its slope, as a function of the position.
   type, extends(equation_t) :: curve_equation_t
      !> Maugis's parameter, X, and the given value of the quantity, reduced.
      real(dp) :: lambda = 1, ratio = 1, given = 0
      !> One of `..._along`.
      integer :: quantity = radius_along
      !> Is the slope of the quantity meant, not the quantity?
      logical :: is_slope = .false.
   contains
      procedure :: evaluate
      procedure :: compare
      procedure :: excess_of
   end type curve_equation_t

   !> Step of the position for the slope of a slope; it need not be exact.
   real(dp), parameter :: small_step = 1.0e-5_dp
   !> A Newton step below the first ends the search; a step above the second is not taken.
   real(dp), parameter :: close_enough = 1.0e-8_dp, longest_step = 1.0_dp
   integer, parameter :: max_plain_steps = 12
   !> X^(2/3) lambda above which separation under approach begins in intimate contact, [9/(16 (1 - 1/pi))]^(1/3).
   real(dp), parameter :: first_intimate = (9/(16*(1 - 1/pi)))**(1.0_dp/3)

contains

   !> See `theory_t`. At radius 0 the surfaces are about to touch.
   pure subroutine of_radius(self, value, contact)
      class(maugis_t), intent(in) :: self
      !> Radius a of the contact, reduced, >= 0.
      real(dp), intent(in) :: value
      !> In: a neighbour that helps the search, or a new one. Out: the contact, with `is_found` and `is_converged`.
      type(sphere_contact_t), intent(inout) :: contact

      if (has_asserts) call assert(value >= 0 .and. self%lambda > 0 .and. self%ratio >= 0, &
         & 'of_radius: radius >= 0, lambda > 0, X >= 0')
      if (value > 0) then
         if (.not. abs(contact%position) > 0) contact%position = guess_position(self%lambda, self%ratio, value)
         call go_to(self, radius_along, value, farthest, .true., contact)
      else
         call go_apart(self, get_disc_radius(self%lambda, self%ratio), contact)
      end if
      contact%radius = value
   end subroutine of_radius

   !> See `theory_t`. A load has one stable state, so the search ends where it meets one.
   pure subroutine of_load(self, value, branch, contact)
      class(maugis_t), intent(in) :: self
      !> Load P of the contact, reduced; tension is negative.
      real(dp), intent(in) :: value
      !> One of `branch_...`: which state is meant where there are two.
      integer, intent(in) :: branch
      !> In: a neighbour that helps the search, or a new one. Out: the contact, with `is_found` and `is_converged`.
      type(sphere_contact_t), intent(inout) :: contact
      type(sphere_contact_t) :: fold

      if (branch == branch_stable .and. value > -2*self%ratio) then
         if (.not. abs(contact%position) > 0) then
            contact%position = guess_position(self%lambda, self%ratio, &
               & cube_root(value + (2 + sqrt(value + 2*self%ratio))*self%ratio))
         end if
         call go_to(self, load_along, value, farthest, value > 0, contact)
         if (contact%is_converged .and. contact%is_stable) return
      end if
      call self%pull_off(0, fold)
      contact = sphere_contact_t()
      if (value < fold%load .or. .not. fold%is_found) return
      if (branch == branch_stable) then
         contact%position = fold%position - 0.5_dp
         call go_to(self, load_along, value, fold%position, .true., contact)
      else if (value > 0) then
         return
      else if (2*value < -pi*self%ratio*self%lambda*get_disc_radius(self%lambda, self%ratio)**2) then
         contact%position = fold%position + 0.5_dp
         call go_to(self, load_along, value, farthest, .true., contact, rises_from=fold%position)
      else if (self%ratio > 0) then
         call go_apart(self, sqrt(-2*value/(pi*self%ratio*self%lambda)), contact)
         contact%load = value
      end if
      contact%is_stable = branch == branch_stable
   end subroutine of_load

   !> See `theory_t`. Held at a distance, the surfaces may part without a jump, through a = 0 to a smaller disc.
   pure subroutine of_approach(self, value, branch, contact)
      class(maugis_t), intent(in) :: self
      !> Approach delta of the contact, reduced; separation is negative.
      real(dp), intent(in) :: value
      !> One of `branch_...`: which state is meant where there are two.
      integer, intent(in) :: branch
      !> In: a neighbour that helps the search, or a new one. Out: the contact, with `is_found` and `is_converged`.
      type(sphere_contact_t), intent(inout) :: contact
      type(sphere_contact_t) :: fold
      real(dp) :: largest, mean, half, touching

      largest = get_disc_radius(self%lambda, self%ratio)
      mean = 8*self%ratio*self%lambda/(3*pi)
      ! a = 0 as the end of the contacts: that of the discs loses its digits where lambda is small
      touching = -4*self%ratio*self%lambda*largest/3
      if (branch == branch_stable .and. value >= touching) then
         if (.not. abs(contact%position) > 0) then
            contact%position = guess_position(self%lambda, self%ratio, &
               & max(sqrt(value - touching) + 0.6_dp*cube_root(self%ratio)*self%lambda/(1 + self%lambda), tiny(value)))
         end if
         call go_to(self, approach_along, value, farthest, value > touching, contact)
         contact%is_stable = contact%is_converged .and. contact%is_stable
         if (contact%is_stable) return
      end if
      call self%pull_off(control_approach, fold)
      contact = sphere_contact_t()
      if (value < fold%approach) return
      half = sqrt(max(0.0_dp, mean**2 + 2*(value + 2/(pi*self%lambda))))
      if (branch == branch_stable .and. largest > mean .and. value < touching) then
         call go_apart(self, mean + half, contact)
      else if (branch == branch_stable) then
         contact%position = fold%position - 0.5_dp
         call go_to(self, approach_along, value, merge(fold%position, farthest, largest <= mean), .true., contact)
      else if (largest <= mean .and. value < touching) then
         contact%position = fold%position + 0.5_dp
         call go_to(self, approach_along, value, farthest, .true., contact, rises_from=fold%position)
      else if (value <= -2/(pi*self%lambda)) then
         ! the smaller root, from the product of both
         call go_apart(self, -2*(value + 2/(pi*self%lambda))/(mean + half), contact)
      end if
      contact%approach = value
      contact%is_stable = branch == branch_stable
   end subroutine of_approach

   !> See `theory_t`.
   pure subroutine pull_off(self, control, contact)
      class(maugis_t), intent(in) :: self
      integer, intent(in) :: control
      type(sphere_contact_t), intent(out) :: contact
      type(curve_equation_t) :: equation
      type(dugdale_point_t) :: point
      real(dp) :: mean, largest

      largest = get_disc_radius(self%lambda, self%ratio)
      mean = 8*self%ratio*self%lambda/(3*pi)
      if (.not. self%ratio > 0) then
         call go_apart(self, largest, contact)
      else if (control == control_approach .and. largest > mean) then
         call go_apart(self, mean, contact)
      else
         equation%lambda = self%lambda
         equation%ratio = self%ratio
         equation%is_slope = .true.
         equation%quantity = merge(approach_along, load_along, control == control_approach)
         contact%position = guess_pull_off(control, self%ratio**(2.0_dp/3)*self%lambda)
         call find_root(equation, start_of(self), farthest, .true., contact%position, contact%is_converged, &
            & close_enough)
         call get_curve_point(self%lambda, self%ratio, contact%position, point)
         call read_point(point, 0.0_dp, contact, equation%quantity)
      end if
      contact%is_stable = .true.
   end subroutine pull_off

   !> A guess of the position of pull-off in intimate contact, to 0.001 under load and to 0.01 under approach: rational functions
   !> fitted to positions that were found for X = 1, with the limits of small and large lambda.
   pure real(dp) function guess_pull_off(control, lambda) result(position)
      !> One of `control_...`: what is prescribed. A given radius counts as a given load.
      integer, intent(in) :: control
      !> Parameter X^(2/3) lambda [-]; under approach above `first_intimate`, where separation begins in intimate contact.
      real(dp), intent(in) :: lambda
      real(dp) :: v

      if (control == control_approach) then
         v = first_intimate/lambda
         position = 1.65077_dp + v*(-1.61163_dp + v*(0.77594_dp + v*(-0.07941_dp - 0.27036_dp*v)))
         position = log(position/(max(1 - v, epsilon(v))*lambda))
      else
         v = sqrt(lambda)
         position = 0.538865_dp + v*(0.001055_dp + v*(0.473604_dp + v*(0.522652_dp + 1.988951_dp*v)))
         position = log(position/(1 + v*(0.025842_dp + v*(0.501305_dp + 1.736954_dp*v)))) - 3*log(v)
      end if
   end function guess_pull_off

   !> Find the position on the curve where a quantity has a value.
   pure subroutine go_to(self, quantity, value, high, is_alone, contact, rises_from)
      class(maugis_t), intent(in) :: self
      !> One of `..._along`: the quantity that is to have the value.
      integer, intent(in) :: quantity
      !> The value to be met, reduced.
      real(dp), intent(in) :: value
      !> Position where the part of the curve ends.
      real(dp), intent(in) :: high
      !> Does the quantity have the value only once there? Otherwise only the neighbourhood of the start is looked at.
      logical, intent(in) :: is_alone
      !> In: a neighbour, or a new one with a position to start from. Out: the contact, with `is_found` and `is_converged`.
      type(sphere_contact_t), intent(inout) :: contact
      !> Position where the part begins, if the quantity rises along it; if absent, it falls from the largest contact on.
      real(dp), intent(in), optional :: rises_from
      type(curve_equation_t) :: equation
      type(dugdale_point_t) :: point
      real(dp) :: excess, slope, step, low
      integer :: iteration
      logical :: does_rise

      equation = curve_equation_t(self%lambda, self%ratio, value, quantity)
      does_rise = present(rises_from)
      ! the largest contact is far from all starts
      low = -huge(low)
      if (does_rise) low = rises_from
      contact%is_converged = .false.
      step = 0
      if (abs(contact%slope) > 0) then
         ! the tangent at the neighbour has been found with it
         step = -equation%excess_of(contact%radius, contact%load, contact%approach)/contact%slope
         if (contact%position + step > low .and. contact%position + step < high .and. abs(step) < longest_step) &
            & contact%position = contact%position + step
         contact%slope = 0
      end if
      do iteration = 1, max_plain_steps
         call get_curve_point(self%lambda, self%ratio, contact%position, point)
         call equation%compare(point, excess, slope)
         if (.not. abs(slope) > 0 .or. (slope > 0 .neqv. does_rise)) exit
         step = -excess/slope
         if (.not. (contact%position + step > low .and. contact%position + step < high .and. abs(step) < longest_step)) exit
         contact%position = contact%position + step
         contact%is_converged = abs(step) < close_enough
         if (contact%is_converged) exit
      end do
      if (contact%is_converged) then
         ! the last step is so small that the tangent is exact
         call read_point(point, step, contact, quantity)
         contact%slope = slope
      else if (is_alone) then
         if (.not. does_rise) low = start_of(self)
         call find_root(equation, low, high, does_rise, contact%position, contact%is_converged, close_enough)
         call get_curve_point(self%lambda, self%ratio, contact%position, point)
         call read_point(point, 0.0_dp, contact, quantity)
      end if
      if (quantity == load_along) contact%load = value
      if (quantity == approach_along) contact%approach = value
   end subroutine go_to

   !> The position of the largest contact there is.
   pure real(dp) function start_of(self)
      class(maugis_t), intent(in) :: self

      start_of = guess_position(self%lambda, self%ratio, largest_radius)
   end function start_of

   !> The contact a small step from a point of the curve.
   pure subroutine read_point(point, step, contact, quantity)
      type(dugdale_point_t), intent(in) :: point
      !> Change of the position from this point, so small that the curve is straight.
      real(dp), intent(in) :: step
      !> Receives the radii, load, approach and stability of the state; the rest stays.
      type(sphere_contact_t), intent(inout) :: contact
      !> One of `..._along`: what is prescribed. The contact is stable where load or approach fall along the curve.
      integer, intent(in) :: quantity

      contact%is_found = .true.
      contact%radius = point%radius + point%radius_slope*step
      contact%adhesion_radius = point%adhesion_radius + point%adhesion_radius_slope*step
      contact%load = point%load + point%load_slope*step
      contact%approach = point%approach + point%approach_slope*step
      contact%is_stable = merge(point%approach_slope, point%load_slope, quantity == approach_along) < 0
   end subroutine read_point

   !> The state without contact whose adhesion reaches a radius.
   pure subroutine go_apart(self, radius, contact)
      class(maugis_t), intent(in) :: self
      !> Radius c of adhesion, reduced, >= 0.
      real(dp), intent(in) :: radius
      !> Receives the state, with contact radius 0.
      type(sphere_contact_t), intent(inout) :: contact

      contact = sphere_contact_t()
      contact%is_found = .true.
      contact%adhesion_radius = radius
      call get_disc(self%lambda, self%ratio, radius, contact%load, contact%approach)
   end subroutine go_apart

   !> Value and slope of the equation. Radii are compared by their logarithms, along which the curve is nearly straight.
   pure subroutine evaluate(self, x, value, slope)
      class(curve_equation_t), intent(in) :: self
      !> Position on the curve.
      real(dp), intent(in) :: x
      !> Quantity less its given value, or the slope of the quantity.
      real(dp), intent(out) :: value
      !> Derivative of the value by the position.
      real(dp), intent(out) :: slope
      type(dugdale_point_t) :: point, next

      call get_curve_point(self%lambda, self%ratio, x, point)
      if (self%is_slope) then
         call get_curve_point(self%lambda, self%ratio, x + small_step, next)
         value = merge(point%approach_slope, point%load_slope, self%quantity == approach_along)
         slope = (merge(next%approach_slope, next%load_slope, self%quantity == approach_along) - value)/small_step
      else
         call self%compare(point, value, slope)
      end if
   end subroutine evaluate

   !> A quantity at a point less the given value, and its slope. Radii are compared by their logarithms, along which the
   !> curve is nearly straight.
   pure subroutine compare(self, point, value, slope)
      class(curve_equation_t), intent(in) :: self
      type(dugdale_point_t), intent(in) :: point
      !> Quantity at the point less its given value.
      real(dp), intent(out) :: value
      real(dp), intent(out) :: slope

      value = self%excess_of(point%radius, point%load, point%approach)
      select case (self%quantity)
      case (radius_along)
         slope = point%radius_slope/point%radius
      case (load_along)
         slope = point%load_slope
      case default
         slope = point%approach_slope
      end select
   end subroutine compare

   !> One of three quantities less the given value.
   pure real(dp) function excess_of(self, radius, load, approach) result(excess)
      class(curve_equation_t), intent(in) :: self
      !> Radius a of the contact, reduced; > 0 where radii are compared.
      real(dp), intent(in) :: radius
      !> Load P of the contact, reduced.
      real(dp), intent(in) :: load
      !> Approach delta of the contact, reduced.
      real(dp), intent(in) :: approach

      select case (self%quantity)
      case (radius_along)
         excess = log(radius/self%given)
      case (load_along)
         excess = load - self%given
      case default
         excess = approach - self%given
      end select
   end function excess_of

end module adfric_round_sphere_maugis_dugdale
