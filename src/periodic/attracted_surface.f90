! SPDX-License-Identifier: GPL-3.0-or-later
!> Contact of a periodic surface whose cells attract each other by any falling law, under a mean pressure, on nested grids. Each grid has the
!> extremal state of its own cells (`adfric_periodic_attracted_contact`); a coarser one only says where Newton's method begins, and
!> tells the error of the area.
module adfric_periodic_attracted_surface
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_interface_adhesion_rows, only: adhesion_law_t, branch_adhered
   use adfric_interface_attraction, only: attraction_t
   use adfric_periodic_adhesive_solver, only: resist
   use adfric_periodic_attracted_contact, only: solve_attracted_contact
   use adfric_periodic_attracted_state, only: violation_of
   use adfric_periodic_attraction_cells, only: attraction_cells_t
   use adfric_periodic_contact, only: contact_state_t
   use adfric_periodic_grids, only: coarsen, refine
   use adfric_periodic_operator, only: periodic_operator_t
   use adfric_periodic_solver, only: check_shape, coarse_tolerance, contact_not_converged, contact_out_of_range, contact_solved, &
      & periodic_solution_t, periodic_solver_t, set_friction, set_full_pressure, set_solution, start_from_coarse
   implicit none (type, external)
   private
   public :: attraction_in_units, cells_of_grids, collect_attracted, periodic_attraction_t, solve_attracted_layer
   public :: solve_attracted_load

   !> Attraction of a surface, and which of the states is wanted.
   type :: periodic_attraction_t
      !> The law: stresses in E*, lengths in the unit of the gap.
      type(attraction_t) :: law
      !> Work of adhesion of each cell over that of the law, >= 0; not allocated: 1. Shape of the cells.
      real(dp), allocatable :: part(:, :)
      !> Is the most adhered state wanted? Else the least adhered one is, which slow loading reaches.
      logical :: is_adhered = .true.
      !> Was the surface loaded no further than to `turning_pressure` [E*] before? Of use for the most adhered state alone.
      logical :: has_turned = .false.
      !> Mean pressure from which the load falls [E*], >= 0.
      real(dp) :: turning_pressure = 0
      !> Work that cells that have been in contact take to open over that which closing gives, >= 1.
      real(dp) :: opening = 1
   contains
      procedure :: in_length
   end type periodic_attraction_t

