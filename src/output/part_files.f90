! SPDX-License-Identifier: GPL-3.0-or-later
!> The files of the parts of a run: do they belong together?
module adfric_output_part_files
   use hdf5, only: hid_t
   use adfric_base_kinds, only: dp, i8
   use adfric_base_error, only: error_t, set_error, file_failure, input_failure
   use adfric_base_text, only: show_count
   use adfric_hdf5_calls, only: hdf5_calls_t
   use adfric_hdf5_file, only: open_file, close_file
   use adfric_hdf5_reading, only: read_attribute
   use adfric_describe_doubt, only: doubt_name, n_doubts
   use adfric_describe_status, only: n_status
   use adfric_output_datasets, only: datasets_t
   use adfric_output_heading, only: heading_t, read_heading, say_difference
   use adfric_output_layout, only: layout_t
   use adfric_output_part_layout, only: read_part_layout
   use adfric_output_seal, only: check_seal
   use adfric_run_blocks, only: blocks_t
   use adfric_system_files, only: kind_of_path, path_other
   implicit none (type, external)
   private
   public :: part_file_t, check_parts

   !> Number of points whose states are read at once.
   integer, parameter :: points_at_once = 2**16

   !> The file of a part.
   type :: part_file_t
      !> Name of the file.
      character(:), allocatable :: path
      !> The blocks of the run, and which of them the part has.
      type(blocks_t) :: blocks
      !> How long its run took [s].
      real(dp) :: wall_seconds = 0
   end type part_file_t

