! SPDX-License-Identifier: GPL-3.0-or-later
!> Datasets of words in HDF5 files: texts of variable length in UTF-8, which readers show as labels.
module adfric_hdf5_words
   use, intrinsic :: iso_c_binding, only: c_char, c_loc, c_null_char, c_ptr
   use hdf5, only: hid_t, h5dcreate_f, h5dwrite_f, h5tcopy_f, h5tset_cset_f, H5T_STRING, H5T_CSET_UTF8_F
   use adfric_base_kinds, only: i8
   use adfric_base_words, only: count_words, get_word
   use adfric_hdf5_calls, only: hdf5_calls_t, no_id
   use adfric_hdf5_datasets, only: create_space
   implicit none (type, external)
   private
   public :: create_word_dataset

contains

   !> Create a dataset of one dimension with a word at each index.
   subroutine create_word_dataset(calls, file, name, words, dataset)
      !> Chain of HDF5 calls; nothing is done once one of them has failed.
      type(hdf5_calls_t), intent(inout) :: calls
      !> Id of the open file.
      integer(hid_t), intent(in) :: file
      !> Name of the dataset, with its group before it if it has one.
      character(*), intent(in) :: name
      !> The words, separated by a blank; at least one.
      character(*), intent(in) :: words
      !> Id of the dataset, to be closed by the caller; `no_id` if a call has failed.
      integer(hid_t), intent(out) :: dataset
      character(kind=c_char), allocatable, target :: letters(:, :)
      type(c_ptr), target :: indices(count_words(words))
      integer(hid_t) :: space, type_id

      dataset = no_id
      type_id = no_id
      call copy_words(words, letters, indices)
      call create_space(calls, [size(indices, kind=i8)], space)
      if (calls%is_good()) call h5tcopy_f(H5T_STRING, type_id, calls%status)
      call calls%check()
      if (calls%is_good()) call h5tset_cset_f(type_id, H5T_CSET_UTF8_F, calls%status)
      call calls%check()
      if (calls%is_good()) then
         call h5dcreate_f(file, name, type_id, space, dataset, calls%status)
         call calls%check()
         if (.not. calls%is_good()) dataset = no_id
      end if
      if (calls%is_good()) call h5dwrite_f(dataset, type_id, c_loc(indices), calls%status)
      call calls%check()
      call calls%close_id(type_id)
      call calls%close_id(space)
   end subroutine create_word_dataset

   !> The words as C has them, each with a null character at its end.
   subroutine copy_words(words, letters, indices)
      !> The words, separated by a blank.
      character(*), intent(in) :: words
      !> Receives the letters, a column for each word.
      character(kind=c_char), allocatable, target, intent(out) :: letters(:, :)
      type(c_ptr), intent(out) :: indices(:)
      character(:), allocatable :: word
      integer :: i, k

      allocate (letters(len(words) + 1, size(indices)), source=c_null_char)
      do i = 1, size(indices)
         word = get_word(words, i)
         do k = 1, len(word)
            letters(k, i) = word(k:k)
         end do
         indices(i) = c_loc(letters(1, i))
      end do
   end subroutine copy_words

end module adfric_hdf5_words
