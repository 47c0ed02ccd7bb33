! SPDX-License-Identifier: GPL-3.0-or-later
!> Pull-off of a periodic surface whose cells attract each other by any law: the least mean pressure that a state of the adhered
!> branch carries, on the finest grid.
!>
!> A state at a load bounds the states of all lower ones, so the search goes down from state to state, halving the interval between the
!> lowest load with a state and the highest without one. A load without one is certain, since a bound shows it. Close to the fold a
!> bound goes slowly, and a load may remain undecided: the search goes on above it. The pull-off is the lowest load with a state. It is
!> found where a load without one lies no more than `beyond` below.
module adfric_periodic_attracted_pull_off
   use adfric_base_kinds, only: dp
   use adfric_periodic_adhesive_pull_off, only: periodic_pull_off_t
   use adfric_periodic_attracted_contact, only: solve_attracted_contact
   use adfric_periodic_attracted_surface, only: periodic_attraction_t
   use adfric_periodic_attraction_cells, only: attraction_cells_t
   use adfric_periodic_contact, only: contact_state_t
   use adfric_periodic_solver, only: periodic_solver_t
   implicit none (type, external)
   private
   public :: find_attracted_pull_off

   !> Relative distance of a load with a state from one without; that from one that is at least not known to have one.
   real(dp), parameter :: beyond = 1.0e-2_dp, wanted_error = 1.0e-4_dp
   !> Part of the largest tension below which a pull-off is none.
   real(dp), parameter :: least_part = 1.0e-6_dp
   !> Loads that are tried at most.
   integer, parameter :: most_loads = 40

contains

   !> Find the pull-off.
   subroutine find_attracted_pull_off(solver, shape, attraction, tolerance, pull_off)
      type(periodic_solver_t), intent(inout) :: solver
      !> Gap of the undeformed surfaces in the middles of the cells; 0 at first touch, and no less.
      real(dp), intent(in) :: shape(:, :)
      !> The law; the branch is the adhered one, or the one after the turn.
      type(periodic_attraction_t), intent(in) :: attraction
      real(dp), intent(in) :: tolerance
      type(periodic_pull_off_t), intent(out) :: pull_off
      type(attraction_cells_t) :: cells
      type(contact_state_t) :: state
      real(dp), allocatable :: start(:, :)
      real(dp) :: load, lowest, undecided, without, largest
      integer :: k
      logical :: has_state

      cells%law = attraction%law
      if (allocated(attraction%part)) cells%part = attraction%part
      associate (operator => solver%grids(size(solver%grids))%operator)
         if (attraction%has_turned) then
            state%shape = shape
            state%mean_pressure = attraction%turning_pressure
            call solve_attracted_contact(state, operator, cells, tolerance, .true., .false., has_state)
            if (.not. (has_state .and. state%is_converged)) return
            start = state%gap
            call cells%open_by(attraction%opening, .not. start > cells%contact_gap())
         else
            call cells%open_by(attraction%opening, .not. shape < 0)
         end if
         ! no state carries more than the whole tension
         if (allocated(start)) then
            largest = sum(cells%tension_beyond(start))/size(start)
         else
            largest = sum(cells%tension_beyond(0*shape))/size(shape)
         end if
         without = -largest*(1 + wanted_error/2)
         undecided = without
         lowest = huge(lowest)
         load = 0
         do k = 1, most_loads
            state = contact_state_t()
            state%shape = shape
            state%mean_pressure = load
            call solve_attracted_contact(state, operator, cells, tolerance, .false., .false., has_state, start)
            if (operator%is_stopped()) return
            if (.not. has_state) then
               without = load
               undecided = max(undecided, load)
            else if (state%is_converged) then
               start = state%gap
               lowest = load
            else
               undecided = load
            end if
            ! nothing pulls
            if (lowest > 0) return
            pull_off%mean_pressure = lowest
            pull_off%margin = (lowest - without)/max(abs(lowest), least_part*largest)
            pull_off%is_found = lowest - without <= beyond*abs(lowest) .or. abs(without) <= least_part*largest
            if (pull_off%is_found .and. lowest - undecided <= wanted_error*abs(lowest)) return
            if (k == 1) then
               load = -largest*(1 - wanted_error/2)
            else if (lowest - undecided <= wanted_error*abs(lowest)) then
               load = (undecided + without)/2
            else if (lowest < 0) then
               load = (lowest + undecided)/2
            else
               load = undecided/2
            end if
         end do
      end associate
   end subroutine find_attracted_pull_off

end module adfric_periodic_attracted_pull_off
