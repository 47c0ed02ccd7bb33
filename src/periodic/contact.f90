! SPDX-License-Identifier: GPL-3.0-or-later
!> Frictionless contact without adhesion of a rigid periodic surface with an elastic half-space, or another solid, on one grid.
!>
!> Unknown is the gap. With the gap of the undeformed surfaces at first touch g0, the penetration delta, and the displacement
!> u = g - g0 + delta of the surface, of mean zero, the pressure is
!>
!>     p = q + A (g - g0),     p >= 0, g >= 0, p g = 0,
!>
!> A the stiffness, |k|/2 of an elastic half-space (`adfric_periodic_operator`), q the mean pressure; delta = mean(g0) - mean(g). Given the load
!> this is a linear complementarity problem without a constraint, and close to full contact nothing cancels: the few gaps are what
!> is solved for. Off its diagonal A is negative (1-D) or mostly so (2-D), a discrete fractional Laplacian. For such matrices the
!> primal-dual active-set method, which is Newton's, converges from any start (M. Hintermueller, K. Ito, K. Kunisch, SIAM J.
!> Optim. 13, 2002, 865): solve for the gap over the open region (`adfric_periodic_gap_solver`), close the cells whose gap is
!> negative, open those that pull, each time as soon as it is clear which these are (`adfric_periodic_region_search`, which sees to it
!> that this ends). Pressure and gap are carried along; what counts in the end is the pressure that is found from the gap anew.
!>
!> With adhesion p is pressure plus the tension sigma0 t of the shares t of the cells within its range (`adfric_periodic_cohesion`), p >= 0
!> as before. Shares that are prescribed leave the problem as it is. Shares that follow the gap in a straight line make A - sigma0
!> dt/dg of A; they are found anew where the pressure is, which is Newton's method, and it may fail:
!> `adfric_periodic_adhesive_contact`.
!>
!> The pressure cannot be more accurate than the round-off of A g0. Surfaces with steps under very light load, where that is more
!> than the tolerance, are reported as not converged, with the residual that was reached.
module adfric_periodic_contact
   use adfric_base_kinds, only: dp
   use adfric_periodic_cohesion, only: cohesion_t
   use adfric_periodic_gap_solver, only: gap_solver_t, extremes_t
   use adfric_periodic_maps, only: is_shared
   use adfric_periodic_operator, only: periodic_operator_t
   use adfric_periodic_region_search, only: region_search_t, verdict_t, new_region_search
   implicit none (type, external)
   private
   public :: contact_state_t, solve_contact, start_contact, residual_of

   !> Changes of the region and steps that are never needed: it takes about ten and twenty-five.
   integer, parameter :: max_rounds = 300, max_iterations = 3000
   !> How often the solution is begun again where its pressure, found anew, is not as good as it seemed, and no better than before.
   integer, parameter :: most_checks = 3
   !> Pressure in open cells that no step leaves on the way to a contact, in units of the tension of adhesion and the largest pressure.
   real(dp), parameter :: far_pressure = 1.0e3_dp
   !> Residual over the one before up to which it was worth while to begin a solution again.
   real(dp), parameter :: worthwhile = 0.8_dp
   !> How often shares that follow the gap are found anew.
   integer, parameter :: most_shares = 12
   !> Steps in all of them.
   integer, parameter :: newton_iterations = 400
   !> Residual to which the first of these problems is solved, and that of the next in units of what the one before left.
   real(dp), parameter :: first_goal = 1.0e-3_dp, next_goal = 0.02_dp

   !> Contact on one grid; arrays have the shape of its cells.
   type :: contact_state_t
      !> Gap of the undeformed surfaces g0, from any level.
      real(dp), allocatable :: shape(:, :)
      !> Gap g of the deformed surfaces, in the unit of `shape`.
      real(dp), allocatable :: gap(:, :)
      !> Pressure of the gap [E*].
      real(dp), allocatable :: pressure(:, :)
      !> Is the cell open? Its pressure is 0 then, else its gap is.
      logical, allocatable :: is_open(:, :)
      !> Given mean of the gap, or the present one.
      real(dp) :: mean_gap = 0
      !> q, given or the present one [E*].
      real(dp) :: mean_pressure = 0
      !> Is the mean gap given, and not the mean pressure?
      logical :: has_fixed_mean = .false.
      !> Does a layer resist a constant? `mean_pressure` is then that of the penetration alone, before the surface has given way.
      logical :: resists_mean = .false.
      !> Pressure and gap that the residual is measured in.
      real(dp) :: pressure_scale = 1, gap_scale = 1
      !> Mean stiffness of the cells: the pressure of a gap of 1 in a single one [E*].
      real(dp) :: cell_stiffness = 1
      !> Rounds without fewer wrong cells before more is asked of a round; below 0 cells are changed one by one.
      integer :: patience = 3
      !> Changes of the open region, and steps in all of them.
      integer :: n_rounds = 0, n_iterations = 0
      !> Adhesion; not allocated: none. `pressure` then has its tension added. A tension below 0 is a hardness.
      type(cohesion_t), allocatable :: cohesion
      !> Hardness of a solid that has yielded [E*], in which residuals are measured; 0 of an elastic one.
      real(dp) :: hardness = 0
      !> Depth of the impressions in a solid that yields, in the unit of `shape`; not allocated: it does not yield.
      real(dp), allocatable :: plastic_depth(:, :)
      !> Has the solid of the cell yielded? Not allocated: it does not yield.
      logical, allocatable :: has_yielded(:, :)
      !> Has the residual come below the tolerance?
      logical :: is_converged = .false.
   end type contact_state_t

