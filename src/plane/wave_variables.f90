! SPDX-License-Identifier: GPL-3.0-or-later
!> The namelist variables and results of the model `wave_1d`.
module adfric_plane_wave_variables
   use adfric_base_kinds, only: dp
   use adfric_interface_adhesion_rows, only: set_adhesion_rows, n_adhesion_rows
   use adfric_solid_contact_modulus, only: set_modulus_rows
   use adfric_interface_coulomb_rows, only: n_coulomb_rows, n_slip_results, set_coulomb_rows, slip_results
   use adfric_interface_shear_strength_rows, only: set_shear_rows, n_shear_rows
   use adfric_solid_spectrum_rows, only: set_spectrum_rows, n_spectrum_rows
   use adfric_describe_rows, only: positive, number, result_row
   use adfric_describe_table, only: variable_t, result_t
   implicit none (type, external)
   private
   public :: get_wave_variables, get_wave_results

   !> Places of the variables. Those of adhesion stand between `v_adhesion` and `v_turning_pressure`, those of the material between
   !> `v_material` and `v_temperature`.
   integer, parameter, public :: v_period = 1, v_amplitude = 2, v_contact_modulus = 3, v_poisson_ratio = 5, &
      & v_second_poisson_ratio = 7, &
      & v_adhesion = 8, v_branch = v_adhesion + 3, v_turning_pressure = v_adhesion - 1 + n_adhesion_rows, &
      & v_material = v_turning_pressure + 1, v_temperature = v_material - 1 + n_spectrum_rows, v_velocity = v_temperature + 1, &
      & v_mean_pressure = v_temperature + 2, v_penetration = v_temperature + 3, &
      & v_shear_strength = v_penetration + 1, v_pressure_factor = v_penetration + n_shear_rows, &
      & v_tangential_stress = v_pressure_factor + 1, v_coefficient = v_pressure_factor + n_coulomb_rows
   !> Places of the results; those from `r_contact_shift` on belong to sliding, friction also to a shear strength, those from
   !> `r_adhesion_fraction` on to adhesion, those from `r_stick_fraction` on to partial slip.
   integer, parameter, public :: r_mean_pressure = 1, r_penetration = 2, r_contact_width = 3, r_contact_fraction = 4, &
      & r_peak_pressure = 5, r_mean_gap = 6, r_largest_gap = 7, r_full_contact_pressure = 8, r_regime = 9, r_violation = 10, &
      & r_friction_stress = 11, r_friction_coefficient = 12, r_contact_shift = 13, r_dissipation = 14, r_energy_imbalance = 15, &
      & r_adhesion_fraction = 16, r_elastic_energy = 17, r_adhesion_energy = 18, r_pull_off_pressure = 19, &
      & r_pull_off_penetration = 20, r_jump_off_penetration = 21, r_hysteresis_loss = 22, &
      & r_stick_fraction = 23, r_tangential_displacement = 24, r_tangential_stiffness = 25, r_cycle_energy = 26
   !> Number of results.
   integer, parameter :: n_results = r_hysteresis_loss + n_slip_results
   !> Places in the meanings of `regime`, from 0.
   integer, parameter, public :: regime_none = 0, regime_partial = 1, regime_full = 2, regime_adhesion_only = 3, &
      & regime_adhesion_zones = 4, regime_saturated_adhesion = 5

