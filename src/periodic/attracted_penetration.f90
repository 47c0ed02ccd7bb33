! SPDX-License-Identifier: GPL-3.0-or-later
!> A periodic surface whose cells attract each other by any law, at a given penetration.
!>
!> Under a load each branch has one state (`adfric_periodic_attracted_contact`), whose penetration D(q) rises with the load q. Any state
!> lies between both under its own load. So no state at a penetration delta has less load than the least one whose most adhered state has
!> D >= delta, and none has more than the largest one whose least adhered state has D <= delta. The branches are
!>
!> - **adhered**: the surfaces part under a load that falls to this least one. Where D is delta there, that state has the least load of
!>   all at delta. Where D jumps over delta, the mean gap is opened slowly from there (`adfric_periodic_attracted_path`).
!> - **loading**: they come together under a load that grows to this largest one, and then the mean gap is closed slowly. Below the
!>   penetration under no load the mean gap is closed from far apart.
!>
!> Loads are tried until one that has passed delta lies near. The state before it is followed to delta. Where the branch under a load
!> a little beyond all loads on this path has passed delta, or has no state, no other load is in question.
module adfric_periodic_attracted_penetration
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_periodic_attracted_contact, only: solve_attracted_contact
   use adfric_periodic_attracted_path, only: attracted_path_t, distance_apart, new_attracted_path
   use adfric_periodic_attracted_surface, only: cells_of_grids, collect_attracted, periodic_attraction_t
   use adfric_periodic_attracted_state, only: find_state_near
   use adfric_periodic_attraction_cells, only: attraction_cells_t
   use adfric_periodic_contact, only: contact_state_t
   use adfric_periodic_gap_path, only: penetration_of
   use adfric_periodic_grids, only: coarsen
   use adfric_periodic_load_window, only: begin_window, beyond, closed, load_window_t, most_attempts, most_looks
   use adfric_periodic_linear_step, only: linear_step_t, new_linear_step
   use adfric_periodic_operator, only: periodic_operator_t
   use adfric_periodic_solver, only: check_shape, coarse_tolerance, contact_not_converged, contact_out_of_range, contact_solved, &
      & grids_for_error, periodic_solution_t, periodic_solver_t
   implicit none (type, external)
   private
   public :: solve_attracted_penetration

   !> Loads that narrow the window before the state is followed, and doublings of a load, at most.
   integer, parameter :: most_narrowing = 6, most_doublings = 60

   !> What is known of the branch under a load.
   type, extends(load_window_t) :: attracted_window_t
      !> Largest residual of a state [-].
      real(dp) :: tolerance = 0
   end type attracted_window_t

