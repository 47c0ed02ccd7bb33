! SPDX-License-Identifier: GPL-3.0-or-later
!> A rigid punch on its contact: the pressure under it, the surface beside it, and the gap.
module adfric_plane_punch_state
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_plane_coupled_wedge, only: coupled_wedge_t
   use adfric_plane_punch_profiles, only: polynomial_t, wedge_pressure, wedge_gap
   use adfric_plane_rigid_punch, only: punch_contact_t
   use adfric_describe_pointwise, only: point_state_t
   implicit none (type, external)
   private
   public :: punch_state_t

   !> A punch on its contact: for the wedge `contact` holds the flat part only.
   type, extends(point_state_t) :: punch_state_t
      !> Shape of the punch.
      type(polynomial_t) :: profile
      !> Its contact.
      type(punch_contact_t) :: contact
      !> Slope of a wedge; 0 for other kinds.
      real(dp) :: slope = 0
      !> Half-width of the face; enormous without an end.
      real(dp) :: face = huge(1.0_dp)
      !> A wedge whose shear stress moves the contact.
      type(coupled_wedge_t) :: coupled
   contains
      procedure :: pressure
      procedure :: level
      procedure :: gap
   end type punch_state_t

contains

   !> Pressure at x.
   elemental real(dp) function pressure(self, x)
      class(punch_state_t), intent(in) :: self
      !> Coordinate along the surface, from the middle of the punch [m].
      real(dp), intent(in) :: x

      pressure = self%contact%pressure(x)
      if (self%slope > 0 .and. abs(x) <= self%contact%half_width) pressure = pressure &
         & + wedge_pressure(self%contact%modulus, self%slope, self%contact%half_width, x)
   end function pressure

   !> How far the surface lies above its level under the middle of the punch.
   elemental real(dp) function level(self, x)
      class(punch_state_t), intent(in) :: self
      !> Coordinate along the surface, from the middle of the punch [m].
      real(dp), intent(in) :: x

      if (self%slope > 0) then
         level = self%slope*abs(x) - wedge_gap(self%slope, self%contact%half_width, x)
         if (abs(x) > self%contact%half_width) level = level + self%contact%rise(x)
      else
         level = self%profile%height(self%contact%half_width) + self%contact%rise(x)
      end if
   end function level

   !> Gap at x, where there is a face.
   elemental real(dp) function gap(self, x)
      class(punch_state_t), intent(in) :: self
      !> Coordinate along the surface, from the middle of the punch [m].
      real(dp), intent(in) :: x

      if (abs(x) > self%face) then
         gap = not_a_number()
      else if (self%slope > 0) then
         gap = wedge_gap(self%slope, self%contact%half_width, x)
      else
         gap = self%profile%height(x) - self%level(x)
      end if
   end function gap

end module adfric_plane_punch_state
