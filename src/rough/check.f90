! SPDX-License-Identifier: GPL-3.0-or-later
!> What an input of the model `rough_theories` may not say.
module adfric_rough_check
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_number
   use adfric_base_unset, only: is_set
   use adfric_describe_check, only: checks_t, new_checks
   use adfric_describe_table, only: variable_t
   use adfric_interface_adhesion_rows, only: check_stress, has_adhesion, n_stress_rows
   use adfric_rough_height_spectrum, only: height_spectrum_t
   use adfric_rough_variables, only: given_density_t, in => rough_input, is_rising, make_spectrum
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
      type(height_spectrum_t) :: spectrum
      logical :: is_possible
      integer :: before

      before = problems%count()
      call new_checks(c, variables, values, problems, is_swept)
      call check_solid(c, variables, values, is_swept, given)
      if (c%has_any([in%wave_numbers, in%densities])) then
         call check_table(c, density)
      else
         call check_self_affine(c, values)
      end if
      if (problems%count() > before) return
      call make_spectrum(values, density, spectrum, is_possible)
      if (is_possible) return
      if (c%has(in%densities)) then
         call c%add(in%densities, 'leads to moments above 1e120 or below 1e-120, or waves of lengths above 1e12 times the shortest')
      else
         call c%add(in%shortest_wavelength, 'leads to moments above 1e120 or below 1e-120, or is below 1e-12 of the longest')
      end if
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
      else
         call check_pressure(c, values)
      end if
   end subroutine check_solid

   !> A pressure, where one is needed: beside adhesion it is refused at any size, so its row allows 0.
   subroutine check_pressure(c, values)
      type(checks_t), intent(in) :: c
      real(dp), intent(in) :: values(:)

      call c%need([in%mean_pressure])
      if (.not. c%has(in%mean_pressure)) return
      call c%add(in%mean_pressure, 'is below 1e-30, given '//show_number(values(in%mean_pressure))// &
         & ' [Pa]; the theories need a load', values(in%mean_pressure) < 1.0e-30_dp)
   end subroutine check_pressure

   !> A self-affine spectrum.
   subroutine check_self_affine(c, values)
      type(checks_t), intent(in) :: c
      real(dp), intent(in) :: values(:)

      call c%need([in%hurst_exponent, in%shortest_wavelength])
      call c%add(in%longest_wavelength, 'is missing [m]; or give rolloff_wavelength', &
         & .not. c%has_any([in%longest_wavelength, in%rolloff_wavelength]))
      call c%need_one([in%root_mean_square_height, in%root_mean_square_slope, in%plateau_density], .true.)
      call c%refuse([in%convention], 'is one of a table; wavelengths and plateau_density need none')
      if (.not. c%has(in%shortest_wavelength) .or. .not. c%has_any([in%longest_wavelength, in%rolloff_wavelength])) return
      if (is_rising(values)) return
      call c%add(in%shortest_wavelength, 'is not below rolloff_wavelength and longest_wavelength in this order, given '// &
         & show_number(values(in%shortest_wavelength))//' [m]')
   end subroutine check_self_affine

   !> A table of a spectrum.
   subroutine check_table(c, density)
      type(checks_t), intent(in) :: c
      type(given_density_t), intent(in) :: density
      integer :: n

      call c%need([in%wave_numbers, in%densities, in%convention])
      call c%refuse([in%hurst_exponent, in%shortest_wavelength, in%rolloff_wavelength, in%longest_wavelength, &
         & in%root_mean_square_height, in%root_mean_square_slope, in%plateau_density], 'stands beside a table of densities')
      if (.not. (allocated(density%wave_numbers) .and. allocated(density%densities))) return
      n = size(density%wave_numbers)
      call c%add(in%densities, 'has another number of values than wave_numbers', size(density%densities) /= n)
      call c%add(in%wave_numbers, 'does not rise from value to value', &
         & any(.not. density%wave_numbers(2:) > density%wave_numbers(:n - 1)*(1 + 1.0e-12_dp)))
   end subroutine check_table

end module adfric_rough_check
