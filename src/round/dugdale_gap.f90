! SPDX-License-Identifier: GPL-3.0-or-later
!> What a zone of adhesion a < r < c of a stress S adds to the gap beside a contact:
!>
!>     (4 S/pi) {int [s - sqrt(c^2 - x^2)]/sqrt(r^2 - x^2) dx (a < x < min(r, c)) + s arccos(c/r) (r > c)},  s = sqrt(c^2 - a^2)
!>
!> and what a disc of it takes away where nothing touches:
!>
!>     (4 S/pi) int sqrt(c^2 - x^2)/sqrt(r^2 - x^2) dx,  0 < x < min(r, c)
module adfric_round_dugdale_gap
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, half_pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_numerics_double_exponential, only: integrand_t, integrate
   implicit none (type, external)
   private
   public :: zone_gap, disc_gap

   !> One of the two integrands.
   type, extends(integrand_t) :: zone_integrand_t
      !> Radii of contact and of adhesion, and the distance from the axis.
      real(dp) :: a = 0, c = 1, r = 1
      !> Is it that of a disc?
      logical :: is_disc = .false.
   contains
      procedure :: evaluate
   end type zone_integrand_t

contains

   !> What a zone of adhesion adds to the gap; NaN if the integral does not come to rest.
   pure real(dp) function zone_gap(stress, a, c, r) result(gap)
      !> Stress S, reduced, > 0.
      real(dp), intent(in) :: stress
      !> Radii of contact and of adhesion, 0 <= a < c.
      real(dp), intent(in) :: a, c
      !> Distance from the axis, > a.
      real(dp), intent(in) :: r
      logical :: is_converged

      call integrate(zone_integrand_t(a, c, r, .false.), min(r, c) - a, gap, is_converged)
      if (r > c) gap = gap + sqrt((c - a)*(c + a))*atan2(sqrt((r - c)*(r + c)), c)
      gap = 4*stress/pi*gap
      if (.not. is_converged) gap = not_a_number()
   end function zone_gap

   !> What a disc of adhesion takes from the gap; NaN if the integral does not come to rest.
   pure real(dp) function disc_gap(stress, c, r) result(gap)
      !> Stress S, reduced, > 0.
      real(dp), intent(in) :: stress
      !> Radius of the disc, > 0.
      real(dp), intent(in) :: c
      !> Distance from the axis, >= 0.
      real(dp), intent(in) :: r
      logical :: is_converged

      is_converged = .true.
      gap = half_pi*c
      if (r > 0) call integrate(zone_integrand_t(0.0_dp, c, r, .true.), min(r, c), gap, is_converged)
      gap = 4*stress/pi*gap
      if (.not. is_converged) gap = not_a_number()
   end function disc_gap

   !> See `integrand_t`.
   pure real(dp) function evaluate(self, from_left, from_right)
      class(zone_integrand_t), intent(in) :: self
      !> Distances of x from a and from min(r, c), > 0.
      real(dp), intent(in) :: from_left, from_right
      real(dp) :: x, to_r, to_c, last

      last = min(self%r, self%c)
      x = self%a + from_left
      to_r = sqrt((from_right + (self%r - last))*(self%r + x))
      to_c = sqrt((from_right + (self%c - last))*(self%c + x))
      if (self%is_disc) then
         evaluate = to_c/to_r
      else
         evaluate = from_left*(x + self%a)/((sqrt((self%c - self%a)*(self%c + self%a)) + to_c)*to_r)
      end if
   end function evaluate

end module adfric_round_dugdale_gap
