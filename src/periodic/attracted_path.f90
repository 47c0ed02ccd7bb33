! SPDX-License-Identifier: GPL-3.0-or-later
!> Surfaces whose cells attract each other by any law, while their mean gap changes slowly (`adfric_periodic_gap_path`).
!>
!> - On a path without a jump dE = q d delta, E the energy of solid and attraction, q the load, delta the penetration. A step whose energy is
!>   not that by the trapezium has passed something, or is too long.
!> - A lost state falls to another one in rounds, each of which lowers the energy. A falling law has a concave energy, so its tangent,
!>   the tension as it is, lies above it. Lennard-Jones's law is stiff in contact: there the tangent has as much slope as the law
!>   has at the new gap, or more. Near the new state Newton's method ends that.
!> - Where the least stiffness of the solid is above the steepest slope of the law there is one state at each mean gap. So surfaces
!>   that a law without an end draws come from so far apart that they are in it.
module adfric_periodic_attracted_path
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_periodic_attracted_state, only: find_state_near, is_apart, set_linear_force, set_scales
   use adfric_periodic_attraction_cells, only: attraction_cells_t
   use adfric_periodic_contact, only: contact_state_t
   use adfric_periodic_gap_path, only: gap_path_t, passing_tolerance
   use adfric_periodic_linear_step, only: fixed_mean_t, linear_step_t, new_linear_step, step_solved
   use adfric_periodic_maps, only: sum_of
   use adfric_periodic_operator, only: periodic_operator_t
   implicit none (type, external)
   private
   public :: attracted_path_t, distance_apart, new_attracted_path

   !> Part of the load and the tension together by which the energy of a step may differ from that of the trapezium.
   real(dp), parameter :: loss_of_step = 0.02_dp
   !> The least load and tension together that count, in units of the largest tension, and the residual of states on the path: far apart
   !> the load of a state that is less exact would not follow the tension.
   real(dp), parameter :: least_carried = 1.0e-8_dp, path_tolerance = 1.0e-10_dp
   !> Difference of tensions over the largest one that is none: next to a fold states are good to the root of their residual.
   real(dp), parameter :: like_tension = 1.0e-4_dp
   !> Round-off of an energy, over the energy.
   real(dp), parameter :: rounding = 1.0e-13_dp
   !> Change of the mean gap that is none, in units of the range of the undeformed gap.
   real(dp), parameter :: resting_gap = 1.0e-14_dp
   !> Largest change of a tension over the largest tension that ends rounds.
   real(dp), parameter :: resting_change = 1.0e-7_dp
   !> Newton's state is the one that rounds go to where it is not farther than so many times what their shrinking changes add up to.
   real(dp), parameter :: margin = 3
   !> Residual of a round over the change of the one before, and the largest one.
   real(dp), parameter :: part_of_change = 0.02_dp, first_tolerance = 1.0e-3_dp
   !> Slope of a law over the least stiffness of the solid, far apart.
   real(dp), parameter :: far_slope = 0.1_dp
   !> Doublings of a stiffness, and of a distance, that are never needed.
   integer, parameter :: most_doublings = 200

   !> A surface with its attraction.
   type, extends(gap_path_t) :: attracted_path_t
      !> Attraction of the cells.
      type(attraction_cells_t) :: cells
      !> Workspace of linear problems.
      type(linear_step_t) :: work
   contains
      procedure :: find
      procedure :: is_step
      procedure :: jump
      procedure :: is_free
   end type attracted_path_t

