! SPDX-License-Identifier: GPL-3.0-or-later
!> Friction of a point of the model `indenter`, in SI units: Coulomb's, or that of a shear strength, in partial slip, and its traction.
module adfric_round_friction_point
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_unset, only: is_set
   use adfric_interface_normal_contact, only: friction_holds
   use adfric_round_case, only: indenter_case_t, tangential_compliance
   use adfric_round_contact_state, only: contact_t
   use adfric_round_profiles, only: pressure_at
   use adfric_round_shear, only: find_shear_slip, find_sliding, resistance_t, shear_slip_t, shear_stress_at
   use adfric_round_slip, only: find_indenter_slip, indenter_slip_t
   use adfric_round_survey, only: survey_t
   use adfric_round_variables, only: law_peeling, theory_jkr, in => indenter_input, out => indenter_output
   use adfric_solid_contact_modulus, only: has_poisson_ratio
   use adfric_describe_status, only: status_no_equilibrium, status_not_converged
   implicit none (type, external)
   private
   public :: round_friction_t, add_slip, add_friction, shear_at

   !> Friction of a contact.
   type :: round_friction_t
      !> Its slip by a coefficient.
      type(indenter_slip_t) :: slip
      !> How it resists shear, where there is a shear strength.
      type(resistance_t) :: resistance
      !> Its slip then.
      type(shear_slip_t) :: shear
   end type round_friction_t

