!> Frictionless contact without adhesion of a rigid periodic surface with an elastic half-space, on one grid.
!>
!> Unknown is the gap. With the gap of the undeformed surfaces at first touch g0, the penetration delta, and the displacement
!> u = g - g0 + delta of the surface, of mean zero, the pressure is
!>
!>     p = q + A (g - g0),     p >= 0, g >= 0, p g = 0,
!>
!> A the stiffness |k|/2 (`adfric_periodic_operator`), q the mean pressure; delta = mean(g0) - mean(g). Given the load
!> this is a linear complementarity problem without a constraint, and close to full contact nothing cancels: the few gaps are what
!> is solved for. Off its diagonal A is negative (1-D) or nearly so (2-D), a discrete fractional Laplacian. For such matrices the
!> primal-dual active-set method, which is Newton's, converges from any start (M. Hintermueller, K. Ito, K. Kunisch, SIAM J.
!> Optim. 13, 2002, 865): solve for the gap over the open region, close the cells whose gap is negative, open those that pull.
!> Should the number of wrong cells not fall any more, only the last wrong cell is changed, which ends for every positive definite
!> matrix (J. J. Judice, F. M. Pires, Comput. Oper. Res. 21, 1994, 587).
!>
!> The pressure cannot be more accurate than the round-off of A g0. Surfaces with steps under very light load, where that is more
!> than the tolerance, are reported as not converged, with the residual that was reached.
module adfric_periodic_contact
   use adfric_base_kinds, only: dp
   use adfric_periodic_gap_solver, only: gap_solver_t
   use adfric_periodic_operator, only: periodic_operator_t
   implicit none (type, external)
   private
   public :: contact_state_t, solve_contact, start_contact, residual_of

   integer, parameter :: max_rounds = 300
   !> How far the pressure of the open cells is reduced while the region still changes.
   real(dp), parameter :: loose = 0.1_dp

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
      !> Pressure and gap that the residual is measured in.
      real(dp) :: pressure_scale = 1, gap_scale = 1
      !> -A g0.
      real(dp), allocatable :: rest_pressure(:, :)
      !> Rounds without fewer wrong cells before cells are changed one by one.
      integer :: patience = 5
      !> Rounds of the active set, and conjugate gradients in all of them.
      integer :: n_rounds = 0, n_iterations = 0
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

      call prepare(state, operator)
      state%gap = 0*state%shape
      if (state%has_fixed_mean) then
         depth = sum(state%shape)/size(state%shape) - state%mean_gap
         state%is_open = state%shape > depth
         state%gap(:, :) = max(state%shape - depth, 0.0_dp)
      else
         state%is_open = state%mean_pressure + state%rest_pressure < 0
      end if
   end subroutine start_contact

   !> Find once what depends on the shape and on what is given alone.
   subroutine prepare(state, operator)
      !> In: the shape and what is given. Out: also rest pressure, scales, and room for the pressure.
      type(contact_state_t), intent(inout) :: state
      !> Operator of this grid, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator

      if (allocated(state%rest_pressure)) return
      allocate (state%rest_pressure, mold=state%shape)
      allocate (state%pressure, source=0*state%shape)
      call operator%apply_stiffness(state%shape, state%rest_pressure)
      state%rest_pressure(:, :) = -state%rest_pressure
      state%gap_scale = maxval(state%shape) - minval(state%shape)
      state%pressure_scale = maxval(state%rest_pressure) + max(state%mean_pressure, 0.0_dp)
   end subroutine prepare

   !> Solve from the gap and the open region in `state`.
   subroutine solve_contact(state, operator, gap_solver, tolerance)
      !> In: gap and open region to begin from. Out: the solution; `is_converged` tells whether it was found.
      type(contact_state_t), intent(inout) :: state
      !> Operator of this grid, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      !> Workspace for the cells of this grid.
      type(gap_solver_t), intent(inout) :: gap_solver
      !> Largest residual that is allowed [-], see `residual_of`.
      real(dp), intent(in) :: tolerance
      logical, allocatable :: is_wrong(:, :)
      integer :: round, n_wrong, n_wrong_before, fewest, patience, n
      logical :: is_exact
      real(dp) :: aim

      call prepare(state, operator)
      allocate (is_wrong, mold=state%is_open)
      is_exact = .false.
      n_wrong_before = size(is_wrong)
      fewest = size(is_wrong)
      patience = state%patience
      do round = 1, max_rounds
         call keep_region_sound(state)
         call update_pressure(state, operator)
         aim = tolerance*state%pressure_scale/2
         if (.not. is_exact) aim = max(aim, loose*maxval(abs(state%pressure), mask=state%is_open))
         call gap_solver%solve(operator, state%is_open, state%has_fixed_mean, aim, state%pressure, state%gap, &
            & state%mean_pressure, n)
         call update_pressure(state, operator)
         state%n_iterations = state%n_iterations + n
         state%n_rounds = round
         if (any(state%pressure > 0)) state%pressure_scale = maxval(state%pressure)
         call find_wrong_cells(state, tolerance, is_wrong)
         n_wrong = count(is_wrong)
         state%is_converged = is_exact .and. n_wrong == 0 .and. residual_of(state) <= tolerance
         if (state%is_converged) exit
         if (is_exact) then
            patience = merge(state%patience, patience - 1, n_wrong < fewest)
            fewest = min(fewest, n_wrong)
            ! no wrong cell and yet no better: round-off
            if (patience < 0 .and. n_wrong == 0) exit
            if (patience < 0) call keep_last(is_wrong)
         end if
         is_exact = n_wrong == 0 .or. n_wrong >= n_wrong_before .or. patience < 0
         n_wrong_before = n_wrong
         state%is_open = state%is_open .neqv. is_wrong
      end do
      state%mean_gap = sum(state%gap)/size(state%gap)
   end subroutine solve_contact

   !> See to it that the gap is zero in contact, that there is contact, and under a given mean gap that there are open cells and
   !> that the mean is as given.
   pure subroutine keep_region_sound(state)
      !> Contact whose open region and gap are mended.
      type(contact_state_t), intent(inout) :: state
      integer :: cell(2)
      real(dp) :: total

      if (all(state%is_open)) then
         cell = minloc(state%shape)
         state%is_open(cell(1), cell(2)) = .false.
      end if
      if (state%has_fixed_mean .and. .not. any(state%is_open)) then
         cell = maxloc(state%shape)
         state%is_open(cell(1), cell(2)) = .true.
      end if
      where (.not. state%is_open) state%gap = 0
      if (.not. state%has_fixed_mean) return
      total = sum(state%gap)
      if (.not. total > 0) then
         state%gap(:, :) = merge(1.0_dp, 0.0_dp, state%is_open)
         total = sum(state%gap)
      end if
      state%gap(:, :) = state%gap*(state%mean_gap*size(state%gap)/total)
   end subroutine keep_region_sound

   !> Find the pressure of the present gap.
   subroutine update_pressure(state, operator)
      !> Contact whose pressure is set from its gap.
      type(contact_state_t), intent(inout) :: state
      !> Operator of this grid, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator

      call operator%apply_stiffness(state%gap, state%pressure)
      state%pressure(:, :) = state%mean_pressure + state%rest_pressure + state%pressure
   end subroutine update_pressure

   !> Find open cells that overlap and closed cells that pull, by more than the tolerance.
   pure subroutine find_wrong_cells(state, tolerance, is_wrong)
      !> Contact whose gap and pressure are judged.
      type(contact_state_t), intent(in) :: state
      !> Violation that is allowed, in the contact's scales of gap and pressure [-].
      real(dp), intent(in) :: tolerance
      !> Is the cell wrong? Shape of the cells.
      logical, intent(out) :: is_wrong(:, :)

      is_wrong = merge(state%gap < -tolerance*state%gap_scale, state%pressure < -tolerance*state%pressure_scale, state%is_open)
   end subroutine find_wrong_cells

   !> Keep the last of the wrong cells only.
   pure subroutine keep_last(is_wrong)
      !> In: the wrong cells. Out: the last of them alone; none if there is none.
      logical, intent(inout) :: is_wrong(:, :)
      integer :: cell(2)

      if (.not. any(is_wrong)) return
      cell = findloc(is_wrong, .true., back=.true.)
      is_wrong(:, :) = .false.
      is_wrong(cell(1), cell(2)) = .true.
   end subroutine keep_last

   !> Largest violation of p >= 0, g >= 0, p g = 0 in any cell, |min(p, g)|, with p in units of the largest pressure and g in
   !> units of the range of the undeformed gap.
   pure real(dp) function residual_of(state) result(residual)
      !> Contact whose gap and pressure are judged.
      type(contact_state_t), intent(in) :: state

      residual = maxval(abs(min(state%pressure/state%pressure_scale, state%gap/state%gap_scale)))
   end function residual_of

end module adfric_periodic_contact
