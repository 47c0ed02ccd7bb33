! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `spectrum_elastic`: a rigid Gaussian surface of a power spectrum, drawn by a seed (`adfric_shape_drawn_heights`), on
!> the cells of an elastic half-space or layer, with or without adhesion or friction. Each point draws its own surface, so the seed
!> and all that the spectrum has may be swept. A point may also be an ensemble of several seeds (`adfric_rough_ensemble`), and have
!> the answers of the theories beside its own (`adfric_rough_pressed_theories`). The file is long by its answers to `model_t`.
module adfric_rough_spectrum_model
   use adfric_base_constants, only: two_pi
   use adfric_base_counting, only: counting
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: newline, show_count, show_number
   use adfric_base_unset, only: is_set, unset
   use adfric_describe_check, only: refuse_swept, require
   use adfric_describe_derived, only: derived_t
   use adfric_describe_doubt, only: doubt_slope_too_steep
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_rows, only: positive, several_words, whole_number
   use adfric_describe_status, only: status_not_converged, status_solved
   use adfric_describe_table, only: result_t, variable_t
   use adfric_describe_word_sets, only: has_number
   use adfric_interface_conduction_rows, only: n_conduction_rows
   use adfric_periodic_elastic_model, only: elastic_model_t, punch_values
   use adfric_periodic_operator, only: is_too_long
   use adfric_periodic_point, only: periodic_goal_t, periodic_surface_t
   use adfric_periodic_variables, only: n_elastic_results, of_contact => periodic_output, prescribed => periodic_input
   use adfric_rough_atlas, only: describe_bands
   use adfric_rough_ensemble, only: find_ensemble, n_ensemble_rows, set_ensemble_rows
   use adfric_rough_pressed_theories, only: add_conductances, answer_pressed, least_mean_pressure, new_pressed_theories, &
      & pressed_surface_t, pressed_theories_t, set_areas, set_nodes, set_shares
   use adfric_rough_variables, only: constant_row, get_rough_results, n_pressed_results, n_theories, suffixes, &
      & theory_of_result
   use adfric_shape_drawn_heights, only: can_hold, draw_heights, has_longest, waves_along
   use adfric_shape_height_spectrum, only: height_spectrum_t
   use adfric_shape_power_spectrum, only: check_density, derive_moments, doubt_density, given_density_t, make_spectrum, &
      & n_density_rows, set_density_rows
   implicit none (type, external)
   private
   public :: spectrum_model_t, new_spectrum_model

   !> Variables of the surface in the order of their rows, behind those of the spectrum; a component is the index of its row.
   type :: drawn_input_t
      !> Indices of the rows.
      integer :: density(n_density_rows) = 0, length_x = 0, length_y = 0, seed = 0, seeds = 0, &
         & cells = 0, theories = 0, yang_persson_constant = 0
   end type drawn_input_t
   type(drawn_input_t), parameter :: in = transfer(counting, drawn_input_t())
   integer, parameter :: n_surface_rows = storage_size(in)/storage_size(1)
   !> Results of a contact and of an ensemble, which stand before those of the theories.
   integer, parameter :: before_theories = n_elastic_results + n_ensemble_rows
   !> Most surfaces of an ensemble.
   integer, parameter :: most_seeds = 100000
   !> Cells come in multiples of this, so that grids of half and a quarter of them tell the error of the area; and the most.
   integer, parameter :: multiple_of_cells = 32, most_cells = 4096
   !> Cells of the shortest wave below which its contact is coarse.
   integer, parameter :: cells_of_wave = 4
   !> Range of the heights of a Gaussian surface over their root mean square, about.
   real(dp), parameter :: typical_range = 8

   !> The model `spectrum_elastic`.
   type, extends(elastic_model_t) :: spectrum_model_t
      private
      !> Table of the spectrum.
      type(given_density_t) :: given
      !> What the theories of all points share, while a run lasts; else not allocated.
      type(pressed_theories_t), allocatable :: theories
   contains
      procedure :: prepare
      procedure :: release
      procedure :: take_dataset
      procedure :: check_surface
      procedure :: check_solid
      procedure :: get_cells
      procedure :: get_shape
      procedure :: solve_point
      procedure :: height_of
      procedure :: derive_quantities
      procedure :: describe_case
      procedure :: describe_doubts
      procedure :: measure
   end type spectrum_model_t

