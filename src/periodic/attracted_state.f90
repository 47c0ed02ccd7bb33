! SPDX-License-Identifier: GPL-3.0-or-later
!> States of a periodic surface whose cells attract each other, on one grid: what presses the cells together, how far a gap is from a
!> state, and Newton's method, under a mean pressure or at a mean gap.
!>
!> With a hard wall a state has g >= 0, F = q + A (g - g0) + s(g) >= 0, g F = 0. Lennard-Jones's law has no wall, and F = 0 in all
!> cells. At a mean gap q is an unknown as well.
module adfric_periodic_attracted_state
   use adfric_base_kinds, only: dp
   use adfric_periodic_attraction_cells, only: attraction_cells_t
   use adfric_periodic_contact, only: contact_state_t
   use adfric_periodic_linear_step, only: fixed_mean_t, linear_step_t, step_solved
   use adfric_periodic_operator, only: periodic_operator_t
   implicit none (type, external)
   private
   public :: find_state_near, has_contact, is_apart, mean_of, set_force, set_linear_force, set_scales, violation_of

   !> Steps of Newton's method at most.
   integer, parameter :: most_tries = 30
   !> What a linear problem may leave, in units of the residual before it.
   real(dp), parameter :: next_goal = 0.01_dp
   !> Residual over the one before that Newton's method must reach in one of a few tries.
   real(dp), parameter :: worthwhile = 0.5_dp
   !> Part of the largest tension that is none.
   real(dp), parameter :: no_tension = 1.0e-12_dp
   !> The least scale of pressures, in units of the largest tension.
   real(dp), parameter :: least_scale = 1.0e-3_dp
   !> Round-off of a gap, in units of the gap.
   real(dp), parameter :: digits = 8*epsilon(1.0_dp)
   !> Tries without that.
   integer, parameter :: most_failures = 3
   !> Part of the distance from where a law without a wall ends that is left after a step.
   real(dp), parameter :: least_distance = 0.7_dp

