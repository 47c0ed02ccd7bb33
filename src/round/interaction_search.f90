! SPDX-License-Identifier: GPL-3.0-or-later
!> What is looked for on the path of an indenter from rest to sliding: the state of a force, the end of the path, and the largest
!> force (`adfric_round_shrinking_path`, `adfric_round_largest_force`).
module adfric_round_interaction_search
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi
   use adfric_round_interaction_path, only: complete_waypoint, get_waypoint, interaction_path_t, waypoint_t
   use adfric_round_weak_contact, only: find_last
   use adfric_interface_interaction, only: slip_energy_of_ratio
   use adfric_round_largest_force, only: find_largest_force
   use adfric_round_shrinking_path, only: demand_up_to, find_first, first_force, force_of, slip_state_t, turn
   use adfric_round_slip_annulus, only: largest_slip_core
   implicit none (type, external)
   private
   public :: find_force, find_end, find_peak, end_capped, end_sliding, end_snap_off, end_no_adhesion

   !> How the part of the path ends where the contact changes: slip is large enough to take no more, the centre slips, the contact
   !> is lost, or nothing is left of adhesion.
   integer, parameter :: end_capped = 1, end_sliding = 2, end_snap_off = 3, end_no_adhesion = 4
   !> A step of ln g that is round-off.
   real(dp), parameter :: round_off = 8*epsilon(1.0_dp)

contains

   !> The first state that bears a force; not found if the force is not reached before sliding.
   pure subroutine find_force(path, force, waypoint, is_converged)
      !> The path; its start is found.
      type(interaction_path_t), intent(inout) :: path
      !> T >= 0.
      real(dp), intent(in) :: force
      type(waypoint_t), intent(out) :: waypoint
      logical, intent(out) :: is_converged
      type(slip_state_t) :: start, state

      is_converged = .true.
      waypoint = path%start
      if (.not. force > 0) return
      start = path%start%slip_state_t
      call find_first(path, first_force, force, start, state, is_converged)
      call take_state(path, state, waypoint)
   end subroutine find_force

   !> The waypoint of a state that a search has found.
   pure subroutine take_state(path, state, waypoint)
      type(interaction_path_t), intent(inout) :: path
      type(slip_state_t), intent(in) :: state
      !> Receives the waypoint, not found where the state is not.
      type(waypoint_t), intent(out) :: waypoint

      if (state%is_found) call get_waypoint(path, state%slip_energy, waypoint)
      waypoint%slip_state_t = state
   end subroutine take_state

   !> Where the part of the path ends in which the contact changes, and how.
   pure subroutine find_end(path, finish, ending, is_converged)
      !> The path; its start is found.
      type(interaction_path_t), intent(inout) :: path
      type(waypoint_t), intent(out) :: finish
      !> Receives one of `end_...`.
      integer, intent(out) :: ending
      logical, intent(out) :: is_converged
      real(dp) :: cap, ratio

      is_converged = .true.
      cap = min(path%law%slip_energy_ratio, path%limit)
      ending = merge(end_capped, end_no_adhesion, path%law%slip_energy_ratio <= path%limit)
      if (.not. path%is_weakened) then
         finish = path%start
         ending = end_sliding
         call turn(half_pi, finish)
         return
      end if
      ! g of sliding if the contact did not shrink
      call get_waypoint(path, demand_up_to(path, path%start%radius, largest_slip_core, cap), finish)
      if (.not. finish%is_found) then
         ending = end_snap_off
         call find_last(path%retreat, finish%ratio, ratio, finish%contact, is_converged)
         finish%ratio = ratio
         finish%slip_energy = min(slip_energy_of_ratio(ratio, path%law%interaction), cap)
         finish%is_found = .true.
         call complete_waypoint(path, finish)
      end if
      if (finish%core < largest_slip_core) return
      ending = end_sliding
      call find_sliding_onset(path, finish, is_converged)
      call turn(half_pi, finish)
   end subroutine find_end

   !> The state where the centre begins to slip: K b (pi/2 - 1) = g, of which the left side falls with g.
   pure subroutine find_sliding_onset(path, finish, is_converged)
      type(interaction_path_t), intent(inout) :: path
      !> In: a state at or beyond it. Out: the state.
      type(waypoint_t), intent(inout) :: finish
      logical, intent(inout) :: is_converged
      integer, parameter :: most_steps = 100
      type(waypoint_t) :: waypoint
      real(dp) :: low, high, at_low, at_high, y, excess, least
      integer :: k, side

      least = largest_slip_core*path%demand
      high = log(finish%slip_energy)
      low = log(least*max(finish%radius, tiny(high)/epsilon(high)/least))
      if (.not. low < high) return
      at_high = log(least*max(finish%radius, tiny(high)/epsilon(high)/least)) - high
      call get_waypoint(path, exp(low), waypoint)
      at_low = log(least*waypoint%radius) - low
      side = 0
      do k = 1, most_steps
         if (high - low <= round_off .or. abs(at_low) <= round_off) exit
         y = low + (high - low)*(at_low/(at_low - at_high))
         if (.not. (y > low .and. y < high) .or. modulo(k, 8) == 0) y = low + (high - low)/2
         call get_waypoint(path, exp(y), waypoint)
         if (.not. waypoint%is_found) is_converged = .false.
         if (.not. waypoint%is_found) return
         excess = log(least*waypoint%radius) - y
         if (abs(excess) <= round_off) exit
         if (excess > 0) then
            low = y
            at_low = excess
            if (side == 1) at_high = at_high/2
            side = 1
         else
            high = y
            at_high = excess
            if (side == 2) at_low = at_low/2
            side = 2
         end if
      end do
      is_converged = is_converged .and. k <= most_steps
      finish = waypoint
   end subroutine find_sliding_onset

   !> The largest force before the contact is constant, if it is larger than a given one.
   pure subroutine find_peak(path, finish, peak, is_found)
      type(interaction_path_t), intent(inout) :: path
      !> The end of its part where the contact changes.
      type(waypoint_t), intent(in) :: finish
      !> In: the state of the largest force so far. Out: that of a larger one, if there is one.
      type(waypoint_t), intent(inout) :: peak
      logical, intent(out) :: is_found
      type(slip_state_t) :: start, state

      start = path%start%slip_state_t
      call find_largest_force(path, start, finish%slip_state_t, force_of(path, peak), state, is_found)
      if (is_found) call take_state(path, state, peak)
   end subroutine find_peak

end module adfric_round_interaction_search
