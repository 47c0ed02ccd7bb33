! SPDX-License-Identifier: GPL-3.0-or-later
!> What the model says of the values together: asked at the first point and at the ends of each sweep.
module adfric_input_consistency
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problem_t, problems_t
   use adfric_base_text, only: is_name_character
   use adfric_base_words, only: has_word
   use adfric_input_case, only: case_t
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_reading, only: reading_t
   use adfric_input_variable, only: show_value
   use adfric_describe_model, only: model_t
   use adfric_describe_scene_messages, only: say_as_scene
   use adfric_describe_scene_rules, only: hidden
   use adfric_describe_table, only: variable_t
   use adfric_run_plan, only: axis_t
   implicit none (type, external)
   private
   public :: check_consistency

contains

   !> Let the model check the values.
   subroutine check_consistency(r, axes)
      !> The input and its case.
      type(reading_t), intent(in) :: r
      !> The swept variables with their values.
      type(axis_t), intent(in) :: axes(:)
      integer :: j, k

      call check_point(r, r%input%values, '')
      do k = 1, size(axes)
         do j = 1, size(axes(k)%variables)
            call check_end(r, axes(k), j, minloc(axes(k)%values(j, :), dim=1))
            call check_end(r, axes(k), j, maxloc(axes(k)%values(j, :), dim=1))
         end do
      end do
   end subroutine check_consistency

   !> Check where one swept variable takes its least or greatest value, unless that is the first one.
   subroutine check_end(r, axis, position, number)
      type(reading_t), intent(in) :: r
      type(axis_t), intent(in) :: axis
      !> Index of the variable among those of the axis, from 1.
      integer, intent(in) :: position
      !> Which value of the axis is looked at, from 1; nothing is done at the first one.
      integer, intent(in) :: number
      real(dp) :: values(size(r%input%values))

      if (number == 1) return
      values = r%input%values
      values(axis%variables) = axis%values(:, number)
      associate (variable => r%model%variables(axis%variables(position)))
         call check_point(r, values, ' (at '//variable%name//' = '//show_value(axis%values(position, number), variable)//')')
      end associate
   end subroutine check_end

   !> Check one point.
   subroutine check_point(r, values, point)
      type(reading_t), intent(in) :: r
      !> Values of all variables at the point; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> What to add to a problem to say at which point it is met; empty for the first point.
      character(*), intent(in) :: point
      type(problems_t) :: found
      integer :: i, n_before

      call r%model%check_values(values, r%input%is_swept, found)
      call say_as_scene(r%model, found)
      n_before = r%problems%count()
      do i = 1, found%count()
         associate (item => found%items(i))
            if (is_consequence(item, r%model, r%input)) cycle
            if (is_known(item, r%problems, n_before, len(point) > 0)) cycle
            call r%problems%add(item%group, item%variable, item%text//point, item%index, line_of_variable(item, r%file, r%model, &
               r%input))
         end associate
      end do
   end subroutine check_point

   !> Is the problem only that a variable has no value since something was wrong with it?
   pure logical function is_consequence(item, model, input)
      type(problem_t), intent(in) :: item
      class(model_t), intent(in) :: model
      type(case_t), intent(in) :: input
      integer :: i

      is_consequence = .true.
      do i = 1, size(model%variables)
         if (.not. input%is_broken(i)) cycle
         if (item%variable == model%variables(i)%name .and. item%group == model%variables(i)%group) return
         if (mentions(item%text, model%variables(i)%name)) return
         if (follows_from_dataset(item, model%variables(i))) return
         ! the solver has taken the scene for another one
         if (item%group == hidden .or. mentions(item%text, 'without &'//model%variables(i)%group)) return
      end do
      is_consequence = .false.
   end function is_consequence

   !> Is a length missing that may stand in the attributes of a dataset, such as dx of heights?
   pure logical function follows_from_dataset(item, variable)
      type(problem_t), intent(in) :: item
      !> A variable whose value could not be read.
      type(variable_t), intent(in) :: variable
      character(*), parameter :: lengths = 'length_x length_y'

      follows_from_dataset = .false.
      if (.not. allocated(variable%attributes)) return
      if (.not. has_word(variable%attributes, 'dx')) return
      follows_from_dataset = item%group == variable%group .and. has_word(lengths, item%variable) &
         & .and. index(item%text, 'is missing') == 1
   end function follows_from_dataset

   !> Does a name stand in a text as a word?
   pure logical function mentions(text, name)
      !> Text of a problem.
      character(*), intent(in) :: text
      !> Name of a variable, not empty.
      character(*), intent(in) :: name
      character(:), allocatable :: padded
      integer :: first, step

      mentions = .true.
      padded = ' '//text//' '
      first = 1
      do
         step = index(padded(first + 1:), name)
         if (step == 0) exit
         first = first + step
         if (is_name_character(padded(first - 1:first - 1))) cycle
         if (.not. is_name_character(padded(first + len(name):first + len(name)))) return
      end do
      mentions = .false.
   end function mentions

   !> Has the same been said before? At the ends of a sweep, has anything been said of the variable?
   pure logical function is_known(item, problems, n_before, is_end)
      type(problem_t), intent(in) :: item
      type(problems_t), intent(in) :: problems
      !> Number of problems that had been reported before this point.
      integer, intent(in) :: n_before
      !> Is the point at the end of a sweep, instead of the first one of the run?
      logical, intent(in) :: is_end
      integer :: i

      is_known = .true.
      do i = 1, problems%count()
         associate (old => problems%items(i))
            if (old%group /= item%group .or. old%variable /= item%variable) cycle
            if (old%text == item%text) return
            if (is_end .and. i <= n_before .and. len(item%variable) > 0) return
            if (index(old%text, item%text//' (at ') == 1) return
         end associate
      end do
      is_known = .false.
   end function is_known

   !> Line of the variable that a problem names, else of its group; 0 if neither stands in the file.
   pure integer function line_of_variable(item, file, model, input)
      type(problem_t), intent(in) :: item
      type(namelist_file_t), intent(in) :: file
      class(model_t), intent(in) :: model
      !> Says in which lines variables are given or swept.
      type(case_t), intent(in) :: input
      integer :: i, group

      line_of_variable = item%line
      if (line_of_variable > 0) return
      i = model%index_of(item%group, item%variable)
      if (i > 0) line_of_variable = input%line(i)
      if (line_of_variable > 0) return
      group = file%find_group(item%group)
      if (group > 0) line_of_variable = file%line_of(file%groups(group)%first)
   end function line_of_variable

end module adfric_input_consistency
