! SPDX-License-Identifier: GPL-3.0-or-later
!> The gap over a given open region, step by step.
!>
!> Where the surfaces are apart the pressure q + s + A g is zero (`adfric_periodic_contact`), where they touch the gap g
!> is zero. On the open region O that is A_OO g = -(q + s). The sum over grids M of
!> `adfric_periodic_levels` is the preconditioner, so a step takes one application of A, a pair of transforms.
!>
!> An elastic solid has a symmetric and positive definite A_OO: steps are those of conjugate gradients. Under a sliding body A_OO is not
!> symmetric, but its symmetric part is positive definite. Steps then make the pressure p that remains in O as small as can be,
!> measured by p M p, along a direction whose pressure is orthogonal to those of the last few directions (Orthomin: S. C. Eisenstat,
!> H. C. Elman, M. H. Schultz, SIAM J. Numer. Anal. 20, 1983, 345). It falls in every step, however few are kept: with d = M p the step
!> alone takes away (p M A d)^2/(A d M A d), and p M A d = d A d > 0.
!>
!> Gap and pressure go on
!> together, in all cells, so nothing has to be computed anew where the region changes; gaps that remain in closed cells are taken
!> away by the first step in the new region, which has the length of the last one.
!>
!> Under given load q is known. Under given penetration the mean of g is, and q is the multiplier of this constraint; the
!> directions are kept in the constraint by a projection in the preconditioner (N. I. M. Gould, M. E. Hribar, J. Nocedal,
!> SIAM J. Sci. Comput. 23, 2001, 1376).
module adfric_periodic_gap_solver
   use adfric_base_kinds, only: dp
   use adfric_periodic_cohesion, only: cohesion_t
   use adfric_periodic_levels, only: levels_t, new_levels
   use adfric_periodic_maps, only: sum_of, dot_of, add_multiple, is_shared
   use adfric_periodic_operator, only: periodic_operator_t
   use adfric_periodic_past_directions, only: past_directions_t
   implicit none (type, external)
   private
   public :: gap_solver_t, extremes_t, new_gap_solver

   !> Length of a step before there was one.
   real(dp), parameter :: first_length = 0.5_dp

   !> Largest values over the cells, 0 where there is none above 0.
   type :: extremes_t
      !> Pressure or tension of open cells [E*].
      real(dp) :: remaining = 0
      !> Overlap of the surfaces.
      real(dp) :: overlap = 0
      !> Tension of closed cells [E*].
      real(dp) :: pull = 0
      !> Pressure [E*].
      real(dp) :: peak = 0
   end type extremes_t

   !> Region and workspace of the steps.
   type :: gap_solver_t
      private
      !> Grids of the preconditioner; not allocated before the first region.
      type(levels_t), allocatable :: levels
      !> Preconditioned pressure, direction, and stiffness times direction; shape of the cells.
      real(dp), allocatable, dimension(:, :) :: correction, direction, stiff
      !> Preconditioned constant, where a constant is special; shape of the cells.
      real(dp), allocatable :: constant(:, :)
      !> Sum of `constant`.
      real(dp) :: sum_of_constant = 0
      !> Is the mean gap given, and the mean pressure not?
      logical :: has_fixed_mean = .false.
      !> Is a constant special, since the mean gap is given, or a layer resists a constant?
      logical :: has_special_mean = .false.
      !> Mean compliance of the layer times the number of cells, where it resists a constant; else 0.
      real(dp) :: compliance_of_sum = 0
      !> Is the stiffness symmetric?
      logical :: is_symmetric = .true.
      !> Directions of the last steps, under a sliding body alone.
      type(past_directions_t) :: past
      !> `stiff` preconditioned, under a sliding body alone; shape of the cells.
      real(dp), allocatable :: preconditioned(:, :)
      !> Is `correction` known already?
      logical :: has_correction = .false.
      !> Is there a direction in this region already?
      logical :: has_direction = .false.
      !> Are there gaps left in closed cells?
      logical :: has_remains = .false.
      !> Direction times stiffness times direction.
      real(dp) :: curvature = 0
      !> Length of the last step along a direction.
      real(dp) :: length = first_length
   contains
      procedure :: forget
      procedure :: set_region
      procedure :: improve
      procedure :: advance
      procedure, private :: precondition
      procedure, private :: precondition_freely
      procedure, private :: set_sliding_step
      procedure, private :: set_direction
      procedure, private :: set_first_step
   end type gap_solver_t

