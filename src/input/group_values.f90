! SPDX-License-Identifier: GPL-3.0-or-later
!> The values in groups that belong to every run, not to a model: numbers, counts, words and names of variables. What is wrong is
!> reported, and the value stays as it was.
module adfric_input_group_values
   use adfric_base_kinds, only: dp, i8
   use adfric_base_text, only: join_words, show_count, show_text, to_lower
   use adfric_base_words, only: has_word
   use adfric_input_item, only: item_t, next_item, take_only_word
   use adfric_input_literal, only: convert
   use adfric_input_reading, only: reading_t
   use adfric_input_suggestion, only: did_you_mean
   use adfric_input_vocabulary, only: find_variable, is_number, list_numbers
   use adfric_describe_model, only: model_t
   implicit none (type, external)
   private
   public :: take_number, take_count, take_choice, take_text, take_words, take_variable, look_up_number

contains

   !> A real number.
   subroutine take_number(r, group, name, value)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      character(*), intent(in) :: name
      !> Receives the number; left as it is if it is not given, or something is wrong.
      real(dp), intent(inout) :: value
      character(:), allocatable :: word, flaw
      real(dp) :: given
      integer :: number, entry

      number = r%file%find_assignment(group, name)
      if (number == 0) return
      call take_only_word(r%file%value_of(number), word, flaw, entry)
      if (len(flaw) == 0) call convert(word, given, flaw)
      if (len(flaw) == 0) value = given
      if (len(flaw) > 0) call r%report(group, name, flaw//', allowed: a number', entry)
   end subroutine take_number

   !> An integer within bounds.
   subroutine take_count(r, group, name, least, most, value)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      character(*), intent(in) :: name
      integer, intent(in) :: least, most
      !> Receives the integer; left as it is if it is not given, or something is wrong.
      integer(i8), intent(inout) :: value
      character(:), allocatable :: word, flaw
      integer(i8) :: given
      integer :: number, entry

      number = r%file%find_assignment(group, name)
      if (number == 0) return
      call take_only_word(r%file%value_of(number), word, flaw, entry)
      if (len(flaw) == 0) call convert(word, given, flaw)
      if (len(flaw) == 0) then
         if (given < least) flaw = 'out of range, given '//show_count(given)
         if (given > most) flaw = 'too many values, given '//show_count(given)
         if (len(flaw) == 0) value = given
      end if
      if (len(flaw) > 0) call r%report(group, name, flaw//', allowed: an integer >= '//show_count(least)//' and <= ' &
         //show_count(most), entry)
   end subroutine take_count

   !> One of several words.
   subroutine take_choice(r, group, name, choices, word, what)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      character(*), intent(in) :: name
      !> Words that are allowed, separated by a blank.
      character(*), intent(in) :: choices
      !> Receives the word; left as it is if it is not given, or something is wrong.
      character(:), allocatable, intent(inout) :: word
      !> What a word is called in a message; not present: choice.
      character(*), intent(in), optional :: what
      character(:), allocatable :: quoted, given, flaw, called
      integer :: number, entry

      number = r%file%find_assignment(group, name)
      if (number == 0) return
      given = ''
      called = 'choice'
      if (present(what)) called = what
      call take_only_word(r%file%value_of(number), quoted, flaw, entry)
      if (len(flaw) == 0) call convert(quoted, given, flaw)
      if (len(flaw) == 0 .and. .not. has_word(choices, given)) flaw = 'unknown '//called//', given '''//show_text(given)//''''
      if (len(flaw) == 0) word = given
      if (len(flaw) > 0) call r%report(group, name, flaw//', allowed: '''//join_words(choices, ''', ''')//'''' &
         //did_you_mean(given, choices), entry)
   end subroutine take_choice

   !> A text in quotes.
   subroutine take_text(r, group, name, allowed, word)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      character(*), intent(in) :: name, allowed
      !> Receives the text without its quotes; left as it is if it is not given, or something is wrong.
      character(:), allocatable, intent(inout) :: word
      character(:), allocatable :: quoted, given, flaw
      integer :: number, entry

      number = r%file%find_assignment(group, name)
      if (number == 0) return
      call take_only_word(r%file%value_of(number), quoted, flaw, entry)
      if (len(flaw) == 0) call convert(quoted, given, flaw)
      if (len(flaw) == 0) word = given
      if (len(flaw) > 0) call r%report(group, name, flaw//', allowed: '//allowed, entry)
   end subroutine take_text

   !> Several words in quotes, in small letters.
   subroutine take_words(r, group, name, allowed, words)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      character(*), intent(in) :: name, allowed
      !> Receives the words, separated by a blank; left as it is if they are not given, or something is wrong.
      character(:), allocatable, intent(inout) :: words
      character(:), allocatable :: text, list, word, flaw
      type(item_t) :: item
      integer :: number, position, entry

      number = r%file%find_assignment(group, name)
      if (number == 0) return
      text = r%file%value_of(number)
      list = ''
      position = 1
      entry = 1
      do
         call next_item(text, position, item, flaw)
         if (item%first == 0) exit
         entry = item%first
         if (len(flaw) == 0) call convert(text(item%first:item%last), word, flaw)
         if (len(flaw) == 0) then
            if (item%repeat > 1 .or. has_word(list, to_lower(word))) flaw = 'given twice, '''//show_text(word)//''''
            if (len_trim(word) == 0 .or. index(word, ' ') > 0) flaw = 'not the name of a variable, given '''//show_text(word)//''''
         end if
         if (len(flaw) > 0) exit
         list = trim(adjustl(list//' '//to_lower(word)))
      end do
      if (len(flaw) == 0 .and. len(list) == 0) flaw = 'no value given'
      if (len(flaw) == 0) words = list
      if (len(flaw) > 0) call r%report(group, name, flaw//', allowed: '//allowed, entry)
   end subroutine take_words

   !> The numeric variable of the model that `variable` names.
   subroutine take_variable(r, group, name, variable)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      !> Receives the name in small letters; empty if there is none.
      character(:), allocatable, intent(out) :: name
      !> Index of the variable in the model's table, from 1; 0 if there is none.
      integer, intent(out) :: variable
      character(:), allocatable :: quoted, flaw
      integer :: number, entry

      variable = 0
      name = ''
      number = r%file%find_assignment(group, 'variable')
      if (number == 0) then
         if (.not. r%file%groups(group)%is_garbled) call r%report(group, 'variable', &
            'not given, needed: the name of a variable of the model')
         return
      end if
      call take_only_word(r%file%value_of(number), quoted, flaw, entry)
      if (len(flaw) == 0) call convert(quoted, name, flaw)
      if (len(flaw) > 0) then
         name = ''
         flaw = flaw//', allowed: the name of a variable of the model'
      else
         name = to_lower(name)
         call look_up_number(r%model, name, variable, flaw)
      end if
      if (len(flaw) > 0) call r%report(group, 'variable', flaw, entry)
   end subroutine take_variable

   !> Look up a numeric variable, `name` or `group%name`.
   subroutine look_up_number(model, name, variable, flaw)
      class(model_t), intent(in) :: model
      !> `name` or `group%name`, in small letters.
      character(*), intent(in) :: name
      !> Index of the variable in the model's table, from 1; 0 if it is none, or no number.
      integer, intent(out) :: variable
      character(:), allocatable, intent(out) :: flaw

      call find_variable(model, name, list_numbers(model), variable, flaw)
      if (variable == 0) return
      if (is_number(model%variables(variable))) return
      flaw = 'not a number, it cannot be swept, given '''//show_text(name)//''', allowed: '//join_words(list_numbers(model), ', ')
      variable = 0
   end subroutine look_up_number

end module adfric_input_group_values
