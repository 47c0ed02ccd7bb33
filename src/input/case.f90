! SPDX-License-Identifier: GPL-3.0-or-later
!> The case: a value for every variable of the model.
module adfric_input_case
   use adfric_base_text, only: show_text
   use adfric_base_words, only: has_word
   use adfric_input_dataset, only: read_dataset_name
   use adfric_input_given_list, only: is_dataset_name, read_numbers
   use adfric_input_reading, only: case_t, reading_t
   use adfric_input_suggestion, only: find_nearest
   use adfric_input_variable, only: read_variable, describe_allowed
   use adfric_input_vocabulary, only: common_groups, job_names, list_known_groups, output_names, say_unknown_group, &
      say_unknown_variable
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: kind_dataset, variable_t
   use adfric_describe_vocabulary, only: list_groups, list_variables, list_groups_of
   use adfric_run_dataset, only: dataset_t
   implicit none (type, external)
   private
   public :: case_t, new_case, read_groups, mark_meant

contains

   !> A case in which nothing is given, so that every variable has its default value.
   subroutine new_case(self, model)
      !> Receives space for every variable of the model.
      type(case_t), intent(out) :: self
      !> The model, whose table has the default values.
      class(model_t), intent(in) :: model
      integer :: i, n

      n = size(model%variables)
      allocate (self%is_given(n), self%is_swept(n), self%is_broken(n), source=.false.)
      allocate (self%line(n), source=0)
      allocate (self%datasets(n))
      self%values = [(model%variables(i)%default, i=1, n)]
   end subroutine new_case

   !> Read the groups of a model.
   subroutine read_groups(r, common)
      type(reading_t), intent(in) :: r
      !> Names of the groups that the input may have beside those of the model, separated by a blank; not present: those of a run.
      character(*), intent(in), optional :: common
      character(:), allocatable :: groups
      integer :: i

      call new_case(r%input, r%model)
      groups = common_groups
      if (present(common)) groups = common
      call check_group_names(r, groups)
      groups = list_groups(r%model)
      do i = 1, size(r%file%assignments)
         if (r%problems%is_enough()) exit
         associate (assignment => r%file%assignments(i))
            if (r%file%groups(assignment%group)%index > 1) cycle
            if (.not. has_word(groups, r%file%groups(assignment%group)%name)) cycle
            if (r%file%find_assignment(assignment%group, trim(assignment%name)) /= i) cycle
            if (r%file%groups(assignment%group)%name == 'output' .and. has_word(output_names, assignment%name)) cycle
            if (r%file%groups(assignment%group)%name == 'job' .and. has_word(job_names//' solver', assignment%name)) cycle
            if (is_read(r%model, trim(r%file%groups(assignment%group)%name), trim(assignment%name))) cycle
            call read_assignment(r, i)
         end associate
      end do
   end subroutine read_groups

   !> Was a name read when the solver of the scene was chosen? The solver may have it as well.
   pure logical function is_read(model, group, name)
      class(model_t), intent(in) :: model
      character(*), intent(in) :: group, name

      is_read = allocated(model%scene_names)
      if (is_read) is_read = has_word(model%scene_names, group//'%'//name) .and. model%index_of(group, name) == 0
   end function is_read

   !> Report groups that the model does not have, and mark what is behind a group that makes no sense.
   subroutine check_group_names(r, common)
      type(reading_t), intent(in) :: r
      !> Names of the groups that the input may have beside those of the model, separated by a blank.
      character(*), intent(in) :: common
      character(:), allocatable :: known
      integer :: i

      known = list_known_groups(r%model, common)
      do i = 1, size(r%file%groups)
         if (r%problems%is_enough()) exit
         associate (group => r%file%groups(i))
            if (group%is_garbled) call mark_group(r%model, trim(group%name), r%input)
            if (has_word(known, group%name)) cycle
            call r%file%report(r%problems, i, '', say_unknown_group(r%model, trim(group%name), common), group%first)
            call mark_group(r%model, find_nearest(trim(group%name), known), r%input)
         end associate
      end do
   end subroutine check_group_names

   !> Mark the variables of a group.
   subroutine mark_group(model, group, input)
      class(model_t), intent(in) :: model
      !> Name of the group, in small letters; nothing is marked if the model has no such group.
      character(*), intent(in) :: group
      type(case_t), intent(inout) :: input
      integer :: k

      do k = 1, size(model%variables)
         if (model%variables(k)%group == group) input%is_broken(k) = .true.
      end do
   end subroutine mark_group

   !> Read the value of one variable.
   subroutine read_assignment(r, number)
      type(reading_t), intent(in) :: r
      !> Number of the assignment in the file, from 1.
      integer, intent(in) :: number
      character(:), allocatable :: group, name, flaw
      integer :: i, index

      associate (assignment => r%file%assignments(number))
         group = trim(r%file%groups(assignment%group)%name)
         name = trim(assignment%name)
         i = r%model%index_of(group, name)
         if (i == 0) then
            call r%file%report(r%problems, assignment%group, name, say_unknown_variable(r%model, group, name), assignment%first)
            call mark_meant(r%model, group, name, r%input)
            return
         end if
         if (r%model%variables(i)%kind == kind_dataset) then
            call read_data(r%file%value_of(number), r%model%variables(i), r%input%datasets(i), flaw, index)
         else
            call read_variable(r%file%value_of(number), r%model%variables(i), r%input%values(i), flaw, index)
         end if
         r%input%is_given(i) = .true.
         r%input%line(i) = r%file%line_of(assignment%first)
         r%input%is_broken(i) = r%input%is_broken(i) .or. len(flaw) > 0
         if (len(flaw) > 0) call r%file%report(r%problems, assignment%group, name, flaw, assignment%value_first + index - 1)
      end associate
   end subroutine read_assignment

   !> Read the name of a dataset or group, or the numbers of a list.
   subroutine read_data(text, variable, dataset, flaw, index)
      !> Text of the value, as it stands in the input.
      character(*), intent(in) :: text
      type(variable_t), intent(in) :: variable
      !> Receives the name or the numbers; left as it is if something is wrong.
      type(dataset_t), intent(inout) :: dataset
      character(:), allocatable, intent(out) :: flaw
      !> Position in the text of what is wrong, from 1.
      integer, intent(out) :: index

      if (variable%is_list .and. .not. is_dataset_name(text)) then
         call read_numbers(text, variable, dataset, flaw, index)
      else
         call read_dataset_name(text, variable%n_columns() > 0, dataset, flaw, index)
         if (len(flaw) == 0 .and. variable%n_columns() > 0) then
            if (dataset%is_column .and. len(dataset%path) > 0) &
               flaw = 'names a column, a group or a whole table is needed, given '''//show_text(dataset%text)//''''
         end if
         if (len(flaw) > 0) flaw = flaw//', allowed: '//describe_allowed(variable)
      end if
   end subroutine read_data

   !> Mark the variables that an unknown name probably means: their absence needs no report of its own.
   subroutine mark_meant(model, group, name, input)
      class(model_t), intent(in) :: model
      !> Name of the group where the name stands; empty where the name may be of any group.
      character(*), intent(in) :: group
      !> The unknown name, in small letters.
      character(*), intent(in) :: name
      type(case_t), intent(inout) :: input
      character(:), allocatable :: meant
      integer :: k

      meant = name
      if (len(list_groups_of(model, name)) == 0) meant = find_nearest(name, list_variables(model, group))
      if (len(meant) == 0) meant = find_nearest(name, list_variables(model, ''))
      do k = 1, size(model%variables)
         if (model%variables(k)%name == meant) input%is_broken(k) = .true.
      end do
   end subroutine mark_meant

end module adfric_input_case
