! SPDX-License-Identifier: GPL-3.0-or-later
!> Contact with a solid that yields where the pressure reaches its hardness, under a load that only grows.
!>
!> Let h be the gap where the surfaces are apart, less than 0 by the plastic depth where the solid has yielded, and 0 elsewhere. With the
!> hardness H
!>
!>     p = q + A (h - g0),     0 <= p <= H,     p = 0 where h > 0,     p = H where h < 0,
!>
!> which is the minimum of a convex energy, so that there is one state. It depends on no path: where q grows, p falls nowhere, and what
!> has yielded stays at H.
!>
!> **Rounds.** Let Y be any cells. Solve the contact with p = H in Y, whatever h is there. Cells of Y with h > 0 leave it, and the contact is
!> solved again, until none does. Then h <= 0 in Y, and the state is that of a solid that may yield in Y alone. Where A is not
!> positive off its diagonal, a solid that may yield elsewhere, too, has a smaller h everywhere. So all of Y has yielded in the end.
!> Now cells above H join Y. They have yielded in the end as well: with h_i = 0 there, p_i would be no less than it is, since h has fallen
!> elsewhere. So cells that join after this stay, and rounds end, wherever they began. A start that is nearly right takes few of
!> them: that of the coarser grid, or, where the solid is very soft, the cells that lie deepest under the rigid surface. The
!> first rounds let cells join and leave at once. Cells of Y that carry more than the load would part the surfaces; so the least deep
!> ones leave before.
!>
!> Stiffnesses of maps have small positive entries. So what is wrong at the end is looked at, and is a residual.
!>
!> In a round the cells of Y are lowered by a depth that none of them reaches, and H is a tension below 0. So they are open
!> cells of a contact that `adfric_periodic_contact` solves.
module adfric_periodic_yielding
   use adfric_base_kinds, only: dp
   use adfric_periodic_cohesion, only: new_cohesion
   use adfric_periodic_contact, only: contact_state_t, solve_contact
   use adfric_periodic_gap_solver, only: gap_solver_t
   use adfric_periodic_grids, only: refine
   use adfric_periodic_operator, only: periodic_operator_t
   implicit none (type, external)
   private
   public :: guess_yield, guess_from_coarse, solve_yield

   !> Rounds in which cells join and leave at once, most rounds, and how often the depth by which cells are lowered is doubled.
   integer, parameter :: free_rounds = 12, most_rounds = 1000, most_depths = 60
   !> Hardness over the pressure of full contact below which the solid is very soft.
   real(dp), parameter :: very_soft = 0.1_dp

