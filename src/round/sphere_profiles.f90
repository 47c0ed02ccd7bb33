! SPDX-License-Identifier: GPL-3.0-or-later
!> Pressure and gap around the axis of a contact of a sphere, for every theory: those of a paraboloid (`adfric_round_profiles`).
!>
!> Reduced variables (see `adfric_round_sphere_contact`): radii in (3 pi w R^2/4E*)^(1/3), gaps in (9 pi^2 w^2 R/16E*^2)^(1/3), the
!> unit of the approach, and pressures in (2 pi w E*^2/9R)^(1/3), 2/3 of that of E* = R = 1. In that unit Dugdale's stress sigma0 is
!> lambda, and P = pi int p r dr. The adhesion of DMT is a force from outside the contact that does not deform; it is no part of the
!> pressure, whose integral is P + 2 X.
module adfric_round_sphere_profiles
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_round_contact_state, only: contact_t
   use adfric_round_power_shape, only: new_power_shape, power_shape_t
   use adfric_round_profiles, only: gap_at, pressure_at
   use adfric_round_sphere_contact, only: sphere_contact_t, theory_t
   use adfric_round_sphere_maugis_dugdale, only: maugis_t
   use adfric_round_sphere_path, only: take_contact
   implicit none (type, external)
   private
   public :: contact_profile_t, new_profile

   !> Pressure and gap of a contact.
   type :: contact_profile_t
      private
      !> The contact; where it is not found all values are NaN.
      type(contact_t) :: contact
      !> The paraboloid, g = x^2.
      type(power_shape_t) :: shape
      !> Tension X lambda of Dugdale's law; 0 in the other theories.
      real(dp) :: tension = 0
   contains
      procedure :: pressure
      procedure :: gap
   end type contact_profile_t

contains

   !> Profile of a contact that a theory has found.
   pure subroutine new_profile(self, theory, contact)
      !> Receives all that pressure and gap need.
      type(contact_profile_t), intent(out) :: self
      !> Theory that has found the contact, one of the four.
      class(theory_t), intent(in) :: theory
      !> The contact as the theory gives it; where it is not found all values of the profile are NaN.
      type(sphere_contact_t), intent(in) :: contact

      call new_power_shape(self%shape, [2.0_dp], [1.0_dp])
      call take_contact(theory, contact, self%contact)
      select type (theory)
      type is (maugis_t)
         self%tension = theory%ratio*theory%lambda
         if (contact%adhesion_radius > 0 .or. .not. -contact%approach > 2/(pi*theory%lambda)) return
         ! beyond the range of adhesion nothing pulls
         self%tension = 0
         self%contact%stress = 0
      end select
   end subroutine new_profile

   !> Pressure at a distance r >= 0 from the axis; at r = c that of the inner side. NaN for JKR at r = a.
   elemental real(dp) function pressure(self, r)
      !> The profile of a contact; where that is not found the pressure is NaN.
      class(contact_profile_t), intent(in) :: self
      !> Distance from the axis, reduced; the pressure is NaN below 0.
      real(dp), intent(in) :: r

      pressure = not_a_number()
      if (.not. (self%contact%is_found .and. r >= 0)) return
      pressure = -self%tension
      if (self%contact%stress > 0 .and. r >= self%contact%spot%radius .and. r <= self%contact%adhesion_radius) return
      pressure = 1.5_dp*pressure_at(self%shape, self%contact, r)
   end function pressure

   !> Gap at a distance r >= 0 from the axis; 0 in contact.
   elemental real(dp) function gap(self, r)
      !> The profile of a contact; where that is not found the gap is NaN.
      class(contact_profile_t), intent(in) :: self
      !> Distance from the axis, reduced; the gap is NaN below 0.
      real(dp), intent(in) :: r

      gap = not_a_number()
      ! where two surfaces are about to touch the terms cancel; they do not overlap
      if (self%contact%is_found .and. r >= 0) gap = max(gap_at(self%shape, self%contact, r), 0.0_dp)
   end function gap

end module adfric_round_sphere_profiles
