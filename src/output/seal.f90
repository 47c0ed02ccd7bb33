! SPDX-License-Identifier: GPL-3.0-or-later
!> The seal of a results file: a checksum of every byte that does not change any more once the file has been created.
!>
!> HDF5 believes what a file says of itself, and a file that has been damaged makes it crash, hang, or give other values. So the
!> bytes are compared with the seal before HDF5 sees them. The seal is a dataset, created before all others, so that it stands
!> near the beginning, where it is found by its mark. Left out, as holes, are what is written while the run goes on: the values
!> of the results, which have checksums of their own, and numbers that are known at the end.
module adfric_output_seal
   use, intrinsic :: iso_c_binding, only: c_int
   use hdf5, only: hid_t
   use adfric_base_error, only: error_t, set_error, file_failure
   use adfric_base_kinds, only: dp, i8
   use adfric_hdf5_attributes, only: write_attribute
   use adfric_hdf5_calls, only: hdf5_calls_t, no_id
   use adfric_hdf5_datasets, only: create_group, create_space, create_integer_dataset, write_values, close_dataset
   use adfric_hdf5_reading, only: get_extent
   use adfric_output_field_dataset, only: count_group
   use adfric_system_checksum, only: mix_integers
   use adfric_system_files, only: error_text
   use adfric_system_file_bytes, only: size_of_file, sum_of_file, find_word, read_words, is_short
   implicit none (type, external)
   private
   public :: seal_t, check_seal, placeholder

   !> The words of a seal: its mark, how many words it has, the size of the file, the checksum of its bytes, the number of
   !> holes, the holes, zeros, and last the checksum of these words. The mark is 'adfric' and two bytes that are no text.
   integer(i8), parameter :: mark = int(z'01F7636972666461', i8)
   integer, parameter :: n_words_before = 5
   !> The mark stands within so many bytes from the beginning, and no seal has more words.
   integer(i8), parameter :: latest = 65536, most_words = 20000

   !> First byte and number of bytes of what HDF5 changes itself: is the file open now? HDF5 believes nothing of it.
   integer(i8), parameter :: flags(2) = [20, 4]

   !> A seal that is being made.
   type :: seal_t
      private
      !> The dataset of the seal while it is open.
      integer(hid_t) :: dataset = no_id
      !> Number of words of the seal.
      integer :: n_words = 0
   contains
      procedure :: create
      procedure :: write => write_seal
   end type seal_t

