! SPDX-License-Identifier: GPL-3.0-or-later
!> One contact of a periodic surface, in the units of its case: lengths in periods along x, pressures in E*. The file is long by
!> what a surface and a goal have, each with its comment, and by the solvers among which it chooses.
module adfric_periodic_point
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_watch, only: watch_t
   use adfric_interface_coulomb_rows, only: coulomb_t
   use adfric_numerics_found_once, only: found_once_t
   use adfric_periodic_adhesive_penetration, only: solve_adhesive_penetration
   use adfric_periodic_adhesive_pull_off, only: periodic_pull_off_t
   use adfric_periodic_adhesive_solver, only: periodic_adhesion_t, solve_adhesive_layer, solve_adhesive_load
   use adfric_periodic_attracted_penetration, only: solve_attracted_penetration
   use adfric_periodic_attracted_surface, only: periodic_attraction_t, solve_attracted_layer, solve_attracted_load
   use adfric_periodic_cohesion, only: new_cohesion
   use adfric_periodic_contact, only: contact_state_t
   use adfric_periodic_contact_punch, only: find_contact_punch
   use adfric_periodic_elastic_kernel, only: elastic_kernel_t
   use adfric_periodic_grids, only: coarsen, halve
   use adfric_periodic_kernel, only: kernel_t
   use adfric_periodic_near_contact, only: solve_near_contact
   use adfric_periodic_operator, only: periodic_operator_t, new_periodic_operator
   use adfric_periodic_pull_off_table, only: seek_on_grid
   use adfric_periodic_slip, only: periodic_slip_t, solve_slip
   use adfric_periodic_solver, only: branches_agree, branches_differ, branches_unknown, contact_not_converged, &
      & contact_out_of_range, contact_solved, hardness_t, periodic_solver_t, periodic_solution_t, new_periodic_solver
   implicit none (type, external)
   private
   public :: periodic_surface_t, periodic_solid_t, periodic_goal_t, periodic_memory_t, solve_periodic, find_full_pressure
   public :: find_near_contacts

   !> Largest difference of a cell's share of two solutions of one state; rounds end within 1e-5.
   real(dp), parameter :: same_share = 1.0e-3_dp

   !> A kernel at another velocity.
   type :: near_kernel_t
      !> The kernel.
      class(kernel_t), allocatable :: kernel
   end type near_kernel_t

   !> What a surface is pressed against.
   type :: periodic_solid_t
      !> Contact modulus E*, the unit of pressures [Pa].
      real(dp) :: modulus = 1
      !> Its surface, with lengths in periods along x and pressures in E*; not allocated: an elastic half-space.
      class(kernel_t), allocatable :: kernel
      !> Kernels at velocities a little off; not allocated: the velocity does not count.
      type(near_kernel_t), allocatable :: near_kernels(:)
      !> Numbers from which the kernel was made; kernels of equal numbers are equal. Only beside a kernel.
      real(dp), allocatable :: numbers(:)
   end type periodic_solid_t

   !> A surface.
   type :: periodic_surface_t
      !> Periods along x and y [m].
      real(dp) :: period(2) = 0
      !> Number of cells along x and y; 1 along y for a surface that does not vary there.
      integer :: n_cells(2) = 0
      !> Is it even about 0 and half a period in both directions, and only that quarter given?
      logical :: is_quarter = .false.
      !> Gap of the undeformed surfaces in the middles of the cells, 0 at first touch [m].
      real(dp), allocatable :: shape(:, :)
      !> What it is pressed against; not allocated: an elastic half-space.
      class(periodic_solid_t), allocatable :: solid
   contains
      procedure :: cell_sizes
      procedure :: middles
   end type periodic_surface_t

   !> What is prescribed at a point.
   type :: periodic_goal_t
      !> Is it the mean pressure [E*], or else the penetration [m]?
      logical :: is_pressure = .true.
      !> The given value of that.
      real(dp) :: value = 0
      !> Largest residual.
      real(dp) :: tolerance = 1.0e-10_dp
      !> Adhesion, with its stress in E* and its range in m; not allocated: none.
      type(periodic_adhesion_t), allocatable :: adhesion
      !> Attraction by another law, with stresses in E* and lengths in m; not allocated: none. Of elastic half-spaces alone.
      type(periodic_attraction_t), allocatable :: attraction
      !> Friction, with its stress in E*; not allocated: none. Elastic half-spaces without adhesion alone.
      type(coulomb_t), allocatable :: friction
      !> Where the solid yields, with pressures in E*; not allocated: nowhere. Under a mean pressure without adhesion and friction alone.
      type(hardness_t), allocatable :: hardness
      !> Is the pull-off wanted? Is the state of the other branch?
      logical :: wants_pull_off = .false., wants_other_branch = .false.
      !> Are contacts at velocities a little off wanted? Is the stiffness of the spots that touch?
      logical :: wants_near = .false., wants_punch = .false.
      !> Pull-offs that the points of a run share; null: of this point alone.
      type(found_once_t), pointer :: pull_offs => null()
      !> Whom iterations ask whether they shall end; null: nobody.
      class(watch_t), pointer :: watch => null()
   end type periodic_goal_t

   !> Solver of the last point, for the next one.
   type :: periodic_memory_t
      private
      !> Number of cells of the solver in each direction; 0 before there is one.
      integer :: n_cells(2) = 0
      !> Period of its surface in each direction [m].
      real(dp) :: period(2) = 0
      !> Does it solve a quarter of the period?
      logical :: is_quarter = .false.
      !> Numbers from which its kernel was made; none for an elastic half-space.
      real(dp), allocatable :: kernel_numbers(:)
      !> The solver, with its transforms and buffers, and that of half the cells; the latter is made where a pull-off is sought.
      type(periodic_solver_t), allocatable :: solver, half
   end type periodic_memory_t

