! SPDX-License-Identifier: GPL-3.0-or-later
!> Partial slip of a periodic surface on an elastic half-space, from two contacts without friction, of the load P and of P* = P - T/mu
!> (`adfric_material_coulomb_rows`). What touches under P* sticks, elsewhere the surfaces slip by mu m times the gap under P*. So a
!> cycle between T and -T takes, over nominal area,
!>
!> $$ W = 4 \mu^2 m\, \overline{p(P)\, g(P^*)}, $$
!> a sum without a term below 0. In three dimensions m is the mean of all directions; with Poisson's ratio above 0 the displacement
!> that q makes then differs from one place of the sticking contact to the other, and `poisson_defect` tells by how much: the force at
!> this displacement is wrong by about its square (`tests/reference/slip_rough.csv`, where the true direction of slip was solved for).
module adfric_periodic_slip
   use adfric_base_kinds, only: dp
   use adfric_base_error, only: error_t
   use adfric_material_coulomb_rows, only: coulomb_t
   use adfric_periodic_area, only: area_t
   use adfric_periodic_cohesion, only: cohesion_t
   use adfric_periodic_gap_solver, only: extremes_t, gap_solver_t
   use adfric_periodic_maps, only: dot_of, sum_of
   use adfric_periodic_operator, only: periodic_operator_t
   use adfric_periodic_solver, only: contact_not_converged, contact_out_of_range, contact_solved, &
      & periodic_solution_t, periodic_solver_t
   implicit none (type, external)
   private
   public :: periodic_slip_t, solve_slip

   !> Slip of a surface.
   type :: periodic_slip_t
      !> Shear traction in the cells [E*]; shape of the cells.
      real(dp), allocatable :: traction(:, :)
      !> Area that sticks, with the bound of its error.
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
      !> Solver of the surface.
      type(periodic_solver_t), intent(inout) :: solver
      !> Gap of the undeformed surfaces in the middles of the cells; 0 at first touch, and no less.
      real(dp), intent(in) :: shape(:, :)
      !> Friction and force, with the stress in E*.
      type(coulomb_t), intent(in) :: friction
      !> Largest residual that is allowed [-].
      real(dp), intent(in) :: tolerance
      !> In: the contact, solved. Out: the worse of the states of both contacts, and the steps of both; out of range where friction
      !> does not hold the force.
      type(periodic_solution_t), intent(inout) :: solution
      !> Receives the slip, in the units of `solution`; not allocated where there is none.
      type(periodic_slip_t), allocatable, intent(out) :: slip
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      type(periodic_solution_t) :: stick
      real(dp) :: tau
      logical :: is_held, is_found

      if (solution%status /= contact_solved) return
      call friction%get_share(solution%mean_pressure, tau, is_held)
      if (.not. is_held) solution%status = contact_out_of_range
      if (.not. (is_held .and. solution%mean_pressure > 0)) return
      call solver%solve_load(shape, solution%mean_pressure*(1 - tau), tolerance, stick, error)
      if (allocated(error)) return
      solution%n_iterations = solution%n_iterations + stick%n_iterations
      solution%n_pairs = solution%n_pairs + stick%n_pairs
      solution%status = stick%status
      if (solution%status /= contact_solved) return
      allocate (slip)
      associate (grid => solver%grids(size(solver%grids)))
         call compare(grid%operator, friction, solution, stick, slip)
         call find_compliance(grid%operator, grid%gap_solver, stick%pressure > 0, slip%compliance, is_found)
      end associate
      slip%compliance = friction%compliance_ratio(size(shape, 2) == 1)*slip%compliance
      if (.not. is_found) solution%status = contact_not_converged
   end subroutine solve_slip

   !> From the two contacts to the slip.
   subroutine compare(operator, friction, whole, stick, slip)
      !> Operator of the finest grid.
      type(periodic_operator_t), intent(inout) :: operator
      !> Friction and force.
      type(coulomb_t), intent(in) :: friction
      !> The contacts of P and of P*.
      type(periodic_solution_t), intent(in) :: whole, stick
      !> Receives the slip.
      type(periodic_slip_t), intent(inout) :: slip
      logical :: is_line
      real(dp) :: sliding

      is_line = size(whole%gap, 2) == 1
      sliding = sign(friction%coefficient, friction%stress)
      allocate (slip%traction, source=whole%pressure)
      slip%traction(:, :) = sliding*(whole%pressure - stick%pressure)
      slip%stick = stick%area
      associate (ratio => friction%compliance_ratio(is_line))
         slip%displacement = sliding*ratio*(whole%penetration - stick%penetration)
         slip%cycle_energy = 4*sliding**2*ratio*(dot_of(whole%pressure, stick%gap)/size(stick%gap))
      end associate
      if (.not. (abs(slip%displacement) > 0 .and. any(stick%pressure > 0))) return
      slip%poisson_defect = 0
      if (.not. is_line .and. abs(friction%poisson) > 0) &
         & call find_defect(operator, friction, stick%pressure, slip)
   end subroutine compare

   !> Find how much the surfaces approach under more load, over that load, where the area of contact stays as it is: where it is open the
   !> pressure stays 0. The error of this mean goes with the square of the residual.
   subroutine find_compliance(operator, gap_solver, is_contact, compliance, is_found)
      !> Operator of the finest grid.
      type(periodic_operator_t), intent(inout) :: operator
      !> Workspace for its cells.
      type(gap_solver_t), intent(inout) :: gap_solver
      !> Is the cell in contact? Shape of the cells.
      logical, intent(in) :: is_contact(:, :)
      !> Receives the compliance; 0 in full contact, below 0 without contact.
      real(dp), intent(out) :: compliance
      !> Was it found?
      logical, intent(out) :: is_found
      real(dp), parameter :: small = 1.0e-6_dp
      integer, parameter :: most_steps = 1000
      type(extremes_t) :: extremes
      type(cohesion_t), allocatable :: none
      real(dp), allocatable :: opening(:, :), pressure(:, :)
      logical, allocatable :: is_open(:, :)
      real(dp) :: mean_pressure
      logical :: is_stuck
      integer :: k

      compliance = 0
      if (.not. any(is_contact)) compliance = -1
      is_found = all(is_contact) .or. .not. any(is_contact)
      if (is_found) return
      allocate (is_open, source=.not. is_contact)
      allocate (opening(size(is_contact, 1), size(is_contact, 2)))
      allocate (pressure, mold=opening)
      opening(:, :) = 0
      ! a load of -1, for gaps that open
      pressure(:, :) = -1
      mean_pressure = -1
      call gap_solver%forget()
      call gap_solver%set_region(operator, is_open, .false., .false., .false.)
      do k = 1, most_steps
         call gap_solver%improve(operator, is_open, 0.0_dp, opening, pressure, mean_pressure, extremes, is_stuck, none)
         is_found = extremes%left <= small
         if (is_found .or. is_stuck) exit
      end do
      compliance = sum_of(opening)/size(opening)
   end subroutine find_compliance

   !> Find how much the displacement along the force differs among the cells that stick.
   subroutine find_defect(operator, friction, stick_pressure, slip)
      !> Operator of the finest grid.
      type(periodic_operator_t), intent(inout) :: operator
      !> Friction and force.
      type(coulomb_t), intent(in) :: friction
      !> Pressure under P*.
      real(dp), intent(in) :: stick_pressure(:, :)
      !> In: with traction and displacement. Out: with the defect.
      type(periodic_slip_t), intent(inout) :: slip
      real(dp), allocatable :: difference(:, :)
      real(dp) :: mean
      integer :: n

      allocate (difference, mold=slip%traction)
      call operator%apply_anisotropy(friction%axis, slip%traction, difference)
      n = count(stick_pressure > 0)
      mean = sum(difference, mask=stick_pressure > 0)/n
      difference(:, :) = difference - mean
      slip%poisson_defect = abs(friction%poisson)*sqrt(sum(difference**2, mask=stick_pressure > 0)/n)/abs(slip%displacement)
   end subroutine find_defect

end module adfric_periodic_slip
