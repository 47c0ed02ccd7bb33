! SPDX-License-Identifier: GPL-3.0-or-later
!> Frictionless contact without adhesion of a rigid body with an elastic half-space that goes on beyond the body, on one grid.
!>
!> Unknown is the pressure. With the displacement u = S p (`adfric_periodic_free_operator`), the gap g0 of the undeformed surfaces
!> at first touch and the approach delta,
!>
!>     g = u + g0 - delta,     p >= 0, g >= 0, p g = 0    on the cells of the body,     p = 0 elsewhere.
!>
!> The approach is given, or the sum of p is. The active-set method of `adfric_periodic_contact` serves here, too: its steps are the
!> same whether the gap over the open region is solved for or the pressure over the closed one. So are the rules by which regions
!> are changed (`adfric_periodic_region_search`), and the proof that this ends: S is positive definite, so its principal minors are
!> positive. Over a region conjugate gradients solve for the pressure, with the approximate inverse of S, restricted to the region,
!> as preconditioner M. Under a given load the approach is the multiplier of the constraint; directions are kept in the constraint
!> by a projection in the preconditioner (N. I. M. Gould, M. E. Hribar, J. Nocedal, SIAM J. Sci. Comput. 23, 2001, 1376):
!>
!>     z = M (delta - g0 - u),   sum of z = 0.
!>
!> A body that may tilt under its load has delta + t_x (x - x_P) + t_y (y - y_P) instead of delta. Its moments about the point P of
!> the load are 0, so that the tilts are multipliers of the same kind.
module adfric_periodic_free_contact
   use adfric_base_kinds, only: dp
   use adfric_periodic_free_operator, only: free_operator_t
   use adfric_periodic_free_state, only: free_state_t, is_balanced, moment_of, motion_of, solve_motions
   use adfric_periodic_maps, only: add_multiple, dot_of, is_shared, sum_of
   use adfric_periodic_region_search, only: new_region_search, region_search_t, verdict_t
   implicit none (type, external)
   private
   public :: solve_free_contact

   !> Changes of the region and steps that are never needed.
   integer, parameter :: max_rounds = 300, max_iterations = 3000
   !> How often the solution is begun again where its displacement, found anew, is not as good as it seemed.
   integer, parameter :: most_checks = 3
   !> Rounds without fewer wrong cells before more is asked of a round.
   integer, parameter :: patience = 3

   !> Workspace of the steps; arrays have the shape of the cells.
   type :: free_steps_t
      !> What is left of the gap in contact, with the sign of a displacement that is missing; preconditioned; direction, and what
      !> displacement that makes.
      real(dp), allocatable, dimension(:, :) :: residual, correction, direction, image
      !> Numbers of the motions that are not given: 1 for the approach under a given load, 2 and 3 for tilts along x and y.
      integer, allocatable :: motions(:)
      !> Preconditioned motions of the cells in contact; shape of the cells, and number of motions.
      real(dp), allocatable :: moved(:, :, :)
      !> Sums of `moved` times the motions; shape `(n_motions, n_motions)`.
      real(dp), allocatable :: matrix(:, :)
      !> Product of residual and correction at the last step; 0 at the first one.
      real(dp) :: product_before = 0, product = 0
      !> Is the displacement that of the pressure, found anew and not carried along?
      logical :: is_fresh = .false.
   end type free_steps_t

   !> Largest values of a row of cells, 0 where there is none above 0.
   type :: free_largest_t
      !> Pressure, and tension of cells in contact [E*].
      real(dp) :: peak = 0, pull = 0
      !> Gap or overlap in contact, and overlap elsewhere.
      real(dp) :: remaining = 0, overlap = 0
   end type free_largest_t

