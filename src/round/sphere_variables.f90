! SPDX-License-Identifier: GPL-3.0-or-later
!> The namelist variables and results of the model `sphere`.
module adfric_round_sphere_variables
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_solid_contact_modulus, only: set_modulus_rows
   use adfric_interface_conduction_rows, only: conduction_results, n_conduction_results, n_conduction_rows, set_conduction_rows
   use adfric_interface_interaction_rows, only: set_interaction_rows
   use adfric_round_variables, only: set_event_rows, set_slip_rows
   use adfric_describe_rows, only: above_zero, choice, poisson_ratio, switch, whole_number, result_row, any_number
   use adfric_describe_table, only: variable_t, result_t, profile_t
   implicit none (type, external)
   private
   public :: get_sphere_variables, get_sphere_results, get_sphere_profiles

   !> Variables in the order of their rows; a component is the index of its row.
   type :: sphere_input_t
      !> Indices of the rows.
      integer :: units = 0, radius = 0, contact_modulus = 0, young_modulus = 0, body_poisson_ratio = 0, &
         & second_young_modulus = 0, second_poisson_ratio = 0, work_of_adhesion = 0, adhesion_stress = 0, adhesion_range = 0, &
         & lambda = 0, shear_strength = 0, pressure_factor = 0, poisson_ratio = 0, edge_fraction = 0, interaction = 0, &
         & critical_slip = 0, slip_energy_ratio = 0, load = 0, approach = 0, contact_radius = 0, branch = 0, state = 0, &
         & tangential_force = 0, tangential_displacement = 0, base_displacement = 0, lateral_stiffness = 0, theory = 0, &
         & relative_tolerance = 0, events = 0, profiles = 0, n_r = 0, r_max = 0, &
         & conduction(n_conduction_rows) = 0
   end type sphere_input_t
   type(sphere_input_t), parameter, public :: sphere_input = transfer(counting, sphere_input_t())
   integer, parameter, public :: n_sphere_variables = storage_size(sphere_input)/storage_size(1)

   !> Indices of the words in the choices.
   integer, parameter, public :: units_si = 1, units_reduced = 2, state_static = 1, state_sliding = 2
   integer, parameter, public :: choose_auto = 1

   !> Results in the order of their rows; a component is the index of its row.
   type :: sphere_output_t
      !> Indices of the rows.
      integer :: load = 0, approach = 0, contact_radius = 0, adhesion_radius = 0, friction_radius = 0, contact_area = 0, &
         & friction_area = 0, friction_force = 0, adhesion_ratio = 0, stick_radius = 0, slip = 0, largest_slip = 0, &
         & tangential_displacement = 0, pull_off_load = 0, stable = 0, theory_used = 0, theory_error = 0, peak_force = 0, &
         & peak_displacement = 0, sliding_force = 0, force_drop = 0, snap_off_force = 0, snap_off_displacement = 0, &
         & critical_lateral_stiffness = 0, jump_base_displacement = 0, jump_displacement = 0, jump_force = 0, &
         & arrest_force = 0, jump_energy = 0, jump_period = 0, period_work = 0, contact_stiffness = 0, &
         & conductances(n_conduction_results) = 0
   end type sphere_output_t
   type(sphere_output_t), parameter, public :: sphere_output = transfer(counting, sphere_output_t())
   integer, parameter, public :: n_sphere_results = storage_size(sphere_output)/storage_size(1)

