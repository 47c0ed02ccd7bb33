! SPDX-License-Identifier: GPL-3.0-or-later
!> A bound of the gaps of a surface whose cells attract each other: where it begins, and how it moves to the extremal state
!> (`adfric_periodic_attracted_contact`). Where the order is exact it does not pass it.
!>
!> - A linear problem moves all cells at once. It is slow where a patch of cells is near its own jump: others wait for it.
!> - So slow cells, whose tension goes on to change, go on in steps of their own (`adfric_periodic_adhesive_relaxation`). Where the
!>   order is exact these pass no state, since the tension of a cell is that of its own gap. They need a wall: without one a step may
!>   be too long where the law rises.
module adfric_periodic_attracted_bound
   use adfric_base_kinds, only: dp
   use adfric_periodic_adhesive_relaxation, only: relaxation_t, new_relaxation, relax
   use adfric_periodic_attracted_state, only: mean_of, set_force, set_linear_force
   use adfric_periodic_attraction_cells, only: attraction_cells_t
   use adfric_periodic_contact, only: contact_state_t
   use adfric_periodic_linear_step, only: linear_step_t, new_linear_step, step_solved
   use adfric_periodic_operator, only: periodic_operator_t
   implicit none (type, external)
   private
   public :: bound_t, begin, judge, step

   !> What a linear problem may leave, in units of the residual before it.
   real(dp), parameter :: next_goal = 0.003_dp
   !> Part of the slopes below which they are left out.
   real(dp), parameter :: least_part = 0.05_dp
   !> Cells away that a step in a single cell presses on.
   integer, parameter :: farthest = 6
   !> A cell is slow whose tension changes by more than this part of its change before, and by more than a part of the largest change, or of
   !> the largest tension.
   real(dp), parameter :: slow = 0.5_dp, part_of_largest = 0.3_dp, slow_tension = 0.02_dp
   !> Change of a tension over the largest tension up to which a bound that falls needs no steps in single cells.
   real(dp), parameter :: last_change = 1.0e-4_dp

   !> A bound that moves to the state.
   type :: bound_t
      !> Does the bound fall to the least adhered state? Else it rises to the most adhered one.
      logical :: falls = .false.
      !> Part of the slopes that the last step could take.
      real(dp) :: part = 1
      !> What a linear problem may leave, over what is usual.
      real(dp) :: care = 1
      !> Gap b, what presses the cells together there [E*]; shape of the cells.
      real(dp), allocatable :: gap(:, :), force(:, :)
      !> Has the cell a gap? All have where there is no wall. Shape of the cells.
      logical, allocatable :: is_open(:, :)
      !> A gap that no state has less of.
      real(dp) :: least_gap = 0
      !> Residual of b as a state [-].
      real(dp) :: residual = huge(1.0_dp)
      !> By how much the last linear problem changed the tension [E*]; shape of the cells.
      real(dp), allocatable :: change(:, :)
      !> Table of the steps in single cells.
      type(relaxation_t) :: relaxation
   end type bound_t

