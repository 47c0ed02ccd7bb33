! SPDX-License-Identifier: GPL-3.0-or-later
!> Contact of a body that ends at the border of a map, or on either side of a strip, by nested grids.
!>
!> A contact is solved on the coarsest grid, then on ever finer ones, each from the pressure and the region of the one before. The
!> three finest tell the errors of area, load and approach. Coarser ones than the finest are solved as far as these errors need it.
module adfric_periodic_free_solver
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_base_watch, only: watch_t
   use adfric_periodic_area, only: area_of_cells, area_t, refine_area, scatter_of_runs
   use adfric_periodic_chords, only: beside_body, chord_fraction
   use adfric_periodic_free_contact, only: solve_free_contact
   use adfric_periodic_free_operator, only: free_operator_t, new_free_operator
   use adfric_periodic_free_state, only: free_state_t
   use adfric_periodic_grids, only: n_grids_of, refine
   use adfric_periodic_maps, only: sum_of
   implicit none (type, external)
   private
   public :: free_field_t, free_solver_t, free_solution_t, new_free_solver, set_fields, solve_free, grids_for_error
   public :: change_error, free_hinge_t, is_inside

   !> Grids whose results tell the error of the finest one.
   integer, parameter :: grids_for_error = 3
   !> Residual of coarser grids: of the two next to the finest, whose results count, and of others.
   real(dp), parameter :: tolerance_for_error = 1.0e-4_dp, tolerance_of_start = 1.0e-2_dp
   !> Change from the last grid but one, as a part of which that before counts; and what is added for safety.
   real(dp), parameter :: of_change_before = 0.5_dp, safety = 1.25_dp

   !> Operators of all grids, the coarsest first. Not to be copied; one for each thread.
   type :: free_solver_t
      !> The operators.
      type(free_operator_t), allocatable :: operators(:)
   end type free_solver_t

   !> How a body may move under a load.
   type :: free_hinge_t
      !> May it tilt along x, along y?
      logical :: may_tilt(2) = .false.
      !> Point of the load from the corner of the map, in its unit.
      real(dp) :: point(2) = 0
   end type free_hinge_t

   !> A solved contact; lengths in the unit of the map, pressures in E*.
   type :: free_solution_t
      !> Was the contact found on all grids?
      logical :: is_converged = .false.
      !> Sum of pressure times area, approach, and bounds of their errors; an error is infinite (`huge`) where there are too few
      !> grids.
      real(dp) :: load = 0, approach = 0, load_error = huge(1.0_dp), approach_error = huge(1.0_dp)
      !> Tilts: slopes by which the body has come nearer along x and along y.
      real(dp) :: tilt(2) = 0
      !> Area in contact as a share of the map.
      type(area_t) :: area
      !> The same by chords, which varies smoothly.
      real(dp) :: smooth_area = 0
      !> Pressure and gap; 0 in contact and beside the body; shape of the cells.
      real(dp), allocatable :: pressure(:, :), gap(:, :)
      !> Half of the sum of pressure times displacement times area.
      real(dp) :: elastic_energy = 0
      !> Largest violation of the conditions of contact.
      real(dp) :: residual = 0
      !> Steps on the finest grid.
      integer :: n_iterations = 0
   end type free_solution_t

   !> A field on a grid.
   type :: free_field_t
      !> Gap of the undeformed surfaces on the cells.
      real(dp), allocatable :: shape(:, :)
      !> Is the cell one of the body?
      logical, allocatable :: is_body(:, :)
   end type free_field_t

