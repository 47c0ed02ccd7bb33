! SPDX-License-Identifier: GPL-3.0-or-later
!> Rows of the model `rough_theories`.
module adfric_rough_variables
   use adfric_base_counting, only: counting
   use adfric_base_kinds, only: dp
   use adfric_describe_rows, only: any_number, number, positive, result_row
   use adfric_describe_table, only: result_t, variable_t
   use adfric_interface_adhesion_rows, only: n_stress_rows, set_stress_rows
   use adfric_rough_summits, only: n_summit_theories
   use adfric_interface_conduction_rows, only: n_conduction_rows, set_conduction_rows
   use adfric_solid_contact_modulus, only: set_modulus_rows
   use adfric_shape_power_spectrum, only: set_density_rows
   use adfric_solid_spectrum_rows, only: n_spectrum_rows, set_spectrum_rows
   implicit none (type, external)
   private
   public :: get_rough_variables, get_rough_results, constant_row, theory_of_result
   public :: suffixes, meanings, n_shares, n_theories, share_plain, share_yang_persson, share_wang_mueser

   !> Forms of Persson's theory.
   integer, parameter :: share_plain = 1, share_yang_persson = 2, share_wang_mueser = 3, n_shares = 3
   integer, parameter :: n_theories = n_shares + n_summit_theories
   !> Names of the theories in results, and what they are.
   character(*), parameter :: suffixes(n_theories) = [character(20) :: 'persson', 'yang_persson', 'wang_mueser', &
      & 'greenwood_williamson', 'bush_gibson_thomas', 'greenwood_elliptic', 'nayak_sphere']
   character(*), parameter :: meanings(n_theories) = [character(64) :: 'Persson''s theory', &
      & 'Persson''s theory, energy of Yang and Persson', 'Persson''s theory, energy of Wang and Mueser', &
      & 'Greenwood and Williamson''s theory', 'Bush, Gibson and Thomas''s theory', &
      & 'Greenwood''s theory of elliptic summits', 'Nayak''s summits as spheres']

   !> Variables in the order of their rows; a component is the index of its row.
   type :: rough_input_t
      !> Indices of the rows.
      integer :: hurst_exponent = 0, shortest_wavelength = 0, rolloff_wavelength = 0, longest_wavelength = 0, &
         & root_mean_square_height = 0, root_mean_square_slope = 0, plateau_density = 0, wave_numbers = 0, densities = 0, &
         & convention = 0, heights = 0, map_length_x = 0, map_length_y = 0, contact_modulus = 0, young_modulus = 0, &
         & poisson_ratio = 0, second_young_modulus = 0, second_poisson_ratio = 0, material(n_spectrum_rows - 1) = 0, &
         & temperature = 0, velocity = 0, mean_pressure = 0, adhesion(n_stress_rows) = 0, yang_persson_constant = 0, &
         & conduction(n_conduction_rows) = 0
   end type rough_input_t
   type(rough_input_t), parameter, public :: rough_input = transfer(counting, rough_input_t())
   integer, parameter, public :: n_rough_variables = storage_size(rough_input)/storage_size(1)

   !> Results in the order of their rows; a component is the index of its row, or those of its rows, one for each theory.
   type :: rough_output_t
      !> Indices of the rows.
      integer :: contact_fraction(n_theories) = 0, mean_gap(n_theories) = 0, normal_stiffness(n_theories) = 0, &
         & conductance_factor(n_theories) = 0, elastic_energy(n_shares) = 0, mean_square_pressure = 0, &
         & electrical_conductance(n_theories) = 0, thermal_conductance(n_theories) = 0, &
         & pull_off_pressure(2:n_shares) = 0, pull_off_gap(2:n_shares) = 0, pastewka_robbins = 0, full_contact_work_ratio = 0, &
         & friction_coefficient(n_shares) = 0, full_contact_friction_coefficient = 0
   end type rough_output_t
   type(rough_output_t), parameter, public :: rough_output = transfer(counting, rough_output_t())
   integer, parameter, public :: n_rough_results = storage_size(rough_output)/storage_size(1)
   !> Number of the first ones, which a surface under a pressure has.
   integer, parameter, public :: n_pressed_results = rough_output%thermal_conductance(n_theories)

