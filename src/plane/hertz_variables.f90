! SPDX-License-Identifier: GPL-3.0-or-later
!> The namelist variables and results of the model `hertz`.
module adfric_plane_hertz_variables
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_interface_conduction_rows, only: conduction_results, n_conduction_results, n_conduction_rows, set_conduction_rows
   use adfric_interface_friction_law_rows, only: n_interface_rows, set_law_rows
   use adfric_interface_shear_coupling, only: coupling_results, coupling_row
   use adfric_interface_heat_rows, only: heat_results, n_heat_results, n_heat_rows, set_heat_rows
   use adfric_interface_shear_strength_rows, only: n_shear_rows, set_shear_rows
   use adfric_interface_total_friction, only: total_friction_results
   use adfric_solid_contact_modulus, only: set_modulus_rows
   use adfric_solid_spectrum_rows, only: set_spectrum_rows, n_spectrum_rows
   use adfric_describe_rows, only: choice, number, positive, result_row, switch
   use adfric_describe_table, only: variable_t, result_t
   implicit none (type, external)
   private
   public :: get_hertz_variables, get_hertz_results

   !> Variables in the order of their rows; a component is the index of its row.
   type :: hertz_input_t
      !> Indices of the rows.
      integer :: kind = 0, radius = 0, radius_1x = 0, radius_1y = 0, radius_2x = 0, radius_2y = 0, angle = 0, &
         & contact_modulus = 0, young_modulus = 0, poisson_ratio = 0, second_young_modulus = 0, second_poisson_ratio = 0, &
         & material(n_spectrum_rows - 1) = 0, temperature = 0, velocity = 0, load = 0, approach = 0, contact_half_width = 0, &
         & peak_pressure = 0, tangential_force = 0, tangential_axis = 0, creepage = 0, state = 0, coefficient = 0, &
         & friction(n_interface_rows) = 0, coupling = 0, &
         & heat(n_heat_rows) = 0, conduction(n_conduction_rows) = 0, largest_stresses = 0, yield_strength = 0
   end type hertz_input_t
   type(hertz_input_t), parameter, public :: hertz_input = transfer(counting, hertz_input_t())
   !> Indices of the words of `kind`.
   integer, parameter, public :: kind_line = 1, kind_circular = 2, kind_elliptical = 3
   !> Index of the word of `tangential_axis` for the force along the minor axis, and that of the word of `state` for a cylinder that
   !> rolls.
   integer, parameter, public :: axis_minor = 2, state_rolling = 2
   !> Results in the order of their rows; a component is the index of its row.
   type :: hertz_output_t
      !> Indices of the rows.
      integer :: load = 0, approach = 0, half_width = 0, minor = 0, peak_pressure = 0, mean_pressure = 0, contact_area = 0, &
         & direction = 0, shear = 0, shear_depth = 0, violation = 0, friction_force = 0, friction_coefficient = 0, &
         & contact_shift = 0, dissipation = 0, energy_imbalance = 0, stick_fraction = 0, tangential_displacement = 0, &
         & tangential_stiffness = 0, cycle_energy = 0, hysteretic_friction_force = 0, interfacial_friction_force = 0, &
         & interfacial_share = 0, velocity_slope = 0, largest_coupling = 0, smallest_stiffness_ratio = 0, &
         & coupling_left_out = 0, heat(n_heat_results) = 0, contact_stiffness = 0, conductances(n_conduction_results) = 0, &
         & tangential_force = 0, creepage = 0, von_mises = 0, von_mises_depth = 0, yield_ratio = 0, yield_load = 0
   end type hertz_output_t
   type(hertz_output_t), parameter, public :: hertz_output = transfer(counting, hertz_output_t())
   !> Number of results.
   integer, parameter :: n_results = storage_size(hertz_output)/storage_size(1)

