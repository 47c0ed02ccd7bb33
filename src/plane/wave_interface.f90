! SPDX-License-Identifier: GPL-3.0-or-later
!> Friction of `wave_1d` with a law of the interface: over a viscoelastic half-plane the sum with what that loses, and over an elastic
!> one the shear alone.
module adfric_plane_wave_interface
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_unset, only: is_set
   use adfric_interface_friction_law, only: friction_law_t
   use adfric_interface_friction_law_rows, only: given_law_t, get_friction_law, n_interface_rows
   use adfric_interface_total_friction, only: get_shear_of_area, interface_tractions, near_ratios, sliding_friction_t
   use adfric_plane_contact_shear, only: contact_nodes, integrate_shear, n_contact_nodes
   use adfric_plane_adhesive_wave_point, only: adhesive_point_t, get_adhesive_profiles
   use adfric_plane_left_out_coupling, only: left_out_of_line, modulus_of_contact
   use adfric_plane_elastic_wave_point, only: get_elastic_wave_profiles
   use adfric_plane_sliding_wave_point, only: slide_point_t
   use adfric_plane_sliding_wave_units, only: new_wave_slide, wave_slide_state_t, wave_slide_t
   use adfric_plane_wave_variables, only: in => wave_input, out => wave_output
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_solid_contact_modulus, only: contact_modulus_of
   use adfric_solid_spectrum_rows, only: poisson_ratio_of, shift_factor_of, solid_shift_of
   use adfric_solid_time_temperature, only: time_temperature_t
   implicit none (type, external)
   private
   public :: interface_of, add_slide_interface, add_elastic_interface, add_left_out, wave_tractions

