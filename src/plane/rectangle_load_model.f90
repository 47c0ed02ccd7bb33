! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `rectangle_load`: a constant pressure on a rectangle of an elastic half-space (Love).
module adfric_plane_rectangle_load_model
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_base_problems, only: problems_t
   use adfric_plane_love_rectangle, only: rectangle_field
   use adfric_plane_field_model, only: field_model_t, set_stresses, set_displacements, maps_of
   use adfric_describe_check, only: require
   use adfric_describe_rows, only: positive, number, poisson_ratio
   use adfric_describe_table, only: result_t, variable_t
   implicit none (type, external)
   private
   public :: rectangle_load_model_t, new_rectangle_load_model

   !> Variables in the order of their rows; a component is the index of its row.
   type :: rectangle_load_input_t
      !> Indices of the rows.
      integer :: young_modulus = 0, poisson_ratio = 0, x = 0, y = 0, z = 0, pressure = 0, half_width_x = 0, half_width_y = 0
   end type rectangle_load_input_t
   type(rectangle_load_input_t), parameter, public :: rectangle_load_input = transfer(counting, rectangle_load_input_t())
   !> Results in the order of their rows; a component is the index of its row.
   type :: rectangle_load_output_t
      !> Indices of the rows.
      integer :: stress_xx = 0, stress_yy = 0, stress_zz = 0, stress_xy = 0, stress_yz = 0, stress_xz = 0, &
         & displacement_x = 0, displacement_y = 0, displacement_z = 0
   end type rectangle_load_output_t
   type(rectangle_load_output_t), parameter, public :: rectangle_load_output = transfer(counting, rectangle_load_output_t())

   !> Largest ratio of the sides, at which corners still leave all digits.
   real(dp), parameter :: longest = 1.0e12_dp

   !> The model `rectangle_load`.
   type, extends(field_model_t) :: rectangle_load_model_t
   contains
      procedure :: check_case
      procedure :: get_position
      procedure :: get_field
   end type rectangle_load_model_t

contains

   !> The model with its tables.
   subroutine new_rectangle_load_model(self)
      !> The new model; receives its tables.
      type(rectangle_load_model_t), intent(out) :: self
      type(variable_t) :: v(8)
      type(result_t) :: r(9)

      v(rectangle_load_input%young_modulus) = positive(group='solid', name='young_modulus', unit='Pa', meaning='Young''s modulus')
      v(rectangle_load_input%poisson_ratio) = poisson_ratio(group='solid', name='poisson_ratio', meaning='Poisson''s ratio')
      v(rectangle_load_input%x) = number(group='position', name='position_x', unit='m', &
         & meaning='where the results are, from the middle of the rectangle', default=0.0_dp)
      v(rectangle_load_input%y) = number(group='position', name='position_y', unit='m', &
         & meaning='where the results and the plane of the maps are, from the middle', default=0.0_dp)
      v(rectangle_load_input%z) = number(group='position', name='position_z', unit='m', meaning='where the results are, depth', &
         & default=0.0_dp, lower=0.0_dp)
      v(rectangle_load_input%pressure) = number(group='operating', name='pressure', unit='Pa', &
         & meaning='p, into the solid, constant on the rectangle')
      v(rectangle_load_input%half_width_x) = positive(group='operating', name='half_width_x', unit='m', &
         & meaning='half-width of the rectangle along x')
      v(rectangle_load_input%half_width_y) = positive(group='operating', name='half_width_y', unit='m', &
         & meaning='half-width of the rectangle along y')
      call set_stresses('xx yy zz xy yz xz', r)
      call set_displacements('x y z', r(rectangle_load_output%displacement_x:))
      call self%set_tables(name='rectangle_load', &
         & summary='a constant pressure on a rectangle of an elastic half-space (Love): stresses, displacements', variables=v, &
         & results=r, profiles=maps_of(r), axes='z x', is_depth=.true.)
   end subroutine new_rectangle_load_model

   !> See `halfspace_model_t`.
   subroutine check_case(self, values, problems)
      class(rectangle_load_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call require(self%variables, values, [rectangle_load_input%young_modulus, rectangle_load_input%poisson_ratio, &
         & rectangle_load_input%pressure, rectangle_load_input%half_width_x, rectangle_load_input%half_width_y], problems)
      associate (sides => values(rectangle_load_input%half_width_x:rectangle_load_input%half_width_y))
         if (maxval(sides) > longest*minval(sides)) call problems%add('operating', 'half_width_y', &
            & 'and half_width_x differ by more than a factor of 1e12; a strip has no ends')
      end associate
   end subroutine check_case

   !> See `field_model_t`.
   pure function get_position(self, values, slow, fast) result(position)
      class(rectangle_load_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Coordinates on the axes of a map [m]; without them the position is that of the results.
      real(dp), intent(in), optional :: slow, fast
      real(dp) :: position(3)

      position = values(rectangle_load_input%x:rectangle_load_input%z)
      if (present(fast)) position(1) = fast
      if (present(slow)) position(3) = slow
      associate (unused => self)
      end associate
   end function get_position

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

      shear_modulus = values(rectangle_load_input%young_modulus)/(2*(1 + values(rectangle_load_input%poisson_ratio)))
      call rectangle_field(values(rectangle_load_input%half_width_x:rectangle_load_input%half_width_y), &
         & values(rectangle_load_input%poisson_ratio), position, stress, displacement)
      associate (pressure => values(rectangle_load_input%pressure))
         field(rectangle_load_output%stress_xx:rectangle_load_output%stress_xz) = pressure*stress
         field(rectangle_load_output%displacement_x:rectangle_load_output%displacement_z) = pressure/shear_modulus*displacement
      end associate
      associate (unused => self)
      end associate
   end subroutine get_field

end module adfric_plane_rectangle_load_model
