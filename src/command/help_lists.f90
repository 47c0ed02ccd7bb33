! SPDX-License-Identifier: GPL-3.0-or-later
!> Lists of all models, groups, variables, results and units, from the tables of the models.
module adfric_command_help_lists
   use adfric_base_words, only: count_words, get_word, pad
   use adfric_base_text, only: newline
   use adfric_command_help_entries, only: entries_t
   use adfric_input_fit_rows, only: fit_groups, get_fit_rows
   use adfric_input_vocabulary, only: common_groups
   use adfric_describe_model, only: model_t
   use adfric_describe_scene_names, only: likely_name_of, likely_result_of, likely_unit_of, may_become, &
      & renamed_to
   use adfric_describe_table, only: result_t, common_results, variable_t
   use adfric_run_conversion, only: is_counted_over_area, unit_over_area
   implicit none (type, external)
   private
   public :: model_box_t, list_topics, show_list, units_of_result

   !> Topics that are lists.
   character(*), parameter :: list_topics = 'models groups variables results units'
   !> Width of the column of names.
   integer, parameter :: name_width = 40
   !> Who has what no model has for itself.
   character(*), parameter :: everyone = 'all', fits = 'fits'

   !> One of the models.
   type :: model_box_t
      !> The model.
      class(model_t), allocatable :: model
   end type model_box_t

