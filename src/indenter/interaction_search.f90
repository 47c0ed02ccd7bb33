! SPDX-License-Identifier: GPL-3.0-or-later
!> What is looked for on the way of an indenter from rest to sliding: the state of a force, the end of the way, and the largest force.
!>
!> **The state of a force T.** At a g the contact of radius b(g) bears T at the angle th with T = 2 tau b^2 (th + sin th cos th), and then
!> slips by as much as the demand D(g) = K b (th sin th + cos th - 1). States of this force are where D(g) = g. As g grows b falls, th
!> rises, and so does D, for d(ln D)/d(ln b) = 1 - th (th + sin th cos th)/(cos th (th sin th + cos th - 1)), which is at most -3. So
!> g <- D(g), from g = 0, rises to the first of them, the state that a growing force reaches, and **passes none**: where g < D(g), there is
!> no state between. If b(g) cannot bear T, or D(g) is beyond the last contact, no g has the state. Several states may have a force;
!> where the first one has gone the surfaces jump to the next, so the first one is that of the largest force so far.
!>
!> Steps below 1 % are made 1 %: then a change of sign of ln D - ln g, or its least value where it turns, shows a state.
!>
!> **The largest force** is that of the end of the way, or one that no stretch from g to g' can hide: its forces are below
!> 2 tau b(g)^2 (th' + sin th' cos th'). Stretches that may hide more are divided, down to 5 %; there the signs of dT/dg at both ends show a peak.
module adfric_indenter_interaction_search
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi, pi
   use adfric_indenter_interaction_path, only: complete_waypoint, force_of, get_rates, get_waypoint, path_t, turn, waypoint_t
   use adfric_indenter_weak_contact, only: find_last
   use adfric_material_interaction, only: slip_energy_of_ratio
   use adfric_material_slip_annulus, only: angle_of_force, force_of_angle, largest_slip_core, slip_of_angle
   implicit none (type, external)
   private
   public :: find_force, find_end, find_peak, end_capped, end_sliding, end_snap_off, end_no_adhesion

   !> How the part of the way ends where the contact changes: slip is large enough to take no more, the centre slips, the contact is lost,
   !> or nothing is left of adhesion.
   integer, parameter :: end_capped = 1, end_sliding = 2, end_snap_off = 3, end_no_adhesion = 4
   !> Smallest step of ln g in the search of a force, and smallest stretch in that of a peak.
   real(dp), parameter :: least_step = 0.01_dp, least_stretch = 0.05_dp
   !> A step of ln g that is round-off.
   real(dp), parameter :: round_off = 8*epsilon(1.0_dp)

contains

   !> ln of the demand over g at a g, for a force.
   pure subroutine get_demand(path, force, slip_energy, excess, waypoint)
      !> The way.
      type(path_t), intent(inout) :: path
      !> T > 0.
      real(dp), intent(in) :: force
      !> g > 0.
      real(dp), intent(in) :: slip_energy
      !> Receives ln(D/g).
      real(dp), intent(out) :: excess
      !> Receives the state with the angle of the force; not found where the contact is lost, or does not bear the force.
      type(waypoint_t), intent(out) :: waypoint
      real(dp) :: largest

      call get_waypoint(path, slip_energy, waypoint)
      excess = huge(excess)
      if (.not. waypoint%is_found) return
      largest = pi*path%law%strength*waypoint%radius**2
      waypoint%is_found = force <= (1 + round_off/2)*largest
      if (.not. waypoint%is_found) return
      call turn(angle_of_force(min(force/largest, 1.0_dp)), waypoint)
      excess = log(path%demand*waypoint%radius*waypoint%core/slip_energy)
   end subroutine get_demand

   !> The first state that bears a force; not found if the force is not reached before sliding.
   pure subroutine find_force(path, force, waypoint, is_converged)
      !> The way; its start is found.
      type(path_t), intent(inout) :: path
      !> T >= 0.
      real(dp), intent(in) :: force
      !> Receives the state.
      type(waypoint_t), intent(out) :: waypoint
      !> Was it found to round-off?
      logical, intent(out) :: is_converged
      integer, parameter :: most_steps = 20000
      type(waypoint_t) :: found
      real(dp) :: g, cap, before, at_before, earlier, at_earlier, excess, largest, step, turning
      integer :: k
      logical :: is_certain

      is_converged = .true.
      waypoint = path%start
      largest = pi*path%law%strength*waypoint%radius**2
      waypoint%is_found = force <= (1 + round_off/2)*largest
      if (.not. waypoint%is_found .or. .not. force > 0) return
      call turn(angle_of_force(min(force/largest, 1.0_dp)), waypoint)
      waypoint%slip_energy = min(path%demand*waypoint%radius*waypoint%core, path%law%slip_energy_ratio)
      ! a slip energy below all numbers takes nothing from adhesion
      if (.not. (path%law%interaction > 0 .and. waypoint%slip_energy > 0)) return
      cap = min(path%law%slip_energy_ratio, path%limit)
      g = min(path%demand*waypoint%radius*waypoint%core, cap)
      before = 0
      at_before = huge(excess)
      earlier = 0
      at_earlier = huge(excess)
      is_certain = .true.
      do k = 1, most_steps
         call get_demand(path, force, g, excess, found)
         if (.not. found%is_found) then
            waypoint%is_found = .false.
            ! a step that was not certain may have passed a state
            if (is_certain .or. g - before <= round_off*g) return
            step = log(g/before)/4
            is_certain = at_before >= step
            g = before*exp(max(at_before, step))
            cycle
         end if
         waypoint = found
         if (g >= cap .and. excess >= 0) then
            ! slip takes no more, or there is nothing left to take
            waypoint%is_found = path%law%slip_energy_ratio <= path%limit
            return
         end if
         if (abs(excess) <= round_off .or. (excess < 0 .and. .not. before > 0)) return
         if (excess < 0) then
            call find_between(path, force, before, g, waypoint, is_converged)
            return
         end if
         if (at_before < at_earlier .and. at_before < min(excess, least_step)) then
            call find_turn(path, force, earlier, g, turning, is_certain)
            if (is_certain) then
               call find_between(path, force, earlier, turning, waypoint, is_converged)
               return
            end if
         end if
         earlier = before
         at_earlier = at_before
         before = g
         at_before = excess
         step = least_step
         is_certain = excess >= step
         g = min(g*exp(max(excess, step)), cap)
      end do
      is_converged = .false.
   end subroutine find_force

   !> Between two g of which the first has a larger demand and the second a smaller one: the state, by the method of Illinois.
   pure subroutine find_between(path, force, first, last, waypoint, is_converged)
      !> The way.
      type(path_t), intent(inout) :: path
      !> T > 0.
      real(dp), intent(in) :: force
      !> The two g, > 0.
      real(dp), intent(in) :: first, last
      !> Receives the state.
      type(waypoint_t), intent(out) :: waypoint
      !> Was it found to round-off?
      logical, intent(out) :: is_converged
      integer, parameter :: most_steps = 100
      real(dp) :: low, high, at_low, at_high, y, excess
      integer :: k, side

      low = log(first)
      high = log(last)
      call get_demand(path, force, first, at_low, waypoint)
      call get_demand(path, force, last, at_high, waypoint)
      side = 0
      is_converged = .true.
      do k = 1, most_steps
         if (high - low <= round_off) return
         y = low + (high - low)*(at_low/(at_low - at_high))
         if (.not. (y > low .and. y < high)) y = low + (high - low)/2
         call get_demand(path, force, exp(y), excess, waypoint)
         is_converged = waypoint%is_found
         if (.not. is_converged .or. abs(excess) <= round_off) return
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
      is_converged = .false.
   end subroutine find_between

   !> Where the demand over g is least between two g, by the golden section; the search ends where the demand is less than g.
   pure subroutine find_turn(path, force, first, last, place, is_found)
      !> The way.
      type(path_t), intent(inout) :: path
      !> T > 0.
      real(dp), intent(in) :: force
      !> The two g.
      real(dp), intent(in) :: first, last
      !> Receives a g with a smaller demand.
      real(dp), intent(out) :: place
      !> Is there one?
      logical, intent(out) :: is_found
      real(dp), parameter :: golden = 0.6180339887498949_dp
      integer, parameter :: most_steps = 45
      type(waypoint_t) :: waypoint
      real(dp) :: low, high, places(2), values(2)
      integer :: k, new

      low = log(first)
      high = log(last)
      places = [high - golden*(high - low), low + golden*(high - low)]
      values = huge(low)
      new = 0
      place = first
      do k = 1, most_steps
         if (new /= 2) call get_demand(path, force, exp(places(1)), values(1), waypoint)
         if (new /= 1) call get_demand(path, force, exp(places(2)), values(2), waypoint)
         is_found = any(values < 0)
         place = exp(places(minloc(values, 1)))
         if (is_found) return
         if (values(1) < values(2)) then
            high = places(2)
            places = [high - golden*(high - low), places(1)]
            values(2) = values(1)
            new = 1
         else
            low = places(1)
            places = [places(2), low + golden*(high - low)]
            values(1) = values(2)
            new = 2
         end if
      end do
   end subroutine find_turn

   !> Where the part of the way ends in which the contact changes, and how.
   pure subroutine find_end(path, finish, ending, is_converged)
      !> The way; its start is found.
      type(path_t), intent(inout) :: path
      !> Receives the last state.
      type(waypoint_t), intent(out) :: finish
      !> Receives one of `end_...`.
      integer, intent(out) :: ending
      !> Was it found to round-off?
      logical, intent(out) :: is_converged
      real(dp) :: cap, ratio

      is_converged = .true.
      cap = min(path%law%slip_energy_ratio, path%limit)
      ending = merge(end_capped, end_no_adhesion, path%law%slip_energy_ratio <= path%limit)
      if (.not. path%law%interaction > 0) then
         finish = path%start
         ending = end_sliding
         call turn(half_pi, finish)
         return
      end if
      ! g of sliding if the contact did not shrink
      call get_waypoint(path, min(cap, largest_slip_core*path%demand*path%start%radius), finish)
      if (.not. finish%is_found) then
         ending = end_snap_off
         call find_last(path%way, finish%ratio, ratio, finish%contact, is_converged)
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
      !> The way.
      type(path_t), intent(inout) :: path
      !> In: a state at or beyond it. Out: the state.
      type(waypoint_t), intent(inout) :: finish
      !> Was it found to round-off?
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

   !> The largest force before the contact is constant, if it is larger than that of a state and than a given one.
   pure subroutine find_peak(path, finish, peak, is_found)
      !> The way.
      type(path_t), intent(inout) :: path
      !> The end of its part where the contact changes.
      type(waypoint_t), intent(in) :: finish
      !> In: the state of the largest force so far. Out: that of a larger one, if there is one.
      type(waypoint_t), intent(inout) :: peak
      !> Was a larger one found?
      logical, intent(out) :: is_found
      integer, parameter :: most_stretches = 2000
      type(waypoint_t) :: high, low, stack(64)
      real(dp) :: largest
      integer :: n, k

      is_found = .false.
      if (.not. path%law%interaction > 0) return
      largest = force_of(path, peak)
      high = finish
      n = 0
      do k = 1, most_stretches
         if (n == 0) then
            ! the next stretch towards the beginning
            call get_waypoint(path, high%slip_energy/2, low)
            if (.not. low%is_found) return
         else
            low = stack(n)
         end if
         ! nothing before the end of this stretch bears more
         if (bound_of(path, path%start, high) <= largest) return
         if (bound_of(path, low, high) <= largest .or. log(high%slip_energy/low%slip_energy) <= least_stretch) then
            if (bound_of(path, low, high) > largest) call find_peak_between(path, low, high, largest, peak, is_found)
            high = low
            n = max(n - 1, 0)
         else if (n < size(stack) - 1) then
            if (n == 0) stack(1) = low
            n = max(n, 1)
            n = n + 1
            call get_waypoint(path, sqrt(low%slip_energy)*sqrt(high%slip_energy), stack(n))
         else
            return
         end if
      end do
   end subroutine find_peak

   !> No state between two of the way bears more than this.
   pure real(dp) function bound_of(path, low, high) result(bound)
      !> The way.
      type(path_t), intent(in) :: path
      !> The states, in the order of g.
      type(waypoint_t), intent(in) :: low, high

      bound = pi*path%law%strength*low%radius**2*force_of_angle(high%angle)
   end function bound_of

   !> The peak between two states close to each other.
   pure subroutine find_peak_between(path, first, last, largest, peak, is_found)
      !> The way.
      type(path_t), intent(inout) :: path
      !> The states, in the order of g.
      type(waypoint_t), intent(in) :: first, last
      !> In: the largest force so far. Out: that of the peak if it is larger.
      real(dp), intent(inout) :: largest
      !> Receives the state then.
      type(waypoint_t), intent(inout) :: peak
      !> Becomes true then.
      logical, intent(inout) :: is_found
      integer, parameter :: most_steps = 100
      ! the rate of ln T that is round-off
      real(dp), parameter :: flat = 1.0e-14_dp
      type(waypoint_t) :: waypoint
      real(dp) :: low, high, at_low, at_high, y, rate, others(2)
      integer :: k, side

      call get_rates(path, first, at_low, others(1), others(2))
      call get_rates(path, last, at_high, others(1), others(2))
      if (.not. (at_low > 0 .and. at_high < 0)) return
      low = log(first%slip_energy)
      high = log(last%slip_energy)
      waypoint = first
      side = 0
      do k = 1, most_steps
         if (high - low <= round_off) exit
         y = low + (high - low)*(at_low/(at_low - at_high))
         if (.not. (y > low .and. y < high) .or. modulo(k, 6) == 0) y = low + (high - low)/2
         call get_waypoint(path, exp(y), waypoint)
         if (.not. waypoint%is_found) return
         call get_rates(path, waypoint, rate, others(1), others(2))
         if (abs(rate) <= flat) exit
         if (rate > 0) then
            low = y
            at_low = rate
            if (side == 1) at_high = at_high/2
            side = 1
         else
            high = y
            at_high = rate
            if (side == 2) at_low = at_low/2
            side = 2
         end if
      end do
      if (.not. force_of(path, waypoint) > largest) return
      largest = force_of(path, waypoint)
      peak = waypoint
      is_found = .true.
   end subroutine find_peak_between

end module adfric_indenter_interaction_search