contains

   !> The table of variables.
   function get_wave_variables() result(v)
      type(variable_t), allocatable :: v(:)

      allocate (v(v_coefficient))
      v(v_period) = positive(group='surface', name='period', unit='m', meaning='wavelength l')
      v(v_amplitude) = positive(group='surface', name='amplitude', unit='m', meaning='D of the wave z = D (1 - cos 2 pi x/l)')
      call set_modulus_rows(positive(group='solid', name='contact_modulus', unit='Pa', meaning=''), &
         & v(v_contact_modulus:v_second_poisson_ratio))
      call set_adhesion_rows(v(v_adhesion:v_turning_pressure))
      call set_spectrum_rows(v(v_material:v_temperature))
      ! a sweep of a modulus means the one of `solid`, where both have the name
      v(v_material:v_temperature - 1)%has_bare_name = .not. is_of_solid(v(v_material:v_temperature - 1))
      v(v_velocity) = number(group='operating', name='velocity', unit='m/s', &
         & meaning='sliding velocity over the material, positive to +x')
      v(v_mean_pressure) = number(group='operating', name='mean_pressure', unit='Pa', &
         & meaning='load over nominal area; below 0 with adhesion alone')
      v(v_penetration) = number(group='operating', name='penetration', unit='m', &
         & meaning='approach of the mean planes since first touch, instead')
      call set_shear_rows(v(v_shear_strength:v_pressure_factor))
      call set_coulomb_rows(v(v_tangential_stress:v_coefficient))
   end function get_wave_variables

   !> Does the group `solid` have a variable of the same name?
   elemental logical function is_of_solid(variable)
      !> A variable of another group.
      type(variable_t), intent(in) :: variable

      is_of_solid = variable%name == 'young_modulus' .or. variable%name == 'poisson_ratio'
   end function is_of_solid

   !> The table of results.
   function get_wave_results() result(r)
      type(result_t), allocatable :: r(:)

      allocate (r(n_results))
      r(r_mean_pressure) = result_row(name='mean_pressure', unit='Pa', long_name='load over nominal area', is_main=.true.)
      r(r_penetration) = result_row(name='penetration', unit='m', long_name='approach of the mean planes since first touch', &
         & is_main=.true.)
      r(r_contact_width) = result_row(name='contact_width', unit='m', long_name='width 2a of contact on one wave', is_main=.true.)
      r(r_contact_fraction) = result_row(name='contact_fraction', unit='-', long_name='share of the wave in contact')
      r(r_peak_pressure) = result_row(name='peak_pressure', unit='Pa', long_name='largest pressure, at rest that on the crests', &
         & is_main=.true.)
      r(r_mean_gap) = result_row(name='mean_gap', unit='m', long_name='mean gap')
      r(r_largest_gap) = result_row(name='largest_gap', unit='m', long_name='largest gap, at rest that in the troughs')
      r(r_full_contact_pressure) = result_row(name='full_contact_pressure', unit='Pa', &
         & long_name='where full contact begins without adhesion; at rest p* = pi E* D/l')
      r(r_regime) = result_row(name='regime', unit='-', long_name='regime', &
         & flag_meanings='no_contact partial full adhesion_without_contact adhesion_zones saturated_adhesion')
      r(r_violation) = result_row(name='contact_violation', unit='-', &
         & long_name='largest violation of g >= 0, p >= 0, g p = 0, with adhesion of p >= -p0 and of its range')
      r(r_friction_stress) = result_row(name='friction_stress', unit='Pa', &
         & long_name='friction force over nominal area: of losses, with the sign of the velocity, or of a shear strength')
      r(r_friction_coefficient) = result_row(name='friction_coefficient', unit='-', &
         & long_name='friction stress over mean pressure', is_main=.true.)
      r(r_contact_shift) = result_row(name='contact_shift', unit='m', &
         & long_name='middle of the contact from the crest, positive to +x; no value without contact and in full contact')
      r(r_dissipation) = result_row(name='dissipation', unit='Pa', &
         & long_name='energy lost over nominal area and distance, in closed form')
      r(r_energy_imbalance) = result_row(name='energy_imbalance', unit='-', &
         & long_name='work of the pressure, from its profile, less the dissipation, over the dissipation')
      r(r_adhesion_fraction) = result_row(name='adhesion_fraction', unit='-', &
         & long_name='share of the wave in adhesion without contact')
      r(r_elastic_energy) = result_row(name='elastic_energy', unit='J/m^2', &
         & long_name='energy of the elastic solid over nominal area')
      r(r_adhesion_energy) = result_row(name='adhesion_energy', unit='J/m^2', &
         & long_name='energy of adhesion over nominal area, 0 far apart')
      r(r_pull_off_pressure) = result_row(name='pull_off_pressure', unit='Pa', &
         & long_name='least mean pressure of the adhered branch')
      r(r_pull_off_penetration) = result_row(name='pull_off_penetration', unit='m', &
         & long_name='penetration of the least mean pressure of the adhered branch')
      r(r_jump_off_penetration) = result_row(name='jump_off_penetration', unit='m', &
         & long_name='least penetration of the adhered branch')
      r(r_hysteresis_loss) = result_row(name='hysteresis_loss', unit='J/m^2', &
         & long_name='energy lost over nominal area by approach and parting at given penetrations')
      r(r_stick_fraction:r_cycle_energy) = slip_results()
   end function get_wave_results

end module adfric_plane_wave_variables
