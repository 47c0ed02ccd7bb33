! SPDX-License-Identifier: GPL-3.0-or-later
!> State of a contact of a body that ends, on one grid, and the motions of the body that its load decides: approach and tilts.
module adfric_periodic_free_state
   use adfric_base_kinds, only: dp
   use adfric_periodic_maps, only: sum_of
   implicit none (type, external)
   private
   public :: free_state_t, is_balanced, moment_of, motion_of, solve_motions

   !> Part of a motion's stiffness that must be left where others have been taken from it.
   real(dp), parameter :: least_pivot = 1.0e-9_dp

   !> Contact on one grid; arrays have the shape of its cells.
   type :: free_state_t
      !> Gap g0 of the undeformed surfaces, >= 0; of no meaning beside the body.
      real(dp), allocatable :: shape(:, :)
      !> Is the cell one of the body?
      logical, allocatable :: is_body(:, :)
      !> Pressure p [E*], and the displacement u that it makes.
      real(dp), allocatable :: pressure(:, :), displacement(:, :)
      !> Is the cell in contact? Its gap is 0 then, else its pressure is.
      logical, allocatable :: is_contact(:, :)
      !> Is the load given, and not the approach?
      logical :: has_load = .true.
      !> Sum of the pressures of all cells [E*], and approach, of which one is given.
      real(dp) :: total = 0, approach = 0
      !> May the body tilt along x, along y? Only under a load.
      logical :: may_tilt(2) = .false.
      !> Tilts: slopes by which it comes nearer along x and along y.
      real(dp) :: tilt(2) = 0
      !> Positions of the cells from the point of the load along x and y; allocated where the body may tilt.
      real(dp), allocatable :: arm_x(:), arm_y(:)
      !> Largest violation of the conditions of contact, of a pressure over the largest one, of a gap over what that makes in one
      !> cell.
      real(dp) :: residual = huge(1.0_dp)
      !> Changes of the region, and steps in all of them.
      integer :: n_rounds = 0, n_iterations = 0
      !> Has the residual come below the tolerance?
      logical :: is_converged = .false.
   contains
      procedure :: depths
   end type free_state_t

contains

   !> How deep the body has come in a row of cells.
   pure function depths(self, row)
      class(free_state_t), intent(in) :: self
      !> Number of the row.
      integer, intent(in) :: row
      real(dp) :: depths(size(self%shape, 1))

      depths = self%approach
      if (any(self%may_tilt)) depths = self%approach + self%tilt(2)*self%arm_y(row) + self%tilt(1)*self%arm_x
   end function depths

   !> A motion of the body in a row of cells.
   pure function motion_of(state, motion, row) result(moved)
      type(free_state_t), intent(in) :: state
      !> 1: approach, 2 and 3: tilts along x and y; and the row.
      integer, intent(in) :: motion, row
      real(dp) :: moved(size(state%shape, 1))

      moved = 1
      if (motion == 2) moved = state%arm_x
      if (motion == 3) moved = state%arm_y(row)
   end function motion_of

   !> Sum of a field times a motion of the body.
   real(dp) function moment_of(state, motion, field) result(moment)
      type(free_state_t), intent(in) :: state
      integer, intent(in) :: motion
      !> The field; shape of the cells.
      real(dp), intent(in), contiguous :: field(:, :)
      integer :: j

      if (motion == 1) then
         moment = sum_of(field)
         return
      end if
      moment = 0
      do j = 1, size(field, 2)
         moment = moment + dot_product(motion_of(state, motion, j), field(:, j))
      end do
   end function moment_of

   !> Solve for motions. What the contact cannot tell from other motions stays 0, such as the tilt over a single cell.
   pure function solve_motions(matrix, right) result(motions)
      !> Symmetric matrix, positive but for motions that cannot be told.
      real(dp), intent(in) :: matrix(:, :)
      real(dp), intent(in) :: right(:)
      real(dp) :: motions(size(right)), m(size(right), size(right)), factor
      logical :: is_known(size(right))
      integer :: i, k

      m = matrix
      motions = right
      do k = 1, size(right)
         is_known(k) = m(k, k) > least_pivot*matrix(k, k)
         if (.not. is_known(k)) cycle
         do i = k + 1, size(right)
            factor = m(i, k)/m(k, k)
            m(i, :) = m(i, :) - factor*m(k, :)
            motions(i) = motions(i) - factor*motions(k)
         end do
      end do
      do k = size(right), 1, -1
         if (.not. is_known(k)) motions(k) = 0
         if (is_known(k)) motions(k) = (motions(k) - sum(m(k, k + 1:)*motions(k + 1:)))/m(k, k)
      end do
   end function solve_motions

   !> Has the pressure no moment about the load, where the body may tilt?
   logical function is_balanced(state, tolerance)
      type(free_state_t), intent(in) :: state
      !> Moment that is allowed, over the load times the longest arm.
      real(dp), intent(in) :: tolerance
      real(dp) :: moments(2)

      moments = 0
      if (state%may_tilt(1)) moments(1) = moment_of(state, 2, state%pressure)/maxval(abs(state%arm_x))
      if (state%may_tilt(2)) moments(2) = moment_of(state, 3, state%pressure)/maxval(abs(state%arm_y))
      is_balanced = all(abs(moments) <= tolerance*state%total) .or. .not. state%has_load
   end function is_balanced

end module adfric_periodic_free_state
