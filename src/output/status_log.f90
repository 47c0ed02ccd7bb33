! SPDX-License-Identifier: GPL-3.0-or-later
!> The states of points whose results are written but may not have reached the disk yet.
!>
!> A state says that a point is done; so it is written only when the point's results are on the disk.
module adfric_output_status_log
   use, intrinsic :: iso_fortran_env, only: int8
   use adfric_base_kinds, only: i8
   implicit none (type, external)
   private
   public :: status_log_t

   !> Space for so many points, and rows of points; there may be more of them in one row.
   integer, parameter :: max_points = 2**20, max_rows = 2**12

   !> States in the order in which they came.
   type :: status_log_t
      !> Number of points that wait, and number of rows of them.
      integer :: n_points = 0, n_rows = 0
      !> States of the points, with space for more.
      integer(int8), allocatable :: states(:)
      !> First index in the file of each row, from 1.
      integer(i8), allocatable :: first(:)
      !> Number of points of each row.
      integer, allocatable :: count(:)
   contains
      procedure :: has_space
      procedure :: add
      procedure :: clear
   end type status_log_t

contains

   !> Is there space for a row of points?
   pure logical function has_space(self, n)
      class(status_log_t), intent(in) :: self
      integer, intent(in) :: n

      has_space = self%n_points == 0 .or. (self%n_points + n <= max_points .and. self%n_rows < max_rows)
   end function has_space

   !> Add a row of points.
   subroutine add(self, first, status)
      !> The states so far, to which the row is added.
      class(status_log_t), intent(inout) :: self
      !> Index of the first point in the file, from 1.
      integer(i8), intent(in) :: first
      !> Status of each point of the row, one of `status_...`.
      integer, intent(in) :: status(:)

      if (.not. allocated(self%first)) allocate (self%first(max_rows), self%count(max_rows), self%states(max_points))
      if (self%n_points == 0 .and. size(status) > size(self%states)) then
         deallocate (self%states)
         allocate (self%states(size(status)))
      end if
      self%n_rows = self%n_rows + 1
      self%first(self%n_rows) = first
      self%count(self%n_rows) = size(status)
      self%states(self%n_points + 1:self%n_points + size(status)) = int(status, int8)
      self%n_points = self%n_points + size(status)
   end subroutine add

   !> Forget everything.
   pure subroutine clear(self)
      class(status_log_t), intent(inout) :: self

      self%n_points = 0
      self%n_rows = 0
   end subroutine clear

end module adfric_output_status_log
