! SPDX-License-Identifier: GPL-3.0-or-later
!> The smallest penetration at which the greatest state of a surface carries a load, after adhesion has taken hold.
!>
!> Steps of the lack over a slope P0' that holds up to where they lead pass no state. They are far too short where edges move, so
!> Newton's method with edges goes ahead, and its state is taken where `bound_response` proves that none is passed.
module adfric_foundation_stepping_approach_search
   use adfric_base_kinds, only: dp
   use adfric_foundation_stepping_response, only: bound_response
   use adfric_foundation_stepping_states, only: stepping_surface_t, stepping_states_t, start, find_extreme, is_shared, sum_up, &
      & shift, largest_depth, stepping_solved, stepping_no_equilibrium, stepping_failed, round_off
   use adfric_foundation_stepping_steady_column, only: take_step, take_edge_step, move, most_edge_steps
   implicit none (type, external)
   private
   public :: search_upwards

   !> By this penetration more than that of the draw-in, in lengths of 1, round-off does not hide that adhesion has taken hold.
   real(dp), parameter :: drawn_in = 1.0e-11_dp
   !> Most penetrations that one search looks at.
   integer, parameter :: most_penetrations = 2000
   !> Bounds of the slope are looked for at so many distances, and taken where they lead so many times less far.
   integer, parameter :: most_reaches = 10
   real(dp), parameter :: enough = 3
   !> Penetrations of a scan for tensions on the approach branch.
   integer, parameter :: steps_of_scan = 64

