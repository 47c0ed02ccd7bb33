! SPDX-License-Identifier: GPL-3.0-or-later
!> The namelist variables and results of the model `surface_sliding`, beside those that all models of a periodic surface share.
module adfric_periodic_sliding_variables
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_base_unset, only: unset
   use adfric_interface_attraction, only: law_words
   use adfric_interface_attraction_rows, only: law_row, n_attraction_rows, table_row
   use adfric_interface_friction_law_rows, only: n_interface_rows, set_law_rows
   use adfric_interface_shear_coupling, only: coupling_results, coupling_row
   use adfric_interface_heat_rows, only: heat_results, n_heat_results, n_heat_rows, set_heat_rows
   use adfric_interface_shear_strength_rows, only: n_shear_rows, set_shear_rows
   use adfric_interface_total_friction, only: total_friction_results
   use adfric_solid_spectrum_rows, only: set_spectrum_rows, n_spectrum_rows
   use adfric_describe_rows, only: above_zero, any_number, choice, number, poisson_ratio, positive, result_row, switch, whole_number
   use adfric_describe_table, only: variable_t, result_t
   use adfric_interface_adhesion_rows, only: branches_differ_row, n_adhesion_rows, set_adhesion_rows
   use adfric_periodic_given_heights, only: set_heights_rows, n_heights_rows
   use adfric_periodic_variables, only: get_periodic_results, n_periodic_results, pull_off_pressure_row, pull_off_row, &
      & smooth_fraction_row, periodic_output
   implicit none (type, external)
   private
   public :: attraction_values, set_surface_rows, set_solid_rows, get_sliding_results, cells_of

   !> Variables in the order of their rows; a component is the index of its row.
   type :: sliding_input_t
      !> Indices of the rows.
      integer :: kind = 0, period = 0, amplitude = 0, heights = 0, length_x = 0, length_y = 0, rms_height = 0, direction = 0, &
         & cells = 0
   end type sliding_input_t
   type(sliding_input_t), parameter, public :: sliding_input = transfer(counting, sliding_input_t())
   integer, parameter, public :: n_surface_rows = storage_size(sliding_input)/storage_size(1)
   !> Kinds of surfaces, in the order of the choice.
   integer, parameter, public :: kind_wave_1d = 1, kind_wave_2d = 2, kind_heights = 3

   !> Indices among the rows of the solid: those of the spectrum, the last of which is the temperature, then those of the layer, the
   !> velocity, and the first one of the interface.
   integer, parameter, public :: s_thickness = n_spectrum_rows + 1, s_base = n_spectrum_rows + 2, &
      & s_poisson_ratio = n_spectrum_rows + 3, s_velocity = n_spectrum_rows + 4, &
      & s_temperature = n_spectrum_rows, s_friction = n_spectrum_rows + 5
   !> Indices of the last row of the interface, of the first and last one of adhesion, of its law and the table of that, of the switches of
   !> the pull-off and of the other branch, of the coupling, of the first and last row of heat, and number of all.
   integer, parameter, public :: s_last_friction = s_friction + n_interface_rows - 1, s_adhesion = s_last_friction + 1, &
      & s_last_adhesion = s_last_friction + n_adhesion_rows, s_law = s_last_adhesion + 1, s_tension_table = s_law + 1, &
      & s_pull_off = s_tension_table + 1, s_other_branch = s_pull_off + 1, &
      & s_coupling = s_other_branch + 1, s_heat = s_coupling + 1, s_last_heat = s_coupling + n_heat_rows
   integer, parameter, public :: n_solid_rows = s_last_heat
   !> Bases of the layer, in the order of the choice.
   integer, parameter, public :: base_frictionless = 1, base_bonded = 2

   !> Results in the order of their rows; a component is the index of its row.
   type :: sliding_output_t
      !> Indices of the rows.
      integer :: friction_stress = 0, friction_coefficient = 0, lateral_stress = 0, full_contact_friction = 0, &
         & contact_shift = 0, dissipation = 0, energy_imbalance = 0, regime = 0, smooth_fraction = 0, &
         & hysteretic_friction_stress = 0, interfacial_friction_stress = 0, interfacial_share = 0, velocity_slope = 0, &
         & adhesion_fraction = 0, cells_per_zone = 0, friction_without_adhesion = 0, &
         & adhesive_friction_stress = 0, order_margin = 0, pull_off_pressure = 0, branches_differ = 0, &
         & largest_coupling = 0, smallest_stiffness_ratio = 0, coupling_left_out = 0, heat(n_heat_results) = 0
   end type sliding_output_t
   type(sliding_output_t), parameter, public :: sliding_output = transfer(counting(n_periodic_results + 1:), sliding_output_t())
   integer, parameter, public :: n_sliding_results = n_periodic_results + storage_size(sliding_output)/storage_size(1)

   !> Cells along a period of a wave where none are given.
   integer, parameter :: default_cells_1d = 1024, default_cells_2d = 256
   !> Cells of waves come in multiples of this, so that there are three nested grids.
   integer, parameter :: multiple_of_cells = 32

