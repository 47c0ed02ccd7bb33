! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `line_load`: a line load on an elastic half-plane, plane strain (Flamant).
module adfric_plane_line_load_model
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_plane_field_model, only: set_plane_stresses, set_displacements, maps_of
   use adfric_plane_flamant, only: line_stress, line_displacement
   use adfric_plane_plane_load, only: plane_load_model_t, set_plane_variables, set_stress, plane_load_input, plane_load_output
   use adfric_describe_check, only: require
   use adfric_describe_rows, only: positive, number
   use adfric_describe_table, only: result_t, variable_t
   implicit none (type, external)
   private
   public :: line_load_model_t, new_line_load_model

   !> Variables in the order of their rows; a component is the index of its row.
   type :: line_load_input_t
      !> Indices of the rows.
      integer :: normal = 0, tangential = 0, datum = 0
   end type line_load_input_t
   type(line_load_input_t), parameter, public :: line_load_input = transfer(counting(plane_load_input%y + 1:), line_load_input_t())
   !> Results in the order of their rows; a component is the index of its row.
   type :: line_load_output_t
      !> Indices of the rows.
      integer :: displacement_x = 0, displacement_y = 0
   end type line_load_output_t
   type(line_load_output_t), parameter, public :: line_load_output = transfer(counting(plane_load_output%shear + 1:), &
      & line_load_output_t())

   !> A line load on a half-plane.
   type, extends(plane_load_model_t) :: line_load_model_t
   contains
      procedure :: check_case
      procedure :: get_field
   end type line_load_model_t

contains

   !> The model of a line load with its tables.
   subroutine new_line_load_model(self)
      !> The new model; receives its tables.
      type(line_load_model_t), intent(out) :: self
      type(variable_t) :: v(7)
      type(result_t) :: r(6)

      call set_plane_variables(v)
      v(line_load_input%normal) = number(group='operating', name='normal_load', unit='N/m', &
         & meaning='N per length, into the solid', &
         & default=0.0_dp)
      v(line_load_input%tangential) = number(group='operating', name='tangential_load', unit='N/m', &
         & meaning='T per length, along x', &
         & default=0.0_dp)
      v(line_load_input%datum) = positive(group='operating', name='datum', unit='m', &
         & meaning='distance that fixes the rigid motion of the displacements', default=1.0_dp)
      call set_plane_stresses(r)
      call set_displacements('x y', r(line_load_output%displacement_x:))
      call self%set_tables(name='line_load', summary='a line load on an elastic half-plane (Flamant): stresses and displacements', &
         & variables=v, results=r, profiles=maps_of(r), axes='y x', is_depth=.true.)
   end subroutine new_line_load_model

   !> See `halfspace_model_t`.
   subroutine check_case(self, values, problems)
      class(line_load_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call require(self%variables, values, [plane_load_input%young_modulus, plane_load_input%poisson_ratio], problems)
   end subroutine check_case

   !> See `field_model_t`.
   subroutine get_field(self, values, position, field)
      class(line_load_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Coordinates x, y, z of the position [m]; of a half-plane x, y, 0.
      real(dp), intent(in) :: position(3)
      !> Results at the position, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(out) :: field(:)

      field = not_a_number()
      if (.not. maxval(abs(position)) > 0) return
      call set_stress(line_stress(values(line_load_input%normal), values(line_load_input%tangential), position(1), position(2)), &
         & field)
      field(line_load_output%displacement_x:line_load_output%displacement_y) = line_displacement(values(line_load_input%normal), &
         & values(line_load_input%tangential), &
         & values(plane_load_input%young_modulus), values(plane_load_input%poisson_ratio), values(line_load_input%datum), &
         & position(1), position(2))
      associate (unused => self)
      end associate
   end subroutine get_field

end module adfric_plane_line_load_model
