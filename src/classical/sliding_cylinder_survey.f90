!> What is found by going over the profiles of a sliding cylinder: the largest pressure, the work of the pressure, and how well the
!> conditions of contact hold. Units and symbols as in `sliding_cylinder`.
!>
!> The work of the pressure on the cylinder, per length and distance, is its tangential force
!>
!>     T = -int p h_x dx = int p x dx/R
!>
!> The closed form of T never meets the pressure at a place, so the two of them check each other; so do the integral of the
!> pressure and the load.
module adfric_classical_sliding_cylinder_survey
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_numerics_double_exponential, only: integrand_t, integrate
   use adfric_numerics_largest_value, only: find_largest_value
   use adfric_classical_contact_conditions, only: largest_violation
   use adfric_classical_sliding_cylinder, only: cylinder_contact_t
   use adfric_classical_sliding_cylinder_profile, only: signed_cylinder_pressure, signed_cylinder_gap
   implicit none (type, external)
   private
   public :: cylinder_survey_t, survey_cylinder

   !> Places in the contact, and on each side of it, at which the conditions of contact are checked; how far they reach, in w.
   integer, parameter :: n_places = 8
   real(dp), parameter :: reach = 2

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

   !> The pressure in the contact, along the way from its trailing edge.
   type, extends(integrand_t) :: place_t
      !> The contact.
      type(cylinder_contact_t) :: contact
      !> Is the pressure multiplied by x?
      logical :: is_work = .false.
   contains
      procedure :: evaluate
   end type place_t

contains

   !> Go over the profiles of a contact.
   pure subroutine survey_cylinder(contact, survey)
      !> The contact.
      type(cylinder_contact_t), intent(in) :: contact
      !> What is found; NaN where a profile is not.
      type(cylinder_survey_t), intent(out) :: survey
      !> Width of the contact [w].
      real(dp), parameter :: width = 2
      type(place_t) :: place
      real(dp) :: load, moment
      logical :: is_load, is_moment

      ! no load makes no contact
      if (.not. contact%half_width > 0) return
      place%contact = contact
      call find_largest_value(place, width, survey%peak_pressure)
      call integrate(place, width, load, is_load)
      place%is_work = .true.
      call integrate(place, width, moment, is_moment)
      if (.not. (is_load .and. is_moment)) load = not_a_number()
      survey%friction_ratio = moment/load
      survey%violation = max(largest_profile_violation(contact, survey%peak_pressure), abs(load/(pi/2*contact%load_ratio) - 1))
   end subroutine survey_cylinder

   !> The largest violation of the conditions of contact. The gap in the contact and the pressure beside it are 0.
   pure real(dp) function largest_profile_violation(contact, peak_pressure) result(violation)
      !> The contact.
      type(cylinder_contact_t), intent(in) :: contact
      !> Its largest pressure [E0 w/(2 R)], > 0.
      real(dp), intent(in) :: peak_pressure
      real(dp) :: pressures(n_places), gaps(2*n_places), nothing(2*n_places)
      integer :: i

      do i = 1, n_places
         pressures(i) = signed_cylinder_pressure(contact, (2*i - 1.0_dp)/n_places, (2*(n_places - i) + 1.0_dp)/n_places)
         gaps(i) = signed_cylinder_gap(contact, reach*(i - 0.5_dp)/n_places, .true.)
         gaps(n_places + i) = signed_cylinder_gap(contact, reach*(i - 0.5_dp)/n_places, .false.)
      end do
      nothing = 0
      violation = max(largest_violation(pressures, nothing(:n_places), peak_pressure, 1.0_dp), &
         & largest_violation(nothing, gaps, 1.0_dp, 1.0_dp))
   end function largest_profile_violation

   !> See `integrand_t`.
   pure real(dp) function evaluate(self, from_left, from_right) result(value)
      !> The contact.
      class(place_t), intent(in) :: self
      !> Distances from the trailing and the leading edge.
      real(dp), intent(in) :: from_left, from_right

      value = signed_cylinder_pressure(self%contact, from_left, from_right)
      if (self%is_work) value = value*(self%contact%shift%shift + (from_left - from_right)/2)
   end function evaluate

end module adfric_classical_sliding_cylinder_survey
