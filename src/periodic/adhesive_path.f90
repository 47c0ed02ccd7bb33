! SPDX-License-Identifier: GPL-3.0-or-later
!> Adhesive contact of a periodic surface whose mean gap changes slowly, on one grid.
!>
!> At a given mean gap there is no order of states as under a load (`adfric_periodic_adhesive_contact`): the mean couples all cells, and
!> which state holds depends on those before. So states are followed in steps, each with Newton's method from the last one.
!>
!> - On a path without a jump dE = q d delta, E the energy of solid and adhesion, q the load, delta the penetration. A step whose energy is
!>   not that by the trapezium has passed something, or is too long, and is halved.
!> - A body that slides over a viscoelastic solid has no such energy. Its steps move no edge of adhesion by more than half a cell.
!> - Where the smallest step fails, the state is lost. Shares are prescribed then and found anew in turns, to a state. At rest each
!>   turn lowers the energy; sliding turns need not end, and those that do not are no answer. Near the state Newton's method ends that.
!> - Surfaces without a cell in range are free; they stay so when they part.
module adfric_periodic_adhesive_path
   use adfric_base_kinds, only: dp
   use adfric_periodic_adhesive_contact, only: find_state, solve_again
   use adfric_periodic_contact, only: contact_state_t
   use adfric_periodic_gap_solver, only: gap_solver_t
   use adfric_periodic_maps, only: sum_of
   use adfric_periodic_operator, only: periodic_operator_t
   implicit none (type, external)
   private
   public :: follow_state, is_free, penetration_of

   !> Steps that are made at most, turns after a jump, and turns before a longer step is tried.
   integer, parameter :: most_steps = 2000, most_rounds = 2000, rounds_before = 40
   !> The smallest step of the mean gap, in units of the range of the undeformed gap.
   real(dp), parameter :: least_step = 2.0e-4_dp
   !> Factor of the step after one that went well, and after one that did not.
   real(dp), parameter :: growth = 2, shrinkage = 0.25_dp
   !> Factor by which the smallest step may be larger, for round-off.
   real(dp), parameter :: enough = 1.01_dp
   !> Part of the load that contact carries, by which the energy of a step may differ from that of the trapezium.
   real(dp), parameter :: loss_of_step = 0.02_dp
   !> Largest change of the share of a cell in a step of a surface that slides.
   real(dp), parameter :: most_change = 0.5_dp
   !> Residual of the states on the way.
   real(dp), parameter :: passing_tolerance = 1.0e-7_dp
   !> Largest change of a share that ends the turns.
   real(dp), parameter :: resting_share = 1.0e-7_dp
   !> Newton's state is the one that turns go to where it is not farther than so many times what their shrinking changes add up to.
   real(dp), parameter :: margin = 3

