! SPDX-License-Identifier: GPL-3.0-or-later
!> `&refine`: where a sweep gets more values than it begins with.
module adfric_input_refinement
   use adfric_base_kinds, only: dp, i8
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: join_words, show_count, show_number, show_text
   use adfric_base_words, only: has_word
   use adfric_input_group_values, only: take_choice, take_count, take_number, take_text, take_variable
   use adfric_input_number_list, only: most_values
   use adfric_input_reading, only: reading_t
   use adfric_input_suggestion, only: did_you_mean
   use adfric_input_sweep_size, only: say_above_limit
   use adfric_input_vocabulary, only: refine_names, report_unknown_names
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
   subroutine read_refinement(r, axes, refinement)
      type(reading_t), intent(in) :: r
      type(axis_t), intent(in) :: axes(:)
      type(refinement_t), intent(out) :: refinement
      character(:), allocatable :: name
      integer :: group, variable, n_before

      group = r%file%find_group('refine')
      if (group == 0) return
      n_before = r%problems%count()
      call report_unknown_names(r, group, refine_names)
      call take_variable(r, group, name, variable)
      call read_result(r, group, refinement%result)
      call read_share(r, group, 'tolerance', least_tolerance, refinement%tolerance)
      call read_share(r, group, 'resolution', least_resolution, refinement%resolution)
      call take_count(r, group, 'limit', 3, most_values, refinement%limit)
      if (.not. r%file%groups(group)%is_garbled .and. r%file%find_assignment(group, 'tolerance') == 0) call r%report(group, &
         'tolerance', 'not given, needed: the width to which a jump is known, in '//'units of the sweep')
      if (r%problems%count() > n_before .or. variable == 0) return
      call check_axes(r, group, axes, variable, refinement%limit)
      if (r%problems%count() == n_before) call find_spacing(r, variable, refinement%is_logarithmic)
   end subroutine read_refinement

   !> Read the name of the result.
   subroutine read_result(r, group, index)
      type(reading_t), intent(in) :: r
      !> Number of `&refine` in the file, from 1.
      integer, intent(in) :: group
      !> Receives the index of the result in the table; 0 if there is none.
      integer, intent(out) :: index
      character(:), allocatable :: name, known
      integer :: n_before, i

      index = 0
      name = ''
      n_before = r%problems%count()
      call take_text(r, group, 'result', 'the name of a result of the model', name)
      if (r%problems%count() > n_before .or. r%file%groups(group)%is_garbled) return
      known = ''
      do i = 1, size(r%model%results)
         if (r%model%results(i)%is_hidden) cycle
         known = trim(adjustl(known//' '//r%model%results(i)%name))
         if (r%model%results(i)%name == name .and. len(name) > 0) index = i
      end do
      if (index > 0) return
      if (r%file%find_assignment(group, 'result') == 0) then
         call r%report(group, 'result', 'not given, needed: one of '//join_words(known, ', '))
      else
         call r%report(group, 'result', 'unknown result, given '''//show_text(name)//''', allowed: '//join_words(known, ', ') &
            //did_you_mean(name, known))
      end if
   end subroutine read_result

   !> Read a number below 1.
   subroutine read_share(r, group, name, least, value)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      character(*), intent(in) :: name
      !> Least value that is allowed.
      real(dp), intent(in) :: least
      !> Receives the number; left as it is if it is not given.
      real(dp), intent(inout) :: value
      integer :: n_before

      n_before = r%problems%count()
      call take_number(r, group, name, value)
      if (r%file%find_assignment(group, name) == 0 .or. r%problems%count() > n_before) return
      if (value < least .or. value >= 1) call r%report(group, name, 'out of range, given '//show_number(value) &
         //', allowed: a number >= '//show_number(least)//' and < 1')
   end subroutine read_share

   !> The run has one sweep, of the variable, whose values rise or fall.
   subroutine check_axes(r, group, axes, variable, limit)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      type(axis_t), intent(in) :: axes(:)
      !> Index of the variable in the model's table, from 1.
      integer, intent(in) :: variable
      !> Values that the refined sweep may have.
      integer(i8), intent(in) :: limit
      character(:), allocatable :: flaw
      integer :: n

      flaw = ''
      if (size(axes) /= 1) then
         flaw = 'a refined run has one sweep, given '//show_count(size(axes))//', allowed: a run for each value of the others'
      else if (allocated(axes(1)%name) .or. size(axes(1)%variables) > 1) then
         flaw = 'several variables change together, allowed: a &sweep of one variable'
      else if (axes(1)%variables(1) /= variable) then
         flaw = 'it is not swept, given '''//r%model%variables(variable)%name//''', allowed: ''' &
            //r%model%variables(axes(1)%variables(1))%name//''''
      else if (r%model%variables(variable)%kind == kind_integer .or. r%model%variables(variable)%has_steps) then
         flaw = 'an integer cannot be refined, given '''//r%model%variables(variable)%name//''''
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
         call r%report(group, 'variable', flaw)
      else if (n > limit) then
         call r%report(group, 'limit', say_above_limit(int(n, i8), limit))
      end if
   end subroutine check_axes

   !> Is the sweep of the variable a logarithmic one?
   subroutine find_spacing(r, variable, is_logarithmic)
      !> The input, in which nothing is wrong with the sweep.
      type(reading_t), intent(in) :: r
      integer, intent(in) :: variable
      !> Receives the answer; a list of values is taken for a linear one.
      logical, intent(out) :: is_logarithmic
      type(problems_t), target :: unused
      type(reading_t) :: aside
      character(:), allocatable :: name, spacing
      integer :: i, index

      is_logarithmic = .false.
      aside = r
      aside%problems => unused
      do i = 1, size(r%file%groups)
         if (r%file%groups(i)%name /= 'sweep') cycle
         spacing = 'linear'
         call take_variable(aside, i, name, index)
         call take_choice(aside, i, 'spacing', 'linear log', spacing)
         if (index == variable .and. has_word('log', spacing)) is_logarithmic = .true.
      end do
   end subroutine find_spacing

end module adfric_input_refinement
