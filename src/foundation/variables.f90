! SPDX-License-Identifier: GPL-3.0-or-later
!> The namelist variables and results of the model `wavy_sliding`.
module adfric_foundation_variables
   use adfric_base_kinds, only: dp
   use adfric_interface_adhesion_rows, only: set_stress_rows, branch_row
   use adfric_solid_given_spectrum, only: set_arm_rows
   use adfric_solid_prony, only: most_arms
   use adfric_solid_shift_rows, only: set_shift_rows
   use adfric_describe_rows, only: above_zero, any_number, choice, dataset, list_row, poisson_ratio, switch, whole_number, result_row
   use adfric_describe_table, only: variable_t, result_t, profile_t
   use adfric_foundation_strip, only: regime_meanings
   implicit none (type, external)
   private
   public :: get_wavy_variables, get_wavy_results, get_wavy_profiles

   !> Places of the variables.
   integer, parameter, public :: v_kind = 1, v_period = 2, v_height = 3, v_slope = 4, v_heights = 5, v_spacing = 6, &
      & v_strip_spacing = 7, v_amplitudes = 8, v_phases = 9, v_interpolation = 10, v_detrend = 11, v_periodise = 12, &
      & v_blend_share = 13, v_shortest_wavelength = 14, v_reverse = 15, v_height_factor = 16, v_stiffness = 17, &
      & v_young_modulus = 18, v_poisson_ratio = 19, v_thickness = 20, v_relaxation_time = 21, &
      & v_retardation_ratio = 22, v_moduli = 23, v_young_moduli = 24, v_relaxation_times = 25, v_master_curve = 26, &
      & v_relaxed_modulus = 27, v_terms_per_decade = 28, v_time_factor = 29, v_shift = 30, v_reference_temperature = 31, &
      & v_wlf_c1 = 32, v_wlf_c2 = 33, v_activation_energy = 34, v_stress = 35, v_surface_energy = 36, v_range = 37, v_edge = 38, &
      & v_branch = 39, v_velocity = 40, v_temperature = 41, v_load = 42, v_mean_pressure = 43, v_penetration = 44, &
      & v_relative_tolerance = 45, v_strips = 46, v_pull_off = 47, v_profiles = 48, v_n_x = 49, v_n_y = 50
   integer, parameter :: n_variables = 50

   !> Places of the results.
   integer, parameter, public :: r_load = 1, r_penetration = 2, r_friction_force = 3, r_friction_coefficient = 4, &
      & r_contact_area = 5, r_adhesion_area = 6, r_contact_width = 7, r_contact_shift = 8, r_regime = 9, &
      & r_dissipation = 10, r_edge_loss = 11, r_energy_imbalance = 12, r_pull_off_load = 13, &
      & r_pull_off_penetration = 14, r_contact_count = 15, r_adhesion_count = 16, r_snap_count = 17, r_saturated_share = 18, &
      & r_friction_sample_error = 19
   integer, parameter, public :: n_wavy_results = 19

