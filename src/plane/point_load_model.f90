! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `point_load`: a point force on an elastic half-space (Boussinesq, Cerruti).
module adfric_plane_point_load_model
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_base_problems, only: problems_t
   use adfric_plane_boussinesq_cerruti, only: point_stress, point_displacement
   use adfric_plane_field_model, only: field_model_t, set_stresses, set_displacements, maps_of
   use adfric_describe_check, only: require
   use adfric_describe_rows, only: positive, number, poisson_ratio
   use adfric_describe_table, only: result_t, variable_t
   implicit none (type, external)
   private
   public :: point_load_model_t, new_point_load_model

   !> Variables in the order of their rows; a component is the index of its row.
   type :: point_load_input_t
      !> Indices of the rows.
      integer :: young_modulus = 0, poisson_ratio = 0, x = 0, y = 0, z = 0, normal = 0, tangential = 0
   end type point_load_input_t
   type(point_load_input_t), parameter, public :: point_load_input = transfer(counting, point_load_input_t())
   !> Results in the order of their rows; a component is the index of its row.
   type :: point_load_output_t
      !> Indices of the rows.
      integer :: stress_xx = 0, stress_yy = 0, stress_zz = 0, stress_xy = 0, stress_yz = 0, stress_xz = 0, &
         & displacement_x = 0, displacement_y = 0, displacement_z = 0
   end type point_load_output_t
   type(point_load_output_t), parameter, public :: point_load_output = transfer(counting, point_load_output_t())

   !> The model `point_load`.
   type, extends(field_model_t) :: point_load_model_t
   contains
      procedure :: check_case
      procedure :: get_position
      procedure :: get_field
   end type point_load_model_t

contains

   !> The model with its tables.
   subroutine new_point_load_model(self)
      !> The new model; receives its tables.
      type(point_load_model_t), intent(out) :: self
      type(variable_t) :: v(7)
      type(result_t) :: r(9)

      v(point_load_input%young_modulus) = positive(group='solid', name='young_modulus', unit='Pa', meaning='Young''s modulus')
      v(point_load_input%poisson_ratio) = poisson_ratio(group='solid', name='poisson_ratio', meaning='Poisson''s ratio')
      v(point_load_input%x) = number(group='position', name='position_x', unit='m', &
         & meaning='where the results are, along the tangential force', &
         & default=0.0_dp)
      v(point_load_input%y) = number(group='position', name='position_y', unit='m', &
         & meaning='where the results and the plane of the maps are, across it', default=0.0_dp)
      v(point_load_input%z) = number(group='position', name='position_z', unit='m', meaning='where the results are, depth', &
         & default=0.0_dp, &
         & lower=0.0_dp)
      v(point_load_input%normal) = number(group='operating', name='normal_load', unit='N', meaning='N, into the solid', &
         & default=0.0_dp)
      v(point_load_input%tangential) = number(group='operating', name='tangential_load', unit='N', meaning='T, along x', &
         & default=0.0_dp)
      call set_stresses('xx yy zz xy yz xz', r)
      call set_displacements('x y z', r(point_load_output%displacement_x:))
      call self%set_tables(name='point_load', &
         & summary='a point force on an elastic half-space (Boussinesq, Cerruti): stresses, displacements', variables=v, &
         & results=r, profiles=maps_of(r), axes='z x', is_depth=.true.)
   end subroutine new_point_load_model

   !> See `halfspace_model_t`.
   subroutine check_case(self, values, problems)
      class(point_load_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call require(self%variables, values, [point_load_input%young_modulus, point_load_input%poisson_ratio], problems)
   end subroutine check_case

   !> See `field_model_t`.
   pure function get_position(self, values, slow, fast) result(position)
      class(point_load_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Coordinates on the axes of a map [m]; without them the position is that of the results.
      real(dp), intent(in), optional :: slow, fast
      real(dp) :: position(3)

      position = values(point_load_input%x:point_load_input%z)
      if (present(fast)) position(1) = fast
      if (present(slow)) position(3) = slow
      associate (unused => self)
      end associate
   end function get_position

   !> See `field_model_t`.
   subroutine get_field(self, values, position, field)
      class(point_load_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Coordinates x, y, z of the position [m].
      real(dp), intent(in) :: position(3)
      !> Results at the position, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(out) :: field(:)
      real(dp) :: shear_modulus

      shear_modulus = values(point_load_input%young_modulus)/(2*(1 + values(point_load_input%poisson_ratio)))
      field(point_load_output%stress_xx:point_load_output%stress_xz) = point_stress(values(point_load_input%normal), &
         & values(point_load_input%tangential), values(point_load_input%poisson_ratio), position)
      field(point_load_output%displacement_x:point_load_output%displacement_z) = &
         & point_displacement(values(point_load_input%normal), values(point_load_input%tangential), shear_modulus, &
         & values(point_load_input%poisson_ratio), position)
      associate (unused => self)
      end associate
   end subroutine get_field

end module adfric_plane_point_load_model
