! SPDX-License-Identifier: GPL-3.0-or-later
!> A run as the user describes it, in two steps: which model is wanted, then its case and sweep.
!>
!> Between them the caller makes the model of that name, so that nothing here knows of any particular one.
module adfric_input_run
   use adfric_base_error, only: error_t
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: join_words, longest_name, show_count, show_text
   use adfric_base_words, only: has_word
   use adfric_input_case, only: case_t, read_groups
   use adfric_input_consistency, only: check_consistency
   use adfric_input_dataset_loading, only: load_datasets
   use adfric_input_design, only: read_axes
   use adfric_input_item, only: take_only_word
   use adfric_input_literal, only: convert
   use adfric_input_namelist_file, only: namelist_file_t, open_namelist_file, open_namelist_text
   use adfric_input_reading, only: new_reading, reading_t
   use adfric_input_refinement, only: read_refinement
   use adfric_input_suggestion, only: find_nearest, did_you_mean
   use adfric_input_sweep_size, only: check_counts, find_size_problem
   use adfric_input_variation, only: read_variation
   use adfric_input_vocabulary, only: job_names, report_unknown_names
   use adfric_run_run, only: run_t
   implicit none (type, external)
   private
   public :: run_input_t, read_job, read_job_of_text, read_case, say_unknown_model

   !> A run, and what its input says of it beside.
   type, extends(run_t) :: run_input_t
      !> Name of the model; empty if the file names none that is known.
      character(:), allocatable :: model_name
      !> Does the file describe a scene, and name no model?
      logical :: is_scene = .false.
      !> Which variables the file gives in their groups, shape `(n_variables)`.
      logical, allocatable :: is_given(:)
      !> Names of the variables that get their values later, separated by a blank, such as `surface%heights`; only then all values
      !> are checked together. Not allocated: the file gives all.
      character(:), allocatable :: later
   end type run_input_t

