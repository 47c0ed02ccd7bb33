! SPDX-License-Identifier: GPL-3.0-or-later
!> Write HDF5 files as a user's script would.
module data_file
   use, intrinsic :: iso_c_binding, only: c_loc, c_null_char, c_ptr
   use, intrinsic :: iso_fortran_env, only: int16, real32
   use hdf5
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: new_data_file, add_reals, add_singles, add_integers, add_texts, add_group, add_label, add_number_label

contains

   !> An empty file; one that is there is replaced.
   subroutine new_data_file(path)
      character(*), intent(in) :: path
      integer(hid_t) :: file
      integer :: status

      call h5open_f(status)
      call h5fcreate_f(path, H5F_ACC_TRUNC_F, file, status)
      call h5fclose_f(file, status)
   end subroutine new_data_file

   !> A group.
   subroutine add_group(path, name)
      character(*), intent(in) :: path, name
      integer(hid_t) :: file, group
      integer :: status

      call h5fopen_f(path, H5F_ACC_RDWR_F, file, status)
      call h5gcreate_f(file, name, group, status)
      call h5gclose_f(group, status)
      call h5fclose_f(file, status)
   end subroutine add_group

   !> A dataset of 64-bit real numbers, of any number of dimensions.
   subroutine add_reals(path, name, values, counts)
      character(*), intent(in) :: path, name
      real(dp), intent(in) :: values(:)
      !> Along each dimension, the slowest first; size 0: a scalar.
      integer, intent(in) :: counts(:)
      real(dp), target :: buffer(max(1, size(values)))

      buffer = 0
      buffer(:size(values)) = values
      call add_any(path, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, counts, c_loc(buffer))
   end subroutine add_reals

   !> A dataset of 32-bit real numbers, the high bytes first.
   subroutine add_singles(path, name, values, counts)
      character(*), intent(in) :: path, name
      real(dp), intent(in) :: values(:)
      integer, intent(in) :: counts(:)
      real(real32), target :: buffer(size(values))

      buffer = real(values, real32)
      call add_any(path, name, H5T_IEEE_F32BE, H5T_NATIVE_REAL, counts, c_loc(buffer))
   end subroutine add_singles

   !> A dataset of 16-bit integers.
   subroutine add_integers(path, name, values, counts)
      character(*), intent(in) :: path, name
      integer, intent(in) :: values(:), counts(:)
      integer(int16), target :: buffer(size(values))

      buffer = int(values, int16)
      call add_any(path, name, H5T_STD_I16LE, h5kind_to_type(int16, H5_INTEGER_KIND), counts, c_loc(buffer))
   end subroutine add_integers

   !> A dataset of single letters.
   subroutine add_texts(path, name, letters)
      character(*), intent(in) :: path, name, letters
      character(len(letters)), target :: buffer

      buffer = letters
      call add_any(path, name, H5T_NATIVE_CHARACTER, H5T_NATIVE_CHARACTER, [len(letters)], c_loc(buffer))
   end subroutine add_texts

   !> A text as an attribute of a dataset or a group.
   subroutine add_label(path, name, label, text, is_fixed, n_texts)
      character(*), intent(in) :: path, name
      !> Name of the attribute.
      character(*), intent(in) :: label
      character(*), intent(in) :: text
      !> Has the text a fixed length in the file?
      logical, intent(in), optional :: is_fixed
      !> That many times the text, in a row; absent: a single one.
      integer, intent(in), optional :: n_texts
      character(len(text)), allocatable, target :: row(:)
      character(len(text) + 1), target :: letters
      type(c_ptr), allocatable, target :: pointers(:)
      integer(hid_t) :: type_id
      integer :: n, status
      logical :: fixed

      n = 1
      if (present(n_texts)) n = n_texts
      fixed = .false.
      if (present(is_fixed)) fixed = is_fixed
      allocate (row(n), pointers(n))
      row = text
      letters = text//c_null_char
      pointers = c_loc(letters)
      if (fixed) then
         call h5tcopy_f(H5T_FORTRAN_S1, type_id, status)
         call h5tset_size_f(type_id, int(len(text), size_t), status)
         call add_attribute(path, name, label, type_id, present(n_texts), n, c_loc(row))
      else
         call h5tcopy_f(H5T_STRING, type_id, status)
         call add_attribute(path, name, label, type_id, present(n_texts), n, c_loc(pointers))
      end if
      call h5tclose_f(type_id, status)
   end subroutine add_label

   !> A number as an attribute of a dataset or a group.
   subroutine add_number_label(path, name, label, number)
      character(*), intent(in) :: path, name
      !> Name of the attribute.
      character(*), intent(in) :: label
      real(dp), intent(in) :: number
      real(dp), target :: buffer

      buffer = number
      call add_attribute(path, name, label, H5T_NATIVE_DOUBLE, .false., 1, c_loc(buffer))
   end subroutine add_number_label

   !> An attribute of any type.
   subroutine add_attribute(path, name, label, type_id, is_row, n, address)
      character(*), intent(in) :: path, name, label
      integer(hid_t), intent(in) :: type_id
      !> Is it a row of n values, and not a single one?
      logical, intent(in) :: is_row
      integer, intent(in) :: n
      type(c_ptr), intent(in) :: address
      integer(hid_t) :: file, dataset, space, attribute
      type(c_ptr) :: buffer
      integer :: status

      buffer = address
      call h5fopen_f(path, H5F_ACC_RDWR_F, file, status)
      call h5oopen_f(file, name, dataset, status)
      if (is_row) then
         call h5screate_simple_f(1, [int(n, hsize_t)], space, status)
      else
         call h5screate_f(H5S_SCALAR_F, space, status)
      end if
      call h5acreate_f(dataset, label, type_id, space, attribute, status)
      if (n > 0) call h5awrite_f(attribute, type_id, buffer, status)
      call h5aclose_f(attribute, status)
      call h5sclose_f(space, status)
      call h5oclose_f(dataset, status)
      call h5fclose_f(file, status)
   end subroutine add_attribute

   !> A dataset of any type.
   subroutine add_any(path, name, file_type, memory_type, counts, address)
      character(*), intent(in) :: path, name
      integer(hid_t), intent(in) :: file_type, memory_type
      integer, intent(in) :: counts(:)
      type(c_ptr), intent(in) :: address
      integer(hid_t) :: file, space, dataset
      integer :: status

      call h5fopen_f(path, H5F_ACC_RDWR_F, file, status)
      if (size(counts) == 0) then
         call h5screate_f(H5S_SCALAR_F, space, status)
      else
         call h5screate_simple_f(size(counts), int(counts(size(counts):1:-1), hsize_t), space, status)
      end if
      call h5dcreate_f(file, name, file_type, space, dataset, status)
      if (product(counts) > 0) call h5dwrite_f(dataset, memory_type, address, status)
      call h5dclose_f(dataset, status)
      call h5sclose_f(space, status)
      call h5fclose_f(file, status)
   end subroutine add_any

end module data_file