contains

   !> Solve from the pressure and the region in `state`.
   subroutine solve_free_contact(state, operator, tolerance)
      !> In: pressure and region to begin from, with the load or the approach. Out: the solution; `is_converged` tells whether it
      !> was found.
      type(free_state_t), intent(inout) :: state
      !> Operator of this grid, which counts how often it is applied.
      type(free_operator_t), intent(inout) :: operator
      !> Largest residual that is allowed [-].
      real(dp), intent(in) :: tolerance
      type(region_search_t) :: search
      type(free_steps_t) :: steps
      type(verdict_t) :: verdict
      real(dp) :: peak
      integer :: n_checks
      logical :: has_ended, is_stuck

      allocate (steps%residual, steps%correction, steps%direction, steps%image, mold=state%shape)
      allocate (steps%motions, source=pack([1, 2, 3], [.true., state%may_tilt] .and. state%has_load))
      allocate (steps%moved(size(state%shape, 1), size(state%shape, 2), size(steps%motions)))
      allocate (steps%matrix(size(steps%motions), size(steps%motions)))
      state%is_converged = .false.
      state%n_rounds = 0
      state%n_iterations = 0
      call new_region_search(search, patience)
      call begin_region(state, steps, operator)
      n_checks = 0
      is_stuck = .false.
      do while (state%n_iterations < max_iterations .and. state%n_rounds < max_rounds)
         if (operator%is_stopped()) exit
         call find_correction(state, steps, operator)
         call judge(state, operator, tolerance, verdict, peak)
         call search%note_step(verdict)
         has_ended = verdict%remaining <= aim() .or. is_stuck .or. search%is_stalled()
         is_stuck = .false.
         if (verdict%violation > 0 .and. (has_ended .or. search%is_due(verdict, aim()))) then
            call change_region(state, operator, tolerance, peak, search)
            call begin_region(state, steps, operator)
            cycle
         else if (has_ended) then
            if (steps%is_fresh) n_checks = n_checks + 1
            state%residual = tolerance
            if (peak > 0) state%residual = verdict%remaining/peak
            state%is_converged = steps%is_fresh .and. verdict%remaining <= tolerance*peak .and. .not. verdict%violation > 0
            if (state%is_converged) state%is_converged = is_balanced(state, tolerance)
            if (state%is_converged .or. n_checks > most_checks) exit
            if (.not. steps%is_fresh) then
               call begin_region(state, steps, operator)
               call search%note_region()
               cycle
            end if
         end if
         call step(state, steps, operator, is_stuck)
         state%n_iterations = state%n_iterations + 1
      end do

   contains

      !> What may be left of gaps in contact, as a pressure [E*].
      pure real(dp) function aim()
         aim = tolerance*peak/2
      end function aim

   end subroutine solve_free_contact

   !> Begin steps: see to it that pressure, load and displacement are those of the region.
   subroutine begin_region(state, steps, operator)
      type(free_state_t), intent(inout) :: state
      type(free_steps_t), intent(inout) :: steps
      !> Operator of this grid, which counts how often it is applied.
      type(free_operator_t), intent(inout) :: operator
      real(dp) :: total, change(size(steps%motions))
      integer :: j, k, l

      where (.not. state%is_contact) state%pressure = 0
      if (state%has_load) then
         total = sum_of(state%pressure)
         if (.not. total > 0) then
            state%pressure(:, :) = merge(1.0_dp, 0.0_dp, state%is_contact)
            total = sum_of(state%pressure)
         end if
         state%pressure(:, :) = state%pressure*(state%total/total)
      end if
      do l = 1, size(steps%motions)
         do j = 1, size(state%shape, 2)
            steps%image(:, j) = merge(motion_of(state, steps%motions(l), j), 0.0_dp, state%is_contact(:, j))
         end do
         call operator%apply_stiffness(steps%image, steps%moved(:, :, l))
         where (.not. state%is_contact) steps%moved(:, :, l) = 0
         do k = 1, size(steps%motions)
            steps%matrix(k, l) = moment_of(state, steps%motions(k), steps%moved(:, :, l))
         end do
      end do
      if (size(steps%motions) > 1) then
         ! no moment about the load
         change = 0
         do k = 2, size(steps%motions)
            change(k) = -moment_of(state, steps%motions(k), state%pressure)
         end do
         change = solve_motions(steps%matrix, change)
         do k = 1, size(steps%motions)
            call add_multiple(state%pressure, change(k), steps%moved(:, :, k))
         end do
      end if
      call operator%apply_compliance(state%pressure, state%displacement)
      steps%product_before = 0
      steps%is_fresh = .true.
   end subroutine begin_region

   !> Find what is missing of the displacement in contact, its correction, and the approach under a given load.
   subroutine find_correction(state, steps, operator)
      type(free_state_t), intent(inout) :: state
      type(free_steps_t), intent(inout) :: steps
      type(free_operator_t), intent(inout) :: operator
      real(dp) :: motion(size(steps%motions))
      integer :: j, k

      !$omp parallel do if(is_shared(size(state%shape))) default(none) shared(state, steps) private(j)
      do j = 1, size(state%shape, 2)
         steps%residual(:, j) = merge(-(state%displacement(:, j) + state%shape(:, j)), 0.0_dp, state%is_contact(:, j))
         if (state%has_load) cycle
         where (state%is_contact(:, j)) steps%residual(:, j) = steps%residual(:, j) + state%approach
      end do
      !$omp end parallel do
      call operator%apply_stiffness(steps%residual, steps%correction)
      where (.not. state%is_contact) steps%correction = 0
      if (state%has_load) then
         do k = 1, size(steps%motions)
            motion(k) = -moment_of(state, steps%motions(k), steps%correction)
         end do
         motion = solve_motions(steps%matrix, motion)
         do k = 1, size(steps%motions)
            call add_multiple(steps%correction, motion(k), steps%moved(:, :, k))
            if (steps%motions(k) == 1) state%approach = motion(k)
            if (steps%motions(k) > 1) state%tilt(steps%motions(k) - 1) = motion(k)
         end do
         !$omp parallel do if(is_shared(size(state%shape))) default(none) shared(state, steps) private(j)
         do j = 1, size(state%shape, 2)
            steps%residual(:, j) = steps%residual(:, j) + merge(state%depths(j), 0.0_dp, state%is_contact(:, j))
         end do
         !$omp end parallel do
      end if
      steps%product = dot_of(steps%residual, steps%correction)
   end subroutine find_correction

   !> Take a step of conjugate gradients.
   subroutine step(state, steps, operator, is_stuck)
      type(free_state_t), intent(inout) :: state
      type(free_steps_t), intent(inout) :: steps
      type(free_operator_t), intent(inout) :: operator
      !> Is there nothing to step along any more?
      logical, intent(out) :: is_stuck
      real(dp) :: work

      if (steps%product_before > 0) then
         steps%direction(:, :) = steps%correction + (steps%product/steps%product_before)*steps%direction
      else
         steps%direction(:, :) = steps%correction
      end if
      steps%product_before = steps%product
      call operator%apply_compliance(steps%direction, steps%image)
      work = dot_of(steps%direction, steps%image)
      is_stuck = .not. (work > 0 .and. steps%product > 0)
      if (is_stuck) return
      steps%is_fresh = .false.
      call add_multiple(state%pressure, steps%product/work, steps%direction)
      call add_multiple(state%displacement, steps%product/work, steps%image)
   end subroutine step

   !> Find what is wrong by more than the tolerance.
   subroutine judge(state, operator, tolerance, verdict, peak)
      type(free_state_t), intent(in) :: state
      !> Operator of this grid, for what a pressure does in its own cell.
      type(free_operator_t), intent(in) :: operator
      !> Violation that is allowed [-].
      real(dp), intent(in) :: tolerance
      type(verdict_t), intent(out) :: verdict
      !> Receives the largest pressure [E*].
      real(dp), intent(out) :: peak
      type(free_largest_t) :: rows(size(state%shape, 2))
      real(dp) :: wrong
      integer :: j

      !$omp parallel do if(is_shared(size(state%shape))) default(none) shared(state, rows) private(j)
      do j = 1, size(state%shape, 2)
         call judge_row(state%pressure(:, j), state%displacement(:, j) + state%shape(:, j) - state%depths(j), &
            & state%is_contact(:, j), state%is_body(:, j), rows(j))
      end do
      !$omp end parallel do
      peak = maxval(rows%peak)
      verdict%remaining = maxval(rows%remaining)/operator%own_influence
      wrong = max(maxval(rows%pull), maxval(rows%overlap)/operator%own_influence)
      if (wrong > tolerance*peak) verdict%violation = wrong
   end subroutine judge

   !> Largest values in a row of cells.
   pure subroutine judge_row(pressure, gap, is_contact, is_body, largest)
      real(dp), intent(in) :: pressure(:), gap(:)
      logical, intent(in) :: is_contact(:), is_body(:)
      type(free_largest_t), intent(out) :: largest
      integer :: i

      do i = 1, size(gap)
         if (is_contact(i)) then
            largest%peak = max(largest%peak, pressure(i))
            largest%pull = max(largest%pull, -pressure(i))
            largest%remaining = max(largest%remaining, abs(gap(i)))
         else if (is_body(i)) then
            largest%overlap = max(largest%overlap, -gap(i))
         end if
      end do
   end subroutine judge_row

   !> Part cells in contact that pull, and close others that overlap. There is a contact at the end.
   subroutine change_region(state, operator, tolerance, peak, search)
      type(free_state_t), intent(inout) :: state
      type(free_operator_t), intent(in) :: operator
      !> Violation that is allowed [-], and the largest pressure [E*].
      real(dp), intent(in) :: tolerance, peak
      !> Says whether only the last wrong cell is changed; takes note of the number of wrong cells.
      type(region_search_t), intent(inout) :: search
      logical, allocatable :: is_wrong(:, :)
      integer :: cell(2), j

      allocate (is_wrong, source=state%is_contact)
      do j = 1, size(state%shape, 2)
         where (state%is_contact(:, j))
            is_wrong(:, j) = state%pressure(:, j) < -tolerance*peak
         else where
            is_wrong(:, j) = state%is_body(:, j) .and. &
               & state%displacement(:, j) + state%shape(:, j) - state%depths(j) < -tolerance*peak*operator%own_influence
         end where
      end do
      call search%choose_wrong(count(is_wrong), is_wrong)
      if (all(is_wrong .eqv. state%is_contact)) then
         ! the load stands on something
         cell = maxloc(state%pressure, mask=state%is_contact)
         if (all(cell > 0)) is_wrong(cell(1), cell(2)) = .false.
      end if
      state%is_contact(:, :) = state%is_contact .neqv. is_wrong
      state%n_rounds = state%n_rounds + 1
   end subroutine change_region

end module adfric_periodic_free_contact
