! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `rough_theories`: what statistical theories say of a surface with a power spectral density, pressed on an elastic
!> half-space, sliding over a viscoelastic one, or parting from an adhesive one. The file is long by its answers to `model_t`.
module adfric_rough_model
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: newline
   use adfric_base_unset, only: is_set
   use adfric_describe_derived, only: add_derived, derived_t
   use adfric_describe_doubt, only: doubt_slope_too_steep
   use adfric_describe_model, only: model_t
   use adfric_describe_status, only: status_not_converged, status_solved
   use adfric_describe_table, only: profile_axis_t
   use adfric_interface_adhesion_rows, only: range_of
   use adfric_rough_atlas, only: describe_bands
   use adfric_rough_check, only: adheres, check_rough, relaxes
   use adfric_rough_pressed_theories, only: add_conductances, answer_pressed, new_pressed_theories, pressed_surface_t, &
      & pressed_theories_t, set_areas, set_nodes, set_shares
   use adfric_rough_pull_off, only: find_pull_off, pastewka_robbins, bearing_pull_off_t
   use adfric_rough_rubber_friction, only: get_rubber_friction, rubber_friction_t
   use adfric_rough_variables, only: get_rough_results, get_rough_variables, in => rough_input, n_pressed_results, n_shares, &
      & n_theories, out => rough_output, share_plain
   use adfric_rough_wave_nodes, only: least_for_squares, new_wave_nodes
   use adfric_shape_height_spectrum, only: height_spectrum_t
   use adfric_shape_power_spectrum, only: derive_moments, doubt_density, given_density_t, make_spectrum, n_density_rows
   use adfric_solid_contact_modulus, only: contact_modulus_of, derive_contact_modulus
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_solid_prony, only: prony_t
   use adfric_solid_spectrum_rows, only: derive_spectrum, describe_spectrum, doubt_spectrum, get_spectrum, shift_factor_of, &
      & take_spectrum, take_spectrum_attribute
   implicit none (type, external)
   private
   public :: rough_theories_t, new_rough_theories

   !> Widest panels in ln t of the integrals of sliding surfaces.
   real(dp), parameter :: widest_sliding = 0.35_dp
   !> Relative error of all results, of series and quadratures.
   real(dp), parameter :: error_of_results = 1.0e-9_dp
   !> What `adfric check` says of a body that slides.
   character(*), parameter :: compared = 'theories of sliding were compared for solids with one arm alone: adfric help theories'

   !> The model.
   type, extends(model_t) :: rough_theories_t
      !> Lists and datasets of the solid.
      type(given_spectrum_t) :: given
      !> Table of the power spectrum.
      type(given_density_t) :: density
      !> What all points share, while a run lasts; else not allocated.
      type(pressed_theories_t), allocatable :: shared
   contains
      procedure :: check_values
      procedure :: wants_profiles
      procedure :: get_profile_axes
      procedure :: solve_block
      procedure :: solve_profiles
      procedure :: prepare
      procedure :: release
      procedure :: take_dataset
      procedure :: take_attribute
      procedure :: derive_quantities
      procedure :: describe_case
      procedure :: describe_doubts
      procedure :: measure
   end type rough_theories_t

   !> What a point leaves for the next one.
   type, extends(pressed_surface_t) :: surface_state_t
      !> Values of the spectrum and of Yang and Persson's constant; not allocated before the first point.
      real(dp), allocatable :: values(:)
      !> Logarithm of the least slope of the nodes of sliding over the last one; 0: there are none.
      real(dp) :: least = 0
      !> Do the values make a spectrum?
      logical :: is_possible = .false.
   end type surface_state_t

