! SPDX-License-Identifier: GPL-3.0-or-later
!> What an input of the model `adhesive_cylinder` may not say.
module adfric_plane_adhesive_cylinder_check
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set, unset
   use adfric_interface_adhesion_rows, only: check_stress
   use adfric_interface_friction_law_check, only: check_interface
   use adfric_interface_friction_law_rows, only: given_law_t, has_interface, needs_temperature
   use adfric_plane_adhesive_cylinder_point, only: is_possible_adhesive_cylinder
   use adfric_plane_adhesive_cylinder_variables, only: in => adhesive_cylinder_input
   use adfric_plane_sliding_check, only: check_sliding
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_solid_spectrum_rows, only: solid_shift_of
   use adfric_solid_time_temperature, only: shift_none, time_temperature_t
   use adfric_describe_check, only: require
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: check_adhesive_cylinder

contains

   !> Add to `problems` what is missing or impossible.
   subroutine check_adhesive_cylinder(variables, values, given, given_law, problems)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: given
      type(given_law_t), intent(in) :: given_law
      type(problems_t), intent(inout) :: problems
      type(time_temperature_t) :: of_solid
      real(dp) :: others(size(values))
      integer :: before

      before = problems%count()
      call require(variables, values, [in%radius, in%load, in%stress(1)], problems)
      associate (stress => values(in%stress(1)))
         if (is_set(stress)) call check_stress(variables(in%stress(1):in%branch), values(in%stress(1):in%branch), problems)
         if (is_set(stress) .and. .not. stress > 0) call problems%add('adhesion', variables(in%stress(1))%name, &
            & 'is 0; a cylinder without &adhesion has a closed form')
      end associate
      of_solid = solid_shift_of(values(in%material(1):in%temperature), given)
      others = values
      ! a solid without shift has no use for the temperature of the interface
      if (needs_temperature(values(in%friction)) .and. of_solid%law == shift_none) others(in%temperature) = unset
      call check_sliding(variables(in%material(1):in%velocity), others(in%material(1):in%velocity), given, problems)
      if (problems%count() > before) return
      if (has_interface(values(in%friction))) call check_interface(variables, values, in%friction, [in%temperature, in%velocity], &
         & given_law, of_solid, values(in%stress(1)), problems)
      if (.not. is_possible_adhesive_cylinder(values, given)) call problems%add('adhesion', variables(in%stress(1))%name, &
         & 'or the load or the velocity is too small or too large: with l = (R^2 w/E0)^(1/3), stress/(E0 l/R) is 1e-4 to 1e4 ' &
         & //'and load/(E0 l^2/R) at most 1e10')
   end subroutine check_adhesive_cylinder

end module adfric_plane_adhesive_cylinder_check
