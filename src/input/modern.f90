! SPDX-License-Identifier: GPL-3.0-or-later
!> An input that names a model, written anew as a scene.
module adfric_input_modern
   use adfric, only: new_model
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: newline, show_number, strip
   use adfric_base_words, only: count_words, get_word, has_word, pad
   use adfric_input_item, only: item_t, next_item
   use adfric_input_literal, only: convert
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_scene, only: find_solver, make_solver
   use adfric_input_variable, only: read_variable
   use adfric_input_vocabulary, only: find_variable, full_name
   use adfric_model_model, only: model_t
   use adfric_model_table, only: kind_choice, variable_t
   use adfric_model_vocabulary, only: list_groups
   use adfric_run_converted_model, only: converted_model_t
   use adfric_scene_facts, only: find_facts, scene_t
   use adfric_scene_names, only: likely_name_of, rename_words
   implicit none (type, external)
   private
   public :: write_scene

   !> Solvers that have one kind of surface, and the word that a scene has for it.
   character(*), parameter :: kinds(*) = [character(30) :: 'sphere paraboloid', 'wave_1d wave_1d', 'wave_2d_elastic wave_2d', &
      & 'surface_elastic heights', 'line_load line', 'strip_load strip', 'point_load point']
   !> Variables that name variables, and results.
   character(*), parameter :: naming = 'variable variables with abscissa', naming_results = 'result ordinate'
   !> Width of an assignment in front of a comment.
   integer, parameter :: assignment_width = 32

