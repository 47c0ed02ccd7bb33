! SPDX-License-Identifier: GPL-3.0-or-later
!> What the file of a part says of itself, so that the parts can be put together without the input and the model.
module adfric_output_part_layout
   use hdf5, only: hid_t
   use adfric_base_kinds, only: dp, i8
   use adfric_base_text, only: show_count
   use adfric_base_words, only: count_words, get_word
   use adfric_hdf5_attributes, only: write_attribute
   use adfric_hdf5_calls, only: hdf5_calls_t
   use adfric_hdf5_datasets, only: create_space, close_dataset
   use adfric_hdf5_reading, only: has_attribute, read_attribute, open_dataset, n_values_of, read_values
   use adfric_output_constant_datasets, only: list_constants, read_constants
   use adfric_output_field_dataset, only: count_group
   use adfric_output_flags, only: read_flags
   use adfric_output_layout, only: layout_t, scale_t, companion_t, field_t, set_status_fields
   use adfric_run_blocks, only: part_t, new_blocks
   implicit none (type, external)
   private
   public :: write_part_layout, read_part_layout

contains

   !> Write which part it is, and the names of its datasets in their order.
   subroutine write_part_layout(calls, file, layout)
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the open file of the part.
      integer(hid_t), intent(in) :: file
      type(layout_t), intent(in) :: layout

      call write_attribute(calls, file, 'part', int(layout%blocks%part%number, i8))
      call write_attribute(calls, file, 'parts', int(layout%blocks%part%of, i8))
      call write_attribute(calls, file, 'points_of_run', layout%blocks%n_points_of_run)
      call write_attribute(calls, file, 'points_of_block', int(layout%blocks%size, i8))
      call write_attribute(calls, file, 'constants', list_constants(layout%constants))
      call write_attribute(calls, file, 'lists', list_scales(layout%lists))
      call write_attribute(calls, file, 'axes', list_scales(layout%axes))
      call write_attribute(calls, file, 'companions', list_companions(layout, with_axes=.false.))
      call write_attribute(calls, file, 'companion_axes', list_companions(layout, with_axes=.true.))
      call write_attribute(calls, file, 'profile_axes', list_scales(layout%profile_axes))
      call write_attribute(calls, file, 'fields', list_fields(layout%fields))
      call write_attribute(calls, file, 'profiles', list_fields(layout%profiles))
      call write_attribute(calls, file, 'counts', list_fields(layout%counts))
   end subroutine write_part_layout

   !> Read the layout of a part; one that is `is_whole` if the file is not that of a part.
   subroutine read_part_layout(calls, file, layout)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      !> Receives the layout; its part is the whole run if the file is not that of a part.
      type(layout_t), intent(out) :: layout
      character(:), allocatable :: names
      integer(i8) :: number, n_parts, n_points, block_size

      if (.not. has_attribute(calls, file, 'parts')) return
      call read_attribute(calls, file, 'part', number)
      call read_attribute(calls, file, 'parts', n_parts)
      call read_attribute(calls, file, 'points_of_run', n_points)
      call read_attribute(calls, file, 'points_of_block', block_size)
      if (.not. calls%is_good() .or. number < 1 .or. number > n_parts .or. n_points < 1 .or. block_size < 1) return
      call new_blocks(layout%blocks, n_points, part_t(int(number), int(n_parts), .true.), int(block_size))
      call read_attribute(calls, file, 'constants', names)
      call read_constants(calls, file, names, layout%constants)
      ! parts of older programs have none
      names = ''
      if (has_attribute(calls, file, 'lists')) call read_attribute(calls, file, 'lists', names)
      call read_scales(calls, file, names, layout%lists)
      call read_attribute(calls, file, 'axes', names)
      call read_scales(calls, file, names, layout%axes)
      call read_companions(calls, file, layout%companions)
      call read_attribute(calls, file, 'profile_axes', names)
      call read_scales(calls, file, names, layout%profile_axes)
      call read_attribute(calls, file, 'fields', names)
      call read_fields(calls, file, '', names, layout%fields)
      if (size(layout%fields) > 1) then
         ! what the file says of its states
         names = layout%fields(size(layout%fields))%flag_meanings
         call set_status_fields(layout%fields(size(layout%fields) - 1:), names)
      end if
      call read_attribute(calls, file, 'profiles', names)
      call read_fields(calls, file, '', names, layout%profiles)
      call read_attribute(calls, file, 'counts', names)
      call read_fields(calls, file, count_group//'/', names, layout%counts)
   end subroutine read_part_layout

   !> Names of scales, separated by a blank.
   pure function list_scales(scales) result(names)
      !> Scales of the swept variables, or of the axes of profiles.
      type(scale_t), intent(in) :: scales(:)
      character(:), allocatable :: names
      integer :: i

      names = ''
      do i = 1, size(scales)
         names = names//' '//scales(i)%name
      end do
   end function list_scales

   !> Names of companions, or indices of their axes, separated by a blank.
   pure function list_companions(layout, with_axes) result(words)
      type(layout_t), intent(in) :: layout
      !> Are the indices of the axes wanted? Else it is the names.
      logical, intent(in) :: with_axes
      character(:), allocatable :: words
      integer :: i

      words = ''
      do i = 1, size(layout%companions)
         if (with_axes) then
            words = words//' '//show_count(layout%companions(i)%axis)
         else
            words = words//' '//layout%companions(i)%name
         end if
      end do
   end function list_companions

   !> Read what changes in step with the scales.
   subroutine read_companions(calls, file, companions)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      type(companion_t), allocatable, intent(out) :: companions(:)
      type(scale_t), allocatable :: scales(:)
      character(:), allocatable :: names, axes
      integer :: i, status

      ! parts of older programs have none
      names = ''
      axes = ''
      if (has_attribute(calls, file, 'companions')) then
         call read_attribute(calls, file, 'companions', names)
         call read_attribute(calls, file, 'companion_axes', axes)
      end if
      call read_scales(calls, file, names, scales)
      allocate (companions(size(scales)))
      do i = 1, size(scales)
         companions(i)%scale_t = scales(i)
         read (axes, *, iostat=status) companions(:i)%axis
         if (status /= 0) call calls%fail('it does not say along which dimensions its variables change')
      end do
   end subroutine read_companions

   !> Names of fields, separated by a blank.
   pure function list_fields(fields) result(names)
      type(field_t), intent(in) :: fields(:)
      character(:), allocatable :: names
      integer :: i

      names = ''
      do i = 1, size(fields)
         names = names//' '//fields(i)%name
      end do
   end function list_fields

   !> Read scales with their values.
   subroutine read_scales(calls, file, names, scales)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      !> Names of the scales, separated by a blank.
      character(*), intent(in) :: names
      !> Receives the scales with their values, in the order of the names.
      type(scale_t), allocatable, intent(out) :: scales(:)
      integer(hid_t) :: dataset, space
      integer(i8) :: n
      integer :: i

      allocate (scales(count_words(names)))
      do i = 1, size(scales)
         scales(i)%name = get_word(names, i)
         call open_dataset(calls, file, scales(i)%name, dataset)
         call read_attribute(calls, dataset, 'units', scales(i)%unit)
         call read_attribute(calls, dataset, 'long_name', scales(i)%long_name)
         n = n_values_of(calls, dataset)
         allocate (scales(i)%values(n), source=0.0_dp)
         call create_space(calls, [n], space)
         call read_values(calls, dataset, space, space, scales(i)%values)
         call calls%close_id(space)
         call close_dataset(calls, dataset)
      end do
   end subroutine read_scales

   !> Read what describes results, profiles or counts.
   subroutine read_fields(calls, file, folder, names, fields)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      !> Group in which the datasets stand, with a slash behind it; empty for the root of the file.
      character(*), intent(in) :: folder
      !> Names of the datasets, separated by a blank.
      character(*), intent(in) :: names
      !> Receives what the file says of each dataset, in the order of the names.
      type(field_t), allocatable, intent(out) :: fields(:)
      integer(hid_t) :: dataset
      integer :: i

      allocate (fields(count_words(names)))
      do i = 1, size(fields)
         fields(i)%name = get_word(names, i)
         fields(i)%column = i
         call open_dataset(calls, file, folder//fields(i)%name, dataset)
         call read_attribute(calls, dataset, 'units', fields(i)%unit)
         call read_attribute(calls, dataset, 'long_name', fields(i)%long_name)
         call read_flags(calls, dataset, fields(i)%first_flag, fields(i)%flag_meanings)
         call close_dataset(calls, dataset)
      end do
   end subroutine read_fields

end module adfric_output_part_layout