contains

   !> The table of variables.
   function get_sphere_variables() result(v)
      type(variable_t), allocatable :: v(:)
      integer :: k

      allocate (v(n_sphere_variables))
      v(sphere_input%units) = choice(group='sphere', name='units', &
         & meaning='SI, or the reduced units of Johnson (2.11) for everything', &
         & choices='si reduced', default='si')
      v(sphere_input%radius) = above_zero(group='sphere', name='radius', unit='m', meaning='radius R of the sphere')
      call set_modulus_rows(above_zero(group='sphere', name='contact_modulus', unit='Pa', meaning=''), &
         & v(sphere_input%contact_modulus:sphere_input%second_poisson_ratio))
      ! without its group a sweep means that of friction, which was there before
      v(sphere_input%contact_modulus:sphere_input%second_poisson_ratio)%has_bare_name = .false.
      v(sphere_input%work_of_adhesion) = any_number(group='sphere', name='work_of_adhesion', unit='J/m^2', &
         & meaning='w; 0: no adhesion', &
         & lower=0.0_dp)
      v(sphere_input%adhesion_stress) = above_zero(group='sphere', name='adhesion_stress', unit='Pa', &
         & meaning='sigma0, the stress of Dugdale''s law')
      v(sphere_input%adhesion_range) = above_zero(group='sphere', name='adhesion_range', unit='m', &
         & meaning='h0 = w/sigma0, instead of the stress')
      v(sphere_input%lambda) = above_zero(group='sphere', name='lambda', unit='-', &
         & meaning='Maugis''s parameter, instead of stress or range')

      v(sphere_input%shear_strength) = above_zero(group='friction', name='shear_strength', unit='Pa', &
         & meaning='tau0, the shear stress of sliding; reduced: in the scale of lambda')
      v(sphere_input%pressure_factor) = any_number(group='friction', name='pressure_factor', unit='-', &
         & meaning='alpha of the shear stress tau0 + alpha p in contact; 0 if not given', lower=0.0_dp)
      v(sphere_input%poisson_ratio) = poisson_ratio(group='friction', name='poisson_ratio', meaning='Poisson''s ratio')
      v(sphere_input%edge_fraction) = any_number(group='friction', name='edge_fraction', unit='-', &
         & meaning='x: friction acts up to the radius b = a + x (c - a)', default=0.4_dp, lower=0.0_dp, upper=1.0_dp)
      call set_interaction_rows(v(sphere_input%interaction:sphere_input%slip_energy_ratio))

      v(sphere_input%load) = any_number(group='operating', name='load', unit='N', meaning='load, pressing positive')
      v(sphere_input%approach) = any_number(group='operating', name='approach', unit='m', meaning='approach, instead of the load')
      v(sphere_input%contact_radius) = above_zero(group='operating', name='contact_radius', unit='m', &
         & meaning='radius a of contact, instead of the load')
      v(sphere_input%branch) = choice(group='operating', name='branch', &
         & meaning='where two states carry a load or have an approach: the stable one or the other', choices='stable unstable', &
         & default='stable')
      v(sphere_input%state) = choice(group='operating', name='state', meaning='before sliding, or during it', &
         & choices='static sliding', &
         & default='static')
      v(sphere_input%tangential_force) = any_number(group='operating', name='tangential_force', unit='N', &
         & meaning='T of the static state', &
         & lower=0.0_dp)
      v(sphere_input%tangential_displacement) = any_number(group='operating', name='tangential_displacement', unit='m', &
         & meaning='of the static state, instead of the force', lower=0.0_dp)
      v(sphere_input%base_displacement) = any_number(group='operating', name='base_displacement', unit='m', &
         & meaning='of the base of a lateral spring, from rest, instead of the force', lower=0.0_dp)
      v(sphere_input%lateral_stiffness) = above_zero(group='operating', name='lateral_stiffness', unit='N/m', &
         & meaning='of a lateral spring; the events then have its jumps')

      v(sphere_input%theory) = choice(group='model', name='theory', &
         & meaning='auto: the simplest one that is proved to be within relative_tolerance of maugis_dugdale', &
         & choices='auto hertz jkr dmt maugis_dugdale', default='auto')

      v(sphere_input%relative_tolerance) = any_number(group='numerics', name='relative_tolerance', unit='-', &
         & meaning='of the theory that auto may choose', default=1.0e-8_dp, lower=1.0e-15_dp, upper=0.5_dp)

      v(sphere_input%events) = switch(group='output', name='events', &
         & meaning='find the largest tangential force, the drop at the onset of sliding, snap-off, and jumps on a spring', &
         & default=.false.)
      v(sphere_input%profiles) = switch(group='output', name='profiles', &
         & meaning='write pressure, gap and shear stress of every point', &
         & default=.false.)
      v(sphere_input%n_r) = whole_number(group='output', name='n_r', meaning='samples of a profile', default=201, lower=2, &
         & upper=10000000)
      v(sphere_input%r_max) = above_zero(group='output', name='r_max', unit='m', meaning='radius up to which profiles are written')
      call set_conduction_rows(v(sphere_input%conduction(1):))
      ! inputs that name the model have the solids in its group
      do k = 1, n_conduction_rows
         v(sphere_input%conduction(k))%group = 'sphere'
      end do
   end function get_sphere_variables

   !> The table of results.
   function get_sphere_results(is_reduced) result(r)
      !> Are all quantities reduced? Then their unit is `-`.
      logical, intent(in) :: is_reduced
      type(result_t), allocatable :: r(:)
      integer :: k

      allocate (r(n_sphere_results))
      r(sphere_output%load) = result_row(name='load', unit='N', long_name='load', is_main=.true.)
      r(sphere_output%approach) = result_row(name='approach', unit='m', long_name='approach of distant points', is_main=.true.)
      r(sphere_output%contact_radius) = result_row(name='contact_radius', unit='m', long_name='radius a of intimate contact', &
         & is_main=.true.)
      r(sphere_output%adhesion_radius) = result_row(name='adhesion_radius', unit='m', &
         & long_name='radius c up to which adhesion acts; none in DMT')
      r(sphere_output%friction_radius) = result_row(name='friction_radius', unit='m', &
         & long_name='radius b up to which friction acts')
      r(sphere_output%contact_area) = result_row(name='contact_area', unit='m^2', long_name='area pi a^2 of intimate contact')
      r(sphere_output%friction_area) = result_row(name='friction_area', unit='m^2', &
         & long_name='area pi b^2 on which friction acts; none without friction')
      r(sphere_output%friction_force) = result_row(name='friction_force', unit='N', long_name='tangential force', is_main=.true.)
      call set_slip_rows(r(sphere_output%adhesion_ratio:sphere_output%largest_slip))
      r(sphere_output%tangential_displacement) = result_row(name='tangential_displacement', unit='m', &
         & long_name='tangential displacement of distant points; none once sliding')
      r(sphere_output%pull_off_load) = result_row(name='pull_off_load', unit='N', &
         & long_name='load at which the contact separates', is_main=.true.)
      r(sphere_output%stable) = result_row(name='stable', unit='-', &
         & long_name='is the state stable while the load, approach or radius is as prescribed?', &
         & flag_meanings='unstable stable')
      r(sphere_output%theory_used) = result_row(name='theory_used', unit='-', long_name='theory that was used', &
         & flag_meanings='hertz jkr dmt maugis_dugdale')
      r(sphere_output%theory_error) = result_row(name='theory_error', unit='-', &
         & long_name='proved bound of the relative error of radii, load and approach by that theory')
      call set_event_rows(r(sphere_output%peak_force:sphere_output%period_work))
      r(sphere_output%sliding_force)%long_name = 'tangential force of sliding at this load'
      r(sphere_output%snap_off_force)%long_name = 'tangential force at which the contact snaps off'
      r(sphere_output%jump_base_displacement)%long_name = 'displacement of the base from rest where the contact jumps'
      r(sphere_output%contact_stiffness) = result_row(name='contact_stiffness', unit='N/m', &
         & long_name='change of load with approach, along the states of contact; none with friction and in maugis_dugdale')
      r(sphere_output%conductances(1):) = conduction_results(.false.)
      if (.not. is_reduced) return
      do k = 1, size(r)
         r(k)%unit = '-'
      end do
   end function get_sphere_results

   !> The table of profiles.
   function get_sphere_profiles(is_reduced) result(p)
      logical, intent(in) :: is_reduced
      type(profile_t), allocatable :: p(:)
      integer :: k

      allocate (p(3))
      p(1) = profile_t(name='pressure', unit='Pa', long_name='pressure, compression positive')
      p(2) = profile_t(name='shear_stress', unit='Pa', long_name='shear stress')
      p(3) = profile_t(name='gap', unit='m', long_name='gap')
      if (.not. is_reduced) return
      do k = 1, size(p)
         p(k)%unit = '-'
      end do
   end function get_sphere_profiles

end module adfric_round_sphere_variables
