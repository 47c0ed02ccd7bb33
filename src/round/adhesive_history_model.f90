! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `adhesive_indenter_history`: an indenter with adhesion on an elastic half-space through a path of loads, approaches, or
!> approaches of the base of a spring, with the jumps of the contact. Opening may take more work than closing gives. What each step
!> leaves is a profile along the axis `step`.
!>
!> The file is long by the rows of variables, results and profiles.
module adfric_round_adhesive_history_model
   use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
   use adfric_base_kinds, only: dp
   use adfric_base_counting, only: counting
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_describe_check, only: checks_t, new_checks, refuse_size
   use adfric_describe_derived, only: derived_t
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_rows, only: above_zero, list_row, result_row
   use adfric_describe_status, only: status_no_equilibrium, status_not_converged, status_solved
   use adfric_describe_stepwise, only: steps_t, stepwise_model_t
   use adfric_describe_table, only: profile_t, result_t, variable_t
   use adfric_round_adhesive_path, only: adhesive_path_t, begin_path, go_to, new_opening
   use adfric_round_case, only: indenter_case_t, is_possible, resolve_case
   use adfric_round_check, only: check_adhesion, check_shape_alone
   use adfric_round_contact_state, only: terms_of
   use adfric_round_curve, only: control_approach, control_load, control_spring, curve_t
   use adfric_round_dugdale_curve, only: dugdale_curve_t
   use adfric_round_edge_slope, only: measure_edge
   use adfric_round_indenter_states, only: plain_indenter
   use adfric_round_variables, only: choose_auto, get_indenter_variables, in => indenter_input, indenter_unit_of, kind_flat, &
      & kind_sphere, n_indenter_variables, theory_maugis_dugdale
   use adfric_solid_contact_modulus, only: check_contact_modulus, derive_contact_modulus
   implicit none (type, external)
   private
   public :: adhesive_indenter_history_t, new_adhesive_indenter_history

   !> Variables behind those of the model `indenter` up to `lambda`; a component is the index of its row.
   type :: adhesive_path_input_t
      !> Indices of the rows.
      integer :: opening_work_of_adhesion = 0, machine_stiffness = 0, loads = 0, approaches = 0, base_approaches = 0
   end type adhesive_path_input_t
   type(adhesive_path_input_t), parameter :: path_input = transfer(in%lambda + counting, adhesive_path_input_t())
   integer, parameter :: n_variables = path_input%base_approaches

   !> Results in the order of their rows; a component is the index of its row.
   type :: adhesive_path_output_t
      !> Indices of the rows.
      integer :: pull_off_load = 0, pull_off_approach = 0, pull_off_base_approach = 0, least_load = 0, least_load_approach = 0, &
         & jump_in_base_approach = 0, jump_in_load = 0, jumps = 0, dissipated_energy = 0, largest_contact_radius = 0
   end type adhesive_path_output_t
   type(adhesive_path_output_t), parameter :: out = transfer(counting, adhesive_path_output_t())
   integer, parameter :: n_results = out%largest_contact_radius

   !> Profiles.
   integer, parameter :: p_load = 1, p_approach = 2, p_contact = 3, p_adhesion = 4, p_taken = 5, n_profiles = p_taken
   !> Round-off of a difference over its terms.
   real(dp), parameter :: round_off = 16*epsilon(1.0_dp)
   !> Most steps of a path.
   integer, parameter :: most_steps = 100000000

   !> Indices of the lists, of which one is given.
   integer, parameter :: lists(3) = [path_input%loads, path_input%approaches, path_input%base_approaches]

   !> The numbers of a list; not allocated where it is not given.
   type :: prescribed_list_t
      !> Loads [N], or approaches [m]; shape `(n_steps)`.
      real(dp), allocatable :: values(:)
   end type prescribed_list_t

   !> The model with its path.
   type, extends(stepwise_model_t) :: adhesive_indenter_history_t
      !> Loads, approaches, and approaches of the base.
      type(prescribed_list_t) :: lists(size(lists))
   contains
      procedure :: has_list
      procedure :: take_dataset
      procedure :: check_values
      procedure :: count_steps
      procedure :: solve_point
      procedure :: measure
      procedure :: derive_quantities
      procedure :: unit_of
   end type adhesive_indenter_history_t