contains

   !> Follow a state to another mean gap.
   subroutine follow_state(state, mean_gap, operator, gap_solver, tolerance, least_load, largest_load, has_arrived)
      !> In: a state, with gap, region and shares. Out: that at the mean gap, with the mean gap fixed.
      type(contact_state_t), intent(inout) :: state
      !> The mean gap, > 0.
      real(dp), intent(in) :: mean_gap
      !> Operator of this grid, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      !> Largest residual of the last state [-].
      real(dp), intent(in) :: tolerance
      !> Receive the smallest and the largest load of the states on the way, those of the ends among them [E*].
      real(dp), intent(out) :: least_load, largest_load
      !> Receives whether the mean gap was reached.
      logical, intent(out) :: has_arrived
      type(contact_state_t) :: next
      real(dp) :: step, shortest, gaps(3), loads(3)
      logical :: has_found, is_last
      integer :: k

      call fix_mean_gap(state)
      least_load = state%mean_pressure
      largest_load = state%mean_pressure
      gaps = state%mean_gap
      loads = state%mean_pressure
      step = mean_gap - state%mean_gap
      shortest = least_step*(maxval(state%shape) - minval(state%shape))
      ! a first cell in range is drawn in at once
      if (is_free(state)) step = sign(min(abs(step), shortest), step)
      has_found = .false.
      is_last = .false.
      do k = 1, most_steps
         if (operator%is_stopped()) exit
         is_last = abs(step) >= abs(mean_gap - state%mean_gap)
         if (is_free(state) .and. mean_gap >= state%mean_gap) then
            call part(state, mean_gap)
            has_found = .true.
            is_last = .true.
            exit
         end if
         next = state
         next%mean_gap = merge(mean_gap, state%mean_gap + step, is_last)
         call find_state(next, operator, gap_solver, merge(tolerance, passing_tolerance, is_last), has_found)
         if (has_found) then
            if (operator%is_symmetric) then
               has_found = is_smooth(state, next)
            else
               has_found = is_near(state, next)
            end if
         end if
         if (.not. has_found .and. abs(next%mean_gap - state%mean_gap) > enough*shortest) then
            step = sign(max(shortest, shrinkage*abs(next%mean_gap - state%mean_gap)), step)
            cycle
         end if
         if (.not. has_found) then
            call jump(state, operator, gap_solver, merge(tolerance, passing_tolerance, is_last), &
               & merge(most_rounds, rounds_before, is_last), next, has_found)
            if (.not. has_found .and. is_last) exit
            ! next to where the state is lost it falls slowly
            if (.not. has_found) then
               shortest = growth*shortest
               step = sign(shortest, step)
               cycle
            end if
            shortest = least_step*(maxval(state%shape) - minval(state%shape))
         end if
         step = growth*step
         call note_load(loads, gaps, next, least_load, largest_load)
         state = next
         if (is_last) exit
      end do
      has_arrived = has_found .and. is_last
   end subroutine follow_state

   !> Take note of the load of one more state; between three of them it is a parabola.
   pure subroutine note_load(loads, gaps, state, least_load, largest_load)
      !> Loads [E*] and mean gaps of the last three states, the last one first; equal where there were fewer.
      real(dp), intent(inout) :: loads(3), gaps(3)
      type(contact_state_t), intent(in) :: state
      !> Smallest and largest load [E*].
      real(dp), intent(inout) :: least_load, largest_load
      real(dp) :: slopes(2), load

      loads = [state%mean_pressure, loads(:2)]
      gaps = [state%mean_gap, gaps(:2)]
      least_load = min(least_load, loads(1))
      largest_load = max(largest_load, loads(1))
      if (.not. product(gaps(:2) - gaps(2:)) > 0) return
      slopes = (loads(:2) - loads(2:))/(gaps(:2) - gaps(2:))
      if (.not. product(slopes) < 0) return
      ! slopes of the parabola at the middle state and its curvature
      associate (slope => sum(slopes*(gaps([2, 1]) - gaps([3, 2])))/(gaps(1) - gaps(3)), &
            & curvature => 2*(slopes(1) - slopes(2))/(gaps(1) - gaps(3)))
         load = loads(2) - slope**2/(2*curvature)
      end associate
      least_load = min(least_load, load)
      largest_load = max(largest_load, load)
   end subroutine note_load

   !> Fix the mean gap of a state, which may have been found under a load.
   subroutine fix_mean_gap(state)
      !> The state; receives its mean gap.
      type(contact_state_t), intent(inout) :: state

      state%has_fixed_mean = .true.
      state%mean_gap = sum_of(state%gap)/size(state%gap)
   end subroutine fix_mean_gap

   !> Part free surfaces.
   subroutine part(state, mean_gap)
      !> In: a state without a cell in range. Out: another one.
      type(contact_state_t), intent(inout) :: state
      real(dp), intent(in) :: mean_gap

      state%gap(:, :) = state%shape + (mean_gap - sum_of(state%shape)/size(state%shape))
      state%pressure(:, :) = 0
      state%mean_pressure = 0
      state%mean_gap = mean_gap
   end subroutine part

   !> Is the energy of a step that of a path without a jump?
   logical function is_smooth(state, next)
      type(contact_state_t), intent(in) :: state, next
      real(dp) :: change, loss, carried

      change = state%mean_gap - next%mean_gap
      carried = abs(next%mean_pressure) + next%cohesion%stress*(sum_of(next%cohesion%share)/size(next%cohesion%share))
      loss = energy_of(next) - energy_of(state) - (state%mean_pressure + next%mean_pressure)/2*change
      is_smooth = abs(loss) <= loss_of_step*carried*abs(change)
   end function is_smooth

   !> Is no cell's share changed by more than half? Two states that are so near are one on these cells.
   logical function is_near(state, next)
      type(contact_state_t), intent(in) :: state, next

      is_near = maxval(abs(next%cohesion%share - state%cohesion%share)) <= most_change
   end function is_near

   !> Energy of solid and adhesion per area [E* times the unit of the gap].
   real(dp) function energy_of(state)
      !> A state with its shares; its pressure is that of the gap and the shares.
      type(contact_state_t), intent(in) :: state
      real(dp), allocatable :: energy(:, :)

      allocate (energy, mold=state%gap)
      energy(:, :) = (state%gap - state%shape)*(state%pressure - state%mean_pressure - state%cohesion%stress*state%cohesion%share)
      energy_of = sum_of(energy)/(2*size(energy)) + state%cohesion%energy_of(state%gap)
   end function energy_of

   !> Go to the state to which a lost one falls.
   subroutine jump(state, operator, gap_solver, tolerance, rounds_at_most, next, has_found)
      type(contact_state_t), intent(in) :: state
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      real(dp), intent(in) :: tolerance
      !> Turns that are made at most.
      integer, intent(in) :: rounds_at_most
      !> In: the mean gap. Out: the state there.
      type(contact_state_t), intent(inout) :: next
      !> Receives whether one was found.
      logical, intent(out) :: has_found
      type(contact_state_t) :: found
      real(dp), allocatable :: share(:, :)
      real(dp) :: change, change_before, mean_gap
      integer :: k, next_try

      mean_gap = next%mean_gap
      next = state
      next%mean_gap = mean_gap
      allocate (share, source=state%cohesion%share)
      next_try = 3
      has_found = .false.
      change = huge(1.0_dp)
      do k = 1, rounds_at_most
         if (operator%is_stopped()) exit
         call next%cohesion%hold()
         call solve_again(next, operator, gap_solver, passing_tolerance)
         share(:, :) = next%cohesion%share
         call next%cohesion%set_share(next%gap)
         change_before = change
         change = maxval(abs(next%cohesion%share - share))
         if (k < next_try .and. change > resting_share) cycle
         next_try = k + max(3, k/4)
         found = next
         call find_state(found, operator, gap_solver, tolerance, has_found)
         if (has_found .and. change > resting_share) has_found = change < change_before .and. &
            & maxval(abs(found%cohesion%share - next%cohesion%share))*(1 - change/change_before) <= margin*change
         if (has_found .or. change <= resting_share) exit
      end do
      if (has_found) then
         next = found
      else if (change <= resting_share) then
         ! no Newton's method, but the shares rest
         call next%cohesion%hold()
         call solve_again(next, operator, gap_solver, tolerance)
         has_found = next%is_converged
      end if
   end subroutine jump

   !> Is no cell within the range?
   pure logical function is_free(state)
      type(contact_state_t), intent(in) :: state

      is_free = .not. any(state%cohesion%share > 0)
   end function is_free

   !> How far the surfaces have approached since first touch, in the unit of the gap.
   real(dp) function penetration_of(state)
      type(contact_state_t), intent(in) :: state

      penetration_of = (sum_of(state%shape) - sum_of(state%gap))/size(state%gap)
   end function penetration_of

end module adfric_periodic_adhesive_path
