!> The namelist variables and results of the model `wavy_sliding`.
module adfric_wavy_variables
   use adfric_base_kinds, only: dp
   use adfric_model_rows, only: above_zero, choice, poisson_ratio, switch, whole_number, result_row, any_number
   use adfric_model_table, only: variable_t, result_t, profile_t
   use adfric_wavy_strip, only: regime_meanings
   implicit none (type, external)
   private
   public :: get_wavy_variables, get_wavy_results, get_wavy_profiles

   !> Places of the variables.
   integer, parameter, public :: v_kind = 1, v_period = 2, v_height = 3, v_slope = 4, v_stiffness = 5, &
      & v_young_modulus = 6, v_poisson_ratio = 7, v_thickness = 8, v_relaxation_time = 9, v_retardation_ratio = 10, &
      & v_stress = 11, v_surface_energy = 12, v_range = 13, v_edge = 14, v_branch = 15, v_velocity = 16, v_load = 17, &
      & v_penetration = 18, v_relative_tolerance = 19, v_strips = 20, v_pull_off = 21, v_profiles = 22, &
      & v_n_x = 23, v_n_y = 24
   integer, parameter :: n_variables = 24

   !> Places of the results.
   integer, parameter, public :: r_load = 1, r_penetration = 2, r_friction_force = 3, r_friction_coefficient = 4, &
      & r_contact_area = 5, r_adhesion_area = 6, r_contact_width = 7, r_contact_shift = 8, r_regime = 9, &
      & r_dissipation = 10, r_edge_loss = 11, r_energy_imbalance = 12, r_pull_off_load = 13, &
      & r_pull_off_penetration = 14
   integer, parameter, public :: n_wavy_results = 14

contains

   !> The table of variables.
   function get_wavy_variables() result(v)
      type(variable_t), allocatable :: v(:)

      allocate (v(n_variables))
      v(v_kind) = choice(group='surface', name='kind', &
         & meaning='one strip, forces per width (wave_2d), or waves in both directions (wave_3d)', choices='wave_2d wave_3d')
      v(v_period) = above_zero(group='surface', name='period', unit='m', meaning='period along and across the sliding direction')
      v(v_height) = above_zero(group='surface', name='height', unit='m', meaning='peak-to-valley height')
      v(v_slope) = choice(group='surface', name='slope', meaning='shear stress p f'' (small) or p sin(arctan f'') (finite)', &
         & choices='small finite', default='small')

      v(v_stiffness) = above_zero(group='foundation', name='stiffness', unit='Pa/m', meaning='long-time stiffness E/((1 - nu^2) H)')
      v(v_young_modulus) = above_zero(group='foundation', name='young_modulus', unit='Pa', &
         & meaning='long-time modulus, instead of the stiffness')
      v(v_poisson_ratio) = poisson_ratio(group='foundation', name='poisson_ratio', meaning='Poisson''s ratio')
      v(v_thickness) = above_zero(group='foundation', name='thickness', unit='m', meaning='thickness of the layer')
      v(v_relaxation_time) = above_zero(group='foundation', name='relaxation_time', unit='s', meaning='relaxation time Ts')
      v(v_retardation_ratio) = any_number(group='foundation', name='retardation_ratio', unit='-', &
         & meaning='Te/Ts, the instantaneous over the long-time stiffness', lower=1.0_dp)

      v(v_stress) = any_number(group='adhesion', name='stress', unit='Pa', meaning='adhesion stress p0; 0: no adhesion', &
         & lower=0.0_dp)
      v(v_surface_energy) = above_zero(group='adhesion', name='surface_energy', unit='J/m^2', meaning='stress times range')
      v(v_range) = above_zero(group='adhesion', name='range', unit='m', &
         & meaning='largest gap with adhesion, instead of the surface energy')
      v(v_edge) = choice(group='adhesion', name='edge', &
         & meaning='the displacement where the stress starts or ends: as published (continuous), as the foundation asks '// &
         & '(instantaneous), or as in a thin layer (front)', choices='continuous instantaneous front', default='continuous')
      v(v_branch) = choice(group='adhesion', name='branch', &
         & meaning='where states coexist: the one that unloading keeps (adhered) or that loading meets (approach)', &
         & choices='adhered approach', default='adhered')

      v(v_velocity) = any_number(group='operating', name='velocity', unit='m/s', meaning='sliding velocity', lower=0.0_dp)
      v(v_load) = any_number(group='operating', name='load', unit='N; N/m for wave_2d', meaning='load on one period')
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

      force = 'N; N/m for wave_2d'
      area = 'm^2; m for wave_2d'
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
      r(r_contact_width) = result_row(name='contact_width', unit='m', long_name='width of contact of the central strip')
      r(r_contact_shift) = result_row(name='contact_shift', unit='m', &
         & long_name='shift of the contact of the central strip towards the leading side')
      r(r_regime) = result_row(name='regime', unit='-', long_name='regime of the central strip', flag_meanings=regime_meanings)
      r(r_dissipation) = result_row(name='dissipation', unit=force, long_name='energy lost in the foundation per distance slid')
      r(r_edge_loss) = result_row(name='edge_loss', unit=force, &
         & long_name='energy lost where adhesion starts and ends per distance slid')
      r(r_energy_imbalance) = result_row(name='energy_imbalance', unit='-', &
         & long_name='friction less all losses, over the sum of their sizes')
      r(r_pull_off_load) = result_row(name='pull_off_load', unit=force, long_name='least load of the adhered branch')
      r(r_pull_off_penetration) = result_row(name='pull_off_penetration', unit='m', &
         & long_name='penetration of the least load of the adhered branch')
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

end module adfric_wavy_variables