contains

   !> Open an input and find out which model it wants.
   subroutine read_job(path, known_models, file, run, problems, error)
      !> Name of the input, with or without a folder.
      character(*), intent(in) :: path
      !> Names of the models, separated by a blank.
      character(*), intent(in) :: known_models
      !> Receives the input, cut into groups and assignments, for `read_case`.
      type(namelist_file_t), intent(out), target :: file
      !> Receives the names of the model and of the results file, the title and the text.
      type(run_input_t), intent(out) :: run
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout), target :: problems
      !> Allocated if the file cannot be read, or is no text.
      type(error_t), allocatable, intent(out) :: error
      type(reading_t) :: r

      call new_reading(r, file, problems)
      call start_run(run, default_output(path))
      call open_namelist_file(file, path, problems, error)
      if (.not. allocated(error)) call find_job(r, known_models, run)
   end subroutine read_job

   !> Find out which model a text wants that is no file.
   subroutine read_job_of_text(text, known_models, file, run, problems, error)
      !> Text of the input.
      character(*), intent(in) :: text
      !> Names of the models, separated by a blank.
      character(*), intent(in) :: known_models
      !> Receives the input, cut into groups and assignments, for `read_case`.
      type(namelist_file_t), intent(out), target :: file
      !> Receives the names of the model and of the results file, the title and the text.
      type(run_input_t), intent(out) :: run
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout), target :: problems
      !> Allocated if it is no text.
      type(error_t), allocatable, intent(out) :: error
      type(reading_t) :: r

      call new_reading(r, file, problems)
      call start_run(run, default_output('text'))
      call open_namelist_text(file, '', text, problems, error)
      if (.not. allocated(error)) call find_job(r, known_models, run)
   end subroutine read_job_of_text

   !> Nothing is known of a run but where its results go.
   subroutine start_run(run, output)
      type(run_input_t), intent(inout) :: run
      character(*), intent(in) :: output

      run%model_name = ''
      run%title = ''
      run%output = output
   end subroutine start_run

   !> Find out which model an input wants.
   subroutine find_job(r, known_models, run)
      type(reading_t), intent(in) :: r
      !> Names of the models, separated by a blank.
      character(*), intent(in) :: known_models
      !> Receives the names of the model and of the results file, the title and the text.
      type(run_input_t), intent(inout) :: run
      integer :: group

      ! of a file that has not been looked at to its end nothing more can be said
      if (r%problems%is_enough()) return
      run%text = r%file%text
      group = r%file%find_group('job')
      run%is_scene = describes_scene(r%file, group)
      if (group == 0) then
         if (run%is_scene) return
         ! a file without any group is no input, and that has been said
         if (size(r%file%groups) > 0 .or. r%problems%count() == 0) call report_missing_job(r, known_models)
         return
      end if
      call report_unknown_names(r, group, job_names//trim(merge(' units solver', '             ', run%is_scene)))
      call read_word(r, group, 'title', run%title)
      call read_output(r, group, run%output)
      if (.not. run%is_scene) call read_model(r, group, known_models, run%model_name)
   end subroutine find_job

   !> Does an input describe a scene, and name no model?
   pure logical function describes_scene(file, job)
      type(namelist_file_t), intent(in) :: file
      !> Number of its `&job`; 0 if it has none.
      integer, intent(in) :: job

      describes_scene = file%find_group('surface') > 0 .or. file%find_group('traction') > 0
      if (job > 0) describes_scene = describes_scene .and. file%find_assignment(job, 'model') == 0 &
         .and. .not. file%groups(job)%is_garbled
   end function describes_scene

   !> Read the case and the sweep of the model that the input wants, and hand the model its datasets.
   subroutine read_case(file, run, problems)
      !> The input, cut into groups and assignments by `read_job`.
      type(namelist_file_t), intent(in), target :: file
      !> In: what `read_job` has found, and the model. Out: also the points, the datasets, and what is given; they are only to be
      !> used when there are no problems.
      type(run_input_t), intent(inout), target :: run
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout), target :: problems
      type(case_t), target :: input
      type(reading_t) :: r
      character(:), allocatable :: text
      integer :: n_before
      logical :: is_countable

      call new_reading(r, file, problems, run%model, input)
      call read_groups(r)
      n_before = problems%count()
      call check_counts(r)
      is_countable = problems%count() == n_before
      if (is_countable .and. .not. problems%is_enough()) call read_axes(r, run%plan%axes)
      ! what the sweeps should have given is not missing
      if (.not. is_countable) input%is_broken = .true.
      if (.not. is_countable) allocate (run%plan%axes(0))
      ! what has not been read is not missing
      if (problems%is_enough()) return
      call load_datasets(run%model, input, problems)
      if (.not. allocated(run%later)) call check_consistency(r, run%plan%axes)
      if (is_countable) call read_refinement(r, run%plan%axes, run%refinement)
      call read_variation(r, run%variation)
      text = find_size_problem(run%plan)
      if (len(text) > 0) call problems%add('sweep', '', text)
      call move_alloc(input%values, run%plan%base)
      call move_alloc(input%is_given, run%is_given)
      call move_alloc(input%datasets, run%datasets)
      if (problems%count() == 0) call run%complete_model()
   end subroutine read_case

   !> The name of the input, without folder and with `.h5` for its extension.
   pure function default_output(path) result(name)
      !> Name of the input, with or without a folder.
      character(*), intent(in) :: path
      character(:), allocatable :: name
      integer :: dot

      name = path(index(path, '/', back=.true.) + 1:)
      dot = index(name, '.', back=.true.)
      if (dot > 1) name = name(:dot - 1)
      name = name//'.h5'
   end function default_output

   !> Report that there is no `&job`.
   subroutine report_missing_job(r, known_models)
      type(reading_t), intent(in) :: r
      character(*), intent(in) :: known_models
      character(:), allocatable :: text
      integer :: i

      text = 'the group is missing, needed: &surface or &traction of a scene (adfric help scenes), or &job model = '''// &
         join_words(known_models, ''' or ''')//''' /'
      do i = 1, size(r%file%groups)
         if (find_nearest(trim(r%file%groups(i)%name), 'job') /= 'job') cycle
         text = text//'; did you mean it by &'//trim(r%file%groups(i)%name)//' in line ' &
            //show_count(r%file%line_of(r%file%groups(i)%first))//'?'
         exit
      end do
      call r%problems%add('job', '', text)
   end subroutine report_missing_job

   !> Read a text of `&job`; what is wrong, or not given, leaves it as it is.
   subroutine read_word(r, group, name, word)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      !> Name of the variable of `&job`.
      character(*), intent(in) :: name
      !> Receives the text without its quotes; left as it is if something is wrong or nothing is given.
      character(:), allocatable, intent(inout) :: word
      character(:), allocatable :: quoted, given, flaw
      integer :: number, position

      number = r%file%find_assignment(group, name)
      if (number == 0) return
      call take_only_word(r%file%value_of(number), quoted, flaw, position)
      if (len(flaw) == 0) call convert(quoted, given, flaw)
      if (len(flaw) == 0) then
         word = given
      else
         call r%report(group, name, flaw//', allowed: a text in quotes', position)
      end if
   end subroutine read_word

   !> Read the name of the results file.
   subroutine read_output(r, group, output)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      !> In: the name for an input that gives none. Out: the name that is given, if one is.
      character(:), allocatable, intent(inout) :: output

      call read_word(r, group, 'output', output)
      if (len(output) == 0) then
         call r%report(group, 'output', 'empty, allowed: the name of a file')
      else if (len(output) > longest_name) then
         call r%report(group, 'output', 'too long for the name of a file, given '//show_text(output)//', allowed: at most ' &
            //show_count(longest_name)//' letters')
      else if (output == r%file%path) then
         call r%report(group, 'output', 'the results would replace the input, given '''//show_text(output) &
            //''', allowed: the name of another file')
      end if
   end subroutine read_output

   !> Read the name of the model; empty if it is unknown.
   subroutine read_model(r, group, known_models, model)
      type(reading_t), intent(in) :: r
      integer, intent(in) :: group
      character(*), intent(in) :: known_models
      !> In: empty. Out: the name of a known model; empty if something is wrong.
      character(:), allocatable, intent(inout) :: model
      character(:), allocatable :: choices
      integer :: n_before

      choices = ''''//join_words(known_models, ''', ''')//''''
      if (r%file%find_assignment(group, 'model') == 0) then
         if (.not. r%file%groups(group)%is_garbled) call r%report(group, 'model', 'not given, allowed: '//choices)
         return
      end if
      n_before = r%problems%count()
      call read_word(r, group, 'model', model)
      if (r%problems%count() > n_before) return
      if (has_word(known_models, model)) return
      call r%report(group, 'model', say_unknown_model(model, known_models))
      model = ''
   end subroutine read_model

   !> What to say of a model that is not known.
   pure function say_unknown_model(name, known_models) result(text)
      !> The name that is not known.
      character(*), intent(in) :: name
      !> Names of the models, separated by a blank.
      character(*), intent(in) :: known_models
      character(:), allocatable :: text

      text = 'unknown model, given '''//show_text(name)//''', allowed: '''//join_words(known_models, ''', ''')//''''// &
         did_you_mean(name, known_models)
   end function say_unknown_model

end module adfric_input_run