contains

   !> Write an input as a scene, with its comments.
   subroutine write_scene(file, name, counts, text, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Name of its model.
      character(*), intent(in) :: name
      !> Number of samples of the heights along x and y; 0 where it is not known.
      integer, intent(in) :: counts(2)
      !> Receives the scene.
      character(:), allocatable, intent(out) :: text
      !> Receives what a scene cannot say; nothing is removed.
      type(problems_t), intent(inout) :: problems
      class(model_t), allocatable :: old, new, chosen
      type(error_t), allocatable :: error
      type(scene_t) :: scene
      character(:), allocatable :: groups
      logical :: is_used(size(file%groups))
      integer :: g

      call new_model(old, name, error)
      if (allocated(error)) error stop 'modernise: a model of an input is not known'
      call find_scene(file, old, scene)
      call find_facts(scene)
      call make_solver(old%name, scene, new)
      call find_solver(scene, '', chosen)
      call count_samples(counts, file, new, problems)
      call check_ordinates(file, old, new, problems)
      call check_rest(file, old, new, problems)
      is_used = .false.
      if (size(is_used) > 0) is_used(1) = .true.

      text = comments_before(file, 1)//'&job'//newline
      if (allocated(chosen)) then
         if (chosen%name /= old%name) text = text//line_of('solver = '''//old%name//'''', '')
      end if
      do g = 1, size(file%groups)
         if (file%groups(g)%name == 'job') text = text//lines_of_common(file, g, old, new)
      end do
      call write_group(file, old, new, scene, 'job', is_used, text)
      text = text//'/'//newline
      groups = list_groups(new)
      do g = 1, count_words(groups)
         if (get_word(groups, g) == 'job') cycle
         call write_group(file, old, new, scene, get_word(groups, g), is_used, text)
      end do
      do g = 1, size(file%groups)
         if (file%groups(g)%name == 'job' .or. has_word(list_groups(old), file%groups(g)%name)) cycle
         text = text//newline//comments_before(file, g)//'&'//trim(file%groups(g)%name)//newline// &
            lines_of_common(file, g, old, new)//'/'//newline
      end do
   end subroutine write_scene

   !> Tell a solver that converts spacings how many samples the heights have.
   subroutine count_samples(counts, file, new, problems)
      !> Number of samples along x and y; 0 where it is not known.
      integer, intent(in) :: counts(2)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> The solver, in the language of scenes.
      class(model_t), intent(inout) :: new
      !> Receives what is wrong; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: group

      select type (new)
      class is (converted_model_t)
         new%n_x = counts(1)
         new%n_y = counts(2)
      end select
      group = file%find_group('surface')
      if (counts(1) > 0 .or. group == 0) return
      if (file%find_assignment(group, 'spacing') > 0) call file%report_variable(problems, group, 'spacing', &
         'is a length of all samples in a scene, and their number is not known; put the file of the heights in its place')
   end subroutine count_samples

   !> What cannot be written as a scene is said: variables without a place in it, columns of tables by the names of the model, and
   !> numbers of converted variables but for those of sweeps.
   subroutine check_rest(file, old, new, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> The model in its own language, and in that of scenes.
      class(model_t), intent(in) :: old, new
      !> Receives what is wrong; nothing is removed.
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: group, name, words
      integer :: i, place

      group = ''
      name = ''
      words = ''
      do i = 1, size(file%assignments)
         group = trim(file%groups(file%assignments(i)%group)%name)
         name = trim(file%assignments(i)%name)
         place = old%index_of(group, name)
         if (place > 0) then
            if (new%variables(place)%is_hidden .and. .not. (has_no_adhesion(file, old) .and. is_of_adhesion(old, place))) &
               call file%report_variable(problems, file%assignments(i)%group, name, &
               'has no place in this scene, or another variable has it; write the scene by hand')
         else if (group == 'cases' .and. name == 'variables') then
            words = names_in_scene(strip(file%value_of(i)), old, new)
            if (words /= strip(file%value_of(i))) call file%report_variable(problems, file%assignments(i)%group, name, &
               'are '//words//' in a scene; rename the columns of the table first')
         else if (has_word('uncertain free', group) .and. name == 'variable') then
            if (is_converted(new, swept_variable(file, file%assignments(i)%group, old))) call file%report_variable(problems, &
               file%assignments(i)%group, name, 'is counted otherwise in a scene; write this group by hand')
         else if (has_word('sweep range', group) .and. has_word('from to values', name)) then
            if (is_converted(new, swept_variable(file, file%assignments(i)%group, old)) .and. &
               .not. are_numbers(strip(file%value_of(i)))) call file%report_variable(problems, file%assignments(i)%group, name, &
               'are counted otherwise in a scene; write them as plain numbers')
         end if
      end do
   end subroutine check_rest

   !> Is a variable counted otherwise in a scene?
   pure logical function is_converted(new, place)
      !> The solver, in the language of scenes.
      class(model_t), intent(in) :: new
      !> Place of the variable; 0: none.
      integer, intent(in) :: place

      is_converted = .false.
      select type (new)
      class is (converted_model_t)
         if (place > 0) is_converted = new%is_converted(place)
      end select
   end function is_converted

   !> Are there numbers alone, without repeats?
   logical function are_numbers(text)
      !> Value of the assignment.
      character(*), intent(in) :: text
      character(:), allocatable :: flaw
      real(dp) :: value
      integer :: k

      are_numbers = index(text, '*') == 0
      do k = 1, count_items(text)
         call convert(item_of(text, k), value, flaw)
         are_numbers = are_numbers .and. len(flaw) == 0
      end do
   end function are_numbers

   !> Says an input by a zero that there is no adhesion?
   logical function has_no_adhesion(file, old)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> The model, in its own language.
      class(model_t), intent(in) :: old
      integer :: i, place

      has_no_adhesion = .false.
      do i = 1, size(file%assignments)
         place = old%index_of(trim(file%groups(file%assignments(i)%group)%name), trim(file%assignments(i)%name))
         if (place > 0) has_no_adhesion = has_no_adhesion .or. is_zero(file, i, old, place)
      end do
   end function has_no_adhesion

   !> Is a variable one of the size of adhesion?
   pure logical function is_of_adhesion(old, place)
      !> The model, in its own language.
      class(model_t), intent(in) :: old
      !> Place of the variable.
      integer, intent(in) :: place

      is_of_adhesion = has_word('work_of_adhesion surface_energy stress range adhesion_stress adhesion_range lambda', &
         old%variables(place)%name)
   end function is_of_adhesion

   !> Data of what a scene counts over the nominal area have to be divided by it first.
   subroutine check_ordinates(file, old, new, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> The model in its own language, and in that of scenes.
      class(model_t), intent(in) :: old, new
      !> Receives what is wrong; nothing is removed.
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: word, flaw
      integer :: i, k

      select type (new)
      class is (converted_model_t)
         do i = 1, size(file%assignments)
            if (file%assignments(i)%name /= 'ordinate') cycle
            call convert(strip(file%value_of(i)), word, flaw)
            if (len(flaw) > 0) cycle
            do k = 1, size(old%results)
               if (old%results(k)%name == word .and. new%is_of_period(k)) call file%report_variable(problems, &
                  file%assignments(i)%group, 'ordinate', 'is '//new%results(k)%name//' over the nominal area ['// &
                  new%results(k)%unit//'] in a scene; divide the data by the size of a period first')
            end do
         end do
      end select
   end subroutine check_ordinates

   !> Names and words of the scene that an input describes.
   subroutine find_scene(file, old, scene)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> The model, in its own language.
      class(model_t), intent(in) :: old
      !> Receives the scene.
      type(scene_t), intent(out) :: scene
      character(:), allocatable :: group, name
      integer :: i, k, place

      group = ''
      name = ''
      scene%names = ''
      scene%surface = ''
      scene%state = ''
      scene%extent = 'half_space'
      if (old%name == 'wavy_sliding') scene%extent = 'foundation'
      if (file%find_group('layer') > 0) scene%extent = 'layer'
      do k = 1, size(kinds)
         if (get_word(kinds(k), 1) == old%name) scene%surface = get_word(kinds(k), 2)
      end do
      do i = 1, size(file%assignments)
         group = trim(file%groups(file%assignments(i)%group)%name)
         name = trim(file%assignments(i)%name)
         place = old%index_of(group, name)
         if (place > 0) then
            if (is_nothing(file, i, old, place)) cycle
            scene%names = scene%names//' '//likely_name_of(old%name, group//'%'//name)
            if (name == 'kind') scene%surface = word_of(file%value_of(i), old%variables(place), renamed(old, place))
            if (name == 'state') scene%state = word_of(file%value_of(i), old%variables(place), old%variables(place))
            if (name == 'theory') scene%theory = word_of(file%value_of(i), old%variables(place), renamed(old, place))
         else if (has_word(naming, name)) then
            scene%names = scene%names//' '//likely_names(file%value_of(i), old)
         end if
      end do
      scene%names = adjustl(scene%names)
   end subroutine find_scene

   !> A row with the words that scenes have for its choices.
   function renamed(old, place) result(row)
      !> The model, in its own language.
      class(model_t), intent(in) :: old
      !> Place of the variable.
      integer, intent(in) :: place
      type(variable_t) :: row

      row = old%variables(place)
      call rename_words(old%name, '', row)
   end function renamed

   !> Is an assignment one of adhesion that is none? A scene without adhesion has no such group.
   logical function is_nothing(file, number, old, place)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the assignment.
      integer, intent(in) :: number
      !> The model, in its own language.
      class(model_t), intent(in) :: old
      !> Place of the variable.
      integer, intent(in) :: place

      is_nothing = is_zero(file, number, old, place)
      if (.not. is_nothing .and. is_of_adhesion(old, place)) is_nothing = has_no_adhesion(file, old)
   end function is_nothing

   !> Is an assignment a work or a stress of adhesion of 0?
   logical function is_zero(file, number, old, place) result(is_nothing)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the assignment.
      integer, intent(in) :: number
      !> The model, in its own language.
      class(model_t), intent(in) :: old
      !> Place of the variable.
      integer, intent(in) :: place
      character(:), allocatable :: flaw
      real(dp) :: value

      is_nothing = has_word('work_of_adhesion surface_energy stress', old%variables(place)%name)
      if (.not. is_nothing) return
      call convert(strip(file%value_of(number)), value, flaw)
      is_nothing = len(flaw) == 0
      if (is_nothing) is_nothing = .not. value > 0
   end function is_zero

   !> The word of one row that stands where another row has the word of an input.
   function word_of(text, row, other) result(word)
      !> Value of the assignment: a word in quotes.
      character(*), intent(in) :: text
      !> The row that has the word.
      type(variable_t), intent(in) :: row
      !> The row whose word is wanted.
      type(variable_t), intent(in) :: other
      character(:), allocatable :: word, given, flaw
      integer :: k

      word = ''
      call convert(strip(text), given, flaw)
      if (len(flaw) > 0) return
      do k = 1, count_words(row%choices)
         if (get_word(row%choices, k) == given .and. k <= count_words(other%choices)) word = get_word(other%choices, k)
      end do
   end function word_of

   !> The likely names of the variables that a sweep names.
   function likely_names(text, old) result(names)
      !> Value of the assignment: words in quotes.
      character(*), intent(in) :: text
      !> The model, in its own language.
      class(model_t), intent(in) :: old
      character(:), allocatable :: names, word, flaw
      integer :: k, place

      names = ''
      do k = 1, count_items(text)
         call convert(item_of(text, k), word, flaw)
         if (len(flaw) > 0) cycle
         call find_variable(old, word, '', place, flaw)
         if (place == 0) cycle
         names = trim(names//' '//likely_name_of(old%name, old%variables(place)%group//'%'//old%variables(place)%name))
      end do
      names = adjustl(names)
   end function likely_names

   !> Number of values of an assignment.
   integer function count_items(text)
      !> Value of the assignment.
      character(*), intent(in) :: text

      count_items = 0
      do while (len(item_of(text, count_items + 1)) > 0)
         count_items = count_items + 1
      end do
   end function count_items

   !> One of the values of an assignment; empty if there are not as many.
   function item_of(text, number) result(item_text)
      !> Value of the assignment.
      character(*), intent(in) :: text
      !> Number of the value, from 1.
      integer, intent(in) :: number
      character(:), allocatable :: item_text, flaw
      type(item_t) :: item
      integer :: position, k

      item_text = ''
      position = 1
      do k = 1, number
         item_text = ''
         if (position > len(text)) return
         call next_item(text, position, item, flaw)
         if (len(flaw) > 0 .or. item%first == 0) return
         item_text = text(item%first:item%last)
      end do
   end function item_of

   !> Write a group of the scene, if the input has something of it.
   subroutine write_group(file, old, new, scene, group, is_used, text)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> The model in its own language, and in that of scenes.
      class(model_t), intent(in) :: old, new
      !> The scene.
      type(scene_t), intent(in) :: scene
      !> Name of the group.
      character(*), intent(in) :: group
      !> Have the comments before a group of the input been written? Shape `(n_groups)`.
      logical, intent(inout) :: is_used(:)
      !> The text so far.
      character(:), allocatable, intent(inout) :: text
      character(:), allocatable :: lines, head
      integer :: i, place

      lines = ''
      head = ''
      if (group == trim(merge('traction', 'surface ', index(old%name, '_load') > 0)) .and. new%index_of(group, 'kind') == 0) &
         lines = line_of('kind = '''//scene%surface//'''', '')
      if (group == 'solid' .and. scene%extent /= 'half_space') lines = line_of('extent = '''//scene%extent//'''', '')
      do i = 1, size(file%assignments)
         associate (assignment => file%assignments(i))
            place = old%index_of(trim(file%groups(assignment%group)%name), trim(assignment%name))
            if (place == 0 .and. group == 'output' .and. file%groups(assignment%group)%name == 'output') &
               lines = lines//comments_above(file, i)//line_of(trim(assignment%name)//' = '// &
               names_in_scene(strip(file%value_of(i)), old, new), comment_behind(file, i))
            if (place == 0) cycle
            if (new%variables(place)%group /= group .or. is_nothing(file, i, old, place)) cycle
            if (.not. is_used(assignment%group)) head = head//comments_before(file, assignment%group)
            is_used(assignment%group) = .true.
            lines = lines//comments_above(file, i)//line_of(new%variables(place)%name//' = '//value_in_scene(file%value_of(i), &
               old, new, place), comment_behind(file, i))
         end associate
      end do
      if (group == 'job') then
         text = text//head//lines
      else if (len(lines) > 0) then
         text = text//newline//head//'&'//group//newline//lines//'/'//newline
      end if
   end subroutine write_group

   !> Value of an assignment as a scene has it.
   function value_in_scene(given, old, new, place) result(text)
      !> Value as it stands in the input.
      character(*), intent(in) :: given
      !> The model in its own language, and in that of scenes.
      class(model_t), intent(in) :: old, new
      !> Place of the variable.
      integer, intent(in) :: place
      character(:), allocatable :: text, flaw
      real(dp) :: value
      integer :: position

      text = strip(given)
      select type (new)
      class is (converted_model_t)
         if (new%is_converted(place)) then
            call read_variable(given, old%variables(place), value, flaw, position)
            if (len(flaw) == 0) text = show_number(new%of_scene(place, value))
            return
         end if
      end select
      if (old%variables(place)%kind == kind_choice) &
         text = ''''//word_of(given, old%variables(place), new%variables(place))//''''
   end function value_in_scene

   !> The assignments of a group that all models have, with the names of the scene.
   function lines_of_common(file, group, old, new) result(lines)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the group.
      integer, intent(in) :: group
      !> The model in its own language, and in that of scenes.
      class(model_t), intent(in) :: old, new
      character(:), allocatable :: lines, name, text
      integer :: i, swept

      lines = ''
      name = ''
      text = ''
      swept = 0
      if (has_word('sweep range', file%groups(group)%name)) swept = swept_variable(file, group, old)
      do i = 1, size(file%assignments)
         if (file%assignments(i)%group /= group) cycle
         name = trim(file%assignments(i)%name)
         if (file%groups(group)%name == 'job' .and. name == 'model') cycle
         text = strip(file%value_of(i))
         if (has_word(naming, name)) then
            text = names_in_scene(text, old, new)
         else if (has_word(naming_results, name)) then
            text = result_in_scene(text, old, new)
         else if (file%groups(group)%name == 'fit' .and. name == 'theories') then
            text = theories_in_scene(text, old, new)
         else if (swept > 0 .and. has_word('from to values', name)) then
            text = numbers_in_scene(text, new, swept)
         end if
         lines = lines//comments_above(file, i)//line_of(name//' = '//text, comment_behind(file, i))
         ! data keep the names of their columns
         if (bare_of(text) /= bare_of(strip(file%value_of(i))) .and. file%groups(group)%name == 'data' .and. &
            file%find_assignment(group, name//'_column') == 0) &
            lines = lines//line_of(name//'_column = '''//bare_of(strip(file%value_of(i)))//'''', '')
      end do
   end function lines_of_common

   !> Words of theories as a scene has them.
   function theories_in_scene(text, old, new) result(words)
      !> Words in quotes.
      character(*), intent(in) :: text
      !> The model in its own language, and in that of scenes.
      class(model_t), intent(in) :: old, new
      character(:), allocatable :: words
      integer :: k, place

      words = text
      place = old%index_of('model', 'theory')
      if (place == 0) return
      words = ''
      do k = 1, count_items(text)
         if (k > 1) words = words//', '
         words = words//''''//word_of(item_of(text, k), old%variables(place), new%variables(place))//''''
      end do
   end function theories_in_scene

   !> A name without its quotes and its group.
   pure function bare_of(text) result(bare)
      !> A word in quotes.
      character(*), intent(in) :: text
      character(:), allocatable :: bare
      integer :: first

      first = max(index(text, '%', back=.true.), scan(text, '''"')) + 1
      bare = text(first:)
      if (scan(bare, '''"') > 0) bare = bare(:scan(bare, '''"') - 1)
   end function bare_of

   !> Place of the variable that a group sweeps; 0 if it names none.
   integer function swept_variable(file, group, old) result(place)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the group.
      integer, intent(in) :: group
      !> The model, in its own language.
      class(model_t), intent(in) :: old
      character(:), allocatable :: word, flaw
      integer :: number

      place = 0
      number = file%find_assignment(group, 'variable')
      if (number == 0) return
      call convert(item_of(file%value_of(number), 1), word, flaw)
      if (len(flaw) == 0) call find_variable(old, word, '', place, flaw)
   end function swept_variable

   !> Names of variables as a scene has them.
   function names_in_scene(text, old, new) result(names)
      !> Words in quotes.
      character(*), intent(in) :: text
      !> The model in its own language, and in that of scenes.
      class(model_t), intent(in) :: old, new
      character(:), allocatable :: names, word, flaw
      integer :: k, place

      names = ''
      do k = 1, count_items(text)
         call convert(item_of(text, k), word, flaw)
         place = 0
         if (len(flaw) == 0) call find_variable(old, word, '', place, flaw)
         if (place > 0) word = full_name(new, place)
         if (k > 1) names = names//', '
         names = names//''''//word//''''
      end do
   end function names_in_scene

   !> Name of a result as a scene has it.
   function result_in_scene(text, old, new) result(name)
      !> A word in quotes.
      character(*), intent(in) :: text
      !> The model in its own language, and in that of scenes.
      class(model_t), intent(in) :: old, new
      character(:), allocatable :: name, word, flaw
      integer :: k

      name = text
      call convert(text, word, flaw)
      if (len(flaw) > 0) return
      do k = 1, size(old%results)
         if (old%results(k)%name == word) name = ''''//new%results(k)%name//''''
      end do
   end function result_in_scene

   !> Numbers of a swept variable as a scene has them.
   function numbers_in_scene(text, new, place) result(numbers)
      !> The numbers, or the name of a dataset.
      character(*), intent(in) :: text
      !> The solver, in the language of scenes.
      class(model_t), intent(in) :: new
      !> Place of the variable.
      integer, intent(in) :: place
      character(:), allocatable :: numbers, flaw
      real(dp) :: value
      integer :: k

      numbers = text
      select type (new)
      class is (converted_model_t)
         if (.not. new%is_converted(place)) return
         numbers = ''
         do k = 1, count_items(text)
            call convert(item_of(text, k), value, flaw)
            if (k > 1) numbers = numbers//', '
            if (len(flaw) == 0) numbers = numbers//show_number(new%of_scene(place, value))
            if (len(flaw) > 0) numbers = numbers//item_of(text, k)
         end do
      end select
   end function numbers_in_scene

   !> A line of a group, with its comment.
   pure function line_of(assignment, comment) result(line)
      !> Name, = and value.
      character(*), intent(in) :: assignment
      !> The comment with its mark; empty if there is none.
      character(*), intent(in) :: comment
      character(:), allocatable :: line

      line = '  '//assignment
      if (len(comment) > 0) line = pad(line, assignment_width)//comment
      if (len(comment) > 0 .and. len(assignment) + 2 >= assignment_width) line = '  '//assignment//'   '//comment
      line = line//newline
   end function line_of

   !> Lines of comment before a group, from the end of the group before it.
   function comments_before(file, group) result(lines)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the group.
      integer, intent(in) :: group
      character(:), allocatable :: lines
      integer :: first

      first = 1
      if (group > 1) first = end_of_line_at(file%text, file%groups(group - 1)%body_last + 1)
      lines = comment_lines(file%text(first:file%groups(group)%first - 1))
   end function comments_before

   !> Lines of comment above an assignment, from the assignment before it.
   function comments_above(file, number) result(lines)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the assignment.
      integer, intent(in) :: number
      character(:), allocatable :: lines
      integer :: first

      associate (assignment => file%assignments(number))
         first = file%groups(assignment%group)%body_first
         if (number > 1) then
            if (file%assignments(number - 1)%group == assignment%group) first = file%assignments(number - 1)%value_last + 1
         end if
         first = end_of_line_at(file%text, first)
         lines = comment_lines(file%text(first:assignment%first - 1))
      end associate
   end function comments_above

   !> Place behind the end of the line of a place.
   pure integer function end_of_line_at(text, place)
      !> The text.
      character(*), intent(in) :: text
      !> The place.
      integer, intent(in) :: place

      end_of_line_at = len(text) + 1
      if (place > len(text)) return
      if (index(text(place:), newline) > 0) end_of_line_at = place + index(text(place:), newline)
   end function end_of_line_at

   !> The lines of a text that are comments.
   pure function comment_lines(text) result(lines)
      !> The text, from the beginning of a line.
      character(*), intent(in) :: text
      character(:), allocatable :: lines, line
      integer :: first, last

      lines = ''
      first = 1
      do while (first <= len(text))
         last = end_of_line_at(text, first) - 1
         line = strip(text(first:last))
         if (index(line, '!') == 1) lines = lines//text(first:last)
         first = last + 1
      end do
   end function comment_lines

   !> The comment behind an assignment, in its line; empty if there is none.
   function comment_behind(file, number) result(comment)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the assignment.
      integer, intent(in) :: number
      character(:), allocatable :: comment
      integer :: first, last, mark

      comment = ''
      first = file%assignments(number)%value_last + 1
      last = end_of_line_at(file%text, first) - 1
      if (last < first) return
      if (number < size(file%assignments)) then
         if (file%assignments(number + 1)%first <= last) return
      end if
      mark = index(file%text(first:last), '!')
      if (mark > 0) comment = strip(file%text(first + mark - 1:last))
   end function comment_behind

end module adfric_input_modern
