! SPDX-License-Identifier: GPL-3.0-or-later
!> What the program knows of a model: its namelist variables, its results, and how to solve points.
!>
!> A model declares its variables and results in tables. Input, help, sweeps and the results file are
!> driven by these tables, so a new model needs no change in any of them. The file is long by its interface, whose every argument
!> is described for all models.
module adfric_describe_model
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set, unset
   use adfric_base_watch, only: asks_for_end, watch_t
   use adfric_describe_derived, only: derived_t
   use adfric_describe_profile_receiver, only: profile_receiver_t
   use adfric_describe_status, only: status_solved, status_meanings
   use adfric_describe_table, only: variable_t, result_t, profile_t, profile_axis_t, count_t, extra_t
   implicit none (type, external)
   private
   public :: model_t, derived_t

   !> A model.
   type, abstract :: model_t
      !> Name in `&job model = ...`.
      character(:), allocatable :: name
      !> One line for `adfric help`.
      character(:), allocatable :: summary
      !> Where the model was published, for the results file; empty if nowhere.
      character(:), allocatable :: references
      !> Namelist variables, shape `(n_variables)`; values are passed in this order.
      type(variable_t), allocatable :: variables(:)
      !> Results, shape `(n_results)`, without `status` and `error_estimate`, which every model has.
      type(result_t), allocatable :: results(:)
      !> Profiles; size 0 if the model has none.
      type(profile_t), allocatable :: profiles(:)
      !> What the model counts while it solves, shape `(n_counts)`; size 0 if it counts nothing.
      type(count_t), allocatable :: counts(:)
      !> Names of the profile axes, one or two, the slowest first, separated by a blank: 'x' or 'y x'.
      character(:), allocatable :: profile_axes
      !> Names of datasets that the results file may have beside results and profiles, separated by a blank; not allocated: none.
      character(:), allocatable :: extra_names
      !> Most points of a block, for points that take long and have little of their neighbours: other threads take the rest.
      integer :: largest_block = huge(1)
      !> May several threads share the work of one point?
      logical :: shares_points = .false.
      !> What is solved, in words, where the input describes a scene and names no model; else not allocated.
      character(:), allocatable :: scene
      !> Names `group%name` that the choice of the solver has read already, separated by a blank; not allocated: none.
      character(:), allocatable :: scene_names
      !> Variables of the input that this scene does not have, but another one: of each `group%name` and the nearest such scene, on a line
      !> of its own. Not allocated: none.
      character(:), allocatable :: of_other_scenes
      !> Whom points that take long ask whether the run shall end; null: nobody.
      class(watch_t), pointer :: watch => null()
   contains
      procedure(check_values_i), deferred :: check_values
      procedure(wants_profiles_i), deferred :: wants_profiles
      procedure(get_profile_axes_i), deferred :: get_profile_axes
      procedure(solve_block_i), deferred :: solve_block
      procedure(solve_profiles_i), deferred :: solve_profiles
      procedure :: prepare
      procedure :: release
      procedure :: obey
      procedure :: is_stopped
      procedure :: solve_block_and_profiles
      procedure :: solve_with_slopes
      procedure :: take_dataset
      procedure :: take_attribute
      procedure :: describe_results
      procedure :: list_states
      procedure :: get_extras
      procedure :: derive_quantities
      procedure :: get_derived
      procedure :: describe_case
      procedure :: measure
      procedure :: describe_doubts
      procedure :: velocity_of_heat
      procedure :: get_nominal_sizes
      procedure :: count_profiles
      procedure :: describe_profiles
      procedure :: profile_shape
      procedure :: unit_of
      procedure :: index_of
      procedure :: solver_index_of
   end type model_t

   abstract interface

      !> Add to `problems` whatever is contradictory or impossible in the values together.
      subroutine check_values_i(self, values, is_swept, problems)
         import :: model_t, dp, problems_t
         implicit none (type, external)
         !> The model, whose table of variables is read.
         class(model_t), intent(in) :: self
         !> Values of the variables; shape `(n_variables)`. Of a swept variable one of its values stands here.
         real(dp), intent(in) :: values(:)
         !> Is the variable swept? Shape `(n_variables)`.
         logical, intent(in) :: is_swept(:)
         !> Receives what is wrong with the input; nothing is removed.
         type(problems_t), intent(inout) :: problems
      end subroutine check_values_i

      !> Does the user ask for profiles?
      pure logical function wants_profiles_i(self, values)
         import :: model_t, dp
         implicit none (type, external)
         !> The model, whose `profiles` may be empty.
         class(model_t), intent(in) :: self
         !> Values of the variables; shape `(n_variables)`.
         real(dp), intent(in) :: values(:)
      end function wants_profiles_i

      !> The axes of the profiles, which all points of a run share.
      subroutine get_profile_axes_i(self, values, axes)
         import :: model_t, dp, profile_axis_t
         implicit none (type, external)
         !> The model, whose profiles have the axes.
         class(model_t), intent(in) :: self
         real(dp), intent(in) :: values(:)
         !> Receives the axes in the order of their names `profile_axes`.
         type(profile_axis_t), allocatable, intent(out) :: axes(:)
      end subroutine get_profile_axes_i

      !> Solve neighbouring points. What one point finds may start the next one within this block only.
      subroutine solve_block_i(self, values, results, error_estimate, status, counts)
         import :: model_t, dp
         implicit none (type, external)
         !> The model; all threads solve with the same one.
         class(model_t), intent(in) :: self
         !> Values of the variables for each point; shape `(n_variables, n_points)`.
         real(dp), intent(in), contiguous :: values(:, :)
         !> Receives the results of each point; shape `(n_results, n_points)`; NaN where there is no value.
         real(dp), intent(out) :: results(:, :)
         !> Relative error of the main result, estimated; shape `(n_points)`.
         real(dp), intent(out) :: error_estimate(:)
         !> One of `status_...` for each point; shape `(n_points)`.
         integer, intent(out) :: status(:)
         !> Receives what was counted at the points of the block, in the order of the table `counts`; shape `(n_counts)`.
         real(dp), intent(out) :: counts(:)
      end subroutine solve_block_i

      !> Profiles of one solved point.
      subroutine solve_profiles_i(self, values, results, profiles)
         import :: model_t, dp
         implicit none (type, external)
         class(model_t), intent(in) :: self
         real(dp), intent(in) :: values(:)
         !> Results that `solve_block` found for this point; shape `(n_results)`.
         real(dp), intent(in) :: results(:)
         !> Receives the profiles; shape `(n_last_axis, n_first_axis, n_profiles)`: x runs fastest; a missing axis has size 1.
         real(dp), intent(out) :: profiles(:, :, :)
      end subroutine solve_profiles_i

   end interface

