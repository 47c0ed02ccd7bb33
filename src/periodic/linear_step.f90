! SPDX-License-Identifier: GPL-3.0-or-later
!> A linear problem of contact with a slope of the tension in each cell, on one grid.
!>
!> Wanted is the gap v with
!>
!>     v >= 0,  f = F + (A + diag(c)) (v - g) >= 0,  v f = 0,
!>
!> A the stiffness (`adfric_periodic_operator`), F what presses the cells together at a gap g, and c <= 0 the slope of the tension there.
!> The open region is sought by `adfric_periodic_region_search`, the gap over it by conjugate gradients with the sum over grids of
!> `adfric_periodic_levels`; gap and f are carried along, so a step takes one pair of transforms. Conjugate gradients see where A + diag(c)
!> is not positive definite on the open region: the solid yields, and the step ends.
!>
!> The mean of the gap may be fixed instead of the mean pressure. Then f changes by one number in all cells, which is found as well, and
!> conjugate gradients see where A + diag(c) is not positive definite among gaps without a mean.
!>
!> Where a constant has a stiffness, as at a given penetration of a layer, there may be no contact at all.
!>
!> A law of attraction that pushes by itself has no wall: all cells are open, gaps have any sign, and slopes c may be above 0. Cells
!> whose slope is large take part in the sum over grids by little.
!>
!> `dominates` is the other question to the same matrix: whether w > 0 with (A + diag(c)) w > 0 exists on a region. Where no entry off the
!> diagonal is positive the matrix then has an inverse without negative entries.
module adfric_periodic_linear_step
   use adfric_base_kinds, only: dp
   use adfric_periodic_levels, only: levels_t, new_levels
   use adfric_periodic_maps, only: dot_of
   use adfric_periodic_operator, only: periodic_operator_t
   use adfric_periodic_region_search, only: new_region_search, region_search_t, verdict_t
   implicit none (type, external)
   private
   public :: fixed_mean_t, linear_step_t, new_linear_step, step_solved, step_indefinite, step_unfinished

   !> How a step ended: solved; the matrix is not positive definite on the open region; too many iterations.
   integer, parameter :: step_solved = 0, step_indefinite = 1, step_unfinished = 2
   !> Iterations and changes of the region that are never needed, and changes without fewer wrong cells that are borne.
   integer, parameter :: most_iterations = 400, most_regions = 200, patience = 3
   !> Remaining part of the right side at which `dominates` decides.
   real(dp), parameter :: enough = 0.2_dp

   !> A mean of the gap that is fixed.
   type :: fixed_mean_t
      !> The mean of the gap, in its unit.
      real(dp) :: gap = 0
      !> Mean pressure that goes with it, in which F and f are meant [E*].
      real(dp) :: pressure = 0
   end type fixed_mean_t

   !> Workspace of the steps on one grid; not to be copied, one for each thread.
   type :: linear_step_t
      private
      !> Grids of the preconditioner.
      type(levels_t) :: levels
      !> Preconditioned residual, direction, and matrix times direction; shape of the cells.
      real(dp), allocatable, dimension(:, :) :: correction, direction, stiff
      !> What the preconditioner makes of a constant, where the mean gap is fixed; shape of the cells.
      real(dp), allocatable :: constant(:, :)
      !> Sum of that.
      real(dp) :: sum_of_constant = 1
      !> Is there a hard wall at the gap 0?
      logical :: has_wall = .true.
      !> Has a constant a stiffness?
      logical :: resists_mean = .false.
      !> Pressure of a gap of 1 in a single cell [E* over the unit of the gap].
      real(dp) :: cell_stiffness = 1
      !> Where a region without contact is closed: the cell that touches first.
      integer :: first_cell(2) = 1
      !> Where full contact opens: the cell that touches last.
      integer :: last_cell(2) = 1
   contains
      procedure :: solve
      procedure :: dominates
      procedure, private :: set_region
      procedure, private :: descend
   end type linear_step_t

