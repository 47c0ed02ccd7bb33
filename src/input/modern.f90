! SPDX-License-Identifier: GPL-3.0-or-later
!> An input that names a model, written anew as a scene.
module adfric_input_modern
   use adfric, only: new_model
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: newline, strip
   use adfric_base_words, only: count_words, get_word, has_word, pad
   use adfric_input_comments, only: comment_behind, comments_above, comments_at_end, comments_before, comments_inside, layout_of
   use adfric_input_literal, only: convert
   use adfric_input_modern_checks, only: check_ordinates, check_rest, count_samples
   use adfric_input_modern_values, only: bare_of, count_items, index_of_assigned, is_converted, item_of, names_in_scene, &
      numbers_in_scene, result_in_scene, swept_variable, theories_in_scene, value_in_scene, word_of
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_scene, only: find_solver, make_solver, naming
   use adfric_input_vocabulary, only: find_variable
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: variable_t
   use adfric_describe_vocabulary, only: list_groups
   use adfric_describe_scene_facts, only: find_facts, scene_t
   use adfric_describe_scene_names, only: added_word, likely_name_of, rename_words
   use adfric_input_reading, only: new_reading, reading_t
   implicit none (type, external)
   private
   public :: write_scene

   !> Solvers that have one kind of surface, and the word that a scene has for it.
   character(*), parameter :: kinds(*) = [character(30) :: 'sphere paraboloid', 'wave_1d wave_1d', 'wave_2d_elastic wave_2d', &
      & 'wave_1d_elastic wave_1d', &
      & 'surface_elastic heights', 'spectrum_elastic spectrum', 'rough_theories spectrum', 'adhesive_cylinder cylinder', &
      & 'line_load line', 'strip_load strip', 'point_load point', 'rectangle_load rectangle']
   !> Variables that name results.
   character(*), parameter :: naming_results = 'result ordinate'
   !> Width of an assignment in front of a comment.
   integer, parameter :: assignment_width = 32