contains

   !> The model with its tables.
   subroutine new_adhesive_indenter_history(self)
      !> Receives its names and its tables.
      type(adhesive_indenter_history_t), intent(out) :: self
      type(variable_t), allocatable :: rows(:)

      self%name = 'adhesive_indenter_history'
      self%summary = 'an indenter with adhesion through a path of loads, approaches or a spring, with jumps and hysteresis'
      self%references = 'D. Maugis, M. Barquins, J. Phys. D 11 (1978) 1989; D. Maugis, J. Colloid Interface Sci. 150 (1992) 243'
      allocate (rows, source=get_indenter_variables())
      allocate (self%variables(n_variables))
      associate (v => self%variables)
         v(:in%lambda) = rows(:in%lambda)
         v(in%work_of_adhesion)%meaning = 'w, the work of adhesion that closing gives'
         v(path_input%opening_work_of_adhesion) = above_zero(group='adhesion', name='opening_work_of_adhesion', unit='J/m^2', &
            & meaning='work of adhesion that opening takes, at the same stress; if not given that of closing')
         v(path_input%machine_stiffness) = rows(in%machine_stiffness)
         v(path_input%loads) = list_row(group='history', name='loads', unit='N', meaning='loads at the ends of the steps, '// &
            & 'below 0 where the body is pulled; a list or FILE:/DATASET', most_count=most_steps)
         v(path_input%approaches) = list_row(group='history', name='approaches', unit='m', meaning='approaches at the ends of '// &
            & 'the steps, instead of the loads', most_count=most_steps)
         v(path_input%base_approaches) = list_row(group='history', name='base_approaches', unit='m', meaning='approaches of '// &
            & 'the base of a spring at the ends of the steps, approach + load/machine_stiffness', most_count=most_steps)
      end associate
      allocate (self%results(n_results))
      call set_results(self%results)
      allocate (self%profiles(n_profiles))
      self%profiles(p_load) = profile_t(name='load', unit='N', long_name='load')
      self%profiles(p_approach) = profile_t(name='approach', unit='m', long_name='approach of distant points')
      self%profiles(p_contact) = profile_t(name='contact_radius', unit='m', long_name='radius a of contact')
      self%profiles(p_adhesion) = profile_t(name='adhesion_radius', unit='m', long_name='radius c up to which adhesion acts')
      self%profiles(p_taken) = profile_t(name='adhesion_loss', unit='J', long_name='energy that jumps and opening have '// &
         & 'taken so far')
      self%profile_axes = 'step'
      allocate (self%counts(0))
   end subroutine new_adhesive_indenter_history

   !> The table of results.
   subroutine set_results(r)
      !> Receives the rows; shape `(n_results)`.
      type(result_t), intent(out) :: r(:)

      r(out%pull_off_load) = result_row(name='pull_off_load', unit='N', long_name='load of the last state before bodies part')
      r(out%pull_off_approach) = result_row(name='pull_off_approach', unit='m', long_name='approach of that state')
      r(out%pull_off_base_approach) = result_row(name='pull_off_base_approach', unit='m', &
         & long_name='approach of the base of the spring in that state')
      r(out%least_load) = result_row(name='least_load', unit='N', long_name='least load of the path, between its steps as well', &
         & is_main=.true.)
      r(out%least_load_approach) = result_row(name='least_load_approach', unit='m', long_name='approach at that load')
      r(out%jump_in_base_approach) = result_row(name='jump_in_base_approach', unit='m', &
         & long_name='approach of the base, or of an indenter without spring, at which contact jumps in; ' &
         & //'of several jumps, that of the one that takes most energy')
      r(out%jump_in_load) = result_row(name='jump_in_load', unit='N', long_name='load right after contact has jumped in')
      r(out%jumps) = result_row(name='jumps', unit='-', long_name='jumps of the radius of adhesion, in and off')
      r(out%dissipated_energy) = result_row(name='dissipated_energy', unit='J', long_name='energy that jumps and opening have '// &
         & 'taken by the end; none known once bodies part under a load')
      r(out%largest_contact_radius) = result_row(name='largest_contact_radius', unit='m', long_name='largest radius of contact '// &
         & 'at a step')
   end subroutine set_results

   !> See `model_t`.
   subroutine take_dataset(self, index, values, problems)
      class(adhesive_indenter_history_t), intent(inout) :: self
      !> Index of the list in `variables`.
      integer, intent(in) :: index
      !> Its numbers; shape `(n_steps, 1)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      self%lists(findloc(lists, index, 1))%values = values(:, 1)
      associate (unused => problems)
      end associate
   end subroutine take_dataset

   !> Index of the list that is given.
   pure integer function given_list(values) result(k)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      k = max(1, findloc(is_set(values(lists)), .true., 1))
   end function given_list

   !> Are the numbers of the list that is given at hand?
   pure logical function has_list(self, values)
      class(adhesive_indenter_history_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      has_list = allocated(self%lists(given_list(values))%values)
   end function has_list

   !> See `model_t`.
   subroutine check_values(self, values, is_swept, problems)
      class(adhesive_indenter_history_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      type(variable_t), allocatable :: rows(:)
      type(indenter_case_t) :: case
      class(curve_t), allocatable :: opening
      type(checks_t) :: c
      real(dp) :: indenter(n_indenter_variables)
      integer :: before, given
      logical :: fits

      associate (unused => is_swept)
      end associate
      before = problems%count()
      call check_shape_alone(self%variables, values, problems)
      call check_contact_modulus(self%variables(in%contact_modulus:in%second_poisson_ratio), &
         & values(in%contact_modulus:in%second_poisson_ratio), problems, .false.)
      allocate (rows, source=get_indenter_variables())
      rows(:in%lambda) = self%variables(:in%lambda)
      indenter = indenter_values(self, values)
      call new_checks(c, rows, indenter, problems)
      call check_adhesion(c)
      call new_checks(c, self%variables, values, problems)
      call c%need([in%work_of_adhesion])
      call c%add(in%work_of_adhesion, 'is 0, and a path without adhesion has no jumps; give loads with tangential_forces and a '// &
         & 'coefficient of friction, or an operation without &history', c%has(in%work_of_adhesion) .and. .not. &
         & c%is_above_zero(in%work_of_adhesion))
      associate (opening => path_input%opening_work_of_adhesion)
         if (c%has(opening) .and. c%is_above_zero(in%work_of_adhesion)) call c%add(opening, 'is below work_of_adhesion, which '// &
            & 'closing gives', values(opening) < values(in%work_of_adhesion))
      end associate
      if (c%has(in%kind)) call c%add(in%kind, 'is ''flat_punch'', whose contact closes and opens as a whole; its pull-off '// &
         & 'stands among the results of an operation without &history', c%is_choice(in%kind, kind_flat))
      call c%need_one(lists, .true.)
      call c%need([path_input%machine_stiffness], c%has(path_input%base_approaches))
      call c%add(path_input%machine_stiffness, 'has no meaning without base_approaches, the approaches of the base of the '// &
         & 'spring', c%has(path_input%machine_stiffness) .and. .not. c%has(path_input%base_approaches))
      if (problems%count() > before .or. .not. self%has_list(values)) return
      call resolve_case(indenter, case)
      given = given_list(values)
      fits = is_possible(indenter, case)
      if (fits) call new_opening(case%curve, opening_ratio(values), opening)
      if (allocated(opening)) then
         select type (opening)
         type is (dugdale_curve_t)
            fits = opening%has_space(0.0_dp, .true.)
         end select
      end if
      if (fits) return
      if (c%is_choice(in%kind, kind_sphere) .and. case%theory == theory_maugis_dugdale) then
         call c%add(in%radius, 'is so small that adhesion would reach beyond the sphere')
      else
         call refuse_size(self%variables(lists(given)), maxval(abs(self%lists(given)%values)), problems)
      end if
   end subroutine check_values

   !> Work of opening over that of closing.
   pure real(dp) function opening_ratio(values) result(ratio)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      ratio = 1
      if (is_set(values(path_input%opening_work_of_adhesion))) ratio = values(path_input%opening_work_of_adhesion) &
         & /values(in%work_of_adhesion)
   end function opening_ratio

   !> The values that the model `indenter` would have where most is prescribed.
   pure function indenter_values(self, values) result(indenter)
      class(adhesive_indenter_history_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      real(dp) :: indenter(n_indenter_variables), most

      indenter = plain_indenter(values(:in%lambda))
      indenter(in%theory) = choose_auto
      most = 0
      if (self%has_list(values)) most = maxval(abs(self%lists(given_list(values))%values))
      if (is_set(values(path_input%loads))) then
         indenter(in%load) = most
      else if (is_set(values(path_input%base_approaches))) then
         indenter(in%base_approach) = most
         indenter(in%machine_stiffness) = values(path_input%machine_stiffness)
      else
         indenter(in%approach) = most
      end if
   end function indenter_values

   !> See `stepwise_model_t`.
   pure integer function count_steps(self, values)
      class(adhesive_indenter_history_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      count_steps = 0
      if (self%has_list(values)) count_steps = size(self%lists(given_list(values))%values)
   end function count_steps

   !> See `pointwise_model_t`.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
      class(adhesive_indenter_history_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the steps, for the profiles; nothing is taken from the point before.
      class(point_state_t), allocatable, intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Relative error of loads, approaches and energy, as their terms tell.
      real(dp), intent(out) :: error_estimate
      !> One of `status_...`.
      integer, intent(out) :: status
      !> This model counts nothing; size 0.
      real(dp), intent(inout) :: counts(:)
      type(indenter_case_t) :: case
      type(adhesive_path_t) :: path
      type(steps_t), allocatable :: found
      real(dp) :: indenter(n_indenter_variables)

      associate (unused => counts)
      end associate
      error_estimate = 0
      status = status_no_equilibrium
      indenter = indenter_values(self, values)
      call resolve_case(indenter, case)
      if (.not. is_possible(indenter, case)) return
      call begin_path(case%curve, case%control, opening_ratio(values), path)
      allocate (found)
      allocate (found%steps(self%count_steps(values), n_profiles))
      call follow_list(self%lists(given_list(values))%values, case, path, found%steps, error_estimate)
      status = merge(status_solved, status_not_converged, path%is_converged)
      if (.not. path%is_converged) return
      call store_results(case, path, found%steps, results)
      call move_alloc(found, state)
   end subroutine solve_point

   !> Go through the list.
   pure subroutine follow_list(list, case, path, steps, error_estimate)
      !> What is prescribed, in SI units.
      real(dp), intent(in) :: list(:)
      type(indenter_case_t), intent(in) :: case
      type(adhesive_path_t), intent(inout) :: path
      !> Receives what each step leaves, in SI units; shape `(n_steps, n_profiles)`.
      real(dp), intent(out) :: steps(:, :)
      !> Round-off of loads and approaches over the largest ones.
      real(dp), intent(out) :: error_estimate
      real(dp) :: terms(2), most(2), unit
      integer :: k
      logical :: is_found

      unit = case%height_unit
      if (case%control == control_load) unit = case%force_unit()
      terms = 0
      most = 0
      error_estimate = round_off
      do k = 1, size(list)
         call go_to(path, list(k)/unit, is_found)
         if (.not. path%is_converged) return
         steps(k, :) = not_a_number()
         steps(k, p_taken) = path%taken*case%force_unit()*case%height_unit
         steps(k, [p_contact, p_adhesion]) = 0
         if (.not. is_found) cycle
         associate (contact => path%contact)
            steps(k, p_load) = contact%load*case%force_unit()
            steps(k, p_approach) = contact%approach*case%height_unit
            steps(k, p_contact) = contact%spot%radius*case%length_unit
            steps(k, p_adhesion) = contact%adhesion_radius*case%length_unit
            if (.not. path%is_bound) steps(k, [p_contact, p_adhesion]) = 0
            ! what is given is kept to the last digit
            if (case%control == control_load) steps(k, p_load) = list(k)
            if (case%control == control_approach) steps(k, p_approach) = list(k)
            if (.not. path%is_bound) cycle
            terms = max(terms, terms_of(contact))
            most = max(most, abs([contact%load, contact%approach]))
         end associate
      end do
      most = max(most, abs([path%least_load, path%least_approach]))
      do k = 1, 2
         error_estimate = max(error_estimate, lost_part(terms(k), most(k)))
      end do
      if (path%least_load < 0) error_estimate = max(error_estimate, lost_part(path%least_load_terms, abs(path%least_load)))
      if (has_energy(path)) error_estimate = max(error_estimate, lost_part(path%terms, path%taken))
   end subroutine follow_list

   !> The results of a path.
   pure subroutine store_results(case, path, steps, results)
      type(indenter_case_t), intent(in) :: case
      type(adhesive_path_t), intent(in) :: path
      !> What each step has left; shape `(n_steps, n_profiles)`.
      real(dp), intent(in) :: steps(:, :)
      !> In: all NaN. Out: results in SI units; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)

      if (path%has_parted) then
         results(out%pull_off_load) = path%last_load*case%force_unit()
         results(out%pull_off_approach) = path%last_approach*case%height_unit
         if (case%control == control_spring) results(out%pull_off_base_approach) = (path%last_approach &
            & + path%opening%compliance*path%last_load)*case%height_unit
      end if
      results(out%least_load) = path%least_load*case%force_unit()
      if (path%least_load < 0) results(out%least_load_approach) = path%least_approach*case%height_unit
      if (path%largest_jump > 0) then
         if (case%control /= control_load) results(out%jump_in_base_approach) = path%jump_in*case%height_unit
         results(out%jump_in_load) = path%load_after*case%force_unit()
      end if
      results(out%jumps) = path%n_jumps
      ! nothing but round-off is nothing
      if (ieee_is_nan(path%taken) .or. has_energy(path)) then
         results(out%dissipated_energy) = path%taken*case%force_unit()*case%height_unit
      else
         results(out%dissipated_energy) = 0
      end if
      results(out%largest_contact_radius) = maxval(steps(:, p_contact))
   end subroutine store_results

   !> Round-off of a difference over itself, at most 1: then it has no digits at all.
   pure real(dp) function lost_part(terms, difference) result(part)
      !> Sum of the terms, >= 0, and their difference, >= 0.
      real(dp), intent(in) :: terms, difference

      part = 0
      if (terms > 0) part = 1
      if (difference > round_off*terms) part = round_off*terms/difference
   end function lost_part

   !> Is what has been taken known, and more than the round-off of its terms?
   pure logical function has_energy(path)
      type(adhesive_path_t), intent(in) :: path

      has_energy = .not. ieee_is_nan(path%taken)
      if (has_energy) has_energy = path%taken > round_off*path%terms
   end function has_energy

   !> See `model_t`: the largest contact of the path.
   subroutine measure(self, values, results, measures)
      class(adhesive_indenter_history_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Results of the point; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      real(dp), intent(inout) :: measures(:)

      call measure_edge(values, results(out%largest_contact_radius), measures)
      associate (unused => self)
      end associate
   end subroutine measure

   !> See `model_t`.
   function derive_quantities(self, values) result(derived)
      class(adhesive_indenter_history_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: derived(:)

      derived = derive_contact_modulus(self%variables(in%contact_modulus:in%second_poisson_ratio), &
         & values(in%contact_modulus:in%second_poisson_ratio))
   end function derive_quantities

   !> See `model_t`: the coefficient of r^n has a unit that depends on n.
   function unit_of(self, values, index) result(unit)
      class(adhesive_indenter_history_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      integer, intent(in) :: index
      character(:), allocatable :: unit

      unit = indenter_unit_of(self%variables, values, index)
   end function unit_of

end module adfric_round_adhesive_history_model
