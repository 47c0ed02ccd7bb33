! SPDX-License-Identifier: GPL-3.0-or-later
!> A dataset of an HDF5 file that a variable names, as in 'FILE.h5:/path/of/dataset', or a column of a table, 'FILE.csv:COLUMN'.
module adfric_input_dataset
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp, i8
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_units, only: unit_t, to_si
   use adfric_base_text, only: longest_name, show_count, show_number, show_text
   use adfric_hdf5_samples, only: read_numbers
   use adfric_input_attributes, only: add_attributes
   use adfric_input_item, only: take_only_word
   use adfric_input_head_unit, only: add_unit, head_t, split_head
   use adfric_input_literal, only: convert
   use adfric_input_table_name, only: find_column_name, is_table_name
   use adfric_input_text_table, only: text_table_t, open_text_table
   use adfric_input_unit_match, only: match_units
   use adfric_describe_table, only: variable_t
   use adfric_run_dataset, only: dataset_t
   use adfric_system_checksum, only: checksum_t
   implicit none (type, external)
   private
   public :: read_dataset_name, load_dataset, load_numbers, take_numbers, examine_values, honour_name

   !> What stands between the name of the file and that of the dataset, with which the latter begins.
   character(*), parameter :: divider = ':/'
   !> Sizes of the numbers of physics: none is larger, and if all are smaller they should be 0.
   real(dp), parameter :: largest = 1.0e60_dp, smallest = 1.0e-60_dp

