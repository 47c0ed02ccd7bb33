! SPDX-License-Identifier: GPL-3.0-or-later
!> The tables in which a model declares its variables, its results and its profiles.
module adfric_describe_table
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: unset
   use adfric_base_words, only: count_words
   use adfric_describe_doubt, only: doubt_meanings, doubt_name
   use adfric_describe_status, only: status_meanings
   implicit none (type, external)
   private
   public :: variable_t, result_t, profile_t, profile_axis_t, count_t, extra_t
   public :: results_of_every_run, doubt_row, common_results, take_units
   public :: kind_real, kind_integer, kind_logical, kind_choice, kind_dataset, kind_text

   !> Kinds of namelist variables. No model has a text: names of files and the like stand in the groups that every model shares.
   integer, parameter :: kind_real = 1, kind_integer = 2, kind_logical = 3, kind_choice = 4, kind_dataset = 5, kind_text = 6

   !> A namelist variable. Every kind is kept as a real number: integers as they are, logicals as 0 and 1,
   !> choices as their index in `choices` (from 1), datasets of a file as 1, and what was not given as `unset`.
   type :: variable_t
      !> Group it stands in, without `&`.
      character(:), allocatable :: group
      !> Name in its group.
      character(:), allocatable :: name
      !> One of `kind_...`.
      integer :: kind = kind_real
      !> SI unit, `-` for a pure number, empty for logicals and choices.
      character(:), allocatable :: unit
      !> What it is, for `adfric help`.
      character(:), allocatable :: meaning
      !> Allowed words, separated by a blank; empty unless it is a choice.
      character(:), allocatable :: choices
      !> May a choice be several of its words at once? Its value has a bit for each then (`adfric_describe_word_sets`).
      logical :: takes_several = .false.
      !> Value where the user gives none; `unset` if there is no default.
      real(dp) :: default = unset
      !> Least and largest value that is allowed, of a dataset that of each of its values.
      real(dp) :: lower = -unset, upper = unset
      !> Is the bound itself not allowed?
      logical :: lower_open = .false., upper_open = .false.
      !> Does 0, its default, leave a number to the solver, such as that of strips?
      logical :: zero_is_automatic = .false.
      !> What an integer has to be a multiple of.
      integer :: multiple_of = 1
      !> Number of dimensions that a dataset may have at most, 1 or 2, and of values that it needs along each.
      integer :: largest_rank = 1, least_count = 1
      !> Most values that a dataset may have along each dimension.
      integer :: most_count = huge(1)
      !> May a dataset lack values, which are NaN then?
      logical :: may_lack_values = .false.
      !> May the numbers of a dataset of one dimension stand in the input, in place of the name of the dataset?
      logical :: is_list = .false.
      !> Names of the datasets of one dimension and equal length that the variable takes from a group of a file, and their SI units,
      !> each separated by a blank; empty where it takes one dataset.
      character(:), allocatable :: columns, column_units
      !> Names of the numbers that the model takes from the attributes of the dataset or group where they are there, and their SI
      !> units, each separated by a blank; empty if it takes none.
      character(:), allocatable :: attributes, attribute_units
      !> Where several groups have the name: may a sweep mean this one without the group?
      logical :: has_bare_name = .true.
      !> May a real number have some values alone, so that nothing varies with it? Such are angles of a solver with four directions.
      logical :: has_steps = .false.
      !> Sizes that it usually has, where they are others than those of its unit (`adfric_describe_plausible_range`).
      real(dp) :: usual_lower = unset, usual_upper = unset
      !> Group and name in the language of the solver, where a scene calls the variable otherwise; else not allocated.
      character(:), allocatable :: solver_group, solver_name
      !> Has the variable no meaning in the scene? It cannot be given then, and nobody hears of it.
      logical :: is_hidden = .false.
   contains
      procedure :: n_columns
      procedure :: n_attributes
      procedure :: is_called
      procedure :: own_name
   end type variable_t

   !> A result per point.
   type :: result_t
      !> Name of its dataset in the results file.
      character(:), allocatable :: name
      !> SI unit, `-` for a pure number.
      character(:), allocatable :: unit
      !> What it is, for `adfric help` and the results file.
      character(:), allocatable :: long_name
      !> Meanings of 0, 1, 2, ... separated by a blank, where the result is an enumerated state; else empty.
      character(:), allocatable :: flag_meanings
      !> Does it stand in the table at the end of a run?
      logical :: is_main = .false.
      !> Is it found by counting, such as an area by cells, so that it varies in steps?
      logical :: is_counted = .false.
      !> Is it continuous, with small jumps of its slope everywhere, such as an area by chords?
      logical :: has_bends = .false.
      !> Name in the language of the solver, where a scene calls the result otherwise; else not allocated.
      character(:), allocatable :: solver_name
      !> Has the result no meaning in the scene? It is absent from the file then, and nobody hears of it.
      logical :: is_hidden = .false.
   contains
      procedure :: n_states
   end type result_t

   !> A result along the profile axes.
   type :: profile_t
      !> Name of its dataset in the results file.
      character(:), allocatable :: name
      !> SI unit, `-` for a pure number.
      character(:), allocatable :: unit
      !> What it is, for `adfric help` and the results file.
      character(:), allocatable :: long_name
   end type profile_t

   !> An axis of the profiles of a case.
   type :: profile_axis_t
      !> Name of its dataset in the results file.
      character(:), allocatable :: name
      !> SI unit, `-` for a pure number.
      character(:), allocatable :: unit
      !> What it is, for the results file.
      character(:), allocatable :: long_name
      !> Coordinates along the axis, in this unit; a single one if the profiles of the case do not vary along it.
      real(dp), allocatable :: coordinates(:)
   end type profile_axis_t

   !> Something that a model counts while it solves, such as the strips that it took. The results file has the mean over all
   !> points of a run.
   type :: count_t
      !> Name of the count, which is that of the attribute with the mean.
      character(:), allocatable :: name
      !> What is counted, for `adfric help`.
      character(:), allocatable :: long_name
   end type count_t

   !> A dataset of any shape, whose values are known when the results file is created.
   type :: extra_t
      !> Name of its dataset in the results file.
      character(:), allocatable :: name
      !> SI unit, `-` for a pure number.
      character(:), allocatable :: unit
      !> What it is, for the results file.
      character(:), allocatable :: long_name
      !> Names of the datasets that are the scales of its dimensions, the slowest first, separated by a blank; its own name makes it
      !> a scale itself.
      character(:), allocatable :: dimensions
      !> Number of values along each dimension, the slowest first.
      integer, allocatable :: counts(:)
      !> Values, the last dimension fastest; not allocated where it has words.
      real(dp), allocatable :: values(:)
      !> Words, separated by a blank, one for each index along its one dimension; not allocated where it has numbers.
      character(:), allocatable :: words
      !> Meanings of `first_flag`, `first_flag + 1`, ... separated by a blank, where the values are enumerated states; else not
      !> allocated.
      character(:), allocatable :: flag_meanings
      !> The state that the first of these meanings is of.
      integer :: first_flag = 0
   end type extra_t

