! SPDX-License-Identifier: GPL-3.0-or-later
!> What the theories say of an elastic surface under a mean pressure, in the order of the first rows of `rough_output`. The models
!> of the theories alone, and of drawn surfaces with theories beside them, take it from here.
module adfric_rough_pressed_theories
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_interface_conduction_rows, only: conductances, has_conduction, n_conduction_results
   use adfric_rough_persson, only: get_persson_states, most_pressure, persson_fraction, persson_mean_square, persson_state_t
   use adfric_rough_separation_functions, only: area_function_t, energy_share_t, new_area_function, new_separation_functions, &
      & plain_share, separation_functions_t, wang_mueser_share, yang_persson_share
   use adfric_rough_summits, only: n_summit_theories, new_summits, summit_state_t, summits_t
   use adfric_rough_variables, only: n_shares, n_theories, out => rough_output, share_plain, share_wang_mueser, share_yang_persson
   use adfric_rough_wave_nodes, only: least_for_gap, new_wave_nodes, wave_nodes_t
   use adfric_shape_height_spectrum, only: height_spectrum_t
   implicit none (type, external)
   private
   public :: pressed_theories_t, new_pressed_theories, pressed_surface_t, set_shares, set_nodes, set_areas, answer_pressed
   public :: add_conductances, least_mean_pressure

   !> Widest panels in ln t of the integrals of pressed surfaces.
   real(dp), parameter :: widest_pressed = 0.8_dp
   !> Least mean pressure that theories have an answer for [Pa].
   real(dp), parameter :: least_mean_pressure = 1.0e-30_dp

   !> What all surfaces share.
   type :: pressed_theories_t
      !> Functions of Persson's theory.
      type(separation_functions_t) :: functions
      !> Theories of summits.
      type(summits_t) :: summits
   end type pressed_theories_t

   !> A surface, with what its theories need at any pressure.
   type :: pressed_surface_t
      !> The spectrum.
      type(height_spectrum_t) :: spectrum
      !> Nodes of its integrals.
      type(wave_nodes_t) :: nodes
      !> Areas of the corrected forms.
      type(area_function_t) :: areas(2:n_shares)
      !> Energies of the forms.
      type(energy_share_t) :: shares(n_shares)
   end type pressed_surface_t

