! SPDX-License-Identifier: GPL-3.0-or-later
!> The names that an input may use, and what to say of a name that is not among them.
module adfric_input_vocabulary
   use adfric_base_text, only: join_words, show_text
   use adfric_base_words, only: count_words, get_word, has_word
   use adfric_input_reading, only: reading_t
   use adfric_input_suggestion, only: find_nearest, did_you_mean
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: variable_t, kind_real, kind_integer
   use adfric_describe_vocabulary, only: list_groups, list_variables, list_groups_of, order_of_scenes
   implicit none (type, external)
   private
   public :: common_groups, job_names, sweep_names, sample_names, range_names, cases_names, refine_names, &
      uncertain_names, output_names, list_common_names, list_known_groups
   public :: say_unknown_group, say_unknown_variable, say_name_of_model, report_unknown_names
   public :: find_variable, list_numbers, is_number, full_name

   !> Variables of `&job`.
   character(*), parameter :: job_names = 'model title output'
   !> Variables of `&sweep`.
   character(*), parameter :: sweep_names = 'variable from to count spacing values with'
   !> Variables of `&cases`, `&sample` and `&range`.
   character(*), parameter :: cases_names = 'file variables', sample_names = 'count method seed', &
      range_names = 'variable from to spacing'
   !> Variables of `&refine` and `&uncertain`, and those of `&output` that every model has.
   character(*), parameter :: refine_names = 'variable result tolerance resolution limit', &
      uncertain_names = 'variable error relative_error method count seed', output_names = 'derivatives'
   !> Groups that every model has.
   character(*), parameter :: common_groups = 'job sweep cases sample range refine uncertain output'

