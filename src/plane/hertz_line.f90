! SPDX-License-Identifier: GPL-3.0-or-later
!> Hertz's contact of parallel cylinders, per length: a = sqrt(4 P R/(pi E*)), p0 = 2 P/(pi a) (Johnson, Contact Mechanics, 1985,
!> 4.2). The approach of a half-plane is undefined: delta = a^2/R is that of the point contact.
module adfric_plane_hertz_line
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_numerics_hyperbolic, only: sinh_minus_argument
   implicit none (type, external)
   private
   public :: line_contact_t, line_of_load, line_pressure, line_gap, line_misfit

   !> A contact.
   type :: line_contact_t
      !> Half-width a [m], largest pressure p0 [Pa].
      real(dp) :: half_width = 0, peak_pressure = 0
      !> R [m].
      real(dp) :: radius = 1
   end type line_contact_t

contains

   !> Contact under a load P >= 0 [N/m].
   pure type(line_contact_t) function line_of_load(radius, modulus, load) result(self)
      !> Radius R [m], 1/R = 1/R1 + 1/R2.
      real(dp), intent(in) :: radius
      !> Contact modulus E* [Pa].
      real(dp), intent(in) :: modulus
      !> Load P per length [N/m], >= 0.
      real(dp), intent(in) :: load

      self%radius = radius
      self%half_width = sqrt(4*radius/pi*(load/modulus))
      self%peak_pressure = modulus*self%half_width/(2*radius)
   end function line_of_load

   !> Share of the load by which half-width and pressure miss it; 0 but for round-off. The pressure is the one that closes the gap.
   pure real(dp) function line_misfit(self, load) result(misfit)
      !> Contact whose half-width and largest pressure are compared with the load.
      type(line_contact_t), intent(in) :: self
      !> Load P per length [N/m], >= 0.
      real(dp), intent(in) :: load

      misfit = 0
      if (load > 0) misfit = abs(pi/2*self%peak_pressure*self%half_width - load)/load
   end function line_misfit

   !> Pressure at x; 0 outside.
   elemental real(dp) function line_pressure(self, x)
      type(line_contact_t), intent(in) :: self
      !> Coordinate across the contact, from its middle [m].
      real(dp), intent(in) :: x

      line_pressure = 0
      if (abs(x) < self%half_width) line_pressure = self%peak_pressure &
         & *sqrt((1 - abs(x)/self%half_width)*(1 + abs(x)/self%half_width))
   end function line_pressure

   !> Gap at x; 0 in contact: (a^2/4R)(sinh 2v - 2v) with |x| = a cosh v.
   elemental real(dp) function line_gap(self, x)
      type(line_contact_t), intent(in) :: self
      !> Coordinate across the contact, from its middle [m].
      real(dp), intent(in) :: x
      real(dp) :: e

      line_gap = 0
      if (abs(x) <= self%half_width) return
      e = sqrt((abs(x) - self%half_width)*(abs(x) + self%half_width))
      if (e < self%half_width/epsilon(e)) then
         line_gap = self%half_width**2/(4*self%radius)*sinh_minus_argument(2*asinh(e/self%half_width))
      else
         line_gap = x**2/(2*self%radius)
      end if
   end function line_gap

end module adfric_plane_hertz_line