contains

   !> Make the workspace for a number of cells.
   pure subroutine new_gap_solver(self, n_cells)
      type(gap_solver_t), intent(out) :: self
      !> Number of cells in each direction.
      integer, intent(in) :: n_cells(2)

      allocate (self%correction(n_cells(1), n_cells(2)), source=0.0_dp)
      allocate (self%direction, self%stiff, source=self%correction)
   end subroutine new_gap_solver

   !> Forget the contact that was solved before, so that the next one does not depend on it.
   pure subroutine forget(self)
      class(gap_solver_t), intent(inout) :: self

      self%length = first_length
      ! a step of length 0 must not find what is no number
      self%direction(:, :) = 0
      self%stiff(:, :) = 0
   end subroutine forget

   !> Begin with another region.
   subroutine set_region(self, operator, is_open, has_fixed_mean, resists_mean, has_remains)
      class(gap_solver_t), intent(inout) :: self
      type(periodic_operator_t), intent(in) :: operator
      !> Is the cell in the open region? Shape of the cells.
      logical, intent(in), contiguous :: is_open(:, :)
      !> Is the mean gap given, and the mean pressure not?
      logical, intent(in) :: has_fixed_mean
      logical, intent(in) :: resists_mean
      !> Are there gaps left in closed cells, or is the mean gap not as given?
      logical, intent(in) :: has_remains
      real(dp) :: sums(2)

      if (.not. allocated(self%levels)) then
         allocate (self%levels)
         call new_levels(self%levels, operator)
      end if
      call self%levels%set_open(is_open)
      self%has_direction = .false.
      self%is_symmetric = operator%is_symmetric
      self%has_correction = .false.
      call self%past%clear()
      if (.not. (self%is_symmetric .or. allocated(self%preconditioned))) allocate (self%preconditioned, source=self%correction)
      self%has_remains = has_remains
      self%has_fixed_mean = has_fixed_mean
      self%has_special_mean = has_fixed_mean .or. resists_mean
      self%compliance_of_sum = merge(operator%mean_compliance*size(is_open), 0.0_dp, resists_mean)
      if (.not. self%has_special_mean) return
      if (.not. allocated(self%constant)) allocate (self%constant, mold=self%correction)
      self%direction(:, :) = 1
      call self%levels%apply(self%direction, self%direction, self%constant, sums)
      self%sum_of_constant = sums(1)
   end subroutine set_region

   !> Improve the gap in the open region by one step, so that the pressure there becomes small.
   subroutine improve(self, operator, is_open, mean_gap, gap, pressure, mean_pressure, extremes, is_stuck, cohesion)
      class(gap_solver_t), intent(inout) :: self
      !> Operator of the same cells, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      !> Is the cell in the open region? Shape of the cells, as that of `pressure` and `gap`.
      logical, intent(in), contiguous :: is_open(:, :)
      !> The given mean gap, if it is given.
      real(dp), intent(in) :: mean_gap
      !> Gap; zero in closed cells but for remains, which are taken away.
      real(dp), intent(inout), contiguous :: gap(:, :)
      !> Pressure of `gap` and `mean_pressure`, in all cells [E*].
      real(dp), intent(inout), contiguous :: pressure(:, :)
      !> Mean pressure q [E*]; it changes under a given mean gap only.
      real(dp), intent(inout) :: mean_pressure
      !> Receives the largest values after the step.
      type(extremes_t), intent(out) :: extremes
      !> Is there nothing to be improved, but for round-off? The gap is not changed then. So it is where the tension of adhesion
      !> makes the solid give way.
      logical, intent(out) :: is_stuck
      !> Adhesion whose shares may follow the gap. Not allocated: none.
      type(cohesion_t), allocatable, intent(in) :: cohesion
      real(dp) :: sums(2), length, lost

      extremes = extremes_t()
      is_stuck = .false.
      if (.not. self%has_correction) call self%precondition(pressure, mean_pressure, sums)
      if (self%has_remains) then
         call self%set_first_step(is_open, mean_gap, gap)
         call operator%apply_stiffness(self%direction, self%stiff)
         if (allocated(cohesion)) call cohesion%subtract_slope(self%direction, self%stiff, lost)
         self%has_remains = .false.
         length = 1
      else if (.not. self%is_symmetric) then
         call self%set_sliding_step(operator, pressure, length, cohesion)
         is_stuck = .not. length > 0
         ! a tension that falls with the gap in all cells may leave no definite solid: the shortest remains may lie opposite then
         if (is_stuck .and. has_law(cohesion)) is_stuck = .not. abs(length) > 0
         if (is_stuck) return
         if (length > 0) self%length = length
         ! what M makes of the pressure follows it, but for the mean pressure that a given mean gap asks for
         self%has_correction = .not. self%has_fixed_mean
         if (self%has_correction) call add_multiple(self%correction, length, self%preconditioned)
      else
         is_stuck = .not. sums(1) > 0
         if (is_stuck) return
         call self%set_direction(sums(2))
         call operator%apply_stiffness(self%direction, self%stiff, self%curvature)
         if (allocated(cohesion)) then
            call cohesion%subtract_slope(self%direction, self%stiff, lost)
            self%curvature = self%curvature - lost
         end if
         is_stuck = .not. self%curvature > 0
         if (is_stuck) return
         self%has_direction = .true.
         self%length = sums(1)/self%curvature
         length = self%length
      end if
      call self%advance(length, gap, pressure, extremes)
   end subroutine improve

   !> Is there another law of attraction than Dugdale's?
   pure logical function has_law(cohesion)
      !> Adhesion; not allocated: none.
      type(cohesion_t), allocatable, intent(in) :: cohesion

      has_law = .false.
      if (allocated(cohesion)) has_law = allocated(cohesion%law)
   end function has_law

   !> Go along the direction, and find the largest values there.
   subroutine advance(self, length, gap, pressure, extremes)
      class(gap_solver_t), intent(in), target :: self
      !> Length of the step; 0 to find the largest values alone.
      real(dp), intent(in) :: length
      !> Gap in all cells.
      real(dp), intent(inout), contiguous :: gap(:, :)
      !> Pressure in all cells [E*].
      real(dp), intent(inout), contiguous :: pressure(:, :)
      type(extremes_t), intent(out) :: extremes
      type(extremes_t) :: rows(size(gap, 2))
      real(dp), pointer, contiguous :: open(:, :)
      integer :: j

      open => self%levels%open_share()
      !$omp parallel do if(is_shared(size(gap))) default(none) shared(self, open, length, gap, pressure, rows) private(j)
      do j = 1, size(gap, 2)
         call advance_row(length, self%direction(:, j), self%stiff(:, j), open(:, j), gap(:, j), pressure(:, j), rows(j))
      end do
      !$omp end parallel do
      extremes = extremes_t(maxval(rows%remaining), maxval(rows%overlap), maxval(rows%pull), maxval(rows%peak))
   end subroutine advance

   !> Go along the direction in a row of cells.
   pure subroutine advance_row(length, direction, stiff, open, gap, pressure, extremes)
      !> Length of the step.
      real(dp), intent(in) :: length
      !> Direction, and stiffness times direction.
      real(dp), intent(in), contiguous :: direction(:), stiff(:)
      !> 1 in open cells, 0 in closed ones.
      real(dp), intent(in), contiguous :: open(:)
      real(dp), intent(inout), contiguous :: gap(:)
      !> Pressure [E*].
      real(dp), intent(inout), contiguous :: pressure(:)
      !> Receives the largest values of the row.
      type(extremes_t), intent(out) :: extremes
      integer, parameter :: lanes = 4
      real(dp), dimension(lanes) :: remaining, overlap, pull, peak
      integer :: first, i, k

      remaining = 0
      overlap = 0
      pull = 0
      peak = 0
      do first = 1, size(gap), lanes
         do k = 1, min(lanes, size(gap) - first + 1)
            i = first + k - 1
            gap(i) = gap(i) + length*direction(i)
            pressure(i) = pressure(i) + length*stiff(i)
            remaining(k) = larger(open(i)*abs(pressure(i)), remaining(k))
            overlap(k) = larger(-gap(i), overlap(k))
            pull(k) = larger((open(i) - 1)*pressure(i), pull(k))
            peak(k) = larger(pressure(i), peak(k))
         end do
      end do
      extremes = extremes_t(maxval(remaining), maxval(overlap), maxval(pull), maxval(peak))
   end subroutine advance_row

   !> The larger of two numbers, neither of them NaN; that is a single instruction, other than `max`.
   pure real(dp) function larger(a, b)
      real(dp), intent(in) :: a, b

      larger = merge(a, b, a > b)
   end function larger

   !> Apply the preconditioner to the pressure; under a fixed mean gap find the mean pressure that leaves it. The stiffness of a
   !> constant is added to what the grids of the preconditioner know by the formula of Sherman and Morrison, whose limit is that.
   subroutine precondition(self, pressure, mean_pressure, sums)
      class(gap_solver_t), intent(inout) :: self
      !> Pressure in all cells [E*]; it changes with `mean_pressure`.
      real(dp), intent(inout), contiguous :: pressure(:, :)
      !> Mean pressure q [E*].
      real(dp), intent(inout) :: mean_pressure
      !> Receives the sums of preconditioned pressure times pressure and times `stiff`.
      real(dp), intent(out) :: sums(2)
      real(dp) :: shift
      integer :: j

      call self%levels%apply(pressure, self%stiff, self%correction, sums)
      if (.not. self%has_special_mean) return
      shift = -sum_of(self%correction)/(self%sum_of_constant + self%compliance_of_sum)
      call add_multiple(self%correction, shift, self%constant)
      if (.not. self%has_fixed_mean) shift = 0
      mean_pressure = mean_pressure + shift
      !$omp parallel do if(is_shared(size(pressure))) default(none) shared(pressure, shift) private(j)
      do j = 1, size(pressure, 2)
         pressure(:, j) = pressure(:, j) + shift
      end do
      !$omp end parallel do
      sums = [dot_of(self%correction, pressure), dot_of(self%correction, self%stiff)]
   end subroutine precondition

   !> The next direction under a sliding body, and how far to go.
   subroutine set_sliding_step(self, operator, pressure, length, cohesion)
      class(gap_solver_t), intent(inout) :: self
      !> Operator of the same cells, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      !> Pressure in all cells [E*].
      real(dp), intent(in), contiguous :: pressure(:, :)
      !> Receives the length of the step; 0 if nothing is to be improved but round-off.
      real(dp), intent(out) :: length
      !> Adhesion whose shares may follow the gap; not allocated: none.
      type(cohesion_t), allocatable, intent(in) :: cohesion
      real(dp) :: product, lost

      call self%set_direction(0.0_dp)
      call operator%apply_stiffness(self%direction, self%stiff)
      if (allocated(cohesion)) call cohesion%subtract_slope(self%direction, self%stiff, lost)
      call self%precondition_freely(self%stiff, self%preconditioned)
      call self%past%take(self%direction, self%stiff, self%preconditioned, product)
      length = 0
      if (product > 0) length = -dot_of(pressure, self%preconditioned)/product
   end subroutine set_sliding_step

   !> Apply the preconditioner to a pressure; as in `precondition`, without a change of the mean pressure.
   subroutine precondition_freely(self, pressure, correction)
      class(gap_solver_t), intent(inout) :: self
      !> Pressure in all cells [E*].
      real(dp), intent(in), contiguous :: pressure(:, :)
      !> Receives the preconditioned pressure, 0 in closed cells.
      real(dp), intent(out), contiguous :: correction(:, :)
      real(dp) :: sums(2)

      call self%levels%apply(pressure, pressure, correction, sums)
      if (self%has_special_mean) call add_multiple(correction, &
         & -sum_of(correction)/(self%sum_of_constant + self%compliance_of_sum), self%constant)
   end subroutine precondition_freely

   !> The next direction, conjugate to the last one of the region.
   subroutine set_direction(self, product)
      class(gap_solver_t), intent(inout) :: self
      !> Preconditioned pressure times stiffness times the last direction.
      real(dp), intent(in) :: product
      real(dp) :: factor
      integer :: j

      factor = 0
      if (self%has_direction) factor = product/self%curvature
      !$omp parallel do if(is_shared(size(self%direction))) default(none) shared(self, factor) private(j)
      do j = 1, size(self%direction, 2)
         if (self%has_direction) then
            self%direction(:, j) = factor*self%direction(:, j) - self%correction(:, j)
         else
            self%direction(:, j) = -self%correction(:, j)
         end if
      end do
      !$omp end parallel do
   end subroutine set_direction

   !> The first step in a region that has been changed: remains are taken away, and the rest goes as far as the last step did.
   subroutine set_first_step(self, is_open, mean_gap, gap)
      !> Workspace with the preconditioned pressure; receives the step as its direction.
      class(gap_solver_t), intent(inout) :: self
      !> Is the cell in the open region?
      logical, intent(in), contiguous :: is_open(:, :)
      !> The given mean gap, if it is given.
      real(dp), intent(in) :: mean_gap
      !> Gap with remains in closed cells.
      real(dp), intent(in), contiguous :: gap(:, :)
      integer :: j

      !$omp parallel do if(is_shared(size(gap))) default(none) shared(self, is_open, gap) private(j)
      do j = 1, size(gap, 2)
         self%direction(:, j) = merge(-self%length*self%correction(:, j), -gap(:, j), is_open(:, j))
      end do
      !$omp end parallel do
      if (self%has_fixed_mean) call add_multiple(self%direction, &
         & (mean_gap*size(gap) - sum_of(gap) - sum_of(self%direction))/self%sum_of_constant, self%constant)
   end subroutine set_first_step

end module adfric_periodic_gap_solver
