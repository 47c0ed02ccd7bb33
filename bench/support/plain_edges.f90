! SPDX-License-Identifier: GPL-3.0-or-later
!> The edge equations of a strip as one first writes them down: unknown phases of the edges, one condition
!> at the end of each zone. For comparison only; the solver's own form is in `adfric_foundation_edges`.
module plain_edges
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_foundation_edges, only: is_admissible, is_admissible_adhesion
   use adfric_foundation_steady_state, only: get_range_margin
   use adfric_foundation_strip, only: strip_t, steady_state_t, regime_discrete, regime_saturated_adhesion, &
      regime_adhesion_zones, regime_adhesion_only, drive
   implicit none (type, external)
   private
   public :: edges_t, new_edges, get_residuals, edges_of, elastic_edges, state_of_edges, is_possible

   !> A strip, the regime whose edges are sought, and their number: a, b, a1, b1 for contact with adhesion
   !> zones (a, b, a1 if the surfaces snap into contact), else a and b.
   type :: edges_t
      type(strip_t) :: strip
      integer :: regime = regime_discrete, n = 2
      real(dp) :: entry = 0
   end type edges_t

contains

   !> The equations for the edges of a strip that is in the state.
   pure subroutine new_edges(self, strip, state)
      type(edges_t), intent(out) :: self
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state

      self%strip = strip
      self%regime = state%regime
      self%entry = state%entry
      if (state%regime == regime_adhesion_zones) self%n = merge(3, 4, state%entry > 0)
   end subroutine new_edges

   !> Residuals of the conditions at the edges.
   pure subroutine get_residuals(self, x, residuals)
      type(edges_t), intent(in) :: self
      real(dp), intent(in) :: x(:)
      real(dp), intent(out) :: residuals(:)
      real(dp) :: a, b, a1, b1

      a = x(1)
      b = x(2)
      associate (s => self%strip, law => self%strip%adhesion, u => self%strip%foundation%u, v => self%strip%foundation%v)
         select case (self%regime)
         case (regime_adhesion_only)
            residuals(1) = (level(s, b) + law%range - law%jump + law%stress)*exp(-(a + b)/v) - law%stress - level(s, -a) - law%range
            residuals(2) = (level(s, -a) + law%range + law%jump)*exp(-(two_pi - a - b)/v) - level(s, b) - law%range
         case (regime_adhesion_zones)
            a1 = x(3)
            b1 = b
            if (self%n == 4) b1 = x(4)
            residuals(1) = pressure(s, -a) + law%stress + (self%entry - law%stress - pressure(s, b))*exp(-(a + b)/u)
            residuals(2) = (level(s, -a) + law%stress)*exp(-(a1 - a)/v) - law%stress - level(s, -a1) - law%range
            residuals(3) = (level(s, -a1) + law%range + law%jump)*exp(-(two_pi - a1 - b1)/v) - level(s, b1) - law%range
            if (self%n == 4) residuals(4) = (level(s, b1) + law%range - law%jump + law%stress)*exp(-(b1 - b)/v) &
               - law%stress - level(s, b)
         case default
            residuals(1) = pressure(s, -a) + law%stress - (law%stress + pressure(s, b))*exp(-(a + b)/u)
            residuals(2) = (level(s, -a) + law%stress)*exp(-(two_pi - a - b)/v) - law%stress - level(s, b)
         end select
      end associate
   end subroutine get_residuals

   !> The surface.
   elemental real(dp) function level(strip, xi)
      type(strip_t), intent(in) :: strip
      real(dp), intent(in) :: xi

      level = strip%mean + cos(xi)
   end function level

   !> The pressure of endless contact.
   elemental real(dp) function pressure(strip, xi)
      type(strip_t), intent(in) :: strip
      real(dp), intent(in) :: xi

      pressure = strip%mean + strip%foundation%storage*cos(xi) + strip%foundation%loss*sin(xi)
   end function pressure

   !> The edges of a state, the length of each zone beside it changed by a share.
   pure function edges_of(self, state, shares) result(x)
      type(edges_t), intent(in) :: self
      type(steady_state_t), intent(in) :: state
      !> Of a, b and the lengths of the adhesion zones.
      real(dp), intent(in) :: shares(4)
      real(dp) :: x(self%n), all_edges(4)

      all_edges(1) = (state%half_width - state%shift)*(1 + shares(1))
      all_edges(2) = (state%half_width + state%shift)*(1 + shares(2))
      all_edges(3) = all_edges(1) + state%trailing*(1 + shares(3))
      all_edges(4) = all_edges(2) + state%leading*(1 + shares(4))
      x = all_edges(:self%n)
   end function edges_of

   !> The edges that a surface at rest would have, kept off the crest and the valley: a start without an answer.
   pure function elastic_edges(self) result(x)
      type(edges_t), intent(in) :: self
      real(dp) :: x(self%n), outer, inner

      associate (s => self%strip)
         outer = acos(max(-0.95_dp, min(0.98_dp, -s%mean - s%adhesion%range)))
         inner = acos(max(-0.9_dp, min(0.99_dp, -s%level)))
      end associate
      x = merge(outer, inner, self%regime == regime_adhesion_only)
      if (self%n > 2) x(3:) = max(outer, 1.1_dp*inner)
   end function elastic_edges

   !> The state that has these edges.
   pure type(steady_state_t) function state_of_edges(self, x) result(state)
      type(edges_t), intent(in) :: self
      real(dp), intent(in) :: x(:)

      state%regime = self%regime
      state%half_width = (x(1) + x(2))/2
      state%shift = (x(2) - x(1))/2
      if (self%n > 2) state%trailing = x(3) - x(1)
      if (self%n > 3) state%leading = x(4) - x(2)
      state%entry = self%entry
      state%outer_shift = state%shift + (state%leading - state%trailing)/2
   end function state_of_edges

   !> Does a state fulfil the inequalities of the model?
   pure logical function is_possible(self, state)
      type(edges_t), intent(in) :: self
      type(steady_state_t), intent(in) :: state
      real(dp) :: a, b

      a = state%half_width - state%shift
      b = state%half_width + state%shift
      is_possible = a + b > 0 .and. a + b < two_pi
      if (.not. is_possible) return
      select case (self%regime)
      case (regime_adhesion_zones)
         is_possible = is_admissible(self%strip, state)
      case (regime_adhesion_only)
         is_possible = is_admissible_adhesion(self%strip, state)
      case default
         is_possible = drive(self%strip, -a) < 0 .and. drive(self%strip, b) > 0
         if (self%regime == regime_saturated_adhesion) is_possible = is_possible .and. get_range_margin(self%strip, state) >= 0
      end select
   end function is_possible

end module plain_edges
