! SPDX-License-Identifier: GPL-3.0-or-later
!> Put the files of the parts of a run together: the file that the run would have written as a whole.
module adfric_output_merging
   use hdf5, only: hid_t
   use adfric_base_kinds, only: dp, i8
   use adfric_base_error, only: error_t
   use adfric_hdf5_calls, only: hdf5_calls_t
   use adfric_hdf5_file, only: open_file, close_file
   use adfric_describe_status, only: status_solved
   use adfric_output_datasets, only: datasets_t
   use adfric_output_heading, only: heading_t
   use adfric_output_layout, only: layout_t
   use adfric_output_part_files, only: part_file_t
   use adfric_output_results_file, only: results_file_t
   use adfric_output_virtual_parts, only: virtual_parts_t, new_virtual_parts
   use adfric_run_blocks, only: new_blocks
   use adfric_system_files, only: folder_of, path_from
   implicit none (type, external)
   private
   public :: write_merged

   !> Number of blocks that are copied at once.
   integer, parameter :: blocks_at_once = 16

contains

   !> Write the file of the whole run.
   subroutine write_merged(parts, layout, heading, path, overwrite, is_virtual, error)
      !> All parts of the run.
      type(part_file_t), intent(in) :: parts(:)
      !> Layout of any of the parts.
      type(layout_t), intent(in) :: layout
      !> Texts for the root of the file of the whole run.
      type(heading_t), intent(in) :: heading
      !> Name of the results file of the whole run.
      character(*), intent(in) :: path
      !> May a file of this name be replaced?
      logical, intent(in) :: overwrite
      !> Do the results stay in the files of the parts, to which the new file refers?
      logical, intent(in) :: is_virtual
      !> Not allocated if all went well.
      type(error_t), allocatable, intent(out) :: error
      type(layout_t) :: whole
      type(results_file_t) :: results
      logical :: refers
      integer :: i

      whole = layout
      call new_blocks(whole%blocks, layout%blocks%n_points_of_run, most=layout%blocks%size)
      ! HDF5 has no virtual scalars
      refers = is_virtual .and. size(whole%axes) > 0
      if (refers) then
         call create_virtual(parts, whole, heading, path, overwrite, results, error)
      else
         call results%create_from(path, overwrite, whole, heading, error)
      end if
      if (allocated(error)) return
      do i = 1, size(parts)
         call copy_part(parts(i), layout, refers, results, error)
         if (.not. allocated(error)) cycle
         call results%discard()
         return
      end do
      call results%finish(sum(parts%wall_seconds), error)
   end subroutine write_merged

   !> Create a file that refers to the parts.
   subroutine create_virtual(parts, whole, heading, path, overwrite, results, error)
      type(part_file_t), intent(in) :: parts(:)
      type(layout_t), intent(in) :: whole
      !> Texts for the root of the file of the whole run.
      type(heading_t), intent(in) :: heading
      !> Name of the results file of the whole run.
      character(*), intent(in) :: path
      !> May a file of this name be replaced?
      logical, intent(in) :: overwrite
      !> The file of the whole run, which is open afterwards.
      type(results_file_t), intent(inout) :: results
      type(error_t), allocatable, intent(out) :: error
      type(hdf5_calls_t) :: calls
      type(virtual_parts_t) :: virtual_parts
      character(:), allocatable :: name
      integer :: i

      call new_virtual_parts(virtual_parts, size(parts))
      call calls%open_library()
      do i = 1, size(parts)
         call path_from(folder_of(path), parts(i)%path, name, error)
         if (allocated(error)) exit
         call virtual_parts%add(calls, whole, parts(i)%blocks, name)
      end do
      if (.not. allocated(error)) call calls%get_error(path//': cannot refer to the parts', error)
      if (.not. allocated(error)) &
         call results%create_from(path, overwrite, whole, heading, error, virtual_parts)
      call virtual_parts%close(calls)
   end subroutine create_virtual

   !> Copy the results of a part.
   subroutine copy_part(part, layout, refers, results, error)
      type(part_file_t), intent(in) :: part
      type(layout_t), intent(in) :: layout
      !> Does the new file refer to the results of the parts? Then only counts and checksums are copied.
      logical, intent(in) :: refers
      !> The open file of the whole run.
      type(results_file_t), intent(inout) :: results
      type(error_t), allocatable, intent(out) :: error
      type(layout_t) :: own
      type(datasets_t) :: datasets
      type(hdf5_calls_t) :: calls, closing
      integer(hid_t) :: file
      integer(i8) :: index
      integer :: n

      own = layout
      own%blocks = part%blocks
      call open_file(calls, part%path, .false., file)
      call datasets%open(calls, file, own)
      index = 1
      do while (index <= own%blocks%n_blocks() .and. calls%is_good() .and. .not. allocated(error))
         n = int(min(own%blocks%n_neighbours(index), int(blocks_at_once, i8)))
         call copy_blocks(calls, datasets, own, index, n, refers, results, error)
         index = index + n
      end do
      if (.not. allocated(error)) call calls%get_error(part%path//': cannot read', error)
      call datasets%close(closing)
      call close_file(closing, file)
   end subroutine copy_part

   !> Copy neighbouring blocks of a part.
   subroutine copy_blocks(calls, datasets, layout, index, n_blocks, refers, results, error)
      type(hdf5_calls_t), intent(inout) :: calls
      type(datasets_t), intent(in) :: datasets
      type(layout_t), intent(in) :: layout
      !> Index of the first block in the file of the part, from 1.
      integer(i8), intent(in) :: index
      !> Number of blocks, neighbours in the run.
      integer, intent(in) :: n_blocks
      logical, intent(in) :: refers
      type(results_file_t), intent(inout) :: results
      type(error_t), allocatable, intent(out) :: error
      real(dp), allocatable :: numbers(:, :), error_estimate(:), counts(:, :), profiles(:, :, :)
      integer, allocatable :: status(:)
      integer(i8) :: row, first, sums(n_blocks)
      integer :: i, n

      row = (index - 1)*layout%blocks%size + 1
      first = layout%blocks%first_point(layout%blocks%block_at(index))
      n = int(min(int(n_blocks, i8)*layout%blocks%size, layout%blocks%n_points() - row + 1))
      allocate (counts(n_blocks, size(layout%counts)))
      call datasets%read_counts(calls, index, counts)
      call datasets%sums%read(calls, index, sums)
      if (refers) then
         if (calls%is_good()) call results%put_counts(first, counts, error)
         if (calls%is_good() .and. .not. allocated(error)) call results%put_known_sums(first, sums, error)
         return
      end if
      allocate (numbers(n, size(layout%fields) - 2), error_estimate(n), status(n))
      call datasets%read_results(calls, layout, row, numbers, error_estimate)
      call datasets%read_status(calls, layout, row, status)
      if (size(layout%profiles) > 0) then
         allocate (profiles(product(layout%profile_shape()), 1, size(layout%profiles)))
         do i = 1, n
            if (status(i) /= status_solved .or. .not. calls%is_good()) cycle
            call datasets%read_profiles(calls, layout, row + i - 1, profiles)
            if (calls%is_good()) call results%put_profiles(first + i - 1, profiles, error)
            if (allocated(error)) return
         end do
      end if
      if (calls%is_good()) call results%put(first, numbers, error_estimate, status, counts, error)
      if (.not. calls%is_good() .or. allocated(error)) return
      if (any(results%sums /= sums)) call calls%fail('it is damaged, its values are not those that were written')
   end subroutine copy_blocks

end module adfric_output_merging
