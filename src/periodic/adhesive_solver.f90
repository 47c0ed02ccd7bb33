! SPDX-License-Identifier: GPL-3.0-or-later
!> Adhesive contact of a periodic surface, at rest or sliding steadily, on nested grids: load to pressure, gap and area on either
!> branch.
!>
!> Each grid has the state of the wanted branch, found from shares that are 1 or 0 everywhere (`adfric_periodic_adhesive_contact`). A
!> coarser grid only says where Newton's method begins. A state under a load nearby that bounds the wanted one takes their part.
!>
!> Where the body slides `adfric_periodic_sliding_rounds` finds the state, and on the finest grid, if these do not settle,
!> `adfric_periodic_sliding_steps`. On the finest grid the zones of the next coarser one, wider or narrower by a cell, are the bound then,
!> where that has contact. So the load of a jump is known as well as a grid of half the cells knows it.
!>
!> The file is long by what loads, layers and turns share.
module adfric_periodic_adhesive_solver
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_interface_adhesion_rows, only: adhesion_law_t, branch_adhered
   use adfric_interface_attraction, only: attraction_t
   use adfric_periodic_adhesive_contact, only: solve_adhesive_contact, widen_share
   use adfric_periodic_cohesion, only: cohesion_t, far_share, new_cohesion
   use adfric_periodic_contact, only: contact_state_t
   use adfric_periodic_grids, only: coarsen
   use adfric_periodic_sliding_steps, only: solve_by_steps
   use adfric_periodic_sliding_rounds, only: solve_by_rounds
   use adfric_periodic_solver, only: periodic_solver_t, periodic_solution_t, check_shape, set_friction, set_full_pressure, &
      & set_solution, start_from_coarse, coarse_tolerance, contact_solved, contact_not_converged, contact_out_of_range
   implicit none (type, external)
   private
   public :: adhesion_in_units, periodic_adhesion_t, resist, solve_adhesive_layer, solve_adhesive_load, solve_adhesive_state
   public :: set_opening_loss

   !> Adhesion of Maugis and Dugdale, and which of the states is wanted.
   type :: periodic_adhesion_t
      !> Tension sigma0 [E*], and range h0 in the unit of the gap; both > 0.
      real(dp) :: stress = 0, range = 0
      !> Is the most adhered state wanted? Else the least adhered one is, which slow loading reaches.
      logical :: is_adhered = .true.
      !> Was the surface loaded no further than to `turning_pressure` [E*] before? Of use for the most adhered state alone.
      logical :: has_turned = .false.
      !> Mean pressure from which the load falls [E*], >= 0.
      real(dp) :: turning_pressure = 0
      !> Work that opening takes over that which closing gives, >= 1, at the same stress.
      real(dp) :: opening = 1
      !> Work of adhesion of each cell over the largest one, which is stress times range; not allocated: 1. Shape of the cells.
      real(dp), allocatable :: part(:, :)
      !> Another law of attraction than Dugdale's, with a wall: its stress in E*, its range in the unit of the gap. Then `stress` and `range`
      !> are those of Dugdale's law of the same stress and work. Not allocated: Dugdale's. For bodies that slide.
      type(attraction_t), allocatable :: law
   contains
      procedure :: first_range
      procedure :: far_range
   end type periodic_adhesion_t

