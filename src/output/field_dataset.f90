!> A new dataset of a results file with all that describes it.
module adfric_output_field_dataset
   use hdf5, only: hid_t
   use adfric_base_kinds, only: i8
   use adfric_hdf5_attributes, only: write_attribute
   use adfric_hdf5_calls, only: hdf5_calls_t
   use adfric_hdf5_datasets, only: create_space, create_real_dataset, create_state_dataset, &
      write_values, make_scale, attach_scale
   use adfric_output_flags, only: write_flags
   use adfric_output_layout, only: scale_t, field_t
   use adfric_output_virtual_parts, only: virtual_parts_t
   implicit none (type, external)
   private
   public :: create_scale, create_field, create_counts, count_group

   !> Group of what is known of each block.
   character(*), parameter :: count_group = 'blocks'

contains

   !> Create a scale with its values.
   subroutine create_scale(calls, file, scale, dataset)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the open results file.
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

   !> Create a dataset of a result or a profile.
   subroutine create_field(calls, file, field, space, scales, first, coordinates, dataset, parts, is_profile)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the open results file.
      integer(hid_t), intent(in) :: file
      !> Name, unit and meanings of what stands in the dataset.
      type(field_t), intent(in) :: field
      !> Space of the dataset's shape.
      integer(hid_t), intent(in) :: space
      !> Ids of the scales of the dimensions, from dimension `first` on.
      integer(hid_t), intent(in) :: scales(:)
      !> Number of the dimension of the first scale, from 1, the slowest first.
      integer, intent(in) :: first
      !> Names of scalars that hold for all values of the dataset, separated by a blank.
      character(*), intent(in) :: coordinates
      !> Id of the dataset, to be closed by the caller; `no_id` if a call has failed.
      integer(hid_t), intent(out) :: dataset
      !> Files in which the values are; if absent the values are in this file.
      type(virtual_parts_t), intent(in), optional :: parts
      !> Present where the dataset is a profile, whatever its value.
      logical, intent(in), optional :: is_profile
      logical :: is_real
      integer :: k

      is_real = len(field%flag_meanings) == 0
      if (present(parts)) then
         call parts%create_dataset(calls, file, field%name, is_real, present(is_profile), space, dataset)
      else if (is_real) then
         call create_real_dataset(calls, file, field%name, space, dataset)
      else
         call create_state_dataset(calls, file, field%name, space, dataset)
      end if
      call write_flags(calls, dataset, field%first_flag, field%flag_meanings)
      call write_attribute(calls, dataset, 'units', field%unit)
      call write_attribute(calls, dataset, 'long_name', field%long_name)
      if (len(coordinates) > 0) call write_attribute(calls, dataset, 'coordinates', coordinates)
      do k = 1, size(scales)
         call attach_scale(calls, dataset, scales(k), first + k - 1)
      end do
   end subroutine create_field

   !> Create the datasets of what the model counts, in the group of what is known of each block.
   subroutine create_counts(calls, file, counts, space, datasets)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the open results file.
      integer(hid_t), intent(in) :: file
      !> Names of what the model counts.
      type(field_t), intent(in) :: counts(:)
      !> Space with a place for each block of the file.
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
