! SPDX-License-Identifier: GPL-3.0-or-later
!> The library as a Fortran program sees it: a simulation is a model whose variables are set by name, which is solved at any number
!> of points, and which is asked for its results by name.
!>
!>     open_simulation ---> open ---set, sweep---> open ---solve---> solved ---set, sweep---> open ---> ...
!>                            |                                         |
!>                            +--- close ---> closed <--- close --------+      closed: every other procedure gives an error
!>
!> Values are in SI units, and what they may be is what `adfric help NAME` says; an error says what is wrong in the words that the
!> program has for a namelist. Points are solved by the threads, in the blocks and with the first guesses of the program, so that
!> results are those of its file, to the bit. Nothing here stops the caller, prints, or changes handlers of signals and errors. A
!> simulation is for one thread at a time; different ones may be used by many threads at once. It is not to be copied: a copy is
!> closed.
!>
!> All but the solution of the points is done by one thread at a time (`critical (adfric_api)`), since gfortran keeps the lengths of
!> texts that functions give back in one index for all threads. The file is long by its public procedures, with a comment
!> on every argument.
module adfric_api
   use adfric, only: known_models
   use adfric_api_solution, only: solve_by_threads, stopped
   use adfric_api_state, only: open_model, read_state, case_state_t
   use adfric_api_numbers, only: find_extra
   use adfric_api_results, only: describe_name, find_axis, find_profile, find_result, list_of
   use adfric_base_error, only: error_t, file_failure, input_failure
   use adfric_base_kinds, only: dp, i8
   use adfric_base_text, only: name_length
   use adfric_base_words, only: count_words, get_word
   use adfric_input_text_table, only: data_table_t => text_table_t, new_data_table => new_table_of_numbers
   use adfric_describe_status, only: status_no_equilibrium, status_not_converged, status_solved
   use adfric_describe_table, only: profile_axis_t
   use adfric_run_progress, only: progress_t
   implicit none (type, external)
   private
   public :: simulation_t, open_simulation, open_scene, read_simulation, open_fit, data_table_t, new_data_table, list_models
   public :: error_t, dp, i8, name_length, progress_t
   public :: input_failure, file_failure, stopped
   public :: status_solved, status_no_equilibrium, status_not_converged

   !> A model, the values of its variables, and what was found.
   type :: simulation_t
      private
      !> The model with its points and values, and what was found.
      type(case_state_t) :: state
   contains
      procedure :: close => close_simulation
      procedure, private :: set_real
      procedure, private :: set_integer
      procedure, private :: set_logical
      procedure, private :: set_word
      procedure, private :: set_line
      procedure, private :: set_map
      generic :: set => set_real, set_integer, set_logical, set_word, set_line, set_map
      procedure :: unset
      procedure, private :: sweep_one
      procedure, private :: sweep_together
      generic :: sweep => sweep_one, sweep_together
      procedure :: n_points
      procedure :: check
      procedure :: solve
      procedure, private :: get_real
      procedure, private :: get_integer
      generic :: get => get_real, get_integer
      procedure :: get_profile
      procedure :: describe
      procedure :: list
      procedure, private :: copy
      generic :: assignment(=) => copy
   end type simulation_t

