! SPDX-License-Identifier: GPL-3.0-or-later
!> Rows of the tables that all models of a periodic surface share: tolerance, then those of the solid, what is prescribed, and the
!> maps; and those of the models on an elastic half-space, which may adhere.
module adfric_periodic_variables
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_base_unset, only: is_set
   use adfric_interface_adhesion_rows, only: n_adhesion_rows
   use adfric_interface_attraction_rows, only: n_attraction_rows
   use adfric_solid_contact_modulus, only: n_two_bodies
   use adfric_interface_conduction_rows, only: conduction_results, n_conduction_results, n_conduction_rows
   use adfric_interface_coulomb_rows, only: n_coulomb_rows, slip_results
   use adfric_interface_friction_law_rows, only: n_law_rows
   use adfric_interface_shear_coupling, only: coupling_results
   use adfric_interface_total_friction, only: total_friction_results
   use adfric_interface_shear_strength_rows, only: n_shear_rows
   use adfric_periodic_hardness_rows, only: hardness_results, n_hardness_results
   use adfric_periodic_layer_rows, only: n_layer_rows
   use adfric_periodic_stress_rows, only: n_stress_results, n_stress_rows, stress_results
   use adfric_describe_rows, only: number, switch, result_row, any_number
   use adfric_describe_table, only: variable_t, result_t
   implicit none (type, external)
   private
   public :: tolerance_row, set_prescribed_rows, pull_off_row, pull_off_pressure_row, is_wanted, get_periodic_results
   public :: get_elastic_results, smooth_fraction_row, stiffness_row, stiffness_error_row

   !> Variables in the order of their rows; a component is the index of its row.
   type :: periodic_input_t
      !> Indices of the rows.
      integer :: mean_pressure = 0, penetration = 0, profiles = 0
   end type periodic_input_t
   type(periodic_input_t), parameter, public :: periodic_input = transfer(counting, periodic_input_t())
   integer, parameter, public :: n_prescribed = storage_size(periodic_input)/storage_size(1)
   !> Number of the rows that the models on an elastic half-space share.
   integer, parameter, public :: n_elastic_solid = n_two_bodies + n_adhesion_rows + n_attraction_rows &
      & + n_conduction_rows + 1 + n_stress_rows + 1 + n_coulomb_rows + n_shear_rows + 1 + n_law_rows + 2 + n_layer_rows
   integer, parameter, public :: n_periodic_variables = 1 + n_elastic_solid + n_prescribed

   !> Results in the order of their rows; a component is the index of its row.
   type :: periodic_output_t
      !> Indices of the rows.
      integer :: mean_pressure = 0, penetration = 0, contact_fraction = 0, contact_fraction_error = 0, peak_pressure = 0, &
         & mean_gap = 0, full_contact_pressure = 0, contact_violation = 0, regime = 0, adhesion_fraction = 0, &
         & elastic_energy = 0, adhesion_energy = 0, pull_off_pressure = 0, cells_per_zone = 0, friction_stress = 0, &
         & friction_coefficient = 0, friction_force = 0, stick_fraction = 0, tangential_displacement = 0, &
         & tangential_stiffness = 0, cycle_energy = 0, poisson_defect = 0, smooth_fraction = 0, smooth_friction = 0, &
         & velocity_slope = 0, coupling_left_out = 0, opening_loss = 0, contact_stiffness = 0, stiffness_error = 0, &
         & conductances(n_conduction_results) = 0, stresses(n_stress_results) = 0, impressions(n_hardness_results) = 0
   end type periodic_output_t
   type(periodic_output_t), parameter, public :: periodic_output = transfer(counting, periodic_output_t())
   integer, parameter, public :: n_periodic_results = periodic_output%contact_violation
   !> Indices of those that the models on an elastic half-space add, and their number in all.
   integer, parameter, public :: n_elastic_results = storage_size(periodic_output)/storage_size(1)
   !> Numbers of the regimes; they have the words of `wave_1d`.
   integer, parameter, public :: regime_none = 0, regime_partial = 1, regime_full = 2, regime_adhesion_only = 3, &
      & regime_adhesion_zones = 4, regime_saturated_adhesion = 5

