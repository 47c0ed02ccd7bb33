! SPDX-License-Identifier: GPL-3.0-or-later
!> Adhesive contact of a body that ends at the border of a map, or on either side of a strip, by the law of Maugis and Dugdale or by
!> another one that falls with the gap.
!>
!> The body is solved as a periodic surface of twice the length (`adfric_periodic_free_kernel`), whose cells beyond the body lie so
!> deep that they neither touch nor come into range. That is looked at where the contact is known; if they do they are laid deeper.
!> So branches, turns and pull-off are those of `adfric_periodic_adhesive_solver`, and by other laws those of
!> `adfric_periodic_attracted_surface`. The force is the mean pressure of the doubled
!> map times its area, and the approach is the penetration of a layer. Grids of half and a quarter of the cells are solved each by
!> itself and tell the errors of load, approach and area.
module adfric_periodic_free_adhesion
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_base_watch, only: watch_t
   use adfric_numerics_found_once, only: found_once_t
   use adfric_periodic_adhesive_pull_off, only: periodic_pull_off_t
   use adfric_periodic_adhesive_solver, only: periodic_adhesion_t, solve_adhesive_layer, solve_adhesive_load
   use adfric_periodic_attracted_surface, only: solve_attracted_layer, solve_attracted_load
   use adfric_periodic_area, only: area_of_cells, area_t, refine_area, scatter_of_runs
   use adfric_periodic_chords, only: beside_body, chord_fraction
   use adfric_periodic_free_attraction, only: free_law_t
   use adfric_periodic_free_kernel, only: free_kernel_t, new_free_kernel
   use adfric_periodic_free_solver, only: change_error, free_field_t, free_solution_t, grids_for_error, set_fields
   use adfric_periodic_grids, only: n_grids_of
   use adfric_periodic_pull_off_table, only: seek_on_grid
   use adfric_periodic_solver, only: contact_not_converged, contact_out_of_range, contact_solved, new_periodic_solver, &
      & periodic_solution_t, periodic_solver_t
   implicit none (type, external)
   private
   public :: free_adhesion_solver_t, free_adhesion_t, new_free_adhesion_solver, solve_free_adhesion

   !> How often the cells beyond the body are laid deeper, and by which factor.
   integer, parameter :: most_depths = 12
   real(dp), parameter :: deeper = 4
   !> Depth of the cells beyond the body in ranges: a triangle between cells of the body and of none is in range in that part alone.
   real(dp), parameter :: ranges_beyond = 1000

   !> A grid of the error estimate.
   type :: doubled_grid_t
      !> Solver of the doubled map.
      type(periodic_solver_t), allocatable :: solver
      !> Number of cells of the map.
      integer :: n_cells(2) = 0
      !> Sizes of a cell.
      real(dp) :: cell_size(2) = 0
   end type doubled_grid_t

   !> Solvers of the finest grid, the last one, and of those that tell its errors. Not to be copied; one for each thread.
   type :: free_adhesion_solver_t
      !> The grids, the coarsest first.
      type(doubled_grid_t), allocatable :: grids(:)
      !> Lengths of the map along x and y.
      real(dp) :: lengths(2) = 0
      !> Does the surface go on periodically along x, along y?
      logical :: is_periodic(2) = .false.
   contains
      procedure :: set_watch
   end type free_adhesion_solver_t

   !> What adhesion adds to a solution.
   type :: free_adhesion_t
      !> Area within the range of Dugdale's law and not in contact, as a share of the map; of no meaning by another law.
      real(dp) :: area = 0
      !> Energy of adhesion, 0 far apart [E* times the cube of the unit of length].
      real(dp) :: energy = 0
      !> Least load of the adhered branch [E* times the square of the unit of length], where it was sought and found; else the
      !> largest number.
      real(dp) :: pull_off = huge(1.0_dp)
      !> Its relative error; 1 where half the cells have none.
      real(dp) :: pull_off_error = 1
      !> Has the contact an edge of adhesion on the cells?
      logical :: has_edge = .false.
      !> Is there no state with contact under the load?
      logical :: is_out_of_range = .false.
   end type free_adhesion_t

   !> What a grid has found on the map.
   type :: free_found_t
      !> Pressure, gap and share in range of the cells of the map.
      real(dp), allocatable :: pressure(:, :), gap(:, :), share(:, :)
      !> Is the cell in contact?
      logical, allocatable :: is_contact(:, :)
      !> Load, and approach.
      real(dp) :: load = 0, approach = 0
      !> Was the load given?
      logical :: has_load = .false.
      !> Energy of adhesion, and largest violation of the conditions of contact.
      real(dp) :: adhesion_energy = 0, residual = 0
      !> Iterations of the grid.
      integer :: n_iterations = 0
      !> One of `contact_...`.
      integer :: status = contact_not_converged
   end type free_found_t

