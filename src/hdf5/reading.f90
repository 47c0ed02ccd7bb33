! SPDX-License-Identifier: GPL-3.0-or-later
!> Read attributes and parts of datasets.
module adfric_hdf5_reading
   use, intrinsic :: iso_c_binding, only: c_char, c_f_pointer, c_loc, c_ptr, c_size_t
   use, intrinsic :: iso_fortran_env, only: int8
   use hdf5, only: hid_t, hsize_t, haddr_t, h5dget_offset_f, h5dget_storage_size_f, &
      h5aopen_f, h5aread_f, h5aexists_f, h5aget_type_f, h5aget_space_f, h5dvlen_reclaim_f, &
      h5dopen_f, h5dread_f, h5dget_space_f, h5sget_simple_extent_npoints_f, h5kind_to_type, &
      H5T_NATIVE_DOUBLE, H5_INTEGER_KIND, H5P_DEFAULT_F
   use adfric_base_kinds, only: dp, i8
   use adfric_hdf5_calls, only: hdf5_calls_t, no_id
   implicit none (type, external)
   private
   public :: has_attribute, read_attribute, open_dataset, n_values_of, read_values, get_extent

   !> Read an attribute: a text of variable length, a number, an integer, or as many small integers as there is space for.
   interface read_attribute
      module procedure read_text
      module procedure read_real
      module procedure read_integer
      module procedure read_small_integers
   end interface read_attribute

   !> Read values of a part of a dataset.
   interface read_values
      module procedure read_reals
      module procedure read_states
      module procedure read_integers
   end interface read_values

   interface
      !> Length of a C text without its null character.
      integer(c_size_t) function strlen(text) bind(c)
         import :: c_ptr, c_size_t
         implicit none (type, external)
         !> Address of the first letter.
         type(c_ptr), intent(in), value :: text
      end function strlen
   end interface