contains

   !> The values of the interface.
   pure function interface_of(values) result(friction)
      real(dp), intent(in) :: values(:)
      real(dp) :: friction(n_interface_rows)

      friction = [values(in%shear_strength:in%pressure_factor), values(in%law(1):in%law(size(in%law)))]
   end function interface_of

   !> Add the interface to the friction of a sliding wave.
   pure subroutine add_slide_interface(values, spectrum, given, point, results, is_valid)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: spectrum
      type(given_law_t), intent(in) :: given
      !> The point, which has been solved.
      type(slide_point_t), intent(in) :: point
      !> In: results of the solid. Out: with both parts of the friction; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Does the law hold at this velocity and temperature?
      logical, intent(out) :: is_valid
      type(friction_law_t) :: law
      type(sliding_friction_t) :: friction
      type(wave_slide_t) :: slide
      type(wave_slide_state_t) :: state
      real(dp) :: shear, unused
      integer :: k
      logical :: is_solved

      call get_friction_law(interface_of(values), given, solid_shift_of(values(in%material(1):in%temperature), spectrum), law)
      friction%direction = point%slide%direction
      friction%hysteretic = friction%direction*point%contact%friction_stress
      call get_slide_shear(values, law, point%slide, point%contact, friction%interfacial, friction%interfacial_slope, is_valid)
      if (.not. is_valid) return
      friction%neighbours = not_a_number()
      do k = 1, size(near_ratios)
         call new_wave_slide(slide, values(in%period), values(in%amplitude), point%prony, &
            & values(in%velocity)*near_ratios(k)*shift_factor_of(values(in%material(1):in%temperature), spectrum), is_solved)
         if (.not. is_solved) cycle
         if (is_set(values(in%mean_pressure))) then
            call slide%solve_pressure(values(in%mean_pressure), state, is_solved)
         else
            call slide%solve_penetration(values(in%penetration), state, is_solved)
         end if
         if (.not. is_solved) cycle
         call get_slide_shear(values, law, slide, state, shear, unused, is_solved)
         friction%neighbours(k) = friction%direction*state%friction_stress + shear
      end do
      call friction%store(values(in%velocity), results(out%mean_pressure), results(out%friction_stress), &
         & results(out%friction_coefficient), results(out%hysteretic_friction_stress:out%velocity_slope))
      call add_left_out_of_slide(values, law, spectrum, point, results)
   end subroutine add_slide_interface

   !> Add what a sliding wave leaves out by a contact of frictionless faces.
   pure subroutine add_left_out_of_slide(values, law, spectrum, point, results)
      real(dp), intent(in) :: values(:)
      type(friction_law_t), intent(in) :: law
      type(given_spectrum_t), intent(in) :: spectrum
      !> The point, which has been solved.
      type(slide_point_t), intent(in) :: point
      !> In: with the friction. Out: with what is left out; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      real(dp) :: x(n_contact_nodes), pressure(n_contact_nodes), half_width
      integer :: i

      if (.not. (point%contact%contact_fraction > 0 .and. is_set(poisson_ratio_of(values(in%material(1):in%temperature))))) return
      half_width = point%contact%contact_fraction*values(in%period)/2
      x = contact_nodes(merge(0.0_dp, point%contact%contact_shift, point%contact%is_full), half_width)
      do i = 1, n_contact_nodes
         pressure(i) = point%slide%pressure_at(point%contact, x(i))
      end do
      associate (material => values(in%material(1):in%temperature))
         results(out%coupling_left_out) = left_out_of_line(law, abs(values(in%velocity)), values(in%temperature), pressure, &
            & half_width, values(in%period), poisson_ratio_of(material), modulus_of_contact(point%prony, abs(values(in%velocity)) &
            & *shift_factor_of(material, spectrum), half_width), results(out%friction_stress))
      end associate
   end subroutine add_left_out_of_slide

   !> Add what a wave on an elastic half-plane leaves out by a contact of frictionless faces.
   pure subroutine add_left_out(values, given, results, adhesive)
      real(dp), intent(in) :: values(:)
      type(given_law_t), intent(in) :: given
      !> In: with the friction. Out: with what is left out; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> The point, where there is adhesion.
      type(adhesive_point_t), intent(in), optional :: adhesive
      type(friction_law_t) :: law
      type(time_temperature_t) :: none
      real(dp) :: x(n_contact_nodes), pressure(n_contact_nodes), gap(n_contact_nodes), tension

      if (.not. (results(out%contact_fraction) > 0 .and. is_set(values(in%poisson_ratio)))) return
      if (is_set(values(in%second_young_modulus))) return
      call get_friction_law(interface_of(values), given, none, law)
      x = contact_nodes(0.0_dp, results(out%contact_width)/2)
      tension = 0
      if (present(adhesive)) then
         call get_adhesive_profiles(adhesive, x, pressure, gap)
         tension = values(in%adhesion)*results(out%adhesion_fraction)
      else
         call get_elastic_wave_profiles(values, results, x, pressure, gap)
      end if
      results(out%coupling_left_out) = left_out_of_line(law, abs(values(in%velocity)), values(in%temperature), pressure, &
         & results(out%contact_width)/2, values(in%period), values(in%poisson_ratio), &
         & contact_modulus_of(values(in%contact_modulus:in%second_poisson_ratio)), results(out%friction_stress), tension)
   end subroutine add_left_out

   !> Shear of a sliding wave over nominal area [Pa].
   pure subroutine get_slide_shear(values, law, slide, state, shear, slope, is_valid)
      real(dp), intent(in) :: values(:)
      type(friction_law_t), intent(in) :: law
      type(wave_slide_t), intent(in) :: slide
      type(wave_slide_state_t), intent(in) :: state
      !> The shear, and its change by ln v in this contact.
      real(dp), intent(out) :: shear, slope
      logical, intent(out) :: is_valid
      real(dp) :: x(n_contact_nodes), pressure(n_contact_nodes)
      integer :: i

      if (.not. law%depends_on_pressure() .or. .not. state%contact_fraction > 0) then
         call get_shear_of_area(law, abs(values(in%velocity)), values(in%temperature), state%contact_fraction, &
            & state%mean_pressure, shear, slope, is_valid)
         return
      end if
      x = contact_nodes(state%contact_shift, state%contact_fraction*values(in%period)/2)
      do i = 1, n_contact_nodes
         pressure(i) = slide%pressure_at(state, x(i))
      end do
      call integrate_shear(law, abs(values(in%velocity)), values(in%temperature), state%contact_fraction/2, pressure, shear, &
         & slope, is_valid)
   end subroutine get_slide_shear

   !> Friction of a wave on an elastic half-plane by a law of the velocity.
   pure subroutine add_elastic_interface(values, given, tension, results, is_valid)
      real(dp), intent(in) :: values(:)
      type(given_law_t), intent(in) :: given
      !> Tension of adhesion outside contact, over nominal area [Pa].
      real(dp), intent(in) :: tension
      !> In: results of a solved point. Out: with friction; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Does the law hold at this velocity and temperature?
      logical, intent(out) :: is_valid
      type(friction_law_t) :: law
      type(time_temperature_t) :: none
      type(sliding_friction_t) :: friction
      real(dp) :: x(n_contact_nodes), pressure(n_contact_nodes), gap(n_contact_nodes)

      call get_friction_law(interface_of(values), given, none, law)
      friction%direction = sign(1.0_dp, values(in%velocity))
      if (law%depends_on_pressure() .and. results(out%contact_fraction) > 0) then
         x = contact_nodes(0.0_dp, results(out%contact_width)/2)
         call get_elastic_wave_profiles(values, results, x, pressure, gap)
         call integrate_shear(law, abs(values(in%velocity)), values(in%temperature), results(out%contact_fraction)/2, pressure, &
            & friction%interfacial, friction%interfacial_slope, is_valid)
      else
         call get_shear_of_area(law, abs(values(in%velocity)), values(in%temperature), results(out%contact_fraction), &
            & results(out%mean_pressure) + tension, friction%interfacial, friction%interfacial_slope, is_valid)
      end if
      if (is_valid) call friction%store(values(in%velocity), results(out%mean_pressure), results(out%friction_stress), &
         & results(out%friction_coefficient), results(out%hysteretic_friction_stress:out%velocity_slope))
   end subroutine add_elastic_interface

   !> Shear stress along the wave [Pa].
   pure function wave_tractions(values, spectrum, given, pressure, is_contact) result(stress)
      real(dp), intent(in) :: values(:)
      type(given_spectrum_t), intent(in) :: spectrum
      type(given_law_t), intent(in) :: given
      !> Pressure [Pa]; shape `(n)`.
      real(dp), intent(in) :: pressure(:)
      !> Do the surfaces touch? Shape `(n)`.
      logical, intent(in) :: is_contact(:)
      real(dp) :: stress(size(pressure))
      type(friction_law_t) :: law

      call get_friction_law(interface_of(values), given, solid_shift_of(values(in%material(1):in%temperature), spectrum), law)
      stress = interface_tractions(law, values(in%velocity), values(in%temperature), pressure, is_contact)
   end function wave_tractions

end module adfric_plane_wave_interface
