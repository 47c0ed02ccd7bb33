! SPDX-License-Identifier: GPL-3.0-or-later
!> What a simulation is made of, and what its parts have to do with each other.
module adfric_api_state
   use adfric, only: known_models, new_model
   use adfric_api_axes, only: leave_out, put_axis
   use adfric_api_values, only: check_swept, error_of, find_index, give_number, give_samples, give_switch, give_word
   use adfric_base_error, only: error_t, input_failure, set_error
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_count, to_lower
   use adfric_input_case, only: case_t, new_case
   use adfric_input_text_table, only: text_table_t
   use adfric_input_consistency, only: check_consistency
   use adfric_input_fit, only: fit_input_t, has_fit_groups, read_fit
   use adfric_input_namelist_file, only: namelist_file_t, no_namelist_file
   use adfric_input_reading, only: new_reading, reading_t
   use adfric_input_run, only: read_case, read_job, read_job_of_text, run_input_t, say_unknown_model
   use adfric_input_scene, only: make_model
   use adfric_input_sweep_size, only: find_size_problem
   use adfric_describe_model, only: model_t
   use adfric_describe_table, only: kind_dataset
   use adfric_run_dataset, only: dataset_t
   use adfric_run_memory_sink, only: memory_sink_t
   use adfric_run_run, only: new_run, run_t
   implicit none (type, external)
   private
   public :: case_state_t, open_model, open_state, read_state

   !> The parts of a simulation.
   type :: case_state_t
      !> The model with its points; the model is not allocated where the simulation is closed.
      type(run_t) :: run
      !> Value of every variable, and which of them are given or swept.
      type(case_t) :: input
      !> What was found.
      type(memory_sink_t), allocatable :: found
      !> Is it a fit, whose values are those of its input?
      logical :: is_fit = .false.
      !> Has it been solved, so that the files of its curves are closed?
      logical :: is_spent = .false.
   contains
      procedure :: close => close_state
      procedure :: give
      procedure :: give_dataset
      procedure :: take_back
      procedure :: sweep
      procedure :: check_case
      procedure :: check_open
      procedure :: check_solved
   end type case_state_t

