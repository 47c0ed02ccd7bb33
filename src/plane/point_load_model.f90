! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `point_load`: a point force on an elastic half-space (Boussinesq, Cerruti).
module adfric_plane_point_load_model
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_plane_boussinesq_cerruti, only: point_stress, point_displacement
   use adfric_plane_field_model, only: field_model_t, set_stresses, set_displacements, maps_of
   use adfric_describe_check, only: require
   use adfric_describe_rows, only: positive, number, poisson_ratio
   use adfric_describe_table, only: result_t, variable_t
   implicit none (type, external)
   private
   public :: point_load_model_t, new_point_load_model

   !> Places of the variables and of the results.
   integer, parameter, public :: v_young_modulus = 1, v_poisson_ratio = 2, v_x = 3, v_y = 4, v_z = 5, v_normal = 6, v_tangential = 7
   integer, parameter, public :: r_stress_xx = 1, r_stress_xz = 6, r_displacement_x = 7, r_displacement_z = 9

   !> The model `point_load`.
   type, extends(field_model_t) :: point_load_model_t
   contains
      procedure :: check_case
      procedure :: get_place
      procedure :: get_field
   end type point_load_model_t

contains

   !> The model with its tables.
   subroutine new_point_load_model(self)
      !> The new model; receives its tables.
      type(point_load_model_t), intent(out) :: self
      type(variable_t) :: v(7)
      type(result_t) :: r(9)

      v(v_young_modulus) = positive(group='solid', name='young_modulus', unit='Pa', meaning='Young''s modulus')
      v(v_poisson_ratio) = poisson_ratio(group='solid', name='poisson_ratio', meaning='Poisson''s ratio')
      v(v_x) = number(group='position', name='position_x', unit='m', meaning='where the results are, along the tangential force', &
         & default=0.0_dp)
      v(v_y) = number(group='position', name='position_y', unit='m', &
         & meaning='where the results and the plane of the maps are, across it', default=0.0_dp)
      v(v_z) = number(group='position', name='position_z', unit='m', meaning='where the results are, depth', default=0.0_dp, &
         & lower=0.0_dp)
      v(v_normal) = number(group='operating', name='normal_load', unit='N', meaning='N, into the solid', default=0.0_dp)
      v(v_tangential) = number(group='operating', name='tangential_load', unit='N', meaning='T, along x', default=0.0_dp)
      call set_stresses('xx yy zz xy yz xz', r)
      call set_displacements('x y z', r(r_displacement_x:))
      call self%set_tables(name='point_load', &
         & summary='a point force on an elastic half-space (Boussinesq, Cerruti): stresses, displacements', variables=v, &
         & results=r, profiles=maps_of(r), axes='z x', is_depth=.true.)
   end subroutine new_point_load_model

   !> See `halfspace_model_t`.
   subroutine check_case(self, values, problems)
      !> The model; its tables give the variables their names.
      class(point_load_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call require(self%variables, values, [v_young_modulus, v_poisson_ratio], problems)
   end subroutine check_case

   !> See `field_model_t`.
   pure function get_place(self, values, slow, fast) result(place)
      !> The model; nothing is read from it here.
      class(point_load_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Coordinates on the axes of a map [m]; without them the place is that of the results.
      real(dp), intent(in), optional :: slow, fast
      real(dp) :: place(3)

      place = values(v_x:v_z)
      if (present(fast)) place(1) = fast
      if (present(slow)) place(3) = slow
      associate (unused => self)
      end associate
   end function get_place

   !> See `field_model_t`.
   subroutine get_field(self, values, place, field)
      !> The model; nothing is read from it here.
      class(point_load_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Coordinates x, y, z of the place [m].
      real(dp), intent(in) :: place(3)
      !> Results at the place, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(out) :: field(:)
      real(dp) :: shear_modulus

      shear_modulus = values(v_young_modulus)/(2*(1 + values(v_poisson_ratio)))
      field(r_stress_xx:r_stress_xz) = point_stress(values(v_normal), values(v_tangential), values(v_poisson_ratio), place)
      field(r_displacement_x:r_displacement_z) = point_displacement(values(v_normal), values(v_tangential), shear_modulus, &
         & values(v_poisson_ratio), place)
      associate (unused => self)
      end associate
   end subroutine get_field

end module adfric_plane_point_load_model
