! SPDX-License-Identifier: GPL-3.0-or-later
!> The namelist variables and results of the model `wave_1d`.
module adfric_plane_wave_variables
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_interface_adhesion_rows, only: branches_differ_row, set_adhesion_rows, n_adhesion_rows
   use adfric_solid_contact_modulus, only: set_modulus_rows
   use adfric_interface_conduction_rows, only: conduction_results, n_conduction_results, n_conduction_rows, set_conduction_rows
   use adfric_interface_coulomb_rows, only: set_coulomb_rows, slip_results
   use adfric_interface_friction_law_rows, only: set_law_rows, n_law_rows
   use adfric_interface_shear_coupling, only: coupling_results, coupling_row
   use adfric_interface_shear_strength_rows, only: set_shear_rows, n_shear_rows
   use adfric_interface_total_friction, only: total_friction_results
   use adfric_solid_spectrum_rows, only: set_spectrum_rows, n_spectrum_rows
   use adfric_describe_rows, only: positive, number, result_row
   use adfric_describe_table, only: variable_t, result_t
   implicit none (type, external)
   private
   public :: get_wave_variables, get_wave_results

   !> Variables in the order of their rows; a component is the index of its row.
   type :: wave_input_t
      !> Indices of the rows.
      integer :: period = 0, amplitude = 0, contact_modulus = 0, young_modulus = 0, poisson_ratio = 0, &
         & second_young_modulus = 0, second_poisson_ratio = 0, adhesion = 0, surface_energy = 0, adhesion_range = 0, &
         & branch = 0, turning_pressure = 0, material(n_spectrum_rows - 1) = 0, temperature = 0, velocity = 0, &
         & mean_pressure = 0, penetration = 0, shear_strength = 0, pressure_factor = 0, tangential_stress = 0, &
         & tangential_axis = 0, coefficient = 0, law(n_law_rows) = 0, coupling = 0, conduction(n_conduction_rows) = 0
   end type wave_input_t
   type(wave_input_t), parameter, public :: wave_input = transfer(counting, wave_input_t())
   !> Results in the order of their rows; a component is the index of its row.
   type :: wave_output_t
      !> Indices of the rows.
      integer :: mean_pressure = 0, penetration = 0, contact_width = 0, contact_fraction = 0, peak_pressure = 0, &
         & mean_gap = 0, largest_gap = 0, full_contact_pressure = 0, regime = 0, violation = 0, friction_stress = 0, &
         & friction_coefficient = 0, contact_shift = 0, dissipation = 0, energy_imbalance = 0, adhesion_fraction = 0, &
         & elastic_energy = 0, adhesion_energy = 0, pull_off_pressure = 0, pull_off_penetration = 0, &
         & jump_off_penetration = 0, hysteresis_loss = 0, saturation_fold_pressure = 0, end_of_saturation_pressure = 0, &
         & branches_differ = 0, order_margin = 0, zone_leading = 0, zone_trailing = 0, friction_without_adhesion = 0, &
         & adhesive_friction_stress = 0, stick_fraction = 0, tangential_displacement = 0, &
         & tangential_stiffness = 0, cycle_energy = 0, hysteretic_friction_stress = 0, interfacial_friction_stress = 0, &
         & interfacial_share = 0, velocity_slope = 0, largest_coupling = 0, smallest_stiffness_ratio = 0, &
         & coupling_left_out = 0, contact_stiffness = 0, conductances(n_conduction_results) = 0
   end type wave_output_t
   type(wave_output_t), parameter, public :: wave_output = transfer(counting, wave_output_t())
   !> Number of results.
   integer, parameter :: n_results = storage_size(wave_output)/storage_size(1)
   !> Indices in the meanings of `regime`, from 0.
   integer, parameter, public :: regime_none = 0, regime_partial = 1, regime_full = 2, regime_adhesion_only = 3, &
      & regime_adhesion_zones = 4, regime_saturated_adhesion = 5

