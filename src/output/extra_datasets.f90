! SPDX-License-Identifier: GPL-3.0-or-later
!> Datasets of any shape, whose values are known when the results file is created.
module adfric_output_extra_datasets
   use hdf5, only: hid_t
   use adfric_base_kinds, only: i8
   use adfric_base_words, only: count_words, get_word
   use adfric_hdf5_attributes, only: write_attribute
   use adfric_hdf5_calls, only: hdf5_calls_t
   use adfric_hdf5_datasets, only: create_space, create_real_dataset, create_state_dataset, write_values, &
      close_dataset, make_scale, attach_scale, to_state
   use adfric_hdf5_reading, only: open_dataset
   use adfric_hdf5_words, only: create_word_dataset
   use adfric_describe_table, only: extra_t
   use adfric_output_constants, only: file_unit
   use adfric_output_flags, only: write_flags
   implicit none (type, external)
   private
   public :: create_extras

contains

   !> Create the datasets with their values: the scales first, to which the others are attached.
   subroutine create_extras(calls, file, extras)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      !> The datasets. A scale has its own name for its dimension; each dimension of the others is one of these.
      type(extra_t), intent(in) :: extras(:)
      integer :: i, pass
      logical :: is_scale

      do pass = 1, 2
         do i = 1, size(extras)
            is_scale = extras(i)%dimensions == extras(i)%name
            if (is_scale .eqv. pass == 1) call create_extra(calls, file, extras(i), is_scale)
         end do
      end do
   end subroutine create_extras

   !> Create one of them.
   subroutine create_extra(calls, file, extra, is_scale)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      type(extra_t), intent(in) :: extra
      !> Is it the scale of a dimension?
      logical, intent(in) :: is_scale
      integer(hid_t) :: dataset, space, scale
      integer :: k

      if (allocated(extra%words)) then
         call create_word_dataset(calls, file, extra%name, extra%words, dataset)
      else
         call create_space(calls, int(extra%counts, i8), space)
         if (allocated(extra%flag_meanings)) then
            call create_state_dataset(calls, file, extra%name, space, dataset)
            call write_values(calls, dataset, space, space, to_state(extra%values))
            call write_flags(calls, dataset, extra%first_flag, extra%flag_meanings)
         else
            call create_real_dataset(calls, file, extra%name, space, dataset)
            call write_values(calls, dataset, space, space, extra%values)
         end if
         call calls%close_id(space)
      end if
      call write_attribute(calls, dataset, 'units', file_unit(extra%unit))
      call write_attribute(calls, dataset, 'long_name', extra%long_name)
      if (is_scale) then
         call make_scale(calls, dataset, extra%name)
      else
         do k = 1, count_words(extra%dimensions)
            call open_dataset(calls, file, get_word(extra%dimensions, k), scale)
            call attach_scale(calls, dataset, scale, k)
            call close_dataset(calls, scale)
         end do
      end if
      call close_dataset(calls, dataset)
   end subroutine create_extra

end module adfric_output_extra_datasets
