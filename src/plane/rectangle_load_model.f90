! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `rectangle_load`: a constant pressure on a rectangle of an elastic half-space (Love).
module adfric_plane_rectangle_load_model
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_plane_love_rectangle, only: rectangle_field
   use adfric_plane_spatial_load, only: n_spatial, spatial_input_t, spatial_load_t, store_field
   use adfric_describe_check, only: require
   use adfric_describe_rows, only: positive, number
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: rectangle_load_model_t, new_rectangle_load_model

   !> Variables in the order of their rows; a component is the index of its row.
   type, extends(spatial_input_t) :: rectangle_load_input_t
      !> Indices of the rows of the load.
      integer :: pressure = 0, half_width_x = 0, half_width_y = 0
   end type rectangle_load_input_t
   type(rectangle_load_input_t), parameter :: in = transfer(counting, rectangle_load_input_t())
   integer, parameter :: n_variables = storage_size(in)/storage_size(1)

   !> Largest ratio of the sides, at which corners still leave all digits.
   real(dp), parameter :: longest = 1.0e12_dp

   !> The model `rectangle_load`.
   type, extends(spatial_load_t) :: rectangle_load_model_t
   contains
      procedure :: check_case
      procedure :: get_field
   end type rectangle_load_model_t

contains

   !> The model with its tables.
   subroutine new_rectangle_load_model(self)
      !> The new model; receives its tables.
      type(rectangle_load_model_t), intent(out) :: self
      type(variable_t) :: v(n_spatial + 1:n_variables)

      v(in%pressure) = number(group='operating', name='pressure', unit='Pa', &
         & meaning='p, into the solid, constant on the rectangle')
      v(in%half_width_x) = positive(group='operating', name='half_width_x', unit='m', &
         & meaning='half-width of the rectangle along x')
      v(in%half_width_y) = positive(group='operating', name='half_width_y', unit='m', &
         & meaning='half-width of the rectangle along y')
      call self%set_load_tables('rectangle_load', 'a constant pressure on a rectangle of an elastic half-space (Love): stresses, ' &
         & //'displacements', 'where the results are, from the middle of the rectangle', &
         & 'where the results and the plane of the maps are, from the middle', v)
   end subroutine new_rectangle_load_model

   !> See `halfspace_model_t`.
   subroutine check_case(self, values, problems)
      class(rectangle_load_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call require(self%variables, values, [in%young_modulus, in%poisson_ratio, in%pressure, in%half_width_x, in%half_width_y], &
         & problems)
      associate (sides => values(in%half_width_x:in%half_width_y))
         if (.not. all(is_set(sides))) return
         if (maxval(sides)/longest > minval(sides)) call problems%add('operating', 'half_width_y', &
            & 'and half_width_x differ by more than a factor of 1e12; a strip has no ends')
      end associate
   end subroutine check_case

   !> See `field_model_t`.
   subroutine get_field(self, values, position, field)
      class(rectangle_load_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Coordinates x, y, z of the position [m].
      real(dp), intent(in) :: position(3)
      !> Results at the position, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(out) :: field(:)
      real(dp) :: shear_modulus, stress(6), displacement(3)

      shear_modulus = values(in%young_modulus)/(2*(1 + values(in%poisson_ratio)))
      call rectangle_field(values(in%half_width_x:in%half_width_y), values(in%poisson_ratio), position, stress, displacement)
      associate (pressure => values(in%pressure))
         call store_field(pressure*stress, pressure/shear_modulus*displacement, field)
      end associate
      associate (unused => self)
      end associate
   end subroutine get_field

end module adfric_plane_rectangle_load_model