contains

   !> Add the results of partial slip; without load there are none.
   pure subroutine add_slip(values, case, survey, contact, slip, results, status)
      real(dp), intent(in) :: values(:)
      type(indenter_case_t), intent(in) :: case
      type(survey_t), intent(in) :: survey
      type(contact_t), intent(in) :: contact
      type(indenter_slip_t), intent(out) :: slip
      !> In: results of the contact. Out: with those of slip, or all NaN; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> In: solved. Out: one of `status_...`.
      integer, intent(inout) :: status
      real(dp) :: needed, ratio
      logical :: is_converged

      associate (mu => values(in%friction_coefficient))
         needed = abs(values(in%tangential_force))/mu
         if (.not. friction_holds(needed, results(out%load))) then
            status = status_no_equilibrium
            results(:) = not_a_number()
            return
         end if
         if (.not. results(out%load) > 0) return
         call find_indenter_slip(case%curve, survey, contact, min(needed/results(out%load), 1.0_dp), slip, is_converged)
         ratio = tangential_compliance(values, case)
         results(out%stick_fraction) = slip%ratio**2
         results(out%tangential_displacement) = sign(mu*ratio*case%height_unit*slip%fall, values(in%tangential_force))
         results(out%tangential_stiffness) = 2*slip%stick%spot%radius*case%length_unit*case%modulus/ratio
         results(out%cycle_energy) = 8*mu**2*ratio*slip%energy*case%force_unit()*case%height_unit
         if (is_converged) return
         status = status_not_converged
         results(:) = not_a_number()
      end associate
   end subroutine add_slip

   !> Add the friction of a shear strength, and under a tangential force its partial slip.
   pure subroutine add_friction(values, case, contact, resistance, slip, results, status)
      real(dp), intent(in) :: values(:)
      type(indenter_case_t), intent(in) :: case
      type(contact_t), intent(in) :: contact
      type(resistance_t), intent(out) :: resistance
      type(shear_slip_t), intent(out) :: slip
      !> In: results of the contact. Out: with those of friction, or all NaN; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      integer, intent(inout) :: status
      real(dp) :: radius, force, ratio, unit
      logical :: is_converged

      unit = case%modulus*(case%height_unit/case%length_unit)
      resistance%strength = values(in%shear_strength)/unit
      if (is_set(values(in%pressure_factor))) resistance%factor = values(in%pressure_factor)
      resistance%edge_fraction = values(in%edge_fraction)
      call find_sliding(resistance, contact, case%curve%outer_pull, radius, force)
      if (force < 0 .and. case%theory == theory_jkr) then
         status = status_no_equilibrium
         results(:) = not_a_number()
         return
      end if
      force = max(force, 0.0_dp)
      results(out%friction_area) = pi*(radius*case%length_unit)**2
      results(out%friction_force) = force*case%force_unit()
      is_converged = .true.
      if (radius > 0 .and. wants_onset(values, case)) call add_onset(values, case, contact, resistance, force, results, &
         & is_converged)
      if (.not. is_converged) then
         status = status_not_converged
         results(:) = not_a_number()
         return
      end if
      if (.not. is_set(values(in%tangential_force))) return
      if (.not. friction_holds(values(in%tangential_force), results(out%friction_force))) then
         status = status_no_equilibrium
         results(:) = not_a_number()
         return
      end if
      if (.not. radius > 0) return
      call find_shear_slip(case%curve%shape, resistance, contact, abs(values(in%tangential_force)) &
         & /case%force_unit(), slip, is_converged)
      ratio = tangential_compliance(values, case)
      results(out%stick_fraction) = slip%ratio**2
      results(out%tangential_displacement) = sign(ratio*case%height_unit*slip%displacement, values(in%tangential_force))
      results(out%tangential_stiffness) = 2*slip%radius*case%length_unit*case%modulus/ratio
      results(out%cycle_energy) = ratio*slip%energy*case%force_unit()*case%height_unit
      if (is_converged) return
      status = status_not_converged
      results(:) = not_a_number()
   end subroutine add_friction

   !> Are the events asked for under a strength that grows with pressure? They need Poisson's ratio, no interaction, and a stress at the
   !> edge that is finite.
   pure logical function wants_onset(values, case) result(wants)
      real(dp), intent(in) :: values(:)
      type(indenter_case_t), intent(in) :: case

      wants = values(in%events) > 0 .and. is_set(values(in%pressure_factor)) .and. .not. values(in%interaction) > 0
      if (wants) wants = values(in%pressure_factor) > 0 .and. case%theory /= theory_jkr &
         & .and. has_poisson_ratio(values(in%contact_modulus:in%second_poisson_ratio))
   end function wants_onset

   !> Add the onset of sliding of a contact that does not change: T grows with u up to the force of sliding, at which the last
   !> position slips, so that is the largest one and nothing drops or jumps.
   pure subroutine add_onset(values, case, contact, resistance, force, results, is_converged)
      real(dp), intent(in) :: values(:)
      type(indenter_case_t), intent(in) :: case
      !> Its contact, of a radius of friction > 0.
      type(contact_t), intent(in) :: contact
      type(resistance_t), intent(in) :: resistance
      !> Force of sliding, reduced.
      real(dp), intent(in) :: force
      !> Receives the events; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      logical, intent(out) :: is_converged
      type(shear_slip_t) :: slip

      call find_shear_slip(case%curve%shape, resistance, contact, force, slip, is_converged)
      results([out%peak_force, out%sliding_force]) = force*case%force_unit()
      results([out%force_drop, out%critical_lateral_stiffness]) = 0
      results(out%peak_displacement) = tangential_compliance(values, case)*case%height_unit*slip%displacement
   end subroutine add_onset

   !> Shear traction at a distance from the axis [Pa].
   pure real(dp) function shear_at(case, contact, friction, values, r) result(traction)
      type(indenter_case_t), intent(in) :: case
      type(contact_t), intent(in) :: contact
      type(round_friction_t), intent(in) :: friction
      real(dp), intent(in) :: values(:)
      !> Distance from the axis, reduced, >= 0.
      real(dp), intent(in) :: r

      if (nint(values(in%law)) == law_peeling) then
         traction = bonded_stress(values(in%tangential_force), contact%spot%radius, r)/case%length_unit**2
         return
      end if
      if (is_set(values(in%shear_strength))) then
         traction = shear_stress_at(case%curve%shape, friction%resistance, contact, friction%shear, r)*case%modulus &
            & *(case%height_unit/case%length_unit)
         if (is_set(values(in%tangential_force))) traction = sign(traction, values(in%tangential_force))
         return
      end if
      traction = pressure_at(case%curve%shape, contact, r)
      if (friction%slip%stick%load > 0) traction = traction - pressure_at(case%curve%shape, friction%slip%stick, r)
      traction = sign(values(in%friction_coefficient), values(in%tangential_force))*traction*case%modulus &
         & *(case%height_unit/case%length_unit)
   end function shear_at

   !> Shear stress of a force on a circle that sticks as a whole; none at its edge.
   pure real(dp) function bonded_stress(force, radius, r) result(stress)
      !> The force, which may not be given.
      real(dp), intent(in) :: force
      !> Radius of the circle, and distance from the axis.
      real(dp), intent(in) :: radius, r

      stress = 0
      if (.not. is_set(force) .or. r > radius) return
      stress = not_a_number()
      if (r < radius) stress = force/(2*pi*radius*sqrt((radius - r)*(radius + r)))
   end function bonded_stress

end module adfric_round_friction_point
