!> A measured surface as rows of heights, each a strip of its own, and its equilibrium under a penetration or a load.
!>
!> The load P under a penetration D obeys, on either branch, P(D) - P(D') <= (D - D') P0'(D) for D' < D, where P0' is its change while
!> zones are as they are: where the state of D is open, w of D' is above where its own dashpots put it, and in contact w of D'
!> is not below the heights. Contact of D holds contact of D', so P0' does not fall with D, and P0' <= 1. Therefore
!> - downwards from a penetration that carries too much, steps of the excess over P0' pass no state: they end at the largest
!>   penetration that carries the load, or where nothing touches and so no smaller one carries less;
!> - upwards from one that carries too little, steps of the lack over P0'(D') pass no state below D'.
!> With falling penetration the least state moves up by less than the heights go down, so the old one, moved with them, is below the new
!> one; with rising penetration the greatest one, moved, is above the new one.
module adfric_wavy_march_equilibrium
   use adfric_base_kinds, only: dp
   use adfric_wavy_march_law, only: march_law_t
   use adfric_wavy_march_forces, only: march_forces_t, get_march_forces
   use adfric_wavy_march_steady_column, only: steady_column_t, take_step, find_adhered, find_approach, start_from_below, &
      & start_from_free, move
   use adfric_wavy_march_way, only: way_t
   implicit none (type, external)
   private
   public :: march_surface_t, march_equilibrium_t, find_at_penetration, find_at_load
   public :: march_solved, march_no_equilibrium, march_failed

   !> How a search ends.
   integer, parameter :: march_solved = 0, march_no_equilibrium = 1, march_failed = 2
   !> Loads and penetrations are known to this share.
   real(dp), parameter :: round_off = 8*epsilon(1.0_dp)
   !> By this penetration more than that of the draw-in, in lengths of 1, round-off does not hide that adhesion has taken hold.
   real(dp), parameter :: drawn_in = 1.0e-11_dp
   !> Most penetrations that one search looks at.
   integer, parameter :: most_penetrations = 2000
   !> Most periods of a row that one search marches; what takes more is not converged.
   integer, parameter :: most_periods = 10000
   !> Penetrations of a scan for tensions on the approach branch.
   integer, parameter :: steps_of_scan = 64

   !> A surface at one velocity.
   type :: march_surface_t
      !> The rows.
      type(way_t), allocatable :: rows(:)
      !> The law of adhesion.
      type(march_law_t) :: law
      !> Is the branch the greatest state? Else it is the least.
      logical :: is_approach = .false.
   end type march_surface_t

   !> An equilibrium.
   type :: march_equilibrium_t
      !> How it was found, one of `march_...`.
      integer :: status = march_failed
      !> Penetration of the highest place.
      real(dp) :: depth = 0
      !> States of the rows.
      type(steady_column_t), allocatable :: rows(:)
      !> Forces of the rows.
      type(march_forces_t), allocatable :: forces(:)
      !> Number of periods marched.
      integer :: n_periods = 0
   end type march_equilibrium_t

   !> States of all rows at one penetration.
   type :: states_t
      !> The states.
      type(steady_column_t), allocatable :: rows(:)
      !> Mean load, its change with the penetration, and what round-off makes of the load.
      real(dp) :: load = 0, slope = 0, least_load = 0
      !> Are all rows steady? Has one failed?
      logical :: are_steady = .false., have_failed = .false.
   end type states_t