contains

   !> Solve at a penetration.
   subroutine solve_attracted_penetration(self, shape, penetration, attraction, tolerance, solution, error)
      !> Grids, operators and workspaces.
      type(periodic_solver_t), intent(inout), target :: self
      !> Gap of the undeformed surfaces in the middles of the cells; 0 at first touch, and no less.
      real(dp), intent(in) :: shape(:, :)
      !> Penetration from first touch at the mean of the deformed surface, in the unit of `shape`; below 0 before it.
      real(dp), intent(in) :: penetration
      !> The law and the branch.
      type(periodic_attraction_t), intent(in) :: attraction
      !> Largest residual that is allowed [-].
      real(dp), intent(in) :: tolerance
      !> The solution; `status` tells how it ended. Out of range: no pressure brings the surfaces so near.
      type(periodic_solution_t), intent(out) :: solution
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      type(attraction_cells_t), allocatable :: cells(:)
      type(attracted_path_t) :: path
      type(attracted_window_t) :: window
      real(dp) :: bare_load
      integer :: n, n_before

      call check_shape(self, shape, error)
      if (allocated(error)) return
      solution%status = contact_out_of_range
      call cells_of_grids(self, attraction, cells)
      n = size(self%grids)
      call begin_window(window, penetration, shape)
      window%tolerance = tolerance
      associate (closest => closed*(maxval(shape) - minval(shape)))
         if (cells(n)%has_wall() .and. .not. sum(shape)/size(shape) - penetration > closest) return
      end associate
      call find_bare_load(self, shape, window, bare_load, solution, error)
      if (allocated(error)) return
      n_before = self%grids(n)%operator%n_applied
      associate (operator => self%grids(n)%operator)
         window%is_adhered = attraction%is_adhered
         if (attraction%is_adhered .and. attraction%has_turned) then
            call begin_at_turn(window, operator, shape, cells(n), attraction)
            solution%status = contact_not_converged
            if (.not. window%is_known) return
         else if (attraction%is_adhered) then
            call cells(n)%open_by(attraction%opening, .not. shape < 0)
         end if
         call new_attracted_path(path, operator, cells(n), shape)
         call open_window(window, operator, shape, path, bare_load)
         if (window%is_known) call search(window, operator, shape, path)
      end associate
      solution%n_applied = self%grids(n)%operator%n_applied - n_before
      solution%n_pairs = solution%n_pairs + solution%n_applied
      solution%status = contact_not_converged
      if (.not. window%state%is_converged) return
      call collect(self, window%state, cells, tolerance, solution)
   end subroutine solve_attracted_penetration

   !> Find the load without adhesion at the penetration; that of full contact where contact is full by then.
   subroutine find_bare_load(self, shape, window, load, solution, error)
      type(periodic_solver_t), intent(inout) :: self
      real(dp), intent(in) :: shape(:, :)
      type(attracted_window_t), intent(in) :: window
      !> Receives the load, >= 0 [E*].
      real(dp), intent(out) :: load
      !> Receives pairs of transforms.
      type(periodic_solution_t), intent(inout) :: solution
      type(error_t), allocatable, intent(out) :: error
      type(periodic_solution_t) :: bare
      real(dp), allocatable :: tension(:, :)

      load = 0
      call self%solve_penetration(shape, window%penetration, max(window%tolerance, coarse_tolerance), bare, error)
      if (allocated(error)) return
      solution%n_pairs = solution%n_pairs + bare%n_pairs
      load = max(bare%mean_pressure, 0.0_dp)
      if (bare%status /= contact_out_of_range) return
      allocate (tension, mold=shape)
      call self%grids(size(self%grids))%operator%apply_stiffness(shape, tension)
      load = maxval(tension)
   end subroutine find_bare_load

   !> After a turn the state is that of loading for penetrations that the turn did not reach, and comes from that of the turn else.
   subroutine begin_at_turn(window, operator, shape, cells, attraction)
      !> Receives the side, and the state of the turn.
      type(attracted_window_t), intent(inout) :: window
      type(periodic_operator_t), intent(inout) :: operator
      real(dp), intent(in) :: shape(:, :)
      !> Attraction of the finest grid; receives what has been in contact at the turn.
      type(attraction_cells_t), intent(inout) :: cells
      type(periodic_attraction_t), intent(in) :: attraction
      type(contact_state_t) :: state

      window%is_adhered = .false.
      call solve_load(window, operator, shape, cells, attraction%turning_pressure, state)
      if (.not. window%is_known) return
      window%is_adhered = penetration_of(state) - window%penetration >= -window%none
      call window%take_note(attraction%turning_pressure, state, allocated(state%gap))
      if (.not. window%is_adhered) return
      window%gap_of_turn = state%gap
      call cells%open_by(attraction%opening, .not. state%gap > cells%contact_gap())
   end subroutine begin_at_turn

   !> Find the extremal state under a load, on the side of the branch; without a gap where there is none.
   subroutine solve_load(window, operator, shape, cells, load, state)
      !> What is known of the branch; receives whether the load has told something.
      type(attracted_window_t), intent(inout) :: window
      type(periodic_operator_t), intent(inout) :: operator
      real(dp), intent(in) :: shape(:, :)
      type(attraction_cells_t), intent(in) :: cells
      !> Mean pressure [E*].
      real(dp), intent(in) :: load
      type(contact_state_t), intent(out) :: state
      real(dp), allocatable :: start(:, :)
      logical :: has_state

      ! without a start it is that of full contact, or of no tension
      if (window%is_adhered .and. allocated(window%gap_of_turn)) start = window%gap_of_turn
      if (window%is_bound_of(load)) start = window%state%gap
      state%shape = shape
      state%mean_pressure = load
      ! a body that is pulled does not come into contact by itself
      has_state = window%is_adhered .or. .not. load < 0
      if (has_state) call solve_attracted_contact(state, operator, cells, window%tolerance, .not. window%is_adhered, .false., &
         & has_state, start)
      window%is_known = state%is_converged .or. .not. has_state
      if (.not. has_state .and. allocated(state%gap)) deallocate (state%gap)
   end subroutine solve_load

   !> Solve under a load, and take note of it.
   subroutine look(window, operator, shape, path, load)
      type(attracted_window_t), intent(inout) :: window
      type(periodic_operator_t), intent(inout) :: operator
      real(dp), intent(in) :: shape(:, :)
      type(attracted_path_t), intent(in) :: path
      real(dp), intent(in) :: load
      type(contact_state_t) :: state

      call solve_load(window, operator, shape, path%cells, load, state)
      call window%take_note(load, state, allocated(state%gap))
   end subroutine look

   !> Find a state that has not passed the penetration, and a load that has.
   subroutine open_window(window, operator, shape, path, bare_load)
      !> In: with the state of a turn. Out: both ends are known.
      type(attracted_window_t), intent(inout) :: window
      type(periodic_operator_t), intent(inout) :: operator
      real(dp), intent(in) :: shape(:, :)
      type(attracted_path_t), intent(inout) :: path
      !> Load at the penetration without adhesion, >= 0 [E*].
      real(dp), intent(in) :: bare_load
      real(dp) :: stress, load
      integer :: k

      stress = path%cells%law%stress
      if (allocated(path%cells%part)) stress = stress*maxval(path%cells%part)
      if (window%is_adhered) then
         ! at a wall no tension is above the stress; without one contact also gives way
         window%passed = merge(bare_load, 0.0_dp, path%cells%has_wall()) - stress
         load = bare_load
         do k = 1, most_doublings
            if (window%has_state) exit
            call look(window, operator, shape, path, load)
            load = 2*max(load, stress)
         end do
         window%passed = min(window%passed, merge(bare_load, 0.0_dp, path%cells%has_wall()) - stress)
         window%has_passed_excess = .false.
      else
         if (.not. window%has_state) call look(window, operator, shape, path, &
            & merge(max(bare_load - stress, 0.0_dp), 0.0_dp, path%cells%has_wall()))
         window%has_passed_excess = .false.
         window%passed = max(bare_load, window%load)
         load = window%passed
         do k = 1, most_doublings
            if (path%cells%has_wall() .or. window%has_passed_excess .or. .not. window%has_state) exit
            call look(window, operator, shape, path, load)
            load = 2*max(load, stress)
         end do
      end if
      if (.not. window%has_state) then
         ! where no load of the adhered branch is near enough, none was found
         if (window%is_known) window%is_known = .not. window%is_adhered
         if (window%is_known) call start_apart(window, operator, shape, path)
         return
      end if
      do k = 1, most_narrowing
         if (operator%is_stopped()) exit
         ! next to a fold a bound takes long; the path goes on from what is known
         if (.not. window%is_known) exit
         if (window%is_near()) exit
         call look(window, operator, shape, path, window%next_load())
      end do
      window%is_known = .true.
   end subroutine open_window

   !> Begin far apart, or at the penetration if that is farther.
   subroutine start_apart(window, operator, shape, path)
      type(attracted_window_t), intent(inout) :: window
      type(periodic_operator_t), intent(in) :: operator
      real(dp), intent(in) :: shape(:, :)
      type(attracted_path_t), intent(inout) :: path

      window%state = contact_state_t()
      associate (state => window%state)
         state%shape = shape
         state%gap = shape - minval(shape) + max(distance_apart(path%cells, operator), minval(shape) - window%penetration)
         allocate (state%is_open(size(shape, 1), size(shape, 2)), source=.true.)
         state%has_fixed_mean = .true.
         state%mean_gap = sum(state%gap)/size(state%gap)
         state%mean_pressure = -sum(path%cells%tension(state%gap))/size(state%gap)
         call path%find(state, window%tolerance, window%is_known)
         window%excess = penetration_of(state) - window%penetration
      end associate
      window%is_of_load = .false.
   end subroutine start_apart

   !> Follow the state of the window to the penetration, until no other load is in question.
   subroutine search(window, operator, shape, path)
      !> In: both ends. Out: the state at the penetration, if it has converged.
      type(attracted_window_t), intent(inout) :: window
      type(periodic_operator_t), intent(inout) :: operator
      real(dp), intent(in) :: shape(:, :)
      type(attracted_path_t), intent(inout) :: path
      type(contact_state_t) :: state
      real(dp) :: ends(2), load, reach
      logical :: has_arrived
      integer :: j, k

      do k = 1, most_attempts
         state = window%state
         has_arrived = .false.
         if (operator%is_stopped()) exit
         call path%follow(state, sum(shape)/size(shape) - window%penetration, window%tolerance, ends(1), ends(2), has_arrived)
         if (.not. window%has_state) exit
         load = merge(ends(1), ends(2), window%is_adhered)
         reach = merge(-beyond, beyond, window%is_adhered)*(abs(load) + sum(abs(path%cells%tension(state%gap)))/size(state%gap))
         window%has_state = .false.
         do j = 1, most_looks
            call look(window, operator, shape, path, load + reach)
            if (window%is_known) exit
            ! next to a fold bounds take long
            reach = 2*reach
         end do
         if (.not. window%has_state) exit
         has_arrived = .false.
         ! more of the window is cut off where the loads on the path have not been enough
         if (k > 1 .and. .not. window%is_near()) &
            & call look(window, operator, shape, path, window%next_load())
      end do
      window%state = state
      window%state%is_converged = has_arrived .and. window%is_known
   end subroutine search

   !> Collect the solution, with the area of coarser grids at the same mean gap, as far as they have the state.
   subroutine collect(self, state, cells, tolerance, solution)
      type(periodic_solver_t), intent(inout) :: self
      type(contact_state_t), intent(in) :: state
      !> Attraction on each grid, of opening on the finest one.
      type(attraction_cells_t), intent(inout) :: cells(:)
      real(dp), intent(in) :: tolerance
      !> In: with pairs of transforms. Out: the solution.
      type(periodic_solution_t), intent(inout) :: solution
      type(contact_state_t), allocatable :: states(:)
      type(linear_step_t), allocatable :: work
      integer :: k, n
      logical :: has_found

      n = size(self%grids)
      allocate (states(n))
      states(n) = state
      do k = n - 1, max(1, n - grids_for_error + 1), -1
         associate (fine => states(k + 1), coarse => states(k), operator => self%grids(k)%operator)
            coarse%shape = coarsen(fine%shape)
            coarse%gap = coarsen(fine%gap)
            coarse%mean_gap = fine%mean_gap
            coarse%mean_pressure = fine%mean_pressure
            coarse%has_fixed_mean = .true.
            if (allocated(cells(k + 1)%has_touched)) then
               cells(k)%has_touched = coarsen(merge(1.0_dp, 0.0_dp, cells(k + 1)%has_touched)) > 0.5_dp
               cells(k)%opening = cells(k + 1)%opening
            end if
            allocate (work)
            call new_linear_step(work, operator, coarse%shape, cells(k)%has_wall())
            call find_state_near(work, coarse, operator, cells(k), max(tolerance, coarse_tolerance), has_found)
            deallocate (work)
            if (has_found) cycle
            deallocate (coarse%gap)
            exit
         end associate
      end do
      call collect_attracted(self, states, cells(n), solution)
   end subroutine collect

end module adfric_periodic_attracted_penetration
