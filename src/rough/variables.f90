! SPDX-License-Identifier: GPL-3.0-or-later
!> Rows of the model `rough_theories`, and the spectrum of its values.
module adfric_rough_variables
   use adfric_base_constants, only: pi
   use adfric_base_counting, only: counting
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_describe_rows, only: any_number, choice, list_row, number, positive, result_row
   use adfric_describe_table, only: result_t, variable_t
   use adfric_interface_adhesion_rows, only: n_stress_rows, set_stress_rows
   use adfric_rough_height_spectrum, only: convention_words, height_spectrum_t, in_this_convention, new_self_affine, new_tabulated
   use adfric_rough_summits, only: n_summit_theories
   use adfric_solid_contact_modulus, only: set_modulus_rows
   use adfric_solid_spectrum_rows, only: n_spectrum_rows, set_spectrum_rows
   implicit none (type, external)
   private
   public :: get_rough_variables, get_rough_results, given_density_t, make_spectrum, is_rising, spectrum_sources
   public :: suffixes, n_shares, share_plain, share_yang_persson, share_wang_mueser

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
         & convention = 0, contact_modulus = 0, young_modulus = 0, poisson_ratio = 0, second_young_modulus = 0, &
         & second_poisson_ratio = 0, material(n_spectrum_rows - 1) = 0, temperature = 0, velocity = 0, mean_pressure = 0, &
         & adhesion(n_stress_rows) = 0, yang_persson_constant = 0
   end type rough_input_t
   type(rough_input_t), parameter, public :: rough_input = transfer(counting, rough_input_t())
   integer, parameter, public :: n_rough_variables = storage_size(rough_input)/storage_size(1)

   !> Results in the order of their rows; a component is the index of its row, or those of its rows, one for each theory.
   type :: rough_output_t
      !> Indices of the rows.
      integer :: contact_fraction(n_theories) = 0, mean_gap(n_theories) = 0, normal_stiffness(n_theories) = 0, &
         & conductance_factor(n_theories) = 0, elastic_energy(n_shares) = 0, mean_square_pressure = 0, &
         & pull_off_pressure(2:n_shares) = 0, pull_off_gap(2:n_shares) = 0, pastewka_robbins = 0, full_contact_work_ratio = 0, &
         & friction_coefficient(n_shares) = 0, full_contact_friction_coefficient = 0
   end type rough_output_t
   type(rough_output_t), parameter, public :: rough_output = transfer(counting, rough_output_t())
   integer, parameter, public :: n_rough_results = storage_size(rough_output)/storage_size(1)

   !> Names of the variables that say the spectrum, separated by a blank.
   character(*), parameter :: spectrum_sources = 'hurst_exponent shortest_wavelength rolloff_wavelength longest_wavelength '// &
      & 'root_mean_square_height root_mean_square_slope plateau_density wave_numbers densities convention'

   !> A table of a spectrum as the input gives it.
   type :: given_density_t
      !> Wave numbers, and densities in their convention; not allocated: none are given.
      real(dp), allocatable :: wave_numbers(:), densities(:)
   end type given_density_t

