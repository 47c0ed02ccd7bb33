! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `point_load`: a point force on an elastic half-space (Boussinesq, Cerruti).
module adfric_plane_point_load_model
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_base_problems, only: problems_t
   use adfric_plane_boussinesq_cerruti, only: point_stress, point_displacement
   use adfric_plane_spatial_load, only: n_spatial, spatial_input_t, spatial_load_t, store_field
   use adfric_describe_check, only: require
   use adfric_describe_rows, only: number
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: point_load_model_t, new_point_load_model

   !> Variables in the order of their rows; a component is the index of its row.
   type, extends(spatial_input_t) :: point_load_input_t
      !> Indices of the rows of the load.
      integer :: normal = 0, tangential = 0
   end type point_load_input_t
   type(point_load_input_t), parameter :: in = transfer(counting, point_load_input_t())
   integer, parameter :: n_variables = storage_size(in)/storage_size(1)

   !> The model `point_load`.
   type, extends(spatial_load_t) :: point_load_model_t
   contains
      procedure :: check_case
      procedure :: get_field
   end type point_load_model_t

contains

   !> The model with its tables.
   subroutine new_point_load_model(self)
      !> The new model; receives its tables.
      type(point_load_model_t), intent(out) :: self
      type(variable_t) :: v(n_spatial + 1:n_variables)

      v(in%normal) = number(group='operating', name='normal_load', unit='N', meaning='N, into the solid', default=0.0_dp)
      v(in%tangential) = number(group='operating', name='tangential_load', unit='N', meaning='T, along x', default=0.0_dp)
      call self%set_load_tables('point_load', 'a point force on an elastic half-space (Boussinesq, Cerruti): stresses, ' &
         & //'displacements', 'where the results are, along the tangential force', &
         & 'where the results and the plane of the maps are, across it', v)
   end subroutine new_point_load_model

   !> See `halfspace_model_t`.
   subroutine check_case(self, values, problems)
      class(point_load_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call require(self%variables, values, [in%young_modulus, in%poisson_ratio], problems)
   end subroutine check_case

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

      shear_modulus = values(in%young_modulus)/(2*(1 + values(in%poisson_ratio)))
      call store_field(point_stress(values(in%normal), values(in%tangential), values(in%poisson_ratio), position), &
         & point_displacement(values(in%normal), values(in%tangential), shear_modulus, values(in%poisson_ratio), position), field)
      associate (unused => self)
      end associate
   end subroutine get_field

end module adfric_plane_point_load_model
