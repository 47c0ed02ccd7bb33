! SPDX-License-Identifier: GPL-3.0-or-later
!> A point of the model `free_surface`: the solvers that points share, and what a solution gives for results and their errors.
module adfric_periodic_free_point
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_base_unset, only: is_set
   use adfric_base_watch, only: watch_t
   use adfric_describe_pointwise, only: point_state_t
   use adfric_interface_adhesion_rows, only: adhesion_law_t
   use adfric_interface_conduction_rows, only: conductances, n_conduction_results, n_conduction_rows
   use adfric_periodic_adhesion_cells, only: cells_per_zone, error_of_edge
   use adfric_periodic_area, only: relative_error_of
   use adfric_periodic_free_adhesion, only: free_adhesion_solver_t, free_adhesion_t, new_free_adhesion_solver
   use adfric_periodic_free_rows, only: in => free_input, out => free_output
   use adfric_periodic_free_solver, only: free_hinge_t, free_solution_t, free_solver_t, new_free_solver
   use adfric_periodic_free_punch, only: find_free_punch, free_punch_t
   use adfric_periodic_point, only: periodic_surface_t
   use adfric_periodic_variables, only: is_wanted
   implicit none (type, external)
   private
   public :: add_punch, error_of_adhesion, error_of_contact, free_point_state_t, prepare_solver, store, store_adhesion

   !> What a point leaves for the next one, and for its maps.
   type, extends(point_state_t) :: free_point_state_t
      !> Lengths and cells of the map, and the undeformed gap [m].
      type(periodic_surface_t) :: surface
      !> Boundaries that the solver is made for.
      logical :: is_periodic(2) = .false.
      !> Number of cells, and ratio of the lengths, of the solver.
      integer :: n_cells(2) = 0
      !> Length along y over that along x.
      real(dp) :: ratio = 0
      !> Solver with its transforms; not allocated before the first point.
      type(free_solver_t), allocatable :: solver
      !> That of bodies that adhere; not allocated before the first point with adhesion.
      type(free_adhesion_solver_t), allocatable :: adhesive_solver
      !> Solution, with lengths in `length_x` and pressures in E*.
      type(free_solution_t) :: solution
      !> What adhesion adds to it.
      type(free_adhesion_t) :: adhesion
   end type free_point_state_t

