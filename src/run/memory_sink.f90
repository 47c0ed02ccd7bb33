! SPDX-License-Identifier: GPL-3.0-or-later
!> A sink that keeps the results of a run in memory, for a caller that has no file.
module adfric_run_memory_sink
   use adfric_base_error, only: error_t, set_error, file_failure
   use adfric_base_kinds, only: dp, i8
   use adfric_base_not_a_number, only: not_a_number
   use adfric_describe_status, only: status_solved
   use adfric_run_blocks, only: blocks_t
   use adfric_run_run, only: run_t
   use adfric_run_sink, only: sink_t
   use adfric_system_memory, only: has_free
   implicit none (type, external)
   private
   public :: memory_sink_t, new_memory_sink, status_not_put

   !> Status of a point whose results have not come, as in the file.
   integer, parameter :: status_not_put = -1
   !> Bytes of a real number.
   integer, parameter :: real_bytes = 8

   !> The results of every point of a run, or of its part, in the order of the points.
   type, extends(sink_t) :: memory_sink_t
      !> Results in the units of the model; shape `(n_points, n_results)`; NaN where there is no value, and of no meaning where they
      !> have not come: to fill them before would take as long as many models do.
      real(dp), allocatable :: results(:, :)
      !> Relative error of the main result at each point; shape `(n_points)`.
      real(dp), allocatable :: error_estimate(:)
      !> One of `status_...` for each point; shape `(n_points)`.
      integer, allocatable :: status(:)
      !> What the model counted in each block; shape `(n_blocks, n_counts)`.
      real(dp), allocatable :: counts(:, :)
      !> Profiles of each point; shape `(n_last_axis, n_first_axis, n_profiles, n_points)`, see `run_t%profile_shape`; NaN for a
      !> point that has none, of no meaning where the results have not come, and of size 0 if the case wants no profiles.
      real(dp), allocatable :: profiles(:, :, :, :)
      !> The points and blocks that are kept.
      type(blocks_t) :: blocks
   contains
      procedure :: put
      procedure :: put_profiles
      procedure :: mean_counts
   end type memory_sink_t

contains

   !> Make space for the results of a run.
   subroutine new_memory_sink(self, run, error)
      !> Receives space for every point, none of which is solved.
      class(memory_sink_t), intent(out) :: self
      !> The run, which says how many points, results, counts and profiles there are.
      class(run_t), intent(in) :: run
      !> Allocated if there is too little memory.
      type(error_t), allocatable, intent(out) :: error
      integer(i8) :: n_points
      real(dp) :: n_bytes
      integer :: shape(3), failure

      ! a copy in memory takes no time that other threads would wait for
      self%has_own_thread = .false.
      self%blocks = run%blocks()
      n_points = self%blocks%n_points()
      shape = run%profile_shape()
      n_bytes = real_bytes*real(n_points, dp)*(size(run%model%results) + 2 + product(real(shape, dp)))
      failure = merge(0, 1, has_free(n_bytes))
      if (failure == 0) allocate (self%results(n_points, size(run%model%results)), self%error_estimate(n_points), &
         self%status(n_points), self%counts(self%blocks%n_blocks(), size(run%model%counts)), &
         self%profiles(shape(1), shape(2), shape(3), n_points), stat=failure)
      if (failure /= 0) then
         call set_error(error, file_failure, 'there is too little memory for the results')
         return
      end if
      self%status = status_not_put
      self%counts = 0
   end subroutine new_memory_sink

   !> See `sink_t`.
   subroutine put(self, first, results, error_estimate, status, counts, error)
      class(memory_sink_t), intent(inout) :: self
      integer(i8), intent(in) :: first
      real(dp), intent(in) :: results(:, :), error_estimate(:)
      integer, intent(in) :: status(:)
      real(dp), intent(in) :: counts(:, :)
      !> Never allocated: there is space for all points.
      type(error_t), allocatable, intent(out) :: error
      integer(i8) :: row, index
      integer :: i

      row = self%blocks%row_of(first)
      index = (row - 1)/self%blocks%size + 1
      self%results(row:row + size(status) - 1, :) = results
      self%error_estimate(row:row + size(status) - 1) = error_estimate
      self%status(row:row + size(status) - 1) = status
      self%counts(index:index + size(counts, 1) - 1, :) = counts
      if (size(self%profiles) > 0) then
         do i = 1, size(status)
            if (status(i) /= status_solved) self%profiles(:, :, :, row + i - 1) = not_a_number()
         end do
      end if
      associate (unused => error)
      end associate
   end subroutine put

   !> See `sink_t`.
   subroutine put_profiles(self, point, profiles, error)
      class(memory_sink_t), intent(inout) :: self
      integer(i8), intent(in) :: point
      real(dp), intent(in) :: profiles(:, :, :)
      !> Never allocated: there is space for all points.
      type(error_t), allocatable, intent(out) :: error

      self%profiles(:, :, :, self%blocks%row_of(point)) = profiles
      associate (unused => error)
      end associate
   end subroutine put_profiles

   !> Means over the points of what the model counts, as they stand in a results file; shape `(n_counts)`.
   pure function mean_counts(self) result(means)
      class(memory_sink_t), intent(in) :: self
      real(dp) :: means(size(self%counts, 2))

      means = sum(self%counts, dim=1)/real(max(self%blocks%n_points(), 1_i8), dp)
   end function mean_counts

end module adfric_run_memory_sink
