! SPDX-License-Identifier: GPL-3.0-or-later
!> What `adfric check` says of a fit beside what it says of every input: the points, what is free, and where the search starts.
module adfric_command_fit_check
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp, i8
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_text, only: newline, show_count, show_number
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: get_word, pad
   use adfric_command_fit_doubts, only: describe_fit_doubts
   use adfric_command_rounding, only: show_to_digits
   use adfric_fit_base_line, only: mark_base_lines
   use adfric_fit_parts, only: has_others, number_curves
   use adfric_fit_problem, only: data_set_t, event_names, fit_t, interval_names, loss_gauss, loss_names, nuisance_names, &
      & n_nuisances, nuisance_lateral_gain, nuisance_spring_stiffness
   use adfric_fit_solution, only: solution_t, fit_solved
   use adfric_fit_solve, only: find_start
   use adfric_fit_stack_model, only: stack_model_t
   use adfric_input_fit, only: fit_input_t
   use adfric_input_fit_points, only: point_counts_t
   use adfric_round_timed_history, only: doubt_turns
   implicit none (type, external)
   private
   public :: describe_fit

   !> Width of the column of names.
   integer, parameter :: name_width = 28

contains

   !> All that there is to say.
   function describe_fit(model, details) result(text)
      class(stack_model_t), intent(in) :: model
      type(fit_input_t), intent(in) :: details
      character(:), allocatable :: text

      text = data_lines(model, details)//event_lines(model%fit)//free_lines(model)//setting_lines(model%fit)
      text = text//start_lines(model)
   end function describe_fit

   !> The points of each `&data`.
   function data_lines(model, details) result(lines)
      class(stack_model_t), intent(in) :: model
      type(fit_input_t), intent(in) :: details
      character(:), allocatable :: lines
      integer :: g

      lines = ''
      do g = 1, size(details%groups)
         associate (group => details%groups(g), set => details%groups(g)%data_set)
            lines = lines//pad('data['//show_count(g)//']', name_width)//model%fit%model%results(set%ordinate)%name//' against '// &
               model%fit%model%variables(set%abscissa)%name//newline
            lines = lines//pad('', name_width)//describe_points(details%loaded%counts(g), group%x_unit, group%y_unit)//newline
            lines = lines//other_lines(model%fit, model%fit%data_sets(g))
            lines = lines//pad('', name_width)//describe_errors(model, details, g)//newline
            lines = lines//nuisance_line(set)//noise_line(model%fit, model%fit%data_sets(g))
         end associate
      end do
   end function data_lines

   !> A line where the history of the points has noise that nothing smooths.
   function noise_line(fit, set) result(line)
      type(fit_t), intent(in) :: fit
      type(data_set_t), intent(in) :: set
      character(:), allocatable :: line
      integer, allocatable :: curves(:)
      integer :: smoothing, k

      line = ''
      if (.not. allocated(set%prescribed)) return
      smoothing = fit%model%index_of('history', 'smoothing')
      if (smoothing > 0) then
         if (is_set(fit%base(smoothing))) return
      end if
      curves = number_curves(set)
      do k = 1, maxval(curves)
         line = doubt_turns(pack(set%prescribed, curves == k))
         if (len(line) > 0) line = 'warning: '//line
         if (len(line) > 0) return
      end do
   end function noise_line

   !> The further variables of the points, and how many curves these are.
   function other_lines(fit, set) result(lines)
      type(fit_t), intent(in) :: fit
      !> The points of a `&data`.
      type(data_set_t), intent(in) :: set
      character(:), allocatable :: lines
      logical, allocatable :: is_used(:)
      integer :: k

      lines = ''
      ! points of a stack are read one curve after the other
      if (.not. has_others(set)) return
      allocate (is_used(size(set%x)))
      is_used(:) = number_curves(set) > 0
      do k = 1, size(set%others)
         lines = lines//pad('', name_width)//fit%model%variables(set%others(k))%name//' of each point, '// &
            show_to_digits(minval(set%at(k, :), is_used), 5)//' to '//show_to_digits(maxval(set%at(k, :), is_used), 5)// &
            show_unit(fit%model%unit_of(fit%base, set%others(k)))//newline
      end do
      lines = lines//pad('', name_width)//show_count(maxval(number_curves(set)))//' curves'//newline
   end function other_lines

   !> The counts of points in words.
   pure function describe_points(counts, x_unit, y_unit) result(text)
      type(point_counts_t), intent(in) :: counts
      !> SI units of abscissa and ordinate.
      character(*), intent(in) :: x_unit, y_unit
      character(:), allocatable :: text

      text = show_count(counts%n_used)//' of '//show_count(counts%n)//' points'
      if (counts%n_without > 0) text = text//', '//show_count(counts%n_without)//' without a number'
      if (counts%n_outside > 0) text = text//', '//show_count(counts%n_outside)//' left out'
      if (counts%n_free > 0) text = text//', '//show_count(counts%n_used - counts%n_free)//' in contact, '// &
         show_count(counts%n_free)//' free'
      if (counts%n_used == 0) return
      text = text//', '//show_to_digits(counts%x(1), 4)//' to '//show_to_digits(counts%x(2), 4)//show_unit(x_unit)//', '// &
         show_to_digits(counts%y(1), 4)//' to '//show_to_digits(counts%y(2), 4)//show_unit(y_unit)
   end function describe_points

   !> A unit as it stands behind a number; nothing for a pure number.
   pure function show_unit(unit) result(text)
      !> A unit; `-` for a pure number.
      character(*), intent(in) :: unit
      character(:), allocatable :: text

      text = ''
      if (unit /= '-') text = ' '//unit
   end function show_unit

   !> Which standard errors the points of a `&data` have, and what a residual costs.
   function describe_errors(model, details, g) result(text)
      class(stack_model_t), intent(in) :: model
      type(fit_input_t), intent(in) :: details
      integer, intent(in) :: g
      character(:), allocatable :: text

      associate (group => details%groups(g), set => model%fit%data_sets(g))
         if (is_set(group%sigma)) then
            text = 'standard error '//show_number(group%sigma)//show_unit(group%y_unit)
         else if (is_set(group%relative_sigma)) then
            text = 'standard error '//show_number(group%relative_sigma)//' of each ordinate'
         else if (details%loaded%has_sigma(g)) then
            text = 'a standard error for each point'
         else
            text = 'standard error not known, one for all points'
         end if
         if (is_set(group%abscissa_sigma)) then
            text = text//', of the abscissa '//show_number(group%abscissa_sigma)//show_unit(group%x_unit)
         else if (allocated(set%x_sigma) .or. allocated(group%abscissa_sigma_column)) then
            text = text//', of the abscissa for each point'
         end if
         if (set%loss /= loss_gauss) text = text//', loss '//get_word(loss_names, set%loss)
      end associate
   end function describe_errors

   !> Nuisances that are not what they are by default.
   pure function nuisance_line(set) result(line)
      !> What the points of a `&data` are.
      type(data_set_t), intent(in) :: set
      character(:), allocatable :: line
      real(dp) :: usual
      integer :: k

      line = ''
      do k = 1, n_nuisances
         if (.not. is_set(set%nuisance(k))) cycle
         usual = 0
         if (k == nuisance_lateral_gain) usual = 1
         if (.not. abs(set%nuisance(k) - usual) > 0 .and. k /= nuisance_spring_stiffness) cycle
         if (len(line) > 0) line = line//', '
         line = line//get_word(nuisance_names, k)//' '//show_number(set%nuisance(k))
      end do
      if (len(line) > 0) line = pad('', name_width)//line//newline
   end function nuisance_line

   !> The events.
   pure function event_lines(fit) result(lines)
      type(fit_t), intent(in) :: fit
      character(:), allocatable :: lines
      integer :: i

      lines = ''
      do i = 1, size(fit%events)
         lines = lines//pad('event', name_width)//get_word(event_names, fit%events(i)%kind)//' '// &
            show_number(fit%events(i)%value)//' +- '//show_number(fit%events(i)%sigma)//newline
      end do
   end function event_lines

   !> What is free, and between which bounds.
   function free_lines(model) result(lines)
      class(stack_model_t), intent(in) :: model
      character(:), allocatable :: lines
      integer :: i

      lines = ''
      do i = 1, size(model%fit%frees)
         associate (free => model%fit%frees(i))
            lines = lines//pad('free '//free%name, name_width)//'['//free%unit//'] '//trim(merge('log   ', 'linear', free%is_log))
            if (is_set(free%start)) lines = lines//', start '//show_number(free%start)
            if (is_set(free%minimum)) lines = lines//', from '//show_number(free%minimum)
            if (is_set(free%maximum)) lines = lines//', to '//show_number(free%maximum)
            if (is_set(free%prior)) lines = lines//', prior '//show_number(free%prior)//' +- '//show_number(free%prior_sigma)// &
               trim(merge(' (relative)', '           ', free%is_log))
            lines = lines//newline
         end associate
      end do
   end function free_lines

   !> How the fit is made.
   pure function setting_lines(fit) result(lines)
      type(fit_t), intent(in) :: fit
      character(:), allocatable :: lines
      integer :: k

      lines = pad('intervals', name_width)//get_word(interval_names, fit%intervals)//', levels'
      do k = 1, size(fit%levels)
         lines = lines//' '//show_number(fit%levels(k))
      end do
      lines = lines//newline
   end function setting_lines

   !> Where the search starts, of the first curve of a stack, and what may not be meant there.
   function start_lines(model) result(lines)
      class(stack_model_t), intent(in) :: model
      character(:), allocatable :: lines
      type(fit_t) :: fit
      type(solution_t) :: solution
      type(data_set_t), allocatable :: curves(:, :)
      real(dp) :: chi2
      character(:), allocatable :: reason, name
      integer :: i
      logical :: is_read

      fit = model%fit
      lines = ''
      if (.not. model%is_single()) then
         allocate (curves(size(fit%data_sets), 1))
         curves(:, 1) = fit%data_sets
         call model%source%get_curves(1_i8, curves, is_read)
         if (.not. is_read) return
         fit%data_sets = curves(:, 1)
      end if
      call mark_base_lines(fit)
      do i = 1, size(fit%data_sets)
         if (allocated(model%fit%data_sets(i)%is_contact) .or. .not. allocated(fit%data_sets(i)%is_contact)) cycle
         lines = lines//pad('base line', name_width)//show_count(count(.not. fit%data_sets(i)%is_contact))// &
            ' points of data['//show_count(i)//'], found from the jump of the load'//newline
      end do
      call find_start(fit, solution%estimate, chi2, solution%measures, reason)
      if (len(reason) > 0) then
         lines = lines//pad('start', name_width)//'none: '//reason//newline
         return
      end if
      name = 'start'
      if (.not. model%is_single()) name = 'start of the first curve'
      do i = 1, size(fit%frees)
         if (i > 1) name = ''
         lines = lines//pad(name, name_width)//fit%frees(i)%name//' = '//show_to_digits(solution%estimate(i), 4)// &
            show_unit(fit%frees(i)%unit)//newline
      end do
      lines = lines//pad('S at the start', name_width)
      if (ieee_is_finite(chi2)) then
         lines = lines//show_to_digits(chi2, 4)//newline
      else
         lines = lines//'none, the model has no value at some point'//newline
         return
      end if
      solution%status = fit_solved
      solution%chi2 = chi2
      solution%lag_correlation = not_a_number()
      solution%runs_p_value = not_a_number()
      lines = lines//describe_fit_doubts(fit, solution)
   end function start_lines

end module adfric_command_fit_check
