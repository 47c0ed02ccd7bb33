! SPDX-License-Identifier: GPL-3.0-or-later
!> Attributes of a results file that are known at the end of its run: how long it took, and means over its points.
module adfric_output_means
   use hdf5, only: hid_t
   use adfric_base_kinds, only: dp, i8
   use adfric_hdf5_attributes, only: write_attribute, replace_attribute
   use adfric_hdf5_calls, only: hdf5_calls_t
   use adfric_output_datasets, only: datasets_t
   use adfric_output_layout, only: layout_t
   use adfric_output_seal, only: placeholder
   implicit none (type, external)
   private
   public :: write_placeholders, n_placeholders, write_seconds, write_means

   !> Number of blocks whose counts are read at once.
   integer, parameter :: blocks_at_once = 4096

contains

   !> Number of the attributes that are known at the end of a run.
   pure integer function n_placeholders(layout)
      type(layout_t), intent(in) :: layout

      n_placeholders = 1 + size(layout%counts)
   end function n_placeholders

   !> Make the attributes, each with a NaN of its own, so that the file keeps its form from now on.
   subroutine write_placeholders(calls, file, layout)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      type(layout_t), intent(in) :: layout
      integer :: i

      call write_attribute(calls, file, 'wall_seconds', placeholder(1))
      do i = 1, size(layout%counts)
         call write_attribute(calls, file, layout%counts(i)%name, placeholder(1 + i))
      end do
   end subroutine write_placeholders

   !> Write how long the run took.
   subroutine write_seconds(calls, file, seconds)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      !> Time that the run took, with that before it was stopped [s].
      real(dp), intent(in) :: seconds

      call replace_attribute(calls, file, 'wall_seconds', seconds)
   end subroutine write_seconds

   !> Write the means over the points of what the model counts. The sums are taken in the order of the blocks.
   subroutine write_means(calls, file, layout, datasets)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      type(layout_t), intent(in) :: layout
      !> The open datasets of the file, whose counts are read.
      type(datasets_t), intent(in) :: datasets
      real(dp), allocatable :: counts(:, :)
      real(dp) :: sums(size(layout%counts))
      integer(i8) :: index, n_blocks
      integer :: i

      sums = 0
      n_blocks = layout%blocks%n_blocks()
      if (size(sums) == 0 .or. n_blocks == 0) return
      do index = 1, n_blocks, blocks_at_once
         allocate (counts(min(int(blocks_at_once, i8), n_blocks - index + 1), size(sums)))
         call datasets%read_counts(calls, index, counts)
         do i = 1, size(counts, 1)
            sums = sums + counts(i, :)
         end do
         deallocate (counts)
      end do
      do i = 1, size(sums)
         call replace_attribute(calls, file, layout%counts(i)%name, sums(i)/real(layout%blocks%n_points(), dp))
      end do
   end subroutine write_means

end module adfric_output_means