contains

   !> Write an input as a scene, with its comments.
   subroutine write_scene(file, name, counts, text, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in), target :: file
      !> Name of its model.
      character(*), intent(in) :: name
      !> Number of samples of the heights along x and y; 0 where it is not known.
      integer, intent(in) :: counts(2)
      !> Receives the scene.
      character(:), allocatable, intent(out) :: text
      !> Receives what a scene cannot say; nothing is removed.
      type(problems_t), intent(inout), target :: problems
      class(model_t), allocatable :: old, new, chosen
      type(error_t), allocatable :: error
      type(scene_t) :: scene
      character(:), allocatable :: groups
      logical :: is_used(size(file%groups)), is_left_out(size(file%assignments))
      type(reading_t) :: r
      integer :: g

      call new_model(old, name, error)
      if (allocated(error)) error stop 'modernise: a model of an input is not known'
      call find_left_out(file, old, is_left_out)
      call find_scene(file, old, is_left_out, scene)
      call find_facts(scene)
      call make_solver(old%name, scene, new)
      call find_solver(scene, '', chosen)
      call new_reading(r, file, problems)
      call count_samples(counts, r, new)
      call check_ordinates(r, old, new)
      call check_rest(r, old, new, is_left_out)
      is_used = .false.
      if (size(is_used) > 0) is_used(1) = .true.

      text = comments_before(file, 1)//'&job'//newline
      if (allocated(chosen)) then
         if (chosen%name /= old%name) text = text//line_of('solver = '''//old%name//'''', '')
      end if
      do g = 1, size(file%groups)
         if (file%groups(g)%name == 'job') text = text//lines_of_common(file, g, old, new)
      end do
      call write_group(file, old, new, scene, is_left_out, 'job', is_used, text)
      text = text//'/'//newline
      groups = list_groups(new)
      do g = 1, count_words(groups)
         if (get_word(groups, g) == 'job') cycle
         call write_group(file, old, new, scene, is_left_out, get_word(groups, g), is_used, text)
      end do
      do g = 1, size(file%groups)
         if (file%groups(g)%name == 'job' .or. has_word(list_groups(old), file%groups(g)%name)) cycle
         text = text//newline//comments_before(file, g)//'&'//trim(file%groups(g)%name)//newline// &
            lines_of_common(file, g, old, new)//'/'//newline
      end do
      if (len(comments_at_end(file)) > 0) text = text//newline//comments_at_end(file)
   end subroutine write_scene

   !> Names and words of the scene that an input describes.
   subroutine find_scene(file, old, is_left_out, scene)
      type(namelist_file_t), intent(in) :: file
      class(model_t), intent(in) :: old
      !> Is the assignment left out? Shape `(n_assignments)`.
      logical, intent(in) :: is_left_out(:)
      type(scene_t), intent(out) :: scene
      character(:), allocatable :: group, name, old_names
      integer :: i, k, at

      group = ''
      name = ''
      old_names = ''
      scene%names = ''
      scene%surface = ''
      scene%state = ''
      scene%extent = 'half_space'
      if (old%name == 'wavy_sliding') scene%extent = 'foundation'
      if (file%find_group('layer') > 0) then
         scene%extent = 'layer'
         if (file%find_assignment(file%find_group('layer'), 'base_young_modulus') > 0) scene%extent = 'coating'
      end if
      do k = 1, size(kinds)
         if (get_word(kinds(k), 1) == old%name) scene%surface = get_word(kinds(k), 2)
      end do
      do i = 1, size(file%assignments)
         group = trim(file%groups(file%assignments(i)%group)%name)
         name = trim(file%assignments(i)%name)
         at = index_of_assigned(file, i, old)
         if (at > 0) then
            if (is_left_out(i)) cycle
            ! SI units say nothing of the scene
            if (name == 'units' .and. word_of(file%value_of(i), old%variables(at), old%variables(at)) == 'si') cycle
            scene%names = scene%names//' '//likely_name_of(old%name, group//'%'//name)
            old_names = old_names//' '//group//'%'//name
            if (name == 'kind') scene%surface = word_of(file%value_of(i), old%variables(at), renamed(old, at))
            if (name == 'state') scene%state = word_of(file%value_of(i), old%variables(at), old%variables(at))
            if (name == 'theory') scene%theory = word_of(file%value_of(i), old%variables(at), renamed(old, at))
         else if (has_word(naming, name)) then
            scene%names = scene%names//' '//likely_names(file%value_of(i), old)
         end if
      end do
      scene%names = adjustl(scene%names)
      call find_facts(scene)
      scene%curve = added_word(old%name, 'solid%curve_modulus', scene%facts//old_names)
      if (len(scene%state) > 0) return
      scene%state = added_word(old%name, 'operating%state', scene%facts//old_names)
      if (len(scene%state) > 0) scene%names = scene%names//' operating%state'
   end subroutine find_scene

   !> A row with the words that scenes have for its choices.
   function renamed(old, at) result(row)
      class(model_t), intent(in) :: old
      integer, intent(in) :: at
      type(variable_t) :: row

      row = old%variables(at)
      call rename_words(old%name, '', row)
   end function renamed

   !> A work or a stress of adhesion of 0 says that there is none. A scene says so by leaving out all of its size.
   subroutine find_left_out(file, old, is_left_out)
      type(namelist_file_t), intent(in) :: file
      class(model_t), intent(in) :: old
      !> Receives whether the assignment is left out; shape `(n_assignments)`.
      logical, intent(out) :: is_left_out(:)
      character(*), parameter :: that_may_be_0 = 'work_of_adhesion surface_energy stress', &
         sizes = that_may_be_0//' range adhesion_stress adhesion_range lambda'
      character(:), allocatable :: flaw
      real(dp) :: value
      logical :: is_zero
      integer :: i

      is_zero = .false.
      do i = 1, size(is_left_out)
         is_left_out(i) = index_of_assigned(file, i, old) > 0 .and. has_word(sizes, file%assignments(i)%name)
         if (.not. (is_left_out(i) .and. has_word(that_may_be_0, file%assignments(i)%name))) cycle
         call convert(strip(file%value_of(i)), value, flaw)
         if (len(flaw) == 0) is_zero = is_zero .or. .not. value > 0
      end do
      is_left_out = is_left_out .and. is_zero
   end subroutine find_left_out

   !> The likely names of the variables that a sweep names.
   function likely_names(text, old) result(names)
      !> Value of the assignment: words in quotes.
      character(*), intent(in) :: text
      class(model_t), intent(in) :: old
      character(:), allocatable :: names, word, flaw
      integer :: k, at

      names = ''
      do k = 1, count_items(text)
         call convert(item_of(text, k), word, flaw)
         if (len(flaw) > 0) cycle
         call find_variable(old, word, '', at, flaw)
         if (at == 0) cycle
         names = trim(names//' '//likely_name_of(old%name, old%variables(at)%group//'%'//old%variables(at)%name))
      end do
      names = adjustl(names)
   end function likely_names

   !> Write a group of the scene, if the input has something of it.
   subroutine write_group(file, old, new, scene, is_left_out, group, is_used, text)
      type(namelist_file_t), intent(in) :: file
      class(model_t), intent(in) :: old, new
      type(scene_t), intent(in) :: scene
      logical, intent(in) :: is_left_out(:)
      character(*), intent(in) :: group
      !> Have the comments before a group of the input been written? Shape `(n_groups)`.
      logical, intent(inout) :: is_used(:)
      !> The text so far.
      character(:), allocatable, intent(inout) :: text
      character(:), allocatable :: lines, head, note
      integer :: i, at

      lines = ''
      head = ''
      note = ''
      if (group == trim(merge('traction', 'surface ', index(old%name, '_load') > 0)) .and. new%index_of(group, 'kind') == 0) &
         lines = line_of('kind = '''//scene%surface//'''', '')
      if (group == 'operating' .and. len(scene%state) > 0 .and. &
         file%find_assignment(file%find_group('operating'), 'state') == 0) &
         lines = line_of('state = '''//scene%state//'''', '')
      if (group == 'solid' .and. scene%extent /= 'half_space') lines = line_of('extent = '''//scene%extent//'''', '')
      if (group == 'solid' .and. len(scene%curve) > 0) lines = lines//line_of('curve_modulus = '''//scene%curve//'''', '')
      do i = 1, size(file%assignments)
         associate (assignment => file%assignments(i))
            at = index_of_assigned(file, i, old)
            if (at == 0 .and. group == 'output' .and. file%groups(assignment%group)%name == 'output') &
               lines = lines//lines_of_assignment(file, i, trim(assignment%name), &
               names_in_scene(strip(file%value_of(i)), old, new), '')
            if (at == 0) cycle
            if (new%variables(at)%group /= group .or. is_left_out(i)) cycle
            if (.not. is_used(assignment%group)) head = head//comments_before(file, assignment%group)
            is_used(assignment%group) = .true.
            note = ''
            if (is_converted(new, at)) note = trim(assignment%name)//' = '//strip(file%value_of(i))//' before'
            lines = lines//lines_of_assignment(file, i, new%variables(at)%name, &
               value_in_scene(file%value_of(i), old, new, at), note)
         end associate
      end do
      if (group == 'job') then
         text = text//head//lines
      else if (len(lines) > 0) then
         text = text//newline//head//'&'//group//newline//lines//'/'//newline
      end if
   end subroutine write_group

   !> The assignments of a group that all models have, with the names of the scene.
   function lines_of_common(file, group, old, new) result(lines)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: group
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
         if (file%groups(group)%name == 'job' .and. name == 'model') then
            lines = lines//comments_above(file, i)
            if (len(comment_behind(file, i)) > 0) lines = lines//'  '//comment_behind(file, i)//newline
            cycle
         end if
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
         lines = lines//lines_of_assignment(file, i, name, text, '')
         ! data keep the names of their columns
         if (old_columns(text) /= old_columns(strip(file%value_of(i))) .and. file%groups(group)%name == 'data' .and. &
            file%find_assignment(group, column_of(name)) == 0) &
            lines = lines//line_of(column_of(name)//' = '//old_columns(strip(file%value_of(i))), '')
      end do
   end function lines_of_common

   !> The variable of `&data` that names the columns of another one.
   pure function column_of(name) result(column)
      !> Name of the other one.
      character(*), intent(in) :: name
      character(:), allocatable :: column

      column = name//'_column'
      if (name == 'variables') column = 'variable_columns'
   end function column_of

   !> Columns of the names that stood in an input: without their groups.
   function old_columns(text) result(columns)
      !> One name in quotes, or several.
      character(*), intent(in) :: text
      character(:), allocatable :: columns
      integer :: k

      columns = ''
      do k = 1, count_items(text)
         if (k > 1) columns = columns//', '
         columns = columns//''''//bare_of(item_of(text, k))//''''
      end do
   end function old_columns

   !> The lines of an assignment with its comments: those of its value, too, which keeps its lines if it has not changed.
   function lines_of_assignment(file, number, name, value, note) result(lines)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: number
      !> Name and value in the scene.
      character(*), intent(in) :: name, value
      !> What the comment says besides; empty if it says no more.
      character(*), intent(in) :: note
      character(:), allocatable :: lines, comment, inside

      lines = comments_above(file, number)
      comment = comment_behind(file, number)
      if (len(comment) > 0 .and. len(note) > 0) comment = comment//'; '
      if (len(comment) == 0 .and. len(note) > 0) comment = '! '
      comment = comment//note
      inside = comments_inside(file, number)
      if (len(inside) > 0 .and. value == strip(file%value_of(number))) then
         lines = lines//line_of(name//' '//layout_of(file, number), comment)
      else
         lines = lines//inside//line_of(name//' = '//value, comment)
      end if
   end function lines_of_assignment

   !> A line of a group, with its comment.
   pure function line_of(assignment, comment) result(line)
      !> Name, = and value.
      character(*), intent(in) :: assignment
      !> The comment with its mark; empty if there is none.
      character(*), intent(in) :: comment
      character(:), allocatable :: line, last_line

      line = '  '//assignment
      last_line = line(index(line, newline, back=.true.) + 1:)
      if (len(comment) > 0) then
         if (len(last_line) >= assignment_width) then
            line = line//'   '//comment
         else
            line = line(:len(line) - len(last_line))//pad(last_line, assignment_width)//comment
         end if
      end if
      line = line//newline
   end function line_of

end module adfric_input_modern
