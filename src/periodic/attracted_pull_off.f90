! SPDX-License-Identifier: GPL-3.0-or-later
!> Pull-off of a periodic surface whose cells attract each other by any falling law: the least mean pressure that a state of the adhered
!> branch carries, on the finest grid.
!>
!> A state at a load bounds the states of all lower ones, so the search goes down from state to state. Loads with a state and without one
!> are brought together to `beyond`; a load without one is certain, since a bound shows it. Near the fold the load is a parabola
!> over the mean gap: the lowest point of that through three states is the pull-off, and states are sought ever nearer to it.
module adfric_periodic_attracted_pull_off
   use adfric_base_kinds, only: dp
   use adfric_periodic_attracted_contact, only: solve_attracted_contact
   use adfric_periodic_attracted_surface, only: periodic_attraction_t
   use adfric_periodic_attraction_cells, only: attraction_cells_t
   use adfric_periodic_contact, only: contact_state_t
   use adfric_periodic_solver, only: periodic_solver_t
   implicit none (type, external)
   private
   public :: find_attracted_pull_off

   !> Relative distance of a load with a state from one without; relative error that is small enough.
   real(dp), parameter :: beyond = 1.0e-2_dp, wanted_error = 1.0e-5_dp
   !> Part of the way from a state to the lowest point that the next state leaves.
   real(dp), parameter :: left = 0.1_dp
   !> Part of the largest tension below which a pull-off is none.
   real(dp), parameter :: least_part = 1.0e-6_dp
   !> Loads that are tried at most.
   integer, parameter :: most_loads = 40

   !> The last three states on the way down, the lowest load first.
   type :: descent_t
      integer :: n = 0
      !> Mean gaps and loads [E*].
      real(dp) :: gaps(3) = 0, loads(3) = 0
   end type descent_t

contains

   !> Find the pull-off.
   subroutine find_attracted_pull_off(solver, shape, attraction, tolerance, pull_off, is_found)
      type(periodic_solver_t), intent(inout) :: solver
      !> Gap of the undeformed surfaces in the middles of the cells; 0 at first touch, and no less.
      real(dp), intent(in) :: shape(:, :)
      !> The law; the branch is the adhered one, or the one after the turn.
      type(periodic_attraction_t), intent(in) :: attraction
      real(dp), intent(in) :: tolerance
      !> Mean pressure [E*], at most 0.
      real(dp), intent(out) :: pull_off
      logical, intent(out) :: is_found
      type(attraction_cells_t) :: cells
      type(contact_state_t) :: state
      type(descent_t) :: path
      real(dp), allocatable :: start(:, :)
      real(dp) :: load, lowest, without, fold, largest
      integer :: k
      logical :: has_state

      cells%law = attraction%law
      if (allocated(attraction%part)) cells%part = attraction%part
      pull_off = 0
      is_found = .false.
      allocate (start, source=0*shape)
      associate (operator => solver%grids(size(solver%grids))%operator)
         if (attraction%has_turned) then
            state%shape = shape
            state%mean_pressure = attraction%turning_pressure
            call solve_attracted_contact(state, operator, cells, tolerance, .true., .false., has_state)
            if (.not. (has_state .and. state%is_converged)) return
            start(:, :) = state%gap
         end if
         ! no state carries more than the whole tension
         largest = sum(cells%tension(start))/size(start)
         without = -largest*(1 + wanted_error)
         lowest = huge(lowest)
         load = 0
         do k = 1, most_loads
            state = contact_state_t()
            state%shape = shape
            state%mean_pressure = load
            call solve_attracted_contact(state, operator, cells, tolerance, .false., .false., has_state, start)
            if (operator%is_stopped()) return
            if (.not. has_state) then
               without = max(without, load)
            else if (state%is_converged) then
               start(:, :) = state%gap
               lowest = load
               call add(path, sum(state%gap)/size(state%gap), load)
            else
               return
            end if
            ! nothing pulls
            if (lowest > 0) exit
            fold = lowest_load(path)
            is_found = lowest - without <= 1.1_dp*beyond*abs(lowest) .or. abs(without) <= least_part*largest
            if (is_found .and. fold > without .and. fold <= lowest) then
               pull_off = fold
               if (lowest - fold <= wanted_error*abs(lowest)) return
               load = fold + left*(lowest - fold)
            else if (is_found) then
               pull_off = lowest
               if (lowest - without <= wanted_error*abs(lowest)) return
               load = (lowest + without)/2
            else if (lowest - without > abs(lowest)) then
               load = merge(without*(1 - wanted_error/2), without/2, k == 1)
            else
               load = (lowest + without)/2
            end if
         end do
      end associate
   end subroutine find_attracted_pull_off

   !> Take a state of a load that is lower than those before.
   pure subroutine add(path, gap, load)
      type(descent_t), intent(inout) :: path
      !> Mean gap and load [E*].
      real(dp), intent(in) :: gap, load

      path%gaps(2:) = path%gaps(:2)
      path%loads(2:) = path%loads(:2)
      path%gaps(1) = gap
      path%loads(1) = load
      path%n = path%n + 1
   end subroutine add

   !> Load at the lowest point of the parabola through three states, beyond the last one; above all loads where there is none.
   pure real(dp) function lowest_load(path) result(load)
      type(descent_t), intent(in) :: path
      real(dp) :: slopes(2), curvature, slope

      load = huge(load)
      if (path%n < 3) return
      if (.not. (path%gaps(1) > path%gaps(2) .and. path%gaps(2) > path%gaps(3))) return
      slopes = (path%loads(2:) - path%loads(:2))/(path%gaps(2:) - path%gaps(:2))
      curvature = (slopes(1) - slopes(2))/(path%gaps(1) - path%gaps(3))
      if (.not. curvature > 0) return
      ! at the last state
      slope = slopes(1) + curvature*(path%gaps(1) - path%gaps(2))
      if (slope > 0) return
      load = path%loads(1) - slope**2/(4*curvature)
   end function lowest_load

end module adfric_periodic_attracted_pull_off