contains

   !> The list of a topic.
   function show_list(models, topic) result(text)
      type(model_box_t), intent(in) :: models(:)
      !> One of `list_topics`.
      character(*), intent(in) :: topic
      character(:), allocatable :: text

      select case (topic)
      case ('models')
         text = show_models(models)//newline//'adfric help NAME shows the groups, variables and results of a model.'//newline
      case ('groups')
         text = show_groups(models)//newline//'adfric help NAME shows the variables of a group.'//newline
      case ('variables')
         text = show_variables(models)//newline//'adfric help NAME says what a variable is, and what it may be.'//newline
      case ('results')
         text = show_results(models)//newline//'adfric help NAME says what a result is.'//newline
      case default
         text = show_units(models)
      end select
   end function show_list

   !> Models, a line each.
   function show_models(models) result(text)
      type(model_box_t), intent(in) :: models(:)
      character(:), allocatable :: text
      integer :: i

      text = 'Models'//newline
      do i = 1, size(models)
         text = text//pad('  '//models(i)%model%name, 20)//models(i)%model%summary//newline
      end do
   end function show_models

   !> Groups, with the models that have them.
   function show_groups(models) result(text)
      type(model_box_t), intent(in) :: models(:)
      character(:), allocatable :: text
      type(entries_t) :: entries
      integer :: i, k

      do k = 1, count_words(common_groups)
         call entries%add('&'//get_word(common_groups, k), everyone)
      end do
      do k = 1, count_words(fit_groups)
         call entries%add('&'//get_word(fit_groups, k), fits)
      end do
      do i = 1, size(models)
         do k = 1, size(models(i)%model%variables)
            call entries%add('&'//models(i)%model%variables(k)%group, models(i)%model%name)
         end do
      end do
      text = 'Groups'//newline//entries%show_table(20, .false.)
   end function show_groups

   !> Variables with their groups and units, and the models that have them.
   function show_variables(models) result(text)
      type(model_box_t), intent(in) :: models(:)
      character(:), allocatable :: text
      type(entries_t) :: entries
      type(variable_t), allocatable :: rows(:)
      integer :: i, k

      allocate (rows, source=get_fit_rows())
      do k = 1, size(rows)
         call entries%add(pad(with_unit(rows(k)%name, rows(k)%unit), name_width - 2)//'&'//rows(k)%group, fits)
      end do
      do i = 1, size(models)
         do k = 1, size(models(i)%model%variables)
            associate (variable => models(i)%model%variables(k))
               call entries%add(pad(with_unit(variable%name, variable%unit), name_width - 2)//'&'//variable%group, &
                  models(i)%model%name)
            end associate
         end do
      end do
      text = 'Variables'//newline//entries%show_table(name_width + 14, .true.)
   end function show_variables

   !> Results and profiles with their units, and the models that have them.
   function show_results(models) result(text)
      type(model_box_t), intent(in) :: models(:)
      character(:), allocatable :: text
      type(result_t), allocatable :: common(:)
      type(entries_t) :: results, profiles
      integer :: i, k

      common = common_results()
      do k = 1, size(common)
         call results%add(with_unit(common(k)%name, common(k)%unit), everyone)
      end do
      do i = 1, size(models)
         associate (model => models(i)%model)
            do k = 1, size(model%results)
               call results%add(with_unit(model%results(k)%name, model%results(k)%unit), model%name)
            end do
            do k = 1, size(model%profiles)
               call profiles%add(with_unit(model%profiles(k)%name, model%profiles(k)%unit), model%name)
            end do
         end associate
      end do
      text = 'Results'//newline//results%show_table(name_width, .true.)//'Profiles'//newline &
         //profiles%show_table(name_width, .true.)
   end function show_results

   !> Units, with the names that scenes have for what is given in them.
   function show_units(models) result(text)
      type(model_box_t), intent(in) :: models(:)
      character(:), allocatable :: text, name, unit
      type(entries_t) :: entries
      integer :: i, k

      name = ''
      unit = ''
      do i = 1, size(models)
         associate (model => models(i)%model)
            do k = 1, size(model%variables)
               name = likely_name_of(model%name, model%variables(k)%group//'%'//model%variables(k)%name)
               call add_units(entries, likely_unit_of(name, model%variables(k)%unit), name(index(name, '%') + 1:))
            end do
            do k = 1, size(model%results)
               unit = model%results(k)%unit
               if (is_counted_over_area(model%name, model%results(k)%name)) unit = unit_over_area(unit)
               call add_units(entries, unit, likely_result_of(model%name, model%results(k)%name))
            end do
            do k = 1, size(model%profiles)
               call entries%add(model%profiles(k)%unit, model%profiles(k)%name)
            end do
         end associate
      end do
      text = 'SI units in inputs and results; - is a pure number.'//newline//newline &
         //'Units'//newline//entries%show_table(12, .true.)
   end function show_units

   !> The units that a variable or a result may have, such as `N; N/m for wave_2d`.
   pure subroutine add_units(entries, units, name)
      !> Entries by unit; receives the variable for each unit that it may have.
      type(entries_t), intent(inout) :: entries
      !> Units with the case that each is for, separated by a semicolon; empty if the variable has none.
      character(*), intent(in) :: units
      !> Name of the variable or result.
      character(*), intent(in) :: name
      integer :: first, last

      first = 1
      do while (first <= len_trim(units))
         last = index(units(first:)//';', ';') + first - 2
         call entries%add(unit_alone(units(first:last)), name)
         first = last + 2
      end do
   end subroutine add_units

   !> The units that a result has with one solver or another, in brackets, such as [N or N/m].
   function units_of_result(models, wanted) result(units)
      !> All models.
      type(model_box_t), intent(in) :: models(:)
      !> Name of the result in the language of scenes.
      character(*), intent(in) :: wanted
      character(:), allocatable :: units, given, unit, old_names
      integer :: m, i, first, last

      units = ''
      given = ''
      old_names = renamed_to(wanted)
      do m = 1, size(models)
         do i = 1, size(models(m)%model%results)
            associate (row => models(m)%model%results(i))
               if (.not. may_become(row%name, row%name, wanted, old_names)) cycle
               if (likely_result_of(models(m)%model%name, row%name) /= wanted) cycle
               given = row%unit
            end associate
            first = 1
            do while (first <= len(given))
               last = index(given(first:)//';', ';') + first - 2
               unit = unit_alone(given(first:last))
               if (index(' or '//units//' or ', ' or '//unit//' or ') == 0) units = units//' or '//unit
               first = last + 2
            end do
         end do
      end do
      ! without the first ` or `
      units = ' ['//units(min(5, len(units) + 1):)//']'
   end function units_of_result

   !> A unit without the case that it is for.
   pure function unit_alone(text) result(unit)
      !> A unit, with ` for ` and a case behind it or without.
      character(*), intent(in) :: text
      character(:), allocatable :: unit

      unit = trim(adjustl(text))
      unit = trim(unit(:index(unit//' for ', ' for ') - 1))
   end function unit_alone

   !> A name with its unit in brackets.
   pure function with_unit(name, unit) result(text)
      !> Name of a variable, a result or a profile.
      character(*), intent(in) :: name
      !> Its unit; empty if it has none.
      character(*), intent(in) :: unit
      character(:), allocatable :: text

      text = name
      if (len_trim(unit) > 0) text = text//' ['//unit//']'
   end function with_unit

end module adfric_command_help_lists
