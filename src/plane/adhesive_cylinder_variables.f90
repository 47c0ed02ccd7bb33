! SPDX-License-Identifier: GPL-3.0-or-later
!> The variables and results of the model `adhesive_cylinder`.
module adfric_plane_adhesive_cylinder_variables
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_interface_adhesion_rows, only: branch_row, n_stress_rows, set_stress_rows
   use adfric_interface_friction_law_rows, only: n_interface_rows, set_law_rows
   use adfric_interface_shear_strength_rows, only: n_shear_rows, set_shear_rows
   use adfric_interface_total_friction, only: total_friction_results
   use adfric_solid_spectrum_rows, only: n_spectrum_rows, set_spectrum_rows
   use adfric_describe_rows, only: number, positive, result_row
   use adfric_describe_table, only: result_t, variable_t
   implicit none (type, external)
   private
   public :: get_adhesive_cylinder_variables, get_adhesive_cylinder_results

   !> Variables in the order of their rows; a component is the index of its row.
   type :: adhesive_cylinder_input_t
      !> Indices of the rows.
      integer :: radius = 0, stress(n_stress_rows) = 0, branch = 0, material(n_spectrum_rows - 1) = 0, temperature = 0, &
         & velocity = 0, load = 0, friction(n_interface_rows) = 0
   end type adhesive_cylinder_input_t
   type(adhesive_cylinder_input_t), parameter, public :: adhesive_cylinder_input = transfer(counting, adhesive_cylinder_input_t())
   !> Results in the order of their rows; a component is the index of its row.
   type :: adhesive_cylinder_output_t
      !> Indices of the rows.
      integer :: load = 0, half_width = 0, peak_pressure = 0, mean_pressure = 0, friction_force = 0, friction_coefficient = 0, &
         & friction_without_adhesion = 0, adhesive_friction_force = 0, contact_shift = 0, zone_leading = 0, zone_trailing = 0, &
         & pull_off_load = 0, pull_off_half_width = 0, branches_differ = 0, order_margin = 0, dissipation = 0, &
         & energy_imbalance = 0, violation = 0, hysteretic_friction_force = 0, interfacial_friction_force = 0, &
         & interfacial_share = 0, velocity_slope = 0
   end type adhesive_cylinder_output_t
   type(adhesive_cylinder_output_t), parameter, public :: &
      & adhesive_cylinder_output = transfer(counting, adhesive_cylinder_output_t())
   !> Number of results.
   integer, parameter :: n_results = storage_size(adhesive_cylinder_output)/storage_size(1)

contains

   !> The table of variables.
   function get_adhesive_cylinder_variables() result(v)
      type(variable_t), allocatable :: v(:)

      associate (in => adhesive_cylinder_input)
         allocate (v(storage_size(in)/storage_size(1)))
         v(in%radius) = positive(group='surface', name='radius', unit='m', meaning='R of the rigid cylinder')
         call set_stress_rows(v(in%stress(1):in%stress(n_stress_rows)))
         v(in%branch) = branch_row()
         call set_spectrum_rows(v(in%material(1):in%temperature))
         v(in%velocity) = number(group='operating', name='velocity', unit='m/s', &
            & meaning='sliding velocity over the material, positive to +x')
         v(in%load) = number(group='operating', name='load', unit='N/m', &
            & meaning='load of the cylinder per length; below 0 it is pulled')
         call set_shear_rows(v(in%friction(1):in%friction(n_shear_rows)))
         call set_law_rows(v(in%friction(n_shear_rows + 1):in%friction(n_interface_rows)))
      end associate
   end function get_adhesive_cylinder_variables

   !> The table of results.
   function get_adhesive_cylinder_results() result(r)
      type(result_t), allocatable :: r(:)

      allocate (r(n_results))
      associate (out => adhesive_cylinder_output)
         r(out%load) = result_row(name='load', unit='N/m', long_name='load per length', is_main=.true.)
         r(out%half_width) = result_row(name='contact_half_width', unit='m', long_name='half-width of contact', is_main=.true.)
         r(out%peak_pressure) = result_row(name='peak_pressure', unit='Pa', long_name='largest pressure', is_main=.true.)
         r(out%mean_pressure) = result_row(name='mean_contact_pressure', unit='Pa', long_name='load over area of contact')
         r(out%friction_force) = result_row(name='friction_force', unit='N/m', is_main=.true., &
            & long_name='friction force per length, of losses and of the interface, with the sign of the velocity')
         r(out%friction_coefficient) = result_row(name='friction_coefficient', unit='-', &
            & long_name='friction force over load; no value without a load that presses')
         r(out%dissipation) = result_row(name='dissipation', unit='N/m', long_name='energy that the solid loses per length and ' &
            & //'distance, by the far field of the pressure')
         r(out%energy_imbalance) = result_row(name='energy_imbalance', unit='-', &
            & long_name='work of the pressure, from its profile, less the dissipation, over the dissipation')
         r(out%violation) = result_row(name='contact_violation', unit='-', &
            & long_name='largest violation of g = 0 and p >= -p0 in contact, and of the range of adhesion')
         r(out%hysteretic_friction_force:out%velocity_slope) = total_friction_results('force', 'N/m')
      end associate
      call set_adhesion_results(r)
   end function get_adhesive_cylinder_results

   !> The results of adhesion.
   subroutine set_adhesion_results(r)
      !> Receives the rows at their indices; shape `(n_results)`.
      type(result_t), intent(inout) :: r(:)

      associate (out => adhesive_cylinder_output)
         r(out%friction_without_adhesion) = result_row(name='friction_force_without_adhesion', unit='N/m', &
            & long_name='losses per length of the same load and velocity without adhesion; no value where nothing presses')
         r(out%adhesive_friction_force) = result_row(name='adhesive_friction_force', unit='N/m', &
            & long_name='losses per length with adhesion, less those without')
         r(out%contact_shift) = result_row(name='contact_shift', unit='m', &
            & long_name='middle of the contact, from the lowest line of the cylinder, positive to +x')
         r(out%zone_leading) = result_row(name='zone_leading', unit='m', &
            & long_name='length of the adhesion zone ahead of the contact')
         r(out%zone_trailing) = result_row(name='zone_trailing', unit='m', &
            & long_name='length of the adhesion zone behind the contact')
         r(out%pull_off_load) = result_row(name='pull_off_load', unit='N/m', &
            & long_name='least load per length of a contact at this velocity')
         r(out%pull_off_half_width) = result_row(name='pull_off_half_width', unit='m', &
            & long_name='half-width of contact at the least load; 0 where the contact shrinks to a line first')
         r(out%branches_differ) = result_row(name='branches_differ', unit='-', &
            & long_name='1 where the other branch has another state, 0 where it has none or the same')
         r(out%order_margin) = result_row(name='order_margin', unit='-', &
            & long_name='order of states M/Einf; where >= 0 the branches bound all states')
      end associate
   end subroutine set_adhesion_results

end module adfric_plane_adhesive_cylinder_variables