contains

   !> Read the name of a dataset.
   pure subroutine read_dataset_name(text, takes_table, dataset, flaw, position)
      !> Text of the value, as it stands in the input.
      character(*), intent(in) :: text
      !> May a table of text be named as a whole?
      logical, intent(in) :: takes_table
      !> Receives the names of file and dataset; left as it is if something is wrong.
      type(dataset_t), intent(inout) :: dataset
      character(:), allocatable, intent(out) :: flaw
      !> Position in the text of what is wrong, from 1.
      integer, intent(out) :: position
      character(:), allocatable :: word, name
      integer :: colon

      call take_only_word(text, word, flaw, position)
      if (len(flaw) == 0) call convert(word, name, flaw)
      if (len(flaw) > 0) return
      if (takes_table .and. is_table_name(name) .and. len(name) <= longest_name) then
         dataset%is_column = .true.
         dataset%text = name
         dataset%file = name
         dataset%path = ''
         return
      end if
      colon = find_column_name(name)
      dataset%is_column = colon > 0
      if (.not. dataset%is_column) colon = index(name, divider, back=.true.)
      if (colon <= 1 .or. len(name) <= colon + merge(0, 1, dataset%is_column)) then
         flaw = 'does not name a dataset of a file, given '''//show_text(name)//''''
         return
      else if (len(name) > longest_name) then
         flaw = 'too long for the name of a file, given '''//show_text(name)//''''
         return
      end if
      dataset%text = name
      dataset%file = name(:colon - 1)
      dataset%path = name(colon + 1:)
   end subroutine read_dataset_name

   !> Read the values of a dataset and hold them against what its variable allows.
   subroutine load_dataset(dataset, variable, values, flaw)
      !> In: the names of file and dataset, and the attributes. Out: also shape, units, range and checksum.
      type(dataset_t), intent(inout) :: dataset
      !> Row of the model's table: unit, bounds, number of dimensions and of values.
      type(variable_t), intent(in) :: variable
      !> The values in SI units, the last dimension of the file first; shape `(n, 1)` for one dimension.
      real(dp), allocatable, intent(out) :: values(:, :)
      !> What is wrong with the file, the dataset or its values; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw

      call load_numbers(dataset, variable%largest_rank, values, flaw)
      if (len(flaw) == 0) call examine_values(dataset, variable, values, flaw)
   end subroutine load_dataset

   !> Read the numbers of a dataset or a column as the file has them.
   subroutine load_numbers(dataset, largest_rank, values, flaw)
      !> In: the names of file and dataset. Out: also shape and units.
      type(dataset_t), intent(inout) :: dataset
      !> Largest number of dimensions that the dataset may have, 1 or 2.
      integer, intent(in) :: largest_rank
      !> The numbers in their units, the last dimension of the file first; shape `(n, 1)` for one dimension.
      real(dp), allocatable, intent(out) :: values(:, :)
      !> What is wrong with the file or the dataset; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw
      type(text_table_t) :: table
      type(error_t), allocatable :: error

      if (.not. dataset%is_column) then
         call read_numbers(dataset%file, dataset%path, largest_rank, values, dataset%counts, dataset%units, flaw)
         if (len(flaw) == 0) call honour_name(dataset%path, dataset%units, flaw)
         return
      end if
      flaw = ''
      call open_text_table(table, dataset%file, error)
      if (allocated(error)) then
         flaw = error%message
      else
         call take_numbers(table, dataset, values, flaw)
      end if
   end subroutine load_numbers

   !> Honour the unit that the name of a dataset has, as in `load_nN`, where no attribute says the units.
   pure subroutine honour_name(path, units, flaw)
      !> Name of the dataset within its file.
      character(*), intent(in) :: path
      !> In: the units that the attribute says; empty: there is none. Out: those of the numbers.
      character(:), allocatable, intent(inout) :: units
      !> What is wrong with the name; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw
      type(head_t) :: head

      call split_head(path(index(path, '/', back=.true.) + 1:), head)
      call add_unit(head, units)
      units = head%unit
      flaw = head%flaw
   end subroutine honour_name

   !> Take the numbers of a column of an open table, each of which there has to be.
   subroutine take_numbers(table, dataset, values, flaw)
      type(text_table_t), intent(in) :: table
      !> In: the names of file and column. Out: also shape and units.
      type(dataset_t), intent(inout) :: dataset
      !> The numbers in their units; shape `(n, 1)`.
      real(dp), allocatable, intent(out) :: values(:, :)
      !> What is wrong with the column; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw
      type(error_t), allocatable :: error
      real(dp), allocatable :: column(:)
      integer :: missing

      flaw = ''
      call table%get_numbers(dataset%path, column, error)
      if (allocated(error)) then
         flaw = error%message
         return
      end if
      missing = findloc(ieee_is_nan(column), .true., dim=1)
      if (missing > 0) flaw = dataset%file//', line '//show_count(table%line_of_row(missing))//': column ' &
         //show_text(dataset%path)//': no value'
      dataset%counts = [size(column, kind=i8)]
      dataset%units = table%unit_of(dataset%path)
      dataset%form = table%describe()
      values = reshape(column, [size(column), 1])
   end subroutine take_numbers

   !> Hold the values of a dataset against what its variable allows.
   subroutine examine_values(dataset, variable, values, flaw)
      !> In: shape, units and attributes. Out: also range and checksum.
      type(dataset_t), intent(inout) :: dataset
      !> Row of the model's table: unit, bounds, number of dimensions and of values.
      type(variable_t), intent(in) :: variable
      !> In: the values in their units, the last dimension of the dataset first. Out: the values in SI units.
      real(dp), intent(inout) :: values(:, :)
      !> What is wrong with the dataset or its values; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw
      type(checksum_t) :: checksum
      logical, allocatable :: is_there(:, :)
      integer :: j
      logical :: lacks_values

      flaw = ''
      if (any(dataset%counts < variable%least_count)) flaw = 'too few values in the dataset'
      if (any(dataset%counts > variable%most_count)) flaw = 'too many values in the dataset'
      if (len(flaw) > 0) return
      allocate (is_there(size(values, 1), size(values, 2)))
      call find_lacking(variable, values, is_there, flaw)
      lacks_values = .not. all(is_there)
      if (len(flaw) > 0) return
      call convert_units(dataset%units, variable%unit, values, flaw)
      if (len(flaw) > 0) return
      do j = 1, size(values, 2)
         call checksum%add_reals(values(:, j))
         if (lacks_values) call checksum%add_reals(merge(1.0_dp, 0.0_dp, is_there(:, j)))
      end do
      call add_attributes(dataset, checksum)
      dataset%checksum = checksum%to_text()
      dataset%lowest = minval(values)
      dataset%highest = maxval(values)
      if (dataset%lowest < max(variable%lower, -largest)) &
         flaw = show_outlier(dataset%lowest, '>= ', max(variable%lower, -largest))
      if (variable%lower_open .and. .not. dataset%lowest > variable%lower) &
         flaw = show_outlier(dataset%lowest, '> ', variable%lower)
      if (dataset%highest > min(variable%upper, largest)) &
         flaw = show_outlier(dataset%highest, '<= ', min(variable%upper, largest))
      associate (size_of_all => max(-dataset%lowest, dataset%highest))
         if (size_of_all > 0 .and. size_of_all < smallest) flaw = 'the values of the dataset are too small, the largest is '// &
            show_number(size_of_all)//', not 0 or >= '//show_number(smallest)
      end associate
      if (lacks_values) where (.not. is_there) values = not_a_number()
   end subroutine examine_values

   !> Find values that are no numbers. Where some may lack, another one stands for them, until all have been examined.
   pure subroutine find_lacking(variable, values, is_there, flaw)
      type(variable_t), intent(in) :: variable
      !> In: values as the file has them. Out: numbers alone.
      real(dp), intent(inout) :: values(:, :)
      !> Receives which values are there; same shape.
      logical, intent(out) :: is_there(:, :)
      !> In: empty. Out: why the values will not do; empty if they will.
      character(:), allocatable, intent(inout) :: flaw
      integer :: j, cell(2)

      is_there(:, :) = .true.
      do j = 1, size(values, 2)
         if (all(ieee_is_finite(values(:, j)))) cycle
         is_there(:, j) = .not. ieee_is_nan(values(:, j))
         if (.not. variable%may_lack_values) then
            flaw = 'NaN or Inf in the dataset'
         else if (.not. all(ieee_is_finite(values(:, j)) .or. .not. is_there(:, j))) then
            flaw = 'Inf in the dataset; what is not known is NaN'
         end if
         if (len(flaw) > 0) return
      end do
      if (all(is_there)) return
      cell = findloc(is_there, .true.)
      if (any(cell == 0)) then
         flaw = 'all values of the dataset are NaN'
         return
      end if
      values(:, :) = merge(values, values(cell(1), cell(2)), is_there)
   end subroutine find_lacking

   !> Convert values to SI units.
   pure subroutine convert_units(units, wanted, values, flaw)
      !> Units in which the values are; empty: SI units.
      character(*), intent(in) :: units
      !> SI unit of the variable.
      character(*), intent(in) :: wanted
      !> Finite values, which are converted in place.
      real(dp), intent(inout) :: values(:, :)
      !> In: empty. Out: why the values cannot be converted; empty if that is done.
      character(:), allocatable, intent(inout) :: flaw
      type(unit_t) :: unit
      integer :: j

      if (len(units) == 0) return
      call match_units(units, wanted, 'dataset', unit, flaw)
      if (len(flaw) > 0) return
      if (maxval(abs(values)) > largest) then
         ! it might be beyond all numbers once it is converted
         flaw = 'a value of the dataset is out of range, '//show_number(maxval(abs(values)))//' '//show_text(units)
         return
      end if
      do j = 1, size(values, 2)
         values(:, j) = to_si(values(:, j), unit)
      end do
   end subroutine convert_units

   !> What to say of a value out of range.
   pure function show_outlier(value, relation, bound) result(text)
      !> The value in SI units.
      real(dp), intent(in) :: value
      !> What the value should be to the bound and is not, with a blank at the end, such as '>= '.
      character(*), intent(in) :: relation
      !> The bound in SI units.
      real(dp), intent(in) :: bound
      character(:), allocatable :: text

      text = 'a value of the dataset is out of range, '//show_number(value)//' is not '//relation//show_number(bound)
   end function show_outlier

end module adfric_input_dataset
