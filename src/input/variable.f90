! SPDX-License-Identifier: GPL-3.0-or-later
!> The values of a model's variables: read from their groups, and compared with what the model's table allows.
module adfric_input_variable
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan
   use adfric_base_kinds, only: dp, i8
   use adfric_base_unset, only: unset
   use adfric_base_words, only: count_words, get_word
   use adfric_base_text, only: join_words, show_count, show_number, show_text
   use adfric_input_item, only: item_t, next_item, take_only_word
   use adfric_input_literal, only: convert
   use adfric_input_suggestion, only: did_you_mean
   use adfric_describe_table, only: variable_t, kind_real, kind_integer, kind_logical, kind_dataset, kind_text
   use adfric_describe_word_sets, only: has_number, with_number
   implicit none (type, external)
   private
   public :: read_variable, check_value, find_outlier, is_in_range, describe_allowed, show_value, words_of_text

   !> No number of physics is larger, or smaller without being 0.
   real(dp), parameter :: largest = 1.0e60_dp, smallest = 1.0e-60_dp

contains

   !> Read the value of a variable as it is kept, as a real number.
   subroutine read_variable(text, variable, value, flaw, index)
      !> Text of the value, as it stands in the input.
      character(*), intent(in) :: text
      !> Row of the model's table: kind, unit, default and what is allowed.
      type(variable_t), intent(in) :: variable
      !> The value as a real number; the default of the variable if something is wrong.
      real(dp), intent(out) :: value
      !> What is wrong, what was given, what is allowed; empty if the value is good.
      character(:), allocatable, intent(out) :: flaw
      !> Position in the text of what is wrong, from 1.
      integer, intent(out) :: index
      character(:), allocatable :: word, question
      integer(i8) :: n
      logical :: is_on

      value = variable%default
      question = ''
      if (variable%takes_several) then
         call convert_words(text, variable%choices, value, flaw, question, index)
      else
         call take_only_word(text, word, flaw, index)
      end if
      if (len(flaw) == 0 .and. .not. variable%takes_several) then
         select case (variable%kind)
         case (kind_real)
            call convert(word, value, flaw)
         case (kind_integer)
            call convert(word, n, flaw)
            value = real(n, dp)
         case (kind_logical)
            call convert(word, is_on, flaw)
            value = merge(1.0_dp, 0.0_dp, is_on)
         case default
            call convert_choice(word, variable%choices, value, flaw, question)
         end select
      end if
      if (len(flaw) > 0) then
         flaw = flaw//', allowed: '//describe_allowed(variable, value)//question
      else
         call check_value(value, variable, flaw)
      end if
      if (len(flaw) == 0) return
      value = variable%default
   end subroutine read_variable

   !> One of several words.
   pure subroutine convert_choice(word, choices, value, flaw, question)
      !> The value as it is written, with its quotes.
      character(*), intent(in) :: word
      !> Words that are allowed, separated by a blank.
      character(*), intent(in) :: choices
      !> Index of the word in `choices`, from 1; `unset` if something is wrong.
      real(dp), intent(out) :: value
      character(:), allocatable, intent(out) :: flaw
      !> A question that names the word which may be meant; empty if there is none.
      character(:), allocatable, intent(out) :: question
      character(:), allocatable :: choice
      integer :: k

      value = unset
      question = ''
      call convert(word, choice, flaw)
      if (len(flaw) > 0) return
      do k = 1, count_words(choices)
         if (get_word(choices, k) /= choice .or. len(choice) == 0) cycle
         value = real(k, dp)
         return
      end do
      flaw = 'unknown choice, given '''//show_text(choice)//''''
      question = did_you_mean(choice, choices)
   end subroutine convert_choice

   !> One word or several, each in quotes of its own, or several in the same quotes with a blank or a comma between them.
   pure subroutine convert_words(text, choices, value, flaw, question, index)
      !> Text of the value, as it stands in the input.
      character(*), intent(in) :: text
      !> Words that are allowed, separated by a blank.
      character(*), intent(in) :: choices
      !> The words as a number with a bit for each; `unset` if something is wrong.
      real(dp), intent(out) :: value
      character(:), allocatable, intent(out) :: flaw
      !> A question that names the word which may be meant; empty if there is none.
      character(:), allocatable, intent(out) :: question
      !> Position in the text of what is wrong, from 1.
      integer, intent(out) :: index
      character(:), allocatable :: list
      type(item_t) :: item
      real(dp) :: words
      integer :: position, k

      words = 0
      value = unset
      question = ''
      index = 1
      position = 1
      do
         call next_item(text, position, item, flaw)
         if (item%first == 0) exit
         index = item%first
         if (len(flaw) == 0 .and. item%repeat > 1) flaw = 'given twice, '//show_text(text)
         if (len(flaw) == 0) call read_list(text(item%first:item%last), list, flaw)
         if (len(flaw) > 0) return
         if (count_words(list) == 0) flaw = 'no word given'
         do k = 1, count_words(list)
            call add_word(get_word(list, k), choices, words, flaw, question)
            if (len(flaw) > 0) return
         end do
         if (len(flaw) > 0) return
      end do
      if (len(flaw) == 0 .and. words < 1) flaw = 'no value given'
      if (len(flaw) == 0) value = words
   end subroutine convert_words

   !> The words of a text as `convert_words` finds them, up to the first that is none, separated by a blank.
   pure function words_of_text(text) result(words)
      !> Text of the value, as it stands in the input.
      character(*), intent(in) :: text
      character(:), allocatable :: words
      character(:), allocatable :: list, flaw
      type(item_t) :: item
      integer :: position, k

      words = ''
      position = 1
      do
         call next_item(text, position, item, flaw)
         if (item%first == 0 .or. len(flaw) > 0) exit
         call read_list(text(item%first:item%last), list, flaw)
         if (len(flaw) > 0) exit
         do k = 1, count_words(list)
            words = words//' '//get_word(list, k)
         end do
      end do
      words = adjustl(words)
   end function words_of_text

   !> The words within one pair of quotes, separated by a blank.
   pure subroutine read_list(quoted, list, flaw)
      character(*), intent(in) :: quoted
      character(:), allocatable, intent(out) :: list, flaw
      integer :: k

      call convert(quoted, list, flaw)
      if (len(flaw) > 0) return
      do k = 1, len(list)
         if (list(k:k) == ',') list(k:k) = ' '
      end do
   end subroutine read_list

   !> Add a word to those that are given.
   pure subroutine add_word(word, choices, words, flaw, question)
      character(*), intent(in) :: word, choices
      !> The words so far, as a number with a bit for each.
      real(dp), intent(inout) :: words
      character(:), allocatable, intent(inout) :: flaw, question
      integer :: k

      do k = 1, count_words(choices)
         if (get_word(choices, k) /= word) cycle
         if (has_number(words, k)) flaw = 'given twice, '''//show_text(word)//''''
         words = with_number(words, k)
         return
      end do
      flaw = 'unknown choice, given '''//show_text(word)//''''
      question = did_you_mean(word, choices)
   end subroutine add_word

   !> Hold a number against what its variable allows.
   pure subroutine check_value(value, variable, flaw)
      !> The value as it is kept, a number in SI units.
      real(dp), intent(in) :: value
      !> Row of the model's table: kind, unit and what is allowed.
      type(variable_t), intent(in) :: variable
      !> What is wrong, what was given, what is allowed; empty if the value is good.
      character(:), allocatable, intent(out) :: flaw

      flaw = ''
      if (is_in_range(value, variable)) return
      flaw = 'out of range, given '//show_value(value, variable)//', allowed: '//describe_allowed(variable, value)
   end subroutine check_value

   !> Hold the values of a sweep against what its variable allows.
   pure subroutine find_outlier(values, variable, first, flaw)
      !> The values in the SI unit of the variable.
      real(dp), intent(in) :: values(:)
      !> Row of the model's table: kind, unit and what is allowed.
      type(variable_t), intent(in) :: variable
      !> Index of the first value that is not allowed; 0 if all are.
      integer, intent(out) :: first
      !> What is wrong, what was given, what is allowed; empty if all values are good.
      character(:), allocatable, intent(out) :: flaw
      integer :: i, n

      n = 0
      first = 0
      flaw = ''
      do i = size(values), 1, -1
         if (is_in_range(values(i), variable)) cycle
         n = n + 1
         first = i
      end do
      if (n == 0) return
      flaw = 'out of range at value '//show_count(first)//' of '//show_count(size(values))
      if (n > 1) flaw = flaw//' and at '//show_count(n - 1)//' more'
      flaw = flaw//', given '//show_value(values(first), variable)//', allowed: '//describe_allowed(variable, values(first))
   end subroutine find_outlier

   !> Is a value within the range of its variable?
   elemental logical function is_in_range(value, variable)
      !> The value as it is kept, a number in SI units.
      real(dp), intent(in) :: value
      !> Row of the model's table: kind, unit and what is allowed.
      type(variable_t), intent(in) :: variable

      is_in_range = is_usable(value)
      if (.not. is_in_range) return
      is_in_range = value >= variable%lower .and. value <= variable%upper
      if (variable%lower_open) is_in_range = is_in_range .and. value > variable%lower
      if (variable%upper_open) is_in_range = is_in_range .and. value < variable%upper
      if (.not. is_in_range .or. variable%kind /= kind_integer) return
      is_in_range = is_integer(value)
      if (is_in_range) is_in_range = modulo(nint(value), variable%multiple_of) == 0
   end function is_in_range

   !> Can a number be multiplied with a few others of its kind without leaving the range of numbers?
   elemental logical function is_usable(value)
      !> Any number in SI units; NaN is not usable.
      real(dp), intent(in) :: value

      is_usable = ieee_is_finite(value)
      if (is_usable) is_usable = abs(value) <= largest .and. .not. (abs(value) > 0 .and. abs(value) < smallest)
   end function is_usable

   !> Can a value be kept as an integer of default kind?
   elemental logical function is_integer(value)
      !> Any number; NaN is no integer.
      real(dp), intent(in) :: value

      is_integer = .false.
      if (abs(value) <= real(huge(1), dp)) is_integer = .not. abs(value - anint(value)) > 0
   end function is_integer

   !> What a variable may be, in words.
   pure function describe_allowed(variable, value) result(text)
      !> Row of the model's table: kind, unit and what is allowed.
      type(variable_t), intent(in) :: variable
      !> What was given instead; if no variable may be so large or small, the text says that as well.
      real(dp), intent(in), optional :: value
      character(:), allocatable :: text
      logical :: has_lower, has_upper

      select case (variable%kind)
      case (kind_real)
         text = 'a number'
      case (kind_integer)
         text = 'an integer'
         if (variable%multiple_of > 1) text = 'a multiple of '//show_count(variable%multiple_of)
      case (kind_logical)
         text = '.true. or .false.'
         return
      case (kind_text)
         text = trim(merge('texts in quotes ', 'a text in quotes', variable%is_list))
         return
      case (kind_dataset)
         if (.not. variable%is_list) then
            text = describe_dataset(variable)
            return
         end if
         text = describe_count(variable)
      case default
         text = list_choices(variable%choices)
         if (variable%takes_several) text = 'one or more of '//text
         return
      end select
      has_lower = abs(variable%lower) < unset
      has_upper = abs(variable%upper) < unset
      if (has_lower) text = text//trim(merge(' > ', ' >=', variable%lower_open))//' '//show_number(variable%lower)
      if (has_lower .and. has_upper) text = text//' and'
      if (has_upper) text = text//trim(merge(' < ', ' <=', variable%upper_open))//' '//show_number(variable%upper)
      if (has_unit(variable)) text = text//' ['//variable%unit//']'
      if (variable%is_list) text = text//', or ''FILE.h5:/DATASET'' or ''FILE.csv:COLUMN'' of them'//describe_attributes(variable)
      if (.not. present(value)) return
      if (.not. is_usable(value)) text = text//', of size '//show_number(smallest)//' to '//show_number(largest)
   end function describe_allowed

   !> How many numbers a list may have, in words.
   pure function describe_count(variable) result(text)
      type(variable_t), intent(in) :: variable
      character(:), allocatable :: text

      text = show_count(variable%least_count)//' to '//show_count(variable%most_count)//' numbers'
      if (variable%least_count == variable%most_count) text = show_count(variable%most_count)//' numbers'
   end function describe_count

   !> What a dataset or group may be, in words.
   pure function describe_dataset(variable) result(text)
      type(variable_t), intent(in) :: variable
      character(:), allocatable :: text
      integer :: k

      if (variable%n_columns() > 0) then
         text = '''FILE.h5:/GROUP'' with the datasets'
         do k = 1, variable%n_columns()
            if (k > 1) text = text//','
            text = text//' '//get_word(variable%columns, k)//' ['//get_word(variable%column_units, k)//']'
         end do
         text = text//' of numbers, 1 dimension, or ''FILE.csv'' with such columns, at least '// &
            show_count(variable%least_count)//' values'
      else if (variable%largest_rank > 1) then
         text = '''FILE.h5:/DATASET'' of numbers, '//show_count(1)//' or '//show_count(variable%largest_rank)// &
            ' dimensions, or ''FILE.csv:COLUMN'', at least '//show_count(variable%least_count)//' values along each'
      else
         text = '''FILE.h5:/DATASET'' of numbers, 1 dimension, or ''FILE.csv:COLUMN'', at least '// &
            show_count(variable%least_count)//' values'
      end if
      if (has_unit(variable)) text = text//' ['//variable%unit//']'
      text = text//describe_attributes(variable)
   end function describe_dataset

   !> Which attributes of a dataset are read, in words; nothing if none is.
   pure function describe_attributes(variable) result(text)
      !> Row of the model's table: names and units of the attributes.
      type(variable_t), intent(in) :: variable
      character(:), allocatable :: text
      integer :: k

      text = ''
      do k = 1, variable%n_attributes()
         if (k == 1) text = ', attributes'
         if (k > 1) text = text//','
         text = text//' '//get_word(variable%attributes, k)
         if (allocated(variable%attribute_units)) text = text//' ['//get_word(variable%attribute_units, k)//']'
      end do
      if (len(text) > 0) text = text//' if there'
   end function describe_attributes

   !> Words in quotes, with commas between them.
   pure function list_choices(choices) result(text)
      character(*), intent(in) :: choices
      character(:), allocatable :: text

      text = ''''//join_words(choices, ''', ''')//''''
   end function list_choices

   !> A value with its unit.
   pure function show_value(value, variable) result(text)
      !> The value as it is kept, a number in SI units, or NaN.
      real(dp), intent(in) :: value
      type(variable_t), intent(in) :: variable
      character(:), allocatable :: text

      if (ieee_is_nan(value)) then
         text = 'NaN'
         return
      end if
      text = trim(merge('Infinity ', '-Infinity', value > 0))
      if (ieee_is_finite(value)) text = show_number(value)
      if (has_unit(variable)) text = text//' '//variable%unit
   end function show_value

   !> Has the variable a unit?
   pure logical function has_unit(variable)
      type(variable_t), intent(in) :: variable

      has_unit = .false.
      if (allocated(variable%unit)) has_unit = len_trim(variable%unit) > 0 .and. variable%unit /= '-'
   end function has_unit

end module adfric_input_variable
