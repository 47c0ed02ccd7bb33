!> Write HDF5 files as a user's script would.
module data_file
   use, intrinsic :: iso_c_binding, only: c_loc, c_ptr
   use, intrinsic :: iso_fortran_env, only: int16, real32
   use hdf5
   use adfric_base_kinds, only: dp
   implicit none (type, external)
   private
   public :: new_data_file, add_reals, add_singles, add_integers, add_texts, add_group

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
