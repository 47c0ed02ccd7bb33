! SPDX-License-Identifier: GPL-3.0-or-later
!> Have all values of a virtual dataset a source? HDF5 gives its fill value for those that have none, and says nothing.
module adfric_hdf5_sources
   use, intrinsic :: iso_c_binding, only: c_int, c_int64_t
   use hdf5, only: hid_t, hsize_t, size_t, h5dget_create_plist_f, h5dget_space_f, h5pget_layout_f, &
      h5pget_virtual_count_f, h5pget_virtual_filename_f, h5pget_virtual_dsetname_f, h5pget_virtual_vspace_f, &
      h5sget_simple_extent_ndims_f, h5sget_simple_extent_npoints_f, h5sget_select_type_f, h5sget_select_npoints_f, &
      h5sselect_all_f, h5sselect_hyperslab_f, H5D_VIRTUAL_F, H5S_SEL_ALL_F, H5S_SELECT_OR_F
   use adfric_hdf5_calls, only: hdf5_calls_t
   use adfric_hdf5_datasets, only: close_dataset
   use adfric_hdf5_file, only: open_source, close_file
   use adfric_hdf5_reading, only: open_dataset
   use adfric_hdf5_virtual, only: select_nothing
   use adfric_system_files, only: folder_of, kind_of_path, path_file
   implicit none (type, external)
   private
   public :: check_sources

   !> Longest name of a file or a dataset, and how deep virtual datasets may refer to virtual datasets.
   integer, parameter :: name_length = 4096, most_levels = 16
   !> Most dimensions that HDF5 knows.
   integer, parameter :: most_dimensions = 32

   interface

      !> `H5Sget_regular_hyperslab`, the slowest dimension first; negative where the selection is no pattern of equal boxes.
      integer(c_int) function get_regular(space, start, stride, count, block) bind(c, name='H5Sget_regular_hyperslab')
         import :: c_int, c_int64_t
         implicit none (type, external)
         !> Id of the space with the selection.
         integer(c_int64_t), intent(in), value :: space
         !> First index of the first box along each dimension, from 0.
         integer(c_int64_t), intent(out) :: start(*)
         !> Distance from a box to the next one along each dimension.
         integer(c_int64_t), intent(out) :: stride(*)
         !> Number of boxes along each dimension.
         integer(c_int64_t), intent(out) :: count(*)
         !> Number of indices of a box along each dimension.
         integer(c_int64_t), intent(out) :: block(*)
      end function get_regular

   end interface