contains

   !> Set the scale of gaps, and the stiffness of a cell.
   subroutine set_scales(state, operator)
      !> In: the shape. Out: with scales.
      type(contact_state_t), intent(inout) :: state
      type(periodic_operator_t), intent(in) :: operator

      state%gap_scale = maxval(state%shape) - minval(state%shape)
      state%cell_stiffness = operator%mean_stiffness(operator%n_cells)
      if (.not. allocated(state%pressure)) allocate (state%pressure, mold=state%shape)
   end subroutine set_scales

   !> What presses the cells together without a tension: q + A (g - g0).
   subroutine set_linear_force(state, operator, gap, force)
      !> Shape and mean pressure; at the penetration of a layer that over its compliance stands for it.
      type(contact_state_t), intent(in) :: state
      !> Operator of the grid, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      !> Gap in the cells.
      real(dp), intent(in) :: gap(:, :)
      !> Receives it [E*].
      real(dp), intent(out), contiguous :: force(:, :)

      real(dp) :: mean

      ! far apart the mean, which costs nothing, would only bring round-off
      mean = 0
      if (state%has_fixed_mean) mean = sum(gap - state%shape)/size(gap)
      call operator%apply_stiffness(gap - state%shape - mean, force)
      force(:, :) = state%mean_pressure + force
   end subroutine set_linear_force

   !> What presses the cells together, its scale, and the residual.
   subroutine set_force(state, operator, cells, gap, force, residual)
      !> In: shape and mean pressure. Out: also the scale of pressures.
      type(contact_state_t), intent(inout) :: state
      !> Operator of the grid, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      !> Attraction of the cells.
      type(attraction_cells_t), intent(in) :: cells
      !> Gap in the cells.
      real(dp), intent(in) :: gap(:, :)
      !> Receives F [E*].
      real(dp), intent(out), contiguous :: force(:, :)
      !> Receives the largest violation of the conditions of a state [-].
      real(dp), intent(out) :: residual
      real(dp), allocatable :: tension(:, :)

      allocate (tension, source=cells%tension(gap))
      call set_linear_force(state, operator, gap, force)
      force(:, :) = force + tension
      ! the largest pressure and tension together, or without a wall the larger of both
      if (cells%has_wall()) then
         state%pressure_scale = max(maxval(force), least_scale*cells%law%stress)
      else
         state%pressure_scale = max(maxval(abs(tension)), least_scale*cells%law%stress)
      end if
      residual = violation_of(force, gap, state, cells)
   end subroutine set_force

   !> Largest violation of the conditions of a state [-].
   pure real(dp) function violation_of(force, gap, state, cells) result(violation)
      !> F [E*] and the gap; shape of the cells.
      real(dp), intent(in) :: force(:, :), gap(:, :)
      !> Scales of pressure and gap.
      type(contact_state_t), intent(in) :: state
      !> Attraction of the cells.
      type(attraction_cells_t), intent(in) :: cells

      if (cells%has_wall()) then
         violation = maxval(abs(min(force/state%pressure_scale, gap/state%gap_scale)))
      else
         violation = maxval(abs(force))/state%pressure_scale
      end if
   end function violation_of

   !> Mean of a map.
   pure real(dp) function mean_of(map)
      !> The map; shape of the cells.
      real(dp), intent(in) :: map(:, :)

      mean_of = sum(map)/size(map)
   end function mean_of

   !> Is any cell in contact?
   pure logical function has_contact(gap, cells)
      !> Gap in the cells.
      real(dp), intent(in) :: gap(:, :)
      !> Attraction of the cells.
      type(attraction_cells_t), intent(in) :: cells

      has_contact = .not. minval(gap) > cells%contact_gap()
   end function has_contact

   !> Does no cell attract, but for what is round-off of the largest tension?
   pure logical function is_apart(gap, cells)
      !> Gap in the cells.
      real(dp), intent(in) :: gap(:, :)
      !> Attraction of the cells.
      type(attraction_cells_t), intent(in) :: cells

      is_apart = .not. any(abs(cells%tension(gap)) > no_tension*cells%law%stress)
   end function is_apart

   !> Newton's method for a state near a gap. Under a mean pressure a state without contact is none that is wanted.
   subroutine find_state_near(work, state, operator, cells, tolerance, has_found)
      !> Workspace of this grid.
      type(linear_step_t), intent(inout) :: work
      !> In: gap to begin from, and the mean pressure, or a mean gap that is fixed and a mean pressure to begin from. Out: the state, if it
      !> is found.
      type(contact_state_t), intent(inout) :: state
      !> Operator of the grid, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      !> Attraction of the cells.
      type(attraction_cells_t), intent(in) :: cells
      !> Largest residual that is allowed [-].
      real(dp), intent(in) :: tolerance
      !> Receives whether a state was found.
      logical, intent(out) :: has_found
      type(fixed_mean_t) :: fixed
      real(dp), allocatable :: before(:, :), force(:, :)
      real(dp) :: residual, best, goal, allowed
      integer :: k, n_failures, outcome

      has_found = .false.
      state%is_converged = .false.
      call set_scales(state, operator)
      allocate (before, force, source=state%gap)
      state%is_open = .not. (cells%has_wall() .and. .not. state%gap > 0)
      best = huge(best)
      n_failures = 0
      do k = 1, most_tries
         if (operator%is_stopped()) return
         call set_force(state, operator, cells, state%gap, force, residual)
         state%pressure(:, :) = force
         if (state%has_fixed_mean) residual = max(residual, abs(sum(state%gap)/size(state%gap) - state%mean_gap)/state%gap_scale)
         allowed = tolerance
         ! far apart the gap has no more digits
         if (state%has_fixed_mean) allowed = max(tolerance, digits*maxval(state%gap)*state%cell_stiffness/state%pressure_scale)
         if (.not. residual > allowed) then
            has_found = state%has_fixed_mean .or. state%resists_mean
            if (.not. has_found) has_found = has_contact(state%gap, cells)
            state%is_converged = has_found
            return
         end if
         ! the first mean pressure at a mean gap may be far off
         if (residual > worthwhile*best .and. .not. (state%has_fixed_mean .and. k == 2)) n_failures = n_failures + 1
         if (n_failures > most_failures) return
         best = min(best, residual)
         before(:, :) = state%gap
         goal = max(allowed/4, next_goal*min(residual, 1.0_dp))*state%pressure_scale
         if (state%has_fixed_mean) then
            fixed = fixed_mean_t(state%mean_gap, state%mean_pressure)
            call work%solve(operator, cells%slope(state%gap), goal, state%is_open, state%gap, state%pressure, outcome, fixed)
            state%mean_pressure = fixed%pressure
         else
            call work%solve(operator, cells%slope(state%gap), goal, state%is_open, state%gap, state%pressure, outcome)
         end if
         state%n_iterations = state%n_iterations + 1
         if (outcome /= step_solved) return
         call shorten(before, state%gap, cells)
      end do
   end subroutine find_state_near

   !> Leave out what a step of Newton's method is too long: gaps below 0 at a wall, or those that a law without one does not have.
   pure subroutine shorten(before, gap, cells)
      !> Gap before the step.
      real(dp), intent(in) :: before(:, :)
      !> In: the gap behind it. Out: one that the law has.
      real(dp), intent(inout) :: gap(:, :)
      type(attraction_cells_t), intent(in) :: cells
      real(dp) :: part, falls

      if (cells%has_wall()) then
         gap(:, :) = max(gap, 0.0_dp)
         return
      end if
      ! the largest part of what is left that any cell uses up
      falls = maxval((before - gap)/(before + cells%law%range))
      part = 1
      if (falls > least_distance) part = least_distance/falls
      gap(:, :) = before + part*(gap - before)
   end subroutine shorten

end module adfric_periodic_attracted_state
