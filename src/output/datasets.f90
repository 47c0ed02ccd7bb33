!> The datasets of an open results file: created or found, written and read by rows of points.
!>
!> Every dataset has its full size from the start and holds NaN, or the state -1, where nothing has been written yet.
module adfric_output_datasets
   use, intrinsic :: iso_fortran_env, only: int8
   use hdf5, only: hid_t
   use adfric_base_kinds, only: dp, i8
   use adfric_base_not_a_number, only: not_a_number
   use adfric_hdf5_calls, only: hdf5_calls_t, no_id
   use adfric_hdf5_datasets, only: create_space, select_box, write_values, close_dataset, no_state, to_state
   use adfric_hdf5_reading, only: open_dataset, read_values, get_extent
   use adfric_output_boxes, only: box_t, next_box
   use adfric_output_constant_datasets, only: create_constants, list_constants
   use adfric_output_field_dataset, only: create_scale, create_field, create_counts, count_group
   use adfric_output_layout, only: layout_t
   use adfric_output_sums_dataset, only: sums_dataset_t
   use adfric_output_virtual_parts, only: virtual_parts_t
   implicit none (type, external)
   private
   public :: datasets_t

   !> The datasets, in the order of the layout. Rows are places of points in the file, from 1.
   type :: datasets_t
      private
      !> Spaces of the shape of a result, of a profile of all points, and of a count of all blocks.
      integer(hid_t) :: space = no_id, profile_space = no_id, count_space = no_id
      !> Scales with the values along a dimension, first of the points, then of the profiles; only when datasets are created.
      integer(hid_t), allocatable :: scales(:)
      !> Results, and last `error_estimate` and `status`.
      integer(hid_t), allocatable :: fields(:)
      integer(hid_t), allocatable :: profiles(:), counts(:)
      !> Checksums of the blocks.
      type(sums_dataset_t), public :: sums
   contains
      procedure :: create
      procedure :: open => open_all
      procedure :: write_results
      procedure :: write_status
      procedure :: write_profiles
      procedure :: write_counts
      procedure :: read_results
      procedure :: read_status
      procedure :: read_profiles
      procedure :: read_counts
      procedure :: get_extents
      procedure :: close => close_all
   end type datasets_t