contains

   !> Make space for what points share, so that it is found once, whichever block and thread needs it first. It saves time and
   !> changes no bit of the results. `release` gives the space back when the points are solved. Here there is nothing; a model with
   !> something costly of that kind overrides both.
   subroutine prepare(self)
      class(model_t), intent(inout) :: self

      associate (unused => self)
      end associate
   end subroutine prepare

   !> Give back what `prepare` has made.
   subroutine release(self)
      class(model_t), intent(inout) :: self

      associate (unused => self)
      end associate
   end subroutine release

   !> From now on somebody may end the solution of points before its time, or nobody any more.
   subroutine obey(self, watch)
      class(model_t), intent(inout) :: self
      !> Who is asked, as long as he is there; null: nobody.
      class(watch_t), pointer, intent(in) :: watch

      self%watch => watch
   end subroutine obey

   !> Shall the solution of points end before its time?
   logical function is_stopped(self)
      class(model_t), intent(in) :: self

      is_stopped = asks_for_end(self%watch)
   end function is_stopped

   !> Solve neighbouring points as `solve_block` does, to the same bits, and hand over the profiles of those that are solved. A
   !> model whose points would be solved once more for their profiles overrides it.
   subroutine solve_block_and_profiles(self, values, results, error_estimate, status, counts, profiles, receiver)
      class(model_t), intent(in) :: self
      !> Values of the variables for each point; shape `(n_variables, n_points)`.
      real(dp), intent(in), contiguous :: values(:, :)
      !> Receives the results of each point; shape `(n_results, n_points)`; NaN where there is no value.
      real(dp), intent(out) :: results(:, :)
      !> Relative error of the main result, estimated; shape `(n_points)`.
      real(dp), intent(out) :: error_estimate(:)
      !> One of `status_...` for each point; shape `(n_points)`.
      integer, intent(out) :: status(:)
      !> Receives what was counted at the points of the block, in the order of the table `counts`; shape `(n_counts)`.
      real(dp), intent(out) :: counts(:)
      !> Space for the profiles of one point, of their shape; what stands in it at the end has no meaning.
      real(dp), intent(inout) :: profiles(:, :, :)
      !> Takes the profiles of one solved point after the other, and says whether more are wanted.
      class(profile_receiver_t), intent(inout) :: receiver
      integer :: i
      logical :: goes_on

      call self%solve_block(values, results, error_estimate, status, counts)
      do i = 1, size(status)
         if (status(i) /= status_solved) cycle
         call self%solve_profiles(values(:, i), results(:, i), profiles)
         call receiver%take(i, profiles, goes_on)
         if (.not. goes_on) return
      end do
   end subroutine solve_block_and_profiles

   !> A result over an abscissa of fits, with its derivatives in closed form: here there are none. A model that has some overrides it.
   subroutine solve_with_slopes(self, values, x, of, by, members, y, y_by, is_known, error_estimate, is_there)
      class(model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`. That of the abscissa is any.
      real(dp), intent(in) :: values(:)
      !> Values of the abscissa of fits; shape `(n_points)`.
      real(dp), intent(in) :: x(:)
      !> Index of the result.
      integer, intent(in) :: of
      !> Indices of the variables by which derivatives are wanted, and which member of a list it is, 0: none; shape `(n_wanted)`.
      integer, intent(in) :: by(:), members(:)
      !> Receives the result; shape `(n_points)`.
      real(dp), intent(out) :: y(:)
      !> Receives the derivatives, 0 where they are not known; shape `(n_points, n_wanted)`.
      real(dp), intent(out) :: y_by(:, :)
      !> Receives by which variables the derivatives are known; shape `(n_wanted)`.
      logical, intent(out) :: is_known(:)
      !> Relative error of the result, estimated.
      real(dp), intent(out) :: error_estimate
      !> Receives whether there is a closed form for all these points; without one nothing else has a meaning.
      logical, intent(out) :: is_there

      y = 0
      y_by = 0
      is_known = .false.
      error_estimate = 0
      is_there = .false.
      associate (unused => self, unused_values => values, unused_x => x, unused_of => of)
      end associate
      associate (unused_by => by, unused_members => members)
      end associate
   end subroutine solve_with_slopes

   !> Take over the values of a dataset, a list or the columns of a group; called for every one that is given, in the order of the
   !> table, before the values are checked. They are finite and within the table's bounds. A model with such variables overrides it;
   !> here nothing is kept.
   subroutine take_dataset(self, index, values, problems)
      class(model_t), intent(inout) :: self
      !> Index of the dataset in `variables`.
      integer, intent(in) :: index
      !> Values of the dataset; shape `(n_last, n_first)`, the dimensions of the file in reverse: what h5py shows as `(ny, nx)` is
      !> `(nx, ny)` here. A dataset of one dimension, or a list of numbers, is `(n, 1)`; the columns of a group are
      !> `(n, n_columns)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      associate (unused => self, unused_index => index, unused_values => values, unused_problems => problems)
      end associate
   end subroutine take_dataset

   !> Take over a number from the attributes of a dataset or group; called behind `take_dataset` for every attribute of the row
   !> that is there, in the order of the row. A model with such rows overrides it; here nothing is kept.
   subroutine take_attribute(self, index, name, value, problems)
      class(model_t), intent(inout) :: self
      !> Index of the dataset in `variables`.
      integer, intent(in) :: index
      !> Name of the attribute, one of those of the row.
      character(*), intent(in) :: name
      !> The number, which is finite, in the SI unit that the row says.
      real(dp), intent(in) :: value
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      associate (unused => self, unused_index => index, unused_name => name, unused_value => value, unused_problems => problems)
      end associate
   end subroutine take_attribute

   !> The results with their units for this case (forces per width in N/m or forces in N); here those of the table. A model whose
   !> units depend on the case overrides it.
   function describe_results(self, values) result(results)
      class(model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(result_t), allocatable :: results(:)

      results = self%results
      associate (unused => values)
      end associate
   end function describe_results

   !> Names of the states of a point in the order of their numbers from 0, separated by a blank. A model whose points are something
   !> else overrides it.
   function list_states(self) result(words)
      class(model_t), intent(in) :: self
      character(:), allocatable :: words

      words = status_meanings
      associate (unused => self)
      end associate
   end function list_states

   !> What else stands in the results file, with its values, which are known before any point is solved: nothing here. A model that
   !> has something overrides it.
   subroutine get_extras(self, extras)
      class(model_t), intent(in) :: self
      !> Receives the datasets with their values.
      type(extra_t), allocatable, intent(out) :: extras(:)

      allocate (extras(0))
      associate (unused => self)
      end associate
   end subroutine get_extras

   !> Quantities that follow from the values, which have been checked, for `adfric check` and the results file: none here. A
   !> model that has some overrides it.
   function derive_quantities(self, values) result(derived)
      class(model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: derived(:)

      allocate (derived(0))
      associate (unused => self, unused_too => values)
      end associate
   end function derive_quantities

   !> The derived quantities but for those that the user has given by a variable of the same name. One that is a variable has its
   !> name in the language of the scene.
   function get_derived(self, values) result(derived)
      !> The model, whose table of variables and derived quantities are read.
      class(model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: derived(:)
      logical, allocatable :: is_given(:)
      integer :: i, k

      derived = self%derive_quantities(values)
      allocate (is_given(size(derived)), source=.false.)
      do i = 1, size(derived)
         do k = 1, size(self%variables)
            if (self%variables(k)%own_name() /= derived(i)%name) cycle
            is_given(i) = is_given(i) .or. is_set(values(k))
            ! a quantity that a scene counts otherwise has one word for its name, and keeps it
            if (.not. self%variables(k)%is_hidden .and. index(derived(i)%name, '_') > 0) derived(i)%name = self%variables(k)%name
         end do
      end do
      derived = pack(derived, .not. is_given)
   end function get_derived

   !> What else there is to say of the resolved case, a line each, for `adfric check`: nothing here.
   function describe_case(self, values) result(text)
      class(model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = ''
      associate (unused => self, unused_too => values)
      end associate
   end function describe_case

   !> What in the case may not be what the user means, a line each, for `adfric check` and the summary of a run. Here nothing is
   !> doubted.
   function describe_doubts(self, values) result(text)
      class(model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = ''
      associate (unused => self, unused_too => values)
      end associate
   end function describe_doubts

   !> Velocity from which on the heat of a point's friction changes its shear stress by a hundredth, whether the input counts heat or
   !> not [m/s]. Here it is not set, as where there is none.
   real(dp) function velocity_of_heat(self, values) result(velocity)
      class(model_t), intent(in) :: self
      !> Values of the variables, which have been checked; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      velocity = unset
      associate (unused => self, unused_too => values)
      end associate
   end function velocity_of_heat

   !> Measure what the bounds of the theory are compared with, in the order of the doubts (`adfric_describe_doubt`); what a model does not
   !> measure stays `not_measured`, here all. Called for every point that is solved, and with results that are NaN for what can be
   !> known of a case before; a measure that needs them is then NaN. It takes no time to speak of beside a point.
   subroutine measure(self, values, results, measures)
      class(model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the point, NaN where they are not known; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> In: all `not_measured`. Out: with what is measured; shape `(n_doubts)`.
      real(dp), intent(inout) :: measures(:)

      associate (unused => self, unused_too => values, unused_results => results, unused_measures => measures)
      end associate
   end subroutine measure

   !> Nominal sizes of what results are counted for, a period: its length or area [m, m^2]. Here there is none; a model of periods
   !> overrides it.
   pure subroutine get_nominal_sizes(self, values, sizes)
      class(model_t), intent(in) :: self
      !> Values of points; shape `(n_variables, n_points)`.
      real(dp), intent(in), contiguous :: values(:, :)
      !> Receives the size of each point; shape `(n_points)`.
      real(dp), intent(out) :: sizes(:)

      sizes = 1
      associate (unused => self, unused_too => values)
      end associate
   end subroutine get_nominal_sizes

   !> Number of profiles of this case: all of the table. A model whose last profiles not every case has overrides it.
   pure integer function count_profiles(self, values)
      class(model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      count_profiles = size(self%profiles)
      associate (unused => values)
      end associate
   end function count_profiles

   !> The profiles with their units for this case: those of the table. A model whose units depend on the case
   !> (reduced units) overrides it.
   function describe_profiles(self, values) result(profiles)
      class(model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(profile_t), allocatable :: profiles(:)

      profiles = self%profiles(:self%count_profiles(values))
   end function describe_profiles

   !> Shape of the profiles of a point: the axis that runs fastest, the other one, and the profiles.
   function profile_shape(self, values) result(shape)
      !> The model, with its table of profiles and their axes.
      class(model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      integer :: shape(3)
      type(profile_axis_t), allocatable :: axes(:)
      integer :: k

      call self%get_profile_axes(values, axes)
      shape = [1, 1, self%count_profiles(values)]
      do k = 1, size(axes)
         shape(size(axes) + 1 - k) = size(axes(k)%coordinates)
      end do
   end function profile_shape

   !> Unit of a variable for this case: that of the table. A model whose units depend on the case overrides it.
   function unit_of(self, values, index) result(unit)
      class(model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Index of the variable in `variables`.
      integer, intent(in) :: index
      character(:), allocatable :: unit

      unit = self%variables(index)%unit
      associate (unused => values)
      end associate
   end function unit_of

   !> Index of a variable in `variables` by the name that the solver has for it; 0 if there is none.
   pure integer function solver_index_of(self, group, name)
      class(model_t), intent(in) :: self
      !> Group of the variable, without `&`, and its name, both in the language of the solver.
      character(*), intent(in) :: group, name

      do solver_index_of = size(self%variables), 1, -1
         if (self%variables(solver_index_of)%is_called(group, name)) return
      end do
   end function solver_index_of

   !> Index of a variable in `variables`; 0 if there is none of that name.
   pure integer function index_of(self, group, name)
      class(model_t), intent(in) :: self
      !> Group of the variable, without `&`.
      character(*), intent(in) :: group
      !> Name of the variable.
      character(*), intent(in) :: name

      do index_of = size(self%variables), 1, -1
         if (self%variables(index_of)%group /= group .or. self%variables(index_of)%is_hidden) cycle
         if (self%variables(index_of)%name == name) return
      end do
   end function index_of

end module adfric_describe_model