contains

   !> Range before a turn: what unloads from full contact opens, what is loaded closes.
   pure real(dp) function first_range(self) result(range)
      class(periodic_adhesion_t), intent(in) :: self

      range = self%range
      if (self%is_adhered .and. .not. self%has_turned) range = self%opening*range
   end function first_range

   !> Gap from which on surfaces count as apart before a turn.
   pure real(dp) function far_range(self) result(range)
      class(periodic_adhesion_t), intent(in) :: self

      range = self%range
      if (allocated(self%law)) range = self%law%reach(far_share)
   end function far_range

   !> An adhesion with stresses in the unit of the contact.
   pure type(periodic_adhesion_t) function adhesion_in_units(law, modulus) result(adhesion)
      !> The adhesion; its stress is above 0.
      type(adhesion_law_t), intent(in) :: law
      !> Unit of pressures E* or E0 [Pa].
      real(dp), intent(in) :: modulus

      adhesion%stress = law%stress/modulus
      adhesion%range = law%range
      adhesion%is_adhered = law%branch == branch_adhered
      adhesion%has_turned = allocated(law%turning_pressure)
      if (allocated(law%turning_pressure)) adhesion%turning_pressure = law%turning_pressure/modulus
      adhesion%opening = law%opening
      if (allocated(law%attraction)) allocate (adhesion%law, source=law%attraction%in_units(modulus, 1.0_dp))
      if (.not. allocated(law%part)) return
      adhesion%stress = maxval(law%part)*adhesion%stress
      adhesion%part = law%part/maxval(law%part)
   end function adhesion_in_units

   !> Solve under a mean pressure with adhesion.
   subroutine solve_adhesive_load(self, shape, mean_pressure, adhesion, tolerance, solution, error)
      type(periodic_solver_t), intent(inout) :: self
      !> Gap of the undeformed surfaces in the middles of the cells; 0 at first touch, and no less.
      real(dp), intent(in) :: shape(:, :)
      !> Mean pressure [E*], negative where the surface is pulled.
      real(dp), intent(in) :: mean_pressure
      type(periodic_adhesion_t), intent(in) :: adhesion
      real(dp), intent(in) :: tolerance
      !> The solution; `status` tells how it ended. Out of range: no state with contact carries the load.
      type(periodic_solution_t), intent(out) :: solution
      type(error_t), allocatable, intent(out) :: error
      type(contact_state_t), allocatable :: states(:), turned(:)

      call solve_on_grids(self, shape, mean_pressure, adhesion, tolerance, states, turned, solution, error)
      if (allocated(error)) return
      associate (n => size(states))
         ! there is no state, or none of the turn has been found
         if (solution%status == contact_out_of_range .or. .not. allocated(states(n)%gap)) return
         call set_full_pressure(self%grids(n)%operator, shape, solution)
         call set_solution(states, self%grids(n)%operator, solution)
         if (allocated(turned)) then
            call set_opening_loss(states(n)%cohesion, adhesion, solution, turned(n)%gap)
         else
            call set_opening_loss(states(n)%cohesion, adhesion, solution)
         end if
         call set_friction(self, states, shape, solution)
      end associate
   end subroutine solve_adhesive_load

   !> Energy that opening has taken beyond what closing gave, beside the energy of adhesion by the law of closing.
   subroutine set_opening_loss(cohesion, adhesion, solution, turned)
      !> The law of opening, or that of closing where nothing has opened.
      type(cohesion_t), intent(in) :: cohesion
      type(periodic_adhesion_t), intent(in) :: adhesion
      !> In: with the gap. Out: with the energies.
      type(periodic_solution_t), intent(inout) :: solution
      !> Gap of the turn; shape of the cells. Not given: all has been in contact.
      real(dp), intent(in), optional :: turned(:, :)
      type(cohesion_t) :: closing
      real(dp), allocatable :: start(:, :)

      if (.not. cohesion%range > adhesion%range) return
      call new_cohesion(closing, adhesion%stress, adhesion%range, cohesion%is_quarter)
      if (allocated(cohesion%part)) closing%part = cohesion%part
      allocate (start, source=0*solution%gap)
      if (present(turned)) start(:, :) = turned
      solution%adhesion_energy = closing%energy_of(solution%gap)
      solution%opening_loss = (cohesion%energy_of(solution%gap) - solution%adhesion_energy) &
         & - (cohesion%energy_of(start) - closing%energy_of(start))
   end subroutine set_opening_loss

   !> Solve at a penetration of a layer, which resists a constant: with its mean compliance C the penetration D is a load D/C on a solid
   !> whose constants are as stiff as it is. So rounds end in the least or the most adhered state at D, and there is no load to be sought.
   subroutine solve_adhesive_layer(self, shape, penetration, adhesion, tolerance, solution, error)
      type(periodic_solver_t), intent(inout) :: self
      !> Gap of the undeformed surfaces in the middles of the cells; 0 at first touch, and no less.
      real(dp), intent(in) :: shape(:, :)
      !> Penetration from first touch at the base of the layer, in the unit of `shape`; below 0 before it.
      real(dp), intent(in) :: penetration
      type(periodic_adhesion_t), intent(in) :: adhesion
      real(dp), intent(in) :: tolerance
      !> The solution; `status` tells how it ended.
      type(periodic_solution_t), intent(out) :: solution
      type(error_t), allocatable, intent(out) :: error
      type(contact_state_t), allocatable :: states(:), turned(:)
      logical :: comes_back
      integer :: n

      call check_shape(self, shape, error)
      if (allocated(error)) return
      n = size(self%grids)
      associate (compliance => self%grids(n)%operator%mean_compliance)
         comes_back = .false.
         if (adhesion%is_adhered .and. adhesion%has_turned) then
            call set_states(self, shape, adhesion%turning_pressure, adhesion, turned)
            call pass_grids(self, turned, .false., tolerance, solution)
            if (solution%status == contact_not_converged) return
            ! penetrations that the turn did not reach are those of approach
            if (solution%status == contact_solved) comes_back = penetration < sum(turned(n)%shape - turned(n)%gap)/size(shape) &
               & + compliance*adhesion%turning_pressure
         end if
         call set_states(self, shape, penetration/compliance, adhesion, states)
      end associate
      states%resists_mean = .true.
      call resist(self, .true.)
      if (comes_back) then
         call pass_grids(self, states, .true., tolerance, solution, turned)
      else
         call pass_grids(self, states, adhesion%is_adhered .and. .not. adhesion%has_turned, tolerance, solution)
      end if
      call resist(self, .false.)
      if (.not. allocated(states(n)%gap)) return
      call set_full_pressure(self%grids(n)%operator, shape, solution)
      call set_solution(states, self%grids(n)%operator, solution)
      call set_friction(self, states, shape, solution)
   end subroutine solve_adhesive_layer

   !> Say of all grids whether a constant has the stiffness of the layer.
   pure subroutine resist(self, resists)
      !> The grids.
      type(periodic_solver_t), intent(inout) :: self
      !> Does it have that stiffness? Else it has none.
      logical, intent(in) :: resists
      integer :: k

      do k = 1, size(self%grids)
         call self%grids(k)%operator%resist_mean(resists)
      end do
   end subroutine resist

   !> Solve as `solve_adhesive_load`, for the state on the finest grid.
   subroutine solve_adhesive_state(self, shape, mean_pressure, adhesion, tolerance, turned, state, solution, error, beside)
      type(periodic_solver_t), intent(inout) :: self
      !> Gap of the undeformed surfaces in the middles of the cells; 0 at first touch, and no less.
      real(dp), intent(in) :: shape(:, :)
      !> Mean pressure [E*], negative where the surface is pulled.
      real(dp), intent(in) :: mean_pressure
      type(periodic_adhesion_t), intent(in) :: adhesion
      real(dp), intent(in) :: tolerance
      !> States of the turn on all grids, which belong to the surface, its law and the tolerance; not allocated: not known yet. Receives
      !> them, so that other loads need not find them again.
      type(contact_state_t), allocatable, intent(inout) :: turned(:)
      !> The state, of no meaning where there is none.
      type(contact_state_t), intent(out) :: state
      !> Receives pairs of transforms and how it ended.
      type(periodic_solution_t), intent(out) :: solution
      type(error_t), allocatable, intent(out) :: error
      !> A state of the same branch on the finest grid that bounds the wanted one: under a load that is not smaller where the branch is
      !> the adhered one, or not larger where it is that of approach. Nothing is asked of coarser grids then. Not given: none is known.
      type(contact_state_t), intent(in), optional :: beside
      type(contact_state_t), allocatable :: states(:)

      if (present(beside)) then
         if (self%grids(size(self%grids))%operator%is_symmetric .and. .not. allocated(adhesion%law)) then
            call solve_beside(self, mean_pressure, adhesion, tolerance, beside, state, solution)
            return
         end if
      end if
      call solve_on_grids(self, shape, mean_pressure, adhesion, tolerance, states, turned, solution, error)
      if (.not. allocated(error)) state = states(size(states))
   end subroutine solve_adhesive_state

   !> Solve on the finest grid from a state that bounds the wanted one.
   subroutine solve_beside(self, mean_pressure, adhesion, tolerance, beside, state, solution)
      type(periodic_solver_t), intent(inout) :: self
      !> Mean pressure [E*].
      real(dp), intent(in) :: mean_pressure
      type(periodic_adhesion_t), intent(in) :: adhesion
      real(dp), intent(in) :: tolerance
      !> The bound.
      type(contact_state_t), intent(in) :: beside
      type(contact_state_t), intent(out) :: state
      !> Receives pairs of transforms and how it ended.
      type(periodic_solution_t), intent(inout) :: solution
      logical :: has_contact
      integer :: n_before

      state = beside
      state%mean_pressure = mean_pressure
      state%has_fixed_mean = .false.
      associate (grid => self%grids(size(self%grids)))
         n_before = grid%operator%n_applied
         call solve_adhesive_contact(state, grid%operator, grid%gap_solver, tolerance, adhesion%is_adhered, &
            & beside%cohesion%share, .true., has_contact)
         solution%n_applied = grid%operator%n_applied - n_before
      end associate
      solution%n_pairs = solution%n_applied
      solution%status = contact_out_of_range
      if (has_contact) solution%status = merge(contact_solved, contact_not_converged, state%is_converged)
   end subroutine solve_beside

   !> Solve on all grids; after a turn the state of the turn first.
   subroutine solve_on_grids(self, shape, mean_pressure, adhesion, tolerance, states, turned, solution, error)
      type(periodic_solver_t), intent(inout) :: self
      !> Gap of the undeformed surfaces in the middles of the cells; 0 at first touch, and no less.
      real(dp), intent(in) :: shape(:, :)
      !> Mean pressure [E*].
      real(dp), intent(in) :: mean_pressure
      type(periodic_adhesion_t), intent(in) :: adhesion
      real(dp), intent(in) :: tolerance
      !> Receives the states, from the coarsest grid to the finest.
      type(contact_state_t), allocatable, intent(out) :: states(:)
      !> States of the turn, if they are known; receives them where they are needed.
      type(contact_state_t), allocatable, intent(inout) :: turned(:)
      !> Receives pairs of transforms and how it ended.
      type(periodic_solution_t), intent(out) :: solution
      type(error_t), allocatable, intent(out) :: error
      integer :: k, n

      call check_shape(self, shape, error)
      if (allocated(error)) return
      call set_states(self, shape, mean_pressure, adhesion, states)
      n = size(states)
      if (adhesion%is_adhered .and. adhesion%has_turned .and. mean_pressure < adhesion%turning_pressure) then
         if (.not. allocated(turned)) then
            allocate (turned, source=states)
            do k = 1, n
               turned(k)%mean_pressure = adhesion%turning_pressure
            end do
            call pass_grids(self, turned, .false., tolerance, solution)
         end if
         do k = 1, n
            if (allocated(turned(k)%gap)) call states(k)%cohesion%open_by(adhesion%opening, turned(k)%gap)
         end do
         solution%status = contact_out_of_range
         if (allocated(turned(n)%gap)) solution%status = merge(contact_solved, contact_not_converged, turned(n)%is_converged)
         if (solution%status == contact_solved) call pass_grids(self, states, .true., tolerance, solution, turned)
      else
         call pass_grids(self, states, adhesion%is_adhered .and. .not. adhesion%has_turned, tolerance, solution)
      end if
   end subroutine solve_on_grids

   !> Shape, load and law on all grids.
   subroutine set_states(self, shape, mean_pressure, adhesion, states)
      type(periodic_solver_t), intent(in) :: self
      !> Gap of the undeformed surfaces in the middles of the cells; 0 at first touch, and no less.
      real(dp), intent(in) :: shape(:, :)
      !> Mean pressure [E*].
      real(dp), intent(in) :: mean_pressure
      type(periodic_adhesion_t), intent(in) :: adhesion
      !> Receives the states, without a gap.
      type(contact_state_t), allocatable, intent(out) :: states(:)
      integer :: k, n

      n = size(self%grids)
      allocate (states(n))
      allocate (states(n)%shape, source=shape)
      do k = n, 1, -1
         if (k < n) allocate (states(k)%shape, source=coarsen(states(k + 1)%shape))
         allocate (states(k)%cohesion)
         call new_cohesion(states(k)%cohesion, adhesion%stress, adhesion%first_range(), self%grids(k)%operator%is_quarter, &
            & adhesion%law)
         if (allocated(adhesion%part)) then
            if (k == n) then
               states(k)%cohesion%part = adhesion%part
            else
               states(k)%cohesion%part = coarsen(states(k + 1)%cohesion%part)
            end if
         end if
         states(k)%mean_pressure = mean_pressure
      end do
   end subroutine set_states

   !> Solve with adhesion on each grid, from the coarsest to the finest.
   subroutine pass_grids(self, states, is_adhered, tolerance, solution, turned)
      type(periodic_solver_t), intent(inout) :: self
      !> In: shape, load and law on each grid. Out: the states; without a gap where there is no contact.
      type(contact_state_t), intent(inout) :: states(:)
      logical, intent(in) :: is_adhered
      real(dp), intent(in) :: tolerance
      !> Receives pairs of transforms and how it ended.
      type(periodic_solution_t), intent(inout) :: solution
      !> States that are more adhered than those that are wanted, or as much.
      type(contact_state_t), intent(in), optional :: turned(:)
      type(contact_state_t) :: blank
      real(dp), allocatable :: bound(:, :), widest(:, :)
      logical :: has_contact, has_guess
      integer :: k, n_before

      has_contact = .false.
      do k = 1, size(states)
         associate (grid => self%grids(k), state => states(k))
            n_before = grid%operator%n_applied
            has_guess = has_contact
            if (present(turned)) then
               ! what has not touched at the turn does not touch after it
               has_contact = allocated(turned(k)%cohesion%share)
               if (.not. has_contact) cycle
            end if
            blank = state
            allocate (bound, widest, mold=state%shape)
            call get_first_bound(state, is_adhered, widest)
            if (present(turned)) widest(:, :) = min(widest, turned(k)%cohesion%share)
            bound(:, :) = widest
            if (has_guess) then
               call start_from_coarse(state, states(max(k - 1, 1)), grid%operator)
               state%mean_pressure = blank%mean_pressure
               call state%cohesion%set_share(state%gap)
            end if
            ! a law that falls slowly has no zones
            if (has_guess .and. k == size(states) .and. .not. (grid%operator%is_symmetric .or. allocated(state%cohesion%law))) then
               call widen_share(state%cohesion%share, grid%operator%is_quarter, is_adhered, bound)
               bound(:, :) = merge(min(bound, widest), max(bound, widest), is_adhered)
            end if
            associate (grid_tolerance => merge(tolerance, coarse_tolerance, k == size(states)))
               if (grid%operator%is_symmetric .and. .not. allocated(state%cohesion%law)) then
                  call solve_adhesive_contact(state, grid%operator, grid%gap_solver, grid_tolerance, is_adhered, bound, &
                     & has_guess, has_contact)
               else
                  call solve_by_rounds(state, grid%operator, grid%gap_solver, grid_tolerance, is_adhered, bound, has_contact)
                  ! steps of time have no turn to come from, and know no penetration of a layer
                  if (k == size(states) .and. has_contact .and. .not. (state%is_converged .or. present(turned) &
                     & .or. state%resists_mean)) &
                     & call solve_by_steps(state, self%kernel, grid%operator, grid%gap_solver, grid_tolerance, is_adhered)
               end if
            end associate
            if (.not. has_contact) state = blank
            deallocate (bound, widest)
            solution%n_applied = grid%operator%n_applied - n_before
            solution%n_pairs = solution%n_pairs + solution%n_applied &
               & *(real(size(state%shape), dp)/size(states(size(states))%shape))
         end associate
      end do
      solution%status = contact_out_of_range
      if (has_contact) solution%status = merge(contact_solved, contact_not_converged, states(size(states))%is_converged)
   end subroutine pass_grids

   !> Shares that bound those of the wanted state whatever it is. Under no load they are those of first touch.
   subroutine get_first_bound(state, is_adhered, bound)
      type(contact_state_t), intent(in) :: state
      logical, intent(in) :: is_adhered
      !> Receives the shares; shape of the cells.
      real(dp), intent(out), contiguous :: bound(:, :)
      type(contact_state_t) :: touch

      bound(:, :) = merge(1, 0, is_adhered)
      if (is_adhered .and. allocated(state%cohesion%part)) then
         touch = state
         call touch%cohesion%set_share(0*state%shape)
         bound(:, :) = touch%cohesion%share
      end if
      if (is_adhered .or. state%resists_mean .or. state%mean_pressure > 0) return
      touch = state
      call touch%cohesion%set_share(state%shape)
      bound(:, :) = touch%cohesion%share
      if (state%mean_pressure < 0) bound(:, :) = 0
   end subroutine get_first_bound

end module adfric_periodic_adhesive_solver
