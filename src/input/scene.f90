! SPDX-License-Identifier: GPL-3.0-or-later
!> An input that names no model describes a scene: a surface on a solid, with an interface, in some operation. Here the solver that
!> answers it is found.
!>
!> The file is long by what is said where no solver answers, or where another scene has what is given.
module adfric_input_scene
   use adfric, only: known_models, new_model
   use adfric_base_error, only: error_t
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: join_words, to_lower
   use adfric_base_words, only: count_words, get_word, has_word
   use adfric_input_group_values, only: take_choice, take_words
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_reading, only: new_reading, reading_t
   use adfric_input_run, only: run_input_t
   use adfric_input_variable, only: words_of_text
   use adfric_input_vocabulary, only: output_names, say_name_of_model
   use adfric_describe_model, only: model_t
   use adfric_describe_vocabulary, only: list_groups_of, order_of_scenes
   use adfric_run_converted_model, only: convert_model
   use adfric_describe_scene_facts, only: describe_scene, find_facts, is_named, scene_t, words_of
   use adfric_describe_scene_names, only: rename_tables
   use adfric_describe_scene_solvers, only: answers, find_nearest, known_boundaries, known_curves, known_extents, known_surfaces, &
      known_tractions, n_scenes, scenes, word_length
   implicit none (type, external)
   private
   public :: make_model, find_solver, make_solver, naming

   !> Names that stand for the scene itself.
   character(*), parameter :: names_of_scene = 'surface%kind solid%extent solid%boundaries solid%curve_modulus '// &
      & 'traction%kind operating%state'
   !> Variables that name other variables.
   character(*), parameter :: naming = 'variable variables with abscissa'

