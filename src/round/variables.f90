! SPDX-License-Identifier: GPL-3.0-or-later
!> The namelist variables, results and profiles of the model `indenter`.
module adfric_round_variables
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: half_pi
   use adfric_base_text, only: show_number
   use adfric_base_unset, only: is_set
   use adfric_solid_contact_modulus, only: set_modulus_rows
   use adfric_interface_interaction_rows, only: set_interaction_rows
   use adfric_interface_shear_strength_rows, only: set_shear_rows, shear_profiles, p_shear_stress
   use adfric_describe_rows, only: positive, number, any_number, above_zero, choice, switch, whole_number, result_row
   use adfric_describe_table, only: variable_t, result_t, profile_t
   implicit none (type, external)
   private
   public :: get_indenter_variables, get_indenter_results, get_indenter_profiles, indenter_unit_of

   !> Places of the variables.
   integer, parameter, public :: v_kind = 1, v_radius = 2, v_slope = 3, v_half_angle = 4, v_exponent = 5, v_coefficient = 6, &
      & v_face_radius = 7, v_coefficient_1 = 8, v_coefficient_8 = 15, v_contact_modulus = 16, v_poisson_ratio = 18, &
      & v_second_poisson_ratio = 20, &
      & v_work_of_adhesion = 21, v_adhesion_stress = 22, v_adhesion_range = 23, v_lambda = 24, v_theory = 25, v_load = 26, &
      & v_approach = 27, v_contact_radius = 28, v_face_angle = 29, v_branch = 30, v_profiles = 31, v_n_r = 32, v_r_max = 33, &
      & v_tangential_force = 34, v_friction_coefficient = 35, v_shear_strength = 36, v_pressure_factor = 37, v_edge_fraction = 38, &
      & v_position_z = 39, v_base_approach = 40, v_machine_stiffness = 41, v_events = 42, &
      & v_law = 43, v_state = 44, v_interaction = 45, v_critical_slip = 46, v_slip_energy_ratio = 47, &
      & v_lateral_stiffness = 48, v_base_displacement = 49
   integer, parameter, public :: n_indenter_variables = 49

   !> Places of the words in the choices.
   integer, parameter, public :: kind_flat = 1, kind_cone = 2, kind_paraboloid = 3, kind_power = 4, kind_sphere = 5, &
      & kind_flat_cone = 6, kind_flat_paraboloid = 7, kind_rounded_punch = 8, kind_rounded_cone = 9, kind_polynomial = 10
   integer, parameter, public :: choose_auto = 1, choose_none = 2, choose_jkr = 3, choose_dmt = 4, &
      & choose_maugis_dugdale = 5
   integer, parameter, public :: law_shear_strength = 1, law_peeling = 2, state_static = 1, state_sliding = 2
   !> Theories, as results.
   integer, parameter, public :: theory_none = 0, theory_jkr = 1, theory_dmt = 2, theory_maugis_dugdale = 3

   !> Places of the results.
   integer, parameter, public :: r_load = 1, r_approach = 2, r_contact_radius = 3, r_contact_area = 4, r_mean_pressure = 5, &
      & r_contact_stiffness = 6, r_elastic_energy = 7, r_pull_off_load = 8, r_pull_off_approach = 9, r_jump_inward_load = 10, &
      & r_jump_inward_approach = 11, r_jump_outward_load = 12, r_jump_outward_approach = 13, r_stable = 14, r_theory_used = 15, &
      & r_adhesion_radius = 16, r_stick_fraction = 17, r_tangential_displacement = 18, r_tangential_stiffness = 19, &
      & r_cycle_energy = 20, r_friction_area = 21, r_friction_force = 22, r_stress_zz = 23, &
      & r_stress_rr = 24, r_base_approach = 25, r_jump_in_base_approach = 26, r_jump_in_load = 27, r_pull_off_base_approach = 28, &
      & r_loop_energy = 29, r_friction_radius = 30, r_adhesion_ratio = 31, r_stick_radius = 32, r_slip = 33, r_largest_slip = 34, &
      & r_peak_force = 35, r_peak_displacement = 36, r_sliding_force = 37, r_force_drop = 38, r_snap_off_force = 39, &
      & r_snap_off_displacement = 40, r_critical_lateral_stiffness = 41, r_jump_base_displacement = 42, r_jump_displacement = 43, &
      & r_jump_force = 44, r_arrest_force = 45, r_jump_energy = 46, r_jump_period = 47, r_period_work = 48, &
      & r_tangential_force = 49
   integer, parameter, public :: n_indenter_results = 49
   !> Places of the profiles; that of the shear stress comes from the rows of friction.
   public :: p_shear_stress
   integer, parameter, public :: p_pressure = 1, p_gap = 2

   !> Largest coefficient of a profile; those of small tips are large.
   real(dp), parameter :: largest_coefficient = 1.0e200_dp

