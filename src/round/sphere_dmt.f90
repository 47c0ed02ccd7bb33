! SPDX-License-Identifier: GPL-3.0-or-later
!> The theory of Derjaguin, Muller and Toporov in Maugis's form: adhesion pulls from outside a contact that it does
!> not deform. P = a^3 - 2 X, delta = a^2 (J 2.11, limit lambda -> 0).
module adfric_round_sphere_dmt
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_numerics_powers, only: cube_root
   use adfric_round_sphere_contact, only: sphere_contact_t, theory_t, branch_stable
   implicit none (type, external)
   private
   public :: dmt_t

   !> DMT for one X. Its adhesion is `pull`, which Hertz's theory takes away.
   type, extends(theory_t) :: dmt_t
   contains
      procedure :: of_radius
      procedure :: of_load
      procedure :: of_approach
      procedure :: pull_off
      procedure :: pull
   end type dmt_t

contains

   !> See `theory_t`.
   pure subroutine of_radius(self, value, contact)
      class(dmt_t), intent(in) :: self
      real(dp), intent(in) :: value
      type(sphere_contact_t), intent(inout) :: contact

      if (has_asserts) call assert(value >= 0, 'of_radius: radius >= 0')
      contact = sphere_contact_t()
      contact%is_found = .true.
      contact%is_stable = .true.
      contact%radius = value
      ! the zone of adhesion has no edge; friction ends where contact does
      contact%adhesion_radius = value
      contact%load = value**3 - self%pull()
      contact%approach = value**2
      contact%load_slope = 3*value
      contact%approach_slope = 2
   end subroutine of_radius

   !> See `theory_t`. There is one branch, to a point contact at pull-off.
   pure subroutine of_load(self, value, branch, contact)
      class(dmt_t), intent(in) :: self
      real(dp), intent(in) :: value
      integer, intent(in) :: branch
      type(sphere_contact_t), intent(inout) :: contact

      contact = sphere_contact_t()
      if (value < -self%pull() .or. branch /= branch_stable) return
      call self%of_radius(cube_root(value + self%pull()), contact)
      contact%load = value
   end subroutine of_load

   !> See `theory_t`.
   pure subroutine of_approach(self, value, branch, contact)
      class(dmt_t), intent(in) :: self
      real(dp), intent(in) :: value
      integer, intent(in) :: branch
      type(sphere_contact_t), intent(inout) :: contact

      contact = sphere_contact_t()
      if (value < 0 .or. branch /= branch_stable) return
      call self%of_radius(sqrt(value), contact)
      contact%approach = value
   end subroutine of_approach

   !> See `theory_t`: the point contact, under every control.
   pure subroutine pull_off(self, control, contact)
      class(dmt_t), intent(in) :: self
      integer, intent(in) :: control
      type(sphere_contact_t), intent(out) :: contact

      call self%of_radius(0.0_dp, contact)
      associate (unused => control)
      end associate
   end subroutine pull_off

   !> Force of adhesion.
   pure real(dp) function pull(self)
      class(dmt_t), intent(in) :: self

      pull = 2*self%ratio
   end function pull

end module adfric_round_sphere_dmt
