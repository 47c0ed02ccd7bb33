! SPDX-License-Identifier: GPL-3.0-or-later
!> Lists of numbers that stand in an input, in place of the name of a dataset.
module adfric_input_given_list
   use adfric_base_kinds, only: dp, i8
   use adfric_base_text, only: show_count
   use adfric_input_item, only: item_t, next_item
   use adfric_input_number_list, only: read_list
   use adfric_input_variable, only: describe_allowed, find_outlier
   use adfric_describe_table, only: variable_t
   use adfric_run_dataset, only: dataset_t
   use adfric_system_checksum, only: checksum_t
   implicit none (type, external)
   private
   public :: is_dataset_name, read_numbers, keep_numbers

contains

   !> Does a value begin with a quote, so that it is the name of a dataset and no list of numbers?
   pure logical function is_dataset_name(text)
      !> Text of the value, as it stands in the input.
      character(*), intent(in) :: text
      type(item_t) :: item
      character(:), allocatable :: flaw
      integer :: position

      position = 1
      call next_item(text, position, item, flaw)
      is_dataset_name = .false.
      if (item%first > 0 .and. item%first <= item%last) &
         is_dataset_name = scan(text(item%first:item%first), '''"') == 1
   end function is_dataset_name

   !> Read the numbers of a list.
   subroutine read_numbers(text, variable, dataset, flaw, index)
      character(*), intent(in) :: text
      !> Row of the model's table: unit, bounds and number of values.
      type(variable_t), intent(in) :: variable
      !> Receives the numbers; left as it is if something is wrong.
      type(dataset_t), intent(inout) :: dataset
      character(:), allocatable, intent(out) :: flaw
      !> Position in the text of what is wrong, from 1.
      integer, intent(out) :: index
      real(dp), allocatable :: numbers(:)

      call read_list(text, numbers, flaw, index, most=variable%most_count)
      if (len(flaw) > 0) then
         flaw = flaw//', allowed: '//describe_allowed(variable)
      else
         call keep_numbers(numbers, variable, dataset, flaw)
         index = 1
      end if
   end subroutine read_numbers

   !> Hold numbers against what their variable allows, and keep them.
   subroutine keep_numbers(numbers, variable, dataset, flaw)
      !> The numbers in the SI unit of the variable.
      real(dp), intent(in) :: numbers(:)
      !> Row of the model's table: unit, bounds and number of values.
      type(variable_t), intent(in) :: variable
      !> Receives the numbers, and what is known of them; left as it is if something is wrong.
      type(dataset_t), intent(inout) :: dataset
      !> What is wrong, what was given, what is allowed; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw
      type(dataset_t) :: list
      type(checksum_t) :: checksum
      integer :: first

      flaw = ''
      if (size(numbers) < variable%least_count) flaw = 'too few values'
      if (size(numbers) > variable%most_count) flaw = 'too many values'
      if (len(flaw) > 0) then
         flaw = flaw//', given '//show_count(size(numbers))//', allowed: '//describe_allowed(variable)
      else
         call find_outlier(numbers, variable, first, flaw)
      end if
      if (len(flaw) > 0) return
      list%text = 'a list of '//show_count(size(numbers))//' numbers'
      list%counts = [size(numbers, kind=i8)]
      list%units = ''
      list%numbers = numbers
      list%lowest = minval(numbers)
      list%highest = maxval(numbers)
      call checksum%add_reals(numbers)
      list%checksum = checksum%to_text()
      dataset = list
   end subroutine keep_numbers

end module adfric_input_given_list
