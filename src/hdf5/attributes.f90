! SPDX-License-Identifier: GPL-3.0-or-later
!> Attributes of HDF5 files and datasets.
module adfric_hdf5_attributes
   use, intrinsic :: iso_c_binding, only: c_char, c_loc, c_null_char, c_ptr
   use, intrinsic :: iso_fortran_env, only: int8
   use hdf5, only: hid_t, hsize_t, h5screate_f, h5screate_simple_f, h5acreate_f, h5aopen_f, h5awrite_f, &
      h5tcopy_f, h5tset_cset_f, h5kind_to_type, &
      H5S_SCALAR_F, H5T_STRING, H5T_CSET_UTF8_F, H5T_IEEE_F64LE, H5T_STD_I8LE, H5T_STD_I64LE, H5T_NATIVE_DOUBLE, &
      H5_INTEGER_KIND
   use adfric_base_kinds, only: dp, i8
   use adfric_hdf5_calls, only: hdf5_calls_t, no_id
   implicit none (type, external)
   private
   public :: write_attribute, replace_attribute

   !> Length of a scalar attribute.
   integer, parameter :: no_length = 0

   !> Write an attribute of a file or a dataset: a text, a number, an integer, or a row of small integers.
   interface write_attribute
      module procedure write_text
      module procedure write_real
      module procedure write_integer
      module procedure write_small_integers
   end interface write_attribute

contains

   !> Write a text of any length, in UTF-8.
   subroutine write_text(calls, index, name, text)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: index
      !> Name of the attribute, which does not exist yet.
      character(*), intent(in) :: name
      !> Text of any length, the empty one too.
      character(*), intent(in) :: text
      !> Allocated, since a whole input may not fit on the stack.
      character(kind=c_char, len=:), allocatable, target :: buffer
      type(c_ptr), target :: pointer_to_text(1)
      integer(hid_t) :: type_id

      type_id = no_id
      buffer = text//c_null_char
      pointer_to_text(1) = c_loc(buffer)
      if (calls%is_good()) then
         call h5tcopy_f(H5T_STRING, type_id, calls%status)
         call calls%check()
      end if
      if (calls%is_good()) then
         call h5tset_cset_f(type_id, H5T_CSET_UTF8_F, calls%status)
         call calls%check()
      end if
      call write_any(calls, index, name, type_id, type_id, no_length, c_loc(pointer_to_text))
      call calls%close_id(type_id)
   end subroutine write_text

   !> Write a number.
   subroutine write_real(calls, index, name, number)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: index
      character(*), intent(in) :: name
      !> Number that is written in 8 bytes.
      real(dp), intent(in) :: number
      real(dp), target :: buffer

      buffer = number
      call write_any(calls, index, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, no_length, c_loc(buffer))
   end subroutine write_real

   !> Write an integer.
   subroutine write_integer(calls, index, name, number)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: index
      character(*), intent(in) :: name
      !> Integer that is written in 8 bytes.
      integer(i8), intent(in) :: number
      integer(i8), target :: buffer

      buffer = number
      call write_any(calls, index, name, H5T_STD_I64LE, h5kind_to_type(i8, H5_INTEGER_KIND), no_length, c_loc(buffer))
   end subroutine write_integer

   !> Write a number over that of an attribute that exists: the file keeps its form.
   subroutine replace_attribute(calls, index, name, number)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the file or the dataset.
      integer(hid_t), intent(in) :: index
      !> Name of the attribute, a number that exists.
      character(*), intent(in) :: name
      !> Number that replaces the former one.
      real(dp), intent(in) :: number
      real(dp), target :: buffer
      integer(hid_t) :: attribute

      buffer = number
      attribute = no_id
      if (calls%is_good()) then
         call h5aopen_f(index, name, attribute, calls%status)
         call calls%check()
      end if
      if (calls%is_good()) then
         call h5awrite_f(attribute, H5T_NATIVE_DOUBLE, c_loc(buffer), calls%status)
         call calls%check()
      end if
      call calls%close_id(attribute)
   end subroutine replace_attribute

   !> Write a row of small integers.
   subroutine write_small_integers(calls, index, name, numbers)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: index
      character(*), intent(in) :: name
      !> Integers that are written in a byte each, in a row.
      integer(int8), intent(in) :: numbers(:)
      integer(int8), target :: buffer(size(numbers))

      buffer = numbers
      call write_any(calls, index, name, H5T_STD_I8LE, h5kind_to_type(int8, H5_INTEGER_KIND), &
         size(numbers), c_loc(buffer))
   end subroutine write_small_integers

   !> Write an attribute of any type.
   subroutine write_any(calls, index, name, file_type, memory_type, length, address)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: index
      character(*), intent(in) :: name
      !> HDF5 type of the values in the file.
      integer(hid_t), intent(in) :: file_type
      !> HDF5 type of the values in the memory.
      integer(hid_t), intent(in) :: memory_type
      !> Number of values; `no_length` for a scalar.
      integer, intent(in) :: length
      type(c_ptr), intent(in) :: address
      integer(hid_t) :: space, attribute

      space = no_id
      attribute = no_id
      if (calls%is_good()) then
         if (length == no_length) then
            call h5screate_f(H5S_SCALAR_F, space, calls%status)
         else
            call h5screate_simple_f(1, [int(length, hsize_t)], space, calls%status)
         end if
         call calls%check()
      end if
      if (calls%is_good()) then
         call h5acreate_f(index, name, file_type, space, attribute, calls%status)
         call calls%check()
      end if
      if (calls%is_good()) then
         call h5awrite_f(attribute, memory_type, address, calls%status)
         call calls%check()
      end if
      call calls%close_id(attribute)
      call calls%close_id(space)
   end subroutine write_any

end module adfric_hdf5_attributes