contains

   !> Is there an attribute of this name?
   logical function has_attribute(calls, index, name)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the file or the dataset.
      integer(hid_t), intent(in) :: index
      !> Name of the attribute.
      character(*), intent(in) :: name

      has_attribute = .false.
      if (.not. calls%is_good()) return
      call h5aexists_f(index, name, has_attribute, calls%status)
      call calls%check()
   end function has_attribute

   !> Open an attribute.
   subroutine open_attribute(calls, index, name, attribute)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: index
      character(*), intent(in) :: name
      !> Id of the attribute, to be closed by the caller; `no_id` if a call has failed.
      integer(hid_t), intent(out) :: attribute

      attribute = no_id
      if (.not. calls%is_good()) return
      call h5aopen_f(index, name, attribute, calls%status)
      call calls%check()
   end subroutine open_attribute

   !> Read an attribute of any type.
   subroutine read_any(calls, index, name, memory_type, address)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: index
      character(*), intent(in) :: name
      !> HDF5 type of the values in the memory.
      integer(hid_t), intent(in) :: memory_type
      !> Address of space for the values; left as it is if a call has failed.
      type(c_ptr), intent(in) :: address
      type(c_ptr) :: copy
      integer(hid_t) :: attribute

      copy = address
      call open_attribute(calls, index, name, attribute)
      if (calls%is_good()) then
         call h5aread_f(attribute, memory_type, copy, calls%status)
         call calls%check()
      end if
      call calls%close_id(attribute)
   end subroutine read_any

   !> Read a text; empty if there is none.
   subroutine read_text(calls, index, name, text)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: index
      character(*), intent(in) :: name
      !> Text of the attribute; empty if a call has failed.
      character(:), allocatable, intent(out) :: text
      type(c_ptr), target :: pointer_to_text(1)
      character(kind=c_char), pointer :: letters(:)
      type(c_ptr) :: address
      integer(hid_t) :: attribute, type_id, space
      integer :: i

      text = ''
      type_id = no_id
      space = no_id
      call open_attribute(calls, index, name, attribute)
      if (calls%is_good()) then
         call h5aget_type_f(attribute, type_id, calls%status)
         call calls%check()
      end if
      if (calls%is_good()) then
         call h5aget_space_f(attribute, space, calls%status)
         call calls%check()
      end if
      address = c_loc(pointer_to_text)
      if (calls%is_good()) then
         call h5aread_f(attribute, type_id, address, calls%status)
         call calls%check()
      end if
      if (calls%is_good()) then
         call c_f_pointer(pointer_to_text(1), letters, [strlen(pointer_to_text(1))])
         deallocate (text)
         allocate (character(size(letters)) :: text)
         do i = 1, size(letters)
            text(i:i) = letters(i)
         end do
         call h5dvlen_reclaim_f(type_id, space, H5P_DEFAULT_F, address, calls%status)
         call calls%check()
      end if
      call calls%close_id(space)
      call calls%close_id(type_id)
      call calls%close_id(attribute)
   end subroutine read_text

   !> Read a number.
   subroutine read_real(calls, index, name, number)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: index
      character(*), intent(in) :: name
      !> Number of the attribute; 0 if a call has failed.
      real(dp), intent(out) :: number
      real(dp), target :: buffer

      buffer = 0
      call read_any(calls, index, name, H5T_NATIVE_DOUBLE, c_loc(buffer))
      number = buffer
   end subroutine read_real

   !> Read an integer.
   subroutine read_integer(calls, index, name, number)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: index
      character(*), intent(in) :: name
      !> Integer of the attribute; 0 if a call has failed.
      integer(i8), intent(out) :: number
      integer(i8), target :: buffer

      buffer = 0
      call read_any(calls, index, name, h5kind_to_type(i8, H5_INTEGER_KIND), c_loc(buffer))
      number = buffer
   end subroutine read_integer

   !> Read small integers.
   subroutine read_small_integers(calls, index, name, numbers)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: index
      character(*), intent(in) :: name
      !> As many integers as the attribute has; all 0 if a call has failed.
      integer(int8), intent(out) :: numbers(:)
      integer(int8), target :: buffer(size(numbers))

      buffer = 0
      call read_any(calls, index, name, h5kind_to_type(int8, H5_INTEGER_KIND), c_loc(buffer))
      numbers = buffer
   end subroutine read_small_integers

   !> Open a dataset.
   subroutine open_dataset(calls, file, name, dataset)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the open file.
      integer(hid_t), intent(in) :: file
      !> Name of the dataset, with its group before it if it has one.
      character(*), intent(in) :: name
      !> Id of the dataset, to be closed by `close_dataset`; `no_id` if a call has failed.
      integer(hid_t), intent(out) :: dataset

      dataset = no_id
      if (.not. calls%is_good()) return
      call h5dopen_f(file, name, dataset, calls%status)
      call calls%check()
   end subroutine open_dataset

   !> Number of values of a dataset; 0 if a call has failed.
   integer(i8) function n_values_of(calls, dataset)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the open dataset.
      integer(hid_t), intent(in) :: dataset
      integer(hid_t) :: space
      integer(hsize_t) :: n

      n_values_of = 0
      if (.not. calls%is_good()) return
      call h5dget_space_f(dataset, space, calls%status)
      call calls%check()
      if (.not. calls%is_good()) return
      call h5sget_simple_extent_npoints_f(space, n, calls%status)
      ! it gives 0, or -1
      call calls%check()
      call calls%close_id(space)
      if (calls%is_good()) n_values_of = int(n, i8)
   end function n_values_of

   !> Read real numbers.
   subroutine read_reals(calls, dataset, memory_space, file_space, values)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: dataset
      !> Space of as many values as are read.
      integer(hid_t), intent(in) :: memory_space
      integer(hid_t), intent(in) :: file_space
      !> Numbers in the order of the file, the last dimension fastest; left as they are if a call has failed.
      real(dp), intent(inout), contiguous, target :: values(:)

      call read_at(calls, dataset, H5T_NATIVE_DOUBLE, memory_space, file_space, c_loc(values))
   end subroutine read_reals

   !> Read states.
   subroutine read_states(calls, dataset, memory_space, file_space, values)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: dataset, memory_space, file_space
      !> States in the order of the file, the last dimension fastest; left as they are if a call has failed.
      integer(int8), intent(inout), contiguous, target :: values(:)

      call read_at(calls, dataset, h5kind_to_type(int8, H5_INTEGER_KIND), memory_space, file_space, c_loc(values))
   end subroutine read_states

   !> Read integers.
   subroutine read_integers(calls, dataset, memory_space, file_space, values)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: dataset, memory_space, file_space
      !> Integers in the order of the file, the last dimension fastest; left as they are if a call has failed.
      integer(i8), intent(inout), contiguous, target :: values(:)

      call read_at(calls, dataset, h5kind_to_type(i8, H5_INTEGER_KIND), memory_space, file_space, c_loc(values))
   end subroutine read_integers

   !> Read values of any type.
   subroutine read_at(calls, dataset, memory_type, memory_space, file_space, address)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: dataset, memory_type, memory_space, file_space
      type(c_ptr), intent(in) :: address
      type(c_ptr) :: copy

      if (.not. calls%is_good()) return
      copy = address
      call h5dread_f(dataset, memory_type, copy, calls%status, memory_space, file_space)
      call calls%check()
   end subroutine read_at

   !> Where the values of a dataset stand in the file: first byte, from 0, and how many; none if they have no index of their own.
   subroutine get_extent(calls, dataset, first, n_bytes)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the open dataset.
      integer(hid_t), intent(in) :: dataset
      !> First byte of the values in the file, from 0; 0 if they have no index of their own.
      integer(i8), intent(out) :: first
      !> Number of bytes of the values; 0 if they have no index of their own.
      integer(i8), intent(out) :: n_bytes
      integer(hsize_t) :: size
      integer(haddr_t) :: offset

      first = 0
      n_bytes = 0
      if (.not. calls%is_good()) return
      ! that values have no index of their own is no failure
      call h5dget_storage_size_f(dataset, size, calls%status)
      if (calls%status < 0 .or. size == 0) return
      call h5dget_offset_f(dataset, offset, calls%status)
      if (calls%status < 0) return
      first = int(offset, i8)
      n_bytes = int(size, i8)
   end subroutine get_extent

end module adfric_hdf5_reading
