! SPDX-License-Identifier: GPL-3.0-or-later
!> What `adfric check` says of a case of `surface_sliding`: derived quantities, doubts, and the slope of its surface.
module adfric_periodic_sliding_description
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: two_pi
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_solid_order_margin, only: order_margin_of
   use adfric_solid_prony, only: prony_t
   use adfric_solid_spectrum_rows, only: derive_spectrum, doubt_spectrum, get_spectrum, n_spectrum_rows
   use adfric_interface_adhesion_rows, only: adhesion_law_t
   use adfric_describe_derived, only: add_derived, derived_t
   use adfric_periodic_adhesion_cells, only: derive_zone
   use adfric_periodic_given_heights, only: given_heights_t
   use adfric_periodic_point, only: periodic_surface_t
   use adfric_periodic_sliding_case, only: frequencies_of
   use adfric_periodic_sliding_interface, only: doubt_surface_coupling, has_surface_interface
   use adfric_periodic_viscoelastic_solid, only: viscoelastic_solid_t
   use adfric_periodic_sliding_variables, only: cells_of, kind_heights, kind_wave_2d, s_velocity, in => sliding_input
   implicit none (type, external)
   private
   public :: derive_surface, doubt_one_contact, doubt_surface, slope_of_surface

contains

   !> Moduli and shift factor, the frequencies of the surface, the cells of a wave, and lengths of adhesion.
   subroutine derive_surface(derived, values, of_solid, spectrum, surface, law)
      !> Receives the quantities.
      type(derived_t), allocatable, intent(out) :: derived(:)
      !> Values of all variables, and those of the rows of the solid.
      real(dp), intent(in) :: values(:), of_solid(:)
      type(given_spectrum_t), intent(in) :: spectrum
      type(periodic_surface_t), intent(in) :: surface
      !> The adhesion, without a stress where there is none.
      type(adhesion_law_t), intent(in) :: law
      type(prony_t) :: prony
      character(*), parameter :: sources = 'direction velocity period cells length_x length_y heights'
      real(dp) :: frequencies(2)

      allocate (derived(0))
      call derive_spectrum(derived, of_solid(:n_spectrum_rows), spectrum)
      frequencies = frequencies_of(of_solid(s_velocity), values(in%direction), nint(values(in%kind)) == kind_heights, surface)
      call add_derived(derived, 'lowest_frequency', 'rad/s', 'lowest angular frequency that the surface excites', &
         & frequencies(1), sources)
      call add_derived(derived, 'highest_frequency', 'rad/s', 'highest angular frequency that the surface excites', &
         & frequencies(2), sources)
      if (nint(values(in%kind)) /= kind_heights) call add_derived(derived, 'cells', '-', 'cells along a period of a wave', &
         & real(cells_of(values), dp), 'cells')
      if (.not. law%stress > 0) return
      call derive_zone(derived, law, surface, 'length of a short zone of adhesion on the relaxed solid, pi E0 w/(4 p0^2)')
      call get_spectrum(of_solid(:n_spectrum_rows), spectrum, prony)
      call add_derived(derived, 'margin_of_order', '-', 'where >= 0, the branches bound all states on a half-plane', &
         & order_margin_of(prony%moduli/prony%relaxed, prony%times))
   end subroutine derive_surface

   !> Edges that do not meet, a solid that loses nothing, frequencies beyond the master curve, and a coupling that is left out.
   function doubt_surface(values, of_solid, spectrum, heights, surface) result(text)
      !> Values of all variables, and those of the rows of the solid.
      real(dp), intent(in) :: values(:), of_solid(:)
      type(given_spectrum_t), intent(in) :: spectrum
      type(given_heights_t), intent(in) :: heights
      type(periodic_surface_t), intent(in) :: surface
      character(:), allocatable :: text

      text = ''
      ! over an elastic solid the interface rubs
      if (of_solid(s_velocity) > 0 .and. has_losses(of_solid, spectrum)) text = &
         & doubt_spectrum(of_solid(:n_spectrum_rows), spectrum, &
         & frequencies_of(of_solid(s_velocity), values(in%direction), nint(values(in%kind)) == kind_heights, surface))
      if (nint(values(in%kind)) == kind_heights) text = text//heights%doubt()
      text = text//doubt_surface_coupling(of_solid, surface%period(1))
   end function doubt_surface

   !> A line where shear moves the contact and the real part of some stiffness is below 0, so that nothing proves that there is one
   !> contact; else nothing. Waves along the motion tell, which couple most.
   function doubt_one_contact(surface) result(text)
      !> The surface with its cells and its solid.
      type(periodic_surface_t), intent(in) :: surface
      character(:), allocatable :: text
      character(200) :: line
      complex(dp) :: stiffness(1, 1)
      real(dp) :: ratio, waves(2)
      integer :: i

      text = ''
      select type (solid => surface%solid)
      type is (viscoelastic_solid_t)
         if (.not. allocated(solid%coupling)) return
         ratio = 1
         do i = 1, maxval(surface%n_cells)/2
            waves = i*solid%motion%steps*merge(surface%period(1)/surface%period, 0.0_dp, solid%motion%varies)
            if (.not. any(abs(waves) > 0)) return
            call solid%kernel%get_stiffness(waves(1:1), waves(2:2), surface%cell_sizes()/surface%period(1), stiffness)
            ratio = min(ratio, real(stiffness(1, 1), dp)/abs(stiffness(1, 1)))
         end do
         if (ratio > 0) return
         write (line, '(a, f7.3, a)') 'losses and shear stress make the real part of a stiffness', ratio, &
            & ' of its size: nothing proves that the contact is the only one, and maps are not solved'
         text = trim(line)//new_line('a')
      end select
   end function doubt_one_contact

   !> Is there something to be said of the losses? Not of an elastic solid beside a law of the interface.
   logical function has_losses(of_solid, spectrum)
      !> Values of the rows of the solid.
      real(dp), intent(in) :: of_solid(:)
      type(given_spectrum_t), intent(in) :: spectrum
      type(prony_t) :: prony

      call get_spectrum(of_solid(:n_spectrum_rows), spectrum, prony)
      has_losses = size(prony%moduli) > 0 .or. .not. has_surface_interface(of_solid)
   end function has_losses

   !> The steepest slope of waves, the mean one of heights [-].
   real(dp) function slope_of_surface(values, heights) result(slope)
      !> Values of all variables.
      real(dp), intent(in) :: values(:)
      type(given_heights_t), intent(in) :: heights

      if (nint(values(in%kind)) == kind_heights) then
         slope = heights%slope(values(in%heights:in%rms_height))
      else
         slope = two_pi*values(in%amplitude)/values(in%period)
         if (nint(values(in%kind)) == kind_wave_2d) slope = sqrt(2.0_dp)*slope
      end if
   end function slope_of_surface

end module adfric_periodic_sliding_description
