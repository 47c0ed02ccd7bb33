! SPDX-License-Identifier: GPL-3.0-or-later
!> The namelist variables and results of the model `hertz`.
module adfric_plane_hertz_variables
   use adfric_base_kinds, only: dp
   use adfric_solid_contact_modulus, only: set_modulus_rows
   use adfric_solid_spectrum_rows, only: set_spectrum_rows, n_spectrum_rows
   use adfric_describe_rows, only: choice, number, positive, result_row
   use adfric_describe_table, only: variable_t, result_t
   implicit none (type, external)
   private
   public :: get_hertz_variables, get_hertz_results

   !> Places of the variables. The rows of the material stand between `v_material` and `v_temperature`.
   integer, parameter, public :: v_kind = 1, v_radius = 2, v_radius_1x = 3, v_radius_1y = 4, v_radius_2x = 5, v_radius_2y = 6, &
      & v_angle = 7, v_contact_modulus = 8, v_poisson_ratio = 10, v_second_poisson_ratio = 12, v_material = 13, &
      & v_temperature = v_material - 1 + n_spectrum_rows, v_velocity = v_temperature + 1, v_load = v_temperature + 2, &
      & v_approach = v_temperature + 3, v_tangential_force = v_temperature + 4, v_tangential_axis = v_temperature + 5, &
      & v_coefficient = v_temperature + 6
   !> Places of the words of `kind`.
   integer, parameter, public :: kind_line = 1, kind_circular = 2, kind_elliptical = 3
   !> Place of the word of `tangential_axis` for the force along the minor axis.
   integer, parameter, public :: axis_minor = 2
   !> Places of the results; those from `r_friction_force` on belong to sliding, those from `r_stick_fraction` on to partial slip.
   integer, parameter, public :: r_load = 1, r_approach = 2, r_half_width = 3, r_minor = 4, r_peak_pressure = 5, &
      & r_mean_pressure = 6, r_contact_area = 7, r_direction = 8, r_shear = 9, r_shear_depth = 10, r_violation = 11, &
      & r_friction_force = 12, r_friction_coefficient = 13, r_contact_shift = 14, r_dissipation = 15, r_energy_imbalance = 16, &
      & r_stick_fraction = 17, r_tangential_displacement = 18, r_tangential_stiffness = 19, r_cycle_energy = 20
   !> Number of results.
   integer, parameter :: n_results = 20