contains

   !> The row of the tolerance.
   type(variable_t) function tolerance_row() result(v)

      v = any_number(group='numerics', name='relative_tolerance', unit='-', &
         & meaning='largest violation of the conditions of contact', default=1.0e-10_dp, lower=1.0e-13_dp, upper=1.0e-3_dp)
   end function tolerance_row

   !> Rows of what is prescribed and of the maps.
   subroutine set_prescribed_rows(v, may_pull)
      !> Receives the rows; shape `(n_prescribed)`.
      type(variable_t), intent(inout) :: v(:)
      !> May the load be below 0?
      logical, intent(in) :: may_pull

      v(periodic_input%mean_pressure) = number(group='operating', name='mean_pressure', unit='Pa', &
         & meaning='load over nominal area', &
         & lower=0.0_dp)
      if (may_pull) v(periodic_input%mean_pressure) = number(group='operating', name='mean_pressure', unit='Pa', &
         & meaning='load over nominal area; below 0 with adhesion alone')
      v(periodic_input%penetration) = number(group='operating', name='penetration', unit='m', &
         & meaning='approach from first touch, at the mean of the deformed surface, instead')
      v(periodic_input%profiles) = switch(group='output', name='profiles', &
         & meaning='write maps of pressure and gap for every point', &
         & default=.false.)
   end subroutine set_prescribed_rows

   !> The switch of the pull-off.
   type(variable_t) function pull_off_row() result(v)

      v = switch(group='output', name='pull_off', meaning='find the pull-off of the adhered branch', default=.false.)
   end function pull_off_row

   !> The switch of the contact stiffness.
   type(variable_t) function stiffness_row() result(v)

      v = switch(group='output', name='stiffness', meaning='find the contact stiffness: slope of the load over the approach', &
         & default=.false.)
   end function stiffness_row

   !> The error of stiffness and conductances among the results.
   type(result_t) function stiffness_error_row() result(r)

      r = result_row(name='stiffness_error', unit='-', &
         & long_name='bound of the relative error of contact stiffness and conductances')
   end function stiffness_error_row

   !> The pull-off among the results.
   type(result_t) function pull_off_pressure_row() result(r)

      r = result_row(name='pull_off_pressure', unit='Pa', &
         & long_name='least mean pressure of the adhered branch, with &output pull_off', is_main=.true.)
   end function pull_off_pressure_row

   !> Is a switch on, which a model may not have?
   pure logical function is_wanted(value)
      !> Value of the switch, or `unset`.
      real(dp), intent(in) :: value

      is_wanted = is_set(value) .and. value > 0
   end function is_wanted

   !> The table of results of the models on an elastic half-space.
   function get_elastic_results() result(r)
      type(result_t), allocatable :: r(:)

      allocate (r(n_elastic_results))
      r(:n_periodic_results) = get_periodic_results()
      r(periodic_output%penetration)%long_name = &
         & 'approach from first touch, at the mean of the deformed surface, or at the base of a layer'
      r(periodic_output%contact_violation)%long_name = &
         & 'largest violation of g >= 0, p >= 0, g p = 0; with adhesion p + p0 t for p, t its ' &
         & //'share of a cell'
      r(periodic_output%regime) = result_row(name='regime', unit='-', long_name='regime', &
         & flag_meanings='no_contact partial full adhesion_without_contact adhesion_zones saturated_adhesion')
      r(periodic_output%adhesion_fraction) = result_row(name='adhesion_fraction', unit='-', &
         & long_name='share of the area in adhesion without contact')
      r(periodic_output%elastic_energy) = result_row(name='elastic_energy', unit='J/m^2', &
         & long_name='energy of the elastic solid over nominal area')
      r(periodic_output%adhesion_energy) = result_row(name='adhesion_energy', unit='J/m^2', &
         & long_name='energy of adhesion over nominal area, 0 far apart')
      r(periodic_output%pull_off_pressure) = pull_off_pressure_row()
      r(periodic_output%cells_per_zone) = result_row(name='cells_per_zone', unit='-', &
         & long_name='length of a short zone of adhesion over that of a cell; pi E* w/(4 p0^2) on a half-space')
      r(periodic_output%friction_stress) = result_row(name='friction_stress', unit='Pa', &
         & long_name='friction force over nominal area, of a shear strength, with the sign of the velocity if there is one')
      r(periodic_output%friction_coefficient) = result_row(name='friction_coefficient', unit='-', &
         & long_name='friction stress over mean pressure, where that presses')
      r(periodic_output%friction_force) = result_row(name='friction_force', unit='N', &
         & long_name='friction force on one period, of a shear strength; none for a surface that does not vary along y')
      r(periodic_output%stick_fraction:periodic_output%cycle_energy) = slip_results()
      r([periodic_output%adhesion_fraction, periodic_output%friction_stress, periodic_output%friction_coefficient, &
         & periodic_output%friction_force, periodic_output%stick_fraction])%is_counted = .true.
      r(periodic_output%poisson_defect) = result_row(name='poisson_defect', unit='-', &
         & long_name='uneven displacement by Poisson''s ratio where it sticks: standard deviation over the displacement')
      r(periodic_output%smooth_fraction) = smooth_fraction_row()
      r(periodic_output%smooth_friction) = result_row(name='smooth_friction_stress', unit='Pa', &
         & long_name='friction stress of a shear strength on the area that varies smoothly')
      r(periodic_output%smooth_friction)%has_bends = .true.
      r(periodic_output%velocity_slope:periodic_output%velocity_slope) = last_of_rows(total_friction_results('stress', 'Pa'))
      r(periodic_output%coupling_left_out:periodic_output%coupling_left_out) = last_of_rows(coupling_results())
      r(periodic_output%opening_loss) = result_row(name='opening_loss', unit='J/m^2', &
         & long_name='energy that opening has taken beyond what closing gave, over nominal area')
      r(periodic_output%contact_stiffness) = result_row(name='contact_stiffness', unit='Pa/m', &
         & long_name='slope of the mean pressure over the approach, with &output stiffness; none in full contact with a half-space')
      r(periodic_output%stiffness_error) = stiffness_error_row()
      associate (conductances => periodic_output%conductances)
         r(conductances(1):conductances(n_conduction_results)) = conduction_results(.true.)
         r(periodic_output%contact_stiffness:conductances(n_conduction_results))%is_counted = .true.
      end associate
      associate (stresses => periodic_output%stresses)
         r(stresses(1):stresses(n_stress_results)) = stress_results()
      end associate
      r(periodic_output%impressions(1):) = hardness_results()
   end function get_elastic_results

   !> The last one of some results: of friction as a sum the slope over the velocity, of a coupling what is left out.
   function last_of_rows(rows) result(last)
      type(result_t), intent(in) :: rows(:)
      type(result_t) :: last(1)

      last = rows(size(rows):)
   end function last_of_rows

   !> The row of the area by chords.
   type(result_t) function smooth_fraction_row() result(row)

      row = result_row(name='smooth_contact_fraction', unit='-', &
         & long_name='share of the area in contact from where its edge cuts rows and columns of cells, which varies smoothly')
      row%has_bends = .true.
   end function smooth_fraction_row

   !> The table of results.
   function get_periodic_results() result(r)
      type(result_t), allocatable :: r(:)

      allocate (r(n_periodic_results))
      r(periodic_output%mean_pressure) = result_row(name='mean_pressure', unit='Pa', long_name='load over nominal area', &
         & is_main=.true.)
      r(periodic_output%penetration) = result_row(name='penetration', unit='m', &
         & long_name='approach from first touch, at the mean of the deformed surface', is_main=.true.)
      r(periodic_output%contact_fraction) = result_row(name='contact_fraction', unit='-', &
         & long_name='share of the area in contact', &
         & is_main=.true.)
      r(periodic_output%contact_fraction_error) = result_row(name='contact_fraction_error', unit='-', &
         & long_name='bound of its error, from coarser grids')
      r(periodic_output%contact_fraction:periodic_output%contact_fraction_error)%is_counted = .true.
      r(periodic_output%peak_pressure) = result_row(name='peak_pressure', unit='Pa', long_name='largest pressure', is_main=.true.)
      r(periodic_output%mean_gap) = result_row(name='mean_gap', unit='m', long_name='volume between the surfaces over nominal area')
      r(periodic_output%full_contact_pressure) = result_row(name='full_contact_pressure', unit='Pa', &
         & long_name='p*, where full contact begins')
      r(periodic_output%contact_violation) = result_row(name='contact_violation', unit='-', &
         & long_name='largest violation of g >= 0, p >= 0, g p = 0')
   end function get_periodic_results

end module adfric_periodic_variables
