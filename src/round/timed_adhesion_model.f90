! SPDX-License-Identifier: GPL-3.0-or-later
!> The model `adhesive_indenter_time`: an indenter of any axisymmetric shape on a viscoelastic half-space through a history in time,
!> with adhesion of Dugdale's law. Its first rows are those of `indenter_time`.
module adfric_round_timed_adhesion_model
   use adfric_base_kinds, only: dp
   use adfric_base_constants, only: pi
   use adfric_base_problems, only: problems_t
   use adfric_base_text, only: show_count, show_number
   use adfric_base_unset, only: is_set
   use adfric_describe_check, only: checks_t, new_checks
   use adfric_describe_pointwise, only: point_state_t
   use adfric_describe_status, only: status_no_equilibrium, status_not_converged, status_solved
   use adfric_describe_stepwise, only: steps_t
   use adfric_describe_table, only: variable_t
   use adfric_round_check, only: check_adhesion
   use adfric_round_dugdale_curve, only: dugdale_curve_t
   use adfric_round_timed_adhesion_contact, only: adhesive_contact_t, advance_to, start_adhesive_contact
   use adfric_round_timed_adhesion_limits, only: find_limits, pull_off_limits_t
   use adfric_round_timed_adhesion_path, only: c_adhesion, c_approach, c_contact, c_load, c_time, close_path, difference_of, &
      & extrapolate, n_columns, o_adhesion, o_approach, o_clock, o_jump_approach, o_jump_load, o_load, o_loss, o_stored, o_taken, &
      & o_work, zone_outcome_t, read_outcome
   use adfric_round_timed_adhesion_rows, only: adhesion_input, more => adhesion_output, most_cells, n_adhesion_profiles, &
      & n_adhesion_results, n_adhesion_rows, p_adhesion_radius, set_adhesion_profiles, set_adhesion_results, set_adhesion_rows
   use adfric_round_timed_adhesion_setting, only: set_up, setting_t, values_of_indenter
   use adfric_round_timed_adhesion_trigger, only: find_adhesive_trigger
   use adfric_round_timed_history, only: path_sine, pressing_under, timed_input
   use adfric_round_timed_model, only: indenter_time_t, set_timed_rows
   use adfric_round_timed_rows, only: n_timed_results, out => timed_output, p_approach, p_area, p_load, p_radius, p_stiffness, &
      & p_time
   use adfric_round_timed_setting, only: before_history, n_timed_variables
   use adfric_round_variables, only: get_indenter_variables, in => indenter_input, n_indenter_variables
   implicit none (type, external)
   private
   public :: adhesive_indenter_time_t, new_adhesive_indenter_time

   !> Number of variables.
   integer, parameter :: n_variables = n_timed_variables + n_adhesion_rows
   !> Fewest cells of a zone.
   real(dp), parameter :: fewest_per_zone = 6
   !> Energy that may be missing on the last grid, over the largest one.
   real(dp), parameter :: most_missing = 1.0e-2_dp

   !> The model.
   type, extends(indenter_time_t) :: adhesive_indenter_time_t
   contains
      procedure :: check_values
      procedure :: solve_point
   end type adhesive_indenter_time_t

