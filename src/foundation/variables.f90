! SPDX-License-Identifier: GPL-3.0-or-later
!> The namelist variables and results of the model `wavy_sliding`.
module adfric_foundation_variables
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_interface_adhesion_rows, only: set_stress_rows, branch_row
   use adfric_interface_attraction, only: law_words
   use adfric_interface_attraction_rows, only: law_row, table_row
   use adfric_interface_friction_law_rows, only: n_interface_rows, set_law_rows
   use adfric_interface_shear_strength_rows, only: n_shear_rows, set_shear_rows
   use adfric_interface_total_friction, only: total_friction_results
   use adfric_solid_given_spectrum, only: set_arm_rows
   use adfric_solid_prony, only: most_arms
   use adfric_solid_shift_rows, only: set_shift_rows
   use adfric_describe_rows, only: above_zero, any_number, choice, dataset, list_row, poisson_ratio, switch, whole_number, &
      & result_row
   use adfric_describe_table, only: variable_t, result_t, profile_t
   use adfric_foundation_strip, only: regime_meanings
   implicit none (type, external)
   private
   public :: get_wavy_variables, get_wavy_results, get_wavy_profiles

   !> Variables in the order of their rows; a component is the index of its row.
   type :: foundation_input_t
      !> Indices of the rows.
      integer :: kind = 0, period = 0, height = 0, slope = 0, heights = 0, spacing = 0, strip_spacing = 0, amplitudes = 0, &
         & phases = 0, interpolation = 0, detrend = 0, periodise = 0, blend_share = 0, shortest_wavelength = 0, reverse = 0, &
         & height_factor = 0, stiffness = 0, young_modulus = 0, poisson_ratio = 0, thickness = 0, relaxation_time = 0, &
         & retardation_ratio = 0, moduli = 0, young_moduli = 0, relaxation_times = 0, master_curve = 0, relaxed_modulus = 0, &
         & terms_per_decade = 0, time_factor = 0, shift = 0, reference_temperature = 0, wlf_c1 = 0, wlf_c2 = 0, &
         & activation_energy = 0, stress = 0, surface_energy = 0, range = 0, edge = 0, branch = 0, velocity = 0, &
         & temperature = 0, load = 0, mean_pressure = 0, penetration = 0, relative_tolerance = 0, strips = 0, pull_off = 0, &
         & profiles = 0, n_x = 0, n_y = 0, friction(n_interface_rows) = 0, law = 0, tension_table = 0
   end type foundation_input_t
   type(foundation_input_t), parameter, public :: foundation_input = transfer(counting, foundation_input_t())
   integer, parameter :: n_variables = storage_size(foundation_input)/storage_size(1)

   !> Results in the order of their rows; a component is the index of its row.
   type :: foundation_output_t
      !> Indices of the rows.
      integer :: load = 0, penetration = 0, friction_force = 0, friction_coefficient = 0, contact_area = 0, &
         & adhesion_area = 0, contact_width = 0, contact_shift = 0, regime = 0, dissipation = 0, edge_loss = 0, &
         & energy_imbalance = 0, pull_off_load = 0, pull_off_penetration = 0, contact_count = 0, adhesion_count = 0, &
         & snap_count = 0, saturated_share = 0, friction_sample_error = 0, hysteretic_friction_force = 0, &
         & interfacial_friction_force = 0, interfacial_share = 0, velocity_slope = 0
   end type foundation_output_t
   type(foundation_output_t), parameter, public :: foundation_output = transfer(counting, foundation_output_t())
   integer, parameter, public :: n_wavy_results = storage_size(foundation_output)/storage_size(1)

