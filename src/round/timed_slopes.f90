! SPDX-License-Identifier: GPL-3.0-or-later
!> The load of one cycle at times of a fit, with its derivatives by the variables of the model `indenter_time`.
module adfric_round_timed_slopes
   use adfric_base_kinds, only: dp
   use adfric_round_indenter_states, only: indenter_states_t
   use adfric_round_timed_cycle, only: new_cycle, timed_cycle_t
   use adfric_round_timed_cycle_slopes, only: cycle_change_t, get_loads, new_cycle_change
   use adfric_round_timed_history, only: has_power_law, n_timed_rows, timed_input, timed_lists_t
   use adfric_round_timed_setting, only: before_history, before_solid, get_power_law_of, set_up_history, timed_setting_t
   use adfric_solid_given_spectrum, only: given_spectrum_t
   use adfric_solid_prony, only: prony_t
   use adfric_solid_spectrum_rows, only: get_spectrum, get_spectrum_slopes, shift_factor_of
   implicit none (type, external)
   private
   public :: solve_cycle_with_slopes

contains

   !> The load of one cycle, by moduli and times of the solid, and by zero and drift of the approach.
   subroutine solve_cycle_with_slopes(values, given, lists, x, by, members, y, y_by, is_known, error_estimate, is_there)
      !> Values of the variables; shape `(n_variables)`. That of the time is any.
      real(dp), intent(in) :: values(:)
      !> Lists of the solid and of the history.
      type(given_spectrum_t), intent(in) :: given
      type(timed_lists_t), intent(in) :: lists
      !> Times [s]; shape `(n_points)`, one at least.
      real(dp), intent(in) :: x(:)
      !> Indices of the variables by which derivatives are wanted, and which member of a list it is, 0: none; shape `(n_wanted)`.
      integer, intent(in) :: by(:), members(:)
      !> Receives the load [N]; shape `(n_points)`.
      real(dp), intent(out) :: y(:)
      !> Receives the derivatives, 0 where they are not known; shape `(n_points, n_wanted)`.
      real(dp), intent(out) :: y_by(:, :)
      !> Receives by which variables the derivatives are known; shape `(n_wanted)`.
      logical, intent(out) :: is_known(:)
      !> Error of the load over the largest one, estimated.
      real(dp), intent(out) :: error_estimate
      !> Receives whether the history is one cycle with all these points; else nothing else has a meaning.
      logical, intent(out) :: is_there
      real(dp), parameter :: round_off = 16*epsilon(1.0_dp)
      type(timed_setting_t) :: setting
      type(indenter_states_t) :: states
      type(timed_cycle_t) :: cycle
      type(cycle_change_t) :: changes(size(by))
      real(dp) :: own(size(values)), begin
      integer :: k

      y = 0
      y_by = 0
      is_known = .false.
      error_estimate = 0
      own = values
      own(before_history + timed_input%time) = x(1)
      call set_up_history(own, given, lists, setting, states, is_there)
      if (is_there) call new_cycle(cycle, setting%solid, states, setting%control, setting%legs, setting%tolerance)
      begin = 0
      if (allocated(lists%times)) begin = lists%times(1)
      is_there = cycle%is_found
      if (is_there) is_there = all(x - begin >= -round_off*abs(x)) .and. &
         & all(x - begin <= cycle%end + round_off*(abs(x) + abs(begin)))
      if (.not. is_there) return
      error_estimate = cycle%error
      do k = 1, size(by)
         call get_change(own, given, lists, setting, states, by(k), members(k), begin, changes(k), is_known(k))
      end do
      call get_loads(cycle, states, x - begin, changes, y, y_by)
      y = y*states%case%force_unit()
      y_by = y_by*states%case%force_unit()
   end subroutine solve_cycle_with_slopes

   !> Derivatives of the numbers of a cycle, in its units, by a variable.
   subroutine get_change(values, given, lists, setting, states, by, member, begin, change, is_known)
      !> Values of the variables; shape `(n_variables)`.
      real(dp), intent(in) :: values(:)
      !> Lists of the solid and of the history.
      type(given_spectrum_t), intent(in) :: given
      type(timed_lists_t), intent(in) :: lists
      !> Solid and path of the cycle, and its units.
      type(timed_setting_t), intent(in) :: setting
      type(indenter_states_t), intent(in) :: states
      !> Index of the variable, and number of the member of a list; 0: none.
      integer, intent(in) :: by, member
      !> Time at the begin of the history [s].
      real(dp), intent(in) :: begin
      !> Receives the derivatives; 0 where they are not known.
      type(cycle_change_t), intent(out) :: change
      !> Receives whether they are known.
      logical, intent(out) :: is_known
      !> Step of the exponent of a power law: its error is far below that of the arms.
      real(dp), parameter :: step = 1.0e-5_dp
      type(prony_t) :: solid, below
      real(dp) :: history(n_timed_rows)

      is_known = .true.
      history = values(before_history + 1:)
      call new_cycle_change(change, size(setting%solid%times))
      associate (row => by - before_history, modulus => states%case%modulus)
         if (row == timed_input%contact_point) then
            change%shift = -1/states%case%height_unit
         else if (row == timed_input%drift_rate) then
            change%drift = 1/states%case%height_unit
            change%shift = begin/states%case%height_unit
         else if (.not. has_power_law(history)) then
            is_known = by > before_solid .and. row <= 0
            if (.not. is_known) return
            associate (rows => values(before_solid + 1:before_history))
               call get_spectrum(rows, given, solid)
               is_known = size(solid%times) == size(setting%solid%times)
               if (is_known) call get_spectrum_slopes(rows, given, solid, by - before_solid, member, change%relaxed, &
                  & change%moduli, change%times, is_known)
               change%relaxed = change%relaxed/modulus
               change%moduli = change%moduli/modulus
               change%times = change%times*shift_factor_of(rows, given)
            end associate
         else if (row == timed_input%power_law_modulus) then
            change%relaxed = setting%solid%relaxed/history(row)
            change%moduli = setting%solid%moduli/history(row)
         else if (row == timed_input%power_law_exponent) then
            history(row) = history(row) - step
            call get_power_law_of(history, lists, below)
            history(row) = history(row) + 2*step
            call get_power_law_of(history, lists, solid)
            change%relaxed = (solid%relaxed - below%relaxed)/(2*step*modulus)
            change%moduli = (solid%moduli - below%moduli)/(2*step*modulus)
            change%times = (solid%times - below%times)/(2*step)
         else
            is_known = .false.
         end if
      end associate
   end subroutine get_change

end module adfric_round_timed_slopes