contains

   !> Create every dataset.
   subroutine create(self, calls, file, layout, parts)
      !> Nothing is open in it before; all datasets are open afterwards.
      class(datasets_t), intent(inout) :: self
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the open results file.
      integer(hid_t), intent(in) :: file
      !> Layout of the file: its datasets and its points.
      type(layout_t), intent(in) :: layout
      !> Files in which the values are; if absent the values are in this file.
      type(virtual_parts_t), intent(in), optional :: parts
      character(:), allocatable :: coordinates
      integer :: i, n
      logical :: is_whole

      call prepare(self, calls, layout)
      n = size(layout%axes)
      do i = 1, n
         call create_scale(calls, file, layout%axes(i), self%scales(i))
      end do
      do i = 1, size(layout%profile_axes)
         call create_scale(calls, file, layout%profile_axes(i), self%scales(n + i))
      end do
      call create_constants(calls, file, layout%constants)
      ! the points of a part stand in a row, along which there is no scale
      is_whole = layout%blocks%part%is_whole()
      coordinates = ''
      if (is_whole) coordinates = list_constants(layout%constants)
      do i = 1, size(self%fields)
         call create_field(calls, file, layout%fields(i), self%space, self%scales(:merge(n, 0, is_whole)), 1, &
            coordinates, self%fields(i), parts)
      end do
      do i = 1, size(self%profiles)
         call create_field(calls, file, layout%profiles(i), self%profile_space, self%scales(merge(1, n + 1, is_whole):), &
            merge(1, 2, is_whole), coordinates, self%profiles(i), parts, is_profile=.true.)
      end do
      call create_counts(calls, file, layout%counts, self%count_space, self%counts)
      call self%sums%create(calls, file, layout%blocks%n_blocks())
   end subroutine create

   !> Open every dataset of results.
   subroutine open_all(self, calls, file, layout)
      !> Nothing is open in it before; all datasets of results are open afterwards.
      class(datasets_t), intent(inout) :: self
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the open results file.
      integer(hid_t), intent(in) :: file
      !> Layout of the file: its datasets and its points.
      type(layout_t), intent(in) :: layout
      integer :: i

      call prepare(self, calls, layout)
      do i = 1, size(self%fields)
         call open_dataset(calls, file, layout%fields(i)%name, self%fields(i))
      end do
      do i = 1, size(self%profiles)
         call open_dataset(calls, file, layout%profiles(i)%name, self%profiles(i))
      end do
      do i = 1, size(self%counts)
         call open_dataset(calls, file, count_group//'/'//layout%counts(i)%name, self%counts(i))
      end do
      call self%sums%open(calls, file, layout%blocks%n_blocks())
   end subroutine open_all

   !> Make room for the ids, and make the spaces.
   subroutine prepare(self, calls, layout)
      !> Gets room for the ids, all `no_id`, and its open spaces.
      class(datasets_t), intent(inout) :: self
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Layout of the file: its datasets and its points.
      type(layout_t), intent(in) :: layout

      allocate (self%scales(size(layout%axes) + size(layout%profile_axes)), self%fields(size(layout%fields)), &
         self%profiles(size(layout%profiles)), self%counts(size(layout%counts)), source=no_id)
      call create_space(calls, layout%row_shape(), self%space)
      call create_space(calls, [layout%row_shape(), layout%profile_shape()], self%profile_space)
      call create_space(calls, [layout%blocks%n_blocks()], self%count_space)
   end subroutine prepare

   !> Select the next box of a row of points in the space of the results.
   subroutine select_rows(self, calls, layout, first, n_left, memory_space, n)
      !> The open datasets and their spaces.
      class(datasets_t), intent(in) :: self
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Layout of the file: its datasets and its points.
      type(layout_t), intent(in) :: layout
      !> Place of the first point in the file, from 1.
      integer(i8), intent(in) :: first
      !> Number of points that are left.
      integer, intent(in) :: n_left
      !> Space of as many values as the box has points; the caller closes it.
      integer(hid_t), intent(out) :: memory_space
      !> Number of points of the box.
      integer, intent(out) :: n
      type(box_t) :: box

      call next_box(layout%row_shape(), first - 1, int(n_left, i8), box)
      n = int(product(box%count))
      call create_space(calls, [int(n, i8)], memory_space)
      call select_box(calls, self%space, box%start, box%count)
   end subroutine select_rows

   !> Write results of a row of points, but for their states.
   subroutine write_results(self, calls, layout, first, results, error_estimate)
      !> The open datasets and their spaces.
      class(datasets_t), intent(in) :: self
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Layout of the file: its datasets and its points.
      type(layout_t), intent(in) :: layout
      !> Place of the first point in the file, from 1.
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
         call select_rows(self, calls, layout, first + done, size(error_estimate) - done, memory_space, n)
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
      !> The open datasets and their spaces.
      class(datasets_t), intent(in) :: self
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Layout of the file: its datasets and its points.
      type(layout_t), intent(in) :: layout
      !> Place of the first point in the file, from 1.
      integer(i8), intent(in) :: first
      !> Status of each point, one of `status_...`, as it stands in the file.
      integer(int8), intent(in) :: states(:)
      integer(hid_t) :: memory_space
      integer :: done, n

      done = 0
      do while (done < size(states) .and. calls%is_good())
         call select_rows(self, calls, layout, first + done, size(states) - done, memory_space, n)
         call write_values(calls, self%fields(size(self%fields)), memory_space, self%space, states(done + 1:done + n))
         call calls%close_id(memory_space)
         done = done + n
      end do
   end subroutine write_status

   !> Read the results of a row of points.
   subroutine read_results(self, calls, layout, first, results, error_estimate)
      !> The open datasets and their spaces.
      class(datasets_t), intent(in) :: self
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Layout of the file: its datasets and its points.
      type(layout_t), intent(in) :: layout
      !> Place of the first point in the file, from 1.
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
         call select_rows(self, calls, layout, first + done, size(error_estimate) - done, memory_space, n)
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

   !> Read the states of a row of points.
   subroutine read_status(self, calls, layout, first, status)
      !> The open datasets and their spaces.
      class(datasets_t), intent(in) :: self
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Layout of the file: its datasets and its points.
      type(layout_t), intent(in) :: layout
      !> Place of the first point in the file, from 1.
      integer(i8), intent(in) :: first
      !> Status of each point, one of `status_...`, or `no_state`.
      integer, intent(out) :: status(:)
      integer(int8), allocatable :: states(:)
      integer(hid_t) :: memory_space
      integer :: done, n

      status = no_state
      done = 0
      do while (done < size(status) .and. calls%is_good())
         call select_rows(self, calls, layout, first + done, size(status) - done, memory_space, n)
         allocate (states(n), source=no_state)
         call read_values(calls, self%fields(size(self%fields)), memory_space, self%space, states)
         status(done + 1:done + n) = states
         call calls%close_id(memory_space)
         deallocate (states)
         done = done + n
      end do
   end subroutine read_status

   !> Write the profiles of a point.
   subroutine write_profiles(self, calls, layout, row, profiles)
      !> The open datasets and their spaces.
      class(datasets_t), intent(in) :: self
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Layout of the file: its datasets and its points.
      type(layout_t), intent(in) :: layout
      !> Place of the point in the file, from 1.
      integer(i8), intent(in) :: row
      !> Profiles of the point; shape `(n_last_axis, n_first_axis, n_profiles)`.
      real(dp), intent(in) :: profiles(:, :, :)
      integer(hid_t) :: memory_space
      integer :: i, n

      n = size(profiles, 1)*size(profiles, 2)
      call select_profile(self, calls, layout, row, n, memory_space)
      do i = 1, size(self%profiles)
         call write_values(calls, self%profiles(i), memory_space, self%profile_space, reshape(profiles(:, :, i), [n]))
      end do
      call calls%close_id(memory_space)
   end subroutine write_profiles

   !> Read the profiles of a point.
   subroutine read_profiles(self, calls, layout, row, profiles)
      !> The open datasets and their spaces.
      class(datasets_t), intent(in) :: self
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Layout of the file: its datasets and its points.
      type(layout_t), intent(in) :: layout
      !> Place of the point in the file, from 1.
      integer(i8), intent(in) :: row
      !> Profiles of the point; shape `(n_last_axis, n_first_axis, n_profiles)`.
      real(dp), intent(out) :: profiles(:, :, :)
      real(dp), allocatable :: numbers(:)
      integer(hid_t) :: memory_space
      integer :: i, n

      n = size(profiles, 1)*size(profiles, 2)
      allocate (numbers(n), source=0.0_dp)
      call select_profile(self, calls, layout, row, n, memory_space)
      do i = 1, size(self%profiles)
         call read_values(calls, self%profiles(i), memory_space, self%profile_space, numbers)
         profiles(:, :, i) = reshape(numbers, [size(profiles, 1), size(profiles, 2)])
      end do
      call calls%close_id(memory_space)
   end subroutine read_profiles

   !> Select a profile of a point in the space of the profiles.
   subroutine select_profile(self, calls, layout, row, n, memory_space)
      !> The open datasets and their spaces.
      class(datasets_t), intent(in) :: self
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Layout of the file: its datasets and its points.
      type(layout_t), intent(in) :: layout
      !> Place of the point in the file, from 1.
      integer(i8), intent(in) :: row
      !> Number of values of a profile.
      integer, intent(in) :: n
      !> Space of as many values, which the caller closes.
      integer(hid_t), intent(out) :: memory_space
      type(box_t) :: box

      call next_box(layout%row_shape(), row - 1, 1_i8, box)
      call create_space(calls, [int(n, i8)], memory_space)
      associate (shape => layout%profile_shape())
         call select_box(calls, self%profile_space, [box%start, 0*shape], [box%count, shape])
      end associate
   end subroutine select_profile

   !> Write what the model counted in neighbouring blocks.
   subroutine write_counts(self, calls, place, counts)
      !> The open datasets and their spaces.
      class(datasets_t), intent(in) :: self
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Place of the first block in the file, from 1.
      integer(i8), intent(in) :: place
      !> What the model counted in each block; shape `(n_blocks, n_counts)`.
      real(dp), intent(in) :: counts(:, :)
      real(dp), allocatable :: numbers(:)
      integer(hid_t) :: memory_space
      integer :: i

      if (size(counts) == 0) return
      call select_blocks(self, calls, place, size(counts, 1), memory_space)
      do i = 1, size(self%counts)
         numbers = counts(:, i)
         call write_values(calls, self%counts(i), memory_space, self%count_space, numbers)
      end do
      call calls%close_id(memory_space)
   end subroutine write_counts

   !> Read what the model counted in neighbouring blocks.
   subroutine read_counts(self, calls, place, counts)
      !> The open datasets and their spaces.
      class(datasets_t), intent(in) :: self
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Place of the first block in the file, from 1.
      integer(i8), intent(in) :: place
      !> What the model counted in each block; shape `(n_blocks, n_counts)`.
      real(dp), intent(out) :: counts(:, :)
      real(dp), allocatable :: numbers(:)
      integer(hid_t) :: memory_space
      integer :: i

      if (size(counts) == 0) return
      allocate (numbers(size(counts, 1)), source=0.0_dp)
      call select_blocks(self, calls, place, size(counts, 1), memory_space)
      do i = 1, size(self%counts)
         call read_values(calls, self%counts(i), memory_space, self%count_space, numbers)
         counts(:, i) = numbers
      end do
      call calls%close_id(memory_space)
   end subroutine read_counts

   !> Where in the file values stand that are written while a run goes on; of size 0 for those that are elsewhere.
   subroutine get_extents(self, calls, extents)
      !> The open datasets and their spaces.
      class(datasets_t), intent(in) :: self
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> First byte in the file, from 0, and number of bytes of each dataset; shape `(2, n)`.
      integer(i8), allocatable, intent(out) :: extents(:, :)
      integer :: i

      associate (ids => [self%fields, self%profiles, self%counts, self%sums%id])
         allocate (extents(2, size(ids)))
         do i = 1, size(ids)
            call get_extent(calls, ids(i), extents(1, i), extents(2, i))
         end do
      end associate
   end subroutine get_extents

   !> Select neighbouring blocks in the space of the counts.
   subroutine select_blocks(self, calls, place, n, memory_space)
      !> The open datasets and their spaces.
      class(datasets_t), intent(in) :: self
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Place of the first block in the file, from 1.
      integer(i8), intent(in) :: place
      !> Number of blocks.
      integer, intent(in) :: n
      !> Space of as many values, which the caller closes.
      integer(hid_t), intent(out) :: memory_space

      call create_space(calls, [int(n, i8)], memory_space)
      call select_box(calls, self%count_space, [place - 1], [int(n, i8)])
   end subroutine select_blocks

   !> Close every id.
   subroutine close_all(self, calls)
      !> The datasets and their spaces, none of which is open afterwards.
      class(datasets_t), intent(inout) :: self
      !> Chain of HDF5 calls; the ids are closed even where one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls

      call self%sums%close(calls)
      call close_list(calls, self%counts)
      call close_list(calls, self%profiles)
      call close_list(calls, self%fields)
      call close_list(calls, self%scales)
      call calls%close_id(self%count_space)
      call calls%close_id(self%profile_space)
      call calls%close_id(self%space)
   end subroutine close_all

   !> Close the datasets of a list.
   subroutine close_list(calls, ids)
      !> Chain of HDF5 calls; the ids are closed even where one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Ids of the datasets; not allocated afterwards. Nothing is done if they are not allocated before.
      integer(hid_t), allocatable, intent(inout) :: ids(:)
      integer :: i

      if (.not. allocated(ids)) return
      do i = 1, size(ids)
         call close_dataset(calls, ids(i))
      end do
      deallocate (ids)
   end subroutine close_list

end module adfric_output_datasets
