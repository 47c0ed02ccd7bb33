! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `spectrum_elastic`: a rigid Gaussian surface of a power spectrum, drawn by a seed (`adfric_shape_drawn_heights`), on
!> the cells of an elastic half-space or layer, with or without adhesion or friction. Each point draws its own surface, so the seed
!> and all that the spectrum has may be swept.
module adfric_periodic_spectrum_model
   use adfric_base_constants, only: two_pi
   use adfric_base_counting, only: counting
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: newline, show_number
   use adfric_base_unset, only: is_set, unset
   use adfric_describe_check, only: refuse_swept, require
   use adfric_describe_doubt, only: doubt_slope_too_steep
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_rows, only: positive, whole_number
   use adfric_describe_status, only: status_not_converged
   use adfric_describe_table, only: variable_t
   use adfric_periodic_elastic_model, only: elastic_model_t
   use adfric_periodic_operator, only: is_too_long
   use adfric_periodic_point, only: periodic_surface_t
   use adfric_shape_drawn_heights, only: can_hold, draw_heights, has_longest, waves_along
   use adfric_shape_height_spectrum, only: height_spectrum_t
   use adfric_shape_power_spectrum, only: check_density, given_density_t, make_spectrum, n_density_rows, set_density_rows
   implicit none (type, external)
   private
   public :: spectrum_model_t, new_spectrum_model

   !> Variables of the surface in the order of their rows, behind those of the spectrum; a component is the index of its row.
   type :: drawn_input_t
      !> Indices of the rows.
      integer :: density(n_density_rows) = 0, length_x = 0, length_y = 0, seed = 0, cells = 0
   end type drawn_input_t
   type(drawn_input_t), parameter :: in = transfer(counting, drawn_input_t())
   integer, parameter :: n_surface_rows = storage_size(in)/storage_size(1)
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
   contains
      procedure :: take_dataset
      procedure :: check_surface
      procedure :: get_cells
      procedure :: get_shape
      procedure :: solve_point
      procedure :: height_of
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
      v(in%cells) = whole_number(group='numerics', name='cells', &
         & meaning='cells along each period; the shortest wave needs more than 2, and better 8', default=512, &
         & lower=multiple_of_cells, upper=most_cells, multiple_of=multiple_of_cells)
      call self%set_elastic_tables(name='spectrum_elastic', surface=v, &
         & summary='a rigid surface drawn by a seed from a power spectrum on an elastic half-space: area, pressure and gap')
   end subroutine new_spectrum_model

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
         call self%given%take(index, values(:, 1))
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
      call require(self%variables, values, [in%seed], problems, 'cells have a surface that a seed draws from the spectrum')
      call require(self%variables, values, [in%length_x], problems)
      call check_density(self%variables(:n_density_rows), values(:n_density_rows), is_swept(:n_density_rows), self%given, problems)
      if (self%wants_profiles(values)) call refuse_swept(self%variables, is_swept, [in%length_x, in%length_y, in%cells], problems)
      if (problems%count() == before) call check_waves(self, values, problems)
   end subroutine check_surface

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
            & show_number(minval(surface%period))//' [m], allowed: '//show_number(two_pi/spectrum%q(0))//' or more')
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
      call draw_heights(spectrum, nint(values(in%seed)), surface%period, shape, error)
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

   !> See `pointwise_model_t`: a point of a sweep whose cells cannot have the waves is not solved.
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

      call get_spectrum(self, values, spectrum, surface, is_possible)
      if (is_possible) then
         call self%solve_contact(values, state, results, error_estimate, status, counts)
      else
         status = status_not_converged
         error_estimate = 0
      end if
   end subroutine solve_point

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

   !> See `model_t`: cells that are coarse for the shortest wave, and what is left out of the interface.
   function describe_doubts(self, values) result(text)
      class(spectrum_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text
      type(height_spectrum_t) :: spectrum
      type(periodic_surface_t) :: surface
      logical :: is_possible

      text = self%doubt_interface(values)
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

end module adfric_periodic_spectrum_model
