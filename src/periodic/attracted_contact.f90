! SPDX-License-Identifier: GPL-3.0-or-later
!> Contact of a periodic surface on one grid whose cells attract each other by any law: the most adhered state and the least adhered one
!> under a load.
!>
!> With the gap g of the cells, the stiffness A, the mean pressure q and the tension s(g_i) of each cell a state has
!>
!>     g >= 0,  F = q + A (g - g0) + s(g) >= 0,  g F = 0,
!>
!> F being the pressure and the tension together. No entry of A off its diagonal is positive (in one direction; nearly so in two), so F_i
!> falls with every other gap. Then there is a state with the least gaps in all cells, the most adhered one, and for q > 0 one with
!> the largest (A. Tamir, Math. Program. 7, 1974, 17). Nothing is asked of the law but that the tension of a cell is that of its own gap.
!>
!> Lennard-Jones's law rises up to its largest tension and has no wall: F = 0, and gaps are above -range. The same order holds. Its
!> most adhered state lies above the constant gap at which it pushes the full contact apart, and the least adhered one below the
!> contact without tension, as its push only parts cells further.
!>
!> At the penetration of a layer a constant has a stiffness too, and q is the penetration over the compliance. Bodies apart are a state then.
!>
!> **Bounds.** A gap b on the adhered side of the least gaps, g = 0 at first, goes up by linear problems (`adfric_periodic_linear_step`)
!> whose slopes are no smaller than any chord of the law from b into the interval where the state lies. With such slopes the linear
!> problem has the state as a supersolution, so it never passes the state; without slopes it is a round with the tension as it is. From
!> the other side, from the gap without tension, the same holds with the largest chord downwards. For a convex law that is the
!> tangent, so from that side a step is one of Newton's method and the bound falls to the state quadratically. Where the matrix is
!> not positive definite, slopes are halved, which keeps what was said. Between the steps slow cells go on by themselves
!> (`adfric_periodic_attracted_bound`).
!>
!> **States.** Newton's method finds a state nearby. Any state lies beyond the bound, so it ends the interval of the chords. It is the extremal
!> one if there is w > 0 with (A + diag(c)) w > 0 on the open cells, c the smallest chord from the state towards the bound: with
!> two states x and y in the interval that matrix maps their difference to what is nowhere positive, so the difference is 0. A bound that has become
!> a state itself is the extremal one.
module adfric_periodic_attracted_contact
   use adfric_base_kinds, only: dp
   use adfric_periodic_attracted_bound, only: begin, bound_t, judge, step
   use adfric_periodic_attracted_state, only: find_state_near, has_contact, mean_of, set_scales
   use adfric_periodic_attraction_cells, only: attraction_cells_t
   use adfric_periodic_contact, only: contact_state_t
   use adfric_periodic_linear_step, only: linear_step_t, new_linear_step
   use adfric_periodic_operator, only: periodic_operator_t
   implicit none (type, external)
   private
   public :: solve_attracted_contact

   !> Steps of a bound at most, and on a grid whose state is only where a finer one begins.
   integer, parameter :: most_steps = 300, most_coarse_steps = 75
   !> How far a bound without a wall strays on maps, in ranges.
   real(dp), parameter :: stray = 1.0e-2_dp
   !> What may be left, over what is usual, below which a bound does not go on.
   real(dp), parameter :: least_care = 1.0e-9_dp

