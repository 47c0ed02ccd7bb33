! SPDX-License-Identifier: GPL-3.0-or-later
!> Maugis's theory in quadruple precision, for comparison only: J 2.12-2.14 in m = c/a with X = 1, evaluated at
!> y = ln mu, mu = sqrt(m^2 - 1). Radius, load and approach are found by bisection and then by Newton's method.
module quad_dugdale
   use, intrinsic :: iso_fortran_env, only: qp => real128
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: qp, state_t, of_radius, of_load, of_approach, pull_off_of_load, pull_off_of_approach, touching_approach, &
      relative, least_value

   real(qp), parameter :: pi = 3.14159265358979323846264338327950288_qp
   !> No state that is asked for lies beyond +- this, and no step that remains is longer than the other.
   real(qp), parameter :: farthest = 80, close_enough = 1.0e-25_qp
   integer, parameter :: coarse_halvings = 30, all_halvings = 130, newton_steps = 6

   !> Relative errors are those of the larger of a value and this.
   real(dp), parameter :: least_value = 0.1_dp

   !> What is held: its place in `state_t`.
   integer, parameter :: radius = 1, load = 2, approach = 3

   !> A state, and its changes with y: radius, load, approach.
   type :: state_t
      real(qp) :: value(3) = 0, slope(3) = 0
   end type state_t

contains

   !> The state at a position.
   pure type(state_t) function state_at(lambda, y) result(state)
      real(qp), intent(in) :: lambda, y
      real(qp) :: mu, m, angle, aa, bb, aa_slope, bb_slope, a, a_slope, pull, pull_slope

      mu = exp(y)
      m = sqrt(1 + mu*mu)
      angle = atan(mu)
      aa = lambda*area_term(mu)/2
      bb = 4*lambda**2*(mu*angle - mu*mu/(1 + m))/3
      ! A a^2 + B a = 1 (J 2.12), and its change with mu
      a = 2/(bb + sqrt(bb*bb + 4*aa))
      aa_slope = lambda*(mu*angle + (mu/m)**2)
      bb_slope = 4*lambda**2*(angle - mu**3/(m*m*(1 + m)))/3
      a_slope = -(aa_slope*a + bb_slope)*a/(2*aa*a + bb)
      pull = mu + m*m*angle
      pull_slope = 2 + 2*mu*angle
      state%value = [a, a**3 - lambda*a**2*pull, a**2 - 4*lambda*a*mu/3]
      state%slope = mu*[a_slope, (3*a**2 - 2*lambda*a*pull)*a_slope - lambda*a**2*pull_slope, &
         2*a*a_slope - 4*lambda*(a_slope*mu + a)/3]
   end function state_at

   !> (m^2 - 2) arccos(1/m) + sqrt(m^2 - 1), by its series where the difference would cost digits.
   pure real(qp) function area_term(mu)
      real(qp), intent(in) :: mu
      real(qp) :: power
      integer :: k

      area_term = mu - (1 - mu)*(1 + mu)*atan(mu)
      if (mu > 0.25_qp) return
      area_term = 0
      power = mu**3
      do k = 1, 30
         area_term = area_term + power*4*k/(4*k*k - 1)
         power = -power*mu*mu
      end do
   end function area_term

   !> Where a quantity falls through a value, from the largest contact to a position.
   type(state_t) function find(lambda, quantity, given, last) result(state)
      real(dp), intent(in) :: lambda, given
      integer, intent(in) :: quantity
      real(qp), intent(in) :: last
      real(qp) :: left, right, y, step
      integer :: k

      left = -farthest
      right = last
      do k = 1, coarse_halvings
         y = (left + right)/2
         state = state_at(real(lambda, qp), y)
         if (state%value(quantity) > given) then
            left = y
         else
            right = y
         end if
      end do
      do k = 1, newton_steps
         step = (given - state%value(quantity))/state%slope(quantity)
         y = y + step
         state = state_at(real(lambda, qp), y)
      end do
      if (.not. abs(step) < close_enough) error stop 'quad_dugdale: no convergence'
   end function find

   !> The position where load or approach is least. Far beyond it the slope is lost in round-off, so that the search ends
   !> where the radius is a small part of lambda; a curve without such a position is followed as far as that.
   real(qp) function fold_of(lambda, quantity) result(y)
      real(dp), intent(in) :: lambda
      integer, intent(in) :: quantity
      real(qp) :: left, right
      type(state_t) :: state
      integer :: k

      left = -farthest
      right = 8 + max(log(disc_radius(real(lambda, qp))/min(lambda, 1.0_dp)), 0.0_qp)
      do k = 1, all_halvings
         y = (left + right)/2
         state = state_at(real(lambda, qp), y)
         if (state%slope(quantity) < 0) then
            left = y
         else
            right = y
         end if
      end do
   end function fold_of

   !> The state of a radius.
   type(state_t) function of_radius(lambda, given) result(state)
      real(dp), intent(in) :: lambda, given

      state = find(lambda, radius, given, farthest)
   end function of_radius

   !> The stable state of a load.
   type(state_t) function of_load(lambda, given) result(state)
      real(dp), intent(in) :: lambda, given

      state = find(lambda, load, given, fold_of(lambda, load))
   end function of_load

   !> The stable state of an approach; with contact.
   type(state_t) function of_approach(lambda, given) result(state)
      real(dp), intent(in) :: lambda, given

      state = find(lambda, approach, given, fold_of(lambda, approach))
   end function of_approach

   !> Where a pulled sphere comes off.
   type(state_t) function pull_off_of_load(lambda) result(state)
      real(dp), intent(in) :: lambda

      state = state_at(real(lambda, qp), fold_of(lambda, load))
   end function pull_off_of_load

   !> Where a sphere that is moved away comes off; for small lambda this is without contact.
   type(state_t) function pull_off_of_approach(lambda) result(state)
      real(dp), intent(in) :: lambda
      real(qp) :: l, c

      l = lambda
      c = 8*l/(3*pi)
      if (c < disc_radius(l)) then
         state%value = [0.0_qp, -pi*l*c**2/2, c**2/2 - 8*l*c/(3*pi) - 2/(pi*l)]
      else
         state = state_at(l, fold_of(lambda, approach))
      end if
   end function pull_off_of_approach

   !> Approach of a point contact.
   real(dp) function touching_approach(lambda) result(value)
      real(dp), intent(in) :: lambda
      real(qp) :: l, c

      l = lambda
      c = disc_radius(l)
      value = real(c**2/2 - 8*l*c/(3*pi) - 2/(pi*l), dp)
   end function touching_approach

   !> Radius of adhesion of a point contact.
   pure real(qp) function disc_radius(l) result(c)
      real(qp), intent(in) :: l
      real(qp) :: bb

      bb = 4*l**2*(pi/2 - 1)/3
      c = 2/(bb + sqrt(bb*bb + pi*l))
   end function disc_radius

   !> Error of a value, relative to the larger of the value and 0.1.
   pure real(dp) function relative(value, truth)
      real(dp), intent(in) :: value
      real(qp), intent(in) :: truth

      relative = real(abs(value - truth)/max(abs(truth), real(least_value, qp)), dp)
   end function relative

end module quad_dugdale
