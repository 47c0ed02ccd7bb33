!> `adfric help`: what the tables of the models say, in words.
module adfric_command_help
   use adfric, only: new_model, known_models
   use adfric_base_error, only: error_t, set_error, input_failure
   use adfric_base_model, only: model_t, variable_t
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: count_words, get_word, pad
   use adfric_command_help_pages, only: usage_page, input_page, outputs_head
   use adfric_command_line, only: command_t
   use adfric_command_outcome, only: outcome_t
   use adfric_command_values, only: show_input_value
   use adfric_input_suggestion, only: did_you_mean
   use adfric_input_text, only: newline
   use adfric_input_variable, only: describe_allowed
   use adfric_input_vocabulary, only: has_word, list_groups, list_variables
   implicit none (type, external)
   private
   public :: give_help

   !> Topics that are not names of the models' tables.
   character(*), parameter :: fixed_topics = 'input outputs run merge check help'
   !> Width of the column of names.
   integer, parameter :: name_width = 34

contains

   !> Carry out the command.
   subroutine give_help(command, outcome)
      type(command_t), intent(in) :: command
      type(outcome_t), intent(inout) :: outcome
      type(error_t), allocatable :: error
      character(:), allocatable :: text

      call find_page(command%subject, text, error)
      if (allocated(error)) then
         call outcome%fail(error)
      else
         call outcome%say(text)
      end if
   end subroutine give_help

   !> The page of a topic; the first page if the topic is empty.
   subroutine find_page(topic, text, error)
      character(*), intent(in) :: topic
      !> Lines with their line ends.
      character(:), allocatable, intent(out) :: text
      type(error_t), allocatable, intent(out) :: error
      class(model_t), allocatable :: model
      character(:), allocatable :: topics
      integer :: i

      text = ''
      topics = fixed_topics//' job sweep '//known_models
      if (has_word('run merge check help', topic) .or. len_trim(topic) == 0) text = usage_page
      if (has_word('input job sweep', topic)) text = input_page
      if (topic == 'outputs') text = outputs_head
      if (len_trim(topic) == 0) text = text//'Models'//newline
      do i = 1, count_words(known_models)
         call new_model(model, get_word(known_models, i), error)
         if (allocated(error)) return
         if (len_trim(topic) == 0) then
            text = text//pad('  '//model%name, name_width)//model%summary//newline
         else
            text = text//describe_topic(model, topic)
         end if
         topics = topics//' '//list_groups(model)//' '//list_variables(model, '')
      end do
      if (len(text) == 0) call set_error(error, input_failure, 'adfric: help: unknown topic, given '''//topic &
         //''', allowed: '//fixed_topics//', a model ('//known_models//'), a group or a variable' &
         //did_you_mean(topic, topics))
   end subroutine find_page

   !> What a model has to say of a topic; empty if it is nothing.
   function describe_topic(model, topic) result(text)
      class(model_t), intent(in) :: model
      character(*), intent(in) :: topic
      character(:), allocatable :: text

      text = ''
      if (topic == 'outputs') then
         text = newline//'model = '''//model%name//''''//newline//describe_results(model)
      else if (topic == model%name) then
         text = 'model = '''//model%name//''': '//model%summary//newline//describe_variables(model, '', '') &
            //'Results'//newline//describe_results(model)
      else if (has_word(list_groups(model), topic)) then
         text = 'model = '''//model%name//''''//newline//describe_variables(model, topic, '')
      else if (has_word(list_variables(model, ''), topic)) then
         text = 'model = '''//model%name//''''//newline//describe_variables(model, '', topic)
      end if
   end function describe_topic

   !> The variables of a model; those of a group, or of a name, if it is not empty.
   function describe_variables(model, group, name) result(text)
      class(model_t), intent(in) :: model
      character(*), intent(in) :: group
      character(*), intent(in) :: name
      character(:), allocatable :: text
      character(:), allocatable :: last_group
      integer :: i

      text = ''
      last_group = ''
      do i = 1, size(model%variables)
         associate (variable => model%variables(i))
            if (len(group) > 0 .and. variable%group /= group) cycle
            if (len(name) > 0 .and. variable%name /= name) cycle
            if (variable%group /= last_group) text = text//'&'//variable%group//newline
            last_group = variable%group
            text = text//describe_variable(variable)
         end associate
      end do
   end function describe_variables

   !> A variable: meaning on the first line, what it may be on the second.
   function describe_variable(variable) result(text)
      type(variable_t), intent(in) :: variable
      character(:), allocatable :: text

      text = '  '//variable%name
      if (len_trim(variable%unit) > 0) text = text//' ['//variable%unit//']'
      text = pad(text, name_width)//variable%meaning//newline
      text = text//repeat(' ', name_width)//'  '//describe_allowed(variable)
      if (is_set(variable%default)) text = text//'; default '//show_input_value(variable, variable%default)
      text = text//newline
   end function describe_variable

   !> The results and the profiles of a model.
   function describe_results(model) result(text)
      class(model_t), intent(in) :: model
      character(:), allocatable :: text
      integer :: i

      text = ''
      do i = 1, size(model%results)
         associate (result => model%results(i))
            text = text//pad('  '//result%name//' ['//result%unit//']', name_width)//result%long_name//newline
            if (result%n_states() == 0) cycle
            text = text//repeat(' ', name_width)//'  '//list_states(result%flag_meanings)//newline
         end associate
      end do
      if (size(model%profiles) > 0) text = text//'Profiles'//newline
      do i = 1, size(model%profiles)
         associate (profile => model%profiles(i))
            text = text//pad('  '//profile%name//' ['//profile%unit//']', name_width)//profile%long_name//newline
         end associate
      end do
   end function describe_results

   !> States with their numbers.
   function list_states(meanings) result(text)
      character(*), intent(in) :: meanings
      character(:), allocatable :: text
      character(4) :: number
      integer :: i

      text = ''
      do i = 1, count_words(meanings)
         write (number, '(i0)') i - 1
         if (i > 1) text = text//', '
         text = text//trim(number)//' '//get_word(meanings, i)
      end do
   end function list_states

end module adfric_command_help
