! SPDX-License-Identifier: GPL-3.0-or-later
!> `adfric check`: read and validate an input, and say what it means.
module adfric_command_check
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_base_words, only: count_words, get_word, pad
   use adfric_base_text, only: newline, show_count, show_number, show_text
   use adfric_command_case, only: open_input, run_or_fit
   use adfric_command_fit_check, only: describe_fit
   use adfric_command_line, only: command_t
   use adfric_command_doubts, only: describe_bounds_of, describe_doubts_of, describe_trials
   use adfric_command_durations, only: show_duration
   use adfric_command_effect, only: has_effect
   use adfric_command_hints, only: hint_of_state
   use adfric_command_outcome, only: outcome_t, exit_success
   use adfric_command_plausibility, only: warn_of_values
   use adfric_command_values, only: show_input_value
   use adfric_fit_stack_model, only: stack_model_t
   use adfric_input_fit, only: fit_input_t
   use adfric_input_run, only: run_input_t
   use adfric_describe_model, only: derived_t, model_t
   use adfric_describe_table, only: kind_dataset
   use adfric_describe_vocabulary, only: list_groups
   use adfric_run_dataset, only: dataset_t
   use adfric_run_plan, only: axis_t
   use adfric_output_resources, only: file_size_of, show_bytes
   use adfric_describe_scene_solvers, only: accuracy_of
   use adfric_run_time_estimate, only: time_estimate_t, estimate_time, longest_trial
   implicit none (type, external)
   private
   public :: check_case

   !> Width of the column of names.
   integer, parameter :: name_width = 28
   !> Width of the column of derived values with their units.
   integer, parameter :: value_width = 26

