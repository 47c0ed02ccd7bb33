! SPDX-License-Identifier: GPL-3.0-or-later
!> Datasets of one dimension and equal length, side by side in a group of an HDF5 file, as in 'FILE.h5:/path/of/group'; or columns of
!> a table of text, as in 'FILE.csv'.
module adfric_input_group_columns
   use adfric_base_constants, only: pi
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_base_printable, only: shell_word
   use adfric_base_text, only: show_count, show_text, to_lower
   use adfric_base_words, only: get_word
   use adfric_hdf5_members, only: find_members
   use adfric_input_attributes, only: add_attributes
   use adfric_input_dataset, only: examine_values, load_dataset
   use adfric_input_text_table, only: open_text_table, text_table_t
   use adfric_describe_table, only: variable_t
   use adfric_run_dataset, only: dataset_t
   use adfric_system_checksum, only: checksum_t
   implicit none (type, external)
   private
   public :: load_columns, examine_columns

   !> The dataset for which another one may stand, in which a turn counts 1 instead of 2 pi, and their units.
   character(*), parameter :: circular_name = 'omega', cycle_name = 'frequency', cycle_unit = 'Hz'
   !> The columns of a master curve.
   character(*), parameter :: curve_columns = 'omega storage loss'

contains

   !> Read the datasets of a group and hold them against what the variable allows.
   subroutine load_columns(dataset, variable, values, flaw)
      !> In: the names of file and group, and the attributes. Out: also length, range and checksum.
      type(dataset_t), intent(inout) :: dataset
      !> Row of the model's table: names and units of the datasets, bounds and number of values.
      type(variable_t), intent(in) :: variable
      !> The values in SI units; shape `(n, n_columns)`.
      real(dp), allocatable, intent(out) :: values(:, :)
      !> What is wrong with the file, the group or its datasets; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw
      character(:), allocatable :: name
      real(dp), allocatable :: column(:, :)
      integer :: k

      do k = 1, variable%n_columns()
         call choose_name(dataset, get_word(variable%columns, k), name, flaw)
         if (len(flaw) == 0) call load_column(dataset, variable, k, name, column, flaw)
         if (len(flaw) > 0) return
         if (k == 1) allocate (values(size(column, 1), variable%n_columns()))
         if (size(column, 1) /= size(values, 1)) then
            flaw = get_word(variable%columns, 1)//' and '//name//' of the group have not as many values, '// &
               show_count(size(values, 1))//' and '//show_count(size(column, 1))
            return
         end if
         values(:, k) = column(:, 1)
      end do
      call describe_columns(dataset, variable, values)
   end subroutine load_columns

   !> Hold columns that no file has against what their variable allows.
   subroutine examine_columns(dataset, variable, values, flaw)
      !> Receives length, range and checksum.
      type(dataset_t), intent(inout) :: dataset
      !> Row of the model's table: names and units of the columns, bounds and number of values.
      type(variable_t), intent(in) :: variable
      !> The values in SI units; shape `(n, n_columns)`.
      real(dp), intent(inout) :: values(:, :)
      !> What is wrong with the values; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw
      integer :: k

      flaw = ''
      dataset%counts = shape(values(:, :1))
      dataset%counts = dataset%counts(:1)
      dataset%units = ''
      do k = 1, size(values, 2)
         call examine_values(dataset, row_of(variable, k), values(:, k:k), flaw)
         if (len(flaw) == 0) cycle
         flaw = get_word(variable%columns, k)//': '//flaw
         return
      end do
      call describe_columns(dataset, variable, values)
   end subroutine examine_columns

   !> Find out under which name the group has a column.
   subroutine choose_name(dataset, wanted, name, flaw)
      type(dataset_t), intent(in) :: dataset
      !> Name of the column in the row of the variable.
      character(*), intent(in) :: wanted
      !> Receives the name of the dataset in the group.
      character(:), allocatable, intent(out) :: name
      !> Why there is no such dataset; empty if there is one.
      character(:), allocatable, intent(out) :: flaw
      logical :: exists(2)

      name = wanted
      if (dataset%is_column) then
         call find_columns(dataset%file, wanted, exists, flaw)
      else if (wanted == circular_name) then
         call find_members(dataset%file, dataset%path, wanted//' '//cycle_name, exists, flaw)
      else
         call find_members(dataset%file, dataset%path, wanted, exists(:1), flaw)
         exists(2) = .false.
      end if
      if (len(flaw) > 0) return
      if (all(exists)) flaw = 'the group has '//wanted//' and '//cycle_name//', one of them is enough'
      if (.not. any(exists)) flaw = 'there is no dataset '//wanted//' in the group'
      if (dataset%is_column .and. len(flaw) > 0) flaw = say_of_table(dataset%file, wanted, all(exists))
      if (exists(2)) name = cycle_name
   end subroutine choose_name

   !> Find out whether a table has a column, and the one that may stand for it.
   subroutine find_columns(file, wanted, exists, flaw)
      !> Name of the table.
      character(*), intent(in) :: file
      !> Name of the column in the row of the variable.
      character(*), intent(in) :: wanted
      !> Receives whether there is the column, and the other one.
      logical, intent(out) :: exists(2)
      !> Why the table cannot be read; empty if it can.
      character(:), allocatable, intent(out) :: flaw
      type(text_table_t) :: table
      type(error_t), allocatable :: error

      flaw = ''
      exists = .false.
      call open_text_table(table, file, error)
      if (allocated(error)) then
         flaw = error%message
      else
         exists(1) = table%has_column(wanted)
         if (wanted == circular_name) exists(2) = table%has_column(cycle_name)
      end if
   end subroutine find_columns

   !> What is wrong with a table: that a column is not there, or that two are the same quantity.
   function say_of_table(file, wanted, has_both) result(flaw)
      !> Name of the table.
      character(*), intent(in) :: file
      !> Name of the column in the row of the variable.
      character(*), intent(in) :: wanted
      !> Are there both columns that may stand for one another?
      logical, intent(in) :: has_both
      character(:), allocatable :: flaw

      if (has_both) then
         flaw = file//': has the columns '//wanted//' and '//cycle_name//', one of them is enough'
         return
      end if
      flaw = file//': there is no column '//wanted
      if (wanted == circular_name) flaw = flaw//' or '//cycle_name
      if (index(curve_columns, wanted) > 0) flaw = flaw//'; scripts/import_surface '//shell_word(file)// &
         ' --master-curve reads tables with other heads'
   end function say_of_table

   !> Read a dataset of the group.
   subroutine load_column(dataset, variable, k, name, column, flaw)
      !> Receives how a table was read.
      type(dataset_t), intent(inout) :: dataset
      type(variable_t), intent(in) :: variable
      !> Which of its columns is read, from 1.
      integer, intent(in) :: k
      !> Name of the dataset in the group.
      character(*), intent(in) :: name
      !> The values in the SI unit of the column; shape `(n, 1)`.
      real(dp), allocatable, intent(out) :: column(:, :)
      !> What is wrong with the dataset; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw
      type(dataset_t) :: part
      type(variable_t) :: row
      logical :: counts_turns

      counts_turns = name /= get_word(variable%columns, k)
      row = row_of(variable, k)
      if (counts_turns) row%unit = cycle_unit
      part%file = dataset%file
      part%is_column = dataset%is_column
      part%path = dataset%path//'/'//name
      if (dataset%is_column) part%path = name
      call load_dataset(part, row, column, flaw)
      if (allocated(part%form)) dataset%form = part%form
      ! both are 1/s, but not the same
      if (len(flaw) == 0) then
         if ((name == circular_name .and. is_in_hertz(part%units)) .or. (counts_turns .and. is_in_radians(part%units))) &
            flaw = 'the units '''//show_text(part%units)//''' of the dataset are of another quantity'
      end if
      if (len(flaw) > 0 .and. index(flaw, dataset%file//': ') /= 1) flaw = name//': '//flaw
      if (counts_turns .and. len(flaw) == 0) column = 2*pi*column
   end subroutine load_column

   !> The row of a column, as if it were a variable of its own.
   function row_of(variable, k) result(row)
      type(variable_t), intent(in) :: variable
      !> Index of the column, from 1.
      integer, intent(in) :: k
      type(variable_t) :: row

      row = variable
      row%name = get_word(variable%columns, k)
      row%unit = get_word(variable%column_units, k)
      row%columns = ''
      row%attributes = ''
   end function row_of

   !> Is a unit a number of turns in a time?
   pure logical function is_in_hertz(units)
      !> Unit as the file says it.
      character(*), intent(in) :: units

      is_in_hertz = index(units, 'Hz') > 0 .or. index(to_lower(units), 'hertz') > 0
   end function is_in_hertz

   !> Is a unit an angle in a time?
   pure logical function is_in_radians(units)
      character(*), intent(in) :: units

      is_in_radians = index(to_lower(units), 'rad') > 0
   end function is_in_radians

   !> Take note of what the columns are.
   subroutine describe_columns(dataset, variable, values)
      !> In: names and attributes. Out: also length, range and checksum.
      type(dataset_t), intent(inout) :: dataset
      type(variable_t), intent(in) :: variable
      !> The values in SI units; shape `(n, n_columns)`.
      real(dp), intent(in) :: values(:, :)
      type(checksum_t) :: checksum
      integer :: k

      dataset%columns = variable%columns
      dataset%counts = shape(values(:, :1))
      dataset%counts = dataset%counts(:1)
      dataset%units = ''
      dataset%lowest = minval(values(:, 1))
      dataset%highest = maxval(values(:, 1))
      do k = 1, size(values, 2)
         call checksum%add_text(get_word(variable%columns, k))
         call checksum%add_reals(values(:, k))
      end do
      call add_attributes(dataset, checksum)
      dataset%checksum = checksum%to_text()
   end subroutine describe_columns

end module adfric_input_group_columns
