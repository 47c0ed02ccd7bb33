! SPDX-License-Identifier: GPL-3.0-or-later
!> Partial slip of a periodic surface on an elastic half-space, from two contacts without friction, of the load P and of P* = P - T/mu
!> (`adfric_interface_coulomb_rows`). The second is found from the first by what changes (`adfric_periodic_lighter_load`), so that results
!> are as accurate for small forces as for large ones. What touches under P* sticks, elsewhere the surfaces slip by mu m times the gap
!> under P*. So a cycle between T and -T takes, over nominal area,
!>
!> $$ W = 4 \mu^2 m\, \overline{p(P)\, g(P^*)}, $$
!> a sum without a term below 0. In three dimensions m is the mean of all directions; with Poisson's ratio above 0 the displacement
!> that q makes then differs from one position of the sticking contact to the other, and `poisson_defect` tells by how much: the
!> force at this displacement is wrong by about its square (`tests/reference/slip_rough.csv`, where the true direction of slip was
!> solved for).
module adfric_periodic_slip
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_interface_coulomb_rows, only: coulomb_t
   use adfric_periodic_area, only: area_of_cells, area_t
   use adfric_periodic_lighter_load, only: find_lighter_load, lighter_load_t
   use adfric_periodic_maps, only: dot_of, sum_of
   use adfric_periodic_operator, only: periodic_operator_t
   use adfric_periodic_punch, only: find_punch_compliance
   use adfric_periodic_solver, only: contact_not_converged, contact_out_of_range, contact_solved, &
      & periodic_solution_t, periodic_solver_t
   implicit none (type, external)
   private
   public :: periodic_slip_t, solve_slip

   !> Largest 1 - P*/P with which the contact of P* is found from that of P: beyond it takes fewer transforms from nothing
   !> (`bench/run partial_slip`).
   real(dp), parameter :: most_relief = 0.75_dp
   !> Least pressure under P* over that under P: the error of the contact of P is a hundred times as large beside it.
   real(dp), parameter :: least_peak = 0.01_dp

   !> Slip of a surface.
   type :: periodic_slip_t
      !> Shear traction in the cells [E*]; shape of the cells.
      real(dp), allocatable :: traction(:, :)
      !> Area that sticks; its error is not estimated.
      type(area_t) :: stick
      !> Tangential displacement, in the unit of the gap, with the sign of the force.
      real(dp) :: displacement = 0
      !> Slope of the displacement over the force while it grows [unit of the gap over E*]; 0 where all sticks in full contact, and below 0
      !> where what sticks is a point.
      real(dp) :: compliance = 0
      !> Energy of a cycle between T and -T over nominal area [E* times the unit of the gap].
      real(dp) :: cycle_energy = 0
      !> Standard deviation, over what sticks, of the displacement along the force that the traction makes, over the displacement [-];
      !> below 0 where nothing sticks, or there is no displacement.
      real(dp) :: poisson_defect = -1
   end type periodic_slip_t

