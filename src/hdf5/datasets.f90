! SPDX-License-Identifier: GPL-3.0-or-later
!> Datasets of fixed size in HDF5 files: contiguous, laid out on the disk and filled when they are created.
!>
!> Shapes, starts and counts are in C order, the slowest dimension first, as h5py shows them; a shape of size 0 is
!> a scalar.
module adfric_hdf5_datasets
   use, intrinsic :: iso_c_binding, only: c_associated, c_loc, c_null_ptr, c_ptr
   use, intrinsic :: iso_fortran_env, only: int8
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_value, ieee_quiet_nan
   use hdf5, only: hid_t, hsize_t, h5screate_f, h5screate_simple_f, h5sselect_hyperslab_f, h5dcreate_f, h5dwrite_f, &
      h5dclose_f, h5pcreate_f, h5pset_layout_f, h5pset_alloc_time_f, h5pset_fill_time_f, h5pset_fill_value_f, &
      h5kind_to_type, h5gcreate_f, H5S_SCALAR_F, H5S_SELECT_SET_F, H5P_DATASET_CREATE_F, H5D_CONTIGUOUS_F, &
      H5D_ALLOC_TIME_EARLY_F, H5D_FILL_TIME_ALLOC_F, H5T_IEEE_F64LE, H5T_STD_I8LE, H5T_STD_I64LE, H5T_NATIVE_DOUBLE, &
      H5_INTEGER_KIND
   use h5ds, only: h5dsset_scale_f, h5dsattach_scale_f
   use adfric_base_kinds, only: dp, i8
   use adfric_hdf5_calls, only: hdf5_calls_t, no_id
   implicit none (type, external)
   private
   public :: create_group, create_space, select_box, create_real_dataset, create_state_dataset, create_integer_dataset
   public :: write_values, close_dataset
   public :: make_scale, attach_scale, no_state, to_state, to_fortran

   !> What stands in a dataset of states where there is none.
   integer(int8), parameter :: no_state = -1

   !> Write values into a part of a dataset.
   interface write_values
      module procedure write_reals
      module procedure write_states
      module procedure write_integers
   end interface write_values

