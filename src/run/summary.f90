! SPDX-License-Identifier: GPL-3.0-or-later
!> What a run found, in a few numbers.
module adfric_run_summary
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp, i8
   use adfric_describe_status, only: n_status, status_solved
   use adfric_describe_table, only: result_t
   implicit none (type, external)
   private
   public :: run_summary_t, new_summary

   !> Counts and ranges over the points of a run, or of a part of it.
   type :: run_summary_t
      !> Number of points.
      integer(i8) :: n_points = 0
      !> Points by status; shape `(0:n_status - 1)`.
      integer(i8) :: by_status(0:n_status - 1) = 0
      !> Points by the states 0, 1, 2, ... of each enumerated result; shape `(0:n_states - 1, n_results)`.
      integer(i8), allocatable :: by_state(:, :)
      !> Range of each main result over the solved points, empty (lowest > highest) if there is none; shape
      !> `(n_results)`.
      real(dp), allocatable :: lowest(:), highest(:)
      !> Points of a file whose values are not those that were written.
      integer(i8) :: n_damaged = 0
      !> Duration of the run [s].
      real(dp) :: wall_seconds = 0
      !> The signal that ended the run before its time; 0 if none did.
      integer :: signal = 0
      !> Time in the solver, summed over the threads, and time in the output [s].
      real(dp) :: solver_seconds = 0, output_seconds = 0
      !> Indices of the enumerated and of the main results.
      integer, allocatable :: enumerated(:), main(:)
   contains
      procedure :: add_points
      procedure :: merge => merge_summary
   end type run_summary_t

contains

   !> Start with no points.
   pure subroutine new_summary(self, results)
      !> Receives counts of 0 and empty ranges.
      type(run_summary_t), intent(out) :: self
      !> The model's table of results: which are enumerated, and which are main results.
      type(result_t), intent(in) :: results(:)
      integer :: i, n_states

      allocate (self%enumerated(0), self%main(0))
      n_states = 0
      do i = 1, size(results)
         n_states = max(n_states, results(i)%n_states())
         if (results(i)%n_states() > 0) then
            self%enumerated = [self%enumerated, i]
         else if (results(i)%is_main) then
            self%main = [self%main, i]
         end if
      end do
      allocate (self%by_state(0:n_states - 1, size(results)), source=0_i8)
      allocate (self%lowest(size(results)), source=huge(1.0_dp))
      allocate (self%highest(size(results)), source=-huge(1.0_dp))
   end subroutine new_summary

   !> Add points.
   pure subroutine add_points(self, results, status)
      class(run_summary_t), intent(inout) :: self
      !> Results of the points; shape `(n_results, n_points)`.
      real(dp), intent(in) :: results(:, :)
      !> One of `status_...` for each point; shape `(n_points)`.
      integer, intent(in) :: status(:)
      integer :: i, k, state

      self%n_points = self%n_points + size(status)
      do i = 1, size(status)
         self%by_status(status(i)) = self%by_status(status(i)) + 1
         if (status(i) /= status_solved) cycle
         do k = 1, size(self%enumerated)
            associate (column => self%enumerated(k))
               if (.not. ieee_is_finite(results(column, i))) cycle
               state = nint(results(column, i))
               self%by_state(state, column) = self%by_state(state, column) + 1
            end associate
         end do
         do k = 1, size(self%main)
            associate (column => self%main(k))
               if (.not. ieee_is_finite(results(column, i))) cycle
               self%lowest(column) = min(self%lowest(column), results(column, i))
               self%highest(column) = max(self%highest(column), results(column, i))
            end associate
         end do
      end do
   end subroutine add_points

   !> Add the points of another part of the run. The result does not depend on the order of the parts.
   pure subroutine merge_summary(self, other)
      !> The summary, to which the points are added; its wall time and signal stay as they are.
      class(run_summary_t), intent(inout) :: self
      !> Summary of the other part, of the same model.
      type(run_summary_t), intent(in) :: other

      self%n_points = self%n_points + other%n_points
      self%n_damaged = self%n_damaged + other%n_damaged
      self%by_status = self%by_status + other%by_status
      self%by_state = self%by_state + other%by_state
      self%lowest = min(self%lowest, other%lowest)
      self%highest = max(self%highest, other%highest)
      self%solver_seconds = self%solver_seconds + other%solver_seconds
   end subroutine merge_summary

end module adfric_run_summary
