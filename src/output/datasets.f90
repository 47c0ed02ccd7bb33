! SPDX-License-Identifier: GPL-3.0-or-later
!> The values in the datasets of an open results file, written and read by rows of points.
module adfric_output_datasets
   use, intrinsic :: iso_fortran_env, only: int8
   use hdf5, only: hid_t
   use adfric_base_kinds, only: dp, i8
   use adfric_base_not_a_number, only: not_a_number
   use adfric_hdf5_calls, only: hdf5_calls_t
   use adfric_hdf5_datasets, only: write_values, no_state, to_state
   use adfric_hdf5_reading, only: read_values
   use adfric_output_dataset_handles, only: dataset_handles_t
   use adfric_output_layout, only: layout_t
   implicit none (type, external)
   private
   public :: datasets_t

   !> The datasets and what stands in them. Rows are indices of points in the file, from 1.
   type, extends(dataset_handles_t) :: datasets_t
   contains
      procedure :: write_results
      procedure :: write_status
      procedure :: write_profiles
      procedure :: write_counts
      procedure :: read_results
      procedure :: read_states
      procedure :: read_status
      procedure :: read_profiles
      procedure :: read_counts
   end type datasets_t

contains

   !> Write results of a row of points, but for their states.
   subroutine write_results(self, calls, layout, first, results, error_estimate)
      class(datasets_t), intent(in) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      type(layout_t), intent(in) :: layout
      !> Index of the first point in the file, from 1.
      integer(i8), intent(in) :: first
      !> Results in the units of the model, shape `(n_points, n_results)`.
      real(dp), intent(in) :: results(:, :)
      !> Estimated relative error of each point [-].
      real(dp), intent(in) :: error_estimate(:)
      !> What is written next, contiguous.
      real(dp), allocatable :: numbers(:)
      integer(int8), allocatable :: states(:)
      integer(hid_t) :: memory_space
      integer :: done, n, i

      done = 0
      do while (done < size(error_estimate) .and. calls%is_good())
         call self%select_rows(calls, layout, first + done, size(error_estimate) - done, memory_space, n)
         do i = 1, size(self%fields) - 2
            numbers = results(done + 1:done + n, layout%fields(i)%column)
            if (len(layout%fields(i)%flag_meanings) == 0) then
               call write_values(calls, self%fields(i), memory_space, self%space, numbers)
            else
               states = to_state(numbers)
               call write_values(calls, self%fields(i), memory_space, self%space, states)
            end if
         end do
         numbers = error_estimate(done + 1:done + n)
         call write_values(calls, self%fields(size(self%fields) - 1), memory_space, self%space, numbers)
         call calls%close_id(memory_space)
         done = done + n
      end do
   end subroutine write_results

   !> Write the states of a row of points.
   subroutine write_status(self, calls, layout, first, states)
      class(datasets_t), intent(in) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      type(layout_t), intent(in) :: layout
      integer(i8), intent(in) :: first
      !> Status of each point, one of `status_...`, as it stands in the file.
      integer(int8), intent(in) :: states(:)
      integer(hid_t) :: memory_space
      integer :: done, n

      done = 0
      do while (done < size(states) .and. calls%is_good())
         call self%select_rows(calls, layout, first + done, size(states) - done, memory_space, n)
         call write_values(calls, self%fields(size(self%fields)), memory_space, self%space, states(done + 1:done + n))
         call calls%close_id(memory_space)
         done = done + n
      end do
   end subroutine write_status

   !> Read the results of a row of points.
   subroutine read_results(self, calls, layout, first, results, error_estimate)
      class(datasets_t), intent(in) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      type(layout_t), intent(in) :: layout
      integer(i8), intent(in) :: first
      !> Results in the units of the model, shape `(n_points, n_results)`; NaN in the columns that are not in the file.
      real(dp), intent(out) :: results(:, :)
      !> Estimated relative error of each point [-].
      real(dp), intent(out) :: error_estimate(:)
      real(dp), allocatable :: numbers(:)
      integer(int8), allocatable :: states(:)
      integer(hid_t) :: memory_space
      integer :: done, n, i

      results = not_a_number()
      done = 0
      do while (done < size(error_estimate) .and. calls%is_good())
         call self%select_rows(calls, layout, first + done, size(error_estimate) - done, memory_space, n)
         allocate (numbers(n), states(n))
         do i = 1, size(self%fields) - 2
            if (len(layout%fields(i)%flag_meanings) == 0) then
               call read_values(calls, self%fields(i), memory_space, self%space, numbers)
            else
               call read_values(calls, self%fields(i), memory_space, self%space, states)
               numbers = merge(real(states, dp), not_a_number(), states /= no_state)
            end if
            results(done + 1:done + n, layout%fields(i)%column) = numbers
         end do
         call read_values(calls, self%fields(size(self%fields) - 1), memory_space, self%space, numbers)
         error_estimate(done + 1:done + n) = numbers
         call calls%close_id(memory_space)
         deallocate (numbers, states)
         done = done + n
      end do
   end subroutine read_results

   !> Read the status of a row of points.
   subroutine read_status(self, calls, layout, first, status)
      class(datasets_t), intent(in) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      type(layout_t), intent(in) :: layout
      integer(i8), intent(in) :: first
      !> Status of each point, one of `status_...`, or `no_state`.
      integer, intent(out) :: status(:)

      call self%read_states(calls, layout, size(self%fields), first, status)
   end subroutine read_status

   !> Read an enumerated result of a row of points.
   subroutine read_states(self, calls, layout, index, first, states)
      class(datasets_t), intent(in) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      type(layout_t), intent(in) :: layout
      !> Index of the result in `fields`.
      integer, intent(in) :: index
      integer(i8), intent(in) :: first
      !> State of each point, or `no_state`.
      integer, intent(out) :: states(:)
      integer(int8), allocatable :: numbers(:)
      integer(hid_t) :: memory_space
      integer :: done, n

      states = no_state
      done = 0
      do while (done < size(states) .and. calls%is_good())
         call self%select_rows(calls, layout, first + done, size(states) - done, memory_space, n)
         allocate (numbers(n), source=no_state)
         call read_values(calls, self%fields(index), memory_space, self%space, numbers)
         states(done + 1:done + n) = numbers
         call calls%close_id(memory_space)
         deallocate (numbers)
         done = done + n
      end do
   end subroutine read_states

   !> Write the profiles of a point.
   subroutine write_profiles(self, calls, layout, row, profiles)
      class(datasets_t), intent(in) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      type(layout_t), intent(in) :: layout
      !> Index of the point in the file, from 1.
      integer(i8), intent(in) :: row
      real(dp), intent(in) :: profiles(:, :, :)
      integer(hid_t) :: memory_space
      integer :: i, n

      n = size(profiles, 1)*size(profiles, 2)
      call self%select_profile(calls, layout, row, n, memory_space)
      do i = 1, size(self%profiles)
         call write_values(calls, self%profiles(i), memory_space, self%profile_space, reshape(profiles(:, :, i), [n]))
      end do
      call calls%close_id(memory_space)
   end subroutine write_profiles

   !> Read the profiles of a point.
   subroutine read_profiles(self, calls, layout, row, profiles)
      class(datasets_t), intent(in) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      type(layout_t), intent(in) :: layout
      integer(i8), intent(in) :: row
      real(dp), intent(out) :: profiles(:, :, :)
      real(dp), allocatable :: numbers(:)
      integer(hid_t) :: memory_space
      integer :: i, n

      n = size(profiles, 1)*size(profiles, 2)
      allocate (numbers(n), source=0.0_dp)
      call self%select_profile(calls, layout, row, n, memory_space)
      do i = 1, size(self%profiles)
         call read_values(calls, self%profiles(i), memory_space, self%profile_space, numbers)
         profiles(:, :, i) = reshape(numbers, [size(profiles, 1), size(profiles, 2)])
      end do
      call calls%close_id(memory_space)
   end subroutine read_profiles

   !> Write what the model counted in neighbouring blocks.
   subroutine write_counts(self, calls, index, counts)
      class(datasets_t), intent(in) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      !> Index of the first block in the file, from 1.
      integer(i8), intent(in) :: index
      real(dp), intent(in) :: counts(:, :)
      real(dp), allocatable :: numbers(:)
      integer(hid_t) :: memory_space
      integer :: i

      if (size(counts) == 0) return
      call self%select_blocks(calls, index, size(counts, 1), memory_space)
      do i = 1, size(self%counts)
         numbers = counts(:, i)
         call write_values(calls, self%counts(i), memory_space, self%count_space, numbers)
      end do
      call calls%close_id(memory_space)
   end subroutine write_counts

   !> Read what the model counted in neighbouring blocks.
   subroutine read_counts(self, calls, index, counts)
      class(datasets_t), intent(in) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      integer(i8), intent(in) :: index
      real(dp), intent(out) :: counts(:, :)
      real(dp), allocatable :: numbers(:)
      integer(hid_t) :: memory_space
      integer :: i

      if (size(counts) == 0) return
      allocate (numbers(size(counts, 1)), source=0.0_dp)
      call self%select_blocks(calls, index, size(counts, 1), memory_space)
      do i = 1, size(self%counts)
         call read_values(calls, self%counts(i), memory_space, self%count_space, numbers)
         counts(:, i) = numbers
      end do
      call calls%close_id(memory_space)
   end subroutine read_counts

end module adfric_output_datasets
