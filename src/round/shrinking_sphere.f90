! SPDX-License-Identifier: GPL-3.0-or-later
!> The path of a sphere from rest to sliding as one along which the contact shrinks: that of stable contact under a given load or
!> approach.
module adfric_round_shrinking_sphere
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi
   use adfric_round_shrinking_path, only: shrinking_path_t, slip_state_t
   use adfric_round_sphere_peeling_path, only: force_along, get_waypoint, peeling_path_t, rate_of, peeling_waypoint_t
   implicit none (type, external)
   private
   public :: shrinking_sphere_t, new_shrinking, state_of

   !> A path along which the contact shrinks.
   type, extends(shrinking_path_t) :: shrinking_sphere_t
      !> The path of the sphere; rates need its end.
      type(peeling_path_t) :: path
   contains
      procedure :: get_state
   end type shrinking_sphere_t

   !> Slope of ln T beyond the last contact.
   real(dp), parameter :: steepest = 1.0e30_dp
   !> Steps of ln g for slopes: the largest, the smallest, and the share of the distance from the end of the path, where b falls by
   !> the root of that distance.
   real(dp), parameter :: fine_step = 1.0e-5_dp, finest_step = 1.0e-10_dp, step_share = 0.125_dp

contains

   !> The path of a sphere as one along which the contact shrinks.
   pure subroutine new_shrinking(retreat, path)
      type(shrinking_sphere_t), intent(out) :: retreat
      type(peeling_path_t), intent(in) :: path

      retreat%path = path
      retreat%is_weakened = path%friction%interaction > 0
      retreat%demand = path%compliance
      retreat%force_scale = half_pi*path%friction%strength
      retreat%displacement_scale = path%displacement_scale
      retreat%slip_energy_ratio = path%friction%slip_energy_ratio
      retreat%limit = path%limit
   end subroutine new_shrinking

   !> See `shrinking_path_t`.
   pure subroutine get_state(self, slip_energy, state, rate)
      class(shrinking_sphere_t), intent(inout) :: self
      !> g, from 0 to the limit of the path.
      real(dp), intent(in) :: slip_energy
      !> Receives the state; not found where the contact has been lost.
      type(slip_state_t), intent(out) :: state
      !> Receives d ln T/d ln g, if it is asked for; enormous and below 0 beyond the last contact.
      real(dp), intent(out), optional :: rate
      type(peeling_waypoint_t) :: waypoint
      real(dp) :: step

      call get_waypoint(self%path, slip_energy, self%path%start%contact, waypoint)
      state = state_of(waypoint)
      if (.not. present(rate)) return
      rate = -steepest
      step = max(min(fine_step, step_share*(1 - slip_energy/self%path%finish%slip_energy)), finest_step)
      if (waypoint%is_found) rate = rate_of(self%path, force_along, waypoint, step, .true.)
   end subroutine get_state

   !> What a search needs to know of a waypoint.
   pure type(slip_state_t) function state_of(waypoint) result(state)
      type(peeling_waypoint_t), intent(in) :: waypoint

      state = slip_state_t(waypoint%is_found, waypoint%slip_energy, waypoint%ratio, waypoint%friction_radius, waypoint%core, &
         & waypoint%angle)
   end function state_of

end module adfric_round_shrinking_sphere