contains

   !> The table of variables.
   function get_hertz_variables() result(v)
      type(variable_t), allocatable :: v(:)

      allocate (v(v_coefficient))
      v(v_kind) = choice(group='contact', name='kind', &
         & meaning='parallel cylinders, spheres, or any smooth bodies; over a material: line', choices='line circular elliptical')
      v(v_radius) = positive(group='contact', name='radius', unit='m', meaning='R of line and circle, 1/R = 1/R1 + 1/R2')
      v(v_radius_1x) = number(group='contact', name='radius_1x', unit='m', &
         & meaning='principal radius of the first body, convex > 0; not given: flat')
      v(v_radius_1y) = number(group='contact', name='radius_1y', unit='m', meaning='its other principal radius')
      v(v_radius_2x) = number(group='contact', name='radius_2x', unit='m', meaning='principal radius of the second body')
      v(v_radius_2y) = number(group='contact', name='radius_2y', unit='m', meaning='its other principal radius')
      v(v_angle) = number(group='contact', name='angle', unit='rad', &
         & meaning='from the first principal direction of body 1 to that of body 2', default=0.0_dp)
      call set_modulus_rows(positive(group='solid', name='contact_modulus', unit='Pa', meaning=''), &
         & v(v_contact_modulus:v_second_poisson_ratio))
      v(v_poisson_ratio)%meaning = 'of the first body, and for the largest shear stress; a line without it: that in the plane'
      call set_spectrum_rows(v(v_material:v_temperature))
      ! a sweep of a modulus means the one of `solid`, where both have the name
      v(v_material:v_temperature - 1)%has_bare_name = .not. is_of_solid(v(v_material:v_temperature - 1))
      v(v_velocity) = number(group='operating', name='velocity', unit='m/s', &
         & meaning='sliding velocity of a rigid cylinder over the material, positive to +x')
      v(v_load) = number(group='operating', name='load', unit='N; N/m for line', meaning='load', lower=0.0_dp)
      v(v_approach) = number(group='operating', name='approach', unit='m', &
         & meaning='of distant points, instead of the load; below 0 the bodies are apart; not for a line')
      v(v_tangential_force) = number(group='operating', name='tangential_force', unit='N; N/m for line', &
         & meaning='T, which has grown from 0 under the load; up to mu P, of either sign')
      v(v_tangential_axis) = choice(group='operating', name='tangential_axis', &
         & meaning='axis of the ellipse along which T acts; major if not given', choices='major minor')
      v(v_coefficient) = positive(group='friction', name='coefficient', unit='-', &
         & meaning='mu of Coulomb''s friction between elastic bodies')
   end function get_hertz_variables

   !> Does the group `solid` have a variable of the same name?
   elemental logical function is_of_solid(variable)
      !> A variable of another group.
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
      r(r_load) = result_row(name='load', unit=force, long_name='load', is_main=.true.)
      r(r_approach) = result_row(name='approach', unit='m', long_name='approach of distant points; a line contact has none', &
         & is_main=.true.)
      r(r_half_width) = result_row(name='contact_half_width', unit='m', &
         & long_name='half-width a of contact, along the major axis x', is_main=.true.)
      r(r_minor) = result_row(name='minor_half_width', unit='m', long_name='half-width b along the minor axis y')
      r(r_peak_pressure) = result_row(name='peak_pressure', unit='Pa', long_name='largest pressure', is_main=.true.)
      r(r_mean_pressure) = result_row(name='mean_pressure', unit='Pa', long_name='load over area of contact')
      r(r_contact_area) = result_row(name='contact_area', unit=area, long_name='area of contact')
      r(r_direction) = result_row(name='major_axis_angle', unit='rad', &
         & long_name='from the first principal direction of body 1 to the major axis')
      r(r_shear) = result_row(name='largest_shear_stress', unit='Pa', &
         & long_name='largest shear stress in the solid; not sought, and no value, where a cylinder slides')
      r(r_shear_depth) = result_row(name='largest_shear_depth', unit='m', long_name='its depth')
      r(r_violation) = result_row(name='contact_violation', unit='-', long_name='largest violation of g >= 0, p >= 0, g p = 0')
      call set_sliding_results(r)
      r(r_stick_fraction) = result_row(name='stick_fraction', unit='-', &
         & long_name='share of the area of contact that sticks; friction alone has it', is_main=.true.)
      r(r_tangential_displacement) = result_row(name='tangential_displacement', unit='m', &
         & long_name='of distant points by the tangential force; a line contact has none')
      r(r_tangential_stiffness) = result_row(name='tangential_stiffness', unit='N/m', &
         & long_name='slope of the tangential force over its displacement, while it grows')
      r(r_cycle_energy) = result_row(name='cycle_energy', unit=energy, &
         & long_name='energy that friction takes in a cycle between T and -T')
   end function get_hertz_results

   !> The results of sliding.
   subroutine set_sliding_results(r)
      !> Receives the rows at their places; shape `(n_results)`.
      type(result_t), intent(inout) :: r(:)

      r(r_friction_force) = result_row(name='friction_force', unit='N/m', &
         & long_name='friction force per length of a sliding cylinder, with the sign of the velocity')
      r(r_friction_coefficient) = result_row(name='friction_coefficient', unit='-', &
         & long_name='friction force over load; no value without load', is_main=.true.)
      r(r_contact_shift) = result_row(name='contact_shift', unit='m', &
         & long_name='middle of the contact, from the lowest line of a sliding cylinder; no value without contact')
      r(r_dissipation) = result_row(name='dissipation', unit='N/m', &
         & long_name='energy lost per length and distance, in closed form')
      r(r_energy_imbalance) = result_row(name='energy_imbalance', unit='-', &
         & long_name='work of the pressure, from its profile, less the dissipation, over the dissipation')
   end subroutine set_sliding_results

end module adfric_plane_hertz_variables
