! SPDX-License-Identifier: GPL-3.0-or-later
!> Contact of a periodic surface, at rest or sliding steadily, with an elastic or viscoelastic half-space or layer: load or
!> penetration to pressure, gap, area and the stress that holds the body back.
!>
!> The contact is solved on the coarsest grid first and carried from grid to grid, each of half the cell size, so that on the
!> finest one only cells at the perimeter are wrong. Without shear stress at the surfaces; equations in `adfric_periodic_contact`.
!> Surfaces that adhere have a solver of their own (`adfric_periodic_adhesive_solver`). Pressures are in the unit of the kernel, E* or
!> E0, which the comments below call E*; lengths in any unit. The file is long by what a solution has, each with its comment.
module adfric_periodic_solver
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t, set_error, input_failure
   use adfric_periodic_area, only: area_t, area_of_cells, refine_area
   use adfric_periodic_friction, only: friction_t, get_friction, get_losses
   use adfric_periodic_cohesion, only: cohesion_t
   use adfric_periodic_contact, only: contact_state_t, solve_contact, start_contact, residual_of
   use adfric_periodic_contact_punch, only: contact_punch_t
   use adfric_periodic_gap_solver, only: gap_solver_t, new_gap_solver
   use adfric_periodic_grids, only: coarsen, refine, n_grids_of
   use adfric_periodic_kernel, only: kernel_t
   use adfric_periodic_line_contact, only: solve_line
   use adfric_periodic_maps, only: sum_of
   use adfric_periodic_near_contact, only: near_contact_t
   use adfric_periodic_operator, only: periodic_operator_t, new_periodic_operator
   use adfric_periodic_yielding, only: guess_from_coarse, guess_yield, solve_yield
   implicit none (type, external)
   private
   public :: periodic_solver_t, periodic_solution_t, hardness_t, new_periodic_solver
   public :: check_shape, set_friction, set_full_pressure, set_solution, start_from_coarse, coarse_tolerance
   public :: contact_solved, contact_not_converged, contact_out_of_range, grids_for_error
   public :: branches_agree, branches_differ, branches_unknown

   !> How a solution ended.
   integer, parameter :: contact_solved = 0, contact_not_converged = 1
   !> A load that is negative, or a penetration that no pressure reaches: full contact has the mean of the undeformed gap.
   integer, parameter :: contact_out_of_range = 2
   !> Whether the other branch has another state: it has none or the same, it has another one, or it was not asked or not found.
   integer, parameter :: branches_agree = 0, branches_differ = 1, branches_unknown = 2
   !> Grids that it takes to estimate the error of the area.
   integer, parameter :: grids_for_error = 3
   !> Largest residual that a grid other than the finest needs.
   real(dp), parameter :: coarse_tolerance = 1.0e-6_dp

   !> A solid that yields.
   type :: hardness_t
      !> Largest pressure that it bears [E*], and the mean pressure that it was pressed with before [E*]; 0 for no more than now.
      real(dp) :: pressure = huge(1.0_dp), turning_pressure = 0
   end type hardness_t

   !> What a solution is; the maps have the shape of the cells.
   type :: periodic_solution_t
      !> Pressure in the cells [E*].
      real(dp), allocatable :: pressure(:, :)
      !> Gap in the cells.
      real(dp), allocatable :: gap(:, :)
      !> Mean pressure [E*].
      real(dp) :: mean_pressure = 0
      !> How far the surfaces approached from first touch, at the mean of the deformed surface, or at the base of a layer.
      real(dp) :: penetration = 0
      !> Area of contact, and the bound of its error.
      type(area_t) :: area
      !> Mean pressure at which contact becomes full on these cells, the largest of A g0 [E*].
      real(dp) :: full_pressure = 0
      !> Shares of the cells within the range of adhesion, not allocated without; shape of the cells.
      real(dp), allocatable :: share(:, :)
      !> The same, each part of a cell with its work of adhesion over the largest one; not allocated where works do not differ.
      real(dp), allocatable :: weighted_share(:, :)
      !> Flash temperatures of a surface that slides [K], not allocated without heat; shape of the cells.
      real(dp), allocatable :: flash(:, :)
      !> Contacts at velocities a little off, in the order of `near_steps`; none where the velocity does not count; not allocated where
      !> they are not wanted.
      type(near_contact_t), allocatable :: near(:)
      !> Depth of the impressions, in the unit of the gap; not allocated where the solid does not yield.
      real(dp), allocatable :: plastic_depth(:, :)
      !> Energy of an elastic solid, and of adhesion below 0, per area [E* times the unit of the gap].
      real(dp) :: elastic_energy = 0, adhesion_energy = 0
      !> Energy per area that opening has taken beyond what closing gave [E* times the unit of the gap].
      real(dp) :: opening_loss = 0
      !> Pull-off, where it was sought and found [E*]; else the largest number.
      real(dp) :: pull_off = huge(1.0_dp)
      !> Its relative error, from the grid of half the cells and what the search leaves open; the largest number where there is no such
      !> grid.
      real(dp) :: pull_off_error = huge(1.0_dp)
      !> Friction in full contact on these cells, along x and along y [E*].
      real(dp) :: full_friction(2) = 0
      !> Friction on these cells.
      type(friction_t) :: friction
      !> Friction from the loss on grids of half and a quarter of the cells in each direction [E*]; shape
      !> `(2, 2)`, x and y first.
      real(dp) :: coarse_losses(2, 2) = 0
      !> How many of these two grids there were.
      integer :: n_coarse_losses = 0
      !> Punch with the shape of the spots that touch; not allocated where it is not wanted.
      type(contact_punch_t), allocatable :: punch
      !> Has the other branch of adhesion another state? One of `branches_...`.
      integer :: branches = branches_unknown
      !> Friction of the same load without adhesion, from the loss, along x and along y [E*]; not allocated where it is not wanted.
      real(dp), allocatable :: loss_without_adhesion(:)
      !> Least real part of the stiffness of a wave on these cells over its size.
      real(dp) :: stiffness_ratio = 1
      !> Largest violation of the conditions of contact, see `adfric_periodic_contact`.
      real(dp) :: residual = huge(1.0_dp)
      !> Iterations and applied operators on the finest grid.
      integer :: n_iterations = 0, n_applied = 0
      !> Applied operators, which take a pair of transforms each, on all grids; coarser ones count by their cells.
      real(dp) :: n_pairs = 0
      !> `contact_solved`, `contact_not_converged` or `contact_out_of_range`.
      integer :: status = contact_not_converged
   end type periodic_solution_t

   !> One grid.
   type :: grid_t
      !> Stiffness and compliance of the half-space on the cells.
      type(periodic_operator_t) :: operator
      !> Workspace of the iterations over the open cells.
      type(gap_solver_t) :: gap_solver
   end type grid_t

   !> Plans and workspaces for one size of surface. Not to be copied; one for each thread.
   type :: periodic_solver_t
      !> The finest is the last. They are `adfric_periodic_adhesive_solver`'s as well, and nobody else's.
      type(grid_t), allocatable :: grids(:)
      !> The surface of the solid, from which they were made.
      class(kernel_t), allocatable :: kernel
   contains
      procedure :: solve_load
      procedure :: solve_penetration
      procedure :: solve_yielding
      procedure, private :: solve
      procedure, private :: set_touch
   end type periodic_solver_t