contains

   !> Check that the files are complete, belong to one run, and are all of it.
   subroutine check_parts(parts, layout, heading, by_status, by_doubt, error)
      !> Files of the parts, given with their paths; their blocks and times are added.
      type(part_file_t), intent(inout) :: parts(:)
      !> Layout of the first file.
      type(layout_t), intent(out) :: layout
      !> Heading of the first file.
      type(heading_t), intent(out) :: heading
      !> Receives the number of points of each status; shape `(0:n_status - 1)`.
      integer(i8), intent(out) :: by_status(0:)
      !> Receives the number of points of each doubt; shape `(0:n_doubts)`.
      integer(i8), intent(out) :: by_doubt(0:)
      !> Not allocated if the files are the whole of one run.
      type(error_t), allocatable, intent(out) :: error
      type(layout_t) :: other
      type(heading_t) :: other_heading
      integer, allocatable :: index_of(:)
      integer :: i

      by_status = 0
      by_doubt = 0
      allocate (index_of(0))
      do i = 1, size(parts)
         if (i == 1) then
            call check_part(parts(i), layout, heading, by_status, by_doubt, error)
         else
            call check_part(parts(i), other, other_heading, by_status, by_doubt, error)
            if (.not. allocated(error)) call compare(parts(i), parts(1), other_heading, heading, error)
         end if
         if (allocated(error)) return
         associate (part => parts(i)%blocks%part)
            if (i == 1) index_of = spread(0, 1, part%of)
            if (index_of(part%number) > 0) then
               call set_error(error, input_failure, parts(i)%path//': part '//show_count(part%number)//' of '//show_count(part%of) &
                  //' is given twice, also as '//parts(index_of(part%number))%path)
               return
            end if
            index_of(part%number) = i
         end associate
      end do
      if (any(index_of == 0)) call set_error(error, input_failure, parts(1)%path//': '//show_count(count(index_of == 0)) &
         //' of '//show_count(size(index_of))//' parts are missing: '//list_missing(index_of))
   end subroutine check_parts

   !> Check one file: is it a part, and complete?
   subroutine check_part(part, layout, heading, by_status, by_doubt, error)
      !> File of the part, given with its path; its blocks and its time are added.
      type(part_file_t), intent(inout) :: part
      type(layout_t), intent(out) :: layout
      type(heading_t), intent(out) :: heading
      !> Number of points of each status, to which those of the part are added; shape `(0:n_status - 1)`.
      integer(i8), intent(inout) :: by_status(0:)
      !> Number of points of each doubt, to which those of the part are added; shape `(0:n_doubts)`.
      integer(i8), intent(inout) :: by_doubt(0:)
      !> Not allocated if the file is that of a part, and complete.
      type(error_t), allocatable, intent(out) :: error
      type(hdf5_calls_t) :: calls
      integer(hid_t) :: file
      integer(i8) :: n_missing

      n_missing = 0
      if (kind_of_path(part%path) == path_other) then
         call set_error(error, file_failure, part%path//': cannot read: this is no regular file')
         return
      end if
      call check_seal(part%path, error)
      if (allocated(error)) return
      call open_file(calls, part%path, .false., file)
      call read_heading(calls, file, heading)
      if (calls%is_good() .and. len(heading%hash) > 0) call read_part_layout(calls, file, layout)
      part%blocks = layout%blocks
      if (.not. layout%blocks%part%is_whole()) then
         call read_attribute(calls, file, 'wall_seconds', part%wall_seconds)
         call count_points(calls, file, layout, by_status, by_doubt, n_missing)
      end if
      call close_file(calls, file)
      call calls%get_error(part%path//': cannot read', error)
      if (allocated(error)) return
      if (layout%blocks%part%is_whole()) then
         call set_error(error, input_failure, part%path//': this is no part of a run, as adfric run --shard makes them')
      else if (n_missing > 0) then
         call set_error(error, input_failure, part%path//': this part is not complete, '//show_count(n_missing)//' of its ' &
            //show_count(layout%blocks%n_points())//' points are missing; adfric run --resume --shard ' &
            //show_count(layout%blocks%part%number)//'/'//show_count(layout%blocks%part%of)//' goes on with it')
      end if
   end subroutine check_part

   !> Count the points of a part by status and doubt.
   subroutine count_points(calls, file, layout, by_status, by_doubt, n_missing)
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the open file of the part.
      integer(hid_t), intent(in) :: file
      type(layout_t), intent(in) :: layout
      integer(i8), intent(inout) :: by_status(0:), by_doubt(0:)
      !> Number of points that have no results yet.
      integer(i8), intent(out) :: n_missing
      type(datasets_t) :: datasets
      integer, allocatable :: states(:)
      integer(i8) :: row, n_points
      integer :: i, k

      n_missing = 0
      n_points = layout%blocks%n_points()
      call datasets%open(calls, file, layout)
      do row = 1, n_points, points_at_once
         allocate (states(min(int(points_at_once, i8), n_points - row + 1)))
         call datasets%read_status(calls, layout, row, states)
         do k = 0, n_status - 1
            by_status(k) = by_status(k) + count(states == k)
         end do
         n_missing = n_missing + count(states < 0)
         do i = 1, size(layout%fields)
            if (layout%fields(i)%name /= doubt_name) cycle
            call datasets%read_states(calls, layout, i, row, states)
            do k = 0, n_doubts
               by_doubt(k) = by_doubt(k) + count(states == k)
            end do
         end do
         deallocate (states)
      end do
      call datasets%close(calls)
   end subroutine count_points

   !> Do two files belong to one run?
   subroutine compare(part, first, heading, first_heading, error)
      type(part_file_t), intent(in) :: part, first
      !> Heading of `part`.
      type(heading_t), intent(in) :: heading
      !> Heading of `first`.
      type(heading_t), intent(in) :: first_heading
      !> Not allocated if the files belong to one run.
      type(error_t), allocatable, intent(out) :: error

      if (len(say_difference(heading, first_heading)) > 0) then
         call set_error(error, input_failure, part%path//': does not belong to the run of '//first%path//': ' &
            //say_difference(heading, first_heading))
      else if (part%blocks%part%of /= first%blocks%part%of) then
         call set_error(error, input_failure, part%path//': one of '//show_count(part%blocks%part%of)//' parts, but ' &
            //first%path//' is one of '//show_count(first%blocks%part%of))
      end if
   end subroutine compare

   !> Numbers of the missing parts, as far as they fit on a line.
   function list_missing(index_of) result(text)
      !> Index of each part among the files, from 1; 0 where a part is missing.
      integer, intent(in) :: index_of(:)
      character(:), allocatable :: text
      integer, parameter :: most = 100
      integer :: i, n

      text = ''
      n = 0
      do i = 1, size(index_of)
         if (index_of(i) > 0) cycle
         n = n + 1
         if (n > most) then
            text = text//', ...'
            return
         end if
         if (n > 1) text = text//', '
         text = text//show_count(i)
      end do
   end function list_missing

end module adfric_output_part_files