contains

   !> Find the extremal state of a grid. Without a wall the most adhered state is found first where the other one is wanted: it ends the
   !> interval of the chords, which without it would reach to gaps at which the law is stiffest.
   subroutine solve_attracted_contact(state, operator, cells, tolerance, falls, has_guess, has_state, start, is_coarse)
      !> In: shape and mean pressure; with a guess also gap and region. Out: the state with F for its pressure; `is_converged` tells
      !> whether it was found.
      type(contact_state_t), intent(inout) :: state
      !> Operator of this grid, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      type(attraction_cells_t), intent(in) :: cells
      !> Largest residual that is allowed [-].
      real(dp), intent(in) :: tolerance
      !> Is the least adhered state wanted? Else the most adhered one is.
      logical, intent(in) :: falls
      !> Is there a guess?
      logical, intent(in) :: has_guess
      !> Is there a state with contact? Without one there is nothing in `state`.
      logical, intent(out) :: has_state
      !> Gap from which the bound begins; not given: without tension (falling) or 0 (rising).
      real(dp), intent(in), optional :: start(:, :)
      !> Is the state only where a finer grid begins?
      logical, intent(in), optional :: is_coarse
      type(linear_step_t) :: work
      type(contact_state_t) :: other, adhered
      integer :: n_steps
      logical :: has_other

      call new_linear_step(work, operator, state%shape, cells%has_wall())
      call set_scales(state, operator)
      n_steps = most_steps
      if (present(is_coarse)) n_steps = merge(most_coarse_steps, most_steps, is_coarse)
      has_other = .false.
      if (has_guess) then
         other = state
         call find_state_near(work, other, operator, cells, tolerance, has_other)
      end if
      if (falls .and. .not. (has_other .or. cells%has_wall())) then
         adhered = state
         call move_bound(work, adhered, operator, cells, tolerance, n_steps, .false., other, has_other, has_state)
         has_other = has_state .and. adhered%is_converged
         if (has_other) other = adhered
      end if
      call move_bound(work, state, operator, cells, tolerance, n_steps, falls, other, has_other, has_state, start)
   end subroutine solve_attracted_contact

   !> Move a bound to the extremal state. It is long by its comments.
   subroutine move_bound(work, state, operator, cells, tolerance, n_steps, falls, other, has_other, has_state, start)
      type(linear_step_t), intent(inout) :: work
      !> In: shape, mean pressure and scales. Out: the state with F for its pressure; `is_converged` tells whether it was found.
      type(contact_state_t), intent(inout) :: state
      type(periodic_operator_t), intent(inout) :: operator
      type(attraction_cells_t), intent(in) :: cells
      real(dp), intent(in) :: tolerance
      !> Steps of the bound, at most.
      integer, intent(in) :: n_steps
      logical, intent(in) :: falls
      !> A state that is known; receives the one that is nearest to the bound.
      type(contact_state_t), intent(inout) :: other
      !> Is one known?
      logical, intent(inout) :: has_other
      !> Is there a state with contact?
      logical, intent(out) :: has_state
      !> Gap from which the bound begins, if it is given.
      real(dp), intent(in), optional :: start(:, :)
      type(bound_t) :: bound
      integer :: k, next_try

      state%is_converged = .false.
      has_state = .true.
      bound%falls = falls
      call begin(work, bound, state, operator, cells, has_state, start)
      if (.not. has_state) return
      next_try = merge(2, 1, has_other)
      do k = 1, n_steps
         if (operator%is_stopped()) exit
         call judge(bound, state, operator, cells)
         if (bound%residual <= tolerance) then
            state%is_converged = .true.
            exit
         end if
         if (.not. (falls .or. state%resists_mean)) has_state = may_hold(bound, state, cells)
         if (.not. has_state) return
         if (has_other) has_other = is_beyond(other%gap, bound, slack(state, cells, tolerance))
         ! from above Newton's method is the step of the bound itself, for a convex law
         if (k >= next_try .and. .not. (falls .and. cells%has_wall())) then
            call look_near(work, bound, state, operator, cells, tolerance, other, has_other)
            next_try = k + 2 + k/4
         end if
         if (has_other) then
            if (is_only(work, bound, other, operator, cells)) then
               state = other
               return
            end if
         end if
         ! nothing more can be gained
         if (bound%care < least_care) exit
         if (has_other) then
            call step(work, bound, state, operator, cells, tolerance, other%gap)
         else
            call step(work, bound, state, operator, cells, tolerance)
         end if
         state%n_iterations = state%n_iterations + 1
      end do
      call take(bound, state)
   end subroutine move_bound

   !> May there be a state with contact above a bound that rises? Tensions are no larger in any state than beyond the gaps of the bound.
   !> Without a wall the least state has contact: else a bit less gap everywhere would pull more in each cell.
   pure logical function may_hold(bound, state, cells)
      type(bound_t), intent(in) :: bound
      !> Mean pressure.
      type(contact_state_t), intent(in) :: state
      type(attraction_cells_t), intent(in) :: cells

      may_hold = .not. state%mean_pressure + mean_of(cells%tension_beyond(bound%gap)) < 0
      if (may_hold .and. .not. cells%has_wall()) may_hold = has_contact(bound%gap, cells)
   end function may_hold

   !> Look for a state from the bound on; one that is farther from the bound than the known one is of no use.
   subroutine look_near(work, bound, state, operator, cells, tolerance, other, has_other)
      type(linear_step_t), intent(inout) :: work
      type(bound_t), intent(in) :: bound
      !> Shape, mean pressure and scales.
      type(contact_state_t), intent(in) :: state
      type(periodic_operator_t), intent(inout) :: operator
      type(attraction_cells_t), intent(in) :: cells
      real(dp), intent(in) :: tolerance
      !> The state that is known; receives the one that is found.
      type(contact_state_t), intent(inout) :: other
      !> Is a state known?
      logical, intent(inout) :: has_other
      type(contact_state_t) :: try
      logical :: has_found

      try = state
      call take(bound, try)
      call find_state_near(work, try, operator, cells, tolerance, has_found)
      if (has_found) has_found = is_beyond(try%gap, bound, slack(state, cells, tolerance))
      if (has_found .and. has_other) has_found = merge(sum(try%gap) > sum(other%gap), sum(try%gap) < sum(other%gap), bound%falls)
      if (.not. has_found) return
      other = try
      has_other = .true.
   end subroutine look_near

   !> Take the gap of a bound.
   pure subroutine take(bound, state)
      type(bound_t), intent(in) :: bound
      type(contact_state_t), intent(inout) :: state

      state%gap = bound%gap
      state%is_open = bound%is_open
      state%pressure = bound%force
   end subroutine take

   !> Gap by which a state may lie on the wrong side of a bound. On maps, whose stiffness has some positive entries, a bound strays.
   pure real(dp) function slack(state, cells, tolerance)
      !> Scale of the gap.
      type(contact_state_t), intent(in) :: state
      type(attraction_cells_t), intent(in) :: cells
      real(dp), intent(in) :: tolerance

      slack = tolerance*state%gap_scale
      if (size(state%shape, 2) > 1 .and. .not. cells%has_wall()) slack = max(slack, stray*cells%law%range)
   end function slack

   !> Does a state lie beyond the bound, but for a small gap?
   pure logical function is_beyond(gap, bound, small)
      real(dp), intent(in) :: gap(:, :)
      type(bound_t), intent(in) :: bound
      real(dp), intent(in) :: small

      if (bound%falls) then
         is_beyond = all(gap <= bound%gap + small)
      else
         is_beyond = all(gap >= bound%gap - small)
      end if
   end function is_beyond

   !> Is there no other state between a bound and a state?
   logical function is_only(work, bound, other, operator, cells)
      type(linear_step_t), intent(inout) :: work
      type(bound_t), intent(in) :: bound
      !> The state.
      type(contact_state_t), intent(in) :: other
      type(periodic_operator_t), intent(inout) :: operator
      type(attraction_cells_t), intent(in) :: cells

      call work%dominates(operator, cells%smallest_chord(other%gap, bound%gap), &
         & other%gap > 0 .or. bound%gap > 0 .or. .not. cells%has_wall(), is_only)
   end function is_only

end module adfric_periodic_attracted_contact
