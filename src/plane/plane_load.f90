! SPDX-License-Identifier: GPL-3.0-or-later
!> What the models of given tractions on a half-plane share: the solid, the place of the results, and the stresses there.
module adfric_plane_plane_load
   use adfric_base_kinds, only: dp
   use adfric_plane_field_model, only: field_model_t
   use adfric_describe_rows, only: positive, number, poisson_ratio
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: plane_load_model_t, set_plane_variables, set_stress

   !> Places of the variables that these models share; their own follow.
   integer, parameter, public :: v_young_modulus = 1, v_poisson_ratio = 2, v_x = 3, v_y = 4
   !> Places of the results that these models share; their own follow.
   integer, parameter, public :: r_stress_xx = 1, r_stress_xy = 3, r_shear = 4

   !> Given tractions on a half-plane.
   type, abstract, extends(field_model_t) :: plane_load_model_t
   contains
      procedure :: get_place
   end type plane_load_model_t

contains

   !> Set the rows that these models share.
   subroutine set_plane_variables(v)
      !> Table of variables; its first four rows are set.
      type(variable_t), intent(inout) :: v(:)

      v(v_young_modulus) = positive(group='solid', name='young_modulus', unit='Pa', meaning='Young''s modulus')
      v(v_poisson_ratio) = poisson_ratio(group='solid', name='poisson_ratio', meaning='Poisson''s ratio')
      v(v_x) = number(group='position', name='position_x', unit='m', meaning='where the results are, along the surface', &
         & default=0.0_dp)
      v(v_y) = number(group='position', name='position_y', unit='m', meaning='where the results are, depth', default=0.0_dp, &
         & lower=0.0_dp)
   end subroutine set_plane_variables

   !> See `field_model_t`.
   pure function get_place(self, values, slow, fast) result(place)
      !> The model; nothing is read from it here.
      class(plane_load_model_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Coordinates on the axes of a map [m]; without them the place is that of the results.
      real(dp), intent(in), optional :: slow, fast
      real(dp) :: place(3)

      place = [values(v_x), values(v_y), 0.0_dp]
      if (present(fast)) place(1) = fast
      if (present(slow)) place(2) = slow
      associate (unused => self)
      end associate
   end function get_place

   !> Set the stresses and their largest shear stress.
   pure subroutine set_stress(stress, field)
      !> Stresses s_xx, s_yy, s_xy at the place [Pa].
      real(dp), intent(in) :: stress(3)
      !> Results at the place; stresses and largest shear stress are set.
      real(dp), intent(inout) :: field(:)

      field(r_stress_xx:r_stress_xy) = stress
      field(r_shear) = hypot((stress(1) - stress(2))/2, stress(3))
   end subroutine set_stress

end module adfric_plane_plane_load
