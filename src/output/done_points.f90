! SPDX-License-Identifier: GPL-3.0-or-later
!> What a results file already has of a run.
module adfric_output_done_points
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use hdf5, only: hid_t
   use adfric_base_kinds, only: dp, i8
   use adfric_base_error, only: error_t, set_error, file_failure
   use adfric_base_not_a_number, only: not_a_number
   use adfric_hdf5_calls, only: hdf5_calls_t
   use adfric_hdf5_file, only: open_file, close_file
   use adfric_hdf5_reading, only: read_attribute
   use adfric_describe_status, only: status_solved
   use adfric_output_block_sums, only: sum_of_block, sum_of_profiles
   use adfric_output_datasets, only: datasets_t
   use adfric_output_heading, only: heading_t, new_heading, read_heading, say_difference
   use adfric_output_layout, only: layout_t, name_of_swept
   use adfric_output_seal, only: check_seal
   use adfric_run_block_source, only: block_list_t, new_block_list
   use adfric_run_run, only: run_t
   use adfric_run_summary, only: run_summary_t, new_summary
   implicit none (type, external)
   private
   public :: read_done_points, is_readable

   !> Number of blocks that are read at once.
   integer, parameter :: blocks_at_once = 16

contains

   !> Find the blocks that are solved in the file of a run, complete or not, and what they add to the run's summary.
   subroutine read_done_points(path, run, layout, list, summary, error)
      !> Name of the file.
      character(*), intent(in) :: path
      !> The run, to which the file must belong.
      class(run_t), intent(in) :: run
      !> Layout of the run.
      type(layout_t), intent(in) :: layout
      !> Receives the blocks of the run, without those that are solved in the file.
      type(block_list_t), intent(out) :: list
      !> Summary of the points that are solved; its time is that which they took, if it is known.
      type(run_summary_t), intent(out) :: summary
      !> Allocated if the file cannot be read, or belongs to another run.
      type(error_t), allocatable, intent(out) :: error
      type(hdf5_calls_t) :: calls
      type(heading_t) :: found, heading
      type(datasets_t) :: datasets
      integer(hid_t) :: file

      call new_block_list(list, layout%blocks)
      call new_summary(summary, run%model%results)
      call new_heading(heading, run)
      call check_seal(path, error)
      if (allocated(error)) return
      call open_file(calls, path, .false., file)
      call read_heading(calls, file, found)
      if (calls%is_good()) then
         if (len(say_difference(found, heading)) > 0) call set_error(error, file_failure, &
            path//': does not belong to this run: '//say_difference(found, heading))
      end if
      if (.not. allocated(error)) then
         call datasets%open(calls, file, layout)
         call read_attribute(calls, file, 'wall_seconds', summary%wall_seconds)
         ! it is NaN in the file of a run that was killed, and may be anything in one that is damaged
         if (.not. ieee_is_finite(summary%wall_seconds)) summary%wall_seconds = 0
         summary%wall_seconds = max(summary%wall_seconds, 0.0_dp)
         call scan(calls, datasets, layout, run, list, summary)
         call datasets%close(calls)
      end if
      call close_file(calls, file)
      if (.not. allocated(error)) call calls%get_error(path//': cannot read', error)
   end subroutine read_done_points

   !> Go through all blocks.
   subroutine scan(calls, datasets, layout, run, list, summary)
      type(hdf5_calls_t), intent(inout) :: calls
      type(datasets_t), intent(in) :: datasets
      type(layout_t), intent(in) :: layout
      class(run_t), intent(in) :: run
      !> The blocks that remain; those that are solved in the file are removed.
      type(block_list_t), intent(inout) :: list
      !> Summary of the run; the points that are solved in the file are added, and those of damaged blocks counted.
      type(run_summary_t), intent(inout) :: summary
      integer, allocatable :: status(:), status_of_block(:)
      real(dp), allocatable :: results(:, :), error_estimate(:)
      integer(i8), allocatable :: sums(:)
      integer(i8) :: index, row, sum
      integer :: i, k, n, first

      allocate (results(layout%blocks%size, size(run%model%results)), error_estimate(layout%blocks%size))
      do index = 1, layout%blocks%n_blocks(), blocks_at_once
         row = (index - 1)*layout%blocks%size + 1
         allocate (status(min(int(blocks_at_once, i8)*layout%blocks%size, layout%blocks%n_points() - row + 1)))
         allocate (sums((size(status) - 1)/layout%blocks%size + 1))
         call datasets%read_status(calls, layout, row, status)
         call datasets%sums%read(calls, index, sums)
         do i = 0, min(blocks_at_once - 1, (size(status) - 1)/layout%blocks%size)
            first = i*layout%blocks%size
            n = min(layout%blocks%size, size(status) - first)
            status_of_block = status(first + 1:first + n)
            ! a block may have been half written: it is solved again as a whole
            if (any(status_of_block < 0) .or. .not. calls%is_good()) cycle
            call read_block(calls, datasets, layout, index + i, status_of_block, results(:n, :), error_estimate(:n), sum)
            if (sum /= sums(i + 1) .or. .not. calls%is_good()) then
               ! a damaged block is solved again, too
               summary%n_damaged = summary%n_damaged + n
               cycle
            end if
            call list%mark_done(index + i)
            call add_swept(layout, run, layout%blocks%block_at(index + i), results(:n, :))
            call summary%add_points(transpose(results(:n, :)), [(status_of_block(k), k=1, n)])
         end do
         deallocate (status, sums)
      end do
   end subroutine scan

   !> Read a block, and find its checksum.
   subroutine read_block(calls, datasets, layout, index, status, results, error_estimate, sum)
      type(hdf5_calls_t), intent(inout) :: calls
      type(datasets_t), intent(in) :: datasets
      type(layout_t), intent(in) :: layout
      !> Index of the block in the file, from 1.
      integer(i8), intent(in) :: index
      !> Status of each point of the block, one of `status_...`.
      integer, intent(in) :: status(:)
      !> Results in the units of the model, shape `(n_points, n_results)`.
      real(dp), intent(out) :: results(:, :)
      !> Estimated relative error of each point [-].
      real(dp), intent(out) :: error_estimate(:)
      !> Checksum of what stands in the file for the block.
      integer(i8), intent(out) :: sum
      real(dp), allocatable :: profiles(:, :, :)
      real(dp) :: counts(1, size(layout%counts))
      integer(i8) :: row, block, profile_sum
      integer :: i

      row = (index - 1)*layout%blocks%size + 1
      block = layout%blocks%block_at(index)
      call datasets%read_results(calls, layout, row, results, error_estimate)
      call datasets%read_counts(calls, index, counts)
      profile_sum = 0
      if (size(layout%profiles) > 0) then
         allocate (profiles(product(layout%profile_shape()), 1, size(layout%profiles)))
         do i = 1, size(status)
            call datasets%read_profiles(calls, layout, row + i - 1, profiles)
            if (status(i) == status_solved) then
               profile_sum = ieor(profile_sum, sum_of_profiles(layout%blocks%first_point(block) + i - 1, profiles))
            else if (any(transfer(profiles, [0_i8]) /= transfer(not_a_number(), 0_i8))) then
               ! nothing has been written here
               profile_sum = not(profile_sum)
            end if
         end do
      end if
      sum = sum_of_block(layout, block, results, error_estimate, status, counts(1, :), profile_sum)
   end subroutine read_block

   !> Results that are swept stand in the file as variables alone.
   subroutine add_swept(layout, run, block, results)
      type(layout_t), intent(in) :: layout
      class(run_t), intent(in) :: run
      !> Number of the block in the run, from 1.
      integer(i8), intent(in) :: block
      !> Results of the block, shape `(n_points, n_results)`; those that are swept receive their values.
      real(dp), intent(inout) :: results(:, :)
      real(dp), allocatable :: values(:, :)
      integer :: i, k

      do k = 1, size(run%model%variables)
         if (.not. run%plan%is_swept(k)) cycle
         do i = 1, size(run%model%results)
            if (run%model%results(i)%name /= name_of_swept(run, k)) cycle
            if (.not. allocated(values)) then
               allocate (values(size(run%model%variables), size(results, 1)))
               call run%plan%get_values(layout%blocks%first_point(block), values)
            end if
            results(:, i) = values(k, :)
         end do
      end do
   end subroutine add_swept

   !> Can a run go on with a file?
   logical function is_readable(path)
      character(*), intent(in) :: path
      type(hdf5_calls_t) :: calls
      type(heading_t) :: heading
      type(error_t), allocatable :: error
      integer(hid_t) :: file

      is_readable = .false.
      call check_seal(path, error)
      if (allocated(error)) return
      call open_file(calls, path, .false., file)
      call read_heading(calls, file, heading)
      call close_file(calls, file)
      is_readable = calls%is_good() .and. len(heading%hash) > 0
   end function is_readable

end module adfric_output_done_points
