! SPDX-License-Identifier: GPL-3.0-or-later
!> Compliance of an elastic layer under a wave of pressure, over that of a half-space of its material, 2/(E* k): F(Q), with Q = k H
!> and the thickness H.
!>
!> On a rigid base
!>
!> $$ F = \frac{2 \sinh^2 Q}{\sinh 2Q + 2Q} \text{ (frictionless)}, \qquad
!> F = \frac{2 c \sinh 2Q - 4Q}{2 c \cosh 2Q + 4Q^2 + 1 + c^2} \text{ (bonded)}, \quad c = 3 - 4 \nu $$
!>
!> (K. L. Johnson, Contact Mechanics, 1985, section 5.8, in other words). A coating is bonded to a half-space with the number c2 and
!> a shear modulus of 1/m of its own. With
!>
!> $$ \lambda = 1 - \frac{1 + c}{1 + m c_2}, \qquad \kappa = 1 - \frac{1 + c}{m + c} $$
!>
!> $$ F = \frac
!> {1 + 4 \kappa Q e^{-2Q} - \lambda \kappa e^{-4Q}}
!> {1 - (\lambda + \kappa + 4 \kappa Q^2) e^{-2Q} + \lambda \kappa e^{-4Q}} $$
!>
!> (T. C. O'Sullivan, R. B. King, J. Tribol. 110, 1988, 235, in other words). It is written here as a ratio of sums whose terms are
!> all above 0, so that no digits are lost for any thickness and any moduli. F is 1 for a layer much thicker than the wave is long.
module adfric_solid_layer_compliance
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_numerics_hyperbolic, only: sinh_minus_argument
   implicit none (type, external)
   private
   public :: coating_t, new_coating, factor_of_frictionless, factor_of_bonded, factor_of_coating
   public :: mean_factor_of_bonded, deep

   !> Wave number times thickness above which the layer is a half-space to round-off.
   real(dp), parameter :: deep = 22.0_dp

   !> A coating, bonded to a half-space.
   type :: coating_t
      private
      !> 1 - lambda, 1 - kappa, 1 + kappa and 1 - lambda kappa [-], all >= 0.
      real(dp) :: without_lambda = 1, without_kappa = 1, with_kappa = 1, without_both = 1
   end type coating_t

contains

   !> A coating from the moduli of both bodies.
   pure subroutine new_coating(self, shear_ratio, poisson_ratio, base_poisson_ratio)
      !> Receives its numbers.
      type(coating_t), intent(out) :: self
      !> m: shear modulus of the coating over that of the half-space [-], > 0.
      real(dp), intent(in) :: shear_ratio
      !> Poisson's ratios of the coating and of the half-space [-], > -1, <= 1/2.
      real(dp), intent(in) :: poisson_ratio, base_poisson_ratio
      real(dp) :: c, c_base

      if (has_asserts) call assert(shear_ratio > 0, 'new_coating: shear_ratio > 0')
      c = 3 - 4*poisson_ratio
      c_base = 3 - 4*base_poisson_ratio
      self%without_lambda = (1 + c)/(1 + shear_ratio*c_base)
      self%without_kappa = (1 + c)/(shear_ratio + c)
      self%with_kappa = (2*shear_ratio + 2*(1 - 2*poisson_ratio))/(shear_ratio + c)
      self%without_both = shear_ratio/(shear_ratio + c)*((1 + c)*(1 + c_base)/(1 + shear_ratio*c_base))
   end subroutine new_coating

   !> F of a layer that slips on its rigid base.
   elemental real(dp) function factor_of_frictionless(q) result(factor)
      !> Wave number times thickness [-], > 0.
      real(dp), intent(in) :: q

      factor = 1
      if (q > deep) return
      factor = 2*sinh(q)**2/(sinh(2*q) + 2*q)
   end function factor_of_frictionless

   !> F of a layer that is bonded to its rigid base.
   elemental real(dp) function factor_of_bonded(q, poisson_ratio) result(factor)
      !> Wave number times thickness [-], > 0.
      real(dp), intent(in) :: q
      !> Poisson's ratio of the layer [-].
      real(dp), intent(in) :: poisson_ratio
      real(dp) :: c

      factor = 1
      if (q > deep) return
      c = 3 - 4*poisson_ratio
      factor = (2*c*sinh_minus_argument(2*q) + 8*(1 - 2*poisson_ratio)*q)/(2*c*cosh(2*q) + 4*q**2 + 1 + c**2)
   end function factor_of_bonded

   !> F of a coating.
   elemental real(dp) function factor_of_coating(q, coating) result(factor)
      !> Wave number times thickness [-], > 0.
      real(dp), intent(in) :: q
      !> Numbers of the coating and of its half-space.
      type(coating_t), intent(in) :: coating
      real(dp) :: decay, above, below

      factor = 1
      if (q > deep) return
      decay = exp(-2*q)
      associate (a => coating%without_lambda, b => coating%without_kappa, d => coating%without_both)
         above = d*decay + 2*sinh_minus_argument(2*q) + 4*q*coating%with_kappa
         ! 1 - exp(-2 Q) = 2 sinh Q exp(-Q), and sinh^2 Q - Q^2 = (sinh Q - Q) (sinh Q + Q)
         below = a*b + 2*d*sinh(q)*exp(-q) + 4*(sinh_minus_argument(q)*(sinh(q) + q) + b*q**2)
      end associate
      factor = above/below
   end function factor_of_coating

   !> Mean displacement over mean pressure of a bonded layer, over that of a frictionless one, H/E* [-].
   elemental real(dp) function mean_factor_of_bonded(poisson_ratio) result(factor)
      !> Poisson's ratio of the layer [-].
      real(dp), intent(in) :: poisson_ratio

      factor = (1 - 2*poisson_ratio)/(1 - poisson_ratio)**2
   end function mean_factor_of_bonded

end module adfric_solid_layer_compliance