contains

   !> Find out whether all values of a dataset have a source; those of one that is not virtual have.
   recursive subroutine check_sources(calls, path, dataset, level, flaw)
      type(hdf5_calls_t), intent(inout) :: calls
      !> Name of the file of the dataset.
      character(*), intent(in) :: path
      integer(hid_t), intent(in) :: dataset
      !> Number of virtual datasets that have led here, 0 at first.
      integer, intent(in) :: level
      !> What is wrong, for the user; empty if nothing is. An earlier flaw is kept.
      character(:), allocatable, intent(inout) :: flaw
      integer(hid_t) :: list
      integer :: layout

      if (len(flaw) > 0 .or. .not. calls%is_good()) return
      call h5dget_create_plist_f(dataset, list, calls%status)
      call calls%check()
      if (.not. calls%is_good()) return
      call h5pget_layout_f(list, layout, calls%status)
      call calls%check()
      if (calls%is_good() .and. layout == H5D_VIRTUAL_F) then
         if (level > most_levels) then
            flaw = 'the dataset is virtual, through more than 16 files'
         else
            call check_each(calls, path, dataset, list, level, flaw)
         end if
      end if
      call calls%close_id(list)
   end subroutine check_sources

   !> Check each source of a virtual dataset, and whether they have all of its values.
   recursive subroutine check_each(calls, path, dataset, list, level, flaw)
      type(hdf5_calls_t), intent(inout) :: calls
      character(*), intent(in) :: path
      integer(hid_t), intent(in) :: dataset
      !> Properties with which the dataset was created.
      integer(hid_t), intent(in) :: list
      !> Number of virtual datasets that have led here; at most `most_levels`.
      integer, intent(in) :: level
      character(:), allocatable, intent(inout) :: flaw
      integer(hid_t) :: covered
      integer(size_t) :: n_sources, i
      integer(hsize_t) :: n_covered, n

      call h5dget_space_f(dataset, covered, calls%status)
      call calls%check()
      if (.not. calls%is_good()) return
      call select_nothing(calls, covered)
      call h5pget_virtual_count_f(list, n_sources, calls%status)
      call calls%check()
      do i = 0, n_sources - 1
         call check_source(calls, path, list, i, level, flaw)
         call add_index(calls, list, i, covered, flaw)
         if (len(flaw) > 0 .or. .not. calls%is_good()) exit
      end do
      call h5sget_select_npoints_f(covered, n_covered, calls%status)
      call h5sget_simple_extent_npoints_f(covered, n, calls%status)
      if (len(flaw) == 0 .and. n_covered < n) flaw = 'the dataset is virtual, and values of it have no source'
      call calls%close_id(covered)
   end subroutine check_each

   !> Is a source there? HDF5 would look for it in other indices, too; only the usual one counts.
   recursive subroutine check_source(calls, path, list, i, level, flaw)
      type(hdf5_calls_t), intent(inout) :: calls
      character(*), intent(in) :: path
      integer(hid_t), intent(in) :: list
      !> Number of the source, from 0.
      integer(size_t), intent(in) :: i
      integer, intent(in) :: level
      character(:), allocatable, intent(inout) :: flaw
      character(name_length) :: file_name, name
      character(:), allocatable :: source
      type(hdf5_calls_t) :: trial
      integer(hid_t) :: file, dataset

      call h5pget_virtual_filename_f(list, i, file_name, calls%status)
      call calls%check()
      call h5pget_virtual_dsetname_f(list, i, name, calls%status)
      call calls%check()
      if (.not. calls%is_good()) return
      source = without_format(trim(file_name))
      if (source == '.') then
         source = path
      else if (source(1:1) /= '/') then
         source = folder_of(path)//'/'//source
      end if
      if (kind_of_path(source) == path_file) then
         call open_source(trial, source, file)
         call open_dataset(trial, file, without_format(trim(name)), dataset)
         if (trial%is_good()) call check_sources(calls, source, dataset, level + 1, flaw)
         call close_dataset(calls, dataset)
         call close_file(calls, file)
         if (trial%is_good()) return
      end if
      flaw = 'the dataset is virtual, and its source '//source//':'//trim(name)//' cannot be opened'
   end subroutine check_source

   !> A name of a source, in which a percent sign stands twice.
   pure function without_format(name) result(plain)
      !> Name of a file or a dataset as HDF5 gives the names of sources.
      character(*), intent(in) :: name
      character(:), allocatable :: plain
      integer :: i

      plain = ''
      i = 1
      do while (i <= len(name))
         plain = plain//name(i:i)
         if (name(i:min(i + 1, len(name))) == '%%') i = i + 1
         i = i + 1
      end do
   end function without_format

   !> Add to what is covered the index of the values of a source.
   subroutine add_index(calls, list, i, covered, flaw)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: list
      integer(size_t), intent(in) :: i
      !> Space of the dataset, with the values selected that have a source; those of this source are added.
      integer(hid_t), intent(in) :: covered
      character(:), allocatable, intent(inout) :: flaw
      integer(c_int64_t), dimension(most_dimensions) :: start, stride, count, block
      integer(hid_t) :: space
      integer :: selection, rank

      if (len(flaw) > 0 .or. .not. calls%is_good()) return
      call h5pget_virtual_vspace_f(list, i, space, calls%status)
      call calls%check()
      if (.not. calls%is_good()) return
      call h5sget_select_type_f(space, selection, calls%status)
      call calls%check()
      call h5sget_simple_extent_ndims_f(space, rank, calls%status)
      call calls%check()
      if (selection == H5S_SEL_ALL_F) then
         call h5sselect_all_f(covered, calls%status)
      else if (get_regular(space, start, stride, count, block) < 0) then
         flaw = 'the dataset is virtual, and its sources have not the form of boxes'
      else
         call h5sselect_hyperslab_f(covered, H5S_SELECT_OR_F, int(start(rank:1:-1), hsize_t), &
            int(count(rank:1:-1), hsize_t), calls%status, int(stride(rank:1:-1), hsize_t), int(block(rank:1:-1), hsize_t))
      end if
      call calls%check()
      call calls%close_id(space)
   end subroutine add_index

end module adfric_hdf5_sources
