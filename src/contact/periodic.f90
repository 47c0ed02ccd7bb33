! SPDX-License-Identifier: GPL-3.0-or-later
!> Contact of a periodic rough surface with an elastic half-space, without friction and adhesion, with plain arrays.
!>
!> Heights, gaps, periods and penetrations are in any one unit of length; pressures are in units of the contact modulus E*. A map
!> has the shape `(nx, ny)`, ny = 1 for a surface that does not vary along y; its values stand in the middles of the cells.
!> Numbers of cells with many factors of 2 are solved fastest. Nothing is kept between calls, and many threads may call at once.
!>
!> Status: `status_solved` (0), `status_no_equilibrium` (1: a penetration that no pressure reaches, or a negative pressure),
!> `status_not_converged` (2), `status_out_of_memory` (-1), `status_bad_argument` (-2). All other results are NaN where the status
!> is not `status_solved`.
module adfric_contact_periodic
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_contact_arguments, only: largest_ratio, lies_between, status_bad_argument
   use adfric_describe_status, only: status_no_equilibrium, status_not_converged, status_out_of_memory, status_solved
   use adfric_periodic_operator, only: is_too_long
   use adfric_periodic_point, only: periodic_goal_t, periodic_memory_t, periodic_surface_t, solve_periodic
   use adfric_periodic_slip, only: periodic_slip_t
   use adfric_periodic_solver, only: contact_out_of_range, contact_solved, periodic_solution_t
   implicit none (type, external)
   private
   public :: solve_periodic_pressure, solve_periodic_penetration
   public :: dp, status_solved, status_no_equilibrium, status_not_converged, status_out_of_memory, status_bad_argument

   !> Fewest cells along a direction that varies.
   integer, parameter :: fewest_cells = 4
   !> Least tolerance that round-off lets a solution meet, and the largest one that is of use.
   real(dp), parameter :: least_tolerance = 1.0e-13_dp, largest_tolerance = 1.0e-3_dp

