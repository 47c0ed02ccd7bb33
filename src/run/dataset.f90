! SPDX-License-Identifier: GPL-3.0-or-later
!> What a run knows of the data of one of its variables: a dataset or a group that it names, or a list of numbers. The model has
!> the values.
module adfric_run_dataset
   use adfric_base_kinds, only: dp, i8
   use adfric_base_text, only: join_words, show_count, show_number, show_text
   use adfric_base_words, only: get_word
   use adfric_system_checksum, only: checksum_length
   implicit none (type, external)
   private
   public :: dataset_t

   !> Longest list of which all numbers are shown.
   integer, parameter :: most_shown = 10

   !> A dataset, a group or a list; everything but `text`, `file`, `path` and the `numbers` of an input is known once it has been
   !> loaded.
   type :: dataset_t
      !> Names of file and dataset as the user gave them, FILE:/DATASET, or how many numbers are given; not allocated where there
      !> is neither.
      character(:), allocatable :: text
      !> Name of the file; not allocated for a list of numbers.
      character(:), allocatable :: file
      !> Name of the dataset or group within the file, or of the column of a table; empty for all columns of one.
      character(:), allocatable :: path
      !> Is it a column of a table of text, or a whole one?
      logical :: is_column = .false.
      !> How the table was read, in words; not allocated if it is none.
      character(:), allocatable :: form
      !> The numbers of a list, in SI units; not allocated if it is none.
      real(dp), allocatable :: numbers(:)
      !> Names of the datasets that a group has, separated by a blank; not allocated if it is no group.
      character(:), allocatable :: columns
      !> Names of the attributes that are there and that the model takes, separated by a blank; not allocated if there are none.
      character(:), allocatable :: attributes
      !> Numbers of these attributes.
      real(dp), allocatable :: attribute_values(:)
      !> Number of values along each dimension, as the file has them: the slowest first.
      integer(i8), allocatable :: counts(:)
      !> Units in which the file has the values; empty where it does not say them, and they are in SI units.
      character(:), allocatable :: units
      !> Least value in SI units, of a group that of its first dataset.
      real(dp) :: lowest = 0
      !> Greatest value in SI units, of a group that of its first dataset.
      real(dp) :: highest = 0
      !> Checksum of the values in SI units as 64-bit numbers, in the order of the file, and of the attributes behind them.
      character(checksum_length) :: checksum = ''
   contains
      procedure :: is_given
      procedure :: is_in_file
      procedure :: describe
   end type dataset_t

contains

   !> Does a variable name a dataset?
   elemental logical function is_given(self)
      !> The dataset of a variable; it has a text if the variable names one.
      class(dataset_t), intent(in) :: self

      is_given = allocated(self%text)
   end function is_given

   !> Does a variable name a dataset or a group of a file?
   elemental logical function is_in_file(self)
      !> The dataset of a variable; it has a file if the variable names one.
      class(dataset_t), intent(in) :: self

      is_in_file = allocated(self%file)
   end function is_in_file

   !> The dataset with its shape and range, or the numbers of a list, in words.
   pure function describe(self) result(text)
      class(dataset_t), intent(in) :: self
      character(:), allocatable :: text
      integer :: k

      if (.not. self%is_in_file() .and. allocated(self%numbers)) then
         text = describe_numbers(self%numbers)
         return
      end if
      text = ''''//self%text//''', '
      do k = 1, size(self%counts)
         if (k > 1) text = text//' x '
         text = text//show_count(self%counts(k))
      end do
      text = text//' values'
      if (allocated(self%columns)) text = text//' of '//join_words(self%columns, ', ')//', '//get_word(self%columns, 1)
      if (len(self%units) > 0) text = text//' in '//show_text(self%units)
      if (.not. allocated(self%columns)) text = text//','
      text = text//' '//show_number(self%lowest)//' to '//show_number(self%highest)
      if (.not. allocated(self%attributes)) return
      do k = 1, size(self%attribute_values)
         text = text//', '//get_word(self%attributes, k)//' = '//show_number(self%attribute_values(k))
      end do
   end function describe

   !> The numbers of a list: all of a short one, the range of a long one.
   pure function describe_numbers(numbers) result(text)
      !> The numbers, at least one.
      real(dp), intent(in) :: numbers(:)
      character(:), allocatable :: text
      integer :: k

      text = show_number(numbers(1))
      if (size(numbers) > most_shown) then
         text = show_count(size(numbers))//' numbers, '//show_number(minval(numbers))//' to '//show_number(maxval(numbers))
         return
      end if
      do k = 2, size(numbers)
         text = text//', '//show_number(numbers(k))
      end do
   end function describe_numbers

end module adfric_run_dataset
