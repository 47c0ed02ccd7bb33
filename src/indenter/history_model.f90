! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `indenter_history`: an indenter of any axisymmetric shape, without adhesion and with Coulomb's friction, through a path of
!> normal and tangential forces or displacements. What each step leaves is a profile along the axis `step`.
module adfric_indenter_history_model
   use adfric_base_kinds, only: dp
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_count, show_number
   use adfric_base_unset, only: is_set, unset
   use adfric_indenter_case, only: indenter_case_t, resolve_case, is_possible
   use adfric_indenter_check, only: check_body
   use adfric_indenter_contact, only: branch_stable, find_contact
   use adfric_indenter_contact_state, only: contact_t
   use adfric_indenter_survey, only: survey_t, survey_curve
   use adfric_indenter_curve, only: control_load, control_approach
   use adfric_indenter_shape, only: spot_t
   use adfric_indenter_variables
   use adfric_material_contact_modulus, only: derive_contact_modulus, has_poisson_ratio, poisson_compliance_of
   use adfric_material_normal_contact, only: by_displacement, by_force, normal_contact_t, normal_state_t
   use adfric_material_tangential_history, only: history_t, start_history
   use adfric_model_check, only: require
   use adfric_model_derived, only: derived_t
   use adfric_model_pointwise, only: pointwise_model_t, point_state_t
   use adfric_model_rows, only: list_row, positive, result_row
   use adfric_model_status, only: status_solved, status_no_equilibrium, status_not_converged
   use adfric_model_table, only: profile_axis_t, profile_t, variable_t
   implicit none (type, external)
   private
   public :: history_model_t, new_history_model

   !> Places of the variables; up to that of the modulus they are those of the model `indenter`.
   integer, parameter, public :: h_coefficient = v_second_poisson_ratio + 1, h_loads = h_coefficient + 1, &
      & h_approaches = h_coefficient + 2, h_tangential_forces = h_coefficient + 3, h_tangential_displacements = h_coefficient + 4
   integer, parameter, public :: n_history_variables = h_tangential_displacements
   !> Places of the results.
   integer, parameter, public :: r_total_loss = 1, r_largest_force = 2, r_largest_displacement = 3
   integer, parameter, public :: n_history_results = r_largest_displacement
   !> Places of the profiles.
   integer, parameter, public :: p_load = 1, p_approach = 2, p_tangential_force = 3, p_tangential_displacement = 4, &
      & p_contact_radius = 5, p_stick_radius = 6, p_friction_loss = 7
   integer, parameter, public :: n_history_profiles = p_friction_loss

   !> Most steps of a path.
   integer, parameter :: most_steps = 100000000

   !> The numbers of a list of the path; not allocated where it is not given.
   type :: list_t
      !> In SI units; shape `(n_steps)`.
      real(dp), allocatable :: values(:)
   end type list_t

   !> The model.
   type, extends(pointwise_model_t) :: history_model_t
      private
      !> The path: loads, approaches, tangential forces, tangential displacements.
      type(list_t) :: path(h_loads:h_tangential_displacements)
   contains
      procedure :: take_dataset
      procedure :: check_values
      procedure :: wants_profiles
      procedure :: get_profile_axes
      procedure :: solve_point
      procedure :: fill_profiles
      procedure :: derive_quantities
      procedure :: unit_of
   end type history_model_t

   !> Normal states of an indenter, reduced.
   type, extends(normal_contact_t) :: indenter_states_t
      !> The indenter with its units.
      type(indenter_case_t) :: case
      !> What its curve is under a load and at an approach.
      type(survey_t) :: surveys(2)
   contains
      procedure :: under_load
      procedure :: at_approach
   end type indenter_states_t

   !> What a point leaves: the profiles.
   type, extends(point_state_t) :: history_state_t
      !> Shape `(n_steps, n_history_profiles)`.
      real(dp), allocatable :: steps(:, :)
   end type history_state_t