contains

   !> The model with its tables.
   subroutine new_rough_theories(self)
      !> Receives its names and its tables.
      type(rough_theories_t), intent(out) :: self

      self%name = 'rough_theories'
      self%summary = 'statistical theories of a surface with a power spectral density: area, gap, stiffness, pull-off, friction'
      self%references = 'B. N. J. Persson, Phys. Rev. Lett. 99 (2007) 125502; C. Yang, B. N. J. Persson, J. Phys.: Condens. '// &
         & 'Matter 20 (2008) 215214; J. A. Greenwood, J. B. P. Williamson, Proc. R. Soc. A 295 (1966) 300; A. W. Bush, '// &
         & 'R. D. Gibson, T. R. Thomas, Wear 35 (1975) 87'
      self%variables = get_rough_variables()
      self%results = get_rough_results()
      allocate (self%profiles(0), self%counts(0))
      self%profile_axes = ''
   end subroutine new_rough_theories

   !> See `model_t`.
   subroutine check_values(self, values, is_swept, problems)
      class(rough_theories_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      logical, intent(in) :: is_swept(:)
      type(problems_t), intent(inout) :: problems

      call check_rough(self%variables, values, is_swept, self%given, self%density, problems)
   end subroutine check_values

   !> See `model_t`: there are none.
   pure logical function wants_profiles(self, values)
      class(rough_theories_t), intent(in) :: self
      real(dp), intent(in) :: values(:)

      wants_profiles = .false.
      associate (unused => self, unused_too => values)
      end associate
   end function wants_profiles

   !> See `model_t`: there are none.
   subroutine get_profile_axes(self, values, axes)
      class(rough_theories_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(profile_axis_t), allocatable, intent(out) :: axes(:)

      allocate (axes(0))
      associate (unused => self, unused_too => values)
      end associate
   end subroutine get_profile_axes

   !> See `model_t`: there are none.
   subroutine solve_profiles(self, values, results, profiles)
      class(rough_theories_t), intent(in) :: self
      real(dp), intent(in) :: values(:), results(:)
      !> Space of no size.
      real(dp), intent(out) :: profiles(:, :, :)

      profiles = not_a_number()
      associate (unused => self, unused_values => values, unused_results => results)
      end associate
   end subroutine solve_profiles

   !> See `model_t`: the series are found once.
   subroutine prepare(self)
      class(rough_theories_t), intent(inout) :: self

      if (allocated(self%shared)) return
      allocate (self%shared)
      call new_pressed_theories(self%shared)
   end subroutine prepare

   !> See `model_t`.
   subroutine release(self)
      class(rough_theories_t), intent(inout) :: self

      if (allocated(self%shared)) deallocate (self%shared)
   end subroutine release

   !> See `model_t`.
   subroutine take_dataset(self, index, values, problems)
      class(rough_theories_t), intent(inout) :: self
      integer, intent(in) :: index
      real(dp), intent(in) :: values(:, :)
      type(problems_t), intent(inout) :: problems

      if (index <= n_density_rows) then
         call self%density%take(index, values)
      else
         call take_spectrum(self%given, index - in%material(1) + 1, values)
      end if
      associate (unused => problems)
      end associate
   end subroutine take_dataset

   !> See `model_t`: the temperature of a master curve.
   subroutine take_attribute(self, index, name, value, problems)
      class(rough_theories_t), intent(inout) :: self
      integer, intent(in) :: index
      character(*), intent(in) :: name
      real(dp), intent(in) :: value
      type(problems_t), intent(inout) :: problems

      call take_spectrum_attribute(self%given, self%variables(index), index - in%material(1) + 1, name, value, problems)
   end subroutine take_attribute

   !> See `model_t`: moments of the spectrum.
   function derive_quantities(self, values) result(list)
      class(rough_theories_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: list(:)
      type(height_spectrum_t) :: spectrum
      logical :: is_possible

      if (relaxes(values)) then
         allocate (list(0))
         call derive_spectrum(list, values(in%material(1):in%temperature), self%given)
      else
         list = derive_contact_modulus(self%variables(in%contact_modulus:in%second_poisson_ratio), &
            & values(in%contact_modulus:in%second_poisson_ratio))
      end if
      call make_spectrum(values(:n_density_rows), self%density, spectrum, is_possible)
      if (.not. is_possible) return
      call derive_moments(list, spectrum)
      if (.not. relaxes(values)) call add_derived(list, 'full_contact_energy', 'J/m^2', &
         & 'elastic energy of an area in full contact', elastic_modulus(values)*spectrum%moment(1)/4)
   end function derive_quantities

   !> Contact modulus of an elastic solid [Pa].
   pure real(dp) function elastic_modulus(values) result(modulus)
      real(dp), intent(in) :: values(:)

      modulus = contact_modulus_of(values(in%contact_modulus:in%second_poisson_ratio))
   end function elastic_modulus

   !> See `model_t`: where the theories have been compared with the exact answer.
   function describe_case(self, values) result(text)
      class(rough_theories_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text
      type(height_spectrum_t) :: spectrum
      logical :: is_possible

      text = ''
      if (relaxes(values)) then
         text = describe_spectrum(values(in%material(1):in%temperature), self%given)//compared//newline
         return
      end if
      if (adheres(values)) return
      call make_spectrum(values(:n_density_rows), self%density, spectrum, is_possible)
      if (is_possible) text = describe_bands(spectrum, values(in%mean_pressure)/elastic_modulus(values) &
         & /spectrum%root_mean_square_slope(), values(in%yang_persson_constant))
   end function describe_case

   !> See `model_t`: a map that has no end or is not isotropic, and frequencies beyond those of the solid.
   function describe_doubts(self, values) result(text)
      class(rough_theories_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text
      type(height_spectrum_t) :: spectrum
      logical :: is_possible

      text = doubt_density(values(:n_density_rows), self%density)
      if (.not. relaxes(values)) return
      call make_spectrum(values(:n_density_rows), self%density, spectrum, is_possible)
      if (is_possible) text = text//doubt_spectrum(values(in%material(1):in%temperature), self%given, &
         & abs(values(in%velocity))*[spectrum%q(0), spectrum%q(size(spectrum%power))])
   end function describe_doubts

   !> See `model_t`: the slope of all waves.
   subroutine measure(self, values, results, measures)
      class(rough_theories_t), intent(in) :: self
      !> Values of the variables, in the order of the table; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the point, NaN where they are not known; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> In: all `not_measured`. Out: with what is measured; shape `(n_doubts)`.
      real(dp), intent(inout) :: measures(:)
      type(height_spectrum_t) :: spectrum
      logical :: is_possible

      call make_spectrum(values(:n_density_rows), self%density, spectrum, is_possible)
      if (is_possible) measures(doubt_slope_too_steep) = spectrum%root_mean_square_slope()
      associate (unused => results)
      end associate
   end subroutine measure

   !> See `model_t`.
   subroutine solve_block(self, values, results, error_estimate, status, counts)
      class(rough_theories_t), intent(in) :: self
      real(dp), intent(in), contiguous :: values(:, :)
      real(dp), intent(out) :: results(:, :), error_estimate(:)
      integer, intent(out) :: status(:)
      real(dp), intent(out) :: counts(:)
      type(pressed_theories_t), allocatable :: own

      counts = 0
      if (allocated(self%shared)) then
         call solve_points(self, self%shared, values, results, error_estimate, status)
      else
         allocate (own)
         call new_pressed_theories(own)
         call solve_points(self, own, values, results, error_estimate, status)
      end if
   end subroutine solve_block

   !> Solve the points of a block.
   subroutine solve_points(self, shared, values, results, error_estimate, status)
      class(rough_theories_t), intent(in) :: self
      type(pressed_theories_t), intent(in) :: shared
      real(dp), intent(in) :: values(:, :)
      real(dp), intent(out) :: results(:, :), error_estimate(:)
      integer, intent(out) :: status(:)
      logical, parameter :: all_theories(n_theories) = .true.
      type(surface_state_t) :: surface
      integer :: i
      logical :: is_converged

      results = not_a_number()
      error_estimate = not_a_number()
      status = status_not_converged
      do i = 1, size(status)
         call set_surface(self, values(:, i), surface)
         if (.not. surface%is_possible) cycle
         if (relaxes(values(:, i))) then
            call solve_sliding(self, surface, values(:, i), results(:, i), is_converged)
         else if (adheres(values(:, i))) then
            call solve_pull_off(shared, surface, values(:, i), results(:, i), is_converged)
         else
            call answer_pressed(shared, surface, elastic_modulus(values(:, i)), values(in%mean_pressure, i), all_theories, &
               & results(:n_pressed_results, i), is_converged)
            if (is_converged) call add_conductances(values(in%conduction, i), results(:n_pressed_results, i))
         end if
         if (.not. is_converged) then
            results(:, i) = not_a_number()
            cycle
         end if
         error_estimate(i) = error_of_results
         status(i) = status_solved
      end do
   end subroutine solve_points

   !> Have the spectrum of a point, unless the point before had the same.
   subroutine set_surface(self, values, surface)
      class(rough_theories_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(surface_state_t), intent(inout) :: surface
      real(dp) :: of_spectrum(in%map_length_y + 2)

      of_spectrum(:in%map_length_y) = values(:in%map_length_y)
      of_spectrum(in%map_length_y + 1) = values(in%yang_persson_constant)
      of_spectrum(in%map_length_y + 2) = merge(1, 0, relaxes(values))
      if (allocated(surface%values)) then
         if (all(abs(of_spectrum - surface%values) <= 0)) return
      end if
      surface%values = of_spectrum
      call make_spectrum(values(:n_density_rows), self%density, surface%spectrum, surface%is_possible)
      if (.not. surface%is_possible) return
      call set_shares(surface, values(in%yang_persson_constant))
      surface%least = 0
      if (relaxes(values)) return
      call set_nodes(surface)
      if (.not. adheres(values)) call set_areas(surface)
   end subroutine set_surface

   !> The pull-off of a surface.
   subroutine solve_pull_off(shared, surface, values, results, is_converged)
      type(pressed_theories_t), intent(in) :: shared
      type(surface_state_t), intent(in) :: surface
      real(dp), intent(in) :: values(:)
      !> In: all NaN. Out: results of the point.
      real(dp), intent(inout) :: results(:)
      logical, intent(out) :: is_converged
      type(bearing_pull_off_t) :: pull_off
      real(dp) :: modulus, unit, range, work
      integer :: k

      modulus = elastic_modulus(values)
      unit = modulus*surface%nodes%slope
      range = range_of(values(in%adhesion))
      work = values(in%adhesion(1))/modulus*range
      is_converged = .true.
      do k = 2, n_shares
         call find_pull_off(surface%spectrum, surface%nodes, shared%functions, surface%shares(k), values(in%adhesion(1))/unit, &
            & range, pull_off)
         is_converged = is_converged .and. pull_off%is_converged
         results(out%pull_off_pressure(k)) = unit*pull_off%pressure
         if (pull_off%has_tension) results(out%pull_off_gap(k)) = pull_off%gap
      end do
      results(out%pastewka_robbins) = pastewka_robbins(surface%spectrum, work, range)
      results(out%full_contact_work_ratio) = 4*work/surface%spectrum%moment(1)
      is_converged = is_converged .and. all(ieee_is_finite(results([out%pull_off_pressure, out%pastewka_robbins, &
         & out%full_contact_work_ratio])))
   end subroutine solve_pull_off

   !> The friction of a surface that slides.
   subroutine solve_sliding(self, surface, values, results, is_converged)
      class(rough_theories_t), intent(in) :: self
      !> Out: with the nodes of the pressure.
      type(surface_state_t), intent(inout) :: surface
      real(dp), intent(in) :: values(:)
      !> In: all NaN. Out: results of the point.
      real(dp), intent(inout) :: results(:)
      logical, intent(out) :: is_converged
      type(prony_t) :: prony
      type(rubber_friction_t) :: friction
      real(dp) :: direction, least

      direction = merge(-1, 1, values(in%velocity) < 0)
      call get_spectrum(values(in%material(1):in%temperature), self%given, prony)
      ! slopes count up to the one at which contact is full, also of the solid at its hardest
      least = least_for_squares + floor(min(0.0_dp, log(values(in%mean_pressure)/(prony%relaxed + sum(prony%moduli)) &
         & /surface%spectrum%root_mean_square_slope())))
      if (abs(least - surface%least) > 0) then
         call new_wave_nodes(surface%nodes, surface%spectrum, widest_sliding, least)
         surface%least = least
      end if
      ! all times are those of the temperature, or the speed over their factor
      call get_rubber_friction(surface%nodes, prony, values(in%mean_pressure), abs(values(in%velocity)) &
         & *shift_factor_of(values(in%material(1):in%temperature), self%given), surface%shares, friction)
      is_converged = friction%is_finite
      if (.not. is_converged) return
      results(out%contact_fraction(share_plain)) = friction%contact_fraction
      results(out%friction_coefficient) = direction*friction%coefficients
      results(out%full_contact_friction_coefficient) = direction*friction%full_contact
   end subroutine solve_sliding

end module adfric_rough_model
