! SPDX-License-Identifier: GPL-3.0-or-later
!> Pull-off of an adhesive periodic surface: the least mean pressure that a state of the branch carries.
!>
!> At a load a branch has a state or it has none, and it has one at every load above one where it has (`adfric_periodic_adhesive_contact`). So
!> tensions from the stress sigma0, which no state carries more than, are halved until there is a state. From there the mean gap is opened
!> step by step, with Newton's method: at a given mean gap the load is what is found, and a fold of the load is only its lowest
!> point. The lowest point of a parabola through three states leads there. That it is the pull-off, and not only a jump to another
!> state, is seen at a load a little below, where the branch has no state then; where it has one, the search goes on from that. Where no
!> such path is found, loads between the last one with a state and the first one without are halved.
module adfric_periodic_adhesive_pull_off
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_periodic_adhesive_contact, only: find_state
   use adfric_periodic_adhesive_solver, only: periodic_adhesion_t, solve_adhesive_state
   use adfric_periodic_contact, only: contact_state_t
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, contact_solved, contact_out_of_range
   implicit none (type, external)
   private
   public :: periodic_pull_off_t, find_pull_off

   !> Pull-off.
   type :: periodic_pull_off_t
      !> Mean pressure [E*], at most 0.
      real(dp) :: mean_pressure = 0
      !> Penetration of the state there.
      real(dp) :: penetration = 0
      !> Applied operators, see `periodic_solution_t`.
      real(dp) :: n_pairs = 0
      !> Has it been found?
      logical :: is_found = .false.
      !> How far below the load is that has no state, relative to it: what the search leaves open.
      real(dp) :: margin = 0
   contains
      procedure :: error_beside
   end type periodic_pull_off_t

   !> Relative error that is small enough, and by how much more a tension is that must have no state.
   real(dp), parameter :: wanted_error = 1.0e-5_dp, beyond = 1.0e-2_dp
   !> The most that it may be more, where rounds of a load nearer to it do not end, and the least, which is tried where they do: rough
   !> surfaces have several folds within `beyond`.
   real(dp), parameter :: farthest = 8*beyond, nearest = 1.0e-3_dp
   !> Loads and steps that are tried at most.
   integer, parameter :: most_loads = 40, most_steps = 60
   !> Attempts of Newton's method between states that enclose the lowest one, at most, but for one.
   integer, parameter :: most_failures = 5
   !> Change from the grid of half the cells that counts as error: an error that falls with the size of the cells is the change itself, and
   !> of rough surfaces it may be twice as much (`bench/run error_estimates`).
   real(dp), parameter :: safety = 2.5_dp
   !> Part of the stress below which a pull-off is none.
   real(dp), parameter :: least_part = 1.0e-6_dp
   !> The first step of the mean gap, in units of the range of the undeformed gap, the growth of the next, and the smallest one.
   real(dp), parameter :: first_step = 2.0e-3_dp, growth = 1.6_dp, least_step = 1.0e-7_dp

   !> The last three states on the way down.
   type :: pull_off_path_t
      !> How many there are.
      integer :: n = 0
      !> Mean gaps and loads [E*].
      real(dp) :: gaps(3) = 0, loads(3) = 0
   end type pull_off_path_t

