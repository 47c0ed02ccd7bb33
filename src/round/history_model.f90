! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `indenter_history`: an indenter of any axisymmetric shape, without adhesion and with Coulomb's friction, through a path of
!> normal and tangential forces or displacements. What each step leaves is a profile along the axis `step`.
module adfric_round_history_model
   use adfric_base_kinds, only: dp
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_round_case, only: indenter_case_t, resolve_case, tangential_compliance, is_possible_case => is_possible
   use adfric_round_check, only: check_history_body
   use adfric_round_contact, only: branch_stable, find_contact
   use adfric_round_contact_state, only: contact_t
   use adfric_round_edge_slope, only: measure_edge
   use adfric_round_indenter_states, only: find_indenter_states, indenter_states_t, plain_indenter
   use adfric_round_survey, only: survey_t, survey_curve
   use adfric_round_variables, only: get_indenter_variables, indenter_unit_of, n_indenter_variables, &
      & in => indenter_input
   use adfric_interface_history_model, only: history_model_t, history_units_t
   use adfric_interface_history_path, only: n_path_results, path_approaches, path_coefficient, path_loads, &
      & path_tangential_displacements, path_tangential_forces, set_path_results
   use adfric_interface_normal_contact, only: normal_contact_t
   use adfric_describe_table, only: profile_t, variable_t
   implicit none (type, external)
   private
   public :: indenter_history_t, new_indenter_history

   !> Indices of the variables; up to that of the modulus they are those of the model `indenter`.
   integer, parameter, public :: h_coefficient = in%second_poisson_ratio + path_coefficient, &
      & h_loads = in%second_poisson_ratio + path_loads, h_approaches = in%second_poisson_ratio + path_approaches, &
      & h_tangential_forces = in%second_poisson_ratio + path_tangential_forces, &
      & h_tangential_displacements = in%second_poisson_ratio + path_tangential_displacements

   !> The model.
   type, extends(history_model_t) :: indenter_history_t
   contains
      procedure :: check_bodies
      procedure :: find_contacts
      procedure :: unit_of
      procedure :: measure
   end type indenter_history_t

contains

   !> The model with its tables.
   subroutine new_indenter_history(self)
      !> Receives its names and its tables.
      type(indenter_history_t), intent(out) :: self
      type(variable_t), allocatable :: rows(:)

      self%name = 'indenter_history'
      self%summary = 'an indenter with friction through a path of normal and tangential forces or displacements'
      allocate (rows, source=get_indenter_variables())
      call self%set_history_tables(rows(:in%second_poisson_ratio), [in%contact_modulus, in%second_poisson_ratio], &
         & profile_t(name='contact_radius', unit='m', long_name='radius a of contact'), &
         & profile_t(name='stick_radius', unit='m', long_name='radius within which nothing slips at the end of the step'))
      allocate (self%results(n_path_results))
      call set_path_results(self%results)
   end subroutine new_indenter_history

   !> See `history_model_t`.
   subroutine check_bodies(self, values, problems)
      class(indenter_history_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems

      call check_history_body(self%variables, values, problems)
   end subroutine check_bodies

   !> See `history_model_t`.
   subroutine find_contacts(self, values, contacts, units, is_possible)
      class(indenter_history_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      class(normal_contact_t), allocatable, intent(out) :: contacts
      type(history_units_t), intent(out) :: units
      logical, intent(out) :: is_possible
      type(indenter_states_t), allocatable :: states

      allocate (states)
      call find_indenter_states(indenter_values(self, values), states, is_possible)
      if (.not. is_possible) return
      units%force = states%case%force_unit()
      units%approach = states%case%height_unit
      units%length = states%case%length_unit
      units%compliance_ratio = tangential_compliance(values, states%case)
      call move_alloc(states, contacts)
   end subroutine find_contacts

   !> See `model_t`: the largest contact of the path.
   subroutine measure(self, values, results, measures)
      class(indenter_history_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Results of the point, none of which is needed; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      real(dp), intent(inout) :: measures(:)
      type(indenter_case_t) :: case
      type(survey_t) :: survey
      type(contact_t) :: contact
      real(dp) :: indenter(n_indenter_variables)

      indenter = indenter_values(self, values)
      call resolve_case(indenter, case)
      if (.not. is_possible_case(indenter, case)) return
      call survey_curve(case%curve, case%control, survey)
      call find_contact(case%curve, survey, case%control, case%given, .true., branch_stable, contact)
      if (contact%is_found) call measure_edge(indenter, contact%spot%radius*case%length_unit, measures)
      associate (unused => results)
      end associate
   end subroutine measure

   !> The values that the model `indenter` would have at the largest load.
   pure function indenter_values(self, values) result(indenter)
      class(indenter_history_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      real(dp) :: indenter(n_indenter_variables)

      indenter = plain_indenter(values(:in%second_poisson_ratio))
      if (is_set(values(h_loads))) indenter(in%load) = self%largest_of(values, path_loads)
      if (is_set(values(h_approaches))) indenter(in%approach) = self%largest_of(values, path_approaches)
   end function indenter_values

   !> See `model_t`: the coefficient of r^n has a unit that depends on n.
   function unit_of(self, values, index) result(unit)
      class(indenter_history_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      integer, intent(in) :: index
      character(:), allocatable :: unit

      unit = indenter_unit_of(self%variables, values, index)
   end function unit_of

end module adfric_round_history_model