contains

   !> Make a solver, unless that of the point before serves.
   subroutine prepare_solver(state, watch, is_periodic, adheres, error)
      !> The surface of the point, and the solvers of the one before; receives those of this point.
      type(free_point_state_t), intent(inout) :: state
      !> Whom iterations ask whether they shall end; null: nobody.
      class(watch_t), pointer, intent(in) :: watch
      !> Does the surface go on periodically along x, along y?
      logical, intent(in) :: is_periodic(2)
      !> Does the body adhere?
      logical, intent(in) :: adheres
      type(error_t), allocatable, intent(out) :: error
      real(dp) :: ratio

      associate (surface => state%surface)
         ratio = surface%period(2)/surface%period(1)
         if (any(state%n_cells /= surface%n_cells) .or. any(state%is_periodic .neqv. is_periodic) &
            & .or. abs(state%ratio - ratio) > 0) then
            if (allocated(state%solver)) deallocate (state%solver)
            if (allocated(state%adhesive_solver)) deallocate (state%adhesive_solver)
         end if
         state%n_cells = surface%n_cells
         state%ratio = ratio
         state%is_periodic = is_periodic
         if (adheres .and. .not. allocated(state%adhesive_solver)) then
            allocate (state%adhesive_solver)
            call new_free_adhesion_solver(state%adhesive_solver, surface%n_cells, [1.0_dp, ratio], is_periodic, error)
            if (.not. allocated(error)) call state%adhesive_solver%set_watch(watch)
            if (allocated(error)) deallocate (state%adhesive_solver)
         else if (.not. (adheres .or. allocated(state%solver))) then
            allocate (state%solver)
            call new_free_solver(state%solver, surface%n_cells, [1.0_dp, ratio], is_periodic, watch, error)
            if (allocated(error)) deallocate (state%solver)
         end if
      end associate
   end subroutine prepare_solver

   !> Relative error that the edge of adhesion adds, and that of a pull-off; above 1 where the cells do not see the edge.
   pure real(dp) function error_of_adhesion(law, state) result(error)
      type(adhesion_law_t), intent(in) :: law
      type(free_point_state_t), intent(in) :: state

      error = 0
      if (state%adhesion%has_edge) error = error_of_edge(cells_per_zone(law, state%surface))
      if (state%adhesion%pull_off < huge(1.0_dp) .and. state%adhesion%pull_off < 0 .and. error <= 1) &
         & error = max(error, state%adhesion%pull_off_error)
   end function error_of_adhesion

   !> Relative error of area, and of load or approach, whichever is not given.
   pure real(dp) function error_of_contact(solution, has_load) result(error)
      type(free_solution_t), intent(in) :: solution
      logical, intent(in) :: has_load

      error = relative_error_of(solution%area)
      if (has_load) then
         error = max(error, ratio_of(solution%approach_error, solution%approach))
      else
         error = max(error, ratio_of(solution%load_error, solution%load))
      end if
   end function error_of_contact

   !> Error of a value relative to it, 1 at most; 0 without error.
   pure real(dp) function ratio_of(error, value)
      real(dp), intent(in) :: error, value

      ratio_of = 0
      if (error > 0) ratio_of = error/max(abs(value), error)
   end function ratio_of

   !> Set the results of a point.
   subroutine store(values, state, modulus, hinge, results)
      real(dp), intent(in) :: values(:)
      type(free_point_state_t), intent(in) :: state
      !> Contact modulus E* [Pa].
      real(dp), intent(in) :: modulus
      !> How the body may move.
      type(free_hinge_t), intent(in) :: hinge
      !> In: all NaN. Out: with what has a value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      real(dp) :: force, cell, map
      integer :: i

      associate (s => state%solution, unit => state%surface%period(1), lengths => state%surface%period, n => state%n_cells)
         map = product(lengths)
         force = modulus*unit*unit
         cell = force*(state%ratio/product(real(n, dp)))
         results(out%load) = s%load*force
         results(out%approach) = s%approach*unit
         ! what was given comes back to the last digit
         if (is_set(values(in%load))) results(out%load) = values(in%load)
         if (is_set(values(in%approach))) results(out%approach) = values(in%approach)
         results(out%contact_area) = s%area%corrected*map
         results(out%contact_area_error) = s%area%error*map
         results(out%smooth_area) = s%smooth_area*map
         if (s%area%corrected > 0) results(out%mean_contact_pressure) = results(out%load)/results(out%contact_area)
         results(out%peak_pressure) = maxval(s%pressure)*modulus
         results(out%elastic_energy) = s%elastic_energy*force*unit
         if (.not. state%is_periodic(2)) results(out%moment_x) = cell*lengths(2)*sum( &
            & [((i - 0.5_dp)/n(2) - 0.5_dp, i=1, n(2))]*sum(s%pressure, 1))
         if (.not. state%is_periodic(1)) results(out%moment_y) = -cell*lengths(1)*sum( &
            & [((i - 0.5_dp)/n(1) - 0.5_dp, i=1, n(1))]*sum(s%pressure, 2))
         results(out%violation) = s%residual
         if (hinge%may_tilt(1)) results(out%tilt_x) = s%tilt(1)
         if (hinge%may_tilt(2)) results(out%tilt_y) = s%tilt(2)
      end associate
   end subroutine store

   !> Find stiffness and conductances of the spots that touch.
   subroutine add_punch(values, is_body, adheres, watch, state, results, is_found, error)
      real(dp), intent(in) :: values(:)
      !> Is the cell one of the body?
      logical, intent(in) :: is_body(:, :)
      !> Does the body adhere?
      logical, intent(in) :: adheres
      !> Whom iterations ask whether they shall end; null: nobody.
      class(watch_t), pointer, intent(in) :: watch
      !> The solved point; receives a solver without adhesion.
      type(free_point_state_t), intent(inout) :: state
      !> In: with the other results. Out: with these; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Was the stiffness found?
      logical, intent(out) :: is_found
      !> Allocated if there is no memory.
      type(error_t), allocatable, intent(out) :: error
      logical, allocatable :: is_contact(:, :)
      type(free_punch_t) :: punch

      is_found = .false.
      call prepare_solver(state, watch, state%is_periodic, .false., error)
      if (allocated(error)) return
      allocate (is_contact(state%n_cells(1), state%n_cells(2)), source=.false.)
      if (adheres) then
         is_contact(:, :) = is_body .and. .not. state%solution%gap > 0
      else
         is_contact(:, :) = state%solution%pressure > 0
      end if
      associate (operator => state%solver%operators(size(state%solver%operators)), unit => state%surface%period(1))
         call find_free_punch(operator, is_contact, is_body, state%solution%area, values(in%tolerance), punch)
         is_found = punch%is_found
         if (.not. is_found) return
         if (is_wanted(values(in%stiffness))) results(out%contact_stiffness) = state%surface%solid%modulus*unit*punch%stiffness
         results(out%stiffness_error) = punch%error
         call conductances(values(in%conduction(1):in%conduction(n_conduction_rows)), unit*punch%stiffness, &
            & results(out%conductances(1):out%conductances(n_conduction_results)))
      end associate
   end subroutine add_punch

   !> Set the results that adhesion adds.
   subroutine store_adhesion(law, state, results)
      type(adhesion_law_t), intent(in) :: law
      type(free_point_state_t), intent(in) :: state
      !> In: with the other results. Out: with all; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)

      associate (adhesion => state%adhesion, unit => state%surface%period(1), modulus => state%surface%solid%modulus)
         if (.not. allocated(law%attraction)) results(out%adhesion_area) = adhesion%area*product(state%surface%period)
         results(out%adhesion_energy) = adhesion%energy*modulus*unit*unit*unit
         results(out%cells_per_zone) = cells_per_zone(law, state%surface)
         if (adhesion%pull_off < huge(1.0_dp)) results(out%pull_off_load) = adhesion%pull_off*modulus*unit*unit
      end associate
   end subroutine store_adhesion

end module adfric_periodic_free_point
