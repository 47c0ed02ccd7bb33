! SPDX-License-Identifier: GPL-3.0-or-later
!> Numbers from HDF5 files that others have written.
module adfric_hdf5_samples
   use, intrinsic :: iso_c_binding, only: c_loc, c_ptr
   use hdf5, only: hid_t, hsize_t, h5fis_hdf5_f, h5dopen_f, h5dget_type_f, h5dget_space_f, h5dread_f, h5tget_class_f, &
      h5sget_simple_extent_type_f, h5sget_simple_extent_ndims_f, h5sget_simple_extent_dims_f, &
      H5S_NULL_F, H5T_FLOAT_F, H5T_INTEGER_F, H5T_NATIVE_DOUBLE
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp, i8
   use adfric_hdf5_calls, only: hdf5_calls_t, no_id
   use adfric_hdf5_datasets, only: close_dataset
   use adfric_hdf5_file, only: open_source, close_file
   use adfric_hdf5_labels, only: read_label
   use adfric_hdf5_sources, only: check_sources
   use adfric_system_files, only: kind_of_path, path_free, path_file
   use adfric_system_memory, only: free_memory, has_space
   implicit none (type, external)
   private
   public :: read_numbers, open_foreign_file, get_extent, units_name, most_dimensions

   !> Attribute that says in which units the numbers are.
   character(*), parameter :: units_name = 'units'
   !> Most dimensions that HDF5 knows.
   integer, parameter :: most_dimensions = 32
   integer, parameter :: real_bytes = 8

