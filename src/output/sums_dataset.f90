! SPDX-License-Identifier: GPL-3.0-or-later
!> The dataset with the checksums of the blocks of a results file.
module adfric_output_sums_dataset
   use hdf5, only: hid_t
   use adfric_base_kinds, only: i8
   use adfric_hdf5_attributes, only: write_attribute
   use adfric_hdf5_calls, only: hdf5_calls_t, no_id
   use adfric_hdf5_datasets, only: create_integer_dataset, create_space, select_box, write_values, close_dataset
   use adfric_hdf5_reading, only: open_dataset, read_values
   use adfric_output_field_dataset, only: count_group
   implicit none (type, external)
   private
   public :: sums_dataset_t

   !> Path of the dataset in the file.
   character(*), parameter :: name = count_group//'/checksum'

   !> The dataset, open. Indices are those of blocks in the file, from 1.
   type :: sums_dataset_t
      !> Id of the dataset.
      integer(hid_t) :: id = no_id
      !> Id of its space.
      integer(hid_t), private :: space = no_id
   contains
      procedure :: create
      procedure :: open => open_sums
      procedure :: write => write_sums
      procedure :: read => read_sums
      procedure :: close => close_sums
   end type sums_dataset_t

contains

   !> Create the dataset.
   subroutine create(self, calls, file, n_blocks)
      class(sums_dataset_t), intent(inout) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      !> Number of blocks of the file.
      integer(i8), intent(in) :: n_blocks

      call create_space(calls, [n_blocks], self%space)
      call create_integer_dataset(calls, file, name, self%space, self%id)
      call write_attribute(calls, self%id, 'units', '1')
      call write_attribute(calls, self%id, 'long_name', 'checksum of what stands in this file for the points of a block')
   end subroutine create

   !> Open the dataset of a file that has one.
   subroutine open_sums(self, calls, file, n_blocks)
      class(sums_dataset_t), intent(inout) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      integer(i8), intent(in) :: n_blocks

      call create_space(calls, [n_blocks], self%space)
      call open_dataset(calls, file, name, self%id)
   end subroutine open_sums

   !> Write the checksums of neighbouring blocks.
   subroutine write_sums(self, calls, index, sums)
      class(sums_dataset_t), intent(in) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      !> Index of the first block in the file, from 1.
      integer(i8), intent(in) :: index
      !> Checksum of each block, from that index on.
      integer(i8), intent(in), contiguous :: sums(:)
      integer(hid_t) :: memory_space

      if (size(sums) == 0) return
      call select_blocks(self, calls, index, size(sums, kind=i8), memory_space)
      call write_values(calls, self%id, memory_space, self%space, sums)
      call calls%close_id(memory_space)
   end subroutine write_sums

   !> Read the checksums of neighbouring blocks.
   subroutine read_sums(self, calls, index, sums)
      class(sums_dataset_t), intent(in) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      integer(i8), intent(in) :: index
      !> Receives the checksum of each block, from that index on; 0 if a call has failed.
      integer(i8), intent(out), contiguous :: sums(:)
      integer(hid_t) :: memory_space

      sums = 0
      if (size(sums) == 0) return
      call select_blocks(self, calls, index, size(sums, kind=i8), memory_space)
      call read_values(calls, self%id, memory_space, self%space, sums)
      call calls%close_id(memory_space)
   end subroutine read_sums

   !> Select neighbouring blocks.
   subroutine select_blocks(self, calls, index, n, memory_space)
      !> The open dataset, in whose space the blocks are selected.
      class(sums_dataset_t), intent(in) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      integer(i8), intent(in) :: index, n
      !> Space of as many values as there are blocks; the caller closes it.
      integer(hid_t), intent(out) :: memory_space

      call create_space(calls, [n], memory_space)
      call select_box(calls, self%space, [index - 1], [n])
   end subroutine select_blocks

   !> Close the dataset and its space.
   subroutine close_sums(self, calls)
      class(sums_dataset_t), intent(inout) :: self
      !> Chain of HDF5 calls; the ids are closed even where one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls

      call close_dataset(calls, self%id)
      call calls%close_id(self%space)
   end subroutine close_sums

end module adfric_output_sums_dataset
