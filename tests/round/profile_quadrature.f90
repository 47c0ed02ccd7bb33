! SPDX-License-Identifier: GPL-3.0-or-later
!> Load and gap of a profile by quadrature of its pressure alone.
module profile_quadrature
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, half_pi
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   use adfric_round_sphere_contact, only: sphere_contact_t
   use adfric_round_sphere_profiles, only: contact_profile_t
   implicit none (type, external)
   private
   public :: integrate_load, integrate_gap

   integer, parameter :: n_nodes = size(gauss_nodes)

contains

   !> pi int p r dr up to r = c, by w^2 = a^2 - r^2 and e^2 = r^2 - a^2.
   real(dp) function integrate_load(profile, contact, width) result(load)
      type(contact_profile_t), intent(in) :: profile
      type(sphere_contact_t), intent(in) :: contact
      !> Distance from the edge within which the pressure varies, > 0.
      real(dp), intent(in) :: width
      real(dp) :: a, low, high, v(n_nodes)
      integer :: k, n

      a = contact%radius
      low = min(width, a)
      v = low*(1 + gauss_nodes)/2
      load = sum(gauss_weights*profile%pressure(sqrt(a**2 - v**2))*v)*low/2
      if (low < a) then
         ! w grows by factors
         n = ceiling(log(a/low))
         do k = 1, n
            high = low*(a/low)**(1.0_dp/(n + 1 - k))
            v = (low + high + (high - low)*gauss_nodes)/2
            load = load + sum(gauss_weights*profile%pressure(sqrt(a**2 - v**2))*v)*(high - low)/2
            low = high
         end do
      end if
      if (contact%adhesion_radius > a) then
         high = sqrt((contact%adhesion_radius - a)*(contact%adhesion_radius + a))
         v = high*(1 + gauss_nodes)/2
         load = load + sum(gauss_weights*profile%pressure(sqrt(a**2 + v**2))*v)*high/2
      end if
      load = pi*load
   end function integrate_load

   !> r^2/2 - delta + (8/3 pi) int_0^r F(t)/sqrt(r^2 - t^2) dt.
   real(dp) function integrate_gap(profile, contact, r) result(gap)
      type(contact_profile_t), intent(in) :: profile
      type(sphere_contact_t), intent(in) :: contact
      real(dp), intent(in) :: r
      real(dp) :: inner, outer

      inner = min(r, contact%radius)
      outer = min(r, contact%adhesion_radius)
      gap = r**2/2 - contact%approach
      if (inner > 0) gap = gap + 8*integrate_transform(profile, contact, r, 0.0_dp, asin(inner/r), r)/(3*pi)
      if (outer > inner) gap = gap + 8*integrate_transform(profile, contact, r, asin(inner/outer), half_pi, outer)/(3*pi)
   end function integrate_gap

   !> Part of the integral of F, with t = scale sin(chi).
   real(dp) function integrate_transform(profile, contact, r, first, last, scale) result(total)
      type(contact_profile_t), intent(in) :: profile
      type(sphere_contact_t), intent(in) :: contact
      real(dp), intent(in) :: r, first, last, scale
      integer, parameter :: n_panels = 6
      real(dp) :: length, chi, weight
      integer :: panel, k

      total = 0
      length = (last - first)/n_panels
      do panel = 1, n_panels
         do k = 1, n_nodes
            chi = first + length*(panel - 1 + (1 + gauss_nodes(k))/2)
            weight = 1
            if (scale < r) weight = scale*cos(chi)/sqrt(r**2 - (scale*sin(chi))**2)
            total = total + gauss_weights(k)*length/2*weight*transform(profile, contact, scale*sin(chi))
         end do
      end do
   end function integrate_transform

   !> F(t) = int p s/sqrt(s^2 - t^2) ds from t to c.
   real(dp) function transform(profile, contact, t)
      type(contact_profile_t), intent(in) :: profile
      type(sphere_contact_t), intent(in) :: contact
      real(dp), intent(in) :: t
      real(dp) :: w, low, high, v(n_nodes)
      integer :: panel, n_panels

      transform = 0
      w = sqrt(max(0.0_dp, contact%radius**2 - t**2))
      if (w > 0) then
         ! s^2 = t^2 + w^2 cos^2 phi; without a ring of adhesion p sin phi is smooth, otherwise panels shrink towards the edge
         n_panels = merge(5, 1, contact%adhesion_radius > contact%radius)
         high = half_pi
         do panel = 1, n_panels
            low = merge(0.0_dp, high/2, panel == n_panels)
            v = (low + high + (high - low)*gauss_nodes)/2
            transform = transform + w*sum(gauss_weights*profile%pressure(sqrt(t**2 + (w*cos(v))**2))*sin(v))*(high - low)/2
            high = low
         end do
      end if
      high = sqrt(max(0.0_dp, contact%adhesion_radius**2 - t**2))
      if (high > w) then
         v = (w + high + (high - w)*gauss_nodes)/2
         transform = transform + sum(gauss_weights*profile%pressure(sqrt(t**2 + v**2)))*(high - w)/2
      end if
   end function transform

end module profile_quadrature