contains

   !> Read a dataset of integers or real numbers of any size, of one or two dimensions.
   subroutine read_numbers(file, path, largest_rank, values, counts, units, flaw)
      !> Name of the file.
      character(*), intent(in) :: file
      !> Name of the dataset within the file, with its groups.
      character(*), intent(in) :: path
      !> Largest number of dimensions that the dataset may have, 1 or 2.
      integer, intent(in) :: largest_rank
      !> Numbers in the order of Fortran: the last dimension of the file first. Shape `(n, 1)` for one dimension.
      real(dp), allocatable, intent(out) :: values(:, :)
      !> Number of values along each dimension, the slowest first.
      integer(i8), allocatable, intent(out) :: counts(:)
      !> Units of the values as the file says them; empty if the file says none.
      character(:), allocatable, intent(out) :: units
      !> What is wrong, for the user; empty if nothing is.
      character(:), allocatable, intent(out) :: flaw
      type(hdf5_calls_t) :: calls
      type(error_t), allocatable :: error
      integer(hid_t) :: file_id, dataset
      logical :: is_text

      flaw = ''
      units = ''
      file_id = no_id
      dataset = no_id
      call calls%open_library()
      call open_foreign_file(calls, file, file_id, flaw)
      if (len(flaw) == 0 .and. calls%is_good()) then
         call h5dopen_f(file_id, path, dataset, calls%status)
         if (calls%status < 0) then
            dataset = no_id
            flaw = 'there is no such dataset in the file'
         end if
      end if
      if (len(flaw) == 0) call get_extent(calls, dataset, largest_rank, counts, flaw)
      if (len(flaw) == 0) then
         call read_label(calls, dataset, units_name, units, is_text)
         if (.not. is_text) flaw = 'the attribute '//units_name//' of the dataset is no text'
      end if
      ! before anything is read: HDF5 would keep the sources open
      if (len(flaw) == 0) call check_sources(calls, file, dataset, 0, flaw)
      if (len(flaw) == 0) call read_values(calls, dataset, counts, values, flaw)
      call close_dataset(calls, dataset)
      call close_file(calls, file_id)
      if (len(flaw) > 0) return
      call calls%get_error('cannot be read', error)
      if (allocated(error)) flaw = error%message
   end subroutine read_numbers

   !> Open a file to read from it.
   subroutine open_foreign_file(calls, file, file_id, flaw)
      type(hdf5_calls_t), intent(inout) :: calls
      character(*), intent(in) :: file
      !> Id of the file, to be closed by `close_file`; left as it is if the file cannot be opened.
      integer(hid_t), intent(inout) :: file_id
      !> What is wrong, for the user; empty if nothing is.
      character(:), allocatable, intent(inout) :: flaw
      logical :: is_hdf5

      select case (kind_of_path(file))
      case (path_free)
         flaw = 'there is no such file'
      case (path_file)
         if (.not. calls%is_good()) return
         call h5fis_hdf5_f(file, is_hdf5, calls%status)
         call calls%check()
         if (.not. calls%is_good()) return
         if (.not. is_hdf5) then
            flaw = 'the file is no HDF5 file'
            return
         end if
         call open_source(calls, file, file_id)
      case default
         flaw = 'this is no regular file'
      end select
   end subroutine open_foreign_file

   !> Number of values along each dimension, of a dataset of numbers that has at least one.
   subroutine get_extent(calls, dataset, largest_rank, counts, flaw)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: dataset
      !> Largest number of dimensions that the dataset may have.
      integer, intent(in) :: largest_rank
      !> Number of values along each dimension, the slowest first.
      integer(i8), allocatable, intent(out) :: counts(:)
      character(:), allocatable, intent(inout) :: flaw
      integer(hsize_t) :: extents(most_dimensions), limits(most_dimensions)
      integer(hid_t) :: type_id, space
      integer :: type_class, space_class, rank
      character(2) :: number

      type_id = no_id
      space = no_id
      rank = 0
      if (calls%is_good()) call h5dget_type_f(dataset, type_id, calls%status)
      call calls%check()
      if (calls%is_good()) call h5tget_class_f(type_id, type_class, calls%status)
      call calls%check()
      if (calls%is_good()) call h5dget_space_f(dataset, space, calls%status)
      call calls%check()
      if (calls%is_good()) call h5sget_simple_extent_type_f(space, space_class, calls%status)
      call calls%check()
      if (calls%is_good()) call h5sget_simple_extent_ndims_f(space, rank, calls%status)
      call calls%check()
      if (calls%is_good() .and. rank > 0) call h5sget_simple_extent_dims_f(space, extents(:rank), limits(:rank), calls%status)
      call calls%check()
      counts = int(extents(rank:1:-1), i8)
      if (calls%is_good()) then
         write (number, '(i0)') rank
         if (.not. any(type_class == [H5T_FLOAT_F, H5T_INTEGER_F])) then
            flaw = 'the dataset has no numbers'
         else if (space_class == H5S_NULL_F .or. any(counts == 0)) then
            flaw = 'the dataset is empty'
         else if (rank < 1 .or. rank > largest_rank) then
            flaw = 'the dataset has '//trim(number)//' dimensions'
         end if
      end if
      call calls%close_id(space)
      call calls%close_id(type_id)
   end subroutine get_extent

   !> The values themselves.
   subroutine read_values(calls, dataset, counts, values, flaw)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: dataset
      !> Number of values along each dimension, the slowest first; one or two dimensions.
      integer(i8), intent(in) :: counts(:)
      !> Numbers in the order of Fortran: the last dimension of the file first; not allocated if there is no space.
      real(dp), allocatable, target, intent(out) :: values(:, :)
      character(:), allocatable, intent(inout) :: flaw
      type(c_ptr) :: address
      real(dp) :: n_bytes
      integer(i8) :: n_slow
      integer :: status

      if (.not. calls%is_good()) return
      n_slow = 1
      if (size(counts) == 2) n_slow = counts(1)
      status = 1
      n_bytes = product(real(counts, dp))*real_bytes
      if (n_bytes < free_memory() .and. all(counts <= huge(1))) then
         if (has_space(n_bytes)) allocate (values(counts(size(counts)), n_slow), stat=status)
      end if
      if (status /= 0) then
         flaw = 'the dataset is too large for the memory'
         return
      end if
      address = c_loc(values)
      call h5dread_f(dataset, H5T_NATIVE_DOUBLE, address, calls%status)
      call calls%check()
   end subroutine read_values

end module adfric_hdf5_samples