contains

   !> An attraction with stresses in the unit of the contact.
   pure type(periodic_attraction_t) function attraction_in_units(adhesion, modulus) result(attraction)
      !> The adhesion, of another law than Dugdale's.
      type(adhesion_law_t), intent(in) :: adhesion
      !> Unit of pressures E* [Pa].
      real(dp), intent(in) :: modulus

      attraction%law = adhesion%attraction%in_units(modulus, 1.0_dp)
      if (allocated(adhesion%part)) allocate (attraction%part, source=adhesion%part)
      attraction%is_adhered = adhesion%branch == branch_adhered
      attraction%has_turned = allocated(adhesion%turning_pressure)
      if (allocated(adhesion%turning_pressure)) attraction%turning_pressure = adhesion%turning_pressure/modulus
      attraction%opening = adhesion%opening
   end function attraction_in_units

   !> The same with lengths in another unit.
   pure type(periodic_attraction_t) function in_length(self, unit) result(other)
      class(periodic_attraction_t), intent(in) :: self
      !> The unit, in that of `self`.
      real(dp), intent(in) :: unit

      other%law = self%law%in_units(1.0_dp, unit)
      if (allocated(self%part)) allocate (other%part, source=self%part)
      other%is_adhered = self%is_adhered
      other%has_turned = self%has_turned
      other%turning_pressure = self%turning_pressure
      other%opening = self%opening
   end function in_length

   !> Solve under a mean pressure.
   subroutine solve_attracted_load(self, shape, mean_pressure, attraction, tolerance, solution, error)
      type(periodic_solver_t), intent(inout) :: self
      !> Gap of the undeformed surfaces in the middles of the cells; 0 at first touch, and no less.
      real(dp), intent(in) :: shape(:, :)
      !> Mean pressure [E*], negative where the surface is pulled.
      real(dp), intent(in) :: mean_pressure
      type(periodic_attraction_t), intent(in) :: attraction
      real(dp), intent(in) :: tolerance
      !> The solution; `status` tells how it ended. Out of range: no state with contact carries the load.
      type(periodic_solution_t), intent(out) :: solution
      type(error_t), allocatable, intent(out) :: error
      type(contact_state_t), allocatable :: states(:), turned(:)
      type(attraction_cells_t), allocatable :: cells(:)
      integer :: n

      call check_shape(self, shape, error)
      if (allocated(error)) return
      n = size(self%grids)
      call set_states(n, shape, mean_pressure, states)
      call cells_of_grids(self, attraction, cells)
      if (attraction%is_adhered .and. attraction%has_turned .and. mean_pressure < attraction%turning_pressure) then
         allocate (turned, source=states)
         turned%mean_pressure = attraction%turning_pressure
         call pass_grids(self, turned, cells, .true., tolerance, solution)
         if (solution%status == contact_solved) call open_again(self, states, cells, attraction, turned, tolerance, solution)
      else
         call pass_branch(self, states, cells, attraction, tolerance, solution)
      end if
      if (solution%status == contact_out_of_range .or. .not. allocated(states(n)%gap)) return
      call collect_attracted(self, states, cells(n), solution)
   end subroutine solve_attracted_load

   !> Solve at a given penetration of a solid whose mean displacement is known, as that of a layer on a rigid base; its law has a wall. A
   !> penetration is no load: there is a state at each, and after a turn those that the turn did not reach are states of approach.
   subroutine solve_attracted_layer(self, shape, penetration, attraction, tolerance, solution, error)
      type(periodic_solver_t), intent(inout) :: self
      !> Gap of the undeformed surfaces in the middles of the cells; 0 at first touch, and no less.
      real(dp), intent(in) :: shape(:, :)
      !> Penetration from first touch at the base of the layer, in the unit of `shape`; below 0 before it.
      real(dp), intent(in) :: penetration
      type(periodic_attraction_t), intent(in) :: attraction
      real(dp), intent(in) :: tolerance
      !> The solution; `status` tells how it ended.
      type(periodic_solution_t), intent(out) :: solution
      type(error_t), allocatable, intent(out) :: error
      type(contact_state_t), allocatable :: states(:), turned(:)
      type(attraction_cells_t), allocatable :: cells(:)
      logical :: comes_back
      integer :: n

      call check_shape(self, shape, error)
      if (allocated(error)) return
      n = size(self%grids)
      call cells_of_grids(self, attraction, cells)
      comes_back = .false.
      associate (compliance => self%grids(n)%operator%mean_compliance)
         if (attraction%is_adhered .and. attraction%has_turned) then
            call set_states(n, shape, attraction%turning_pressure, turned)
            call pass_grids(self, turned, cells, .true., tolerance, solution)
            if (solution%status == contact_not_converged) return
            if (solution%status == contact_solved) comes_back = penetration < sum(turned(n)%shape - turned(n)%gap)/size(shape) &
               & + compliance*attraction%turning_pressure
         end if
         call set_states(n, shape, penetration/compliance, states)
      end associate
      call resist(self, .true.)
      states%resists_mean = .true.
      if (comes_back) then
         call open_again(self, states, cells, attraction, turned, tolerance, solution)
      else
         call pass_branch(self, states, cells, attraction, tolerance, solution)
      end if
      call resist(self, .false.)
      if (.not. allocated(states(n)%gap)) return
      ! from here on the load is known
      associate (finest => states(n))
         finest%mean_pressure = finest%mean_pressure - sum(finest%shape - finest%gap)/size(shape) &
            & /self%grids(n)%operator%mean_compliance
      end associate
      states%resists_mean = .false.
      call collect_attracted(self, states, cells(n), solution)
   end subroutine solve_attracted_layer

   !> Find the states behind a turn, from the states of the turn.
   subroutine open_again(self, states, cells, attraction, turned, tolerance, solution)
      type(periodic_solver_t), intent(inout) :: self
      !> In: shape and load on each grid. Out: the states.
      type(contact_state_t), intent(inout) :: states(:)
      !> Attraction on each grid; what has been in contact opens by the law of opening from here on.
      type(attraction_cells_t), intent(inout) :: cells(:)
      type(periodic_attraction_t), intent(in) :: attraction
      !> States of the turn.
      type(contact_state_t), intent(in) :: turned(:)
      real(dp), intent(in) :: tolerance
      type(periodic_solution_t), intent(inout) :: solution
      integer :: k

      do k = 1, size(cells)
         if (allocated(turned(k)%gap)) call cells(k)%open_by(attraction%opening, .not. turned(k)%gap > cells(k)%contact_gap())
      end do
      call pass_grids(self, states, cells, .false., tolerance, solution, turned)
   end subroutine open_again

   !> Find the states of the branch that is wanted; those that a turn did not reach are states of approach.
   subroutine pass_branch(self, states, cells, attraction, tolerance, solution)
      type(periodic_solver_t), intent(inout) :: self
      !> In: shape and load on each grid. Out: the states.
      type(contact_state_t), intent(inout) :: states(:)
      !> Attraction on each grid.
      type(attraction_cells_t), intent(inout) :: cells(:)
      type(periodic_attraction_t), intent(in) :: attraction
      real(dp), intent(in) :: tolerance
      type(periodic_solution_t), intent(inout) :: solution
      integer :: k

      ! without a turn all has been in contact
      do k = 1, size(cells)
         if (attraction%is_adhered .and. .not. attraction%has_turned) call cells(k)%open_by(attraction%opening, &
            & .not. states(k)%shape < 0)
      end do
      call pass_grids(self, states, cells, attraction%has_turned .or. .not. attraction%is_adhered, tolerance, solution)
   end subroutine pass_branch

   !> States of all grids with their shapes and a mean pressure.
   subroutine set_states(n, shape, mean_pressure, states)
      !> Number of grids.
      integer, intent(in) :: n
      !> Gap of the undeformed surfaces on the finest grid.
      real(dp), intent(in) :: shape(:, :)
      real(dp), intent(in) :: mean_pressure
      !> Receives the states, that of the coarsest grid first.
      type(contact_state_t), allocatable, intent(out) :: states(:)
      integer :: k

      allocate (states(n))
      do k = n, 1, -1
         if (k == n) then
            allocate (states(k)%shape, source=shape)
         else
            allocate (states(k)%shape, source=coarsen(states(k + 1)%shape))
         end if
         states(k)%mean_pressure = mean_pressure
      end do
   end subroutine set_states

   !> Attraction of the cells of all grids.
   subroutine cells_of_grids(self, attraction, cells)
      !> The grids.
      type(periodic_solver_t), intent(in) :: self
      !> The law, and the works of the cells of the finest grid.
      type(periodic_attraction_t), intent(in) :: attraction
      !> Receives the attraction, from the coarsest grid to the finest.
      type(attraction_cells_t), allocatable, intent(out) :: cells(:)
      integer :: k, n

      n = size(self%grids)
      allocate (cells(n))
      do k = n, 1, -1
         cells(k)%law = attraction%law
         if (.not. allocated(attraction%part)) cycle
         if (k == n) then
            cells(k)%part = attraction%part
         else
            cells(k)%part = coarsen(cells(k + 1)%part)
         end if
      end do
   end subroutine cells_of_grids

   !> Find the states of all grids, from the coarsest to the finest.
   subroutine pass_grids(self, states, cells, falls, tolerance, solution, turned)
      type(periodic_solver_t), intent(inout) :: self
      !> In: shape and load on each grid. Out: the states; without a gap where there is none.
      type(contact_state_t), intent(inout) :: states(:)
      !> Attraction on each grid.
      type(attraction_cells_t), intent(in) :: cells(:)
      !> Is the least adhered state wanted?
      logical, intent(in) :: falls
      real(dp), intent(in) :: tolerance
      !> Receives pairs of transforms and how it ended.
      type(periodic_solution_t), intent(inout) :: solution
      !> States of the turn on each grid, less adhered than those that are wanted, or as much.
      type(contact_state_t), intent(in), optional :: turned(:)
      type(contact_state_t) :: blank
      real(dp), allocatable :: start(:, :)
      logical :: has_state, has_guess
      integer :: k, n, n_before

      n = size(states)
      has_guess = .false.
      has_state = .false.
      do k = 1, n
         ! a body that is pulled does not come into contact by itself
         if (falls .and. states(k)%mean_pressure < 0 .and. .not. states(k)%resists_mean) exit
         associate (grid => self%grids(k), state => states(k))
            n_before = grid%operator%n_applied
            blank = state
            if (has_guess) then
               call start_fine(state, states(max(k - 1, 1)), grid%operator, cells(k))
               state%mean_pressure = blank%mean_pressure
            end if
            associate (grid_tolerance => merge(tolerance, coarse_tolerance, k == n))
               if (present(turned)) then
                  has_state = allocated(turned(k)%gap)
                  if (.not. has_state) cycle
                  start = turned(k)%gap
                  call solve_attracted_contact(state, grid%operator, cells(k), grid_tolerance, falls, has_guess, has_state, start, &
                     & is_coarse=k < n)
               else
                  call solve_attracted_contact(state, grid%operator, cells(k), grid_tolerance, falls, has_guess, has_state, &
                     & is_coarse=k < n)
               end if
            end associate
            has_guess = has_state .and. state%is_converged
            if (.not. has_state .or. (k < n .and. .not. state%is_converged)) state = blank
            solution%n_applied = grid%operator%n_applied - n_before
            solution%n_pairs = solution%n_pairs + solution%n_applied*(real(size(state%shape), dp)/size(states(n)%shape))
         end associate
      end do
      solution%status = contact_out_of_range
      if (has_state) solution%status = merge(contact_solved, contact_not_converged, states(n)%is_converged)
   end subroutine pass_grids

   !> Begin from the gap of the next coarser grid.
   subroutine start_fine(state, coarse, operator, cells)
      !> Receives the gap to begin from.
      type(contact_state_t), intent(inout) :: state
      type(contact_state_t), intent(in) :: coarse
      type(periodic_operator_t), intent(in) :: operator
      type(attraction_cells_t), intent(in) :: cells

      call start_from_coarse(state, coarse, operator)
      if (cells%has_wall()) return
      ! in contact the gap hardly knows of waves that only the finer grid has
      state%gap = refine(coarse%gap, state%shape, operator%is_quarter)
      where (state%gap > cells%contact_gap()) state%gap = max(cells%contact_gap(), state%gap + state%shape &
         & - refine(coarse%shape, state%shape, operator%is_quarter))
   end subroutine start_fine

   !> Collect what the grids have found.
   subroutine collect_attracted(self, states, cells, solution)
      !> Grids, operators and workspaces.
      type(periodic_solver_t), intent(inout) :: self
      !> States of the grids, the finest last; without a gap where there is none.
      type(contact_state_t), intent(inout) :: states(:)
      !> Attraction of the finest grid.
      type(attraction_cells_t), intent(in) :: cells
      !> In: with pairs of transforms. Out: the solution.
      type(periodic_solution_t), intent(inout) :: solution
      real(dp), allocatable :: tension(:, :)
      real(dp) :: load
      integer :: k, n, first

      n = size(states)
      first = n
      do k = n - 1, 1, -1
         if (.not. allocated(states(k)%gap)) exit
         first = k
      end do
      do k = first, n
         if (.not. cells%has_wall()) states(k)%is_open = states(k)%gap > cells%contact_gap()
      end do
      load = states(n)%mean_pressure
      allocate (tension, source=cells%tension(states(n)%gap))
      ! contact carries the load and the tension
      states(n)%mean_pressure = load + sum(tension)/size(tension)
      call set_full_pressure(self%grids(n)%operator, states(n)%shape, solution)
      call set_solution(states(first:), self%grids(n)%operator, solution)
      states(n)%mean_pressure = load
      solution%mean_pressure = load
      associate (compliance => self%grids(n)%operator%mean_compliance)
         ! the mean of the surface follows the load alone
         solution%penetration = solution%penetration - compliance*(sum(tension)/size(tension))
      end associate
      if (cells%has_wall()) then
         solution%pressure(:, :) = solution%pressure - tension
      else
         ! the law is all that acts
         solution%gap(:, :) = states(n)%gap
         solution%pressure(:, :) = -tension
         solution%residual = violation_of(states(n)%pressure, states(n)%gap, states(n), cells)
      end if
      solution%share = tension/cells%law%stress
      solution%adhesion_energy = cells%energy(solution%gap)
      solution%opening_loss = cells%opening_loss(solution%gap)
      solution%elastic_energy = sum((solution%gap - states(n)%shape)*(solution%pressure - load))/(2*size(tension)) &
         & + self%grids(n)%operator%mean_compliance*load**2/2
      call set_friction(self, states, states(n)%shape, solution)
   end subroutine collect_attracted

end module adfric_periodic_attracted_surface