contains

   !> Sizes of a cell along x and y [m].
   pure function cell_sizes(self) result(sizes)
      class(periodic_surface_t), intent(in) :: self
      real(dp) :: sizes(2)

      sizes = self%period/(self%n_cells*merge(2, 1, self%is_quarter))
   end function cell_sizes

   !> Coordinates of the middles of the cells along x or y [m].
   pure function middles(self, along)
      class(periodic_surface_t), intent(in) :: self
      !> 1 along x, 2 along y.
      integer, intent(in) :: along
      real(dp) :: middles(self%n_cells(along))
      integer :: i

      associate (n => self%n_cells(along))
         middles = [(self%period(along)*(i - 0.5_dp)/(n*merge(2, 1, self%is_quarter)), i=1, n)]
      end associate
   end function middles

   !> Solve a point; an error means that there is no memory.
   subroutine solve_periodic(surface, goal, memory, solution, slip, error)
      !> Periods and undeformed gap of the surface [m].
      type(periodic_surface_t), intent(in) :: surface
      !> What is prescribed at the point, and the largest residual.
      type(periodic_goal_t), intent(in) :: goal
      !> Solver of the last point; made anew where cells, ratio of the periods or symmetry are others.
      type(periodic_memory_t), intent(inout) :: memory
      !> The solution; lengths in m, pressures in E*.
      type(periodic_solution_t), intent(out) :: solution
      !> Receives partial slip, in the same units; not allocated without friction or without contact.
      type(periodic_slip_t), allocatable, intent(out) :: slip
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      real(dp) :: unit

      unit = surface%period(1)
      call prepare(surface, memory, error)
      if (allocated(error)) return
      call let_watch(goal%watch, memory%solver)
      if (allocated(goal%attraction)) then
         call solve_attracted(surface, goal, memory, solution, error)
      else if (allocated(goal%adhesion)) then
         call solve_adhesive(surface, goal, memory, solution, error)
      else if (allocated(goal%hardness)) then
         call memory%solver%solve_yielding(surface%shape/unit, goal%value, goal%hardness, goal%tolerance, solution, error)
      else if (goal%is_pressure) then
         call memory%solver%solve_load(surface%shape/unit, goal%value, goal%tolerance, solution, error)
      else
         call memory%solver%solve_penetration(surface%shape/unit, goal%value/unit, goal%tolerance, solution, error)
      end if
      if (allocated(error)) return
      if (allocated(goal%friction)) call solve_slip(memory%solver, surface%shape/unit, goal%friction, goal%tolerance, solution, &
         & slip, error)
      if (allocated(error)) return
      if (allocated(slip)) then
         slip%displacement = slip%displacement*unit
         slip%cycle_energy = slip%cycle_energy*unit
         slip%compliance = slip%compliance*unit
      end if
      if (goal%wants_punch .and. solution%status == contact_solved) call add_punch(goal, memory%solver, unit, solution)
      solution%penetration = solution%penetration*unit
      if (allocated(solution%gap)) solution%gap = solution%gap*unit
      if (allocated(solution%plastic_depth)) solution%plastic_depth = solution%plastic_depth*unit
      solution%elastic_energy = solution%elastic_energy*unit
      solution%adhesion_energy = solution%adhesion_energy*unit
      solution%opening_loss = solution%opening_loss*unit
   end subroutine solve_periodic

   !> Find the stiffness of the spots that touch.
   subroutine add_punch(goal, solver, unit, solution)
      type(periodic_goal_t), intent(in) :: goal
      type(periodic_solver_t), intent(inout) :: solver
      !> Unit of length of the solver [m].
      real(dp), intent(in) :: unit
      !> In: solved, in units of the solver. Out: with the punch, whose compliance is in m over E*; not converged if it is not found.
      type(periodic_solution_t), intent(inout) :: solution
      logical, allocatable :: is_open(:, :)
      integer :: n_before

      allocate (is_open(size(solution%gap, 1), size(solution%gap, 2)), source=.false.)
      if (allocated(goal%adhesion) .or. allocated(goal%attraction)) then
         is_open(:, :) = solution%gap > 0
      else
         is_open(:, :) = .not. solution%pressure > 0
      end if
      allocate (solution%punch)
      associate (grid => solver%grids(size(solver%grids)))
         n_before = grid%operator%n_applied
         call find_contact_punch(grid%operator, grid%gap_solver, is_open, solution%area, goal%tolerance, solution%punch)
         solution%n_pairs = solution%n_pairs + (grid%operator%n_applied - n_before)
      end associate
      if (solution%punch%compliance > 0) solution%punch%compliance = solution%punch%compliance*unit
      if (.not. solution%punch%is_found) solution%status = contact_not_converged
   end subroutine add_punch

   !> Find the contacts of a solution at velocities a little off, as far as they are found.
   subroutine find_near_contacts(surface, goal, memory, solution)
      !> Periods and undeformed gap of the surface [m], and its solid.
      type(periodic_surface_t), intent(in) :: surface
      type(periodic_goal_t), intent(in) :: goal
      !> Solver of the point; made anew where a closed form needed none.
      type(periodic_memory_t), intent(inout) :: memory
      !> In: solved; lengths in m, pressures in E*. Out: with these contacts.
      type(periodic_solution_t), intent(inout) :: solution
      type(periodic_operator_t), allocatable :: operator
      type(contact_state_t) :: state
      type(periodic_adhesion_t) :: law
      type(error_t), allocatable :: error
      integer :: k, n

      n = 0
      if (allocated(surface%solid%near_kernels)) n = size(surface%solid%near_kernels)
      allocate (solution%near(n))
      if (n == 0) return
      call prepare(surface, memory, error)
      if (allocated(error)) return
      associate (unit => surface%period(1), grid => memory%solver%grids(size(memory%solver%grids)))
         do k = 1, n
            allocate (operator)
            call new_periodic_operator(operator, surface%solid%near_kernels(k)%kernel, shape(surface%shape), surface%period/unit, &
               & .false., .false., error)
            if (allocated(error)) return
            operator%watch => goal%watch
            state = contact_state_t()
            state%shape = surface%shape/unit
            state%gap = solution%gap/unit
            state%is_open = solution%gap > 0
            state%has_fixed_mean = .not. (goal%is_pressure .or. operator%mean_compliance > 0)
            state%resists_mean = .not. (goal%is_pressure .or. state%has_fixed_mean)
            state%mean_pressure = solution%mean_pressure
            if (state%resists_mean) state%mean_pressure = goal%value/unit/operator%mean_compliance
            state%mean_gap = sum(state%gap)/size(state%gap)
            if (allocated(goal%adhesion) .and. allocated(solution%share)) then
               allocate (state%cohesion)
               law = goal%adhesion
               if (allocated(law%law)) law%law = law%law%in_units(1.0_dp, unit)
               call new_cohesion(state%cohesion, law%stress, law%range/unit, .false., law%law)
            end if
            call solve_near_contact(state, operator, grid%gap_solver, goal%tolerance, solution%near(k))
            deallocate (operator)
         end do
      end associate
   end subroutine find_near_contacts

   !> Solve a point with another law of adhesion, and find its pull-off if it is wanted.
   subroutine solve_attracted(surface, goal, memory, solution, error)
      !> Periods and undeformed gap of the surface [m].
      type(periodic_surface_t), intent(in) :: surface
      type(periodic_goal_t), intent(in) :: goal
      type(periodic_memory_t), intent(inout) :: memory
      !> The solution; lengths in periods along x, pressures in E*.
      type(periodic_solution_t), intent(out) :: solution
      type(error_t), allocatable, intent(out) :: error
      type(periodic_attraction_t) :: attraction

      attraction = goal%attraction%in_length(surface%period(1))
      associate (solver => memory%solver, shape_in_periods => surface%shape/surface%period(1))
         if (goal%is_pressure) then
            call solve_attracted_load(solver, shape_in_periods, goal%value, attraction, goal%tolerance, solution, error)
            if (allocated(error)) return
            ! a bound that finds no state is a proof where states have an order
            if (solution%status == contact_out_of_range .and. .not. solver%kernel%orders_states() &
               & .and. goal%value >= -largest_tension_of(attraction%law%stress, attraction%part)) &
               & solution%status = contact_not_converged
         else if (solver%grids(size(solver%grids))%operator%mean_compliance > 0) then
            call solve_attracted_layer(solver, shape_in_periods, goal%value/surface%period(1), attraction, goal%tolerance, &
               & solution, error)
         else
            call solve_attracted_penetration(solver, shape_in_periods, goal%value/surface%period(1), attraction, goal%tolerance, &
               & solution, error)
         end if
         if (allocated(error) .or. .not. goal%wants_pull_off) return
         call add_pull_off(goal, memory, shape_in_periods, solution, error, attraction=attraction)
      end associate
   end subroutine solve_attracted

   !> Solve a point with adhesion, and find its pull-off if it is wanted and not known.
   subroutine solve_adhesive(surface, goal, memory, solution, error)
      !> Periods and undeformed gap of the surface [m].
      type(periodic_surface_t), intent(in) :: surface
      type(periodic_goal_t), intent(in) :: goal
      type(periodic_memory_t), intent(inout) :: memory
      !> The solution; lengths in periods along x, pressures in E*.
      type(periodic_solution_t), intent(out) :: solution
      type(error_t), allocatable, intent(out) :: error
      type(periodic_adhesion_t) :: adhesion, branch
      type(periodic_solution_t) :: other, without
      real(dp), allocatable :: shape_in_periods(:, :)
      real(dp) :: value

      adhesion = goal%adhesion
      adhesion%range = adhesion%range/surface%period(1)
      if (allocated(adhesion%law)) adhesion%law = adhesion%law%in_units(1.0_dp, surface%period(1))
      allocate (shape_in_periods, source=surface%shape/surface%period(1))
      value = goal%value
      if (.not. goal%is_pressure) value = goal%value/surface%period(1)
      call solve_branch(memory%solver, shape_in_periods, goal, value, adhesion, solution, error)
      if (allocated(error)) return
      associate (grids => memory%solver%grids)
         if (.not. grids(size(grids))%operator%is_symmetric .and. solution%mean_pressure > 0 .and. &
            & solution%status == contact_solved) then
            call memory%solver%solve_load(shape_in_periods, solution%mean_pressure, goal%tolerance, without, error)
            if (allocated(error)) return
            if (without%status == contact_solved) solution%loss_without_adhesion = without%friction%loss
         end if
      end associate
      if (goal%wants_other_branch .and. solution%status == contact_solved) then
         branch = adhesion
         branch%is_adhered = .not. adhesion%is_adhered
         call solve_branch(memory%solver, shape_in_periods, goal, value, branch, other, error)
         if (allocated(error)) return
         solution%branches = compare(solution, other)
      end if
      if (goal%wants_pull_off) call add_pull_off(goal, memory, shape_in_periods, solution, error, adhesion=adhesion)
   end subroutine solve_adhesive

   !> Find the pull-off, and its error from the grid of half the cells: the contact that comes off is smaller than the one under load.
   subroutine add_pull_off(goal, memory, shape, solution, error, adhesion, attraction)
      type(periodic_goal_t), intent(in) :: goal
      type(periodic_memory_t), intent(inout) :: memory
      !> Gap of the undeformed surfaces [periods along x].
      real(dp), intent(in) :: shape(:, :)
      !> Receives the pull-off and its error.
      type(periodic_solution_t), intent(inout) :: solution
      type(error_t), allocatable, intent(out) :: error
      !> The law, one of both.
      type(periodic_adhesion_t), intent(in), optional :: adhesion
      type(periodic_attraction_t), intent(in), optional :: attraction
      type(periodic_adhesion_t), allocatable :: half_adhesion
      type(periodic_attraction_t), allocatable :: half_attraction
      type(periodic_pull_off_t) :: pull_off, of_half
      real(dp), allocatable :: half_shape(:, :)

      call seek_on_grid(goal%pull_offs, memory%solver, shape, [memory%period, memory%kernel_numbers], goal%tolerance, adhesion, &
         & attraction, pull_off, error)
      if (allocated(error) .or. .not. pull_off%is_found) return
      solution%pull_off = pull_off%mean_pressure
      call prepare_half(goal, memory, error)
      if (allocated(error) .or. .not. allocated(memory%half)) return
      allocate (half_shape, source=halve(shape, memory%is_quarter))
      half_shape(:, :) = half_shape - minval(half_shape)
      if (present(adhesion)) then
         allocate (half_adhesion, source=adhesion)
         if (allocated(adhesion%part)) half_adhesion%part = coarsen(adhesion%part)
      else
         allocate (half_attraction, source=attraction)
         if (allocated(attraction%part)) half_attraction%part = coarsen(attraction%part)
      end if
      call seek_on_grid(goal%pull_offs, memory%half, half_shape, [memory%period, memory%kernel_numbers], goal%tolerance, &
         & half_adhesion, half_attraction, of_half, error)
      if (.not. allocated(error)) solution%pull_off_error = pull_off%error_beside(of_half)
   end subroutine add_pull_off

   !> A solver of half the cells, where they can be halved.
   subroutine prepare_half(goal, memory, error)
      type(periodic_goal_t), intent(in) :: goal
      !> With the solver of all cells.
      type(periodic_memory_t), intent(inout) :: memory
      type(error_t), allocatable, intent(out) :: error

      if (size(memory%solver%grids) < 2) return
      if (.not. allocated(memory%half)) then
         allocate (memory%half)
         call new_periodic_solver(memory%half, memory%solver%kernel, max(memory%n_cells/2, 1), memory%period, &
            & memory%is_quarter, error)
         if (allocated(error)) then
            deallocate (memory%half)
            return
         end if
      end if
      call let_watch(goal%watch, memory%half)
   end subroutine prepare_half

   !> Let a watch say when the work of a solver ends.
   subroutine let_watch(watch, solver)
      !> The watch; null: nobody ends it.
      class(watch_t), pointer, intent(in) :: watch
      type(periodic_solver_t), intent(inout) :: solver
      integer :: k

      do k = 1, size(solver%grids)
         solver%grids(k)%operator%watch => watch
      end do
   end subroutine let_watch

   !> Solve on a branch what the goal prescribes.
   subroutine solve_branch(solver, shape, goal, value, adhesion, solution, error)
      type(periodic_solver_t), intent(inout) :: solver
      !> Gap of the undeformed surfaces [periods along x].
      real(dp), intent(in) :: shape(:, :)
      type(periodic_goal_t), intent(in) :: goal
      !> What it prescribes: mean pressure [E*] or penetration [periods along x].
      real(dp), intent(in) :: value
      !> Stress [E*], range [periods along x], and the branch.
      type(periodic_adhesion_t), intent(in) :: adhesion
      !> The solution; lengths in periods along x, pressures in E*.
      type(periodic_solution_t), intent(out) :: solution
      type(error_t), allocatable, intent(out) :: error

      if (goal%is_pressure) then
         call solve_adhesive_load(solver, shape, value, adhesion, goal%tolerance, solution, error)
         if (allocated(error)) return
         ! rounds that find no state are a proof where states have an order
         if (solution%status == contact_out_of_range .and. .not. solver%kernel%orders_states() &
            & .and. value >= -largest_tension_of(adhesion%stress, adhesion%part)) solution%status = contact_not_converged
      else if (solver%grids(size(solver%grids))%operator%mean_compliance > 0) then
         call solve_adhesive_layer(solver, shape, value, adhesion, goal%tolerance, solution, error)
      else
         call solve_adhesive_penetration(solver, shape, value, adhesion, goal%tolerance, solution, error)
      end if
   end subroutine solve_branch

   !> Mean tension that no state exceeds, whatever the solid [E*]: all cells within the range, and none pressed.
   pure real(dp) function largest_tension_of(stress, part) result(tension)
      !> Largest tension of the law [E*], and what of it each cell has; not allocated: all.
      real(dp), intent(in) :: stress
      real(dp), allocatable, intent(in) :: part(:, :)

      tension = stress
      if (allocated(part)) tension = tension*(sum(part)/size(part))
   end function largest_tension_of

   !> Does the other branch have another state? It has the same where no cell's share differs; one of `branches_...`.
   pure integer function compare(solution, other) result(branches)
      !> A solution, and what the other branch has under the same load or penetration.
      type(periodic_solution_t), intent(in) :: solution, other

      branches = branches_unknown
      if (other%status == contact_out_of_range) branches = branches_agree
      if (other%status /= contact_solved) return
      branches = merge(branches_agree, branches_differ, maxval(abs(solution%share - other%share)) <= same_share)
   end function compare

   !> Mean pressure at which contact becomes full on the cells of the surface: the largest tension under a flat surface, without a
   !> mean, that follows it everywhere. NaN if there is no memory.
   real(dp) function find_full_pressure(surface) result(pressure)
      !> Periods and undeformed gap of the surface [m].
      type(periodic_surface_t), intent(in) :: surface
      type(periodic_operator_t) :: operator
      type(error_t), allocatable :: error
      real(dp), allocatable :: tension(:, :)

      pressure = not_a_number()
      call make(surface, operator=operator, error=error)
      if (allocated(error)) return
      allocate (tension, mold=surface%shape)
      call operator%apply_stiffness(surface%shape/surface%period(1), tension)
      pressure = maxval(tension)
   end function find_full_pressure

   !> A solver of the surface's size and solid, where the last point has not left it.
   subroutine prepare(surface, memory, error)
      !> Periods and undeformed gap of the surface [m], and its solid.
      type(periodic_surface_t), intent(in) :: surface
      !> Solver of the last point; made anew where cells, ratio of the periods, symmetry or solid are others.
      type(periodic_memory_t), intent(inout) :: memory
      type(error_t), allocatable, intent(out) :: error

      if (is_kept(surface, memory)) return
      memory%n_cells = 0
      if (allocated(memory%half)) deallocate (memory%half)
      if (allocated(memory%solver)) deallocate (memory%solver)
      allocate (memory%solver)
      call make(surface, solver=memory%solver, error=error)
      if (allocated(error)) return
      memory%n_cells = shape(surface%shape)
      memory%period = surface%period/surface%period(1)
      memory%is_quarter = surface%is_quarter
      memory%kernel_numbers = numbers_of(surface)
   end subroutine prepare

   !> Is the solver of the last point that of a surface?
   pure logical function is_kept(surface, memory)
      !> Periods and undeformed gap of the surface [m], and its solid.
      type(periodic_surface_t), intent(in) :: surface
      type(periodic_memory_t), intent(in) :: memory

      is_kept = .not. any(memory%n_cells /= shape(surface%shape))
      if (.not. is_kept) return
      is_kept = .not. (any(abs(memory%period - surface%period/surface%period(1)) > 0) &
         & .or. (memory%is_quarter .neqv. surface%is_quarter))
      if (.not. is_kept) return
      associate (numbers => numbers_of(surface))
         is_kept = size(memory%kernel_numbers) == size(numbers)
         if (is_kept) is_kept = .not. any(abs(memory%kernel_numbers - numbers) > 0)
      end associate
   end function is_kept

   !> Numbers from which the kernel of a surface is made.
   pure function numbers_of(surface) result(numbers)
      type(periodic_surface_t), intent(in) :: surface
      real(dp), allocatable :: numbers(:)

      allocate (numbers(0))
      if (.not. allocated(surface%solid)) return
      if (allocated(surface%solid%kernel)) numbers = surface%solid%numbers
   end function numbers_of

   !> Make a solver or an operator for the cells and the solid of a surface.
   subroutine make(surface, solver, operator, error)
      !> Periods and undeformed gap of the surface [m], and its solid.
      type(periodic_surface_t), intent(in) :: surface
      !> Receives the solver, where it is wanted.
      type(periodic_solver_t), intent(out), optional :: solver
      !> Receives the operator, where it is wanted.
      type(periodic_operator_t), intent(out), optional :: operator
      type(error_t), allocatable, intent(out) :: error

      if (allocated(surface%solid)) then
         if (allocated(surface%solid%kernel)) then
            call make_from(surface%solid%kernel)
            return
         end if
      end if
      call make_from(elastic_kernel_t())

   contains

      !> Make it for a kernel.
      subroutine make_from(kernel)
         class(kernel_t), intent(in) :: kernel

         associate (n => shape(surface%shape), period => surface%period/surface%period(1))
            if (present(solver)) call new_periodic_solver(solver, kernel, n, period, surface%is_quarter, error)
            if (present(operator)) call new_periodic_operator(operator, kernel, n, period, surface%is_quarter, .false., error)
         end associate
      end subroutine make_from

   end subroutine make

end module adfric_periodic_point