contains

   !> The results that every model has beside those of its table: of a point, the last ones of the file.
   pure function results_of_every_run(states) result(results)
      !> Names of the states of a point, separated by a blank; not present: `status_meanings`.
      character(*), intent(in), optional :: states
      type(result_t) :: results(2)

      results(1) = result_t(name='error_estimate', unit='-', long_name='relative error of the main result, estimated', &
         & flag_meanings='')
      results(2) = result_t(name='status', unit='-', long_name='whether the point was solved', flag_meanings=status_meanings)
      if (present(states)) results(2)%flag_meanings = states
   end function results_of_every_run

   !> The result of every run of a model that says whether a point lies beyond a bound of its theory.
   pure type(result_t) function doubt_row() result(row)
      row = result_t(name=doubt_name, unit='-', long_name='bound of the theory that the point lies beyond', &
         & flag_meanings=doubt_meanings)
   end function doubt_row

   !> The results that every model has beside those of its table, the doubt first.
   pure function common_results() result(results)
      type(result_t) :: results(3)

      results(1) = doubt_row()
      results(2:) = results_of_every_run()
   end function common_results

   !> Number of datasets that a variable takes from a group of a file; 0 if it takes no group.
   pure integer function n_columns(self)
      class(variable_t), intent(in) :: self

      n_columns = 0
      if (allocated(self%columns)) n_columns = count_words(self%columns)
   end function n_columns

   !> Number of attributes of a dataset or group that a model takes.
   pure integer function n_attributes(self)
      class(variable_t), intent(in) :: self

      n_attributes = 0
      if (allocated(self%attributes)) n_attributes = count_words(self%attributes)
   end function n_attributes

   !> Give results the units that the same rows have for another case; what they are called stays.
   pure subroutine take_units(rows, results)
      !> The rows with the units of the case.
      type(result_t), intent(in) :: rows(:)
      !> Results of the model, in the same order.
      type(result_t), intent(inout) :: results(:)
      integer :: i

      do i = 1, size(results)
         results(i)%unit = rows(i)%unit
      end do
   end subroutine take_units

   !> Name of a variable in the language of the solver.
   pure function own_name(self) result(name)
      class(variable_t), intent(in) :: self
      character(:), allocatable :: name

      name = self%name
      if (allocated(self%solver_name)) name = self%solver_name
   end function own_name

   !> Is this the name that the solver has for a variable, whatever the scene calls it?
   pure logical function is_called(self, group, name)
      class(variable_t), intent(in) :: self
      !> Group and name in the language of the solver.
      character(*), intent(in) :: group, name

      if (allocated(self%solver_group)) then
         is_called = self%solver_group == group .and. self%solver_name == name
      else
         is_called = self%group == group .and. self%name == name
      end if
   end function is_called

   !> Number of states of an enumerated result; 0 for a number.
   pure integer function n_states(self)
      class(result_t), intent(in) :: self

      n_states = 0
      if (allocated(self%flag_meanings)) n_states = count_words(self%flag_meanings)
   end function n_states

end module adfric_describe_table
