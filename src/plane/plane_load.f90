! SPDX-License-Identifier: GPL-3.0-or-later
!> What the models of given tractions on a half-plane share: the solid, the position of the results, and the stresses there.
module adfric_plane_plane_load
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_plane_field_model, only: field_model_t
   use adfric_describe_rows, only: positive, number, poisson_ratio
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: plane_load_model_t, set_plane_variables, set_stress

   !> Variables in the order of their rows; a component is the index of its row.
   type :: plane_load_input_t
      !> Indices of the rows.
      integer :: young_modulus = 0, poisson_ratio = 0, x = 0, y = 0
   end type plane_load_input_t
   type(plane_load_input_t), parameter, public :: plane_load_input = transfer(counting, plane_load_input_t())
   !> Results in the order of their rows; a component is the index of its row.
   type :: plane_load_output_t
      !> Indices of the rows.
      integer :: stress_xx = 0, stress_yy = 0, stress_xy = 0, shear = 0
   end type plane_load_output_t
   type(plane_load_output_t), parameter, public :: plane_load_output = transfer(counting, plane_load_output_t())

   !> Given tractions on a half-plane.
   type, abstract, extends(field_model_t) :: plane_load_model_t
   contains
      procedure :: get_position
   end type plane_load_model_t

contains

   !> Set the rows that these models share.
   subroutine set_plane_variables(v)
      !> Table of variables; its first four rows are set.
      type(variable_t), intent(inout) :: v(:)

      v(plane_load_input%young_modulus) = positive(group='solid', name='young_modulus', unit='Pa', meaning='Young''s modulus')
      v(plane_load_input%poisson_ratio) = poisson_ratio(group='solid', name='poisson_ratio', meaning='Poisson''s ratio')
      v(plane_load_input%x) = number(group='position', name='position_x', unit='m', &
         & meaning='where the results are, along the surface', &
         & default=0.0_dp)
      v(plane_load_input%y) = number(group='position', name='position_y', unit='m', meaning='where the results are, depth', &
         & default=0.0_dp, &
         & lower=0.0_dp)
   end subroutine set_plane_variables

   !> See `field_model_t`.
   pure function get_position(self, values, slow, fast) result(position)
      class(plane_load_model_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Coordinates on the axes of a map [m]; without them the position is that of the results.
      real(dp), intent(in), optional :: slow, fast
      real(dp) :: position(3)

      position = [values(plane_load_input%x), values(plane_load_input%y), 0.0_dp]
      if (present(fast)) position(1) = fast
      if (present(slow)) position(2) = slow
      associate (unused => self)
      end associate
   end function get_position

   !> Set the stresses and their largest shear stress.
   pure subroutine set_stress(stress, field)
      !> Stresses s_xx, s_yy, s_xy at the position [Pa].
      real(dp), intent(in) :: stress(3)
      !> Results at the position; stresses and largest shear stress are set.
      real(dp), intent(inout) :: field(:)

      field(plane_load_output%stress_xx:plane_load_output%stress_xy) = stress
      field(plane_load_output%shear) = hypot((stress(1) - stress(2))/2, stress(3))
   end subroutine set_stress

end module adfric_plane_plane_load
