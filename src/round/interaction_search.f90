! SPDX-License-Identifier: GPL-3.0-or-later
!> What is looked for on the path of an indenter from rest to sliding: the first state with a force or a displacement, the end of the
!> path, and the largest force.
!>
!> Where the contact shrinks as slip takes from adhesion, which it does in stable contact under a given load or approach, the first
!> state and the largest force are found for certain (`adfric_round_shrinking_path`, `adfric_round_largest_force`): the force may have
!> two peaks (JKR at a given separation with alpha near 1). Where it grows, one peak is looked for.
module adfric_round_interaction_search
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi
   use adfric_numerics_scalar_root, only: equation_t, find_root
   use adfric_round_interaction_path, only: complete_waypoint, end_capped, end_no_adhesion, end_none, end_sliding, end_snap_off, &
      & get_known_waypoint, get_rates, get_waypoint, interaction_path_t, waypoint_t
   use adfric_interface_interaction, only: slip_energy_of_ratio
   use adfric_round_largest_force, only: find_largest_force
   use adfric_round_shrinking_path, only: demand_up_to, displacement_of, find_first, first_core, first_displacement, first_force, &
      & force_of, slip_state_t, turn, turn_to
   use adfric_round_slip_annulus, only: largest_slip_core
   implicit none (type, external)
   private
   public :: find_state, find_end, find_peak

   !> A quantity of a path less a given value, or its rate, as a function of z = sqrt(g).
   type, extends(equation_t) :: path_equation_t
      !> The path, known as far as it is looked at.
      class(interaction_path_t), allocatable :: path
      !> One of `first_...`.
      integer :: quantity = first_force
      !> The value that is given.
      real(dp) :: given = 0
      !> Is the rate of the quantity meant, not the quantity?
      logical :: is_rate = .false.
   contains
      procedure :: evaluate
   end type path_equation_t

   !> A step of ln g that is round-off.
   real(dp), parameter :: round_off = 8*epsilon(1.0_dp)
   !> Step of ln z for the slope of a rate.
   real(dp), parameter :: rate_step = 1.0e-4_dp

