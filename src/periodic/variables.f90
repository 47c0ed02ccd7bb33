!> Rows of the tables that all models of a periodic surface share: tolerance, then those of the solid, what is held, and the maps.
module adfric_periodic_variables
   use adfric_base_kinds, only: dp
   use adfric_material_contact_modulus, only: n_two_bodies
   use adfric_model_rows, only: number, switch, result_row, any_number
   use adfric_model_table, only: variable_t, result_t
   implicit none (type, external)
   private
   public :: tolerance_row, set_held_rows, get_periodic_results

   !> Places among the rows behind those of the solid.
   integer, parameter, public :: v_mean_pressure = 1, v_penetration = 2, v_profiles = 3
   integer, parameter, public :: n_held = 3
   !> Number of the rows that the models on an elastic half-space share.
   integer, parameter, public :: n_periodic_variables = 1 + n_two_bodies + n_held

   !> Places of the results.
   integer, parameter, public :: r_mean_pressure = 1, r_penetration = 2, r_contact_fraction = 3, r_contact_fraction_error = 4, &
      & r_peak_pressure = 5, r_mean_gap = 6, r_full_contact_pressure = 7, r_contact_violation = 8
   integer, parameter, public :: n_periodic_results = 8

contains

   !> The row of the tolerance.
   type(variable_t) function tolerance_row() result(v)

      v = any_number(group='numerics', name='relative_tolerance', unit='-', &
         & meaning='largest violation of the conditions of contact', default=1.0e-10_dp, lower=1.0e-13_dp, upper=1.0e-3_dp)
   end function tolerance_row

   !> Rows of what is held and of the maps.
   subroutine set_held_rows(v)
      !> Receives the rows; shape `(n_held)`.
      type(variable_t), intent(inout) :: v(:)

      v(v_mean_pressure) = number(group='operating', name='mean_pressure', unit='Pa', meaning='load over nominal area', &
         & lower=0.0_dp)
      v(v_penetration) = number(group='operating', name='penetration', unit='m', &
         & meaning='approach from first touch, at the mean of the deformed surface, instead')
      v(v_profiles) = switch(group='output', name='profiles', meaning='write maps of pressure and gap for every point', &
         & default=.false.)
   end subroutine set_held_rows

   !> The table of results.
   function get_periodic_results() result(r)
      type(result_t), allocatable :: r(:)

      allocate (r(n_periodic_results))
      r(r_mean_pressure) = result_row(name='mean_pressure', unit='Pa', long_name='load over nominal area', is_main=.true.)
      r(r_penetration) = result_row(name='penetration', unit='m', &
         & long_name='approach from first touch, at the mean of the deformed surface', is_main=.true.)
      r(r_contact_fraction) = result_row(name='contact_fraction', unit='-', long_name='share of the area in contact', &
         & is_main=.true.)
      r(r_contact_fraction_error) = result_row(name='contact_fraction_error', unit='-', &
         & long_name='bound of its error, from coarser grids')
      r(r_peak_pressure) = result_row(name='peak_pressure', unit='Pa', long_name='largest pressure', is_main=.true.)
      r(r_mean_gap) = result_row(name='mean_gap', unit='m', long_name='volume between the surfaces over nominal area')
      r(r_full_contact_pressure) = result_row(name='full_contact_pressure', unit='Pa', long_name='p*, where full contact begins')
      r(r_contact_violation) = result_row(name='contact_violation', unit='-', &
         & long_name='largest violation of g >= 0, p >= 0, g p = 0')
   end function get_periodic_results

end module adfric_periodic_variables
