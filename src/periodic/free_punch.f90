! SPDX-License-Identifier: GPL-3.0-or-later
!> Stiffness of the spots on which a body that ends touches: the load of a rigid flat punch of their shape over its approach. Its
!> error is that of the area, see `adfric_periodic_contact_punch`.
module adfric_periodic_free_punch
   use adfric_base_kinds, only: dp
   use adfric_periodic_area, only: area_t
   use adfric_periodic_contact_punch, only: cells_inside, error_by_area
   use adfric_periodic_free_contact, only: solve_free_contact
   use adfric_periodic_free_operator, only: free_operator_t
   use adfric_periodic_free_state, only: free_state_t
   use adfric_periodic_maps, only: sum_of
   implicit none (type, external)
   private
   public :: free_punch_t, find_free_punch

   !> Relative error of the stiffness without the edges.
   real(dp), parameter :: tolerance_inside = 1.0e-4_dp

   !> Part of a cell by which an edge of the body is off, where the pressure of cells has no end: 0.17 along a straight edge.
   real(dp), parameter :: part_at_border = 0.25_dp

   !> A punch with the shape of the spots that touch.
   type :: free_punch_t
      !> Load over approach [E* times the unit of length]; 0 without contact.
      real(dp) :: stiffness = 0
      !> Bound of its relative error [-].
      real(dp) :: error = 0
      !> Was it found?
      logical :: is_found = .true.
   end type free_punch_t

contains

   !> Find the punch of a contact.
   subroutine find_free_punch(operator, is_contact, is_body, area, tolerance, punch)
      !> Operator of the cells, which counts how often it is applied.
      type(free_operator_t), intent(inout) :: operator
      !> Is the cell in contact? Shape of the cells.
      logical, intent(in) :: is_contact(:, :)
      !> Is the cell one of the body? Same shape.
      logical, intent(in) :: is_body(:, :)
      !> Area in contact, with the bound of its error, as shares of the map.
      type(area_t), intent(in) :: area
      !> Largest residual of the gap below the punch [-].
      real(dp), intent(in) :: tolerance
      type(free_punch_t), intent(out) :: punch
      logical, allocatable :: is_inside(:, :)
      type(area_t) :: uncertain
      real(dp) :: inside
      logical :: is_found

      if (.not. any(is_contact)) return
      call press(operator, is_contact, tolerance, punch%stiffness, punch%is_found)
      if (.not. punch%is_found) return
      allocate (is_inside, source=cells_inside(is_contact, operator%is_periodic))
      ! a body ends at a border beyond which its map does not go on
      if (.not. operator%is_periodic(1)) is_inside([1, size(is_inside, 1)], :) = .false.
      if (.not. operator%is_periodic(2)) is_inside(:, [1, size(is_inside, 2)]) = .false.
      inside = 0
      is_found = .true.
      if (any(is_inside)) call press(operator, is_inside, tolerance_inside, inside, is_found)
      punch%is_found = is_found
      uncertain = area
      uncertain%error = area%error + part_at_border*area%resolution*sides_at_border(is_contact, is_body, operator%is_periodic)
      punch%error = error_by_area(punch%stiffness, inside, count(is_contact), count(is_inside), uncertain)
   end subroutine find_free_punch

   !> Number of sides of cells in contact beyond which there is no body.
   pure integer function sides_at_border(is_contact, is_body, goes_on) result(n_sides)
      !> Is the cell in contact? Is it one of the body? Shape of the cells.
      logical, intent(in) :: is_contact(:, :), is_body(:, :)
      !> Does the map go on periodically along x, along y?
      logical, intent(in) :: goes_on(2)
      integer :: nx, ny

      nx = size(is_contact, 1)
      ny = size(is_contact, 2)
      n_sides = count(is_contact(2:, :) .and. .not. is_body(:nx - 1, :)) &
         & + count(is_contact(:nx - 1, :) .and. .not. is_body(2:, :)) &
         & + count(is_contact(:, 2:) .and. .not. is_body(:, :ny - 1)) &
         & + count(is_contact(:, :ny - 1) .and. .not. is_body(:, 2:))
      if (.not. goes_on(1)) n_sides = n_sides + count(is_contact([1, nx], :))
      if (.not. goes_on(2)) n_sides = n_sides + count(is_contact(:, [1, ny]))
   end function sides_at_border

   !> Press a flat punch by 1. Its pressure is above 0 everywhere, so that it stays in contact.
   subroutine press(operator, is_contact, tolerance, stiffness, is_found)
      type(free_operator_t), intent(inout) :: operator
      logical, intent(in) :: is_contact(:, :)
      real(dp), intent(in) :: tolerance
      !> Receives its load.
      real(dp), intent(out) :: stiffness
      logical, intent(out) :: is_found
      type(free_state_t) :: state

      allocate (state%shape(size(is_contact, 1), size(is_contact, 2)), source=0.0_dp)
      allocate (state%pressure, state%displacement, source=state%shape)
      allocate (state%is_body, state%is_contact, source=is_contact)
      state%has_load = .false.
      state%approach = 1
      call solve_free_contact(state, operator, tolerance)
      stiffness = sum_of(state%pressure)*product(operator%cell_size)
      is_found = state%is_converged .and. stiffness > 0
   end subroutine press

end module adfric_periodic_free_punch
