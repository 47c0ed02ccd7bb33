! SPDX-License-Identifier: GPL-3.0-or-later
!> An input that names no model describes a scene: a surface on a solid, with an interface, in some operation. Here the solver that
!> answers it is found.
module adfric_input_scene
   use adfric, only: known_models, new_model
   use adfric_base_error, only: error_t
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: join_words, show_text, to_lower
   use adfric_base_words, only: count_words, get_word, has_word
   use adfric_input_item, only: next_item, item_t, take_only_word
   use adfric_input_literal, only: convert
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_run, only: run_input_t
   use adfric_input_suggestion, only: did_you_mean
   use adfric_model_model, only: model_t
   use adfric_model_vocabulary, only: list_groups_of
   use adfric_run_converted_model, only: convert_model
   use adfric_scene_facts, only: describe_scene, find_facts, scene_t
   use adfric_scene_names, only: rename_tables
   use adfric_scene_solvers, only: answers, cell_t, find_cell, known_extents, known_surfaces, known_tractions, n_scenes, scenes, &
      word_length
   implicit none (type, external)
   private
   public :: make_model, find_solver, make_solver

   !> Groups of a scene, and names that stand for the scene itself.
   character(*), parameter :: scene_groups = 'surface solid adhesion friction operating history traction position numerics '// &
      'output', words_of_scene = 'surface%kind solid%extent traction%kind operating%state'
   !> Variables that name other variables.
   character(*), parameter :: naming = 'variable variables with abscissa'