contains

   !> The model with its tables.
   subroutine new_adhesive_indenter_time(self)
      !> Receives its names and its tables.
      type(adhesive_indenter_time_t), intent(out) :: self
      type(variable_t), allocatable :: rows(:)

      self%name = 'adhesive_indenter_time'
      self%summary = 'an indenter with adhesion on a viscoelastic half-space in time'
      self%references = 'T. C. T. Ting, J. Appl. Mech. 33 (1966) 845; D. Maugis, J. Colloid Interface Sci. 150 (1992) 243'
      allocate (rows, source=get_indenter_variables())
      allocate (self%variables(n_variables))
      call set_timed_rows(rows, self%variables(:n_timed_variables))
      call set_adhesion_rows(rows, self%variables(n_timed_variables + 1:))
      associate (tolerance => self%variables(before_history + timed_input%relative_tolerance), &
         & loads => self%variables(before_history + timed_input%loads), &
         & top => self%variables(before_history + timed_input%largest_approach), &
         & base_top => self%variables(before_history + timed_input%largest_base_approach))
         tolerance%default = 1.0e-3_dp
         tolerance%lower = 1.0e-7_dp
         tolerance%upper = 1.0e-2_dp
         tolerance%meaning = 'largest error of approach and load over the largest ones, and of the pull-off load over '// &
            & 'itself, as grids tell'
         ! pulled
         loads%lower = -huge(loads%lower)
         ! within the range it adheres without being pressed
         top%lower = -top%upper
         base_top%lower = -base_top%upper
      end associate
      allocate (self%results(n_timed_results + n_adhesion_results))
      call set_adhesion_results(self%results)
      allocate (self%profiles(n_adhesion_profiles))
      call set_adhesion_profiles(self%profiles)
      self%profile_axes = 'step'
      allocate (self%counts(0))
   end subroutine new_adhesive_indenter_time

   !> See `model_t`.
   subroutine check_values(self, values, is_swept, problems)
      class(adhesive_indenter_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Is the variable swept? Shape `(n_variables)`.
      logical, intent(in) :: is_swept(:)
      !> Receives what is wrong with the input; nothing is removed.
      type(problems_t), intent(inout) :: problems
      type(checks_t) :: c
      type(setting_t) :: setting
      ! largest number of cells that a message tells
      real(dp), parameter :: most_shown = 1.0e9_dp
      real(dp) :: own(size(values))
      integer :: before
      logical :: is_found

      before = problems%count()
      call check_own(self, values, problems)
      if (problems%count() > before) return
      call self%indenter_time_t%check_values(values, is_swept, problems)
      if (problems%count() > before) return
      call new_checks(c, self%variables, values, problems)
      ! where a load ends pressing, cells are those of the relaxed contact under it
      own = values
      if (is_set(values(before_history + timed_input%trigger_load))) own(before_history + 1:n_timed_variables) = &
         & pressing_under(values(before_history + 1:n_timed_variables))
      call set_up(self, own, setting, is_found)
      if (.not. is_found) then
         call problems%add('surface', 'kind', 'is too small for this history: adhesion would reach beyond the body, or numbers '// &
            & 'beyond 1e308')
         return
      end if
      associate (needed => setting%largest%adhesion_radius/setting%cell*fewest_per_zone/setting%per_zone)
         if (needed > most_cells) then
            call c%add(n_timed_variables + adhesion_input%work_of_adhesion, 'has so short a range that its zone needs '// &
               & show_count(ceiling(min(needed, most_shown)))//trim(merge(' or more', '        ', needed > most_shown))// &
               & ' cells up to the edge, and '//show_count(most_cells)//' are the most; give a longer range')
         else
            call c%add(n_timed_variables + adhesion_input%cells, 'are '//show_number(aint(100*setting%per_zone)/100)// &
               & ' in the zone of adhesion, which needs 6; give '//show_count(ceiling(needed))//' or more', &
               & setting%per_zone < fewest_per_zone .and. values(n_timed_variables + adhesion_input%cells) > 0)
         end if
      end associate
   end subroutine check_values

   !> What adhesion needs, and what has no meaning beside it.
   subroutine check_own(self, values, problems)
      class(adhesive_indenter_time_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      type(problems_t), intent(inout) :: problems
      type(variable_t), allocatable :: rows(:)
      real(dp) :: indenter(n_indenter_variables)
      type(checks_t) :: c
      integer, parameter :: first = n_timed_variables

      allocate (rows, source=get_indenter_variables())
      rows(:in%coefficient_8) = self%variables(:in%coefficient_8)
      rows(in%work_of_adhesion:in%lambda) = self%variables(first + 1:first + adhesion_input%lambda)
      indenter = values_of_indenter(values)
      call new_checks(c, self%variables, values, problems)
      if (c%has(first + adhesion_input%work_of_adhesion) .and. &
         & .not. any(is_set(indenter(in%adhesion_stress:in%lambda)))) then
         call c%add(first + adhesion_input%work_of_adhesion, 'has no range, which adhesion in time needs: give '// &
            & 'adhesion_stress, adhesion_range or lambda (a work that depends on speed is no model of it)')
         return
      end if
      associate (path => before_history + timed_input%path)
         if (c%has(path)) call c%add(path, 'is ''sine'', whose moduli have no meaning with adhesion; give times and approaches', &
            & c%is_choice(path, path_sine))
      end associate
      call c%refuse(before_history + [timed_input%smoothing], 'has no solver with adhesion; smooth the list before')
      call c%refuse(before_history + [timed_input%time], 'cannot be fitted over with adhesion; there is no such solver')
      call new_checks(c, rows, indenter, problems)
      call check_adhesion(c)
   end subroutine check_own

   !> See `pointwise_model_t`.
   subroutine solve_point(self, values, state, results, error_estimate, status, counts)
      class(adhesive_indenter_time_t), intent(in) :: self
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Receives the steps, for the profiles; nothing is taken from the point before.
      class(point_state_t), allocatable, intent(inout) :: state
      !> In: all NaN. Out: results of the point, NaN where there is no value; shape `(n_results)`.
      real(dp), intent(inout) :: results(:)
      !> Largest error of approach and load over the largest ones, and of the pull-off load over itself.
      real(dp), intent(out) :: error_estimate
      !> One of `status_...`.
      integer, intent(out) :: status
      !> This model counts nothing; size 0.
      real(dp), intent(inout) :: counts(:)
      type(setting_t) :: setting
      type(zone_outcome_t) :: best
      type(steps_t), allocatable :: found
      real(dp) :: own(size(values))
      logical :: is_found

      error_estimate = 0
      own = values
      status = status_not_converged
      call find_adhesive_trigger(self, own, is_found)
      if (.not. is_found) return
      status = status_no_equilibrium
      call set_up(self, own, setting, is_found)
      if (.not. is_found) return
      if (setting%per_zone < fewest_per_zone .or. setting%largest%adhesion_radius/setting%cell > 2*most_cells) return
      call refine(self, setting, values(before_history + timed_input%relative_tolerance), best, error_estimate, status)
      if (status /= status_solved) return
      allocate (found)
      allocate (found%steps(size(best%steps, 1), n_adhesion_profiles))
      call write_results(setting, best, found%steps, results)
      ! times as they are given, from the first one on
      if (allocated(self%lists%times)) then
         found%steps(:, p_time) = found%steps(:, p_time) + self%lists%times(1)
         associate (clocks => [out%loss_time, out%time_of_largest_contact, n_timed_results + more%pull_off_time])
            results(clocks) = results(clocks) + self%lists%times(1)
         end associate
      end if
      call move_alloc(found, state)
      associate (unused => counts)
      end associate
   end subroutine solve_point

   !> Grids, each with cells half as wide as the one before, until they agree. Two grids may be alike and both be wrong, where a zone
   !> has few cells: the error is what a third one changes of the answer of two. The last grid is as fine as it has to be. There the
   !> ratio q of cells is below 2. Let a number be V + a h^2 + b h^m. Two grids with cells h and q h say together V + r b h^m with
   !> r = 1 - (q^m - 1)/(q^2 - 1), which a smaller q makes smaller: what a third grid changes is still above the error. What is not
   !> regular is multiplied by 1/(q^2 - 1), so q is 2 until the error has fallen as that of a regular one.
   subroutine refine(self, setting, tolerance, best, error, status)
      class(adhesive_indenter_time_t), intent(in) :: self
      type(setting_t), intent(inout) :: setting
      !> Largest error.
      real(dp), intent(in) :: tolerance
      type(zone_outcome_t), intent(out) :: best
      !> Error, as estimated.
      real(dp), intent(out) :: error
      integer, intent(out) :: status
      integer, parameter :: most_grids = 9
      real(dp), parameter :: first_fineness = 0.1_dp, after_loss = 0.05_dp
      ! of the difference of two grids what is counted, where it has fallen as of second order, and else
      real(dp), parameter :: second_order = 0.1_dp, any_order = 0.25_dp, least_power = 1.5_dp
      type(zone_outcome_t) :: coarse, fine, last
      real(dp) :: top, change, last_change, last_error, cell, ratio
      integer :: grid
      logical :: is_solved

      status = status_not_converged
      error = huge(error)
      last_change = 0
      last_error = 0
      cell = 2*setting%cell
      if (setting%is_closed) then
         ! where contact is lost, on a grid twice as coarse
         call follow(self, setting, cell, 2*first_fineness, coarse, is_solved)
         if (.not. is_solved) return
         top = maxval(setting%legs%end)
         if (coarse%lost_at < huge(top)) call close_path(setting%legs, setting%legs(1)%begin, &
            & coarse%lost_at - after_loss*(top - coarse%lost_at))
      end if
      call follow(self, setting, cell, 2*first_fineness, coarse, is_solved)
      if (.not. is_solved) return
      do grid = 2, most_grids
         ratio = 2
         ! before there are two errors there is nothing to compare
         if (grid > 4) then
            if (error*2**least_power <= last_error) ratio = next_ratio(setting, cell, error, tolerance)
         end if
         last_error = error
         cell = cell/ratio
         if (setting%largest%adhesion_radius/cell > 2*most_cells) exit
         call follow(self, setting, cell, first_fineness*cell/setting%cell, fine, is_solved)
         if (.not. is_solved) return
         call extrapolate(coarse, fine, ratio, best)
         ! as if cells were half as wide
         change = difference_of(fine, coarse)*3/(ratio**2 - 1)
         if (grid > 2) error = max(difference_of(best, last), &
            & merge(second_order, any_order, change*ratio**least_power <= last_change)*change)
         last_change = change
         last = best
         coarse = fine
         if (error <= tolerance .and. fine%narrowest > fewest_per_zone) exit
      end do
      if (error <= tolerance .and. fine%narrowest > fewest_per_zone .and. abs(fine%imbalance) <= most_missing) &
         & status = status_solved
   end subroutine refine

   !> Cells over those of the next grid.
   pure real(dp) function next_ratio(setting, cell, error, tolerance) result(ratio)
      type(setting_t), intent(in) :: setting
      !> Width of the cells, and the error with them.
      real(dp), intent(in) :: cell, error, tolerance
      ! the least power of cells by which errors are expected to fall, what of the tolerance is aimed at, and the least ratio
      real(dp), parameter :: power = 2.5_dp, aim = 0.8_dp, least = 1.25_dp

      ratio = 2
      if (error < aim*tolerance*2**power) ratio = max(least, (error/(aim*tolerance))**(1/power))
      ! the kink at a corner stays a node
      associate (corner => setting%case%curve%shape%corner)
         if (corner > 0) ratio = ceiling(ratio*anint(corner/cell))/anint(corner/cell)
      end associate
   end function next_ratio

   !> Go through the history on one grid.
   subroutine follow(self, setting, cell, fineness, outcome, is_solved)
      class(adhesive_indenter_time_t), intent(in) :: self
      type(setting_t), intent(in) :: setting
      !> Width of the cells, and longest step over the time since the last kink.
      real(dp), intent(in) :: cell, fineness
      type(zone_outcome_t), intent(out) :: outcome
      logical, intent(out) :: is_solved
      type(adhesive_contact_t) :: contact
      integer :: leg, k, n, step

      call start_adhesive_contact(contact, setting%solid, setting%case%curve%shape, setting%stress, setting%range, cell, &
         & setting%control, setting%legs)
      contact%fineness = fineness
      allocate (outcome%steps(1 + (size(setting%legs) - setting%n_before)*setting%n_per_leg, n_columns), source=0.0_dp)
      step = 1
      call note(0.0_dp)
      do leg = 1, size(setting%legs)
         n = merge(1, setting%n_per_leg, leg <= setting%n_before)
         if (leg > setting%n_before) step = 1 + (leg - setting%n_before - 1)*setting%n_per_leg
         do k = 1, n
            is_solved = .not. self%is_stopped()
            if (is_solved) call advance_to(contact, real(k, dp)/n, is_solved)
            if (.not. is_solved) return
            if (leg > setting%n_before) step = step + 1
            call note(setting%legs(leg)%clock + setting%legs(leg)%span*k/n)
         end do
      end do
      call read_outcome(contact, outcome)

   contains

      !> Write a step.
      subroutine note(clock)
         real(dp), intent(in) :: clock

         associate (state => contact%state)
            outcome%steps(step, [c_time, c_approach, c_load, c_contact, c_adhesion]) = [clock, state%approach, state%load, &
               & state%a, contact%problem%adhesion_radius(state%c)]
         end associate
      end subroutine note

   end subroutine follow

   !> Steps and results in SI units.
   pure subroutine write_results(setting, best, steps, results)
      type(setting_t), intent(in) :: setting
      type(zone_outcome_t), intent(in) :: best
      !> Receives the steps; shape `(n_steps, n_adhesion_profiles)`.
      real(dp), intent(out) :: steps(:, :)
      real(dp), intent(inout) :: results(:)
      type(pull_off_limits_t) :: limits
      real(dp) :: glassy
      integer :: widest

      glassy = setting%solid%instantaneous_modulus()
      associate (case => setting%case, first => n_timed_results)
         associate (height => case%height_unit, force => case%force_unit(), numbers => best%numbers)
            steps(:, p_time) = best%steps(:, c_time)
            steps(:, p_approach) = best%steps(:, c_approach)*height
            steps(:, p_load) = best%steps(:, c_load)*force
            steps(:, p_radius) = best%steps(:, c_contact)*case%length_unit
            steps(:, p_adhesion_radius) = best%steps(:, c_adhesion)*case%length_unit
            steps(:, p_area) = pi*steps(:, p_radius)**2
            steps(:, p_stiffness) = 2*steps(:, p_radius)*glassy*case%modulus
            widest = maxloc(steps(:, p_radius), 1)
            results(out%largest_load) = maxval(steps(:, p_load))
            results(out%largest_approach) = maxval(steps(:, p_approach), steps(:, p_adhesion_radius) > 0)
            results(out%largest_contact_radius) = steps(widest, p_radius)
            results(out%time_of_largest_contact) = steps(widest, p_time)
            results(out%loss_time) = numbers(o_loss)
            results(out%path_work) = numbers(o_work)*force*height
            results(out%elastic_energy) = numbers(o_stored)*force*height
            results(out%dissipated_energy) = numbers(o_taken)*force*height
            results(out%energy_imbalance) = best%imbalance
            results(first + more%pull_off_load) = numbers(o_load)*force
            results(first + more%pull_off_approach) = numbers(o_approach)*height
            results(first + more%pull_off_time) = numbers(o_clock)
            results(first + more%jump_in_approach) = numbers(o_jump_approach)*height
            results(first + more%jump_in_load) = numbers(o_jump_load)*force
            results(first + more%jumps) = best%n_jumps
            results(first + more%adhesion_energy) = numbers(o_adhesion)*force*height
            if (best%narrowest < huge(glassy)) results(first + more%cells_per_zone) = best%narrowest
            select type (curve => case%curve)
            type is (dugdale_curve_t)
               call find_limits(curve, glassy, setting%largest, setting%control, limits)
            end select
            results(first + more%relaxed_pull_off_load) = limits%relaxed*force
            results(first + more%glassy_pull_off_load) = limits%glassy*force
            results(first + more%frozen_pull_off_load) = limits%frozen*force
         end associate
      end associate
   end subroutine write_results

end module adfric_round_timed_adhesion_model
