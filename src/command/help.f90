! SPDX-License-Identifier: GPL-3.0-or-later
!> `adfric help`: what the tables of the models say, in words.
module adfric_command_help
   use adfric, only: new_model, known_models
   use adfric_base_error, only: error_t, set_error, input_failure
   use adfric_base_words, only: count_words, get_word, has_word
   use adfric_base_text, only: join_words, newline, to_lower
   use adfric_command_help_entries, only: entries_t
   use adfric_command_help_lists, only: model_box_t, list_topics, show_list
   use adfric_command_help_names, only: describe_model, describe_outputs, describe_name, describe_common, &
      describe_variables, list_names, list_words
   use adfric_command_help_scenes, only: describe_scene_list, describe_scene_name, describe_scenes, &
      list_scene_names
   use adfric_command_help_pages, only: usage_page, input_page, tables_page, outputs_head
   use adfric_command_help_phenomena, only: describe_phenomena, list_phenomena, show_phenomena
   use adfric_command_help_theories, only: describe_theories
   use adfric_command_line, only: command_t, known_commands
   use adfric_command_outcome, only: outcome_t
   use adfric_input_fit_rows, only: fit_groups, get_fit_rows, list_fit_names
   use adfric_input_suggestion, only: did_you_mean
   use adfric_input_vocabulary, only: common_groups, list_common_names
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: give_help

   !> Topics that are pages.
   character(*), parameter :: page_topics = 'scenes phenomena theories input tables outputs names'
   !> Head of what only inputs in the names of version 0.2 have.
   character(*), parameter :: of_old_inputs = 'In an input that names a model (&job model)'