contains

   !> The table of variables.
   function get_wavy_variables() result(v)
      type(variable_t), allocatable :: v(:)

      allocate (v(n_variables))
      call set_surface_rows(v)
      v(foundation_input%stiffness) = above_zero(group='foundation', name='stiffness', unit='Pa/m', &
         & meaning='long-time stiffness E/((1 - nu^2) H)')
      v(foundation_input%young_modulus) = above_zero(group='foundation', name='young_modulus', unit='Pa', &
         & meaning='long-time modulus, instead of the stiffness')
      v(foundation_input%poisson_ratio) = poisson_ratio(group='foundation', name='poisson_ratio', meaning='Poisson''s ratio')
      v(foundation_input%thickness) = above_zero(group='foundation', name='thickness', unit='m', meaning='thickness of the layer')
      v(foundation_input%relaxation_time) = above_zero(group='foundation', name='relaxation_time', unit='s', &
         & meaning='relaxation time Ts')
      v(foundation_input%retardation_ratio) = any_number(group='foundation', name='retardation_ratio', unit='-', &
         & meaning='Te/Ts, the instantaneous over the long-time stiffness', lower=1.0_dp)
      v(foundation_input%moduli) = list_row(group='foundation', name='moduli', unit='Pa/m', &
         & meaning='stiffnesses of arms beside the long-time stiffness, one for each of relaxation_times', lower=0.0_dp, &
         & least_count=1, most_count=most_arms)
      call set_arm_rows('foundation', v(foundation_input%young_moduli:foundation_input%time_factor))
      v(foundation_input%relaxation_times)%meaning = &
         & 'relaxation times of the arms, instead of relaxation_time and retardation_ratio'
      call set_shift_rows('foundation', v(foundation_input%shift:foundation_input%activation_energy))

      call set_stress_rows(v(foundation_input%stress:foundation_input%range))
      v(foundation_input%edge) = choice(group='adhesion', name='edge', &
         & meaning='the displacement where the stress starts or ends: it stays (continuous, as published), jumps '// &
         & '(instantaneous, as of columns alone), or jumps with the range half way (front, as of a thin layer)', &
         & choices='continuous instantaneous front')
      v(foundation_input%branch) = branch_row()

      v(foundation_input%velocity) = any_number(group='operating', name='velocity', unit='m/s', meaning='sliding velocity', &
         & lower=0.0_dp)
      v(foundation_input%temperature) = above_zero(group='operating', name='temperature', unit='K', &
         & meaning='temperature of the solid; shift needs it')
      v(foundation_input%load) = any_number(group='operating', name='load', unit='N/m; N for wave_3d and map', &
         & meaning='load on one period')
      v(foundation_input%mean_pressure) = any_number(group='operating', name='mean_pressure', unit='Pa', &
         & meaning='load over the area of one period, instead of the load')
      v(foundation_input%penetration) = any_number(group='operating', name='penetration', unit='m', &
         & meaning='of the crests into the undisturbed surface, instead of the load')

      v(foundation_input%relative_tolerance) = any_number(group='numerics', name='relative_tolerance', unit='-', &
         & meaning='of load and friction of wave_3d', default=1.0e-8_dp, lower=1.0e-13_dp, upper=1.0e-2_dp)
      v(foundation_input%strips) = whole_number(group='numerics', name='strips', &
         & meaning='equal strips on half a period of wave_3d, as published; 0: as many as the tolerance needs', default=0, &
         & lower=0, upper=100000000)

      v(foundation_input%pull_off) = switch(group='output', name='pull_off', &
         & meaning='find the pull-off load, too; by default under a given load alone')
      v(foundation_input%profiles) = switch(group='output', name='profiles', &
         & meaning='write pressure, shear stress, displacement and gap of every point', default=.false.)
      v(foundation_input%n_x) = whole_number(group='output', name='n_x', &
         & meaning='samples of a profile along the sliding direction', default=401, &
         & lower=2, upper=10000000)
      v(foundation_input%n_y) = whole_number(group='output', name='n_y', meaning='samples of a profile across it (wave_3d)', &
         & default=101, &
         & lower=2, upper=10000000)

      call set_shear_rows(v(foundation_input%friction(1):foundation_input%friction(n_shear_rows)))
      call set_law_rows(v(foundation_input%friction(n_shear_rows + 1):foundation_input%friction(n_interface_rows)))
      v(foundation_input%law) = law_row(law_words)
      v(foundation_input%tension_table) = table_row()
   end function get_wavy_variables

   !> The rows of the surface.
   subroutine set_surface_rows(v)
      !> Table of the variables; receives these rows.
      type(variable_t), intent(inout) :: v(:)

      v(foundation_input%kind) = choice(group='surface', name='kind', &
         & meaning='one wave (wave_2d), waves in both directions (wave_3d), a line of heights (profile), a sum of waves ' &
         & //'(cosines), or heights over x and y, whose rows are strips (map); forces are per width but for wave_3d and map', &
         & choices='wave_2d wave_3d profile cosines map')
      v(foundation_input%period) = above_zero(group='surface', name='period', unit='m', meaning='period of waves and cosines')
      v(foundation_input%height) = above_zero(group='surface', name='height', unit='m', meaning='peak-to-valley height of a wave')
      v(foundation_input%slope) = choice(group='surface', name='slope', &
         & meaning='shear stress p f'' (small) or p sin(arctan f'') (finite)', &
         & choices='small finite', default='small')
      v(foundation_input%heights) = dataset(group='surface', name='heights', unit='m', &
         & meaning='heights of a profile (x) or a map (y, x), summits positive', largest_rank=2, least_count=1, &
         & attributes='dx dy', attribute_units='m m')
      v(foundation_input%spacing) = above_zero(group='surface', name='spacing', unit='m', &
         & meaning='distance of samples along x, instead of the attribute dx of the heights')
      v(foundation_input%strip_spacing) = above_zero(group='surface', name='strip_spacing', unit='m', &
         & meaning='distance of the rows of a map, instead of the attribute dy of the heights')
      v(foundation_input%amplitudes) = list_row(group='surface', name='amplitudes', unit='m', &
         & meaning='amplitudes of cosines with 1, 2, ... waves in a period', least_count=1, most_count=512)
      v(foundation_input%phases) = list_row(group='surface', name='phases', unit='rad', &
         & meaning='phases of the cosines at x = 0, a cos(2 pi n x/period + phase)', least_count=1, most_count=512)
      v(foundation_input%interpolation) = choice(group='surface', name='interpolation', &
         & meaning='between samples: periodic spline (cubic, if not given) or chords (linear)', choices='linear cubic')
      v(foundation_input%detrend) = choice(group='surface', name='detrend', &
         & meaning='what is subtracted from heights first; line, of a map a plane, if not given', choices='none mean line')
      v(foundation_input%periodise) = choice(group='surface', name='periodise', &
         & meaning='how the ends of heights meet: the last part goes over into the first (blend, if not given), the heights ' &
         & //'follow backwards (mirror), fall to the mean at both ends (taper), or stay (none)', choices='none blend mirror taper')
      v(foundation_input%blend_share) = any_number(group='surface', name='blend_share', unit='-', &
         & meaning='share of the length that a blend or a taper changes; 0.05 if not given', lower=0.0_dp, upper=0.5_dp)
      v(foundation_input%shortest_wavelength) = any_number(group='surface', name='shortest_wavelength', unit='m', &
         & meaning='shorter waves are taken out of the heights; 0 or not given: none', lower=0.0_dp)
      v(foundation_input%reverse) = switch(group='surface', name='reverse', &
         & meaning='the heights are crossed from the last to the first: x becomes -x')
      v(foundation_input%height_factor) = above_zero(group='surface', name='height_factor', unit='-', &
         & meaning='factor of all heights or amplitudes; 1 if not given')
   end subroutine set_surface_rows

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
      r(foundation_output%load) = result_row(name='load', unit=force, long_name='load on one period', is_main=.true.)
      r(foundation_output%penetration) = result_row(name='penetration', unit='m', long_name='penetration of the crests', &
         & is_main=.true.)
      r(foundation_output%friction_force) = result_row(name='friction_force', unit=force, &
         & long_name='friction force on one period', is_main=.true.)
      r(foundation_output%friction_coefficient) = result_row(name='friction_coefficient', unit='-', &
         & long_name='friction force over load', &
         & is_main=.true.)
      r(foundation_output%contact_area) = result_row(name='contact_area', unit=area, long_name='area in contact on one period', &
         & is_main=.true.)
      r(foundation_output%adhesion_area) = result_row(name='adhesion_area', unit=area, &
         & long_name='area in adhesion without contact on one period')
      r(foundation_output%contact_width) = result_row(name='contact_width', unit='m', &
         & long_name='width of the contact, of waves that of the central strip')
      r(foundation_output%contact_shift) = result_row(name='contact_shift', unit='m', &
         & long_name='shift of the contact from the highest place towards the leading side')
      r(foundation_output%regime) = result_row(name='regime', unit='-', long_name='regime, of waves that of the central strip', &
         & flag_meanings=regime_meanings)
      r(foundation_output%dissipation) = result_row(name='dissipation', unit=force, &
         & long_name='energy lost in the foundation per distance slid')
      r(foundation_output%edge_loss) = result_row(name='edge_loss', unit=force, &
         & long_name='energy lost where adhesion starts and ends per distance slid')
      r(foundation_output%energy_imbalance) = result_row(name='energy_imbalance', unit='-', &
         & long_name='friction less all losses, over the sum of their sizes')
      r(foundation_output%pull_off_load) = result_row(name='pull_off_load', unit=force, &
         & long_name='least load of the adhered branch')
      r(foundation_output%pull_off_penetration) = result_row(name='pull_off_penetration', unit='m', &
         & long_name='penetration of the least load of the adhered branch')
      r(foundation_output%contact_count) = result_row(name='contact_count', unit='-', &
         & long_name='contacts on one period, of all strips')
      r(foundation_output%adhesion_count) = result_row(name='adhesion_count', unit='-', &
         & long_name='zones of adhesion on one period, of all strips')
      r(foundation_output%snap_count) = result_row(name='snap_count', unit='-', &
         & long_name='edges where the displacement jumps and adhesion is lost on one period, of all strips')
      r(foundation_output%saturated_share) = result_row(name='saturated_share', unit='-', &
         & long_name='share of strips in contact everywhere')
      r(foundation_output%friction_sample_error) = result_row(name='friction_sample_error', unit=force, &
         & long_name='standard error of the friction force from the scatter of the strips')
      r(foundation_output%hysteretic_friction_force:foundation_output%velocity_slope) = total_friction_results('force', force)
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
