! SPDX-License-Identifier: GPL-3.0-or-later
!> From a contact without adhesion on an elastic half-space to that of a lighter load, by what changes.
!>
!> Known are the gap g and the pressure p of the mean pressure P. Under P - D the gap is g + h and the pressure p - r with
!>
!>     r = D - A h,     g + h >= 0,  p - r >= 0,  (g + h) (p - r) = 0
!>
!> (`adfric_periodic_contact`), so where the lighter load leaves the surfaces apart A_OO h = D - p, and elsewhere h = -g. Unknown are h
!> and r alone: no digits are lost where D is small, since nothing is the difference of two contacts, and round-off of A g0 is in neither.
!> What remains of the pressure is measured by the largest r, or the largest p - r where that is less.
!>
!> On lines no cell comes into contact, and all cells of p < D leave it (docs/theory/periodic_slip.md, Proofs). On maps that is nearly
!> so. So the search begins with the cells of p < D open, and then opens and closes cells as that of any contact does: what is found
!> fulfils all conditions.
!>
!> The slope of the mean gap where the contact stays as it is (`adfric_periodic_punch`) needs the same matrix, and begins from h.
module adfric_periodic_lighter_load
   use adfric_base_kinds, only: dp
   use adfric_periodic_cohesion, only: cohesion_t
   use adfric_periodic_gap_solver, only: extremes_t, gap_solver_t
   use adfric_periodic_maps, only: dot_of, is_shared, sum_of
   use adfric_periodic_operator, only: periodic_operator_t
   use adfric_periodic_punch, only: finish_punch
   use adfric_periodic_region_search, only: new_region_search, region_search_t, verdict_t
   implicit none (type, external)
   private
   public :: lighter_load_t, find_lighter_load

   !> Changes of the region and steps that are never needed, as in `adfric_periodic_contact`.
   integer, parameter :: max_rounds = 300, max_iterations = 3000
   !> Rounds without fewer wrong cells before more is asked of a round.
   integer, parameter :: patience = 3
   !> How often the steps go on where the pressure, found anew, is not as good as it seemed.
   integer, parameter :: most_checks = 3
   !> Residual at which the pressure is found anew, over the tolerance.
   real(dp), parameter :: almost = 0.9_dp

   !> What a lighter load changes; arrays have the shape of the cells.
   type :: lighter_load_t
      !> By how much the gap is larger, h.
      real(dp), allocatable :: rise(:, :)
      !> By how much the pressure is less, r [E*].
      real(dp), allocatable :: fall(:, :)
      !> Is the cell open under the lighter load?
      logical, allocatable :: is_open(:, :)
      !> Slope of the mean of `rise` over the mean of `fall` where the open cells stay so [unit of the gap over E*]; 0 in full contact.
      real(dp) :: compliance = 0
      !> Largest violation of the conditions of contact, in pressure by the largest `fall`, or by the largest pressure if that is less, and
      !> in the gap by the largest `rise`.
      real(dp) :: residual = huge(1.0_dp)
      !> Steps in all.
      integer :: n_iterations = 0
      !> Has the residual come below the tolerance, and was the compliance found?
      logical :: is_converged = .false.
   end type lighter_load_t

   !> The search for it; arrays have the shape of the cells.
   type :: lighter_search_t
      !> h in open cells, g + h in closed ones, where it comes to be 0.
      real(dp), allocatable :: gap(:, :)
      !> p - r in open cells, where it comes to be 0, -r in closed ones [E*].
      real(dp), allocatable :: pressure(:, :)
      !> Pressure and gap that violations are measured in.
      real(dp) :: pressure_scale = 1, gap_scale = 1
      !> Mean stiffness of the cells: the pressure of a gap of 1 in a single one [E*].
      real(dp) :: cell_stiffness = 1
      !> What is wrong.
      type(verdict_t) :: verdict
      !> Does the last change of the region leave gaps in closed cells?
      logical :: has_remains = .false.
   end type lighter_search_t

   !> Largest values over the cells, 0 where there is none above 0.
   type :: largest_t
      !> Pressure or tension p - r of open cells, tension of closed ones, and pressure of these [E*].
      real(dp) :: remaining = 0, pull = 0, peak = 0
      !> r of closed cells [E*].
      real(dp) :: fall = 0
      !> Overlap of the surfaces in open cells, and |h| there.
      real(dp) :: overlap = 0, rise = 0
   end type largest_t

