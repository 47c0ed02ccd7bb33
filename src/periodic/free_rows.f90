! SPDX-License-Identifier: GPL-3.0-or-later
!> Rows of the tables of `free_surface`: a body of given heights that ends at the border of its map.
module adfric_periodic_free_rows
   use adfric_base_counting, only: counting
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: unset
   use adfric_interface_adhesion_rows, only: n_adhesion_rows, set_adhesion_rows
   use adfric_interface_attraction, only: law_words
   use adfric_interface_attraction_rows, only: law_row, n_attraction_rows, table_row
   use adfric_interface_conduction_rows, only: conduction_results, n_conduction_results, n_conduction_rows, set_conduction_rows
   use adfric_describe_rows, only: any_number, choice, number, positive, result_row, switch
   use adfric_describe_table, only: result_t, variable_t
   use adfric_periodic_given_heights, only: n_heights_rows, set_heights_rows
   use adfric_periodic_variables, only: pull_off_row, stiffness_error_row, stiffness_row
   use adfric_solid_contact_modulus, only: n_two_bodies, set_modulus_rows
   implicit none (type, external)
   private
   public :: attraction_values, get_free_variables, get_free_results, is_periodic_by

   !> Words of `boundaries`, and the number of the first one: what is periodic in both directions has another solver.
   character(*), parameter :: known_boundaries = 'periodic free periodic_x periodic_y'
   integer, parameter, public :: boundaries_periodic = 1
   !> Number of the second word of `tilt`.
   integer, parameter, public :: tilt_free = 2

   !> Variables in the order of their rows; a component is the index of its row, those of the modulus begin at `modulus`,
   !> those of adhesion at `adhesion`, with the law behind them.
   type :: free_input_t
      !> Indices of the rows.
      integer :: heights = 0, length_x = 0, length_y = 0, rms_height = 0, tolerance = 0, modulus = 0, &
         & others(n_two_bodies - 1) = 0, boundaries = 0, adhesion = 0, of_adhesion(n_adhesion_rows - 1) = 0, law = 0, &
         & tension_table = 0, load = 0, approach = 0, tilt = 0, load_x = 0, load_y = 0, pull_off = 0, profiles = 0, &
         & conduction(n_conduction_rows) = 0, stiffness = 0
   end type free_input_t
   type(free_input_t), parameter, public :: free_input = transfer(counting, free_input_t())
   integer, parameter, public :: n_free_variables = storage_size(free_input)/storage_size(1)

   !> Results in the order of their rows; a component is the index of its row.
   type :: free_output_t
      !> Indices of the rows.
      integer :: load = 0, approach = 0, contact_area = 0, contact_area_error = 0, smooth_area = 0, mean_contact_pressure = 0, &
         & peak_pressure = 0, elastic_energy = 0, moment_x = 0, moment_y = 0, violation = 0, adhesion_area = 0, &
         & adhesion_energy = 0, pull_off_load = 0, cells_per_zone = 0, tilt_x = 0, tilt_y = 0, contact_stiffness = 0, &
         & stiffness_error = 0, conductances(n_conduction_results) = 0
   end type free_output_t
   type(free_output_t), parameter, public :: free_output = transfer(counting, free_output_t())
   integer, parameter, public :: n_free_results = storage_size(free_output)/storage_size(1)