contains

   !> All groups that an input of a model may have, separated by a blank.
   pure function list_known_groups(model, common) result(groups)
      class(model_t), intent(in) :: model
      !> Names of the groups that the input may have beside those of the model, separated by a blank.
      character(*), intent(in) :: common
      character(:), allocatable :: groups
      integer :: k

      groups = common
      do k = 1, count_words(list_groups(model))
         if (.not. has_word(groups, get_word(list_groups(model), k))) groups = groups//' '//get_word(list_groups(model), k)
      end do
   end function list_known_groups

   !> Names that a group of a model may have, separated by a blank.
   pure function list_names_of(model, group) result(names)
      class(model_t), intent(in) :: model
      character(*), intent(in) :: group
      character(:), allocatable :: names

      names = list_variables(model, group)
      if (group == 'output') names = names//' '//output_names
   end function list_names_of

   !> Variables of a group that every model has, separated by a blank.
   pure function list_common_names(group) result(names)
      !> Name of the group, one of `common_groups`.
      character(*), intent(in) :: group
      character(:), allocatable :: names

      select case (group)
      case ('job')
         names = job_names
      case ('sweep')
         names = sweep_names
      case ('cases')
         names = cases_names
      case ('sample')
         names = sample_names
      case ('range')
         names = range_names
      case ('refine')
         names = refine_names
      case ('uncertain')
         names = uncertain_names
      case default
         names = output_names
      end select
   end function list_common_names

   !> What to say of a group that a model does not have.
   pure function say_unknown_group(model, group, common) result(text)
      class(model_t), intent(in) :: model
      !> The unknown name, in small letters and without `&`.
      character(*), intent(in) :: group
      character(*), intent(in) :: common
      character(:), allocatable :: text, known

      known = list_known_groups(model, common)
      if (allocated(model%scene)) then
         if (len(groups_in_scene(model, group)) > 0) then
            text = 'is a group of the model '''//model%name//'''; a scene has its variables in &'// &
               join_words(groups_in_scene(model, group), ', &')//' (adfric modernise writes such an input anew)'
            return
         end if
      else if (has_word(order_of_scenes, group)) then
         text = 'is a group of scenes, and &job names the model '''//model%name//''', whose groups are &'// &
            join_words(list_groups(model), ', &')//'; leave the model out'
         return
      end if
      text = 'unknown group for '
      if (allocated(model%scene) .and. has_word(order_of_scenes, group)) text = 'no solver knows this group in '
      text = text//name_of(model)//reason_of(model, group)//', allowed: &'//join_words(known, ', &')
      if (len(find_nearest(group, known)) > 0) text = text//'; did you mean &'//find_nearest(group, known)//'?'
   end function say_unknown_group

   !> Why a scene cannot have a group; empty where the names of the scene say so.
   pure function reason_of(model, group) result(text)
      class(model_t), intent(in) :: model
      !> The group.
      character(*), intent(in) :: group
      character(:), allocatable :: text

      text = ''
      if (.not. allocated(model%scene) .or. group /= 'heat') return
      if (index(model%scene, 'on a foundation') > 0) text = ' (heat flows along a layer and into its base, of which columns know ' &
         //'nothing; extent = ''layer'' with its thickness has heat)'
   end function reason_of

   !> Groups in which a scene has the variables that its solver has in a group of its own; empty if it has none such.
   pure function groups_in_scene(model, group) result(groups)
      class(model_t), intent(in) :: model
      character(*), intent(in) :: group
      character(:), allocatable :: groups
      integer :: i

      groups = ''
      do i = 1, size(model%variables)
         associate (variable => model%variables(i))
            if (variable%is_hidden .or. .not. allocated(variable%solver_group)) cycle
            if (variable%solver_group == group .and. .not. has_word(groups, variable%group)) groups = groups//' '//variable%group
         end associate
      end do
      groups = adjustl(groups)
   end function groups_in_scene

   !> What is solved: the scene, or the model of this name.
   pure function name_of(model) result(text)
      class(model_t), intent(in) :: model
      character(:), allocatable :: text

      text = 'the model '''//model%name//''''
      if (allocated(model%scene)) text = 'the scene '''//model%scene//''''
   end function name_of

   !> What to say of a name that the solver of a scene has for a variable; empty if it has none such.
   pure function say_name_of_model(model, group, name) result(text)
      class(model_t), intent(in) :: model
      !> Group and name in the language of the solver.
      character(*), intent(in) :: group, name
      character(:), allocatable :: text
      integer :: k

      text = ''
      if (.not. allocated(model%scene)) return
      k = model%solver_index_of(group, name)
      if (k == 0) return
      if (.not. model%variables(k)%is_hidden) text = 'is a name of the model '''//model%name//'''; in a scene it is &'// &
         model%variables(k)%group//' '//model%variables(k)%name//' (adfric modernise writes such an input anew)'
   end function say_name_of_model

   !> What to add about a variable that another scene has; empty if none does.
   pure function say_other_scene(model, group, name) result(text)
      class(model_t), intent(in) :: model
      !> Group and name in the language of scenes.
      character(*), intent(in) :: group, name
      character(:), allocatable :: text, of_others
      integer :: first, last

      text = ''
      if (.not. allocated(model%of_other_scenes)) return
      of_others = new_line('a')//model%of_other_scenes
      first = index(of_others, new_line('a')//group//'%'//name//' ')
      if (first == 0) return
      first = first + len(group) + len(name) + 3
      last = first + index(of_others(first:), new_line('a')) - 2
      text = '; the nearest scene that has it is '//of_others(first:last)
   end function say_other_scene

   !> What to say of a variable that a group does not have; the model may have it elsewhere.
   pure function say_unknown_variable(model, group, name) result(text)
      class(model_t), intent(in) :: model
      !> Name of the group where the name stands.
      character(*), intent(in) :: group
      !> The unknown name, in small letters.
      character(*), intent(in) :: name
      character(:), allocatable :: text, home, near
      integer :: k

      text = say_name_of_model(model, group, name)
      if (len(text) > 0) return
      text = say_other_scene(model, group, name)
      if (len(text) > 0) then
         if (len(find_nearest(name, list_names_of(model, group))) > 0) text = ''
         text = say_unknown_name(list_names_of(model, group), name)//text
         return
      end if
      home = list_groups_of(model, name)
      do k = 1, count_words(common_groups)
         if (len(home) == 0 .and. has_word(list_common_names(get_word(common_groups, k)), name)) home = get_word(common_groups, k)
      end do
      text = 'unknown variable'
      if (len(home) > 0) text = text//', it belongs to &'//join_words(home, ' or &')
      text = text//', allowed: '//join_words(list_names_of(model, group), ', ')
      if (len(home) > 0) return
      near = find_nearest(name, list_variables(model, ''))
      if (len(find_nearest(name, list_names_of(model, group))) > 0) then
         text = text//did_you_mean(name, list_names_of(model, group))
      else if (len(near) > 0) then
         text = text//'; did you mean '''//near//''' of &'//join_words(list_groups_of(model, near), ' or &')//'?'
      end if
   end function say_unknown_variable

   !> What to say of a variable that `&job` or `&sweep` does not have.
   pure function say_unknown_name(known, name) result(text)
      !> Names that the group has, separated by a blank.
      character(*), intent(in) :: known
      character(*), intent(in) :: name
      character(:), allocatable :: text

      text = 'unknown variable, allowed: '//join_words(known, ', ')//did_you_mean(name, known)
   end function say_unknown_name

   !> Report the variables of a group that are not among the known ones.
   subroutine report_unknown_names(r, group, known)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      character(*), intent(in) :: known
      integer :: i

      do i = 1, size(r%file%assignments)
         if (r%problems%is_enough()) return
         associate (assignment => r%file%assignments(i))
            if (assignment%group /= group .or. has_word(known, assignment%name)) cycle
            call r%file%report(r%problems, group, trim(assignment%name), say_unknown_name(known, trim(assignment%name)), &
               assignment%first)
         end associate
      end do
   end subroutine report_unknown_names

   !> Find a variable by `name` or `group%name`.
   pure subroutine find_variable(model, name, allowed, variable, flaw)
      !> The model, whose table says which variables it has and what they may be.
      class(model_t), intent(in) :: model
      !> `name` or `group%name`, in small letters.
      character(*), intent(in) :: name
      !> Names that are allowed here, separated by a blank.
      character(*), intent(in) :: allowed
      !> Index of the variable in the model's table, from 1; 0 if none is meant.
      integer, intent(out) :: variable
      !> What is wrong, what was given, what is allowed; empty if nothing is wrong.
      character(:), allocatable, intent(out) :: flaw
      character(:), allocatable :: groups, bare_name
      integer :: percent

      flaw = ''
      variable = 0
      percent = index(name, '%')
      bare_name = name(percent + 1:)
      groups = list_groups_of(model, bare_name)
      if (len(groups) == 0) then
         flaw = 'unknown variable, given '''//show_text(name)//''', allowed: '//join_words(allowed, ', ')// &
            did_you_mean(bare_name, list_variables(model, ''))
      else if (percent > 0) then
         variable = model%index_of(name(:percent - 1), bare_name)
         if (variable == 0) flaw = 'unknown variable, given '''//show_text(name)//''', it belongs to &'//join_words(groups, ' or &')
      else if (count_words(groups) > 1) then
         variable = find_bare_name(model, name)
         if (variable == 0) flaw = 'stands in several groups, given '''//name//''', allowed: '''// &
            join_words(groups, '%'//name//''' or ''')//'%'//name//''''
      else
         variable = model%index_of(groups, name)
      end if
   end subroutine find_variable

   !> The only variable of this name that may be meant without its group; 0 if none is, or several are.
   pure integer function find_bare_name(model, name)
      class(model_t), intent(in) :: model
      !> Name of the variable, in small letters and without its group.
      character(*), intent(in) :: name
      integer :: i

      find_bare_name = 0
      do i = 1, size(model%variables)
         if (model%variables(i)%name /= name .or. .not. model%variables(i)%has_bare_name) cycle
         if (find_bare_name > 0) then
            find_bare_name = 0
            return
         end if
         find_bare_name = i
      end do
   end function find_bare_name

   !> Is a variable a number, which can be swept?
   elemental logical function is_number(variable)
      !> Row of the model's table, of which the kind is read.
      type(variable_t), intent(in) :: variable

      is_number = any(variable%kind == [kind_real, kind_integer])
   end function is_number

   !> Variables that are numbers, separated by a blank, with their groups where several groups have the name.
   pure function list_numbers(model) result(list)
      class(model_t), intent(in) :: model
      character(:), allocatable :: list
      integer :: i

      list = ''
      do i = 1, size(model%variables)
         if (is_number(model%variables(i)) .and. .not. model%variables(i)%is_hidden) list = list//' '//full_name(model, i)
      end do
   end function list_numbers

   !> Name of a variable by which nothing else can be meant: with its group where several groups have the name.
   pure function full_name(model, variable) result(name)
      !> The model, whose table says which variables it has and what they may be.
      class(model_t), intent(in) :: model
      !> Index of the variable in the table, from 1.
      integer, intent(in) :: variable
      character(:), allocatable :: name

      name = model%variables(variable)%name
      if (count_words(list_groups_of(model, name)) > 1) name = model%variables(variable)%group//'%'//name
   end function full_name

end module adfric_input_vocabulary
