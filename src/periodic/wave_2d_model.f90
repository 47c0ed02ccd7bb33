! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `wave_2d_elastic`: a rigid bi-sinusoidal wave on an elastic half-space, without friction, with or without adhesion.
!>
!> Full contact is reached at the mean pressure p* = 2 pi E* D/l (K. L. Johnson, J. A. Greenwood, J. G. Higginson, Int. J. Mech.
!> Sci. 27, 1985, 383, on axes turned by 45 degrees), at the penetration 2 D. The wave is even about its crests and troughs, so
!> a quarter of its cell is all that is solved.
module adfric_periodic_wave_2d_model
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_base_constants, only: two_pi
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
   public :: wave_2d_model_t, new_wave_2d_model

   !> Variables in the order of their rows; a component is the index of its row.
   type :: wave_2d_input_t
      !> Indices of the rows.
      integer :: period = 0, amplitude = 0, cells = 0
   end type wave_2d_input_t
   type(wave_2d_input_t), parameter, public :: wave_2d_input = transfer(counting, wave_2d_input_t())
   integer, parameter, public :: n_wave_2d_own = storage_size(wave_2d_input)/storage_size(1)
   !> Cells come in multiples of this, so that grids of half and a quarter of them tell the error of the area.
   integer, parameter :: multiple_of_cells = 64

   !> The model `wave_2d_elastic`.
   type, extends(elastic_model_t) :: wave_2d_model_t
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

   !> The model with its tables.
   subroutine new_wave_2d_model(self)
      !> The new model; receives its tables.
      type(wave_2d_model_t), intent(out) :: self
      type(variable_t) :: v(n_wave_2d_own)

      v(wave_2d_input%period) = positive(group='surface', name='period', unit='m', meaning='period l in x and y')
      v(wave_2d_input%amplitude) = positive(group='surface', name='amplitude', unit='m', &
         & meaning='D of the wave z = D (2 - cos 2 pi x/l - cos 2 pi y/l)')
      v(wave_2d_input%cells) = whole_number(group='numerics', name='cells', &
         & meaning='cells along a period; the error of the area falls with their number', default=512, lower=64, upper=8192, &
         & multiple_of=multiple_of_cells)
      call self%set_elastic_tables(name='wave_2d_elastic', &
         & summary='a rigid wave in two directions on an elastic half-space, also with adhesion: area, pressure and gap', &
         & surface=v)
      self%knows_full_pressure = .true.
   end subroutine new_wave_2d_model

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
      !> Receives the periods and the cells of a quarter.
      type(periodic_surface_t), intent(inout) :: surface

      surface%period = values(wave_2d_input%period)
      surface%n_cells = nint(values(wave_2d_input%cells))/2
      surface%is_quarter = .true.
      associate (unused => self)
      end associate
   end subroutine get_cells

   !> See `periodic_model_t`.
   subroutine get_shape(self, values, shape)
      class(wave_2d_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the gap of the undeformed wave in a quarter [m].
      real(dp), allocatable, intent(inout) :: shape(:, :)

      associate (n => nint(values(wave_2d_input%cells)))
         call set_wave(values(wave_2d_input%amplitude), n, [n/2, n/2], shape)
      end associate
      associate (unused => self)
      end associate
   end subroutine get_shape

   !> See `elastic_model_t`.
   pure real(dp) function height_of(self, values)
      class(wave_2d_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      height_of = 4*values(wave_2d_input%amplitude)
      associate (unused => self)
      end associate
   end function height_of

   !> See `periodic_model_t`: that of the wave itself.
   pure real(dp) function get_full_pressure(self, values, solid, on_cells)
      class(wave_2d_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> The half-space.
      class(periodic_solid_t), intent(in) :: solid
      !> Pressure of full contact of the surface as its cells have it [E*], not used here.
      real(dp), intent(in) :: on_cells

      get_full_pressure = two_pi*solid%modulus*(values(wave_2d_input%amplitude)/values(wave_2d_input%period))
      associate (unused => self, unused_number => on_cells)
      end associate
   end function get_full_pressure

   !> See `periodic_model_t`: that of the crest, about which pressure is even in both directions.
   real(dp) function get_peak_pressure(self, values, pressure)
      class(wave_2d_model_t), intent(in) :: self
      !> Values of the variables, not used here.
      real(dp), intent(in) :: values(:)
      !> Pressure in the middles of the cells; shape `(nx, ny)`.
      real(dp), intent(in) :: pressure(:, :)

      associate (p => pressure)
         get_peak_pressure = p(1, 1)
         if (p(1, 1) > 0) get_peak_pressure = (81*p(1, 1) - 9*p(2, 1) - 9*p(1, 2) + p(2, 2))/64
      end associate
      associate (unused => self, unused_values => values)
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

      measures(doubt_slope_too_steep) = sqrt(2.0_dp)*two_pi*values(wave_2d_input%amplitude)/values(wave_2d_input%period)
      associate (unused => self, unused_results => results)
      end associate
   end subroutine measure

end module adfric_periodic_wave_2d_model
