! SPDX-License-Identifier: GPL-3.0-or-later
!> One point of the model `sphere`: from the values of a namelist to reduced variables.
module adfric_round_sphere_case
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set
   use adfric_solid_contact_modulus, only: contact_modulus_of
   use adfric_interface_interaction_rows, only: slip_energy_ratio_of
   use adfric_round_sphere_contact, only: theory_hertz, control_load, control_approach, control_radius
   use adfric_round_sphere_units, only: get_sphere_units
   use adfric_round_sphere_variables, only: state_sliding, units_si, in => sphere_input
   implicit none (type, external)
   private
   public :: sphere_case_t, resolve_case, has_ratio_of_body, theory_auto

   !> Asked to choose the theory; otherwise one of `theory_...`.
   integer, parameter :: theory_auto = -1

   !> A point in reduced variables (J 2.11), and the units of its results.
   type :: sphere_case_t
      !> Maugis's parameter; 1 where no theory needs it.
      real(dp) :: lambda = 1
      !> One of `theory_...`.
      integer :: theory = theory_auto
      !> Relative error that a theory chosen by `theory_auto` may have [-].
      real(dp) :: tolerance = 1.0e-8_dp
      !> What is prescribed (`control_...`), its value, and the branch.
      integer :: control = control_load, branch = 1
      !> Load, approach or radius that is prescribed, reduced.
      real(dp) :: value = 0
      !> Is there a law of friction, and does the sphere slide?
      logical :: has_friction = .false., is_sliding = .false.
      !> Shear strength in the scale of lambda, Poisson's ratio, x, alpha, g0.
      real(dp) :: strength = 0, poisson = 0, edge_fraction = 0.4_dp, interaction = 0, slip_energy_ratio = huge(1.0_dp)
      !> alpha of the shear stress tau0 + alpha p.
      real(dp) :: pressure_factor = 0
      !> Tangential force or displacement, where one is given.
      logical :: is_force_given = .false., is_displacement_given = .false., is_base_given = .false.
      !> That force or displacement, or the displacement of the base of a lateral spring, reduced.
      real(dp) :: tangential = 0
      !> Stiffness of a lateral spring, reduced; 0 if none is given.
      real(dp) :: stiffness = 0
      !> Units: radii, approach, forces, stresses.
      real(dp) :: length_unit = 1, approach_unit = 1, force_unit = 1, stress_unit = 1
   end type sphere_case_t

contains

   !> The point that the values describe; they have been checked.
   pure subroutine resolve_case(values, self)
      real(dp), intent(in) :: values(:)
      !> Receives the point in reduced variables, with its units.
      type(sphere_case_t), intent(out) :: self

      self%theory = nint(values(in%theory)) - 2
      self%tolerance = values(in%relative_tolerance)
      if (is_set(values(in%lambda))) self%lambda = values(in%lambda)
      if (nint(values(in%units)) == units_si) call resolve_units(values, self)
      call resolve_operation(values, self)
      call resolve_friction(values, self)
   end subroutine resolve_case

   !> Units, and what adhesion is in them. Without adhesion the units are those of w = E* R.
   pure subroutine resolve_units(values, self)
      real(dp), intent(in) :: values(:)
      !> In: with theory and lambda as they are given. Out: with the units, and what follows for theory and lambda.
      type(sphere_case_t), intent(inout) :: self
      real(dp) :: work, e

      work = get_work(values)
      if (.not. work > 0) self%theory = theory_hertz
      e = contact_modulus_of(values(in%contact_modulus:in%second_poisson_ratio))
      if (self%theory == theory_hertz) work = e*values(in%radius)
      call get_sphere_units(values(in%radius), e, work, self%length_unit, self%approach_unit, self%force_unit, self%stress_unit)
      if (is_set(values(in%adhesion_stress))) self%lambda = values(in%adhesion_stress)/self%stress_unit
      if (is_set(values(in%adhesion_range))) self%lambda = work/values(in%adhesion_range)/self%stress_unit
   end subroutine resolve_units

   !> The work of adhesion; 0 where none is given.
   pure real(dp) function get_work(values) result(work)
      real(dp), intent(in) :: values(:)

      work = 0
      if (is_set(values(in%work_of_adhesion))) work = values(in%work_of_adhesion)
   end function get_work

   !> What is prescribed.
   pure subroutine resolve_operation(values, self)
      real(dp), intent(in) :: values(:)
      !> In: with its units. Out: with what is prescribed, too.
      type(sphere_case_t), intent(inout) :: self

      self%branch = nint(values(in%branch))
      if (is_set(values(in%load))) then
         self%control = control_load
         self%value = values(in%load)/self%force_unit
      else if (is_set(values(in%approach))) then
         self%control = control_approach
         self%value = values(in%approach)/self%approach_unit
      else
         self%control = control_radius
         self%value = values(in%contact_radius)/self%length_unit
      end if
   end subroutine resolve_operation

   !> Does one body alone yield, whose Poisson's ratio is known by its moduli?
   pure logical function has_ratio_of_body(values)
      real(dp), intent(in) :: values(:)

      has_ratio_of_body = is_set(values(in%body_poisson_ratio)) .and. .not. is_set(values(in%second_young_modulus))
   end function has_ratio_of_body

   !> Friction.
   pure subroutine resolve_friction(values, self)
      real(dp), intent(in) :: values(:)
      !> In: with its units. Out: with its friction, too.
      type(sphere_case_t), intent(inout) :: self

      self%edge_fraction = values(in%edge_fraction)
      self%is_sliding = nint(values(in%state)) == state_sliding
      self%has_friction = is_set(values(in%shear_strength))
      if (.not. self%has_friction) return
      self%strength = values(in%shear_strength)/self%stress_unit
      if (is_set(values(in%pressure_factor))) self%pressure_factor = values(in%pressure_factor)
      if (has_ratio_of_body(values)) self%poisson = values(in%body_poisson_ratio)
      if (is_set(values(in%poisson_ratio))) self%poisson = values(in%poisson_ratio)
      self%interaction = values(in%interaction)
      self%slip_energy_ratio = slip_energy_ratio_of(values(in%interaction:in%slip_energy_ratio), values(in%shear_strength), &
         & get_work(values))
      self%is_force_given = is_set(values(in%tangential_force))
      self%is_displacement_given = is_set(values(in%tangential_displacement))
      if (self%is_force_given) self%tangential = values(in%tangential_force)/self%force_unit
      self%is_base_given = is_set(values(in%base_displacement))
      if (self%is_base_given) self%tangential = values(in%base_displacement)/self%approach_unit
      if (is_set(values(in%lateral_stiffness))) self%stiffness = values(in%lateral_stiffness)*(self%approach_unit/self%force_unit)
      if (self%is_displacement_given) self%tangential = values(in%tangential_displacement)/self%approach_unit
   end subroutine resolve_friction

end module adfric_round_sphere_case