contains

   !> The smallest penetration that carries a load, after the surface has been drawn in.
   subroutine search_upwards(surface, load, depth, states, status)
      type(stepping_surface_t), intent(in) :: surface
      real(dp), intent(in) :: load
      real(dp), intent(out) :: depth
      type(stepping_states_t), intent(inout) :: states
      !> Receives how the search ended.
      integer, intent(out) :: status
      type(stepping_states_t) :: least
      real(dp) :: limit, slope, slope_limit, step
      integer :: k
      logical :: is_proved

      limit = largest_depth(surface, load)
      if (allocated(surface%law%attraction)) then
         call start_apart(surface, depth, states)
         status = merge(stepping_failed, stepping_solved, states%have_failed)
         ! a body that is pulled does not come into contact by itself
         if (load < 0) status = stepping_no_equilibrium
      else if (load > 0) then
         call start_before_touch(surface, depth, states)
         status = merge(stepping_failed, stepping_solved, states%have_failed)
      else
         call start_drawn_in(surface, load, limit, depth, states, status)
      end if
      if (status /= stepping_solved .or. states%load >= load) return
      status = stepping_failed
      if (limit <= depth) then
         status = stepping_no_equilibrium
         return
      end if
      call start(surface, limit, .false., least)
      call find_extreme(surface, limit, .true., least)
      do k = 1, most_penetrations
         if (states%have_failed .or. least%have_failed) return
         ! the penetration has met one that carries the load or more
         if (depth >= limit .or. load - states%load <= states%least_load + round_off*abs(load) + surface%law%resolution) exit
         slope_limit = depth
         if (.not. allocated(surface%law%attraction)) then
            call find_proved(surface, load, limit, depth, states, slope, slope_limit, is_proved)
            if (is_proved) exit
         end if
         step = load - states%load
         if (step <= round_off*(1 + abs(depth)) + surface%law%resolution) exit
         if (.not. slope_limit > depth) call find_slope(surface, load, limit, least, depth, states, slope, slope_limit)
         if (slope*(slope_limit - depth) > step) then
            step = step/slope
         else
            step = max(step, slope_limit - depth)
         end if
         step = min(step, limit - depth)
         depth = depth + step
         call shift(states, step)
         call find_extreme(surface, depth, .false., states)
      end do
      if (k <= most_penetrations) status = stepping_solved
   end subroutine search_upwards

   !> Under a law without an end: a penetration at which no column is in contact, so that the load is below 0.
   subroutine start_apart(surface, depth, states)
      type(stepping_surface_t), intent(in) :: surface
      !> Receives the penetration.
      real(dp), intent(out) :: depth
      type(stepping_states_t), intent(inout) :: states
      real(dp), parameter :: share = 1.0e-3_dp
      integer, parameter :: most_doublings = 60
      real(dp) :: nothing
      integer :: k

      associate (law => surface%law%attraction%law)
         ! a column moves towards the surface by no more than its rest under the largest tension
         depth = -(law%reach(share) + law%stress)
         ! beyond a law that ends nothing acts but round-off
         nothing = surface%law%resolution + round_off*law%stress
      end associate
      do k = 1, most_doublings
         call start(surface, depth, .true., states)
         call find_extreme(surface, depth, .false., states)
         if (states%have_failed .or. .not. states%load > nothing + states%least_load) return
         depth = 2*depth
      end do
      states%have_failed = .true.
   end subroutine start_apart

   !> The surface just before adhesion takes hold of its highest position: free, and nothing is carried.
   subroutine start_before_touch(surface, depth, states)
      type(stepping_surface_t), intent(in) :: surface
      real(dp), intent(out) :: depth
      type(stepping_states_t), intent(inout) :: states
      integer :: i

      depth = -surface%law%attach_gap - drawn_in*(1 + surface%law%attach_gap)
      call start(surface, depth, .true., states)
      do i = 1, size(surface%rows)
         states%rows(i)%state%length = 0
         call take_step(states%rows(i), surface%rows(i), surface%law, depth)
      end do
      call sum_up(depth, states)
   end subroutine start_before_touch

   !> The surface just after adhesion has taken hold of its highest position, or the state that carries a tension.
   subroutine start_drawn_in(surface, load, limit, depth, states, status)
      type(stepping_surface_t), intent(in) :: surface
      !> Mean load of the rows, <= 0.
      real(dp), intent(in) :: load
      !> A penetration beyond which none carries the load.
      real(dp), intent(in) :: limit
      real(dp), intent(out) :: depth
      !> Receives the greatest states there, which carry the load or less.
      type(stepping_states_t), intent(inout) :: states
      integer, intent(out) :: status
      type(stepping_states_t) :: beyond
      real(dp) :: last_depth

      depth = -surface%law%attach_gap + drawn_in*(1 + surface%law%attach_gap)
      call start(surface, depth, .true., states)
      call find_extreme(surface, depth, .false., states)
      status = merge(stepping_failed, stepping_solved, states%have_failed)
      if (states%have_failed .or. states%load <= load) return
      ! a tension: there is a state if there is a last one, and one before it if the load falls below it once more
      last_depth = limit
      call find_last_state(surface, load, last_depth, beyond, status)
      if (status /= stepping_solved) return
      call scan_for_fall(surface, load, last_depth, depth, states)
      status = merge(stepping_failed, stepping_solved, states%have_failed)
      if (states%have_failed .or. states%load <= load) return
      depth = last_depth
      call move_alloc(beyond%rows, states%rows)
      states%load = load
   end subroutine start_drawn_in

   !> The largest penetration at which the greatest state carries a load: steps of the excess over the slope pass none.
   subroutine find_last_state(surface, load, depth, states, status)
      type(stepping_surface_t), intent(in) :: surface
      real(dp), intent(in) :: load
      !> In: a penetration beyond which none carries the load. Out: the last one that does, if there is one.
      real(dp), intent(inout) :: depth
      type(stepping_states_t), intent(inout) :: states
      integer, intent(out) :: status
      real(dp) :: step
      integer :: k

      status = stepping_failed
      do k = 1, most_penetrations
         call start(surface, depth, .true., states)
         call find_extreme(surface, depth, .false., states)
         if (states%have_failed) return
         if (.not. states%slope > 0 .and. states%load > load) then
            ! nothing touches: no smaller penetration carries less
            status = stepping_no_equilibrium
            return
         end if
         step = 0
         if (states%slope > 0) step = (states%load - load)/states%slope
         if (states%load - load <= states%least_load + round_off*abs(load) .or. step <= round_off*(1 + abs(depth))) then
            status = stepping_solved
            return
         end if
         depth = depth - step
      end do
   end subroutine find_last_state

   !> Look for a penetration that carries no more than a load, behind the draw-in that carries more: for tensions alone. The load may
   !> fall anywhere, where adhesion takes hold, so a fall and rise within one step of the scan is not seen.
   subroutine scan_for_fall(surface, load, limit, depth, states)
      type(stepping_surface_t), intent(in) :: surface
      real(dp), intent(in) :: load
      !> Penetration beyond which nothing is sought.
      real(dp), intent(in) :: limit
      !> In: where the surface has been drawn in. Out: a penetration that carries no more than the load, if there is one.
      real(dp), intent(inout) :: depth
      !> In: the greatest states there. Out: those of the last penetration that was looked at.
      type(stepping_states_t), intent(inout) :: states
      real(dp) :: step
      integer :: k

      step = (limit - depth)/steps_of_scan
      if (.not. step > 0) return
      do k = 1, steps_of_scan
         depth = depth + step
         call shift(states, step)
         call find_extreme(surface, depth, .false., states)
         if (states%have_failed .or. states%load <= load) return
      end do
   end subroutine scan_for_fall

   !> A bound of the slope of the load beyond a penetration that carries less than a load.
   subroutine find_slope(surface, load, limit, least, depth, states, slope, slope_limit)
      type(stepping_surface_t), intent(in) :: surface
      real(dp), intent(in) :: load
      !> A penetration beyond which nothing is sought.
      real(dp), intent(in) :: limit
      type(stepping_states_t), intent(in) :: least
      !> The penetration.
      real(dp), intent(in) :: depth
      type(stepping_states_t), intent(in) :: states
      !> Receives the bound, and the penetration to which it holds.
      real(dp), intent(out) :: slope, slope_limit
      type(stepping_states_t) :: beyond
      real(dp) :: lack, reach
      integer :: k

      slope = least%slope
      slope_limit = limit
      lack = load - states%load
      reach = limit - depth
      ! so far if the slope did not rise
      if (states%slope*reach > lack) reach = lack/states%slope
      do k = 1, most_reaches
         if (k > 1 .or. reach < limit - depth) then
            beyond = states
            call shift(beyond, reach)
            call find_extreme(surface, depth + reach, .false., beyond)
            if (beyond%have_failed) return
            slope = beyond%slope
            slope_limit = depth + reach
         end if
         ! where it rises much on the path, a shorter one has a smaller bound
         if (slope*reach <= enough*lack) return
         reach = reach/enough**2
      end do
   end subroutine find_slope

   !> Go to the smallest penetration beyond one that carries a load, if Newton's method with edges finds a state with the load there
   !> and there is proof that no smaller penetration carries it: every greatest state between has the same zones, is the only one
   !> between these two, and the load rises.
   subroutine find_proved(surface, load, limit, depth, states, slope, slope_limit, is_proved)
      type(stepping_surface_t), intent(in) :: surface
      real(dp), intent(in) :: load, limit
      !> In: a penetration that carries less. Out: the one that carries the load, if it is proved.
      real(dp), intent(inout) :: depth
      !> In: the greatest states there. Out: those of the load, if it is proved.
      type(stepping_states_t), intent(inout) :: states
      !> Receives a bound of the slope of the load, and the penetration to which it holds, if it is not proved.
      real(dp), intent(out) :: slope, slope_limit
      logical, intent(out) :: is_proved
      type(stepping_states_t) :: trial
      real(dp) :: trial_depth, row_slope
      integer :: i

      slope = 1
      slope_limit = depth
      trial = states
      trial_depth = depth
      call find_with_edges(surface, load, limit, trial_depth, trial)
      states%rows%n_periods = trial%rows%n_periods
      is_proved = trial%are_steady .and. trial_depth >= depth
      if (.not. is_proved) return
      slope = 0
      do i = 1, size(surface%rows)
         call bound_response(surface%rows(i), surface%law, trial%rows(i)%period, trial_depth, states%rows(i)%period, depth, &
            & row_slope, is_proved)
         if (.not. is_proved) exit
         slope = slope + row_slope
      end do
      is_proved = is_proved .and. slope > 0
      if (is_proved) then
         depth = trial_depth
         call move_alloc(trial%rows, states%rows)
      else
         ! the greatest states of smaller penetrations are above this one, and in contact for no longer
         slope_limit = trial_depth
         do i = 1, size(surface%rows)
            call take_step(trial%rows(i), surface%rows(i), surface%law, trial_depth)
         end do
         slope = sum(trial%rows%load_slope)/size(surface%rows)
      end if
   end subroutine find_proved

   !> Newton's method with edges for states and penetration that carry a load.
   subroutine find_with_edges(surface, load, limit, depth, states)
      type(stepping_surface_t), intent(in) :: surface
      real(dp), intent(in) :: load, limit
      !> In: where to start. Out: the penetration.
      real(dp), intent(inout) :: depth
      !> In: where to start. Out: states that are steady if the method converges.
      type(stepping_states_t), intent(inout) :: states
      real(dp) :: first, change, last_change
      integer :: n_zones(size(surface%rows)), i, k
      logical :: is_over

      n_zones = states%rows%period%n_zones
      first = depth
      last_change = huge(1.0_dp)
      do k = 1, most_edge_steps
         !$omp parallel do schedule(dynamic) if (is_shared(surface))
         do i = 1, size(surface%rows)
            call take_edge_step(states%rows(i), surface%rows(i), surface%law, depth)
         end do
         !$omp end parallel do
         call sum_up(depth, states)
         if (states%have_failed .or. .not. states%slope*(limit - first) > abs(load - states%load)) exit
         change = (load - states%load)/states%slope
         is_over = abs(load - states%load) <= states%least_load + round_off*abs(load) .or. &
            & abs(change) <= round_off*(1 + abs(depth))
         if (is_over .and. states%are_steady) return
         depth = depth + change
         do i = 1, size(surface%rows)
            call move(states%rows(i))
            states%rows(i)%state%length = states%rows(i)%state%length + change*states%rows(i)%response
         end do
         ! there is a proof only with the same zones, and with steps that become small quickly
         if (k > 2 .and. (any(states%rows%period%n_zones /= n_zones) .or. abs(change) > last_change/2)) exit
         last_change = abs(change)
      end do
      states%are_steady = .false.
   end subroutine find_with_edges

end module adfric_foundation_stepping_approach_search
