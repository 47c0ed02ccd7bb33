! SPDX-License-Identifier: GPL-3.0-or-later
!> Adhesive contact of a periodic surface at a given penetration, on either branch.
!>
!> Under a load q each branch has one state (`adfric_periodic_adhesive_contact`), whose penetration D(q) rises with q: it is known where a
!> penetration is prescribed under a load, and where a jump of the load passes it. At the penetration delta the states of the
!> branches are
!>
!> - **adhered**: the surfaces part slowly under a load that falls to the least one whose state is not yet farther apart than delta. If
!>   that is not the state at delta, the next load would pass it; from there on the mean gap is opened slowly
!>   (`adfric_periodic_adhesive_path`).
!> - **approach**: they come together under a load that grows to the largest one whose state is not yet nearer than delta, and then the
!>   mean gap is closed slowly. Below the penetration under no load the mean gap is closed from where the first cell comes into range.
!>
!> Without jumps of the load inside delta's window these are the states that parting and approach at given penetrations reach. A
!> tension of at most sigma0 pulls, so that D(q) lies between the penetrations without adhesion under q and under q + sigma0. The window
!> is narrowed from there; from its end the state is followed to delta, and where the branch under a load a little beyond all loads on
!> this way has passed delta, or has no state, no other load is in question.
!>
!> A body that slides over a viscoelastic solid has ordered branches where its order margin is not below 0 (`adfric_solid_order_margin`).
!> Elsewhere the same search is made, and its state is one of slow parting or approach at the velocity of the point. Where the search
!> does not end, time stepping at the mean gap decides (`adfric_periodic_sliding_steps`).
module adfric_periodic_adhesive_penetration
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_periodic_adhesive_contact, only: find_state
   use adfric_periodic_adhesive_path, only: follow_state
   use adfric_periodic_adhesive_solver, only: periodic_adhesion_t, set_opening_loss, solve_adhesive_state
   use adfric_periodic_cohesion, only: new_cohesion
   use adfric_periodic_contact, only: contact_state_t
   use adfric_periodic_gap_path, only: penetration_of
   use adfric_periodic_grids, only: coarsen
   use adfric_periodic_load_window, only: begin_window, beyond, closed, load_window_t, most_attempts, most_looks
   use adfric_periodic_maps, only: sum_of
   use adfric_periodic_sliding_steps, only: solve_by_steps
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, check_shape, set_friction, set_full_pressure, &
      & set_solution, coarse_tolerance, contact_solved, contact_not_converged, contact_out_of_range, grids_for_error
   implicit none (type, external)
   private
   public :: solve_adhesive_penetration

   !> Loads that narrow the window before the state is followed, at most.
   integer, parameter :: most_narrowing = 5

   !> What is known of the branch under a load.
   type, extends(load_window_t) :: window_t
      !> Mean pressure without adhesion [E*], 0 where there is no contact.
      real(dp) :: bare_load = 0
      !> States of a turn on all grids, once they are known.
      type(contact_state_t), allocatable :: turned(:)
   end type window_t