contains

   !> Set up grids, plans and workspaces.
   subroutine new_periodic_solver(self, kernel, n_cells, period, is_quarter, error, is_measured)
      !> The solver; not to be used after an error.
      type(periodic_solver_t), intent(out) :: self
      !> The surface of the solid, see `adfric_periodic_operator`.
      class(kernel_t), intent(in) :: kernel
      !> Number of cells along x and y, of the quarter if it is one; best with many factors of 2. One cell along y makes a line.
      integer, intent(in) :: n_cells(2)
      !> Periods in x and y, in any unit of length, > 0.
      real(dp), intent(in) :: period(2)
      !> Is the surface even about 0 and half a period in x and in y, and only that quarter given?
      logical, intent(in) :: is_quarter
      type(error_t), allocatable, intent(out) :: error
      !> Shall trials tell the fastest transforms? Worth it for hundreds of solutions.
      logical, intent(in), optional :: is_measured
      integer :: k, n_grids
      logical :: measured

      measured = .false.
      if (present(is_measured)) measured = is_measured
      n_grids = n_grids_of(n_cells)
      allocate (self%grids(n_grids))
      allocate (self%kernel, source=kernel)
      do k = 1, n_grids
         associate (n => max(n_cells/2**(n_grids - k), min(n_cells, 1)))
            call new_periodic_operator(self%grids(k)%operator, kernel, n, period, is_quarter, measured, error)
            if (allocated(error)) return
            call new_gap_solver(self%grids(k)%gap_solver, n)
         end associate
      end do
   end subroutine new_periodic_solver

   !> Solve under a mean pressure.
   subroutine solve_load(self, shape, mean_pressure, tolerance, solution, error)
      class(periodic_solver_t), intent(inout) :: self
      !> Gap of the undeformed surfaces in the middles of the cells; 0 at first touch, and no less.
      real(dp), intent(in) :: shape(:, :)
      !> Mean pressure [E*]; a negative one is out of range.
      real(dp), intent(in) :: mean_pressure
      real(dp), intent(in) :: tolerance
      !> The solution; `status` tells how it ended.
      type(periodic_solution_t), intent(out) :: solution
      type(error_t), allocatable, intent(out) :: error
      type(contact_state_t) :: goal

      call check_shape(self, shape, error)
      if (allocated(error)) return
      if (mean_pressure > 0) then
         goal%mean_pressure = mean_pressure
         call self%solve(shape, goal, tolerance, solution)
      else if (mean_pressure < 0) then
         solution%status = contact_out_of_range
      else
         call self%set_touch(shape, 0.0_dp, solution)
      end if
   end subroutine solve_load

   !> Solve at a penetration.
   subroutine solve_penetration(self, shape, penetration, tolerance, solution, error)
      class(periodic_solver_t), intent(inout) :: self
      !> Gap of the undeformed surfaces in the middles of the cells; 0 at first touch, and no less.
      real(dp), intent(in) :: shape(:, :)
      !> Penetration from first touch, at the mean of the deformed surface, or at the base of a layer; in the unit of `shape`.
      real(dp), intent(in) :: penetration
      real(dp), intent(in) :: tolerance
      !> The solution; `status` tells how it ended.
      type(periodic_solution_t), intent(out) :: solution
      type(error_t), allocatable, intent(out) :: error
      type(contact_state_t) :: goal

      call check_shape(self, shape, error)
      if (allocated(error)) return
      associate (compliance => self%grids(size(self%grids))%operator%mean_compliance)
         goal%resists_mean = compliance > 0
         goal%has_fixed_mean = .not. goal%resists_mean
         if (goal%resists_mean) goal%mean_pressure = penetration/compliance
      end associate
      goal%mean_gap = sum(shape)/size(shape) - penetration
      if (penetration <= minval(shape)) then
         call self%set_touch(shape, penetration, solution)
      else if (goal%mean_gap > 0 .or. goal%resists_mean) then
         call self%solve(shape, goal, tolerance, solution)
      else
         solution%status = contact_out_of_range
      end if
   end subroutine solve_penetration

   !> Solve under a mean pressure, which may be less than one before, with a solid that yields. A lighter load finds an elastic solid
   !> with the impressions of the heavier one: no pressure grows while a load falls.
   subroutine solve_yielding(self, shape, mean_pressure, hardness, tolerance, solution, error)
      class(periodic_solver_t), intent(inout) :: self
      !> Gap of the undeformed surfaces in the middles of the cells; 0 at first touch, and no less.
      real(dp), intent(in) :: shape(:, :)
      !> Mean pressure [E*], >= 0; one that is not below the hardness is out of range.
      real(dp), intent(in) :: mean_pressure
      type(hardness_t), intent(in) :: hardness
      real(dp), intent(in) :: tolerance
      !> The solution; `status` tells how it ended.
      type(periodic_solution_t), intent(out) :: solution
      type(error_t), allocatable, intent(out) :: error
      type(contact_state_t) :: goal

      call check_shape(self, shape, error)
      if (allocated(error)) return
      goal%mean_pressure = max(mean_pressure, hardness%turning_pressure)
      if (goal%mean_pressure >= hardness%pressure) then
         solution%status = contact_out_of_range
      else if (goal%mean_pressure > 0) then
         call self%solve(shape, goal, tolerance, solution, hardness)
      else
         call self%set_touch(shape, 0.0_dp, solution)
         solution%plastic_depth = 0*shape
      end if
      if (solution%status == contact_solved .and. mean_pressure < goal%mean_pressure) &
         & call unload(self, shape, mean_pressure, hardness%pressure, tolerance, solution)
      call raise_area(solution, hardness%pressure)
   end subroutine solve_yielding

   !> Solve under a lighter load with the impressions of a heavier one.
   subroutine unload(self, shape, mean_pressure, hardness, tolerance, solution)
      class(periodic_solver_t), intent(inout) :: self
      !> Gap of the undeformed surfaces in the middles of the cells.
      real(dp), intent(in) :: shape(:, :)
      !> The lighter load, and the hardness [E*].
      real(dp), intent(in) :: mean_pressure, hardness
      real(dp), intent(in) :: tolerance
      !> In: under the heavier load. Out: under the lighter one.
      type(periodic_solution_t), intent(inout) :: solution
      type(contact_state_t) :: goal
      real(dp), allocatable :: depth(:, :), impressed(:, :)
      real(dp) :: full_pressure, n_pairs

      call move_alloc(solution%plastic_depth, depth)
      allocate (impressed, source=shape + depth)
      full_pressure = solution%full_pressure
      n_pairs = solution%n_pairs
      solution = periodic_solution_t()
      goal%mean_pressure = mean_pressure
      if (any(depth > 0)) goal%hardness = hardness
      if (mean_pressure > 0) then
         call self%solve(impressed, goal, tolerance, solution)
      else
         call self%set_touch(impressed, minval(impressed), solution)
         solution%area%error = 0
      end if
      solution%full_pressure = full_pressure
      solution%n_pairs = solution%n_pairs + n_pairs
      call move_alloc(depth, solution%plastic_depth)
   end subroutine unload

   !> No area is less than the load over the hardness; cells at the perimeter, which bear the hardness, are counted for less.
   pure subroutine raise_area(solution, hardness)
      type(periodic_solution_t), intent(inout) :: solution
      !> Largest pressure [E*].
      real(dp), intent(in) :: hardness
      real(dp) :: lacking

      if (solution%status /= contact_solved) return
      lacking = max(solution%mean_pressure/hardness - solution%area%corrected, 0.0_dp)
      solution%area%corrected = solution%area%corrected + lacking
      solution%area%error = solution%area%error + lacking
   end subroutine raise_area

   !> The shape must be one of the finest grid.
   pure subroutine check_shape(self, shape, error)
      !> Solver whose finest grid says how many cells there must be.
      class(periodic_solver_t), intent(in) :: self
      !> Gap of the undeformed surfaces, whose number of cells is checked.
      real(dp), intent(in) :: shape(:, :)
      type(error_t), allocatable, intent(out) :: error

      if (any(ubound(shape) /= self%grids(size(self%grids))%operator%n_cells)) &
         call set_error(error, input_failure, 'the surface does not have the number of cells of its solver')
   end subroutine check_shape

   !> Set the state without contact.
   subroutine set_touch(self, shape, penetration, solution)
      !> Solver whose finest operator finds the pressure of full contact.
      class(periodic_solver_t), intent(inout) :: self
      !> Gap of the undeformed surfaces in the middles of the cells; 0 at first touch, and no less.
      real(dp), intent(in) :: shape(:, :)
      !> Penetration from first touch, at most the least value of `shape`.
      real(dp), intent(in) :: penetration
      type(periodic_solution_t), intent(inout) :: solution

      solution%gap = shape - penetration
      solution%stiffness_ratio = self%grids(size(self%grids))%operator%smallest_ratio()
      call set_full_pressure(self%grids(size(self%grids))%operator, shape, solution)
      solution%pressure = 0*shape
      solution%penetration = penetration
      solution%area%error = 0
      ! a contact smaller than a cell goes unseen
      if (penetration > 0) solution%area%error = 1/real(size(shape), dp)
      solution%residual = 0
      solution%status = contact_solved
   end subroutine set_touch

   !> Solve on each grid, from the coarsest that has contact to the finest.
   subroutine solve(self, shape, goal, tolerance, solution, hardness)
      class(periodic_solver_t), intent(inout) :: self
      !> Gap of the undeformed surfaces in the middles of the cells; 0 at first touch, and no less.
      real(dp), intent(in) :: shape(:, :)
      !> What is given: the mean pressure or the mean gap.
      type(contact_state_t), intent(in) :: goal
      real(dp), intent(in) :: tolerance
      !> Receives the solution, and how often the finest operator was applied for it.
      type(periodic_solution_t), intent(inout) :: solution
      !> Where the solid yields; not given: nowhere.
      type(hardness_t), intent(in), optional :: hardness
      type(contact_state_t), allocatable :: states(:)
      integer :: k, n, first
      logical :: is_definite

      n = size(self%grids)
      solution%stiffness_ratio = self%grids(n)%operator%smallest_ratio()
      is_definite = solution%stiffness_ratio > 0
      ! the steps over maps and at a mean gap are for definite stiffnesses alone
      if (.not. is_definite .and. (size(shape, 2) > 1 .or. goal%has_fixed_mean)) return
      allocate (states(n), source=goal)
      states(n)%shape = shape
      first = n
      do k = n - 1, 1, -1
         states(k)%shape = coarsen(states(k + 1)%shape)
         if (touches(states(k))) first = k
         if (first > k) exit
      end do
      do k = first, n
         associate (grid => self%grids(k))
            solution%n_applied = -grid%operator%n_applied
            call grid%operator%resist_mean(goal%resists_mean)
            if (k == first) call start_contact(states(k), grid%operator)
            if (k > first) call start_from_coarse(states(k), states(k - 1), grid%operator)
            if (present(hardness)) then
               if (k == first) call guess_yield(states(k), grid%operator, hardness%pressure)
               if (k > first) call guess_from_coarse(states(k), states(k - 1), grid%operator, hardness%pressure)
               call solve_yield(states(k), grid%operator, grid%gap_solver, hardness%pressure, &
                  & merge(tolerance, coarse_tolerance, k == n))
            else if (is_definite) then
               call solve_contact(states(k), grid%operator, grid%gap_solver, merge(tolerance, coarse_tolerance, k == n))
            else
               call solve_line(states(k), grid%operator, merge(tolerance, coarse_tolerance, k == n))
            end if
            call grid%operator%resist_mean(.false.)
            if (grid%operator%is_stopped()) return
            if (k == n) call set_full_pressure(grid%operator, shape, solution)
            solution%n_applied = solution%n_applied + grid%operator%n_applied
            solution%n_pairs = solution%n_pairs + solution%n_applied*(real(size(states(k)%gap), dp)/size(shape))
         end associate
      end do
      call set_solution(states(first:), self%grids(n)%operator, solution)
      call set_friction(self, states, shape, solution)
   end subroutine solve

   !> Find the friction on the finest grid, and from the loss on the two coarser ones that have a contact.
   subroutine set_friction(self, states, shape, solution)
      class(periodic_solver_t), intent(inout) :: self
      !> Contacts on all grids, the finest last; without a gap where there is none.
      type(contact_state_t), intent(in) :: states(:)
      !> Gap of the undeformed surfaces in the middles of the cells.
      real(dp), intent(in), contiguous :: shape(:, :)
      !> In: pressure and gap. Out: with friction.
      type(periodic_solution_t), intent(inout) :: solution
      integer :: k, n

      n = size(states)
      call get_friction(self%grids(n)%operator, solution%pressure, shape, solution%gap, solution%friction)
      solution%n_coarse_losses = 0
      do k = 1, min(n - 1, size(solution%coarse_losses, 2))
         if (.not. allocated(states(n - k)%gap)) exit
         call get_losses(self%grids(n - k)%operator, states(n - k)%gap - states(n - k)%shape, solution%coarse_losses(:, k))
         solution%n_coarse_losses = k
      end do
   end subroutine set_friction

   !> Find the pressure at which contact becomes full, and the friction from there on.
   subroutine set_full_pressure(operator, shape, solution)
      type(periodic_operator_t), intent(inout) :: operator
      !> Gap of the undeformed surfaces in the middles of the cells.
      real(dp), intent(in) :: shape(:, :)
      type(periodic_solution_t), intent(inout) :: solution
      real(dp), allocatable :: tension(:, :)

      allocate (tension, mold=shape)
      call operator%apply_stiffness(shape, tension)
      solution%full_pressure = maxval(tension)
      call get_losses(operator, shape, solution%full_friction)
   end subroutine set_full_pressure

   !> Is there contact? Under given penetration a coarse grid may have lost the summits that touch.
   pure logical function touches(state)
      type(contact_state_t), intent(in) :: state

      touches = .not. state%has_fixed_mean
      if (.not. touches) touches = minval(state%shape) < sum(state%shape)/size(state%shape) - state%mean_gap
   end function touches

   !> Begin from gap and open region of the next coarser grid. A function that changes its sign at the edge of the contact tells
   !> where this edge lies.
   subroutine start_from_coarse(state, coarse, operator)
      !> Contact on the finer grid; receives gap, open region and mean pressure to begin from.
      type(contact_state_t), intent(inout) :: state
      type(contact_state_t), intent(in) :: coarse
      !> Operator of the finer grid, for its cells and symmetry.
      type(periodic_operator_t), intent(in) :: operator
      real(dp) :: sign_function(size(coarse%gap, 1), size(coarse%gap, 2))
      real(dp), allocatable :: detail(:, :)

      sign_function = merge(-coarse%gap/maxval(operator%cell_size), coarse%pressure, coarse%is_open)
      allocate (detail, mold=state%shape)
      detail(:, :) = state%shape - refine(coarse%shape, state%shape, operator%is_quarter)
      ! waves that only the finer grid has leave the displacement as it is where the surfaces are apart, and part them elsewhere
      state%is_open = refine(sign_function, state%shape, operator%is_quarter) < detail/(2*maxval(operator%cell_size))
      state%gap = max(refine(coarse%gap, state%shape, operator%is_quarter) + detail, 0.0_dp)
      state%mean_pressure = coarse%mean_pressure
   end subroutine start_from_coarse

   !> Collect what the grids have found.
   subroutine set_solution(states, operator, solution)
      !> Contacts on the grids that were used, the finest last.
      type(contact_state_t), intent(in) :: states(:)
      type(periodic_operator_t), intent(in) :: operator
      !> Receives the contact on the finest grid, and the area with its error from coarser ones.
      type(periodic_solution_t), intent(inout) :: solution
      type(area_t) :: areas(size(states))
      real(dp) :: total
      integer :: k, n, first

      n = size(states)
      first = n
      do k = n, max(1, n - grids_for_error + 1), -1
         if (.not. allocated(states(k)%is_open)) exit
         areas(k) = area_of_cells(.not. states(k)%is_open, operator%is_quarter)
         first = k
      end do
      if (n - first + 1 >= grids_for_error) call refine_area(areas(n), areas(n - 1), areas(n - 2), size(states(n)%shape, 2) == 1)
      solution%area = areas(n)
      solution%residual = residual_of(states(n))
      solution%status = merge(contact_solved, contact_not_converged, states(n)%is_converged)
      solution%n_iterations = states(n)%n_iterations
      solution%mean_pressure = states(n)%mean_pressure
      if (states(n)%resists_mean) solution%mean_pressure = load_of(states(n))
      if (states(n)%resists_mean .and. allocated(states(n)%cohesion)) solution%mean_pressure = solution%mean_pressure &
         & - states(n)%cohesion%mean_tension()
      solution%penetration = sum(states(n)%shape - states(n)%gap)/size(states(n)%shape) &
         & + operator%mean_compliance*solution%mean_pressure
      if (allocated(states(n)%plastic_depth)) solution%penetration = solution%penetration &
         & + sum(states(n)%plastic_depth)/size(states(n)%shape)
      solution%gap = max(states(n)%gap, 0.0_dp)
      solution%pressure = merge(0.0_dp, max(states(n)%pressure, 0.0_dp), states(n)%is_open)
      ! what little pressure was left in open cells is that of the others, so that they carry the load
      total = sum_of(solution%pressure)
      if (total > 0) solution%pressure(:, :) = solution%pressure*(load_of(states(n))*size(solution%pressure)/total)
      if (allocated(states(n)%cohesion)) call take_tension(states(n)%cohesion, solution)
      solution%elastic_energy = sum((solution%gap - states(n)%shape)*(solution%pressure - solution%mean_pressure)) &
         & /(2*size(solution%gap)) + operator%mean_compliance*solution%mean_pressure**2/2
      if (.not. allocated(states(n)%plastic_depth)) return
      ! what the elastic solid gives way by is less by the impressions
      solution%plastic_depth = states(n)%plastic_depth
      solution%elastic_energy = solution%elastic_energy - sum(solution%plastic_depth*(solution%pressure - solution%mean_pressure)) &
         & /(2*size(solution%gap))
   end subroutine set_solution

   !> Take the tension of adhesion from the pressure, and find the energy of adhesion.
   subroutine take_tension(cohesion, solution)
      type(cohesion_t), intent(in) :: cohesion
      !> In: pressure with the tension added, and the gap. Out: the pressure, shares and energy.
      type(periodic_solution_t), intent(inout) :: solution

      solution%share = cohesion%share
      if (allocated(cohesion%part)) then
         solution%weighted_share = cohesion%share
         solution%share = cohesion%area_share(solution%gap)
      end if
      solution%pressure(:, :) = solution%pressure - cohesion%stress*cohesion%share
      solution%adhesion_energy = cohesion%energy_of(solution%gap)
   end subroutine take_tension

   !> The mean pressure that contact carries: the load, and the tension that presses the surfaces together.
   real(dp) function load_of(state) result(load)
      type(contact_state_t), intent(in) :: state

      load = state%mean_pressure
      if (allocated(state%cohesion)) load = load + state%cohesion%mean_tension()
      if (state%resists_mean) load = sum_of(state%pressure)/size(state%pressure)
   end function load_of

end module adfric_periodic_solver
