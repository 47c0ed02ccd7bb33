! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `indenter_time`: an indenter of any axisymmetric shape on a viscoelastic half-space through a history in time, without
!> adhesion and friction. What each step leaves is a profile along the axis `step`. The file is long by its answers to `model_t`.
module adfric_round_timed_model
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_not_a_number, only: not_a_number
   use adfric_base_problems, only: problems_t
   use adfric_base_unset, only: is_set
   use adfric_describe_check, only: checks_t, new_checks, refuse_given
   use adfric_describe_derived, only: derived_t
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_status, only: status_no_equilibrium, status_not_converged, status_solved
   use adfric_describe_stepwise, only: steps_t, stepwise_model_t
   use adfric_describe_table, only: variable_t
   use adfric_numerics_time_panels, only: get_weights, n_nodes
   use adfric_round_check, only: check_shape_alone
   use adfric_round_edge_slope, only: measure_edge
   use adfric_round_indenter_states, only: indenter_states_t
   use adfric_round_timed_contact, only: advance, error_of, start_contact, timed_contact_t
   use adfric_round_timed_course, only: find_course, read_steps, timed_course_t
   use adfric_round_timed_cycle, only: new_cycle
   use adfric_round_timed_energy, only: stored_free, stored_in_contact
   use adfric_round_timed_history, only: adheres, check_history, doubt_noise, doubt_swing, has_power_law, n_given_legs, &
      & set_history_rows, steps_of_leg, timed_input, timed_lists_t
   use adfric_round_timed_oscillation, only: add_oscillation, get_moduli, oscillation_t
   use adfric_round_timed_panel, only: timed_panel_t
   use adfric_round_timed_rows, only: n_timed_profiles, n_timed_results, p_approach, p_area, p_load, p_radius, p_stiffness, &
      & p_time, set_timed_profiles, set_timed_results, out => timed_output
   use adfric_round_timed_setting, only: before_history, before_solid, n_shape, n_timed_variables, new_timed_contact, &
      & set_up_history, timed_setting_t
   use adfric_round_timed_slopes, only: solve_cycle_with_slopes
   use adfric_round_timed_springs, only: get_spot
   use adfric_round_timed_trigger, only: find_trigger
   use adfric_round_variables, only: get_indenter_variables, indenter_unit_of, in => indenter_input, kind_flat
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_solid_power_law, only: power_law_error
   use adfric_solid_spectrum_rows, only: check_spectrum, derive_spectrum, describe_spectrum, n_spectrum_rows, &
      & set_spectrum_rows, take_spectrum, take_spectrum_attribute
   implicit none (type, external)
   private
   public :: indenter_time_t, new_indenter_time, set_timed_rows

   !> The model.
   type, extends(stepwise_model_t) :: indenter_time_t
      !> Lists of the solid.
      type(given_spectrum_t) :: given
      !> Lists of the history.
      type(timed_lists_t) :: lists
   contains
      procedure :: take_dataset
      procedure :: take_attribute
      procedure :: check_values
      procedure :: count_steps
      procedure :: describe_case
      procedure :: derive_quantities
      procedure :: describe_doubts
      procedure :: solve_point
      procedure :: solve_with_slopes
      procedure :: measure
      procedure :: unit_of
   end type indenter_time_t