contains

   !> The first state with a force, a displacement or a slip core; not found if that is not reached before sliding.
   pure subroutine find_state(path, quantity, value, waypoint, is_converged)
      !> The path; its start is found. It receives its end, where that is needed.
      class(interaction_path_t), intent(inout) :: path
      !> One of `first_...`.
      integer, intent(in) :: quantity
      !> Its value, >= 0.
      real(dp), intent(in) :: value
      type(waypoint_t), intent(out) :: waypoint
      logical, intent(out) :: is_converged
      type(slip_state_t) :: start, state

      is_converged = .true.
      waypoint = path%start
      if (.not. value > 0) return
      if (.not. path%is_weakened) then
         call turn_to(path, quantity, value, waypoint)
         waypoint%slip_energy = demand_up_to(path, waypoint%radius, waypoint%core, path%slip_energy_ratio)
      else if (path%is_shrinking .and. quantity /= first_core) then
         start = path%start%slip_state_t
         call find_first(path, quantity, value, start, state, is_converged)
         call take_state(path, state, waypoint)
      else
         waypoint%is_found = .false.
         if (path%ending == end_none) call find_end(path, is_converged)
         if (is_converged) call find_before_end(path, quantity, value, waypoint, is_converged)
      end if
   end subroutine find_state

   !> `find_state` on the whole path, whose end is known.
   pure subroutine find_before_end(path, quantity, value, waypoint, is_converged)
      class(interaction_path_t), intent(inout) :: path
      integer, intent(in) :: quantity
      !> Its value, > 0.
      real(dp), intent(in) :: value
      type(waypoint_t), intent(inout) :: waypoint
      logical, intent(out) :: is_converged
      type(waypoint_t) :: peak

      is_converged = .true.
      if (value <= quantity_of(path, quantity, path%finish)) then
         peak = path%finish
      else
         call find_turn(path, quantity, peak, is_converged)
      end if
      if (.not. is_converged) return
      if (peak%is_found) then
         if (value <= quantity_of(path, quantity, peak)) then
            call find_crossing(path, quantity, value, peak, waypoint, is_converged)
            return
         end if
      end if
      if (path%ending /= end_capped) return
      waypoint = path%finish
      call turn_to(path, quantity, value, waypoint)
   end subroutine find_before_end

   !> The waypoint of a state that a search has found.
   pure subroutine take_state(path, state, waypoint)
      class(interaction_path_t), intent(inout) :: path
      type(slip_state_t), intent(in) :: state
      !> Receives the waypoint, not found where the state is not.
      type(waypoint_t), intent(out) :: waypoint

      if (state%is_found) call get_waypoint(path, state%slip_energy, waypoint)
      waypoint%slip_state_t = state
   end subroutine take_state

   !> Where the part of the path ends in which the contact changes, and how.
   pure subroutine find_end(path, is_converged)
      !> The path, whose start is found; it receives `finish` and `ending`.
      class(interaction_path_t), intent(inout) :: path
      logical, intent(out) :: is_converged
      integer, parameter :: most_doublings = 60
      type(waypoint_t) :: finish, last
      real(dp) :: cap, expected, lost_ratio
      integer :: k

      is_converged = .true.
      cap = min(path%slip_energy_ratio, path%limit)
      path%ending = merge(end_capped, end_no_adhesion, path%slip_energy_ratio <= path%limit)
      if (.not. path%is_weakened) then
         path%finish = path%start
         path%ending = end_sliding
         call turn(half_pi, path%finish)
         return
      end if
      ! g of sliding if the contact did not change, which is enough unless it grows
      expected = demand_up_to(path, path%start%radius, largest_slip_core, cap)
      do k = 1, most_doublings
         call get_waypoint(path, min(cap, expected), finish)
         if (.not. finish%is_found) exit
         if (finish%core >= largest_slip_core .or. finish%slip_energy >= cap) exit
         expected = 2*expected
      end do
      if (.not. path%is_shrinking) then
         call step_to_end(path, finish)
      else if (.not. finish%is_found) then
         path%ending = end_snap_off
         lost_ratio = finish%ratio
         call path%find_last(lost_ratio, finish%ratio, finish%contact, is_converged)
         finish%slip_energy = min(slip_energy_of_ratio(finish%ratio, path%law%interaction), cap)
         finish%is_found = .true.
         call complete_waypoint(path, finish)
      end if
      path%finish = finish
      if (finish%core < largest_slip_core .or. .not. is_converged) return
      path%ending = end_sliding
      if (path%is_shrinking) then
         call find_sliding_onset(path, finish, is_converged)
      else
         last = finish
         call find_crossing(path, first_core, sqrt(largest_slip_core), last, finish, is_converged)
      end if
      call turn(half_pi, finish)
      path%finish = finish
   end subroutine find_end

   !> Where the area may grow: go step by step to where contact is lost or the centre slips for the first time.
   pure subroutine step_to_end(path, last)
      !> The path; its `ending` is set where contact is lost.
      class(interaction_path_t), intent(inout) :: path
      !> In: a state at or beyond the end. Out: the last state with contact, or the first one whose centre slips.
      type(waypoint_t), intent(inout) :: last
      integer, parameter :: n_marks = 100
      type(waypoint_t) :: next, known
      real(dp) :: whole, low, high
      integer :: k

      whole = sqrt(last%slip_energy)
      known = path%start
      do k = 1, n_marks
         high = whole*k/n_marks
         call get_waypoint(path, high**2, next)
         if (.not. next%is_found) exit
         known = next
         if (known%core >= largest_slip_core) exit
      end do
      ! nothing on the path: the state at its end stands, which the last step may miss by round-off
      if (next%is_found .and. known%core < largest_slip_core .and. last%is_found) return
      if (.not. next%is_found) then
         path%ending = end_snap_off
         low = sqrt(known%slip_energy)
         do k = 1, digits(low)
            call get_waypoint(path, (low + (high - low)/2)**2, next)
            if (next%is_found) known = next
            if (next%is_found) low = low + (high - low)/2
            if (.not. next%is_found) high = low + (high - low)/2
         end do
      end if
      last = known
   end subroutine step_to_end

   !> The state where the centre begins to slip: K b (pi/2 - 1) = g, of which the left side falls with g.
   pure subroutine find_sliding_onset(path, finish, is_converged)
      class(interaction_path_t), intent(inout) :: path
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
         if (.not. waypoint%is_found) then
            ! round-off beyond the last contact
            high = y
            cycle
         end if
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
      is_converged = is_converged .and. waypoint%is_found .and. k <= most_steps
      finish = waypoint
   end subroutine find_sliding_onset

   !> The largest force before the contact is constant, if it is larger than a given one.
   pure subroutine find_peak(path, peak, is_found, is_converged)
      !> The path, whose end is known.
      class(interaction_path_t), intent(inout) :: path
      !> In: the state of the largest force so far. Out: that of a larger one, if there is one.
      type(waypoint_t), intent(inout) :: peak
      logical, intent(out) :: is_found, is_converged
      type(slip_state_t) :: start, finish, state
      type(waypoint_t) :: waypoint

      is_converged = .true.
      if (path%is_shrinking) then
         start = path%start%slip_state_t
         finish = path%finish%slip_state_t
         call find_largest_force(path, start, finish, force_of(path, peak), state, is_found)
         if (is_found) call take_state(path, state, peak)
         return
      end if
      call find_turn(path, first_force, waypoint, is_converged)
      is_found = waypoint%is_found
      if (is_found) is_found = force_of(path, waypoint) > force_of(path, peak)
      if (is_found) peak = waypoint
   end subroutine find_peak

   !> The largest value of a quantity before the end of the path; not found if it still rises there.
   pure subroutine find_turn(path, quantity, waypoint, is_converged)
      class(interaction_path_t), intent(inout) :: path
      integer, intent(in) :: quantity
      type(waypoint_t), intent(out) :: waypoint
      logical, intent(out) :: is_converged
      type(path_equation_t) :: equation
      real(dp) :: z, high

      is_converged = .true.
      if (.not. path%is_weakened) return
      if (rate_of(path, quantity, path%finish) >= 0) return
      allocate (equation%path, source=path)
      equation%quantity = quantity
      equation%is_rate = .true.
      high = sqrt(path%finish%slip_energy)
      z = high/2
      call find_root(equation, 0.0_dp, high, .false., z, is_converged)
      call get_waypoint(path, z**2, waypoint)
   end subroutine find_turn

   !> The state with a value of a quantity, 0 < value <= that of a state which lies after it.
   pure subroutine find_crossing(path, quantity, value, last, waypoint, is_converged)
      class(interaction_path_t), intent(inout) :: path
      integer, intent(in) :: quantity
      !> Value of the quantity, > 0, at most that of the state `last`.
      real(dp), intent(in) :: value
      !> State on the path that lies after the one with the value, or is that one.
      type(waypoint_t), intent(in) :: last
      type(waypoint_t), intent(inout) :: waypoint
      logical, intent(out) :: is_converged
      type(path_equation_t) :: equation
      real(dp) :: z, high

      allocate (equation%path, source=path)
      equation%quantity = quantity
      equation%given = value
      high = sqrt(last%slip_energy)
      z = high*value/quantity_of(path, quantity, last)
      call find_root(equation, 0.0_dp, high*(1 + 4*epsilon(high)), .true., z, is_converged)
      call get_waypoint(path, z**2, waypoint)
   end subroutine find_crossing

   !> See `equation_t`. Beyond the last contact value and rate are as if the root had been passed.
   pure subroutine evaluate(self, x, value, slope)
      class(path_equation_t), intent(in) :: self
      real(dp), intent(in) :: x
      real(dp), intent(out) :: value, slope
      type(waypoint_t) :: waypoint, near
      real(dp) :: quantity

      call get_known_waypoint(self%path, x**2, waypoint)
      value = merge(-1, 1, self%is_rate)
      slope = 0
      if (.not. waypoint%is_found) return
      if (self%is_rate) then
         value = rate_of(self%path, self%quantity, waypoint)
         call get_known_waypoint(self%path, (x*(1 - rate_step))**2, near)
         slope = (value - rate_of(self%path, self%quantity, near))/(x*rate_step)
      else
         quantity = quantity_of(self%path, self%quantity, waypoint)
         value = quantity - self%given
         slope = 2*quantity*rate_of(self%path, self%quantity, waypoint)/x
      end if
   end subroutine evaluate

   !> Force, displacement, or root of the slip core.
   pure real(dp) function quantity_of(path, quantity, waypoint) result(value)
      class(interaction_path_t), intent(in) :: path
      integer, intent(in) :: quantity
      type(waypoint_t), intent(in) :: waypoint

      value = sqrt(waypoint%core)
      if (quantity == first_force) value = force_of(path, waypoint)
      if (quantity == first_displacement) value = displacement_of(path, waypoint)
   end function quantity_of

   !> d ln(quantity)/d ln g.
   pure real(dp) function rate_of(path, quantity, waypoint) result(rate)
      class(interaction_path_t), intent(in) :: path
      integer, intent(in) :: quantity
      type(waypoint_t), intent(in) :: waypoint
      real(dp) :: rates(3)

      call get_rates(path, waypoint, rates(first_force), rates(first_displacement), rates(first_core))
      rates(first_core) = (1 - rates(first_core))/2
      rate = rates(quantity)
   end function rate_of

end module adfric_round_interaction_search
