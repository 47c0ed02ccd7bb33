! SPDX-License-Identifier: GPL-3.0-or-later
!> Virtual datasets: they have a shape, and their values are in datasets of other files.
module adfric_hdf5_virtual
   use, intrinsic :: iso_c_binding, only: c_loc
   use, intrinsic :: iso_fortran_env, only: int8
   use hdf5, only: hid_t, h5pcreate_f, h5pset_fill_value_f, h5pset_virtual_f, h5sselect_none_f, h5sselect_hyperslab_f, &
      h5dcreate_f, h5kind_to_type, H5S_SELECT_OR_F, H5P_DATASET_CREATE_F, H5T_IEEE_F64LE, H5T_STD_I8LE, &
      H5T_NATIVE_DOUBLE, H5_INTEGER_KIND
   use adfric_base_kinds, only: dp, i8
   use adfric_base_not_a_number, only: not_a_number
   use adfric_hdf5_calls, only: hdf5_calls_t, no_id
   use adfric_hdf5_datasets, only: no_state, to_fortran
   implicit none (type, external)
   private
   public :: select_nothing, add_box, create_virtual_list, add_source, create_virtual_dataset

contains

   !> Select no part of a space.
   subroutine select_nothing(calls, space)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Space in which nothing is selected afterwards.
      integer(hid_t), intent(in) :: space

      if (.not. calls%is_good()) return
      call h5sselect_none_f(space, calls%status)
      call calls%check()
   end subroutine select_nothing

   !> Select a box of a space besides what is selected.
   subroutine add_box(calls, space, start, count)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Space in which the box is selected besides what is selected.
      integer(hid_t), intent(in) :: space
      !> First index of the box along each dimension, from 0, and how many indices; the slowest dimension first.
      integer(i8), intent(in) :: start(:), count(:)

      if (.not. calls%is_good()) return
      call h5sselect_hyperslab_f(space, H5S_SELECT_OR_F, to_fortran(start), to_fortran(count), calls%status)
      call calls%check()
   end subroutine add_box

   !> Create a list of properties of a virtual dataset; NaN, or `no_state`, stands where a source is missing.
   subroutine create_virtual_list(calls, is_real, list)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Has the dataset real numbers? Else it has states.
      logical, intent(in) :: is_real
      !> Id of the list of properties, to be closed by the caller; `no_id` if a call has failed.
      integer(hid_t), intent(out) :: list
      real(dp), target :: real_fill
      integer(int8), target :: state_fill

      list = no_id
      real_fill = not_a_number()
      state_fill = no_state
      if (.not. calls%is_good()) return
      call h5pcreate_f(H5P_DATASET_CREATE_F, list, calls%status)
      call calls%check()
      if (.not. calls%is_good()) return
      if (is_real) then
         call h5pset_fill_value_f(list, H5T_NATIVE_DOUBLE, c_loc(real_fill), calls%status)
      else
         call h5pset_fill_value_f(list, h5kind_to_type(int8, H5_INTEGER_KIND), c_loc(state_fill), calls%status)
      end if
      call calls%check()
   end subroutine create_virtual_list

   !> Say where a part of the values is.
   subroutine add_source(calls, list, space, path, name, source_space)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> List of properties of the virtual dataset, to which the source is added.
      integer(hid_t), intent(in) :: list
      !> Space of the virtual dataset, with the part selected that the source has.
      integer(hid_t), intent(in) :: space
      !> Name of the source's file, relative to the folder of the virtual dataset or absolute.
      character(*), intent(in) :: path
      !> Name of the source within its file.
      character(*), intent(in) :: name
      !> Space of the source, with the values selected; as many as in `space`.
      integer(hid_t), intent(in) :: source_space

      if (.not. calls%is_good()) return
      call h5pset_virtual_f(list, space, as_format(path), as_format(name), source_space, calls%status)
      call calls%check()
   end subroutine add_source

   !> A name as HDF5 takes the names of sources: as formats, in which a percent sign stands twice.
   pure function as_format(name) result(format)
      !> Name of a file or a dataset.
      character(*), intent(in) :: name
      character(:), allocatable :: format
      integer :: i

      format = ''
      do i = 1, len(name)
         format = format//name(i:i)
         if (name(i:i) == '%') format = format//'%'
      end do
   end function as_format

   !> Create a virtual dataset.
   subroutine create_virtual_dataset(calls, file, name, is_real, space, list, dataset)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the open file.
      integer(hid_t), intent(in) :: file
      !> Name of the dataset.
      character(*), intent(in) :: name
      !> Has the dataset real numbers? Else it has states.
      logical, intent(in) :: is_real
      !> Space of the dataset's shape.
      integer(hid_t), intent(in) :: space
      !> List of properties with the sources, see `add_source`.
      integer(hid_t), intent(in) :: list
      !> Id of the dataset, to be closed by `close_dataset`; `no_id` if a call has failed.
      integer(hid_t), intent(out) :: dataset

      dataset = no_id
      if (.not. calls%is_good()) return
      call h5dcreate_f(file, name, merge(H5T_IEEE_F64LE, H5T_STD_I8LE, is_real), space, dataset, calls%status, dcpl_id=list)
      call calls%check()
   end subroutine create_virtual_dataset

end module adfric_hdf5_virtual