contains

   !> Open a model. All its variables have their default values, or none.
   subroutine open_simulation(self, model, error)
      !> Receives the simulation; closed if there is an error.
      type(simulation_t), intent(out) :: self
      !> Name of the model, such as 'sphere'.
      character(*), intent(in) :: model
      !> Allocated if there is no such model; says which there are.
      type(error_t), allocatable, intent(out) :: error

      !$omp critical (adfric_api)
      call open_model(self%state, model, error)
      !$omp end critical (adfric_api)
   end subroutine open_simulation

   !> Open a scene as the text of an input describes it. Some of its variables get their values afterwards, by `set` and `sweep`.
   !> The solver is chosen as if they had values; `check` and `solve` check all values together.
   subroutine open_scene(self, text, later, error)
      !> Receives the simulation; closed if there is an error.
      type(simulation_t), intent(out) :: self
      !> Text of the input.
      character(*), intent(in) :: text
      !> Names of the variables that get their values afterwards, such as `surface%heights`; blanks at their ends do not count.
      character(*), intent(in) :: later(:)
      !> Says what is wrong with the input or the names, a line each.
      type(error_t), allocatable, intent(out) :: error
      character(len(later)) :: names(size(later) + 1)

      ! an array constructor without elements would not be present
      names(:size(later)) = later
      !$omp critical (adfric_api)
      call read_state(self%state, text, is_text=.true., error=error, later=names(:size(later)))
      !$omp end critical (adfric_api)
   end subroutine open_scene

   !> Open a fit as the text of an input describes it. `&data file` names one of the tables, or a file. It is solved once; its results
   !> are those of the results file of `adfric fit`, and what a single fit has beside them.
   subroutine open_fit(self, text, tables, error)
      !> Receives the fit; closed if there is an error.
      type(simulation_t), intent(out) :: self
      !> Text of the input.
      character(*), intent(in) :: text
      !> The tables, made by `new_data_table`; there may be none.
      type(data_table_t), intent(in) :: tables(:)
      !> Says what is wrong with the input or the data, a line each.
      type(error_t), allocatable, intent(out) :: error

      !$omp critical (adfric_api)
      call read_state(self%state, text, is_text=.true., error=error, tables=tables)
      !$omp end critical (adfric_api)
   end subroutine open_fit

   !> Open a simulation as an input describes it, with its sweeps and its datasets, or a fit.
   subroutine read_simulation(self, path, error)
      !> Receives the simulation; closed if there is an error.
      type(simulation_t), intent(out) :: self
      !> Name of the input.
      character(*), intent(in) :: path
      !> Says what is wrong with the input, a line each.
      type(error_t), allocatable, intent(out) :: error

      !$omp critical (adfric_api)
      call read_state(self%state, path, is_text=.false., error=error)
      !$omp end critical (adfric_api)
   end subroutine read_simulation

   !> Close a simulation, and give back its memory. It may be opened again.
   subroutine close_simulation(self)
      !> The simulation, open or closed.
      class(simulation_t), intent(inout) :: self

      !$omp critical (adfric_api)
      call self%state%close()
      !$omp end critical (adfric_api)
   end subroutine close_simulation

   !> Names of all models.
   function list_models() result(names)
      character(name_length), allocatable :: names(:)
      integer :: i

      allocate (names(count_words(known_models)))
      !$omp critical (adfric_api)
      do i = 1, size(names)
         names(i) = get_word(known_models, i)
      end do
      !$omp end critical (adfric_api)
   end function list_models

   !> Set a variable that is a number. It is not swept any more.
   subroutine set_real(self, name, value, error)
      !> The simulation; unchanged if there is an error.
      class(simulation_t), intent(inout) :: self
      !> Name of the variable, or `group%name` where several groups have one.
      character(*), intent(in) :: name
      !> Value in the SI unit of the variable.
      real(dp), intent(in) :: value
      !> Not allocated if the value is set.
      type(error_t), allocatable, intent(out) :: error

      !$omp critical (adfric_api)
      call self%state%give(name, value, error)
      !$omp end critical (adfric_api)
   end subroutine set_real

   !> Set a variable that is a number, by an integer.
   subroutine set_integer(self, name, value, error)
      !> The simulation; unchanged if there is an error.
      class(simulation_t), intent(inout) :: self
      !> Name of the variable, or `group%name` where several groups have one.
      character(*), intent(in) :: name
      !> Value in the SI unit of the variable.
      integer, intent(in) :: value
      !> Not allocated if the value is set.
      type(error_t), allocatable, intent(out) :: error

      !$omp critical (adfric_api)
      call self%state%give(name, value, error)
      !$omp end critical (adfric_api)
   end subroutine set_integer

   !> Set a variable that is true or false.
   subroutine set_logical(self, name, value, error)
      !> The simulation; unchanged if there is an error.
      class(simulation_t), intent(inout) :: self
      !> Name of the variable, or `group%name` where several groups have one.
      character(*), intent(in) :: name
      !> Value of the variable.
      logical, intent(in) :: value
      !> Not allocated if the value is set.
      type(error_t), allocatable, intent(out) :: error

      !$omp critical (adfric_api)
      call self%state%give(name, value, error)
      !$omp end critical (adfric_api)
   end subroutine set_logical

   !> Set a variable that is one of several words.
   subroutine set_word(self, name, value, error)
      !> The simulation; unchanged if there is an error.
      class(simulation_t), intent(inout) :: self
      !> Name of the variable, or `group%name` where several groups have one.
      character(*), intent(in) :: name
      !> The word; blanks at its end do not count.
      character(*), intent(in) :: value
      !> Not allocated if the value is set.
      type(error_t), allocatable, intent(out) :: error

      !$omp critical (adfric_api)
      call self%state%give(name, value, error)
      !$omp end critical (adfric_api)
   end subroutine set_word

   !> Set a variable that is a list of numbers, or a dataset of one dimension, in place of the name of a file.
   subroutine set_line(self, name, values, error)
      !> The simulation; after an error the dataset is not given.
      class(simulation_t), intent(inout) :: self
      !> Name of the variable, or `group%name` where several groups have one.
      character(*), intent(in) :: name
      !> Values of the dataset in the SI unit of the variable.
      real(dp), intent(in) :: values(:)
      !> Not allocated if the values are set.
      type(error_t), allocatable, intent(out) :: error

      !$omp critical (adfric_api)
      call self%state%give_dataset(name, reshape(values, [size(values), 1]), 1, error)
      !$omp end critical (adfric_api)
   end subroutine set_line

   !> Set a variable that is a dataset of two dimensions, or the columns of a group, in place of the name of a file.
   subroutine set_map(self, name, values, error)
      !> The simulation; after an error the dataset is not given.
      class(simulation_t), intent(inout) :: self
      !> Name of the variable, or `group%name` where several groups have one.
      character(*), intent(in) :: name
      !> Values of the dataset in the SI unit of the variable; shape `(nx, ny)`, which h5py shows as `(ny, nx)`;
      !> of columns `(n, n_columns)`.
      real(dp), intent(in) :: values(:, :)
      !> Not allocated if the values are set.
      type(error_t), allocatable, intent(out) :: error

      !$omp critical (adfric_api)
      call self%state%give_dataset(name, values, 2, error)
      !$omp end critical (adfric_api)
   end subroutine set_map

   !> Give a variable its default value again, or none. It is not swept any more.
   subroutine unset(self, name, error)
      !> The simulation; unchanged if there is an error.
      class(simulation_t), intent(inout) :: self
      !> Name of the variable, or `group%name` where several groups have one.
      character(*), intent(in) :: name
      !> Allocated if there is no such variable.
      type(error_t), allocatable, intent(out) :: error

      !$omp critical (adfric_api)
      call self%state%take_back(name, error)
      !$omp end critical (adfric_api)
   end subroutine unset

   !> Sweep a variable. Several sweeps make the outer product of their values; the variable that is swept last varies fastest. A
   !> variable that is swept already takes the new values in the same index.
   subroutine sweep_one(self, name, values, error)
      !> The simulation; unchanged if there is an error.
      class(simulation_t), intent(inout) :: self
      !> Name of the variable, or `group%name` where several groups have one.
      character(*), intent(in) :: name
      !> Values of the variable in its SI unit, in any order.
      real(dp), intent(in) :: values(:)
      !> Not allocated if the variable is swept.
      type(error_t), allocatable, intent(out) :: error

      !$omp critical (adfric_api)
      call self%state%sweep([name], reshape(values, [size(values), 1]), error)
      !$omp end critical (adfric_api)
   end subroutine sweep_one

   !> Sweep several variables together: each row of the values is a point, or one for each combination with other sweeps.
   subroutine sweep_together(self, names, values, error)
      !> The simulation; unchanged if there is an error.
      class(simulation_t), intent(inout) :: self
      !> Names of the variables, or `group%name` where several groups have one; blanks at their ends do not count.
      character(*), intent(in) :: names(:)
      !> Values of the variables in their SI units; shape `(n_values, n_names)`.
      real(dp), intent(in) :: values(:, :)
      !> Not allocated if the variables are swept.
      type(error_t), allocatable, intent(out) :: error

      !$omp critical (adfric_api)
      call self%state%sweep(names, values, error)
      !$omp end critical (adfric_api)
   end subroutine sweep_together

   !> Number of points: 1 where nothing is swept, 0 where the simulation is closed.
   integer(i8) function n_points(self)
      !> The simulation, open or closed.
      class(simulation_t), intent(in) :: self

      n_points = 0
      if (allocated(self%state%run%model)) n_points = self%state%run%plan%n_points()
   end function n_points

   !> Check all values together, as `solve` does before it solves.
   subroutine check(self, error)
      !> The simulation; its values stay as they are.
      class(simulation_t), intent(inout) :: self
      !> Says what is missing, contradictory or impossible, a line each.
      type(error_t), allocatable, intent(out) :: error

      !$omp critical (adfric_api)
      call self%state%check_open(error)
      if (.not. allocated(error)) call self%state%check_case(error)
      !$omp end critical (adfric_api)
   end subroutine check

   !> Solve all points. A point without equilibrium, or that did not converge, is no error: see its status.
   subroutine solve(self, error, n_threads, progress)
      !> The simulation; after an error it has no results.
      class(simulation_t), intent(inout) :: self
      !> Says what is missing, contradictory or impossible, a line each, or what the machine has too little of.
      type(error_t), allocatable, intent(out) :: error
      !> Number of threads, >= 1; as many as OpenMP gives if absent. The results do not depend on it.
      integer, intent(in), optional :: n_threads
      !> Is told from time to time how many points are solved, and may end the call: the code of the error is `stopped` then.
      class(progress_t), intent(inout), optional :: progress

      call self%check(error)
      self%state%is_spent = self%state%is_fit
      if (.not. allocated(error)) call solve_by_threads(self%state%run, self%state%found, error, n_threads, progress)
   end subroutine solve

   !> Get a result of every point, the error estimate or the status, or the coordinates along an axis of the profiles.
   subroutine get_real(self, name, values, error)
      !> The simulation, which is solved.
      class(simulation_t), intent(in) :: self
      !> Name of the result, 'error_estimate', 'status', the name of an axis, or of what a single fit has beside its results.
      character(*), intent(in) :: name
      !> Receives the values in the unit that `describe` says, NaN where there is none; shape `(n_points)`, the variable that was
      !> swept last varies fastest; of an axis `(n_coordinates)`.
      real(dp), allocatable, intent(out) :: values(:)
      !> Allocated if there is no such result, or nothing is solved.
      type(error_t), allocatable, intent(out) :: error
      type(profile_axis_t), allocatable :: axes(:)
      integer :: axis

      !$omp critical (adfric_api)
      call self%state%check_solved(error)
      axis = 0
      if (.not. (allocated(error) .or. self%state%is_fit)) axis = find_axis(self%state%run%model, name)
      if (axis > 0) then
         call self%state%run%model%get_profile_axes(self%state%run%plan%base, axes)
         values = axes(axis)%coordinates
      else if (.not. allocated(error)) then
         call find_extra(self%state%run%model, name, values)
      end if
      if (.not. (allocated(error) .or. allocated(values))) then
         call find_result(self%state%run%model, self%state%found, name, values, error)
      end if
      !$omp end critical (adfric_api)
   end subroutine get_real

   !> Get a result of every point that is one of several states, such as the status, as the number of the state.
   subroutine get_integer(self, name, values, error)
      !> The simulation, which is solved.
      class(simulation_t), intent(in) :: self
      !> Name of the result.
      character(*), intent(in) :: name
      !> Receives the numbers, -1 where there is none; shape `(n_points)`, the variable that was swept last varies fastest.
      integer, allocatable, intent(out) :: values(:)
      !> Allocated if there is no such result, it has no states, or nothing is solved.
      type(error_t), allocatable, intent(out) :: error

      !$omp critical (adfric_api)
      call self%state%check_solved(error)
      if (.not. allocated(error)) call find_result(self%state%run%model, self%state%found, name, values, error)
      !$omp end critical (adfric_api)
   end subroutine get_integer

   !> Get a profile of a point. Profiles are kept where they were asked for: `set('profiles', .true.)` before `solve`.
   subroutine get_profile(self, name, point, values, error)
      !> The simulation, which is solved.
      class(simulation_t), intent(in) :: self
      !> Name of the profile.
      character(*), intent(in) :: name
      !> Number of the point, from 1.
      integer(i8), intent(in) :: point
      !> Receives the profile, NaN if the point is not solved; shape `(n_last, n_first)`, the lengths of the last and the first of
      !> the axes that `list` names; n_first = 1 where there is one axis.
      real(dp), allocatable, intent(out) :: values(:, :)
      !> Allocated if there is no such profile or point, or profiles were not asked for.
      type(error_t), allocatable, intent(out) :: error

      !$omp critical (adfric_api)
      call self%state%check_solved(error)
      if (.not. allocated(error)) call find_profile(self%state%run%model, self%state%found, name, point, values, error)
      !$omp end critical (adfric_api)
   end subroutine get_profile

   !> Say what a variable, a result, a profile or an axis is. Units that depend on other variables are right once these are set.
   subroutine describe(self, name, unit, long_name, error, meanings)
      !> The simulation, which is open.
      class(simulation_t), intent(in) :: self
      !> Name of the variable, result, profile or axis; what is both a variable and a result is described as a result.
      character(*), intent(in) :: name
      !> Receives the SI unit, `-` for a pure number, empty where there is none.
      character(:), allocatable, intent(out) :: unit
      !> Receives a few words.
      character(:), allocatable, intent(out) :: long_name
      !> Allocated if there is no such name.
      type(error_t), allocatable, intent(out) :: error
      !> Receives the states of a result from number 0 on, or the words that a variable may be, separated by a blank; else empty.
      character(:), allocatable, intent(out), optional :: meanings

      character(:), allocatable :: words

      !$omp critical (adfric_api)
      call self%state%check_open(error)
      if (.not. allocated(error)) call describe_name(self%state%run%model, self%state%input, name, unit, long_name, words, error)
      !$omp end critical (adfric_api)
      ! gfortran loses the length of an optional text that is handed on
      if (present(meanings) .and. allocated(words)) meanings = words
   end subroutine describe

   !> List names of the model.
   subroutine list(self, what, names, error)
      !> The simulation, which is open.
      class(simulation_t), intent(in) :: self
      !> 'variables', 'results', 'profiles', 'axes', or 'extras': what a single fit that is solved has beside its results.
      character(*), intent(in) :: what
      !> Receives the names; axes from the slowest to the fastest.
      character(name_length), allocatable, intent(out) :: names(:)
      !> Allocated if there is no such list.
      type(error_t), allocatable, intent(out) :: error

      !$omp critical (adfric_api)
      call self%state%check_open(error)
      if (.not. allocated(error)) call list_of(self%state%run%model, self%state%input, what, names, error)
      !$omp end critical (adfric_api)
   end subroutine list

   !> A copy is closed: what a model keeps for its points belongs to one simulation.
   subroutine copy(self, other)
      !> The simulation, which is closed.
      class(simulation_t), intent(inout) :: self
      !> The simulation that stays as it is.
      class(simulation_t), intent(in) :: other

      call self%close()
      associate (unused => other)
      end associate
   end subroutine copy

end module adfric_api
