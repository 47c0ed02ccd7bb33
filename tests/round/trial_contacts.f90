! SPDX-License-Identifier: GPL-3.0-or-later
!> Contacts of every theory with their profiles.
module trial_contacts
   use adfric_base_kinds, only: dp
   use adfric_round_sphere_contact, only: sphere_contact_t
   use adfric_round_sphere_dmt, only: dmt_t
   use adfric_round_sphere_dugdale_curve, only: dugdale_point_t, get_curve_point, get_disc
   use adfric_round_sphere_hertz, only: hertz_t
   use adfric_round_sphere_jkr, only: jkr_t
   use adfric_round_sphere_maugis_dugdale, only: maugis_t
   use adfric_round_sphere_profiles, only: contact_profile_t, new_profile
   implicit none (type, external)
   private
   public :: curve_contact, disc_contact, set_profile, solve_hertz, solve_dmt, solve_jkr

contains

   !> Contact of Maugis's theory at a position on its curve.
   type(sphere_contact_t) function curve_contact(lambda, ratio, position) result(contact)
      real(dp), intent(in) :: lambda, ratio, position
      type(dugdale_point_t) :: point

      call get_curve_point(lambda, ratio, position, point)
      contact = sphere_contact_t()
      contact%is_found = .true.
      contact%radius = point%radius
      contact%adhesion_radius = point%adhesion_radius
      contact%load = point%load
      contact%approach = point%approach
      contact%position = position
   end function curve_contact

   !> State without contact whose adhesion reaches a radius.
   type(sphere_contact_t) function disc_contact(lambda, ratio, radius) result(contact)
      real(dp), intent(in) :: lambda, ratio, radius

      contact = sphere_contact_t()
      contact%is_found = .true.
      contact%adhesion_radius = radius
      call get_disc(lambda, ratio, radius, contact%load, contact%approach)
   end function disc_contact

   !> Profile of a contact of Maugis's theory.
   subroutine set_profile(profile, lambda, ratio, contact)
      type(contact_profile_t), intent(out) :: profile
      real(dp), intent(in) :: lambda, ratio
      type(sphere_contact_t), intent(in) :: contact

      call new_profile(profile, maugis_t(ratio=ratio, lambda=lambda), contact)
   end subroutine set_profile

   !> Contact of a radius by the theory of Hertz, and its profile.
   subroutine solve_hertz(radius, profile, contact)
      real(dp), intent(in) :: radius
      type(contact_profile_t), intent(out) :: profile
      type(sphere_contact_t), intent(out) :: contact
      type(hertz_t) :: theory

      call theory%of_radius(radius, contact)
      call new_profile(profile, theory, contact)
   end subroutine solve_hertz

   !> Contact of a radius by the theory of DMT, and its profile.
   subroutine solve_dmt(ratio, radius, profile, contact)
      real(dp), intent(in) :: ratio, radius
      type(contact_profile_t), intent(out) :: profile
      type(sphere_contact_t), intent(out) :: contact
      type(dmt_t) :: theory

      theory%ratio = ratio
      call theory%of_radius(radius, contact)
      call new_profile(profile, theory, contact)
   end subroutine solve_dmt

   !> Contact of a radius by the theory of JKR, and its profile.
   subroutine solve_jkr(ratio, radius, profile, contact)
      real(dp), intent(in) :: ratio, radius
      type(contact_profile_t), intent(out) :: profile
      type(sphere_contact_t), intent(out) :: contact
      type(jkr_t) :: theory

      theory%ratio = ratio
      call theory%of_radius(radius, contact)
      call new_profile(profile, theory, contact)
   end subroutine solve_jkr

end module trial_contacts
