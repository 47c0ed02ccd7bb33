! SPDX-License-Identifier: GPL-3.0-or-later
!> The words of an enumerated dataset, as attributes.
module adfric_output_flags
   use, intrinsic :: iso_fortran_env, only: int8
   use hdf5, only: hid_t
   use adfric_base_words, only: count_words
   use adfric_hdf5_attributes, only: write_attribute
   use adfric_hdf5_calls, only: hdf5_calls_t
   use adfric_hdf5_reading, only: has_attribute, read_attribute
   implicit none (type, external)
   private
   public :: write_flags, read_flags

contains

   !> Write what the numbers of a dataset mean.
   subroutine write_flags(calls, dataset, first, meanings)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: dataset
      !> Number of the first meaning; the others follow it.
      integer, intent(in) :: first
      !> Meanings separated by a blank; nothing is written if there are none.
      character(*), intent(in) :: meanings
      integer :: k

      if (len(meanings) == 0) return
      call write_attribute(calls, dataset, 'flag_values', [(int(first + k, int8), k=0, count_words(meanings) - 1)])
      call write_attribute(calls, dataset, 'flag_meanings', meanings)
   end subroutine write_flags

   !> Read what the numbers of a dataset mean.
   subroutine read_flags(calls, dataset, first, meanings)
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: dataset
      !> Number of the first meaning; 0 if the dataset has no meanings.
      integer, intent(out) :: first
      !> Meanings separated by a blank; empty if there are none.
      character(:), allocatable, intent(out) :: meanings
      integer(int8), allocatable :: flags(:)

      first = 0
      meanings = ''
      if (.not. has_attribute(calls, dataset, 'flag_meanings')) return
      call read_attribute(calls, dataset, 'flag_meanings', meanings)
      allocate (flags(count_words(meanings)))
      call read_attribute(calls, dataset, 'flag_values', flags)
      if (size(flags) > 0) first = flags(1)
   end subroutine read_flags

end module adfric_output_flags
