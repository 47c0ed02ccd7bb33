! SPDX-License-Identifier: GPL-3.0-or-later
!> What is found by going over the profiles of a sliding cylinder: the largest pressure, the work of the pressure, and how well the
!> conditions of contact hold. Units and symbols as in `sliding_cylinder`.
!>
!> The work of the pressure on the cylinder, per length and distance, is its tangential force
!>
!>     T = -int p h_x dx = int p x dx/R
!>
!> The closed form of T never meets the pressure at a position, so the two of them check each other; so do the integral of the
!> pressure and the load. Both integrals are sums over positions that are as dense in each decade of the distance from an edge: with
!> a short relaxation length the pressure has a layer there, and with many of them layers of all sizes.
module adfric_plane_sliding_cylinder_survey
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_numerics_double_exponential, only: integrand_t
   use adfric_numerics_largest_value, only: find_largest_value
   use adfric_plane_contact_conditions, only: largest_violation
   use adfric_plane_sliding_cylinder, only: cylinder_contact_t
   use adfric_plane_sliding_cylinder_profile, only: signed_cylinder_pressure, signed_cylinder_gap
   implicit none (type, external)
   private
   public :: cylinder_survey_t, survey_cylinder

   !> Positions in the contact, and on each side of it, at which the conditions of contact are checked; how far they reach, in w.
   integer, parameter :: n_positions = 8
   real(dp), parameter :: reach = 2

   !> Distance of the positions of the sums, in the logarithm of the ratio of the paths to both edges. A layer e^(-s/a) leaves an
   !> error of e^(-pi^2/step).
   real(dp), parameter :: step = 0.2_dp
   !> Where the positions end, in that logarithm, if the solid is elastic: the load beyond is 1e-18 of the whole.
   real(dp), parameter :: last_position = 28

   !> What is found.
   type :: cylinder_survey_t
      !> Largest pressure [E0 w/(2 R)].
      real(dp) :: peak_pressure = 0
      !> Friction coefficient from the pressure, over w/R.
      real(dp) :: friction_ratio = 0
      !> Largest violation of g >= 0, p >= 0 [largest pressure, w^2/R], or share of the load by which the integral of the pressure
      !> misses it.
      real(dp) :: violation = 0
   end type cylinder_survey_t

   !> The pressure in the contact, along the path from its trailing edge.
   type, extends(integrand_t) :: cylinder_position_t
      !> The contact.
      type(cylinder_contact_t) :: contact
   contains
      procedure :: evaluate
   end type cylinder_position_t

contains

   !> Go over the profiles of a contact.
   pure subroutine survey_cylinder(contact, survey)
      type(cylinder_contact_t), intent(in) :: contact
      !> What is found; NaN where a profile is not.
      type(cylinder_survey_t), intent(out) :: survey
      !> Width of the contact [w].
      real(dp), parameter :: width = 2
      type(cylinder_position_t) :: position
      real(dp) :: load, moment

      ! no load makes no contact
      if (.not. contact%half_width > 0) return
      position%contact = contact
      call find_largest_value(position, width, survey%peak_pressure)
      call sum_pressures(contact, load, moment)
      survey%friction_ratio = moment/load
      survey%violation = max(largest_profile_violation(contact, survey%peak_pressure), abs(load/(pi/2*contact%load_ratio) - 1))
   end subroutine survey_cylinder

   !> Load and moment of the pressure.
   pure subroutine sum_pressures(contact, load, moment)
      type(cylinder_contact_t), intent(in) :: contact
      !> int p dx and int p x dx [w E0 w/(2 R), times w].
      real(dp), intent(out) :: load, moment
      real(dp) :: ratio, paths(2), share
      integer :: i, n_steps

      load = 0
      moment = 0
      ! a glass carries as many times the load on the path s from an edge, which is in proportion to s^(3/2)
      n_steps = nint((last_position + 2*log(contact%solid%instantaneous_ratio())/3)/step)
      do i = -n_steps, n_steps
         ratio = exp(-step*abs(i))
         ! to the nearer edge and to the other one
         paths = 2*[ratio, 1.0_dp]/(1 + ratio)
         if (i > 0) paths = paths([2, 1])
         share = step*paths(1)*paths(2)/2*signed_cylinder_pressure(contact, paths(1), paths(2))
         load = load + share
         moment = moment + share*(contact%shift%shift + (paths(1) - paths(2))/2)
      end do
   end subroutine sum_pressures

   !> The largest violation of the conditions of contact. The gap in the contact and the pressure beside it are 0.
   pure real(dp) function largest_profile_violation(contact, peak_pressure) result(violation)
      type(cylinder_contact_t), intent(in) :: contact
      !> Its largest pressure [E0 w/(2 R)], > 0.
      real(dp), intent(in) :: peak_pressure
      real(dp) :: pressures(n_positions), gaps(2*n_positions), nothing(2*n_positions)
      integer :: i

      do i = 1, n_positions
         pressures(i) = signed_cylinder_pressure(contact, (2*i - 1.0_dp)/n_positions, (2*(n_positions - i) + 1.0_dp)/n_positions)
         gaps(i) = signed_cylinder_gap(contact, reach*(i - 0.5_dp)/n_positions, 1.0_dp)
         gaps(n_positions + i) = signed_cylinder_gap(contact, reach*(i - 0.5_dp)/n_positions, -1.0_dp)
      end do
      nothing = 0
      violation = max(largest_violation(pressures, nothing(:n_positions), peak_pressure, 1.0_dp), &
         & largest_violation(nothing, gaps, 1.0_dp, 1.0_dp))
   end function largest_profile_violation

   !> See `integrand_t`.
   pure real(dp) function evaluate(self, from_left, from_right) result(value)
      class(cylinder_position_t), intent(in) :: self
      !> Distances from the trailing and the leading edge.
      real(dp), intent(in) :: from_left, from_right

      value = signed_cylinder_pressure(self%contact, from_left, from_right)
   end function evaluate

end module adfric_plane_sliding_cylinder_survey