contains

   !> The table of variables.
   function get_wave_variables() result(v)
      type(variable_t), allocatable :: v(:)

      allocate (v(storage_size(wave_input)/storage_size(1)))
      v(wave_input%period) = positive(group='surface', name='period', unit='m', meaning='wavelength l')
      v(wave_input%amplitude) = positive(group='surface', name='amplitude', unit='m', &
         & meaning='D of the wave z = D (1 - cos 2 pi x/l)')
      call set_modulus_rows(positive(group='solid', name='contact_modulus', unit='Pa', meaning=''), &
         & v(wave_input%contact_modulus:wave_input%second_poisson_ratio))
      call set_adhesion_rows(v(wave_input%adhesion:wave_input%turning_pressure))
      call set_spectrum_rows(v(wave_input%material(1):wave_input%temperature))
      ! a sweep of a modulus means the one of `solid`, where both have the name
      v(wave_input%material(1):wave_input%temperature &
         & - 1)%has_bare_name = .not. is_of_solid(v(wave_input%material(1):wave_input%temperature - 1))
      v(wave_input%velocity) = number(group='operating', name='velocity', unit='m/s', &
         & meaning='sliding velocity over the material, positive to +x')
      v(wave_input%mean_pressure) = number(group='operating', name='mean_pressure', unit='Pa', &
         & meaning='load over nominal area; below 0 with adhesion alone')
      v(wave_input%penetration) = number(group='operating', name='penetration', unit='m', &
         & meaning='approach of the mean planes since first touch, instead')
      call set_shear_rows(v(wave_input%shear_strength:wave_input%pressure_factor))
      call set_coulomb_rows(v(wave_input%tangential_stress:wave_input%coefficient))
      call set_law_rows(v(wave_input%law(1):wave_input%law(n_law_rows)))
      v(wave_input%coupling) = coupling_row()
      call set_conduction_rows(v(wave_input%conduction(1):))
   end function get_wave_variables

   !> Does the group `solid` have a variable of the same name?
   elemental logical function is_of_solid(variable)
      type(variable_t), intent(in) :: variable

      is_of_solid = variable%name == 'young_modulus' .or. variable%name == 'poisson_ratio'
   end function is_of_solid

   !> The table of results.
   function get_wave_results() result(r)
      type(result_t), allocatable :: r(:)

      allocate (r(n_results))
      r(wave_output%mean_pressure) = result_row(name='mean_pressure', unit='Pa', long_name='load over nominal area', is_main=.true.)
      r(wave_output%penetration) = result_row(name='penetration', unit='m', &
         & long_name='approach of the mean planes since first touch', &
         & is_main=.true.)
      r(wave_output%contact_width) = result_row(name='contact_width', unit='m', long_name='width 2a of contact on one wave', &
         & is_main=.true.)
      r(wave_output%contact_fraction) = result_row(name='contact_fraction', unit='-', &
         & long_name='share of the wave in contact', is_main=.true.)
      r(wave_output%peak_pressure) = result_row(name='peak_pressure', unit='Pa', &
         & long_name='largest pressure, at rest that on the crests', &
         & is_main=.true.)
      r(wave_output%mean_gap) = result_row(name='mean_gap', unit='m', long_name='mean gap')
      r(wave_output%largest_gap) = result_row(name='largest_gap', unit='m', long_name='largest gap, at rest that in the troughs')
      r(wave_output%full_contact_pressure) = result_row(name='full_contact_pressure', unit='Pa', &
         & long_name='where full contact begins without adhesion; at rest p* = pi E* D/l')
      r(wave_output%regime) = result_row(name='regime', unit='-', long_name='regime', &
         & flag_meanings='no_contact partial full adhesion_without_contact adhesion_zones saturated_adhesion')
      r(wave_output%violation) = result_row(name='contact_violation', unit='-', &
         & long_name='largest violation of g >= 0, p >= 0, g p = 0, with adhesion of p >= -p0 and of its range')
      r(wave_output%friction_stress) = result_row(name='friction_stress', unit='Pa', &
         & long_name='friction force over nominal area, of losses and of the interface, with the sign of the velocity', &
         & is_main=.true.)
      r(wave_output%friction_coefficient) = result_row(name='friction_coefficient', unit='-', &
         & long_name='friction stress over mean pressure', is_main=.true.)
      r(wave_output%contact_shift) = result_row(name='contact_shift', unit='m', &
         & long_name='middle of the contact from the crest, positive to +x; no value without contact and in full contact')
      r(wave_output%dissipation) = result_row(name='dissipation', unit='Pa', &
         & long_name='energy lost over nominal area and distance, in closed form')
      r(wave_output%energy_imbalance) = result_row(name='energy_imbalance', unit='-', &
         & long_name='work of the pressure, from its profile, less the dissipation, over the dissipation')
      r(wave_output%adhesion_fraction) = result_row(name='adhesion_fraction', unit='-', &
         & long_name='share of the wave in adhesion without contact')
      r(wave_output%elastic_energy) = result_row(name='elastic_energy', unit='J/m^2', &
         & long_name='energy of the elastic solid over nominal area')
      r(wave_output%adhesion_energy) = result_row(name='adhesion_energy', unit='J/m^2', &
         & long_name='energy of adhesion over nominal area, 0 far apart')
      r(wave_output%pull_off_pressure) = result_row(name='pull_off_pressure', unit='Pa', &
         & long_name='least mean pressure of the adhered branch', is_main=.true.)
      r(wave_output%pull_off_penetration) = result_row(name='pull_off_penetration', unit='m', &
         & long_name='penetration of the least mean pressure of the adhered branch')
      r(wave_output%jump_off_penetration) = result_row(name='jump_off_penetration', unit='m', &
         & long_name='least penetration of the adhered branch')
      r(wave_output%hysteresis_loss) = result_row(name='hysteresis_loss', unit='J/m^2', &
         & long_name='energy lost over nominal area by approach and parting at given penetrations')
      call set_sliding_adhesion_results(r)
      r(wave_output%stick_fraction:wave_output%cycle_energy) = slip_results()
      r(wave_output%hysteretic_friction_stress:wave_output%velocity_slope) = total_friction_results('stress', 'Pa')
      r(wave_output%largest_coupling:wave_output%coupling_left_out) = coupling_results()
      r(wave_output%contact_stiffness) = result_row(name='contact_stiffness', unit='Pa/m', &
         & long_name='slope of the mean pressure over the approach, at rest without adhesion; none in full contact')
      r(wave_output%conductances(1):) = conduction_results(.true.)
   end function get_wave_results

   !> Rows of results of adhesion while the wave slides.
   subroutine set_sliding_adhesion_results(r)
      !> All rows.
      type(result_t), intent(inout) :: r(:)

      r(wave_output%saturation_fold_pressure) = result_row(name='saturation_fold_pressure', unit='Pa', &
         & long_name='largest mean pressure of a partial contact at this velocity')
      r(wave_output%end_of_saturation_pressure) = result_row(name='end_of_saturation_pressure', unit='Pa', &
         & long_name='least mean pressure with all of the gap in range at this velocity')
      r(wave_output%branches_differ) = branches_differ_row()
      r(wave_output%order_margin) = result_row(name='order_margin', unit='-', &
         & long_name='order of states M/Einf; where >= 0 the branches bound all states')
      r(wave_output%zone_leading) = result_row(name='zone_leading', unit='m', &
         & long_name='length of the adhesion zone ahead of the contact')
      r(wave_output%zone_trailing) = result_row(name='zone_trailing', unit='m', &
         & long_name='length of the adhesion zone behind the contact')
      r(wave_output%friction_without_adhesion) = result_row(name='friction_stress_without_adhesion', unit='Pa', &
         & long_name='friction over nominal area of the same load and velocity without adhesion')
      r(wave_output%adhesive_friction_stress) = result_row(name='adhesive_friction_stress', unit='Pa', &
         & long_name='friction stress less that without adhesion')
   end subroutine set_sliding_adhesion_results

end module adfric_plane_wave_variables