contains

   !> Where the bound begins.
   subroutine begin(work, bound, state, operator, cells, has_state, start)
      type(linear_step_t), intent(inout) :: work
      type(bound_t), intent(inout) :: bound
      !> Shape and mean pressure.
      type(contact_state_t), intent(in) :: state
      type(periodic_operator_t), intent(inout) :: operator
      type(attraction_cells_t), intent(in) :: cells
      !> Receives whether there may be a state.
      logical, intent(out) :: has_state
      !> Gap to begin from, if it is given.
      real(dp), intent(in), optional :: start(:, :)
      type(linear_step_t) :: walled
      real(dp), allocatable :: nothing(:, :)
      integer :: outcome

      allocate (bound%gap, bound%force, mold=state%shape)
      allocate (bound%is_open(size(state%shape, 1), size(state%shape, 2)))
      call new_relaxation(bound%relaxation, operator, farthest)
      allocate (bound%change, mold=state%shape)
      bound%change(:, :) = cells%law%stress
      call set_least_gap(bound, state, operator, cells, has_state)
      if (.not. has_state) return
      bound%gap(:, :) = bound%least_gap
      if (present(start)) then
         bound%gap(:, :) = start
      else if (bound%falls .and. state%mean_pressure > 0) then
         bound%gap(:, :) = 0
         call set_linear_force(state, operator, bound%gap, bound%force)
         bound%is_open(:, :) = bound%force < 0
         allocate (nothing, source=0*state%shape)
         associate (goal => 1.0e-6_dp*maxval(abs(bound%force)))
            ! a little less load leaves the bound on its side
            bound%force(:, :) = bound%force - goal
            if (cells%has_wall()) then
               call work%solve(operator, nothing, goal, bound%is_open, bound%gap, bound%force, outcome)
            else
               call new_linear_step(walled, operator, state%shape, .true.)
               call walled%solve(operator, nothing, goal, bound%is_open, bound%gap, bound%force, outcome)
            end if
         end associate
         bound%gap(:, :) = max(bound%gap, 0.0_dp)
      else if (bound%falls) then
         bound%gap(:, :) = state%shape
         ! apart, a layer is as it was
         if (state%resists_mean) bound%gap(:, :) = state%shape - operator%mean_compliance*state%mean_pressure
      end if
      bound%is_open(:, :) = bound%gap > 0 .or. .not. cells%has_wall()
   end subroutine begin

   !> A gap that no state has less of: 0 at a wall. Without one it is where the push, or the least tension, carries the full contact at
   !> its lowest pressure. Where a state has its least gap, F is not above that of this gap everywhere, since all others only take
   !> from it.
   subroutine set_least_gap(bound, state, operator, cells, has_state)
      type(bound_t), intent(inout) :: bound
      !> Shape and mean pressure.
      type(contact_state_t), intent(in) :: state
      type(periodic_operator_t), intent(inout) :: operator
      type(attraction_cells_t), intent(in) :: cells
      !> Receives whether there is such a gap; else the load pulls more than all cells do.
      logical, intent(out) :: has_state
      real(dp) :: needed, part(2)

      has_state = .true.
      bound%least_gap = 0
      if (cells%has_wall()) return
      call set_linear_force(state, operator, 0*state%shape, bound%force)
      needed = -maxval(bound%force)
      part = 1
      if (allocated(cells%part)) part = [minval(cells%part), maxval(cells%part)]
      needed = needed/merge(part(1), part(2), needed < 0)
      has_state = needed < cells%law%stress
      if (has_state) bound%least_gap = cells%law%gap_before_largest(needed)
   end subroutine set_least_gap

   !> What presses the cells of a bound together, and how far the bound is from being a state.
   subroutine judge(bound, state, operator, cells)
      type(bound_t), intent(inout) :: bound
      !> Shape and mean pressure; receives the scale of pressures.
      type(contact_state_t), intent(inout) :: state
      type(periodic_operator_t), intent(inout) :: operator
      type(attraction_cells_t), intent(in) :: cells

      call set_force(state, operator, cells, bound%gap, bound%force, bound%residual)
   end subroutine judge

   !> A step of the bound towards the state.
   subroutine step(work, bound, state, operator, cells, tolerance, other)
      type(linear_step_t), intent(inout) :: work
      !> In: with its force. Out: nearer to the state.
      type(bound_t), intent(inout) :: bound
      !> Scales.
      type(contact_state_t), intent(in) :: state
      type(periodic_operator_t), intent(inout) :: operator
      type(attraction_cells_t), intent(in) :: cells
      real(dp), intent(in) :: tolerance
      !> A state at the other end of the interval, if one is known.
      real(dp), intent(in), optional :: other(:, :)
      real(dp), allocatable :: slope(:, :), gap(:, :), force(:, :)
      logical, allocatable :: is_open(:, :)
      real(dp) :: goal, carried
      integer :: outcome
      logical :: has_gained

      allocate (slope, source=0*bound%gap)
      if (present(other)) then
         slope(:, :) = cells%largest_chord(bound%gap, other)
      else if (bound%falls) then
         slope(:, :) = cells%largest_chord(bound%gap, bound%least_gap + 0*bound%gap)
      else if (.not. cells%has_wall()) then
         ! no chord to a larger gap is larger
         slope(:, :) = max(0.0_dp, cells%slope(bound%gap))
      end if
      if (.not. any(slope < 0)) bound%part = 0
      goal = next_goal*bound%care*min(bound%residual, 1.0_dp)*state%pressure_scale
      ! nor may what is left count beside what contact carries in all
      if (state%resists_mean) then
         carried = abs(mean_of(bound%force))
      else
         carried = abs(state%mean_pressure + mean_of(cells%tension(bound%gap)))
      end if
      if (cells%has_wall()) goal = min(goal, next_goal*bound%care*carried)
      goal = max(tolerance/4*state%pressure_scale, goal)
      do
         if (bound%part < least_part) bound%part = 0
         gap = bound%gap
         is_open = bound%is_open
         ! the problem of a load that differs by what may be left lies on the safe side
         force = bound%force + merge(-goal, goal, bound%falls)
         call work%solve(operator, max(slope, bound%part*slope), goal, is_open, gap, force, outcome)
         if (outcome == step_solved .or. .not. bound%part > 0) exit
         bound%part = bound%part/2
         if (operator%is_stopped()) return
      end do
      has_gained = any(merge(gap < bound%gap, gap > bound%gap, bound%falls))
      ! where nothing was gained, what was left has lost
      bound%care = merge(1.0_dp, bound%care/100, outcome == step_solved .and. has_gained)
      if (outcome /= step_solved) return
      force(:, :) = force - merge(-goal, goal, bound%falls) - max(slope, bound%part*slope)*(gap - bound%gap)
      ! on maps, whose order is not exact, a bound may pass the state by a little, and the next step of all cells comes back
      gap(:, :) = max(gap, bound%least_gap)
      if (cells%has_wall()) call go_on(bound, cells, gap, force)
      bound%gap(:, :) = gap
      bound%is_open(:, :) = bound%gap > 0 .or. .not. cells%has_wall()
      bound%part = min(1.0_dp, max(2*bound%part, 2*least_part))
   end subroutine step

   !> Go on from a step of the bound in single cells.
   subroutine go_on(bound, cells, gap, force)
      !> In: as it was before the step. Its change of the tension follows.
      type(bound_t), intent(inout) :: bound
      type(attraction_cells_t), intent(in) :: cells
      !> In: the gap behind the step. Out: one that is nearer to the state.
      real(dp), intent(inout), contiguous :: gap(:, :)
      !> In: what presses the cells together there, with the tension of before [E*]. Out: nothing of use.
      real(dp), intent(inout), contiguous :: force(:, :)
      type(attraction_cells_t) :: law
      real(dp), allocatable :: change(:, :)
      logical, allocatable :: is_slow(:, :)

      allocate (change, source=cells%tension(gap))
      change(:, :) = change - cells%tension(bound%gap)
      force(:, :) = force + change
      change(:, :) = abs(change)
      allocate (is_slow, mold=bound%is_open)
      is_slow(:, :) = change > max(slow*bound%change, min(part_of_largest*maxval(change), slow_tension*cells%law%stress))
      bound%change(:, :) = change
      if (.not. any(is_slow)) return
      ! from above the step of all cells is one of Newton's method, which ends by itself
      if (bound%falls .and. .not. maxval(change) > last_change*cells%law%stress) return
      law = cells
      call relax(bound%relaxation, .not. bound%falls, 0.0_dp, is_slow, law, gap, force)
   end subroutine go_on

end module adfric_periodic_attracted_bound
