! SPDX-License-Identifier: GPL-3.0-or-later
!> The namelist variables and results of the model `sphere`.
module adfric_round_sphere_variables
   use adfric_base_kinds, only: dp
   use adfric_solid_contact_modulus, only: set_modulus_rows
   use adfric_interface_interaction_rows, only: set_interaction_rows
   use adfric_describe_rows, only: above_zero, choice, poisson_ratio, switch, whole_number, result_row, any_number
   use adfric_describe_table, only: variable_t, result_t, profile_t
   implicit none (type, external)
   private
   public :: get_sphere_variables, get_sphere_results, get_sphere_profiles

   !> Places of the variables.
   integer, parameter, public :: v_units = 1, v_radius = 2, v_contact_modulus = 3, v_young_modulus = 4, &
      & v_body_poisson_ratio = 5, v_second_young_modulus = 6, v_second_poisson_ratio = 7, &
      & v_work_of_adhesion = 8, v_adhesion_stress = 9, v_adhesion_range = 10, v_lambda = 11, &
      & v_shear_strength = 12, v_pressure_factor = 13, v_poisson_ratio = 14, v_edge_fraction = 15, &
      & v_interaction = 16, v_critical_slip = 17, v_slip_energy_ratio = 18, v_load = 19, v_approach = 20, &
      & v_contact_radius = 21, v_branch = 22, v_state = 23, v_tangential_force = 24, &
      & v_tangential_displacement = 25, v_base_displacement = 26, v_lateral_stiffness = 27, v_theory = 28, &
      & v_relative_tolerance = 29, v_events = 30, v_profiles = 31, v_n_r = 32, v_r_max = 33
   integer, parameter, public :: n_sphere_variables = 33

   !> Places of the words in the choices.
   integer, parameter, public :: units_si = 1, units_reduced = 2, state_static = 1, state_sliding = 2
   integer, parameter, public :: choose_auto = 1

   !> Places of the results.
   integer, parameter, public :: r_load = 1, r_approach = 2, r_contact_radius = 3, r_adhesion_radius = 4, &
      & r_friction_radius = 5, r_contact_area = 6, r_friction_area = 7, r_friction_force = 8, r_adhesion_ratio = 9, &
      & r_stick_radius = 10, r_slip = 11, r_largest_slip = 12, r_tangential_displacement = 13, r_pull_off_load = 14, &
      & r_stable = 15, r_theory_used = 16, r_theory_error = 17, r_peak_force = 18, r_peak_displacement = 19, &
      & r_sliding_force = 20, r_force_drop = 21, r_snap_off_force = 22, r_snap_off_displacement = 23, &
      & r_critical_lateral_stiffness = 24, r_jump_base_displacement = 25, r_jump_displacement = 26, r_jump_force = 27, &
      & r_arrest_force = 28, r_jump_energy = 29, r_jump_period = 30, r_period_work = 31
   integer, parameter, public :: n_sphere_results = 31

