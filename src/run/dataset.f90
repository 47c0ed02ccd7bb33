!> What a run knows of a dataset that one of its variables names; the model has its values.
module adfric_run_dataset
   use adfric_base_kinds, only: dp, i8
   use adfric_base_text, only: show_count, show_number, show_text
   use adfric_system_checksum, only: checksum_length
   implicit none (type, external)
   private
   public :: dataset_t

   !> A dataset; everything but `text`, `file` and `path` is known once it has been loaded.
   type :: dataset_t
      !> Names of file and dataset as the user gave them, FILE:/DATASET; not allocated where no dataset is given.
      character(:), allocatable :: text
      !> Name of the file.
      character(:), allocatable :: file
      !> Name of the dataset within the file.
      character(:), allocatable :: path
      !> Number of values along each dimension, as the file has them: the slowest first.
      integer(i8), allocatable :: counts(:)
      !> Units in which the file has the values; empty where it does not say them, and they are in SI units.
      character(:), allocatable :: units
      !> Least value in SI units.
      real(dp) :: lowest = 0
      !> Greatest value in SI units.
      real(dp) :: highest = 0
      !> Checksum of the values in SI units as 64-bit numbers, in the order of the file.
      character(checksum_length) :: checksum = ''
   contains
      procedure :: is_given
      procedure :: describe
   end type dataset_t

contains

   !> Does a variable name a dataset?
   elemental logical function is_given(self)
      !> The dataset of a variable; it has a text if the variable names one.
      class(dataset_t), intent(in) :: self

      is_given = allocated(self%text)
   end function is_given

   !> The dataset with its shape and range, in words.
   pure function describe(self) result(text)
      !> A dataset that has been loaded.
      class(dataset_t), intent(in) :: self
      character(:), allocatable :: text
      integer :: k

      text = ''''//self%text//''', '
      do k = 1, size(self%counts)
         if (k > 1) text = text//' x '
         text = text//show_count(self%counts(k))
      end do
      text = text//' values'
      if (len(self%units) > 0) text = text//' in '//show_text(self%units)
      text = text//', '//show_number(self%lowest)//' to '//show_number(self%highest)
   end function describe

end module adfric_run_dataset
