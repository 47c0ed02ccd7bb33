! SPDX-License-Identifier: GPL-3.0-or-later
!> Proof that no state of an adhesive surface lies between a gap that bounds the wanted one and a state that was found.
!>
!> Let g be the state, and g -+ x a gap beyond the bound, x >= 0. Where no share changes by more than s m_i between g and g -+ s x,
!> 0 < s <= 1, a round from there ends within s y of g, y = sigma0 A_OO^-1 m, over the open cells O of both ends. With y < x
!> wherever m > 0 that is nearer to g than it began, for every s: no state lies between, and rounds from its far end come to g.
!>
!> - The path is along w = (A - sigma0 dt/dg)_OO^-1 sigma0, which is how the solid yields to a load, so long that it passes the
!>   bound, and the distance to the bound where that is more. Near the state A w - sigma0 m = sigma0: w has a margin everywhere.
!> - m is the largest of secants. Shares change in one direction, so that between two parts of the path |t - t(g)|/s is not above the
!>   change at the farther part over the nearer s. Parts are closer in cells where that costs too much of the margin.
!> - On the last part, next to the state, slopes are those of the state itself.
!> - x - y = v is what A_OO v = A x - sigma0 m says. It is above 0 where the right side is so in all cells. Else a little is taken
!>   from that side, and v found to no more than that, so that it is not above the true one.
module adfric_periodic_adhesive_proof
   use adfric_base_kinds, only: dp
   use adfric_periodic_adhesive_secants, only: set_largest_slope, set_slope
   use adfric_periodic_cohesion, only: cohesion_t
   use adfric_periodic_contact, only: contact_state_t
   use adfric_periodic_gap_solver, only: gap_solver_t, extremes_t
   use adfric_periodic_maps, only: largest_difference
   use adfric_periodic_operator, only: periodic_operator_t
   implicit none (type, external)
   private
   public :: find_path, is_alone, solve_open

   !> Pressure that the system of the path leaves, over the tension, and steps of a system, at most.
   real(dp), parameter :: path_tolerance = 0.05_dp
   integer, parameter :: most_steps = 200
   !> Largest change of a share on a path that is tried.
   real(dp), parameter :: farthest_change = 0.5_dp
   !> Part of the margin that slopes may cost before they are found closer, and part that is left to the system of the distance.
   real(dp), parameter :: cost_of_secants = 0.5_dp, part_of_margin = 0.1_dp

contains

   !> Find the direction in which the solid yields to a load.
   subroutine find_path(state, is_open, operator, gap_solver, path)
      !> A state, with the slopes of its shares.
      type(contact_state_t), intent(in) :: state
      !> Open cells of the state and of a bound, or more.
      logical, intent(in), contiguous :: is_open(:, :)
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      !> Receives the change of the gap, >= 0; not allocated where there is none, since the solid yields by itself.
      real(dp), allocatable, intent(out) :: path(:, :)
      real(dp), allocatable :: load(:, :)

      allocate (load, path, mold=state%gap)
      load(:, :) = state%cohesion%stress
      call solve_open(operator, gap_solver, is_open, load, path_tolerance*state%cohesion%stress, path, state%cohesion)
      if (minval(path) < 0) deallocate (path)
   end subroutine find_path

   !> Is there no other state between a bound and a state?
   logical function is_alone(state, direction, is_open, operator, gap_solver, is_adhered, bound)
      !> The state, with the slopes of its shares.
      type(contact_state_t), intent(in) :: state
      !> Its direction, see `find_path`.
      real(dp), intent(in), contiguous :: direction(:, :)
      !> Open cells of the direction: those of the state and of the bound, or more.
      logical, intent(in), contiguous :: is_open(:, :)
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      !> Does the bound lie below the state? Else above.
      logical, intent(in) :: is_adhered
      !> Gap of the bound; shape of the cells.
      real(dp), intent(in), contiguous :: bound(:, :)
      type(cohesion_t) :: law
      type(cohesion_t), allocatable :: none
      real(dp), allocatable, dimension(:, :) :: path, slope, load, rest
      real(dp) :: length, spared, sign_of_path

      is_alone = .false.
      sign_of_path = merge(-1, 1, is_adhered)
      law = state%cohesion
      allocate (path, slope, load, rest, mold=bound)
      call set_slope(law, direction, slope)
      path(:, :) = max(0.0_dp, sign_of_path*(bound - state%gap))
      length = length_of(path, direction, slope > 0)
      path(:, :) = max(path, length*direction)
      call law%set_share(state%gap + sign_of_path*path)
      if (largest_difference(law%share, state%cohesion%share) > farthest_change) return
      call set_largest_slope(state, sign_of_path, path, cost_of_secants*length, slope)
      is_alone = .not. maxval(slope) > 0
      if (is_alone) return
      call operator%apply_stiffness(path, load)
      load(:, :) = load - law%stress*slope
      is_alone = minval(load, mask=is_open) > 0
      if (is_alone) return
      spared = part_of_margin*length*law%stress
      load(:, :) = load - spared
      call solve_open(operator, gap_solver, is_open, load, spared, rest, none)
      is_alone = all(rest > 0 .or. .not. (slope > 0 .and. is_open))
   end function is_alone

   !> How often a direction goes into a distance, in cells whose shares change.
   pure real(dp) function length_of(distance, direction, is_changing) result(length)
      real(dp), intent(in), contiguous :: distance(:, :), direction(:, :)
      !> Do shares change in the cell?
      logical, intent(in), contiguous :: is_changing(:, :)
      integer :: i, j

      length = 0
      do j = 1, size(distance, 2)
         do i = 1, size(distance, 1)
            if (.not. (is_changing(i, j) .and. direction(i, j) > 0)) cycle
            length = max(length, distance(i, j)/direction(i, j))
         end do
      end do
   end function length_of

   !> Solve A_OO x = b over given open cells. Where the slopes of adhesion leave no positive A, x is below 0 somewhere.
   subroutine solve_open(operator, gap_solver, is_open, load, tolerance, x, cohesion)
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      !> The open cells.
      logical, intent(in), contiguous :: is_open(:, :)
      !> b [E*].
      real(dp), intent(in), contiguous :: load(:, :)
      !> Largest |A x - b| in an open cell [E*]. Where it is not reached x is -1.
      real(dp), intent(in) :: tolerance
      !> Receives x, 0 in closed cells.
      real(dp), intent(out), contiguous :: x(:, :)
      !> Adhesion whose slopes are taken from A; not allocated: none.
      type(cohesion_t), allocatable, intent(in) :: cohesion
      type(extremes_t) :: extremes
      real(dp), allocatable :: pressure(:, :)
      real(dp) :: mean_pressure
      logical :: is_stuck
      integer :: k

      x(:, :) = 0
      if (.not. any(is_open)) return
      allocate (pressure, source=-load)
      mean_pressure = 0
      call gap_solver%forget()
      call gap_solver%set_region(operator, is_open, .false., .false., .false.)
      do k = 1, most_steps
         if (operator%is_stopped()) exit
         call gap_solver%improve(operator, is_open, 0.0_dp, x, pressure, mean_pressure, extremes, is_stuck, cohesion)
         if (is_stuck .or. extremes%remaining <= tolerance) exit
      end do
      if (is_stuck .or. .not. extremes%remaining <= tolerance) x(:, :) = -1
   end subroutine solve_open

end module adfric_periodic_adhesive_proof
