! SPDX-License-Identifier: GPL-3.0-or-later
!> Proof that no state of an adhesive surface lies between a gap that bounds the wanted one and a state that was found.
!>
!> Let g be the state, and g -+ x a gap beyond the bound, x >= 0. Where no share changes by more than s m_i on the way from g to g -+ s x,
!> 0 < s <= 1, a round from there ends within s y of g, y = sigma0 A_OO^-1 m, over the open cells O of both ends. With y < x wherever
!> m > 0 that is nearer to g than it began, for every s: no state lies on the way, and rounds from its far end come to g.
!>
!> - The way is w = (A - sigma0 dt/dg)_OO^-1 sigma0, along which the solid gives way at a load, so long that it passes the bound, and
!>   the distance to the bound where that is more. Near the state y/w = 1 - A^-1 sigma0/w: w has the largest margin everywhere.
!> - m is the largest of secants. Shares change one way, so that between two parts of the way |t - t(g)|/s is not above the change at
!>   the farther part over the nearer s. Parts are so close that this costs a part of the margin that w has.
!> - On the last part, next to the state, slopes are those of the state itself.
!> - What the linear systems leave is in the comparison: an error e of the pressure changes y by at most e A_OO^-1 1 <= (e/sigma0) w.
module adfric_periodic_adhesive_proof
   use adfric_base_kinds, only: dp
   use adfric_periodic_cohesion, only: cohesion_t, shares_in_square
   use adfric_periodic_contact, only: contact_state_t
   use adfric_periodic_gap_solver, only: gap_solver_t, extremes_t
   use adfric_periodic_operator, only: periodic_operator_t
   implicit none (type, external)
   private
   public :: is_alone

   !> Pressure that the linear systems leave, over the largest of the load.
   real(dp), parameter :: linear_tolerance = 1.0e-3_dp
   !> Steps of each of them, at most.
   integer, parameter :: most_steps = 200
   !> Largest change of a share on a way that is tried.
   real(dp), parameter :: farthest_change = 0.6_dp
   !> Nearest part of the way with a secant of its own.
   real(dp), parameter :: nearest_part = 0.02_dp
   !> Part of the margin that secants may cost, and limits of the ratio of two parts.
   real(dp), parameter :: cost_of_secants = 0.25_dp, least_ratio = 0.85_dp, largest_ratio = 0.99_dp