contains

   !> Find the contact under a mean pressure.
   subroutine solve_periodic_pressure(heights, period, mean_pressure, pressure, gap, penetration, contact_fraction, status, &
      & tolerance)
      !> Heights of the rough body, the largest of which touches first; shape `(nx, ny)`.
      real(dp), intent(in) :: heights(:, :)
      !> Periods in x and y, > 0; that in y is not used where ny is 1.
      real(dp), intent(in) :: period(2)
      !> Mean pressure [E*].
      real(dp), intent(in) :: mean_pressure
      !> Receives the pressure [E*]; shape of `heights`.
      real(dp), intent(out) :: pressure(:, :)
      !> Receives the gap between the surfaces; shape of `heights`.
      real(dp), intent(out) :: gap(:, :)
      !> Receives how far the surfaces approached from first touch, at the mean of the deformed surface.
      real(dp), intent(out) :: penetration
      !> Receives the share of the surface in contact, less the excess of the cells at the perimeter.
      real(dp), intent(out) :: contact_fraction
      !> Receives what has become of the contact, see above.
      integer, intent(out) :: status
      !> Largest violation of the conditions of contact [-], 1e-13 to 1e-3; 1e-10 if absent.
      real(dp), intent(in), optional :: tolerance
      real(dp) :: found

      call solve(heights, period, periodic_goal_t(.true., mean_pressure), pressure, gap, found, penetration, contact_fraction, &
         & status, tolerance)
   end subroutine solve_periodic_pressure

   !> Find the contact at a penetration.
   subroutine solve_periodic_penetration(heights, period, penetration, pressure, gap, mean_pressure, contact_fraction, status, &
      & tolerance)
      !> Heights of the rough body, the largest of which touches first; shape `(nx, ny)`.
      real(dp), intent(in) :: heights(:, :)
      !> Periods in x and y, > 0; that in y is not used where ny is 1.
      real(dp), intent(in) :: period(2)
      !> How far the surfaces approach from first touch, at the mean of the deformed surface.
      real(dp), intent(in) :: penetration
      !> Receives the pressure [E*]; shape of `heights`.
      real(dp), intent(out) :: pressure(:, :)
      !> Receives the gap between the surfaces; shape of `heights`.
      real(dp), intent(out) :: gap(:, :)
      !> Receives the mean pressure [E*].
      real(dp), intent(out) :: mean_pressure
      !> Receives the share of the surface in contact, less the excess of the cells at the perimeter.
      real(dp), intent(out) :: contact_fraction
      !> Receives what has become of the contact, see above.
      integer, intent(out) :: status
      !> Largest violation of the conditions of contact [-], 1e-13 to 1e-3; 1e-10 if absent.
      real(dp), intent(in), optional :: tolerance
      real(dp) :: found

      call solve(heights, period, periodic_goal_t(.false., penetration), pressure, gap, mean_pressure, found, contact_fraction, &
         & status, tolerance)
   end subroutine solve_periodic_penetration

   !> Find the contact for what is prescribed.
   subroutine solve(heights, period, goal, pressure, gap, mean_pressure, penetration, contact_fraction, status, tolerance)
      real(dp), intent(in) :: heights(:, :), period(2)
      !> What is prescribed.
      type(periodic_goal_t), intent(in) :: goal
      real(dp), intent(out) :: pressure(:, :), gap(:, :), mean_pressure
      !> Receives the penetration.
      real(dp), intent(out) :: penetration
      real(dp), intent(out) :: contact_fraction
      integer, intent(out) :: status
      real(dp), intent(in), optional :: tolerance
      type(periodic_goal_t) :: wanted
      type(periodic_surface_t) :: surface
      type(periodic_memory_t) :: memory
      type(periodic_solution_t) :: solution
      type(periodic_slip_t), allocatable :: slip
      type(error_t), allocatable :: error

      pressure = not_a_number()
      gap = not_a_number()
      mean_pressure = not_a_number()
      penetration = not_a_number()
      contact_fraction = not_a_number()
      wanted = goal
      if (present(tolerance)) wanted%tolerance = tolerance
      status = status_bad_argument
      if (.not. are_good(heights, period, wanted, shape(pressure), shape(gap))) return
      surface%period = period
      if (size(heights, 2) == 1) surface%period(2) = period(1)
      surface%shape = maxval(heights) - heights
      call solve_periodic(surface, wanted, memory, solution, slip, error)
      status = status_out_of_memory
      if (allocated(error)) return
      status = status_not_converged
      if (solution%status == contact_out_of_range) status = status_no_equilibrium
      if (solution%status /= contact_solved) return
      status = status_solved
      pressure = solution%pressure
      gap = solution%gap
      mean_pressure = solution%mean_pressure
      penetration = solution%penetration
      contact_fraction = solution%area%corrected
   end subroutine solve

   !> May these arguments be solved?
   pure logical function are_good(heights, period, goal, shape_of_pressure, shape_of_gap)
      real(dp), intent(in) :: heights(:, :), period(2)
      !> What is prescribed, and the largest violation of the conditions of contact.
      type(periodic_goal_t), intent(in) :: goal
      !> Shape of the map of the pressure.
      integer, intent(in) :: shape_of_pressure(2)
      !> Shape of the map of the gap.
      integer, intent(in) :: shape_of_gap(2)
      logical :: is_line

      is_line = size(heights, 2) == 1
      are_good = all(shape_of_pressure == shape(heights)) .and. all(shape_of_gap == shape(heights)) &
         & .and. size(heights, 1) >= fewest_cells .and. (is_line .or. size(heights, 2) >= fewest_cells) &
         & .and. lies_between(period(1), 1/largest_ratio, largest_ratio) &
         & .and. (is_line .or. lies_between(period(2), 1/largest_ratio, largest_ratio)) &
         & .and. lies_between(goal%value, -largest_ratio, largest_ratio) &
         & .and. lies_between(goal%tolerance, least_tolerance, largest_tolerance)
      if (are_good) are_good = all(lies_between(heights, -largest_ratio, largest_ratio))
      if (are_good) are_good = maxval(heights) > minval(heights)
      if (are_good .and. .not. is_line) are_good = .not. is_too_long(shape(heights), period)
   end function are_good

end module adfric_contact_periodic
