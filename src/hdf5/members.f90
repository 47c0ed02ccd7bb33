! SPDX-License-Identifier: GPL-3.0-or-later
!> What groups and datasets of HDF5 files that others have written have beside values: datasets within a group, and attributes that
!> are numbers.
module adfric_hdf5_members
   use, intrinsic :: iso_c_binding, only: c_loc, c_ptr
   use hdf5, only: hid_t, h5aread_f, h5gopen_f, h5lexists_f, h5oclose_f, h5oopen_f, H5T_FLOAT_F, H5T_INTEGER_F, H5T_NATIVE_DOUBLE
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_base_words, only: get_word
   use adfric_hdf5_calls, only: hdf5_calls_t, no_id
   use adfric_hdf5_file, only: close_file
   use adfric_hdf5_labels, only: label_t
   use adfric_hdf5_samples, only: open_foreign_file
   implicit none (type, external)
   private
   public :: number_label_t, find_members, read_number_labels

   !> An attribute that should be a number.
   type :: number_label_t
      !> Is there such an attribute, and is it one number?
      logical :: exists = .false., is_number = .false.
      !> The number; 0 if it is none.
      real(dp) :: number = 0
   end type number_label_t

contains

   !> Find out which names a group has.
   subroutine find_members(file, path, names, exists, flaw)
      !> Name of the file.
      character(*), intent(in) :: file
      !> Name of the group within the file.
      character(*), intent(in) :: path
      !> Names that are looked for, separated by a blank.
      character(*), intent(in) :: names
      !> Does the group have the name? One value for each name.
      logical, intent(out) :: exists(:)
      !> What is wrong with the file or the group, for the user; empty if nothing is.
      character(:), allocatable, intent(out) :: flaw
      type(hdf5_calls_t) :: calls
      integer(hid_t) :: file_id, group
      integer :: k

      exists = .false.
      flaw = ''
      file_id = no_id
      group = no_id
      call calls%open_library()
      call open_foreign_file(calls, file, file_id, flaw)
      if (len(flaw) == 0 .and. calls%is_good()) then
         call h5gopen_f(file_id, path, group, calls%status)
         if (calls%status < 0) then
            group = no_id
            flaw = 'there is no such group in the file'
         end if
      end if
      do k = 1, size(exists)
         if (len(flaw) > 0 .or. .not. calls%is_good()) exit
         call h5lexists_f(group, get_word(names, k), exists(k), calls%status)
         call calls%check()
      end do
      call calls%close_id(group)
      call close_file(calls, file_id)
      call say_failure(calls, flaw)
   end subroutine find_members

   !> Read attributes of a dataset or a group.
   subroutine read_number_labels(file, path, names, labels, flaw)
      !> Name of the file.
      character(*), intent(in) :: file
      !> Name of the dataset or group within the file.
      character(*), intent(in) :: path
      !> Names of the attributes, separated by a blank.
      character(*), intent(in) :: names
      !> Receives the attributes, one for each name.
      type(number_label_t), intent(out) :: labels(:)
      !> What is wrong with the file, for the user; empty if nothing is.
      character(:), allocatable, intent(out) :: flaw
      type(hdf5_calls_t) :: calls
      integer(hid_t) :: file_id, index
      integer :: k

      flaw = ''
      file_id = no_id
      index = no_id
      call calls%open_library()
      call open_foreign_file(calls, file, file_id, flaw)
      if (len(flaw) == 0 .and. calls%is_good()) then
         call h5oopen_f(file_id, path, index, calls%status)
         ! what is not there has no attributes either; whoever reads the values says that it is not there
         if (calls%status < 0) then
            index = no_id
            calls%status = 0
         end if
      end if
      do k = 1, size(labels)
         if (index /= no_id) call read_number_label(calls, index, get_word(names, k), labels(k))
      end do
      if (index /= no_id) call h5oclose_f(index, calls%status)
      call calls%check()
      call close_file(calls, file_id)
      call say_failure(calls, flaw)
   end subroutine read_number_labels

   !> Read an attribute.
   subroutine read_number_label(calls, index, name, label)
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the open dataset or group.
      integer(hid_t), intent(in) :: index
      character(*), intent(in) :: name
      type(number_label_t), intent(out) :: label
      real(dp), target :: buffer
      type(c_ptr) :: address
      type(label_t) :: attribute

      call attribute%open(calls, index, name)
      label%exists = attribute%exists
      label%is_number = calls%is_good() .and. attribute%n_values == 1 &
         & .and. any(attribute%type_class == [H5T_FLOAT_F, H5T_INTEGER_F])
      if (label%is_number) then
         buffer = 0
         address = c_loc(buffer)
         call h5aread_f(attribute%id, H5T_NATIVE_DOUBLE, address, calls%status)
         call calls%check()
         label%number = buffer
      end if
      call attribute%close(calls)
   end subroutine read_number_label

   !> Say that a call has failed, unless something else is wrong.
   subroutine say_failure(calls, flaw)
      !> Chain of HDF5 calls.
      type(hdf5_calls_t), intent(inout) :: calls
      !> What is wrong, for the user; an earlier flaw is kept.
      character(:), allocatable, intent(inout) :: flaw
      type(error_t), allocatable :: error

      if (len(flaw) > 0) return
      call calls%get_error('cannot be read', error)
      if (allocated(error)) flaw = error%message
   end subroutine say_failure

end module adfric_hdf5_members
