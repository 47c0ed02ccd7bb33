! SPDX-License-Identifier: GPL-3.0-or-later
!> Scalar datasets with what has one value in a whole run.
module adfric_output_constant_datasets
   use, intrinsic :: iso_fortran_env, only: int8
   use hdf5, only: hid_t
   use adfric_base_kinds, only: dp, i8
   use adfric_base_words, only: count_words, get_word
   use adfric_hdf5_attributes, only: write_attribute
   use adfric_hdf5_calls, only: hdf5_calls_t
   use adfric_hdf5_datasets, only: create_space, create_real_dataset, create_state_dataset, write_values, &
      close_dataset
   use adfric_hdf5_reading, only: read_attribute, open_dataset, read_values
   use adfric_output_constants, only: constant_t
   use adfric_output_flags, only: write_flags, read_flags
   implicit none (type, external)
   private
   public :: create_constants, read_constants, list_constants

   !> Shape of a scalar.
   integer(i8), parameter :: scalar(0) = [integer(i8) ::]

contains

   !> Create the datasets with their values.
   subroutine create_constants(calls, file, constants)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      !> What has one value in the run; a dataset of its name is made for each.
      type(constant_t), intent(in) :: constants(:)
      integer(hid_t) :: dataset, space
      integer :: i

      call create_space(calls, scalar, space)
      do i = 1, size(constants)
         associate (constant => constants(i))
            if (len(constant%flag_meanings) == 0) then
               call create_real_dataset(calls, file, constant%name, space, dataset)
               call write_values(calls, dataset, space, space, [constant%value])
            else
               call create_state_dataset(calls, file, constant%name, space, dataset)
               call write_values(calls, dataset, space, space, [nint(constant%value, int8)])
            end if
            call write_flags(calls, dataset, constant%first_flag, constant%flag_meanings)
            call write_attribute(calls, dataset, 'units', constant%unit)
            call write_attribute(calls, dataset, 'long_name', constant%long_name)
            call close_dataset(calls, dataset)
         end associate
      end do
      call calls%close_id(space)
   end subroutine create_constants

   !> Read constants with their values.
   subroutine read_constants(calls, file, names, constants)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      !> Names of the constants, separated by a blank.
      character(*), intent(in) :: names
      !> The constants in the order of the names, with all that the file says of them.
      type(constant_t), allocatable, intent(out) :: constants(:)
      integer(hid_t) :: dataset, space
      real(dp) :: number(1)
      integer :: i

      allocate (constants(count_words(names)))
      call create_space(calls, scalar, space)
      do i = 1, size(constants)
         associate (constant => constants(i))
            constant%name = get_word(names, i)
            call open_dataset(calls, file, constant%name, dataset)
            call read_attribute(calls, dataset, 'units', constant%unit)
            call read_attribute(calls, dataset, 'long_name', constant%long_name)
            call read_flags(calls, dataset, constant%first_flag, constant%flag_meanings)
            ! a small integer is read as the number that it is
            number = 0
            call read_values(calls, dataset, space, space, number)
            constant%value = number(1)
            call close_dataset(calls, dataset)
         end associate
      end do
      call calls%close_id(space)
   end subroutine read_constants

   !> Names of constants, separated by a blank.
   pure function list_constants(constants) result(names)
      type(constant_t), intent(in) :: constants(:)
      character(:), allocatable :: names
      integer :: i

      names = ''
      do i = 1, size(constants)
         names = names//' '//constants(i)%name
      end do
      names = trim(adjustl(names))
   end function list_constants

end module adfric_output_constant_datasets