contains

   !> Begin from the geometry alone: where the full contact would pull, or where the undeformed surfaces do not overlap.
   subroutine start_contact(state, operator)
      !> In: the shape and what is given. Out: also gap and open region to begin from.
      type(contact_state_t), intent(inout) :: state
      !> Operator of this grid, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      real(dp) :: depth

      if (.not. allocated(state%gap)) allocate (state%gap, mold=state%shape)
      if (.not. allocated(state%is_open)) allocate (state%is_open(size(state%shape, 1), size(state%shape, 2)))
      state%gap(:, :) = 0
      if (state%has_fixed_mean) then
         depth = sum(state%shape)/size(state%shape) - state%mean_gap
         state%is_open(:, :) = state%shape > depth
         state%gap(:, :) = max(state%shape - depth, 0.0_dp)
      else
         allocate (state%pressure, mold=state%shape)
         call update_pressure(state, operator)
         state%is_open(:, :) = state%pressure < 0
      end if
   end subroutine start_contact

   !> Solve from the gap and the open region in `state`.
   subroutine solve_contact(state, operator, gap_solver, tolerance, is_passing)
      !> In: gap and open region to begin from. Out: the solution; `is_converged` tells whether it was found.
      type(contact_state_t), intent(inout) :: state
      !> Operator of this grid, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      !> Largest residual that is allowed [-], see `residual_of`.
      real(dp), intent(in) :: tolerance
      !> Is the solution one before another? Its pressure is not found anew at the end then. Not given: no.
      logical, intent(in), optional :: is_passing
      type(region_search_t) :: search
      type(verdict_t) :: verdict
      type(extremes_t) :: extremes
      real(dp) :: goal, residual, residual_before
      integer :: n_checks, checks_at_most, most_iterations
      logical :: is_stuck, has_ended

      call begin(state, operator, gap_solver, extremes)
      checks_at_most = most_checks
      if (present(is_passing)) checks_at_most = merge(0, most_checks, is_passing)
      ! what is linear only near the gap is solved no further than it holds
      goal = tolerance
      residual_before = huge(1.0_dp)
      if (follows_gap(state)) then
         checks_at_most = most_shares
         goal = max(tolerance, first_goal)
      end if
      call new_region_search(search, state%patience)
      n_checks = 0
      is_stuck = .false.
      state%is_converged = .false.
      most_iterations = merge(newton_iterations, max_iterations, follows_gap(state))
      do while (state%n_iterations < most_iterations .and. state%n_rounds < max_rounds)
         if (operator%is_stopped()) exit
         call judge(state, extremes, goal, verdict)
         call search%note_step(verdict)
         has_ended = verdict%remaining <= goal*state%pressure_scale/2 .or. is_stuck .or. search%is_stalled()
         if (verdict%violation > 0 .and. (has_ended .or. search%is_due(verdict, goal*state%pressure_scale/2))) then
            call change_region(state, goal, search)
            call gap_solver%set_region(operator, state%is_open, state%has_fixed_mean, state%resists_mean, .true.)
         else if (has_ended) then
            if (checks_at_most > 0) call update_pressure(state, operator)
            residual = residual_of(state)
            state%is_converged = residual <= tolerance
            ! slow steps are none in vain
            if (follows_gap(state) .or. .not. residual <= worthwhile*residual_before) n_checks = n_checks + 1
            if (state%is_converged .or. n_checks > checks_at_most) exit
            if (follows_gap(state)) then
               if (is_stuck .or. residual > residual_before/2) exit
               goal = max(tolerance/2, min(goal, next_goal*residual))
            end if
            residual_before = residual
            call gap_solver%set_region(operator, state%is_open, state%has_fixed_mean, state%resists_mean, state%has_fixed_mean)
            call search%note_region()
         end if
         call gap_solver%improve(operator, state%is_open, state%mean_gap, state%gap, state%pressure, state%mean_pressure, &
            & extremes, is_stuck, state%cohesion)
         if (is_stuck) call gap_solver%advance(0.0_dp, state%gap, state%pressure, extremes)
         state%n_iterations = state%n_iterations + 1
         ! a tension that follows the gap may make the solid give way without end
         if (follows_gap(state)) then
            if (is_stuck .and. extremes%remaining > goal*state%pressure_scale) exit
            if (.not. extremes%remaining <= far_pressure*(state%cohesion%stress + state%pressure_scale)) exit
         end if
      end do
      if (.not. state%has_fixed_mean) state%mean_gap = sum(state%gap)/size(state%gap)
   end subroutine solve_contact

   !> Do shares of adhesion follow the gap?
   pure logical function follows_gap(state)
      type(contact_state_t), intent(in) :: state

      follows_gap = .false.
      if (allocated(state%cohesion)) follows_gap = state%cohesion%is_linear
   end function follows_gap

   !> See to it that gap, region and pressure are those of one contact.
   subroutine begin(state, operator, gap_solver, extremes)
      !> In: gap and open region to begin from. Out: with pressure and scales.
      type(contact_state_t), intent(inout) :: state
      !> Operator of this grid, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      !> Workspace for the cells of this grid; receives the region.
      type(gap_solver_t), intent(inout) :: gap_solver
      !> Receives the largest values of gap and pressure.
      type(extremes_t), intent(out) :: extremes
      real(dp) :: total, lowest, highest
      integer :: j

      if (.not. allocated(state%pressure)) allocate (state%pressure, mold=state%shape)
      call keep_region_sound(state)
      lowest = huge(lowest)
      highest = -huge(highest)
      !$omp parallel do if(is_shared(size(state%shape))) default(none) shared(state) private(j) &
      !$omp& reduction(min:lowest) reduction(max:highest)
      do j = 1, size(state%shape, 2)
         where (.not. state%is_open(:, j)) state%gap(:, j) = 0
         lowest = min(lowest, minval(state%shape(:, j)))
         highest = max(highest, maxval(state%shape(:, j)))
      end do
      !$omp end parallel do
      state%gap_scale = highest - lowest
      if (state%has_fixed_mean) then
         total = sum(state%gap)
         if (.not. total > 0) then
            state%gap(:, :) = merge(1.0_dp, 0.0_dp, state%is_open)
            total = sum(state%gap)
         end if
         state%gap(:, :) = state%gap*(state%mean_gap*size(state%gap)/total)
      end if
      call update_pressure(state, operator)
      state%cell_stiffness = operator%mean_stiffness(operator%n_cells)
      call gap_solver%forget()
      call gap_solver%set_region(operator, state%is_open, state%has_fixed_mean, state%resists_mean, .false.)
      call gap_solver%advance(0.0_dp, state%gap, state%pressure, extremes)
   end subroutine begin

   !> See to it that there is contact, and under a given mean gap that there are open cells. At a given mean gap or penetration of a
   !> layer adhesion holds surfaces that do not touch.
   pure subroutine keep_region_sound(state)
      !> Contact whose open region is mended.
      type(contact_state_t), intent(inout) :: state
      integer :: cell(2)

      if (all(state%is_open)) then
         if ((state%has_fixed_mean .or. state%resists_mean) .and. allocated(state%cohesion)) return
         cell = minloc(state%shape)
         state%is_open(cell(1), cell(2)) = .false.
      else if (state%has_fixed_mean .and. .not. any(state%is_open)) then
         cell = maxloc(state%shape)
         state%is_open(cell(1), cell(2)) = .true.
      end if
   end subroutine keep_region_sound

   !> Find the pressure of the present gap, and the shares that follow it.
   subroutine update_pressure(state, operator)
      !> Contact whose pressure is set from its gap.
      type(contact_state_t), intent(inout) :: state
      !> Operator of this grid, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      real(dp), allocatable :: displacement(:, :)
      integer :: j

      allocate (displacement, mold=state%gap)
      !$omp parallel do if(is_shared(size(displacement))) default(none) shared(state, displacement) private(j)
      do j = 1, size(displacement, 2)
         displacement(:, j) = state%gap(:, j) - state%shape(:, j)
      end do
      !$omp end parallel do
      call operator%apply_stiffness(displacement, state%pressure)
      if (follows_gap(state)) call state%cohesion%follow(state%gap)
      !$omp parallel do if(is_shared(size(displacement))) default(none) shared(state) private(j)
      do j = 1, size(state%pressure, 2)
         state%pressure(:, j) = state%mean_pressure + state%pressure(:, j)
         if (allocated(state%cohesion)) state%pressure(:, j) = state%pressure(:, j) &
            & + state%cohesion%stress*state%cohesion%share(:, j)
      end do
      !$omp end parallel do
   end subroutine update_pressure

   !> Find what is wrong by more than the tolerance.
   pure subroutine judge(state, extremes, tolerance, verdict)
      !> Contact whose gap and pressure are judged; its scale of pressure is set.
      type(contact_state_t), intent(inout) :: state
      type(extremes_t), intent(in) :: extremes
      !> Violation that is allowed, in the contact's scales of gap and pressure [-].
      real(dp), intent(in) :: tolerance
      type(verdict_t), intent(out) :: verdict

      if (extremes%peak > 0) state%pressure_scale = extremes%peak
      ! surfaces that do not touch have no pressure but that of adhesion, which the tension takes away
      if (allocated(state%cohesion) .and. (state%has_fixed_mean .or. state%resists_mean)) &
         & state%pressure_scale = max(extremes%peak, state%cohesion%stress)
      state%pressure_scale = max(state%pressure_scale, state%hardness)
      verdict%remaining = extremes%remaining
      if (extremes%overlap > tolerance*state%gap_scale) verdict%violation = state%cell_stiffness*extremes%overlap
      if (extremes%pull > tolerance*state%pressure_scale) verdict%violation = max(verdict%violation, extremes%pull)
   end subroutine judge

   !> Close open cells that overlap, and open closed ones that pull.
   subroutine change_region(state, tolerance, search)
      !> Contact whose open region is changed.
      type(contact_state_t), intent(inout) :: state
      !> Violation that is allowed, in the contact's scales of gap and pressure [-].
      real(dp), intent(in) :: tolerance
      !> Says whether only the last wrong cell is changed; takes note of the number of wrong cells.
      type(region_search_t), intent(inout) :: search
      logical, allocatable :: is_wrong(:, :)
      integer :: j, n_wrong

      allocate (is_wrong, mold=state%is_open)
      n_wrong = 0
      !$omp parallel do if(is_shared(size(is_wrong))) default(none) shared(state, tolerance, is_wrong) private(j) &
      !$omp& reduction(+:n_wrong)
      do j = 1, size(is_wrong, 2)
         is_wrong(:, j) = merge(state%gap(:, j) < -tolerance*state%gap_scale, &
            & state%pressure(:, j) < -tolerance*state%pressure_scale, state%is_open(:, j))
         n_wrong = n_wrong + count(is_wrong(:, j))
      end do
      !$omp end parallel do
      call search%choose_wrong(n_wrong, is_wrong)
      !$omp parallel do if(is_shared(size(is_wrong))) default(none) shared(state, is_wrong) private(j)
      do j = 1, size(is_wrong, 2)
         state%is_open(:, j) = state%is_open(:, j) .neqv. is_wrong(:, j)
      end do
      !$omp end parallel do
      call keep_region_sound(state)
      state%n_rounds = state%n_rounds + 1
   end subroutine change_region

   !> Largest violation of p >= 0, g >= 0, p g = 0 in any cell, |min(p, g)|, and of a given mean of g, with p in units of the largest
   !> pressure and g in units of the range of the undeformed gap.
   real(dp) function residual_of(state) result(residual)
      type(contact_state_t), intent(in) :: state
      real(dp) :: rows(size(state%gap, 2))
      integer :: j

      !$omp parallel do if(is_shared(size(state%gap))) default(none) shared(state, rows) private(j)
      do j = 1, size(state%gap, 2)
         rows(j) = maxval(abs(min(state%pressure(:, j)/state%pressure_scale, state%gap(:, j)/state%gap_scale)))
      end do
      !$omp end parallel do
      ! NaN where all are
      residual = maxval(rows)
      if (state%has_fixed_mean) residual = max(residual, abs(sum(state%gap)/size(state%gap) - state%mean_gap)/state%gap_scale)
   end function residual_of

end module adfric_periodic_contact