contains

   !> Is there no other state between a bound and a state?
   logical function is_alone(state, operator, gap_solver, is_adhered, bound, is_open_there)
      !> The state, with the slopes of its shares.
      type(contact_state_t), intent(in) :: state
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      !> Does the bound lie below the state? Else above.
      logical, intent(in) :: is_adhered
      !> Gap of the bound; shape of the cells.
      real(dp), intent(in), contiguous :: bound(:, :)
      !> Open cells of the bound.
      logical, intent(in), contiguous :: is_open_there(:, :)
      type(cohesion_t) :: law
      type(cohesion_t), allocatable :: none
      real(dp), allocatable, dimension(:, :) :: direction, way, slope, next
      logical, allocatable :: is_open(:, :)
      real(dp) :: error, steepest, sign_of_way

      is_alone = .false.
      sign_of_way = merge(-1, 1, is_adhered)
      law = state%cohesion
      allocate (direction, way, slope, next, mold=bound)
      allocate (is_open, source=state%is_open)
      if (.not. is_adhered) is_open(:, :) = is_open .or. is_open_there
      next(:, :) = law%stress
      call solve_open(operator, gap_solver, is_open, next, direction, state%cohesion, error)
      if (.not. (minval(direction) >= 0 .and. error < law%stress/2)) return
      ! no smaller than without the error
      direction(:, :) = direction/(1 - error/law%stress)
      call set_slope(law, direction, slope)
      steepest = maxval(slope)
      way(:, :) = max(0.0_dp, sign_of_way*(bound - state%gap))
      way(:, :) = max(way, length_of(way, direction, slope > 0)*direction)
      call law%set_share(state%gap + sign_of_way*way)
      if (maxval(abs(law%share - state%cohesion%share)) > farthest_change) return
      law = state%cohesion
      call set_slope(law, way, slope)
      call raise_slope(law, state%gap, sign_of_way*way, &
         & min(max(1 - cost_of_secants/(1 + steepest), least_ratio), largest_ratio), slope)
      is_alone = .not. maxval(slope) > 0
      if (is_alone) return
      call solve_open(operator, gap_solver, is_open, law%stress*slope, next, none, error)
      is_alone = all(next + (error/law%stress)*direction < way .or. .not. slope > 0)
   end function is_alone

   !> Slopes of the shares at a state along a way.
   pure subroutine set_slope(law, way, slope)
      !> The law with its slopes.
      type(cohesion_t), intent(in) :: law
      !> Change of the gap, of one sign; shape of the cells.
      real(dp), intent(in), contiguous :: way(:, :)
      !> Receives the slopes, >= 0.
      real(dp), intent(out), contiguous :: slope(:, :)
      real(dp) :: product

      slope(:, :) = 0
      call law%subtract_slope(way, slope, product)
      slope(:, :) = abs(slope)/law%stress
   end subroutine set_slope

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

   !> The largest of slopes and of secants of the shares, from a state to all positions on a way but the nearest.
   subroutine raise_slope(law, gap, way, ratio, slope)
      !> The law; receives the squares on the way.
      type(cohesion_t), intent(inout) :: law
      !> Gap of the state; shape of the cells.
      real(dp), intent(in), contiguous :: gap(:, :)
      !> Change of the gap, of one sign.
      real(dp), intent(in), contiguous :: way(:, :)
      !> A part of the way over the next farther one.
      real(dp), intent(in) :: ratio
      !> In: slopes. Out: raised to the secants.
      real(dp), intent(inout), contiguous :: slope(:, :)
      integer, allocatable :: corners(:, :), number(:, :)
      real(dp), allocatable, dimension(:) :: start, direction, here, there, largest
      real(dp) :: part
      integer :: i, j, k, n

      call law%set_band(min(gap, gap + way), max(gap, gap + way))
      if (law%n_squares == 0) return
      allocate (number(size(gap, 1), size(gap, 2)), source=0)
      allocate (corners(4, law%n_squares))
      n = 0
      do k = 1, law%n_squares
         associate (x => law%squares(k)%x([1, 2, 2, 1]), y => law%squares(k)%y([1, 1, 2, 2]))
            do i = 1, 4
               if (number(x(i), y(i)) == 0) then
                  n = n + 1
                  number(x(i), y(i)) = n
               end if
               corners(i, k) = number(x(i), y(i))
            end do
         end associate
      end do
      allocate (start(n), direction(n), here(n), there(n), largest(n))
      do j = 1, size(gap, 2)
         do i = 1, size(gap, 1)
            if (number(i, j) == 0) cycle
            start(number(i, j)) = gap(i, j)
            direction(number(i, j)) = way(i, j)
            largest(number(i, j)) = slope(i, j)
         end do
      end do
      call sum_shares(law, corners, start, here)
      part = 1
      do while (part > nearest_part)
         call sum_shares(law, corners, start + part*direction, there)
         part = ratio*part
         largest(:) = max(largest, abs(there - here)/part)
      end do
      do j = 1, size(gap, 2)
         do i = 1, size(gap, 1)
            if (number(i, j) > 0) slope(i, j) = largest(number(i, j))
         end do
      end do
   end subroutine raise_slope

   !> What the squares on the way add to the shares of their cells.
   pure subroutine sum_shares(law, corners, gap, share)
      !> The law with the squares.
      type(cohesion_t), intent(in) :: law
      !> Cells of each square, round it; shape `(4, n)`.
      integer, intent(in), contiguous :: corners(:, :)
      !> Gap of the cells.
      real(dp), intent(in), contiguous :: gap(:)
      !> Receives the shares of the cells.
      real(dp), intent(out), contiguous :: share(:)
      real(dp) :: shares(4)
      integer :: i, k

      share(:) = 0
      do k = 1, size(corners, 2)
         shares = law%squares(k)%weight*shares_in_square(law%range, gap(corners(:, k)))
         do i = 1, 4
            share(corners(i, k)) = share(corners(i, k)) + shares(i)
         end do
      end do
   end subroutine sum_shares

   !> Solve A_OO x = b over given open cells. Where the slopes of adhesion leave no positive A, x is below 0 somewhere.
   subroutine solve_open(operator, gap_solver, is_open, load, x, cohesion, error)
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      !> The open cells.
      logical, intent(in), contiguous :: is_open(:, :)
      !> b [E*].
      real(dp), intent(in), contiguous :: load(:, :)
      !> Receives x, 0 in closed cells.
      real(dp), intent(out), contiguous :: x(:, :)
      !> Adhesion whose slopes are taken from A; not allocated: none.
      type(cohesion_t), allocatable, intent(in) :: cohesion
      !> Receives the largest |A x - b| in an open cell [E*].
      real(dp), intent(out) :: error
      type(extremes_t) :: extremes
      real(dp), allocatable :: pressure(:, :)
      real(dp) :: mean_pressure, largest
      logical :: is_stuck
      integer :: k

      x(:, :) = 0
      allocate (pressure, source=-load)
      mean_pressure = 0
      largest = maxval(load)
      call gap_solver%forget()
      call gap_solver%set_region(operator, is_open, .false., .false., .false.)
      do k = 1, most_steps
         if (operator%is_stopped()) exit
         call gap_solver%improve(operator, is_open, 0.0_dp, x, pressure, mean_pressure, extremes, is_stuck, cohesion)
         if (is_stuck .or. extremes%remaining <= linear_tolerance*largest) exit
      end do
      error = maxval(abs(pressure), mask=is_open)
      if (.not. any(is_open)) error = 0
      if (allocated(cohesion) .and. is_stuck .and. error > linear_tolerance*largest) x(:, :) = -1
   end subroutine solve_open

end module adfric_periodic_adhesive_proof