contains

   !> The model with its tables.
   subroutine new_history_model(self)
      !> Receives its names and its tables.
      type(history_model_t), intent(out) :: self
      type(variable_t), allocatable :: v(:)

      self%name = 'indenter_history'
      self%summary = 'an indenter with friction through a path of normal and tangential forces or displacements'
      self%references = 'R. D. Mindlin, H. Deresiewicz, J. Appl. Mech. 20 (1953) 327; J. Jaeger, Arch. Appl. Mech. 63 (1993) 402'
      self%variables = get_indenter_variables()
      allocate (v(n_history_variables))
      v(:v_second_poisson_ratio) = self%variables(:v_second_poisson_ratio)
      v(h_coefficient) = positive(group='friction', name='coefficient', unit='-', meaning='mu of Coulomb''s friction')
      v(h_coefficient)%has_bare_name = .false.
      v(h_loads) = list_row(group='history', name='loads', unit='N', meaning='loads at the ends of straight steps, the first ' &
         & //'from 0; a list or FILE:/DATASET', most_count=most_steps, lower=0.0_dp)
      v(h_approaches) = list_row(group='history', name='approaches', unit='m', meaning='approaches, instead of the loads; ' &
         & //'below 0 out of contact', most_count=most_steps)
      v(h_tangential_forces) = list_row(group='history', name='tangential_forces', unit='N', &
         & meaning='tangential forces at the ends of the steps, up to mu P of either sign', most_count=most_steps)
      v(h_tangential_displacements) = list_row(group='history', name='tangential_displacements', unit='m', &
         & meaning='displacements of distant points along the force, instead of the tangential forces', most_count=most_steps)
      call move_alloc(v, self%variables)
      allocate (self%results(n_history_results))
      self%results(r_total_loss) = result_row(name='total_friction_loss', unit='J', &
         & long_name='energy that friction has taken by the last step', is_main=.true.)
      self%results(r_largest_force) = result_row(name='largest_tangential_force', unit='N', &
         & long_name='largest size of the tangential force at a step', is_main=.true.)
      self%results(r_largest_displacement) = result_row(name='largest_tangential_displacement', unit='m', &
         & long_name='largest size of the tangential displacement at a step', is_main=.true.)
      allocate (self%profiles(n_history_profiles))
      self%profiles(p_load) = profile_t(name='load', unit='N', long_name='load')
      self%profiles(p_approach) = profile_t(name='approach', unit='m', long_name='approach of distant points')
      self%profiles(p_tangential_force) = profile_t(name='tangential_force', unit='N', long_name='tangential force')
      self%profiles(p_tangential_displacement) = profile_t(name='tangential_displacement', unit='m', &
         & long_name='displacement of distant points along the tangential force')
      self%profiles(p_contact_radius) = profile_t(name='contact_radius', unit='m', long_name='radius a of contact')
      self%profiles(p_stick_radius) = profile_t(name='stick_radius', unit='m', &
         & long_name='radius within which nothing slips at the end of the step')
      self%profiles(p_friction_loss) = profile_t(name='friction_loss', unit='J', long_name='energy that friction has taken so far')
      self%profile_axes = 'step'
      allocate (self%counts(0))
   end subroutine new_history_model

   !> See `model_t`.
   subroutine take_dataset(self, place, values, problems)
      !> The model, which keeps the path.
      class(history_model_t), intent(inout) :: self
      !> Place of the list in `variables`.
      integer, intent(in) :: place
      !> Its numbers; shape `(n_steps, 1)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      self%path(place)%values = values(:, 1)
      associate (unused => problems)
      end associate
   end subroutine take_dataset

   !> See `model_t`.
   subroutine check_values(self, values, is_swept, problems)
      !> The model with its path.
      class(history_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      type(indenter_case_t) :: case
      integer :: before

      before = problems%count()
      call check_body(self%variables, values, .true., problems)
      call require(self%variables, values, [h_coefficient], problems)
      if (is_set(values(v_contact_modulus)) .and. .not. has_poisson_ratio(values(v_contact_modulus:v_second_poisson_ratio))) &
         & call problems%add('solid', 'poisson_ratio', 'is missing [-]; the tangential displacement needs it')
      call check_pair(h_loads, h_approaches)
      call check_pair(h_tangential_forces, h_tangential_displacements)
      if (problems%count() > before) return
      call check_path(self, values, is_swept, problems)
      if (problems%count() > before) return
      call resolve_case(indenter_values(self, values), case)
      if (.not. is_possible(indenter_values(self, values), case)) then
         associate (v => self%variables(merge(h_loads, h_approaches, is_set(values(h_loads)))))
            call problems%add(v%group, v%name, 'are beyond all numbers for this indenter')
         end associate
      end if

   contains

      !> One of two lists is needed.
      subroutine check_pair(one, two)
         !> Places of the two.
         integer, intent(in) :: one, two

         if (is_set(values(one)) .and. is_set(values(two))) then
            call problems%add('history', self%variables(one)%name, 'stands beside '//self%variables(two)%name//'; give one of them')
         else if (.not. (is_set(values(one)) .or. is_set(values(two)))) then
            call problems%add('history', self%variables(one)%name, 'is missing ['//self%variables(one)%unit//']; give it, or ' &
               & //self%variables(two)%name)
         end if
      end subroutine check_pair

   end subroutine check_values

   !> Are the steps possible?
   subroutine check_path(self, values, is_swept, problems)
      !> The model with its path.
      class(history_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer :: normal, tangential, k
      logical :: is_mixed

      normal = merge(h_loads, h_approaches, is_set(values(h_loads)))
      tangential = merge(h_tangential_forces, h_tangential_displacements, is_set(values(h_tangential_forces)))
      if (.not. (allocated(self%path(normal)%values) .and. allocated(self%path(tangential)%values))) return
      associate (n => self%path(normal)%values, t => self%path(tangential)%values)
         if (size(n) /= size(t)) then
            call problems%add('history', self%variables(tangential)%name, 'has '//show_count(size(t))//' values, and ' &
               & //self%variables(normal)%name//' has '//show_count(size(n)))
            return
         end if
         if (.not. maxval(n) > 0) call problems%add('history', self%variables(normal)%name, 'never presses: no value is above 0')
         is_mixed = (normal == h_loads) .neqv. (tangential == h_tangential_forces)
         do k = 1, size(n)
            if (normal == h_loads .and. tangential == h_tangential_forces .and. is_set(values(h_coefficient)) &
               & .and. .not. is_swept(h_coefficient)) then
               if (abs(t(k)) > (1 + 16*epsilon(t))*values(h_coefficient)*n(k)) then
                  call problems%add('history', 'tangential_forces', 'is '//show_number(t(k))//' N at step '//show_count(k) &
                     & //', more than mu P')
                  return
               end if
            end if
            if (.not. is_mixed) cycle
            if (k == 1) then
               if (.not. abs(t(k)) > 0) cycle
            else
               if (.not. (abs(n(k) - n(k - 1)) > 0 .and. abs(t(k) - t(k - 1)) > 0)) cycle
            end if
            call problems%add('history', self%variables(tangential)%name, 'changes at step '//show_count(k)//' together with ' &
               & //self%variables(normal)%name//'; let them change in turn, or give both as forces or both as displacements')
            return
         end do
      end associate
   end subroutine check_path

   !> The values that the model `indenter` would have at the largest load.
   pure function indenter_values(self, values) result(indenter)
      !> The model with its path.
      class(history_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      real(dp) :: indenter(n_indenter_variables)

      indenter = unset
      indenter(:v_second_poisson_ratio) = values(:v_second_poisson_ratio)
      indenter([v_theory, v_branch, v_profiles, v_n_r]) = [choose_none, branch_stable, 0, 2]
      if (is_set(values(h_loads))) indenter(v_load) = maxval(self%path(h_loads)%values)
      if (is_set(values(h_approaches))) indenter(v_approach) = maxval(self%path(h_approaches)%values)
   end function indenter_values

   !> See `model_t`: always.
   pure logical function wants_profiles(self, values)
      !> The model; nothing of it is read here.
      class(history_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      wants_profiles = .true.
      associate (unused => self, unused_too => values)
      end associate
   end function wants_profiles

   !> See `model_t`.
   subroutine get_profile_axes(self, values, axes)
      !> The model with its path.
      class(history_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the axis of the steps.
      type(profile_axis_t), allocatable, intent(out) :: axes(:)
      integer :: n, k

      allocate (axes(1))
      axes(1)%name = self%profile_axes
      axes(1)%unit = '-'
      axes(1)%long_name = 'number of the step'
      n = 0
      do k = h_loads, h_tangential_displacements
         if (allocated(self%path(k)%values)) n = size(self%path(k)%values)
      end do
      allocate (axes(1)%coordinates(n), source=0.0_dp)
      do k = 1, n
         axes(1)%coordinates(k) = k
      end do
      associate (unused => values)
      end associate
   end subroutine get_profile_axes

   !> See `pointwise_model_t`.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
      !> The model with its path.
      class(history_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the steps, for the profiles; nothing is taken from the point before.
      class(point_state_t), allocatable, intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Relative error of the energy that friction takes, and at least round-off.
      real(dp), intent(out) :: error_estimate
      !> One of `status_...`.
      integer, intent(out) :: status
      !> This model counts nothing; size 0.
      real(dp), intent(inout) :: counts(:)
      type(history_state_t), allocatable :: found
      type(indenter_states_t) :: contacts
      type(history_t) :: history
      type(spot_t) :: corner
      real(dp) :: indenter(n_indenter_variables)

      error_estimate = 0
      status = status_no_equilibrium
      indenter = indenter_values(self, values)
      call resolve_case(indenter, contacts%case)
      if (.not. is_possible(indenter, contacts%case)) return
      call survey_curve(contacts%case%curve, control_load, contacts%surveys(control_load))
      call survey_curve(contacts%case%curve, control_approach, contacts%surveys(control_approach))
      call contacts%case%curve%shape%evaluate(0.0_dp, .true., corner)
      if (contacts%case%curve%shape%inner_rise() > 0) contacts%kink = corner%depth
      allocate (found)
      call follow_path(self, values, contacts, history, found%steps, status)
      if (status /= status_solved) return
      results(r_total_loss) = found%steps(size(found%steps, 1), p_friction_loss)
      results(r_largest_force) = maxval(abs(found%steps(:, p_tangential_force)))
      results(r_largest_displacement) = maxval(abs(found%steps(:, p_tangential_displacement)))
      error_estimate = 16*epsilon(1.0_dp)
      if (results(r_total_loss) > 0) error_estimate = max(error_estimate, history%loss_error/history%loss)
      call move_alloc(found, state)
      associate (unused_counts => counts)
      end associate
   end subroutine solve_point

   !> Go through the path.
   pure subroutine follow_path(self, values, contacts, history, steps, status)
      !> The model with its path.
      class(history_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> The normal states.
      type(indenter_states_t), intent(in) :: contacts
      !> Receives the last state.
      type(history_t), intent(out) :: history
      !> Receives what each step leaves, in SI units; shape `(n_steps, n_history_profiles)`.
      real(dp), allocatable, intent(out) :: steps(:, :)
      !> Receives one of `status_...`.
      integer, intent(out) :: status
      type(normal_state_t) :: next
      real(dp) :: given, units(2), compliance
      integer :: normal, tangential, kind, k
      logical :: is_converged, is_possible

      normal = merge(h_loads, h_approaches, is_set(values(h_loads)))
      tangential = merge(h_tangential_forces, h_tangential_displacements, is_set(values(h_tangential_forces)))
      kind = merge(by_force, by_displacement, tangential == h_tangential_forces)
      units = [contacts%case%force_unit(), contacts%case%height_unit]
      associate (mu => values(h_coefficient), path => self%path(normal)%values)
         ! m, the ratio of the tangential to the normal compliance
         compliance = 1 + contacts%case%modulus*poisson_compliance_of(values(v_contact_modulus:v_second_poisson_ratio))/4
         allocate (steps(size(path), n_history_profiles))
         call start_history(history)
         status = status_solved
         do k = 1, size(path)
            next = normal_state_t()
            is_converged = .true.
            if (.not. path(k) > 0) then
               if (normal == h_approaches) next%approach = path(k)/units(by_displacement)
            else if (normal == h_loads) then
               call contacts%under_load(path(k)/units(by_force), next, is_converged)
            else
               call contacts%at_approach(path(k)/units(by_displacement), next, is_converged)
            end if
            given = self%path(tangential)%values(k)
            call history%advance(contacts, next, kind, given/(mu*units(kind)*merge(compliance, 1.0_dp, kind == by_displacement)), &
               & is_possible)
            if (.not. is_possible) status = status_no_equilibrium
            if (.not. (is_converged .and. history%is_converged)) status = status_not_converged
            if (status /= status_solved) return
            steps(k, p_load) = next%load*units(by_force)
            steps(k, p_approach) = next%approach*units(by_displacement)
            steps(k, p_tangential_force) = mu*history%force*units(by_force)
            steps(k, p_tangential_displacement) = mu*compliance*history%displacement*units(by_displacement)
            steps(k, merge(p_load, p_approach, normal == h_loads)) = path(k)
            steps(k, merge(p_tangential_force, p_tangential_displacement, kind == by_force)) = given
            steps(k, p_contact_radius) = next%radius*contacts%case%length_unit
            steps(k, p_stick_radius) = history%stick_radius()*contacts%case%length_unit
            ! nothing but round-off is nothing
            steps(k, p_friction_loss) = 0
            if (history%loss > history%loss_error) steps(k, p_friction_loss) = mu**2*compliance*history%loss*product(units)
         end do
      end associate
   end subroutine follow_path

   !> See `normal_contact_t`.
   pure subroutine under_load(self, given, state, is_converged)
      !> The indenter.
      class(indenter_states_t), intent(in) :: self
      !> Load, reduced.
      real(dp), intent(in) :: given
      !> Receives the state.
      type(normal_state_t), intent(out) :: state
      !> Was it found to round-off?
      logical, intent(out) :: is_converged

      call find_state(self, control_load, given, state, is_converged)
   end subroutine under_load

   !> See `normal_contact_t`.
   pure subroutine at_approach(self, given, state, is_converged)
      !> The indenter.
      class(indenter_states_t), intent(in) :: self
      !> Approach, reduced.
      real(dp), intent(in) :: given
      !> Receives the state.
      type(normal_state_t), intent(out) :: state
      !> Was it found to round-off?
      logical, intent(out) :: is_converged

      call find_state(self, control_approach, given, state, is_converged)
   end subroutine at_approach

   !> A normal state, reduced. The elastic energy is the integral of the load over the approach.
   pure subroutine find_state(self, control, given, state, is_converged)
      !> The indenter.
      type(indenter_states_t), intent(in) :: self
      !> `control_load` or `control_approach`.
      integer, intent(in) :: control
      !> Load or approach.
      real(dp), intent(in) :: given
      !> Receives the state.
      type(normal_state_t), intent(out) :: state
      !> Was it found to round-off?
      logical, intent(out) :: is_converged
      type(contact_t) :: contact

      call find_contact(self%case%curve, self%surveys(control), control, given, .true., branch_stable, contact)
      is_converged = contact%is_found .and. contact%is_converged
      state%load = contact%load
      state%approach = contact%approach
      state%radius = contact%spot%radius
      state%stiffness = contact%stiffness
      if (self%case%curve%shape%n_pieces == 0) then
         state%work = contact%load*contact%approach/2
      else
         state%work = self%case%curve%shape%energy(contact%u, contact%is_beyond)
      end if
   end subroutine find_state

   !> See `pointwise_model_t`.
   subroutine fill_profiles(self, values, results, state, axes, profiles)
      !> The model; nothing of it is read here.
      class(history_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the point, of which none is needed; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> The steps of the point.
      class(point_state_t), allocatable, intent(in) :: state
      !> The axis of the steps.
      type(profile_axis_t), intent(in) :: axes(:)
      !> In: all NaN. Out: the profiles; shape `(n_steps, 1, n_profiles)`.
      real(dp), intent(inout) :: profiles(:, :, :)

      profiles = not_a_number()
      if (.not. allocated(state)) return
      select type (state)
      type is (history_state_t)
         profiles(:, 1, :) = state%steps
      end select
      associate (unused => self, unused_too => values, unused_results => results, unused_axes => axes)
      end associate
   end subroutine fill_profiles

   !> See `model_t`.
   function derive_quantities(self, values) result(derived)
      !> The model, whose table of variables is read.
      class(history_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: derived(:)

      associate (first => v_contact_modulus, last => v_second_poisson_ratio)
         derived = derive_contact_modulus(self%variables(first:last), values(first:last))
      end associate
   end function derive_quantities

   !> See `model_t`: the coefficient of r^n has a unit that depends on n.
   function unit_of(self, values, place) result(unit)
      !> The model, whose table of variables is read.
      class(history_model_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Place of the variable in `variables`.
      integer, intent(in) :: place
      character(:), allocatable :: unit

      unit = self%variables(place)%unit
      if (place /= v_coefficient .or. .not. is_set(values(v_exponent))) return
      unit = 'm^(1-'//show_number(values(v_exponent))//')'
   end function unit_of

end module adfric_indenter_history_model