contains

   !> The table of variables.
   function get_sphere_variables() result(v)
      type(variable_t), allocatable :: v(:)

      allocate (v(n_sphere_variables))
      v(v_units) = choice(group='sphere', name='units', meaning='SI, or the reduced units of Johnson (2.11) for everything', &
         & choices='si reduced', default='si')
      v(v_radius) = above_zero(group='sphere', name='radius', unit='m', meaning='radius R of the sphere')
      call set_modulus_rows(above_zero(group='sphere', name='contact_modulus', unit='Pa', meaning=''), &
         & v(v_contact_modulus:v_second_poisson_ratio))
      ! without its group a sweep means that of friction, which was there before
      v(v_contact_modulus:v_second_poisson_ratio)%has_bare_name = .false.
      v(v_work_of_adhesion) = any_number(group='sphere', name='work_of_adhesion', unit='J/m^2', meaning='w; 0: no adhesion', &
         & lower=0.0_dp)
      v(v_adhesion_stress) = above_zero(group='sphere', name='adhesion_stress', unit='Pa', &
         & meaning='sigma0, the stress of Dugdale''s law')
      v(v_adhesion_range) = above_zero(group='sphere', name='adhesion_range', unit='m', &
         & meaning='h0 = w/sigma0, instead of the stress')
      v(v_lambda) = above_zero(group='sphere', name='lambda', unit='-', meaning='Maugis''s parameter, instead of stress or range')

      v(v_shear_strength) = above_zero(group='friction', name='shear_strength', unit='Pa', &
         & meaning='tau0, the shear stress of sliding; reduced: in the scale of lambda')
      v(v_pressure_factor) = any_number(group='friction', name='pressure_factor', unit='-', &
         & meaning='alpha of the shear stress tau0 + alpha p in contact; 0 if not given', lower=0.0_dp)
      v(v_poisson_ratio) = poisson_ratio(group='friction', name='poisson_ratio', meaning='Poisson''s ratio')
      v(v_edge_fraction) = any_number(group='friction', name='edge_fraction', unit='-', &
         & meaning='x: friction acts up to the radius b = a + x (c - a)', default=0.4_dp, lower=0.0_dp, upper=1.0_dp)
      call set_interaction_rows(v(v_interaction:v_slip_energy_ratio))

      v(v_load) = any_number(group='operating', name='load', unit='N', meaning='load, pressing positive')
      v(v_approach) = any_number(group='operating', name='approach', unit='m', meaning='approach, instead of the load')
      v(v_contact_radius) = above_zero(group='operating', name='contact_radius', unit='m', &
         & meaning='radius a of contact, instead of the load')
      v(v_branch) = choice(group='operating', name='branch', &
         & meaning='where two states carry a load or have an approach: the stable one or the other', choices='stable unstable', &
         & default='stable')
      v(v_state) = choice(group='operating', name='state', meaning='before sliding, or during it', choices='static sliding', &
         & default='static')
      v(v_tangential_force) = any_number(group='operating', name='tangential_force', unit='N', meaning='T of the static state', &
         & lower=0.0_dp)
      v(v_tangential_displacement) = any_number(group='operating', name='tangential_displacement', unit='m', &
         & meaning='of the static state, instead of the force', lower=0.0_dp)
      v(v_base_displacement) = any_number(group='operating', name='base_displacement', unit='m', &
         & meaning='of the base of a lateral spring, from rest, instead of the force', lower=0.0_dp)
      v(v_lateral_stiffness) = above_zero(group='operating', name='lateral_stiffness', unit='N/m', &
         & meaning='of a lateral spring; the events then have its jumps')

      v(v_theory) = choice(group='model', name='theory', &
         & meaning='auto: the simplest one that is proved to be within relative_tolerance of maugis_dugdale', &
         & choices='auto hertz jkr dmt maugis_dugdale', default='auto')

      v(v_relative_tolerance) = any_number(group='numerics', name='relative_tolerance', unit='-', &
         & meaning='of the theory that auto may choose', default=1.0e-8_dp, lower=1.0e-15_dp, upper=0.5_dp)

      v(v_events) = switch(group='output', name='events', &
         & meaning='find the largest tangential force, the drop at the onset of sliding, snap-off, and jumps on a spring', &
         & default=.false.)
      v(v_profiles) = switch(group='output', name='profiles', meaning='write pressure, gap and shear stress of every point', &
         & default=.false.)
      v(v_n_r) = whole_number(group='output', name='n_r', meaning='samples of a profile', default=201, lower=2, upper=10000000)
      v(v_r_max) = above_zero(group='output', name='r_max', unit='m', meaning='radius up to which profiles are written')
   end function get_sphere_variables

   !> The table of results.
   function get_sphere_results(is_reduced) result(r)
      !> Are all quantities reduced? Then their unit is `-`.
      logical, intent(in) :: is_reduced
      type(result_t), allocatable :: r(:)
      character(:), allocatable :: force, length, area, energy, stiffness

      force = 'N'
      length = 'm'
      area = 'm^2'
      energy = 'J'
      stiffness = 'N/m'
      if (is_reduced) force = '-'
      if (is_reduced) length = '-'
      if (is_reduced) area = '-'
      if (is_reduced) energy = '-'
      if (is_reduced) stiffness = '-'
      allocate (r(n_sphere_results))
      r(r_load) = result_row(name='load', unit=force, long_name='load', is_main=.true.)
      r(r_approach) = result_row(name='approach', unit=length, long_name='approach of distant points', is_main=.true.)
      r(r_contact_radius) = result_row(name='contact_radius', unit=length, long_name='radius a of intimate contact', is_main=.true.)
      r(r_adhesion_radius) = result_row(name='adhesion_radius', unit=length, &
         & long_name='radius c up to which adhesion acts; none in DMT')
      r(r_friction_radius) = result_row(name='friction_radius', unit=length, long_name='radius b up to which friction acts')
      r(r_contact_area) = result_row(name='contact_area', unit=area, long_name='area pi a^2 of intimate contact')
      r(r_friction_area) = result_row(name='friction_area', unit=area, &
         & long_name='area pi b^2 on which friction acts; none without friction')
      r(r_friction_force) = result_row(name='friction_force', unit=force, long_name='tangential force', is_main=.true.)
      r(r_adhesion_ratio) = result_row(name='adhesion_ratio', unit='-', long_name='X, what friction leaves of the work of adhesion')
      r(r_stick_radius) = result_row(name='stick_radius', unit=length, long_name='radius e of the part that sticks')
      r(r_slip) = result_row(name='slip', unit=length, long_name='slip at the edge, mean around it; none once sliding')
      r(r_largest_slip) = result_row(name='largest_slip', unit=length, &
         & long_name='slip at the edge where it is largest; none once sliding')
      r(r_tangential_displacement) = result_row(name='tangential_displacement', unit=length, &
         & long_name='tangential displacement of distant points; none once sliding')
      r(r_pull_off_load) = result_row(name='pull_off_load', unit=force, &
         & long_name='load at which the contact separates in this control', is_main=.true.)
      r(r_stable) = result_row(name='stable', unit='-', long_name='is the state stable under the control that is given?', &
         & flag_meanings='unstable stable')
      r(r_theory_used) = result_row(name='theory_used', unit='-', long_name='theory that was used', &
         & flag_meanings='hertz jkr dmt maugis_dugdale')
      r(r_theory_error) = result_row(name='theory_error', unit='-', &
         & long_name='proved bound of the relative error of radii, load and approach by that theory')
      r(r_peak_force) = result_row(name='peak_force', unit=force, long_name='largest tangential force before sliding')
      r(r_peak_displacement) = result_row(name='peak_displacement', unit=length, &
         & long_name='tangential displacement at the largest force')
      r(r_sliding_force) = result_row(name='sliding_force', unit=force, long_name='tangential force of sliding at this load')
      r(r_force_drop) = result_row(name='force_drop', unit=force, long_name='force that is lost at the onset of sliding')
      r(r_snap_off_force) = result_row(name='snap_off_force', unit=force, &
         & long_name='tangential force at which the contact snaps off')
      r(r_snap_off_displacement) = result_row(name='snap_off_displacement', unit=length, &
         & long_name='tangential displacement at that place')
      r(r_critical_lateral_stiffness) = result_row(name='critical_lateral_stiffness', unit=stiffness, &
         & long_name='lateral stiffness from which on there is no stick-slip; 0: never any, none: at every stiffness')
      r(r_jump_base_displacement) = result_row(name='jump_base_displacement', unit=length, &
         & long_name='displacement of the base from rest where the contact jumps')
      r(r_jump_displacement) = result_row(name='jump_displacement', unit=length, &
         & long_name='tangential displacement of the contact at that place')
      r(r_jump_force) = result_row(name='jump_force', unit=force, long_name='tangential force at the onset of the jump')
      r(r_arrest_force) = result_row(name='arrest_force', unit=force, long_name='tangential force right after the jump')
      r(r_jump_energy) = result_row(name='jump_energy', unit=energy, long_name='energy that the jump takes')
      r(r_jump_period) = result_row(name='jump_period', unit=length, &
         & long_name='displacement of the base from one jump to the next, if rest heals the contact')
      r(r_period_work) = result_row(name='period_work', unit=energy, long_name='work of the base from one jump to the next')
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
      p(1) = profile_t(name='pressure', unit=stress, long_name='pressure, compression positive')
      p(2) = profile_t(name='shear_stress', unit=stress, long_name='shear stress')
      p(3) = profile_t(name='gap', unit=length, long_name='gap')
   end function get_sphere_profiles

end module adfric_round_sphere_variables