contains

   !> The variables.
   function get_rough_variables() result(v)
      type(variable_t), allocatable :: v(:)
      character(*), parameter :: group = 'power_spectrum'

      allocate (v(n_rough_variables))
      associate (in => rough_input)
         v(in%hurst_exponent) = any_number(group=group, name='hurst_exponent', unit='-', &
            & meaning='H: the density falls as q^(-2-2H) beyond the roll-off', lower=0.0_dp, upper=1.0_dp)
         v(in%shortest_wavelength) = positive(group=group, name='shortest_wavelength', unit='m', &
            & meaning='wavelength 2 pi/q of the shortest wave')
         v(in%rolloff_wavelength) = positive(group=group, name='rolloff_wavelength', unit='m', &
            & meaning='wavelength above which the density is constant; the longest one if not given')
         v(in%longest_wavelength) = positive(group=group, name='longest_wavelength', unit='m', &
            & meaning='wavelength of the longest wave; that of the roll-off if not given')
         v(in%root_mean_square_height) = positive(group=group, name='root_mean_square_height', unit='m', &
            & meaning='root mean square of the heights h')
         v(in%root_mean_square_slope) = positive(group=group, name='root_mean_square_slope', unit='-', &
            & meaning='root mean square of the gradient g, instead of the height')
         v(in%plateau_density) = any_number(group=group, name='plateau_density', unit='m^4', &
            & meaning='C at the roll-off, h^2 = int C d^2q, instead of the height', lower=0.0_dp)
         v(in%plateau_density)%lower_open = .true.
         v(in%wave_numbers) = list_row(group=group, name='wave_numbers', unit='1/m', &
            & meaning='wave numbers of a table, rising, in rad/m, or in cycles per length', most_count=100000, &
            & least_count=2, lower=0.0_dp, lower_open=.true.)
         v(in%densities) = list_row(group=group, name='densities', unit='m^4', &
            & meaning='densities at wave_numbers, in the convention', most_count=100000, least_count=2, lower=0.0_dp, &
            & lower_open=.true.)
         v(in%convention) = choice(group=group, name='convention', &
            & meaning='h^2 = int C d^2q (variance), int C d^2q/(2 pi)^2 (transform), or int C d^2f, q = 2 pi f (cycles)', &
            & choices=convention_words)
         call set_modulus_rows(positive(group='solid', name='contact_modulus', unit='Pa', meaning=''), &
            & v(in%contact_modulus:in%second_poisson_ratio))
         call set_spectrum_rows(v(in%material(1):in%temperature))
         v(in%material(1):in%temperature - 1)%has_bare_name = .not. is_of_solid(v(in%material(1):in%temperature - 1))
         v(in%velocity) = number(group='operating', name='velocity', unit='m/s', &
            & meaning='sliding velocity over a solid that relaxes')
         v(in%mean_pressure) = number(group='operating', name='mean_pressure', unit='Pa', &
            & meaning='load over the nominal area, > 0', lower=0.0_dp)
         call set_stress_rows(v(in%adhesion(1):in%adhesion(n_stress_rows)))
         v(in%yang_persson_constant) = any_number(group='estimates', name='yang_persson_constant', unit='-', &
            & meaning='gamma of the energy gamma A + (1 - gamma) A^3 of waves in a part A of the area', default=0.45_dp, &
            & lower=0.1_dp, upper=1.0_dp)
      end associate
   end function get_rough_variables

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

   !> A row of a result by a theory.
   function of_theory(name, unit, long_name, k) result(row)
      character(*), intent(in) :: name, unit, long_name
      !> Number of the theory.
      integer, intent(in) :: k
      type(result_t) :: row

      row = result_row(name=name//'_'//trim(suffixes(k)), unit=unit, long_name=long_name//' ('//trim(meanings(k))//')')
   end function of_theory

   !> Do wavelengths that are set make a spectrum?
   pure logical function is_rising(values)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      real(dp) :: waves(3)

      waves = wavelengths_of(values)
      is_rising = waves(1) < waves(3) .and. waves(1) <= waves(2) .and. waves(2) <= waves(3)
   end function is_rising

   !> Shortest wavelength, that of the roll-off, and the longest one; of the last two one may be left out.
   pure function wavelengths_of(values) result(waves)
      real(dp), intent(in) :: values(:)
      real(dp) :: waves(3)

      waves = values([rough_input%shortest_wavelength, rough_input%rolloff_wavelength, rough_input%longest_wavelength])
      if (.not. is_set(waves(2))) waves(2) = waves(3)
      if (.not. is_set(waves(3))) waves(3) = waves(2)
   end function wavelengths_of

   !> The spectrum of values that have been checked.
   pure subroutine make_spectrum(values, given, spectrum, is_possible)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Table of the input.
      type(given_density_t), intent(in) :: given
      !> Receives the spectrum.
      type(height_spectrum_t), intent(out) :: spectrum
      !> Do the wavelengths rise, and are the moments within the numbers?
      logical, intent(out) :: is_possible
      real(dp), parameter :: most = 1.0e120_dp, farthest = 1.0e30_dp, widest = 1.0e12_dp
      real(dp) :: waves(3), factor
      real(dp), allocatable :: q(:), density(:)

      is_possible = .false.
      if (is_set(values(rough_input%wave_numbers))) then
         allocate (q(size(given%wave_numbers)), density(size(given%wave_numbers)))
         associate (first => given%wave_numbers(1), last => given%wave_numbers(size(q)))
            if (.not. (first > 1/farthest .and. last < farthest .and. last < widest*first)) return
         end associate
         if (.not. (minval(given%densities) > 1/most .and. maxval(given%densities) < most)) return
         call in_this_convention(nint(values(rough_input%convention)), given%wave_numbers, given%densities, q, density)
         call new_tabulated(spectrum, q, density)
      else
         if (.not. is_rising(values)) return
         waves = wavelengths_of(values)
         if (.not. waves(3) < widest*waves(1)) return
         call new_self_affine(spectrum, values(rough_input%hurst_exponent), 2*pi/waves(3), 2*pi/waves(2), 2*pi/waves(1))
         if (is_set(values(rough_input%root_mean_square_height))) then
            factor = (values(rough_input%root_mean_square_height)/spectrum%root_mean_square_height())**2
         else if (is_set(values(rough_input%root_mean_square_slope))) then
            factor = (values(rough_input%root_mean_square_slope)/spectrum%root_mean_square_slope())**2
         else
            factor = values(rough_input%plateau_density)*(2*pi/waves(2))**4
         end if
         if (.not. (factor > 1/most .and. factor < most)) return
         call spectrum%scale_by(factor)
      end if
      is_possible = spectrum%moment(0) > 1/most .and. spectrum%moment(0) < most .and. spectrum%moment(2) > 1/most &
         & .and. spectrum%moment(2) < most .and. spectrum%moment(4) > 1/most .and. spectrum%moment(4) < most
   end subroutine make_spectrum

end module adfric_rough_variables
