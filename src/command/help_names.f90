! SPDX-License-Identifier: GPL-3.0-or-later
!> What a model has to say of the names in its tables: groups, variables, results, profiles, and the words that they may be.
module adfric_command_help_names
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: count_words, get_word, pad, has_word
   use adfric_base_text, only: newline
   use adfric_command_values, only: show_input_value
   use adfric_input_variable, only: describe_allowed
   use adfric_describe_doubt, only: doubt_meanings, doubt_name, explain_doubt
   use adfric_describe_model, only: model_t
   use adfric_describe_plausible_range, only: describe_usual
   use adfric_describe_status, only: explain_status, status_meanings
   use adfric_describe_table, only: variable_t, result_t, common_results, kind_choice
   use adfric_describe_vocabulary, only: list_groups, list_variables
   implicit none (type, external)
   private
   public :: describe_model, describe_outputs, describe_name, describe_common, describe_variables, list_names, list_words

   !> Width of the column of names, and of a line.
   integer, parameter :: name_width = 40, line_width = 110
   !> Heading of what a model counts.
   character(*), parameter :: head_of_counts = 'Attributes of the file, means over all points'

contains

   !> All that there is to say of a model, without its name.
   function describe_model(model) result(text)
      class(model_t), intent(in) :: model
      character(:), allocatable :: text

      text = model%summary//newline//newline//describe_variables(model%variables, '')//newline//describe_outputs(model)
   end function describe_model

   !> Results, profiles and counts of a model.
   function describe_outputs(model) result(text)
      class(model_t), intent(in) :: model
      character(:), allocatable :: text

      text = with_head('Results', describe_results(model%results, ''))//with_head('Profiles', describe_profiles(model, '')) &
         //with_head(head_of_counts, describe_counts(model, ''))
   end function describe_outputs

   !> What a model says of a name, or of `group%name`; empty if the name does not occur in its tables.
   function describe_name(model, name) result(text)
      class(model_t), intent(in) :: model
      !> A name, or `group%name`, in small letters.
      character(*), intent(in) :: name
      character(:), allocatable :: text

      text = describe_variables(model%variables, name)
      text = text//with_head('Results', describe_results(model%results, name))
      text = text//with_head('Profiles', describe_profiles(model, name))
      text = text//with_head(head_of_counts, describe_counts(model, name))
   end function describe_name

   !> What stands in the file of every model: the results of that name; all of them if it is empty.
   function describe_common(name) result(text)
      !> Name of a result, or a word that the status may be; empty for all results.
      character(*), intent(in) :: name
      character(:), allocatable :: text
      type(result_t), allocatable :: common(:)
      integer :: i

      common = common_results()
      text = with_head('On every run', describe_results(common, name))
      do i = 1, count_words(doubt_meanings)
         if (is_meant(doubt_name, doubt_meanings, i)) text = text//explained(doubt_meanings, i, explain_doubt(i - 1))
      end do
      do i = 1, count_words(status_meanings)
         if (is_meant('status', status_meanings, i)) text = text//explained(status_meanings, i, explain_status(i - 1))
      end do

   contains

      !> Is one of the states of a result meant by the name?
      pure logical function is_meant(result, meanings, index)
         character(*), intent(in) :: result
         !> Names of its states, separated by a blank.
         character(*), intent(in) :: meanings
         !> Index of the state, from 1.
         integer, intent(in) :: index

         is_meant = len(name) == 0 .or. name == result .or. name == get_word(meanings, index)
      end function is_meant

      !> The line of a state.
      pure function explained(meanings, index, explanation) result(line)
         !> Names of the states, separated by a blank.
         character(*), intent(in) :: meanings
         integer, intent(in) :: index
         !> What it means.
         character(*), intent(in) :: explanation
         character(:), allocatable :: line

         line = pad('    '//get_word(meanings, index), name_width)//explanation//newline
      end function explained

   end function describe_common

   !> A heading and what stands under it; nothing if that is nothing.
   pure function with_head(head, lines) result(text)
      !> The line of the heading, without line end.
      character(*), intent(in) :: head
      !> What stands under the heading, with line ends; empty if there is nothing.
      character(*), intent(in) :: lines
      character(:), allocatable :: text

      text = ''
      if (len(lines) > 0) text = head//newline//lines
   end function with_head

   !> The variables that a name means: of a group, of this name, or with this word among their choices; all if it is empty.
   function describe_variables(variables, name) result(text)
      type(variable_t), intent(in) :: variables(:)
      !> Name of a group, a variable or a choice, or `group%name`; empty for all variables.
      character(*), intent(in) :: name
      character(:), allocatable :: text, last_group
      integer :: i

      text = ''
      last_group = ''
      do i = 1, size(variables)
         associate (variable => variables(i))
            if (variable%is_hidden .or. .not. is_meant(variable, name)) cycle
            if (variable%group /= last_group) text = text//'&'//variable%group//newline
            last_group = variable%group
            text = text//describe_variable(variable)
         end associate
      end do
   end function describe_variables

   !> Does a name mean this variable?
   pure logical function is_meant(variable, name)
      !> Row of the model's table: names, unit, meaning and what is allowed.
      type(variable_t), intent(in) :: variable
      character(*), intent(in) :: name

      is_meant = len(name) == 0 .or. name == variable%group .or. name == variable%name &
         .or. name == variable%group//'%'//variable%name
      if (.not. is_meant .and. variable%kind == kind_choice) is_meant = has_word(variable%choices, name)
   end function is_meant

   !> A variable: meaning on the first line, what it may be on the second.
   function describe_variable(variable) result(text)
      type(variable_t), intent(in) :: variable
      character(:), allocatable :: text, usual

      text = '  '//variable%name
      if (len_trim(variable%unit) > 0) text = text//' ['//variable%unit//']'
      text = pad(text, name_width)//variable%meaning//newline
      text = text//repeat(' ', name_width)//'  '//describe_allowed(variable)
      if (is_set(variable%default)) text = text//'; default '//show_input_value(variable, variable%default)
      usual = describe_usual(variable, variable%unit)
      if (len(usual) > 0) text = text//'; '//usual
      text = text//newline
   end function describe_variable

   !> The results of a name, or that may be in a state of that name; all if it is empty.
   pure function describe_results(results, name) result(text)
      type(result_t), intent(in) :: results(:)
      !> Name of a result or of one of its states; empty for all results.
      character(*), intent(in) :: name
      character(:), allocatable :: text
      logical :: has_state
      integer :: i

      text = ''
      do i = 1, size(results)
         associate (result => results(i))
            if (result%is_hidden) cycle
            has_state = result%n_states() > 0
            if (.not. (len(name) == 0 .or. name == result%name)) then
               if (.not. has_state) cycle
               if (.not. has_word(result%flag_meanings, name)) cycle
            end if
            text = text//pad('  '//result%name//' ['//result%unit//']', name_width)//result%long_name//newline
            if (has_state) text = text//list_states(result%flag_meanings)
         end associate
      end do
   end function describe_results

   !> The profiles of a name; all if it is empty.
   pure function describe_profiles(model, name) result(text)
      class(model_t), intent(in) :: model
      !> Name of a profile; empty for all profiles.
      character(*), intent(in) :: name
      character(:), allocatable :: text
      integer :: i

      text = ''
      do i = 1, size(model%profiles)
         associate (profile => model%profiles(i))
            if (.not. (len(name) == 0 .or. name == profile%name)) cycle
            text = text//pad('  '//profile%name//' ['//profile%unit//']', name_width)//profile%long_name//newline
         end associate
      end do
   end function describe_profiles

   !> The counts of a name; all if it is empty.
   pure function describe_counts(model, name) result(text)
      class(model_t), intent(in) :: model
      !> Name of a count; empty for all counts.
      character(*), intent(in) :: name
      character(:), allocatable :: text
      integer :: i

      text = ''
      do i = 1, size(model%counts)
         associate (count => model%counts(i))
            if (len(name) == 0 .or. name == count%name) text = text//pad('  '//count%name//' [-]', name_width) &
               //count%long_name//newline
         end associate
      end do
   end function describe_counts

   !> States with their numbers, on lines that begin behind the column of names.
   pure function list_states(meanings) result(text)
      !> Meanings of the states 0, 1, 2, ..., separated by a blank.
      character(*), intent(in) :: meanings
      character(:), allocatable :: text, line, state
      character(4) :: number
      integer :: i

      text = ''
      line = repeat(' ', name_width + 1)
      do i = 1, count_words(meanings)
         write (number, '(i0)') i - 1
         state = ' '//trim(number)//' '//get_word(meanings, i)
         if (i < count_words(meanings)) state = state//','
         if (len(line//state) > line_width) then
            text = text//line//newline
            line = repeat(' ', name_width + 1)
         end if
         line = line//state
      end do
      text = text//line//newline
   end function list_states

   !> Every name that a model has something to say of, and those of every run, separated by a blank.
   function list_names(model) result(names)
      class(model_t), intent(in) :: model
      character(:), allocatable :: names
      type(result_t), allocatable :: common(:)
      integer :: i

      names = list_groups(model)//' '//list_variables(model, '')//list_words(model%variables)
      common = common_results()
      names = names//list_results(model%results)//list_results(common)
      do i = 1, size(model%profiles)
         names = names//' '//model%profiles(i)%name
      end do
      do i = 1, size(model%counts)
         names = names//' '//model%counts(i)%name
      end do
   end function list_names

   !> Words that the variables may be, each after a blank.
   pure function list_words(variables) result(words)
      type(variable_t), intent(in) :: variables(:)
      character(:), allocatable :: words
      integer :: i

      words = ''
      do i = 1, size(variables)
         if (variables(i)%kind == kind_choice) words = words//' '//variables(i)%choices
      end do
   end function list_words

   !> Names of results and of the states that they may be in, each after a blank.
   pure function list_results(results) result(names)
      type(result_t), intent(in) :: results(:)
      character(:), allocatable :: names
      integer :: i

      names = ''
      do i = 1, size(results)
         names = names//' '//results(i)%name
         if (results(i)%n_states() > 0) names = names//' '//results(i)%flag_meanings
      end do
   end function list_results

end module adfric_command_help_names
