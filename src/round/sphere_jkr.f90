! SPDX-License-Identifier: GPL-3.0-or-later
!> The theory of Johnson, Kendall and Roberts: P = a^3 - sqrt(6 X a^3), delta = a^2 - (2/3) sqrt(6 X a)
!> (J 2.11, 4.10, limit lambda -> infinity).
module adfric_round_sphere_jkr
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_numerics_powers, only: cube_root
   use adfric_numerics_scalar_root, only: equation_t, find_root
   use adfric_round_sphere_contact, only: sphere_contact_t, theory_t, branch_stable, control_approach
   implicit none (type, external)
   private
   public :: jkr_t, jkr_ratio_of_load, jkr_ratio_of_approach

   !> JKR for one X.
   type, extends(theory_t) :: jkr_t
   contains
      procedure :: of_radius
      procedure :: of_load
      procedure :: of_approach
      procedure :: pull_off
   end type jkr_t

   !> Approach as a function of the square root q of the radius, q^4 - (2/3) sqrt(6 X) q, less a given one.
   type, extends(equation_t) :: approach_equation_t
      !> sqrt(6 X), and the approach that is given, reduced.
      real(dp) :: tension = 0, approach = 0
   contains
      procedure :: evaluate
   end type approach_equation_t

contains

   !> See `theory_t`.
   pure subroutine of_radius(self, value, contact)
      class(jkr_t), intent(in) :: self
      real(dp), intent(in) :: value
      type(sphere_contact_t), intent(inout) :: contact
      real(dp) :: tension

      if (has_asserts) call assert(value >= 0, 'of_radius: radius >= 0')
      contact = sphere_contact_t()
      contact%is_found = .true.
      contact%radius = value
      contact%adhesion_radius = value
      tension = sqrt(6*self%ratio)
      contact%load = value**3 - tension*value*sqrt(value)
      contact%approach = value**2 - 2*tension*sqrt(value)/3
      contact%is_stable = 2*value**3 >= 3*self%ratio
      ! over the root of the radius
      contact%load_slope = 3*value**2 - 3*tension*sqrt(value)/2
      contact%approach_slope = 2*value
      if (tension > 0) then
         contact%load_slope = contact%load_slope*sqrt(value)
         contact%approach_slope = 2*value*sqrt(value) - tension/3
      end if
   end subroutine of_radius

   !> See `theory_t`. P is quadratic in a^(3/2).
   pure subroutine of_load(self, value, branch, contact)
      class(jkr_t), intent(in) :: self
      real(dp), intent(in) :: value
      integer, intent(in) :: branch
      type(sphere_contact_t), intent(inout) :: contact
      real(dp) :: tension, discriminant, root

      contact = sphere_contact_t()
      discriminant = 6*self%ratio + 4*value
      if (discriminant < 0) return
      tension = sqrt(6*self%ratio)
      root = (tension + sqrt(discriminant))/2
      if (branch /= branch_stable) then
         ! the product of both roots is -P
         if (value > 0 .or. .not. root > 0) return
         root = -value/root
      end if
      call self%of_radius(cube_root(root*root), contact)
      contact%load = value
      contact%is_stable = branch == branch_stable
   end subroutine of_load

   !> See `theory_t`.
   pure subroutine of_approach(self, value, branch, contact)
      class(jkr_t), intent(in) :: self
      real(dp), intent(in) :: value
      integer, intent(in) :: branch
      type(sphere_contact_t), intent(inout) :: contact
      type(approach_equation_t) :: equation
      real(dp) :: fold, root, rest
      logical :: is_converged

      contact = sphere_contact_t()
      equation%tension = 2*sqrt(6*self%ratio)/3
      equation%approach = value
      fold = 0
      if (value < 0 .or. branch /= branch_stable) then
         ! the approach is least where 4 q^3 is the tension
         fold = cube_root(equation%tension/4)
         if (value < fold**4 - equation%tension*fold) return
      end if
      if (branch == branch_stable) then
         ! not below the root, and close to it
         rest = sqrt(max(value, 0.0_dp))
         root = cube_root(equation%tension + rest*sqrt(rest))
         call find_root(equation, fold, 2*root, .true., root, is_converged)
      else
         if (value > 0) return
         ! at approach 0 the contact has shrunk to a point
         root = 0
         is_converged = .true.
         if (value < 0) call find_root(equation, 0.0_dp, fold, .false., root, is_converged)
      end if
      call self%of_radius(root*root, contact)
      contact%approach = value
      contact%is_stable = branch == branch_stable
      contact%is_converged = is_converged
   end subroutine of_approach

   !> See `theory_t`: a^3 = 3 X/2 under load, X/6 under approach.
   pure subroutine pull_off(self, control, contact)
      class(jkr_t), intent(in) :: self
      integer, intent(in) :: control
      type(sphere_contact_t), intent(out) :: contact

      call self%of_radius(cube_root(self%ratio*merge(1/6.0_dp, 1.5_dp, control == control_approach)), contact)
      contact%is_stable = .true.
   end subroutine pull_off

   !> Value and slope of the equation of the approach.
   pure subroutine evaluate(self, x, value, slope)
      class(approach_equation_t), intent(in) :: self
      !> Root q of the radius, reduced, >= 0.
      real(dp), intent(in) :: x
      !> Approach at q less the given one, reduced.
      real(dp), intent(out) :: value
      !> Derivative of the value by q.
      real(dp), intent(out) :: slope

      value = (x**3 - self%tension)*x - self%approach
      slope = 4*x**3 - self%tension
   end subroutine evaluate

   !> JKR: the least X with which a contact carries a load (J 4.10). With `largest_interaction` of g0 it gives the largest
   !> alpha for which sliding contact exists, if it is not above 1.
   elemental real(dp) function jkr_ratio_of_load(load) result(ratio)
      !> Load P, reduced; only tension, P < 0, needs adhesion.
      real(dp), intent(in) :: load

      ratio = max(-2*load/3, 0.0_dp)
   end function jkr_ratio_of_load

   !> JKR: the least X with which a contact has an approach, -3 (X/6)^(2/3).
   elemental real(dp) function jkr_ratio_of_approach(approach) result(ratio)
      !> Approach delta, reduced; only separation, delta < 0, needs adhesion.
      real(dp), intent(in) :: approach

      ratio = max(-approach, 0.0_dp)/3
      ratio = 6*ratio*sqrt(ratio)
   end function jkr_ratio_of_approach

end module adfric_round_sphere_jkr
