! SPDX-License-Identifier: GPL-3.0-or-later
!> Friction with GM's finite slope, tau = p sin(arctan f') (GM 13), by Gauss's rule.
module adfric_foundation_finite_slope
   use adfric_base_kinds, only: dp
   use adfric_base_asserts, only: assert, has_asserts
   use adfric_base_constants, only: pi, half_pi
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   use adfric_foundation_column, only: get_column
   use adfric_foundation_strip, only: strip_t, steady_state_t, regime_free, regime_adhesion_only, regime_adhesion_zones, &
      & regime_saturated
   implicit none (type, external)
   private
   public :: get_finite_slope_friction, shear_of_pressure

contains

   !> Shear stress under a pressure p at a phase, positive against the motion: -p sin(arctan f').
   elemental real(dp) function shear_of_pressure(pressure, xi, slope) result(shear)
      !> Pressure p, compression positive; its unit is that of the shear stress.
      real(dp), intent(in) :: pressure
      !> Phase [rad]; the crest is at 0.
      real(dp), intent(in) :: xi
      !> Largest slope of the strip, k h_y/2; f' = -slope sin(xi).
      real(dp), intent(in) :: slope

      shear = pressure*slope*sin(xi)/hypot(1.0_dp, slope*sin(xi))
   end function shear_of_pressure

   !> Integral of the shear stress over a period, over the slope: in the units of `balance_t%friction`. It is long by its integrands,
   !> which share the strip and its state.
   pure subroutine get_finite_slope_friction(strip, state, slope, friction, small_slope)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      !> Largest slope of the strip, k h_y/2 [-], > 0.
      real(dp), intent(in) :: slope
      !> Friction of tau = p sin(arctan f'), over the slope.
      real(dp), intent(out) :: friction
      !> Friction of tau = p f' by the same rule, over the slope.
      real(dp), intent(out) :: small_slope
      real(dp) :: a, b, trailing, start, finish, length, total(2)

      if (has_asserts) call assert(slope > 0, 'get_finite_slope_friction: slope > 0')
      friction = 0
      small_slope = 0
      if (state%regime == regime_free) return
      a = state%half_width - state%shift
      b = state%half_width + state%shift
      if (state%regime == regime_adhesion_only) then
         total = strip%adhesion%stress*(rise(b) - rise(a))
         friction = total(1)
         small_slope = total(2)
         return
      end if
      if (state%regime == regime_saturated) then
         a = pi
         b = pi
      end if
      if (state%regime == regime_adhesion_zones) then
         trailing = state%trailing
         total = strip%adhesion%stress*(rise(b + state%leading) - rise(b) + rise(a) - rise(a + trailing))
      else
         total = strip%adhesion%stress*(rise(a) - rise(b))
      end if
      ! pieces that grow from the leading edge, where the pressure changes over the length u
      start = 0
      length = min(strip%foundation%u, half_pi/2, space_below(b))
      do while (start < a + b)
         finish = min(start + length, a + b)
         ! beyond 40 u the exponential is gone and the pressure is a sine
         if (a + b - finish < length/4) finish = a + b
         total = total + integrate_piece(b - finish, b - start)
         start = finish
         length = min(2*length, half_pi/2, space_below(b - finish))
      end do
      friction = total(1)
      small_slope = total(2)

   contains

      !> How far a piece may reach down from a phase. Steep slopes turn about crest and valley within 1/slope: a piece is no longer
      !> than its distance from there, or than that.
      pure real(dp) function space_below(xi)
         !> Phase of the upper end of the piece [rad].
         real(dp), intent(in) :: xi
         real(dp) :: below

         below = xi - pi*floor(xi/pi)
         space_below = max(asinh(1/max(slope, 0.1_dp)), 64*epsilon(xi), min(below/2, pi - below))
      end function space_below

      !> Integrals of sin/sqrt(1 + slope^2 sin^2), and of sin, with the sign of cos.
      pure function rise(xi)
         !> Phase of the end of a zone, or minus that phase, which gives the same [rad].
         real(dp), intent(in) :: xi
         real(dp) :: rise(2)

         rise = [asin(slope/hypot(1.0_dp, slope)*cos(xi))/slope, cos(xi)]
      end function rise

      !> Integrals of both shear stresses over the slope.
      pure function integrate_piece(from, to) result(integral)
         !> Phases of the ends of the piece [rad].
         real(dp), intent(in) :: from, to
         real(dp) :: integral(2), xi, displacement, pressure
         integer :: k

         integral = 0
         do k = 1, size(gauss_nodes)
            xi = (from + to)/2 + (to - from)/2*gauss_nodes(k)
            call get_column(strip, state, xi, displacement, pressure)
            integral = integral + gauss_weights(k)*[shear_of_pressure(pressure, xi, slope)/slope, pressure*sin(xi)]
         end do
         integral = integral*(to - from)/2
      end function integrate_piece

   end subroutine get_finite_slope_friction

end module adfric_foundation_finite_slope
