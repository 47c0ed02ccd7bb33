! SPDX-License-Identifier: GPL-3.0-or-later
!> Profiles of punches that are no polynomials.
module trial_profiles
   use adfric_base_kinds, only: dp
   use adfric_plane_rigid_punch, only: punch_profile_t
   implicit none (type, external)
   private
   public :: hyperbola_t

   !> z = sqrt(1 + x^2) - 1.
   type, extends(punch_profile_t) :: hyperbola_t
   contains
      procedure :: height
      procedure :: slope
   end type hyperbola_t

contains

   elemental real(dp) function height(self, x)
      class(hyperbola_t), intent(in) :: self
      real(dp), intent(in) :: x

      height = x*x/(1 + sqrt(1 + x*x))
      associate (unused => self)
      end associate
   end function height

   elemental real(dp) function slope(self, x)
      class(hyperbola_t), intent(in) :: self
      real(dp), intent(in) :: x

      slope = x/sqrt(1 + x*x)
      associate (unused => self)
      end associate
   end function slope

end module trial_profiles
