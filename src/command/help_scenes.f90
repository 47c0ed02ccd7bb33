! SPDX-License-Identifier: GPL-3.0-or-later
!> The page of scenes: which can be solved, and the variables of their groups.
module adfric_command_help_scenes
   use adfric_base_text, only: newline
   use adfric_base_words, only: count_words, get_word, has_word, pad
   use adfric_command_help_lists, only: model_box_t
   use adfric_describe_table, only: kind_choice, variable_t
   use adfric_describe_vocabulary, only: order_of_scenes
   use adfric_describe_scene_names, only: likely_name_of, likely_result_of, meaning_of, rename_words
   use adfric_describe_scene_solvers, only: accuracy_of_scene, known_extents, known_surfaces, known_tractions, word_length
   implicit none (type, external)
   private
   public :: describe_scenes, list_scene_names

   !> Columns of the table: solid, interface, operation, and what they are.
   integer, parameter :: n_columns = 10
   character(*), parameter :: columns(3, n_columns) = reshape([character(word_length) :: &
      & 'half_space', 'none', 'press', 'half_space', 'adhesion', 'press', 'half_space', 'shear', 'slide', &
      & 'half_space', 'adhesion+shear', 'slide', 'half_space', 'coulomb', 'tangential', 'half_space', 'coulomb', 'path', &
      & 'relaxing', 'none', 'slide', 'layer', 'none', 'slide', 'foundation', 'none', 'slide', 'foundation', 'adhesion', 'slide'], &
      & [3, n_columns])
   character(*), parameter :: heads(n_columns) = [character(70) :: &
      & 'elastic half-space, pressed', 'elastic half-space, pressed, with adhesion', &
      & 'elastic half-space, sliding with a shear strength', &
      & 'elastic half-space, sliding with adhesion and a shear strength', &
      & 'elastic half-space, tangential force below mu P (Coulomb)', 'elastic half-space, path of loads and tangential forces', &
      & 'viscoelastic half-space, sliding', 'viscoelastic layer, sliding', 'viscoelastic foundation (columns), sliding', &
      & 'viscoelastic foundation (columns), sliding with adhesion']
   !> Width of the column of names.
   integer, parameter :: name_width = 40, surface_width = 18

contains

   !> The whole page.
   function describe_scenes(models) result(text)
      type(model_box_t), intent(in) :: models(:)
      character(:), allocatable :: text

      text = 'A scene is a surface on a solid, with an interface, in some operation.'//newline// &
         'An input that names no model describes one:'//newline//newline// &
         '  &surface kind = ''paraboloid'', radius = 140e-9 /'//newline// &
         '  &solid contact_modulus = 44e9 /'//newline// &
         '  &adhesion work_of_adhesion = 0.19, lambda = 0.8 /'//newline// &
         '  &friction shear_strength = 0.96e9 /'//newline// &
         '  &operating load = 1e-7, state = ''sliding'' /'//newline//newline// &
         'The program finds the solver; adfric check says which. &job solver = ''NAME'' asks for one of several.'//newline// &
         'e: exact (closed forms, roots, integrals), n: numerical (cells or collocation), -: nothing solves it yet.'//newline &
         //newline//describe_table()//newline &
         //'Given loads: &traction kind = ''line'', ''strip'' or ''point'' in place of &surface.'//newline//newline &
         //'Variables'//newline//describe_groups(models)//newline//'Results, where they have a meaning'//newline// &
         describe_results(models)
   end function describe_scenes

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
         if (group == 'surface') text = text//words_line('kind', known_surfaces)
         if (group == 'traction') text = text//words_line('kind', known_tractions)
         if (group == 'solid') text = text//words_line('extent', known_extents)
         if (has_word('surface traction', group)) names = 'kind'
         call add_group(models, group, names, text)
      end do
   end function describe_groups

   !> A variable whose words are known.
   pure function words_line(name, words) result(line)
      character(*), intent(in) :: name
      !> Its words, separated by a blank.
      character(*), intent(in) :: words
      character(:), allocatable :: line
      integer :: k

      line = pad('  '//name, name_width)
      do k = 1, count_words(words)
         if (k > 1) line = line//', '
         if (len(line) - index(line, newline, back=.true.) > 100) line = trim(line)//newline//repeat(' ', name_width)
         line = line//''''//get_word(words, k)//''''
      end do
      line = line//newline
   end function words_line

   !> Add the variables of a group.
   subroutine add_group(models, group, names, text)
      type(model_box_t), intent(in) :: models(:)
      !> Name of the group.
      character(*), intent(in) :: group
      !> Names that have been described.
      character(:), allocatable, intent(inout) :: names
      !> The page so far.
      character(:), allocatable, intent(inout) :: text
      type(variable_t) :: row
      character(:), allocatable :: name
      integer :: m, i, percent

      name = ''
      do m = 1, size(models)
         do i = 1, size(models(m)%model%variables)
            row = models(m)%model%variables(i)
            name = likely_name_of(models(m)%model%name, row%group//'%'//row%name)
            percent = index(name, '%')
            if (name(:percent - 1) /= group .or. has_word(names, name(percent + 1:))) cycle
            names = names//' '//name(percent + 1:)
            ! an angle in scenes, whatever it is for the solver
            if (name == 'operating%direction') then
               row%choices = ''
               row%unit = 'rad'
            end if
            text = text//pad('  '//name(percent + 1:)//unit_of(row), name_width)//meaning_of(name, row%meaning)// &
               newline
            if (len(row%choices) > 0) text = text//words_line('', words_of_all(models, name))
         end do
      end do
   end subroutine add_group

   !> The results of all scenes, each once.
   function describe_results(models) result(text)
      type(model_box_t), intent(in) :: models(:)
      character(:), allocatable :: text, names, name
      integer :: k, m, i

      text = ''
      names = ''
      name = ''
      ! from bodies to waves: the first solver is that of columns
      do k = 1, size(models)
         m = 1 + modulo(k, size(models))
         do i = 1, size(models(m)%model%results)
            associate (row => models(m)%model%results(i))
               name = likely_result_of(models(m)%model%name, row%name)
               if (has_word(names, name)) cycle
               names = names//' '//name
               text = text//pad('  '//name, name_width)//row%long_name//newline
            end associate
         end do
      end do
   end function describe_results

   !> Words of a choice, of all solvers that have it.
   function words_of_all(models, name) result(words)
      type(model_box_t), intent(in) :: models(:)
      !> Name of the variable in the language of scenes, with its group.
      character(*), intent(in) :: name
      character(:), allocatable :: words, word
      type(variable_t) :: row
      integer :: m, i, k

      words = ''
      word = ''
      do m = 1, size(models)
         do i = 1, size(models(m)%model%variables)
            if (models(m)%model%variables(i)%kind /= kind_choice) cycle
            row = models(m)%model%variables(i)
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
      if (len_trim(row%unit) > 0) text = ' ['//row%unit//']'
   end function unit_of

   !> Names of scenes, for completion and for what may be meant by an unknown topic.
   function list_scene_names(models) result(names)
      type(model_box_t), intent(in) :: models(:)
      character(:), allocatable :: names, name
      integer :: m, i

      name = ''
      names = known_surfaces//' '//known_tractions//' extent '//known_extents//' '//order_of_scenes
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