contains

   !> Create a group.
   subroutine create_group(calls, file, name, group)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the open file.
      integer(hid_t), intent(in) :: file
      !> Name of the group.
      character(*), intent(in) :: name
      !> Id of the group, to be closed by the caller; `no_id` if a call has failed.
      integer(hid_t), intent(out) :: group

      group = no_id
      if (.not. calls%is_good()) return
      call h5gcreate_f(file, name, group, calls%status)
      call calls%check()
   end subroutine create_group

   !> Create a space of a shape.
   subroutine create_space(calls, shape, space)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Number of values along each dimension, the slowest first; of size 0 for a scalar.
      integer(i8), intent(in) :: shape(:)
      !> Id of the space, to be closed by the caller; `no_id` if a call has failed.
      integer(hid_t), intent(out) :: space

      space = no_id
      if (.not. calls%is_good()) return
      if (size(shape) == 0) then
         call h5screate_f(H5S_SCALAR_F, space, calls%status)
      else
         call h5screate_simple_f(size(shape), to_fortran(shape), space, calls%status)
      end if
      call calls%check()
   end subroutine create_space

   !> Select a part of a space; a scalar is always selected as a whole.
   subroutine select_box(calls, space, start, count)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Space in which the part is selected, in place of what was selected before.
      integer(hid_t), intent(in) :: space
      !> First index of the part along each dimension, from 0, and how many indices; the slowest dimension first.
      integer(i8), intent(in) :: start(:), count(:)

      if (size(start) == 0 .or. .not. calls%is_good()) return
      call h5sselect_hyperslab_f(space, H5S_SELECT_SET_F, to_fortran(start), to_fortran(count), calls%status)
      call calls%check()
   end subroutine select_box

   !> Numbers of the dimensions in Fortran order.
   pure function to_fortran(numbers) result(reversed)
      !> Numbers of the dimensions in C order, the slowest first.
      integer(i8), intent(in) :: numbers(:)
      integer(hsize_t) :: reversed(size(numbers))

      reversed = int(numbers(size(numbers):1:-1), hsize_t)
   end function to_fortran

   !> Create a dataset of real numbers, all NaN.
   subroutine create_real_dataset(calls, file, name, space, dataset)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the open file.
      integer(hid_t), intent(in) :: file
      !> Name of the dataset, with its group before it if it has one.
      character(*), intent(in) :: name
      !> Space of the dataset's shape.
      integer(hid_t), intent(in) :: space
      !> Id of the dataset, to be closed by the caller; `no_id` if a call has failed.
      integer(hid_t), intent(out) :: dataset
      real(dp), target :: fill

      fill = ieee_value(fill, ieee_quiet_nan)
      call create_dataset(calls, file, name, H5T_IEEE_F64LE, space, H5T_NATIVE_DOUBLE, c_loc(fill), dataset)
   end subroutine create_real_dataset

   !> Create a dataset of states, all `no_state`.
   subroutine create_state_dataset(calls, file, name, space, dataset)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the open file.
      integer(hid_t), intent(in) :: file
      !> Name of the dataset, with its group before it if it has one.
      character(*), intent(in) :: name
      !> Space of the dataset's shape.
      integer(hid_t), intent(in) :: space
      !> Id of the dataset, to be closed by the caller; `no_id` if a call has failed.
      integer(hid_t), intent(out) :: dataset
      integer(int8), target :: fill

      fill = no_state
      call create_dataset(calls, file, name, H5T_STD_I8LE, space, h5kind_to_type(int8, H5_INTEGER_KIND), c_loc(fill), dataset)
   end subroutine create_state_dataset

   !> Create a dataset of integers, all 0.
   subroutine create_integer_dataset(calls, file, name, space, dataset)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the open file.
      integer(hid_t), intent(in) :: file
      !> Name of the dataset, with its group before it if it has one.
      character(*), intent(in) :: name
      !> Space of the dataset's shape.
      integer(hid_t), intent(in) :: space
      !> Id of the dataset, to be closed by the caller; `no_id` if a call has failed.
      integer(hid_t), intent(out) :: dataset

      call create_dataset(calls, file, name, H5T_STD_I64LE, space, H5T_STD_I64LE, c_null_ptr, dataset)
   end subroutine create_integer_dataset

   !> Create a list of properties: contiguous, laid out and filled at once.
   subroutine create_list(calls, list)
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the list of properties, to be closed by the caller; `no_id` if a call has failed.
      integer(hid_t), intent(out) :: list

      list = no_id
      if (.not. calls%is_good()) return
      call h5pcreate_f(H5P_DATASET_CREATE_F, list, calls%status)
      call calls%check()
      if (.not. calls%is_good()) return
      call h5pset_layout_f(list, H5D_CONTIGUOUS_F, calls%status)
      call calls%check()
      if (.not. calls%is_good()) return
      call h5pset_alloc_time_f(list, H5D_ALLOC_TIME_EARLY_F, calls%status)
      call calls%check()
      if (.not. calls%is_good()) return
      call h5pset_fill_time_f(list, H5D_FILL_TIME_ALLOC_F, calls%status)
      call calls%check()
   end subroutine create_list

   !> Create a dataset: contiguous, laid out and filled at once.
   subroutine create_dataset(calls, file, name, file_type, space, fill_type, fill, dataset)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      !> Name of the dataset, with its group before it if it has one.
      character(*), intent(in) :: name
      !> HDF5 type of the values in the file.
      integer(hid_t), intent(in) :: file_type
      !> Space of the dataset's shape.
      integer(hid_t), intent(in) :: space
      !> HDF5 type of the value that fills the dataset.
      integer(hid_t), intent(in) :: fill_type
      !> Address of the value that fills the dataset; null: that of HDF5, which is 0.
      type(c_ptr), intent(in) :: fill
      !> Id of the dataset, to be closed by the caller; `no_id` if a call has failed.
      integer(hid_t), intent(out) :: dataset
      integer(hid_t) :: list

      dataset = no_id
      call create_list(calls, list)
      if (calls%is_good() .and. c_associated(fill)) then
         call h5pset_fill_value_f(list, fill_type, fill, calls%status)
         call calls%check()
      end if
      if (calls%is_good()) then
         call h5dcreate_f(file, name, file_type, space, dataset, calls%status, dcpl_id=list)
         call calls%check()
      end if
      call calls%close_id(list)
   end subroutine create_dataset

   !> Write real numbers.
   subroutine write_reals(calls, dataset, memory_space, file_space, values)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: dataset
      !> Space of as many values as are written.
      integer(hid_t), intent(in) :: memory_space
      integer(hid_t), intent(in) :: file_space
      !> Numbers in the order of the file, the last dimension fastest.
      real(dp), intent(in), contiguous, target :: values(:)

      call write_from(calls, dataset, H5T_NATIVE_DOUBLE, memory_space, file_space, c_loc(values))
   end subroutine write_reals

   !> Write states.
   subroutine write_states(calls, dataset, memory_space, file_space, values)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: dataset, memory_space, file_space
      !> States in the order of the file, the last dimension fastest.
      integer(int8), intent(in), contiguous, target :: values(:)

      call write_from(calls, dataset, h5kind_to_type(int8, H5_INTEGER_KIND), memory_space, file_space, c_loc(values))
   end subroutine write_states

   !> Write integers.
   subroutine write_integers(calls, dataset, memory_space, file_space, values)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: dataset, memory_space, file_space
      !> Integers in the order of the file, the last dimension fastest.
      integer(i8), intent(in), contiguous, target :: values(:)

      call write_from(calls, dataset, h5kind_to_type(i8, H5_INTEGER_KIND), memory_space, file_space, c_loc(values))
   end subroutine write_integers

   !> Write values of any type.
   subroutine write_from(calls, dataset, memory_type, memory_space, file_space, address)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: dataset
      !> HDF5 type of the values in the memory.
      integer(hid_t), intent(in) :: memory_type
      integer(hid_t), intent(in) :: memory_space, file_space
      type(c_ptr), intent(in) :: address

      if (.not. calls%is_good()) return
      call h5dwrite_f(dataset, memory_type, address, calls%status, memory_space, file_space)
      call calls%check()
   end subroutine write_from

   !> Close a dataset, even if its last writing fails.
   subroutine close_dataset(calls, dataset)
      !> Chain of HDF5 calls; the dataset is closed even where one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the dataset, which is `no_id` afterwards; `no_id` is left alone.
      integer(hid_t), intent(inout) :: dataset

      if (dataset == no_id) return
      call h5dclose_f(dataset, calls%status)
      call calls%check()
      dataset = no_id
   end subroutine close_dataset

   !> Make a dataset of one dimension a scale.
   subroutine make_scale(calls, dataset, name)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the open dataset, of one dimension.
      integer(hid_t), intent(in) :: dataset
      !> Name of the dimension, which readers show.
      character(*), intent(in) :: name

      if (.not. calls%is_good()) return
      call h5dsset_scale_f(dataset, calls%status, name)
      call calls%check()
   end subroutine make_scale

   !> Attach a scale to a dimension of a dataset.
   subroutine attach_scale(calls, dataset, scale, dimension)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the open dataset.
      integer(hid_t), intent(in) :: dataset
      !> Id of the open dataset that is the scale.
      integer(hid_t), intent(in) :: scale
      !> Number of the dimension, from 1, the slowest first.
      integer, intent(in) :: dimension

      if (.not. calls%is_good()) return
      call h5dsattach_scale_f(dataset, scale, dimension, calls%status)
      call calls%check()
   end subroutine attach_scale

   !> A state as it stands in the file.
   elemental integer(int8) function to_state(value)
      !> Number of the state, or NaN where there is none.
      real(dp), intent(in) :: value

      to_state = no_state
      if (ieee_is_finite(value)) to_state = nint(value, int8)
   end function to_state

end module adfric_hdf5_datasets
