!> The names that an input may use, and what to say of a name that is not among them.
module adfric_input_vocabulary
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: join_words
   use adfric_base_words, only: has_word
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_suggestion, only: find_nearest, did_you_mean
   use adfric_model_model, only: model_t
   use adfric_model_vocabulary, only: list_groups, list_variables, list_groups_of
   implicit none (type, external)
   private
   public :: job_names, sweep_names
   public :: say_unknown_group, say_unknown_variable, report_unknown_names

   !> Variables of `&job`.
   character(*), parameter :: job_names = 'model title output'
   !> Variables of `&sweep`.
   character(*), parameter :: sweep_names = 'variable from to count spacing values'

contains

   !> What to say of a group that a model does not have.
   pure function say_unknown_group(model, group) result(text)
      !> The model, whose table names groups and variables.
      class(model_t), intent(in) :: model
      !> The unknown name, in small letters and without `&`.
      character(*), intent(in) :: group
      character(:), allocatable :: text
      character(:), allocatable :: known

      known = 'job sweep '//list_groups(model)
      text = 'unknown group for the model '''//model%name//''', allowed: &'//join_words(known, ', &')
      if (len(find_nearest(group, known)) > 0) text = text//'; did you mean &'//find_nearest(group, known)//'?'
   end function say_unknown_group

   !> What to say of a variable that a group does not have; the model may have it elsewhere.
   pure function say_unknown_variable(model, group, name) result(text)
      !> The model, whose table names groups and variables.
      class(model_t), intent(in) :: model
      !> Name of the group where the name stands.
      character(*), intent(in) :: group
      !> The unknown name, in small letters.
      character(*), intent(in) :: name
      character(:), allocatable :: text
      character(:), allocatable :: home, near

      home = list_groups_of(model, name)
      if (len(home) == 0 .and. has_word(job_names, name)) home = 'job'
      if (len(home) == 0 .and. has_word(sweep_names, name)) home = 'sweep'
      text = 'unknown variable'
      if (len(home) > 0) text = text//', it belongs to &'//join_words(home, ' or &')
      text = text//', allowed: '//join_words(list_variables(model, group), ', ')
      if (len(home) > 0) return
      near = find_nearest(name, list_variables(model, ''))
      if (len(find_nearest(name, list_variables(model, group))) > 0) then
         text = text//did_you_mean(name, list_variables(model, group))
      else if (len(near) > 0) then
         text = text//'; did you mean '''//near//''' of &'//join_words(list_groups_of(model, near), ' or &')//'?'
      end if
   end function say_unknown_variable

   !> What to say of a variable that `&job` or `&sweep` does not have.
   pure function say_unknown_name(known, name) result(text)
      !> Names that the group has, separated by a blank.
      character(*), intent(in) :: known
      !> The unknown name, in small letters.
      character(*), intent(in) :: name
      character(:), allocatable :: text

      text = 'unknown variable, allowed: '//join_words(known, ', ')//did_you_mean(name, known)
   end function say_unknown_name

   !> Report the variables of a group that are not among the known ones.
   subroutine report_unknown_names(file, group, known, problems)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Number of the group in the file, from 1.
      integer, intent(in) :: group
      !> Names that the group has, separated by a blank.
      character(*), intent(in) :: known
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: i

      do i = 1, size(file%assignments)
         if (problems%is_enough()) return
         associate (assignment => file%assignments(i))
            if (assignment%group /= group .or. has_word(known, assignment%name)) cycle
            call file%report(problems, group, trim(assignment%name), say_unknown_name(known, trim(assignment%name)), &
               assignment%first)
         end associate
      end do
   end subroutine report_unknown_names

end module adfric_input_vocabulary
