! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `surface_elastic`: a rigid periodic surface, given by its heights (`adfric_periodic_given_heights`), on an elastic
!> half-space, without friction, with or without adhesion.
module adfric_periodic_surface_model
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_base_problems, only: problems_t
   use adfric_describe_check, only: refuse_swept
   use adfric_describe_doubt, only: doubt_slope_too_steep
   use adfric_describe_table, only: variable_t
   use adfric_periodic_elastic_model, only: elastic_model_t
   use adfric_periodic_given_heights, only: given_heights_t, set_heights_rows, n_heights_rows
   use adfric_periodic_point, only: periodic_surface_t
   implicit none (type, external)
   private
   public :: surface_model_t, new_surface_model

   !> Variables in the order of their rows; a component is the index of its row.
   type :: surface_input_t
      !> Indices of the rows.
      integer :: heights = 0, length_x = 0, length_y = 0, rms_height = 0
   end type surface_input_t
   type(surface_input_t), parameter, public :: surface_input = transfer(counting, surface_input_t())

   !> The model `surface_elastic`.
   type, extends(elastic_model_t) :: surface_model_t
      private
      !> Heights of the input.
      type(given_heights_t) :: given
   contains
      procedure :: take_dataset
      procedure :: check_surface
      procedure :: get_cells
      procedure :: get_shape
      procedure :: height_of
      procedure :: describe_surface
      procedure :: describe_doubts
      procedure :: measure
   end type surface_model_t

contains

   !> The model with its tables.
   subroutine new_surface_model(self)
      !> The new model; receives its tables.
      type(surface_model_t), intent(out) :: self
      type(variable_t) :: v(n_heights_rows)

      call set_heights_rows(v)
      call self%set_elastic_tables(name='surface_elastic', surface=v, &
         & summary='a rigid periodic surface of given heights on an elastic half-space, also with adhesion: area, pressure and gap')
   end subroutine new_surface_model

   !> See `model_t`.
   subroutine take_dataset(self, index, values, problems)
      !> The model, which keeps the depths below the highest summit.
      class(surface_model_t), intent(inout) :: self
      !> Index of the dataset in `variables`.
      integer, intent(in) :: index
      !> Heights of the rough body [m]; shape `(nx, ny)`, ny = 1 if they do not vary along y.
      real(dp), intent(in) :: values(:, :)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      if (self%variables(index)%own_name() == 'heights') then
         call self%given%take(self%variables(index), values, problems)
      else
         call self%take_law(index, values, problems)
      end if
   end subroutine take_dataset

   !> See `periodic_model_t`.
   subroutine check_surface(self, values, is_swept, problems)
      !> The model with its heights; its tables give the variables their names.
      class(surface_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call self%given%check(self%variables(surface_input%heights:surface_input%rms_height), &
         & values(surface_input%heights:surface_input%rms_height), problems)
      if (self%wants_profiles(values)) call refuse_swept(self%variables, is_swept, [surface_input%length_x, &
         & surface_input%length_y], problems)
   end subroutine check_surface

   !> See `periodic_model_t`.
   subroutine get_cells(self, values, surface)
      class(surface_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the periods and the cells of the heights.
      type(periodic_surface_t), intent(inout) :: surface

      call self%given%get_cells(values(surface_input%heights:surface_input%rms_height), surface)
   end subroutine get_cells

   !> See `periodic_model_t`.
   subroutine get_shape(self, values, shape)
      class(surface_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the depths below the highest summit, unless it has them already [m].
      real(dp), allocatable, intent(inout) :: shape(:, :)

      call self%given%get_shape(values(surface_input%heights:surface_input%rms_height), shape)
   end subroutine get_shape

   !> See `elastic_model_t`.
   pure real(dp) function height_of(self, values)
      class(surface_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      height_of = self%given%factor_of(values(surface_input%heights:surface_input%rms_height))*maxval(self%given%depths)
   end function height_of

   !> See `periodic_model_t`.
   function describe_surface(self) result(text)
      class(surface_model_t), intent(in) :: self
      character(:), allocatable :: text

      text = self%given%describe(.false.)
   end function describe_surface

   !> See `model_t`: edges that do not meet, and what is left out of the interface.
   function describe_doubts(self, values) result(text)
      class(surface_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = self%given%doubt()//self%doubt_interface(values)
   end function describe_doubts

   !> See `model_t`: the mean slope of the heights.
   subroutine measure(self, values, results, measures)
      class(surface_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the point, NaN where they are not known; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> In: all `not_measured`. Out: with what is measured; shape `(n_doubts)`.
      real(dp), intent(inout) :: measures(:)

      measures(doubt_slope_too_steep) = self%given%slope(values(surface_input%heights:surface_input%rms_height))
      associate (unused => results)
      end associate
   end subroutine measure

end module adfric_periodic_surface_model