contains

   !> A number that stands for one that is known at the end: a NaN of its own.
   pure real(dp) function placeholder(i)
      !> Number of the placeholder, from 1 on; each has another NaN.
      integer, intent(in) :: i
      integer(i8), parameter :: first = int(z'7FF8ADF71C000000', i8)

      placeholder = transfer(first + i, 0.0_dp)
   end function placeholder

   !> Create the dataset of the seal, and the group in which it is; before all other datasets.
   subroutine create(self, calls, file, n_holes)
      class(seal_t), intent(inout) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      integer(hid_t), intent(in) :: file
      !> Largest number of holes that the seal will have.
      integer, intent(in) :: n_holes
      integer(hid_t) :: group, space

      self%n_words = n_words_before + 2*(n_holes + 2) + 1
      call create_group(calls, file, count_group, group)
      call calls%close_id(group)
      call create_space(calls, [int(self%n_words, i8)], space)
      call create_integer_dataset(calls, file, count_group//'/seal', space, self%dataset)
      call calls%close_id(space)
      call write_attribute(calls, self%dataset, 'units', '1')
      call write_attribute(calls, self%dataset, 'long_name', 'checksum of the bytes of this file that never change')
   end subroutine create

   !> Write the seal into a file that has been handed to the operating system as a whole.
   subroutine write_seal(self, calls, path, extents, n_placeholders)
      class(seal_t), intent(inout) :: self
      type(hdf5_calls_t), intent(inout) :: calls
      character(*), intent(in) :: path
      !> Where values stand that are written later, see `get_extents` of the datasets.
      integer(i8), intent(in) :: extents(:, :)
      integer, intent(in) :: n_placeholders
      integer(i8), allocatable :: holes(:, :), words(:)
      integer(i8) :: own(2), index, sum, n_bytes
      integer(hid_t) :: space
      integer :: i, n_found, number

      call get_extent(calls, self%dataset, own(1), own(2))
      n_bytes = size_of_file(path)
      number = 0
      sum = 0
      holes = in_order(reshape([flags, own, extents], [2, 2 + size(extents, 2)]))
      do i = 1, n_placeholders
         call find_word(path, n_bytes, holes, transfer(placeholder(i), 0_i8), index, n_found, number)
         if (number == 0 .and. n_found /= 1) call calls%fail('the attributes cannot be found in the file')
         if (number /= 0) exit
         holes = in_order(reshape([holes, [index, 8_i8]], [2, 1 + size(holes, 2)]))
      end do
      if (number == 0) call sum_of_file(path, n_bytes, holes, sum, number)
      if (number > 0) call calls%fail(error_text(int(number, c_int)))
      if (number < 0) call calls%fail('the file is shorter than it should be')
      allocate (words(self%n_words), source=0_i8)
      words(:n_words_before) = [mark, int(self%n_words, i8), n_bytes, sum, size(holes, 2, kind=i8)]
      words(n_words_before + 1:n_words_before + size(holes)) = reshape(holes, [size(holes)])
      words(self%n_words) = mix_integers(0_i8, self%n_words - 1, words)
      call create_space(calls, [int(self%n_words, i8)], space)
      call write_values(calls, self%dataset, space, space, words)
      call calls%close_id(space)
      call close_dataset(calls, self%dataset)
   end subroutine write_seal

   !> Holes as they rise, without those that are empty.
   pure function in_order(holes) result(rising)
      !> Holes in any order: first byte, from 0, and number of bytes; shape `(2, n)`.
      integer(i8), intent(in) :: holes(:, :)
      integer(i8), allocatable :: rising(:, :)
      logical :: is_left(size(holes, 2))
      integer :: i, next

      is_left = holes(2, :) > 0
      allocate (rising(2, count(is_left)))
      do i = 1, size(rising, 2)
         next = minloc(holes(1, :), dim=1, mask=is_left)
         rising(:, i) = holes(:, next)
         is_left(next) = .false.
      end do
   end function in_order

   !> Is a file a results file that has not been damaged? Asked before HDF5 opens it.
   subroutine check_seal(path, error)
      character(*), intent(in) :: path
      !> Allocated if the file cannot be read, is damaged, or is no results file.
      type(error_t), allocatable, intent(out) :: error
      integer(i8), allocatable :: words(:)
      integer(i8) :: sum
      integer :: number

      call read_seal(path, words, number)
      if (number == 0) then
         associate (n_holes => int(words(5)))
            call sum_of_file(path, words(3), reshape(words(n_words_before + 1:n_words_before + 2*n_holes), [2, n_holes]), &
               sum, number)
         end associate
         if (number == 0 .and. sum /= words(4)) number = is_short
      end if
      if (number > 0) then
         call set_error(error, file_failure, path//': cannot read: '//error_text(int(number, c_int)))
      else if (number < 0) then
         call set_error(error, file_failure, path//': cannot read: it is damaged, or no results file of adfric')
      end if
   end subroutine check_seal

   !> Read the seal of a file.
   subroutine read_seal(path, words, number)
      character(*), intent(in) :: path
      !> Receives the words of the seal; not to be used if `number` is not 0.
      integer(i8), allocatable, intent(out) :: words(:)
      !> 0; `is_short` if there is no seal, or a damaged one; or an error number of the system.
      integer, intent(out) :: number
      integer(i8), allocatable :: empty(:, :)
      integer(i8) :: index, head(2)
      integer :: n_found

      allocate (empty(2, 0))
      call find_word(path, min(latest, max(size_of_file(path), 0_i8)), empty, mark, index, n_found, number)
      if (number == 0 .and. n_found == 0) number = is_short
      if (number == 0) call read_words(path, index, head, number)
      if (number == 0) then
         if (head(2) <= n_words_before .or. head(2) > most_words) number = is_short
      end if
      if (number /= 0) return
      allocate (words(head(2)), source=0_i8)
      call read_words(path, index, words, number)
      if (number /= 0) return
      associate (n => size(words))
         if (words(n) /= mix_integers(0_i8, n - 1, words)) number = is_short
         if (number == 0 .and. .not. makes_sense(words)) number = is_short
      end associate
   end subroutine read_seal

   !> Are there as many holes in a seal as it says, which rise within the file?
   pure logical function makes_sense(words)
      !> Those of the seal.
      integer(i8), intent(in) :: words(:)
      integer(i8) :: last
      integer :: i

      makes_sense = words(3) >= 0 .and. words(5) >= 0 .and. words(5) <= (size(words) - n_words_before - 1)/2
      if (.not. makes_sense) return
      last = 0
      do i = n_words_before + 1, n_words_before + 2*int(words(5)), 2
         makes_sense = words(i) >= last .and. words(i) <= words(3) .and. words(i + 1) >= 0
         ! compared without a sum that might be too large
         if (makes_sense) makes_sense = words(i + 1) <= words(3) - words(i)
         if (.not. makes_sense) return
         last = words(i) + words(i + 1)
      end do
   end function makes_sense

end module adfric_output_seal
