!> The namelist variables and results of the model `sphere`.
module adfric_sphere_variables
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: unset
   use adfric_material_contact_modulus, only: set_modulus_rows
   use adfric_model_table, only: variable_t, result_t, profile_t, kind_real, kind_integer, kind_logical, kind_choice, &
      & positive => positive_variable
   implicit none (type, external)
   private
   public :: get_sphere_variables, get_sphere_results, get_sphere_profiles

   !> Places of the variables.
   integer, parameter, public :: v_units = 1, v_radius = 2, v_contact_modulus = 3, v_young_modulus = 4, &
      & v_body_poisson_ratio = 5, v_second_young_modulus = 6, v_second_poisson_ratio = 7, v_work_of_adhesion = 8, &
      & v_adhesion_stress = 9, v_adhesion_range = 10, &
      & v_lambda = 11, v_shear_strength = 12, v_poisson_ratio = 13, v_edge_fraction = 14, &
      & v_interaction = 15, v_critical_slip = 16, v_slip_energy_ratio = 17, v_load = 18, v_approach = 19, &
      & v_contact_radius = 20, v_branch = 21, v_state = 22, v_tangential_force = 23, v_tangential_displacement = 24, &
      & v_theory = 25, v_relative_tolerance = 26, v_events = 27, v_profiles = 28, v_n_r = 29, v_r_max = 30
   integer, parameter, public :: n_sphere_variables = 30

   !> Places of the words in the choices.
   integer, parameter, public :: units_si = 1, units_reduced = 2, state_static = 1, state_sliding = 2
   integer, parameter, public :: choose_auto = 1

   !> Places of the results.
   integer, parameter, public :: r_load = 1, r_approach = 2, r_contact_radius = 3, r_adhesion_radius = 4, &
      & r_friction_radius = 5, r_contact_area = 6, r_friction_area = 7, r_friction_force = 8, r_adhesion_ratio = 9, &
      & r_stick_radius = 10, r_slip = 11, r_largest_slip = 12, r_tangential_displacement = 13, r_pull_off_load = 14, &
      & r_stable = 15, r_theory_used = 16, r_theory_error = 17, r_peak_force = 18, r_peak_displacement = 19, &
      & r_sliding_force = 20, r_force_drop = 21, r_snap_off_force = 22, r_snap_off_displacement = 23
   integer, parameter, public :: n_sphere_results = 23

