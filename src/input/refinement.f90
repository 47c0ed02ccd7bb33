! SPDX-License-Identifier: GPL-3.0-or-later
!> `&refine`: where a sweep gets more values than it begins with.
module adfric_input_refinement
   use adfric_base_kinds, only: dp, i8
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: join_words, show_count, show_number, show_text
   use adfric_base_words, only: has_word
   use adfric_input_group_values, only: take_choice, take_count, take_number, take_text, take_variable
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_number_list, only: most_values
   use adfric_input_suggestion, only: did_you_mean
   use adfric_input_sweep_size, only: say_above_limit
   use adfric_input_vocabulary, only: refine_names, report_unknown_names
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: kind_integer
   use adfric_run_plan, only: axis_t
   use adfric_run_refinement, only: refinement_t
   implicit none (type, external)
   private
   public :: read_refinement

   !> Bounds of the tolerance and of the resolution. Below the first one values of a sweep can hardly be told apart.
   real(dp), parameter :: least_tolerance = 1.0e-12_dp, least_resolution = 1.0e-6_dp

contains

   !> Read the refinement of a run, if there is one.
   subroutine read_refinement(file, model, axes, refinement, problems)
      type(namelist_file_t), intent(in) :: file
      !> The model, whose table says which variables and results it has.
      class(model_t), intent(in) :: model
      type(axis_t), intent(in) :: axes(:)
      type(refinement_t), intent(out) :: refinement
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: name
      integer :: group, variable, n_before

      group = file%find_group('refine')
      if (group == 0) return
      n_before = problems%count()
      call report_unknown_names(file, group, refine_names, problems)
      call take_variable(file, group, model, name, variable, problems)
      call read_result(file, group, model, refinement%result, problems)
      call read_share(file, group, 'tolerance', least_tolerance, refinement%tolerance, problems)
      call read_share(file, group, 'resolution', least_resolution, refinement%resolution, problems)
      call take_count(file, group, 'limit', 3, most_values, refinement%limit, problems)
      if (.not. file%groups(group)%is_garbled .and. file%find_assignment(group, 'tolerance') == 0) &
         call file%report_variable(problems, group, 'tolerance', 'not given, needed: the width to which a jump is known, in '// &
         'units of the sweep')
      if (problems%count() > n_before .or. variable == 0) return
      call check_axes(file, group, model, axes, variable, refinement%limit, problems)
      if (problems%count() == n_before) call find_spacing(file, variable, model, refinement%is_logarithmic)
   end subroutine read_refinement

   !> Read the name of the result.
   subroutine read_result(file, group, model, index, problems)
      type(namelist_file_t), intent(in) :: file
      !> Number of `&refine` in the file, from 1.
      integer, intent(in) :: group
      !> The model, whose table says which results it has.
      class(model_t), intent(in) :: model
      !> Receives the index of the result in the table; 0 if there is none.
      integer, intent(out) :: index
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: name, known
      integer :: n_before, i

      index = 0
      name = ''
      n_before = problems%count()
      call take_text(file, group, 'result', 'the name of a result of the model', name, problems)
      if (problems%count() > n_before .or. file%groups(group)%is_garbled) return
      known = ''
      do i = 1, size(model%results)
         if (model%results(i)%is_hidden) cycle
         known = trim(adjustl(known//' '//model%results(i)%name))
         if (model%results(i)%name == name .and. len(name) > 0) index = i
      end do
      if (index > 0) return
      if (file%find_assignment(group, 'result') == 0) then
         call file%report_variable(problems, group, 'result', 'not given, needed: one of '//join_words(known, ', '))
      else
         call file%report_variable(problems, group, 'result', 'unknown result, given '''//show_text(name)//''', allowed: '// &
            join_words(known, ', ')//did_you_mean(name, known))
      end if
   end subroutine read_result

   !> Read a number below 1.
   subroutine read_share(file, group, name, least, value, problems)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: group
      character(*), intent(in) :: name
      !> Least value that is allowed.
      real(dp), intent(in) :: least
      !> Receives the number; left as it is if it is not given.
      real(dp), intent(inout) :: value
      type(problems_t), intent(inout) :: problems
      integer :: n_before

      n_before = problems%count()
      call take_number(file, group, name, value, problems)
      if (file%find_assignment(group, name) == 0 .or. problems%count() > n_before) return
      if (value < least .or. value >= 1) call file%report_variable(problems, group, name, 'out of range, given '// &
         show_number(value)//', allowed: a number >= '//show_number(least)//' and < 1')
   end subroutine read_share

   !> The run has one sweep, of the variable, whose values rise or fall.
   subroutine check_axes(file, group, model, axes, variable, limit, problems)
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: group
      class(model_t), intent(in) :: model
      type(axis_t), intent(in) :: axes(:)
      !> Index of the variable in the model's table, from 1.
      integer, intent(in) :: variable
      !> Values that the refined sweep may have.
      integer(i8), intent(in) :: limit
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: flaw
      integer :: n

      flaw = ''
      if (size(axes) /= 1) then
         flaw = 'a refined run has one sweep, given '//show_count(size(axes))//', allowed: a run for each value of the others'
      else if (allocated(axes(1)%name) .or. size(axes(1)%variables) > 1) then
         flaw = 'several variables change together, allowed: a &sweep of one variable'
      else if (axes(1)%variables(1) /= variable) then
         flaw = 'it is not swept, given '''//model%variables(variable)%name//''', allowed: '''// &
            model%variables(axes(1)%variables(1))%name//''''
      else if (model%variables(variable)%kind == kind_integer .or. model%variables(variable)%has_steps) then
         flaw = 'an integer cannot be refined, given '''//model%variables(variable)%name//''''
      else
         associate (x => axes(1)%values(1, :))
            n = size(x)
            if (n < 3) then
               flaw = 'the sweep has too few values to begin with, given '//show_count(n)//', allowed: 3 or more'
            else if (.not. (all(x(2:) > x(:n - 1)) .or. all(x(2:) < x(:n - 1)))) then
               flaw = 'the values of the sweep neither rise nor fall, allowed: an order'
            end if
         end associate
      end if
      if (len(flaw) > 0) then
         call file%report_variable(problems, group, 'variable', flaw)
      else if (n > limit) then
         call file%report_variable(problems, group, 'limit', say_above_limit(int(n, i8), limit))
      end if
   end subroutine check_axes

   !> Is the sweep of the variable a logarithmic one?
   subroutine find_spacing(file, variable, model, is_logarithmic)
      !> The input, cut into groups and assignments, in which nothing is wrong with the sweep.
      type(namelist_file_t), intent(in) :: file
      integer, intent(in) :: variable
      class(model_t), intent(in) :: model
      !> Receives the answer; a list of values is taken for a linear one.
      logical, intent(out) :: is_logarithmic
      type(problems_t) :: unused
      character(:), allocatable :: name, spacing
      integer :: i, index

      is_logarithmic = .false.
      do i = 1, size(file%groups)
         if (file%groups(i)%name /= 'sweep') cycle
         spacing = 'linear'
         call take_variable(file, i, model, name, index, unused)
         call take_choice(file, i, 'spacing', 'linear log', spacing, unused)
         if (index == variable .and. has_word('log', spacing)) is_logarithmic = .true.
      end do
   end subroutine find_spacing

end module adfric_input_refinement
