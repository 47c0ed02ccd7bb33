! SPDX-License-Identifier: GPL-3.0-or-later
!> What a round contact has where nothing slips while its load grows (Mossakovskii, Spence; F. M. Borodich, L. M. Keer, Proc. R.
!> Soc. Lond. A 460 (2004) 507), over what it has without friction. With Dundurs's beta of both bodies, kappa = artanh(beta)/pi, and a
!> profile f ~ r^n, at the same radius of contact
!>
!>     dP/d delta = C 2 E* a,  C = artanh(beta)/beta
!>     delta = c delta_0,  1/c = int_0^1 cos(kappa ln((1 - t)/(1 + t))) d(t^n)
!>
!> So the load is C c times that without friction. C is that of every shape, as each step of load is one of a flat punch. One body on
!> a rigid one has C = (1 - nu) ln(3 - 4 nu)/(1 - 2 nu).
module adfric_round_full_stick
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_unset, only: is_set
   use adfric_numerics_double_exponential, only: integrand_t, integrate
   use adfric_numerics_libm, only: expm1, log1p
   use adfric_round_case, only: indenter_case_t
   use adfric_round_variables, only: in => indenter_input, kind_cone, kind_flat, kind_paraboloid, kind_power, &
      & out => indenter_output, theory_none
   use adfric_solid_contact_modulus, only: dundurs_ratio_of, has_poisson_ratio
   implicit none (type, external)
   private
   public :: stick_stiffness_ratio, get_stick_depth_ratio, store_full_stick

   !> The integrand over t^n.
   type, extends(integrand_t) :: depth_integrand_t
      !> kappa [-].
      real(dp) :: kappa = 0
      !> The exponent n of the profile.
      real(dp) :: exponent = 2
   contains
      procedure :: evaluate
   end type depth_integrand_t

contains

   !> C, the stiffness over that without friction.
   elemental real(dp) function stick_stiffness_ratio(beta) result(ratio)
      !> Dundurs's beta, below 1 in size.
      real(dp), intent(in) :: beta

      ratio = 1
      if (abs(beta) > epsilon(beta)) ratio = atanh(beta)/beta
   end function stick_stiffness_ratio

   !> c, the approach over that without friction, at the same radius.
   pure subroutine get_stick_depth_ratio(beta, exponent, ratio, is_found)
      !> Dundurs's beta, and the exponent n of the profile, > 0.
      real(dp), intent(in) :: beta, exponent
      real(dp), intent(out) :: ratio
      logical, intent(out) :: is_found

      call integrate(depth_integrand_t(atanh(beta)/pi, exponent), 1.0_dp, ratio, is_found)
      ratio = 1/ratio
   end subroutine get_stick_depth_ratio

   !> See `integrand_t`: the positions are t^n and 1 - t^n.
   pure real(dp) function evaluate(self, from_left, from_right) result(value)
      class(depth_integrand_t), intent(in) :: self
      real(dp), intent(in) :: from_left, from_right
      real(dp) :: logarithm, rest

      if (from_left < 0.5_dp) then
         logarithm = log(from_left)
      else
         logarithm = log1p(-from_right)
      end if
      ! 1 - t; of small exponents almost all t are 0
      rest = 1
      if (logarithm/700 > -self%exponent) rest = -expm1(logarithm/self%exponent)
      value = 1
      if (rest > 0) value = cos(self%kappa*log(rest/(2 - rest)))
   end function evaluate

   !> The results of full stick of a contact without adhesion, from those without friction.
   pure subroutine store_full_stick(case, values, results, is_found)
      type(indenter_case_t), intent(in) :: case
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> In: load, approach and stiffness. Receives the results; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Have the integrals been found?
      logical, intent(out) :: is_found
      real(dp) :: beta, exponent, depth, stiffness

      is_found = .true.
      associate (bodies => values(in%contact_modulus:in%second_poisson_ratio))
         if (case%theory /= theory_none .or. .not. has_poisson_ratio(bodies)) return
         ! without an approach, and bodies that are apart
         if (ieee_is_nan(results(out%approach))) return
         if (results(out%approach) < 0) return
         beta = dundurs_ratio_of(bodies)
      end associate
      stiffness = stick_stiffness_ratio(beta)
      results(out%full_stick_stiffness) = stiffness*results(out%contact_stiffness)
      select case (nint(values(in%kind)))
      case (kind_flat)
         depth = 1
      case (kind_cone, kind_paraboloid, kind_power)
         exponent = nint(values(in%kind)) - kind_flat
         if (is_set(values(in%exponent))) exponent = values(in%exponent)
         call get_stick_depth_ratio(beta, exponent, depth, is_found)
      case default
         return
      end select
      if (.not. is_found) return
      results(out%full_stick_approach) = depth*results(out%approach)
      results(out%full_stick_load) = stiffness*depth*results(out%load)
   end subroutine store_full_stick

end module adfric_round_full_stick
