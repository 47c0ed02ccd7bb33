! SPDX-License-Identifier: GPL-3.0-or-later
!> What a scene calls the variables, results and profiles of the solver that answers it.
!> The rules stand in `adfric_describe_scene_rules`.
module adfric_describe_scene_names
   use adfric_base_words, only: count_words, get_word, has_word
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: result_t, variable_t
   use adfric_describe_scene_rules, only: added_words, default_rules, hidden, meanings, profile_rules, result_rules, &
      & variable_rules, with_depth, word_rules
   implicit none (type, external)
   private
   public :: rename_tables, rename_words, likely_name_of, likely_result_of, likely_unit_of, long_name_of, meaning_of, &
      & words_of_rules, added_word, renamed_to, may_become

contains

   !> Call the rows of a solver's tables as a scene does, and hide those that have no meaning in it.
   subroutine rename_tables(model, facts)
      !> The solver, whose tables are in its own language.
      class(model_t), intent(inout) :: model
      !> Facts of the scene, separated by a blank.
      character(*), intent(in) :: facts
      integer :: i

      do i = 1, size(model%variables)
         call set_default(model%name, facts, model%variables(i))
         call rename_variable(model%name, facts, model%variables(i))
      end do
      do i = 1, size(model%results)
         call rename_result(model%name, facts, model%results(i))
      end do
      do i = 1, size(model%profiles)
         model%profiles(i)%name = scene_name_of(profile_rules, model%name, model%profiles(i)%name, facts)
         model%profiles(i)%long_name = long_name_of(model%name, model%profiles(i)%name, model%profiles(i)%long_name)
      end do
      if (is_of(with_depth, model%name)) model%profile_axes = 'z x'
   end subroutine rename_tables

   !> Give a variable the value that follows from what a scene leaves out.
   subroutine set_default(solver, facts, variable)
      character(*), intent(in) :: solver, facts
      !> Row of the solver, in its own language.
      type(variable_t), intent(inout) :: variable
      character(:), allocatable :: value
      integer :: i

      value = ''
      do i = 1, size(default_rules)
         if (.not. is_for(default_rules(i), solver, variable%group//'%'//variable%name)) cycle
         if (.not. is_so(default_rules(i), facts)) cycle
         value = get_word(default_rules(i), 3)
         read (value, *) variable%default
      end do
   end subroutine set_default

   !> The word of a variable that a scene says and an input which names a model leaves out; empty if there is none.
   pure function added_word(solver, name, facts) result(word)
      !> Name of the solver, and name of the variable, with its group.
      character(*), intent(in) :: solver, name
      !> Facts of the scene without the word, and names of the solver that the input gives, `group%name`.
      character(*), intent(in) :: facts
      character(:), allocatable :: word
      integer :: i

      word = ''
      do i = 1, size(added_words)
         if (is_for(added_words(i), solver, name) .and. is_so(added_words(i), facts)) word = get_word(added_words(i), 3)
      end do
   end function added_word

   !> Call a variable as a scene does.
   subroutine rename_variable(solver, facts, variable)
      character(*), intent(in) :: solver, facts
      type(variable_t), intent(inout) :: variable
      character(:), allocatable :: name
      integer :: percent

      call rename_words(solver, facts, variable)
      name = scene_name_of(variable_rules, solver, variable%group//'%'//variable%name, facts)
      variable%solver_group = variable%group
      variable%solver_name = variable%name
      variable%is_hidden = name == hidden .or. variable%is_hidden
      if (name == hidden) then
         variable%group = hidden
         variable%name = hidden
         return
      end if
      percent = index(name, '%')
      variable%group = name(:percent - 1)
      variable%name = name(percent + 1:)
      variable%meaning = meaning_of(name, variable%meaning)
   end subroutine rename_variable

   !> What a variable is.
   pure function meaning_of(name, of_solver) result(meaning)
      !> Its name in the language of scenes, with its group.
      character(*), intent(in) :: name
      !> What the solver says of it.
      character(*), intent(in) :: of_solver
      character(:), allocatable :: meaning
      integer :: i

      meaning = of_solver
      do i = 1, size(meanings)
         if (behind_word(meanings(i), 1) /= len(name) + 1) cycle
         if (meanings(i)(:len(name)) == name) meaning = trim(meanings(i)(len(name) + 2:))
      end do
   end function meaning_of

   !> Call a result as a scene does.
   subroutine rename_result(solver, facts, result)
      character(*), intent(in) :: solver, facts
      type(result_t), intent(inout) :: result
      character(:), allocatable :: name

      if (allocated(result%flag_meanings)) call rename_list(solver, facts, 'results%'//result%name, result%flag_meanings)
      name = scene_name_of(result_rules, solver, result%name, facts)
      result%solver_name = result%name
      result%is_hidden = name == hidden .or. result%is_hidden
      if (name == hidden) then
         result%is_main = .false.
         result%flag_meanings = ''
      end if
      result%name = name
      result%long_name = long_name_of(solver, name, result%long_name)
   end subroutine rename_result

   !> What a result or a profile is, in the words of scenes.
   pure function long_name_of(solver, name, of_solver) result(long_name)
      !> Name of the solver, name in scenes, and what the solver says of it.
      character(*), intent(in) :: solver, name, of_solver
      character(:), allocatable :: long_name

      long_name = meaning_of(solver//'%'//name, of_solver)
      if (is_of(with_depth, solver)) long_name = with_z(long_name)
   end function long_name_of

   !> A text with z for the depth, which is y for the solvers of the plane.
   pure function with_z(text) result(renamed)
      character(*), intent(in) :: text
      character(:), allocatable :: renamed
      character(*), parameter :: pairs(*) = [character(15) :: 's_yy=s_zz', 's_xy=s_xz', 'u_y=u_z', 'along y=along z']
      integer :: i, at, equals

      renamed = text
      do i = 1, size(pairs)
         equals = index(pairs(i), '=')
         at = index(renamed, pairs(i)(:equals - 1))
         if (at > 0) renamed = renamed(:at - 1)//trim(pairs(i)(equals + 1:))//renamed(at + equals - 1:)
      end do
   end function with_z

   !> Have the words of a variable those of scenes.
   pure subroutine rename_words(solver, facts, variable)
      !> Name of the solver.
      character(*), intent(in) :: solver
      !> Facts of the scene, separated by a blank.
      character(*), intent(in) :: facts
      !> Row of the solver, whose choices are renamed.
      type(variable_t), intent(inout) :: variable

      call rename_list(solver, facts, variable%group//'%'//variable%name, variable%choices)
   end subroutine rename_words

   !> Have words those of scenes.
   pure subroutine rename_list(solver, facts, name, words)
      character(*), intent(in) :: solver, facts
      !> What has the words, in the language of the solver, with its group.
      character(*), intent(in) :: name
      !> The words, separated by a blank.
      character(:), allocatable, intent(inout) :: words
      character(:), allocatable :: choices, word, pair
      integer :: i, k, n

      do i = 1, size(word_rules)
         if (.not. is_for(word_rules(i), solver, name)) cycle
         if (.not. is_so(word_rules(i), facts)) cycle
         choices = ''
         do k = 1, count_words(words)
            word = get_word(words, k)
            do n = 3, count_words(word_rules(i))
               pair = get_word(word_rules(i), n)
               if (index(pair, word//'=') == 1) then
                  word = pair(len(word) + 2:)
                  exit
               end if
            end do
            choices = choices//' '//word
         end do
         words = choices(2:)
         return
      end do
   end subroutine rename_list

   !> The words that a scene always calls otherwise than its solver, as `old=new` and separated by a blank.
   pure function words_of_rules(model) result(pairs)
      !> The solver, with its tables in the language of scenes.
      class(model_t), intent(in) :: model
      character(:), allocatable :: pairs, variable
      integer :: i, k

      pairs = ''
      variable = ''
      do i = 1, size(word_rules)
         variable = get_word(word_rules(i), 2)
         k = index(variable, '%')
         if (.not. is_of(get_word(word_rules(i), 1), model%name)) cycle
         if (model%solver_index_of(variable(:k - 1), variable(k + 1:)) == 0 .or. .not. is_so(word_rules(i), '')) cycle
         do k = 3, count_words(word_rules(i))
            pairs = trim(pairs//' '//get_word(word_rules(i), k))
         end do
      end do
      pairs = adjustl(pairs)
   end function words_of_rules

   !> What a scene calls something; `hidden` if it has no meaning there.
   pure function scene_name_of(rules, solver, name, facts) result(new_name)
      character(*), intent(in) :: rules(:), solver
      !> Name in the language of the solver, of a variable with its group.
      character(*), intent(in) :: name
      character(*), intent(in) :: facts
      character(:), allocatable :: new_name
      integer :: i

      do i = 1, size(rules)
         if (.not. is_for(rules(i), solver, name)) cycle
         if (.not. is_so(rules(i), facts)) cycle
         new_name = name_by(rules(i), name)
         return
      end do
      new_name = name
   end function scene_name_of

   !> Is a rule one for something of a solver?
   pure logical function is_for(rule, solver, name)
      character(*), intent(in) :: rule
      !> Name of the solver, and name in its language, of a variable with its group.
      character(*), intent(in) :: solver, name
      integer :: first, behind

      ! the second word of the rule, without a copy, since most rules are for something else
      first = behind_word(rule, 1) + 1
      behind = behind_word(rule, first)
      associate (from => rule(first:behind - 1))
         if (iachar(rule(behind - 1:behind - 1)) == iachar('%')) then
            ! a group stands for all its variables
            is_for = index(name, from) == 1
         else
            is_for = len(from) >= len(name)
            if (is_for) is_for = index(from, name) > 0
            if (is_for) is_for = is_of(from, name)
         end if
      end associate
      if (is_for) is_for = is_of(rule(:first - 2), solver)
   end function is_for

   !> Index of the blank behind a word.
   pure integer function behind_word(rule, first) result(behind)
      character(*), intent(in) :: rule
      !> Index of the first letter of the word.
      integer, intent(in) :: first

      ! a comparison with ' ' itself would take a library's procedure for each letter
      do behind = first, len(rule)
         if (iachar(rule(behind:behind)) == iachar(' ')) return
      end do
   end function behind_word

   !> What a rule calls something that it is for.
   pure function name_by(rule, name) result(new_name)
      character(*), intent(in) :: rule, name
      character(:), allocatable :: new_name, from

      from = get_word(rule, 2)
      new_name = get_word(rule, 3)
      if (from /= name .and. new_name /= hidden) new_name = new_name//name(len(from) + 1:)
   end function name_by

   !> What solvers call the variables, with their groups, and results that rules rename to a name, separated by a blank.
   pure function renamed_to(name) result(names)
      !> Name in the language of scenes, of a variable without its group.
      character(*), intent(in) :: name
      character(:), allocatable :: names
      integer :: i

      names = ''
      do i = 1, size(variable_rules)
         if (index(variable_rules(i), '%'//name//' ') > 0) names = names//' '//get_word(variable_rules(i), 2)
      end do
      do i = 1, size(result_rules)
         if (index(result_rules(i), ' '//name//' ') > 0) names = names//' '//get_word(result_rules(i), 2)
      end do
   end function renamed_to

   !> May rules call something by a name? A glance that spares most rows the rules.
   pure logical function may_become(old_name, with_group, name, old_names)
      !> Name in the language of the solver, and that with its group, if it is one of a variable.
      character(*), intent(in) :: old_name, with_group
      !> Name in the language of scenes, without a group, and what `renamed_to` says of it.
      character(*), intent(in) :: name, old_names

      may_become = old_name == name
      if (.not. may_become) may_become = has_word(old_names, with_group)
   end function may_become

   !> What a scene probably calls a variable, with its group, before its facts are known.
   pure function likely_name_of(solver, name) result(new_name)
      !> Name of the solver, and name of the variable in its language.
      character(*), intent(in) :: solver, name
      character(:), allocatable :: new_name

      new_name = likely_name(variable_rules, solver, name, .true.)
   end function likely_name_of

   !> The same of a result.
   pure function likely_result_of(solver, name) result(new_name)
      !> Name of the solver, and name of the result in its language.
      character(*), intent(in) :: solver, name
      character(:), allocatable :: new_name

      ! rules that need a fact are for some scenes
      new_name = likely_name(result_rules, solver, name, .false.)
   end function likely_result_of

   !> The unit of a variable in scenes.
   pure function likely_unit_of(new_name, of_solver) result(unit)
      !> What `likely_name_of` says, and unit of the solver.
      character(*), intent(in) :: new_name, of_solver
      character(:), allocatable :: unit

      unit = of_solver
      ! an angle in scenes, whatever it is for the solver
      if (new_name == 'operating%direction') unit = 'rad'
   end function likely_unit_of

   !> Does a rule need a fact to be there?
   elemental logical function needs_fact(rule)
      character(*), intent(in) :: rule
      integer :: k

      needs_fact = .false.
      do k = 4, count_words(rule)
         needs_fact = needs_fact .or. index(get_word(rule, k), '!') /= 1
      end do
   end function needs_fact

   !> What a scene calls something by the first rule that does not hide it.
   pure function likely_name(rules, solver, name, with_facts) result(new_name)
      character(*), intent(in) :: rules(:)
      !> Name of the solver, and name in its language.
      character(*), intent(in) :: solver, name
      !> Do rules count that need a fact to be there?
      logical, intent(in) :: with_facts
      character(:), allocatable :: new_name
      integer :: i

      do i = 1, size(rules)
         if (.not. is_for(rules(i), solver, name)) cycle
         if (.not. with_facts) then
            if (needs_fact(rules(i))) cycle
         end if
         new_name = name_by(rules(i), name)
         if (new_name /= hidden) return
      end do
      new_name = name
   end function likely_name

   !> Is a solver or another name among those of a rule?
   pure logical function is_of(names, name)
      !> Names, separated by a comma, or `*`.
      character(*), intent(in) :: names
      character(*), intent(in) :: name

      is_of = names == '*' .or. index(','//names//',', ','//name//',') > 0
   end function is_of

   !> Does a scene have the facts that a rule needs?
   pure logical function is_so(rule, facts)
      character(*), intent(in) :: rule, facts
      character(:), allocatable :: fact
      integer :: k

      is_so = .true.
      do k = 4, count_words(rule)
         fact = get_word(rule, k)
         if (index(fact, '=') > 0) cycle
         if (fact(1:1) == '!') then
            is_so = is_so .and. .not. has_word(facts, fact(2:))
         else
            is_so = is_so .and. has_word(facts, fact)
         end if
      end do
   end function is_so

end module adfric_describe_scene_names