contains

   !> Open a model by its name.
   subroutine open_model(self, name, error)
      !> Receives the model, with no value but the defaults; closed if there is an error.
      type(case_state_t), intent(out) :: self
      !> Name of the model; blanks at its end do not count.
      character(*), intent(in) :: name
      !> Allocated if there is no such model; says which there are.
      type(error_t), allocatable, intent(out) :: error
      class(model_t), allocatable :: model

      call new_model(model, trim(name), error)
      if (allocated(error)) then
         error%message = '&job model: '//say_unknown_model(trim(name), known_models)
      else
         call open_state(self, model)
      end if
   end subroutine open_model

   !> Open what an input describes: the model, its values, sweeps and datasets, or a fit with its data.
   subroutine read_state(self, input, is_text, error, tables, later)
      !> Receives the model with its values; closed if there is an error.
      type(case_state_t), intent(out) :: self
      !> Name of the input, or its text.
      character(*), intent(in) :: input
      !> Is it the text, and not the name?
      logical, intent(in) :: is_text
      !> Says what is wrong with the input, a line each.
      type(error_t), allocatable, intent(out) :: error
      !> Tables of a fit that the caller has in memory, by their names.
      type(text_table_t), intent(in), optional :: tables(:)
      !> Names of variables that the caller gives values afterwards, or `group%name`; only then all values are checked together.
      character(*), intent(in), optional :: later(:)
      type(namelist_file_t) :: file
      type(run_input_t) :: run
      type(fit_input_t) :: details
      type(problems_t) :: problems

      if (is_text) then
         call read_job_of_text(input, known_models, file, run, problems, error)
      else
         call read_job(input, known_models, file, run, problems, error)
      end if
      if (allocated(error)) return
      if (present(later)) call announce(later, file, run, error)
      if (allocated(error)) return
      call make_model(file, run, problems, error)
      if (allocated(error)) return
      if (allocated(run%model) .and. present(later)) call check_announced(later, run%model, problems)
      if (allocated(run%model)) then
         self%is_fit = has_fit_groups(file) .or. present(tables)
         if (self%is_fit) then
            if (present(tables)) file%tables = tables
            call read_fit(file, run, details, problems)
         else
            call read_case(file, run, problems)
         end if
      end if
      call error_of(problems, error, file%path)
      if (.not. allocated(error) .and. run%refinement%is_wanted()) call set_error(error, input_failure, &
         & '&refine: a simulation solves the points that it is given, allowed: adfric run')
      if (.not. allocated(error) .and. present(later) .and. run%variation%is_wanted()) call set_error(error, input_failure, &
         & '&uncertain or &output derivatives: a scene whose values come later has none, allowed: an input that has all values')
      if (.not. allocated(error)) call take_input(self, run)
   end subroutine read_state

   !> Take note of the variables that the caller gives values afterwards.
   subroutine announce(later, file, run, error)
      character(*), intent(in) :: later(:)
      !> The input, cut into groups and assignments.
      type(namelist_file_t), intent(in) :: file
      !> Receives the names.
      type(run_input_t), intent(inout) :: run
      !> Allocated if the input is no scene, or one of a fit.
      type(error_t), allocatable, intent(out) :: error
      integer :: i

      if (len(run%model_name) > 0) then
         call set_error(error, input_failure, '&job model: given, allowed: a scene, which names none')
      else if (has_fit_groups(file)) then
         call set_error(error, input_failure, 'a scene whose values come later is no fit, allowed: open_fit')
      end if
      run%later = ''
      do i = 1, size(later)
         run%later = trim(run%later//' '//to_lower(trim(adjustl(later(i)))))
      end do
      run%later = adjustl(run%later)
   end subroutine announce

   !> Hold the names that the caller has announced against the table of the model.
   subroutine check_announced(later, model, problems)
      character(*), intent(in) :: later(:)
      !> The solver, in the language of scenes.
      class(model_t), intent(in) :: model
      !> Receives which names are unknown.
      type(problems_t), intent(inout) :: problems
      integer :: i, index

      do i = 1, size(later)
         call find_index(model, later(i), index, problems)
      end do
   end subroutine check_announced

   !> Take over what an input describes.
   subroutine take_input(self, run)
      type(case_state_t), intent(inout) :: self
      !> What the input describes; nothing is left of it.
      type(run_input_t), intent(inout) :: run
      logical :: is_fit
      integer :: i

      is_fit = self%is_fit
      call open_state(self, run%model)
      self%is_fit = is_fit
      self%input%values = run%plan%base
      self%input%is_given = run%is_given
      do i = 1, size(self%input%values)
         self%input%is_swept(i) = run%plan%is_swept(i)
      end do
      if (is_fit) self%run%datasets = run%datasets
      call move_alloc(run%datasets, self%input%datasets)
      call move_alloc(run%plan%axes, self%run%plan%axes)
      if (allocated(run%digest)) self%run%digest = run%digest
      self%run%plan%base = self%input%values
      self%run%title = run%title
      self%run%text = run%text
      self%run%output = run%output
   end subroutine take_input

   !> Open a model.
   subroutine open_state(self, model)
      !> Receives the model, with no value but the defaults.
      type(case_state_t), intent(out) :: self
      !> The model, which is taken over.
      class(model_t), allocatable, intent(inout) :: model

      call new_run(self%run, model)
      call new_case(self%input, self%run%model)
   end subroutine open_state

   !> Give everything back.
   subroutine close_state(self)
      !> The simulation, open or closed.
      class(case_state_t), intent(inout) :: self

      if (allocated(self%found)) deallocate (self%found)
      if (allocated(self%run%model)) deallocate (self%run%model)
   end subroutine close_state

   !> Give a variable one value: it is not swept any more.
   subroutine give(self, name, value, error)
      !> The simulation; unchanged if there is an error.
      class(case_state_t), intent(inout) :: self
      !> Name of the variable, or `group%name`.
      character(*), intent(in) :: name
      !> The value: a real number of kind `dp`, an integer, a logical or a word.
      class(*), intent(in) :: value
      !> Not allocated if the value is given.
      type(error_t), allocatable, intent(out) :: error
      type(problems_t) :: problems
      integer :: index

      call find_variable(self, name, index, error)
      if (allocated(error)) return
      associate (variable => self%run%model%variables(index))
         select type (value)
         type is (real(dp))
            call give_number(variable, value, self%input%values(index), problems)
         type is (integer)
            call give_number(variable, real(value, dp), self%input%values(index), problems)
         type is (logical)
            call give_switch(variable, value, self%input%values(index), problems)
         type is (character(*))
            call give_word(variable, value, self%input%values(index), problems)
         end select
      end associate
      call error_of(problems, error)
      if (.not. allocated(error)) call mark(self, index, is_given=.true.)
   end subroutine give

   !> Give a variable a dataset.
   subroutine give_dataset(self, name, values, rank, error)
      !> The simulation; after an error the dataset is not given.
      class(case_state_t), intent(inout) :: self
      !> Name of the variable, or `group%name`.
      character(*), intent(in) :: name
      !> Values of the dataset in the SI unit of the variable; shape `(nx, ny)`, ny = 1 for one dimension.
      real(dp), intent(in) :: values(:, :)
      !> Number of dimensions, 1 or 2.
      integer, intent(in) :: rank
      !> Not allocated if the dataset is given.
      type(error_t), allocatable, intent(out) :: error
      type(problems_t) :: problems
      integer :: index

      call find_variable(self, name, index, error)
      if (allocated(error)) return
      call give_samples(self%run%model, index, values, rank, self%input, problems)
      call error_of(problems, error)
      if (allocated(self%found) .and. self%run%model%variables(index)%kind == kind_dataset) deallocate (self%found)
   end subroutine give_dataset

   !> Give a variable its default value again, or none.
   subroutine take_back(self, name, error)
      !> The simulation; unchanged if there is an error.
      class(case_state_t), intent(inout) :: self
      !> Name of the variable, or `group%name`.
      character(*), intent(in) :: name
      !> Allocated if there is no such variable.
      type(error_t), allocatable, intent(out) :: error
      integer :: index

      call find_variable(self, name, index, error)
      if (allocated(error)) return
      self%input%values(index) = self%run%model%variables(index)%default
      call mark(self, index, is_given=.false.)
   end subroutine take_back

   !> Sweep variables together.
   subroutine sweep(self, names, values, error)
      !> The simulation; unchanged if there is an error.
      class(case_state_t), intent(inout) :: self
      !> Names of the variables, or `group%name`.
      character(*), intent(in) :: names(:)
      !> Values of the variables in their SI units; shape `(n_values, n_names)`.
      real(dp), intent(in) :: values(:, :)
      !> Not allocated if the variables are swept.
      type(error_t), allocatable, intent(out) :: error
      type(problems_t) :: problems
      integer :: indices(size(names)), k

      call self%check_open(error)
      if (allocated(error)) return
      if (size(values, 2) /= size(names) .or. size(names) == 0) then
         call set_error(error, input_failure, 'a sweep of '//show_count(size(names))//' variables with values of '// &
            & show_count(size(values, 2))//', allowed: values of shape (n_values, n_variables)')
         return
      end if
      do k = 1, size(names)
         call find_variable(self, names(k), indices(k), error)
         if (allocated(error)) return
         call check_swept(self%run%model%variables(indices(k)), values(:, k), problems)
         if (any(indices(:k - 1) == indices(k))) call problems%add('', '', trim(names(k))//' is given twice, allowed: once')
      end do
      call error_of(problems, error)
      if (allocated(error)) return
      call put_axis(self%run%plan%axes, indices, transpose(values))
      do k = 1, size(indices)
         self%input%values(indices(k)) = values(1, k)
         self%input%is_given(indices(k)) = .false.
         self%input%is_swept(indices(k)) = .true.
      end do
      if (allocated(self%found)) deallocate (self%found)
   end subroutine sweep

   !> Let the model check all values together, as those of a namelist.
   subroutine check_case(self, error)
      !> The simulation, which is open; the points receive the values.
      class(case_state_t), intent(inout), target :: self
      !> Says what is missing, contradictory or impossible, a line each.
      type(error_t), allocatable, intent(out) :: error
      type(namelist_file_t), target :: nothing
      type(problems_t), target :: problems
      type(reading_t) :: reading
      type(dataset_t) :: none
      character(:), allocatable :: text
      integer :: i

      if (self%is_fit) then
         ! it was checked when it was opened
         if (self%is_spent) call set_error(error, input_failure, 'a fit is solved once, allowed: to open it once more')
         return
      end if
      self%run%plan%base = self%input%values
      do i = 1, size(self%input%datasets)
         self%run%datasets(i) = none
         if (self%input%is_given(i)) self%run%datasets(i) = self%input%datasets(i)
      end do
      call no_namelist_file(nothing)
      call new_reading(reading, nothing, problems, self%run%model, self%input)
      call check_consistency(reading, self%run%plan%axes)
      text = find_size_problem(self%run%plan)
      if (len(text) > 0) call problems%add('', '', text)
      call error_of(problems, error)
   end subroutine check_case

   !> Is the simulation open?
   subroutine check_open(self, error)
      !> The simulation.
      class(case_state_t), intent(in) :: self
      !> Allocated if the simulation is closed.
      type(error_t), allocatable, intent(out) :: error

      if (.not. allocated(self%run%model)) call set_error(error, input_failure, &
         & 'the simulation is closed, open_simulation opens it')
   end subroutine check_open

   !> Is the simulation solved?
   subroutine check_solved(self, error)
      !> The simulation.
      class(case_state_t), intent(in) :: self
      !> Allocated if the simulation is closed, or not solved since a variable was set last.
      type(error_t), allocatable, intent(out) :: error

      call self%check_open(error)
      if (allocated(error)) return
      if (.not. allocated(self%found)) call set_error(error, input_failure, &
         & 'there are no results for the values as they are, solve finds them')
   end subroutine check_solved

   !> Find a variable.
   subroutine find_variable(self, name, index, error)
      class(case_state_t), intent(in) :: self
      character(*), intent(in) :: name
      !> Index of the variable in the model's table; 0 if there is an error.
      integer, intent(out) :: index
      type(error_t), allocatable, intent(out) :: error
      type(problems_t) :: problems

      index = 0
      call self%check_open(error)
      if (allocated(error)) return
      if (self%is_fit) then
         call set_error(error, input_failure, trim(name)//': a fit is as its input describes it, allowed: another input')
         return
      end if
      call find_index(self%run%model, name, index, problems)
      call error_of(problems, error)
   end subroutine find_variable

   !> Take note of a variable that has one value now: what was found does not belong to it.
   subroutine mark(self, index, is_given)
      class(case_state_t), intent(inout) :: self
      integer, intent(in) :: index
      !> Is the value given by the caller, and not the default?
      logical, intent(in) :: is_given

      self%input%is_given(index) = is_given
      if (self%input%is_swept(index)) call leave_out(self%run%plan%axes, index)
      self%input%is_swept(index) = .false.
      if (allocated(self%found)) deallocate (self%found)
   end subroutine mark

end module adfric_api_state