contains

   !> Make the model that an input names, or the solver of its scene.
   subroutine make_model(file, run, problems, error)
      !> The input, cut into groups and assignments by `read_job`.
      type(namelist_file_t), intent(in) :: file
      !> In: what `read_job` has found. Out: also the model; it is not allocated if there is none.
      type(run_input_t), intent(inout) :: run
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      !> Allocated if the model cannot be made.
      type(error_t), allocatable, intent(out) :: error

      if (len(run%model_name) > 0) then
         call new_model(run%model, run%model_name, error)
      else if (run%is_scene .and. .not. problems%is_enough()) then
         call new_scene_model(file, run%model, problems)
         if (.not. allocated(run%model)) return
         run%model_name = run%model%name
         if (is_reduced(file) .and. run%model%index_of('job', 'units') == 0) call problems%add('job', 'units', &
            'reduced units are those of a paraboloid with adhesion or friction, allowed here: si')
      end if
   end subroutine make_model

   !> Find the solver of a scene, with its tables in the language of scenes.
   subroutine new_scene_model(file, model, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Receives the solver; not allocated if there is none.
      class(model_t), allocatable, intent(out) :: model
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      type(scene_t) :: scene
      character(:), allocatable :: solver

      call read_scene(file, scene, problems)
      solver = ''
      call read_choice(file, 'job', 'solver', known_models, solver, problems)
      if (len(scene%surface) == 0) return
      call find_solver(scene, solver, model)
      if (.not. allocated(model)) call report_no_solver(scene, solver, problems)
   end subroutine new_scene_model

   !> Find the solver of a scene, with its tables in the language of scenes.
   subroutine find_solver(scene, solver, model)
      !> In: names and words of the scene. Out: with all facts.
      type(scene_t), intent(inout) :: scene
      !> Name of the solver that is wanted; empty: any.
      character(*), intent(in) :: solver
      !> Receives the solver; not allocated if there is none.
      class(model_t), allocatable, intent(out) :: model
      class(model_t), allocatable :: other
      integer :: row, n_unknown, least

      call find_facts(scene)
      least = huge(1)
      do row = 1, n_scenes
         if (len(solver) > 0 .and. get_word(scenes(row), 5) /= solver) cycle
         if (.not. answers(row, words_of(scene))) cycle
         call make_solver(get_word(scenes(row), 5), scene, other)
         ! where no solver knows all names, the one that knows most says which it does not know
         n_unknown = count_unknown(other, scene)
         if (n_unknown >= least) cycle
         call move_alloc(other, model)
         least = n_unknown
         if (least == 0) exit
      end do
   end subroutine find_solver

   !> Make a solver for a scene.
   subroutine make_solver(name, scene, model)
      !> Name of the solver.
      character(*), intent(in) :: name
      !> The scene.
      type(scene_t), intent(in) :: scene
      !> Receives the solver, with its tables in the language of scenes.
      class(model_t), allocatable, intent(out) :: model
      type(error_t), allocatable :: error

      call new_model(model, name, error)
      if (allocated(error)) error stop 'input: a solver of the table of scenes is not known'
      call rename_tables(model, scene%facts)
      call convert_model(model, scene%surface, scene%facts)
      model%scene = describe_scene(scene%surface, scene%solid, scene%interface, scene%operation)
      model%scene_names = words_of_scene
   end subroutine make_solver

   !> Number of names that a scene gives and its solver does not know.
   pure integer function count_unknown(model, scene)
      !> The solver, with its tables in the language of scenes.
      class(model_t), intent(in) :: model
      !> The scene.
      type(scene_t), intent(in) :: scene
      character(:), allocatable :: name
      integer :: k, percent
      logical :: is_known

      count_unknown = 0
      name = ''
      do k = 1, count_words(scene%names)
         name = get_word(scene%names, k)
         if (has_word(words_of_scene, name)) cycle
         percent = index(name, '%')
         if (percent == 0) then
            is_known = len(list_groups_of(model, name)) > 0
         else
            is_known = model%index_of(name(:percent - 1), name(percent + 1:)) > 0
         end if
         if (.not. is_known) count_unknown = count_unknown + 1
      end do
   end function count_unknown

   !> Surface, solid, interface and operation.
   pure function words_of(scene) result(words)
      !> The scene.
      type(scene_t), intent(in) :: scene
      character(word_length) :: words(4)

      words = [character(word_length) :: scene%surface, scene%solid, scene%interface, scene%operation]
   end function words_of

   !> Read what an input says of its scene.
   subroutine read_scene(file, scene, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Receives names and words; the surface is empty if something is wrong.
      type(scene_t), intent(out) :: scene
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: traction
      integer :: n_before

      n_before = problems%count()
      call list_given(file, scene%names)
      scene%extent = 'half_space'
      call read_choice(file, 'solid', 'extent', known_extents, scene%extent, problems)
      scene%state = ''
      call read_choice(file, 'operating', 'state', 'static sliding', scene%state, problems)
      scene%theory = ''
      call read_choice(file, 'adhesion', 'theory', 'auto hertz jkr dmt maugis_dugdale', scene%theory, problems)
      call check_cases(file, problems)
      scene%surface = ''
      if (file%find_group('traction') == 0) then
         call read_choice(file, 'surface', 'kind', known_surfaces, scene%surface, problems)
         if (len(scene%surface) == 0 .and. problems%count() == n_before) call problems%add('surface', 'kind', &
            'is missing, one of '//join_words(known_surfaces, ', '))
      else if (file%find_group('surface') > 0) then
         call problems%add('traction', '', 'stands beside &surface; give a surface, or the loads on the solid')
      else
         traction = ''
         call read_choice(file, 'traction', 'kind', known_tractions, traction, problems)
         if (len(traction) == 0 .and. problems%count() == n_before) call problems%add('traction', 'kind', &
            'is missing, one of '//join_words(known_tractions, ', '))
         scene%surface = traction
      end if
      if (problems%count() > n_before) scene%surface = ''
   end subroutine read_scene

   !> The columns of a table say what is solved, so that the input has to name them; and units are known or refused.
   subroutine check_cases(file, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: units
      integer :: group

      group = file%find_group('cases')
      if (group > 0) then
         if (file%find_assignment(group, 'variables') == 0) call file%report_variable(problems, group, 'variables', &
            'not given, needed: names of the columns, which say what scene is solved')
      end if
      units = ''
      call read_choice(file, 'job', 'units', 'si reduced', units, problems)
   end subroutine check_cases

   !> The names that an input gives values, in groups of the scene or by a sweep.
   subroutine list_given(file, names)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Receives the names with their groups; of what is swept by its name alone, the name, and with each group of a scene.
      character(:), allocatable, intent(out) :: names
      character(:), allocatable :: group, name
      integer :: i

      names = ''
      group = ''
      name = ''
      do i = 1, size(file%assignments)
         group = trim(file%groups(file%assignments(i)%group)%name)
         name = trim(file%assignments(i)%name)
         if (has_word(scene_groups, group) .or. group == 'job' .and. name == 'units') then
            if (group == 'output' .and. name == 'derivatives') cycle
            if (group == 'job') then
               if (.not. is_reduced(file)) cycle
            end if
            names = names//' '//group//'%'//name
         else if (has_word(naming, name)) then
            call add_named(file%value_of(i), names)
         end if
      end do
      names = adjustl(names)
   end subroutine list_given

   !> Does a scene ask for reduced units?
   logical function is_reduced(file)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      character(:), allocatable :: word
      type(problems_t) :: unused

      word = ''
      call read_choice(file, 'job', 'units', 'si reduced', word, unused)
      is_reduced = word == 'reduced'
   end function is_reduced

   !> Add the variables that a sweep names.
   subroutine add_named(text, names)
      !> Value of the assignment: words in quotes.
      character(*), intent(in) :: text
      !> The names so far.
      character(:), allocatable, intent(inout) :: names
      character(:), allocatable :: flaw, word
      type(item_t) :: item
      integer :: position

      position = 1
      word = ''
      do while (position <= len(text))
         call next_item(text, position, item, flaw)
         if (len(flaw) > 0 .or. item%first == 0) return
         call convert(text(item%first:item%last), word, flaw)
         if (len(flaw) > 0) return
         names = names//' '//to_lower(word)
      end do
   end subroutine add_named

   !> Read a word of a list; what is wrong, or not given, leaves it as it is.
   subroutine read_choice(file, group, name, known, word, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Group and name of the variable.
      character(*), intent(in) :: group, name
      !> Words that are allowed, separated by a blank.
      character(*), intent(in) :: known
      !> Receives the word.
      character(:), allocatable, intent(inout) :: word
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: quoted, given, flaw
      integer :: number, i, place

      number = 0
      given = ''
      do i = 1, size(file%groups)
         if (file%groups(i)%name == group .and. number == 0) number = file%find_assignment(i, name)
         if (number > 0) exit
      end do
      if (number == 0) return
      call take_only_word(file%value_of(number), quoted, flaw, place)
      if (len(flaw) == 0) call convert(quoted, given, flaw)
      if (len(flaw) == 0) then
         if (has_word(known, given)) then
            word = given
            return
         end if
         flaw = 'unknown word, given '''//show_text(given)//''''
      end if
      call file%report_variable(problems, i, name, flaw//', allowed: '''//join_words(known, ''', ''')//''''// &
         did_you_mean(given, known), place)
   end subroutine read_choice

   !> Report names that no solver has in the language of scenes: where they are unknown the scene may be another one.
   subroutine report_unknown_names(scene, problems, is_reported)
      !> The scene.
      type(scene_t), intent(in) :: scene
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      !> Was there such a name?
      logical, intent(out) :: is_reported
      class(model_t), allocatable :: model
      character(:), allocatable :: name, group, text
      integer :: n, m, i, percent
      logical :: is_known

      is_reported = .false.
      name = ''
      group = ''
      do n = 1, count_words(scene%names)
         name = get_word(scene%names, n)
         percent = index(name, '%')
         if (percent == 0 .or. has_word(words_of_scene, name)) cycle
         group = name(:percent - 1)
         is_known = .false.
         text = 'unknown variable (adfric help scenes)'
         do m = 1, count_words(known_models)
            call make_solver(get_word(known_models, m), scene, model)
            is_known = is_known .or. model%index_of(group, name(percent + 1:)) > 0
            do i = 1, size(model%variables)
               if (model%variables(i)%is_hidden .or. .not. model%variables(i)%is_called(group, name(percent + 1:))) cycle
               text = 'is a name of the model '''//model%name//'''; in a scene it is &'//model%variables(i)%group//' '// &
                  model%variables(i)%name//' (adfric modernise writes such an input anew)'
            end do
         end do
         if (is_known) cycle
         call problems%add(group, name(percent + 1:), text)
         is_reported = .true.
      end do
   end subroutine report_unknown_names

   !> Say that nobody answers a scene yet, what stands in the way, and which scene is nearest.
   subroutine report_no_solver(scene, solver, problems)
      !> The scene.
      type(scene_t), intent(in) :: scene
      !> Name of the solver that is wanted; empty: any.
      character(*), intent(in) :: solver
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      character(*), parameter :: groups(4) = [character(10) :: 'surface', 'solid', 'friction', 'operating']
      character(word_length) :: words(4)
      character(:), allocatable :: group
      type(cell_t) :: nearest
      logical :: is_reported
      integer :: k

      if (len(solver) > 0) then
         call problems%add('job', 'solver', solver//' does not solve '//describe_scene(scene%surface, scene%solid, &
            scene%interface, scene%operation)//' (adfric help scenes)')
         return
      end if
      call report_unknown_names(scene, problems, is_reported)
      if (is_reported) return
      words = words_of(scene)
      call find_cell(words, nearest)
      group = 'surface'
      do k = 1, 4
         if (nearest%words(k) == words(k)) cycle
         group = trim(groups(k))
         exit
      end do
      if (group == 'friction' .and. .not. scene%has('shear') .and. .not. scene%has('coulomb')) group = 'adhesion'
      if (group == 'operating' .and. scene%has('path')) group = 'history'
      call problems%add(group, '', 'nothing solves '//describe_scene(scene%surface, scene%solid, scene%interface, &
         scene%operation)//'; the nearest scene that can be solved is '//describe_scene(trim(nearest%words(1)), &
         trim(nearest%words(2)), trim(nearest%words(3)), trim(nearest%words(4)))//' (adfric help scenes)')
   end subroutine report_no_solver

end module adfric_input_scene