contains

   !> The variables.
   function get_rough_variables() result(v)
      type(variable_t), allocatable :: v(:)

      allocate (v(n_rough_variables))
      associate (in => rough_input)
         call set_density_rows(v(in%hurst_exponent:in%map_length_y))
         call set_modulus_rows(positive(group='solid', name='contact_modulus', unit='Pa', meaning=''), &
            & v(in%contact_modulus:in%second_poisson_ratio))
         call set_spectrum_rows(v(in%material(1):in%temperature))
         v(in%material(1):in%temperature - 1)%has_bare_name = .not. is_of_solid(v(in%material(1):in%temperature - 1))
         v(in%velocity) = number(group='operating', name='velocity', unit='m/s', &
            & meaning='sliding velocity over a solid that relaxes')
         v(in%mean_pressure) = number(group='operating', name='mean_pressure', unit='Pa', &
            & meaning='load over the nominal area, > 0', lower=0.0_dp)
         call set_stress_rows(v(in%adhesion(1):in%adhesion(n_stress_rows)))
         v(in%yang_persson_constant) = constant_row()
         call set_conduction_rows(v(in%conduction(1):))
      end associate
   end function get_rough_variables

   !> The row of Yang and Persson's constant.
   function constant_row() result(row)
      type(variable_t) :: row

      row = any_number(group='estimates', name='yang_persson_constant', unit='-', &
         & meaning='gamma of the energy gamma A + (1 - gamma) A^3 of waves in a part A of the area', default=0.45_dp, &
         & lower=0.1_dp, upper=1.0_dp)
   end function constant_row

   !> Has the group `solid` a variable of the same name?
   elemental logical function is_of_solid(variable)
      type(variable_t), intent(in) :: variable

      is_of_solid = variable%name == 'young_modulus' .or. variable%name == 'poisson_ratio'
   end function is_of_solid

   !> The results.
   function get_rough_results() result(r)
      type(result_t), allocatable :: r(:)
      integer :: k

      allocate (r(n_rough_results))
      associate (out => rough_output)
         do k = 1, n_theories
            r(out%contact_fraction(k)) = of_theory('contact_fraction', '-', 'area of contact over the nominal area', k)
            r(out%mean_gap(k)) = of_theory('mean_gap', 'm', 'mean gap', k)
            r(out%normal_stiffness(k)) = of_theory('normal_stiffness', 'Pa/m', &
               & 'slope of the mean pressure over the mean gap, K = -dp/du', k)
            r(out%conductance_factor(k)) = of_theory('conductance_factor', '1/m', &
               & 'K over modulus: conductance of an area over 2 k1 k2/(k1 + k2), k conductivities', k)
         end do
         do k = 1, n_theories
            r(out%electrical_conductance(k)) = of_theory('electrical_conductance', 'S/m^2', &
               & 'current over nominal area and voltage', k)
            r(out%thermal_conductance(k)) = of_theory('thermal_conductance', 'W/m^2/K', &
               & 'heat over nominal area and difference of temperature', k)
         end do
         do k = 1, n_shares
            r(out%elastic_energy(k)) = of_theory('elastic_energy', 'J/m^2', 'elastic energy of an area', k)
            r(out%friction_coefficient(k)) = of_theory('friction_coefficient', '-', &
               & 'hysteretic friction over load, with the sign of the velocity', k)
         end do
         do k = 2, n_shares
            r(out%pull_off_pressure(k)) = of_theory('pull_off_pressure', 'Pa', &
               & 'least mean pressure of the bearing-area model, below 0; 0 where no tension is found', k)
            r(out%pull_off_gap(k)) = of_theory('pull_off_gap', 'm', 'mean gap there; no value without tension', k)
         end do
         r(out%mean_square_pressure) = of_theory('mean_square_pressure', 'Pa^2', 'mean square of the pressure', share_plain)
         r(out%pastewka_robbins) = result_row(name='pastewka_robbins_ratio', unit='-', &
            & long_name='left side of Pastewka and Robbins''s condition, which is that it is below 1', is_main=.true.)
         r(out%full_contact_work_ratio) = result_row(name='full_contact_work_ratio', unit='-', &
            & long_name='work of adhesion over the elastic energy of full contact', is_main=.true.)
         r(out%full_contact_friction_coefficient) = result_row(name='full_contact_friction_coefficient', unit='-', &
            & long_name='hysteretic friction over load if contact were full, with the sign of the velocity')
         ! the theories of the table at the end of a run
         r(out%contact_fraction(share_wang_mueser))%is_main = .true.
         r(out%contact_fraction(share_plain))%is_main = .true.
         r(out%mean_gap(share_wang_mueser))%is_main = .true.
         r(out%normal_stiffness(share_wang_mueser))%is_main = .true.
         r(out%friction_coefficient(share_yang_persson))%is_main = .true.
         r(out%pull_off_pressure(share_yang_persson))%is_main = .true.
      end associate
   end function get_rough_results

   !> Number of the theory that a result of a surface under a pressure is of.
   elemental integer function theory_of_result(row) result(theory)
      !> Index of the result, from 1 to `n_pressed_results`.
      integer, intent(in) :: row

      associate (out => rough_output)
         theory = max(findloc(out%contact_fraction, row, 1), findloc(out%mean_gap, row, 1), &
            & findloc(out%normal_stiffness, row, 1), findloc(out%conductance_factor, row, 1), findloc(out%elastic_energy, row, 1), &
            & findloc(out%electrical_conductance, row, 1), findloc(out%thermal_conductance, row, 1))
         if (row == out%mean_square_pressure) theory = share_plain
      end associate
   end function theory_of_result

   !> A row of a result by a theory.
   function of_theory(name, unit, long_name, k) result(row)
      character(*), intent(in) :: name, unit, long_name
      !> Number of the theory.
      integer, intent(in) :: k
      type(result_t) :: row

      row = result_row(name=name//'_'//trim(suffixes(k)), unit=unit, long_name=long_name//' ('//trim(meanings(k))//')')
   end function of_theory

end module adfric_rough_variables
