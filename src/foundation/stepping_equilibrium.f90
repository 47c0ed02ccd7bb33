! SPDX-License-Identifier: GPL-3.0-or-later
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
module adfric_foundation_stepping_equilibrium
   use adfric_base_kinds, only: dp
   use adfric_foundation_stepping_approach_search, only: search_upwards
   use adfric_foundation_stepping_forces, only: stepping_forces_t, get_stepping_forces
   use adfric_foundation_stepping_states, only: stepping_surface_t, stepping_states_t, start, find_extreme, is_shared, sum_up, &
      & largest_depth, stepping_solved, stepping_no_equilibrium, stepping_failed, round_off
   use adfric_foundation_stepping_steady_column, only: steady_column_t, take_step, move
   implicit none (type, external)
   private
   public :: stepping_surface_t, stepping_equilibrium_t, find_at_penetration, find_at_load
   public :: stepping_solved, stepping_no_equilibrium, stepping_failed

   !> Most penetrations that one search looks at.
   integer, parameter :: most_penetrations = 2000

   !> An equilibrium.
   type :: stepping_equilibrium_t
      !> How it was found, one of `stepping_...`.
      integer :: status = stepping_failed
      !> Penetration of the highest position.
      real(dp) :: depth = 0
      !> States of the rows.
      type(steady_column_t), allocatable :: rows(:)
      !> Forces of the rows.
      type(stepping_forces_t), allocatable :: forces(:)
      !> Number of periods stepped.
      integer :: n_periods = 0
   end type stepping_equilibrium_t

contains

   !> The equilibrium under a penetration.
   subroutine find_at_penetration(surface, depth, equilibrium)
      type(stepping_surface_t), intent(in) :: surface
      real(dp), intent(in) :: depth
      type(stepping_equilibrium_t), intent(out) :: equilibrium
      type(stepping_states_t) :: states

      if (surface%is_approach) then
         call start(surface, depth, .true., states)
         call find_extreme(surface, depth, .false., states)
      else
         call start(surface, depth, .false., states)
         call find_extreme(surface, depth, .true., states)
      end if
      call finish(surface, depth, states, merge(stepping_solved, stepping_failed, states%are_steady), equilibrium)
   end subroutine find_at_penetration

   !> The equilibrium under a load.
   subroutine find_at_load(surface, load, equilibrium)
      type(stepping_surface_t), intent(in) :: surface
      real(dp), intent(in) :: load
      type(stepping_equilibrium_t), intent(out) :: equilibrium
      type(stepping_states_t) :: states
      real(dp) :: depth
      integer :: status

      if (surface%is_approach .and. surface%law%stress > 0) then
         call search_upwards(surface, load, depth, states, status)
      else if (.not. (surface%law%stress > 0 .or. load > 0)) then
         call start_at_touch(surface, depth, states)
         status = merge(stepping_no_equilibrium, stepping_solved, load < 0)
      else
         call search_downwards(surface, load, depth, states, status)
      end if
      call finish(surface, depth, states, status, equilibrium)
   end subroutine find_at_load

   !> Without adhesion nothing is carried up to the penetration 0, at which the surface touches, and more beyond.
   subroutine start_at_touch(surface, depth, states)
      type(stepping_surface_t), intent(in) :: surface
      real(dp), intent(out) :: depth
      type(stepping_states_t), intent(inout) :: states
      integer :: i

      depth = 0
      call start(surface, depth, .true., states)
      do i = 1, size(surface%rows)
         states%rows(i)%state%length = 0
         call take_step(states%rows(i), surface%rows(i), surface%law, depth)
      end do
      call sum_up(depth, states)
   end subroutine start_at_touch

   !> The largest penetration that carries a load. States and penetration go on together: a state that is not yet steady is below
   !> the least one, carries less and touches more, so steps are shorter and pass nothing.
   subroutine search_downwards(surface, load, depth, states, status)
      type(stepping_surface_t), intent(in) :: surface
      real(dp), intent(in) :: load
      real(dp), intent(out) :: depth
      type(stepping_states_t), intent(inout) :: states
      !> Receives how the search ended.
      integer, intent(out) :: status
      real(dp) :: change
      integer :: i, k

      depth = largest_depth(surface, load)
      call start(surface, depth, .false., states)
      status = stepping_failed
      do k = 1, most_penetrations
         !$omp parallel do schedule(dynamic) if (is_shared(surface))
         do i = 1, size(surface%rows)
            call take_step(states%rows(i), surface%rows(i), surface%law, depth)
         end do
         !$omp end parallel do
         call sum_up(depth, states)
         if (states%have_failed) return
         change = load - states%load
         if (states%are_steady .and. abs(change) <= states%least_load + round_off*abs(load) + surface%law%resolution) then
            status = stepping_solved
            return
         end if
         if (change < 0) then
            if (.not. states%slope > 0) then
               ! nothing touches: no smaller penetration carries less
               status = stepping_no_equilibrium
               return
            end if
            change = change/states%slope
         else
            change = 0
         end if
         if (states%are_steady .and. abs(change) <= round_off*(1 + abs(depth)) + surface%law%resolution) then
            status = stepping_solved
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

   !> Hand over what was found.
   subroutine finish(surface, depth, states, status, equilibrium)
      type(stepping_surface_t), intent(in) :: surface
      real(dp), intent(in) :: depth
      !> The states, which are moved away.
      type(stepping_states_t), intent(inout) :: states
      !> How the search ended.
      integer, intent(in) :: status
      type(stepping_equilibrium_t), intent(inout) :: equilibrium
      integer :: i

      equilibrium%depth = depth
      equilibrium%status = status
      equilibrium%n_periods = sum(states%rows%n_periods)
      call move_alloc(states%rows, equilibrium%rows)
      allocate (equilibrium%forces(size(surface%rows)))
      if (status /= stepping_solved) return
      !$omp parallel do schedule(dynamic) if (is_shared(surface))
      do i = 1, size(surface%rows)
         call get_stepping_forces(surface%rows(i), surface%law, depth, equilibrium%rows(i)%period, equilibrium%forces(i))
         ! with the last step, which is round-off; without contact the load is known to the last digit
         if (equilibrium%forces(i)%n_contacts > 0) equilibrium%forces(i)%load = equilibrium%rows(i)%load
      end do
      !$omp end parallel do
   end subroutine finish

end module adfric_foundation_stepping_equilibrium
