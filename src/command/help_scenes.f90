! SPDX-License-Identifier: GPL-3.0-or-later
!> The page of scenes: which can be solved, and the variables of their groups. The file is long by its table of columns.
module adfric_command_help_scenes
   use adfric_base_text, only: newline
   use adfric_base_words, only: count_words, get_word, has_word, pad
   use adfric_command_help_lists, only: model_box_t, units_of_result
   use adfric_describe_plausible_range, only: describe_usual
   use adfric_describe_table, only: kind_choice, variable_t
   use adfric_describe_vocabulary, only: order_of_scenes
   use adfric_describe_scene_messages, only: with_phrases
   use adfric_describe_scene_names, only: likely_name_of, likely_result_of, likely_unit_of, long_name_of, meaning_of, &
      & may_become, rename_words, renamed_to
   use adfric_describe_scene_shapes, only: list_shapes
   use adfric_describe_scene_solvers, only: accuracy_of_scene, known_curves, known_extents, known_surfaces, known_tractions, &
      word_length
   implicit none (type, external)
   private
   public :: describe_scenes, describe_scene_list, describe_scene_name, list_scene_names

   !> Columns of the table: solid, interface, operation, and what they are.
   integer, parameter :: n_columns = 22
   character(*), parameter :: columns(3, n_columns) = reshape([character(word_length) :: &
      & 'half_space', 'none', 'press', 'half_space', 'adhesion', 'press', 'half_space', 'shear', 'slide', 'half_space', &
      & 'adhesion+shear', 'slide', 'half_space', 'coulomb', 'tangential', 'half_space', 'coulomb', 'roll', &
      & 'half_space', 'coulomb', 'path', 'half_space', 'adhesion', 'path', 'free_half_space', 'none', 'press', &
      & 'free_half_space', 'adhesion', 'press', 'layer', 'none', 'press', 'layer', 'adhesion', 'press', &
      & 'coating', 'none', 'press', 'coating', 'adhesion', 'press', 'relaxing', 'none', 'path', &
      & 'relaxing', 'adhesion', 'path', 'relaxing', 'none', 'slide', 'relaxing', 'adhesion', 'slide', 'layer', 'none', 'slide', &
      & 'layer', 'adhesion', 'slide', 'foundation', 'none', 'slide', 'foundation', 'adhesion', 'slide'], [3, n_columns])
   character(*), parameter :: heads(n_columns) = [character(72) :: &
      & 'elastic half-space, pressed', 'elastic half-space, pressed, with adhesion', &
      & 'elastic half-space, sliding with a shear strength', 'elastic half-space, sliding with adhesion and a shear strength', &
      & 'elastic half-space, tangential force below mu P (Coulomb)', &
      & 'elastic half-space, rolling under a tangential force (Coulomb)', &
      & 'elastic half-space, path of loads and tangential forces', &
      & 'elastic half-space, path of loads, approaches or a spring with adhesion', &
      & 'elastic half-space with free boundaries, pressed', 'elastic half-space with free boundaries, pressed, with adhesion', &
      & 'elastic layer, pressed', 'elastic layer, pressed, with adhesion', 'elastic coating, pressed', &
      & 'elastic coating, pressed, with adhesion', 'viscoelastic half-space, history in time', &
      & 'viscoelastic half-space, history in time with adhesion', 'viscoelastic half-space, sliding', &
      & 'viscoelastic half-space, sliding with adhesion', 'viscoelastic layer, sliding', &
      & 'viscoelastic layer, sliding with adhesion', 'viscoelastic foundation (columns), sliding', &
      & 'viscoelastic foundation (columns), sliding with adhesion']
   !> Variables that choose the solver: group, name, meaning, and words.
   character(*), parameter :: choosing(4, 4) = reshape([character(len(known_surfaces)) :: &
      & 'surface', 'kind', 'shape of the rigid surface', known_surfaces, &
      & 'traction', 'kind', 'where the tractions act', known_tractions, &
      & 'solid', 'extent', 'half-space, layer on a rigid base, coating, or columns side by side (foundation)', known_extents, &
      & 'solid', 'curve_modulus', 'which modulus the master curve is one of: E, or E/(1 - nu^2)', known_curves], [4, 4])
   !> Width of the column of names.
   integer, parameter :: name_width = 40, surface_width = 18