contains

   !> Rows of the surface, the direction of its motion, and the cells.
   subroutine set_surface_rows(v)
      !> Receives the rows; shape `(n_surface_rows)`.
      type(variable_t), intent(inout) :: v(:)

      v(sliding_input%kind) = choice(group='surface', name='kind', &
         & meaning='a wave along x (wave_1d), waves along x and y (wave_2d), or given heights', choices='wave_1d wave_2d heights')
      v(sliding_input%period) = positive(group='surface', name='period', unit='m', meaning='period l of waves')
      v(sliding_input%amplitude) = positive(group='surface', name='amplitude', unit='m', &
         & meaning='D of the wave z = D (1 - cos 2 pi x/l), or z = D (2 - cos 2 pi x/l - cos 2 pi y/l)')
      call set_heights_rows(v(sliding_input%heights:sliding_input%heights + n_heights_rows - 1))
      v(sliding_input%direction) = any_number(group='surface', name='direction', unit='degrees', &
         & meaning='direction to which the body slides, 0 along +x, 90 along +y; a multiple of 90, of 45 for waves', &
         & default=0.0_dp, lower=0.0_dp, upper=315.0_dp)
      v(sliding_input%cells) = whole_number(group='numerics', name='cells', &
         & meaning='cells along a period of a wave; 1024 for wave_1d and 256 for wave_2d if not given', &
         & default=default_cells_1d, lower=32, upper=65536, multiple_of=multiple_of_cells)
      v(sliding_input%cells)%default = unset
   end subroutine set_surface_rows

   !> Rows of the material, the layer, the velocity, the interface, adhesion and heat.
   subroutine set_solid_rows(v)
      !> Receives the rows; shape `(n_solid_rows)`.
      type(variable_t), intent(inout) :: v(:)

      call set_spectrum_rows(v(:n_spectrum_rows))
      v(s_thickness) = above_zero(group='layer', name='thickness', unit='m', &
         & meaning='thickness of a layer on a rigid base; without it the solid is a half-space')
      v(s_base) = choice(group='layer', name='base', meaning='whether the layer slips on its base (frictionless) or not (bonded)', &
         & choices='frictionless bonded')
      v(s_poisson_ratio) = poisson_ratio(group='layer', name='poisson_ratio', &
         & meaning='Poisson''s ratio nu of a bonded layer, where &material does not have it')
      v(s_poisson_ratio)%has_bare_name = .false.
      v(s_velocity) = number(group='operating', name='velocity', unit='m/s', meaning='sliding velocity', lower=0.0_dp)
      call set_shear_rows(v(s_friction:s_friction + n_shear_rows - 1))
      call set_law_rows(v(s_friction + n_shear_rows:s_last_friction))
      call set_adhesion_rows(v(s_adhesion:s_last_adhesion))
      v(s_law) = law_row(law_words)
      v(s_tension_table) = table_row()
      v(s_pull_off) = pull_off_row()
      v(s_other_branch) = switch(group='output', name='compare_branches', &
         & meaning='solve the other branch too, and say whether it has another state', default=.false.)
      v(s_coupling) = coupling_row()
      call set_heat_rows(v(s_heat:s_last_heat))
   end subroutine set_solid_rows

   !> Values of the rows of adhesion and of its law, as all models of periodic surfaces have them: those that sliding does not have are unset.
   pure function attraction_values(values) result(attraction)
      !> Values of the rows of the solid; shape `(n_solid_rows)`.
      real(dp), intent(in) :: values(:)
      real(dp) :: attraction(n_adhesion_rows + n_attraction_rows)

      attraction = unset
      attraction(:n_adhesion_rows + 2) = values(s_adhesion:s_tension_table)
   end function attraction_values

   !> Cells along a period of a wave.
   pure integer function cells_of(values) result(n)
      !> Values of the rows of the surface; shape `(n_surface_rows)` or longer.
      real(dp), intent(in) :: values(:)

      n = merge(default_cells_1d, default_cells_2d, nint(values(sliding_input%kind)) == kind_wave_1d)
      if (values(sliding_input%cells) < unset) n = nint(values(sliding_input%cells))
   end function cells_of

   !> The table of results.
   function get_sliding_results() result(r)
      type(result_t), allocatable :: r(:)

      allocate (r(n_sliding_results))
      r(:n_periodic_results) = get_periodic_results()
      r(periodic_output%penetration)%long_name = &
         & 'approach from first touch, at the mean of the deformed surface, or at the base of a layer'
      r(sliding_output%friction_stress) = result_row(name='friction_stress', unit='Pa', long_name='friction over nominal area', &
         & is_main=.true.)
      r(sliding_output%friction_coefficient) = result_row(name='friction_coefficient', unit='-', long_name='friction over load', &
         & is_main=.true.)
      r(sliding_output%lateral_stress) = result_row(name='lateral_stress', unit='Pa', &
         & long_name='stress across the motion that keeps the body on its path, positive to the left')
      r(sliding_output%full_contact_friction) = result_row(name='full_contact_friction', unit='Pa', &
         & long_name='friction over nominal area in full contact at this velocity, of heights on their cells')
      r(sliding_output%contact_shift) = result_row(name='contact_shift', unit='m', &
         & long_name='shift of the contact of a wave from the crest towards the leading side; none along diagonals')
      r(sliding_output%dissipation) = result_row(name='dissipation', unit='Pa', &
         & long_name='energy lost in the solid per nominal area and distance slid')
      r(sliding_output%energy_imbalance) = result_row(name='energy_imbalance', unit='-', &
         & long_name='friction from the pressure on the slopes less the energy lost, over the larger of them')
      r(sliding_output%regime) = result_row(name='regime', unit='-', long_name='regime', &
         & flag_meanings='no_contact partial full adhesion_without_contact adhesion_zones saturated_adhesion')
      r(sliding_output%smooth_fraction) = smooth_fraction_row()
      r(sliding_output%hysteretic_friction_stress:sliding_output%velocity_slope) = total_friction_results('stress', 'Pa')
      r([sliding_output%interfacial_friction_stress, sliding_output%interfacial_share])%is_counted = .true.
      r(sliding_output%adhesion_fraction) = result_row(name='adhesion_fraction', unit='-', &
         & long_name='share of the area in adhesion without contact')
      r(sliding_output%adhesion_fraction)%is_counted = .true.
      r(sliding_output%cells_per_zone) = result_row(name='cells_per_zone', unit='-', &
         & long_name='length pi E0 w/(4 p0^2) of a short zone of adhesion on the relaxed solid over that of a cell')
      r(sliding_output%friction_without_adhesion) = result_row(name='friction_stress_without_adhesion', unit='Pa', &
         & long_name='friction over nominal area of the same load and velocity without adhesion')
      r(sliding_output%adhesive_friction_stress) = result_row(name='adhesive_friction_stress', unit='Pa', &
         & long_name='friction stress less that without adhesion')
      r(sliding_output%order_margin) = result_row(name='order_margin', unit='-', &
         & long_name='least value of the kernel of memory over its largest; where >= 0, branches bound all states on a half-plane')
      r(sliding_output%pull_off_pressure) = pull_off_pressure_row()
      r(sliding_output%branches_differ) = branches_differ_row()
      r(sliding_output%largest_coupling:sliding_output%coupling_left_out) = coupling_results()
      r(sliding_output%heat(1):) = heat_results('W/m^2')
   end function get_sliding_results

end module adfric_periodic_sliding_variables
