! SPDX-License-Identifier: GPL-3.0-or-later
!> Hertz's contact, no adhesion: P = a^3, delta = a^2 (J 2.1, 2.2). It is that of DMT without its force of adhesion.
module adfric_round_sphere_hertz
   use adfric_base_kinds, only: dp
   use adfric_round_sphere_dmt, only: dmt_t
   implicit none (type, external)
   private
   public :: hertz_t

   !> Hertz's theory: that of DMT with a `pull` of 0.
   type, extends(dmt_t) :: hertz_t
   contains
      procedure :: pull
   end type hertz_t

contains

   !> No force, whatever is left of adhesion.
   pure real(dp) function pull(self)
      !> The theory; its X has no part in the result.
      class(hertz_t), intent(in) :: self

      pull = 0
      associate (unused => self)
      end associate
   end function pull

end module adfric_round_sphere_hertz