contains

   !> Carry out the command.
   subroutine give_help(command, outcome)
      !> What the user asks for on the command line.
      type(command_t), intent(in) :: command
      !> Receives what the command has to say, and the exit status.
      type(outcome_t), intent(inout) :: outcome
      type(model_box_t), allocatable :: models(:)
      type(error_t), allocatable :: error
      character(:), allocatable :: text

      call make_models(models, error)
      if (.not. allocated(error)) call find_page(models, plain_topic(command%subject), text, error)
      if (allocated(error)) then
         call outcome%fail(error)
      else
         call outcome%say(text)
      end if
   end subroutine give_help

   !> Every model.
   subroutine make_models(models, error)
      !> Receives every model that the program knows.
      type(model_box_t), allocatable, intent(out) :: models(:)
      type(error_t), allocatable, intent(out) :: error
      integer :: i

      allocate (models(count_words(known_models)))
      do i = 1, size(models)
         call new_model(models(i)%model, get_word(known_models, i), error)
         if (allocated(error)) return
      end do
   end subroutine make_models

   !> A topic in small letters, and without the & of a group.
   pure function plain_topic(topic) result(plain)
      !> The topic as the user wrote it; empty if there is none.
      character(*), intent(in) :: topic
      character(:), allocatable :: plain

      plain = to_lower(trim(topic))
      if (index(plain, '&') == 1) plain = plain(2:)
   end function plain_topic

   !> The page of a topic; the first page if the topic is empty.
   subroutine find_page(models, topic, text, error)
      type(model_box_t), intent(in) :: models(:)
      !> The topic in small letters, without the & of a group; empty if there is none.
      character(*), intent(in) :: topic
      !> The lines of the page, each with its line end; empty if the topic is unknown.
      character(:), allocatable, intent(out) :: text
      type(error_t), allocatable, intent(out) :: error
      character(:), allocatable :: named

      if (len(topic) == 0) then
         text = usage_page//show_list(models, 'models')
      else if (has_word(list_topics, topic)) then
         text = list_of(models, topic)
         ! a variable may have the name of a list
         named = explain(models, topic)
         if (len(named) > 0) text = text//newline//named
      else if (topic == 'outputs') then
         text = outputs_head//newline//describe_common('')//newline//describe_every_model(models, topic)
      else if (topic == 'scenes') then
         text = describe_scenes(models)
      else if (topic == 'phenomena') then
         text = show_phenomena()
      else if (topic == 'theories') then
         ! a variable has the name of this page
         text = describe_theories()//newline//explain(models, topic)
      else if (topic == 'input') then
         text = input_page
      else if (topic == 'tables') then
         text = tables_page
      else if (topic == 'names') then
         text = join_words(every_name(models), newline)//newline
      else
         text = explain(models, topic)
      end if
      if (len(text) == 0) call set_error(error, input_failure, 'adfric: help: unknown topic, given '''//topic &
         //''', allowed: '//list_topics//' '//page_topics//', or a name that stands there'//did_you_mean(topic, every_name(models)))
   end subroutine find_page

   !> A list of scenes, and below it that of inputs that name a model.
   function list_of(models, topic) result(text)
      type(model_box_t), intent(in) :: models(:)
      !> One of `list_topics`.
      character(*), intent(in) :: topic
      character(:), allocatable :: text

      text = describe_scene_list(models, topic)
      if (len(text) > 0) text = text//newline//of_old_inputs//newline
      text = text//show_list(models, topic)
   end function list_of

   !> What there is to say of a name; empty if nothing knows it.
   function explain(models, topic) result(text)
      type(model_box_t), intent(in) :: models(:)
      !> A name in small letters, without the & of a group.
      character(*), intent(in) :: topic
      character(:), allocatable :: text, of_models, of_fits, of_scenes, of_phenomena

      text = ''
      if (has_word(known_commands, topic)) text = usage_page
      if (has_word(every_common_name(), topic)) text = input_page
      text = text//describe_common(topic)
      of_fits = describe_fits(topic)
      if (len(text) > 0 .and. len(of_fits) > 0) text = text//newline
      text = text//of_fits
      of_scenes = describe_scene_name(models, topic)
      if (len(text) > 0 .and. len(of_scenes) > 0) text = text//newline
      text = text//of_scenes
      of_models = describe_every_model(models, topic)
      if (len(text) > 0 .and. len(of_models) > 0) text = text//newline
      if (len(of_scenes) > 0 .and. len(of_models) > 0) text = text//of_old_inputs//newline
      text = text//of_models
      of_phenomena = describe_phenomena(topic)
      if (len(text) > 0 .and. len(of_phenomena) > 0) of_phenomena = of_phenomena//newline
      text = of_phenomena//text
   end function explain

   !> What the groups of fits say of a topic; empty if they do not have the name.
   function describe_fits(topic) result(text)
      !> The command `fit`, or a name in the groups.
      character(*), intent(in) :: topic
      character(:), allocatable :: text
      type(variable_t), allocatable :: rows(:)

      allocate (rows, source=get_fit_rows())
      if (topic == 'fit') then
         text = describe_variables(rows, '')
      else
         text = describe_variables(rows, topic)
      end if
      if (len(text) > 0) text = 'Inputs of adfric fit; the groups data, event and free may be repeated'//newline//text
   end function describe_fits

   !> What the models say of a topic, each thing once.
   function describe_every_model(models, topic) result(text)
      type(model_box_t), intent(in) :: models(:)
      !> 'outputs', the name of a model, or a name in the tables of the models.
      character(*), intent(in) :: topic
      character(:), allocatable :: text
      type(entries_t) :: entries
      integer :: i

      do i = 1, size(models)
         associate (model => models(i)%model)
            if (topic == 'outputs') then
               call entries%add(describe_outputs(model), model%name)
            else if (topic == model%name) then
               call entries%add(describe_model(model), model%name)
            else
               call entries%add(describe_name(model, topic), model%name)
            end if
         end associate
      end do
      text = entries%show_pages()
   end function describe_every_model

   !> Groups that every model has, and their variables, separated by a blank.
   pure function every_common_name() result(names)
      character(:), allocatable :: names
      integer :: k

      names = common_groups
      do k = 1, count_words(common_groups)
         names = names//' '//list_common_names(get_word(common_groups, k))
      end do
   end function every_common_name

   !> Every name that there is help on, separated by a blank.
   function every_name(models) result(names)
      type(model_box_t), intent(in) :: models(:)
      character(:), allocatable :: names
      type(variable_t), allocatable :: rows(:)
      integer :: i

      allocate (rows, source=get_fit_rows())
      names = list_topics//' '//page_topics//' '//known_commands//' '//every_common_name()//' '//known_models//' '//fit_groups &
         //list_words(rows)
      do i = 1, count_words(fit_groups)
         names = names//list_fit_names(rows, get_word(fit_groups, i))
      end do
      do i = 1, size(models)
         names = names//' '//list_names(models(i)%model)
      end do
      names = names//' '//list_scene_names(models)//list_phenomena()
   end function every_name

end module adfric_command_help
