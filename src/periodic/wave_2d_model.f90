! SPDX-License-Identifier: GPL-3.0-or-later
!> The models `wave_2d_elastic` and `wave_1d_elastic`: a rigid wave on the cells of an elastic half-space, in two directions, without
!> friction, with or without adhesion, and in one, for laws of adhesion other than Dugdale's, whose wave has a solution without cells.
!>
!> Full contact of the wave in two directions is reached at the mean pressure p* = 2 pi E* D/l (K. L. Johnson, J. A. Greenwood,
!> J. G. Higginson, Int. J. Mech. Sci. 27, 1985, 383, on axes turned by 45 degrees), at the penetration 2 D. The wave is even about its
!> crests and troughs, so a quarter of its cell is all that is solved. That in one direction needs half of the pressure, pi E* D/l
!> (H. M. Westergaard, J. Appl. Mech. 6, 1939, 49), and of the penetration; it has one row of cells.
module adfric_periodic_wave_2d_model
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_base_constants, only: pi, two_pi
   use adfric_base_problems, only: problems_t
   use adfric_describe_check, only: require, refuse_swept
   use adfric_describe_doubt, only: doubt_slope_too_steep
   use adfric_describe_rows, only: positive, whole_number
   use adfric_describe_table, only: variable_t
   use adfric_periodic_elastic_model, only: elastic_model_t
   use adfric_periodic_point, only: periodic_surface_t, periodic_solid_t
   use adfric_periodic_wave_cells, only: set_wave
   implicit none (type, external)
   private
   public :: wave_2d_model_t, new_wave_2d_model, new_wave_1d_cells

   !> Variables in the order of their rows; a component is the index of its row.
   type :: wave_2d_input_t
      !> Indices of the rows.
      integer :: period = 0, amplitude = 0, cells = 0
   end type wave_2d_input_t
   type(wave_2d_input_t), parameter, public :: wave_2d_input = transfer(counting, wave_2d_input_t())
   integer, parameter, public :: n_wave_2d_own = storage_size(wave_2d_input)/storage_size(1)
   !> Cells come in multiples of this, so that grids of half and a quarter of them tell the error of the area.
   integer, parameter :: multiple_of_cells = 64

   !> The models.
   type, extends(elastic_model_t) :: wave_2d_model_t
      !> Number of directions in which the surface is a wave.
      integer :: n_directions = 2
   contains
      procedure :: check_surface
      procedure :: get_cells
      procedure :: get_shape
      procedure :: get_full_pressure
      procedure :: get_peak_pressure
      procedure :: height_of
      procedure :: measure
   end type wave_2d_model_t