contains

   !> Carry out the command.
   subroutine check_case(command, outcome)
      !> What the user asks for on the command line.
      type(command_t), intent(in) :: command
      !> Receives what the command has to say, and the exit status.
      type(outcome_t), intent(inout) :: outcome
      type(run_input_t) :: run
      type(fit_input_t), allocatable :: details
      type(time_estimate_t) :: estimate
      character(:), allocatable :: text

      call open_input(command%subject, run_or_fit, run, details, outcome)
      if (command%names_output .and. outcome%exit_status == exit_success) call outcome%say(run%output//newline)
      if (outcome%exit_status /= exit_success .or. command%is_quiet .or. command%names_output) return
      if (len(run%title) > 0) call outcome%say(run%title//newline)
      call outcome%say(describe_model(run%model))
      call outcome%say(describe_values(run)//describe_tables(run%datasets))
      select type (model => run%model)
      type is (stack_model_t)
         call check_fit(model, details, run, outcome)
         return
      end select
      text = describe_derived(run)//run%model%describe_case(run%plan%base)
      if (len(text) > 0) then
         call outcome%say(describe_first_point(run)//text)
         if (text(len(text):) /= newline) call outcome%say(newline)
      end if
      call run%model%prepare()
      call outcome%say(describe_doubts_of(run)//hint_of_state(run))
      call outcome%say(describe_sweep(run))
      call outcome%say(describe_points(run))
      call estimate_time(run, estimate)
      call outcome%say(pad('estimated time', name_width)//describe_time(estimate)//newline)
      call outcome%say(describe_bounds_of(run)//describe_trials(estimate))
      call run%model%release()
      call outcome%say(warn_of_values(run))
      call outcome%say(pad('results file', name_width)//run%output//', ' &
         //show_bytes(file_size_of(run))//newline)
   end subroutine check_case

   !> The model, or the scene with the solver that answers it.
   pure function describe_model(model) result(text)
      class(model_t), intent(in) :: model
      character(:), allocatable :: text

      if (allocated(model%scene)) then
         text = pad('scene', name_width)//model%scene//newline//pad('solver', name_width)//model%name//', '// &
            accuracy_of(model%name)//newline
      else
         text = pad('model', name_width)//model%name//newline
      end if
   end function describe_model

   !> What there is to say of a fit.
   subroutine check_fit(model, details, run, outcome)
      class(stack_model_t), intent(in) :: model
      type(fit_input_t), intent(in) :: details
      type(run_input_t), intent(in) :: run
      type(outcome_t), intent(inout) :: outcome
      type(time_estimate_t) :: estimate

      call outcome%say(describe_fit(model, details))
      if (.not. model%is_single()) call outcome%say(describe_sweep(run))
      call outcome%say(pad('fits', name_width)//show_count(run%plan%n_points())//newline)
      call estimate_time(run, estimate)
      call outcome%say(pad('estimated time', name_width)//describe_time(estimate)//newline)
      call outcome%say(warn_of_values(run))
      call outcome%say(pad('results file', name_width)//run%output//newline)
   end subroutine check_fit

   !> What is done beside the sweeps, and the number of points.
   function describe_points(run) result(lines)
      type(run_input_t), intent(in) :: run
      character(:), allocatable :: lines, text

      lines = ''
      if (run%refinement%is_wanted()) lines = pad('refined', name_width)//run%refinement%describe(run%model)//newline
      text = run%variation%describe(run%model%variables)
      if (len(text) > 0) lines = lines//pad('beside the results', name_width)//text//newline
      lines = lines//pad('points', name_width)//show_count(run%plan%n_points())
      if (run%refinement%is_wanted()) lines = lines//' or more'
      associate (blocks => run%blocks())
         if (blocks%n_blocks_of_run < blocks%n_points_of_run) lines = lines//' in '//show_count(blocks%n_blocks_of_run)// &
            & ' block'//trim(merge(' ', 's', blocks%n_blocks_of_run == 1))//', each for one thread or part of a run'
      end associate
      lines = lines//newline
   end function describe_points

   !> The variables that have one value, group by group, but for defaults without an effect.
   function describe_values(run) result(lines)
      type(run_input_t), intent(in) :: run
      character(:), allocatable :: lines, groups, of_group
      integer :: g, i

      lines = ''
      groups = list_groups(run%model)
      do g = 1, count_words(groups)
         of_group = ''
         do i = 1, size(run%model%variables)
            if (run%model%variables(i)%group /= get_word(groups, g)) cycle
            if (run%plan%is_swept(i) .or. .not. is_set(run%plan%base(i))) cycle
            if (.not. has_effect(run, i)) cycle
            of_group = of_group//describe_value(run, i)
         end do
         if (len(of_group) > 0) lines = lines//'&'//get_word(groups, g)//newline//of_group
      end do
   end function describe_values

   !> A variable that has one value.
   function describe_value(run, at) result(line)
      type(run_input_t), intent(in) :: run
      !> Index of the variable in the table of the model.
      integer, intent(in) :: at
      character(:), allocatable :: line

      associate (variable => run%model%variables(at))
         line = pad('  '//variable%name, name_width)
         if (variable%kind == kind_dataset) then
            line = line//run%datasets(at)%describe()
         else if (variable%zero_is_automatic .and. abs(run%plan%base(at)) < 0.5_dp) then
            line = line//'chosen by the solver'
         else
            line = line//show_input_value(variable, run%plan%base(at))
         end if
         line = line//show_unit(run%model%unit_of(run%plan%base, at))
         if (.not. run%is_given(at)) line = line//' (default)'
         line = line//newline
      end associate
   end function describe_value

   !> How the tables of text were read, each once.
   function describe_tables(datasets) result(lines)
      !> The datasets, some of which are columns of tables.
      type(dataset_t), intent(in) :: datasets(:)
      character(:), allocatable :: lines
      integer :: i, k
      logical :: is_said(size(datasets))

      lines = ''
      is_said = .false.
      do i = 1, size(datasets)
         if (is_said(i) .or. .not. allocated(datasets(i)%form)) cycle
         lines = lines//pad('table', name_width)//datasets(i)%file//': '//datasets(i)%form
         do k = i, size(datasets)
            if (.not. allocated(datasets(k)%form)) cycle
            if (datasets(k)%file /= datasets(i)%file .or. len(datasets(k)%path) == 0) cycle
            lines = lines//trim(merge('; ', ', ', k == i))//' '//show_text(datasets(k)%path)
            if (len(datasets(k)%units) > 0) lines = lines//' in '//show_text(datasets(k)%units)
            is_said(k) = .true.
         end do
         lines = lines//newline
      end do
   end function describe_tables

   !> The point of a sweep that what follows is said of.
   function describe_first_point(run) result(line)
      type(run_input_t), intent(in) :: run
      character(:), allocatable :: line
      integer :: j, k

      line = ''
      do k = 1, size(run%plan%axes)
         do j = 1, size(run%plan%axes(k)%variables)
            associate (position => run%plan%axes(k)%variables(j))
               if (len(line) > 0) line = line//', '
               line = line//run%model%variables(position)%group//'%'//run%model%variables(position)%name//' = ' &
                  //show_number(run%plan%base(position))//show_unit(run%model%unit_of(run%plan%base, position))
            end associate
         end do
      end do
      if (len(line) > 0) line = 'at the first point, '//line//newline
   end function describe_first_point

   !> How long the run will take.
   function describe_time(estimate) result(text)
      type(time_estimate_t), intent(in) :: estimate
      character(:), allocatable :: text

      if (.not. estimate%is_known) then
         text = 'not known, no trial point could be solved'
         return
      end if
      text = show_duration(estimate%seconds)//' on '//show_count(estimate%n_threads)//' thread'
      if (estimate%n_threads > 1) text = text//'s'
      if (.not. estimate%is_complete) then
         ! less than a second is no news of a run that takes longer
         if (index(text, 'less') == 1) then
            text = 'more than '//show_number(longest_trial)//' s, in which no trial point was solved'
         else
            text = 'more than '//text//', a trial point took too long'
         end if
      else if (index(text, 'less') == 1) then
         text = text//', from trial points'
      else
         text = 'about '//text//', from trial points'
      end if
   end function describe_time

   !> What follows from the values.
   function describe_derived(run) result(lines)
      type(run_input_t), intent(in) :: run
      character(:), allocatable :: lines
      type(derived_t), allocatable :: list(:)
      integer :: i

      lines = ''
      allocate (list, source=run%model%get_derived(run%plan%base))
      if (size(list) > 0) lines = 'derived'//newline
      do i = 1, size(list)
         lines = lines//pad(pad('  '//list(i)%name, name_width)//show_number(list(i)%value)//show_unit(list(i)%unit), &
            name_width + value_width)//list(i)%long_name//newline
      end do
   end function describe_derived

   !> The swept variables, the slowest first.
   function describe_sweep(run) result(lines)
      type(run_input_t), intent(in) :: run
      character(:), allocatable :: lines
      integer :: j, k

      lines = ''
      do k = 1, size(run%plan%axes)
         do j = 1, size(run%plan%axes(k)%variables)
            associate (position => run%plan%axes(k)%variables(j), values => run%plan%axes(k)%values(j, :))
               lines = lines//pad('sweep of '//run%model%variables(position)%group//'%'//run%model%variables(position)%name, &
                  & name_width) &
                  //show_count(size(values))//trim(merge(' value ', ' values', size(values) == 1))//', '
               if (is_sample(run%plan%axes(k))) then
                  lines = lines//show_number(minval(values))//' to '//show_number(maxval(values))
               else
                  lines = lines//show_number(values(1))
                  if (size(values) > 1) lines = lines//' to '//show_number(values(size(values)))
               end if
               lines = lines//show_unit(run%model%unit_of(run%plan%base, position))//describe_choice(run, k, j)//newline
            end associate
         end do
      end do
   end function describe_sweep

   !> Do the values of an axis have no order?
   pure logical function is_sample(axis)
      type(axis_t), intent(in) :: axis

      is_sample = allocated(axis%name)
   end function is_sample

   !> How the values of a swept variable come about, beside other variables or from a file; nothing for a plain sweep.
   function describe_choice(run, axis, position) result(text)
      type(run_input_t), intent(in) :: run
      !> Index of the axis, from 1.
      integer, intent(in) :: axis
      !> Index of the variable along it, from 1.
      integer, intent(in) :: position
      character(:), allocatable :: text

      text = ''
      associate (variables => run%plan%axes(axis)%variables)
         if (allocated(run%plan%axes(axis)%name)) then
            text = text//', along '//run%plan%axes(axis)%name
         else if (position > 1) then
            text = text//', with '//run%model%variables(variables(1))%name
         end if
         if (run%datasets(variables(position))%is_given()) text = text//', from '''//run%datasets(variables(position))%text//''''
      end associate
   end function describe_choice

   !> A unit as it stands behind a number; nothing for a pure number.
   pure function show_unit(unit) result(text)
      !> A unit; empty or `-` for a pure number.
      character(*), intent(in) :: unit
      character(:), allocatable :: text

      text = ''
      if (len_trim(unit) > 0 .and. unit /= '-') text = ' '//unit
   end function show_unit

end module adfric_command_check
