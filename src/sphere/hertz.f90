!> Hertz's contact: no adhesion. P = a^3, delta = a^2 (J 2.1, 2.2).
module adfric_sphere_hertz
   use adfric_base_kinds, only: dp
   use adfric_numerics_powers, only: cube_root
   use adfric_sphere_contact, only: contact_t, theory_t, branch_stable
   implicit none (type, external)
   private
   public :: hertz_t

   type, extends(theory_t) :: hertz_t
   contains
      procedure :: of_radius
      procedure :: of_load
      procedure :: of_approach
      procedure :: pull_off
   end type hertz_t

contains

   !> See `theory_t`.
   pure subroutine of_radius(self, value, contact)
      class(hertz_t), intent(in) :: self
      real(dp), intent(in) :: value
      type(contact_t), intent(inout) :: contact

      contact = contact_t()
      contact%is_found = .true.
      ! whatever is left of adhesion is left out
      contact%is_stable = self%ratio >= 0
      contact%radius = value
      contact%adhesion_radius = value
      contact%load = value**3
      contact%approach = value**2
   end subroutine of_radius

   !> See `theory_t`. There is one branch, and no tension.
   pure subroutine of_load(self, value, branch, contact)
      class(hertz_t), intent(in) :: self
      real(dp), intent(in) :: value
      integer, intent(in) :: branch
      type(contact_t), intent(inout) :: contact

      contact = contact_t()
      if (value < 0 .or. branch /= branch_stable) return
      call self%of_radius(cube_root(value), contact)
      contact%load = value
   end subroutine of_load

   !> See `theory_t`.
   pure subroutine of_approach(self, value, branch, contact)
      class(hertz_t), intent(in) :: self
      real(dp), intent(in) :: value
      integer, intent(in) :: branch
      type(contact_t), intent(inout) :: contact

      contact = contact_t()
      if (value < 0 .or. branch /= branch_stable) return
      call self%of_radius(sqrt(value), contact)
      contact%approach = value
   end subroutine of_approach

   !> See `theory_t`: nothing holds the sphere.
   pure subroutine pull_off(self, control, contact)
      class(hertz_t), intent(in) :: self
      integer, intent(in) :: control
      type(contact_t), intent(out) :: contact

      call self%of_radius(0.0_dp, contact)
      associate (unused => control)
      end associate
   end subroutine pull_off

end module adfric_sphere_hertz
