! SPDX-License-Identifier: GPL-3.0-or-later
!> What the models of a load on an elastic half-space in three dimensions share: the solid, the position, and stresses and displacements
!> there, or on a plane of depths. A model says what its load is.
module adfric_plane_spatial_load
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_plane_field_model, only: field_model_t, set_stresses, set_displacements, maps_of
   use adfric_describe_rows, only: positive, number, poisson_ratio
   use adfric_describe_table, only: result_t, variable_t
   implicit none (type, external)
   private
   public :: spatial_load_t, spatial_input_t, store_field, n_spatial

   !> Variables in the order of their rows; a component is the index of its row. Those of the load follow.
   type :: spatial_input_t
      !> Indices of the rows.
      integer :: young_modulus = 0, poisson_ratio = 0, x = 0, y = 0, z = 0
   end type spatial_input_t
   type(spatial_input_t), parameter :: spatial_input = transfer(counting, spatial_input_t())
   integer, parameter :: n_spatial = storage_size(spatial_input)/storage_size(1)
   !> Results in the order of their rows; a component is the index of its row.
   type :: spatial_output_t
      !> Indices of the rows.
      integer :: stress_xx = 0, stress_yy = 0, stress_zz = 0, stress_xy = 0, stress_yz = 0, stress_xz = 0, &
         & displacement_x = 0, displacement_y = 0, displacement_z = 0
   end type spatial_output_t
   type(spatial_output_t), parameter :: spatial_output = transfer(counting, spatial_output_t())
   integer, parameter :: n_results = storage_size(spatial_output)/storage_size(1)

   !> A load on an elastic half-space.
   type, abstract, extends(field_model_t) :: spatial_load_t
   contains
      procedure :: set_load_tables
      procedure :: get_position
   end type spatial_load_t

contains

   !> Set the tables of the model.
   subroutine set_load_tables(self, name, summary, along_x, along_y, load)
      class(spatial_load_t), intent(inout) :: self
      !> Name of the model, and what it is in one line.
      character(*), intent(in) :: name, summary
      !> What the positions along x and y are.
      character(*), intent(in) :: along_x, along_y
      !> Rows of the load.
      type(variable_t), intent(in) :: load(:)
      type(variable_t) :: v(n_spatial + size(load))
      type(result_t) :: r(n_results)

      v(spatial_input%young_modulus) = positive(group='solid', name='young_modulus', unit='Pa', meaning='Young''s modulus')
      v(spatial_input%poisson_ratio) = poisson_ratio(group='solid', name='poisson_ratio', meaning='Poisson''s ratio')
      v(spatial_input%x) = number(group='position', name='position_x', unit='m', meaning=along_x, default=0.0_dp)
      v(spatial_input%y) = number(group='position', name='position_y', unit='m', meaning=along_y, default=0.0_dp)
      v(spatial_input%z) = number(group='position', name='position_z', unit='m', meaning='where the results are, depth', &
         & default=0.0_dp, lower=0.0_dp)
      v(n_spatial + 1:) = load
      call set_stresses('xx yy zz xy yz xz', r)
      call set_displacements('x y z', r(spatial_output%displacement_x:))
      call self%set_tables(name=name, summary=summary, variables=v, results=r, profiles=maps_of(r), axes='z x', is_depth=.true.)
   end subroutine set_load_tables

   !> See `field_model_t`.
   pure function get_position(self, values, slow, fast) result(position)
      class(spatial_load_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Coordinates on the axes of a map [m]; without them the position is that of the results.
      real(dp), intent(in), optional :: slow, fast
      real(dp) :: position(3)

      position = values(spatial_input%x:spatial_input%z)
      if (present(fast)) position(1) = fast
      if (present(slow)) position(3) = slow
      associate (unused => self)
      end associate
   end function get_position

   !> Store stresses and displacements.
   pure subroutine store_field(stress, displacement, field)
      !> Stresses [Pa], in the order of the results, and displacements [m].
      real(dp), intent(in) :: stress(:), displacement(:)
      !> Receives the results; shape `(n_results)`.
      real(dp), intent(out) :: field(:)

      field(spatial_output%stress_xx:spatial_output%stress_xz) = stress
      field(spatial_output%displacement_x:spatial_output%displacement_z) = displacement
   end subroutine store_field

end module adfric_plane_spatial_load