contains

   !> Find what all surfaces share.
   pure subroutine new_pressed_theories(self)
      !> Receives functions and series.
      type(pressed_theories_t), intent(out) :: self

      call new_separation_functions(self%functions)
      call new_summits(self%summits)
   end subroutine new_pressed_theories

   !> Have the energies of the forms of Persson's theory.
   pure subroutine set_shares(surface, constant)
      !> Receives the energies.
      class(pressed_surface_t), intent(inout) :: surface
      !> Yang and Persson's constant.
      real(dp), intent(in) :: constant

      surface%shares(share_plain) = plain_share()
      surface%shares(share_yang_persson) = yang_persson_share(constant)
      surface%shares(share_wang_mueser) = wang_mueser_share()
   end subroutine set_shares

   !> Have the nodes of the integrals of a surface that does not slide.
   pure subroutine set_nodes(surface)
      !> In: with its spectrum. Out: with the nodes.
      class(pressed_surface_t), intent(inout) :: surface

      call new_wave_nodes(surface%nodes, surface%spectrum, widest_pressed, least_for_gap)
   end subroutine set_nodes

   !> Have the areas of the corrected forms.
   pure subroutine set_areas(surface)
      !> In: with the energies of the forms. Out: with their areas.
      class(pressed_surface_t), intent(inout) :: surface
      integer :: k

      do k = 2, n_shares
         call new_area_function(surface%areas(k), surface%shares(k))
      end do
   end subroutine set_areas

   !> The answers of the theories under a pressure.
   pure subroutine answer_pressed(shared, surface, modulus, mean_pressure, is_asked, results, is_converged)
      !> What all surfaces share.
      type(pressed_theories_t), intent(in) :: shared
      !> The surface, with nodes, energies and areas.
      class(pressed_surface_t), intent(in) :: surface
      !> Contact modulus, and mean pressure, at least `least_mean_pressure` [Pa].
      real(dp), intent(in) :: modulus, mean_pressure
      !> Which theories are asked; what others fail to find does not count; shape `(n_theories)`.
      logical, intent(in) :: is_asked(:)
      !> In: all NaN. Out: answers in the order of the first rows of `rough_output`, NaN where a theory has no state; shape `(n)`
      !> with n at least `n_pressed_results`.
      real(dp), intent(inout) :: results(:)
      !> Receives whether all theories that are asked have an answer or no state.
      logical, intent(out) :: is_converged
      type(persson_state_t) :: states(n_shares)
      real(dp) :: pressure
      integer :: k
      logical :: is_found

      pressure = mean_pressure/modulus/surface%nodes%slope
      results(out%contact_fraction(share_plain)) = persson_fraction(pressure)
      results(out%mean_square_pressure) = (modulus*surface%nodes%slope)**2*persson_mean_square(pressure)
      is_converged = .true.
      do k = 2, n_shares
         call surface%areas(k)%contact_fraction(pressure, results(out%contact_fraction(k)), is_found)
         is_converged = is_converged .and. (is_found .or. .not. is_asked(k))
      end do
      ! beyond, contact is full to all digits, and gap and stiffness have no value
      states%energy = surface%spectrum%moment(1)/4
      if (pressure < most_pressure) then
         call get_persson_states(surface%nodes, shared%functions, pressure, surface%shares, states)
         is_converged = is_converged .and. all(.not. is_asked(:n_shares) .or. (ieee_is_finite(states%gap) .and. &
            & ieee_is_finite(states%stiffness) .and. ieee_is_finite(states%energy)))
         if (.not. is_converged) return
         results(out%mean_gap(:n_shares)) = states%gap
         results(out%normal_stiffness(:n_shares)) = modulus*states%stiffness
         results(out%conductance_factor(:n_shares)) = states%stiffness
      end if
      results(out%elastic_energy) = modulus*states%energy
      if (any(is_asked(n_shares + 1:n_theories))) call answer_of_summits(shared%summits, surface, modulus, pressure, is_asked, &
         & results, is_converged)
   end subroutine answer_pressed

   !> Add the conductances of all theories, from their stiffness.
   pure subroutine add_conductances(conduction, results)
      !> Values of the rows of conduction.
      real(dp), intent(in) :: conduction(:)
      !> In: with `conductance_factor`. Out: with the conductances that are wanted; shape `(n_pressed_results)`.
      real(dp), intent(inout) :: results(:)
      real(dp) :: found(n_conduction_results)
      integer :: k

      if (.not. has_conduction(conduction)) return
      do k = 1, n_theories
         found = not_a_number()
         call conductances(conduction, results(out%conductance_factor(k)), found)
         results([out%electrical_conductance(k), out%thermal_conductance(k)]) = found
      end do
   end subroutine add_conductances

   !> The answers of the theories of summits.
   pure subroutine answer_of_summits(summits, surface, modulus, pressure, is_asked, results, is_converged)
      type(summits_t), intent(in) :: summits
      class(pressed_surface_t), intent(in) :: surface
      !> Contact modulus [Pa], and p/(E g).
      real(dp), intent(in) :: modulus, pressure
      logical, intent(in) :: is_asked(:)
      real(dp), intent(inout) :: results(:)
      logical, intent(inout) :: is_converged
      type(summit_state_t) :: state
      real(dp) :: h, guess
      logical :: is_there, is_found
      integer :: k

      h = surface%spectrum%root_mean_square_height()
      guess = 1
      do k = 1, n_summit_theories
         call summits%under_pressure(k, surface%spectrum%nayak_parameter(), pressure, guess, state, is_there, is_found)
         is_converged = is_converged .and. (is_found .or. .not. is_asked(n_shares + k))
         if (.not. is_there) cycle
         ! the next theory is not far from this one
         guess = state%separation
         results(out%contact_fraction(n_shares + k)) = state%area
         results(out%mean_gap(n_shares + k)) = h*state%separation
         results(out%conductance_factor(n_shares + k)) = surface%nodes%slope/h*state%stiffness
         results(out%normal_stiffness(n_shares + k)) = modulus*results(out%conductance_factor(n_shares + k))
      end do
   end subroutine answer_of_summits

end module adfric_rough_pressed_theories