contains

   !> The table of variables.
   function get_free_variables() result(v)
      type(variable_t), allocatable :: v(:)

      allocate (v(n_free_variables))
      call set_heights_rows(v(:n_heights_rows))
      v(free_input%length_x)%meaning = 'length of the map along x, along which the heights vary fastest'
      v(free_input%length_y)%meaning = 'length of the map along y'
      v(free_input%heights)%may_lack_values = .true.
      v(free_input%tolerance) = any_number(group='numerics', name='contact_tolerance', unit='-', &
         & meaning='largest violation of the conditions of contact', default=1.0e-7_dp, lower=1.0e-11_dp, upper=1.0e-3_dp)
      call set_modulus_rows(positive(group='solid', name='contact_modulus', unit='Pa', meaning=''), &
         & v(free_input%modulus:free_input%modulus + n_two_bodies - 1))
      v(free_input%boundaries) = choice(group='solid', name='boundaries', choices=known_boundaries, &
         & meaning='how given heights go on beyond their map: periodically, along x or y alone, or not at all (free)', &
         & default='free')
      call set_adhesion_rows(v(free_input%adhesion:free_input%adhesion + n_adhesion_rows - 1))
      v(free_input%adhesion + n_adhesion_rows - 1) = any_number(group='adhesion', name='turning_load', unit='N', &
         & meaning='load up to which the body has approached before it parts again, of the adhered branch; full contact if not ' &
         & //'given', lower=0.0_dp)
      v(free_input%law) = law_row(law_words)
      v(free_input%tension_table) = table_row()
      v(free_input%load) = number(group='operating', name='load', unit='N', &
         & meaning='load, or that of one period; below 0 with adhesion alone')
      v(free_input%approach) = number(group='operating', name='approach', unit='m', &
         & meaning='approach of the body from first touch of the undisturbed surface, instead')
      v(free_input%tilt) = choice(group='operating', name='tilt', choices='fixed free', &
         & meaning='does the body keep its direction (fixed), or turn until its load has no moment (free)', default='fixed')
      v(free_input%load_x) = number(group='operating', name='load_x', unit='m', &
         & meaning='point of the load along x on the map, of a body that may tilt; the middle if not given')
      v(free_input%load_y) = number(group='operating', name='load_y', unit='m', &
         & meaning='point of the load along y on the map, of a body that may tilt; the middle if not given')
      v(free_input%pull_off) = pull_off_row()
      v(free_input%profiles) = switch(group='output', name='profiles', &
         & meaning='write maps of pressure and gap for every point', default=.false.)
      call set_conduction_rows(v(free_input%conduction(1):free_input%conduction(n_conduction_rows)))
      v(free_input%stiffness) = stiffness_row()
   end function get_free_variables

   !> Values of the rows of adhesion and of its law, as those of all rows of attraction.
   pure function attraction_values(values) result(attraction)
      !> Values of all variables.
      real(dp), intent(in) :: values(:)
      real(dp) :: attraction(n_adhesion_rows + n_attraction_rows)

      attraction = unset
      attraction(:n_adhesion_rows + 2) = values(free_input%adhesion:free_input%tension_table)
   end function attraction_values

   !> Does the surface go on periodically along x, along y?
   pure function is_periodic_by(boundaries) result(is_periodic)
      !> Value of the variable `boundaries`, the number of its word.
      real(dp), intent(in) :: boundaries
      logical :: is_periodic(2)

      is_periodic = [nint(boundaries) == boundaries_periodic + 2, nint(boundaries) == boundaries_periodic + 3]
   end function is_periodic_by

   !> The table of results.
   function get_free_results() result(r)
      type(result_t), allocatable :: r(:)

      allocate (r(n_free_results))
      r(free_output%load) = result_row(name='load', unit='N', long_name='load, or that of one period', is_main=.true.)
      r(free_output%approach) = result_row(name='approach', unit='m', is_main=.true., &
         & long_name='approach from first touch of the undisturbed surface, of a body that tilts at its load; of a period from ' &
         & //'where a line load has no displacement')
      r(free_output%contact_area) = result_row(name='contact_area', unit='m^2', long_name='area of contact', is_main=.true.)
      r(free_output%contact_area_error) = result_row(name='contact_area_error', unit='m^2', &
         & long_name='bound of its error, from coarser grids')
      r(free_output%contact_area:free_output%contact_area_error)%is_counted = .true.
      r(free_output%smooth_area) = result_row(name='smooth_contact_area', unit='m^2', &
         & long_name='area of contact from where its edge cuts rows and columns of cells, which varies smoothly')
      r(free_output%smooth_area)%has_bends = .true.
      r(free_output%mean_contact_pressure) = result_row(name='mean_contact_pressure', unit='Pa', &
         & long_name='load over area of contact')
      r(free_output%mean_contact_pressure)%is_counted = .true.
      r(free_output%peak_pressure) = result_row(name='peak_pressure', unit='Pa', &
         & long_name='largest pressure of a cell; at sharp edges it grows with the number of cells')
      r(free_output%elastic_energy) = result_row(name='elastic_energy', unit='J', long_name='energy of the elastic solid')
      r(free_output%moment_x) = result_row(name='moment_x', unit='N m', &
         & long_name='moment of the pressure about the x axis through the middle of the map, sum of (y - length_y/2) p')
      r(free_output%moment_y) = result_row(name='moment_y', unit='N m', &
         & long_name='moment of the pressure about the y axis through the middle of the map, -sum of (x - length_x/2) p')
      r(free_output%violation) = result_row(name='contact_violation', unit='-', &
         & long_name='largest violation of g >= 0, p >= 0, g p = 0; with adhesion p + p0 t for p, t its share of a cell')
      r(free_output%adhesion_area) = result_row(name='adhesion_area', unit='m^2', &
         & long_name='area within the range of Dugdale''s law and not in contact')
      r(free_output%adhesion_area)%is_counted = .true.
      r(free_output%adhesion_energy) = result_row(name='adhesion_energy', unit='J', &
         & long_name='energy of adhesion, 0 far apart')
      r(free_output%pull_off_load) = result_row(name='pull_off_load', unit='N', &
         & long_name='least load of the adhered branch, with &output pull_off', is_main=.true.)
      r(free_output%cells_per_zone) = result_row(name='cells_per_zone', unit='-', &
         & long_name='length pi E* w/(4 p0^2) of a short zone of adhesion over that of a cell')
      r(free_output%tilt_x) = result_row(name='tilt_x', unit='-', &
         & long_name='slope by which the body has turned down along x, of one that may tilt')
      r(free_output%tilt_y) = result_row(name='tilt_y', unit='-', &
         & long_name='slope by which the body has turned down along y, of one that may tilt')
      r(free_output%contact_stiffness) = result_row(name='contact_stiffness', unit='N/m', &
         & long_name='slope of the load over the approach, with &output stiffness')
      r(free_output%stiffness_error) = stiffness_error_row()
      r(free_output%conductances(1):) = conduction_results(.false.)
      r(free_output%contact_stiffness:)%is_counted = .true.
   end function get_free_results

end module adfric_periodic_free_rows