contains

   !> Find the slip of a solved contact. Without contact there is none.
   subroutine solve_slip(solver, shape, friction, tolerance, solution, slip, error)
      type(periodic_solver_t), intent(inout) :: solver
      !> Gap of the undeformed surfaces in the middles of the cells; 0 at first touch, and no less.
      real(dp), intent(in) :: shape(:, :)
      type(coulomb_t), intent(in) :: friction
      real(dp), intent(in) :: tolerance
      !> In: the contact, solved. Out: the worse of the states of both contacts, and the steps and transforms of all; out of range where
      !> friction does not hold the force.
      type(periodic_solution_t), intent(inout) :: solution
      !> Receives the slip, in the units of `solution`; not allocated where there is none.
      type(periodic_slip_t), allocatable, intent(out) :: slip
      type(error_t), allocatable, intent(out) :: error
      type(lighter_load_t) :: stick
      real(dp) :: tau
      integer :: n, n_before
      logical :: is_sustained

      if (solution%status /= contact_solved) return
      call friction%get_share(solution%mean_pressure, tau, is_sustained)
      if (.not. is_sustained) solution%status = contact_out_of_range
      if (.not. (is_sustained .and. solution%mean_pressure > 0)) return
      n = size(solver%grids)
      n_before = solver%grids(n)%operator%n_applied
      if (tau > 0 .and. tau <= most_relief) call find_lighter_load(stick, solver%grids(n)%operator, solver%grids(n)%gap_solver, &
         & solution%pressure, solution%gap, tau*solution%mean_pressure, tolerance)
      solution%n_iterations = solution%n_iterations + stick%n_iterations
      solution%n_pairs = solution%n_pairs + (solver%grids(n)%operator%n_applied - n_before)
      if (.not. is_certain(stick, solution%pressure)) then
         call compare_contacts(solver, shape, tau, tolerance, solution, stick, error)
         if (allocated(error)) return
      end if
      solution%status = merge(contact_solved, contact_not_converged, stick%is_converged)
      if (solution%status /= contact_solved) return
      allocate (slip)
      n_before = solver%grids(n)%operator%n_applied
      call set_slip(solver%grids(n)%operator, friction, solution%pressure, stick, slip)
      solution%n_pairs = solution%n_pairs + (solver%grids(n)%operator%n_applied - n_before)
   end subroutine solve_slip

   !> Is what sticks found, and is the error of the contact small beside the pressure there?
   pure logical function is_certain(stick, pressure)
      !> What the lighter load changes, if it was sought.
      type(lighter_load_t), intent(in) :: stick
      !> Pressure of the contact [E*].
      real(dp), intent(in) :: pressure(:, :)

      is_certain = stick%is_converged
      if (is_certain) is_certain = maxval(pressure - stick%fall) >= least_peak*maxval(pressure)
   end function is_certain

   !> Find what the lighter load changes from two contacts, each from nothing: where hardly any load is left, or none was taken.
   subroutine compare_contacts(solver, shape, tau, tolerance, solution, stick, error)
      type(periodic_solver_t), intent(inout) :: solver
      !> Gap of the undeformed surfaces in the middles of the cells; 0 at first touch, and no less.
      real(dp), intent(in) :: shape(:, :)
      !> 1 - P*/P [-].
      real(dp), intent(in) :: tau
      real(dp), intent(in) :: tolerance
      !> In: the contact of P. Out: with the steps and transforms of that of P*.
      type(periodic_solution_t), intent(inout) :: solution
      type(lighter_load_t), intent(out) :: stick
      type(error_t), allocatable, intent(out) :: error
      type(periodic_solution_t) :: lighter
      integer :: n_before

      lighter = solution
      if (tau > 0) then
         call solver%solve_load(shape, solution%mean_pressure*(1 - tau), tolerance, lighter, error)
         if (allocated(error)) return
         solution%n_iterations = solution%n_iterations + lighter%n_iterations
         solution%n_pairs = solution%n_pairs + lighter%n_pairs
      end if
      stick%is_converged = lighter%status == contact_solved
      if (.not. stick%is_converged) return
      stick%rise = lighter%gap - solution%gap
      stick%fall = solution%pressure - lighter%pressure
      stick%is_open = .not. lighter%pressure > 0
      associate (grid => solver%grids(size(solver%grids)))
         n_before = grid%operator%n_applied
         call find_punch_compliance(grid%operator, grid%gap_solver, stick%is_open, tolerance, stick%compliance, &
            & stick%is_converged)
         solution%n_pairs = solution%n_pairs + (grid%operator%n_applied - n_before)
      end associate
   end subroutine compare_contacts

   !> From what the lighter load changes to the slip.
   subroutine set_slip(operator, friction, pressure, stick, slip)
      type(periodic_operator_t), intent(inout) :: operator
      type(coulomb_t), intent(in) :: friction
      !> Pressure under P [E*].
      real(dp), intent(in), contiguous :: pressure(:, :)
      type(lighter_load_t), intent(in) :: stick
      type(periodic_slip_t), intent(inout) :: slip
      logical :: is_line
      real(dp) :: sliding

      is_line = size(pressure, 2) == 1
      sliding = sign(friction%coefficient, friction%stress)
      slip%traction = sliding*stick%fall
      slip%stick = area_of_cells(.not. stick%is_open, operator%is_quarter)
      associate (ratio => friction%compliance_ratio(is_line))
         slip%displacement = sliding*ratio*(sum_of(stick%rise)/size(pressure))
         slip%cycle_energy = 4*sliding**2*ratio*(dot_of(pressure, stick%rise)/size(pressure))
         slip%compliance = ratio*stick%compliance
      end associate
      if (.not. (abs(slip%displacement) > 0) .or. all(stick%is_open)) return
      slip%poisson_defect = 0
      if (.not. is_line .and. abs(friction%poisson) > 0) call find_defect(operator, friction, .not. stick%is_open, slip)
   end subroutine set_slip

   !> Find how much the displacement along the force differs among the cells that stick.
   subroutine find_defect(operator, friction, sticks, slip)
      type(periodic_operator_t), intent(inout) :: operator
      type(coulomb_t), intent(in) :: friction
      logical, intent(in) :: sticks(:, :)
      !> In: with traction and displacement. Out: with the defect.
      type(periodic_slip_t), intent(inout) :: slip
      real(dp), allocatable :: difference(:, :)
      real(dp) :: mean
      integer :: n

      allocate (difference, mold=slip%traction)
      call operator%apply_anisotropy(friction%axis, slip%traction, difference)
      n = count(sticks)
      mean = sum(difference, mask=sticks)/n
      difference(:, :) = difference - mean
      slip%poisson_defect = abs(friction%poisson)*sqrt(sum(difference**2, mask=sticks)/n)/abs(slip%displacement)
   end subroutine find_defect

end module adfric_periodic_slip
