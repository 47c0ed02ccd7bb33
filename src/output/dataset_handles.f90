! SPDX-License-Identifier: GPL-3.0-or-later
!> The datasets of an open results file as HDF5 knows them: created or found, with their spaces, and closed.
!>
!> Every dataset has its full size from the start and holds NaN, or the state -1, where nothing has been written yet.
module adfric_output_dataset_handles
   use hdf5, only: hid_t
   use adfric_base_kinds, only: i8
   use adfric_hdf5_calls, only: hdf5_calls_t, no_id
   use adfric_hdf5_datasets, only: create_space, select_box, close_dataset
   use adfric_hdf5_reading, only: open_dataset, get_extent
   use adfric_base_boxes, only: box_t, next_box
   use adfric_output_constant_datasets, only: create_constants
   use adfric_output_extra_datasets, only: create_extras
   use adfric_output_field_dataset, only: field_form_t, create_scale, create_list, create_row, create_field, &
      create_counts, count_group
   use adfric_output_layout, only: layout_t
   use adfric_output_sums_dataset, only: sums_dataset_t
   use adfric_output_virtual_parts, only: virtual_parts_t
   implicit none (type, external)
   private
   public :: dataset_handles_t

   !> The datasets, in the order of the layout. Rows are indices of points in the file, from 1.
   type :: dataset_handles_t
      !> Spaces of the shape of a result, of a profile of all points, and of a count of all blocks.
      integer(hid_t) :: space = no_id, profile_space = no_id, count_space = no_id
      !> Scales with the values along a dimension, first of the points, then of the profiles; only when datasets are created.
      integer(hid_t), allocatable :: scales(:)
      !> Results, and last `error_estimate` and `status`.
      integer(hid_t), allocatable :: fields(:)
      !> Profiles.
      integer(hid_t), allocatable :: profiles(:)
      !> What the model counts.
      integer(hid_t), allocatable :: counts(:)
      !> Checksums of the blocks.
      type(sums_dataset_t) :: sums
   contains
      procedure :: create
      procedure :: open => open_all
      procedure :: select_rows
      procedure :: select_profile
      procedure :: select_blocks
      procedure :: get_extents
      procedure :: close => close_all
   end type dataset_handles_t

contains

   !> Create every dataset.
   subroutine create(self, calls, file, layout, parts)
      !> Nothing is open in it before; all datasets are open afterwards.
      class(dataset_handles_t), intent(inout) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      type(layout_t), intent(in) :: layout
      !> Files in which the values are; if absent the values are in this file.
      type(virtual_parts_t), intent(in), optional :: parts
      type(field_form_t) :: form
      integer :: i, n
      logical :: is_whole

      call prepare(self, calls, layout)
      n = size(layout%axes)
      do i = 1, n
         call create_scale(calls, file, layout%axes(i), self%scales(i))
      end do
      do i = 1, size(layout%companions)
         call create_row(calls, file, layout%companions(i), self%scales(layout%companions(i)%axis))
      end do
      do i = 1, size(layout%profile_axes)
         call create_scale(calls, file, layout%profile_axes(i), self%scales(n + i))
      end do
      call create_constants(calls, file, layout%constants)
      do i = 1, size(layout%lists)
         call create_list(calls, file, layout%lists(i))
      end do
      if (allocated(layout%extras)) call create_extras(calls, file, layout%extras)
      ! the points of a part stand in a row, along which there is no scale
      is_whole = layout%blocks%part%is_whole()
      form%coordinates = ''
      if (is_whole) form%coordinates = layout%list_coordinates()
      form%space = self%space
      form%scales = self%scales(:merge(n, 0, is_whole))
      do i = 1, size(self%fields)
         call create_field(calls, file, layout%fields(i), form, self%fields(i), parts)
      end do
      form%is_profile = .true.
      form%space = self%profile_space
      form%scales = self%scales(merge(1, n + 1, is_whole):)
      form%first_dimension = merge(1, 2, is_whole)
      do i = 1, size(self%profiles)
         call create_field(calls, file, layout%profiles(i), form, self%profiles(i), parts)
      end do
      call create_counts(calls, file, layout%counts, self%count_space, self%counts)
      call self%sums%create(calls, file, layout%blocks%n_blocks())
   end subroutine create

   !> Open every dataset of results.
   subroutine open_all(self, calls, file, layout)
      !> Nothing is open in it before; all datasets of results are open afterwards.
      class(dataset_handles_t), intent(inout) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
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

   !> Make space for the ids, and make the spaces.
   subroutine prepare(self, calls, layout)
      !> Gets space for the ids, all `no_id`, and its open spaces.
      class(dataset_handles_t), intent(inout) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      type(layout_t), intent(in) :: layout

      allocate (self%scales(size(layout%axes) + size(layout%profile_axes)), self%fields(size(layout%fields)), &
         self%profiles(size(layout%profiles)), self%counts(size(layout%counts)), source=no_id)
      call create_space(calls, layout%row_shape(), self%space)
      call create_space(calls, [layout%row_shape(), layout%profile_shape()], self%profile_space)
      call create_space(calls, [layout%blocks%n_blocks()], self%count_space)
   end subroutine prepare

   !> Select the next box of a row of points in the space of the results.
   subroutine select_rows(self, calls, layout, first, n_remaining, memory_space, n)
      class(dataset_handles_t), intent(in) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      type(layout_t), intent(in) :: layout
      !> Index of the first point in the file, from 1.
      integer(i8), intent(in) :: first
      integer, intent(in) :: n_remaining
      !> Space of as many values as the box has points; the caller closes it.
      integer(hid_t), intent(out) :: memory_space
      integer, intent(out) :: n
      type(box_t) :: box

      call next_box(layout%row_shape(), first - 1, int(n_remaining, i8), box)
      n = int(product(box%count))
      call create_space(calls, [int(n, i8)], memory_space)
      call select_box(calls, self%space, box%start, box%count)
   end subroutine select_rows

   !> Select a profile of a point in the space of the profiles.
   subroutine select_profile(self, calls, layout, row, n, memory_space)
      class(dataset_handles_t), intent(in) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      type(layout_t), intent(in) :: layout
      !> Index of the point in the file, from 1.
      integer(i8), intent(in) :: row
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

   !> Select neighbouring blocks in the space of the counts.
   subroutine select_blocks(self, calls, index, n, memory_space)
      class(dataset_handles_t), intent(in) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      !> Index of the first block in the file, from 1.
      integer(i8), intent(in) :: index
      integer, intent(in) :: n
      integer(hid_t), intent(out) :: memory_space

      call create_space(calls, [int(n, i8)], memory_space)
      call select_box(calls, self%count_space, [index - 1], [int(n, i8)])
   end subroutine select_blocks

   !> Where in the file values stand that are written while a run goes on; of size 0 for those that are elsewhere.
   subroutine get_extents(self, calls, extents)
      class(dataset_handles_t), intent(in) :: self
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

   !> Close every id.
   subroutine close_all(self, calls)
      !> The datasets and their spaces, none of which is open afterwards.
      class(dataset_handles_t), intent(inout) :: self
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

end module adfric_output_dataset_handles