contains

   !> Where a solid yields that is so soft that it carries by the area alone: under the deepest parts of the rigid surface.
   subroutine guess_yield(state, operator, hardness)
      !> In: shape, gap and open region of the elastic solid. Out: also where it yields, if it is very soft.
      type(contact_state_t), intent(inout) :: state
      type(periodic_operator_t), intent(inout) :: operator
      !> Largest pressure that the solid bears [E*].
      real(dp), intent(in) :: hardness
      real(dp) :: pressure(size(state%shape, 1), size(state%shape, 2)), level

      allocate (state%has_yielded(size(state%shape, 1), size(state%shape, 2)), source=.false.)
      call operator%apply_stiffness(state%shape, pressure)
      if (hardness > very_soft*maxval(pressure)) return
      level = level_of_load(state, hardness, state%shape, minval(state%shape), maxval(state%shape))
      state%has_yielded(:, :) = state%shape < level
      state%gap(:, :) = state%shape - level
      state%is_open(:, :) = .true.
   end subroutine guess_yield

   !> Where the solid yields on a grid, from the next coarser one; the mirror of how open cells are found.
   subroutine guess_from_coarse(state, coarse, operator, hardness)
      !> In: shape, gap and open region to begin from. Out: also where it yields.
      type(contact_state_t), intent(inout) :: state
      type(contact_state_t), intent(in) :: coarse
      type(periodic_operator_t), intent(in) :: operator
      !> Largest pressure that the solid bears [E*].
      real(dp), intent(in) :: hardness
      real(dp) :: sign_function(size(coarse%gap, 1), size(coarse%gap, 2)), length
      real(dp) :: depth(size(state%shape, 1), size(state%shape, 2)), detail(size(state%shape, 1), size(state%shape, 2))

      length = maxval(operator%cell_size)
      sign_function = merge(coarse%plastic_depth/length, coarse%pressure - hardness, coarse%plastic_depth > 0)
      detail = state%shape - refine(coarse%shape, state%shape, operator%is_quarter)
      allocate (state%has_yielded(size(depth, 1), size(depth, 2)))
      state%has_yielded(:, :) = refine(sign_function, state%shape, operator%is_quarter) > detail/(2*length)
      depth = refine(coarse%plastic_depth, state%shape, operator%is_quarter) - detail
      where (state%has_yielded) state%gap = min(-depth, 0.0_dp)
   end subroutine guess_from_coarse

   !> Solve the contact of a solid that yields.
   subroutine solve_yield(state, operator, gap_solver, hardness, tolerance)
      !> In: gap, open region and where the solid yields, to begin from, under a mean pressure below the hardness. Out: the
      !> contact with its plastic depth; `is_converged` tells whether it was found.
      type(contact_state_t), intent(inout) :: state
      !> Operator of this grid, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      !> Largest pressure that the solid bears [E*], > 0.
      real(dp), intent(in) :: hardness
      !> Largest residual that is allowed [-], in units of the hardness and of the heights.
      real(dp), intent(in) :: tolerance
      logical, allocatable :: joins(:, :), leaves(:, :)
      real(dp), allocatable :: shape(:, :)
      real(dp) :: depth, height
      integer :: k

      allocate (shape, source=state%shape)
      height = maxval(shape) - minval(shape)
      depth = 2*height
      allocate (joins, leaves, mold=state%has_yielded)
      do k = 1, most_rounds
         call limit_to_load(state, hardness)
         if (any(state%has_yielded)) then
            call solve_lowered(state, operator, gap_solver, shape, hardness, depth, tolerance)
         else
            state%hardness = 0
            call solve_contact(state, operator, gap_solver, tolerance)
         end if
         if (operator%is_stopped()) state%is_converged = .false.
         if (.not. state%is_converged) exit
         joins(:, :) = .not. (state%has_yielded .or. state%is_open) .and. state%pressure > hardness*(1 + tolerance)
         leaves(:, :) = state%has_yielded .and. state%gap > tolerance*height
         if (.not. (any(joins) .or. any(leaves))) exit
         if (any(leaves) .and. k > free_rounds) joins(:, :) = .false.
         state%has_yielded(:, :) = (state%has_yielded .or. joins) .and. .not. leaves
      end do
      state%is_converged = state%is_converged .and. k <= most_rounds
      state%plastic_depth = merge(max(-state%gap, 0.0_dp), 0.0_dp, state%has_yielded)
      if (.not. any(state%has_yielded)) return
      state%is_open(:, :) = state%is_open .and. .not. state%has_yielded
      where (.not. state%is_open) state%gap = 0
      state%pressure_scale = hardness
      state%gap_scale = height
   end subroutine solve_yield

   !> Let the least deep of the cells that have yielded leave, until these carry less than the load.
   pure subroutine limit_to_load(state, hardness)
      type(contact_state_t), intent(inout) :: state
      !> Largest pressure that the solid bears [E*].
      real(dp), intent(in) :: hardness
      real(dp) :: level

      if (carries_less(state, hardness, state%has_yielded)) return
      level = level_of_load(state, hardness, merge(state%gap, huge(level), state%has_yielded), &
         & minval(state%gap) - (maxval(state%shape) - minval(state%shape)), maxval(state%gap))
      where (state%has_yielded .and. .not. state%gap < level)
         state%has_yielded = .false.
         state%is_open = .false.
         state%gap = 0
      end where
   end subroutine limit_to_load

   !> Do cells carry less than the load if they bear the hardness?
   pure logical function carries_less(state, hardness, cells)
      type(contact_state_t), intent(in) :: state
      real(dp), intent(in) :: hardness
      logical, intent(in) :: cells(:, :)

      carries_less = count(cells) < state%mean_pressure*size(cells)/hardness
   end function carries_less

   !> The highest level below which cells carry less than the load, to round-off.
   pure real(dp) function level_of_load(state, hardness, map, low, high) result(level)
      type(contact_state_t), intent(in) :: state
      real(dp), intent(in) :: hardness
      !> Where each cell stands; shape of the cells.
      real(dp), intent(in) :: map(:, :)
      !> Levels between which it lies.
      real(dp), intent(in) :: low, high
      integer, parameter :: most_halvings = 60
      real(dp) :: above, middle
      integer :: k

      level = low
      above = high
      do k = 1, most_halvings
         middle = (level + above)/2
         if (carries_less(state, hardness, map < middle)) then
            level = middle
         else
            above = middle
         end if
      end do
   end function level_of_load

   !> Solve the contact with the hardness as the pressure of cells that have yielded.
   subroutine solve_lowered(state, operator, gap_solver, shape, hardness, depth, tolerance)
      !> In: the contact of the round before, with its h as the gap. Out: that of this round.
      type(contact_state_t), intent(inout) :: state
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      !> Gap of the undeformed surfaces.
      real(dp), intent(in) :: shape(:, :)
      !> Largest pressure that the solid bears [E*].
      real(dp), intent(in) :: hardness
      !> Depth by which cells that have yielded are lowered; doubled where one of them reaches it.
      real(dp), intent(inout) :: depth
      real(dp), intent(in) :: tolerance
      real(dp) :: yielded(size(shape, 1), size(shape, 2))
      integer :: k, n_before

      state%hardness = hardness
      allocate (state%cohesion)
      call new_cohesion(state%cohesion, -hardness, 1.0_dp, operator%is_quarter)
      yielded = merge(1.0_dp, 0.0_dp, state%has_yielded)
      state%cohesion%share = yielded
      do k = 1, most_depths
         state%shape(:, :) = shape + depth*yielded
         state%gap(:, :) = max(state%gap + depth*yielded, 0.0_dp)
         state%is_open(:, :) = state%is_open .or. state%has_yielded
         n_before = state%n_iterations
         state%n_iterations = 0
         state%n_rounds = 0
         call solve_contact(state, operator, gap_solver, tolerance)
         state%n_iterations = state%n_iterations + n_before
         state%gap(:, :) = state%gap - depth*yielded
         state%pressure(:, :) = state%pressure + hardness*yielded
         state%shape(:, :) = shape
         if (all(state%is_open .or. .not. state%has_yielded)) exit
         depth = 2*depth
      end do
      state%is_converged = state%is_converged .and. k <= most_depths
      deallocate (state%cohesion)
   end subroutine solve_lowered

end module adfric_periodic_yielding
