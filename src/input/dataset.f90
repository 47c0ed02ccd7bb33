!> A dataset of an HDF5 file that a variable names, as in 'FILE.h5:/path/of/dataset'.
module adfric_input_dataset
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_checksum, only: checksum_t, checksum_length
   use adfric_base_kinds, only: dp, i8
   use adfric_base_model, only: variable_t
   use adfric_input_item, only: take_only_word
   use adfric_input_literal, only: convert
   use adfric_input_text, only: show_count, show_number
   use adfric_output_hdf5_layer_samples, only: read_numbers
   implicit none (type, external)
   private
   public :: dataset_t, read_dataset_name, load_dataset

   !> What stands between the name of the file and that of the dataset, with which the latter begins.
   character(*), parameter :: divider = ':/'

   !> A dataset; everything but `text` is known once it has been loaded.
   type :: dataset_t
      !> As it stands in the input; not allocated where no dataset is given.
      character(:), allocatable :: text
      !> Name of the file, and of the dataset within it.
      character(:), allocatable :: file, path
      !> Number of values along each dimension, as the file has them: the slowest first.
      integer(i8), allocatable :: counts(:)
      !> Range of the values.
      real(dp) :: lowest = 0, highest = 0
      !> Of the values as 64-bit numbers, in the order of the file.
      character(checksum_length) :: checksum = ''
   contains
      procedure :: is_given
      procedure :: describe
   end type dataset_t

contains

   !> Does a variable name a dataset?
   elemental logical function is_given(self)
      class(dataset_t), intent(in) :: self

      is_given = allocated(self%text)
   end function is_given

   !> The dataset with its shape and range, in words.
   pure function describe(self) result(text)
      class(dataset_t), intent(in) :: self
      character(:), allocatable :: text
      integer :: k

      text = ''''//self%text//''', '
      do k = 1, size(self%counts)
         if (k > 1) text = text//' x '
         text = text//show_count(self%counts(k))
      end do
      text = text//' values, '//show_number(self%lowest)//' to '//show_number(self%highest)
   end function describe

   !> Read the name of a dataset.
   pure subroutine read_dataset_name(text, dataset, flaw, place)
      !> Text of the value.
      character(*), intent(in) :: text
      !> Not given if something is wrong.
      type(dataset_t), intent(inout) :: dataset
      !> What is wrong and what was given; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw
      !> Position of what is wrong in the text.
      integer, intent(out) :: place
      character(:), allocatable :: word, name
      integer :: colon

      call take_only_word(text, word, flaw, place)
      if (len(flaw) == 0) call convert(word, name, flaw)
      if (len(flaw) > 0) return
      colon = index(name, divider, back=.true.)
      if (colon <= 1 .or. len(name) <= colon + 1) then
         flaw = 'does not name a dataset of a file, given '''//name//''''
         return
      end if
      dataset%text = name
      dataset%file = name(:colon - 1)
      dataset%path = name(colon + 1:)
   end subroutine read_dataset_name

   !> Read the values of a dataset and hold them against what its variable allows.
   subroutine load_dataset(dataset, variable, values, flaw)
      type(dataset_t), intent(inout) :: dataset
      type(variable_t), intent(in) :: variable
      !> As a model takes them.
      real(dp), allocatable, intent(out) :: values(:, :)
      !> What is wrong; empty if nothing is.
      character(:), allocatable, intent(out) :: flaw
      type(checksum_t) :: checksum
      integer :: j

      call read_numbers(dataset%file, dataset%path, variable%largest_rank, values, dataset%counts, flaw)
      if (len(flaw) > 0) return
      if (any(dataset%counts < variable%least_count)) then
         flaw = 'too few values in the dataset'
         return
      end if
      do j = 1, size(values, 2)
         if (.not. all(ieee_is_finite(values(:, j)))) then
            flaw = 'NaN or Inf in the dataset'
            return
         end if
         call checksum%add_reals(values(:, j))
      end do
      dataset%lowest = minval(values)
      dataset%highest = maxval(values)
      dataset%checksum = checksum%to_text()
      if (dataset%lowest < variable%lower) flaw = show_outlier(dataset%lowest, '>= ', variable%lower)
      if (dataset%highest > variable%upper) flaw = show_outlier(dataset%highest, '<= ', variable%upper)
   end subroutine load_dataset

   !> What to say of a value out of range.
   pure function show_outlier(value, relation, bound) result(text)
      real(dp), intent(in) :: value
      character(*), intent(in) :: relation
      real(dp), intent(in) :: bound
      character(:), allocatable :: text

      text = 'a value of the dataset is out of range, '//show_number(value)//' is not '//relation//show_number(bound)
   end function show_outlier

end module adfric_input_dataset
