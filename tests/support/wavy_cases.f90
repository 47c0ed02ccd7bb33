! SPDX-License-Identifier: GPL-3.0-or-later
!> Values of the model `wavy_sliding` as an input would give them.
module wavy_cases
   use adfric_base_kinds, only: dp
   use adfric_foundation_model, only: wavy_model_t, new_wavy_model
   use adfric_foundation_variables, only: in => foundation_input
   use model_calls, only: set_value, find_problems, solve_values, solve_point
   implicit none (type, external)
   private
   public :: new_values, set_value, find_problems, solve_values, solve_point

contains

   !> A 2-D wave with adhesion of finite range at a given penetration.
   subroutine new_values(model, values)
      type(wavy_model_t), intent(out) :: model
      real(dp), allocatable, intent(out) :: values(:)

      call new_wavy_model(model)
      values = model%variables%default
      values(in%kind) = 1
      values(in%period) = 1.0e-2_dp
      values(in%height) = 1.0e-4_dp
      values(in%stiffness) = 1.0e8_dp
      values(in%relaxation_time) = 1.0e-3_dp
      values(in%retardation_ratio) = 10
      values(in%stress) = 2.0e3_dp
      values(in%range) = 1.0e-5_dp
      values(in%velocity) = 0.5_dp
      values(in%penetration) = 4.0e-5_dp
   end subroutine new_values

end module wavy_cases
