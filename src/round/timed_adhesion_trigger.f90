! SPDX-License-Identifier: GPL-3.0-or-later
!> Pressing with adhesion that ends where a load is reached: the approach there. The contact is pressed at the same speed up to a
!> larger approach, on grids that become finer until what two of them say together stays.
module adfric_round_timed_adhesion_trigger
   use adfric_base_kinds, only: dp
   use adfric_base_unset, only: is_set, unset
   use adfric_round_timed_adhesion_contact, only: adhesive_contact_t, advance_to, start_adhesive_contact
   use adfric_round_timed_adhesion_setting, only: set_up, setting_t
   use adfric_round_timed_history, only: pressing_alone, pressing_under, timed_input, top_row
   use adfric_round_timed_model, only: indenter_time_t
   use adfric_round_timed_setting, only: before_history, n_timed_variables
   implicit none (type, external)
   private
   public :: find_adhesive_trigger

contains

   !> The approach at the end of pressing in place of the load that ends it.
   subroutine find_adhesive_trigger(self, values, is_found)
      !> The lists of the history and of the solid.
      class(indenter_time_t), intent(in) :: self
      !> In: values of the variables; shape `(n_variables)`. Out: the same without the load, if there is one.
      real(dp), intent(inout) :: values(:)
      !> Was it found, or is there none?
      logical, intent(out) :: is_found
      integer, parameter :: most_tries = 40, most_grids = 8
      ! what of the tolerance the turn may be off, and what of the difference of two grids counts
      real(dp), parameter :: share = 0.25_dp, second_order = 0.1_dp
      type(setting_t) :: setting
      real(dp) :: own(size(values)), trigger, top, rest, last, best, before
      integer :: try, grid

      associate (history => values(before_history + 1:n_timed_variables))
         trigger = history(timed_input%trigger_load)
         is_found = .not. is_set(trigger)
         if (is_found) return
         ! adhesion lowers the load at an approach, and a solid that has not relaxed raises it
         call relaxed_top(self, values, top, is_found)
         do try = 1, most_tries
            if (.not. is_found) return
            own = values
            own(before_history + 1:n_timed_variables) = pressing_alone(history, top)
            call set_up(self, own, setting, is_found)
            if (.not. is_found) return
            call press(self, setting, trigger, 2.0_dp, rest, is_found)
            if (.not. is_found) return
            if (rest >= 0) exit
            top = 2*top
         end do
         is_found = rest >= 0
         if (.not. is_found) return
         best = huge(best)
         do grid = 1, most_grids
            last = rest
            before = best
            call press(self, setting, trigger, 1/2.0_dp**(grid - 1), rest, is_found)
            if (.not. is_found) return
            best = rest + (rest - last)/3
            associate (span => setting%legs(size(setting%legs))%span, tolerance => history(timed_input%relative_tolerance))
               is_found = max(second_order*abs(rest - last), abs(best - before)) <= share*tolerance*(span - best)
            end associate
            if (is_found) exit
         end do
         if (.not. is_found) return
         history(top_row(history)) = top - history(timed_input%approach_rate)*best
         history(timed_input%trigger_load) = unset
      end associate
   end subroutine find_adhesive_trigger

   !> The approach of the relaxed contact under the load.
   subroutine relaxed_top(self, values, top, is_found)
      class(indenter_time_t), intent(in) :: self
      real(dp), intent(in) :: values(:)
      !> Receives the approach [m], before its zero is taken off.
      real(dp), intent(out) :: top
      logical, intent(out) :: is_found
      type(setting_t) :: setting
      real(dp) :: own(size(values))

      own = values
      associate (history => values(before_history + 1:n_timed_variables))
         own(before_history + 1:n_timed_variables) = pressing_under(history)
         call set_up(self, own, setting, is_found)
         top = 0
         if (.not. is_found) return
         top = setting%largest%approach*setting%case%height_unit
         if (is_set(history(timed_input%machine_stiffness))) top = top + &
            & history(timed_input%trigger_load)/history(timed_input%machine_stiffness)
         top = max(top, setting%range*setting%case%height_unit) + max(0.0_dp, history(timed_input%contact_point))
      end associate
   end subroutine relaxed_top

   !> Press on one grid: the time that remains of pressing where the load is reached.
   subroutine press(self, setting, trigger, coarseness, rest, is_solved)
      class(indenter_time_t), intent(in) :: self
      type(setting_t), intent(in) :: setting
      !> The load [N].
      real(dp), intent(in) :: trigger
      !> Cells and steps over those of the first grid.
      real(dp), intent(in) :: coarseness
      !> Receives the time; below 0 where the load is not reached.
      real(dp), intent(out) :: rest
      logical, intent(out) :: is_solved
      integer, parameter :: n_looks = 64, most_steps = 60
      real(dp), parameter :: fineness = 0.1_dp, fine = 1.0e-12_dp
      type(adhesive_contact_t) :: contact, begin
      real(dp) :: wanted, low, high, phase, at_low, at_high
      integer :: k, last

      rest = -1
      call start_adhesive_contact(contact, setting%solid, setting%case%curve%shape, setting%stress, setting%range, &
         & setting%cell*coarseness, setting%control, setting%legs)
      contact%fineness = fineness*coarseness
      wanted = trigger/setting%case%force_unit()
      last = size(setting%legs)
      do k = 1, last - 1
         call advance_to(contact, 1.0_dp, is_solved)
         if (.not. is_solved) return
      end do
      do k = 1, n_looks
         begin = contact
         is_solved = .not. self%is_stopped()
         if (is_solved) call advance_to(contact, real(k, dp)/n_looks, is_solved)
         if (.not. is_solved) return
         if (contact%state%load >= wanted) exit
      end do
      if (k > n_looks) return
      ! secants between two phases, and halves
      low = real(k - 1, dp)/n_looks
      high = real(k, dp)/n_looks
      at_low = begin%state%load - wanted
      at_high = contact%state%load - wanted
      do k = 1, most_steps
         phase = (low*at_high - high*at_low)/(at_high - at_low)
         if (modulo(k, 3) == 0) phase = (low + high)/2
         if (high - low <= fine .or. .not. (phase > low .and. phase < high)) exit
         contact = begin
         call advance_to(contact, phase, is_solved)
         if (.not. is_solved) return
         associate (found => contact%state%load - wanted)
            if (found >= 0) then
               high = phase
               at_high = found
            else
               low = phase
               at_low = found
            end if
            if (abs(found) <= fine*abs(wanted)) high = phase
         end associate
      end do
      rest = setting%legs(last)%span*(1 - high)
   end subroutine press

end module adfric_round_timed_adhesion_trigger