contains

   !> The equilibrium under a penetration.
   subroutine find_at_penetration(surface, depth, equilibrium)
      !> The surface.
      type(march_surface_t), intent(in) :: surface
      !> Penetration.
      real(dp), intent(in) :: depth
      !> Receives the equilibrium.
      type(march_equilibrium_t), intent(out) :: equilibrium
      type(states_t) :: states, least

      if (surface%is_approach) then
         call start(surface, depth, .false., least)
         call start(surface, depth, .true., states)
         call find_greatest(surface, depth, states, least)
      else
         call start(surface, depth, .false., states)
         call find_least(surface, depth, states)
      end if
      call finish(surface, depth, states, merge(march_solved, march_failed, states%are_steady), equilibrium)
   end subroutine find_at_penetration

   !> The equilibrium under a load.
   subroutine find_at_load(surface, load, equilibrium)
      !> The surface.
      type(march_surface_t), intent(in) :: surface
      !> Mean load of the rows.
      real(dp), intent(in) :: load
      !> Receives the equilibrium.
      type(march_equilibrium_t), intent(out) :: equilibrium
      type(states_t) :: states
      real(dp) :: depth
      integer :: status

      if (surface%is_approach .and. surface%law%stress > 0) then
         call search_upwards(surface, load, depth, states, status)
      else
         call search_downwards(surface, load, depth, states, status)
      end if
      call finish(surface, depth, states, status, equilibrium)
   end subroutine find_at_load

   !> A penetration that no state below carries the load at: gaps are not negative, so the load is that of endless contact or more.
   pure real(dp) function largest_depth(surface, load) result(depth)
      !> The surface.
      type(march_surface_t), intent(in) :: surface
      !> Mean load of the rows.
      real(dp), intent(in) :: load
      integer :: i

      depth = load
      do i = 1, size(surface%rows)
         depth = depth - surface%rows(i)%mean/size(surface%rows)
      end do
   end function largest_depth

   !> States to start from.
   subroutine start(surface, depth, is_free, states)
      !> The surface.
      type(march_surface_t), intent(in) :: surface
      !> Penetration.
      real(dp), intent(in) :: depth
      !> Above all states that are steady? Else below.
      logical, intent(in) :: is_free
      !> Receives the states.
      type(states_t), intent(inout) :: states
      integer :: i

      if (.not. allocated(states%rows)) allocate (states%rows(size(surface%rows)))
      do i = 1, size(surface%rows)
         if (is_free) then
            call start_from_free(states%rows(i), surface%rows(i), depth)
         else
            call start_from_below(states%rows(i), surface%rows(i), surface%law, depth)
         end if
      end do
   end subroutine start

   !> The least states.
   subroutine find_least(surface, depth, states)
      !> The surface.
      type(march_surface_t), intent(in) :: surface
      !> Penetration.
      real(dp), intent(in) :: depth
      !> In: states below. Out: the least states.
      type(states_t), intent(inout) :: states
      integer :: i

      !$omp parallel do schedule(dynamic) if (size(surface%rows) > 1)
      do i = 1, size(surface%rows)
         call find_adhered(states%rows(i), surface%rows(i), surface%law, depth)
      end do
      !$omp end parallel do
      call sum_up(depth, states)
   end subroutine find_least

   !> The greatest states.
   subroutine find_greatest(surface, depth, states, least)
      !> The surface.
      type(march_surface_t), intent(in) :: surface
      !> Penetration.
      real(dp), intent(in) :: depth
      !> In: states above. Out: the greatest states.
      type(states_t), intent(inout) :: states
      !> In: states below. Out: the least states.
      type(states_t), intent(inout) :: least
      integer :: i

      !$omp parallel do schedule(dynamic) if (size(surface%rows) > 1)
      do i = 1, size(surface%rows)
         call find_approach(states%rows(i), least%rows(i), surface%rows(i), surface%law, depth)
      end do
      !$omp end parallel do
      call sum_up(depth, states)
   end subroutine find_greatest

   !> Sums over rows.
   pure subroutine sum_up(depth, states)
      !> Penetration.
      real(dp), intent(in) :: depth
      !> The states; receives the sums.
      type(states_t), intent(inout) :: states
      integer :: i

      states%load = 0
      states%slope = 0
      states%least_load = 0
      states%are_steady = .true.
      states%have_failed = .false.
      do i = 1, size(states%rows)
         associate (row => states%rows(i), weight => 1/real(size(states%rows), dp))
            states%load = states%load + weight*row%load
            states%slope = states%slope + weight*row%load_slope
            states%least_load = states%least_load + weight*round_off*sum(abs(row%period%zones(:row%period%n_zones)%load))
            states%are_steady = states%are_steady .and. row%is_steady
            states%have_failed = states%have_failed .or. row%has_failed .or. row%n_periods > most_periods
         end associate
      end do
      states%least_load = states%least_load + round_off*abs(depth)*states%slope
      states%are_steady = states%are_steady .and. .not. states%have_failed
   end subroutine sum_up

   !> The largest penetration that carries a load. States and penetration go on together: a state that is not yet steady is below
   !> the least one, carries less and touches more, so steps are shorter and pass nothing.
   subroutine search_downwards(surface, load, depth, states, status)
      !> The surface.
      type(march_surface_t), intent(in) :: surface
      !> Mean load of the rows.
      real(dp), intent(in) :: load
      !> Receives the penetration.
      real(dp), intent(out) :: depth
      !> Receives the states.
      type(states_t), intent(inout) :: states
      !> Receives how the search ended.
      integer, intent(out) :: status
      real(dp) :: change
      integer :: i, k

      depth = largest_depth(surface, load)
      call start(surface, depth, .false., states)
      status = march_failed
      do k = 1, most_penetrations
         !$omp parallel do schedule(dynamic) if (size(surface%rows) > 1)
         do i = 1, size(surface%rows)
            call take_step(states%rows(i), surface%rows(i), surface%law, depth)
         end do
         !$omp end parallel do
         call sum_up(depth, states)
         if (states%have_failed) return
         change = load - states%load
         if (states%are_steady .and. abs(change) <= states%least_load + round_off*abs(load)) then
            status = march_solved
            return
         end if
         if (change < 0) then
            if (.not. states%slope > 0) then
               ! nothing touches: no smaller penetration carries less
               status = march_no_equilibrium
               return
            end if
            change = change/states%slope
         else
            change = 0
         end if
         if (states%are_steady .and. abs(change) <= round_off*(1 + abs(depth))) then
            status = march_solved
            return
         end if
         depth = depth + change
         do i = 1, size(surface%rows)
            call move(states%rows(i))
            if (surface%law%stress > 0) then
               states%rows(i)%state%length = states%rows(i)%state%length + change
            else
               states%rows(i)%state%length = states%rows(i)%state%length + change*states%rows(i)%response
            end if
         end do
      end do
   end subroutine search_downwards

   !> The smallest penetration that carries a load, after the surface has been drawn in.
   subroutine search_upwards(surface, load, depth, states, status)
      !> The surface.
      type(march_surface_t), intent(in) :: surface
      !> Mean load of the rows.
      real(dp), intent(in) :: load
      !> Receives the penetration.
      real(dp), intent(out) :: depth
      !> Receives the states.
      type(states_t), intent(inout) :: states
      !> Receives how the search ended.
      integer, intent(out) :: status
      type(states_t) :: beyond, least, least_here
      real(dp) :: limit, slope, step, guess, last_depth, last_load
      integer :: k

      status = march_failed
      limit = largest_depth(surface, load)
      depth = -surface%law%attach_gap + drawn_in*(1 + surface%law%attach_gap)
      call start(surface, depth, .true., states)
      call start(surface, depth, .false., least_here)
      call find_greatest(surface, depth, states, least_here)
      if (states%have_failed) return
      if (states%load > load) then
         ! a tension: there is a state if there is a last one, and one before it if the load falls below it once more
         call find_last_state(surface, load, limit, beyond, status)
         if (status /= march_solved) return
         status = march_failed
         call scan_for_fall(surface, load, limit, depth, states)
         if (states%have_failed) return
         if (states%load > load) then
            depth = limit
            call move_alloc(beyond%rows, states%rows)
            status = march_solved
            return
         end if
      end if
      if (limit <= depth) then
         status = march_no_equilibrium
         return
      end if
      slope = 1
      call start(surface, limit, .false., least)
      call find_least(surface, limit, least)
      last_depth = depth
      last_load = states%load
      do k = 1, most_penetrations
         if (states%have_failed .or. least%have_failed) return
         step = (load - states%load)/slope
         ! the penetration has met one that carries the load or more
         if (step <= round_off*(1 + abs(depth)) .or. depth >= limit .or. &
            & load - states%load <= states%least_load + round_off*abs(load)) then
            status = march_solved
            return
         end if
         if (k > 1 .and. states%load > last_load) then
            ! a penetration that may be just beyond the state tells the slope that bounds the next steps
            guess = depth + 1.1_dp*(load - states%load)*(depth - last_depth)/(states%load - last_load)
            if (guess < limit) then
               beyond = states
               call shift(beyond, guess - depth)
               least_here = least
               call shift(least_here, guess - limit)
               call find_greatest(surface, guess, beyond, least_here)
               if (beyond%have_failed) return
               if (beyond%load >= load) then
                  limit = guess
                  slope = min(slope, beyond%slope)
                  least = least_here
                  step = (load - states%load)/slope
               end if
            end if
         end if
         last_depth = depth
         last_load = states%load
         depth = min(limit, depth + step)
         call shift(states, depth - last_depth)
         least_here = least
         call shift(least_here, depth - limit)
         call find_greatest(surface, depth, states, least_here)
      end do
   end subroutine search_upwards

   !> The largest penetration at which the greatest state carries a load: steps of the excess over the slope pass none.
   subroutine find_last_state(surface, load, depth, states, status)
      !> The surface.
      type(march_surface_t), intent(in) :: surface
      !> Mean load of the rows.
      real(dp), intent(in) :: load
      !> In: a penetration beyond which none carries the load. Out: the last one that does, if there is one.
      real(dp), intent(inout) :: depth
      !> Receives the greatest states there.
      type(states_t), intent(inout) :: states
      !> Receives how the search ended.
      integer, intent(out) :: status
      type(states_t) :: least
      real(dp) :: step
      integer :: k

      status = march_failed
      do k = 1, most_penetrations
         call start(surface, depth, .true., states)
         call start(surface, depth, .false., least)
         call find_greatest(surface, depth, states, least)
         if (states%have_failed) return
         if (.not. states%slope > 0 .and. states%load > load) then
            ! nothing touches: no smaller penetration carries less
            status = march_no_equilibrium
            return
         end if
         step = 0
         if (states%slope > 0) step = (states%load - load)/states%slope
         if (states%load - load <= states%least_load + round_off*abs(load) .or. step <= round_off*(1 + abs(depth))) then
            status = march_solved
            return
         end if
         depth = depth - step
      end do
   end subroutine find_last_state

   !> Look for a penetration that carries no more than a load, behind the draw-in that carries more: for tensions alone. The load may
   !> fall anywhere, where adhesion takes hold, so a fall and rise within one step of the scan is not seen.
   subroutine scan_for_fall(surface, load, limit, depth, states)
      !> The surface.
      type(march_surface_t), intent(in) :: surface
      !> Mean load of the rows.
      real(dp), intent(in) :: load
      !> Penetration beyond which nothing is sought.
      real(dp), intent(in) :: limit
      !> In: where the surface has been drawn in. Out: a penetration that carries no more than the load, if there is one.
      real(dp), intent(inout) :: depth
      !> In: the greatest states there. Out: those of the last penetration that was looked at.
      type(states_t), intent(inout) :: states
      type(states_t) :: least
      real(dp) :: step
      integer :: k

      step = (limit - depth)/steps_of_scan
      if (.not. step > 0) return
      do k = 1, steps_of_scan
         depth = depth + step
         call shift(states, step)
         call start(surface, depth, .false., least)
         call find_greatest(surface, depth, states, least)
         if (states%have_failed .or. states%load <= load) return
      end do
   end subroutine scan_for_fall

   !> Move states with the heights.
   pure subroutine shift(states, change)
      !> The states.
      type(states_t), intent(inout) :: states
      !> Change of the penetration.
      real(dp), intent(in) :: change
      integer :: i

      do i = 1, size(states%rows)
         states%rows(i)%state%length = states%rows(i)%state%length + change
      end do
   end subroutine shift

   !> Hand over what was found.
   subroutine finish(surface, depth, states, status, equilibrium)
      !> The surface.
      type(march_surface_t), intent(in) :: surface
      !> Penetration.
      real(dp), intent(in) :: depth
      !> The states, which are moved away.
      type(states_t), intent(inout) :: states
      !> How the search ended.
      integer, intent(in) :: status
      !> Receives states and forces.
      type(march_equilibrium_t), intent(inout) :: equilibrium
      integer :: i

      equilibrium%depth = depth
      equilibrium%status = status
      equilibrium%n_periods = sum(states%rows%n_periods)
      call move_alloc(states%rows, equilibrium%rows)
      allocate (equilibrium%forces(size(surface%rows)))
      if (status /= march_solved) return
      !$omp parallel do schedule(dynamic) if (size(surface%rows) > 1)
      do i = 1, size(surface%rows)
         call get_march_forces(surface%rows(i), surface%law, depth, equilibrium%rows(i)%period, equilibrium%forces(i))
         ! with the last step, which is round-off; without contact the load is known to the last digit
         if (equilibrium%forces(i)%n_contacts > 0) equilibrium%forces(i)%load = equilibrium%rows(i)%load
      end do
      !$omp end parallel do
   end subroutine finish

end module adfric_wavy_march_equilibrium
