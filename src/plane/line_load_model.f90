! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `line_load`: a line load on an elastic half-plane, plane strain (Flamant).
module adfric_plane_line_load_model
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_plane_field_model, only: set_plane_stresses, set_displacements, maps_of
   use adfric_plane_flamant, only: line_stress, line_displacement
   use adfric_plane_plane_load, only: plane_load_model_t, set_plane_variables, set_stress, v_young_modulus, v_poisson_ratio
   use adfric_describe_check, only: require
   use adfric_describe_rows, only: positive, number
   use adfric_describe_table, only: result_t, variable_t
   implicit none (type, external)
   private
   public :: line_load_model_t, new_line_load_model

   !> Places of the line load's own variables and results; those of `adfric_plane_plane_load` are the first.
   integer, parameter, public :: v_normal = 5, v_tangential = 6, v_datum = 7
   integer, parameter, public :: r_displacement_x = 5, r_displacement_y = 6

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
      v(v_normal) = number(group='operating', name='normal_load', unit='N/m', meaning='N per length, into the solid', &
         & default=0.0_dp)
      v(v_tangential) = number(group='operating', name='tangential_load', unit='N/m', meaning='T per length, along x', &
         & default=0.0_dp)
      v(v_datum) = positive(group='operating', name='datum', unit='m', &
         & meaning='distance that fixes the rigid motion of the displacements', default=1.0_dp)
      call set_plane_stresses(r)
      call set_displacements('x y', r(r_displacement_x:))
      call self%set_tables(name='line_load', summary='a line load on an elastic half-plane (Flamant): stresses and displacements', &
         & variables=v, results=r, profiles=maps_of(r), axes='y x', is_depth=.true.)
   end subroutine new_line_load_model

   !> See `halfspace_model_t`.
   subroutine check_case(self, values, problems)
      !> The model; its tables give the variables their names.
      class(line_load_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call require(self%variables, values, [v_young_modulus, v_poisson_ratio], problems)
   end subroutine check_case

   !> See `field_model_t`.
   subroutine get_field(self, values, place, field)
      !> The model; nothing is read from it here.
      class(line_load_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Coordinates x, y, z of the place [m]; of a half-plane x, y, 0.
      real(dp), intent(in) :: place(3)
      !> Results at the place, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(out) :: field(:)

      field = not_a_number()
      if (.not. maxval(abs(place)) > 0) return
      call set_stress(line_stress(values(v_normal), values(v_tangential), place(1), place(2)), field)
      field(r_displacement_x:r_displacement_y) = line_displacement(values(v_normal), values(v_tangential), &
         & values(v_young_modulus), values(v_poisson_ratio), values(v_datum), place(1), place(2))
      associate (unused => self)
      end associate
   end subroutine get_field

end module adfric_plane_line_load_model
