! SPDX-License-Identifier: GPL-3.0-or-later
!> A new dataset of a results file with all that describes it.
module adfric_output_field_dataset
   use hdf5, only: hid_t
   use adfric_base_kinds, only: i8
   use adfric_hdf5_attributes, only: write_attribute
   use adfric_hdf5_calls, only: hdf5_calls_t, no_id
   use adfric_hdf5_datasets, only: create_space, create_real_dataset, create_state_dataset, &
      write_values, close_dataset, make_scale, attach_scale
   use adfric_output_flags, only: write_flags
   use adfric_output_layout, only: scale_t, field_t, number_indices
   use adfric_output_virtual_parts, only: virtual_parts_t
   implicit none (type, external)
   private
   public :: field_form_t, create_scale, create_list, create_row, create_field, create_counts, count_group

   !> Group of what is known of each block.
   character(*), parameter :: count_group = 'blocks'

   !> What all results, or all profiles, of a file have in common.
   type :: field_form_t
      !> Space of the shape of the datasets.
      integer(hid_t) :: space = no_id
      !> Ids of the scales of the dimensions, from `first_dimension` on.
      integer(hid_t), allocatable :: scales(:)
      !> Number of the dimension of the first scale, from 1, the slowest first.
      integer :: first_dimension = 1
      !> Names of scalars that hold for all values, and of what changes in step with a scale, separated by a blank.
      character(:), allocatable :: coordinates
      !> Are these profiles? Else they are results.
      logical :: is_profile = .false.
   end type field_form_t

contains

   !> Create a scale with its values.
   subroutine create_scale(calls, file, scale, dataset)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      !> The scale: its name, its unit and its values.
      type(scale_t), intent(in) :: scale
      !> Id of the dataset, to be closed by the caller; `no_id` if a call has failed.
      integer(hid_t), intent(out) :: dataset
      integer(hid_t) :: space

      call create_space(calls, [size(scale%values, kind=i8)], space)
      call create_real_dataset(calls, file, scale%name, space, dataset)
      call write_attribute(calls, dataset, 'units', scale%unit)
      call write_attribute(calls, dataset, 'long_name', scale%long_name)
      call write_values(calls, dataset, space, space, scale%values)
      call make_scale(calls, dataset, scale%name)
      call calls%close_id(space)
   end subroutine create_scale

   !> Create the dataset of a list of numbers, and that of the indices of its numbers, which is the scale of its one dimension.
   subroutine create_list(calls, file, list)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      !> The list: its name, its unit and its numbers.
      type(scale_t), intent(in) :: list
      type(scale_t) :: indices
      integer(hid_t) :: scale

      call number_indices(list, indices)
      call create_scale(calls, file, indices, scale)
      call create_row(calls, file, list, scale)
      call close_dataset(calls, scale)
   end subroutine create_list

   !> Create a dataset of one dimension along a scale.
   subroutine create_row(calls, file, row, scale)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      !> The dataset: its name, its unit and its numbers.
      class(scale_t), intent(in) :: row
      !> Id of the scale of its dimension.
      integer(hid_t), intent(in) :: scale
      integer(hid_t) :: space, dataset

      call create_space(calls, [size(row%values, kind=i8)], space)
      call create_real_dataset(calls, file, row%name, space, dataset)
      call write_attribute(calls, dataset, 'units', row%unit)
      call write_attribute(calls, dataset, 'long_name', row%long_name)
      call write_values(calls, dataset, space, space, row%values)
      call attach_scale(calls, dataset, scale, 1)
      call calls%close_id(space)
      call close_dataset(calls, dataset)
   end subroutine create_row

   !> Create a dataset of a result or a profile.
   subroutine create_field(calls, file, field, form, dataset, parts)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      !> Name, unit and meanings of what stands in the dataset.
      type(field_t), intent(in) :: field
      !> Shape of the dataset, and what belongs to its dimensions.
      type(field_form_t), intent(in) :: form
      integer(hid_t), intent(out) :: dataset
      !> Files in which the values are; if absent the values are in this file.
      type(virtual_parts_t), intent(in), optional :: parts
      integer :: k

      if (present(parts)) then
         call parts%create_dataset(calls, file, field, form%is_profile, form%space, dataset)
      else if (len(field%flag_meanings) == 0) then
         call create_real_dataset(calls, file, field%name, form%space, dataset)
      else
         call create_state_dataset(calls, file, field%name, form%space, dataset)
      end if
      call write_flags(calls, dataset, field%first_flag, field%flag_meanings)
      call write_attribute(calls, dataset, 'units', field%unit)
      call write_attribute(calls, dataset, 'long_name', field%long_name)
      if (len(form%coordinates) > 0) call write_attribute(calls, dataset, 'coordinates', form%coordinates)
      do k = 1, size(form%scales)
         call attach_scale(calls, dataset, form%scales(k), form%first_dimension + k - 1)
      end do
   end subroutine create_field

   !> Create the datasets of what the model counts, in the group of what is known of each block.
   subroutine create_counts(calls, file, counts, space, datasets)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      type(field_t), intent(in) :: counts(:)
      !> Space with a index for each block of the file.
      integer(hid_t), intent(in) :: space
      !> Ids of the datasets, to be closed by the caller; shape `(n_counts)`.
      integer(hid_t), intent(inout) :: datasets(:)
      integer :: i

      do i = 1, size(counts)
         call create_real_dataset(calls, file, count_group//'/'//counts(i)%name, space, datasets(i))
         call write_attribute(calls, datasets(i), 'units', counts(i)%unit)
         call write_attribute(calls, datasets(i), 'long_name', counts(i)%long_name)
      end do
   end subroutine create_counts

end module adfric_output_field_dataset
