! SPDX-License-Identifier: GPL-3.0-or-later
!> The rows of a power spectrum that an input gives, self-affine, as a table or by a map of heights, what they may not say, and
!> the spectrum of their values. The models that read `&power_spectrum` share them.
module adfric_shape_power_spectrum
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_constants, only: pi
   use adfric_base_counting, only: counting
   use adfric_base_error, only: error_t
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: newline, show_number
   use adfric_base_unset, only: is_set
   use adfric_describe_check, only: checks_t, new_checks
   use adfric_describe_derived, only: add_derived, derived_t
   use adfric_describe_rows, only: any_number, choice, dataset, list_row, positive
   use adfric_describe_table, only: variable_t
   use adfric_shape_height_spectrum, only: convention_words, height_spectrum_t, in_this_convention, new_self_affine, new_tabulated
   use adfric_shape_measured_spectrum, only: map_waves_t, new_map_waves, new_measured, slope_ratio
   use adfric_shape_period_seam, only: seam_of, seam_t
   implicit none (type, external)
   private
   public :: set_density_rows, check_density, make_spectrum, derive_moments, doubt_density, given_density_t

   !> Rows of the spectrum; a component is the position of its row.
   type :: density_input_t
      !> Positions of the rows.
      integer :: hurst_exponent = 0, shortest_wavelength = 0, rolloff_wavelength = 0, longest_wavelength = 0, &
         & root_mean_square_height = 0, root_mean_square_slope = 0, plateau_density = 0, wave_numbers = 0, densities = 0, &
         & convention = 0, heights = 0, map_length_x = 0, map_length_y = 0
   end type density_input_t
   type(density_input_t), parameter :: at = transfer(counting, density_input_t())
   integer, parameter, public :: n_density_rows = storage_size(at)/storage_size(1)

   !> Names of the variables that say the spectrum, separated by a blank.
   character(*), parameter :: spectrum_sources = 'hurst_exponent shortest_wavelength rolloff_wavelength longest_wavelength '// &
      & 'root_mean_square_height root_mean_square_slope plateau_density wave_numbers densities convention '// &
      & 'heights map_length_x map_length_y'

   !> Cells of a map in each direction at least, so that it can hold a wave.
   integer, parameter :: fewest_cells = 4
   !> Mean square slope along one direction over that along the other from which on a surface is not isotropic.
   real(dp), parameter :: unlike = 1.5_dp
   !> The same from which on there is but one direction.
   real(dp), parameter :: alone = 1.0e6_dp

   !> A table of a spectrum, or a map of heights, as the input gives it.
   type :: given_density_t
      !> Wave numbers, and densities in their convention; not allocated: none are given.
      real(dp), allocatable :: wave_numbers(:), densities(:)
      !> Numbers of heights of a map along x and y; 0: there is none.
      integer :: n_heights(2) = 0
      !> Is each height a number? And was there memory for their transform?
      logical :: is_whole = .true., has_memory = .true.
      !> Waves of the map.
      type(map_waves_t) :: waves
      !> Its spectrum where it has square cells and the length 1 in x.
      type(height_spectrum_t) :: of_squares
      !> Steps across the ends of its periods along x and y.
      type(seam_t) :: seams(2)
   contains
      procedure :: take
   end type given_density_t

