! SPDX-License-Identifier: GPL-3.0-or-later
!> What a solver says of its values, in the language of the scene that it answers.
!>
!> A solver names its variables by its tables, which a scene has renamed, or by words of its own. Here the latter become those of
!> the scene: the group and the variable that a problem is about, and in its text
!>
!> - `&group name` and `&group`, where the scene has the variable or all variables of the group elsewhere;
!> - names with an underscore, which no sentence has by chance;
!> - words of choices, in quotes or with an underscore,
!> - and phrases (`adfric_describe_scene_rules`).
module adfric_describe_scene_messages
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: is_name_character
   use adfric_base_words, only: count_words, get_word
   use adfric_describe_model, only: model_t
   use adfric_describe_scene_names, only: words_of_rules
   use adfric_describe_scene_rules, only: phrases
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: say_as_scene, with_phrases, replace_word

contains

   !> Have problems speak the language of a scene.
   subroutine say_as_scene(model, problems)
      !> The solver with its tables in the language of scenes; of a model of the older language nothing changes.
      class(model_t), intent(in) :: model
      !> What is wrong; groups, names and texts become those of the scene.
      type(problems_t), intent(inout) :: problems
      integer :: i

      if (.not. allocated(model%scene)) return
      do i = 1, problems%count()
         associate (item => problems%items(i))
            item%text = in_scene(model, item%text)
            call rename_subject(model, item%group, item%variable)
         end associate
      end do
   end subroutine say_as_scene

   !> Name a variable as the scene does.
   pure subroutine rename_subject(model, group, name)
      class(model_t), intent(in) :: model
      !> Group and name, in either language.
      character(:), allocatable, intent(inout) :: group, name
      integer :: k

      if (model%index_of(group, name) > 0) return
      k = model%solver_index_of(group, name)
      if (k == 0) return
      if (model%variables(k)%is_hidden) return
      group = model%variables(k)%group
      name = model%variables(k)%name
   end subroutine rename_subject

   !> A text in the language of the scene.
   function in_scene(model, of_solver) result(text)
      class(model_t), intent(in) :: model
      character(*), intent(in) :: of_solver
      character(:), allocatable :: text, pairs, pair, old
      integer :: i, k

      text = of_solver
      do i = 1, size(model%variables)
         associate (variable => model%variables(i))
            if (.not. is_renamed(variable)) cycle
            call replace_word(text, '&'//variable%solver_group//' '//variable%solver_name, '&'//variable%group//' '//variable%name)
            if (index(variable%solver_name, '_') > 0) call replace_word(text, variable%solver_name, variable%name)
         end associate
      end do
      do i = 1, size(model%variables)
         if (.not. is_renamed(model%variables(i)) .or. has_group(model, model%variables(i)%solver_group)) cycle
         call replace_word(text, '&'//model%variables(i)%solver_group, '&'//model%variables(i)%group)
      end do
      pairs = words_of_rules(model)
      pair = ''
      old = ''
      do k = 1, count_words(pairs)
         pair = get_word(pairs, k)
         old = pair(:index(pair, '=') - 1)
         call replace_word(text, ''''//old//'''', ''''//pair(len(old) + 2:)//'''')
         if (index(old, '_') > 0) call replace_word(text, old, pair(len(old) + 2:))
      end do
      text = with_phrases(text)
   end function in_scene

   !> Has the scene a variable in a group?
   pure logical function has_group(model, group)
      class(model_t), intent(in) :: model
      character(*), intent(in) :: group
      integer :: i

      has_group = .false.
      do i = 1, size(model%variables)
         if (model%variables(i)%group == group .and. .not. model%variables(i)%is_hidden) has_group = .true.
      end do
   end function has_group

   !> A text with the phrases of scenes.
   pure function with_phrases(of_solver) result(text)
      !> The text of a solver.
      character(*), intent(in) :: of_solver
      character(:), allocatable :: text
      integer :: k

      text = of_solver
      do k = 1, size(phrases)
         call replace_word(text, phrases(k)(:index(phrases(k), '=') - 1), trim(phrases(k)(index(phrases(k), '=') + 1:)))
      end do
   end function with_phrases

   !> Has a scene another name for a variable?
   pure logical function is_renamed(variable)
      type(variable_t), intent(in) :: variable

      is_renamed = .false.
      if (variable%is_hidden .or. .not. allocated(variable%solver_name)) return
      is_renamed = variable%solver_group /= variable%group .or. variable%solver_name /= variable%name
   end function is_renamed

   !> Replace a word of a text wherever it stands alone.
   pure subroutine replace_word(text, old, new)
      character(:), allocatable, intent(inout) :: text
      !> The word, not empty, and what stands in its stead.
      character(*), intent(in) :: old, new
      integer :: at, first

      if (old == new) return
      first = 1
      do
         at = index(text(first:), old)
         if (at == 0) return
         at = first + at - 1
         first = at + len(old)
         if (stands_alone(text, at, first - 1)) then
            text = text(:at - 1)//new//text(first:)
            first = at + len(new)
         end if
      end do
   end subroutine replace_word

   !> Is a part of a text no part of a longer name?
   pure logical function stands_alone(text, first, last)
      character(*), intent(in) :: text
      !> First and last character of the part.
      integer, intent(in) :: first, last

      stands_alone = .true.
      if (first > 1) stands_alone = .not. is_name_character(text(first - 1:first - 1))
      if (last < len(text)) stands_alone = stands_alone .and. .not. is_name_character(text(last + 1:last + 1))
   end function stands_alone

end module adfric_describe_scene_messages
