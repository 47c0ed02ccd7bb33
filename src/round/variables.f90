! SPDX-License-Identifier: GPL-3.0-or-later
!> The namelist variables, results and profiles of the model `indenter`.
module adfric_round_variables
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_base_constants, only: half_pi
   use adfric_base_text, only: show_number
   use adfric_base_unset, only: is_set
   use adfric_solid_contact_modulus, only: set_modulus_rows
   use adfric_interface_conduction_rows, only: conduction_results, n_conduction_results, n_conduction_rows, set_conduction_rows
   use adfric_interface_friction_law_rows, only: n_law_rows, set_law_rows
   use adfric_interface_heat_rows, only: heat_results, n_heat_results, n_heat_rows, set_heat_rows
   use adfric_interface_interaction_rows, only: set_interaction_rows
   use adfric_interface_shear_strength_rows, only: set_shear_rows, shear_profiles, p_shear_stress
   use adfric_describe_rows, only: positive, number, any_number, above_zero, choice, switch, whole_number, result_row
   use adfric_describe_table, only: variable_t, result_t, profile_t, profile_axis_t
   implicit none (type, external)
   private
   public :: get_indenter_variables, get_indenter_results, get_indenter_profiles, indenter_unit_of
   public :: set_slip_rows, set_event_rows, radius_axis

   !> Variables in the order of their rows; a component is the index of its row.
   type :: indenter_input_t
      !> Indices of the rows.
      integer :: kind = 0, radius = 0, slope = 0, half_angle = 0, exponent = 0, coefficient = 0, face_radius = 0, &
         & coefficient_1 = 0, coefficient_2 = 0, coefficient_3 = 0, coefficient_4 = 0, coefficient_5 = 0, coefficient_6 = 0, &
         & coefficient_7 = 0, coefficient_8 = 0, contact_modulus = 0, young_modulus = 0, poisson_ratio = 0, &
         & second_young_modulus = 0, second_poisson_ratio = 0, work_of_adhesion = 0, adhesion_stress = 0, adhesion_range = 0, &
         & lambda = 0, theory = 0, load = 0, approach = 0, contact_radius = 0, face_angle = 0, branch = 0, profiles = 0, &
         & n_r = 0, r_max = 0, tangential_force = 0, friction_coefficient = 0, shear_strength = 0, pressure_factor = 0, &
         & edge_fraction = 0, position_z = 0, base_approach = 0, machine_stiffness = 0, events = 0, law = 0, state = 0, &
         & interaction = 0, critical_slip = 0, slip_energy_ratio = 0, lateral_stiffness = 0, base_displacement = 0, &
         & velocity_law(n_law_rows - 1) = 0, temperature = 0, velocity = 0, heat(n_heat_rows) = 0, &
         & conduction(n_conduction_rows) = 0
   end type indenter_input_t
   type(indenter_input_t), parameter, public :: indenter_input = transfer(counting, indenter_input_t())
   integer, parameter, public :: n_indenter_variables = storage_size(indenter_input)/storage_size(1)

   !> Indices of the words in the choices.
   integer, parameter, public :: kind_flat = 1, kind_cone = 2, kind_paraboloid = 3, kind_power = 4, kind_sphere = 5, &
      & kind_flat_cone = 6, kind_flat_paraboloid = 7, kind_rounded_punch = 8, kind_rounded_cone = 9, kind_polynomial = 10
   integer, parameter, public :: choose_auto = 1, choose_none = 2, choose_jkr = 3, choose_dmt = 4, &
      & choose_maugis_dugdale = 5
   integer, parameter, public :: law_shear_strength = 1, law_peeling = 2, state_static = 1, state_sliding = 2
   !> Theories, as results.
   integer, parameter, public :: theory_none = 0, theory_jkr = 1, theory_dmt = 2, theory_maugis_dugdale = 3

   !> Results in the order of their rows; a component is the index of its row.
   type :: indenter_output_t
      !> Indices of the rows.
      integer :: load = 0, approach = 0, contact_radius = 0, contact_area = 0, mean_pressure = 0, contact_stiffness = 0, &
         & elastic_energy = 0, pull_off_load = 0, pull_off_approach = 0, jump_inward_load = 0, jump_inward_approach = 0, &
         & jump_outward_load = 0, jump_outward_approach = 0, stable = 0, theory_used = 0, adhesion_radius = 0, &
         & stick_fraction = 0, tangential_displacement = 0, tangential_stiffness = 0, cycle_energy = 0, friction_area = 0, &
         & friction_force = 0, stress_zz = 0, stress_rr = 0, base_approach = 0, jump_in_base_approach = 0, jump_in_load = 0, &
         & pull_off_base_approach = 0, loop_energy = 0, friction_radius = 0, adhesion_ratio = 0, stick_radius = 0, slip = 0, &
         & largest_slip = 0, peak_force = 0, peak_displacement = 0, sliding_force = 0, force_drop = 0, snap_off_force = 0, &
         & snap_off_displacement = 0, critical_lateral_stiffness = 0, jump_base_displacement = 0, jump_displacement = 0, &
         & jump_force = 0, arrest_force = 0, jump_energy = 0, jump_period = 0, period_work = 0, tangential_force = 0, &
         & velocity_slope = 0, heat(n_heat_results) = 0, conductances(n_conduction_results) = 0, &
         & full_stick_stiffness = 0, full_stick_load = 0, full_stick_approach = 0
   end type indenter_output_t
   type(indenter_output_t), parameter, public :: indenter_output = transfer(counting, indenter_output_t())
   integer, parameter, public :: n_indenter_results = storage_size(indenter_output)/storage_size(1)
   !> Indices of the profiles; that of the shear stress comes from the rows of friction.
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
         & v(indenter_input%contact_modulus:indenter_input%second_poisson_ratio))
      v(indenter_input%work_of_adhesion) = number(group='adhesion', name='work_of_adhesion', unit='J/m^2', &
         & meaning='w; 0, or without it: no adhesion', lower=0.0_dp)
      v(indenter_input%adhesion_stress) = above_zero(group='adhesion', name='adhesion_stress', unit='Pa', &
         & meaning='sigma0, the stress of Dugdale''s law; without it, or range or lambda, the range is 0')
      v(indenter_input%adhesion_range) = above_zero(group='adhesion', name='adhesion_range', unit='m', &
         & meaning='h0 = w/sigma0, instead of the stress')
      v(indenter_input%lambda) = above_zero(group='adhesion', name='lambda', unit='-', &
         & meaning='Maugis''s parameter of r^n, instead of the stress; of a cone, a paraboloid or a power')
      v(indenter_input%theory) = choice(group='model', name='theory', &
         & meaning='of adhesion; auto: none without a work of adhesion, jkr without a range, else maugis_dugdale; dmt: r^2 alone', &
         & choices='auto none jkr dmt maugis_dugdale', default='auto')
      v(indenter_input%load) = any_number(group='operating', name='load', unit='N', meaning='load, pressing positive')
      v(indenter_input%approach) = any_number(group='operating', name='approach', unit='m', meaning='approach, instead of the load')
      v(indenter_input%contact_radius) = positive(group='operating', name='contact_radius', unit='m', &
         & meaning='radius a of contact, instead of the load')
      v(indenter_input%face_angle) = any_number(group='operating', name='face_angle', unit='rad', &
         & meaning='phi = arccos(b/a), instead of the load, where a is close to the radius b of a face', lower=0.0_dp, &
         & upper=half_pi)
      v(indenter_input%face_angle)%upper_open = .true.
      v(indenter_input%branch) = choice(group='operating', name='branch', &
         & meaning='where several states carry a load or have an approach: ' &
         & //'the largest stable one, the smallest stable one (inner), or the largest unstable one', &
         & choices='stable inner unstable', default='stable')
      v(indenter_input%profiles) = switch(group='output', name='profiles', meaning='write pressure and gap of every point', &
         & default=.false.)
      v(indenter_input%n_r) = whole_number(group='output', name='n_r', meaning='samples of a profile', default=201, lower=2, &
         & upper=10000000)
      v(indenter_input%r_max) = above_zero(group='output', name='r_max', unit='m', &
         & meaning='radius up to which profiles are written')
      v(indenter_input%tangential_force) = any_number(group='operating', name='tangential_force', unit='N', &
         & meaning='T, which has grown from 0 under the load; up to that of sliding, of either sign')
      v(indenter_input%friction_coefficient) = positive(group='friction', name='coefficient', unit='-', &
         & meaning='mu of Coulomb''s friction, without adhesion')
      ! a sweep of a coefficient means that of the shape
      v(indenter_input%friction_coefficient)%has_bare_name = .false.
      call set_shear_rows(v(indenter_input%shear_strength:indenter_input%pressure_factor))
      v(indenter_input%edge_fraction) = any_number(group='friction', name='edge_fraction', unit='-', &
         & meaning='x of the radius b = a + x (c - a) up to which a shear strength acts', default=0.4_dp, &
         & lower=0.0_dp, upper=1.0_dp)
      v(indenter_input%position_z) = above_zero(group='position', name='position_z', unit='m', &
         & meaning='depth below the middle of the contact where the stresses on the axis are')
      v(indenter_input%base_approach) = any_number(group='operating', name='base_approach', unit='m', &
         & meaning='approach of the base of the spring, approach + load/machine_stiffness, instead of the load')
      v(indenter_input%machine_stiffness) = above_zero(group='operating', name='machine_stiffness', unit='N/m', &
         & meaning='k of the spring (a cantilever, a machine) between the indenter and its base')
      v(indenter_input%events) = switch(group='output', name='events', &
         & meaning='find where contact jumps in, what a cycle of approach and retraction takes, and what happens as a tangential ' &
         & //'force grows', default=.false.)
      v(indenter_input%law) = choice(group='friction', name='law', &
         & meaning='friction of a shear strength (or of a coefficient), a contact that sticks without limit and peels (JKR), ' &
         & //'or a law of velocity and temperature', choices='shear_strength peeling power activated bonds log_gaussian table', &
         & default='shear_strength')
      v(indenter_input%state) = choice(group='operating', name='state', meaning='before sliding, or during it', &
         & choices='static sliding', &
         & default='static')
      call set_interaction_rows(v(indenter_input%interaction:indenter_input%slip_energy_ratio))
      v(indenter_input%lateral_stiffness) = above_zero(group='operating', name='lateral_stiffness', unit='N/m', &
         & meaning='of a lateral spring; the events then have its jumps')
      v(indenter_input%base_displacement) = any_number(group='operating', name='base_displacement', unit='m', &
         & meaning='of the base of a lateral spring, from rest, instead of the force', lower=0.0_dp)
      call set_velocity_rows(v)
      call set_conduction_rows(v(indenter_input%conduction(1):))
   end function get_indenter_variables

   !> The rows of the law of velocity and temperature, of both, and of heat.
   subroutine set_velocity_rows(v)
      !> The table of variables.
      type(variable_t), intent(inout) :: v(:)
      type(variable_t) :: rows(n_law_rows)
      integer :: k

      call set_law_rows(rows)
      ! the first one is the law, of which indenters have more
      do k = 2, n_law_rows
         v(indenter_input%velocity_law(k - 1)) = rows(k)
      end do
      v(indenter_input%temperature) = above_zero(group='operating', name='temperature', unit='K', &
         & meaning='temperature of the interface, for laws of friction that depend on it')
      v(indenter_input%velocity) = number(group='operating', name='velocity', unit='m/s', &
         & meaning='sliding velocity, for laws of friction that depend on it, and for heat')
      call set_heat_rows(v(indenter_input%heat(1):indenter_input%heat(n_heat_rows)))
   end subroutine set_velocity_rows

   !> The rows of the shape.
   subroutine set_shape_rows(v)
      !> The table of variables, whose first rows are set.
      type(variable_t), intent(inout) :: v(:)
      character(1) :: degree, power
      integer :: i

      v(indenter_input%kind) = choice(group='shape', name='kind', meaning='profile f(r)', &
         & choices='flat cone paraboloid power sphere ' &
         & //'flat_cone flat_paraboloid rounded_punch rounded_cone polynomial')
      v(indenter_input%radius) = positive(group='shape', name='radius', unit='m', &
         & meaning='R of a paraboloid r^2/2R, a sphere, the edge of a rounded punch, or the tip of a rounded cone')
      v(indenter_input%slope) = positive(group='shape', name='slope', unit='-', meaning='of a cone against the plane, f'' = slope')
      v(indenter_input%half_angle) = any_number(group='shape', name='half_angle', unit='rad', &
         & meaning='of a cone from its axis, instead of the slope cot(half_angle)', lower=0.0_dp, upper=half_pi)
      v(indenter_input%half_angle)%lower_open = .true.
      v(indenter_input%half_angle)%upper_open = .true.
      v(indenter_input%exponent) = any_number(group='shape', name='exponent', unit='-', meaning='n of f = C r^n', lower=0.0_dp, &
         & upper=100.0_dp)
      v(indenter_input%exponent)%lower_open = .true.
      v(indenter_input%coefficient) = any_number(group='shape', name='coefficient', unit='m^(1-n)', meaning='C of f = C r^n', &
         & lower=0.0_dp, &
         & upper=largest_coefficient)
      v(indenter_input%coefficient)%lower_open = .true.
      v(indenter_input%face_radius) = positive(group='shape', name='face_radius', unit='m', meaning='radius b of a flat face')
      do i = 1, indenter_input%coefficient_8 - indenter_input%coefficient_1 + 1
         write (degree, '(i1)') i
         write (power, '(i1)') i - 1
         associate (row => v(indenter_input%coefficient_1 + i - 1))
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
      r(indenter_output%load) = result_row(name='load', unit='N', long_name='load', is_main=.true.)
      r(indenter_output%approach) = result_row(name='approach', unit='m', long_name='approach of distant points', is_main=.true.)
      r(indenter_output%contact_radius) = result_row(name='contact_radius', unit='m', long_name='radius a of contact', &
         & is_main=.true.)
      r(indenter_output%contact_area) = result_row(name='contact_area', unit='m^2', long_name='area pi a^2 of contact')
      r(indenter_output%mean_pressure) = result_row(name='mean_pressure', unit='Pa', long_name='load over area of contact')
      r(indenter_output%contact_stiffness) = result_row(name='contact_stiffness', unit='N/m', &
         & long_name='change of load with approach, along the states of contact')
      r(indenter_output%elastic_energy) = result_row(name='elastic_energy', unit='J', long_name='elastic energy of the solids')
      r(indenter_output%pull_off_load) = result_row(name='pull_off_load', unit='N', &
         & long_name='load at which the contact separates, the least one of all stable states', is_main=.true.)
      r(indenter_output%pull_off_approach) = result_row(name='pull_off_approach', unit='m', &
         & long_name='approach at which the contact separates')
      r(indenter_output%jump_inward_load) = result_row(name='jump_inward_load', unit='N', &
         & long_name='load at which retraction makes the contact jump to a smaller one')
      r(indenter_output%jump_inward_approach) = result_row(name='jump_inward_approach', unit='m', &
         & long_name='approach before that jump')
      r(indenter_output%jump_outward_load) = result_row(name='jump_outward_load', unit='N', &
         & long_name='load at which pressing makes the contact jump to a larger one')
      r(indenter_output%jump_outward_approach) = result_row(name='jump_outward_approach', unit='m', &
         & long_name='approach before that jump')
      r(indenter_output%stable) = result_row(name='stable', unit='-', &
         & long_name='is the state stable while the load, approach or radius is as prescribed?', &
         & flag_meanings='unstable stable')
      r(indenter_output%theory_used) = result_row(name='theory_used', unit='-', long_name='theory that was used', &
         & flag_meanings='none jkr dmt maugis_dugdale')
      r(indenter_output%adhesion_radius) = result_row(name='adhesion_radius', unit='m', &
         & long_name='radius c up to which adhesion acts; none in DMT')
      r(indenter_output%stick_fraction) = result_row(name='stick_fraction', unit='-', &
         & long_name='share that sticks of the area where friction acts; a tangential force has it')
      r(indenter_output%tangential_displacement) = result_row(name='tangential_displacement', unit='m', &
         & long_name='of distant points by the tangential force')
      r(indenter_output%tangential_stiffness) = result_row(name='tangential_stiffness', unit='N/m', &
         & long_name='slope of the tangential force over its displacement, while it grows')
      r(indenter_output%cycle_energy) = result_row(name='cycle_energy', unit='J', &
         & long_name='energy that friction takes in a cycle between T and -T')
      r(indenter_output%friction_area) = result_row(name='friction_area', unit='m^2', &
         & long_name='area pi b^2 where a shear strength acts')
      r(indenter_output%friction_force) = result_row(name='friction_force', unit='N', &
         & long_name='force of sliding against a shear strength', is_main=.true.)
      r(indenter_output%stress_zz) = result_row(name='stress_zz', unit='Pa', &
         & long_name='stress along the axis at position_z, tension positive')
      r(indenter_output%stress_rr) = result_row(name='stress_rr', unit='Pa', &
         & long_name='stress across the axis at position_z, tension positive; in the body of poisson_ratio')
      r(indenter_output%base_approach) = result_row(name='base_approach', unit='m', long_name='approach of the base of the spring')
      r(indenter_output%jump_in_base_approach) = result_row(name='jump_in_base_approach', unit='m', &
         & long_name='approach of the base, or of an indenter without spring, at which contact jumps in; ' &
         & //'of several jumps, that of the one that takes most energy')
      r(indenter_output%jump_in_load) = result_row(name='jump_in_load', unit='N', &
         & long_name='load right after contact has jumped in')
      r(indenter_output%pull_off_base_approach) = result_row(name='pull_off_base_approach', unit='m', &
         & long_name='approach of the base, or of an indenter without spring, at which the contact separates')
      r(indenter_output%loop_energy) = result_row(name='loop_energy', unit='J', &
         & long_name='energy that the jumps of a cycle of approach and retraction take')
      call set_peeling_results(r)
      r(indenter_output%conductances(1):indenter_output%conductances(n_conduction_results)) = conduction_results(.false.)
      r(indenter_output%full_stick_stiffness) = result_row(name='full_stick_stiffness', unit='N/m', &
         & long_name='contact stiffness if nothing slips on this contact')
      r(indenter_output%full_stick_load) = result_row(name='full_stick_load', unit='N', &
         & long_name='load of this contact radius if nothing slips while the load grows')
      r(indenter_output%full_stick_approach) = result_row(name='full_stick_approach', unit='m', &
         & long_name='approach of this contact radius if nothing slips while the load grows')
   end function get_indenter_results

   !> The results of what friction does to adhesion, and of heat.
   subroutine set_peeling_results(r)
      !> The table of results, whose last rows are set.
      type(result_t), intent(inout) :: r(:)

      r(indenter_output%friction_radius) = result_row(name='friction_radius', unit='m', &
         & long_name='radius b up to which a shear strength acts')
      call set_slip_rows(r(indenter_output%adhesion_ratio:indenter_output%largest_slip))
      call set_event_rows(r(indenter_output%peak_force:indenter_output%period_work))
      r(indenter_output%tangential_force) = result_row(name='tangential_force', unit='N', &
         & long_name='tangential force at a given displacement of the base of a lateral spring')
      r(indenter_output%velocity_slope) = result_row(name='velocity_slope', unit='-', long_name='d ln T/d ln v of the friction T ' &
         & //'over the velocity v at this temperature; below 0 steady sliding may be unstable')
      r(indenter_output%heat(1):indenter_output%heat(n_heat_results)) = heat_results('W')
   end subroutine set_peeling_results

   !> The rows of slip at the edge, from X to the largest slip.
   subroutine set_slip_rows(r)
      type(result_t), intent(inout) :: r(:)
      integer, parameter :: before = indenter_output%adhesion_ratio - 1

      associate (o => indenter_output)
         r(o%adhesion_ratio - before) = result_row(name='adhesion_ratio', unit='-', &
            & long_name='X, what friction leaves of the work of adhesion')
         r(o%stick_radius - before) = result_row(name='stick_radius', unit='m', long_name='radius e of the part that sticks')
         r(o%slip - before) = result_row(name='slip', unit='m', long_name='slip at the edge, mean around it; none once sliding')
         r(o%largest_slip - before) = result_row(name='largest_slip', unit='m', &
            & long_name='slip at the edge where it is largest; none once sliding')
      end associate
   end subroutine set_slip_rows

   !> The rows of what happens as a tangential force grows, from the largest force to the work of a period.
   subroutine set_event_rows(r)
      type(result_t), intent(inout) :: r(:)
      integer, parameter :: before = indenter_output%peak_force - 1

      associate (o => indenter_output)
         r(o%peak_force - before) = result_row(name='peak_force', unit='N', long_name='largest tangential force before sliding')
         r(o%peak_displacement - before) = result_row(name='peak_displacement', unit='m', &
            & long_name='tangential displacement at the largest force')
         r(o%sliding_force - before) = result_row(name='sliding_force', unit='N', &
            & long_name='tangential force of sliding at the prescribed load, approach or radius')
         r(o%force_drop - before) = result_row(name='force_drop', unit='N', long_name='force that is lost at the onset of sliding')
         r(o%snap_off_force - before) = result_row(name='snap_off_force', unit='N', &
            & long_name='tangential force at which the contact snaps off, or jumps to a smaller one')
         r(o%snap_off_displacement - before) = result_row(name='snap_off_displacement', unit='m', &
            & long_name='tangential displacement where the contact snaps off')
         r(o%critical_lateral_stiffness - before) = result_row(name='critical_lateral_stiffness', unit='N/m', &
            & long_name='lateral stiffness from which on there is no stick-slip; 0: never any, none: at every stiffness')
         r(o%jump_base_displacement - before) = result_row(name='jump_base_displacement', unit='m', &
            & long_name='displacement of the base of a lateral spring from rest where the contact jumps')
         r(o%jump_displacement - before) = result_row(name='jump_displacement', unit='m', &
            & long_name='tangential displacement of the contact where it jumps')
         r(o%jump_force - before) = result_row(name='jump_force', unit='N', long_name='tangential force at the onset of the jump')
         r(o%arrest_force - before) = result_row(name='arrest_force', unit='N', long_name='tangential force right after the jump')
         r(o%jump_energy - before) = result_row(name='jump_energy', unit='J', long_name='energy that the jump takes')
         r(o%jump_period - before) = result_row(name='jump_period', unit='m', &
            & long_name='displacement of the base from one jump to the next, if rest heals the contact')
         r(o%period_work - before) = result_row(name='period_work', unit='J', &
            & long_name='work of the base from one jump to the next')
      end associate
   end subroutine set_event_rows

   !> The axis of profiles, from the axis of the contact on.
   function radius_axis(r_max, n_r, unit) result(axes)
      !> The largest radius, and the number of samples, as they are given.
      real(dp), intent(in) :: r_max, n_r
      !> Unit of the radius.
      character(*), intent(in) :: unit
      type(profile_axis_t) :: axes(1)
      integer :: n, k

      axes(1)%name = 'r'
      axes(1)%unit = unit
      axes(1)%long_name = 'distance from the axis'
      n = nint(n_r)
      allocate (axes(1)%coordinates(n), source=0.0_dp)
      if (is_set(r_max)) axes(1)%coordinates = [(r_max*k/(n - 1), k=0, n - 1)]
   end function radius_axis

   !> The table of profiles.
   function get_indenter_profiles() result(p)
      type(profile_t), allocatable :: p(:)

      p = shear_profiles()
   end function get_indenter_profiles

   !> Unit of a variable of a body: that of the coefficient of r^n depends on n.
   function indenter_unit_of(variables, values, index) result(unit)
      type(variable_t), intent(in) :: variables(:)
      real(dp), intent(in) :: values(:)
      !> Index of the variable in the table.
      integer, intent(in) :: index
      character(:), allocatable :: unit

      unit = variables(index)%unit
      if (index /= indenter_input%coefficient .or. .not. is_set(values(indenter_input%exponent))) return
      unit = 'm^(1-'//show_number(values(indenter_input%exponent))//')'
   end function indenter_unit_of

end module adfric_round_variables