contains

   !> The model with its tables.
   subroutine new_indenter_time(self)
      !> Receives its names and its tables.
      type(indenter_time_t), intent(out) :: self

      self%name = 'indenter_time'
      self%summary = 'an indenter on a viscoelastic half-space in time'
      self%references = 'E. H. Lee, J. R. M. Radok, J. Appl. Mech. 27 (1960) 438; T. C. T. Ting, J. Appl. Mech. 33 (1966) 845'
      allocate (self%variables(n_timed_variables))
      call set_timed_rows(get_indenter_variables(), self%variables)
      allocate (self%results(n_timed_results))
      call set_timed_results(self%results)
      allocate (self%profiles(n_timed_profiles))
      call set_timed_profiles(self%profiles)
      self%profile_axes = 'step'
      allocate (self%counts(0))
   end subroutine new_indenter_time

   !> The rows of shape, solid and history.
   subroutine set_timed_rows(indenter, v)
      !> The table of the model `indenter`, which has the same shapes; shape `(n_indenter_variables)`.
      type(variable_t), intent(in) :: indenter(:)
      !> Receives the rows; shape `(n_timed_variables)`.
      type(variable_t), intent(out) :: v(:)

      v(:n_shape) = indenter(:n_shape)
      call set_spectrum_rows(v(before_solid + 1:before_history))
      call set_history_rows(v(before_history + 1:))
   end subroutine set_timed_rows

   !> See `model_t`.
   subroutine take_dataset(self, index, values, problems)
      class(indenter_time_t), intent(inout) :: self
      !> Index of the list in `variables`.
      integer, intent(in) :: index
      !> Its numbers; shape `(n, n_columns)`.
      real(dp), intent(in) :: values(:, :)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      if (index <= before_history) then
         call take_spectrum(self%given, index - before_solid, values)
      else
         select case (index - before_history)
         case (timed_input%times)
            self%lists%times = values(:, 1)
         case (timed_input%approaches)
            self%lists%approaches = values(:, 1)
         case (timed_input%loads)
            self%lists%loads = values(:, 1)
         case (timed_input%base_approaches)
            self%lists%base_approaches = values(:, 1)
         end select
      end if
      associate (unused => problems)
      end associate
   end subroutine take_dataset

   !> See `model_t`: the temperature of a master curve.
   subroutine take_attribute(self, index, name, value, problems)
      class(indenter_time_t), intent(inout) :: self
      !> Index of the variable.
      integer, intent(in) :: index
      !> Name of the attribute, and its value in SI units.
      character(*), intent(in) :: name
      real(dp), intent(in) :: value
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems

      call take_spectrum_attribute(self%given, self%variables(index), index - before_solid, name, value, problems)
   end subroutine take_attribute

   !> See `model_t`.
   subroutine check_values(self, values, is_swept, problems)
      class(indenter_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      integer, parameter :: shifts(2) = [timed_input%contact_point, timed_input%drift_rate]
      real(dp) :: own(size(values))
      type(checks_t) :: c
      type(timed_contact_t) :: contact
      type(indenter_states_t) :: states
      integer :: before, n_before, k
      logical :: is_possible

      before = problems%count()
      call check_shape_alone(self%variables, values, problems)
      associate (solid => values(before_solid + 1:before_history), rows => self%variables(before_solid + 1:before_history))
         if (has_power_law(values(before_history + 1:))) then
            call refuse_given(rows, solid, is_swept(before_solid + 1:before_history), [(k, k=1, n_spectrum_rows)], &
               & 'stands beside a power law, which has one modulus and one exponent', problems)
         else
            call check_spectrum(rows, solid, self%given, is_swept(before_solid + 1:before_history), problems)
         end if
      end associate
      call new_checks(c, self%variables, values, problems)
      call check_history(c, before_history, self%lists, is_swept, problems)
      ! with adhesion the contact is another one
      if (problems%count() > before .or. adheres(self%variables, before_history)) return
      own = values
      ! a zero or a drift that varies has no value yet
      where (is_swept(before_history + shifts)) own(before_history + shifts) = 0
      call find_trigger(self, self%given, self%lists, own, is_possible)
      if (is_possible) call new_timed_contact(own, self%given, self%lists, contact, states, n_before, is_possible)
      if (.not. is_possible) call problems%add('surface', 'kind', &
         & 'leads to numbers above 1e308 or below 1e-308 with this history')
   end subroutine check_values

   !> See `stepwise_model_t`: the steps that are written.
   pure integer function count_steps(self, values)
      class(indenter_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)

      associate (history => values(before_history + 1:))
         count_steps = 1 + n_given_legs(history, self%lists)*steps_of_leg(history)
      end associate
   end function count_steps

   !> See `model_t`: the solid.
   function describe_case(self, values) result(text)
      class(indenter_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = ''
      if (.not. has_power_law(values(before_history + 1:))) text = describe_spectrum(values(before_solid + 1:before_history), &
         & self%given)
   end function describe_case

   !> See `model_t`.
   function derive_quantities(self, values) result(derived)
      class(indenter_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      type(derived_t), allocatable :: derived(:)

      allocate (derived(0))
      if (.not. has_power_law(values(before_history + 1:))) call derive_spectrum(derived, &
         & values(before_solid + 1:before_history), self%given)
   end function derive_quantities

   !> See `model_t`: noise of a list.
   function describe_doubts(self, values) result(text)
      class(indenter_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      character(:), allocatable :: text

      text = doubt_noise(values(before_history + 1:), self%lists)
      ! a face has no edge that swings
      if (nint(values(in%kind)) /= kind_flat) text = text//doubt_swing(values(before_history + 1:))
   end function describe_doubts

   !> See `pointwise_model_t`.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
      class(indenter_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the steps, for the profiles; nothing is taken from the point before.
      class(point_state_t), allocatable, intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Largest error of approach and load, over the largest ones.
      real(dp), intent(out) :: error_estimate
      !> One of `status_...`.
      integer, intent(out) :: status
      !> This model counts nothing; size 0.
      real(dp), intent(inout) :: counts(:)
      real(dp) :: own(size(values))
      logical :: is_found

      if (is_set(values(before_history + timed_input%time))) then
         call read_course(self, values, state, results, error_estimate, status)
      else
         own = values
         error_estimate = 0
         status = status_not_converged
         call find_trigger(self, self%given, self%lists, own, is_found)
         if (is_found) call solve_steps(self, own, state, results, error_estimate, status)
      end if
      associate (unused => counts)
      end associate
   end subroutine solve_point

   !> The steps of a history.
   subroutine solve_steps(self, values, state, results, error_estimate, status)
      class(indenter_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the steps, for the profiles.
      class(point_state_t), allocatable, intent(inout) :: state
      !> Receives the results.
      real(dp), intent(inout) :: results(:)
      real(dp), intent(out) :: error_estimate
      integer, intent(out) :: status
      type(timed_contact_t) :: contact
      type(indenter_states_t) :: states
      type(steps_t), allocatable :: found
      integer :: n_before
      logical :: is_possible

      error_estimate = 0
      status = status_no_equilibrium
      call new_timed_contact(values, self%given, self%lists, contact, states, n_before, is_possible)
      if (.not. is_possible) return
      allocate (found)
      allocate (found%steps(self%count_steps(values), n_timed_profiles))
      contact%has_energy = .true.
      call follow(self, contact, states, steps_of_leg(values(before_history + 1:)), n_before, &
         & is_set(values(before_history + timed_input%smoothing)), found%steps, results, status)
      if (status /= status_solved) return
      error_estimate = error_of(contact)
      if (has_power_law(values(before_history + 1:))) then
         error_estimate = max(error_estimate, power_law_error)
         ! without bound right after a step
         found%steps(:, p_stiffness) = not_a_number()
      end if
      ! times as they are given, from the first one on
      if (allocated(self%lists%times)) found%steps(:, p_time) = found%steps(:, p_time) + self%lists%times(1)
      if (allocated(self%lists%times)) results([out%loss_time, out%time_of_largest_contact]) = &
         & results([out%loss_time, out%time_of_largest_contact]) + self%lists%times(1)
      call move_alloc(found, state)
   end subroutine solve_steps

   !> Approach, load and radius of contact at a time. All points of a block that differ in nothing but the time have one course.
   subroutine read_course(self, values, state, results, error_estimate, status)
      class(indenter_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> In: the course of the point before, or none. Out: that of this point.
      class(point_state_t), allocatable, intent(inout) :: state
      !> Receives the results.
      real(dp), intent(inout) :: results(:)
      real(dp), intent(out) :: error_estimate
      integer, intent(out) :: status
      integer, parameter :: time = before_history + timed_input%time
      logical :: is_there

      error_estimate = 0
      if (allocated(state)) then
         select type (state)
         class is (timed_course_t)
            is_there = state%is_of(values, time)
         class default
            is_there = .false.
         end select
         if (.not. is_there) deallocate (state)
      end if
      if (.not. allocated(state)) call start_course(self, values, state)
      select type (state)
      class is (timed_course_t)
         status = state%status
         error_estimate = state%error
         if (status /= status_solved) return
         call state%read_at(values(time), results(out%approach), results(out%load), results(out%contact_radius), is_there)
         if (.not. is_there) status = status_no_equilibrium
      class default
         status = status_no_equilibrium
      end select
   end subroutine read_course

   !> The course of a point.
   subroutine start_course(self, values, state)
      class(indenter_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the course.
      class(point_state_t), allocatable, intent(out) :: state
      type(timed_course_t), allocatable :: course
      type(timed_contact_t) :: contact
      type(timed_setting_t) :: setting
      logical :: is_there

      allocate (course)
      course%values = values
      course%status = status_no_equilibrium
      if (allocated(self%lists%times)) course%begin = self%lists%times(1)
      call set_up_history(values, self%given, self%lists, setting, course%states, is_there)
      if (is_there) call new_cycle(course%cycle, setting%solid, course%states, setting%control, setting%legs, setting%tolerance)
      if (course%cycle%is_found) then
         course%error = course%cycle%error
         course%status = status_solved
      else if (is_there) then
         call start_contact(contact, setting%solid, course%states, setting%control, setting%legs, setting%tolerance, is_there)
         if (is_there) call find_course(course, self, contact)
      end if
      call move_alloc(course, state)
   end subroutine start_course

   !> See `model_t`: the load of one cycle.
   subroutine solve_with_slopes(self, values, x, of, by, members, y, y_by, is_known, error_estimate, is_there)
      class(indenter_time_t), intent(in) :: self
      real(dp), intent(in) :: values(:), x(:)
      integer, intent(in) :: of, by(:), members(:)
      real(dp), intent(out) :: y(:), y_by(:, :)
      logical, intent(out) :: is_known(:)
      real(dp), intent(out) :: error_estimate
      logical, intent(out) :: is_there

      is_there = of == out%load .and. size(x) > 0
      select type (self)
      type is (indenter_time_t)
      class default
         ! another contact, such as one with adhesion
         is_there = .false.
      end select
      if (is_there) then
         call solve_cycle_with_slopes(values, self%given, self%lists, x, by, members, y, y_by, is_known, error_estimate, is_there)
      else
         y = 0
         y_by = 0
         is_known = .false.
         error_estimate = 0
      end if
   end subroutine solve_with_slopes

   !> Go through the history.
   subroutine follow(self, contact, states, n_per_leg, n_before, is_smoothed, steps, results, status)
      class(indenter_time_t), intent(in) :: self
      type(timed_contact_t), intent(inout) :: contact
      type(indenter_states_t), intent(in) :: states
      !> Steps of each leg, and legs before those that are written.
      integer, intent(in) :: n_per_leg, n_before
      !> Are there fewer legs than those of the list?
      logical, intent(in) :: is_smoothed
      !> Receives the steps in SI units; shape `(n_steps, n_timed_profiles)`.
      real(dp), intent(out) :: steps(:, :)
      !> Receives the results in SI units.
      real(dp), intent(inout) :: results(:)
      !> Receives one of `status_...`.
      integer, intent(out) :: status
      type(timed_panel_t) :: panel
      type(oscillation_t) :: oscillation
      type(timed_course_t) :: course
      real(dp) :: clock, loss
      integer :: leg, widest
      logical :: is_solved, had_contact

      status = status_not_converged
      loss = not_a_number()
      clock = 0
      steps = 0
      course%states = states
      if (allocated(self%lists%times)) course%begin = self%lists%times(1)
      if (n_before == 0 .and. contact%control%by_approach > 0) steps(1, p_approach) = contact%legs(1)%begin
      do while (.not. contact%is_done)
         if (self%is_stopped()) return
         leg = contact%leg
         ! the contact that rests before a sine
         if (.not. oscillation%radius > 0 .and. abs(contact%legs(leg)%amplitude) > 0) oscillation%radius = contact%radius
         had_contact = contact%radius > 0
         call advance(contact, panel, is_solved)
         if (.not. is_solved) return
         clock = panel%clock + panel%span
         if (contact%radius > 0) loss = not_a_number()
         ! contact may be lost before the panel, or at its end
         if (.not. contact%radius > 0 .and. had_contact) loss = panel%clock
         if (.not. contact%radius > 0 .and. panel%radius(1) > 0) loss = clock
         if (is_smoothed) then
            call course%keep(panel)
         else
            call write_steps(contact, panel, leg, n_per_leg, n_before, steps)
         end if
         if (leg == size(contact%legs) .and. abs(contact%legs(leg)%amplitude) > 0) &
            & call add_oscillation(oscillation, contact%legs(leg), panel)
      end do
      if (is_smoothed) call read_steps(course, self%lists%times, n_per_leg, steps)
      associate (case => states%case)
         steps(:, p_approach) = steps(:, p_approach)*case%height_unit
         steps(:, p_load) = steps(:, p_load)*case%force_unit()
         steps(:, p_radius) = steps(:, p_radius)*case%length_unit
         steps(:, p_area) = pi*steps(:, p_radius)**2
         steps(:, p_stiffness) = 2*steps(:, p_radius)*contact%glassy*case%modulus
         ! the first of those that are as wide but for the tolerance
         widest = findloc(steps(:, p_radius) >= maxval(steps(:, p_radius))*(1 - contact%tolerance), .true., 1)
         results(out%largest_load) = maxval(steps(:, p_load))
         results(out%largest_approach) = maxval(steps(:, p_approach))
         results(out%largest_contact_radius) = steps(widest, p_radius)
         results(out%time_of_largest_contact) = steps(widest, p_time)
         results(out%loss_time) = loss
         if (oscillation%radius > 0 .and. .not. oscillation%is_lost) then
            call get_moduli(oscillation, case%modulus, results(out%storage_modulus), results(out%loss_modulus))
            ! both are differences of loads
            associate (of_loads => max(abs(results(out%storage_modulus)), results(out%largest_load)/(2*oscillation%radius* &
               & case%length_unit*abs(contact%legs(size(contact%legs))%amplitude)*case%height_unit)))
               call clear(contact, results(out%loss_modulus), of_loads)
            end associate
         end if
         call take_energies(contact, states, results)
      end associate
      status = status_solved

   end subroutine follow

   !> Work, and what of it is stored and lost.
   subroutine take_energies(contact, states, results)
      !> The contact at the end of its history, with its units.
      type(timed_contact_t), intent(in) :: contact
      type(indenter_states_t), intent(in) :: states
      !> Receives the energies in SI units.
      real(dp), intent(inout) :: results(:)
      real(dp), parameter :: most_missing = 1.0e-2_dp
      real(dp) :: stored

      associate (energy => contact%energy, unit => states%case%force_unit()*states%case%height_unit)
         stored = stored_in_contact(energy, contact%timed_springs_t)
         results(out%path_work) = energy%work*unit
         results(out%elastic_energy) = (stored + stored_free(contact%timed_springs_t))*unit
         results(out%dissipated_energy) = results(out%path_work) - results(out%elastic_energy)
         call clear(contact, results(out%path_work), energy%largest_work*unit)
         call clear(contact, results(out%dissipated_energy), energy%largest_work*unit)
         results(out%energy_imbalance) = (energy%work - stored - energy%lost - energy%carried)/energy%largest_work
      end associate
      ! where the balance fails, as of profiles with very high powers of r, energies have no value
      if (.not. abs(results(out%energy_imbalance)) <= most_missing) results([out%path_work, out%elastic_energy, &
         & out%dissipated_energy, out%energy_imbalance]) = not_a_number()
   end subroutine take_energies

   !> What is no more than the error of a size is 0.
   pure subroutine clear(contact, value, size)
      type(timed_contact_t), intent(in) :: contact
      real(dp), intent(inout) :: value
      real(dp), intent(in) :: size
      real(dp), parameter :: digits = 10

      if (abs(value) <= digits*error_of(contact)*abs(size)) value = 0
   end subroutine clear

   !> The steps that a panel has, in units of the contact.
   pure subroutine write_steps(contact, panel, leg, n_per_leg, n_before, steps)
      type(timed_contact_t), intent(in) :: contact
      type(timed_panel_t), intent(in) :: panel
      !> Leg of the panel.
      integer, intent(in) :: leg, n_per_leg, n_before
      real(dp), intent(inout) :: steps(:, :)
      real(dp), parameter :: round_off = 8*epsilon(1.0_dp)
      real(dp) :: weights(n_nodes), phase, moment
      integer :: k, step

      do k = merge(n_per_leg, max(1, ceiling(panel%phase*n_per_leg*(1 - round_off))), leg <= n_before), n_per_leg
         phase = real(k, dp)/n_per_leg
         if (phase > (panel%phase + panel%phase_span)*(1 + round_off)) exit
         step = 1 + (leg - n_before - 1)*n_per_leg + k
         call get_weights(min(1.0_dp, max(-1.0_dp, 2*(phase - panel%phase)/panel%phase_span - 1)), weights)
         steps(step, p_time) = panel%clock + panel%span*min(1.0_dp, (phase - panel%phase)/panel%phase_span)
         steps(step, p_approach) = dot_product(weights, panel%approach)
         steps(step, p_load) = max(0.0_dp, dot_product(weights, panel%load))
         steps(step, p_radius) = 0
         if (maxval(panel%radius) > 0) call get_spot(contact%contacts, dot_product(weights, panel%depth), &
            & steps(step, p_radius), moment)
      end do
   end subroutine write_steps

   !> See `model_t`: the largest contact of the history.
   subroutine measure(self, values, results, measures)
      class(indenter_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> What `solve_point` has found; shape `(n_results)`.
      real(dp), intent(in) :: results(:)
      !> In: all `not_measured`. Out: with what is measured; shape `(n_doubts)`.
      real(dp), intent(inout) :: measures(:)

      call measure_edge(values, results(out%largest_contact_radius), measures)
      associate (unused => self)
      end associate
   end subroutine measure

   !> See `model_t`: the coefficient of r^n has a unit that depends on n, and smoothing that of its list.
   function unit_of(self, values, index) result(unit)
      class(indenter_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Index of the variable.
      integer, intent(in) :: index
      character(:), allocatable :: unit

      unit = indenter_unit_of(self%variables, values, index)
      associate (history => values(before_history + 1:))
         if (index == before_history + timed_input%smoothing) unit = merge('N', 'm', is_set(history(timed_input%loads)))
      end associate
   end function unit_of

end module adfric_round_timed_model
