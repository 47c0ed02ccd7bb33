! SPDX-License-Identifier: GPL-3.0-or-later
!> What `adfric check` says of heights and spectra, and of what the user may not mean.
module adfric_foundation_stepped_description
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi, two_pi
   use adfric_base_error, only: error_t
   use adfric_base_unset, only: is_set
   use adfric_solid_given_spectrum, only: describe_arms, describe_fit, doubt_range
   use adfric_solid_master_curve, only: master_curve_fit_t
   use adfric_solid_prony, only: prony_t, instantaneous_modulus
   use adfric_describe_derived, only: derived_t, add_derived
   use adfric_foundation_adhesion, only: edge_front
   use adfric_foundation_case, only: kind_cosines
   use adfric_foundation_given_surface, only: given_surface_t
   use adfric_foundation_stepping_relief, only: relief_t
   use adfric_foundation_stepped_case, only: stepped_case_t, get_relief, get_spectrum, resolve_stepped, has_heights, spacing_of
   use adfric_foundation_variables, only: in => foundation_input
   implicit none (type, external)
   private
   public :: describe_stepped, doubt_stepped, derive_stepped

   !> Positions of the words in the choice of how ends meet.
   integer, parameter :: periodise_none = 1

contains

   !> Spectrum and heights, a line each.
   function describe_stepped(values, given) result(text)
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      character(:), allocatable :: text
      type(prony_t) :: prony
      type(master_curve_fit_t) :: fit
      character(200) :: line
      real(dp) :: frequencies(2)

      call get_spectrum(values, given, prony, fit)
      text = ''
      if (is_set(values(in%master_curve))) text = describe_fit(given, fit)
      text = text//describe_arms(prony, 'stiffness', 'Pa/m')
      frequencies = get_frequencies(values, given)
      write (line, '(a, es9.2, a, es9.2, a)') 'the surface excites', frequencies(1), ' to', frequencies(2), ' rad/s'
      text = text//trim(line)//new_line('a')
   end function describe_stepped

   !> Angular frequencies that the surface excites at the reference temperature: those of the period and of the shortest wave [rad/s].
   function get_frequencies(values, given) result(frequencies)
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      real(dp) :: frequencies(2)
      type(relief_t) :: relief
      type(prony_t) :: prony
      type(master_curve_fit_t) :: fit
      type(stepped_case_t) :: point
      type(error_t), allocatable :: error
      real(dp) :: shortest

      frequencies = 0
      call get_spectrum(values, given, prony, fit)
      call get_relief(values, given, .false., relief, error)
      if (allocated(error)) return
      call resolve_stepped(values, given, relief, prony, point)
      shortest = point%period
      if (has_heights(values)) then
         shortest = 2*spacing_of(values, given)
         if (is_set(values(in%shortest_wavelength))) shortest = max(shortest, values(in%shortest_wavelength))
      else if (nint(values(in%kind)) == kind_cosines) then
         shortest = point%period/max(1, findloc(abs(given%amplitudes) > 0, .true., dim=1, back=.true.))
      end if
      frequencies = two_pi*point%pace*[1.0_dp, point%period/shortest]
   end function get_frequencies

   !> What may not be what the user means, a line each.
   function doubt_stepped(values, given) result(text)
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      character(:), allocatable :: text
      type(relief_t) :: relief
      type(prony_t) :: prony
      type(master_curve_fit_t) :: fit
      type(stepped_case_t) :: point
      type(error_t), allocatable :: error
      character(200) :: line

      text = ''
      call get_spectrum(values, given, prony, fit)
      call get_relief(values, given, .false., relief, error)
      if (allocated(error)) then
         text = error%message//new_line('a')
         return
      end if
      call resolve_stepped(values, given, relief, prony, point)
      if (has_heights(values)) then
         if (relief%seam%is_open() .and. is_set(values(in%periodise))) then
            if (nint(values(in%periodise)) == periodise_none) then
               write (line, '(a, es9.2, a, es9.2, a)') 'the heights do not meet where the period ends: a step of', &
                  & relief%seam%step, ' m, inside at most', relief%seam%largest, ' m (root mean square); periodise = ''blend''?'
               text = text//trim(line)//new_line('a')
            end if
         end if
      end if
      if (is_set(values(in%master_curve))) then
         text = text//doubt_range(fit, get_frequencies(values, given))
      end if
      if (point%edge == edge_front .and. is_set(values(in%thickness)) .and. size(prony%times) > 0 .and. point%stress > 0) then
         if (values(in%velocity)*minval(prony%times) < values(in%thickness)) text = text//'edge = ''front'' holds while velocity ' &
            & //'times relaxation_times exceeds the thickness, and it does not for the shortest of them'//new_line('a')
      end if
   end function doubt_stepped

   !> Quantities that follow from the values, for `adfric check` and the results file.
   subroutine derive_stepped(derived, values, given)
      type(derived_t), allocatable, intent(inout) :: derived(:)
      real(dp), intent(in) :: values(:)
      type(given_surface_t), intent(in) :: given
      character(*), parameter :: of_foundation = 'stiffness young_modulus poisson_ratio thickness relaxation_time ' &
         & //'retardation_ratio moduli young_moduli relaxation_times master_curve relaxed_modulus terms_per_decade'
      character(*), parameter :: of_surface = 'period height heights spacing amplitudes phases interpolation detrend periodise ' &
         & //'blend_share shortest_wavelength height_factor'
      type(relief_t) :: relief
      type(prony_t) :: prony
      type(master_curve_fit_t) :: fit
      type(stepped_case_t) :: point
      type(error_t), allocatable :: error

      call get_spectrum(values, given, prony, fit)
      call get_relief(values, given, .false., relief, error)
      if (allocated(error)) return
      call resolve_stepped(values, given, relief, prony, point)
      call add_derived(derived, 'stiffness', 'Pa/m', 'long-time stiffness', prony%relaxed, of_foundation)
      call add_derived(derived, 'stiffness_ratio', '-', 'instantaneous over long-time stiffness', &
         & instantaneous_modulus(prony)/prony%relaxed, of_foundation)
      call add_derived(derived, 'period', 'm', 'length of one period', point%period, of_surface)
      call add_derived(derived, 'height', 'm', 'peak-to-valley height', point%height, of_surface)
      call add_derived(derived, 'pressure_unit', 'Pa', 'pressure unit, height times stiffness', point%pressure_unit, &
         & of_foundation//' '//of_surface)
   end subroutine derive_stepped

end module adfric_foundation_stepped_description
