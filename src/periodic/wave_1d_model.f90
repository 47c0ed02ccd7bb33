! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `wave_1d_elastic`: a rigid sinusoidal wave on the cells of an elastic half-plane, for laws of adhesion other than Dugdale's, whose
!> wave has a solution without cells.
!>
!> Full contact is reached at the mean pressure p* = pi E* D/l (H. M. Westergaard, J. Appl. Mech. 6, 1939, 49), at the penetration D.
module adfric_periodic_wave_1d_model
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, two_pi
   use adfric_base_counting, only: counting
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
   public :: wave_1d_cells_t, new_wave_1d_cells

   !> Variables in the order of their rows; a component is the index of its row.
   type :: wave_1d_input_t
      !> Indices of the rows.
      integer :: period = 0, amplitude = 0, cells = 0
   end type wave_1d_input_t
   type(wave_1d_input_t), parameter :: input = transfer(counting, wave_1d_input_t())
   integer, parameter :: n_own = storage_size(input)/storage_size(1)
   !> Cells come in multiples of this, so that grids of half and a quarter of them tell the error of the area.
   integer, parameter :: multiple_of_cells = 64

   !> The model `wave_1d_elastic`.
   type, extends(elastic_model_t) :: wave_1d_cells_t
   contains
      procedure :: check_surface
      procedure :: get_cells
      procedure :: get_shape
      procedure :: get_full_pressure
      procedure :: get_peak_pressure
      procedure :: height_of
      procedure :: measure
   end type wave_1d_cells_t

contains

   !> The model with its tables.
   subroutine new_wave_1d_cells(self)
      !> The new model; receives its tables.
      type(wave_1d_cells_t), intent(out) :: self
      type(variable_t) :: v(n_own)

      v(input%period) = positive(group='surface', name='period', unit='m', meaning='period l')
      v(input%amplitude) = positive(group='surface', name='amplitude', unit='m', meaning='D of the wave z = D (1 - cos 2 pi x/l)')
      v(input%cells) = whole_number(group='numerics', name='cells', &
         & meaning='cells along a period; the error of the area falls with their number', default=1024, lower=64, upper=65536, &
         & multiple_of=multiple_of_cells)
      call self%set_elastic_tables(name='wave_1d_elastic', &
         & summary='a rigid wave on the cells of an elastic half-plane, with any falling law of adhesion: area, pressure and gap', &
         & surface=v)
      self%knows_full_pressure = .true.
   end subroutine new_wave_1d_cells

   !> See `periodic_model_t`.
   subroutine check_surface(self, values, is_swept, problems)
      class(wave_1d_cells_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call require(self%variables, values, [input%period, input%amplitude], problems)
      if (self%wants_profiles(values)) call refuse_swept(self%variables, is_swept, [input%period, input%cells], problems)
   end subroutine check_surface

   !> See `periodic_model_t`.
   subroutine get_cells(self, values, surface)
      class(wave_1d_cells_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the period and its cells.
      type(periodic_surface_t), intent(inout) :: surface

      surface%period = values(input%period)
      surface%n_cells = [nint(values(input%cells)), 1]
      surface%is_quarter = .false.
      associate (unused => self)
      end associate
   end subroutine get_cells

   !> See `periodic_model_t`.
   subroutine get_shape(self, values, shape)
      class(wave_1d_cells_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the gap of the undeformed wave, 0 in the middle of the first cell [m].
      real(dp), allocatable, intent(inout) :: shape(:, :)

      associate (n => nint(values(input%cells)))
         call set_wave(values(input%amplitude), n, [n, 1], shape)
      end associate
      associate (unused => self)
      end associate
   end subroutine get_shape

   !> See `elastic_model_t`.
   pure real(dp) function height_of(self, values)
      class(wave_1d_cells_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      height_of = 2*values(input%amplitude)
      associate (unused => self)
      end associate
   end function height_of

   !> See `periodic_model_t`: that of the wave itself.
   pure real(dp) function get_full_pressure(self, values, solid, on_cells)
      class(wave_1d_cells_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> The half-space.
      class(periodic_solid_t), intent(in) :: solid
      !> Pressure of full contact of the surface as its cells have it [E*], not used here.
      real(dp), intent(in) :: on_cells

      get_full_pressure = pi*solid%modulus*(values(input%amplitude)/values(input%period))
      associate (unused => self, unused_number => on_cells)
      end associate
   end function get_full_pressure

   !> See `periodic_model_t`: that of the crest, about which pressure is even.
   real(dp) function get_peak_pressure(self, values, pressure)
      class(wave_1d_cells_t), intent(in) :: self
      !> Values of the variables, not used here.
      real(dp), intent(in) :: values(:)
      !> Pressure in the middles of the cells; shape `(nx, 1)`.
      real(dp), intent(in) :: pressure(:, :)

      get_peak_pressure = pressure(1, 1)
      if (pressure(1, 1) > 0) get_peak_pressure = (9*pressure(1, 1) - pressure(2, 1))/8
      associate (unused => self, unused_values => values)
      end associate
   end function get_peak_pressure

   !> See `model_t`: the steepest slope.
   subroutine measure(self, values, results, measures)
      class(wave_1d_cells_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the point, NaN where they are not known; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> In: all `not_measured`. Out: with what is measured; shape `(n_doubts)`.
      real(dp), intent(inout) :: measures(:)

      measures(doubt_slope_too_steep) = two_pi*values(input%amplitude)/values(input%period)
      associate (unused => self, unused_results => results)
      end associate
   end subroutine measure

end module adfric_periodic_wave_1d_model
