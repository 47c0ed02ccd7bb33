!> What a results file already has of a run.
module adfric_output_done_points
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use hdf5, only: hid_t
   use adfric_base_kinds, only: dp, i8
   use adfric_base_error, only: error_t, set_error, file_failure
   use adfric_base_model, only: model_t
   use adfric_output_datasets, only: datasets_t
   use adfric_output_heading, only: heading_t, read_heading, say_difference
   use adfric_output_hdf5_layer_calls, only: hdf5_calls_t
   use adfric_output_hdf5_layer_file, only: open_file, close_file
   use adfric_output_hdf5_layer_reading, only: read_attribute
   use adfric_output_layout, only: layout_t
   use adfric_sweep_block_source, only: block_list_t, new_block_list
   use adfric_sweep_plan, only: plan_t
   use adfric_sweep_summary, only: run_summary_t, new_summary
   implicit none (type, external)
   private
   public :: read_done_points, is_readable

   !> Number of blocks that are read at once.
   integer, parameter :: blocks_at_once = 16

contains

   !> Find the blocks that are solved in the file of a run, complete or not, and what they add to the run's summary.
   subroutine read_done_points(path, layout, heading, model, plan, list, summary, error)
      !> Name of the file.
      character(*), intent(in) :: path
      !> Of the run.
      type(layout_t), intent(in) :: layout
      type(heading_t), intent(in) :: heading
      class(model_t), intent(in) :: model
      type(plan_t), intent(in) :: plan
      !> Without the blocks that are solved.
      type(block_list_t), intent(out) :: list
      !> Of the points that are solved; its time is that which they took, if it is known.
      type(run_summary_t), intent(out) :: summary
      !> The file cannot be read, or belongs to another run.
      type(error_t), allocatable, intent(out) :: error
      type(hdf5_calls_t) :: calls
      type(heading_t) :: found
      type(datasets_t) :: datasets
      integer(hid_t) :: file

      call new_block_list(list, layout%blocks)
      call new_summary(summary, model%results)
      call open_file(calls, path, .false., file)
      call read_heading(calls, file, found)
      if (calls%is_good()) then
         if (len(say_difference(found, heading)) > 0) call set_error(error, file_failure, &
            path//': does not belong to this run: '//say_difference(found, heading))
      end if
      if (.not. allocated(error)) then
         call datasets%open(calls, file, layout)
         call read_attribute(calls, file, 'wall_seconds', summary%wall_seconds)
         ! it is NaN in the file of a run that was killed
         if (ieee_is_nan(summary%wall_seconds)) summary%wall_seconds = 0
         call scan(calls, datasets, layout, model, plan, list, summary)
         call datasets%close(calls)
      end if
      call close_file(calls, file)
      if (.not. allocated(error)) call calls%get_error(path//': cannot read', error)
   end subroutine read_done_points

   !> Go through all blocks.
   subroutine scan(calls, datasets, layout, model, plan, list, summary)
      type(hdf5_calls_t), intent(inout) :: calls
      type(datasets_t), intent(in) :: datasets
      type(layout_t), intent(in) :: layout
      class(model_t), intent(in) :: model
      type(plan_t), intent(in) :: plan
      type(block_list_t), intent(inout) :: list
      type(run_summary_t), intent(inout) :: summary
      integer, allocatable :: status(:), status_of_block(:)
      real(dp), allocatable :: results(:, :), error_estimate(:)
      integer(i8) :: place, row
      integer :: i, k, n, first

      allocate (results(layout%blocks%size, size(model%results)), error_estimate(layout%blocks%size))
      do place = 1, layout%blocks%n_blocks(), blocks_at_once
         row = (place - 1)*layout%blocks%size + 1
         allocate (status(min(int(blocks_at_once, i8)*layout%blocks%size, layout%blocks%n_points() - row + 1)))
         call datasets%read_status(calls, layout, row, status)
         do i = 0, min(blocks_at_once - 1, (size(status) - 1)/layout%blocks%size)
            first = i*layout%blocks%size
            n = min(layout%blocks%size, size(status) - first)
            status_of_block = status(first + 1:first + n)
            ! a block may have been half written: it is solved again as a whole
            if (any(status_of_block < 0) .or. .not. calls%is_good()) cycle
            call list%mark_done(place + i)
            call datasets%read_results(calls, layout, row + first, results(:n, :), error_estimate(:n))
            call add_swept(layout, model, plan, layout%blocks%block_at(place + i), results(:n, :))
            call summary%add_points(transpose(results(:n, :)), [(status_of_block(k), k=1, n)])
         end do
         deallocate (status)
      end do
   end subroutine scan

   !> Results that are swept stand in the file as axes alone.
   subroutine add_swept(layout, model, plan, block, results)
      type(layout_t), intent(in) :: layout
      class(model_t), intent(in) :: model
      type(plan_t), intent(in) :: plan
      !> Number in the run.
      integer(i8), intent(in) :: block
      !> Shape `(n_points, n_results)`.
      real(dp), intent(inout) :: results(:, :)
      real(dp), allocatable :: values(:, :)
      integer :: i, k

      do k = 1, size(layout%axes)
         do i = 1, size(model%results)
            if (model%results(i)%name /= layout%axes(k)%name) cycle
            if (.not. allocated(values)) then
               allocate (values(size(model%variables), size(results, 1)))
               call plan%get_values(layout%blocks%first_point(block), values)
            end if
            results(:, i) = values(plan%axes(k)%variable, :)
         end do
      end do
   end subroutine add_swept

   !> Can a run go on with a file?
   logical function is_readable(path)
      character(*), intent(in) :: path
      type(hdf5_calls_t) :: calls
      type(heading_t) :: heading
      integer(hid_t) :: file

      call open_file(calls, path, .false., file)
      call read_heading(calls, file, heading)
      call close_file(calls, file)
      is_readable = calls%is_good() .and. len(heading%hash) > 0
   end function is_readable

end module adfric_output_done_points
