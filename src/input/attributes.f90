! SPDX-License-Identifier: GPL-3.0-or-later
!> Numbers beside the datasets and groups that an input names, such as the distance of samples.
module adfric_input_attributes
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_base_words, only: count_words, get_word
   use adfric_hdf5_members, only: number_label_t, read_number_labels
   use adfric_describe_table, only: variable_t
   use adfric_run_dataset, only: dataset_t
   use adfric_system_checksum, only: checksum_t
   implicit none (type, external)
   private
   public :: load_attributes, add_attributes

   !> No number of physics is larger.
   real(dp), parameter :: largest = 1.0e60_dp

contains

   !> Read the attributes that the model takes, where they are there.
   subroutine load_attributes(dataset, variable, flaw)
      !> In: the names of file and dataset. Out: also the attributes.
      type(dataset_t), intent(inout) :: dataset
      !> Row of the model's table, with the names of the attributes.
      type(variable_t), intent(in) :: variable
      !> What is wrong with the file or an attribute; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw
      type(number_label_t) :: labels(variable%n_attributes())
      character(:), allocatable :: names
      integer :: k

      flaw = ''
      ! a table of text has none
      if (size(labels) == 0 .or. dataset%is_column) return
      call read_number_labels(dataset%file, dataset%path, variable%attributes, labels, flaw)
      if (len(flaw) > 0) return
      names = ''
      do k = 1, size(labels)
         if (.not. labels(k)%exists) cycle
         if (.not. labels(k)%is_number) then
            flaw = 'the attribute '//get_word(variable%attributes, k)//' is no single number'
         else if (.not. ieee_is_finite(labels(k)%number)) then
            flaw = 'the attribute '//get_word(variable%attributes, k)//' is NaN or Inf'
         else if (abs(labels(k)%number) > largest) then
            flaw = 'the attribute '//get_word(variable%attributes, k)//' is out of range'
         end if
         if (len(flaw) > 0) return
         names = names//' '//get_word(variable%attributes, k)
      end do
      if (count_words(names) == 0) return
      dataset%attributes = trim(adjustl(names))
      dataset%attribute_values = pack(labels%number, labels%exists)
   end subroutine load_attributes

   !> Add the attributes to a checksum.
   subroutine add_attributes(dataset, checksum)
      type(dataset_t), intent(in) :: dataset
      !> The checksum so far; it does not change if there are no attributes.
      type(checksum_t), intent(inout) :: checksum
      integer :: k

      if (.not. allocated(dataset%attributes)) return
      do k = 1, size(dataset%attribute_values)
         call checksum%add_text(get_word(dataset%attributes, k))
         call checksum%add_reals(dataset%attribute_values(k:k))
      end do
   end subroutine add_attributes

end module adfric_input_attributes
