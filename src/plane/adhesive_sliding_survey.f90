! SPDX-License-Identifier: GPL-3.0-or-later
!> What is found by going over the profiles of an adhesive sliding wave or cylinder: the largest pressure and gap, load and work of
!> the pressure, and how well the conditions of contact hold. The work, per area and distance, is the friction again,
!> T = mean(p sin x), or T = integral p x dx of a cylinder, from the pressure at positions instead of the far field.
module adfric_plane_adhesive_sliding_survey
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_numerics_double_exponential, only: integrand_t
   use adfric_numerics_largest_value, only: find_largest_value
   use adfric_plane_adhesive_sliding_nodes, only: nodes_t, get_nodes
   use adfric_plane_adhesive_sliding_profile, only: slide_profile_t, slide_pressure, slide_gap, slide_violation
   implicit none (type, external)
   private
   public :: slide_survey_t, survey_slide

   !> How near positions come to the edges of the contact.
   real(dp), parameter :: depth = 38

   !> What is found.
   type :: slide_survey_t
      !> Largest pressure [E0 k D] and, of a wave, gap [D].
      real(dp) :: peak_pressure = 0, largest_gap = 0
      !> Load and friction from the pressure (`slide_zones_t`).
      real(dp) :: load = 0, friction = 0
      !> Largest violation of p >= -p0 in contact, g >= d0 in the free gap and g <= d0 in zones beside a short one, over p0 and d0;
      !> 0 if there is none.
      real(dp) :: violation = 0
   end type slide_survey_t

   !> Pressure in the contact, along the path from its trailing edge; or the free gap, from its leading end.
   type, extends(integrand_t) :: slide_position_t
      !> The profile.
      type(slide_profile_t) :: profile
      !> Is it the gap?
      logical :: is_gap = .false.
   contains
      procedure :: evaluate
   end type slide_position_t

contains

   !> Go over the profiles.
   pure subroutine survey_slide(profile, survey)
      type(slide_profile_t), intent(in) :: profile
      !> What is found; NaN where a profile is not.
      type(slide_survey_t), intent(out) :: survey

      call find_largest_value(slide_position_t(profile, .false.), 2*profile%zones%half_width, survey%peak_pressure)
      if (profile%slide%is_wave) call find_largest_value(slide_position_t(profile, .true.), profile%zones%free, &
         & survey%largest_gap)
      survey%violation = max(0.0_dp, slide_violation(profile))
      call sum_pressure(profile, survey%load, survey%friction)
   end subroutine survey_slide

   !> Load and work of the pressure.
   pure subroutine sum_pressure(profile, load, work)
      type(slide_profile_t), intent(in) :: profile
      real(dp), intent(out) :: load, work
      type(nodes_t) :: nodes
      real(dp) :: shortest, share, x
      integer :: i

      associate (z => profile%zones, p0 => profile%slide%stress, is_wave => profile%slide%is_wave)
         shortest = min(z%leading, z%trailing)
         if (profile%slide%solid%n_arms > 0) shortest = min(shortest, profile%slide%solid%relaxation(1))
         call get_nodes(2*z%half_width, [shortest, shortest], depth, profile%slide%refinement, nodes)
         ! the zones, and -p0 in all of the contact
         share = 2*z%half_width + z%leading + z%trailing
         x = z%middle + (z%leading - z%trailing)/2
         load = -p0*share
         work = load*x
         if (is_wave) work = -2*p0*sin(share/2)*sin(x)
         do i = 1, size(nodes%weights)
            share = nodes%weights(i)*(slide_pressure(profile, nodes%left(i), nodes%right(i)) + p0)
            x = z%middle + (nodes%left(i) - nodes%right(i))/2
            load = load + share
            work = work + share*merge(sin(x), x, is_wave)
         end do
         if (.not. is_wave) return
         load = load/two_pi
         work = work/two_pi
      end associate
   end subroutine sum_pressure

   !> See `integrand_t`.
   pure real(dp) function evaluate(self, from_left, from_right)
      class(slide_position_t), intent(in) :: self
      !> Distances from the ends of the contact, or of the free gap, both > 0.
      real(dp), intent(in) :: from_left, from_right

      if (self%is_gap) then
         evaluate = slide_gap(self%profile, self%profile%zones%leading + from_left, .false.)
      else
         evaluate = slide_pressure(self%profile, from_left, from_right)
      end if
   end function evaluate

end module adfric_plane_adhesive_sliding_survey
