! SPDX-License-Identifier: GPL-3.0-or-later
!> Steady states of all rows of a surface under one penetration.
module adfric_foundation_stepping_states
   use adfric_base_kinds, only: dp
   use adfric_foundation_stepping_approach_state, only: find_approach
   use adfric_foundation_stepping_law, only: stepping_law_t
   use adfric_foundation_stepping_steady_column, only: steady_column_t, find_adhered, start_from_below, start_from_free
   use adfric_foundation_stepping_path, only: column_path_t
   implicit none (type, external)
   private
   public :: stepping_surface_t, stepping_states_t, start, find_extreme, sum_up, shift, largest_depth, is_shared
   public :: stepping_solved, stepping_no_equilibrium, stepping_failed, round_off

   !> How a search ends.
   integer, parameter :: stepping_solved = 0, stepping_no_equilibrium = 1, stepping_failed = 2
   !> Loads and penetrations are known to this share.
   real(dp), parameter :: round_off = 8*epsilon(1.0_dp)
   !> Rows are shared among threads from so many pieces on.
   integer, parameter :: least_shared = 4096
   !> Most periods of a row that one search steps; what takes more is not converged.
   integer, parameter :: most_periods = 10000

   !> A surface at one velocity.
   type :: stepping_surface_t
      !> The rows.
      type(column_path_t), allocatable :: rows(:)
      !> The law of adhesion.
      type(stepping_law_t) :: law
      !> Is the branch the greatest state? Else it is the least.
      logical :: is_approach = .false.
   end type stepping_surface_t

   !> States of all rows at one penetration.
   type :: stepping_states_t
      !> The states.
      type(steady_column_t), allocatable :: rows(:)
      !> Mean load, its change with the penetration, and what round-off makes of the load.
      real(dp) :: load = 0, slope = 0, least_load = 0
      !> Are all rows steady? Has one failed?
      logical :: are_steady = .false., have_failed = .false.
   end type stepping_states_t

contains

   !> A penetration that no state below carries the load at: gaps are not negative, so the load is that of endless contact or more.
   pure real(dp) function largest_depth(surface, load) result(depth)
      type(stepping_surface_t), intent(in) :: surface
      real(dp), intent(in) :: load
      integer :: i

      depth = load
      do i = 1, size(surface%rows)
         depth = depth - surface%rows(i)%mean/size(surface%rows)
      end do
   end function largest_depth

   !> Are there so many pieces of heights that threads share the rows? They lose more by waiting for each other where there are few.
   pure logical function is_shared(surface)
      type(stepping_surface_t), intent(in) :: surface

      is_shared = size(surface%rows) > 1 .and. sum(surface%rows%n) >= least_shared
   end function is_shared

   !> States to start from.
   subroutine start(surface, depth, is_free, states)
      type(stepping_surface_t), intent(in) :: surface
      real(dp), intent(in) :: depth
      !> Above all states that are steady? Else below.
      logical, intent(in) :: is_free
      type(stepping_states_t), intent(inout) :: states
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

   !> The least states, from states below; or the greatest ones, from states above.
   subroutine find_extreme(surface, depth, is_least, states)
      type(stepping_surface_t), intent(in) :: surface
      real(dp), intent(in) :: depth
      logical, intent(in) :: is_least
      type(stepping_states_t), intent(inout) :: states
      integer :: i

      !$omp parallel do schedule(dynamic) if (is_shared(surface))
      do i = 1, size(surface%rows)
         if (is_least) then
            call find_adhered(states%rows(i), surface%rows(i), surface%law, depth)
         else
            call find_approach(states%rows(i), surface%rows(i), surface%law, depth)
         end if
      end do
      !$omp end parallel do
      call sum_up(depth, states)
   end subroutine find_extreme

   !> Sums over rows.
   pure subroutine sum_up(depth, states)
      real(dp), intent(in) :: depth
      type(stepping_states_t), intent(inout) :: states
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
            states%are_steady = states%are_steady .and. row%is_steady
            states%have_failed = states%have_failed .or. row%has_failed .or. row%n_periods > most_periods
            if (allocated(row%period%zones)) then
               states%least_load = states%least_load + weight*round_off*sum(abs(row%period%zones(:row%period%n_zones)%load))
            else
               ! the path of the state below was lost, so that the search for the greatest one ended before its first period
               states%have_failed = .true.
            end if
         end associate
      end do
      states%least_load = states%least_load + round_off*abs(depth)*states%slope
      states%are_steady = states%are_steady .and. .not. states%have_failed
   end subroutine sum_up

   !> Move states with the heights.
   pure subroutine shift(states, change)
      type(stepping_states_t), intent(inout) :: states
      !> Change of the penetration.
      real(dp), intent(in) :: change
      integer :: i

      do i = 1, size(states%rows)
         states%rows(i)%state%length = states%rows(i)%state%length + change
      end do
   end subroutine shift

end module adfric_foundation_stepping_states