contains

   !> A surface on the grid of an operator.
   subroutine new_attracted_path(self, operator, cells, shape)
      !> Receives the surface; the operator stays where it is.
      type(attracted_path_t), intent(out) :: self
      !> Operator of the grid.
      type(periodic_operator_t), intent(in), target :: operator
      !> Attraction of the cells.
      type(attraction_cells_t), intent(in) :: cells
      !> Gap of the undeformed surfaces; shape of the cells.
      real(dp), intent(in) :: shape(:, :)

      self%operator => operator
      self%cells = cells
      call new_linear_step(self%work, operator, shape, cells%has_wall())
   end subroutine new_attracted_path

   !> Least gap of surfaces that are far apart: at the end of the law, or where there is one state at each mean gap.
   pure real(dp) function distance_apart(cells, operator) result(gap)
      !> Attraction of the cells.
      type(attraction_cells_t), intent(in) :: cells
      !> Operator of the grid.
      type(periodic_operator_t), intent(in) :: operator
      real(dp) :: stiffness
      integer :: k

      associate (law => cells%law)
         if (law%has_end()) then
            gap = law%range*(1 + epsilon(gap))
            return
         end if
         ! of the longest wave
         stiffness = pi/maxval(operator%cell_size*operator%n_cells*merge(2, 1, operator%is_quarter))
         gap = law%range
         if (.not. law%has_wall()) gap = law%gap_of_steepest()
         do k = 1, most_doublings
            if (abs(law%slope(gap)) <= far_slope*stiffness) exit
            gap = 2*gap
         end do
      end associate
   end function distance_apart

   !> See `gap_path_t`.
   subroutine find(self, state, tolerance, has_found)
      class(attracted_path_t), intent(inout) :: self
      type(contact_state_t), intent(inout) :: state
      real(dp), intent(in) :: tolerance
      logical, intent(out) :: has_found

      call find_state_near(self%work, state, self%operator, self%cells, min(tolerance, path_tolerance), has_found)
   end subroutine find

   !> See `gap_path_t`: is the energy of a step that of a path without a jump, and does it lead back?
   logical function is_step(self, state, next)
      class(attracted_path_t), intent(inout) :: self
      type(contact_state_t), intent(in) :: state, next
      real(dp) :: change, carried, energies(2)

      change = state%mean_gap - next%mean_gap
      is_step = .not. abs(change) > resting_gap*next%gap_scale
      ! a state is the one that Newton's method finds from itself
      if (is_step) return
      carried = abs(next%mean_pressure) + sum_of(abs(self%cells%tension(next%gap)))/size(next%gap)
      carried = max(carried, least_carried*self%cells%law%stress)
      energies = [energy_of(self, state), energy_of(self, next)]
      is_step = abs(energies(2) - energies(1) - (state%mean_pressure + next%mean_pressure)/2*change) &
         & <= loss_of_step*carried*abs(change) + rounding*maxval(abs(energies))
      if (is_step) is_step = leads_back(self, state, next)
   end function is_step

   !> Does Newton's method lead from the end of a step to its start? From another curve of states it leads to that.
   logical function leads_back(self, state, next)
      class(attracted_path_t), intent(inout) :: self
      type(contact_state_t), intent(in) :: state, next
      type(contact_state_t) :: back

      back = next
      back%mean_gap = state%mean_gap
      call self%find(back, passing_tolerance, leads_back)
      if (.not. leads_back) return
      leads_back = maxval(abs(self%cells%tension(back%gap) - self%cells%tension(state%gap))) <= like_tension*self%cells%law%stress
   end function leads_back

   !> Energy of solid and attraction over area [E* times the unit of the gap].
   real(dp) function energy_of(self, state) result(energy)
      class(attracted_path_t), intent(inout) :: self
      type(contact_state_t), intent(in) :: state
      real(dp), allocatable :: force(:, :), change(:, :)

      ! the mean, which costs nothing, would only bring round-off
      allocate (force, change, source=state%gap - state%shape)
      change(:, :) = change - sum(change)/size(change)
      call self%operator%apply_stiffness(change, force)
      energy = sum(change*force)/(2*size(force)) + self%cells%energy(state%gap) + self%cells%opening_loss(state%gap)
   end function energy_of

   !> See `gap_path_t`.
   subroutine jump(self, state, tolerance, rounds_at_most, next, has_found)
      class(attracted_path_t), intent(inout) :: self
      type(contact_state_t), intent(in) :: state
      real(dp), intent(in) :: tolerance
      integer, intent(in) :: rounds_at_most
      type(contact_state_t), intent(inout) :: next
      logical, intent(out) :: has_found
      type(contact_state_t) :: found
      real(dp), allocatable :: tension(:, :)
      real(dp) :: change, change_before, mean_gap
      integer :: k, next_try
      logical :: is_done

      mean_gap = next%mean_gap
      next = state
      next%mean_gap = mean_gap
      call set_scales(next, self%operator)
      next_try = 3
      has_found = .false.
      change = 1
      do k = 1, rounds_at_most
         if (self%operator%is_stopped()) exit
         tension = self%cells%tension(next%gap)
         call go_round(self, next, max(passing_tolerance, min(first_tolerance, part_of_change*change)), is_done)
         if (.not. is_done) return
         change_before = change
         change = maxval(abs(self%cells%tension(next%gap) - tension))/self%cells%law%stress
         if (k < next_try .and. change > resting_change) cycle
         next_try = k + max(3, k/4)
         found = next
         call self%find(found, tolerance, has_found)
         ! what rests is the state, however far Newton's method goes from there
         if (has_found) has_found = change < change_before .or. change <= resting_change
         if (has_found) has_found = maxval(abs(self%cells%tension(found%gap) - self%cells%tension(next%gap))) &
            & *(1 - min(change/change_before, 1.0_dp)) <= margin*max(change, resting_change)*self%cells%law%stress
         if (has_found .or. change <= resting_change) exit
      end do
      if (has_found) next = found
   end subroutine jump

   !> A round at the mean gap of a state.
   subroutine go_round(self, state, tolerance, is_done)
      class(attracted_path_t), intent(inout) :: self
      !> In: with a mean gap that is fixed. Out: with a gap of no more energy at this mean.
      type(contact_state_t), intent(inout) :: state
      !> What may be left, over the largest tension [-].
      real(dp), intent(in) :: tolerance
      !> Receives whether the linear problem was solved.
      logical, intent(out) :: is_done
      type(fixed_mean_t) :: fixed
      real(dp), allocatable :: slope(:, :), gap(:, :), force(:, :), first(:, :)
      logical, allocatable :: is_open(:, :)
      integer :: k, outcome
      logical :: is_enough

      allocate (first, mold=state%gap)
      call set_linear_force(state, self%operator, state%gap, first)
      first(:, :) = first + self%cells%tension(state%gap)
      allocate (slope, source=max(0.0_dp, self%cells%slope(state%gap)))
      is_done = .false.
      do k = 1, most_doublings
         gap = state%gap
         force = first
         is_open = gap > 0 .or. .not. self%cells%has_wall()
         fixed = fixed_mean_t(state%mean_gap, state%mean_pressure)
         call self%work%solve(self%operator, slope, tolerance*self%cells%law%stress, is_open, gap, force, outcome, fixed)
         if (self%operator%is_stopped()) return
         if (outcome /= step_solved) return
         if (self%cells%has_wall()) exit
         call stiffen(self, state%gap, gap, slope, is_enough)
         if (is_enough) exit
      end do
      is_done = k <= most_doublings
      if (self%cells%has_wall()) gap(:, :) = max(gap, 0.0_dp)
      state%gap = gap
      state%is_open = is_open
      state%mean_pressure = fixed%pressure
   end subroutine go_round

   !> See to it that the law has no more slope than given at any gap between this one and a smaller one.
   subroutine stiffen(self, before, gap, slope, is_enough)
      class(attracted_path_t), intent(in) :: self
      !> Gap before and behind; shape of the cells.
      real(dp), intent(in) :: before(:, :), gap(:, :)
      !> In: the slope. Out: more of it where the law has more; shape of the cells.
      real(dp), intent(inout) :: slope(:, :)
      !> Receives whether there was enough of it.
      logical, intent(out) :: is_enough
      real(dp), parameter :: least_part = 0.05_dp
      real(dp), allocatable :: slopes(:, :)

      allocate (slopes, source=self%cells%slope(max(gap, -(1 - least_part)*self%cells%law%range)))
      is_enough = .not. any(gap < before .and. slopes > slope)
      if (is_enough) return
      slopes(:, :) = self%cells%slope(max(gap, 0.0_dp))
      where (gap < before) slope = max(2*slope, slopes)
   end subroutine stiffen

   !> See `gap_path_t`: no cell attracts.
   logical function is_free(self, state)
      class(attracted_path_t), intent(in) :: self
      type(contact_state_t), intent(in) :: state

      is_free = is_apart(state%gap, self%cells)
   end function is_free

end module adfric_periodic_attracted_path
