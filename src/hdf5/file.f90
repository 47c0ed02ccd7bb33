! SPDX-License-Identifier: GPL-3.0-or-later
!> HDF5 files as a whole.
module adfric_hdf5_file
   use, intrinsic :: iso_c_binding, only: c_size_t
   use hdf5, only: hid_t, h5fcreate_f, h5fopen_f, h5fflush_f, h5fclose_f, h5pcreate_f, h5pset_fclose_degree_f, &
      h5pset_sieve_buf_size_f, H5F_ACC_EXCL_F, H5F_ACC_RDONLY_F, H5F_ACC_RDWR_F, H5F_SCOPE_GLOBAL_F, H5F_CLOSE_SEMI_F, &
      H5F_CLOSE_WEAK_F, H5P_FILE_ACCESS_F
   use adfric_hdf5_calls, only: hdf5_calls_t, no_id
   implicit none (type, external)
   private
   public :: create_file, open_file, open_source, flush_file, close_file, create_access

contains

   !> Create a file; there must be none of this name.
   subroutine create_file(calls, path, file)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Name of the file; nothing may stand there.
      character(*), intent(in) :: path
      !> Id of the file, to be closed by `close_file`; `no_id` if a call has failed.
      integer(hid_t), intent(out) :: file
      integer(hid_t) :: list

      file = no_id
      call create_access(calls, list)
      if (calls%is_good()) then
         call h5fcreate_f(path, H5F_ACC_EXCL_F, file, calls%status, access_prp=list)
         call calls%check()
      end if
      call calls%close_id(list)
   end subroutine create_file

   !> Open a file.
   subroutine open_file(calls, path, is_written, file, access)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Name of the file.
      character(*), intent(in) :: path
      !> Is the file opened to be written? Else only to be read.
      logical, intent(in) :: is_written
      !> Id of the file, to be closed by `close_file`; `no_id` if a call has failed.
      integer(hid_t), intent(out) :: file
      !> Access list by which several processes open the file together; if absent this one opens it alone.
      integer(hid_t), intent(in), optional :: access
      integer(hid_t) :: list

      file = no_id
      list = no_id
      if (.not. present(access)) call create_access(calls, list)
      if (calls%is_good()) then
         if (present(access)) list = access
         call h5fopen_f(path, merge(H5F_ACC_RDWR_F, H5F_ACC_RDONLY_F, is_written), file, calls%status, access_prp=list)
         call calls%check()
      end if
      if (.not. present(access)) call calls%close_id(list)
   end subroutine open_file

   !> Open a file to read datasets that may be virtual, as HDF5 opens the files of their sources: where one of them is
   !> this file by another name, HDF5 would give fill values otherwise.
   subroutine open_source(calls, path, file)
      !> The chain of calls that this is a part of.
      type(hdf5_calls_t), intent(inout) :: calls
      character(*), intent(in) :: path
      !> Its id.
      integer(hid_t), intent(out) :: file
      integer(hid_t) :: list

      call create_access(calls, list)
      if (calls%is_good()) call h5pset_fclose_degree_f(list, H5F_CLOSE_WEAK_F, calls%status)
      call calls%check()
      call open_file(calls, path, .false., file, access=list)
      call calls%close_id(list)
   end subroutine open_source

   !> Make the library ready, and a list of properties: closing a file fails as long as anything in it is open, and values
   !> go straight to the operating system (HDF5 would first read what stands where they go).
   subroutine create_access(calls, list)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the list of properties, to be closed by the caller; `no_id` if a call has failed.
      integer(hid_t), intent(out) :: list

      list = no_id
      call calls%open_library()
      if (.not. calls%is_good()) return
      call h5pcreate_f(H5P_FILE_ACCESS_F, list, calls%status)
      call calls%check()
      if (.not. calls%is_good()) return
      call h5pset_fclose_degree_f(list, H5F_CLOSE_SEMI_F, calls%status)
      call calls%check()
      if (.not. calls%is_good()) return
      call h5pset_sieve_buf_size_f(list, 0_c_size_t, calls%status)
      call calls%check()
   end subroutine create_access

   !> Hand everything written so far to the operating system.
   subroutine flush_file(calls, file)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the open file.
      integer(hid_t), intent(in) :: file

      if (.not. calls%is_good()) return
      call h5fflush_f(file, H5F_SCOPE_GLOBAL_F, calls%status)
      call calls%check()
   end subroutine flush_file

   !> Close a file.
   subroutine close_file(calls, file)
      !> Chain of HDF5 calls; the file is closed even where one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the file, which is `no_id` afterwards; `no_id` is left alone.
      integer(hid_t), intent(inout) :: file

      if (file == no_id) return
      call h5fclose_f(file, calls%status)
      call calls%check()
      file = no_id
   end subroutine close_file

end module adfric_hdf5_file