contains

   !> The table of variables.
   function get_hertz_variables() result(v)
      type(variable_t), allocatable :: v(:)

      allocate (v(storage_size(hertz_input)/storage_size(1)))
      v(hertz_input%kind) = choice(group='contact', name='kind', &
         & meaning='parallel cylinders, spheres, or any smooth bodies; over a material: line', choices='line circular elliptical')
      v(hertz_input%radius) = positive(group='contact', name='radius', unit='m', meaning='R of line and circle, 1/R = 1/R1 + 1/R2')
      v(hertz_input%radius_1x) = number(group='contact', name='radius_1x', unit='m', &
         & meaning='principal radius of the first body, convex > 0; not given: flat')
      v(hertz_input%radius_1y) = number(group='contact', name='radius_1y', unit='m', meaning='its other principal radius')
      v(hertz_input%radius_2x) = number(group='contact', name='radius_2x', unit='m', meaning='principal radius of the second body')
      v(hertz_input%radius_2y) = number(group='contact', name='radius_2y', unit='m', meaning='its other principal radius')
      v(hertz_input%angle) = number(group='contact', name='angle', unit='rad', &
         & meaning='from the first principal direction of body 1 to that of body 2', default=0.0_dp)
      call set_modulus_rows(positive(group='solid', name='contact_modulus', unit='Pa', meaning=''), &
         & v(hertz_input%contact_modulus:hertz_input%second_poisson_ratio))
      v(hertz_input%poisson_ratio)%meaning = &
         & 'of the first body, and for the largest shear stress; a line without it: that in the plane'
      call set_spectrum_rows(v(hertz_input%material(1):hertz_input%temperature))
      ! a sweep of a modulus means the one of `solid`, where both have the name
      v(hertz_input%material(1):hertz_input%temperature &
         & - 1)%has_bare_name = .not. is_of_solid(v(hertz_input%material(1):hertz_input%temperature - 1))
      v(hertz_input%velocity) = number(group='operating', name='velocity', unit='m/s', &
         & meaning='sliding velocity of a rigid cylinder over the solid, positive to +x')
      v(hertz_input%load) = number(group='operating', name='load', unit='N; N/m for line', meaning='load', lower=0.0_dp)
      v(hertz_input%approach) = number(group='operating', name='approach', unit='m', &
         & meaning='of distant points, instead of the load; below 0 the bodies are apart; not for a line')
      v(hertz_input%contact_half_width) = positive(group='operating', name='contact_half_width', unit='m', &
         & meaning='half-width a of contact along the major axis, instead of the load')
      v(hertz_input%peak_pressure) = positive(group='operating', name='peak_pressure', unit='Pa', &
         & meaning='largest pressure between elastic bodies, instead of the load')
      v(hertz_input%tangential_force) = number(group='operating', name='tangential_force', unit='N; N/m for line', &
         & meaning='T, which has grown from 0 under the load; up to mu P, of either sign')
      v(hertz_input%tangential_axis) = choice(group='operating', name='tangential_axis', &
         & meaning='axis of the ellipse along which T acts, or the body slides; major if not given', choices='major minor')
      v(hertz_input%creepage) = number(group='operating', name='creepage', unit='-', &
         & meaning='of a cylinder that rolls, instead of tangential_force: how much faster it turns than it rolls, as a share')
      v(hertz_input%state) = choice(group='operating', name='state', &
         & meaning='is the body at rest (static, if not given), or does it roll (rolling)', choices='static rolling')
      v(hertz_input%coefficient) = positive(group='friction', name='coefficient', unit='-', &
         & meaning='mu of Coulomb''s friction between elastic bodies')
      call set_shear_rows(v(hertz_input%friction(1):hertz_input%friction(n_shear_rows)))
      call set_law_rows(v(hertz_input%friction(n_shear_rows + 1):hertz_input%friction(n_interface_rows)))
      v(hertz_input%coupling) = coupling_row()
      call set_heat_rows(v(hertz_input%heat(1):hertz_input%heat(n_heat_rows)))
      call set_conduction_rows(v(hertz_input%conduction(1):hertz_input%conduction(n_conduction_rows)))
      v(hertz_input%largest_stresses) = switch(group='output', name='largest_stresses', &
         & meaning='find the largest von Mises and shear stress in the solid, over all depths', default=.false.)
      v(hertz_input%yield_strength) = positive(group='solid', name='yield_strength', unit='Pa', &
         & meaning='von Mises stress at which the solid yields, for its ratio to the largest one')
   end function get_hertz_variables

   !> Does the group `solid` have a variable of the same name?
   elemental logical function is_of_solid(variable)
      type(variable_t), intent(in) :: variable

      is_of_solid = variable%name == 'young_modulus' .or. variable%name == 'poisson_ratio'
   end function is_of_solid

   !> The table of results.
   function get_hertz_results(is_line) result(r)
      !> Is the contact one along a line, so that load and area are per length? Absent before it is known: then the units are
      !> those of either.
      logical, intent(in), optional :: is_line
      type(result_t), allocatable :: r(:)
      character(:), allocatable :: force, area, energy

      force = 'N; N/m for line'
      area = 'm^2; m for line'
      energy = 'J; J/m for line'
      if (present(is_line)) then
         energy = trim(merge('J/m', 'J  ', is_line))
         force = trim(merge('N/m', 'N  ', is_line))
         area = trim(merge('m  ', 'm^2', is_line))
      end if
      allocate (r(n_results))
      r(hertz_output%load) = result_row(name='load', unit=force, long_name='load', is_main=.true.)
      r(hertz_output%approach) = result_row(name='approach', unit='m', &
         & long_name='approach of distant points; a line contact has none', &
         & is_main=.true.)
      r(hertz_output%half_width) = result_row(name='contact_half_width', unit='m', &
         & long_name='half-width a of contact, along the major axis x', is_main=.true.)
      r(hertz_output%minor) = result_row(name='minor_half_width', unit='m', long_name='half-width b along the minor axis y')
      r(hertz_output%peak_pressure) = result_row(name='peak_pressure', unit='Pa', long_name='largest pressure', is_main=.true.)
      r(hertz_output%mean_pressure) = result_row(name='mean_pressure', unit='Pa', long_name='load over area of contact')
      r(hertz_output%contact_area) = result_row(name='contact_area', unit=area, long_name='area of contact')
      r(hertz_output%direction) = result_row(name='major_axis_angle', unit='rad', &
         & long_name='from the first principal direction of body 1 to the major axis')
      r(hertz_output%shear) = result_row(name='largest_shear_stress', unit='Pa', &
         & long_name='largest shear stress in the solid by the pressure alone; no value where a cylinder slides or rolls')
      r(hertz_output%shear_depth) = result_row(name='largest_shear_depth', unit='m', long_name='its depth')
      r(hertz_output%violation) = result_row(name='contact_violation', unit='-', &
         & long_name='largest violation of g >= 0, p >= 0, g p = 0')
      call set_sliding_results(r, force)
      r(hertz_output%stick_fraction) = result_row(name='stick_fraction', unit='-', &
         & long_name='share of the area of contact that sticks; friction alone has it', is_main=.true.)
      r(hertz_output%tangential_displacement) = result_row(name='tangential_displacement', unit='m', &
         & long_name='of distant points by the tangential force; a line contact has none')
      r(hertz_output%tangential_stiffness) = result_row(name='tangential_stiffness', unit='N/m', &
         & long_name='slope of the tangential force over its displacement, while it grows')
      r(hertz_output%cycle_energy) = result_row(name='cycle_energy', unit=energy, &
         & long_name='energy that friction takes in a cycle between T and -T')
      r(hertz_output%hysteretic_friction_force:hertz_output%velocity_slope) = total_friction_results('force', force)
      r(hertz_output%largest_coupling:hertz_output%coupling_left_out) = coupling_results()
      r(hertz_output%heat(1):hertz_output%heat(n_heat_results)) = heat_results('W/m')
      r(hertz_output%contact_stiffness) = result_row(name='contact_stiffness', unit='N/m', &
         & long_name='change of load with approach; a line contact has none')
      r(hertz_output%conductances(1):hertz_output%conductances(n_conduction_results)) = conduction_results(.false.)
      r(hertz_output%tangential_force) = result_row(name='tangential_force', unit=force, &
         & long_name='force by which a cylinder that rolls drives the other body')
      r(hertz_output%creepage) = result_row(name='creepage', unit='-', &
         & long_name='how much faster a body turns than it rolls, as a share, with the sign of the force')
      r(hertz_output%von_mises) = result_row(name='largest_von_mises_stress', unit='Pa', &
         & long_name='largest von Mises stress in the solid, or at position_z')
      r(hertz_output%von_mises_depth) = result_row(name='largest_von_mises_depth', unit='m', long_name='its depth')
      r(hertz_output%yield_ratio) = result_row(name='yield_ratio', unit='-', &
         & long_name='largest von Mises stress over the yield strength; from 1 on the solid is not elastic')
      r(hertz_output%yield_load) = result_row(name='yield_load', unit=force, long_name='load at which the solid begins to yield')
   end function get_hertz_results

   !> The results of sliding.
   subroutine set_sliding_results(r, force)
      !> Receives the rows at their indices; shape `(n_results)`.
      type(result_t), intent(inout) :: r(:)
      !> Unit of a force.
      character(*), intent(in) :: force

      r(hertz_output%friction_force) = result_row(name='friction_force', unit=force, &
         & long_name='friction force of a body that slides, of a cylinder per length, with the sign of the velocity', &
         & is_main=.true.)
      r(hertz_output%friction_coefficient) = result_row(name='friction_coefficient', unit='-', &
         & long_name='friction force over load; no value without load', is_main=.true.)
      r(hertz_output%contact_shift) = result_row(name='contact_shift', unit='m', &
         & long_name='middle of the contact, from the lowest line of a sliding cylinder; no value without contact')
      r(hertz_output%dissipation) = result_row(name='dissipation', unit='N/m', &
         & long_name='energy lost per length and distance, in closed form; of a cylinder that rolls: force times creepage')
      r(hertz_output%energy_imbalance) = result_row(name='energy_imbalance', unit='-', &
         & long_name='work of the pressure, or of slip, from its profile, less the dissipation, over the dissipation')
   end subroutine set_sliding_results

end module adfric_plane_hertz_variables
