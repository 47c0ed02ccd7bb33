!> The dataset with the checksums of the blocks of a results file.
module adfric_output_sums_dataset
   use hdf5, only: hid_t
   use adfric_base_kinds, only: i8
   use adfric_output_field_dataset, only: count_group
   use adfric_output_hdf5_layer_attributes, only: write_attribute
   use adfric_output_hdf5_layer_calls, only: hdf5_calls_t, no_id
   use adfric_output_hdf5_layer_datasets, only: create_integer_dataset, create_space, select_box, write_values, close_dataset
   use adfric_output_hdf5_layer_reading, only: open_dataset, read_values
   implicit none (type, external)
   private
   public :: sums_dataset_t

   !> Its path.
   character(*), parameter :: name = count_group//'/checksum'

   !> The dataset, open. Places are those of blocks in the file, from 1.
   type :: sums_dataset_t
      !> Its id, and that of its space.
      integer(hid_t) :: id = no_id
      integer(hid_t), private :: space = no_id
   contains
      procedure :: create
      procedure :: open => open_sums
      procedure :: write => write_sums
      procedure :: read => read_sums
      procedure :: close => close_sums
   end type sums_dataset_t

contains

   !> Create it.
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

   !> Open it.
   subroutine open_sums(self, calls, file, n_blocks)
      class(sums_dataset_t), intent(inout) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      !> Number of blocks of the file.
      integer(i8), intent(in) :: n_blocks

      call create_space(calls, [n_blocks], self%space)
      call open_dataset(calls, file, name, self%id)
   end subroutine open_sums

   !> Write the checksums of neighbouring blocks.
   subroutine write_sums(self, calls, place, sums)
      class(sums_dataset_t), intent(in) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      !> Place of the first block.
      integer(i8), intent(in) :: place
      integer(i8), intent(in), contiguous :: sums(:)
      integer(hid_t) :: memory_space

      if (size(sums) == 0) return
      call select_blocks(self, calls, place, size(sums, kind=i8), memory_space)
      call write_values(calls, self%id, memory_space, self%space, sums)
      call calls%close_id(memory_space)
   end subroutine write_sums

   !> Read the checksums of neighbouring blocks.
   subroutine read_sums(self, calls, place, sums)
      class(sums_dataset_t), intent(in) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      !> Place of the first block.
      integer(i8), intent(in) :: place
      integer(i8), intent(out), contiguous :: sums(:)
      integer(hid_t) :: memory_space

      sums = 0
      if (size(sums) == 0) return
      call select_blocks(self, calls, place, size(sums, kind=i8), memory_space)
      call read_values(calls, self%id, memory_space, self%space, sums)
      call calls%close_id(memory_space)
   end subroutine read_sums

   !> Select neighbouring blocks.
   subroutine select_blocks(self, calls, place, n, memory_space)
      class(sums_dataset_t), intent(in) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      !> Place of the first block, and how many they are.
      integer(i8), intent(in) :: place, n
      !> A space of as many values, to be closed by the caller.
      integer(hid_t), intent(out) :: memory_space

      call create_space(calls, [n], memory_space)
      call select_box(calls, self%space, [place - 1], [n])
   end subroutine select_blocks

   !> Close it.
   subroutine close_sums(self, calls)
      class(sums_dataset_t), intent(inout) :: self
      type(hdf5_calls_t), intent(inout) :: calls

      call close_dataset(calls, self%id)
      call calls%close_id(self%space)
   end subroutine close_sums

end module adfric_output_sums_dataset
