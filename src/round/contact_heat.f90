! SPDX-License-Identifier: GPL-3.0-or-later
!> Heat of a round body that slides: the mean temperature of its contact, which the law of friction has.
!>
!> A shear stress that is the same in all of the contact is a uniform disc of heat. What goes with the pressure of a paraboloid without
!> adhesion is Hertz's source. Both have closed forms of P = v a/(2 kappa), so the temperature is that of one contact,
!>
!>     T = T0 + (v a/lambda) [M_disc tau(v, T) + M_Hertz alpha p],
!>
!> with the mean pressure p. All heat goes into the solid, and none leaves its surface beside the contact. The contact itself does not
!> depend on the shear stress here.
module adfric_round_contact_heat
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set, unset
   use adfric_interface_friction_law, only: friction_law_t
   use adfric_interface_heat_rows, only: check_heat, get_heat, h_background, h_interface, h_peak, h_share, has_heat, heat_t
   use adfric_interface_heat_sources, only: find_largest_of_sources, mean_temperature, source_disc, source_hertz
   use adfric_interface_thermal_states, only: heated_contact_t
   use adfric_round_variables, only: kind_paraboloid, law_peeling, in => indenter_input
   use adfric_describe_check, only: checks_t, new_checks, require
   use adfric_describe_table, only: variable_t
   implicit none (type, external)
   private
   public :: has_contact_heat, check_contact_heat, find_contact_temperature

contains

   !> Does heat count?
   pure logical function has_contact_heat(values)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      has_contact_heat = has_heat(values(in%heat(1):in%heat(size(in%heat))))
   end function has_contact_heat

   !> Add to `problems` what heat needs, and what does not go with it.
   subroutine check_contact_heat(variables, values, problems)
      !> Table of the variables; their names stand in the messages.
      type(variable_t), intent(in), target :: variables(:)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in), target :: values(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout), target :: problems
      type(checks_t) :: c
      integer :: before, first

      if (.not. has_contact_heat(values)) return
      call new_checks(c, variables, values, problems)
      before = problems%count()
      first = in%heat(findloc(is_set(values(in%heat)), .true., 1))
      if (nint(values(in%law)) == law_peeling .or. is_set(values(in%friction_coefficient))) then
         call c%add(first, 'has no meaning without a shear stress of sliding, whose work is the heat')
      else if (values(in%interaction) > 0) then
         call c%add(first, 'stands beside interaction, with which the contact would depend on its own temperature')
      else if (values(in%pressure_factor) > 0 .and. is_set(values(in%pressure_factor)) .and. .not. is_hertzian(values)) then
         call c%add(first, 'stands beside pressure_factor; heat that goes with the pressure is in closed form for a ' &
            & //'paraboloid without adhesion alone')
      end if
      if (problems%count() > before) return
      call require(variables, values, [in%velocity], problems)
      call check_heat(variables, values, in%heat(1), in%temperature, .true., unset, .true., problems)
   end subroutine check_contact_heat

   !> Is the pressure that of Hertz's contact?
   pure logical function is_hertzian(values)
      real(dp), intent(in) :: values(:)

      is_hertzian = nint(values(in%kind)) == kind_paraboloid
      if (is_set(values(in%work_of_adhesion))) is_hertzian = is_hertzian .and. .not. values(in%work_of_adhesion) > 0
   end function is_hertzian

   !> The temperature of the contact, and the results of heat but that of the bulk.
   pure subroutine find_contact_temperature(values, law, area, load, temperature, results, is_valid)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> The law of the interface, with the factor of the pressure.
      type(friction_law_t), intent(in) :: law
      !> Area where the shear stress acts [m^2], and the load [N].
      real(dp), intent(in) :: area, load
      !> Mean temperature of the contact [K].
      real(dp), intent(out) :: temperature
      !> Receives the results; shape `(n_heat_results)`.
      real(dp), intent(inout) :: results(:)
      !> Were the states found?
      logical, intent(out) :: is_valid
      type(heat_t) :: heat
      type(heated_contact_t) :: contact
      real(dp) :: peclet, unit, pressure, stress, slope, means(2), position

      temperature = values(in%temperature)
      results([h_background, h_interface]) = 0
      is_valid = .true.
      if (.not. area > 0) return
      call get_heat(values(in%heat), unset, heat)
      associate (speed => abs(values(in%velocity)), radius => sqrt(area/pi))
         peclet = speed*radius/(2*heat%diffusivity)
         unit = speed*radius/heat%conductivity
         pressure = load/area
         means = 1
         if (peclet > 0) means(1) = mean_temperature(source_disc, peclet, .false.)
         if (peclet > 0 .and. law%pressure_factor > 0) means(2) = mean_temperature(source_hertz, peclet, .false.)
         contact = heated_contact_t(law=law, speed=speed, base=temperature, pressure=[pressure*means(2)/means(1)], &
            & weights=[unit*means(1)])
         call heat%settle(contact, temperature, results, is_valid)
         if (.not. is_valid) return
         call law%get_stress(speed, 0.0_dp, temperature, stress, slope, is_valid)
         results(h_interface) = speed*area*(stress + law%pressure_factor*pressure)
         if (.not. results(h_interface) > 0) return
         results(h_share) = 1
         call find_largest_of_sources([source_disc, source_hertz], [stress, law%pressure_factor*pressure], peclet, position, &
            & results(h_peak))
         results(h_peak) = unit*results(h_peak)
      end associate
   end subroutine find_contact_temperature

end module adfric_round_contact_heat
