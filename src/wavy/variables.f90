!> The namelist variables and results of the model `wavy_sliding`.
module adfric_wavy_variables
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: unset
   use adfric_model_table, only: variable_t, result_t, profile_t, kind_real, kind_integer, kind_logical, kind_choice, &
      & positive => positive_variable
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
      v(v_kind) = variable_t('surface', 'kind', kind_choice, '', &
         & 'one strip, forces per width (wave_2d), or waves in both directions (wave_3d)', 'wave_2d wave_3d')
      v(v_period) = positive('surface', 'period', 'm', 'period along and across the sliding direction')
      v(v_height) = positive('surface', 'height', 'm', 'peak-to-valley height')
      v(v_slope) = variable_t('surface', 'slope', kind_choice, '', &
         & 'shear stress p f'' (small) or p sin(arctan f'') (finite)', 'small finite', 1.0_dp)

      v(v_stiffness) = positive('foundation', 'stiffness', 'Pa/m', 'long-time stiffness E/((1 - nu^2) H)')
      v(v_young_modulus) = positive('foundation', 'young_modulus', 'Pa', 'long-time modulus, instead of the stiffness')
      v(v_poisson_ratio) = variable_t('foundation', 'poisson_ratio', kind_real, '-', 'Poisson''s ratio', '', &
         & unset, -1.0_dp, 0.5_dp, .true.)
      v(v_thickness) = positive('foundation', 'thickness', 'm', 'thickness of the layer')
      v(v_relaxation_time) = positive('foundation', 'relaxation_time', 's', 'relaxation time Ts')
      v(v_retardation_ratio) = variable_t('foundation', 'retardation_ratio', kind_real, '-', &
         & 'Te/Ts, the instantaneous over the long-time stiffness', '', unset, 1.0_dp)

      v(v_stress) = variable_t('adhesion', 'stress', kind_real, 'Pa', 'adhesion stress p0; 0: no adhesion', '', &
         & unset, 0.0_dp)
      v(v_surface_energy) = positive('adhesion', 'surface_energy', 'J/m^2', 'stress times range')
      v(v_range) = positive('adhesion', 'range', 'm', 'largest gap with adhesion, instead of the surface energy')
      v(v_edge) = variable_t('adhesion', 'edge', kind_choice, '', &
         & 'the displacement where the stress starts or ends: as published (continuous) or as the foundation asks', &
         & 'continuous instantaneous', 1.0_dp)
      v(v_branch) = variable_t('adhesion', 'branch', kind_choice, '', &
         & 'where states coexist: the one that unloading keeps (adhered) or that loading meets (approach)', &
         & 'adhered approach', 1.0_dp)

      v(v_velocity) = variable_t('operating', 'velocity', kind_real, 'm/s', 'sliding velocity', '', unset, 0.0_dp)
      v(v_load) = variable_t('operating', 'load', kind_real, 'N; N/m for wave_2d', 'load on one period', '')
      v(v_penetration) = variable_t('operating', 'penetration', kind_real, 'm', &
         & 'of the crests into the undisturbed surface, instead of the load', '')

      v(v_relative_tolerance) = variable_t('numerics', 'relative_tolerance', kind_real, '-', &
         & 'of load and friction of wave_3d', '', 1.0e-8_dp, 1.0e-13_dp, 1.0e-2_dp)
      v(v_strips) = variable_t('numerics', 'strips', kind_integer, '-', &
         & 'equal strips on half a period of wave_3d, as published; 0: as many as the tolerance needs', '', &
         & 0.0_dp, 0.0_dp, 1.0e8_dp)

      v(v_pull_off) = variable_t('output', 'pull_off', kind_logical, '', &
         & 'find the pull-off load, too; by default under a given load alone', '')
      v(v_profiles) = variable_t('output', 'profiles', kind_logical, '', &
         & 'write pressure, shear stress, displacement and gap of every point', '', 0.0_dp)
      v(v_n_x) = variable_t('output', 'n_x', kind_integer, '-', 'samples of a profile along the sliding direction', '', &
         & 401.0_dp, 2.0_dp, 1.0e7_dp)
      v(v_n_y) = variable_t('output', 'n_y', kind_integer, '-', 'samples of a profile across it (wave_3d)', '', &
         & 101.0_dp, 2.0_dp, 1.0e7_dp)
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
      r(r_load) = result_t('load', force, 'load on one period', '', .true.)
      r(r_penetration) = result_t('penetration', 'm', 'penetration of the crests', '', .true.)
      r(r_friction_force) = result_t('friction_force', force, 'friction force on one period', '', .true.)
      r(r_friction_coefficient) = result_t('friction_coefficient', '-', 'friction force over load', '', .true.)
      r(r_contact_area) = result_t('contact_area', area, 'area in contact on one period', '', .true.)
      r(r_adhesion_area) = result_t('adhesion_area', area, 'area in adhesion without contact on one period', '')
      r(r_contact_width) = result_t('contact_width', 'm', 'width of contact of the central strip', '')
      r(r_contact_shift) = result_t('contact_shift', 'm', &
         & 'shift of the contact of the central strip towards the leading side', '')
      r(r_regime) = result_t('regime', '-', 'regime of the central strip', regime_meanings)
      r(r_dissipation) = result_t('dissipation', force, 'energy lost in the foundation per distance slid', '')
      r(r_edge_loss) = result_t('edge_loss', force, &
         & 'energy lost where adhesion starts and ends per distance slid', '')
      r(r_energy_imbalance) = result_t('energy_imbalance', '-', &
         & 'friction less all losses, over the sum of their sizes', '')
      r(r_pull_off_load) = result_t('pull_off_load', force, 'least load of the adhered branch', '')
      r(r_pull_off_penetration) = result_t('pull_off_penetration', 'm', 'penetration of the least load of the adhered branch', '')
   end function get_wavy_results

   !> The table of profiles.
   function get_wavy_profiles() result(p)
      type(profile_t), allocatable :: p(:)

      allocate (p(4))
      p(1) = profile_t('pressure', 'Pa', 'pressure, compression positive')
      p(2) = profile_t('shear_stress', 'Pa', 'shear stress against the motion')
      p(3) = profile_t('displacement', 'm', 'displacement of the boundary, positive into the foundation')
      p(4) = profile_t('gap', 'm', 'gap')
   end function get_wavy_profiles

end module adfric_wavy_variables
