! SPDX-License-Identifier: GPL-3.0-or-later
!> Integrals over the profiles of a strip, zone by zone, from nothing but its edges and the profiles themselves.
module zone_quadrature
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_numerics_gauss, only: gauss_nodes, gauss_weights
   use adfric_foundation_column, only: get_column
   use adfric_foundation_strip, only: strip_t, steady_state_t, regime_free, regime_adhesion_only, regime_saturated, &
      regime_adhesion_zones
   implicit none (type, external)
   private
   public :: integrals_t, integrate_profiles, get_zones

   !> Integrals over a period, in units of the strip.
   type :: integrals_t
      !> Of p, of -p F', of w, of (p - w)^2/(u (beta - 1)), and of -p F'/sqrt(1 + (slope F')^2).
      real(dp) :: load = 0, friction = 0, displacement = 0, dissipation = 0, finite_friction = 0
   end type integrals_t

contains

   !> Ends of the zones, from the leading end of the contact towards the trailing side, over one period.
   pure subroutine get_zones(state, ends)
      type(steady_state_t), intent(in) :: state
      real(dp), allocatable, intent(out) :: ends(:)
      real(dp) :: start, contact, trailing

      start = state%shift + state%half_width
      contact = 2*state%half_width
      trailing = contact + state%trailing
      select case (state%regime)
      case (regime_free, regime_saturated)
         ends = [0.0_dp, -two_pi]
      case (regime_adhesion_only)
         ends = start - [0.0_dp, contact, two_pi]
         if (contact >= two_pi) ends = [0.0_dp, -two_pi]
      case (regime_adhesion_zones)
         ends = start - [0.0_dp, contact, trailing, two_pi - state%leading, two_pi]
         if (state%leading <= 0) ends = ends(:4)
      case default
         ends = start - [0.0_dp, contact, two_pi]
      end select
   end subroutine get_zones

   !> All integrals.
   pure subroutine integrate_profiles(strip, state, integrals, slope)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      type(integrals_t), intent(out) :: integrals
      !> Largest slope of the surface.
      real(dp), intent(in), optional :: slope
      real(dp), allocatable :: ends(:)
      real(dp) :: steepness, start, finish, length
      integer :: k

      steepness = 0
      if (present(slope)) steepness = slope
      call get_zones(state, ends)
      do k = 1, size(ends) - 1
         ! pieces that grow from the leading end, where the exponentials begin
         start = ends(k)
         length = min(strip%foundation%u, 0.2_dp)/2
         do while (start > ends(k + 1))
            finish = max(start - length, ends(k + 1))
            call add_piece(strip, state, start, finish, steepness, integrals)
            start = finish
            length = min(1.5_dp*length, 0.3_dp)
         end do
      end do
   end subroutine integrate_profiles

   !> Gauss's rule on one piece.
   pure subroutine add_piece(strip, state, start, finish, steepness, integrals)
      type(strip_t), intent(in) :: strip
      type(steady_state_t), intent(in) :: state
      real(dp), intent(in) :: start, finish, steepness
      type(integrals_t), intent(inout) :: integrals
      real(dp) :: xi, weight, w, p, rise
      integer :: k

      do k = 1, size(gauss_nodes)
         xi = (start + finish)/2 + (start - finish)/2*gauss_nodes(k)
         weight = gauss_weights(k)*(start - finish)/2
         call get_column(strip, state, xi, w, p)
         ! -F'
         rise = sin(xi)
         integrals%load = integrals%load + weight*p
         integrals%friction = integrals%friction + weight*p*rise
         integrals%displacement = integrals%displacement + weight*w
         integrals%finite_friction = integrals%finite_friction + weight*p*rise/sqrt(1 + (steepness*rise)**2)
         if (strip%foundation%beta > 1) integrals%dissipation = integrals%dissipation &
            + weight*(p - w)**2/(strip%foundation%u*(strip%foundation%beta - 1))
      end do
   end subroutine add_piece

end module zone_quadrature