contains

   !> The table of variables.
   function get_indenter_variables() result(v)
      type(variable_t), allocatable :: v(:)

      allocate (v(n_indenter_variables))
      call set_shape_rows(v)
      call set_modulus_rows(positive(group='solid', name='contact_modulus', unit='Pa', meaning=''), &
         & v(v_contact_modulus:v_second_poisson_ratio))
      v(v_work_of_adhesion) = number(group='adhesion', name='work_of_adhesion', unit='J/m^2', &
         & meaning='w; 0, or without it: no adhesion', lower=0.0_dp)
      v(v_adhesion_stress) = above_zero(group='adhesion', name='adhesion_stress', unit='Pa', &
         & meaning='sigma0, the stress of Dugdale''s law; without it, or range or lambda, the range is 0')
      v(v_adhesion_range) = above_zero(group='adhesion', name='adhesion_range', unit='m', &
         & meaning='h0 = w/sigma0, instead of the stress')
      v(v_lambda) = above_zero(group='adhesion', name='lambda', unit='-', &
         & meaning='Maugis''s parameter of r^n, instead of the stress; of a cone, a paraboloid or a power')
      v(v_theory) = choice(group='model', name='theory', &
         & meaning='of adhesion; auto: none without a work of adhesion, jkr without a range, else maugis_dugdale; dmt: r^2 alone', &
         & choices='auto none jkr dmt maugis_dugdale', default='auto')
      v(v_load) = any_number(group='operating', name='load', unit='N', meaning='load, pressing positive')
      v(v_approach) = any_number(group='operating', name='approach', unit='m', meaning='approach, instead of the load')
      v(v_contact_radius) = positive(group='operating', name='contact_radius', unit='m', &
         & meaning='radius a of contact, instead of the load')
      v(v_face_angle) = any_number(group='operating', name='face_angle', unit='rad', &
         & meaning='phi = arccos(b/a), instead of the load, where a is close to the radius b of a face', lower=0.0_dp, &
         & upper=half_pi)
      v(v_face_angle)%upper_open = .true.
      v(v_branch) = choice(group='operating', name='branch', meaning='where several states carry a load or have an approach: ' &
         & //'the largest stable one, the smallest stable one (inner), or the largest unstable one', &
         & choices='stable inner unstable', default='stable')
      v(v_profiles) = switch(group='output', name='profiles', meaning='write pressure and gap of every point', default=.false.)
      v(v_n_r) = whole_number(group='output', name='n_r', meaning='samples of a profile', default=201, lower=2, upper=10000000)
      v(v_r_max) = above_zero(group='output', name='r_max', unit='m', meaning='radius up to which profiles are written')
      v(v_tangential_force) = any_number(group='operating', name='tangential_force', unit='N', &
         & meaning='T, which has grown from 0 under the load; up to that of sliding, of either sign')
      v(v_friction_coefficient) = positive(group='friction', name='coefficient', unit='-', &
         & meaning='mu of Coulomb''s friction, without adhesion')
      ! a sweep of a coefficient means that of the shape
      v(v_friction_coefficient)%has_bare_name = .false.
      call set_shear_rows(v(v_shear_strength:v_pressure_factor))
      v(v_edge_fraction) = any_number(group='friction', name='edge_fraction', unit='-', &
         & meaning='x of the radius b = a + x (c - a) up to which a shear strength acts', default=0.4_dp, &
         & lower=0.0_dp, upper=1.0_dp)
      v(v_position_z) = above_zero(group='position', name='position_z', unit='m', &
         & meaning='depth below the middle of the contact where the stresses on the axis are')
      v(v_base_approach) = any_number(group='operating', name='base_approach', unit='m', &
         & meaning='approach + load/machine_stiffness, instead of the load: that of what holds the spring')
      v(v_machine_stiffness) = above_zero(group='operating', name='machine_stiffness', unit='N/m', &
         & meaning='k of the spring (a cantilever, a machine) between the indenter and its base')
      v(v_events) = switch(group='output', name='events', &
         & meaning='find where contact jumps in, what a cycle of approach and retraction takes, and what happens as a tangential ' &
         & //'force grows', default=.false.)
      v(v_law) = choice(group='friction', name='law', meaning='friction of a shear strength (or of a coefficient), or a contact ' &
         & //'that sticks without limit and peels (JKR)', choices='shear_strength peeling', default='shear_strength')
      v(v_state) = choice(group='operating', name='state', meaning='before sliding, or during it', choices='static sliding', &
         & default='static')
      call set_interaction_rows(v(v_interaction:v_slip_energy_ratio))
      v(v_lateral_stiffness) = above_zero(group='operating', name='lateral_stiffness', unit='N/m', &
         & meaning='of a lateral spring; the events then have its jumps')
      v(v_base_displacement) = any_number(group='operating', name='base_displacement', unit='m', &
         & meaning='of the base of a lateral spring, from rest, instead of the force', lower=0.0_dp)
   end function get_indenter_variables

   !> The rows of the shape.
   subroutine set_shape_rows(v)
      !> The table of variables, whose first rows are set.
      type(variable_t), intent(inout) :: v(:)
      character(1) :: degree, power
      integer :: i

      v(v_kind) = choice(group='shape', name='kind', meaning='profile f(r)', choices='flat cone paraboloid power sphere ' &
         & //'flat_cone flat_paraboloid rounded_punch rounded_cone polynomial')
      v(v_radius) = positive(group='shape', name='radius', unit='m', &
         & meaning='R of a paraboloid r^2/2R, a sphere, the edge of a rounded punch, or the tip of a rounded cone')
      v(v_slope) = positive(group='shape', name='slope', unit='-', meaning='of a cone against the plane, f'' = slope')
      v(v_half_angle) = any_number(group='shape', name='half_angle', unit='rad', &
         & meaning='of a cone from its axis, instead of the slope cot(half_angle)', lower=0.0_dp, upper=half_pi)
      v(v_half_angle)%lower_open = .true.
      v(v_half_angle)%upper_open = .true.
      v(v_exponent) = any_number(group='shape', name='exponent', unit='-', meaning='n of f = C r^n', lower=0.0_dp, &
         & upper=100.0_dp)
      v(v_exponent)%lower_open = .true.
      v(v_coefficient) = any_number(group='shape', name='coefficient', unit='m^(1-n)', meaning='C of f = C r^n', lower=0.0_dp, &
         & upper=largest_coefficient)
      v(v_coefficient)%lower_open = .true.
      v(v_face_radius) = positive(group='shape', name='face_radius', unit='m', meaning='radius b of a flat face')
      do i = 1, v_coefficient_8 - v_coefficient_1 + 1
         write (degree, '(i1)') i
         write (power, '(i1)') i - 1
         associate (row => v(v_coefficient_1 + i - 1))
            row = any_number(group='shape', name='coefficient_'//degree, unit='1/m^'//power, &
               & meaning='C of C r^'//degree//' in a polynomial profile', default=0.0_dp, lower=0.0_dp, upper=largest_coefficient)
            if (i == 1) row%unit = '-'
            if (i == 2) row%unit = '1/m'
         end associate
      end do
   end subroutine set_shape_rows

   !> The table of results.
   function get_indenter_results() result(r)
      type(result_t), allocatable :: r(:)

      allocate (r(n_indenter_results))
      r(r_load) = result_row(name='load', unit='N', long_name='load', is_main=.true.)
      r(r_approach) = result_row(name='approach', unit='m', long_name='approach of distant points', is_main=.true.)
      r(r_contact_radius) = result_row(name='contact_radius', unit='m', long_name='radius a of contact', is_main=.true.)
      r(r_contact_area) = result_row(name='contact_area', unit='m^2', long_name='area pi a^2 of contact')
      r(r_mean_pressure) = result_row(name='mean_pressure', unit='Pa', long_name='load over area of contact')
      r(r_contact_stiffness) = result_row(name='contact_stiffness', unit='N/m', &
         & long_name='change of load with approach, along the states of contact')
      r(r_elastic_energy) = result_row(name='elastic_energy', unit='J', long_name='elastic energy of the solids')
      r(r_pull_off_load) = result_row(name='pull_off_load', unit='N', &
         & long_name='load at which the contact separates in this control, the least one of all stable states', is_main=.true.)
      r(r_pull_off_approach) = result_row(name='pull_off_approach', unit='m', &
         & long_name='approach at which the contact separates in this control')
      r(r_jump_inward_load) = result_row(name='jump_inward_load', unit='N', &
         & long_name='load at which retraction makes the contact jump to a smaller one')
      r(r_jump_inward_approach) = result_row(name='jump_inward_approach', unit='m', long_name='approach before that jump')
      r(r_jump_outward_load) = result_row(name='jump_outward_load', unit='N', &
         & long_name='load at which pressing makes the contact jump to a larger one')
      r(r_jump_outward_approach) = result_row(name='jump_outward_approach', unit='m', long_name='approach before that jump')
      r(r_stable) = result_row(name='stable', unit='-', long_name='is the state stable under the control that is given?', &
         & flag_meanings='unstable stable')
      r(r_theory_used) = result_row(name='theory_used', unit='-', long_name='theory that was used', &
         & flag_meanings='none jkr dmt maugis_dugdale')
      r(r_adhesion_radius) = result_row(name='adhesion_radius', unit='m', &
         & long_name='radius c up to which adhesion acts; none in DMT')
      r(r_stick_fraction) = result_row(name='stick_fraction', unit='-', &
         & long_name='share that sticks of the area where friction acts; a tangential force has it')
      r(r_tangential_displacement) = result_row(name='tangential_displacement', unit='m', &
         & long_name='of distant points by the tangential force')
      r(r_tangential_stiffness) = result_row(name='tangential_stiffness', unit='N/m', &
         & long_name='slope of the tangential force over its displacement, while it grows')
      r(r_cycle_energy) = result_row(name='cycle_energy', unit='J', &
         & long_name='energy that friction takes in a cycle between T and -T')
      r(r_friction_area) = result_row(name='friction_area', unit='m^2', &
         & long_name='area pi b^2 where a shear strength acts')
      r(r_friction_force) = result_row(name='friction_force', unit='N', &
         & long_name='force of sliding against a shear strength')
      r(r_stress_zz) = result_row(name='stress_zz', unit='Pa', long_name='stress along the axis at position_z, tension positive')
      r(r_stress_rr) = result_row(name='stress_rr', unit='Pa', &
         & long_name='stress across the axis at position_z, tension positive; in the body of poisson_ratio')
      r(r_base_approach) = result_row(name='base_approach', unit='m', long_name='approach of the base of the spring')
      r(r_jump_in_base_approach) = result_row(name='jump_in_base_approach', unit='m', &
         & long_name='approach of the base, or of an indenter without spring, at which contact jumps in; ' &
         & //'of several jumps, that of the one that takes most energy')
      r(r_jump_in_load) = result_row(name='jump_in_load', unit='N', long_name='load right after contact has jumped in')
      r(r_pull_off_base_approach) = result_row(name='pull_off_base_approach', unit='m', &
         & long_name='approach of the base, or of an indenter without spring, at which the contact separates')
      r(r_loop_energy) = result_row(name='loop_energy', unit='J', &
         & long_name='energy that the jumps of a cycle of approach and retraction take')
      call set_peeling_results(r)
   end function get_indenter_results

   !> The results of what friction does to adhesion.
   subroutine set_peeling_results(r)
      !> The table of results, whose last rows are set.
      type(result_t), intent(inout) :: r(:)

      r(r_friction_radius) = result_row(name='friction_radius', unit='m', long_name='radius b up to which a shear strength acts')
      r(r_adhesion_ratio) = result_row(name='adhesion_ratio', unit='-', &
         & long_name='X, what friction leaves of the work of adhesion')
      r(r_stick_radius) = result_row(name='stick_radius', unit='m', long_name='radius e of the part that sticks')
      r(r_slip) = result_row(name='slip', unit='m', long_name='slip at the edge, mean around it; none once sliding')
      r(r_largest_slip) = result_row(name='largest_slip', unit='m', &
         & long_name='slip at the edge where it is largest; none once sliding')
      r(r_peak_force) = result_row(name='peak_force', unit='N', long_name='largest tangential force before sliding')
      r(r_peak_displacement) = result_row(name='peak_displacement', unit='m', &
         & long_name='tangential displacement at the largest force')
      r(r_sliding_force) = result_row(name='sliding_force', unit='N', long_name='tangential force of sliding under what is held')
      r(r_force_drop) = result_row(name='force_drop', unit='N', long_name='force that is lost at the onset of sliding')
      r(r_snap_off_force) = result_row(name='snap_off_force', unit='N', &
         & long_name='tangential force at which the contact snaps off, or jumps to a smaller one')
      r(r_snap_off_displacement) = result_row(name='snap_off_displacement', unit='m', &
         & long_name='tangential displacement at that place')
      r(r_critical_lateral_stiffness) = result_row(name='critical_lateral_stiffness', unit='N/m', &
         & long_name='lateral stiffness from which on there is no stick-slip; 0: never any, none: at every stiffness')
      r(r_jump_base_displacement) = result_row(name='jump_base_displacement', unit='m', &
         & long_name='displacement of the base of a lateral spring from rest where the contact jumps')
      r(r_jump_displacement) = result_row(name='jump_displacement', unit='m', &
         & long_name='tangential displacement of the contact at that place')
      r(r_jump_force) = result_row(name='jump_force', unit='N', long_name='tangential force at the onset of the jump')
      r(r_arrest_force) = result_row(name='arrest_force', unit='N', long_name='tangential force right after the jump')
      r(r_jump_energy) = result_row(name='jump_energy', unit='J', long_name='energy that the jump takes')
      r(r_jump_period) = result_row(name='jump_period', unit='m', &
         & long_name='displacement of the base from one jump to the next, if rest heals the contact')
      r(r_period_work) = result_row(name='period_work', unit='J', long_name='work of the base from one jump to the next')
      r(r_tangential_force) = result_row(name='tangential_force', unit='N', &
         & long_name='tangential force at a given displacement of the base of a lateral spring')
   end subroutine set_peeling_results

   !> The table of profiles.
   function get_indenter_profiles() result(p)
      type(profile_t), allocatable :: p(:)

      p = shear_profiles()
   end function get_indenter_profiles

   !> Unit of a variable of a body: that of the coefficient of r^n depends on n.
   function indenter_unit_of(variables, values, place) result(unit)
      !> The table of variables.
      type(variable_t), intent(in) :: variables(:)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Place of the variable in the table.
      integer, intent(in) :: place
      character(:), allocatable :: unit

      unit = variables(place)%unit
      if (place /= v_coefficient .or. .not. is_set(values(v_exponent))) return
      unit = 'm^(1-'//show_number(values(v_exponent))//')'
   end function indenter_unit_of

end module adfric_round_variables
