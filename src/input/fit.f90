! SPDX-License-Identifier: GPL-3.0-or-later
!> A fit as the user describes it: the model's groups as in a run, and beside them the data, the events, what is free, and how.
module adfric_input_fit
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_count
   use adfric_base_unset, only: unset
   use adfric_base_words, only: count_words, get_word
   use adfric_fit_curve_source, only: curve_source_t
   use adfric_fit_parts, only: curve_points_t, has_others, list_curves, set_values_at
   use adfric_fit_problem, only: data_set_t, fit_t, n_nuisances, nuisance_friction_offset, nuisance_tilt
   use adfric_fit_scales, only: find_refusal
   use adfric_fit_stack_model, only: stack_model_t, new_stack_model
   use adfric_input_case, only: case_t, read_groups
   use adfric_input_consistency, only: check_consistency
   use adfric_input_dataset_loading, only: load_datasets
   use adfric_input_fit_data, only: check_data, load_data, loaded_data_t
   use adfric_input_fit_data_group, only: data_group_t, read_data_group
   use adfric_input_fit_free, only: check_members, hold_variable, read_frees
   use adfric_input_fit_history, only: hold_histories, let_vary, n_others, stack_history_t, take_histories
   use adfric_input_fit_identity, only: check_identity
   use adfric_input_fit_rows, only: fit_groups, get_fit_rows
   use adfric_input_fit_settings, only: read_events, read_settings
   use adfric_input_fit_stack, only: hdf5_stack_t
   use adfric_input_fit_values, only: reader_t
   use adfric_input_namelist_file, only: namelist_file_t
   use adfric_input_reading, only: new_reading, reading_t
   use adfric_input_run, only: run_input_t
   use adfric_input_vocabulary, only: full_name, output_names
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: result_t, variable_t
   use adfric_run_conversion, only: follows_nothing
   use adfric_run_converted_model, only: converted_model_t
   use adfric_run_dataset, only: dataset_t
   use adfric_run_listed_model, only: own_history_t
   use adfric_run_plan, only: axis_t, new_axis
   use adfric_system_checksum, only: checksum_t
   implicit none (type, external)
   private
   public :: fit_input_t, has_fit_groups, read_fit

   !> What the input of a fit says beside its run.
   type :: fit_input_t
      !> The `&data` groups.
      type(data_group_t), allocatable :: groups(:)
      !> What is known of their points.
      type(loaded_data_t) :: loaded
      !> Are the points of each curve of a stack wanted beside the results?
      logical :: wants_residuals = .false.
   end type fit_input_t