contains

   !> The table of variables.
   function get_wavy_variables() result(v)
      type(variable_t), allocatable :: v(:)

      allocate (v(n_variables))
      v(v_kind) = choice(group='surface', name='kind', &
         & meaning='one wave (wave_2d), waves in both directions (wave_3d), a line of heights (profile), a sum of waves ' &
         & //'(cosines), or heights over x and y, whose rows are strips (map); forces are per width but for wave_3d and map', &
         & choices='wave_2d wave_3d profile cosines map')
      v(v_period) = above_zero(group='surface', name='period', unit='m', meaning='period of waves and cosines')
      v(v_height) = above_zero(group='surface', name='height', unit='m', meaning='peak-to-valley height of a wave')
      v(v_slope) = choice(group='surface', name='slope', meaning='shear stress p f'' (small) or p sin(arctan f'') (finite)', &
         & choices='small finite', default='small')
      v(v_heights) = dataset(group='surface', name='heights', unit='m', &
         & meaning='heights of a profile (x) or a map (y, x), summits positive', largest_rank=2, least_count=1, &
         & attributes='dx dy', attribute_units='m m')
      v(v_spacing) = above_zero(group='surface', name='spacing', unit='m', &
         & meaning='distance of samples along x, instead of the attribute dx of the heights')
      v(v_strip_spacing) = above_zero(group='surface', name='strip_spacing', unit='m', &
         & meaning='distance of the rows of a map, instead of the attribute dy of the heights')
      v(v_amplitudes) = list_row(group='surface', name='amplitudes', unit='m', &
         & meaning='amplitudes of cosines with 1, 2, ... waves in a period', least_count=1, most_count=512)
      v(v_phases) = list_row(group='surface', name='phases', unit='rad', &
         & meaning='phases of the cosines at x = 0, a cos(2 pi n x/period + phase)', least_count=1, most_count=512)
      v(v_interpolation) = choice(group='surface', name='interpolation', &
         & meaning='between samples: periodic spline (cubic, if not given) or chords (linear)', choices='linear cubic')
      v(v_detrend) = choice(group='surface', name='detrend', &
         & meaning='what is subtracted from heights first; line, of a map a plane, if not given', choices='none mean line')
      v(v_periodise) = choice(group='surface', name='periodise', &
         & meaning='how the ends of heights meet: the last part goes over into the first (blend, if not given), the heights ' &
         & //'follow backwards (mirror), fall to the mean at both ends (taper), or stay (none)', choices='none blend mirror taper')
      v(v_blend_share) = any_number(group='surface', name='blend_share', unit='-', &
         & meaning='share of the length that a blend or a taper changes; 0.05 if not given', lower=0.0_dp, upper=0.5_dp)
      v(v_shortest_wavelength) = any_number(group='surface', name='shortest_wavelength', unit='m', &
         & meaning='shorter waves are taken out of the heights; 0 or not given: none', lower=0.0_dp)
      v(v_reverse) = switch(group='surface', name='reverse', meaning='the heights are crossed the other way')
      v(v_height_factor) = above_zero(group='surface', name='height_factor', unit='-', &
         & meaning='factor of all heights or amplitudes; 1 if not given')

      v(v_stiffness) = above_zero(group='foundation', name='stiffness', unit='Pa/m', meaning='long-time stiffness E/((1 - nu^2) H)')
      v(v_young_modulus) = above_zero(group='foundation', name='young_modulus', unit='Pa', &
         & meaning='long-time modulus, instead of the stiffness')
      v(v_poisson_ratio) = poisson_ratio(group='foundation', name='poisson_ratio', meaning='Poisson''s ratio')
      v(v_thickness) = above_zero(group='foundation', name='thickness', unit='m', meaning='thickness of the layer')
      v(v_relaxation_time) = above_zero(group='foundation', name='relaxation_time', unit='s', meaning='relaxation time Ts')
      v(v_retardation_ratio) = any_number(group='foundation', name='retardation_ratio', unit='-', &
         & meaning='Te/Ts, the instantaneous over the long-time stiffness', lower=1.0_dp)
      v(v_moduli) = list_row(group='foundation', name='moduli', unit='Pa/m', &
         & meaning='stiffnesses of arms beside the long-time stiffness, one for each of relaxation_times', lower=0.0_dp, &
         & least_count=1, most_count=most_arms)
      call set_arm_rows('foundation', v(v_young_moduli:v_time_factor))
      v(v_relaxation_times)%meaning = 'relaxation times of the arms, instead of relaxation_time and retardation_ratio'
      call set_shift_rows('foundation', v(v_shift:v_activation_energy))

      call set_stress_rows(v(v_stress:v_range))
      v(v_edge) = choice(group='adhesion', name='edge', &
         & meaning='the displacement where the stress starts or ends: as published (continuous), as the foundation asks '// &
         & '(instantaneous), or as in a thin layer (front)', choices='continuous instantaneous front')
      v(v_branch) = branch_row()

      v(v_velocity) = any_number(group='operating', name='velocity', unit='m/s', meaning='sliding velocity', lower=0.0_dp)
      v(v_temperature) = above_zero(group='operating', name='temperature', unit='K', &
         & meaning='temperature of the foundation; shift needs it')
      v(v_load) = any_number(group='operating', name='load', unit='N/m; N for wave_3d and map', meaning='load on one period')
      v(v_mean_pressure) = any_number(group='operating', name='mean_pressure', unit='Pa', &
         & meaning='load over the area of one period, instead of the load')
      v(v_penetration) = any_number(group='operating', name='penetration', unit='m', &
         & meaning='of the crests into the undisturbed surface, instead of the load')

      v(v_relative_tolerance) = any_number(group='numerics', name='relative_tolerance', unit='-', &
         & meaning='of load and friction of wave_3d', default=1.0e-8_dp, lower=1.0e-13_dp, upper=1.0e-2_dp)
      v(v_strips) = whole_number(group='numerics', name='strips', &
         & meaning='equal strips on half a period of wave_3d, as published; 0: as many as the tolerance needs', default=0, &
         & lower=0, upper=100000000)

      v(v_pull_off) = switch(group='output', name='pull_off', &
         & meaning='find the pull-off load, too; by default under a given load alone')
      v(v_profiles) = switch(group='output', name='profiles', &
         & meaning='write pressure, shear stress, displacement and gap of every point', default=.false.)
      v(v_n_x) = whole_number(group='output', name='n_x', meaning='samples of a profile along the sliding direction', default=401, &
         & lower=2, upper=10000000)
      v(v_n_y) = whole_number(group='output', name='n_y', meaning='samples of a profile across it (wave_3d)', default=101, &
         & lower=2, upper=10000000)
   end function get_wavy_variables

   !> The table of results.
   function get_wavy_results(is_3d) result(r)
      !> Waves in both directions, whose forces are not per width? Absent before it is known: then the units are those of either.
      logical, intent(in), optional :: is_3d
      type(result_t), allocatable :: r(:)
      character(:), allocatable :: force, area

      force = 'N/m; N for wave_3d and map'
      area = 'm; m^2 for wave_3d and map'
      if (present(is_3d)) then
         force = trim(merge('N  ', 'N/m', is_3d))
         area = trim(merge('m^2', 'm  ', is_3d))
      end if
      allocate (r(n_wavy_results))
      r(r_load) = result_row(name='load', unit=force, long_name='load on one period', is_main=.true.)
      r(r_penetration) = result_row(name='penetration', unit='m', long_name='penetration of the crests', is_main=.true.)
      r(r_friction_force) = result_row(name='friction_force', unit=force, long_name='friction force on one period', is_main=.true.)
      r(r_friction_coefficient) = result_row(name='friction_coefficient', unit='-', long_name='friction force over load', &
         & is_main=.true.)
      r(r_contact_area) = result_row(name='contact_area', unit=area, long_name='area in contact on one period', is_main=.true.)
      r(r_adhesion_area) = result_row(name='adhesion_area', unit=area, long_name='area in adhesion without contact on one period')
      r(r_contact_width) = result_row(name='contact_width', unit='m', &
         & long_name='width of the contact, of waves that of the central strip')
      r(r_contact_shift) = result_row(name='contact_shift', unit='m', &
         & long_name='shift of the contact from the highest place towards the leading side')
      r(r_regime) = result_row(name='regime', unit='-', long_name='regime, of waves that of the central strip', &
         & flag_meanings=regime_meanings)
      r(r_dissipation) = result_row(name='dissipation', unit=force, long_name='energy lost in the foundation per distance slid')
      r(r_edge_loss) = result_row(name='edge_loss', unit=force, &
         & long_name='energy lost where adhesion starts and ends per distance slid')
      r(r_energy_imbalance) = result_row(name='energy_imbalance', unit='-', &
         & long_name='friction less all losses, over the sum of their sizes')
      r(r_pull_off_load) = result_row(name='pull_off_load', unit=force, long_name='least load of the adhered branch')
      r(r_pull_off_penetration) = result_row(name='pull_off_penetration', unit='m', &
         & long_name='penetration of the least load of the adhered branch')
      r(r_contact_count) = result_row(name='contact_count', unit='-', long_name='contacts on one period, of all strips')
      r(r_adhesion_count) = result_row(name='adhesion_count', unit='-', long_name='zones of adhesion on one period, of all strips')
      r(r_snap_count) = result_row(name='snap_count', unit='-', &
         & long_name='edges where the displacement jumps and adhesion is lost on one period, of all strips')
      r(r_saturated_share) = result_row(name='saturated_share', unit='-', long_name='share of strips in contact everywhere')
      r(r_friction_sample_error) = result_row(name='friction_sample_error', unit=force, &
         & long_name='standard error of the friction force from the scatter of the strips')
   end function get_wavy_results

   !> The table of profiles.
   function get_wavy_profiles() result(p)
      type(profile_t), allocatable :: p(:)

      allocate (p(4))
      p(1) = profile_t(name='pressure', unit='Pa', long_name='pressure, compression positive')
      p(2) = profile_t(name='shear_stress', unit='Pa', long_name='shear stress against the motion')
      p(3) = profile_t(name='displacement', unit='m', long_name='displacement of the boundary, positive into the foundation')
      p(4) = profile_t(name='gap', unit='m', long_name='gap')
   end function get_wavy_profiles

end module adfric_foundation_variables