contains

   !> Find the pull-off of a branch.
   subroutine find_pull_off(solver, shape, adhesion, tolerance, pull_off, error)
      type(periodic_solver_t), intent(inout) :: solver
      !> Gap of the undeformed surfaces in the middles of the cells; 0 at first touch, and no less.
      real(dp), intent(in) :: shape(:, :)
      !> The law; the branch is the adhered one, or the one after the turn.
      type(periodic_adhesion_t), intent(in) :: adhesion
      real(dp), intent(in) :: tolerance
      type(periodic_pull_off_t), intent(out) :: pull_off
      type(error_t), allocatable, intent(out) :: error
      type(periodic_adhesion_t) :: branch
      type(periodic_solution_t) :: solution
      type(contact_state_t) :: state
      type(contact_state_t), allocatable :: turned(:), last
      real(dp) :: load, without, reach
      logical :: is_near, is_lost
      integer :: k

      branch = adhesion
      branch%is_adhered = .true.
      without = -adhesion%stress*(1 + wanted_error)
      load = -adhesion%stress*(1 - wanted_error)
      pull_off%mean_pressure = 0
      reach = beyond
      is_lost = .false.
      do k = 1, most_loads
         if (solver%grids(size(solver%grids))%operator%is_stopped()) return
         if (allocated(last)) then
            call solve_adhesive_state(solver, shape, load, branch, tolerance, turned, state, solution, error, last)
         else
            call solve_adhesive_state(solver, shape, load, branch, tolerance, turned, state, solution, error)
         end if
         if (allocated(error)) return
         pull_off%n_pairs = pull_off%n_pairs + solution%n_pairs
         if (solution%status == contact_out_of_range) then
            without = load
         else if (solution%status == contact_solved) then
            if (.not. pull_off%is_found) reach = beyond
            ! it bounds the states of all loads below
            last = state
            pull_off%mean_pressure = load
            pull_off%penetration = sum(shape - state%gap)/size(shape)
            if (any(state%is_open)) call go_down(solver, state, tolerance, pull_off)
            is_lost = .not. pull_off%mean_pressure < load
         else if (pull_off%is_found) then
            ! rounds nearer to a fold than `beyond` do not end: it stays found
            return
         else if (pull_off%mean_pressure < 0 .and. reach < farthest) then
            ! next to a fold rounds take long
            reach = 2*reach
            is_lost = .false.
         else if (pull_off%mean_pressure < 0 .or. k == most_loads) then
            return
         end if
         if (pull_off%mean_pressure < 0) pull_off%margin = (pull_off%mean_pressure - without)/abs(pull_off%mean_pressure)
         is_near = pull_off%mean_pressure - without <= max(1.1_dp*reach*abs(pull_off%mean_pressure), least_part*adhesion%stress)
         pull_off%is_found = pull_off%is_found .or. is_near
         if (is_near) then
            if (reach > beyond .or. reach <= nearest .or. abs(without) <= least_part*adhesion%stress) return
            reach = nearest
         end if
         if (is_lost) then
            ! where no path leads down the interval is halved
            load = (pull_off%mean_pressure + without)/2
         else if (pull_off%mean_pressure < 0) then
            load = max((1 + reach)*pull_off%mean_pressure, (pull_off%mean_pressure + without)/2)
         else if (solution%status == contact_out_of_range) then
            load = without/2
         else
            load = load/2
         end if
      end do
   end subroutine find_pull_off

   !> Relative error of a pull-off: what cells leave of it, and what its search leaves open. It is 1 where half the cells have none.
   pure real(dp) function error_beside(self, of_half) result(error)
      class(periodic_pull_off_t), intent(in) :: self
      !> The pull-off of the grid of half the cells.
      type(periodic_pull_off_t), intent(in) :: of_half
      real(dp) :: change

      error = 1
      if (.not. of_half%is_found) return
      change = safety*abs(of_half%mean_pressure - self%mean_pressure)
      error = self%margin
      if (change > 0) error = max(error, change/max(change, abs(self%mean_pressure)))
   end function error_beside

   !> Open the mean gap from a state, to the lowest load on the way.
   subroutine go_down(solver, state, tolerance, pull_off)
      type(periodic_solver_t), intent(inout) :: solver
      !> In: the state. Out: one next to the lowest load.
      type(contact_state_t), intent(inout) :: state
      real(dp), intent(in) :: tolerance
      !> Receives the lowest load; keeps what it has where there is none.
      type(periodic_pull_off_t), intent(inout) :: pull_off
      type(contact_state_t) :: next, lowest
      type(pull_off_path_t) :: path
      real(dp) :: step, shortest, gap
      logical :: has_found
      integer :: k, n_before, n_failed

      state%has_fixed_mean = .true.
      call add(path, sum(state%gap)/size(state%gap), state%mean_pressure)
      step = first_step*(maxval(state%shape) - minval(state%shape))
      shortest = least_step*(maxval(state%shape) - minval(state%shape))
      lowest = state
      n_failed = 0
      associate (grid => solver%grids(size(solver%grids)))
         n_before = grid%operator%n_applied
         do k = 1, most_steps
            if (grid%operator%is_stopped()) exit
            gap = path%gaps(path%n) + step
            if (has_bracket(path)) then
               gap = lowest_position(path)
               ! nearer to the lowest state, and from it, where Newton's method has gone astray
               gap = path%gaps(2) + (gap - path%gaps(2))/2**n_failed
               if (n_failed > 0) state = lowest
            end if
            ! nothing lies between states that are one but for round-off
            if (any(abs(gap - path%gaps(:path%n)) <= shortest)) exit
            next = state
            next%mean_gap = gap
            call find_state(next, grid%operator, grid%gap_solver, tolerance, has_found)
            if (has_found) then
               state = next
               call add(path, gap, next%mean_pressure)
               if (next%mean_pressure < pull_off%mean_pressure) then
                  pull_off%penetration = sum(next%shape - next%gap)/size(next%gap)
                  pull_off%mean_pressure = next%mean_pressure
                  lowest = next
               end if
               step = growth*step
               n_failed = 0
               if (is_lowest(path)) exit
            else
               step = step/4
               n_failed = n_failed + 1
               if (merge(n_failed > most_failures, step < shortest, has_bracket(path))) exit
            end if
         end do
         pull_off%n_pairs = pull_off%n_pairs + grid%operator%n_applied - n_before
      end associate
   end subroutine go_down

   !> Keep three states: the lowest load and those beside it, or the last ones.
   pure subroutine add(path, gap, load)
      !> States that have been found, by rising gap.
      type(pull_off_path_t), intent(inout) :: path
      !> Mean gap and load of one more [E*].
      real(dp), intent(in) :: gap, load
      real(dp) :: gaps(4), loads(4)
      integer :: position, first

      position = count(path%gaps(:path%n) < gap)
      gaps(:path%n + 1) = [path%gaps(:position), gap, path%gaps(position + 1:path%n)]
      loads(:path%n + 1) = [path%loads(:position), load, path%loads(position + 1:path%n)]
      path%n = path%n + 1
      first = 1
      if (path%n > 3) then
         path%n = 3
         first = max(1, min(minloc(loads, 1) - 1, 2))
      end if
      path%gaps(:path%n) = gaps(first:first + path%n - 1)
      path%loads(:path%n) = loads(first:first + path%n - 1)
   end subroutine add

   !> Is the middle one of three states the lowest?
   pure logical function has_bracket(path)
      type(pull_off_path_t), intent(in) :: path

      has_bracket = path%n == 3 .and. minloc(path%loads, 1) == 2
   end function has_bracket

   !> Mean gap at the lowest point of the parabola through three states, between the outer ones and apart from the middle one.
   pure real(dp) function lowest_position(path) result(gap)
      !> States of which the middle one is the lowest.
      type(pull_off_path_t), intent(in) :: path
      real(dp) :: slopes(2), least

      slopes = (path%loads(2:) - path%loads(:2))/(path%gaps(2:) - path%gaps(:2))
      gap = (path%gaps(1) + path%gaps(2))/2 - slopes(1)*(path%gaps(3) - path%gaps(1))/(2*(slopes(2) - slopes(1)))
      least = (path%gaps(3) - path%gaps(1))/50
      if (abs(gap - path%gaps(2)) < least) gap = path%gaps(2) + merge(least, -least, &
         & path%gaps(3) - path%gaps(2) > path%gaps(2) - path%gaps(1))
   end function lowest_position

   !> Is the parabola through three states nowhere lower than the lowest of them, but for the wanted error?
   pure logical function is_lowest(path)
      type(pull_off_path_t), intent(in) :: path
      real(dp) :: slopes(2), curvature, slope

      is_lowest = .false.
      if (.not. has_bracket(path)) return
      slopes = (path%loads(2:) - path%loads(:2))/(path%gaps(2:) - path%gaps(:2))
      curvature = (slopes(2) - slopes(1))/(path%gaps(3) - path%gaps(1))
      slope = slopes(1) + curvature*(path%gaps(2) - path%gaps(1))
      is_lowest = slope**2/(4*curvature) <= wanted_error*abs(path%loads(2)) &
         & .and. maxval(path%loads) - path%loads(2) <= 100*wanted_error*abs(path%loads(2))
   end function is_lowest

end module adfric_periodic_adhesive_pull_off