contains

   !> Has an input a group of a fit?
   pure logical function has_fit_groups(file)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file

      has_fit_groups = file%find_group('data') > 0 .or. file%find_group('free') > 0 .or. file%find_group('fit') > 0 .or. &
         file%find_group('event') > 0
   end function has_fit_groups

   !> The fits of a sphere know its work of adhesion, and do not take it from stress and range.
   subroutine refuse_missing_work(model, problems)
      class(model_t), intent(in) :: model
      type(problems_t), intent(inout) :: problems

      select type (model)
      class is (converted_model_t)
         if (model%name == 'sphere' .and. model%scene_values%follows /= follows_nothing) &
            & call problems%add('adhesion', 'work_of_adhesion', 'is missing [J/m^2]; a fit takes it '// &
            & 'with adhesion_stress or with adhesion_range, not these two')
      end select
   end subroutine refuse_missing_work

   !> Read the case, the data and what is free; the model of the run becomes the stack of curves.
   subroutine read_fit(file, run, details, problems)
      !> The input, cut into groups and assignments by `read_job`.
      type(namelist_file_t), intent(in), target :: file
      !> In: what `read_job` has found, and the model. Out: a run whose points are fits; only to be used when there are no problems.
      type(run_input_t), intent(inout), target :: run
      !> Receives what the input says of the data.
      type(fit_input_t), intent(out) :: details
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout), target :: problems
      type(case_t), target :: input
      type(reading_t) :: r
      type(fit_t) :: fit
      type(reader_t), allocatable :: readers(:)
      type(variable_t), allocatable :: rows(:)
      type(own_history_t), allocatable :: histories(:)
      type(stack_history_t) :: of_stack
      logical :: is_together

      allocate (rows, source=get_fit_rows())
      call new_reading(r, file, problems, run%model, input)
      call read_groups(r, 'job '//fit_groups)
      call refuse_output(r)
      call refuse_missing_work(run%model, problems)
      call need_group(r, 'data')
      call need_group(r, 'free')
      call read_data_groups(r, rows, details%groups)
      if (problems%is_enough()) return
      call read_frees(r, rows, details%groups, fit%frees, readers)
      call read_events(r, rows, details%groups, fit%events)
      call read_settings(r, rows, fit, is_together, details%wants_residuals)
      if (details%wants_residuals .and. size(details%groups) > 1) call problems%add('fit', 'residuals', &
         'is ''all'' beside several &data; the points of a stack are written where it has one')
      if (problems%is_enough()) return
      call load_datasets(run%model, input, problems)
      call check_members(r, fit%frees, readers)
      call hold_histories(r, details%groups)
      call check_each_abscissa(r, details%groups)
      call check_identity(r, details%groups, fit%frees, readers)
      if (problems%count() > 0) return
      call set_units(run%model, input, details%groups)
      call load_data(r, details%groups, is_together, details%loaded)
      if (problems%count() == 0) call check_data(r, details%groups, details%loaded, fit)
      if (problems%count() == 0) call take_histories(r, details%groups, details%loaded%data_sets, &
         size(details%loaded%lengths) > 0, histories, of_stack)
      if (problems%count() == 0) call check_each_curve(r, details%loaded%data_sets)
      if (problems%count() > 0) return
      call let_vary(r, histories, fit%frees, run%model)
      call extend_case(run%model, input)
      call set_run(input, fit, details, of_stack, run, problems)
   end subroutine read_fit

   !> Report what only a run can write beside its results.
   subroutine refuse_output(r)
      type(reading_t), intent(in) :: r
      integer :: group, k

      group = r%file%find_group('output')
      if (group == 0) return
      do k = 1, count_words(output_names)
         if (r%file%find_assignment(group, get_word(output_names, k)) > 0) call r%report(group, get_word(output_names, k), &
            'has no place in a fit, allowed: adfric run')
      end do
   end subroutine refuse_output

   !> Report a group that is missing.
   subroutine need_group(r, name)
      type(reading_t), intent(in) :: r
      !> Name of the group.
      character(*), intent(in) :: name

      if (r%file%find_group(name) > 0 .or. r%problems%is_enough()) return
      call r%problems%add(name, '', 'the group is missing, a fit needs at least one')
   end subroutine need_group

   !> Read every `&data`; its abscissa is given nowhere else.
   subroutine read_data_groups(r, rows, groups)
      type(reading_t), intent(in) :: r
      type(variable_t), intent(in) :: rows(:)
      type(data_group_t), allocatable, intent(out) :: groups(:)
      integer :: i, g, index

      allocate (groups(count(r%file%groups%name == 'data')))
      g = 0
      do i = 1, size(r%file%groups)
         if (r%file%groups(i)%name /= 'data') cycle
         if (r%problems%is_enough()) exit
         g = g + 1
         call read_data_group(r, i, rows, groups(g))
         index = groups(g)%data_set%abscissa
         if (index == 0) then
            r%input%is_broken = .true.
         else if (r%input%is_given(index)) then
            call groups(g)%reader%report(r, 'abscissa', r%model%variables(index)%name//' is given twice, here and in &' &
               //r%model%variables(index)%group//' in line '//show_count(r%input%line(index))//', allowed: one of them')
         end if
      end do
      groups = groups(:g)
   end subroutine read_data_groups

   !> Let the model check its values with each abscissa. Where points have values of further variables, these are needed for it
   !> (`check_each_curve`).
   subroutine check_each_abscissa(r, groups)
      type(reading_t), intent(in) :: r
      !> The `&data` groups.
      type(data_group_t), intent(in) :: groups(:)
      integer :: g

      do g = 1, size(groups)
         if (groups(g)%data_set%abscissa > 0 .and. n_others(r%model, groups(g)) == 0) &
            call check_abscissa(r, groups(g)%data_set%abscissa)
      end do
   end subroutine check_each_abscissa

   !> Let the model check its values with an abscissa, which has no value afterwards.
   subroutine check_abscissa(r, index)
      type(reading_t), intent(in) :: r
      !> Index of the variable.
      integer, intent(in) :: index
      type(axis_t) :: axes(0)

      if (r%input%is_given(index)) return
      call hold_variable(r%model, index, r%input)
      call check_consistency(r, axes)
      r%input%values(index) = unset
      r%input%is_swept(index) = .false.
   end subroutine check_abscissa

   !> Let the model check its values with those of each curve of the points; it ends at the first problem.
   subroutine check_each_curve(r, data_sets)
      type(reading_t), intent(in) :: r
      !> The points of each `&data`.
      type(data_set_t), intent(in) :: data_sets(:)
      type(curve_points_t), allocatable :: curves(:)
      real(dp), allocatable :: usual(:)
      integer :: c, g, n_before

      ! the points of a stack are not read yet, and have none
      if (.not. any([(has_others(data_sets(g)), g=1, size(data_sets))])) return
      n_before = r%problems%count()
      call list_curves(data_sets, curves)
      do c = 1, size(curves)
         associate (set => data_sets(curves(c)%data_set))
            if (.not. has_others(set)) cycle
            usual = r%input%values(set%others)
            call set_values_at(set, curves(c)%points(1), r%input%values)
            r%input%is_swept(set%others) = .true.
            call check_abscissa(r, set%abscissa)
            ! another &data may be without them
            r%input%values(set%others) = usual
            r%input%is_swept(set%others) = .false.
         end associate
         if (r%problems%count() > n_before) return
      end do
   end subroutine check_each_curve

   !> Units of abscissas and ordinates in this case.
   subroutine set_units(model, input, groups)
      class(model_t), intent(in) :: model
      type(case_t), intent(in) :: input
      type(data_group_t), intent(inout) :: groups(:)
      type(result_t), allocatable :: results(:)
      integer :: g, k

      allocate (results, source=model%describe_results(input%values))
      do g = 1, size(groups)
         groups(g)%x_unit = model%unit_of(input%values, groups(g)%data_set%abscissa)
         groups(g)%y_unit = results(groups(g)%data_set%ordinate)%unit
         do k = 1, size(groups(g)%others)
            groups(g)%others(k)%unit = model%unit_of(input%values, groups(g)%data_set%others(k))
         end do
      end do
   end subroutine set_units

   !> Values of variables that the model has got behind those of its table: members of lists, and the number of the `&data`.
   subroutine extend_case(model, input)
      class(model_t), intent(in) :: model
      type(case_t), intent(inout) :: input
      type(dataset_t), allocatable :: datasets(:)
      integer :: n, more

      n = size(input%values)
      more = size(model%variables) - n
      if (more == 0) return
      input%values = [input%values, spread(1.0_dp, 1, more)]
      input%is_given = [input%is_given, spread(.false., 1, more)]
      allocate (datasets(n + more))
      datasets(:n) = input%datasets
      call move_alloc(datasets, input%datasets)
   end subroutine extend_case

   !> Make the run of the stack.
   subroutine set_run(input, fit, details, of_stack, run, problems)
      type(case_t), intent(inout) :: input
      !> What is fitted, without model, values and points.
      type(fit_t), intent(inout) :: fit
      type(fit_input_t), intent(in) :: details
      !> Where the curves of a stack over time have their histories from.
      type(stack_history_t), intent(in) :: of_stack
      !> In: the run with the model. Out: the run with the stack.
      type(run_input_t), intent(inout) :: run
      type(problems_t), intent(inout) :: problems
      character(:), allocatable :: reason
      type(hdf5_stack_t), allocatable :: stack
      class(curve_source_t), allocatable :: source
      type(stack_model_t), allocatable :: model
      integer :: i, n_samples

      allocate (fit%model, source=run%model)
      do i = 1, size(fit%frees)
         if (fit%frees(i)%variable > 0) input%values(fit%frees(i)%variable) = unset
         if (fit%frees(i)%nuisance == nuisance_friction_offset) fit%frees(i)%unit = details%groups(fit%frees(i)%data_set)%y_unit
         if (fit%frees(i)%nuisance == nuisance_tilt) fit%frees(i)%unit = tilt_unit(details%groups(fit%frees(i)%data_set))
      end do
      fit%base = input%values
      fit%data_sets = details%loaded%data_sets
      if (size(details%loaded%lengths) == 0) then
         call find_refusal(fit, reason)
         if (len(reason) > 0) call problems%add('data', '', reason)
      else
         allocate (stack)
         stack%groups = details%groups
         stack%files = details%loaded%files
         stack%history = of_stack
         fit%history_lists = of_stack%lists
         call move_alloc(stack, source)
      end if
      n_samples = 0
      if (allocated(source) .and. details%wants_residuals) n_samples = details%loaded%files(1)%n_points
      allocate (model)
      call new_stack_model(model, fit, size(details%groups), details%loaded%lengths, n_samples, source)
      run%digest = digest_of(fit, details%groups)
      if (n_samples > 0) run%digest = run%digest//' residuals'
      call extend_plan(input, details%loaded, run)
      deallocate (run%model)
      call move_alloc(model, run%model)
   end subroutine set_run

   !> Unit of the slope of a base line: that of the ordinate over that of the abscissa.
   pure function tilt_unit(group) result(unit)
      !> The `&data` group with its units.
      type(data_group_t), intent(in) :: group
      character(:), allocatable :: unit

      unit = group%y_unit//'/'//group%x_unit
      if (unit == 'N/m/m') unit = 'N/m^2'
   end function tilt_unit

   !> The values, files and axes of the stack's run.
   subroutine extend_plan(input, loaded, run)
      type(case_t), intent(in) :: input
      type(loaded_data_t), intent(in) :: loaded
      type(run_input_t), intent(inout) :: run
      integer :: i, k, n

      associate (n_files => size(loaded%datasets), n_axes => size(loaded%lengths))
         n = size(input%values) + n_files
         run%plan%base = [input%values, spread(1.0_dp, 1, n_files + n_axes)]
         run%is_given = [input%is_given, spread(.true., 1, n_files + n_axes)]
         allocate (run%datasets(n + n_axes), run%plan%axes(n_axes))
         run%datasets(:size(input%values)) = input%datasets
         run%datasets(size(input%values) + 1:n) = loaded%datasets
         do k = 1, n_axes
            call new_axis(run%plan%axes(k), n + k, [(real(i, dp), i=1, int(loaded%lengths(k)))])
         end do
      end associate
   end subroutine extend_plan

   !> A checksum of all that says how the data are fitted.
   function digest_of(fit, groups) result(digest)
      type(fit_t), intent(in) :: fit
      type(data_group_t), intent(in) :: groups(:)
      character(:), allocatable :: digest
      type(checksum_t) :: sum
      integer :: i, k

      call sum%add_text('fit')
      do i = 1, size(fit%frees)
         associate (free => fit%frees(i))
            call sum%add_text(free%name)
            call sum%add_reals([merge(1.0_dp, 0.0_dp, free%is_log), free%start, free%minimum, free%maximum, free%prior, &
               free%prior_sigma])
         end associate
      end do
      do i = 1, size(fit%data_sets)
         associate (set => fit%data_sets(i))
            call sum%add_text(full_name(fit%model, set%abscissa)//' '//fit%model%results(set%ordinate)%name)
            call sum%add_reals([real(set%loss, dp), set%loss_width, set%nuisance(:n_nuisances)])
            do k = 1, size(set%others)
               call sum%add_text(full_name(fit%model, set%others(k)))
            end do
         end associate
         call sum%add_reals([groups(i)%sigma, groups(i)%relative_sigma, groups(i)%abscissa_sigma, groups(i)%from, groups(i)%to])
      end do
      do i = 1, size(fit%events)
         call sum%add_reals([real(fit%events(i)%data_set, dp), real(fit%events(i)%kind, dp), fit%events(i)%value, &
            fit%events(i)%sigma])
      end do
      call sum%add_reals(real([fit%intervals, fit%n_starts, fit%n_bootstrap, fit%seed, fit%theories], dp))
      call sum%add_reals([fit%relative_tolerance, fit%levels])
      call sum%add_text(fit%derived)
      digest = sum%to_text()
   end function digest_of

end module adfric_input_fit