contains

   !> Make the operators of all grids.
   subroutine new_free_solver(self, n_cells, lengths, is_periodic, watch, error)
      !> Receives the operators; of no use after an error.
      type(free_solver_t), intent(out) :: self
      !> Number of cells along x and y.
      integer, intent(in) :: n_cells(2)
      !> Lengths of the map along x and y, in any unit, > 0.
      real(dp), intent(in) :: lengths(2)
      !> Does the surface go on periodically along x, along y? Not along both.
      logical, intent(in) :: is_periodic(2)
      !> Whom iterations ask whether they shall end; null: nobody.
      class(watch_t), pointer, intent(in) :: watch
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      integer :: k, n

      n = n_grids_of(n_cells)
      allocate (self%operators(n))
      do k = 1, n
         call new_free_operator(self%operators(k), n_cells/2**(n - k), lengths, is_periodic, error)
         if (allocated(error)) return
         self%operators(k)%watch => watch
      end do
   end subroutine new_free_solver

   !> Solve a contact under a given load, or at a given approach.
   subroutine solve_free(self, shape, is_body, has_load, prescribed, tolerance, solution, hinge)
      type(free_solver_t), intent(inout) :: self
      !> Gap of the undeformed surfaces on the finest grid, 0 at first touch; of no meaning beside the body.
      real(dp), intent(in) :: shape(:, :)
      !> Is the cell one of the body? Same shape.
      logical, intent(in) :: is_body(:, :)
      !> Is the load given, and not the approach?
      logical, intent(in) :: has_load
      !> Load [E* times the square of the unit of length], >= 0, or approach.
      real(dp), intent(in) :: prescribed
      !> Largest residual on the finest grid [-].
      real(dp), intent(in) :: tolerance
      type(free_solution_t), intent(inout) :: solution
      !> How the body may move under a load. Not given: it does not tilt.
      type(free_hinge_t), intent(in), optional :: hinge
      type(free_field_t) :: fields(size(self%operators))
      type(free_state_t) :: states(size(self%operators))
      integer :: k, before, n
      real(dp) :: goal

      n = size(self%operators)
      if (.not. prescribed > 0) then
         call set_apart(shape, is_body, has_load, prescribed, solution)
         return
      end if
      call set_fields(fields, shape, is_body)
      do k = 1, n
         associate (operator => self%operators(k))
            states(k)%has_load = has_load
            states(k)%approach = merge(0.0_dp, prescribed, has_load)
            if (has_load) states(k)%total = prescribed/product(operator%cell_size)
            call move_alloc(fields(k)%shape, states(k)%shape)
            call move_alloc(fields(k)%is_body, states(k)%is_body)
            if (present(hinge)) call set_hinge(states(k), hinge, operator)
            before = k - 1
            if (k == 1) call start(states(k))
            if (k > 1) call start_from_coarse(states(k), states(before), operator)
            goal = tolerance
            if (k < n) goal = max(goal, merge(tolerance_for_error, tolerance_of_start, k > n - grids_for_error))
            call solve_free_contact(states(k), operator, goal)
            if (operator%is_stopped()) return
         end associate
      end do
      call set_solution(states, self%operators, solution)
   end subroutine solve_free

   !> Let a body tilt about the point of its load.
   subroutine set_hinge(state, hinge, operator)
      type(free_state_t), intent(inout) :: state
      type(free_hinge_t), intent(in) :: hinge
      !> Operator of the grid, for its cells.
      type(free_operator_t), intent(in) :: operator
      integer :: i

      state%may_tilt = hinge%may_tilt .and. state%has_load
      if (.not. any(state%may_tilt)) return
      state%arm_x = [((i - 0.5_dp)*operator%cell_size(1) - hinge%point(1), i=1, operator%n_cells(1))]
      state%arm_y = [((i - 0.5_dp)*operator%cell_size(2) - hinge%point(2), i=1, operator%n_cells(2))]
   end subroutine set_hinge

   !> Does the point of the load lie inside the outline of the body, so that it can stand on its cells? The outline is convex.
   pure logical function is_inside(is_body, lengths, hinge)
      !> Is the cell one of the body?
      logical, intent(in) :: is_body(:, :)
      !> Lengths of the map along x and y.
      real(dp), intent(in) :: lengths(2)
      type(free_hinge_t), intent(in) :: hinge
      real(dp) :: ends(2, size(is_body, 2)), y(size(is_body, 2)), left, right, part
      integer :: i, j, k

      is_inside = .true.
      if (.not. any(hinge%may_tilt)) return
      ends(1, :) = huge(1.0_dp)
      ends(2, :) = -huge(1.0_dp)
      do j = 1, size(is_body, 2)
         y(j) = (j - 0.5_dp)*lengths(2)/size(is_body, 2)
         i = findloc(is_body(:, j), .true., 1)
         if (i > 0) ends(1, j) = (i - 0.5_dp)*lengths(1)/size(is_body, 1)
         i = findloc(is_body(:, j), .true., 1, back=.true.)
         if (i > 0) ends(2, j) = (i - 0.5_dp)*lengths(1)/size(is_body, 1)
      end do
      associate (rows => pack(y, ends(1, :) < huge(1.0_dp)))
         if (hinge%may_tilt(2)) is_inside = minval(rows) < hinge%point(2) .and. hinge%point(2) < maxval(rows)
      end associate
      if (.not. (is_inside .and. hinge%may_tilt(1))) return
      left = huge(1.0_dp)
      right = -huge(1.0_dp)
      do j = 1, size(y)
         if (.not. ends(1, j) < huge(1.0_dp)) cycle
         if (.not. hinge%may_tilt(2)) then
            left = min(left, ends(1, j))
            right = max(right, ends(2, j))
            cycle
         end if
         if (y(j) > hinge%point(2)) exit
         do k = j, size(y)
            if (.not. ends(1, k) < huge(1.0_dp) .or. y(k) < hinge%point(2)) cycle
            part = 0
            if (k > j) part = (hinge%point(2) - y(j))/(y(k) - y(j))
            left = min(left, (1 - part)*ends(1, j) + part*ends(1, k))
            right = max(right, (1 - part)*ends(2, j) + part*ends(2, k))
         end do
      end do
      is_inside = left < hinge%point(1) .and. hinge%point(1) < right
   end function is_inside

   !> The bodies do not press each other.
   subroutine set_apart(shape, is_body, has_load, prescribed, solution)
      real(dp), intent(in) :: shape(:, :)
      logical, intent(in) :: is_body(:, :)
      logical, intent(in) :: has_load
      !> Load, 0, or approach, not above 0.
      real(dp), intent(in) :: prescribed
      type(free_solution_t), intent(inout) :: solution

      solution = free_solution_t()
      solution%is_converged = .true.
      if (.not. has_load) solution%approach = prescribed
      solution%area%error = 0
      solution%load_error = 0
      solution%approach_error = 0
      allocate (solution%pressure, solution%gap, mold=shape)
      solution%pressure(:, :) = 0
      solution%gap(:, :) = merge(shape - solution%approach, 0.0_dp, is_body)
   end subroutine set_apart

   !> The undeformed gap and the body on all grids: means over those of four cells that are of the body.
   subroutine set_fields(fields, shape, is_body)
      !> Receives the fields, the coarsest first.
      type(free_field_t), intent(out) :: fields(:)
      real(dp), intent(in) :: shape(:, :)
      logical, intent(in) :: is_body(:, :)
      real(dp), allocatable :: weight(:, :)
      integer :: k, nx, ny

      k = size(fields)
      allocate (fields(k)%is_body, source=is_body)
      allocate (fields(k)%shape, source=shape)
      where (.not. is_body) fields(k)%shape = 0
      do k = size(fields) - 1, 1, -1
         associate (fine => fields(k + 1))
            nx = size(fine%shape, 1)
            ny = size(fine%shape, 2)
            allocate (weight(nx/2, ny/2))
            weight(:, :) = sum_of_four(merge(1.0_dp, 0.0_dp, fine%is_body), nx, ny)
            allocate (fields(k)%is_body, source=weight > 0)
            allocate (fields(k)%shape(nx/2, ny/2))
            fields(k)%shape(:, :) = sum_of_four(fine%shape, nx, ny)/max(weight, 1.0_dp)
            deallocate (weight)
         end associate
      end do
   end subroutine set_fields

   !> Sums over squares of four cells.
   pure function sum_of_four(fine, nx, ny) result(coarse)
      real(dp), intent(in) :: fine(:, :)
      !> Number of cells of the finer grid, even.
      integer, intent(in) :: nx, ny
      real(dp) :: coarse(nx/2, ny/2)

      coarse = (fine(1:nx:2, 1:ny:2) + fine(2:nx:2, 1:ny:2)) + (fine(1:nx:2, 2:ny:2) + fine(2:nx:2, 2:ny:2))
   end function sum_of_four

   !> Begin on the coarsest grid: under a load with all cells of the body, else with those that overlap.
   subroutine start(state)
      type(free_state_t), intent(inout) :: state

      allocate (state%pressure, state%displacement, mold=state%shape)
      allocate (state%is_contact, source=state%is_body)
      if (.not. state%has_load) state%is_contact(:, :) = state%is_body .and. state%shape < state%approach
      state%pressure(:, :) = merge(1.0_dp, 0.0_dp, state%is_contact)
      if (.not. state%has_load) state%pressure(:, :) = 0
   end subroutine start

   !> Begin from pressure and region of the next coarser grid. A function that changes its sign at the edge of the contact tells
   !> where this edge lies, and waves that only the finer grid has part the surfaces where they are higher than the pressure bears.
   subroutine start_from_coarse(state, coarse, operator)
      !> Contact on the finer grid; receives pressure and region to begin from.
      type(free_state_t), intent(inout) :: state
      type(free_state_t), intent(in) :: coarse
      !> Operator of the finer grid, for its cells.
      type(free_operator_t), intent(in) :: operator
      real(dp), allocatable :: sign_function(:, :), detail(:, :)
      integer :: j

      associate (width => maxval(operator%cell_size))
         allocate (sign_function, mold=coarse%shape)
         allocate (detail, state%displacement, mold=state%shape)
         do j = 1, size(sign_function, 2)
            sign_function(:, j) = merge(coarse%pressure(:, j), -(coarse%displacement(:, j) + coarse%shape(:, j) &
               & - coarse%depths(j))/width, coarse%is_contact(:, j))
         end do
         detail(:, :) = (state%shape - refine(coarse%shape, state%shape, .true.))/(2*width)
         allocate (state%is_contact, source=state%is_body)
         state%is_contact(:, :) = state%is_body .and. refine(sign_function, state%shape, .true.) >= detail
         ! the load stands on something
         if (.not. any(state%is_contact)) state%is_contact(:, :) = state%is_body .and. &
            & refine(coarse%pressure, state%shape, .true.) > 0
      end associate
      allocate (state%pressure, mold=state%shape)
      state%pressure(:, :) = max(refine(coarse%pressure, state%shape, .true.), 0.0_dp)
   end subroutine start_from_coarse

   !> Collect what the grids have found.
   subroutine set_solution(states, operators, solution)
      !> Contacts on all grids, the finest last.
      type(free_state_t), intent(in) :: states(:)
      type(free_operator_t), intent(in) :: operators(:)
      type(free_solution_t), intent(inout) :: solution
      type(area_t) :: areas(size(states))
      real(dp), allocatable :: gap(:, :)
      real(dp) :: loads(size(states)), cell
      integer :: k, n

      solution = free_solution_t()
      n = size(states)
      do k = max(1, n - grids_for_error + 1), n
         areas(k) = area_of_cells(states(k)%is_contact, .false., operators(k)%is_periodic)
         loads(k) = sum_of(states(k)%pressure)*product(operators(k)%cell_size)
      end do
      if (n >= grids_for_error) then
         call refine_area(areas(n), areas(n - 1), areas(n - 2), .false.)
         solution%load_error = change_error(loads(n - 2:))
         solution%approach_error = change_error(states(n - 2:)%approach)
      end if
      cell = product(operators(n)%cell_size)
      associate (finest => states(n))
         solution%area = areas(n)
         solution%is_converged = finest%is_converged
         solution%residual = finest%residual
         solution%n_iterations = finest%n_iterations
         solution%approach = finest%approach
         allocate (solution%pressure, solution%gap, mold=finest%shape)
         solution%pressure(:, :) = merge(max(finest%pressure, 0.0_dp), 0.0_dp, finest%is_contact)
         solution%tilt = finest%tilt
         do k = 1, size(solution%gap, 2)
            solution%gap(:, k) = merge(max(finest%displacement(:, k) + finest%shape(:, k) - finest%depths(k), 0.0_dp), 0.0_dp, &
               & finest%is_body(:, k) .and. .not. finest%is_contact(:, k))
         end do
         allocate (gap, source=solution%gap)
         where (.not. finest%is_body) gap = beside_body
         solution%smooth_area = chord_fraction(solution%pressure, gap, operators(n)%cell_size, .false., operators(n)%is_periodic)
         ! cells along a straight edge are all wrong together
         solution%area%error = max(solution%area%error, scatter_of_runs(finest%is_contact))
         solution%load = sum_of(solution%pressure)*cell
         if (finest%has_load .and. solution%load > 0) then
            solution%pressure(:, :) = solution%pressure*(finest%total*cell/solution%load)
            solution%load = finest%total*cell
         end if
         solution%elastic_energy = sum(solution%pressure*finest%displacement)*cell/2
      end associate
   end subroutine set_solution

   !> Bound of the error of the last of three values: of the last change, or a part of the one before.
   pure real(dp) function change_error(values) result(error)
      !> Values on three grids, the finest last.
      real(dp), intent(in) :: values(:)

      error = safety*max(abs(values(3) - values(2)), of_change_before*abs(values(2) - values(1)))
   end function change_error

end module adfric_periodic_free_solver
