! SPDX-License-Identifier: GPL-3.0-or-later
!> Stiffness of a contact: the slope of the mean pressure over the approach, with the cells in contact as they are.
!>
!> Without adhesion pressure and gap are 0 at an edge. So what an edge's motion adds to the load is of the second order, and the
!> slope is that of a rigid flat punch with the shape of the spots. Of cells it jumps a little where one comes into contact. On the
!> mean it is right to the order of the approach, since it is the slope of that. So its error is that of the area, times the slope
!> of the stiffness over the area. That is found from the same contact without the cells along its edges.
module adfric_periodic_contact_punch
   use adfric_base_kinds, only: dp
   use adfric_periodic_area, only: area_t
   use adfric_periodic_gap_solver, only: gap_solver_t
   use adfric_periodic_operator, only: periodic_operator_t
   use adfric_periodic_punch, only: find_punch_compliance
   implicit none (type, external)
   private
   public :: contact_punch_t, find_contact_punch, cells_inside, error_by_area

   !> Relative error of the stiffness without the edges.
   real(dp), parameter :: tolerance_inside = 1.0e-4_dp

   !> A punch with the shape of the spots that touch.
   type :: contact_punch_t
      !> Slope of the approach over the mean pressure [unit of the gap over E*]: 0 in full contact with a half-space, below 0
      !> without contact.
      real(dp) :: compliance = -1
      !> Bound of the relative error of its inverse, the stiffness [-].
      real(dp) :: error = 0
      !> Was it found?
      logical :: is_found = .false.
   end type contact_punch_t

contains

   !> Find the punch of a contact.
   subroutine find_contact_punch(operator, gap_solver, is_open, area, tolerance, punch)
      !> Operator of the cells, which counts how often it is applied.
      type(periodic_operator_t), intent(inout) :: operator
      type(gap_solver_t), intent(inout) :: gap_solver
      !> Is the cell out of contact? Shape of the cells.
      logical, intent(in), contiguous :: is_open(:, :)
      !> Area in contact, with the bound of its error.
      type(area_t), intent(in) :: area
      !> Relative error that steps may leave [-].
      real(dp), intent(in) :: tolerance
      type(contact_punch_t), intent(out) :: punch
      logical, allocatable :: is_inside(:, :)
      real(dp) :: inside, stiffness, stiffness_inside
      logical :: is_found

      call find_punch_compliance(operator, gap_solver, is_open, tolerance, punch%compliance, punch%is_found)
      if (punch%compliance < 0 .or. .not. punch%is_found) return
      punch%compliance = punch%compliance + operator%mean_compliance
      if (.not. any(is_open) .or. .not. punch%compliance > 0) return
      stiffness = 1/punch%compliance
      allocate (is_inside, source=cells_inside(.not. is_open, .not. [operator%is_quarter, operator%is_quarter]))
      stiffness_inside = 0
      is_found = .true.
      if (any(is_inside)) then
         call find_punch_compliance(operator, gap_solver, .not. is_inside, tolerance_inside, inside, is_found)
         inside = inside + operator%mean_compliance
         is_found = is_found .and. inside > 0
         if (is_found) stiffness_inside = 1/inside
      end if
      punch%is_found = is_found
      punch%error = error_by_area(stiffness, stiffness_inside, count(.not. is_open), count(is_inside), area)
   end subroutine find_contact_punch

   !> Bound of the relative error of a stiffness, from that of the area and the stiffness without the cells along the edges.
   pure real(dp) function error_by_area(stiffness, stiffness_inside, n_cells, n_inside, area) result(error)
      !> The stiffness, and that without the cells along the edges, in any unit.
      real(dp), intent(in) :: stiffness, stiffness_inside
      !> Number of cells in contact, and of those that are not along an edge; the first is above the second.
      integer, intent(in) :: n_cells, n_inside
      !> Area in contact, with the bound of its error.
      type(area_t), intent(in) :: area
      real(dp) :: slope

      ! per share of the surface
      slope = (1 - stiffness_inside/stiffness)/(area%resolution*(n_cells - n_inside))
      error = min(slope*area%error, 1.0_dp)
   end function error_by_area

   !> The cells whose four neighbours are in contact, too.
   pure function cells_inside(is_contact, goes_on) result(is_inside)
      !> Is the cell in contact? Shape of the cells.
      logical, intent(in) :: is_contact(:, :)
      !> Does the map go on periodically along x, along y? Else a cell at its border has the neighbour that a mirror there makes.
      logical, intent(in) :: goes_on(2)
      logical :: is_inside(size(is_contact, 1), size(is_contact, 2))
      integer :: i, j, nx, ny

      nx = size(is_contact, 1)
      ny = size(is_contact, 2)
      do j = 1, ny
         do i = 1, nx
            is_inside(i, j) = is_contact(i, j) .and. is_contact(before(i, nx, goes_on(1)), j) .and. &
               & is_contact(behind(i, nx, goes_on(1)), j) .and. is_contact(i, before(j, ny, goes_on(2))) .and. &
               & is_contact(i, behind(j, ny, goes_on(2)))
         end do
      end do
   end function cells_inside

   !> Number of the neighbour before a cell.
   pure integer function before(i, n, goes_on)
      !> Number of the cell, and of all in its row.
      integer, intent(in) :: i, n
      !> Does the row go on periodically?
      logical, intent(in) :: goes_on

      before = i - 1
      if (i == 1) before = merge(n, 1, goes_on)
   end function before

   !> Number of the neighbour behind a cell.
   pure integer function behind(i, n, goes_on)
      !> Number of the cell, and of all in its row.
      integer, intent(in) :: i, n
      !> Does the row go on periodically?
      logical, intent(in) :: goes_on

      behind = i + 1
      if (i == n) behind = merge(1, n, goes_on)
   end function behind

end module adfric_periodic_contact_punch