contains

   !> Make the workspace for the cells of an operator.
   subroutine new_linear_step(self, operator, shape, has_wall)
      type(linear_step_t), intent(out) :: self
      !> Operator of the grid.
      type(periodic_operator_t), intent(in) :: operator
      !> Gap of the undeformed surfaces; shape of the cells.
      real(dp), intent(in) :: shape(:, :)
      !> Is there a hard wall at the gap 0? Else all cells are open.
      logical, intent(in) :: has_wall

      call new_levels(self%levels, operator)
      self%has_wall = has_wall
      self%resists_mean = operator%resists()
      allocate (self%correction, self%direction, self%stiff, mold=shape)
      self%cell_stiffness = operator%mean_stiffness(operator%n_cells)
      self%first_cell = minloc(shape)
      self%last_cell = maxloc(shape)
   end subroutine new_linear_step

   !> Solve the linear problem.
   subroutine solve(self, operator, slope, goal, is_open, gap, force, outcome, fixed)
      class(linear_step_t), intent(inout) :: self
      !> Operator of the grid, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      !> Slope c of the tension [E* over the unit of the gap], above 0 only without a wall; shape of the cells.
      real(dp), intent(in), contiguous :: slope(:, :)
      !> What may be left of f in open cells, and be missing in closed ones [E*]; > 0.
      real(dp), intent(in) :: goal
      !> In: region to begin from; closed cells have no gap. Out: the open region.
      logical, intent(inout), contiguous :: is_open(:, :)
      !> In: the gap g, >= 0. Out: v, with no gap in closed cells.
      real(dp), intent(inout), contiguous :: gap(:, :)
      !> In: F [E*]. Out: f.
      real(dp), intent(inout), contiguous :: force(:, :)
      !> One of `step_...`.
      integer, intent(out) :: outcome
      !> In: the mean gap that v has, and the mean pressure of F. Out: that of f. Not given: the mean pressure is fixed.
      type(fixed_mean_t), intent(inout), optional :: fixed
      type(region_search_t) :: search
      type(verdict_t) :: verdict
      logical, allocatable :: is_wrong(:, :)
      real(dp) :: overlap, pull, curvature
      integer :: k, n_regions
      logical :: has_direction, has_ended

      call keep_region_sound(self, is_open, present(fixed))
      call self%set_region(operator, slope, is_open, gap, force, fixed)
      call new_region_search(search, patience)
      allocate (is_wrong, mold=is_open)
      outcome = step_unfinished
      n_regions = 0
      has_direction = .false.
      do k = 1, most_iterations
         if (operator%is_stopped()) return
         verdict%remaining = maxval(abs(force), mask=is_open)
         if (.not. any(is_open)) verdict%remaining = 0
         overlap = 0
         if (self%has_wall) overlap = max(0.0_dp, -minval(gap))
         pull = 0
         if (.not. all(is_open)) pull = max(0.0_dp, -minval(force, mask=.not. is_open))
         verdict%violation = 0
         if (self%cell_stiffness*overlap > goal) verdict%violation = self%cell_stiffness*overlap
         if (pull > goal) verdict%violation = max(verdict%violation, pull)
         call search%note_step(verdict)
         has_ended = verdict%remaining <= goal
         if (verdict%violation > 0 .and. (has_ended .or. search%is_due(verdict, goal))) then
            is_wrong(:, :) = merge(self%cell_stiffness*gap < -goal, force < -goal, is_open)
            call search%choose_wrong(count(is_wrong), is_wrong)
            is_open(:, :) = is_open .neqv. is_wrong
            call keep_region_sound(self, is_open, present(fixed))
            n_regions = n_regions + 1
            if (n_regions > most_regions) return
            has_direction = .false.
            call remove_gaps(self, operator, slope, is_open, gap, force)
            call self%set_region(operator, slope, is_open, gap, force, fixed)
         else if (has_ended) then
            outcome = step_solved
            exit
         else if (search%is_stalled()) then
            exit
         else
            call self%descend(operator, slope, gap, force, has_direction, curvature, fixed)
            if (curvature > 0) cycle
            ! the mean pressure alone may have been what was missing
            if (present(fixed) .and. .not. maxval(abs(force), mask=is_open) > goal) cycle
            outcome = step_indefinite
            return
         end if
      end do
      if (.not. self%has_wall) return
      ! gaps below 0 by less than the goal are those of no gap
      is_open(:, :) = is_open .and. gap > 0
      call remove_gaps(self, operator, slope, is_open, gap, force)
   end subroutine solve

   !> See to it that there is contact under a fixed mean pressure, and that there is a gap where its mean is fixed. Without a wall all
   !> cells are open, and where a constant has a stiffness any region will do.
   pure subroutine keep_region_sound(self, is_open, has_fixed_mean)
      type(linear_step_t), intent(in) :: self
      !> Open region, which may lose or gain a cell.
      logical, intent(inout) :: is_open(:, :)
      !> Is the mean gap fixed?
      logical, intent(in) :: has_fixed_mean

      if (.not. self%has_wall) then
         is_open(:, :) = .true.
      else if (has_fixed_mean) then
         if (.not. any(is_open)) is_open(self%last_cell(1), self%last_cell(2)) = .true.
      else if (all(is_open) .and. .not. self%resists_mean) then
         is_open(self%first_cell(1), self%first_cell(2)) = .false.
      end if
   end subroutine keep_region_sound

   !> Begin with a region: the preconditioner knows it, and the gap has the mean that is fixed.
   subroutine set_region(self, operator, slope, is_open, gap, force, fixed)
      class(linear_step_t), intent(inout) :: self
      type(periodic_operator_t), intent(inout) :: operator
      real(dp), intent(in), contiguous :: slope(:, :)
      logical, intent(in), contiguous :: is_open(:, :)
      !> Gap, which changes in open cells.
      real(dp), intent(inout), contiguous :: gap(:, :)
      !> f, which follows the gap.
      real(dp), intent(inout), contiguous :: force(:, :)
      !> The mean gap, where it is fixed.
      type(fixed_mean_t), intent(in), optional :: fixed
      real(dp) :: sums(2), missing

      if (self%has_wall) then
         call self%levels%set_open(is_open)
      else
         call self%levels%set_share(sqrt(self%cell_stiffness/(self%cell_stiffness + max(slope, 0.0_dp))))
      end if
      if (.not. present(fixed)) return
      if (.not. allocated(self%constant)) allocate (self%constant, mold=self%correction)
      self%direction(:, :) = 1
      call self%levels%apply(self%direction, self%direction, self%constant, sums)
      self%sum_of_constant = sums(1)
      missing = fixed%gap*size(gap) - sum(gap)
      if (.not. abs(missing) > epsilon(missing)*sum(abs(gap))) return
      self%direction(:, :) = (missing/self%sum_of_constant)*self%constant
      call operator%apply_stiffness(self%direction, self%stiff)
      gap(:, :) = gap + self%direction
      force(:, :) = force + self%stiff + slope*self%direction
   end subroutine set_region

   !> Take the gaps of closed cells away.
   subroutine remove_gaps(self, operator, slope, is_open, gap, force)
      type(linear_step_t), intent(inout) :: self
      type(periodic_operator_t), intent(inout) :: operator
      real(dp), intent(in), contiguous :: slope(:, :)
      logical, intent(in), contiguous :: is_open(:, :)
      !> In: with gaps in closed cells. Out: without.
      real(dp), intent(inout), contiguous :: gap(:, :)
      !> f, which follows the gap.
      real(dp), intent(inout), contiguous :: force(:, :)

      if (.not. any(.not. is_open .and. abs(gap) > 0)) return
      self%direction(:, :) = merge(0.0_dp, -gap, is_open)
      call operator%apply_stiffness(self%direction, self%stiff)
      force(:, :) = force + self%stiff + slope*self%direction
      where (.not. is_open) gap = 0
   end subroutine remove_gaps

   !> One step of conjugate gradients on the open region.
   subroutine descend(self, operator, slope, gap, force, has_direction, curvature, fixed)
      class(linear_step_t), intent(inout) :: self
      type(periodic_operator_t), intent(inout) :: operator
      real(dp), intent(in), contiguous :: slope(:, :)
      real(dp), intent(inout), contiguous :: gap(:, :)
      real(dp), intent(inout), contiguous :: force(:, :)
      !> Is there a direction in this region? Set.
      logical, intent(inout) :: has_direction
      !> Direction times matrix times direction; nothing is changed where it is not above 0.
      real(dp), intent(out) :: curvature
      !> Where the mean gap is fixed: the mean pressure, which changes.
      type(fixed_mean_t), intent(inout), optional :: fixed
      real(dp) :: sums(2), length, shift

      if (.not. has_direction) self%stiff(:, :) = 0
      call self%levels%apply(force, self%stiff, self%correction, sums)
      if (present(fixed)) then
         ! the mean pressure that leaves the mean gap as it is
         shift = -sum(self%correction)/self%sum_of_constant
         self%correction(:, :) = self%correction + shift*self%constant
         force(:, :) = force + shift
         fixed%pressure = fixed%pressure + shift
         sums(2) = dot_of(self%correction, self%stiff)
      end if
      if (has_direction) then
         self%direction(:, :) = (sums(2)/dot_of(self%direction, self%stiff))*self%direction - self%correction
      else
         self%direction(:, :) = -self%correction
      end if
      call operator%apply_stiffness(self%direction, self%stiff)
      self%stiff(:, :) = self%stiff + slope*self%direction
      curvature = dot_of(self%direction, self%stiff)
      if (.not. curvature > 0) return
      has_direction = .true.
      length = -dot_of(self%direction, force)/curvature
      gap(:, :) = gap + length*self%direction
      force(:, :) = force + length*self%stiff
   end subroutine descend

   !> Is there w > 0 on a region with (A + diag(c)) w > 0?
   subroutine dominates(self, operator, slope, is_open, is_dominant)
      class(linear_step_t), intent(inout) :: self
      type(periodic_operator_t), intent(inout) :: operator
      !> Slope c of the tension [E* over the unit of the gap]; shape of the cells.
      real(dp), intent(in), contiguous :: slope(:, :)
      !> The region; not all cells, but where there is no wall.
      logical, intent(in), contiguous :: is_open(:, :)
      logical, intent(out) :: is_dominant
      real(dp), allocatable :: w(:, :), rest(:, :)
      real(dp) :: curvature
      integer :: k
      logical :: has_direction

      is_dominant = .not. any(is_open)
      if (is_dominant .or. (self%has_wall .and. all(is_open) .and. .not. self%resists_mean)) return
      allocate (w, source=0*slope)
      allocate (rest, source=w)
      rest(:, :) = -1
      call self%set_region(operator, slope, is_open, w, rest)
      has_direction = .false.
      do k = 1, most_iterations
         if (operator%is_stopped()) return
         call self%descend(operator, slope, w, rest, has_direction, curvature)
         if (.not. curvature > 0) return
         if (maxval(abs(rest), mask=is_open) > enough) cycle
         is_dominant = minval(w, mask=is_open) > 0
         return
      end do
   end subroutine dominates

end module adfric_periodic_linear_step
