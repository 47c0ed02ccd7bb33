! SPDX-License-Identifier: GPL-3.0-or-later
!> The creation of a results file with all that stands in it before the first result.
module adfric_output_file_creation
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: i8
   use adfric_hdf5_calls, only: hdf5_calls_t
   use adfric_hdf5_file, only: create_file, flush_file
   use adfric_output_heading, only: heading_t, write_heading
   use adfric_output_means, only: write_placeholders, n_placeholders
   use adfric_output_part_layout, only: write_part_layout
   use adfric_output_results_writer, only: results_writer_t
   use adfric_output_seal, only: seal_t
   use adfric_output_virtual_parts, only: virtual_parts_t
   use adfric_system_clock, only: wall_clock
   use adfric_system_files, only: kind_of_path, path_free, id_of_file, remove_file
   use adfric_system_leftovers, only: note_leftover, begin_making, end_making
   implicit none (type, external)
   private
   public :: create_all

contains

   !> Create the file with its heading, every dataset and its seal.
   subroutine create_all(results, heading, error, parts)
      !> The file, which has its names and its layout; it is open afterwards, also after an error.
      class(results_writer_t), intent(inout) :: results
      type(heading_t), intent(in) :: heading
      type(error_t), allocatable, intent(out) :: error
      !> Files in which the values are; if absent the values come into this file.
      type(virtual_parts_t), intent(in), optional :: parts
      type(hdf5_calls_t) :: calls
      type(seal_t) :: seal
      integer(i8), allocatable :: extents(:, :)

      if (kind_of_path(results%path_now) /= path_free) call remove_file(results%path_now, error)
      if (allocated(error)) return
      call begin_making()
      call note_leftover(results%path_now)
      call create_file(calls, results%path_now, results%file)
      call end_making()
      ! what a creation leaves that has failed half way is ours, too
      results%id = id_of_file(results%path_now)
      associate (layout => results%layout)
         call seal%create(calls, results%file, n_placeholders(layout) + size(layout%fields) + size(layout%profiles) &
            + size(layout%counts) + 1)
      end associate
      call write_heading(calls, results%file, heading)
      call write_placeholders(calls, results%file, results%layout)
      if (.not. results%layout%blocks%part%is_whole()) call write_part_layout(calls, results%file, results%layout)
      call results%datasets%create(calls, results%file, results%layout, parts)
      call flush_file(calls, results%file)
      call results%datasets%get_extents(calls, extents)
      call seal%write(calls, results%path_now, extents, n_placeholders(results%layout))
      call flush_file(calls, results%file)
      call calls%get_error(results%path//': cannot create', error)
      results%safe_at = wall_clock()
   end subroutine create_all

end module adfric_output_file_creation
