! SPDX-License-Identifier: GPL-3.0-or-later
!> What an input of the model `rough_theories` may not say.
module adfric_rough_check
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_number
   use adfric_base_unset, only: is_set
   use adfric_describe_check, only: checks_t, new_checks
   use adfric_describe_table, only: variable_t
   use adfric_interface_conduction_rows, only: check_conduction, n_conduction_rows
   use adfric_interface_adhesion_rows, only: check_stress, has_adhesion, n_stress_rows
   use adfric_rough_pressed_theories, only: least_mean_pressure
   use adfric_rough_variables, only: in => rough_input
   use adfric_shape_power_spectrum, only: check_density, given_density_t, n_density_rows
   use adfric_solid_contact_modulus, only: check_contact_modulus
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_solid_spectrum_rows, only: check_spectrum, has_spectrum, needs_velocity
   implicit none (type, external)
   private
   public :: check_rough, relaxes, adheres

contains

   !> Add to `problems` what is missing or impossible.
   subroutine check_rough(variables, values, is_swept, given, density, problems)
      type(variable_t), intent(in), target :: variables(:)
      real(dp), intent(in), target :: values(:)
      logical, intent(in), target :: is_swept(:)
      !> Lists and datasets of the solid.
      type(given_spectrum_t), intent(in) :: given
      !> Table of the power spectrum.
      type(given_density_t), intent(in) :: density
      type(problems_t), intent(inout), target :: problems
      type(checks_t) :: c

      call new_checks(c, variables, values, problems, is_swept)
      call check_solid(c, variables, values, is_swept, given)
      call check_density(variables(:n_density_rows), values(:n_density_rows), is_swept(:n_density_rows), density, &
         & problems)
   end subroutine check_rough

   !> Is the solid one that relaxes?
   pure logical function relaxes(values)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      relaxes = has_spectrum(values(in%material(1):in%temperature))
   end function relaxes

   !> Is there adhesion?
   pure logical function adheres(values)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      adheres = any(is_set(values(in%adhesion)))
   end function adheres

   !> The solid and what goes with it.
   subroutine check_solid(c, variables, values, is_swept, given)
      type(checks_t), intent(in) :: c
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      logical, intent(in) :: is_swept(:)
      type(given_spectrum_t), intent(in) :: given
      integer :: k

      if (relaxes(values)) then
         call c%refuse([(k, k=in%contact_modulus, in%second_poisson_ratio)], 'stands beside &material; give one solid')
         call c%refuse(in%adhesion, 'stands beside a solid that relaxes; its pull-off has no theory here')
         call c%refuse(in%conduction, 'stands beside a solid that relaxes; its stiffness has no theory here')
         call check_spectrum(variables(in%material(1):in%temperature), values(in%material(1):in%temperature), given, &
            & is_swept(in%material(1):in%temperature), c%problems)
         call check_pressure(c, values)
         call c%add(in%velocity, 'is missing [m/s]; '//needs_velocity, .not. c%has(in%velocity))
         return
      end if
      call check_contact_modulus(variables(in%contact_modulus:in%second_poisson_ratio), &
         & values(in%contact_modulus:in%second_poisson_ratio), c%problems, .true.)
      call c%refuse([in%temperature, in%velocity], 'has no meaning without &material; over an elastic solid nothing rubs')
      if (adheres(values)) then
         call check_stress(variables(in%adhesion(1):in%adhesion(n_stress_rows)), values(in%adhesion), c%problems)
         if (is_set(values(in%adhesion(1)))) call c%add(in%adhesion(1), 'is 0; leave adhesion out, or give a tension', &
            & .not. has_adhesion([values(in%adhesion), 0.0_dp, 0.0_dp]))
         call c%refuse([in%mean_pressure], 'stands beside adhesion, whose theories give pull-off alone')
         call c%refuse(in%conduction, 'stands beside adhesion, whose theories give pull-off alone')
      else
         call check_pressure(c, values)
         call check_conduction(variables(in%conduction(1):in%conduction(n_conduction_rows)), values(in%conduction), c%problems)
      end if
   end subroutine check_solid

   !> A pressure, where one is needed: beside adhesion it is refused at any size, so its row allows 0.
   subroutine check_pressure(c, values)
      type(checks_t), intent(in) :: c
      real(dp), intent(in) :: values(:)

      call c%need([in%mean_pressure])
      if (.not. c%has(in%mean_pressure)) return
      call c%add(in%mean_pressure, 'is below 1e-30, given '//show_number(values(in%mean_pressure))// &
         & ' [Pa]; the theories need a load', values(in%mean_pressure) < least_mean_pressure)
   end subroutine check_pressure

end module adfric_rough_check