contains

   !> The table of variables.
   function get_sphere_variables() result(v)
      type(variable_t), allocatable :: v(:)

      allocate (v(n_sphere_variables))
      v(v_units) = variable_t('sphere', 'units', kind_choice, '', &
         & 'SI, or the reduced units of Johnson (2.11) for everything', 'si reduced', 1.0_dp)
      v(v_radius) = positive('sphere', 'radius', 'm', 'radius R of the sphere')
      call set_modulus_rows(positive('sphere', 'contact_modulus', 'Pa', ''), v(v_contact_modulus:v_second_poisson_ratio))
      ! without its group a sweep means that of friction, which was there before
      v(v_contact_modulus:v_second_poisson_ratio)%has_bare_name = .false.
      v(v_work_of_adhesion) = variable_t('sphere', 'work_of_adhesion', kind_real, 'J/m^2', 'w; 0: no adhesion', '', &
         & unset, 0.0_dp)
      v(v_adhesion_stress) = positive('sphere', 'adhesion_stress', 'Pa', 'sigma0, the stress of Dugdale''s law')
      v(v_adhesion_range) = positive('sphere', 'adhesion_range', 'm', 'h0 = w/sigma0, instead of the stress')
      v(v_lambda) = positive('sphere', 'lambda', '-', 'Maugis''s parameter, instead of stress or range')

      v(v_shear_strength) = positive('friction', 'shear_strength', 'Pa', &
         & 'tau0, the shear stress of sliding; reduced: in the scale of lambda')
      v(v_poisson_ratio) = variable_t('friction', 'poisson_ratio', kind_real, '-', 'Poisson''s ratio', '', &
         & unset, -1.0_dp, 0.5_dp, .true.)
      v(v_edge_fraction) = variable_t('friction', 'edge_fraction', kind_real, '-', &
         & 'x: friction acts up to the radius b = a + x (c - a)', '', 0.4_dp, 0.0_dp, 1.0_dp)
      v(v_interaction) = variable_t('friction', 'interaction', kind_real, '-', &
         & 'alpha, the share of the work of slip that adhesion loses; 0: friction leaves adhesion alone', '', 0.0_dp, 0.0_dp)
      v(v_critical_slip) = positive('friction', 'critical_slip', 'm', 's0, after which slip takes no more from adhesion')
      v(v_slip_energy_ratio) = positive('friction', 'slip_energy_ratio', '-', 'g0 = tau0 s0/w, instead of the critical slip')

      v(v_load) = variable_t('operating', 'load', kind_real, 'N', 'load, pressing positive', '')
      v(v_approach) = variable_t('operating', 'approach', kind_real, 'm', 'approach, instead of the load', '')
      v(v_contact_radius) = positive('operating', 'contact_radius', 'm', 'radius a of contact, instead of the load')
      v(v_branch) = variable_t('operating', 'branch', kind_choice, '', &
         & 'where two states carry a load or have an approach: the stable one or the other', 'stable unstable', 1.0_dp)
      v(v_state) = variable_t('operating', 'state', kind_choice, '', 'before sliding, or during it', 'static sliding', 1.0_dp)
      v(v_tangential_force) = variable_t('operating', 'tangential_force', kind_real, 'N', 'T of the static state', '', &
         & unset, 0.0_dp)
      v(v_tangential_displacement) = variable_t('operating', 'tangential_displacement', kind_real, 'm', &
         & 'of the static state, instead of the force', '', unset, 0.0_dp)

      v(v_theory) = variable_t('model', 'theory', kind_choice, '', &
         & 'auto: the simplest one that is proved to be within relative_tolerance of maugis_dugdale', &
         & 'auto hertz jkr dmt maugis_dugdale', 1.0_dp)

      v(v_relative_tolerance) = variable_t('numerics', 'relative_tolerance', kind_real, '-', &
         & 'of the theory that auto may choose', '', 1.0e-8_dp, 1.0e-15_dp, 0.5_dp)

      v(v_events) = variable_t('output', 'events', kind_logical, '', &
         & 'find the largest tangential force, the drop at the onset of sliding, and where the contact snaps off', '', 0.0_dp)
      v(v_profiles) = variable_t('output', 'profiles', kind_logical, '', 'write pressure, gap and shear stress of every point', &
         & '', 0.0_dp)
      v(v_n_r) = variable_t('output', 'n_r', kind_integer, '-', 'samples of a profile', '', 201.0_dp, 2.0_dp, 1.0e7_dp)
      v(v_r_max) = positive('output', 'r_max', 'm', 'radius up to which profiles are written')
   end function get_sphere_variables

   !> The table of results.
   function get_sphere_results(is_reduced) result(r)
      !> Are all quantities reduced? Then their unit is `-`.
      logical, intent(in) :: is_reduced
      type(result_t), allocatable :: r(:)
      character(:), allocatable :: force, length, area

      force = 'N'
      length = 'm'
      area = 'm^2'
      if (is_reduced) force = '-'
      if (is_reduced) length = '-'
      if (is_reduced) area = '-'
      allocate (r(n_sphere_results))
      r(r_load) = result_t('load', force, 'load', '', .true.)
      r(r_approach) = result_t('approach', length, 'approach of distant points', '', .true.)
      r(r_contact_radius) = result_t('contact_radius', length, 'radius a of intimate contact', '', .true.)
      r(r_adhesion_radius) = result_t('adhesion_radius', length, 'radius c up to which adhesion acts; none in DMT', '')
      r(r_friction_radius) = result_t('friction_radius', length, 'radius b up to which friction acts', '')
      r(r_contact_area) = result_t('contact_area', area, 'area pi a^2 of intimate contact', '')
      r(r_friction_area) = result_t('friction_area', area, 'area pi b^2 on which friction acts; none without friction', '')
      r(r_friction_force) = result_t('friction_force', force, 'tangential force', '', .true.)
      r(r_adhesion_ratio) = result_t('adhesion_ratio', '-', 'X, what friction leaves of the work of adhesion', '')
      r(r_stick_radius) = result_t('stick_radius', length, 'radius e of the part that sticks', '')
      r(r_slip) = result_t('slip', length, 'slip at the edge, mean around it; none once sliding', '')
      r(r_largest_slip) = result_t('largest_slip', length, 'slip at the edge where it is largest; none once sliding', '')
      r(r_tangential_displacement) = result_t('tangential_displacement', length, &
         & 'tangential displacement of distant points; none once sliding', '')
      r(r_pull_off_load) = result_t('pull_off_load', force, 'load at which the contact separates in this control', '', .true.)
      r(r_stable) = result_t('stable', '-', 'is the state stable under the control that is given?', 'unstable stable')
      r(r_theory_used) = result_t('theory_used', '-', 'theory that was used', 'hertz jkr dmt maugis_dugdale')
      r(r_theory_error) = result_t('theory_error', '-', &
         & 'proved bound of the relative error of radii, load and approach by that theory', '')
      r(r_peak_force) = result_t('peak_force', force, 'largest tangential force before sliding', '')
      r(r_peak_displacement) = result_t('peak_displacement', length, 'tangential displacement at the largest force', '')
      r(r_sliding_force) = result_t('sliding_force', force, 'tangential force of sliding at this load', '')
      r(r_force_drop) = result_t('force_drop', force, 'force that is lost at the onset of sliding', '')
      r(r_snap_off_force) = result_t('snap_off_force', force, 'tangential force at which the contact snaps off', '')
      r(r_snap_off_displacement) = result_t('snap_off_displacement', length, 'tangential displacement at that place', '')
   end function get_sphere_results

   !> The table of profiles.
   function get_sphere_profiles(is_reduced) result(p)
      !> Are all quantities reduced? Then their unit is `-`.
      logical, intent(in) :: is_reduced
      type(profile_t), allocatable :: p(:)
      character(:), allocatable :: stress, length

      stress = 'Pa'
      length = 'm'
      if (is_reduced) stress = '-'
      if (is_reduced) length = '-'
      allocate (p(3))
      p(1) = profile_t('pressure', stress, 'pressure, compression positive')
      p(2) = profile_t('shear_stress', stress, 'shear stress')
      p(3) = profile_t('gap', length, 'gap')
   end function get_sphere_profiles

end module adfric_sphere_variables
