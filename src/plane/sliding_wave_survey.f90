! SPDX-License-Identifier: GPL-3.0-or-later
!> What is found by going over the profiles of a sliding wave: the largest pressure and gap, the work of the pressure, and how well
!> the conditions of contact hold. Units and symbols as in `sliding_wave`.
!>
!> The work of the pressure on the wave, per area and distance, is its tangential stress
!>
!>     T = -mean(p h_x) = int p sin x dx/(2 pi)
!>
!> The closed form of T never meets the pressure at a position, so the two of them check each other. The integral is a sum over
!> positions that are as dense in each decade of the distance from an edge: with short relaxation lengths the pressure has layers
!> there, of all sizes.
module adfric_plane_sliding_wave_survey
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_numerics_double_exponential, only: integrand_t
   use adfric_numerics_largest_value, only: find_largest_value
   use adfric_plane_contact_conditions, only: largest_violation
   use adfric_plane_sliding_solid, only: sliding_solid_t
   use adfric_plane_sliding_wave, only: wave_contact_t
   use adfric_plane_sliding_wave_profile, only: signed_pressure, signed_gap
   implicit none (type, external)
   private
   public :: wave_survey_t, survey_wave

   !> Positions in the contact, and in the gap, at which the conditions of contact are checked.
   integer, parameter :: n_positions = 8
   !> Distance of the positions of the sum, in the logarithm of the ratio of the paths to both edges. A layer e^(-s/a) leaves an
   !> error of e^(-pi^2/step).
   real(dp), parameter :: step = 0.3_dp
   !> Where the positions end, in that logarithm, if the solid is elastic: the load beyond is 1e-15 of the whole.
   real(dp), parameter :: last_position = 24

   !> What is found.
   type :: wave_survey_t
      !> Largest pressure [p*], and largest gap [D].
      real(dp) :: peak_pressure = 0, largest_gap = 0
      !> Tangential stress from the pressure [k D p*].
      real(dp) :: friction = 0
      !> Largest violation of g >= 0, p >= 0 [p*, D].
      real(dp) :: violation = 0
   end type wave_survey_t

   !> The pressure in the contact, along the path from its trailing edge; the gap beyond it, from its leading edge.
   type, extends(integrand_t) :: wave_position_t
      !> The solid.
      type(sliding_solid_t) :: solid
      !> The contact.
      type(wave_contact_t) :: contact
      !> Where the path begins.
      real(dp) :: first = 0
      !> Is it the gap?
      logical :: is_gap = .false.
   contains
      procedure :: evaluate
   end type wave_position_t

contains

   !> Go over the profiles of a contact.
   pure subroutine survey_wave(solid, contact, survey)
      !> The solid, with lengths in 1/k.
      type(sliding_solid_t), intent(in) :: solid
      type(wave_contact_t), intent(in) :: contact
      !> What is found; NaN where a profile is not.
      type(wave_survey_t), intent(out) :: survey
      type(wave_position_t) :: position
      real(dp) :: width

      if (contact%is_full) then
         ! p = q + |E| cos(x - d)
         survey%peak_pressure = contact%mean_pressure + contact%stiffness
         survey%friction = contact%stiffness*sin(contact%shift%shift)/2
         return
      else if (.not. contact%half_width > 0) then
         survey%largest_gap = 2 - contact%penetration
         return
      end if
      width = 2*contact%half_width
      position = wave_position_t(solid, contact, contact%shift%shift - contact%half_width)
      call find_largest_value(position, width, survey%peak_pressure)
      call add_violations(position, width, survey%violation)
      survey%friction = work_of_pressure(solid, contact, width)
      position = wave_position_t(solid, contact, contact%shift%shift + contact%half_width, is_gap=.true.)
      width = 4*atan2(contact%cosine, contact%sine)
      call find_largest_value(position, width, survey%largest_gap)
      call add_violations(position, width, survey%violation)
   end subroutine survey_wave

   !> Work of the pressure on the wave, per area and distance [k D p*].
   pure real(dp) function work_of_pressure(solid, contact, width) result(work)
      !> The solid, with lengths in 1/k.
      type(sliding_solid_t), intent(in) :: solid
      type(wave_contact_t), intent(in) :: contact
      !> Its width, > 0.
      real(dp), intent(in) :: width
      real(dp) :: ratio, paths(2), x
      integer :: i, n_steps

      work = 0
      ! a glass carries as many times the load on the path s from an edge, which is in proportion to s^(3/2)
      n_steps = nint((last_position + 2*log(solid%instantaneous_ratio())/3)/step)
      do i = -n_steps, n_steps
         ratio = exp(-step*abs(i))
         ! to the nearer edge and to the other one
         paths = width*[ratio, 1.0_dp]/(1 + ratio)
         if (i > 0) paths = paths([2, 1])
         x = contact%shift%shift + (paths(1) - paths(2))/2
         work = work + step*(paths(1)*paths(2)/width)*signed_pressure(solid, contact, x)*sin(x)
      end do
      work = work/two_pi
   end function work_of_pressure

   !> Take violations of the conditions of contact into account. The gap in the contact and the pressure beside it are 0.
   pure subroutine add_violations(position, length, violation)
      type(wave_position_t), intent(in) :: position
      !> Width of the contact, or of the gap.
      real(dp), intent(in) :: length
      !> The largest violation so far.
      real(dp), intent(inout) :: violation
      real(dp) :: values(n_positions), nothing(n_positions)
      integer :: i

      nothing = 0
      values = [(position%evaluate(length*(i - 0.5_dp)/n_positions, length*(n_positions + 0.5_dp - i)/n_positions), i=1, &
         & n_positions)]
      violation = max(violation, largest_violation(values, nothing, 1.0_dp, 1.0_dp))
   end subroutine add_violations

   !> See `integrand_t`.
   pure real(dp) function evaluate(self, from_left, from_right) result(value)
      class(wave_position_t), intent(in) :: self
      !> Path from the edge where it begins.
      real(dp), intent(in) :: from_left
      !> Way to the other edge.
      real(dp), intent(in) :: from_right
      real(dp) :: x

      x = self%first + from_left
      if (self%is_gap) then
         value = signed_gap(self%solid, self%contact, x)
      else
         value = signed_pressure(self%solid, self%contact, x)
      end if
      associate (unused => from_right)
      end associate
   end function evaluate

end module adfric_plane_sliding_wave_survey