contains

   !> Make the model that an input names, or the solver of its scene.
   subroutine make_model(file, run, problems, error)
      !> The input, cut into groups and assignments by `read_job`.
      type(namelist_file_t), intent(in), target :: file
      !> In: what `read_job` has found. Out: also the model; it is not allocated if there is none.
      type(run_input_t), intent(inout) :: run
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout), target :: problems
      !> Allocated if the model cannot be made.
      type(error_t), allocatable, intent(out) :: error
      type(reading_t) :: r

      if (len(run%model_name) > 0) then
         call new_model(run%model, run%model_name, error)
      else if (run%is_scene .and. .not. problems%is_enough()) then
         call new_reading(r, file, problems)
         if (allocated(run%later)) then
            call new_scene_model(r, run%later, run%model)
         else
            call new_scene_model(r, '', run%model)
         end if
         if (allocated(run%model)) run%model_name = run%model%name
      end if
   end subroutine make_model

   !> Find the solver of a scene, with its tables in the language of scenes.
   subroutine new_scene_model(r, later, model)
      type(reading_t), intent(in) :: r
      !> Names of variables that get their values later, separated by a blank.
      character(*), intent(in) :: later
      !> Receives the solver; not allocated if there is none.
      class(model_t), allocatable, intent(out) :: model
      type(scene_t) :: scene
      character(:), allocatable :: solver, units

      call read_scene(r, scene)
      if (len(later) > 0) scene%names = trim(scene%names//' '//later)
      units = ''
      call read_choice(r, 'job', 'units', 'si reduced', units)
      if (units == 'reduced') scene%names = scene%names//' job%units'
      solver = ''
      call read_choice(r, 'job', 'solver', known_models, solver)
      if (len(scene%surface) == 0) return
      call find_solver(scene, solver, model)
      if (.not. allocated(model)) then
         call report_no_solver(scene, solver, r%problems)
      else if (units == 'reduced' .and. model%index_of('job', 'units') == 0) then
         call r%problems%add('job', 'units', 'reduced units are those of a paraboloid with adhesion or friction, allowed here: si')
      end if
   end subroutine new_scene_model

   !> Find the solver of a scene, with its tables in the language of scenes.
   subroutine find_solver(scene, solver, model)
      !> In: names and words of the scene. Out: with all facts.
      type(scene_t), intent(inout) :: scene
      !> Name of the solver that is wanted; empty: any.
      character(*), intent(in) :: solver
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
      if (allocated(model) .and. least > 0) call note_other_scenes(scene, model)
   end subroutine find_solver

   !> Note of each name that a scene gives and its solver does not know which scene has it.
   subroutine note_other_scenes(scene, model)
      type(scene_t), intent(in) :: scene
      !> The solver; receives the nearest scenes.
      class(model_t), intent(inout) :: model
      class(model_t), allocatable :: other
      character(word_length) :: nearest(4)
      character(:), allocatable :: name, solver, solvers
      integer :: k, m, percent

      model%of_other_scenes = ''
      name = ''
      solver = ''
      do k = 1, count_words(scene%names)
         name = get_word(scene%names, k)
         percent = index(name, '%')
         if (percent == 0 .or. has_word(names_of_scene, name)) cycle
         if (model%index_of(name(:percent - 1), name(percent + 1:)) > 0) cycle
         solvers = ''
         do m = 1, count_words(known_models)
            solver = get_word(known_models, m)
            call make_solver(solver, scene, other)
            if (other%index_of(name(:percent - 1), name(percent + 1:)) > 0) solvers = solvers//' '//solver
         end do
         if (len(solvers) == 0) cycle
         call find_nearest(words_of(scene), nearest, solvers)
         model%of_other_scenes = model%of_other_scenes//name//' '//describe_scene(nearest)//new_line('a')
      end do
   end subroutine note_other_scenes

   !> Make a solver for a scene.
   subroutine make_solver(name, scene, model)
      character(*), intent(in) :: name
      type(scene_t), intent(in) :: scene
      !> Receives the solver, with its tables in the language of scenes.
      class(model_t), allocatable, intent(out) :: model
      type(error_t), allocatable :: error

      call new_model(model, name, error)
      if (allocated(error)) error stop 'input: a solver of the table of scenes is not known'
      call rename_tables(model, scene%facts)
      call convert_model(model, scene%surface, scene%facts)
      model%scene = describe_scene(words_of(scene))
      model%scene_names = names_of_scene
   end subroutine make_solver

   !> Number of names that a scene gives and its solver does not know.
   pure integer function count_unknown(model, scene)
      !> The solver, with its tables in the language of scenes.
      class(model_t), intent(in) :: model
      type(scene_t), intent(in) :: scene
      character(:), allocatable :: name
      integer :: k, percent
      logical :: is_known

      count_unknown = 0
      name = ''
      do k = 1, count_words(scene%names)
         name = get_word(scene%names, k)
         if (has_word(names_of_scene, name)) cycle
         percent = index(name, '%')
         if (percent == 0) then
            is_known = len(list_groups_of(model, name)) > 0
         else
            is_known = model%index_of(name(:percent - 1), name(percent + 1:)) > 0
         end if
         if (.not. is_known) count_unknown = count_unknown + 1
      end do
   end function count_unknown

   !> Read what an input says of its scene.
   subroutine read_scene(r, scene)
      type(reading_t), intent(in) :: r
      !> Receives names and words; the surface is empty if something is wrong.
      type(scene_t), intent(out) :: scene
      integer :: n_before

      n_before = r%problems%count()
      call list_given(r, scene%names)
      scene%is_uncoupled = is_off(r, 'friction', 'coupling')
      scene%is_single = is_one(r, 'surface', 'seeds')
      call list_theories(r, scene%theories)
      scene%extent = 'half_space'
      call read_choice(r, 'solid', 'extent', known_extents, scene%extent)
      call check_extent(scene, r%problems)
      scene%boundaries = ''
      call read_choice(r, 'solid', 'boundaries', known_boundaries, scene%boundaries)
      scene%curve = ''
      call read_choice(r, 'solid', 'curve_modulus', known_curves, scene%curve)
      call check_curve(scene, r%problems)
      scene%state = ''
      call read_choice(r, 'operating', 'state', 'static sliding rolling', scene%state)
      scene%theory = ''
      call read_choice(r, 'adhesion', 'theory', 'auto hertz jkr dmt maugis_dugdale', scene%theory)
      call check_cases(r)
      scene%surface = ''
      if (r%file%find_group('traction') == 0) then
         call read_kind('surface', known_surfaces)
      else if (r%file%find_group('surface') > 0) then
         call r%problems%add('traction', '', 'stands beside &surface; give a surface, or the loads on the solid')
      else
         call read_kind('traction', known_tractions)
      end if
      if (r%problems%count() == n_before) call check_boundaries(scene, r%problems)
      if (r%problems%count() > n_before) scene%surface = ''

   contains

      !> The kind of a surface, or of given loads, which has to be there.
      subroutine read_kind(group, known)
         character(*), intent(in) :: group
         !> Words that are allowed, separated by a blank.
         character(*), intent(in) :: known

         call read_choice(r, group, 'kind', known, scene%surface)
         if (len(scene%surface) == 0 .and. r%problems%count() == n_before) call r%problems%add(group, 'kind', &
            'is missing, one of '//join_words(known, ', '))
      end subroutine read_kind

   end subroutine read_scene

   !> A layer has a thickness, a half-space has none, moduli of a base belong to a coating, and a stiffness per area to columns.
   subroutine check_extent(scene, problems)
      type(scene_t), intent(in) :: scene
      type(problems_t), intent(inout) :: problems
      logical :: has_thickness

      has_thickness = is_named(scene%names, 'solid%thickness')
      if ((scene%extent == 'layer' .or. scene%extent == 'coating') .and. .not. has_thickness) then
         call problems%add('solid', 'thickness', 'is missing [m]; a '//scene%extent//' needs it')
      else if (scene%extent == 'half_space' .and. has_thickness) then
         call problems%add('solid', 'thickness', 'belongs to a layer, a coating or columns, and a half-space has none; '// &
            & 'give extent = ''layer'', extent = ''coating'' or extent = ''foundation''')
      end if
      if (scene%extent /= 'layer' .and. is_named(scene%names, 'solid%base')) call problems%add('solid', 'base', &
         & 'belongs to a layer; give extent = ''layer''')
      if (scene%extent /= 'coating' .and. is_named(scene%names, 'solid%base_young_modulus')) then
         call problems%add('solid', 'base_young_modulus', 'belongs to a coating; give extent = ''coating''')
      else if (scene%extent == 'coating' .and. .not. is_named(scene%names, 'solid%base_young_modulus')) then
         call problems%add('solid', 'base_young_modulus', 'is missing [Pa]; a coating needs it and base_poisson_ratio')
      end if
      if (scene%extent /= 'foundation' .and. (is_named(scene%names, 'solid%stiffness') .or. &
         & is_named(scene%names, 'solid%stiffnesses'))) call problems%add('solid', 'stiffness', &
         & 'belongs to columns; give extent = ''foundation''')
   end subroutine check_extent

   !> A round body, or one on a line, is alone, which boundaries that are periodic would deny.
   subroutine check_boundaries(scene, problems)
      type(scene_t), intent(in) :: scene
      type(problems_t), intent(inout) :: problems

      if (scene%boundaries /= 'periodic') return
      if (has_word('wave_1d wave_2d wave_product cosines profile heights', scene%surface)) return
      call problems%add('solid', 'boundaries', 'are periodic under waves and given heights, and a body of kind '''//scene%surface &
         //''' is alone')
   end subroutine check_boundaries

   !> Which modulus a master curve is one of: that of columns is Young's.
   subroutine check_curve(scene, problems)
      type(scene_t), intent(in) :: scene
      type(problems_t), intent(inout) :: problems

      if (len(scene%curve) == 0) return
      if (.not. has_word(scene%names, 'solid%master_curve')) then
         call problems%add('solid', 'curve_modulus', 'has no meaning without master_curve')
      else if (scene%extent == 'foundation' .and. scene%curve == 'contact') then
         call problems%add('solid', 'curve_modulus', 'is ''contact'', and columns need Young''s modulus, allowed: young')
      else if (scene%curve == 'young' .and. .not. (has_word(scene%names, 'solid%poisson_ratio') .or. &
         has_word(scene%names, 'poisson_ratio'))) then
         call problems%add('solid', 'poisson_ratio', 'is missing [-]; a master curve of Young''s modulus needs it')
      end if
   end subroutine check_curve

   !> The columns of a table say what is solved, so that the input has to name them.
   subroutine check_cases(r)
      type(reading_t), intent(in) :: r
      integer :: group

      group = r%file%find_group('cases')
      if (group == 0) return
      if (r%file%find_assignment(group, 'variables') == 0) call r%report(group, 'variables', &
         'not given, needed: names of the columns, which say what scene is solved')
   end subroutine check_cases

   !> The names that an input gives values, in groups of the scene or by a sweep.
   subroutine list_given(r, names)
      type(reading_t), intent(in) :: r
      !> Receives the names with their groups; of what is swept by its name alone, the name.
      character(:), allocatable, intent(out) :: names
      character(:), allocatable :: group, name, swept
      type(problems_t), target :: unused
      type(reading_t) :: aside
      integer :: i

      aside = r
      aside%problems => unused
      names = ''
      group = ''
      name = ''
      do i = 1, size(r%file%assignments)
         group = trim(r%file%groups(r%file%assignments(i)%group)%name)
         name = trim(r%file%assignments(i)%name)
         if (has_word(order_of_scenes, group)) then
            if (group == 'output' .and. has_word(output_names, name)) cycle
            names = names//' '//group//'%'//name
         else if (has_word(naming, name)) then
            ! what is wrong with a sweep is said by those who read it
            swept = ''
            call take_words(aside, r%file%assignments(i)%group, name, '', swept)
            names = names//' '//swept
         end if
      end do
      names = adjustl(names)
   end subroutine list_given

   !> Has a variable the value .false.? What is no logical is said by those who read it.
   pure logical function is_off(r, group, name)
      type(reading_t), intent(in) :: r
      character(*), intent(in) :: group, name
      character(:), allocatable :: word
      integer :: i

      is_off = .false.
      word = ''
      do i = 1, size(r%file%assignments)
         if (r%file%groups(r%file%assignments(i)%group)%name /= group .or. r%file%assignments(i)%name /= name) cycle
         word = to_lower(trim(adjustl(r%file%value_of(i))))
         is_off = index(word, '.f') == 1 .or. index(word, 'f') == 1
      end do
   end function is_off

   !> Is 1 the value of a variable? What is no number is said by those who read it.
   pure logical function is_one(r, group, name)
      type(reading_t), intent(in) :: r
      character(*), intent(in) :: group, name
      integer :: i

      is_one = .false.
      do i = 1, size(r%file%assignments)
         if (r%file%groups(r%file%assignments(i)%group)%name /= group .or. r%file%assignments(i)%name /= name) cycle
         is_one = trim(adjustl(r%file%value_of(i))) == '1'
      end do
   end function is_one

   !> The words of the theories that are asked. What is wrong with them is said by those who read the variable.
   subroutine list_theories(r, words)
      type(reading_t), intent(in) :: r
      !> Receives the words, separated by a blank; empty if there are none.
      character(:), allocatable, intent(out) :: words
      integer :: group, number

      words = ''
      group = r%file%find_group('estimates')
      if (group == 0) return
      number = r%file%find_assignment(group, 'theories')
      if (number > 0) words = words_of_text(r%file%value_of(number))
   end subroutine list_theories

   !> Read a word of a list; what is wrong, or not given, leaves it as it is.
   subroutine read_choice(r, group, name, known, word)
      type(reading_t), intent(in) :: r
      !> Group and name of the variable.
      character(*), intent(in) :: group, name
      character(*), intent(in) :: known
      !> Receives the word.
      character(:), allocatable, intent(inout) :: word

      if (r%file%find_group(group) > 0) call take_choice(r, r%file%find_group(group), name, known, word, what='word')
   end subroutine read_choice

   !> Report names that no solver has in the language of scenes: where they are unknown the scene may be another one.
   subroutine report_unknown_names(scene, problems, is_reported)
      type(scene_t), intent(in) :: scene
      type(problems_t), intent(inout) :: problems
      logical, intent(out) :: is_reported
      class(model_t), allocatable :: model
      character(:), allocatable :: name, group, text, of_model
      integer :: n, m, percent
      logical :: is_known

      is_reported = .false.
      of_model = ''
      name = ''
      group = ''
      do n = 1, count_words(scene%names)
         name = get_word(scene%names, n)
         percent = index(name, '%')
         if (percent == 0 .or. has_word(names_of_scene, name)) cycle
         group = name(:percent - 1)
         ! a member of a list is known where the list is
         name = name(percent + 1:index(name//'(', '(') - 1)
         is_known = .false.
         text = 'unknown variable (adfric help scenes)'
         do m = 1, count_words(known_models)
            call make_solver(get_word(known_models, m), scene, model)
            is_known = is_known .or. model%index_of(group, name) > 0
            of_model = say_name_of_model(model, group, name)
            if (len(of_model) > 0) text = of_model
         end do
         if (is_known) cycle
         call problems%add(group, name, text)
         is_reported = .true.
      end do
   end subroutine report_unknown_names

   !> Say that nobody answers a scene yet, what stands in the way, and which scene is nearest.
   subroutine report_no_solver(scene, solver, problems)
      type(scene_t), intent(in) :: scene
      character(*), intent(in) :: solver
      type(problems_t), intent(inout) :: problems
      character(*), parameter :: groups(4) = [character(10) :: 'surface', 'solid', 'friction', 'operating']
      character(word_length) :: words(4), nearest(4)
      character(:), allocatable :: group
      logical :: is_reported

      words = words_of(scene)
      if (len(solver) > 0) then
         call problems%add('job', 'solver', solver//' does not solve '//describe_scene(words)//' (adfric help scenes)')
         return
      end if
      call report_unknown_names(scene, problems, is_reported)
      if (is_reported) return
      call find_nearest(words, nearest)
      group = trim(groups(findloc(nearest /= words, .true., 1)))
      if (group == 'friction' .and. .not. scene%has('shear') .and. .not. scene%has('coulomb')) group = 'adhesion'
      if (group == 'operating' .and. (scene%has('path') .or. nearest(4) == 'path')) group = 'history'
      call problems%add(group, '', 'nothing solves '//describe_scene(words)//'; the nearest scene that can be solved is '// &
         describe_scene(nearest)//hint_of_state(scene)//hint_of_history(scene, nearest)//' (adfric help scenes)')
   end subroutine report_no_solver

   !> What a scene needs whose body slides because `state` says so; empty where it has that, or says it otherwise.
   pure function hint_of_state(scene) result(hint)
      type(scene_t), intent(in) :: scene
      character(:), allocatable :: hint

      hint = ''
      if (scene%state /= 'sliding' .or. scene%has('shear')) return
      if (scene%solid == 'half_space') then
         hint = '; state = ''sliding'' needs &friction shear_strength'
      else if (.not. scene%has('moves')) then
         hint = '; over a viscoelastic solid a velocity says that the body slides'
      end if
   end function hint_of_state

   !> What a scene needs whose nearest one goes along a path; empty where it has one.
   pure function hint_of_history(scene, nearest) result(hint)
      type(scene_t), intent(in) :: scene
      character(*), intent(in) :: nearest(4)
      character(:), allocatable :: hint

      hint = ''
      if (nearest(4) == 'path' .and. scene%solid == 'relaxing' .and. .not. scene%has('path')) &
         & hint = '; give &history times with what is prescribed, or a path'
   end function hint_of_history

end module adfric_input_scene