contains

   !> Make the solvers of the grids.
   subroutine new_free_adhesion_solver(self, n_cells, lengths, is_periodic, error)
      !> Receives the solvers; of no use after an error.
      type(free_adhesion_solver_t), intent(out) :: self
      !> Number of cells along x and y.
      integer, intent(in) :: n_cells(2)
      !> Lengths of the map along x and y, in any unit, > 0.
      real(dp), intent(in) :: lengths(2)
      !> Does the surface go on periodically along x, along y? Not along both.
      logical, intent(in) :: is_periodic(2)
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      type(free_kernel_t) :: kernel
      integer :: k, n, n_doubled(2)

      self%lengths = lengths
      self%is_periodic = is_periodic
      n = min(n_grids_of(n_cells), grids_for_error)
      allocate (self%grids(n))
      do k = 1, n
         associate (grid => self%grids(k))
            grid%n_cells = n_cells/2**(n - k)
            grid%cell_size = lengths/grid%n_cells
            n_doubled = grid%n_cells*merge(1, 2, is_periodic)
            call new_free_kernel(kernel, grid%n_cells, lengths, is_periodic, n_grids_of(n_doubled), error)
            if (allocated(error)) return
            allocate (grid%solver)
            call new_periodic_solver(grid%solver, kernel, n_doubled, lengths*merge(1, 2, is_periodic), .false., error)
            if (allocated(error)) return
         end associate
      end do
   end subroutine new_free_adhesion_solver

   !> Say whom iterations ask whether they shall end.
   subroutine set_watch(self, watch)
      class(free_adhesion_solver_t), intent(inout) :: self
      !> Null: nobody.
      class(watch_t), pointer, intent(in) :: watch
      integer :: k, l

      do k = 1, size(self%grids)
         do l = 1, size(self%grids(k)%solver%grids)
            self%grids(k)%solver%grids(l)%operator%watch => watch
         end do
      end do
   end subroutine set_watch

   !> Solve a contact under a given load, or at a given approach.
   subroutine solve_free_adhesion(self, shape, is_body, has_load, prescribed, law, tolerance, wants_pull_off, pull_offs, &
      & solution, adhesion, error)
      type(free_adhesion_solver_t), intent(inout) :: self
      !> Gap of the undeformed surfaces on the finest grid, 0 at first touch; of no meaning beside the body.
      real(dp), intent(in) :: shape(:, :)
      !> Is the cell one of the body? Same shape.
      logical, intent(in) :: is_body(:, :)
      !> Is the load given, and not the approach?
      logical, intent(in) :: has_load
      !> Load [E* times the square of the unit of length], or approach.
      real(dp), intent(in) :: prescribed
      type(free_law_t), intent(in) :: law
      !> Largest residual on the finest grid [-].
      real(dp), intent(in) :: tolerance
      !> Shall the pull-off be found?
      logical, intent(in) :: wants_pull_off
      !> Pull-offs that the points of a run share; null: none.
      type(found_once_t), pointer, intent(in) :: pull_offs
      !> Receives the contact.
      type(free_solution_t), intent(inout) :: solution
      !> Receives what adhesion adds.
      type(free_adhesion_t), intent(out) :: adhesion
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      type(free_field_t) :: fields(size(self%grids))
      type(free_found_t) :: found(size(self%grids))
      integer :: k, n

      n = size(self%grids)
      solution = free_solution_t()
      call set_fields(fields, shape, is_body)
      do k = n, 1, -1
         call solve_grid(self, self%grids(k), fields(k), has_load, prescribed, law, tolerance, found(k), error)
         if (allocated(error)) return
         if (found(n)%status /= contact_solved) exit
      end do
      adhesion%is_out_of_range = found(n)%status == contact_out_of_range
      if (found(n)%status /= contact_solved) return
      call set_solution(self, found, fields(n), solution, adhesion)
      if (wants_pull_off) call seek_pull_off(self, fields, law, tolerance, pull_offs, adhesion, error)
   end subroutine solve_free_adhesion

   !> Solve on one grid, with cells beyond the body that lie deep enough.
   subroutine solve_grid(self, grid, field, has_load, prescribed, law, tolerance, found, error)
      type(free_adhesion_solver_t), intent(in) :: self
      type(doubled_grid_t), intent(inout) :: grid
      !> Gap of the undeformed surfaces, and the body.
      type(free_field_t), intent(in) :: field
      logical, intent(in) :: has_load
      !> Load, or approach.
      real(dp), intent(in) :: prescribed
      type(free_law_t), intent(in) :: law
      real(dp), intent(in) :: tolerance
      !> Receives what was found.
      type(free_found_t), intent(out) :: found
      type(error_t), allocatable, intent(out) :: error
      type(periodic_solution_t) :: solution
      type(free_law_t) :: mean_law
      real(dp), allocatable :: doubled(:, :)
      real(dp) :: area, depth, clear
      logical, allocatable :: is_beyond(:, :)
      integer :: k

      area = product(self%lengths*merge(1, 2, self%is_periodic))
      depth = depth_beyond(self, field, law%dugdale, has_load, prescribed)
      ! a triangle between cells of the body and of none is in range in part; other laws do not act there at all
      clear = merge(0.0_dp, law%dugdale%range, allocated(law%attraction))
      do k = 1, most_depths
         call double_map(self, field, depth, doubled, is_beyond)
         mean_law = law%on_cells(area, .not. is_beyond)
         if (allocated(law%attraction) .and. has_load) then
            call solve_attracted_load(grid%solver, doubled, prescribed/area, mean_law%attraction, tolerance, solution, error)
         else if (allocated(law%attraction)) then
            call solve_attracted_layer(grid%solver, doubled, prescribed, mean_law%attraction, tolerance, solution, error)
         else if (has_load) then
            call solve_adhesive_load(grid%solver, doubled, prescribed/area, mean_law%dugdale, tolerance, solution, error)
         else
            call solve_adhesive_layer(grid%solver, doubled, prescribed, mean_law%dugdale, tolerance, solution, error)
         end if
         if (allocated(error)) return
         found%status = solution%status
         if (solution%status /= contact_solved) return
         if (.not. any(is_beyond .and. .not. solution%gap > clear)) exit
         found%status = contact_not_converged
         depth = deeper*depth
      end do
      if (found%status /= contact_solved) return
      associate (n => grid%n_cells)
         allocate (found%pressure, source=solution%pressure(:n(1), :n(2)))
         allocate (found%gap, source=solution%gap(:n(1), :n(2)))
         if (allocated(law%attraction)) then
            allocate (found%share, source=solution%share(:n(1), :n(2)))
         else
            allocate (found%share, source=solution%weighted_share(:n(1), :n(2)))
         end if
         allocate (found%is_contact, source=field%is_body .and. .not. found%gap > 0)
      end associate
      found%has_load = has_load
      found%load = solution%mean_pressure*area
      if (has_load) found%load = prescribed
      found%approach = solution%penetration
      if (.not. has_load) found%approach = prescribed
      found%adhesion_energy = solution%adhesion_energy*area
      found%residual = solution%residual
      found%n_iterations = solution%n_iterations
   end subroutine solve_grid

   !> The gap of the undeformed surfaces on the doubled map.
   subroutine double_map(self, field, depth, doubled, is_beyond)
      type(free_adhesion_solver_t), intent(in) :: self
      type(free_field_t), intent(in) :: field
      !> Depth of the cells beyond the body.
      real(dp), intent(in) :: depth
      !> Receives the gap.
      real(dp), allocatable, intent(out) :: doubled(:, :)
      !> Receives which cells are not those of the body.
      logical, allocatable, intent(out) :: is_beyond(:, :)
      integer :: n(2), n_doubled(2)

      n = shape(field%shape)
      n_doubled = n*merge(1, 2, self%is_periodic)
      allocate (doubled(n_doubled(1), n_doubled(2)), source=depth)
      allocate (is_beyond(n_doubled(1), n_doubled(2)), source=.true.)
      is_beyond(:n(1), :n(2)) = .not. field%is_body
      where (field%is_body) doubled(:n(1), :n(2)) = field%shape
   end subroutine double_map

   !> Collect what the grids have found.
   subroutine set_solution(self, found, field, solution, adhesion)
      type(free_adhesion_solver_t), intent(in) :: self
      !> Contacts on all grids, the finest last.
      type(free_found_t), intent(in) :: found(:)
      !> Gap of the undeformed surfaces on the finest grid, and the body.
      type(free_field_t), intent(in) :: field
      type(free_solution_t), intent(inout) :: solution
      type(free_adhesion_t), intent(inout) :: adhesion
      type(area_t) :: areas(size(found))
      real(dp), allocatable :: gap(:, :)
      integer :: k, n

      n = size(found)
      do k = 1, n
         if (found(k)%status == contact_solved) areas(k) = area_of_cells(found(k)%is_contact, .false., self%is_periodic)
      end do
      if (n == grids_for_error .and. all(found%status == contact_solved)) then
         call refine_area(areas(n), areas(n - 1), areas(n - 2), .false.)
         solution%load_error = change_error(found%load)
         solution%approach_error = change_error(found%approach)
      end if
      associate (finest => found(n), is_body => field%is_body, cell => product(self%grids(n)%cell_size))
         solution%area = areas(n)
         solution%area%error = max(solution%area%error, scatter_of_runs(finest%is_contact))
         solution%is_converged = .true.
         solution%residual = finest%residual
         solution%n_iterations = finest%n_iterations
         solution%approach = finest%approach
         solution%load = finest%load
         solution%pressure = finest%pressure
         solution%gap = merge(finest%gap, 0.0_dp, is_body)
         allocate (gap, source=merge(finest%gap, beside_body, is_body))
         solution%smooth_area = chord_fraction(solution%pressure, gap, self%grids(n)%cell_size, .false., self%is_periodic)
         ! the displacement is what the gap has more than that of the undeformed surfaces, with the approach
         solution%elastic_energy = sum(finest%pressure*(finest%gap - field%shape + finest%approach), mask=is_body)*cell/2
         adhesion%energy = finest%adhesion_energy
         adhesion%area = max(sum(finest%share)/size(finest%share) - solution%area%corrected, 0.0_dp)
         adhesion%has_edge = any(finest%share > 0 .and. is_body) .and. any(finest%share < 1 .and. is_body)
      end associate
      ! nothing but what the tolerance leaves acts between bodies that are apart
      if (.not. any(is_apart(found(n:)))) return
      solution%pressure(:, :) = 0
      solution%load = 0
      solution%elastic_energy = 0
      solution%residual = 0
      solution%gap(:, :) = merge(field%shape - solution%approach, 0.0_dp, field%is_body)
      if (.not. all(is_apart(found))) return
      solution%load_error = 0
      solution%approach_error = 0
      solution%area%error = 0
   end subroutine set_solution

   !> Are the bodies neither in contact nor in range of each other? Only at a given approach.
   elemental logical function is_apart(found)
      type(free_found_t), intent(in) :: found

      is_apart = .false.
      if (found%status /= contact_solved) return
      is_apart = .not. (any(found%is_contact) .or. any(found%share > 0) .or. found%has_load)
   end function is_apart

   !> Find the least load of the adhered branch, and its error from the grid of half the cells.
   subroutine seek_pull_off(self, fields, law, tolerance, pull_offs, adhesion, error)
      type(free_adhesion_solver_t), intent(inout) :: self
      !> Gap of the undeformed surfaces, and the body, on all grids.
      type(free_field_t), intent(in) :: fields(:)
      type(free_law_t), intent(in) :: law
      real(dp), intent(in) :: tolerance
      type(found_once_t), pointer, intent(in) :: pull_offs
      !> Receives the load and its error; keeps their values where none was found.
      type(free_adhesion_t), intent(inout) :: adhesion
      type(error_t), allocatable, intent(out) :: error
      type(periodic_pull_off_t) :: found(2)
      type(free_law_t) :: mean_law
      real(dp), allocatable :: doubled(:, :)
      real(dp) :: area
      logical, allocatable :: is_beyond(:, :)
      integer :: k, n

      n = size(self%grids)
      area = product(self%lengths*merge(1, 2, self%is_periodic))
      do k = n, max(n - 1, 1), -1
         associate (pull_off => found(n - k + 1))
            call double_map(self, fields(k), depth_beyond(self, fields(k), law%dugdale, .true., 0.0_dp), doubled, is_beyond)
            mean_law = law%on_cells(area, .not. is_beyond)
            call seek_on_grid(pull_offs, self%grids(k)%solver, doubled, [self%lengths, merge(1.0_dp, 0.0_dp, self%is_periodic)], &
               & tolerance, mean_law%dugdale, mean_law%attraction, pull_off, error)
            if (allocated(error)) return
            if (.not. pull_off%is_found) return
            if (k == n) adhesion%pull_off = pull_off%mean_pressure*area
            if (k < n) adhesion%pull_off_error = found(1)%error_beside(pull_off)
         end associate
      end do
   end subroutine seek_pull_off

   !> A depth of the cells beyond the body at which they should not come near the surface.
   pure real(dp) function depth_beyond(self, field, law, has_load, prescribed) result(depth)
      type(free_adhesion_solver_t), intent(in) :: self
      !> Gap of the undeformed surfaces, and the body.
      type(free_field_t), intent(in) :: field
      !> Dugdale's law, of the same stress and range.
      type(periodic_adhesion_t), intent(in) :: law
      logical, intent(in) :: has_load
      !> Load, or approach.
      real(dp), intent(in) :: prescribed

      depth = max(maxval(field%shape, mask=field%is_body), 0.0_dp) + ranges_beyond*law%range + 2*law%stress*maxval(self%lengths)
      ! a force on a body makes displacements of about its mean pressure times its length
      if (has_load) depth = depth + 2*max(prescribed, law%turning_pressure, 0.0_dp)/minval(self%lengths)
      if (.not. has_load) depth = depth + 2*max(prescribed, 0.0_dp)
   end function depth_beyond

end module adfric_periodic_free_adhesion