contains

   !> The rows.
   subroutine set_density_rows(rows)
      !> Receives the rows; shape `(n_density_rows)`.
      type(variable_t), intent(inout) :: rows(:)
      character(*), parameter :: group = 'power_spectrum'

      rows(at%hurst_exponent) = any_number(group=group, name='hurst_exponent', unit='-', &
         & meaning='H: the density falls as q^(-2-2H) beyond the roll-off', lower=0.0_dp, upper=1.0_dp)
      rows(at%shortest_wavelength) = positive(group=group, name='shortest_wavelength', unit='m', &
         & meaning='wavelength 2 pi/q of the shortest wave')
      rows(at%rolloff_wavelength) = positive(group=group, name='rolloff_wavelength', unit='m', &
         & meaning='wavelength above which the density is constant; the longest one if not given')
      rows(at%longest_wavelength) = positive(group=group, name='longest_wavelength', unit='m', &
         & meaning='wavelength of the longest wave; that of the roll-off if not given')
      rows(at%root_mean_square_height) = positive(group=group, name='root_mean_square_height', unit='m', &
         & meaning='root mean square of the heights h')
      rows(at%root_mean_square_slope) = positive(group=group, name='root_mean_square_slope', unit='-', &
         & meaning='root mean square of the gradient g, instead of the height')
      rows(at%plateau_density) = any_number(group=group, name='plateau_density', unit='m^4', &
         & meaning='C at the roll-off, h^2 = int C d^2q, instead of the height', lower=0.0_dp)
      rows(at%plateau_density)%lower_open = .true.
      rows(at%wave_numbers) = list_row(group=group, name='wave_numbers', unit='1/m', &
         & meaning='wave numbers of a table, rising, in rad/m, or in cycles per length', most_count=100000, &
         & least_count=2, lower=0.0_dp, lower_open=.true.)
      rows(at%densities) = list_row(group=group, name='densities', unit='m^4', &
         & meaning='densities at wave_numbers, in the convention', most_count=100000, least_count=2, lower=0.0_dp, &
         & lower_open=.true.)
      rows(at%convention) = choice(group=group, name='convention', &
         & meaning='h^2 = int C d^2q (variance), int C d^2q/(2 pi)^2 (transform), or int C d^2f, q = 2 pi f (cycles)', &
         & choices=convention_words)
      rows(at%heights) = dataset(group=group, name='heights', unit='m', &
         & meaning='heights (ny, nx) of a map that fills a period, whose spectrum is taken', largest_rank=2, &
         & least_count=fewest_cells)
      rows(at%map_length_x) = positive(group=group, name='map_length_x', unit='m', &
         & meaning='length of the map in x, along which the heights vary fastest')
      rows(at%map_length_y) = positive(group=group, name='map_length_y', unit='m', &
         & meaning='length of the map in y; its cells are squares if not given')
   end subroutine set_density_rows

   !> Keep a list or the waves of a map of the input.
   subroutine take(self, row, values)
      class(given_density_t), intent(inout) :: self
      !> Position of its row; others than those of lists and maps are left.
      integer, intent(in) :: row
      !> Its values; shape `(n, 1)`, of a map `(nx, ny)`.
      real(dp), intent(in) :: values(:, :)
      type(error_t), allocatable :: error
      integer :: k

      if (row == at%wave_numbers) self%wave_numbers = values(:, 1)
      if (row == at%densities) self%densities = values(:, 1)
      if (row /= at%heights) return
      self%n_heights = shape(values)
      self%is_whole = all(ieee_is_finite(values))
      if (.not. self%is_whole .or. size(values, 2) < fewest_cells) return
      self%seams(:) = [(seam_of(values, k), k=1, 2)]
      call new_map_waves(self%waves, values, error)
      self%has_memory = .not. allocated(error)
      if (allocated(self%waves%squares)) call new_measured(self%of_squares, self%waves, [1.0_dp, real(self%n_heights(2), dp) &
         & /self%n_heights(1)])
   end subroutine take

   !> Add to `problems` what is missing or impossible.
   subroutine check_density(rows, values, is_swept, given, problems)
      !> The rows, for their names.
      type(variable_t), intent(in), target :: rows(:)
      !> Their values; shape `(n_density_rows)`.
      real(dp), intent(in), target :: values(:)
      !> Is the variable swept? Shape `(n_density_rows)`.
      logical, intent(in), target :: is_swept(:)
      !> Table of the input.
      type(given_density_t), intent(in) :: given
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout), target :: problems
      type(checks_t) :: c
      type(height_spectrum_t) :: spectrum
      logical :: is_possible
      integer :: before

      before = problems%count()
      call new_checks(c, rows, values, problems, is_swept)
      if (c%has_any([at%heights, at%map_length_x, at%map_length_y])) then
         call check_map(c, given)
         if (.not. c%has(at%heights)) return
      else if (c%has_any([at%wave_numbers, at%densities])) then
         call check_table(c, given)
      else
         call check_self_affine(c, values)
      end if
      if (problems%count() > before) return
      call make_spectrum(values, given, spectrum, is_possible)
      if (is_possible) return
      if (c%has(at%heights)) then
         call c%add(at%heights, 'leads to moments above 1e120 or below 1e-120')
      else if (c%has(at%densities)) then
         call c%add(at%densities, 'leads to moments above 1e120 or below 1e-120, or waves of lengths above 1e12 times the shortest')
      else
         call c%add(at%shortest_wavelength, 'leads to moments above 1e120 or below 1e-120, or is below 1e-12 of the longest')
      end if
   end subroutine check_density

   !> A self-affine spectrum.
   subroutine check_self_affine(c, values)
      type(checks_t), intent(in) :: c
      real(dp), intent(in) :: values(:)

      call c%need([at%hurst_exponent, at%shortest_wavelength])
      call c%add(at%longest_wavelength, 'is missing [m]; or give rolloff_wavelength', &
         & .not. c%has_any([at%longest_wavelength, at%rolloff_wavelength]))
      call c%need_one([at%root_mean_square_height, at%root_mean_square_slope, at%plateau_density], .true.)
      call c%refuse([at%convention], 'is one of a table; wavelengths and plateau_density need none')
      if (.not. c%has(at%shortest_wavelength) .or. .not. c%has_any([at%longest_wavelength, at%rolloff_wavelength])) return
      if (is_rising(values)) return
      call c%add(at%shortest_wavelength, 'is not below rolloff_wavelength and longest_wavelength in this order, given '// &
         & show_number(values(at%shortest_wavelength))//' [m]')
   end subroutine check_self_affine

   !> A table of a spectrum.
   subroutine check_table(c, density)
      type(checks_t), intent(in) :: c
      type(given_density_t), intent(in) :: density
      integer :: n

      call c%need([at%wave_numbers, at%densities, at%convention])
      call c%refuse([at%hurst_exponent, at%shortest_wavelength, at%rolloff_wavelength, at%longest_wavelength, &
         & at%root_mean_square_height, at%root_mean_square_slope, at%plateau_density], 'stands beside a table of densities')
      if (.not. (allocated(density%wave_numbers) .and. allocated(density%densities))) return
      n = size(density%wave_numbers)
      call c%add(at%densities, 'has another number of values than wave_numbers', size(density%densities) /= n)
      call c%add(at%wave_numbers, 'does not rise from value to value', &
         & any(.not. density%wave_numbers(2:) > density%wave_numbers(:n - 1)*(1 + 1.0e-12_dp)))
   end subroutine check_table

   !> A map of heights.
   subroutine check_map(c, given)
      type(checks_t), intent(in) :: c
      type(given_density_t), intent(in) :: given

      if (.not. c%has(at%heights)) then
         ! heights that cannot be read have been told
         if (c%problems%count() > 0) return
         call c%refuse([at%map_length_x, at%map_length_y], 'is the length of a map; give its heights')
         return
      end if
      call c%need([at%map_length_x])
      call c%refuse([at%hurst_exponent, at%shortest_wavelength, at%rolloff_wavelength, at%longest_wavelength, &
         & at%root_mean_square_height, at%root_mean_square_slope, at%plateau_density, at%wave_numbers, at%densities, &
         & at%convention], 'stands beside the heights of a map, which say the spectrum')
      if (.not. given%n_heights(1) > 0) return
      if (given%n_heights(2) < fewest_cells) then
         call c%add(at%heights, 'is a line, or a map of fewer than 4 cells along y; theories need a map')
      else if (.not. given%is_whole) then
         call c%add(at%heights, 'has cells without a height; a spectrum needs all of them')
      else if (.not. given%has_memory) then
         call c%add(at%heights, 'is too large for its transform: no memory')
      else if (.not. given%waves%scale > 0) then
         call c%add(at%heights, 'is the same everywhere')
      end if
   end subroutine check_map

   !> Lengths of a map along x and y.
   pure function lengths_of(values, given) result(lengths)
      real(dp), intent(in) :: values(:)
      type(given_density_t), intent(in) :: given
      real(dp) :: lengths(2)

      lengths = values(at%map_length_x)
      lengths(2) = lengths(1)*(real(given%n_heights(2), dp)/given%n_heights(1))
      if (is_set(values(at%map_length_y))) lengths(2) = values(at%map_length_y)
   end function lengths_of

   !> Lines for a map that does not fill a period, or is not isotropic.
   function doubt_density(values, given) result(text)
      !> Values of the rows; shape `(n_density_rows)`.
      real(dp), intent(in) :: values(:)
      !> Table or map of the input.
      type(given_density_t), intent(in) :: given
      character(:), allocatable :: text
      character(*), parameter :: axes = 'xy'
      real(dp) :: ratio
      integer :: k

      text = ''
      if (.not. is_set(values(at%heights)) .or. .not. allocated(given%waves%squares)) return
      do k = 1, 2
         if (given%seams(k)%is_open()) text = text//'the map of heights does not meet itself along '//axes(k:k)// &
            & ': if it is a part of a larger surface, a table by adfric import_surface has the right spectrum'//newline
      end do
      ratio = slope_ratio(given%waves, lengths_of(values, given))
      if (.not. max(ratio, 1/ratio) > unlike) return
      if (max(ratio, 1/ratio) > alone) then
         text = text//'the slopes of the map along one direction are more than 1000 times those along the other'
      else
         text = text//'the slopes of the map along x and y differ by a factor of '// &
            & show_number(anint(10*sqrt(max(ratio, 1/ratio)))/10)
      end if
      text = text//'; the spectrum is that of an isotropic surface'//newline
   end function doubt_density

   !> Do wavelengths that are set make a spectrum?
   pure logical function is_rising(values)
      !> Values of the rows; shape `(n_density_rows)`.
      real(dp), intent(in) :: values(:)
      real(dp) :: waves(3)

      waves = wavelengths_of(values)
      is_rising = waves(1) < waves(3) .and. waves(1) <= waves(2) .and. waves(2) <= waves(3)
   end function is_rising

   !> Shortest wavelength, that of the roll-off, and the longest one; of the last two one may be left out.
   pure function wavelengths_of(values) result(waves)
      real(dp), intent(in) :: values(:)
      real(dp) :: waves(3)

      waves = values([at%shortest_wavelength, at%rolloff_wavelength, at%longest_wavelength])
      if (.not. is_set(waves(2))) waves(2) = waves(3)
      if (.not. is_set(waves(3))) waves(3) = waves(2)
   end function wavelengths_of

   !> The spectrum of values that have been checked.
   pure subroutine make_spectrum(values, given, spectrum, is_possible)
      !> Values of the rows; shape `(n_density_rows)`.
      real(dp), intent(in) :: values(:)
      !> Table of the input.
      type(given_density_t), intent(in) :: given
      !> Receives the spectrum.
      type(height_spectrum_t), intent(out) :: spectrum
      !> Do the wavelengths rise, and are the moments within the numbers?
      logical, intent(out) :: is_possible
      real(dp), parameter :: most = 1.0e120_dp, farthest = 1.0e30_dp, widest = 1.0e12_dp
      real(dp) :: waves(3), lengths(2), factor
      real(dp), allocatable :: q(:), density(:)

      is_possible = .false.
      if (is_set(values(at%heights))) then
         if (.not. allocated(given%waves%squares)) return
         lengths = lengths_of(values, given)
         if (.not. all(lengths > 1/farthest .and. lengths < farthest)) return
         if (.not. (given%waves%scale > 1/farthest .and. given%waves%scale < farthest)) return
         if (is_set(values(at%map_length_y))) then
            call new_measured(spectrum, given%waves, lengths)
         else
            spectrum = given%of_squares
            call spectrum%stretch(values(at%map_length_x))
         end if
      else if (is_set(values(at%wave_numbers))) then
         allocate (q(size(given%wave_numbers)), density(size(given%wave_numbers)))
         associate (first => given%wave_numbers(1), last => given%wave_numbers(size(q)))
            if (.not. (first > 1/farthest .and. last < farthest .and. last < widest*first)) return
         end associate
         if (.not. (minval(given%densities) > 1/most .and. maxval(given%densities) < most)) return
         call in_this_convention(nint(values(at%convention)), given%wave_numbers, given%densities, q, density)
         call new_tabulated(spectrum, q, density)
      else
         if (.not. is_rising(values)) return
         waves = wavelengths_of(values)
         if (.not. waves(3) < widest*waves(1)) return
         call new_self_affine(spectrum, values(at%hurst_exponent), 2*pi/waves(3), 2*pi/waves(2), 2*pi/waves(1))
         if (is_set(values(at%root_mean_square_height))) then
            factor = (values(at%root_mean_square_height)/spectrum%root_mean_square_height())**2
         else if (is_set(values(at%root_mean_square_slope))) then
            factor = (values(at%root_mean_square_slope)/spectrum%root_mean_square_slope())**2
         else
            factor = values(at%plateau_density)*(2*pi/waves(2))**4
         end if
         if (.not. (factor > 1/most .and. factor < most)) return
         call spectrum%scale_by(factor)
      end if
      is_possible = spectrum%moment(0) > 1/most .and. spectrum%moment(0) < most .and. spectrum%moment(2) > 1/most &
         & .and. spectrum%moment(2) < most .and. spectrum%moment(4) > 1/most .and. spectrum%moment(4) < most
   end subroutine make_spectrum

   !> Add moments of a spectrum to what follows from the input.
   subroutine derive_moments(list, spectrum)
      !> Receives the moments behind what it has.
      type(derived_t), allocatable, intent(inout) :: list(:)
      !> The spectrum.
      type(height_spectrum_t), intent(in) :: spectrum

      call add_derived(list, 'root_mean_square_height', 'm', 'root mean square of the heights', &
         & spectrum%root_mean_square_height(), spectrum_sources)
      call add_derived(list, 'root_mean_square_slope', '-', 'root mean square of the gradient', &
         & spectrum%root_mean_square_slope(), spectrum_sources)
      call add_derived(list, 'root_mean_square_curvature', '1/m', 'root mean square of half the Laplacian', &
         & spectrum%root_mean_square_curvature(), spectrum_sources)
      call add_derived(list, 'nayak_parameter', '-', 'm0 m4/m2^2 of the moments along a line', spectrum%nayak_parameter(), &
         & spectrum_sources)
   end subroutine derive_moments

end module adfric_shape_power_spectrum