contains

   !> The whole page.
   function describe_scenes(models) result(text)
      type(model_box_t), intent(in) :: models(:)
      character(:), allocatable :: text

      text = 'A scene is a surface on a solid, with an interface, in some operation.'//newline &
         //'An input that names no model describes one:'//newline//newline// &
         '  &surface kind = ''paraboloid'', radius = 140e-9 /'//newline//'  &solid contact_modulus = 44e9 /'//newline// &
         '  &adhesion work_of_adhesion = 0.19, lambda = 0.8 /'//newline// &
         '  &friction shear_strength = 0.96e9 /'//newline// &
         '  &operating load = 1e-7, state = ''sliding'' /'//newline//newline// &
         'The program finds the solver; adfric check says which. &job solver = ''NAME'' asks for one of several.'//newline// &
         'e: exact (closed forms, roots, integrals), n: numerical (cells), t: a statistical theory, -: no solver yet.'//newline &
         //newline//describe_table()//newline &
         //'Given loads: &traction kind = ''line'', ''strip'', ''point'' or ''rectangle'' in place of &surface.'//newline//newline &
         //'Variables'//newline//describe_groups(models)//newline &
         //'Results, where they have a meaning'//newline//describe_results(models, '')
   end function describe_scenes

   !> What scenes have of a list; empty where its page needs nothing of them.
   function describe_scene_list(models, topic) result(text)
      type(model_box_t), intent(in) :: models(:)
      !> One of `list_topics`.
      character(*), intent(in) :: topic
      character(:), allocatable :: text
      integer :: g

      text = ''
      select case (topic)
      case ('groups')
         text = 'Groups of scenes'//newline
         do g = 1, count_words(order_of_scenes)
            text = text//'  &'//get_word(order_of_scenes, g)//newline
         end do
      case ('variables')
         text = 'Variables of scenes'//newline//describe_groups(models)
      case ('results')
         text = 'Results of scenes, where they have a meaning'//newline//describe_results(models, '')
      end select
   end function describe_scene_list

   !> The table of surfaces.
   function describe_table() result(text)
      character(:), allocatable :: text, line, surface
      character(4) :: number
      integer :: c, k

      text = ''
      do c = 1, n_columns
         write (number, '(i3, 1x)') c
         text = text//number//trim(heads(c))//newline
      end do
      line = pad('surface', surface_width)
      do c = 1, n_columns
         write (number, '(i3)') c
         line = line//number
      end do
      text = text//newline//trim(line)//newline
      do k = 1, count_words(known_surfaces)
         surface = get_word(known_surfaces, k)
         line = pad(surface, surface_width)
         do c = 1, n_columns
            line = line//'  '//initial_of(surface, c)//' '
         end do
         text = text//trim(line)//newline
      end do
   end function describe_table

   !> Letter of a cell of the table.
   pure character function initial_of(surface, column) result(letter)
      !> Surface of the row.
      character(*), intent(in) :: surface
      !> Number of the column.
      integer, intent(in) :: column
      character(word_length) :: words(4)
      character(:), allocatable :: accuracy

      words(1) = surface
      words(2:) = columns(:, column)
      accuracy = accuracy_of_scene(words)
      letter = '-'
      if (len(accuracy) > 0) letter = accuracy(1:1)
   end function initial_of

   !> The variables of all groups, each once.
   function describe_groups(models) result(text)
      type(model_box_t), intent(in) :: models(:)
      character(:), allocatable :: text, group, names
      integer :: g

      text = ''
      do g = 1, count_words(order_of_scenes)
         group = get_word(order_of_scenes, g)
         text = text//'&'//group//newline
         names = ''
         text = text//choosing_lines(group, '')
         if (has_word('surface traction', group)) names = 'kind'
         call add_group(models, group, '', names, text)
      end do
   end function describe_groups

   !> What scenes say of a name; empty if they do not have it.
   function describe_scene_name(models, topic) result(text)
      type(model_box_t), intent(in) :: models(:)
      !> Name of a group, a variable, a result, or a word of a scene, in small letters; a variable may stand behind its group and %.
      character(*), intent(in) :: topic
      character(:), allocatable :: text, group, lines, names, name, meant
      integer :: g

      text = ''
      meant = groups_meant(models, topic)
      do g = 1, count_words(order_of_scenes)
         group = get_word(order_of_scenes, g)
         name = topic
         if (index(topic, group//'%') == 1) name = topic(len(group) + 2:)
         if (group == topic) name = ''
         if (index(name, '%') > 0) cycle
         names = 'kind extent'
         lines = choosing_lines(group, name)
         if (has_word(meant, group)) call add_group(models, group, name, names, lines)
         if (len(lines) > 0) text = text//'&'//group//newline//lines
      end do
      lines = describe_results(models, topic)
      if (len(lines) > 0 .and. len(topic) > 0) text = text//'Results, where they have a meaning'//newline//lines
      if (len(text) > 0) text = 'In a scene (adfric help scenes)'//newline//text
   end function describe_scene_name

   !> The variables of a group that choose the solver, with their meanings and words.
   pure function choosing_lines(group, name) result(lines)
      character(*), intent(in) :: group
      !> Name of a variable, or one of its words; empty for all variables.
      character(*), intent(in) :: name
      character(:), allocatable :: lines, variable, words
      integer :: k

      lines = ''
      variable = ''
      words = ''
      do k = 1, size(choosing, 2)
         if (choosing(1, k) /= group) cycle
         variable = trim(choosing(2, k))
         words = trim(choosing(4, k))
         if (len(name) > 0 .and. name /= variable .and. .not. has_word(words, name)) cycle
         lines = lines//pad('  '//variable, name_width)//trim(choosing(3, k))//newline//words_line(words)
         if (group == 'surface') lines = lines//list_shapes(words, name, name_width)
      end do
   end function choosing_lines

   !> The words that a variable may have.
   pure function words_line(words) result(line)
      !> The words, separated by a blank.
      character(*), intent(in) :: words
      character(:), allocatable :: line
      integer :: k

      line = repeat(' ', name_width)
      do k = 1, count_words(words)
         if (k > 1) line = line//', '
         if (len(line) - index(line, newline, back=.true.) > 100) line = trim(line)//newline//repeat(' ', name_width)
         line = line//''''//get_word(words, k)//''''
      end do
      line = line//newline
   end function words_line

   !> Add the variables of a group.
   subroutine add_group(models, group, wanted, names, text)
      type(model_box_t), intent(in) :: models(:)
      character(*), intent(in) :: group
      !> Name of a variable, or one of its words; empty for all variables.
      character(*), intent(in) :: wanted
      !> Names that have been described.
      character(:), allocatable, intent(inout) :: names
      !> The page so far.
      character(:), allocatable, intent(inout) :: text
      type(variable_t) :: row
      character(:), allocatable :: name, old_names
      integer :: m, i, percent

      name = ''
      old_names = renamed_to(wanted)
      do m = 1, size(models)
         do i = 1, size(models(m)%model%variables)
            if (.not. may_be_meant(models(m)%model%variables(i), wanted, old_names)) cycle
            row = models(m)%model%variables(i)
            name = likely_name_of(models(m)%model%name, row%group//'%'//row%name)
            percent = index(name, '%')
            if (name(:percent - 1) /= group .or. has_word(names, name(percent + 1:))) cycle
            if (.not. is_meant(models(m)%model%name, name(percent + 1:), row, wanted)) cycle
            names = names//' '//name(percent + 1:)
            row%unit = likely_unit_of(name, row%unit)
            ! an angle has no words, whatever the solver takes for it
            if (row%unit == 'rad') row%choices = ''
            text = text//pad('  '//name(percent + 1:)//unit_of(row), name_width)//with_phrases(meaning_of(name, row%meaning))// &
               newline
            if (len(row%choices) > 0) text = text//words_line(words_of_all(models, name))
            if (name(percent + 1:) == wanted) text = text//usual_line(row)
         end do
      end do
   end subroutine add_group

   !> A line with the sizes that a variable usually has; empty where nothing is known.
   pure function usual_line(row) result(line)
      !> Row of the solver, with the unit of scenes.
      type(variable_t), intent(in) :: row
      character(:), allocatable :: line

      line = describe_usual(row, row%unit)
      if (len(line) > 0) line = repeat(' ', name_width)//line//newline
   end function usual_line

   !> Groups of the variables that a topic means, separated by a blank.
   function groups_meant(models, topic) result(groups)
      type(model_box_t), intent(in) :: models(:)
      !> Name of a group, a variable or a word; a variable may stand behind its group and %.
      character(*), intent(in) :: topic
      character(:), allocatable :: groups, name, old_names
      integer :: m, i, percent

      groups = ''
      name = ''
      old_names = renamed_to(topic(index(topic, '%') + 1:))
      do m = 1, size(models)
         do i = 1, size(models(m)%model%variables)
            associate (row => models(m)%model%variables(i))
               if (.not. may_be_meant(row, topic(index(topic, '%') + 1:), old_names)) cycle
               name = likely_name_of(models(m)%model%name, row%group//'%'//row%name)
               percent = index(name, '%')
               if (has_word(groups, name(:percent - 1))) cycle
               if (name(:percent - 1) == topic .or. name == topic .or. &
                  is_meant(models(m)%model%name, name(percent + 1:), row, topic)) groups = groups//' '//name(:percent - 1)
            end associate
         end do
      end do
   end function groups_meant

   !> May a variable be meant? A glance that spares most of them the rules.
   pure logical function may_be_meant(row, wanted, old_names)
      type(variable_t), intent(in) :: row
      !> Name of a group, a variable or a word; empty: every variable.
      character(*), intent(in) :: wanted
      !> What rules rename to it.
      character(*), intent(in) :: old_names

      may_be_meant = len(wanted) == 0 .or. row%name == wanted .or. len(row%choices) > 0 .or. has_word(order_of_scenes, wanted)
      if (.not. may_be_meant) may_be_meant = has_word(old_names, row%group//'%'//row%name)
   end function may_be_meant

   !> Is a variable meant by a name, or by one of its words?
   pure logical function is_meant(solver, name, row, wanted)
      !> Name of the solver, and name of the variable in the language of scenes.
      character(*), intent(in) :: solver, name
      type(variable_t), intent(in) :: row
      !> What is meant; empty: every variable.
      character(*), intent(in) :: wanted
      type(variable_t) :: renamed

      is_meant = len(wanted) == 0 .or. name == wanted
      if (is_meant .or. len(row%choices) == 0) return
      renamed = row
      call rename_words(solver, '', renamed)
      is_meant = has_word(renamed%choices, wanted)
   end function is_meant

   !> The results of all scenes, each once, or the one of a name, with their units.
   function describe_results(models, wanted) result(text)
      type(model_box_t), intent(in) :: models(:)
      !> Name of the result; empty for all results.
      character(*), intent(in) :: wanted
      character(:), allocatable :: text, names, name, old_names
      integer :: k, m, i

      text = ''
      names = ''
      name = ''
      old_names = renamed_to(wanted)
      ! from bodies to waves: the first solver is that of columns
      do k = 1, size(models)
         m = 1 + modulo(k, size(models))
         do i = 1, size(models(m)%model%results)
            associate (row => models(m)%model%results(i))
               if (len(wanted) > 0) then
                  if (.not. may_become(row%name, row%name, wanted, old_names)) cycle
               end if
               name = likely_result_of(models(m)%model%name, row%name)
               if (has_word(names, name) .or. len(wanted) > 0 .and. name /= wanted) cycle
               names = names//' '//name
               text = text//pad('  '//name//units_of_result(models, name), name_width)//with_phrases(long_name_of( &
                  & models(m)%model%name, name, row%long_name))//newline
            end associate
         end do
      end do
   end function describe_results

   !> Words of a choice, of all solvers that have it.
   function words_of_all(models, name) result(words)
      type(model_box_t), intent(in) :: models(:)
      !> Name of the variable in the language of scenes, with its group.
      character(*), intent(in) :: name
      character(:), allocatable :: words, word, old_names
      type(variable_t) :: row
      integer :: m, i, k

      words = ''
      word = ''
      old_names = renamed_to(name(index(name, '%') + 1:))
      do m = 1, size(models)
         do i = 1, size(models(m)%model%variables)
            if (models(m)%model%variables(i)%kind /= kind_choice) cycle
            row = models(m)%model%variables(i)
            if (.not. may_become(row%name, row%group//'%'//row%name, name(index(name, '%') + 1:), old_names)) cycle
            if (likely_name_of(models(m)%model%name, row%group//'%'//row%name) /= name) cycle
            call rename_words(models(m)%model%name, '', row)
            do k = 1, count_words(row%choices)
               word = get_word(row%choices, k)
               if (.not. has_word(words, word)) words = words//' '//word
            end do
         end do
      end do
   end function words_of_all

   !> Unit of a variable in brackets.
   pure function unit_of(row) result(text)
      type(variable_t), intent(in) :: row
      character(:), allocatable :: text

      text = ''
      if (len_trim(row%unit) > 0) text = ' ['//with_phrases(row%unit)//']'
   end function unit_of

   !> Names of scenes, for completion and for what may be meant by an unknown topic.
   function list_scene_names(models) result(names)
      type(model_box_t), intent(in) :: models(:)
      character(:), allocatable :: names, name
      integer :: m, i

      name = ''
      names = known_surfaces//' '//known_tractions//' extent curve_modulus '//known_extents//' '//known_curves//' '//order_of_scenes
      do m = 1, size(models)
         do i = 1, size(models(m)%model%variables)
            associate (row => models(m)%model%variables(i))
               name = likely_name_of(models(m)%model%name, row%group//'%'//row%name)
               names = names//' '//name(index(name, '%') + 1:)
            end associate
         end do
         do i = 1, size(models(m)%model%results)
            names = names//' '//likely_result_of(models(m)%model%name, models(m)%model%results(i)%name)
         end do
      end do
   end function list_scene_names

end module adfric_command_help_scenes