contains

   !> Solve at a penetration with adhesion.
   subroutine solve_adhesive_penetration(self, shape, penetration, adhesion, tolerance, solution, error)
      type(periodic_solver_t), intent(inout) :: self
      !> Gap of the undeformed surfaces in the middles of the cells; 0 at first touch, and no less.
      real(dp), intent(in) :: shape(:, :)
      !> Penetration from first touch at the mean of the deformed surface, in the unit of `shape`; below 0 before it.
      real(dp), intent(in) :: penetration
      type(periodic_adhesion_t), intent(in) :: adhesion
      real(dp), intent(in) :: tolerance
      !> The solution; `status` tells how it ended. Out of range: no pressure brings the surfaces so near.
      type(periodic_solution_t), intent(out) :: solution
      type(error_t), allocatable, intent(out) :: error
      type(periodic_adhesion_t) :: branch
      type(window_t) :: window

      call check_shape(self, shape, error)
      if (allocated(error)) return
      solution%status = contact_out_of_range
      if (.not. sum_of(shape)/size(shape) - penetration > closed*(maxval(shape) - minval(shape))) return
      branch = adhesion
      call begin_window(window, penetration, shape)
      call solve_bare(self, shape, tolerance, window, solution, error)
      if (allocated(error)) return
      call choose_side(self, shape, tolerance, branch, window, solution, error)
      if (allocated(error)) return
      if (.not. window%is_adhered .and. penetration <= minval(shape) - adhesion%far_range()) then
         call start_apart(self, shape, branch, window)
      else
         call open_window(self, shape, branch, tolerance, window, solution, error)
      end if
      if (allocated(error)) return
      call search(self, shape, branch, tolerance, window, solution, error)
      if (allocated(error)) return
      if (.not. (window%state%is_converged .or. (branch%has_turned .and. window%is_adhered))) &
         & call step_on(self, shape, branch, tolerance, window, solution)
      if (.not. window%state%is_converged) return
      call collect(self, window%state, tolerance, solution)
      if (allocated(window%gap_of_turn)) then
         call set_opening_loss(window%state%cohesion, adhesion, solution, window%gap_of_turn)
      else
         call set_opening_loss(window%state%cohesion, adhesion, solution)
      end if
   end subroutine solve_adhesive_penetration

   !> Find the load without adhesion at the penetration.
   subroutine solve_bare(self, shape, tolerance, window, solution, error)
      type(periodic_solver_t), intent(inout) :: self
      !> Gap of the undeformed surfaces in the middles of the cells.
      real(dp), intent(in) :: shape(:, :)
      real(dp), intent(in) :: tolerance
      type(window_t), intent(inout) :: window
      type(periodic_solution_t), intent(inout) :: solution
      type(error_t), allocatable, intent(out) :: error
      type(periodic_solution_t) :: bare

      call self%solve_penetration(shape, window%penetration, tolerance, bare, error)
      if (allocated(error)) return
      window%bare_load = max(bare%mean_pressure, 0.0_dp)
      solution%n_pairs = solution%n_pairs + bare%n_pairs
   end subroutine solve_bare

   !> After a turn the state is that of approach for penetrations that the turn did not reach, and comes from that of the turn else.
   subroutine choose_side(self, shape, tolerance, branch, window, solution, error)
      type(periodic_solver_t), intent(inout) :: self
      !> Gap of the undeformed surfaces in the middles of the cells.
      real(dp), intent(in) :: shape(:, :)
      real(dp), intent(in) :: tolerance
      !> In: the branch. Out: that of approach, if it is that.
      type(periodic_adhesion_t), intent(inout) :: branch
      !> Receives the side, and the state of the turn.
      type(window_t), intent(inout) :: window
      type(periodic_solution_t), intent(inout) :: solution
      type(error_t), allocatable, intent(out) :: error

      window%is_adhered = branch%is_adhered
      if (.not. (branch%is_adhered .and. branch%has_turned)) return
      call look(self, shape, branch%turning_pressure, branch, tolerance, window, solution, error)
      if (allocated(error)) return
      if (window%has_state) then
         ! from here on contact opens
         window%gap_of_turn = window%state%gap
         call window%state%cohesion%open_by(branch%opening, window%state%gap)
         return
      end if
      branch%is_adhered = .false.
      window%is_adhered = .false.
      window%has_state = .false.
   end subroutine choose_side

   !> Find a state that has not passed the penetration, and a load that has.
   subroutine open_window(self, shape, branch, tolerance, window, solution, error)
      type(periodic_solver_t), intent(inout) :: self
      !> Gap of the undeformed surfaces in the middles of the cells.
      real(dp), intent(in) :: shape(:, :)
      type(periodic_adhesion_t), intent(in) :: branch
      real(dp), intent(in) :: tolerance
      !> In: with the state of a turn. Out: both ends are known.
      type(window_t), intent(inout) :: window
      type(periodic_solution_t), intent(inout) :: solution
      type(error_t), allocatable, intent(out) :: error
      real(dp) :: near_end, far_end
      integer :: k

      window%has_passed_excess = .false.
      near_end = window%bare_load
      far_end = window%bare_load - branch%stress
      if (.not. window%is_adhered) then
         near_end = max(window%bare_load - branch%stress, 0.0_dp)
         far_end = window%bare_load
      end if
      window%passed = far_end
      if (.not. window%has_state) then
         call look(self, shape, near_end, branch, tolerance, window, solution, error)
         if (allocated(error)) return
      end if
      if (.not. window%has_state) then
         call start_apart(self, shape, branch, window)
         return
      end if
      do k = 1, most_narrowing
         if (window%is_near()) exit
         call look(self, shape, window%next_load(), branch, tolerance, window, solution, error)
         if (allocated(error)) return
      end do
   end subroutine open_window

   !> Begin with the first cell about to come into range.
   subroutine start_apart(self, shape, branch, window)
      type(periodic_solver_t), intent(in) :: self
      !> Gap of the undeformed surfaces in the middles of the cells.
      real(dp), intent(in) :: shape(:, :)
      type(periodic_adhesion_t), intent(in) :: branch
      type(window_t), intent(inout) :: window

      window%state = contact_state_t()
      associate (state => window%state)
         allocate (state%cohesion)
         call new_cohesion(state%cohesion, branch%stress, branch%first_range(), self%grids(size(self%grids))%operator%is_quarter, &
            & branch%law)
         if (allocated(branch%part)) state%cohesion%part = branch%part
         state%shape = shape
         state%gap = shape - minval(shape) + state%cohesion%far_range()*(1 + epsilon(1.0_dp))
         state%pressure = 0*shape
         allocate (state%is_open(size(shape, 1), size(shape, 2)), source=.true.)
         call state%cohesion%set_share(state%gap)
         window%excess = penetration_of(state) - window%penetration
         window%is_of_load = .false.
      end associate
   end subroutine start_apart

   !> Solve under a load, and take note on which side of the penetration its state is.
   subroutine look(self, shape, load, branch, tolerance, window, solution, error)
      type(periodic_solver_t), intent(inout) :: self
      !> Gap of the undeformed surfaces in the middles of the cells.
      real(dp), intent(in) :: shape(:, :)
      !> Mean pressure [E*].
      real(dp), intent(in) :: load
      type(periodic_adhesion_t), intent(in) :: branch
      real(dp), intent(in) :: tolerance
      !> What is known; receives one more state or load.
      type(window_t), intent(inout) :: window
      type(periodic_solution_t), intent(inout) :: solution
      type(error_t), allocatable, intent(out) :: error
      type(contact_state_t) :: state
      type(periodic_solution_t) :: found

      if (window%is_bound_of(load)) then
         call solve_adhesive_state(self, shape, load, branch, tolerance, window%turned, state, found, error, window%state)
      else
         call solve_adhesive_state(self, shape, load, branch, tolerance, window%turned, state, found, error)
      end if
      if (allocated(error)) return
      solution%n_pairs = solution%n_pairs + found%n_pairs
      window%is_known = found%status /= contact_not_converged
      call window%take_note(load, state, found%status == contact_solved)
   end subroutine look

   !> Follow the state of the window to the penetration, until no other load is in question.
   subroutine search(self, shape, branch, tolerance, window, solution, error)
      type(periodic_solver_t), intent(inout) :: self
      !> Gap of the undeformed surfaces in the middles of the cells.
      real(dp), intent(in) :: shape(:, :)
      type(periodic_adhesion_t), intent(in) :: branch
      real(dp), intent(in) :: tolerance
      !> In: both ends. Out: the state at the penetration, if it has converged.
      type(window_t), intent(inout) :: window
      !> Receives pairs of transforms and how it ended.
      type(periodic_solution_t), intent(inout) :: solution
      type(error_t), allocatable, intent(out) :: error
      type(contact_state_t) :: state
      real(dp) :: ends(2), load, reach
      logical :: has_arrived
      integer :: j, k, n_before

      do k = 1, most_attempts
         state = window%state
         associate (grid => self%grids(size(self%grids)))
            n_before = grid%operator%n_applied
            call follow_state(state, sum_of(shape)/size(shape) - window%penetration, grid%operator, grid%gap_solver, tolerance, &
               & ends(1), ends(2), has_arrived)
            solution%n_pairs = solution%n_pairs + grid%operator%n_applied - n_before
         end associate
         if (.not. window%has_state) exit
         load = merge(ends(1), ends(2), window%is_adhered)
         reach = merge(-beyond, beyond, window%is_adhered)*(abs(load) + state%cohesion%mean_tension())
         window%has_state = .false.
         do j = 1, most_looks
            call look(self, shape, load + reach, branch, tolerance, window, solution, error)
            if (allocated(error)) return
            if (window%is_known) exit
            ! next to a fold rounds take long
            reach = 2*reach
         end do
         if (.not. window%has_state) exit
         has_arrived = .false.
         ! more of the window is cut off where the loads on the way have not been enough
         if (k > 1 .and. .not. window%is_near()) &
            & call look(self, shape, window%next_load(), branch, tolerance, window, solution, error)
         if (allocated(error)) return
      end do
      window%state = state
      window%state%is_converged = has_arrived .and. window%is_known
      solution%status = contact_not_converged
   end subroutine search

   !> Look for the state of a body that slides in time.
   subroutine step_on(self, shape, branch, tolerance, window, solution)
      type(periodic_solver_t), intent(inout) :: self
      !> Gap of the undeformed surfaces in the middles of the cells.
      real(dp), intent(in) :: shape(:, :)
      type(periodic_adhesion_t), intent(in) :: branch
      real(dp), intent(in) :: tolerance
      !> The side; receives the state, if it is found.
      type(window_t), intent(inout) :: window
      !> Receives pairs of transforms.
      type(periodic_solution_t), intent(inout) :: solution
      integer :: n_before

      associate (grid => self%grids(size(self%grids)), state => window%state)
         call start_apart(self, shape, branch, window)
         state%has_fixed_mean = .true.
         state%mean_gap = sum_of(shape)/size(shape) - window%penetration
         n_before = grid%operator%n_applied
         call solve_by_steps(state, self%kernel, grid%operator, grid%gap_solver, tolerance, window%is_adhered)
         solution%n_pairs = solution%n_pairs + grid%operator%n_applied - n_before
      end associate
   end subroutine step_on

   !> Collect the solution, with the area of coarser grids at the same mean gap, as far as they have the state.
   subroutine collect(self, state, tolerance, solution)
      type(periodic_solver_t), intent(inout) :: self
      type(contact_state_t), intent(in) :: state
      real(dp), intent(in) :: tolerance
      !> In: with pairs of transforms. Out: the solution.
      type(periodic_solution_t), intent(inout) :: solution
      type(contact_state_t), allocatable :: states(:)
      integer :: k, n, first
      logical :: has_found

      n = size(self%grids)
      allocate (states(n))
      states(n) = state
      first = n
      do k = n - 1, max(1, n - grids_for_error + 1), -1
         associate (grid => self%grids(k))
            call set_coarse(states(k), states(k + 1), grid%operator%is_quarter)
            call find_state(states(k), grid%operator, grid%gap_solver, max(tolerance, coarse_tolerance), has_found)
         end associate
         if (.not. has_found) exit
         first = k
      end do
      call set_full_pressure(self%grids(n)%operator, state%shape, solution)
      call set_solution(states(first:), self%grids(n)%operator, solution)
      call set_friction(self, states, state%shape, solution)
   end subroutine collect

   !> Begin on a coarser grid from the gap of a finer one.
   subroutine set_coarse(coarse, fine, is_quarter)
      type(contact_state_t), intent(out) :: coarse
      type(contact_state_t), intent(in) :: fine
      !> Is only a quarter of an even surface given?
      logical, intent(in) :: is_quarter

      coarse%shape = coarsen(fine%shape)
      coarse%gap = coarsen(fine%gap)
      coarse%is_open = coarsen(merge(1.0_dp, 0.0_dp, fine%is_open)) > 0.5_dp
      coarse%mean_gap = fine%mean_gap
      coarse%mean_pressure = fine%mean_pressure
      coarse%has_fixed_mean = .true.
      allocate (coarse%cohesion)
      call new_cohesion(coarse%cohesion, fine%cohesion%stress, fine%cohesion%range, is_quarter, fine%cohesion%law)
      if (allocated(fine%cohesion%part)) coarse%cohesion%part = coarsen(fine%cohesion%part)
      if (allocated(fine%cohesion%beyond)) coarse%cohesion%beyond = coarsen(fine%cohesion%beyond)
      call coarse%cohesion%set_share(coarse%gap)
   end subroutine set_coarse

end module adfric_periodic_adhesive_penetration