contains

   !> The model `wave_2d_elastic` with its tables.
   subroutine new_wave_2d_model(self)
      !> The new model; receives its tables.
      type(wave_2d_model_t), intent(out) :: self

      call set_tables(self, name='wave_2d_elastic', default_cells=512, most_cells=8192, along='period l in x and y', &
         & shape='D of the wave z = D (2 - cos 2 pi x/l - cos 2 pi y/l)', &
         & summary='a rigid wave in two directions on an elastic half-space, also with adhesion: area, pressure and gap')
   end subroutine new_wave_2d_model

   !> The model `wave_1d_elastic` with its tables.
   subroutine new_wave_1d_cells(self)
      !> The new model; receives its tables.
      type(wave_2d_model_t), intent(out) :: self

      self%n_directions = 1
      call set_tables(self, name='wave_1d_elastic', default_cells=1024, most_cells=65536, along='period l', &
         & shape='D of the wave z = D (1 - cos 2 pi x/l)', &
         & summary='a rigid wave on the cells of an elastic half-plane, with any falling law of adhesion: area, pressure and gap')
   end subroutine new_wave_1d_cells

   !> The tables of a model.
   subroutine set_tables(self, name, summary, along, shape, default_cells, most_cells)
      type(wave_2d_model_t), intent(inout) :: self
      !> Name of the model and what it is; what period and amplitude are.
      character(*), intent(in) :: name, summary, along, shape
      !> Cells along a period if none are given, and the most.
      integer, intent(in) :: default_cells, most_cells
      type(variable_t) :: v(n_wave_2d_own)

      v(wave_2d_input%period) = positive(group='surface', name='period', unit='m', meaning=along)
      v(wave_2d_input%amplitude) = positive(group='surface', name='amplitude', unit='m', meaning=shape)
      v(wave_2d_input%cells) = whole_number(group='numerics', name='cells', &
         & meaning='cells along a period; the error of the area falls with their number', default=default_cells, lower=64, &
         & upper=most_cells, multiple_of=multiple_of_cells)
      call self%set_elastic_tables(name=name, summary=summary, surface=v)
      self%knows_full_pressure = .true.
   end subroutine set_tables

   !> See `periodic_model_t`.
   subroutine check_surface(self, values, is_swept, problems)
      class(wave_2d_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call require(self%variables, values, [wave_2d_input%period, wave_2d_input%amplitude], problems)
      if (self%wants_profiles(values)) call refuse_swept(self%variables, is_swept, [wave_2d_input%period, wave_2d_input%cells], &
         & problems)
   end subroutine check_surface

   !> See `periodic_model_t`.
   subroutine get_cells(self, values, surface)
      class(wave_2d_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the periods and the cells of a quarter, or those of a row.
      type(periodic_surface_t), intent(inout) :: surface

      surface%period = values(wave_2d_input%period)
      surface%n_cells = cells_of(self, values)
      surface%is_quarter = self%n_directions == 2
   end subroutine get_cells

   !> Number of the cells that are solved, along x and y.
   pure function cells_of(self, values) result(n_cells)
      class(wave_2d_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      integer :: n_cells(2)

      n_cells = nint(values(wave_2d_input%cells))/2
      if (self%n_directions == 1) n_cells = [nint(values(wave_2d_input%cells)), 1]
   end function cells_of

   !> See `periodic_model_t`.
   subroutine get_shape(self, values, shape)
      class(wave_2d_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the gap of the undeformed wave in the cells that are solved, 0 in the middle of the first one [m].
      real(dp), allocatable, intent(inout) :: shape(:, :)

      call set_wave(values(wave_2d_input%amplitude), nint(values(wave_2d_input%cells)), cells_of(self, values), shape)
   end subroutine get_shape

   !> See `elastic_model_t`.
   pure real(dp) function height_of(self, values)
      class(wave_2d_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      height_of = 2*self%n_directions*values(wave_2d_input%amplitude)
   end function height_of

   !> See `periodic_model_t`: that of the wave itself.
   pure real(dp) function get_full_pressure(self, values, solid, on_cells)
      class(wave_2d_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> The half-space or layer.
      class(periodic_solid_t), intent(in) :: solid
      !> Pressure of full contact of the surface as its cells have it [E*], not used here.
      real(dp), intent(in) :: on_cells
      complex(dp) :: stiffness(1, 1)

      stiffness = pi
      if (allocated(solid%kernel)) call solid%kernel%get_stiffness([1.0_dp], [0.0_dp], [0.0_dp, 0.0_dp], stiffness)
      get_full_pressure = self%n_directions*real(stiffness(1, 1), dp)*solid%modulus &
         & *(values(wave_2d_input%amplitude)/values(wave_2d_input%period))
      associate (unused_number => on_cells)
      end associate
   end function get_full_pressure

   !> See `periodic_model_t`: that of the crest, about which pressure is even in every direction, or that of a cell where it is more, as
   !> below a stiff coating.
   real(dp) function get_peak_pressure(self, values, pressure)
      class(wave_2d_model_t), intent(in) :: self
      !> Values of the variables, not used here.
      real(dp), intent(in) :: values(:)
      !> Pressure in the middles of the cells; shape `(nx, ny)`.
      real(dp), intent(in) :: pressure(:, :)

      associate (p => pressure)
         get_peak_pressure = p(1, 1)
         if (p(1, 1) > 0 .and. self%n_directions == 1) then
            get_peak_pressure = (9*p(1, 1) - p(2, 1))/8
         else if (p(1, 1) > 0) then
            get_peak_pressure = (81*p(1, 1) - 9*p(2, 1) - 9*p(1, 2) + p(2, 2))/64
         end if
         if (maxval(p) > max(get_peak_pressure, 0.0_dp)) get_peak_pressure = maxval(p)
      end associate
      associate (unused_values => values)
      end associate
   end function get_peak_pressure

   !> See `model_t`: the steepest slope, that of both waves together.
   subroutine measure(self, values, results, measures)
      class(wave_2d_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the point, NaN where they are not known; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> In: all `not_measured`. Out: with what is measured; shape `(n_doubts)`.
      real(dp), intent(inout) :: measures(:)

      measures(doubt_slope_too_steep) = sqrt(real(self%n_directions, dp))*two_pi*values(wave_2d_input%amplitude) &
         & /values(wave_2d_input%period)
      associate (unused_results => results)
      end associate
   end subroutine measure

end module adfric_periodic_wave_2d_model
