! SPDX-License-Identifier: GPL-3.0-or-later
!> The kinds of shapes with a corner (see `adfric_round_corner_shape`), and their depth g beyond it.
module adfric_round_corner_kinds
   use adfric_base_kinds, only: dp
   use adfric_round_closed_annulus, only: less_arctan
   implicit none (type, external)
   private
   public :: flat_face, flat_cone, flat_paraboloid, rounded_punch, rounded_cone, depth_beyond

   !> The kinds; a flat face ends where it ends.
   integer, parameter :: flat_face = 0, flat_cone = 1, flat_paraboloid = 2, rounded_punch = 3, rounded_cone = 4

contains

   !> g beyond the corner.
   pure real(dp) function depth_beyond(kind, v, a) result(depth)
      !> One of the kinds of this file.
      integer, intent(in) :: kind
      !> v = sqrt(a^2 - 1), >= 0.
      real(dp), intent(in) :: v
      !> Radius a of contact.
      real(dp), intent(in) :: a

      select case (kind)
      case (flat_cone)
         depth = a*atan(v)
      case (flat_paraboloid)
         depth = a*v
      case (rounded_punch)
         depth = a*less_arctan(v)
      case (rounded_cone)
         depth = a*atan(v) + a/(a + v)
      case default
         depth = 0
      end select
   end function depth_beyond

end module adfric_round_corner_kinds