contains

   !> The model with its tables.
   subroutine new_spectrum_model(self)
      !> The new model; receives its tables.
      type(spectrum_model_t), intent(out) :: self
      type(variable_t) :: v(n_surface_rows)

      call set_density_rows(v(:n_density_rows))
      v(in%length_x) = positive(group='surface', name='length_x', unit='m', meaning='period in x, at least the longest wave')
      v(in%length_y) = positive(group='surface', name='length_y', unit='m', meaning='period in y, that in x if not given')
      v(in%seed) = whole_number(group='surface', name='seed', &
         & meaning='number of the surface that is drawn from the spectrum; the same surface on every machine', default=1, lower=1, &
         & upper=huge(1))
      v(in%seed)%default = unset
      v(in%seeds) = whole_number(group='surface', name='seeds', &
         & meaning='number of surfaces, drawn by the seeds from seed on, whose means and spreads a point has', default=1, lower=1, &
         & upper=most_seeds)
      v(in%seeds)%default = unset
      v(in%cells) = whole_number(group='numerics', name='cells', &
         & meaning='cells along each period; the shortest wave needs more than 2, and better 8', default=512, &
         & lower=multiple_of_cells, upper=most_cells, multiple_of=multiple_of_cells)
      v(in%theories) = several_words(group='estimates', name='theories', &
         & meaning='one or more statistical theories, whose answers stand beside those of the cells at the same mean pressure', &
         & choices=list_of_theories())
      v(in%yang_persson_constant) = constant_row()
      call self%set_elastic_tables(name='spectrum_elastic', surface=v, &
         & summary='a rigid surface drawn by a seed from a power spectrum on an elastic half-space: area, pressure and gap')
      call add_results(self)
   end subroutine new_spectrum_model

   !> Names of the theories, separated by a blank.
   pure function list_of_theories() result(words)
      character(:), allocatable :: words
      integer :: k

      words = ''
      do k = 1, n_theories
         words = words//' '//trim(suffixes(k))
      end do
      words = words(2:)
   end function list_of_theories

   !> Add the rows of the ensemble and of the theories to the results of a contact.
   subroutine add_results(self)
      type(spectrum_model_t), intent(inout) :: self
      type(result_t), allocatable :: rows(:), of_theories(:)
      integer :: k

      allocate (rows(before_theories + n_pressed_results))
      do k = 1, n_elastic_results
         rows(k) = self%results(k)
      end do
      call set_ensemble_rows(self%results, rows(n_elastic_results + 1:before_theories))
      allocate (of_theories, source=get_rough_results())
      do k = 1, n_pressed_results
         rows(before_theories + k) = of_theories(k)
         ! a theory has no value where it is not asked, or has no state
         rows(before_theories + k)%is_main = .false.
      end do
      call move_alloc(rows, self%results)
   end subroutine add_results

   !> Make what points share: pull-offs, and functions of the theories.
   subroutine prepare(self)
      !> The model.
      class(spectrum_model_t), intent(inout) :: self

      call self%prepare_contacts()
      if (allocated(self%theories)) return
      allocate (self%theories)
      call new_pressed_theories(self%theories)
   end subroutine prepare

   !> Give back what points have shared.
   subroutine release(self)
      !> The model.
      class(spectrum_model_t), intent(inout) :: self

      call self%release_contacts()
      if (allocated(self%theories)) deallocate (self%theories)
   end subroutine release

   !> Number of surfaces of a point.
   pure integer function n_seeds_of(values) result(n)
      real(dp), intent(in) :: values(:)

      n = 1
      if (is_set(values(in%seeds))) n = nint(values(in%seeds))
   end function n_seeds_of

   !> The first seed of a point: 1 where an ensemble names none.
   pure integer function first_seed_of(values) result(seed)
      real(dp), intent(in) :: values(:)

      seed = 1
      if (is_set(values(in%seed))) seed = nint(values(in%seed))
   end function first_seed_of

   !> Are the seeds of a point numbers that there are?
   pure logical function are_seeds_there(values)
      real(dp), intent(in) :: values(:)

      are_seeds_there = first_seed_of(values) <= huge(1) - (n_seeds_of(values) - 1)
   end function are_seeds_there

   !> See `model_t`.
   subroutine take_dataset(self, index, values, problems)
      !> The model, which keeps the table of the spectrum.
      class(spectrum_model_t), intent(inout) :: self
      !> Index of the dataset in `variables`.
      integer, intent(in) :: index
      !> Its values; shape `(n, n_columns)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      if (index <= n_density_rows) then
         call self%given%take(index, values)
      else
         call self%take_law(index, values, problems)
      end if
   end subroutine take_dataset

   !> See `periodic_model_t`.
   subroutine check_surface(self, values, is_swept, problems)
      class(spectrum_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: before

      before = problems%count()
      if (.not. is_set(values(in%seeds))) call require(self%variables, values, [in%seed], problems, &
         & 'cells have a surface that a seed draws from the spectrum')
      if (.not. are_seeds_there(values)) call problems%add('surface', 'seeds', 'goes beyond the largest seed, given '// &
         & show_count(n_seeds_of(values))//' from '//show_count(first_seed_of(values))//' on, allowed: seeds up to '// &
         & show_count(huge(1)))
      call require(self%variables, values, [in%length_x], problems)
      call check_density(self%variables(:n_density_rows), values(:n_density_rows), is_swept(:n_density_rows), self%given, problems)
      if (self%wants_profiles(values)) then
         call refuse_swept(self%variables, is_swept, [in%length_x, in%length_y, in%cells], problems)
         if (n_seeds_of(values) > 1 .or. is_swept(in%seeds)) call problems%add('output', 'profiles', &
            & 'are maps of one surface, and seeds make several; leave seeds out, and sweep seed')
      end if
      if (problems%count() == before) call check_waves(self, values, problems)
   end subroutine check_surface

   !> See `periodic_model_t`: the theories are those of a half-space without adhesion.
   subroutine check_solid(self, values, is_swept, problems)
      class(spectrum_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      type(periodic_surface_t) :: surface
      type(periodic_goal_t) :: goal

      call self%check_elastic_solid(values, is_swept, problems)
      if (problems%count() > 0 .or. .not. is_set(values(in%theories))) return
      call self%get_cells(values, surface)
      call self%set_solid(values, surface)
      call self%set_interface(values, surface, goal)
      if (allocated(surface%solid%kernel)) call problems%add('estimates', 'theories', &
         & 'are those of a half-space, and there is a layer')
      if (allocated(goal%adhesion) .or. allocated(goal%attraction)) call problems%add('estimates', 'theories', &
         & 'stand beside adhesion, of which they give the pull-off alone; leave them out, or the seed for that')
      if (allocated(goal%hardness)) call problems%add('estimates', 'theories', &
         & 'stand beside a hardness, and are those of elastic solids')
   end subroutine check_solid

   !> Add to `problems` a period that is too short for the longest wave, and cells that are too few for the shortest one.
   subroutine check_waves(self, values, problems)
      class(spectrum_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      type(height_spectrum_t) :: spectrum
      type(periodic_surface_t) :: surface
      character(:), allocatable :: longest
      logical :: is_possible

      call make_spectrum(values(:n_density_rows), self%given, spectrum, is_possible)
      if (.not. is_possible) return
      call self%get_cells(values, surface)
      if (is_too_long(surface%n_cells, surface%period)) then
         call problems%add('surface', 'length_y', 'makes cells more than 1e6 times as long as wide, given '// &
            & show_number(surface%period(2))//' m beside length_x = '//show_number(surface%period(1))//' m')
      else if (.not. has_longest(spectrum, surface%period)) then
         longest = trim(merge('length_x', 'length_y', surface%period(1) <= surface%period(2)))
         call problems%add('surface', longest, 'is less than the longest wave of the spectrum, given '// &
            & show_number(minval(surface%period))//' [m], allowed: '//show_number(two_pi/spectrum%longest)//' or more')
      else if (.not. can_hold(spectrum, surface%period, surface%n_cells)) then
         call problems%add('numerics', 'cells', 'is '//show_number(real(surface%n_cells(1), dp))// &
            & ', too few for the shortest wave; '//what_would_do(spectrum, surface%period, 2))
      end if
   end subroutine check_waves

   !> The fewest cells that give the shortest wave more than so many, or that there are none.
   function what_would_do(spectrum, period, n_of_wave) result(text)
      type(height_spectrum_t), intent(in) :: spectrum
      real(dp), intent(in) :: period(2)
      !> Cells of the shortest wave.
      integer, intent(in) :: n_of_wave
      character(:), allocatable :: text
      real(dp) :: blocks

      blocks = aint(n_of_wave*maxval(waves_along(spectrum, period))*(1 + 1.0e-6_dp)/multiple_of_cells) + 1
      if (blocks*multiple_of_cells > most_cells) then
         text = 'no number allowed is enough: take shorter periods or leave out short waves'
      else
         text = show_number(blocks*multiple_of_cells)//' would do'
      end if
   end function what_would_do

   !> See `periodic_model_t`.
   subroutine get_cells(self, values, surface)
      class(spectrum_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the periods and the cells.
      type(periodic_surface_t), intent(inout) :: surface

      surface%period = values(in%length_x)
      if (is_set(values(in%length_y))) surface%period(2) = values(in%length_y)
      surface%n_cells = nint(values(in%cells))
      associate (unused => self)
      end associate
   end subroutine get_cells

   !> See `periodic_model_t`: the surface is drawn anew, which costs little beside a contact. It is not there without memory.
   subroutine get_shape(self, values, shape)
      class(spectrum_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the depths below the highest summit [m]; not allocated without memory, or if cells cannot have the waves.
      real(dp), allocatable, intent(inout) :: shape(:, :)
      type(height_spectrum_t) :: spectrum
      type(periodic_surface_t) :: surface
      type(error_t), allocatable :: error
      integer :: failure
      logical :: is_possible

      if (allocated(shape)) deallocate (shape)
      call get_spectrum(self, values, spectrum, surface, is_possible)
      if (.not. is_possible) return
      allocate (shape(surface%n_cells(1), surface%n_cells(2)), stat=failure)
      if (failure /= 0) return
      call draw_heights(spectrum, first_seed_of(values), surface%period, shape, error)
      if (allocated(error)) then
         deallocate (shape)
      else
         shape(:, :) = maxval(shape) - shape
      end if
   end subroutine get_shape

   !> The spectrum and the cells of a point.
   subroutine get_spectrum(self, values, spectrum, surface, is_possible)
      class(spectrum_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(height_spectrum_t), intent(out) :: spectrum
      !> Receives periods and numbers of cells.
      type(periodic_surface_t), intent(inout) :: surface
      !> Is there a spectrum, and can the cells have its waves?
      logical, intent(out) :: is_possible

      call make_spectrum(values(:n_density_rows), self%given, spectrum, is_possible)
      if (.not. is_possible) return
      call self%get_cells(values, surface)
      is_possible = .not. is_too_long(surface%n_cells, surface%period)
      if (is_possible) is_possible = has_longest(spectrum, surface%period) .and. can_hold(spectrum, surface%period, surface%n_cells)
   end subroutine get_spectrum

   !> See `pointwise_model_t`: a point of a sweep whose cells cannot have the waves is not solved, nor is an ensemble with a member
   !> that is not solved.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
      class(spectrum_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Solver and solution of the point before; receives those of this point.
      class(point_state_t), allocatable, intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Estimated relative error of the main result [-]; 0 where the point is not solved.
      real(dp), intent(out) :: error_estimate
      !> Status of the point, one of `status_...`.
      integer, intent(out) :: status
      !> One number, to which the iterations on the finest grid are added.
      real(dp), intent(inout) :: counts(:)
      type(height_spectrum_t) :: spectrum
      type(periodic_surface_t) :: surface
      logical :: is_possible

      status = status_not_converged
      error_estimate = 0
      call get_spectrum(self, values, spectrum, surface, is_possible)
      if (is_possible) is_possible = are_seeds_there(values)
      if (.not. is_possible) return
      if (n_seeds_of(values) == 1) then
         call self%solve_contact(values, state, results(:n_elastic_results), error_estimate, status, counts)
      else
         call solve_ensemble(self, values, state, results(:before_theories), error_estimate, status, counts)
      end if
      if (status /= status_solved .or. .not. is_set(values(in%theories))) return
      call self%set_solid(values, surface)
      call answer_theories(self, values, spectrum, surface%solid%modulus, results(of_contact%mean_pressure), &
         & results(before_theories + 1:), is_possible)
      if (is_possible) return
      status = status_not_converged
      error_estimate = 0
      results(:) = not_a_number()
   end subroutine solve_point

   !> Solve the members of an ensemble, each as a point of its own. The first one that is not solved ends the point.
   subroutine solve_ensemble(self, values, state, results, error_estimate, status, counts)
      class(spectrum_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      class(point_state_t), allocatable, intent(inout) :: state
      !> In: all NaN. Out: means, spreads and errors of means; shape `(before_theories)`.
      real(dp), intent(inout) :: results(:)
      !> Largest one of the members, which bounds that of a mean of numbers of one sign.
      real(dp), intent(out) :: error_estimate
      integer, intent(out) :: status
      real(dp), intent(inout) :: counts(:)
      real(dp), allocatable :: members(:, :)
      real(dp) :: of_member(size(values)), error
      integer :: k

      allocate (members(n_elastic_results, n_seeds_of(values)), source=not_a_number())
      of_member = values
      error_estimate = 0
      do k = 1, size(members, 2)
         of_member(in%seed) = first_seed_of(values) + (k - 1)
         call self%solve_contact(of_member, state, members(:, k), error, status, counts)
         if (self%is_stopped()) status = status_not_converged
         if (status /= status_solved) then
            error_estimate = 0
            return
         end if
         error_estimate = max(error_estimate, error)
      end do
      call find_ensemble(members, results)
   end subroutine solve_ensemble

   !> The answers of the theories that are asked, at the mean pressure of a point. They have none where nothing presses.
   subroutine answer_theories(self, values, spectrum, modulus, mean_pressure, results, is_converged)
      class(spectrum_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(height_spectrum_t), intent(in) :: spectrum
      !> Contact modulus and mean pressure [Pa].
      real(dp), intent(in) :: modulus, mean_pressure
      !> In: all NaN. Out: with the answers; shape `(n_pressed_results)`.
      real(dp), intent(inout) :: results(:)
      logical, intent(out) :: is_converged
      type(pressed_theories_t), allocatable :: own
      type(pressed_surface_t) :: surface
      real(dp) :: answers(n_pressed_results)
      logical :: is_asked(n_theories)
      integer :: k

      is_converged = .true.
      if (.not. mean_pressure >= least_mean_pressure) return
      is_asked = [(has_number(values(in%theories), k), k=1, n_theories)]
      surface%spectrum = spectrum
      call set_shares(surface, values(in%yang_persson_constant))
      call set_nodes(surface)
      call set_areas(surface)
      answers = not_a_number()
      if (allocated(self%theories)) then
         call answer_pressed(self%theories, surface, modulus, mean_pressure, is_asked, answers, is_converged)
      else
         allocate (own)
         call new_pressed_theories(own)
         call answer_pressed(own, surface, modulus, mean_pressure, is_asked, answers, is_converged)
      end if
      associate (punch => punch_values(self, values))
         call add_conductances(punch(:n_conduction_rows), answers)
      end associate
      do k = 1, n_pressed_results
         if (is_asked(theory_of_result(k))) results(k) = answers(k)
      end do
   end subroutine answer_theories

   !> See `elastic_model_t`: that of most Gaussian surfaces.
   pure real(dp) function height_of(self, values)
      class(spectrum_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(height_spectrum_t) :: spectrum
      logical :: is_possible

      height_of = 1
      call make_spectrum(values(:n_density_rows), self%given, spectrum, is_possible)
      if (is_possible) height_of = typical_range*spectrum%root_mean_square_height()
   end function height_of

   !> See `model_t`: of an ensemble those of the spectrum, for each surface has its own.
   function derive_quantities(self, values) result(derived)
      class(spectrum_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: derived(:)
      type(periodic_surface_t) :: surface
      type(height_spectrum_t) :: spectrum
      logical :: is_possible

      if (n_seeds_of(values) == 1) then
         derived = self%derive_surface(values)
         return
      end if
      call self%get_cells(values, surface)
      call self%set_solid(values, surface)
      derived = self%derive_solid(values, surface)
      call make_spectrum(values(:n_density_rows), self%given, spectrum, is_possible)
      if (is_possible) call derive_moments(derived, spectrum)
   end function derive_quantities

   !> See `model_t`: where the theories that are asked have been compared with the numerical answer.
   function describe_case(self, values) result(text)
      class(spectrum_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text
      type(height_spectrum_t) :: spectrum
      type(periodic_surface_t) :: surface
      real(dp) :: pressure
      logical :: is_possible

      text = ''
      if (.not. is_set(values(in%theories))) return
      pressure = values(self%before_prescribed + prescribed%mean_pressure)
      call make_spectrum(values(:n_density_rows), self%given, spectrum, is_possible)
      if (.not. (is_possible .and. is_set(pressure))) return
      call self%get_cells(values, surface)
      call self%set_solid(values, surface)
      text = describe_bands(spectrum, pressure/surface%solid%modulus/spectrum%root_mean_square_slope(), &
         & values(in%yang_persson_constant))
   end function describe_case

   !> See `model_t`: cells that are coarse for the shortest wave, and what is left out of the interface.
   function describe_doubts(self, values) result(text)
      class(spectrum_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text
      type(height_spectrum_t) :: spectrum
      type(periodic_surface_t) :: surface
      logical :: is_possible

      text = self%doubt_interface(values)//doubt_density(values(:n_density_rows), self%given)
      call get_spectrum(self, values, spectrum, surface, is_possible)
      if (.not. is_possible) return
      if (maxval(waves_along(spectrum, surface%period)/surface%n_cells) <= 1.0_dp/cells_of_wave) return
      text = text//'the shortest wave has fewer than 4 cells, and light contact lies on it; of cells '// &
         & what_would_do(spectrum, surface%period, cells_of_wave)//newline
   end function describe_doubts

   !> See `model_t`: the slope of all waves.
   subroutine measure(self, values, results, measures)
      class(spectrum_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the point, NaN where they are not known; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> In: all `not_measured`. Out: with what is measured; shape `(n_doubts)`.
      real(dp), intent(inout) :: measures(:)
      type(height_spectrum_t) :: spectrum
      logical :: is_possible

      call make_spectrum(values(:n_density_rows), self%given, spectrum, is_possible)
      if (is_possible) measures(doubt_slope_too_steep) = spectrum%root_mean_square_slope()
      associate (unused => results)
      end associate
   end subroutine measure

end module adfric_rough_spectrum_model