contains

   !> Find what a lighter load changes.
   subroutine find_lighter_load(self, operator, gap_solver, pressure, gap, relief, tolerance)
      !> Receives what changes; `is_converged` tells whether it was found.
      type(lighter_load_t), intent(out) :: self
      !> Operator of the cells, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      !> Pressure p [E*] and gap g of the contact under the heavier load: one of both is 0 in every cell, none is below.
      real(dp), intent(in), contiguous :: pressure(:, :), gap(:, :)
      !> By how much the mean pressure is less, D [E*]: above 0, and less than the mean of `pressure`.
      real(dp), intent(in) :: relief
      real(dp), intent(in) :: tolerance
      type(lighter_search_t) :: search

      call begin(self, search, operator, pressure, relief)
      if (.not. any(self%is_open)) then
         ! full contact stays
         self%residual = 0
         self%is_converged = .true.
      else
         call improve(self, search, operator, gap_solver, pressure, gap, relief, tolerance)
         call find_slope(self, search, operator, gap_solver, pressure, relief, tolerance)
      end if
      call set_changes(self, search, pressure, gap, relief)
   end subroutine find_lighter_load

   !> Begin with the cells open that are so under the heavier load, or bear less than the relief.
   subroutine begin(self, search, operator, pressure, relief)
      type(lighter_load_t), intent(inout) :: self
      type(lighter_search_t), intent(inout) :: search
      type(periodic_operator_t), intent(in) :: operator
      !> Pressure under the heavier load [E*].
      real(dp), intent(in), contiguous :: pressure(:, :)
      !> By how much the mean pressure is less [E*].
      real(dp), intent(in) :: relief

      allocate (self%is_open, source=pressure < relief)
      allocate (search%gap(size(pressure, 1), size(pressure, 2)))
      allocate (search%pressure, mold=search%gap)
      search%gap(:, :) = 0
      search%pressure(:, :) = merge(pressure, 0.0_dp, self%is_open) - relief
      search%cell_stiffness = operator%mean_stiffness(operator%n_cells)
   end subroutine begin

   !> Take steps and change the region until all conditions hold.
   subroutine improve(self, search, operator, gap_solver, pressure, gap, relief, tolerance)
      !> In: open cells to begin from. Out: those that were found, and how well.
      type(lighter_load_t), intent(inout) :: self
      !> In: gap and pressure to begin from. Out: those that were found.
      type(lighter_search_t), intent(inout) :: search
      !> Operator of the cells, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      !> Pressure [E*] and gap under the heavier load.
      real(dp), intent(in), contiguous :: pressure(:, :), gap(:, :)
      !> By how much the mean pressure is less [E*].
      real(dp), intent(in) :: relief
      real(dp), intent(in) :: tolerance
      type(region_search_t) :: region
      type(cohesion_t), allocatable :: none
      type(extremes_t) :: unused
      real(dp) :: mean_pressure
      integer :: n_checks, n_rounds
      logical :: is_stuck, has_ended

      call new_region_search(region, patience)
      call gap_solver%forget()
      call gap_solver%set_region(operator, self%is_open, .false., .false., .false.)
      mean_pressure = -relief
      is_stuck = .false.
      n_checks = 0
      n_rounds = 0
      do while (self%n_iterations < max_iterations .and. n_rounds < max_rounds)
         if (operator%is_stopped()) exit
         call judge(search, self%is_open, pressure, gap, tolerance)
         call region%note_step(search%verdict)
         has_ended = search%verdict%remaining <= aim() .or. is_stuck .or. region%is_stalled()
         if (search%verdict%violation > 0 .and. (has_ended .or. region%is_due(search%verdict, aim()))) then
            call change_region(search, self%is_open, pressure, gap, tolerance, region)
            call gap_solver%set_region(operator, self%is_open, .false., .false., search%has_remains)
            n_rounds = n_rounds + 1
         else if (has_ended) then
            call update_pressure(search, operator, self%is_open, pressure, gap, relief)
            call judge(search, self%is_open, pressure, gap, tolerance)
            self%residual = max(search%verdict%remaining/search%pressure_scale, tolerance*merge(2, 0, search%verdict%violation > 0))
            self%is_converged = self%residual <= tolerance
            n_checks = n_checks + 1
            if (self%is_converged .or. n_checks > most_checks) exit
            call gap_solver%set_region(operator, self%is_open, .false., .false., .false.)
            call region%note_region()
         end if
         call gap_solver%improve(operator, self%is_open, 0.0_dp, search%gap, search%pressure, mean_pressure, unused, is_stuck, none)
         self%n_iterations = self%n_iterations + 1
      end do

   contains

      !> Pressure that may be left in open cells [E*].
      pure real(dp) function aim()
         aim = almost*tolerance*search%pressure_scale
      end function aim

   end subroutine improve

   !> Find what is wrong by more than the tolerance, and the scales.
   subroutine judge(search, is_open, pressure, gap, tolerance)
      type(lighter_search_t), intent(inout) :: search
      logical, intent(in), contiguous :: is_open(:, :)
      !> Pressure [E*] and gap under the heavier load.
      real(dp), intent(in), contiguous :: pressure(:, :), gap(:, :)
      !> Violation that is allowed, in the scales [-].
      real(dp), intent(in) :: tolerance
      type(largest_t) :: rows(size(gap, 2))
      real(dp) :: overlap, pull
      integer :: j

      !$omp parallel do if(is_shared(size(gap))) default(none) shared(search, is_open, pressure, gap, rows) private(j)
      do j = 1, size(gap, 2)
         call judge_row(search%gap(:, j), search%pressure(:, j), is_open(:, j), pressure(:, j), gap(:, j), rows(j))
      end do
      !$omp end parallel do
      search%pressure_scale = min(maxval(rows%fall), maxval(rows%peak))
      search%gap_scale = maxval(rows%rise)
      overlap = maxval(rows%overlap)
      pull = maxval(rows%pull)
      search%verdict%remaining = maxval(rows%remaining)
      search%verdict%violation = 0
      if (overlap > tolerance*search%gap_scale) search%verdict%violation = search%cell_stiffness*overlap
      if (pull > tolerance*search%pressure_scale) search%verdict%violation = max(search%verdict%violation, pull)
   end subroutine judge

   !> Largest values in a row of cells.
   pure subroutine judge_row(rise, rest, is_open, pressure, gap, largest)
      !> Gap and pressure of the search.
      real(dp), intent(in), contiguous :: rise(:), rest(:)
      logical, intent(in), contiguous :: is_open(:)
      !> Pressure [E*] and gap under the heavier load.
      real(dp), intent(in), contiguous :: pressure(:), gap(:)
      type(largest_t), intent(out) :: largest
      integer :: i

      do i = 1, size(rise)
         if (is_open(i)) then
            largest%remaining = max(largest%remaining, abs(rest(i)))
            largest%overlap = max(largest%overlap, -(gap(i) + rise(i)))
            largest%rise = max(largest%rise, abs(rise(i)))
         else
            largest%fall = max(largest%fall, -rest(i))
            largest%peak = max(largest%peak, pressure(i) + rest(i))
            largest%pull = max(largest%pull, -(pressure(i) + rest(i)))
         end if
      end do
   end subroutine judge_row

   !> Close open cells that overlap, and open closed ones that pull.
   subroutine change_region(search, is_open, pressure, gap, tolerance, region)
      !> In: gap and pressure of the old region. Out: of the new one.
      type(lighter_search_t), intent(inout) :: search
      !> Is the cell open? It is changed.
      logical, intent(inout), contiguous :: is_open(:, :)
      !> Pressure [E*] and gap under the heavier load.
      real(dp), intent(in), contiguous :: pressure(:, :), gap(:, :)
      !> Violation that is allowed, in the scales [-].
      real(dp), intent(in) :: tolerance
      !> Says whether only the last wrong cell is changed; takes note of the number of wrong cells.
      type(region_search_t), intent(inout) :: region
      logical, allocatable :: is_wrong(:, :)
      integer :: cell(2)

      allocate (is_wrong, source=merge(gap + search%gap < -tolerance*search%gap_scale, &
         & pressure + search%pressure < -tolerance*search%pressure_scale, is_open))
      call region%choose_wrong(count(is_wrong), is_wrong)
      if (all(is_open .neqv. is_wrong)) then
         ! the load stands on something
         cell = maxloc(pressure)
         is_wrong(cell(1), cell(2)) = is_open(cell(1), cell(2))
      end if
      search%has_remains = any(is_wrong .and. is_open)
      where (is_wrong .and. is_open)
         search%gap = search%gap + gap
         search%pressure = search%pressure - pressure
      else where (is_wrong)
         search%gap = search%gap - gap
         search%pressure = search%pressure + pressure
      end where
      is_open = is_open .neqv. is_wrong
   end subroutine change_region

   !> Find the pressure of the present gap anew.
   subroutine update_pressure(search, operator, is_open, pressure, gap, relief)
      !> The search, whose pressure is set from its gap.
      type(lighter_search_t), intent(inout) :: search
      !> Operator of the cells, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      logical, intent(in), contiguous :: is_open(:, :)
      !> Pressure [E*] and gap under the heavier load.
      real(dp), intent(in), contiguous :: pressure(:, :), gap(:, :)
      !> By how much the mean pressure is less [E*].
      real(dp), intent(in) :: relief

      call operator%apply_stiffness(search%gap - merge(0.0_dp, gap, is_open), search%pressure)
      search%pressure(:, :) = (search%pressure - relief) + merge(pressure, 0.0_dp, is_open)
   end subroutine update_pressure

   !> Find the slope of the mean gap from the multiple of h with the least error, mean(k A k) - 2 mean(k), that of k = b h where b is
   !> sum(h)/sum(h A h). It is k itself where no cell of `pressure` has opened.
   subroutine find_slope(self, search, operator, gap_solver, pressure, relief, tolerance)
      !> In: with the open cells. Out: with the compliance; not converged if that was not found.
      type(lighter_load_t), intent(inout) :: self
      !> The search at its end; its gap and pressure are kept.
      type(lighter_search_t), intent(in) :: search
      !> Operator of the cells, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      !> Pressure under the heavier load [E*].
      real(dp), intent(in), contiguous :: pressure(:, :)
      !> By how much the mean pressure is less [E*].
      real(dp), intent(in) :: relief
      !> Relative error that is allowed [-].
      real(dp), intent(in) :: tolerance
      real(dp), allocatable :: gap(:, :), rest(:, :)
      logical :: is_found

      allocate (gap, mold=search%gap)
      allocate (rest, mold=search%gap)
      ! A h in open cells
      rest(:, :) = merge(search%pressure + relief - pressure, 0.0_dp, self%is_open)
      gap(:, :) = merge(search%gap, 0.0_dp, self%is_open)
      associate (total => sum_of(gap), energy => dot_of(gap, rest))
         if (energy > 0) then
            gap(:, :) = gap*(total/energy)
            rest(:, :) = rest*(total/energy)
         end if
      end associate
      rest(:, :) = rest - 1
      call finish_punch(operator, gap_solver, self%is_open, tolerance, gap, rest, self%compliance, is_found)
      self%is_converged = self%is_converged .and. is_found
   end subroutine find_slope

   !> From the search to what changes. What little pressure was left in open cells is that of the others, so that they carry the load.
   subroutine set_changes(self, search, pressure, gap, relief)
      !> In: with the open cells. Out: with `rise` and `fall`.
      type(lighter_load_t), intent(inout) :: self
      type(lighter_search_t), intent(inout) :: search
      !> Pressure [E*] and gap under the heavier load.
      real(dp), intent(in), contiguous :: pressure(:, :), gap(:, :)
      !> By how much the mean pressure is less [E*].
      real(dp), intent(in) :: relief
      real(dp) :: of_open, of_closed

      self%rise = merge(search%gap, -gap, self%is_open)
      self%fall = merge(pressure, -search%pressure, self%is_open)
      of_open = sum(self%fall, mask=self%is_open)
      of_closed = sum(self%fall, mask=.not. self%is_open)
      if (of_closed > 0) then
         where (.not. self%is_open) self%fall = self%fall*((relief*size(gap) - of_open)/of_closed)
      end if
   end subroutine set_changes

end module adfric_periodic_lighter_load
